#include "vertex.hpp"

#include "sector_map.hpp"
#include "vertices.hpp"

#include <algorithm>
#include <set>

namespace subcert_check {
namespace {

constexpr std::size_t most_points = 64, max_level = 8, max_squarings = 24;

/// The map z of the data that turn by w = exp(2 pi i/n) and are lambda times themselves, and what it proves.
class Vertex {
 public:
  Vertex(const LatticeMask& mask, const SectorRules& rules, Reader& reader, const Fields& fields,
         Arithmetic& arithmetic)
      : mask_(mask),
        rules_(rules),
        reader_(reader),
        intervals_(parse_size(fields[0], 64, 1024), arithmetic),
        arithmetic_(arithmetic),
        scale_(mpz_class(1) << parse_size(fields[1], 0, 4096)),
        levels_(parse_size(fields[2], 0, max_level)),
        first_(1, rules.valence, intervals_),
        cosine_(intervals_.cosine(1, rules.valence)) {
    lambda_ = ratio(parse_integer(fields[3]), scale_);
    radius_ = ratio(parse_integer(fields[4]), scale_);
    require(radius_ >= 0 && lambda_ - radius_ > 0 && lambda_ + radius_ < 1,
            "the subdominant eigenvalue is not between 0 and 1");
  }

  void check() {
    points_ = read_points(reader_, rules_, most_points);
    turning_ = turning(points_, rules_);
    read_values();
    show_eigenvector();
    widen();
    for (std::size_t k = 0; 2 * k <= rules_.valence; ++k) show_gap(k);
    show_regular();
  }

 private:
  void read_values() {
    const std::size_t n = turning_.size();
    const auto numbers = [&](const Fields& fields, const mpz_class& scale) {
      std::vector<Turning> result;
      for (std::size_t i = 0; i < fields.size(); i += 2)
        result.push_back({intervals_.number(ratio(parse_integer(fields[i]), scale)),
                          intervals_.number(ratio(parse_integer(fields[i + 1]), scale))});
      return result;
    };
    values_ = numbers(reader_.take("values", 2 * n, 2 * n), scale_);
    const mpz_class of_inverse = mpz_class(1) << parse_size(reader_.take("inverse", 1, 1)[0], 0, 4096);
    for (std::size_t i = 0; i < n; ++i)
      inverse_.push_back(numbers(reader_.take("row " + std::to_string(i), 2 * n, 2 * n), of_inverse));
  }

  /// What is done to data that turn by w^k, on these points.
  TurningMatrix block(std::size_t k, const Frequency& frequency, const std::vector<Point>& points) const {
    TurningMatrix matrix(points.size(), std::vector<Turning>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
      for (const SectorTerm& term : rule_at(mask_, rules_, points[i])) {
        if ((term.frequency && *term.frequency != k) || (k != 0 && rules_.is_vertex(term.at.point))) continue;
        const auto datum = std::ranges::find(points, term.at.point);
        require(datum != points.end(), "a rule of the points has data elsewhere");
        Turning& entry = matrix[i][static_cast<std::size_t>(datum - points.begin())];
        entry = entry + frequency.turned({weight_at(term, {cosine_, {0, 0}}, intervals_), {0, 0}}, term.at.turn);
      }
    return matrix;
  }

  /// For each eigenvector near the values, an eigenvalue near lambda.
  void show_eigenvector() {
    const std::size_t n = turning_.size();
    TurningMatrix matrix = block(1, first_, turning_);
    const Interval lambda = intervals_.number(lambda_);
    for (std::size_t i = 0; i < n; ++i) matrix[i][i].a = matrix[i][i].a - lambda;
    TurningMatrix column;
    for (const Turning& z : values_) column.push_back({z});
    const mpz_class off = row_norm(product(inverse_, product(matrix, column, first_), first_));
    for (std::size_t i = 0; i < n; ++i) matrix[i][0] = Turning{{0, 0}, {0, 0}} - values_[i];
    TurningMatrix rest = product(inverse_, matrix, first_);
    for (std::size_t i = 0; i < n; ++i) rest[i][i].a = rest[i][i].a - Interval{intervals_.one(), intervals_.one()};
    const mpq_class one = intervals_.one(), slope = row_norm(rest) / one;
    require(slope < 1 && off / one + radius_ * (slope + radius_ * row_norm(inverse_) / one) <= radius_,
            "no eigenvector is shown near the values");
  }

  /// From here on lambda and the values are intervals.
  void widen() {
    const Interval one{intervals_.one(), intervals_.one()};
    const Interval sine = one - intervals_.times(cosine_, cosine_);
    require(sine.low > 0, "too few bits for the angle");
    // |b| |sin|, |a| |sin| <= |a + b w|, and |sin| >= its square.
    const mpz_class by = intervals_.over(intervals_.number(radius_), sine).high;
    const Interval error{-by, by};
    const Turning both{error, error};
    for (std::size_t i = 1; i < values_.size(); ++i) values_[i] = values_[i] + both;
    eigenvalue_ = Turning{intervals_.number(lambda_), {0, 0}} + both;
    for (const Point& point : points_) known_[point] = {};  // stays so at the vertex
    for (std::size_t i = 0; i < values_.size(); ++i) known_[turning_[i]] = values_[i];
  }

  /// The other eigenvalues of this frequency are smaller than |lambda|: but for 1 of the constants, and lambda.
  void show_gap(std::size_t k) const {
    const Frequency frequency(k, rules_.valence, intervals_);
    TurningMatrix matrix = block(k, frequency, k == 0 ? points_ : turning_);
    if (k < 2) {
      const Turning one{{intervals_.one(), intervals_.one()}, {0, 0}};
      const Turning first = k == 1 ? first_.inverse(values_[0]) : one;
      for (std::size_t i = 1; i < matrix.size(); ++i) {
        const Turning part = k == 1 ? first_.times(values_[i], first) : one;
        for (std::size_t j = 1; j < matrix.size(); ++j)
          matrix[i][j] = matrix[i][j] - frequency.times(part, matrix[0][j]);
        matrix[i].erase(matrix[i].begin());
      }
      matrix.erase(matrix.begin());
      if (matrix.empty()) return;
    }
    const Interval scale = intervals_.number(1 / (lambda_ - radius_));
    for (std::vector<Turning>& row : matrix)
      for (Turning& x : row) x = frequency.scaled({scale.high, scale.high}, x);
    const mpz_class one = intervals_.one();
    for (auto [squarings, norm] = std::pair(std::size_t{0}, row_norm(matrix)); norm >= one; norm = row_norm(matrix)) {
      require(++squarings <= max_squarings && norm < one * one,
              "eigenvalues of frequency " + std::to_string(k) + " may not be below lambda");
      matrix = product(matrix, matrix, frequency);
    }
  }

  void show_regular() {
    std::optional<FitBounds> fits;
    if (reader_.at("fits")) fits = fit_bounds(mask_, parse_rational(reader_.take("fits", 1, 1)[0]), arithmetic_);
    const MapRing ring(mask_, rules_, std::move(fits));
    SectorMap map(mask_, rules_, ring, {cosine_, {0, 0}}, first_, intervals_, eigenvalue_, first_.inverse(eigenvalue_),
                  known_, {}, arithmetic_);
    require(map.is_regular(levels_), "the characteristic map is not shown to be regular and in a half plane");
  }

  const LatticeMask& mask_;
  const SectorRules& rules_;
  Reader& reader_;
  Intervals intervals_;
  Arithmetic& arithmetic_;
  mpz_class scale_;
  std::size_t levels_;
  Frequency first_;
  Interval cosine_;
  mpq_class lambda_, radius_;
  std::vector<Point> points_, turning_;  // the second without the vertex
  std::vector<Turning> values_;          // at the second
  TurningMatrix inverse_;
  Turning eigenvalue_;
  std::map<Point, Turning> known_;
};

}  // namespace

void check_vertex(const Mask& mask, const Dilation& dilation, const SectorRules& rules, Reader& reader,
                  Arithmetic& arithmetic) {
  const LatticeMask lattice = lattice_mask(mask, dilation);
  for (const auto& [k, value] : lattice.coefficients)
    require(lattice.at(rules.turned_index(k, lattice.arity)) == value, "the mask does not turn with the sectors");
  check_own_rules(rules);
  if (rules.and_above)
    check_vertices(lattice, rules, reader, arithmetic);
  else
    Vertex(lattice, rules, reader, reader.take("vertex", 5, 5), arithmetic).check();
}

}  // namespace subcert_check
