#include "axis_refinement.hpp"

#include "weighted_sum.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/schemes/local_regression.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace subcert::data {
AxisStencils axis_stencils(const Mask& mask) {
  require(is_affine(mask), "refine: need coset sums 1");
  const PolynomialReproduction polynomials = polynomial_reproduction(mask);
  std::vector<AxisStencils::Class> classes;
  for (long residue = 0; residue < mask.arity(); ++residue) {
    const LaurentPolynomial coset = mask.symbol().coset(mask.arity(), residue);
    classes.push_back({residue + mask.arity() * coset.lowest(), residue + mask.arity() * coset.highest()});
  }
  return {std::move(classes), polynomials.parametrization.front() * (mask.arity() - 1),
          polynomials.reproduction_degree};
}

AxisRefiner::AxisRefiner(const Mask& mask, Boundary boundary) : boundary_(boundary), rule_{axis_stencils(mask), {}} {
  for (long residue = 0; residue < mask.arity(); ++residue) {
    rule_.weights.push_back(mask.symbol().coset(mask.arity(), residue).coefficients());
    std::reverse(rule_.weights.back().begin(), rule_.weights.back().end());
  }
}

const std::vector<std::vector<Rational>>& AxisRefiner::fit(const Rational& position) {
  if (const auto found = fits_.find(position); found != fits_.end()) return found->second;
  const int degree = rule_.stencils.degree();
  std::vector<std::vector<Rational>>& result = fits_[position];
  if (rule_.components == 1) {
    std::vector<Rational> nodes;
    for (std::size_t i = 0; i < window(); ++i) nodes.emplace_back(i);
    result.push_back(regression_weights(nodes, {}, degree, position));
    return result;
  }
  if (!hermite_) hermite_.emplace(0, static_cast<long>(window()) - 1, rule_.components, degree);
  const RationalMatrix weights = hermite_->weights(position, static_cast<int>(rule_.stencils.arity()));
  for (std::size_t k = 0; k < weights.rows(); ++k) {
    result.emplace_back();
    for (std::size_t i = 0; i < weights.columns(); ++i) result.back().push_back(weights(k, i));
  }
  return result;
}

const std::vector<Rational>& AxisRefiner::weights(long output, std::size_t component) const {
  return rule_.weights[rule_.stencils.residue(output) * static_cast<std::size_t>(rule_.components) + component];
}

WeightRow<Rational> AxisRefiner::row(long output, std::size_t component, const Axis& axis) {
  const AxisStencils& stencils = rule_.stencils;
  const auto components = static_cast<std::size_t>(rule_.components);
  const long count = static_cast<long>(axis.count), first = stencils.first_read(output),
             last = stencils.last_read(output);
  WeightRow<Rational> result;
  if ((first < 0 || last >= count) && !axis.closed && boundary_ == Boundary::regression) {
    const long shift = first < 0 ? 0 : count - static_cast<long>(window());
    result.weights = fit(stencils.position(output) - shift)[component];
    for (std::size_t k = 0; k < result.weights.size(); ++k)
      result.at.push_back(static_cast<std::size_t>(shift) * components + k);
    return result;
  }
  std::map<std::size_t, Rational> sums;
  auto weight = weights(output, component).begin();
  for (long j = first; j <= last; ++j)
    for (std::size_t l = 0; l < components; ++l) sums[source(j, axis, boundary_) * components + l] += *weight++;
  return collected(sums);
}

void AxisRefiner::append_rows(std::vector<WeightRow<Rational>>& rows, long begin, long end, const Axis& axis) {
  for (long i = begin; i < end; ++i)
    for (int k = 0; k < rule_.components; ++k) rows.push_back(row(i, static_cast<std::size_t>(k), axis));
}

WeightRow<Rational> collected(const std::map<std::size_t, Rational>& weights) {
  WeightRow<Rational> result;
  for (const auto& [at, weight] : weights) {
    result.at.push_back(at);
    result.weights.push_back(weight);
  }
  return result;
}

AxisRefinement<Rational> AxisRefiner::step(const Axis& axis) {
  const AxisStencils& stencils = rule_.stencils;
  const OutputRange range = stencils.outputs(axis, boundary_);
  const auto components = static_cast<std::size_t>(rule_.components);
  const long arity = stencils.arity();
  AxisRefinement<Rational> result{range.input, range.output, {}, {}, 0, {}, components, components};
  const long groups = std::max(0L, (range.complete_end - range.complete_begin) / arity);
  const long begin = groups > 0 ? range.complete_begin : range.begin;
  result.groups = static_cast<std::size_t>(groups);
  append_rows(result.head, range.begin, begin, range.input);
  if (groups > 0)
    for (long i = begin; i < begin + arity; ++i)
      for (std::size_t k = 0; k < components; ++k)
        result.phases.push_back({static_cast<std::size_t>(stencils.first_read(i)) * components, weights(i, k)});
  append_rows(result.tail, begin + arity * groups, range.end, range.input);
  return result;
}

double nearest_double(const Rational& value) {
  double best = value.convert_to<double>();
  if (std::isnormal(best) || value.is_zero()) return best;
  Rational error = abs(value - Rational(best));
  for (const double toward : {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}) {
    const double next = std::nextafter(value.convert_to<double>(), toward);
    const Rational other = std::isfinite(next) ? abs(value - Rational(next)) : error;
    if (other < error) {
      best = next;
      error = other;
    }
  }
  return best;
}

template <>
std::vector<Rational> converted<Rational>(const std::vector<Rational>& weights) {
  return weights;
}

template <>
std::vector<double> converted<double>(const std::vector<Rational>& weights) {
  std::vector<double> result;
  for (const Rational& weight : weights) result.push_back(nearest_double(weight));
  return result;
}

namespace {

template <class Number>
void apply_row(const WeightRow<Number>& row, const Number* in, Number* out, std::size_t inner) {
  for (std::size_t c = 0; c < inner; ++c) out[c] = row.weights[0] * in[row.at[0] * inner + c];
  for (std::size_t k = 1; k < row.at.size(); ++k)
    for (std::size_t c = 0; c < inner; ++c) out[c] += row.weights[k] * in[row.at[k] * inner + c];
}

/// Groups begin, ..., end - 1; `out` is where group 0 goes.
template <class Number>
void apply_groups_plainly(const AxisRefinement<Number>& rows, const Number* in, Number* out, std::size_t inner,
                          std::size_t begin, std::size_t end) {
  const std::size_t arity = rows.phases.size();
  for (std::size_t g = begin; g < end; ++g)
    for (std::size_t p = 0; p < arity; ++p)
      for (std::size_t c = 0; c < inner; ++c) {
        const Phase<Number>& phase = rows.phases[p];
        Number sum = 0;
        for (std::size_t k = 0; k < phase.weights.size(); ++k)
          sum += phase.weights[k] * in[(phase.first + g * rows.stride + k) * inner + c];
        out[(g * arity + p) * inner + c] = sum;
      }
}

void apply_groups(const AxisRefinement<Rational>& rows, const Rational* in, Rational* out, std::size_t inner,
                  std::size_t begin, std::size_t end) {
  apply_groups_plainly(rows, in, out, inner, begin, end);
}

constexpr std::size_t block_length = 512;  // numbers of a block: input, parts and output fit the nearest cache

void apply_groups(const AxisRefinement<double>& rows, const double* in, double* out, std::size_t inner,
                  std::size_t begin, std::size_t end) {
  if (rows.stride != 1) return apply_groups_plainly(rows, in, out, inner, begin, end);
  const std::vector<Phase<double>>& phases = rows.phases;
  const std::size_t arity = phases.size();
  if (inner >= block_length / 2) {  // whole rows, no merging
    for (std::size_t g = begin; g < end; ++g)
      for (std::size_t c = 0; c < inner; c += block_length)
        for (std::size_t p = 0; p < arity; ++p)
          weighted_sum(in + (phases[p].first + g) * inner + c, inner, phases[p].weights.data(),
                       phases[p].weights.size(), std::min(block_length, inner - c), out + (g * arity + p) * inner + c);
    return;
  }
  const std::size_t block = std::max<std::size_t>(1, block_length / inner);
  std::vector<double> parts(arity * block * inner);
  for (std::size_t g = begin; g < end; g += block) {
    const std::size_t groups = std::min(block, end - g);
    for (std::size_t p = 0; p < arity; ++p)
      weighted_sum(in + (phases[p].first + g) * inner, inner, phases[p].weights.data(), phases[p].weights.size(),
                   groups * inner, parts.data() + p * block * inner);
    interleave(parts.data(), block * inner, arity, groups, inner, out + g * arity * inner);
  }
}

}  // namespace

template <class Number>
AxisRefinement<Number> converted(const AxisRefinement<Rational>& rows) {
  AxisRefinement<Number> result{rows.input, rows.output, {}, {}, rows.groups, {}, rows.stride, rows.components};
  for (const auto& row : rows.head) result.head.push_back({row.at, converted<Number>(row.weights)});
  for (const auto& phase : rows.phases) result.phases.push_back({phase.first, converted<Number>(phase.weights)});
  for (const auto& row : rows.tail) result.tail.push_back({row.at, converted<Number>(row.weights)});
  return result;
}

template <class Number>
void apply(const AxisRefinement<Number>& rows, const Number* in, Number* out, std::size_t outer, std::size_t inner,
           int threads) {
  const std::size_t numbers = outer * rows.outputs() * inner;
  const auto piece = [&](std::size_t o, std::size_t begin, std::size_t end) {
    const Number* const source = in + o * rows.input.count * rows.components * inner;
    Number* const target = out + o * rows.outputs() * inner;
    if (begin == 0)
      for (std::size_t i = 0; i < rows.head.size(); ++i) apply_row(rows.head[i], source, target + i * inner, inner);
    apply_groups(rows, source, target + rows.head.size() * inner, inner, begin, end);
    if (end == rows.groups)
      for (std::size_t i = 0; i < rows.tail.size(); ++i)
        apply_row(rows.tail[i], source, target + (rows.outputs() - rows.tail.size() + i) * inner, inner);
  };
  if (outer >= 16)
    parallel_ranges(outer, numbers / numbers_per_thread, threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t o = begin; o < end; ++o) piece(o, 0, rows.groups);
    });
  else
    for (std::size_t o = 0; o < outer; ++o)
      parallel_ranges(rows.groups, numbers / outer / numbers_per_thread, threads,
                      [&](std::size_t begin, std::size_t end) { piece(o, begin, end); });
}

template <class Number>
GridData<Number> apply_along(const GridData<Number>& data, std::size_t k, const AxisRefinement<Number>& rows,
                             int threads) {
  GridData<Number> result{{}, data.dimension, data.axes};
  result.axes[k] = rows.output;
  std::size_t inner = data.dimension / rows.components, outer = 1;
  for (std::size_t l = 0; l < k; ++l) inner *= data.axes[l].count;
  for (std::size_t l = k + 1; l < data.axes.size(); ++l) outer *= data.axes[l].count;
  result.values.resize(outer * rows.outputs() * inner);
  apply(rows, data.values.data(), result.values.data(), outer, inner, threads);
  return result;
}

template AxisRefinement<double> converted<double>(const AxisRefinement<Rational>&);
template AxisRefinement<Rational> converted<Rational>(const AxisRefinement<Rational>&);
template void apply<double>(const AxisRefinement<double>&, const double*, double*, std::size_t, std::size_t, int);
template void apply<Rational>(const AxisRefinement<Rational>&, const Rational*, Rational*, std::size_t, std::size_t,
                              int);

template GridData<double> apply_along<double>(const GridData<double>&, std::size_t, const AxisRefinement<double>&, int);
template GridData<Rational> apply_along<Rational>(const GridData<Rational>&, std::size_t,
                                                  const AxisRefinement<Rational>&, int);

}  // namespace subcert::data
