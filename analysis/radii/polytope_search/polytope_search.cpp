#include "polytope_search.hpp"

#include "polytope_run.hpp"

#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace subcert::polytope {

namespace {

constexpr std::size_t max_maximizing = 12;  // products that roots are made of; more are shifts of a continuum of them

// A polytope that closes mostly does so within a small multiple of the first look at the products; one that does not
// gets a wider look for a better product, and more time each round.
constexpr double first_patience = 20, later_patience = 30;
// Small extra vertices need fewer others. Some polytopes close with large ones alone, or with a little more than the
// radius after half as many vertices.
constexpr double small_reach = 0.3, large_reach = 0.9;
constexpr double clearly_ahead = 0.6;  // ratio of the shares of open images
constexpr double no_limit = std::numeric_limits<double>::infinity();

// What a look for products costs: a multiplication of matrices for each product of so many letters as are usual.
constexpr double seconds_per_product = 2e-9;  // of numbers
constexpr int usual_length = 40;

// Descending tolerance: by what the radius is exceeded at first, and how it falls.
constexpr double first_excess = 0.1, excess_factor = 0.4;
constexpr double third_excess = 6e-4;  // encloses the logarithm to base 2 within 1e-3
constexpr int excess_count = 28;       // the last is below the rounding of the radius
constexpr double inner_share = 0.1;    // of the excess, by which images are to be inside

void check(const SearchFamily& family, const SearchOptions& options) {
  require(!family.matrices.empty(), "search_polytope: need at least one matrix, got {}", family.matrices.size());
  const std::size_t d = family.matrices.front().rows();
  require(d >= 1, "search_polytope: need dimension >= 1, got {}", d);
  for (const Matrix& a : family.matrices) {
    require(a.rows() == d && a.columns() == d, "search_polytope: need square matrices of one size {}, got {} x {}", d,
            a.rows(), a.columns());
  }
  require(options.tolerance > 0 && options.tolerance < 1e-2, "search_polytope: need 0 < tolerance < 1e-2, got {}",
          options.tolerance);
}

std::size_t bytes_of(const SearchResult& result) {
  std::size_t bytes = 0;
  for (const Vertex& v : result.vertices) bytes += sizeof v + v.value.size() * sizeof v.value.front();
  for (const VertexImage& i : result.images) bytes += sizeof i + i.terms.capacity() * sizeof i.terms.front();
  return bytes;
}

class Search {
 public:
  Search(const SearchFamily& family, const SearchOptions& options)
      : options_(options),
        seconds_(options.budget.deadline.remaining()),
        races_(Deadline::in(schedule::polytope::races * seconds_)) {
    family_[0] = family_[1] = family;
    for (Matrix& a : family_[1].matrices) a = a.transposed();
    family_[1].symmetry = family.symmetry.transposed();
  }

  SearchResult run() {
    look_for_products(product_looks[0], schedule::polytope::first_products);
    if (candidates_.front().radius == 0) return vanishing();
    if (!options_.exact) return enclosed();
    if (race(std::min(schedule::polytope::least_race + first_patience * work_,
                      schedule::polytope::first_race * seconds_),
             1))
      return closed();
    const double before = work_;
    look_for_products(product_looks[1], schedule::polytope::later_products);
    double patience = std::min(schedule::polytope::least_race + later_patience * (work_ - before), left_for_races());
    if (forms_follow()) {
      if (race(schedule::polytope::early_race * patience, 2)) return closed();
      look_for_more_products();
      patience *= 1 - schedule::polytope::early_race;
    }
    if (race(patience, 2) ||
        race_with_large_extras(schedule::polytope::large_extras * schedule::polytope::races * seconds_))
      return closed();
    if (work_ > schedule::polytope::last_look * seconds_ || races_.expired() || full()) return enclosed();
    look_for_products(product_looks[2], schedule::polytope::later_products);
    return race((forms_follow() ? schedule::polytope::last_race : 1) * left_for_races(), 2) ? closed() : enclosed();
  }

 private:
  const Deadline& deadline() const { return options_.budget.deadline; }
  // Who has other products has forms.
  bool forms_follow() const { return static_cast<bool>(options_.more_products); }
  // Products get a quarter of the memory, polytopes the rest.
  std::size_t memory_of_products() const { return options_.budget.memory / 4; }
  std::size_t memory_of_polytopes() const { return options_.budget.memory - memory_of_products(); }

  double left_for_races() const { return schedule::polytope::races * seconds_ - work_; }
  bool full() const { return runs_[0] && runs_[1] && runs_[0]->full() && runs_[1]->full(); }

  // Looks for products and gives up what is built on a worse one.
  void look_for_products(const ProductLook& look, double share) {
    ProductSearchOptions options;
    options.max_length = std::min(look.length, longest_product);
    options.width = look.width;
    options.budget = {races_.at_most(share * seconds_), memory_of_products()};
    take(search_products(family_[0], options));
    const double d = static_cast<double>(family_[0].matrices.front().rows());
    work_ += seconds_per_product * d * d * d * static_cast<double>(family_[0].matrices.size()) * options.width *
             std::min(options.max_length, usual_length);
  }

  void look_for_more_products() {
    const Deadline end = races_.at_most(schedule::polytope::later_products * seconds_);
    const double seconds = end.remaining();
    take(options_.more_products(family_[0], candidates_.front().radius, {end, memory_of_products()}));
    work_ += seconds - end.remaining();
  }

  void take(std::vector<Candidate> found) {
    for (const Candidate& c : candidates_) {
      if (std::none_of(found.begin(), found.end(), [&c](const Candidate& f) { return f.word == c.word; })) {
        found.push_back(c);
      }
    }
    const std::vector<Candidate> old = maximizing();
    sort_candidates(found);
    add_better_neighbours(found, family_[0]);
    maximizing_ = std::min(sort_candidates(found), max_maximizing);
    candidates_ = std::move(found);
    if (std::ranges::equal(old, maximizing(), {}, &Candidate::word, &Candidate::word)) return;
    for (auto& run : runs_) run.reset();
  }

  std::vector<Candidate> maximizing() const {
    return {candidates_.begin(), candidates_.begin() + static_cast<std::ptrdiff_t>(maximizing_)};
  }

  PolytopeKind kind() const {
    const auto& matrices = family_[0].matrices;
    const auto is_nonnegative = [](const Matrix& a) {
      return std::all_of(a.entries().begin(), a.entries().end(), [](double entry) { return entry >= 0; });
    };
    if (options_.cones && !family_[0].symmetry.is_dense() &&
        std::all_of(matrices.begin(), matrices.end(), is_nonnegative))
      return PolytopeKind::nonnegative;
    for (const RootCycle& cycle : leading_cycles(matrices, maximizing(), 1e-10, deadline())) {
      if (std::abs(cycle.phase.imag()) > 1e-9) return PolytopeKind::complex;
    }
    return PolytopeKind::real;
  }

  std::unique_ptr<PolytopeRun> start(std::size_t side, double scale, PolytopeKind kind, std::size_t memory) {
    std::vector<Candidate> products = maximizing();
    if (side == 1) {
      for (Candidate& c : products) c = c.transposed();
    }
    SearchOptions options = options_;
    options.budget.memory = memory;
    return std::make_unique<PolytopeRun>(family_[side], std::move(products), kind, scale, reach_, options);
  }

  // Whether the run of that side is clearly nearer to its end, judged by the share of its images that are still open.
  bool is_ahead(std::size_t side) const {
    return runs_[0] && runs_[1] && runs_[side]->open_share() < clearly_ahead * runs_[1 - side]->open_share();
  }

  // Advances the family, or the family and its transpose in turn, by slices that grow; true when one closes.
  bool race(double seconds, std::size_t sides) {
    const double end = work_ + seconds;
    const auto left = [&] { return races_.expired() ? 0 : end - work_; };
    const auto first_slice = [&] {
      return std::clamp(left() / 64, schedule::polytope::least_slice, schedule::polytope::largest_slice);
    };
    double slice = sides == 1 ? seconds : first_slice();
    for (int round = 0; left() > 0 && !full(); ++round) {
      // Every fourth round the one behind gets its turn as well.
      const bool all = round % 4 == 3;
      const std::size_t skipped = all ? 2 : is_ahead(0) ? 1 : is_ahead(1) ? 0 : 2;
      for (std::size_t side = 0; side < sides && left() > 0; ++side) {
        if (sides == 2 && side == skipped) continue;
        auto& run = runs_[side];
        if (!run) run = start(side, candidates_.front().radius, kind(), memory_of_polytopes() / 2);
        const double before = run->work();
        const bool closes = run->advance(std::min(slice, left()), races_) == PolytopeRun::State::closed;
        work_ += run->work() - before;
        if (closes) {
          winner_ = side;
          return true;
        }
        if (take_better_product(side)) {
          slice = first_slice();
          break;
        }
      }
      if (sides == 1 && runs_[0]) break;
      slice *= 1.5;
    }
    return false;
  }

  // A race of other polytopes, after which those so far go on.
  bool race_with_large_extras(double seconds) {
    if (kind() != PolytopeKind::real) return false;
    const std::vector<Candidate> before = maximizing();
    std::unique_ptr<PolytopeRun> others[2];
    for (std::size_t side : {0, 1}) std::swap(runs_[side], others[side]);
    reach_ = large_reach;
    const bool closes = race(seconds, 2);
    reach_ = small_reach;
    if (closes) return true;
    const bool same = std::ranges::equal(before, maximizing(), {}, &Candidate::word, &Candidate::word);
    for (std::size_t side : {0, 1}) {
      runs_[side].reset();
      if (same) std::swap(runs_[side], others[side]);
    }
    return false;
  }

  bool take_better_product(std::size_t side) {
    std::optional<Candidate> better = runs_[side]->better_product(candidates_.front().radius);
    if (!better) return false;
    if (side == 1) {
      better->word = canonical_word(better->written(), family_[0].matrices.size(), family_[0].symmetry);
    }
    take({*better});
    return true;
  }

  double radius_bound() const { return orbit_shape(family_[0].matrices, deadline()).radius_bound; }

  SearchResult vanishing() {
    SearchResult result;
    result.products = {candidates_.front()};
    result.maximizing = 1;
    result.upper_bound = radius_bound();
    result.closed = result.upper_bound == 0;
    return result;
  }

  SearchResult closed() {
    PolytopeRun& run = *runs_[winner_];
    runs_[1 - winner_].reset();
    run.finish(deadline());
    SearchResult result;
    std::move(run).report(result);
    result.transposed = winner_ == 1;
    return result;
  }

  // Images divided by (1 + excess) radius, the excess smaller as long as time and memory last. Forms enclose better.
  SearchResult enclosed() {
    const Deadline end = forms_follow() ? deadline().at_most((1 - schedule::polytope::races) * seconds_) : deadline();
    SearchResult best;
    const double radius = candidates_.front().radius;
    const std::size_t side = runs_[0] && runs_[1] && runs_[1]->open_share() < runs_[0]->open_share() ? 1 : 0;
    for (auto& run : runs_) run.reset();
    reach_ = large_reach;
    // No image needs to come back to a vertex any more, so that real polytopes do for complex eigenvalues.
    const PolytopeKind simple = kind() == PolytopeKind::nonnegative ? PolytopeKind::nonnegative : PolytopeKind::real;
    double excess = first_excess;
    for (int k = 0; k < excess_count && !end.expired(); ++k, excess *= excess_factor) {
      if (k == 3) excess = third_excess;
      const std::size_t held = std::min(bytes_of(best), memory_of_polytopes());
      // An image that is inside by less than the excess need not become a vertex: it would by the radius itself.
      options_.tolerance = std::min(options_.tolerance, inner_share * excess);
      auto run = start(side, radius * (1 + excess), simple, memory_of_polytopes() - held);
      if (run->advance(no_limit, end) != PolytopeRun::State::closed) break;
      run->finish(end.after(schedule::polytope::enclosing_proof));
      std::move(*run).report(best);
      best.transposed = side == 1;
    }
    best.closed = false;
    best.radius = radius;
    if (best.products.empty()) {
      best.products = maximizing();
      best.maximizing = maximizing_;
    }
    best.upper_bound = std::min(best.upper_bound, radius_bound() * (1 + 1e-6));
    return best;
  }

  SearchOptions options_;
  double seconds_;
  Deadline races_;          // of looks for products, too: what is left is for enclosing
  double work_ = 0;         // what decides whose turn it is, in place of a clock: PolytopeRun::work
  SearchFamily family_[2];  // as given, transposed
  std::vector<Candidate> candidates_;
  std::size_t maximizing_ = 0;
  std::unique_ptr<PolytopeRun> runs_[2];
  double reach_ = small_reach;
  std::size_t winner_ = 0;
};

}  // namespace

SearchResult search_polytope(const SearchFamily& family, const SearchOptions& options) {
  check(family, options);
  if (!is_finite(family)) {
    SearchResult nothing;
    nothing.products = {Candidate{{0}, 0.0}};
    nothing.maximizing = 1;
    return nothing;
  }
  if (!has_symmetry(family)) return Search({family.matrices, {}}, options).run();
  return Search(family, options).run();
}

}  // namespace subcert::polytope
