#include "frequency_proof.hpp"

#include "positive_fixed_point.hpp"

#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>

namespace subcert {
namespace {

constexpr slong bits = 192;
constexpr double least_power = -40;  // of 10: no smaller excess is looked for

/// Bounds of |b|/A, b the symbol on the unit circle.
class SymbolBounds {
 public:
  explicit SymbolBounds(const Mask& scheme) : arity_(scheme.arity()), degree_(scheme.symbol().length() - 1) {
    const LaurentPolynomial& symbol = scheme.symbol();
    const auto size = static_cast<std::size_t>(degree_) + 1;
    for (int l = 0; l <= most_terms; ++l) {
      BallVector row(size);
      Ball sum(bits);
      for (long k = 0; k <= degree_; ++k) {
        // So many halves is the index away from the middle.
        const Rational value = symbol.coefficient(symbol.lowest() + k) * power(Rational(2 * k - degree_), l) / arity_;
        row.set(static_cast<std::size_t>(k), Ball(value, bits));
        sum += abs(Ball(value, bits));
      }
      rows_.push_back(std::move(row));
      sums_.push_back(sum);
    }
  }

  long degree() const { return degree_; }
  double sum() const { return arity_ * sums_.front().middle(); }
  /// So many that the remainder within this distance is small.
  int terms(double radius) const {
    double factor = 1;
    for (int l = 1; l < most_terms; ++l) {
      factor *= radius / 2 / l;
      if (l >= 4 && factor * sums_[static_cast<std::size_t>(l)].middle() < 1e-10) return l;
    }
    return most_terms;
  }

  /// A Taylor polynomial where the angle is pi times a number within `radius` of y.
  class Expansion {
   public:
    Expansion(const SymbolBounds& symbol, const Rational& y, const Rational& radius, int terms)
        : reach_(half_angle(radius)), bend_(bits), rest_(symbol.sums_[static_cast<std::size_t>(terms)]) {
      const std::size_t size = symbol.rows_.front().size();
      std::vector<ComplexBall> powers{ComplexBall(Ball(1, bits)), ComplexBall(bits)};
      const Ball angle = half_angle(y).scaled(1);
      arb_sin_cos(acb_imagref(powers[1].get()), acb_realref(powers[1].get()), angle.get(), bits);
      BallVector cosine(size), sine(size);
      for (std::size_t k = 0; k < size; ++k) {
        if (k > 1) powers.push_back(powers[k / 2] * powers[k - k / 2]);
        arb_set(cosine[k], acb_realref(powers[k].get()));
        arb_set(sine[k], acb_imagref(powers[k].get()));
      }
      for (int l = 0; l < terms; ++l) {
        const BallVector& row = symbol.rows_[static_cast<std::size_t>(l)];
        re_.push_back(dot(row, cosine, bits));
        im_.push_back(-dot(row, sine, bits));
      }
      for (int l = terms; l > 0; --l) rest_ = rest_ * reach_ / l;
      for (int l = terms; l-- > 2;) bend_ = modulus(re_[index(l)], im_[index(l)]) + bend_ * reach_ / (l - 1);
    }

    /// Within `half` of y + offset.
    Ball largest(const Rational& offset, const Rational& half) const {
      const Ball t = half_angle(offset), h = half_angle(half);
      return (value(0, t) + h * value(1, t) + (h * h * bend_).scaled(-1) + rest_).upper_end();
    }

   private:
    static std::size_t index(int l) { return static_cast<std::size_t>(l); }
    static Ball half_angle(const Rational& y) { return Ball::pi(bits) * Ball(Rational(y / 2), bits); }
    static Ball modulus(const Ball& x, const Ball& y) { return sqrt(x * x + y * y); }
    /// |sum of c_(l + from) (-i t)^l/l!|
    Ball value(int from, const Ball& t) const {
      Ball re(bits), im(bits);
      for (int l = static_cast<int>(re_.size()); l-- > from;) {
        const Ball step = t / (l - from + 1), x = im * step;
        im = im_[index(l)] - re * step;
        re = re_[index(l)] + x;
      }
      return modulus(re, im);
    }

    Ball reach_, bend_, rest_;
    std::vector<Ball> re_, im_;
  };

 private:
  static constexpr int most_terms = 48;
  int arity_;
  long degree_;
  std::vector<BallVector> rows_;  ///< the coefficients times powers of their doubled distances from the middle
  std::vector<Ball> sums_;        ///< of the moduli
};

/// What leaves towards zero, and a cell of shell 0 to which an alias goes.
struct Alias {
  Ball bound;
  std::size_t target;
};
struct Cell {
  Ball stay;
  std::vector<Alias> aliases;
};

class Shells {
 public:
  Shells(const Mask& scheme, int cells, const Deadline& deadline)
      : symbol_(scheme), arity_(scheme.arity()), cells_(cells), deadline_(deadline) {
    const double pi = std::acos(-1.0), half = std::max(1.0, static_cast<double>(symbol_.degree()) / 2);
    const double width = pi / static_cast<double>(arity_ * arity_ * cells);
    steps_ = static_cast<int>(std::ceil(8 * width * half));
    group_ = std::max(1, static_cast<int>(2 * steps_ / (width * half)));
    terms_ = symbol_.terms(std::max(1.0, group_ * width / (2 * steps_) * half) / half);
    const double far = std::log(std::max(half, static_cast<double>(cells))) / std::log(arity_);
    add(static_cast<int>(far) + 8);
  }

  bool is_complete() const { return complete_; }
  std::size_t size() const { return static_cast<std::size_t>(cells_ * (arity_ - 1)); }
  double sum() const { return symbol_.sum(); }

  void add(int count) {
    while (count-- > 0 && complete_) add_shell();
    const Rational half = power(Rational(arity_), -static_cast<long>(shells_.size()) - 1) / 2;
    inner_ = Cell{Ball(bits), {}};
    for (int r = 0; r < arity_ && complete_; ++r) {
      const SymbolBounds::Expansion expansion(symbol_, Rational(2 * r, arity_) + half, half, terms_);
      put(inner_, r, 0, expansion.largest(0, half));
    }
  }

  /// Of the modulus beyond the last shell.
  double inner_excess() const { return (inner_.stay - 1).middle(); }

  /// weights -> what they make of themselves, near enough for a search; nothing where that is infinite.
  std::optional<polytope::Matrix> matrix(double excess) const {
    if (!(excess > inner_excess())) return std::nullopt;
    const double factor = 1 / (1 + excess);
    polytope::Matrix result(size(), size());
    for (std::size_t i = 0; i < size(); ++i) {
      double product = 1;
      for (const std::vector<Cell>& shell : shells_) {
        product *= factor;
        for (const Alias& alias : shell[i].aliases) result(i, alias.target) += product * alias.bound.middle();
        product *= shell[i].stay.middle();
      }
      for (const Alias& alias : inner_.aliases)
        result(i, alias.target) += product * alias.bound.middle() / (excess - inner_excess());
    }
    return result;
  }

  /// Theorem 40 with these weights, with room for a check that rounds.
  bool prove(const Rational& bound, const std::vector<Integer>& weights) const {
    std::vector<Ball> v;
    for (const Integer& weight : weights) v.emplace_back(Rational(weight), bits);
    const auto from = [&](const Cell& cell) {
      Ball sum(bits);
      for (const Alias& alias : cell.aliases) sum.add_product(alias.bound, v[alias.target]);
      return sum;
    };
    const Ball factor(bound, bits), rest = factor - inner_.stay;
    if (!Ball(0, bits).is_less(rest)) return false;
    const Ball inner = from(inner_) / rest, room = Ball(1, bits).scaled(-24) + 1;
    for (std::size_t i = 0; i < size(); ++i) {
      Ball value = inner;
      for (std::size_t j = shells_.size(); j-- > 0;)
        value = (from(shells_[j][i]) + shells_[j][i].stay * value) / factor;
      if (!(value * room).is_at_most(v[i])) return false;
    }
    return true;
  }

  FrequencyProof proof(Rational bound, std::vector<Integer> weights) const {
    const double size = symbol_.sum() * static_cast<double>(symbol_.degree() + 1);
    const int all = static_cast<int>(bits + std::ceil(std::log2(size + 1)));
    return {std::move(bound),  cells_, static_cast<int>(shells_.size()), steps_, group_, terms_, all,
            std::move(weights)};
  }

 private:
  /// The images of the cells of the next shell: cut into steps, many of which share an expansion.
  void add_shell() {
    const auto j = static_cast<long>(shells_.size());
    const Integer shrink = pow(Integer(arity_), static_cast<unsigned long>(j));
    const long steps = std::max(1L, Integer((steps_ + shrink - 1) / shrink).convert_to<long>());
    const long count = static_cast<long>(size()) * steps;
    const Integer wide = std::max(Integer(1), Integer(shrink * group_ * steps / steps_));
    const long group = wide < count ? wide.convert_to<long>() : count;
    const Rational part = power(Rational(arity_), -j - 2) / (cells_ * steps);
    std::vector<Cell> shell(size(), Cell{Ball(bits), {}});
    for (int r = 0; r < arity_; ++r) {
      std::vector<Ball> largest(size(), Ball(bits));
      for (long first = 0; first < count; first += group) {
        if (deadline_.expired()) complete_ = false;
        if (!complete_) return;
        const long last = std::min(count, first + group);
        const Rational radius = part * (last - first) / 2;
        const Rational middle = Rational(2 * r, arity_) + part * (cells_ * steps + first) + radius;
        const SymbolBounds::Expansion expansion(symbol_, middle, radius, terms_);
        for (long s = first; s < last; ++s) {
          Ball& one = largest[static_cast<std::size_t>(s / steps)];
          one = max(one, expansion.largest(part * (2 * s + 1 - first - last) / 2, part / 2));
        }
      }
      for (std::size_t i = 0; i < size(); ++i) put(shell[i], r, part_of(cells_ + static_cast<long>(i), j), largest[i]);
    }
    shells_.push_back(std::move(shell));
  }

  /// floor(place/arity^(j + 1))
  long part_of(long place, long j) const {
    for (; place > 0 && j >= 0; --j) place /= arity_;
    return place;
  }

  /// The image with 2 pi r added, which lies `part` cells beyond 2 r pi/arity, in shell 0 but for r = 0.
  void put(Cell& cell, int r, long part, const Ball& bound) const {
    const long place = 2 * r * cells_ + part, mirrored = 2 * arity_ * cells_ - 1 - place;
    if (r == 0)
      cell.stay = bound;
    else
      cell.aliases.push_back({bound, static_cast<std::size_t>(std::min(place, mirrored) - cells_)});
  }

  SymbolBounds symbol_;
  long arity_;
  int cells_, steps_ = 1, group_ = 1, terms_ = 1;
  Deadline deadline_;
  bool complete_ = true;
  std::vector<std::vector<Cell>> shells_;
  Cell inner_;
};

std::optional<std::vector<double>> weights_with(const Shells& shells, double excess) {
  const std::optional<polytope::Matrix> matrix = shells.matrix(excess);
  if (!matrix) return std::nullopt;
  return frequency::positive_fixed_point(*matrix, std::vector<double>(shells.size(), 1));
}

/// The least excess for which there are weights, by bisection of its logarithm.
std::optional<double> least_excess(const Shells& shells) {
  double low = least_power, high = std::log10(shells.sum() + 1);
  const auto excess = [](double power) { return std::pow(10.0, power); };
  if (!weights_with(shells, excess(high))) return std::nullopt;
  while (high - low > 1e-4) {
    const double middle = (low + high) / 2;
    (weights_with(shells, excess(middle)) ? high : low) = middle;
  }
  return excess(high);
}

/// Large integers in these proportions.
std::vector<Integer> whole(const std::vector<double>& weights) {
  const double least = *std::min_element(weights.begin(), weights.end());
  std::vector<Integer> result;
  for (const double weight : weights) {
    const Rational scaled(weight / least * std::ldexp(1.0, 48));
    result.push_back(numerator(scaled) / denominator(scaled) + 1);
  }
  return result;
}

}  // namespace

std::optional<FrequencyProof> frequency_proof(const Mask& scheme, int cells, const Deadline& deadline) {
  require(cells >= 1, "frequency_proof: need cells >= 1, got {}", cells);
  constexpr int most_rounds = 8;
  constexpr double small_share = 0.01;  // of the excess that may come from the last shell
  Shells shells(scheme, cells, deadline);
  for (int round = 0; shells.is_complete() && round < most_rounds; ++round) {
    const std::optional<double> least = least_excess(shells);
    if (!least) return std::nullopt;
    if (shells.inner_excess() > small_share * *least && round + 1 < most_rounds) {
      shells.add(4 << round);
      continue;
    }
    // A little more, to five digits, so that the weights have room.
    const Rational excess = parse_decimal(to_decimal(Rational(*least * 1.0005), 5, Rounding::up))->value;
    const auto weights = weights_with(shells, excess.convert_to<double>());
    if (!weights) return std::nullopt;
    std::vector<Integer> integers = whole(*weights);
    if (!shells.prove(1 + excess, integers)) return std::nullopt;
    return shells.proof(1 + excess, std::move(integers));
  }
  return std::nullopt;
}

}  // namespace subcert
