#include "grid_refinement.hpp"

#include "axis_refinement.hpp"
#include "weighted_sum.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/schemes/grid_regression.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>

namespace subcert::data {
namespace {

std::vector<AxisStencils> stencils_of(const LatticeMask& mask) {
  const PolynomialReproduction polynomials = polynomial_reproduction(mask);
  require(polynomials.sum_rules >= 1, "refine: need coset sums 1");
  const long arity = mask.arity();
  std::vector<AxisStencils> result;
  for (std::size_t v = 0; v < static_cast<std::size_t>(mask.dimension()); ++v) {
    std::vector<AxisStencils::Class> classes(static_cast<std::size_t>(arity),
                                             {std::numeric_limits<long>::max(), std::numeric_limits<long>::min()});
    for (const auto& term : mask.symbol().terms()) {
      const long n = term.exponents[v];
      AxisStencils::Class& one = classes[static_cast<std::size_t>(modulo(n, arity))];
      one = {std::min(one.lowest, n), std::max(one.highest, n)};
    }
    result.emplace_back(std::move(classes), polynomials.parametrization[v] * (arity - 1),
                        polynomials.reproduction_degree);
  }
  return result;
}

/// One output along one axis: the data of the rule, and the data and the place of the fit that replaces it at an end.
struct Place {
  bool fitted;  // the rule is not complete, and regression replaces it
  std::size_t residue;
  std::vector<std::size_t> at;
  std::vector<std::size_t> fit_at;
  std::size_t position;  // number of the place in its window
};

/// The places of one axis.
struct Line {
  OutputRange range;
  std::vector<Place> places;
  std::vector<Rational> positions;
};

Line make_line(const AxisStencils& stencils, const Axis& axis, Boundary boundary) {
  Line line{stencils.outputs(axis, boundary), {}, {}};
  const Axis& input = line.range.input;
  const long count = static_cast<long>(input.count), window = static_cast<long>(stencils.window());
  std::map<Rational, std::size_t> known;
  for (long i = line.range.begin; i < line.range.end; ++i) {
    const long first = stencils.first_read(i), last = stencils.last_read(i);
    const bool open = !input.closed && boundary == Boundary::regression;
    Place place{open && (first < 0 || last >= count), stencils.residue(i), {}, {}, 0};
    if (!place.fitted)
      for (long j = first; j <= last; ++j) place.at.push_back(source(j, input, boundary));
    if (boundary == Boundary::regression) {
      long shift = first - (window - (last - first + 1)) / 2;
      if (!input.closed) shift = std::clamp(shift, 0L, count - window);
      for (long j = shift; j < shift + window; ++j) place.fit_at.push_back(source(j, input, boundary));
      const auto [found, added] = known.emplace(stencils.position(i) - shift, line.positions.size());
      if (added) line.positions.push_back(found->first);
      place.position = found->second;
    }
    line.places.push_back(std::move(place));
  }
  return line;
}

/// Weights on a box of data, the first axis fastest.
template <class Number>
using Box = std::vector<Number>;

/// Input of a level: some or all slices across the last axis.
template <class Number>
struct Slices {
  const Number* values;
  std::function<std::size_t(std::size_t)> place;  // of a slice among these
};

/// One level: its lines and the weights of its rules.
template <class Number>
class Level {
 public:
  Level(std::vector<Axis> axes, std::size_t dimension, LatticeMask mask, std::vector<AxisStencils> stencils,
        Boundary boundary)
      : axes_(std::move(axes)), dimension_(dimension), mask_(std::move(mask)), stencils_(std::move(stencils)) {
    for (std::size_t v = 0; v < stencils_.size(); ++v) lines_.push_back(make_line(stencils_[v], axes_[v], boundary));
    make_rules();
    make_fits();
  }

  std::vector<Axis> output() const {
    std::vector<Axis> axes;
    for (const Line& line : lines_) axes.push_back(line.range.output);
    return axes;
  }

  /// The slices of the input that slices begin, ..., end - 1 of the output depend on.
  std::vector<std::size_t> reads(std::size_t begin, std::size_t end) const {
    std::vector<std::size_t> result;
    for (std::size_t o = begin; o < end; ++o) {
      const Place& place = lines_.back().places[o];
      for (const auto* list : {&place.at, &place.fit_at}) result.insert(result.end(), list->begin(), list->end());
    }
    return result;
  }

  /// Makes slices begin, ..., end - 1.
  void run(const Slices<Number>& in, std::size_t begin, std::size_t end, int threads, Number* out) const {
    const std::size_t row = lines_[0].places.size() * dimension_;
    std::size_t rows = 1;  // of a slice
    for (std::size_t v = 1; v + 1 < lines_.size(); ++v) rows *= lines_[v].places.size();
    parallel_ranges(rows * (end - begin), rows * (end - begin) * row / numbers_per_thread, threads,
                    [&](std::size_t first, std::size_t last) {
                      for (std::size_t r = first; r < last; ++r) run_row(in, rows * begin + r, out + r * row);
                    });
  }

 private:
  using Places = std::vector<const Place*>;

  /// The rules of the mask, by residue classes.
  void make_rules() {
    const std::size_t arity = static_cast<std::size_t>(mask_.arity());
    std::size_t classes = 1;
    for (std::size_t v = 0; v < lines_.size(); ++v) classes *= arity;
    for (std::size_t number = 0; number < classes; ++number) {
      std::vector<long> output;
      std::size_t rest = number, size = 1;
      for (const AxisStencils& axis : stencils_) {
        output.push_back(static_cast<long>(rest % arity));
        rest /= arity;
        size *= static_cast<std::size_t>(axis.last_read(output.back()) - axis.first_read(output.back())) + 1;
      }
      std::vector<Rational> weights;
      for (std::size_t i = 0; i < size; ++i) {
        std::vector<long> exponents;
        std::size_t at = i;
        for (std::size_t v = 0; v < lines_.size(); ++v) {
          const long first = stencils_[v].first_read(output[v]);
          const auto length = static_cast<std::size_t>(stencils_[v].last_read(output[v]) - first) + 1;
          exponents.push_back(output[v] - mask_.arity() * (first + static_cast<long>(at % length)));
          at /= length;
        }
        weights.push_back(mask_.symbol().coefficient(exponents));
      }
      rules_.push_back(converted<Number>(weights));
    }
  }

  /// The fits of all combinations of places in which an axis is fitted.
  void make_fits() {
    std::vector<std::vector<const Place*>> different;  // places with different positions, for each axis
    for (const Line& line : lines_) {
      std::map<std::pair<std::size_t, bool>, const Place*> known;
      for (const Place& place : line.places) known.emplace(std::pair(place.position, place.fitted), &place);
      different.emplace_back();
      for (const auto& [key, place] : known) different.back().push_back(place);
    }
    Places places;
    add_fits(different, places);
  }

  void add_fits(const std::vector<std::vector<const Place*>>& different, Places& places) {
    if (places.size() < lines_.size()) {
      for (const Place* place : different[places.size()]) {
        places.push_back(place);
        add_fits(different, places);
        places.pop_back();
      }
      return;
    }
    if (!is_fitted(places) || fits_.count(positions(places))) return;
    std::vector<std::vector<Rational>> nodes;
    std::vector<Rational> x;
    for (std::size_t v = 0; v < lines_.size(); ++v) {
      nodes.emplace_back();
      for (std::size_t i = 0; i < stencils_[v].window(); ++i) nodes.back().emplace_back(i);
      x.push_back(lines_[v].positions[places[v]->position]);
    }
    fits_[positions(places)] = converted<Number>(grid_regression_weights(nodes, stencils_[0].degree(), x));
  }

  static bool is_fitted(const Places& places) {
    return std::any_of(places.begin(), places.end(), [](const Place* place) { return place->fitted; });
  }
  static std::vector<std::size_t> positions(const Places& places) {
    std::vector<std::size_t> result;
    for (const Place* place : places) result.push_back(place->position);
    return result;
  }

  void run_row(const Slices<Number>& in, std::size_t row, Number* out) const {
    Places places{nullptr};
    for (std::size_t v = 1; v < lines_.size(); ++v) {
      places.push_back(&lines_[v].places[row % lines_[v].places.size()]);
      row /= lines_[v].places.size();
    }
    const Line& line = lines_[0];
    const long arity = mask_.arity();
    long begin = line.range.end, end = line.range.end;  // complete groups of the first axis, in fast runs
    if constexpr (std::is_same_v<Number, double>)
      if (!is_fitted({places.begin() + 1, places.end()}) &&
          line.range.complete_end - line.range.complete_begin >= arity) {
        begin = line.range.complete_begin;
        end = begin + (line.range.complete_end - begin) / arity * arity;
        run_groups(in, places, begin, static_cast<std::size_t>((end - begin) / arity),
                   out + static_cast<std::size_t>(begin - line.range.begin) * dimension_);
      }
    for (long i = line.range.begin; i < line.range.end; ++i) {
      if (i == begin) i = end;
      if (i == line.range.end) break;
      const auto at = static_cast<std::size_t>(i - line.range.begin);
      places[0] = &line.places[at];
      run_point(in, places, out + at * dimension_);
    }
  }

  void run_point(const Slices<Number>& in, const Places& places, Number* out) const {
    const bool fitted = is_fitted(places);
    const Box<Number>& box = fitted ? fits_.at(positions(places)) : rules_[rule(places)];
    const auto list = [&](std::size_t v) -> const std::vector<std::size_t>& {
      return fitted ? places[v]->fit_at : places[v]->at;
    };
    std::fill_n(out, dimension_, Number(0));
    std::size_t i = 0;
    for_rows(in, places.size(), list, [&](std::size_t offset) {
      for (const std::size_t x : list(0)) {
        for (std::size_t c = 0; c < dimension_; ++c) out[c] += box[i] * in.values[(offset + x) * dimension_ + c];
        ++i;
      }
    });
  }

  /// Complete outputs of the first axis from output `begin` on, which begins a group.
  void run_groups(const Slices<Number>& in, Places& places, long begin, std::size_t groups, double* out) const {
    constexpr std::size_t length = 512;
    const std::size_t size = dimension_, arity = static_cast<std::size_t>(mask_.arity());
    const std::size_t block = std::max<std::size_t>(1, length / size);
    std::vector<double> parts(arity * block * size);
    const auto list = [&](std::size_t v) -> const std::vector<std::size_t>& { return places[v]->at; };
    for (std::size_t g = 0; g < groups; g += block) {
      const std::size_t now = std::min(block, groups - g);
      for (std::size_t p = 0; p < arity; ++p) {
        const std::size_t index = static_cast<std::size_t>(begin - lines_[0].range.begin) + p;
        places[0] = &lines_[0].places[index];
        const std::size_t taps = list(0).size(), first = list(0).front() + g;
        const Box<Number>& box = rules_[rule(places)];
        const double* weights = box.data();
        for_rows(in, places.size(), list, [&](std::size_t offset) {
          weighted_sum(in.values + (offset + first) * size, size, weights, taps, now * size,
                       parts.data() + p * block * size, weights != box.data());
          weights += taps;
        });
      }
      interleave(parts.data(), block * size, arity, now, size, out + g * arity * size);
    }
  }

  /// Calls work(offset) for each row of the box in the axes from the second on.
  template <class List, class Work>
  void for_rows(const Slices<Number>& in, std::size_t axes, const List& list, const Work& work) const {
    const std::size_t columns = axes_[0].count;
    if (axes == 2) {
      for (const std::size_t y : list(1)) work(in.place(y) * columns);
      return;
    }
    for (const std::size_t z : list(2))
      for (const std::size_t y : list(1)) work((in.place(z) * axes_[1].count + y) * columns);
  }

  std::size_t rule(const Places& places) const {
    std::size_t number = 0;
    for (std::size_t v = places.size(); v-- > 0;)
      number = number * static_cast<std::size_t>(mask_.arity()) + places[v]->residue;
    return number;
  }

  std::vector<Axis> axes_;
  std::size_t dimension_;
  LatticeMask mask_;
  std::vector<AxisStencils> stencils_;
  std::vector<Line> lines_;
  std::vector<Box<Number>> rules_;
  std::map<std::vector<std::size_t>, Box<Number>> fits_;
};

class GridStep : public SliceStep {
 public:
  GridStep(Level<double> level, std::size_t dimension, int threads)
      : SliceStep(level.output()), level_(std::move(level)), dimension_(dimension), threads_(threads) {}

  void append(std::size_t begin, std::size_t end, const SliceSource& source,
              std::vector<double>& values) const override {
    const SliceBuffer in(level_.reads(begin, end), source);
    const std::size_t old = values.size();
    values.resize(old + (end - begin) * numbers_of_slice(output(), dimension_));
    level_.run({in.values().data(), [&](std::size_t slice) { return in.place(slice); }}, begin, end, threads_,
               values.data() + old);
  }

 private:
  Level<double> level_;
  std::size_t dimension_;
  int threads_;
};

}  // namespace

template <class Number>
GridData<Number> refined_on_grid(const GridData<Number>& data, const LatticeMask& mask, const RefineOptions& options) {
  const std::vector<AxisStencils> stencils = stencils_of(mask);
  GridData<Number> result = data;
  for (int level = 0; level < options.levels; ++level) {
    const Level<Number> made(result.axes, result.dimension, mask, stencils, options.boundary);
    GridData<Number> next{{}, result.dimension, made.output()};
    next.values.resize(next.points() * next.dimension);
    made.run({result.values.data(), [](std::size_t slice) { return slice; }}, 0, next.axes.back().count,
             options.threads, next.values.data());
    result = std::move(next);
  }
  return result;
}

SliceSteps grid_steps(std::vector<Axis> axes, std::size_t dimension, const LatticeMask& mask,
                      const RefineOptions& options) {
  const std::vector<AxisStencils> stencils = stencils_of(mask);
  SliceSteps steps;
  for (int level = 0; level < options.levels; ++level) {
    Level<double> next(std::move(axes), dimension, mask, stencils, options.boundary);
    axes = next.output();
    steps.push_back(std::make_unique<GridStep>(std::move(next), dimension, options.threads));
  }
  return steps;
}

std::vector<std::size_t> windows(const LatticeMask& mask) {
  std::vector<std::size_t> result;
  for (const AxisStencils& axis : stencils_of(mask)) result.push_back(axis.window());
  return result;
}

template GridData<double> refined_on_grid<double>(const GridData<double>&, const LatticeMask&, const RefineOptions&);
template GridData<Rational> refined_on_grid<Rational>(const GridData<Rational>&, const LatticeMask&,
                                                      const RefineOptions&);

}  // namespace subcert::data
