#include "attained.hpp"

#include <algorithm>
#include <optional>
#include <set>

namespace subcert_check {
namespace {

constexpr std::size_t most_letters = 256;  // of a cycle, and the largest degree
constexpr std::size_t error_bits = 512;    // bounds are rounded up to so many binary digits after the point

struct Complex {
  mpz_class re, im;
};

mpz_class square(const mpz_class& x) { return x * x; }
mpz_class squared_modulus(const Complex& z) { return square(z.re) + square(z.im); }
mpz_class norm(const Complex& z) { return abs(z.re) + abs(z.im); }

Complex times(const Complex& a, const Complex& b, Arithmetic& arithmetic) {
  Complex product;
  arithmetic.add_product(product.re, a.re, b.re);
  arithmetic.add_product(product.re, a.im, -b.im);
  arithmetic.add_product(product.im, a.re, b.im);
  arithmetic.add_product(product.im, a.im, b.re);
  return product;
}

mpz_class norm(const Vector& x) {
  mpz_class sum = 0;
  for (const mpz_class& c : x) sum += abs(c);
  return sum;
}

/// point / scale
struct ComplexRatio {
  Complex point;
  mpz_class scale;

  ComplexRatio(const mpq_class& re, const mpq_class& im) : scale(lcm(re.get_den(), im.get_den())) {
    point = {re.get_num() * (scale / re.get_den()), im.get_num() * (scale / im.get_den())};
  }
};

/// The sum of c_k point^k scale^(n - k), k = 0, ..., n.
Complex form_value(const Vector& c, const ComplexRatio& at, Arithmetic& arithmetic) {
  Complex value{0, 0};
  mpz_class scale = 1;
  for (std::size_t k = c.size(); k-- > 0; scale *= at.scale) {
    value = times(value, at.point, arithmetic);
    arithmetic.add_product(value.re, c[k], scale);
  }
  return value;
}

mpq_class rounded_up(const mpq_class& x) {
  const mpz_class one = mpz_class(1) << error_bits;
  return ratio(ceiling(x * one), one);
}

Vector derivative(const Vector& p) {
  Vector result;
  for (std::size_t k = 1; k < p.size(); ++k) result.push_back(p[k] * k);
  return result;
}

/// The polytope with its true vertices.
class Attained {
 public:
  Attained(const Polytope& body, const ExactRadius& radius, Reader& reader, Arithmetic& arithmetic)
      : body_(body), radius_(radius), reader_(reader), arithmetic_(arithmetic), vertices_(body.vertices.size()) {}

  void run() {
    for (const Vector& vertex : body_.vertices)
      largest_ = std::max(largest_, *std::max_element(vertex.begin(), vertex.end()));
    while (reader_.at("cycle")) read_cycle();
    for (std::size_t j = 0; j < vertices_.size(); ++j)
      if (reader_.at("origin " + std::to_string(j))) read_origin(j);
    for (const Vertex& vertex : vertices_) error_ = std::max(error_, vertex.error);
    require(error_ < 1, "the true vertices are too far from the given ones");
    for (const Cycle& cycle : cycles_) close(cycle);
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
    std::optional<std::size_t> cycle, parent;  // of a first vertex of a cycle; of the image of another one
    std::size_t letter = 0;
    mpq_class error = 0;  // of the norm of true less given vertex
  };
  using Image = std::pair<std::size_t, std::size_t>;  // of a vertex under a matrix

  Vector moved(std::size_t letter, const Vector& x) {
    return arithmetic_.multiply(body_.family.matrix(letter), x, body_.size);
  }
  Vector turned(const std::string& word, Vector x) {
    require(!body_.symmetric || word.size() <= 1, "unknown generator");
    for (std::size_t k = word.size(); k-- > 0;) x = body_.turn(word[k], std::move(x), arithmetic_);
    return x;
  }
  Vector around(const Cycle& cycle, Vector x) {
    for (const std::size_t t : cycle.letters) x = moved(t, x);
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
    const Vector& p = radius_.polynomial;
    const std::size_t degree = p.size() - 1, n = body_.size;
    Vector seed;
    for (const std::string_view field : reader_.take("seed", n, n)) seed.push_back(parse_integer(field));
    // The matrix of the cycle is N / scale, and the zeros of sum p_k scale^(degree - k) x^k are those of p times scale.
    const mpz_class scale = power(body_.family.denominator, cycle.letters.size()).get_num();
    power(scale, degree);  // not too large
    cycle.basis.assign(degree, Vector(n));
    for (std::size_t i = 0; i < n; ++i) cycle.basis[degree - 1][i] = p[degree] * seed[i];
    mpz_class factor = scale;
    for (std::size_t k = degree; k-- > 0; factor *= scale) {
      Vector next = around(cycle, cycle.basis[k]);
      const mpz_class coefficient = p[k] * factor;
      for (std::size_t i = 0; i < n; ++i) arithmetic_.add_product(next[i], coefficient, seed[i]);
      if (k > 0)
        cycle.basis[k - 1] = std::move(next);
      else
        require(norm(next) == 0, "the polynomial of the cycle does not vanish on the seed");
    }
    Vertex& root = vertices_[cycle.root];
    root.cycle = cycles_.size();
    root.error = root_error(cycle, scale);
    cycles_.push_back(std::move(cycle));
  }

  /// How far the eigenvector, scaled so that it has a large coordinate of the given vertex, is from that vertex.
  mpq_class root_error(const Cycle& cycle, const mpz_class& scale) {
    const std::size_t n = body_.size, degree = cycle.basis.size();
    require(body_.parts == 2 || (radius_.im == 0 && radius_.near_im == 0), "a real polytope, but no real eigenvalue");
    ComplexRatio at(radius_.near_re * scale, radius_.near_im * scale);
    const mpq_class away = radius_.error * scale,
                    size = (abs(radius_.near_re) + abs(radius_.near_im) + radius_.error) * scale;
    // U = sum of basis_k at^k, times at.scale^(degree - 1), and a bound for its error.
    std::vector<Complex> vector(n);
    mpz_class whole = 1;
    for (std::size_t k = degree; k-- > 0; whole *= k > 0 ? at.scale : mpz_class(1))
      for (std::size_t i = 0; i < n; ++i) {
        vector[i] = times(vector[i], at.point, arithmetic_);
        arithmetic_.add_product(vector[i].re, cycle.basis[k][i], whole);
      }
    mpq_class slope = 0, powers = 1;
    for (std::size_t k = 1; k < degree; ++k, powers = rounded_up(powers * size))
      slope += mpz_class(k * norm(cycle.basis[k])) * powers;
    const mpq_class off = 2 * away * slope * whole;
    // (v_i U - U_i v) / U_i
    const Vector& given = body_.vertices[cycle.root];
    const auto coordinate = [&](std::size_t i) {
      return Complex{given[i], body_.parts == 2 ? given[n + i] : mpz_class(0)};
    };
    std::size_t largest = 0;
    for (std::size_t i = 1; i < n; ++i)
      if (norm(coordinate(i)) > norm(coordinate(largest))) largest = i;
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
    const Fields fields = reader_.take("origin " + std::to_string(j), 2, 2);
    require(j > 0 && !vertices_[j].cycle, "the first vertex of a cycle is no image");
    const std::size_t parent = parse_size(fields[0], 0, j - 1),
                      letter = parse_size(fields[1], 0, body_.family.count() - 1);
    const Vector image = moved(letter, body_.vertices[parent]);
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
                          (radius_.high - radius_.low) * norm(body_.vertices[j]);
    Vertex& vertex = vertices_[j];
    vertex.parent = parent;
    vertex.letter = letter;
    vertex.error = rounded_up((body_.bound * vertices_[parent].error + off * body_.unit_norm / body_.vertex_one) /
                              radius_.low);
    children_[{parent, letter}] = j;
  }

  /// The last image of a cycle is its first vertex, up to a factor and the group.
  void close(const Cycle& cycle) {
    std::size_t at = cycle.root;
    for (std::size_t k = 0; k + 1 < cycle.letters.size(); ++k) {
      const auto next = children_.find({at, cycle.letters[k]});
      require(next != children_.end(), "a vertex of a cycle is missing");
      at = next->second;
    }
    met_.emplace(at, cycle.letters.back());
  }

  /// The first vertex that a vertex stems from, and the letters in between, the last one first.
  std::pair<std::size_t, std::vector<std::size_t>> descent(std::size_t j) {
    std::vector<std::size_t> letters;
    for (; vertices_[j].parent; j = *vertices_[j].parent) letters.push_back(vertices_[j].letter);
    arithmetic_.spend(letters.size());
    return {j, std::move(letters)};
  }

  /// An image is a vertex, up to its sign, because both stem from one cycle, or from given vertices, by linear
  /// equations. Cones: it lies below, as each coordinate is equal by such equations, or clearly less.
  void read_same() {
    const Fields fields = reader_.take("same", 3, 3);
    const std::size_t source = parse_size(fields[0], 0, vertices_.size() - 1),
                      letter = parse_size(fields[1], 0, body_.family.count() - 1);
    const auto [target, word] = parse_turned_index(fields[2], vertices_.size());
    const std::size_t n = body_.size;
    std::vector<bool> equal(body_.parts * n, true), opposite = equal;
    compare(source, letter, target, word, equal, opposite);
    for (std::size_t i = 0; body_.nonnegative && i < n; ++i)
      equal[i] = equal[i] || is_below(source, letter, target, word, i);
    const auto all = [](const std::vector<bool>& marks) {
      return std::find(marks.begin(), marks.end(), false) == marks.end();
    };
    require(all(equal) || all(opposite), "an image is not the vertex that it is said to be");
    met_.emplace(source, letter);
  }

  /// Marks the coordinates for which no equation says that image and vertex are equal, or opposite.
  void compare(std::size_t source, std::size_t letter, std::size_t target, const std::string& word,
               std::vector<bool>& equal, std::vector<bool>& opposite) {
    auto [from, left] = descent(source);
    left.insert(left.begin(), letter);
    const auto [to, right] = descent(target);
    const std::optional<std::size_t> cycle = vertices_[from].cycle;
    const std::size_t more = std::max(left.size(), right.size()) - std::min(left.size(), right.size());
    if (vertices_[to].cycle != cycle || (cycle ? more % radius_.length : more) != 0) {
      equal.assign(equal.size(), false);
      opposite = equal;
      return;
    }
    const auto led = [&](std::size_t first, std::size_t k, bool fewer, const std::vector<std::size_t>& letters) {
      Vector x = cycle ? cycles_[*cycle].basis[k] : body_.vertices[first];
      for (std::size_t turns = 0; fewer && turns < more / radius_.length; ++turns)
        x = around(cycles_[*cycle], std::move(x));
      for (std::size_t at = letters.size(); at-- > 0;) x = moved(letters[at], x);
      return x;
    };
    for (std::size_t k = 0; k < (cycle ? cycles_[*cycle].basis.size() : 1); ++k) {
      const Vector image = led(from, k, left.size() < right.size(), left),
                   vertex = turned(word, led(to, k, left.size() > right.size(), right));
      for (std::size_t i = 0; i < image.size(); ++i) {
        equal[i] = equal[i] && image[i] == vertex[i];
        opposite[i] = opposite[i] && image[i] == -vertex[i];
      }
    }
  }

  /// Whether a coordinate of the image is below that of radius * vertex, for a cone.
  bool is_below(std::size_t source, std::size_t letter, std::size_t target, const std::string& word, std::size_t i) {
    const auto matrix = body_.family.matrix(letter);
    mpz_class row = 0;
    for (std::size_t k = 0; k < body_.size; ++k) row += matrix[k * body_.size + i];
    const mpq_class off = error_ * largest_;  // no coordinate of a true vertex differs by more
    return moved(letter, body_.vertices[source])[i] + row * off <=
           radius_.low * body_.family.denominator * (turned(word, body_.vertices[target])[i] - off);
  }

  /// The other images lie inside.
  void check_images() const {
    const std::size_t count = body_.family.count();
    const mpz_class residual_one = body_.weight_one * body_.vertex_one * body_.family.denominator;
    for (std::size_t i = 0; i < body_.images.size(); ++i) {
      const Image image{i / count, i % count};
      if (children_.contains(image) || met_.contains(image)) continue;
      const mpq_class weights = ratio(body_.images[i].weights, body_.weight_one),
                      rest = ratio(body_.images[i].residual * body_.unit_norm, residual_one) +
                             (body_.bound + weights) * error_;
      require(weights + rest / (1 - error_) <= radius_.low,
              "image " + std::to_string(image.first) + " " + std::to_string(image.second) + " may lie outside");
    }
  }

  const Polytope& body_;
  const ExactRadius& radius_;
  Reader& reader_;
  Arithmetic& arithmetic_;
  std::vector<Vertex> vertices_;
  std::vector<Cycle> cycles_;
  std::map<Image, std::size_t> children_;  // vertices that are images, up to the radius and a sign
  std::set<Image> met_;                    // other images whose norm is the radius at most
  mpq_class error_ = 0;
  mpz_class largest_ = 0;  // coordinate of the given vertices
};

}  // namespace

ExactRadius parse_exact_radius(std::string_view text) {
  constexpr const char* expected = "an exact radius is |[p0,p1,...]@RE,IM,EPS|^1/L";
  const std::size_t end = text.find("]@"), power = text.rfind("|^1/");
  require(text.starts_with("|[") && end < power && power < text.size(), expected);
  const Fields point = split(text.substr(end + 2, power - end - 2), ",");
  require(point.size() == 3, expected);
  ExactRadius radius;
  for (const std::string_view c : split(text.substr(2, end - 2), ",")) radius.polynomial.push_back(parse_integer(c));
  const std::size_t degree = radius.polynomial.size() - 1;
  require(degree >= 1 && degree <= most_letters && radius.polynomial.back() != 0,
          "a polynomial has the degree 1 to 256 and a leading coefficient that is not zero");
  radius.re = parse_rational(point[0]);
  radius.im = parse_rational(point[1]);
  radius.within = parse_rational(point[2]);
  require(radius.within > 0, "the distance of a zero must be positive");
  radius.length = parse_size(text.substr(power + 4), 1, most_letters);
  return radius;
}

void read_root(ExactRadius& radius, Reader& reader, Arithmetic& arithmetic) {
  const Fields fields = reader.take("root", 5, 5);
  mpq_class* const numbers[] = {&radius.near_re, &radius.near_im, &radius.error, &radius.low, &radius.high};
  for (std::size_t k = 0; k < 5; ++k) *numbers[k] = parse_rational(fields[k]);
  const auto squared = [](const mpq_class& x) { return mpq_class(x * x); };
  const mpq_class &error = radius.error, low = power(radius.low, radius.length),
                  high = power(radius.high, radius.length);
  require(error >= 0 && radius.low > 0, "the error of a root is negative, or its modulus not positive");
  const mpq_class away = squared(radius.near_re - radius.re) + squared(radius.near_im - radius.im),
                  modulus = squared(radius.near_re) + squared(radius.near_im);
  require(error <= radius.within && away <= squared(radius.within - error), "the root is not the one of the claim");
  require(squared(low + error) <= modulus && high >= error && modulus <= squared(high - error),
          "the bounds of the exact radius are wrong");
  // A zero within n |p/p'| of the point.
  const Vector &p = radius.polynomial, slope = derivative(p);
  const ComplexRatio near(radius.near_re, radius.near_im), centre(radius.re, radius.im);
  const mpz_class value = squared_modulus(form_value(p, near, arithmetic)),
                  steep = squared_modulus(form_value(slope, near, arithmetic));
  require(steep > 0 && square(mpz_class(slope.size())) * value <= squared(error * near.scale) * steep,
          "no zero is proved so near");
  // Only one: |p'(x) - p'(centre)| < |p'(centre)| for all x of the disc.
  const mpq_class size = abs(radius.re) + abs(radius.im) + radius.within;
  mpq_class change = 0;
  for (std::size_t k = p.size(); k-- > 2;) change = rounded_up(change * size) + abs(mpz_class(p[k] * k * (k - 1)));
  const mpq_class steepness = ratio(squared_modulus(form_value(slope, centre, arithmetic)),
                                    power(centre.scale, 2 * (slope.size() - 1)).get_num());
  require(squared(change * radius.within) < steepness, "more than one zero may be so near");
}

void check_attained(const Polytope& body, const ExactRadius& radius, Reader& reader, Arithmetic& arithmetic) {
  Attained(body, radius, reader, arithmetic).run();
}

}  // namespace subcert_check
