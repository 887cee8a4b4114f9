// Bases of the simplex method: their columns, factorisation, refinement, ratio test and exchange of columns.
#include "decompositions.hpp"
#include "incremental_simplex.hpp"
#include "kernels.hpp"

#include <algorithm>
#include <cmath>

namespace subcert::polytope {

namespace {

constexpr double pivot_tolerance = 1e-7;  // relative to the largest entry of the pivot column

}  // namespace

void IncrementalSimplex::fill_column(const BasisColumn& column, double* out) const {
  std::fill(out, out + stride_, 0.0);
  if (column.vertex < 0) {
    if (column.slack) {
      out[column.axis] = -1;
    } else if (kind_ == PolytopeKind::nonnegative) {
      std::fill(out, out + size_, 1.0);
    } else {
      out[column.axis] = 1;
    }
    return;
  }
  const double* v = vertices_.data() + static_cast<std::size_t>(column.vertex) * stride_;
  std::copy(v, v + size_, out);
  for (std::size_t h = 0; h < size_; h += half_) action_.apply(column.element, out + h);
  if (kind_ != PolytopeKind::complex) return;
  if (column.conjugated) {
    for (std::size_t k = half_; k < size_; ++k) out[k] = -out[k];
  }
  const double c = std::cos(column.phase), s = std::sin(column.phase);
  for (std::size_t k = 0; k < half_; ++k) {
    const double re = out[k], im = out[half_ + k];
    out[k] = c * re - s * im;
    out[half_ + k] = s * re + c * im;
  }
}

bool IncrementalSimplex::refactor(Basis& basis) const {
  basis.matrix.assign(stride_ * size_, 0.0);
  basis.inverse.assign(stride_ * size_, 0.0);
  for (std::size_t c = 0; c < size_; ++c) fill_column(basis.columns[c], basis.matrix.data() + c * stride_);
  basis.age = 0;
  return invert(basis.matrix.data(), size_, stride_, basis.inverse.data());
}

void IncrementalSimplex::set_coefficients(std::span<const double> x) {
  kernels::multiply(work_.inverse.data(), stride_, size_, x.data(), lambda_.data());
}

double IncrementalSimplex::objective() const {
  double sum = 0;
  for (std::size_t k = 0; k < size_; ++k) sum += work_.columns[k].cost * std::abs(lambda_[k]);
  return sum;
}

double IncrementalSimplex::artificial_part() const {
  double sum = 0;
  for (std::size_t k = 0; k < size_; ++k) {
    const BasisColumn& column = work_.columns[k];
    if (column.vertex < 0 && !column.slack) sum += std::abs(lambda_[k]);
  }
  return sum;
}

// Refines lambda against the basis matrix; false when the basis had to be given up.
bool IncrementalSimplex::refine(std::span<const double> x) {
  double scale = 0;
  for (const double entry : x) scale = std::max(scale, std::abs(entry));
  for (int attempt = 0; attempt < 3; ++attempt) {
    kernels::multiply(work_.matrix.data(), stride_, size_, lambda_.data(), scratch_.data());
    double worst = 0;
    for (std::size_t k = 0; k < size_; ++k) {
      scratch_[k] = x[k] - scratch_[k];
      worst = std::max(worst, std::abs(scratch_[k]));
    }
    if (!(worst < 1e300)) return false;
    if (worst <= 1e-13 * scale) return true;
    if (attempt == 1) {
      if (!refactor(work_)) return false;
      changed_ = true;
      set_coefficients(x);
      continue;
    }
    kernels::multiply(work_.inverse.data(), stride_, size_, scratch_.data(), column_.data());
    for (std::size_t k = 0; k < size_; ++k) lambda_[k] += column_[k];
    if (attempt == 2) return worst <= 1e-10 * scale;
  }
  return true;
}

// Ratio test for the entering column: fills column_, direction_ and the step; false where no pivot is large enough.
bool IncrementalSimplex::ratio_test(Step& result) {
  fill_column(entering_.column, column_.data());
  kernels::multiply(work_.inverse.data(), stride_, size_, column_.data(), direction_.data());
  const double gain = kernels::dot(y_.data(), column_.data(), size_);
  // Whether an entry is rounding is seen where the columns have equal lengths: extra vertices may be longer by far.
  double largest = 0;
  for (std::size_t k = 0; k < size_; ++k)
    largest = std::max(largest, std::abs(direction_[k]) * length_of(work_.columns[k]));
  const bool symmetric = kind_ != PolytopeKind::nonnegative;
  const double sign = symmetric && gain < 0 ? -1 : 1;
  breaks_.clear();
  for (std::size_t k = 0; k < size_; ++k) {
    const double l = lambda_[k], d = sign * direction_[k];
    const double down = symmetric && l < 0 ? -d : d;
    if (down * length_of(work_.columns[k]) > pivot_tolerance * largest) breaks_.emplace_back(std::abs(l) / down, k);
  }
  if (breaks_.empty()) return false;
  double slope = entering_.column.cost - std::abs(gain);
  const auto later = [](const auto& p, const auto& q) { return p.first > q.first; };
  std::make_heap(breaks_.begin(), breaks_.end(), later);
  for (auto end = breaks_.end();; --end) {
    std::pop_heap(breaks_.begin(), end, later);
    const auto [step, k] = *(end - 1);
    result = {sign * step, k};
    // Long step: past a zero of basic variable k the slope rises by 2 cost_k |d_k|; stop where it turns positive.
    slope += 2 * work_.columns[k].cost * std::abs(direction_[k]);
    if (!symmetric || slope >= 0 || end - 1 == breaks_.begin()) return true;
  }
}

// Exchanges the leaving column of the basis for the entering one.
bool IncrementalSimplex::pivot() {
  Step step{};
  if (!ratio_test(step)) return false;
  const std::size_t r = step.leaving;
  const double divisor = direction_[r];
  for (std::size_t k = 0; k < size_; ++k) lambda_[k] -= step.length * direction_[k];
  lambda_[r] = step.length;
  for (std::size_t c = 0; c < size_; ++c) {
    double& entry = work_.inverse[c * stride_ + r];
    entry /= divisor;
    row_[c] = entry;
  }
  direction_[r] = 0;
  kernels::rank_one(work_.inverse.data(), stride_, size_, direction_.data(), row_.data());
  std::copy(column_.begin(), column_.end(), work_.matrix.begin() + static_cast<std::ptrdiff_t>(r * stride_));
  work_.columns[r] = entering_.column;
  work_.largest = 0;
  ++work_.age;
  ++pivots_;
  changed_ = true;
  return true;
}

}  // namespace subcert::polytope
