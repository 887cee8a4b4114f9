#include <subcert/analysis/limit/field_values.hpp>
#include <subcert/analysis/regularity/multivariate_regularity.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/specification.hpp>

#include <cmath>
#include <optional>

using namespace subcert;

namespace {

FunctionVector vector_of(const Scheme& scheme) {
  const Budget budget{Deadline::in(20)};
  return scheme.quadratic ? *vector_regularity(*scheme.quadratic, budget).vector
                          : *vector_regularity(scheme.mask, budget).vector;
}

FieldValues values_of(const Scheme& scheme, int level, const LatticePoint& orders = {}) {
  return limit_values(scheme.mask, scheme.quadratic, *vector_of(scheme).values, level, orders);
}

double about(const QuadraticNumber& number) { return rounded(number, 80).convert_to<double>(); }

}  // namespace

TEST_CASE("numbers with a square root are rounded to a relative error") {
  CHECK(rounded({Rational(1, 3)}, 10) == Rational(1, 3));
  // (sqrt(2) - 1)^40 = p - q sqrt(2), some 10^-16: both parts are some 10^15.
  Rational p = 1, q = 0;
  for (int k = 0; k < 40; ++k) {  // times sqrt(2) - 1
    const Rational next = 2 * q - p;
    q = p - q;
    p = next;
  }
  const Rational power_value = rounded({p, q, 2}, 100);
  CHECK(power_value.convert_to<double>() == Approx(std::pow(std::sqrt(2.0) - 1, 40)).epsilon(1e-9));
  CHECK(about({-3, 2, 2}) == Approx(-3 + 2 * std::sqrt(2.0)).epsilon(1e-13));
  CHECK(about({0, 2, 7}) == Approx(2 * std::sqrt(7.0)).epsilon(1e-15));
}

TEST_CASE("functions that a factor makes rational have the rational values times numbers of the field") {
  // GHM as printed, and with the square root taken out of the second function.
  const Scheme printed = make_refinable_scheme(
      "refinable:[[[12,16*sqrt(2)],[-sqrt(2),-6]],[[12,0],[9*sqrt(2),20]],[[0,0],[9*sqrt(2),-6]],"
      "[[0,0],[-sqrt(2),0]]]/20@0");
  const Scheme rational = make_refinable_scheme("ghm");
  REQUIRE(printed.quadratic);
  const FieldValues one = values_of(printed, 4), other = values_of(rational, 4);
  REQUIRE(one.size() == other.size());
  std::optional<QuadraticNumber> ratios[2];  // of the functions
  for (const auto& [point, numbers] : one)
    for (std::size_t c = 0; c < 2; ++c) {
      CHECK(numbers[c].is_zero() == other.at(point)[c].is_zero());
      if (numbers[c].is_zero()) continue;
      const QuadraticNumber ratio = numbers[c] / other.at(point)[c];
      if (!ratios[c]) ratios[c] = ratio;
      CHECK(ratio == *ratios[c]);
    }
  const QuadraticNumber between = *ratios[0] / *ratios[1];
  CHECK(between.rational == 0);
  CHECK(between.root == 2);
}

TEST_CASE("values over a field solve the refinement equation, and sum to 1 at lattice points") {
  for (const char* name : {"cl:2", "cl:3", "bat:1", "bat:2", "bat:3", "sa4"}) {
    CAPTURE(name);
    const Scheme scheme = make_refinable_scheme(name);
    const std::size_t size = scheme.mask.components();
    const FieldValues coarse = values_of(scheme, 0), fine = values_of(scheme, 1), finest = values_of(scheme, 5);
    QuadraticNumber sum;
    for (const auto& [point, numbers] : coarse)
      for (const QuadraticNumber& number : numbers) {
        sum.rational += number.rational;
        sum.multiple += number.multiple;
      }
    CHECK(sum.rational == 1);
    CHECK(sum.multiple == 0);
    const auto at = [&](const FieldValues& values, long index, std::size_t c) {
      const auto found = values.find({index});
      return found == values.end() ? 0 : about(found->second[c]);
    };
    // phi_r(i/2) = sum of A_k(r, c) phi_c(i - k), by the rounded matrices.
    for (long i = -2; i <= 20; ++i) {
      std::vector<double> expected(size, 0);
      for (const LatticeMask::Term& term : scheme.mask.terms())
        expected[term.row] += term.coefficient.convert_to<double>() * at(coarse, i - term.exponents[0], term.column);
      for (std::size_t c = 0; c < size; ++c) {
        CHECK(at(fine, i, c) == Approx(expected[c]).margin(1e-12));
        CHECK(at(finest, 32 * i, c) == Approx(at(coarse, i, c)).margin(1e-12));
        CHECK(at(finest, 16 * i, c) == Approx(at(fine, i, c)).margin(1e-12));
      }
    }
  }
}

TEST_CASE("derivatives over a field: Merrien's scheme gives the slopes that it refines") {
  const Scheme scheme = make_refinable_scheme(
      "hermite:[[[1/2,-1/8],[1/2-sqrt(2)/8,sqrt(2)/16]],[[1,0],[0,1/2]],[[1/2,1/8],[sqrt(2)/8-1/2,sqrt(2)/16]]]@-1");
  REQUIRE(scheme.quadratic);
  const FieldValues values = values_of(scheme, 2), slopes = values_of(scheme, 2, {1});
  const Rational quarter(1, 4);
  // f(1/2) = 1/2, f'(1/2) = mu - 1, f(1/4) = 3/4 + (1 - mu)/16, f'(1/4) = (1 - mu) 2 (f(1/2) - 1) + mu (mu - 1)/2.
  CHECK(values.at({2})[0] == QuadraticNumber{Rational(1, 2)});
  CHECK(values.at({1})[0] == QuadraticNumber{Rational(13, 16), Rational(-1, 64), 2});
  CHECK(slopes.at({2})[0] == QuadraticNumber{-1, quarter, 2});
  CHECK(slopes.at({1})[0] == QuadraticNumber{Rational(-15, 16), Rational(1, 8), 2});
  CHECK(slopes.at({0})[1] == QuadraticNumber{1});
}

TEST_CASE("Sobolev exponents over a field are those of rational matrices where a factor makes them so") {
  const auto sobolev = [](const std::string& text) {
    const Scheme scheme = make_refinable_scheme(text);
    REQUIRE(scheme.quadratic);
    return vector_regularity(*scheme.quadratic, {Deadline::in(20)}).sobolev;
  };
  const auto ghm = sobolev(
      "refinable:[[[12,16*sqrt(2)],[-sqrt(2),-6]],[[12,0],[9*sqrt(2),20]],[[0,0],[9*sqrt(2),-6]],"
      "[[0,0],[-sqrt(2),0]]]/20@0");
  REQUIRE(ghm);
  CHECK(ghm->contains(Rational(3, 2)));
  CHECK(*ghm->upper - *ghm->lower < Rational(1, 1'000'000'000'000));
  // cubic Hermite splines with the slopes in units of sqrt(3)
  const auto cubic = sobolev(
      "refinable:[[[4,2*sqrt(3)],[-sqrt(3),-1]],[[8,0],[0,4]],[[4,-2*sqrt(3)],[sqrt(3),-1]]]/8@-1");
  REQUIRE(cubic);
  CHECK(cubic->contains(Rational(5, 2)));
  // known by other means to these digits
  for (const char* name : {"cl:2", "bat:1"}) {
    CAPTURE(name);
    const auto found = sobolev(name);
    REQUIRE(found);
    CHECK(*found->lower > Rational(105'457, 100'000));
    CHECK(*found->upper < Rational(105'459, 100'000));
  }
}
