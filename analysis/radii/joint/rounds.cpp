#include "rounds.hpp"

#include <subcert/analysis/radii/schedule.hpp>

#include <algorithm>

namespace subcert::radius {
namespace {

namespace shares = schedule::family;

bool is_better(const JointSpectralRadius& first, const JointSpectralRadius& second) {
  const bool exact = first.exact.is_yes();
  if (exact != second.exact.is_yes()) return exact;
  return exact ? first.proved_upper() < second.proved_upper() : *first.radius.upper < *second.radius.upper;
}

}  // namespace

JointSpectralRadius better_of(JointSpectralRadius first, JointSpectralRadius second, const MatrixFamily& family,
                              const Deadline& deadline) {
  if (is_better(second, first)) std::swap(first, second);
  if (first.exact.is_yes() || *second.radius.lower <= *first.radius.lower) return first;
  ProductEvidence& product = second.product;
  if (auto* const proof = std::get_if<BlockProof>(&first.proof)) {
    // It is one of the leading block.
    proof->try_product(product.word, deadline);
    product = proof->blocks[proof->leading].product;
  } else if (second.by_blocks()) {
    product = prove_product(family, product.word, deadline);
  }
  if (*product.radius.lower <= *first.radius.lower) return first;
  first.radius.lower = product.radius.lower;
  first.product = std::move(product);
  return first;
}

std::vector<double> seconds_of_rounds(double seconds) {
  std::vector<double> rounds;
  do {
    double shorter = std::min(shares::shorter_rounds * seconds, shares::most_of_shorter_rounds);
    if (shorter < shares::least_round) shorter = 0;
    rounds.push_back(seconds - shorter);
    seconds = shorter;
  } while (seconds > 0);
  return rounds;
}

JointSpectralRadius best_of_rounds(const MatrixFamily& family, const Budget& budget,
                                   const std::function<JointSpectralRadius(const Budget&)>& search) {
  // The grace that proofs of one round took is not the time of the next one.
  const Deadline end = budget.deadline.later(shares::grace_of_rounds);
  std::optional<JointSpectralRadius> best;
  for (const double seconds : seconds_of_rounds(budget.deadline.remaining())) {
    if (best && (best->exact.is_yes() || end.expired())) break;
    JointSpectralRadius found = search({end.at_most(seconds), budget.memory});
    best = best ? better_of(std::move(*best), std::move(found), family, end) : std::move(found);
  }
  return std::move(*best);
}

}  // namespace subcert::radius
