#include "vertex_evidence.hpp"

#include <subcert/analysis/symbol/matrices/ball_solvers.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::vertex {
namespace {

using Point = Turning<Ball>;

/// Numbers x + y w of a frequency with a real w as x alone.
class Parts {
 public:
  Parts(long frequency, const SectorRules& rules, const BallField& field)
      : sign_(frequency == 0                   ? 1
              : 2 * frequency == rules.valence ? -1
                                               : 0),
        zero_(0, field.bits()) {}

  Point of(const Point& z) const {
    return sign_ > 0 ? Point{z.x + z.y, zero_} : sign_ < 0 ? Point{z.x - z.y, zero_} : z;
  }

 private:
  int sign_;
  Ball zero_;
};

std::array<Rational, 2> middle_of(const Point& z) { return {Rational(z.x.middle()), Rational(z.y.middle())}; }

double size_of(const Point& z) { return std::abs(z.x.middle()) + std::abs(z.y.middle()); }

/// Multiplication by x + y w as a matrix of real numbers, at these places.
void put(std::vector<std::vector<Ball>>& matrix, std::size_t i, std::size_t j, const Point& z, const Ball& twice) {
  matrix[2 * i][2 * j] = z.x;
  matrix[2 * i][2 * j + 1] = -z.y;
  matrix[2 * i + 1][2 * j] = z.y;
  matrix[2 * i + 1][2 * j + 1] = z.x + twice * z.y;
}

}  // namespace

std::optional<VertexEvidence> evidence_of(const SectorRules& rules, const ClosedSet& set, const CharacteristicMap& map,
                                          long frequency, const Ball& lambda, const BallField& field, bool by_hulls) {
  VertexEvidence result;
  result.frequency = frequency;
  result.by_hulls = by_hulls;
  const Parts parts(frequency, rules, field);
  std::vector<std::pair<LatticePoint, Point>> values;
  for (const auto& [point, rule] : set.rules)
    if (frequency != 0 && rules.lattice != SectorLattice::dual && point == LatticePoint{0, 0})
      result.points.push_back(point);
    else
      values.emplace_back(point, parts.of(map.data_at(point)));
  if (values.empty()) return std::nullopt;
  // The first one is not 0; of frequency 0 the second one is another number.
  const auto put_largest = [&](std::size_t place, const Point& than) {
    const auto largest = std::max_element(
        values.begin() + static_cast<std::ptrdiff_t>(place), values.end(),
        [&](const auto& a, const auto& b) { return size_of(a.second - than) < size_of(b.second - than); });
    std::iter_swap(values.begin() + static_cast<std::ptrdiff_t>(place), largest);
  };
  put_largest(0, {Ball(0, field.bits()), Ball(0, field.bits())});
  if (frequency == 0 && values.size() > 1) put_largest(1, values[0].second);
  const std::size_t n = values.size();
  const Ball zero(0, field.bits()), scale = 1 / (abs(values[0].second.x) + abs(values[0].second.y));
  const SectorBlock<BallField> block(rules, {}, frequency, field);
  std::vector<std::vector<Ball>> derivative(2 * n, std::vector<Ball>(2 * n, zero));
  for (std::size_t j = 0; j < n; ++j) {
    values[j].second = scale * values[j].second;
    for (std::size_t i = 0; i < n; ++i) {
      const Point entry = parts.of(block.value(set.rules.at(values[i].first), [&](const LatticePoint& datum) {
        return Point{Ball(datum == values[j].first ? 1 : 0, field.bits()), zero};
      }));
      put(derivative, i, j, i == j ? entry - Point{lambda, zero} : entry, block.twice_cosine());
    }
  }
  for (std::size_t i = 0; i < n; ++i) put(derivative, i, 0, Point{zero, zero} - values[i].second, block.twice_cosine());
  result.inverse.assign(n, std::vector<std::array<Rational, 2>>(n));
  for (std::size_t j = 0; j < n; ++j) {
    std::vector<Ball> unit(2 * n, zero);
    unit[2 * j] = Ball(1, field.bits());
    const auto column = solve(derivative, unit, field.bits());
    if (!column) return std::nullopt;
    for (std::size_t i = 0; i < n; ++i) result.inverse[i][j] = middle_of({(*column)[2 * i], (*column)[2 * i + 1]});
  }
  for (const auto& [point, value] : values) {
    result.points.push_back(point);
    result.values.push_back(middle_of(value));
  }
  result.lambda = Rational(lambda.middle());
  return result;
}

}  // namespace subcert::vertex
