#pragma once
/// Whether reweighted fits, with any delta and several numbers of fits, shrink second differences of all data.

#include <subcert/analysis/symbol/numbers/numbers.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace subcert::data {

/// |D^2 S f| <= bound |D^2 f| for all data, every delta > 0 and every number of fits up to `fits`, also another one for
/// each window; so all limits exist and are as smooth as by least squares (docs/l1.md, Theorem 7).
struct ReweightedContraction {
  int fits;
  Rational bound;       ///< below 1
  std::uint64_t boxes;  ///< of data of one window
};

struct Ends {
  double lower = 0, upper = 0;
};

/// The second differences of points + 1 data, and the root of delta.
struct DifferenceBox {
  std::vector<Ends> differences;
  Ends root;
};

/// Contains both second differences of the four outputs of the two windows of such data, for all data and delta of the
/// box and up to so many fits in each window. Domain: 3 <= points <= 8, points - 1 differences with ends in [-1, 1];
/// 0 <= lower <= upper of the root; fits >= 0. Errors: throws a domain error. Cost: as reweighted_contraction, of a
/// box.
std::array<Ends, 2> second_differences(int points, int fits, const DifferenceBox& box);

struct ReweightedOptions {
  Rational bound = Rational(19, 20);  ///< not less than that of l1_basin
  std::uint64_t most_boxes = 200'000;
  Deadline deadline = {};
};

/// Of lines on `points` data, binary. Nothing where it is not proved: the boxes or the time did not suffice, or it is
/// not so. Domain: 3 <= points <= 8, 0 <= fits <= 40, 0 < bound < 1. Errors: throws a domain error. Error: none; double
/// precision with bounds of all rounding errors. Cost: fits * points * 2^points * binom(points, 2) operations a box,
/// some microseconds for 6 points and 6 fits; some thousand boxes for 4 points, ten thousand for 5, and 0.05, 0.12,
/// 0.26 and 2.6 million for 6 points and 1, 2, 3 and 6 fits.
std::optional<ReweightedContraction> reweighted_contraction(int points, int fits,
                                                            const ReweightedOptions& options = {});

}  // namespace subcert::data
