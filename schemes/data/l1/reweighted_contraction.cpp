// A second difference of the next level depends on two windows, that is, on the second differences d of points + 1
// data. By homogeneity one of them is 1, the others are in [-1, 1], and e = delta^(1/2) is in [0, 1/radius]: where e is
// larger, l1_basin() says it. These boxes are cut until the bound holds on each (docs/l1.md, Theorem 7).
//
// The line of weights w is the mean of the lines through two data, weighted by w_r w_s (x_r - x_s)^2, or as well by
// (x_r - x_s)^2 times the product of u_t = 1/w_t = (t^2 + e^2)^(1/2) at all other data. As a function of one u_t each
// mean is a quotient of linear ones, hence monotone: its ends on a box of the u_t are at the corners.
//
// Rounding: a weight is off by less than a part 2^-45, a sum by less than 2^-45 times the sum of the moduli; so a mean
// of numbers of modulus B at most is off by less than 2^-42 B. All ends are moved by `slack` = 2^-36 B.

#include "reweighted_contraction.hpp"

#include "l1_basin.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace subcert::data {
namespace {

using Form = std::vector<double>;  // in the second differences

using Interval = Ends;
using Box = DifferenceBox;

/// Contains both.
Interval joined(const Interval& a, const Interval& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

Form combined(double a, const Form& x, double b, const Form& y) {
  Form result;
  for (std::size_t j = 0; j < x.size(); ++j) result.push_back(a * x[j] + b * y[j]);
  return result;
}

/// The points + 1 data by their second differences, with zeros in their second differences elsewhere: near the middle
/// they are small.
std::vector<Form> data_forms(std::size_t count) {
  std::vector<Form> data(count, Form(count - 2, 0));
  const std::size_t middle = (count - 1) / 2;
  data[middle - 1][middle - 1] = data[middle + 1][middle - 1] = 0.5;
  const auto extend = [&](std::size_t to, std::size_t near, std::size_t far, std::size_t difference) {
    data[to] = combined(2, data[near], -1, data[far]);
    data[to][difference] += 1;
  };
  for (std::size_t j = middle + 2; j < count; ++j) extend(j, j - 1, j - 2, j - 2);
  for (std::size_t j = middle - 1; j-- > 0;) extend(j, j + 1, j + 2, j);
  return data;
}

/// Two data of a window, and what follows from the line through them.
struct Pair {
  std::size_t r, s;
  double square;                  // of their distance
  std::vector<Form> residuals;    // [datum]
  std::vector<Form> differences;  // [0, 1]: the part that this window has in both second differences
};

Pair make_pair(const std::vector<Form>& data, std::size_t window, std::size_t points, std::size_t r, std::size_t s) {
  const auto distance = static_cast<double>(s - r);
  const auto line = [&](double x) {
    const double part = (x - static_cast<double>(r)) / distance;
    return combined(1 - part, data[window + r], part, data[window + s]);
  };
  Pair pair{r, s, distance * distance, {}, {}};
  for (std::size_t t = 0; t < points; ++t)
    pair.residuals.push_back(t == r || t == s ? Form(data[0].size(), 0)
                                              : combined(1, data[window + t], -1, line(static_cast<double>(t))));
  const double centre = static_cast<double>(points - 1) / 2;
  const Form left = line(centre - 0.25), right = line(centre + 0.25);
  // The outputs are a_0, a_1 of the first window and b_0, b_1 of the second one: a_0 - 2 a_1 + b_0, a_1 - 2 b_0 + b_1.
  if (window == 0)
    pair.differences = {combined(1, left, -2, right), right};
  else
    pair.differences = {left, combined(1, right, -2, left)};
  return pair;
}

double sum_of_moduli(const Form& form) {
  double sum = 0;
  for (const double entry : form) sum += std::abs(entry);
  return sum;
}

/// The weights of the pairs at a corner of a box, or those that may have any.
struct Corner {
  bool any_proportion;
  std::vector<double> weights;
};

class BoxSearch {
 public:
  BoxSearch(int points, int fits, double bound, const ReweightedOptions& options)
      : points_(static_cast<std::size_t>(points)), fits_(fits), bound_(bound), options_(options) {
    const std::vector<Form> data = data_forms(points_ + 1);
    double largest = 0;
    for (std::size_t window = 0; window < 2; ++window)
      for (std::size_t r = 0; r < points_; ++r)
        for (std::size_t s = r + 1; s < points_; ++s) {
          pairs_[window].push_back(make_pair(data, window, points_, r, s));
          for (const auto* forms : {&pairs_[window].back().residuals, &pairs_[window].back().differences})
            for (const Form& form : *forms) largest = std::max(largest, sum_of_moduli(form));
        }
    slack_ = std::ldexp(largest, -36);
    corners_.assign(std::size_t{1} << points_, {false, std::vector<double>(pairs_[0].size())});
  }

  /// Whether both second differences are at most the bound on all of the box.
  bool holds(Box& box) {
    if (++boxes_ > options_.most_boxes || options_.deadline.expired()) return false;
    if (largest_difference(box) <= bound_) return true;
    return halves(box, [&](Box& half) { return holds(half); });
  }

  /// Of all numbers of fits in each window.
  std::array<Ends, 2> differences(const Box& box) {
    std::array<Ends, 2> total{Ends{0, 0}, Ends{0, 0}};
    for (const std::vector<Pair>& pairs : pairs_) {
      std::vector<Interval> inverse_weights(points_, {1, 1});
      std::array<Ends, 2> parts{};
      for (int fit = 0; fit <= fits_; ++fit) {
        set_weights(pairs, inverse_weights);
        for (std::size_t k = 0; k < 2; ++k) {
          const Interval part = mean_of(pairs, box, &Pair::differences, k);
          parts[k] = fit == 0 ? part : joined(parts[k], part);
        }
        for (std::size_t t = 0; t < points_ && fit < fits_; ++t)
          inverse_weights[t] = inverse_weight(mean_of(pairs, box, &Pair::residuals, t), box.root);
      }
      for (std::size_t k = 0; k < 2; ++k) total[k] = {total[k].lower + parts[k].lower, total[k].upper + parts[k].upper};
    }
    for (Interval& one : total) one = {one.lower - slack_, one.upper + slack_};
    return total;
  }

  std::uint64_t boxes() const { return boxes_; }

 private:
  Interval value(const Form& form, const Box& box) const {
    Interval result{-slack_, slack_};
    for (std::size_t j = 0; j < form.size(); ++j) {
      const Interval& d = box.differences[j];
      result.lower += form[j] * (form[j] > 0 ? d.lower : d.upper);
      result.upper += form[j] * (form[j] > 0 ? d.upper : d.lower);
    }
    return result;
  }

  /// At the corners of the box of the u_t. Where three of these tend to 0, the lines through two data of theirs are the
  /// mean, in any proportion: all other weights are of a smaller order.
  void set_weights(const std::vector<Pair>& pairs, const std::vector<Interval>& inverse_weights) {
    double largest = 0;
    for (const Interval& u : inverse_weights) largest = std::max(largest, u.upper);
    std::vector<Interval> ends;
    for (const Interval& u : inverse_weights)
      ends.push_back({u.lower <= 0x1p-100 * largest ? 0 : u.lower / largest, largest > 0 ? u.upper / largest : 0});
    for (std::size_t corner = 0; corner < corners_.size(); ++corner) {
      const auto end = [&](std::size_t t) { return (corner >> t & 1) != 0 ? ends[t].upper : ends[t].lower; };
      Corner& one = corners_[corner];
      std::size_t zeros = 0;
      for (std::size_t t = 0; t < points_; ++t) zeros += end(t) == 0 ? 1 : 0;
      one.any_proportion = zeros >= 3;
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        double& weight = one.weights[i] = pairs[i].square;
        if (one.any_proportion) {
          weight = end(pairs[i].r) == 0 && end(pairs[i].s) == 0 ? 1 : 0;
          continue;
        }
        for (std::size_t t = 0; t < points_; ++t)
          if (t != pairs[i].r && t != pairs[i].s) weight *= end(t);
      }
    }
  }

  /// Of a quantity that has these values for the lines through two data.
  Interval mean(const std::vector<Interval>& values) const {
    Interval result{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Corner& corner : corners_) {
      double lower = 0, upper = 0, total = 0;
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (corner.weights[i] == 0) continue;
        if (corner.any_proportion) result = joined(result, values[i]);
        lower += corner.weights[i] * values[i].lower;
        upper += corner.weights[i] * values[i].upper;
        total += corner.weights[i];
      }
      result = joined(result, {lower / total, upper / total});
    }
    return {result.lower - slack_, result.upper + slack_};
  }

  Interval mean_of(const std::vector<Pair>& pairs, const Box& box, std::vector<Form> Pair::*forms, std::size_t which) {
    values_.clear();
    for (const Pair& pair : pairs) values_.push_back(value((pair.*forms)[which], box));
    return mean(values_);
  }

  /// (t^2 + e^2)^(1/2).
  static Interval inverse_weight(const Interval& residual, const Interval& root) {
    const double least = std::max({0.0, residual.lower, -residual.upper});
    const double most = std::max(-residual.lower, residual.upper);
    return {std::sqrt(least * least + root.lower * root.lower), std::sqrt(most * most + root.upper * root.upper)};
  }

  double largest_difference(const Box& box) {
    double largest = 0;
    for (const Interval& one : differences(box)) largest = std::max({largest, -one.lower, one.upper});
    return largest;
  }

  /// Cuts the widest side; e, where it is near to 0, far from the middle.
  template <class Visit>
  static bool halves(Box& box, const Visit& visit) {
    Interval* widest = &box.root;
    for (Interval& one : box.differences)
      if (one.upper - one.lower > widest->upper - widest->lower) widest = &one;
    const Interval whole = *widest;
    if (whole.upper - whole.lower < 0x1p-30) return false;
    double cut = (whole.lower + whole.upper) / 2;
    if (widest == &box.root && whole.upper > 0.3)
      cut = whole.lower == 0 ? whole.upper / 8 : std::sqrt(whole.lower * whole.upper);
    for (const Interval& part : {Interval{whole.lower, cut}, Interval{cut, whole.upper}}) {
      *widest = part;
      if (!visit(box)) return false;
    }
    *widest = whole;
    return true;
  }

  std::size_t points_;
  int fits_;
  double bound_, slack_ = 0;
  ReweightedOptions options_;
  std::vector<Pair> pairs_[2];  // of each window
  std::vector<Corner> corners_;
  std::vector<Interval> values_;
  std::uint64_t boxes_ = 0;
};

}  // namespace

std::array<Ends, 2> second_differences(int points, int fits, const DifferenceBox& box) {
  require(points >= 3 && points <= 8 && fits >= 0,
          "second differences: need 3 <= points <= 8 and fits >= 0, got {}, {}", points, fits);
  require(box.differences.size() + 1 == static_cast<std::size_t>(points), "second differences: need {} of them, got {}",
          points - 1, box.differences.size());
  for (const Ends& one : box.differences)
    require(-1 <= one.lower && one.lower <= one.upper && one.upper <= 1, "second differences: need ends in [-1, 1]");
  require(0 <= box.root.lower && box.root.lower <= box.root.upper, "second differences: need a root >= 0");
  return BoxSearch(points, fits, 1, {}).differences(box);
}

std::optional<ReweightedContraction> reweighted_contraction(int points, int fits, const ReweightedOptions& options) {
  require(points >= 3 && points <= 8, "reweighted contraction: need 3 <= points <= 8, got {}", points);
  require(fits >= 0 && fits <= 40, "reweighted contraction: need 0 <= fits <= 40, got {}", fits);
  require(options.bound > 0 && options.bound < 1, "reweighted contraction: need 0 < bound < 1, got {}", options.bound);
  const auto basin = l1_basin(points, 1);
  if (!basin || basin->contraction > options.bound) return std::nullopt;
  const double bound = options.bound.convert_to<double>() * (1 - 0x1p-40);
  const double end = Rational(1 / basin->radius).convert_to<double>() * (1 + 0x1p-40);
  BoxSearch search(points, fits, bound, options);
  const std::size_t count = static_cast<std::size_t>(points) - 1;
  for (std::size_t largest = 0; 2 * largest < count; ++largest) {  // the others are mirror images
    Box box{std::vector<Interval>(count, {-1, 1}), {0, end}};
    box.differences[largest] = {1, 1};
    if (!search.holds(box)) return std::nullopt;
  }
  return ReweightedContraction{fits, options.bound, search.boxes()};
}

}  // namespace subcert::data
