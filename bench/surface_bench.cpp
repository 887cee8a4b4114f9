// Exponents of vectors of functions, and of surfaces: the largest block of the transition operators with and without
// its symmetry group. Ratios are read within one run.

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/radii/joint/similarity.hpp>
#include <subcert/analysis/radii/polytope_proof/candidate.hpp>
#include <subcert/analysis/radii/quadratic/quadratic_proof.hpp>
#include <subcert/analysis/regularity/gram_function.hpp>
#include <subcert/analysis/regularity/regularity.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/schemes/specification.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>

namespace {

using namespace subcert;

LatticeMask mask_of(const std::string& scheme) { return make_linear_scheme(scheme).mask; }

MatrixFamily largest_block(const std::string& scheme, bool symmetric) {
  const LatticeMask mask = mask_of(scheme);
  const DifferenceSpace space = difference_space(mask, polynomial_reproduction(mask).sum_rules);
  BlockTriangular triangular = block_triangularise(space.family, {});
  if (symmetric) triangular = radius::with_symmetries(std::move(triangular), {});
  const auto largest = std::max_element(triangular.sizes.begin(), triangular.sizes.end());
  return triangular.block(static_cast<std::size_t>(largest - triangular.sizes.begin()));
}

void BM_surface_polytope(benchmark::State& state, const std::string& scheme, bool symmetric) {
  const MatrixFamily family = largest_block(scheme, symmetric);
  radius::PolytopeCandidate candidate;
  for (auto _ : state) candidate = radius::find_polytope(family, {Deadline::in(120)});
  state.counters["dimension"] = static_cast<double>(family.size());
  state.counters["group"] = static_cast<double>(family.group().size());
  state.counters["vertices"] = static_cast<double>(candidate.vertices.size());
  state.counters["closed"] = candidate.closed ? 1 : 0;
}

/// The bound and the words of a quadratic form, as narrow as 20 s and the work of the checker allow; the target 0.
void BM_surface_form(benchmark::State& state, const std::string& scheme, bool symmetric) {
  const MatrixFamily family = largest_block(scheme, symmetric);
  std::optional<GraphProof> proof;
  for (auto _ : state) proof = prove_by_quadratic_forms(family, 0, {Deadline::in(20)});
  state.counters["dimension"] = static_cast<double>(family.size());
  state.counters["group"] = static_cast<double>(family.group().size());
  state.counters["bound"] = proof ? proof->bound.convert_to<double>() : 0;
  state.counters["words"] = proof ? static_cast<double>(proof->words()) : 0;
}

void BM_surface_stability(benchmark::State& state, const std::string& scheme) {
  const LatticeMask mask = mask_of(scheme);
  for (auto _ : state) benchmark::DoNotOptimize(has_stable_shifts(*gram_function(mask)));
}

/// Of a vector of functions: the space of its values, and what its radius tells.
void BM_vector_regularity(benchmark::State& state, const std::string& scheme) {
  const LatticeMask mask = make_refinable_scheme(scheme).mask;
  Regularity found;
  for (auto _ : state) found = regularity_of(mask, {Deadline::in(120)});
  state.counters["dimension"] = static_cast<double>(found.surface->space->family.size());
  state.counters["exact"] = found.exact().is_yes() ? 1 : 0;
}

const bool surface_benchmarks = [] {
  for (const std::string scheme :
       {"ghm", "merrien:lambda=-1/8,mu=1/2", "hermite-dd:points=4,order=2", "hermite-dd:points=6,order=2",
        "hermite-dd:points=4,order=3", "tensor:(hermite-dd:points=2,order=3)x(hermite-dd:points=2,order=3)"})
    benchmark::RegisterBenchmark(("BM_vector_regularity/" + scheme).c_str(), BM_vector_regularity, scheme)
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1);
  for (const std::string scheme : {"quincunx:", "butterfly:w=1/16", "grid:points=3x3,d=2", "grid:points=4x4,d=2",
                                   "grid:points=4x4,d=3", "grid:points=5x5,d=2"}) {
    for (const bool symmetric : {true, false}) {
      const std::string name = scheme + (symmetric ? "/group" : "/none");
      for (const auto& [kind, run] :
           {std::pair{"BM_surface_polytope/", &BM_surface_polytope}, std::pair{"BM_surface_form/", &BM_surface_form}})
        benchmark::RegisterBenchmark((kind + name).c_str(), run, scheme, symmetric)
            ->Unit(benchmark::kMillisecond)
            ->Iterations(1);
    }
    benchmark::RegisterBenchmark(("BM_surface_stability/" + scheme).c_str(), BM_surface_stability, scheme)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
