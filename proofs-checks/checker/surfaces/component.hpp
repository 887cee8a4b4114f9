// One component of a vector of functions: section 5.9 of ../certificates/SPEC.md.
#pragma once

#include "scheme.hpp"

namespace subcert_check {

/// What of a space the component does not show.
struct Component {
  std::vector<Vector> readings;  // functionals on the space: the values at each point of what its vectors have there
  std::size_t unobservable = 0;  // the dimension of an invariant subspace on which they are 0
  std::size_t degree = 1;        // of the field, over which that is the dimension; the readings are over the rationals
};

/// Rejects unless the first `unobservable` columns of the basis, of vectors of this size, are 0 under the readings.
void check_unobservable(const Component& component, const Vector& basis, std::size_t size, Arithmetic& arithmetic);

/// Rejects unless no larger invariant subspace is 0 under the readings: modulo the prime the transposed matrices lead
/// them to as many independent functionals as there are dimensions beside it.
void check_observable(const Component& component, const Family& family, Arithmetic& arithmetic);

}  // namespace subcert_check
