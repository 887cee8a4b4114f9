#pragma once
/// The independent checker, a program of its own.

#include "command.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>

#include <functional>
#include <optional>
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
/// neither, and missing_file where there is no checker. Cost: one run of the checker, or two where the two differ.
Certificate verified(const Certificate& certificate, const std::string& matrices = {});

/// After an answer whose certificates were asked for: what the system does not let be written. Nothing where there are
/// none for want of a proof.
struct WriteFailure {
  std::optional<Error> error;

  /// Errors: throws the error.
  void raise() const;
};

/// What became of a certificate that was asked for.
struct WrittenCertificate {
  std::string file;                       ///< empty where none was asked for
  std::optional<CertificateClaim> claim;  ///< what it proves; nothing where none was written,
  std::string reason = {};                ///< and why
  WriteFailure failure = {};              ///< a file that cannot be written, or no checker

  /// The line of a page; empty where none was asked for. `attained`: the page says that a product attains the radius.
  std::string text(bool attained) const;
  /// Adds `certificate`, null where none was written, and then `certificate_reason`.
  void add_to(Json& json) const;
};

/// Makes a certificate and writes what verified() accepts of it, and the matrices as FILE.matrices. Whatever stands in
/// the way, the answer that is to be certified remains: it becomes the reason, and what stood there stays. Nothing is
/// made where `file` is empty.
WrittenCertificate write_certificate(const std::string& file, const std::function<Certificate()>& make,
                                     const std::string& matrices = {});

/// Before the work: whether a certificate can be written there. Errors: throws missing_file where the folder is none.
void require_place(const std::string& file);

/// The reason in few words: those of the error, without the name of what threw it.
std::string reason_text(const Error& error);

}  // namespace subcert::cli
