#pragma once
/// The joint spectral radius of a family with letters, bounded for all their values in a box. Inner header.

#include "interval_proof.hpp"
#include "parametric_family.hpp"

#include <map>
#include <mutex>
#include <tuple>

namespace subcert::family {

/// The product with the largest radius that a quick look finds, in floating point.
struct Look {
  std::vector<int> word;  ///< from left to right
  double radius = 0;
};

/// Bounds over boxes. What it learns of products it keeps; safe to use from several threads.
class FamilyRadius {
 public:
  explicit FamilyRadius(ParametricFamily family) : family_(std::move(family)) {}

  Look look(const Values& w, const Deadline& deadline) const;

  /// A proof that the radius is below the target, by the control matrices; nothing where none is found. `try_form`: by
  /// a quadratic form first.
  std::optional<JointSpectralRadius> from_above(const Box& box, const Rational& target, bool try_form,
                                                const Budget& budget) const;
  /// An upper bound that exceeds the radius of the control matrices by that share, about, or by as little as the budget
  /// allows; nothing where the box has no control matrices.
  std::optional<JointSpectralRadius> from_above(const Box& box, double excess, const Budget& budget) const;

  /// A proof that the spectral radius of the product is above a number, at least this, on the whole box; nothing where
  /// none is found. `sharp`: the number is to be as large as it can be. Domain: least > 0.
  std::optional<EigenvalueBound> from_below(const Box& box, const std::vector<int>& word, const Rational& least,
                                            bool sharp, const Deadline& deadline);

  /// det(g - P) times a power of the denominator for the product P and the bound g (or -P, or the second compound and
  /// g^2): det(g - P) is negative where an odd number of eigenvalues exceed the bound. Zero past the deadline, or where
  /// it would be large.
  Powers<Rational> characteristic(const EigenvalueBound& bound, const Deadline& deadline);

 private:
  std::vector<EigenvalueBound> guesses(const Box& box, const std::vector<int>& word, double least, bool sharp) const;
  bool is_negative(const EigenvalueBound& bound, const Box& box, const Deadline& deadline);

  ParametricFamily family_;
  std::mutex mutex_;
  std::map<std::tuple<std::vector<int>, Rational, Rational>, Powers<Rational>> characteristics_;
};

}  // namespace subcert::family
