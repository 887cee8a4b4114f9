// subcert range SCHEME --over w=LOW..HIGH --property PROPERTY [--certificate DIR]

#include "command.hpp"
#include "exponent_text.hpp"
#include "parameter_range.hpp"

#include <subcert/analysis/family/property_range.hpp>
#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/analysis/symbol/real_roots.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <fmt/format.h>

#include <sstream>

namespace subcert::cli {
namespace {

constexpr const char* properties =
    "convergent, C1, C2, ..., holder>=P/Q, sobolev>=P/Q, stable, positive, monotone or convex";

struct ParameterRangeOptions : SearchOptions {
  std::string scheme;
  std::string over;
  std::string property;
  std::string width = "1e-9";
  std::string certificate;
};

Json json_of(const PropertyRange& range, const ParameterRangeOptions& options, const ParametricScheme& scheme) {
  Json pieces = Json::array(), ends = Json::array(), special = Json::array();
  for (const RangePiece& piece : range.pieces)
    pieces.push_back({{"from", to_text(piece.low)},
                      {"to", to_text(piece.high)},
                      {"from_included", piece.low_included},
                      {"to_included", piece.high_included},
                      {"verdict", verdict_text(piece.holds)}});
  for (const RangeEnd& end : range.ends)
    ends.push_back({{"lower", to_text(end.low)},
                    {"upper", to_text(end.high)},
                    {"polynomial", to_text(end.polynomial, scheme.parameter)},
                    {"product", word_text(end.word)},
                    {"verdict", verdict_text(end.holds)}});
  for (const SpecialValue& value : range.special)
    special.push_back({{"value", enclosure_json(value.value)},
                       {"polynomial", to_text(value.polynomial, scheme.parameter)},
                       {"why", why_text(value.why)},
                       {"verdict", verdict_text(value.holds)}});
  return {{"family", scheme.specification},
          {"property", options.property},
          {"sum_rules", range.sum_rules},
          {"pieces", pieces},
          {"ends", ends},
          {"special", special}};
}

constexpr std::size_t longest_polynomial = 12;  // coefficients, in text

/// The number itself, where it is rational.
std::string end_text(const RangeEnd& end, char w) {
  if (const auto zero = zero_of_linear(end.polynomial)) return fmt::format("{} = {}", w, to_text(*zero));
  const std::string polynomial = static_cast<std::size_t>(end.polynomial.length()) <= longest_polynomial
                                     ? to_text(end.polynomial, w)
                                     : fmt::format("a polynomial of degree {}", end.polynomial.highest());
  return fmt::format("the zero of {} near {}", polynomial, number_text(end.low));
}

std::string text_of(const PropertyRange& range, const ParameterRangeOptions& options, const ParametricScheme& scheme) {
  std::ostringstream page;
  const char w = scheme.parameter;
  page << "scheme       " << scheme.specification << "  (" << scheme.title << ")\n"
       << "property     " << options.property << "\n"
       << "sum rules    " << range.sum_rules << " for all " << w << "\n";
  for (const RangePiece& piece : range.pieces) {
    page << padded(verdict_text(piece.holds), 13);
    // What is said of a piece is true as it is printed.
    const bool open = piece.holds == Truth::unknown;
    if (piece.low == piece.high)
      page << w << " = " << number_text(piece.low);
    else
      page << number_text(piece.low, open ? Rounding::down : Rounding::up) << (piece.low_included ? " <= " : " < ") << w
           << (piece.high_included ? " <= " : " < ") << number_text(piece.high, open ? Rounding::up : Rounding::down);
    if (open && piece.low < piece.high)
      page << "  (width " << to_decimal(piece.high - piece.low, 2, Rounding::up) << ")";
    page << "\n";
  }
  for (const RangeEnd& end : range.ends)
    page << "end          " << end_text(end, w) << ", where "
         << (end.word.empty() ? "the spectral radius" : "the radius of the product " + word_text(end.word))
         << " crosses the threshold"
         << (end.holds == Truth::unknown ? "" : fmt::format("; {} there", verdict_text(end.holds))) << "\n";
  for (const SpecialValue& value : range.special)
    page << "special      " << w << " = " << number_text(value.value) << ": " << why_text(value.why) << "; "
         << verdict_text(value.holds) << " there\n";
  return page.str();
}

/// `01-proved.cert` and so on.
std::vector<NamedCertificate> named(const std::vector<RangeCertificate>& certificates) {
  std::vector<NamedCertificate> result;
  for (const RangeCertificate& one : certificates)
    result.push_back({fmt::format("{:02}-{}", result.size() + 1, verdict_text(one.holds)), one.certificate.text});
  return result;
}

ExitCode run(const ParameterRangeOptions& options) {
  const ParametricScheme scheme = make_parametric_scheme(options.scheme);
  const auto property = parse_range_property(options.property);
  if (!property) fail(ErrorKind::usage, "--property: expected {}, got '{}'", properties, options.property);
  const auto [low, high] = read_over(options.over, scheme.parameter);
  const auto width = parse_number(options.width);
  if (!width || !(*width > 0))
    fail(ErrorKind::usage, "--width: expected a positive number, as 1e-9 or 1/1000, got '{}'", options.width);
  options.progress("intervals");
  const PropertyRange range = property_range(scheme.mask, *property, low, high,
                                             {*width, options.threads(), options.limits()});
  options.end_progress();
  std::string note;
  if (!options.certificate.empty()) {
    const auto certificates = range_certificates(scheme.mask, scheme.parameter, *property, range, *width);
    note = write_certificates(options.certificate, named(certificates), {"-proved", "-refuted"});
  }
  options.answer(json_of(range, options, scheme), text_of(range, options, scheme) + note);
  return range.complete ? done : undecided;
}

}  // namespace

void add_range(Command& app) {
  auto options = std::make_shared<ParameterRangeOptions>();
  Command command = add_command(app, "range", "For which values of its parameter a scheme has a property, with proof",
                                "subcert range four-point:w --over w=-1..1 --property C1", options,
                                [=] { return run(*options); });
  command
      .option("SCHEME", options->scheme, "mask:[-w,0,1/2+w,1,1/2+w,0,-w], four-point:w and other families, any letter")
      .required()
      .suggest(suggested_schemes);
  command.option("--over", options->over, "The values: w=LOW..HIGH").required();
  command.option("--property", options->property, properties).required();
  command.option("--width", options->width, "Of what is left open about an end").with_default();
  command.option("--certificate", options->certificate, "Write a certificate for each decided piece into this folder");
  add_limits(command, *options);
}

}  // namespace subcert::cli
