#include "grid_holes.hpp"

#include <subcert/analysis/symbol/support/parallel.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace subcert::data {
namespace {

constexpr double least_pivot = 1e-7;
constexpr std::size_t outputs_per_thread = 64;

/// The symmetric matrix G of a window, row by row, and its Cholesky factor in the same place.
class GramMatrix {
 public:
  explicit GramMatrix(std::size_t size) : size_(size), entries_(size * size) {
    for (std::size_t k = 0; k < size; ++k) entries_[k * size + k] = 1;
  }
  void take_out(const std::vector<double>& u) {
    for (std::size_t a = 0; a < size_; ++a)
      for (std::size_t b = 0; b <= a; ++b) entries_[a * size_ + b] -= u[a] * u[b];
  }
  /// Whether it is not singular.
  bool factor() {
    for (std::size_t a = 0; a < size_; ++a)
      for (std::size_t b = 0; b <= a; ++b) {
        double sum = at(a, b);
        for (std::size_t c = 0; c < b; ++c) sum -= at(a, c) * at(b, c);
        if (a == b && !(sum > least_pivot)) return false;
        entries_[a * size_ + b] = a == b ? std::sqrt(sum) : sum / at(b, b);
      }
    return true;
  }
  /// Domain: after factor().
  void solve(std::vector<double>& x) const {
    for (std::size_t a = 0; a < size_; ++a) {
      for (std::size_t c = 0; c < a; ++c) x[a] -= at(a, c) * x[c];
      x[a] /= at(a, a);
    }
    for (std::size_t a = size_; a-- > 0;) {
      for (std::size_t c = a + 1; c < size_; ++c) x[a] -= at(c, a) * x[c];
      x[a] /= at(a, a);
    }
  }

 private:
  double at(std::size_t a, std::size_t b) const { return entries_[a * size_ + b]; }

  std::size_t size_;
  std::vector<double> entries_;
};

/// The fit at one output, from the bases along the axes.
class Window {
 public:
  Window(const GridHoles& holes, const LocalBasis& x, const LocalBasis& y, const LocalBasis& z)
      : holes_(holes), along_{&x, &y, &z} {}

  bool has_missing() const {
    bool found = false;
    visit_lines([&](std::size_t line, std::size_t, std::size_t) {
      for (std::size_t a = 0; !found && line != LocalBasis::outside && a < along_[0]->data.size(); ++a)
        found = is_missing(point_of(line, a));
    });
    return found;
  }

  /// `sums` is as long as the grid has points, of zeros, before and after.
  GridRow row(std::size_t output, std::vector<double>& sums) const {
    GridRow result{output};
    std::vector<double> solution, u;
    const auto& [x, y, z] = along_;
    set_products(solution, [&](std::size_t axis, std::size_t k) { return along_[axis]->at[k]; });
    GramMatrix gram(solution.size());
    visit_lines([&](std::size_t line, std::size_t b, std::size_t c) {
      if (line == LocalBasis::outside) return;
      for (std::size_t a = 0; a < x->data.size(); ++a) {
        if (!is_missing(point_of(line, a))) continue;
        const std::array<std::size_t, 3> at{a, b, c};
        set_products(u, [&](std::size_t axis, std::size_t k) { return along_[axis]->values[k][at[axis]]; });
        gram.take_out(u);
      }
    });
    if (!gram.factor()) return result;
    result.known = true;
    gram.solve(solution);
    std::vector<double> of_line(x->at.size());
    visit_lines([&](std::size_t line, std::size_t b, std::size_t c) {
      set_sums(of_line, solution, b, c);
      const double root = y->roots[b] * z->roots[c];
      for (std::size_t a = 0; a < x->data.size(); ++a) {
        const std::size_t point = point_of(line, a);
        if (is_missing(point)) continue;
        double weight = 0;
        for (std::size_t k = 0; k < of_line.size(); ++k) weight += of_line[k] * x->values[k][a];
        weight *= root * x->roots[a];
        if (point == LocalBasis::outside) {
          result.outside += weight;
          continue;
        }
        if (sums[point] == 0) result.terms.emplace_back(point, 0);
        sums[point] += weight;
      }
    });
    for (auto& [point, weight] : result.terms) {
      weight = std::exchange(sums[point], 0);
      result.variance += weight * weight;
    }
    return result;
  }

 private:
  /// Calls take(number of the first point or `outside`, index in the second basis, in the third) for each line along
  /// the first axis.
  template <class Take>
  void visit_lines(const Take& take) const {
    const auto& [x, y, z] = along_;
    for (std::size_t c = 0; c < z->data.size(); ++c)
      for (std::size_t b = 0; b < y->data.size(); ++b) {
        const bool inside = y->data[b] != LocalBasis::outside && z->data[c] != LocalBasis::outside;
        take(inside ? (z->data[c] * holes_.counts[1] + y->data[b]) * holes_.counts[0] : LocalBasis::outside, b, c);
      }
  }
  std::size_t point_of(std::size_t line, std::size_t a) const {
    const std::size_t datum = along_[0]->data[a];
    return line == LocalBasis::outside || datum == LocalBasis::outside ? LocalBasis::outside : line + datum;
  }
  bool is_missing(std::size_t point) const { return point != LocalBasis::outside && holes_.missing[point]; }

  /// The products of value(axis, k), k of the first axis fastest.
  template <class Value>
  void set_products(std::vector<double>& u, const Value& value) const {
    u.clear();
    for (std::size_t c = 0; c < along_[2]->at.size(); ++c)
      for (std::size_t b = 0; b < along_[1]->at.size(); ++b) {
        const double outer = value(2, c) * value(1, b);
        for (std::size_t a = 0; a < along_[0]->at.size(); ++a) u.push_back(outer * value(0, a));
      }
  }

  /// [k]: what of the products of the solution with the values of a line belongs to the polynomial k of the first axis.
  void set_sums(std::vector<double>& sums, const std::vector<double>& solution, std::size_t b, std::size_t c) const {
    const auto& [x, y, z] = along_;
    std::ranges::fill(sums, 0);
    auto next = solution.begin();
    for (std::size_t l = 0; l < z->at.size(); ++l)
      for (std::size_t m = 0; m < y->at.size(); ++m) {
        const double outer = z->values[l][c] * y->values[m][b];
        for (double& sum : sums) sum += outer * *next++;
      }
  }

  const GridHoles& holes_;
  std::array<const LocalBasis*, 3> along_;
};

}  // namespace

LocalBasis trivial_basis() { return {{0}, {1}, {{1}}, {1}}; }

void fit_around_holes(const GridHoles& holes, const std::array<std::vector<LocalBasis>, 3>& along, int threads,
                      const std::function<void(const GridRow&)>& take) {
  const auto& [x, y, z] = along;
  const std::size_t outputs = x.size() * y.size() * z.size();
  parallel_ranges(outputs, outputs / outputs_per_thread, threads, [&](std::size_t begin, std::size_t end) {
    std::vector<double> sums(holes.missing.size());
    for (std::size_t o = begin; o < end; ++o) {
      const Window window(holes, x[o % x.size()], y[o / x.size() % y.size()], z[o / x.size() / y.size()]);
      if (window.has_missing()) take(window.row(o, sums));
    }
  });
}

}  // namespace subcert::data
