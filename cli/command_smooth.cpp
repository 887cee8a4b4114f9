// subcert smooth DATA

#include "command.hpp"
#include "samples.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/reports/formats/figure.hpp>
#include <subcert/schemes/data/axis_refinement.hpp>
#include <subcert/schemes/data/l1_specification.hpp>
#include <subcert/schemes/data/smoothing_choice.hpp>

#include <boost/math/distributions/students_t.hpp>

#include <cmath>
#include <iostream>

namespace subcert::cli {
namespace {

struct SmoothCommand : CommonOptions {
  SampleOptions samples;
  std::string scheme;
  bool automatic = false;
  std::string boundary = "interp";
  double constant = 0;
  std::optional<double> requested_bands;
  double bands() const { return requested_bands.value_or(0.95); }
  int level = 2;
  int derivative = 0;
  std::string plot;
};

/// What was computed, column by column.
struct Smooth {
  std::string specification;
  std::vector<std::string> notes;  ///< lines for people
  Json choice;
  std::vector<Rational> positions;  ///< in spacings, from the first datum
  std::vector<data::NoiseEstimate> noise;
  std::vector<std::vector<double>> values;
  std::vector<std::vector<double>> deviations;  ///< standard deviations; empty where there are none
  std::vector<std::vector<double>> half_widths;
};

std::string number_text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

Json risk_json(const data::SmoothingCandidate& candidate) {
  return {{"scheme", candidate.specification},
          {"bias_squared", candidate.risk.bias_squared},
          {"variance", candidate.risk.variance},
          {"expected_squared_error", candidate.risk.total()}};
}

std::string risk_text(const data::SmoothingCandidate& candidate) {
  return candidate.specification + ": " + number_text(candidate.risk.total()) + " = bias^2 " +
         number_text(candidate.risk.bias_squared) + " + variance " + number_text(candidate.risk.variance);
}

/// The largest n among the candidates of a degree.
int widest(const std::vector<data::SmoothingCandidate>& candidates, int degree) {
  int n = 0;
  for (const data::SmoothingCandidate& candidate : candidates)
    if (candidate.degree == degree) n = std::max(n, candidate.n);
  return n;
}

/// The scheme of the smallest estimated risk whose limits are smooth enough.
Scheme choose_scheme(const SmoothCommand& options, const Samples& samples, Smooth& result) {
  if (samples.count() < 4)
    fail(ErrorKind::data, "expected at least 4 rows to choose a scheme; found {}; name one with --scheme",
         samples.count());
  for (const data::NoiseEstimate& noise : result.noise)
    if (noise.terms == 0)
      fail(ErrorKind::data,
           "expected three neighbouring data to estimate the noise; found none; name a scheme with --scheme");
  const auto ranked = data::rank_schemes(samples.columns, result.noise, *data::parse_extension(options.boundary),
                                         samples.weights, options.constant);
  for (std::size_t i = 0; i < ranked.size(); ++i) {
    Scheme scheme = make_scheme(ranked[i].specification);
    if (options.derivative > 0 && proved_smoothness(scheme.mask).order < options.derivative) continue;
    result.notes.push_back("chosen for the smallest estimated mean squared error at the data, of " +
                           std::to_string(ranked.size()) + " schemes" +
                           (i == 0 ? "" : ", among those with continuous derivatives of this order"));
    result.notes.push_back("  " + risk_text(ranked[i]));
    if (ranked[i].n == widest(ranked, ranked[i].degree))
      result.notes.push_back("  more points were not tried for this degree");
    for (std::size_t k = 0, shown = 0; k < ranked.size() && shown < 2; ++k)
      if (k != i) {
        result.notes.push_back("  " + risk_text(ranked[k]));
        ++shown;
      }
    result.choice = {{"chosen", risk_json(ranked[i])}, {"candidates", Json::array()}};
    for (const data::SmoothingCandidate& candidate : ranked)
      result.choice["candidates"].push_back(risk_json(candidate));
    return scheme;
  }
  fail(ErrorKind::usage, "--derivative {}: no scheme tried has limits proved to be so smooth", options.derivative);
}

void require_limits(const Scheme& scheme, int derivative) {
  if (derivative == 0) {
    const Decision convergence = converges(scheme.mask);
    if (!convergence.is_yes())
      fail(ErrorKind::usage, "{}: no proof that the scheme converges ({})", scheme.specification, convergence.reason);
    return;
  }
  const SmoothnessProof smoothness = proved_smoothness(scheme.mask);
  if (smoothness.order < derivative)
    fail(ErrorKind::usage, "--derivative {}: {} is not proved to have continuous derivatives of that order; {}",
         derivative, scheme.specification, smoothness.obstacle);
}

/// The factor between standard deviation and half the width of a band.
double band_factor(double level, const data::NoiseEstimate& noise) {
  return boost::math::quantile(boost::math::students_t(noise.degrees_of_freedom), 0.5 + level / 2);
}

void smooth_linearly(const SmoothCommand& options, const Samples& samples, Smooth& result) {
  std::vector<double> weights;
  for (const Rational& weight : samples.weights) weights.push_back(data::nearest_double(weight));
  for (const auto& column : samples.columns) result.noise.push_back(data::estimate_noise(column, weights));
  const Scheme scheme = options.scheme.empty() ? choose_scheme(options, samples, result) : make_scheme(options.scheme);
  require_limits(scheme, options.derivative);
  result.specification = scheme.specification;
  const data::LinearSmoother smoother(scheme.mask, samples.count(),
                                      {*data::parse_extension(options.boundary), options.level, options.derivative},
                                      scheme.rules, samples.weights);
  const double unit = std::pow(data::nearest_double(samples.spacing), -options.derivative);
  for (std::size_t o = 0; o < smoother.outputs(); ++o) result.positions.push_back(smoother.position(o));
  for (std::size_t c = 0; c < samples.columns.size(); ++c) {
    const auto smoothed = smoother.apply(samples.columns[c], options.constant);
    result.values.push_back(smoothed.values);
    for (double& value : result.values.back()) value *= unit;
    const data::NoiseEstimate& noise = result.noise[c];
    result.notes.push_back("noise of " + samples.names[c] + ": " +
                           (noise.terms == 0 ? std::string("not estimated, there are no three neighbouring data")
                                             : "standard deviation " + number_text(std::sqrt(noise.variance)) +
                                                   " from " + std::to_string(noise.terms) + " second differences, " +
                                                   number_text(noise.degrees_of_freedom) + " degrees of freedom"));
    if (noise.terms == 0) continue;
    auto& deviations = result.deviations.emplace_back();
    for (const double variance : smoothed.variances) deviations.push_back(unit * std::sqrt(noise.variance * variance));
    if (options.bands() == 0) continue;
    auto& half_widths = result.half_widths.emplace_back(deviations);
    for (double& width : half_widths) width *= band_factor(options.bands(), noise);
  }
  if (!result.half_widths.empty())
    result.notes.push_back("bands: " + number_text(100 * options.bands()) +
                           " % pointwise, for the expected value of the limit; the bias is not in them");
}

/// Values between neighbours of a fine refinement, by linear interpolation.
std::vector<double> interpolate(const data::GridData<double>& fine, const std::vector<Rational>& positions) {
  std::vector<double> result;
  const auto last = static_cast<long>(fine.points()) - 1;
  for (const Rational& position : positions) {
    const Rational place = (position - fine.axes[0].first) / fine.axes[0].step;
    const long left = static_cast<long>(std::floor(data::nearest_double(place)));
    const bool closed = fine.axes[0].closed;
    const long i = closed ? left : std::clamp(left, 0L, last - 1);
    const double t = data::nearest_double(place - i);
    const auto at = [&](long k) { return fine.values[static_cast<std::size_t>((k + last + 1) % (last + 1))]; };
    result.push_back((1 - t) * at(i) + t * at(i + 1));
  }
  return result;
}

constexpr int finer_levels = 6;

void smooth_by_l1(const SmoothCommand& options, const Samples& samples, Smooth& result) {
  const data::NamedL1Scheme named = data::make_l1_scheme(options.scheme);
  const auto refuse = [&](const std::string& what) {
    fail(ErrorKind::usage, "{} needs a linear scheme; {} is none", what, named.specification);
  };
  if (named.scheme.points.size() != 1) fail(ErrorKind::usage, "{}: expected a scheme for curves", named.specification);
  if (options.derivative != 0) refuse("--derivative");
  if (options.requested_bands.value_or(0) != 0) refuse("--bands");
  if (!samples.weights.empty()) refuse("prior weights and missing data: a fit with them");
  const data::Extension extension = *data::parse_extension(options.boundary);
  if (extension == data::Extension::nearest || extension == data::Extension::constant)
    fail(ErrorKind::usage, "--boundary {}: expected interp, mirror or wrap for l1 schemes", options.boundary);
  if (samples.count() < static_cast<std::size_t>(named.scheme.points[0]))
    fail(ErrorKind::data, "expected at least {} rows for {}; found {}", named.scheme.points[0], named.specification,
         samples.count());
  const data::Boundary boundary = extension == data::Extension::interp   ? data::Boundary::regression
                                  : extension == data::Extension::mirror ? data::Boundary::reflect
                                                                         : data::Boundary::periodic;
  result.specification = named.specification;
  result.notes.push_back("values " + std::to_string(finer_levels) +
                         " levels below the output grid, interpolated; no bands, as the scheme is not linear");
  const long scale = 1L << options.level;
  data::require_smoothable(samples.count(), static_cast<std::size_t>(scale));
  for (long o = 0; o <= static_cast<long>(samples.count() - 1) * scale; ++o) result.positions.emplace_back(o, scale);
  for (const auto& column : samples.columns)
    result.values.push_back(interpolate(
        refine(data::curve_data(column), named.scheme, {options.level + finer_levels, boundary, options.threads()}),
        result.positions));
}

/// Columns x, then value, deviation, lower and upper end for each column of the data.
data::Table result_table(const Samples& samples, const Smooth& smooth) {
  data::Table table;
  table.separator = samples.separator;
  table.header.push_back(samples.x_name);
  const bool single = samples.columns.size() == 1;
  for (std::size_t c = 0; c < samples.columns.size(); ++c) {
    const std::string prefix = single ? "" : samples.names[c] + "_";
    table.header.push_back(samples.names[c]);
    if (!smooth.deviations.empty()) table.header.push_back(prefix + "sd");
    if (!smooth.half_widths.empty()) {
      table.header.push_back(prefix + "lower");
      table.header.push_back(prefix + "upper");
    }
  }
  table.columns = table.header.size();
  for (std::size_t o = 0; o < smooth.positions.size(); ++o) {
    table.values.push_back(data::nearest_double(samples.origin + samples.spacing * smooth.positions[o]));
    for (std::size_t c = 0; c < samples.columns.size(); ++c) {
      const double value = smooth.values[c][o];
      table.values.push_back(value);
      if (!smooth.deviations.empty()) table.values.push_back(smooth.deviations[c][o]);
      if (!smooth.half_widths.empty()) {
        table.values.push_back(value - smooth.half_widths[c][o]);
        table.values.push_back(value + smooth.half_widths[c][o]);
      }
    }
  }
  return table;
}

Json result_json(const SmoothCommand& options, const Samples& samples, const Smooth& smooth, const data::Table& table) {
  Json noise = Json::array(), rows = Json::array();
  for (std::size_t c = 0; c < smooth.noise.size(); ++c)
    noise.push_back({{"column", samples.names[c]},
                     {"sigma", std::sqrt(smooth.noise[c].variance)},
                     {"degrees_of_freedom", smooth.noise[c].degrees_of_freedom},
                     {"terms", smooth.noise[c].terms}});
  for (std::size_t i = 0; i < table.rows(); ++i) {
    Json row = Json::array();
    for (std::size_t c = 0; c < table.columns; ++c) row.push_back(table.values[i * table.columns + c]);
    rows.push_back(row);
  }
  return {{"scheme", smooth.specification},
          {"auto", options.scheme.empty()},
          {"choice", smooth.choice},
          {"boundary", options.boundary},
          {"origin", to_text(samples.origin)},
          {"spacing", to_text(samples.spacing)},
          {"level", options.level},
          {"derivative", options.derivative},
          {"noise", noise},
          {"bands", smooth.half_widths.empty() ? Json() : Json(options.bands())},
          {"columns", table.header},
          {"rows", rows}};
}

void draw_smooth(const SmoothCommand& options, const Samples& samples, const Smooth& smooth, const data::Table& table) {
  formats::Figure figure{"smooth", smooth.specification, "", 1, {}};
  for (std::size_t c = 0; c < samples.columns.size(); ++c) {
    formats::Panel panel{smooth.specification, samples.x_name, samples.names[c], {}, false, "below"};
    const auto curve = [&](const std::string& label, double sign) {
      formats::Curve result{label, {}};
      for (std::size_t o = 0; o < smooth.positions.size(); ++o)
        result.points.emplace_back(table.values[o * table.columns],
                                   smooth.values[c][o] + (sign == 0 ? 0 : sign * smooth.half_widths[c][o]));
      return result;
    };
    if (options.derivative == 0) {
      formats::Curve data{"data", {}, true, false};
      for (std::size_t i = 0; i < samples.count(); ++i)
        if (samples.weights.empty() || samples.weights[i] > 0)
          data.points.emplace_back(data::nearest_double(samples.origin + samples.spacing * Rational(i)),
                                   samples.columns[c][i]);
      panel.curves.push_back(data);
    }
    panel.curves.push_back(curve("limit", 0));
    if (!smooth.half_widths.empty()) {
      panel.curves.push_back(curve("lower", -1));
      panel.curves.push_back(curve("upper", 1));
    }
    figure.panels.push_back(panel);
  }
  formats::draw_file(figure, options.plot);
}

ExitCode run(const SmoothCommand& options) {
  if (options.automatic && !options.scheme.empty())
    fail(ErrorKind::usage, "--auto and --scheme: expected one of the two");
  if (!options.plot.empty() && !formats::is_picture_name(options.plot))
    fail(ErrorKind::usage, "--plot {}: expected a name that ends in .svg or .png", options.plot);
  const Samples samples = read_samples(options.samples);
  Smooth smooth;
  try {
    if (data::is_l1_specification(options.scheme))
      smooth_by_l1(options, samples, smooth);
    else
      smooth_linearly(options, samples, smooth);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::data) throw;
    fail(ErrorKind::data, "{}: {}", options.samples.file, error.what());
  }
  const data::Table table = result_table(samples, smooth);
  if (!options.plot.empty()) draw_smooth(options, samples, smooth, table);
  if (options.json) {
    options.answer(result_json(options, samples, smooth, table));
    return done;
  }
  std::string text;
  if (!options.quiet) {
    text += "# scheme " + smooth.specification + ", boundary " + options.boundary +
            (options.derivative > 0 ? ", derivative " + std::to_string(options.derivative) : "") + "\n";
    for (const std::string& note : smooth.notes) text += "# " + note + "\n";
  }
  options.answer(text + to_text(table));
  return done;
}

}  // namespace

void add_smooth(Command& app) {
  auto options = std::make_shared<SmoothCommand>();
  Command command = add_command(app, "smooth", "Smooths data on a uniform grid by the limit of a scheme, with bands",
                                "subcert smooth samples.csv --bands 0.95 --plot smooth.svg", options,
                                [=] { return run(*options); });
  command.option("DATA", options->samples.file, "CSV: a column of positions, then one or more of values").required();
  command.option("--scheme", options->scheme, "Scheme specification, also l1:...");
  command.flag("--auto", options->automatic, "Choose the scheme from noise and bias (the default)");
  command.option("--x", options->samples.x, "Column of positions, by name or number; none: 0, 1, 2, ...");
  command.option("--y", options->samples.y, "Columns of values, by name or number").separated_by_commas();
  command.option("--weights", options->samples.weights,
                 "Column of prior weights, inverse to the variance of the noise");
  command.option("--missing", options->samples.missing, "Missing values").one_of({"raise", "drop"}).with_default();
  command.option("--boundary", options->boundary, "How data go on past the ends")
      .one_of({"interp", "mirror", "nearest", "constant", "wrap"})
      .with_default();
  command.option("--constant", options->constant, "The value of --boundary constant")
      .within(-1e300, 1e300)
      .with_default();
  command
      .option("--bands", options->requested_bands, "Level of the pointwise confidence bands, 0 for none (default 0.95)")
      .within(0.0, 0.999999);
  command.option("--level", options->level, "Values at the multiples of arity^-LEVEL of the spacing")
      .within(0, 12)
      .with_default();
  command.option("--derivative", options->derivative, "Order of the derivative").within(0, 20).with_default();
  command.option("--plot", options->plot, "Draw data and result, as .svg or .png");
}

}  // namespace subcert::cli
