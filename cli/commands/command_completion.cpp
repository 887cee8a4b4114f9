// subcert completion SHELL: the script with which a shell completes the command line

#include <subcert/cli/command.hpp>
#include <subcert/cli/completion.hpp>

namespace subcert::cli {

void add_completion(Command& app) {
  const auto shell = std::make_shared<std::string>();
  const auto options = std::make_shared<CommonOptions>();
  Command command = app.subcommand("completion", "The completion of command lines, as a script for a shell");
  command.add_to_footer("\nExample:\n  subcert completion bash > ~/.local/share/bash-completion/completions/subcert");
  command.option("SHELL", *shell, "The shell that reads the script").one_of({"bash", "zsh", "fish"}).required();
  command.option("--out", options->out, "Write the script there");
  command.run([app, shell, options] {
    const CommandHelp program = app.help();
    options->answer(*shell == "bash"  ? bash_completion(program)
                    : *shell == "zsh" ? zsh_completion(program)
                                      : fish_completion(program));
    return static_cast<int>(done);
  });
}

}  // namespace subcert::cli
