#pragma once
/// Local regression where the flat fan is not whole: at boundaries, and where triangles beyond an edge are missing.

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <string_view>
#include <vector>

namespace subcert {

/// What an edge of a triangle mesh sees from one of its ends, which lies at 0: neighbours w^first, ..., w^last, w =
/// exp(2 pi i / turn), of which w^0 = 1 is the other end, and of the third corners of the triangles beyond it those at
/// 1 + w, 2 and 1 + 1/w that are there.
struct MeshFan {
  long turn;
  long first, last;
  bool left = false, straight = false, right = false;

  auto operator<=>(const MeshFan&) const = default;
};

/// The weights of the data in that order, the end first, of the fit of `triangular:` at the middle of the edge, or at
/// the end: as vertex_rules() has them where the fan is whole. Where the data do not determine the value of a fit, that
/// of the next lower degree is taken. Domain: a scheme with rules at vertices; 3 <= turn <= 2000, first <= 0 <= last,
/// no neighbour twice. Error: a relative width of about 2^-64. Errors: throws Error. Cost: linear in the neighbours.
std::vector<Enclosure> fan_weights(std::string_view specification, const MeshFan& fan, bool at_middle);

}  // namespace subcert
