#include "fit.hpp"

#include <algorithm>
#include <optional>

namespace subcert_check {
namespace {

constexpr std::size_t max_letters = 16;
constexpr Point corners[]{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

/// The data at 0, (1,0), (0,1) from which an affine function has its value at a point.
std::array<mpz_class, 3> affine_at(const Point& l) { return {mpz_class(1 - l[0] - l[1]), l[0], l[1]}; }

/// The products B_w of the operators B_d, v(x) = B_d v(y) for x = (d + y)/m, on the window; in the rows of 0, (1,0) and
/// (0,1) nothing is asked.
class Words {
 public:
  Words(const LatticeMask& mask, const mpq_class& rate, FitBounds& bounds, Arithmetic& arithmetic)
      : mask_(mask), rate_(rate), bounds_(bounds), arithmetic_(arithmetic) {
    const auto& window = bounds.window;
    const std::int64_t m = mask.arity;
    for (std::int64_t x = 0; x < m; ++x)
      for (std::int64_t y = 0; y < m; ++y) {
        letters_.emplace_back();
        for (const Point& l : window) {
          letters_.back().emplace_back();
          for (std::size_t p = 0; p < window.size(); ++p) {
            const Point k{x + window[p][0] - m * l[0], y + window[p][1] - m * l[1], 0};
            if (mpz_class value = mask.at(k); value != 0) letters_.back().back().emplace_back(p, value);
          }
        }
      }
  }

  void bound() {
    std::vector<Vector> rows(bounds_.free.size(), Vector(bounds_.window.size()));
    for (std::size_t i = 0; i < bounds_.free.size(); ++i) rows[i][bounds_.free[i]] = 1;
    visit(rows, 1, 1, 0);
  }

 private:
  /// N of B_w times the window's coefficients of u_l, or of the affine function with these coefficients at the corners.
  mpz_class norm(const std::vector<Vector>& rows, const std::array<mpz_class, 3>& affine, const std::size_t* l) const {
    mpz_class sum = 0;
    for (std::size_t i = 0; i < bounds_.free.size(); ++i) {
      mpz_class value = 0;
      for (std::size_t v = 0; v < 3; ++v) arithmetic_.add_product(value, rows[i][bounds_.corners[v]], affine[v]);
      if (l != nullptr) value = rows[i][*l] - value;
      sum += bounds_.weights[bounds_.free[i]] * abs(value);
    }
    return sum;
  }

  /// g_w, or nothing where it is above the rate. Numbers of the rows are those of B_w times the scale.
  std::optional<mpq_class> contraction(const std::vector<Vector>& rows, const mpz_class& grown,
                                       const mpz_class& scale) {
    mpq_class largest = 0;
    for (std::size_t i = 0; i < bounds_.free.size(); ++i) {
      std::size_t l = bounds_.free[(first_ + i) % bounds_.free.size()];
      const mpz_class value = norm(rows, affine_at(bounds_.window[l]), &l);
      largest = std::max(largest, ratio(grown * value, scale * bounds_.weights[l]));
      if (largest <= rate_) continue;
      first_ = (first_ + i) % bounds_.free.size();  // likely the next one to fail
      return std::nullopt;
    }
    return largest;
  }

  void visit(const std::vector<Vector>& rows, const mpz_class& grown, const mpz_class& scale, std::size_t letters) {
    if (const auto g = contraction(rows, grown, scale)) return use(rows, grown, scale, *g);
    require(letters < max_letters, "words do not contract by the rate");
    for (const auto& letter : letters_) {
      std::vector<Vector> next(rows.size(), Vector(bounds_.window.size()));
      for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t k = 0; k < letter.size(); ++k) {
          if (rows[i][k] == 0) continue;
          for (const auto& [p, value] : letter[k]) arithmetic_.add_product(next[i][p], rows[i][k], value);
        }
      visit(next, grown * mask_.arity, scale * mask_.denominator, letters + 1);
    }
  }

  void use(const std::vector<Vector>& rows, const mpz_class& grown, const mpz_class& scale, const mpq_class& g) {
    for (const std::size_t axis : {0U, 1U}) {
      const mpz_class value = norm(rows, {-1, axis == 0 ? 1 : 0, axis == 0 ? 0 : 1}, nullptr);
      bounds_.slopes[axis] = std::max(bounds_.slopes[axis], mpq_class(ratio(grown * value, scale) / (1 - g)));
    }
    const mpz_class parts = bounds_.shift[0].get_den() * bounds_.shift[1].get_den();
    for (const int x : {0, 1})
      for (const int y : {0, 1}) {
        const mpq_class s = parts * (x + bounds_.shift[0]), t = parts * (y + bounds_.shift[1]);
        const mpz_class value = norm(rows, {parts - s.get_num() - t.get_num(), s.get_num(), t.get_num()}, nullptr);
        bounds_.value = std::max(bounds_.value, mpq_class(ratio(value, scale * parts) / (1 - g / grown)));
      }
  }

  const LatticeMask& mask_;
  const mpq_class& rate_;
  FitBounds& bounds_;
  Arithmetic& arithmetic_;
  std::vector<std::vector<std::vector<std::pair<std::size_t, mpz_class>>>> letters_;  // by digit, row: columns
  std::size_t first_ = 0;
};

/// -mu/(m-1), mu the sum of k a_k over each class, which are the same.
void find_shift(const LatticeMask& mask, FitBounds& bounds) {
  const std::int64_t m = mask.arity;
  std::map<Point, std::array<mpz_class, 3>> sums;
  for (const auto& [k, value] : mask.coefficients) {
    auto& sum = sums[{(k[0] % m + m) % m, (k[1] % m + m) % m, 0}];
    sum[0] += value;
    for (std::size_t v = 0; v < 2; ++v) sum[v + 1] += value * k[v];
  }
  const auto& first = sums.begin()->second;
  require(first[0] == mask.denominator && sums.size() == static_cast<std::size_t>(m * m) &&
              std::ranges::all_of(sums, [&](const auto& sum) { return sum.second == first; }),
          "the mask does not keep affine functions");
  for (std::size_t v = 0; v < 2; ++v) bounds.shift[v] = ratio(-first[v + 1], (m - 1) * mask.denominator);
}

}  // namespace

FitBounds fit_bounds(const LatticeMask& mask, const mpq_class& rate, Arithmetic& arithmetic) {
  require(0 < rate && rate < 1, "the rate of the fits is not between 0 and 1");
  FitBounds bounds;
  find_shift(mask, bounds);
  std::set<Point> window = mask.window();
  window.insert(std::begin(corners), std::end(corners));
  arithmetic.spend(100 * window.size() * window.size() * window.size());
  bounds.window.assign(window.begin(), window.end());
  for (std::size_t v = 0; v < 3; ++v)
    bounds.corners[v] = static_cast<std::size_t>(std::ranges::find(bounds.window, corners[v]) - bounds.window.begin());
  for (const auto& [x, y, z] : bounds.window) bounds.weights.emplace_back(3 * (x * x + x * y + y * y - x - y) + 1);
  for (std::size_t i = 0; i < bounds.window.size(); ++i)
    if (std::ranges::find(corners, bounds.window[i]) == std::end(corners)) bounds.free.push_back(i);
  Words(mask, rate, bounds, arithmetic).bound();
  return bounds;
}

AffineFit::AffineFit(const FitBounds& bounds, const std::vector<Interval>& data, const Intervals& intervals)
    : bounds_(bounds), intervals_(intervals), at_zero_(data[bounds.corners[0]]) {
  for (std::size_t v = 0; v < 2; ++v) steps_[v] = data[bounds.corners[v + 1]] - at_zero_;
  for (const std::size_t i : bounds.free) {
    const std::array<mpz_class, 3> affine = affine_at(bounds.window[i]);
    Interval rest = data[i];
    for (std::size_t v = 0; v < 3; ++v) {
      const Interval& corner = data[bounds.corners[v]];
      rest = rest - (affine[v] < 0 ? Interval{affine[v] * corner.high, affine[v] * corner.low}
                                   : Interval{affine[v] * corner.low, affine[v] * corner.high});
    }
    rest_.high = std::max(rest_.high, ceiling(ratio(largest(rest), bounds.weights[i])));
  }
}

Interval AffineFit::slope(std::size_t axis) const {
  const mpz_class off = intervals_.times(intervals_.number(bounds_.slopes[axis]), rest_).high;
  return steps_[axis] + Interval{-off, off};
}

mpz_class AffineFit::least() const {
  mpz_class least = at_zero_.low - intervals_.times(intervals_.number(bounds_.value), rest_).high;
  for (std::size_t v = 0; v < 2; ++v) {
    const auto at = [&](int x) { return intervals_.times(intervals_.number(x + bounds_.shift[v]), steps_[v]).low; };
    least += std::min(at(0), at(1));
  }
  return least;
}

}  // namespace subcert_check
