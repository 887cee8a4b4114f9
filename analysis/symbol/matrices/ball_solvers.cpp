#include "ball_solvers.hpp"

#if __has_include(<flint/arb_mat.h>)
#include <flint/arb_mat.h>
#else
#include <arb_mat.h>
#endif

namespace subcert {
namespace {

class Matrix {
 public:
  Matrix(std::size_t rows, std::size_t columns) {
    arb_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  Matrix(const Matrix&) = delete;
  Matrix& operator=(const Matrix&) = delete;
  ~Matrix() { arb_mat_clear(value_); }
  arb_ptr entry(std::size_t i, std::size_t j) {
    return arb_mat_entry(value_, static_cast<slong>(i), static_cast<slong>(j));
  }
  arb_mat_struct* get() { return value_; }

 private:
  arb_mat_t value_;
};

void copy(Matrix& target, const std::vector<std::vector<Ball>>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows[i].size(); ++j) arb_set(target.entry(i, j), rows[i][j].get());
}

using Function = std::function<ComplexBall(const ComplexBall&)>;

int evaluate(acb_ptr result, const acb_t s, void* function, slong, slong bits) {
  acb_set(result, (*static_cast<const Function*>(function))(ComplexBall(s, bits)).get());
  return 0;
}

}  // namespace

std::optional<std::vector<Ball>> solve(const std::vector<std::vector<Ball>>& matrix, const std::vector<Ball>& right,
                                       slong bits) {
  const std::size_t size = right.size();
  Matrix system(size, size), column(size, 1), solution(size, 1);
  copy(system, matrix);
  for (std::size_t i = 0; i < size; ++i) arb_set(column.entry(i, 0), right[i].get());
  if (arb_mat_solve_precond(solution.get(), system.get(), column.get(), bits) == 0) return std::nullopt;
  std::vector<Ball> result(size, Ball(bits));
  for (std::size_t i = 0; i < size; ++i) arb_set(result[i].get(), solution.entry(i, 0));
  return result;
}

bool is_positive_definite(const std::vector<std::vector<Ball>>& matrix, slong bits) {
  Matrix copied(matrix.size(), matrix.size()), factor(matrix.size(), matrix.size());
  copy(copied, matrix);
  return arb_mat_cho(factor.get(), copied.get(), bits) != 0;
}

Ball determinant(const std::vector<std::vector<Ball>>& matrix, slong bits) {
  Matrix copied(matrix.size(), matrix.size());
  copy(copied, matrix);
  Ball result(bits);
  arb_mat_det_lu(result.get(), copied.get(), bits);
  return result;
}

ComplexBall integral(const Function& function, const ComplexBall& start, const ComplexBall& end, slong wanted,
                     slong bits) {
  acb_calc_integrate_opt_t options;
  acb_calc_integrate_opt_init(options);
  options->eval_limit = 100'000'000;
  options->depth_limit = 10'000;
  mag_t tolerance;  // of one word: nothing to free
  mag_init(tolerance);
  mag_set_ui_2exp_si(tolerance, 1, -wanted);
  ComplexBall result(bits);
  acb_calc_integrate(result.get(), evaluate, const_cast<Function*>(&function), start.get(), end.get(), bits, tolerance,
                     options, bits);
  return result;
}

}  // namespace subcert
