#pragma once
/// The data that the windows of local polynomials hold, and how much each counts.

#include "extension.hpp"

#include <bit>
#include <cstddef>
#include <vector>

namespace subcert::data {

/// How much a datum counts at the distance u of the window's radius, 0 <= u <= 1: 1; 1 - u; 1 - u^2; (1 - u^2)^2;
/// (1 - u^3)^3.
enum class LocalWeight { box, triangle, epanechnikov, biweight, tricube };

/// The fit uses the data within a radius: the distance of the `points`-th nearest datum that is not missing or, with
/// `width`, that. Values with their derivatives count as one datum. Ref: [Cle79].
struct LocalPolynomial {
  int degree = 1;
  LocalWeight weight = LocalWeight::tricube;
  std::size_t points = 0;  ///< 0: by width, or to be chosen
  double width = 0;        ///< of the window to each side, in units of the positions; 0: by points
  int robust = 0;          ///< fits again, each with the bisquare weights of the residuals before

  bool is_complete() const { return points > 0 || width > 0; }
};

template <class Number>
Number distance_factor(LocalWeight weight, const Number& u) {
  Number one = 1;
  switch (weight) {
    case LocalWeight::box: return one;
    case LocalWeight::triangle: return one - u;
    case LocalWeight::epanechnikov: return one - u * u;
    case LocalWeight::biweight: {
      const Number root = one - u * u;
      return root * root;
    }
    case LocalWeight::tricube: break;
  }
  const Number root = one - u * u * u;
  return root * root * root;
}

/// The data with positive prior weight in the order of their positions, continued past the ends as far as windows about
/// positions between the ends reach.
class LocalWindows {
 public:
  /// Domain: a complete method, its width in spacings; with Boundary::regression nothing stands past the ends. Errors:
  /// throws a size error where too many data past an end lie within the width.
  LocalWindows(const ExtendedData& data, Boundary boundary, const LocalPolynomial& method);

  /// The data from `first` to before `end` lie within the radius of the position.
  struct Window {
    double position = 0;
    std::size_t first = 0;
    std::size_t end = 0;
    double radius = 0;
  };

  /// A window of so many points grows until those with a factor above 0 stand at more positions than the degree, as far
  /// as there are such. Domain: `before` is the window of a position that is not larger, or {}. Cost: as far as the
  /// window moves from there.
  Window at(double position, const Window& before) const;

  std::size_t count() const { return positions_.size(); }
  const std::vector<double>& positions() const { return positions_; }
  /// Of the datum number k in ExtendedData.
  long index(std::size_t k) const { return indices_.empty() ? static_cast<long>(k) - before_ : indices_[k]; }
  /// By its distance alone.
  double factor(const Window& window, std::size_t k) const;
  /// The positions of the data of a window from its own, in units of its radius, and their factors.
  void nodes_and_factors(const Window& window, std::vector<double>& nodes, std::vector<double>& factors) const;
  /// Which derivative the datum is, 0: a value.
  int order(std::size_t k) const { return kinds_ == 1 ? 0 : static_cast<int>((k + shift_) % kinds_); }
  /// Whether data of the window for which counts(k) holds determine a polynomial: a position gives as many conditions
  /// as it has derivatives 0, 1, ... without a gap, and all together are more than the degree.
  template <class Counts>
  bool determines(const Window& window, const Counts& counts) const {
    std::size_t conditions = 0, last = window.end;
    unsigned seen = 0;  // derivatives at the last position, a bit each
    for (std::size_t k = window.first; k < window.end && conditions <= degree_; ++k) {
      if (!counts(k)) continue;
      if (last == window.end || positions_[k] != positions_[last]) {
        conditions += static_cast<std::size_t>(std::countr_one(seen));
        seen = 0;
        last = k;
      }
      seen |= 1U << static_cast<unsigned>(order(k));
    }
    return conditions + static_cast<std::size_t>(std::countr_one(seen)) > degree_;
  }
  bool determines(const Window& window) const {
    return determines(window, [&](std::size_t k) { return factor(window, k) > 0; });
  }

 private:
  std::vector<long> indices_beyond(const ExtendedData& data, long step) const;
  Window nearest(double position, std::size_t from) const;
  Window within(double position, const Window& before) const;
  void take_all_within(Window& window) const;

  LocalWeight weight_;
  std::size_t degree_, kinds_, points_;  // points: data, each derivative by itself
  std::size_t shift_ = 0;                // of numbers of data, modulo the kinds
  double width_;
  bool repeated_ = false;  // whether data share positions
  std::vector<double> positions_;
  std::vector<long> indices_;  // none: consecutive
  long before_ = 0;            // data before the first
};

}  // namespace subcert::data
