// The limits C_d with 32 digits by two methods, and the second coefficient for degree 1 against exact means.

#include "proofs.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include "degree_one.hpp"
#include "kept_by_scheme.hpp"
#include "limit_constant.hpp"

namespace subcert::theorems {
namespace {

constexpr int quadrature_digits = 33;
constexpr int large = 132;  // the n at which the remainder of the mean is below half a percent of the second term

std::string name(int degree, const char* end) { return "C_" + std::to_string(degree) + end; }

/// The digits of each constant, the last one rounded down.
const char* stated_digits(int degree) {
  switch (degree) {
    case 1: return "0.40443676798398528146562149114537";
    case 3: return "1.04463731055178611512482192898430";
    case 5: return "1.68582015169964301573430513097017";
    case 7: return "2.32495767433520910442958803271836";
    case 9: return "2.96292059258582514692846037891264";
    default: return nullptr;
  }
}

const std::vector<int>& stated_degrees() {
  static const std::vector<int> degrees{1, 3, 5, 7, 9};
  return degrees;
}

/// Both ways to one constant, and C_degree < C_{degree+2} for the degrees below 20; kept for the next call.
struct Numbers {
  std::vector<Ball> sums, integrals;
  std::vector<Check> order;
};

const Numbers& numbers() {
  static const Numbers known = [] {
    Numbers result;
    for (int degree : stated_degrees()) {
      result.sums.push_back(limit_ball(degree));
      next_step(name(degree, " as an integral"));
      result.integrals.push_back(Ball::containing(limit_constant_by_quadrature(degree, quadrature_digits), proof_bits));
    }
    for (int degree = 1; degree <= 19; degree += 2)
      result.order.push_back(less("C0", "C_" + std::to_string(degree) + " < C_" + std::to_string(degree + 2),
                                  limit_ball(degree).enclosure(), limit_ball(degree + 2).enclosure()));
    return result;
  }();
  return known;
}

/// N^2 (N I/(2c) - 1) at `large` from the exact mean, without the remainder K/(2c N^2) and the aliases.
struct Observed {
  Ball coefficient, error;
};

Observed second_coefficient_at_large() {
  const DegreeOneMean mean = degree_one_mean(large);
  const Ball N = exactly(Rational(4 * large - 1, 2)), leading = Ball::containing(mean.leading, proof_bits);
  const Ball exact = exactly(squared_l2_norm(primal_mask(large, 1)));
  const Ball error = Ball::containing(mean.remainder, proof_bits) + exactly(*mean.aliases.upper);
  return {(exact / leading - 1) * N.pow(2), error / leading * N.pow(2)};
}

}  // namespace

const Ball& limit_ball(int degree) {
  static Kept<int, Ball> known;
  return known(degree, [&] {
    next_step("C_" + std::to_string(degree));
    return Ball::containing(limit_constant(degree, degree <= stated_degrees().back() ? 40 : 8), proof_bits);
  });
}

Constants limit_constants_stated() {
  std::vector<Constant> list;
  const Rational unit = power(Rational(10), -32);
  for (int degree : stated_degrees()) {
    const std::string number = std::to_string(degree);
    const Rational value = decimal(stated_digits(degree));
    list.push_back({name(degree, "-"), value, Side::below, "C" + number + "a", "limit of n max psi, degree " + number});
    list.push_back(
        {name(degree, "+"), value + unit, Side::above, "C" + number + "b", "limit of n max psi, degree " + number});
  }
  const Rational coefficient = degree_one_second_coefficient();
  list.push_back({"nu-", coefficient, Side::below, "N1", "coefficient of 1/N^2 in N I_n/(2c), degree 1, from below"});
  list.push_back({"nu+", coefficient, Side::above, "N2", "coefficient of 1/N^2 in N I_n/(2c), degree 1, from above"});
  return Constants(list);
}

std::vector<Check> limit_constants_checks(const Constants& c, int) {
  std::vector<Check> checks;
  for (std::size_t i = 0; i < stated_degrees().size(); ++i) {
    const int degree = stated_degrees()[i];
    const std::string number = std::to_string(degree), symbol = "C_" + number;
    const Ball &sum = numbers().sums[i], &integral = numbers().integrals[i];
    checks.push_back(defining(c, name(degree, "-"), symbol + " as a sum", sum));
    checks.push_back(defining(c, name(degree, "+"), symbol + " as a sum", sum));
    checks.push_back(less("C" + number + "c", "|" + symbol + " as a sum - " + symbol + " as an integral| < 10^-32",
                          abs(sum - integral).enclosure(), Enclosure::exactly(power(Rational(10), -32))));
  }
  checks.insert(checks.end(), numbers().order.begin(), numbers().order.end());
  static const Observed observed = second_coefficient_at_large();
  const Ball slack = observed.error;
  const std::string where = " at n = " + std::to_string(large);
  checks.push_back(less("N1", "nu- < N^2 (N I_n/(2c) - 1) + remainder" + where, Enclosure::exactly(c["nu-"]),
                        (observed.coefficient + slack).enclosure()));
  checks.push_back(less("N2", "N^2 (N I_n/(2c) - 1) - remainder < nu+" + where,
                        (observed.coefficient - slack).enclosure(), Enclosure::exactly(c["nu+"])));
  return checks;
}

}  // namespace subcert::theorems
