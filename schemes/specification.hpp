#pragma once
/// Scheme specifications `FAMILY:key=value,key=value`, read, checked and printed back.

#include "l1_scheme.hpp"
#include "local_regression.hpp"

#include <subcert/analysis/symbol/masks/level_masks.hpp>
#include <subcert/analysis/symbol/masks/matrix_masks.hpp>
#include <subcert/analysis/symbol/masks/parametric_mask.hpp>
#include <subcert/analysis/symbol/polynomials/term_text.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace subcert {

/// A specification that cannot be read.
class SpecificationError : public ParseError {
 public:
  SpecificationError(std::string_view token, std::size_t position, const std::string& expected)
      : ParseError("scheme specification", token, position, expected) {}
};

/// How the matrices of a vector of functions are given: those of the equation phi(x) = sum over k of A_k phi(Mx - k),
/// of a scheme f'_i = sum over j of P_{i-Mj} f_j, or of a Hermite scheme D^(n+1) f'_i = sum over j of P_{i-Mj} D^n f_j
/// on values and derivatives, D = diag(1, 1/a, 1/a^2, ...). Of both schemes phi_c is the limit of the first component
/// from the unit datum in component c, and A_k is P_k transposed.
enum class VectorForm { refinable, vector, hermite };

/// A linear scheme: its canonical specification, a name for people, its exact mask, and the local regressions that it
/// was made from. `mask` has one factor, curve(), for one variable, those of a tensor product, and no factors for
/// others.
struct Scheme {
  std::string specification;
  std::string title;
  LatticeMask mask;
  std::optional<LocalRegression> rules = std::nullopt;
  std::optional<MaskRounding> rounding = std::nullopt;  ///< where the coefficients that are meant are not rational
  std::optional<VectorForm> form = std::nullopt;        ///< of a mask of matrices, always
  /// What is meant where `mask` is one of matrices and rounded.
  std::optional<QuadraticMask> quadratic = std::nullopt;
  /// Of a mask of matrices: the integral of the functions that are meant, where the equation has several solutions.
  std::optional<std::vector<Rational>> integral = std::nullopt;
  /// What is meant where `mask` is one of numbers and rounded, and its field is known.
  std::optional<AlgebraicMask> algebraic = std::nullopt;
};

/// A data-dependent scheme of one to three variables. It has no mask and only acts on data.
struct DataDependentScheme {
  std::string specification;
  std::string title;
  L1Scheme rules;
  std::string choice = {};  ///< what was chosen by the program, for its user: the number of fits; else empty
};

/// A linear scheme of one variable with masks that change from level to level. It has no mask and, but for the values
/// of its limits, only acts on data.
struct LevelDependentScheme {
  std::string specification;  ///< for people: the masks, and how they follow each other
  LevelMasks masks;
  std::optional<VectorForm> form = std::nullopt;  ///< of masks of matrices, always: vector or hermite
};

/// The form of levels whose masks have the form of a scheme; of numbers none.
std::optional<VectorForm> form_of_levels(const std::optional<VectorForm>& form);

/// The schemes with the specifications of `first`, one for each level, and then those of `again` in turn. Domain: a
/// scheme in `again`. Errors: throws SpecificationError, and a domain error for other dilations, matrices of another
/// size or rounded ones, and Hermite schemes beside others.
LevelDependentScheme levels_in_turn(const std::vector<std::string>& first, const std::vector<std::string>& again);

/// The masks that come again, as one mask. Domain: one variable; masks that come again. Errors: throws a size error for
/// matrices of more than 4096 classes.
Scheme period_of(const LevelDependentScheme& scheme);

using AnyScheme = std::variant<Scheme, DataDependentScheme, LevelDependentScheme>;

/// Reads a specification of one variable and makes the mask. Domain: at most 30,000 characters. Errors: throws
/// SpecificationError for an unknown family or key, a missing or repeated key, a malformed value, a value outside its
/// range (sizes are bounded so that every accepted mask is made in seconds and megabytes), or coset sums other than 1.
Scheme make_scheme(std::string_view specification);

/// Reads a linear specification of one, two or three variables. Domain and errors: as make_scheme.
Scheme make_linear_scheme(std::string_view specification);

/// Reads any of these, or a specification of a vector of functions or a vector scheme. Domain and errors: as
/// make_scheme, of masks of matrices at most 20,000 numbers; nothing is asked of their sums.
Scheme make_refinable_scheme(std::string_view specification);

/// The scheme of a mask of matrices A_k with its canonical specification.
Scheme vector_scheme(VectorForm form, const std::string& title, const LatticeMask& mask);

/// Whether the text names the family l1.
bool is_l1_specification(std::string_view specification);

/// Reads `l1:points=P[xQ[xR]]` with the optional keys d (1), iterations (6), delta (1e-8, decimal or p/q), tolerance
/// (0, the same) and residuals (separate or joint). Domain: 2, ..., 64 points on curves, 2, ..., 16 along each axis of
/// a grid; d < points, at most 3; at most 10^6 iterations; delta from 1e-300 to 1e300. On curves, `exact` stands in the
/// place of iterations, delta, tolerance and residuals, and `iterations=auto[,remainder=1e-6]` is the fewest fits that
/// leave no more than this part of an outlier; the canonical form has their number. Errors: throws SpecificationError.
DataDependentScheme make_l1_scheme(std::string_view specification);

/// Reads any specification: make_l1_scheme or make_linear_scheme.
AnyScheme make_any_scheme(std::string_view specification);

/// The canonical specification.
const std::string& specification_of(const AnyScheme& scheme);

/// The mask, where it has factors to be applied along the axes: those of one variable and tensor products.
std::optional<LatticeMask> mask_with_factors(const AnyScheme& scheme);

/// One line of help for every family: those of one variable, which make_scheme accepts, those of several, and vectors.
struct FamilyHelp {
  std::string family;
  std::string usage;
  std::string meaning;
};
const std::vector<FamilyHelp>& families();
const std::vector<FamilyHelp>& multivariate_families();
const std::vector<FamilyHelp>& vector_families();

/// The coefficients as nested lists over their common denominator, the last variable outermost, and the first index of
/// each variable: `[[1,3],[3,1]]/8@-1,0`. Matrices are lists of rows in the place of numbers.
std::string to_mask_text(const LatticeMask& mask);
/// What it prints. Matrices run faster than the first variable.
text::MaskText mask_text_parts(const LatticeMask& mask);

}  // namespace subcert
