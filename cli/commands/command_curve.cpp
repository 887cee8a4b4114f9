// subcert curve SCHEME --over w=LOW..HIGH [--plot FILE] [--csv FILE] [--certificate DIR]

#include <subcert/cli/pages/plot.hpp>
#include <subcert/cli/paper_form.hpp>
#include <subcert/cli/parameter_range.hpp>
#include <subcert/cli/width.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/reports/facts/exponents.hpp>
#include <subcert/reports/facts/screen_lines.hpp>
#include <subcert/schemes/data/runtime/files.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace subcert::cli {
namespace {

struct CurveCommandOptions : SearchOptions {
  std::string scheme;
  std::string over;
  std::string plot;
  std::string csv;
  std::string certificate;
  int pieces = 200;
  PaperForm form;
};

const char* convergence_text(const Enclosure& exponent) {
  if (exponent.lower && *exponent.lower > 0) return "convergent";
  return exponent.upper && *exponent.upper <= 0 ? "divergent" : "undecided";
}

std::string product_text(const CurvePiece& piece) {
  return piece.proof.below ? word_text(piece.proof.below->word) : "";
}

/// The largest exponent of all values: between which numbers it lies, and between which values alone it can be.
struct Largest {
  Enclosure exponent;
  Rational low, high;
};

/// Nothing where no exponent is proved to be positive. What has no upper end may be anything.
std::optional<Largest> largest_of(const ExponentCurve& curve) {
  struct Part {
    Enclosure exponent;
    Rational low, high;
  };
  std::vector<Part> parts;
  for (const CurvePiece& piece : curve.pieces)
    parts.push_back({positive_part(piece.exponent), piece.proof.low, piece.proof.high});
  for (const CurvePoint& point : curve.special)
    parts.push_back(
        {positive_part(point.exponent.value_or(Enclosure{})), *point.at.value.lower, *point.at.value.upper});
  std::optional<Rational> least, most = Rational(0);
  for (const Part& part : parts) {
    if (part.exponent.lower && (!least || *part.exponent.lower > *least)) least = part.exponent.lower;
    most = most && part.exponent.upper ? std::optional(std::max(*most, *part.exponent.upper)) : std::nullopt;
  }
  if (!least || *least <= 0) return std::nullopt;
  std::optional<Largest> result;
  for (const Part& part : parts) {
    if (part.exponent.upper && *part.exponent.upper < *least) continue;
    if (!result) result = Largest{{least, most}, part.low, part.high};
    result->low = std::min(result->low, part.low);
    result->high = std::max(result->high, part.high);
  }
  return result;
}

Json json_of(const ExponentCurve& curve, const ParametricScheme& scheme) {
  Json pieces = Json::array(), special = Json::array();
  for (const CurvePiece& piece : curve.pieces)
    pieces.push_back({{"from", to_text(piece.proof.low)},
                      {"to", to_text(piece.proof.high)},
                      {"holder", enclosure_json(positive_part(piece.exponent))},
                      {"product", product_text(piece)},
                      {"convergence", convergence_text(piece.exponent)},
                      {"reason", piece.proof.reason}});
  for (const CurvePoint& point : curve.special)
    special.push_back({{"value", enclosure_json(point.at.value)},
                       {"polynomial", scheme.named(to_text(point.at.polynomial, scheme.letter))},
                       {"why", why_text(point.at.why)},
                       {"holder", enclosure_json(positive_part(point.exponent.value_or(Enclosure{})))}});
  Json json{{"family", scheme.specification}, {"sum_rules", curve.sum_rules}, {"pieces", pieces}, {"special", special}};
  if (const auto largest = largest_of(curve))
    json["largest"] = {
        {"holder", enclosure_json(largest->exponent)}, {"from", to_text(largest->low)}, {"to", to_text(largest->high)}};
  return json;
}

std::string csv_of(const ExponentCurve& curve) {
  std::string text = "from,to,lower,upper,product,convergence\n";
  for (const CurvePiece& piece : curve.pieces) {
    const Enclosure holder = positive_part(piece.exponent);
    text += fmt::format("{},{},{},{},{},{}\n", to_text(piece.proof.low), to_text(piece.proof.high),
                        holder.lower ? holder.lower_text(15) : "", holder.upper ? holder.upper_text(15) : "",
                        product_text(piece), convergence_text(piece.exponent));
  }
  return text;
}

/// `; exponent 2`, or nothing where none is known.
std::string exponent_text(const CurvePoint& point) {
  const Enclosure exponent = positive_part(point.exponent.value_or(Enclosure{}));
  return exponent.lower || exponent.upper ? "; exponent " + enclosure_text(exponent, 8) : "";
}

/// Pieces side by side with one product and one verdict on convergence.
struct Run {
  const char* convergence;
  Rational low, high;
  Enclosure hull;
  std::string product;
  std::string reasons;

  /// `; product 01`, or why there is none.
  std::string evidence() const {
    return !product.empty() ? "product " + product
           : hull.upper     ? "the upper end from the sum rules"
                            : "no upper end is proved";
  }
};

std::vector<Run> runs_of(const ExponentCurve& curve) {
  std::vector<Run> runs;
  for (const CurvePiece& piece : curve.pieces) {
    const Enclosure holder = positive_part(piece.exponent);
    const char* convergence = convergence_text(piece.exponent);
    const bool goes_on = !runs.empty() && runs.back().product == product_text(piece) &&
                         std::string_view(runs.back().convergence) == convergence;
    if (!goes_on)
      runs.push_back({convergence, piece.proof.low, piece.proof.high, holder, product_text(piece), piece.proof.reason});
    Run& run = runs.back();
    run.high = piece.proof.high;
    if (run.reasons.find(piece.proof.reason) == std::string::npos)
      run.reasons += (run.reasons.empty() ? "" : "; ") + piece.proof.reason;
    Enclosure& hull = run.hull;
    hull.lower = hull.lower && holder.lower ? std::optional(std::min(*hull.lower, *holder.lower)) : std::nullopt;
    hull.upper = hull.upper && holder.upper ? std::optional(std::max(*hull.upper, *holder.upper)) : std::nullopt;
  }
  return runs;
}

/// What is said of a run is true as it is printed.
std::string values_text(const Run& run, const std::string& name) {
  return fmt::format("{} <= {} <= {}", number_text(run.low, Rounding::up), name, number_text(run.high, Rounding::down));
}

std::string special_text(const CurvePoint& point) { return why_text(point.at.why) + exponent_text(point); }

std::string text_of(const ExponentCurve& curve, const ParametricScheme& scheme) {
  std::ostringstream page;
  const std::string& w = scheme.name;
  page << "scheme       " << scheme.specification << "  (" << scheme.title << ")\n"
       << "sum rules    " << curve.sum_rules << " for all " << w << "\n"
       << "pieces       " << curve.pieces.size() << "\n";
  double widest = 0;
  for (const CurvePiece& piece : curve.pieces)
    if (const Enclosure holder = positive_part(piece.exponent); holder.is_bounded())
      widest = std::max(widest, Rational(*holder.upper - *holder.lower).convert_to<double>());
  const bool bounded = std::any_of(curve.pieces.begin(), curve.pieces.end(),
                                   [](const CurvePiece& piece) { return positive_part(piece.exponent).is_bounded(); });
  page << "envelopes    "
       << (bounded ? fmt::format("{:.2g} apart, or less", widest) : "none, as no piece has both ends") << "\n";
  for (const Run& run : runs_of(curve)) {
    page << padded(run.convergence, 13) << values_text(run, w);
    if (run.hull.lower || run.hull.upper) page << ": exponent " << enclosure_text(run.hull, 5);
    page << ", " << run.evidence() << (run.reasons.empty() ? "" : " (" + run.reasons + ")") << "\n";
  }
  if (const auto largest = largest_of(curve)) {
    const bool is_point = largest->low == largest->high;
    page << "largest      exponent " << enclosure_text(largest->exponent, 5) << ", "
         << (is_point ? fmt::format("at {} = {}", w, number_text(largest->low))
                      : fmt::format("within {} <= {} <= {}", number_text(largest->low, Rounding::down), w,
                                    number_text(largest->high, Rounding::up)))
         << "\n";
  }
  for (const CurvePoint& point : curve.special)
    page << "special      " << w << " = " << number_text(point.at.value) << ": " << special_text(point) << "\n";
  return facts::wrapped(page.str(), 13);
}

/// The same for papers.
formats::TableRows rows_of(const ExponentCurve& curve, const ParametricScheme& scheme) {
  formats::TableRows rows{{scheme.name, "scheme", "exponent", "by"}};
  for (const Run& run : runs_of(curve))
    rows.push_back({values_text(run, scheme.name), run.convergence,
                    run.hull.lower || run.hull.upper ? enclosure_text(run.hull, 5) : "-", run.evidence()});
  for (const CurvePoint& point : curve.special)
    rows.push_back({scheme.name + " = " + number_text(point.at.value), "special", "", special_text(point)});
  return rows;
}

/// Both envelopes in runs without gaps, what lies between them, and the exponents at single values.
void draw(const ExponentCurve& curve, const ParametricScheme& scheme, const std::string& file) {
  const auto number = [](const Rational& value) { return value.convert_to<double>(); };
  formats::Panel panel{scheme.specification, scheme.name, "Hoelder exponent", {}};
  struct Envelope {
    const char *label, *colour;
    std::optional<Rational> Enclosure::*end;
  };
  for (const Envelope& envelope :
       {Envelope{"at least", "#0b559f", &Enclosure::lower}, Envelope{"at most", "#c0392b", &Enclosure::upper}}) {
    bool joined = false, labelled = false;
    for (const CurvePiece& piece : curve.pieces) {
      const Enclosure exponent = positive_part(piece.exponent);
      const auto& end = exponent.*envelope.end;
      if (end) {
        if (!joined) panel.curves.push_back({labelled ? "" : envelope.label, {}, false, true, envelope.colour});
        labelled = true;
        for (const Rational& w : {piece.proof.low, piece.proof.high})
          panel.curves.back().points.emplace_back(number(w), number(*end));
      }
      joined = end.has_value();
    }
  }
  formats::Band enclosed{"enclosed", {}};
  for (const CurvePiece& piece : curve.pieces)
    if (const Enclosure exponent = positive_part(piece.exponent); exponent.is_bounded()) {
      const bool goes_on = !enclosed.ends.empty() && enclosed.ends.back()[0] == number(piece.proof.low);
      if (!goes_on && !enclosed.ends.empty()) panel.bands.push_back(std::exchange(enclosed, {"", {}}));
      for (const Rational& w : {piece.proof.low, piece.proof.high})
        enclosed.ends.push_back({number(w), number(*exponent.lower), number(*exponent.upper)});
    }
  if (!enclosed.ends.empty()) panel.bands.push_back(std::move(enclosed));
  for (formats::Band& band : panel.bands) band.colour = "#0b559f";
  formats::Curve points{"single values", {}, true, false, "#1e8449"};
  for (const CurvePoint& point : curve.special)
    if (point.exponent && point.exponent->lower && *point.exponent->lower > 0)
      points.points.emplace_back(number(*point.at.value.lower), number(*point.exponent->lower));
  if (!points.points.empty()) panel.curves.push_back(std::move(points));
  if (panel.curves.empty())
    fail(ErrorKind::domain, "--plot {}: there is no exponent to draw, as no scheme is proved to converge", file);
  formats::draw_file({"curve", scheme.specification, "", 1, {panel}}, file);
}

ExitCode run(const CurveCommandOptions& options) {
  require_one_form(options, options.form);
  require_picture_name(options.plot);
  const ParametricScheme scheme = make_parametric_scheme(options.scheme);
  const auto [low, high] = read_over(options.over, scheme.name);
  if (!options.certificate.empty()) require_folder(options.certificate);
  options.progress("pieces");
  const ExponentCurve curve = exponent_curve(scheme.mask, low, high,
                                             {options.pieces, options.threads(), options.limits()});
  options.end_progress();
  Json json = json_of(curve, scheme);
  WrittenCertificates written;
  if (!options.csv.empty()) runtime::write_file(options.csv, csv_of(curve));
  if (!options.certificate.empty()) {
    std::vector<NamedCertificate> certificates;
    for (const RangeCertificate& one : curve_certificates(scheme.mask, scheme.letter, curve))
      certificates.push_back({fmt::format("{:05}-piece", certificates.size() + 1), one.certificate});
    written = write_certificates(options.certificate, certificates, {"-piece"}, "these pieces", json);
  }
  if (!options.plot.empty()) draw(curve, scheme, options.plot);
  if (options.form.asked_for())
    answer(options, options.form, TableAnswer{"% " + scheme.specification + "\n", rows_of(curve, scheme), {0}});
  else
    options.answer(json, text_of(curve, scheme) + written.text);
  written.failure.raise();
  return static_cast<int>(curve.pieces.size()) == options.pieces ? done : undecided;
}

}  // namespace

void add_curve(Command& app) {
  auto options = std::make_shared<CurveCommandOptions>();
  Command command = add_command(
      app, "curve", "The exponent of a family over its parameter, between certified envelopes",
      "subcert curve four-point:w --over w=0..1/4 --plot curve.svg", options, [=] { return run(*options); });
  add_family(command, options->scheme, options->over);
  command.option("--pieces", options->pieces, "Intervals, more of them where the envelopes are far apart")
      .within(1, 100'000)
      .with_default();
  command.option("--plot", options->plot, "Draw both envelopes, as .svg, .png, .pdf, .tex or .html");
  command.option("--csv", options->csv, "Write the pieces as a table");
  command.option("--certificate", options->certificate, "Write a certificate for each piece into this folder");
  add_limits(command, *options);
  add_paper_form(command, options->form, "The rows of the answer as a table in LaTeX", "The same in Markdown");
}

}  // namespace subcert::cli
