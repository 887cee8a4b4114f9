#include "vertex.hpp"

#include "sector_map.hpp"
#include "vertices.hpp"

#include <algorithm>
#include <set>

namespace subcert_check {
namespace {

constexpr std::size_t most_points = 64, max_level = 8, max_squarings = 24;
constexpr std::int64_t max_place = 4096;  // of a square

/// The map z of the data that turn by w = exp(2 pi i k/n) and are lambda times themselves, and what it proves.
class Vertex {
 public:
  /// `fields`: BITS XBITS L0 RHO
  Vertex(const LatticeMask& mask, const SectorRules& rules, std::size_t k, Reader& reader, const Fields& fields,
         Arithmetic& arithmetic)
      : mask_(mask),
        rules_(rules),
        reader_(reader),
        intervals_(parse_size(fields[0], 64, 1024), arithmetic),
        arithmetic_(arithmetic),
        scale_(mpz_class(1) << parse_size(fields[1], 0, 4096)),
        frequency_(k, rules.valence, intervals_),
        cosine_(intervals_.cosine(1, rules.valence)) {
    lambda_ = ratio(parse_integer(fields[2]), scale_);
    radius_ = ratio(parse_integer(fields[3]), scale_);
    require(radius_ >= 0, "the radius is below 0");
  }

  /// Theorem 55, with squares cut up to `levels` times.
  void check_c1(std::size_t levels) {
    find_leader();
    require(map().is_regular(levels), "the characteristic map is not shown to be regular and in a half plane");
  }

  /// Theorem 67, or 68 where the eigenvalue is above 1 in modulus.
  void check_not_c1() {
    if (abs(lambda_) - radius_ > 1) {
      read_points_and_values();
      show_eigenvector();
      return;
    }
    require(!frequency_.is_real() || frequency_.number() == 0, "the frequency is n/2");
    find_leader();
    if (frequency_.number() != 1 && reader_.at("around")) {
      const auto radius = static_cast<std::int64_t>(parse_size(reader_.take("around", 1, 1)[0], 1, max_place));
      SectorMap leader = map();
      require_in_ring(radius);
      require(leader.has_no_zero_at(radius), "the map may be 0 on these squares");
      return;
    }
    require(frequency_.number() != 0, "a real map has no Jacobian");
    const Fields fields = reader_.take("folds", 2, 2);
    SectorMap leader = map();
    for (const bool positive : {true, false}) {
      const Point corner = parse_point(fields[positive ? 0 : 1], 2, max_place);
      require(corner[0] >= 0 && corner[1] >= 0, "a square is not one of sector 0");
      require_in_ring(std::max(corner[0], corner[1]));
      require(leader.has_jacobian(corner, positive), "the Jacobian is not shown to have both signs");
    }
  }

 private:
  /// All other eigenvalues but that of the constants are smaller.
  void find_leader() {
    require(lambda_ - radius_ > 0 && lambda_ + radius_ < 1, "the subdominant eigenvalue is not between 0 and 1");
    read_points_and_values();
    show_eigenvector();
    widen();
    for (std::size_t k = 0; 2 * k <= rules_.valence; ++k) show_gap(k);
  }

  void read_points_and_values() {
    points_ = read_points(reader_, rules_, most_points);
    turning_ = turning(points_, rules_);
    read_values();
  }

  const std::vector<Point>& points_of(std::size_t k) const { return k == 0 ? points_ : turning_; }
  const std::vector<Point>& own_points() const { return points_of(frequency_.number()); }

  void read_values() {
    const std::size_t n = own_points().size();
    const auto numbers = [&](const Fields& fields, const mpz_class& scale) {
      std::vector<Turning> result;
      for (std::size_t i = 0; i < fields.size(); i += 2) {
        const mpz_class a = parse_integer(fields[i]), b = parse_integer(fields[i + 1]);
        require(!frequency_.is_real() || b == 0, "a number of a real frequency is not real");
        result.push_back({intervals_.number(ratio(a, scale)), intervals_.number(ratio(b, scale))});
      }
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
    const std::size_t n = own_points().size();
    TurningMatrix matrix = block(frequency_.number(), frequency_, own_points());
    const Interval lambda = intervals_.number(lambda_);
    for (std::size_t i = 0; i < n; ++i) matrix[i][i].a = matrix[i][i].a - lambda;
    TurningMatrix column;
    for (const Turning& z : values_) column.push_back({z});
    const mpz_class off = row_norm(product(inverse_, product(matrix, column, frequency_), frequency_));
    for (std::size_t i = 0; i < n; ++i) matrix[i][0] = Turning{{0, 0}, {0, 0}} - values_[i];
    TurningMatrix rest = product(inverse_, matrix, frequency_);
    for (std::size_t i = 0; i < n; ++i) rest[i][i].a = rest[i][i].a - Interval{intervals_.one(), intervals_.one()};
    const mpq_class one = intervals_.one(), slope = row_norm(rest) / one;
    require(slope < 1 && off / one + radius_ * (slope + radius_ * row_norm(inverse_) / one) <= radius_,
            "no eigenvector is shown near the values");
  }

  /// From here on lambda and the values are intervals.
  void widen() {
    const Turning both = error();
    for (std::size_t i = 1; i < values_.size(); ++i) values_[i] = values_[i] + both;
    eigenvalue_ = Turning{intervals_.number(lambda_), {0, 0}} + both;
    for (const Point& point : points_) known_[point] = {};  // stays so at the vertex
    for (std::size_t i = 0; i < values_.size(); ++i) known_[own_points()[i]] = values_[i];
  }

  /// Holds all numbers of modulus at most the radius.
  Turning error() const {
    const Interval radius = intervals_.number(radius_), one{intervals_.one(), intervals_.one()};
    if (frequency_.is_real()) return {{-radius.high, radius.high}, {0, 0}};
    const Interval cosine = intervals_.cosine(frequency_.number(), rules_.valence);
    const Interval sine = one - intervals_.times(cosine, cosine);
    require(sine.low > 0, "too few bits for the angle");
    // |b| |sin|, |a| |sin| <= |a + b w|, and |sin| >= its square.
    const mpz_class by = intervals_.over(radius, sine).high;
    return {{-by, by}, {-by, by}};
  }

  /// The matrix on the quotient by a vector, in the coordinates that vanish at the first place.
  static TurningMatrix quotient(TurningMatrix matrix, const std::vector<Turning>& vector, const Frequency& frequency) {
    const Turning first = frequency.inverse(vector[0]);
    for (std::size_t i = 1; i < matrix.size(); ++i) {
      const Turning part = frequency.times(vector[i], first);
      for (std::size_t j = 1; j < matrix.size(); ++j) matrix[i][j] = matrix[i][j] - frequency.times(part, matrix[0][j]);
      matrix[i].erase(matrix[i].begin());
    }
    matrix.erase(matrix.begin());
    return matrix;
  }

  /// The other eigenvalues of this frequency are smaller than |lambda|: but for 1 of the constants, and lambda.
  void show_gap(std::size_t k) const {
    const Frequency frequency(k, rules_.valence, intervals_);
    TurningMatrix matrix = block(k, frequency, points_of(k));
    const mpz_class one = intervals_.one();
    if (k == 0)
      matrix = quotient(std::move(matrix), std::vector(matrix.size(), Turning{{one, one}, {0, 0}}), frequency);
    if (k == frequency_.number() && !matrix.empty()) {
      std::vector<Turning> vector = values_;
      if (k == 0) {
        for (Turning& z : vector) z = z - values_[0];
        vector.erase(vector.begin());
      }
      matrix = quotient(std::move(matrix), vector, frequency);
    }
    if (matrix.empty()) return;
    const Interval scale = intervals_.number(1 / (lambda_ - radius_));
    for (std::vector<Turning>& row : matrix)
      for (Turning& x : row) x = frequency.scaled({scale.high, scale.high}, x);
    for (auto [squarings, norm] = std::pair(std::size_t{0}, row_norm(matrix)); norm >= one; norm = row_norm(matrix)) {
      require(++squarings <= max_squarings && norm < one * one,
              "eigenvalues of frequency " + std::to_string(k) + " may not be below lambda");
      matrix = product(matrix, matrix, frequency);
    }
  }

  /// The map outwards, by hulls or, with their line, by fits.
  SectorMap map() {
    std::optional<FitBounds> fits;
    if (reader_.at("fits")) fits = fit_bounds(mask_, parse_rational(reader_.take("fits", 1, 1)[0]), arithmetic_);
    ring_.emplace(mask_, rules_, std::move(fits));
    return {mask_,      rules_,     *ring_,      {cosine_, {0, 0}},
            frequency_, intervals_, eigenvalue_, frequency_.inverse(eigenvalue_),
            known_,     {},         arithmetic_};
  }

  void require_in_ring(std::int64_t radius) const {
    require(radius >= ring_->first, "a square is too near to the vertex");
  }

  const LatticeMask& mask_;
  const SectorRules& rules_;
  Reader& reader_;
  Intervals intervals_;
  Arithmetic& arithmetic_;
  mpz_class scale_;
  Frequency frequency_;
  Interval cosine_;
  mpq_class lambda_, radius_;
  std::vector<Point> points_, turning_;  // the second without the vertex
  std::vector<Turning> values_;          // at the second, or at all of frequency 0
  TurningMatrix inverse_;
  Turning eigenvalue_;
  std::map<Point, Turning> known_;
  std::optional<MapRing> ring_;
};

}  // namespace

void check_vertex(const Mask& mask, const Dilation& dilation, const SectorRules& rules, bool not_c1, Reader& reader,
                  Arithmetic& arithmetic) {
  const LatticeMask lattice = lattice_mask(mask, dilation);
  for (const auto& [k, value] : lattice.coefficients)
    require(lattice.at(rules.turned_index(k, lattice.arity)) == value, "the mask does not turn with the sectors");
  check_own_rules(rules);
  if (rules.and_above) {
    check_vertices(lattice, rules, reader, arithmetic);
  } else if (not_c1) {
    const Fields fields = reader.take("not-c1", 5, 5);
    Vertex(lattice, rules, parse_size(fields[0], 0, rules.valence / 2), reader, {fields.begin() + 1, fields.end()},
           arithmetic)
        .check_not_c1();
  } else {
    const Fields fields = reader.take("vertex", 5, 5);
    Vertex vertex(lattice, rules, 1, reader, {fields[0], fields[1], fields[3], fields[4]}, arithmetic);
    vertex.check_c1(parse_size(fields[2], 0, max_level));
  }
}

}  // namespace subcert_check
