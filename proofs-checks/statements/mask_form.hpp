#pragma once
/// Printed masks, symbols and rows of tables against derived ones.

#include "identities.hpp"

#include <subcert/analysis/symbol/masks/mask.hpp>

namespace subcert::statements {

/// The part sum of coefficient z^exponent(index) over index = first(n), ..., last(n) of a symbol.
struct SymbolPart {
  Formula coefficient;
  std::string index;
  Line first;
  Line last;
  Line exponent;
};

LaurentPolynomial assembled(const std::vector<SymbolPart>& parts, long n);

/// The assembled symbols against derived ones for n = first_n, ..., last_n.
Trial symbol_family(const std::vector<SymbolPart>& parts, const std::function<LaurentPolynomial(long)>& derived,
                    long first_n, long last_n);

/// A printed list of coefficients against a derived mask, in order. The paper prints no indices with it.
Trial mask_list(const std::vector<Formula>& printed, const Mask& derived, const std::string& name);

/// Printed decimals against certified enclosures, cell by cell: a failure names all cells that cannot be right. A cell
/// that the enclosure does not decide fails too.
Trial table_row(const std::vector<std::string>& printed, const std::vector<std::string>& labels,
                const std::function<Enclosure(std::size_t)>& certified);

/// Whether the closed support of the basic limit function of the masks is [lower(n), upper(n)].
Trial limit_supports(const Formula& lower, const Formula& upper, const std::function<Mask(long)>& mask, long first_n,
                     long last_n);

}  // namespace subcert::statements
