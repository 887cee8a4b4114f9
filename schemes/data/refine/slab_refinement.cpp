#include "slab_refinement.hpp"

#include "extended_refinement.hpp"
#include "grid_refinement.hpp"

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

/// Appends slices of a closed or open axis, going round.
void append_round(const SliceSource& source, std::size_t count, long begin, long end, std::vector<double>& values) {
  const auto size = static_cast<long>(count);
  while (begin < end) {
    const long first = modulo(begin, size), last = std::min(size, first + end - begin);
    source(static_cast<std::size_t>(first), static_cast<std::size_t>(last), values);
    begin += last - first;
  }
}

/// A step along one axis.
class AxisStep : public SliceStep {
 public:
  AxisStep(std::vector<Axis> axes, std::size_t dimension, std::size_t along, AxisRefinement<double> rows, int threads)
      : SliceStep(with(axes, along, rows.output)),
        input_(std::move(axes)),
        dimension_(dimension),
        along_(along),
        rows_(std::move(rows)),
        threads_(threads) {}

  void append(std::size_t begin, std::size_t end, const SliceSource& source,
              std::vector<double>& values) const override {
    const std::size_t old = values.size(), made = (end - begin) * numbers_of_slice(output(), dimension_);
    std::vector<double> in;
    if (along_ + 1 == input_.size()) {
      const PartOfStep part(rows_, begin, end);
      append_round(source, input_.back().count, part.begin, part.end, in);
      values.resize(old + made);
      apply(part.part(), in.data(), values.data() + old, 1, numbers_of_slice(input_, dimension_), threads_);
      return;
    }
    source(begin, end, in);
    values.resize(old + made);
    std::size_t inner = dimension_;
    for (std::size_t k = 0; k < along_; ++k) inner *= input_[k].count;
    apply(rows_, in.data(), values.data() + old, in.size() / (inner * input_[along_].count), inner, threads_);
  }

 private:
  static std::vector<Axis> with(std::vector<Axis> axes, std::size_t k, const Axis& axis) {
    axes[k] = axis;
    return axes;
  }

  std::vector<Axis> input_;
  std::size_t dimension_;
  std::size_t along_;
  AxisRefinement<double> rows_;
  int threads_;
};

void require_axes(const std::vector<Axis>& axes, const LatticeMask& mask) {
  require(static_cast<std::size_t>(mask.dimension()) == axes.size(),
          "refine: need as many axes as variables, got {} for {}", axes.size(), mask.dimension());
}

SliceSteps axis_steps(std::vector<Axis> axes, std::size_t dimension, const std::vector<StepAlong>& steps, int threads) {
  SliceSteps result;
  for (const StepAlong& step : steps) {
    axes[step.axis] = step.rows.input;  // closed for `periodic`
    result.push_back(std::make_unique<AxisStep>(axes, dimension, step.axis, converted<double>(step.rows), threads));
    axes = result.back()->output();
  }
  return result;
}

}  // namespace

std::size_t numbers_of_slice(const std::vector<Axis>& axes, std::size_t dimension) {
  std::size_t numbers = dimension;
  for (std::size_t k = 0; k + 1 < axes.size(); ++k) numbers *= axes[k].count;
  return numbers;
}

SliceBuffer::SliceBuffer(const std::vector<std::size_t>& numbers, const SliceSource& source) {
  std::vector<std::size_t> sorted = numbers;
  std::ranges::sort(sorted);
  std::size_t held = 0;
  for (const std::size_t number : sorted) {
    if (!runs_.empty() && number < runs_.back().end) continue;
    if (runs_.empty() || number > runs_.back().end) runs_.push_back({number, number, held});
    ++runs_.back().end;
    ++held;
  }
  for (const Run& run : runs_) source(run.begin, run.end, values_);
}

std::size_t SliceBuffer::place(std::size_t number) const {
  const auto after = std::ranges::upper_bound(runs_, number, {}, &Run::begin);
  const Run& run = *std::prev(after);
  return run.place + number - run.begin;
}

SliceSteps refinement_steps(const std::vector<Axis>& axes, std::size_t dimension, const LatticeMask& mask,
                            const RefineOptions& options) {
  return refinement_steps(axes, dimension, LevelMasks{{}, {mask}}, options);
}

SliceSteps refinement_steps(const std::vector<Axis>& axes, std::size_t dimension, const LevelMasks& masks,
                            const RefineOptions& options) {
  require_axes(axes, masks.at(0));
  require(options.levels >= 0, "refine: need levels >= 0, got {}", options.levels);
  const bool is_one = masks.first.empty() && masks.again.size() == 1;
  return steps_at_boundary(axes, dimension, fewest_points(masks.at(0), Boundary::shrink), options,
                           [&](const std::vector<Axis>& on, const RefineOptions& how) {
                             require_refinable(on, dimension, masks, how.levels, most_streamed_numbers);
                             if (is_one && !masks.at(0).has_factors())
                               return grid_steps(on, dimension, masks.at(0), how);
                             require_factors(masks);
                             return axis_steps(on, dimension, steps_of_refinement(on, masks, how), how.threads);
                           });
}

SliceSteps limit_steps(const std::vector<Axis>& axes, std::size_t dimension, const LatticeMask& mask,
                       const RefineOptions& options) {
  require_axes(axes, mask);
  return steps_at_boundary(
      axes, dimension, fewest_points(mask, Boundary::shrink), options,
      [&](const std::vector<Axis>& on, const RefineOptions& how) {
        return axis_steps(on, dimension, steps_of_limit(on, dimension, mask.factors(), how, most_streamed_numbers),
                          how.threads);
      });
}

SlabRefinement::SlabRefinement(std::vector<Axis> axes, std::size_t dimension, SliceSource data, SliceSteps steps)
    : axes_(std::move(axes)), dimension_(dimension), data_(std::move(data)), steps_(std::move(steps)) {}

SlabRefinement::SlabRefinement(const GridData<double>& data, SliceSteps steps)
    : SlabRefinement(
          data.axes, data.dimension,
          [&data, slice = numbers_of_slice(data.axes, data.dimension)](std::size_t begin, std::size_t end,
                                                                       std::vector<double>& values) {
            const double* const first = data.values.data();
            values.insert(values.end(), first + begin * slice, first + end * slice);
          },
          std::move(steps)) {
  require(data.is_canonical(), "refine: need as many values as points times coordinates");
}

GridData<double> SlabRefinement::whole() const {
  GridData<double> result{{}, dimension_, axes()};
  run([&](const double* values, std::size_t points) {
    result.values.insert(result.values.end(), values, values + points * dimension_);
  });
  return result;
}

void SlabRefinement::run(const std::function<void(const double*, std::size_t)>& take) const {
  const std::size_t numbers = numbers_of_slice(axes(), dimension_), count = axes().back().count;
  const std::size_t slices = std::max(fewest_slices, numbers_of_slab / numbers);
  std::vector<double> values;
  for (std::size_t begin = 0; begin < count; begin += slices) {
    values.clear();
    append(steps_.size(), begin, std::min(begin + slices, count), values);
    take(values.data(), values.size() / dimension_);
  }
}

void SlabRefinement::append(std::size_t step, std::size_t begin, std::size_t end, std::vector<double>& values) const {
  if (step == 0) return data_(begin, end, values);
  steps_[step - 1]->append(
      begin, end,
      [&](std::size_t first, std::size_t last, std::vector<double>& in) { append(step - 1, first, last, in); }, values);
}

}  // namespace subcert::data
