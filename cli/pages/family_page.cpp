#include "family_page.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/real_roots.hpp>
#include <subcert/cli/command.hpp>

#include <fmt/format.h>

namespace subcert::cli {
namespace {

constexpr long longest = 12;  // terms of a polynomial

/// `w = 1/16`, `the zeros of -1 + 4*w + 32*w^3`, or nothing where the polynomial has no real zeros; without those of
/// another polynomial.
std::vector<std::string> values_text(const LaurentPolynomial& polynomial, const LaurentPolynomial& excluded,
                                     char letter) {
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
                                                   : to_text(p, letter)));
  }
  return values;
}

std::string joined(const std::vector<std::string>& values) { return fmt::format("{}", fmt::join(values, ", ")); }

}  // namespace

FamilyPage family_page(const ParametricScheme& scheme) {
  const ParametricMask& mask = scheme.mask;
  const char w = scheme.parameter;
  const int rules = sum_rules(mask);
  const ParametricReproduction polynomials = polynomial_reproduction(mask);
  const ParametricMask rest = divided_difference_scheme(mask, rules);
  const IndexRange support = mask.support();
  const Rational first = Rational(support.first) / (mask.arity() - 1),
                 last = Rational(support.last) / (mask.arity() - 1);
  const std::vector<std::string> rules_at = values_text(polynomials.more_sum_rules, mask.denominator(), w),
                                 reproduction_at = values_text(polynomials.more_reproduction, mask.denominator(), w);
  const LaurentPolynomial unstable = unstable_values(mask, Deadline::in(10));
  const std::vector<std::string> unstable_at = values_text(unstable, mask.denominator(), w);
  const std::string parametrization = polynomials.parametrization.to_text(w), all = fmt::format(" for all {}", w);
  std::string text;
  const auto line = [&](const char* head, const std::string& content) { text += padded(head, 14) + content + "\n"; };
  line("scheme", fmt::format("{}  ({})", scheme.specification, scheme.title));
  line("mask", mask.to_text(w));
  line("symbol", fmt::format("{}^-{} ({})^{} times that of {}", mask.arity(), rules,
                             LaurentPolynomial::all_ones(mask.arity()).to_text(), rules, rest.to_text(w)));
  line("support", fmt::format("mask {} ... {}, basic limit function [{}, {}], or less", support.first, support.last,
                              to_text(first), to_text(last)));
  line("sum rules", fmt::format("{}{}{}", rules, all, rules_at.empty() ? "" : "; more at " + joined(rules_at)));
  line("polynomials", fmt::format("generates degree {}, reproduces degree {} with f_j at j + {}{}{}",
                                  polynomials.generation_degree, polynomials.reproduction_degree, parametrization, all,
                                  reproduction_at.empty() ? "" : "; more at " + joined(reproduction_at)));
  line("stable", unstable.is_zero()    ? "not decided"
                 : unstable_at.empty() ? "for all " + std::string(1, w)
                                       : "but perhaps at " + joined(unstable_at));
  return {text,
          {{"family", scheme.specification},
           {"mask", mask.to_text(w)},
           {"rest", rest.to_text(w)},
           {"support", {support.first, support.last}},
           {"sum_rules", rules},
           {"more_sum_rules", rules_at},
           {"generates", polynomials.generation_degree},
           {"reproduces", polynomials.reproduction_degree},
           {"parametrization", parametrization},
           {"more_reproduction", reproduction_at},
           {"unstable", unstable_at}}};
}

}  // namespace subcert::cli
