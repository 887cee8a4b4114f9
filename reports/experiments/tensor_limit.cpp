#include "tensor_limit.hpp"

#include <subcert/schemes/data/runtime/parallel.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace subcert::experiments {
namespace {

/// matrix times each column of `values`, a matrix with `width` columns; zeros are skipped.
Coordinate product(const DenseMatrix& matrix, const Coordinate& values, std::size_t width) {
  Coordinate result(matrix.rows() * width);
  for (std::size_t r = 0; r < matrix.rows(); ++r) {
    double* const out = result.data() + r * width;
    for (std::size_t k = 0; k < matrix.columns(); ++k) {
      const double weight = matrix.at(r, k);
      if (weight == 0) continue;
      const double* const in = values.data() + k * width;
      for (std::size_t c = 0; c < width; ++c) out[c] += weight * in[c];
    }
  }
  return result;
}

Coordinate transposed(const Coordinate& values, std::size_t width) {
  Coordinate result(values.size());
  const std::size_t height = values.size() / width;
  for (std::size_t r = 0; r < height; ++r)
    for (std::size_t c = 0; c < width; ++c) result[c * height + r] = values[r * width + c];
  return result;
}

PointGrid noisy(PointGrid samples, double decibel, std::mt19937_64& engine) {
  add_noise(samples.points, noise_deviation(samples.points, decibel), engine);
  return samples;
}

double mean(const Coordinate& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The points scaled about their centre by the factor that brings them nearest to the truth, both moved to the origin.
double best_scaled_error(PointGrid grid, PointGrid truth) {
  double product = 0, square = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double centre = mean(grid.points[c]), true_centre = mean(truth.points[c]);
    for (std::size_t i = 0; i < grid.points[c].size(); ++i) {
      grid.points[c][i] -= centre;
      truth.points[c][i] -= true_centre;
      product += grid.points[c][i] * truth.points[c][i];
      square += grid.points[c][i] * grid.points[c][i];
    }
  }
  for (Coordinate& coordinate : grid.points)
    for (double& value : coordinate) value *= product / square;
  return relative_error(grid.points, truth.points);
}

using Vector = std::array<double, 3>;

/// The normal of the facet with the lowest corner (i, j): the product of its diagonals.
Vector facet_normal(const PointGrid& grid, std::size_t i, std::size_t j) {
  const std::size_t corner = j * grid.columns + i;
  Vector u{}, v{};
  for (std::size_t c = 0; c < 3; ++c) {
    const Coordinate& p = grid.points[c];
    u[c] = p[corner + grid.columns + 1] - p[corner];
    v[c] = p[corner + grid.columns] - p[corner + 1];
  }
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// In degrees, over the facets between neighbours in the grid.
double normal_angle(const PointGrid& grid, const PointGrid& truth) {
  double sum = 0;
  for (std::size_t j = 0; j + 1 < grid.rows; ++j)
    for (std::size_t i = 0; i + 1 < grid.columns; ++i) {
      const Vector a = facet_normal(grid, i, j), b = facet_normal(truth, i, j);
      const double angle = std::acos(std::clamp(dot(a, b) / std::sqrt(dot(a, a) * dot(b, b)), -1.0, 1.0));
      sum += angle * angle;
    }
  return std::sqrt(sum / static_cast<double>((grid.rows - 1) * (grid.columns - 1))) * 180 / std::numbers::pi;
}

std::vector<TensorLimit> limits(const SurfaceTrial& trial, int at_level) {
  std::vector<TensorLimit> result;
  for (const std::string& scheme : trial.schemes)
    result.emplace_back(scheme, trial.samples.columns, trial.samples.rows,
                        trial.closed ? data::Boundary::periodic : data::Boundary::regression, at_level);
  return result;
}

}  // namespace

formats::DrawnSurface PointGrid::drawn(const std::string& title, bool closed) const {
  formats::DrawnSurface result{title, columns, rows, closed, closed, {}};
  for (std::size_t i = 0; i < columns * rows; ++i) result.points.push_back({points[0][i], points[1][i], points[2][i]});
  return result;
}

TensorLimit::TensorLimit(const std::string& specification, std::size_t columns, std::size_t rows,
                         data::Boundary extension, int level)
    : along_columns_(limit_matrix(specification, columns, extension, level)),
      along_rows_(limit_matrix(specification, rows, extension, level)) {}

PointGrid TensorLimit::operator()(const PointGrid& grid) const {
  PointGrid result{along_columns_.rows(), along_rows_.rows(), {}};
  for (std::size_t c = 0; c < 3; ++c) {
    const Coordinate half = transposed(product(along_rows_, grid.points[c], grid.columns), grid.columns);
    result.points[c] = transposed(product(along_columns_, half, result.rows), result.rows);
  }
  return result;
}

SurfaceErrors measure(const SurfaceTrial& trial, const ExperimentOptions& options) {
  const auto schemes = limits(trial, trial.level);
  const Measured empty = empty_measure(schemes.size(), options.runs);
  SurfaceErrors result{empty, empty, empty};
  runtime::parallel_for_each(options.runs, options.jobs, [&](std::size_t run) {
    auto engine = generator(options.seed, run);
    for (std::size_t d = 0; d < 2; ++d) {
      const PointGrid data = noisy(trial.samples, trial.decibels[d], engine);
      for (std::size_t s = 0; s < schemes.size(); ++s) {
        const PointGrid limit = schemes[s](data);
        result.error[s][d][run] = relative_error(limit.points, trial.truth.points);
        result.shape_error[s][d][run] = best_scaled_error(limit, trial.truth);
        result.normal_error[s][d][run] = normal_angle(limit, trial.truth);
      }
    }
  });
  return result;
}

formats::SurfaceFigure samples_figure(const SurfaceTrial& trial, const std::string& id, std::uint64_t seed) {
  formats::SurfaceFigure figure{id, trial.title + " and its noisy samples", "One sample of the noise.", {}, 3};
  figure.surfaces.push_back(trial.truth.drawn(trial.title, trial.closed));
  auto engine = generator(seed, 0);
  for (const double decibel : trial.decibels)
    figure.surfaces.push_back(
        noisy(trial.samples, decibel, engine).drawn("samples, " + short_number(decibel) + " dB", trial.closed));
  return figure;
}

formats::SurfaceFigure limits_figure(const SurfaceTrial& trial, std::uint64_t seed) {
  formats::SurfaceFigure figure{trial.id,
                                trial.title + ": limits",
                                "One sample of the noise; rows: low and high noise.",
                                {},
                                trial.schemes.size()};
  const auto schemes = limits(trial, trial.closed ? trial.level : 0);
  auto engine = generator(seed, 0);
  for (const double decibel : trial.decibels) {
    const PointGrid data = noisy(trial.samples, decibel, engine);
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const std::string name = scheme_name(trial.schemes[s]);
      figure.surfaces.push_back(
          schemes[s](data).drawn(name + " x " + name + ", " + short_number(decibel) + " dB", trial.closed));
    }
  }
  return figure;
}

}  // namespace subcert::experiments
