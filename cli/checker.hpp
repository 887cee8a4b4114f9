#pragma once
/// The independent checker, a program of its own.

#include "json.hpp"

#include <subcert/proofs-checks/certificates/certificate.hpp>

#include <string>
#include <vector>

namespace subcert::cli {

struct CheckerAnswer {
  int code;
  std::string text;  ///< without the last end of line
};

/// subcert-check beside this program, or else the one on the PATH.
std::string checker_program();

/// Runs the checker. Errors: throws missing_file where there is none.
CheckerAnswer run_checker(const std::vector<std::string>& arguments, const std::string& program = checker_program());

/// The certificate if the checker accepts it, or else, if it accepts that, the one of the bounds alone. `matrices`:
/// what a certificate of a radius is about. Errors: throws undecided, with the checker's reason, where it accepts
/// neither, and missing_file where there is no checker. Cost: at most two runs of the checker.
Certificate verified(const Certificate& certificate, const std::string& matrices = {});

/// Writes that, and the matrices as FILE.matrices; returns what it claims. Errors: as verified(), and nothing is
/// written then; missing_file.
CertificateClaim write_verified(const std::string& file, const Certificate& certificate,
                                const std::string& matrices = {});

/// What was written.
Json claim_json(const CertificateClaim& claim);
std::string verified_text(const std::string& file, const CertificateClaim& claim);

}  // namespace subcert::cli
