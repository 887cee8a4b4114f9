#include "product_search.hpp"

#include "decompositions.hpp"
#include "kernels.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

namespace subcert {

namespace {

constexpr double kEqual = 1e-11;
constexpr std::size_t kMaxCandidates = 64;

double spectral_radius(const Eigen::MatrixXd& matrix) {
  if (matrix.isZero(0)) return 0;
  return detail::eigenvalues(matrix).cwiseAbs().maxCoeff();
}

struct Partial {
  std::vector<int> word;
  Eigen::MatrixXd product;  // divided by scale^length
  double norm = 0;          // Frobenius, averaged, of the scaled product
  double bound = 0;         // least averaged norm of the prefixes
  double score = 0;         // averaged estimate of the spectral radius
};

// |tr P^2|^(1/2) is the radius of P up to the weight of the other eigenvalues.
double estimated_radius(const Eigen::MatrixXd& p) { return std::sqrt(std::abs(p.cwiseProduct(p.transpose()).sum())); }

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

}  // namespace

std::vector<int> canonical_word(std::vector<int> word, int letter_count, bool flip_symmetric) {
  const std::size_t n = word.size();
  for (std::size_t period = 1; period < n; ++period) {
    if (n % period != 0) continue;
    bool periodic = true;
    for (std::size_t k = period; k < n && periodic; ++k) periodic = word[k] == word[k - period];
    if (!periodic) continue;
    word.resize(period);
    break;
  }
  std::vector<int> best = least_shift(word);
  if (flip_symmetric) {
    for (int& letter : word) letter = letter_count - 1 - letter;
    best = std::min(best, least_shift(word));
  }
  return best;
}

double product_radius(const std::vector<Eigen::MatrixXd>& matrices, const std::vector<int>& word) {
  if (word.empty()) throw std::invalid_argument("product_radius: need a non-empty word");
  Eigen::MatrixXd product = matrices.at(static_cast<std::size_t>(word.front()));
  double log_scale = 0;
  for (std::size_t k = 1; k < word.size(); ++k) {
    product = matrices.at(static_cast<std::size_t>(word[k])) * product;
    const double norm = product.norm();
    if (norm == 0) return 0;
    product /= norm;
    log_scale += std::log(norm);
  }
  const double radius = spectral_radius(product);
  return radius == 0 ? 0 : std::exp((std::log(radius) + log_scale) / static_cast<double>(word.size()));
}

OrbitShape orbit_shape(const std::vector<Eigen::MatrixXd>& matrices) {
  const Eigen::Index d = matrices.front().rows();
  OrbitShape result;
  Eigen::MatrixXd g = Eigen::MatrixXd::Identity(d, d) / static_cast<double>(d);
  double growth = 0;
  for (int k = 0; k < 60; ++k) {
    Eigen::MatrixXd next = Eigen::MatrixXd::Zero(d, d);
    for (const Eigen::MatrixXd& a : matrices) next.noalias() += a * g * a.transpose();
    const double trace = next.trace();
    if (trace == 0) {
      result.shape = Eigen::MatrixXd::Identity(d, d);
      return result;
    }
    const bool settled = std::abs(trace - growth) < 1e-6 * trace;
    growth = trace;
    g = next / trace;
    if (settled && k > 10) break;
  }
  result.shape = (g + g.transpose()) / 2;
  result.shape.diagonal().array() += 1e-9 / static_cast<double>(d);
  result.radius_bound = std::sqrt(growth);
  return result;
}

std::vector<Candidate> search_products(const SearchFamily& family, const ProductSearchOptions& options) {
  if (family.matrices.empty()) throw std::invalid_argument("search_products: need at least one matrix");
  const auto start = std::chrono::steady_clock::now();
  const int letters = static_cast<int>(family.matrices.size());
  const std::size_t width = static_cast<std::size_t>(std::max(options.width, 1));

  // In the coordinates of the averaged orbit the Frobenius norm says more about the radius.
  const OrbitShape orbit = orbit_shape(family.matrices);
  if (orbit.radius_bound == 0) return {Candidate{{0}, 0.0}};
  const detail::SymmetricDecomposition eigen = detail::symmetric_decomposition(orbit.shape);
  const Eigen::VectorXd root = eigen.values.cwiseMax(1e-14 * eigen.values.maxCoeff()).cwiseSqrt();
  const Eigen::MatrixXd to = root.cwiseInverse().asDiagonal() * eigen.vectors.transpose();
  const Eigen::MatrixXd from = eigen.vectors * root.asDiagonal();
  std::vector<Eigen::MatrixXd> matrices;
  for (const Eigen::MatrixXd& a : family.matrices) matrices.push_back(to * a * from / orbit.radius_bound);

  std::map<std::vector<int>, double> known;
  double best = 0;
  auto record = [&](const Partial& p) {
    std::vector<int> word = canonical_word(p.word, letters, family.flip_symmetric);
    if (known.contains(word)) return;
    double radius = std::pow(spectral_radius(p.product), 1.0 / static_cast<double>(p.word.size()));
    best = std::max(best, radius);
    known.emplace(std::move(word), radius);
  };

  std::vector<Partial> level;
  for (int a = 0; a < letters; ++a) {
    Partial p;
    p.word = {a};
    p.product = matrices[static_cast<std::size_t>(a)];
    p.norm = p.bound = p.product.norm();
    p.score = estimated_radius(p.product);
    record(p);
    level.push_back(std::move(p));
  }
  for (int length = 2; length <= options.max_length && !level.empty(); ++length) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    if (spent.count() > options.seconds) break;
    const double exponent = 1.0 / length;
    std::vector<Partial> next;
    std::set<std::vector<int>> mirrors;
    for (const Partial& parent : level) {
      for (int a = 0; a < letters; ++a) {
        Partial p;
        p.word = parent.word;
        p.word.push_back(a);
        if (family.flip_symmetric) {
          std::vector<int> mirror = p.word;
          for (int& letter : mirror) letter = letters - 1 - letter;
          if (mirrors.contains(mirror)) continue;
          mirrors.insert(p.word);
        }
        p.product.noalias() = matrices[static_cast<std::size_t>(a)] * parent.product;
        p.norm = std::pow(p.product.norm(), exponent);
        p.bound = std::min(parent.bound, p.norm);
        if (p.bound <= best * (1 - options.near)) continue;
        p.score = std::pow(estimated_radius(p.product), exponent);
        next.push_back(std::move(p));
      }
    }
    // Exact radii of the most promising products only.
    std::vector<std::size_t> order(next.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return next[a].score > next[b].score; });
    int solved = 0;
    for (std::size_t k : order) {
      if (solved >= (length <= 8 ? 32 : 8)) break;
      if (next[k].score < best * (1 - options.near)) break;
      const std::size_t before = known.size();
      record(next[k]);
      solved += known.size() > before ? 1 : 0;
    }
    if (next.size() > width) {
      // Half by estimated radius, half by norm.
      std::vector<char> keep(next.size(), 0);
      for (std::size_t k = 0; k < width / 2; ++k) keep[order[k]] = 1;
      std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return next[a].norm > next[b].norm; });
      std::size_t kept = width / 2;
      for (std::size_t k : order) {
        if (kept >= width) break;
        if (keep[k] == 0) ++kept;
        keep[k] = 1;
      }
      std::vector<Partial> narrowed;
      for (std::size_t k = 0; k < next.size(); ++k) {
        if (keep[k] != 0) narrowed.push_back(std::move(next[k]));
      }
      next = std::move(narrowed);
    }
    level = std::move(next);
  }

  std::vector<Candidate> result;
  for (const auto& [word, radius] : known) {
    if (radius >= best * (1 - options.near)) result.push_back({word, radius * orbit.radius_bound});
  }
  const double top = best * orbit.radius_bound;
  std::sort(result.begin(), result.end(), [top](const Candidate& a, const Candidate& b) {
    const bool first = a.radius >= top * (1 - kEqual), second = b.radius >= top * (1 - kEqual);
    if (first != second) return first;
    if (first && a.word.size() != b.word.size()) return a.word.size() < b.word.size();
    return a.radius > b.radius;
  });
  if (result.size() > kMaxCandidates) result.resize(kMaxCandidates);
  return result;
}

}  // namespace subcert
