// Operators over a quadratic field: mirrors, and which product attains the radius of all blocks.

#include <subcert/analysis/radii/joint/congruences.hpp>
#include <subcert/analysis/radii/joint/p_radius.hpp>
#include <subcert/analysis/regularity/vector_operators.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

namespace subcert::vectors {
namespace {

using testing::Random;
using testing::rounds;

const Budget budget{Deadline::in(20)};

/// p + q sqrt(root), by rows.
struct Number {
  Rational p = 0, q = 0;
};
using FieldMatrix = std::vector<std::vector<Number>>;

/// In the basis e_1, J e_1, e_2, J e_2, ...
RationalMatrix doubled(const FieldMatrix& matrix, long root) {
  RationalMatrix result(2 * matrix.size(), 2 * matrix.size());
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::size_t k = 0; k < matrix.size(); ++k) {
      const auto& [p, q] = matrix[i][k];
      result(2 * i, 2 * k) = result(2 * i + 1, 2 * k + 1) = p;
      result(2 * i, 2 * k + 1) = root * q;
      result(2 * i + 1, 2 * k) = q;
    }
  return result;
}

RationalMatrix doubled_root(std::size_t size, long root) {
  FieldMatrix one(size, std::vector<Number>(size));
  for (std::size_t i = 0; i < size; ++i) one[i][i] = {0, 1};
  return doubled(one, root);
}

Operators operators(const std::vector<FieldMatrix>& matrices, long root) {
  std::vector<RationalMatrix> list;
  for (const FieldMatrix& matrix : matrices) list.push_back(doubled(matrix, root));
  return {MatrixFamily(std::move(list)), doubled_root(matrices.front().size(), root)};
}

FieldMatrix random_matrix(Random& random, std::size_t size) {
  FieldMatrix result(size, std::vector<Number>(size));
  for (auto& row : result)
    for (Number& entry : row) entry = {Rational(random.integer(-9, 9), 7), Rational(random.integer(-9, 9), 5)};
  return result;
}

/// The matrix, its image under the map, and a random one between that is its own image, all in a random basis.
Operators mirrored(Random& random, const FieldMatrix& map, long root, bool is_own_image_between = true) {
  const std::size_t size = map.size();
  const RationalMatrix j = doubled(map, root), first = doubled(random_matrix(random, size), root);
  const auto image = [&](const RationalMatrix& matrix) {
    return transposed(solve(transposed(j), transposed(j * matrix)));
  };
  std::vector<RationalMatrix> list{first};
  if (is_own_image_between) {
    RationalMatrix half = doubled(random_matrix(random, size), root);
    const RationalMatrix other = image(half);
    for (std::size_t i = 0; i < half.rows(); ++i)
      for (std::size_t k = 0; k < half.rows(); ++k) half(i, k) += other(i, k);
    list.push_back(half);
  }
  list.push_back(image(first));
  Operators result{MatrixFamily(std::move(list)), doubled_root(size, root)};
  for (;;)
    if (const RationalMatrix basis = doubled(random_matrix(random, size), root); kernel(basis).empty())
      return in_basis(result, basis);
}

FieldMatrix diagonal(const std::vector<Number>& numbers) {
  FieldMatrix result(numbers.size(), std::vector<Number>(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i) result[i][i] = numbers[i];
  return result;
}

TEST_CASE("Rounded matrices keep a mirror that is found over the field") {
  Random random;
  for ([[maybe_unused]] const int round : rounds(10))
    for (const auto& [signs, expected] : {std::pair{std::vector<Number>{{1}, {-1}}, true},
                                          {{{1}, {-1}, {1}}, true},
                                          {{{-1}, {-1}, {1}}, true},
                                          {{{2, 1}, {2, 1}, {-2, -1}, {-2, -1}, {2, 1}}, true},
                                          {{{1}, {1}, {1}, {-1}}, false}}) {
      const long root = random.chance(50) ? 2 : 15199;
      const Operators given = mirrored(random, diagonal(signs), root);
      const auto found = mirror_symmetric_basis(given, Deadline::in(20));
      CHECK(found.has_value() == expected);
      if (!found) continue;
      const RealFamily family = on_functions(in_basis(given, *found), root);
      CHECK(family.distance > 0);
      CHECK(family.matrices.is_flip_symmetric());
      // the same operators in another basis: traces over the field, of all products of two
      const RealFamily before = on_functions(given, root);
      const auto trace = [](const RationalMatrix& matrix) {
        Rational sum = 0;
        for (std::size_t i = 0; i < matrix.rows(); ++i) sum += matrix(i, i);
        return sum;
      };
      for (int s = 0; s < 3; ++s)
        for (int t = 0; t < 3; ++t)
          CHECK(abs(trace(family.matrices.product({s, t})) - trace(before.matrices.product({s, t}))) <
                power(Rational(2), -300));
    }
}

TEST_CASE("A mirror is one that the field has") {
  Random random;
  const auto has_mirror = [&](const Number& square, long root) {  // J J is that number
    return mirror_symmetric_basis(mirrored(random, {{{}, square}, {{1}, {}}}, root), Deadline::in(20)).has_value();
  };
  CHECK(has_mirror({3, 2}, 2));  // (1 + sqrt(2))^2
  CHECK(has_mirror({7}, 7));     // the root itself
  CHECK(has_mirror({Rational(9, 4)}, 7));
  CHECK_FALSE(has_mirror({1, 1}, 2));  // of norm -1
  CHECK_FALSE(has_mirror({-1}, 2));
  CHECK_FALSE(has_mirror({3}, 2));
  CHECK_FALSE(has_mirror({-3, -2}, 2));
  // a matrix between the two that is not its own image, none at all
  Operators other = mirrored(random, diagonal({{1}, {-1}}), 2, false);
  std::vector<RationalMatrix> three{other.family[0], doubled(random_matrix(random, 2), 2), other.family[1]};
  CHECK(mirror_symmetric_basis(other, Deadline::in(20)));
  CHECK_FALSE(mirror_symmetric_basis({MatrixFamily(three), other.root}, Deadline::in(20)));
  const Operators any = operators({random_matrix(random, 3), random_matrix(random, 3)}, 2);
  CHECK_FALSE(mirror_symmetric_basis(any, Deadline::in(20)));
  CHECK(are_similar(any, in_basis(any, doubled({{{1}, {0, 1}, {}}, {{}, {1}, {3}}, {{}, {}, {1}}}, 2)),
                    Deadline::in(20)));
  CHECK_FALSE(are_similar(any, operators({random_matrix(random, 3), random_matrix(random, 3)}, 2), Deadline::in(20)));
}

TEST_CASE("Radii of blocks over a field are equal where that is proved") {
  const Number half{0, Rational(1, 2)}, more{power(Rational(2), -600), Rational(1, 2)};
  const auto exact = [](const std::vector<Number>& first, const std::vector<Number>& last) {
    return radius_of(operators({diagonal(first), diagonal(last)}, 2), 2, budget, {}).exact.truth;
  };
  CHECK(exact({half, {Rational(1, 4)}}, {{Rational(1, 4)}, half}) == Truth::yes);  // mirror images
  CHECK(exact({half, {Rational(1, 4)}}, {{}, {Rational(1, 3)}}) == Truth::yes);    // the other is smaller
  CHECK(exact({half, half}, {{Rational(1, 4)}, {Rational(1, 3)}}) == Truth::yes);  // one product of both
  // larger by less than what rounding shows, by another product
  CHECK(exact({half, {Rational(1, 4)}}, {{Rational(1, 4)}, more}) == Truth::unknown);
  CHECK(exact({half, {}}, {{}, {0, Rational(-1, 2)}}) == Truth::unknown);  // equal, but by no map
  CHECK(exact({half}, {{0, Rational(-1, 2)}}) == Truth::yes);              // of one block, up to the sign
  CHECK(exact({half}, {more}) == Truth::unknown);
}

/// Rows of integers as balls, each entry `width` away from the integer at most.
radius::BallMatrix balls(const std::vector<std::vector<long>>& rows, int bits, const Rational& width = 0) {
  const slong precision = radius::bits_for_congruences(bits);
  radius::BallMatrix result;
  for (const std::vector<long>& row : rows) {
    auto& entries = result.emplace_back();
    for (const long entry : row) entries.push_back(Ball(entry, precision).widened(Ball(width, precision)));
  }
  return result;
}

TEST_CASE("the mean of squares over a field is that of the real matrices near by") {
  constexpr int bits = 60;
  const Rational near = power(Rational(2), -bits + 8);
  Random random;
  for ([[maybe_unused]] const auto round : rounds(12)) {
    const long root = std::vector<long>{2, 7, 15199}[static_cast<std::size_t>(random.integer(0, 2))];
    const auto size = static_cast<std::size_t>(random.integer(1, 4));
    std::vector<FieldMatrix> matrices;
    for (long k = random.integer(1, 3); k > 0; --k) matrices.push_back(random_matrix(random, size));
    if (random.chance(20))
      for (auto& row : matrices.front())
        for (Number& entry : row) entry = {};
    const Operators given = operators(matrices, root);
    const auto found = mean_square_radius(given, root, bits, Deadline::never());
    const auto rounded = p_radius(on_functions(given, root).matrices, 2, bits, Deadline::never());
    REQUIRE(found);
    REQUIRE(rounded);
    CHECK(abs(*found->upper - *rounded->radius.upper) <= near * *found->upper);
    CHECK(*found->lower >= *found->upper * (1 - near));
  }
}

TEST_CASE("sums of congruences: what they leave open, and what they never say") {
  constexpr int bits = 40;
  const auto of = [](const std::vector<radius::BallMatrix>& matrices) {
    return radius::radius_of_congruences(matrices, bits, Deadline::never());
  };
  CHECK(*of({balls({{0}}, bits)})->upper == 0);
  CHECK(*of({balls({{-3}}, bits), balls({{4}}, bits)})->lower <= 25);
  CHECK_FALSE(of({balls({{0, 1}, {0, 0}}, bits)}));  // nilpotent
  CHECK_FALSE(of({balls({{1, 2}, {3, 4}}, bits, Rational(1, 2))}));
  const auto is_near = [&](const std::vector<radius::BallMatrix>& matrices, const Rational& value) {
    const auto found = of(matrices);
    return found && *found->lower <= value && value <= *found->upper &&
           *found->upper - *found->lower < value * power(Rational(2), -20);
  };
  CHECK(is_near({balls({{0, -1}, {1, 0}}, bits)}, 1));                                // a turn
  CHECK(is_near({balls({{2, 0}, {0, 2}}, bits), balls({{0, 1}, {1, 0}}, bits)}, 5));  // equal parts
  CHECK(is_near({balls({{3, 1, 7}, {0, 2, 5}, {0, 0, 1}}, bits)}, 9));                // triangular
  const auto jordan = of({balls({{1, 1}, {0, 1}}, bits)});  // a zero of higher order is slow, and may stay open
  CHECK((!jordan || (*jordan->lower <= 1 && *jordan->upper >= 1)));
  CHECK_THROWS_WITH(of({radius::BallMatrix(23, std::vector<Ball>(23, Ball(1L, 64)))}),
                    Catch::Contains("need at most 22 rows, got 23"));
  CHECK_FALSE(radius::radius_of_congruences({balls({{1, 2}, {3, 4}}, bits)}, bits, Deadline::in(0)));
}

}  // namespace
}  // namespace subcert::vectors
