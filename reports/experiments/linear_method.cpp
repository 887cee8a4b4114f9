#include "linear_method.hpp"

#include <subcert/schemes/data/smooth/scheme_smoother.hpp>
#include <subcert/schemes/specification.hpp>

namespace subcert::experiments {

std::vector<double> DenseMatrix::operator*(const std::vector<double>& data) const {
  std::vector<double> result(rows());
  for (std::size_t r = 0; r < result.size(); ++r) {
    const double* row = entries_.data() + r * columns_;
    double sum = 0;
    for (std::size_t c = 0; c < columns_; ++c) sum += row[c] * data[c];
    result[r] = sum;
  }
  return result;
}

DenseMatrix limit_matrix(const std::string& specification, std::size_t count, data::Boundary extension, int level) {
  const Scheme scheme = make_scheme(specification);
  const data::SchemeSmoother smoother(scheme.mask.curve(), count, {extension, level, 0});
  // Wrapped data: the outputs past the last datum are those before datum 1 of the data turned by one place.
  std::size_t scale = 1;
  for (int l = 0; l < level; ++l) scale *= static_cast<std::size_t>(scheme.mask.curve().arity());
  const std::size_t outputs = extension == data::Boundary::periodic ? count * scale : smoother.outputs();
  DenseMatrix result(outputs, count);
  const auto rows = smoother.rounded_rows();
  for (std::size_t r = 0; r < outputs; ++r) {
    const bool turned = r >= rows.size();
    const auto& row = rows[turned ? r - scale : r];
    for (std::size_t k = 0; k < row.weights.size(); ++k)
      result.at(r, (row.first + k + (turned ? 1 : 0)) % count) = row.weights[k];
  }
  return result;
}

}  // namespace subcert::experiments
