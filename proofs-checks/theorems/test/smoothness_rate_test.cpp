#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/symbol/matrices/ball_solvers.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/proofs-checks/theorems/smoothness_rate.hpp>
#include <subcert/schemes/specification.hpp>

#include <cmath>
#include <complex>
#include <numbers>

using namespace subcert;
using namespace subcert::theorems;

namespace {

Mask primal_of(int n) { return make_scheme("primal:n=" + std::to_string(n)).mask.curve(); }

/// h_n from the coefficients of the second differences, in floating point.
class PlainHarmonics {
 public:
  explicit PlainHarmonics(int n) {
    const Mask mask = divided_difference_scheme(primal_of(n), 2);
    const std::vector<Rational> coefficients = mask.symbol().coefficients();
    const double centre = (static_cast<double>(coefficients.size()) - 1) / 2;
    const auto b = [&](double w) {
      double sum = 0;
      for (std::size_t i = 0; i < coefficients.size(); ++i)
        sum += coefficients[i].convert_to<double>() * std::cos((static_cast<double>(i) - centre) * w);
      return sum / 2;
    };
    for (int k = 1; k < 2 * n - 0.5; k += 2) {
      double product = 1, w = 2 * std::numbers::pi * k;
      for (int j = 0; j < 30; ++j) product *= b(w /= 2);
      values_.push_back(2 * product);
    }
  }
  double operator()(double x) const {
    double sum = 0;
    for (std::size_t i = 0; i < values_.size(); ++i)
      sum += values_[i] * std::cos(2 * std::numbers::pi * (2 * static_cast<double>(i) + 1) * x);
    return sum;
  }
  double mean(int length, int digits) const {
    double sum = 0, x = digits / (std::exp2(length) - 1);
    for (int j = 0; j < length; ++j, x = std::fmod(2 * x, 1)) sum += (*this)(x);
    return sum / length;
  }

 private:
  std::vector<double> values_;
};

}  // namespace

TEST_CASE("the predicted mean is that of its word, and no orbit has more than the largest mean") {
  for (int n : {2, 3, 4, 5, 6, 8, 12, 16}) {
    const SmoothnessRate rate = smoothness_rate(n);
    CAPTURE(n, rate.word);
    const PlainHarmonics h(n);
    const int length = static_cast<int>(rate.word.size());
    const double mean = h.mean(length, std::stoi(rate.word, nullptr, 2)), scale = std::abs(h(0)) + std::abs(mean);
    CHECK(std::abs(rate.predicted.lower->convert_to<double>() - mean) < 1e-6 * scale);
    CHECK(*rate.predicted.upper - *rate.predicted.lower < power(Rational(10), -30));
    CHECK(rate.largest.contains(*rate.predicted.upper));
    for (int p = 1; p <= 11; ++p)
      for (int digits = 0; digits < std::max(1, (1 << p) - 1); ++digits)
        REQUIRE(h.mean(p, digits) <= rate.largest.upper->convert_to<double>() + 1e-9 * scale);
  }
}

TEST_CASE("the eigenvalue of the word is the joint spectral radius where the prediction is right") {
  for (int n = 2; n <= 8; ++n) {
    const SmoothnessRate rate = smoothness_rate(n);
    CAPTURE(n, rate.word);
    const HolderRegularity exact = holder_regularity(primal_of(n), 4, {});
    REQUIRE(*exact.exponent.upper - *exact.exponent.lower < power(Rational(10), -15));
    const double defect = (2 - *exact.exponent.lower).convert_to<double>() * std::log(2.0);
    REQUIRE(rate.product.is_bounded());
    CHECK(rate.product.lower->convert_to<double>() <= defect * (1 + 1e-12));
    // For n = 4 the second order decides: 0001 has the larger product.
    if (n != 4) CHECK(rate.product.upper->convert_to<double>() >= defect * (1 - 1e-12));
    if (n >= 5) CHECK(std::abs(rate.predicted.lower->convert_to<double>() / defect - 1) < 0.02);
  }
}

TEST_CASE("determinants of balls, and sizes outside the domain") {
  const auto ball = [](long value) { return Ball(value, 128); };
  const std::vector<std::vector<Ball>> regular{
      {ball(0), ball(2), ball(1)}, {ball(3), ball(1), ball(4)}, {ball(5), ball(9), ball(2)}};
  CHECK(determinant(regular, 128).enclosure().contains(50));
  const std::vector<std::vector<Ball>> singular{{ball(1), ball(3)}, {ball(2), ball(6)}};
  CHECK(determinant(singular, 128).enclosure().contains(0));
  CHECK_FAILS(smoothness_rate(1), domain);
  CHECK_FAILS(smoothness_rate(65), domain);
}
