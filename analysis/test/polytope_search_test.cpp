// The search for an invariant polytope: what it finds, and that it keeps within its budget.
#include <subcert/analysis/radii/joint/similarity.hpp>
#include <subcert/analysis/radii/polytope_proof/round_family.hpp>
#include <subcert/analysis/radii/polytope_search/polytope_search.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>

#include <sys/resource.h>

#include <cmath>
#include <random>

using namespace subcert;
using namespace subcert::polytope;

namespace {

SearchFamily random_family(std::size_t size, std::size_t count, unsigned seed) {
  std::mt19937_64 engine(seed);
  SearchFamily family;
  for (std::size_t t = 0; t < count; ++t) {
    Matrix& a = family.matrices.emplace_back(size, size);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) a(i, j) = static_cast<double>(engine() >> 11) / 0x1p52 - 1;
  }
  return family;
}

Matrix two_by_two(double a, double b, double c, double d) {
  Matrix m(2, 2);
  m(0, 0) = a;
  m(0, 1) = b;
  m(1, 0) = c;
  m(1, 1) = d;
  return m;
}

/// The most that the process has held so far.
double peak_mebibytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void check_enclosure(const SearchResult& result) {
  CHECK_FALSE(result.closed);
  REQUIRE(!result.products.empty());
  CHECK(result.radius > 0);
  CHECK(result.upper_bound >= result.radius);
}

}  // namespace

TEST_CASE("the polytope search closes on families of known radius") {
  // The golden ratio is the root of the radius of A_0 A_1.
  const double golden = (1 + std::sqrt(5.0)) / 2;
  const SearchFamily cone{{two_by_two(1, 1, 0, 1), two_by_two(1, 0, 1, 1)}, SymmetryGroup::flip()};
  const SearchResult result = search_polytope(cone);
  CHECK(result.closed);
  CHECK(result.kind == PolytopeKind::nonnegative);
  CHECK(std::abs(result.radius - golden) < 1e-12);
  CHECK(result.products.front().word == std::vector<int>{0, 1});
  CHECK(result.images.size() == 2 * result.vertices.size());

  // A rotation and a small matrix: complex leading eigenvalues.
  const SearchFamily turning{{two_by_two(0.6, -0.8, 0.8, 0.6), two_by_two(0.1, 0.2, -0.1, 0.3)}, {}};
  const SearchResult turned = search_polytope(turning);
  CHECK(turned.closed);
  CHECK(turned.kind == PolytopeKind::complex);
  CHECK(std::abs(turned.radius - 1) < 1e-12);

  const SearchFamily vanishing{{two_by_two(0, 1, 0, 0)}, {}};
  CHECK(search_polytope(vanishing).upper_bound == 0);
}

TEST_CASE("the polytope search names broken preconditions") {
  const auto fails = [](const SearchFamily& family, const SearchOptions& options, const std::string& text) {
    try {
      search_polytope(family, options);
    } catch (const Error& error) {
      return error.kind() == ErrorKind::domain && std::string(error.what()).find(text) != std::string::npos;
    }
    return false;
  };
  CHECK(fails({}, {}, "at least one matrix"));
  CHECK(fails({{Matrix(2, 2), Matrix(3, 3)}, {}}, {}, "square matrices of one size"));
  SearchOptions options;
  options.tolerance = 0.5;
  CHECK(fails({{two_by_two(1, 0, 0, 1)}, {}}, options, "tolerance"));
}

TEST_CASE("the polytope search gives up what is no number and drops a symmetry that does not hold") {
  for (const double entry : {std::nan(""), HUGE_VAL}) {
    const SearchResult lost = search_polytope({{two_by_two(1, entry, 0, 1)}, {}});
    CHECK_FALSE(lost.closed);
    CHECK(lost.products.size() == 1);
    CHECK(lost.vertices.empty());
    CHECK(search_products({{two_by_two(1, entry, 0, 1)}, {}}, {}).size() == 1);
  }
  const SearchFamily family{{two_by_two(1, 2, 0, 1), two_by_two(1, 0, 1, 1)}, SymmetryGroup::flip()};
  REQUIRE(!has_symmetry(family));
  const SearchResult found = search_polytope(family), plain = search_polytope({family.matrices, {}});
  CHECK(found.closed);
  CHECK(found.radius == plain.radius);
  CHECK(found.vertices.size() == plain.vertices.size());
}

TEST_CASE("the flip exchanges the letters that it is given") {
  const SymmetryGroup flip = SymmetryGroup::flip({0, 2, 1});
  CHECK(flip.word(1, {0, 1, 2}, 3) == std::vector<int>{0, 2, 1});
  CHECK(has_symmetry({{two_by_two(1, 2, 2, 1), two_by_two(1, 1, 0, 1), two_by_two(1, 0, 1, 1)}, flip}));
}

TEST_CASE("the shape of orbits is one of numbers, also of badly conditioned families") {
  // Of segv2x2.json: rounding makes the sum of the images of the shape indefinite.
  const std::vector<Matrix> family{two_by_two(-999999, 1e6, -1e6, 1000001),
                                   two_by_two(1000002, -1e6, 1000002.000001, -1e6)};
  const OrbitShape shape = orbit_shape(family);
  CHECK(is_finite(shape.shape));
  CHECK(shape.radius_bound > 0);
}

TEST_CASE("symmetry groups act on letters, words and matrices") {
  const SymmetryGroup trivial, flip = SymmetryGroup::flip();
  CHECK(canonical_word({1, 0, 1, 0}, 2, trivial) == std::vector<int>{0, 1});
  CHECK(canonical_word({2, 2, 1}, 3, trivial) == std::vector<int>{1, 2, 2});
  CHECK(canonical_word({2, 2, 1}, 3, flip) == std::vector<int>{0, 0, 1});
  const Matrix a = two_by_two(1, 2, 3, 4);
  CHECK(flip.conjugated(1, a).entries() == two_by_two(4, 3, 2, 1).entries());
  for (const std::size_t d : {1U, 2U, 5U, 6U}) {
    // In adapted coordinates the flip changes signs.
    const CoordinateChange adapted = flip.adapted_coordinates(d);
    const Matrix& q = adapted.to;
    Vector x(d);
    for (std::size_t k = 0; k < d; ++k) x[k] = static_cast<double>(k * k) - 2;
    Vector turned = q * x, image = x;
    flip.action_in(adapted).apply(1, turned.data());
    flip.action(d).apply(1, image.data());
    const Vector expected = q * image;
    for (std::size_t k = 0; k < d; ++k) CHECK(std::abs(turned[k] - expected[k]) < 1e-12);
  }
}

TEST_CASE("a group of matrices makes a real polytope, also of non-negative families") {
  const Matrix exchange = two_by_two(0, 1, 1, 0);
  const SymmetryGroup group({{Matrix::identity(2), Matrix::identity(2), {0, 1}}, {exchange, exchange, {1, 0}}});
  const SearchFamily family{{two_by_two(1, 1, 0, 1), two_by_two(1, 0, 1, 1)}, group};
  const SearchResult result = search_polytope(family);
  CHECK(result.closed);
  CHECK(result.kind == PolytopeKind::real);
  CHECK(std::abs(result.radius - 1.618033988749895) < 1e-12);
}

TEST_CASE("every phase of the polytope search obeys the deadline") {
  for (const std::size_t size : {6U, 30U, 120U}) {
    const SearchFamily family = random_family(size, 5, 7);
    for (const double seconds : {0.0, 0.05, 0.5}) {
      INFO("size " << size << ", seconds " << seconds);
      SearchOptions options;
      options.budget.deadline = Deadline::in(seconds);
      const SearchResult result = search_polytope(family, options);
      // How long the smallest step takes is the machine's business; a phase that ignores the deadline runs for minutes.
      if (seconds == 0) CHECK(result.vertices.empty());
      if (!result.closed) check_enclosure(result);
    }
  }
}

TEST_CASE("the polytope search keeps within its memory") {
  // A family whose polytope does not close: what grows fills a bound of some MiB within a second or two.
  const SearchFamily family = random_family(24, 6, 11);
  for (const double mebibytes : {0.0, 1.0, 6.0}) {
    SearchOptions options;
    options.budget = {Deadline::in(10), static_cast<std::size_t>(mebibytes * 0x1p20)};
    [[maybe_unused]] const double before = peak_mebibytes();
    const SearchResult result = search_polytope(family, options);
    check_enclosure(result);
#ifndef __SANITIZE_ADDRESS__
    CHECK(peak_mebibytes() - before < mebibytes + 8);  // some arrays of the size of the family
#endif
  }
}

namespace {

/// D^-1 A D for random A with entries of hundredths, D = diag(1, 1000, ...), so that orbits are flat.
MatrixFamily flat_family(std::size_t size, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::vector<RationalMatrix> matrices;
  for (int t = 0; t < 2; ++t) {
    RationalMatrix& a = matrices.emplace_back(size, size);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j)
        a(i, j) = Rational(static_cast<long>(engine() % 201) - 100, 100) *
                  power(Rational(1000), static_cast<long>(j) - static_cast<long>(i));
  }
  return MatrixFamily(std::move(matrices));
}

}  // namespace

TEST_CASE("flat orbits are made round by exact coordinates, and the search closes there") {
  const MatrixFamily family = flat_family(8, 7);
  const radius::RoundFamily round = radius::round_family(family, Deadline::in(60));
  REQUIRE(round.coordinates.differ());
  for (std::size_t t = 0; t < family.count(); ++t) {
    CHECK(radius::to_double(round.coordinates.to * family[t] * round.coordinates.from).entries() ==
          round.family.matrices[t].entries());
  }
  // As joint_spectral_radius does, the basis is balanced before.
  const auto balanced = radius::balanced(block_triangularise(family, Deadline::in(60)), Deadline::in(60));
  REQUIRE(balanced.sizes.size() == 1);
  for (const polytope::Matrix& m : radius::round_family(balanced.block(0), Deadline::in(60)).family.matrices)
    CHECK(m.largest_modulus() < 1000);
  const RationalMatrix product = round.coordinates.to * round.coordinates.from;
  for (std::size_t i = 0; i < family.size(); ++i)
    for (std::size_t j = 0; j < family.size(); ++j)
      CHECK(abs(Rational(product(i, j) - (i == j ? 1 : 0))) < power(Rational(10), -100));
  const SearchResult found = search_polytope(round.family);
  CHECK(found.closed);

  // A round family keeps its coordinates.
  CHECK_FALSE(radius::round_family({RationalMatrix::identity(3)}, Deadline::in(60)).coordinates.differ());
}

TEST_CASE("orbits that are flatter than doubles resolve keep finite coordinates") {
  for (const std::size_t size : {14, 20, 30}) {
    CAPTURE(size);
    for (const polytope::Matrix& a : radius::round_family(flat_family(size, 7), Deadline::in(5)).family.matrices)
      CHECK(std::isfinite(a.largest_modulus()));
  }
}

TEST_CASE("long vertices leave small differences between short ones to the linear program") {
  // Points (1 - s, z), z small beside their distance to (0, +-10^6), which cost 10^-6 for a way of 1.
  IncrementalSimplex simplex(PolytopeKind::real, GroupAction(2), {Deadline::in(60)});
  simplex.add(Vector{1, 0});
  simplex.add(Vector{0, 1e6});
  const Membership inside = simplex.solve(Vector{1 - 2e-7, 0.1}, 1 - 1e-4, 1);
  CHECK(inside.combined);
  CHECK(std::abs(inside.upper - (1 - 1e-7)) < 1e-12);
  const Membership outside = simplex.solve(Vector{1 - 2e-7, 0.3}, 1 - 1e-4, 1);
  CHECK(outside.upper > 1 + 0.9e-7);
}

TEST_CASE("products are improved by parts and by joins, and small looks at them are taken in any time") {
  const SearchFamily family{{two_by_two(1, 1, 0, 1), two_by_two(1, 0, 1, 1)}, {}};
  const double golden = (1 + std::sqrt(5.0)) / 2;
  for (const std::vector<std::vector<int>>& words :
       {std::vector<std::vector<int>>{{0, 0, 1, 0, 1}}, {{0, 0, 1}, {1, 1, 0}}, {{0}, {1}}}) {
    std::vector<Candidate> candidates;
    for (const std::vector<int>& word : words) candidates.push_back({word, product_radius(family.matrices, word)});
    add_better_neighbours(candidates, family);
    CHECK(candidates.front().word == std::vector<int>{0, 1});
    CHECK(candidates.front().radius == Approx(golden));
    CHECK(candidates.size() > words.size());
  }
  const auto found = search_products(family, {.max_length = 12, .width = 12, .budget = {Deadline::in(0)}});
  CHECK(found.front().radius == Approx(golden));
}
