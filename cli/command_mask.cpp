// subcert mask SCHEME

#include "command.hpp"

namespace subcert::cli {

void add_mask(CLI::App& app) {
  auto options = std::make_shared<CommonOptions>();
  auto specification = std::make_shared<std::string>();
  CLI::App& command = add_command(app, "mask", "The exact mask of a scheme", "subcert mask primal:n=3", options, [=] {
    const Scheme scheme = make_scheme(*specification);
    const LaurentPolynomial& symbol = scheme.mask.symbol();
    if (!options->json) {
      options->answer(symbol.to_mask_text() + "\n");
      return done;
    }
    const Interval support = limit_support(scheme.mask);
    Json coefficients = Json::array();
    for (const Rational& c : symbol.coefficients()) coefficients.push_back(to_text(c));
    options->answer(Json{{"scheme", scheme.specification},
                         {"arity", scheme.mask.arity()},
                         {"first_index", symbol.lowest()},
                         {"coefficients", coefficients},
                         {"support", {{"lower", to_text(support.lower)}, {"upper", to_text(support.upper)}}}});
    return done;
  });
  add_scheme(command, *specification);
}

}  // namespace subcert::cli
