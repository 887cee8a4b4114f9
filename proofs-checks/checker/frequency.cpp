#include "frequency.hpp"

#include "circle.hpp"

#include <algorithm>

namespace subcert_check {
namespace {

constexpr std::size_t most_shells = 1000, most_cells = 4096, most_parts = 1 << 20, most_terms = 64;

mpz_class modulus_above(const CirclePoint& p) { return sqrt(mpz_class(p.re * p.re + p.im * p.im)) + 1; }
mpz_class above(const mpz_class& x, const mpz_class& y) { return ceiling(ratio(x, y)); }

/// D b(z), D the least denominator of b: its bounds on arcs, times W.
class SymbolOnCircle {
 public:
  SymbolOnCircle(const Family& family, std::size_t terms, std::size_t bits, Arithmetic& arithmetic)
      : circle_(bits), arithmetic_(arithmetic), denominator_(family.denominator) {
    Vector c;
    for (std::size_t i = 0; i < family.count() * family.size; ++i)
      c.push_back(family.matrix(i % family.count())[i / family.count()]);
    while (c.back() == 0) c.pop_back();
    mpz_class common = denominator_;
    for (const mpz_class& x : c) common = gcd(common, x);
    for (mpz_class& x : c) x /= common;
    denominator_ /= common;
    const std::size_t degree = c.size() - 1;
    for (std::size_t l = 0; l <= terms; ++l) {
      mpz_class sum = 0;
      for (const mpz_class& x : c) sum += abs(x);
      sums_.push_back(sum);
      errors_.push_back((sum * degree) << 19);
      rows_.push_back(c);
      for (std::size_t k = 0; k <= degree; ++k) c[k] *= 2 * mpz_class(k) - degree;
    }
  }

  const mpz_class& one() const { return circle_.one(); }
  const mpz_class& denominator() const { return denominator_; }

  /// From here on around pi y, as far as pi radius.
  void expand(const mpq_class& y, const mpq_class& radius) {
    reach_ = circle_.half_angle(radius) + 3;
    const std::size_t terms = rows_.size() - 1;
    const std::vector<CirclePoint> powers = circle_.powers(y, rows_.front().size(), arithmetic_);
    points_.clear();
    for (std::size_t l = 0; l < terms; ++l) points_.push_back(combined(rows_[l], powers, arithmetic_));
    Vector sizes;
    for (std::size_t l = 0; l < terms; ++l) sizes.push_back(modulus_above(points_[l]) + errors_[l]);
    bend_ = at_reach(sizes, 2);
    for (std::size_t m : {0, 1}) rounding_[m] = at_reach(errors_, m) + 2 * terms;
    rest_ = sums_.back() * one();
    for (std::size_t l = terms; l > 0; --l) rest_ = above(rest_ * reach_, one() * l);
  }

  /// Of largest().
  std::uint64_t work() const { return 4000 + 8 * rows_.size() * (40 + words() * words()); }
  /// Above the modulus times W where the angle is within pi half of pi (y + offset).
  mpz_class largest(const mpq_class& offset, const mpq_class& half) const {
    const mpz_class t = circle_.half_angle(offset), h = circle_.half_angle(half) + 6;
    return value(0, t) + above(h * value(1, t), one()) + above(h * h * bend_, 2 * one() * one()) + rest_;
  }

 private:
  std::size_t words() const { return bits(one()) / 64 + 2; }

  /// The sum of x_(l + from) reach^l/l!, rounded up.
  mpz_class at_reach(const Vector& x, std::size_t from) const {
    mpz_class sum = 0;
    for (std::size_t l = points_.size(); l-- > from;) sum = x[l] + above(sum * reach_, one() * (l - from + 1));
    return sum;
  }

  mpz_class value(std::size_t from, const mpz_class& t) const {
    CirclePoint sum;
    for (std::size_t l = points_.size(); l-- > from;) {
      const mpz_class scale = one() * (l - from + 1), turned = -sum.im * t / scale;
      sum.im = points_[l].im + sum.re * t / scale;
      sum.re = points_[l].re + turned;
    }
    return modulus_above(sum) + rounding_[from];
  }

  Circle circle_;
  Arithmetic& arithmetic_;
  mpz_class denominator_;
  std::vector<Vector> rows_;  // times powers of the doubled distances from the middle
  Vector sums_, errors_;      // of the moduli; what the points may be off
  std::vector<CirclePoint> points_;
  mpz_class reach_, bend_, rest_, rounding_[2];
};

/// Bounds on the images of one cell.
struct Cell {
  mpz_class stay;
  std::vector<std::pair<mpz_class, std::size_t>> aliases;  // and the cells of shell 0 to which they lead
};

class Frequencies {
 public:
  Frequencies(const Family& family, const Fields& fields, Arithmetic& arithmetic)
      : arity_(family.count()),
        bound_(parse_rational(fields[1])),
        cells_(parse_size(fields[2], 1, most_cells)),
        shells_(parse_size(fields[3], 1, most_shells)),
        steps_(parse_size(fields[4], 1, most_parts)),
        group_(parse_size(fields[5], 1, most_parts)),
        symbol_{family, parse_size(fields[6], 2, most_terms), parse_size(fields[7], 64, 1024), arithmetic},
        arithmetic_(arithmetic) {
    require(power(arity_, shells_) >= mpz_class(cells_), "too few shells for so many cells");
    denominator_ = symbol_.denominator() * symbol_.one() * arity_;
  }

  const mpq_class& bound() const { return bound_; }
  std::size_t size() const { return (arity_ - 1) * cells_; }

  /// Theorem 40.
  void check(const Vector& weights) {
    const Cell end = inner();
    const mpz_class factor = bound_.get_num() * denominator_, rest = factor - end.stay * bound_.get_den();
    require(rest > 0, "the bound is not above the symbol near 0");
    Vector values(size(), from(end, 0, weights) / rest + 1);
    for (std::size_t j = shells_; j-- > 0;) {
      const std::vector<Cell> shell = images(j);
      for (std::size_t i = 0; i < size(); ++i) values[i] = from(shell[i], values[i], weights) / factor + 1;
    }
    for (std::size_t i = 0; i < size(); ++i) require(values[i] <= weights[i], "the bound is not proved by the weights");
  }

 private:
  /// What the operator makes of a cell, times the denominator of the bound.
  mpz_class from(const Cell& cell, const mpz_class& value, const Vector& weights) {
    mpz_class sum;
    arithmetic_.add_product(sum, cell.stay, value);
    for (const auto& [bound, target] : cell.aliases) arithmetic_.add_product(sum, bound, weights[target]);
    return sum * bound_.get_den();
  }

  void put(Cell& cell, std::size_t r, std::size_t part, const mpz_class& bound) const {
    const std::size_t place = 2 * r * cells_ + part, mirrored = 2 * arity_ * cells_ - 1 - place;
    if (r == 0)
      cell.stay = bound;
    else
      cell.aliases.emplace_back(bound, std::min(place, mirrored) - cells_);
  }

  Cell inner() {
    Cell result;
    const mpq_class half = mpq_class(1, 2) / power(arity_, shells_ + 1);
    for (std::size_t r = 0; r < arity_; ++r) {
      symbol_.expand(ratio(2 * r, arity_) + half, half);
      put(result, r, 0, symbol_.largest(0, half));
    }
    return result;
  }

  /// The images of the cells of shell j.
  std::vector<Cell> images(std::size_t j) {
    const mpz_class shrink = power(arity_, j).get_num(), parts = above(steps_, shrink);
    const std::size_t steps = parts.get_ui(), count = size() * steps;
    const mpz_class wide = group_ * shrink * steps / steps_;
    const std::size_t group = wide >= count ? count : std::max<std::size_t>(1, wide.get_ui());
    const mpq_class part = ratio(1, shrink * arity_ * arity_ * cells_ * steps);
    std::vector<Cell> shell(size());
    arithmetic_.spend(arity_ * count * symbol_.work());
    for (std::size_t r = 0; r < arity_; ++r) {
      Vector largest(size());
      for (std::size_t first = 0; first < count; first += group) {
        const std::size_t last = std::min(count, first + group);
        const mpq_class radius = part * mpz_class(last - first) / 2;
        symbol_.expand(ratio(2 * r, arity_) + part * mpz_class(cells_ * steps + first) + radius, radius);
        for (std::size_t s = first; s < last; ++s) {
          const mpz_class place = 2 * mpz_class(s) + 1 - mpz_class(first) - mpz_class(last);
          mpz_class& one = largest[s / steps];
          one = std::max(one, symbol_.largest(part * place / 2, part / 2));
        }
      }
      for (std::size_t i = 0; i < size(); ++i)
        put(shell[i], r, mpz_class((cells_ + i) / (shrink * arity_)).get_ui(), largest[i]);
    }
    return shell;
  }

  std::size_t arity_;
  mpz_class denominator_;  // of bounds of the modulus over the arity
  mpq_class bound_;
  std::size_t cells_, shells_, steps_, group_;
  SymbolOnCircle symbol_;
  Arithmetic& arithmetic_;
};

}  // namespace

mpq_class read_frequency(const Family& family, const Fields& fields, Reader& reader, Arithmetic& arithmetic) {
  require(fields.size() == 8, "expected 'frequency', a bound and six numbers");
  Frequencies frequencies(family, fields, arithmetic);
  require(frequencies.bound() > 0, "the bound of a radius is not positive");
  Vector weights;
  for (const std::string_view field : reader.take("weights", frequencies.size(), frequencies.size()))
    weights.push_back(parse_integer(field));
  require(std::all_of(weights.begin(), weights.end(), [](const mpz_class& x) { return x > 0; }),
          "a weight is not positive");
  frequencies.check(weights);
  return frequencies.bound();
}

}  // namespace subcert_check
