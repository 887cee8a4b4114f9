#include "options.hpp"

#include <CLI/CLI.hpp>

namespace subcert::cli {

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
  return *this;
}

Option& Option::with_default() {
  option_->capture_default_str();
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

void Command::require_subcommands(std::size_t at_least, std::size_t at_most) {
  app_->require_subcommand(static_cast<int>(at_least), static_cast<int>(at_most));
}

bool Command::has_parsed_subcommand() const { return !app_->get_subcommands().empty(); }

void Command::footer(const std::string& text) { app_->footer(text); }

void Command::run(const std::function<void()>& action) { app_->callback(action); }

}  // namespace subcert::cli
