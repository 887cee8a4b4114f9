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
}

TEST_CASE("no certificate where smoothness around a vertex is not proved by hulls") {
  const Made midedge("midedge", {4});
  CHECK_THROWS_AS(midedge.of(3), Error);  // a Jordan block
  CHECK_THROWS_AS(Made("butterfly", {5}), Error);
}

}  // namespace subcert::testing
