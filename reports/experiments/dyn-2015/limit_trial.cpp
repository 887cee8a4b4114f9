#include "limit_trial.hpp"

#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/reports/experiments/figures.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace subcert::experiments::dyn_2015 {
namespace {

using Values = std::vector<double>;

/// With independent normal noise in every coordinate, of the same deviation.
data::GridData<double> noisy(data::GridData<double> samples, double sigma, std::mt19937_64& engine) {
  for (std::size_t c = 0; c < samples.dimension; ++c) {
    const Values noise = normal_noise(engine, samples.points());
    for (std::size_t i = 0; i < noise.size(); ++i) samples.values[i * samples.dimension + c] += sigma * noise[i];
  }
  return samples;
}

/// Moved so that the mean of every coordinate is 0.
Values centred(const data::GridData<double>& points) {
  Values result = points.values;
  for (std::size_t c = 0; c < points.dimension; ++c) {
    double sum = 0;
    for (std::size_t i = c; i < result.size(); i += points.dimension) sum += result[i];
    for (std::size_t i = c; i < result.size(); i += points.dimension)
      result[i] -= sum / static_cast<double>(points.points());
  }
  return result;
}

using Vector = std::array<double, 3>;

/// The normal of the facet with the lowest corner (i, j): the product of its diagonals.
Vector facet_normal(const data::GridData<double>& grid, std::size_t i, std::size_t j) {
  const std::size_t columns = grid.axes[0].count;
  const double* const corner = &grid.values[3 * (j * columns + i)];
  Vector u{}, v{};
  for (std::size_t c = 0; c < 3; ++c) {
    u[c] = corner[3 * (columns + 1) + c] - corner[c];
    v[c] = corner[3 * columns + c] - corner[3 + c];
  }
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double mean_squared_distance(const data::GridData<double>& a, const data::GridData<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) sum += (a.values[i] - b.values[i]) * (a.values[i] - b.values[i]);
  return sum / static_cast<double>(a.points());
}

/// The limit at the parameters of the samples.
data::GridData<double> at_samples(const TrialSample& s) {
  return {polygon_at(s.limit, parameters(s.noisy.axes[0])), s.noisy.dimension, s.noisy.axes};
}

std::string noise_words(double decibel) { return short_number(decibel) + " dB"; }

std::string at_noise(const std::string& scheme, double decibel) {
  return scheme_name(scheme) + " at " + noise_words(decibel);
}

std::vector<TensorLimit> limits_of(const LimitTrial& trial, int level) {
  std::vector<TensorLimit> result;
  for (const std::string& scheme : trial.schemes) result.emplace_back(scheme, trial.axes, level, trial.ends);
  return result;
}

/// Calls visit(decibel, data) for one sample of the noise, with this ratio for all coordinates together.
void for_each_noise(const LimitTrial& trial, const data::GridData<double>& samples, std::uint64_t seed, std::size_t run,
                    const std::function<void(double, const data::GridData<double>&)>& visit) {
  auto engine = generator(seed, run);
  const double square = mean_square(samples.values);
  for (const double decibel : trial.decibels)
    visit(decibel, noisy(samples, noise_deviation(square, decibel, trial.factor), engine));
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

double relative_error(const Values& values, const Values& truth) {
  double error = 0, norm = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    error += (values[i] - truth[i]) * (values[i] - truth[i]);
    norm += truth[i] * truth[i];
  }
  return std::sqrt(error / norm);
}

namespace {

double error_up_to_size(const data::GridData<double>& points, const data::GridData<double>& truth) {
  Values found = centred(points);
  const Values wanted = centred(truth);
  double product = 0, square = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    product += found[i] * wanted[i];
    square += found[i] * found[i];
  }
  for (double& value : found) value *= product / square;
  return relative_error(found, wanted);
}

}  // namespace

double point_error(const TrialSample& s) { return relative_error(s.limit.values, s.truth.values); }
double sample_error(const TrialSample& s) { return relative_error(s.noisy.values, s.exact.values); }
double squared_noise(const TrialSample& s) { return mean_squared_distance(s.limit, s.quiet); }
double squared_bias(const TrialSample& s) { return mean_squared_distance(s.quiet, s.truth); }
double square_to_noisy(const TrialSample& s) { return mean_squared_distance(at_samples(s), s.noisy); }
double square_to_exact(const TrialSample& s) { return mean_squared_distance(at_samples(s), s.exact); }

double shape_error(const TrialSample& s) { return error_up_to_size(s.limit, s.truth); }
double sample_shape_error(const TrialSample& s) { return error_up_to_size(s.noisy, s.exact); }

double normal_error(const TrialSample& sample) {
  const auto &limit = sample.limit, &truth = sample.truth;
  const std::size_t columns = limit.axes[0].count - 1, rows = limit.axes[1].count - 1;
  double sum = 0;
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const Vector a = facet_normal(limit, i, j), b = facet_normal(truth, i, j);
      const double angle = std::acos(std::clamp(dot(a, b) / std::sqrt(dot(a, a) * dot(b, b)), -1.0, 1.0));
      sum += angle * angle;
    }
  return std::sqrt(sum / static_cast<double>(rows * columns)) * 180 / std::numbers::pi;
}

TensorLimit::TensorLimit(const std::string& specification, const std::vector<data::Axis>& axes, int level,
                         data::Boundary ends) {
  for (const data::Axis& axis : axes) {
    along_.push_back(limit_matrix(specification, axis.count, axis.closed ? data::Boundary::periodic : ends, level));
    axes_.push_back(finer(axis, 1 << level));
  }
}

data::GridData<double> TensorLimit::operator()(const data::GridData<double>& data) const {
  // The last axis first, as its points are the farthest apart: the others are refined once for each of its outputs.
  data::GridData<double> result = data;
  for (std::size_t k = along_.size(); k-- > 0;) {
    const DenseMatrix& matrix = along_[k];
    std::size_t width = data.dimension, blocks = 1;  // values at a point of this axis; runs along it
    for (std::size_t i = 0; i < k; ++i) width *= data.axes[i].count;
    for (std::size_t i = k + 1; i < axes_.size(); ++i) blocks *= axes_[i].count;
    Values values(blocks * matrix.rows() * width);
    for (std::size_t b = 0; b < blocks; ++b)
      for (std::size_t r = 0; r < matrix.rows(); ++r) {
        double* const out = &values[(b * matrix.rows() + r) * width];
        for (std::size_t i = 0; i < matrix.columns(); ++i) {
          const double weight = matrix.at(r, i);
          if (weight == 0) continue;
          const double* const in = &result.values[(b * matrix.columns() + i) * width];
          for (std::size_t c = 0; c < width; ++c) out[c] += weight * in[c];
        }
      }
    result.values = std::move(values);
  }
  result.axes = axes_;
  return result;
}

data::GridData<double> LimitTrial::truth() const {
  std::vector<data::Axis> fine;
  for (const data::Axis& axis : axes) fine.push_back(finer(axis, 1 << level));
  return sampled(fine, dimension, shape);
}

Measured LimitTrial::measured(const Run& run) const {
  const data::GridData<double> exact = samples(), wanted = truth();
  const auto limits = limits_of(*this, level);
  std::vector<data::GridData<double>> quiet;
  for (const TensorLimit& limit : limits) quiet.push_back(limit(exact));
  Measured result;
  MeansTable table{run.experiment.id + "-measures", title, {"scheme", "SNR (dB)"}, {}, {}};
  for (const auto& [name, measure] : measures) table.columns.push_back({name, name});
  for (const std::string& scheme : schemes)
    for (const double decibel : decibels) {
      const std::string subject = at_noise(scheme, decibel);
      table.rows.push_back({{scheme_name(scheme), short_number(decibel)}, subject});
      for (const auto& [name, measure] : measures) result.samples[{name, subject}].resize(run.runs);
    }
  parallel_for_each(run.runs, run.jobs, [&](std::size_t sample) {
    for_each_noise(*this, exact, run.seed, sample, [&](double decibel, const data::GridData<double>& data) {
      for (std::size_t s = 0; s < schemes.size(); ++s) {
        const data::GridData<double> limit = limits[s](data);
        for (const auto& [name, measure] : measures)
          result.samples.at({name, at_noise(schemes[s], decibel)})[sample] = measure(
              {limit, wanted, quiet[s], data, exact});
      }
    });
  });
  if (!run.is_alternative()) result.tables = {table.filled(result)};
  return result;
}

formats::Figure LimitTrial::curves_figure(const Run& run) const {
  formats::Figure figure{run.experiment.id,
                         title,
                         "One sample of the noise; rows: low and high noise.",
                         static_cast<int>(schemes.size()),
                         {}};
  const data::GridData<double> wanted = truth();
  const auto limits = limits_of(*this, level);
  for_each_noise(*this, samples(), run.seed, 0, [&](double decibel, const data::GridData<double>& data) {
    for (std::size_t s = 0; s < schemes.size(); ++s)
      figure.panels.push_back(
          plain_panel(scheme_name(schemes[s]) + ", " + noise_words(decibel),
                      {dots("data", points_of(data), colour::grey), line("curve", line_of(wanted), colour::amber),
                       line("limit", line_of(limits[s](data)), colour::blue)},
                      true));
  });
  return figure;
}

formats::SurfaceFigure LimitTrial::surfaces_figure(const Run& run) const {
  formats::SurfaceFigure figure{
      run.experiment.id, title + ": limits", "One sample of the noise; rows: low and high noise.", {}, schemes.size()};
  const auto limits = limits_of(*this, axes[0].closed ? level : 0);
  for_each_noise(*this, samples(), run.seed, 0, [&](double decibel, const data::GridData<double>& data) {
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      const std::string name = scheme_name(schemes[s]);
      figure.surfaces.push_back(drawn_surface(name + " x " + name + ", " + noise_words(decibel), limits[s](data)));
    }
  });
  return figure;
}

formats::SurfaceFigure LimitTrial::samples_figure(const std::string& figure_id, const Run& run) const {
  formats::SurfaceFigure figure{figure_id, title + " and its noisy samples", "One sample of the noise.", {}, 3};
  figure.surfaces.push_back(drawn_surface(title, truth()));
  for_each_noise(*this, samples(), run.seed, 0, [&](double decibel, const data::GridData<double>& data) {
    figure.surfaces.push_back(drawn_surface("samples, " + noise_words(decibel), data));
  });
  return figure;
}

}  // namespace subcert::experiments::dyn_2015
