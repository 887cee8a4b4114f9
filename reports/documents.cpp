#include "documents.hpp"

#include "formats/html.hpp"

#include <subcert/schemes/data/runtime/files.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <string_view>

namespace subcert {

extern const std::map<std::string, std::string_view> document_files;  // by their names in docs, by the build

}  // namespace subcert

namespace subcert::reports {
namespace {

/// Of `docs/theorems/README.md` it is `theorems`.
std::string key_of(std::string name) {
  constexpr std::string_view index = "/README";
  if (name.ends_with(index)) name.erase(name.size() - index.size());
  return name;
}

std::string linked(const std::string& text) {
  static const std::regex name(R"(\bdocs/([\w/-]+)\.md\b)");
  std::string result;
  std::size_t at = 0;
  for (std::sregex_iterator one(text.begin(), text.end(), name), end; one != end; ++one) {
    const std::string key = key_of((*one)[1]);
    if (!document_files.contains(key)) continue;
    const auto begin = static_cast<std::size_t>(one->position());
    result += text.substr(at, begin - at) + fmt::format("<a href=\"docs/{}.html\">{}</a>", key, one->str());
    at = begin + one->str().size();
  }
  return result + text.substr(at);
}

}  // namespace

std::string with_documents(const std::string& page) {
  std::string result;
  for (std::size_t at = 0; at < page.size();) {
    const std::size_t tag = std::min(page.find('<', at), page.size());
    result += linked(page.substr(at, tag - at));
    std::size_t end = std::min(page.find('>', tag), page.size() - 1) + 1;
    for (const char* element : {"script", "a"}) {
      const std::string_view rest = std::string_view(page).substr(tag);
      const std::string opened = fmt::format("<{}", element);
      if (rest.starts_with(opened + " ") || rest.starts_with(opened + ">"))
        end = std::min(page.find(fmt::format("</{}", element), end), page.size());
    }
    result += page.substr(tag, end - tag);
    at = end;
  }
  return result;
}

void write_documents(const std::filesystem::path& folder) {
  for (const auto& [key, text] : document_files) {
    const std::string_view title = text.substr(0, text.find('\n'));
    runtime::write_file(
        folder / "docs" / (key + ".html"),
        formats::html_page(formats::html(std::string(title.substr(std::min<std::size_t>(2, title.size())))),
                           fmt::format("<pre class=document>{}</pre>\n", formats::html(std::string(text)))));
  }
}

}  // namespace subcert::reports
