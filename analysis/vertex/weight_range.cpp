#include "weight_range.hpp"

#include "weight_proof.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert {
namespace {

using vertex::WeightBox;
using vertex::WeightProof;

const Rational coarsest = Rational(1) / 1000;  // share of the range, of what no eigenvalue decides

void add(std::vector<WeightPiece>& pieces, const WeightPiece& piece) {
  if (!pieces.empty() && pieces.back().holds.truth == piece.holds.truth &&
      pieces.back().holds.reason == piece.holds.reason)
    pieces.back().high = piece.high;
  else
    pieces.push_back(piece);
}

}  // namespace

WeightRange weight_range(const SectorRules& rules, const RegularPart& regular, WeightProperty property,
                         const Rational& low, const Rational& high, const Rational& width, int jobs,
                         const Budget& budget) {
  require(low < high && width > 0, "range of a weight: need low < high and width > 0");
  const WeightProof proof(rules, regular, property, 1);
  WeightRange result{rules.valence, {}, {}};
  const Rational coarse = std::max((high - low) * coarsest, width);
  std::vector<WeightBox> boxes = decide_boxes(
      proof, {{low}, {high}}, jobs, budget, [&](const Box& box, WeightProof::Help help) {
        return box.width() <= (help == WeightProof::Help::fine ? width : coarse);
      });
  std::ranges::sort(boxes, {}, [](const WeightBox& one) { return one.box.low; });
  for (const WeightBox& one : boxes) add(result.pieces, {one.box.low[0], one.box.high[0], one.holds});
  for (std::size_t i = 1; i + 1 < result.pieces.size(); ++i) {
    const WeightPiece &before = result.pieces[i - 1], &piece = result.pieces[i], &after = result.pieces[i + 1];
    const bool changes = before.holds.truth != after.holds.truth && before.holds.truth != Truth::unknown &&
                         after.holds.truth != Truth::unknown;
    if (piece.holds.truth != Truth::unknown || !changes) continue;
    if (auto end = proof.end_in(piece.low, piece.high)) result.ends.push_back(std::move(*end));
  }
  return result;
}

}  // namespace subcert
