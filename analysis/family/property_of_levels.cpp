#include "property_of_levels.hpp"

#include "between_zeros.hpp"
#include "box_search.hpp"

#include <subcert/analysis/regularity/regularity.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>

#include <algorithm>

namespace subcert {
namespace {

using Kind = RangeProperty::Kind;

constexpr double bounding = 0.7;     // of the time: the rest is for sequences without the property
constexpr double excess = 1e-6;      // of a radius that only bounds an exponent
constexpr double nearly = 1 - 1e-9;  // at the threshold, in doubles, which others then decide
constexpr int norm_levels = 8;

/// The corners, and then the middle.
std::vector<Values> some_values(const Box& box) {
  std::vector<Values> values;
  for (unsigned corner = 0; corner < box.corners(); ++corner) values.push_back(box.corner(corner));
  values.push_back(box.middle());
  return values;
}

/// The levels of a period as one; nothing where a value has no mask.
std::optional<Mask> scheme_of(const ParametricMask& mask, const std::vector<Values>& period) {
  try {
    std::vector<LatticeMask> levels;
    for (const Values& w : period) levels.emplace_back(mask.at(w));
    return levels_as_one(levels).curve();
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// Of one value at all levels. Errors: throws Error where it has no mask.
Regularity regularity_at(const ParametricMask& mask, const Values& w, const Budget& budget,
                         RegularityOptions options = {}) {
  options.levels = norm_levels;
  return regularity_of(mask.lattice_mask_at(w), budget, options);
}

class Levels {
 public:
  Levels(const ParametricMask& mask, const RangeProperty& property, const Box& box, const Budget& budget)
      : mask_(mask), property_(property), box_(box), budget_(budget), search_(mask, property, box, budget) {}

  PropertyOfLevels decide() {
    result_.sum_rules = sum_rules(mask_);
    const std::vector<Values> values = some_values(box_);
    for (const Values& w : values)
      if (may_be_too_large(w) && fails({w})) return result_;
    if (search_.threshold().is_reachable()) result_.above = bound();
    if (result_.above) {
      result_.holds = Truth::yes;
      return result_;
    }
    for (std::size_t k = 0; k + 1 < values.size(); ++k)
      for (std::size_t l = 0; l < k; ++l)
        if (fails({values[l], values[k]})) return result_;
    result_.reason = budget_.deadline.expired() ? family::spent
                     : search_.threshold().is_reachable()
                         ? "the radius of the control matrices of the box was not proved to be below the threshold"
                         : "only orders below the number of sum rules are proved";
    return result_;
  }

 private:
  bool may_be_too_large(const Values& w) const {
    return !search_.threshold().is_reachable() ||
           search_.look_if_possible(w).radius > search_.threshold().value() * nearly;
  }

  std::optional<JointSpectralRadius> bound() {
    try {
      return search_.radius().from_above(box_, search_.threshold().below(), false,
                                         {budget_.deadline.after(bounding), budget_.memory});
    } catch (const Error&) {
      return std::nullopt;
    }
  }

  /// Whether the sequence of that period is proved not to have the property. Of matrices one value at all levels.
  bool fails(std::vector<Values> period) {
    if (budget_.deadline.expired()) return false;
    if (mask_.components() > 1) {
      if (period.size() > 1 || !fails_at(period.front())) return false;
    } else {
      const std::optional<Mask> scheme = scheme_of(mask_, period);
      if (!scheme || family::holds_at(*scheme, property_, budget_.deadline) != Truth::no) return false;
    }
    result_.holds = Truth::no;
    result_.period = std::move(period);
    return true;
  }

  bool fails_at(const Values& w) const {
    RegularityOptions options;
    options.hermite = property_.kind == Kind::hermite;
    const Budget share{budget_.deadline.after(1 - bounding), budget_.memory};
    const MultivariateRegularity found = *regularity_at(mask_, w, share, options).surface;
    if (property_.kind == Kind::convergent) return found.converges.is_no();
    if (options.hermite)
      return found.vector->hermite && found.vector->hermite->next.is_no() &&
             found.vector->hermite->order < property_.order;
    return found.exponent.upper && *found.exponent.upper < property_.order;
  }

  const ParametricMask& mask_;
  RangeProperty property_;
  const Box& box_;
  Budget budget_;
  family::BoxSearch search_;
  PropertyOfLevels result_;
};

/// Part of a box, about a point.
Box shrunk(const Box& box, const Values& about, const Rational& share) {
  Box result = box;
  for (std::size_t v = 0; v < box.letters(); ++v) {
    result.low[v] = about[v] + share * (box.low[v] - about[v]);
    result.high[v] = about[v] + share * (box.high[v] - about[v]);
  }
  return result;
}

}  // namespace

Truth holds(const Enclosure& exponent, const RangeProperty& property) {
  if (property.kind == Kind::convergent) return exponent.lower ? Truth::yes : Truth::unknown;
  const bool strictly = property.kind == Kind::smooth;
  if (exponent.lower && (strictly ? *exponent.lower > property.order : *exponent.lower >= property.order))
    return Truth::yes;
  return exponent.upper && *exponent.upper < property.order ? Truth::no : Truth::unknown;
}

Truth holds(const ExponentOfList& found, const RangeProperty& property) {
  if (property.kind != Kind::hermite) return holds(found.exponent, property);
  if (!found.vectors || !found.vectors->keeps_derivatives) return Truth::unknown;
  const VectorList& vectors = *found.vectors;
  if (vectors.decay && *vectors.decay > property.order && property.order < found.sum_rules) return Truth::yes;
  if (!vectors.hermite) return Truth::unknown;
  if (vectors.hermite->order >= property.order) return found.is_one_sequence() ? Truth::yes : Truth::unknown;
  return vectors.hermite->next.is_no() ? Truth::no : Truth::unknown;
}

std::optional<HermiteOrder> hermite_order_of(const ExponentOfList& found) {
  if (!found.list.hermite || !found.vectors || !found.vectors->keeps_derivatives) return std::nullopt;
  const int least = static_cast<int>(found.list.masks.front().components()) - 1;
  const auto have = [&](int order) { return holds(found, {Kind::hermite, order}); };
  HermiteOrder result{-1, {have(least), ""}};
  while (result.next.is_yes()) {
    result.order = result.order < 0 ? least : result.order + 1;
    result.next = {have(result.order + 1), ""};
  }
  return result;
}

void require_property(const MaskList& list, const RangeProperty& property) {
  if (property.kind != Kind::hermite) return;
  require(list.hermite, "levels: need Hermite schemes for HC{}, got others", property.order);
  const std::size_t derivatives = list.masks.front().components() - 1;
  require(property.order >= derivatives, "levels: need HC{} or more, as there are {} derivatives, got HC{}",
          derivatives, derivatives, property.order);
  require(kept_polynomials(list).hermite,
          "levels: need values and derivatives of polynomials of degree up to {} that all masks keep, got others "
          "(perhaps the matrices are transposed)",
          derivatives);
}

void require_levels(const ParametricMask& mask, const Box& box) {
  require(box.letters() == mask.letters(), "levels: need a range for each letter, got {} letters and {} ranges",
          mask.letters(), box.letters());
  family::require_box("levels", mask, box);
}

std::optional<Rational> upper_end_of_levels(const ParametricMask& mask, const Box& box, const Budget& budget) {
  std::optional<Rational> least;
  for (unsigned corner = 0; corner < box.corners(); ++corner) {
    try {
      const auto upper = regularity_at(mask, box.corner(corner), budget).exponent().upper;
      if (upper && (!least || *upper < *least)) least = upper;
    } catch (const Error&) {  // nothing is proved there
    }
  }
  return least;
}

PropertyOfLevels property_of_levels(const ParametricMask& mask, const RangeProperty& property, const Box& box,
                                    const Budget& budget) {
  require_levels(mask, box);
  require(property.kind == Kind::convergent || property.kind == Kind::smooth || property.kind == Kind::hermite ||
              property.kind == Kind::holder,
          "levels: need 'convergent', C1, HC1 or holder>=3/2");
  family::require_property("levels", mask, property, sum_rules(mask));
  return Levels(mask, property, box, budget).decide();
}

std::vector<ExponentOfLevels> exponents_of_levels(const ParametricMask& mask, const Box& box, const Values& about,
                                                  const LevelsCurveOptions& options) {
  require_levels(mask, box);
  require(options.boxes >= 1 && options.boxes <= 1000, "levels: need 1 to 1000 boxes, got {}", options.boxes);
  for (std::size_t v = 0; v < box.letters(); ++v)
    require(about.size() == box.letters() && box.low[v] <= about[v] && about[v] <= box.high[v],
            "levels: need a point of the box");
  const int rules = sum_rules(mask);
  const family::FamilyRadius radius(difference_matrices(mask));
  const auto count = static_cast<std::size_t>(options.boxes);
  std::vector<ExponentOfLevels> result(count);
  const Deadline all = options.budget.deadline;
  parallel_tasks(count, options.jobs, [&](std::size_t k) {
    ExponentOfLevels& one = result[k];
    one.box = shrunk(box, about, Rational(static_cast<long>(k) + 1, options.boxes));
    if (all.expired()) return;
    const Budget share{all.after(1.0 / static_cast<double>(count - k + 1)), options.budget.memory};
    try {
      if (const auto above = radius.from_above(one.box, excess, share))
        one.exponent.lower = std::min(Rational(rules),
                                      Rational(rules - *log_ratio(above->proved_upper(), mask.arity()).upper));
    } catch (const Error&) {  // nothing is proved there
    }
    one.exponent.upper = upper_end_of_levels(mask, one.box, share);
  });
  return result;
}

}  // namespace subcert
