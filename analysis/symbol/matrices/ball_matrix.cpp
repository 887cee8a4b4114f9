#include "ball_matrix.hpp"

#if __has_include(<flint/acb_mat.h>)
#include <flint/acb_mat.h>
#else
#include <acb_mat.h>
#endif

#include <cmath>
#include <numbers>

namespace subcert {
namespace {

constexpr slong few_bits = 128;  // of inverses that only have to contract

class ComplexBallMatrix {
 public:
  ComplexBallMatrix(std::size_t rows, std::size_t columns) {
    acb_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  /// Of numbers with so many bits.
  ComplexBallMatrix(const RationalMatrix& matrix, slong bits) : ComplexBallMatrix(matrix.rows(), matrix.columns()) {
    for (std::size_t i = 0; i < matrix.rows(); ++i)
      for (std::size_t j = 0; j < matrix.columns(); ++j)
        acb_set(entry(i, j), ball_around({matrix(i, j), 0}, bits).get());
  }
  ComplexBallMatrix(const ComplexBallMatrix&) = delete;
  ComplexBallMatrix& operator=(const ComplexBallMatrix&) = delete;
  ~ComplexBallMatrix() { acb_mat_clear(value_); }
  std::size_t rows() const { return static_cast<std::size_t>(acb_mat_nrows(value_)); }
  std::size_t columns() const { return static_cast<std::size_t>(acb_mat_ncols(value_)); }
  acb_mat_struct* get() { return value_; }
  acb_ptr entry(std::size_t i, std::size_t j) {
    return acb_mat_entry(value_, static_cast<slong>(i), static_cast<slong>(j));
  }

 private:
  acb_mat_t value_;
};

/// The largest sum of moduli of a row.
Ball norm(ComplexBallMatrix& matrix) {
  constexpr slong bits = 64;
  Ball most(bits);
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    Ball sum(bits);
    for (std::size_t j = 0; j < matrix.columns(); ++j) sum += abs(ComplexBall(matrix.entry(i, j), bits));
    most = max(most, sum);
  }
  return most.upper_end();
}

/// A zero of F(v, x) = ((A - x) v, v_k - 1), k the place of the largest entry of the approximation of v. The inverse of
/// its derivative needs few bits: steps with a fixed one come as close as wanted.
class EigenpairSearch {
 public:
  EigenpairSearch(const RationalMatrix& matrix, const RationalComplex& near, slong bits)
      : n_(matrix.rows()),
        bits_(bits),
        matrix_(matrix, bits),
        vector_(n_, 1),
        value_(middle(ball_around(near, bits))) {}

  void start(const ComplexVector& vector) {
    for (std::size_t i = 0; i < n_; ++i) acb_set(vector_.entry(i, 0), ball_around(vector[i], bits_).get());
    normalise();
  }

  /// By inverse iteration, each time from a point beside the eigenvalue that the last step tells. False where that does
  /// not settle soon, as the approximation is a bad one. Domain: entries up to about 1.
  bool start(slong few, const Deadline& deadline) {
    ComplexBallMatrix factors(n_, n_);
    std::vector<slong> pivots(n_);
    const Ball size = abs(value_).upper_end(),
               beside = (size.is_less(Ball(Rational(1, 1L << 40), bits_)) ? Ball(1L, bits_).scaled(-40) : size)
                            .scaled(-few / 2);
    // Irregular, so that no eigenvector has no share of it.
    for (std::size_t i = 0; i < n_; ++i)
      acb_set_d(vector_.entry(i, 0), 1 + std::fmod(std::numbers::phi * static_cast<double>(i + 1), 1));
    for (int k = 0; k < inverse_steps && !deadline.expired(); ++k) {
      const ComplexBall point = value_ + beside;
      put_shifted(factors, point);
      if (acb_mat_approx_lu(pivots.data(), factors.get(), factors.get(), few) == 0) return false;
      for (int repeated = 0; repeated < 2; ++repeated) {
        acb_mat_approx_solve_lu_precomp(vector_.get(), pivots.data(), factors.get(), vector_.get(), few);
        if (acb_mat_is_finite(vector_.get()) == 0 || acb_mat_is_zero(vector_.get()) != 0) return false;
        if (repeated == 0) normalise();
      }
      const ComplexBall scale = middle(ComplexBall(vector_.entry(largest_, 0), bits_));
      normalise();
      const ComplexBall next = middle(point + ComplexBall(Ball(1L, bits_)) / scale);
      if (!next.is_finite()) return false;
      const bool settled = abs(next - value_).is_less(beside.scaled(2));
      value_ = next;
      if (settled) return true;
    }
    return false;
  }

  /// With an inverse of `few` bits. Nothing where that isolates no simple eigenpair, or time ends between two steps.
  std::optional<EigenpairEnclosure> enclosure(slong few, const Deadline& deadline) {
    ComplexBallMatrix inverse(n_ + 1, n_ + 1), product(n_ + 1, n_ + 1), step(n_ + 1, 1);
    derivative(product);
    if (acb_mat_approx_inv(inverse.get(), product.get(), few) == 0 || acb_mat_is_finite(inverse.get()) == 0 ||
        deadline.expired())
      return std::nullopt;
    acb_mat_get_mid(inverse.get(), inverse.get());
    improve(inverse, deadline);
    if (deadline.expired()) return std::nullopt;
    // Let C be that inverse and r twice |C F|. Where |1 - C F'| + 2 |C| r <= 1/2, the map 1 - C F takes the points
    // within r of this one to such points, as the quadratic part of F is the product of the changes of v and x; and F'
    // has an inverse there, so that the eigenvalue is simple. Where all is real, so is the fixed point.
    derivative(product);
    acb_mat_mul(product.get(), inverse.get(), product.get(), few);
    if (deadline.expired()) return std::nullopt;
    for (std::size_t i = 0; i <= n_; ++i) acb_sub_ui(product.entry(i, i), product.entry(i, i), 1, few);
    residual(step);
    acb_mat_mul(step.get(), inverse.get(), step.get(), bits_);
    const Ball error = norm(step).scaled(1), change = norm(product) + (norm(inverse) * error).scaled(1);
    if (!change.is_at_most(Ball(Rational(1, 2), bits_))) return std::nullopt;
    const bool real = acb_mat_is_real(vector_.get()) != 0 && acb_is_real(value_.get()) != 0;
    const auto widened = [&](const ComplexBall& point) {
      return real ? ComplexBall(point.real().widened(error)) : point.widened(error);
    };
    EigenpairEnclosure result{widened(value_), {}};
    for (std::size_t i = 0; i < n_; ++i) result.vector.push_back(widened(ComplexBall(vector_.entry(i, 0), bits_)));
    return result;
  }

 private:
  static constexpr int inverse_steps = 8, newton_steps = 60;

  /// Its largest entry becomes 1.
  void normalise() {
    acb_mat_get_mid(vector_.get(), vector_.get());
    Ball most(64);
    for (std::size_t i = 0; i < n_; ++i)
      if (const Ball modulus = abs(ComplexBall(vector_.entry(i, 0), 64)); most.is_less(modulus)) {
        most = modulus;
        largest_ = i;
      }
    const ComplexBall unit(vector_.entry(largest_, 0), bits_);
    for (std::size_t i = 0; i < n_; ++i) acb_div(vector_.entry(i, 0), vector_.entry(i, 0), unit.get(), bits_);
    acb_mat_get_mid(vector_.get(), vector_.get());
    acb_one(vector_.entry(largest_, 0));
  }

  /// The matrix less a number, in the first rows and columns.
  void put_shifted(ComplexBallMatrix& result, const ComplexBall& shift) {
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < n_; ++j) acb_set(result.entry(i, j), matrix_.entry(i, j));
    for (std::size_t i = 0; i < n_; ++i) acb_sub(result.entry(i, i), result.entry(i, i), shift.get(), bits_);
  }

  void derivative(ComplexBallMatrix& result) {
    acb_mat_zero(result.get());
    put_shifted(result, value_);
    for (std::size_t i = 0; i < n_; ++i) acb_neg(result.entry(i, n_), vector_.entry(i, 0));
    acb_one(result.entry(n_, largest_));
  }

  /// F, the last entry of which is 0.
  void residual(ComplexBallMatrix& result) {
    ComplexBallMatrix image(n_, 1);
    acb_mat_mul(image.get(), matrix_.get(), vector_.get(), bits_);
    acb_zero(result.entry(n_, 0));
    for (std::size_t i = 0; i < n_; ++i) {
      acb_set(result.entry(i, 0), image.entry(i, 0));
      acb_submul(result.entry(i, 0), value_.get(), vector_.entry(i, 0), bits_);
    }
  }

  /// Steps as long as they become shorter.
  void improve(ComplexBallMatrix& inverse, const Deadline& deadline) {
    ComplexBallMatrix step(n_ + 1, 1);
    Ball last = Ball::indeterminate(64);
    for (int k = 0; k < newton_steps && !deadline.expired(); ++k) {
      residual(step);
      acb_mat_approx_mul(step.get(), inverse.get(), step.get(), bits_);
      const Ball length = norm(step);
      if (!length.is_finite() || (last.is_finite() && !length.scaled(1).is_less(last))) break;
      last = length;
      for (std::size_t i = 0; i < n_; ++i)
        if (i != largest_) acb_sub(vector_.entry(i, 0), vector_.entry(i, 0), step.entry(i, 0), bits_);
      acb_sub(value_.get(), value_.get(), step.entry(n_, 0), bits_);
      acb_mat_get_mid(vector_.get(), vector_.get());
      value_ = middle(value_);
    }
  }

  std::size_t n_;
  slong bits_;
  ComplexBallMatrix matrix_, vector_;
  ComplexBall value_;
  std::size_t largest_ = 0;
};

/// `start` makes an approximation with so many bits, or false. Inverses of few bits do, most often.
template <class Start>
std::optional<EigenpairEnclosure> enclosure_of(const RationalMatrix& matrix, const RationalComplex& near, slong bits,
                                               const Deadline& deadline, const Start& start) {
  const long exponent = binary_exponent(matrix).value_or(0);
  const Rational unit = power(Rational(2), -exponent);
  EigenpairSearch search(unit * matrix, unit * near, bits);
  for (const slong few : {std::min(bits, few_bits), bits}) {
    if (deadline.expired() || !start(search, few)) return std::nullopt;
    if (auto found = search.enclosure(few, deadline)) {
      found->value = found->value.scaled(exponent);
      return found;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<EigenpairEnclosure> enclose_eigenpair(const RationalMatrix& matrix, const ComplexVector& approximation,
                                                    slong bits, const Deadline& deadline) {
  return enclosure_of(matrix, rayleigh_quotient(approximation, matrix * approximation), bits, deadline,
                      [&](EigenpairSearch& search, slong) {
                        search.start(approximation);
                        return true;
                      });
}

std::optional<EigenpairEnclosure> enclose_eigenpair(const RationalMatrix& matrix, const RationalComplex& near,
                                                    slong bits, const Deadline& deadline) {
  return enclosure_of(matrix, near, bits, deadline,
                      [&](EigenpairSearch& search, slong few) { return search.start(few, deadline); });
}

std::optional<std::vector<EigenvalueGroup>> eigenvalues(const std::vector<std::vector<Ball>>& matrix, slong bits) {
  const std::size_t n = matrix.size();
  ComplexBallMatrix balls(n, n), middles(n, n), right(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) acb_set_arb(balls.entry(i, j), matrix[i][j].get());
  acb_mat_get_mid(middles.get(), balls.get());
  ComplexBallMatrix approximate(1, n), enclosed(1, n);
  acb_mat_approx_eig_qr(approximate.entry(0, 0), nullptr, right.get(), middles.get(), nullptr, 0, bits);
  if (acb_mat_eig_multiple(enclosed.entry(0, 0), balls.get(), approximate.entry(0, 0), right.get(), bits) == 0)
    return std::nullopt;
  std::vector<EigenvalueGroup> groups;
  for (std::size_t i = 0; i < n; ++i) {
    const ComplexBall value(enclosed.entry(0, i), bits);
    if (!value.is_finite()) return std::nullopt;
    const auto known = std::find_if(groups.begin(), groups.end(),
                                    [&](const EigenvalueGroup& group) { return overlap(group.value, value); });
    // Those of one group have one ball.
    if (known == groups.end())
      groups.push_back({value, 1});
    else if (acb_equal(known->value.get(), value.get()) == 0)
      return std::nullopt;
    else
      ++known->count;
  }
  return groups;
}

std::optional<std::vector<ComplexVector>> inverse_columns(const RationalMatrix& matrix, const RationalComplex& point,
                                                          slong bits) {
  const std::size_t n = matrix.rows();
  ComplexBallMatrix balls(Rational(-1) * matrix, bits), inverse(n, n);
  const auto add_to_diagonal = [&](ComplexBallMatrix& to, const RationalComplex& number) {
    const ComplexBall ball = ball_around(number, bits);
    for (std::size_t i = 0; i < n; ++i) acb_add(to.entry(i, i), to.entry(i, i), ball.get(), bits);
  };
  if (point.im == 0) {
    add_to_diagonal(balls, point);
    if (acb_mat_approx_inv(inverse.get(), balls.get(), bits) == 0) return std::nullopt;
  } else {
    // (c - M)^-1 = (c' - M) ((re c - M)^2 + (im c)^2)^-1, as real matrices have the shorter products.
    add_to_diagonal(balls, {point.re, 0});
    ComplexBallMatrix square(n, n);
    acb_mat_approx_mul(square.get(), balls.get(), balls.get(), bits);
    add_to_diagonal(square, {point.im * point.im, 0});
    acb_mat_get_mid(square.get(), square.get());
    if (acb_mat_approx_inv(square.get(), square.get(), bits) == 0) return std::nullopt;
    acb_mat_approx_mul(inverse.get(), balls.get(), square.get(), bits);
    const ComplexBall turned = ball_around({0, -point.im}, bits);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) acb_addmul(inverse.entry(i, j), turned.get(), square.entry(i, j), bits);
  }
  if (acb_mat_is_finite(inverse.get()) == 0) return std::nullopt;
  std::vector<ComplexVector> columns(n, ComplexVector(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) columns[j][i] = exact_middle(ComplexBall(inverse.entry(i, j), bits));
  return columns;
}

}  // namespace subcert
