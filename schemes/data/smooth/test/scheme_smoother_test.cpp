#include <subcert/analysis/variance/variance.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/data/smooth/scheme_smoother.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <cmath>

using namespace subcert;
using namespace subcert::data;
using subcert::testing::Random;

namespace {

Rational apply_exactly(const SmoothingRow& row, const std::vector<Rational>& data) {
  Rational sum = 0;
  for (std::size_t k = 0; k < row.weights.size(); ++k) sum += row.weights[k] * data[row.first + k];
  return sum;
}

std::vector<Rational> polynomial_data(std::size_t count, int degree) {
  std::vector<Rational> data;
  for (std::size_t i = 0; i < count; ++i)
    data.push_back(power(Rational(i) - 3, degree) + (degree > 0 ? Rational(i, 2) : 0));
  return data;
}

Rational polynomial_at(const Rational& x, int degree) {
  return power(x - 3, degree) + (degree > 0 ? Rational(x / 2) : 0);
}

}  // namespace

TEST_CASE("regression reproduces the polynomials of the scheme up to the ends, exactly") {
  for (const auto& [text, degree] : {std::pair{"primal:n=3", 1},
                                     {"dual:n=2", 1},
                                     {"primal:n=3,d=3", 3},
                                     {"dual-odd:n=2,d=2", 2},
                                     {"dd:n=2", 3},
                                     {"bspline:degree=3", 1},
                                     {"ary:a=3,points=5,d=1", 1}}) {
    const Scheme scheme = make_scheme(text);
    for (const std::size_t count : {std::size_t{9}, std::size_t{25}}) {
      const SchemeSmoother smoother(scheme.mask.curve(), count, {Boundary::regression, 1, 0});
      for (int q = 0; q <= degree; ++q) {
        const auto data = polynomial_data(count, q);
        for (std::size_t o = 0; o < smoother.outputs(); ++o)
          CHECK(apply_exactly(smoother.row(o), data) == polynomial_at(smoother.position(o), q));
      }
    }
  }
}

TEST_CASE("every boundary keeps constants, but for constant, and sums up variances") {
  const Scheme scheme = make_scheme("primal:n=2");
  for (const Boundary kind :
       {Boundary::regression, Boundary::reflect, Boundary::nearest, Boundary::constant, Boundary::periodic})
    for (const std::size_t count : {std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{20}}) {
      const SchemeSmoother smoother(scheme.mask.curve(), count, {kind, 1, 0});
      for (std::size_t o = 0; o < smoother.outputs(); ++o) {
        const SmoothingRow row = smoother.row(o);
        Rational sum = row.outside, squares = 0;
        for (const Rational& weight : row.weights) {
          sum += weight;
          squares += weight * weight;
        }
        CHECK(sum == 1);
        CHECK(row.variance == squares);
        CHECK((kind == Boundary::constant || row.outside == 0));
      }
    }
}

TEST_CASE("away from the ends the variance is psi, exactly") {
  for (const char* text : {"primal:n=3", "primal:n=2,d=3", "dual:n=3", "ary:a=3,points=3,d=1"}) {
    const Scheme scheme = make_scheme(text);
    const SchemeSmoother smoother(scheme.mask.curve(), 41, {Boundary::reflect, 2, 0});
    const VarianceGrid psi = variance_grid(scheme.mask.curve(), 2, false);
    const auto scale = psi.values.size() - 1;
    const bool shifted = std::string(text).starts_with("dual");  // by half a spacing
    for (std::size_t t = 0; t < scale; ++t)
      CHECK(smoother.row(20 * scale + t).variance == psi.values[(t + (shifted ? scale / 2 : 0)) % scale]);
  }
}

TEST_CASE("the rows agree with many refinements of the extended data") {
  const Scheme scheme = make_scheme("dual:n=2");
  Random random;
  std::vector<Rational> data;
  for (int i = 0; i < 12; ++i) data.push_back(random.rational());
  for (const Boundary kind : {Boundary::regression, Boundary::reflect, Boundary::nearest, Boundary::periodic}) {
    const ExtendedData extended(SmoothingKernel(scheme.mask.curve(), scheme.rules, {}, false).extension(kind),
                                data.size());
    LaurentPolynomial values;  // sum of f_j z^j
    for (long j = -14; j < 26; ++j) {
      const auto combination = extended.at<Rational>(j);
      Rational value = 0;
      for (const auto& [index, weight] : combination.terms) value += weight * data[index];
      values += LaurentPolynomial::monomial(value, j);
    }
    const int levels = 7;
    for (int k = 0; k < levels; ++k) values = scheme.mask.curve().symbol() * values.dilated(2);
    // The datum with index i of level k stands at (i + 1/2) / 2^k - 1/2 in the parameter, data index + parameter shift.
    const SchemeSmoother smoother(scheme.mask.curve(), data.size(), {kind, 1, 0});
    for (std::size_t o = 0; o < smoother.outputs(); ++o) {
      const Rational parameter = smoother.position(o) - Rational(1, 2);
      const long index = numerator(Rational(parameter * 128)).convert_to<long>();
      const double refined = static_cast<double>(values.coefficient(index));
      CHECK(std::abs(refined - static_cast<double>(apply_exactly(smoother.row(o), data))) < 0.05);
    }
  }
}

TEST_CASE("the mirror, nearest and periodic data are those of the names") {
  const auto indices = [](Boundary kind) {
    const ExtendedData data({kind, 1, 0}, 4);
    std::vector<std::size_t> result;
    for (long i = -5; i < 9; ++i) result.push_back(data.at<Rational>(i).terms.begin()->first);
    return result;
  };
  CHECK(indices(Boundary::reflect) == std::vector<std::size_t>{1, 2, 3, 2, 1, 0, 1, 2, 3, 2, 1, 0, 1, 2});
  CHECK(indices(Boundary::nearest) == std::vector<std::size_t>{0, 0, 0, 0, 0, 0, 1, 2, 3, 3, 3, 3, 3, 3});
  CHECK(indices(Boundary::periodic) == std::vector<std::size_t>{3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0});
}

TEST_CASE("derivatives are those of the limit") {
  const Scheme scheme = make_scheme("primal:n=3,d=3");
  const SchemeSmoother smoother(scheme.mask.curve(), 15, {Boundary::regression, 2, 1});
  const auto data = polynomial_data(15, 3);
  for (std::size_t o = 0; o < smoother.outputs(); ++o) {
    const Rational x = smoother.position(o);
    CHECK(apply_exactly(smoother.row(o), data) == 3 * (x - 3) * (x - 3) + Rational(1, 2));
  }
}

TEST_CASE("equal prior weights change nothing, missing data leave polynomials alone") {
  for (const char* text : {"primal:n=3", "dual:n=2", "primal:n=4,d=3", "ary:a=3,points=5,d=1"}) {
    const Scheme scheme = make_scheme(text);
    const std::size_t count = 18;
    for (const int derivative : {0, 1}) {
      const SmoothingOptions options{Boundary::regression, 1, derivative};
      const SchemeSmoother plain(scheme.mask.curve(), count, options);
      const SchemeSmoother equal(scheme.mask.curve(), {count, std::vector<Rational>(count, 3)}, options, scheme.rules);
      for (std::size_t o = 0; o < plain.outputs(); ++o) {
        const SmoothingRow a = plain.row(o), b = equal.row(o);
        CHECK(3 * b.variance == a.variance);
        for (std::size_t q = 0; q < 2; ++q) {
          const auto data = polynomial_data(count, static_cast<int>(2 * q));
          CHECK(apply_exactly(a, data) == apply_exactly(b, data));
        }
      }
    }
    std::vector<Rational> weights(count, 1);
    weights[0] = 0;
    weights[7] = 0;
    weights[8] = Rational(1, 2);
    weights[17] = 0;
    const SchemeSmoother gaps(scheme.mask.curve(), {count, weights}, {Boundary::regression, 1, 0}, scheme.rules);
    for (int q = 0; q <= scheme.rules->degree; ++q) {
      const auto data = polynomial_data(count, q);
      for (std::size_t o = 0; o < gaps.outputs(); ++o) {
        const SmoothingRow row = gaps.row(o);
        CHECK(apply_exactly(row, data) == polynomial_at(gaps.position(o), q));
        if (row.first <= 7 && row.first + row.weights.size() > 7) CHECK(row.weights[7 - row.first] == 0);
      }
    }
  }
}

TEST_CASE("double precision agrees with the exact rows") {
  Random random;
  std::vector<double> data;
  std::vector<Rational> exact;
  for (int i = 0; i < 30; ++i) {
    data.push_back(static_cast<double>(random.integer(-1000, 1000)) / 64);
    exact.emplace_back(data.back());
  }
  // The widest rows leave no interior, the narrowest have it from the first spacing on.
  for (const char* text :
       {"primal:n=1", "dual:n=1", "dual:n=3", "primal:n=4,d=3", "primal:n=12", "ary:a=3,points=3,d=1"})
    for (const Boundary kind : {Boundary::regression, Boundary::reflect, Boundary::constant}) {
      const Scheme scheme = make_scheme(text);
      const SchemeSmoother smoother(scheme.mask.curve(), data.size(), {kind, 2, 0, 2.5});
      const auto smoothed = smoother.apply(data);
      REQUIRE(smoothed.values.size() == smoother.outputs());
      REQUIRE(smoothed.leverages.size() == data.size());
      const std::size_t scale = (smoother.outputs() - 1) / (data.size() - 1);
      for (std::size_t o = 0; o < smoother.outputs(); ++o) {
        const SmoothingRow row = smoother.row(o);
        const Rational value = apply_exactly(row, exact) + row.outside * Rational(5, 2);
        CHECK(std::abs(smoothed.values[o] - static_cast<double>(value)) < 1e-12);
        CHECK(smoothed.variances[o] == Approx(static_cast<double>(row.variance)).epsilon(1e-13));
        if (o % scale != 0) continue;
        const std::size_t own = o / scale - row.first;
        CHECK(smoothed.leverages[o / scale] == Approx(static_cast<double>(row.weights.at(own))).margin(1e-14));
      }
    }
}

TEST_CASE("fits with prior weights in double precision agree with the exact ones") {
  Random random;
  for (const auto& [text, boundary] : {std::pair{"primal:n=3", Boundary::regression},
                                       {"primal:n=5,d=5", Boundary::regression},
                                       {"dual:n=4,d=3", Boundary::reflect},
                                       {"primal:n=1", Boundary::constant}}) {
    const Scheme scheme = make_scheme(text);
    std::vector<Rational> weights, exact;
    std::vector<double> data;
    for (int i = 0; i < 30; ++i) {
      weights.push_back(random.chance(10) && i % 3 == 0 && scheme.rules->degree > 1
                            ? Rational(0)
                            : Rational(random.integer(1, 300), 100));
      data.push_back(static_cast<double>(random.integer(-1000, 1000)) / 64);
      exact.emplace_back(data.back());
    }
    const SchemeSmoother smoother(scheme.mask.curve(), {data.size(), weights}, {boundary, 1, 0, 2.5}, scheme.rules);
    const auto smoothed = smoother.apply(data);
    for (std::size_t o = 0; o < smoother.outputs(); ++o) {
      const SmoothingRow row = smoother.row(o);
      const double value = static_cast<double>(Rational(apply_exactly(row, exact) + row.outside * Rational(5, 2)));
      CHECK(smoothed.values[o] == Approx(value).epsilon(1e-10).margin(1e-10));
      CHECK(smoothed.variances[o] == Approx(static_cast<double>(row.variance)).epsilon(1e-10));
    }
  }
}

TEST_CASE("rows that are translates of each other are the exact ones, in every run of equal weights") {
  Random random;
  for (const char* text : {"primal:n=2", "dual-odd:n=2", "ary:a=3,points=3,d=1"}) {
    const Scheme scheme = make_scheme(text);
    constexpr std::size_t count = 90;
    std::vector<Rational> weights(count, 1), exact;
    weights[30] = 0;
    for (std::size_t i = 60; i < count; ++i) weights[i] = 3;
    std::vector<double> data;
    for (std::size_t i = 0; i < count; ++i) {
      data.push_back(static_cast<double>(random.integer(-1000, 1000)) / 64);
      exact.emplace_back(data.back());
    }
    const SchemeSmoother smoother(scheme.mask.curve(), {count, weights}, {Boundary::regression, 1, 0}, scheme.rules);
    const auto smoothed = smoother.apply(data);
    const auto rows = smoother.rounded_rows();
    for (std::size_t o = 0; o < smoother.outputs(); ++o) {
      const SmoothingRow row = smoother.row(o);
      CHECK(smoothed.values[o] == Approx(static_cast<double>(apply_exactly(row, exact))).margin(1e-12));
      CHECK(smoothed.variances[o] == Approx(static_cast<double>(row.variance)).epsilon(1e-12));
      double sum = 0;
      for (std::size_t k = 0; k < rows[o].weights.size(); ++k) sum += rows[o].weights[k] * data[rows[o].first + k];
      CHECK(sum == Approx(smoothed.values[o]).margin(1e-12));
    }
  }
  // More positions than one block has.
  const Scheme scheme = make_scheme("primal:n=4,d=3");
  constexpr std::size_t count = 1300;
  std::vector<double> data;
  for (std::size_t i = 0; i < count; ++i) data.push_back(static_cast<double>(random.integer(-1000, 1000)) / 64);
  const SchemeSmoother smoother(scheme.mask.curve(), count, {Boundary::reflect, 1, 0});
  const auto smoothed = smoother.apply(data);
  for (std::size_t o = 0; o < smoother.outputs(); o += 7) {
    const SmoothingRow row = smoother.row(o);
    double sum = 0;
    for (std::size_t k = 0; k < row.weights.size(); ++k)
      sum += static_cast<double>(row.weights[k]) * data[row.first + k];
    CHECK(smoothed.values[o] == Approx(sum).margin(1e-12));
  }
}

TEST_CASE("smoothers that do not exist say why") {
  const auto contains = [](const std::string& part) { return Catch::Matchers::Contains(part); };
  const Scheme scheme = make_scheme("primal:n=3"), spline = make_scheme("bspline:degree=3");
  CHECK_THROWS_WITH(SchemeSmoother(make_scheme("ary:a=3,points=4").mask.curve(), 10, {}), contains("no 3-adic number"));
  CHECK_THROWS_WITH(SchemeSmoother(spline.mask.curve(), {3, {1, 1, 1}}, {}), contains("scheme of local regressions"));
  CHECK_THROWS_WITH(SchemeSmoother(scheme.mask.curve(), {3, {1, 1}}, {}, scheme.rules), contains("got 2 for 3"));
  CHECK_THROWS_WITH(SchemeSmoother(scheme.mask.curve(), 0, {}), contains("count >= 1"));
  CHECK_THROWS_WITH(SchemeSmoother(scheme.mask.curve(), 2'000'001, {Boundary::regression, 1}),
                    contains("at most 4000000 outputs"));
  CHECK_THROWS_WITH(SchemeSmoother(scheme.mask.curve(), 9, {Boundary::shrink}), contains("got shrink"));
  CHECK_NOTHROW(count_outputs(0, std::size_t{1} << 40));
  std::vector<Rational> weights(20, 0);
  weights[0] = weights[19] = 1;
  const SchemeSmoother gap(scheme.mask.curve(), {20, weights}, {}, scheme.rules);
  CHECK_THROWS_WITH(gap.row(10), contains("a fit of degree 1 needs 2"));
}

TEST_CASE("the digits of a point give the values of a limit and of its derivatives there") {
  Random random;
  for (const auto& [text, orders] : {std::pair{"primal:n=3", 1},
                                     {"bspline:degree=4", 3},
                                     {"dd:n=2", 1},
                                     {"dual:n=2", 1},
                                     {"ary:a=3,points=5,d=1", 0},
                                     {"bspline:degree=3,a=4", 2}}) {
    const Mask mask = make_scheme(text).mask.curve();
    for (int order = 0; order <= orders; ++order) {
      CAPTURE(text, order);
      const int level = 3;
      const LimitValues known = limit_values(mask, level, order);
      const AdicLimit limit(mask, order);
      const long scale = numerator(power(Rational(mask.arity()), level)).convert_to<long>();
      for (long index = 0; index < scale; ++index) {
        const auto exact = limit.values<Rational>(index * (limit.points() / scale));
        const auto rounded = limit.values<double>(index * (limit.points() / scale));
        for (std::size_t k = 0; k < exact.size(); ++k) {
          CHECK(exact[k] == known.at(index + scale * (limit.first() + static_cast<long>(k))));
          CHECK(std::abs(rounded[k] - static_cast<double>(exact[k])) < 1e-13);
        }
        for (const long outside : {limit.first() - 1, limit.first() + static_cast<long>(exact.size())})
          CHECK(known.at(index + scale * outside) == 0);
      }
      // All digits: no error grows with them.
      const long any = random.integer(0, limit.points() - 1);
      const auto exact = limit.values<Rational>(any);
      const auto rounded = limit.values<double>(any);
      Rational sum = 0;
      for (std::size_t k = 0; k < exact.size(); ++k) {
        sum += exact[k];
        CHECK(std::abs(rounded[k] - static_cast<double>(exact[k])) < 1e-12);
      }
      CHECK(sum == (order == 0 ? 1 : 0));
    }
  }
  CHECK_FAILS(AdicLimit(make_scheme("dd:n=2").mask.curve(), 0).values<double>(-1), domain);
}

TEST_CASE("at given places the limit is that of the grid, and polynomials are reproduced between its points") {
  Random random;
  std::vector<Rational> weights(14, 1);
  weights[5] = 0;
  weights[9] = Rational(1, 3);
  std::vector<double> uneven;
  for (int i = 0; i < 14; ++i) uneven.push_back(i == 0 ? 0 : uneven.back() + 0.75 + 0.5 * (i % 2));
  for (const auto& [text, degree] :
       {std::pair{"primal:n=3", 1}, {"dual:n=2", 1}, {"primal:n=3,d=3", 3}, {"ary:a=3,points=5,d=1", 1}}) {
    const Scheme scheme = make_scheme(text);
    for (const DataSites& sites : {DataSites(14), DataSites(14, weights), DataSites(14, {}, uneven)})
      for (const Boundary kind : {Boundary::regression, Boundary::reflect, Boundary::constant, Boundary::periodic}) {
        CAPTURE(text, sites.weights.size(), sites.positions.size(), to_text(kind));
        SmoothingOptions options{kind, 2, 0};
        const SchemeSmoother grid(scheme.mask.curve(), sites, options, scheme.rules);
        for (std::size_t o = 0; o < grid.outputs(); ++o)
          if (numerator(power(Rational(2), 40)) % denominator(grid.position(o)) == 0)
            options.places.push_back(static_cast<double>(grid.position(o)));
        const SchemeSmoother there(scheme.mask.curve(), sites, options, scheme.rules);
        std::size_t o = 0;
        for (std::size_t k = 0; k < there.outputs(); ++k) {
          while (grid.position(o) != there.position(k)) ++o;
          const SmoothingRow a = grid.row(o), b = there.row(k);
          CHECK(a.variance == b.variance);
          CHECK(a.outside == b.outside);
          for (std::size_t i = 0; i < 14; ++i) {
            const auto at = [&](const SmoothingRow& row) {
              return i < row.first || i >= row.first + row.weights.size() ? Rational(0) : row.weights[i - row.first];
            };
            CHECK(at(a) == at(b));
          }
        }
      }
    SmoothingOptions options;
    for (int k = 0; k < 6; ++k) options.places.push_back(static_cast<double>(random.integer(0, 13 * 1024)) / 1024);
    std::ranges::sort(options.places);
    const SchemeSmoother any(scheme.mask.curve(), 14, options);
    for (std::size_t o = 0; o < any.outputs(); ++o)
      for (int q = 0; q <= degree; ++q)
        if (scheme.mask.curve().arity() == 2)
          CHECK(apply_exactly(any.row(o), polynomial_data(14, q)) == polynomial_at(any.position(o), q));
  }
  for (const std::vector<double>& wrong : {std::vector<double>{2, 1}, {-0.5}, {13.25}}) {
    SmoothingOptions options;
    options.places = wrong;
    CHECK_FAILS(SchemeSmoother(make_scheme("dd:n=2").mask.curve(), 14, options), domain);
  }
}
