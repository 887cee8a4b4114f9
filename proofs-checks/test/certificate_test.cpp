#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/radii/joint/constrained.hpp>
#include <subcert/analysis/radii/joint/one_block.hpp>
#include <subcert/analysis/radii/joint/similarity.hpp>
#include <subcert/analysis/radii/polytope_proof/candidate.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

using namespace subcert;
namespace fs = std::filesystem;

namespace {

Rational q(const char* text) { return *parse_rational(text); }

HolderRegularity regularity_of(const std::string& specification, int levels = 8) {
  return holder_regularity(make_scheme(specification).mask.curve(), levels, {Deadline::in(60)},
                           HolderProof::certificate);
}

/// Whether the checker proves this claim from the certificate.
bool proves(const std::string& subject, const std::string& lower, const std::string& upper, const std::string& text) {
  const fs::path file = fs::temp_directory_path() / ("subcert-proofs-test-" + std::to_string(getpid()) + ".cert");
  std::ofstream(file, std::ios::binary) << text;
  std::string command = std::string(SUBCERT_CHECKER) + " " + subject;
  if (!lower.empty()) command += " --lower " + lower;
  if (!upper.empty()) command += " --upper " + upper;
  const int status = std::system((command + " " + file.string() + " >/dev/null 2>&1").c_str());
  fs::remove(file);
  REQUIRE(WIFEXITED(status));
  return WEXITSTATUS(status) == 0;
}

std::string subject_of(const Mask& mask) {
  return "--mask '" + mask.symbol().to_mask_text() + "' --arity " + std::to_string(mask.arity());
}

std::string subject_of(const LatticeMask& mask) {
  return "--surface '" + to_mask_text(mask) + "' --dilation '" + mask.dilation().to_text() + "'";
}

MultivariatePolynomial one_plus(const LatticePoint& direction) {
  return MultivariatePolynomial(static_cast<int>(direction.size()),
                                {{1, LatticePoint(direction.size(), 0)}, {1, direction}});
}

LatticeMask box_spline(const std::vector<LatticePoint>& directions) {
  const int variables = static_cast<int>(directions.front().size());
  MultivariatePolynomial symbol(variables, power(Rational(2), variables - static_cast<long>(directions.size())));
  for (const LatticePoint& direction : directions) symbol = symbol * one_plus(direction);
  return {symbol, 2};
}

/// The centre, and the coefficients of the first and of the second ring about it.
LatticeMask rings(const Rational& centre, const std::vector<LatticePoint>& first, const Rational& at_first,
                  const std::vector<LatticePoint>& second, const Rational& at_second, Dilation dilation) {
  std::vector<MultivariatePolynomial::Monomial> terms{{centre, LatticePoint(2, 0)}};
  for (const LatticePoint& point : first) terms.push_back({at_first, point});
  for (const LatticePoint& point : second) terms.push_back({at_second, point});
  return {MultivariatePolynomial(2, terms), std::move(dilation)};
}

/// Whether the text says of itself what the claim is.
bool says_its_claim(const Certificate& certificate) {
  return checker_arguments(read_claim(certificate.text(), "file"), "file") ==
         checker_arguments(certificate.claim, "file");
}

/// Whether the checker proves what a certificate says of the radius of a family; `more`: and what else it is asked.
bool proves(const MatrixFamily& family, const Certificate& certificate, const std::string& more = "") {
  const fs::path file = fs::temp_directory_path() / ("subcert-proofs-test-" + std::to_string(getpid()) + ".family");
  std::ofstream(file, std::ios::binary) << matrices_text(family);
  const bool proved = proves("--matrices " + file.string() + more, certificate.claim.lower.value_or(""),
                             *certificate.claim.upper, certificate.text());
  fs::remove(file);
  return proved;
}

/// The same, and what the radius is. Domain: the certificate says it.
bool proves_exactly(const MatrixFamily& family, const Certificate& certificate) {
  return proves(family, certificate, " --exact '" + *certificate.claim.exact + "'");
}

RationalMatrix matrix_of(std::size_t size, const std::vector<const char*>& entries) {
  RationalMatrix m(size, size);
  for (std::size_t i = 0; i < size * size; ++i) m(i / size, i % size) = q(entries[i]);
  return m;
}

}  // namespace

TEST_CASE("known exponents are enclosed to 1e-12") {
  const struct {
    const char* specification;
    Rational low, high;
  } known[] = {
      {"bspline:degree=1", 1, 1},
      {"bspline:degree=4", 4, 4},
      {"bspline:degree=3,a=3", 3, 3},
      {"dd:n=2", 2, 2},
      {"dd:n=3", q("2830074998557/1000000000000"), q("2830074998558/1000000000000")},
      {"mask:[-5,-7,35,105,105,35,-7,-5]/128", q("2830074998557/1000000000000"), q("2830074998558/1000000000000")},
      // 2 - log2(1 + sqrt(1 - 16 w)) at w = 1/20 is 2 - log2(1.4472135954999579...)
      {"four-point:w=1/20", q("1466722133/1000000000"), q("1466722134/1000000000")}};
  for (const auto& [specification, low, high] : known) {
    CAPTURE(specification);
    const HolderRegularity regularity = regularity_of(specification);
    CHECK(regularity.radius.is_closed());
    REQUIRE(regularity.exponent.is_bounded());
    CHECK(*regularity.exponent.upper - *regularity.exponent.lower < power(Rational(10), -12));
    CHECK(*regularity.exponent.lower <= high);
    CHECK(*regularity.exponent.upper >= low);
  }
}

TEST_CASE("shifts that are not stable: the exponent and the certificate of the reduced mask") {
  struct Case {
    const char *mask, *factor;
    int exponent;
  };
  for (const Case& c : {Case{"mask:[1,1,1,1]/2", "1 + z", 1}, Case{"mask:[1,2,2,2,1]/4", "1 + z", 2},
                        Case{"mask:[1,3,3,2,3,3,1]/8", "1 + z + z^2", 3}, Case{"mask:[1,1,0,1,1]/2", "1 + z + z^2", 1},
                        Case{"mask:[1,1,1,1,1,1,1,1,1]/3,arity=3", "1 + z + z^2", 1}}) {
    CAPTURE(c.mask);
    const HolderRegularity regularity = regularity_of(c.mask);
    CHECK(regularity.stable.is_no());
    REQUIRE(regularity.reduced);
    const Mask mask = make_scheme(c.mask).mask.curve();
    const ReducedMask& other = regularity.reduced->mask;
    CHECK(other.factor.to_text() == c.factor);
    CHECK(mask.symbol() * other.factor == other.factor.dilated(mask.arity()) * other.mask.symbol());
    CHECK(has_stable_shifts(other.mask).is_yes());
    CHECK(regularity.exponent.is_exact());
    CHECK(*regularity.exponent.lower == c.exponent);
    CHECK(has_derivatives(regularity, c.exponent) == Truth::no);
    CHECK(has_derivatives(regularity, c.exponent - 1) == Truth::yes);
    const Certificate certificate = exponent_certificate(mask, regularity);
    CHECK(certificate.claim.upper == std::to_string(c.exponent));
    CHECK(proves(subject_of(mask), *certificate.claim.lower, *certificate.claim.upper, certificate.text()));
    CHECK_FALSE(proves(subject_of(mask), std::to_string(c.exponent) + "1/10", "", certificate.text()));
  }
  // Continuous, but the scheme does not converge.
  const HolderRegularity divergent = regularity_of("mask:[1,0,0,2,0,0,1]/2");
  CHECK(divergent.converges.is_no());
  CHECK_FALSE(divergent.exponent.upper.has_value());
}

TEST_CASE("with stable shifts an upper end is never absent, and divergence is proved by products") {
  // Beside the 4-point scheme: doubles tell no radius from 1.
  const std::string w = "1000000000000000000000000000016/16000000000000000000000000000000";
  const Mask mask = make_scheme("four-point:w=" + w).mask.curve();
  const HolderRegularity near = holder_regularity(mask, 8, {Deadline::in(2)}, HolderProof::certificate);
  REQUIRE(near.exponent.upper.has_value());
  CHECK(*near.exponent.upper <= 2);
  CHECK(has_derivatives(near, 2) == Truth::no);
  const Certificate certificate = exponent_certificate(mask, near);
  CHECK(proves(subject_of(mask), *certificate.claim.lower, "2", certificate.text()));
  CHECK(proves(subject_of(mask), "", "C2", certificate.text()));
  CHECK_FALSE(proves(subject_of(mask), "", "C1", certificate.text()));
  const HolderRegularity divergent = regularity_of("mask:[33/50,15709/10000,17/50,-5709/10000]");
  CHECK(divergent.converges.is_no());
  CHECK(divergent.stable.is_yes());
  CHECK(regularity_of("mask:[1,1]").converges.is_no());
  CHECK(regularity_of("four-point:w=-1/2").converges.is_no());
  CHECK(regularity_of("four-point:w=1/2").converges.is_no());
}

TEST_CASE("certificates of the program are proved by the checker, false claims are not") {
  for (const char* specification :
       {"primal:n=2", "primal:n=3", "primal:n=5", "primal-odd:n=1", "dual:n=2", "dual-odd:n=2", "dd:n=2", "dd:n=3",
        "four-point:w=1/20", "ary:a=3,points=4,d=3", "bspline:degree=2"}) {
    CAPTURE(specification);
    const Mask mask = make_scheme(specification).mask.curve();
    const HolderRegularity regularity = regularity_of(specification);
    CHECK(regularity.radius.is_closed());
    const Certificate certificate = exponent_certificate(mask, regularity);
    REQUIRE(certificate.claim.lower);
    REQUIRE(certificate.claim.upper);
    CHECK(proves(subject_of(mask), *certificate.claim.lower, *certificate.claim.upper, certificate.text()));
    const Rational tiny = power(Rational(10), -9);
    CHECK_FALSE(
        proves(subject_of(mask), to_text(*parse_rational(*certificate.claim.upper) + tiny), "", certificate.text()));
    CHECK_FALSE(proves(subject_of(mask), *certificate.claim.lower,
                       to_text(*parse_rational(*certificate.claim.lower) - tiny), certificate.text()));
    // Not for another mask.
    CHECK_FALSE(proves("--mask '[1,4,7,4,1]/8' --arity 2", *certificate.claim.lower, "", certificate.text()));
  }
}

TEST_CASE("certificates of surfaces and volumes are proved by the checker, false claims are not") {
  const std::vector<LatticePoint> triangle{{1, 0}, {0, 1}, {1, 1}};
  std::vector<LatticePoint> twice = triangle;
  twice.insert(twice.end(), triangle.begin(), triangle.end());
  const LatticeMask quincunx = rings(1, {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, q("1/4"), {}, 0,
                                     Dilation({{1, -1}, {1, 1}}));
  LatticeMask butterfly = rings(1, {{1, 0}, {1, 1}, {0, 1}, {-1, 0}, {-1, -1}, {0, -1}}, q("1/2"),
                                {{1, 2}, {2, 1}, {1, -1}, {-1, 1}, {-1, -2}, {-2, -1}}, q("1/8"),
                                Dilation::multiple(2, 2));
  std::vector<MultivariatePolynomial::Monomial> outer = butterfly.symbol().terms();
  for (const LatticePoint& point : std::vector<LatticePoint>{
           {3, 1}, {3, 2}, {2, 3}, {1, 3}, {-1, 2}, {-2, 1}, {-3, -1}, {-3, -2}, {-2, -3}, {-1, -3}, {1, -2}, {2, -1}})
    outer.push_back({q("-1/16"), point});
  butterfly = {MultivariatePolynomial(2, outer), 2};
  const struct {
    const char* name;
    LatticeMask mask;
    Rational exponent;  // to 1e-13
  } known[] = {{"three directions", box_spline(triangle), 1},
               {"Loop", box_spline(twice), 3},
               {"butterfly", butterfly, 2},
               {"quincunx", quincunx, q("611516172738767/1000000000000000")},
               {"four directions in space", box_spline({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}), 1}};
  const Rational tiny = power(Rational(10), -12);
  for (const auto& [name, mask, exponent] : known) {
    CAPTURE(name);
    const Certificate certificate = surface_certificate(mask, multivariate_regularity(mask, {Deadline::in(60)}));
    REQUIRE(certificate.claim.lower);
    REQUIRE(certificate.claim.upper);
    const std::string lower = *certificate.claim.lower, upper = *certificate.claim.upper;
    CHECK(q(lower.c_str()) > exponent - tiny);
    CHECK(q(upper.c_str()) < exponent + tiny);
    const std::string text = certificate.of_bounds().text();
    CHECK(proves(subject_of(mask), lower, upper, text));
    CHECK_FALSE(proves(subject_of(mask), to_text(exponent + tiny), "", text));
    CHECK_FALSE(proves(subject_of(mask), lower, to_text(exponent - tiny), text));
    CHECK_FALSE(proves(subject_of(box_spline({{1, 0}, {0, 1}})), lower, "", text));
  }
  // Without stable shifts by the differences of the limit.
  const LatticeMask zwart_powell = box_spline({{1, 0}, {0, 1}, {1, 1}, {1, -1}});
  const Certificate unstable = surface_certificate(zwart_powell,
                                                   multivariate_regularity(zwart_powell, {Deadline::in(60)}));
  CHECK((unstable.claim.lower == "2" && unstable.claim.upper == "2"));
  CHECK(proves(subject_of(zwart_powell), "2", "2", unstable.text()));
  CHECK_FALSE(proves(subject_of(zwart_powell), to_text(2 + tiny), "", unstable.text()));
  CHECK_FALSE(proves(subject_of(zwart_powell), "2", to_text(2 - tiny), unstable.text()));
  const LatticeMask haar = box_spline({{1, 0}, {0, 1}});
  CHECK_THROWS_AS(surface_certificate(haar, multivariate_regularity(haar, {Deadline::in(5)})), Error);
}

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

namespace {

bool proves_exactly(const std::string& subject, const Certificate& certificate) {
  const CertificateClaim& claim = certificate.claim;
  REQUIRE(claim.exact);
  const Certificate bounds = certificate.of_bounds();
  CHECK(bounds.text().find("cycle") == std::string::npos);
  CHECK((says_its_claim(certificate) && says_its_claim(bounds)));
  CHECK(proves(subject, *bounds.claim.lower, *bounds.claim.upper, bounds.text()));
  std::string other = *claim.exact;
  other.back() = other.back() == '9' ? '8' : '9';
  CHECK_FALSE(proves(subject + " --exact '" + other + "'", "", "", certificate.text()));
  return proves(subject + " --exact '" + *claim.exact + "'", *claim.lower, *claim.upper, certificate.text());
}

}  // namespace

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

TEST_CASE("equal input has equal certificates") {
  // Of the second one the search goes on with wider looks for products, and both sides take turns.
  for (const char* specification : {"primal:n=4", "dual:n=6,d=3"}) {
    const auto text = [&] {
      return exponent_certificate(make_scheme(specification).mask.curve(), regularity_of(specification)).text();
    };
    CHECK(text() == text());
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

TEST_CASE("reducible masks: certificates by blocks") {
  // (1+z)^4 (1 - z + z^2) r: the multiples of 1 + z + z^2 are an invariant subspace. The scheme is not stable.
  const LaurentPolynomial factor({1, -1, 1}, 0), rest({3, 5, 6, 4, 2}, 0);
  const LaurentPolynomial binary = LaurentPolynomial({1, 1}, 0).pow(4) * factor * rest;
  const Mask mask(binary * LaurentPolynomial(2 / binary(1)), 2);
  const HolderRegularity regularity = holder_regularity(mask, 8, {Deadline::in(30)}, HolderProof::certificate);
  REQUIRE(regularity.radius.by_blocks());
  CHECK(regularity.radius.by_blocks()->triangular.sizes.size() > 1);
  CHECK(regularity.stable.is_no());
  const Certificate certificate = exponent_certificate(mask, regularity);
  CHECK(certificate.text().find("\nblocks ") != std::string::npos);
  CHECK(proves(subject_of(mask), *certificate.claim.lower, "", certificate.text()));
  CHECK_FALSE(proves(subject_of(mask), to_text(*parse_rational(*certificate.claim.lower) + power(Rational(10), -6)), "",
                     certificate.text()));
  // Arity 3, p = (1 - z^4)/(1 - z).
  const LaurentPolynomial ternary = LaurentPolynomial({1, 1, 1}, 0).pow(3) *
                                    LaurentPolynomial({1, 0, 0, 0, 1, 0, 0, 0, 1}, 0) *
                                    LaurentPolynomial({2, 5, 1, 1}, 0);
  const Mask other(ternary * LaurentPolynomial(3 / ternary(1)), 3);
  const HolderRegularity second = holder_regularity(other, 6, {Deadline::in(30)}, HolderProof::certificate);
  REQUIRE(second.radius.by_blocks());
  const Certificate proof = exponent_certificate(other, second);
  CHECK(proves(subject_of(other), *proof.claim.lower, "", proof.text()));
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
  // Memory: products of one length only, and no polytope.
  CHECK(norm_of_products(large, {Deadline(), std::size_t{1} << 16}).level == 1);
  const MatrixFamily four_point{matrix_of(2, {"-1", "0", "-1", "4"}), matrix_of(2, {"4", "-1", "0", "-1"})};
  const JointSpectralRadius norms = joint_spectral_radius(four_point, {Deadline::in(5), 64});
  CHECK(norms.method() == JsrMethod::norm_of_products);
  CHECK(norms.radius.contains(4));
  CHECK(proves(four_point, radius_certificate(four_point, norms)));
}

TEST_CASE("the four-point scheme with a tension beyond doubles") {
  const std::string tension = "1" + std::string(200, '0');
  const Mask mask = make_scheme("four-point:w=" + tension).mask.curve();
  const HolderRegularity regularity = holder_regularity(mask, 6, {Deadline::in(20)});
  CHECK(regularity.exponent.lower.has_value());
  CHECK(*regularity.exponent.lower < 0);
  CHECK(*regularity.radius.radius.lower <= *regularity.radius.radius.upper);
}

TEST_CASE("certificates of ranges are accepted, and prove no more than their claims") {
  struct Case {
    const char *scheme, *property;
    int low, high;
    const char* verdicts;
  };
  for (const Case& c :
       {Case{"four-point:w", "C1", 0, 1, "yn"}, Case{"four-point:w", "holder>=3/2", 0, 1, "nyn"},
        Case{"four-point:w", "convergent", -1, 1, "nyn"}, Case{"mask:[w^2,1/2,1-2*w^2,1/2,w^2]", "C1", -1, 1, "nyyn"},
        Case{"mask:[w^2,1/2,1-2*w^2,1/2,w^2]", "stable", 0, 1, "yyy"},
        Case{"mask:[-1/18+1/6*u,-1/18-1/6*u,0,7/18-1/2*u,13/18+1/2*u,1,13/18+1/2*u,7/18-1/2*u,0,"
             "-1/18-1/6*u,-1/18+1/6*u],arity=3",
             "C2", 0, 1, "nyn"},
        // Refuted for lack of sum rules, on both sides of 1/16.
        Case{"four-point:w", "C2", 0, 1, "nn"}, Case{"mask:[1,v,v,1]/(1+v)", "C1", 2, 9, "nn"},
        // A pair of complex eigenvalues leads.
        Case{"mask:[-1/2*w,1/2-1/2*w,1,1/2+1/2*w,1/2*w]", "holder>=1/2", 0, 2, "yn"}}) {
    CAPTURE(c.scheme, c.property);
    const ParametricScheme scheme = make_parametric_scheme(c.scheme);
    const RangeProperty property = *parse_range_property(c.property);
    const Rational width(1, 1000);
    const PropertyRange range = property_range(scheme.mask, property, c.low, c.high, {width, 2, {Deadline::in(60)}});
    std::string verdicts;
    for (const RangeCertificate& piece : range_certificates(scheme.mask, scheme.letter, property, range, width)) {
      verdicts += piece.holds == Truth::yes ? 'y' : 'n';
      const auto subject = [&](const Rational& low, const Rational& high) {
        return "--mask '" + scheme.mask.to_text(scheme.letter) + "' --arity " + std::to_string(scheme.mask.arity()) +
               " --for " + scheme.letter + "=" + to_text(low) + ".." + to_text(high);
      };
      const CertificateClaim& claim = piece.certificate.claim;
      const std::string text = piece.certificate.text();
      CHECK(says_its_claim(piece.certificate));
      CHECK(proves(subject(piece.low, piece.high), claim.lower.value_or(""), claim.upper.value_or(""), text));
      CHECK_FALSE(proves(subject(piece.low, piece.high + 1), claim.lower.value_or(""), claim.upper.value_or(""), text));
      CHECK_FALSE(proves(subject(piece.low, piece.high), claim.upper.value_or("12"), "", text));
    }
    CHECK(verdicts == c.verdicts);
  }
}

TEST_CASE("certificates of curves are accepted, and prove no more than their envelopes") {
  for (const char* text :
       {"four-point:w", "mask:[w^2,1/2,1-2*w^2,1/2,w^2]", "mask:[-1/2*w,1/2-1/2*w,1,1/2+1/2*w,1/2*w]"}) {
    const ParametricScheme scheme = make_parametric_scheme(text);
    const ExponentCurve curve = exponent_curve(scheme.mask, q("1/20"), 1, {8, 2, {Deadline::in(60)}});
    for (const RangeCertificate& piece : curve_certificates(scheme.mask, scheme.letter, curve)) {
      const std::string subject = "--mask '" + scheme.mask.to_text(scheme.letter) + "' --arity 2 --for " +
                                  scheme.letter + "=" + to_text(piece.low) + ".." + to_text(piece.high);
      const auto& [lower, upper] = static_cast<const ClaimedEnds&>(piece.certificate.claim);
      CHECK_FALSE((piece.certificate.claim.exact || piece.certificate.claim.logarithm));
      CAPTURE(subject, lower.value_or("-"), upper.value_or("-"));
      CHECK(proves(subject, lower.value_or(""), upper.value_or(""), piece.certificate.text()));
      if (upper) CHECK_FALSE(proves(subject, *upper, "", piece.certificate.text()));
      if (lower)
        CHECK_FALSE(
            proves(subject, to_text(*parse_rational(*lower) + Rational(1, 1000)), "", piece.certificate.text()));
    }
  }
}

TEST_CASE("rounded masks: certificates for all masks nearby") {
  const Rational near = power(Rational(10), -40);
  for (const char* specification :
       {"mask:[1+t,3+t,3-t,1-t]/4@0,where=t^2-3:1.7..1.8", "daubechies:n=6", "daubechies:n=10", "primal:n=5",
        "dual:n=4,d=3", "ary:a=3,points=4,d=1", "cdf:n=2,m=4", "mask:[1,0,1,1,0,1]/2", "mask:[5,-1,4,7,-1,2]/8"}) {
    CAPTURE(specification);
    const Scheme scheme = make_scheme(specification);
    const Mask& mask = scheme.mask.curve();
    const MaskRounding rounding = scheme.rounding.value_or(MaskRounding{near, sum_rules(mask)});
    const HolderRegularity regularity = holder_regularity(mask, 8, {Deadline::in(60)}, HolderProof::certificate,
                                                          rounding);
    if (!(*regularity.exponent.lower > 0)) continue;
    const Certificate certificate = exponent_certificate(mask, regularity, rounding);
    const std::string subject = subject_of(mask) + " --within " + to_text(rounding.distance) + "," +
                                std::to_string(rounding.sum_rules),
                      lower = certificate.claim.lower.value(), upper = certificate.claim.upper.value_or("");
    CHECK(proves(subject, lower, upper, certificate.text()));
    CHECK_FALSE(proves(subject_of(mask), lower, upper, certificate.text()));
    CHECK_FALSE(proves(subject_of(mask) + " --within 1/10," + std::to_string(rounding.sum_rules), lower, upper,
                       certificate.text()));
    CHECK_FALSE(proves(subject, to_text(*parse_rational(lower) + q("1/1000")), upper, certificate.text()));
    if (!upper.empty())
      CHECK_FALSE(proves(subject, lower, to_text(*parse_rational(upper) - q("1/1000")), certificate.text()));
  }
}

TEST_CASE("rounded masks: the exponents of masks nearby are enclosed") {
  subcert::testing::Random random;
  for (const char* specification : {"mask:[273205,473205,126795,-73205]/400000", "primal:n=4", "daubechies:n=4"}) {
    CAPTURE(specification);
    const Mask mask = make_scheme(specification).mask.curve();
    const int rules = sum_rules(mask);
    const LaurentPolynomial smooth = LaurentPolynomial({q("1/2"), q("1/2")}, 0).pow(rules);
    const LaurentPolynomial rest = *mask.symbol().exact_quotient(smooth);
    const Rational distance = power(Rational(10), -30);
    const HolderRegularity all = holder_regularity(mask, 6, {Deadline::in(60)}, HolderProof::shortest,
                                                   MaskRounding{distance, rules});
    CAPTURE(all.stable.reason, to_decimal(*all.radius.radius.lower, 6, Rounding::down));
    REQUIRE(all.exponent.is_bounded());
    CHECK(*all.exponent.upper - *all.exponent.lower < q("1/1000"));
    for (const int round : {1, 2, 3}) {
      CAPTURE(round);
      // The errors of the other factor sum to 0; those of the mask are not larger.
      std::vector<Rational> errors{0};
      for (long k = 1; k < rest.length(); ++k) {
        errors.push_back(distance * Rational(random.integer(-100, 100), 100 * rest.length()));
        errors.front() -= errors.back();
      }
      const Mask other(smooth * (rest + LaurentPolynomial(errors, rest.lowest())), 2);
      const HolderRegularity exact = holder_regularity(other, 6, {Deadline::in(60)});
      CHECK(*all.exponent.lower <= *exact.exponent.lower);
      CHECK(*exact.exponent.upper <= *all.exponent.upper);
    }
  }
}

TEST_CASE("the exponent of D4 is 2 - log2(1 + sqrt 3)") {
  const Scheme scheme = make_scheme("daubechies:n=2");
  const HolderRegularity regularity = holder_regularity(scheme.mask.curve(), 6, {Deadline::in(60)},
                                                        HolderProof::shortest, scheme.rounding);
  const Rational digits = power(Rational(10), 80);
  Enclosure root = root_enclosure(3 * digits * digits, 2);
  root = {*root.lower / digits, *root.upper / digits};
  const Rational lower = 2 - *log_ratio(1 + *root.upper, 2).upper, upper = 2 - *log_ratio(1 + *root.lower, 2).lower;
  CHECK(*regularity.exponent.lower <= upper);
  CHECK(lower <= *regularity.exponent.upper);
  CHECK(*regularity.exponent.upper - *regularity.exponent.lower < power(Rational(10), -14));
  CHECK_FALSE(regularity.radius.exact.is_yes());
}
