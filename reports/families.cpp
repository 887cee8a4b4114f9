#include "collections.hpp"

#include "computed_quantities.hpp"

#include <subcert/analysis/family/property_range.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/papers/registry.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert::reports {
namespace {

constexpr double range_seconds = 30;
const Rational share_left_open(1, 1'000'000);  // of the printed range, about each end
constexpr std::string_view exactly = " exactly";

/// An end of the proved range: up to which number it is proved, and what names the end itself.
struct ProvedEnd {
  Rational proved;
  std::optional<RangeEnd> end;

  std::string text() const {
    const auto zero = end ? zero_of_linear(end->polynomial) : std::nullopt;
    return zero ? subcert::to_text(*zero) : to_decimal(proved, 7, Rounding::nearest);
  }
};

/// The proved pieces about a number, with gaps that are left open between them.
struct ProvedRange {
  ProvedEnd low, high;
  bool has_gaps = false;
};

ProvedEnd end_of(const PropertyRange& range, const Rational& proved) {
  for (const RangeEnd& end : range.ends)
    if (end.low == proved || end.high == proved) return {proved, end};
  return {proved, std::nullopt};
}

std::optional<ProvedRange> proved_about(const PropertyRange& range, const Rational& middle, const Rational& width) {
  const auto& pieces = range.pieces;
  const auto nearest = std::ranges::find_if(pieces, [&](const RangePiece& piece) {
    return piece.holds == Truth::yes && piece.low <= middle + width && middle <= piece.high + width;
  });
  if (nearest == pieces.end()) return std::nullopt;
  auto first = nearest, last = nearest;
  const auto is_bridge = [&](auto gap) { return gap->holds == Truth::unknown && gap->high - gap->low <= width; };
  bool gaps = false;
  while (first - pieces.begin() >= 2 && is_bridge(first - 1) && (first - 2)->holds == Truth::yes)
    first -= 2, gaps = true;
  while (pieces.end() - last > 2 && is_bridge(last + 1) && (last + 2)->holds == Truth::yes) last += 2, gaps = true;
  return ProvedRange{end_of(range, first->low), end_of(range, last->high), gaps};
}

/// Whether a printed end is that of the proved range: the zero itself, or its decimals.
bool agrees(const std::string& printed, const Rational& value, const ProvedEnd& proved) {
  if (!proved.end) return false;
  const RangeEnd& end = *proved.end;
  if (end.low <= value && value <= end.high && end.polynomial(value) == 0) return true;
  const std::size_t point = printed.find('.');
  if (point == std::string::npos) return false;
  const Rational unit = power(Rational(10), -static_cast<long>(printed.size() - point - 1));
  return abs(Rational(end.low - value)) <= unit / 2 && abs(Rational(end.high - value)) <= unit / 2;
}

std::string polynomials_text(const ProvedRange& range, const ParametricScheme& family) {
  std::string text;
  for (const ProvedEnd* proved : {&range.low, &range.high})
    if (proved->end && !zero_of_linear(proved->end->polynomial))
      text += fmt::format("; {} is the zero of {}", proved->text(),
                          family.named(to_text(proved->end->polynomial, family.letter)));
  return text;
}

/// Where the property is refuted for values of the printed range.
void refute(formats::Comparison& comparison, const PropertyRange& range, const ParameterRange& printed) {
  for (const RangePiece& piece : range.pieces)
    if (piece.holds == Truth::no && std::max(piece.low, printed.low) < std::min(piece.high, printed.high)) {
      comparison.verdict = ValueVerdict::mismatch;
      comparison.note = fmt::format("refuted from {} to {}",
                                    to_decimal(std::max(piece.low, printed.low), 7, Rounding::up),
                                    to_decimal(std::min(piece.high, printed.high), 7, Rounding::down));
    }
}

/// The verdict on `C^k for LOW < w < HIGH`, a sufficient condition, or on `exactly for`.
formats::Comparison compare_range(const statements::PublishedCell& cell) {
  const ParametricScheme family = make_parametric_scheme(cell.scheme);
  const std::string& letter = family.name;
  const bool is_exact = cell.quantity.ends_with(exactly);
  const auto property = parse_range_property(
      std::string_view(cell.quantity).substr(0, cell.quantity.size() - (is_exact ? exactly.size() : 0)));
  const auto printed = parse_parameter_range(cell.printed, letter);
  require(printed && property, "families: need a property and a range of {}, got '{}' and '{}'", letter, cell.quantity,
          cell.printed);
  const Rational length = printed->high - printed->low, width = length * share_left_open;
  const PropertyRange found = property_range(family.mask, *property, printed->low - 2 * length,
                                             printed->high + 2 * length, {width, 1, {Deadline::in(range_seconds)}});
  formats::Comparison comparison{cell.row,
                                 cell.column,
                                 family.specification,
                                 cell.printed,
                                 std::string("nothing"),
                                 ValueVerdict::open,
                                 cell.recorded,
                                 "",
                                 ""};
  comparison.source = source_text(cell);
  comparison.command = fmt::format("subcert range '{}' --over {}={}..{} --property {}", family.specification, letter,
                                   to_text(printed->low - 2 * length), to_text(printed->high + 2 * length),
                                   cell.quantity.substr(0, cell.quantity.find(exactly)));
  const auto proved = proved_about(found, (printed->low + printed->high) / 2, width);
  if (proved) comparison.computed = fmt::format("{} < {} < {}", proved->low.text(), letter, proved->high.text());
  const std::size_t at = cell.printed.find(letter);
  const auto digits = [](std::string text) {
    std::erase_if(text, [](char c) { return c == ' ' || c == '<' || c == '='; });
    return text;
  };
  const bool low_agrees = proved && agrees(digits(cell.printed.substr(0, at)), printed->low, proved->low),
             high_agrees = proved && agrees(digits(cell.printed.substr(at + 1)), printed->high, proved->high);
  if (!(is_exact && low_agrees && high_agrees)) refute(comparison, found, *printed);
  if (!proved || comparison.verdict == ValueVerdict::mismatch) return comparison;
  // An open end that agrees is an end of the proved range; all else has to lie inside.
  const bool low_inside = (low_agrees && !printed->low_included) || proved->low.proved <= printed->low,
             high_inside = (high_agrees && !printed->high_included) || printed->high <= proved->high.proved,
             beyond = (proved->low.proved < printed->low && !low_agrees) ||
                      (printed->high < proved->high.proved && !high_agrees);
  const std::string polynomials = polynomials_text(*proved, family);
  if (proved->has_gaps) {
    comparison.note = "gaps inside are open" + polynomials;
  } else if (is_exact && beyond) {
    comparison.verdict = ValueVerdict::mismatch;
    comparison.note = "the proved range is larger" + polynomials;
  } else if (low_inside && high_inside && (!is_exact || (low_agrees && high_agrees))) {
    comparison.verdict = ValueVerdict::match;
    comparison.note = (low_agrees && high_agrees
                           ? std::string("exactly the proved range")
                           : fmt::format("true, but a part of the proved range: {} of it",
                                         to_decimal(length / (proved->high.proved - proved->low.proved), 2,
                                                    Rounding::nearest))) +
                      polynomials;
  } else {
    comparison.note = "an end is not decided" + polynomials;
  }
  return comparison;
}

}  // namespace

Report report_families(const ReportOptions& options) {
  const statements::PublishedTable& published = statements::paper("families").table("ranges");
  formats::Section section{"ranges", "For which values of a parameter: published ranges, and what is proved", {}};
  section.paragraphs.push_back(
      "Ranges of a parameter for which the literature states convergence (C0) or smoothness, with the source of each. "
      "Such a statement is a sufficient condition, unless it says exactly: it matches where it lies in the range that "
      "is proved, and the whole range stands beside it, with the polynomials whose zeros are its ends. It "
      "mismatches where a value in it is refuted.");
  add_published(section, "families", published, compare_range, options.jobs);
  return collection_report("families", std::move(section));
}

}  // namespace subcert::reports
