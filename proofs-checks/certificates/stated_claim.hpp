#pragma once
/// Claims in words, and what certificates say of them that prove more or less.

#include "claim.hpp"

#include <subcert/analysis/family/recurrence.hpp>
#include <subcert/analysis/symbol/numbers/numbers.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <functional>
#include <optional>
#include <string>

namespace subcert {

/// A claim in words. Certificates about ranges and about vector schemes prove their ends with `<`, others with `<=`.
struct StatedClaim {
  CertificateClaim claim;
  bool lower_strict = false, upper_strict = false;  ///< `<` where certificates have `<=`
  std::optional<ParameterRange> values = {};        ///< of a parameter; low = high for a single value
  std::optional<FirstValues> start = {};            ///< where they follow from each other

  /// Whether a checker can be asked for it as it stands: without a sign `<` of its own, not about a single value of a
  /// parameter or values that follow from each other, and not of an upper end alone where claims about ranges, radii or
  /// C^k are not meant.
  bool is_plain() const;
};

using ReadList = std::function<ListSubject(const std::string& file)>;

/// Reads `[LOWER <=] SUBJECT [= EXACT [with |log h|^P]] [<= UPPER]`, with `<` in the place of `<=`, or all of it from
/// the right with `>=` and `>`. EXACT is a number as in SPEC.md, section 1. SUBJECT is
/// - a scheme, or a vector of functions, or `component K of` it with K = 1, 2, ..., whose exponent is meant; `scheme
/// of`
///   a vector scheme, whose limits are meant (LOWER is below their exponents, UPPER 0 says that it does not converge),
///   or `HC of` a Hermite scheme (the ends are k, of HC^k and of what is refuted);
/// - a family with a parameter, as `four-point:w for w=1/100..19/100`, or `for 1/100 <= w <= 19/100`, `for all w=...`,
///   `for w=1/16`, before or behind the upper end; `HC of` before it says that an end is the k of HC^k, `for all levels
///   w=LOW..HIGH` that each level has a value of its own, `, w=STEP, w0=FIRST..LAST` behind it that these follow from
///   each other by a recurrence for all these first values (LAST may be inf), and come into the range, `, limit VALUE`
///   behind that again that they tend to it (then an upper end is that of late levels, and <= is meant);
/// - `lists:FILE`, all sequences of the masks in that file;
/// - `radius FILE` or `subradius FILE`, of the matrices in that file;
/// - `l1:points=6,d=1`, of whose limits LOWER and UPPER are ends, or `contraction STEPS,ORDER of` it, with UPPER alone.
/// LOWER and UPPER are exact numbers, UPPER also `C2`, for limits that are not C^2; without both the integer shifts are
/// stable. Errors: throws a usage error for another text, and for a scheme with rounded coefficients, of which a claim
/// needs the distance.
/// `read_list` gives the masks of a file; without it there are no lists.
StatedClaim stated_claim(const std::string& words, const ReadList& read_list = {});

/// The same about a letter of the certificate's, where both are about families: letters are names.
StatedClaim with_letter_of(const CertificateClaim& proved, StatedClaim stated);

/// What the certificate says of itself, said of the subject of the stated claim, and on the certificate's own range:
/// where a checker proves this, the two claims are about one subject.
CertificateClaim about_subject_of(const StatedClaim& stated, const CertificateClaim& proved);

/// What a proved claim says of another one about the same subject: yes where it follows, no where it is false.
Truth follows(const StatedClaim& stated, const CertificateClaim& proved);

}  // namespace subcert
