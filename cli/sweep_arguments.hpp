#pragma once
/// The options of commands that run sweeps.

#include "command.hpp"

#include <subcert/proofs-checks/sweeps/sweep_plan.hpp>

#include <string>
#include <vector>

namespace subcert::cli {

/// The positional argument SCHEMES.
void add_schemes_of_sweep(Command& command, std::vector<std::string>& schemes);

/// What it means: the plan that is given alone, or one of these schemes. Errors: throws a data error for a plan that
/// cannot be read, a usage error for one beside other texts.
sweeps::SweepPlan plan_of_texts(const std::vector<std::string>& texts, const std::string& command);

/// `1 scheme`, `2 schemes`; what has another plural gives it.
std::string counted(std::size_t count, const std::string& one, const std::string& several = "");

/// --journal and --shard, as they stand on the command line.
struct SweepArguments {
  std::string journal;
  std::string shard = "1/1";
};

void add_sweep_arguments(Command& command, SweepArguments& arguments);

/// --worker, of commands whose cases are answered by processes.
struct WorkerArguments {
  std::string worker;

  /// That one, or this program. Errors: throws missing_file where it cannot be started.
  std::string answering_program() const;
};

void add_worker(Command& command, WorkerArguments& arguments);

/// What run_sweep takes; progress lines begin with `title`. Errors: throws ParseError for a malformed shard, a usage
/// error where a launcher started several processes that cannot work together.
sweeps::SweepOptions sweep_options(const CommonOptions& common, const SweepArguments& arguments,
                                   const std::string& title);

}  // namespace subcert::cli
