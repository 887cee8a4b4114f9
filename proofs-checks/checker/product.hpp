// Bounds of the joint spectral radius by products: sections 4.5 and 4.6 of ../certificates/SPEC.md.
#pragma once

#include "scheme.hpp"

namespace subcert_check {

/// A product of the matrices of these letters, and a number that is said to be near one of its eigenvalues.
struct GivenProduct {
  std::vector<std::size_t> letters;
  mpq_class re, im;
};

/// A lower bound of the spectral radius of the product; reads its lines `inverse` and `column`, if it has them. The
/// entries of the matrices are within `entry_error` of those that are meant.
mpq_class spectral_radius_bound(const Family& family, const GivenProduct& given, const mpq_class& entry_error,
                                Reader& reader, Arithmetic& arithmetic);

/// The largest sum of moduli in one of the first columns of all products of so many matrices.
mpq_class norm_of_products(const Family& family, std::size_t level, std::size_t columns, Arithmetic& arithmetic);

}  // namespace subcert_check
