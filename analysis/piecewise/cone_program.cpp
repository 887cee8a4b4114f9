#include "cone_program.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/rational_matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace subcert::piecewise {
namespace {

constexpr double feasible = 1e-9;    // violations below this are rounding
constexpr double pivot_size = 1e-9;  // entries below this are no pivots

const Rational zero = 0;
const Rational& at(const Row& row, std::size_t j) { return j < row.size() ? row[j] : zero; }

std::optional<RationalMatrix> solved(const RationalMatrix& system, const RationalMatrix& wanted) {
  try {
    return solve(system, wanted);
  } catch (const Error&) {
    return std::nullopt;  // singular: the search lost its basis to rounding
  }
}

}  // namespace

void ConeProgram::add(const Row& row) {
  rows_.push_back(&row);
  double largest = 0;
  const std::size_t begin = entries_.size();
  for (std::size_t j = 0; j < dimension_; ++j) {
    entries_.push_back(at(row, j).convert_to<double>());
    largest = std::max(largest, std::abs(entries_.back()));
  }
  if (largest > 0)
    for (std::size_t j = begin; j < entries_.size(); ++j) entries_[j] /= largest;
}

// The corner of the box at which the objective is largest.
void ConeProgram::start(const Row& objective) {
  basis_.resize(dimension_);
  inverse_.assign(dimension_ * dimension_, 0);
  x_.resize(dimension_);
  y_.resize(dimension_);
  for (std::size_t j = 0; j < dimension_; ++j) {
    const double value = at(objective, j).convert_to<double>();
    const int sign = value < 0 ? -1 : 1;
    basis_[j] = {false, j, sign};
    inverse_[j * dimension_ + j] = sign;
    x_[j] = sign * width(j);
    y_[j] = std::abs(value);
  }
}

std::optional<std::pair<ConeProgram::Constraint, double>> ConeProgram::violated() const {
  Constraint worst;
  double largest = feasible;
  for (std::size_t j = 0; j < dimension_; ++j)
    if (const double by = std::abs(x_[j]) / width(j) - 1; by > largest) {
      largest = by;
      worst = {false, j, x_[j] < 0 ? -1 : 1};
    }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const double* row = &entries_[i * dimension_];
    double by = 0;
    for (std::size_t j = 0; j < dimension_; ++j) by -= row[j] * x_[j];
    if (by > largest) {
      largest = by;
      worst = {true, i, 1};
    }
  }
  if (largest == feasible) return std::nullopt;
  return std::pair{worst, largest};
}

// Ties go to the largest pivot, and after many pivots to any of them, so that no cycle lasts.
std::optional<std::size_t> ConeProgram::leaving(const std::vector<double>& entering, std::size_t salt) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < dimension_; ++k)
    if (entering[k] > pivot_size) least = std::min(least, (y_[k] + 1e-12) / entering[k]);
  std::optional<std::size_t> best;
  double rank = 0;
  for (std::size_t k = 0; k < dimension_; ++k)
    if (entering[k] > pivot_size && y_[k] / entering[k] <= least) {
      const double own = salt == 0 ? entering[k] : static_cast<double>((k * 7919 + salt * 104729) % 1009 + 1);
      if (own > rank) {
        rank = own;
        best = k;
      }
    }
  return best;
}

bool ConeProgram::run(double enough) {
  const std::size_t n = dimension_;
  const std::size_t most_pivots = 60 * (n + rows_.size());
  std::vector<double> entering(n);
  for (std::size_t pivot = 0; pivot < most_pivots; ++pivot) {
    double objective = 0;
    for (std::size_t k = 0; k < n; ++k) objective += y_[k] * (basis_[k].is_row ? 0 : width(basis_[k].index));
    if (objective < enough) return true;
    const auto found = violated();
    if (!found) return true;
    const Constraint next = found->first;
    double by = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const double* column = &inverse_[k * n];
      if (next.is_row) {
        entering[k] = 0;
        for (std::size_t j = 0; j < n; ++j) entering[k] -= entries_[next.index * n + j] * column[j];
      } else {
        entering[k] = next.sign * column[next.index];
      }
    }
    if (next.is_row)
      by = found->second;
    else
      by = next.sign * x_[next.index] - width(next.index);
    const auto out = leaving(entering, pivot < most_pivots / 2 ? 0 : pivot);
    if (!out) return false;
    const double step = 1 / entering[*out];
    double* gone = &inverse_[*out * n];
    for (std::size_t j = 0; j < n; ++j) gone[j] *= step;
    const double ratio = y_[*out] * step;
    for (std::size_t k = 0; k < n; ++k) {
      if (k == *out || entering[k] == 0) continue;
      y_[k] = std::max(0.0, y_[k] - ratio * entering[k]);
      for (std::size_t j = 0; j < n; ++j) inverse_[k * n + j] -= entering[k] * gone[j];
    }
    y_[*out] = ratio;
    for (std::size_t j = 0; j < n; ++j) x_[j] -= by * gone[j];
    basis_[*out] = next;
  }
  return false;
}

// In the coordinates that the basis leaves free, the rows of the basis cancel the objective.
std::optional<ConeBound> ConeProgram::exact_bound(const Row& objective) const {
  std::vector<std::size_t> used;
  std::vector<bool> held(dimension_, false);
  for (const Constraint& constraint : basis_)
    if (constraint.is_row)
      used.push_back(constraint.index);
    else
      held[constraint.index] = true;
  std::sort(used.begin(), used.end());
  std::vector<std::size_t> open;
  for (std::size_t j = 0; j < dimension_; ++j)
    if (!held[j]) open.push_back(j);
  if (open.size() != used.size()) return std::nullopt;
  ConeBound result;
  if (!used.empty()) {
    RationalMatrix system(used.size(), used.size()), wanted(used.size(), 1);
    for (std::size_t e = 0; e < open.size(); ++e) {
      for (std::size_t i = 0; i < used.size(); ++i) system(e, i) = at(*rows_[used[i]], open[e]);
      wanted(e, 0) = -at(objective, open[e]);
    }
    const auto solution = solved(system, wanted);
    if (!solution) return std::nullopt;
    for (std::size_t i = 0; i < used.size(); ++i) {
      if ((*solution)(i, 0) < 0) return std::nullopt;
      if ((*solution)(i, 0) != 0) result.multipliers.emplace_back(used[i], (*solution)(i, 0));
    }
  }
  for (std::size_t j = 0; j < dimension_; ++j) {
    Rational sum = at(objective, j);
    for (const auto& [row, factor] : result.multipliers) sum += factor * at(*rows_[row], j);
    if (j >= boxed_ && sum != 0) return std::nullopt;
    result.bound += abs(sum);
  }
  return result;
}

std::optional<ConeBound> ConeProgram::bound(const Row& objective, double enough) {
  start(objective);
  if (!run(enough)) return std::nullopt;
  return exact_bound(objective);
}

std::optional<std::size_t> ConeProgram::unbounded_coordinate() const {
  std::optional<std::size_t> found;
  double most = pivot_size;
  for (std::size_t k = 0; k < dimension_; ++k)
    if (!basis_[k].is_row && basis_[k].index >= boxed_ && y_[k] > most) {
      most = y_[k];
      found = basis_[k].index;
    }
  return found;
}

std::optional<std::vector<Rational>> ConeProgram::maximiser() const {
  RationalMatrix system(dimension_, dimension_), wanted(dimension_, 1);
  for (std::size_t k = 0; k < dimension_; ++k) {
    if (basis_[k].is_row)
      for (std::size_t j = 0; j < dimension_; ++j) system(k, j) = at(*rows_[basis_[k].index], j);
    else
      system(k, basis_[k].index) = 1;
    if (!basis_[k].is_row) wanted(k, 0) = basis_[k].index < boxed_ ? basis_[k].sign : 0;
  }
  const auto solution = solved(system, wanted);
  if (!solution) return std::nullopt;
  std::vector<Rational> x;
  for (std::size_t j = 0; j < dimension_; ++j) x.push_back((*solution)(j, 0));
  for (std::size_t j = 0; j < boxed_; ++j)
    if (abs(x[j]) > 1) return std::nullopt;
  for (const Row* row : rows_)
    if (value_at(*row, x) < 0) return std::nullopt;
  return x;
}

}  // namespace subcert::piecewise
