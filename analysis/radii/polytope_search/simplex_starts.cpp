// Where a program of the simplex method starts: cold, from what the same question left behind, or from a cached basis.
#include "incremental_simplex.hpp"
#include "kernels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace subcert::polytope {

namespace {

constexpr std::size_t cached_starts = 6;      // cached bases that are tried as a start
constexpr double feasible_tolerance = 1e-13;  // a negative part of a combination this small is rounding

}  // namespace

void IncrementalSimplex::start_cold(std::span<const double> x) {
  work_.columns.assign(size_, BasisColumn{});
  const auto largest = std::max_element(x.begin(), x.end()) - x.begin();
  for (std::size_t k = 0; k < size_; ++k) {
    BasisColumn& column = work_.columns[k];
    column.axis = static_cast<int>(k);
    column.slack = kind_ == PolytopeKind::nonnegative && column.axis != largest;
    column.cost = column.slack ? 0 : artificial_cost;
  }
  refactor(work_);
  set_coefficients(x);
}

bool IncrementalSimplex::start_from(const std::vector<BasisColumn>& columns, std::span<const double> x) {
  work_.columns = columns;
  work_.largest = 0;
  changed_ = true;
  if (!refactor(work_)) return false;
  set_coefficients(x);
  return true;
}

// y.x / max |y.v|, a lower bound of the norm of x, or of an image of x, which has the same norm.
double IncrementalSimplex::lower_bound(const Basis& basis, std::span<const double> x, int& element) const {
  element = 0;
  if (basis.largest == 0) return 0;
  const double* y = basis.y.data();
  const std::size_t odd = action_.odd(), even = size_ - odd;
  if (kind_ != PolytopeKind::real || odd == 0) return std::abs(kernels::dot(y, x.data(), size_)) / basis.largest;
  const double p = kernels::dot(y, x.data(), even), q = kernels::dot(y + even, x.data() + even, odd);
  element = p * q < 0 ? 1 : 0;
  return (std::abs(p) + std::abs(q)) / basis.largest;
}

// Starts from the cached bases whose multipliers say most about `x`, from the one of them that values it least.
// Leaves the best multipliers in y_ and returns the lower bound that they give; |y.v| <= 1.
double IncrementalSimplex::choose_start(std::span<const double> x) {
  std::array<std::pair<double, std::size_t>, cached_starts> top;
  std::size_t found = 0;
  int element = 0;
  for (std::size_t b = 0; b < cache_.size(); ++b) {
    const double value = lower_bound(cache_[b], x, element);
    if (found == cached_starts && value <= top[cached_starts - 1].first) continue;
    if (found < cached_starts) ++found;
    std::size_t k = found - 1;
    for (; k > 0 && top[k - 1].first < value; --k) top[k] = top[k - 1];
    top[k] = {value, b};
  }
  changed_ = false;
  double lower = 0, least = std::numeric_limits<double>::infinity();
  std::size_t chosen = cache_.size();
  int chosen_element = 0;
  for (std::size_t t = 0; t < found; ++t) {
    const Basis& basis = cache_[top[t].second];
    lower_bound(basis, x, element);
    if (t == 0) {
      lower = top[0].first;
      for (std::size_t k = 0; k < size_; ++k) y_[k] = basis.y[k] / basis.largest;
      action_.apply(element, y_.data());
    }
    std::copy(x.begin(), x.end(), column_.begin());
    action_.apply(element, column_.data());
    kernels::multiply(basis.inverse.data(), stride_, size_, column_.data(), scratch_.data());
    double sum = 0, smallest = 0;
    for (std::size_t k = 0; k < size_; ++k) {
      sum += basis.columns[k].cost * std::abs(scratch_[k]);
      smallest = std::min(smallest, scratch_[k]);
    }
    if (kind_ == PolytopeKind::nonnegative && smallest < -feasible_tolerance) continue;
    if (sum >= least) continue;
    least = sum;
    chosen = top[t].second;
    chosen_element = element;
    lambda_.swap(scratch_);
  }
  if (chosen == cache_.size()) {
    start_cold(x);
    return lower;
  }
  cache_[chosen].used = ++clock_;
  work_ = cache_[chosen];
  turn_basis(chosen_element);
  return lower;
}

// Replaces the basis of the real kind by its image: the odd coordinates change sign.
void IncrementalSimplex::turn_basis(int element) {
  if (element == 0) return;
  for (std::size_t c = 0; c < size_; ++c) {
    BasisColumn& column = work_.columns[c];
    column.element = column.vertex < 0 ? 0 : action_.composed(element, column.element);
    action_.apply(element, work_.matrix.data() + c * stride_);
  }
  for (std::size_t k = size_ - action_.odd(); k < size_; ++k) {
    for (std::size_t c = 0; c < size_; ++c) work_.inverse[k * stride_ + c] *= -1;
  }
}

// Do the multipliers, held against the vertices added since, still show that the point is outside?
bool IncrementalSimplex::still_outside(WarmStart& warm, double reject) {
  std::copy(warm.multipliers.begin(), warm.multipliers.end(), y_.begin());
  std::fill(y_.begin() + static_cast<std::ptrdiff_t>(size_), y_.end(), 0.0);
  for (; warm.seen < count_; ++warm.seen) {
    warm.largest = std::max(warm.largest, price_one(warm.seen, y_.data()).price);
    if (warm.value <= warm.largest * reject * (1 + price_margin)) return false;
  }
  return true;
}

void IncrementalSimplex::keep_multipliers(double largest) {
  work_.y = y_;
  work_.largest = largest;
}

// The answer is `outside`, shown by y_ with |y.v| <= largest for all vertices.
void IncrementalSimplex::store(WarmStart* warm, const Membership& result, double largest) const {
  if (warm == nullptr) return;
  warm->multipliers.assign(y_.begin(), y_.begin() + static_cast<std::ptrdiff_t>(size_));
  warm->value = result.lower * largest;
  warm->upper = result.upper;
  warm->largest = largest;
  warm->seen = count_;
  warm->basis = work_.columns;
}

void IncrementalSimplex::cache_basis() {
  if (!changed_) return;
  if (work_.largest == 0) {  // answered from above: the multipliers have not met all vertices yet
    double largest = std::numeric_limits<double>::min();
    for (std::size_t j = 0; j < count_; ++j) largest = std::max(largest, price_one(j, y_.data()).price);
    keep_multipliers(largest);
  }
  work_.used = ++clock_;
  if (cache_.size() < cache_size_) {
    cache_.push_back(work_);
    return;
  }
  *std::min_element(cache_.begin(), cache_.end(),
                    [](const Basis& a, const Basis& b) { return a.used < b.used; }) = work_;
}

std::size_t IncrementalSimplex::bytes_of_basis() const {
  return sizeof(Basis) + (2 * size_ + 1) * stride_ * sizeof(double) + size_ * sizeof(BasisColumn);
}

}  // namespace subcert::polytope
