#include "rounding.hpp"

#include <algorithm>

namespace subcert_check {

namespace {

constexpr long kept_bits = 128;
constexpr std::size_t max_power_bits = 1UL << 28;

}  // namespace

mpq_class few_digits_up(const mpq_class& x) {
  const long shift = static_cast<long>(bits(x.get_num())) - static_cast<long>(bits(x.get_den())) - kept_bits;
  const mpz_class top = shift < 0 ? mpz_class(x.get_num() << -shift) : x.get_num(),
                  bottom = shift > 0 ? mpz_class(x.get_den() << shift) : x.get_den();
  mpz_class kept;
  mpz_cdiv_q(kept.get_mpz_t(), top.get_mpz_t(), bottom.get_mpz_t());
  return shift < 0 ? ratio(kept, mpz_class(1) << -shift) : mpq_class(mpz_class(kept << shift));
}

Rounding parse_rounding(std::string_view text) {
  const Fields fields = split(text, ",");
  require(fields.size() == 2, "a rounding is EPS,M with EPS > 0 and the number M of sum rules");
  Rounding rounding{parse_rational(fields[0]), parse_size(fields[1], 1, 500)};
  require(rounding.distance > 0, "a rounding is EPS,M with EPS > 0 and the number M of sum rules");
  return rounding;
}

mpq_class entry_error(const Mask& mask, unsigned arity, const Rounding& rounding) {
  // (1 + z + ...) ((1 + z) / (1 - z^arity))^M
  Vector factors(mask.points(), 1);
  for (std::size_t round = 0; round < rounding.sum_rules; ++round) {
    for (std::size_t i = factors.size(); i-- > 1;) factors[i] += factors[i - 1];
    for (std::size_t i = arity; i < factors.size(); ++i) factors[i] += factors[i - arity];
  }
  return rounding.distance * power(arity, rounding.sum_rules) * *std::max_element(factors.begin(), factors.end());
}

mpq_class change_of_product(const mpq_class& norm, const mpq_class& error, std::size_t factors) {
  if (factors == 0) return 0;
  const mpq_class base = few_digits_up(norm + error);
  require((bits(base.get_num()) + bits(base.get_den())) * factors <= max_power_bits, too_much_work);
  return few_digits_up(few_digits_up(power(base, factors - 1)) * few_digits_up(error) * mpz_class(factors));
}

mpq_class largest_column_sum(const Family& family) {
  mpz_class largest = 0;
  for (std::size_t k = 0; k < family.count() * family.size; ++k) {
    mpz_class sum = 0;
    for (std::size_t i = 0; i < family.size; ++i) sum += abs(family.entries[k * family.size + i]);
    largest = std::max(largest, sum);
  }
  return ratio(largest, family.denominator);
}

}  // namespace subcert_check
