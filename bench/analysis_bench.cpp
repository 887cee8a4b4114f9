// Symbols, masks, level norms and limit values. Ratios are read within one run: BM_plain_convolution is the way that
// the level norms are compared with.

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/difference/level_norms.hpp>
#include <subcert/analysis/limit/limit_range.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/radii/joint/product.hpp>
#include <subcert/analysis/radii/joint/single_radius.hpp>
#include <subcert/analysis/radii/polytope_proof/candidate.hpp>
#include <subcert/analysis/radii/quadratic/product_tree.hpp>
#include <subcert/analysis/radii/quadratic/quadratic_proof.hpp>
#include <subcert/analysis/radii/subradius/joint_spectral_subradius.hpp>
#include <subcert/analysis/symbol/polynomials/sum_of_squares.hpp>
#include <subcert/analysis/transition/transition.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/analysis/variance/variance_order.hpp>
#include <subcert/analysis/variance/variance_range.hpp>
#include <subcert/schemes/specification.hpp>

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

namespace {

using namespace subcert;

LaurentPolynomial random_polynomial(long length, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_int_distribution<long> digit(-999, 999);
  std::vector<Rational> coefficients;
  for (long i = 0; i < length; ++i) coefficients.emplace_back(2 * digit(engine) + 1, 360);
  return LaurentPolynomial(coefficients, -length / 2);
}

void BM_product(benchmark::State& state) {
  const LaurentPolynomial p = random_polynomial(state.range(0), 1), q = random_polynomial(state.range(0), 2);
  for (auto _ : state) benchmark::DoNotOptimize(p * q);
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_product)->RangeMultiplier(4)->Range(16, 16384)->Complexity();

void BM_mask(benchmark::State& state) {
  const std::string text = "primal:n=" + std::to_string(state.range(0)) + ",d=" + std::to_string(state.range(1));
  for (auto _ : state) benchmark::DoNotOptimize(make_scheme(text));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_mask)->Args({50, 1})->Args({50, 3})->Args({50, 9})->Unit(benchmark::kMillisecond);
BENCHMARK(BM_mask)->ArgsProduct({{10, 20, 40, 80, 160}, {5}})->Complexity()->Unit(benchmark::kMillisecond);

Mask derived(const std::string& specification) {
  const Mask mask = make_scheme(specification).mask.curve();
  return divided_difference_scheme(mask, sum_rules(mask));
}

std::vector<Mask> degree_one_schemes() {
  std::vector<Mask> masks;
  for (const char* family : {"primal", "dual", "primal-odd", "dual-odd"})
    for (int n = std::string(family).find("odd") == std::string::npos ? 2 : 1; n <= 10; ++n)
      masks.push_back(derived(std::string(family) + ":n=" + std::to_string(n)));
  return masks;
}

/// Exact norms of the levels 1, ..., 16 of all 38 degree-1 schemes with n <= 10.
void BM_level_norms_38_schemes(benchmark::State& state) {
  const std::vector<Mask> masks = degree_one_schemes();
  std::uint64_t visited = 0, exact = 0;
  for (auto _ : state) {
    visited = exact = 0;
    for (const Mask& mask : masks) {
      const LevelNorms result = level_norms(mask, 16);
      visited += result.visited;
      exact += result.exact;
    }
  }
  state.counters["nodes"] = static_cast<double>(visited);
  state.counters["exact_sums"] = static_cast<double>(exact);
}
BENCHMARK(BM_level_norms_38_schemes)->Unit(benchmark::kSecond)->Iterations(1);

/// The plain way for level 16 alone: convolve the whole symbol in double precision, then sum over residues.
double plain_norm(const std::vector<double>& b, int levels) {
  std::vector<double> power_of_b{1.0};
  for (int level = 0; level < levels; ++level) {
    std::vector<double> next(2 * (power_of_b.size() - 1) + b.size(), 0.0);
    for (std::size_t i = 0; i < power_of_b.size(); ++i)
      for (std::size_t j = 0; j < b.size(); ++j) next[2 * i + j] += power_of_b[i] * b[j];
    power_of_b = std::move(next);
  }
  std::vector<double> sums(std::size_t{1} << levels, 0.0);
  for (std::size_t i = 0; i < power_of_b.size(); ++i) sums[i & (sums.size() - 1)] += std::abs(power_of_b[i]);
  return *std::max_element(sums.begin(), sums.end());
}

void BM_plain_convolution_38_schemes(benchmark::State& state) {
  std::vector<std::vector<double>> masks;
  for (const Mask& mask : degree_one_schemes()) {
    masks.emplace_back();
    for (const Rational& c : mask.symbol().coefficients()) masks.back().push_back(c.convert_to<double>());
  }
  for (auto _ : state)
    for (const auto& b : masks) benchmark::DoNotOptimize(plain_norm(b, 16));
}
BENCHMARK(BM_plain_convolution_38_schemes)->Unit(benchmark::kSecond)->Iterations(1);

void BM_level_norms(benchmark::State& state) {
  const Mask mask = derived("primal:n=" + std::to_string(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(level_norms(mask, static_cast<int>(state.range(1))));
}
BENCHMARK(BM_level_norms)->ArgsProduct({{3, 5, 10}, {8, 12, 16}})->Unit(benchmark::kMillisecond);

/// The search for an invariant polytope alone, then its proof alone (rounding, refinement, exact residuals).
MatrixFamily difference_matrices(const std::string& scheme) { return transition_matrices(derived(scheme)); }

void BM_polytope_search(benchmark::State& state, const std::string& scheme) {
  const MatrixFamily family = difference_matrices(scheme);
  std::size_t vertices = 0;
  for (auto _ : state) vertices = radius::find_polytope(family, {Deadline::in(60)}).vertices.size();
  state.counters["vertices"] = static_cast<double>(vertices);
  state.counters["dimension"] = static_cast<double>(family.size());
}

void BM_polytope_proof(benchmark::State& state, const std::string& scheme) {
  const MatrixFamily family = difference_matrices(scheme);
  const radius::PolytopeCandidate candidate = radius::find_polytope(family, {Deadline::in(60)});
  for (auto _ : state) benchmark::DoNotOptimize(certify_polytope(family, candidate, {}));
}

/// All 38 schemes of degree 1 in the paper's tables, and two whose orbits are flat.
const bool polytope_benchmarks = [] {
  const auto add = [](const std::string& scheme) {
    benchmark::RegisterBenchmark(("BM_polytope_search/" + scheme).c_str(), BM_polytope_search, scheme)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("BM_polytope_proof/" + scheme).c_str(), BM_polytope_proof, scheme)
        ->Unit(benchmark::kMillisecond);
  };
  for (const std::string family : {"primal", "dual", "primal-odd", "dual-odd"}) {
    const bool odd = family.ends_with("odd");
    for (int n = odd ? 1 : 2; n <= 10; ++n) add(family + ":n=" + std::to_string(n));
  }
  for (const char* scheme : {"dual:n=12", "primal:n=16"}) add(scheme);
  return true;
}();

/// The interpolating schemes with 2 n points: one spectral radius, and the sum of squares of its certificate.
Mask deslauriers_dubuc(long n) {
  const Mask mask = make_scheme("dd:n=" + std::to_string(n)).mask.curve();
  return divided_difference_scheme(mask, sum_rules(mask));
}

/// Products of many letters, from the product of one or two letters that is the best of the short ones.
void BM_long_products(benchmark::State& state, const std::string& scheme, const std::vector<int>& product) {
  const polytope::SearchFamily family = radius::to_search_family(difference_matrices(scheme));
  const double radius = polytope::product_radius(family.matrices, product);
  std::vector<polytope::Candidate> found;
  for (auto _ : state) found = quadratic::long_products(family, radius, {Deadline::in(60)});
  if (found.empty()) return state.SkipWithError("nothing found");
  state.counters["letters"] = static_cast<double>(found.front().word.size());
  state.counters["above"] = 100 * (found.front().radius / radius - 1);
}
const bool product_benchmarks = [] {
  for (const char* scheme : {"dual:n=8,d=3", "dual:n=10,d=5"})
    benchmark::RegisterBenchmark((std::string("BM_long_products/") + scheme).c_str(), BM_long_products, scheme,
                                 std::vector{0, 1})
        ->Unit(benchmark::kMillisecond);
  return true;
}();

/// Forms of contexts until there are so many; by what their bound exceeds the radius of the best product, in percent.
void BM_context_forms(benchmark::State& state, const std::string& scheme, double radius) {
  const polytope::SearchFamily family = radius::to_search_family(difference_matrices(scheme));
  const auto one = quadratic::ellipsoidal_coordinates(family, 0, Deadline::in(60));
  double bound = 0;
  for (auto _ : state) {
    quadratic::ContextForms contexts(family, one);
    while (contexts.forms().states() < static_cast<std::size_t>(state.range(0)) && contexts.grow({Deadline::in(600)})) {
    }
    bound = contexts.forms().bound;
  }
  state.counters["above"] = 100 * (bound / radius - 1);
}

/// A tree of 0.1 % more than the radius from 32 contexts: for each word a product and a decomposition, or two.
void BM_product_tree(benchmark::State& state, const std::string& scheme, double radius) {
  const polytope::SearchFamily family = radius::to_search_family(difference_matrices(scheme));
  quadratic::ContextForms contexts(family, quadratic::ellipsoidal_coordinates(family, 0, Deadline::in(60)));
  while (contexts.forms().states() < 32 && contexts.grow({Deadline::in(600)})) {
  }
  std::optional<quadratic::ProductTree> tree;
  for (auto _ : state) tree = quadratic::product_tree(contexts.forms(), 1.001 * radius, {1e12, Deadline::in(600)});
  long words = 0;
  for (const std::string& ends : tree->ends) words += std::ranges::count_if(ends, [](char end) { return end != '+'; });
  state.counters["words"] = static_cast<double>(words);
}
/// From a product to a graph of forms that it keeps, with the proof that it attains the radius.
void BM_kept_product(benchmark::State& state, const std::string& scheme, const std::vector<int>& product) {
  const MatrixFamily family = difference_matrices(scheme);
  const ProductEvidence evidence = prove_product(family, product);
  std::optional<GraphProof> proof;
  for (auto _ : state)
    proof = prove_by_quadratic_forms(family, *evidence.radius.lower, {Deadline::in(60)},
                                     {product, evidence.eigenvalue});
  if (!proof || !proof->attained) return state.SkipWithError("not proved");
  state.counters["words"] = static_cast<double>(proof->words());
}
const bool context_benchmarks = [] {
  benchmark::RegisterBenchmark("BM_kept_product/primal:n=6,d=5", BM_kept_product, "primal:n=6,d=5", std::vector{0})
      ->Unit(benchmark::kSecond);
  benchmark::RegisterBenchmark("BM_kept_product/primal:n=8,d=3", BM_kept_product, "primal:n=8,d=3",
                               std::vector{1, 0, 1, 1, 0, 1, 0, 0})
      ->Unit(benchmark::kSecond)
      ->Iterations(1);
  for (const auto& [scheme, radius] :
       {std::pair{"primal:n=6,d=3", 1.79008312595166}, {"primal:n=8,d=3", 1.44650169078056}})
    benchmark::RegisterBenchmark((std::string("BM_context_forms/") + scheme).c_str(), BM_context_forms, scheme, radius)
        ->Arg(8)
        ->Arg(32)
        ->Arg(128)
        ->Unit(benchmark::kSecond)
        ->Iterations(1);
  benchmark::RegisterBenchmark("BM_product_tree/primal:n=6,d=3", BM_product_tree, "primal:n=6,d=3", 1.79008312595166)
      ->Unit(benchmark::kSecond);
  return true;
}();

/// Two matrices of zeros and ones, as many of each: products, a polytope and the proof that one attains the subradius.
void BM_subradius(benchmark::State& state) {
  std::mt19937_64 engine(1);
  const auto size = static_cast<std::size_t>(state.range(0));
  std::vector<RationalMatrix> matrices(2, RationalMatrix(size, size));
  for (RationalMatrix& matrix : matrices)
    for (std::size_t i = 0; i < size * size; ++i) matrix(i / size, i % size) = static_cast<long>(engine() % 2);
  std::optional<JointSpectralSubradius> found;
  for (auto _ : state) found = joint_spectral_subradius(matrices, {Deadline::in(60)});
  if (!found->exact.is_yes()) return state.SkipWithError("not proved");
  state.counters["vertices"] = static_cast<double>(found->antinorm->vertices.size());
}
BENCHMARK(BM_subradius)->Arg(5)->Arg(10)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);

void BM_single_spectral_radius(benchmark::State& state) {
  const Mask mask = deslauriers_dubuc(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(single_spectral_radius(mask));
}
BENCHMARK(BM_single_spectral_radius)->Arg(5)->Arg(20)->Arg(60)->Unit(benchmark::kMillisecond);

void BM_sum_of_squares(benchmark::State& state) {
  const LaurentPolynomial symbol = single_spectral_radius(deslauriers_dubuc(state.range(0))).symbol;
  for (auto _ : state) benchmark::DoNotOptimize(sum_of_squares(symbol));
}
BENCHMARK(BM_sum_of_squares)->Arg(5)->Arg(20)->Arg(60)->Unit(benchmark::kMillisecond);

void BM_limit_values(benchmark::State& state) {
  const Mask mask = make_scheme("primal:n=" + std::to_string(state.range(0))).mask.curve();
  for (auto _ : state) benchmark::DoNotOptimize(limit_values(mask, static_cast<int>(state.range(1))));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_limit_values)->ArgsProduct({{5, 10, 20, 40}, {0}})->Complexity()->Unit(benchmark::kMillisecond);
BENCHMARK(BM_limit_values)->ArgsProduct({{5}, {4, 6, 8, 10}})->Unit(benchmark::kMillisecond);

void BM_variance_grid(benchmark::State& state) {
  const Mask mask = make_scheme("primal:n=" + std::to_string(state.range(0)) + ",d=3").mask.curve();
  for (auto _ : state) benchmark::DoNotOptimize(variance_grid(mask, 7, true));
}
BENCHMARK(BM_variance_grid)->Arg(3)->Arg(7)->Unit(benchmark::kMillisecond);

/// Maximum, minimum and largest slope of psi to a relative width of 1e-6, and the mean.
void BM_variance_range(benchmark::State& state) {
  const Mask mask = make_scheme("primal:n=" + std::to_string(state.range(0)) + ",d=" + std::to_string(state.range(1)))
                        .mask.curve();
  VarianceRange range;
  for (auto _ : state) range = variance_range(mask);
  state.counters["cells"] = static_cast<double>(range.cells);
  state.counters["slope_width"] = Rational((*range.slope->upper - *range.slope->lower) / *range.slope->upper)
                                      .convert_to<double>();
}
BENCHMARK(BM_variance_range)->ArgsProduct({{5, 20, 40}, {1, 3}})->Unit(benchmark::kMillisecond);

void BM_variance_order(benchmark::State& state) {
  const Mask first = make_scheme("primal:n=" + std::to_string(state.range(0))).mask.curve();
  const Mask second = make_scheme("primal:n=" + std::to_string(state.range(0) - 1)).mask.curve();
  for (auto _ : state) benchmark::DoNotOptimize(compare_variance(first, second));
}
BENCHMARK(BM_variance_order)->Arg(5)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);

void BM_limit_range(benchmark::State& state) {
  const Mask mask = make_scheme("primal:n=" + std::to_string(state.range(0)) + ",d=3").mask.curve();
  for (auto _ : state) benchmark::DoNotOptimize(limit_range(mask));
}
BENCHMARK(BM_limit_range)->Arg(5)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);

}  // namespace
