#include "checker.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>
#include <subcert/cmake/random.hpp>

using namespace subcert;
using namespace subcert::testing;

namespace {

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

TEST_CASE("equal input has equal certificates") {
  // Of the second one the search goes on with wider looks for products, and both sides take turns.
  for (const char* specification : {"primal:n=4", "dual:n=6,d=3"}) {
    const auto text = [&] {
      return exponent_certificate(make_scheme(specification).mask.curve(), regularity_of(specification)).text();
    };
    CHECK(text() == text());
  }
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

namespace {

void check_masks_nearby(const char* specification) {
  subcert::testing::Random random;
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
  for (const int round : {1, 2}) {
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

}  // namespace

TEST_CASE("rounded masks: the exponents of masks nearby are enclosed") {
  check_masks_nearby("mask:[273205,473205,126795,-73205]/400000");
}

TEST_CASE("rounded masks: the exponents of masks nearby are enclosed, of longer ones", "[long]") {
  for (const char* specification : {"primal:n=4", "daubechies:n=4"}) check_masks_nearby(specification);
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
  CHECK(regularity.radius.exact.is_yes());
  CHECK(regularity.radius.product.word == std::vector{0});
  CHECK(regularity.logarithm.at_most == 0);
  CHECK(regularity.logarithm.at_least == 0);
}

namespace {

/// What a checker is asked of all masks near a rounded one.
std::string nearby_subject(const Scheme& scheme, const std::string& distance = {}) {
  const MaskRounding& rounding = *scheme.rounding;
  return subject_of(scheme.mask.curve()) + " --within " + (distance.empty() ? to_text(rounding.distance) : distance) +
         "," + std::to_string(rounding.sum_rules) + (rounding.symmetric ? ",symmetric" : "");
}

}  // namespace

TEST_CASE("rounded masks: one product attains the radius of all masks nearby") {
  // The shorter filter of the 9/7 pair of [CDF92], the shortest coiflet, and masks whose product has one or four
  // letters.
  for (const std::string& specification :
       {std::string("mask:[-t,1-2*t,4+t,6+4*t,4+t,1-2*t,-t]/8,where=16*t^3-16*t^2+10*t-5:0.7..0.8"),
        std::string("mask:[1-t,5+t,14+2*t,14-2*t,1-t,-3+t]/16,where=t^2-7:2.6..2.7"), std::string("daubechies:n=2"),
        std::string("daubechies:n=3"), std::string("daubechies:n=5"), std::string("daubechies:n=6"),
        std::string("daubechies:n=9"), std::string("daubechies:n=10")}) {
    CAPTURE(specification);
    const Scheme scheme = make_scheme(specification);
    const Mask& mask = scheme.mask.curve();
    const HolderRegularity regularity = holder_regularity(mask, 8, {Deadline::in(60)}, HolderProof::certificate,
                                                          scheme.rounding);
    CAPTURE(regularity.radius.exact.reason);
    REQUIRE(regularity.radius.exact.is_yes());
    const Enclosure& exponent = regularity.exponent;
    CHECK(*exponent.upper - *exponent.lower < power(Rational(2), -155));
    const Certificate certificate = exponent_certificate(mask, regularity, scheme.rounding);
    REQUIRE(certificate.claim.attains);
    const std::string attains = " --attains " + *certificate.claim.attains, subject = nearby_subject(scheme);
    CHECK(certificate.claim.logarithm == 0);
    CHECK(proves(subject + attains + " --logarithm 0", *certificate.claim.lower, *certificate.claim.upper,
                 certificate.text()));
    CHECK(proves(subject + attains, "", "", certificate.text()));
    CHECK_FALSE(proves(subject + attains + ",0", "", "", certificate.text()));
    CHECK_FALSE(proves(subject + attains + " --logarithm 1", "", "", certificate.text()));
    CHECK_FALSE(proves(nearby_subject(scheme, "1/10") + attains, "", "", certificate.text()));
    CHECK(proves(subject, *certificate.claim.lower, *certificate.claim.upper, certificate.of_bounds().text()));
  }
}

TEST_CASE("rounded masks: what one product attains is what the masks nearby have") {
  subcert::testing::Random random;
  int exact = 0;
  for (int round = 0; round < 12; ++round) {
    // sum rules of order 2 or 3, and a factor with 2 to 5 coefficients of sum 2
    const int rules = static_cast<int>(random.integer(2, 3)), length = static_cast<int>(random.integer(2, 5));
    std::vector<Rational> factor{2};
    for (int k = 1; k < length; ++k) {
      factor.push_back(Rational(random.integer(-90, 90), 60));
      factor.front() -= factor.back();
    }
    const LaurentPolynomial smooth = LaurentPolynomial({q("1/2"), q("1/2")}, 0).pow(rules);
    const Mask mask(smooth * LaurentPolynomial(factor, 0), 2);
    if (sum_rules(mask) != rules) continue;
    const MaskRounding rounding{power(Rational(10), -40), rules};
    const HolderRegularity all = holder_regularity(mask, 6, {Deadline::in(5)}, HolderProof::certificate, rounding);
    if (!all.radius.exact.is_yes()) continue;
    CAPTURE(mask.symbol().to_mask_text(), word_text(all.radius.product.word));
    ++exact;
    const JointSpectralRadius own = joint_spectral_radius(transition_matrices(divided_difference_scheme(mask, rules)),
                                                          {Deadline::in(5)});
    CHECK(*own.radius.lower <= *all.radius.radius.upper);
    CHECK(*all.radius.radius.lower <= *own.radius.upper);
    if (!(*all.exponent.lower > 0)) continue;
    const Certificate certificate = exponent_certificate(mask, all, rounding);
    if (!certificate.claim.attains) continue;  // stability is not proved
    CHECK(proves(subject_of(mask) + " --within " + to_text(rounding.distance) + "," + std::to_string(rules) +
                     " --attains " + *certificate.claim.attains,
                 *certificate.claim.lower, *certificate.claim.upper, certificate.text()));
  }
  CHECK(exact >= 6);
}
