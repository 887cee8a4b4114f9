#include "limit_range.hpp"
#include "limit_values.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/numbers/scaled_numbers.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert {
namespace {

constexpr std::size_t most_window_points = 1000, bytes_of_entry = 48;
constexpr int deepest_tile = 400;

/// The tile M^-n (index + Gamma), where phi(M^-n (index + y)) = sum over k of row_k phi(y + k) / denominator^n.
struct Tile {
  LatticePoint index;
  std::vector<Integer> row;
  std::optional<Interval> around = {};  ///< of phi on the larger tile it was cut from, where that is known

  bool is_zero() const {
    return std::all_of(row.begin(), row.end(), [](const Integer& entry) { return entry.is_zero(); });
  }
};

/// The inner product of a row and the numbers.
Rational times(const ScaledNumbers& numbers, const std::vector<Integer>& row) {
  Integer sum = 0;
  for (std::size_t k = 0; k < row.size(); ++k) add_product(sum, row[k], numbers.numerators[k]);
  return {sum, numbers.denominator};
}

/// What the digits of a mask make of the lattice, and phi on its tiles.
class Tiling {
 public:
  /// Domain: the digits in M [0, 1)^s.
  explicit Tiling(const LatticeMask& mask);

  std::size_t window() const { return window_.size(); }
  std::size_t digits() const { return steps_.size(); }
  const Dilation& dilation() const { return dilation_; }

  std::vector<Tile> roots() const;
  /// The tiles of the next level that cover this one, digit by digit.
  std::vector<Tile> parts(const Tile& tile) const;
  /// phi(M^-level index).
  Rational corner(const Tile& tile, int level) const { return times(corner_, tile.row) / scale(level); }
  /// phi on the tile, where sum over k of |phi(. + k)| <= `modulus`.
  Interval range(const Tile& tile, int level, const Rational& modulus) const;
  /// A bound of sum over k of |phi(. + k)|, from all tiles of a level in the order of roots() and parts(). Nothing
  /// where they are too coarse.
  std::optional<Rational> modulus(const std::vector<Tile>& tiles, int level, const Rational& contraction) const;

 private:
  struct Entry {
    std::size_t from, to;
    Integer factor;
  };
  Rational scale(int level) const { return power(Rational(denominator_), level); }
  void find_slopes(const LatticeMask& mask);

  Dilation dilation_;
  LatticeWindow window_;
  Integer denominator_ = 1;
  std::vector<std::vector<Entry>> steps_;  // digit by digit
  ScaledNumbers corner_;
  std::vector<Interval> tile_box_;  // holds Gamma
  std::size_t middle_ = 0;          // a point of the window near its centre
  std::vector<Rational> shift_;     // sum over k of k phi(x - k) = x - shift; none without sum rules of order 2
  ScaledNumbers fit_{
      std::vector<Rational>()};       // the slopes of the linear part that is fitted to a row, variable by variable
  std::vector<Integer> coordinates_;  // those of the points of the window, in the same order
};

std::vector<Rational> values_on_window(const LatticeSequence& values, const LatticeWindow& window) {
  std::vector<Rational> result(window.size(), 0);
  for (const auto& [point, value] : values)
    if (const std::size_t k = window.place(point); k < result.size()) result[k] = value;
  return result;
}

LatticeMask indicator(const Dilation& dilation) {
  std::vector<MultivariatePolynomial::Monomial> terms;
  for (const LatticePoint& digit : dilation.digits()) terms.push_back({1, digit});
  return {MultivariatePolynomial(static_cast<int>(dilation.variables()), terms), dilation};
}

Tiling::Tiling(const LatticeMask& mask)
    : dilation_(mask.dilation()),
      window_(mask, {LatticePoint(dilation_.variables(), 0)}, most_window_points),
      steps_(dilation_.digits().size()),
      corner_(values_on_window(limit_values(mask, 0), window_)),
      tile_box_(limit_support(indicator(dilation_))) {
  for (const auto& term : mask.symbol().terms())
    denominator_ = lcm(denominator_, subcert::denominator(term.coefficient));
  for (std::size_t k = 0; k < window_.size(); ++k) {
    const auto images = transitions(mask, {{window_.points()[k], 1}});
    for (std::size_t d = 0; d < images.size(); ++d)
      for (const auto& [point, value] : images[d])
        steps_[d].push_back({window_.place(point), k, numerator(value * denominator_)});
  }
  find_slopes(mask);
}

void Tiling::find_slopes(const LatticeMask& mask) {
  const std::size_t variables = dilation_.variables();
  const Rational count(static_cast<long>(window()));
  RationalMatrix points(window(), variables);  // about their mean
  for (std::size_t v = 0; v < variables; ++v) {
    Rational mean = 0;
    for (const LatticePoint& point : window_.points()) mean += point[v] / count;
    for (std::size_t k = 0; k < window(); ++k) points(k, v) = window_.points()[k][v] - mean;
  }
  std::vector<Rational> squares(window(), 0);
  for (std::size_t k = 0; k < window(); ++k)
    for (std::size_t v = 0; v < variables; ++v) squares[k] += points(k, v) * points(k, v);
  middle_ = static_cast<std::size_t>(std::min_element(squares.begin(), squares.end()) - squares.begin());
  const PolynomialReproduction polynomials = polynomial_reproduction(mask);
  const RationalMatrix products = transposed(points) * points;
  if (polynomials.sum_rules < 2 || !kernel(products).empty()) return;
  shift_ = polynomials.parametrization;
  const RationalMatrix fit = solve(products, transposed(points));
  std::vector<Rational> weights;
  for (std::size_t v = 0; v < variables; ++v)
    for (std::size_t k = 0; k < window(); ++k) {
      weights.push_back(fit(v, k));
      coordinates_.emplace_back(window_.points()[k][v]);
    }
  fit_ = ScaledNumbers(weights);
}

std::vector<Tile> Tiling::roots() const {
  std::vector<Tile> result;
  for (std::size_t k = 0; k < window(); ++k) {
    result.push_back({window_.points()[k], std::vector<Integer>(window(), 0)});
    result.back().row[k] = 1;
  }
  return result;
}

std::vector<Tile> Tiling::parts(const Tile& tile) const {
  std::vector<Tile> result;
  const LatticePoint origin = dilation_ * tile.index;
  for (std::size_t d = 0; d < steps_.size(); ++d) {
    result.push_back({origin + dilation_.digits()[d], std::vector<Integer>(window(), 0)});
    for (const Entry& entry : steps_[d])
      if (!tile.row[entry.from].is_zero()) add_product(result.back().row[entry.to], tile.row[entry.from], entry.factor);
  }
  return result;
}

Interval Tiling::range(const Tile& tile, int level, const Rational& modulus) const {
  // phi = slope . (shift - y) + sum over k of (row_k - slope . k) phi(y + k); the sum of phi(y + k) is 1.
  const std::size_t count = window();
  Interval result = Interval::exactly(0);
  std::vector<Integer> descents;
  for (std::size_t v = 0; v < shift_.size(); ++v) {
    Integer slope = 0;
    for (std::size_t k = 0; k < count; ++k) add_product(slope, tile.row[k], fit_.numerators[v * count + k]);
    result = result + (Interval::exactly(shift_[v]) - tile_box_[v]) * Rational(slope);
    descents.push_back(-slope);
  }
  Integer low, high;
  for (std::size_t k = 0; k < count; ++k) {
    Integer rest = tile.row[k] * fit_.denominator;
    for (std::size_t v = 0; v < descents.size(); ++v) add_product(rest, descents[v], coordinates_[v * count + k]);
    if (k == 0 || rest < low) low = rest;
    if (k == 0 || rest > high) high = rest;
  }
  const Rational half = Rational(high - low) / 2, middle = Rational(high + low) / 2;
  return (result + Interval{middle - modulus * half, middle + modulus * half}) *
         (1 / (scale(level) * fit_.denominator));
}

std::optional<Rational> Tiling::modulus(const std::vector<Tile>& tiles, int level, const Rational& contraction) const {
  const std::size_t words = tiles.size() / window();
  Integer norm = 0, widest = 0;
  for (std::size_t word = 0; word < words; ++word)
    for (std::size_t k = 0; k < window(); ++k) {
      Integer sum = 0;
      for (std::size_t root = 0; root < window(); ++root) {
        const std::vector<Integer>& row = tiles[root * words + word].row;
        sum += k == middle_ ? abs(row[k]) : abs(row[k] - row[middle_]);
      }
      Integer& largest = k == middle_ ? norm : widest;
      largest = std::max(largest, sum);
    }
  const Rational ratio = widest / scale(level);
  if (ratio >= contraction) return std::nullopt;
  return norm / scale(level) / (1 - ratio);
}

/// The larger values of a function, phi or -phi, as far as tiles told: 0 outside the support.
struct Peak {
  int sign;
  Rational attained = 0, aside = 0;
  std::vector<Rational> point = {};

  void attain(const Rational& value, const Tile& tile, int level, const Dilation& dilation) {
    if (sign * value <= attained) return;
    attained = sign * value;
    point = point_at(dilation, tile.index, level);
  }
  Rational above(const Interval& range) const { return sign > 0 ? range.upper : Rational(-range.lower); }
  /// Of the largest value of the sign times the function.
  Enclosure enclosure(bool bounded) const {
    Enclosure value = Enclosure::at_least(attained);
    if (bounded) value.upper = std::max(attained, aside);
    return value;
  }
};

class RangeSearch {
 public:
  RangeSearch(const LatticeMask& mask, const LimitOptions& options)
      : tiling_(mask.has_factors() ? mask : LatticeMask(mask.symbol(), Dilation(mask.dilation().rows()))),
        options_(options),
        tiles_(tiling_.roots()) {}

  LimitRange run() {
    attain();
    while (!modulus_ && split_all()) find_modulus();
    LimitRange result;
    result.complete = modulus_.has_value();
    while (modulus_ && !tiles_.empty()) result.complete = bound() && result.complete;
    const bool bounded = modulus_.has_value();
    const Enclosure lowest = low_.enclosure(bounded);
    result.maximum = high_.enclosure(bounded);
    result.minimum = {bounded ? std::optional<Rational>(-*lowest.upper) : std::nullopt, Rational(-*lowest.lower)};
    result.sup_norm = Enclosure::at_least(std::max(high_.attained, low_.attained));
    if (bounded) result.sup_norm.upper = std::max(*result.maximum.upper, *lowest.upper);
    result.highest = high_.point;
    result.lowest = low_.point;
    result.nonnegative = sign(result.minimum);
    result.cells = cells_;
    return result;
  }

 private:
  void attain() {
    cells_ += tiles_.size();
    for (const Tile& tile : tiles_) {
      const Rational value = tiling_.corner(tile, level_);
      high_.attain(value, tile, level_, tiling_.dilation());
      low_.attain(value, tile, level_, tiling_.dilation());
    }
  }

  bool may_hold(std::size_t tiles) const { return tiles * tiling_.window() * bytes_of_entry <= options_.budget.memory; }

  bool split_all() {
    if (!may_hold(tiles_.size() * tiling_.digits())) return false;
    std::vector<Tile> next;
    for (const Tile& tile : tiles_) {
      if (options_.budget.deadline.expired()) return false;
      for (Tile& part : tiling_.parts(tile)) next.push_back(std::move(part));
    }
    tiles_ = std::move(next);
    ++level_;
    attain();
    return true;
  }

  void find_modulus() {
    nonnegative_ = std::all_of(tiles_.begin(), tiles_.end(), [](const Tile& tile) {
      return std::all_of(tile.row.begin(), tile.row.end(), [](const Integer& entry) { return entry.sign() >= 0; });
    });
    if (nonnegative_)
      modulus_ = 1;
    else
      // The last level that memory allows may be coarser.
      modulus_ = tiling_.modulus(tiles_, level_, may_hold(tiles_.size() * tiling_.digits()) ? Rational(3, 4) : 1);
    if (modulus_) first_level_ = level_;
  }

  /// Puts tiles aside that raise no extreme by more than asked for, and splits the others. Whether none was put aside
  /// for lack of time or memory. When the time is up a tile has the bounds of the one it was cut from.
  bool bound() {
    const Rational margin = options_.relative_width * std::max(high_.attained, low_.attained);
    bool complete = true;
    std::vector<Tile> next;
    for (const Tile& tile : tiles_) {
      if (tile.is_zero()) continue;
      const bool late = options_.budget.deadline.expired();
      if (late && !tile.around) {
        modulus_.reset();  // not all of phi is bounded
        return false;
      }
      const Interval range = late ? *tile.around : tiling_.range(tile, level_, *modulus_);
      const Rational above = high_.above(range), below = nonnegative_ ? Rational(0) : low_.above(range);
      const bool settled = above <= high_.attained + margin && below <= low_.attained + margin;
      if (!settled && !late && level_ < deepest_tile && may_hold(next.size() + tiling_.digits())) {
        for (Tile& part : tiling_.parts(tile)) {
          part.around = range;
          next.push_back(std::move(part));
        }
        continue;
      }
      complete = complete && settled;
      high_.aside = std::max(high_.aside, above);
      low_.aside = std::max(low_.aside, below);
    }
    tiles_ = std::move(next);
    ++level_;
    attain();
    return complete;
  }

  Decision sign(const Enclosure& minimum) const {
    if (nonnegative_)
      return {Truth::yes, first_level_ == 1 ? "no coefficient of the mask is negative"
                                            : "no coefficient of the power " + std::to_string(first_level_) +
                                                  " of the scheme is negative"};
    if (*minimum.upper < 0) {
      std::string at;
      for (const Rational& x : low_.point) at += (at.empty() ? "" : ", ") + to_text(x);
      return {Truth::no, "phi(" + at + ") = " + short_text(*minimum.upper)};
    }
    if (minimum.lower && *minimum.lower >= 0) return {Truth::yes, "by bounds on all cells"};
    return {Truth::unknown, "the coefficients have both signs, the values found do not"};
  }

  Tiling tiling_;
  LimitOptions options_;
  std::vector<Tile> tiles_;
  int level_ = 0, first_level_ = 0;
  std::uint64_t cells_ = 0;
  bool nonnegative_ = false;
  std::optional<Rational> modulus_;
  Peak high_{1}, low_{-1};
};

}  // namespace

LimitRange limit_range(const LatticeMask& mask, const LimitOptions& options) {
  if (mask.factors().size() == 1) return limit_range(mask.curve(), options);
  require(options.relative_width > 0, "limit_range: need relative_width > 0, got {}", to_text(options.relative_width));
  return RangeSearch(mask, options).run();
}

}  // namespace subcert
