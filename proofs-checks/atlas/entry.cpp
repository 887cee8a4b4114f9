#include "entry.hpp"

#include "canonical_mask.hpp"

#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/certificates/identity.hpp>

#include <algorithm>
#include <map>

namespace subcert::atlas {
namespace {

/// Whether the values of some class of indices are one 1: shifted, the mask keeps the data.
bool is_interpolatory(const LatticeMask& mask) {
  std::vector<int> counts(static_cast<std::size_t>(mask.dilation().classes()));
  std::vector<bool> has_one(counts.size());
  for (const LatticeMask::Term& term : mask.terms()) {
    const std::size_t digit = mask.dilation().divide(term.exponents).digit;
    ++counts[digit];
    has_one[digit] = term.coefficient == 1;
  }
  for (std::size_t digit = 0; digit < counts.size(); ++digit)
    if (counts[digit] == 1 && has_one[digit]) return true;
  return false;
}

bool is_non_negative(const LatticeMask& mask) {
  return std::ranges::all_of(mask.terms(), [](const LatticeMask::Term& one) { return one.coefficient >= 0; });
}

/// Whether the mask is that of x -> -x but for a shift.
bool is_symmetric(const LatticeMask& mask) {
  const MultivariatePolynomial reversed = mask.symbol().reversed();
  LatticePoint back = mask.symbol().lowest();
  for (std::size_t k = 0; k < back.size(); ++k) back[k] -= reversed.lowest()[k];
  return reversed.shifted(back) == mask.symbol();
}

void add_curve_facts(Json& entry, const Mask& mask, int sum_rules) {
  const LaurentPolynomial ones = LaurentPolynomial::all_ones(mask.arity());
  const Symmetry kind = symmetry(mask).kind;
  entry["length"] = mask.symbol().length();
  entry["support"] = to_text(limit_support(mask).width());
  entry["symmetry"] = kind == Symmetry::odd ? "odd" : kind == Symmetry::even ? "even" : "none";
  entry["remaining_factor"] = mask.symbol().exact_quotient(ones.pow(sum_rules))->to_mask_text();
}

/// What does not depend on limits.
void add_mask_facts(Json& entry, const LatticeMask& mask) {
  const PolynomialReproduction polynomials = polynomial_reproduction(mask);
  const auto factor = mask.dilation().factor();
  entry["variables"] = mask.dimension();
  entry["arity"] = factor ? Json(*factor) : Json();
  entry["symmetric"] = is_symmetric(mask);
  entry["interpolatory"] = is_interpolatory(mask);
  entry["non_negative"] = is_non_negative(mask);
  entry["sum_rules"] = polynomials.sum_rules;
  entry["generation_degree"] = polynomials.generation_degree();
  entry["reproduction_degree"] = polynomials.reproduction_degree;
  if (mask.dimension() == 1) add_curve_facts(entry, mask.curve(), polynomials.sum_rules);
}

Json member_or_null(const Json& answer, const char* path) {
  const Json* found = sweeps::member_at(answer, path);
  return found ? *found : Json();
}

/// Whether phi has the derivative of its exponent: no where a power of a logarithm is in the modulus of continuity.
Json is_attained(const Json& logarithm) {
  const Json least = member_or_null(logarithm, "at_least"), most = member_or_null(logarithm, "at_most");
  if (least.is_number() && least > 0) return false;
  return most.is_number() && most == 0 ? Json(true) : Json();
}

/// Of a surface as `regularity` says, which says yes only.
Truth stability_of(const LatticeMask& mask, const Json& regularity) {
  if (mask.dimension() == 1) return has_stable_shifts(mask.curve()).truth;
  const Json* stable = sweeps::member_at(regularity, "stable");
  return stable && *stable == true ? Truth::yes : Truth::unknown;
}

void add_regularity(Json& entry, const LatticeMask& mask, const Json& regularity) {
  const bool has_limits = regularity.at("converges") != to_text(Truth::no);
  const auto of_limits = [&](const char* path) { return has_limits ? member_or_null(regularity, path) : Json(); };
  entry["converges"] = regularity.at("converges");
  entry["holder"] = of_limits("holder");
  entry["exact"] = of_limits("exact");
  entry["formula"] = of_limits("formula");
  entry["product"] = of_limits("product");
  entry["method"] = of_limits("method");
  entry["attained"] = is_attained(of_limits("logarithm"));
  entry["logarithm"] = of_limits("logarithm");
  entry["sobolev"] = of_limits("sobolev.exponent");
  entry["stable"] = to_text(stability_of(mask, regularity));
  entry["closed"] = !has_limits || regularity.at("closed") == true;
}

bool is_text(const Json& value) { return value.is_string(); }
bool is_text_or_null(const Json& value) { return value.is_string() || value.is_null(); }
bool is_integer_or_null(const Json& value) { return value.is_number_integer() || value.is_null(); }
bool is_boolean_or_null(const Json& value) { return value.is_boolean() || value.is_null(); }

bool has_text(const Json& value, const char* name) { return value.contains(name) && value.at(name).is_string(); }

bool is_enclosure_or_null(const Json& value) {
  return value.is_null() || (value.is_object() && has_text(value, "lower") && has_text(value, "upper"));
}

bool is_logarithm_or_null(const Json& value) {
  return value.is_null() ||
         (value.is_object() && value.contains("at_least") && value.contains("at_most") && has_text(value, "reason"));
}

/// What a member has to be, where that is less than everything.
const std::map<std::string, bool (*)(const Json&)>& kinds_of_members() {
  static const std::map<std::string, bool (*)(const Json&)> kinds = {
      {"id", is_text},
      {"mask", is_text},
      {"converges", is_text},
      {"stable", is_text},
      {"version", is_text},
      {"support", is_text_or_null},
      {"certificate", is_text_or_null},
      {"variables", [](const Json& value) { return value == 1 || value == 2; }},
      {"arity", is_integer_or_null},
      {"length", is_integer_or_null},
      {"sum_rules", [](const Json& value) { return value.is_number_integer(); }},
      {"closed", is_boolean_or_null},
      {"budget", [](const Json& value) { return value.is_number(); }},
      {"holder", is_enclosure_or_null},
      {"sobolev", is_enclosure_or_null},
      {"noise_factor", is_enclosure_or_null},
      {"logarithm", is_logarithm_or_null}};
  return kinds;
}

}  // namespace

LatticeMask mask_of_entry(const Scheme& scheme) {
  const LatticeMask& mask = scheme.mask;
  if (mask.components() != 1 || mask.dimension() > 2 || scheme.rounding || scheme.algebraic)
    fail(ErrorKind::usage, "atlas: need a mask of rational numbers in one or two variables, got {}",
         scheme.specification);
  return canonical_mask(mask);
}

Json entry_of(const LatticeMask& canonical, const sweeps::SweepPlan& plan, const Json& answers,
              const std::string& version) {
  const Json& errors = answers.at("errors");
  if (errors.contains("regularity")) throw Error(ErrorKind::undecided, errors.at("regularity").get<std::string>());
  Json entry;
  for (const Member& member : entry_members()) entry[member.name] = nullptr;
  entry.erase("names");
  entry["id"] = entry_id(canonical);
  entry["mask"] = mask_text(canonical);
  add_mask_facts(entry, canonical);
  add_regularity(entry, canonical, answers.at("answers").at("regularity"));
  const Json* variance = sweeps::member_at(answers, "answers.variance");
  entry["noise_factor"] = variance ? member_or_null(*variance, "sup") : Json();
  entry["mean_variance"] = variance ? member_or_null(*variance, "mean") : Json();
  const Json* certificate = sweeps::member_at(answers, "certificate");
  if (certificate)
    entry["certificate"] = content_id(certificate->get<std::string>());
  else
    entry["certificate"] = plan.certificates ? Json("none") : Json();
  entry["budget"] = plan.budget;
  entry["version"] = version;
  return entry;
}

const std::vector<Member>& entry_members() {
  static const std::vector<Member> members = {
      {"id", "the first 12 digits of the SHA-256 of `mask`"},
      {"mask", "the mask that stands for all with these limits up to an affine map of the lattice"},
      {"variables", "1 for curves, 2 for surfaces"},
      {"arity", "of the mask; of surfaces where the dilation is a multiple of the identity", true},
      {"length", "number of coefficients from the first to the last; of curves", true},
      {"support", "length of the support of phi; of curves", true},
      {"symmetry", "odd, even or none; of curves", true},
      {"symmetric", "whether x -> -x leaves the mask as it is but for a shift"},
      {"interpolatory", "whether a shift of the mask keeps the data"},
      {"non_negative", "whether no coefficient is negative"},
      {"sum_rules", "order of the sum rules"},
      {"generation_degree", "of polynomials that are limits"},
      {"reproduction_degree", "of polynomials that are limits of their own values"},
      {"remaining_factor", "the symbol without (1 + z + ... + z^(arity-1))^sum_rules, as a mask; of curves", true},
      {"converges", "yes, no or unknown"},
      {"holder", "Hoelder exponent"},
      {"exact", "whether a product is proved to attain the radius behind it"},
      {"formula", "the exponent in closed form; of curves", true},
      {"product", "the digits of that product"},
      {"method", "of the proof"},
      {"attained", "yes where the modulus of continuity has no logarithm; of curves", true},
      {"logarithm", "its power, and why; of curves", true},
      {"sobolev", "Sobolev exponent"},
      {"stable", "whether the integer shifts of phi are stable: yes, no or unknown"},
      {"closed", "whether nothing is left to decide of the exponent"},
      {"noise_factor", "largest variance of the limit from noise of variance 1; of curves", true},
      {"mean_variance", "its mean; of curves", true},
      {"certificate", "SHA-256 of the certificate of the exponent; none where there is none"},
      {"budget", "seconds of processor time that the answers had"},
      {"version", "of the program that answered"},
      {"names", "schemes that have this mask"}};
  return members;
}

bool is_entry(const Json& value) {
  if (!value.is_object()) return false;
  for (const Member& member : entry_members()) {
    const auto found = value.find(member.name);
    if (found == value.end()) return false;
    if (const auto kind = kinds_of_members().find(member.name); kind != kinds_of_members().end())
      if (!kind->second(*found)) return false;
  }
  return true;
}

bool is_open(const Json& entry) { return entry.at("closed") != true; }

}  // namespace subcert::atlas
