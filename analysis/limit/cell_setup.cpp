#include "cell_setup.hpp"

#include "limit_values.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/difference/level_norms.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace subcert::cells {
namespace {

using namespace outward;

constexpr double contraction_seconds = 10;  // for the norms of one divided difference scheme

/// Norms of the powers of S_[order], far enough that one of them contracts; order 0 where none was found to.
Contraction contraction_of_order(const Mask& mask, int order, const Deadline& deadline) {
  const Mask derived = divided_difference_scheme(mask, order);
  Contraction result;
  int levels = 2;
  while (real_power(mask.arity(), levels + 1) <= 256) ++levels;
  for (; result.order == 0; levels *= 2) {
    const LevelNorms found = level_norms(derived, levels, deadline.at_most(contraction_seconds));
    result.norms.assign(1, 1.0);
    for (const Rational& norm : found.norms) {
      if (norm < power(Rational(mask.arity()), static_cast<long>(result.norms.size()))) result.order = order;
      result.norms.push_back(to_double_above(norm));
    }
    if (levels > 8 || found.norms.size() < static_cast<std::size_t>(levels)) break;
  }
  return result;
}

Contraction prove_contraction(const Mask& mask, const Deadline& deadline) {
  if (!is_affine(mask)) fail(ErrorKind::domain, "limit cells: {}", converges(mask).reason);
  const int rules = sum_rules(mask);
  Contraction result;
  std::string reason = rules < 2 ? "the mask has only one sum rule" : "";
  for (int order = std::min(2, rules); order >= 1 && result.order == 0; --order) {
    if (order == 2) {
      const Decision smooth = converges(divided_difference_scheme(mask, 1),
                                        {16, deadline.at_most(2 * contraction_seconds)});
      reason = "C^1 is not proved: " + smooth.reason;
      if (smooth.is_no()) continue;
    }
    result = contraction_of_order(mask, order, deadline);
  }
  require(result.order > 0, "limit cells: no contractive power of the difference scheme was found");
  if (result.order == 1) result.reason = reason;
  return result;
}

bool has_mirrored_variance(const Mask& mask) {
  const SymmetryReport symmetric = symmetry(mask);
  return symmetric.kind != Symmetry::none && denominator(2 * symmetric.centre / (mask.arity() - 1)) == 1;
}

int level_of_nodes(int arity) {
  int level = 1;
  while (int_power(arity, level) < 32) ++level;
  return level;
}

}  // namespace

double to_double(const Ball& ball, double& error) {
  const double middle = ball.middle();
  error = up(error + ball.radius() + std::abs(middle) * 0x1p-52 + 0x1p-1000);
  return middle;
}

double Contraction::norm_bound(int level) const {
  const auto known = static_cast<int>(norms.size()) - 1;
  double result = 1;
  for (; level > known; level -= known) result = up(result * norms.back());
  return up(result * norms[static_cast<std::size_t>(level)]);
}

std::vector<BallVector> Interpolation::polynomial(const std::vector<BallVector>& values, slong bits) const {
  std::vector<BallVector> result;
  for (std::size_t j = 0; j < nodes(); ++j) {
    result.emplace_back(values.front().size());
    for (std::size_t s = 0; s < nodes(); ++s) result.back().add_multiple(lagrange[s].at(j, bits), values[s]);
  }
  return result;
}

CellSetup::CellSetup(const Mask& given, const Deadline& deadline)
    : mask(given),
      arity(given.arity()),
      mirrored(has_mirrored_variance(given)),
      contraction(prove_contraction(given, deadline)),
      node_level(level_of_nodes(arity)),
      window(given),
      width(static_cast<std::size_t>(TransitionWindow(static_cast<long>(window.coefficients.size()) - 1, arity).width)),
      bits(static_cast<slong>(192 + width / 2)),
      refine(window.coefficients, arity, bits),
      at_zero(width) {
  const LimitValues integers = limit_values(mask, 0, 0, deadline);
  for (std::size_t k = 0; k < width; ++k) at_zero.set(k, Ball(integers.at(window.first + static_cast<long>(k)), bits));
}

Rational CellSetup::node_point(const Interpolation& in, std::size_t s) const {
  return Rational(in.node[s]) / Rational(int_power(arity, node_level));
}

BallVector CellSetup::values(std::int64_t index, int level) const {
  BallVector x(width), y(width);
  const bool at_one = index == int_power(arity, level);
  for (std::size_t k = at_one ? 1 : 0; k < width; ++k) x.set(at_one ? k - 1 : k, at_zero.at(k, bits));
  if (at_one) return x;
  for (; level > 0 && index % arity == 0; --level) index /= arity;
  for (; level > 0; --level, index /= arity) {
    refine.apply(static_cast<long>(index % arity), x, y);
    std::swap(x, y);
  }
  return x;
}

Interpolation CellSetup::interpolation(std::size_t degree) const {
  Interpolation in;
  in.degree = degree;
  const auto last = static_cast<double>(int_power(arity, node_level));
  for (std::size_t s = 0; s < in.nodes(); ++s)
    in.node.push_back(std::llround(
        last / 2 * (1 - std::cos(std::numbers::pi * static_cast<double>(s) / static_cast<double>(degree)))));
  for (std::size_t s = 0; s < in.nodes(); ++s) {
    const Rational here = node_point(in, s);
    LaurentPolynomial basis(1);  // in u, of positive exponents
    for (std::size_t r = 0; r < in.nodes(); ++r) {
      if (r == s) continue;
      const Rational there = node_point(in, r);
      basis *= LaurentPolynomial({(Rational(1, 2) - there) / (here - there), 1 / (here - there)}, 0);
    }
    in.lagrange.emplace_back(in.nodes());
    for (std::size_t j = 0; j < in.nodes(); ++j)
      in.lagrange.back().set(j, Ball(basis.coefficient(static_cast<long>(j)), bits));
    in.at_nodes.push_back(values(in.node[s], node_level));
  }
  return in;
}

bool CellSetup::is_piecewise_polynomial(const Interpolation& in, const Deadline& deadline) const {
  if (width > 64) return false;
  const LimitValues exact = limit_values(mask, node_level + 1, 0, deadline);
  const long last = static_cast<long>(int_power(arity, node_level)), unit = last * arity;
  for (int t = 0; t < arity; ++t)
    for (std::size_t s = 0; s < in.nodes(); ++s) {
      const long index = t * last + static_cast<long>(in.node[s]);
      const Rational x = Rational(index) / Rational(unit);
      std::vector<Rational> weights;
      for (std::size_t r = 0; r < in.nodes(); ++r) {
        Rational weight = 1;
        for (std::size_t q = 0; q < in.nodes(); ++q)
          if (q != r) weight *= (x - node_point(in, q)) / (node_point(in, r) - node_point(in, q));
        weights.push_back(weight);
      }
      for (long k = window.first; k < window.first + static_cast<long>(width); ++k) {
        Rational rest = exact.at(k * unit + index);
        for (std::size_t r = 0; r < in.nodes(); ++r)
          rest -= weights[r] * exact.at(k * unit + static_cast<long>(in.node[r]) * arity);
        if (rest != 0) return false;
      }
    }
  return true;
}

std::vector<VectorPolynomial> CellSetup::sources(const Interpolation& in) const {
  const std::int64_t last = int_power(arity, node_level);
  const std::size_t length = rows_width(), nodes = in.nodes();
  std::vector<VectorPolynomial> result;
  for (int t = 0; t < arity; ++t) {
    std::vector<BallVector> eta;
    for (std::size_t s = 0; s < nodes; ++s) {
      const std::int64_t index = t * last + in.node[s];
      BallVector rest = values(index, node_level + 1);
      const Ball at(Rational(Rational(index) / Rational(arity * last) - Rational(1, 2)), bits);
      for (std::size_t r = 0; r < nodes; ++r) {
        Ball weight(bits);
        for (std::size_t j = nodes; j-- > 0;) weight = weight * at + in.lagrange[r].at(j, bits);
        rest.add_multiple(-weight, in.at_nodes[r]);
      }
      for (int m = 0; m < order(); ++m) rest.sum_up(bits);
      eta.push_back(std::move(rest));
    }
    VectorPolynomial source{std::vector<double>(nodes * length, 0.0), std::vector<double>(nodes, 0.0), {}};
    const std::vector<BallVector> coefficients = in.polynomial(eta, bits);
    for (std::size_t j = 0; j < nodes; ++j)
      for (std::size_t k = 0; k < length; ++k)
        source.coefficients[j * length + k] = to_double(coefficients[j].at(k, bits), source.errors[j]);
    result.push_back(std::move(source));
  }
  return result;
}

}  // namespace subcert::cells
