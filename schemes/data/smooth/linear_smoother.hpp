#pragma once
/// Linear smoothing: values that are combinations of data, with their variances.

#include "extension.hpp"

#include <cstdint>
#include <memory>

namespace subcert::data {

/// Outputs that one smoother may have.
constexpr std::size_t most_smoothed_values = 4'000'000;

/// The multiples of 1 / scale from 0 to `length`, which may be a little rounded. Errors: throws a size error beyond
/// most_smoothed_values.
std::size_t count_outputs(double length, std::size_t scale);

/// By what a method is chosen: the estimated error, or the squared errors of predicting each datum from the others.
enum class Selection { risk, cross_validation };

struct SmoothingOptions {
  Boundary boundary = Boundary::regression;
  int level = 0;                          ///< outputs at the multiples of arity^-level of the spacing
  int derivative = 0;                     ///< with respect to the index of the data
  double constant = 0;                    ///< beyond the ends, for Boundary::constant
  bool at_data = false;                   ///< outputs at the data, whatever the level
  bool path = true;                       ///< whether SmoothedData::path is wanted
  bool sparse = true;                     ///< whether wide windows may be fitted at some outputs alone, unless `path`
  Selection selection = Selection::risk;  ///< where no method is named
  int resamples = 0;                      ///< for bands of l1 schemes, 2 or more; 0: no bands
  std::uint64_t seed = 2015;              ///< of what is drawn for these
  /// Positions of the outputs in spacings from the first datum, in order, in place of a grid; smooth() takes those of
  /// the samples, in any order.
  std::vector<double> places = {};
  bool keep_holes = false;  ///< of grids: NaN beside missing data
  /// At the data, of values with derivatives: such derivatives of the fit, whatever `derivative` is.
  bool as_observed = false;

  bool on_grid() const { return !at_data && places.empty(); }
};

/// The value, or a derivative, at one position: a combination of the data.
template <class Number>
struct RowOf {
  std::size_t first = 0;  ///< the first datum with a weight below
  std::vector<Number> weights;
  Number outside = 0;   ///< weight of the constant of Boundary::constant
  Number variance = 0;  ///< for independent noise of variance 1 / (prior weight): sum of weights^2 / prior weight
};
using SmoothingRow = RowOf<Rational>;
using RoundedRow = RowOf<double>;

/// All values of a smoother.
struct SmoothedData {
  std::vector<double> values;
  std::vector<double> variances;  ///< as SmoothingRow::variance
  std::vector<double> leverages;  ///< [i]: the weight of datum i in the value there; where there is an output at it
  /// Of the path of great arcs through the rows, each divided by its norm, with its data in units of their noise; up to
  /// signs. Rows of zeros are left out.
  double path = 0;
};

/// A linear map from data to values at the multiples of 1 / scale, in spacings from the first datum to the last, at the
/// data, or at given places between them. Rows that are translates of each other are made once.
class LinearSmoother {
 public:
  virtual ~LinearSmoother() = default;

  std::size_t outputs() const { return outputs_; }
  /// Outputs for each spacing; 1 where they stand on no grid.
  std::size_t scale() const { return scale_; }
  Rational position(std::size_t output) const;

  /// Exact. Errors: throws a data error where too few data are left for a fit, and says where.
  virtual SmoothingRow row(std::size_t output) const = 0;
  /// All rows, composed in double precision; equal rows are made once. Errors: as row(). Cost: as apply().
  std::vector<RoundedRow> rounded_rows() const;

  /// All rows on the data, composed and applied in double precision; of local polynomials with windows of more than
  /// 2048 data, unless the weight is box, at 128 places of a window, and interpolated between these. Errors: as row().
  /// Cost: outputs times the width of a row; then 128 times the data.
  SmoothedData apply(const std::vector<double>& data) const;
  /// The same for the outputs of the spacings begin, ..., end - 1 alone; of some of them none are interpolated. Domain:
  /// begin <= end <= spacings().
  SmoothedData apply(const std::vector<double>& data, std::size_t begin, std::size_t end) const;
  /// The same for several functions, with rows made once for all. Domain: one or more.
  std::vector<SmoothedData> apply_to(const std::vector<std::vector<double>>& columns, std::size_t begin,
                                     std::size_t end) const;
  std::vector<SmoothedData> apply_to(const std::vector<std::vector<double>>& columns) const;
  /// One more than the number of whole spacings between the ends: the last has one output. Outputs at the data: as many
  /// as data.
  std::size_t spacings() const { return (outputs_ + scale_ - 1) / scale_; }

  /// Where data are uniform the outputs from the spacing k on, before the next, combine those from k + lowest() to
  /// k + highest() at most.
  long lowest() const { return lowest_; }
  long highest() const { return highest_; }

 protected:
  /// Domain: scale >= 1, reach.first <= reach.second; places in order, between the ends. Errors: throws a
  /// domain error, a size error beyond most_smoothed_values, or as ExtendedData.
  LinearSmoother(const ExtensionRule& rule, DataSites sites, const SmoothingOptions& options, std::size_t scale,
                 std::pair<long, long> reach);

  /// Makes rows for outputs that go up.
  template <class Number>
  class RowMaker {
   public:
    virtual ~RowMaker() = default;
    virtual RowOf<Number> row(std::size_t output) = 0;
  };
  virtual std::unique_ptr<RowMaker<double>> row_maker() const = 0;

  /// How many data one output is made for, where what lies between is so smooth that it may be interpolated; else 1.
  virtual std::size_t stride() const { return 1; }
  /// Every stride-th output at different positions, and the last; all where the stride is 1.
  std::vector<std::size_t> vertices() const;
  /// The values at all outputs, from those at the vertices by cubic interpolation. Domain: as many as vertices.
  std::vector<double> between(const std::vector<std::size_t>& vertices, const std::vector<double>& values) const;
  double rounded_position(std::size_t output) const;
  /// Whether it stands where the output before it does, as at data that share a position; so their rows are equal.
  bool repeats(std::size_t output) const {
    return !options_.on_grid() && !(options_.as_observed && data_.kinds() > 1) && output > 0 &&
           rounded_position(output) == rounded_position(output - 1);
  }

  /// Of the value there.
  int derivative(std::size_t output) const {
    return options_.as_observed && data_.kinds() > 1 ? data_.order(static_cast<long>(output)) : options_.derivative;
  }

  const SmoothingOptions& options() const { return options_; }
  const ExtendedData& data() const { return data_; }
  /// The prior weight of an index inside or outside, 1 where none are given.
  template <class Number>
  Number prior_weight(long index) const;
  /// The sum of factor * combination over the parts.
  template <class Number>
  RowOf<Number> to_row(const std::vector<std::pair<const Combination<Number>*, Number>>& parts) const;

 private:
  class PathLength;
  std::size_t interior_end(std::size_t whole) const;
  using Columns = std::vector<const std::vector<double>*>;
  std::vector<SmoothedData> apply(const Columns& columns, std::size_t begin, std::size_t end) const;
  std::vector<SmoothedData> apply_densely(const Columns& columns, std::size_t begin, std::size_t end) const;
  std::vector<SmoothedData> apply_sparsely(const Columns& columns) const;
  /// Calls one(row, output), or many(rows, shift, begin, end) for the outputs of the spacings begin, ..., end - 1:
  /// rows[phase] acts on the data from its `first` + shift on at `begin`, and one further for each spacing; in order.
  template <class One, class Many>
  void visit_rounded_rows(std::size_t begin, std::size_t end, const One& one, const Many& many) const;

  SmoothingOptions options_;
  ExtendedData data_;
  std::size_t scale_;
  std::size_t outputs_;
  long lowest_;
  long highest_;
  std::vector<double> prior_weights_;           // of all data, 1 where none are given
  std::vector<std::size_t> same_weight_until_;  // [i]: the first after i with another weight; with prior weights alone
};

}  // namespace subcert::data
