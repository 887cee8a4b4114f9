// subcert range SCHEME --over w=LOW..HIGH --property PROPERTY [--certificate DIR]

#include <subcert/analysis/family/property_range.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/cli/paper_form.hpp>
#include <subcert/cli/parameter_range.hpp>
#include <subcert/cli/width.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/reports/facts/screen_lines.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <functional>
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

constexpr std::size_t longest_polynomial = 12;  // coefficients, in text
const Rational small(1, 1'000'000);             // share of the range, of pieces that are open after the time

/// How formulas are printed.
using Formula = std::function<std::string(const std::string&)>;
std::string as_text(const std::string& formula) { return formula; }
std::string as_latex(const std::string& formula) { return "$" + formats::latex_formula(formula) + "$"; }

/// The number itself, where it is rational.
std::string zero_text(const LaurentPolynomial& of, const Rational& near, const ParametricScheme& scheme,
                      const Formula& formula = as_text) {
  if (const auto zero = zero_of_linear(of)) return to_text(*zero);
  const std::string polynomial = static_cast<std::size_t>(of.length()) <= longest_polynomial
                                     ? formula(scheme.named(to_text(of, scheme.letter)))
                                     : fmt::format("a polynomial of degree {}", of.highest());
  return fmt::format("the zero of {} near {}", polynomial, formula(number_text(near)));
}

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

/// Where the values for which the property holds begin or end.
struct Border {
  std::string value;  ///< `0`, `the zero of ...`
  bool included;
};

/// Puts together for which values the property holds, where all pieces, ends and special values leave no more open
/// than the width that was asked for, or little.
class Summary {
 public:
  Summary(const PropertyRange& range, const ParametricScheme& scheme, Formula formula)
      : range_(range), scheme_(scheme), formula_(std::move(formula)), name_(formula_(scheme.name)) {}

  /// `C1 exactly for 0 < w < r, r the zero of 32*w^3 + 4*w - 1 near 0.19`; nothing where some values are open.
  std::optional<std::string> sentence(const std::string& property) {
    for (std::size_t k = 0; k < range_.pieces.size(); ++k)
      if (!add(k)) return std::nullopt;
    if (open_) close({last(), true});
    if (!range_.complete && gap_ > (range_.pieces.back().high - range_.pieces.front().low) * small) return std::nullopt;
    const std::string among = fmt::format(" from {} to {}", formula_(number_text(range_.pieces.front().low)),
                                          formula_(last()));
    std::string text = values_.empty() ? fmt::format("{} for no {}", property, name_)
                       : near_.empty() && left_open_ == 0
                           ? fmt::format("{} exactly for {}, of all {}", property, values_, name_)
                           : fmt::format("{} for {}, and for no other {}", property, values_, name_);
    text += among;
    std::string near;
    for (const std::string& value : near_) near += (near.empty() ? "" : ", ") + formula_(value);
    if (!near.empty())
      text += fmt::format("; open on both sides within {} of {}", to_decimal(gap_, 2, Rounding::up), near);
    if (left_open_ > 0)
      text += fmt::format("; open in {} other piece{} of at most {}", left_open_, left_open_ == 1 ? "" : "s",
                          to_decimal(gap_, 2, Rounding::up));
    for (const auto& [meaning, name] : roots_) text += fmt::format("; {} is {}", formula_(name), meaning);
    return text;
  }

 private:
  std::string last() const { return number_text(range_.pieces.back().high); }

  /// A rational number, or a name for a zero.
  std::string value_text(const LaurentPolynomial& of, const Rational& near) {
    std::string text = zero_text(of, near, scheme_, formula_);
    if (zero_of_linear(of)) return text;
    for (const auto& [meaning, name] : roots_)
      if (meaning == text) return name;
    std::string name = roots_.empty() ? "r" : fmt::format("r{}", roots_.size() + 1);
    if (name == scheme_.name) name = "r1";
    roots_.emplace_back(std::move(text), name);
    return name;
  }

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
      if (inside(end.low, end.high)) points.emplace_back(value_text(end.polynomial, end.low), end.holds);
    for (const SpecialValue& value : range_.special)
      if (inside(*value.value.lower, *value.value.upper))
        points.emplace_back(value_text(value.polynomial, *value.value.lower), value.holds);
    if (points.empty()) return leave_open(k);
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

  /// Between two pieces with one verdict.
  bool leave_open(std::size_t k) {
    if (k == 0 || k + 1 >= range_.pieces.size()) return false;
    const Truth before = range_.pieces[k - 1].holds;
    ++left_open_;
    return before != Truth::unknown && before == range_.pieces[k + 1].holds;
  }

  void close(const Border& end) {
    values_ += values_.empty() ? "" : " and ";
    values_ += formula_(open_->value == end.value
                            ? fmt::format("{} = {}", scheme_.name, end.value)
                            : fmt::format("{} {} {} {} {}", open_->value, open_->included ? "<=" : "<", scheme_.name,
                                          end.included ? "<=" : "<", end.value));
    open_.reset();
  }

  const PropertyRange& range_;
  const ParametricScheme& scheme_;
  Formula formula_;
  std::string name_;  // of the parameter, as a formula
  std::optional<Border> open_;
  std::string values_;                                      // `w = 0 and 1 < w <= 2`
  Rational gap_ = 0;                                        // the width of the widest piece that is not decided
  int left_open_ = 0;                                       // such pieces without a value that is decided
  std::vector<std::string> near_;                           // what lies in such pieces
  std::vector<std::pair<std::string, std::string>> roots_;  // what they are, and their names
};

/// The answer in one sentence, or nothing.
std::string summary(const PropertyRange& range, const ParameterRangeOptions& options, const ParametricScheme& scheme) {
  return Summary(range, scheme, as_text).sentence(options.property).value_or("");
}

/// The same in LaTeX, or what is not decided.
std::string latex_of(const PropertyRange& range, const ParameterRangeOptions& options, const ParametricScheme& scheme) {
  const std::string head = "% " + scheme.specification + ", " + options.over + "\n";
  const auto text = Summary(range, scheme, as_latex).sentence(property_latex(options.property));
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
