#pragma once
/// The parts of a page.

#include "comparison.hpp"
#include "figure.hpp"
#include "surface_figure.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace subcert::formats {

/// The proof of a row: files of the folder of the paper, and what a checker is to be asked. The page has a button that
/// does so.
struct RowProof {
  std::string name;                          ///< of the certificate
  std::vector<std::string> words;            ///< the command line of the checker
  std::map<std::string, std::string> files;  ///< texts by their names
  std::string scheme = {};                   ///< whose exponent it proves, as cells name it; may be empty
};

/// A table of our own, without printed counterpart.
struct PlainTable {
  std::string id;
  std::string title;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row_classes = {};  ///< how the page marks each row; empty for no marks
  std::vector<RowProof> proofs = {};          ///< of each row; empty for none
  std::vector<std::string> row_ids = {};      ///< names of links to the rows; empty for none
};

/// One part of the page. Items that were not asked for have no section.
struct Section {
  std::string id;
  std::string heading;
  std::vector<std::string> paragraphs;
  std::vector<ComparisonTable> comparisons = {};
  std::vector<PlainTable> tables = {};
  std::vector<Figure> figures = {};
  std::vector<SurfaceFigure> surface_figures = {};
  std::string finding = {};  ///< one sentence for the first screen, if a reader must know it; made of what was computed
  std::optional<Panel> evidence = {};  ///< the picture beside it; without it that of the first figure
};

/// The button and the place of its answer; nothing for a proof without a name. `folder`: of the paper, beside the page.
std::string check_button(const std::string& folder, const RowProof& proof);

/// The same for a page in one file, which holds the certificate.
std::string check_button_inside(const RowProof& proof);

/// The script that gives the files of the proof to the page: PROOF.name + ".js" in the folder.
std::string certificate_script(const std::string& folder, const RowProof& proof);

}  // namespace subcert::formats
