#include "vertex_certificate.hpp"

#include <subcert/analysis/regularity/regularity.hpp>
#include <subcert/analysis/symbol/numbers/numbers.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace subcert {
namespace {

constexpr int bits = 128, value_bits = 64, disc_bits = 24, row_bits = 24, most_hulls = 8, most_power = 12,
              most_halvings = 12;
constexpr long most_turn = 3;
constexpr int most_fits = 6;  // cuts of a square
constexpr const char* rate_of_fits = "3/4";
const Rational least_exponent = Rational(11) / 10;

std::string polynomial_in_c(const LaurentPolynomial& p) {
  if (p.is_zero()) return "0";
  require(p.lowest() >= 0 && p.highest() <= most_power, "certificate: need weights of degrees up to {} in c, got {}",
          most_power, p.highest());
  std::string text;
  for (long k = p.lowest(); k <= p.highest(); ++k) {
    const Rational& factor = p.coefficient(k);
    if (factor == 0) continue;
    const std::string number = to_text(factor), power = k == 0 ? "" : k == 1 ? "*c" : fmt::format("*c^{}", k);
    text += (text.empty() || factor < 0 ? "" : "+") + number + power;
  }
  return text;
}

const char* lattice_text(SectorLattice lattice) {
  return lattice == SectorLattice::triangles ? "triangles" : lattice == SectorLattice::quads ? "quads" : "dual";
}

/// Pairs over 2^digits, each number after a blank.
std::string pairs_text(const std::vector<VertexEvidence::Pair>& pairs, int digits) {
  const Rational scale = power(Rational(2), digits);
  std::string text;
  for (const VertexEvidence::Pair& pair : pairs)
    for (const Rational& number : pair) text += " " + to_integer(Rational(number * scale), Rounding::nearest).str();
  return text;
}

/// The terms of a rule; turns count from -most on, as far as there are others. `of_weight` ends each weight.
void add_terms(std::vector<std::string>& terms, const SectorRule& rule, long valence, long most,
               const char* of_weight = "") {
  for (const SectorTerm& term : rule.terms)
    terms.push_back(fmt::format("{}{}@{},{}", polynomial_in_c(term.weight), of_weight, fmt::join(term.at.point, ","),
                                term.at.turn < valence - most ? term.at.turn : term.at.turn - valence));
  for (const RingTerm& ring : rule.rings)
    terms.push_back(
        fmt::format("{}{}@{}~{}", polynomial_in_c(ring.weight), of_weight, fmt::join(ring.point, ","), ring.frequency));
}

std::string rules_text(const SectorRules& rules, const std::string& valences, long most,
                       const SectorRule& over_vertex) {
  std::string text = fmt::format("{}:{}", lattice_text(rules.lattice), valences);
  for (const auto& [point, rule] : rules.rules) {
    std::vector<std::string> terms;
    add_terms(terms, rule, rules.valence, most);
    if (point == LatticePoint{0, 0}) add_terms(terms, over_vertex, rules.valence, most, "/n");
    text += fmt::format(";{}={}", fmt::join(point, ","), fmt::join(terms, "|"));
  }
  return text;
}

/// Of the mask, with a claim about what is around these vertices.
Certificate certificate_around(const LatticeMask& mask, const std::string& rules,
                               const MultivariateRegularity& regularity, const Decision& c1, bool is_told) {
  require(c1.truth != Truth::unknown, "certificate: need smoothness that is decided, got: {}", c1.reason);
  require(is_told,
          "certificate: need what tells a checker the maps, those of all valences by hulls of differences alone");
  Certificate certificate = surface_certificate(mask, regularity);
  require(certificate.claim.lower && *parse_rational(*certificate.claim.lower) > 1,
          "certificate: need a proved exponent above 1 of the mask, got {}", certificate.claim.lower.value_or("none"));
  auto& subject = std::get<SurfaceSubject>(certificate.claim.subject);
  subject.vertex = rules;
  subject.is_c1 = c1.is_yes();
  return certificate;
}

}  // namespace

std::string rules_text(const SectorRules& rules) { return rules_text(rules, std::to_string(rules.valence), 0, {}); }

std::string rules_text(const SectorRuleFamily& family, long first) {
  return rules_text(family.rules, fmt::format("{}+", first), most_turn, family.over_vertex);
}

MultivariateRegularity regularity_around(const LatticeMask& mask, bool by_hulls, const Budget& budget) {
  const LatticeMask whole = mask.without_factors();
  if (!by_hulls)
    if (auto found = regularity_of_at_least(whole, least_exponent, budget)) return *std::move(found);
  return *regularity_of(whole, budget).surface;
}

Certificate vertex_certificate(const SectorRules& rules, const MultivariateRegularity& regularity,
                               const VertexSmoothness& smoothness) {
  Certificate certificate = certificate_around(rules.mask, rules_text(rules), regularity, smoothness.c1,
                                               smoothness.evidence != nullptr);
  const VertexEvidence& evidence = *smoothness.evidence;
  const std::string place = fmt::format(
      "{} {}", to_integer(Rational(evidence.lambda * power(Rational(2), value_bits)), Rounding::nearest).str(),
      to_integer(power(Rational(2), disc_bits), Rounding::nearest).str());
  std::string text = smoothness.c1.is_yes()
                         ? fmt::format("vertex {} {} {} {}\npoints", bits, value_bits,
                                       evidence.by_hulls ? std::min(smoothness.levels + 1, most_hulls) : most_fits,
                                       place)
                         : fmt::format("not-c1 {} {} {} {}\npoints", evidence.frequency, bits, value_bits, place);
  for (const LatticePoint& point : evidence.points) text += fmt::format(" {}", fmt::join(point, ","));
  text += fmt::format("\nvalues{}\ninverse {}\n", pairs_text(evidence.values, value_bits), row_bits);
  for (std::size_t i = 0; i < evidence.inverse.size(); ++i)
    text += fmt::format("row {}{}\n", i, pairs_text(evidence.inverse[i], row_bits));
  if (evidence.around) text += fmt::format("around {}\n", *evidence.around);
  if (!evidence.folds.empty())
    text += fmt::format("folds {} {}\n", fmt::join(evidence.folds[0], ","), fmt::join(evidence.folds[1], ","));
  const bool has_map = smoothness.c1.is_yes() || evidence.around || !evidence.folds.empty();
  if (has_map && !evidence.by_hulls) text += fmt::format("fits {}\n", rate_of_fits);
  certificate.sections.push_back({std::move(text)});
  return certificate;
}

Certificate vertex_certificate(const SectorRuleFamily& family, const MultivariateRegularity& regularity,
                               const EveryValence& smoothness) {
  Certificate certificate = certificate_around(family.rules.mask, rules_text(family, smoothness.first), regularity,
                                               smoothness.c1, smoothness.evidence.has_value());
  const Rational scale = power(Rational(2), disc_bits);
  const Rational start = Rational(to_integer(Rational(smoothness.evidence->subdominant * scale), Rounding::nearest)) /
                         scale;
  std::string text = fmt::format("vertices {} {} {}\npoints", bits, most_halvings, to_text(start));
  for (const LatticePoint& point : smoothness.evidence->points) text += fmt::format(" {}", fmt::join(point, ","));
  certificate.sections.push_back({text + "\n"});
  return certificate;
}

}  // namespace subcert
