#include "weight_proof.hpp"

#include "required_rules.hpp"

#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert::vertex {
namespace {

constexpr slong weight_bits = 96;
constexpr int most_map_levels = 3;
constexpr auto above_one = "an eigenvalue has a modulus above 1";

Ball smallest_of(const Ball& ball) { return -(-ball).upper_end(); }

Letters weights_on(const Box& box) {
  Letters result;
  for (std::size_t v = 0; v < box.letters(); ++v)
    result.push_back(Ball::containing({box.low[v], box.high[v]}, weight_bits));
  return result;
}

/// Calls visit with 0, ..., degree of each letter in all combinations.
template <class Visit>
void for_all_values(const std::vector<long>& degrees, const Visit& visit) {
  std::vector<LaurentPolynomial> values(degrees.size());
  const auto choose = [&](const auto& self, std::size_t v) -> void {
    if (v == degrees.size()) return visit(values);
    for (long value = 0; value <= degrees[v]; ++value) {
      values[v] = Rational(value);
      self(self, v + 1);
    }
  };
  choose(choose, 0);
}

}  // namespace

WeightProof::WeightProof(const SectorRules& rules, const RegularPart& regular, WeightProperty property,
                         std::size_t letters)
    : rules_(rules), regular_(regular), property_(property), set_(smallest_closed_set(rules)) {
  // Sums of weights are polynomials in the letters: what holds at more values of each than its degree holds at all.
  for_all_values(letter_degrees(rules, letters), [&](const std::vector<LaurentPolynomial>& values) {
    const SectorRules at = with_letter_values(rules, values);
    require_rules(at, with_rules_of(at, set_), regular, CosineField(rules.valence));
  });
  spectrum_.emplace(rules, set_, letters);
}

WeightProof::Found WeightProof::on(const Box& box) const {
  const Letters weights = weights_on(box);
  if (!regular_.c1.is_yes()) return {{Truth::unknown, "the regular part is not proved to be C1"}, Help::none};
  const auto first = spectrum_->leader(1, weights);
  const Found c1 = first ? by_map(*first, weights) : refuted(weights);
  if (property_ == WeightProperty::c1 || !c1.holds.is_yes()) return c1;
  return curvature(*first, weights);
}

std::optional<WeightEnd> WeightProof::end_in(const Rational& low, const Rational& high) const {
  const bool squared = property_ == WeightProperty::bounded_curvature;
  const Letters weights = weights_on({{low}, {high}});
  const auto zero = spectrum_->largest(1, weights);
  if (!zero || !Ball(0, weight_bits).is_less(zero->value)) return std::nullopt;
  const auto rivals = spectrum_->rivals(*zero, squared ? zero->value * zero->value : zero->value, weights);
  if (!rivals || rivals->empty() || !by_map(*zero, weights).holds.is_yes()) return std::nullopt;
  // Behind the end the one rival leads; of curvature it is enough that one is there.
  if (!squared && (rivals->size() > 1 || !is_refuted_by(rivals->front(), weights))) return std::nullopt;
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

std::optional<CharacteristicMap> WeightProof::map_of(const LetterZero& zero, const Letters& weights) const {
  return CharacteristicMap::find(rules_, set_, *regular_.forms, zero.frequency, zero.value,
                                 BallField(rules_.valence, weights));
}

WeightProof::Found WeightProof::by_map(const LetterZero& first, const Letters& weights) const {
  if (Ball(1, weight_bits).is_less(first.value)) return {{Truth::no, above_one}};
  if (!Ball(0, weight_bits).is_less(first.value) || !first.value.is_less(Ball(1, weight_bits)))
    return {{Truth::unknown, "the subdominant eigenvalue is not proved to be positive and below 1"}};
  const auto map = map_of(first, weights);
  if (!map) return {{Truth::unknown, "no eigenvector of the subdominant eigenvalue is found"}};
  const MapProof proof = map->prove(most_map_levels);
  const Decision& deciding = proof.regular.is_yes() ? proof.half_plane : proof.regular;
  return {deciding.is_yes() ? Decision{Truth::yes, "the characteristic map is regular and injective"} : deciding,
          Help::coarse};
}

bool WeightProof::is_refuted_by(const LetterZero& leader, const Letters& weights) const {
  if (Ball(1, weight_bits).is_less(abs(leader.value))) return true;  // points leave every bounded set
  const auto map = map_of(leader, weights);
  return map && map->winds(most_map_levels).has_value();
}

WeightProof::Found WeightProof::refuted(const Letters& weights) const {
  for (long k = 0; 2 * k < rules_.valence; ++k) {
    if (k == 1) continue;
    const auto leader = spectrum_->leader(k, weights);
    if (!leader) continue;
    const std::string what = fmt::format("the subdominant eigenvalue has frequency {}", k);
    if (is_refuted_by(*leader, weights)) return {{Truth::no, what}};
    return {{Truth::unknown, what + ", and no closed curve without a zero of its map is found"}, Help::coarse};
  }
  if (spectrum_->some_above_one(weights)) return {{Truth::no, above_one}};
  return {{Truth::unknown, "no single real subdominant eigenvalue is proved"}};
}

WeightProof::Found WeightProof::curvature(const LetterZero& first, const Letters& weights) const {
  const Ball square = first.value * first.value;
  if (spectrum_->some_beyond(first, square.upper_end(), weights))
    return {{Truth::no, "an eigenvalue is above the square of the subdominant one"}};
  if (!regular_.curved)
    return {{Truth::unknown, "second derivatives of the regular part are not proved to be bounded"}, Help::none};
  if (spectrum_->others_below(first, smallest_of(square), weights))
    return {{Truth::yes, "the other eigenvalues are below the square of the subdominant one"}};
  if (const auto rivals = spectrum_->rivals(first, square, weights))
    for (const LetterZero& rival : *rivals)
      if (spectrum_->coincide(first, rival, true))
        return {{Truth::unknown, "an eigenvalue is the square of the subdominant one for all values"}, Help::none};
  return {{Truth::unknown, "an eigenvalue is not told from the square of the subdominant one"}};
}

Ball WeightProof::value_of(const LetterSpectrum::Polynomial& p, const Ball& letter) const {
  const BallField field(rules_.valence, weight_bits);
  Ball value(0, weight_bits);
  for (std::size_t k = p.size(); k-- > 0;) value = value * letter + field.number(p[k].polynomial());
  return value;
}

bool WeightProof::has_one_zero(const LetterSpectrum::Polynomial& p, const Rational& low, const Rational& high) const {
  const Ball zero(0, weight_bits),
      at_low = value_of(p, Ball(low, weight_bits)), at_high = value_of(p, Ball(high, weight_bits)),
      slope = value_of(derivative(p, spectrum_->field()), Ball::containing({low, high}, weight_bits));
  return (at_low * at_high).is_less(zero) && (zero.is_less(slope) || slope.is_less(zero));
}

void WeightProof::simplify(WeightEnd& end) const {
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

Decision WeightProof::at(const LaurentPolynomial& value) const {
  const VertexSmoothness found = vertex_smoothness(with_letter_values(rules_, {value}), regular_);
  if (property_ == WeightProperty::c1 || !found.c1.is_yes()) return found.c1;
  if (!found.curvature) return {Truth::unknown, "the curvature is not decided"};
  return {*found.curvature == CurvatureLimit::unbounded ? Truth::no : Truth::yes, to_text(*found.curvature)};
}

std::vector<WeightBox> decide_boxes(const WeightProof& proof, const Box& range, int jobs, const Budget& budget,
                                    const std::function<bool(const Box&, WeightProof::Help)>& is_smallest) {
  std::vector<WeightBox> done;
  in_rounds(
      std::vector<Box>{range}, jobs,
      [&](const Box& box) { return budget.deadline.expired() ? std::nullopt : std::optional(proof.on(box)); },
      [&](const std::vector<Box>& open, const std::vector<std::optional<WeightProof::Found>>& found) {
        std::vector<Box> next;
        for (std::size_t k = 0; k < open.size(); ++k) {
          if (!found[k]) {
            done.push_back({open[k], {Truth::unknown, "the time is up"}, false});
            continue;
          }
          const auto& [holds, help] = *found[k];
          if (holds.truth != Truth::unknown || help == WeightProof::Help::none || is_smallest(open[k], help))
            done.push_back({open[k], holds});
          else
            for (unsigned corner = 0; corner < open[k].corners(); ++corner) next.push_back(open[k].part(corner));
        }
        return next;
      });
  return done;
}

}  // namespace subcert::vertex
