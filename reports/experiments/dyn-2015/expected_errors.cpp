// [DHHS15, eq. (16)]: the expected squared error, exact and simulated.

#include "parts.hpp"

#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/data/smooth/expected_error.hpp>
#include <subcert/schemes/data/smooth/scheme_smoother.hpp>
#include <subcert/schemes/specification.hpp>

namespace subcert::experiments::dyn_2015 {
namespace {

constexpr std::size_t data_points = 41;
const Rational sigma_squared(1, 25);

struct Case {
  std::string scheme;
  int subdivision;  // h = 1 / subdivision
  std::size_t output;
  data::ExpectedError exact{};
  data::SimulatedError simulated{};
};

Rational runge(const Rational& x) { return 1 / (1 + 25 * x * x); }

/// f at the data (index - 20) h, and at the multiples of 1/4 between.
Rational value(const Case& c, const Rational& position) { return runge((position - 20) / c.subdivision); }

void evaluate(Case& c, const Run& run, std::uint64_t salt) {
  const Scheme scheme = make_scheme(c.scheme);
  const data::SchemeSmoother smoother(scheme.mask.curve(), data_points, {data::Boundary::regression, 2, 0});
  std::vector<Rational> samples;
  std::vector<double> rounded;
  for (std::size_t i = 0; i < data_points; ++i) {
    samples.push_back(value(c, Rational(i)));
    rounded.push_back(data::nearest_double(samples.back()));
  }
  const data::SmoothingRow row = smoother.row(c.output);
  const Rational truth = value(c, smoother.position(c.output));
  c.exact = data::expected_error(row, samples, truth, sigma_squared);
  auto engine = generator(run.seed, salt);
  c.simulated = data::simulated_error(row, rounded, data::nearest_double(truth), 0.2, 100 * run.runs, engine(), 0.999);
}

}  // namespace

Measured expected_errors(const Run& run) {
  std::vector<Case> cases;
  for (const char* scheme :
       {"primal:n=2", "primal:n=3", "primal:n=5", "primal:n=5,d=3", "dual:n=3", "bspline:degree=3"})
    for (const int subdivision : {10, 20, 40})
      for (const std::size_t output : {80u, 82u, 1u}) cases.push_back({scheme, subdivision, output});
  parallel_for_each(cases.size(), run.jobs, [&](std::size_t i) { evaluate(cases[i], run, i); });
  formats::PlainTable table{"mse-values",
                            "Expected squared error: exact and simulated",
                            {"scheme", "h", "at", "bias^2", "sigma^2 psi", "exact sum", "simulated", "inside"},
                            {}};
  std::size_t inside = 0;
  for (const Case& c : cases) {
    const double exact = data::nearest_double(c.exact.total());
    const bool is_inside = c.simulated.lower <= exact && exact <= c.simulated.upper;
    inside += is_inside;
    table.rows.push_back({c.scheme, "1/" + std::to_string(c.subdivision), to_text(Rational(Rational(c.output) / 4)),
                          short_number(data::nearest_double(c.exact.bias * c.exact.bias)),
                          short_number(data::nearest_double(c.exact.variance)), short_number(exact),
                          short_number(c.simulated.lower) + " ... " + short_number(c.simulated.upper),
                          is_inside ? "yes" : "no"});
  }
  Measured result;
  result.add_fact("inside", "", inside * 20 >= cases.size() * 19,
                  std::to_string(inside) + " of " + std::to_string(cases.size()));
  result.tables = {table};
  return result;
}

}  // namespace subcert::experiments::dyn_2015
