#include "antinorm_search.hpp"

#include <subcert/analysis/radii/polytope_search/decompositions.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::subradius {
namespace {

using polytope::Matrix;
using polytope::Vector;

constexpr std::size_t longest_suffix = 200;  // of the products that are looked at where an image is small
constexpr double clearly_less = 1 - 1e-10;   // of spectral radii
constexpr double clearly_above = 1e-9;       // an antinorm so far above 1 is inside for certain
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

}  // namespace subcert::subradius
