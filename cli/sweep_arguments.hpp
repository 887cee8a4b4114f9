#pragma once
/// The options of commands that run sweeps.

#include "command.hpp"

#include <subcert/proofs-checks/sweeps/sweep.hpp>

#include <string>

namespace subcert::cli {

/// --journal and --shard, as they stand on the command line.
struct SweepArguments {
  std::string journal;
  std::string shard = "1/1";
};

void add_sweep_arguments(Command& command, SweepArguments& arguments);

/// What run_sweep takes; progress lines begin with `title`. Errors: throws ParseError for a malformed shard, a usage
/// error where a launcher started several processes that cannot work together.
sweeps::SweepOptions sweep_options(const CommonOptions& common, const SweepArguments& arguments,
                                   const std::string& title);

}  // namespace subcert::cli
