#pragma once
/// The statements of one paper.

#include "statement.hpp"

namespace subcert::statements {

/// What one paper brings.
struct PaperStatements {
  std::string key;
  std::string citation;
  std::vector<Transcription> transcriptions;  ///< ids start with the key
  std::vector<Statement> statements;          ///< in the order of the paper
};

}  // namespace subcert::statements
