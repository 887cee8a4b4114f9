#include "exact_radius.hpp"
#include "near_eigenvector.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace subcert_check {
namespace {

/// The polytope with its true vertices.
class Attained {
 public:
  Attained(const Polytope& body, const ExactRadius& radius, const FamilyError& error, Reader& reader,
           Arithmetic& arithmetic)
      : body_(body),
        radius_(radius),
        many_(error.entry > 0 && !error.field),
        symmetric_(error.symmetric),
        matrix_error_(error.entry * mpz_class(body.size)),
        reader_(reader),
        arithmetic_(arithmetic),
        vertices_(body.vertices.size()),
        origins_(body, arithmetic) {
    if (!error.field) return;
    require(body.parts == 1 && !body.nonnegative, "over a field complex polytopes and cones name no radius");
    field_ = *error.field;
    if (body.transposed) field_->transpose();
  }

  void run() {
    for (const Vector& vertex : body_.vertices)
      largest_ = std::max(largest_, *std::max_element(vertex.begin(), vertex.end()));
    if (many_)
      read_near_cycles();
    else
      while (reader_.at("cycle")) read_cycle();
    for (std::size_t j = 0; j < vertices_.size(); ++j)
      if (reader_.at("origin " + std::to_string(j))) read_origin(j);
    for (const Vertex& vertex : vertices_) error_ = std::max(error_, vertex.error);
    require(error_ < 1, "the true vertices are too far from the given ones");
    for (const Cycle& cycle : cycles_) met_.insert(origins_.last_image(cycle.root, cycle.letters));
    while (reader_.at("same")) read_same();
    check_images();
  }

 private:
  struct Cycle {
    std::size_t root;
    std::vector<std::size_t> letters;  // the first one is applied first
    std::string word;                  // of generators, after the letters
    std::vector<Vector> basis;         // y_0, y_1, ... of the theorem
  };
  struct Vertex {
    std::optional<std::size_t> cycle;  // of a first vertex of a cycle
    mpq_class error = 0;               // of the norm of true less given vertex
  };

  Vector turned(const std::string& word, Vector x) {
    require(!body_.symmetric || word.size() <= 1, "unknown generator");
    for (std::size_t k = word.size(); k-- > 0;) x = body_.turn(word[k], std::move(x), arithmetic_);
    return x;
  }
  /// Exactly: over a field x holds the p and then the q of p + sqrt(root) q.
  Vector exact_image(std::size_t letter, const Vector& x) const {
    return field_ ? field_->image(letter, x, arithmetic_) : body_.image(letter, x, arithmetic_);
  }
  Vector around(const Cycle& cycle, Vector x) {
    for (const std::size_t t : cycle.letters) x = exact_image(t, x);
    return turned(cycle.word, std::move(x));
  }

  void read_cycle() {
    const Fields fields = reader_.take("cycle", 2 + radius_.length, 2 + radius_.length);
    Cycle cycle{parse_size(fields[0], 0, vertices_.size() - 1), {}, std::string(fields[1]), {}};
    require(!cycle.word.empty(), "a cycle has a word, or '-'");
    if (cycle.word == "-") cycle.word.clear();
    require(cycle.word.size() <= 16, "a word of more than 16 generators");
    for (std::size_t k = 2; k < fields.size(); ++k)
      cycle.letters.push_back(parse_size(fields[k], 0, body_.family.count() - 1));
    require(!vertices_[cycle.root].cycle, "a vertex is the first one of two cycles");
    const mpz_class scale =
        power(field_ ? field_->rational.denominator : body_.family.denominator, cycle.letters.size()).get_num();
    cycle.basis = read_seed(
        radius_, field_ ? 2 * body_.size : body_.size, scale, [&](const Vector& x) { return around(cycle, x); },
        reader_, arithmetic_);
    Vertex& root = vertices_[cycle.root];
    root.cycle = cycles_.size();
    const Eigenvector found = eigenvector_of(radius_, cycle.basis, scale, arithmetic_);
    root.error = root_error(cycle, field_ ? over_field(found, field_->root) : found);
    cycles_.push_back(std::move(cycle));
  }

  Complex coordinate_of(const Vector& vertex, std::size_t i) const {
    return {vertex[i], body_.parts == 2 ? vertex[body_.size + i] : mpz_class(0)};
  }
  /// The first of those that are largest.
  std::size_t largest_coordinate(const Vector& vertex) const {
    std::size_t largest = 0;
    for (std::size_t i = 1; i < body_.size; ++i)
      if (norm(coordinate_of(vertex, i)) > norm(coordinate_of(vertex, largest))) largest = i;
    return largest;
  }

  /// Of all families near by: a product, its letters in the order in which they are applied, and how far its eigenvalue
  /// is from a number.
  struct NearCycle {
    std::vector<std::size_t> product;
    mpq_class eigenvalue, distance;
  };

  /// Section 7.1: one cycle, or two whose products have the same eigenvalue in all families.
  void read_near_cycles() {
    require(
        body_.parts == 1 && !body_.nonnegative && (!body_.symmetric || symmetric_),
        "of all masks near by a complex polytope, a cone, and a symmetric polytope where they are not prove nothing");
    NearCycle first = read_near_cycle();
    std::vector<std::size_t> product = first.product;
    if (!body_.transposed) std::reverse(product.begin(), product.end());
    require(product == radius_.letters, "the product of the cycle is not the one of the claim");
    if (!reader_.at("cycle")) return;
    const NearCycle second = read_near_cycle();
    const std::size_t last = body_.family.count() - 1;
    const std::vector<std::size_t> ends{std::min(first.product[0], second.product[0]),
                                        std::max(first.product[0], second.product[0])};
    require(!body_.symmetric && first.eigenvalue == second.eigenvalue &&
                first.product.size() + second.product.size() == 2 && ends == std::vector<std::size_t>{0, last},
            "nothing says that two products have the same radius for all masks near by");
    const mpq_class error = std::max(first.distance, second.distance) + matrix_error_;
    for (const mpz_class& corner : {body_.family.matrix(0).front(), body_.family.matrix(last).back()})
      require(abs(ratio(corner, body_.family.denominator) - first.eigenvalue) > error,
              "a corner of a matrix may be the eigenvalue");
  }

  NearCycle read_near_cycle() {
    const Fields fields = reader_.take("cycle", 4, 3 + most_letters);
    require(fields[1] == "-" || (fields[1] == "f" && body_.symmetric), "the word of a cycle is '-' or 'f'");
    Cycle cycle{parse_size(fields[0], 0, vertices_.size() - 1), {}, fields[1] == "-" ? "" : "f", {}};
    require(!vertices_[cycle.root].cycle, "a vertex is the first one of two cycles");
    NearCycle near{{}, parse_rational(fields[2]), 0};
    const std::size_t count = body_.family.count(), n = body_.size;
    for (std::size_t k = 3; k < fields.size(); ++k) cycle.letters.push_back(parse_size(fields[k], 0, count - 1));
    near.product = cycle.letters;
    if (!cycle.word.empty())
      for (const std::size_t letter : cycle.letters) near.product.push_back(count - 1 - letter);
    Vector unity(n * n);
    for (std::size_t i = 0; i < n; ++i) unity[i * n + i] = 1;
    const Vector& vertex = body_.vertices[cycle.root];
    const std::size_t length = cycle.letters.size();
    near.distance = distance_to_eigenvector({around(cycle, unity), power(body_.family.denominator, length).get_num(),
                                             change_of_product(largest_column_sum(body_.family), matrix_error_, length),
                                             near.eigenvalue, vertex, largest_coordinate(vertex), body_.vertex_one},
                                            reader_, arithmetic_);
    require(lies_between(near.eigenvalue, 0, near.distance, power(radius_.low, length), power(radius_.high, length)),
            wrong_bounds);
    vertices_[cycle.root] = {cycles_.size(), rounded_up(near.distance * body_.unit_norm)};
    cycles_.push_back(std::move(cycle));
    return near;
  }

  /// How far the eigenvector, scaled so that it has a large coordinate of the given vertex, is from that vertex.
  mpq_class root_error(const Cycle& cycle, const Eigenvector& eigenvector) const {
    require(body_.parts == 2 || (radius_.im == 0 && radius_.near_im == 0), "a real polytope, but no real eigenvalue");
    const auto& [vector, off] = eigenvector;
    const std::size_t n = body_.size;
    // (v_i U - U_i v) / U_i
    const Vector& given = body_.vertices[cycle.root];
    const auto coordinate = [&](std::size_t i) { return coordinate_of(given, i); };
    const std::size_t largest = largest_coordinate(given);
    const Complex& pivot = vector[largest];
    const mpq_class below = std::max(abs(pivot.re), abs(pivot.im)) - off;
    require(below > 0, "the eigenvector of a cycle may be zero where the vertex is large");
    mpq_class difference = off * (norm(coordinate(largest)) + norm(given));
    for (std::size_t i = 0; i < n; ++i) {
      const Complex left = times(coordinate(largest), vector[i], arithmetic_),
                    right = times(pivot, coordinate(i), arithmetic_);
      difference += norm(Complex{left.re - right.re, left.im - right.im});
    }
    const mpq_class distance = difference / below;  // times vertex_one
    for (std::size_t i = 0; body_.nonnegative && i < n; ++i)
      require(given[i] > distance ||
                  std::all_of(cycle.basis.begin(), cycle.basis.end(), [i](const Vector& y) { return y[i] == 0; }),
              "a coordinate of the eigenvector may be negative");
    return rounded_up(distance * body_.unit_norm / body_.vertex_one);
  }

  /// True vertex j is +- (matrix) (true parent) / radius.
  void read_origin(std::size_t j) {
    require(j > 0 && !vertices_[j].cycle, "the first vertex of a cycle is no image");
    const auto [parent, letter] = origins_.read(j, reader_);
    const Vector image = body_.image(letter, body_.vertices[parent], arithmetic_);
    const mpz_class left = radius_.low.get_den(), right = radius_.low.get_num() * body_.family.denominator;
    mpz_class least = -1;
    for (const int sign : {1, -1}) {
      if (sign < 0 && body_.nonnegative) continue;
      mpz_class sum = 0;
      for (std::size_t i = 0; i < image.size(); ++i) {
        mpz_class part = 0;
        arithmetic_.add_product(part, left, image[i]);
        arithmetic_.add_product(part, right * -sign, body_.vertices[j][i]);
        sum += abs(part);
      }
      if (least < 0 || sum < least) least = sum;
    }
    const mpq_class off = ratio(least, left * body_.family.denominator) +
                          (radius_.high - radius_.low) * norm(body_.vertices[j]) +
                          matrix_error_ * norm(body_.vertices[parent]);
    vertices_[j].error = rounded_up((body_.bound * vertices_[parent].error + off * body_.unit_norm / body_.vertex_one) /
                                    radius_.low);
  }

  /// An image is a vertex, up to its sign, because both stem from one cycle, or from given vertices, by linear
  /// equations. Cones: it lies below, as each coordinate is equal by such equations, or clearly less.
  void read_same() {
    const Fields fields = reader_.take("same", 3, 3);
    const Image image{parse_size(fields[0], 0, vertices_.size() - 1),
                      parse_size(fields[1], 0, body_.family.count() - 1)};
    const auto [target, word] = parse_turned_index(fields[2], vertices_.size());
    if (many_) {
      require(is_mirrored(image, target, word), "nothing says of all masks near by that an image is a vertex");
      met_.insert(image);
      return;
    }
    const std::size_t n = body_.size;
    std::vector<bool> equal((field_ ? 2 : body_.parts) * n, true), opposite = equal;
    compare(image, target, word, equal, opposite);
    for (std::size_t i = 0; body_.nonnegative && i < n; ++i) equal[i] = equal[i] || is_below(image, target, word, i);
    const auto all = [](const std::vector<bool>& marks) {
      return std::find(marks.begin(), marks.end(), false) == marks.end();
    };
    require(all(equal) || all(opposite), "an image is not the vertex that it is said to be");
    met_.insert(image);
  }

  /// Whether an image is the flip of a vertex because both stem from one vertex that is its own flip, up to its sign,
  /// by letters that are those of mirrored matrices.
  bool is_mirrored(const Image& image, std::size_t target, const std::string& word) {
    Origins::Way left = origins_.way_to(image.vertex);
    left.letters.insert(left.letters.begin(), image.letter);
    const Origins::Way right = origins_.way_to(target);
    const auto mirrored = [&](std::vector<std::size_t> letters) {
      for (std::size_t& letter : letters) letter = body_.family.count() - 1 - letter;
      return letters;
    };
    if (word != "f" || !body_.symmetric || left.first != right.first || left.letters != mirrored(right.letters))
      return false;
    if (vertices_[left.first].cycle) return cycles_.front().letters == mirrored(cycles_.front().letters);
    const Vector &vertex = body_.vertices[left.first], flipped = turned(word, vertex);
    return vertex == flipped || std::equal(vertex.begin(), vertex.end(), flipped.begin(),
                                           [](const auto& a, const auto& b) { return a == -b; });
  }

  /// Marks the coordinates for which no equation says that image and vertex are equal, or opposite.
  void compare(const Image& image, std::size_t target, const std::string& word, std::vector<bool>& equal,
               std::vector<bool>& opposite) {
    Origins::Way left = origins_.way_to(image.vertex);
    left.letters.insert(left.letters.begin(), image.letter);
    const Origins::Way right = origins_.way_to(target);
    const std::size_t n = body_.size, a = left.letters.size(), b = right.letters.size(),
                      more = std::max(a, b) - std::min(a, b);
    const std::optional<std::size_t> cycle = vertices_[left.first].cycle;
    if (vertices_[right.first].cycle != cycle || (cycle ? more % radius_.length : more) != 0) {
      equal.assign(equal.size(), false);
      opposite = equal;
      return;
    }
    const auto led = [&](const Origins::Way& way, std::size_t k, bool fewer) {
      Vector x = cycle ? cycles_[*cycle].basis[k] : body_.vertices[way.first];
      if (field_) x.resize(2 * n);
      for (std::size_t turn = fewer ? more / radius_.length : 0; turn > 0; --turn)
        x = around(cycles_[*cycle], std::move(x));
      for (std::size_t at = way.letters.size(); at-- > 0;) x = exact_image(way.letters[at], x);
      return x;
    };
    for (std::size_t k = 0; k < (cycle ? cycles_[*cycle].basis.size() : 1); ++k) {
      const Vector moved = led(left, k, a < b), vertex = turned(word, led(right, k, a > b));
      for (std::size_t i = 0; i < moved.size(); ++i) {
        equal[i] = equal[i] && moved[i] == vertex[i];
        opposite[i] = opposite[i] && moved[i] == -vertex[i];
      }
    }
  }

  /// Whether a coordinate of the image is below that of radius * vertex, for a cone.
  bool is_below(const Image& image, std::size_t target, const std::string& word, std::size_t i) {
    const auto matrix = body_.family.matrix(image.letter);
    mpz_class row = 0;
    for (std::size_t k = 0; k < body_.size; ++k) row += matrix[k * body_.size + i];
    const mpq_class off = error_ * largest_;  // no coordinate of a true vertex differs by more
    return body_.image(image.letter, body_.vertices[image.vertex], arithmetic_)[i] + row * off <=
           radius_.low * body_.family.denominator * (turned(word, body_.vertices[target])[i] - off);
  }

  /// The other images lie inside.
  void check_images() const {
    const std::size_t count = body_.family.count();
    const mpz_class residual_one = body_.weight_one * body_.vertex_one * body_.family.denominator;
    for (std::size_t i = 0; i < body_.images.size(); ++i) {
      const Image image{i / count, i % count};
      if (origins_.contains(image) || met_.contains(image)) continue;
      const mpq_class weights = ratio(body_.images[i].weights, body_.weight_one),
                      moved = matrix_error_ * norm(body_.vertices[image.vertex]) / body_.vertex_one,
                      rest = (ratio(body_.images[i].residual, residual_one) + moved) * body_.unit_norm +
                             (body_.bound + weights) * error_;
      require(weights + rest / (1 - error_) <= radius_.low,
              "image " + std::to_string(image.vertex) + " " + std::to_string(image.letter) + " may lie outside");
    }
  }

  const Polytope& body_;
  const ExactRadius& radius_;
  bool many_;                         // families, those of all masks near one
  bool symmetric_;                    // and all these masks
  mpq_class matrix_error_;            // of the matrices, in the 1-norm
  std::optional<FieldFamily> field_;  // of which the matrices are rounded, transposed where they are
  Reader& reader_;
  Arithmetic& arithmetic_;
  std::vector<Vertex> vertices_;
  std::vector<Cycle> cycles_;
  Origins origins_;      // vertices that are images, up to the radius and a sign
  std::set<Image> met_;  // other images whose norm is the radius at most
  mpq_class error_ = 0;
  mpz_class largest_ = 0;  // coordinate of the given vertices
};

}  // namespace

void check_attained(const Polytope& body, const ExactRadius& radius, const FamilyError& error, Reader& reader,
                    Arithmetic& arithmetic) {
  Attained(body, radius, error, reader, arithmetic).run();
}

Image Origins::read(std::size_t j, Reader& reader) {
  const Fields fields = reader.take("origin " + std::to_string(j), 2, 2);
  const Image image{parse_size(fields[0], 0, j - 1), parse_size(fields[1], 0, body_.family.count() - 1)};
  parents_[j] = image;
  children_[image] = j;
  return image;
}

Image Origins::last_image(std::size_t vertex, const std::vector<std::size_t>& letters) const {
  for (std::size_t k = 0; k + 1 < letters.size(); ++k) {
    const auto next = children_.find({vertex, letters[k]});
    require(next != children_.end(), "a vertex of a cycle is missing");
    vertex = next->second;
  }
  return {vertex, letters.back()};
}

Origins::Way Origins::way_to(std::size_t j) {
  Way way{j, {}};
  for (; parents_[way.first]; way.first = parents_[way.first]->vertex)
    way.letters.push_back(parents_[way.first]->letter);
  arithmetic_.spend(way.letters.size());
  return way;
}

Vector Origins::led(Vector x, const std::function<Vector(Vector)>& around, std::size_t turns, const Way& way) {
  for (; turns > 0; --turns) x = around(std::move(x));
  for (std::size_t at = way.letters.size(); at-- > 0;) x = body_.image(way.letters[at], x, arithmetic_);
  return x;
}

}  // namespace subcert_check
