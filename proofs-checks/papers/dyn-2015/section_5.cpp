// Section 5: geometric data.

#include "checks.hpp"

#include <subcert/proofs-checks/statements/trial.hpp>

namespace subcert::statements::dyn_2015 {
namespace {

Outcome alpha_samples(const Context& context) {
  const Formula sample = context.formula("eq-25-sample");
  const Formula last = context.formula("eq-25-last"), end = context.formula("eq-25-end");
  Trial trial;
  trial.equal(-end({}), sample({{"i", 0}}), "the first sample");
  trial.equal(end({}), sample({{"i", last({})}}), "the last sample");
  return trial.over("i = 0 and i = 29");
}

/// Samples of a closed curve of period 2 pi: as many steps as samples make one period. pi is a name, and
/// 333/106 < pi < 355/113.
Trial one_period(const Formula& step, const Rational& count) {
  Trial trial;
  const auto percent = [&](const Rational& pi) { return Rational(100 * count * step({{"pi", pi}}) / (2 * pi)); };
  const Rational low(333, 106), high(355, 113), one = percent(low), other = percent(high);
  const std::string where = subcert::to_text(count) + " steps make " +
                            to_decimal(std::min(one, other), 4, Rounding::down) + " ... " +
                            to_decimal(std::max(one, other), 4, Rounding::up) + " % of the period 2 pi";
  for (const Rational& pi : {low, high, Rational(157, 50)})
    trial.require(count * step({{"pi", pi}}) == 2 * pi,
                  where + "; the step times " + subcert::to_text(count) + " is not 2 pi");
  return trial;
}

Outcome star_samples(const Context& context) {
  const Rational count = context.formula("eq-26-last")({}) + 1;
  return one_period(context.formula("eq-26-step"), count)
      .outcome(one_period(context.formula("eq-26-step", Form::corrected), count).over("50 samples"));
}

Outcome torus_samples(const Context& context) {
  const Rational count = context.formula("eq-27-last")({}) + 1;
  Trial trial = one_period(context.formula("eq-27-step"), count);
  trial.equal(context.formula("eq-27-degrees")({}), 360 / count, "the step in degrees");
  return trial.over("24 samples");
}

Outcome mechanical_element(const Context& context) {
  Trial trial;
  trial.equal(context.formula("vertices")({}), context.formula("grid")({}), "the number of vertices");
  return trial.over("one number");
}

}  // namespace

Checks section_5() {
  return {
      {"eq-25", alpha_samples}, {"eq-26", star_samples}, {"eq-27", torus_samples}, {"vertices", mechanical_element}};
}

}  // namespace subcert::statements::dyn_2015
