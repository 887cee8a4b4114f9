#include "l1_basin.hpp"

#include "l1_refinement.hpp"
#include "l1_regression.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert::data {
namespace {

using Form = std::vector<Rational>;

/// The coefficients of the differences of this order in a form that vanishes on polynomials of lower degree.
Form in_differences(Form form, int order) {
  for (int k = 0; k < order; ++k) {
    for (std::size_t j = 0; j + 1 < form.size(); ++j) {
      form[j + 1] += form[j];
      form[j] = -form[j];
    }
    require(form.back() == 0, "l1 basin: need a form of differences");
    form.pop_back();
  }
  return form;
}

Rational sum_of_moduli(const Form& form) {
  Rational sum = 0;
  for (const Rational& entry : form) sum += abs(entry);
  return sum;
}

/// Not below the root, by at most 2^-20.
Rational root_above(const Rational& value) {
  const Rational unit = power(Rational(2), 20);
  return Rational(sqrt(to_integer(value * unit * unit, Rounding::up)) + 1) / unit;
}

/// Least squares on one window.
struct LeastSquares {
  std::vector<Form> outputs;    // in the data
  std::vector<Form> residuals;  // in their differences
  Rational leverage_of_outputs, leverage_of_data;
};

LeastSquares least_squares(int points, int degree, int arity) {
  const RegressionWindow window = l1_window({{points}, degree, {}, arity});
  std::vector<Position> places = window.output_points();
  places.insert(places.end(), window.node_points().begin(), window.node_points().end());
  const RegressionWindow all(window.node_points(), degree, places);
  LeastSquares result;
  std::vector<Form> fits(places.size(), Form(window.nodes(), 0));
  for (std::size_t r = 0; r < window.nodes(); ++r) {
    Form data(window.nodes(), 0);
    data[r] = 1;
    const Form values = weighted_fit(all, Form(window.nodes(), 1), data);
    for (std::size_t place = 0; place < places.size(); ++place) fits[place][r] = values[place];
  }
  for (std::size_t place = 0; place < places.size(); ++place) {
    Rational leverage = 0;  // of a projection: the sum of the squares of its row
    for (const Rational& entry : fits[place]) leverage += entry * entry;
    const bool is_output = place < window.outputs();
    Rational& largest = is_output ? result.leverage_of_outputs : result.leverage_of_data;
    largest = std::max(largest, leverage);
    if (is_output) {
      result.outputs.push_back(fits[place]);
      continue;
    }
    Form residual = fits[place];
    for (Rational& entry : residual) entry = -entry;
    residual[place - window.outputs()] += 1;
    result.residuals.push_back(in_differences(std::move(residual), degree + 1));
  }
  return result;
}

/// Of the differences of this order in one step, window i giving the values a*i, ..., a*i + a - 1.
Rational norm_of_differences(const std::vector<Form>& outputs, int order) {
  Rational largest = 0;
  const std::size_t arity = outputs.size();
  for (std::size_t start = 0; start < arity; ++start) {
    Form form(outputs[0].size() + (start + static_cast<std::size_t>(order)) / arity, 0);
    Rational factor = order % 2 == 0 ? 1 : -1;
    for (int s = 0; s <= order; ++s) {
      const std::size_t index = start + static_cast<std::size_t>(s);
      for (std::size_t r = 0; r < outputs[0].size(); ++r) form[index / arity + r] += factor * outputs[index % arity][r];
      factor *= Rational(s - order, s + 1);
    }
    largest = std::max(largest, sum_of_moduli(in_differences(std::move(form), order)));
  }
  return largest;
}

/// The largest sum of the squares of forms on [-1, 1]^m: it is convex, so at a corner.
Rational largest_square(const std::vector<Form>& forms) {
  Rational largest = 0;
  for (std::size_t corner = 0; corner >> (forms[0].size() - 1) == 0; ++corner) {  // the last sign is that of all
    Rational sum = 0;
    for (const Form& form : forms) {
      Rational value = 0;
      for (std::size_t j = 0; j < form.size(); ++j) value += (corner >> j & 1) != 0 ? -form[j] : form[j];
      sum += value * value;
    }
    largest = std::max(largest, sum);
  }
  return largest;
}

}  // namespace

std::optional<L1Basin> l1_basin(int points, int degree, int arity) {
  require(degree >= 0 && degree <= 3 && points >= degree + 2 && points <= degree + 17,
          "l1 basin: need 0 <= degree <= 3 and degree + 2 <= points <= degree + 17, got {} and {}", degree, points);
  const LeastSquares fit = least_squares(points, degree, arity);
  L1Basin result;
  result.linear = norm_of_differences(fit.outputs, degree + 1);
  if (result.linear >= 1) return std::nullopt;
  Rational largest = 0;
  for (const Form& form : fit.residuals) largest = std::max(largest, sum_of_moduli(form));
  const Rational squares = root_above(largest_square(fit.residuals));
  const Rational of_data = root_above(fit.leverage_of_data) * squares;
  const Rational of_outputs = root_above(fit.leverage_of_outputs) * squares;
  result.contraction = (1 + result.linear) / 2;
  // Weights lie between 1 - e and 1; u stands for e / (1 - e), in terms of which all bounds are linear.
  const Rational by_contraction = (result.contraction - result.linear) / (power(Rational(2), degree + 1) * of_outputs);
  Rational best = 0;
  for (int part = 1; part <= 128; ++part) {
    const Rational residual = largest * (1 + Rational(part, 64));
    const Rational u = std::min(by_contraction, Rational((residual - largest) / of_data));
    const Rational radius_squared = 2 * u / ((1 + u) * residual * residual);
    if (radius_squared <= best) continue;
    best = radius_squared;
    result.residual = residual;
    // Not above the root, in thousandths.
    result.radius = Rational(sqrt(to_integer(radius_squared * 1000000, Rounding::down)), Integer(1000));
    result.error = of_outputs * residual * residual * (1 + u) / 2;
  }
  return result;
}

}  // namespace subcert::data
