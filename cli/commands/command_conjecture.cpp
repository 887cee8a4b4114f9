// subcert conjecture 7|8: certified tables and verdicts over ranges of n and d

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/pages/conjecture_page.hpp>
#include <subcert/cli/sweep_arguments.hpp>
#include <subcert/proofs-checks/number_list.hpp>

namespace subcert::cli {
namespace {

struct ConjectureOptions : CommonOptions, SweepArguments {
  int number = 7;
  std::string n = "1..40";
  std::string d = "1,3,5";
  conjectures::CaseBudget budget;
};

constexpr int largest_n = 2047, largest_d = 2 * largest_n - 1;

template <class Check>
ExitCode answer(const ConjectureOptions& options, const ConjectureRange& range, const Check& check) {
  const sweeps::SweepOptions sweep = sweep_options(options, options, "conjecture " + std::to_string(options.number));
  const auto result = check(range.schemes, options.budget, sweep);
  if (!result) return done;
  options.end_progress();
  if (options.json)
    options.answer(conjecture_json(*result, range));
  else
    options.answer(conjecture_text(*result, range));
  return exit_code(result->verdict);
}

ExitCode run(const ConjectureOptions& options) {
  const std::vector<int> n = parse_number_list("--n", options.n, 1, largest_n);
  const std::vector<int> d = parse_number_list("--d", options.d, 0, largest_d);
  const ConjectureRange range{number_list_text(n), number_list_text(d),
                              sweeps::parse_shard(options.shard).is_whole() ? "" : options.shard,
                              conjectures::distinct_primal_schemes(n, d)};
  if (range.schemes.schemes.empty())
    fail(ErrorKind::usage, "{} is left out: {}; no scheme remains",
         range.schemes.skipped.front().scheme.specification(), range.schemes.skipped.front().reason());
  return options.number == 7 ? answer(options, range, conjectures::check_conjecture_7)
                             : answer(options, range, conjectures::check_conjecture_8);
}

}  // namespace

void add_conjecture(Command& app) {
  auto options = std::make_shared<ConjectureOptions>();
  Command command = add_command(
      app, "conjecture", "Conjectures 7 and 8 of Dyn et al. over ranges of n and d, certified",
      "subcert conjecture 7 --n 1..40 --d 1,3,5 --journal seven.journal", options, [=] { return run(*options); });
  command.option("NUMBER", options->number, "7: max psi ~ 1/n and max |psi'| ~ 1/n^2; 8: psi is monotone in d and n")
      .required()
      .within(7, 8);
  command.option("--n", options->n, "Values of n, as 1..40 or 1,2,5..9").with_default();
  command.option("--d", options->d, "Degrees").with_default();
  command.option("--width", options->budget.relative_width, "Relative width of the enclosures")
      .within(1e-15, 0.5)
      .with_default();
  command.option("--budget", options->budget.seconds, "Seconds of processor time for each case")
      .within(0.001, 1e6)
      .with_default();
  add_sweep_arguments(command, *options);
}

}  // namespace subcert::cli
