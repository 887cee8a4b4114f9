// What the program is asked to prove: sections 1 and 2 of ../certificates/SPEC.md, and the command line.
#pragma once

#include "exact_radius.hpp"
#include "least_absolute.hpp"
#include "levels.hpp"
#include "parameter.hpp"
#include "recurrence.hpp"
#include "surfaces/sector.hpp"
#include "surfaces/surface.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace subcert_check {

extern const char* const usage;

/// What is to be proved: about the exponent of a mask with an arity or a dilation, otherwise about the radius of a
/// family or its subradius. For a range of a parameter and vector schemes the inequalities are strict; `levels` is
/// about all sequences of its values, one for each level. Or that limits are not C^k for k = `rough`. Without any of
/// them: the shifts are stable. Or about fits of least absolute deviations: that differences contract, or that limits
/// have an exponent.
struct Claim {
  std::optional<Mask> mask;
  unsigned arity = 0;
  std::optional<Range> range;
  bool on_vectors = false;  // of matrices: about a scheme on vectors itself, sections 6.7 and 6.11
  bool hermite = false;     // of such: HC^k of a Hermite scheme, not the exponent of limits
  bool levels = false;
  bool each_point = false;               // of all choices of values, one for each new point of each level; not strict
  std::optional<Recurrence> recurrence;  // of these levels
  std::optional<MasksToLimit> limit;     // masks that tend to `mask`: of all of them, or of late ones
  std::optional<MaskList> list;          // one mask for each level; in a period they are `mask`, with its arity; of
                                         // matrices `mask` is masks_as_powers
  std::optional<Rounding> rounding;
  std::optional<Dilation> dilation;
  std::optional<SectorRules> vertex;     // of numbers with a dilation: limits are C^1 there as well
  bool not_c1 = false;                   // or they are not, there
  std::optional<Rationals> integral;     // of matrices: of the only functions that have it
  std::optional<std::size_t> component;  // of matrices: of one function alone
  mpz_class root = 0;                    // of matrices: R where they hold sqrt(R), and `mask` is the doubled one
  Family family;
  bool subradius = false;
  std::optional<mpq_class> lower, upper;
  std::optional<std::size_t> rough;
  std::optional<ExactRadius> exact;  // of the radius; of an exponent: exact_order less its logarithm
  std::size_t exact_order = 0;
  std::string exact_text;  // with --attains the letters
  std::optional<std::size_t> logarithm;
  std::optional<L1Rule> l1;
  std::optional<Contraction> contraction;
  std::string head, text, subject, file;  // its line in a certificate; what to print; of what; the certificate

  /// Of matrices: as many as they have rows.
  std::size_t functions() const { return mask->components / (root == 0 ? 1 : 2); }
  /// Of each value of a range by itself.
  bool is_of_values() const { return range && !each_point; }
  /// Of all sequences of a list of masks of matrices exponents are at least the lower end.
  bool is_strict() const { return is_of_values() || (on_vectors && (!list || hermite)); }
  /// Of masks of numbers, for all that may be chosen at each level, or for each new point.
  bool is_of_choices() const { return each_point || (list && list->period.empty() && !on_vectors); }
};

/// |ROOT|^1/L, or M-log|ROOT|^1/L for an exponent; the radius and M.
std::pair<ExactRadius, std::size_t> parse_exact(std::string_view text, bool exponent);

/// What the arguments ask, the matrices read from their file. Rejects wrong ones with exit code 64, matrices with 65.
Claim read_claim(const std::vector<std::string>& arguments);

}  // namespace subcert_check
