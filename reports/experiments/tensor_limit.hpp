#pragma once
/// Limits of tensor product schemes on grids of points in space.

#include "measures.hpp"

namespace subcert::experiments {

/// columns x rows points: coordinate[j * columns + i].
struct PointGrid {
  std::size_t columns;
  std::size_t rows;
  std::array<Coordinate, 3> points;

  /// As a picture.
  formats::DrawnSurface drawn(const std::string& title, bool closed) const;
};

/// One scheme in both directions of a grid, its limit at the multiples of 2^-level.
class TensorLimit {
 public:
  TensorLimit(const std::string& specification, std::size_t columns, std::size_t rows, data::Boundary extension,
              int level);
  PointGrid operator()(const PointGrid& grid) const;

 private:
  DenseMatrix along_columns_;
  DenseMatrix along_rows_;
};

/// A surface with what its limits are compared with.
struct SurfaceTrial {
  std::string id;  ///< of the figure of the limits
  std::string title;
  PointGrid samples;
  PointGrid truth;  ///< at the outputs
  bool closed;      ///< in both directions
  int level;        ///< the outputs stand at the multiples of 2^-level
  TwoLevels decibels;
  std::vector<std::string> schemes;
};

/// The errors of the limits, relative to the truth.
struct SurfaceErrors {
  Measured error;
  Measured shape_error;   ///< after the limit is scaled about its centre so that it fits best
  Measured normal_error;  ///< root mean square of the angles between the normals of facets, in degrees
};
SurfaceErrors measure(const SurfaceTrial& trial, const ExperimentOptions& options);

/// One sample of the noise: the surface and its noisy points, and the limits, one row for each level of noise.
formats::SurfaceFigure samples_figure(const SurfaceTrial& trial, const std::string& id, std::uint64_t seed);
formats::SurfaceFigure limits_figure(const SurfaceTrial& trial, std::uint64_t seed);

}  // namespace subcert::experiments
