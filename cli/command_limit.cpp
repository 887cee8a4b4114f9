// subcert limit SCHEME

#include "multivariate_regularity_page.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/limit/multivariate_limit_values.hpp>
#include <subcert/analysis/symbol/error.hpp>

#include <iomanip>
#include <iostream>
#include <sstream>

namespace subcert::cli {
namespace {

constexpr double convergence_seconds = 10;
constexpr int usual_level = 8, usual_level_of_surfaces = 2;

struct LimitOptions : CommonOptions {
  std::string scheme;
  int level = -1;  // not given
  int derivative = 0;
};

ExitCode run(const MultivariateScheme& scheme, const LimitOptions& options) {
  if (options.derivative > 0)
    fail(ErrorKind::usage, "--derivative: need a scheme of one variable, got {}", scheme.specification);
  const Decision convergence = multivariate_regularity_page(scheme, {Deadline::in(convergence_seconds)}, false)
                                   .regularity.converges;
  if (!convergence.is_yes()) return refuse_unproved(scheme.specification, "no limit function to evaluate", convergence);
  const LatticeSequence values = limit_values(scheme.mask, options.level);
  if (options.json) {
    Json points = Json::array(), numbers = Json::array();
    for (const auto& [point, value] : values) {
      points.push_back(point);
      numbers.push_back(to_text(value));
    }
    options.answer(Json{{"scheme", scheme.specification},
                        {"dilation", scheme.mask.dilation().rows()},
                        {"level", options.level},
                        {"indices", std::move(points)},
                        {"values", std::move(numbers)}});
    return done;
  }
  std::ostringstream text;
  for (const auto& [index, value] : values) {
    std::vector<Rational> point(index.begin(), index.end());
    for (int n = 0; n < options.level; ++n) point = scheme.mask.dilation().inverse_times(point);
    std::string place;
    for (const Rational& coordinate : point) place += (place.empty() ? "" : ", ") + to_text(coordinate);
    text << std::setw(20) << place << "  " << std::setw(20) << to_decimal(value, 15, Rounding::nearest) << "  "
         << to_text(value) << "\n";
  }
  options.answer(text.str());
  return done;
}

ExitCode run(const Scheme& scheme, const LimitOptions& options) {
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
                                "subcert limit primal:n=2 --level 3", options, [=] {
                                  const LinearScheme scheme = make_linear_scheme(options->scheme);
                                  if (options->level < 0)
                                    options->level = scheme.index() == 0 ? usual_level : usual_level_of_surfaces;
                                  return std::visit([&](const auto& one) { return run(one, *options); }, scheme);
                                });
  command
      .option("--level", options->level,
              "Values at the points i / arity^LEVEL, 8 if not given; of surfaces at M^-LEVEL i, 2 if not given")
      .within(0, 60);
  command.option("--derivative", options->derivative, "Order of the derivative").within(0, 1000).with_default();
  add_scheme(command, options->scheme, true);
}

}  // namespace subcert::cli
