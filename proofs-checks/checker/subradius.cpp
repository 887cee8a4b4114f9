#include "subradius.hpp"

#include "exact_radius.hpp"

#include <algorithm>
#include <set>

namespace subcert_check {
namespace {

Vector read_weights(const std::string& head, std::size_t n, Reader& reader) {
  Vector weights;
  for (const std::string_view field : reader.take(head, n, n)) {
    weights.push_back(parse_integer(field));
    require(weights.back() > 0, "a weight is not positive");
  }
  return weights;
}

/// a c - b d
mpz_class difference(const mpz_class& a, const mpz_class& c, const mpz_class& b, const mpz_class& d,
                     Arithmetic& arithmetic) {
  mpz_class result = 0;
  arithmetic.add_product(result, a, c);
  arithmetic.add_product(result, b, -d);
  return result;
}

/// Whether x <= factor * y in each coordinate.
bool is_at_most(const Vector& x, const mpq_class& factor, const Vector& y, Arithmetic& arithmetic) {
  for (std::size_t i = 0; i < x.size(); ++i)
    if (difference(factor.get_num(), y[i], factor.get_den(), x[i], arithmetic) < 0) return false;
  return true;
}

/// A product that takes positive weights to at most RE times them.
void read_upper_end(const Family& family, const std::optional<mpq_class>& upper, Reader& reader,
                    Arithmetic& arithmetic) {
  const Fields fields = reader.take("product", 4, 3 + 4096);
  parse_size(fields[0], 0, 0);
  const mpq_class re = parse_rational(fields[1]), im = parse_rational(fields[2]);
  require(re >= 0 && im == 0, "the product of a subradius needs a real number that is not negative");
  std::vector<std::size_t> letters;
  for (std::size_t i = 3; i < fields.size(); ++i) letters.push_back(parse_size(fields[i], 0, family.count() - 1));
  const Vector weights = read_weights("weights", family.size, reader);
  Vector image = weights;
  for (std::size_t i = letters.size(); i-- > 0;)
    image = arithmetic.multiply(family.matrix(letters[i]), image, family.size);
  require(is_at_most(image, re * power(family.denominator, letters.size()), weights, arithmetic),
          "the product takes a weight to more than the given multiple");
  require(!upper || (*upper >= 0 && re <= power(*upper, letters.size())), "the product does not prove the upper end");
}

/// Vertices that each matrix takes above a multiple of a mean of vertices.
Polytope read_lower_end(const Family& family, const std::optional<mpq_class>& lower, Reader& reader,
                        Arithmetic& arithmetic) {
  Fields fields = reader.take("block 0", 4, 5);
  require(fields.size() == 4 || fields[4] == "transposed", "unknown property of the polytope of a subradius");
  fields.push_back("nonnegative");
  Polytope body = read_polytope_head(family, fields, 0, reader, arithmetic);
  while (body.vertices.size() < body.count) require(read_vertex(body, reader) != Vector(body.size), "a vertex is 0");
  std::optional<mpz_class> least;
  for (std::size_t j = 0; j < body.count; ++j)
    for (std::size_t t = 0; t < family.count(); ++t) {
      body.images.push_back(read_image(body, j, t, -1, reader, arithmetic));
      const auto& [weights, residual] = body.images.back();
      require(residual == 0, "an image is not above the sum of its terms");
      least = least ? std::min(*least, weights) : weights;
    }
  require(!lower || *lower * body.weight_one <= *least, "the weights of an image do not prove the lower end");
  return body;
}

/// The polytope with its true vertices, of which the first one is an eigenvector of a product.
class SlowProduct {
 public:
  SlowProduct(const Polytope& body, const ExactRadius& radius, Reader& reader, Arithmetic& arithmetic)
      : body_(body),
        radius_(radius),
        reader_(reader),
        arithmetic_(arithmetic),
        origins_(body, arithmetic),
        cut_(body.count, false) {}

  void run() {
    read_cycle();
    while (factors_.size() < body_.count) read_origin(factors_.size());
    const Image last = origins_.last_image(0, letters_);
    require(!cut_[last.vertex], "a vertex of the cycle is cut");
    met_.insert(last);
    needed_ = radius_.high * *std::max_element(factors_.begin(), factors_.end());
    while (reader_.at("same")) read_same();
    check_images();
  }

 private:
  Vector around(Vector x) {
    for (const std::size_t t : letters_) x = body_.image(t, x, arithmetic_);
    return x;
  }

  void read_cycle() {
    for (const std::string_view field : reader_.take("cycle 0 -", radius_.length, radius_.length))
      letters_.push_back(parse_size(field, 0, body_.family.count() - 1));
    const mpz_class scale = power(body_.family.denominator, letters_.size()).get_num();
    basis_ = read_seed(
        radius_, body_.size, scale, [this](const Vector& x) { return around(x); }, reader_, arithmetic_);
    factors_.push_back(first_factor(scale));
    const Vector& given = body_.vertices[0];
    if (std::count(given.begin(), given.end(), 0) == 0) return;
    Vector rest = read_weights("rest", body_.size, reader_);
    const auto drop_others = [&](Vector& x) {
      for (std::size_t i = 0; i < body_.size; ++i)
        if (given[i] > 0) x[i] = 0;
    };
    drop_others(rest);
    Vector image = around(rest);
    drop_others(image);
    require(is_at_most(image, power(radius_.low, letters_.size()) * scale, rest, arithmetic_),
            "the cycle takes a weight of the rest to too much");
  }

  /// What the first vertex times that is at least the true one, a multiple of the eigenvector that it is at most.
  mpq_class first_factor(const mpz_class& scale) {
    const Vector& given = body_.vertices[0];
    const Eigenvector eigenvector = eigenvector_of(radius_, basis_, scale, arithmetic_);
    const auto first = std::find_if(given.begin(), given.end(), [](const mpz_class& x) { return x > 0; });
    const int sign = eigenvector.point[static_cast<std::size_t>(first - given.begin())].re < 0 ? -1 : 1;
    Vector least, most;  // bounds of the eigenvector times one number
    for (std::size_t i = 0; i < body_.size; ++i) {
      const auto is_zero = [i](const Vector& y) { return y[i] == 0; };
      mpz_class point = 0;
      arithmetic_.add_product(point, eigenvector.point[i].re, sign * eigenvector.error.get_den());
      least.push_back(point - eigenvector.error.get_num());
      most.push_back(point + eigenvector.error.get_num());
      require(given[i] > 0 ? least[i] > 0 : std::all_of(basis_.begin(), basis_.end(), is_zero),
              "a coordinate of the eigenvector may not be positive, or not be 0, as that of the vertex is");
    }
    return rounded_up(largest_quotient(given, least) * largest_quotient(most, given));
  }

  /// Of the coordinates of two vectors, where that of the second one is positive.
  mpq_class largest_quotient(const Vector& x, const Vector& y) {
    mpz_class top = 0, bottom = 1;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (y[i] > 0 && difference(x[i], bottom, top, y[i], arithmetic_) > 0) {
        top = x[i];
        bottom = y[i];
      }
    return ratio(top, bottom);
  }

  /// True vertex j is (matrix) (true parent) / radius, where the given vertex is not 0.
  void read_origin(std::size_t j) {
    const auto [parent, letter] = origins_.read(j, reader_);
    const Vector &vertex = body_.vertices[j], image = body_.image(letter, body_.vertices[parent], arithmetic_);
    require(is_at_most(vertex, 1 / (radius_.high * body_.family.denominator), image, arithmetic_),
            "a vertex is above the image from which it stems");
    cut_[j] = cut_[parent];
    for (std::size_t i = 0; i < body_.size; ++i)
      if (vertex[i] == 0 && image[i] > 0) cut_[j] = true;
    factors_.push_back(
        rounded_up(factors_[parent] * largest_quotient(image, vertex) / (radius_.low * body_.family.denominator)));
  }

  /// An image is above a vertex, as each coordinate is equal by linear equations, or clearly more.
  void read_same() {
    const Fields fields = reader_.take("same", 3, 3);
    const Image image{parse_size(fields[0], 0, body_.count - 1), parse_size(fields[1], 0, body_.family.count() - 1)};
    const std::size_t target = parse_size(fields[2], 0, body_.count - 1);
    const Vector &vertex = body_.vertices[target],
                 moved = body_.image(image.letter, body_.vertices[image.vertex], arithmetic_);
    const std::vector<bool> equal = equal_coordinates(image, target);
    const mpq_class needed = needed_ * body_.family.denominator;
    for (std::size_t i = 0; i < body_.size; ++i)
      if (!equal[i])
        require(difference(moved[i], needed.get_den(), vertex[i], needed.get_num(), arithmetic_) >= 0,
                "an image is not above the vertex that it is said to be");
    met_.insert(image);
  }

  /// Those for which equations say that the true image is a multiple of the true vertex.
  std::vector<bool> equal_coordinates(const Image& image, std::size_t target) {
    std::vector<bool> equal(body_.size, false);
    if (cut_[image.vertex] || cut_[target]) return equal;
    Origins::Way left = origins_.way_to(image.vertex);
    left.letters.insert(left.letters.begin(), image.letter);
    const Origins::Way right = origins_.way_to(target);
    const std::size_t a = left.letters.size(), b = right.letters.size(), more = std::max(a, b) - std::min(a, b);
    if (more % radius_.length != 0) return equal;
    equal.flip();
    for (const Vector& y : basis_) {
      const auto led = [&](const Origins::Way& way, bool fewer) {
        return origins_.led(
            y, [this](const Vector& x) { return around(x); }, fewer ? more / radius_.length : 0, way);
      };
      const Vector first = led(left, a < b), second = led(right, a > b);
      for (std::size_t i = 0; i < body_.size; ++i) equal[i] = equal[i] && first[i] == second[i];
    }
    return equal;
  }

  /// The other images are above combinations of the true vertices.
  void check_images() const {
    const std::size_t count = body_.family.count();
    const mpz_class least = ceiling(needed_ * body_.weight_one);
    for (std::size_t i = 0; i < body_.images.size(); ++i) {
      const Image image{i / count, i % count};
      require(body_.images[i].weights >= least || origins_.contains(image) || met_.contains(image),
              "image " + std::to_string(image.vertex) + " " + std::to_string(image.letter) + " may lie below");
    }
  }

  const Polytope& body_;
  const ExactRadius& radius_;
  Reader& reader_;
  Arithmetic& arithmetic_;
  std::vector<std::size_t> letters_;  // of the cycle, the first one is applied first
  std::vector<Vector> basis_;         // y_0, y_1, ...
  Origins origins_;
  std::vector<mpq_class> factors_;  // vertices times them are at least the true ones
  std::vector<bool> cut_;           // vertices that lost coordinates, or stem from such
  mpq_class needed_;                // a factor for all of them, times the radius
  std::set<Image> met_;             // other images that are above multiples of true vertices
};

}  // namespace

void read_subradius(const Family& family, const Subradius& claim, Reader& reader, Arithmetic& arithmetic) {
  require(!claim.exact || (claim.exact->im == 0 && claim.exact->near_im == 0), "a subradius needs a real zero");
  if (claim.upper || reader.at("product")) read_upper_end(family, claim.upper, reader, arithmetic);
  if (!claim.lower && !claim.exact && !reader.at("block 0")) return;
  const Polytope body = read_lower_end(family, claim.lower, reader, arithmetic);
  if (claim.exact) SlowProduct(body, *claim.exact, reader, arithmetic).run();
}

}  // namespace subcert_check
