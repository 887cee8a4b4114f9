#pragma once
/// Refinement of more data than memory holds.

#include "axis_refinement.hpp"
#include "refine.hpp"

#include <functional>
#include <vector>

namespace subcert::data {

/// Numbers that a refinement may give piece by piece.
constexpr double most_streamed_numbers = 1e9;

/// refine() of a mask with factors, by slabs across the last axis: the same numbers, to the last bit, but of each level
/// only the slices are held that the slab depends on. Memory: with levels it grows as a slice, and not at all for
/// curves.
class SlabRefinement {
 public:
  /// `data` must outlive this. Domain and errors: as refine(), with most_streamed_numbers, and for a mask with factors.
  SlabRefinement(const GridData<double>& data, const LatticeMask& mask, const RefineOptions& options);

  /// Of the result.
  const std::vector<Axis>& axes() const { return levels_.empty() ? data_.axes : levels_.back().axes; }

  /// Gives the points in their order, whole slices at a time. Cost: that of refine(), and up to twice as much where
  /// slices are large.
  void run(const std::function<void(const double* values, std::size_t points)>& take) const;

 private:
  struct Level {
    std::vector<AxisRefinement<double>> steps;  // one for each axis
    std::vector<Axis> axes;
  };

  const std::vector<Axis>& axes(std::size_t level) const { return level == 0 ? data_.axes : levels_[level - 1].axes; }
  /// Numbers of a slice.
  std::size_t slice(std::size_t level) const;
  /// Appends the slices begin, ..., end - 1; along a closed axis they go round.
  void append(std::size_t level, long begin, long end, std::vector<double>& values) const;
  /// The same within 0 <= begin < end <= count.
  void append_made(std::size_t level, std::size_t begin, std::size_t end, std::vector<double>& values) const;

  const GridData<double>& data_;
  int threads_;
  std::vector<Level> levels_;
};

}  // namespace subcert::data
