#include "checker.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/radii/joint/constrained.hpp>
#include <subcert/analysis/radii/joint/one_block.hpp>
#include <subcert/analysis/radii/joint/similarity.hpp>
#include <subcert/analysis/radii/polytope_proof/candidate.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>
#include <subcert/cmake/random.hpp>

using namespace subcert;
using namespace subcert::testing;

TEST_CASE("the product that attains the radius is proved") {
  for (const char* specification : {"primal:n=2", "primal:n=3", "primal:n=5", "primal:n=6", "primal-odd:n=1",
                                    "primal-odd:n=2", "dual:n=2", "dual-odd:n=2", "dual-odd:n=4", "dd:n=2", "dd:n=3",
                                    "four-point:w=1/20", "ary:a=3,points=4,d=3", "bspline:degree=3", "dual:n=4,d=3"}) {
    CAPTURE(specification);
    const HolderRegularity regularity = regularity_of(specification);
    CAPTURE(regularity.radius.exact.reason);
    CHECK(regularity.radius.exact.is_yes());
  }
}

TEST_CASE("a complex leading pair") {
  // A rotation by the angle of 3/5 + 4/5 i, and a contraction: radius 1, attained by the rotation.
  RationalMatrix rotation(2, 2), contraction(2, 2);
  rotation(0, 0) = rotation(1, 1) = q("3/5");
  rotation(0, 1) = q("-4/5");
  rotation(1, 0) = q("4/5");
  contraction(0, 0) = contraction(1, 1) = q("1/2");
  contraction(0, 1) = q("1/3");
  const JointSpectralRadius radius = joint_spectral_radius({rotation, contraction}, {Deadline::in(30)});
  const auto* polytope = std::get_if<PolytopeProof>(&radius.proof);
  REQUIRE(polytope);
  CHECK(polytope->kind == PolytopeKind::complex);
  CHECK(radius.is_closed());
  CHECK(radius.radius.contains(1));
  for (const auto& terms : polytope->images)
    for (const WeightedVertex& term : terms)
      CHECK(term.modulus * term.modulus >= term.weight * term.weight + term.imaginary * term.imaginary);
  // The certificate of a scheme with such a pair.
  const Mask mask = make_scheme("dual:n=3").mask.curve();
  const HolderRegularity regularity = regularity_of("dual:n=3");
  CHECK(regularity.radius.is_closed());
  const Certificate certificate = exponent_certificate(mask, regularity);
  CHECK(proves(subject_of(mask), *certificate.claim.lower, *certificate.claim.upper, certificate.text()));
}

TEST_CASE("a group of two that reverses the coordinates of a block, but not the letters, is no flip") {
  // a = 7: the block of order 2 has other letters than its matrices have places.
  for (const char* specification : {"ary:a=7,points=5,d=1", "ary:a=5,points=5,d=1", "ary:a=3,points=5,d=1"}) {
    CAPTURE(specification);
    const Mask mask = make_scheme(specification).mask.curve();
    const Certificate certificate = exponent_certificate(mask, regularity_of(specification));
    CHECK(proves(subject_of(mask), *certificate.claim.lower, *certificate.claim.upper, certificate.text()));
  }
}

TEST_CASE("certificates by quadratic forms") {
  const auto by_form = [](const MatrixFamily& family) {
    JointSpectralRadius result = joint_spectral_radius(family, {Deadline::in(2)});
    result.proof = *radius::quadratic_bound(family, 0, {Deadline::in(2)});
    result.radius.upper = result.proved_upper();
    return result;
  };
  // With the flip, and without.
  const Mask mask = make_scheme("primal:n=3,d=3").mask.curve();
  const int rules = holder_bounds(mask, 4, Deadline::in(10)).sum_rules;
  HolderRegularity regularity = regularity_of("primal:n=3,d=3");
  regularity.radius = by_form(transition_matrices(divided_difference_scheme(mask, rules)));
  REQUIRE(regularity.radius.method() == JsrMethod::quadratic_form);
  CHECK(std::get<GraphProof>(regularity.radius.proof).states.size() > 1);
  const Certificate curve = exponent_certificate(mask, regularity);
  CHECK(proves(subject_of(mask), *curve.claim.lower, *curve.claim.upper, curve.text()));
  // With larger groups and equal matrices.
  const fs::path file = fs::temp_directory_path() / ("subcert-forms-test-" + std::to_string(getpid()) + ".matrices");
  RationalMatrix up(2, 2), down(2, 2);
  up(0, 0) = up(0, 1) = up(1, 1) = down(0, 0) = down(1, 0) = down(1, 1) = q("1/3");
  const auto surface = make_linear_scheme("grid:points=3x3,d=2");
  const BlockTriangular blocks = radius::with_symmetries(
      block_triangularise(difference_space(surface.mask, 3).family, Deadline::in(60)), Deadline::in(60));
  REQUIRE(blocks.block(0).group().size() == 8);
  for (const MatrixFamily& family : {MatrixFamily{up, down, up}, blocks.block(0)}) {
    const JointSpectralRadius radius = by_form(family);
    std::ofstream(file, std::ios::binary) << matrices_text(family);
    const Certificate certificate = radius_certificate(family, radius);
    CHECK(
        proves("--matrices " + file.string(), *certificate.claim.lower, *certificate.claim.upper, certificate.text()));
    CHECK_FALSE(proves("--matrices " + file.string(), "",
                       to_text(*parse_rational(*certificate.claim.upper) - power(Rational(10), -6)),
                       certificate.text()));
  }
  fs::remove(file);
}

TEST_CASE("reducible families: radii and certificates by blocks") {
  subcert::testing::Random random;
  const fs::path file = fs::temp_directory_path() / ("subcert-proofs-test-" + std::to_string(getpid()) + ".matrices");
  const auto check = [&](const std::vector<RationalMatrix>& family, const JointSpectralRadius& radius) {
    std::ofstream(file, std::ios::binary) << matrices_text(family);
    const Certificate certificate = radius_certificate(family, radius);
    CHECK(proves("--matrices " + file.string(), certificate.claim.lower.value_or(""), *certificate.claim.upper,
                 certificate.text()));
    CHECK_FALSE(proves("--matrices " + file.string(), "",
                       to_text(*parse_rational(*certificate.claim.upper) - power(Rational(10), -6)),
                       certificate.text()));
    fs::remove(file);
  };
  // The matrices of the four-point scheme, of radius 4, and a smaller pair, coupled and hidden by integer shears.
  const auto put = [](std::vector<RationalMatrix>& family, std::size_t start) {
    family[0](start, start) = family[0](start + 1, start) = family[1](start + 1, start + 1) = family[1](start,
                                                                                                        start + 1) = -1;
    family[0](start + 1, start + 1) = family[1](start, start) = 4;
  };
  for (int round = 0; round < 5; ++round) {
    std::vector<RationalMatrix> family(2, RationalMatrix(4, 4));
    put(family, 0);
    for (std::size_t t = 0; t < 2; ++t) {
      RationalMatrix& m = family[t];
      m(2, 2) = q("1/2");
      m(3, 3) = q("-2/3");
      m(3 - t, 2 + t) = 1;
      for (std::size_t i : {0, 1})
        for (std::size_t j : {2, 3}) m(i, j) = random.integer(-3, 3);
    }
    for (int k = 0; k < 8 * std::min(round, 1); ++k) {
      const auto i = static_cast<std::size_t>(random.integer(0, 3)),
                 j = (i + static_cast<std::size_t>(random.integer(1, 3))) % 4;
      RationalMatrix shear = RationalMatrix::identity(4), back = shear;
      shear(i, j) = random.integer(-2, 2);
      back(i, j) = -shear(i, j);
      for (RationalMatrix& m : family) m = shear * m * back;
    }
    const JointSpectralRadius radius = joint_spectral_radius(family, {Deadline::in(2)});
    REQUIRE(radius.by_blocks());
    CHECK(radius.by_blocks()->triangular.sizes == std::vector<std::size_t>{2, 2});
    CHECK(radius.radius.contains(4));
    CHECK(*radius.radius.upper < 4 + power(Rational(10), -5));
    if (round == 0) {
      CHECK(radius.radius.is_exact());
      CHECK(radius.exact.is_yes());
      CHECK(radius.growth.at_most == 0);
    }
    check(family, radius);
  }

  // Twice the same pair, coupled: equal radii, compared exactly; products grow by one power faster.
  std::vector<RationalMatrix> twice(2, RationalMatrix(4, 4));
  put(twice, 0);
  put(twice, 2);
  for (RationalMatrix& m : twice) m(0, 2) = m(1, 3) = 1;
  const JointSpectralRadius coupled = joint_spectral_radius(twice, {Deadline::in(20)});
  CHECK((coupled.radius.is_exact() && *coupled.radius.lower == 4));
  CHECK(coupled.exact.is_yes());
  CHECK(coupled.growth.at_least == 1);
  CHECK(coupled.growth.at_most == 1);
  check(twice, coupled);

  // The same for an irrational radius.
  const Mask scheme = make_scheme("four-point:w=1/20").mask.curve();
  const auto small = transition_matrices(divided_difference_scheme(scheme, 2));
  const std::size_t n = small.front().rows();
  std::vector<RationalMatrix> irrational(2, RationalMatrix(2 * n, 2 * n));
  for (std::size_t t = 0; t < 2; ++t)
    for (std::size_t i = 0; i < n; ++i) {
      irrational[t](i, n + i) = 1;
      for (std::size_t j = 0; j < n; ++j) irrational[t](i, j) = irrational[t](n + i, n + j) = small[t](i, j);
    }
  const JointSpectralRadius double_root = joint_spectral_radius(irrational, {Deadline::in(20)});
  CHECK(double_root.by_blocks()->triangular.sizes == std::vector<std::size_t>{n, n});
  CHECK(double_root.exact.is_yes());
  CHECK(double_root.growth.at_least == 1);
  CHECK(double_root.growth.at_most == 1);
  check(irrational, double_root);

  // A Jordan block, and a nilpotent family.
  RationalMatrix jordan = RationalMatrix::identity(2);
  jordan(0, 1) = 1;
  const JointSpectralRadius one = joint_spectral_radius({jordan}, {Deadline::in(5)});
  CHECK((one.radius.is_exact() && *one.radius.lower == 1));
  CHECK(one.exact.is_yes());
  CHECK(one.growth.at_least == 1);
  check({jordan}, one);
  RationalMatrix up(3, 3), further(3, 3);
  up(0, 1) = up(1, 2) = 5;
  further(0, 2) = further(0, 1) = q("-1/3");
  const JointSpectralRadius zero = joint_spectral_radius({up, further}, {Deadline::in(5)});
  CHECK((zero.radius.is_exact() && *zero.radius.upper == 0));
  CHECK(zero.exact.is_yes());
  CHECK(zero.is_closed());
  std::ofstream(file, std::ios::binary) << matrices_text({up, further});
  CHECK(proves("--matrices " + file.string(), "", "0", radius_certificate({up, further}, zero).text()));
  fs::remove(file);
}

TEST_CASE("joint spectral radii from the literature") {
  RationalMatrix up(2, 2), down(2, 2);
  up(0, 0) = up(0, 1) = up(1, 1) = 1;
  down(0, 0) = down(1, 0) = down(1, 1) = 1;
  const JointSpectralRadius golden = joint_spectral_radius({up, down}, {Deadline::in(30)});
  CHECK(golden.is_closed());
  // The golden ratio: x^2 = x + 1.
  const Rational low = *golden.radius.lower, high = *golden.radius.upper;
  CHECK(low * low <= low + 1);
  CHECK(high * high >= high + 1);
  CHECK(high - low < power(Rational(10), -12));
  CHECK(golden.product.word.size() == 2);

  const fs::path matrices = fs::temp_directory_path() /
                            ("subcert-proofs-test-" + std::to_string(getpid()) + ".matrices");
  std::ofstream(matrices, std::ios::binary) << matrices_text({up, down});
  const Certificate certificate = radius_certificate({up, down}, golden);
  CHECK(proves("--matrices " + matrices.string(), *certificate.claim.lower, *certificate.claim.upper,
               certificate.text()));
  CHECK_FALSE(proves("--matrices " + matrices.string(), "", "16180/10000", certificate.text()));
  fs::remove(matrices);

  // One matrix, the zero matrix, the identity.
  CHECK(joint_spectral_radius({RationalMatrix::identity(3)}, {Deadline::in(5)}).radius.contains(1));
  CHECK(*joint_spectral_radius({RationalMatrix(2, 2)}, {Deadline::in(5)}).radius.upper == 0);
  RationalMatrix half(1, 1);
  half(0, 0) = q("-1/2");
  CHECK(joint_spectral_radius({half}, {Deadline::in(5)}).radius.contains(q("1/2")));
  CHECK_THROWS_AS(joint_spectral_radius({}, {Deadline::in(5)}), Error);
  CHECK_THROWS_AS(joint_spectral_radius({RationalMatrix(2, 3)}, {Deadline::in(5)}), Error);
}

TEST_CASE("radii of cycles whose eigenvalues differ by their signs, and of rational vectors of several letters") {
  const auto pair = [](const std::vector<const char*>& a, const std::vector<const char*>& b) {
    const std::size_t size = a.size() == 4 ? 2 : 3;
    return MatrixFamily{matrix_of(size, a), matrix_of(size, b)};
  };
  const std::vector<const char*> root_of_two = {"-1", "-1", "-1", "1"};
  for (const MatrixFamily& family :
       {pair({"-2", "-2", "1", "-2", "1", "-1", "-2", "-2", "1"}, {"1", "-1", "-1", "1", "-2", "-1", "0", "-2", "1"}),
        pair(root_of_two, {"1", "1", "1", "-1"}), pair(root_of_two, {"-1", "-1", "0", "0"}),
        pair(root_of_two, {"-1", "-1", "1", "-1"}), pair(root_of_two, {"-1", "0", "0", "1"}),
        // Vectors that one of several products leads back: those of the first two may not close, or are not rational.
        pair(root_of_two, {"-1", "-1", "1", "0"}), pair({"1", "1", "1", "0"}, {"1", "1", "-1", "2"}),
        pair({"-1", "2", "2", "1", "2", "-1", "-2", "1", "-1"}, {"0", "-2", "1", "2", "0", "0", "0", "-2", "-1"}),
        pair({"0", "-1", "1", "0"}, {"0", "0", "0", "0"}), pair({"0", "-1", "1", "0"}, {"-1", "0", "0", "0"})}) {
    const JointSpectralRadius radius = joint_spectral_radius(family, {Deadline::in(10)});
    CAPTURE(matrices_text(family));
    CHECK(radius.exact.is_yes());
    const Certificate certificate = radius_certificate(family, radius);
    CHECK(proves(family, certificate));
    if (radius.radius.is_exact() && certificate.claim.lower == certificate.claim.upper) continue;
    REQUIRE(certificate.claim.exact);
    CHECK(proves_exactly(family, certificate));
    // The negation is a generator for the cycles alone.
    const Certificate bounds = certificate.of_bounds();
    CHECK(proves(family, bounds));
    CHECK((says_its_claim(certificate) && says_its_claim(bounds)));
    const auto generators = [](const std::string& text) { return text.find("\ngenerator ") != std::string::npos; };
    CHECK(generators(bounds.text()) == (generators(certificate.text()) && family.group().size() > 2));
    // Another sign of the eigenvalue of a cycle.
    for (std::size_t i = 0; i < certificate.sections.size(); ++i) {
      Certificate wrong = certificate;
      std::string& lines = wrong.sections[i].lines;
      const std::size_t cycle = lines.find("\ncycle "), sign = lines.find(" A ", cycle);
      if (cycle == std::string::npos || sign == std::string::npos) continue;
      lines.replace(sign, 3, " - ");
      CHECK_FALSE(proves_exactly(family, wrong));
    }
  }
}

TEST_CASE("cones: exact where images lie below vertices") {
  // Euler's partition functions: ones where 0 <= 2i + t - j < d.
  for (const long d : {3L, 5L, 7L, 13L, 21L}) {
    CAPTURE(d);
    std::vector<Rational> ones(static_cast<std::size_t>(d), 1);
    const MatrixFamily family(transition_matrices(Mask(LaurentPolynomial(ones, 0), 2)));
    const JointSpectralRadius radius = joint_spectral_radius(family, {Deadline::in(30)});
    CHECK(radius.exact.is_yes());
    CHECK(*radius.radius.upper - *radius.radius.lower < power(Rational(10), -18));
    CHECK(radius.radius.contains(Rational(d, 2)) == false);
    CHECK(proves(family, radius_certificate(family, radius)));
  }
  // The capacity of binary words without two ones in a row.
  RationalMatrix step(2, 2);
  step(0, 0) = step(0, 1) = step(1, 0) = 1;
  CHECK(joint_spectral_radius({step}, {Deadline::in(5)}).exact.is_yes());
}

TEST_CASE("a cone needs matrices without negative entries, also where doubles see none") {
  // Differences of the fourth order are 1, -1e-12, 2/5, and those of the reduced mask were taken for non-negative.
  const Mask mask = make_scheme(
                        "mask:[1000000000000,2999999999999,3399999999997,3199999999997,4199999999998,"
                        "3799999999997,2199999999997,1199999999999,400000000000]/11199999999992@-4")
                        .mask.curve();
  const HolderRegularity regularity = holder_regularity(mask, 8, {Deadline::in(20)}, HolderProof::certificate);
  const Certificate certificate = exponent_certificate(mask, regularity);
  CHECK(certificate.text().find(" nonnegative\n") == std::string::npos);
  CHECK(proves(subject_of(mask), *certificate.claim.lower, *certificate.claim.upper, certificate.text()));
  RationalMatrix matrix(2, 2);
  matrix(0, 0) = matrix(1, 1) = 1;
  matrix(0, 1) = power(Rational(10), -40);
  const MatrixFamily family{matrix};
  radius::PolytopeCandidate candidate = radius::find_polytope(family, Budget{Deadline::in(5)}, true);
  REQUIRE(candidate.kind == PolytopeKind::nonnegative);
  matrix(0, 1) = -matrix(0, 1);
  CHECK_FALSE(certify_polytope(MatrixFamily{matrix}, candidate, Budget{Deadline::in(5)}));
}

TEST_CASE("an eigenvalue that is given exactly proves its modulus, whether it is known to be the largest or not") {
  const std::size_t size = 25;  // from 24 on an inverse proves what is not
  RationalMatrix matrix(size, size);
  for (std::size_t i = 0; i < size; ++i) matrix(i, i) = i == 7 ? Rational(-1) : Rational(1, static_cast<long>(i) + 2);
  const MatrixFamily family{matrix};
  JointSpectralRadius radius;
  radius.product = prove_product(family, {0}, Deadline::in(60));
  REQUIRE(radius.product.exact == Rational(1));
  radius.product.exact.reset();  // as where there is no time to enclose the other eigenvalues
  radius.radius = Enclosure::exactly(1);
  radius.proof = NormProof{1, 1};
  const Certificate certificate = radius_certificate(family, radius);
  CHECK(certificate.claim.lower == "1");
  CHECK(proves(family, certificate));
}

TEST_CASE("certificates of subradii are proved by the checker, false claims are not") {
  const auto family_of = [](std::size_t size, const std::vector<std::vector<Rational>>& matrices) {
    std::vector<RationalMatrix> result;
    for (const std::vector<Rational>& entries : matrices) {
      RationalMatrix& matrix = result.emplace_back(size, size);
      for (std::size_t i = 0; i < size * size; ++i) matrix(i / size, i % size) = entries[i];
    }
    return MatrixFamily(result);
  };
  // By a transposed polytope; with a zero in the first vertex; by equations; with tiny numbers; of a number.
  for (const MatrixFamily& family :
       {family_of(2, {{7, 2, 0, 3}, {2, 0, 4, 8}}), family_of(2, {{1, 1, 0, 1}, {q("4/5"), 0, q("4/5"), q("4/5")}}),
        family_of(2, {{1, 1, 1, 0}, {1, 1, 1, 1}}), family_of(1, {{q("2/7")}}),
        power(Rational(10), -100) * family_of(2, {{7, 2, 0, 3}, {2, 0, 4, 8}})}) {
    const JointSpectralSubradius found = joint_spectral_subradius(family, {Deadline::in(60)});
    REQUIRE(found.exact.is_yes());
    const Certificate certificate = subradius_certificate(family, found);
    const fs::path file = fs::temp_directory_path() / ("subcert-proofs-test-" + std::to_string(getpid()) + ".mat");
    std::ofstream(file, std::ios::binary) << matrices_text(family);
    const std::string subject = "--subradius " + file.string();
    REQUIRE(certificate.claim.exact);
    const std::string lower = *certificate.claim.lower, upper = *certificate.claim.upper;
    CHECK(proves(subject + " --exact '" + *certificate.claim.exact + "'", lower, upper, certificate.text()));
    CHECK(proves(subject, lower, upper, certificate.of_bounds().text()));
    const auto above = [](const std::string& end) { return to_text(*parse_rational(end) * Rational(1001, 1000)); };
    const auto below = [](const std::string& end) { return to_text(*parse_rational(end) * Rational(999, 1000)); };
    CHECK_FALSE(proves(subject, above(lower), "", certificate.text()));
    CHECK_FALSE(proves(subject, "", below(upper), certificate.text()));
    fs::remove(file);
  }
}

TEST_CASE("isometries end at once") {
  const auto matrix = [](const char* a, const char* b, const char* c, const char* d) {
    return matrix_of(2, {a, b, c, d});
  };
  // A rotation and a reflection; two generators of a finite group in skew coordinates; twice
  // a rotation and a reflection.
  for (const MatrixFamily& family : {MatrixFamily{matrix("3/5", "-4/5", "4/5", "3/5"), matrix("1", "0", "0", "-1")},
                                     MatrixFamily{matrix("1", "1", "-1", "0"), matrix("0", "1", "-1", "-1")},
                                     MatrixFamily{matrix("0", "-2", "2", "0"), matrix("2", "0", "0", "-2")}}) {
    const JointSpectralRadius radius = joint_spectral_radius(family, {Deadline::in(20)});
    CHECK(radius.exact.is_yes());
    CHECK(radius.radius.is_exact());
    CHECK(radius.method() == JsrMethod::quadratic_form);
    CHECK(proves_exactly(family, radius_certificate(family, radius)));
    // What is true of a family is true of its multiples, however small.
    const MatrixFamily tiny = power(Rational(10), -100) * family;
    const JointSpectralRadius small = joint_spectral_radius(tiny, {Deadline::in(20)});
    CHECK(small.exact.is_yes());
    CHECK(*small.radius.lower == *radius.radius.lower * power(Rational(10), -100));
    CHECK(proves_exactly(tiny, radius_certificate(tiny, small)));
  }
}

TEST_CASE("products along a graph") {
  RationalMatrix up(2, 2), down(2, 2);
  up(0, 0) = up(0, 1) = up(1, 1) = 1;
  down(0, 0) = down(1, 0) = down(1, 1) = 1;
  const MatrixFamily pair{up, down};
  const auto radius = [&](const std::vector<Succession>& graph) {
    return joint_spectral_radius(lifted(pair, graph).family, {Deadline::in(20)}).radius;
  };
  // All words: two loops at one node, or all edges between two.
  const Enclosure golden = joint_spectral_radius(pair, {Deadline::in(20)}).radius;
  CHECK(lifted(pair, {{0, 0, 0}, {0, 0, 1}}).family.matrices() == pair.matrices());
  CHECK(radius({{0, 0, 0}, {0, 1, 1}, {1, 0, 0}, {1, 1, 1}}).contains(*golden.lower));
  // One matrix leaves a node twice: two lifted matrices.
  const LiftedFamily twice = lifted(pair, {{0, 0, 0}, {0, 1, 0}, {1, 0, 1}});
  CHECK(twice.letters == std::vector<int>{0, 0, 1});
  // Each first twice, then the other: the fourth root of the radius of up^2 down^2, 3 + 2 sqrt 2.
  const Enclosure doubled = radius({{0, 1, 0}, {1, 2, 0}, {2, 3, 1}, {3, 0, 1}});
  const Rational fourth = power(*doubled.lower, 4);
  CHECK(fourth < q("58285/10000"));
  CHECK(power(*doubled.upper, 4) > q("58284/10000"));
  CHECK(radius({{0, 1, 0}, {1, 2, 1}}).upper == Rational(0));
  CHECK_THROWS_AS(lifted(pair, {}), Error);
  CHECK_THROWS_AS(lifted(pair, {{0, 0, 2}}), Error);
}

TEST_CASE("families of numbers that doubles do not hold") {
  const MatrixFamily golden{matrix_of(2, {"1", "1", "0", "1"}), matrix_of(2, {"1", "0", "1", "1"})};
  const MatrixFamily four_point{matrix_of(2, {"-1", "0", "-1", "4"}), matrix_of(2, {"4", "-1", "0", "-1"})};
  const MatrixFamily turning{matrix_of(2, {"3/5", "-4/5", "4/5", "3/5"}), matrix_of(2, {"1/2", "1/3", "0", "1/2"})};
  for (const MatrixFamily* family : {&golden, &four_point, &turning})
    for (const long exponent : {160, -30, -400}) {
      CAPTURE(exponent);
      const JointSpectralRadius plain = joint_spectral_radius(*family, {Deadline::in(20)});
      const Rational factor = power(Rational(10), exponent);
      const MatrixFamily scaled = factor * *family;
      const JointSpectralRadius radius = joint_spectral_radius(scaled, {Deadline::in(20)});
      CHECK(radius.is_closed());
      CHECK(radius.exact.truth == plain.exact.truth);
      CHECK(radius.product.word == plain.product.word);
      CHECK(*radius.radius.lower <= factor * *plain.radius.upper);
      CHECK(*radius.radius.upper >= factor * *plain.radius.lower);
      Certificate certificate = radius_certificate(scaled, radius);
      CHECK(proves(scaled, certificate));
      CHECK_FALSE(proves(*family, certificate));
      certificate.claim.upper = to_text(factor * *plain.radius.lower * q("999999/1000000"));
      CHECK_FALSE(proves(scaled, certificate));
    }
}

TEST_CASE("families whose entries differ in size") {
  // Coordinates of other lengths: the radius is that of the golden ratio all the same.
  const Rational large = power(Rational(10), 200);
  RationalMatrix up = RationalMatrix::identity(2), down = up;
  up(0, 1) = large;
  down(1, 0) = 1 / large;
  const JointSpectralRadius skew = joint_spectral_radius({up, down}, {Deadline::in(20)});
  CHECK(skew.is_closed());
  CHECK(*skew.radius.lower * *skew.radius.lower <= *skew.radius.lower + 1);
  CHECK(*skew.radius.upper * *skew.radius.upper >= *skew.radius.upper + 1);
  CHECK(proves({up, down}, radius_certificate({up, down}, skew)));
  // Blocks of radius 4 * 10^200 and 10^-200, coupled.
  std::vector<RationalMatrix> blocks(2, RationalMatrix(4, 4));
  for (std::size_t t = 0; t < 2; ++t) {
    blocks[t](t, t) = blocks[t](1 - t, t) = blocks[t](1 - t, 1 - t) = 0;
    blocks[t](0, 0) = t == 0 ? -large : 4 * large;
    blocks[t](1, 1) = t == 0 ? 4 * large : -large;
    blocks[t](1 - t, t) = -large;
    blocks[t](0, 3) = 7;
    blocks[t](2, 2) = blocks[t](3, 3) = blocks[t](2 + t, 3 - t) = 1 / large;
  }
  const JointSpectralRadius coupled = joint_spectral_radius(blocks, {Deadline::in(20)});
  CHECK(coupled.by_blocks());
  CHECK(coupled.is_closed());
  CHECK(coupled.radius.contains(4 * large));
  CHECK(proves(blocks, radius_certificate(blocks, coupled)));
  // One entry that doubles do not see beside the others.
  RationalMatrix flat(2, 2), tiny = RationalMatrix::identity(2);
  flat(0, 0) = flat(0, 1) = flat(1, 0) = 1;
  tiny(0, 1) = tiny(1, 0) = power(Rational(10), -300);
  const JointSpectralRadius near = joint_spectral_radius({tiny, flat}, {Deadline::in(20)});
  CHECK(near.is_closed());
  CHECK(proves({tiny, flat}, radius_certificate({tiny, flat}, near)));
}

TEST_CASE("norms of a family with opposite matrices have lengths that the checker goes through") {
  const RationalMatrix m = matrix_of(3, {"1", "5", "-2", "0", "-1", "7", "3", "1", "1"});
  const MatrixFamily family{m, Rational(-1) * m};
  CHECK(norm_of_products({m}, {}, 2).level <= 9);
  const JointSpectralRadius found = joint_spectral_radius(family, {Deadline::in(0.001)});
  CHECK(found.exact.is_yes());
  CHECK(proves(family, radius_certificate(family, found)));
}

TEST_CASE("near a bound the work ends with what is proved") {
  subcert::testing::Random random;
  std::vector<RationalMatrix> large(2, RationalMatrix(48, 48));
  for (RationalMatrix& m : large)
    for (std::size_t i = 0; i < 48; ++i)
      for (std::size_t j = 0; j < 48; ++j) m(i, j) = random.integer(-9, 9);
  const JointSpectralRadius bounded = joint_spectral_radius(large, {Deadline::in(0.5)});
  CHECK(*bounded.radius.lower <= *bounded.radius.upper);
  CHECK(joint_spectral_radius(large, {Deadline::in(0)}).radius.upper.has_value());
  // Norms of products are the same in any time.
  for (const std::size_t size : {1, 3, 12, 48}) {
    std::vector<RationalMatrix> family(2, RationalMatrix(size, size));
    for (RationalMatrix& m : family)
      for (std::size_t i = 0; i < size * size; ++i)
        m(i / size, i % size) = Rational(random.integer(-9, 9), random.integer(1, 9));
    const NormProof at_once = norm_of_products(family, {Deadline::in(0)}), in_time = norm_of_products(family, {});
    CHECK(at_once.level == in_time.level);
    CHECK(at_once.norm == in_time.norm);
    Rational longest = 0;
    for (int number = 0; number < 1 << in_time.level; ++number) {
      std::vector<int> word;
      for (int k = 0; k < in_time.level; ++k) word.push_back(number >> k & 1);
      longest = std::max(longest, one_norm(MatrixFamily(family).product(word)));
    }
    CHECK(in_time.norm == longest);
  }
  // Memory: products of one length only, and no polytope.
  CHECK(norm_of_products(large, {Deadline(), std::size_t{1} << 16}).level == 1);
  const MatrixFamily four_point{matrix_of(2, {"-1", "0", "-1", "4"}), matrix_of(2, {"4", "-1", "0", "-1"})};
  const JointSpectralRadius norms = joint_spectral_radius(four_point, {Deadline::in(5), 64});
  CHECK(norms.method() == JsrMethod::norm_of_products);
  CHECK(norms.radius.contains(4));
  CHECK(proves(four_point, radius_certificate(four_point, norms)));
}
