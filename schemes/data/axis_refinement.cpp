#include "axis_refinement.hpp"

#include "weighted_sum.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/schemes/local_regression.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>

namespace subcert {
namespace {

long floor_divide(long a, long b) { return a / b - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0); }
long modulo(long a, long b) { return a - b * floor_divide(a, b); }

Integer floor_of(const Rational& x) {
  const Integer p = numerator(x), q = denominator(x);
  return p >= 0 ? p / q : -((-p + q - 1) / q);
}
long to_long(const Integer& x) { return x.convert_to<long>(); }
long floor_index(const Rational& x) { return to_long(floor_of(x)); }
long ceil_index(const Rational& x) { return -to_long(floor_of(-x)); }

/// The datum 0, ..., count - 1 that stands at index j after mirroring about twice_low / 2 and twice_high / 2, which
/// enclose the data. Domain: count >= 2.
std::size_t mirrored(long j, long count, long twice_low, long twice_high) {
  while (j < 0 || j >= count) j = (j < 0 ? twice_low : twice_high) - j;
  return static_cast<std::size_t>(j);
}

}  // namespace

AxisRefiner::AxisRefiner(const Mask& mask, Boundary boundary) : mask_(mask), boundary_(boundary) {
  if (!is_affine(mask)) throw std::invalid_argument("refine: need coset sums 1");
  const PolynomialReproduction polynomials = polynomial_reproduction(mask);
  const long arity = mask.arity();
  degree_ = polynomials.reproduction_degree;
  centre_ = polynomials.parametrization * (arity - 1);
  window_ = std::max<std::size_t>(2, static_cast<std::size_t>(degree_) + 1);
  const LaurentPolynomial& symbol = mask.symbol();
  for (long residue = 0; residue < arity; ++residue) {
    const LaurentPolynomial coset = symbol.coset(mask.arity(), residue);
    std::vector<Rational> weights = coset.coefficients();
    std::reverse(weights.begin(), weights.end());
    window_ = std::max(window_, weights.size());
    cosets_.push_back({residue + arity * coset.lowest(), residue + arity * coset.highest(), std::move(weights)});
  }
}

const AxisRefiner::Coset& AxisRefiner::coset_of(long output) const {
  return cosets_[static_cast<std::size_t>(modulo(output, mask_.arity()))];
}
long AxisRefiner::first_read(long output) const { return (output - coset_of(output).highest) / mask_.arity(); }
long AxisRefiner::last_read(long output) const { return (output - coset_of(output).lowest) / mask_.arity(); }

const std::vector<Rational>& AxisRefiner::fit(const Rational& position) {
  auto found = fits_.find(position);
  if (found == fits_.end()) {
    std::vector<Rational> nodes;
    for (std::size_t i = 0; i < window_; ++i) nodes.emplace_back(i);
    found = fits_.emplace(position, regression_weights(nodes, {}, degree_, position)).first;
  }
  return found->second;
}

/// Output i, numbered so that f'_i = sum of a_{i - arity*j} f_j with the data of the axis numbered from 0.
WeightRow<Rational> AxisRefiner::row(long output, const Axis& axis) {
  const auto count = static_cast<long>(axis.count);
  const long first = first_read(output), last = last_read(output);
  const bool complete = first >= 0 && last < count;
  WeightRow<Rational> result;
  if (!complete && !axis.closed && boundary_ == Boundary::regression) {
    const long shift = first < 0 ? 0 : count - static_cast<long>(window_);
    result.weights = fit(Rational(output - centre_) / mask_.arity() - shift);
    for (std::size_t k = 0; k < window_; ++k) result.at.push_back(static_cast<std::size_t>(shift) + k);
    return result;
  }
  const Rational low = -2 * axis.first / axis.step, high = 2 * axis.length / axis.step + low;
  std::map<std::size_t, Rational> collected;
  const std::vector<Rational>& weights = coset_of(output).weights;
  for (long j = first; j <= last; ++j) {
    const bool mirror = !complete && !axis.closed && boundary_ == Boundary::reflect;
    const std::size_t at = mirror ? mirrored(j, count, floor_index(low), floor_index(high))
                                  : static_cast<std::size_t>(modulo(j, count));
    collected[at] += weights[static_cast<std::size_t>(j - first)];
  }
  for (auto& [at, weight] : collected) {
    result.at.push_back(at);
    result.weights.push_back(std::move(weight));
  }
  return result;
}

AxisRefinement<Rational> AxisRefiner::step(const Axis& input) {
  Axis axis = input;
  if (boundary_ == Boundary::periodic && !axis.closed) {
    axis.closed = true;
    axis.length += axis.step;
  }
  if (axis.count < window_)
    throw std::invalid_argument("refine: need at least " + std::to_string(window_) + " points, got " +
                                std::to_string(axis.count));
  const long arity = mask_.arity(), count = static_cast<long>(axis.count);
  // Output i stands at (i + base) new steps from the beginning of the domain.
  const Rational base = arity * axis.first / axis.step - centre_;
  if (!axis.closed && boundary_ == Boundary::reflect && denominator(Rational(2 * centre_)) != 1)
    throw std::invalid_argument("refine: reflect needs 2 tau to be an integer, got tau = " + to_text(centre_) +
                                " (tau = a'(1) / arity, the centre of a symmetric mask)");
  long begin = ceil_index(-base), end = 0;  // outputs begin, ..., end - 1
  if (axis.closed) {
    end = begin + arity * count;
  } else if (boundary_ == Boundary::shrink) {
    begin = std::numeric_limits<long>::min();
    end = std::numeric_limits<long>::max();
    for (const Coset& coset : cosets_) {  // outputs of this class are complete from `highest` on, up to the last
      begin = std::max(begin, coset.highest - arity + 1);
      end = std::min(end, coset.lowest + arity * count);
    }
  } else {
    end = floor_index(arity * axis.length / axis.step - base) + 1;
  }
  if (end <= begin)
    throw std::invalid_argument("refine: need more points for one output, got " + std::to_string(axis.count));

  // The complete stencils, from the first phase on which all are.
  long complete_begin = begin, complete_end = end;
  for (const Coset& coset : cosets_) {
    complete_begin = std::max(complete_begin, coset.highest - arity + 1);
    complete_end = std::min(complete_end, coset.lowest + arity * count);
  }
  complete_begin = std::min(complete_begin, end);
  AxisRefinement<Rational> result{axis, axis, {}, {}, 0, {}};
  result.groups = static_cast<std::size_t>(std::max(0L, floor_divide(complete_end - complete_begin, arity)));
  if (result.groups == 0) complete_begin = begin;
  for (long i = begin; i < complete_begin; ++i) result.head.push_back(row(i, axis));
  for (long i = complete_begin; result.groups > 0 && i < complete_begin + arity; ++i)
    result.phases.push_back({static_cast<std::size_t>(first_read(i)), coset_of(i).weights});
  for (long i = complete_begin + arity * static_cast<long>(result.groups); i < end; ++i)
    result.tail.push_back(row(i, axis));
  result.output.count = static_cast<std::size_t>(end - begin);
  result.output.step = axis.step / arity;
  result.output.first = (begin + base) * result.output.step;
  return result;
}

double nearest_double(const Rational& value) {
  double best = value.convert_to<double>();
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

namespace {

template <class Number>
std::vector<Number> converted_weights(const std::vector<Rational>& weights) {
  if constexpr (std::is_same_v<Number, Rational>) {
    return weights;
  } else {
    std::vector<Number> result;
    for (const Rational& weight : weights) result.push_back(nearest_double(weight));
    return result;
  }
}

template <class Number>
void apply_row(const WeightRow<Number>& row, const Number* in, Number* out, std::size_t inner) {
  for (std::size_t c = 0; c < inner; ++c) out[c] = row.weights[0] * in[row.at[0] * inner + c];
  for (std::size_t k = 1; k < row.at.size(); ++k)
    for (std::size_t c = 0; c < inner; ++c) out[c] += row.weights[k] * in[row.at[k] * inner + c];
}

/// Groups begin, ..., end - 1; `out` is where group 0 goes.
void apply_groups(const std::vector<Phase<Rational>>& phases, const Rational* in, Rational* out, std::size_t inner,
                  std::size_t begin, std::size_t end) {
  for (std::size_t g = begin; g < end; ++g)
    for (std::size_t p = 0; p < phases.size(); ++p)
      for (std::size_t c = 0; c < inner; ++c) {
        Rational sum = 0;
        for (std::size_t k = 0; k < phases[p].weights.size(); ++k)
          sum += phases[p].weights[k] * in[(phases[p].first + g + k) * inner + c];
        out[(g * phases.size() + p) * inner + c] = sum;
      }
}

constexpr std::size_t block_length = 512;  // numbers of a block: input, parts and output fit the nearest cache

void apply_groups(const std::vector<Phase<double>>& phases, const double* in, double* out, std::size_t inner,
                  std::size_t begin, std::size_t end) {
  const std::size_t arity = phases.size();
  if (inner >= block_length / 2) {  // whole rows, no merging
    for (std::size_t g = begin; g < end; ++g)
      for (std::size_t c = 0; c < inner; c += block_length)
        for (std::size_t p = 0; p < arity; ++p)
          weighted_sum(in + (phases[p].first + g) * inner + c, inner, phases[p].weights.data(), phases[p].weights.size(),
                       std::min(block_length, inner - c), out + (g * arity + p) * inner + c);
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

constexpr std::size_t least_work = 1 << 16;  // outputs that are worth a thread

/// Calls work(begin, end) on disjoint ranges that cover 0, ..., count - 1.
template <class Work>
void in_ranges(std::size_t count, std::size_t numbers, int threads, const Work& work) {
  const std::size_t team = std::clamp<std::size_t>(
      std::min(numbers / least_work, count), 1, static_cast<std::size_t>(std::max(threads, 1)));
  std::vector<std::jthread> helpers;
  for (std::size_t t = 1; t < team; ++t)
    helpers.emplace_back([&work, count, team, t] { work(count * t / team, count * (t + 1) / team); });
  work(0, count / team);
}

}  // namespace

template <class Number>
AxisRefinement<Number> converted(const AxisRefinement<Rational>& rows) {
  AxisRefinement<Number> result{rows.input, rows.output, {}, {}, rows.groups, {}};
  for (const auto& row : rows.head) result.head.push_back({row.at, converted_weights<Number>(row.weights)});
  for (const auto& phase : rows.phases) result.phases.push_back({phase.first, converted_weights<Number>(phase.weights)});
  for (const auto& row : rows.tail) result.tail.push_back({row.at, converted_weights<Number>(row.weights)});
  return result;
}

template <class Number>
void apply(const AxisRefinement<Number>& rows, const Number* in, Number* out, std::size_t outer, std::size_t inner,
           int threads) {
  const std::size_t numbers = outer * rows.outputs() * inner;
  const auto piece = [&](std::size_t o, std::size_t begin, std::size_t end) {
    const Number* const source = in + o * rows.input.count * inner;
    Number* const target = out + o * rows.outputs() * inner;
    if (begin == 0)
      for (std::size_t i = 0; i < rows.head.size(); ++i) apply_row(rows.head[i], source, target + i * inner, inner);
    apply_groups(rows.phases, source, target + rows.head.size() * inner, inner, begin, end);
    if (end == rows.groups)
      for (std::size_t i = 0; i < rows.tail.size(); ++i)
        apply_row(rows.tail[i], source, target + (rows.outputs() - rows.tail.size() + i) * inner, inner);
  };
  if (outer >= 16)
    in_ranges(outer, numbers, threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t o = begin; o < end; ++o) piece(o, 0, rows.groups);
    });
  else
    for (std::size_t o = 0; o < outer; ++o)
      in_ranges(rows.groups, numbers / outer, threads,
                [&](std::size_t begin, std::size_t end) { piece(o, begin, end); });
}

template AxisRefinement<double> converted<double>(const AxisRefinement<Rational>&);
template AxisRefinement<Rational> converted<Rational>(const AxisRefinement<Rational>&);
template void apply<double>(const AxisRefinement<double>&, const double*, double*, std::size_t, std::size_t, int);
template void apply<Rational>(const AxisRefinement<Rational>&, const Rational*, Rational*, std::size_t, std::size_t, int);

}  // namespace subcert
