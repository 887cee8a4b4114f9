#include "ball_matrix.hpp"

#if __has_include(<flint/acb_mat.h>)
#include <flint/acb_mat.h>
#else
#include <acb_mat.h>
#endif

namespace subcert {
namespace {

class ComplexBallMatrix {
 public:
  ComplexBallMatrix(std::size_t rows, std::size_t columns) {
    acb_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  ComplexBallMatrix(const ComplexBallMatrix&) = delete;
  ComplexBallMatrix& operator=(const ComplexBallMatrix&) = delete;
  ~ComplexBallMatrix() { acb_mat_clear(value_); }
  acb_mat_struct* get() { return value_; }
  acb_ptr entry(std::size_t i, std::size_t j) {
    return acb_mat_entry(value_, static_cast<slong>(i), static_cast<slong>(j));
  }

 private:
  acb_mat_t value_;
};

}  // namespace

std::optional<EigenpairEnclosure> enclose_eigenpair(const RationalMatrix& matrix, const ComplexVector& approximation,
                                                    slong bits) {
  const std::size_t n = matrix.rows();
  ComplexBallMatrix balls(n, n), start(n, 1), vector(n, 1), subspace(1, 1);
  // Inclusion is decided by absolute errors, so that the vector has to be about as long as 1.
  const Rational unit = power(Rational(2), -binary_exponent(one_norm(approximation)));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) acb_set(balls.entry(i, j), ball_around({matrix(i, j), 0}, bits).get());
    acb_set(start.entry(i, 0), ball_around(unit * approximation[i], bits).get());
  }
  acb_mat_get_mid(start.get(), start.get());
  const ComplexBall near = middle(ball_around(rayleigh_quotient(approximation, matrix * approximation), bits));
  EigenpairEnclosure result{ComplexBall(bits), {}};
  acb_mat_eig_enclosure_rump(result.value.get(), subspace.get(), vector.get(), balls.get(), near.get(), start.get(),
                             bits);
  if (!result.value.is_finite()) return std::nullopt;
  for (std::size_t i = 0; i < n; ++i) {
    result.vector.emplace_back(vector.entry(i, 0), bits);
    if (!result.vector.back().is_finite()) return std::nullopt;
  }
  return result;
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
  ComplexBallMatrix balls(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const Rational entry = -matrix(i, j);
      const RationalComplex shifted = i == j ? RationalComplex{entry + point.re, point.im} : RationalComplex{entry, 0};
      acb_set(balls.entry(i, j), ball_around(shifted, bits).get());
    }
  if (acb_mat_approx_inv(balls.get(), balls.get(), bits) == 0 || acb_mat_is_finite(balls.get()) == 0)
    return std::nullopt;
  std::vector<ComplexVector> columns(n, ComplexVector(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) columns[j][i] = exact_middle(ComplexBall(balls.entry(i, j), bits));
  return columns;
}

}  // namespace subcert
