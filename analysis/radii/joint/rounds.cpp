#include "rounds.hpp"

#include <subcert/analysis/radii/schedule.hpp>

#include <algorithm>

namespace subcert::radius {
namespace {

bool is_better(const JointSpectralRadius& first, const JointSpectralRadius& second) {
  const bool exact = first.exact.is_yes();
  if (exact != second.exact.is_yes()) return exact;
  return exact ? first.proved_upper() < second.proved_upper() : *first.radius.upper < *second.radius.upper;
}

/// Doubles misjudge products of large matrices with entries much larger than their eigenvalues, so that their letters
/// are proved before any search, which may take all of the time. Empty where that is no letter.
ProductEvidence largest_long_letter(const MatrixFamily& family, const Deadline& deadline) {
  const Deadline first = deadline.after(schedule::family::first_letter),
                 others = deadline.after(schedule::family::letters);
  ProductEvidence best;
  for (int letter = 0; letter < static_cast<int>(family.count()); ++letter) {
    const auto found = prove_long_product(family, {letter}, letter == 0 ? first : others);
    if (found && *found->radius.lower > *best.radius.lower) best = *found;
  }
  return best;
}

}  // namespace

void try_product(JointSpectralRadius& radius, ProductEvidence product, const Deadline& deadline) {
  if (radius.exact.is_yes() || *product.radius.lower <= *radius.radius.lower) return;
  if (auto* const blocks = std::get_if<BlockProof>(&radius.proof)) {
    blocks->try_product(product.word, deadline);
    product = blocks->blocks[blocks->leading].product;
    if (*product.radius.lower <= *radius.radius.lower) return;
  }
  radius.radius.lower = product.radius.lower;
  radius.product = std::move(product);
}

JointSpectralRadius better_of(JointSpectralRadius first, JointSpectralRadius second, const MatrixFamily& family,
                              const Deadline& deadline) {
  if (is_better(second, first)) std::swap(first, second);
  if (first.exact.is_yes() || *second.radius.lower <= *first.radius.lower) return first;
  if (second.by_blocks() && !first.by_blocks()) second.product = prove_product(family, second.product.word, deadline);
  try_product(first, std::move(second.product), deadline);
  return first;
}

std::vector<double> seconds_of_rounds(double seconds) {
  std::vector<double> rounds;
  do {
    double shorter = std::min(schedule::family::shorter_rounds * seconds, schedule::family::most_of_shorter_rounds);
    if (shorter < schedule::family::least_round) shorter = 0;
    rounds.push_back(seconds - shorter);
    seconds = shorter;
  } while (seconds > 0);
  return rounds;
}

JointSpectralRadius best_of_rounds(const MatrixFamily& family, const Budget& budget,
                                   const std::function<JointSpectralRadius(const Budget&)>& search) {
  // The grace that proofs of one round took is not the time of the next one.
  const Deadline end = budget.deadline.later(schedule::family::grace_of_rounds);
  ProductEvidence letter = largest_long_letter(family, budget.deadline);
  std::optional<JointSpectralRadius> best;
  for (const double seconds : seconds_of_rounds(budget.deadline.remaining())) {
    if (best && (best->exact.is_yes() || end.expired())) break;
    JointSpectralRadius found = search({end.at_most(seconds), budget.memory});
    best = best ? better_of(std::move(*best), std::move(found), family, end) : std::move(found);
  }
  try_product(*best, std::move(letter), end);
  return std::move(*best);
}

}  // namespace subcert::radius
