#pragma once
/// Refinement of more data than memory holds.

#include "axis_refinement.hpp"
#include "refine.hpp"

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace subcert::data {

/// Numbers that a refinement may give piece by piece.
constexpr double most_streamed_numbers = 1e9;

/// Appends the slices begin, ..., end - 1 across the last axis. Domain: 0 <= begin < end <= count of that axis.
using SliceSource = std::function<void(std::size_t begin, std::size_t end, std::vector<double>& values)>;

/// Numbers of a slice of points with so many coordinates.
std::size_t numbers_of_slice(const std::vector<Axis>& axes, std::size_t dimension);

/// A step of a refinement that makes slices across the last axis from some of its input.
class SliceStep {
 public:
  virtual ~SliceStep() = default;
  const std::vector<Axis>& output() const { return output_; }
  /// Appends slices of the output; `source` gives those of the input.
  virtual void append(std::size_t begin, std::size_t end, const SliceSource& source,
                      std::vector<double>& values) const = 0;

 protected:
  explicit SliceStep(std::vector<Axis> output) : output_(std::move(output)) {}

 private:
  std::vector<Axis> output_;
};
using SliceSteps = std::vector<std::unique_ptr<SliceStep>>;

/// Some slices, one after another in memory.
class SliceBuffer {
 public:
  /// `numbers`: of the slices that are wanted, in any order, also several times.
  SliceBuffer(const std::vector<std::size_t>& numbers, const SliceSource& source);
  const std::vector<double>& values() const { return values_; }
  /// The place of a slice that was wanted.
  std::size_t place(std::size_t number) const;

 private:
  struct Run {
    std::size_t begin, end, place;
  };
  std::vector<Run> runs_;
  std::vector<double> values_;
};

/// The steps of refine() and of limit_of_data() by a mask, also with nearest and constant: then those of data that go
/// on without an end. Domain and errors: as these, with most_streamed_numbers.
SliceSteps refinement_steps(const std::vector<Axis>& axes, std::size_t dimension, const LatticeMask& mask,
                            const RefineOptions& options);
SliceSteps refinement_steps(const std::vector<Axis>& axes, std::size_t dimension, const LevelMasks& masks,
                            const RefineOptions& options);
SliceSteps limit_steps(const std::vector<Axis>& axes, std::size_t dimension, const LatticeMask& mask,
                       const RefineOptions& options);

/// Steps one after another by slabs across the last axis: the numbers of the whole refinement, to the last bit, but of
/// each step only the slices are held that the slab depends on. Memory: with levels it grows as a slice, and not at all
/// for curves.
class SlabRefinement {
 public:
  SlabRefinement(std::vector<Axis> axes, std::size_t dimension, SliceSource data, SliceSteps steps);
  /// Of data that outlive this.
  SlabRefinement(const GridData<double>& data, SliceSteps steps);

  /// Of the result.
  const std::vector<Axis>& axes() const { return steps_.empty() ? axes_ : steps_.back()->output(); }

  /// All points at once.
  GridData<double> whole() const;

  /// Gives the points in their order, whole slices at a time. Cost: that of the whole refinement, and up to twice as
  /// much where slices are large.
  void run(const std::function<void(const double* values, std::size_t points)>& take) const;

 private:
  void append(std::size_t step, std::size_t begin, std::size_t end, std::vector<double>& values) const;

  std::vector<Axis> axes_;
  std::size_t dimension_;
  SliceSource data_;
  SliceSteps steps_;
};

}  // namespace subcert::data
