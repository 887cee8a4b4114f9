#pragma once
/// The transition operators in ball arithmetic, for sources (never for public headers).

#include "transition.hpp"

#include <subcert/analysis/symbol/numbers/balls.hpp>

namespace subcert {

/// As Transition<double>; the balls of the result contain the exact result for all points of the arguments' balls.
template <>
class Transition<Ball> {
 public:
  Transition(const std::vector<Rational>& coefficients, int arity, slong bits)
      : window_(static_cast<long>(coefficients.size()) - 1, arity), bits_(bits), reversed_(coefficients.size()) {
    for (std::size_t i = 0; i < coefficients.size(); ++i)
      reversed_.set(coefficients.size() - 1 - i, Ball(coefficients[i], bits));
  }

  const TransitionWindow& window() const { return window_; }
  std::size_t width() const { return static_cast<std::size_t>(window_.width); }

  /// out = T_t in, each entry by one inner product.
  void apply(long t, const BallVector& in, BallVector& out) const {
    for (long j = 0; j < window_.width; ++j) {
      const IndexRange columns = window_.columns(t, j);
      const auto from = static_cast<std::size_t>(columns.first), entry = static_cast<std::size_t>(j);
      const long count = columns.last + 1 - columns.first;
      if (count > 0)
        out.set_dot(entry, reversed_, static_cast<std::size_t>(window_.degree - window_.index(t, j, columns.first)), in,
                    from, static_cast<std::size_t>(count), bits_);
      else
        out.set(entry, Ball(bits_));
    }
  }

 private:
  TransitionWindow window_;
  slong bits_;
  BallVector reversed_;
};

}  // namespace subcert
