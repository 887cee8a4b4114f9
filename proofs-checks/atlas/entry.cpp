#include "entry.hpp"

#include "canonical_mask.hpp"

#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/certificates/identity.hpp>

#include <algorithm>

namespace subcert::atlas {
namespace {

/// Whether the values of some class of indices are one 1: shifted, the mask keeps the data.
bool is_interpolatory(const Mask& mask) {
  for (long residue = 0; residue < mask.arity(); ++residue) {
    const LaurentPolynomial coset = mask.symbol().coset(mask.arity(), residue);
    if (coset.length() == 1 && coset.coefficient(coset.lowest()) == 1) return true;
  }
  return false;
}

bool is_non_negative(const Mask& mask) {
  return std::ranges::all_of(mask.symbol().coefficients(), [](const Rational& one) { return one >= 0; });
}

/// What does not depend on limits.
void add_mask_facts(Json& entry, const Mask& mask) {
  const PolynomialReproduction polynomials = polynomial_reproduction(mask);
  const LaurentPolynomial ones = LaurentPolynomial::all_ones(mask.arity());
  const Symmetry kind = symmetry(mask).kind;
  entry["arity"] = mask.arity();
  entry["length"] = mask.symbol().length();
  entry["support"] = to_text(limit_support(mask).width());
  entry["symmetry"] = kind == Symmetry::odd ? "odd" : kind == Symmetry::even ? "even" : "none";
  entry["symmetric"] = kind != Symmetry::none;
  entry["interpolatory"] = is_interpolatory(mask);
  entry["non_negative"] = is_non_negative(mask);
  entry["sum_rules"] = polynomials.sum_rules;
  entry["generation_degree"] = polynomials.generation_degree();
  entry["reproduction_degree"] = polynomials.reproduction_degree;
  entry["remaining_factor"] = mask.symbol().exact_quotient(ones.pow(polynomials.sum_rules))->to_mask_text();
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

void add_regularity(Json& entry, const Mask& mask, const Json& regularity) {
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
  entry["stable"] = to_text(has_stable_shifts(mask).truth);
  entry["closed"] = !has_limits || regularity.at("closed") == true;
}

}  // namespace

Mask mask_of_entry(const Scheme& scheme) {
  const LatticeMask& mask = scheme.mask;
  if (mask.components() != 1 || mask.dimension() != 1 || scheme.rounding || scheme.algebraic)
    fail(ErrorKind::usage, "atlas: need a mask of rational numbers in one variable, got {}", scheme.specification);
  return canonical_mask(mask.curve());
}

Json entry_of(const Mask& canonical, const sweeps::SweepPlan& plan, const Json& answers, const std::string& version) {
  const Json& errors = answers.at("errors");
  if (errors.contains("regularity")) throw Error(ErrorKind::undecided, errors.at("regularity").get<std::string>());
  Json entry = {{"id", entry_id(canonical)}, {"mask", mask_text(canonical)}};
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
      {"mask", "the mask that stands for all with these limits but for a shift and a reflection"},
      {"arity", "of the mask"},
      {"length", "number of coefficients from the first to the last"},
      {"support", "length of the support of phi"},
      {"symmetry", "odd, even or none"},
      {"symmetric", "whether it is not none"},
      {"interpolatory", "whether a shift of the mask keeps the data"},
      {"non_negative", "whether no coefficient is negative"},
      {"sum_rules", "order of the sum rules"},
      {"generation_degree", "of polynomials that are limits"},
      {"reproduction_degree", "of polynomials that are limits of their own values"},
      {"remaining_factor", "the symbol without (1 + z + ... + z^(arity-1))^sum_rules, as a mask"},
      {"converges", "yes, no or unknown"},
      {"holder", "Hoelder exponent"},
      {"exact", "whether a product is proved to attain the radius behind it"},
      {"formula", "the exponent in closed form"},
      {"product", "the digits of that product"},
      {"method", "of the proof"},
      {"attained", "yes where the modulus of continuity has no logarithm"},
      {"logarithm", "its power, and why"},
      {"sobolev", "Sobolev exponent"},
      {"stable", "whether the integer shifts of phi are stable: yes, no or unknown"},
      {"closed", "whether nothing is left to decide of the exponent"},
      {"noise_factor", "largest variance of the limit from noise of variance 1"},
      {"mean_variance", "its mean"},
      {"certificate", "SHA-256 of the certificate of the exponent; none where there is none"},
      {"budget", "seconds of processor time that the answers had"},
      {"version", "of the program that answered"},
      {"names", "schemes that have this mask"}};
  return members;
}

bool is_open(const Json& entry) { return entry.at("closed") != true; }

}  // namespace subcert::atlas
