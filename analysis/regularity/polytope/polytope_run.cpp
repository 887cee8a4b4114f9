#include "polytope_run.hpp"

#include "decompositions.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

namespace subcert::detail {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kComfortable = 1e-4;  // images this far inside are not looked at again
constexpr double kSame = 1e-8;         // an image this close to a vertex is that vertex
constexpr double kExtraSize = 0.02;    // size of vertices added only to span the space
constexpr double kExtraReach = 0.3;    // how far orbits of extra vertices come towards the faces at the roots

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// x' = to x turns the symmetric positive definite block into the identity.
void whiten(const Eigen::MatrixXd& shape, Eigen::MatrixXd& to, Eigen::MatrixXd& from) {
  const SymmetricDecomposition eigen = symmetric_decomposition(shape);
  const Eigen::VectorXd root = eigen.values.cwiseMax(1e-12 * eigen.values.maxCoeff()).cwiseSqrt();
  to = root.cwiseInverse().asDiagonal() * eigen.vectors.transpose();
  from = eigen.vectors * root.asDiagonal();
}

Eigen::VectorXcd mirrored(Eigen::VectorXcd x, PolytopeKind kind, int odd) {
  if (kind == PolytopeKind::nonnegative) return x.reverse();
  x.tail(odd) *= -1;
  return x;
}

// Mirror images as the polytope counts them: u and, under flip symmetry, J u.
std::vector<Eigen::VectorXcd> with_mirror_images(const std::vector<Eigen::VectorXcd>& vectors, bool flip,
                                                 PolytopeKind kind, int odd) {
  std::vector<Eigen::VectorXcd> result = vectors;
  if (!flip) return result;
  for (const Eigen::VectorXcd& u : vectors) result.push_back(mirrored(u, kind, odd));
  return result;
}

// The largest modulus on x of the dual vectors and, where points are complex, of their conjugates.
double largest_value(const std::vector<Eigen::VectorXcd>& duals, PolytopeKind kind, const Eigen::VectorXcd& x) {
  double largest = 0;
  for (const Eigen::VectorXcd& u : duals) {
    largest = std::max(largest, std::abs(u.conjugate().dot(x)));
    if (kind == PolytopeKind::complex) largest = std::max(largest, std::abs(u.dot(x)));
  }
  return largest;
}

// Makes a vector that is even or odd under the flip up to rounding exactly so; leaves others alone.
void restore_symmetry(Eigen::VectorXcd& x) {
  for (double sign : {1.0, -1.0}) {
    const Eigen::VectorXcd symmetric = (x + sign * x.reverse()) / 2;
    if ((x - symmetric).norm() <= 1e-12 * x.norm()) {
      x = symmetric;
      return;
    }
  }
}

// Calls visit(x) for the points of the orbit of `front`, at most `width` of them, of largest `value`, per generation.
template <class Value, class Visit>
void follow_orbit(std::vector<Eigen::VectorXcd> front, const std::vector<Eigen::MatrixXd>& matrices, int generations,
                  std::size_t width, Value value, Visit visit) {
  for (int generation = 0; generation < generations; ++generation) {
    std::vector<std::pair<double, Eigen::VectorXcd>> next;
    for (const Eigen::VectorXcd& v : front) {
      for (const Eigen::MatrixXd& a : matrices) {
        Eigen::VectorXcd x = a * v;
        const double size = value(x);
        next.emplace_back(size, std::move(x));
      }
    }
    if (next.size() > width) {
      std::nth_element(next.begin(), next.begin() + static_cast<std::ptrdiff_t>(width), next.end(),
                       [](const auto& a, const auto& b) { return a.first > b.first; });
      next.resize(width);
    }
    front.clear();
    for (auto& [size, x] : next) {
      visit(x);
      front.push_back(std::move(x));
    }
  }
}

// Sizes of the root cycles so that no orbit of one sticks out at the roots of another: with q_ij the largest value of
// the dual vectors of j on the orbit of i, maximise t in log size_i + log q_ij + t <= log size_j. Ref: [GP16].
void balance(std::vector<RootCycle>& cycles, const std::vector<Eigen::MatrixXd>& matrices, bool flip, PolytopeKind kind,
             int odd) {
  const std::size_t n = cycles.size();
  if (n < 2) return;
  std::vector<std::vector<Eigen::VectorXcd>> duals;
  for (const RootCycle& cycle : cycles) duals.push_back(with_mirror_images(cycle.left, flip, kind, odd));
  Eigen::MatrixXd q = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n), -50.0);
  for (std::size_t i = 0; i < n; ++i) {
    follow_orbit(
        cycles[i].right, matrices, 14, 256, [](const auto& x) { return x.squaredNorm(); },
        [&](const Eigen::VectorXcd& x) {
          for (std::size_t j = 0; j < n; ++j) {
            double& entry = q(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
            if (j != i) entry = std::max(entry, std::log(largest_value(duals[j], kind, x) + 1e-20));
          }
        });
  }
  auto potentials = [&](double t, Eigen::VectorXd& p) {
    p.setZero(static_cast<Eigen::Index>(n));
    for (std::size_t round = 0; round <= n; ++round) {
      bool changed = false;
      for (Eigen::Index i = 0; i < p.size(); ++i) {
        for (Eigen::Index j = 0; j < p.size(); ++j) {
          if (i == j || p[i] + q(i, j) + t <= p[j] + 1e-12) continue;
          p[j] = p[i] + q(i, j) + t;
          changed = true;
        }
      }
      if (!changed) return true;
    }
    return false;
  };
  Eigen::VectorXd p, best = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n));
  double low = -20, high = 5;
  for (int k = 0; k < 40; ++k) {
    const double t = (low + high) / 2;
    if (potentials(t, p)) {
      low = t;
      best = p;
    } else {
      high = t;
    }
  }
  best.array() -= best.maxCoeff();
  for (std::size_t i = 0; i < n; ++i) cycles[i].size = std::exp(std::max(best[static_cast<Eigen::Index>(i)], -15.0));
}

}  // namespace

Coordinates working_coordinates(const SearchFamily& family, PolytopeKind kind) {
  const Eigen::Index d = family.matrices.front().rows();
  Coordinates result;
  if (kind == PolytopeKind::nonnegative) {
    result.to = result.from = Eigen::MatrixXd::Identity(d, d);
    return result;
  }
  const Eigen::MatrixXd shape = orbit_shape(family.matrices).shape;
  if (!family.flip_symmetric) {
    whiten(shape, result.to, result.from);
    return result;
  }
  const Eigen::Index odd = d / 2, even = d - odd;
  Eigen::MatrixXd q = Eigen::MatrixXd::Zero(d, d);
  for (Eigen::Index k = 0; k < odd; ++k) {
    q(k, k) = q(k, d - 1 - k) = q(even + k, k) = std::sqrt(0.5);
    q(even + k, d - 1 - k) = -std::sqrt(0.5);
  }
  if (even > odd) q(odd, odd) = 1;
  const Eigen::MatrixXd turned = q * shape * q.transpose();
  Eigen::MatrixXd to = Eigen::MatrixXd::Zero(d, d), from = to, block_to, block_from;
  whiten(turned.topLeftCorner(even, even), block_to, block_from);
  to.topLeftCorner(even, even) = block_to;
  from.topLeftCorner(even, even) = block_from;
  if (odd > 0) {
    whiten(turned.bottomRightCorner(odd, odd), block_to, block_from);
    to.bottomRightCorner(odd, odd) = block_to;
    from.bottomRightCorner(odd, odd) = block_from;
  }
  result.to = to * q;
  result.from = q.transpose() * from;
  result.odd = static_cast<int>(odd);
  return result;
}

std::vector<RootCycle> leading_cycles(const std::vector<Eigen::MatrixXd>& matrices,
                                      const std::vector<Candidate>& products, double tolerance) {
  std::vector<RootCycle> cycles;
  const Eigen::Index d = matrices.front().rows();
  for (std::size_t index = 0; index < products.size(); ++index) {
    const Candidate& candidate = products[index];
    Eigen::MatrixXd product = Eigen::MatrixXd::Identity(d, d);
    for (int letter : candidate.word) product = matrices[static_cast<std::size_t>(letter)] * product / candidate.radius;
    const EigenDecomposition right = eigen_decomposition(product), left = eigen_decomposition(product.transpose());
    for (Eigen::Index k = 0; k < d; ++k) {
      const std::complex<double> value = right.values[k];
      if (std::abs(value) < (1 - tolerance) * right.values.cwiseAbs().maxCoeff() || value.imag() < 0) continue;
      RootCycle cycle;
      cycle.product = static_cast<int>(index);
      cycle.phase = value / std::abs(value);
      Eigen::VectorXcd v = right.vectors.col(k);
      v.normalize();
      // A Jordan block shows as parallel eigenvectors: one root only, and no polytope will close.
      const bool repeated = std::any_of(cycles.begin(), cycles.end(), [&](const RootCycle& c) {
        return c.product == static_cast<int>(index) && std::abs(c.right.front().normalized().dot(v)) > 1 - 1e-10;
      });
      if (repeated) continue;
      Eigen::Index match = 0;
      double most = -1;
      for (Eigen::Index l = 0; l < d; ++l) {  // among close eigenvalues the dual vector that pairs best
        if (std::abs(left.values[l] - value) > 1e-6) continue;
        const double pairing = std::abs(left.vectors.col(l).conjugate().dot(v));
        if (pairing > most) {
          most = pairing;
          match = l;
        }
      }
      for (int letter : candidate.word) {
        cycle.right.push_back(v);
        v = matrices[static_cast<std::size_t>(letter)] * v / candidate.radius;
      }
      if (most > 1e-9) {
        // left[t] applies the rest of the word first.
        Eigen::VectorXcd u = left.vectors.col(match);
        cycle.left.resize(candidate.word.size());
        for (std::size_t t = candidate.word.size(); t-- > 0;) {
          u = matrices[static_cast<std::size_t>(candidate.word[t])].transpose() * u / candidate.radius;
          cycle.left[t] = u / u.conjugate().dot(cycle.right[t]);
        }
      }
      cycles.push_back(std::move(cycle));
    }
  }
  return cycles;
}

PolytopeRun::PolytopeRun(const SearchFamily& family, std::vector<Candidate> products, std::size_t maximizing,
                         PolytopeKind kind, double scale, const SearchOptions& options)
    : kind_(kind),
      flip_(family.flip_symmetric),
      scale_(scale),
      options_(options),
      original_(family.matrices),
      products_(std::move(products)),
      maximizing_(maximizing),
      coordinates_(working_coordinates(family, kind)),
      dimension_(static_cast<int>(family.matrices.front().rows())),
      simplex_(kind, dimension_, flip_, coordinates_.odd) {
  for (const Eigen::MatrixXd& a : original_) matrices_.push_back(coordinates_.to * a * coordinates_.from);
  cycles_ = leading_cycles(matrices_, products_, 1e-10);
  for (Eigen::MatrixXd& a : matrices_) a /= scale_;
  if (kind_ == PolytopeKind::nonnegative) {
    for (RootCycle& cycle : cycles_) {
      for (Eigen::VectorXcd& v : cycle.right) v = v.cwiseAbs().cast<std::complex<double>>();
    }
  }
  balance(cycles_, matrices_, flip_, kind_, coordinates_.odd);
  add_roots();
  add_extra_vertices();
}

Eigen::VectorXd PolytopeRun::real_form(const Eigen::VectorXcd& x) const {
  if (kind_ != PolytopeKind::complex) {
    // An eigenvector of a real eigenvalue is real up to a phase.
    Eigen::Index largest = 0;
    x.cwiseAbs().maxCoeff(&largest);
    return (x * std::conj(x[largest] / std::abs(x[largest]))).real();
  }
  Eigen::VectorXd result(2 * x.size());
  result << x.real(), x.imag();
  return result;
}

Eigen::VectorXd PolytopeRun::apply(int letter, const Eigen::VectorXd& x) const {
  const Eigen::MatrixXd& a = matrices_[static_cast<std::size_t>(letter)];
  if (kind_ != PolytopeKind::complex) return a * x;
  Eigen::VectorXd result(x.size());
  result.head(dimension_).noalias() = a * x.head(dimension_);
  result.tail(dimension_).noalias() = a * x.tail(dimension_);
  return result;
}

int PolytopeRun::add(Node node) {
  const int index = simplex_.add(node.value);
  vertices_.push_back(std::move(node));
  images_.resize(images_.size() + matrices_.size());
  for (int a = 0; a < static_cast<int>(matrices_.size()); ++a) fresh_.push_back({index, a, 0, {}});
  return index;
}

void PolytopeRun::add_roots() {
  for (std::size_t c = 0; c < cycles_.size(); ++c) {
    const RootCycle& cycle = cycles_[c];
    for (std::size_t t = 0; t < cycle.right.size(); ++t) {
      const Eigen::VectorXcd v = cycle.right[t] * cycle.size;
      // A root that is the mirror image of an earlier one of its cycle is that one.
      bool known = false;
      if (flip_) {
        const Eigen::VectorXcd m = mirrored(v, kind_, coordinates_.odd);
        for (std::size_t s = 0; s < t && !known; ++s) {
          const Eigen::VectorXcd w = cycle.right[s] * cycle.size;
          for (const Eigen::VectorXcd& x : {m, Eigen::VectorXcd(m.conjugate())}) {
            known = known || std::abs(std::abs(w.dot(x)) - x.norm() * w.norm()) <= 1e-12 * x.norm() * w.norm();
          }
          known = known && std::abs(w.norm() - v.norm()) <= 1e-8 * v.norm();
        }
      }
      if (known) continue;
      // The real part of a complex eigenvector is a vertex like any other.
      const bool eigenvector = kind_ == PolytopeKind::complex || std::abs(cycle.phase.imag()) < 1e-9;
      add(eigenvector ? Node{real_form(v), -1, -1, cycle.product, static_cast<int>(t)} : Node{real_form(v)});
    }
  }
}

// One vertex in each of a set of orthogonal directions, as long as its orbit allows: it must stay well behind the faces
// u.x = 1 at the roots, u their dual vectors. The hull of the roots' orbit alone is flat where the matrices nearly
// share an eigenvector, and then takes many vertices that differ little. Ref: [GP16] (balancing), [Mej20] (extra
// vertices).
void PolytopeRun::add_extra_vertices() {
  if (kind_ == PolytopeKind::nonnegative) return;
  std::vector<Eigen::VectorXcd> duals;
  for (const RootCycle& cycle : cycles_) {
    for (const Eigen::VectorXcd& u : cycle.left) duals.push_back(u / cycle.size);
  }
  if (duals.empty()) return;
  duals = with_mirror_images(duals, flip_, kind_, coordinates_.odd);
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(dimension_, dimension_);
  for (const Eigen::VectorXcd& u : duals) gram += (u * u.adjoint()).real();
  auto value = [&](const Eigen::VectorXcd& x) { return largest_value(duals, kind_, x); };
  const int even = dimension_ - coordinates_.odd;
  for (const auto& [begin, size] : {std::pair(0, even), std::pair(even, coordinates_.odd)}) {
    if (size == 0) continue;
    const SymmetricDecomposition eigen = symmetric_decomposition(gram.block(begin, begin, size, size));
    for (int k = 0; k < size; ++k) {
      Eigen::VectorXd direction = Eigen::VectorXd::Zero(vertices_.front().value.size());
      direction.segment(begin, size) = eigen.vectors.col(k);
      const Eigen::VectorXcd x = direction.head(dimension_).cast<std::complex<double>>();
      double reach = value(x);
      follow_orbit({x}, matrices_, 20, 16, value, [&](const auto& y) { reach = std::max(reach, value(y)); });
      if (reach > 0) add({direction * (kExtraReach / reach)});
    }
  }
}

// Small vertices in the directions no vertex reaches.
void PolytopeRun::add_spanning_vertices() {
  const Eigen::Index rows = vertices_.front().value.size();
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(dimension_, dimension_);
  double size = 0;
  for (const Node& node : vertices_) {
    for (Eigen::Index h = 0; h < rows; h += dimension_) {
      Eigen::VectorXd v = node.value.segment(h, dimension_);
      size = std::max(size, v.norm());
      gram += v * v.transpose();
      if (!flip_) continue;
      v = mirrored(v.cast<std::complex<double>>(), kind_, coordinates_.odd).real();
      gram += v * v.transpose();
    }
  }
  const SymmetricDecomposition eigen = symmetric_decomposition(gram);
  if (kind_ == PolytopeKind::nonnegative) {
    // The cone hull has inner points once every coordinate is reached.
    for (int k = 0; k < dimension_; ++k) {
      if (gram(k, k) > 0) continue;
      add({Eigen::VectorXd::Unit(dimension_, k) * (kExtraSize * size)});
    }
    return;
  }
  for (Eigen::Index k = 0; k < dimension_; ++k) {
    if (eigen.values[k] > 1e-16 * eigen.values.maxCoeff() * static_cast<double>(dimension_)) continue;
    Eigen::VectorXd v = Eigen::VectorXd::Zero(rows);
    v.head(dimension_) = eigen.vectors.col(k) * (kExtraSize * size);
    add({v});
  }
}

// Decides one image; true if it is inside or a vertex. Otherwise sets the key to an estimate of its norm.
bool PolytopeRun::settle(Pending& pending, bool optimum) {
  const Eigen::VectorXd x = apply(pending.letter, vertices_[static_cast<std::size_t>(pending.vertex)].value);
  Image& entry = image(pending.vertex, pending.letter);
  if (x.isZero(0)) {
    entry.known = true;
    entry.norm = 0;
    return true;
  }
  if (kind_ == PolytopeKind::complex && match(x, entry)) return true;
  const double reject = optimum ? std::numeric_limits<double>::max() / 4 : 1.0;
  Membership m = simplex_.solve(x, 1 - kComfortable, reject, optimum ? nullptr : &pending.hint);
  const bool decided = m.answer != Membership::Answer::undecided;
  if (m.answer != Membership::Answer::inside && (!decided || m.upper > 1 + kSame)) {
    pending.key = std::sqrt(std::max(m.lower, 1.0) * std::min(m.upper, 1e3));
    entry.norm = std::min(entry.norm, m.upper);
    return false;
  }
  std::vector<Term> terms = simplex_.combination();
  if (m.upper > 1 - kSame) {
    auto largest = std::max_element(terms.begin(), terms.end(), [](const Term& a, const Term& b) {
      return std::abs(a.coefficient) < std::abs(b.coefficient);
    });
    if (std::abs(std::abs(largest->coefficient) - 1) <= kSame) {
      entry.known = entry.identity = true;
      entry.norm = 1;
      entry.terms = {*largest};
      return true;
    }
  }
  if (m.upper > 1 - options_.tolerance) {
    pending.key = m.upper;
    entry.norm = std::min(entry.norm, m.upper);
    return false;
  }
  entry.known = true;
  entry.norm = m.upper;
  entry.terms = std::move(terms);
  return true;
}

// Is x a multiple c of a vertex, |c| = 1 up to rounding? A linear program comes near that phase by many pivots only.
bool PolytopeRun::match(const Eigen::VectorXd& x, Image& entry) const {
  Eigen::VectorXcd z(dimension_);
  z.real() = x.head(dimension_);
  z.imag() = x.tail(dimension_);
  for (std::size_t j = 0; j < vertices_.size(); ++j) {
    Eigen::VectorXcd v(dimension_);
    v.real() = vertices_[j].value.head(dimension_);
    v.imag() = vertices_[j].value.tail(dimension_);
    for (int g = 0; g < (flip_ ? 4 : 2); ++g) {
      Eigen::VectorXcd w = g >= 2 ? mirrored(v, kind_, coordinates_.odd) : v;
      if (g % 2 == 1) w = w.conjugate().eval();
      const std::complex<double> c = w.dot(z) / w.squaredNorm();
      if (std::abs(std::abs(c) - 1) > kSame || (z - c * w).norm() > kSame * z.norm()) continue;
      entry.known = entry.identity = true;
      entry.norm = 1;
      entry.terms = {Term{static_cast<int>(j), g >= 2, g % 2 == 1, c}};
      return true;
    }
  }
  return false;
}

PolytopeRun::State PolytopeRun::advance(double seconds, std::size_t max_vertices) {
  const auto start = Clock::now();
  auto stop = [&] { return since(start) > seconds || vertices_.size() >= max_vertices; };
  while (state_ == State::open && !stop()) {
    // Images of the newest vertices against the polytope so far.
    std::size_t done = 0;
    for (; done < fresh_.size(); ++done) {
      if (done % 16 == 15 && stop()) break;
      if (!settle(fresh_[done])) waiting_.push_back(fresh_[done]);
    }
    fresh_.erase(fresh_.begin(), fresh_.begin() + static_cast<std::ptrdiff_t>(done));
    if (!fresh_.empty()) break;
    if (waiting_.empty()) {
      if (spanning_) {
        state_ = State::closed;
        break;
      }
      spanning_ = true;
      add_spanning_vertices();
      if (fresh_.empty()) state_ = State::closed;
      continue;
    }
    // The largest first: each may put smaller ones inside.
    std::sort(waiting_.begin(), waiting_.end(), [](const Pending& a, const Pending& b) { return a.key > b.key; });
    // An image on the boundary that is no vertex becomes one.
    const double threshold = std::min(1.0, waiting_.front().key);
    std::vector<Pending> later;
    for (std::size_t k = 0; k < waiting_.size(); ++k) {
      Pending& pending = waiting_[k];
      if (pending.key < threshold || (k % 16 == 15 && stop())) {
        later.insert(later.end(), waiting_.begin() + static_cast<std::ptrdiff_t>(k), waiting_.end());
        break;
      }
      if (k > 0) {
        if (settle(pending)) continue;
        if (pending.key < threshold) {
          later.push_back(pending);
          continue;
        }
      }
      Image& entry = image(pending.vertex, pending.letter);
      Node node{apply(pending.letter, vertices_[static_cast<std::size_t>(pending.vertex)].value), pending.vertex,
                pending.letter};
      entry.known = entry.identity = true;
      entry.norm = 1;
      entry.terms = {Term{static_cast<int>(vertices_.size()), false, false, 1.0}};
      add(std::move(node));
    }
    waiting_ = std::move(later);
  }
  spent_ += since(start);
  return state_;
}

std::vector<int> PolytopeRun::path(int vertex) const {
  std::vector<int> word;
  for (int v = vertex; v >= 0 && word.size() < 60; v = vertices_[static_cast<std::size_t>(v)].parent) {
    if (vertices_[static_cast<std::size_t>(v)].parent >= 0)
      word.push_back(vertices_[static_cast<std::size_t>(v)].letter);
  }
  std::reverse(word.begin(), word.end());
  return word;
}

std::optional<Candidate> PolytopeRun::better_product(double radius) const {
  std::optional<Candidate> best;
  std::set<std::vector<int>> tried;
  // The deepest vertices tell along which words the orbit does not shrink.
  for (std::size_t k = 0; k < 6 && k < vertices_.size(); ++k) {
    const std::vector<int> word = path(static_cast<int>(vertices_.size() - 1 - k * (1 + vertices_.size() / 40)));
    for (std::size_t length = 2; length <= word.size(); ++length) {
      if (static_cast<int>(length) > options_.max_product_length) break;
      std::vector<int> tail(word.end() - static_cast<std::ptrdiff_t>(length), word.end());
      tail = canonical_word(tail, static_cast<int>(matrices_.size()), flip_);
      if (!tried.insert(tail).second) continue;
      const double r = product_radius(original_, tail);
      if (r > radius * (1 + 1e-9) && (!best || r > best->radius)) best = Candidate{tail, r};
    }
  }
  return best;
}

bool PolytopeRun::finish(double seconds) {
  const auto start = Clock::now();
  bool complete = true;
  for (int v = 0; v < static_cast<int>(vertices_.size()); ++v) {
    for (int a = 0; a < static_cast<int>(matrices_.size()); ++a) {
      const Image& entry = image(v, a);
      if (entry.known && (entry.identity || entry.norm <= 1 - kComfortable)) continue;
      if (since(start) > seconds) {
        complete = complete && entry.norm < 1e5;
        continue;
      }
      const Image before = entry;
      Pending pending{v, a, 0, {}};
      if (!settle(pending, true) || image(v, a).identity) {
        if (before.known && before.norm < image(v, a).norm) image(v, a) = before;
      }
      complete = complete && image(v, a).norm < 1e5;
    }
  }
  spent_ += since(start);
  return complete;
}

void PolytopeRun::count(SearchCounters& counters) const {
  counters.programs += simplex_.programs();
  counters.pivots += simplex_.pivots();
  counters.cold_starts += simplex_.cold_starts();
}

void PolytopeRun::report(SearchResult& result) const {
  result.status = state_ == State::closed ? SearchStatus::closed : SearchStatus::budget_spent;
  result.products = products_;
  result.maximizing = maximizing_;
  result.radius = products_.front().radius;
  result.scale = scale_;
  result.kind = kind_;
  result.spanning = spanning_ || state_ == State::closed;
  result.vertices.clear();
  result.images.clear();
  for (const Node& node : vertices_) {
    Vertex vertex{Eigen::VectorXcd(dimension_), node.parent, node.letter, node.cycle, node.place};
    vertex.value.real() = coordinates_.from * node.value.head(dimension_);
    vertex.value.imag().setZero();
    if (kind_ == PolytopeKind::complex) vertex.value.imag() = coordinates_.from * node.value.tail(dimension_);
    if (flip_ && node.parent < 0 && node.cycle < 0) restore_symmetry(vertex.value);
    result.vertices.push_back(std::move(vertex));
  }
  double worst = 0, margin = 1;
  for (std::size_t k = 0; k < images_.size(); ++k) {
    const Image& entry = images_[k];
    const int m = static_cast<int>(matrices_.size()), index = static_cast<int>(k);
    result.images.push_back({index / m, index % m, entry.identity, entry.norm, entry.terms});
    worst = std::max(worst, entry.norm);
    if (!entry.identity) margin = std::min(margin, 1 - entry.norm);
  }
  result.worst_margin = margin;
  result.upper_bound = scale_ * worst;
}

}  // namespace subcert::detail
