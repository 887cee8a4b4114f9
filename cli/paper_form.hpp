#pragma once
// Answers in the forms that papers and pages have.

#include "command.hpp"

#include <subcert/reports/formats/paper_text.hpp>

#include <string>

namespace subcert::cli {

struct PaperForm {
  bool latex = false;
  bool markdown = false;
};

/// --latex and --markdown, where these say what they print. Errors of a command line with both, or with --json: a usage
/// error, by require_one_form().
void add_paper_form(Command& command, PaperForm& form, const std::string& latex, const std::string& markdown = {});
void require_one_form(const CommonOptions& options, const PaperForm& form);

/// A row for each fact that people read.
formats::TableRows fact_rows(const Facts& list);

}  // namespace subcert::cli
