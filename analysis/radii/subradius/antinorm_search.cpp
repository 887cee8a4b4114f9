
#include "antinorm_search.hpp"

#include <subcert/analysis/radii/polytope_search/decompositions.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace subcert::subradius {
namespace {

using polytope::Matrix;
using polytope::Vector;

constexpr std::size_t longest_suffix = 200;  // of the products that are looked at where an image is small
constexpr double clearly_less = 1 - 1e-10;   // of spectral radii
// Coordinates of a vertex that are so much smaller than its largest one become 0: a smaller vertex is as good, and
// where a coordinate decays along a word only that ends.
constexpr double tiny_coordinate = 1e-36;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

bool is_finite(const Vector& x) {
  return std::ranges::all_of(x, [](double c) { return std::isfinite(c); });
}

}  // namespace

AntinormSearch::AntinormSearch(std::vector<Matrix> matrices, Vector first, std::vector<int> cycle, std::size_t memory,
                               bool explained)
    : matrices_(std::move(matrices)),
      cycle_(std::move(cycle)),
      memory_(memory),
      explained_(explained),
      program_(first.size()) {
  add({std::move(first)});
  for (std::size_t k = 0; k + 1 < cycle_.size(); ++k)
    add_image({matrices_[at(cycle_[k])] * result_.vertices.back().value, static_cast<int>(k), cycle_[k], 1});
  end_ = result_.vertices.size();
  overflows_ = !std::ranges::all_of(result_.vertices, is_finite, &AntinormCandidate::Vertex::value);
}

bool AntinormSearch::is_full() const {
  const std::size_t bytes = 3 * sizeof(double) * program_.dimension() + sizeof(AntinormCandidate::Vertex);
  return (result_.vertices.size() + below_.size()) * bytes > memory_;
}

const AntinormCandidate& AntinormSearch::advance(std::size_t vertices, const Deadline& deadline) {
  while (!is_over() && result_.vertices.size() < std::max(vertices, cycle_.size() + 1) && !deadline.expired())
    if (next_ < end_) {
      look_at_images(next_++);
      if (next_ == end_ && !overflows_) end_generation();
    } else if (added_ < below_.size()) {
      Image& image = below_[added_++];
      image.antinorm = program_.below(image.value, 1 + clearly_above).value;
      if (!is_inside(image)) add_image(image);
    } else {
      below_.clear();
      added_ = 0;
      end_ = result_.vertices.size();
    }
  return result_;
}

void AntinormSearch::add(AntinormCandidate::Vertex vertex) {
  const double least = tiny_coordinate * *std::max_element(vertex.value.begin(), vertex.value.end());
  for (double& c : vertex.value)
    if (c > 0 && c < least) {
      c = 0;
      vertex.cut = true;
    }
  program_.add(vertex.value);
  result_.vertices.push_back(std::move(vertex));
}

void AntinormSearch::add_image(const Image& image) {
  const AntinormCandidate::Vertex& parent = result_.vertices[at(image.parent)];
  add({image.value, image.parent, image.letter, parent.steps + 1, parent.cut});
}

void AntinormSearch::look_at_images(std::size_t vertex) {
  for (std::size_t t = 0; t < matrices_.size(); ++t) {
    if (vertex < cycle_.size() && at(cycle_[vertex]) == t) continue;  // the next vertex
    Image image{matrices_[t] * result_.vertices[vertex].value, static_cast<int>(vertex), static_cast<int>(t), 0};
    overflows_ = overflows_ || !is_finite(image.value);
    if (overflows_) return;
    image.antinorm = program_.below(image.value, 1 + clearly_above).value;
    if (!is_inside(image)) below_.push_back(std::move(image));
  }
}

bool AntinormSearch::is_inside(const Image& image) {
  if (image.antinorm < 1 - rounding) return false;
  if (image.antinorm > 1 + clearly_above / 2) return true;
  const auto target = coincident(image);
  if (target) result_.coincidences.push_back({at(image.parent), at(image.letter), *target});
  return target || !explained_;
}

std::optional<std::size_t> AntinormSearch::coincident(const Image& image) const {
  const AntinormCandidate::Vertex& parent = result_.vertices[at(image.parent)];
  for (std::size_t k = 0; k < result_.vertices.size() && !parent.cut; ++k) {
    const AntinormCandidate::Vertex& vertex = result_.vertices[k];
    const std::size_t more = std::max(vertex.steps, parent.steps + 1) - std::min(vertex.steps, parent.steps + 1);
    if (vertex.cut || more % cycle_.size() != 0) continue;
    bool is_above = true;
    for (std::size_t i = 0; i < vertex.value.size() && is_above; ++i)
      is_above = image.value[i] >= (1 - rounding) * vertex.value[i];
    if (is_above) return k;
  }
  return std::nullopt;
}

/// The images of all vertices of the generation are known.
void AntinormSearch::end_generation() {
  std::sort(below_.begin(), below_.end(), [](const Image& a, const Image& b) { return a.antinorm < b.antinorm; });
  const double least = below_.empty() ? 1 : std::min(below_.front().antinorm, 1.0);
  if (least > result_.least || below_.empty()) {
    result_.least = least;
    result_.kept = end_;
  }
  result_.closed = below_.empty();
  if (!below_.empty()) find_smaller(below_.front());
}

/// Looks whether the last letters that led to an image are a product of smaller radius.
void AntinormSearch::find_smaller(const Image& image) {
  std::vector<int> letters{image.letter};  // the last one first
  Matrix product = matrices_[at(image.letter)];
  double log_scale = 0;
  for (int j = image.parent;; j = result_.vertices[at(j)].parent) {
    const double radius = polytope::spectral_radius(product);
    if (radius == 0 || std::log(radius) + log_scale < static_cast<double>(letters.size()) * std::log(clearly_less)) {
      result_.smaller.assign(letters.rbegin(), letters.rend());
      return;
    }
    const int letter = result_.vertices[at(j)].letter;
    if (letter < 0 || letters.size() >= longest_suffix) return;
    letters.push_back(letter);
    product = product * matrices_[at(letter)];
    const double size = polytope::norm(product.entries());
    if (size == 0) continue;
    product /= size;
    log_scale += std::log(size);
  }
}

namespace {

using polytope::Matrix;
using polytope::Vector;

constexpr double tiny_price = 1e-12;  // reduced costs below that do not count
constexpr double tiny_pivot = 1e-11;

/// One program: its rows are the positive coordinates of the point, in units of the point, its columns the vertices
/// that have no other positive coordinates.
class Pivoting {
 public:
  Pivoting(const Vector& x, const AntinormProgram& program) : program_(program), units_(x.size(), 0) {
    for (std::size_t i = 0; i < x.size(); ++i)
      if (x[i] > 0) {
        rows_.push_back(i);
        units_[i] = 1 / x[i];
      }
    for (std::size_t j = 0; j < program.count(); ++j)
      if (rows_.size() == x.size() || !sticks_out(program.vertex(j))) columns_.push_back(j);
    const std::size_t n = rows_.size();
    inverse_ = Matrix::identity(n);
    basis_.resize(n);
    std::iota(basis_.begin(), basis_.end(), columns_.size());  // the slacks
    solution_.assign(n, 1);
  }

  Combination run(double enough) {
    if (rows_.empty() || columns_.empty()) return {0, {}, {}};
    pivot(best_single());
    const std::size_t most = 50 + 20 * rows_.size();
    for (std::size_t k = 0; k < most && value() < enough; ++k) {
      const std::size_t entering = priced();
      if (entering == none || !pivot(entering)) break;
    }
    return combination();
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  bool sticks_out(const double* vertex) const {
    for (std::size_t i = 0; i < units_.size(); ++i)
      if (units_[i] == 0 && vertex[i] > 0) return true;
    return false;
  }

  bool is_slack(std::size_t column) const { return column >= columns_.size(); }

  double value() const {
    double sum = 0;
    for (std::size_t i = 0; i < basis_.size(); ++i)
      if (!is_slack(basis_[i])) sum += solution_[i];
    return sum;
  }

  /// The vertex with the largest multiple below the point.
  std::size_t best_single() const {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const double* vertex = program_.vertex(columns_[k]);
      double largest = 0;
      for (std::size_t i = 0; i < units_.size(); ++i) largest = std::max(largest, units_[i] * vertex[i]);
      if (largest < least) {
        least = largest;
        best = k;
      }
    }
    return best;
  }

  /// The column whose weight raises the value fastest, or none.
  std::size_t priced() const {
    const std::size_t n = rows_.size();
    std::size_t entering = none;
    double best = tiny_price;
    Vector prices(units_.size(), 0);  // of the coordinates
    for (std::size_t i = 0; i < n; ++i) {
      double multiplier = 0;
      for (std::size_t k = 0; k < n; ++k)
        if (!is_slack(basis_[k])) multiplier += inverse_(k, i);
      prices[rows_[i]] = multiplier * units_[rows_[i]];
      if (-multiplier <= best) continue;
      best = -multiplier;
      entering = columns_.size() + i;
    }
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const double* vertex = program_.vertex(columns_[k]);
      double value = 1;
      for (std::size_t i = 0; i < prices.size(); ++i) value -= prices[i] * vertex[i];
      if (value <= best) continue;
      best = value;
      entering = k;
    }
    return entering;
  }

  /// False where no pivot is large enough.
  bool pivot(std::size_t entering) {
    const std::size_t n = rows_.size();
    Vector direction(n, 0);
    if (is_slack(entering))
      for (std::size_t k = 0; k < n; ++k) direction[k] = inverse_(k, entering - columns_.size());
    else
      direction = inverse_ * column(entering);
    std::size_t leaving = none;
    double step = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < n; ++k) {
      if (direction[k] <= tiny_pivot) continue;
      const double ratio = std::max(solution_[k], 0.0) / direction[k];
      if (ratio < step || (ratio == step && direction[k] > direction[leaving])) {
        step = ratio;
        leaving = k;
      }
    }
    if (leaving == none) return false;
    for (std::size_t k = 0; k < n; ++k) solution_[k] = k == leaving ? step : solution_[k] - step * direction[k];
    for (std::size_t i = 0; i < n; ++i) {
      const double row = inverse_(leaving, i) / direction[leaving];
      if (row == 0) continue;
      for (std::size_t k = 0; k < n; ++k) inverse_(k, i) = k == leaving ? row : inverse_(k, i) - row * direction[k];
    }
    basis_[leaving] = entering;
    return true;
  }

  Vector column(std::size_t k) const {
    const double* vertex = program_.vertex(columns_[k]);
    Vector result;
    for (const std::size_t i : rows_) result.push_back(units_[i] * vertex[i]);
    return result;
  }

  Combination combination() const {
    Combination result;
    std::vector<bool> free(rows_.size(), false);
    for (std::size_t k = 0; k < basis_.size(); ++k) {
      if (is_slack(basis_[k])) {
        free[basis_[k] - columns_.size()] = true;
        continue;
      }
      const double weight = std::max(solution_[k], 0.0);
      result.terms.push_back({columns_[basis_[k]], weight});
      result.value += weight;
    }
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (!free[i]) result.rows.push_back(rows_[i]);
    return result;
  }

  const AntinormProgram& program_;
  Vector units_;                             // 1 over the coordinates of the point, 0 for zeros
  std::vector<std::size_t> rows_, columns_;  // coordinates, vertices
  Matrix inverse_;                           // of the basis
  std::vector<std::size_t> basis_;           // columns, then slacks
  Vector solution_;
};

}  // namespace

Combination AntinormProgram::below(const Vector& x, double enough) const { return Pivoting(x, *this).run(enough); }

}  // namespace subcert::subradius
