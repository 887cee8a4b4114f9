#include "checker.hpp"

#include <subcert/analysis/regularity/multivariate_regularity.hpp>
#include <subcert/analysis/regularity/scheme_convergence.hpp>
#include <subcert/cmake/random.hpp>

using namespace subcert;
using namespace subcert::testing;

namespace {

Certificate certificate_of(const Scheme& scheme) {
  return field_certificate(*scheme.quadratic, vector_regularity(*scheme.quadratic, {Deadline::in(60)}));
}

/// As the certificate names its mask.
std::string subject_of(const Certificate& certificate) {
  const auto& subject = std::get<SurfaceSubject>(certificate.claim.subject);
  return "--refinable '" + subject.mask + "' --dilation '" + subject.dilation + "'";
}

/// A hat function, and beside it two functions f = h(2x - 1) (1, 1) + C_0 f(2x) + C_1 f(2x - 1): `c` are the entries of
/// both, row by row.
std::string beside_hat(const std::vector<std::string>& c) {
  REQUIRE(c.size() == 8);
  return "refinable:[[[1/2,0,0],[0,0,0],[0,0,0]],[[1,0,0],[0," + c[0] + "," + c[1] + "],[0," + c[2] + "," + c[3] +
         "]],[[1/2,0,0],[1," + c[4] + "," + c[5] + "],[1," + c[6] + "," + c[7] + "]]]@-1";
}

}  // namespace

TEST_CASE("certificates of matrices with a square root say what the exponent is") {
  for (const char* specification : {"cl:2", "cl:3", "bat:1", "bat:2", "bat:3", "sa4"}) {
    CAPTURE(specification);
    const Certificate certificate = certificate_of(make_refinable_scheme(specification));
    CHECK(certificate.missing.empty());
    CHECK(proves_exactly(subject_of(certificate), certificate));
  }
}

TEST_CASE("certificates of matrices with a square root: of random functions, and against false claims") {
  Random random;
  for ([[maybe_unused]] const auto round : rounds(6)) {
    const long root = random.chance(50) ? 2 : 7;
    std::vector<std::string> entries;
    for (int k = 0; k < 8; ++k)
      entries.push_back(std::to_string(random.integer(-3, 3)) + "/10+" + std::to_string(random.integer(0, 2)) +
                        "/20*sqrt(" + std::to_string(root) + ")");
    const Scheme scheme = make_refinable_scheme(beside_hat(entries));
    CAPTURE(scheme.specification);
    if (!scheme.quadratic) continue;
    const MultivariateRegularity found = vector_regularity(*scheme.quadratic, {Deadline::in(20)});
    if (!found.exponent.lower || *found.exponent.lower <= 0 || found.vector->solutions != 1) continue;
    const Certificate certificate = field_certificate(*scheme.quadratic, found);
    const CertificateClaim& claim = certificate.claim;
    const std::string subject = subject_of(certificate);
    REQUIRE(claim.lower);
    CHECK(proves(subject, *claim.lower, claim.upper.value_or(""), certificate.text()));
    CHECK_FALSE(proves(subject, to_text(*parse_rational(*claim.lower) + Rational(1, 1000)), "", certificate.text()));
    if (!claim.upper) continue;
    CHECK_FALSE(
        proves(subject, *claim.lower, to_text(*parse_rational(*claim.upper) - Rational(1, 1000)), certificate.text()));
  }
}

TEST_CASE("certificates of matrices with a square root: of one function, and of one of several solutions") {
  const auto asked = [](const Certificate& certificate) {
    const auto& named = std::get<SurfaceSubject>(certificate.claim.subject);
    return subject_of(certificate) + (named.integral.empty() ? "" : " --integral '" + named.integral + "'") +
           (named.component.empty() ? "" : " --component " + named.component);
  };
  // (x h + sqrt(2) y q, y q), h the hat function and q the quadratic B-spline; in the last one the bubble beside it
  const std::string mixed =
      "refinable:[[[2,-sqrt(2)],[0,1]],[[4,-sqrt(2)],[0,3]],[[2,sqrt(2)],[0,3]],[[0,sqrt(2)],[0,1]]]/4@-1";
  const std::string beside = "refinable:[[[2,0],[0,1]],[[4,0],[0,3]],[[2,0],[0,3]],[[0,0],[0,1]]]/4@-1";  // no root
  const std::string bubble = beside_hat({"sqrt(2)/2", "0", "1/3", "1/4", "sqrt(2)/2", "0", "0", "1/5"});
  for (const auto& [text, component, lower, upper] : std::vector<std::tuple<std::string, int, Rational, Rational>>{
           {mixed + ",integral=[1,0]", -1, 1, 1},
           {mixed + ",integral=[0,1]", -1, 1, 1},
           {mixed + ",integral=[0,1]", 0, 1, 1},
           {mixed + ",integral=[-2/3,1]", 1, 2, 2},
           {mixed + ",integral=[sqrt(2),0]", -1, 1, 1},
           {mixed + ",integral=[1/2-sqrt(2),sqrt(8)]", 1, 2, 2},
           {beside + ",integral=[0,1-sqrt(2)]", -1, 2, 2},
           {beside + ",integral=[sqrt(5),2]", 1, 2, 2},
           {bubble, 0, 1, 1},
           {bubble, 1, Rational(1, 2), Rational(1, 2)},
           {"bat:2", 1, Rational(1167, 1000), Rational(1168, 1000)}}) {
    CAPTURE(text, component);
    const Scheme scheme = make_refinable_scheme(text);
    VectorQuestion question{.integral = scheme.integral};
    if (component >= 0) question.component = component;
    const Certificate certificate = field_certificate(
        *scheme.quadratic, vector_regularity(*scheme.quadratic, {Deadline::in(60)}, question));
    CHECK(proves_exactly(asked(certificate), certificate));
    CHECK(abs(*parse_rational(*certificate.claim.lower) - lower) < Rational(1, 500));
    CHECK(abs(*parse_rational(*certificate.claim.upper) - upper) < Rational(1, 500));
    CHECK_FALSE(proves(subject_of(certificate), *certificate.claim.lower, "", certificate.text()));
  }
}

TEST_CASE("certificates of matrices with a square root: of one function of random ones") {
  Random random;
  for ([[maybe_unused]] const auto round : rounds(6)) {
    std::vector<std::string> entries;
    for (int k = 0; k < 8; ++k)
      entries.push_back(random.chance(40) ? "0"
                                          : std::to_string(random.integer(-3, 3)) + "/10+" +
                                                std::to_string(random.integer(0, 2)) + "/20*sqrt(3)");
    const Scheme scheme = make_refinable_scheme(beside_hat(entries));
    CAPTURE(scheme.specification);
    if (!scheme.quadratic) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const MultivariateRegularity found = vector_regularity(*scheme.quadratic, {Deadline::in(20)}, {.component = c});
      if (!found.exponent.lower || *found.exponent.lower <= 0 || !found.vector->proof) continue;
      const Certificate certificate = field_certificate(*scheme.quadratic, found);
      const std::string subject = subject_of(certificate) + " --component " + std::to_string(c);
      const std::string upper = certificate.claim.upper.value_or("");
      CHECK(proves(subject, *certificate.claim.lower, upper, certificate.text()));
      CHECK_FALSE(proves(subject, to_text(*parse_rational(*certificate.claim.lower) + Rational(1, 1000)), "",
                         certificate.text()));
    }
  }
}

namespace {

/// The functions (phi_1 + sqrt(root) phi_2, phi_2) of a rational mask of two.
QuadraticMask mixed_with_root(const LatticeMask& mask, long root) {
  std::vector<QuadraticTerm> terms;
  for (const LatticeMask::Term& term : mask.terms()) {
    const Rational& x = term.coefficient;
    const auto add = [&](std::size_t row, std::size_t column, const Rational& rational, const Rational& multiple) {
      terms.push_back({term.exponents, row, column, rational, multiple});
    };
    add(term.row, term.column, x, 0);
    if (term.row == 1) add(0, term.column, 0, x);
    if (term.column == 0) add(term.row, 1, 0, -x);
    if (term.row == 1 && term.column == 0) add(0, 1, -root * x, 0);
  }
  return quadratic_mask(terms, 2, root, mask.dilation());
}

bool proves_scheme(const Certificate& certificate) {
  const auto& subject = std::get<MaskSubject>(certificate.claim.subject);
  return proves("--" + subject.of_matrices + " '" + subject.mask + "' --arity " + subject.arity,
                certificate.claim.lower.value_or(""), certificate.claim.upper.value_or(""), certificate.text());
}

}  // namespace

TEST_CASE("certificates of schemes with a square root in their matrices") {
  const Budget budget{Deadline::in(60)};
  for (const char* specification : {"cl:2", "cl:3", "bat:1", "bat:2", "sa4"}) {
    CAPTURE(specification);
    const Certificate certificate = vector_scheme_certificate(*make_refinable_scheme(specification).quadratic, false,
                                                              budget);
    CHECK(certificate.claim.lower == "0");
    CHECK(proves_scheme(certificate));
  }
  // Merrien's scheme, mu = sqrt(2)/4, and mu = 2 sqrt(2) - 2 or its conjugate, of which the first is HC^1 alone
  for (const auto& [text, lower, upper] : std::vector<std::tuple<std::string, std::string, std::string>>{
           {"[[[1/2,-1/8],[1/2-sqrt(2)/8,sqrt(2)/16]],[[1,0],[0,1/2]],[[1/2,1/8],[sqrt(2)/8-1/2,sqrt(2)/16]]]@-1", "1",
            ""},
           {"[[[1/2,-1/8],[3/2-sqrt(2),sqrt(2)/2-1/2]],[[1,0],[0,1/2]],[[1/2,1/8],[sqrt(2)-3/2,sqrt(2)/2-1/2]]]@-1",
            "1", ""},
           {"[[[1/2,-1/8],[3/2+sqrt(2),-sqrt(2)/2-1/2]],[[1,0],[0,1/2]],[[1/2,1/8],[-sqrt(2)-3/2,-sqrt(2)/2-1/2]]]@-1",
            "", "1"}}) {
    CAPTURE(text);
    const Certificate certificate = vector_scheme_certificate(*make_refinable_scheme("hermite:" + text).quadratic, true,
                                                              budget);
    CHECK(certificate.claim.lower.value_or("") == lower);
    CHECK(certificate.claim.upper.value_or("") == upper);
    CHECK(proves_scheme(certificate));
  }
}

TEST_CASE("certificates of schemes that a square root mixes say what those of the rational ones do") {
  const Budget budget{Deadline::in(60)};
  for (const char* specification :
       {"bspline:degree=3,multiplicity=2", "bspline:degree=2,multiplicity=2", "ghm", "merrien:lambda=-1/8,mu=1/2",
        "vector:[[[1,0],[0,2]],[[2,0],[0,0]],[[1,0],[0,0]]]/2@-1"})
    for (const long root : {2L, 7L}) {
      CAPTURE(specification, root);
      const LatticeMask mask = make_refinable_scheme(specification).mask;
      const Certificate rational = vector_scheme_certificate(mask, false, budget),
                        mixed = vector_scheme_certificate(mixed_with_root(mask, root), false, budget);
      CHECK(mixed.claim.lower == rational.claim.lower);
      CHECK(mixed.claim.upper == rational.claim.upper);
      CHECK(proves_scheme(mixed));
    }
}

TEST_CASE("certificates of convergence in several variables, and of several constants") {
  const std::string plane =  // bilinear hat functions, and numbers that are multiplied by a quarter of C at even points
      "vector:[[[[1,0],[0,0]],[[2,0],[0,0]],[[1,0],[0,0]]],[[[2,0],[0,0]],[[4,0],[0,C]],[[2,0],[0,0]]],"
      "[[[1,0],[0,0]],[[2,0],[0,0]],[[1,0],[0,0]]]]/4@-1,-1";
  const auto with = [&](const std::string& number) {
    std::string text = plane;
    return text.replace(text.find('C'), 1, number);
  };
  for (const auto& [text, converges] : std::vector<std::pair<std::string, bool>>{
           {with("2"), true},
           {with("4"), false},
           {with("-4"), false},
           {with("5"), false},
           {with("2*sqrt(3)"), true},
           {with("sqrt(17)"), false},
           {"tensor:(ghm)x(bspline:degree=1)", true},
           {"tensor:(bspline:degree=2,multiplicity=2)x(bspline:degree=1)x(bspline:degree=1)", true},
           {"vector:[[[[1,0],[0,1]],[[2,0],[0,0]],[[1,0],[0,0]]]]/2@-1,0,dilation=[1,1;1,-1]", true},
           {"vector:[[[2,0],[0,1]],[[4,0],[0,3]],[[2,0],[0,3]],[[0,0],[0,1]]]/4@-1", true},  // two constants
           {"vector:[[[1,0],[0,1]],[[1,0],[0,1]]]/3@0", false},                              // and none
           {"vector:[[[1,0],[0,sqrt(2)]],[[1,0],[0,1]]]/3@0", false},
           {"refinable:[[[2,-sqrt(2)],[0,1]],[[4,-sqrt(2)],[0,3]],[[2,sqrt(2)],[0,3]],[[0,sqrt(2)],[0,1]]]/4@-1",
            true}}) {
    CAPTURE(text);
    const Scheme scheme = make_refinable_scheme(text);
    CHECK_FALSE(is_told_by_polynomials(scheme));
    const Certificate certificate = scheme_certificate(scheme, {Deadline::in(60)});
    CHECK(certificate.claim.lower.has_value() == converges);
    CHECK(certificate.claim.upper.has_value() != converges);
    CHECK(says_its_claim(certificate));
    const auto& named = std::get<MaskSubject>(certificate.claim.subject);
    const std::string subject = "--vectors '" + named.mask + "' --dilation '" + named.arity + "'";
    CHECK(proves(subject, converges ? "0" : "", converges ? "" : "0", certificate.text()));
    CHECK_FALSE(proves(subject, converges ? "" : "0", converges ? "0" : "", certificate.text()));
  }
  CHECK(is_told_by_polynomials(make_refinable_scheme("ghm")));
  CHECK(is_told_by_polynomials(make_refinable_scheme("hermite-dd:points=2,order=2")));
  const Scheme stretched = make_refinable_scheme("vector:[[[[1,0],[0,1]],[[1,0],[0,0]]]],dilation=[2,0;0,3]");
  CHECK_THROWS_WITH(scheme_certificate(stretched, {Deadline::in(5)}), Catch::Contains("got [2,0;0,3]"));
  CHECK_THROWS_WITH(convergence_certificate(make_refinable_scheme("tensor:(chaikin)x(chaikin)").mask, Budget{}),
                    Catch::Contains("need a vector scheme"));
}

TEST_CASE("certificates of convergence in two variables of random schemes are what the analysis says") {
  Random random;
  for ([[maybe_unused]] const auto round : rounds(12)) {
    // the class of each point keeps (1, 0); the rest is random
    std::string rows;
    for (int y = 0; y < 2; ++y) {
      rows += y == 0 ? "[" : ",[";
      for (int x = 0; x < 3; ++x) {
        const long half = x == 1 ? 2 : 1;
        rows += fmt::format("{}[[{},{}],[0,{}{}]]", x == 0 ? "" : ",", half, random.integer(-1, 1),
                            random.integer(-2, 2), random.chance(30) ? "*sqrt(2)" : "");
      }
      rows += "]";
    }
    const std::string text = "vector:[" + rows + "]/2@-1,0";
    CAPTURE(text);
    const Scheme scheme = make_refinable_scheme(text);
    const Budget budget{Deadline::in(20)};
    const Decision said = scheme.quadratic ? vector_scheme_converges(*scheme.quadratic, budget)
                                           : vector_scheme_converges(scheme.mask, budget);
    if (said.truth == Truth::unknown || is_told_by_polynomials(scheme)) continue;
    const Certificate certificate = scheme_certificate(scheme, budget);
    CHECK(certificate.claim.lower.has_value() == said.is_yes());
    const auto& named = std::get<MaskSubject>(certificate.claim.subject);
    CHECK(proves("--vectors '" + named.mask + "' --dilation '" + named.arity + "'", said.is_yes() ? "0" : "",
                 said.is_yes() ? "" : "0", certificate.text()));
  }
}

TEST_CASE("certificates of matrices with a square root: what there are none for") {
  const Scheme scheme = make_refinable_scheme("cl:2");
  const Budget budget{Deadline::in(20)};
  const auto fails = [&](const VectorQuestion& question, const char* message) {
    CHECK_THROWS_WITH(field_certificate(*scheme.quadratic, vector_regularity(*scheme.quadratic, budget, question)),
                      Catch::Contains(message));
  };
  fails({.integral = std::vector<Rational>{0, 0, 1, 1}}, "need a joint spectral radius, got none");
  const Scheme two = make_refinable_scheme("refinable:[[[2,0],[0,2]],[[4,0],[0,4]],[[2,0],[sqrt(2),2]]]/4@-1");
  CHECK_THROWS_WITH(certificate_of(two), Catch::Contains("need a continuous solution that is the only one"));
  const auto fails_as = [&](const std::string& text, bool hermite, const char* message) {
    CHECK_THROWS_WITH(vector_scheme_certificate(*make_refinable_scheme(text).quadratic, hermite, budget),
                      Catch::Contains(message));
  };
  fails_as("hermite:[[[1/2,-1/8],[sqrt(2)/2,0]],[[1,0],[0,1/2]],[[1/2,1/8],[-sqrt(2)/2,0]]]@-1", true,
           "need a Hermite scheme that keeps values and derivatives");
  fails_as("vector:[[[sqrt(2),0],[0,2]],[[1,0],[0,1]]]", false, "need a vector scheme that keeps one vector");
  fails_as("vector:[[[[1,0],[0,sqrt(2)]],[[1,0],[0,1]]],[[[1,0],[0,1]],[[1,0],[0,1]]]]", false, "of one variable");
  // discontinuous functions, as the matrices of differences have a radius of 1 or more
  const Scheme rough = make_refinable_scheme(beside_hat({"sqrt(2)", "0", "0", "1/2", "1/2", "0", "0", "1/2"}));
  CHECK_THROWS_AS(certificate_of(rough), Error);
}
