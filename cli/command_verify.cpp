// subcert verify FILE|DIR...: asks the independent checker, a program of its own

#include "command.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/proofs-checks/certificates/checker_arguments.hpp>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

extern char** environ;

namespace subcert::cli {
namespace {

struct VerifyOptions : CommonOptions {
  std::vector<std::string> files;
};

/// subcert-check beside this program, or else on the PATH.
std::string checker() {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  const auto beside = self.parent_path() / "subcert-check";
  return !error && std::filesystem::exists(beside) ? beside.string() : "subcert-check";
}

struct CheckerAnswer {
  int code;
  std::string line;
};

CheckerAnswer run_checker(const std::vector<std::string>& arguments) {
  int channel[2];
  if (pipe(channel) != 0) throw std::system_error(errno, std::generic_category(), "verify: cannot make a pipe");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, channel[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, channel[1], STDERR_FILENO);
  posix_spawn_file_actions_addclose(&actions, channel[0]);
  const std::string program = checker();
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  pid_t child = 0;
  const int started = posix_spawnp(&child, program.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(channel[1]);
  if (started != 0) {
    close(channel[0]);
    fail(ErrorKind::missing_file, "verify: the checker subcert-check is not installed");
  }
  CheckerAnswer answer{};
  char buffer[4096];
  for (ssize_t n; (n = read(channel[0], buffer, sizeof buffer)) > 0;)
    answer.line.append(buffer, static_cast<std::size_t>(n));
  close(channel[0]);
  int status = 0;
  waitpid(child, &status, 0);
  answer.code = WIFEXITED(status) ? WEXITSTATUS(status) : static_cast<int>(internal);
  while (!answer.line.empty() && answer.line.back() == '\n') answer.line.pop_back();
  return answer;
}

/// The files, and those named .cert in folders, in the order of their names.
std::vector<std::string> certificates_of(const std::vector<std::string>& paths) {
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    if (!fs::is_directory(path)) {
      files.push_back(path);
      continue;
    }
    std::vector<std::string> inside;
    for (const fs::directory_entry& entry : fs::directory_iterator(path))
      if (entry.path().extension() == ".cert") inside.push_back(entry.path().string());
    if (inside.empty()) fail(ErrorKind::missing_file, "{}: no certificates (*.cert) in this folder", path);
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

ExitCode run(const VerifyOptions& options) {
  Json list = Json::array();
  std::string text;
  ExitCode worst = done;
  for (const std::string& file : certificates_of(options.files)) {
    const CheckerAnswer answer = run_checker(checker_arguments(read_file(file), file));
    if (answer.code != 0) worst = std::max(worst, static_cast<ExitCode>(answer.code));
    list.push_back({{"file", file}, {"verified", answer.code == 0}, {"answer", answer.line}});
    text += file + ": " + answer.line + "\n";
  }
  options.answer(Json{{"certificates", list}}, text);
  return worst;
}

}  // namespace

void add_verify(Command& app) {
  auto options = std::make_shared<VerifyOptions>();
  Command command = add_command(app, "verify", "Checks certificates with the independent checker",
                                "subcert verify s5.cert", options, [=] { return run(*options); });
  command.option("FILE", options->files, "Certificates, or folders of them").required();
}

}  // namespace subcert::cli
