// subcert smooth DATA

#include "plot.hpp"
#include "smooth_page.hpp"

#include <subcert/analysis/symbol/error.hpp>

namespace subcert::cli {
namespace {

std::vector<data::SmoothedColumn> smooth_by_l1(const SmoothOptions& options, const data::Samples& samples,
                                               const DataDependentScheme& scheme, const data::SmoothingOptions& how) {
  if (options.requested_bands.value_or(0) != 0)
    fail(ErrorKind::usage, "--bands needs a linear scheme; {} is none", scheme.specification);
  if (how.boundary == data::Boundary::nearest || how.boundary == data::Boundary::constant)
    fail(ErrorKind::usage, "--boundary {}: expected interp, mirror or wrap for l1 schemes", options.boundary);
  return smooth(samples, scheme, how, options.threads()).columns;
}

SmoothPage smoothed(const SmoothOptions& options, const NamedSamples& samples) {
  const data::SmoothingOptions how{*data::parse_boundary(options.boundary), options.level, options.derivative,
                                   options.constant};
  if (is_l1_specification(options.scheme)) {
    const DataDependentScheme scheme = make_l1_scheme(options.scheme);
    return {options, samples, scheme.specification, {}, smooth_by_l1(options, samples, scheme, how)};
  }
  if (!options.scheme.empty()) {
    const Scheme scheme = make_scheme(options.scheme);
    return {options, samples, scheme.specification, {}, smoothed_columns(samples, scheme, how)};
  }
  const data::SchemeChoice choice = choose_scheme(samples, how);
  return {options, samples, choice.scheme.specification, choice, smoothed_columns(samples, choice.scheme, how)};
}

ExitCode run(const SmoothOptions& options) {
  if (options.automatic && !options.scheme.empty())
    fail(ErrorKind::usage, "--auto and --scheme: expected one of the two");
  if (options.kind() == data::BandKind::prediction && options.derivative > 0)
    fail(ErrorKind::usage, "--bands-kind prediction: a new datum has no derivative; leave out --derivative");
  if (options.kind() != data::BandKind::pointwise && is_l1_specification(options.scheme))
    fail(ErrorKind::usage, "--bands-kind {} needs a linear scheme; {} is none", options.bands_kind, options.scheme);
  require_picture_name(options.plot);
  const NamedSamples samples = read_samples(options.samples);
  try {
    const SmoothPage page = smoothed(options, samples);
    if (!options.plot.empty()) formats::draw_file(page.figure(), options.plot);
    if (options.json)
      options.answer(page.json());
    else
      options.answer([&](std::ostream& stream) { page.write(stream); });
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::data) throw;
    fail(ErrorKind::data, "{}: {}{}", options.samples.name(), error.what(),
         options.scheme.empty() ? "; name one with --scheme" : "");
  }
  return done;
}

}  // namespace

void add_smooth(Command& app) {
  auto options = std::make_shared<SmoothOptions>();
  Command command = add_command(app, "smooth", "Smooths data on a uniform grid by the limit of a scheme, with bands",
                                "subcert smooth samples.csv --bands 0.95 --plot smooth.svg", options,
                                [=] { return run(*options); });
  command
      .option("DATA", options->samples.file,
              "CSV: a column of positions, then one or more of values; - is standard input")
      .required();
  command.option("--scheme", options->scheme, "Scheme specification, also l1:...").suggest(suggested_schemes);
  command.flag("--auto", options->automatic, "Choose the scheme from noise and bias (the default)");
  command.option("--x", options->samples.x, "Column of positions, by name or number; none: 0, 1, 2, ...");
  command.option("--y", options->samples.y, "Columns of values, by name or number").separated_by_commas();
  command.option("--weights", options->samples.weights,
                 "Column of prior weights, inverse to the variance of the noise");
  command.option("--missing", options->samples.missing, "Missing values").one_of({"raise", "drop"}).with_default();
  command.option("--boundary", options->boundary, "How data go on past the ends")
      .one_of(data::smoothing_boundary_names())
      .with_default();
  command.option("--constant", options->constant, "The value of --boundary constant")
      .within(-1e300, 1e300)
      .with_default();
  command
      .option("--bands", options->requested_bands, "Level of the pointwise confidence bands, 0 for none (default 0.95)")
      .within(0.0, 0.999999);
  command
      .option("--bands-kind", options->bands_kind,
              "Bands for the expected value of the limit at each point by itself, or at all points at once; or for a "
              "new datum "
              "of weight 1")
      .one_of(data::band_kind_names())
      .with_default();
  command.option("--level", options->level, "Values at the multiples of arity^-LEVEL of the spacing")
      .within(0, 12)
      .with_default();
  command.option("--derivative", options->derivative, "Order of the derivative").within(0, 20).with_default();
  command.option("--plot", options->plot, "Draw data and result, as .svg or .png");
}

}  // namespace subcert::cli
