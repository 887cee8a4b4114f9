// subcert manual: writes the manual pages; run when the program is built

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/checker.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/cli/manual.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <filesystem>

namespace subcert::cli {
namespace {

void write_pages(const CommandHelp& program, const std::filesystem::path& folder, const std::string& checker) {
  const std::string checker_usage = run_checker({"--help"}, checker).text;
  std::vector<const CommandHelp*> commands{&program};
  for (const CommandHelp& command : program.commands) commands.push_back(&command);
  for (const CommandHelp* command : commands)
    runtime::write_file((folder / (page_name(*command) + ".1")).string(),
                        manual_page(program, *command, checker_usage));
}

}  // namespace

void add_manual(Command& app) {
  const auto folder = std::make_shared<std::string>();
  const auto checker = std::make_shared<std::string>();
  Command command = app.subcommand("manual", "Writes the manual pages");
  command.option("FOLDER", *folder, "Where they go").required();
  command.option("CHECKER", *checker, "The program subcert-check, whose help is part of its page").required();
  command.run([app, folder, checker] {
    write_pages(app.help(), *folder, *checker);
    return static_cast<int>(done);
  });
  command.hide();
}

}  // namespace subcert::cli
