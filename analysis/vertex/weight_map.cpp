#include "weight_map.hpp"

#include "weight_proof.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

namespace subcert {

CellMap weight_map(const SectorRules& rules, const RegularPart& regular, WeightProperty property, const Box& box,
                   const MapOptions& options) {
  require_map(box, options);
  const vertex::WeightProof proof(rules, regular, property, box.letters());
  CellMap result;
  for (vertex::WeightBox& one :
       decide_boxes(proof, box, options.jobs, options.budget, [&](const Box&cell, vertex::WeightProof::Help) {
         return cell.width() * options.resolution <= box.width();
       })) {
    result.complete = result.complete && one.is_last;
    const bool is_open = one.holds.truth == Truth::unknown;
    result.cells.push_back({std::move(one.box), one.holds.truth, is_open ? one.holds.reason : ""});
  }
  return result;
}

}  // namespace subcert
