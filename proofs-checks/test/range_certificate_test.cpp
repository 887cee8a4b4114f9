#include "checker.hpp"

#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/schemes/parametric_specification.hpp>

using namespace subcert;
using namespace subcert::testing;

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
        // Matrices: HC^1 and limits.
        Case{"merrien:lambda=-1/8,mu", "HC1", -5, 3, "nyn"}, Case{"merrien:lambda=-1/8,mu", "convergent", -6, 4, "nyn"},
        Case{"merrien:lambda=-1/8,mu", "holder>=5/4", -5, 3, "y"},
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
      const std::string& of_matrices = std::get<MaskSubject>(piece.certificate.claim.subject).of_matrices;
      const auto subject = [&](const Rational& low, const Rational& high) {
        return "--" + (of_matrices.empty() ? "mask" : of_matrices) + " '" + scheme.mask.to_text(scheme.letter) +
               "' --arity " + std::to_string(scheme.mask.arity()) + " --for " + scheme.letter + "=" + to_text(low) +
               ".." + to_text(high);
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
