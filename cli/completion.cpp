#include "completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace subcert::cli {
namespace {

/// The program and all its commands.
std::vector<const CommandHelp*> all_commands(const CommandHelp& program) {
  std::vector<const CommandHelp*> all{&program};
  for (const CommandHelp& command : program.commands)
    for (const CommandHelp* below : all_commands(command)) all.push_back(below);
  return all;
}

/// `check` of `statements check`.
std::string last_word(const std::string& name) { return name.substr(name.rfind(' ') + 1); }

bool takes_value(const OptionHelp& option) { return !option.value.empty(); }

/// Any text may be the name of a file; numbers, and what has words, are none.
bool may_be_file(const OptionHelp& option) { return option.value.starts_with("TEXT") && !option.suggestions; }

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

std::string in_a_row(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); }

/// A word of bash and zsh.
std::string quoted(const std::string& text) { return "'" + replaced(text, "'", "'\\''") + "'"; }

std::string fish_quoted(const std::string& text) {
  return "'" + replaced(replaced(text, "\\", "\\\\"), "'", "\\'") + "'";
}

/// Lists of words, each once.
class Lists {
 public:
  /// The number of the list.
  std::size_t number(const OptionHelp& option) {
    std::vector<Suggestion> list = option.suggestions();
    const auto same = [](const Suggestion& a, const Suggestion& b) { return a.word == b.word; };
    for (std::size_t i = 0; i < lists_.size(); ++i)
      if (std::equal(list.begin(), list.end(), lists_[i].begin(), lists_[i].end(), same)) return i;
    lists_.push_back(std::move(list));
    return lists_.size() - 1;
  }

  const std::vector<std::vector<Suggestion>>& all() const { return lists_; }

 private:
  std::vector<std::vector<Suggestion>> lists_;
};

/// Whether each word is only the beginning of a value, as `primal:`.
bool are_beginnings(const std::vector<Suggestion>& list) {
  return std::all_of(list.begin(), list.end(), [](const Suggestion& one) { return one.word.ends_with(':'); });
}

constexpr auto bash_body = R"(
_subcert() {
  local IFS=$' \t\n'
  local typed current= word option= command= place=0 commands options valued words= files=
  read -ra typed <<<"${COMP_LINE:0:COMP_POINT}"
  [[ ${COMP_LINE:COMP_POINT-1:1} == [[:blank:]] ]] || { current=${typed[-1]}; unset 'typed[-1]'; }
  _subcert_command ''
  for word in "${typed[@]:1}"; do
    if [[ $option ]]; then option=
    elif [[ $word == -* ]]; then [[ " $valued " != *" $word "* ]] || option=$word
    elif [[ " $commands " == *" $word "* ]]; then command+="$word " && _subcert_command "$command"
    else ((++place)); fi
  done
  if [[ ! $option && $current == --*=* ]]; then
    option=${current%%=*}
    current=${current#*=}
  fi
  if [[ $option ]]; then _subcert_words "$command$option"
  elif [[ $current == -* ]]; then words=$options
  else
    _subcert_words "$command$place"
    words+=" $commands"
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  # What is replaced begins behind the last break of words.
  local breaks=${COMP_WORDBREAKS//[^:=]}
  [[ ! $breaks ]] || COMPREPLY=("${COMPREPLY[@]#"${current%"${current##*[$breaks]}"}"}")
  [[ ! $files ]] || compopt -o default 2>/dev/null
  [[ ${COMPREPLY[0]-} != *: ]] || compopt -o nospace 2>/dev/null
}
complete -F _subcert subcert
)";

std::string zsh_function_name(const std::string& command) {
  return command.empty() ? "_subcert" : "_subcert_" + replaced(command, " ", "_");
}

/// Words and their meanings, as the elements of an array for _describe.
std::string zsh_choices(const std::vector<Suggestion>& list) {
  std::string text;
  for (const Suggestion& one : list)
    text += "\n    " + quoted(replaced(replaced(one.word, "\\", "\\\\"), ":", "\\:") +
                              (one.meaning.empty() ? "" : ":" + one.meaning));
  return text;
}

/// What _arguments is told of the options and arguments of a command.
std::string zsh_arguments(const CommandHelp& command, Lists& lists) {
  std::string text;
  const auto value_of = [&](const OptionHelp& option, const std::string& name) {
    return ":" + name + ":" +
           (option.suggestions    ? "_subcert_words_" + std::to_string(lists.number(option))
            : may_be_file(option) ? "_files"
                                  : " ");
  };
  for (const OptionHelp& option : command.options) {
    const std::string name = option.names.back();
    std::string rest = replaced(replaced(replaced(option.meaning, "\\", "\\\\"), "[", "\\["), "]", "\\]");
    rest = quoted((takes_value(option) ? "=[" : "[") + rest + "]" +
                  (takes_value(option) ? value_of(option, name.substr(2)) : ""));
    text += " \\\n    " +
            (option.names.size() == 2 ? fmt::format("'(- *)'{{{},{}}}", option.names[0], name)
             : option.many            ? "'*'" + name
                                      : name) +
            rest;
  }
  for (const OptionHelp& argument : command.arguments)
    text += " \\\n    " + quoted((argument.many ? "*" : "") + value_of(argument, argument.names.back()));
  return text;
}

std::string zsh_function(const CommandHelp& command, Lists& lists) {
  const std::string begin = zsh_function_name(command.name) + "() {\n";
  const std::string arguments = zsh_arguments(command, lists);
  if (command.commands.empty()) return begin + "  _arguments" + arguments + "\n}\n\n";
  std::vector<Suggestion> below;
  std::string cases;
  for (const CommandHelp& one : command.commands) {
    below.push_back({last_word(one.name), one.meaning});
    cases += fmt::format("      {}) {} ;;\n", last_word(one.name), zsh_function_name(one.name));
  }
  return begin + "  local curcontext=$curcontext state line\n  typeset -A opt_args\n  local -a choices=(" +
         zsh_choices(below) + ")\n  _arguments -C" + arguments +
         " \\\n    ':command:->command' '*::argument:->argument'\n  case $state in\n"
         "    command) _describe -t commands command choices ;;\n    argument) case $words[1] in\n" +
         cases + "    esac ;;\n  esac\n}\n\n";
}

}  // namespace

std::string bash_completion(const CommandHelp& program) {
  Lists lists;
  std::string commands, words;
  for (const CommandHelp* command : all_commands(program)) {
    const std::string begin = command->name.empty() ? "" : command->name + " ";
    const auto line = [&](const std::string& place, const OptionHelp& option) {
      if (option.suggestions)
        words += fmt::format("    {}) words=$list{} ;;\n", place, lists.number(option));
      else if (may_be_file(option))
        words += fmt::format("    {}) files=yes ;;\n", place);
    };
    std::vector<std::string> below, options, valued;
    for (const CommandHelp& one : command->commands) below.push_back(last_word(one.name));
    for (const OptionHelp& option : command->options) {
      options.push_back(option.names.back());
      if (!takes_value(option)) continue;
      valued.push_back(option.names.back());
      line(quoted(begin + option.names.back()), option);
    }
    for (std::size_t i = 0; i < command->arguments.size(); ++i)
      line(command->arguments[i].many ? quoted(begin) + "[0-9]*" : quoted(begin + std::to_string(i)),
           command->arguments[i]);
    commands += fmt::format("    {}) commands={} options={} valued={} ;;\n", quoted(begin), quoted(in_a_row(below)),
                            quoted(in_a_row(options)), quoted(in_a_row(valued)));
  }
  std::string variables;
  for (std::size_t i = 0; i < lists.all().size(); ++i) {
    std::vector<std::string> list;
    for (const Suggestion& one : lists.all()[i]) list.push_back(one.word);
    variables += fmt::format("  local list{}={}\n", i, quoted(in_a_row(list)));
  }
  return "# Completion of subcert in bash. Printed by 'subcert completion bash'.\n\n"
         "# What a command has.\n_subcert_command() {\n  case $1 in\n" +
         commands +
         "  esac\n}\n\n# What stands behind an option of a command, or at a place of its arguments.\n"
         "_subcert_words() {\n" +
         variables + "  case $1 in\n" + words + "  esac\n}\n" + bash_body;
}

std::string zsh_completion(const CommandHelp& program) {
  Lists lists;
  std::string functions, words;
  for (const CommandHelp* command : all_commands(program)) functions += zsh_function(*command, lists);
  for (std::size_t i = 0; i < lists.all().size(); ++i)
    words += fmt::format("_subcert_words_{}() {{\n  local -a choices=({})\n  _describe -t words word choices{}\n}}\n\n",
                         i, zsh_choices(lists.all()[i]), are_beginnings(lists.all()[i]) ? " -S ''" : "");
  return "#compdef subcert\n# Completion of subcert in zsh. Printed by 'subcert completion zsh'.\n\n" + words +
         functions + "if [[ $funcstack[1] == _subcert ]]; then _subcert \"$@\"; else compdef _subcert subcert; fi\n";
}

std::string fish_completion(const CommandHelp& program) {
  Lists lists;
  std::string lines;
  std::vector<std::string> names, valued;
  for (const CommandHelp* command : all_commands(program)) {
    const std::string& name = command->name;
    const auto add = [&](const std::string& place, const std::string& what) {
      const std::string condition = fmt::format("__subcert_at {}{}", fish_quoted(name), place);
      lines += fmt::format("complete -c subcert -n {} {}\n", fish_quoted(condition), what);
    };
    const auto words_of = [&](const OptionHelp& option) {
      return fmt::format("-x -a '(__subcert_words_{})'", lists.number(option));
    };
    if (!name.empty()) names.push_back(fish_quoted(name));
    for (const CommandHelp& one : command->commands)
      add(" 0", fmt::format("-a {} -d {}", last_word(one.name), fish_quoted(one.meaning)));
    for (const OptionHelp& option : command->options) {
      const std::string option_name = option.names.back();
      if (takes_value(option)) valued.push_back(fish_quoted(name + " " + option_name));
      add("", fmt::format("{}-l {} {}-d {}", option.names.size() == 2 ? "-s " + option.names[0].substr(1) + " " : "",
                          option_name.substr(2),
                          option.suggestions    ? words_of(option) + " "
                          : may_be_file(option) ? "-r -F "
                          : takes_value(option) ? "-x "
                                                : "",
                          fish_quoted(option.meaning)));
    }
    for (std::size_t i = 0; i < command->arguments.size(); ++i) {
      const OptionHelp& argument = command->arguments[i];
      const std::string place = fmt::format(" {}{}", i, argument.many ? " many" : "");
      if (argument.suggestions)
        add(place, words_of(argument));
      else if (may_be_file(argument))
        add(place, "-F");
    }
  }
  std::string words;
  for (std::size_t i = 0; i < lists.all().size(); ++i) {
    words += fmt::format("function __subcert_words_{}\n  printf '%s\\t%s\\n'", i);
    for (const Suggestion& one : lists.all()[i])
      words += fmt::format(" \\\n    {} {}", fish_quoted(one.word), fish_quoted(one.meaning));
    words += "\nend\n\n";
  }
  return fmt::format(
             R"(# Completion of subcert in fish. Printed by 'subcert completion fish'.

# Whether the cursor is at this command, and at this place of its arguments (and at all later ones with 'many').
function __subcert_at
  set -l commands {}
  set -l valued {}
  set -l command ''
  set -l place 0
  set -l is_value no
  for word in (commandline -opc)[2..-1]
    if test $is_value = yes
      set is_value no
    else if string match -q -- '-*' $word
      contains -- "$command $word" $valued; and set is_value yes
    else if contains -- (string trim -- "$command $word") $commands
      set command (string trim -- "$command $word")
    else
      set place (math $place + 1)
    end
  end
  test "$command" = "$argv[1]"; or return 1
  test (count $argv) = 1; and return 0
  test $place = $argv[2]; or begin
    test "$argv[3]" = many; and test $place -gt $argv[2]
  end
end

)",
             fmt::join(names, " "), fmt::join(valued, " ")) +
         words + "complete -c subcert -f\n" + lines;
}

}  // namespace subcert::cli
