#pragma once
/// A parameter that each level takes from the one before.

#include <subcert/analysis/symbol/numbers/interval.hpp>
#include <subcert/analysis/symbol/polynomials/rational_function.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace subcert {

/// w_0: all values of an interval, or all from its lower end on.
struct FirstValues {
  Interval values;
  bool unbounded = false;  ///< then the upper end is the lower one
};

/// To which number values tend.
struct LimitOfValues {
  Rational value;
  std::vector<Interval> way;  ///< that they are in one after the other, until |r'| < 1 in one that they do not leave
};

/// w_{k+1} = r(w_k), or the square root of that.
class Recurrence {
 public:
  /// `w=sqrt((1+w)/2)`, or behind the sign what RationalFunction::parse reads. The letter stands for the name within.
  /// Errors: throws ParseError.
  static Recurrence parse(std::string_view written, std::string_view name, char letter);

  /// What stands behind the sign, as it is written, without blanks.
  const std::string& text() const { return text_; }

  /// The same in the form of certificates: `sqrt[1/2+1/2*w]`, `[1]/(1+w)`.
  std::string to_text(char letter) const;

  /// An interval that contains the values for all w in this one; nothing where some w has none, or may have none.
  /// Error: the ends are exact or rounded outward; with many zeros of r' the interval may be larger than needed. Cost:
  /// Bernstein coefficients on 64 parts.
  std::optional<Interval> image(const Interval& w) const;

  /// w_0, w_1, ..., so many of them. Errors: throws Error of kind domain where one does not exist, or may not, of
  /// kind undecided where one is not known within 2^-100, or is above 2^256 in modulus. Error:
  /// exact where numbers are rational and short, else widths of some 2^-128 times what the recurrence makes of them.
  std::vector<Interval> values(const Rational& start, std::size_t count) const;

  /// An interval that contains w_k, given in one, and all values after it; nothing where none was found.
  std::optional<Interval> all_from(const Interval& w) const;

  /// Intervals of the values at levels 1, 2, ... up to the first that lies in `kept`, which is then true of all later
  /// levels; none where `start` lies there. Where it is unbounded, those that begin with w_0 up to the upper end of
  /// `kept`: values above it are led down to it, in some number of levels. Nothing where that is not proved within
  /// `most` levels: where `kept` is not mapped into itself, for one. Domain: most >= 0. Error: ends have few digits,
  /// and are rounded outward.
  std::optional<std::vector<Interval>> way_into(const Interval& kept, const FirstValues& start, int most) const;

  /// The rational number to which w_k tends for all w_0 in `kept`; nothing where that is not proved: where `kept` is
  /// not mapped into itself, or no part of it into which all values come has |r'| < 1 throughout.
  std::optional<LimitOfValues> limit_in(const Interval& kept) const;

  /// Whether w_{k+1} = sqrt((1 + w_k)/2), which cos(t/2) is of cos(t).
  bool halves_angles() const;

 private:
  /// Whether each w above the interval leads to at most 9 w / 10, and not below it.
  bool descends_to(const Interval& w) const;
  bool contracts(const Interval& w) const;
  /// A rational one.
  std::optional<Rational> fixed_point_in(const Interval& w) const;

  std::string text_;
  RationalFunction function_;
  bool is_root_ = false;
};

}  // namespace subcert
