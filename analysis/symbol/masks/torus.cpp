#include "torus.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/polynomials/box.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include "dilation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace subcert {
namespace {

constexpr long largest_order = 12;
constexpr double near_zero = 1e-9;
constexpr std::size_t most_cells = 200'000;

/// p at the point with coordinates e^(2 pi i j_v / order), as an element of Q[z] / Phi_order.
bool vanishes(const std::vector<MultivariatePolynomial::Monomial>& terms, const LatticePoint& j, long order) {
  std::vector<Rational> coefficients(static_cast<std::size_t>(order), 0);
  for (const auto& term : terms) {
    long exponent = 0;
    for (std::size_t v = 0; v < j.size(); ++v) exponent += term.exponents[v] * j[v];
    coefficients[static_cast<std::size_t>(modulo(exponent, order))] += term.coefficient;
  }
  const LaurentPolynomial value(coefficients, 0);
  return value.is_zero() || value.exact_quotient(cyclotomic(order)).has_value();
}

/// Polynomials in t with Gaussian integers.
struct Gaussian {
  Integer re = 0, im = 0;
};
using Form = std::vector<Gaussian>;

/// (1 + t^2)^n z^k for z = sign (1 + it) / (1 - it): sign^k (1 + it)^(n + k) (1 - it)^(n - k).
Form power_form(long n, long k, int sign) {
  Form form{{sign < 0 && k % 2 != 0 ? -1 : 1, 0}};
  for (long r = 0; r < 2 * n; ++r) {
    const int im = r < n + k ? 1 : -1;
    form.emplace_back();
    for (std::size_t j = form.size(); --j > 0;) {
      form[j].re -= form[j - 1].im * im;
      form[j].im += form[j - 1].re * im;
    }
  }
  return form;
}

/// The factors of the Bernstein coefficients on [-1, 1], times a positive integer.
std::vector<std::vector<Integer>> integer_bernstein_factors(long n) {
  const std::vector<Values> factors = bernstein_factors(n, -1, 1);
  Integer common = 1;
  for (const Values& row : factors)
    for (const Rational& factor : row) common = lcm(common, denominator(factor));
  std::vector<std::vector<Integer>> result;
  for (const Values& row : factors) {
    result.emplace_back();
    for (const Rational& factor : row) result.back().push_back(numerator(Rational(factor * common)));
  }
  return result;
}

/// Bytes that numbers hold.
std::size_t size_of(const Powers<Integer>& form) {
  std::size_t size = 0;
  for (const Integer& c : form.entries) size += sizeof(Integer) + (mpz_size(c.get()) + 2) * sizeof(mp_limb_t);
  return size;
}

/// Divided by the largest power of 2 that divides all entries.
void divide_by_power(Powers<Integer>& form) {
  mp_bitcnt_t power = std::numeric_limits<mp_bitcnt_t>::max();
  for (const Integer& c : form.entries)
    if (c != 0) power = std::min(power, mpz_scan1(c.get(), 0));
  if (power == 0 || power == std::numeric_limits<mp_bitcnt_t>::max()) return;
  for (Integer& c : form.entries) c >>= power;
}

class Cells {
 public:
  explicit Cells(const MultivariatePolynomial& p) : degrees_(static_cast<std::size_t>(p.variables())) {
    Integer denominator_of_all = 1;
    terms_ = p.terms();
    for (const auto& term : terms_) {
      denominator_of_all = lcm(denominator_of_all, denominator(term.coefficient));
      for (std::size_t v = 0; v < degrees_.size(); ++v)
        degrees_[v] = std::max(degrees_[v], std::abs(term.exponents[v]));
    }
    for (auto& term : terms_) term.coefficient *= denominator_of_all;
  }

  Decision run(const Budget& budget) {
    std::vector<std::pair<Powers<Integer>, std::size_t>> open;  // with the axis to be halved next
    std::size_t cells = 0, held = 0;
    const auto add = [&](Powers<Integer> form, std::size_t axis) {
      held += size_of(form);
      open.emplace_back(std::move(form), axis);
    };
    for (unsigned chart = 0; chart < 1U << degrees_.size(); ++chart) add(form(chart), 0);
    for (; !open.empty(); ++cells) {
      if (cells >= most_cells || held > budget.memory || budget.deadline.expired())
        return {Truth::unknown, fmt::format("not decided on {} cells", cells)};
      const auto [form, axis] = std::move(open.back());
      open.pop_back();
      held -= size_of(form);
      if (std::all_of(form.entries.begin(), form.entries.end(), [](const Integer& c) { return c > 0; })) continue;
      if (has_corner_that_is_not_positive(form)) return {Truth::no, "a value on a corner of a cell is not positive"};
      auto [left, right] = halved(form, axis);
      const std::size_t next = (axis + 1) % degrees_.size();
      add(std::move(left), next);
      add(std::move(right), next);
    }
    return {Truth::yes, fmt::format("by exact bounds on {} cells", cells)};
  }

 private:
  /// The Bernstein coefficients, up to a positive factor, of p times a positive function on |x_v - pi_v| <= pi / 2 with
  /// pi_v = pi where the bit of the chart is set, otherwise 0.
  Powers<Integer> form(unsigned chart) const {
    // Sums over the exponents of one variable after another; what is left are keys of the remaining exponents.
    std::map<LatticePoint, std::vector<Gaussian>> parts;
    for (const auto& term : terms_) parts[term.exponents] = {{numerator(term.coefficient), 0}};
    Powers<Integer> result;
    for (std::size_t v = 0; v < degrees_.size(); ++v) {
      std::map<LatticePoint, std::vector<Gaussian>> sums;
      std::map<long, Form> forms;
      result.sizes.push_back(static_cast<std::size_t>(2 * degrees_[v] + 1));
      for (const auto& [key, values] : parts) {
        const long k = key.front();
        if (!forms.contains(k)) forms[k] = power_form(degrees_[v], k, chart >> v & 1 ? -1 : 1);
        auto& sum = sums[LatticePoint(key.begin() + 1, key.end())];
        sum.resize(forms[k].size() * values.size());
        std::size_t at = 0;
        for (const Gaussian& x : forms[k])
          for (const Gaussian& y : values) {
            sum[at].re += x.re * y.re - x.im * y.im;
            sum[at++].im += x.re * y.im + x.im * y.re;
          }
      }
      parts = std::move(sums);
    }
    for (const Gaussian& c : parts.begin()->second) result.entries.push_back(c.re);
    for (std::size_t v = 0; v < degrees_.size(); ++v)
      result = along(result, v, integer_bernstein_factors(2 * degrees_[v]));
    return result;
  }

  static bool has_corner_that_is_not_positive(const Powers<Integer>& form) {
    for (unsigned corner = 0; corner < 1U << form.sizes.size(); ++corner) {
      std::size_t at = 0;
      for (std::size_t v = form.sizes.size(); v-- > 0;)
        at = at * form.sizes[v] + (corner >> v & 1 ? form.sizes[v] - 1 : 0);
      if (form.entries[at] <= 0) return true;
    }
    return false;
  }

  /// De Casteljau's scheme in the middle of the axis, without its divisions.
  static std::pair<Powers<Integer>, Powers<Integer>> halved(const Powers<Integer>& form, std::size_t axis) {
    const std::size_t size = form.sizes[axis], stride = form.stride(axis);
    Powers<Integer> left = form, right = form;
    std::vector<Integer> line(size);
    for (std::size_t start = 0; start < form.entries.size(); ++start) {
      if (start / stride % size != 0) continue;
      for (std::size_t j = 0; j < size; ++j) line[j] = form.entries[start + j * stride];
      for (std::size_t round = 0; round < size; ++round) {
        const long up = static_cast<long>(size - 1 - round);
        left.entries[start + round * stride] = line[0] << up;
        right.entries[start + (size - 1 - round) * stride] = line[size - 1 - round] << up;
        for (std::size_t j = 0; j + 1 + round < size; ++j) line[j] += line[j + 1];
      }
    }
    divide_by_power(left);
    divide_by_power(right);
    return {std::move(left), std::move(right)};
  }

  std::vector<MultivariatePolynomial::Monomial> terms_;  // with integer coefficients
  std::vector<long> degrees_;
};

}  // namespace

std::optional<std::string> zero_on_torus(const MultivariatePolynomial& p) {
  const auto terms = p.terms();
  const auto variables = static_cast<std::size_t>(p.variables());
  double size = 0;
  std::vector<double> values;
  for (const auto& term : terms) {
    values.push_back(term.coefficient.convert_to<double>());
    size += std::abs(values.back());
  }
  for (long order = 1; order <= largest_order; ++order)
    for (const LatticePoint& j : points_of_box(LatticePoint(variables, 0), LatticePoint(variables, order - 1))) {
      long common = order;
      for (const long c : j) common = std::gcd(common, c);
      if (common == 1) {
        double value = 0;
        for (std::size_t t = 0; t < terms.size(); ++t) {
          long exponent = 0;
          for (std::size_t v = 0; v < variables; ++v) exponent += terms[t].exponents[v] * j[v];
          value += values[t] * std::cos(2 * std::numbers::pi * static_cast<double>(modulo(exponent, order)) /
                                        static_cast<double>(order));
        }
        if (std::abs(value) < near_zero * size && vanishes(terms, j, order)) {
          std::vector<std::string> coordinates;
          for (const long c : j) coordinates.push_back(to_text(Rational(c, order)));
          return fmt::format("2 pi ({})", fmt::join(coordinates, ", "));
        }
      }
    }
  return std::nullopt;
}

Decision is_positive_on_torus(const MultivariatePolynomial& p, const Budget& budget) { return Cells(p).run(budget); }

}  // namespace subcert
