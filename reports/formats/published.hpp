#pragma once
/// The values that the papers print: data, with their places.

#include "comparison.hpp"

#include <string>
#include <vector>

namespace subcert::formats {

/// One printed value. `quantity` names what it is (mask, support, holder16, variance, ...), `scheme` of which scheme.
struct PublishedCell {
  std::string row;
  std::string column;
  std::string scheme;
  std::string quantity;
  std::string printed;
  Verdict recorded;
};

struct PublishedTable {
  std::string id;
  std::string title;
  std::string place;
  bool grid;
  std::vector<PublishedCell> cells;
};

struct PublishedPaper {
  std::string key;
  std::vector<PublishedTable> tables;

  /// Errors: throws a domain error for an id that is not there.
  const PublishedTable& table(const std::string& id) const;
};

/// The data of a paper, from reports/published/KEY.json as it was when the library was built. Errors: throws
/// a domain error for a key without data, a data error for malformed data.
PublishedPaper published_paper(const std::string& key);

}  // namespace subcert::formats
