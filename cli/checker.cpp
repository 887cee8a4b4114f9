#include "checker.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/certificates/identity.hpp>
#include <subcert/reports/facts/screen_lines.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <fmt/format.h>

#include <filesystem>
#include <ostream>
#include <system_error>

namespace subcert::cli {

namespace {

Json certificate_json(const WrittenCertificate& written) {
  const CertificateClaim& claim = *written.claim;
  return {{"file", written.file},
          {"id", written.id},
          {"verified", true},  // otherwise it is not written
          {"lower", optional_json(claim.lower)},
          {"upper", optional_json(claim.upper)},
          {"exact", optional_json(claim.exact)},
          {"attains", optional_json(claim.attains)},
          {"logarithm", optional_json(claim.logarithm)}};
}

/// What is proved of a vector scheme itself; empty of other claims.
std::string of_scheme_text(const CertificateClaim& claim) {
  const auto* mask = std::get_if<MaskSubject>(&claim.subject);
  if (!mask || mask->of_matrices.empty() || !mask->range.empty()) return "";
  const bool hermite = mask->of_matrices == "hermite";
  if (claim.lower) return hermite ? "that the scheme is HC^" + *claim.lower : "that the scheme converges";
  return hermite ? "that the scheme is not HC^" + *claim.upper : "that the scheme does not converge";
}

}  // namespace

void WriteFailure::raise() const {
  if (error) throw Error(*error);
}

std::string WrittenCertificate::text(bool attained) const {
  if (file.empty()) return "";
  if (!claim) return facts::wrapped("certificate  not written: " + reason, 13) + "\n";
  const std::string of_scheme = of_scheme_text(*claim);
  const std::string line = fmt::format(
      "certificate  {}, verified: {}", file,
      !of_scheme.empty() ? of_scheme
      : claim->logarithm ? "the bounds, that the product attains the radius, and the modulus of continuity"
      : claim->exact || claim->attains ? "the bounds, and that the product attains the radius"
      : attained && claim->lower != claim->upper
          ? "the bounds, but not that the product attains the radius" + (reason.empty() ? "" : ": " + reason)
          : "the bounds");
  return facts::wrapped(line, 13) + "\n";
}

void WrittenCertificate::add_to(Json& json, const std::string& name) const {
  if (file.empty()) return;
  json[name] = claim ? certificate_json(*this) : Json();
  if (!claim || (!reason.empty() && claim->lower != claim->upper)) json[name + "_reason"] = reason;
}

WrittenCertificate write_certificate(const std::string& file, const std::function<Certificate()>& make,
                                     const std::string& matrices) {
  if (file.empty()) return {};
  try {
    const Certificate accepted = verified(make(), matrices);
    const std::string text = accepted.text();
    if (matrices.empty()) {
      runtime::write_file(file, text);
    } else {  // both or neither
      runtime::write_stream(file + ".matrices", [&](std::ostream& stream) {
        if (stream << matrices << std::flush) runtime::write_file(file, text);
      });
    }
    return {file, accepted.claim, accepted.missing, {}, content_id(text)};
  } catch (const Error& error) {
    const bool unwritable = error.kind() == ErrorKind::missing_file;
    return {file, std::nullopt, reason_text(error), {unwritable ? std::optional(error) : std::nullopt}};
  }
}

WrittenCertificate write_scheme_certificate(const std::string& file, const Scheme& scheme, const Budget& budget) {
  return write_certificate(file, [&] { return scheme_certificate(scheme, budget); });
}

void require_place(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = fs::path(file).parent_path();
  if (!file.empty() && (fs::is_directory(file, error) || !(folder.empty() || fs::is_directory(folder, error))))
    fail(ErrorKind::missing_file, "--certificate {}: expected a file in a folder that exists", file);
}

std::string reason_text(const Error& error) {
  const std::string what = error.what(), prefix = "certificate: ";
  return what.starts_with(prefix) ? what.substr(prefix.size()) : what;
}

}  // namespace subcert::cli
