#pragma once
/// Smoothing of data that arrive one after another, in memory that does not grow with their number.

#include "smooth.hpp"

#include <memory>
#include <vector>

namespace subcert::data {

/// The values that smooth() would give for all data together, the same bits, as soon as no datum that is still to come
/// can change them.
class SmoothingStream {
 public:
  /// Domain: a linear method, complete; uniform positions with origin and spacing of `head`, which has no data yet but
  /// its columns, and the noise, if known: it is not estimated. `weighted`: data come with prior weights, 0 for missing
  /// ones. Errors: throws a domain error that says which of these fails, for Boundary::periodic, and for weights with
  /// local polynomials of so many points, whose windows have no bound; else as smooth().
  SmoothingStream(Samples head, SmoothingMethod method, const SmoothingOptions& options, bool weighted);

  /// columns[c][i] follows what was added to column c; as many weights as data, or none. Cost: linear.
  void add(const std::vector<std::vector<double>>& columns, const std::vector<Rational>& weights = {});
  /// The values that are certain and were not taken yet. Errors: as smooth(). Cost: that of smooth() for these, and for
  /// the window of one more.
  SmoothedSamples take();
  /// All that are left; no more data come. Domain: one datum or more.
  SmoothedSamples finish();

 private:
  std::unique_ptr<LinearSmoother> smoother(std::size_t count) const;
  SmoothedSamples values(std::size_t end, const LinearSmoother& smoother);
  bool knows_left_end() const;
  void forget();

  Samples kept_;  // the data from first_ on
  SmoothingMethod method_;
  SmoothingOptions options_;
  bool weighted_;
  std::shared_ptr<const SmoothingKernel> kernel_;  // of a scheme
  std::size_t end_window_ = 1;                     // data that are not missing on which the values at an end depend
  std::size_t before_ = 0;                         // data from a spacing to the first and last of those
  std::size_t after_ = 1;                          // that its values combine, away from the ends
  std::size_t first_ = 0;
  std::size_t taken_ = 0;  // spacings whose values were taken
};

}  // namespace subcert::data
