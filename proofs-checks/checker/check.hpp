// subcert-check: proves a claim about a mask or about a family of matrices from a certificate
// (../certificates/SPEC.md).
#pragma once

#include <gmpxx.h>

#include <istream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace subcert_check {

/// The certificate does not prove the claim. Never means that the claim is false.
struct Rejected : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A mask: coefficient i of `coefficients` has index first + i. Canonical: first and last coefficients are not zero.
struct Mask {
  std::vector<mpq_class> coefficients;
  long first = 0;
  bool operator==(const Mask&) const = default;
};

/// Square matrices of one size, entries[t][j * size + k] / denominator. Canonical: denominator > 0.
struct Family {
  std::size_t size = 0;
  mpz_class denominator = 1;
  std::vector<std::vector<mpz_class>> entries;
};

/// What is to be proved: about the exponent of a mask if `arity` is not 0, otherwise about the radius of a family.
struct Claim {
  unsigned arity = 0;
  Mask mask;
  Family family;
  std::string subject;  ///< the name of the mask or of the matrices, as the user gave it
  std::optional<mpq_class> lower, upper;

  std::string text() const;
};

/// Readers of the command line's values; they throw Rejected with the reason.
Mask parse_mask(std::string_view text);
mpq_class parse_rational(std::string_view text);
Family read_matrices(std::istream& input);

/// Returns if the certificate proves the claim, throws Rejected otherwise. Cost: bounded multiples of the input's size.
void check(const Claim& claim, std::istream& certificate);

}  // namespace subcert_check
