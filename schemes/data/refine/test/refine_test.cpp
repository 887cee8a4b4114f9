#include <subcert/analysis/family/limit_values_of_levels.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/data/refine/slab_refinement.hpp>
#include <subcert/schemes/data/scheme_refinement.hpp>
#include <subcert/schemes/parametric_specification.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace subcert;
using namespace subcert::data;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

const std::vector<std::string> schemes{"primal:n=1",
                                       "primal:n=3",
                                       "primal:n=4,d=3",
                                       "primal-odd:n=2,d=2",
                                       "dual:n=1",
                                       "dual:n=3",
                                       "dual:n=4,d=3",
                                       "dual-odd:n=2",
                                       "dual-odd:n=3,d=4",
                                       "ary:a=3,points=4,d=3",
                                       "ary:a=3,points=5",
                                       "ary:a=4,points=6,d=2",
                                       "ary:a=5,points=3",
                                       "dd:n=2",
                                       "dd:n=3",
                                       "bspline:degree=2",
                                       "bspline:degree=3",
                                       "bspline:degree=4",
                                       "four-point:w=1/20",
                                       "bspline:degree=3,a=3",
                                       "mask:[1,3,3,1]/4@0",
                                       "mask:[1,3,3,1]/4@7",
                                       "mask:[1,1]",
                                       "regression:stencils=[0..3;-1..2],at=[0;1/2],d=2",
                                       "regression:stencils=[-3..0;-2..3],at=[-1/3;1/6],d=1"};

Rational evaluate(const std::vector<Rational>& polynomial, const Rational& x) {
  Rational sum = 0;
  for (std::size_t k = polynomial.size(); k-- > 0;) sum = sum * x + polynomial[k];
  return sum;
}

std::vector<Rational> random_polynomial(Random& random, int degree) {
  std::vector<Rational> result;
  for (int k = 0; k <= degree; ++k) result.push_back(random.rational() / (1 + k));
  return result;
}

std::vector<double> doubles(const std::vector<Rational>& values) {
  std::vector<double> result;
  for (const Rational& value : values) result.push_back(nearest_double(value));
  return result;
}

/// f'_i for data of any length that is zero outside, from the definition.
Rational by_definition(const Mask& mask, const std::vector<Rational>& data, long offset, long i) {
  Rational sum = 0;
  for (std::size_t j = 0; j < data.size(); ++j)
    sum += mask.symbol().coefficient(i - mask.arity() * (static_cast<long>(j) + offset)) * data[j];
  return sum;
}

}  // namespace

TEST_CASE("polynomials of the reproduction degree are refined exactly, up to the ends") {
  Random random;
  for (const std::string& text : schemes)
    for (const Boundary boundary : {Boundary::regression, Boundary::shrink})
      for (const std::size_t dimension : {1, 2, 3}) {
        const Mask mask = make_scheme(text).mask.curve();
        const std::size_t count = AxisRefiner(mask, boundary).window() +
                                  (boundary == Boundary::shrink ? 12 : random.integer(0, 9));
        std::vector<std::vector<Rational>> polynomials;
        for (std::size_t c = 0; c < dimension; ++c)
          polynomials.push_back(random_polynomial(random, polynomial_reproduction(mask).reproduction_degree));
        std::vector<Rational> values;
        for (std::size_t j = 0; j < count; ++j)
          for (const auto& p : polynomials) values.push_back(evaluate(p, j));
        const int levels = 3;
        CAPTURE(text, to_text(boundary), dimension, count);
        const auto exact = refine(curve_data(values, dimension), mask, {levels, boundary, 1});
        const auto rounded = refine(curve_data(doubles(values), dimension), mask, {levels, boundary, 2});
        REQUIRE(exact.is_canonical());
        REQUIRE(rounded.values.size() == exact.values.size());
        const Axis& axis = exact.axes[0];
        CHECK(axis.step == power(Rational(mask.arity()), -levels));
        if (boundary == Boundary::regression) {  // the points cover the domain of the data, and no more
          CHECK((axis.first >= 0 && axis.first < axis.step));
          const Rational last = axis.parameter(axis.count - 1);
          CHECK((last <= Rational(count - 1) && last > Rational(count - 1) - axis.step));
        }
        Rational largest = 0;
        for (const Rational& value : values) largest = std::max(largest, Rational(abs(value)));
        for (std::size_t i = 0; i < axis.count; ++i)
          for (std::size_t c = 0; c < dimension; ++c) {
            const Rational& value = exact.values[i * dimension + c];
            CHECK(value == evaluate(polynomials[c], axis.parameter(i)));
            CHECK(std::abs(rounded.values[i * dimension + c] - nearest_double(value)) <=
                  2e-13 * nearest_double(largest));
          }
      }
}

TEST_CASE("the definition of a step, with data repeated or mirrored by hand") {
  Random random;
  for (const std::string& text : schemes) {
    const Mask mask = make_scheme(text).mask.curve();
    const long arity = mask.arity();
    const Rational tau = polynomial_reproduction(mask).parametrization.front() * (arity - 1);
    for (const auto round : rounds(3)) {
      const long count = static_cast<long>(AxisRefiner(mask, Boundary::shrink).window()) + random.integer(1, 7);
      std::vector<Rational> data;
      for (long j = 0; j < count; ++j) data.push_back(random.rational());
      const long many = support(mask).last - support(mask).first + std::abs(support(mask).first) + 2;
      const auto extended = [&](auto index) {
        std::vector<Rational> result;
        for (long j = -many; j < count + many; ++j) result.push_back(data[static_cast<std::size_t>(index(j))]);
        return result;
      };
      const auto mirror = extended([&](long j) {
        const long period = 2 * (count - 1), m = (j % period + period) % period;
        return m < count ? m : period - m;
      });
      CAPTURE(text, count);
      // Also of fewer periodic data than the rules read.
      for (const long few : {1L, 2L, 3L, count})
        for (const bool closed : {true, false}) {
          const std::vector<Rational> first(data.begin(), data.begin() + few);
          std::vector<Rational> repeated;
          for (long j = -many; j < few + many; ++j)
            repeated.push_back(first[static_cast<std::size_t>((j % few + few) % few)]);
          const auto refined = refine(curve_data(first, 1, closed), mask, {1, Boundary::periodic, 1});
          REQUIRE(refined.values.size() == static_cast<std::size_t>(arity * few));
          CHECK(refined.axes[0].closed);
          for (std::size_t i = 0; i < refined.values.size(); ++i) {
            const Rational index = refined.axes[0].parameter(i) * arity + tau;
            REQUIRE(denominator(index) == 1);
            CHECK(refined.values[i] == by_definition(mask, repeated, -many, numerator(index).convert_to<long>()));
          }
        }
      if (denominator(Rational(2 * tau)) != 1) {
        CHECK_FAILS(refine(curve_data(data), mask, {1, Boundary::reflect, 1}), domain);
        continue;
      }
      const auto refined = refine(curve_data(data), mask, {1, Boundary::reflect, 1});
      for (std::size_t i = 0; i < refined.values.size(); ++i) {
        const Rational index = refined.axes[0].parameter(i) * arity + tau;
        CHECK(refined.values[i] == by_definition(mask, mirror, -many, numerator(index).convert_to<long>()));
      }
    }
  }
}

TEST_CASE("mirrored data stay mirrored over several levels") {
  Random random;
  for (const char* text :
       {"primal:n=2", "dual:n=2", "ary:a=3,points=4,d=1", "ary:a=3,points=3,d=1", "bspline:degree=3"}) {
    const Mask mask = make_scheme(text).mask.curve();
    std::vector<Rational> half, whole;
    for (int j = 0; j < 9; ++j) half.push_back(random.rational());
    for (int j = 0; j < 16; ++j) whole.push_back(half[static_cast<std::size_t>(j < 9 ? j : 16 - j)]);
    const auto open = refine(curve_data(half), mask, {3, Boundary::reflect, 1});
    const auto closed = refine(curve_data(whole, 1, true), mask, {3, Boundary::regression, 1});
    CAPTURE(text);
    REQUIRE(open.axes[0].first == closed.axes[0].first);
    CHECK(std::equal(open.values.begin(), open.values.end(), closed.values.begin()));
  }
}

TEST_CASE("interpolatory schemes keep the data, at the ends too") {
  Random random;
  const Mask mask = make_scheme("dd:n=3").mask.curve();
  std::vector<Rational> data;
  for (int j = 0; j < 11; ++j) data.push_back(random.rational());
  for (const Boundary boundary : {Boundary::regression, Boundary::reflect}) {
    const auto refined = refine(curve_data(data), mask, {2, boundary, 1});
    REQUIRE(refined.values.size() == 41);
    for (std::size_t j = 0; j < data.size(); ++j) CHECK(refined.values[4 * j] == data[j]);
  }
}

TEST_CASE("threads and blocks do not change a bit") {
  Random random;
  for (const char* text : {"primal:n=3", "dual:n=6", "ary:a=3,points=5,d=1", "ary:a=5,points=4,d=1"})
    for (const std::size_t dimension : {1, 2, 3, 5, 300}) {
      const Mask mask = make_scheme(text).mask.curve();
      const std::size_t count = 200000 / dimension + 17;
      std::vector<double> data;
      for (std::size_t i = 0; i < count * dimension; ++i)
        data.push_back(static_cast<double>(random.integer(-1000, 1000)) / 7);
      const auto one = refine(curve_data(data, dimension), mask, {1, Boundary::regression, 1});
      const auto many = refine(curve_data(data, dimension), mask, {1, Boundary::regression, 5});
      CHECK(one.values == many.values);
      std::vector<double> first;
      for (std::size_t i = 0; i < count; ++i) first.push_back(data[i * dimension]);
      const auto alone = refine(curve_data(first), mask, {1, Boundary::regression, 1});
      bool same = true;
      for (std::size_t i = 0; i < alone.values.size(); ++i) same = same && alone.values[i] == one.values[i * dimension];
      CHECK(same);
    }
}

TEST_CASE("tensor products on grids reproduce products of polynomials") {
  Random random;
  const std::vector<std::vector<std::string>> cases{{"primal:n=2,d=3", "dual:n=2"},
                                                    {"dd:n=2", "bspline:degree=2"},
                                                    {"dual-odd:n=1", "primal:n=2", "ary:a=3,points=4,d=3"}};
  for (const auto& texts : cases)
    for (const std::size_t dimension : {1, 3}) {
      std::vector<Mask> masks;
      std::vector<Axis> axes;
      std::vector<std::vector<Rational>> polynomials;
      std::size_t points = 1;
      for (const std::string& text : texts) {
        masks.push_back(make_scheme(text).mask.curve());
        axes.push_back(Axis::of(6 + static_cast<std::size_t>(random.integer(0, 3))));
        points *= axes.back().count;
        polynomials.push_back(random_polynomial(random, polynomial_reproduction(masks.back()).reproduction_degree));
      }
      const auto value_at = [&](const std::vector<Axis>& grid, std::size_t point) {
        Rational product = 1;
        for (std::size_t k = 0; k < grid.size(); ++k) {
          product *= evaluate(polynomials[k], grid[k].parameter(point % grid[k].count));
          point /= grid[k].count;
        }
        return product;
      };
      GridData<Rational> data{{}, dimension, axes};
      for (std::size_t i = 0; i < points; ++i)
        for (std::size_t c = 0; c < dimension; ++c) data.values.push_back(value_at(axes, i) * (1 + Rational(c)));
      const GridData<double> rounded{doubles(data.values), dimension, axes};
      const auto exact = refine(data, tensor_product(masks), {2, Boundary::regression, 1});
      const auto approximate = refine(rounded, tensor_product(masks), {2, Boundary::regression, 2});
      REQUIRE(exact.is_canonical());
      REQUIRE(approximate.values.size() == exact.values.size());
      double scale = 0;
      for (double value : rounded.values) scale = std::max(scale, std::abs(value));
      for (std::size_t i = 0; i < exact.points(); ++i)
        for (std::size_t c = 0; c < dimension; ++c) {
          CHECK(exact.values[i * dimension + c] == value_at(exact.axes, i) * (1 + Rational(c)));
          CHECK(std::abs(approximate.values[i * dimension + c] - nearest_double(exact.values[i * dimension + c])) <=
                1e-12 * scale);
        }
    }
}

TEST_CASE("fits on grids reproduce polynomials of their total degree, up to the ends") {
  Random random;
  struct Case {
    const char* scheme;
    std::vector<std::size_t> counts;
    int levels;
  };
  const std::vector<Case> cases{{"grid:points=4x4,d=3", {6, 5}, 2},      {"grid:points=5x5,d=2", {5, 7}, 2},
                                {"grid:points=4x5,d=1", {9, 6}, 3},      {"grid:points=3x3,d=2,a=3", {4, 5}, 2},
                                {"grid:points=2x2x2,d=1", {4, 3, 5}, 2}, {"grid:points=3x4x3,d=2", {4, 4, 5}, 1}};
  for (const Case& one : cases)
    for (const Boundary boundary : {Boundary::regression, Boundary::shrink})
      for (const std::size_t dimension : {1, 3}) {
        const Scheme scheme = make_linear_scheme(one.scheme);
        const int degree = polynomial_reproduction(scheme.mask).reproduction_degree;
        std::vector<Axis> axes;
        for (const std::size_t count : one.counts)
          axes.push_back(Axis::of(count + (boundary == Boundary::shrink ? 3 : 0)));
        // A power of a linear form has total degree `degree` and all mixed terms.
        std::vector<Rational> form;
        for (std::size_t k = 0; k <= axes.size(); ++k) form.push_back(random.nonzero());
        const auto value_at = [&](const std::vector<Axis>& grid, std::size_t point) {
          Rational linear = form.back(), product = 1;
          for (std::size_t k = 0; k < grid.size(); ++k) {
            linear += form[k] * grid[k].parameter(point % grid[k].count);
            point /= grid[k].count;
          }
          for (int k = 0; k < degree; ++k) product *= linear;
          return product;
        };
        GridData<Rational> data{{}, dimension, axes};
        for (std::size_t i = 0; i < data.points(); ++i)
          for (std::size_t c = 0; c < dimension; ++c) data.values.push_back(value_at(axes, i) - Rational(c));
        const GridData<double> rounded{doubles(data.values), dimension, axes};
        CAPTURE(one.scheme, to_text(boundary), dimension);
        const auto exact = refine(data, scheme.mask, {one.levels, boundary, 2});
        const auto approximate = refine(rounded, scheme.mask, {one.levels, boundary, 1});
        REQUIRE(exact.is_canonical());
        REQUIRE(approximate.values.size() == exact.values.size());
        double scale = 1;
        for (double value : rounded.values) scale = std::max(scale, std::abs(value));
        bool equal = true, near = true;
        for (std::size_t i = 0; i < exact.points(); ++i)
          for (std::size_t c = 0; c < dimension; ++c) {
            equal = equal && exact.values[i * dimension + c] == value_at(exact.axes, i) - Rational(c);
            near = near && std::abs(approximate.values[i * dimension + c] -
                                    nearest_double(exact.values[i * dimension + c])) <= 1e-12 * scale;
          }
        CHECK(equal);
        CHECK(near);
      }
}

TEST_CASE("a product is refined the same by its factors and by its mask") {
  Random random;
  for (const char* text : {"tensor:(primal:n=2)x(dual:n=2)", "tensor:(dd:n=2)x(bspline:degree=2)",
                           "tensor:(dual:n=1)x(dual:n=1)x(primal:n=1)"})
    for (const Boundary boundary : {Boundary::reflect, Boundary::periodic, Boundary::shrink})
      for (const bool closed : {false, true}) {
        const Scheme scheme = make_linear_scheme(text);
        std::vector<Axis> axes;
        for (std::size_t v = 0; v < scheme.mask.factors().size(); ++v)
          axes.push_back(Axis::of(6 + static_cast<std::size_t>(random.integer(0, 2)), closed && v == 0));
        GridData<Rational> data{{}, 2, axes};
        for (std::size_t i = 0; i < 2 * data.points(); ++i) data.values.push_back(random.rational());
        CAPTURE(text, to_text(boundary), closed);
        const auto by_factors = refine(data, scheme.mask, {2, boundary, 1});
        const auto by_mask = refine(data, scheme.mask.without_factors(), {2, boundary, 1});
        CHECK(by_factors.values == by_mask.values);
        for (std::size_t v = 0; v < axes.size(); ++v) {
          CHECK(by_factors.axes[v].first == by_mask.axes[v].first);
          CHECK(by_factors.axes[v].closed == by_mask.axes[v].closed);
        }
      }
}

TEST_CASE("doubles and exact numbers agree on closed grids, for any number of threads") {
  Random random;
  for (const char* text : {"grid:points=4x4,d=3", "grid:points=3x3,d=1,a=3", "grid:points=2x3x2,d=1"}) {
    const Scheme scheme = make_linear_scheme(text);
    std::vector<Axis> axes{Axis::of(9, true), Axis::of(6, false)};
    if (scheme.mask.dimension() == 3) axes.push_back(Axis::of(4, true));
    GridData<Rational> data{{}, 3, axes};
    for (std::size_t i = 0; i < 3 * data.points(); ++i) data.values.push_back(random.integer(-99, 99));
    const GridData<double> rounded{doubles(data.values), 3, axes};
    const auto exact = refine(data, scheme.mask, {2, Boundary::regression, 1});
    const auto one = refine(rounded, scheme.mask, {2, Boundary::regression, 1});
    double largest = 0;
    for (std::size_t i = 0; i < exact.values.size(); ++i)
      largest = std::max(largest, std::abs(one.values[i] - nearest_double(exact.values[i])));
    CHECK(largest <= 1e-11);
    CHECK(refine(rounded, scheme.mask, {3, Boundary::regression, 1}).values ==
          refine(rounded, scheme.mask, {3, Boundary::regression, 4}).values);
  }
}

TEST_CASE("questions without an answer are refused") {
  const Mask mask = make_scheme("primal:n=3").mask.curve();
  const std::vector<double> data{1, 2, 3, 4, 5, 6};
  CHECK_FAILS(refine(curve_data(data), mask, {100000000, Boundary::regression, 1}), size);
  CHECK_FAILS(refine(curve_data(data), mask, {-1, Boundary::regression, 1}), domain);
  CHECK_FAILS(refine(curve_data(std::vector<double>{1, 2, 3, 4, 5}), mask, {1, Boundary::regression, 1}), domain);
  CHECK_FAILS(refine(GridData<double>{data, 4, {Axis::of(2)}}, mask, {1, Boundary::regression, 1}), domain);
  CHECK_FAILS(refine(curve_data(data), tensor_product({mask, mask}), {1, Boundary::regression, 1}), domain);
  CHECK_FAILS(refine(curve_data(data), Mask(LaurentPolynomial({1, 1, 1}, 0), 2), {1, Boundary::regression, 1}), domain);
  CHECK(refine(curve_data(data), mask, {0, Boundary::regression, 1}).values == data);
  CHECK(refine(curve_data(data), mask, {1, Boundary::shrink, 1}).values.size() == 3);
}

TEST_CASE("nearest doubles") {
  CHECK(nearest_double(Rational(1, 3)) == 1.0 / 3);
  CHECK(nearest_double(Rational(2, 3)) == 2.0 / 3);
  CHECK(nearest_double(Rational(-7, 10)) == -0.7);
  CHECK(nearest_double(0) == 0);
}

TEST_CASE("slabs have the bits of the whole") {
  std::mt19937 engine(3);
  const auto random = [&](std::size_t numbers) {
    std::vector<double> values;
    for (std::size_t i = 0; i < numbers; ++i) values.push_back(static_cast<double>(engine()) / 1e9 - 2);
    return values;
  };
  struct Case {
    const char* scheme;
    std::vector<std::size_t> counts;
    std::size_t dimension;
    int levels;
  };
  const Case cases[] = {{"primal:n=3", {12}, 2, 9},
                        {"dual:n=2", {40}, 1, 14},
                        {"primal:n=3", {3}, 1, 6},
                        {"bspline:degree=3,a=3", {50}, 3, 5},
                        {"tensor:(primal:n=2)x(dual:n=3)", {9, 14}, 1, 6},
                        {"tensor:(dd:n=2)x(dd:n=2)", {9, 8}, 4, 4},
                        {"tensor:(primal:n=1)x(dd:n=2)x(dual:n=2)", {3, 9, 11}, 2, 3},
                        {"grid:points=4x4,d=3", {9, 23}, 2, 4},
                        {"grid:points=3x3,d=1,a=3", {6, 7}, 1, 3},
                        {"butterfly:w=1/16", {8, 9}, 3, 4},
                        {"grid:points=2x3x2,d=1", {5, 4, 9}, 1, 3},
                        {"l1:points=6", {12}, 2, 9},
                        {"l1:points=5,d=2", {40}, 1, 12},
                        {"l1:points=4,a=3", {9}, 3, 6},
                        {"l1:points=8,residuals=joint", {31}, 2, 6},
                        {"l1:points=4x3", {9, 8}, 2, 5},
                        {"l1:points=2x3x4", {3, 5, 6}, 1, 3}};
  for (const Case& one : cases)
    for (const Boundary boundary : {Boundary::regression, Boundary::reflect, Boundary::periodic, Boundary::shrink})
      for (const bool closed : {false, true}) {
        CAPTURE(one.scheme, to_text(boundary), closed);
        GridData<double> data{{}, one.dimension, {}};
        for (const std::size_t count : one.counts) data.axes.push_back(Axis::of(count, closed));
        data.values = random(data.points() * data.dimension);
        const AnyScheme scheme = make_data_scheme(one.scheme);
        const std::vector<std::size_t> fewest = fewest_points(scheme, closed ? Boundary::periodic : boundary);
        bool few = false;
        for (std::size_t k = 0; k < fewest.size(); ++k) few = few || one.counts[k] < fewest[k];
        if (few) continue;
        const RefineOptions options{one.levels, boundary, 2};
        const auto check = [&](SliceSteps steps, const GridData<double>& whole) {
          const SlabRefinement slabs(data, std::move(steps));
          std::vector<double> values;
          slabs.run([&](const double* some, std::size_t points) {
            values.insert(values.end(), some, some + points * data.dimension);
          });
          CHECK(values == whole.values);
          for (std::size_t k = 0; k < whole.axes.size(); ++k) {
            CHECK(slabs.axes()[k].count == whole.axes[k].count);
            CHECK(slabs.axes()[k].first == whole.axes[k].first);
            CHECK(slabs.axes()[k].step == whole.axes[k].step);
          }
        };
        check(std::move(*refinement_steps(data.axes, data.dimension, scheme, options)), refine(data, scheme, options));
        const auto* linear = std::get_if<Scheme>(&scheme);
        if (!linear || !linear->mask.has_factors()) continue;
        const RefineOptions fewer{std::max(0, one.levels - 3), boundary, 2};
        check(limit_steps(data.axes, data.dimension, linear->mask, fewer), limit_of_data(data, linear->mask, fewer));
      }
  const GridData<double> line = curve_data<double>({1, 2, 3, 4});
  CHECK_FAILS(refinement_steps(line.axes, 1, make_data_scheme("primal:n=1"), {60, Boundary::regression, 1}), size);
  CHECK_FAILS(refinement_steps(line.axes, 1, make_data_scheme("l1:points=4"), {60, Boundary::regression, 1}), size);
  CHECK_FAILS(limit_steps(line.axes, 1, make_scheme("primal:n=1").mask, {60, Boundary::regression, 1}), size);
  CHECK_FAILS(refinement_steps(line.axes, 1, make_data_scheme("loop"), {1, Boundary::regression, 1}), domain);
}

TEST_CASE("refinement with a mask for each level") {
  Random random;
  const LatticeMask a = make_scheme("dd:n=2").mask, b = make_scheme("bspline:degree=4").mask,
                    c = make_scheme("dual:n=2").mask;
  for (const Boundary boundary : {Boundary::regression, Boundary::reflect, Boundary::periodic, Boundary::shrink})
    for (const LevelMasks& masks :
         {LevelMasks{{}, {a}}, LevelMasks{{}, {a, b}}, LevelMasks{{c}, {b, a}}, LevelMasks{{b, c, a}, {}}}) {
      CAPTURE(to_text(boundary), masks.first.size());
      std::vector<Rational> values;
      for (int i = 0; i < 24; ++i) values.push_back(random.rational());
      const GridData<Rational> data = curve_data<Rational>(values, 2);
      GridData<Rational> one_by_one = data;
      for (std::size_t level = 0; level < 3; ++level)
        one_by_one = refine(one_by_one, masks.at(level), {1, boundary, 1});
      const GridData<Rational> found = refine(data, masks, {3, boundary, 1});
      CHECK(found.values == one_by_one.values);
      CHECK(found.axes[0].first == one_by_one.axes[0].first);
    }
  // The data and what lies beyond them are followed by slices, too.
  const AnyScheme scheme = LevelDependentScheme{"a, b", {{c}, {a, b}}};
  const GridData<double> line = curve_data<double>({1, 4, 2, 8, 5, 7, 3, 9});
  for (const Boundary boundary : {Boundary::regression, Boundary::nearest}) {
    const RefineOptions how{3, boundary, 1};
    CHECK(SlabRefinement(line, *refinement_steps(line.axes, 1, scheme, how)).whole().values ==
          refine(line, scheme, how).values);
  }
  CHECK(fewest_points(scheme, Boundary::regression) == fewest_points(c, Boundary::regression));
  CHECK_FAILS(refine(line, LevelMasks{{a}, {}}, {2, Boundary::regression, 1}), domain);
  CHECK_FAILS(refine(line, LevelMasks{{a}, {make_scheme("bspline:degree=3,a=3").mask}}, {2, Boundary::regression, 1}),
              domain);
  CHECK_FAILS(refine(line, LevelMasks{{}, {a}}, {60, Boundary::regression, 1}), size);
}

TEST_CASE("refinement with a mask for each level keeps the points of an ellipse") {
  const LevelMasks masks = masks_of_levels(make_parametric_scheme("conic-four-point:v").mask,
                                           Recurrence::parse("v=sqrt((1+v)/2)", "v", 'v'), Rational(1, 2), 6);
  std::vector<double> corners;
  for (int j = 0; j < 3; ++j) {
    corners.push_back(3 * std::cos(2 * std::numbers::pi * j / 3));
    corners.push_back(2 * std::sin(2 * std::numbers::pi * j / 3));
  }
  const GridData<double> found = refine(curve_data(corners, 2, true), masks, {6, Boundary::periodic, 1});
  REQUIRE(found.points() == 192);
  for (std::size_t j = 0; j < 192; ++j) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(j) / 192;
    CHECK(found.values[2 * j] == Approx(3 * std::cos(angle)).margin(1e-14));
    CHECK(found.values[2 * j + 1] == Approx(2 * std::sin(angle)).margin(1e-14));
  }
}
