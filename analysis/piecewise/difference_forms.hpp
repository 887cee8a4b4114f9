#pragma once
/// A difference after some steps as a form in the data and the coefficients of all fits. Inner header.

#include "cone_program.hpp"
#include "contraction.hpp"

namespace subcert::piecewise {

/// What a difference at the last level depends on: of each level the first index and the number of values.
struct Dependence {
  struct Level {
    long first;
    std::size_t count;
  };
  std::vector<Level> levels;  // 0, ..., steps
  std::vector<WindowPlace> windows;
};

Dependence dependence(const Rule& rule, int steps, int order, long start);

/// The form in the differences of the data that one difference of the last level is, and the residuals of all windows
/// that it depends on, in these differences and the coefficients of all fits.
struct Forms {
  std::vector<Row> data;       // each datum
  std::vector<Row> residuals;  // [window * points + datum]
  Row objective;
  std::size_t dimension = 0, boxed = 0;
};

/// What is bounded: a difference, on all data; or the negative of one, on data whose differences are not negative.
enum class Aim { modulus, sign };

/// The forms of a difference; for its sign with the differences of the data as further rows.
Forms forms_for(Aim aim, const Rule& rule, const Dependence& plan, int order);

}  // namespace subcert::piecewise
