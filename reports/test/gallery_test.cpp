#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/reports/formats/svg.hpp>
#include <subcert/reports/gallery/gallery.hpp>

#include <algorithm>
#include <set>

using namespace subcert;
using namespace subcert::reports;

TEST_CASE("gallery: forty schemes in canonical form, each with a reference") {
  CHECK(gallery_schemes().size() == 40);
  std::set<std::string> specifications;
  for (const GalleryScheme& scheme : gallery_schemes()) {
    CAPTURE(scheme.specification);
    specifications.insert(scheme.specification);
    CHECK_FALSE(reference(scheme.key).empty());
    const Scheme made = make_linear_scheme(scheme.specification);
    std::string canonical = made.specification;
    if (scheme.specification.ends_with(':') && !canonical.ends_with(':')) canonical += ':';
    CHECK(canonical == scheme.specification);
  }
  CHECK(specifications.size() == gallery_schemes().size());
  CHECK(reference("Loo87") ==
        "C. Loop: Smooth subdivision surfaces based on triangles. Master's thesis, University of Utah (1987).");
  CHECK_THROWS_AS(reference("Loo"), Error);
  CHECK_THROWS_AS(reference(""), Error);
}

namespace {

/// The pairs of numbers of the first path of this class.
std::size_t points_of_path(const std::string& svg, const std::string& kind) {
  const std::size_t begin = svg.find("d=\"", svg.find("class=\"" + kind)) + 3;
  const std::string path = svg.substr(begin, svg.find('"', begin) - begin);
  return static_cast<std::size_t>(std::count(path.begin(), path.end(), ','));
}

}  // namespace

TEST_CASE("svg: only the points that a line needs") {
  formats::Curve hat{"", {}};
  for (int i = -100; i <= 100; ++i) hat.points.emplace_back(i, 100 - std::abs(i));
  const std::string picture = formats::svg(formats::Panel{"hat", "", "", {hat}});
  CHECK(points_of_path(picture, "curve") == 3);
  CHECK_THROWS_AS(formats::svg(formats::Panel{"empty", "", "", {}}), Error);
  hat.points.emplace_back(101, std::nan(""));
  CHECK_THROWS_AS(formats::svg(formats::Panel{"hole", "", "", {hat}}), Error);
}

TEST_CASE("svg: a curve that is nearly constant has axes with few numbers") {
  const formats::Curve flat{"", {{0, 0.2}, {0.5, 0.2 + 1e-17}, {1, 0.2 - 3e-17}}};
  const std::string picture = formats::svg(formats::Panel{"flat", "", "", {flat}});
  CHECK(picture.size() < 3000);
  CHECK(points_of_path(picture, "curve") == 2);
  CHECK(formats::svg(formats::Panel{"zero", "", "", {{"", {{0, 0}, {1, 0}}}}}).size() < 3000);
  CHECK(formats::svg(formats::Panel{"point", "", "", {{"", {{3, 5}}}}}).size() < 3000);
}

TEST_CASE("svg: level lines of a pyramid are squares") {
  formats::DrawnSurface pyramid{"pyramid", 21, 21, false, false, {}, true};
  for (int j = -10; j <= 10; ++j)
    for (int i = -10; i <= 10; ++i)
      pyramid.points.push_back({double(i), double(j), 10.0 - std::max(std::abs(i), std::abs(j))});
  const std::string picture = formats::svg(pyramid);
  CHECK(std::ranges::count(picture, 'Z') == 9);  // one closed line for each level
  CHECK(picture.find("level below") == std::string::npos);
  const std::size_t corners = points_of_path(picture, "level");
  CHECK(corners >= 5);
  CHECK(corners <= 12);
  for (auto& point : pyramid.points) point[2] = -point[2];
  CHECK(formats::svg(pyramid).find("level above") == std::string::npos);
}
