#pragma once
/// What certificates claim, and how the independent checkers are asked about it.

#include <subcert/analysis/symbol/numbers/rational.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace subcert {

/// What a claim is about, in the texts of SPEC.md, section 1. Canonical: none of them has blanks.
struct MaskSubject {
  std::string mask, arity;
  std::string range = {};   ///< w=LOW..HIGH, or empty
  bool is_levels = false;   ///< with a range: of all sequences of its values, one for each level
  std::string within = {};  ///< EPS,M[,symmetric] of a mask with rounded coefficients, or empty; not with a range
  /// Of masks of matrices: `vectors`, of the limits of f'_i = sum over j of A_(i-aj)^T f_j, or `hermite`,
  /// of HC^k of a Hermite scheme, of which k is the lower end, or the upper one where it is refuted; or empty.
  std::string of_matrices = {};
  std::string recurrence = {};        ///< of levels that follow from each other, STEP; or empty
  std::string start = {}, from = {};  ///< the values at level 0, and the level from which on the claim is
  std::string limit = {};             ///< of these, the value to which they tend; then ends are `<=`; or empty
  bool is_each_point = false;  ///< with a range: of all choices of its values, one for each new point of each level
};
/// A mask for each level.
struct ListSubject {
  std::string masks, arity;      ///< MASK;MASK;...
  std::string order;             ///< `any`, `follows=0-1,1-0,...` or `period=0,1,...`
  std::string of_matrices = {};  ///< as above
};
struct SurfaceSubject {
  std::string mask, dilation;
  bool is_refinable = false;   ///< a vector of functions, given by its refinement equation
  std::string component = {};  ///< the number, from 0, of the one that is meant, or empty
  std::string integral = {};   ///< X0,X1,..., that of the only functions that have it, or empty
  std::string vertex = {};     ///< LATTICE:N;..., rules around a vertex where limits are C^1, or empty
  bool is_c1 = true;           ///< with these: or they are not
};
struct FamilySubject {
  bool is_subradius = false;
  std::string count, size;                   ///< empty where the claim is stated about a file
  std::optional<std::string> matrices = {};  ///< the file of the matrices, where it is not beside the certificate
};
/// Fits of least absolute deviations.
struct L1Subject {
  std::string points, degree;
  std::string arity = {};        ///< empty for 2
  std::string contraction = {};  ///< STEPS,ORDER,BOUND, or empty; not empty in a certificate
};
using ClaimSubject = std::variant<MaskSubject, SurfaceSubject, FamilySubject, L1Subject, ListSubject>;

/// Decimals with 15 places, more for tiny numbers, rounded outward; an upper end `C2` says that limits are not C^2.
struct ClaimedEnds {
  std::optional<std::string> lower = {}, upper = {};

  bool says_rough() const { return upper && upper->starts_with('C'); }
};

/// What a certificate proves, as the checker is to be asked.
struct CertificateClaim : ClaimedEnds {
  ClaimSubject subject = {};
  /// What the radius or the exponent is: `2-log|[-4,1]@4,0,1/1000|^1/1`, see SPEC.md, section 4.10.
  std::optional<std::string> exact = {};
  /// Of rounded coefficients: the letters of the product whose spectral radius the exponent is from, `1,1,0,0`.
  std::optional<std::string> attains = {};
  /// Beside an exact exponent, or such letters: the power of |log h| in the modulus of continuity, see section 4.12.
  std::optional<int> logarithm = {};
};

/// A power of a logarithm, or the number of a component; nothing for another text.
std::optional<int> whole_number(std::string_view text);

/// As SurfaceSubject::integral. `root`: where it is not 0 the multiples of 1, and then as many of its square root.
std::string integral_text(const std::optional<std::vector<Rational>>& numbers, long root = 0);

/// The first lines of a certificate, up to what the number is, or the contraction.
std::string head_text(const CertificateClaim& claim);

/// What the text of a certificate says it proves. `file`: the name by which errors call it. Errors: throws a data error
/// for a text that is no certificate. Cost: the first four lines are read, and the power of a logarithm is looked for.
CertificateClaim read_claim(const std::string& text, const std::string& file);

/// The command line of a checker, without its name, that asks whether the file proves the claim. The matrices of a
/// family are in FILE.matrices where the claim does not name them.
std::vector<std::string> checker_arguments(const CertificateClaim& claim, const std::string& file);

}  // namespace subcert
