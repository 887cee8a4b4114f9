#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/schemes/data/smooth/smooth.hpp>

#include <cmath>

using namespace subcert;
using namespace subcert::data;

namespace {

Samples waves() {
  Samples samples{{{}, {}}, {}, Rational(2), Rational(1, 10)};
  for (int i = 0; i < 40; ++i) {
    samples.columns[0].push_back(std::sin(0.2 * i) + 0.01 * ((i * 7919) % 13 - 6));
    samples.columns[1].push_back(3 + 0.5 * i);
  }
  return samples;
}

}  // namespace

TEST_CASE("columns are smoothed with deviations, bands and derivatives in units of the positions") {
  const Scheme scheme = make_scheme("primal:n=3");
  const SmoothedSamples limit = smooth(waves(), scheme, {Boundary::regression, 1});
  REQUIRE(limit.positions.size() == 79);
  CHECK(limit.positions[3] == Rational(3, 2));
  const LinearSmoother smoother(scheme.mask, 40, {Boundary::regression, 1});
  CHECK(limit.columns[0].values == smoother.apply(waves().columns[0]).values);
  const NoiseEstimate noise = estimate_noise(waves().columns[0]);
  for (std::size_t o = 0; o < 79; ++o) {
    const double deviation = std::sqrt(noise.variance * static_cast<double>(smoother.row(o).variance));
    CHECK(limit.columns[0].deviations[o] == Approx(deviation));
    CHECK(limit.columns[0].half_widths(0.9)[o] == Approx(band_factor(0.9, noise) * deviation));
  }
  const SmoothedSamples slopes = smooth(waves(), scheme, {Boundary::regression, 0, 1});
  for (const double slope : slopes.columns[1].values) CHECK(slope == Approx(5));
  const SmoothedSamples single = smooth({{{7}}}, scheme, {});
  CHECK(single.columns[0].values == std::vector<double>{7});
  CHECK(single.columns[0].half_widths(0.9).empty());
}

TEST_CASE("samples are smoothed by l1 regression too, without bands") {
  const DataDependentScheme scheme = make_l1_scheme("l1:points=6");
  const SmoothedSamples limit = smooth(waves(), scheme, {Boundary::regression, 2});
  REQUIRE(limit.positions.size() == 157);
  for (std::size_t o = 0; o < 157; ++o)
    CHECK(limit.columns[1].values[o] == Approx(3 + 0.5 * static_cast<double>(limit.positions[o])));
  CHECK(limit.columns[1].half_widths(0.9).empty());
  CHECK_FALSE(limit.columns[1].noise);
}

TEST_CASE("what cannot be smoothed is said") {
  const Scheme scheme = make_scheme("primal:n=2");
  const DataDependentScheme l1 = make_l1_scheme("l1:points=6");
  Samples weighted = waves();
  weighted.weights.assign(40, 1);
  CHECK_FAILS(smooth(waves(), scheme, {Boundary::regression, 0, 3}), domain);
  CHECK_FAILS(smooth(waves(), make_scheme("mask:[1,1]"), {}), domain);
  CHECK_FAILS(smooth(waves(), l1, {Boundary::regression, 0, 1}), domain);
  CHECK_FAILS(smooth(waves(), l1, {Boundary::nearest}), domain);
  CHECK_FAILS(smooth(weighted, l1, {}), domain);
  CHECK_FAILS(smooth(waves(), make_l1_scheme("l1:points=4x4"), {}), domain);
  CHECK_FAILS(smooth({{{1, 2, 3}}}, l1, {}), data);
}
