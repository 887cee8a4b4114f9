#include "slab_refinement.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <limits>

namespace subcert::data {
namespace {

constexpr std::size_t fewest_slices = 32, numbers_of_slab = 1 << 18;

/// The part of a step that makes some of its outputs, and the data begin, ..., end - 1 that it reads; on a closed axis
/// these go round. Rows and phases count from `begin`.
class PartOfStep {
 public:
  PartOfStep(const AxisRefinement<double>& step, std::size_t first, std::size_t last) : step_(step) {
    const std::size_t arity = step.phases.size(), head = step.head.size(), tail = head + step.groups * arity;
    for (std::size_t o = first; o < std::min(last, head); ++o) add(step.head[o], -1, part_.head);
    const std::size_t low = std::max(first, head) - head, high = std::max(std::min(last, tail), head) - head;
    if (low < high) add_groups(low, high);
    for (std::size_t o = std::max(first, tail); o < last; ++o) add(step.tail[o - tail], 1, part_.tail);
    for (auto* rows : {&part_.head, &part_.tail})
      for (WeightRow<double>& row : *rows)
        for (std::size_t& at : row.at) at -= static_cast<std::size_t>(begin);  // modulo 2^64, as add() left them
    for (Phase<double>& phase : part_.phases) phase.first -= static_cast<std::size_t>(begin);
    part_.input.count = static_cast<std::size_t>(end - begin);
  }

  long begin = std::numeric_limits<long>::max();
  long end = std::numeric_limits<long>::min();
  const AxisRefinement<double>& part() const { return part_; }

 private:
  void read(long at, std::size_t count = 1) {
    begin = std::min(begin, at);
    end = std::max(end, at + static_cast<long>(count));
  }

  /// `side`: of the axis at which the row stands; data beyond it come from the other one.
  void add(WeightRow<double> row, int side, std::vector<WeightRow<double>>& rows) {
    const auto count = static_cast<long>(step_.input.count);
    for (std::size_t& at : row.at) {
      auto place = static_cast<long>(at);
      if (step_.input.closed && (side < 0 ? 2 * place > count : side > 0 && 2 * place < count)) place += side * count;
      read(place);
      at = static_cast<std::size_t>(place);
    }
    rows.push_back(std::move(row));
  }

  /// Outputs low, ..., high - 1 of the groups: single ones about whole groups.
  void add_groups(std::size_t low, std::size_t high) {
    const std::size_t arity = step_.phases.size(), first = (low + arity - 1) / arity, last = high / arity;
    const auto single = [&](std::size_t o, std::vector<WeightRow<double>>& rows) {
      const Phase<double>& phase = step_.phases[o % arity];
      WeightRow<double> row{{}, phase.weights};
      for (std::size_t k = 0; k < phase.weights.size(); ++k)
        row.at.push_back(phase.first + o / arity * step_.stride + k);
      add(std::move(row), 0, rows);
    };
    for (std::size_t o = low; o < std::min(high, first * arity); ++o) single(o, part_.head);
    if (first < last) {
      part_.phases = step_.phases;
      part_.groups = last - first;
      for (Phase<double>& phase : part_.phases) {
        phase.first += first * step_.stride;
        read(static_cast<long>(phase.first), (part_.groups - 1) * step_.stride + phase.weights.size());
      }
    }
    for (std::size_t o = std::max(low, std::max(first, last) * arity); o < high; ++o) single(o, part_.tail);
  }

  const AxisRefinement<double>& step_;
  AxisRefinement<double> part_{step_.input, step_.output, {}, {}, 0, {}, step_.stride};
};

}  // namespace

SlabRefinement::SlabRefinement(const GridData<double>& data, const LatticeMask& mask, const RefineOptions& options)
    : data_(data), threads_(options.threads) {
  require(data.is_canonical(), "refine: need as many values as points times coordinates");
  require(mask.has_factors(), "refine by slabs: need a mask with factors");
  require(static_cast<std::size_t>(mask.dimension()) == data.axes.size(),
          "refine: need as many axes as variables, got {} for {}", data.axes.size(), mask.dimension());
  require(options.levels >= 0, "refine: need levels >= 0, got {}", options.levels);
  require_refinable(data.values.size(), mask.dilation().classes(), options.levels, most_streamed_numbers);
  std::vector<AxisRefiner> refiners;
  for (const Mask& factor : mask.factors()) refiners.emplace_back(factor, options.boundary);
  for (int level = 0; level < options.levels; ++level) {
    Level next;
    for (std::size_t k = 0; k < refiners.size(); ++k) {
      next.steps.push_back(converted<double>(refiners[k].step(axes()[k])));
      next.axes.push_back(next.steps.back().output);
    }
    levels_.push_back(std::move(next));
  }
}

std::size_t SlabRefinement::slice(std::size_t level) const {
  std::size_t numbers = data_.dimension;
  for (std::size_t k = 0; k + 1 < data_.axes.size(); ++k) numbers *= axes(level)[k].count;
  return numbers;
}

void SlabRefinement::run(const std::function<void(const double*, std::size_t)>& take) const {
  const std::size_t numbers = slice(levels_.size()), count = axes().back().count;
  const std::size_t slices = std::max(fewest_slices, numbers_of_slab / numbers);
  std::vector<double> values;
  for (std::size_t begin = 0; begin < count; begin += slices) {
    values.clear();
    append_made(levels_.size(), begin, std::min(begin + slices, count), values);
    take(values.data(), values.size() / data_.dimension);
  }
}

void SlabRefinement::append(std::size_t level, long begin, long end, std::vector<double>& values) const {
  const auto count = static_cast<long>(axes(level).back().count);
  while (begin < end) {
    const long first = modulo(begin, count), last = std::min(count, first + end - begin);
    append_made(level, static_cast<std::size_t>(first), static_cast<std::size_t>(last), values);
    begin += last - first;
  }
}

void SlabRefinement::append_made(std::size_t level, std::size_t begin, std::size_t end,
                                 std::vector<double>& values) const {
  if (level == 0) {
    const double* const first = data_.values.data();
    values.insert(values.end(), first + begin * slice(0), first + end * slice(0));
    return;
  }
  const std::vector<AxisRefinement<double>>& steps = levels_[level - 1].steps;
  const PartOfStep part(steps.back(), begin, end);
  std::vector<double> in, out;
  append(level - 1, part.begin, part.end, in);
  std::size_t inner = data_.dimension, outer = in.size() / inner;
  for (std::size_t k = 0; k + 1 < steps.size(); ++k) {
    outer /= steps[k].input.count;
    out.resize(outer * steps[k].outputs() * inner);
    apply(steps[k], in.data(), out.data(), outer, inner, threads_);
    in.swap(out);
    inner *= steps[k].outputs();
  }
  const std::size_t old = values.size();
  values.resize(old + (end - begin) * inner);
  apply(part.part(), in.data(), values.data() + old, 1, inner, threads_);
}

}  // namespace subcert::data
