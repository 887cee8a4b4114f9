#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/folder.hpp>
#include <subcert/reports/documents.hpp>

#include <filesystem>
#include <fstream>
#include <regex>

using namespace subcert::reports;
using subcert::testing::content;
using subcert::testing::Folder;
namespace fs = std::filesystem;

TEST_CASE("documents: names in texts are links, in scripts, tags and links they are not") {
  CHECK(with_documents("<p>(docs/l1.md, Theorem 1)</p>") ==
        "<p>(<a href=\"docs/l1.html\">docs/l1.md</a>, Theorem 1)</p>");
  CHECK(with_documents("docs/theorems/README.md") == "<a href=\"docs/theorems.html\">docs/theorems/README.md</a>");
  for (const char* text :
       {"", "<", "a<", "<p", "docs/none.md", "xdocs/l1.md", "docs/l1.mdx", "<script>\"docs/l1.md\"</script>",
        "<script id=a>docs/l1.md", "<a href=x>docs/l1.md</a>", "<b title=\"docs/l1.md\">b</b>", "docs/l1"})
    CHECK(with_documents(text) == text);
  CHECK(with_documents("<article>docs/l1.md</article>").find("href") != std::string::npos);
}

TEST_CASE("documents: what texts of pages name is kept, and is written whole") {
  const fs::path source = SUBCERT_SOURCE_DIR;
  const Folder folder;
  write_documents(folder.path);
  const std::regex name("\\bdocs/[\\w/-]+\\.md\\b"), href("href=\"([^\"]*)\"");
  std::size_t count = 0;
  for (const char* floor : {"proofs-checks/papers", "reports"})
    for (const auto& entry : fs::recursive_directory_iterator(source / floor)) {
      const fs::path& file = entry.path();
      if (file.string().find("/test/") != std::string::npos ||
          (file.extension() != ".cpp" && file.extension() != ".toml"))
        continue;
      std::ifstream lines(file);
      for (std::string line; std::getline(lines, line);) {
        const std::size_t text = line.find_first_not_of(' ');
        std::smatch found, link;
        if (text == std::string::npos || line.find("//") < line.find("docs/") || line[text] == '#' ||
            !std::regex_search(line, found, name))
          continue;
        CAPTURE(file, line);
        const std::string page = with_documents(found.str());
        REQUIRE(std::regex_search(page, link, href));
        const std::string written = content(folder.path / link[1].str());
        CHECK(written.size() > content(source / found.str()).size());
        ++count;
      }
    }
  CHECK(count > 10);
}
