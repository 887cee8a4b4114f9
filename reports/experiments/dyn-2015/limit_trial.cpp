#include "limit_trial.hpp"

#include <subcert/analysis/symbol/parallel.hpp>
#include <subcert/reports/experiments/figures.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace subcert::experiments::dyn_2015 {
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

/// With independent normal noise in every coordinate: the ratio `decibel` for all coordinates together.
PointGrid noisy(PointGrid samples, double decibel, std::mt19937_64& engine) {
  double square = 0;
  for (const Coordinate& values : samples.points)
    square += mean_square(values) / static_cast<double>(samples.points.size());
  const double sigma = noise_deviation(square, decibel);
  for (Coordinate& values : samples.points) {
    const auto noise = normal_noise(engine, values.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += sigma * noise[i];
  }
  return samples;
}

double mean_of(const Coordinate& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
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

std::string at_noise(const std::string& scheme, double decibel) {
  return scheme + " at " + short_number(decibel) + " dB";
}

data::GridData<double> as_data(const PointGrid& grid, bool closed) {
  data::GridData<double> result{{}, grid.points.size(), {data::Axis::of(grid.columns, closed)}};
  if (grid.rows > 1) result.axes.push_back(data::Axis::of(grid.rows, closed));
  for (std::size_t k = 0; k < grid.columns * grid.rows; ++k)
    for (const Coordinate& coordinate : grid.points) result.values.push_back(coordinate[k]);
  return result;
}

std::vector<TensorLimit> limits_of(const LimitTrial& trial, const PointGrid& samples, int level) {
  std::vector<TensorLimit> result;
  for (const std::string& scheme : trial.schemes)
    result.emplace_back(scheme, samples.columns, samples.rows,
                        trial.closed ? data::Boundary::periodic : data::Boundary::regression, level);
  return result;
}

/// Calls visit(decibel, data) for one sample of the noise.
void for_each_noise(const LimitTrial& trial, const PointGrid& samples, std::uint64_t seed, std::size_t run,
                    const std::function<void(double, const PointGrid&)>& visit) {
  auto engine = generator(seed, run);
  for (const double decibel : trial.decibels) visit(decibel, noisy(samples, decibel, engine));
}

}  // namespace

std::string scheme_name(const std::string& specification) {
  const std::string prefix = "primal:n=";
  if (!specification.starts_with(prefix)) return specification;
  const std::size_t comma = specification.find(",d=");
  std::string name = "S_" + specification.substr(prefix.size(), comma - prefix.size());
  if (comma != std::string::npos) name += "^" + specification.substr(comma + 3);
  return name;
}

double relative_error(const std::vector<Coordinate>& values, const std::vector<Coordinate>& truth) {
  double error = 0, norm = 0;
  for (std::size_t c = 0; c < truth.size(); ++c)
    for (std::size_t i = 0; i < truth[c].size(); ++i) {
      error += (values[c][i] - truth[c][i]) * (values[c][i] - truth[c][i]);
      norm += truth[c][i] * truth[c][i];
    }
  return std::sqrt(error / norm);
}

PointGrid sampled_grid(std::size_t columns, std::size_t rows, std::size_t dimension,
                       const std::function<std::array<double, 3>(double, double)>& point) {
  PointGrid result{columns, rows, std::vector<Coordinate>(dimension)};
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const auto p = point(static_cast<double>(i), static_cast<double>(j));
      for (std::size_t c = 0; c < dimension; ++c) result.points[c].push_back(p[c]);
    }
  return result;
}

double point_error(const PointGrid& limit, const PointGrid& truth) {
  return relative_error(limit.points, truth.points);
}

double shape_error(const PointGrid& limit, const PointGrid& truth) {
  // Both are moved to the origin, and the limit is scaled by the factor that brings it nearest.
  std::vector<Coordinate> found = limit.points, wanted = truth.points;
  double product = 0, square = 0;
  for (std::size_t c = 0; c < found.size(); ++c) {
    const double centre = mean_of(found[c]), true_centre = mean_of(wanted[c]);
    for (std::size_t i = 0; i < found[c].size(); ++i) {
      found[c][i] -= centre;
      wanted[c][i] -= true_centre;
      product += found[c][i] * wanted[c][i];
      square += found[c][i] * found[c][i];
    }
  }
  for (Coordinate& coordinate : found)
    for (double& value : coordinate) value *= product / square;
  return relative_error(found, wanted);
}

double normal_error(const PointGrid& limit, const PointGrid& truth) {
  double sum = 0;
  for (std::size_t j = 0; j + 1 < limit.rows; ++j)
    for (std::size_t i = 0; i + 1 < limit.columns; ++i) {
      const Vector a = facet_normal(limit, i, j), b = facet_normal(truth, i, j);
      const double angle = std::acos(std::clamp(dot(a, b) / std::sqrt(dot(a, a) * dot(b, b)), -1.0, 1.0));
      sum += angle * angle;
    }
  return std::sqrt(sum / static_cast<double>((limit.rows - 1) * (limit.columns - 1))) * 180 / std::numbers::pi;
}

TensorLimit::TensorLimit(const std::string& specification, std::size_t columns, std::size_t rows,
                         data::Boundary extension, int level)
    : along_columns_(limit_matrix(specification, columns, extension, level)),
      along_rows_(rows > 1 ? std::optional(limit_matrix(specification, rows, extension, level)) : std::nullopt) {}

PointGrid TensorLimit::operator()(const PointGrid& grid) const {
  PointGrid result{along_columns_.rows(), along_rows_ ? along_rows_->rows() : 1, {}};
  for (const Coordinate& values : grid.points) {
    const Coordinate half = along_rows_ ? transposed(product(*along_rows_, values, grid.columns), grid.columns)
                                        : values;
    result.points.push_back(transposed(product(along_columns_, half, result.rows), result.rows));
  }
  return result;
}

Measured LimitTrial::measured(const ExperimentOptions& options) const {
  const PointGrid samples = shape(1), truth = shape(std::size_t{1} << level);
  const auto limits = limits_of(*this, samples, level);
  Measured result;
  for (const auto& [name, measure] : measures)
    for (const std::string& scheme : schemes)
      for (const double decibel : decibels)
        result.samples[{name, at_noise(scheme_name(scheme), decibel)}].resize(options.runs);
  parallel_for_each(options.runs, options.jobs, [&](std::size_t run) {
    for_each_noise(*this, samples, options.seed, run, [&](double decibel, const PointGrid& data) {
      for (std::size_t s = 0; s < schemes.size(); ++s) {
        const PointGrid limit = limits[s](data);
        for (const auto& [name, measure] : measures)
          result.samples.at({name, at_noise(scheme_name(schemes[s]), decibel)})[run] = measure(limit, truth);
      }
    });
  });
  return result;
}

MeansTable LimitTrial::table() const {
  MeansTable result{id + "-measures", title, {"scheme", "SNR (dB)"}, {}, {}};
  for (const std::string& scheme : schemes)
    for (const double decibel : decibels) {
      const std::string name = scheme_name(scheme);
      result.rows.push_back({{name, short_number(decibel)}, at_noise(name, decibel)});
    }
  for (const auto& [name, measure] : measures) result.columns.push_back({name, name});
  return result;
}

formats::Figure LimitTrial::curves_figure(std::uint64_t seed) const {
  formats::Figure figure{
      id, title, "One sample of the noise; rows: low and high noise.", static_cast<int>(schemes.size()), {}};
  const PointGrid samples = shape(1), truth = shape(std::size_t{1} << level);
  const auto limits = limits_of(*this, samples, level);
  for_each_noise(*this, samples, seed, 0, [&](double decibel, const PointGrid& data) {
    for (std::size_t s = 0; s < schemes.size(); ++s)
      figure.panels.push_back(plain_panel(scheme_name(schemes[s]) + ", " + short_number(decibel) + " dB",
                                          {dots("data", points_of(as_data(data, closed)), colour::grey),
                                           line("curve", line_of(as_data(truth, closed)), colour::amber),
                                           line("limit", line_of(as_data(limits[s](data), closed)), colour::blue)},
                                          true));
  });
  return figure;
}

formats::SurfaceFigure LimitTrial::surfaces_figure(std::uint64_t seed) const {
  formats::SurfaceFigure figure{
      id, title + ": limits", "One sample of the noise; rows: low and high noise.", {}, schemes.size()};
  const PointGrid samples = shape(1);
  const auto limits = limits_of(*this, samples, closed ? level : 0);
  for_each_noise(*this, samples, seed, 0, [&](double decibel, const PointGrid& data) {
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const std::string name = scheme_name(schemes[s]);
      figure.surfaces.push_back(
          drawn_surface(name + " x " + name + ", " + short_number(decibel) + " dB", as_data(limits[s](data), closed)));
    }
  });
  return figure;
}

formats::SurfaceFigure LimitTrial::samples_figure(const std::string& figure_id, std::uint64_t seed) const {
  formats::SurfaceFigure figure{figure_id, title + " and its noisy samples", "One sample of the noise.", {}, 3};
  figure.surfaces.push_back(drawn_surface(title, as_data(shape(std::size_t{1} << level), closed)));
  for_each_noise(*this, shape(1), seed, 0, [&](double decibel, const PointGrid& data) {
    figure.surfaces.push_back(drawn_surface("samples, " + short_number(decibel) + " dB", as_data(data, closed)));
  });
  return figure;
}

Means with_noise(double decibel, Means means) {
  for (Mean& mean : means) {
    mean.of.subject = at_noise(mean.of.subject, decibel);
    if (mean.minus) mean.minus->subject = at_noise(mean.minus->subject, decibel);
  }
  return means;
}

}  // namespace subcert::experiments::dyn_2015
