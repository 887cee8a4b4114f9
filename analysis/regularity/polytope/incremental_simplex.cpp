#include "incremental_simplex.hpp"

#include "kernels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace subcert {

namespace {

constexpr double kArtificialCost = 1e6;   // cost of the unit vectors that complete a basis
constexpr double kPivotTolerance = 1e-7;  // relative to the largest entry of the pivot column
constexpr double kPriceTolerance = 1e-10;
constexpr double kSlack = 1e-6;  // of prices in single precision
constexpr int kMaxAge = 100;     // pivots between factorisations
constexpr std::size_t kCacheSize = 512;
constexpr std::size_t kStarts = 6;  // remembered bases that are tried as a start
constexpr std::size_t kTrials = 1;  // columns tried per pivot
constexpr std::size_t kListSize = 96;
constexpr float kListDepth = 0.5F;  // a short list holds the profits in the upper half
constexpr int kLongList = 60;       // vertices per coordinate beyond which short lists pay

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

IncrementalSimplex::IncrementalSimplex(PolytopeKind kind, int dimension, bool flip, int odd)
    : kind_(kind),
      half_(dimension),
      size_(kind == PolytopeKind::complex ? 2 * dimension : dimension),
      stride_((size_ + 3) / 4 * 4),
      flip_(flip),
      odd_(flip ? odd : 0) {
  if (dimension < 1) {
    throw std::invalid_argument("IncrementalSimplex: need dimension >= 1, got " + std::to_string(dimension));
  }
  if (odd < 0 || odd > dimension) {
    throw std::invalid_argument("IncrementalSimplex: need 0 <= odd <= dimension, got " + std::to_string(odd));
  }
  const std::size_t n = at(stride_);
  for (auto* v : {&lambda_, &y_, &direction_, &column_, &row_, &scratch_}) v->assign(n, 0.0);
  single_.assign(n, 0.0F);
}

int IncrementalSimplex::add(const Eigen::VectorXd& vertex) {
  if (vertex.size() != size_) {
    throw std::invalid_argument("IncrementalSimplex::add: need " + std::to_string(size_) + " numbers, got " +
                                std::to_string(vertex.size()));
  }
  const std::size_t begin = vertices_.size();
  vertices_.resize(begin + at(stride_), 0.0);
  std::copy(vertex.data(), vertex.data() + size_, vertices_.begin() + static_cast<std::ptrdiff_t>(begin));
  if (kind_ != PolytopeKind::nonnegative) {
    if (count_ % kLane == 0) lanes_.resize(lanes_.size() + at(kLane) * at(size_), 0.0F);
    float* block = lanes_.data() + at(count_ / kLane) * at(kLane) * at(size_);
    for (int k = 0; k < size_; ++k) block[k * kLane + count_ % kLane] = static_cast<float>(vertex[k]);
  }
  for (Basis& basis : cache_) {
    if (basis.largest > 0) basis.largest = std::max(basis.largest, price_one(count_, basis.y.data()).profit);
  }
  return count_++;
}

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
  const double* v = vertices_.data() + at(column.vertex) * at(stride_);
  if (kind_ == PolytopeKind::nonnegative) {
    for (int k = 0; k < size_; ++k) out[k] = v[column.flipped ? size_ - 1 - k : k];
    return;
  }
  std::copy(v, v + size_, out);
  if (column.flipped) {
    for (int h = half_; h <= size_; h += half_) {
      for (int k = h - odd_; k < h; ++k) out[k] = -out[k];
    }
  }
  if (kind_ != PolytopeKind::complex) return;
  if (column.conjugated) {
    for (int k = half_; k < size_; ++k) out[k] = -out[k];
  }
  const double c = std::cos(column.phase), s = std::sin(column.phase);
  for (int k = 0; k < half_; ++k) {
    const double re = out[k], im = out[half_ + k];
    out[k] = c * re - s * im;
    out[half_ + k] = s * re + c * im;
  }
}

void IncrementalSimplex::cold_basis(const Eigen::VectorXd& x, Basis& basis) const {
  basis.columns.assign(at(size_), BasisColumn{});
  int largest = 0;
  x.maxCoeff(&largest);
  for (int k = 0; k < size_; ++k) {
    BasisColumn& column = basis.columns[at(k)];
    column.axis = k;
    column.slack = kind_ == PolytopeKind::nonnegative && k != largest;
    column.cost = column.slack ? 0 : kArtificialCost;
  }
  refactor(basis);
}

bool IncrementalSimplex::refactor(Basis& basis) const {
  const std::size_t n = at(stride_);
  basis.matrix.assign(n * at(size_), 0.0);
  for (int c = 0; c < size_; ++c) fill_column(basis.columns[at(c)], basis.matrix.data() + at(c) * n);
  Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> matrix(basis.matrix.data(), size_, size_,
                                                                    Eigen::OuterStride<>(stride_));
  const Eigen::MatrixXd inverse = Eigen::PartialPivLU<Eigen::MatrixXd>(matrix).inverse();
  basis.inverse.assign(n * at(size_), 0.0);
  Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>(basis.inverse.data(), size_, size_,
                                                       Eigen::OuterStride<>(stride_)) = inverse;
  basis.age = 0;
  return inverse.allFinite() && inverse.cwiseAbs().maxCoeff() < 1e13;
}

double IncrementalSimplex::evaluate() {
  double sum = 0;
  for (int k = 0; k < size_; ++k) sum += work_.columns[at(k)].cost * std::abs(lambda_[at(k)]);
  return sum;
}

double IncrementalSimplex::artificial_part() const {
  double sum = 0;
  for (int k = 0; k < size_; ++k) {
    const BasisColumn& column = work_.columns[at(k)];
    if (column.vertex < 0 && !column.slack) sum += std::abs(lambda_[at(k)]);
  }
  return sum;
}

// y.x / max |y.v|, a lower bound of the norm of x, or of its mirror image, which has the same norm.
double IncrementalSimplex::score(const Basis& basis, const Eigen::VectorXd& x, bool& flipped) const {
  if (basis.largest == 0) return 0;
  const double* y = basis.y.data();
  flipped = false;
  if (kind_ != PolytopeKind::real || odd_ == 0) return std::abs(kernels::dot(y, x.data(), at(size_))) / basis.largest;
  const std::size_t even = at(size_ - odd_);
  const double p = kernels::dot(y, x.data(), even), q = kernels::dot(y + even, x.data() + even, at(odd_));
  flipped = p * q < 0;
  return (std::abs(p) + std::abs(q)) / basis.largest;
}

// Starts from the remembered bases whose multipliers say most about `x`, from the one of them that values it least.
// Leaves the best multipliers in y_ and returns the lower bound that they give; |y.v| <= 1.
double IncrementalSimplex::choose_start(const Eigen::VectorXd& x) {
  std::array<std::pair<double, std::size_t>, kStarts> top;
  std::size_t found = 0;
  bool flipped = false;
  for (std::size_t b = 0; b < cache_.size(); ++b) {
    const double value = score(cache_[b], x, flipped);
    if (found == kStarts && value <= top[kStarts - 1].first) continue;
    if (found < kStarts) ++found;
    std::size_t k = found - 1;
    for (; k > 0 && top[k - 1].first < value; --k) top[k] = top[k - 1];
    top[k] = {value, b};
  }
  if (found > 0) {
    const Basis& basis = cache_[top[0].second];
    score(basis, x, flipped);
    for (int k = 0; k < size_; ++k) {
      y_[at(k)] = basis.y[at(k)] / (flipped && k >= size_ - odd_ ? -basis.largest : basis.largest);
    }
  }
  const double lower = found > 0 ? top[0].first : 0;
  double best = std::numeric_limits<double>::infinity();
  std::size_t chosen = cache_.size();
  bool chosen_flipped = false;
  for (std::size_t t = 0; t < found; ++t) {
    const Basis& basis = cache_[top[t].second];
    score(basis, x, flipped);
    turned_ = x;
    if (flipped) turned_.tail(odd_) *= -1;
    kernels::multiply(basis.inverse.data(), at(stride_), at(size_), turned_.data(), scratch_.data());
    double sum = 0, least = 0;
    for (int k = 0; k < size_; ++k) {
      const double l = scratch_[at(k)];
      sum += basis.columns[at(k)].cost * std::abs(l);
      least = std::min(least, l);
    }
    if (kind_ == PolytopeKind::nonnegative && least < -1e-13) continue;
    if (sum < best) {
      best = sum;
      chosen = top[t].second;
      chosen_flipped = flipped;
      lambda_.swap(scratch_);
    }
  }
  changed_ = false;
  if (chosen == cache_.size()) {
    cold_basis(x, work_);
    kernels::multiply(work_.inverse.data(), at(stride_), at(size_), x.data(), lambda_.data());
    return lower;
  }
  cache_[chosen].used = ++clock_;
  work_ = cache_[chosen];
  if (!chosen_flipped) return lower;
  // The mirror image of the whole basis: the odd coordinates change sign.
  for (BasisColumn& column : work_.columns) column.flipped = !column.flipped && column.vertex >= 0;
  for (int c = 0; c < size_; ++c) {
    for (int k = size_ - odd_; k < size_; ++k) {
      work_.matrix[at(c) * at(stride_) + at(k)] *= -1;
      work_.inverse[at(k) * at(stride_) + at(c)] *= -1;
    }
  }
  return lower;
}

bool IncrementalSimplex::start_from(const std::vector<BasisColumn>& columns, const Eigen::VectorXd& x) {
  work_.columns = columns;
  work_.largest = 0;
  changed_ = true;
  if (!refactor(work_)) return false;
  kernels::multiply(work_.inverse.data(), at(stride_), at(size_), x.data(), lambda_.data());
  return true;
}

// Do the multipliers of the hint, held against the vertices added since, still show that the point is outside?
bool IncrementalSimplex::still_outside(Hint& hint, double reject) {
  std::copy(hint.multipliers.data(), hint.multipliers.data() + size_, y_.begin());
  std::fill(y_.begin() + size_, y_.end(), 0.0);
  for (; hint.seen < count_; ++hint.seen) {
    hint.largest = std::max(hint.largest, price_one(hint.seen, y_.data()).profit);
    if (hint.value <= hint.largest * reject * (1 + kSlack)) return false;
  }
  return true;
}

void IncrementalSimplex::know(double largest) {
  work_.y = y_;
  work_.largest = largest;
}

// The answer is `outside`, shown by y_ with |y.v| <= largest for all vertices.
void IncrementalSimplex::keep(Hint* hint, const Membership& result, double largest) const {
  if (hint == nullptr) return;
  hint->multipliers = Eigen::Map<const Eigen::VectorXd>(y_.data(), size_);
  hint->value = result.lower * largest;
  hint->upper = result.upper;
  hint->largest = largest;
  hint->seen = count_;
  hint->basis = work_.columns;
}

void IncrementalSimplex::remember() {
  if (!changed_) return;
  if (work_.largest == 0) {  // answered from above: the multipliers have not met all vertices yet
    double largest = std::numeric_limits<double>::min();
    for (int j = 0; j < count_; ++j) largest = std::max(largest, price_one(j, y_.data()).profit);
    know(largest);
  }
  work_.used = ++clock_;
  if (cache_.size() < kCacheSize) {
    cache_.push_back(work_);
    return;
  }
  auto oldest = std::min_element(cache_.begin(), cache_.end(),
                                 [](const Basis& a, const Basis& b) { return a.used < b.used; });
  *oldest = work_;
}

void IncrementalSimplex::multipliers() {
  for (int k = 0; k < size_; ++k) {
    const double cost = work_.columns[at(k)].cost;
    row_[at(k)] = lambda_[at(k)] < 0 && kind_ != PolytopeKind::nonnegative ? -cost : cost;
  }
  kernels::multiply_transposed(work_.inverse.data(), at(stride_), at(size_), row_.data(), y_.data());
  std::fill(y_.begin() + size_, y_.end(), 0.0);
}

// Prices a vertex in all its guises in double precision; the column returned is the best of them.
IncrementalSimplex::Offer IncrementalSimplex::price_one(int vertex, const double* y) const {
  const double* v = vertices_.data() + at(vertex) * at(stride_);
  Offer offer;
  offer.column.vertex = vertex;
  if (kind_ == PolytopeKind::real) {
    const std::size_t even = at(size_ - odd_);
    const double p = kernels::dot(v, y, even);
    const double q = odd_ == 0 ? 0.0 : kernels::dot(v + even, y + even, at(odd_));
    offer.profit = std::abs(p) + std::abs(q);
    offer.column.flipped = p * q < 0;
    return offer;
  }
  if (kind_ == PolytopeKind::nonnegative) {
    double p = 0, q = 0;
    for (int k = 0; k < size_; ++k) {
      p += v[k] * y[k];
      q += v[k] * y[size_ - 1 - k];
    }
    offer.column.flipped = flip_ && q > p;
    offer.profit = offer.column.flipped ? q : p;
    return offer;
  }
  // <y, e^{it} g v> = cos t <y, g v> + sin t <y, i g v> over the flips and conjugates g.
  double part[2][4] = {};  // even and odd coordinates; re.re, im.im, re.im, im.re
  for (int k = 0; k < half_; ++k) {
    double* sum = part[k >= half_ - odd_ ? 1 : 0];
    const double yr = y[k], yi = y[half_ + k], vr = v[k], vi = v[half_ + k];
    sum[0] += yr * vr;
    sum[1] += yi * vi;
    sum[2] += yr * vi;
    sum[3] += yi * vr;
  }
  offer.profit = -1;
  for (int g = 0; g < (flip_ ? 4 : 2); ++g) {
    const double f = g >= 2 ? -1 : 1, c = g % 2 == 1 ? -1 : 1;
    double sum[4];
    for (int k = 0; k < 4; ++k) sum[k] = part[0][k] + f * part[1][k];
    const double re = sum[0] + c * sum[1], im = sum[3] - c * sum[2];
    const double value = std::hypot(re, im);
    if (value > offer.profit) {
      offer.profit = value;
      offer.column.flipped = g >= 2;
      offer.column.conjugated = g % 2 == 1;
      offer.column.phase = std::atan2(im, re);
    }
  }
  return offer;
}

// Prices every vertex, returns the largest profit and leaves the vertices nearest to it in list_.
double IncrementalSimplex::price_all() {
  const int blocks = (count_ + kLane - 1) / kLane;
  prices_.resize(at(blocks) * kLane);
  peaks_.resize(at(blocks));
  float largest = 1;
  if (kind_ != PolytopeKind::nonnegative) {
    for (int k = 0; k < size_; ++k) single_[at(k)] = static_cast<float>(y_[at(k)]);
    const std::size_t even = at(half_ - odd_);
    for (int b = 0; b < blocks; ++b) {
      const float* block = lanes_.data() + at(b) * at(kLane) * at(size_);
      float* prices = prices_.data() + at(b) * kLane;
      peaks_[at(b)] = kind_ == PolytopeKind::real
                          ? kernels::price_block(block, even, at(odd_), single_.data(), prices)
                          : kernels::price_complex_block(block, even, at(odd_), flip_, single_.data(), prices);
      largest = std::max(largest, peaks_[at(b)]);
    }
  } else {
    std::fill(peaks_.begin(), peaks_.end(), 0.0F);
    for (int j = 0; j < count_; ++j) {
      prices_[at(j)] = static_cast<float>(price_one(j, y_.data()).profit);
      peaks_[at(j / kLane)] = std::max(peaks_[at(j / kLane)], prices_[at(j)]);
    }
    for (float peak : peaks_) largest = std::max(largest, peak);
  }
  list_.clear();
  const float share = 1 - kListDepth;
  const float threshold = patience_ == 0 && kTrials == 1 ? largest * (1 - 1e-6F) : 1 - 1e-6F + share * (largest - 1);
  for (int b = 0; b < blocks && list_.size() < kListSize; ++b) {
    if (peaks_[at(b)] < threshold) continue;
    for (int j = b * kLane; j < std::min(count_, (b + 1) * kLane); ++j) {
      if (prices_[at(j)] >= threshold) list_.push_back(j);
    }
  }
  return static_cast<double>(largest);
}

// The most profitable columns of the short list, best first.
bool IncrementalSimplex::collect_offers() {
  offers_.clear();
  for (int j : list_) {
    const Offer offer = price_one(j, y_.data());
    if (offer.profit <= 1 + kPriceTolerance) continue;
    if (offers_.size() == kTrials && offer.profit <= offers_.back().profit) continue;
    if (offers_.size() < kTrials) offers_.push_back(offer);
    std::size_t k = offers_.size() - 1;
    for (; k > 0 && offers_[k - 1].profit < offer.profit; --k) offers_[k] = offers_[k - 1];
    offers_[k] = offer;
  }
  return !offers_.empty();
}

// Refines lambda against the basis matrix; false when the basis had to be given up.
bool IncrementalSimplex::refine(const Eigen::VectorXd& x) {
  const std::size_t n = at(stride_);
  const double scale = x.cwiseAbs().maxCoeff();
  for (int attempt = 0; attempt < 3; ++attempt) {
    kernels::multiply(work_.matrix.data(), n, at(size_), lambda_.data(), scratch_.data());
    double worst = 0;
    for (int k = 0; k < size_; ++k) {
      scratch_[at(k)] = x[k] - scratch_[at(k)];
      worst = std::max(worst, std::abs(scratch_[at(k)]));
    }
    if (!(worst < 1e300)) return false;
    if (worst <= 1e-13 * scale) return true;
    if (attempt == 1) {
      if (!refactor(work_)) return false;
      changed_ = true;
      kernels::multiply(work_.inverse.data(), n, at(size_), x.data(), lambda_.data());
      continue;
    }
    kernels::multiply(work_.inverse.data(), n, at(size_), scratch_.data(), column_.data());
    for (int k = 0; k < size_; ++k) lambda_[at(k)] += column_[at(k)];
    if (attempt == 2) return worst <= 1e-10 * scale;
  }
  return true;
}

// Ratio test for one column: fills column_, direction_ and the step; returns the decrease of the objective, or -1.
double IncrementalSimplex::ratio_test(const Offer& offer, Step& result) {
  const std::size_t n = at(stride_);
  fill_column(offer.column, column_.data());
  kernels::multiply(work_.inverse.data(), n, at(size_), column_.data(), direction_.data());
  const double gain = kernels::dot(y_.data(), column_.data(), at(size_));
  double largest = 0;
  for (int k = 0; k < size_; ++k) largest = std::max(largest, std::abs(direction_[at(k)]));
  const bool symmetric = kind_ != PolytopeKind::nonnegative;
  const double sign = symmetric && gain < 0 ? -1 : 1;
  breaks_.clear();
  for (int k = 0; k < size_; ++k) {
    const double l = lambda_[at(k)], d = sign * direction_[at(k)];
    const double down = symmetric && l < 0 ? -d : d;
    if (down > kPivotTolerance * largest) breaks_.emplace_back(std::abs(l) / down, k);
  }
  if (breaks_.empty()) return -1;
  double slope = offer.column.cost - std::abs(gain), decrease = 0, reached = 0;
  auto later = [](const auto& p, const auto& q) { return p.first > q.first; };
  std::make_heap(breaks_.begin(), breaks_.end(), later);
  for (std::size_t end = breaks_.size();; --end) {
    std::pop_heap(breaks_.begin(), breaks_.begin() + static_cast<std::ptrdiff_t>(end), later);
    const auto [step, k] = breaks_[end - 1];
    decrease -= slope * (step - reached);
    reached = step;
    result = {sign * step, k};
    // Long step: past a zero of basic variable k the slope rises by 2 cost_k |d_k|; stop where it turns positive.
    slope += 2 * work_.columns[at(k)].cost * std::abs(direction_[at(k)]);
    if (!symmetric || slope >= 0 || end == 1) return decrease;
  }
}

// Exchanges one column of the basis for the one of the offers that lowers the objective most.
bool IncrementalSimplex::pivot(const std::vector<Offer>& offers) {
  const std::size_t n = at(stride_);
  double most = -1;
  const Offer* chosen = nullptr;
  Step step{};
  for (const Offer& offer : offers) {
    Step trial{};
    const double decrease = ratio_test(offer, trial);
    if (decrease <= most) continue;
    most = decrease;
    chosen = &offer;
    step = trial;
    if (offers.size() > 1) {
      best_column_ = column_;
      best_direction_ = direction_;
    }
  }
  if (chosen == nullptr) return false;
  if (offers.size() > 1) {
    column_.swap(best_column_);
    direction_.swap(best_direction_);
  }
  const std::size_t r = at(step.leaving);
  const double divisor = direction_[r];
  for (int k = 0; k < size_; ++k) lambda_[at(k)] -= step.length * direction_[at(k)];
  lambda_[r] = step.length;
  for (int c = 0; c < size_; ++c) {
    double& entry = work_.inverse[at(c) * n + r];
    entry /= divisor;
    row_[at(c)] = entry;
  }
  direction_[r] = 0;
  kernels::rank_one(work_.inverse.data(), n, at(size_), direction_.data(), row_.data());
  std::copy(column_.begin(), column_.end(), work_.matrix.begin() + static_cast<std::ptrdiff_t>(r * n));
  work_.columns[r] = chosen->column;
  work_.largest = 0;
  ++work_.age;
  ++pivots_;
  changed_ = true;
  return true;
}

Membership IncrementalSimplex::solve(const Eigen::VectorXd& x, double accept, double reject, Hint* hint) {
  if (x.size() != size_) {
    throw std::invalid_argument("IncrementalSimplex::solve: need " + std::to_string(size_) + " numbers, got " +
                                std::to_string(x.size()));
  }
  ++programs_;
  Membership result;
  bool warm = false;
  if (hint != nullptr && hint->multipliers.size() > 0) {
    if (still_outside(*hint, reject)) {
      result.answer = Membership::Answer::outside;
      result.lower = hint->value / hint->largest;
      result.upper = hint->upper;
      return result;
    }
    warm = start_from(hint->basis, x);
  }
  if (!warm) {
    result.lower = choose_start(x);
    if (result.lower > reject * (1 + kSlack)) {
      result.answer = Membership::Answer::outside;
      result.upper = evaluate();
      keep(hint, result, 1);
      return result;
    }
    result.lower = 0;
  }
  list_.clear();
  const int limit = 200 + 20 * size_;
  // A short list serves as many pivots as make it as expensive as pricing everything once.
  patience_ = kind_ == PolytopeKind::nonnegative ? count_ / 500 : count_ / (kLongList * size_);
  int stale = 0;
  bool cold = false;
  for (int iteration = 0; iteration < limit; ++iteration) {
    result.upper = evaluate();
    if (result.upper <= accept && artificial_part() < 1e-13) {
      if (refine(x) && evaluate() <= accept) {
        result.upper = evaluate();
        result.answer = Membership::Answer::inside;
        break;
      }
      result.upper = evaluate();
    }
    if (work_.age > kMaxAge) {
      const bool sound = refactor(work_);
      kernels::multiply(work_.inverse.data(), at(stride_), at(size_), x.data(), lambda_.data());
      if (!sound) {
        if (cold) break;
        cold = true;
        ++cold_starts_;
        cold_basis(x, work_);
        kernels::multiply(work_.inverse.data(), at(stride_), at(size_), x.data(), lambda_.data());
        list_.clear();
        continue;
      }
    }
    multipliers();
    offers_.clear();
    bool found = false;
    if (kind_ == PolytopeKind::nonnegative) {
      Offer best;
      best.profit = 1e-11;
      best.column.slack = true;
      best.column.cost = 0;
      for (int k = 0; k < size_; ++k) {
        if (-y_[at(k)] <= best.profit) continue;
        best.profit = -y_[at(k)];
        best.column.axis = k;
        found = true;
      }
      if (found) offers_.push_back(best);
    }
    if (!found && stale < patience_) {
      ++stale;
      found = collect_offers();
    }
    if (!found) {
      stale = 0;
      const double largest = price_all();
      result.lower = std::max(result.lower, result.upper / largest);
      if (result.lower > reject * (1 + kSlack)) {
        result.answer = Membership::Answer::outside;
        know(largest);
        keep(hint, result, largest);
        break;
      }
      found = collect_offers();
    }
    if (found && pivot(offers_)) continue;
    // Optimal up to the pricing tolerance, or no acceptable pivot: then only the upper bound counts.
    const bool sound = refine(x);
    result.upper = evaluate();
    if (!found) result.lower = std::max(result.lower, result.upper * (1 - kSlack));
    if (sound && result.upper <= accept && artificial_part() < 1e-13) {
      result.answer = Membership::Answer::inside;
    } else if (sound && !found) {
      result.answer = Membership::Answer::outside;
      know(1 + kSlack);
      keep(hint, result, 1 + kSlack);
    }
    break;
  }
  remember();
  return result;
}

std::vector<Term> IncrementalSimplex::combination() const {
  std::vector<Term> terms;
  for (int k = 0; k < size_; ++k) {
    const BasisColumn& column = work_.columns[at(k)];
    const double l = lambda_[at(k)];
    if (column.vertex < 0 || l == 0) continue;
    Term term{column.vertex, column.flipped, column.conjugated, std::polar(std::abs(l), column.phase)};
    if (l < 0) term.coefficient = -term.coefficient;
    if (kind_ != PolytopeKind::complex) term.coefficient = l;
    auto same = std::find_if(terms.begin(), terms.end(), [&term](const Term& t) {
      return t.vertex == term.vertex && t.flipped == term.flipped && t.conjugated == term.conjugated;
    });
    if (same == terms.end()) {
      terms.push_back(term);
    } else {
      same->coefficient += term.coefficient;
    }
  }
  return terms;
}

}  // namespace subcert
