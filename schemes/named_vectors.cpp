// Specifications of vectors of functions by name.

#include "specification_text.hpp"
#include "vector_schemes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace subcert {
namespace {

using namespace specification_text;

constexpr long max_data = 64, max_spline_degree = 64;

std::string arity_text(long arity) { return arity == 2 ? "" : fmt::format(",a={}", arity); }

long read_a(Fields& fields) {
  const auto piece = fields.optional("a");
  return piece ? read_integer(*piece, "a", 2, max_arity) : 2;
}

/// Domain: piece is what makes the mask large.
void require_entries(const Piece& piece, long count) {
  if (count > max_entries) fail(piece, fmt::format("a mask of at most {} numbers, here up to {}", max_entries, count));
}

Scheme make_merrien(Fields& fields) {
  const Rational lambda = read_rational(fields.required("lambda")), mu = read_rational(fields.required("mu"));
  fields.finish();
  return {fmt::format("merrien:lambda={},mu={}", lambda, mu),
          fmt::format("Merrien's Hermite scheme with lambda = {}, mu = {}", lambda, mu),
          make_refinable_scheme(merrien_matrices(to_text(lambda), to_text(mu))).mask,
          {},
          {},
          VectorForm::hermite};
}

Scheme make_hermite_interpolation(Fields& fields) {
  const Piece points_piece = fields.required("points"), order_piece = fields.required("order");
  const long points = read_integer(points_piece, "points", 2, max_data),
             order = read_integer(order_piece, "order", 1, max_data), arity = read_a(fields);
  fields.finish();
  if (points % 2 != 0) fail(points_piece, "points as an even number");
  if (order == 1) return make_scheme(fmt::format("dd:n={}{}", points / 2, arity_text(arity)));
  if (points * order > max_data)
    fail(order_piece, fmt::format("points * order <= {} (here points = {})", max_data, points));
  require_entries(points_piece, arity * points * order * order);
  return {fmt::format("hermite-dd:points={},order={}{}", points, order, arity_text(arity)),
          fmt::format("Hermite interpolation of {} data at each of {} points", order, points),
          hermite_interpolation_mask(static_cast<int>(points / 2), static_cast<int>(order), static_cast<int>(arity)),
          {},
          {},
          VectorForm::hermite};
}

/// With knots of multiplicity 1 a scheme of numbers.
Scheme make_multiple_knot_bspline(const Piece& family, const Piece& body, const std::string& usage) {
  Fields fields(family, body, usage);
  const Piece degree_piece = fields.required("degree");
  const auto multiplicity_piece = fields.optional("multiplicity");
  const long arity = read_a(fields);
  fields.finish();
  if (!multiplicity_piece) return make_scheme(fmt::format("{}:{}", family.text, body.text));
  const long degree = read_integer(degree_piece, "degree", 1, max_spline_degree),
             multiplicity = read_integer(*multiplicity_piece, "multiplicity", 1, degree);
  if (multiplicity == 1) return make_scheme(fmt::format("bspline:degree={}{}", degree, arity_text(arity)));
  require_entries(degree_piece, arity * (degree + multiplicity) * multiplicity);
  return {fmt::format("bspline:degree={},multiplicity={}{}", degree, multiplicity, arity_text(arity)),
          fmt::format("B-splines of degree {} with {}-fold knots", degree, multiplicity),
          multiple_knot_bspline_mask(static_cast<int>(degree), static_cast<int>(multiplicity), static_cast<int>(arity)),
          {},
          {},
          VectorForm::refinable};
}

/// Where no factor is a vector a scheme of numbers.
Scheme make_vector_tensor(const Piece& family, const Piece& body, const std::string&) {
  const std::vector<Piece> pieces = read_factors(body);
  std::vector<Scheme> schemes;
  for (const Piece& factor : pieces)
    schemes.push_back(placed(factor, [&factor] { return make_refinable_scheme(factor.text); }));
  if (std::ranges::none_of(schemes, [](const Scheme& scheme) { return scheme.form.has_value(); }))
    return make_linear_scheme(fmt::format("{}:{}", family.text, body.text));
  std::vector<LatticeMask> factors;
  std::string specification = "tensor:";
  std::size_t components = 1, variables = 0, entries = 1;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Scheme& scheme = schemes[k];
    if (scheme.quadratic || scheme.rounding) fail(pieces[k], "factors with rational coefficients");
    specification += (k == 0 ? "(" : "x(") + scheme.specification + ")";
    factors.push_back(scheme.mask);
    components *= scheme.mask.components();
    variables += scheme.mask.dilation().variables();
    entries *= scheme.mask.terms().size();
    if (components > max_components)
      fail(pieces[k], fmt::format("factors with at most {} components in all", max_components));
    if (variables > 3) fail(pieces[k], "factors of three variables in all at most");
    require_entries(pieces[k], static_cast<long>(entries));
  }
  return {specification,        "tensor product", checked(body, [&] { return vector_tensor_product(factors); }), {}, {},
          VectorForm::refinable};
}

Family named(const std::string& name, const std::string& meaning, LatticeMask (*mask)()) {
  return {{name, name, meaning}, [=](const Piece&, const Piece& body, const std::string&) {
            if (!body.text.empty()) fail(body, "nothing after " + name);
            return Scheme{name, meaning, mask(), {}, {}, VectorForm::refinable};
          }};
}

/// A family `name:NUMBER`.
Family numbered(const std::string& name, const std::string& meaning, long first, long last,
                const std::function<Scheme(int number)>& make) {
  return {{name, fmt::format("{}:{}", name, first), meaning}, [=](const Piece&, const Piece& body, const std::string&) {
            return make(static_cast<int>(read_integer(body, "the number of " + name, first, last)));
          }};
}

}  // namespace

const std::vector<Family>& specification_text::named_vectors() {
  static const std::vector<Family> families{
      {{"merrien", "merrien:lambda=-1/8,mu=-1/2", "Merrien's interpolatory 2-point scheme on values and slopes"},
       from_fields(make_merrien)},
      {{"hermite-dd", "hermite-dd:points=4,order=2,a=2",
        "values and derivatives, `order` data at each point, of the polynomial through those at the nearest points"},
       from_fields(make_hermite_interpolation)},
      {{"bspline", "bspline:degree=3,multiplicity=2,a=2", "B-splines with multiple knots"}, make_multiple_knot_bspline},
      named("ghm", "orthogonal multiwavelet of Geronimo, Hardin and Massopust, the first function times sqrt(2)",
            geronimo_hardin_massopust_mask),
      numbered("cl", "orthogonal multiwavelets of Chui and Lian on [0, 2] and [0, 3]: cl:2, cl:3", 2, 3,
               [](int n) {
                 return quadratic_scheme(fmt::format("cl:{}", n),
                                         fmt::format("orthogonal multiwavelet of Chui and Lian on [0, {}]{}", n,
                                                     n == 3 ? ", the second function times sqrt(6)" : ""),
                                         VectorForm::refinable, chui_lian_mask(n));
               }),
      numbered(
          "bat", "balanced orthogonal multiwavelets of Lebrun and Vetterli, of orders 1, 2, 3: bat:1 to bat:3", 1, 3,
          [](int n) {
            return quadratic_scheme(fmt::format("bat:{}", n),
                                    fmt::format("balanced orthogonal multiwavelet of Lebrun and Vetterli, order {}", n),
                                    VectorForm::refinable, balanced_mask(n));
          }),
      {{"sa4", "sa4", "symmetric and antisymmetric orthogonal multiwavelet of Shen, Tan and Tham on [0, 3]"},
       [](const Piece&, const Piece& body, const std::string& usage) {
         if (!body.text.empty()) fail(body, "nothing after " + usage);
         return quadratic_scheme(usage, "orthogonal multiwavelet of Shen, Tan and Tham", VectorForm::refinable,
                                 shen_tan_tham_mask());
       }},
      {{"tensor", "tensor:(ghm)x(bspline:degree=1)", "tensor product of vectors of functions, or of these and schemes"},
       make_vector_tensor}};
  return families;
}

}  // namespace subcert
