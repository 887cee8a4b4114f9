#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/data/refine/vector_refinement.hpp>
#include <subcert/schemes/data/scheme_refinement.hpp>

#include <algorithm>
#include <cmath>

using namespace subcert;
using namespace subcert::data;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

/// Value and derivatives at x.
std::vector<Rational> jet(const std::vector<Rational>& polynomial, std::size_t order, const Rational& x) {
  std::vector<Rational> result;
  for (std::size_t k = 0; k < order; ++k) {
    Rational sum = 0;
    for (std::size_t n = polynomial.size(); n-- > k;) {
      Rational factor = polynomial[n];
      for (std::size_t i = 0; i < k; ++i) factor *= n - i;
      sum = sum * x + factor;
    }
    result.push_back(sum);
  }
  return result;
}

std::vector<Rational> random_coefficients(Random& random, int degree) {
  std::vector<Rational> result;
  for (int n = 0; n <= degree; ++n) result.push_back(random.rational());
  return result;
}

/// Points of a curve with these coordinates, block by block, at the parameters of the axis times `spacing`.
std::vector<Rational> samples(const std::vector<std::vector<Rational>>& curve, std::size_t order, const Axis& axis,
                              const Rational& spacing) {
  std::vector<Rational> result;
  for (std::size_t i = 0; i < axis.count; ++i)
    for (std::size_t k = 0; k < order; ++k)
      for (const auto& polynomial : curve) result.push_back(jet(polynomial, order, axis.parameter(i) * spacing)[k]);
  return result;
}

/// The scheme whose outputs a i, ..., a i + a - 1 are those of the polynomial with the Hermite data at i and i + 1, at
/// i
/// + position + k/a.
LatticeMask shifted_hermite(int order, int arity, const Rational& position) {
  const HermiteFit fit(0, 1, order, 2 * order - 1);
  const auto size = static_cast<std::size_t>(order);
  std::vector<LatticeMask::Term> terms;
  for (int k = 0; k < arity; ++k) {
    const RationalMatrix weights = fit.weights(position + Rational(k, arity), arity);
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t i = 0; i < 2 * size; ++i)
        terms.push_back({{k - arity * static_cast<long>(i / size)}, i % size, row, weights(row, i)});
  }
  return matrix_mask(terms, size, Dilation::multiple(1, arity));
}

struct Reproducing {
  Scheme scheme;
  int degree;
};

std::vector<Reproducing> reproducing() {
  std::vector<Reproducing> result;
  for (const auto& [text, degree] : std::vector<std::pair<const char*, int>>{{"hermite-dd:points=2,order=2", 3},
                                                                             {"hermite-dd:points=2,order=3,a=3", 5},
                                                                             {"hermite-dd:points=4,order=2", 7},
                                                                             {"hermite-dd:points=4,order=2,a=3", 7},
                                                                             {"merrien:lambda=-1/8,mu=-1/2", 3},
                                                                             {"merrien:lambda=-1/8,mu=1/3", 2},
                                                                             {"merrien:lambda=-1/7,mu=-1/2", 1}})
    result.push_back({make_refinable_scheme(text), degree});
  result.push_back({vector_scheme(VectorForm::hermite, "", shifted_hermite(2, 2, Rational(1, 4))), 3});
  result.push_back({vector_scheme(VectorForm::hermite, "", shifted_hermite(3, 3, Rational(1, 7))), 5});
  return result;
}

/// P_k, k from `first` on, with random entries; of `hermite` ones that keep constants.
LatticeMask random_mask(Random& random, std::size_t size, int arity, VectorForm form) {
  const long first = random.integer(-4, 2), last = first + arity + random.integer(0, 4);
  std::vector<LatticeMask::Term> terms;
  std::vector<Rational> sums(size * static_cast<std::size_t>(arity), 0);
  const auto add = [&](long k, std::size_t row, std::size_t column, const Rational& entry) {
    terms.push_back({{k}, column, row, entry});
    if (column == 0) sums[static_cast<std::size_t>(modulo(k, static_cast<long>(arity))) * size + row] += entry;
  };
  for (long k = first; k <= last; ++k)
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column)
        if (random.chance(70)) add(k, row, column, random.rational());
  if (form == VectorForm::hermite)
    for (long k = first; k < first + arity; ++k)
      for (std::size_t row = 0; row < size; ++row)
        add(k, row, 0,
            Rational(row == 0 ? 1 : 0) -
                sums[static_cast<std::size_t>(modulo(k, static_cast<long>(arity))) * size + row]);
  add(first, size - 1, size - 1, Rational(100));
  return matrix_mask(terms, size, Dilation::multiple(1, arity));
}

/// One step by its definition, of data `level` steps after the first; the result has the axis `to`.
std::vector<Rational> step_by_definition(const LatticeMask& mask, VectorForm form, const GridData<Rational>& data,
                                         const Axis& to, int level) {
  const Axis& axis = data.axes[0];
  const std::size_t size = mask.components(), block = data.dimension / size;
  const long arity = mask.arity(), count = static_cast<long>(axis.count);
  const Rational centre = form == VectorForm::hermite ? -arity * axis_rule(mask, form).stencils.position(0)
                                                      : Rational(0);
  const auto d = [&](int n, std::size_t k) {
    return form == VectorForm::hermite ? power(Rational(arity), -n * static_cast<int>(k)) : Rational(1);
  };
  std::vector<Rational> result(to.count * data.dimension, 0);
  for (std::size_t o = 0; o < to.count; ++o) {
    const Rational output = (to.parameter(o) - axis.first) / axis.step * arity + centre;
    CHECK(denominator(output) == 1);
    const long i = floor_index(output);
    for (const LatticeMask::Term& term : mask.terms()) {
      if (modulo(i - term.exponents[0], arity) != 0) continue;
      const long j = (i - term.exponents[0]) / arity;
      if (!axis.closed) CHECK((0 <= j && j < count));
      const auto at = static_cast<std::size_t>(modulo(j, count));
      for (std::size_t c = 0; c < block; ++c)
        result[o * data.dimension + term.column * block + c] += term.coefficient * d(level, term.row) /
                                                                d(level + 1, term.column) *
                                                                data.values[at * data.dimension + term.row * block + c];
    }
  }
  return result;
}

}  // namespace

TEST_CASE("Hermite schemes with a square root keep data of polynomials around places with it") {
  const auto degree = [](const std::string& text) {
    const Scheme scheme = make_refinable_scheme("hermite:" + text);
    REQUIRE(scheme.quadratic);
    return hermite_reproduction(scheme.mask, scheme.quadratic).degree;
  };
  // Merrien's scheme, mu = sqrt(2)/4; slopes that are not those of lines; no constants
  CHECK(degree("[[[1/2,-1/8],[1/2-sqrt(2)/8,sqrt(2)/16]],[[1,0],[0,1/2]],[[1/2,1/8],[sqrt(2)/8-1/2,sqrt(2)/16]]]@-1") ==
        2);
  CHECK(degree("[[[1/2,-1/8],[sqrt(2)/2,0]],[[1,0],[0,1/2]],[[1/2,1/8],[-sqrt(2)/2,0]]]@-1") == 0);
  CHECK(degree("[[[1/2,-1/8],[sqrt(2)/2,0]],[[1,0],[0,1/2]],[[sqrt(2)/2,1/8],[-sqrt(2)/2,0]]]@-1") == -1);
  // values on the tangents at (i - sqrt(2))/2; the same with -sqrt(2) in one class, which has no common place
  CHECK(degree("[[[1,-sqrt(2)/2],[0,1/2]],[[1,1/2-sqrt(2)/2],[0,1/2]]]@0") == 1);
  CHECK(degree("[[[1,-sqrt(2)/2],[0,1/2]],[[1,1/2+sqrt(2)/2],[0,1/2]]]@0") == 0);
  for (const auto& [scheme, expected] : reproducing()) {
    std::vector<QuadraticTerm> terms;
    for (const LatticeMask::Term& term : scheme.mask.terms())
      terms.push_back({term.exponents, term.row, term.column, term.coefficient, 0});
    const QuadraticMask meant = quadratic_mask(terms, scheme.mask.components(), 7, scheme.mask.dilation());
    CHECK(hermite_reproduction(scheme.mask, meant).degree == expected);
  }
}

TEST_CASE("Hermite schemes with a square root refine data of polynomials up to the rounding of the root") {
  Random random;
  const Rational error = power(Rational(2), -200);
  // Merrien's scheme, mu = sqrt(2)/4; values on the tangents at (i - sqrt(2))/2
  for (const auto& [text, degree] : std::vector<std::pair<std::string, int>>{
           {"[[[1/2,-1/8],[1/2-sqrt(2)/8,sqrt(2)/16]],[[1,0],[0,1/2]],[[1/2,1/8],[sqrt(2)/8-1/2,sqrt(2)/16]]]@-1", 2},
           {"[[[1,-sqrt(2)/2],[0,1/2]],[[1,1/2-sqrt(2)/2],[0,1/2]]]@0", 1}}) {
    const Scheme scheme = make_refinable_scheme("hermite:" + text);
    CAPTURE(scheme.specification);
    CHECK(axis_rule(scheme.mask, *scheme.form, scheme.quadratic).stencils.degree() == degree);
    for (const Boundary boundary : {Boundary::regression, Boundary::shrink}) {
      const std::vector<std::vector<Rational>> curve{random_coefficients(random, degree),
                                                     random_coefficients(random, degree)};
      const Rational spacing(random.integer(1, 5), 3);
      const Axis axis = Axis::of(fewest_points(scheme, boundary)[0] + 4);
      const GridData<Rational> data{samples(curve, 2, axis, spacing), 4, {axis}};
      const GridData<Rational> refined = refine_vectors(data, scheme.mask, *scheme.form, {3, boundary}, spacing,
                                                        scheme.quadratic);
      CHECK(refined.is_canonical());
      const std::vector<Rational> expected = samples(curve, 2, refined.axes[0], spacing);
      REQUIRE(refined.values.size() == expected.size());
      CHECK(std::ranges::equal(refined.values, expected,
                               [&](const Rational& a, const Rational& b) { return abs(Rational(a - b)) < error; }));
    }
  }
  const AnyScheme no_constants = make_data_scheme(
      "hermite:[[[1/2,-1/8],[sqrt(2)/2,0]],[[1,0],[0,1/2]],[[sqrt(2)/2,1/8],[-sqrt(2)/2,0]]]@-1");
  CHECK_THROWS(fewest_points(no_constants, Boundary::regression));
}

TEST_CASE("Hermite data of polynomials are refined exactly, up to the ends") {
  Random random;
  for (const auto& [scheme, degree] : reproducing()) {
    CAPTURE(scheme.specification);
    const std::size_t order = scheme.mask.components();
    const auto arity = static_cast<std::size_t>(scheme.mask.arity());
    CHECK(axis_rule(scheme.mask, *scheme.form).stencils.degree() == degree);
    for (const Boundary boundary : {Boundary::regression, Boundary::shrink})
      for (const std::size_t dimension : {1, 2, 3}) {
        const auto count = fewest_points(scheme, boundary)[0] +
                           (boundary == Boundary::shrink ? 6 : static_cast<std::size_t>(random.integer(0, 4)));
        const Rational spacing(random.integer(1, 5), 3);
        std::vector<std::vector<Rational>> curve;
        for (std::size_t c = 0; c < dimension; ++c) curve.push_back(random_coefficients(random, degree));
        const Axis axis = Axis::of(count);
        const GridData<Rational> data{samples(curve, order, axis, spacing), order * dimension, {axis}};
        const GridData<Rational> refined = refine_vectors(data, scheme.mask, *scheme.form, {2, boundary}, spacing);
        CHECK(refined.is_canonical());
        CHECK(refined.values == samples(curve, order, refined.axes[0], spacing));
        if (boundary == Boundary::regression && scheme.specification.find("hermite:") != 0)
          CHECK(refined.axes[0].count == (count - 1) * arity * arity + 1);
      }
  }
}

TEST_CASE("vectors are refined as the rule is defined") {
  Random random;
  for ([[maybe_unused]] const auto round : rounds(40)) {
    const VectorForm form = random.chance(50) ? VectorForm::hermite : VectorForm::vector;
    const auto size = static_cast<std::size_t>(random.integer(2, 4)),
               block = static_cast<std::size_t>(random.integer(1, 3));
    const LatticeMask mask = random_mask(random, size, static_cast<int>(random.integer(2, 4)), form);
    const Boundary boundary = random.chance(50) ? Boundary::periodic : Boundary::shrink;
    const auto count = static_cast<std::size_t>(boundary == Boundary::periodic ? random.integer(1, 9)
                                                                               : random.integer(12, 20));
    GridData<Rational> data{{}, size * block, {Axis::of(count)}};
    while (data.values.size() < count * data.dimension) data.values.push_back(random.rational());
    GridData<Rational> expected = data;
    if (boundary == Boundary::periodic) expected.axes[0].close();
    std::vector<double> rounded;
    for (const Rational& value : data.values) rounded.push_back(nearest_double(value));
    for (int level = 1; level <= 2; ++level) {
      const GridData<Rational> refined = refine_vectors(data, mask, form, {level, boundary});
      expected.values = step_by_definition(mask, form, expected, refined.axes[0], level - 1);
      expected.axes = refined.axes;
      CHECK(refined.values == expected.values);
      const std::vector<double> near =
          refine_vectors(GridData<double>{rounded, data.dimension, data.axes}, mask, form, {level, boundary, 2}).values;
      REQUIRE(near.size() == expected.values.size());
      double largest = 0, error = 0;
      for (std::size_t i = 0; i < near.size(); ++i) {
        largest = std::max(largest, std::abs(near[i]));
        error = std::max(error, std::abs(near[i] - nearest_double(expected.values[i])));
      }
      CHECK(error <= 1e-11 * largest);
    }
  }
}

TEST_CASE("a mask for each level refines vectors as its rule is defined, and polynomials that all keep exactly") {
  Random random;
  for ([[maybe_unused]] const auto round : rounds(10)) {
    const VectorForm form = random.chance(50) ? VectorForm::hermite : VectorForm::vector;
    const auto size = static_cast<std::size_t>(random.integer(2, 3));
    const int arity = static_cast<int>(random.integer(2, 3));
    LevelMasks masks;
    for (long k = random.integer(0, 2); k > 0; --k) masks.first.push_back(random_mask(random, size, arity, form));
    for (long k = random.integer(1, 2); k > 0; --k) masks.again.push_back(random_mask(random, size, arity, form));
    const Boundary boundary = random.chance(50) ? Boundary::periodic : Boundary::shrink;
    GridData<Rational> data{{}, size, {Axis::of(boundary == Boundary::periodic ? 5 : 25)}};
    while (data.values.size() < data.axes[0].count * size) data.values.push_back(random.rational());
    GridData<Rational> expected = data;
    if (boundary == Boundary::periodic) expected.axes[0].close();
    for (int level = 1; level <= 4; ++level) {
      const GridData<Rational> refined = refine_vectors(data, masks, form, {level, boundary});
      expected.values = step_by_definition(masks.at(static_cast<std::size_t>(level - 1)), form, expected,
                                           refined.axes[0], level - 1);
      expected.axes = refined.axes;
      CHECK(refined.values == expected.values);
    }
  }
  // Cubic and quintic Hermite interpolation in turn, in a spacing of its own, up to the ends.
  const LevelDependentScheme both = levels_in_turn({"hermite-dd:points=4,order=2"}, {"hermite-dd:points=2,order=2"});
  const Rational spacing(2, 3);
  const Axis axis = Axis::of(6);
  const std::vector<std::vector<Rational>> curve{random_coefficients(random, 3)};
  const GridData<Rational> data{samples(curve, 2, axis, spacing), 2, {axis}},
      refined = refine_vectors(data, both.masks, *both.form, {3, Boundary::regression}, spacing);
  CHECK(refined.axes[0].count == 41);
  CHECK(refined.values == samples(curve, 2, refined.axes[0], spacing));
  CHECK_FAILS(refine_vectors(data, LevelMasks{{both.masks.at(0)}, {}}, VectorForm::hermite, {2}), domain);
  CHECK_FAILS(refine_vectors(data, LevelMasks{}, VectorForm::hermite, {0}), domain);
}

TEST_CASE("levels in turn are of one kind") {
  const std::string hermite = "hermite-dd:points=2,order=2";
  CHECK_FAILS(levels_in_turn({}, {}), domain);
  CHECK_FAILS(levels_in_turn({}, {hermite, "hermite-dd:points=2,order=3"}), domain);
  CHECK_FAILS(levels_in_turn({}, {hermite, "ghm"}), domain);
  CHECK_FAILS(levels_in_turn({"dd:n=2"}, {hermite}), domain);
  CHECK_FAILS(levels_in_turn({}, {"dd:n=2", "bspline:degree=3,a=3"}), domain);
  CHECK_FAILS(levels_in_turn({}, {"cl:2"}), domain);
  CHECK_THROWS_AS(levels_in_turn({}, {"hermite-dd:"}), SpecificationError);
  const LevelDependentScheme splines = levels_in_turn({}, {"ghm", "bspline:degree=3,multiplicity=2"});
  CHECK(splines.form == VectorForm::vector);
  CHECK(period_of(splines).mask.arity() == 4);
  CHECK_FALSE(levels_in_turn({}, {"dd:n=2", "bspline:degree=3"}).form);
}

TEST_CASE("components without a link are refined as numbers are") {
  const LatticeMask both = make_refinable_scheme(
                               "vector:[[[-1,0],[0,0]],[[0,0],[0,2]],[[9,0],[0,8]],[[16,0],[0,12]],"
                               "[[9,0],[0,8]],[[0,0],[0,2]],[[-1,0],[0,0]]]/16@-3")
                               .mask;
  Random random;
  GridData<Rational> data{{}, 2, {Axis::of(9, true)}};
  for (int i = 0; i < 18; ++i) data.values.push_back(random.rational());
  const std::vector<Rational> refined = refine_vectors(data, both, VectorForm::vector, {3}).values;
  for (std::size_t c = 0; c < 2; ++c) {
    GridData<Rational> one{{}, 1, data.axes};
    for (std::size_t i = 0; i < 9; ++i) one.values.push_back(data.values[2 * i + c]);
    const auto alone = refine(one, make_linear_scheme(c == 0 ? "dd:n=2" : "mask:[1,4,6,4,1]/8").mask, {3}).values;
    for (std::size_t i = 0; i < alone.size(); ++i) CHECK(refined[2 * i + c] == alone[i]);
  }
}

TEST_CASE("inserted knots keep a spline that is 1") {
  for (const char* text : {"bspline:degree=3,multiplicity=2", "bspline:degree=2,multiplicity=2,a=3"}) {
    const Scheme scheme = make_refinable_scheme(text);
    const GridData<double> ones{std::vector<double>(16, 1), 2, {Axis::of(8)}};
    for (const double value : refine(ones, scheme, {3, Boundary::shrink}).values) CHECK(std::abs(value - 1) < 1e-14);
  }
}

TEST_CASE("data with positions have derivatives by these") {
  const AnyScheme scheme = make_data_scheme("hermite-dd:points=2,order=2");
  GridData<double> data{{}, 3, {Axis::of(5)}};
  for (const double x : {1.0, 1.1, 1.2, 1.3, 1.4})
    for (const double number : {x, x * x * x, 3 * x * x}) data.values.push_back(number);
  const GridData<double> refined = refine(data, scheme, {3});
  CHECK(refined.dimension == 3);
  REQUIRE(refined.points() == 33);
  for (std::size_t i = 0; i < 33; ++i) {
    const double x = 1 + 0.1 * static_cast<double>(i) / 8;
    CHECK(std::abs(refined.values[3 * i] - x) < 1e-15);
    CHECK(std::abs(refined.values[3 * i + 1] - x * x * x) < 1e-14);
    CHECK(std::abs(refined.values[3 * i + 2] - 3 * x * x) < 1e-13);
  }
  // What was given comes back bit by bit.
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t c = 0; c < 3; ++c) CHECK(refined.values[24 * i + c] == data.values[3 * i + c]);
  CHECK(without_derivatives(scheme, refined).dimension == 2);
}

TEST_CASE("data that are none of vectors are refused") {
  const auto with = [](const std::string& text, std::vector<double> values, std::size_t dimension,
                       const RefineOptions& options = {}) {
    return refine(curve_data(std::move(values), dimension), make_data_scheme(text), options);
  };
  const std::vector<double> zeros(24, 0);
  CHECK_FAILS(with("hermite-dd:points=2,order=3", zeros, 2), data);
  CHECK_FAILS(with("hermite-dd:points=2,order=2", zeros, 1), data);
  CHECK_FAILS(with("hermite-dd:points=2,order=2", zeros, 3), data);
  CHECK_FAILS(with("hermite-dd:points=2,order=2", {0, 1, 1, 1, 1, 1, 3, 1, 1}, 3), data);
  CHECK_FAILS(with("hermite-dd:points=2,order=2", {0, 1, 1}, 3, {1, Boundary::periodic}), data);
  CHECK_FAILS(with("vector:[[[1,0],[0,1]],[[1,0],[0,1]]]", zeros, 3, {1, Boundary::shrink}), data);
  CHECK_FAILS(with("hermite-dd:points=2,order=2", zeros, 2, {1, Boundary::reflect}), domain);
  CHECK_FAILS(with("ghm", zeros, 2), domain);
  CHECK_FAILS(with("ghm", zeros, 2, {1, Boundary::nearest}), domain);
  CHECK_FAILS(with("hermite:[[[1,0],[1,2]],[[2,1],[0,1]]]/2@0", zeros, 2), domain);
  CHECK_FAILS(with("tensor:(ghm)x(bspline:degree=1)", zeros, 2), domain);
  CHECK_FAILS(with("hermite-dd:points=2,order=2", zeros, 2, {-1}), domain);
  CHECK_FAILS(with("hermite-dd:points=2,order=2", zeros, 2, {1000}), size);
  CHECK_FAILS(with("hermite-dd:points=2,order=2", {1e308, 0, -1e308, 0}, 2, {2}), size);
}
