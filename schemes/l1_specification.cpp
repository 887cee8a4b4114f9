// Specifications of the data-dependent schemes.

#include "outlier_remainder.hpp"
#include "specification_text.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>

#include <fmt/ranges.h>

#include <algorithm>

namespace subcert {
namespace {

using namespace specification_text;

constexpr std::string_view family_name = "l1";
constexpr long most_points[] = {64, 16, 8};  // along an axis of a curve, a grid, a volume
constexpr long largest_arity = 16;
const std::string l1_usage = "l1:points=6,d=1,iterations=6,delta=1e-8";

Rational read_number(const Piece& piece, const std::string& name, bool zero_allowed) {
  const std::optional<Rational> value = parse_number(piece.text);
  const std::string range = zero_allowed ? "0 or from 1e-300 to 1e300" : "from 1e-300 to 1e300";
  if (!value || (*value == 0 ? !zero_allowed : *value < power(Rational(10), -300) || *value > power(Rational(10), 300)))
    fail(piece, name + " " + range + ", as 1e-8 or p/q");
  return *value;
}

std::vector<int> read_points(const Piece& piece) {
  const std::vector<Piece> axes = split(piece, 'x');
  if (axes.size() > 3) fail(piece, "points of a curve, as 6, of a grid, as 6x6, or of a volume, as 4x4x4");
  std::vector<int> points;
  for (const Piece& axis : axes)
    points.push_back(static_cast<int>(read_integer(axis, "points", 2, most_points[axes.size() - 1])));
  return points;
}

std::string points_text(const std::vector<int>& points) { return fmt::format("{}", fmt::join(points, "x")); }

/// Takes the word `exact` from the fields.
bool take_exact(std::vector<Piece>& pieces) {
  const auto is_exact = [](const Piece& piece) { return piece.text == "exact"; };
  const auto first = std::find_if(pieces.begin(), pieces.end(), is_exact);
  if (first == pieces.end()) return false;
  const auto second = std::find_if(first + 1, pieces.end(), is_exact);
  if (second != pieces.end()) fail(*second, "each key once");
  pieces.erase(first);
  return true;
}

void require_no_fits(Fields& fields, const std::vector<Piece>& pieces) {
  for (const std::string_view key : {"iterations", "delta", "tolerance", "residuals", "remainder"})
    if (fields.optional(key)) {
      const auto at = std::find_if(pieces.begin(), pieces.end(),
                                   [&](const Piece& piece) { return piece.text.substr(0, key.size()) == key; });
      fail(*at, "points, d and a alone beside 'exact', which makes no reweighted fits");
    }
}

/// The number of fits for iterations=auto.
int automatic_iterations(const Piece& piece, const L1Scheme& scheme, const Rational& remainder) {
  if (scheme.points.size() != 1) fail(piece, "a number of iterations; auto is for curves");
  const int points = scheme.points[0];
  if (points <= scheme.degree + 1 || outlier_factor(points, scheme.degree) >= 1)
    fail(piece, "a number of iterations, or more points: no number of fits leaves out every outlier among " +
                    std::to_string(points));
  const std::optional<int> count = iterations_for_remainder(points, scheme.degree, remainder, scheme.arity);
  if (!count) fail(piece, "a number of iterations, or a larger remainder: 1000 fits are not proved to suffice");
  return *count;
}

void read_iterations(Fields& fields, DataDependentScheme& result) {
  const auto piece = fields.optional("iterations");
  const auto remainder = fields.optional("remainder");
  if (remainder && (!piece || piece->text != "auto")) fail(*remainder, "remainder beside iterations=auto alone");
  if (!piece) return;
  int& iterations = result.rules.options.iterations;
  if (piece->text == "auto") {
    Rational part(1, 1'000'000);
    if (remainder) part = read_number(*remainder, "remainder", false);
    iterations = automatic_iterations(*piece, result.rules, part);
    result.choice = "iterations=auto: " + std::to_string(iterations) + " fits leave at most " + to_short_text(part) +
                    " of a far outlier, wherever it stands";
  } else {
    iterations = static_cast<int>(read_integer(*piece, "iterations", 0, 1'000'000));
  }
}

}  // namespace

bool is_l1_specification(std::string_view specification) {
  return specification.substr(0, specification.find(':')) == family_name;
}

DataDependentScheme make_l1_scheme(std::string_view specification) {
  const std::size_t colon = specification.find(':');
  const Piece family{specification.substr(0, colon), 0};
  if (family.text != family_name) fail(family, "the family l1, as in " + l1_usage);
  if (colon == std::string_view::npos) fail(family, l1_usage);
  const Piece body{specification.substr(colon + 1), colon + 1};
  std::vector<Piece> pieces = body.text.empty() ? std::vector<Piece>{} : split(body, ',');
  const bool exact = take_exact(pieces);
  Fields fields(family, pieces, l1_usage);

  DataDependentScheme result;
  L1Scheme& scheme = result.rules;
  scheme.points = read_points(fields.required("points"));
  const int least = *std::min_element(scheme.points.begin(), scheme.points.end());
  if (const auto piece = fields.optional("d"))
    scheme.degree = static_cast<int>(read_integer(*piece, "d", 0, std::min(3, least - 1)));
  if (const auto piece = fields.optional("a"))
    scheme.arity = static_cast<int>(read_integer(*piece, "a", 2, largest_arity));
  const bool binary = scheme.arity == 2;
  const std::string window = "points=" + points_text(scheme.points) + ",d=" + std::to_string(scheme.degree) +
                             (binary ? "" : ",a=" + std::to_string(scheme.arity));
  const std::string words = points_text(scheme.points) + " points, degree " + std::to_string(scheme.degree) +
                            (binary ? "" : ", arity " + std::to_string(scheme.arity));
  if (exact) {
    if (scheme.points.size() != 1) fail(fields.required("points"), "points of a curve, as 6, beside 'exact'");
    require_no_fits(fields, pieces);
    fields.finish();
    scheme.options.exact = true;
    result.specification = "l1:" + window + ",exact";
    result.title = "least absolute deviations, " + words;
    return result;
  }
  read_iterations(fields, result);
  Rational delta(1, 100'000'000), tolerance = 0;
  if (const auto piece = fields.optional("delta")) delta = read_number(*piece, "delta", false);
  if (const auto piece = fields.optional("tolerance")) tolerance = read_number(*piece, "tolerance", true);
  if (const auto piece = fields.optional("residuals")) {
    if (piece->text != "separate" && piece->text != "joint") fail(*piece, "residuals=separate or residuals=joint");
    scheme.options.joint_residuals = piece->text == "joint";
  }
  fields.finish();
  scheme.options.delta = static_cast<double>(delta);
  scheme.options.tolerance = static_cast<double>(tolerance);
  result.specification = "l1:" + window + ",iterations=" + std::to_string(scheme.options.iterations) +
                         ",delta=" + to_short_text(delta) +
                         (tolerance == 0 ? "" : ",tolerance=" + to_short_text(tolerance)) +
                         (scheme.options.joint_residuals ? ",residuals=joint" : "");
  result.title = "local l1 regression, " + words + ", " + std::to_string(scheme.options.iterations) + " iterations";
  return result;
}

}  // namespace subcert
