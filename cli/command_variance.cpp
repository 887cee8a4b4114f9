// subcert variance SCHEME

#include "command.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/variance/variance.hpp>

#include <iostream>
#include <sstream>

namespace subcert::cli {
namespace {

struct VarianceOptions : CommonOptions {
  std::string scheme;
  int level = 8;
};

int run(const VarianceOptions& options) {
  const Scheme scheme = make_scheme(options.scheme);
  const SmoothnessProof smoothness = proved_smoothness(scheme.mask);
  if (smoothness.order < 0) {
    const Decision convergence = converges(scheme.mask);
    std::cerr << "subcert: " << scheme.specification << ": no variance curve; convergence: "
              << to_text(convergence.truth) << " (" << convergence.reason << ")\n";
    return convergence.is_no() ? failed : undecided;
  }
  const VarianceGrid grid = variance_grid(scheme.mask, options.level, smoothness.order >= 1);
  const Enclosure sup{grid.largest(), variance_ceiling(scheme.mask)};
  const Enclosure inf{variance_floor(scheme.mask), grid.smallest()};
  const Enclosure slope = Enclosure::at_least(grid.steepest());
  const Rational mean = squared_l2_norm(scheme.mask);
  if (options.json) {
    options.answer(Json{{"scheme", scheme.specification},
                        {"level", grid.level},
                        {"sup", enclosure_json(sup)},
                        {"inf", enclosure_json(inf)},
                        {"derivative_sup", enclosure_json(slope)},
                        {"mean", to_text(mean)}});
    return done;
  }
  std::ostringstream text;
  text << "scheme        " << scheme.specification << "  (" << scheme.title << ")\n"
       << "psi           exact on the grid of level " << grid.level << "; one-sided bounds follow\n"
       << "maximum       " << enclosure_text(sup) << "\n"
       << "minimum       " << enclosure_text(inf) << "\n"
       << "largest |psi'|" << " " << enclosure_text(slope) << "\n"
       << "mean          " << to_decimal(mean, 15, Rounding::nearest) << "  = " << to_text(mean) << "\n";
  options.answer(text.str());
  return done;
}

}  // namespace

void add_variance(CLI::App& app) {
  auto options = std::make_shared<VarianceOptions>();
  CLI::App& command =
      add_command(app, "variance", "The variance curve psi on a grid, with rigorous one-sided bounds",
                  "subcert variance primal:n=5", options, [=] { return run(*options); });
  command.add_option("--level", options->level, "Grid of arity^LEVEL points in a period")
      ->check(CLI::Range(0, 60))
      ->capture_default_str();
  add_scheme(command, options->scheme);
}

}  // namespace subcert::cli
