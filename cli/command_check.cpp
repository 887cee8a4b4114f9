// subcert check FILE...: expected properties of schemes as a gate for continuous integration

#include "command.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/parallel.hpp>
#include <subcert/proofs-checks/properties/properties.hpp>

#include <algorithm>

namespace subcert::cli {
namespace {

struct CheckOptions : CommonOptions {
  std::vector<std::string> files;
  double budget = 20;
};

/// One property of one scheme of one file.
struct Question {
  std::string file;
  const properties::ExpectedScheme* scheme;
  const properties::Expectation* expectation;
};

std::vector<properties::ExpectedScheme> read_expected(const std::string& file) {
  try {
    return properties::read_expectations(read_file(file));
  } catch (const properties::FileError& error) {
    fail(ErrorKind::data, "{}, {}", file, error.what());
  }
}

Json answer_json(const Question& question, const Decision& answer) {
  return {{"file", question.file},
          {"line", question.expectation->place.line},
          {"scheme", question.scheme->specification},
          {"name", question.scheme->name},
          {"property", question.expectation->property},
          {"expected", question.expectation->expected},
          {"holds", to_text(answer.truth)},
          {"found", answer.reason}};
}

std::string answer_line(const Question& question, const Decision& answer) {
  const std::string claim = question.scheme->name + ": " + question.expectation->property + " " +
                            question.expectation->expected;
  const std::string place = question.file + ":" + std::to_string(question.expectation->place.line) + ": ";
  if (answer.is_yes()) return "holds      " + place + claim + "\n";
  return (answer.is_no() ? "FAILS      " : "undecided  ") + place + claim + " (" + answer.reason + ")\n";
}

ExitCode run(const CheckOptions& options) {
  std::vector<std::vector<properties::ExpectedScheme>> files;
  for (const std::string& file : options.files) files.push_back(read_expected(file));
  std::vector<Question> questions;
  for (std::size_t i = 0; i < files.size(); ++i)
    for (const auto& scheme : files[i])
      for (const auto& expectation : scheme.expectations)
        questions.push_back({options.files[i], &scheme, &expectation});
  std::vector<Decision> answers(questions.size());
  parallel_tasks(questions.size(), options.threads(), [&](std::size_t i) {
    answers[i] = has_property(*questions[i].scheme, *questions[i].expectation, options.budget);
  });
  Json json{{"properties", Json::array()}};
  std::string text;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    json["properties"].push_back(answer_json(questions[i], answers[i]));
    text += answer_line(questions[i], answers[i]);
  }
  const auto count = [&](Truth truth) {
    return std::count_if(answers.begin(), answers.end(), [&](const Decision& answer) { return answer.truth == truth; });
  };
  text += "\n" + std::to_string(answers.size()) + (answers.size() == 1 ? " property: " : " properties: ") +
          std::to_string(count(Truth::yes)) + " hold, " + std::to_string(count(Truth::no)) + " fail, " +
          std::to_string(count(Truth::unknown)) + " undecided.\n";
  options.answer(json, text);
  return count(Truth::no) > 0 ? failed : count(Truth::unknown) > 0 ? undecided : done;
}

}  // namespace

void add_check(Command& app) {
  auto options = std::make_shared<CheckOptions>();
  Command command = add_command(app, "check", "Checks expected properties of schemes, given in TOML files",
                                "subcert check my-schemes.toml", options, [=] { return run(*options); });
  command.option("FILE", options->files, "TOML files with schemes and properties").required();
  command.option("--budget", options->budget, "Seconds of processor time for each search")
      .within(0.001, 1e6)
      .with_default();
  std::string known;
  for (const auto& property : properties::known_properties())
    known += "\n  " + property.name + " = " + property.values + "\n      " + property.meaning;
  command.add_to_footer("\n\nProperties:" + known);
}

}  // namespace subcert::cli
