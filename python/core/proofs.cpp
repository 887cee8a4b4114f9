#include "work.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/proofs-checks/certificates/checker_arguments.hpp>
#include <subcert/proofs-checks/properties/properties.hpp>
#include <subcert/reports/errata.hpp>
#include <subcert/reports/report_files.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace subcert::python {
namespace {

py::dict statement_dict(const statements::Statement& statement) {
  return py::dict("id"_a = statement.id, "place"_a = statement.place, "paraphrase"_a = statement.paraphrase,
                  "checked"_a = statement.checked, "printed"_a = printed_latex(statement),
                  "recorded"_a = to_text(statement.recorded));
}

std::vector<const statements::Statement*> find(const std::vector<std::string>& wanted) {
  std::vector<const statements::Statement*> result;
  for (const std::string& one : wanted) {
    const auto found = statements::find_statements(one);
    result.insert(result.end(), found.begin(), found.end());
  }
  if (wanted.empty())
    for (const statements::Statement& statement : statements::statements()) result.push_back(&statement);
  return result;
}

py::list check_statements(const std::vector<std::string>& wanted, bool wide, int jobs, const py::object& progress) {
  const auto chosen = find(wanted);
  const auto checked = interruptible(progress, [&] {
    return reports::check_statements(chosen, wide ? statements::Tier::wide : statements::Tier::quick, jobs,
                                     [](const std::string&) {});
  });
  py::list result;
  for (const reports::CheckedStatement& one : checked) {
    py::dict answer = statement_dict(*one.statement);
    answer["verdict"] = to_text(one.outcome.verdict);
    const auto grade = statements::grade_of(*one.statement, one.outcome);
    answer["grade"] = grade ? to_text(*grade) : "";
    answer["edge"] = one.outcome.edge;
    answer["sentence"] = one.statement->sentence;
    answer["readings"] = one.statement->readings;
    answer["follows"] = one.statement->follows;
    answer["scan"] = one.statement->scan;
    answer["range"] = one.outcome.range;
    answer["witness"] = one.outcome.witness;
    answer["argument"] = one.outcome.argument;
    answer["corrected"] = corrected_latex(*one.statement);
    result.append(answer);
  }
  return result;
}

py::list check_properties(const std::string& text, double seconds, int jobs, const py::object& progress) {
  const auto schemes = properties::read_expectations(text);
  std::vector<std::pair<const properties::ExpectedScheme*, const properties::Expectation*>> questions;
  for (const auto& scheme : schemes)
    for (const auto& expectation : scheme.expectations) questions.emplace_back(&scheme, &expectation);
  const auto answers = interruptible(progress, [&] {
    std::vector<Decision> decisions(questions.size());
    parallel_tasks(questions.size(), jobs, [&](std::size_t i) {
      decisions[i] = has_property(*questions[i].first, *questions[i].second, seconds);
    });
    return decisions;
  });
  py::list result;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const auto& [scheme, expectation] = questions[i];
    result.append(py::dict("line"_a = expectation->place.line, "scheme"_a = scheme->specification,
                           "name"_a = scheme->name, "property"_a = expectation->property,
                           "expected"_a = expectation->expected, "answer"_a = answers[i]));
  }
  return result;
}

/// The JSON of the contract.
std::string reproduce(const std::string& paper, const std::vector<std::string>& only, int jobs,
                      const py::object& progress) {
  const auto known = reports::reproducible_papers();
  if (std::find(known.begin(), known.end(), paper) == known.end())
    fail(ErrorKind::usage, "reproduce: paper '{}' is not known; expected one of subcert.papers()", paper);
  const auto items = reports::report_items(paper);
  for (const std::string& item : only)
    if (std::find(items.begin(), items.end(), item) == items.end())
      fail(ErrorKind::usage, "reproduce: item '{}' is not one of {}; expected {}", item, paper, fmt::join(items, ", "));
  reports::ReportOptions options;
  options.only = only;
  options.jobs = jobs;
  return interruptible(progress, [&] { return reports::reports_json({reports::make_report(paper, options)}); });
}

}  // namespace

void add_proofs(py::module_& module) {
  module.def("checker_arguments", &checker_arguments);
  module.def("statements", [](const std::vector<std::string>& wanted) {
    py::list result;
    for (const statements::Statement* statement : find(wanted)) result.append(statement_dict(*statement));
    return result;
  });
  module.def("check_statements", &check_statements);
  module.def("check_properties", &check_properties);
  module.def("papers", [] {
    std::map<std::string, std::vector<std::string>> result;
    for (const std::string& paper : reports::reproducible_papers()) result[paper] = reports::report_items(paper);
    return result;
  });
  module.def("reproduce", &reproduce);
}

}  // namespace subcert::python
