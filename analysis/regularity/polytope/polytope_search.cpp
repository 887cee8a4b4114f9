#include "polytope_search.hpp"

#include "polytope_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace subcert {

namespace {

using detail::PolytopeRun;
using Clock = std::chrono::steady_clock;

constexpr double kEqualRadius = 1e-11;

void check(const SearchFamily& family, const SearchOptions& options) {
  const auto fail = [](const std::string& what) { throw std::invalid_argument("search_polytope: " + what); };
  if (family.matrices.empty()) fail("need at least one matrix");
  const Eigen::Index d = family.matrices.front().rows();
  if (d < 1) fail("need dimension >= 1");
  for (const Eigen::MatrixXd& a : family.matrices) {
    if (a.rows() != d || a.cols() != d) fail("need square matrices of one size");
    if (!a.allFinite()) fail("need finite entries");
  }
  if (family.flip_symmetric) {
    const std::size_t m = family.matrices.size();
    for (std::size_t i = 0; i < m; ++i) {
      const Eigen::MatrixXd& a = family.matrices[i];
      if (!(a.reverse() - family.matrices[m - 1 - i]).isZero(1e-12 * std::max(1.0, a.cwiseAbs().maxCoeff()))) {
        fail("need J A_i J = A_{m-1-i} for a flip symmetric family");
      }
    }
  }
  if (!(options.seconds > 0)) fail("need seconds > 0");
  if (!(options.tolerance > 0 && options.tolerance < 1e-2)) fail("need 0 < tolerance < 1e-2");
  if (options.max_product_length < 1) fail("need max_product_length >= 1");
}

class Search {
 public:
  Search(const SearchFamily& family, const SearchOptions& options) : options_(options), start_(Clock::now()) {
    family_[0] = family_[1] = family;
    for (Eigen::MatrixXd& a : family_[1].matrices) a.transposeInPlace();
  }

  SearchResult run() {
    SearchResult result;
    look_for_products({std::min(12, options_.max_product_length), 12, options_.seconds / 4, 5e-3});
    const double first_look = elapsed();
    if (candidates_.front().radius == 0) return vanishing();
    if (race(std::min(0.1 + 20 * first_look, 0.6 * options_.seconds), false)) return closed();
    for (int width : {32, 200}) {
      look_for_products({options_.max_product_length, width, options_.seconds / 8, 5e-3});
      const double patience = width == 200 ? 0.65 * options_.seconds - elapsed() : 60 * elapsed();
      if (race(std::min(patience, 0.65 * options_.seconds - elapsed()), true)) return closed();
      if (elapsed() > 0.5 * options_.seconds || full()) break;
    }
    return enclosed();
  }

 private:
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  double left() const { return options_.seconds - elapsed(); }

  bool full() const {
    return runs_[0] && runs_[1] && runs_[0]->size() >= options_.max_vertices &&
           runs_[1]->size() >= options_.max_vertices;
  }

  // Looks for products and gives up what is built on a worse one.
  void look_for_products(const ProductSearchOptions& options) { take(search_products(family_[0], options)); }

  void take(std::vector<Candidate> found) {
    const double before = candidates_.empty() ? 0 : candidates_.front().radius;
    for (const Candidate& c : candidates_) {
      if (std::none_of(found.begin(), found.end(), [&c](const Candidate& f) { return f.word == c.word; })) {
        found.push_back(c);
      }
    }
    double top = 0;
    for (const Candidate& c : found) top = std::max(top, c.radius);
    std::sort(found.begin(), found.end(), [top](const Candidate& a, const Candidate& b) {
      const bool first = a.radius >= top * (1 - kEqualRadius), second = b.radius >= top * (1 - kEqualRadius);
      if (first != second) return first;
      if (first && a.word.size() != b.word.size()) return a.word.size() < b.word.size();
      return a.radius > b.radius;
    });
    std::size_t maximizing = 0;
    while (maximizing < found.size() && found[maximizing].radius >= top * (1 - kEqualRadius)) ++maximizing;
    maximizing = std::min<std::size_t>(maximizing, 12);
    std::vector<Candidate> old(candidates_.begin(), candidates_.begin() + static_cast<std::ptrdiff_t>(maximizing_));
    candidates_ = std::move(found);
    maximizing_ = maximizing;
    bool same = old.size() == maximizing_;
    for (std::size_t k = 0; k < maximizing_ && same; ++k) same = old[k].word == candidates_[k].word;
    if (same) return;
    if (before > 0) ++counters_.restarts;
    for (auto& run : runs_) retire(run);
  }

  void retire(std::unique_ptr<PolytopeRun>& run) {
    if (run) run->count(counters_);
    run.reset();
  }

  PolytopeKind kind() const {
    const auto& matrices = family_[0].matrices;
    if (std::all_of(matrices.begin(), matrices.end(), [](const auto& a) { return a.minCoeff() >= 0; })) {
      return PolytopeKind::nonnegative;
    }
    const std::vector<Candidate> products(candidates_.begin(),
                                          candidates_.begin() + static_cast<std::ptrdiff_t>(maximizing_));
    for (const detail::RootCycle& cycle : detail::leading_cycles(matrices, products, 1e-10)) {
      if (std::abs(cycle.phase.imag()) > 1e-9) return PolytopeKind::complex;
    }
    return PolytopeKind::real;
  }

  std::unique_ptr<PolytopeRun> start(int side, double scale, PolytopeKind kind) {
    ++counters_.runs;
    std::vector<Candidate> products(candidates_.begin(),
                                    candidates_.begin() + static_cast<std::ptrdiff_t>(maximizing_));
    if (side == 1) {
      for (Candidate& c : products) std::reverse(c.word.begin(), c.word.end());
    }
    return std::make_unique<PolytopeRun>(family_[side], std::move(products), maximizing_, kind, scale, options_);
  }

  // The side that is clearly nearer to its end, judged by the share of its images that are still outside, or -1.
  int side_ahead() const {
    if (!runs_[0] || !runs_[1]) return -1;
    const double a = runs_[0]->open_share(), b = runs_[1]->open_share();
    if (a < 0.6 * b) return 0;
    return b < 0.6 * a ? 1 : -1;
  }

  // Advances the family and its transpose in turn by slices that grow; true when one closes.
  bool race(double seconds, bool both) {
    const double begin = elapsed();
    double slice = both ? std::max(0.02, seconds / 64) : seconds;
    for (int round = 0; elapsed() - begin < seconds && !full(); ++round) {
      const int ahead = round % 4 == 3 ? -1 : side_ahead();
      for (int side = 0; side < (both ? 2 : 1); ++side) {
        if (both && ahead == 1 - side) continue;
        auto& run = runs_[side];
        if (!run) run = start(side, candidates_.front().radius, kind());
        const double share = std::min(slice, begin + seconds - elapsed());
        if (share <= 0) break;
        if (run->advance(share, options_.max_vertices) == PolytopeRun::State::closed) {
          winner_ = side;
          return true;
        }
        std::optional<Candidate> better = run->better_product(candidates_.front().radius);
        if (better) {
          if (side == 1) {
            std::reverse(better->word.begin(), better->word.end());
            better->word = canonical_word(better->word, static_cast<int>(family_[0].matrices.size()),
                                          family_[0].flip_symmetric);
          }
          take({*better});
          slice = std::max(0.02, (begin + seconds - elapsed()) / 64);
          break;
        }
      }
      if (!both && runs_[0]) break;
      slice *= 1.5;
    }
    return false;
  }

  SearchResult vanishing() {
    SearchResult result;
    result.products = {candidates_.front()};
    result.maximizing = 1;
    result.upper_bound = detail_vanishing_bound();
    result.status = result.upper_bound == 0 ? SearchStatus::closed : SearchStatus::budget_spent;
    result.counters = counters_;
    result.counters.seconds = elapsed();
    return result;
  }

  double detail_vanishing_bound() const { return orbit_shape(family_[0].matrices).radius_bound; }

  SearchResult deliver(PolytopeRun& run, bool transposed) {
    SearchResult result;
    run.report(result);
    result.transposed = transposed;
    for (auto& r : runs_) {
      if (r) r->count(counters_);
    }
    counters_.vertices = run.size();
    result.counters = counters_;
    result.counters.seconds = elapsed();
    return result;
  }

  SearchResult closed() {
    PolytopeRun& run = *runs_[winner_];
    run.finish(std::max(left(), 0.5 * elapsed()));
    return deliver(run, winner_ == 1);
  }

  // Descending tolerance: images divided by (1 + eps) radius, eps smaller as long as time lasts.
  SearchResult enclosed() {
    SearchResult best;
    const double radius = candidates_.front().radius;
    const int side = runs_[1] && runs_[0] && runs_[1]->open_share() < runs_[0]->open_share() ? 1 : 0;
    for (auto& run : runs_) retire(run);
    // No image needs to come back to a vertex any more, so that real polytopes do for complex eigenvalues.
    const PolytopeKind simple = kind() == PolytopeKind::nonnegative ? PolytopeKind::nonnegative : PolytopeKind::real;
    double eps = 0.1;
    for (int k = 0; k < 24 && left() > 0; ++k, eps *= 0.4) {
      if (k == 3) eps = 6e-4;  // encloses the logarithm to base 2 within 1e-3
      auto run = start(side, radius * (1 + eps), simple);
      if (run->advance(left(), options_.max_vertices) != PolytopeRun::State::closed) break;
      run->finish(left() / 2);
      run->count(counters_);
      run->report(best);
      best.transposed = side == 1;
      counters_.vertices = run->size();
    }
    best.status = SearchStatus::budget_spent;
    best.radius = radius;
    if (best.products.empty()) best.products = {candidates_.front()};
    best.upper_bound = std::min(best.upper_bound, orbit_shape(family_[0].matrices).radius_bound * (1 + 1e-6));
    best.counters = counters_;
    best.counters.seconds = elapsed();
    return best;
  }

  SearchOptions options_;
  Clock::time_point start_;
  SearchFamily family_[2];  // as given, transposed
  std::vector<Candidate> candidates_;
  std::size_t maximizing_ = 0;
  std::unique_ptr<PolytopeRun> runs_[2];
  int winner_ = 0;
  SearchCounters counters_;
};

}  // namespace

SearchResult search_polytope(const SearchFamily& family, const SearchOptions& options) {
  check(family, options);
  return Search(family, options).run();
}

}  // namespace subcert
