#include "polytope_run.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace subcert::polytope {

namespace {

constexpr double comfortable_depth = 1e-4;       // images this far inside are not looked at again
constexpr double same_symmetry = 1e-10;          // squared distance of a vector from its image that counts as kept
constexpr int unit_bits = 40;                    // of the whole numbers that extra vertices are made of
constexpr double same_image = 1e-12;             // images this close to parallel are one
constexpr double same_point = 1e-8;              // an image this close to a vertex is that vertex
constexpr double same_in_cone = 1e-12;           // or, in a cone, this little above it
constexpr double least_gain = 1e-9;              // a product that beats another by less is the same up to rounding
constexpr double largest_norm = 1e3;             // norms beyond say only that the vertices do not span yet
constexpr double real_phase = 1e-9;              // an eigenvalue whose phase is this close to real is real
constexpr std::size_t longest_path = 60;         // letters of a word that is tried as a product
constexpr std::size_t tried_paths = 6;           // deep vertices whose words are tried
constexpr std::size_t large_dimension = 32;      // from here on the clock costs nothing beside a program
constexpr std::size_t allocation_overhead = 16;  // bytes that the heap spends on a block of its own
constexpr double seconds_per_operation = 1e-9;   // a multiplication and an addition, all in all
constexpr double pivots_between_pricings = 8;    // of all vertices, as a rule

// Makes a vector that is even or odd under the flip up to rounding exactly so; leaves others alone.
void restore_flip_symmetry(ComplexVector& x, const GroupAction& action) {
  ComplexVector image = x;
  action.apply(1, image.data());
  for (const double sign : {1.0, -1.0}) {
    ComplexVector symmetric = x, rest = x;
    for (std::size_t k = 0; k < x.size(); ++k) {
      symmetric[k] = (x[k] + sign * image[k]) / 2.0;
      rest[k] -= symmetric[k];
    }
    if (squared_norm(rest) > 1e-24 * squared_norm(x)) continue;
    x = symmetric;
    break;
  }
}

// The sum of a vector of whole numbers of units and its images under the elements that keep it up to a sign: exact
// where the elements have small integer entries, so that the sum is kept by them exactly.
void restore_dense_symmetry(ComplexVector& x, const GroupAction& action, double unit) {
  std::vector<std::pair<int, double>> kept;
  for (int g = 0; g < action.order(); ++g) {
    ComplexVector image = x;
    action.apply(g, image.data());
    const double cosine = inner(x, image).real() / squared_norm(x);
    double distance = 0;
    for (std::size_t k = 0; k < x.size(); ++k) distance += std::norm(image[k] - (cosine > 0 ? x[k] : -x[k]));
    if (distance < same_symmetry * squared_norm(x)) kept.emplace_back(g, cosine > 0 ? 1.0 : -1.0);
  }
  ComplexVector rounded = x;
  for (auto& entry : rounded) {
    entry /= unit * static_cast<double>(kept.size());
    entry = {std::round(entry.real()), std::round(entry.imag())};
  }
  std::fill(x.begin(), x.end(), 0.0);
  for (const auto& [g, sign] : kept) {
    ComplexVector image = rounded;
    action.apply(g, image.data());
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += sign * unit * image[k];
  }
}

void restore_symmetry(ComplexVector& x, const GroupAction& action) {
  if (action.order() == 1 || squared_norm(x) == 0) return;
  if (!action.is_dense()) return restore_flip_symmetry(x, action);
  int exponent = 0;
  std::frexp(std::sqrt(squared_norm(x)), &exponent);
  restore_dense_symmetry(x, action, std::ldexp(1.0, exponent - unit_bits));
}

}  // namespace

PolytopeRun::PolytopeRun(const SearchFamily& family, std::vector<Candidate> products, PolytopeKind kind, double scale,
                         double extra_reach, const SearchOptions& options)
    : family_(family),
      kind_(kind),
      scale_(scale),
      extra_reach_(extra_reach),
      options_(options),
      products_(std::move(products)),
      coordinates_(working_coordinates(family, kind, options.budget.deadline)),
      dimension_(family.matrices.front().rows()),
      stride_between_looks_(dimension_ < large_dimension ? 16 : 1),
      // A quarter of the memory for what only saves time.
      simplex_(kind, coordinates_.action.is_dense() ? GroupAction(dimension_) : coordinates_.action,
               {options.budget.deadline, options.budget.memory / 4}) {
  for (const Matrix& a : family.matrices) {
    if (options_.budget.deadline.expired()) return;
    matrices_.push_back(coordinates_.change.to * a * coordinates_.change.from);
  }
  // Of more than the radius one product is enough: no image has to come back to a root of the others.
  const std::size_t roots = scale_ > products_.front().radius ? 1 : products_.size();
  cycles_ = leading_cycles(matrices_, {products_.begin(), products_.begin() + static_cast<std::ptrdiff_t>(roots)},
                           1e-10, options_.budget.deadline);
  for (Matrix& a : matrices_) a /= scale_;
  if (kind_ == PolytopeKind::nonnegative) {
    for (RootCycle& cycle : cycles_) {
      for (ComplexVector& v : cycle.right) {
        for (auto& entry : v) entry = std::abs(entry);
      }
    }
  }
  balance(cycles_, matrices_, coordinates_.action, kind_, {options_.budget.deadline, options_.budget.memory / 4});
  add_roots();
  add_extra_vertices();
}

Vector PolytopeRun::real_form(const ComplexVector& x) const {
  Vector result;
  if (kind_ == PolytopeKind::complex) {
    for (const auto& entry : x) result.push_back(entry.real());
    for (const auto& entry : x) result.push_back(entry.imag());
    return result;
  }
  // An eigenvector of a real eigenvalue is real up to a phase.
  std::complex<double> largest = x.front();
  for (const auto& entry : x) {
    if (std::abs(entry) > std::abs(largest)) largest = entry;
  }
  const std::complex<double> turn = std::conj(largest / std::abs(largest));
  for (const auto& entry : x) result.push_back((entry * turn).real());
  return result;
}

ComplexVector PolytopeRun::complex_form(const Vector& x) const {
  ComplexVector result(dimension_);
  for (std::size_t k = 0; k < dimension_; ++k)
    result[k] = {x[k], kind_ == PolytopeKind::complex ? x[dimension_ + k] : 0.0};
  return result;
}

Vector PolytopeRun::apply(int letter, const Vector& x) const {
  Vector result(x.size());
  for (std::size_t h = 0; h < x.size(); h += dimension_)
    add_product(matrices_[static_cast<std::size_t>(letter)], x.data() + h, result.data() + h);
  return result;
}

Vector PolytopeRun::acted_on(int element, Vector x) const {
  for (std::size_t h = 0; h < x.size(); h += dimension_) coordinates_.action.apply(element, x.data() + h);
  return x;
}

int PolytopeRun::add(Node node) {
  const int index = static_cast<int>(vertices_.size());
  std::vector<Vector> images;  // each once up to its sign
  for (int g = 0; g < static_cast<int>(images_in_simplex()); ++g) {
    Vector image = acted_on(g, node.value);
    const double size = inner(image, image);
    if (std::any_of(images.begin(), images.end(),
                    [&](const Vector& other) { return std::abs(inner(image, other)) > (1 - same_image) * size; }))
      continue;
    simplex_.add(image);
    image_of_.emplace_back(index, g);
    images.push_back(std::move(image));
  }
  vertices_.push_back(std::move(node));
  images_.resize(images_.size() + matrices_.size());
  for (int a = 0; a < static_cast<int>(matrices_.size()); ++a) fresh_.push_back({index, a, 0, {}});
  return index;
}

std::vector<CombinationTerm> PolytopeRun::combination() const {
  std::vector<CombinationTerm> terms = simplex_.combination();
  for (CombinationTerm& term : terms) {
    const auto [vertex, element] = image_of_[static_cast<std::size_t>(term.vertex)];
    term.vertex = vertex;
    if (coordinates_.action.is_dense()) term.element = element;
  }
  return terms;
}

// A vertex, its images as far as their number goes, and what a report makes of them.
std::size_t PolytopeRun::bytes_of_vertex() const {
  const std::size_t image = sizeof(Image) + sizeof(VertexImage) + 3 * sizeof(Pending) + allocation_overhead;
  return sizeof(Node) + sizeof(Vertex) + 2 * allocation_overhead + simplex_.dimension() * sizeof(double) +
         dimension_ * sizeof(std::complex<double>) + matrices_.size() * image;
}

std::size_t PolytopeRun::bytes() const {
  return vertices_.size() * bytes_of_vertex() + bytes_of_terms_ + simplex_.bytes() +
         waiting_.size() * simplex_.bytes_of_warm_start();
}

void PolytopeRun::set_terms(Image& entry, std::vector<CombinationTerm> terms) {
  bytes_of_terms_ -= entry.terms.capacity() * sizeof(CombinationTerm);
  entry.terms = std::move(terms);
  bytes_of_terms_ += entry.terms.capacity() * sizeof(CombinationTerm);
}

// Is the root at place t the image of an earlier one of its cycle under the symmetry?
bool PolytopeRun::is_image_of_earlier_root(const RootCycle& cycle, std::size_t t) const {
  const ComplexVector& v = cycle.right[t];
  const double size = std::sqrt(squared_norm(v));
  for (int g = 1; g < coordinates_.action.order(); ++g) {
    ComplexVector image = v;
    coordinates_.action.apply(g, image.data());
    for (std::size_t s = 0; s < t; ++s) {
      const ComplexVector& w = cycle.right[s];
      const double other = std::sqrt(squared_norm(w));
      const auto parallel = [&](const ComplexVector& x) {
        return std::abs(std::abs(inner(w, x)) - size * other) <= 1e-12 * size * other;
      };
      if (std::abs(other - size) <= same_point * size && (parallel(image) || parallel(conjugate(image)))) return true;
    }
  }
  return false;
}

void PolytopeRun::add_roots() {
  for (const RootCycle& cycle : cycles_) {
    for (std::size_t t = 0; t < cycle.right.size(); ++t) {
      if (is_image_of_earlier_root(cycle, t)) continue;
      ComplexVector v = cycle.right[t];
      scale(v, cycle.size);
      // The real part of a complex eigenvector is a vertex like any other.
      const bool eigenvector = kind_ == PolytopeKind::complex || std::abs(cycle.phase.imag()) < real_phase;
      if (eigenvector) {
        add({real_form(v), -1, -1, cycle.product, static_cast<int>(t)});
      } else {
        add({real_form(v)});
      }
    }
  }
}

// A look at all vertices and the image itself, and so many pivots.
void PolytopeRun::count_work(std::int64_t pivots) {
  const auto d = static_cast<double>(dimension_), n = static_cast<double>(vertices_.size());
  work_ += seconds_per_operation * d * (d + n + static_cast<double>(pivots) * (d + n / pivots_between_pricings));
}

// Decides one image; true if it is inside or a vertex. Otherwise sets the key to an estimate of its norm.

bool PolytopeRun::settle(Pending& pending, bool optimum) {
  const Vector x = apply(pending.letter, value(pending.vertex));
  Image& entry = image(pending.vertex, pending.letter);
  if (std::all_of(x.begin(), x.end(), [](double c) { return c == 0; })) {
    entry.known = true;
    entry.norm = 0;
    return true;
  }
  if (const int root = next_root(pending); root >= 0 && match(x, root, entry)) return true;
  if (kind_ == PolytopeKind::complex && match(x, entry)) return true;
  const double reject = optimum ? std::numeric_limits<double>::max() / 4 : 1.0;
  const std::int64_t pivots = simplex_.pivots();
  const Membership m = simplex_.solve(x, 1 - comfortable_depth, reject, optimum ? nullptr : &pending.warm);
  count_work(simplex_.pivots() - pivots);
  const double same = kind_ == PolytopeKind::nonnegative ? same_in_cone : same_point;
  if (!m.combined || m.upper > 1 + same) {
    pending.key = std::sqrt(std::max(m.lower, 1.0) * std::min(m.upper, largest_norm));
    entry.norm = std::min(entry.norm, m.upper);
    return false;
  }
  std::vector<CombinationTerm> terms = combination();
  if (m.upper > 1 - same) {
    const auto largest = std::max_element(terms.begin(), terms.end(), [](const auto& a, const auto& b) {
      return std::abs(a.coefficient) < std::abs(b.coefficient);
    });
    if (std::abs(std::abs(largest->coefficient) - 1) <= same && is_term(x, *largest)) {
      entry.known = entry.identity = true;
      entry.norm = 1;
      set_terms(entry, {*largest});
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
  set_terms(entry, std::move(terms));
  return true;
}

// Whether x is the term up to rounding: where vertices are long, small coefficients of others move a point far. In a
// cone it is only to be below it.
bool PolytopeRun::is_term(const Vector& x, const CombinationTerm& term) const {
  if (kind_ == PolytopeKind::nonnegative) return true;
  ComplexVector w = complex_form(value(term.vertex));
  coordinates_.action.apply(term.element, w.data());
  if (term.conjugated) w = conjugate(std::move(w));
  const ComplexVector z = complex_form(x);
  double distance = 0;
  for (std::size_t k = 0; k < dimension_; ++k) distance += std::norm(z[k] - term.coefficient * w[k]);
  return distance <= same_point * same_point * squared_norm(z);
}

// The root that the image of a root by the letter of its product is, or -1. A linear program may combine it of others
// that lie on a line with it.
int PolytopeRun::next_root(const Pending& pending) const {
  const Node& root = vertices_[static_cast<std::size_t>(pending.vertex)];
  if (root.cycle < 0) return -1;
  const std::vector<int>& word = products_[static_cast<std::size_t>(root.cycle)].word;
  if (word[static_cast<std::size_t>(root.place)] != pending.letter) return -1;
  const int place = (root.place + 1) % static_cast<int>(word.size());
  const auto next = std::ranges::find_if(
      vertices_, [&](const Node& node) { return node.cycle == root.cycle && node.place == place; });
  return next == vertices_.end() ? -1 : static_cast<int>(next - vertices_.begin());
}

// Is x a multiple c of a vertex, |c| = 1 up to rounding? A linear program comes near that phase by many pivots only.
bool PolytopeRun::match(const Vector& x, Image& entry) {
  for (std::size_t j = 0; j < vertices_.size(); ++j)
    if (match(x, static_cast<int>(j), entry)) return true;
  return false;
}

bool PolytopeRun::match(const Vector& x, int vertex, Image& entry) {
  const double size = inner(x, x);
  // Those of another length are no candidates: |x| and |c v| differ by 2 same_point at most.
  if (std::abs(inner(value(vertex), value(vertex)) - size) > 10 * same_point * size) return false;
  const ComplexVector z = complex_form(x);
  for (int g = 0; g < coordinates_.action.order(); ++g) {
    ComplexVector w = complex_form(value(vertex));
    coordinates_.action.apply(g, w.data());
    for (const bool conjugated : {false, true}) {
      if (conjugated) w = conjugate(std::move(w));
      const std::complex<double> c = inner(w, z) / squared_norm(w);
      double distance = 0;
      for (std::size_t k = 0; k < dimension_; ++k) distance += std::norm(z[k] - c * w[k]);
      if (std::abs(std::abs(c) - 1) > same_point || distance > same_point * same_point * size) continue;
      entry.known = entry.identity = true;
      entry.norm = 1;
      set_terms(entry, {CombinationTerm{vertex, g, conjugated, c}});
      return true;
    }
  }
  return false;
}

PolytopeRun::State PolytopeRun::advance(double work, const Deadline& deadline) {
  work_limit_ = work_ + work;
  while (state_ == State::open && !vertices_.empty() && !must_stop(deadline)) {
    if (!settle_fresh(deadline)) break;
    if (!waiting_.empty()) {
      add_largest(deadline);
      continue;
    }
    if (!spanning_) add_spanning_vertices();
    spanning_ = true;
    if (fresh_.empty()) state_ = State::closed;
  }
  return state_;
}

// Images of the newest vertices against the polytope so far; false if they were not all settled in time.
bool PolytopeRun::settle_fresh(const Deadline& deadline) {
  std::size_t done = 0;
  for (; done < fresh_.size(); ++done) {
    if ((done + 1) % stride_between_looks_ == 0 && must_stop(deadline)) break;
    if (!settle(fresh_[done])) waiting_.push_back(std::move(fresh_[done]));
  }
  fresh_.erase(fresh_.begin(), fresh_.begin() + static_cast<std::ptrdiff_t>(done));
  return fresh_.empty();
}

// The largest images become vertices, the largest first: each may put smaller ones inside.
void PolytopeRun::add_largest(const Deadline& deadline) {
  std::sort(waiting_.begin(), waiting_.end(), [](const Pending& a, const Pending& b) { return a.key > b.key; });
  // An image on the boundary that is no vertex becomes one.
  const double threshold = std::min(1.0, waiting_.front().key);
  std::vector<Pending> later;
  for (std::size_t k = 0; k < waiting_.size(); ++k) {
    Pending& pending = waiting_[k];
    if (pending.key < threshold || ((k + 1) % stride_between_looks_ == 0 && must_stop(deadline))) {
      std::move(waiting_.begin() + static_cast<std::ptrdiff_t>(k), waiting_.end(), std::back_inserter(later));
      break;
    }
    if (k > 0 && settle(pending)) continue;
    if (pending.key < threshold) {
      later.push_back(std::move(pending));
    } else {
      make_vertex(pending);
    }
  }
  waiting_ = std::move(later);
}

void PolytopeRun::make_vertex(const Pending& pending) {
  Image& entry = image(pending.vertex, pending.letter);
  entry.known = entry.identity = true;
  entry.norm = 1;
  set_terms(entry, {CombinationTerm{static_cast<int>(vertices_.size()), 0, false, 1.0}});
  add({apply(pending.letter, value(pending.vertex)), pending.vertex, pending.letter});
}

std::vector<int> PolytopeRun::path(int vertex) const {
  std::vector<int> word;
  for (int v = vertex; word.size() < longest_path && vertices_[static_cast<std::size_t>(v)].parent >= 0;
       v = vertices_[static_cast<std::size_t>(v)].parent)
    word.push_back(vertices_[static_cast<std::size_t>(v)].letter);
  std::reverse(word.begin(), word.end());
  return word;
}

std::optional<Candidate> PolytopeRun::better_product(double radius) const {
  std::optional<Candidate> best;
  std::set<std::vector<int>> tried;
  // The deepest vertices tell along which words the orbit does not shrink.
  for (std::size_t k = 0; k < tried_paths && k < size(); ++k) {
    const std::vector<int> word = path(static_cast<int>(size() - 1 - k * (1 + size() / 40)));
    for (std::size_t length = 2; length <= word.size(); ++length) {
      if (static_cast<int>(length) > longest_product || options_.budget.deadline.expired()) break;
      std::vector<int> tail(word.end() - static_cast<std::ptrdiff_t>(length), word.end());
      tail = canonical_word(tail, matrices_.size(), family_.symmetry);
      if (!tried.insert(tail).second) continue;
      const double r = product_radius(family_.matrices, tail);
      if (r > radius * (1 + least_gain) && (!best || r > best->radius)) best = Candidate{tail, r};
    }
  }
  return best;
}

void PolytopeRun::finish(const Deadline& deadline) {
  for (int v = 0; v < static_cast<int>(size()); ++v) {
    for (int a = 0; a < static_cast<int>(matrices_.size()); ++a) {
      Image& entry = image(v, a);
      if (entry.known && (entry.identity || entry.norm <= 1 - comfortable_depth)) continue;
      if (deadline.expired()) return;
      const Image before = entry;
      Pending pending{v, a, 0, {}};
      if (settle(pending, true) && !entry.identity) continue;
      if (before.known && before.norm < entry.norm) {
        entry.identity = before.identity;
        entry.norm = before.norm;
        set_terms(entry, before.terms);
      }
    }
  }
}

void PolytopeRun::report(SearchResult& result) && {
  result.closed = state_ == State::closed;
  result.products = std::move(products_);
  result.maximizing = result.products.size();
  result.radius = result.products.front().radius;
  result.scale = scale_;
  result.kind = kind_;
  result.vertices.clear();
  result.vertices.reserve(size());
  const GroupAction action = family_.symmetry.action(dimension_);
  for (const Node& node : vertices_) {
    result.vertices.push_back(
        {coordinates_.change.from * complex_form(node.value), node.parent, node.letter, node.cycle, node.place});
    if (node.parent < 0 && node.cycle < 0) restore_symmetry(result.vertices.back().value, action);
  }
  result.images.clear();
  result.images.reserve(images_.size());
  double worst = 0;
  for (Image& entry : images_) {
    const int m = static_cast<int>(matrices_.size()), index = static_cast<int>(result.images.size());
    result.images.push_back({index / m, index % m, entry.identity, std::move(entry.terms), entry.norm});
    worst = std::max(worst, entry.norm);
  }
  result.upper_bound = scale_ * worst;
}

}  // namespace subcert::polytope
