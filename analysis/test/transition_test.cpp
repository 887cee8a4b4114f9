#include "specimens.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/ball_transition.hpp>
#include <subcert/analysis/transition/transition.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

using namespace subcert;
using subcert::testing::masks;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

/// By the definition, from the coefficients of the symbol.
std::vector<Rational> by_definition(const Mask& mask, long t, const std::vector<Rational>& v, bool transposed) {
  const long width = static_cast<long>(v.size());
  std::vector<Rational> result(v.size(), 0);
  for (long j = 0; j < width; ++j)
    for (long k = 0; k < width; ++k) {
      const Rational b = mask.symbol().coefficient(mask.symbol().lowest() + mask.arity() * j + t - k);
      const auto row = static_cast<std::size_t>(j), column = static_cast<std::size_t>(k);
      if (transposed)
        result[column] += b * v[row];
      else
        result[row] += b * v[column];
    }
  return result;
}

template <class To, class From>
std::vector<To> converted(const std::vector<From>& v) {
  std::vector<To> result;
  for (const From& x : v) result.push_back(x.template convert_to<To>());
  return result;
}

/// Small integers over 2^4, exact in every kind of number; lengths down to 1, leading zeros inside.
Mask random_dyadic_mask(Random& random) {
  std::vector<Rational> coefficients(static_cast<std::size_t>(random.integer(1, 14)), 0);
  for (Rational& c : coefficients)
    if (random.chance(80)) c = Rational(random.integer(-9, 9), 16);
  coefficients.front() = 1;
  return {LaurentPolynomial(coefficients, random.integer(-5, 5)), static_cast<int>(random.integer(2, 5))};
}

}  // namespace

TEST_CASE("the transition operator is what its definition says, for all numbers") {
  Random random;
  for (const auto round : rounds(200)) {
    const Mask mask = random_dyadic_mask(random);
    const std::vector<Rational> coefficients = mask.symbol().coefficients();
    const Transition<Rational> exact(coefficients, mask.arity());
    const Transition<Integer> integral(mask.symbol().numerators(), mask.arity());
    const Transition<double> rounded(converted<double>(coefficients), mask.arity());
    const Transition<Ball> balls(coefficients, mask.arity(), 100);
    const long t = random.integer(0, mask.arity() - 1);
    std::vector<Rational> v(exact.width());
    for (Rational& x : v) x = random.chance(20) ? 0 : random.integer(-99, 99);
    CAPTURE(round, mask.symbol().to_mask_text(), mask.arity(), t);
    std::vector<Rational> image(v.size(), 7), back(v.size(), 7);
    exact.apply(t, v.data(), image.data());
    exact.apply_transposed(t, v.data(), back.data());
    CHECK(image == by_definition(mask, t, v, false));
    CHECK(back == by_definition(mask, t, v, true));
    const RationalMatrix matrix = transition_matrices(mask)[static_cast<std::size_t>(t)];
    CHECK(matrix * v == image);
    CHECK(transposed(matrix) * v == back);
    const std::vector<double> rounded_v = converted<double>(v);
    std::vector<double> rounded_image(v.size(), 7), rounded_back(v.size(), 7);
    rounded.apply(t, rounded_v.data(), rounded_image.data());
    rounded.apply_transposed(t, rounded_v.data(), rounded_back.data());
    CHECK(rounded_image == converted<double>(image));
    CHECK(rounded_back == converted<double>(back));
    std::vector<Integer> whole_v, whole_image(v.size(), 7);
    for (const Rational& x : v) whole_v.push_back(numerator(x));
    integral.apply(t, whole_v.data(), whole_image.data());
    BallVector ball_v(v.size()), ball_image(v.size());
    for (std::size_t k = 0; k < v.size(); ++k) ball_v.set(k, Ball(v[k], 100));
    balls.apply(t, ball_v, ball_image);
    for (std::size_t j = 0; j < v.size(); ++j) {
      CHECK(Rational(whole_image[j], mask.symbol().denominator()) == image[j]);
      CHECK(ball_image.at(j, 100).enclosure().contains(image[j]));
    }
  }
}

TEST_CASE("the window is the least range that the operators keep") {
  for (int arity = 2; arity <= 5; ++arity)
    for (long degree = 0; degree <= 30; ++degree) {
      const TransitionWindow window(degree, arity);
      CAPTURE(arity, degree);
      const auto keeps = [&](long width) {  // no row outside 0, ..., width-1 has a coefficient in a column inside
        for (long t = 0; t < arity; ++t)
          for (long k = 0; k < width; ++k)
            for (const long j : {-1L, width})
              if (window.index(t, j, k) >= 0 && window.index(t, j, k) <= degree) return false;
        return true;
      };
      CHECK(keeps(window.width));
      CHECK((window.width == 1 || !keeps(window.width - 1)));
      for (long t = 0; t < arity; ++t)
        for (long j = 0; j < window.width; ++j)
          for (long k = 0; k < window.width; ++k) {
            const IndexRange columns = window.columns(t, j);
            const long index = window.index(t, j, k);
            CHECK((columns.first <= k && k <= columns.last) == (index >= 0 && index <= degree));
          }
    }
}

TEST_CASE("the refinement equation is a step with the transition operator") {
  for (const Mask& mask : masks()) {
    CAPTURE(mask.symbol().to_mask_text(), mask.arity());
    const RefinementWindow window(mask);
    const Transition<Rational> refine(window.coefficients, mask.arity());
    const LimitValues coarse = limit_values(mask, 1), fine = limit_values(mask, 2);
    const long arity = mask.arity();
    for (long x = 0; x < arity; ++x)
      for (long t = 0; t < arity; ++t) {
        std::vector<Rational> v, image(refine.width());
        for (std::size_t k = 0; k < refine.width(); ++k)
          v.push_back(coarse.at(arity * (window.first + static_cast<long>(k)) + x));
        refine.apply(t, v.data(), image.data());
        for (std::size_t k = 0; k < refine.width(); ++k)
          CHECK(image[k] == fine.at(arity * arity * (window.first + static_cast<long>(k)) + arity * t + x));
      }
  }
}

TEST_CASE("central matrices fold the operator about the centre") {
  const LaurentPolynomial b({1, -3, 5, 2, 5, -3, 1}, -3);
  for (int arity = 2; arity <= 3; ++arity) {
    const RationalMatrix c = central_matrix(b, arity);
    CHECK(c.rows() == static_cast<std::size_t>(3 / (arity - 1)) + 1);
    CHECK(c(0, 0) == 2);
    if (arity == 2) CHECK(c(1, 1) == b.coefficient(1) + b.coefficient(3));
    CHECK(central_matrix(b, arity, 1).rows() == 2);
  }
  CHECK_THROWS_AS(central_matrix(LaurentPolynomial({1, 2}, 0), 2), Error);
  CHECK_THROWS_AS(central_matrix(LaurentPolynomial(), 2), Error);
}
