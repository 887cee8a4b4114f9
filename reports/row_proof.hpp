#pragma once
/// Proofs beside the numbers of a page.

#include "formats/section.hpp"

#include <subcert/proofs-checks/certificates/certificate.hpp>

#include <functional>
#include <string>

namespace subcert::reports {

/// What a checker accepts of a certificate, and of matrices that it is about. Errors: throws undecided where it accepts
/// nothing.
using Verified = std::function<Certificate(const Certificate&, const std::string& matrices)>;

/// Asks no checker, and so claims no more than the bounds.
inline Certificate bounds_alone(const Certificate& certificate, const std::string&) { return certificate.of_bounds(); }

/// The proof of a row of a table, by the certificate that a checker accepts; without a name where it accepts none.
/// `matrices`: what a certificate of a radius is about.
formats::RowProof row_proof(const std::string& name, const Certificate& certificate, const Verified& verified,
                            const std::string& matrices = {});

}  // namespace subcert::reports
