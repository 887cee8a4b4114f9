#pragma once
// Eigen's decompositions, compiled once: each source that used them directly would compile them again.

#include <Eigen/Core>

namespace subcert::detail {

/// matrix = vectors * diag(values) * vectors^T, the values increasing. Domain: symmetric.
struct SymmetricDecomposition {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
SymmetricDecomposition symmetric_decomposition(const Eigen::MatrixXd& matrix);

/// matrix * vectors = vectors * diag(values), in no particular order; the vectors have norm 1.
struct EigenDecomposition {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
};
EigenDecomposition eigen_decomposition(const Eigen::MatrixXd& matrix);

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix);

}  // namespace subcert::detail
