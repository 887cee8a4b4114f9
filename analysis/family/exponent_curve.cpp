#include "exponent_curve.hpp"

#include "between_zeros.hpp"
#include "box_search.hpp"

#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/symbol/numbers/numbers.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace subcert {
namespace {

using namespace family;

constexpr int first_share = 2, round_share = 32;  // of the pieces: at once, and then in each round
constexpr int least_share = 4096;                 // of the range: no shorter piece is halved for a missing end
constexpr double excess_share = 0.02;             // of an upper bound, for one piece: small beside its slope
constexpr double most_seconds = 1;                // for one piece
constexpr double generous = 1.2;                  // times the equal share of the time, for one piece
constexpr double value_seconds = 5;
constexpr int value_levels = 12;  // of norms, at special values

class CurveSearch {
 public:
  CurveSearch(const ParametricMask& mask, const LaurentPolynomial& unstable, const std::vector<CurvePoint>& special,
              const Box& range, const CurveOptions& options)
      : options_(options),
        arity_(mask.arity()),
        rules_(sum_rules(mask)),
        polynomials_(polynomials_of(mask)),
        unstable_(unstable),
        special_(special),
        radius_(difference_matrices(mask)),
        range_(range) {}

  std::vector<CurvePiece> pieces() {
    const int wanted = options_.pieces, first = std::max(1, wanted / first_share);
    std::vector<Box> open;
    for (int k = 0; k < first; ++k)
      open.push_back({{range_.low[0] + range_.width() * Rational(k, first)},
                      {range_.low[0] + range_.width() * Rational(k + 1, first)}});
    std::vector<CurvePiece> done;
    in_rounds(
        std::move(open), options_.jobs, [&](const Box& box) { return piece(box); },
        [&](const std::vector<Box>&, std::vector<CurvePiece> decided) {
          std::move(decided.begin(), decided.end(), std::back_inserter(done));
          const auto missing = static_cast<std::size_t>(wanted) - done.size();
          if (options_.budget.deadline.expired()) return std::vector<Box>();
          return halves(done, std::min(missing, static_cast<std::size_t>(wanted / round_share + 1)));
        });
    std::sort(done.begin(), done.end(), [](const auto& a, const auto& b) { return a.proof.low < b.proof.low; });
    return done;
  }

 private:
  /// Takes out the pieces that are most worth it.
  std::vector<Box> halves(std::vector<CurvePiece>& pieces, std::size_t count) const {
    count = std::min(count, pieces.size());
    std::stable_sort(pieces.begin(), pieces.end(),
                     [this](const CurvePiece& a, const CurvePiece& b) { return worth(a) > worth(b); });
    std::vector<Box> result;
    for (std::size_t k = 0; k < count; ++k)
      for (const unsigned half : {0U, 1U})
        result.push_back(Box{{pieces[k].proof.low}, {pieces[k].proof.high}}.part(half));
    pieces.erase(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(count));
    return result;
  }

  /// The distance of the envelopes; a piece without one of them comes first, until it is short. Where a product is
  /// known and is no upper end there will be none.
  double worth(const CurvePiece& piece) const {
    if (piece.exponent.upper ? *piece.exponent.upper <= 0 : piece.proof.below.has_value()) return 0;
    if (!piece.exponent.is_bounded())
      return (piece.proof.high - piece.proof.low) * least_share > range_.width() ? rules_ : 0;
    return Rational(*piece.exponent.upper - std::max(Rational(0), *piece.exponent.lower)).convert_to<double>();
  }

  /// A piece on which a search fails has no ends, and says so.
  CurvePiece piece(const Box& box) {
    CurvePiece result{{}, {box.low[0], box.high[0], std::nullopt, std::nullopt}};
    try {
      enclose(box, result);
    } catch (const Error& error) {
      result.proof.reason = std::string("a search failed (") + error.what() + ")";
    }
    if (!result.exponent.is_bounded() && options_.budget.deadline.expired()) result.proof.reason = spent;
    if (result.exponent.is_bounded() || (result.exponent.upper && *result.exponent.upper <= 0))
      result.proof.reason.clear();
    return result;
  }

  void enclose(const Box& box, CurvePiece& result) {
    const Budget& budget = options_.budget;
    // Most pieces need less than their share; those that are harder may have more.
    const double share = budget.deadline.remaining() / options_.pieces;
    const double seconds = std::min(most_seconds, generous * share);
    if (budget.deadline.expired()) return;
    result.proof.above = radius_.from_above(box, excess_share / options_.pieces,
                                            {budget.deadline.at_most(seconds), budget.memory});
    if (result.proof.above)
      result.exponent.lower = rules_ - *log_ratio(result.proof.above->proved_upper(), arity_).upper;
    else
      result.proof.reason = "no upper bound of the radius was found in the time for one interval";
    const std::string reason = why_no_upper_end(box, result);
    if (!reason.empty() && polynomials_.data.empty()) {
      add_reason(result.proof.reason, reason);
      return;
    }
    std::tie(result.proof.below, result.exponent.upper) = end_by_product(box);
    if (!reason.empty()) {
      add_reason(result.proof.reason, reason);
      keep_what_stays(result);
      return;
    }
    if (!result.exponent.upper) result.exponent.upper = end_by_sum_rules(box);
    if (!result.exponent.upper) add_reason(result.proof.reason, "no product was proved to lead for all values there");
  }

  /// Of a scheme of vectors where a radius does not bound the exponent: its product, where shorter pieces tell no more,
  /// and an upper end where the scheme does not converge.
  void keep_what_stays(CurvePiece& piece) const {
    std::optional<Rational>& upper = piece.exponent.upper;
    if (polynomials_.interpolating && upper && *upper > derivatives()) piece.proof.below.reset();
    if (upper && *upper > 0) upper.reset();
  }
  /// Of the first component that the others are. Domain: matrices.
  long derivatives() const { return static_cast<long>(polynomials_.data.front().size()) - 1; }

  /// Why radii do not bound the exponent from above; empty where they do.
  std::string why_no_upper_end(const Box& box, const CurvePiece& found) const {
    const Deadline& deadline = options_.budget.deadline;
    if (polynomials_.data.empty())
      return has_no_real_root(unstable_, box.low[0], box.high[0], deadline) ? ""
             : unstable_.is_zero()                                          ? why_stability_is_open(deadline)
                                   : "the shifts may be unstable at a value there";
    if (!polynomials_.interpolating) return "no upper end is proved of matrices that do not interpolate";
    return found.exponent.lower && *found.exponent.lower > derivatives()
               ? ""
               : fmt::format("without a proof of HC{} no upper end is proved", derivatives());
  }

  /// By the product that leads, if one is proved to.
  std::pair<std::optional<EigenvalueBound>, std::optional<Rational>> end_by_product(const Box& box) {
    const Deadline& deadline = options_.budget.deadline;
    for (const Values& w : {box.middle(), box.low, box.high}) {
      const std::vector<int> word = radius_.look(w, deadline).word;
      auto below = radius_.from_below(box, word, 1, true, deadline);
      if (!below) continue;
      const Rational upper = rules_ -
                             *log_ratio(below->modulus(), arity_).lower / Rational(static_cast<long>(word.size()));
      return {std::move(below), upper};
    }
    return {};
  }

  /// An exponent above m is C^m, which takes m + 1 sum rules where the shifts are stable; so only single values go
  /// beyond.
  std::optional<Rational> end_by_sum_rules(const Box& box) const {
    Rational end = rules_;
    for (const CurvePoint& point : special_) {
      if (*point.at.value.upper < box.low[0] || box.high[0] < *point.at.value.lower) continue;
      if (!point.exponent || !point.exponent->upper) return std::nullopt;
      end = std::max(end, *point.exponent->upper);
    }
    return end;
  }

  const CurveOptions& options_;
  int arity_, rules_;
  PolynomialData polynomials_;
  const LaurentPolynomial& unstable_;
  const std::vector<CurvePoint>& special_;
  FamilyRadius radius_;
  Box range_;  // what is asked for
};

}  // namespace

ExponentCurve exponent_curve(const ParametricMask& mask, const Rational& low, const Rational& high,
                             const CurveOptions& options) {
  require_family(mask, low, high);
  require(options.pieces >= 1 && options.pieces <= 100'000, "curve: need 1 to 100000 pieces, got {}", options.pieces);
  ExponentCurve result;
  result.sum_rules = sum_rules(mask);
  const LaurentPolynomial unstable = unstable_values(mask, options.budget.deadline);
  for (SpecialValue& value : single_values(mask, unstable, low, high, power(Rational(10), -9))) {
    CurvePoint point{std::move(value), std::nullopt};
    if (point.at.value.is_exact())
      point.exponent = holder_regularity(mask.at(*point.at.value.lower), value_levels,
                                         {options.budget.deadline.at_most(value_seconds), options.budget.memory})
                           .exponent;
    result.special.push_back(std::move(point));
  }
  result.pieces = CurveSearch(mask, unstable, result.special, {{low}, {high}}, options).pieces();
  return result;
}

}  // namespace subcert
