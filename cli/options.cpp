#include "options.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <CLI/CLI.hpp>

#include <map>

namespace subcert::cli {
namespace {

/// CLI11's options have no room for words.
std::map<const CLI::Option*, Suggestions>& suggestions_of_options() {
  static std::map<const CLI::Option*, Suggestions> suggestions;
  return suggestions;
}

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

Option& Option::one_of(const std::vector<std::string>& words) {
  option_->check(CLI::IsMember(words));
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
  return Option(app_->add_option(name, target, text));
}

Option Command::option(const std::string& name, unsigned long& target, const std::string& text) {
  return Option(app_->add_option(name, target, text));
}

Option Command::option(const std::string& name, double& target, const std::string& text) {
  return Option(app_->add_option(name, target, text));
}

Option Command::option(const std::string& name, std::optional<double>& target, const std::string& text) {
  return Option(app_->add_option_function<double>(
      name, [&target](const double& value) { target = value; }, text));
}

Option Command::option(const std::string& name, std::optional<int>& target, const std::string& text) {
  return Option(app_->add_option_function<int>(
      name, [&target](const int& value) { target = value; }, text));
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

Command Command::subcommand(const std::string& name, const std::string& text) {
  return Command(app_->add_subcommand(name, text));
}

void Command::add_to_footer(const std::string& text) { app_->footer(app_->get_footer() + text); }

void Command::run(const std::function<int()>& action) {
  app_->callback([action] {
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

int run_program(const std::string& description, const std::string& footer,
                const std::vector<void (*)(Command&)>& add_commands, int argc, char** argv) {
  CLI::App app{description, "subcert"};
  app.set_version_flag("--version", std::string("subcert ") + SUBCERT_VERSION);
  app.require_subcommand(1);
  Command program(&app);
  for (const auto add : add_commands) add(program);
  app.footer(footer);  // last, as commands inherit it
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::RuntimeError& left) {
    return left.get_exit_code();
  } catch (const CLI::ParseError& error) {
    fail(ErrorKind::usage, "{}; see 'subcert --help'", error.what());
  }
}

}  // namespace subcert::cli
