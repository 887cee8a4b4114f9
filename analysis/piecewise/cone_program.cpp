#include "cone_program.hpp"

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace subcert::piecewise {
namespace {

constexpr double feasible = 1e-9;    // violations below this are rounding
constexpr double pivot_size = 1e-9;  // entries below this are no pivots

const Rational zero = 0;
const Rational& at(const Row& row, std::size_t j) { return j < row.size() ? row[j] : zero; }

bool allows(Side side, int sign) { return (static_cast<unsigned>(side) & (sign > 0 ? 1U : 2U)) != 0; }

std::optional<RationalMatrix> solved(const RationalMatrix& system, const RationalMatrix& wanted) {
  try {
    return solve(system, wanted);
  } catch (const Error&) {
    return std::nullopt;  // singular, or not square: the search lost its basis to rounding
  }
}

}  // namespace

ConeProgram::ConeProgram(std::size_t dimension, std::size_t boxed, std::vector<Row> rows, Row objective)
    : dimension_(dimension), boxed_(boxed), rows_(std::move(rows)), objective_(std::move(objective)) {
  for (const Row& row : rows_) {
    double largest = 0;
    const std::size_t begin = entries_.size();
    for (std::size_t j = 0; j < dimension_; ++j) {
      entries_.push_back(at(row, j).convert_to<double>());
      largest = std::max(largest, std::abs(entries_.back()));
    }
    if (largest > 0)
      for (std::size_t j = begin; j < entries_.size(); ++j) entries_[j] /= largest;
  }
}

ConeProgram::Corner ConeProgram::corner_of_box() const {
  Corner corner;
  corner.basis.resize(dimension_);
  corner.inverse.assign(dimension_ * dimension_, 0);
  corner.x.resize(dimension_);
  corner.y.resize(dimension_);
  for (std::size_t j = 0; j < dimension_; ++j) {
    const double value = at(objective_, j).convert_to<double>();
    const int sign = value < 0 ? -1 : 1;
    corner.basis[j] = {false, j, sign};
    corner.inverse[j * dimension_ + j] = sign;
    corner.x[j] = sign * width(j);
    corner.y[j] = std::abs(value);
  }
  return corner;
}

double ConeProgram::value(const Corner& corner) const {
  double sum = 0;
  for (std::size_t k = 0; k < dimension_; ++k)
    if (!corner.basis[k].is_row) sum += corner.y[k] * width(corner.basis[k].index);
  return sum;
}

// Whether a coordinate without a bound of its own is held by that of the search.
bool ConeProgram::leans_on_free(const Corner& corner) const {
  for (std::size_t k = 0; k < dimension_; ++k)
    if (!corner.basis[k].is_row && corner.basis[k].index >= boxed_ && corner.y[k] > pivot_size / free_width)
      return true;
  return false;
}

double ConeProgram::product(std::size_t row, const double* x) const {
  const double* entries = &entries_[row * dimension_];
  double sum = 0;
  for (std::size_t j = 0; j < dimension_; ++j) sum += entries[j] * x[j];
  return sum;
}

std::vector<double> ConeProgram::row_values(const Corner& corner) const {
  std::vector<double> values;
  for (std::size_t i = 0; i < rows_.size(); ++i) values.push_back(product(i, corner.x.data()));
  return values;
}

// The constraint that is violated most, and by how much.
std::optional<std::pair<ConeProgram::Constraint, double>> ConeProgram::violated(const Corner& corner,
                                                                                const std::vector<Side>& sides) const {
  Constraint worst;
  double largest = feasible;
  for (std::size_t j = 0; j < dimension_; ++j)
    if (const double by = std::abs(corner.x[j]) / width(j) - 1; by > largest) {
      largest = by;
      worst = {false, j, corner.x[j] < 0 ? -1 : 1};
    }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (sides[i] == Side::any) continue;
    const double value = product(i, corner.x.data());
    const int sign = value < 0 ? 1 : -1;
    if (std::abs(value) > largest && allows(sides[i], sign)) {
      largest = std::abs(value);
      worst = {true, i, sign};
    }
  }
  if (largest == feasible) return std::nullopt;
  return std::pair{worst, worst.is_row ? largest : std::abs(corner.x[worst.index]) - width(worst.index)};
}

// Rows that are zero stay. Ties go to the largest pivot, and after many pivots to any of them, so that no cycle lasts.
std::optional<std::size_t> ConeProgram::leaving(const Corner& corner, const std::vector<double>& entering,
                                                const std::vector<Side>& sides, std::size_t salt) const {
  const auto may_leave = [&](std::size_t k) {
    return entering[k] > pivot_size && !(corner.basis[k].is_row && sides[corner.basis[k].index] == Side::zero);
  };
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < dimension_; ++k)
    if (may_leave(k)) least = std::min(least, (corner.y[k] + 1e-12) / entering[k]);
  std::optional<std::size_t> best;
  double rank = 0;
  for (std::size_t k = 0; k < dimension_; ++k)
    if (may_leave(k) && corner.y[k] / entering[k] <= least) {
      const double own = salt == 0 ? entering[k] : static_cast<double>((k * 7919 + salt * 104729) % 1009 + 1);
      if (own > rank) {
        rank = own;
        best = k;
      }
    }
  return best;
}

std::vector<double> ConeProgram::in_basis(const Corner& corner, const Constraint& constraint) const {
  std::vector<double> result(dimension_);
  for (std::size_t k = 0; k < dimension_; ++k) {
    const double* column = &corner.inverse[k * dimension_];
    result[k] = constraint.sign * (constraint.is_row ? -product(constraint.index, column) : column[constraint.index]);
  }
  return result;
}

void ConeProgram::replace(Corner& corner, std::size_t out, const Constraint& next, double by,
                          const std::vector<double>& entering, const std::vector<Side>& sides) const {
  const std::size_t n = dimension_;
  const double step = 1 / entering[out];
  double* gone = &corner.inverse[out * n];
  for (std::size_t j = 0; j < n; ++j) gone[j] *= step;
  const double ratio = corner.y[out] * step;
  for (std::size_t k = 0; k < n; ++k) {
    if (k == out || entering[k] == 0) continue;
    corner.y[k] -= ratio * entering[k];
    if (corner.y[k] < 0 && !(corner.basis[k].is_row && sides[corner.basis[k].index] == Side::zero)) corner.y[k] = 0;
    double* column = &corner.inverse[k * n];
    for (std::size_t j = 0; j < n; ++j) column[j] -= entering[k] * gone[j];
  }
  corner.y[out] = ratio;
  for (std::size_t j = 0; j < n; ++j) corner.x[j] -= by * gone[j];
  corner.basis[out] = next;
}

bool ConeProgram::improve(Corner& corner, const std::vector<Side>& sides, double enough) const {
  const std::size_t most_pivots = 60 * (dimension_ + rows_.size());
  for (std::size_t pivot = 0; pivot < most_pivots; ++pivot) {
    if (value(corner) < enough && !leans_on_free(corner)) return true;
    const auto found = violated(corner, sides);
    if (!found) return true;
    const std::vector<double> entering = in_basis(corner, found->first);
    const auto out = leaving(corner, entering, sides, pivot < most_pivots / 2 ? 0 : pivot);
    if (!out) return false;
    replace(corner, *out, found->first, found->second, entering, sides);
  }
  return false;
}

// In the coordinates that the basis leaves free, the rows of the basis cancel the objective.
std::optional<ConeBound> ConeProgram::bound(const Corner& corner, const std::vector<Side>& sides) const {
  std::vector<std::size_t> used;
  std::vector<bool> held(dimension_, false);
  for (std::size_t k = 0; k < dimension_; ++k)
    if (corner.basis[k].is_row)
      used.push_back(corner.basis[k].index);
    else
      held[corner.basis[k].index] = true;
  std::sort(used.begin(), used.end());
  std::vector<std::size_t> open;
  for (std::size_t j = 0; j < dimension_; ++j)
    if (!held[j]) open.push_back(j);
  ConeBound result;
  if (!used.empty()) {
    RationalMatrix system(open.size(), used.size()), wanted(open.size(), 1);
    for (std::size_t e = 0; e < open.size(); ++e) {
      for (std::size_t i = 0; i < used.size(); ++i) system(e, i) = at(rows_[used[i]], open[e]);
      wanted(e, 0) = -at(objective_, open[e]);
    }
    const auto solution = solved(system, wanted);
    if (!solution) return std::nullopt;
    for (std::size_t i = 0; i < used.size(); ++i) {
      const Rational& multiplier = (*solution)(i, 0);
      if (multiplier == 0) continue;
      if (!allows(sides[used[i]], multiplier.sign())) return std::nullopt;
      result.multipliers.emplace_back(used[i], multiplier);
    }
  }
  std::vector<Rational> sums(dimension_, 0);
  for (std::size_t j = 0; j < objective_.size(); ++j) sums[j] = objective_[j];
  for (const auto& [row, factor] : result.multipliers)
    for (std::size_t j = 0; j < rows_[row].size(); ++j)
      if (rows_[row][j] != 0) sums[j] += factor * rows_[row][j];
  for (std::size_t j = 0; j < dimension_; ++j) {
    if (j >= boxed_ && sums[j] != 0) return std::nullopt;
    result.bound += abs(sums[j]);
  }
  return result;
}

std::optional<std::vector<Rational>> ConeProgram::point(const Corner& corner, const std::vector<Side>& sides) const {
  RationalMatrix system(dimension_, dimension_), wanted(dimension_, 1);
  for (std::size_t k = 0; k < dimension_; ++k) {
    const Constraint& constraint = corner.basis[k];
    if (constraint.is_row)
      for (std::size_t j = 0; j < dimension_; ++j) system(k, j) = at(rows_[constraint.index], j);
    else
      system(k, constraint.index) = 1;
    if (!constraint.is_row) wanted(k, 0) = constraint.index < boxed_ ? constraint.sign : 0;
  }
  const auto solution = solved(system, wanted);
  if (!solution) return std::nullopt;
  std::vector<Rational> x;
  for (std::size_t j = 0; j < dimension_; ++j) x.push_back((*solution)(j, 0));
  for (std::size_t j = 0; j < boxed_; ++j)
    if (abs(x[j]) > 1) return std::nullopt;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (const int sign = value_at(rows_[i], x).sign(); sign != 0 && allows(sides[i], -sign)) return std::nullopt;
  return x;
}

}  // namespace subcert::piecewise
