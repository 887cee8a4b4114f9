// subcert smooth DATA

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/pages/plot.hpp>
#include <subcert/cli/pages/smooth_figure.hpp>
#include <subcert/cli/pages/smooth_grid.hpp>
#include <subcert/cli/pages/smooth_mesh.hpp>
#include <subcert/schemes/data/formats/mesh_file.hpp>
#include <subcert/schemes/data/l1/l1_remarks.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/data/smooth/smoothing_stream.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

namespace subcert::cli {
namespace {

data::SmoothedSamples smoothed(const SmoothOptions& options, const data::NamedSamples& samples,
                               const std::vector<double>& places) {
  data::SmoothingOptions how{*data::parse_boundary(options.boundary), options.level, options.derivative,
                             options.constant, options.at == "data"};
  how.path = options.kind() == data::BandKind::simultaneous;
  if (options.select == "cv") how.selection = data::Selection::cross_validation;
  if (options.requested_bands.value_or(0) != 0) how.resamples = bootstrap_drawings;
  how.seed = options.seed;
  how.places = places;
  return smooth(samples, options.scheme, how, options.threads());
}

/// Columns, also of several groups, that are as no linear method takes them well, or have noise that is not as bands
/// suppose.
class RemarksOnData {
 public:
  void add(const data::NamedSamples& samples, const data::SmoothedSamples& result) {
    // Of a derivative of values with slopes it is these that were looked at.
    const std::size_t looked_at = samples.slopes ? samples.names.size() - result.columns.size() : 0;
    for (std::size_t c = 0; c < result.columns.size(); ++c) {
      const std::string name = samples.names[looked_at + c] + (samples.group.empty() ? "" : " of " + samples.group);
      if (const auto& correlation = result.columns[c].correlated) correlated_.emplace_back(name, *correlation);
      if (const std::size_t count = result.columns[c].outliers; count > 0) outliers_.emplace_back(name, count);
    }
  }

  /// A line for each kind.
  void tell(const SmoothOptions& options) const {
    if (!correlated_.empty()) options.remark(data::remark_on_correlations(correlated_));
    if (outliers_.empty()) return;
    const auto& [name, count] = outliers_.front();
    constexpr const char* leaves = "(more than six deviations from both sides); --scheme local:d=1,robust=3 leaves";
    if (outliers_.size() == 1)
      return options.remark(fmt::format("{}: {} this fit, its bands and the choice of its window {} {} out", name,
                                        count == 1 ? "1 outlier moves" : fmt::format("{} outliers move", count), leaves,
                                        count == 1 ? "it" : "them"));
    std::vector<std::string> names;
    for (const auto& [each, number] : outliers_) names.push_back(fmt::format("{} ({})", each, number));
    options.remark(fmt::format("{}: outliers move these fits, their bands and the choice of their windows {} them out",
                               fmt::join(names, ", "), leaves));
  }

 private:
  std::vector<std::pair<std::string, double>> correlated_;
  std::vector<std::pair<std::string, std::size_t>> outliers_;
};

/// What data-dependent schemes cannot do.
void require_l1(const SmoothOptions& options) {
  const std::string scheme = make_l1_scheme(options.scheme).specification;
  if (options.kind() != data::BandKind::pointwise)
    fail(ErrorKind::usage, "--bands-kind {} needs a linear scheme; {} is none", options.bands_kind, scheme);
  if (options.boundary == "nearest" || options.boundary == "constant")
    fail(ErrorKind::usage, "--boundary {}: expected interp, mirror or wrap for l1 schemes", options.boundary);
}

/// Writes values as soon as their data have come.
void smooth_stream(const SmoothOptions& options, const std::optional<double>& noise) {
  if (options.scheme.empty()) fail(ErrorKind::usage, "--stream needs --scheme: the choice needs all data");
  if (options.json || !options.plot.empty() || options.at != "grid" || options.at_positions() ||
      options.irregular == "fit" || !options.samples.by.empty() || options.samples.series == "rows")
    fail(ErrorKind::usage,
         "--stream: expected none of --json, --plot, --at, --at-file, --irregular fit, --by, --series rows");
  if (!noise && options.requested_bands.value_or(0) != 0)
    fail(ErrorKind::usage, "--stream: --bands needs --noise, as its estimate needs all data");
  if (options.kind() == data::BandKind::simultaneous)
    fail(ErrorKind::usage, "--stream: --bands-kind simultaneous needs all data");
  data::SampleStream input(options.samples);
  data::NamedSamples head = input.head();
  head.noise = noise;
  const data::SmoothingOptions how{*data::parse_boundary(options.boundary), options.level, options.derivative,
                                   options.constant};
  data::SmoothingStream stream(head, data::make_smoothing_method(options.scheme), how, input.weighted());
  options.answer([&](std::ostream& out) {
    bool headed = false;
    const auto write = [&](data::SmoothedSamples values) {
      if (values.positions.empty()) return;
      const SmoothPage page(options, head, std::move(values));
      if (!headed) {
        page.write_comments(out);
        page.write_header(out);
      }
      headed = true;
      page.write_rows(out);
      out << std::flush;
    };
    while (out) {  // nobody waits for more than can be written
      const auto rows = input.next();
      if (!rows) break;
      stream.add(rows->columns, rows->weights);
      write(stream.take());
    }
    write(stream.finish());
  });
}

/// Whether all data have one weight and a uniform grid.
bool are_even(const std::vector<data::NamedSamples>& groups) {
  return std::ranges::all_of(
      groups, [](const data::NamedSamples& samples) { return samples.uniform() && samples.weights.empty(); });
}

bool takes_any_positions(const SmoothOptions& options) {
  if (options.irregular != "auto") return options.irregular == "fit";
  return data::takes_any_positions(options.scheme);
}

/// Why these samples cannot be smoothed.
std::string reason(const SmoothOptions& options, const data::NamedSamples& samples, const Error& error) {
  if (!samples.refused.empty()) return samples.refused;
  return options.samples.name() + ": " + error.what();
}

/// One line for groups that are left out for the same reason.
void remark_on_refused(const SmoothOptions& options, const RefusedGroups& refused) {
  std::map<std::string, std::string> groups;
  for (const auto& [group, why] : refused) groups[why] += (groups[why].empty() ? " " : ", ") + group;
  for (const auto& [why, names] : groups) options.remark(options.samples.by + names + ", left out: " + why);
}

/// What --closed stands for.
void take_closed(SmoothOptions& options) {
  if (options.boundary != data::smoothing_boundary_names().front() && options.boundary != "wrap")
    fail(ErrorKind::usage, "--closed and --boundary {}: expected one of the two; closed data have no ends",
         options.boundary);
  options.boundary = "wrap";
  if (options.samples.x.empty() && options.samples.series == "columns") options.samples.x = "none";
}

/// Refuses what does not go together.
void require_one_question(const SmoothOptions& options) {
  if (options.automatic && !options.scheme.empty())
    fail(ErrorKind::usage, "--auto and --scheme: expected one of the two");
  if (!options.at_file.empty() && options.at != "grid")
    fail(ErrorKind::usage, "--at {} and --at-file: expected one of the two", options.at);
  if (options.kind() == data::BandKind::prediction && options.derivative > 0)
    fail(ErrorKind::usage, "--bands-kind prediction: a new datum has no derivative; leave out --derivative");
  if (is_l1_specification(options.scheme)) require_l1(options);
  if (options.kind() == data::BandKind::prediction && data::is_robust_specification(options.scheme))
    fail(ErrorKind::usage,
         "--bands-kind prediction: a new datum may be an outlier, of which robust steps know nothing");
}

/// Refuses what values with slopes are not smoothed by.
void require_values_with_slopes(const SmoothOptions& options) {
  if (!options.samples.slopes) {
    if (!options.slope_noise.empty()) fail(ErrorKind::usage, "--slope-noise needs --hermite");
    return;
  }
  if (options.grid || options.stream || options.samples.series == "rows")
    fail(ErrorKind::usage, "--hermite: expected none of --grid, --stream, --series rows");
  if (!data::takes_any_positions(options.scheme))
    fail(ErrorKind::usage, "--hermite: expected local polynomials, as --scheme local:points=21,d=3; found {}",
         options.scheme);
  if (options.boundary != "interp" && options.boundary != "wrap")
    fail(ErrorKind::usage, "--boundary {}: expected interp or wrap with --hermite", options.boundary);
  if (!options.slope_noise.empty() && data::finds_its_noise(options.scheme))
    fail(ErrorKind::usage, "--slope-noise: robust steps find the noise by themselves");
}

/// A standard deviation, where one is given.
std::optional<Rational> deviation(const char* option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  auto noise = parse_number(text);
  if (!noise || !data::is_noise(data::nearest_double(*noise)))
    fail(ErrorKind::usage, "{} {}: expected a standard deviation from 1e-150 to 1e150", option, text);
  return noise;
}

ExitCode run(const SmoothOptions& options) {
  require_one_question(options);
  require_values_with_slopes(options);
  std::optional<Rational> noise = deviation("--noise", options.noise);
  const std::optional<Rational> slope_noise = deviation("--slope-noise", options.slope_noise);
  if (!noise && !options.samples.errors.empty() && !data::finds_its_noise(options.scheme)) noise = 1;  // their unit
  require_picture_name(options.plot);
  if (!options.grid && data::mesh_format(options.samples.file)) {
    smooth_mesh_file(options);
    return done;
  }
  const auto given = options.given();
  if (std::find(given.begin(), given.end(), "--steps") != given.end())
    fail(ErrorKind::usage, "--steps: {} is no mesh; expected one of OBJ, PLY, OFF or STL", options.samples.name());
  if (options.grid) {
    smooth_grid_file(options, noise ? std::optional(data::nearest_double(*noise)) : std::nullopt);
    return done;
  }
  if (options.samples.missing == "keep")
    fail(ErrorKind::usage, "--missing keep: expected --grid, or drop; of rows --at data has values where data are");
  if (!options.samples.keep.empty() && options.at != "data")
    fail(ErrorKind::usage, "--keep needs --at data: other rows have no fields of the table");
  if (!options.scheme.empty()) data::make_smoothing_method(options.scheme);  // a misspelt one before faults of the data
  if (options.stream) {
    smooth_stream(options, noise ? std::optional(data::nearest_double(*noise)) : std::nullopt);
    return done;
  }
  data::SampleOptions how_read = options.samples;
  how_read.any_positions = takes_any_positions(options);
  std::vector<data::NamedSamples> groups = data::read_samples(how_read);
  if (is_l1_specification(options.scheme))
    for (const std::string& line : data::remarks(make_l1_scheme(options.scheme), are_even(groups)))
      options.remark(line);
  if (options.irregular == "auto" &&
      std::ranges::any_of(groups, [](const data::NamedSamples& samples) { return !samples.uniform(); }))
    options.remark("the positions are not uniform and are taken as they are (--irregular raise refuses them)");
  std::optional<data::GivenPositions> positions;
  if (options.at_positions())
    positions = options.at_file.empty() ? data::GivenPositions::of_list(options.at)
                                        : data::GivenPositions::of_file(options.samples, options.at_file);
  std::vector<std::unique_ptr<SmoothPage>> pages;
  std::set<std::string> remarks;  // of several groups alike
  const auto remark_once = [&](const std::string& line) {
    if (remarks.insert(line).second) options.remark(line);
  };
  RemarksOnData of_data;
  std::size_t outside = 0;
  RefusedGroups refused;
  for (data::NamedSamples& samples : groups) {
    std::ranges::for_each(samples.remarks, remark_once);
    if (noise) samples.noise = data::nearest_double(*noise);
    if (slope_noise) samples.slope_noise = data::nearest_double(*slope_noise);
    const std::vector<double> places = positions ? positions->of(samples) : std::vector<double>();
    try {
      if (!samples.refused.empty()) fail(ErrorKind::data, "{}", samples.refused);
      data::SmoothedSamples result = smoothed(options, samples, places);
      of_data.add(samples, result);
      outside = std::max(outside, result.outside);
      if (result.choice && samples.names.size() > (samples.slopes ? 2 : 1))
        remark_once(fmt::format("one method is chosen for all columns together; --y {} chooses it for one alone",
                                samples.slopes ? "NAME,SLOPE" : "NAME"));
      pages.push_back(std::make_unique<SmoothPage>(options, samples, std::move(result)));
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::data) throw;
      refused.emplace_back(samples.group, reason(options, samples, error));
    }
  }
  if (pages.empty())
    fail(ErrorKind::data, "{}{}{}",
         options.samples.by.empty() ? "" : options.samples.by + " " + refused[0].first + ": ", refused[0].second,
         refused.size() > 1 ? "; nor can other groups be smoothed" : "");
  of_data.tell(options);
  if (outside > 0)
    options.remark(
        fmt::format("positions not between the first datum and the last, where values are nan: {}", outside));
  remark_on_refused(options, refused);
  if (!options.plot.empty()) formats::draw_file(figure_of(pages), options.plot);
  if (options.json)
    options.answer(smooth_json(pages, refused));
  else
    options.answer([&](std::ostream& stream) { write(pages, stream); });
  return refused.empty() ? done : bad_data;
}

/// How DATA are read.
void add_table_options(Command& command, data::SampleOptions& samples) {
  command.option("--x", samples.x, "Column of positions, by name or number; none: 0, 1, 2, ...");
  command.option("--y", samples.y, "Columns of values, by name or number").separated_by_commas();
  command.option("--weights", samples.weights, "Column of prior weights, inverse to the variance of the noise");
  command.option("--errors", samples.errors,
                 "Column of standard deviations of the noise, in place of --weights and --noise");
  command.option("--by", samples.by, "Column of the names of groups, each smoothed by itself");
  command.option("--keep", samples.keep, "Columns that go into the answer as they are, with --at data")
      .separated_by_commas();
  command.option(
      "--delimiter", samples.delimiter,
      "Between the columns: a character, tab or blank (default: the first of ; tab , that the first row has)");
  command.option("--decimal", samples.decimal, "Decimal mark").one_of({".", ","}).with_default();
  command.option("--header", samples.header, "Whether the first row has the names of the columns")
      .one_of({"auto", "yes", "no"})
      .with_default();
  command
      .option("--series", samples.series,
              "What is one series: a column, or a row, whose positions are the names of the columns, and which --by "
              "names")
      .one_of({"columns", "rows"})
      .with_default();
  command
      .option("--missing", samples.missing,
              "Missing values: an error, left out, or with --grid left out and kept missing")
      .one_of({"raise", "drop", "keep"})
      .with_default();
}

}  // namespace

void add_smooth(Command& app) {
  auto options = std::make_shared<SmoothOptions>();
  Command command = add_command(app, "smooth", "Smooths data by the limit of a scheme or local polynomials, with bands",
                                "subcert smooth samples.csv --bands 0.95 --plot smooth.svg", options, [=] {
                                  if (options->closed) take_closed(*options);
                                  return run(*options);
                                });
  options->given = [command] { return command.given(); };
  command
      .option("DATA", options->samples.file,
              "CSV: a column of positions, then one or more of values; - is standard input")
      .required();
  command.option("--scheme", options->scheme, "Scheme specification, also local:... and l1:...")
      .suggest(suggested_schemes);
  command.flag("--auto", options->automatic, "Choose the method from noise and bias (the default)");
  command.option("--select", options->select, "By what: the estimated error, or cross-validation")
      .one_of({"risk", "cv"})
      .with_default();
  add_table_options(command, options->samples);
  command
      .option("--irregular", options->irregular,
              "Positions that are not uniform, or several data at one: an error, or taken as they are, as auto does "
              "where no scheme is named that needs uniform ones")
      .one_of({"auto", "raise", "fit"})
      .with_default();
  command
      .option("--spacing", options->samples.spacing,
              "Of the output grid where positions are irregular (default: that of most neighbours, or the mean), or of "
              "the data of a stream")
      .exact_number();
  command
      .option("--at", options->at,
              "Where values stand: grid, that of --level, data, or positions as 1,2.5,7; nan outside the data")
      .with_default();
  command.option("--at-file", options->at_file,
                 "Table of the positions where values stand, in the column named as those of DATA, or the first");
  command.option("--noise", options->noise, "Its standard deviation for weight 1, where it is known").exact_number();
  command.flag("--hermite", options->samples.slopes,
               "The columns are values, and then as many of their slopes by the position, as for refine: both are "
               "fitted together");
  command.option("--slope-noise", options->slope_noise, "The standard deviation of the noise of slopes for weight 1")
      .exact_number();
  command.option("--boundary", options->boundary, "How data go on past the ends")
      .one_of(data::smoothing_boundary_names())
      .with_default();
  command.flag("--closed", options->closed,
               "The last row is followed by the first, and unless --x names a column rows are counted: --boundary wrap "
               "--x none");
  command.option("--constant", options->constant, "The value of --boundary constant")
      .within(-1e300, 1e300)
      .with_default();
  command.option("--bands", options->requested_bands, "Level of the confidence bands, 0 for none (default 0.95)")
      .share(0.999999);
  command
      .option("--bands-kind", options->bands_kind,
              "Bands for the expected value of the limit at each point by itself, or at all points at once; or for a "
              "new datum of weight 1")
      .one_of(data::band_kind_names())
      .with_default();
  command.option("--level", options->level, "Values at the multiples of arity^-LEVEL of the spacing")
      .within(0, 12)
      .with_default();
  command.option("--steps", options->steps, "Of a mesh: times that its vertices are moved by the rules of --scheme")
      .within(1, 1000)
      .with_default();
  command.option("--derivative", options->derivative, "Order of the derivative").within(0, 20).with_default();
  command.flag("--grid", options->grid,
               "DATA is a matrix of heights, or a volume in a .vtk file; --scheme works along each axis");
  command.flag("--stream", options->stream,
               "Write values as soon as their data have come, in memory that does not grow");
  command.option("--plot", options->plot, "Draw data, result and residuals, as .svg, .png, .pdf, .tex or .html");
}

}  // namespace subcert::cli
