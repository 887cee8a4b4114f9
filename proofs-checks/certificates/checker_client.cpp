#include "checker_client.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>

extern char** environ;

namespace subcert {
namespace {

constexpr int internal_error = 70;  // of a checker that was killed

}  // namespace

std::string checker_program() {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  const auto beside = self.parent_path() / "subcert-check";
  return !error && std::filesystem::exists(beside) ? beside.string() : "subcert-check";
}

CheckerAnswer run_checker(const std::vector<std::string>& arguments, const std::string& program) {
  int channel[2];
  if (pipe2(channel, O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "checker: cannot make a pipe");
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
  answer.code = WIFEXITED(status) ? WEXITSTATUS(status) : internal_error;
  while (!answer.text.empty() && answer.text.back() == '\n') answer.text.pop_back();
  return answer;
}

CheckerAnswer check_certificate(const CertificateClaim& claim, const std::string& text, const std::string& matrices,
                                const std::string& program) {
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
  const std::string file = folder + "/certificate", name = file + ": ";
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
