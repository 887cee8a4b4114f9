#pragma once
/// Curves and surfaces from noisy points: limits of several schemes at two levels of noise.

#include <subcert/reports/experiments/experiment.hpp>
#include <subcert/reports/experiments/linear_method.hpp>

#include <array>

namespace subcert::experiments::dyn_2015 {

using Coordinate = std::vector<double>;

/// As [DHHS15] names it: primal:n=4,d=3 is S_4^3. Other specifications stay as they are.
std::string scheme_name(const std::string& specification);

/// The norm of the difference over the norm of the truth, all coordinates together.
double relative_error(const std::vector<Coordinate>& values, const std::vector<Coordinate>& truth);

/// columns x rows points: coordinate[j * columns + i]. A curve has one row.
struct PointGrid {
  std::size_t columns;
  std::size_t rows;
  std::vector<Coordinate> points;
};

/// The points of all (i, j); the first `dimension` numbers of each are read.
PointGrid sampled_grid(std::size_t columns, std::size_t rows, std::size_t dimension,
                       const std::function<std::array<double, 3>(double, double)>& point);

/// One scheme along a curve or in both directions of a surface, its limit at the multiples of 2^-level.
class TensorLimit {
 public:
  TensorLimit(const std::string& specification, std::size_t columns, std::size_t rows, data::Boundary extension,
              int level);
  PointGrid operator()(const PointGrid& grid) const;

 private:
  DenseMatrix along_columns_;
  std::optional<DenseMatrix> along_rows_;
};

/// A number for a limit beside the truth at the same parameters.
using GridMeasure = double (*)(const PointGrid& limit, const PointGrid& truth);

double point_error(const PointGrid& limit, const PointGrid& truth);
/// After the limit is scaled about its centre so that it fits best.
double shape_error(const PointGrid& limit, const PointGrid& truth);
/// The root mean square of the angles between the normals of facets, in degrees. Domain: at least two rows.
double normal_error(const PointGrid& limit, const PointGrid& truth);

/// A shape, its noisy samples and the limits of schemes.
struct LimitTrial {
  std::string id;  ///< of the figure of the limits
  std::string title;
  PointGrid (*shape)(std::size_t refinement);  ///< the samples for refinement 1
  bool closed;                                 ///< in every direction
  int level;                                   ///< limits stand at the multiples of 2^-level
  std::array<double, 2> decibels;              ///< low and high noise
  Names schemes;
  std::vector<std::pair<std::string, GridMeasure>> measures;

  /// The quantities, each of a scheme at a level of noise.
  Measured measured(const ExperimentOptions& options) const;
  /// A row for each scheme and level of noise, a column for each measure.
  MeansTable table() const;
  /// One sample of the noise: the limits of curves with data and truth, those of surfaces alone.
  formats::Figure curves_figure(std::uint64_t seed) const;
  formats::SurfaceFigure surfaces_figure(std::uint64_t seed) const;
  /// The surface and its noisy points.
  formats::SurfaceFigure samples_figure(const std::string& figure_id, std::uint64_t seed) const;
};

/// Means that name schemes, taken at this level of noise.
Means with_noise(double decibel, Means means);

}  // namespace subcert::experiments::dyn_2015
