#include "checker.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/proofs-checks/certificates/checker_arguments.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <system_error>

extern char** environ;

namespace subcert::cli {

std::string checker_program() {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  const auto beside = self.parent_path() / "subcert-check";
  return !error && std::filesystem::exists(beside) ? beside.string() : "subcert-check";
}

CheckerAnswer run_checker(const std::vector<std::string>& arguments, const std::string& program) {
  int channel[2];
  if (pipe(channel) != 0) throw std::system_error(errno, std::generic_category(), "checker: cannot make a pipe");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, channel[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, channel[1], STDERR_FILENO);
  posix_spawn_file_actions_addclose(&actions, channel[0]);
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  pid_t child = 0;
  const int started = posix_spawnp(&child, program.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(channel[1]);
  if (started != 0) {
    close(channel[0]);
    fail(ErrorKind::missing_file, "the checker {} is not installed", program);
  }
  CheckerAnswer answer{};
  char buffer[4096];
  for (ssize_t n; (n = read(channel[0], buffer, sizeof buffer)) > 0;)
    answer.text.append(buffer, static_cast<std::size_t>(n));
  close(channel[0]);
  int status = 0;
  waitpid(child, &status, 0);
  answer.code = WIFEXITED(status) ? WEXITSTATUS(status) : static_cast<int>(internal);
  while (!answer.text.empty() && answer.text.back() == '\n') answer.text.pop_back();
  return answer;
}

Certificate verified(const Certificate& certificate, const std::string& matrices) {
  const char* temporary = std::getenv("TMPDIR");
  std::string folder = fmt::format("{}/subcert-XXXXXX", temporary && *temporary ? temporary : "/tmp");
  if (!mkdtemp(folder.data()))
    fail(ErrorKind::missing_file, "cannot make a folder for temporary files, {}: {}", folder,
         std::generic_category().message(errno));
  const struct Remove {
    std::filesystem::path folder;
    ~Remove() {
      std::error_code error;
      std::filesystem::remove_all(folder, error);
    }
  } remove{folder};
  const std::string file = folder + "/certificate";
  if (!matrices.empty()) runtime::write_file(file + ".matrices", matrices);
  const auto answer_to = [&](const Certificate& one) {
    runtime::write_file(file, one.text);
    return run_checker(checker_arguments(one.text, file));
  };
  CheckerAnswer answer = answer_to(certificate);
  if (answer.code == 0) return certificate;
  Certificate bounds = certificate.of_bounds();
  if (bounds.text != certificate.text) answer = answer_to(bounds);
  if (answer.code != 0) fail(ErrorKind::undecided, "subcert-check says {}", answer.text);
  return bounds;
}

namespace {

Json claim_json(const CertificateClaim& claim) {
  return {{"lower", optional_json(claim.lower)},
          {"upper", optional_json(claim.upper)},
          {"exact", optional_json(claim.exact)},
          {"logarithm", optional_json(claim.logarithm)}};
}

}  // namespace

void WriteFailure::raise() const {
  if (error) throw Error(*error);
}

std::string WrittenCertificate::text(bool attained) const {
  if (file.empty()) return "";
  if (!claim) return "certificate  not written: " + reason + "\n";
  return fmt::format("certificate  {}, verified: {}\n", file,
                     claim->logarithm ? "the bounds, that the product attains the radius, and the modulus of continuity"
                     : claim->exact   ? "the bounds, and that the product attains the radius"
                     : attained && claim->lower != claim->upper
                         ? "the bounds, but not that the product attains the radius"
                         : "the bounds");
}

void WrittenCertificate::add_to(Json& json) const {
  if (file.empty()) return;
  json["certificate"] = claim ? claim_json(*claim) : Json();
  if (!claim) json["certificate_reason"] = reason;
}

WrittenCertificate write_certificate(const std::string& file, const std::function<Certificate()>& make,
                                     const std::string& matrices) {
  if (file.empty()) return {};
  try {
    const Certificate accepted = verified(make(), matrices);
    if (matrices.empty()) {
      runtime::write_file(file, accepted.text);
    } else {  // both or neither
      runtime::write_stream(file + ".matrices", [&](std::ostream& stream) {
        if (stream << matrices << std::flush) runtime::write_file(file, accepted.text);
      });
    }
    return {file, accepted.claim};
  } catch (const Error& error) {
    const bool unwritable = error.kind() == ErrorKind::missing_file;
    return {file, std::nullopt, reason_text(error), {unwritable ? std::optional(error) : std::nullopt}};
  }
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
