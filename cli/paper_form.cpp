#include "paper_form.hpp"

namespace subcert::cli {

void add_paper_form(Command& command, PaperForm& form, const std::string& latex, const std::string& markdown) {
  if (!latex.empty()) command.flag("--latex", form.latex, latex);
  if (!markdown.empty()) command.flag("--markdown", form.markdown, markdown);
}

void require_one_form(const CommonOptions& options, const PaperForm& form) {
  if (int(options.json) + int(form.latex) + int(form.markdown) > 1)
    fail(ErrorKind::usage, "expected one of --json, --latex and --markdown");
}

formats::TableRows fact_rows(const Facts& list) {
  formats::TableRows rows;
  for (const Fact& fact : list)
    if (!fact.label.empty()) rows.push_back({fact.label, text_with_remark(fact)});
  return rows;
}

}  // namespace subcert::cli
