// subcert sweep SCHEMES...: what other commands answer, for many schemes

#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cli/pages/sweep_lines.hpp>
#include <subcert/cli/parameter_range.hpp>
#include <subcert/cli/sweep_arguments.hpp>
#include <subcert/proofs-checks/sweeps/growth.hpp>
#include <subcert/proofs-checks/sweeps/sweep_plan.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>

namespace subcert::cli {
namespace {

struct SweepCommandOptions : CommonOptions, SweepArguments, WorkerArguments {
  std::vector<std::string> schemes;
  std::vector<std::string> columns;
  std::string ask, where, expect;
  std::optional<double> budget;
  std::optional<int> memory;
  bool in_order = false;
  std::string certificates, fit;
};

constexpr std::size_t most_counterexamples = 5;

/// The plan that is given, options over what its file says.
sweeps::SweepPlan plan_of(const SweepCommandOptions& options) {
  sweeps::SweepPlan plan = plan_of_texts(options.schemes, "sweep");
  if (!options.ask.empty()) plan.ask = sweeps::SchemeQuestion::split(options.ask);
  if (!options.columns.empty()) plan.columns = options.columns;
  if (!options.where.empty()) plan.where = options.where;
  if (!options.expect.empty()) plan.expect = options.expect;
  if (options.budget) plan.budget = *options.budget;
  if (options.memory) plan.memory = static_cast<std::size_t>(*options.memory);
  if (std::ranges::count(plan.columns, "") > 0) fail(ErrorKind::usage, "sweep: need a name for each column, got none");
  return plan;
}

/// Names that no answer has: they may be mistaken.
class UnknownNames {
 public:
  explicit UnknownNames(std::vector<std::string> names) : names_(std::move(names)) {
    std::ranges::sort(names_);
    names_.erase(std::ranges::unique(names_).begin(), names_.end());
  }

  void see(const Json& answers) {
    if (!names_.empty() && !answers.at("answers").empty()) has_answer_ = true;
    std::erase_if(names_, [&](const std::string& name) { return sweeps::value_of(answers, name) != nullptr; });
    if (names_.empty() || !members_.empty()) return;
    for (const Json& answer : answers.at("answers"))
      for (const auto& [member, value] : answer.items()) members_.push_back(member);
  }

  void tell(const CommonOptions& options) const {
    for (const std::string& name : names_)
      if (has_answer_) options.remark(fmt::format("no answer has {}{}", in_quotes(name), did_you_mean(name, members_)));
  }

 private:
  std::vector<std::string> names_, members_;
  bool has_answer_ = false;
};

/// What came of the schemes.
class Tally {
 public:
  explicit Tally(const std::string& expect) {
    if (!expect.empty()) expect_ = sweeps::Condition::parse("--expect", expect);
  }

  /// What is expected something of.
  std::vector<std::string> names() const { return expect_ ? expect_->names() : std::vector<std::string>(); }

  /// The answers with what became of the expectation, where there is one.
  Json judged(Json answers) const {
    if (expect_) answers["expected"] = to_text(verdict_on(answers));
    return answers;
  }

  void add(const Json& answers) {
    ++schemes_;
    const bool has_error = !answers.at("errors").empty();
    if (has_error && errors_++ == 0)
      first_error_ = answers.at("scheme").get<std::string>() + ": " +
                     answers.at("errors").begin().value().get<std::string>();
    if (!expect_) return;
    const Truth found = verdict_on(answers);
    if (found == Truth::yes) ++held_;
    if (found != Truth::no) return;
    ++failed_;
    if (counterexamples_.size() < most_counterexamples)
      counterexamples_.push_back(answers.at("scheme").get<std::string>());
  }

  std::string text() const {
    std::string result = counted(schemes_, "scheme");
    if (errors_ > 0) result += fmt::format(", {} with errors, the first: {}", errors_, first_error_);
    if (!expect_) return result;
    result += fmt::format("; as expected {}, not {}, open {}", held_, failed_, schemes_ - held_ - failed_);
    if (failed_ > 0) result += fmt::format("; the first that are not: {}", fmt::join(counterexamples_, "  "));
    return result;
  }

  const std::vector<std::string>& counterexamples() const { return counterexamples_; }

  ExitCode code() const {
    if (failed_ > 0) return failed;
    return errors_ > 0 || (expect_ && held_ < schemes_) ? undecided : done;
  }

 private:
  /// Domain: something is expected.
  Truth verdict_on(const Json& answers) const { return sweeps::meets(answers, *expect_); }

  std::optional<sweeps::Condition> expect_;
  std::size_t schemes_ = 0, errors_ = 0, held_ = 0, failed_ = 0;
  std::string first_error_;
  std::vector<std::string> counterexamples_;
};

/// Writes a certificate of the exponent of each scheme, made and verified by the program; says which there are.
void write_certificates(const SweepCommandOptions& options, const sweeps::SweepPlan& plan, const std::string& program,
                        const std::vector<std::string>& schemes) {
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    const std::string file = fmt::format("{}/{}.cert", options.certificates, k + 1);
    const auto certificate = sweeps::certificate_of(plan, schemes[k], program);
    if (certificate) runtime::write_file(file, *certificate);
    options.remark(certificate ? fmt::format("{}: certificate {}, verified", schemes[k], file)
                               : schemes[k] + ": no certificate");
  }
}

/// What is found by least squares; nothing of it is proved.
void tell_growths(const SweepCommandOptions& options, const sweeps::Growths& growths) {
  const auto found = growths.result();
  if (found.empty()) options.remark("fit of " + options.fit + ": there are not three positive values of a family");
  for (const sweeps::Growth& one : found)
    options.remark(
        fmt::format("fit of {}, {}: {:.4g} * {}^{:.4g} for {} values from {} to {}, off by at most {:.2g} %; "
                    "power {:.4g} between the last two",
                    options.fit, one.schemes, one.factor, growths.question().key, one.power, one.count,
                    to_text(one.first), to_text(one.last), 100 * one.deviation, one.last_power));
}

std::vector<Suggestion> question_suggestions() {
  std::vector<Suggestion> result;
  for (const std::string& name : sweeps::SchemeQuestion::commands()) result.push_back({name, ""});
  return result;
}

ExitCode run(const SweepCommandOptions& options) {
  const sweeps::SweepPlan plan = plan_of(options);
  const std::vector<std::string> schemes = schemes_of_plan(plan);
  if (schemes.empty())
    fail(ErrorKind::usage, "sweep: no scheme is left; expected schemes{}",
         plan.where.empty() ? "" : " for which " + plan.where);
  if (!options.certificates.empty()) require_folder(options.certificates, "--certificates");
  std::vector<sweeps::SweepCase> cases;
  for (const std::string& scheme : schemes) cases.push_back(case_of(plan, scheme));
  const std::string program = options.answering_program();
  std::vector<std::string> columns = plan.columns.empty() ? usual_columns(plan.ask) : plan.columns;
  if (plan.columns.empty() && !plan.expect.empty()) columns.emplace_back("expected");
  const SweepLines lines(options.json, columns);
  Tally tally(plan.expect);
  std::vector<std::string> named = tally.names();
  named.insert(named.end(), plan.columns.begin(), plan.columns.end());
  std::erase(named, "expected");
  UnknownNames unknown(named);
  std::optional<sweeps::Growths> growths;
  if (!options.fit.empty()) growths.emplace(sweeps::GrowthQuestion::parse(options.fit));
  const bool on_screen = options.out.empty() || options.out == standard_stream;
  sweeps::SweepOptions sweep = sweep_options(options, options, "sweep");
  bool has_head = false;
  const auto print = [&](const std::string& text) {
    if (!has_head) std::cout << lines.head();
    has_head = true;
    std::cout << text;
    require_output_written();
  };
  const bool as_they_come = on_screen && !options.in_order;
  if (as_they_come)
    sweep.finished = [&](std::size_t, const Json& answers) { print(lines.line(tally.judged(answers))); };
  std::string text = lines.head();  // of a file
  sweep.in_order = [&](std::size_t, const Json& answers) {
    tally.add(answers);
    unknown.see(answers);
    if (growths) growths->add(answers);
    if (as_they_come) return;
    const std::string line = lines.line(tally.judged(answers));
    if (on_screen) return print(line);
    text += line;
  };
  const auto results = run_sweep(
      cases, [&](std::size_t i) { return answers_of_scheme(plan, schemes[i], program); }, sweep);
  if (!results) return done;  // the first rank prints
  options.end_progress();
  if (!on_screen) options.answer(text);
  if (on_screen && !has_head) print("");
  options.remark(tally.text());
  unknown.tell(options);
  if (growths) tell_growths(options, *growths);
  if (!options.certificates.empty()) write_certificates(options, plan, program, tally.counterexamples());
  return tally.code();
}

}  // namespace

void add_sweep(Command& app) {
  auto options = std::make_shared<SweepCommandOptions>();
  Command command = add_command(app, "sweep", "What other commands answer, for many schemes, in processes of their own",
                                "subcert sweep 'primal:n=1..20,d={1,3}' --expect 'holder > 1.5'", options,
                                [=] { return run(*options); });
  add_schemes_of_sweep(command, options->schemes);
  command
      .option(
          "--ask", options->ask,
          fmt::format("Questions separated by commas; regularity if none. A question is one of the commands {}, with "
                      "settings that change its answer, as 'vertex --valence 3..50' or 'check smoothness >= 1'",
                      fmt::join(sweeps::SchemeQuestion::commands(), ", ")))
      .suggest(question_suggestions);
  command.option("--where", options->where, "Only schemes whose keys meet this, as 'n >= 4 and d == 1'");
  command.option("--expect", options->expect, "What the answers should meet, as 'holder > 1.9 and converges == yes'");
  command.option("--fit", options->fit,
                 "How a number grows with a key, by least squares, as 'mean by n' or '2 - holder by n'");
  command.option("--columns", options->columns, "Columns of the table, by the names of --json").separated_by_commas();
  command.flag("--in-order", options->in_order, "Lines in the order of the schemes, not as they come");
  command.option("--budget", options->budget, "Seconds of processor time for each answer; 10 if none")
      .within(0.001, 1e6);
  command.option("--memory", options->memory, "MiB that a search of one answer may hold; 512 if none")
      .within(16, 1'000'000);
  command.option("--certificates", options->certificates,
                 "A folder for certificates of the first schemes that are not as expected");
  add_sweep_arguments(command, *options);
  add_worker(command, *options);
}

}  // namespace subcert::cli
