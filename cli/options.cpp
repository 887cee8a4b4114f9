#include "options.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/reports/facts/screen_lines.hpp>
#include <subcert/reports/formats/provenance.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <regex>
#include <sstream>

namespace subcert::cli {
namespace {

/// CLI11's options have no room for words.
std::map<const CLI::Option*, Suggestions>& suggestions_of_options() {
  static std::map<const CLI::Option*, Suggestions> suggestions;
  return suggestions;
}

/// Of all options that take a number in floating point: nothing but finite decimal numbers.
CLI::Validator finite() {
  return CLI::Validator(
      [](const std::string& text) -> std::string {
        double value = 0;
        const char *begin = text.data() + (text.starts_with('+') ? 1 : 0), *end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(begin, end, value);
        const bool number = error == std::errc() && stop == end && std::isfinite(value);
        return number ? "" : "expected a finite number, got " + in_quotes(text);
      },
      "");
}

/// Of all options that take an integer.
CLI::Validator whole() {
  return CLI::Validator(
      [](const std::string& text) -> std::string {
        const auto value = parse_rational(text);
        return value && denominator(*value) == 1 ? "" : "expected an integer, got " + in_quotes(text);
      },
      "");
}

/// The files among the arguments, which are read.
std::map<std::filesystem::path, std::string> files_read(const CLI::App& app) {
  std::map<std::filesystem::path, std::string> files;
  for (const CLI::Option* option : app.get_options())
    if (option->get_positional())
      for (const std::string& text : option->results())
        if (std::error_code error; std::filesystem::is_regular_file(text, error))
          files.emplace(std::filesystem::weakly_canonical(text, error), "");
  return files;
}

/// Refuses one file for two answers, an answer in the place of a file that is read, and standard output for another one
/// than the first.
void require_different_files(const CLI::App& app) {
  std::map<std::filesystem::path, std::string> taken = files_read(app);
  for (const std::string name : {"--out", "--plot", "--csv", "--html", "--page", "--stencils-header", "--certificate",
                                 "--journal", "--junit", "--sarif"}) {
    const CLI::Option* option = app.get_option_no_throw(name);
    if (!option || option->count() == 0) continue;
    const std::string& file = option->results().front();
    if (file == "-" && name != "--out")
      fail(ErrorKind::usage, "{} -: standard output takes the answer of the command; expected another place", name);
    if (file == "-") continue;
    std::error_code error;
    const auto [other, is_new] = taken.emplace(std::filesystem::weakly_canonical(file, error), name);
    if (!is_new && other->second.empty())
      fail(ErrorKind::usage, "{} {}: it is read, and would be overwritten; expected another file", name, file);
    if (!is_new)
      fail(ErrorKind::usage, "{} {}: {} is to write there, too; expected another file", name, file, other->second);
  }
}

/// Help in lines that a terminal shows whole.
class ScreenFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    std::istringstream lines(CLI::Formatter::make_help(app, std::move(name), mode));
    std::string result;
    for (std::string line; std::getline(lines, line);) {
      // A meaning goes on where it begins: behind the blanks that part it from what it explains.
      const std::size_t term = std::min(line.find_first_not_of(' '), line.size());
      const std::size_t meaning = line.find_first_not_of(' ', line.find("  ", term));
      result += facts::wrapped(line, meaning == std::string::npos ? term : meaning) + "\n";
    }
    return result;
  }
};

OptionHelp help_of(const CLI::Option& option) {
  const CLI::Formatter formatter;
  OptionHelp help;
  help.names = CLI::detail::split(formatter.make_option_name(&option, option.get_positional()), ',');
  help.value = CLI::detail::trim_copy(formatter.make_option_opts(&option));
  help.meaning = option.get_description();
  help.many = option.get_expected_max() == CLI::detail::expected_max_vector_size;
  if (const auto found = suggestions_of_options().find(&option); found != suggestions_of_options().end())
    help.suggestions = found->second;
  return help;
}

CommandHelp help_of(const CLI::App& app, const std::string& name) {
  const std::string program = "subcert";
  const std::string usage = CLI::Formatter().make_usage(&app, name.empty() ? program : program + " " + name);
  CommandHelp help{name, app.get_description(), CLI::detail::trim_copy(usage.substr(usage.find(':') + 1)),
                   app.get_footer()};
  for (const CLI::Option* option : app.get_options())
    if (!option->get_group().empty())
      (option->get_positional() ? help.arguments : help.options).push_back(help_of(*option));
  for (const CLI::App* command : app.get_subcommands({}))
    if (!command->get_group().empty())
      help.commands.push_back(help_of(*command, name.empty() ? command->get_name() : name + " " + command->get_name()));
  return help;
}

}  // namespace

Option& Option::required() {
  option_->required();
  return *this;
}

Option& Option::within(int low, int high) {
  option_->check(CLI::Range(low, high));
  return *this;
}

Option& Option::within(double low, double high) {
  option_->check(CLI::Range(low, high));
  return *this;
}

Option& Option::share(double most) {
  option_->check(CLI::Validator(
      [most](const std::string& text) -> std::string {
        const auto number = parse_number(text);
        if (!number || *number <= 1 || *number > 100 * Rational(most)) return "";
        return "expected a share of 1; " + text + " % are " + to_decimal(*number / 100, 9, Rounding::nearest);
      },
      ""));
  return within(0.0, most);
}

Option& Option::exact_number() {
  option_->type_name("NUMBER");
  option_->check(CLI::Validator(
      [](const std::string& text) -> std::string {
        return parse_number(text) ? "" : "expected an exact number, as 1/16, 0.5 or 1e-9, got " + in_quotes(text);
      },
      ""));
  return *this;
}

Option& Option::one_of(const std::vector<std::string>& words) {
  option_->check(CLI::Validator(
      [words](const std::string& text) -> std::string {
        return std::ranges::find(words, text) == words.end() ? expected_one_of(words, text) : "";
      },
      fmt::format("{{{}}}", fmt::join(words, ","))));
  return suggest([words] {
    std::vector<Suggestion> suggestions;
    for (const std::string& word : words) suggestions.push_back({word, ""});
    return suggestions;
  });
}

Option& Option::with_default() {
  option_->capture_default_str();
  return *this;
}

Option& Option::one_each() {
  option_->allow_extra_args(false);
  return *this;
}

Option& Option::separated_by_commas() {
  option_->delimiter(',');
  return *this;
}

Option& Option::describe(const std::string& text) {
  option_->description(text);
  return *this;
}

Option& Option::suggest(const Suggestions& suggestions) {
  suggestions_of_options()[option_] = suggestions;
  return *this;
}

Option Command::option(const std::string& name, int& target, const std::string& text) {
  return Option(app_->add_option(name, target, text)->check(whole()));
}

Option Command::option(const std::string& name, unsigned long& target, const std::string& text) {
  return Option(app_->add_option(name, target, text)->check(whole()));
}

Option Command::option(const std::string& name, double& target, const std::string& text) {
  return Option(app_->add_option(name, target, text)->check(finite()));
}

Option Command::option(const std::string& name, std::optional<double>& target, const std::string& text) {
  return Option(app_->add_option_function<double>(
                        name, [&target](const double& value) { target = value; }, text)
                    ->check(finite()));
}

Option Command::option(const std::string& name, std::optional<int>& target, const std::string& text) {
  return Option(app_->add_option_function<int>(
                        name, [&target](const int& value) { target = value; }, text)
                    ->check(whole()));
}

Option Command::option(const std::string& name, std::string& target, const std::string& text) {
  return Option(app_->add_option(name, target, text));
}

Option Command::option(const std::string& name, std::vector<std::string>& target, const std::string& text) {
  return Option(app_->add_option(name, target, text));
}

Option Command::flag(const std::string& name, bool& target, const std::string& text) {
  return Option(app_->add_flag(name, target, text));
}

Option Command::existing(const std::string& name) { return Option(app_->get_option(name)); }

std::vector<std::string> Command::given() const {
  std::vector<std::string> names;
  for (const CLI::Option* option : app_->get_options())
    if (option->count() > 0 && !option->get_positional()) names.push_back(option->get_name());
  return names;
}

Command Command::subcommand(const std::string& name, const std::string& text) {
  return Command(app_->add_subcommand(name, text));
}

void Command::add_to_footer(const std::string& text) { app_->footer(app_->get_footer() + text); }

void Command::run(const std::function<int()>& action) {
  app_->callback([action, app = app_] {
    require_different_files(*app);
    if (const int code = action(); code != 0) throw CLI::RuntimeError(code);
  });
}

void Command::run_without_subcommand(const std::function<int()>& action) {
  app_->require_subcommand(0, 1);
  app_->callback([app = app_, action] {
    if (!app->get_subcommands().empty()) return;
    if (const int code = action(); code != 0) throw CLI::RuntimeError(code);
  });
}

void Command::hide() { app_->group(""); }

CommandHelp Command::help() const { return help_of(*app_, ""); }

namespace {

/// `help` and `help range` as `--help` and `range --help`.
std::vector<std::string> arguments_of(int argc, char** argv) {
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  if (arguments.empty() || arguments.front() != "help") return arguments;
  arguments.erase(arguments.begin());
  arguments.emplace_back("--help");
  return arguments;
}

/// The names in quotes behind a beginning, as `; see 'a', 'b'`; empty where there are none.
std::string see_also(const char* beginning, const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? beginning : ", ") + ("'" + name + "'");
  return text;
}

/// For a word that is near no command: those whose names begin as it does, or whose meanings speak of it; or what lists
/// schemes.
std::string commands_about(const CLI::App& app, const std::string& word) {
  constexpr std::size_t shortest = 3, most = 5;
  std::vector<std::string> found;
  const std::string wanted = CLI::detail::to_lower(word);
  constexpr std::array<std::pair<std::string_view, std::string_view>, 10> elsewhere{{
      {"list", "'subcert mask --help' lists the schemes"},
      {"families", "'subcert mask --help' lists the schemes"},
      {"schemes", "'subcert mask --help' lists the schemes"},
      {"scheme", "'subcert mask --help' lists the schemes"},
      {"plot", "'analyze', 'compare', 'refine' and 'smooth' draw, with --plot FILE"},
      {"draw", "'analyze', 'compare', 'refine' and 'smooth' draw, with --plot FILE"},
      {"show", "'subcert analyze SCHEME' tells all about one scheme, with --plot FILE in a picture, too"},
      {"cite", "the file CITATION.cff says how"},
      {"licence", "the file LICENSE has it"},
      {"license", "the file LICENSE has it"},
  }};
  for (const auto& [other, meaning] : elsewhere)
    if (wanted == other) return "; " + std::string(meaning);
  for (const CLI::App* command : app.get_subcommands({})) {
    const std::string name = command->get_name(), meaning = CLI::detail::to_lower(command->get_description());
    const bool near = name.starts_with(wanted) || wanted.starts_with(name) || meaning.find(wanted) != std::string::npos;
    if (!command->get_group().empty() && wanted.size() >= shortest && near) found.push_back(name);
  }
  return found.size() > most ? "" : see_also("; did you mean one of ", found);
}

/// What stands for an option that other programs have; empty where nothing is known.
std::string known_as(const std::string& option, const std::vector<std::string>& names) {
  constexpr std::array<std::array<std::string_view, 3>, 9> elsewhere{{
      {"--robust", "--scheme", "--scheme local:d=1,robust=3"},
      {"--window", "--weights", "--scheme local:d=1,width=..., or points=..."},
      {"--bandwidth", "--weights", "--scheme local:d=1,width=..."},
      {"--span", "--weights", "--scheme local:d=1,width=..."},
      {"--sigma", "--errors", "--errors COLUMN, or --noise for one number"},
      {"--sd", "--errors", "--errors COLUMN, or --noise for one number"},
      {"--se", "--errors", "--errors COLUMN, or --noise for one number"},
      {"--iterations", "--levels", "--levels"},
      {"--steps", "--levels", "--levels"},
  }};
  for (const auto& [word, needs, meaning] : elsewhere)
    if (option == word && std::ranges::count(names, needs) > 0) return "; did you mean " + std::string(meaning) + "?";
  return "";
}

/// Commands that have the option.
std::string commands_with(const CLI::App& app, const std::string& option) {
  std::vector<std::string> found;
  for (const CLI::App* command : app.get_subcommands({}))
    if (!command->get_group().empty() && command->get_option_no_throw(option)) found.push_back(command->get_name());
  return see_also("; it is one of ", found);
}

/// For the first argument where it is a scheme.
std::string command_for_scheme(const std::string& word) {
  return is_scheme(word) ? "; it is a scheme, as in 'subcert analyze " + printable(word) + "'" : "";
}

/// Refuses a first argument that is neither a command nor an option.
void require_command(const CLI::App& app, const std::vector<std::string>& arguments) {
  if (arguments.empty())
    fail(ErrorKind::usage, "a command is missing, as in 'subcert analyze chaikin'; 'subcert --help' lists all");
  if (arguments.front().starts_with('-')) {
    if (!app.get_option_no_throw(arguments.front()))
      fail(ErrorKind::usage, "there is no option {} before a command; see 'subcert --help'",
           in_quotes(arguments.front()));
    return;
  }
  std::vector<std::string> names{"help"};
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == arguments.front()) return;
    if (!command->get_group().empty()) names.push_back(command->get_name());
  }
  std::string meant = did_you_mean(arguments.front(), names);
  if (meant.empty()) meant = commands_about(app, arguments.front());
  if (meant.empty()) meant = command_for_scheme(arguments.front());
  fail(ErrorKind::usage, "there is no command {}{}; see 'subcert --help'", in_quotes(arguments.front()), meant);
}

/// Whose help says more: of the command that is named first, or of the program.
std::string helped(const CLI::App& app, const std::vector<std::string>& arguments) {
  for (const CLI::App* command : app.get_subcommands({}))
    if (!arguments.empty() && command->get_name() == arguments.front()) return command->get_name() + " ";
  return "";
}

/// The first argument that looks like an option and is none of the command that is named, with the nearest one.
void refuse_unknown_option(const CLI::App& app, const std::vector<std::string>& arguments) {
  const CLI::App* command = &app;
  std::vector<std::string> names;
  const auto add_names = [&] {
    for (const CLI::Option* option : command->get_options())
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  };
  add_names();
  for (const std::string& argument : arguments) {
    if (argument == "--") return;
    for (const CLI::App* below : command->get_subcommands({}))
      if (below->get_name() == argument) {
        command = below;
        add_names();
        break;
      }
    const std::string name = argument.substr(0, argument.find('='));
    if (name.starts_with("--") && std::ranges::find(names, name) == names.end()) {
      const std::string elsewhere = commands_with(app, name), known = known_as(name, names);
      fail(ErrorKind::usage, "there is no option {}{}; see 'subcert {}--help'", in_quotes(name),
           !known.empty()      ? known
           : elsewhere.empty() ? did_you_mean(name, names)
                               : elsewhere,
           helped(app, arguments));
    }
  }
}

/// What a command line that lacks an argument, or has one too many, may have meant.
std::string meant_by(const CLI::ParseError& error, const std::vector<std::string>& arguments) {
  if (arguments.size() < 2) return "";
  const std::string& last = arguments.back();
  if (dynamic_cast<const CLI::RequiredError*>(&error) && arguments.size() == 2 && std::filesystem::exists(last))
    return fmt::format("; {} is a file: name a scheme before it, as in 'subcert {} chaikin {}'", printable(last),
                       arguments.front(), printable(last));
  const bool too_many = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  return too_many && is_scheme(last) ? "; 'subcert compare' takes several schemes" : "";
}

/// What CLI11 says of an option that is given more than once, as this program says it.
std::string in_our_words(const std::string& message) {
  static const std::regex too_often("^(--[a-z-]+): At Most 1 required but received ([0-9]+)$");
  std::smatch found;
  if (!std::regex_match(message, found, too_often)) return message;
  return fmt::format("{}: expected once; found {} values", found[1].str(), found[2].str());
}

}  // namespace

bool is_scheme(const std::string& word) {
  try {
    make_any_scheme(word);
    return true;
  } catch (const Error&) {
    return false;
  }
}

int run_program(const std::string& description, const std::string& footer,
                const std::vector<void (*)(Command&)>& add_commands, int argc, char** argv) {
  CLI::App app{description, "subcert"};
  app.set_version_flag("--version", std::string("subcert ") + formats::version());
  app.require_subcommand(1);
  app.formatter(std::make_shared<ScreenFormatter>());  // before its commands, which take it over
  Command program(&app);
  for (const auto add : add_commands) add(program);
  app.footer(footer);  // last, as commands inherit it
  std::vector<std::string> arguments = arguments_of(argc, argv);
  require_command(app, arguments);
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));  // CLI11 takes the last one first
    return 0;
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::RuntimeError& left) {
    return left.get_exit_code();
  } catch (const CLI::ParseError& error) {
    refuse_unknown_option(app, arguments);
    fail(ErrorKind::usage, "{}{}; see 'subcert {}--help'", in_our_words(error.what()), meant_by(error, arguments),
         helped(app, arguments));
  }
}

}  // namespace subcert::cli
