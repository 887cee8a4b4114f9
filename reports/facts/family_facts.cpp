#include "family_facts.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>

#include <fmt/ranges.h>

namespace subcert::facts {
namespace {

constexpr long longest = 12;  // terms of a polynomial

/// `w = 1/16`, `the zeros of -1 + 4*w + 32*w^3`, or nothing where the polynomial has no real zeros; without those of
/// another polynomial.
std::vector<std::string> values_text(const LaurentPolynomial& polynomial, const LaurentPolynomial& excluded,
                                     const ParametricScheme& scheme) {
  const std::string& letter = scheme.name;
  std::vector<std::string> values;
  if (polynomial.is_zero() || polynomial.length() == 1) {
    if (!polynomial.is_zero() && polynomial.lowest() > 0) values.push_back(fmt::format("{} = 0", letter));
    return values;
  }
  for (const PolynomialFactor& factor : irreducible_factors(polynomial)) {
    const LaurentPolynomial& p = factor.polynomial;
    const auto zero = zero_of_linear(p);
    if (zero ? excluded(*zero) == 0 : excluded.exact_quotient(p).has_value()) continue;
    if (zero)
      values.push_back(fmt::format("{} = {}", letter, to_text(*zero)));
    else if (count_real_roots(p) > 0)
      values.push_back("the real zeros of " + (p.length() > longest
                                                   ? fmt::format("a polynomial of degree {}", p.highest())
                                                   : scheme.named(to_text(p, scheme.letter))));
  }
  return values;
}

}  // namespace

Facts family_facts(const ParametricScheme& scheme) {
  const ParametricMask& mask = scheme.mask;
  const std::string& w = scheme.name;
  const int rules = sum_rules(mask);
  const ParametricReproduction polynomials = polynomial_reproduction(mask);
  const ParametricMask rest_mask = divided_difference_scheme(mask, rules);
  const std::string rest = scheme.named(rest_mask.to_text(scheme.letter));
  const IndexRange support = mask.support();
  const auto end = [&](long index) { return to_text(Rational(index) / (mask.arity() - 1)); };
  const auto at = [&](const LaurentPolynomial& p) { return values_text(p, mask.denominator(), scheme); };
  const auto more = [](const std::vector<std::string>& values) {
    return values.empty() ? "" : fmt::format("; more at {}", fmt::join(values, ", "));
  };
  const LaurentPolynomial unstable = unstable_values(mask, Deadline::in(10));
  const std::vector<std::string> rules_at = at(polynomials.more_sum_rules),
                                 reproduction_at = at(polynomials.more_reproduction), unstable_at = at(unstable);
  const std::string parametrization = scheme.named(polynomials.parametrization.to_text(scheme.letter));
  return {{"family", "scheme", scheme.specification, scheme.title, scheme.specification},
          plain("mask", "mask", scheme.named(mask.to_text(scheme.letter))),
          {"", "symbol",
           fmt::format("{}^-{} ({})^{} times that of {}", mask.arity(), rules,
                       LaurentPolynomial::all_ones(mask.arity()).to_text(), rules, rest)},
          member("rest", rest),
          {"support", "support",
           fmt::format("mask {} ... {}, basic limit function [{}, {}], or less", support.first, support.last,
                       end(support.first), end(support.last)),
           "", Json::array({support.first, support.last})},
          {"sum_rules", "sum rules", fmt::format("{} for all {}{}", rules, w, more(rules_at)), "", rules},
          member("more_sum_rules", rules_at),
          {"", "polynomials",
           fmt::format("generates degree {}, reproduces degree {} with f_j at j + {} for all {}{}",
                       polynomials.generation_degree, polynomials.reproduction_degree, parametrization, w,
                       more(reproduction_at))},
          member("generates", polynomials.generation_degree),
          member("reproduces", polynomials.reproduction_degree),
          member("parametrization", parametrization),
          member("more_reproduction", reproduction_at),
          {"unstable", "stable",
           unstable.is_zero()    ? "not decided"
           : unstable_at.empty() ? fmt::format("for all {}", w)
                                 : fmt::format("but perhaps at {}", fmt::join(unstable_at, ", ")),
           "", unstable_at}};
}

}  // namespace subcert::facts
