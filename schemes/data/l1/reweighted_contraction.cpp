// A second difference of the next level depends on two windows, that is, on the second differences d of points + 1
// data. Of these the first one is of the first window alone and the last one of the second window alone; the others
// are shared. So on a box of the shared ones and e = delta^(1/2) the two windows are looked at apart, each with an
// interval of its own difference, and only their numbers are added, for all pairs of intervals (docs/l1.md, Theorem 7).
//
// By homogeneity either the largest shared difference is 1 and the two others are at most 8, or one of these is 1 and
// the shared ones are at most 1/8. Where e times `radius` is the largest difference or more, l1_basin() says it. What
// is left is cut until the bound holds on each box.

#include "reweighted_contraction.hpp"

#include "l1_basin.hpp"
#include "window_range.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace subcert::data {
namespace {

using Box = DifferenceBox;

double width(const Ends& one) { return one.upper - one.lower; }
double least_modulus(const Ends& one) { return std::max({0.0, one.lower, -one.upper}); }
double largest_modulus(const Ends& one) { return std::max(-one.lower, one.upper); }

/// Of the difference that a window has for itself, with what the window gives.
struct Own {
  Ends difference;
  WindowRange::Parts parts = {};
  bool is_known = false;
};

/// Pairs of intervals, by their places, for which the bound is not yet proved.
struct Open {
  std::array<std::vector<Own>, 2> own;
  std::vector<std::array<std::size_t, 2>> pairs;
};

class Search {
 public:
  Search(int points, int fits, double bound, double radius, const ReweightedOptions& options)
      : windows_{window_range(points, 0), window_range(points, 1)},
        shared_(static_cast<std::size_t>(points) - 3),
        fits_(fits),
        bound_(bound),
        radius_(radius),
        options_(options) {}

  bool holds_for_all_data() {
    constexpr double most = WindowRange::largest_datum;
    for (std::size_t largest = 0; 2 * largest < shared_; ++largest) {  // the others are mirror images
      Box box = shared_box(1, most);
      box.differences[1 + largest] = {1, 1};
      if (!holds(box, {{{{{{-most, most}}}, {{{-most, most}}}}}, {{0, 0}}})) return false;
    }
    Box box = shared_box(1 / most, 1);
    return holds(box, {{{{{{1, 1}}}, {{{-1, 1}}}}}, {{0, 0}}});  // as well the mirror images
  }

  std::uint64_t boxes() const { return boxes_; }

 private:
  Box shared_box(double largest_shared, double largest) const {
    return {std::vector<Ends>(shared_ + 2, {-largest_shared, largest_shared}), {0, largest / radius_ * (1 + 0x1p-40)}};
  }

  /// Whether both second differences are at most the bound on all of the box, for the pairs that are open.
  bool holds(Box& box, Open open) {
    Ends& widest = widest_side(box);
    do {
      if (!look_at(box, open)) return false;
      std::erase_if(open.pairs, [&](const auto& pair) { return is_proved(box, open, pair); });
      if (open.pairs.empty()) return true;
    } while (cut_own(open, width(widest)));
    for (std::vector<Own>& list : open.own)
      for (Own& own : list) own.is_known = false;
    return halves_hold(box, widest, open);
  }

  Ends& widest_side(Box& box) const {
    Ends* widest = &box.root;
    for (std::size_t j = 1; j <= shared_; ++j)
      if (width(box.differences[j]) > width(*widest)) widest = &box.differences[j];
    return *widest;
  }

  /// False where the boxes or the time do not suffice.
  bool look_at(Box& box, Open& open) {
    for (std::size_t window = 0; window < 2; ++window) {
      box.differences.front() = box.differences.back() = {0, 0};
      for (Own& own : open.own[window]) {
        if (std::exchange(own.is_known, true)) continue;
        if (++boxes_ > options_.most_boxes || options_.deadline.expired()) return false;
        (window == 0 ? box.differences.front() : box.differences.back()) = own.difference;
        own.parts = windows_[window]->parts(box, fits_);
      }
    }
    return true;
  }

  bool is_proved(const Box& box, const Open& open, const std::array<std::size_t, 2>& pair) const {
    const Own &first = open.own[0][pair[0]], &last = open.own[1][pair[1]];
    double least = std::max(least_modulus(first.difference), least_modulus(last.difference));
    double most = std::max(largest_modulus(first.difference), largest_modulus(last.difference));
    for (std::size_t j = 1; j <= shared_; ++j) {
      least = std::max(least, least_modulus(box.differences[j]));
      most = std::max(most, largest_modulus(box.differences[j]));
    }
    if (box.root.lower * radius_ >= most) return true;
    for (std::size_t k = 0; k < 2; ++k)
      if (first.parts[k].lower + last.parts[k].lower < -bound_ * least ||
          first.parts[k].upper + last.parts[k].upper > bound_ * least)
        return false;
    return true;
  }

  /// Forgets intervals that are in no open pair and halves those that are wider, also in proportion; whether any is.
  static bool cut_own(Open& open, double most_width) {
    std::array<std::vector<std::vector<std::size_t>>, 2> parts;
    bool is_cut = false;
    for (std::size_t window = 0; window < 2; ++window) {
      std::vector<Own>& list = open.own[window];
      std::vector<bool> is_open(list.size());
      for (const auto& pair : open.pairs) is_open[pair[window]] = true;
      parts[window].resize(list.size());
      std::vector<Own> next;
      for (std::size_t i = 0; i < list.size(); ++i) {
        if (!is_open[i]) continue;
        const Ends& whole = list[i].difference;
        const bool cut = width(whole) > most_width * std::max(1.0, least_modulus(whole));
        const double middle = (whole.lower + whole.upper) / 2;
        const std::vector<Own> own = cut ? std::vector<Own>{{{whole.lower, middle}}, {{middle, whole.upper}}}
                                         : std::vector<Own>{list[i]};
        for (const Own& one : own) {
          parts[window][i].push_back(next.size());
          next.push_back(one);
        }
        is_cut = is_cut || cut;
      }
      list = std::move(next);
    }
    std::vector<std::array<std::size_t, 2>> pairs;
    for (const auto& pair : open.pairs)
      for (const std::size_t first : parts[0][pair[0]])
        for (const std::size_t last : parts[1][pair[1]]) pairs.push_back({first, last});
    open.pairs = std::move(pairs);
    return is_cut;
  }

  /// e, where it is near to 0, is cut far from the middle.
  bool halves_hold(Box& box, Ends& side, const Open& open) {
    const Ends whole = side;
    if (width(whole) < 0x1p-30) return false;
    double cut = (whole.lower + whole.upper) / 2;
    if (&side == &box.root && whole.upper > 0.3)
      cut = whole.lower == 0 ? whole.upper / 8 : std::sqrt(whole.lower * whole.upper);
    for (const Ends& part : {Ends{whole.lower, cut}, Ends{cut, whole.upper}}) {
      side = part;
      if (!holds(box, open)) return false;
    }
    side = whole;
    return true;
  }

  std::array<std::unique_ptr<WindowRange>, 2> windows_;
  std::size_t shared_;
  int fits_;
  double bound_, radius_;
  ReweightedOptions options_;
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
  std::array<Ends, 2> total{};
  for (std::size_t window = 0; window < 2; ++window) {
    const WindowRange::Parts parts = window_range(points, window)->parts(box, fits);
    for (std::size_t k = 0; k < 2; ++k) total[k] = {total[k].lower + parts[k].lower, total[k].upper + parts[k].upper};
  }
  return total;
}

std::optional<ReweightedContraction> reweighted_contraction(int points, int fits, const ReweightedOptions& options) {
  require(points >= 3 && points <= 8, "reweighted contraction: need 3 <= points <= 8, got {}", points);
  require(fits >= 0 && fits <= 40, "reweighted contraction: need 0 <= fits <= 40, got {}", fits);
  require(options.bound > 0 && options.bound < 1, "reweighted contraction: need 0 < bound < 1, got {}", options.bound);
  const auto basin = l1_basin(points, 1);
  if (!basin || basin->contraction > options.bound) return std::nullopt;
  const double bound = options.bound.convert_to<double>() * (1 - 0x1p-40);
  const double radius = basin->radius.convert_to<double>() * (1 - 0x1p-40);
  Search search(points, fits, bound, radius, options);
  if (!search.holds_for_all_data()) return std::nullopt;
  return ReweightedContraction{fits, options.bound, search.boxes()};
}

}  // namespace subcert::data
