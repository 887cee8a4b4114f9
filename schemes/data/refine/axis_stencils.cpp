#include "axis_stencils.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <limits>

namespace subcert::data {

AxisStencils::AxisStencils(std::vector<Class> classes, const Rational& centre, int degree, int components)
    : classes_(std::move(classes)), centre_(centre), degree_(degree) {
  window_ = std::max<std::size_t>(2, static_cast<std::size_t>((degree + components) / components));
  for (const Class& one : classes_)
    window_ = std::max(window_, static_cast<std::size_t>((one.highest - one.lowest) / arity()) + 1);
}

std::size_t AxisStencils::residue(long output) const { return static_cast<std::size_t>(modulo(output, arity())); }

OutputRange AxisStencils::outputs(const Axis& axis, Boundary boundary) const {
  require_refinement_boundary(boundary);
  OutputRange range{axis, axis, 0, 0, 0, 0};
  Axis& input = range.input;
  if (boundary == Boundary::periodic) input.close();
  const std::size_t fewest = input.closed ? 1 : window_;
  require(axis.count >= fewest, "refine: need at least {} points, got {}", fewest, axis.count);
  if (!input.closed && boundary == Boundary::reflect && denominator(Rational(2 * centre_)) != 1)
    fail(ErrorKind::domain,
         "refine: reflect needs 2 tau to be an integer, got tau = {} (tau = a'(1) / a(1), the centre of a symmetric "
         "mask)",
         to_text(centre_));
  const long count = static_cast<long>(input.count);
  // Output i stands at (i + base) new steps from the beginning of the domain.
  const Rational base = arity() * input.first / input.step - centre_;
  range.complete_begin = std::numeric_limits<long>::min();
  range.complete_end = std::numeric_limits<long>::max();
  for (const Class& one : classes_) {  // from its first complete output on, the other classes follow within arity - 1
    range.complete_begin = std::max(range.complete_begin, one.highest - arity() + 1);
    range.complete_end = std::min(range.complete_end, one.lowest + arity() * count);
  }
  if (boundary == Boundary::shrink && !input.closed) {
    range.begin = range.complete_begin;
    range.end = range.complete_end;
  } else {
    range.begin = ceil_index(-base);
    range.end = input.closed ? range.begin + arity() * count
                             : floor_index(arity() * input.length / input.step - base) + 1;
  }
  require(range.end > range.begin, "refine: need more points for one output, got {}", input.count);
  range.complete_begin = std::max(range.complete_begin, range.begin);
  range.complete_end = std::min(range.complete_end, range.end);
  range.output = input;
  range.output.count = static_cast<std::size_t>(range.end - range.begin);
  range.output.step = input.step / arity();
  range.output.first = (range.begin + base) * range.output.step;
  return range;
}

std::size_t source(long j, const Axis& axis, Boundary boundary) {
  const long count = static_cast<long>(axis.count);
  if (axis.closed) return static_cast<std::size_t>(modulo(j, count));
  if (boundary == Boundary::reflect && (j < 0 || j >= count)) {
    const long low = floor_index(-2 * axis.first / axis.step), high = floor_index(2 * axis.length / axis.step) + low;
    while (j < 0 || j >= count) j = (j < 0 ? low : high) - j;
  }
  return static_cast<std::size_t>(j);
}

}  // namespace subcert::data
