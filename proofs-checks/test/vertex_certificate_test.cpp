// Certificates of smoothness around vertices.

#include "checker.hpp"

#include <subcert/analysis/regularity/regularity.hpp>
#include <subcert/proofs-checks/certificates/vertex_certificate.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

namespace subcert::testing {
namespace {

struct Made {
  Made(const std::string& specification, const std::vector<long>& valences)
      : scheme(specification),
        mask(vertex_rules(scheme, valences.front()).mask),
        regular(regular_part(vertex_rules(scheme, valences.front()), {Deadline::in(60)})),
        regularity(*subcert::regularity_of(mask.without_factors(), {Deadline::in(60)}).surface) {
    for (const long n : valences) certificates.push_back(of(n));
  }
  Certificate of(long n) const {
    const SectorRules rules = vertex_rules(scheme, n);
    return vertex_certificate(rules, regularity, vertex_smoothness(rules, regular));
  }

  std::string scheme;
  LatticeMask mask;
  RegularPart regular;
  MultivariateRegularity regularity;
  std::vector<Certificate> certificates;
};

std::string subject_of(const Made& made, const std::string& rules) {
  return testing::subject_of(made.mask) + " --vertex '" + rules + "'";
}

}  // namespace

TEST_CASE("certificates of smoothness around vertices are proved by the checker, of other rules they prove nothing") {
  for (const std::string scheme : {"loop", "catmull-clark", "doo-sabin", "midedge"}) {
    const std::vector<long> valences{scheme == "midedge" ? 4 : 3, 5, 12, 50};
    const Made made(scheme, valences);
    for (std::size_t i = 0; i < valences.size(); ++i) {
      CAPTURE(scheme, valences[i]);
      const Certificate& certificate = made.certificates[i];
      const std::string rules = rules_text(vertex_rules(scheme, valences[i])),
                        others = rules_text(vertex_rules(scheme, valences[i] + 1));
      CHECK(says_its_claim(certificate));
      CHECK(proves(subject_of(made, rules), "3/2", "", certificate.text()));
      CHECK_FALSE(proves(subject_of(made, others), "3/2", "", certificate.text()));
      // The same lines, said of the other rules.
      std::string changed = certificate.text();
      changed.replace(changed.find(rules), rules.size(), others);
      CHECK_FALSE(proves(subject_of(made, others), "3/2", "", changed));
      CHECK(certificate.text().size() < 6000);
    }
  }
}

TEST_CASE("rules around vertices as claims name them") {
  CHECK(rules_text(vertex_rules("doo-sabin", 5)) == "dual:5;0,0=1/4@0,0,0|3/4@0,0~0|1/4@0,0~1");
  CHECK(rules_text(vertex_rules("catmull-clark", 4)) == "quads:4;0,0=9/16@0,0,0|3/8@1,0~0|1/16@1,1~0");
  CHECK(rules_text(vertex_rules("loop", 7)) ==
        "triangles:7;0,0=33/64+3/16*c+1/16*c^2@0,0,0|31/64-3/16*c-1/16*c^2@1,0~0");
  CHECK(rules_text(vertex_rule_family("midedge"), 13) == "dual:13+;0,0=1/2@0,0,0|1/4@0,0,1|1/4@0,0,-1");
  CHECK(rules_text(vertex_rule_family("catmull-clark"), 7) ==
        "quads:7+;0,0=1@0,0,0|-7/4/n@0,0,0|3/2/n@1,0~0|1/4/n@1,1~0");
}

TEST_CASE("one certificate of all valences from one on, which proves nothing of others or of other rules") {
  for (const std::string scheme : {"loop", "catmull-clark", "doo-sabin", "midedge"}) {
    CAPTURE(scheme);
    const Made made(scheme, {5});
    const SectorRuleFamily family = vertex_rule_family(scheme);
    const long first = 100;
    const EveryValence smoothness = every_valence(family, made.regular, first, {Deadline::in(60)});
    REQUIRE(smoothness.evidence);
    const Certificate certificate = vertex_certificate(family, made.regularity, smoothness);
    const std::string rules = rules_text(family, first), earlier = rules_text(family, first - 1);
    CHECK(says_its_claim(certificate));
    CHECK(proves(subject_of(made, rules), "3/2", "", certificate.text()));
    CHECK_FALSE(proves(subject_of(made, earlier), "3/2", "", certificate.text()));
    CHECK_FALSE(proves(subject_of(made, rules_text(vertex_rules(scheme, first))), "3/2", "", certificate.text()));
    CHECK(certificate.text().size() < 4000);
  }
}

TEST_CASE("no certificate of all valences where it is not proved, or not by hulls") {
  const Made loop("loop", {5});
  const SectorRuleFamily family = vertex_rule_family("loop");
  EveryValence open = every_valence(family, loop.regular, 13, {Deadline::in(60)});
  open.c1 = {Truth::unknown, "open"};
  CHECK_THROWS_AS(vertex_certificate(family, loop.regularity, open), Error);
  open.c1 = {Truth::yes, ""};
  open.evidence.reset();
  CHECK_THROWS_AS(vertex_certificate(family, loop.regularity, open), Error);
}

TEST_CASE("certificates by affine fits, where masks have signs, and their short proofs of the regular part") {
  const LatticeMask mask = vertex_rules("modified-butterfly", 5).mask;
  const RegularPart regular = regular_part(vertex_rules("modified-butterfly", 5), {Deadline::in(60)});
  const MultivariateRegularity regularity = regularity_around(mask, false, {Deadline::in(60)});
  for (const long valence : {5L, 20L}) {
    CAPTURE(valence);
    const SectorRules rules = vertex_rules("modified-butterfly", valence);
    const VertexSmoothness smoothness = vertex_smoothness(rules, regular);
    REQUIRE(smoothness.evidence);
    CHECK_FALSE(smoothness.evidence->by_hulls);
    const Certificate certificate = vertex_certificate(rules, regularity, smoothness);
    const std::string subject = testing::subject_of(mask) + " --vertex '";
    const std::string others = rules_text(vertex_rules("modified-butterfly", valence + 1));
    CHECK(says_its_claim(certificate));
    CHECK(proves(subject + rules_text(rules) + "'", "11/10", "", certificate.text()));
    CHECK_FALSE(proves(subject + others + "'", "11/10", "", certificate.text()));
    CHECK(certificate.text().size() < 8000);
    // Without the line of the fits, and with words that do not contract.
    for (const std::string end : {"", "fits 1/1000000\n"}) {
      std::string changed = certificate.text();
      changed.replace(changed.find("fits 3/4\n"), 9, end);
      CHECK_FALSE(proves(subject + rules_text(rules) + "'", "11/10", "", changed));
    }
  }
}

TEST_CASE("certificates of limits that are not smooth, which prove nothing of other rules, nor smoothness") {
  for (const auto& [scheme, valence] : std::vector<std::pair<std::string, long>>{{"butterfly", 8}, {"butterfly", 12}}) {
    CAPTURE(scheme, valence);
    const SectorRules rules = vertex_rules(scheme, valence);
    const RegularPart regular = regular_part(rules, {Deadline::in(60)});
    const VertexSmoothness smoothness = vertex_smoothness(rules, regular);
    REQUIRE(smoothness.c1.truth == Truth::no);
    REQUIRE(smoothness.evidence);
    CHECK(smoothness.evidence->frequency == 2);
    const Certificate certificate = vertex_certificate(rules, regularity_around(rules.mask, false, {Deadline::in(60)}),
                                                       smoothness);
    const std::string subject = testing::subject_of(rules.mask), text = certificate.text();
    CHECK(says_its_claim(certificate));
    CHECK(proves(subject + " --not-c1 '" + rules_text(rules) + "'", "11/10", "", text));
    CHECK_FALSE(proves(subject + " --vertex '" + rules_text(rules) + "'", "11/10", "", text));
    CHECK_FALSE(
        proves(subject + " --not-c1 '" + rules_text(vertex_rules(scheme, valence + 1)) + "'", "11/10", "", text));
  }
}

TEST_CASE("no certificate where smoothness around a vertex is not decided, or several eigenvalues lead") {
  const Made midedge("midedge", {4});
  CHECK_THROWS_AS(midedge.of(3), Error);           // a Jordan block
  CHECK_THROWS_AS(Made("butterfly", {3}), Error);  // refuted, with a Jordan block
}

}  // namespace subcert::testing
