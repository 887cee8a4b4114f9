#pragma once
/// One refinement step along one axis, written as rows of weights.

#include "axis_stencils.hpp"

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/schemes/vector_schemes.hpp>

#include <map>
#include <optional>

namespace subcert::data {

/// new value = sum of weights[k] * value[at[k]]. Numbers of a datum that has several count as values, one after
/// another.
template <class Number>
struct WeightRow {
  std::vector<std::size_t> at;
  std::vector<Number> weights;
};

/// The rule of the outputs of one phase where every stencil is complete: output group g reads first + g * stride and
/// the data that follow, with the stride of the step.
template <class Number>
struct Phase {
  std::size_t first;
  std::vector<Number> weights;
};

/// Outputs, in this order: head.size() single rows, `groups` groups with one output of each phase, tail.size() single
/// rows. Canonical: as many phases as the arity times the components where groups > 0.
template <class Number>
struct AxisRefinement {
  Axis input;
  Axis output;
  std::vector<WeightRow<Number>> head;
  std::vector<Phase<Number>> phases;
  std::size_t groups = 0;
  std::vector<WeightRow<Number>> tail;
  std::size_t stride = 1;
  std::size_t components = 1;  ///< numbers of each datum and output that rows tell apart; several only of curves

  std::size_t outputs() const { return head.size() + groups * phases.size() + tail.size(); }
};

/// The rule of one variable with numbers or r x r matrices as weights.
struct AxisRule {
  AxisStencils stencils;
  /// [r * residue class + number of the output], in the order of the data, the numbers of each one after another.
  std::vector<std::vector<Rational>> weights;
  int components = 1;  ///< r; several are values and derivatives where a polynomial is fitted to them
};

/// Writes the step of a rule as rows, for as many axes and levels as are asked for; fits at the ends are kept for the
/// next question.
class AxisRefiner {
 public:
  /// Domain: coset sums 1. Errors: throws a domain error.
  AxisRefiner(const Mask& mask, Boundary boundary);
  /// Domain: `reflect` asks for numbers as weights, `regression` for a degree of 0 or more.
  AxisRefiner(AxisRule rule, Boundary boundary) : boundary_(boundary), rule_(std::move(rule)) {}

  std::size_t window() const { return rule_.stencils.window(); }

  /// Domain and errors: as AxisStencils::outputs. Cost: exact arithmetic for the outputs near the ends.
  AxisRefinement<Rational> step(const Axis& axis);

 private:
  /// A list of weights for each component.
  const std::vector<std::vector<Rational>>& fit(const Rational& position);
  WeightRow<Rational> row(long output, std::size_t component, const Axis& axis);
  void append_rows(std::vector<WeightRow<Rational>>& rows, long begin, long end, const Axis& axis);
  const std::vector<Rational>& weights(long output, std::size_t component) const;

  Boundary boundary_;
  AxisRule rule_;
  std::optional<HermiteFit> hermite_;
  std::map<Rational, std::vector<std::vector<Rational>>> fits_;
};

/// The stencils of a mask of one variable. Domain: coset sums 1. Errors: throws a domain error.
AxisStencils axis_stencils(const Mask& mask);

/// The weights, the sum of those of one datum at one place.
WeightRow<Rational> collected(const std::map<std::size_t, Rational>& weights);

/// The same weights and rows in another number type; doubles are the nearest ones.
template <class Number>
std::vector<Number> converted(const std::vector<Rational>& weights);
template <class Number>
AxisRefinement<Number> converted(const AxisRefinement<Rational>& rows);

/// A step along the axis with this number.
struct StepAlong {
  std::size_t axis;
  AxisRefinement<Rational> rows;
};

/// Numbers to write that are worth a thread of their own.
constexpr std::size_t numbers_per_thread = 1 << 16;

/// The double nearest to `value` (ties to either side). Domain: |value| within the range of doubles.
double nearest_double(const Rational& value);

/// Applies the step to `in`, seen as [outer][input.count][inner], and writes `out`, [outer][outputs][inner].
/// Cost: linear; for doubles two block-wise passes that stay in the nearest cache, on `threads` threads.
template <class Number>
void apply(const AxisRefinement<Number>& rows, const Number* in, Number* out, std::size_t outer, std::size_t inner,
           int threads = 1);

/// The data after the step along axis k, whose input is data.axes[k].
template <class Number>
GridData<Number> apply_along(const GridData<Number>& data, std::size_t k, const AxisRefinement<Number>& rows,
                             int threads = 1);

}  // namespace subcert::data
