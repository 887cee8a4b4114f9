// Section 5: geometric data.

#include "dyn_2015.hpp"

#include <subcert/proofs-checks/statements/trial.hpp>

namespace subcert::statements::dyn_2015 {
namespace {

Outcome alpha_samples(const Context& context) {
  const Formula sample = context.formula("dyn-2015/eq-25-sample");
  const Formula last = context.formula("dyn-2015/eq-25-last"), end = context.formula("dyn-2015/eq-25-end");
  Trial trial;
  trial.equal(-end({}), sample({{"i", 0}}), "the first sample");
  trial.equal(end({}), sample({{"i", last({})}}), "the last sample");
  return trial.over("i = 0 and i = 29").outcome();
}

/// Samples of a closed curve of period 2 pi: as many steps as samples make one period. pi is a name, and 3 < pi < 22/7.
Trial one_period(const Formula& step, const Rational& count) {
  Trial trial;
  const Rational low = count * step({{"pi", 3}}), high = count * step({{"pi", Rational(22, 7)}});
  const std::string where = subcert::to_text(count) + " samples cover " +
                            to_decimal(std::min(low, high), 3, Rounding::down) + " ... " +
                            to_decimal(std::max(low, high), 3, Rounding::up) + " of the period 6.28...";
  for (const Rational& pi : {Rational(3), Rational(22, 7), Rational(311, 100)})
    trial.require(count * step({{"pi", pi}}) == 2 * pi,
                  where + "; the step times " + subcert::to_text(count) + " is not 2 pi");
  return trial;
}

Outcome star_samples(const Context& context) {
  const Rational count = context.formula("dyn-2015/eq-26-last")({}) + 1;
  return one_period(context.formula("dyn-2015/eq-26-step"), count)
      .outcome(one_period(context.formula("dyn-2015/eq-26-step", Form::corrected), count).over("50 samples"));
}

Outcome torus_samples(const Context& context) {
  const Rational count = context.formula("dyn-2015/eq-27-last")({}) + 1;
  Trial trial = one_period(context.formula("dyn-2015/eq-27-step"), count);
  trial.equal(context.formula("dyn-2015/eq-27-degrees")({}), 360 / count, "the step in degrees");
  return trial.over("24 samples").outcome();
}

Outcome mechanical_element(const Context& context) {
  Trial trial;
  trial.equal(context.formula("dyn-2015/vertices")({}), context.formula("dyn-2015/grid")({}), "the number of vertices");
  return trial.over("one number").outcome();
}

}  // namespace

void add_section_5(PaperStatements& to) {
  to.transcriptions.insert(to.transcriptions.end(), {
                                                        {"dyn-2015/eq-25-sample", "-7/5 + i*14/145"},
                                                        {"dyn-2015/eq-25-last", "29"},
                                                        {"dyn-2015/eq-25-end", "1.4"},
                                                        {"dyn-2015/eq-26-step", "{1/(100*pi) => pi/25}"},
                                                        {"dyn-2015/eq-26-last", "49"},
                                                        {"dyn-2015/eq-27-step", "pi/12"},
                                                        {"dyn-2015/eq-27-last", "23"},
                                                        {"dyn-2015/eq-27-degrees", "15"},
                                                        {"dyn-2015/grid", "49*81"},
                                                        {"dyn-2015/vertices", "3969"},
                                                    });
  const auto add = [&](const Statement& statement) { to.statements.push_back(statement); };
  add({"dyn-2015/eq-25", "section 5.1, equation (25)", "The samples of the alpha-like curve cover [-1.4, 1.4].",
       "first and last sample", R"(t_i = <<dyn-2015/eq-25-sample>>, \quad i = 0, \dots, <<dyn-2015/eq-25-last>>)", "",
       Verdict::holds, alpha_samples});
  add({"dyn-2015/eq-26", "section 5.1, equation (26)", "The samples of the star-shaped curve cover it.",
       "as many steps as samples make one period 2 pi",
       R"(t_i = i \cdot <<dyn-2015/eq-26-step>>, \quad i = 0, \dots, <<dyn-2015/eq-26-last>>)",
       R"(t_i = i \cdot <<dyn-2015/eq-26-step>>, \quad i = 0, \dots, <<dyn-2015/eq-26-last>>)", Verdict::misprint,
       star_samples});
  add({"dyn-2015/eq-27", "section 5.2, equation (27)", "The torus is sampled every 15 degrees.",
       "as many steps as samples make one period 2 pi",
       R"(u_i = i \cdot <<dyn-2015/eq-27-step>>, \quad i = 0, \dots, <<dyn-2015/eq-27-last>>)", "", Verdict::holds,
       torus_samples});
  add({"dyn-2015/vertices", "section 5.2", "The grid of the mechanical element has 3969 vertices.", "the product",
       R"(<<dyn-2015/grid>> = <<dyn-2015/vertices>>)", "", Verdict::holds, mechanical_element});
  add({"dyn-2015/figs-14-21", "section 5, Figs. 14-21", "Limits for noisy curves and surfaces.", "",
       R"(S_3, S_5, S_4^3, S_6^3, S_3 \otimes S_3, S_5 \otimes S_5)", "", Verdict::not_checkable, [](const Context&) {
         return not_checkable("the noise of the experiments and the scan of the mechanical element were not published");
       }});
}

}  // namespace subcert::statements::dyn_2015
