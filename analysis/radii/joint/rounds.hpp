#pragma once
/// Searches with less time after one that left something open, so that more time is never worse. Inner header.

#include "joint_spectral_radius.hpp"

#include <functional>

namespace subcert::radius {

/// Raises the lower end where this product has a larger radius than the one found, and nothing is exact. By blocks it
/// is tried in each, in time.
void try_product(JointSpectralRadius& radius, ProductEvidence product, const Deadline& deadline);

/// What two searches prove of one family: the larger product of both, and the proof that a product attains the radius,
/// or else that of the smaller bound. Cost: a characteristic polynomial for each block, where one is by blocks.
JointSpectralRadius better_of(JointSpectralRadius first, JointSpectralRadius second, const MatrixFamily& family,
                              const Deadline& deadline);

/// How many seconds each search has, the longest first. Those of a third of the budget are the last ones, as long as
/// that third is not more than `most_of_shorter_rounds`. Domain: seconds >= 0, infinite perhaps; there is one at least.
std::vector<double> seconds_of_rounds(double seconds);

/// The best of what the rounds find, up to one that is exact. Steps share the time of a search, so one that comes to
/// its end in a short search may be cut in a longer one: a third of the budget (or, with much time, those seconds)
/// repeats what a search with so much time alone would do, and so the enclosure is not wider than that, but for the
/// accuracy of the clock, and for proofs that take more than a grace after the time. Cost: at most the budget and that
/// grace; the first round where that is exact.
JointSpectralRadius best_of_rounds(const MatrixFamily& family, const Budget& budget,
                                   const std::function<JointSpectralRadius(const Budget&)>& search);

}  // namespace subcert::radius
