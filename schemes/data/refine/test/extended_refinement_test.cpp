#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/schemes/data/refine/slab_refinement.hpp>
#include <subcert/schemes/data/scheme_refinement.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <random>

using namespace subcert;
using namespace subcert::data;

TEST_CASE("nearest and constant are the refinement of data that go on, to the last bit") {
  constexpr std::size_t far = 30;
  std::mt19937 engine(4);
  for (const char* name :
       {"primal:n=3", "dual:n=2", "bspline:degree=3,a=3", "mask:[1,2,3,2]/4@2", "l1:points=6", "l1:points=5,d=2",
        "tensor:(primal:n=2)x(dual:n=2)", "grid:points=3x4,d=1", "butterfly:w=1/16"})
    for (const Boundary boundary : {Boundary::nearest, Boundary::constant})
      for (const std::size_t count : {1, 2, 9})
        for (const int levels : {0, 1, 3}) {
          CAPTURE(name, to_text(boundary), count, levels);
          const AnyScheme scheme = make_data_scheme(name);
          const std::size_t variables = fewest_points(scheme, Boundary::shrink).size(), dimension = 2;
          const auto at = [&](std::size_t k) { return Axis::of(k == 0 ? count : count + 1); };
          GridData<double> data{{}, dimension, {}}, longer{{}, dimension, {}};
          for (std::size_t k = 0; k < variables; ++k) {
            data.axes.push_back(at(k));
            longer.axes.push_back(Axis::of(at(k).count + 2 * far));
          }
          for (std::size_t i = 0; i < data.points() * dimension; ++i)
            data.values.push_back(static_cast<double>(engine()) / 1e9);
          const RefineOptions options{levels, boundary, 1, -1.5};
          const auto inside = [&](std::size_t i, std::size_t k) {
            return std::min(std::max(i, far) - far, data.axes[k].count - 1);
          };
          for (std::size_t i = 0; i < longer.points(); ++i) {
            const std::size_t x = i % longer.axes[0].count, y = i / longer.axes[0].count;
            const std::size_t at_x = inside(x, 0), at_y = variables == 1 ? 0 : inside(y, 1);
            const bool outside = at_x + far != x || (variables > 1 && at_y + far != y);
            for (std::size_t c = 0; c < dimension; ++c)
              longer.values.push_back(outside && boundary == Boundary::constant
                                          ? options.constant
                                          : data.values[(at_y * data.axes[0].count + at_x) * dimension + c]);
          }
          const GridData<double> all = refine(longer, scheme, {levels, Boundary::shrink});
          bool keeps_datum = false;
          for (std::size_t i = 0; i < all.axes[0].count; ++i)
            keeps_datum = keeps_datum || all.axes[0].parameter(i) == Rational(far);
          if (count == 1 && !keeps_datum) {
            CHECK_FAILS(refine(data, scheme, options), domain);
            continue;
          }
          const GridData<double> made = refine(data, scheme, options);
          std::vector<double> wanted;
          std::vector<std::size_t> first, end;
          for (std::size_t k = 0; k < variables; ++k) {
            std::size_t i = 0;
            while (all.axes[k].parameter(i) < Rational(far)) ++i;
            first.push_back(i);
            CHECK(made.axes[k].first == all.axes[k].parameter(i) - Rational(far));
            CHECK(made.axes[k].step == all.axes[k].step);
            CHECK(made.axes[k].length == data.axes[k].length);
            while (all.axes[k].parameter(i) <= data.axes[k].length + Rational(far)) ++i;
            end.push_back(i);
          }
          for (std::size_t y = variables == 1 ? 0 : first[1]; y < (variables == 1 ? 1 : end[1]); ++y)
            for (std::size_t x = first[0]; x < end[0]; ++x)
              for (std::size_t c = 0; c < dimension; ++c)
                wanted.push_back(all.values[(y * all.axes[0].count + x) * dimension + c]);
          CHECK(made.values == wanted);
        }
  const GridData<double> few = curve_data(std::vector<double>{1, 2, 3, 4}, 2);
  CHECK_FAILS(refine(few, make_data_scheme("merrien:lambda=-1/8,mu=1/2"), {1, Boundary::nearest}), domain);
}

TEST_CASE("limits of data that go on past their ends") {
  const GridData<double> data = curve_data<double>({3, 1, 4, 1, 5});
  GridData<double> longer = curve_data<double>({3, 3, 3, 3, 3, 3, 3, 3, 1, 4, 1, 5, 5, 5, 5, 5, 5, 5, 5});
  const LatticeMask mask = make_scheme("primal:n=2").mask;
  const auto limit = [&](const GridData<double>& of, Boundary boundary) {
    return SlabRefinement(of, limit_steps(of.axes, 1, mask, {1, boundary})).whole();
  };
  const GridData<double> made = limit(data, Boundary::nearest), all = limit(longer, Boundary::regression);
  REQUIRE(made.values.size() == 9);
  CHECK(made.axes[0].first == 0);
  for (std::size_t i = 0; i < 9; ++i) CHECK(made.values[i] == Approx(all.values[i + 14]));
}
