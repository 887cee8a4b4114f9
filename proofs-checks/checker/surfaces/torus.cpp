#include "torus.hpp"

#include <algorithm>

namespace subcert_check {
namespace {

constexpr std::size_t max_cell_entries = 1UL << 15, max_depth = 60;
constexpr std::size_t precision = 256;  // bits of the largest coefficient of a cell

struct Gaussian {
  mpz_class re, im;
};

/// (1 + t^2)^n e^(ikx) for x = 2 arctan t, t = 2u - 1: (1 + it)^(n+k) (1 - it)^(n-k), as the coefficients of
/// u^j (1-u)^(2n-j).
std::vector<Gaussian> power_form(std::size_t n, std::size_t n_plus_k) {
  std::vector<Gaussian> form{{1, 0}};
  for (std::size_t r = 0; r < 2 * n; ++r) {
    const int s = r < n_plus_k ? 1 : -1;  // times 1 + sit = (1 - si)(1 - u) + (1 + si) u
    form.push_back({0, 0});
    for (std::size_t j = form.size(); j-- > 0;) {
      const Gaussian x = form[j], y = j > 0 ? form[j - 1] : Gaussian{0, 0};
      form[j] = {x.re + y.re + s * (x.im - y.im), x.im + y.im + s * (y.re - x.re)};
    }
  }
  return form;
}

/// Values on a box of three axes, the first running fastest.
template <class Value>
struct Box {
  std::array<std::size_t, 3> sizes;
  std::vector<Value> values;

  /// change(line) of all lines along an axis.
  template <class Change>
  void along(std::size_t axis, Change change) {
    std::size_t stride = 1;
    for (std::size_t v = 0; v < axis; ++v) stride *= sizes[v];
    std::vector<Value> line(sizes[axis]);
    for (std::size_t start = 0; start < values.size(); ++start) {
      if (start / stride % sizes[axis] != 0) continue;
      for (std::size_t j = 0; j < line.size(); ++j) line[j] = values[start + j * stride];
      change(line);
      for (std::size_t j = 0; j < line.size(); ++j) values[start + j * stride] = line[j];
    }
  }
};

/// A polynomial on [0, 1]^3, by the coefficients of the products of u_v^j (1 - u_v)^(n_v - j): positive coefficients
/// prove that it is positive; otherwise both halves of the cell, the axes taking turns.
class Cells {
 public:
  Cells(std::size_t variables, const std::string& what, Arithmetic& arithmetic)
      : variables_(variables), what_(what), arithmetic_(arithmetic) {}

  void check(Box<mpz_class> cell) {
    std::size_t largest = 0;
    for (const mpz_class& value : cell.values) largest = std::max(largest, bits(value));
    // Rounded down: what is shown to be positive is not larger.
    for (mpz_class& value : cell.values)
      if (largest > precision) value >>= largest - precision;
    check_cell(cell, 0);
  }

 private:
  void check_cell(const Box<mpz_class>& cell, std::size_t depth) {
    const auto positive = [](const mpz_class& c) { return c > 0; };
    if (std::all_of(cell.values.begin(), cell.values.end(), positive)) return;
    // The coefficients at the ends of all axes are values at corners.
    for (unsigned corner = 0; corner < 8; ++corner) {
      std::size_t at = 0;
      for (std::size_t v = 3; v-- > 0;) at = at * cell.sizes[v] + (corner >> v & 1 ? cell.sizes[v] - 1 : 0);
      require(positive(cell.values[at]), what_ + " is not positive");
    }
    require(depth < max_depth, what_ + " is not shown to be positive");
    for (const bool right : {false, true}) {
      Box<mpz_class> half = cell;
      half.along(depth % variables_, [&](Vector& line) {
        const std::size_t n = line.size() - 1;
        arithmetic_.spend((n + 1) * (n + 1) * (10 + mpz_size(line[0].get_mpz_t())) +
                          80 * n * mpz_size(line[0].get_mpz_t()));
        if (right) std::reverse(line.begin(), line.end());
        for (std::size_t k = n; k > 0; --k)  // 1 - u becomes 2 (1 - u) + u
          for (std::size_t j = 1; j <= k; ++j) line[j] += line[j - 1];
        for (std::size_t j = 0; j <= n; ++j) line[j] <<= n - j;
        if (right) std::reverse(line.begin(), line.end());
      });
      check_cell(half, depth + 1);
    }
  }

  std::size_t variables_;
  const std::string& what_;
  Arithmetic& arithmetic_;
};

/// Section 5.5: sum_k g_k e^(ikx) > 0 for all x, for g_{-k} = g_k.
class Positivity {
 public:
  Positivity(const Sequence& g, std::size_t variables, Arithmetic& arithmetic)
      : g_(g), variables_(variables), arithmetic_(arithmetic) {
    std::size_t entries = 1;
    for (const auto& [place, value] : g)
      for (std::size_t v = 0; v < 3; ++v)
        half_[v] = std::max(half_[v], static_cast<std::size_t>(std::abs(place.point[v])));
    for (std::size_t v = 0; v < 3; ++v) {
      const std::size_t n = half_[v];
      require((entries *= sizes_[v] = 2 * n + 1) <= max_cell_entries, too_much_work);
      arithmetic_.spend(sizes_[v] * sizes_[v] * sizes_[v] * (20 + n));
      for (std::size_t k = 0; k <= 2 * n; ++k) forms_[v].push_back(power_form(n, k));
    }
  }
  void check() {
    const std::string what = "stability: the sum over the gram line";
    for (unsigned chart = 0; chart < 1U << variables_; ++chart) Cells(variables_, what, arithmetic_).check(form(chart));
  }

 private:
  /// On |x_v - pi_v| <= pi/2, pi_v = pi where the bit of the chart is set, otherwise 0; times a positive function.
  Box<mpz_class> form(unsigned chart) {
    Box<Gaussian> sum{sizes_, std::vector<Gaussian>(sizes_[0] * sizes_[1] * sizes_[2])};
    for (const auto& [place, value] : g_) {
      const Point& point = place.point;
      std::size_t at = 0, sign = 0;
      for (std::size_t v = 3; v-- > 0;) {
        at = at * sum.sizes[v] + static_cast<std::size_t>(point[v] + static_cast<std::int64_t>(half_[v]));
        if (chart >> v & 1) sign += static_cast<std::size_t>(std::abs(point[v]));
      }
      sum.values[at].re = sign % 2 == 0 ? value : mpz_class(-value);
    }
    for (std::size_t v = 0; v < variables_; ++v) {
      sum.along(v, [&](std::vector<Gaussian>& line) {
        std::vector<Gaussian> result(line.size());
        for (std::size_t k = 0; k < line.size(); ++k) {
          if (line[k].re == 0 && line[k].im == 0) continue;
          for (std::size_t j = 0; j < line.size(); ++j) {
            const Gaussian& form = forms_[v][k][j];
            arithmetic_.add_product(result[j].re, line[k].re, form.re);
            arithmetic_.add_product(result[j].re, -line[k].im, form.im);
            arithmetic_.add_product(result[j].im, line[k].re, form.im);
            arithmetic_.add_product(result[j].im, line[k].im, form.re);
          }
        }
        line = std::move(result);
      });
    }
    Box<mpz_class> real{sum.sizes, {}};
    for (const Gaussian& value : sum.values) real.values.push_back(value.re);
    return real;
  }

  const Sequence& g_;
  std::size_t variables_;
  Arithmetic& arithmetic_;
  std::array<std::size_t, 3> half_{}, sizes_{};              // n, and 2n + 1, along the axes
  std::array<std::vector<std::vector<Gaussian>>, 3> forms_;  // by axis and n + k
};

}  // namespace

void check_positive(const Sequence& g, std::size_t variables, Arithmetic& arithmetic) {
  Positivity(g, variables, arithmetic).check();
}

void check_positive_form(const Vector& form, const std::string& what, Arithmetic& arithmetic) {
  require(form.size() <= max_cell_entries, too_much_work);
  Cells(1, what, arithmetic).check({{form.size(), 1, 1}, form});
}

}  // namespace subcert_check
