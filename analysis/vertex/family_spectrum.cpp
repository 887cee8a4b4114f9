#include "family_spectrum.hpp"

#include "diagonal_blocks.hpp"

#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <set>

namespace subcert::vertex {
namespace {

const Rational narrowest = Rational(1) / 512;  // of intervals of w

/// The smallest and the largest point of a ball, exact.
Ball lower_end(const Ball& ball) { return -(-ball).upper_end(); }

Letters letters_on(const Rational& low, const Rational& high, slong bits) {
  const Ball share = Ball::containing({low, high}, bits), cosine = cos(Ball::pi(bits) * share * 2);
  return {cosine, cosine, share};
}

slong bits_of(const Letters& at) { return at[letter_c].bits(); }

bool depends_on_c_alone(const LetterPolynomial& p) {
  return std::ranges::all_of(p.coefficients(), [](const MultivariatePolynomial& coefficient) {
    return coefficient.derivative(letter_share).is_zero() && coefficient.derivative(letter_w).is_zero();
  });
}

/// The derivative of a zero by 1/n, where p has no w.
Ball slope_of(const LetterPolynomial& p, const Ball& zero, const Letters& at) {
  const Ball pi = Ball::pi(zero.bits()), by_c = -(sin(pi * at[letter_share] * 2) * pi * 2);
  const Ball change = value_at(p.derivative_at(at, letter_c), zero) * by_c +
                      value_at(p.derivative_at(at, letter_share), zero);
  return -change / derivative_at(p.at(at), zero);
}

/// Whether two polynomials have one and the same zero in both of these balls, which hold one of each, for n ->
/// infinity.
bool share_limit(const LetterPolynomial& a, const Ball& of_a, const LetterPolynomial& b, const Ball& of_b) {
  const LaurentPolynomial first = a.limit(), second = b.limit(), common = gcd(first, second);
  const Enclosure at_first = of_a.enclosure(), at_second = of_b.enclosure();
  const Rational low = std::max(*at_first.lower, *at_second.lower), high = std::min(*at_first.upper, *at_second.upper);
  return low < high && common.length() > 1 && count_real_roots(common, low, high) == 1 &&
         count_real_roots(first, *at_first.lower, *at_first.upper) == 1 &&
         count_real_roots(second, *at_second.lower, *at_second.upper) == 1;
}

}  // namespace

FamilySpectrum::FamilySpectrum(const SectorRuleFamily& family, const ClosedSet& set) {
  std::set<long> named{0};
  for (const auto& [point, rule] : set.rules)
    for (const RingTerm& ring : rule.rings) named.insert(ring.frequency);
  named.erase(1);
  const long general = std::max(1L, *named.rbegin()) + 1;
  first_ = polynomials(family, set, 1, general);
  general_ = polynomials(family, set, general, general);
  int constants = 0;
  for (const long frequency : named)
    for (const LetterPolynomial& p : polynomials(family, set, frequency, general)) {
      const auto rest = frequency == 0 ? p.without_one() : std::nullopt;
      constants += rest ? 1 : 0;
      if (!rest || rest->degree() > 0) named_.push_back({rest ? *rest : p});
    }
  require(constants == 1, "eigenvalues at vertices: need the eigenvalue 1 once, got {} times", constants);
}

std::vector<LetterPolynomial> FamilySpectrum::polynomials(const SectorRuleFamily& family, const ClosedSet& set,
                                                          long frequency, long general) {
  // The weights are affine in 1/n: their values at two valences tell all.
  const LetterRing ring(general);
  const long many = SectorRuleFamily::many;
  const auto matrix_of = [&](long valence) {
    const SectorRules rules = family.at(valence);
    return SectorBlock<LetterRing>(rules, with_rules_of(rules, set), frequency, ring).matrix();
  };
  auto matrix = matrix_of(many);
  const auto other = matrix_of(2 * many);
  const MultivariatePolynomial share = ring.letter(letter_share);
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::size_t j = 0; j < matrix.size(); ++j) {
      const MultivariatePolynomial half = matrix[i][j] - other[i][j];  // what 1/(2 many) adds
      matrix[i][j] = other[i][j] - half + ring.number(2 * many) * half * share;
    }
  std::vector<LetterPolynomial> result;
  for (const Unknowns& block : diagonal_blocks(matrix, [](const auto& entry) { return entry.is_zero(); }))
    result.emplace_back(characteristic_polynomial(restricted(matrix, block), ring));
  return result;
}

std::optional<FamilySpectrum::Leader> FamilySpectrum::find_leader(const Letters& at, const Letters& middle) const {
  std::size_t best = 0;
  std::optional<Ball> start;
  for (std::size_t i = 0; i < first_.size(); ++i) {
    const auto zero = leading_zero(first_[i].at(middle));
    if (!zero || (start && !start->is_less(*zero))) continue;
    start = zero;
    best = i;
  }
  const auto value = start ? zero_near(first_[best].at(at), *start) : std::nullopt;
  const Ball nothing(0, bits_of(at)), one(1, bits_of(at));
  if (!value || !nothing.is_less(*value)) return std::nullopt;
  std::optional<Ball> decay;
  if (!value->is_less(one)) {
    // It may be 1 in c = 1, and grow in c.
    const LaurentPolynomial limit = first_[best].limit();
    const Ball by_c = -(value_at(first_[best].derivative_at(at, letter_c), *value) /
                        derivative_at(first_[best].at(at), *value));
    if (limit(1) != 0 || !arb_contains(value->get(), one.get()) || !arb_contains(at[letter_c].get(), one.get()) ||
        !depends_on_c_alone(first_[best]) || !nothing.is_less(by_c))
      return std::nullopt;
    decay = by_c / 2;
  }
  const Ball end = lower_end(*value);
  for (std::size_t i = 0; i < first_.size(); ++i) {
    const std::vector<Ball> p = first_[i].at(at);
    if (!has_zeros_below(i == best ? deflated(p, *value) : p, end)) return std::nullopt;
  }
  return Leader{best, *value, slope_of(first_[best], *value, at), decay};
}

/// Whether the leader grows away from the largest zero of p, which it meets for n -> infinity or is above of.
bool FamilySpectrum::is_behind(const LetterPolynomial& p, const Leader& leader, const Letters& at,
                               const Letters& middle, bool from_zero) const {
  const auto start = leading_zero(p.at(middle));
  const std::vector<Ball> values = p.at(at);
  const auto zero = start ? zero_near(values, *start) : std::nullopt;
  const Ball end = lower_end(leader.value);
  if (!zero || !(-end).is_less(*zero) || !has_zeros_below(deflated(values, *zero), end)) return false;
  if (from_zero && !share_limit(first_[leader.block], leader.value, p, *zero)) return false;
  return slope_of(p, *zero, at).is_less(leader.slope);
}

/// Whether for each w the zeros are smaller, or there is a largest one that grows in w, and equals the leader in w = c.
bool FamilySpectrum::general_is_behind(const LetterPolynomial& p, const Leader& leader, const Letters& at,
                                       const Letters& middle) const {
  const slong bits = leader.value.bits();
  const Ball end = lower_end(leader.value);
  const auto grows_on = [&](const Letters& here, const Ball& start_w) {
    Letters there = middle;
    there[letter_w] = start_w;
    const auto start = leading_zero(p.at(there));
    const std::vector<Ball> values = p.at(here);
    const auto zero = start ? zero_near(values, *start) : std::nullopt;
    return zero && Ball(0, bits).is_less(*zero) &&
           has_zeros_below(deflated(values, *zero), min(end, lower_end(*zero))) &&
           Ball(0, bits).is_less(-(value_at(p.derivative_at(here, letter_w), *zero) / derivative_at(values, *zero)));
  };
  // Those of this frequency are k = 2, ..., n/2, so that w <= cos(4 pi/n).
  const Rational last = *cos(Ball::pi(bits) * at[letter_share] * 4).enclosure().upper;
  bool grows = p.equals_with_w_as_c(first_[leader.block]);
  std::vector<std::pair<Rational, Rational>> open{{-1, grows ? *at[letter_c].enclosure().upper : last}};
  while (!open.empty()) {
    const auto [low, high] = open.back();
    open.pop_back();
    Letters here = at;
    here[letter_w] = Ball::containing({low, high}, bits);
    const Rational centre = (low + high) / 2;
    if (grows && grows_on(here, Ball(centre, bits))) continue;
    if (low >= last || has_zeros_below(p.at(here), end)) {
      grows = false;
      continue;
    }
    if (high - low < narrowest) return false;
    open.emplace_back(low, centre);
    open.emplace_back(centre, high);
  }
  return true;
}

std::optional<FamilyLeader> FamilySpectrum::leader_on(const Rational& low, const Rational& high, slong bits) {
  const Letters at = letters_on(low, high, bits);
  const Rational centre = (low + high) / 2;
  const Letters middle = letters_on(centre, centre, bits);
  const auto leader = find_leader(at, middle);
  if (!leader) return std::nullopt;
  for (const LetterPolynomial& p : general_)
    if (!general_is_behind(p, *leader, at, middle)) return std::nullopt;
  std::vector<bool> meets;
  for (const Named& named : named_) {
    meets.push_back(named.meets && is_behind(named.polynomial, *leader, at, middle, low == 0));
    if (!meets.back() && !has_zeros_below(named.polynomial.at(at), lower_end(leader->value))) return std::nullopt;
  }
  for (std::size_t i = 0; i < named_.size(); ++i) named_[i].meets = meets[i];
  return FamilyLeader{leader->value, leader->decay};
}

}  // namespace subcert::vertex
