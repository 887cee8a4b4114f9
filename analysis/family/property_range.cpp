#include "property_range.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/regularity/polytope_proof/candidate.hpp>
#include <subcert/analysis/regularity/polytope_search/decompositions.hpp>
#include <subcert/analysis/regularity/radius/one_block.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/parallel.hpp>
#include <subcert/analysis/symbol/real_roots.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <tuple>

namespace subcert {
namespace {

constexpr double form_seconds = 0.2, radius_seconds = 2;  // for one interval
constexpr double far_below = 0.97;                        // of the threshold: quadratic forms may do
constexpr double special_seconds = 10;                    // for one value
constexpr int levels = 12;                                // of norms, at special values
constexpr std::size_t longest_end = 24;                   // letters of a product that names an end
constexpr std::size_t most_matrices = 64;

/// What a radius of the difference scheme of order m has to stay below: arity^(m - order).
class Threshold {
 public:
  Threshold(const RangeProperty& property, int arity, int rules) : arity_(arity), exponent_(rules) {
    if (property.kind == RangeProperty::Kind::smooth || property.kind == RangeProperty::Kind::holder)
      exponent_ -= property.order;
  }

  double value() const { return std::pow(arity_, exponent_.convert_to<double>()); }
  bool is_above(const Rational& radius) const { return power_below(1) > radius; }
  /// Rational bounds of its powers, exact where these are rational and the exponent is whole.
  Rational power_below(long length) const { return *raised(length).lower; }
  Rational power_above(long length) const { return *raised(length).upper; }
  /// The power of that power which is rational.
  long rational_power(long length) const { return denominator(exponent_ * Rational(length)).convert_to<long>(); }
  /// Radii are at least 1: below that nothing can be proved.
  bool is_reachable() const { return exponent_ > 0; }

 private:
  Enclosure raised(long length) const {
    const Rational exponent = exponent_ * Rational(length);
    const long top = numerator(exponent).convert_to<long>(), root = denominator(exponent).convert_to<long>();
    if (root == 1) return Enclosure::exactly(power(Rational(arity_), top));
    Enclosure modulus = root_enclosure(power(Rational(arity_), std::abs(top)), static_cast<int>(root));
    if (top >= 0) return modulus;
    return {1 / *modulus.upper, 1 / *modulus.lower};
  }

  int arity_;
  Rational exponent_;
};

/// The product with the largest radius that a quick look finds, in floating point.
struct Look {
  std::vector<int> word;
  double radius = 0;
};

struct Node {
  Rational low, high;
  Look at_low, at_high;
};

class RangeSearch {
 public:
  RangeSearch(const ParametricMask& mask, const RangeProperty& property, const RangeOptions& options)
      : property_(property),
        options_(options),
        rules_(sum_rules(mask)),
        threshold_(property, mask.arity(), rules_),
        family_(transition_matrices(divided_difference_scheme(mask, rules_))) {
    if (property.kind != RangeProperty::Kind::convergent) unstable_ = unstable_values(mask, options.budget.deadline);
  }

  std::vector<RangePiece> pieces(const Rational& low, const Rational& high) {
    std::vector<RangePiece> done;
    std::vector<Node> open{{low, high, look(low), look(high)}};
    while (!open.empty()) {
      std::vector<RangePiece> decided(open.size());
      std::vector<Look> middles(open.size());
      parallel_for_each(open.size(), options_.jobs, [&](std::size_t k) {
        middles[k] = look((open[k].low + open[k].high) / 2);
        decided[k] = decide(open[k], middles[k]);
      });
      std::vector<Node> next;
      for (std::size_t k = 0; k < open.size(); ++k) {
        Node& node = open[k];
        const Rational middle = (node.low + node.high) / 2;
        if (decided[k].holds != Truth::unknown || node.high - node.low <= options_.width ||
            options_.budget.deadline.expired()) {
          done.push_back(std::move(decided[k]));
          continue;
        }
        next.push_back({node.low, middle, std::move(node.at_low), middles[k]});
        next.push_back({middle, node.high, std::move(middles[k]), std::move(node.at_high)});
      }
      open = std::move(next);
    }
    std::sort(done.begin(), done.end(), [](const RangePiece& a, const RangePiece& b) { return a.low < b.low; });
    return done;
  }

  /// Between a proved and a refuted piece.
  std::optional<RangeEnd> end_between(const RangePiece& gap, const std::vector<int>& word) {
    // As often as makes the power of the threshold rational.
    const long times = threshold_.rational_power(static_cast<long>(word.size()));
    std::vector<int> repeated;
    for (long k = 0; k < times; ++k) repeated.insert(repeated.end(), word.begin(), word.end());
    if (repeated.size() > longest_end) return std::nullopt;
    for (const int sign : {1, -1}) {
      const LaurentPolynomial crossing = characteristic_at(power_of_threshold(repeated), repeated, sign);
      if (crossing.is_zero() || crossing(gap.low) == 0 || crossing(gap.high) == 0 ||
          count_real_roots(crossing, gap.low, gap.high) != 1)
        continue;
      for (const PolynomialFactor& factor : irreducible_factors(crossing))
        if (count_real_roots(factor.polynomial, gap.low, gap.high) == 1)
          return RangeEnd{gap.low, gap.high, factor.polynomial, word};
    }
    return std::nullopt;
  }

 private:
  Look look(const Rational& w) const {
    const MatrixFamily family = family_.at(w);
    Look result{radius::find_product(family, options_.budget.deadline), 0};
    // From left to right here, the letter applied first there.
    std::vector<int> word(result.word.rbegin(), result.word.rend());
    result.radius = polytope::product_radius(radius::to_search_family(family).matrices, word);
    return result;
  }

  RangePiece decide(const Node& node, const Look& middle) {
    RangePiece piece{node.low, node.high};
    if (options_.budget.deadline.expired()) return piece;
    const double limit = threshold_.value();
    if (middle.radius > std::max(limit, 1.0)) {
      if (!is_stable_on(node)) return piece;
      for (const std::vector<int>& word : {middle.word, node.at_low.word, node.at_high.word})
        if (is_too_large_on(node, word)) {
          piece.holds = Truth::no;
          piece.word = word;
          return piece;
        }
    } else if (const double largest = std::max(node.at_low.radius, node.at_high.radius);
               threshold_.is_reachable() && largest < limit) {
      if (is_small_on(node, largest < far_below * limit)) piece.holds = Truth::yes;
    }
    return piece;
  }

  bool is_stable_on(const Node& node) const {
    if (property_.kind == RangeProperty::Kind::convergent) return true;
    return !unstable_.is_zero() && unstable_(node.low) != 0 && unstable_(node.high) != 0 &&
           count_real_roots(unstable_, node.low, node.high) == 0;
  }

  /// By a quadratic form first, where that may do.
  bool is_small_on(const Node& node, bool try_form) const {
    const MatrixFamily family = family_.controls(node.low, node.high);
    const Rational target = threshold_.power_below(1);
    const auto within = [this](double seconds) {
      return Budget{options_.budget.deadline.at_most(seconds), options_.budget.memory};
    };
    if (try_form)
      if (const auto form = radius::quadratic_bound(family, target, within(form_seconds));
          form && threshold_.is_above(form->bound))
        return true;
    return threshold_.is_above(joint_spectral_radius(family, within(radius_seconds)).proved_upper());
  }

  /// Whether the product has a real eigenvalue of modulus above the power of the threshold, for all w of the interval:
  /// its characteristic polynomial, which tends to infinity, is negative there or above it.
  bool is_too_large_on(const Node& node, const std::vector<int>& word) {
    for (const int sign : {1, -1}) {
      for (const Rational& g : below_eigenvalues(node, word, sign)) {
        const LaurentPolynomial value = characteristic_at(g, word, sign);
        if (!value.is_zero() && value(node.low) < 0 && value(node.high) < 0 &&
            count_real_roots(value, node.low, node.high) == 0)
          return true;
      }
    }
    return false;
  }

  Rational power_of_threshold(const std::vector<int>& word) const {
    return std::max(Rational(1), threshold_.power_above(static_cast<long>(word.size())));
  }

  /// Numbers, at least the power of the threshold, that an odd number of real eigenvalues of sign * P exceed in the
  /// middle, as far as floating point tells: the power itself, and one below the largest eigenvalue alone.
  std::vector<Rational> below_eigenvalues(const Node& node, const std::vector<int>& word, int sign) const {
    const Rational g = power_of_threshold(word);
    const MatrixFamily family = family_.at((node.low + node.high) / 2);
    std::vector<double> above;
    const polytope::Matrix product = radius::to_search_family({family.product(word)}).matrices.front();
    for (const std::complex<double>& value : polytope::eigenvalues(product))
      if (std::abs(value.imag()) < 1e-9 * std::abs(value) && sign * value.real() > g.convert_to<double>())
        above.push_back(sign * value.real());
    if (above.empty()) return {};
    std::vector<Rational> result;
    if (above.size() % 2 == 1) result.push_back(g);
    above.push_back(g.convert_to<double>());
    std::sort(above.rbegin(), above.rend());
    result.push_back(std::max(g, Rational(std::sqrt(above[0] * above[1]))));
    return result;
  }

  /// det(g - sign P(w)) as a polynomial in w, P the product of the word; zero past the deadline.
  LaurentPolynomial characteristic_at(const Rational& g, const std::vector<int>& word, int sign) {
    const auto key = std::tuple(word, sign, g);
    {
      const std::scoped_lock lock(mutex_);
      if (const auto known = characteristics_.find(key); known != characteristics_.end()) return known->second;
    }
    const auto shifted = [&](const Rational& w) {
      RationalMatrix result = Rational(-sign) * family_.at(w).product(word);
      for (std::size_t i = 0; i < family_.size(); ++i) result(i, i) += g;
      return result;
    };
    const auto degree = static_cast<long>(family_.size() * word.size()) * family_.degree();
    auto result = determinant(shifted, degree, options_.budget.deadline);
    if (!result) return {};
    const std::scoped_lock lock(mutex_);
    return characteristics_.emplace(key, std::move(*result)).first->second;
  }

  RangeProperty property_;
  const RangeOptions& options_;
  int rules_;
  Threshold threshold_;
  ParametricFamily family_;
  LaurentPolynomial unstable_;
  std::mutex mutex_;
  std::map<std::tuple<std::vector<int>, int, Rational>, LaurentPolynomial> characteristics_;
};

/// Whether the scheme has the property at one value.
Truth holds_at(const Mask& mask, const RangeProperty& property, const Deadline& deadline) {
  if (property.kind == RangeProperty::Kind::stable) return has_stable_shifts(mask).truth;
  const HolderRegularity regularity = holder_regularity(mask, levels, {deadline.at_most(special_seconds)});
  const Enclosure& exponent = regularity.exponent;
  const bool strict = property.kind != RangeProperty::Kind::holder;
  if (*exponent.lower > property.order || (!strict && *exponent.lower >= property.order)) return Truth::yes;
  if (property.kind == RangeProperty::Kind::convergent) return converges(mask, {levels, deadline.at_most(5)}).truth;
  if (!exponent.upper) return Truth::unknown;
  // With a logarithm the derivative before the last is not Lipschitz continuous.
  const bool attains = exponent.is_exact() && *exponent.lower == property.order;
  return *exponent.upper < property.order || (strict && attains && regularity.logarithm.at_least > 0) ? Truth::no
                                                                                                      : Truth::unknown;
}

/// The real zeros of a polynomial in w, each with its irreducible factor.
std::vector<SpecialValue> zeros_of(const LaurentPolynomial& polynomial, const Rational& low, const Rational& high,
                                   const Rational& width) {
  std::vector<SpecialValue> result;
  if (polynomial.is_zero() || polynomial == LaurentPolynomial(polynomial.coefficient(0))) return result;
  for (const PolynomialFactor& factor : irreducible_factors(polynomial)) {
    const LaurentPolynomial& p = factor.polynomial;
    if (p.length() == 2 || p.lowest() == 1) {
      const Rational root = -p.coefficient(0) / p.coefficient(1);
      if (low <= root && root <= high) result.push_back({Enclosure::exactly(root), p, Truth::unknown});
      continue;
    }
    for (const Enclosure& root : real_roots(p, low, high, width)) result.push_back({root, p, Truth::unknown});
  }
  std::sort(result.begin(), result.end(),
            [](const SpecialValue& a, const SpecialValue& b) { return *a.value.lower < *b.value.lower; });
  return result;
}

std::vector<RangePiece> merged(const std::vector<RangePiece>& pieces) {
  std::vector<RangePiece> result;
  for (const RangePiece& piece : pieces) {
    if (!result.empty() && result.back().holds == piece.holds)
      result.back().high = piece.high;
    else
      result.push_back(piece);
  }
  return result;
}

/// Between the zeros of the polynomial that tells where shifts may be unstable.
PropertyRange stable_range(const ParametricMask& mask, const Rational& low, const Rational& high,
                           const RangeOptions& options) {
  PropertyRange result;
  result.sum_rules = sum_rules(mask);
  const LaurentPolynomial unstable = unstable_values(mask, options.budget.deadline);
  if (unstable.is_zero()) {
    result.pieces = {{low, high}};
    result.complete = false;
    return result;
  }
  result.special = zeros_of(unstable, low, high, options.width);
  Rational reached = low;
  for (SpecialValue& value : result.special) {
    if (value.value.is_exact()) value.holds = has_stable_shifts(mask.at(*value.value.lower)).truth;
    if (reached < *value.value.lower)
      result.pieces.push_back({reached, *value.value.lower, Truth::yes, {}, result.pieces.empty(), false});
    result.pieces.push_back({*value.value.lower, *value.value.upper, value.holds, {}});
    reached = *value.value.upper;
  }
  if (reached < high || result.pieces.empty())
    result.pieces.push_back({reached, high, Truth::yes, {}, result.pieces.empty(), true});
  return result;
}

}  // namespace

std::optional<RangeProperty> parse_range_property(std::string_view text) {
  using Kind = RangeProperty::Kind;
  if (text == "convergent") return RangeProperty{Kind::convergent, 0};
  if (text == "stable") return RangeProperty{Kind::stable, 0};
  constexpr std::string_view holder = "holder>=";
  const bool smooth = text.starts_with('C');
  if (!smooth && !text.starts_with(holder)) return std::nullopt;
  const auto order = text.size() > 40 ? std::nullopt : parse_rational(text.substr(smooth ? 1 : holder.size()));
  if (!order || *order < 0 || *order > 100 || denominator(*order) > (smooth ? 1 : 1000)) return std::nullopt;
  if (smooth && *order == 0) return RangeProperty{Kind::convergent, 0};
  return RangeProperty{smooth ? Kind::smooth : Kind::holder, *order};
}

PropertyRange property_range(const ParametricMask& mask, const RangeProperty& property, const Rational& low,
                             const Rational& high, const RangeOptions& options) {
  require(low < high, "range: need low < high, got {} and {}", low, high);
  require(static_cast<std::size_t>(mask.arity()) * (mask.powers().size()) <= most_matrices,
          "range: need arity * (degree + 1) up to 64, got {}",
          static_cast<std::size_t>(mask.arity()) * mask.powers().size());
  require(sum_rules(mask) >= 1, "range: need a sum rule for all values of the parameter, got none");
  if (property.kind == RangeProperty::Kind::stable) return stable_range(mask, low, high, options);
  RangeSearch search(mask, property, options);
  PropertyRange result;
  result.sum_rules = sum_rules(mask);
  const std::vector<RangePiece> pieces = search.pieces(low, high);
  result.pieces = merged(pieces);
  result.complete = std::all_of(pieces.begin(), pieces.end(), [&](const RangePiece& piece) {
    return piece.holds != Truth::unknown || piece.high - piece.low <= options.width;
  });
  for (std::size_t k = 1; k + 1 < result.pieces.size(); ++k) {
    const RangePiece& gap = result.pieces[k];
    const Truth before = result.pieces[k - 1].holds, after = result.pieces[k + 1].holds;
    if (gap.holds != Truth::unknown || before == Truth::unknown || after == Truth::unknown || before == after) continue;
    // The product that refutes beside the gap.
    const Rational& side = before == Truth::no ? gap.low : gap.high;
    const auto beside = std::find_if(pieces.begin(), pieces.end(), [&](const RangePiece& piece) {
      return piece.holds == Truth::no && (before == Truth::no ? piece.high : piece.low) == side;
    });
    if (beside == pieces.end()) continue;
    if (auto end = search.end_between(gap, beside->word)) result.ends.push_back(std::move(*end));
  }
  result.special = zeros_of(special_values(mask), low, high, options.width);
  for (SpecialValue& value : result.special)
    if (value.value.is_exact()) value.holds = holds_at(mask.at(*value.value.lower), property, options.budget.deadline);
  return result;
}

}  // namespace subcert
