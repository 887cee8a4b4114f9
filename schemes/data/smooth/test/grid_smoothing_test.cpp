#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/schemes/data/refine/refine.hpp>
#include <subcert/schemes/data/smooth/grid_smoothing.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace subcert;
using namespace subcert::data;

namespace {

std::vector<double> random_numbers(std::size_t count, std::mt19937& engine) {
  std::normal_distribution<double> normal;
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(normal(engine));
  return numbers;
}

}  // namespace

TEST_CASE("products are smoothed as their factors are, with the products of the variances") {
  std::mt19937 engine(5);
  const std::vector<double> f = random_numbers(12, engine), g = random_numbers(17, engine);
  GridData<double> grid{{}, 2, {Axis::of(12), Axis::of(17)}};
  for (const double y : g)
    for (const double x : f) {
      grid.values.push_back(x * y);
      grid.values.push_back(1 - x * y);
    }
  for (const Boundary boundary : {Boundary::regression, Boundary::reflect, Boundary::nearest, Boundary::periodic})
    for (const auto& [all, x, y] : {std::tuple("tensor:(primal:n=2)x(dual:n=3)", "primal:n=2", "dual:n=3"),
                                    std::tuple("local:points=5,d=2", "local:points=5,d=2", "local:points=5,d=2"),
                                    std::tuple("bspline:degree=3", "bspline:degree=3", "bspline:degree=3")}) {
      CAPTURE(to_text(boundary), all);
      const SmoothingOptions options{boundary, 1};
      const SmoothedGrid smoothed = smooth_grid(grid, all, options, 2.0, 2);
      Samples along_x{{f}}, along_y{{g}};
      along_x.noise = along_y.noise = 1;
      const SmoothedColumn sx = smooth(along_x, std::string_view(x), options).columns[0],
                           sy = smooth(along_y, std::string_view(y), options).columns[0];
      REQUIRE(smoothed.axes[0].count == sx.values.size());
      REQUIRE(smoothed.axes[1].count == sy.values.size());
      CHECK(smoothed.axes[0].step == Rational(1) / 2);
      double error = 0;
      for (std::size_t j = 0; j < sy.values.size(); ++j)
        for (std::size_t i = 0; i < sx.values.size(); ++i) {
          const std::size_t at = j * sx.values.size() + i;
          error = std::max({error, std::abs(smoothed.columns[0].values[at] - sx.values[i] * sy.values[j]),
                            std::abs(smoothed.columns[1].values[at] - 1 + sx.values[i] * sy.values[j]),
                            std::abs(smoothed.columns[0].deviations[at] - 2 * sx.deviations[i] * sy.deviations[j])});
        }
      CHECK(error < 1e-12);
    }
  // The same constant everywhere.
  for (double& value : grid.values) value = 7;
  const SmoothingOptions constant{Boundary::constant, 1, 0, 7};
  for (const double value : smooth_grid(grid, "primal:n=3", constant, 1.0).columns[1].values)
    CHECK(std::abs(value - 7) < 1e-12);
}

TEST_CASE("inside, a smoothed surface is the limit of its data") {
  std::mt19937 engine(6);
  const GridData<double> grid{random_numbers(20 * 21, engine), 1, {Axis::of(20), Axis::of(21)}};
  const std::string name = "tensor:(primal:n=2)x(primal:n=1)";
  const GridData<double> limit = limit_of_data(grid, std::get<Scheme>(make_any_scheme(name)).mask, {1});
  const SmoothedGrid smoothed = smooth_grid(grid, name, {Boundary::regression, 1}, std::nullopt);
  REQUIRE(smoothed.axes[0].count == limit.axes[0].count);
  for (std::size_t j = 16; j < 24; ++j)
    for (std::size_t i = 16; i < 24; ++i) {
      const std::size_t at = j * limit.axes[0].count + i;
      CHECK(std::abs(smoothed.columns[0].values[at] - limit.values[at]) < 1e-12);
    }
}

TEST_CASE("the noise of a surface is found, and bands cover") {
  std::mt19937 engine(7);
  constexpr int draws = 400;
  int covered = 0, covered_new = 0;
  double mean = 0;
  for (int draw = 0; draw < draws; ++draw) {
    GridData<double> grid{random_numbers(13 * 11, engine), 1, {Axis::of(13), Axis::of(11)}};
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
      const auto x = static_cast<double>(i % 13), y = static_cast<double>(i / 13);
      grid.values[i] = 3 * grid.values[i] + 2 * x - y + 0.5 * x * y;
    }
    const SmoothedGrid smoothed = smooth_grid(grid, "primal:n=2", {Boundary::regression, 0}, std::nullopt);
    const SmoothedColumn& column = smoothed.columns[0];
    mean += column.noise->variance / draws;
    const std::size_t at = 4 * 13 + 9;
    const double truth = 2 * 9 - 4 + 0.5 * 36, off = std::abs(column.values[at] - truth);
    covered += off <= column.half_widths(0.9)[at] ? 1 : 0;
    const double fresh = truth + 3 * random_numbers(1, engine)[0];
    covered_new += std::abs(fresh - column.values[at]) <= column.half_widths(0.9, BandKind::prediction)[at] ? 1 : 0;
  }
  CHECK(std::abs(mean - 9) < 0.5);
  const double deviation = std::sqrt(draws * 0.9 * 0.1);  // of the binomial law
  CHECK(std::abs(covered - 0.9 * draws) < 3.5 * deviation);
  CHECK(std::abs(covered_new - 0.9 * draws) < 3.5 * deviation);
  // A plane has none; one row is a curve; two by two have no estimate.
  GridData<double> plane{{}, 1, {Axis::of(5), Axis::of(4)}};
  for (std::size_t i = 0; i < 20; ++i) plane.values.push_back(static_cast<double>(i % 5) - static_cast<double>(i / 5));
  CHECK(estimate_noise(plane)[0].variance < 1e-28);
  CHECK(estimate_noise(plane)[0].terms == 6);
  const std::vector<double> curve = random_numbers(30, engine);
  const NoiseEstimate row = estimate_noise(GridData<double>{curve, 1, {Axis::of(30), Axis::of(1)}})[0],
                      same = estimate_noise(curve);
  CHECK(std::abs(row.variance - same.variance) < 1e-12);
  CHECK(row.degrees_of_freedom == same.degrees_of_freedom);
  CHECK_FALSE(estimate_noise(GridData<double>{{1, 2, 3, 4}, 1, {Axis::of(2), Axis::of(2)}})[0].exists());
}

TEST_CASE("bands at all positions of a grid at once cover") {
  std::mt19937 engine(8);
  constexpr int draws = 300;
  SmoothingOptions options{Boundary::regression, 1};
  int covered = 0, covered_pointwise = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const GridData<double> grid{random_numbers(14 * 10, engine), 1, {Axis::of(14), Axis::of(10)}};
    const SmoothedColumn column = smooth_grid(grid, "local:points=6", options, std::nullopt).columns[0];
    const auto holds = [&](BandKind kind) {
      const std::vector<double> widths = column.half_widths(0.9, kind);
      for (std::size_t i = 0; i < widths.size(); ++i)
        if (std::abs(column.values[i]) > widths[i]) return 0;
      return 1;
    };
    covered += holds(BandKind::simultaneous);
    covered_pointwise += holds(BandKind::pointwise);
  }
  CHECK(covered > 0.9 * draws - 3.5 * std::sqrt(draws * 0.9 * 0.1));
  CHECK(covered_pointwise < 0.2 * draws);
  // One row is a curve, whose path it has; with two rows alike there are two such, and the way from one to the other.
  const std::vector<double> curve = random_numbers(20, engine);
  Samples samples{{curve}};
  const double path = smooth(samples, std::string_view("primal:n=2"), options).columns[0].path;
  const auto path_of = [&](std::size_t rows, const std::string& along_y, const SmoothingOptions& how) {
    GridData<double> grid{{}, 1, {Axis::of(20), Axis::of(rows)}};
    for (std::size_t j = 0; j < rows; ++j) grid.values.insert(grid.values.end(), curve.begin(), curve.end());
    return smooth_grid(grid, "tensor:(primal:n=2)x(" + along_y + ")", how, 1.0).columns[0].path;
  };
  CHECK(std::abs(path_of(1, "primal:n=1", options) - path) < 1e-12);
  SmoothingOptions at_data = options;
  at_data.at_data = true;  // interpolating rows are at right angles
  const double at_data_path = smooth(samples, std::string_view("primal:n=2"), at_data).columns[0].path;
  CHECK(std::abs(path_of(2, "dd:n=1", at_data) - (2 * at_data_path + std::acos(0.0))) < 1e-12);
}

TEST_CASE("the method for a grid is chosen for its expected squared error") {
  std::mt19937 engine(9);
  GridData<double> grid{random_numbers(160 * 90, engine), 1, {Axis::of(160), Axis::of(90)}};
  std::vector<double> truth;
  for (std::size_t i = 0; i < grid.values.size(); ++i) {
    truth.push_back(std::sin(static_cast<double>(i % 160) / 4) + std::cos(static_cast<double>(i / 160) / 20));
    grid.values[i] = truth.back() + 0.5 * grid.values[i];
  }
  const SmoothingOptions options{Boundary::regression, 0, 0, 0, true, false};
  const auto error_of = [&](const std::string& method) {
    const std::vector<double> values = smooth_grid(grid, method, options, std::nullopt).columns[0].values;
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += (values[i] - truth[i]) * (values[i] - truth[i]);
    return sum / static_cast<double>(values.size());
  };
  const SmoothedGrid chosen = smooth_grid(grid, "", options, std::nullopt, 2);
  REQUIRE(chosen.choice);
  const auto& candidates = chosen.choice->candidates;
  CHECK(chosen.method == candidates.front().specification);
  CHECK(chosen.method.starts_with("tensor:("));  // it bends more along x
  double best = 1e9;
  for (const SmoothingCandidate& one : candidates) {
    best = std::min(best, error_of(one.specification));
    CHECK(one.risk.bias_squared >= 0);
    CHECK(candidates.front().risk.total() <= one.risk.total());
  }
  CHECK(error_of(chosen.method) < 1.2 * best);
  CHECK(candidates.front().risk.total() < 2 * error_of(chosen.method));
  CHECK(candidates.front().risk.total() > 0.5 * error_of(chosen.method));
  // Short axes, one row, and numbers at each point; what has no noise to estimate.
  for (const std::size_t rows : {1, 2, 3}) {
    const GridData<double> small{random_numbers(2 * 9 * rows, engine), 2, {Axis::of(9), Axis::of(rows)}};
    CHECK(smooth_grid(small, "", options, std::nullopt).columns[1].values.size() == 9 * rows);
  }
  const GridData<double> least{{1, 2, 3, 4}, 1, {Axis::of(2), Axis::of(2)}};
  CHECK_THROWS_WITH(smooth_grid(least, "", options, std::nullopt), Catch::Matchers::Contains("name a scheme"));
  CHECK(smooth_grid(least, "", options, 1.0).columns[0].values.size() == 4);
}

TEST_CASE("what does not smooth grids is refused") {
  const GridData<double> grid{std::vector<double>(64), 1, {Axis::of(8), Axis::of(8)}};
  CHECK_THROWS_AS(smooth_grid(grid, "l1:points=4", {}, std::nullopt), Error);
  CHECK_THROWS_AS(smooth_grid(grid, "tensor:(primal:n=1)x(primal:n=1)x(primal:n=1)", {}, std::nullopt), Error);
  CHECK_THROWS_AS(smooth_grid(grid, "mask:[1,0,0,1]", {}, std::nullopt), Error);
  CHECK_THROWS_AS(smooth_grid(grid, "grid:points=4x4", {}, std::nullopt), Error);
  CHECK_THROWS_AS(smooth_grid(grid, "tensor:(local:points=3)x(l1:points=4)", {}, std::nullopt), Error);
  CHECK_THROWS_AS(smooth_grid(grid, "tensor:(local:points=3)", {}, std::nullopt), Error);
  CHECK_THROWS_AS(smooth_grid(grid, "tensor:(local:points=3", {}, std::nullopt), Error);
  CHECK_THROWS_AS(smooth_grid(grid, "primal:n=2", {Boundary::regression, 0, 1}, std::nullopt), Error);
}

namespace {

constexpr double hole = std::numeric_limits<double>::quiet_NaN();

/// Numbers on a grid of two axes, one in `every` missing.
GridData<double> with_holes(std::size_t columns, std::size_t rows, int every, std::mt19937& engine) {
  GridData<double> grid{random_numbers(columns * rows, engine), 1, {Axis::of(columns), Axis::of(rows)}};
  for (double& value : grid.values)
    if (engine() % static_cast<unsigned>(every) == 0) value = hole;
  return grid;
}

/// The solution by elimination with pivots, of normal equations.
std::vector<double> solved(std::vector<std::vector<double>> matrix, std::vector<double> right) {
  const std::size_t n = right.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t best = k;
    for (std::size_t i = k; i < n; ++i)
      if (std::abs(matrix[i][k]) > std::abs(matrix[best][k])) best = i;
    std::swap(matrix[k], matrix[best]);
    std::swap(right[k], right[best]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = matrix[i][k] / matrix[k][k];
      for (std::size_t j = k; j < n; ++j) matrix[i][j] -= factor * matrix[k][j];
      right[i] -= factor * right[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) right[k] -= matrix[k][j] * right[j];
    right[k] /= matrix[k][k];
  }
  return right;
}

/// The fit at (x, y) by monomials, tricube weights of this width and the normal equations.
double fitted(const GridData<double>& grid, double x, double y, int degree, double width) {
  std::vector<std::vector<double>> matrix;
  std::vector<double> right;
  const auto size = static_cast<std::size_t>((degree + 1) * (degree + 1));
  matrix.assign(size, std::vector<double>(size));
  right.assign(size, 0);
  const auto weight = [&](double u) {
    u = std::abs(u) / width;
    return u < 1 ? std::pow(1 - u * u * u, 3) : 0;
  };
  for (std::size_t j = 0; j < grid.axes[1].count; ++j)
    for (std::size_t i = 0; i < grid.axes[0].count; ++i) {
      const double value = grid.values[j * grid.axes[0].count + i];
      if (std::isnan(value)) continue;
      const double a = static_cast<double>(i) - x, b = static_cast<double>(j) - y, w = weight(a) * weight(b);
      std::vector<double> terms;
      for (int q = 0; q <= degree; ++q)
        for (int p = 0; p <= degree; ++p) terms.push_back(std::pow(a, p) * std::pow(b, q));
      for (std::size_t r = 0; r < size; ++r) {
        right[r] += w * terms[r] * value;
        for (std::size_t c = 0; c < size; ++c) matrix[r][c] += w * terms[r] * terms[c];
      }
    }
  return solved(matrix, right).front();
}

double most_apart(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(std::isnan(a[i]) == std::isnan(b[i]));
    if (!std::isnan(a[i])) most = std::max(most, std::abs(a[i] - b[i]));
  }
  return most;
}

}  // namespace

TEST_CASE("around missing data a grid has the fits to those that are there") {
  std::mt19937 engine(11);
  for (const int degree : {0, 1, 2}) {
    const GridData<double> grid = with_holes(11, 9, 12, engine);
    const SmoothedGrid smoothed = smooth_grid(grid, "local:width=4,d=" + std::to_string(degree),
                                              {Boundary::regression, 1, 0, 0, false, false}, 1.0, 2);
    CHECK(smoothed.unknown == 0);
    CHECK(smoothed.missing ==
          static_cast<std::size_t>(std::ranges::count_if(grid.values, [](double value) { return std::isnan(value); })));
    std::vector<double> expected;
    for (int j = 0; j <= 16; ++j)
      for (int i = 0; i <= 20; ++i) expected.push_back(fitted(grid, i / 2.0, j / 2.0, degree, 4));
    CHECK(most_apart(smoothed.columns[0].values, expected) < 1e-8);
  }
}

TEST_CASE("a line of a grid with missing data is smoothed as rows with missing data are") {
  std::mt19937 engine(12);
  std::vector<double> line = random_numbers(40, engine);
  Samples samples{{line}, std::vector<Rational>(40, 1)};
  for (const std::size_t i : {3, 9, 10, 22, 39}) {
    line[i] = hole;
    samples.weights[i] = 0;
  }
  for (const Boundary boundary : {Boundary::regression, Boundary::reflect, Boundary::constant, Boundary::periodic}) {
    const SmoothingOptions options{boundary, 1, 0, 0.5, false, false};
    const auto rows = smooth(samples, "local:width=5,d=1", options).columns[0];
    for (const bool turned : {false, true}) {
      const GridData<double> grid{line, 1, {Axis::of(turned ? 1 : 40), Axis::of(turned ? 40 : 1)}};
      const SmoothedGrid along = smooth_grid(grid,
                                             turned ? "tensor:(local:points=1,d=0)x(local:width=5,d=1)"
                                                    : "tensor:(local:width=5,d=1)x(local:points=1,d=0)",
                                             options, std::nullopt);
      CAPTURE(to_text(boundary), turned);
      CHECK(most_apart(along.columns[0].values, rows.values) < 1e-12);
      CHECK(most_apart(along.columns[0].deviations, rows.deviations) < 1e-12);
      CHECK(along.columns[0].noise->terms == rows.noise->terms);
      CHECK(std::abs(along.columns[0].noise->degrees_of_freedom - rows.noise->degrees_of_freedom) < 1e-9);
    }
  }
}

TEST_CASE("missing data of grids: what is reproduced, what is not known, what stays a hole") {
  std::mt19937 engine(13);
  GridData<double> grid = with_holes(24, 20, 9, engine);
  GridData<double> whole = grid;
  for (std::size_t i = 0; i < grid.values.size(); ++i) {
    const double x = static_cast<double>(i % 24), y = static_cast<double>(i / 24);
    whole.values[i] = 1 + x - 2 * y + 0.25 * x * y;
    if (!std::isnan(grid.values[i])) grid.values[i] = whole.values[i];
  }
  for (std::size_t j = 4; j < 12; ++j)
    for (std::size_t i = 4; i < 12; ++i) grid.values[j * 24 + i] = hole;
  SmoothingOptions options{Boundary::regression, 0, 0, 0, true, false};
  const SmoothedGrid filled = smooth_grid(grid, "local:points=9,d=1", options, 1.0, 2);
  CHECK(filled.unknown > 1);
  CHECK(std::isnan(filled.columns[0].values[8 * 24 + 8]));
  for (std::size_t i = 0; i < grid.values.size(); ++i) {
    const double value = filled.columns[0].values[i];
    CHECK(std::isnan(value) == std::isnan(filled.columns[0].deviations[i]));
    if (!std::isnan(value)) CHECK(std::abs(value - whole.values[i]) < 1e-9);
    if (!std::isnan(grid.values[i])) CHECK_FALSE(std::isnan(value));
  }
  options.keep_holes = true;
  const SmoothedGrid kept = smooth_grid(grid, "local:points=9,d=1", options, 1.0);
  for (std::size_t i = 0; i < grid.values.size(); ++i)
    CHECK(std::isnan(kept.columns[0].values[i]) == std::isnan(grid.values[i]));
  options.at_data = false;
  options.level = 1;
  const SmoothedGrid finer = smooth_grid(grid, "local:points=9,d=1", options, 1.0);
  for (std::size_t j = 0; j < 39; ++j)
    for (std::size_t i = 0; i < 47; ++i) {
      bool beside = false;
      for (const std::size_t b : {j / 2, (j + 1) / 2})
        for (const std::size_t a : {i / 2, (i + 1) / 2}) beside = beside || std::isnan(grid.values[b * 24 + a]);
      if (beside) CHECK(std::isnan(finer.columns[0].values[j * 47 + i]));
      const auto x = static_cast<double>(i), y = static_cast<double>(j);
      if (!beside) CHECK(std::abs(finer.columns[0].values[j * 47 + i] - 1 - x / 2 + y - x * y / 16) < 1e-9);
    }
  CHECK_FAILS(smooth_grid(grid, "primal:n=2", options, 1.0), domain);
  CHECK_FAILS(smooth_grid(grid, "local:points=9,d=1", SmoothingOptions{}, 1.0), domain);
  std::ranges::fill(grid.values, hole);
  CHECK_FAILS(smooth_grid(grid, "local:points=9,d=1", options, 1.0), data);
}

TEST_CASE("with a tenth of a grid missing the noise is found, and the choice is nearly as good") {
  std::mt19937 engine(14);
  GridData<double> whole{random_numbers(70 * 50, engine), 1, {Axis::of(70), Axis::of(50)}}, grid;
  std::vector<double> truth;
  for (std::size_t i = 0; i < whole.values.size(); ++i) {
    truth.push_back(3 * std::sin(static_cast<double>(i % 70) / 9) * std::cos(static_cast<double>(i / 70) / 7));
    whole.values[i] = truth[i] + 0.5 * whole.values[i];
  }
  grid = whole;
  for (double& value : grid.values)
    if (engine() % 10 == 0) value = hole;
  const NoiseEstimate all = estimate_noise(whole)[0], some = estimate_noise(grid)[0];
  CHECK(some.terms < all.terms);
  CHECK(some.degrees_of_freedom < all.degrees_of_freedom);
  CHECK(some.degrees_of_freedom / static_cast<double>(some.terms) >
        all.degrees_of_freedom / static_cast<double>(all.terms));  // with fewer neighbours
  CHECK(std::abs(some.variance - 0.25) < 4 * 0.25 * std::sqrt(2 / some.degrees_of_freedom));
  const auto error = [&](const GridData<double>& data) {
    const SmoothedGrid smoothed = smooth_grid(data, "", {Boundary::regression, 0, 0, 0, true, false}, std::nullopt, 2);
    double sum = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) sum += std::pow(smoothed.columns[0].values[i] - truth[i], 2);
    return std::sqrt(sum / static_cast<double>(truth.size()));
  };
  const double without = error(whole), with = error(grid);
  CHECK(with < 1.2 * without);
}
