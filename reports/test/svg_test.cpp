#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/folder.hpp>
#include <subcert/reports/formats/svg.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <cmath>
#include <cstdlib>

using namespace subcert;
using subcert::testing::content;

namespace {

formats::Panel sequence() {
  formats::Curve marked{"a sequence", {}, true}, single{"other marks", {{2, 0.5}, {3, 0}}, true, false, "#123456"};
  for (int n = 1; n <= 8; ++n) {
    marked.points.emplace_back(n, std::pow(10, -n));
    marked.values.push_back("n = " + std::to_string(n) + ": exactly 1/10^" + std::to_string(n));
  }
  return {"a sequence & its <marks>", "n", "value", {marked, single, {"nothing to see", {{1, 0}}}}, true};
}

formats::Panel enclosed() {
  formats::Panel panel{"enclosed", "w", "", {{"curve", {{0, 1}, {1, 2}, {2, 1.5}}}}};
  panel.bands = {{"band", {{0, 0.5, 1.5}, {1, 1.5, 2.5}, {2, 1, 2}}}};
  panel.cells = {{"proved", "#1e7a43", {{0, 1, 0, 1}, {1, 2, 1, 3}}}};
  return panel;
}

formats::Panel polygon() {
  formats::Panel panel{"polygon", "", "", {{"", {{0, 0}, {4, 0}, {4, 1}, {0, 0}}}}};
  panel.equal_units = true;
  return panel;
}

}  // namespace

// SUBCERT_APPROVE=1 in the environment writes the files instead.
TEST_CASE("pictures: approved") {
  for (const auto& [name, panel] :
       {std::pair{"sequence", sequence()}, std::pair{"enclosed", enclosed()}, std::pair{"polygon", polygon()}}) {
    const std::string file = std::string(SUBCERT_APPROVED) + "/" + name + ".html", text = formats::plot(panel) + "\n";
    if (std::getenv("SUBCERT_APPROVE")) runtime::write_file(file, text);
    CAPTURE(file);
    CHECK(content(file) == text);
  }
}

TEST_CASE("pictures: every name in the legend is that of a series") {
  const auto count = [](const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
  };
  for (const formats::Panel& panel : {sequence(), enclosed()}) {
    const std::string text = formats::plot(panel);
    CHECK(count(text, "aria-pressed") == count(text, "<g class=\"series"));
  }
}
