// subcert range SCHEME --over w=LOW..HIGH --property PROPERTY [--certificate DIR]

#include <subcert/analysis/family/property_range.hpp>
#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/analysis/symbol/real_roots.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/cli/parameter_range.hpp>
#include <subcert/cli/width.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <fmt/format.h>

#include <algorithm>
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

constexpr std::size_t longest_polynomial = 12;  // coefficients, in text

/// The number itself, where it is rational.
std::string zero_text(const LaurentPolynomial& of, const Rational& near, char w) {
  if (const auto zero = zero_of_linear(of)) return to_text(*zero);
  const std::string polynomial = static_cast<std::size_t>(of.length()) <= longest_polynomial
                                     ? to_text(of, w)
                                     : fmt::format("a polynomial of degree {}", of.highest());
  return fmt::format("the zero of {} near {}", polynomial, number_text(near));
}

std::string end_text(const RangeEnd& end, char w) {
  return (zero_of_linear(end.polynomial) ? fmt::format("{} = ", w) : "") + zero_text(end.polynomial, end.low, w);
}

/// Where the values for which the property holds begin or end.
struct Border {
  std::string value;  ///< `0`, `the zero of ...`
  bool included;
};

/// Puts together for which values the property holds, where all pieces, ends and special values leave no more open
/// than the width that was asked for.
class Summary {
 public:
  Summary(const PropertyRange& range, char letter) : range_(range), letter_(letter) {}

  /// `w = 0 and 1 < w <= 2`; `no w`; nothing where some values are open.
  std::optional<std::string> values() {
    for (std::size_t k = 0; k < range_.pieces.size(); ++k)
      if (!add(k)) return std::nullopt;
    if (open_) close({last(), true});
    return text_.empty() ? std::string("no ") + letter_ : text_;
  }
  bool holds_nowhere() const { return text_.empty(); }
  /// `; other w within 1e-10 of 0 are not decided`, or nothing.
  std::string open_values() const {
    if (near_.empty()) return "";
    return fmt::format("; other {} within {} of {} are not decided", letter_, to_decimal(gap_, 2, Rounding::up),
                       fmt::join(near_, ", "));
  }

 private:
  std::string last() const { return number_text(range_.pieces.back().high); }

  bool add(std::size_t k) {
    const RangePiece& piece = range_.pieces[k];
    if (piece.holds == Truth::unknown) return bridge(k);
    if (piece.holds == Truth::yes && !open_) open_ = Border{number_text(piece.low), piece.low_included};
    if (piece.holds == Truth::no && open_) close({number_text(piece.low), !piece.low_included});
    return true;
  }

  /// Over a piece that is not decided: by the one end or value in it.
  bool bridge(std::size_t k) {
    const RangePiece& piece = range_.pieces[k];
    gap_ = std::max(gap_, Rational(piece.high - piece.low));
    const auto inside = [&](const Rational& low, const Rational& high) {
      return piece.low <= low && high <= piece.high;
    };
    std::vector<std::pair<std::string, Truth>> points;
    for (const RangeEnd& end : range_.ends)
      if (inside(end.low, end.high)) points.emplace_back(zero_text(end.polynomial, end.low, letter_), end.holds);
    for (const SpecialValue& value : range_.special)
      if (inside(*value.value.lower, *value.value.upper))
        points.emplace_back(zero_text(value.polynomial, *value.value.lower, letter_), value.holds);
    if (points.size() != 1 || points.front().second == Truth::unknown) return false;
    const auto& [value, holds] = points.front();
    if (piece.low < piece.high) near_.push_back(value);
    const auto holds_in = [&](std::size_t other) {
      return other < range_.pieces.size() && range_.pieces[other].holds == Truth::yes;
    };
    const bool after = holds_in(k + 1), at = holds == Truth::yes;
    if (open_ && !(at && after)) close({value, at});
    if (!open_ && after) open_ = Border{value, at};
    return true;
  }

  void close(const Border& end) {
    text_ += text_.empty() ? "" : " and ";
    if (open_->value == end.value)
      text_ += fmt::format("{} = {}", letter_, end.value);
    else
      text_ += fmt::format("{} {} {} {} {}", open_->value, open_->included ? "<=" : "<", letter_,
                           end.included ? "<=" : "<", end.value);
    open_.reset();
  }

  const PropertyRange& range_;
  char letter_;
  std::optional<Border> open_;
  std::string text_;
  Rational gap_ = 0;               // the width of the widest piece that is not decided
  std::vector<std::string> near_;  // what lies in such pieces
};

/// The answer in one sentence, or nothing.
std::string summary(const PropertyRange& range, const ParameterRangeOptions& options, const ParametricScheme& scheme) {
  Summary summary(range, scheme.parameter);
  const auto values = range.complete ? summary.values() : std::nullopt;
  if (!values) return "";
  const std::string whole = fmt::format("from {} to {}", number_text(range.pieces.front().low),
                                        number_text(range.pieces.back().high));
  const std::string rest = summary.holds_nowhere() ? "" : fmt::format(", and for no other {}", scheme.parameter);
  return fmt::format("{} for {}{} {}{}", options.property, *values, rest, whole, summary.open_values());
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
          {"summary", summary(range, options, scheme)},
          {"pieces", pieces},
          {"ends", ends},
          {"special", special}};
}

std::string text_of(const PropertyRange& range, const ParameterRangeOptions& options, const ParametricScheme& scheme) {
  std::ostringstream page;
  const char w = scheme.parameter;
  page << "scheme       " << scheme.specification << "  (" << scheme.title << ")\n"
       << "property     " << options.property
       << (options.property == "stable" ? ": the integer shifts of the refinable distribution\n" : "\n")
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
    if (open) page << ": " << piece.reason;
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
  if (const std::string text = summary(range, options, scheme); !text.empty()) page << "in short     " << text << "\n";
  return page.str();
}

/// `01-proved.cert` and so on.
std::vector<NamedCertificate> named(const std::vector<RangeCertificate>& certificates) {
  std::vector<NamedCertificate> result;
  for (const RangeCertificate& one : certificates)
    result.push_back({fmt::format("{:02}-{}", result.size() + 1, verdict_text(one.holds)), one.certificate});
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
  if (!options.certificate.empty()) require_folder(options.certificate);
  options.progress("intervals");
  const PropertyRange range = property_range(scheme.mask, *property, low, high,
                                             {*width, options.threads(), options.limits()});
  options.end_progress();
  Json json = json_of(range, options, scheme);
  WrittenCertificates written;
  if (!options.certificate.empty()) {
    const auto certificates = range_certificates(scheme.mask, scheme.parameter, *property, range, *width);
    written = write_certificates(options.certificate, named(certificates), {"-proved", "-refuted"}, json);
  }
  options.answer(json, text_of(range, options, scheme) + written.text);
  written.failure.raise();
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
  command.option("--width", options->width, "Of what is left open about an end").exact_number().with_default();
  command.option("--certificate", options->certificate, "Write a certificate for each decided piece into this folder");
  add_limits(command, *options);
}

}  // namespace subcert::cli
