#pragma once
/// Local polynomial regression: at each position a polynomial is fitted to the data around it.

#include "linear_smoother.hpp"
#include "local_windows.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace subcert::data {

/// `local:points=21,d=1,weight=tricube`, `local:width=0.5,d=2,weight=box`, `local:d=1,weight=tricube,robust=3`. Errors
/// of reading: throws a usage error.
std::string to_text(const LocalPolynomial& method);
bool is_local_specification(std::string_view specification);
/// Whether it is that of a local polynomial with robust steps. Errors: as make_local_polynomial().
bool is_robust_specification(std::string_view specification);
LocalPolynomial make_local_polynomial(std::string_view specification);

/// What a fit at one output is made of: the data of its window with their weights w_i > 0, and polynomials q_k that are
/// orthonormal with these weights. The value there is the sum of y_i roots[i] values[k][i] at[k].
struct LocalBasis {
  static constexpr std::size_t outside = static_cast<std::size_t>(-1);
  std::vector<std::size_t> data;            ///< numbers of the data, or `outside` for the constant past an end
  std::vector<double> roots;                ///< of the weights
  std::vector<std::vector<double>> values;  ///< [k][i] = roots[i] q_k(position of datum i)
  std::vector<double> at;                   ///< [k] = q_k(position of the output)
};

/// The fits of local polynomials at the outputs, without robust steps; a derivative is that of the polynomial fitted
/// there. With Boundary::regression nothing stands past the ends, and fits near them are one-sided. Data that are
/// derivatives, by the index, are fitted by those of the polynomial, together with the values.
class LocalSmoother : public LinearSmoother {
 public:
  /// Domain: a complete method whose width is in spacings, derivative <= degree. Errors: throws a domain error; a data
  /// error for fewer data than points; else as LinearSmoother.
  LocalSmoother(const LocalPolynomial& method, DataSites sites, const SmoothingOptions& options);

  SmoothingRow row(std::size_t output) const override;
  /// Of all outputs, without derivatives. Errors: as row().
  std::vector<LocalBasis> bases() const;

  /// The values at the outputs where prior weights are multiplied by `factors`, one for each datum, and in windows that
  /// would leave no fit by themselves. Of methods with robust steps those with windows of more than 128 data are fitted
  /// at 64 places of a window, and interpolated between these; else as apply(). Domain: as many data and factors as
  /// sites, factors >= 0. Cost: a few operations for each datum of each window.
  std::vector<double> values(const std::vector<double>& data, const std::vector<double>& factors, int threads) const;

 private:
  template <class Number>
  class Rows;
  std::unique_ptr<RowMaker<double>> row_maker() const override;
  std::size_t stride() const override;
  /// Throws a data error where the window leaves no fit.
  void require_fit(const LocalWindows::Window& window) const;

  LocalPolynomial method_;
  LocalWindows windows_;
};

}  // namespace subcert::data
