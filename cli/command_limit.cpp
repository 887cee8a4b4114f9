// subcert limit SCHEME

#include "command.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/limit/limit_values.hpp>

#include <iomanip>
#include <iostream>
#include <sstream>

namespace subcert::cli {
namespace {

struct LimitOptions : CommonOptions {
  std::string scheme;
  int level = 8;
  int derivative = 0;
};

ExitCode run(const LimitOptions& options) {
  const Scheme scheme = make_scheme(options.scheme);
  if (options.derivative == 0) {
    const Decision convergence = converges(scheme.mask);
    if (!convergence.is_yes())
      return refuse_unproved(scheme.specification, "no limit function to evaluate", convergence);
  } else {
    const SmoothnessProof smoothness = proved_smoothness(scheme.mask);
    if (smoothness.order < options.derivative) {
      std::cerr << "subcert: " << scheme.specification << ": derivative " << options.derivative
                << " is not proved to be continuous; " << smoothness.obstacle << "\n";
      return undecided;
    }
  }
  const LimitValues values = limit_values(scheme.mask, options.level, options.derivative);
  if (options.json) {
    options.answer(Json{{"scheme", scheme.specification},
                        {"arity", values.arity},
                        {"level", values.level},
                        {"derivative", values.order},
                        {"first_index", values.first_index},
                        {"values", numbers_json(values.values)}});
    return done;
  }
  std::ostringstream text;
  for (std::size_t i = 0; i < values.values.size(); ++i)
    text << std::setw(12) << to_text(values.point(i)) << "  " << std::setw(20)
         << to_decimal(values.values[i], 15, Rounding::nearest) << "  " << to_text(values.values[i]) << "\n";
  options.answer(text.str());
  return done;
}

}  // namespace

void add_limit(Command& app) {
  auto options = std::make_shared<LimitOptions>();
  Command command = add_command(app, "limit", "Exact values of the basic limit function",
                                "subcert limit primal:n=2 --level 3", options, [=] { return run(*options); });
  command.option("--level", options->level, "Values at the points i / arity^LEVEL").within(0, 60).with_default();
  command.option("--derivative", options->derivative, "Order of the derivative").within(0, 1000).with_default();
  add_scheme(command, options->scheme);
}

}  // namespace subcert::cli
