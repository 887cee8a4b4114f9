#include "checker_client.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/runtime/files.hpp>
#include <subcert/schemes/data/runtime/process.hpp>

#include <filesystem>

namespace subcert {
namespace {

constexpr int internal_error = 70;  // of a checker that was killed

}  // namespace

std::string checker_program() {
  const auto self = runtime::own_program(), beside = self.parent_path() / "subcert-check";
  return !self.empty() && std::filesystem::exists(beside) ? beside.string() : "subcert-check";
}

CheckerAnswer run_checker(const std::vector<std::string>& arguments, const std::string& program) {
  runtime::ProcessEnd end;
  try {
    end = runtime::run_process(program, arguments);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::missing_file) throw;
    fail(ErrorKind::missing_file, "the checker {} is not installed", program);
  }
  CheckerAnswer answer{end.signal == 0 ? end.code : internal_error, end.output + end.errors};
  while (!answer.text.empty() && answer.text.back() == '\n') answer.text.pop_back();
  return answer;
}

CheckerAnswer check_certificate(const CertificateClaim& claim, const std::string& text, const std::string& matrices,
                                const std::string& program) {
  const runtime::TemporaryFolder folder;
  const std::string file = folder / "certificate", name = file + ": ";
  if (!matrices.empty()) runtime::write_file(file + ".matrices", matrices);
  runtime::write_file(file, text);
  CheckerAnswer answer = run_checker(checker_arguments(claim, file), program);
  for (std::size_t at = 0; (at = answer.text.find(name, at)) != std::string::npos;) answer.text.erase(at, name.size());
  return answer;
}

Certificate verified(const Certificate& certificate, const std::string& matrices) {
  const CheckerAnswer answer = check_certificate(certificate.claim, certificate.text(), matrices);
  if (answer.code == 0) return certificate;
  if (!certificate.claim.exact) fail(ErrorKind::undecided, "subcert-check says {}", answer.text);
  Certificate bounds = verified(certificate.of_bounds(), matrices);
  bounds.missing = "subcert-check says " + answer.text;
  return bounds;
}

}  // namespace subcert
