// Specifications of two and three variables: tensor products, fits on grids, masks, box splines and classical surface
// schemes; and of any kind.

#include "classical.hpp"
#include "grid_regression.hpp"
#include "specification_text.hpp"
#include "surface_schemes.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace subcert {

namespace specification_text {

constexpr long max_digit = 1'000'000;

std::vector<LatticePoint> read_lattice_points(const Piece& piece, const std::string& name, std::size_t variables,
                                              long bound) {
  std::vector<LatticePoint> points;
  for (const Piece& entry : read_rows(piece)) {
    points.emplace_back();
    for (const Piece& number : split(entry, ',')) points.back().push_back(read_integer(number, name, -bound, bound));
    if (points.back().size() != variables) fail(entry, fmt::format("{} numbers, one for each variable", variables));
  }
  return points;
}

std::vector<LatticeMask::Term> terms_of(const text::MaskText& mask, text::Entries entries) {
  const bool matrices = entries == text::Entries::matrices;
  const std::size_t skipped = matrices ? 2 : 0, columns = matrices ? mask.sizes[0] : 1,
                    block = matrices ? columns * mask.sizes[1] : 1;
  std::vector<LatticeMask::Term> terms;
  for (std::size_t i = 0; i < mask.coefficients.size(); ++i) {
    if (mask.coefficients[i] == 0) continue;
    LatticeMask::Term term{{}, i % block / columns, i % columns, mask.coefficients[i]};
    std::size_t rest = i / block;
    for (std::size_t v = skipped; v < mask.sizes.size(); rest /= mask.sizes[v++]) {
      const long first = mask.first ? (*mask.first)[v - skipped] : -static_cast<long>(mask.sizes[v] / 2);
      term.exponents.push_back(first + static_cast<long>(rest % mask.sizes[v]));
    }
    terms.push_back(std::move(term));
  }
  return terms;
}

Dilation read_dilation(Fields& fields, std::size_t variables) {
  const auto arity = fields.optional("arity"), matrix = fields.optional("dilation"), digits = fields.optional("digits");
  if (arity && matrix) fail(*matrix, "arity or dilation, not both");
  Dilation result = matrix
                        ? checked(
                              *matrix,
                              [&] { return Dilation(read_lattice_points(*matrix, "an entry", variables, max_entry)); })
                        : Dilation::multiple(static_cast<int>(variables),
                                             arity ? static_cast<int>(read_integer(*arity, "arity", 2, max_arity)) : 2);
  if (!digits) return result;
  return checked(*digits, [&] {
    return Dilation(result.rows(), read_lattice_points(*digits, "a coordinate", variables, max_digit));
  });
}

std::string fields_text(const Dilation& dilation) {
  const int factor = dilation.factor().value_or(0);
  const Dilation plain(dilation.rows());
  return (factor == 2  ? ""
          : factor > 2 ? ",arity=" + std::to_string(factor)
                       : ",dilation=" + dilation.to_text()) +
         (dilation == plain ? "" : ",digits=" + to_text(dilation.digits()));
}

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

}  // namespace specification_text

namespace {

using namespace specification_text;

constexpr long max_of_factors = 100'000, max_mask = 2 * max_points;

Scheme make_tensor(const Piece&, const Piece& body, const std::string&) {
  std::string specification = "tensor:";
  std::vector<Mask> factors;
  long coefficients = 1;
  for (const Piece& factor : read_factors(body)) {
    try {
      const Scheme scheme = make_scheme(factor.text);
      if (scheme.rounding) fail(factor, "factors with rational coefficients");  // what is proved would be of others
      specification += (factors.empty() ? "(" : "x(") + scheme.specification + ")";
      factors.push_back(scheme.mask.curve());
    } catch (const SpecificationError& error) {
      if (error.position() > factor.at) throw;
      throw SpecificationError(error.token(), factor.at + error.position(), error.expected());
    }
    coefficients *= factors.back().symbol().length();
    if (coefficients > max_of_factors)
      fail(factor, "factors with at most " + std::to_string(max_of_factors) + " coefficients in all");
  }
  return {specification, "tensor product", tensor_product(factors)};
}

Scheme make_grid(Fields& fields) {
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
    if (coefficients > max_of_factors)
      fail(points_piece,
           "at most " + std::to_string(max_of_factors) + " coefficients (points times a along each axis)");
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
          grid_regression_mask(scheme)};
}

/// Refuses masks whose coset sums are not all 1, by a class without coefficients where there is one.
void require_affine(const Piece& body, const LatticeMask& mask) {
  const std::vector<Rational> sums = coset_sums(mask);
  std::vector<bool> empty(sums.size(), true);
  for (const auto& term : mask.symbol().terms()) empty[mask.dilation().divide(term.exponents).digit] = false;
  auto bad = static_cast<std::size_t>(std::find(empty.begin(), empty.end(), true) - empty.begin());
  for (std::size_t d = 0; d < sums.size() && bad == sums.size(); ++d)
    if (sums[d] != 1) bad = d;
  if (bad == sums.size()) return;
  const std::string name = fmt::format("the class of ({})", fmt::join(mask.dilation().digits()[bad], ","));
  fail(body,
       fmt::format("coefficients that sum to 1 over each class of indices modulo {}; {}", mask.dilation().to_text(),
                   empty[bad] ? name + " has none (another matrix: dilation=[a,b;c,d])"
                              : sum_text(name, sums[bad], common_sum(sums))));
}

MultivariatePolynomial symbol_of(const text::MaskText& mask) {
  std::vector<Monomial> terms;
  for (LatticeMask::Term& term : terms_of(mask, text::Entries::numbers))
    terms.push_back({std::move(term.coefficient), std::move(term.exponents)});
  return {static_cast<int>(mask.sizes.size()), terms};
}

/// Domain: a common denominator and a count of coefficients that make it in seconds.
Scheme mask_of(const std::string& name, const Piece& body, const MultivariatePolynomial& symbol, Fields& fields) {
  Integer common = 1;
  for (const Monomial& term : symbol.terms()) common = lcm(common, denominator(term.coefficient));
  if (common.str().size() * symbol.count() > 5 * static_cast<std::size_t>(max_long_work))
    fail(body, fmt::format("coefficients with (number of them) * (digits of the common denominator) <= {}",
                           5 * max_long_work));
  const Dilation dilation = read_dilation(fields, static_cast<std::size_t>(symbol.variables()));
  fields.finish();
  const LatticeMask mask = checked(body, [&] { return LatticeMask(symbol, dilation); });
  require_affine(body, mask);
  return {name + ":" + to_mask_text(mask) + fields_text(dilation), "mask given by its coefficients", mask};
}

template <int variables>
Scheme make_mask_of(const Piece& family, const Piece& body, const std::string& usage) {
  auto [parts, fields] = read_mask(family, body, usage, variables, max_mask);
  return mask_of(std::string(family.text), body, symbol_of(parts), fields);
}

template <int variables>
Scheme make_symbol_of(const Piece& family, const Piece& body, const std::string& usage) {
  auto [expression, fields] = split_symbol(family, body, usage);
  const MultivariatePolynomial symbol = read_symbol(expression, std::string_view("xyz").substr(0, variables));
  const LatticePoint size = symbol.is_zero() ? LatticePoint() : symbol.highest() - symbol.lowest();
  long coefficients = 1;
  for (const long length : size) coefficients = std::min(coefficients * (length + 1), max_mask + 1);
  if (coefficients > max_mask) fail(expression, fmt::format("at most {} coefficients", max_mask));
  return mask_of(fmt::format("mask{}", variables), expression, symbol, fields);
}

Scheme make_box(const Piece& family, const Piece& body, const std::string& usage) {
  std::vector<Piece> rest = split(body, ',');
  const Piece list = rest.front();
  rest.erase(rest.begin());
  const std::size_t variables = split(read_rows(list).front(), ',').size();
  if (variables < 2 || variables > 3) fail(list, "directions of two or three variables, as [1,0;0,1;1,1]");
  const std::vector<LatticePoint> directions = read_lattice_points(list, "a coordinate", variables, max_entry);
  Fields fields(family, rest, usage);
  const Dilation dilation = read_dilation(fields, variables);
  fields.finish();
  const LatticeMask mask = checked(list, [&] { return box_spline_mask(directions, dilation); });
  require_affine(list, mask);
  return {"box:" + to_text(directions) + fields_text(dilation),
          fmt::format("box spline of {} directions", directions.size()), mask};
}

BallRegression read_ball_regression(Fields& fields) {
  BallRegression scheme;
  const Piece radius = fields.required("L");
  scheme.radius = read_rational(radius);
  if (denominator(scheme.radius) > 1000) fail(radius, "L with a denominator up to 1000");
  if (const auto piece = fields.optional("d")) scheme.degree = static_cast<int>(read_integer(*piece, "d", 0, 6));
  if (const auto piece = fields.optional("grid")) {
    if (piece->text != "equilateral" && piece->text != "rectangular")
      fail(*piece, "grid=equilateral or grid=rectangular");
    if (piece->text == "rectangular") scheme.lattice = Lattice::rectangular;
  }
  const auto power = fields.optional("power"), weights = fields.optional("weights");
  if (power && weights) fail(*weights, "power or weights, not both");
  if (power) scheme.power = static_cast<int>(read_integer(*power, "power", 0, 8));
  if (weights) {
    for (const Piece& entry : read_list(*weights, ';')) {
      scheme.weights.push_back(read_rational(entry));
      if (scheme.weights.back() <= 0 || entry.text.size() > 40) fail(entry, "a weight > 0 of at most 40 characters");
    }
    const std::vector<Rational> distances = checked(radius, [&] { return ball_distances(scheme); });
    const auto few = distances.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(distances.size(), 8));
    if (distances.size() != scheme.weights.size())
      fail(*weights, fmt::format("{} weights, one for each squared distance {}{}", distances.size(),
                                 fmt::join(distances.begin(), few, ", "), few == distances.end() ? "" : ", ..."));
  }
  fields.finish();
  return scheme;
}

Scheme make_triangular(Fields& fields) {
  const Piece radius = fields.required("L");
  const BallRegression scheme = read_ball_regression(fields);
  const bool rectangular = scheme.lattice == Lattice::rectangular;
  std::string text = fmt::format("triangular:L={},d={}{}", scheme.radius, scheme.degree,
                                 rectangular ? ",grid=rectangular" : "");
  if (scheme.power > 0) text += fmt::format(",power={}", scheme.power);
  for (std::size_t i = 0; i < scheme.weights.size(); ++i)
    text += (i == 0 ? ",weights=[" : ";") + to_text(scheme.weights[i]);
  if (!scheme.weights.empty()) text += "]";
  return {text,
          fmt::format("least squares on the {} triangular grid within L = {}, degree {}",
                      rectangular ? "rectangular" : "equilateral", scheme.radius, scheme.degree),
          checked(radius, [&] { return ball_regression_mask(scheme); })};
}

Scheme make_butterfly(Fields& fields) {
  const Rational w = read_rational(fields.required("w"));
  fields.finish();
  return {"butterfly:w=" + to_text(w), "butterfly scheme with tension " + to_text(w), butterfly_mask(w)};
}

Scheme make_kobbelt(Fields& fields) {
  const Rational w = read_rational(fields.required("w"));
  fields.finish();
  return {"kobbelt:w=" + to_text(w), "Kobbelt's interpolatory scheme for quadrilaterals with tension " + to_text(w),
          tensor_product({four_point_mask(w), four_point_mask(w)})};
}

const std::vector<Family>& multivariate_table();

/// A scheme without parameters, known by its name: another specification.
Family named(const std::string& name, const std::string& meaning, const std::string& definition) {
  return {{name, name, meaning}, [=](const Piece&, const Piece& body, const std::string&) {
            if (!body.text.empty()) fail(body, "nothing after " + name);
            return Scheme{name, meaning, make_one_of(multivariate_table(), definition)->mask};
          }};
}

const std::vector<Family>& multivariate_table() {
  static const std::vector<Family> families{
      {{"tensor", "tensor:(primal:n=3)x(dual:n=2)", "tensor product of two or three schemes of one variable"},
       make_tensor},
      {{"grid", "grid:points=4x4,d=3",
        "least squares of total degree d on a grid of data, as 4x4, 5x5 or 4x4x4; optional a=2"},
       from_fields(make_grid)},
      {{"triangular", "triangular:L=8/5,d=1",
        "least squares within the distance L on a triangular grid; optional grid=rectangular, power=2 or "
        "weights=[...]"},
       from_fields(make_triangular)},
      {{"mask2", "mask2:[[1,1,0],[1,2,1],[0,1,1]]/2@-1,-1",
        "any mask, rows in x; optional arity=2 or dilation=[1,2;-2,-1], and digits=[0,0;1,0;...]"},
       make_mask_of<2>},
      {{"mask3", "mask3:[[[1,1],[1,1]],[[1,1],[1,1]]]@-1,-1,-1", "the same in three variables"}, make_mask_of<3>},
      {{"symbol2", "symbol2:(1+x)(1+y)(1+x*y)/2,arity=2", "the mask of a symbol in x and y; optional keys as of mask2"},
       make_symbol_of<2>},
      {{"symbol3", "symbol3:(1+x)(1+y)(1+z)(1+x*y*z)/2,arity=2", "the same in x, y and z"}, make_symbol_of<3>},
      {{"box", "box:[1,0;0,1;1,1]",
        "box spline by its directions in two or three variables; optional keys as of mask2"},
       make_box},
      {{"butterfly", "butterfly:w=1/16", "butterfly scheme with tension w"}, from_fields(make_butterfly)},
      named("modified-butterfly", "Zorin, Schröder and Sweldens' modified butterfly scheme", "butterfly:w=1/16"),
      named("loop", "Loop's scheme, three-directional quartic box spline", "box:[1,0;1,0;0,1;0,1;1,1;1,1]"),
      named("catmull-clark", "Catmull and Clark's scheme, bicubic B-spline",
            "tensor:(bspline:degree=3)x(bspline:degree=3)"),
      named("doo-sabin", "Doo and Sabin's scheme, biquadratic B-spline",
            "tensor:(bspline:degree=2)x(bspline:degree=2)"),
      {{"kobbelt", "kobbelt:w=1/16", "Kobbelt's interpolatory scheme, tensor product of the 4-point scheme"},
       from_fields(make_kobbelt)},
      named("sqrt3", "Kobbelt's sqrt(3) scheme",
            "mask2:[[0,0,0,1,0],[0,1,6,6,1],[0,6,12,6,0],[1,6,6,1,0],[0,1,0,0,0]]/18@-2,-2,dilation=[1,2;-2,-1]"),
      named("quincunx", "bilinear interpolation on the quincunx lattice",
            "mask2:[[0,1,0],[1,4,1],[0,1,0]]/4@-1,-1,dilation=[1,-1;1,1]"),
      named("four-eight", "Velho and Zorin's 4-8 scheme, four-directional box spline, one bisection a step",
            "box:[1,0;1,0;0,1;0,1;1,1;1,1;1,-1;1,-1],dilation=[1,-1;1,1]"),
      named("zwart-powell", "Zwart-Powell element, four-directional quadratic box spline", "box:[1,0;0,1;1,1;1,-1]"),
      named("midedge", "Peters and Reif's simplest scheme, the Zwart-Powell element with midpoints of edges",
            "box:[1,0;0,1;1,1;1,-1],dilation=[1,-1;1,1]")};
  return families;
}

Scheme linear_scheme_of(std::string_view specification) {
  if (auto scheme = make_one_of(multivariate_table(), specification)) return *std::move(scheme);
  const Piece family = family_of(specification);
  for (const FamilyHelp& help : families())
    if (help.family == family.text) return make_scheme(specification);
  for (const FamilyHelp& help : vector_families())
    if (help.family == family.text) fail(family, numbers_only);
  if (is_l1_specification(specification))
    fail(family, "a linear scheme; l1 schemes only act on data, and 'subcert l1' tells what is proved of them");
  fail(family, unknown_family(family.text));
}

}  // namespace

std::optional<BallRegression> specification_text::ball_regression_of(std::string_view specification) {
  const Piece family = family_of(specification);
  if (family.text != "triangular") return std::nullopt;
  Fields fields(family, body_of(specification), "triangular:L=8/5,d=1");
  return read_ball_regression(fields);
}

Scheme make_linear_scheme(std::string_view specification) { return from_written(specification, linear_scheme_of); }

AnyScheme make_any_scheme(std::string_view specification) {
  if (is_l1_specification(specification_as_written(specification))) return from_written(specification, make_l1_scheme);
  return make_linear_scheme(specification);
}

const std::string& specification_of(const AnyScheme& scheme) {
  return std::visit([](const auto& one) -> const std::string& { return one.specification; }, scheme);
}

std::optional<LatticeMask> mask_with_factors(const AnyScheme& scheme) {
  const auto* linear = std::get_if<Scheme>(&scheme);
  return linear && linear->mask.has_factors() ? std::optional(linear->mask) : std::nullopt;
}

std::optional<VectorForm> form_of_levels(const std::optional<VectorForm>& form) {
  return form == VectorForm::refinable ? VectorForm::vector : form;
}

LevelDependentScheme levels_in_turn(const std::vector<std::string>& first, const std::vector<std::string>& again) {
  require(!again.empty(), "levels: need a scheme that comes again, got none");
  const Scheme model = make_refinable_scheme(again.front());
  LevelDependentScheme result{"", {}, form_of_levels(model.form)};
  const auto append = [&](const std::string& specification, std::vector<LatticeMask>& masks) {
    const Scheme scheme = make_refinable_scheme(specification);
    const LatticeMask &mask = scheme.mask, &other = model.mask;
    require(mask.dilation() == other.dilation(),
            "levels: need schemes of one arity and as many variables, got {} and {}", model.specification,
            scheme.specification);
    require(mask.components() == other.components(), "levels: need matrices of one size, got {} and {} rows",
            other.components(), mask.components());
    require(form_of_levels(scheme.form) == result.form, "levels: need Hermite schemes alone or none, got {} and {}",
            model.specification, scheme.specification);
    require(!scheme.form || !scheme.rounding, "levels: need matrices with rational entries, got {}",
            scheme.specification);
    result.specification += (result.specification.empty() ? "" : ", ") + scheme.specification;
    masks.push_back(mask);
  };
  for (const std::string& one : first) append(one, result.masks.first);
  for (const std::string& one : again) append(one, result.masks.again);
  return result;
}

Scheme period_of(const LevelDependentScheme& scheme) {
  constexpr long most_classes = 4096;
  long classes = 1;
  for (const LatticeMask& mask : scheme.masks.again)
    if (scheme.form && (classes *= mask.arity()) > most_classes)
      fail(ErrorKind::size, "levels: need matrices in a period with arity^length up to {}, got a length of {}",
           most_classes, scheme.masks.again.size());
  return {.specification = scheme.specification,
          .title = "",
          .mask = levels_as_one(scheme.masks.again),
          .form = scheme.form};
}

const std::vector<FamilyHelp>& multivariate_families() {
  static const std::vector<FamilyHelp> help = help_of(multivariate_table());
  return help;
}

text::MaskText mask_text_parts(const LatticeMask& mask) {
  const std::vector<LatticeMask::Term>& terms = mask.terms();
  LatticePoint lowest = terms.front().exponents, highest = lowest;
  for (const LatticeMask::Term& term : terms)
    for (std::size_t v = 0; v < lowest.size(); ++v) {
      lowest[v] = std::min(lowest[v], term.exponents[v]);
      highest[v] = std::max(highest[v], term.exponents[v]);
    }
  text::MaskText result{{}, {}, lowest};
  const std::size_t size = mask.components();
  if (size > 1) result.sizes = {size, size};
  std::size_t count = size * size;
  for (std::size_t v = 0; v < lowest.size(); ++v) {
    result.sizes.push_back(static_cast<std::size_t>(highest[v] - lowest[v] + 1));
    count *= result.sizes.back();
  }
  result.coefficients.resize(count, 0);
  for (const LatticeMask::Term& term : terms) {
    std::size_t at = 0;
    for (std::size_t v = lowest.size(); v-- > 0;)
      at = at * result.sizes[result.sizes.size() - lowest.size() + v] +
           static_cast<std::size_t>(term.exponents[v] - lowest[v]);
    result.coefficients[(at * size + term.row) * size + term.column] = term.coefficient;
  }
  return result;
}

std::string to_mask_text(const LatticeMask& mask) { return text::print_mask_text(mask_text_parts(mask)); }

}  // namespace subcert
