// subcert check FILE...: expected properties of schemes as a gate for continuous integration

#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/cli/checker.hpp>
#include <subcert/cli/pages/check_reports.hpp>
#include <subcert/cli/parameter_range.hpp>
#include <subcert/cli/sweep_arguments.hpp>
#include <subcert/proofs-checks/properties/properties.hpp>
#include <subcert/proofs-checks/sweeps/question.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <map>
#include <new>
#include <set>
#include <variant>

namespace subcert::cli {
namespace {

struct CheckOptions : CommonOptions, SweepArguments, WorkerArguments {
  std::vector<std::string> files;
  std::string junit, sarif;
  std::string certificate;
  sweeps::AnswerLimits limits{.budget = 20, .memory = 1024};
  bool in_process = false;

  /// Whether lines are printed as soon as those before them are there.
  bool at_once() const { return !json && (out.empty() || out == standard_stream); }
};

using SchemeOfFile = std::variant<properties::ExpectedScheme, FileError>;

/// An expected property; of a scheme that cannot be read, nothing that could be asked.
struct Question {
  CheckedProperty answer;
  const properties::ExpectedScheme* scheme = nullptr;
  const properties::Expectation* expectation = nullptr;
  std::size_t number = 0;  ///< of the case that answers

  /// A file that asks this alone.
  std::string text() const { return scheme->lines + expectation->line; }
  /// The vector or Hermite scheme, where the question is about the scheme itself, or null.
  const Scheme* itself() const {
    const Scheme* single = scheme ? std::get_if<Scheme>(&scheme->scheme) : nullptr;
    const bool of_itself = answer.property == "HC" || answer.property == "convergent";
    return of_itself && single && single->form ? single : nullptr;
  }
};

/// Domain: the schemes outlive the questions.
void add_questions(const std::string& file, const std::vector<SchemeOfFile>& schemes,
                   std::vector<Question>& questions) {
  for (const SchemeOfFile& one : schemes) {
    if (const auto* error = std::get_if<FileError>(&one)) {
      questions.push_back({{file, error->place, "", "", "", "", true, {Truth::unknown, error->message}, true}});
      continue;
    }
    const auto& scheme = std::get<properties::ExpectedScheme>(one);
    for (const properties::Expectation& expectation : scheme.expectations)
      questions.push_back({{file,
                            expectation.place,
                            scheme.specification,
                            scheme.name,
                            expectation.property,
                            expectation.expected,
                            false,
                            {},
                            false},
                           &scheme,
                           &expectation});
  }
}

std::vector<SchemeOfFile> read_expected(const std::string& file) {
  try {
    return properties::read_schemes(read_input(file));
  } catch (const properties::FileError& error) {
    fail(ErrorKind::data, "{}, {}", input_name(file), error.what());
  }
}

/// An error in one question is the answer to that question alone.
void answer_here(Question& question, const sweeps::AnswerLimits& limits) {
  CheckedProperty& answer = question.answer;
  if (answer.unreadable) return;
  try {
    answer.decision = has_property(*question.scheme, *question.expectation, {limits.budget, limits.memory << 20});
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    answer.decision = {Truth::unknown, error.what()};
    answer.error = true;
  }
}

/// What a process says of a file with one question; a crash is an error of it.
Json answer_of_process(const std::string& text, const sweeps::AnswerLimits& limits, const std::string& program) {
  const sweeps::Reply reply = sweeps::reply_to(check_arguments(limits), {text, sweeps::most_seconds(limits.budget)},
                                               program);
  if (reply.answer.is_null()) return {{"holds", "error"}, {"found", reply.error}};
  const Json& one = reply.answer.at("properties").at(0);
  return {{"holds", one.at("holds")}, {"found", one.at("found")}};
}

void take(const Json& found, CheckedProperty& answer) {
  const auto holds = found.is_null() ? "error" : found.at("holds").get<std::string>();
  answer.error = holds == "error";
  answer.decision = {holds == "yes"  ? Truth::yes
                     : holds == "no" ? Truth::no
                                     : Truth::unknown,
                     found.is_null() ? "not computed" : found.at("found").get<std::string>()};
}

/// The texts of the cases: one for the same questions, which get its number.
std::vector<std::string> cases_of(std::vector<Question>& questions) {
  std::vector<std::string> texts;
  std::map<std::string, std::size_t> numbers;
  for (Question& one : questions) {
    if (one.answer.unreadable) continue;
    const auto [at, is_new] = numbers.try_emplace(one.text(), texts.size());
    one.number = at->second;
    if (is_new) texts.push_back(at->first);
  }
  return texts;
}

/// A sweep, each case in a process of its own. Of a shard, the questions of other cases are left out. False on ranks
/// that only work.
bool answer_by_processes(std::vector<Question>& questions, const CheckOptions& options) {
  const std::vector<std::string> texts = cases_of(questions);
  std::vector<sweeps::SweepCase> cases;
  for (const std::string& text : texts)
    cases.push_back(
        {fmt::format("check budget {} memory {} of {}", options.limits.budget, options.limits.memory, text)});
  sweeps::SweepOptions sweep = sweep_options(options, options, "check");
  std::erase_if(questions, [&](const Question& one) {
    return one.answer.unreadable ? sweep.shard.number > 1 : !sweep.shard.contains(one.number);
  });
  std::vector<Json> found(cases.size());
  std::size_t known = 0;
  // Those before the first of a case that is not known.
  const auto take_until = [&](std::size_t number) {
    for (; known < questions.size() && (questions[known].answer.unreadable || questions[known].number < number);
         ++known) {
      CheckedProperty& answer = questions[known].answer;
      if (!answer.unreadable) take(found[questions[known].number], answer);
      if (!options.at_once()) continue;
      std::cout << property_line(answer);
      require_output_written();
    }
  };
  if (options.at_once()) sweep.progress = {};
  sweep.in_order = [&](std::size_t i, const Json& answer) {
    found[i] = answer;
    take_until(i + 1);
  };
  const std::string program = options.answering_program();
  const bool is_first = run_sweep(
                            cases, [&](std::size_t i) { return answer_of_process(texts[i], options.limits, program); },
                            sweep)
                            .has_value();
  options.end_progress();
  if (is_first) take_until(cases.size());
  return is_first;
}

/// Of each vector or Hermite scheme of which a question about the scheme itself is answered, one that says what is
/// proved of it.
WrittenCertificates write_certificates_of_schemes(const std::vector<Question>& questions, const CheckOptions& options,
                                                  Json& json) {
  if (options.certificate.empty()) return {};
  std::vector<NamedCertificate> certificates;
  std::set<const Scheme*> seen;
  std::string missing;
  for (const Question& one : questions) {
    const Scheme* scheme = one.itself();
    if (!scheme || (!one.answer.is(Truth::yes) && !one.answer.is(Truth::no)) || !seen.insert(scheme).second) continue;
    try {
      certificates.push_back({fmt::format("{:05}-scheme", certificates.size() + 1),
                              scheme_certificate(*scheme, {Deadline::in(options.limits.budget)})});
    } catch (const Error& error) {
      missing += fmt::format("no certificate of {}: {}\n", one.answer.name, reason_text(error));
    }
  }
  WrittenCertificates written = write_certificates(
      options.certificate, certificates, {"-scheme"},
      "other questions than HC and convergent of vector and Hermite schemes", json);
  written.text = missing + written.text;
  return written;
}

ExitCode run(const CheckOptions& options) {
  if (!options.certificate.empty()) require_folder(options.certificate);
  std::vector<std::vector<SchemeOfFile>> files;
  for (const std::string& file : options.files) files.push_back(read_expected(file));
  std::vector<Question> questions;
  for (std::size_t i = 0; i < files.size(); ++i) add_questions(input_name(options.files[i]), files[i], questions);
  if (options.in_process)
    parallel_tasks(questions.size(), options.threads(),
                   [&](std::size_t i) { answer_here(questions[i], options.limits); });
  else if (!answer_by_processes(questions, options))
    return done;  // the first rank prints
  std::vector<CheckedProperty> answers;
  for (const Question& one : questions) answers.push_back(one.answer);
  Json json{{"properties", Json::array()}};
  std::string text;
  for (const CheckedProperty& one : answers) {
    json["properties"].push_back(property_json(one));
    if (options.in_process || !options.at_once()) text += property_line(one);
  }
  if (!options.junit.empty()) runtime::write_file(options.junit, junit_text(answers));
  if (!options.sarif.empty()) runtime::write_file(options.sarif, sarif_text(answers));
  const WrittenCertificates written = write_certificates_of_schemes(questions, options, json);
  options.answer(json, text + counts_text(answers) + written.text);
  written.failure.raise();
  const auto is_one = [&](Truth truth) { return [=](const CheckedProperty& one) { return one.is(truth); }; };
  if (std::ranges::any_of(answers, is_one(Truth::no))) return failed;
  if (std::ranges::any_of(answers, &CheckedProperty::unreadable)) return bad_data;
  return std::ranges::all_of(answers, is_one(Truth::yes)) ? done : undecided;
}

}  // namespace

void add_check(Command& app) {
  auto options = std::make_shared<CheckOptions>();
  Command command = add_command(app, "check", "Checks expected properties of schemes, given in TOML files",
                                "subcert check my-schemes.toml", options, [=] { return run(*options); });
  command.option("FILE", options->files, "TOML files with schemes and properties; - is standard input").required();
  command.option("--junit", options->junit, "Write the answers there, too, as a report of JUnit");
  command.option("--sarif", options->sarif, "Write what does not hold there, too, as a report in SARIF");
  command.option("--certificate", options->certificate,
                 "Write certificates of what is proved of vector and Hermite schemes themselves into this folder");
  command.option("--budget", options->limits.budget, "Seconds of processor time for each search")
      .within(0.001, 1e6)
      .with_default();
  command.option("--memory", options->limits.memory, "MiB that each search may hold")
      .within(16, 1 << 20)
      .with_default();
  command.flag("--in-process", options->in_process,
               "No process for each question: faster for many easy ones, but a crash ends all");
  add_sweep_arguments(command, *options);
  add_worker(command, *options);
  std::string known;
  for (const auto& property : properties::known_properties())
    known += "\n  " + property.name + " = " + property.values + "\n      " + property.meaning;
  command.add_to_footer(
      "\n\nExample file:\n  [[scheme]]\n  name = \"the slider\"\n  mask = \"four-point:w\"\n"
      "  for = \"0.01 <= w <= 0.19\"\n  smoothness = \">= 1\""
      "\n\nProperties:" +
      known);
}

}  // namespace subcert::cli
