// Matrices over a quadratic field: section 5.13 of ../certificates/SPEC.md.
#pragma once

#include "surfaces/component.hpp"

#include <utility>

namespace subcert_check {

/// Square matrices with the entries p + sqrt(root) q. Vectors over the field are the p and then the q of all their
/// coordinates.
struct FieldFamily {
  Family rational, multiples;  // the p and the q, of one size, over one denominator
  mpz_class root;

  std::size_t size() const { return rational.size; }
  bool is_rational() const;
  /// Whether the last matrix is the first one with rows and columns reversed, and so on.
  bool is_mirrored() const;
  void transpose();
  /// [p, root q; q, p]: the rational matrices on vectors over the field.
  Family on_halves() const;
  /// `denominator` times the matrix times x.
  Vector image(std::size_t letter, const Vector& x, Arithmetic& arithmetic) const;
};

/// Rational matrices, and at least the distance of an entry of those that are meant.
struct NearFamily {
  Family family;
  mpq_class error;
};

/// The largest multiple of 2^-512 up to sqrt(root), times 2^512.
mpz_class scaled_root(const mpz_class& root);
constexpr std::size_t root_bits = 512;

/// With that number in place of the root; without error where all q are 0.
NearFamily near_family(const FieldFamily& family);

/// The p of all matrices, column by column, and then the q.
FieldFamily field_family(std::size_t size, const Rationals& values, const mpz_class& root);

/// Section 4.4 over the field, as read_blocks(). Reads the lines from `blocks` on.
std::pair<std::vector<FieldFamily>, std::size_t> read_field_blocks(const FieldFamily& family,
                                                                   const Component& component, Reader& reader,
                                                                   Arithmetic& arithmetic);

/// [[[a,b],[c,d]],...]/D@first with numbers c, sqrt(R), c*sqrt(R) and sums of such as entries: P + sqrt(R) Q.
struct FieldMask {
  Mask doubled;  // [P, R Q; Q, P]
  mpz_class root;
};
bool has_root(std::string_view text);
/// R of the first root in the text. Rejects unless it may be one.
mpz_class parse_root(std::string_view text);
/// The entries may have no other root; where they have none the q are 0.
FieldMask parse_field_mask(std::string_view text, const mpz_class& root);
/// p and q of sums of terms as in a mask, separated by commas: the p, and then the q.
Rationals parse_field_numbers(std::string_view text, const mpz_class& root);

}  // namespace subcert_check
