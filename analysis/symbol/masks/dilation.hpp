#pragma once
/// Dilation matrices and the digits of the classes of the lattice that they leave.

#include <subcert/analysis/symbol/numbers/rational.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace subcert {

/// A point of Z^s, or the exponents of a monomial in s variables.
using LatticePoint = std::vector<long>;

LatticePoint operator+(LatticePoint a, const LatticePoint& b);
LatticePoint operator-(LatticePoint a, const LatticePoint& b);

/// The product of square matrices of one size, given by their rows; of a matrix and a point.
std::vector<LatticePoint> times(const std::vector<LatticePoint>& a, const std::vector<LatticePoint>& b);
LatticePoint times(const std::vector<LatticePoint>& rows, const LatticePoint& point);

/// point^exponents, with 0^0 = 1.
Rational monomial_at(const std::vector<Rational>& point, const LatticePoint& exponents);

/// The lattice points of a box, the first variable running fastest. Domain: low <= high in each variable.
std::vector<LatticePoint> points_of_box(const LatticePoint& low, const LatticePoint& high);

/// All points with non-negative coordinates of this sum: the exponents of the monomials of this total degree.
std::vector<LatticePoint> exponents_of_degree(std::size_t variables, long degree);
/// Of this sum or a smaller one, the smallest first.
std::vector<LatticePoint> exponents_up_to(std::size_t variables, long degree);

/// A subspace that a matrix leaves invariant and on which it is similar to a multiple of an orthogonal matrix.
struct IsotropicSubspace {
  std::vector<LatticePoint> basis;
  long classes;  ///< |det| of the matrix on it, which thus expands it by classes^(1 / basis.size())
};

/// An integer matrix M whose eigenvalues are all larger than 1 in modulus, with a set of digits: one point of each of
/// the |det M| classes of Z^s modulo M Z^s. In one variable M is the arity.
class Dilation {
 public:
  /// The matrix with these rows; where no digits are given those in M [0, 1)^s, the first variable running fastest.
  /// Domain: 1 to 3 rows, entries up to 64 in modulus, |det M| <= 2^18. Errors: throws Error that names what is wrong
  /// with the matrix or with the digits.
  explicit Dilation(std::vector<LatticePoint> rows, std::vector<LatticePoint> digits = {});
  /// factor times the identity. Domain: factor >= 2. Errors: throws Error.
  static Dilation multiple(int variables, int factor);

  std::size_t variables() const { return rows_.size(); }
  const std::vector<LatticePoint>& rows() const { return rows_; }
  const std::vector<LatticePoint>& digits() const { return digits_; }
  /// |det M|.
  long classes() const { return static_cast<long>(digits_.size()); }
  /// The factor of the identity, where M is one.
  std::optional<int> factor() const;
  /// Whether M is similar to a multiple of an orthogonal matrix: diagonalizable over C, all eigenvalues of one modulus,
  /// which is then |det M|^(1/s). Decided exactly.
  bool is_isotropic() const { return isotropic_subspaces_.size() == 1; }
  /// Subspaces with integer bases whose sum is everything, one for each modulus of the eigenvalues, the smallest first.
  /// None where M is not diagonalizable over C, or where an irreducible factor of its characteristic polynomial has
  /// zeros of different moduli.
  const std::vector<IsotropicSubspace>& isotropic_subspaces() const { return isotropic_subspaces_; }

  LatticePoint operator*(const LatticePoint& point) const;
  /// point = M quotient + digits()[digit].
  struct Division {
    LatticePoint quotient;
    std::size_t digit;
  };
  Division divide(const LatticePoint& point) const;
  /// M^-1 times a rational point.
  std::vector<Rational> inverse_times(const std::vector<Rational>& point) const;

  std::string to_text() const;
  bool operator==(const Dilation& other) const { return rows_ == other.rows_ && digits_ == other.digits_; }

 private:
  LatticePoint class_of(const LatticePoint& point) const;

  std::vector<LatticePoint> rows_;
  std::vector<LatticePoint> adjugate_;  // M adjugate = determinant identity
  long determinant_ = 1;
  std::vector<LatticePoint> digits_;
  std::map<LatticePoint, std::size_t> digit_of_class_;
  std::vector<IsotropicSubspace> isotropic_subspaces_;
};

/// Points, or the rows of a matrix, as `[1,2;-2,-1]`.
std::string to_text(const std::vector<LatticePoint>& points);

}  // namespace subcert
