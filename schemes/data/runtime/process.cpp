#include "process.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <system_error>

namespace subcert::runtime {
namespace {

constexpr const char* running = "/proc/self/exe";  // in a new process too, until it becomes another program
constexpr const char* own_name = "subcert";

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

/// What a program reads: one end of a connection, whose other end a limit of files or a reader that leaves does not
/// disturb.
class Input {
 public:
  explicit Input(const std::string& text) : text_(text) {
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends_.data()) != 0)
      throw std::system_error(errno, std::generic_category(), "process: cannot make a connection");
  }
  ~Input() {
    close_reader();
    close_writer();
  }
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;

  int reader() const { return ends_[0]; }
  /// -1 where nothing is left to be sent.
  int writer() const { return ends_[1]; }
  void close_reader() { close_end(ends_[0]); }
  void send_some() {
    const ssize_t count = sent_ == text_.size()
                              ? 0
                              : send(ends_[1], text_.data() + sent_, text_.size() - sent_, MSG_NOSIGNAL | MSG_DONTWAIT);
    sent_ += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    if (sent_ == text_.size() || (count < 0 && errno != EINTR && errno != EAGAIN)) close_writer();
  }

 private:
  static void close_end(int& end) {
    if (end >= 0) close(end);
    end = -1;
  }
  void close_writer() { close_end(ends_[1]); }

  const std::string& text_;
  std::size_t sent_ = 0;
  std::array<int, 2> ends_{};
};

/// In a new process, which ends with its parent: becomes the program, or tells the parent why not. Between fork and
/// exec nothing is allocated, as other threads may hold locks.
[[noreturn]] void become(const char* program, char* const* arguments, const std::array<int, 3>& streams, pid_t parent,
                         int trouble) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() == parent) {
    for (int to = 0; to < 3; ++to) dup2(streams[static_cast<std::size_t>(to)], to);
    execvp(program, arguments);
    const int reason = errno;
    static_cast<void>(!write(trouble, &reason, sizeof reason));
  }
  _exit(127);
}

/// How it ended.
int wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return status;
}

/// Starts the program. Errors: throws missing_file.
pid_t started(const std::string& program, const std::vector<std::string>& arguments,
              const std::array<int, 3>& streams) {
  std::vector<char*> argv{const_cast<char*>(program == running ? own_name : program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  Pipe trouble;
  const pid_t parent = getpid(), child = fork();
  if (child == 0) become(program.c_str(), argv.data(), streams, parent, trouble.writer());
  trouble.close_writer();
  int reason = child < 0 ? errno : 0;
  while (child > 0 && read(trouble.reader(), &reason, sizeof reason) < 0 && errno == EINTR) continue;
  if (child > 0 && reason != 0) wait_for(child);
  if (reason != 0)
    fail(ErrorKind::missing_file, "{}: cannot be started: {}", program, std::generic_category().message(reason));
  return child;
}

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

/// Until both outputs are closed.
void exchange(pid_t child, double most_seconds, Input& input, const Pipe& output, const Pipe& errors, ProcessEnd& end) {
  constexpr int pause = 500;  // milliseconds between two looks at the clock
  std::array<pollfd, 3> open{
      {{output.reader(), POLLIN, 0}, {errors.reader(), POLLIN, 0}, {input.writer(), POLLOUT, 0}}};
  std::array<std::string*, 2> texts{&end.output, &end.errors};
  while (open[0].fd >= 0 || open[1].fd >= 0) {
    if (poll(open.data(), open.size(), pause) < 0 && errno != EINTR) break;
    for (std::size_t k = 0; k < texts.size(); ++k)
      if (open[k].fd >= 0 && open[k].revents != 0 && !read_some(open[k].fd, *texts[k])) open[k].fd = -1;
    if (open[2].fd >= 0 && open[2].revents != 0) input.send_some();
    open[2].fd = input.writer();
    if (seconds_of(child) > most_seconds) kill(child, SIGKILL);
  }
}

}  // namespace

std::filesystem::path own_program() {
  std::error_code error;
  return std::filesystem::read_symlink(running, error);
}

std::string this_program() { return own_program().empty() ? own_name : running; }

ProcessEnd run_process(const std::string& program, const std::vector<std::string>& arguments,
                       const ProcessSettings& settings) {
  Input input(settings.input);
  Pipe output, errors;
  const pid_t child = started(program, arguments, {input.reader(), output.writer(), errors.writer()});
  input.close_reader();
  output.close_writer();
  errors.close_writer();
  ProcessEnd end;
  exchange(child, settings.most_seconds, input, output, errors, end);
  const int status = wait_for(child);
  if (WIFSIGNALED(status))
    end.signal = WTERMSIG(status);
  else
    end.code = WEXITSTATUS(status);
  return end;
}

}  // namespace subcert::runtime
