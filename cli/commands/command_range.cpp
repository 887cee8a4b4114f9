// subcert range SCHEME --over w=LOW..HIGH --property PROPERTY [--certificate DIR]

#include <subcert/analysis/family/property_range.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/cli/paper_form.hpp>
#include <subcert/cli/parameter_range.hpp>
#include <subcert/cli/width.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/reports/facts/range_summary.hpp>
#include <subcert/reports/facts/screen_lines.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <fmt/format.h>

#include <sstream>
#include <utility>

namespace subcert::cli {
namespace {

constexpr const char* properties =
    "convergent, C1, C2, ..., HC1, ... of Hermite schemes, holder>=P/Q, sobolev>=P/Q, stable, positive, monotone or "
    "convex";

struct ParameterRangeOptions : SearchOptions {
  std::string scheme;
  std::string over;
  std::string property;
  std::string width = "1e-9";
  std::string certificate;
  PaperForm form;
};

std::string as_latex(const std::string& formula) { return "$" + formats::latex_formula(formula) + "$"; }

/// `$C^{1}$`, `$\\alpha \\ge 3/2$`, or the word.
std::string property_latex(const std::string& property) {
  if (property.starts_with('C')) return as_latex("C^" + property.substr(1));
  for (const auto& [name, letter] : {std::pair{"holder", "alpha"}, {"sobolev", "s"}})
    if (property.starts_with(name)) return as_latex(letter + property.substr(std::string_view(name).size()));
  return property;
}

std::string end_text(const RangeEnd& end, const ParametricScheme& scheme) {
  return (zero_of_linear(end.polynomial) ? scheme.name + " = " : "") + zero_text(end.polynomial, end.low, scheme);
}

/// The answer in one sentence, or nothing.
std::string summary(const PropertyRange& range, const ParameterRangeOptions& options, const ParametricScheme& scheme) {
  return range_summary(range, scheme, options.property).value_or("");
}

/// The same in LaTeX, or what is not decided.
std::string latex_of(const PropertyRange& range, const ParameterRangeOptions& options, const ParametricScheme& scheme) {
  const std::string head = "% " + scheme.specification + ", " + options.over + "\n";
  const auto text = range_summary(range, scheme, property_latex(options.property), as_latex);
  if (text) return head + *text + "\n";
  formats::TableRows rows{{"from", "to", "verdict"}};
  for (const RangePiece& piece : range.pieces) {
    const bool open = piece.holds == Truth::unknown, one = piece.low == piece.high;
    const int digits = digits_apart(piece.low, piece.high);
    rows.push_back({as_latex((piece.low_included ? "" : "> ") +
                             number_text(piece.low, open || one ? Rounding::down : Rounding::up, digits)),
                    as_latex((piece.high_included ? "" : "< ") +
                             number_text(piece.high, open || one ? Rounding::up : Rounding::down, digits)),
                    verdict_text(piece.holds)});
  }
  return head + "% " + property_latex(options.property) + ", needs \\usepackage{booktabs}\n" +
         formats::latex_tabular(rows, "l");
}

Json json_of(const PropertyRange& range, const ParameterRangeOptions& options, const ParametricScheme& scheme) {
  Json pieces = Json::array(), ends = Json::array(), special = Json::array();
  for (const RangePiece& piece : range.pieces)
    pieces.push_back({{"from", to_text(piece.low)},
                      {"to", to_text(piece.high)},
                      {"from_included", piece.low_included},
                      {"to_included", piece.high_included},
                      {"verdict", verdict_text(piece.holds)},
                      {"reason", piece.reason}});
  for (const RangeEnd& end : range.ends)
    ends.push_back({{"lower", to_text(end.low)},
                    {"upper", to_text(end.high)},
                    {"polynomial", scheme.named(to_text(end.polynomial, scheme.letter))},
                    {"product", word_text(end.word)},
                    {"verdict", verdict_text(end.holds)}});
  for (const SpecialValue& value : range.special)
    special.push_back({{"value", enclosure_json(value.value)},
                       {"polynomial", scheme.named(to_text(value.polynomial, scheme.letter))},
                       {"why", why_text(value.why)},
                       {"verdict", verdict_text(value.holds)}});
  return {{"family", scheme.specification},
          {"property", options.property},
          {"sum_rules", range.sum_rules},
          {"summary", summary(range, options, scheme)},
          {"pieces", pieces},
          {"ends", ends},
          {"special", special}};
}

std::string text_of(const PropertyRange& range, const ParameterRangeOptions& options, const ParametricScheme& scheme) {
  std::ostringstream page;
  const std::string& w = scheme.name;
  page << "scheme       " << scheme.specification << "  (" << scheme.title << ")\n";
  if (const std::string text = summary(range, options, scheme); !text.empty()) page << "answer       " << text << "\n";
  page << "property     " << options.property
       << (options.property == "stable" ? ": the integer shifts of the refinable distribution\n" : "\n")
       << "sum rules    " << range.sum_rules << " for all " << w << "\n";
  for (const RangePiece& piece : range.pieces) {
    page << padded(verdict_text(piece.holds), 13);
    // What is said of a piece is true as it is printed.
    const bool open = piece.holds == Truth::unknown;
    const int digits = digits_apart(piece.low, piece.high);
    if (piece.low == piece.high)
      page << w << " = " << number_text(piece.low);
    else
      page << number_text(piece.low, open ? Rounding::down : Rounding::up, digits)
           << (piece.low_included ? " <= " : " < ") << w << (piece.high_included ? " <= " : " < ")
           << number_text(piece.high, open ? Rounding::up : Rounding::down, digits);
    if (open && piece.low < piece.high)
      page << "  (width " << to_decimal(piece.high - piece.low, 2, Rounding::up) << ")";
    if (open) page << ": " << piece.reason;
    page << "\n";
  }
  for (const RangeEnd& end : range.ends)
    page << "end          " << end_text(end, scheme) << ", where "
         << (end.word.empty() ? "the spectral radius" : "the radius of the product " + word_text(end.word))
         << " crosses the threshold"
         << (end.holds == Truth::unknown ? "" : fmt::format("; {} there", verdict_text(end.holds))) << "\n";
  for (const SpecialValue& value : range.special)
    page << "special      " << w << " = " << number_text(value.value) << ": " << why_text(value.why) << "; "
         << verdict_text(value.holds) << " there\n";
  return facts::wrapped(page.str(), 13);
}

/// `01-proved.cert` and so on.
std::vector<NamedCertificate> named(const std::vector<RangeCertificate>& certificates) {
  std::vector<NamedCertificate> result;
  for (const RangeCertificate& one : certificates)
    result.push_back({fmt::format("{:02}-{}", result.size() + 1, verdict_text(one.holds)), one.certificate});
  return result;
}

ExitCode run(const ParameterRangeOptions& options) {
  require_one_form(options, options.form);
  const ParametricScheme scheme = make_parametric_scheme(options.scheme);
  const auto property = parse_range_property(options.property);
  if (!property) fail(ErrorKind::usage, "--property: expected {}, got '{}'", properties, options.property);
  const auto [low, high] = read_over(options.over, scheme.name);
  const auto width = parse_number(options.width);
  if (!width || !(*width > 0))
    fail(ErrorKind::usage, "--width: expected a positive number, as 1e-9 or 1/1000, got '{}'", options.width);
  if (!options.certificate.empty()) require_folder(options.certificate);
  options.progress("intervals");
  const Budget budget = options.limits();
  const PropertyRange range = property_range(scheme.mask, *property, low, high, {*width, options.threads(), budget});
  options.end_progress();
  Json json = json_of(range, options, scheme);
  WrittenCertificates written;
  if (!options.certificate.empty()) {
    const auto certificates = range_certificates(scheme.mask, scheme.letter, *property, range, *width);
    written = write_certificates(options.certificate, named(certificates), {"-proved", "-refuted"}, "this property",
                                 json);
  }
  if (options.form.latex)
    options.answer(latex_of(range, options, scheme));
  else
    options.answer(json, text_of(range, options, scheme) + written.text);
  written.failure.raise();
  return exit_code(range.complete ? Truth::yes : Truth::unknown, !budget.deadline.expired());
}

}  // namespace

void add_range(Command& app) {
  auto options = std::make_shared<ParameterRangeOptions>();
  Command command = add_command(app, "range", "For which values of its parameter a scheme has a property, with proof",
                                "subcert range four-point:w --over w=-1..1 --property C1", options,
                                [=] { return run(*options); });
  add_family(command, options->scheme, options->over);
  command.option("--property", options->property, properties).required();
  command.option("--width", options->width, "Of what is left open about an end").exact_number().with_default();
  command.option("--certificate", options->certificate, "Write a certificate for each decided piece into this folder");
  add_limits(command, *options);
  add_paper_form(command, options->form, "The answer as a sentence in LaTeX, or a table of the pieces");
}

}  // namespace subcert::cli
