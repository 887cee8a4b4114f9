// Schemes and refinable functions of one, two and three variables: section 5 of ../certificates/SPEC.md.
#pragma once

#include "component.hpp"
#include "dilation.hpp"
#include "field.hpp"

#include <functional>
#include <optional>

namespace subcert_check {

struct SurfaceFamily {
  Family family;
  /// Where the differences are those of phi: reads the lines of a space of differences of the scheme, section 5.6, and
  /// returns the matrices there. The scheme converges if their radius is below 1.
  std::function<Family()> of_scheme;
  /// Of matrices: the rest of what is said of one component, from the line `unobservable` on.
  std::function<Component(std::size_t)> of_component;
  /// Of matrices with a square root: those over the field, of which `family` has the rational ones on halves.
  std::optional<FieldFamily> over_field = {};
};

/// Of f'_i = sum over j of A_(i-aj)^T f_j, section 6.7, arity^order times the transition matrices of all powers of the
/// parameter, one after another for each digit, on the space of the certificate; reads its lines from `data` on, of a
/// Hermite scheme from `digits` on. With a root, that is not 0, those over the field, of the doubled mask.
SurfaceFamily read_vector_scheme(const Mask& mask, const mpz_class& root, unsigned arity, std::size_t order,
                                 bool hermite, Reader& reader, Arithmetic& arithmetic);

/// Section 6.11: of a scheme with any isotropic dilation those on the space of what annihilates the constant data that
/// it keeps; reads the lines from `digits` on. Without a matrix where it keeps none.
SurfaceFamily read_vector_scheme(const Mask& mask, const mpz_class& root, const Dilation& dilation, Reader& reader,
                                 Arithmetic& arithmetic);

/// The transition matrices on the space of the certificate; reads its lines from `digits` on. The differences have this
/// order; they are those of the scheme, or with `of_values` those of phi, as they always are for a mask of matrices.
/// With `upper` the radius is shown to tell the exponent from above as well, provided that it tells it from below: the
/// shifts are stable, or the differences of phi span the space. `integral`: that of the phi that is meant, of a mask of
/// matrices. The result uses the reader and the arithmetic.
SurfaceFamily read_surface(const Mask& mask, const Dilation& dilation, std::size_t order, bool of_values, bool upper,
                           const std::optional<Rationals>& integral, Reader& reader, Arithmetic& arithmetic);

/// The same of matrices with a square root, section 5.13.
SurfaceFamily read_vector_over_field(const Mask& doubled, const mpz_class& root, const Dilation& dilation,
                                     std::size_t order, bool upper, const std::optional<Rationals>& integral,
                                     Reader& reader, Arithmetic& arithmetic);

}  // namespace subcert_check
