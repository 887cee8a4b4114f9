#include "specification.hpp"

#include "classical.hpp"
#include "nearby_mask.hpp"
#include "regression_text.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>

namespace subcert {
namespace {

using namespace specification_text;

constexpr std::size_t most_nearby = 200;

std::string number(long value) { return std::to_string(value); }

using Preset = LocalRegression (*)(int, int);

Scheme least_squares(const std::string& family, const std::string& title, bool odd, Preset preset, Fields& fields) {
  const long n = read_integer(fields.required("n"), "n", 1, (max_points - 1) / 2);
  const long points = odd ? 2 * n + 1 : 2 * n;
  const long degree = read_degree(fields, points);
  fields.finish();
  const LocalRegression rules = preset(static_cast<int>(n), static_cast<int>(degree));
  return {family + ":n=" + number(n) + ",d=" + number(degree),
          title + ", " + number(points) + " points, degree " + number(degree), regression_mask(rules), rules};
}

Scheme make_primal(Fields& f) { return least_squares("primal", "primal least squares scheme", false, primal, f); }
Scheme make_dual(Fields& f) { return least_squares("dual", "dual least squares scheme", false, dual, f); }
Scheme make_primal_odd(Fields& f) {
  return least_squares("primal-odd", "primal least squares scheme", true, primal_odd, f);
}
Scheme make_dual_odd(Fields& f) { return least_squares("dual-odd", "dual least squares scheme", true, dual_odd, f); }

Scheme make_ary(Fields& fields) {
  const long arity = read_integer(fields.required("a"), "a", 2, max_arity);
  const Piece points_piece = fields.required("points");
  const long points = read_integer(points_piece, "points", 2, max_points);
  if (arity * points > 4 * max_points) fail(points_piece, "a * points <= " + number(4 * max_points));
  const long degree = read_degree(fields, points);
  fields.finish();
  const LocalRegression rules = ary(static_cast<int>(arity), static_cast<int>(points), static_cast<int>(degree));
  return {"ary:a=" + number(arity) + ",points=" + number(points) + ",d=" + number(degree),
          number(arity) + "-ary least squares scheme, " + number(points) + " points, degree " + number(degree),
          regression_mask(rules), rules};
}

Scheme make_deslauriers_dubuc(Fields& fields) {
  const long n = read_integer(fields.required("n"), "n", 1, 200);
  const auto arity_piece = fields.optional("a");
  const long arity = arity_piece ? read_integer(*arity_piece, "a", 2, max_arity) : 2;
  fields.finish();
  return {"dd:n=" + number(n) + (arity == 2 ? "" : ",a=" + number(arity)),
          "interpolatory Deslauriers-Dubuc " + number(2 * n) + "-point scheme" +
              (arity == 2 ? "" : ", arity " + number(arity)),
          deslauriers_dubuc_mask(static_cast<int>(n), static_cast<int>(arity))};
}

Scheme make_bspline(Fields& fields) {
  const Piece degree_piece = fields.required("degree");
  const long degree = read_integer(degree_piece, "degree", 1, 2000);
  const auto arity_piece = fields.optional("a");
  const long arity = arity_piece ? read_integer(*arity_piece, "a", 2, max_arity) : 2;
  if (const auto multiplicity = fields.optional("multiplicity")) fail(*multiplicity, numbers_only);
  fields.finish();
  if (arity * degree > 8000) fail(degree_piece, "a * degree <= 8000");
  return {"bspline:degree=" + number(degree) + (arity == 2 ? "" : ",a=" + number(arity)),
          "B-spline of degree " + number(degree) + (arity == 2 ? "" : ", arity " + number(arity)),
          bspline_mask(static_cast<int>(degree), static_cast<int>(arity))};
}

Scheme make_pseudo_spline(Fields& fields) {
  const Piece order = fields.required("m");
  const Rational m = read_rational(order);
  if (m < 1 || m > 100 || denominator(Rational(2 * m)) != 1) fail(order, "a multiple m of 1/2 with 1 <= m <= 100");
  const long l = read_integer(fields.required("l"), "l", 0, ceil_index(m) - 1);
  fields.finish();
  const std::string text = to_text(m);
  return {"pseudo-spline:m=" + text + ",l=" + number(l),
          (denominator(m) == 1 ? "pseudo-spline of type II and order (" : "dual pseudo-spline of order (") + text +
              ", " + number(l) + ")",
          pseudo_spline_mask(m, static_cast<int>(l))};
}

/// One scheme of each family, by the number that takes the place of its letter.
Family at_numbers(const ClassicalFamily& family) {
  return {{family.name, family.name + ":w=" + family.example, family.title + " w"},
          from_fields([&family](Fields& fields) {
            const Rational w = read_rational(fields.required("w"));
            fields.finish();
            return Scheme{family.name + ":w=" + to_text(w), family.title + " " + to_text(w), family.mask().at(w)};
          })};
}

/// f'_{a i + k} = the fit on the k-th stencil, evaluated at the k-th position.
Scheme make_regression(Fields& fields) {
  const auto weight = [](const Piece& piece) {
    Rational value = read_rational(piece);
    if (value <= 0) fail(piece, "a weight > 0");
    return value;
  };
  const auto [scheme, text, points, digits, stencils] = read_regression<Rational>(
      fields, read_rational, weight, [](const Rational& value) { return to_text(value); });
  // Long numbers make long masks: their digits multiply with the degree.
  const long effective = std::min<long>(scheme.degree, points - 1);
  const bool weighted = !scheme.rules.front().weights.empty();
  if ((weighted || digits > 6) && points * effective * effective * static_cast<long>(digits) > max_long_work)
    fail(stencils, "points * d^2 * (digits of the longest position or weight) <= " + number(max_long_work));
  fields.finish();
  return {text, "local regression of degree " + number(scheme.degree), regression_mask(scheme), scheme};
}

Scheme make_daubechies(Fields& fields) {
  const long n = read_integer(fields.required("n"), "n", 1, 40);
  fields.finish();
  const RoundedMask rounded = daubechies_mask(static_cast<int>(n));
  Scheme scheme{"daubechies:n=" + number(n),
                "orthonormal scaling function D" + number(2 * n) + " of Daubechies, coefficients rounded",
                rounded.mask};
  if (rounded.rounding.distance > 0) scheme.rounding = rounded.rounding;
  // Those that are of small degree over the rationals.
  static const std::map<long, std::string> known{
      {2, "mask:[1+t,3+t,3-t,1-t]/4,where=t^2-3:1..2"},
      {3, "mask:[t^2+2*t-3,t^2+6*t+5,30-2*t^2+4*t,30-2*t^2-4*t,t^2-6*t+5,t^2-2*t-3]/32,where=t^4-10*t^2-15:3..4"}};
  if (const auto field = known.find(n); field != known.end()) scheme.algebraic = make_scheme(field->second).algebraic;
  return scheme;
}

Scheme make_dual_spline(Fields& fields) {
  const long n = read_integer(fields.required("n"), "n", 1, 100);
  const Piece rules_piece = fields.required("m");
  const long m = read_integer(rules_piece, "m", 1, 100);
  fields.finish();
  if ((n + m) % 2 != 0) fail(rules_piece, "n + m even");
  return {"cdf:n=" + number(n) + ",m=" + number(m),
          "scaling function with " + number(m) + " sum rules, dual to the B-spline of order " + number(n),
          dual_spline_mask(static_cast<int>(n), static_cast<int>(m))};
}

Scheme mask_of(const Piece& body, const LaurentPolynomial& symbol, long arity) {
  if (symbol.is_zero()) fail(body, "at least one non-zero coefficient");
  const Mask mask(symbol, static_cast<int>(arity));
  const auto sums = coset_sums(mask);
  for (std::size_t residue = 0; residue < sums.size(); ++residue)
    if (sums[residue] != 1)
      fail(body, "coefficients that sum to 1 over each residue class; " +
                     sum_text("the class " + std::to_string(residue) + " mod " + number(arity), sums[residue],
                              common_sum(sums)));
  return {"mask:" + symbol.to_mask_text() + (arity == 2 ? "" : ",arity=" + number(arity)),
          "mask given by its coefficients", mask};
}

/// `mask:[...],nearly=1e-9`: of coefficients that were rounded.
Scheme make_nearby_mask(const Piece& body, const std::vector<Rational>& coefficients, long first, long arity,
                        const Piece& nearly) {
  const auto accuracy = parse_number(nearly.text);
  if (!accuracy || *accuracy <= 0 || *accuracy >= 1) fail(nearly, "an accuracy above 0 and below 1, as 1e-9");
  if (coefficients.size() > most_nearby)
    fail(body, fmt::format("up to {} coefficients where they are rounded", most_nearby));
  const auto found = nearby_mask(coefficients, first, static_cast<int>(arity), *accuracy);
  if (!found)
    fail(body, fmt::format("coefficients within {} of a mask: their sum is {}, 1 or the root of {}, and those of each "
                           "residue class mod {} have the same sum",
                           nearly.text, arity, arity, arity));
  return {fmt::format("mask:{}{},nearly={}", LaurentPolynomial(coefficients, first).to_mask_text(),
                      arity == 2 ? "" : ",arity=" + number(arity), nearly.text),
          fmt::format("the mask with {} next to the coefficients{}, changed by {} at most",
                      found->sum_rules == 1 ? "1 sum rule" : number(found->sum_rules) + " sum rules",
                      found->factor == 1 ? "" : " times " + to_decimal(found->factor, 12, Rounding::nearest),
                      to_decimal(found->change, 2, Rounding::up)),
          Mask(found->symbol, static_cast<int>(arity))};
}

Scheme make_mask(const Piece& family, const Piece& body, const std::string& usage) {
  if (body.text.find(",where=") != std::string_view::npos) return make_algebraic_mask(family, body);
  auto [parts, fields] = read_mask(family, body, usage, 1, 4 * max_points);
  const long arity = read_arity(fields);
  const auto nearly = fields.optional("nearly");
  fields.finish();
  const long first = parts.first ? parts.first->front() : -static_cast<long>(parts.coefficients.size() / 2);
  return nearly ? make_nearby_mask(body, parts.coefficients, first, arity, *nearly)
                : mask_of(body, LaurentPolynomial(parts.coefficients, first), arity);
}

Scheme make_symbol(const Piece& family, const Piece& body, const std::string& usage) {
  auto [expression, fields] = split_symbol(family, body, usage);
  const long arity = read_arity(fields);
  fields.finish();
  return mask_of(expression, in_one_letter(read_symbol(expression, "z")), arity);
}

const std::vector<Family>& table() {
  static const std::vector<Family> families = [] {
    std::vector<Family> list{
        {{"primal", "primal:n=3,d=1", "binary primal 2n-point least squares scheme"}, from_fields(make_primal)},
        {{"dual", "dual:n=3,d=1", "binary dual 2n-point least squares scheme"}, from_fields(make_dual)},
        {{"primal-odd", "primal-odd:n=3,d=1", "binary primal (2n+1)-point variant"}, from_fields(make_primal_odd)},
        {{"dual-odd", "dual-odd:n=3,d=1", "binary dual (2n+1)-point variant"}, from_fields(make_dual_odd)},
        {{"ary", "ary:a=3,points=4,d=3", "a-ary least squares scheme on consecutive data"}, from_fields(make_ary)},
        {{"dd", "dd:n=2,a=2", "interpolatory Deslauriers-Dubuc 2n-point scheme, arity a (2 unless given)"},
         from_fields(make_deslauriers_dubuc)},
        {{"bspline", "bspline:degree=3,a=2", "B-spline, arity a (2 unless given)"}, from_fields(make_bspline)},
        {{"pseudo-spline", "pseudo-spline:m=3,l=1", "pseudo-spline of type II"}, from_fields(make_pseudo_spline)},
        {{"daubechies", "daubechies:n=2", "Daubechies' orthonormal scaling function D(2n)"},
         from_fields(make_daubechies)},
        {{"cdf", "cdf:n=2,m=2", "dual of the B-spline of order n with m sum rules"}, from_fields(make_dual_spline)}};
    for (const ClassicalFamily& family : classical_families()) list.push_back(at_numbers(family));
    list.push_back(
        {{"mask", "mask:[1,3,3,1]/4@-2,arity=2",
          "any mask; centred and binary unless said otherwise; where=t^2-3:1.7..1.8 for a number t, nearly=1e-9 for "
          "rounded coefficients"},
         make_mask});
    list.push_back(
        {{"symbol", "symbol:(1+z)^3/(4*z^2),arity=2", "the mask of a symbol, the sum of a_i z^i"}, make_symbol});
    list.push_back({{"regression", "regression:stencils=[-1..1;-1..2],at=[0;1/2],d=1",
                     "any local regression rules; optional weights=[1;2;1|1;1;1;1] and first=0"},
                    from_fields(make_regression)});
    return list;
  }();
  return families;
}

}  // namespace

namespace specification_text {

std::pair<Piece, Fields> split_mask(const Piece& family, const Piece& body, const std::string& usage, int variables,
                                    long most) {
  // The first indices are separated by commas, as the fields are.
  std::vector<Piece> rest = split(body, ',');
  const std::size_t indices = rest.front().text.find('@') == std::string_view::npos
                                  ? 1
                                  : static_cast<std::size_t>(variables);
  const auto fields = rest.begin() + static_cast<std::ptrdiff_t>(std::min(indices, rest.size()));
  const Piece& last = *std::prev(fields);
  const Piece mask{body.text.substr(0, last.at + last.text.size() - body.at), body.at};
  const std::string_view lists = mask.text.substr(0, mask.text.rfind(']'));
  if (1 + std::count(lists.begin(), lists.end(), ',') > most)
    fail(mask, "at most " + std::to_string(most) + " coefficients");
  return {mask, Fields(family, {fields, rest.end()}, usage)};
}

std::pair<Piece, Fields> split_symbol(const Piece& family, const Piece& body, const std::string& usage) {
  std::vector<Piece> rest = split(body, ',');
  const Piece expression = rest.front();
  rest.erase(rest.begin());
  return {expression, Fields(family, rest, usage)};
}

MultivariatePolynomial read_symbol(const Piece& expression, std::string_view letters) {
  return placed(expression, [&] { return read_polynomial(expression.text, letters, 4 * max_points); });
}

MaskAndFields read_mask(const Piece& family, const Piece& body, const std::string& usage, int variables, long most) {
  auto [mask, fields] = split_mask(family, body, usage, variables, most);
  return {placed(mask, [&mask = mask, variables] { return text::parse_mask_text(mask.text, variables); }),
          std::move(fields)};
}

}  // namespace specification_text

namespace {

Scheme scheme_of(std::string_view specification) {
  if (auto scheme = make_one_of(table(), specification)) return *std::move(scheme);
  const Piece family = family_of(specification);
  const std::string known = names_of(families());
  if (is_l1_specification(specification))
    fail(family, "a linear scheme, one of " + known + "; l1 schemes only act on data");
  for (const FamilyHelp& other : multivariate_families())
    if (other.family == family.text) fail(family, "a linear scheme of one variable (" + known + ")");
  for (const FamilyHelp& other : vector_families())
    if (other.family == family.text) fail(family, numbers_only);
  fail(family, unknown_family(family.text));
}

}  // namespace

Scheme make_scheme(std::string_view specification) { return from_written(specification, scheme_of); }

const std::vector<FamilyHelp>& families() {
  static const std::vector<FamilyHelp> help = help_of(table());
  return help;
}

}  // namespace subcert
