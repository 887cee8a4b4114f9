#pragma once
/// A parameter that each level takes from the one before.

#include <subcert/analysis/symbol/numbers/interval.hpp>
#include <subcert/analysis/symbol/polynomials/rational_function.hpp>

#include <optional>
#include <string_view>

namespace subcert {

/// w_{k+1} = r(w_k), or the square root of that.
class Recurrence {
 public:
  /// `sqrt((1+w)/2)` or what RationalFunction::parse reads. Errors: throws ParseError.
  static Recurrence parse(std::string_view text, char letter);

  /// An interval that contains the values for all w in this one; nothing where some w has none, or may have none.
  /// Error: the ends are exact or rounded outward; with many zeros of r' the interval may be larger than needed. Cost:
  /// Bernstein coefficients on 64 parts.
  std::optional<Interval> image(const Interval& w) const;

  /// The least level found from which on all values stay in `kept`, for all w_0 in `start`; nothing where that is not
  /// proved within `most` levels: where `kept` is not mapped into itself, for one. Domain: most >= 0.
  std::optional<int> first_level_in(const Interval& kept, const Interval& start, int most) const;

 private:
  RationalFunction function_;
  bool is_root_ = false;
};

}  // namespace subcert
