#include "antinorm_search.hpp"

#include <subcert/analysis/regularity/polytope_search/decompositions.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::subradius {
namespace {

using polytope::Matrix;
using polytope::Vector;

constexpr std::size_t longest_suffix = 200;  // of the products that are looked at where an image is small
constexpr double clearly_less = 1 - 1e-10;   // of spectral radii

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

AntinormSearch::AntinormSearch(std::vector<Matrix> matrices, Vector first, std::vector<int> cycle, std::size_t memory)
    : matrices_(std::move(matrices)), cycle_(std::move(cycle)), memory_(memory), program_(first.size()) {
  add({std::move(first)});
  for (std::size_t k = 0; k + 1 < cycle_.size(); ++k)
    add({matrices_[at(cycle_[k])] * result_.vertices.back().value, static_cast<int>(k), cycle_[k]});
  end_ = result_.vertices.size();
}

const AntinormCandidate& AntinormSearch::advance(const Deadline& deadline) {
  while (!is_over() && !deadline.expired())
    if (next_ < end_) {
      look_at_images(next_++);
      if (next_ == end_) end_generation();
    } else if (added_ < below_.size()) {
      const Image& image = below_[added_++];
      if (program_.below(image.value, 1).value < 1 - rounding) add({image.value, image.parent, image.letter});
    } else {
      below_.clear();
      added_ = 0;
      end_ = result_.vertices.size();
    }
  return result_;
}

bool AntinormSearch::is_full() const {
  const std::size_t bytes = 3 * sizeof(double) * program_.dimension() + sizeof(AntinormCandidate::Vertex);
  return (result_.vertices.size() + below_.size()) * bytes > memory_;
}

void AntinormSearch::add(AntinormCandidate::Vertex vertex) {
  program_.add(vertex.value);
  result_.vertices.push_back(std::move(vertex));
}

void AntinormSearch::look_at_images(std::size_t vertex) {
  for (std::size_t t = 0; t < matrices_.size(); ++t) {
    if (vertex < cycle_.size() && at(cycle_[vertex]) == t) continue;  // the next vertex
    Vector image = matrices_[t] * result_.vertices[vertex].value;
    const double antinorm = program_.below(image, 1).value;
    if (antinorm < 1 - rounding)
      below_.push_back({std::move(image), static_cast<int>(vertex), static_cast<int>(t), antinorm});
  }
}

/// The images of all vertices of the generation are known.
void AntinormSearch::end_generation() {
  std::sort(below_.begin(), below_.end(), [](const Image& a, const Image& b) { return a.antinorm < b.antinorm; });
  const double least = below_.empty() ? 1 : below_.front().antinorm;
  if (least > result_.least) {
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
