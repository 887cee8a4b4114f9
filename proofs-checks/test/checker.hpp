#pragma once
/// The checker as a process, and what tests of certificates ask it.

#include <subcert/cmake/catch.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/schemes/specification.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace subcert::testing {

namespace fs = std::filesystem;

inline Rational q(const char* text) { return *parse_rational(text); }

inline HolderRegularity regularity_of(const std::string& specification, int levels = 8) {
  return holder_regularity(make_scheme(specification).mask.curve(), levels, {Deadline::in(60)},
                           HolderProof::certificate);
}

/// Whether the checker proves this claim from the certificate.
inline bool proves(const std::string& subject, const std::string& lower, const std::string& upper,
                   const std::string& text) {
  const fs::path file = fs::temp_directory_path() / ("subcert-proofs-test-" + std::to_string(getpid()) + ".cert");
  std::ofstream(file, std::ios::binary) << text;
  std::string command = std::string(SUBCERT_CHECKER) + " " + subject;
  if (!lower.empty()) command += " --lower " + lower;
  if (!upper.empty()) command += " --upper " + upper;
  const int status = std::system((command + " " + file.string() + " >/dev/null 2>&1").c_str());
  fs::remove(file);
  REQUIRE(WIFEXITED(status));
  return WEXITSTATUS(status) == 0;
}

inline std::string subject_of(const Mask& mask) {
  return "--mask '" + mask.symbol().to_mask_text() + "' --arity " + std::to_string(mask.arity());
}

inline std::string subject_of(const LatticeMask& mask) {
  return "--surface '" + to_mask_text(mask) + "' --dilation '" + mask.dilation().to_text() + "'";
}

/// Whether the text says of itself what the claim is.
inline bool says_its_claim(const Certificate& certificate) {
  return checker_arguments(read_claim(certificate.text(), "file"), "file") ==
         checker_arguments(certificate.claim, "file");
}

/// Whether the checker proves what a certificate says of the radius of a family; `more`: and what else it is asked.
inline bool proves(const MatrixFamily& family, const Certificate& certificate, const std::string& more = "") {
  const fs::path file = fs::temp_directory_path() / ("subcert-proofs-test-" + std::to_string(getpid()) + ".family");
  std::ofstream(file, std::ios::binary) << matrices_text(family);
  const bool proved = proves("--matrices " + file.string() + more, certificate.claim.lower.value_or(""),
                             *certificate.claim.upper, certificate.text());
  fs::remove(file);
  return proved;
}

/// The same, and what the radius is. Domain: the certificate says it.
inline bool proves_exactly(const MatrixFamily& family, const Certificate& certificate) {
  return proves(family, certificate, " --exact '" + *certificate.claim.exact + "'");
}

/// The same of a scheme; its bounds alone are proved, too, and another number is not.
inline bool proves_exactly(const std::string& subject, const Certificate& certificate) {
  const CertificateClaim& claim = certificate.claim;
  REQUIRE(claim.exact);
  const Certificate bounds = certificate.of_bounds();
  CHECK(bounds.text().find("cycle") == std::string::npos);
  CHECK((says_its_claim(certificate) && says_its_claim(bounds)));
  CHECK(proves(subject, *bounds.claim.lower, *bounds.claim.upper, bounds.text()));
  std::string other = *claim.exact;
  other.back() = other.back() == '9' ? '8' : '9';
  CHECK_FALSE(proves(subject + " --exact '" + other + "'", "", "", certificate.text()));
  return proves(subject + " --exact '" + *claim.exact + "'", *claim.lower, *claim.upper, certificate.text());
}

inline RationalMatrix matrix_of(std::size_t size, const std::vector<const char*>& entries) {
  RationalMatrix m(size, size);
  for (std::size_t i = 0; i < size * size; ++i) m(i / size, i % size) = q(entries[i]);
  return m;
}

}  // namespace subcert::testing
