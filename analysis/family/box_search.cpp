
#include "box_search.hpp"

#include "between_zeros.hpp"

#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace subcert::family {
namespace {

constexpr double far_below = 0.97;     // of the threshold: quadratic forms may do
constexpr double linking_seconds = 1;  // for the upper bound of one box

}  // namespace

void require_box(const std::string& command, const ParametricMask& mask, const Box& box) {
  std::size_t matrices = static_cast<std::size_t>(mask.arity());
  for (std::size_t v = 0; v < box.letters(); ++v) {
    require(box.low[v] < box.high[v], "{}: need low < high, got {} and {}", command, box.low[v], box.high[v]);
    matrices *= mask.sizes()[v];
  }
  const bool one = box.letters() == 1;
  require(matrices <= most_matrices, "{}: need arity * {} up to {}, got {}", command,
          one ? "(degree + 1)" : "(degree in one letter + 1) * (degree in the next + 1)", most_matrices, matrices);
  const char* values = one ? "all values of the parameter" : "all values of the parameters";
  require(sum_rules(mask) >= 1 || mask.components() == 1,
          "{}: need a vector that the sums over all classes keep, the same one for {} and but for factors no other, "
          "got none",
          command, values);
  require(sum_rules(mask) >= 1, "{}: need a sum rule for {}, got none", command, values);
}

void require_property(const std::string& command, const ParametricMask& mask, const RangeProperty& property,
                      int rules) {
  using Kind = RangeProperty::Kind;
  if (mask.components() == 1) {
    require(property.kind != Kind::hermite, "{}: need a Hermite scheme for HC{}, got a mask of numbers", command,
            property.order);
    return;
  }
  require(property.kind == Kind::convergent || property.kind == Kind::smooth || property.kind == Kind::hermite ||
              property.kind == Kind::holder,
          "{}: need 'convergent', C1, HC1 or holder>=3/2 for a mask of matrices", command);
  if (property.kind == Kind::hermite) {
    const std::size_t derivatives = mask.components() - 1;
    require(kept_polynomials(mask).hermite,
            "{}: need values and derivatives of polynomials of degree up to {} that are kept for all values of the "
            "letters, got others (perhaps the matrices are transposed)",
            command, derivatives);
    require(property.order >= derivatives, "{}: need HC{} or more, as there are {} derivatives, got HC{}", command,
            derivatives, derivatives, property.order);
  }
  require(property.order < rules, "{}: need an order below the number {} of sum rules that hold for all values, got {}",
          command, rules, property.order);
}

PolynomialData polynomials_of(const ParametricMask& mask) {
  return mask.components() == 1 ? PolynomialData{} : kept_polynomials(mask);
}

bool links_derivatives(const FamilyRadius& radius, const PolynomialData& polynomials, int arity, const Box& box,
                       const Budget& budget) {
  if (!polynomials.interpolating) return false;
  const auto rules = static_cast<long>(polynomials.data.size()),
             derivatives = static_cast<long>(polynomials.data.front().size()) - 1;
  return radius
      .from_above(box, power(Rational(arity), rules - derivatives), true,
                  {budget.deadline.at_most(linking_seconds), budget.memory})
      .has_value();
}

BoxSearch::BoxSearch(const ParametricMask& mask, const RangeProperty& property, const Box& range, const Budget& budget)
    : mask_(mask),
      property_(property),
      range_(range),
      budget_(budget),
      threshold_(property, mask.arity(), sum_rules(mask)),
      radius_(difference_matrices(mask_)),
      polynomials_(polynomials_of(mask)) {
  if (mask.letters() == 1 && property.kind != RangeProperty::Kind::convergent)
    unstable_ = unstable_values(mask, budget.deadline);
}

void BoxSearch::run(const Plan& plan, const std::function<void(BoxProof)>& done) {
  std::vector<Look> looks = plan.at_corners;
  looks.resize(range_.corners());
  in_rounds(
      std::vector{Node{range_, std::move(looks)}}, plan.jobs, [&](const Node& node) { return decide(node, plan); },
      [&](const std::vector<Node>& open, std::vector<Decided> decided) {
        std::vector<Node> next;
        for (std::size_t k = 0; k < open.size(); ++k) {
          auto& [proof, middle, seconds] = decided[k];
          if (proof.holds() != Truth::unknown || proof.is_final || plan.is_last(proof.box, seconds) ||
              budget_.deadline.expired()) {
            done(std::move(proof));
            continue;
          }
          for (unsigned corner = 0; corner < proof.box.corners(); ++corner) {
            Node part{proof.box.part(corner), std::vector<Look>(proof.box.corners())};
            part.at_corners[corner] = open[k].at_corners[corner];
            part.at_corners[proof.box.corners() - 1 - corner] = middle;
            next.push_back(std::move(part));
          }
        }
        return next;
      });
}

/// A box that a search cannot treat is not decided: the others are.
BoxSearch::Decided BoxSearch::decide(const Node& node, const Plan& plan) {
  const Stopwatch watch;
  Decided result{{node.box, std::nullopt, std::nullopt}, {}};
  BoxProof& proof = result.proof;
  try {
    if (!budget_.deadline.expired()) {
      result.middle = radius_.look(node.box.middle(), budget_.deadline);
      proof.reason = search(node, plan.seconds(node.box), result);
    }
  } catch (const Error& error) {
    proof.reason = std::string("a search failed (") + error.what() + ")";
  }
  if (proof.holds() != Truth::unknown)
    proof.reason.clear();
  else if (budget_.deadline.expired())
    proof.reason = spent;
  result.seconds = watch.seconds();
  return result;
}

/// Why no proof was found, where none was.
std::string BoxSearch::search(const Node& node, double seconds, Decided& result) {
  const double limit = threshold_.value();
  if (result.middle.radius > std::max(limit, 1.0)) {
    std::vector<Look> looks{result.middle};
    looks.insert(looks.end(), node.at_corners.begin(), node.at_corners.end());
    if (!refutes_on(node.box)) {
      result.proof.is_final = never_refutes_on(node.box, looks);
      return why_not_refuted();
    }
    for (const Look& look : looks)
      if (!result.proof.below && !look.word.empty())
        result.proof.below = radius_.from_below(
            node.box, look.word, std::max(Rational(1), threshold_.power_above(static_cast<long>(look.word.size()))),
            false, budget_.deadline);
    return "no product was proved to be too large for all values there";
  }
  if (!threshold_.is_reachable()) return "only orders below the number of sum rules are proved";
  double largest = result.middle.radius;
  for (const Look& look : node.at_corners) largest = std::max(largest, look.radius);
  if (largest >= limit) return "the radius comes near to the threshold";
  // Of several letters few corners were looked at: there the middle tells how far it is.
  const double near = mask_.letters() == 1 ? largest : result.middle.radius;
  result.proof.above = radius_.from_above(node.box, threshold_.below(), near < far_below * limit,
                                          {budget_.deadline.at_most(seconds), budget_.memory});
  return fmt::format("the radius was not proved to be below the threshold in the time for one {}",
                     mask_.letters() == 1 ? "interval" : "cell");
}

Look BoxSearch::look_if_possible(const Values& w) const {
  try {
    return radius_.look(w, budget_.deadline);
  } catch (const Error&) {
    return {};
  }
}

std::string BoxSearch::why_not_refuted() const {
  if (mask_.components() == 1)
    return mask_.letters() == 1 && unstable_.is_zero() ? why_stability_is_open(budget_.deadline)
                                                       : "the shifts may be unstable at a value there";
  return polynomials_.interpolating
             ? fmt::format("the radius is too large, which refutes this only where HC{0} is proved; ask for HC{0}",
                           mask_.components() - 1)
             : "the radius is too large, which refutes this only of schemes that interpolate values and derivatives";
}

bool BoxSearch::refutes_on(const Box& box) const {
  using Kind = RangeProperty::Kind;
  if (property_.kind == Kind::convergent) return true;
  if (mask_.components() == 1) return is_stable_on(box);
  if (property_.kind == Kind::hermite) return polynomials_.interpolating;
  return property_.order >= static_cast<long>(mask_.components()) - 1 &&
         links_derivatives(radius_, polynomials_, mask_.arity(), box, budget_);
}

/// Of matrices: where all radii are too large, also for what would have to be proved first.
bool BoxSearch::never_refutes_on(const Box& box, const std::vector<Look>& looks) {
  if (mask_.components() == 1) return false;
  const auto derivatives = static_cast<long>(mask_.components()) - 1;
  const bool may_be_linked = polynomials_.interpolating && property_.order >= derivatives;
  const Threshold linked({RangeProperty::Kind::hermite, derivatives}, mask_.arity(),
                         static_cast<int>(polynomials_.data.size()));
  const Threshold& threshold = may_be_linked ? linked : threshold_;
  return std::ranges::any_of(looks, [&](const Look& look) {
    const auto length = static_cast<long>(look.word.size());
    return length > 0 &&
           radius_.from_below(box, look.word, threshold.power_above(length), false, budget_.deadline).has_value();
  });
}

/// Of one letter by the zeros of a polynomial; else the shifts are to be stable for all masks that are as far from the
/// one in the middle as any on the box.
bool BoxSearch::is_stable_on(const Box& box) const {
  if (mask_.letters() == 1) return has_no_real_root(unstable_, box.low[0], box.high[0], budget_.deadline);
  const Mask mask = mask_.at(box.middle());
  const IndexRange all = mask_.support();
  const auto controls = mask_.controls(box);
  if (!controls || !(support(mask) == all)) return false;
  std::vector<Rational> errors;
  for (long k = all.first; k <= all.last; ++k) {
    errors.emplace_back(0);
    for (const LaurentPolynomial& control : *controls)
      errors.back() = std::max(errors.back(), abs(control.coefficient(k) - mask.symbol().coefficient(k)));
  }
  return has_stable_shifts(mask, errors, sum_rules(mask_)).is_yes();
}

Threshold::Threshold(const RangeProperty& property, int arity, int rules)
    : arity_(arity), exponent_(rules - property.order) {}

double Threshold::value() const { return std::pow(arity_, exponent_.convert_to<double>()); }

Enclosure Threshold::raised(long length) const {
  const Rational exponent = exponent_ * Rational(length);
  const long top = numerator(exponent).convert_to<long>(), root = denominator(exponent).convert_to<long>();
  if (root == 1) return Enclosure::exactly(power(Rational(arity_), top));
  Enclosure modulus = root_enclosure(power(Rational(arity_), std::abs(top)), static_cast<int>(root));
  if (top >= 0) return modulus;
  return {1 / *modulus.upper, 1 / *modulus.lower};
}

}  // namespace subcert::family
