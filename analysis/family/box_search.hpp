#pragma once
/// A property over boxes of values of letters: the search of ranges and maps. Inner header.

#include "family_radius.hpp"
#include "property_range.hpp"

#include <subcert/analysis/symbol/masks/polynomial_data.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>

#include <functional>

namespace subcert::family {

/// Of the difference scheme of order m: arity^(m - order).
class Threshold {
 public:
  Threshold(const RangeProperty& property, int arity, int rules);

  double value() const;
  /// Bounds with room for the rounding of the checker, exact where the exponent is whole.
  Rational below() const { return *raised(1).lower * (1 - margin()); }
  Rational power_above(long length) const { return *raised(length).upper * (1 + margin()); }
  /// Domain: a multiple of rational_power(1).
  Rational exact_power(long length) const { return *raised(length).upper; }
  /// The power of that power which is rational.
  long rational_power(long length) const { return denominator(exponent_ * Rational(length)).convert_to<long>(); }
  /// Radii are at least 1: below that nothing can be proved.
  bool is_reachable() const { return exponent_ > 0; }

 private:
  Rational margin() const { return denominator(exponent_) == 1 ? Rational(0) : power(Rational(2), -90); }
  Enclosure raised(long length) const;

  int arity_;
  Rational exponent_;
};

constexpr std::size_t most_matrices = 64;  // that a box may have for its controls

/// Errors: throws Error, which names the command, unless low < high for all letters, a sum rule holds for all values,
/// and there are at most `most_matrices` control matrices.
void require_box(const std::string& command, const ParametricMask& mask, const Box& box);

/// Errors: throws Error, which names the command, where a property cannot be asked for: `hermite` of numbers, of
/// matrices that do not keep values and derivatives, or with an order below the last derivative; others of matrices
/// than those of property_range.
void require_property(const std::string& command, const ParametricMask& mask, const RangeProperty& property, int rules);

/// The data of a mask of matrices; none of numbers.
PolynomialData polynomials_of(const ParametricMask& mask);

/// Of matrices: whether it is proved that on all of the box the components converge to derivatives of the first, by
/// which the radius tells the exponent of the limits (docs/vectors.md).
bool links_derivatives(const FamilyRadius& radius, const PolynomialData& polynomials, int arity, const Box& box,
                       const Budget& budget);

/// As IntervalProof, for several letters.
struct BoxProof {
  Box box;
  std::optional<JointSpectralRadius> above;
  std::optional<EigenvalueBound> below;
  std::string reason = {};
  bool is_final = false;  ///< no part of the box will be decided either

  Truth holds() const { return above ? Truth::yes : below ? Truth::no : Truth::unknown; }
};

class BoxSearch {
 public:
  /// Domain: as require_box; `convergent`, or `smooth`, `hermite` or `holder` of any order.
  BoxSearch(const ParametricMask& mask, const RangeProperty& property, const Box& range, const Budget& budget);

  struct Plan {
    int jobs;
    std::vector<Look> at_corners;               ///< of the range; empty where none is asked for
    std::function<double(const Box&)> seconds;  ///< for one upper bound
    /// Whether a box that is not decided, after so many seconds, is left so.
    std::function<bool(const Box&, double)> is_last;
  };
  /// Halves in each letter what is not decided, until the deadline; `done` is called with each box that is not halved.
  void run(const Plan& plan, const std::function<void(BoxProof)>& done);

  /// Where a search fails nothing is known of the value.
  Look look_if_possible(const Values& w) const;
  /// Whether it is proved that a radius above the threshold refutes the property, for all values: of numbers by stable
  /// shifts.
  bool refutes_on(const Box& box) const;

  FamilyRadius& radius() { return radius_; }
  const Threshold& threshold() const { return threshold_; }
  /// unstable_values of a mask with one letter, where they matter.
  const LaurentPolynomial& unstable() const { return unstable_; }

 private:
  struct Node {
    Box box;
    std::vector<Look> at_corners;  ///< with empty words where nothing is known
  };
  struct Decided {
    BoxProof proof;
    Look middle;
    double seconds = 0;
  };
  Decided decide(const Node& node, const Plan& plan);
  std::string search(const Node& node, double seconds, Decided& result);
  bool is_stable_on(const Box& box) const;
  bool never_refutes_on(const Box& box, const std::vector<Look>& looks);
  std::string why_not_refuted() const;

  ParametricMask mask_;
  RangeProperty property_;
  Box range_;
  Budget budget_;
  Threshold threshold_;
  FamilyRadius radius_;
  LaurentPolynomial unstable_;
  PolynomialData polynomials_;
};

}  // namespace subcert::family
