#pragma once
/// Whether a scheme on vectors converges itself, which asks for more than a smooth solution of its refinement equation.

#include "multivariate_regularity.hpp"

namespace subcert {

/// Whether f'_i = sum over j of P_{i-Mj} f_j, P_k the transposed A_k of the mask, converges: for all bounded data there
/// is a continuous F with sup |f^n_i - F(M^-n i)| -> 0, and F is not always 0. Domain: any dilation. Error: none, `yes`
/// and `no` are proved. Cost: spinning of the first differences, and a joint spectral radius until it is below 1.
/// Proof: docs/vectors.md, theorem 1.
Decision vector_scheme_converges(const LatticeMask& mask, const Budget& budget);
Decision vector_scheme_converges(const QuadraticMask& mask, const Budget& budget);

/// What tells whether such a scheme converges: the vectors y that the sums of the P_k over all classes keep, and the
/// space of all long words T_w on the first differences of the data and on how they differ from the next ones.
struct SchemeDifferences {
  /// A basis; over a field the parts p, and then q, of p + sqrt(root) q. Where there is none it does not converge.
  std::vector<std::vector<Rational>> kept;
  std::optional<DifferenceSpace> space = std::nullopt;  ///< where something is kept
  /// Of the operators there, at least until it is known on which side of 1 it is: below 1 if it converges.
  JointSpectralRadius radius = {};
};
/// Domain: as above. Errors: throws Error where no space of at most 256 dimensions is found, 128 over a field.
SchemeDifferences scheme_differences(const LatticeMask& mask, const Budget& budget);
SchemeDifferences scheme_differences(const QuadraticMask& mask, const Budget& budget);

/// Whether the Hermite scheme D^(n+1) f'_i = sum over j of P_{i-aj} D^n f_j, D = diag(1, 1/a, ..., a^(1-r)), converges
/// with its derivatives, HC^(r-1): f^n_i - F(a^-n i) -> 0 uniformly with F = (phi, phi', ..., phi^(r-1)) continuous for
/// all bounded data, and phi is not always 0. No polynomials have to be kept. Domain: one variable. Errors: throws
/// Error. Error: as above. Cost: as above, r times. Proof: docs/vectors.md, theorem 2. Ref: [DM06], [MS19].
Decision hermite_scheme_converges(const LatticeMask& mask, const Budget& budget);
Decision hermite_scheme_converges(const QuadraticMask& mask, const Budget& budget);

/// HC^l of a scheme on r data from its convergence and the exponent of its limits: none where it does not converge. A
/// function of this kind has l continuous derivatives if and only if its exponent exceeds l (docs/vectors.md, theorem
/// 3). Domain: `found` is of the mask, all components asked for.
HermiteOrder hermite_order(const MultivariateRegularity& found, const Decision& converges, std::size_t data);

}  // namespace subcert
