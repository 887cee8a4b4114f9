#include "published.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <nlohmann/json.hpp>

#include <map>
#include <stdexcept>
#include <string_view>

namespace subcert {
extern const std::map<std::string, std::string_view> published_files;  // made by the build
}

namespace subcert::formats {

/// Made at build time from the files in published/.

const PublishedTable& PublishedPaper::table(const std::string& id) const {
  for (const PublishedTable& candidate : tables)
    if (candidate.id == id) return candidate;
  fail(ErrorKind::domain, "no table '{}' in {}", id, key);
}

PublishedPaper published_paper(const std::string& key) {
  const auto file = published_files.find(key);
  require(file != published_files.end(), "no published values for the paper '{}'", key);
  try {
    const auto json = nlohmann::json::parse(file->second);
    PublishedPaper paper{json.at("paper"), {}};
    for (const auto& table : json.at("tables")) {
      PublishedTable result{table.at("id"), table.at("title"), table.at("place"), table.at("layout") == "grid", {}};
      for (const auto& cell : table.at("cells"))
        result.cells.push_back({cell.at("row"), cell.at("column"), cell.at("scheme"), cell.at("quantity"),
                                cell.at("printed"), parse_verdict(cell.at("verdict"))});
      paper.tables.push_back(std::move(result));
    }
    return paper;
  } catch (const nlohmann::json::exception& error) {
    fail(ErrorKind::data, "published values of {}: {}", key, error.what());
  }
}

}  // namespace subcert::formats
