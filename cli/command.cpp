#include "command.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/parallel.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>

namespace subcert::cli {
namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 28;  // of an input: some, as /dev/zero, have no end

std::string read_to_the_end(std::istream& stream, const std::string& name) {
  std::string text;
  for (std::size_t block = std::size_t{1} << 16; stream; block = std::min(2 * block, std::size_t{1} << 24)) {
    const std::size_t old = text.size();
    if (old > most_bytes) fail(ErrorKind::data, "{}: longer than {} MB", name, most_bytes >> 20);
    text.resize(old + block);
    stream.read(text.data() + old, static_cast<std::streamsize>(block));
    text.resize(old + static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream.eof()) fail(ErrorKind::data, "{}: cannot be read", name);
  return text;
}

}  // namespace

ExitCode exit_code(Truth answer) { return answer == Truth::yes ? done : answer == Truth::no ? failed : undecided; }

ExitCode exit_code(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::data: return bad_data;
    case ErrorKind::missing_file: return missing_file;
    case ErrorKind::undecided: return undecided;
    case ErrorKind::usage:
    case ErrorKind::domain:
    case ErrorKind::size: break;
  }
  return usage;
}

std::string exit_code_help() {
  return "\nExit status:\n"
         "  0   done and as expected\n"
         "  1   a claim, a certificate or a comparison failed\n"
         "  2   undecided; what is proved is printed\n"
         "  64  wrong usage\n"
         "  65  a data file that cannot be used\n"
         "  66  a file that is missing or cannot be written\n"
         "  70  internal error";
}

std::string read_file(const std::string& path) {
  if (!std::filesystem::exists(path)) fail(ErrorKind::missing_file, "{}: no such file", path);
  if (std::filesystem::is_directory(path)) fail(ErrorKind::data, "{}: cannot be read", path);
  std::ifstream stream(path, std::ios::binary);
  return read_to_the_end(stream, path);
}

std::string input_name(const std::string& path) { return path == standard_stream ? "standard input" : path; }

std::string read_input(const std::string& path) {
  return path == standard_stream ? read_to_the_end(std::cin, input_name(path)) : read_file(path);
}

int CommonOptions::threads() const { return jobs > 0 ? jobs : all_cores(); }

void CommonOptions::remark(const std::string& line) const {
  end_progress();
  if (!quiet) std::cerr << "subcert: note: " << line << "\n";
}

void CommonOptions::progress(const std::string& line) const {
  if (!quiet && isatty(STDERR_FILENO)) std::cerr << "\r\033[K" << line << std::flush;
}

void CommonOptions::end_progress() const {
  if (!quiet && isatty(STDERR_FILENO)) std::cerr << "\r\033[K" << std::flush;
}

void CommonOptions::answer(const std::string& text) const {
  answer([&](std::ostream& stream) { stream << text; });
}

void CommonOptions::answer(const std::function<void(std::ostream&)>& write) const {
  if (!out.empty() && out != standard_stream) {
    runtime::write_stream(out, write);
    return;
  }
  errno = 0;
  write(std::cout);
  require_output_written(std::cout ? 0 : errno);
}

void require_output_written(int reason) {
  errno = reason;
  const bool written = std::fflush(stdout) == 0;
  reason = errno;
  if (written && std::cout.flush()) return;
  if (reason == EPIPE) throw ReaderLeft();
  fail(ErrorKind::missing_file, "cannot write to standard output{}",
       reason == 0 ? "" : ": " + std::generic_category().message(reason));
}

Command add_command(Command& app, const std::string& name, const std::string& description, const std::string& example,
                    const std::shared_ptr<CommonOptions>& options, const std::function<ExitCode()>& run) {
  Command command = app.subcommand(name, description);
  command.add_to_footer("\nExample:\n  " + example);
  command.flag("--json", options->json, "One JSON object on standard output");
  command.flag("--quiet", options->quiet, "No progress");
  command.option("--jobs", options->jobs, "Threads (default: all cores)").within(1, 1024);
  command.option("--seed", options->seed, "Seed for whatever is random");
  command.option("--out", options->out, "Write the answer there; - is standard output");
  command.run([run] { return static_cast<int>(run()); });
  return command;
}

void add_limits(Command& command, SearchOptions& options) {
  command.option("--budget", options.budget, "Seconds of processor time").within(0.001, 1e6).with_default();
  command.option("--memory", options.memory, "MiB that the search may hold; near them it ends with what is proved")
      .within(16, 1 << 20)
      .with_default();
}

std::vector<Suggestion> suggested_schemes() {
  std::vector<Suggestion> result;
  for (const auto* help : {&families(), &multivariate_families()})
    for (const FamilyHelp& family : *help) result.push_back({family.family + ":", family.meaning});
  return result;
}

void add_scheme(Command& command, std::string& target, bool any) {
  std::vector<FamilyHelp> help = families();
  if (any) help.insert(help.end(), multivariate_families().begin(), multivariate_families().end());
  std::string known;
  for (const FamilyHelp& family : help) known += "\n  " + family.usage + "\n      " + family.meaning;
  command.option("SCHEME", target, "Scheme specification").required().suggest(suggested_schemes);
  command.add_to_footer("\n\nSchemes:" + known);
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

ExitCode refuse_unproved(const std::string& scheme, const std::string& lack, const Decision& convergence) {
  std::cerr << "subcert: " << scheme << ": " << lack << "; convergence: " << to_text(convergence.truth) << " ("
            << convergence.reason << ")\n";
  return convergence.is_no() ? failed : undecided;
}

}  // namespace subcert::cli
