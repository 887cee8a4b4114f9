#include "process.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <system_error>

extern char** environ;

namespace subcert::runtime {
namespace {

/// Closed when it ends, and by other programs that start meanwhile.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0)
      throw std::system_error(errno, std::generic_category(), "process: cannot make a pipe");
  }
  ~Pipe() {
    close(ends_[0]);
    close_writer();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int reader() const { return ends_[0]; }
  int writer() const { return ends_[1]; }
  void close_writer() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  std::array<int, 2> ends_{};
};

/// Processor time of a process that runs.
double seconds_of(pid_t child) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(child, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Appends what can be read now. False: nothing more will come.
bool read_some(int from, std::string& text) {
  std::array<char, 4096> buffer{};
  const ssize_t count = read(from, buffer.data(), buffer.size());
  if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && (errno == EINTR || errno == EAGAIN));
}

/// Until both ends are closed.
void read_all(pid_t child, double most_seconds, const Pipe& output, const Pipe& errors, ProcessEnd& end) {
  constexpr int pause = 500;  // milliseconds between two looks at the clock
  std::array<pollfd, 2> open{{{output.reader(), POLLIN, 0}, {errors.reader(), POLLIN, 0}}};
  std::array<std::string*, 2> texts{&end.output, &end.errors};
  while (open[0].fd >= 0 || open[1].fd >= 0) {
    if (poll(open.data(), open.size(), pause) < 0 && errno != EINTR) break;
    for (std::size_t k = 0; k < open.size(); ++k)
      if (open[k].fd >= 0 && open[k].revents != 0 && !read_some(open[k].fd, *texts[k])) open[k].fd = -1;
    if (seconds_of(child) > most_seconds) kill(child, SIGKILL);
  }
}

}  // namespace

std::filesystem::path own_program() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error);
}

ProcessEnd run_process(const std::string& program, const std::vector<std::string>& arguments, double most_seconds) {
  Pipe nothing, output, errors;  // where nothing is mounted there is no /dev/null
  nothing.close_writer();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, nothing.reader(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output.writer(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors.writer(), STDERR_FILENO);
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  pid_t child = 0;
  const int started = posix_spawnp(&child, program.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  output.close_writer();
  errors.close_writer();
  if (started != 0)
    fail(ErrorKind::missing_file, "{}: cannot be started: {}", program, std::generic_category().message(started));
  ProcessEnd end;
  read_all(child, most_seconds, output, errors, end);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (WIFSIGNALED(status))
    end.signal = WTERMSIG(status);
  else
    end.code = WEXITSTATUS(status);
  return end;
}

}  // namespace subcert::runtime
