#include <subcert/analysis/symbol/matrices/lifted_solution.hpp>
#include <subcert/cmake/catch.hpp>

#include <random>

using namespace subcert;

namespace {

Rational random_number(std::mt19937_64& engine, int digits) {
  const Rational large = power(Rational(10), static_cast<long>(engine() % static_cast<unsigned>(digits)));
  return Rational(static_cast<long>(engine() % 1999) - 999, static_cast<long>(engine() % 30) + 1) * large +
         Rational(1, 7);
}

RationalMatrix random_matrix(std::size_t size, std::mt19937_64& engine, int digits) {
  RationalMatrix result(size, size);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) result(i, j) = random_number(engine, digits);
  return result;
}

std::vector<Rational> times(const RationalMatrix& a, const std::vector<Rational>& x) {
  std::vector<Rational> result(x.size(), 0);
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < x.size(); ++j) result[i] += a(i, j) * x[j];
  return result;
}

}  // namespace

TEST_CASE("lifted solutions are those that were put in, short and long") {
  std::mt19937_64 engine(5);
  for (const std::size_t size : {1, 2, 3, 7, 15})
    for (const int digits : {1, 20, 300}) {
      CAPTURE(size, digits);
      const RationalMatrix a = random_matrix(size, engine, digits);
      std::vector<Rational> x;
      for (std::size_t i = 0; i < size; ++i) x.push_back(random_number(engine, digits));
      CHECK(lifted_solution(a, times(a, x), Deadline()) == x);
      CHECK(lifted_solution(a, std::vector<Rational>(size, 0), Deadline()) == std::vector<Rational>(size, 0));
      // Not put in: as long as it has to be.
      std::vector<Rational> right(size, 0);
      right.back() = 1;
      const auto found = lifted_solution(a, right, Deadline());
      REQUIRE(found);
      CHECK(times(a, *found) == right);
    }
}

TEST_CASE("no lifted solution of singular systems, past the deadline, or of other shapes") {
  std::mt19937_64 engine(6);
  RationalMatrix a = random_matrix(4, engine, 5);
  const std::vector<Rational> right(4, 1);
  CHECK(lifted_solution(a, right, Deadline::in(100)));
  CHECK_FALSE(lifted_solution(a, right, Deadline::in(0)));
  for (std::size_t j = 0; j < 4; ++j) a(3, j) = a(0, j) - 2 * a(1, j);
  CHECK_FALSE(lifted_solution(a, right, Deadline()));
  CHECK_FALSE(lifted_solution(RationalMatrix(1, 1), {1}, Deadline()));
  CHECK_THROWS_WITH(lifted_solution(a, {1, 2}, Deadline()), Catch::Contains("4 x 4 and 2"));
}
