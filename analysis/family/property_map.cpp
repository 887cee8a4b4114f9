#include "property_map.hpp"

#include "box_search.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

namespace subcert {
namespace {

constexpr double cell_seconds = 1;  // for one upper bound

}  // namespace

PropertyMap property_map(const ParametricMask& mask, const RangeProperty& property, const Box& box,
                         const MapOptions& options) {
  require(mask.letters() >= 2 && box.letters() == mask.letters(),
          "map: need a mask with two or more letters and a range for each, got {} letters and {} ranges",
          mask.letters(), box.letters());
  family::require_box("map", mask, box);
  require_map(box, options);
  PropertyMap result;
  result.sum_rules = sum_rules(mask);
  family::require_property("map", mask, property, result.sum_rules);
  using Kind = RangeProperty::Kind;
  require(property.kind != Kind::sobolev && property.kind != Kind::stable && property.kind != Kind::preserving &&
              property.order < result.sum_rules,
          "map: need 'convergent', or an order below the number {} of sum rules that hold for all values",
          result.sum_rules);
  const auto is_smallest = [&](const Box& cell) { return cell.width() * options.resolution <= box.width(); };
  family::BoxSearch search(mask, property, box, options.budget);
  search.run({options.jobs,
              {},
              [](const Box&) { return cell_seconds; },
              [&](const Box& cell, double) { return is_smallest(cell); }},
             [&](family::BoxProof proof) {
               result.cells.push_back({proof.box, proof.holds(), std::move(proof.reason)});
               result.complete = result.complete && (proof.holds() != Truth::unknown || is_smallest(proof.box));
             });
  return result;
}

}  // namespace subcert
