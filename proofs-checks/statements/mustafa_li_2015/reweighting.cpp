#include "reweighting.hpp"

namespace subcert::statements {
namespace {}  // namespace

Trial weights_of_modulus(const Formula& bracket, const Rational& exponent, const Formula& residual,
                         const std::vector<Variable>& names) {
  // h = B^e and w = B^-e, so that h' = e B^(e-1) B' equals t w if B' = 2t and e = 1/2; B is quadratic in f.
  Trial trial = identity(bracket.replaced("f", f("f + 1")) - bracket.replaced("f", f("f - 1")), f("4") * residual,
                         names);
  trial.follow(identity(bracket - residual * residual, f("delta"), names));
  trial.equal(exponent, Rational(1, 2), "exponent");
  return trial.for_all("all residuals and delta > 0", "h'(t) = t w with h(t) = (t^2 + delta)^(1/2), w = 1/h(t)");
}

Trial entries_of_normal_equations(const std::vector<Formula>& terms, const std::vector<std::string>& expected) {
  Trial trial;
  for (std::size_t k = 0; k < terms.size(); ++k)
    trial.follow(identity(terms[k], f(expected[k]), {{"r", 1}, {"s", 2}, {"w", 3}, {"f", 5}}));
  return trial.for_all("all n and all weights", "term by term the entries of the normal equations");
}

Trial summation_range(const Formula& first, const Formula& last, bool even) {
  Trial trial = identity(first + last, f(even ? "1" : "0"), {{"n", 1}});
  trial.follow(identity(last - first + f("1"), f(even ? "2*n" : "2*n + 1"), {{"n", 1}}));
  return trial;
}

}  // namespace subcert::statements
