#include "paper_form.hpp"

#include <algorithm>

namespace subcert::cli {
namespace {

constexpr int latex_digits = 14;
constexpr const char* booktabs = "% needs \\usepackage{booktabs}\n";

/// In one line; what follows an equals sign goes on.
std::string in_one_line(const std::string& text) {
  std::string line;
  for (std::size_t i = 0; i < text.size(); ++i)
    line += text[i] != '\n' ? std::string(1, text[i]) : text.substr(i + 1).starts_with('=') ? " " : "; ";
  return line;
}

/// A row for each fact that people read.
formats::TableRows fact_rows(const Facts& list) {
  formats::TableRows rows;
  for (const Fact& fact : list)
    if (!fact.label.empty()) rows.push_back({fact.label, in_one_line(text_with_remark(fact))});
  return rows;
}

}  // namespace

void add_paper_form(Command& command, PaperForm& form, const std::string& latex, const std::string& markdown) {
  if (!latex.empty()) command.flag("--latex", form.latex, latex);
  if (!markdown.empty()) command.flag("--markdown", form.markdown, markdown);
}

void add_fact_forms(Command& command, PaperForm& form) {
  add_paper_form(command, form, "All facts as a table in LaTeX", "All facts as a table in Markdown");
}

void require_one_form(const CommonOptions& options, const PaperForm& form) {
  if (int(options.json) + int(form.latex) + int(form.markdown) > 1)
    fail(ErrorKind::usage, "expected one of --json, --latex and --markdown");
}

void answer(const CommonOptions& options, const PaperForm& form, const FactAnswer& known) {
  if (form.asked_for())
    answer(options, form, TableAnswer{known.formulas, fact_rows(known.facts), {}, "p{0.75\\linewidth}"});
  else
    options.answer(known.json, page_text(known.facts, known.width) + known.more);
}

void answer(const CommonOptions& options, const PaperForm& form, TableAnswer answer) {
  formats::TableRows& rows = answer.rows;
  if (form.markdown) return options.answer(formats::markdown_table(rows));
  const auto is_formula = [&](std::size_t r, std::size_t i) {
    return (i > 0 && rows[r].front() == "symbol") || (r > 0 && std::ranges::count(answer.formulas, i) > 0);
  };
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t i = rows[r].size(); i-- > 0;)  // the label last
      if (std::string& cell = rows[r][i]; !cell.empty())
        cell = is_formula(r, i) ? "$" + formats::latex_formula(cell) + "$" : formats::latex_text(cell);
  options.answer(answer.remark + booktabs + formats::latex_tabular(rows, answer.column));
}

std::string mask_formulas(const Scheme& scheme) {
  std::string text = "% " + scheme.specification + "\n" + formats::mask_latex(scheme.mask) + "\n";
  if (scheme.mask.dimension() == 1) text += formats::symbol_latex(scheme.mask.curve()) + "\n";
  return text;
}

std::string exponent_latex(const Enclosure& exponent, const std::optional<ExponentFormula>& formula) {
  const std::string relation = formats::relation_latex(exponent, latex_digits);
  return relation.empty() ? ""
                          : "\\alpha " + (formula ? "= " + formula->latex() + " " : "") + relation +
                                (formula ? formula->latex_of_zero() : "");
}

ExitCode print_range(const Scheme& scheme, Facts known, bool complete, std::size_t width, const CommonOptions& options,
                     const PaperForm& form) {
  Facts list = named(scheme.specification, scheme.title);
  append(list, std::move(known));
  answer(
      options, form,
      {list, width, page_json(list), complete ? "" : "The enclosures are wider than asked for: the budget ran out.\n"});
  return complete ? done : undecided;
}

}  // namespace subcert::cli
