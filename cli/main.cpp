// The program subcert: subcommands, errors and exit codes.

#include "command.hpp"

#include <subcert/analysis/symbol/numbers/flint.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/schemes/specification.hpp>

#include <fcntl.h>
#include <gmp.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <span>
#include <string_view>

namespace {

using namespace subcert;

/// One line, whatever the message holds.
int complain(const std::string& message, cli::ExitCode code) {
  std::string line = message;
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  std::cerr << "subcert: " << visible(line) << "\n";
  return static_cast<int>(code);
}

/// For a file that was given in the place of a scheme.
std::string about_file(const Error& error, const std::span<char*> arguments) {
  const auto* refused = dynamic_cast<const SpecificationError*>(&error);
  std::error_code none;
  if (!refused || refused->position() != 1) return "";
  if (std::filesystem::is_directory(refused->token(), none)) return "; it is a folder";
  if (!std::filesystem::is_regular_file(refused->token(), none)) return "";
  for (std::size_t i = 2; i < arguments.size(); ++i)  // behind the command
    if (refused->token() == arguments[i] && i + 1 < arguments.size() && cli::is_scheme(arguments[i + 1]))
      return std::string("; it is a file, and the scheme stands before it: 'subcert ") + arguments[1] + " " +
             arguments[i + 1] + " " + arguments[i] + "'";
  if (refused->token().ends_with(".toml"))
    return "; it is a file: rules at vertices are for 'subcert vertex FILE' and 'subcert refine FILE MESH', plans for "
           "'subcert sweep FILE', properties for 'subcert check FILE'";
  return "; it is a file: 'subcert sweep FILE' takes one with a scheme a line, and \"$(cat FILE)\" stands for one with "
         "a mask";
}

/// No file that is opened comes to stand for a standard stream that was closed.
void hold_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0 && open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0)
      std::_Exit(static_cast<int>(cli::internal));
}

/// Where nothing can be thrown: in GMP and FLINT, which would end the program by abort, and in destructors.
[[noreturn]] void end_without_memory() {
  constexpr std::string_view line = "subcert: out of memory\n";
  static_cast<void>(!write(STDERR_FILENO, line.data(), line.size()));
  std::_Exit(static_cast<int>(cli::internal));
}

void* enough(void* memory, std::size_t size) {
  if (!memory && size > 0) end_without_memory();
  return memory;
}

void* allocate(std::size_t size) { return enough(std::malloc(size), size); }
void* allocate_zeros(std::size_t count, std::size_t size) { return enough(std::calloc(count, size), count); }
void* reallocate(void* memory, std::size_t size) { return enough(std::realloc(memory, size), size); }

void answer_lack_of_memory() {
  mp_set_memory_functions(
      allocate, [](void* memory, std::size_t, std::size_t size) { return reallocate(memory, size); },
      [](void* memory, std::size_t) { std::free(memory); });
  __flint_set_memory_functions(allocate, allocate_zeros, reallocate, std::free);
  std::set_terminate([] {
    try {
      if (std::current_exception()) throw;
    } catch (const std::bad_alloc&) {
      end_without_memory();
    } catch (...) {
    }
    std::abort();
  });
}

}  // namespace

int main(int argc, char** argv) {
  hold_standard_streams();
  prctl(PR_SET_NAME, "subcert");  // a process that answers is started as "exe"
  answer_lack_of_memory();
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);  // a failed write says so
  try {
    const int code = cli::run_program(
        "Proves how smooth the limits of subdivision schemes are, and what else is claimed of them",
        cli::program_footer(),
        {cli::add_reproduce, cli::add_analyze,    cli::add_mask,       cli::add_regularity, cli::add_range,
         cli::add_curve,     cli::add_levels,     cli::add_map,        cli::add_jsr,        cli::add_verify,
         cli::add_limit,     cli::add_variance,   cli::add_refine,     cli::add_smooth,     cli::add_gallery,
         cli::add_compare,   cli::add_experiment, cli::add_conjecture, cli::add_merge,      cli::add_sweep,
         cli::add_theorem,   cli::add_statements, cli::add_check,      cli::add_completion, cli::add_manual,
         cli::add_l1,        cli::add_vertex,     cli::add_atlas},
        argc, argv);
    cli::require_output_written();
    return code;
  } catch (const cli::ReaderLeft&) {
    return static_cast<int>(cli::missing_file);
  } catch (const Error& error) {
    return complain(std::string(error.what()) + about_file(error, {argv, static_cast<std::size_t>(argc)}),
                    cli::exit_code(error));
  } catch (const std::bad_alloc&) {
    return complain("out of memory", cli::internal);
  } catch (const std::exception& error) {
    return complain(error.what(), cli::internal);
  }
}
