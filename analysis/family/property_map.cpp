#include "property_map.hpp"

#include "between_zeros.hpp"
#include "family_radius.hpp"
#include "threshold.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/parallel.hpp>

#include <algorithm>
#include <map>
#include <mutex>
#include <numeric>

namespace subcert {
namespace {

using namespace family;

constexpr double cell_seconds = 1;  // for one upper bound
constexpr double far_below = 0.97;  // of the threshold: quadratic forms may do
constexpr long most_terms = 1500;   // of the polynomial of a product
constexpr int most_matrices = 64;

/// [j][i]: the factor of v^i w^j.
using Bivariate = std::vector<std::vector<Rational>>;

/// The Bernstein coefficients of a polynomial on a rectangle.
Bivariate bernstein(const Bivariate& polynomial, const Rectangle& cell) {
  const auto factors = [&](std::size_t side, std::size_t count) {
    return bernstein_factors(static_cast<long>(count) - 1, cell.low[side], cell.high[side]);
  };
  const auto in_v = factors(0, polynomial.front().size()), in_w = factors(1, polynomial.size());
  Bivariate rows;  // coefficients in v, powers of w
  for (const std::vector<Rational>& row : polynomial) {
    rows.emplace_back();
    for (const std::vector<Rational>& control : in_v)
      rows.back().push_back(std::inner_product(row.begin(), row.end(), control.begin(), Rational(0)));
  }
  Bivariate result;
  for (const std::vector<Rational>& control : in_w) {
    result.emplace_back(in_v.size(), Rational(0));
    for (std::size_t j = 0; j < rows.size(); ++j)
      for (std::size_t i = 0; i < in_v.size(); ++i) result.back()[i] += control[j] * rows[j][i];
  }
  return result;
}

std::array<Rational, 2> middle(const Rectangle& cell) {
  return {(cell.low[0] + cell.high[0]) / 2, (cell.low[1] + cell.high[1]) / 2};
}

/// The quarters of a rectangle.
std::array<Rectangle, 4> quarters(const Rectangle& cell) {
  const auto [v, w] = middle(cell);
  return {Rectangle{cell.low, {v, w}}, Rectangle{{v, cell.low[1]}, {cell.high[0], w}},
          Rectangle{{cell.low[0], w}, {v, cell.high[1]}}, Rectangle{{v, w}, cell.high}};
}

class MapSearch {
 public:
  MapSearch(const BiparametricMask& mask, int rules, const RangeProperty& property, const MapOptions& options)
      : mask_(mask),
        property_(property),
        options_(options),
        threshold_(property, mask.flat.arity(), rules),
        family_{transition_matrices(divided_difference_scheme(mask.flat, rules), 0).powers,
                static_cast<std::size_t>(mask.columns)} {
    // The last powers of w may be missing.
    for (auto& powers : family_.powers)
      while (powers.size() % family_.columns != 0) powers.emplace_back(family_.size(), family_.size());
    for (long k = mask.flat.support().first; k <= mask.flat.support().last; ++k) coefficients_.push_back(bivariate(k));
  }

  /// A cell on which a search fails is not decided, and says so.
  MapCell decide(const Rectangle& rectangle) {
    MapCell cell{rectangle, Truth::unknown, spent};
    if (options_.budget.deadline.expired()) return cell;
    try {
      cell.holds = search(rectangle, cell.reason);
    } catch (const Error& error) {
      cell.reason = std::string("a search failed (") + error.what() + ")";
    }
    if (cell.holds != Truth::unknown)
      cell.reason.clear();
    else if (options_.budget.deadline.expired())
      cell.reason = spent;
    return cell;
  }

 private:
  Truth search(const Rectangle& cell, std::string& reason) {
    const std::array<Rational, 2> v_w = middle(cell);
    const Look look = look_at(family_.slice(v_w[1]).at(v_w[0]), options_.budget.deadline);
    const double limit = threshold_.value();
    if (look.radius > std::max(limit, 1.0)) {
      reason = "no product was proved to be too large for all values there, or the shifts may be unstable";
      return is_refuted(cell, look.word) ? Truth::no : Truth::unknown;
    }
    reason = "the radius comes near to the threshold";
    if (!threshold_.is_reachable() || look.radius >= limit) return Truth::unknown;
    reason = "the radius was not proved to be below the threshold for all values there";
    const Budget budget{options_.budget.deadline.at_most(cell_seconds), options_.budget.memory};
    return radius_below(family_.controls(cell.low, cell.high), threshold_.below(), look.radius < far_below * limit,
                        budget)
               ? Truth::yes
               : Truth::unknown;
  }

  bool is_refuted(const Rectangle& cell, const std::vector<int>& word) {
    if (property_.kind != RangeProperty::Kind::convergent && !is_stable_on(cell)) return false;
    const Rational least = std::max(Rational(1), threshold_.power_above(static_cast<long>(word.size())));
    for (const EigenvalueBound& bound : {EigenvalueBound{word, least, 0}, {word, -least, 0}, {word, 0, least}})
      if (is_negative(characteristic(bound), cell)) return true;
    return false;
  }

  /// All Bernstein coefficients are negative.
  static bool is_negative(const Bivariate& polynomial, const Rectangle& cell) {
    if (polynomial.empty()) return false;
    for (const std::vector<Rational>& row : bernstein(polynomial, cell))
      if (std::any_of(row.begin(), row.end(), [](const Rational& c) { return c >= 0; })) return false;
    return true;
  }

  /// The shifts are stable for all masks that are as far from the one in the middle as any on the cell.
  bool is_stable_on(const Rectangle& cell) const {
    const auto [v, w] = middle(cell);
    const Mask mask = mask_.at(v, w);
    const IndexRange all = mask_.flat.support();
    if (!(support(mask) == all)) return false;
    std::vector<Rational> errors;
    for (std::size_t k = 0; k < coefficients_.size(); ++k) {
      const Rational value = mask.symbol().coefficient(all.first + static_cast<long>(k));
      errors.emplace_back(0);
      for (const std::vector<Rational>& row : bernstein(coefficients_[k], cell))
        for (const Rational& c : row) errors.back() = std::max(errors.back(), abs(c - value));
    }
    return has_stable_shifts(mask, errors).is_yes();
  }

  /// A coefficient of the mask.
  Bivariate bivariate(long index) const {
    const std::vector<LaurentPolynomial>& powers = mask_.flat.powers();
    const auto columns = static_cast<std::size_t>(mask_.columns);
    Bivariate result((powers.size() + columns - 1) / columns, std::vector<Rational>(columns, 0));
    for (std::size_t k = 0; k < powers.size(); ++k) result[k / columns][k % columns] = powers[k].coefficient(index);
    return result;
  }

  /// The polynomial of FamilyRadius::characteristic, from its values for some w; empty where it would be large.
  Bivariate characteristic(const EigenvalueBound& bound) {
    const auto key = std::pair(bound.word, std::pair(bound.re, bound.im));
    {
      const std::scoped_lock lock(mutex_);
      if (const auto known = characteristics_.find(key); known != characteristics_.end()) return known->second;
    }
    const auto size = static_cast<long>(family_.size()), length = static_cast<long>(bound.word.size());
    const long factors = bound.re == 0 ? length * size * (size - 1) : length * size,
               rows = factors * static_cast<long>(family_.rows() - 1) + 1,
               columns = factors * static_cast<long>(family_.columns - 1) + 1;
    Bivariate result;
    if (rows * columns <= most_terms) {
      std::vector<Rational> nodes;
      Bivariate values(static_cast<std::size_t>(columns));
      for (long j = 0; j < rows; ++j) {
        nodes.emplace_back(j);
        const LaurentPolynomial slice = FamilyRadius(family_.slice(nodes.back()))
                                            .characteristic(bound, options_.budget.deadline);
        if (slice.is_zero()) return {};
        for (long i = 0; i < columns; ++i) values[static_cast<std::size_t>(i)].push_back(slice.coefficient(i));
      }
      result.assign(static_cast<std::size_t>(rows), std::vector<Rational>(static_cast<std::size_t>(columns), 0));
      for (std::size_t i = 0; i < values.size(); ++i) {
        const LaurentPolynomial in_w = interpolation(nodes, values[i]);
        for (std::size_t j = 0; j < result.size(); ++j) result[j][i] = in_w.coefficient(static_cast<long>(j));
      }
    }
    const std::scoped_lock lock(mutex_);
    return characteristics_.emplace(key, std::move(result)).first->second;
  }

  const BiparametricMask& mask_;
  RangeProperty property_;
  const MapOptions& options_;
  Threshold threshold_;
  BiparametricFamily family_;
  std::vector<Bivariate> coefficients_;  // of the mask
  std::mutex mutex_;
  std::map<std::pair<std::vector<int>, std::pair<Rational, Rational>>, Bivariate> characteristics_;
};

}  // namespace

Rational PropertyMap::share(Truth holds) const {
  Rational all = 0, found = 0;
  for (const MapCell& cell : cells) {
    const Rational area = (cell.rectangle.high[0] - cell.rectangle.low[0]) *
                          (cell.rectangle.high[1] - cell.rectangle.low[1]);
    all += area;
    if (cell.holds == holds) found += area;
  }
  return found / all;
}

PropertyMap property_map(const BiparametricMask& mask, const RangeProperty& property, const Rectangle& rectangle,
                         const MapOptions& options) {
  for (const std::size_t side : {0U, 1U})
    require(rectangle.low[side] < rectangle.high[side], "map: need low < high, got {} and {}", rectangle.low[side],
            rectangle.high[side]);
  require(options.resolution >= 1 && options.resolution <= 1024, "map: need a resolution from 1 to 1024, got {}",
          options.resolution);
  const auto matrices = mask.flat.arity() * static_cast<int>(mask.flat.powers().size());
  require(matrices <= most_matrices, "map: need arity * (degree in v + 1) * (degree in w + 1) up to {}, got {}",
          most_matrices, matrices);
  PropertyMap result;
  result.sum_rules = sum_rules(mask.flat);
  require(result.sum_rules >= 1, "map: need a sum rule for all values of the parameters, got none");
  using Kind = RangeProperty::Kind;
  require((property.kind == Kind::convergent || property.kind == Kind::smooth || property.kind == Kind::holder) &&
              property.order < result.sum_rules,
          "map: need 'convergent', or an order below the number {} of sum rules that hold for all values",
          result.sum_rules);
  MapSearch search(mask, result.sum_rules, property, options);
  std::vector<Rectangle> open{rectangle};
  for (int cells = 1; !open.empty(); cells *= 2) {
    std::vector<MapCell> decided(open.size());
    parallel_tasks(open.size(), options.jobs, [&](std::size_t k) { decided[k] = search.decide(open[k]); });
    std::vector<Rectangle> next;
    const bool last = cells >= options.resolution, late = options.budget.deadline.expired();
    for (std::size_t k = 0; k < open.size(); ++k) {
      const Truth holds = decided[k].holds;
      if (holds != Truth::unknown || last || late) {
        result.cells.push_back(std::move(decided[k]));
        result.complete = result.complete && (holds != Truth::unknown || last);
        continue;
      }
      for (Rectangle& quarter : quarters(open[k])) next.push_back(std::move(quarter));
    }
    open = std::move(next);
  }
  return result;
}

}  // namespace subcert
