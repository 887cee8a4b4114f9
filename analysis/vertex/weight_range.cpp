#include "weight_range.hpp"

#include "characteristic_map.hpp"
#include "letter_spectrum.hpp"
#include "required_rules.hpp"

#include <subcert/analysis/symbol/polynomials/real_roots.hpp>

#include <algorithm>

namespace subcert {
namespace {

using namespace vertex;

constexpr slong weight_bits = 96;
constexpr int most_map_levels = 3;
const Rational coarsest = Rational(1) / 1000;  // share of the range, of what no eigenvalue decides

Ball smallest_of(const Ball& ball) { return -(-ball).upper_end(); }

/// How far smaller intervals help.
enum class Help { fine, coarse, none };

struct Found {
  Decision holds;
  Help help = Help::fine;
};

class WeightProof {
 public:
  WeightProof(const SectorRules& rules, const RegularPart& regular, WeightProperty property)
      : rules_(rules), regular_(regular), property_(property), set_(smallest_closed_set(rules)) {
    // Sums of weights are polynomials in the letter: what holds at more values than their degree holds at all.
    for (long value = 0; value <= letter_degree(rules); ++value) {
      const SectorRules at = with_letter_value(rules, LaurentPolynomial(Rational(value)));
      require_rules(at, with_rules_of(at, set_), regular, CosineField(rules.valence));
    }
    spectrum_.emplace(rules, set_);
  }

  Found on(const Rational& low, const Rational& high) const {
    const Ball letter = letter_on(low, high);
    if (!regular_.c1.is_yes()) return {{Truth::unknown, "the regular part is not proved to be C1"}, Help::none};
    const auto first = spectrum_->leader(1, letter);
    const Found c1 = first ? by_map(*first, letter) : refuted(letter);
    if (property_ == WeightProperty::c1 || !c1.holds.is_yes()) return c1;
    return curvature(*first, letter);
  }

  /// The end in a small interval where the answer changes.
  std::optional<WeightEnd> end_in(const Rational& low, const Rational& high) const {
    const bool squared = property_ == WeightProperty::bounded_curvature;
    const Ball letter = letter_on(low, high);
    const auto zero = spectrum_->largest(1, letter);
    if (!zero || !Ball(0, weight_bits).is_less(zero->value)) return std::nullopt;
    const auto rivals = spectrum_->rivals(*zero, squared ? zero->value * zero->value : zero->value, letter);
    if (!rivals || rivals->empty() || !by_map(*zero, letter).holds.is_yes()) return std::nullopt;
    // Behind the end the one rival leads; of curvature it is enough that one is there.
    if (!squared && (rivals->size() > 1 || !is_refuted_by(rivals->front(), letter))) return std::nullopt;
    std::optional<WeightEnd> result;
    for (const LetterZero& rival : *rivals) {
      const LetterSpectrum::Polynomial p = spectrum_->crossing(*zero, rival, squared);
      if (p.empty() || !has_one_zero(p, low, high)) return std::nullopt;
      WeightEnd end{low, high, {}, {}, {}};
      for (const CosineField::Number& coefficient : p) end.polynomial.push_back(coefficient.polynomial());
      simplify(end);
      if (result && (!end.value || end.value != result->value)) return std::nullopt;
      result = std::move(end);
    }
    if (result->value) result->holds = at(*result->value);
    return result;
  }

 private:
  static Ball letter_on(const Rational& low, const Rational& high) {
    return Ball::containing({low, high}, weight_bits);
  }

  std::optional<CharacteristicMap> map_of(const LetterZero& zero, const Ball& letter) const {
    return CharacteristicMap::find(rules_, set_, *regular_.forms, zero.frequency, zero.value,
                                   BallField(rules_.valence, letter));
  }

  Found by_map(const LetterZero& first, const Ball& letter) const {
    if (!Ball(0, weight_bits).is_less(first.value) || !first.value.is_less(Ball(1, weight_bits)))
      return {{Truth::unknown, "the subdominant eigenvalue is not proved to be positive and below 1"}};
    const auto map = map_of(first, letter);
    if (!map) return {{Truth::unknown, "no eigenvector of the subdominant eigenvalue is found"}};
    const MapProof proof = map->prove(most_map_levels);
    const Decision& deciding = proof.regular.is_yes() ? proof.half_plane : proof.regular;
    return {deciding.is_yes() ? Decision{Truth::yes, "the characteristic map is regular and injective"} : deciding,
            Help::coarse};
  }

  bool is_refuted_by(const LetterZero& leader, const Ball& letter) const {
    if (Ball(1, weight_bits).is_less(abs(leader.value))) return true;  // the data grow
    const auto map = map_of(leader, letter);
    return map && map->winds(most_map_levels);
  }

  /// By a leader of another frequency.
  Found refuted(const Ball& letter) const {
    for (long k = 0; 2 * k < rules_.valence; ++k) {
      if (k == 1) continue;
      const auto leader = spectrum_->leader(k, letter);
      if (!leader) continue;
      const std::string what = fmt::format("the subdominant eigenvalue has frequency {}", k);
      if (is_refuted_by(*leader, letter)) return {{Truth::no, what}};
      return {{Truth::unknown, what + ", and no closed curve without a zero of its map is found"}, Help::coarse};
    }
    return {{Truth::unknown, "no single real subdominant eigenvalue is proved"}};
  }

  Found curvature(const LetterZero& first, const Ball& letter) const {
    const Ball square = first.value * first.value;
    if (spectrum_->some_beyond(first, square.upper_end(), letter))
      return {{Truth::no, "an eigenvalue is above the square of the subdominant one"}};
    if (!regular_.curved)
      return {{Truth::unknown, "second derivatives of the regular part are not proved to be bounded"}, Help::none};
    if (spectrum_->others_below(first, smallest_of(square), letter))
      return {{Truth::yes, "the other eigenvalues are below the square of the subdominant one"}};
    if (const auto rivals = spectrum_->rivals(first, square, letter))
      for (const LetterZero& rival : *rivals)
        if (spectrum_->crossing(first, rival, true).empty())
          return {{Truth::unknown, "an eigenvalue is the square of the subdominant one for all values"}, Help::none};
    return {{Truth::unknown, "an eigenvalue is not told from the square of the subdominant one"}};
  }

  Ball value_of(const LetterSpectrum::Polynomial& p, const Ball& letter) const {
    const BallField field(rules_.valence, weight_bits);
    Ball value(0, weight_bits);
    for (std::size_t k = p.size(); k-- > 0;) value = value * letter + field.number(p[k].polynomial());
    return value;
  }

  /// Different signs at the ends, and a slope that is not 0 between them.
  bool has_one_zero(const LetterSpectrum::Polynomial& p, const Rational& low, const Rational& high) const {
    const Ball zero(0, weight_bits), at_low = value_of(p, Ball(low, weight_bits)),
                                     at_high = value_of(p, Ball(high, weight_bits)),
                                     slope = value_of(derivative(p, spectrum_->field()), letter_on(low, high));
    return (at_low * at_high).is_less(zero) && (zero.is_less(slope) || slope.is_less(zero));
  }

  /// The factor that has the zero, where the coefficients are rational; the value, where it is linear.
  void simplify(WeightEnd& end) const {
    const auto is_constant = [](const LaurentPolynomial& p) { return p.is_zero() || p.highest() == 0; };
    if (std::ranges::all_of(end.polynomial, is_constant)) {
      std::vector<Rational> coefficients;
      for (const LaurentPolynomial& p : end.polynomial) coefficients.push_back(p.coefficient(0));
      for (const PolynomialFactor& factor : irreducible_factors(LaurentPolynomial(coefficients, 0))) {
        if (count_real_roots(factor.polynomial, end.low, end.high) == 0) continue;
        end.polynomial.clear();
        for (long k = 0; k <= factor.polynomial.highest(); ++k)
          end.polynomial.emplace_back(factor.polynomial.coefficient(k));
        break;
      }
    }
    if (end.polynomial.size() != 2) return;
    const CosineField& field = spectrum_->field();
    end.value = (-(field.number(end.polynomial[0]) * field.number(end.polynomial[1]).inverse())).polynomial();
  }

  Decision at(const LaurentPolynomial& value) const {
    const VertexSmoothness found = vertex_smoothness(with_letter_value(rules_, value), regular_);
    if (property_ == WeightProperty::c1 || !found.c1.is_yes()) return found.c1;
    if (!found.curvature) return {Truth::unknown, "the curvature is not decided"};
    return {*found.curvature == CurvatureLimit::unbounded ? Truth::no : Truth::yes, to_text(*found.curvature)};
  }

  const SectorRules& rules_;
  const RegularPart& regular_;
  WeightProperty property_;
  ClosedSet set_;
  std::optional<LetterSpectrum> spectrum_;
};

void add(std::vector<WeightPiece>& pieces, const WeightPiece& piece) {
  if (!pieces.empty() && pieces.back().holds.truth == piece.holds.truth &&
      pieces.back().holds.reason == piece.holds.reason)
    pieces.back().high = piece.high;
  else
    pieces.push_back(piece);
}

}  // namespace

WeightRange weight_range(const SectorRules& rules, const RegularPart& regular, WeightProperty property,
                         const Rational& low, const Rational& high, const Rational& width, const Budget& budget) {
  require(low < high && width > 0, "range of a weight: need low < high and width > 0");
  const WeightProof proof(rules, regular, property);
  WeightRange result{rules.valence, {}, {}};
  const Rational coarse = (high - low) * coarsest;
  std::vector<std::pair<Rational, Rational>> open{{low, high}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    const bool in_time = !budget.deadline.expired();
    const Found found = in_time ? proof.on(from, to) : Found{{Truth::unknown, "the time is up"}, Help::none};
    const Rational least = found.help == Help::fine ? width : std::max(coarse, width);
    if (found.holds.truth != Truth::unknown || found.help == Help::none || to - from <= least) {
      add(result.pieces, {from, to, found.holds});
      continue;
    }
    const Rational middle = (from + to) / 2;
    open.emplace_back(middle, to);
    open.emplace_back(from, middle);
  }
  for (std::size_t i = 1; i + 1 < result.pieces.size(); ++i) {
    const WeightPiece &before = result.pieces[i - 1], &piece = result.pieces[i], &after = result.pieces[i + 1];
    const bool changes = before.holds.truth != after.holds.truth && before.holds.truth != Truth::unknown &&
                         after.holds.truth != Truth::unknown;
    if (piece.holds.truth != Truth::unknown || !changes) continue;
    if (auto end = proof.end_in(piece.low, piece.high)) result.ends.push_back(std::move(*end));
  }
  return result;
}

}  // namespace subcert
