#include "sweep_arguments.hpp"

#include <subcert/proofs-checks/sweeps/ranks.hpp>
#include <subcert/reports/formats/provenance.hpp>

#include <iostream>

namespace subcert::cli {

void add_sweep_arguments(Command& command, SweepArguments& arguments) {
  command.option("--journal", arguments.journal, "Keep finished cases there and go on from those it has");
  command.option("--shard", arguments.shard, "Only part I of N, as I/N with I from 1 to N; see 'subcert merge'");
}

sweeps::SweepOptions sweep_options(const CommonOptions& common, const SweepArguments& arguments,
                                   const std::string& title) {
  sweeps::SweepOptions options;
  options.journal = arguments.journal;
  options.shard = sweeps::parse_shard(arguments.shard);
  sweeps::rank_count();  // refuses processes that cannot work together
  options.jobs = common.jobs;
  options.version = formats::version();
  options.progress = [&common, title](const std::string& line) { common.progress(title + ": " + line); };
  options.warn = [&common](const std::string& line) {
    common.end_progress();
    std::cerr << "subcert: " << line << "\n";
  };
  return options;
}

}  // namespace subcert::cli
