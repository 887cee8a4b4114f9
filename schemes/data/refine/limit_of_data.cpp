#include "refine.hpp"

#include "axis_refinement.hpp"
#include "grid_refinement.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/polynomials/root_modulus.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <stdexcept>

namespace subcert::data {
namespace {

/// The first outputs of a step as a matrix on the first data: as many rows as columns, so that steps multiply.
RationalMatrix end_matrix(const AxisRefinement<Rational>& rows, std::size_t size) {
  RationalMatrix matrix(size, size);
  for (std::size_t i = 0; i < size; ++i) {
    if (i < rows.head.size()) {
      for (std::size_t k = 0; k < rows.head[i].at.size(); ++k) matrix(i, rows.head[i].at[k]) += rows.head[i].weights[k];
    } else {
      const std::size_t group = (i - rows.head.size()) / rows.phases.size();
      const Phase<Rational>& phase = rows.phases[(i - rows.head.size()) % rows.phases.size()];
      for (std::size_t k = 0; k < phase.weights.size(); ++k) matrix(i, phase.first + group + k) += phase.weights[k];
    }
  }
  return matrix;
}

/// How many first data determine as many first outputs on all levels.
std::size_t end_size(const AxisStencils& stencils) {
  // An output of index i reads up to datum (i - lowest) / arity, and its index passes its number by at most the centre.
  return 2 * stencils.window() + 2;
}

/// The weights of the first data in the limit at the first end of the domain; `axis` is that of the data.
std::vector<Rational> end_functional(const Mask& mask, Axis axis) {
  AxisRefiner refiner(mask, Boundary::regression);
  const std::size_t size = end_size(axis_stencils(mask));
  // Far from the other end; the offsets of the first points run into a cycle.
  std::vector<RationalMatrix> steps;
  std::vector<Rational> offsets;
  std::size_t cycle = 0;
  for (;;) {
    axis.count = std::max(axis.count, 4 * size);
    axis.length = axis.first + axis.step * Rational(axis.count - 1);
    const Rational offset = axis.first / axis.step;
    const auto seen = std::find(offsets.begin(), offsets.end(), offset);
    if (seen != offsets.end()) {
      cycle = static_cast<std::size_t>(seen - offsets.begin());
      break;
    }
    require(offsets.size() != 64, "limit_of_data: the grids at the end do not repeat within 64 levels");
    offsets.push_back(offset);
    const AxisRefinement<Rational> rows = refiner.step(axis);
    steps.push_back(end_matrix(rows, size));
    axis = rows.output;
  }
  RationalMatrix round = RationalMatrix::identity(size);
  for (std::size_t k = cycle; k < steps.size(); ++k) round = steps[k] * round;
  // The functional that the round keeps: it must be the only one, and all others must die out.
  const auto rest = characteristic_polynomial(round).exact_quotient(LaurentPolynomial({-1, 1}, 0));
  if (!rest || !(*largest_root_modulus(*rest).largest.upper < 1))
    fail(ErrorKind::domain, "limit_of_data: refinement is not proved to converge at an end of open data");
  RationalMatrix transposed(size, size);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) transposed(i, j) = round(j, i) - (i == j ? 1 : 0);
  std::vector<Rational> functional = kernel(transposed).front();
  Rational sum = 0;
  for (const Rational& weight : functional) sum += weight;
  for (Rational& weight : functional) weight /= sum;
  for (std::size_t k = cycle; k-- > 0;) {
    std::vector<Rational> earlier(size, 0);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) earlier[j] += functional[i] * steps[k](i, j);
    functional = std::move(earlier);
  }
  while (functional.back() == 0) functional.pop_back();
  return functional;
}

/// The limit along one axis at every `stride`-th multiple of its step, from data that are fine enough for it.
class LimitRows {
 public:
  LimitRows(const Mask& mask, const Axis& axis, Boundary boundary, long stride)
      : mask_(mask), axis_(axis), boundary_(boundary), stride_(stride) {
    // The datum j stands at j + offset; the limit at y takes it with phi(y - j + shift).
    offset_ = axis.first / axis.step;
    shift_ = polynomial_reproduction(mask).parametrization.front() - offset_;
    const ShiftedValues values = limit_values_at(mask, shift_);
    weights_.assign(values.values.rbegin(), values.values.rend());
    last_ = -values.first;  // the last datum in the closed support at y = 0
    const Interval support = limit_support(mask);
    const bool touches_first = shift_ + values.first == support.lower;
    const bool touches_last = shift_ + values.first + static_cast<long>(weights_.size()) - 1 == support.upper;
    support_last_ = last_ - (touches_first ? 1 : 0);
    support_first_ = last_ - static_cast<long>(weights_.size()) + 1 + (touches_last ? 1 : 0);
    while (weights_.back() == 0) {
      weights_.pop_back();
      --last_;
    }
    weights_.erase(weights_.begin(),
                   std::find_if(weights_.begin(), weights_.end(), [](const Rational& w) { return w != 0; }));
    first_ = last_ - static_cast<long>(weights_.size()) + 1;
  }

  AxisRefinement<Rational> make() const {
    const long count = static_cast<long>(axis_.count);
    const Rational end = axis_.length / axis_.step / stride_;  // in outputs
    const long ends = (numerator(end) / denominator(end)).convert_to<long>();
    long begin = 0, stop = axis_.closed ? ends : ends + 1;
    const bool shrink = boundary_ == Boundary::shrink && !axis_.closed;
    AxisRefinement<Rational> result{axis_, axis_, {}, {}, 0, {}};
    const auto complete = [&](long i) { return i * stride_ + first_ >= 0 && i * stride_ + last_ < count; };
    const auto supported = [&](long i) {
      return i * stride_ + support_first_ >= 0 && i * stride_ + support_last_ < count;
    };
    while (shrink && begin < stop && !supported(begin)) ++begin;
    while (shrink && begin < stop && !supported(stop - 1)) --stop;
    require(begin < stop, "limit_of_data: need more points for one value, got {}", count);
    long head = begin, tail = stop;
    while (head < stop && !complete(head)) result.head.push_back(row(head++, ends));
    while (tail > head && !complete(tail - 1)) --tail;
    for (long i = tail; i < stop; ++i) result.tail.push_back(row(i, ends));
    result.groups = static_cast<std::size_t>(tail - head);
    result.stride = static_cast<std::size_t>(stride_);
    if (result.groups > 0) result.phases.push_back({static_cast<std::size_t>(head * stride_ + first_), weights_});
    result.output.count = static_cast<std::size_t>(stop - begin);
    result.output.step = axis_.step * stride_;
    result.output.first = begin * result.output.step;
    return result;
  }

 private:
  WeightRow<Rational> row(long output, long ends) const {
    WeightRow<Rational> result;
    if (!axis_.closed && boundary_ == Boundary::regression) {
      if (output != 0 && output != ends) throw std::logic_error("limit_of_data: data too coarse near an end");
      const bool first = output == 0;
      const Axis mirrored{axis_.count, false, axis_.length, axis_.length - axis_.parameter(axis_.count - 1),
                          axis_.step};
      result.weights = first ? end_functional(mask_, axis_)
                             : end_functional(Mask(mask_.symbol().reversed(), mask_.arity()), mirrored);
      for (std::size_t k = 0; k < result.weights.size(); ++k) result.at.push_back(first ? k : axis_.count - 1 - k);
      return result;
    }
    std::map<std::size_t, Rational> sums;
    for (std::size_t k = 0; k < weights_.size(); ++k)
      sums[source(output * stride_ + first_ + static_cast<long>(k), axis_, boundary_)] += weights_[k];
    return collected(sums);
  }

  Mask mask_;
  Axis axis_;
  Boundary boundary_;
  long stride_;
  Rational offset_;
  Rational shift_;
  std::vector<Rational> weights_;  // of the data first_, ..., last_ at y = 0
  long first_;
  long last_;
  long support_first_;  // the data in the open support, whether their weights vanish or not
  long support_last_;
};

/// Levels beyond the asked one after which the support of the limit function around the point next to an end lies
/// within the data, and the rows of end_functional() too.
int extra_levels(const Mask& mask) {
  const Interval support = limit_support(mask);
  const Rational shift = abs(polynomial_reproduction(mask).parametrization.front());
  const Rational reach = std::max(Rational(abs(support.lower)), Rational(abs(support.upper))) + shift + 2;
  int levels = 0;
  for (Rational power_of_arity = 1;
       power_of_arity < reach || power_of_arity + 1 < Rational(end_size(axis_stencils(mask)));
       power_of_arity *= mask.arity())
    ++levels;
  return levels;
}

}  // namespace

std::vector<StepAlong> steps_of_limit(std::vector<Axis> axes, std::size_t dimension, const std::vector<Mask>& masks,
                                      const RefineOptions& options, double most) {
  require(masks.size() == axes.size(), "limit_of_data: need one factor for each axis, got {} for {}", masks.size(),
          axes.size());
  std::vector<StepAlong> steps;
  for (std::size_t k = 0; k < masks.size(); ++k) {
    Axis& axis = axes[k];
    if (options.boundary == Boundary::periodic) axis.close();
    const bool ends = options.boundary == Boundary::regression && !axis.closed;
    const int extra = ends ? extra_levels(masks[k]) : 0;
    require_refinable(numbers_of_slice(axes, dimension) * axes.back().count, masks[k].arity(), options.levels + extra,
                      most);
    AxisRefiner refiner(masks[k], options.boundary);
    long stride = 1;
    for (int level = 0; level < options.levels + extra; ++level) {
      axis = steps.emplace_back(StepAlong{k, refiner.step(axis)}).rows.output;
      if (level >= options.levels) stride *= masks[k].arity();
    }
    axis = steps.emplace_back(StepAlong{k, LimitRows(masks[k], axis, options.boundary, stride).make()}).rows.output;
  }
  return steps;
}

template <class Number>
GridData<Number> limit_of_data(const GridData<Number>& data, const LatticeMask& mask, const RefineOptions& options) {
  return refined_along_axes(
      data, steps_of_limit(data.axes, data.dimension, mask.factors(), options, most_refined_numbers), options.threads);
}

template GridData<double> limit_of_data<double>(const GridData<double>&, const LatticeMask&, const RefineOptions&);
template GridData<Rational> limit_of_data<Rational>(const GridData<Rational>&, const LatticeMask&,
                                                    const RefineOptions&);

}  // namespace subcert::data
