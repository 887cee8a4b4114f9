// subcert regularity SCHEME

#include "command.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/regularity/holder_bound.hpp>

#include <chrono>
#include <sstream>

namespace subcert::cli {
namespace {

struct RegularityOptions : CommonOptions {
  std::string scheme;
  int levels = 16;
  double budget = 60;
};

int run(const RegularityOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const Scheme scheme = make_scheme(options.scheme);
  options.progress("norms of the difference scheme");
  const HolderBounds bounds = holder_bounds(scheme.mask, options.levels, options.budget);
  options.end_progress();
  const bool complete = static_cast<int>(bounds.levels.size()) == options.levels;
  const HolderBound& last = bounds.last();
  const HolderBound& best = bounds.best();
  // A bound that is not positive proves nothing, not even convergence.
  const bool proves = *best.exponent.lower > 0;
  const Decision convergence = proves ? Decision{Truth::yes, "the bound is positive"}
                                      : converges(scheme.mask, {options.levels, options.budget});
  Enclosure holder;
  if (proves)
    holder = Enclosure::at_least(*best.exponent.lower);
  else if (convergence.is_yes())
    holder = Enclosure::at_least(0);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const int code = convergence.is_no() ? failed : (convergence.is_yes() && complete) ? done : undecided;

  if (options.json) {
    Json by_level = Json::array();
    for (const HolderBound& bound : bounds.levels) by_level.push_back(bound.exponent.lower_text(12));
    options.answer(Json{{"scheme", scheme.specification},
                        {"sum_rules", bounds.sum_rules},
                        {"bound", {{"levels", last.levels}, {"norm", to_text(last.norm)}, {"holder", enclosure_json(last.exponent)}}},
                        {"bounds_by_level", by_level},
                        {"converges", to_text(convergence.truth)},
                        {"holder", enclosure_json(holder)},
                        {"exact", false},
                        {"method", "norms of the difference scheme"},
                        {"stable", false},
                        {"seconds", seconds}});
    return code;
  }
  std::ostringstream text;
  text << "scheme       " << scheme.specification << "  (" << scheme.title << ")\n"
       << "sum rules    " << bounds.sum_rules << "\n"
       << "levels       bound for the Hoelder exponent\n";
  for (const HolderBound& bound : bounds.levels)
    text << (bound.levels < 10 ? "         " : "        ") << bound.levels << "   " << enclosure_text(bound.exponent) << "\n";
  text << "norm         ||S_b^" << last.levels << "|| = " << to_text(last.norm) << "\n"
       << "converges    " << to_text(convergence.truth) << ": " << convergence.reason << "\n"
       << "exponent     " << enclosure_text(holder) << "  (a lower bound; the exact exponent is not computed)\n";
  if (!complete) text << "budget       spent after " << last.levels << " of " << options.levels << " levels\n";
  options.answer(text.str());
  return code;
}

}  // namespace

void add_regularity(CLI::App& app) {
  auto options = std::make_shared<RegularityOptions>();
  CLI::App& command = add_command(app, "regularity", "Proved bounds of the Hoelder exponent",
                                  "subcert regularity dual:n=7 --levels 16", options, [=] { return run(*options); });
  command.add_option("--levels", options->levels, "Levels of the difference scheme")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command.add_option("--budget", options->budget, "Seconds")->check(CLI::Range(0.001, 1e6))->capture_default_str();
  add_scheme(command, options->scheme);
}

}  // namespace subcert::cli
