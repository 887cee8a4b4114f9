#pragma once
/// Data on a uniform grid, continued past their ends for smoothing.

#include <subcert/schemes/data/refine/boundary.hpp>

#include <map>
#include <vector>

namespace subcert::data {

/// A value as a combination of the data: sum over i of terms[i] y_i + outside * v, v the one of Boundary::constant.
struct Combination {
  std::map<std::size_t, Rational> terms = {};
  Rational outside = 0;

  void add(const Combination& other, const Rational& factor);
};

/// A combination in double precision.
struct RoundedCombination {
  std::vector<std::pair<std::size_t, double>> terms = {};
  double outside = 0;
};

RoundedCombination rounded(const Combination& combination);

/// How to continue.
struct ExtensionRule {
  Boundary kind = Boundary::regression;
  std::size_t window = 1;  ///< data next to an end that `regression` fits
  int degree = 0;          ///< of the polynomial of `regression`
};

/// The data 0, ..., count - 1 with prior weights (none: all 1; 0: missing) at every integer.
class ExtendedData {
 public:
  /// Domain: count >= 1, no `shrink`, weights >= 0, as many as data or none, not all 0. Errors: throws a domain error.
  ExtendedData(const ExtensionRule& rule, std::size_t count, std::vector<Rational> weights = {});

  std::size_t count() const { return count_; }
  bool weighted() const { return !weights_.empty(); }
  bool is_inside(long index) const { return index >= 0 && index < static_cast<long>(count_); }
  /// The datum at `index`. Missing data that lie outside or next to the ends are replaced by the rule, those inside are
  /// not to be asked for.
  Combination at(long index) const;
  /// at() in double precision; fits with prior weights are computed in it.
  RoundedCombination rounded_at(long index) const;
  /// The prior weight there: that of the datum which is repeated, the mean of the weights for regression and constant.
  Rational weight(long index) const;

 private:
  /// The datum whose copy stands at an outside index, for reflect, nearest and periodic.
  std::size_t source(long index) const;
  const Combination& fitted(long index) const;
  /// The data that `regression` fits beyond the end next to `index`.
  std::vector<std::size_t> fitted_data(long index) const;

  ExtensionRule rule_;
  std::size_t count_;
  std::vector<Rational> weights_;
  std::vector<std::size_t> present_;  // data with positive weight, empty where none is given
  Rational mean_weight_ = 1;
  mutable std::map<long, Combination> fitted_;  // made so far
};

}  // namespace subcert::data
