#include "antinorm_program.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace subcert::subradius {
namespace {

using polytope::Matrix;
using polytope::Vector;

constexpr double tiny_price = 1e-12;  // reduced costs below that do not count
constexpr double tiny_pivot = 1e-11;

/// One program: its rows are the positive coordinates of the point, in units of the point, its columns the vertices
/// that have no other positive coordinates.
class Pivoting {
 public:
  Pivoting(const Vector& x, const AntinormProgram& program) : program_(program), units_(x.size(), 0) {
    for (std::size_t i = 0; i < x.size(); ++i)
      if (x[i] > 0) {
        rows_.push_back(i);
        units_[i] = 1 / x[i];
      }
    for (std::size_t j = 0; j < program.count(); ++j)
      if (rows_.size() == x.size() || !sticks_out(program.vertex(j))) columns_.push_back(j);
    const std::size_t n = rows_.size();
    inverse_ = Matrix::identity(n);
    basis_.resize(n);
    std::iota(basis_.begin(), basis_.end(), columns_.size());  // the slacks
    solution_.assign(n, 1);
  }

  Combination run(double enough) {
    if (rows_.empty() || columns_.empty()) return {0, {}, {}};
    pivot(best_single());
    const std::size_t most = 50 + 20 * rows_.size();
    for (std::size_t k = 0; k < most && value() < enough; ++k) {
      const std::size_t entering = priced();
      if (entering == none || !pivot(entering)) break;
    }
    return combination();
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  bool sticks_out(const double* vertex) const {
    for (std::size_t i = 0; i < units_.size(); ++i)
      if (units_[i] == 0 && vertex[i] > 0) return true;
    return false;
  }

  bool is_slack(std::size_t column) const { return column >= columns_.size(); }

  double value() const {
    double sum = 0;
    for (std::size_t i = 0; i < basis_.size(); ++i)
      if (!is_slack(basis_[i])) sum += solution_[i];
    return sum;
  }

  /// The vertex with the largest multiple below the point.
  std::size_t best_single() const {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const double* vertex = program_.vertex(columns_[k]);
      double largest = 0;
      for (std::size_t i = 0; i < units_.size(); ++i) largest = std::max(largest, units_[i] * vertex[i]);
      if (largest < least) {
        least = largest;
        best = k;
      }
    }
    return best;
  }

  /// The column whose weight raises the value fastest, or none.
  std::size_t priced() const {
    const std::size_t n = rows_.size();
    std::size_t entering = none;
    double best = tiny_price;
    Vector prices(units_.size(), 0);  // of the coordinates
    for (std::size_t i = 0; i < n; ++i) {
      double multiplier = 0;
      for (std::size_t k = 0; k < n; ++k)
        if (!is_slack(basis_[k])) multiplier += inverse_(k, i);
      prices[rows_[i]] = multiplier * units_[rows_[i]];
      if (-multiplier <= best) continue;
      best = -multiplier;
      entering = columns_.size() + i;
    }
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const double* vertex = program_.vertex(columns_[k]);
      double value = 1;
      for (std::size_t i = 0; i < prices.size(); ++i) value -= prices[i] * vertex[i];
      if (value <= best) continue;
      best = value;
      entering = k;
    }
    return entering;
  }

  /// False where no pivot is large enough.
  bool pivot(std::size_t entering) {
    const std::size_t n = rows_.size();
    Vector direction(n, 0);
    if (is_slack(entering))
      for (std::size_t k = 0; k < n; ++k) direction[k] = inverse_(k, entering - columns_.size());
    else
      direction = inverse_ * column(entering);
    std::size_t leaving = none;
    double step = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < n; ++k) {
      if (direction[k] <= tiny_pivot) continue;
      const double ratio = std::max(solution_[k], 0.0) / direction[k];
      if (ratio < step || (ratio == step && direction[k] > direction[leaving])) {
        step = ratio;
        leaving = k;
      }
    }
    if (leaving == none) return false;
    for (std::size_t k = 0; k < n; ++k) solution_[k] = k == leaving ? step : solution_[k] - step * direction[k];
    for (std::size_t i = 0; i < n; ++i) {
      const double row = inverse_(leaving, i) / direction[leaving];
      if (row == 0) continue;
      for (std::size_t k = 0; k < n; ++k) inverse_(k, i) = k == leaving ? row : inverse_(k, i) - row * direction[k];
    }
    basis_[leaving] = entering;
    return true;
  }

  Vector column(std::size_t k) const {
    const double* vertex = program_.vertex(columns_[k]);
    Vector result;
    for (const std::size_t i : rows_) result.push_back(units_[i] * vertex[i]);
    return result;
  }

  Combination combination() const {
    Combination result;
    std::vector<bool> free(rows_.size(), false);
    for (std::size_t k = 0; k < basis_.size(); ++k) {
      if (is_slack(basis_[k])) {
        free[basis_[k] - columns_.size()] = true;
        continue;
      }
      const double weight = std::max(solution_[k], 0.0);
      result.terms.push_back({columns_[basis_[k]], weight});
      result.value += weight;
    }
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (!free[i]) result.rows.push_back(rows_[i]);
    return result;
  }

  const AntinormProgram& program_;
  Vector units_;                             // 1 over the coordinates of the point, 0 for zeros
  std::vector<std::size_t> rows_, columns_;  // coordinates, vertices
  Matrix inverse_;                           // of the basis
  std::vector<std::size_t> basis_;           // columns, then slacks
  Vector solution_;
};

}  // namespace

Combination AntinormProgram::below(const Vector& x, double enough) const { return Pivoting(x, *this).run(enough); }

}  // namespace subcert::subradius
