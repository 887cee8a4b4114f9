#include "manual.hpp"

#include <subcert/reports/formats/provenance.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace subcert::cli {
namespace {

/// Text of a page: no character commands groff, and hyphens stay hyphens when copied.
std::string escaped(const std::string& text) {
  std::string result = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) {
    switch (c) {
      case '\\': result += "\\e"; break;
      case '-': result += "\\-"; break;
      case '^': result += "\\(ha"; break;
      case '~': result += "\\(ti"; break;
      case '`': result += "\\(ga"; break;
      case '\'': result += "\\(aq"; break;
      default: result += c;
    }
  }
  return result;
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }

std::string page_reference(const std::string& name) { return bold(name) + "(1)"; }

std::string capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

std::string section(const std::string& title) { return ".SH " + escaped(capitals(title)) + "\n"; }

/// A term and what it means.
std::string term(const std::string& shown_term, const std::string& meaning) {
  return ".TP\n" + shown_term + "\n" + escaped(meaning) + "\n";
}

/// Verbatim.
std::string display(const std::string& lines) {
  std::istringstream stream(lines);
  std::string result = ".PP\n.EX\n";
  for (std::string line; std::getline(stream, line);) result += escaped(line) + "\n";
  return result + ".EE\n";
}

/// Long lists of words may go on in the next line behind a comma.
std::string breakable(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == ',' ? std::string(",\\:") : std::string(1, c);
  return result;
}

std::string options_text(const std::vector<OptionHelp>& options) {
  std::string text;
  for (const OptionHelp& option : options) {
    std::string names;
    for (const std::string& name : option.names) names += (names.empty() ? "" : ", ") + bold(name);
    text += term(names + (option.value.empty() ? "" : " " + breakable(escaped(option.value))), option.meaning);
  }
  return text;
}

/// The end of help: `Title:` begins a section; terms stand at column 2, their meanings behind two blanks or at column 6
/// of the next line; other lines at column 2 are examples. Of a command in a group the sections are smaller ones.
std::string footer_text(const std::string& footer, bool is_in_group = false) {
  std::vector<std::string> lines;
  std::istringstream stream(footer);
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) lines.push_back(line);
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    if (!line.starts_with("  ")) {
      const std::string title = line.substr(0, line.size() - 1);
      text += !line.ends_with(':') ? ".PP\n" + escaped(line) + "\n"
              : is_in_group        ? ".SS " + escaped(title) + "\n"
                                   : section(title);
      continue;
    }
    const std::string content = line.substr(2);
    if (i + 1 < lines.size() && lines[i + 1].starts_with("      ")) {
      text += term(bold(content), lines[++i].substr(6));
    } else if (const std::size_t blanks = content.find("  "); blanks != std::string::npos) {
      text += term(bold(content.substr(0, blanks)), content.substr(content.find_first_not_of(' ', blanks)));
    } else {
      text += display(content);
    }
  }
  return text;
}

/// Arguments, options, commands of a group.
std::string body(const CommandHelp& command) {
  std::string text;
  if (!command.arguments.empty()) text += section("Arguments") + options_text(command.arguments);
  if (!command.options.empty()) text += section("Options") + options_text(command.options);
  if (!command.name.empty()) {
    for (const CommandHelp& one : command.commands)
      text += section("subcert " + one.name) + escaped(one.meaning) + ".\n.PP\n" + bold(one.usage) + "\n" +
              options_text(one.arguments) + options_text(one.options) + footer_text(one.footer, true);
  }
  return text;
}

}  // namespace

std::string page_name(const CommandHelp& command) {
  return command.name.empty() ? "subcert" : "subcert-" + command.name;
}

std::string manual_page(const CommandHelp& program, const CommandHelp& command, const std::string& checker_usage) {
  const std::string name = page_name(command);
  const bool is_program = command.name.empty();
  const bool is_shared = name == "subcert-check";
  std::string text = fmt::format(
      ".\\\" Made from the help of the program.\n.TH {} 1 \"\" \"subcert {}\" \"subcert\"\n"
      ".ad l\n.nh\n.SH NAME\n{} \\- {}{}\n.SH SYNOPSIS\n{}\n",
      escaped(capitals(name)), formats::version(), escaped(name), escaped(command.meaning),
      is_shared ? "; the independent checker of certificates" : "", bold(command.usage));
  if (is_shared) text += ".PP\n\\fBsubcert\\-check\\fR \\fICLAIM\\fR \\fIFILE\\fR\n";
  text += section("Description") + escaped(command.meaning) + ".\n";
  if (is_shared)
    text +=
        ".PP\nTwo things have this name: the command \\fBsubcert check\\fR, and the program \\fBsubcert\\-check\\fR, "
        "whose section is below.\n";
  if (is_program) {
    text += ".PP\nEvery command has a page of its own, which says the same as its \\fB\\-\\-help\\fR.\n" +
            section("Commands");
    for (const CommandHelp& one : command.commands) text += term(page_reference(page_name(one)), one.meaning);
  }
  text += body(command) + footer_text(command.footer);
  if (is_shared) text += section("The program subcert-check") + display(checker_usage);
  if (!is_program) text += footer_text(program.footer);
  std::vector<std::string> others;
  if (!is_program) others.push_back("subcert");
  const auto has_option = [&](const std::string& option) {
    return std::any_of(command.options.begin(), command.options.end(),
                       [&](const OptionHelp& one) { return one.names.back() == option; });
  };
  if (has_option("--certificate") || is_shared) others.push_back("subcert-verify");
  if (is_program || name == "subcert-verify") others.push_back("subcert-check");
  text += section("See also");
  for (std::string& other : others) other = page_reference(other);
  return text + fmt::format("{}\n", fmt::join(others, ", "));
}

}  // namespace subcert::cli
