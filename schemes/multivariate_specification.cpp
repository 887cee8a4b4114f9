// Specifications of two and three variables: tensor products and fits on grids; and of any kind.

#include "grid_regression.hpp"
#include "specification_text.hpp"

#include <algorithm>
#include <limits>

namespace subcert {
namespace {

using namespace specification_text;

constexpr long max_coefficients = 100'000;

const FamilyHelp tensor_help{"tensor", "tensor:(primal:n=3)x(dual:n=2)",
                             "tensor product of two or three schemes of one variable and one arity"};
const FamilyHelp grid_help{"grid", "grid:points=4x4,d=3",
                           "least squares of total degree d on a grid of data, as 4x4, 5x5 or 4x4x4; optional a=2"};

/// The specifications in `(A)x(B)` or `(A)x(B)x(C)`.
std::vector<Piece> read_factors(const Piece& body) {
  const std::string expected = "two or three specifications in parentheses, as (primal:n=3)x(dual:n=2)";
  std::vector<Piece> factors;
  for (std::size_t at = 0;;) {
    if (at >= body.text.size() || body.text[at] != '(') fail({body.text.substr(at), body.at + at}, expected);
    int depth = 0;
    std::size_t end = at;
    do {
      if (body.text[end] == '(') ++depth;
      if (body.text[end] == ')') --depth;
      ++end;
    } while (depth > 0 && end < body.text.size());
    if (depth > 0) fail({body.text.substr(at), body.at + at}, "a closing parenthesis");
    factors.push_back({body.text.substr(at + 1, end - at - 2), body.at + at + 1});
    if (end == body.text.size()) break;
    if (body.text[end] != 'x') fail({body.text.substr(end), body.at + end}, "an x between the factors");
    at = end + 1;
  }
  if (factors.size() < 2 || factors.size() > 3) fail(body, expected);
  return factors;
}

MultivariateScheme make_tensor(const Piece& body) {
  MultivariateScheme result{"tensor:", "tensor product", {MultivariatePolynomial(2, 1), 2}, {}};
  long coefficients = 1;
  for (const Piece& factor : read_factors(body)) {
    try {
      const Scheme scheme = make_scheme(factor.text);
      if (!result.factors.empty() && scheme.mask.arity() != result.factors[0].arity())
        fail(factor, "a scheme of arity " + std::to_string(result.factors[0].arity()) + " like the first");
      result.specification += (result.factors.empty() ? "(" : "x(") + scheme.specification + ")";
      coefficients *= scheme.mask.symbol().length();
      result.factors.push_back(scheme.mask);
    } catch (const SpecificationError& error) {
      if (error.position() > factor.at) throw;
      throw SpecificationError(error.token(), factor.at + error.position(), error.expected());
    }
    if (coefficients > max_coefficients)
      fail(factor, "factors with at most " + std::to_string(max_coefficients) + " coefficients in all");
  }
  result.mask = tensor_product(result.factors);
  return result;
}

MultivariateScheme make_grid(const Piece& family, const Piece& body) {
  Fields fields(family, body, grid_help.usage);
  const Piece points_piece = fields.required("points");
  GridRegression scheme;
  std::string points;
  long coefficients = 1, longest = 0;
  const auto arity_piece = fields.optional("a");
  scheme.arity = arity_piece ? static_cast<int>(read_integer(*arity_piece, "a", 2, max_arity)) : 2;
  for (const Piece& piece : split(points_piece, 'x')) {
    const long count = read_integer(piece, "points", 2, max_points);
    if (scheme.points.size() == 3) fail(points_piece, "two or three numbers of points, as 4x4");
    scheme.points.push_back(static_cast<int>(count));
    points += (points.empty() ? "" : "x") + std::to_string(count);
    coefficients *= scheme.arity * count;
    longest = std::max(longest, count);
    if (coefficients > max_coefficients)
      fail(points_piece,
           "at most " + std::to_string(max_coefficients) + " coefficients (points times a along each axis)");
  }
  if (scheme.points.size() < 2) fail(points_piece, "two or three numbers of points, as 4x4");
  if (const auto piece = fields.optional("d")) {
    const long degree = read_integer(*piece, "d", 0, std::numeric_limits<std::int32_t>::max());
    if (coefficients * std::min(degree, longest - 1) > 5 * max_work)
      fail(*piece, "a degree d with (coefficients) * d <= " + std::to_string(5 * max_work) + " (here " +
                       std::to_string(coefficients) + " coefficients)");
    scheme.degree = static_cast<int>(degree);
  }
  fields.finish();
  std::string text = "grid:points=" + points + ",d=" + std::to_string(scheme.degree);
  if (scheme.arity != 2) text += ",a=" + std::to_string(scheme.arity);
  return {text,
          points + "-point least squares scheme of total degree " + std::to_string(scheme.degree) +
              (scheme.arity == 2 ? "" : ", arity " + std::to_string(scheme.arity)),
          grid_regression_mask(scheme),
          {}};
}

}  // namespace

LinearScheme make_linear_scheme(std::string_view specification) {
  const std::size_t colon = specification.find(':');
  const Piece family{specification.substr(0, colon), 0};
  if (family.text != tensor_help.family && family.text != grid_help.family) {
    std::string known;
    for (const auto* list : {&families(), &multivariate_families()})
      for (const FamilyHelp& help : *list) {
        known += (known.empty() ? "" : ", ") + help.family;
        if (help.family == family.text) return make_scheme(specification);
      }
    if (family.text == "l1") fail(family, "a linear scheme, one of " + known + "; l1 schemes only act on data");
    fail(family, "one of " + known + "; for data also l1");
  }
  if (specification.size() > max_text) fail({specification, 0}, "at most " + std::to_string(max_text) + " characters");
  const bool tensor = family.text == tensor_help.family;
  if (colon == std::string_view::npos) fail(family, (tensor ? tensor_help : grid_help).usage);
  const Piece body{specification.substr(colon + 1), colon + 1};
  return tensor ? make_tensor(body) : make_grid(family, body);
}

AnyScheme make_any_scheme(std::string_view specification) {
  if (is_l1_specification(specification)) return make_l1_scheme(specification);
  return std::visit([](auto scheme) -> AnyScheme { return scheme; }, make_linear_scheme(specification));
}

const std::string& specification_of(const AnyScheme& scheme) {
  return std::visit([](const auto& one) -> const std::string& { return one.specification; }, scheme);
}

std::vector<Mask> axis_masks(const AnyScheme& scheme) {
  if (const auto* univariate = std::get_if<Scheme>(&scheme)) return {univariate->mask};
  if (const auto* multivariate = std::get_if<MultivariateScheme>(&scheme)) return multivariate->factors;
  return {};
}

const std::vector<FamilyHelp>& multivariate_families() {
  static const std::vector<FamilyHelp> help{tensor_help, grid_help};
  return help;
}

std::string to_mask_text(const MultivariateMask& mask) {
  const auto lowest = mask.symbol().lowest(), highest = mask.symbol().highest();
  const std::size_t variables = lowest.size();
  std::vector<std::size_t> sizes;
  std::size_t count = 1;
  for (std::size_t v = 0; v < variables; ++v) {
    sizes.push_back(static_cast<std::size_t>(highest[v] - lowest[v] + 1));
    count *= sizes.back();
  }
  std::vector<Rational> dense(count, 0);
  Integer common = 1;
  for (const auto& term : mask.symbol().terms()) {
    std::size_t at = 0;
    for (std::size_t v = variables; v-- > 0;)
      at = at * sizes[v] + static_cast<std::size_t>(term.exponents[v] - lowest[v]);
    dense[at] = term.coefficient;
    common = lcm(common, denominator(term.coefficient));
  }
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t run = 1;  // numbers in the lists that begin or end here
    for (std::size_t v = 0; v < variables && i % (run *= sizes[v]) == 0; ++v) text += '[';
    text += to_text(Rational(dense[i] * common));
    run = 1;
    for (std::size_t v = 0; v < variables && (i + 1) % (run *= sizes[v]) == 0; ++v) text += ']';
    if (i + 1 < count) text += ',';
  }
  if (common != 1) text += "/" + to_text(Rational(common));
  for (std::size_t v = 0; v < variables; ++v) text += (v ? "," : "@") + std::to_string(lowest[v]);
  return text;
}

}  // namespace subcert
