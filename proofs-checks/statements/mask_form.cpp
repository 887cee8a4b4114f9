#include "mask_form.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <stdexcept>

namespace subcert::statements {

LaurentPolynomial assembled(const std::vector<SymbolPart>& parts, long n) {
  LaurentPolynomial symbol;
  for (const SymbolPart& part : parts)
    for (long j = part.first(n); j <= part.last(n); ++j)
      symbol += LaurentPolynomial::monomial(part.coefficient({{"n", n}, {part.index, j}}), part.exponent(j));
  return symbol;
}

Trial symbol_family(const std::vector<SymbolPart>& parts, const std::function<LaurentPolynomial(long)>& derived,
                    long first_n, long last_n) {
  Trial trial;
  for (long n = first_n; n <= last_n && !trial.failed(); ++n) {
    const LaurentPolynomial printed = assembled(parts, n), truth = derived(n);
    const long low = std::min(printed.lowest(), truth.lowest()), high = std::max(printed.highest(), truth.highest());
    for (long k = low; k <= high; ++k)
      if (!trial.equal(printed.coefficient(k), truth.coefficient(k),
                       at("n", n) + ", coefficient of z^" + std::to_string(k)))
        break;
  }
  return trial.over("n = " + std::to_string(first_n) + ".." + std::to_string(last_n));
}

Trial mask_list(const std::vector<Formula>& printed, const Mask& derived, const std::string& name) {
  std::vector<Rational> values;
  for (const Formula& entry : printed) values.push_back(entry({}));
  const LaurentPolynomial symbol(values, derived.symbol().lowest());
  Trial trial;
  if (values.size() != static_cast<std::size_t>(derived.symbol().length())) {
    std::string sums;
    for (const Rational& sum : coset_sums({symbol, derived.arity()}))
      sums += (sums.empty() ? "" : " and ") + subcert::to_text(sum);
    trial.require(false, name + ": printed " + symbol.to_mask_text() + " with " + std::to_string(values.size()) +
                             " entries, which sum to " + sums +
                             " over the residue classes where a mask needs 1; derived " +
                             derived.symbol().to_mask_text() + " with " + std::to_string(derived.symbol().length()));
    return trial;
  }
  for (std::size_t i = 0; i < values.size(); ++i)
    trial.equal(values[i], derived.symbol().coefficient(derived.symbol().lowest() + static_cast<long>(i)),
                name + ", entry " + std::to_string(i + 1));
  return trial;
}

Trial table_row(const std::vector<std::string>& printed, const std::vector<std::string>& labels,
                const std::function<Enclosure(std::size_t)>& certified) {
  require(printed.size() == labels.size(), "table_row: need as many values as labels, got {} for {}", printed.size(),
          labels.size());
  std::string failures;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const Enclosure truth = certified(i);
    if (agrees(read_decimal(printed[i]), truth) == Truth::yes) continue;
    failures += (failures.empty() ? "" : "; ") + labels[i] + ": printed " + printed[i] + ", certified " +
                truth.lower_text(8) + " ... " + truth.upper_text(8);
  }
  Trial trial;
  trial.require(failures.empty(), failures);
  return trial.over(std::to_string(printed.size()) + " cells");
}

Trial limit_supports(const Formula& lower, const Formula& upper, const std::function<Mask(long)>& mask, long first_n,
                     long last_n) {
  Trial trial;
  for (long n = first_n; n <= last_n && !trial.failed(); ++n) {
    const Interval support = limit_support(mask(n));
    trial.equal(lower({{"n", n}}), support.lower, at("n", n) + ", left end");
    trial.equal(upper({{"n", n}}), support.upper, at("n", n) + ", right end");
  }
  return trial.over("n = " + std::to_string(first_n) + ".." + std::to_string(last_n));
}

}  // namespace subcert::statements
