#pragma once
/// Subcommands, their options and flags. CLI11, which parses them, is compiled in options.cpp alone.

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace subcert::cli {

/// A word that may stand for the value of an option, with its meaning or none.
struct Suggestion {
  std::string word;
  std::string meaning;
};
using Suggestions = std::function<std::vector<Suggestion>()>;

/// What help says of an option or argument.
struct OptionHelp {
  std::vector<std::string> names;  ///< `-h` and `--help`; of an argument its one name
  std::string value;               ///< type, range and default, as help prints them; empty for flags
  std::string meaning;
  bool many = false;        ///< whether one value may follow another
  Suggestions suggestions;  ///< none: any value
};

/// What help says of a command, without what is hidden from it.
struct CommandHelp {
  std::string name;  ///< `range`; `statements check` of a command in a group; empty for the program
  std::string meaning;
  std::string usage;
  std::string footer;
  std::vector<OptionHelp> arguments = {};
  std::vector<OptionHelp> options = {};
  std::vector<CommandHelp> commands = {};
};

/// An option or argument that may be restricted further.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}
  Option& required();
  Option& within(int low, int high);
  Option& within(double low, double high);
  /// Of 1, from 0 to `most`. What is meant in percent is answered with the share.
  Option& share(double most);
  /// Of a text: parse_number can read it. Help calls the value NUMBER.
  Option& exact_number();
  Option& one_of(const std::vector<std::string>& words);
  /// Help shows the value that the target has now.
  Option& with_default();
  /// `a,b` is the same as `a b`.
  Option& separated_by_commas();
  /// A value each time the option is named; what follows is an argument of its own.
  Option& one_each();
  Option& describe(const std::string& text);
  /// Words that a shell offers for the value; others are as good. They are asked for when a completion is made.
  Option& suggest(const Suggestions& suggestions);

 private:
  CLI::Option* option_;
};

/// The program, or a subcommand of it. Names that start with dashes are options, others positional arguments; targets
/// must live until the program has run.
class Command {
 public:
  explicit Command(CLI::App* app) : app_(app) {}

  Option option(const std::string& name, int& target, const std::string& text);
  Option option(const std::string& name, unsigned long& target, const std::string& text);
  /// Numbers in floating point are finite.
  Option option(const std::string& name, double& target, const std::string& text);
  Option option(const std::string& name, std::optional<double>& target, const std::string& text);
  Option option(const std::string& name, std::optional<int>& target, const std::string& text);
  Option option(const std::string& name, std::string& target, const std::string& text);
  Option option(const std::string& name, std::vector<std::string>& target, const std::string& text);
  Option flag(const std::string& name, bool& target, const std::string& text);
  /// One that was added before.
  Option existing(const std::string& name);
  /// The names of the options that stand on the command line, in the order of the help.
  std::vector<std::string> given() const;

  Command subcommand(const std::string& name, const std::string& text);
  void add_to_footer(const std::string& text);
  /// What the command does; it returns the program's exit code.
  void run(const std::function<int()>& action);
  /// The same for a command that has subcommands and was given none of them.
  void run_without_subcommand(const std::function<int()>& action);
  /// Help, pages and completions do not name the command.
  void hide();
  /// All that help says of this command and those below it.
  CommandHelp help() const;

 private:
  CLI::App* app_;
};

/// Whether the word is a scheme that can be read.
bool is_scheme(const std::string& word);

/// Reads the command line, runs the command that it names and returns the exit code. Errors: throws a usage error for a
/// command line that cannot be read, and whatever the command throws.
int run_program(const std::string& description, const std::string& footer,
                const std::vector<void (*)(Command&)>& add_commands, int argc, char** argv);

}  // namespace subcert::cli
