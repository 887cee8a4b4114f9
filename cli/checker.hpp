#pragma once
/// What becomes of a certificate that is asked for.

#include "command.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/certificates/checker_client.hpp>
#include <subcert/schemes/specification.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace subcert::cli {

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
  std::string reason = {};                ///< and why, or why it does not say what the exact number is
  WriteFailure failure = {};              ///< a file that cannot be written, or no checker
  std::string id = {};                    ///< the SHA-256 of what was written

  /// The line of a page; empty where none was asked for. `attained`: the page says that a product attains the radius.
  std::string text(bool attained) const;
  /// Adds `certificate`, or what has this name: what it proves, its file, its id and that it was verified; null where
  /// none was written, and then, or where it says less, `certificate_reason`.
  void add_to(Json& json, const std::string& name = "certificate") const;
};

/// Makes a certificate and writes what verified() accepts of it, and the matrices as FILE.matrices. Whatever stands in
/// the way, the answer that is to be certified remains: it becomes the reason, and what stood there stays. Nothing is
/// made where `file` is empty.
WrittenCertificate write_certificate(const std::string& file, const std::function<Certificate()>& make,
                                     const std::string& matrices = {});

/// The same for scheme_certificate().
WrittenCertificate write_scheme_certificate(const std::string& file, const Scheme& scheme, const Budget& budget);

/// Before the work: whether a certificate can be written there. Errors: throws missing_file where the folder is none.
void require_place(const std::string& file);

/// The reason in few words: those of the error, without the name of what threw it.
std::string reason_text(const Error& error);

}  // namespace subcert::cli
