#pragma once
// Numbers |z|^(1/L), and eigenvectors of products for z: section 4.10 of ../certificates/SPEC.md.

#include "arithmetic.hpp"
#include "field.hpp"
#include "polytope.hpp"

#include <functional>
#include <optional>

namespace subcert_check {

constexpr std::size_t most_letters = 1000;  // of a cycle

/// The number |z|^(1/length), z the only zero of a polynomial within a distance of re + i im. Or, of all masks near
/// one, the spectral radius of the product of these letters, from left to right, to the power 1/length: without
/// polynomial.
struct ExactRadius {
  Vector polynomial;  // from the constant coefficient on
  mpq_class re, im, within;
  std::size_t length = 1;
  // What the line `root` says: a zero lies within `error` of near_re + i near_im, and low <= |z|^(1/length) <= high.
  mpq_class near_re, near_im, error, low, high;
  std::vector<std::size_t> letters;
};

/// |[p0,p1,...]@RE,IM,EPS|^1/L
ExactRadius parse_exact_radius(std::string_view text);

constexpr const char* wrong_bounds = "the bounds of the exact radius are wrong";

/// Whether the modulus of each number within `error` of the point does.
bool lies_between(const mpq_class& re, const mpq_class& im, const mpq_class& error, const mpq_class& low,
                  const mpq_class& high);

/// Reads the line `root` and shows that it is right, and that there is only one such zero.
void read_root(ExactRadius& radius, Reader& reader, Arithmetic& arithmetic);

struct Complex {
  mpz_class re, im;
};

mpz_class norm(const Complex& z);  // |re| + |im|
mpz_class norm(const Vector& x);
Complex times(const Complex& a, const Complex& b, Arithmetic& arithmetic);

/// Rounded up to so many binary digits after the point that errors are still small.
mpq_class rounded_up(const mpq_class& x);

/// Reads the line `seed`: y_0, y_1, ..., times powers of `scale`, for which the sum of z^k y_k is an eigenvector of a
/// product for the zero z. `around` is `scale` times the product, which acts on n numbers.
std::vector<Vector> read_seed(const ExactRadius& radius, std::size_t n, const mpz_class& scale,
                              const std::function<Vector(const Vector&)>& around, Reader& reader,
                              Arithmetic& arithmetic);

/// U = sum of z^k y_k.
struct Eigenvector {
  std::vector<Complex> point;  // the point near z in place of z, times a number that depends on the scale only
  mpq_class error;             // at least the sum of |re| + |im| of U times this number, less `point`
};
Eigenvector eigenvector_of(const ExactRadius& radius, const std::vector<Vector>& basis, const mpz_class& scale,
                           Arithmetic& arithmetic);

/// p + sqrt(root) q, of a vector of all p and then all q.
Eigenvector over_field(const Eigenvector& parts, const mpz_class& root);

/// T1,T2,...
std::vector<std::size_t> parse_letters(std::string_view text);
/// T1,T2,... LOW HIGH, section 7.1.
ExactRadius parse_attained(const Fields& fields);

/// What is known of the families for which something is to be shown: of matrices whose entries are within `entry` of
/// the given ones; whether each of them is its own mirror image; or that the family is this one over a field.
struct FamilyError {
  mpq_class entry;
  bool symmetric;
  const FieldFamily* field = nullptr;
};

/// Reads the lines from `cycle` on after those of the polytope, and shows that the joint spectral radius of its family
/// is this number; or with letters the same of all families near by.
void check_attained(const Polytope& body, const ExactRadius& radius, const FamilyError& error, Reader& reader,
                    Arithmetic& arithmetic);

/// Of a vertex under a matrix.
struct Image {
  std::size_t vertex, letter;

  auto operator<=>(const Image&) const = default;
};

/// What the lines `origin` say.
class Origins {
 public:
  Origins(const Polytope& body, Arithmetic& arithmetic)
      : body_(body), arithmetic_(arithmetic), parents_(body.vertices.size()) {}

  /// Reads the line of a vertex, which is not the first one of all. Returns the image from which it stems.
  Image read(std::size_t j, Reader& reader);

  /// Whether a vertex stems from this image.
  bool contains(const Image& image) const { return children_.contains(image); }

  /// The last image of a cycle from this vertex on.
  Image last_image(std::size_t vertex, const std::vector<std::size_t>& letters) const;

  /// The first vertex that a vertex stems from, and the letters in between, the last one first.
  struct Way {
    std::size_t first;
    std::vector<std::size_t> letters;
  };
  Way way_to(std::size_t j);

  /// What so many turns and then the letters of a way make of x.
  Vector led(Vector x, const std::function<Vector(Vector)>& around, std::size_t turns, const Way& way);

 private:
  const Polytope& body_;
  Arithmetic& arithmetic_;
  std::vector<std::optional<Image>> parents_;
  std::map<Image, std::size_t> children_;  // of several with one origin the last one
};

}  // namespace subcert_check
