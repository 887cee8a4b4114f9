#pragma once
/// What one paper prints and claims.

#include "statement.hpp"

#include <string_view>

namespace subcert::statements {

struct Paper {
  std::string key;
  std::string citation;
  Transcriptions transcriptions;
  std::vector<Statement> statements;  ///< in the order of the paper
  std::vector<PublishedTable> tables;

  /// Errors: throws a domain error for an id that is not there.
  const PublishedTable& table(const std::string& id) const;
};

/// The checks of a paper by the id of their statement.
using Checks = std::vector<std::pair<std::string, Check>>;
Checks joined(const std::vector<Checks>& parts);

/// Reads a paper.toml as docs/statements.md describes it. Errors: throws FileError for what is no TOML, an unknown or
/// missing key, a value of the wrong kind, an id that is there twice, and for statements without check and checks
/// without statement, by their ids.
Paper read_paper(const std::string& key, std::string_view text, const Checks& checks);

}  // namespace subcert::statements
