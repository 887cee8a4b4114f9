// Pricing of the simplex method: which column enters the basis.
#include "incremental_simplex.hpp"
#include "kernels.hpp"

#include <algorithm>
#include <cmath>

namespace subcert::polytope {

namespace {

constexpr double price_tolerance = 1e-10;  // prices above the cost by less are rounding
constexpr double slack_tolerance = 1e-11;  // the same for slacks, whose prices are single multipliers
constexpr std::size_t short_list = 96;     // vertices
constexpr float short_list_depth = 0.5F;   // a short list holds the prices in the upper half

}  // namespace

void IncrementalSimplex::update_multipliers() {
  for (std::size_t k = 0; k < size_; ++k) {
    const double cost = work_.columns[k].cost;
    row_[k] = lambda_[k] < 0 && kind_ != PolytopeKind::nonnegative ? -cost : cost;
  }
  kernels::multiply_transposed(work_.inverse.data(), stride_, size_, row_.data(), y_.data());
  std::fill(y_.begin() + static_cast<std::ptrdiff_t>(size_), y_.end(), 0.0);
}

// Prices a vertex in all its images in double precision; the column returned is the best of them.
IncrementalSimplex::EnteringColumn IncrementalSimplex::price_one(std::size_t vertex, const double* y) const {
  if (kind_ == PolytopeKind::complex) return price_complex(vertex, y);
  const double* v = vertices_.data() + vertex * stride_;
  EnteringColumn result;
  result.column.vertex = static_cast<int>(vertex);
  if (kind_ == PolytopeKind::real) {
    const std::size_t odd = action_.odd(), even = size_ - odd;
    const double p = kernels::dot(v, y, even);
    const double q = odd == 0 ? 0.0 : kernels::dot(v + even, y + even, odd);
    result.price = std::abs(p) + std::abs(q);
    result.column.element = p * q < 0 ? 1 : 0;
    return result;
  }
  double p = 0, q = 0;
  for (std::size_t k = 0; k < size_; ++k) {
    p += v[k] * y[k];
    q += v[k] * y[size_ - 1 - k];
  }
  result.column.element = action_.order() > 1 && q > p ? 1 : 0;
  result.price = result.column.element == 0 ? p : q;
  return result;
}

// <y, e^{it} g v> = cos t <y, g v> + sin t <y, i g v> over the symmetry and conjugation g.
IncrementalSimplex::EnteringColumn IncrementalSimplex::price_complex(std::size_t vertex, const double* y) const {
  const double* v = vertices_.data() + vertex * stride_;
  double part[2][4] = {};  // even and odd coordinates; re.re, im.im, re.im, im.re
  for (std::size_t k = 0; k < half_; ++k) {
    double* sum = part[k >= half_ - action_.odd() ? 1 : 0];
    const double yr = y[k], yi = y[half_ + k], vr = v[k], vi = v[half_ + k];
    sum[0] += yr * vr;
    sum[1] += yi * vi;
    sum[2] += yr * vi;
    sum[3] += yi * vr;
  }
  EnteringColumn result;
  result.column.vertex = static_cast<int>(vertex);
  result.price = -1;
  for (int g = 0; g < 2 * action_.order(); ++g) {
    const double f = g >= 2 ? -1 : 1, c = g % 2 == 1 ? -1 : 1;
    double sum[4];
    for (int k = 0; k < 4; ++k) sum[k] = part[0][k] + f * part[1][k];
    const double re = sum[0] + c * sum[1], im = sum[3] - c * sum[2];
    const double price = std::hypot(re, im);
    if (price <= result.price) continue;
    result.price = price;
    result.column.element = g / 2;
    result.column.conjugated = g % 2 == 1;
    result.column.phase = std::atan2(im, re);
  }
  return result;
}

// Prices every vertex, returns the largest price and leaves the vertices nearest to it in short_list_.
double IncrementalSimplex::price_all() {
  const std::size_t blocks = (count_ + block_size - 1) / block_size;
  prices_.resize(blocks * block_size);
  peaks_.resize(blocks);
  if (kind_ == PolytopeKind::nonnegative) {
    std::fill(peaks_.begin(), peaks_.end(), 0.0F);
    for (std::size_t j = 0; j < count_; ++j) {
      prices_[j] = static_cast<float>(price_one(j, y_.data()).price);
      peaks_[j / block_size] = std::max(peaks_[j / block_size], prices_[j]);
    }
  } else {
    for (std::size_t k = 0; k < size_; ++k) single_[k] = static_cast<float>(y_[k]);
    const std::size_t odd = action_.odd(), even = half_ - odd;
    for (std::size_t b = 0; b < blocks; ++b) {
      const float* block = blocks_.data() + b * block_size * size_;
      float* prices = prices_.data() + b * block_size;
      peaks_[b] = kind_ == PolytopeKind::real
                      ? kernels::price_block(block, even, odd, single_.data(), prices)
                      : kernels::price_complex_block(block, even, odd, action_.order() > 1, single_.data(), prices);
    }
  }
  float largest = 1;
  for (const float peak : peaks_) largest = std::max(largest, peak);
  fill_short_list(largest);
  return static_cast<double>(largest);
}

void IncrementalSimplex::fill_short_list(float largest) {
  short_list_.clear();
  constexpr float margin = static_cast<float>(price_margin);
  const float threshold = short_list_pivots_ == 0 ? largest * (1 - margin)
                                                  : 1 - margin + (1 - short_list_depth) * (largest - 1);
  for (std::size_t b = 0; b < peaks_.size() && short_list_.size() < short_list; ++b) {
    if (peaks_[b] < threshold) continue;
    for (std::size_t j = b * block_size; j < std::min(count_, (b + 1) * block_size); ++j) {
      if (prices_[j] >= threshold) short_list_.push_back(j);
    }
  }
}

// The most profitable slack; false where none lowers the objective.
bool IncrementalSimplex::choose_slack() {
  if (kind_ != PolytopeKind::nonnegative) return false;
  entering_ = {slack_tolerance, {}};
  entering_.column.slack = true;
  entering_.column.cost = 0;
  bool found = false;
  for (std::size_t k = 0; k < size_; ++k) {
    if (-y_[k] <= entering_.price) continue;
    entering_.price = -y_[k];
    entering_.column.axis = static_cast<int>(k);
    found = true;
  }
  return found;
}

// The same among all vertices: what single precision did not see. Cones are priced in double precision anyway.
bool IncrementalSimplex::choose_among_all() {
  if (kind_ == PolytopeKind::nonnegative) return false;
  entering_.price = 1 + price_tolerance;
  bool found = false;
  for (std::size_t j = 0; j < count_; ++j) {
    const EnteringColumn column = price_one(j, y_.data());
    if (column.price <= entering_.price) continue;
    entering_ = column;
    found = true;
  }
  return found;
}

// The most profitable column of the short list; false where none lowers the objective.
bool IncrementalSimplex::choose_vertex() {
  entering_.price = 1 + price_tolerance;
  bool found = false;
  for (const std::size_t j : short_list_) {
    const EnteringColumn column = price_one(j, y_.data());
    if (column.price <= entering_.price) continue;
    entering_ = column;
    found = true;
  }
  return found;
}

}  // namespace subcert::polytope
