// subcert check FILE...: expected properties of schemes as a gate for continuous integration

#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cli/checker.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/cli/parameter_range.hpp>
#include <subcert/proofs-checks/properties/properties.hpp>
#include <subcert/reports/formats/html.hpp>
#include <subcert/reports/formats/provenance.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <exception>
#include <functional>
#include <iostream>
#include <mutex>
#include <new>
#include <set>
#include <string_view>
#include <variant>

namespace subcert::cli {
namespace {

struct CheckOptions : CommonOptions {
  std::vector<std::string> files;
  std::string junit, sarif;
  std::string certificate;
  double budget = 20;
};

using SchemeOfFile = std::variant<properties::ExpectedScheme, FileError>;

/// One property of one scheme of one file, or a scheme of which nothing can be asked.
struct Question {
  std::string file;
  Place place;
  std::string specification, name, property, expected;
  std::function<Decision(double seconds)> decide;
  bool unreadable = false;
  const Scheme* itself = nullptr;  ///< the vector or Hermite scheme, where the question is about the scheme itself

  std::string claim() const { return unreadable ? "the scheme" : name + ": " + property + " " + expected; }
};

/// Domain: the schemes outlive the questions.
void add_questions(const std::string& file, const std::vector<SchemeOfFile>& schemes,
                   std::vector<Question>& questions) {
  for (const SchemeOfFile& one : schemes) {
    if (const auto* error = std::get_if<FileError>(&one)) {
      const auto raise = [error](double) -> Decision { throw Error(ErrorKind::data, error->message); };
      questions.push_back({file, error->place, "", "", "", "", raise, true});
      continue;
    }
    const auto& scheme = std::get<properties::ExpectedScheme>(one);
    const Scheme* single = std::get_if<Scheme>(&scheme.scheme);
    for (const properties::Expectation& expectation : scheme.expectations) {
      const bool of_itself = expectation.property == "HC" || expectation.property == "convergent";
      questions.push_back({file, expectation.place, scheme.specification, scheme.name, expectation.property,
                           expectation.expected,
                           [&](double seconds) { return has_property(scheme, expectation, seconds); }, false,
                           of_itself && single && single->form ? single : nullptr});
    }
  }
}

std::vector<SchemeOfFile> read_expected(const std::string& file) {
  try {
    return properties::read_schemes(read_input(file));
  } catch (const properties::FileError& error) {
    fail(ErrorKind::data, "{}, {}", input_name(file), error.what());
  }
}

/// The verdict on one question: `error` where it could not be computed, with the message as its reason.
struct Answer {
  Decision decision;
  bool error = false;

  bool is(Truth truth) const { return !error && decision.truth == truth; }
};

/// An error in one question is the answer to that question alone.
Answer answer_to(const Question& question, double seconds) {
  try {
    return {question.decide(seconds)};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return {{Truth::unknown, error.what()}, true};
  }
}

Json answer_json(const Question& question, const Answer& answer) {
  return {{"file", question.file},
          {"line", question.place.line},
          {"scheme", question.specification},
          {"name", question.name},
          {"property", question.property},
          {"expected", question.expected},
          {"holds", answer.error ? "error" : to_text(answer.decision.truth)},
          {"found", answer.decision.reason}};
}

std::string answer_line(const Question& question, const Answer& answer) {
  const std::string claim = question.claim();
  const std::string column = question.unreadable ? ":" + std::to_string(question.place.column) : "";
  const std::string place = question.file + ":" + std::to_string(question.place.line) + column + ": ";
  if (answer.is(Truth::yes)) return "holds      " + place + claim + "\n";
  const std::string verdict = answer.error ? "error      " : answer.is(Truth::no) ? "FAILS      " : "undecided  ";
  return verdict + place + claim + " (" + visible(answer.decision.reason) + ")\n";
}

/// Prints the lines of answers in the order of the questions, each as soon as those before it are there. Safe to use
/// from several threads.
class Lines {
 public:
  Lines(const std::vector<Question>& questions, const std::vector<Answer>& answers)
      : questions_(questions), answers_(answers), known_(questions.size(), false) {}

  void finish(std::size_t i) {
    const std::scoped_lock lock(mutex_);
    known_[i] = true;
    const std::size_t before = printed_;
    for (; printed_ < known_.size() && known_[printed_]; ++printed_)
      std::cout << answer_line(questions_[printed_], answers_[printed_]);
    if (printed_ > before) require_output_written();
  }

 private:
  const std::vector<Question>& questions_;
  const std::vector<Answer>& answers_;
  std::mutex mutex_;
  std::vector<bool> known_;
  std::size_t printed_ = 0;
};

/// The report of JUnit, which servers of continuous integration show: a test for each question.
std::string junit_text(const std::vector<Question>& questions, const std::vector<Answer>& answers) {
  using formats::html;
  std::string tests;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const std::string file = html(visible(questions[i].file)), reason = html(visible(answers[i].decision.reason));
    tests += fmt::format("  <testcase classname=\"{0}\" name=\"{1}\" file=\"{0}\" line=\"{2}\"", file,
                         html(visible(questions[i].claim())), questions[i].place.line);
    tests += answers[i].is(Truth::yes)  ? "/>\n"
             : answers[i].is(Truth::no) ? fmt::format("><failure message=\"{}\"/></testcase>\n", reason)
                                        : fmt::format("><error message=\"{}{}\"/></testcase>\n",
                                                      answers[i].error ? "" : "undecided: ", reason);
  }
  const auto failures = std::ranges::count_if(answers, [](const Answer& answer) { return answer.is(Truth::no); });
  const auto right = std::ranges::count_if(answers, [](const Answer& answer) { return answer.is(Truth::yes); });
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"subcert check\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n{}</testsuite>\n",
      answers.size(), failures, static_cast<long>(answers.size()) - failures - right, tests);
}

/// As a reference of a file in a report: what is no letter, digit or one of -._~/ by its bytes.
std::string uri(const std::string& file) {
  std::string result = file.starts_with('/') ? "file://" : "";
  for (const char c : file) {
    const auto byte = static_cast<unsigned char>(c);
    result += byte < 0x80 && (std::isalnum(byte) || std::string_view("-._~/").find(c) != std::string_view::npos)
                  ? std::string(1, c)
                  : fmt::format("%{:02X}", byte);
  }
  return result;
}

/// The report in SARIF 2.1.0, which servers show at the lines of the file: what does not hold, each with its property.
std::string sarif_text(const std::vector<Question>& questions, const std::vector<Answer>& answers) {
  Json rules = Json::array(), results = Json::array();
  for (const auto& property : properties::known_properties())
    rules.push_back({{"id", property.name}, {"shortDescription", {{"text", property.meaning}}}});
  rules.push_back({{"id", "scheme"}, {"shortDescription", {{"text", "can be read, with its properties"}}}});
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const Question& question = questions[i];
    const Answer& answer = answers[i];
    if (answer.is(Truth::yes)) continue;
    const bool open = !answer.error && !answer.is(Truth::no);
    const Json region{{"startLine", question.place.line}, {"startColumn", std::max(1U, question.place.column)}};
    results.push_back(
        {{"ruleId", question.unreadable ? "scheme" : question.property},
         {"kind", open ? "open" : "fail"},
         {"level", open ? "none" : "error"},
         {"message",
          {{"text", visible(question.claim() + (open ? " is undecided: " : ": ") + answer.decision.reason)}}},
         {"locations",
          {{{"physicalLocation", {{"artifactLocation", {{"uri", uri(question.file)}}}, {"region", region}}}}}}});
  }
  const Json driver{{"name", "subcert"}, {"version", formats::version()}, {"rules", std::move(rules)}};
  return Json{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
              {"version", "2.1.0"},
              {"runs", {{{"tool", {{"driver", driver}}}, {"results", std::move(results)}}}}}
             .dump(1) +
         "\n";
}

/// `\n3 properties: 2 hold, 0 fail, 1 undecided.`
std::string counts_text(const std::vector<Answer>& answers) {
  const auto count = [&](Truth truth) {
    return std::to_string(std::ranges::count_if(answers, [=](const Answer& answer) { return answer.is(truth); }));
  };
  const auto errors = std::ranges::count_if(answers, &Answer::error);
  return "\n" + std::to_string(answers.size()) + (answers.size() == 1 ? " property: " : " properties: ") +
         count(Truth::yes) + " hold, " + count(Truth::no) + " fail, " + count(Truth::unknown) + " undecided" +
         (errors == 0 ? "" : ", " + std::to_string(errors) + (errors == 1 ? " error" : " errors")) + ".\n";
}

/// Of each vector or Hermite scheme of which a question about the scheme itself is answered, one that says what is
/// proved of it.
WrittenCertificates write_certificates_of_schemes(const std::vector<Question>& questions,
                                                  const std::vector<Answer>& answers, const CheckOptions& options,
                                                  Json& json) {
  if (options.certificate.empty()) return {};
  std::vector<NamedCertificate> certificates;
  std::set<const Scheme*> seen;
  std::string missing;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const Scheme* scheme = questions[i].itself;
    if (!scheme || (!answers[i].is(Truth::yes) && !answers[i].is(Truth::no)) || !seen.insert(scheme).second) continue;
    try {
      certificates.push_back({fmt::format("{:05}-scheme", certificates.size() + 1),
                              scheme_certificate(*scheme, {Deadline::in(options.budget)})});
    } catch (const Error& error) {
      missing += fmt::format("no certificate of {}: {}\n", questions[i].name, reason_text(error));
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
  std::vector<Answer> answers(questions.size());
  const bool at_once = !options.json && (options.out.empty() || options.out == standard_stream);
  Lines lines(questions, answers);
  parallel_tasks(questions.size(), options.threads(), [&](std::size_t i) {
    answers[i] = answer_to(questions[i], options.budget);
    if (at_once) lines.finish(i);
  });
  Json json{{"properties", Json::array()}};
  std::string text;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    json["properties"].push_back(answer_json(questions[i], answers[i]));
    if (!at_once) text += answer_line(questions[i], answers[i]);
  }
  if (!options.junit.empty()) runtime::write_file(options.junit, junit_text(questions, answers));
  if (!options.sarif.empty()) runtime::write_file(options.sarif, sarif_text(questions, answers));
  const WrittenCertificates written = write_certificates_of_schemes(questions, answers, options, json);
  options.answer(json, text + counts_text(answers) + written.text);
  written.failure.raise();
  if (std::ranges::any_of(answers, [](const Answer& answer) { return answer.is(Truth::no); })) return failed;
  if (std::ranges::any_of(questions, &Question::unreadable)) return bad_data;
  return std::ranges::all_of(answers, [](const Answer& answer) { return answer.is(Truth::yes); }) ? done : undecided;
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
  command.option("--budget", options->budget, "Seconds of processor time for each search")
      .within(0.001, 1e6)
      .with_default();
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
