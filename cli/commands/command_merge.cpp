// subcert merge JOURNAL... --out JOURNAL: joins the journals of shards

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/proofs-checks/sweeps/journal.hpp>

#include <filesystem>
#include <iostream>

namespace subcert::cli {
namespace {

struct MergeOptions : CommonOptions {
  std::vector<std::string> journals;
};

ExitCode run(const MergeOptions& options) {
  for (const std::string& journal : options.journals)
    if (!std::filesystem::exists(journal)) fail(ErrorKind::missing_file, "{}: no such file", journal);
  const sweeps::MergedJournals merged = sweeps::merge_journals({options.journals.begin(), options.journals.end()},
                                                               options.out);
  for (const std::string& report : merged.damage) std::cerr << "subcert: " << report << "\n";
  if (options.json)
    print_json({{"journal", options.out}, {"cases", merged.cases}, {"damaged_lines", merged.damage.size()}});
  else
    std::cout << options.out << ": " << merged.cases << (merged.cases == 1 ? " case\n" : " cases\n");
  return done;
}

}  // namespace

void add_merge(Command& app) {
  auto options = std::make_shared<MergeOptions>();
  Command command = add_command(app, "merge", "Joins the journals of the shards of a sweep",
                                "subcert merge shard-*.journal --out whole.journal", options,
                                [=] { return run(*options); });
  command.option("JOURNAL", options->journals, "Journals to join").required();
  command.existing("--out").describe("The journal that takes them; its own cases are kept").required();
}

}  // namespace subcert::cli
