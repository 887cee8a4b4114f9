#include "limit_cells.hpp"

#include "cell_range.hpp"
#include "limit_values.hpp"
#include "rounded.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/difference/level_norms.hpp>
#include <subcert/analysis/symbol/balls.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace subcert {
namespace {

using namespace rounded;

constexpr std::size_t most_nodes = 9;
constexpr std::size_t rough_degree = 3;  // tried, too, where phi may be rough at the scale of the integers
constexpr std::size_t rough_width = 64;  // widest vectors for which it is
constexpr std::size_t most_words = 16;   // looked at one by one where the remainder of a cell is bounded
constexpr double infinite = std::numeric_limits<double>::infinity();

/// The middle as a double; what is missing is added to `error`.
double to_double(arb_srcptr ball, double& error) {
  const double middle = arf_get_d(arb_midref(ball), ARF_RND_NEAR);
  error = up(error + mag_get_d(arb_radref(ball)) + std::abs(middle) * 0x1p-52 + 0x1p-1000);
  return middle;
}

std::vector<Rational> coefficients_from_zero(const LaurentPolynomial& symbol) {
  std::vector<Rational> result(static_cast<std::size_t>(symbol.lowest()), 0);
  for (const Rational& c : symbol.coefficients()) result.push_back(c);
  return result;
}

/// What depends on the degree of the polynomials that interpolate v.
struct Interpolation {
  std::size_t degree = 0;
  std::size_t nodes = 0;                  // degree + 1
  std::vector<std::int64_t> node;         // node / arity^node_level
  std::vector<BallVector> lagrange;       // lagrange[s][j]: coefficient of u^j in the s-th basis polynomial
  std::vector<BallVector> at_nodes;       // v at the nodes
  std::vector<VectorPolynomial> sources;  // k_t
  int word_level = 0;                     // words[w]: eta on the w-th cell of this level, but for P_w eta
  std::vector<VectorPolynomial> words;
  double rest_bound = 0;  // sup of the 1-norm of epsilon
  double rest_slope = 0;  // and of epsilon'
};

}  // namespace

struct LimitCells::Impl : Interpolation {
  int arity;
  int order;           // m: 2 with C^1, else 1
  std::string reason;  // why not C^1
  bool slopes;
  bool mirrored;
  long first;         // of the integers around the support
  Mask mask;          // moved so that phi lives on [0, width]
  std::size_t width;  // v(x) = (phi(x), ..., phi(x + width - 1))
  slong bits;
  int node_level;
  BallVector reversed;                 // mask coefficients from the highest down to index 0
  BallVector at_zero;                  // v(0)
  std::vector<Transition> transition;  // of the divided difference scheme of order m; one element
  std::vector<Recentring> recentring;  // one for each digit
  std::vector<double> norms;           // norms[j] >= || S_[m]^j ||
  std::vector<double> contraction;     // contraction[j] >= sup of ||P epsilon|| / ||epsilon||, P of j steps
  std::size_t moments;                 // epsilon is orthogonal to the polynomials of lower degree
  std::vector<double> fit;             // moments x width: coefficients of a fitted polynomial in position(k)

  explicit Impl(const Mask& given)
      : arity(given.arity()),
        first(first_integer_of(given)),
        mask(given.symbol().shifted(-(arity - 1) * first), arity),
        width(static_cast<std::size_t>(std::max(1L, (mask.symbol().highest() + arity - 2) / (arity - 1)))),
        bits(static_cast<slong>(192 + width / 2)),
        reversed(static_cast<std::size_t>(mask.symbol().highest()) + 1),
        at_zero(width) {
    const SymmetryReport symmetric = symmetry(given);
    mirrored = symmetric.kind != Symmetry::none && denominator(2 * symmetric.centre / (arity - 1)) == 1;
    prove_contraction(given);
    node_level = 1;
    while (int_power(arity, node_level) < 32) ++node_level;
    set_values();
    const Mask derived = divided_difference_scheme(mask, order);
    transition.emplace_back(coefficients_from_zero(derived.symbol()), arity);
    if (rows_width() + static_cast<std::size_t>(order) != width)
      throw std::logic_error("limit cells: the widths of the mask and of its difference scheme do not fit");
    for (int t = 0; t < arity; ++t) recentring.emplace_back(arity, t, 2 * most_nodes - 1);
    set_degree(most_nodes - 1);
    slopes = order == 2 || is_piecewise_polynomial();
    if (order == 1 && slopes) {
      const std::vector<double> nothing(nodes * rows_width(), 0.0);
      sources.assign(static_cast<std::size_t>(arity), {nothing, std::vector<double>(nodes, 0.0), {}});
      return;
    }
    set_fit(std::min<std::size_t>({static_cast<std::size_t>(sum_rules(given)), rough_degree + 1, width}));
    set_contraction();
    set_sources();
    set_bounds();
    if (width <= rough_width) {
      Interpolation smooth = std::move(*this);
      static_cast<Interpolation&>(*this) = Interpolation();
      set_degree(rough_degree);
      set_sources();
      set_bounds();
      const bool rougher = order == 2 ? rest_slope < smooth.rest_slope : rest_bound < smooth.rest_bound;
      if (!rougher) static_cast<Interpolation&>(*this) = std::move(smooth);
    }
    if (std::isinf(rest_bound)) throw std::domain_error("limit cells: the difference scheme contracts too slowly");
    if (order == 2 && std::isinf(rest_slope)) {
      slopes = false;
      reason = "C^1 is proved, but the difference scheme contracts too slowly for a bound of the slope";
    }
  }

  static long first_integer_of(const Mask& given) {
    const long first = given.symbol().lowest(), steps = given.arity() - 1;
    return first >= 0 ? first / steps : -((-first + steps - 1) / steps);
  }

  std::size_t rows_width() const { return transition.front().width(); }

  void prove_contraction(const Mask& given) {
    if (!is_affine(given)) throw std::domain_error("limit cells: " + converges(given).reason);
    order = 0;
    const int rules = sum_rules(given);
    if (rules < 2) reason = "the mask has only one sum rule";
    for (int m = std::min(2, rules); m >= 1 && order == 0; --m) {
      if (m == 2) {
        const Decision smooth = converges(divided_difference_scheme(given, 1));
        reason = "C^1 is not proved: " + smooth.reason;
        if (smooth.is_no()) continue;
      }
      const Mask derived = divided_difference_scheme(given, m);
      int levels = 2;
      while (real_power(arity, levels + 1) <= 256) ++levels;
      for (; order == 0; levels *= 2) {
        const LevelNorms found = level_norms(derived, levels, 10);
        norms.assign(1, 1.0);
        for (const Rational& norm : found.norms) {
          if (norm < power(Rational(arity), static_cast<long>(norms.size()))) order = m;
          norms.push_back(to_double_above(norm));
        }
        if (levels > 8 || found.norms.size() < static_cast<std::size_t>(levels)) break;
      }
    }
    if (order == 0) throw std::domain_error("limit cells: no contractive power of the difference scheme was found");
    if (order == 2) reason.clear();
  }

  /// Above || S_[m]^level ||, by the submultiplicativity of norms.
  double norm_bound(int level) const {
    const auto known = static_cast<int>(norms.size()) - 1;
    double result = 1;
    for (; level > known; level -= known) result = up(result * norms.back());
    return up(result * norms[static_cast<std::size_t>(level)]);
  }

  Rational node_point(std::size_t s) const { return Rational(node[s]) / Rational(int_power(arity, node_level)); }

  void set_values() {
    const LaurentPolynomial& symbol = mask.symbol();
    for (long i = 0; i <= symbol.highest(); ++i)
      arb_set_fmpq(reversed[static_cast<std::size_t>(symbol.highest() - i)],
                   flint::Quotient(symbol.coefficient(i)).get(), bits);
    const LimitValues integers = limit_values(mask, 0);
    for (std::size_t k = 0; k < width; ++k)
      arb_set_fmpq(at_zero[k], flint::Quotient(integers.at(static_cast<long>(k))).get(), bits);
  }

  /// Nodes near those of Chebyshev, the ends included, their basis polynomials and v at them.
  void set_degree(std::size_t given) {
    degree = given;
    nodes = degree + 1;
    const auto last = static_cast<double>(int_power(arity, node_level));
    for (std::size_t s = 0; s < nodes; ++s)
      node.push_back(std::llround(
          last / 2 * (1 - std::cos(std::numbers::pi * static_cast<double>(s) / static_cast<double>(degree)))));
    for (std::size_t s = 0; s < nodes; ++s) {
      LaurentPolynomial basis(1);  // in u, of positive exponents
      for (std::size_t r = 0; r < nodes; ++r)
        if (r != s)
          basis *= LaurentPolynomial(
              {(Rational(1, 2) - node_point(r)) / (node_point(s) - node_point(r)), 1 / (node_point(s) - node_point(r))},
              0);
      lagrange.emplace_back(nodes);
      for (std::size_t j = 0; j < nodes; ++j)
        arb_set_fmpq(lagrange.back()[j], flint::Quotient(basis.coefficient(static_cast<long>(j))).get(), bits);
      at_nodes.push_back(values(node[s], node_level));
    }
  }

  /// v(index / arity^level), 0 <= index <= arity^level.
  BallVector values(std::int64_t index, int level) const {
    BallVector x(width), y(width);
    const bool at_one = index == int_power(arity, level);
    for (std::size_t k = 0; k < width; ++k) {
      if (!at_one)
        arb_set(x[k], at_zero[k]);
      else if (k + 1 < width)
        arb_set(x[k], at_zero[k + 1]);
    }
    if (at_one) return x;
    for (; level > 0 && index % arity == 0; --level) index /= arity;
    const long top = mask.symbol().highest();
    for (; level > 0; --level, index /= arity) {
      const long t = static_cast<long>(index % arity);
      for (long j = 0; j < static_cast<long>(width); ++j) {
        const long low = std::max(0L, arity * j + t - top),
                   high = std::min(static_cast<long>(width) - 1, arity * j + t);
        // b_{arity j + t - i} = reversed[top - arity j - t + i]
        arb_dot(y[static_cast<std::size_t>(j)], nullptr, 0,
                reversed[static_cast<std::size_t>(top - arity * j - t + low)], 1, x[static_cast<std::size_t>(low)], 1,
                high - low + 1, bits);
      }
      std::swap(x, y);
    }
    return x;
  }

  /// Whether v agrees with its interpolating polynomial at all nodes of all children, exactly.
  bool is_piecewise_polynomial() const {
    if (width > 64) return false;
    const LimitValues exact = limit_values(mask, node_level + 1);
    const long last = static_cast<long>(int_power(arity, node_level));
    for (int t = 0; t < arity; ++t)
      for (std::size_t s = 0; s < nodes; ++s) {
        const long index = t * last + static_cast<long>(node[s]);
        const Rational x = Rational(index) / Rational(arity * last);
        std::vector<Rational> weights;
        for (std::size_t r = 0; r < nodes; ++r) {
          Rational weight = 1;
          for (std::size_t q = 0; q < nodes; ++q)
            if (q != r) weight *= (x - node_point(q)) / (node_point(r) - node_point(q));
          weights.push_back(weight);
        }
        for (long k = 0; k < static_cast<long>(width); ++k) {
          Rational rest = exact.at(k * last * arity + index);
          for (std::size_t r = 0; r < nodes; ++r)
            rest -= weights[r] * exact.at(k * last * arity + static_cast<long>(node[r]) * arity);
          if (rest != 0) return false;
        }
      }
    return true;
  }

  /// k_t = sum over s of basis_s eta((t + node_s) / arity), where the m-th difference of eta is v minus its
  /// interpolating polynomial.
  void set_sources() {
    const std::int64_t last = int_power(arity, node_level);
    const std::size_t length = rows_width();
    for (int t = 0; t < arity; ++t) {
      std::vector<BallVector> eta;
      for (std::size_t s = 0; s < nodes; ++s) {
        const std::int64_t index = t * last + node[s];
        BallVector rest = values(index, node_level + 1);
        const Rational u = Rational(index) / Rational(arity * last) - Rational(1, 2);
        Ball at, weight;
        arb_set_fmpq(at.get(), flint::Quotient(u).get(), bits);
        for (std::size_t r = 0; r < nodes; ++r) {
          arb_zero(weight.get());
          for (std::size_t j = nodes; j-- > 0;) {
            arb_mul(weight.get(), weight.get(), at.get(), bits);
            arb_add(weight.get(), weight.get(), lagrange[r][j], bits);
          }
          for (std::size_t k = 0; k < width; ++k) arb_submul(rest[k], weight.get(), at_nodes[r][k], bits);
        }
        for (int m = 0; m < order; ++m)
          for (std::size_t k = 1; k < width; ++k) arb_add(rest[k], rest[k], rest[k - 1], bits);
        eta.push_back(std::move(rest));
      }
      VectorPolynomial source{std::vector<double>(nodes * length, 0.0), std::vector<double>(nodes, 0.0), {}};
      Ball sum;
      for (std::size_t j = 0; j < nodes; ++j)
        for (std::size_t k = 0; k < length; ++k) {
          arb_zero(sum.get());
          for (std::size_t s = 0; s < nodes; ++s) arb_addmul(sum.get(), lagrange[s][j], eta[s][k], bits);
          source.coefficients[j * length + k] = to_double(sum.get(), source.errors[j]);
        }
      sources.push_back(std::move(source));
    }
  }

  VectorPolynomial recentred(const VectorPolynomial& p, int digit) const {
    const std::size_t length = rows_width();
    const Recentring& matrix = recentring[static_cast<std::size_t>(digit)];
    VectorPolynomial result{std::vector<double>(nodes * length, 0.0), std::vector<double>(nodes, 0.0), {}};
    for (std::size_t j = 0; j < nodes; ++j) {
      const double norm = one_norm(&p.coefficients[j * length], length);
      for (std::size_t i = 0; i <= j; ++i) {
        const double factor = matrix(i, j);
        for (std::size_t k = 0; k < length; ++k)
          result.coefficients[i * length + k] += factor * p.coefficients[j * length + k];
        result.errors[i] += std::abs(factor) * (p.errors[j] + gamma(nodes) * norm);
      }
    }
    for (double& error : result.errors) error = up(error);
    return result;
  }

  /// What the words of one length contribute, and the rest by the norm of the power of that length.
  void set_bounds() {
    const std::size_t length = rows_width();
    const Transition& step = transition.front();
    const double shrink = 1 / real_power(arity, order);
    words = sources;
    word_level = 1;
    std::vector<VectorPolynomial> all = sources, pieces = sources;  // pieces[t * count + word]: k_t on the cell of word
    int level = 1;
    const auto work = static_cast<double>(length * length) / 2 * static_cast<double>(nodes);
    while (real_power(arity, level + 1) <= 256 && real_power(arity, level + 1) * work <= 1.5e7) {
      const std::size_t count = all.size();
      std::vector<VectorPolynomial> finer;  // k_t on the cells one level finer
      for (const VectorPolynomial& piece : pieces)
        for (int t = 0; t < arity; ++t) finer.push_back(recentred(piece, t));
      pieces = std::move(finer);
      std::vector<VectorPolynomial> longer;
      for (int t = 0; t < arity; ++t)
        for (std::size_t word = 0; word < count; ++word) {
          VectorPolynomial sum = pieces[static_cast<std::size_t>(t) * count + word];
          std::vector<double> image(length);
          for (std::size_t j = 0; j < nodes; ++j) {
            const double* source = &all[word].coefficients[j * length];
            step.apply(source, t, image.data());
            for (std::size_t k = 0; k < length; ++k) sum.coefficients[j * length + k] += shrink * image[k];
            const double moved = shrink * norms[1] * one_norm(source, length);
            sum.errors[j] = up(sum.errors[j] + shrink * norms[1] * all[word].errors[j] + gamma(length) * moved +
                               gamma(4) * one_norm(&sum.coefficients[j * length], length));
          }
          longer.push_back(std::move(sum));
        }
      all = std::move(longer);
      ++level;
      if (all.size() <= most_words) {
        words = all;
        word_level = level;
      }
    }
    for (VectorPolynomial& word : words)
      for (std::size_t j = 0; j < nodes; ++j) word.norms.push_back(one_norm(&word.coefficients[j * length], length));
    // Largest 1-norms over the words of the m-th differences: the part of epsilon and of epsilon' that they contribute.
    double value = 0, slope = 0;
    std::vector<double> differences;
    for (const VectorPolynomial& word : all) {
      double value_sum = 0, slope_sum = 0;
      for (std::size_t j = 0; j < nodes; ++j) {
        const double* c = &word.coefficients[j * length];
        differences.assign(c, c + length);
        for (int m = 0; m < order; ++m) {
          differences.push_back(0);
          for (std::size_t k = differences.size(); k-- > 1;) differences[k] -= differences[k - 1];
        }
        const double norm = one_norm(differences.data(), differences.size()) + 4 * word.errors[j] +
                            gamma(4) * 4 * one_norm(c, length);
        value_sum += half_power(j) * norm;
        slope_sum += static_cast<double>(j) * 2 * half_power(j) * norm;
      }
      value = std::max(value, up(value_sum));
      slope = std::max(slope, up(slope_sum));
    }
    rest_bound = geometric(value, level, 0);
    rest_slope = order == 2 ? geometric(up(slope * real_power(arity, level)), level, 1) : infinite;
  }

  /// The least bound B with B <= top (1 + r_1 + ... + r_{q-1}) + r_q B, r_i = arity^(growth i level) contraction(i
  /// level).
  double geometric(double top, int level, int growth) const {
    double sum = 1, best = infinite;
    for (int q = 1; q <= 64; ++q) {
      const double ratio = up(contraction_bound(q * level) * real_power(arity, growth * q * level));
      if (ratio < 1) best = std::min(best, up(up(top * sum) / (1 - ratio)));
      sum = up(sum + ratio);
    }
    return best;
  }

  double position(std::size_t k) const {
    return (2 * static_cast<double>(k) + 1 - static_cast<double>(width)) / static_cast<double>(width);
  }

  /// The least squares fit by polynomials of degree count - 1 in position(k). Its rounding errors matter to no bound:
  /// every polynomial may be taken.
  void set_fit(std::size_t count) {
    moments = count;
    std::vector<std::vector<double>> basis, in_powers;  // orthonormal, and its coefficients
    for (std::size_t q = 0; q < count; ++q) {
      std::vector<double> values_of_q(width), powers(count, 0.0);
      for (std::size_t k = 0; k < width; ++k) values_of_q[k] = std::pow(position(k), static_cast<double>(q));
      powers[q] = 1;
      for (int pass = 0; pass < 2; ++pass)
        for (std::size_t r = 0; r < q; ++r) {
          const double part = dot(values_of_q.data(), basis[r].data(), width);
          for (std::size_t k = 0; k < width; ++k) values_of_q[k] -= part * basis[r][k];
          for (std::size_t i = 0; i < count; ++i) powers[i] -= part * in_powers[r][i];
        }
      const double norm = std::sqrt(dot(values_of_q.data(), values_of_q.data(), width));
      for (double& x : values_of_q) x /= norm;
      for (double& x : powers) x /= norm;
      basis.push_back(std::move(values_of_q));
      in_powers.push_back(std::move(powers));
    }
    fit.assign(count * width, 0.0);
    for (std::size_t q = 0; q < count; ++q)
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < width; ++k) fit[i * width + k] += in_powers[q][i] * basis[q][k];
  }

  /// Subtracts a polynomial in k of degree below `moments` from x; returns a bound for the rounding error of an entry.
  double remove_polynomial(double* x) const {
    double c[rough_degree + 1] = {}, size = largest(x, width);
    for (std::size_t i = 0; i < moments; ++i) {
      c[i] = dot(&fit[i * width], x, width);
      size += std::abs(c[i]);
    }
    for (std::size_t k = 0; k < width; ++k) {
      double value = 0;
      const double place = position(k);
      for (std::size_t i = moments; i-- > 0;) value = value * place + c[i];
      x[k] -= value;
    }
    return up(gamma(0) * size);
  }

  /// contraction[j]: the matrix of j steps has the rows (A_{q - l})_l, 0 <= l < width, cut out of the coefficients A of
  /// the j-th power of the mask; a polynomial in l may be taken off each, as epsilon is orthogonal to it.
  void set_contraction() {
    const double norm_of_mask = to_double_above(operator_norm(mask));
    std::vector<double> mask_coefficients;
    for (const Rational& c : coefficients_from_zero(mask.symbol())) mask_coefficients.push_back(to_double(c));
    std::vector<double> coefficients{1.0};
    double error = 0, size = 1;
    contraction.assign(1, 1.0);
    for (int j = 1;; ++j) {
      const double work = real_power(arity, j) * static_cast<double>(width * width) *
                          static_cast<double>(2 * moments + 2);
      if (j > 1 && work > 4e6) break;
      std::vector<double> finer(mask_coefficients.size() + (coefficients.size() - 1) * static_cast<std::size_t>(arity),
                                0.0);
      for (std::size_t q = 0; q < coefficients.size(); ++q)
        for (std::size_t i = 0; i < mask_coefficients.size(); ++i)
          finer[q * static_cast<std::size_t>(arity) + i] += coefficients[q] * mask_coefficients[i];
      error = up(norm_of_mask * (error + gamma(mask_coefficients.size()) * size));
      coefficients = std::move(finer);
      size = up(largest(coefficients.data(), coefficients.size()) + error);
      const auto count = static_cast<std::size_t>(int_power(arity, j));
      const double rows = static_cast<double>(width);
      double worst = 0;
      std::vector<double> sums(width), window(width);
      for (std::size_t r = 0; r < count; ++r) {
        std::fill(sums.begin(), sums.end(), 0.0);
        for (std::size_t q = r; q < count * width; q += count) {
          for (std::size_t l = 0; l < width; ++l)
            window[l] = l <= q && q - l < coefficients.size() ? coefficients[q - l] : 0;
          const double rounding = remove_polynomial(window.data());
          for (std::size_t l = 0; l < width; ++l) sums[l] += std::abs(window[l]) + rounding;
        }
        worst = std::max(worst, largest(sums.data(), width));
      }
      contraction.push_back(up(worst + rows * error));
    }
    // Differences: epsilon = nabla^m eta, || eta || <= (width / 2)^m || epsilon ||.
    for (std::size_t j = 1; j < contraction.size(); ++j)
      contraction[j] = std::min(contraction[j], difference_bound(static_cast<int>(j)));
  }

  double difference_bound(int level) const {
    return up(norm_bound(level) * real_power(static_cast<int>(width), order) / real_power(arity, order * level));
  }

  double contraction_bound(int level) const {
    if (contraction.empty()) return 0;
    const auto known = static_cast<int>(contraction.size()) - 1;
    double result = 1;
    for (int rest = level; rest > 0; rest -= known)
      result = up(result * contraction[static_cast<std::size_t>(std::min(rest, known))]);
    return level == 0 ? 1 : std::min(result, difference_bound(level));
  }

  /// Bounds for the square of the remainder of all cells of one level, and for its derivative by x.
  std::pair<double, double> square_bounds(int level) const {
    if (rest_bound == 0) return {0, 0};
    const double factor = contraction_bound(level);
    const double value = up(factor * rest_bound);
    const double slope = slopes ? up(up(factor * rest_slope) * real_power(arity, level)) : 0;
    return {up(value * value / 2), up(value * slope)};
  }

  /// A bound for |row . eta| / rest_bound, and at the same time for |row . eta'| / rest_slope: the row is the m-th
  /// difference of a longer one, of which a polynomial may be taken off.
  double pairing(const double* row, double error) const {
    thread_local std::vector<double> sums;
    sums.assign(row, row + rows_width());
    for (int m = 0; m < order; ++m) {
      double sum = 0, size = 0;
      for (double& x : sums) {  // s_k - s_{k+1} = x_k with s_0 = 0
        size += std::abs(x);
        const double next = sum - x;
        x = sum;
        sum = next;
      }
      sums.push_back(sum);
      error = up(static_cast<double>(width) * error + gamma(width) * size);
    }
    const double rounding = remove_polynomial(sums.data());
    return up(largest(sums.data(), width) + rounding + error);
  }

  /// Bounds of the rows' part of a form and of its derivative by x, for each power of u.
  struct RowBounds {
    double value[most_nodes] = {};
    double slope[most_nodes] = {};
  };
  RowBounds row_bounds(const CellForm& form) const {
    RowBounds bounds;
    if (rest_bound == 0) return bounds;
    const std::vector<double> errors = row_errors(form.row_losses, form.rows.size() / rows_width());
    const double scale = up(form.factor / real_power(arity, order * form.level)), speed = real_power(arity, form.level);
    const std::size_t length = rows_width();
    const double shrink = contraction_bound(word_level), faster = real_power(arity, word_level);
    for (std::size_t j = 0; j < errors.size(); ++j) {
      const double* row = &form.rows[j * length];
      const double paired = up(pairing(row, errors[j]) * shrink), size = up(largest(row, length) + errors[j]);
      double value = 0, slope = 0;  // of row . eta on the words
      for (const VectorPolynomial& word : words) {
        double value_sum = 0, slope_sum = 0;
        for (std::size_t l = 0; l < nodes; ++l) {
          const double* c = &word.coefficients[l * length];
          const double term = std::abs(dot(row, c, length)) + (errors[j] + gamma(length) * size) * word.norms[l] +
                              size * word.errors[l];
          value_sum += half_power(l) * term;
          slope_sum += static_cast<double>(l) * 2 * half_power(l) * term;
        }
        value = std::max(value, up(value_sum));
        slope = std::max(slope, up(slope_sum));
      }
      value = up(value + paired * rest_bound);
      bounds.value[j] = up(scale * half_power(j) * value);
      if (slopes)
        bounds.slope[j] = up(scale * speed * half_power(j) *
                             up(faster * up(slope + paired * rest_slope) + 2 * static_cast<double>(j) * value));
    }
    return bounds;
  }

  /// The errors of the rows: what each step lost, carried on by the steps after it.
  std::vector<double> row_errors(const std::vector<double>& losses, std::size_t count) const {
    const std::size_t steps = losses.size() / count;
    std::vector<double> errors(count, 0.0);
    for (std::size_t k = 0; k < steps; ++k) {
      const double norm = norm_bound(static_cast<int>(steps - 1 - k));
      for (std::size_t j = 0; j < count; ++j) errors[j] = up(errors[j] + norm * losses[k * count + j]);
    }
    return errors;
  }

  void drop_small_rows(CellForm& form, const Spare& spare) const;
  CellParts parts(const CellForm& form) const;
};

LimitCells::LimitCells(const Mask& mask) : impl_(std::make_unique<Impl>(mask)) {}
LimitCells::LimitCells(LimitCells&&) noexcept = default;
LimitCells& LimitCells::operator=(LimitCells&&) noexcept = default;
LimitCells::~LimitCells() = default;

int LimitCells::arity() const { return impl_->arity; }
bool LimitCells::has_slopes() const { return impl_->slopes; }
const std::string& LimitCells::slope_reason() const { return impl_->reason; }
bool LimitCells::is_mirrored() const { return impl_->mirrored; }
long LimitCells::first_integer() const { return impl_->first; }
long LimitCells::last_integer() const { return impl_->first + static_cast<long>(impl_->width); }

int LimitCells::deepest_level() const {
  int level = 0;
  for (double size = arity(); size < 0x1p61; size *= arity()) ++level;
  return level;
}

CellForm LimitCells::limit_form(long k) const {
  const Impl& m = *impl_;
  const long place = k - m.first;
  CellForm form;
  form.index = k;
  form.middle.assign(1, 0.0);
  form.radius.assign(1, 0.0);
  form.rows.assign(m.rows_width(), 0.0);
  form.row_losses.assign(1, 0.0);
  if (place < 0 || place >= static_cast<long>(m.width)) return form;
  form.middle.assign(m.nodes, 0.0);
  form.radius.assign(m.nodes, 0.0);
  Ball sum;
  for (std::size_t j = 0; j < m.nodes; ++j) {
    arb_zero(sum.get());
    for (std::size_t s = 0; s < m.nodes; ++s)
      arb_addmul(sum.get(), m.lagrange[s][j], m.at_nodes[s][static_cast<std::size_t>(place)], m.bits);
    form.middle[j] = to_double(sum.get(), form.radius[j]);
  }
  std::vector<double> unit(m.width, 0.0);
  unit[static_cast<std::size_t>(place)] = 1;
  for (int i = 0; i < m.order; ++i) {
    for (std::size_t j = 0; j + 1 < unit.size(); ++j) unit[j] -= unit[j + 1];
    unit.pop_back();
  }
  std::copy(unit.begin(), unit.begin() + static_cast<long>(m.rows_width()), form.rows.begin());
  return form;
}

CellForm LimitCells::variance_form(std::int64_t index, int level) const {
  const Impl& m = *impl_;
  const int deepest = deepest_level() - m.node_level;
  if (level < 0 || level > deepest || index < 0 || index >= int_power(m.arity, level))
    throw std::invalid_argument("variance_form: need 0 <= level <= " + std::to_string(deepest) +
                                " and 0 <= index < arity^level, got level " + std::to_string(level));
  CellForm form;
  form.level = level;
  form.index = index;
  form.factor = 2;
  std::vector<BallVector> z;  // coefficients of the interpolating polynomial in u
  {
    std::vector<BallVector> at;
    for (std::size_t s = 0; s < m.nodes; ++s)
      at.push_back(level == 0 ? m.values(m.node[s], m.node_level)
                              : m.values(index * int_power(m.arity, m.node_level) + m.node[s], level + m.node_level));
    for (std::size_t j = 0; j < m.nodes; ++j) {
      z.emplace_back(m.width);
      for (std::size_t s = 0; s < m.nodes; ++s)
        for (std::size_t k = 0; k < m.width; ++k) arb_addmul(z[j][k], m.lagrange[s][j], at[s][k], m.bits);
    }
  }
  form.middle.assign(2 * m.degree + 1, 0.0);
  form.radius.assign(2 * m.degree + 1, 0.0);
  Ball sum, product;
  for (std::size_t i = 0; i <= 2 * m.degree; ++i) {
    arb_zero(sum.get());
    for (std::size_t j = i > m.degree ? i - m.degree : 0; 2 * j <= i; ++j) {
      arb_dot(product.get(), nullptr, 0, z[j][0], 1, z[i - j][0], 1, static_cast<slong>(m.width), m.bits);
      arb_add(sum.get(), sum.get(), product.get(), m.bits);
      if (2 * j < i) arb_add(sum.get(), sum.get(), product.get(), m.bits);
    }
    form.middle[i] = to_double(sum.get(), form.radius[i]);
  }
  const std::size_t length = m.rows_width();
  form.rows.assign(m.nodes * length, 0.0);
  for (std::size_t j = 0; j < m.nodes; ++j) {
    for (int i = 0; i < m.order; ++i)
      for (std::size_t k = 0; k + 1 < m.width; ++k) arb_sub(z[j][k], z[j][k], z[j][k + 1], m.bits);
    double error = 0;
    for (std::size_t k = 0; k < length; ++k) {
      double entry_error = 0;
      form.rows[j * length + k] = to_double(z[j][k], entry_error);
      error = std::max(error, entry_error);
    }
    form.row_losses.push_back(error);
  }
  std::vector<int> digits;
  for (std::int64_t rest = index; static_cast<int>(digits.size()) < level; rest /= m.arity)
    digits.push_back(static_cast<int>(rest % m.arity));
  std::vector<double> image(length);
  for (std::size_t d = digits.size(); d-- > 0;)
    for (std::size_t j = 0; j < m.nodes; ++j) {
      double* row = &form.rows[j * length];
      const double size = largest(row, length);
      m.transition.front().apply_transposed(row, digits[d], image.data());
      std::copy(image.begin(), image.end(), row);
      form.row_losses.push_back(up(m.norms[1] * gamma(length) * size));
    }
  std::tie(form.square, form.square_slope) = m.square_bounds(level);
  return form;
}

CellForm LimitCells::variance_child(const CellForm& form, const CellRange& range, int digit, const Spare& spare) const {
  // Where cells are few: what is spare leaves no room for the square.
  const double cost = real_power(arity(), form.level + 1) * static_cast<double>(impl_->width * impl_->width);
  const bool early = (cost < 1e5 || form.level < 4) &&
                     (form.square > 5 * spare.value || form.square_slope > 5 * spare.slope);
  if ((range.square_share > 0.1 || early) && form.level + impl_->node_level < deepest_level()) {
    const auto [value, slope] = impl_->square_bounds(form.level + 1);
    if (value < form.square / 2 || slope < form.square_slope / 2)
      return variance_form(form.index * arity() + digit, form.level + 1);
  }
  return child(form, digit, spare);
}

CellForm LimitCells::child(const CellForm& form, int digit, const Spare& spare) const {
  const Impl& m = *impl_;
  const std::size_t length = m.rows_width(), count = form.rows.size() / length;
  const Recentring& matrix = m.recentring[static_cast<std::size_t>(digit)];
  CellForm result;
  result.level = form.level + 1;
  result.index = form.index * m.arity + digit;
  result.factor = form.factor;
  result.value_slack = form.value_slack;
  result.slope_slack = form.slope_slack;
  result.square = form.square;
  result.square_slope = form.square_slope;
  // The polynomial, recentred.
  const std::size_t size = std::max(form.middle.size(), count + m.degree);
  result.middle.assign(size, 0.0);
  result.radius.assign(size, 0.0);
  for (std::size_t i = 0; i < form.middle.size(); ++i) {
    for (std::size_t j = i; j < form.middle.size(); ++j) {
      const double factor = matrix(i, j);
      result.middle[i] += factor * form.middle[j];
      result.radius[i] += std::abs(factor) * (form.radius[j] + gamma(form.middle.size()) * std::abs(form.middle[j]));
    }
    result.radius[i] = up(result.radius[i]);
  }
  // The rows, recentred.
  std::vector<double> rows(count * length, 0.0), errors(count, 0.0), sizes(count, 0.0), losses(count, 0.0);
  for (std::size_t j = 0; j < count; ++j) {
    const double row_size = largest(&form.rows[j * length], length);
    for (std::size_t i = 0; i <= j; ++i) {
      const double factor = matrix(i, j);
      for (std::size_t k = 0; k < length; ++k) rows[i * length + k] += factor * form.rows[j * length + k];
      losses[i] += std::abs(factor) * gamma(count) * row_size;
    }
  }
  result.row_losses.assign(form.row_losses.size(), 0.0);
  for (std::size_t k = 0; k < form.row_losses.size(); k += count)
    for (std::size_t j = 0; j < count; ++j)
      for (std::size_t i = 0; i <= j; ++i)
        result.row_losses[k + i] = up(result.row_losses[k + i] + std::abs(matrix(i, j)) * form.row_losses[k + j]);
  const std::vector<double> carried = m.row_errors(result.row_losses, count);
  for (std::size_t i = 0; i < count; ++i) {
    errors[i] = up(carried[i] + losses[i]);
    sizes[i] = up(largest(&rows[i * length], length) + errors[i]);
  }
  // eta((t + y) / a) = a^-m T eta(y) + k_t(y): the second part goes to the polynomial, the first makes the new rows.
  const VectorPolynomial& source = m.sources[static_cast<std::size_t>(digit)];
  const double scale = form.factor / real_power(m.arity, m.order * form.level);
  for (std::size_t l = 0; l < m.nodes; ++l) {
    const double* k = &source.coefficients[l * length];
    const double norm = one_norm(k, length);
    if (norm + source.errors[l] == 0) continue;
    for (std::size_t i = 0; i < count; ++i) {
      result.middle[i + l] += scale * dot(&rows[i * length], k, length);
      result.radius[i + l] = up(result.radius[i + l] +
                                scale *
                                    (errors[i] * norm + sizes[i] * source.errors[l] + gamma(length) * sizes[i] * norm) +
                                gamma(4) * std::abs(result.middle[i + l]));
    }
  }
  result.rows.assign(count * length, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    m.transition.front().apply_transposed(&rows[i * length], digit, &result.rows[i * length]);
    result.row_losses.push_back(up(m.norms[1] * (losses[i] + gamma(length) * sizes[i])));
  }
  m.drop_small_rows(result, spare);
  return result;
}

/// Rows of high m.degree matter less at each level; those that matter less than what is spare are replaced by bounds.
void LimitCells::Impl::drop_small_rows(CellForm& form, const Spare& spare) const {
  if (form.rows.size() == rows_width()) return;
  const RowBounds bounds = row_bounds(form);
  std::size_t keep = form.rows.size() / rows_width();
  while (keep > 1 && bounds.value[keep - 1] <= spare.value && bounds.slope[keep - 1] <= spare.slope) {
    --keep;
    form.value_slack = up(form.value_slack + bounds.value[keep]);
    form.slope_slack = up(form.slope_slack + bounds.slope[keep]);
  }
  const std::size_t count = form.rows.size() / rows_width(), steps = form.row_losses.size() / count;
  for (std::size_t k = 1; k < steps; ++k)
    for (std::size_t j = 0; j < keep; ++j) form.row_losses[k * keep + j] = form.row_losses[k * count + j];
  form.row_losses.resize(steps * keep);
  form.rows.resize(keep * rows_width());
}

CellParts LimitCells::Impl::parts(const CellForm& form) const {
  const RowBounds bounds = row_bounds(form);
  CellParts parts{form.middle,
                  form.radius,
                  real_power(arity, form.level),
                  form.value_slack,
                  form.slope_slack,
                  form.value_slack,
                  form.slope_slack,
                  0,
                  form.square,
                  form.square_slope,
                  slopes};
  for (std::size_t j = 0; j < most_nodes; ++j) {
    parts.value_rest += bounds.value[j];
    parts.slope_rest += bounds.slope[j];
  }
  parts.value_rest = up(parts.value_rest);
  parts.slope_rest = up(parts.slope_rest);
  return parts;
}

CellRange LimitCells::range(const CellForm& form) const { return range_of(impl_->parts(form)); }

CellRange LimitCells::difference(const LimitCells& first, const CellForm& form, const LimitCells& second,
                                 const CellForm& other) {
  if (first.arity() != second.arity() || form.level != other.level || form.index != other.index)
    throw std::invalid_argument("difference: need forms on one cell");
  CellParts parts = first.impl_->parts(form);
  const CellParts less = second.impl_->parts(other);
  parts.middle.resize(std::max(parts.middle.size(), less.middle.size()), 0.0);
  parts.radius.resize(parts.middle.size(), 0.0);
  for (std::size_t j = 0; j < less.middle.size(); ++j) {
    parts.middle[j] -= less.middle[j];
    parts.radius[j] = up(parts.radius[j] + less.radius[j] + std::abs(parts.middle[j]) * 0x1p-50);
  }
  parts.value_rest = up(parts.value_rest + less.value_rest);
  parts.slope_rest = up(parts.slope_rest + less.slope_rest);
  parts.value_slack = up(parts.value_slack + less.value_slack);
  parts.slope_slack = up(parts.slope_slack + less.slope_slack);
  parts.square_below = less.square_above;
  parts.square_slope = up(parts.square_slope + less.square_slope);
  parts.slopes = parts.slopes && less.slopes;
  return range_of(parts);
}

}  // namespace subcert
