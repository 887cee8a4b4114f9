#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/folder.hpp>
#include <subcert/reports/formats/date_ticks.hpp>
#include <subcert/reports/formats/svg.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <algorithm>
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

TEST_CASE("pictures of many points are small, and nothing that stands out is lost") {
  formats::Panel panel{"many", "x", "y", {{"marks", {}, true, false}, {"line", {}}}};
  panel.bands = {{"band", {}}};
  for (int i = 0; i < 200'000; ++i) {
    const double x = i, y = std::sin(i / 3e4);
    panel.curves[0].points.emplace_back(x, y + (i == 77'777 ? 9 : i % 7 * 0.01));
    panel.curves[1].points.emplace_back(x, i == 123'456 ? -5 : y);
    panel.bands[0].ends.push_back({x, i == 55'555 ? -3 : y - 1, i == 44'444 ? 4 : y + 1});
  }
  const formats::Panel thin = formats::thinned(panel);
  REQUIRE(thin.curves.size() == 1);
  REQUIRE(thin.bands.size() == 2);
  CHECK(thin.curves[0].points.size() <= 6000);
  CHECK(thin.curves[0].points.front() == panel.curves[1].points.front());
  CHECK(thin.curves[0].points.back() == panel.curves[1].points.back());
  CHECK(std::ranges::count(thin.curves[0].points, std::pair(123'456.0, -5.0)) == 1);
  CHECK(std::ranges::is_sorted(thin.curves[0].points));
  CHECK(thin.bands[0].label == "marks, lowest to highest");
  double lowest = 0, highest = 0, cloud = 0;
  for (const auto& [x, low, high] : thin.bands[1].ends)
    lowest = std::min(lowest, low), highest = std::max(highest, high);
  for (const auto& [x, low, high] : thin.bands[0].ends) cloud = std::max(cloud, high);
  CHECK(lowest == -3);
  CHECK(highest == 4);
  CHECK(cloud > 9);
  CHECK(thin.bands[0].ends.size() <= 2000);
  CHECK(formats::svg(thin).size() < 400'000);
  const formats::Panel small = sequence();
  CHECK(formats::thinned(small).curves[0].points == small.curves[0].points);
}

TEST_CASE("dates on an axis stand at round times") {
  const auto texts = [](double low, double high, double unit) {
    std::string text;
    for (const auto& [at, label] : formats::date_ticks(low, high, unit)) text += (text.empty() ? "" : " ") + label;
    return text;
  };
  CHECK(texts(0, 365.2425 * 30, 86'400) == "1970 1975 1980 1985 1990 1995 2000");
  CHECK(texts(19'000, 19'400, 86'400) == "2022-04 2022-07 2022-10 2023-01");
  CHECK(texts(19'782, 19'800, 86'400) == "2024-03-02 2024-03-06 2024-03-10 2024-03-14 2024-03-18");
  CHECK(texts(-1, 1, 86'400) == "1969-12-31 12:00 1970-01-01 12:00 1970-01-02");
  CHECK(texts(0, 60, 1) == "1970-01-01 00:00:10 00:00:20 00:00:30 00:00:40 00:00:50 00:01:00");
  CHECK(texts(0.25, 0.75, 1) == "00:00:00.300000 00:00:00.400000 00:00:00.500000 00:00:00.600000 00:00:00.700000");
  // Every span has some, in order and within it.
  for (double span = 1e-5; span < 1e10; span *= 1.7)
    for (const double low : {0.0, -1e9 + 0.3, 1.7e9}) {
      const auto ticks = formats::date_ticks(low, low + span, 1);
      CAPTURE(span, low);
      CHECK((ticks.size() >= 1 && ticks.size() <= 8));
      for (std::size_t i = 0; i < ticks.size(); ++i) {
        CHECK((ticks[i].first >= low - 1e-6 && ticks[i].first <= low + span + 1e-6));
        if (i > 0) CHECK((ticks[i].first > ticks[i - 1].first && ticks[i].second != ticks[i - 1].second));
      }
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
