#include <subcert/analysis/vertex/vertex_smoothness.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <iostream>

using namespace subcert;

TEST_CASE("vertex trial") {
  for (const std::string name : {"sqrt3"}) {
    const RegularPart regular = regular_part(vertex_rules(name, 3).mask, {Deadline::in(2)});
    std::cerr << name << " " << to_text(regular.c1.truth) << " " << enclosure_text(regular.exponent) << "\n";
    for (const long n : {3L, 4L, 5L, 6L, 7L, 8L, 9L, 12L, 20L, 50L}) {
      const auto begin = std::chrono::steady_clock::now();
      const VertexSmoothness v = vertex_smoothness(vertex_rules(name, n), regular);
      std::cerr << n << " " << to_text(v.c1.truth) << " k=" << v.frequency << " " << enclosure_text(v.subdominant) << " mu "
                << enclosure_text(v.next) << " exp " << enclosure_text(v.exponent) << " "
                << (v.curvature ? to_text(*v.curvature) : "?") << " levels " << v.levels << " squares " << v.squares << " "
                << v.c1.reason << " " << std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()
                << "\n";
    }
  }
}
