#pragma once
/// The tables that papers print, cell by cell.

#include <subcert/proofs-checks/verdict.hpp>

#include <optional>
#include <string>
#include <vector>

namespace subcert::statements {

/// One printed value.
struct PublishedCell {
  std::string row;
  std::string column;
  std::string scheme;    ///< of which scheme
  std::string quantity;  ///< what it is: `mask`, `support`, `max psi`, ...
  std::optional<int> n;  ///< size and degree of the scheme, where the table has them
  std::optional<int> d;
  std::string printed;
  std::string words;  ///< the transcription that this value is a word of; may be empty
  ValueVerdict recorded;
  std::string source = {};   ///< its key in docs/references.md, where a table is gathered from many
  std::string derived = {};  ///< from what it follows, where it is no printed value of its own
};

struct PublishedTable {
  std::string id;
  std::string title;
  std::string place;
  bool grid;  ///< rows and columns as in the paper; otherwise one cell a line
  std::vector<PublishedCell> cells;
};

}  // namespace subcert::statements
