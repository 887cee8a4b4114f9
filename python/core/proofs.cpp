#include "work.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/certificates/checker_client.hpp>
#include <subcert/proofs-checks/certificates/claim.hpp>
#include <subcert/proofs-checks/properties/properties.hpp>
#include <subcert/reports/facts/statement_facts.hpp>
#include <subcert/reports/report.hpp>
#include <subcert/reports/report_files.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace subcert::python {
namespace {

/// JSON, as the command line has it.
std::string check_statements(const std::vector<std::string>& wanted, bool wide, int jobs, const py::object& progress) {
  const auto chosen = statements::select_statements(wanted);
  return interruptible(progress, [&] {
    return facts::statements_json(
               check_statements(chosen, wide ? statements::Tier::wide : statements::Tier::quick, jobs, {}))
        .dump();
  });
}

py::list check_properties(const std::string& text, double seconds, int jobs, const py::object& progress) {
  const auto schemes = properties::read_expectations(text);
  std::vector<std::pair<const properties::ExpectedScheme*, const properties::Expectation*>> questions;
  for (const auto& scheme : schemes)
    for (const auto& expectation : scheme.expectations) questions.emplace_back(&scheme, &expectation);
  const auto answers = interruptible(progress, [&] {
    std::vector<Decision> decisions(questions.size());
    parallel_tasks(questions.size(), jobs, [&](std::size_t i) {
      decisions[i] = has_property(*questions[i].first, *questions[i].second, {seconds});
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
  return interruptible(progress, [&] { return reports::reports_json({reports::make_report(paper, options)}).dump(); });
}

}  // namespace

void add_proofs(py::module_& module) {
  const auto pair = [](const CheckerAnswer& answer) { return std::pair(answer.code == 0, answer.text); };
  module.def("check_file", [=](const std::string& text, const std::string& file, const std::string& program) {
    return pair(run_checker(checker_arguments(read_claim(text, file), file), program));
  });
  module.def("check_certificate",
             [=](const std::string& text, const std::string& matrices, const std::string& program) {
               return pair(check_certificate(read_claim(text, "certificate"), text, matrices, program));
             });
  module.def("statements", [](const std::vector<std::string>& wanted) {
    return facts::statements_json(statements::select_statements(wanted)).dump();
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
