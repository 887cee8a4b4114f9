#include "specimens.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/specification.hpp>

using namespace subcert;
using subcert::testing::mask_of;

namespace {

/// B-spline of this degree with the knots 0, ..., degree+1, by Cox and de Boor.
Rational bspline(int degree, const Rational& x) {
  if (degree == 0) return x >= 0 && x < 1 ? 1 : 0;
  return (x * bspline(degree - 1, x) + (degree + 1 - x) * bspline(degree - 1, x - 1)) / degree;
}

}  // namespace

TEST_CASE("limit values satisfy the refinement equation and sum to one") {
  for (const char* text : {"primal:n=1", "primal:n=3", "dual:n=2", "primal:n=3,d=3", "dual-odd:n=2", "dd:n=3",
                           "ary:a=3,points=4,d=3", "ary:a=4,points=3", "four-point:w=1/9"}) {
    CAPTURE(text);
    const Mask mask = mask_of(text);
    const int level = 3, arity = mask.arity();
    const LimitValues fine = limit_values(mask, level), coarse = limit_values(mask, level - 1);
    const Interval support = limit_support(mask);
    CHECK(fine.point(0) >= support.lower);
    CHECK(fine.point(fine.values.size() - 1) <= support.upper);
    const long scale = numerator(power(Rational(arity), level)).convert_to<long>(), coarse_scale = scale / arity;
    for (std::size_t i = 0; i < fine.values.size(); ++i) {
      const long index = fine.first_index + static_cast<long>(i);
      Rational sum = 0;
      for (long j = mask.symbol().lowest(); j <= mask.symbol().highest(); ++j)
        sum += mask.symbol().coefficient(j) * coarse.at(index - j * coarse_scale);
      CHECK(fine.values[i] == sum);
    }
    for (long r = 0; r < scale; ++r) {
      Rational sum = 0;
      for (long j = -40; j <= 40; ++j) sum += fine.at(r + j * scale);
      CHECK(sum == 1);
    }
    for (long i = coarse.first_index; i < coarse.first_index + static_cast<long>(coarse.values.size()); ++i)
      CHECK(fine.at(i * arity) == coarse.at(i));
  }
}

TEST_CASE("B-splines and their derivatives") {
  for (int degree = 1; degree <= 4; ++degree)
    for (int arity = 2; arity <= 3; ++arity) {
      const Mask mask = mask_of("bspline:degree=" + std::to_string(degree) + ",a=" + std::to_string(arity));
      const Rational left = limit_support(mask).lower;
      const LimitValues values = limit_values(mask, 3);
      for (std::size_t i = 0; i < values.values.size(); ++i)
        CHECK(values.values[i] == bspline(degree, values.point(i) - left));
      if (degree < 2) continue;
      const LimitValues slopes = limit_values(mask, 3, 1);
      for (std::size_t i = 0; i < slopes.values.size(); ++i)
        CHECK(slopes.values[i] ==
              bspline(degree - 1, slopes.point(i) - left) - bspline(degree - 1, slopes.point(i) - left - 1));
    }
}

TEST_CASE("the basic limit functions of Dyn, Heard, Hormann and Sharon") {
  CHECK(limit_values(mask_of("primal:n=2"), 0).at(0) == Rational(9, 31));
  for (int n = 2; n <= 12; ++n) {
    CAPTURE(n);
    const LimitValues values = limit_values(mask_of("primal:n=" + std::to_string(n)), 0);
    // Proposition 3 and Corollary 4.
    CHECK(values.at(-2 * n + 1) == 0);
    for (long k = -2 * n + 1; k < 0; ++k) CHECK(values.at(k) < values.at(k + 1));
    CHECK(values.at(-n) == Rational(n - 1, 2 * n - 1) * values.at(0));
    CHECK(values.at(0) > Rational(1, 3 * n - 2));
    CHECK(values.at(0) < Rational(1, n - 1));
  }
  const LimitValues cardinal = limit_values(mask_of("dd:n=4"), 0);
  for (long k = -7; k <= 7; ++k) CHECK(cardinal.at(k) == (k == 0 ? 1 : 0));
}

TEST_CASE("what cannot be evaluated is refused") {
  const auto kind_of = [](const char* text, int level, int order = 0) {
    try {
      limit_values(mask_of(text), level, order);
    } catch (const Error& error) {
      return std::optional(error.kind());
    }
    return std::optional<ErrorKind>();
  };
  CHECK(kind_of("mask:[1,0,0,1]", 0) == ErrorKind::domain);
  CHECK(kind_of("primal:n=2", -1) == ErrorKind::domain);
  CHECK(kind_of("primal:n=2", 40) == ErrorKind::size);
  CHECK(kind_of("primal:n=1000", 0) == ErrorKind::size);
  CHECK(kind_of("primal:n=2", 0, 3) == ErrorKind::domain);
}

TEST_CASE("the variance curve") {
  const VarianceGrid hat = variance_grid(mask_of("primal:n=1"), 4, false);
  for (long i = 0; i <= 16; ++i) {
    const Rational x(i, 16);
    CHECK(hat.values[static_cast<std::size_t>(i)] == x * x + (1 - x) * (1 - x));
  }
  CHECK(hat.largest() == 1);
  CHECK(hat.smallest() == Rational(1, 2));
  CHECK(hat.steepest() == 2 - Rational(1, 8));
  CHECK(squared_l2_norm(mask_of("primal:n=1")) == Rational(2, 3));
  CHECK(squared_l2_norm(mask_of("bspline:degree=2")) == Rational(11, 20));
  CHECK(squared_l2_norm(mask_of("bspline:degree=3")) == Rational(151, 315));
  CHECK(squared_l2_norm(mask_of("bspline:degree=3,a=3")) == Rational(151, 315));
  for (const char* text : {"primal:n=2", "dual:n=3", "primal:n=3,d=3", "dd:n=2", "ary:a=3,points=4,d=3"}) {
    CAPTURE(text);
    const Mask mask = mask_of(text);
    const VarianceGrid grid = variance_grid(mask, 5, true);
    Rational sum = 0;
    // phi is symmetric about c = the middle of its support, so psi is about c; with 2c an integer that is 0 or 1/2.
    const Interval ends = limit_support(mask);
    const bool mirrored = denominator(ends.lower + ends.upper) == 1;
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
      if (mirrored) {
        CHECK(grid.values[i] == grid.values[grid.values.size() - 1 - i]);
        CHECK(grid.slopes[i] == -grid.slopes[grid.slopes.size() - 1 - i]);
      }
      CHECK(grid.values[i] >= variance_floor(mask));
      if (i > 0) sum += (grid.values[i] + grid.values[i - 1]) / 2 * grid.step();
    }
    CHECK(abs(sum - squared_l2_norm(mask)) < Rational(1, 1000));
  }
  CHECK(variance_ceiling(mask_of("primal:n=4")) == Rational(1));
  CHECK_FALSE(variance_ceiling(mask_of("dd:n=2")).has_value());
}

TEST_CASE("values at rational points: on the grid as before, elsewhere as the refinement equation and splines say") {
  for (const char* text : {"primal:n=2", "dual:n=3,d=3", "dd:n=2", "ary:a=3,points=4,d=1", "ary:a=3,points=5,d=2"}) {
    const Mask mask = mask_of(text);
    const LimitValues grid = limit_values(mask, 2);
    for (long i = -3; i < 7; ++i) {
      const Rational x = Rational(i) * power(Rational(mask.arity()), -2);
      const ShiftedValues values = limit_values_at(mask, x);
      Rational sum = 0;
      for (std::size_t k = 0; k < values.values.size(); ++k) {
        CHECK(values.values[k] == grid.at(i + (values.first + static_cast<long>(k)) * mask.arity() * mask.arity()));
        sum += values.values[k];
      }
      CHECK(sum == 1);
    }
    // phi(x) = sum of a_n phi(arity x - n) at a point with a cycle of length 3 or 6.
    const Rational x(3, 7);
    const ShiftedValues here = limit_values_at(mask, x), there = limit_values_at(mask, mask.arity() * x);
    for (std::size_t k = 0; k < here.values.size(); ++k) {
      Rational sum = 0;
      for (std::size_t l = 0; l < there.values.size(); ++l)
        sum += mask.symbol().coefficient(mask.arity() * (here.first + static_cast<long>(k)) - there.first -
                                         static_cast<long>(l)) *
               there.values[l];
      CHECK(sum == here.values[k]);
    }
  }
  for (int degree = 1; degree <= 4; ++degree) {
    const Mask mask = mask_of("bspline:degree=" + std::to_string(degree) + ",a=3");
    for (const Rational& x : {Rational(1, 4), Rational(-5, 7), Rational(2, 5), Rational(11, 2)}) {
      const ShiftedValues values = limit_values_at(mask, x);
      for (std::size_t k = 0; k < values.values.size(); ++k)
        CHECK(values.values[k] == bspline(degree, x + values.first + static_cast<long>(k) - limit_support(mask).lower));
    }
  }
  CHECK_THROWS_AS(limit_values_at(mask_of("primal:n=2"), Rational(1, 1000003)), Error);
}

TEST_CASE("exact values end with their deadline, and say so") {
  const Mask mask = mask_of("primal:n=5,d=3");
  for (const int level : {0, 5})
    CHECK_THROWS_WITH(limit_values(mask, level, 0, Deadline::in(0)), Catch::Contains("budget"));
  CHECK_THROWS_WITH(variance_grid(mask, 3, false, Deadline::in(0)), Catch::Contains("budget"));
  CHECK_THROWS_WITH(squared_l2_norm(mask, Deadline::in(0)), Catch::Contains("budget"));
  CHECK(limit_values(mask, 3, 0, Deadline::in(1000)).values == limit_values(mask, 3).values);
}

TEST_CASE("fixed vectors where the last equation does not follow from the others") {
  RationalMatrix first(2, 2);  // the first coordinate is kept, the last one vanishes
  first(0, 0) = 1;
  CHECK(fixed_vector(first) == std::vector<Rational>{1, 0});
  CHECK_FALSE(fixed_vector(RationalMatrix(2, 2)));
  CHECK_FALSE(fixed_vector(RationalMatrix::identity(2)));
  CHECK(fixed_vector(RationalMatrix::identity(1), 7) == std::vector<Rational>{1});
}
