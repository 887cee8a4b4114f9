#include "linear_smoother.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/refine/weighted_sum.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace subcert::data {
namespace {

constexpr std::size_t most_block_positions = 512;
constexpr std::size_t most_block_values = 8192;

}  // namespace

std::size_t count_outputs(double length, std::size_t scale) {
  constexpr double rounding = 1e-10;  // of positions, so that the last one is not lost
  const double spacings = std::floor(length * static_cast<double>(scale) * (1 + rounding) + rounding);
  if (!(spacings < static_cast<double>(most_smoothed_values)))
    fail(ErrorKind::size, "smoothing: need at most {} outputs, got {} spacings with {} outputs each",
         most_smoothed_values, length, scale);
  return static_cast<std::size_t>(spacings) + 1;
}

LinearSmoother::LinearSmoother(const ExtensionRule& rule, DataSites sites, const SmoothingOptions& options,
                               std::size_t scale, std::pair<long, long> reach)
    : options_(options),
      data_(rule, std::move(sites)),
      scale_(options.on_grid() ? scale : 1),
      outputs_(!options.places.empty() ? options.places.size()
               : options.at_data       ? data_.count()
                                       : count_outputs(data_.position(static_cast<long>(data_.count()) - 1), scale)),
      lowest_(reach.first),
      highest_(reach.second),
      prior_weights_(data_.count(), 1) {
  require(!options.as_observed || options.at_data, "smoothing: data are observed at the data alone");
  if (const std::vector<double>& places = options_.places; !places.empty()) {
    const double last = data_.position(static_cast<long>(data_.count()) - 1);
    require(!options_.at_data && std::ranges::is_sorted(places) && places.front() >= 0 && places.back() <= last,
            "smoothing: need places in order from 0 to {}", last);
  }
  if (!data_.weighted()) return;
  for (std::size_t i = 0; i < data_.count(); ++i)
    prior_weights_[i] = static_cast<double>(data_.weight(static_cast<long>(i)));
  same_weight_until_.assign(data_.count(), data_.count());
  for (std::size_t i = data_.count() - 1; i-- > 0;)
    same_weight_until_[i] = prior_weights_[i] == prior_weights_[i + 1] ? same_weight_until_[i + 1] : i + 1;
}

Rational LinearSmoother::position(std::size_t output) const {
  if (!options_.on_grid()) return Rational(rounded_position(output));
  return Rational(output) / Rational(scale_);
}

template <class Number>
Number LinearSmoother::prior_weight(long index) const {
  if constexpr (std::is_same_v<Number, double>)
    if (data_.is_inside(index)) return prior_weights_[static_cast<std::size_t>(index)];
  return static_cast<Number>(data_.weight(index));
}

template double LinearSmoother::prior_weight<double>(long) const;
template Rational LinearSmoother::prior_weight<Rational>(long) const;

/// The first spacing from `whole` on whose outputs are not all composed from data inside of one weight; `whole` itself
/// where its own are not, as always where data are not uniform or missing. The last spacing, which has one output
/// alone, never counts as such.
std::size_t LinearSmoother::interior_end(std::size_t whole) const {
  const auto count = static_cast<long>(data_.count()), at = static_cast<long>(whole);
  if (!data_.uniform() || !options_.places.empty() || at + lowest_ < 0 || at + highest_ >= count) return whole;
  if (prior_weights_[static_cast<std::size_t>(at + lowest_)] == 0) return whole;
  const long end = same_weight_until_.empty()
                       ? count
                       : static_cast<long>(same_weight_until_[static_cast<std::size_t>(at + lowest_)]);
  return static_cast<std::size_t>(std::clamp(end - highest_, at, std::max(at, count - 1)));
}

template <class Number>
RowOf<Number> LinearSmoother::to_row(const std::vector<std::pair<const Combination<Number>*, Number>>& parts) const {
  RowOf<Number> row;
  std::size_t low = data_.count(), high = 0;
  for (const auto& [part, factor] : parts)
    for (const auto& [datum, weight] : part->terms) {
      low = std::min(low, datum);
      high = std::max(high, datum);
    }
  row.first = low;
  if (low <= high) row.weights.assign(high - low + 1, 0);
  for (const auto& [part, factor] : parts) {
    row.outside += factor * part->outside;
    for (const auto& [datum, weight] : part->terms) row.weights[datum - low] += factor * weight;
  }
  for (std::size_t k = 0; k < row.weights.size(); ++k)
    if (row.weights[k] != 0)
      row.variance += row.weights[k] * row.weights[k] / prior_weight<Number>(static_cast<long>(low + k));
  return row;
}

template RoundedRow LinearSmoother::to_row<double>(
    const std::vector<std::pair<const Combination<double>*, double>>&) const;
template SmoothingRow LinearSmoother::to_row<Rational>(
    const std::vector<std::pair<const Combination<Rational>*, Rational>>&) const;

template <class One, class Many>
void LinearSmoother::visit_rounded_rows(std::size_t begin, std::size_t end, const One& one, const Many& many) const {
  const std::unique_ptr<RowMaker<double>> maker = row_maker();
  std::vector<RoundedRow> interior;  // of one spacing
  RoundedRow row;
  std::size_t made_at = 0;
  for (std::size_t whole = begin; whole < end;) {
    const std::size_t next = std::min(interior_end(whole), end);
    if (next == whole) {
      for (std::size_t o = whole * scale_; o < std::min((whole + 1) * scale_, outputs()); ++o) {
        if (whole == begin || !repeats(o)) row = maker->row(o);
        one(row, o);
      }
      ++whole;
      continue;
    }
    const auto weight_at = [&](std::size_t at) {
      return prior_weights_[static_cast<std::size_t>(static_cast<long>(at) + lowest_)];
    };
    if (interior.empty() || weight_at(whole) != weight_at(made_at)) {
      interior.clear();
      made_at = whole;
      for (std::size_t p = 0; p < scale_; ++p) interior.push_back(maker->row(whole * scale_ + p));
    }
    many(interior, whole - made_at, whole, next);
    whole = next;
  }
}

std::vector<RoundedRow> LinearSmoother::rounded_rows() const {
  std::vector<RoundedRow> result;
  result.reserve(outputs());
  visit_rounded_rows(
      0, spacings(), [&](const RoundedRow& row, std::size_t) { result.push_back(row); },
      [&](const std::vector<RoundedRow>& rows, std::size_t shift, std::size_t begin, std::size_t end) {
        for (std::size_t whole = begin; whole < end; ++whole)
          for (const RoundedRow& row : rows) {
            result.push_back(row);
            result.back().first += shift + whole - begin;
          }
      });
  return result;
}

/// SmoothedData::path, row by row.
class LinearSmoother::PathLength {
 public:
  explicit PathLength(const std::vector<double>& prior_weights) : prior_weights_(prior_weights) {}

  void go_to(const RoundedRow& row, std::size_t shift) {
    if (row.variance == 0) return;
    if (last_.variance > 0) length_ += angle(last_, last_shift_, row, shift);
    last_ = row;
    last_shift_ = shift;
  }
  /// Through all rows, and again `times` - 1 times, each time one datum further: all of these data have one weight.
  void go_through(const std::vector<RoundedRow>& rows, std::size_t shift, std::size_t times) {
    for (const RoundedRow& row : rows) go_to(row, shift);
    if (times < 2) return;
    const auto first = std::find_if(rows.begin(), rows.end(), [](const RoundedRow& row) { return row.variance > 0; });
    if (first == rows.end()) return;
    PathLength once(prior_weights_);
    for (const RoundedRow& row : rows) once.go_to(row, shift);
    once.go_to(*first, shift + 1);
    length_ += static_cast<double>(times - 1) * once.length_;
    last_shift_ = shift + times - 1;
  }
  double length() const { return length_; }

 private:
  /// Between two rows as lines, from the distance of unit vectors, which does not cancel where they are near.
  double angle(const RoundedRow& a, std::size_t a_shift, const RoundedRow& b, std::size_t b_shift) const {
    const std::size_t low = std::min(a.first + a_shift, b.first + b_shift);
    const std::size_t high = std::max(a.first + a_shift + a.weights.size(), b.first + b_shift + b.weights.size());
    const double a_norm = 1 / std::sqrt(a.variance), b_norm = 1 / std::sqrt(b.variance);
    const auto at = [](const RoundedRow& row, std::size_t datum) {
      return datum < row.weights.size() ? row.weights[datum] : 0;  // wraps around before the row
    };
    double apart = 0, opposite = 0;
    for (std::size_t i = low; i < high; ++i) {
      const double x = at(a, i - a_shift - a.first) * a_norm, y = at(b, i - b_shift - b.first) * b_norm;
      if (x == 0 && y == 0) continue;
      apart += (x - y) * (x - y) / prior_weights_[i];
      opposite += (x + y) * (x + y) / prior_weights_[i];
    }
    return 2 * std::asin(std::min(1.0, std::sqrt(std::min(apart, opposite)) / 2));
  }

  const std::vector<double>& prior_weights_;
  double length_ = 0;
  RoundedRow last_;
  std::size_t last_shift_ = 0;
};

double LinearSmoother::rounded_position(std::size_t output) const {
  if (!options_.places.empty()) return options_.places[output];
  if (options_.at_data) return data_.position(static_cast<long>(output));
  return static_cast<double>(output) / static_cast<double>(scale_);
}

std::vector<std::size_t> LinearSmoother::vertices() const {
  std::vector<std::size_t> result;
  const auto add = [&](std::size_t output) {
    if (stride() == 1 || result.empty() || rounded_position(output) > rounded_position(result.back()))
      result.push_back(output);
  };
  for (std::size_t o = 0; o + 1 < outputs_; o += stride() == 1 ? 1 : stride() * scale_) add(o);
  add(outputs_ - 1);
  return result;
}

std::vector<double> LinearSmoother::between(const std::vector<std::size_t>& vertices,
                                            const std::vector<double>& values) const {
  if (stride() == 1) return values;
  constexpr std::size_t points = 4;
  const std::size_t used = std::min(points, vertices.size());
  std::vector<double> result(outputs_);
  std::size_t first = 0;
  for (std::size_t o = 0; o < outputs_; ++o) {
    const double x = rounded_position(o);
    while (first + used < vertices.size() && rounded_position(vertices[first + 2]) < x) ++first;
    for (std::size_t i = 0; i < used; ++i) {
      double weight = values[first + i];
      const double at = rounded_position(vertices[first + i]);
      for (std::size_t j = 0; j < used; ++j)
        if (const double other = rounded_position(vertices[first + j]); j != i) weight *= (x - other) / (at - other);
      result[o] += weight;
    }
  }
  return result;
}

std::vector<SmoothedData> LinearSmoother::apply_sparsely(const Columns& columns) const {
  const std::unique_ptr<RowMaker<double>> maker = row_maker();
  const std::vector<std::size_t> made = vertices();
  std::vector<std::vector<double>> values(columns.size());
  std::vector<double> variances, leverages;
  RoundedRow interior;
  std::size_t made_at = 0;
  for (const std::size_t output : made) {
    const std::size_t whole = output / scale_;
    const bool inside = output % scale_ == 0 && same_weight_until_.empty() && interior_end(whole) > whole;
    if (inside && interior.weights.empty()) {
      interior = maker->row(output);
      made_at = whole;
    }
    const RoundedRow row = inside ? RoundedRow{} : maker->row(output);
    const RoundedRow& used = inside ? interior : row;
    const std::size_t first = used.first + (inside ? whole - made_at : 0), own = whole - first;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      double sum = used.outside * options_.constant;
      for (std::size_t k = 0; k < used.weights.size(); ++k) sum += used.weights[k] * (*columns[c])[first + k];
      values[c].push_back(sum);
    }
    variances.push_back(used.variance);
    leverages.push_back(own < used.weights.size() ? used.weights[own] : 0);
  }
  SmoothedData shared{{}, between(made, variances), {}};
  if (data_.uniform() || options_.at_data) {
    const std::vector<double> all = between(made, leverages);
    for (std::size_t o = 0; o < outputs_; o += scale_) shared.leverages.push_back(all[o]);
  }
  std::vector<SmoothedData> result(columns.size(), shared);
  for (std::size_t c = 0; c < columns.size(); ++c) result[c].values = between(made, values[c]);
  return result;
}

SmoothedData LinearSmoother::apply(const std::vector<double>& data) const { return apply(data, 0, spacings()); }

SmoothedData LinearSmoother::apply(const std::vector<double>& data, std::size_t begin, std::size_t end) const {
  return std::move(apply(Columns{&data}, begin, end).front());
}

std::vector<SmoothedData> LinearSmoother::apply_to(const std::vector<std::vector<double>>& columns, std::size_t begin,
                                                   std::size_t end) const {
  require(!columns.empty(), "smoothing: need a column, got none");
  Columns all;
  for (const auto& column : columns) all.push_back(&column);
  return apply(all, begin, end);
}

std::vector<SmoothedData> LinearSmoother::apply_to(const std::vector<std::vector<double>>& columns) const {
  return apply_to(columns, 0, spacings());
}

std::vector<SmoothedData> LinearSmoother::apply(const Columns& columns, std::size_t begin, std::size_t end) const {
  for (const std::vector<double>* data : columns)
    require(data->size() == data_.count(), "smoothing: need {} data, got {}", data_.count(), data->size());
  require(begin <= end && end <= spacings(), "smoothing: need spacings up to {}, got {} to {}", spacings(), begin, end);
  return stride() > 1 && begin == 0 && end == spacings() ? apply_sparsely(columns) : apply_densely(columns, begin, end);
}

std::vector<SmoothedData> LinearSmoother::apply_densely(const Columns& columns, std::size_t begin,
                                                        std::size_t end) const {
  const std::size_t before = begin * scale_, made = std::min(end * scale_, outputs_) - before;
  SmoothedData shared{{}, std::vector<double>(made), {}};
  std::vector<std::vector<double>> values(columns.size(), std::vector<double>(made));
  const bool at_data = options_.at_data || (data_.uniform() && options_.on_grid());
  if (at_data) shared.leverages.resize(end - begin);
  PathLength path(prior_weights_);
  const auto leverage = [](const RoundedRow& row, std::size_t datum, std::size_t shift) {
    const std::size_t own = datum - shift - row.first;  // wraps around where the datum lies before the row
    return own < row.weights.size() ? row.weights[own] : 0;
  };
  const auto value = [&](const RoundedRow& row, const std::vector<double>& data) {
    double sum = row.outside * options_.constant;
    for (std::size_t k = 0; k < row.weights.size(); ++k)
      if (row.weights[k] != 0) sum += row.weights[k] * data[row.first + k];
    return sum;
  };
  const auto one = [&](const RoundedRow& row, std::size_t output) {
    const std::size_t at = output - before;
    const bool again = at > 0 && repeats(output);
    for (std::size_t c = 0; c < columns.size(); ++c)
      values[c][at] = again ? values[c][at - 1] : value(row, *columns[c]);
    shared.variances[at] = row.variance;
    if (options_.path) path.go_to(row, 0);
    if (at_data && output % scale_ == 0) shared.leverages[output / scale_ - begin] = leverage(row, output / scale_, 0);
  };
  // Positions that are computed phase by phase, so that sums and rows stay in the nearest cache.
  const std::size_t block = std::clamp<std::size_t>(most_block_values / scale_, 1, most_block_positions);
  std::vector<double> parts(scale_ <= outputs_ ? scale_ * block : 0);
  const auto many = [&](const std::vector<RoundedRow>& rows, std::size_t shift, std::size_t from, std::size_t to) {
    for (std::size_t c = 0; c < columns.size(); ++c)
      for (std::size_t first = from; first < to; first += block) {
        const std::size_t size = std::min(block, to - first);
        for (std::size_t p = 0; p < scale_; ++p) {
          const RoundedRow& row = rows[p];
          double* const sums = parts.data() + p * block;
          std::fill_n(sums, size, row.outside * options_.constant);
          if (!row.weights.empty())
            weighted_sum(columns[c]->data() + row.first + shift + (first - from), 1, row.weights.data(),
                         row.weights.size(), size, sums, true);
        }
        interleave(parts.data(), block, scale_, size, 1, values[c].data() + first * scale_ - before);
      }
    if (options_.path) path.go_through(rows, shift, to - from);
    double* variance = shared.variances.data() + from * scale_ - before;
    for (std::size_t whole = from; whole < to; ++whole) {
      for (const RoundedRow& row : rows) *variance++ = row.variance;
      if (at_data) shared.leverages[whole - begin] = leverage(rows.front(), from, shift);
    }
  };
  visit_rounded_rows(begin, end, one, many);
  shared.path = path.length();
  std::vector<SmoothedData> result(columns.size(), shared);
  for (std::size_t c = 0; c < columns.size(); ++c) result[c].values = std::move(values[c]);
  return result;
}

}  // namespace subcert::data
