#include "vector_schemes.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace subcert {
namespace {

/// The matrices A_k by their k. Domain: square, of one size, not all zero.
LatticeMask mask_of(const std::map<long, RationalMatrix>& matrices, int arity) {
  const std::size_t size = matrices.begin()->second.rows();
  std::vector<LatticeMask::Term> terms;
  for (const auto& [k, matrix] : matrices)
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) terms.push_back({{k}, i, j, matrix(i, j)});
  return matrix_mask(terms, size, Dilation::multiple(1, arity));
}

RationalMatrix matrix_of(std::size_t size, const std::vector<Rational>& entries) {
  RationalMatrix result(size, size);
  for (std::size_t i = 0; i < entries.size(); ++i) result(i / size, i % size) = entries[i];
  return result;
}

Rational factorial_ratio(int above, int below) {
  Rational result = 1;
  for (int n = below + 1; n <= above; ++n) result *= n;
  return result;
}

/// What the data weigh in the coefficients of the polynomial, as of HermiteFit.
RationalMatrix fit_coefficients(long first, long last, int order, int degree) {
  const long count = (last - first + 1) * order;
  require(order >= 1 && degree >= 0 && degree < count, "HermiteFit: need order >= 1 and 0 <= degree < {}, got {}, {}",
          count, order, degree);
  const auto size = static_cast<std::size_t>(degree) + 1;
  RationalMatrix data(size, static_cast<std::size_t>(count));  // of the powers of x, a row for each
  for (int n = 0; n <= degree; ++n)
    for (long i = 0; i < count; ++i)
      if (const int k = static_cast<int>(i % order); n >= k)
        data(static_cast<std::size_t>(n), static_cast<std::size_t>(i)) = factorial_ratio(n, n - k) *
                                                                         power(Rational(first + i / order), n - k);
  const RationalMatrix rows = transposed(data);
  return size == rows.rows() ? solve(rows, RationalMatrix::identity(size)) : solve(data * rows, data);
}

/// Of B-splines of this degree with knots[k] = k / multiplicity, rounded down: what those that begin at the knots 0, 1,
/// ..., multiplicity - 1 are made of in the one with the index `fine` over a times as many such knots.
std::vector<Rational> knot_insertion(int degree, int multiplicity, int arity, long fine) {
  const auto knot = [&](long k) { return Rational(k / multiplicity); };
  const auto fine_knot = [&](long k) { return Rational(k / multiplicity, arity); };
  // weights[j] belongs to the B-spline of degree e that begins at knot j, e = 0, 1, ..., degree.
  std::vector<Rational> weights(static_cast<std::size_t>(multiplicity + degree), 0);
  for (std::size_t j = 0; j < weights.size(); ++j)
    if (const auto k = static_cast<long>(j); knot(k) <= fine_knot(fine) && fine_knot(fine) < knot(k + 1))
      weights[j] = 1;
  for (int e = 1; e <= degree; ++e) {
    const Rational x = fine_knot(fine + e);
    for (long j = 0; j + 1 < static_cast<long>(weights.size()); ++j) {
      const Rational up = knot(j + e) - knot(j), down = knot(j + e + 1) - knot(j + 1);
      Rational& weight = weights[static_cast<std::size_t>(j)];
      weight = (up == 0 ? Rational(0) : Rational((x - knot(j)) / up * weight)) +
               (down == 0 ? Rational(0)
                          : Rational((knot(j + e + 1) - x) / down * weights[static_cast<std::size_t>(j) + 1]));
    }
    weights.pop_back();
  }
  return weights;
}

}  // namespace

HermiteFit::HermiteFit(long first, long last, int order, int degree)
    : coefficients_(fit_coefficients(first, last, order, degree)), order_(order) {}

RationalMatrix HermiteFit::weights(const Rational& x, int arity) const {
  RationalMatrix powers(static_cast<std::size_t>(order_), coefficients_.rows());
  for (int m = 0; m < order_; ++m)
    for (int n = m; n < static_cast<int>(coefficients_.rows()); ++n)
      powers(static_cast<std::size_t>(m), static_cast<std::size_t>(n)) = factorial_ratio(n, n - m) * power(x, n - m) *
                                                                         power(Rational(arity), -m);
  return powers * coefficients_;
}

std::string merrien_matrices(std::string_view lambda, std::string_view mu) {
  return fmt::format(
      "hermite:[[[1/2,({0})],[1/2-({1})/2,({1})/4]],[[1,0],[0,1/2]],[[1/2,-({0})],[({1})/2-1/2,({1})/4]]]@-1", lambda,
      mu);
}

LatticeMask hermite_interpolation_mask(int n, int order, int arity) {
  require(n >= 1 && order >= 1 && arity >= 2,
          "hermite_interpolation_mask: need n >= 1, order >= 1, arity >= 2, got {}, {}, {}", n, order, arity);
  const auto size = static_cast<std::size_t>(order);
  std::map<long, RationalMatrix> matrices;
  RationalMatrix& scaling = matrices.emplace(0, RationalMatrix(size, size)).first->second;
  for (int m = 0; m < order; ++m)
    scaling(static_cast<std::size_t>(m), static_cast<std::size_t>(m)) = power(Rational(arity), -m);
  const HermiteFit fit(1 - n, n, order, 2 * n * order - 1);
  for (int j = 1; j < arity; ++j) {
    const RationalMatrix weights = fit.weights(Rational(j, arity), arity);
    for (int i = 0; i < 2 * n; ++i) {
      RationalMatrix& matrix = matrices.emplace(j - arity * (1 - n + i), RationalMatrix(size, size)).first->second;
      for (std::size_t k = 0; k < size; ++k)
        for (std::size_t m = 0; m < size; ++m) matrix(k, m) = weights(m, static_cast<std::size_t>(i) * size + k);
    }
  }
  return mask_of(matrices, arity);
}

LatticeMask multiple_knot_bspline_mask(int degree, int multiplicity, int arity) {
  require(1 <= multiplicity && multiplicity <= degree && arity >= 2,
          "multiple_knot_bspline_mask: need 1 <= multiplicity <= degree and arity >= 2, got {}, {}, {}", multiplicity,
          degree, arity);
  const auto size = static_cast<std::size_t>(multiplicity);
  std::map<long, RationalMatrix> matrices;
  const long last = arity * ((degree + multiplicity) / multiplicity);  // the last knot of all, in fine steps
  for (long k = 0; k < last; ++k) {
    RationalMatrix& matrix = matrices.emplace(k, RationalMatrix(size, size)).first->second;
    for (int c = 0; c < multiplicity; ++c) {
      const std::vector<Rational> column = knot_insertion(degree, multiplicity, arity, k * multiplicity + c);
      for (std::size_t row = 0; row < size; ++row) matrix(row, static_cast<std::size_t>(c)) = column[row];
    }
  }
  return mask_of(matrices, arity);
}

LatticeMask geronimo_hardin_massopust_mask() {
  const auto twentieths = [](const std::vector<Rational>& entries) { return Rational(1, 20) * matrix_of(2, entries); };
  return mask_of({{0, twentieths({12, 32, -1, -6})},
                  {1, twentieths({12, 0, 9, 20})},
                  {2, twentieths({0, 0, 9, -6})},
                  {3, twentieths({0, 0, -1, 0})}},
                 2);
}

namespace {

/// p + q sqrt(root), by its two numbers.
struct Pair {
  long rational, root = 0;
};

/// Of matrices of two rows, row by row, A_0 first, over a common denominator.
QuadraticMask quadratic_pairs(long root, long denominator, const std::vector<std::vector<Pair>>& matrices) {
  std::vector<QuadraticTerm> terms;
  for (std::size_t k = 0; k < matrices.size(); ++k)
    for (std::size_t i = 0; i < 4; ++i)
      terms.push_back({{static_cast<long>(k)},
                       i / 2,
                       i % 2,
                       Rational(matrices[k][i].rational, denominator),
                       Rational(matrices[k][i].root, denominator)});
  return quadratic_mask(terms, 2, root, Dilation::multiple(1, 2));
}

/// The second half of matrices that are those of the first half, last first, with both components exchanged.
std::vector<std::vector<Pair>> mirrored(std::vector<std::vector<Pair>> matrices) {
  for (std::size_t k = matrices.size() - 1; k-- > 0;) {
    matrices.push_back(matrices[k]);
    std::ranges::reverse(matrices.back());
  }
  return matrices;
}

}  // namespace

QuadraticMask chui_lian_mask(int length) {
  require(length == 2 || length == 3, "chui_lian_mask: need 2 or 3, got {}", length);
  if (length == 2)
    return quadratic_pairs(7, 4, {{{2}, {2}, {0, -1}, {0, -1}}, {{4}, {0}, {0}, {2}}, {{2}, {-2}, {0, 1}, {0, -1}}});
  return quadratic_pairs(10, 40,
                         {{{10, -3}, {5, -1}, {30, -9}, {5, -3}},
                          {{30, 3}, {5, -1}, {-30, -21}, {15, -3}},
                          {{30, 3}, {-5, 1}, {30, 21}, {15, -3}},
                          {{10, -3}, {-5, 1}, {-30, 9}, {5, -3}}});
}

QuadraticMask shen_tan_tham_mask() {
  const Pair large{4, 1}, small{4, -1};
  return quadratic_pairs(15, 8,
                         {{small, {1}, small, {-1}},
                          {large, {1}, {-4, -1}, {1}},
                          {large, {-1}, large, {1}},
                          {small, {-1}, {-4, 1}, {-1}}});
}

QuadraticMask balanced_mask(int order) {
  require(1 <= order && order <= 3, "balanced_mask: need an order from 1 to 3, got {}", order);
  if (order == 1) return quadratic_pairs(7, 4, mirrored({{{0}, {2, 1}, {0}, {2, -1}}, {{3}, {1}, {1}, {3}}}));
  if (order == 2)
    return quadratic_pairs(31, 320,
                           mirrored({{{0}, {-31, 1}, {0}, {-13, 3}},
                                     {{93, -13}, {217, 23}, {-1, 1}, {11, -11}},
                                     {{341, -11}, {23, 7}, {23, 7}, {341, -11}}}));
  return quadratic_pairs(15199, 1116160,
                         mirrored({{{0}, {-2989, 97}, {0}, {12405, -105}},
                                   {{537, 69}, {-75969, -525}, {-23505, 195}, {13769, -43}},
                                   {{73925, 551}, {1202922, -882}, {22083, -111}, {-192186, 450}},
                                   {{901278, 1638}, {300050, -1334}, {300050, -1334}, {901278, 1638}}}));
}

LatticeMask vector_tensor_product(const std::vector<LatticeMask>& factors) {
  require(factors.size() == 2 || factors.size() == 3, "tensor product: need two or three factors, got {}",
          factors.size());
  std::vector<LatticeMask::Term> terms{{{}, 0, 0, 1}};
  std::vector<LatticePoint> rows;
  std::size_t size = 1, variables = 0;
  for (const LatticeMask& factor : factors) variables += factor.dilation().variables();
  for (const LatticeMask& factor : factors) {
    const std::size_t inner = factor.components(), before = rows.size();
    std::vector<LatticeMask::Term> next;
    for (const LatticeMask::Term& a : terms)
      for (const LatticeMask::Term& b : factor.terms()) {
        next.push_back(
            {a.exponents, a.row * inner + b.row, a.column * inner + b.column, a.coefficient * b.coefficient});
        next.back().exponents.insert(next.back().exponents.end(), b.exponents.begin(), b.exponents.end());
      }
    terms = std::move(next);
    size *= inner;
    for (const LatticePoint& row : factor.dilation().rows()) {
      rows.emplace_back(variables, 0);
      std::ranges::copy(row, rows.back().begin() + static_cast<long>(before));
    }
  }
  return matrix_mask(terms, size, Dilation(std::move(rows)));
}

}  // namespace subcert
