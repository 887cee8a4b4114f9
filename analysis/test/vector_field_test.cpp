// Operators over a quadratic field: mirrors, and which product attains the radius of all blocks.

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

}  // namespace
}  // namespace subcert::vectors
