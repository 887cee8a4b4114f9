#include "product_search.hpp"

#include "decompositions.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>

namespace subcert::polytope {

namespace {

constexpr double equal_radii = 1e-11;  // radii this close are equal: eigenvalues carry some 1e-13
constexpr std::size_t max_candidates = 64;
constexpr double symmetric_tolerance = 1e-12;  // a symmetry may be off by that, relatively
constexpr int short_word = 8;                  // words up to this length are few: more of them are solved exactly
constexpr int solved_short = 32, solved_long = 8;
constexpr double work_in_any_time = 5e6;  // products of numbers, so that more time never tells less
constexpr double work_of_orbit = 120;     // products of matrices, for each letter
constexpr std::size_t most_neighbours = 8;
constexpr double clearly_better = 1e-5;  // relatively: matrices that are nearly the same have long products nearby
constexpr double most_work_of_neighbours = 4e6;  // products of numbers, for each

std::size_t at(int letter) { return static_cast<std::size_t>(letter); }

std::vector<int> least_shift(const std::vector<int>& word) {
  const std::size_t n = word.size();
  std::size_t best = 0;
  for (std::size_t s = 1; s < n; ++s) {
    for (std::size_t k = 0; k < n; ++k) {
      const int a = word[(s + k) % n], b = word[(best + k) % n];
      if (a == b) continue;
      if (a < b) best = s;
      break;
    }
  }
  std::vector<int> shifted(n);
  for (std::size_t k = 0; k < n; ++k) shifted[k] = word[(best + k) % n];
  return shifted;
}

struct Partial {
  std::vector<int> word;
  Matrix product;    // divided by scale^length
  double norm = 0;   // Frobenius, averaged, of the scaled product
  double bound = 0;  // least averaged norm of the prefixes
  double score = 0;  // averaged estimate of the spectral radius
};

// One search, length by length.
class ProductSearch {
 public:
  ProductSearch(const SearchFamily& family, const ProductSearchOptions& options)
      : family_(family),
        options_(options),
        work_of_product_(std::pow(static_cast<double>(family.matrices.front().rows()), 3)),
        orbit_(orbit_shape(family.matrices, is_small() ? Deadline() : options.budget.deadline)) {}

  std::vector<Candidate> run() {
    if (!(orbit_.radius_bound > 0) || !std::isfinite(orbit_.radius_bound)) return {Candidate{{0}, 0.0}};
    begin();
    for (int length = 2; length <= options_.max_length && !level_.empty() && !late(); ++length) {
      std::vector<Partial> next = extensions(length);
      if (late()) break;
      std::vector<std::size_t> order = by_score(next);
      solve_most_promising(next, order, length);
      if (next.size() > width_) narrow(next, order, width_);
      level_ = std::move(next);
    }
    std::vector<Candidate> result;
    for (const auto& [word, radius] : known_)
      if (is_near(radius)) result.push_back({word, radius * orbit_.radius_bound});
    sort_candidates(result, options_.least);
    if (!options_.least && !result.empty()) add_better_neighbours(result, family_);
    if (result.size() > max_candidates) result.resize(max_candidates);
    if (result.empty()) result.push_back({{0}, 0.0});
    return result;
  }

 private:
  bool late() const { return work_ > work_in_any_time && options_.budget.deadline.expired(); }
  bool is_small() const {
    return work_of_orbit * work_of_product_ * static_cast<double>(family_.matrices.size()) <= work_in_any_time;
  }

  // Whether a radius is better than another one.
  bool leads(double radius, double other) const { return options_.least ? radius < other : radius > other; }
  // Whether it is as good as the best, or nearly.
  bool is_near(double radius) const {
    return !leads(best_ * (options_.least ? 1 + options_.near : 1 - options_.near), radius);
  }

  // The exact radius of a product, unless it is known already.
  bool record(const Partial& p) {
    std::vector<int> word = canonical_word(p.word, family_.matrices.size(), family_.symmetry);
    if (known_.contains(word)) return false;
    const double radius = std::pow(spectral_radius(p.product), 1.0 / static_cast<double>(p.word.size()));
    if (!std::isfinite(radius)) return false;
    if (known_.empty() || leads(radius, best_)) best_ = radius;
    return known_.emplace(std::move(word), radius).second;
  }

  void begin() {
    // In the coordinates of the averaged orbit the Frobenius norm says more about the radius.
    const auto [to, from] = whitening(orbit_.shape, 1e-14);
    const std::size_t letters = family_.matrices.size();
    const std::size_t bytes = sizeof(Partial) + at(options_.max_length) * 2 * sizeof(int) +
                              to.entries().size() * sizeof(double);
    // A level and all its extensions are held at a time.
    const std::size_t widest = std::max<std::size_t>(options_.budget.memory / ((letters + 1) * bytes), 1);
    width_ = std::min(widest, at(std::max(options_.width, 1)));
    for (std::size_t a = 0; a < letters && (a == 0 || !late()); ++a) {
      matrices_.push_back(to * family_.matrices[a] * from);
      matrices_.back() /= orbit_.radius_bound;
      Partial p;
      p.word = {static_cast<int>(a)};
      p.product = matrices_[a];
      p.norm = p.bound = norm(p.product.entries());
      p.score = estimated_radius(p.product);
      record(p);
      level_.push_back(std::move(p));
    }
    if (level_.size() > widest) {
      std::vector<std::size_t> order = by_score(level_);
      narrow(level_, order, widest);
    }
  }

  std::vector<std::size_t> by_score(const std::vector<Partial>& partials) const {
    std::vector<std::size_t> order(partials.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return leads(partials[a].score, partials[b].score); });
    return order;
  }

  // All products one letter longer that may still beat the best, one of each orbit of the symmetry.
  std::vector<Partial> extensions(int length) {
    const double exponent = 1.0 / length;
    std::vector<Partial> next;
    std::set<std::vector<int>> seen;
    for (const Partial& parent : level_) {
      if (late()) break;
      for (std::size_t a = 0; a < matrices_.size(); ++a) {
        Partial p;
        p.word = parent.word;
        p.word.push_back(static_cast<int>(a));
        bool mirrored = false;
        for (int g = 1; g < family_.symmetry.order() && !mirrored; ++g)
          mirrored = seen.contains(family_.symmetry.word(g, p.word, matrices_.size()));
        if (mirrored) continue;
        if (family_.symmetry.order() > 1) seen.insert(p.word);
        p.product = matrices_[a] * parent.product;
        work_ += work_of_product_;
        p.norm = std::pow(norm(p.product.entries()), exponent);
        p.bound = std::min(parent.bound, p.norm);
        if (!options_.least && p.bound <= best_ * (1 - options_.near)) continue;
        p.score = std::pow(estimated_radius(p.product), exponent);
        next.push_back(std::move(p));
      }
    }
    return next;
  }

  void solve_most_promising(const std::vector<Partial>& next, const std::vector<std::size_t>& order, int length) {
    int solved = 0;
    for (const std::size_t k : order) {
      if (solved >= (length <= short_word ? solved_short : solved_long) || late()) break;
      if (!options_.least && !is_near(next[k].score)) break;
      if (record(next[k])) ++solved;
    }
  }

  // Keeps `width` of them: half by estimated radius, which is what `order` goes by, half by norm.
  void narrow(std::vector<Partial>& next, std::vector<std::size_t>& order, std::size_t width) const {
    std::vector<char> keep(next.size(), 0);
    for (std::size_t k = 0; k < width / 2; ++k) keep[order[k]] = 1;
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return leads(next[a].norm, next[b].norm); });
    std::size_t kept = width / 2;
    for (const std::size_t k : order) {
      if (kept >= width) break;
      if (keep[k] == 0) ++kept;
      keep[k] = 1;
    }
    std::vector<Partial> narrowed;
    narrowed.reserve(width);
    for (std::size_t k = 0; k < next.size(); ++k) {
      if (keep[k] != 0) narrowed.push_back(std::move(next[k]));
    }
    next = std::move(narrowed);
  }

  const SearchFamily& family_;
  const ProductSearchOptions& options_;
  double work_of_product_, work_ = 0;
  OrbitShape orbit_;
  std::vector<Matrix> matrices_;
  std::size_t width_ = 1;
  std::vector<Partial> level_;
  std::map<std::vector<int>, double> known_;
  double best_ = 0;
};

}  // namespace

bool is_finite(const SearchFamily& family) {
  return std::ranges::all_of(family.matrices, [](const Matrix& a) { return is_finite(a); });
}

bool has_symmetry(const SearchFamily& family) {
  const std::size_t m = family.matrices.size();
  for (int g = 1; g < family.symmetry.order(); ++g)
    for (std::size_t i = 0; i < m; ++i) {
      const Matrix& a = family.matrices[i];
      Matrix difference = family.symmetry.conjugated(g, a);
      difference /= -1;
      difference += family.matrices[at(family.symmetry.letter(g, static_cast<int>(i), m))];
      const double most = symmetric_tolerance * std::max(1.0, a.largest_modulus()) * family.symmetry.condition(g);
      if (!(difference.largest_modulus() <= most)) return false;
    }
  return true;
}

std::vector<int> without_repetitions(std::vector<int> word) {
  const std::size_t n = word.size();
  for (std::size_t period = 1; period < n; ++period) {
    if (n % period != 0) continue;
    bool periodic = true;
    for (std::size_t k = period; k < n && periodic; ++k) periodic = word[k] == word[k - period];
    if (!periodic) continue;
    word.resize(period);
    break;
  }
  return word;
}

std::vector<int> canonical_word(std::vector<int> word, std::size_t letter_count, const SymmetryGroup& symmetry) {
  word = without_repetitions(std::move(word));
  std::vector<int> best = least_shift(word);
  for (int g = 1; g < symmetry.order(); ++g) best = std::min(best, least_shift(symmetry.word(g, word, letter_count)));
  return best;
}

std::size_t sort_candidates(std::vector<Candidate>& candidates, bool least) {
  double top = least ? std::numeric_limits<double>::infinity() : 0;
  for (const Candidate& c : candidates) top = least ? std::min(top, c.radius) : std::max(top, c.radius);
  const auto leads = [=](const Candidate& c) {
    return least ? c.radius <= top * (1 + equal_radii) : c.radius >= top * (1 - equal_radii);
  };
  std::sort(candidates.begin(), candidates.end(), [&](const Candidate& a, const Candidate& b) {
    if (leads(a) != leads(b)) return leads(a);
    if (leads(a) && a.word.size() != b.word.size()) return a.word.size() < b.word.size();
    return least ? a.radius < b.radius : a.radius > b.radius;
  });
  return static_cast<std::size_t>(std::count_if(candidates.begin(), candidates.end(), leads));
}

namespace {

std::optional<Candidate> better_neighbour(const SearchFamily& family, const std::vector<Candidate>& candidates) {
  const Candidate& first = candidates.front();
  const std::size_t length = first.word.size(), size = family.matrices.front().rows();
  const auto is_cheap = [&](std::size_t products) {
    return static_cast<double>(products * size * size * size) <= most_work_of_neighbours;
  };
  if (!(first.radius > 0) || !is_cheap(length * length)) return std::nullopt;
  Candidate best{{}, first.radius * (1 + clearly_better)};
  const auto look_at = [&](const Matrix& product, const std::vector<int>& word) {  // over the power of the radius
    const double least = std::pow(best.radius / first.radius, static_cast<double>(word.size()));
    if (estimated_radius(product) < least) return;
    const double radius = product_radius(family.matrices, word);
    if (radius > best.radius) best = {word, radius};
  };
  // The words from each of their letters on, with their products; shorter ones on the way.
  const auto turns = [&](const Candidate& candidate, bool parts) {
    std::vector<std::pair<std::vector<int>, Matrix>> result;
    for (std::size_t start = 0; start < candidate.word.size(); ++start) {
      auto& [word, product] = result.emplace_back(std::vector<int>{}, Matrix::identity(size));
      while (word.size() < candidate.word.size()) {
        if (parts && !word.empty()) look_at(product, word);
        word.push_back(candidate.word[(start + word.size()) % candidate.word.size()]);
        product = family.matrices[at(word.back())] * product;
        product /= first.radius;
      }
    }
    return result;
  };
  const auto own = turns(first, true);
  for (std::size_t k = 1; k < std::min(candidates.size(), most_neighbours); ++k) {
    const std::size_t other = candidates[k].word.size();
    if (!is_cheap(other * (length + other))) continue;
    for (const auto& [end, last] : turns(candidates[k], false))
      for (const auto& [start, product] : own) {
        std::vector<int> word = start;
        word.insert(word.end(), end.begin(), end.end());
        look_at(last * product, word);
      }
  }
  if (best.word.empty()) return std::nullopt;
  best.word = canonical_word(best.word, family.matrices.size(), family.symmetry);
  return best;
}

}  // namespace

void add_better_neighbours(std::vector<Candidate>& candidates, const SearchFamily& family) {
  while (auto better = better_neighbour(family, candidates)) candidates.insert(candidates.begin(), *std::move(better));
}

double estimated_radius(const Matrix& product) {
  double trace = 0;
  for (std::size_t j = 0; j < product.columns(); ++j)
    for (std::size_t i = 0; i < product.rows(); ++i) trace += product(i, j) * product(j, i);
  return std::sqrt(std::abs(trace));
}

double product_radius(const std::vector<Matrix>& matrices, const std::vector<int>& word) {
  require(!word.empty(), "product_radius: need a non-empty word, got one of length {}", word.size());
  Matrix product = matrices.at(at(word.front()));
  double log_scale = 0;
  for (std::size_t k = 1; k < word.size(); ++k) {
    product = matrices.at(at(word[k])) * product;
    const double size = norm(product.entries());
    if (size == 0) return 0;
    product /= size;
    log_scale += std::log(size);
  }
  const double radius = spectral_radius(product);
  return radius == 0 ? 0 : std::exp((std::log(radius) + log_scale) / static_cast<double>(word.size()));
}

OrbitShape orbit_shape(const std::vector<Matrix>& matrices, const Deadline& deadline) {
  const std::size_t d = matrices.front().rows();
  OrbitShape result;
  Matrix g = Matrix::identity(d);
  g /= static_cast<double>(d);
  double growth = 0;
  bool complete = true;
  for (int k = 0; k < 60 && complete; ++k) {
    Matrix next(d, d);
    for (const Matrix& a : matrices) {
      complete = complete && !deadline.expired();
      if (complete) next += a * g * a.transposed();
    }
    if (!complete) break;
    double trace = 0;
    for (std::size_t i = 0; i < d; ++i) trace += next(i, i);
    if (trace == 0 && next.is_zero()) return {Matrix::identity(d), 0};
    complete = trace > 0 && std::isfinite(trace);
    result.lost = !complete;
    if (!complete) break;
    const bool settled = std::abs(trace - growth) < 1e-6 * trace;
    growth = trace;
    g = std::move(next);
    g /= trace;
    if (settled && k > 10) break;
  }
  result.shape = g;
  result.shape += g.transposed();
  result.shape /= 2;
  for (std::size_t i = 0; i < d; ++i) result.shape(i, i) += resolved_share / static_cast<double>(d);
  if (!complete) {  // rho <= max |A_i|
    growth = 0;
    for (const Matrix& a : matrices) growth = std::max(growth, std::pow(norm(a.entries()), 2));
  }
  result.radius_bound = std::sqrt(growth);
  return result;
}

Whitening whitening(const Matrix& shape, double least) {
  const SymmetricDecomposition eigen = symmetric_decomposition(shape);
  const std::size_t n = eigen.values.size();
  const double floor = least * *std::max_element(eigen.values.begin(), eigen.values.end());
  Whitening result{Matrix(n, n), Matrix(n, n)};
  for (std::size_t i = 0; i < n; ++i) {
    const double root = std::sqrt(std::max(eigen.values[i], floor));
    const double inverse = 1 / root;
    for (std::size_t j = 0; j < n; ++j) {
      result.to(i, j) = inverse * eigen.vectors(j, i);
      result.from(j, i) = eigen.vectors(j, i) * root;
    }
  }
  return result;
}

std::vector<Candidate> search_products(const SearchFamily& family, const ProductSearchOptions& options) {
  require(!family.matrices.empty(), "search_products: need at least one matrix, got {}", family.matrices.size());
  return ProductSearch(family, options).run();
}

}  // namespace subcert::polytope
