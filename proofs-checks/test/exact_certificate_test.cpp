#include "checker.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/radii/joint/one_block.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/transition/transition.hpp>
#include <subcert/cmake/random.hpp>

#include <array>
#include <set>

using namespace subcert;
using namespace subcert::testing;

TEST_CASE("one spectral radius: the exponent, what it is, and the modulus of continuity") {
  struct Case {
    const char* specification;
    int logarithm;
  };
  // Rational and irrational numbers, several arities, an even mask, zeros on the unit circle, integers by norms and by
  // recurrences, shifts that are not stable.
  for (const auto& [specification, logarithm] :
       {Case{"dd:n=2", 1}, Case{"dd:n=3", 0}, Case{"dd:n=6", 0}, Case{"four-point:w=1/20", 0},
        Case{"bspline:degree=3,a=3", 0}, Case{"mask:[-5,-7,35,105,105,35,-7,-5]/128", 0}, Case{"bspline:degree=1", 0},
        Case{"pseudo-spline:m=4,l=2", 0}, Case{"mask:[-1,0,9,16,9,0,-1]/16", 1}, Case{"mask:[1,2,2,2,1]/4", 0}}) {
    CAPTURE(specification);
    const Mask mask = make_scheme(specification).mask.curve();
    const HolderRegularity regularity = regularity_of(specification);
    CHECK(regularity.deciding().radius.method() == JsrMethod::single_spectral_radius);
    const Certificate certificate = exponent_certificate(mask, regularity);
    const CertificateClaim& claim = certificate.claim;
    const auto& [lower, upper] = static_cast<const ClaimedEnds&>(claim);
    REQUIRE((lower && upper && claim.exact));
    REQUIRE(claim.logarithm == logarithm);
    const std::string number = subject_of(mask) + " --exact '" + *claim.exact + "'";
    CHECK(proves(number + " --logarithm " + std::to_string(logarithm), *lower, *upper, certificate.text()));
    CHECK_FALSE(proves(number + " --logarithm " + std::to_string(1 - logarithm), "", "", certificate.text()));
    CHECK_FALSE(proves(number, to_text(*parse_rational(*lower) + Rational(1, 1000000)), "", certificate.text()));
    CHECK(proves(subject_of(mask), *lower, *upper, certificate.of_bounds().text()));
  }
  // Where polytopes prove it.
  const Certificate polytopes = exponent_certificate(make_scheme("primal:n=5").mask.curve(),
                                                     regularity_of("primal:n=5"));
  CHECK(polytopes.claim.logarithm == 0);
}

TEST_CASE("certificates say what an exponent or a radius is") {
  // A product that the flip shortens, one of four letters, one with a complex eigenvalue, one without flip.
  for (const char* specification :
       {"primal:n=2", "primal:n=4", "primal:n=5", "dual:n=3", "dd:n=2", "four-point:w=1/20"}) {
    CAPTURE(specification);
    const Mask mask = make_scheme(specification).mask.curve();
    CHECK(proves_exactly(subject_of(mask), exponent_certificate(mask, regularity_of(specification))));
  }
  // A cone, diagonal blocks, and several variables.
  const fs::path file = fs::temp_directory_path() / ("subcert-exact-test-" + std::to_string(getpid()) + ".matrices");
  const MatrixFamily golden{matrix_of(2, {"1", "1", "0", "1"}), matrix_of(2, {"1", "0", "1", "1"})};
  const MatrixFamily blocks{matrix_of(3, {"1", "1", "2", "0", "1", "3", "0", "0", "1/2"}),
                            matrix_of(3, {"1", "0", "1", "1", "1", "1", "0", "0", "1/3"})};
  for (const MatrixFamily& family : {golden, blocks}) {
    std::ofstream(file, std::ios::binary) << matrices_text(family);
    const Certificate certificate = radius_certificate(family, joint_spectral_radius(family, {Deadline::in(30)}));
    CHECK(certificate.claim.exact == "|[-1,-1,1]@809/500,0,1/1000|^1/1");
    CHECK(proves_exactly("--matrices " + file.string(), certificate));
  }
  fs::remove(file);
  // Of the butterfly an image is near to a vertex that stems from another cycle, and lies inside.
  for (const char* specification : {"grid:points=3x3,d=1", "butterfly:w=1/16"}) {
    const auto surface = make_linear_scheme(specification);
    const MultivariateRegularity regularity = multivariate_regularity(surface.mask, {Deadline::in(60)});
    CHECK(proves_exactly(subject_of(surface.mask), surface_certificate(surface.mask, regularity)));
  }
}

TEST_CASE("certificates of letters that a product keeps") {
  const auto by_graph = [](const MatrixFamily& family, const std::vector<int>& word) {
    JointSpectralRadius result;
    result.product = prove_product(family, word);
    const auto graph = radius::prove_by_forms(family, *result.product.radius.lower, {Deadline::in(20)}, result.product);
    REQUIRE((graph && graph->attained));
    result.exact = {Truth::yes, "by a graph"};
    result.radius = graph->attained->radius;
    result.proof = *graph;
    return result;
  };
  // A complex pair.
  const Mask mask = make_scheme("primal:n=3,d=3").mask.curve();
  HolderRegularity regularity = regularity_of("primal:n=3,d=3");
  regularity.radius = by_graph(transition_matrices(divided_difference_scheme(mask, regularity.bounds.sum_rules)),
                               regularity.radius.product.word);
  CHECK(proves_exactly(subject_of(mask), exponent_certificate(mask, regularity)));
  const fs::path file = fs::temp_directory_path() / ("subcert-kept-test-" + std::to_string(getpid()) + ".matrices");
  const MatrixFamily golden{matrix_of(2, {"1", "1", "0", "1"}), matrix_of(2, {"1", "0", "1", "1"})};
  std::ofstream(file, std::ios::binary) << matrices_text(golden);
  CHECK(proves_exactly("--matrices " + file.string(), radius_certificate(golden, by_graph(golden, {0, 1}))));
  // By the search, where no polytope closes: letters of equal matrices, and a power of two taken out.
  const Mask open = make_scheme("primal:n=6,d=5").mask.curve();
  const MatrixFamily pair = Rational(1, 1000) * transition_matrices(divided_difference_scheme(open, 6));
  const MatrixFamily family({pair[0], pair[1], pair[0], pair[1]});
  const JointSpectralRadius radius = joint_spectral_radius(family, {Deadline::in(10)});
  REQUIRE(radius.exact.is_yes());
  REQUIRE(std::holds_alternative<GraphProof>(radius.proof));
  std::ofstream(file, std::ios::binary) << matrices_text(family);
  CHECK(proves_exactly("--matrices " + file.string(), radius_certificate(family, radius)));
  fs::remove(file);
}

namespace {

/// Whether the certificate, as the checker accepts it, says as much as the answer: that the number is exact, or why
/// not.
bool says_as_much(const MatrixFamily& family) {
  const JointSpectralRadius radius = joint_spectral_radius(family, {Deadline::in(10)});
  Certificate certificate = radius_certificate(family, radius);
  CAPTURE(matrices_text(family), radius.exact.reason, certificate.missing);
  if (certificate.claim.exact && !proves_exactly(family, certificate)) certificate = certificate.of_bounds();
  CHECK(proves(family, certificate));
  CHECK((radius.exact.is_yes() || !certificate.claim.exact));
  const bool says = certificate.claim.exact || certificate.claim.lower == certificate.claim.upper ||
                    *radius.radius.upper == 0;
  CHECK((says || !radius.exact.is_yes() || !certificate.missing.empty()));
  return says || !radius.exact.is_yes();
}

/// Pairs of 2 x 2 matrices with entries -1, 0, 1: one of each class under signs of the matrices, their order,
/// transposes and signed permutations of the coordinates. Source: Cicone, Guglielmi, Serra-Capizzano, Zennaro 2010.
std::vector<MatrixFamily> small_pairs() {
  using Entries = std::array<int, 4>;
  const auto signed_least = [](Entries m) {
    Entries minus = m;
    for (int& x : minus) x = -x;
    return std::min(m, minus);
  };
  std::set<std::pair<Entries, Entries>> classes;
  const auto entries_of = [](int number) {
    Entries m{};
    for (int& x : m) x = number % 3 - 1, number /= 3;
    return m;
  };
  const auto moved = [](Entries m, int by) {
    if (by & 1) std::swap(m[1], m[2]);
    if (by & 2) std::reverse(m.begin(), m.end());
    if (by & 4) m[1] = -m[1], m[2] = -m[2];
    return m;
  };
  for (int i = 0; i < 81; ++i)
    for (int j = 0; j <= i; ++j) {
      std::pair<Entries, Entries> least{{2}, {2}};
      for (int by = 0; by < 8; ++by) {
        const Entries a = signed_least(moved(entries_of(i), by)), b = signed_least(moved(entries_of(j), by));
        least = std::min(least, std::pair<Entries, Entries>(std::minmax(a, b)));
      }
      classes.insert(least);
    }
  std::vector<MatrixFamily> pairs;
  for (const auto& [a, b] : classes) {
    RationalMatrix first(2, 2), second(2, 2);
    for (std::size_t k = 0; k < 4; ++k) first(k / 2, k % 2) = a[k], second(k / 2, k % 2) = b[k];
    pairs.push_back({first, second});
  }
  return pairs;
}

MatrixFamily random_family(subcert::testing::Random& random) {
  const auto size = static_cast<std::size_t>(random.integer(2, 3)),
             count = static_cast<std::size_t>(random.integer(1, 3));
  const long most = random.integer(1, 2);
  std::vector<RationalMatrix> matrices(count, RationalMatrix(size, size));
  for (RationalMatrix& m : matrices)
    for (std::size_t i = 0; i < size * size; ++i) m(i / size, i % size) = random.integer(-most, most);
  return matrices;
}

/// How many of random families say more than their certificates.
int silent_among(int count) {
  subcert::testing::Random random;
  int silent = 0;
  for ([[maybe_unused]] const auto round : subcert::testing::rounds(count))
    silent += !says_as_much(random_family(random));
  return silent;
}

}  // namespace

TEST_CASE("what an answer says is exact a certificate proves, or says why not") {
  CHECK(silent_among(40) <= 1);
  const std::vector<MatrixFamily> pairs = small_pairs();
  for (std::size_t k = 0; k < pairs.size(); k += 7) says_as_much(pairs[k]);
}

TEST_CASE("the same of four hundred families and all classes of small pairs", "[long]") {
  CHECK(silent_among(400) <= 2);
  const std::vector<MatrixFamily> pairs = small_pairs();
  CHECK(pairs.size() == 197);  // with that of two zeros
  int silent = 0;
  for (const MatrixFamily& pair : pairs) silent += !says_as_much(pair);
  CHECK(silent <= 1);
}
