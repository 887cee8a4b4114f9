#pragma once
// Answers in the forms that papers and pages have.

#include "command.hpp"

#include <subcert/reports/facts/regularity_facts.hpp>
#include <subcert/reports/formats/paper_text.hpp>

#include <optional>
#include <string>
#include <vector>

namespace subcert::cli {

struct PaperForm {
  bool latex = false;
  bool markdown = false;

  bool asked_for() const { return latex || markdown; }
};

/// --latex and --markdown, where these say what they print. Errors of a command line with both, or with --json: a usage
/// error, by require_one_form().
void add_paper_form(Command& command, PaperForm& form, const std::string& latex, const std::string& markdown = {});
/// The same of a command that answers by facts.
void add_fact_forms(Command& command, PaperForm& form);
void require_one_form(const CommonOptions& options, const PaperForm& form);

/// What one command knows, in all forms. In LaTeX the formulas stand before the table.
struct FactAnswer {
  const Facts& facts;
  std::size_t width;          ///< of the labels of the page
  Json json;                  ///< page_json() and what is added to it
  std::string more = {};      ///< lines below the page
  std::string formulas = {};  ///< lines of LaTeX
};

/// A table for LaTeX or Markdown, below a remark for LaTeX. Cells are texts, in LaTeX formulas in the row `symbol` and
/// in the columns that are named; the columns but the first are set as `column` says.
struct TableAnswer {
  std::string remark;
  formats::TableRows rows;
  std::vector<std::size_t> formulas = {};
  std::string column = "l";
};

void answer(const CommonOptions& options, const PaperForm& form, const FactAnswer& answer);

/// Domain: LaTeX or Markdown is asked for.
void answer(const CommonOptions& options, const PaperForm& form, TableAnswer answer);

/// Mask and symbol, a line each below the name of the scheme. Errors: as mask_latex().
std::string mask_formulas(const Scheme& scheme);

/// `\alpha = 2`, of proved ends; empty where there are none. With a formula it goes first.
std::string exponent_latex(const Enclosure& exponent, const std::optional<facts::ExponentFormula>& formula = {});

/// Bounds of a function of a scheme, texts from the column `width` on; undecided where they are not as narrow as was
/// asked for.
ExitCode print_range(const Scheme& scheme, Facts known, bool complete, std::size_t width, const CommonOptions& options,
                     const PaperForm& form);

}  // namespace subcert::cli
