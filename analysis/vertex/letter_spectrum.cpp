#include "letter_spectrum.hpp"

#include "diagonal_blocks.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert::vertex {
namespace {

/// In the blocks of a frequency its cosine is w, from 2 on; those of 0 and 1 are polynomials in c.
LetterRing ring_of(long frequency) { return LetterRing(frequency > 1 ? frequency : -1); }

/// p(-x), up to a sign.
std::vector<Ball> mirror_of(std::vector<Ball> p) {
  for (std::size_t i = 0; i < p.size(); ++i)
    if ((p.size() - 1 - i) % 2 != 0) p[i] = -p[i];
  return p;
}

using Numbers = std::vector<std::vector<MultivariatePolynomial>>;

Numbers product_of(const Numbers& a, const Numbers& b) {
  Numbers result(a.size(), std::vector<MultivariatePolynomial>(a.size(), MultivariatePolynomial(letters)));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j)
      for (std::size_t k = 0; k < a.size(); ++k)
        if (!a[i][k].is_zero() && !b[k][j].is_zero()) result[i][j] += a[i][k] * b[k][j];
  return result;
}

/// A matrix with the zeros of p, monic, as its eigenvalues.
Numbers companion(const LetterPolynomial& p) {
  const std::size_t n = p.degree();
  Numbers result(n, std::vector<MultivariatePolynomial>(n, MultivariatePolynomial(letters)));
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0) result[i][i - 1] = MultivariatePolynomial(letters, Rational(1));
    result[i][n - 1] = -p.coefficients()[i];
  }
  return result;
}

/// With w as a polynomial in c.
MultivariatePolynomial with_cosine(const MultivariatePolynomial& p, long frequency) {
  MultivariatePolynomial result(letters);
  const LaurentPolynomial w = chebyshev(frequency);
  for (const Monomial& term : p.terms())
    result += MultivariatePolynomial(letters, {{term.coefficient, {term.exponents[0], 0, term.exponents[2]}}}) *
              MultivariatePolynomial::in_variable(letters, letter_c, w.pow(term.exponents[1]));
  return result;
}

}  // namespace

LetterSpectrum::LetterSpectrum(const SectorRules& rules, const ClosedSet& set)
    : valence_(rules.valence), field_(rules.valence) {
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

Letters LetterSpectrum::letters_at(long frequency, const Ball& letter) const {
  const BallField field(valence_, letter.bits());
  return {field.cosine(1), field.cosine(frequency), letter};
}

std::vector<Ball> LetterSpectrum::values(const Block& block, const Ball& letter, bool mirrored) const {
  std::vector<Ball> p = block.polynomial.at(letters_at(block.frequency, letter));
  return mirrored ? mirror_of(std::move(p)) : p;
}

std::optional<LetterZero> LetterSpectrum::largest(long frequency, const Ball& letter) const {
  const Ball middle(Rational(letter.middle()), letter.bits());
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
  const auto value = zero_near(values(blocks_[best->block], letter, best_is_mirrored), *start);
  if (!value || !Ball(0, letter.bits()).is_less(*value)) return std::nullopt;
  best->value = best_is_mirrored ? -*value : *value;
  return best;
}

bool LetterSpectrum::others_below(const LetterZero& zero, const Ball& radius, const Ball& letter) const {
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const std::vector<Ball> p = values(blocks_[i], letter, false);
    if (!has_zeros_below(i == zero.block ? deflated(p, zero.value) : p, radius)) return false;
  }
  return true;
}

std::optional<LetterZero> LetterSpectrum::leader(long frequency, const Ball& letter) const {
  auto zero = largest(frequency, letter);
  if (!zero) return std::nullopt;
  const Ball end = -(-abs(zero->value)).upper_end();
  return others_below(*zero, end, letter) ? zero : std::nullopt;
}

bool LetterSpectrum::some_beyond(const LetterZero& but, const Ball& radius, const Ball& letter) const {
  const Ball middle(Rational(letter.middle()), letter.bits());
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    for (const bool mirrored : {false, true}) {
      std::vector<Ball> p = values(blocks_[i], letter, false), at = values(blocks_[i], middle, false);
      if (i == but.block) {
        p = deflated(p, but.value);
        const auto near = zero_near(at, Ball(Rational(but.value.middle()), letter.bits()));
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

std::optional<std::vector<LetterZero>> LetterSpectrum::rivals(const LetterZero& zero, const Ball& radius,
                                                              const Ball& letter) const {
  const Ball middle(Rational(letter.middle()), letter.bits()), end = -(-radius).upper_end();
  std::vector<LetterZero> result;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const std::vector<Ball> p = values(blocks_[i], letter, false);
    if (has_zeros_below(i == zero.block ? deflated(p, zero.value) : p, end)) continue;
    if (i == zero.block) return std::nullopt;
    const std::size_t before = result.size();
    for (const bool mirrored : {false, true}) {
      const auto start = leading_zero(values(blocks_[i], middle, mirrored));
      const std::vector<Ball> q = values(blocks_[i], letter, mirrored);
      const auto value = start ? zero_near(q, *start) : std::nullopt;
      if (!value || !Ball(0, letter.bits()).is_less(*value)) continue;
      if (has_zeros_below(deflated(q, *value), min(end, -(-*value).upper_end())))
        result.push_back({blocks_[i].frequency, i, mirrored ? -*value : *value});
    }
    if (result.size() != before + 1) return std::nullopt;
  }
  return result;
}

LetterSpectrum::Polynomial LetterSpectrum::crossing(const LetterZero& zero, const LetterZero& rival,
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
  Numbers value(n, std::vector<MultivariatePolynomial>(n, MultivariatePolynomial(letters)));
  for (std::size_t k = q.size(); k-- > 0;) {
    value = product_of(value, root);
    for (std::size_t j = 0; j < n; ++j) value[j][j] += with_cosine(q[k], other.frequency);
  }
  std::vector<LaurentPolynomial> powers;
  for (const Monomial& term : characteristic_polynomial(value, ring_of(1)).front().terms()) {
    const auto power = static_cast<std::size_t>(term.exponents[letter_share]);
    powers.resize(std::max(powers.size(), power + 1));
    powers[power] += LaurentPolynomial::monomial(term.coefficient, term.exponents[letter_c]);
  }
  Polynomial result;
  for (const LaurentPolynomial& power : powers) result.push_back(field_.number(power));
  while (!result.empty() && result.back().is_zero()) result.pop_back();
  return result;
}

}  // namespace subcert::vertex
