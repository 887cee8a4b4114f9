#include "range_summary.hpp"

#include <subcert/analysis/symbol/polynomials/real_roots.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace subcert::facts {
namespace {

constexpr std::size_t most_coefficients = 12;  // of a polynomial in text
const Rational little(1, 1'000'000);           // share of the range, of pieces that are open after the time

/// Where the values for which the property holds begin or end.
struct Border {
  std::string value;  ///< `0`, `the zero of ...`
  bool included;
};

/// Puts together for which values the property holds, where all pieces, ends and special values leave no more open
/// than the width that was asked for, or little.
class Summary {
 public:
  Summary(const PropertyRange& range, const ParametricScheme& scheme, Formula formula)
      : range_(range), scheme_(scheme), formula_(std::move(formula)), name_(formula_(scheme.name)) {}

  /// `C1 exactly for 0 < w < r, r the zero of 32*w^3 + 4*w - 1 near 0.19`; nothing where some values are open.
  std::optional<std::string> sentence(const std::string& property) {
    for (std::size_t k = 0; k < range_.pieces.size(); ++k)
      if (!add(k)) return std::nullopt;
    if (open_) close({last(), true});
    if (!range_.complete && gap_ > (range_.pieces.back().high - range_.pieces.front().low) * little)
      return std::nullopt;
    const std::string among = fmt::format(" from {} to {}", formula_(number_text(range_.pieces.front().low)),
                                          formula_(last()));
    std::string text = values_.empty() ? fmt::format("{} for no {}", property, name_)
                       : near_.empty() && left_open_ == 0
                           ? fmt::format("{} exactly for {}, of all {}", property, values_, name_)
                           : fmt::format("{} for {}, and for no other {}", property, values_, name_);
    text += among;
    std::string near;
    for (const std::string& value : near_) near += (near.empty() ? "" : ", ") + formula_(value);
    if (!near.empty())
      text += fmt::format("; open on both sides within {} of {}", to_decimal(gap_, 2, Rounding::up), near);
    if (left_open_ > 0)
      text += fmt::format("; open in {} other piece{} of at most {}", left_open_, left_open_ == 1 ? "" : "s",
                          to_decimal(gap_, 2, Rounding::up));
    for (const auto& [meaning, name] : roots_) text += fmt::format("; {} is {}", formula_(name), meaning);
    return text;
  }

 private:
  std::string last() const { return number_text(range_.pieces.back().high); }

  /// A rational number, or a name for a zero.
  std::string value_text(const LaurentPolynomial& of, const Rational& near) {
    std::string text = zero_text(of, near, scheme_, formula_);
    if (zero_of_linear(of)) return text;
    for (const auto& [meaning, name] : roots_)
      if (meaning == text) return name;
    std::string name = roots_.empty() ? "r" : fmt::format("r{}", roots_.size() + 1);
    if (name == scheme_.name) name = "r1";
    roots_.emplace_back(std::move(text), name);
    return name;
  }

  bool add(std::size_t k) {
    const RangePiece& piece = range_.pieces[k];
    if (piece.holds == Truth::unknown) return bridge(k);
    if (piece.holds == Truth::yes && !open_) open_ = Border{number_text(piece.low), piece.low_included};
    if (piece.holds == Truth::no && open_) close({number_text(piece.low), !piece.low_included});
    return true;
  }

  /// Over a piece that is not decided: by the one end or value in it.
  bool bridge(std::size_t k) {
    const RangePiece& piece = range_.pieces[k];
    gap_ = std::max(gap_, Rational(piece.high - piece.low));
    const auto inside = [&](const Rational& low, const Rational& high) {
      return piece.low <= low && high <= piece.high;
    };
    std::vector<std::pair<std::string, Truth>> points;
    for (const RangeEnd& end : range_.ends)
      if (inside(end.low, end.high)) points.emplace_back(value_text(end.polynomial, end.low), end.holds);
    for (const SpecialValue& value : range_.special)
      if (inside(*value.value.lower, *value.value.upper))
        points.emplace_back(value_text(value.polynomial, *value.value.lower), value.holds);
    if (points.empty()) return leave_open(k);
    if (points.size() != 1 || points.front().second == Truth::unknown) return false;
    const auto& [value, holds] = points.front();
    if (piece.low < piece.high) near_.push_back(value);
    const auto holds_in = [&](std::size_t other) {
      return other < range_.pieces.size() && range_.pieces[other].holds == Truth::yes;
    };
    const bool after = holds_in(k + 1), at = holds == Truth::yes;
    if (open_ && !(at && after)) close({value, at});
    if (!open_ && after) open_ = Border{value, at};
    return true;
  }

  /// Between two pieces with one verdict.
  bool leave_open(std::size_t k) {
    if (k == 0 || k + 1 >= range_.pieces.size()) return false;
    const Truth before = range_.pieces[k - 1].holds;
    ++left_open_;
    return before != Truth::unknown && before == range_.pieces[k + 1].holds;
  }

  void close(const Border& end) {
    values_ += values_.empty() ? "" : " and ";
    values_ += formula_(open_->value == end.value
                            ? fmt::format("{} = {}", scheme_.name, end.value)
                            : fmt::format("{} {} {} {} {}", open_->value, open_->included ? "<=" : "<", scheme_.name,
                                          end.included ? "<=" : "<", end.value));
    open_.reset();
  }

  const PropertyRange& range_;
  const ParametricScheme& scheme_;
  Formula formula_;
  std::string name_;  // of the parameter, as a formula
  std::optional<Border> open_;
  std::string values_;                                      // `w = 0 and 1 < w <= 2`
  Rational gap_ = 0;                                        // the width of the widest piece that is not decided
  int left_open_ = 0;                                       // such pieces without a value that is decided
  std::vector<std::string> near_;                           // what lies in such pieces
  std::vector<std::pair<std::string, std::string>> roots_;  // what they are, and their names
};

}  // namespace

std::string number_text(const Rational& value, Rounding rounding, int digits) {
  const std::string exact = to_text(value);
  return exact.size() <= 12 ? exact : to_decimal(value, digits, rounding);
}

std::string zero_text(const LaurentPolynomial& of, const Rational& near, const ParametricScheme& scheme,
                      const Formula& formula) {
  if (const auto zero = zero_of_linear(of)) return to_text(*zero);
  const std::string polynomial = static_cast<std::size_t>(of.length()) <= most_coefficients
                                     ? formula(scheme.named(to_text(of, scheme.letter)))
                                     : fmt::format("a polynomial of degree {}", of.highest());
  return fmt::format("the zero of {} near {}", polynomial, formula(number_text(near)));
}

std::optional<std::string> range_summary(const PropertyRange& range, const ParametricScheme& scheme,
                                         const std::string& property, const Formula& formula) {
  return Summary(range, scheme, formula).sentence(property);
}

}  // namespace subcert::facts
