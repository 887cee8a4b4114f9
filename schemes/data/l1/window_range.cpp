// The line of weights w is the mean of the lines through two data, weighted by w_r w_s (x_r - x_s)^2, or as well by
// (x_r - x_s)^2 times the product of u_t = 1/w_t = (t^2 + e^2)^(1/2) at all other data, e the root of delta. As a
// function of one u_t each mean is a quotient of linear ones, hence monotone: its ends on a box of the u_t are at the
// corners (docs/l1.md, Theorem 7).
//
// Rounding: a weight is off by less than a part 2^-45, a sum by less than 2^-45 times the sum of the moduli; so a mean
// of numbers of modulus B at most is off by less than 2^-42 B. All ends are moved by `slack` = 2^-36 B.

#include "window_range.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace subcert::data {
namespace {

using Form = std::vector<double>;  // in the second differences

Form combined(double a, const Form& x, double b, const Form& y) {
  Form result;
  for (std::size_t j = 0; j < x.size(); ++j) result.push_back(a * x[j] + b * y[j]);
  return result;
}

/// The points + 1 data by their second differences, up to a line: those of a window do not depend on the difference
/// that the other one has for itself, and near the middle they are small.
std::vector<Form> data_forms(std::size_t count) {
  std::vector<Form> data(count, Form(count - 2, 0));
  const std::size_t middle = (count - 1) / 2;
  const double before = count == 4 ? 1 : 0.5;  // of 3 points no difference is of both windows
  data[middle - 1][middle - 1] = before;
  data[middle + 1][middle - 1] = 1 - before;
  const auto extend = [&](std::size_t to, std::size_t near, std::size_t far, std::size_t difference) {
    data[to] = combined(2, data[near], -1, data[far]);
    data[to][difference] += 1;
  };
  for (std::size_t j = middle + 2; j < count; ++j) extend(j, j - 1, j - 2, j - 2);
  for (std::size_t j = middle - 1; j-- > 0;) extend(j, j + 1, j + 2, j);
  return data;
}

/// The residuals of the line through two data of a window, and the parts that its outputs have in both second
/// differences.
std::vector<Form> pair_forms(const std::vector<Form>& data, std::size_t window, std::size_t points, std::size_t r,
                             std::size_t s) {
  const auto line = [&](double x) {
    const double part = (x - static_cast<double>(r)) / static_cast<double>(s - r);
    return combined(1 - part, data[window + r], part, data[window + s]);
  };
  std::vector<Form> forms;
  for (std::size_t t = 0; t < points; ++t)
    forms.push_back(t == r || t == s ? Form(data[0].size(), 0)
                                     : combined(1, data[window + t], -1, line(static_cast<double>(t))));
  const double centre = static_cast<double>(points - 1) / 2;
  const Form left = line(centre - 0.25), right = line(centre + 0.25);
  // The outputs are a_0, a_1 of the first window and b_0, b_1 of the second one: a_0 - 2 a_1 + b_0, a_1 - 2 b_0 + b_1.
  forms.push_back(window == 0 ? combined(1, left, -2, right) : left);
  forms.push_back(window == 0 ? right : combined(1, right, -2, left));
  return forms;
}

double sum_of_moduli(const Form& form) {
  double sum = 0;
  for (const double entry : form) sum += std::abs(entry);
  return sum;
}

typedef double Lanes __attribute__((vector_size(32), may_alias));
constexpr std::size_t lanes = 4;
constexpr std::size_t in_lanes(std::size_t numbers) { return (numbers + lanes - 1) / lanes; }

/// What the means at all corners are made of, for N points; `u` are relative to the largest one.
template <std::size_t N>
struct Means {
  static constexpr std::size_t pairs = N * (N - 1) / 2;
  static constexpr std::size_t values = in_lanes(2 * (N + 2));
  struct Weights {
    Lanes of[in_lanes(pairs)] = {};
    double& operator[](std::size_t pair) { return reinterpret_cast<double*>(of)[pair]; }
  };

  Weights squares;                  // of the distances
  Weights inside[N], outside[N];    // 1 where the pair contains the datum and where not, else 0
  Lanes value[pairs][values] = {};  // of each quantity the lower end and minus the upper end
  std::array<Ends, N> u{};
  Lanes least[values] = {};  // of the means
};

/// Goes through the corners of the u_t, t >= T. Where three or more u tend to 0, the lines through two data of theirs
/// are the mean, in any proportion, as all other weights are of a smaller order: so these corners are between those
/// where two are 0, and are left out. (No upper end is 0.)
template <std::size_t T, std::size_t N>
[[gnu::always_inline]] inline void go_through_corners(Means<N>& means, typename Means<N>::Weights& weights, int zeros) {
  using M = Means<N>;
  if constexpr (T == N) {
    if (zeros >= 3) return;
    Lanes sums[M::values] = {};
    double total = 0;
    for (std::size_t i = 0; i < M::pairs; ++i) {
      total += weights[i];
      for (std::size_t k = 0; k < M::values; ++k) sums[k] += weights[i] * means.value[i][k];
    }
    const double inverse = 1 / total;
    for (std::size_t k = 0; k < M::values; ++k) {
      const Lanes mean = sums[k] * inverse;
      means.least[k] = mean < means.least[k] ? mean : means.least[k];
    }
  } else {
    const Ends& u = means.u[T];
    for (const bool upper : {false, true}) {
      if (!upper && u.lower == u.upper) continue;
      const double end = upper ? u.upper : u.lower;
      typename M::Weights next;
      for (std::size_t i = 0; i < in_lanes(M::pairs); ++i)
        next.of[i] = weights.of[i] * (means.inside[T].of[i] + means.outside[T].of[i] * end);
      go_through_corners<T + 1>(means, next, zeros + (end == 0 ? 1 : 0));
    }
  }
}

template <std::size_t N>
[[gnu::always_inline]] inline void find_means_inline(Means<N>& means) {
  go_through_corners<0>(means, means.squares, 0);
}

template <std::size_t N>
void find_means_portable(Means<N>& means) {
  find_means_inline(means);
}

#if defined(__x86_64__) && defined(__GNUC__)
template <std::size_t N>
[[gnu::target("avx2")]] void find_means_wide(Means<N>& means) {
  find_means_inline(means);
}
const bool use_wide = __builtin_cpu_supports("avx2") != 0;
#endif

template <std::size_t N>
void find_means(Means<N>& means) {
#if defined(__x86_64__) && defined(__GNUC__)
  if (use_wide) return find_means_wide(means);
#endif
  find_means_portable(means);
}

template <std::size_t N>
class Window final : public WindowRange {
 public:
  explicit Window(std::size_t which) {
    const std::vector<Form> data = data_forms(N + 1);
    double largest = 0;
    for (std::size_t r = 0, i = 0; r < N; ++r)
      for (std::size_t s = r + 1; s < N; ++s, ++i) {
        forms_.push_back(pair_forms(data, which, N, r, s));
        for (const Form& form : forms_.back()) largest = std::max(largest, sum_of_moduli(form));
        means_.squares[i] = static_cast<double>((s - r) * (s - r));
        means_.inside[r][i] = means_.inside[s][i] = 1;
      }
    for (std::size_t t = 0; t < N; ++t)
      for (std::size_t i = 0; i < in_lanes(M::pairs); ++i) means_.outside[t].of[i] = 1 - means_.inside[t].of[i];
    slack_ = std::ldexp(largest * largest_datum, -36);
  }

  Parts parts(const DifferenceBox& box, int fits) override {
    set_values(box);
    means_.u.fill({1, 1});
    Parts result;
    for (int fit = 0; fit <= fits; ++fit) {
      for (Lanes& least : means_.least) least = Lanes{} + std::numeric_limits<double>::infinity();
      find_means(means_);
      for (std::size_t k = 0; k < 2; ++k) {
        const Ends part = mean(N + k);
        result[k] = fit == 0 ? part
                             : Ends{std::min(result[k].lower, part.lower), std::max(result[k].upper, part.upper)};
      }
      if (fit < fits) set_inverse_weights(box.root);
    }
    return result;
  }

 private:
  using M = Means<N>;

  void set_values(const DifferenceBox& box) {
    for (std::size_t i = 0; i < M::pairs; ++i)
      for (std::size_t k = 0; k < N + 2; ++k) {
        double lower = -slack_, minus_upper = -slack_;
        const Form& form = forms_[i][k];
        for (std::size_t j = 0; j < form.size(); ++j) {
          const Ends& d = box.differences[j];
          lower += form[j] * (form[j] > 0 ? d.lower : d.upper);
          minus_upper -= form[j] * (form[j] > 0 ? d.upper : d.lower);
        }
        means_.value[i][2 * k / lanes][2 * k % lanes] = lower;
        means_.value[i][2 * k / lanes][2 * k % lanes + 1] = minus_upper;
      }
  }

  Ends mean(std::size_t which) const {
    const Lanes& least = means_.least[2 * which / lanes];
    const std::size_t at = 2 * which % lanes;
    return {least[at] - slack_, -least[at + 1] + slack_};
  }

  /// (t^2 + e^2)^(1/2), relative to the largest.
  void set_inverse_weights(const Ends& root) {
    double largest = 0;
    for (std::size_t t = 0; t < N; ++t) {
      const Ends residual = mean(t);
      const double least = std::max({0.0, residual.lower, -residual.upper});
      const double most = std::max(-residual.lower, residual.upper);
      means_.u[t] = {std::sqrt(least * least + root.lower * root.lower),
                     std::sqrt(most * most + root.upper * root.upper)};
      largest = std::max(largest, means_.u[t].upper);
    }
    for (Ends& u : means_.u) u = {u.lower <= 0x1p-100 * largest ? 0 : u.lower / largest, u.upper / largest};
  }

  std::vector<std::vector<Form>> forms_;  // of each pair
  Means<N> means_;
  double slack_ = 0;
};

}  // namespace

std::unique_ptr<WindowRange> window_range(int points, std::size_t which) {
  switch (points) {
    case 3: return std::make_unique<Window<3>>(which);
    case 4: return std::make_unique<Window<4>>(which);
    case 5: return std::make_unique<Window<5>>(which);
    case 6: return std::make_unique<Window<6>>(which);
    case 7: return std::make_unique<Window<7>>(which);
    default: return std::make_unique<Window<8>>(which);
  }
}

}  // namespace subcert::data
