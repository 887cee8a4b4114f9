#include "row_proof.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

namespace subcert::reports {

formats::RowProof row_proof(const std::string& name, const Certificate& certificate, const Verified& verified,
                            const std::string& matrices) {
  try {
    const Certificate accepted = verified(certificate, matrices);
    formats::RowProof proof{name, checker_arguments(accepted.claim, name), {{name, accepted.text()}}};
    if (!matrices.empty()) proof.files.emplace(name + ".matrices", matrices);
    return proof;
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::undecided) throw;
    return {};
  }
}

}  // namespace subcert::reports
