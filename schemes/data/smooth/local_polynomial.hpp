#pragma once
/// Local polynomial regression: at each position a polynomial is fitted to the data around it.

#include "linear_smoother.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace subcert::data {

/// How much a datum counts at the distance u of the window's radius, 0 <= u <= 1: 1; 1 - u; 1 - u^2; (1 - u^2)^2;
/// (1 - u^3)^3.
enum class LocalWeight { box, triangle, epanechnikov, biweight, tricube };

/// The fit uses the data within a radius: the distance of the `points`-th nearest datum that is not missing or, with
/// `width`, that. Ref: [Cle79].
struct LocalPolynomial {
  int degree = 1;
  LocalWeight weight = LocalWeight::tricube;
  std::size_t points = 0;  ///< 0: by width, or to be chosen
  double width = 0;        ///< of the window to each side, in units of the positions; 0: by points

  bool is_complete() const { return points > 0 || width > 0; }
};

/// `local:points=21,d=1,weight=tricube`, `local:width=0.5,d=2,weight=box`, `local:d=1,weight=tricube`. Errors of
/// reading: throws a usage error.
std::string to_text(const LocalPolynomial& method);
bool is_local_specification(std::string_view specification);
LocalPolynomial make_local_polynomial(std::string_view specification);

/// The fits of local polynomials at the outputs; a derivative is that of the polynomial fitted there. With
/// Boundary::regression nothing stands past the ends, and fits near them are one-sided.
class LocalSmoother : public LinearSmoother {
 public:
  /// Domain: a complete method whose width is in spacings, derivative <= degree. Errors: throws a domain error; a data
  /// error for fewer data than points; else as LinearSmoother.
  LocalSmoother(const LocalPolynomial& method, DataSites sites, const SmoothingOptions& options);

  SmoothingRow row(std::size_t output) const override;

 private:
  /// Indices from first to last lie within the radius of the position.
  struct Window {
    double position;
    long first;
    long last;
    double radius;
  };
  template <class Number>
  class Rows;
  std::unique_ptr<RowMaker<double>> row_maker() const override;
  Window window_at(double position) const;
  template <class Number>
  Number weight_of(const Window& window, long index) const;
  /// The indices of the data that count, and their weights.
  template <class Number>
  std::pair<std::vector<long>, std::vector<Number>> fitted_data(const Window& window) const;

  /// Whether data at more positions than the degree count.
  bool determines(const Window& window) const;

  LocalPolynomial method_;
  bool repeated_ = false;  // whether data share positions
};

}  // namespace subcert::data
