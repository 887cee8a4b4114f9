#include "vertex_stencils.hpp"

#include "diagonal_blocks.hpp"
#include "kernel_vector.hpp"
#include "sector_block.hpp"

#include <subcert/analysis/symbol/matrices/ball_solvers.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <numeric>
#include <type_traits>

namespace subcert {
namespace {

using namespace vertex;

constexpr long most_degree = 24, most_denominator = 64;

Ball inverse_of(const Ball& x) { return 1 / x; }
CosineField::Number inverse_of(const CosineField::Number& x) { return x.inverse(); }
bool is_exactly_zero(const Ball& x) { return arb_is_zero(x.get()) != 0; }
bool is_exactly_zero(const CosineField::Number& x) { return x.is_zero(); }

/// a + b i sin(2 pi/n).
template <class Field>
struct Complex {
  using Number = typename Field::Number;
  Number a, b;

  friend Complex operator+(const Complex& p, const Complex& q) { return {p.a + q.a, p.b + q.b}; }
  friend Complex operator-(const Complex& p, const Complex& q) { return {p.a - q.a, p.b - q.b}; }
  friend Complex operator*(const Number& factor, const Complex& p) { return {factor * p.a, factor * p.b}; }
};

/// Weights of single data from a linear form m of the unknowns of a block.
template <class Field>
class Weights {
 public:
  using Number = typename Field::Number;
  using Block = SectorBlock<Field>;
  using Map = std::map<SectorPoint, Complex<Field>>;

  Weights(const SectorRules& rules, const Block& block, const Field& field)
      : rules_(rules),
        block_(block),
        field_(field),
        c_(field.cosine(1)),
        share_(field.number(LaurentPolynomial(Rational(1, rules.valence)))) {}

  /// Of frequency 0.
  Map of_means(const std::vector<std::size_t>& unknowns, const std::vector<Number>& form) {
    Map sum;
    const Complex<Field> one{field_.number(1), field_.number(0)};
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      const LatticePoint& point = block_.unknown(unknowns[i]).point;
      if (rules_.lattice != SectorLattice::dual && point == LatticePoint{0, 0})
        sum.emplace(SectorPoint{point}, form[i] * one);
      else
        for (long t = 0; t < rules_.valence; ++t) sum.emplace(SectorPoint{point, t}, (form[i] * share_) * one);
    }
    return sum;
  }

  /// Of frequency 1: with the sums g_P of w^-t f_(P, t), each unknown as a complex linear form of the g_P.
  Map of_waves(const std::vector<std::size_t>& unknowns, const std::vector<Number>& form) {
    Map sum;
    const Number zero = field_.number(0), one = field_.number(1),
                 half = field_.number(LaurentPolynomial(Rational(1, 2)));
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      const auto& [point, part] = block_.unknown(unknowns[i]);
      const SectorPoint image = mirror_image(point, rules_);
      using Part = typename Block::Part;
      if (part == Part::alone) {
        add_wave(sum, point, form[i] * Complex<Field>{one, zero}, 0);
      } else if (part == Part::with_next) {
        // 1/(1 + w) = (1 + w^-1) / (2 + 2c)
        const Number factor = form[i] * half * inverse_of(one + c_);
        add_wave(sum, point, factor * Complex<Field>{one, zero}, 0);
        add_wave(sum, point, factor * Complex<Field>{one, zero}, -1);
      } else {
        // y = (g_P - w^(turn - 1) g_image) / (w - 1/w), where w - 1/w is 2 i sin; x = g_P - y w.
        const Complex<Field> inverse{zero, form[i] * half * inverse_of(c_ * c_ - one)};
        const bool is_y = part == Part::y;
        const Complex<Field> sign = field_.number(is_y ? 1 : -1) * inverse;
        add_wave(sum, point, sign, is_y ? 0 : 1);
        add_wave(sum, image.point, field_.number(-1) * sign, image.turn - (is_y ? 1 : 0));
        if (!is_y) add_wave(sum, point, form[i] * Complex<Field>{one, zero}, 0);
      }
    }
    return sum;
  }

 private:
  Complex<Field> times(const Complex<Field>& p, const Complex<Field>& q) const {
    return {p.a * q.a + (c_ * c_ - field_.number(1)) * p.b * q.b, p.a * q.b + p.b * q.a};
  }
  /// w^k = T_k(c) + U_(k-1)(c) i sin.
  const Complex<Field>& wave(long k) {
    if (waves_.empty()) {
      Complex<Field> power{field_.number(1), field_.number(0)};
      for (long j = 0; j < rules_.valence; ++j) {
        waves_.push_back(power);
        power = times(power, {c_, field_.number(1)});
      }
    }
    return waves_[static_cast<std::size_t>((k % rules_.valence + rules_.valence) % rules_.valence)];
  }
  /// factor w^k times the sum of w^-t f_(point, t).
  void add_wave(Map& sum, const LatticePoint& point, const Complex<Field>& factor, long k) {
    for (long t = 0; t < rules_.valence; ++t) {
      const Complex<Field> weight = times(factor, wave(k - t));
      const auto [entry, is_new] = sum.try_emplace(SectorPoint{point, t}, weight);
      if (!is_new) entry->second = entry->second + weight;
    }
  }

  const SectorRules& rules_;
  const Block& block_;
  const Field& field_;
  Number c_, share_;
  std::vector<Complex<Field>> waves_;
};

/// The unknowns that one depends on, itself among them.
template <class Matrix>
std::vector<std::size_t> reached(const Matrix& matrix, std::size_t from) {
  std::vector<bool> known(matrix.size(), false);
  std::vector<std::size_t> open{from}, result;
  known[from] = true;
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    result.push_back(i);
    for (std::size_t j = 0; j < matrix.size(); ++j)
      if (!known[j] && !is_exactly_zero(matrix[i][j])) {
        known[j] = true;
        open.push_back(j);
      }
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// The transposed matrix, less a multiple of the identity.
template <class Matrix, class Number>
Matrix transposed_less(Matrix matrix, const Number& value) {
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) std::swap(matrix[i][j], matrix[j][i]);
    matrix[i][i] = matrix[i][i] - value;
  }
  return matrix;
}

/// m with m M = value m on the unknowns, the first entry that is not 0 being 1.
template <class Field>
std::optional<std::vector<typename Field::Number>> left_vector(const SectorBlock<Field>& block,
                                                               const std::vector<std::size_t>& unknowns,
                                                               const typename Field::Number& value,
                                                               const Field& field) {
  return kernel_vector(transposed_less(restricted(block.matrix(), unknowns), value), field);
}

class Stencils {
 public:
  Stencils(const SectorRules& rules, const VertexSmoothness& smoothness, int bits)
      : rules_(rules),
        smoothness_(smoothness),
        set_(smallest_closed_set(rules)),
        bits_(bits),
        balls_(rules.valence, 2 * bits) {
    if (totient(rules.valence) <= 2 * most_degree) exact_.emplace(rules.valence);
  }

  VertexStencils run() {
    VertexStencils result;
    if (exact_) result.limit = limit(*exact_);
    if (!exact_) result.limit = limit(balls_);
    if (smoothness_.frequency != 1 || !smoothness_.subdominant.is_bounded()) return result;
    if (exact_)
      if (const auto value = exact_leader()) {
        result.tangents = tangents(*exact_, *value);
        return result;
      }
    if (leader_blocks().size() == 1) result.tangents = tangents(balls_, lambda());
    return result;
  }

 private:
  Ball lambda() const { return Ball::containing(smoothness_.subdominant, balls_.bits()); }

  template <class Field>
  VertexStencils::Stencil limit(const Field& field) {
    const SectorBlock<Field> block(rules_, set_, 0, field);
    const auto unknowns = reached(block.matrix(), 0);
    auto form = left_vector(block, unknowns, field.number(1), field);
    require(form.has_value(), "stencils: need the eigenvalue 1 once");
    auto sum = field.number(0);
    for (const auto& entry : *form) sum = sum + entry;
    const auto scale = inverse_of(sum);
    for (auto& entry : *form) entry = scale * entry;
    return listed(Weights<Field>(rules_, block, field).of_means(unknowns, *form), Column::limit);
  }

  template <class Field>
  std::array<VertexStencils::Stencil, 2> tangents(const Field& field, const typename Field::Number& value) {
    const SectorBlock<Field> block(rules_, set_, 1, field);
    const std::vector<Unknowns> of_leader = leader_blocks();
    if (of_leader.empty()) return {};
    auto unknowns = reached(block.matrix(), of_leader.front().front());
    auto form = left_vector(block, unknowns, value, field);
    if constexpr (std::is_same_v<Field, CosineField>)
      if (of_leader.size() > 1) {
        unknowns = Unknowns(block.size());
        std::iota(unknowns.begin(), unknowns.end(), std::size_t{0});
        form = nilpotent_part(transposed_less(block.matrix(), value), field).last;
      }
    if (!form || form->empty()) return {};
    const auto weights = Weights<Field>(rules_, block, field).of_waves(unknowns, *form);
    return {listed(weights, Column::first), listed(weights, Column::second)};
  }

  /// The diagonal blocks that have the leader among their eigenvalues.
  std::vector<Unknowns> leader_blocks() const {
    const auto matrix = SectorBlock<BallField>(rules_, set_, 1, balls_).matrix();
    std::vector<Unknowns> result;
    for (const Unknowns& block : diagonal_blocks(matrix, [](const Ball& entry) { return is_exactly_zero(entry); })) {
      auto own = restricted(matrix, block);
      for (std::size_t i = 0; i < own.size(); ++i) own[i][i] = own[i][i] - lambda();
      if (arb_contains_zero(determinant(own, balls_.bits()).get()) != 0) result.push_back(block);
    }
    return result;
  }

  /// Where it is the only entry of its block, or a rational number of a small denominator.
  std::optional<CosineField::Number> exact_leader() const {
    const std::vector<Unknowns> blocks = leader_blocks();
    if (blocks.empty()) return std::nullopt;
    const auto own = restricted(SectorBlock<CosineField>(rules_, set_, 1, *exact_).matrix(), blocks.front());
    if (own.size() == 1) return own[0][0];
    const auto p = characteristic_polynomial(own, *exact_);
    for (long d = 1; d <= most_denominator; ++d) {
      const Rational guess = Rational(to_integer(Rational(*smoothness_.subdominant.lower * d), Rounding::nearest)) /
                             Rational(d);
      if (!smoothness_.subdominant.contains(guess)) continue;
      const CosineField::Number x = exact_->number(LaurentPolynomial(guess));
      CosineField::Number value = exact_->number(0);
      for (std::size_t i = p.size(); i-- > 0;) value = value * x + p[i];
      if (value.is_zero()) return x;
    }
    return std::nullopt;
  }

  enum class Column { limit, first, second };

  template <class Field>
  VertexStencils::Stencil listed(const std::map<SectorPoint, Complex<Field>>& weights, Column column) const {
    VertexStencils::Stencil result;
    const bool second = column == Column::second;
    for (const auto& [at, weight] : weights) {
      const auto number = second ? -weight.b : weight.a;
      if (!is_exactly_zero(number) && !(column != Column::limit && is_zero_by_symmetry(at, second)))
        result.push_back(entry(at, number, second));
    }
    return result;
  }
  /// Data mirrored at the ray (1, 0) have the conjugate l f: datum and image count the same in the first tangent, the
  /// opposite in the second. With half a turn more it is the other way round.
  bool is_zero_by_symmetry(const SectorPoint& at, bool second) const {
    const long n = rules_.valence;
    const SectorPoint image = mirror_image(at.point, rules_);
    if (image.point != at.point || (!second && n % 2 != 0)) return false;
    return (image.turn - 1 - 2 * at.turn + (second ? 0 : n / 2)) % n == 0;
  }
  StencilWeight entry(const SectorPoint& at, const CosineField::Number& number, bool second) const {
    StencilWeight result = entry(at, balls_.number(number.polynomial()), second);
    result.exact = number.polynomial();
    return result;
  }
  StencilWeight entry(const SectorPoint& at, const Ball& number, bool second) const {
    const Ball sine = sin(Ball::pi(balls_.bits()) * 2 / rules_.valence);
    return {at, (second ? number * sine : number).enclosure(bits_), std::nullopt};
  }

  const SectorRules& rules_;
  const VertexSmoothness& smoothness_;
  ClosedSet set_;
  int bits_;
  BallField balls_;
  std::optional<CosineField> exact_;
};

}  // namespace

VertexStencils vertex_stencils(const SectorRules& rules, const VertexSmoothness& smoothness, int bits) {
  require(smoothness.valence == rules.valence, "stencils: need what is said of valence {}, got {}", rules.valence,
          smoothness.valence);
  return Stencils(rules, smoothness, bits).run();
}

}  // namespace subcert
