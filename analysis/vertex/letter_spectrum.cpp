#include "letter_spectrum.hpp"

#include "diagonal_blocks.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <utility>

namespace subcert::vertex {
namespace {

/// p(-x), up to a sign.
std::vector<Ball> mirror_of(std::vector<Ball> p) {
  for (std::size_t i = 0; i < p.size(); ++i)
    if ((p.size() - 1 - i) % 2 != 0) p[i] = -p[i];
  return p;
}

using Numbers = std::vector<std::vector<MultivariatePolynomial>>;

Numbers product_of(const Numbers& a, const Numbers& b) {
  const MultivariatePolynomial zero(a.front().front().variables());
  Numbers result(a.size(), std::vector<MultivariatePolynomial>(a.size(), zero));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j)
      for (std::size_t k = 0; k < a.size(); ++k)
        if (!a[i][k].is_zero() && !b[k][j].is_zero()) result[i][j] += a[i][k] * b[k][j];
  return result;
}

/// A matrix with the zeros of p, monic, as its eigenvalues.
Numbers companion(const LetterPolynomial& p) {
  const std::size_t n = p.degree();
  const int letters = p.coefficients().front().variables();
  Numbers result(n, std::vector<MultivariatePolynomial>(n, MultivariatePolynomial(letters)));
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0) result[i][i - 1] = MultivariatePolynomial(letters, Rational(1));
    result[i][n - 1] = -p.coefficients()[i];
  }
  return result;
}

/// With w as a polynomial in c.
MultivariatePolynomial with_cosine(const MultivariatePolynomial& p, long frequency) {
  MultivariatePolynomial result(p.variables());
  const LaurentPolynomial w = chebyshev(frequency);
  for (Monomial term : p.terms()) {
    const long power = std::exchange(term.exponents[letter_w], 0);
    result += MultivariatePolynomial(p.variables(), {term}) *
              MultivariatePolynomial::in_variable(p.variables(), letter_c, w.pow(power));
  }
  return result;
}

Letters middles_of(const Letters& weights) {
  Letters result;
  for (const Ball& one : weights) result.emplace_back(Rational(one.middle()), one.bits());
  return result;
}

}  // namespace

LetterSpectrum::LetterSpectrum(const SectorRules& rules, const ClosedSet& set, std::size_t letters)
    : valence_(rules.valence), letters_(letters), field_(rules.valence) {
  int constants = 0;
  for (long k = 0; 2 * k <= valence_; ++k) {
    const LetterRing ring = ring_of(k);
    const auto matrix = SectorBlock<LetterRing>(rules, set, k, ring).matrix();
    for (const Unknowns& block : diagonal_blocks(matrix, [](const auto& entry) { return entry.is_zero(); })) {
      const LetterPolynomial p(characteristic_polynomial(restricted(matrix, block), ring));
      const auto rest = k == 0 ? p.without_one() : std::nullopt;
      constants += rest ? 1 : 0;
      if (!rest || rest->degree() > 0) blocks_.push_back({k, rest ? *rest : p});
    }
  }
  require(constants == 1, "eigenvalues at a vertex: need the eigenvalue 1 once, got {} times", constants);
}

/// In the blocks of a frequency its cosine is w, from 2 on; those of 0 and 1 are polynomials in c.
LetterRing LetterSpectrum::ring_of(long frequency) const {
  return LetterRing(frequency > 1 ? frequency : -1, letters_);
}

Letters LetterSpectrum::letters_at(long frequency, const Letters& weights) const {
  const BallField field(valence_, weights.front().bits());
  Letters result{field.cosine(1), field.cosine(frequency)};
  result.insert(result.end(), weights.begin(), weights.end());
  return result;
}

std::vector<Ball> LetterSpectrum::values(const Block& block, const Letters& weights, bool mirrored) const {
  std::vector<Ball> p = block.polynomial.at(letters_at(block.frequency, weights));
  return mirrored ? mirror_of(std::move(p)) : p;
}

std::optional<LetterZero> LetterSpectrum::largest(long frequency, const Letters& weights) const {
  const Letters middle = middles_of(weights);
  std::optional<LetterZero> best;
  std::optional<Ball> start;
  bool best_is_mirrored = false;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (blocks_[i].frequency != frequency) continue;
    for (const bool mirrored : {false, true}) {
      if (mirrored && frequency != 0) continue;
      const auto zero = leading_zero(values(blocks_[i], middle, mirrored));
      if (!zero || (start && !start->is_less(*zero))) continue;
      start = zero;
      best = LetterZero{frequency, i, *zero};
      best_is_mirrored = mirrored;
    }
  }
  if (!best) return std::nullopt;
  const auto value = zero_near(values(blocks_[best->block], weights, best_is_mirrored), *start);
  if (!value || !Ball(0, weights.front().bits()).is_less(*value)) return std::nullopt;
  best->value = best_is_mirrored ? -*value : *value;
  return best;
}

bool LetterSpectrum::others_below(const LetterZero& zero, const Ball& radius, const Letters& weights) const {
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const std::vector<Ball> p = values(blocks_[i], weights, false);
    if (!has_zeros_below(i == zero.block ? deflated(p, zero.value) : p, radius)) return false;
  }
  return true;
}

std::optional<LetterZero> LetterSpectrum::leader(long frequency, const Letters& weights) const {
  auto zero = largest(frequency, weights);
  if (!zero) return std::nullopt;
  const Ball end = -(-abs(zero->value)).upper_end();
  return others_below(*zero, end, weights) ? zero : std::nullopt;
}

bool LetterSpectrum::some_beyond(const LetterZero& but, const Ball& radius, const Letters& weights) const {
  const Letters middle = middles_of(weights);
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    for (const bool mirrored : {false, true}) {
      std::vector<Ball> p = values(blocks_[i], weights, false), at = values(blocks_[i], middle, false);
      if (i == but.block) {
        p = deflated(p, but.value);
        const auto near = zero_near(at, Ball(Rational(but.value.middle()), weights.front().bits()));
        if (!near) continue;
        at = deflated(at, *near);
      }
      if (p.size() < 2) continue;
      const auto start = leading_zero(mirrored ? mirror_of(at) : at);
      const auto zero = start ? zero_near(mirrored ? mirror_of(p) : p, *start) : std::nullopt;
      if (zero && radius.is_less(*zero)) return true;
    }
  return false;
}

bool LetterSpectrum::some_above_one(const Letters& weights) const {
  const Ball one(1, weights.front().bits());
  const Letters middle = middles_of(weights);
  for (const Block& block : blocks_) {
    // The product of all zeros of a block, or a real one.
    if (one.is_less(abs(values(block, weights, false).front()))) return true;
    for (const bool mirrored : {false, true}) {
      const auto start = leading_zero(values(block, middle, mirrored));
      const auto zero = start ? zero_near(values(block, weights, mirrored), *start) : std::nullopt;
      if (zero && one.is_less(*zero)) return true;
    }
  }
  return false;
}

std::optional<std::vector<LetterZero>> LetterSpectrum::rivals(const LetterZero& zero, const Ball& radius,
                                                              const Letters& weights) const {
  const Letters middle = middles_of(weights);
  const Ball end = -(-radius).upper_end();
  std::vector<LetterZero> result;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const std::vector<Ball> p = values(blocks_[i], weights, false);
    if (has_zeros_below(i == zero.block ? deflated(p, zero.value) : p, end)) continue;
    if (i == zero.block) return std::nullopt;
    const std::size_t before = result.size();
    for (const bool mirrored : {false, true}) {
      const auto start = leading_zero(values(blocks_[i], middle, mirrored));
      const std::vector<Ball> q = values(blocks_[i], weights, mirrored);
      const auto value = start ? zero_near(q, *start) : std::nullopt;
      if (!value || !Ball(0, weights.front().bits()).is_less(*value)) continue;
      if (has_zeros_below(deflated(q, *value), min(end, -(-*value).upper_end())))
        result.push_back({blocks_[i].frequency, i, mirrored ? -*value : *value});
    }
    if (result.size() != before + 1) return std::nullopt;
  }
  return result;
}

std::map<std::vector<long>, CosineField::Number> LetterSpectrum::resultant(const LetterZero& zero,
                                                                           const LetterZero& rival,
                                                                           bool squared) const {
  const Block &own = blocks_[zero.block], &other = blocks_[rival.block];
  Numbers root = companion(own.polynomial);
  const bool is_negative = rival.value.is_less(Ball(0, rival.value.bits()));
  for (auto& row : root)
    for (auto& entry : row) entry = with_cosine(entry, own.frequency);
  if (squared) root = product_of(root, root);
  for (auto& row : root)
    for (auto& entry : row)
      if (is_negative) entry = -entry;
  // det q(M), by Horner's rule in matrices.
  const auto& q = other.polynomial.coefficients();
  const std::size_t n = root.size();
  const LetterRing ring = ring_of(1);
  Numbers value(n, std::vector<MultivariatePolynomial>(n, ring.number(0)));
  for (std::size_t k = q.size(); k-- > 0;) {
    value = product_of(value, root);
    for (std::size_t j = 0; j < n; ++j) value[j][j] += with_cosine(q[k], other.frequency);
  }
  std::map<std::vector<long>, LaurentPolynomial> sums;
  for (const Monomial& term : characteristic_polynomial(value, ring).front().terms())
    sums[{term.exponents.begin() + letter_share, term.exponents.end()}] += LaurentPolynomial::monomial(
        term.coefficient, term.exponents[letter_c]);
  std::map<std::vector<long>, CosineField::Number> result;
  for (const auto& [powers, sum] : sums)
    if (const CosineField::Number number = field_.number(sum); !number.is_zero()) result.emplace(powers, number);
  return result;
}

LetterSpectrum::Polynomial LetterSpectrum::crossing(const LetterZero& zero, const LetterZero& rival,
                                                    bool squared) const {
  Polynomial result;
  for (const auto& [powers, number] : resultant(zero, rival, squared)) {
    result.resize(static_cast<std::size_t>(powers.front()) + 1, field_.number(0));
    result.back() = number;
  }
  return result;
}

bool LetterSpectrum::coincide(const LetterZero& zero, const LetterZero& rival, bool squared) const {
  return resultant(zero, rival, squared).empty();
}

}  // namespace subcert::vertex
