#pragma once
/// The transition operators of a mask of one variable, in several kinds of numbers and without maps of indices:
///
///   (T_t)_{jk} = b_{arity*j + t - k} ,   0 <= t < arity ,   0 <= j, k < width .
///
/// They are those of lattice_window.hpp for s = 1 and the digits 0, ..., arity - 1.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>

#include <vector>

namespace subcert {

/// The indices that matter for coefficients b_0, ..., b_degree: 0, ..., width - 1 with width = max(1, ceil(degree /
/// (arity-1))), the least range outside of which T_t v vanishes for every v that vanishes there. Domain: degree >= 0,
/// arity >= 2.
struct TransitionWindow {
  TransitionWindow(long degree, int arity);

  long degree;
  long arity;
  long width;

  /// The index of the coefficient at (T_t)_{jk}.
  long index(long t, long j, long k) const { return arity * j + t - k; }
  /// The columns k of row j where there is a coefficient; last < first where there is none.
  IndexRange columns(long t, long j) const {
    const long highest = index(t, j, 0);
    return {highest > degree ? highest - degree : 0, highest < width ? highest : width - 1};
  }
};

/// T_0, ..., T_{arity-1} for the coefficients b_0, ..., b_degree, on vectors of width() numbers. Domain: Number is
/// double, Integer or Rational (for balls: ball_transition.hpp); the vectors do not overlap; 0 <= t < arity.
/// Error: none but for double, where an entry is a sum of at most `width` products, each step of which is rounded; the
/// order of the products is that of the entries of `in`. Cost: degree * width / arity products.
template <class Number>
class Transition {
 public:
  Transition(const std::vector<Number>& coefficients, int arity);

  const TransitionWindow& window() const { return window_; }
  std::size_t width() const { return static_cast<std::size_t>(window_.width); }

  /// out = T_t in.
  void apply(long t, const Number* in, Number* out) const;
  /// out = transposed T_t in.
  void apply_transposed(long t, const Number* in, Number* out) const;

 private:
  TransitionWindow window_;
  std::vector<std::vector<Number>> cosets_;  // a column of T_t is a stretch of one coset of the coefficients,
  std::vector<Number> reversed_;             // a row one of the coefficients from the last to the first
};

extern template class Transition<double>;
extern template class Transition<Integer>;
extern template class Transition<Rational>;

/// (b_{arity*j + shift - k})_{jk} for j in rows and k in columns, with the coefficients b of the symbol as they are
/// numbered there.
RationalMatrix transition_block(const LaurentPolynomial& symbol, int arity, long shift, const IndexRange& rows,
                                const IndexRange& columns);

/// T_0, ..., T_{arity-1} for b_i = the coefficient first + i of a mask that starts at `first`. The sums of absolute
/// values in the columns of the products of L of them are the sums of |coefficients| of the L-th power of the scheme
/// over cosets (docs/level-norms.md), so that their joint spectral radius is the limit of ||S^L||^(1/L).
std::vector<RationalMatrix> transition_matrices(const Mask& mask);
/// The same on so many indices. Domain: width >= that of the window.
std::vector<RationalMatrix> transition_matrices(const Mask& mask, long width);

/// C_{jk} = b_{arity*j - k} + b_{arity*j + k} (one term where k = 0), 0 <= j, k <= N/(arity-1), for coefficients
/// b_{-N}, ..., b_N with b_{-i} = b_i: the powers of C hold the coefficients about the centre of the powers of the
/// scheme, (C^n)_{00} is the coefficient of z^0 of b(z) b(z^arity) ... b(z^(arity^(n-1))). Domain: symbol(1/z) =
/// symbol(z), not zero. Errors: throws Error. Ref: docs/single-radius.md.
RationalMatrix central_matrix(const LaurentPolynomial& symbol, int arity);
/// The same for 0 <= j, k <= reach.
RationalMatrix central_matrix(const LaurentPolynomial& symbol, int arity, long reach);

/// The refinement equation as a step of vectors. With v(x) = (phi(first + k + x))_k, 0 <= k < width, 0 <= x <= 1:
/// v((t + x)/arity) = T_t v(x), where T_t belongs to these coefficients, which start with zeros where the support of
/// phi starts between integers. phi vanishes outside [first, first + width]. Domain: phi is continuous.
struct RefinementWindow {
  explicit RefinementWindow(const Mask& mask);

  long first;
  std::vector<Rational> coefficients;
};

}  // namespace subcert
