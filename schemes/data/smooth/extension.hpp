#pragma once
/// Data continued past their ends for smoothing.

#include <subcert/schemes/data/refine/boundary.hpp>

#include <map>
#include <utility>
#include <vector>

namespace subcert::data {

class ExtendedData;

/// A value as a combination of the data: sum of weight * y_i over the terms + outside * v, v the one of
/// Boundary::constant; data may come more than once. Exact in rational numbers.
template <class Number>
struct Combination {
  std::vector<std::pair<std::size_t, Number>> terms = {};
  Number outside = 0;

  /// Adds the datum with this index, inside or outside, times `factor`.
  void add(const ExtendedData& data, long index, const Number& factor);
};

/// How to continue.
struct ExtensionRule {
  Boundary kind = Boundary::regression;
  std::size_t window = 1;  ///< data next to an end that `regression` fits
  int degree = 0;          ///< of the polynomial of `regression`
};

/// Where data stand, and how much they count.
struct DataSites {
  std::size_t count = 0;
  std::vector<Rational> weights = {};  ///< prior; none: all 1; 0: missing
  std::vector<double> positions = {};  ///< from 0 on, in order, taken as exact; none: 0, 1, 2, ...
  std::size_t before = 0;              ///< data that came before these, for messages
  int derivatives = 0;  ///< so many data after each value, at its position, are the derivatives of the function there

  DataSites(std::size_t number, std::vector<Rational> prior = {}, std::vector<double> at = {})
      : count(number), weights(std::move(prior)), positions(std::move(at)) {}
};

/// The data at their sites, continued to every integer index: past the ends by reflection or periodically with period
/// last position + 1, else with spacing 1.
class ExtendedData {
 public:
  /// Domain: count >= 1, no `shrink`, weights >= 0, not all 0; as many weights and positions as data, or none; with
  /// derivatives positions, equal for the data of one, and `regression`, past which nothing is asked for, or
  /// `periodic`. Errors: throws a domain error.
  ExtendedData(const ExtensionRule& rule, DataSites sites);

  std::size_t count() const { return sites_.count; }
  const DataSites& sites() const { return sites_; }
  bool weighted() const { return !sites_.weights.empty(); }
  /// Data at one position: a value, and derivatives.
  std::size_t kinds() const { return static_cast<std::size_t>(sites_.derivatives) + 1; }
  /// Which derivative of the function the datum with this index is; 0: a value.
  int order(long index) const { return sites_.derivatives == 0 ? 0 : order_of_many(index); }
  /// Whether the data stand at 0, 1, 2, ...
  bool uniform() const { return sites_.positions.empty(); }
  bool is_inside(long index) const { return index >= 0 && index < static_cast<long>(count()); }
  /// Of the datum with this index.
  double position(long index) const;
  /// The index of which this is the position, linear between data.
  double index_at(double position) const;
  /// The datum at `index`. Missing data that lie outside or next to the ends are replaced by the rule, those inside are
  /// not to be asked for. Of doubles, fits with prior weights or at given positions are computed in them.
  template <class Number>
  Combination<Number> at(long index) const;
  /// The prior weight there: that of the datum which is repeated; for regression and constant the mean of the data that
  /// regression fits past this end.
  const Rational& weight(long index) const;
  /// Whether the datum there is no missing one.
  bool is_present(long index) const { return !weighted() || weight(index) > 0; }

 private:
  /// The datum whose copy stands at an outside index, for reflect, nearest and periodic.
  std::size_t source(long index) const;
  template <class Number>
  Combination<Number> fitted(long index) const;
  /// The data that `regression` fits beyond the end next to `index`.
  std::vector<std::size_t> fitted_data(long index) const;
  Rational mean_weight(long index) const;
  int order_of_many(long index) const;

  ExtensionRule rule_;
  DataSites sites_;
  std::vector<std::size_t> present_;                    // data with positive weight, empty where none is given
  Rational mean_before_ = 1;                            // weight() before the first datum
  Rational mean_after_ = 1;                             // and past the last
  mutable std::map<long, std::vector<Rational>> fits_;  // made so far
};

}  // namespace subcert::data
