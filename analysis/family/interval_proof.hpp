#pragma once
/// What is proved of a family with a parameter for all its values in an interval, in rational numbers that a
/// certificate can hold.

#include <subcert/analysis/radii/joint/joint_spectral_radius.hpp>

#include <string>

namespace subcert {

/// For all values of an interval the product of the word, over the transition matrices from left to right, has a real
/// eigenvalue beyond `re`, on its side of 0, or two eigenvalues whose product is above im^2. Canonical: one of both is
/// 0, im >= 0.
struct EigenvalueBound {
  std::vector<int> word;
  Rational re = 0, im = 0;

  /// The spectral radius of the product is above it.
  Rational modulus() const { return re == 0 ? im : abs(re); }
};

struct IntervalProof {
  Rational low, high;
  /// An upper bound of the joint spectral radius of the control matrices of the interval.
  std::optional<JointSpectralRadius> above;
  std::optional<EigenvalueBound> below;
  std::string reason = {};  ///< where there is neither

  /// Of the property that needs a radius below a threshold.
  Truth holds() const { return above ? Truth::yes : below ? Truth::no : Truth::unknown; }
};

}  // namespace subcert
