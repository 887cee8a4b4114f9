// The program subcert: subcommands, errors and exit codes.

#include "command.hpp"

#include <csignal>
#include <iostream>
#include <new>

namespace {

using namespace subcert;

/// One line, whatever the message holds.
int complain(const std::string& message, cli::ExitCode code) {
  std::string line;
  for (char c : message) line += (c == '\n' || c == '\r') ? ' ' : c;
  std::cerr << "subcert: " << line << "\n";
  return static_cast<int>(code);
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return cli::run_program(
        "Certifies what is claimed about subdivision schemes", cli::exit_code_help(),
        {cli::add_reproduce,  cli::add_analyze, cli::add_mask,    cli::add_regularity, cli::add_range,
         cli::add_curve,      cli::add_map,     cli::add_jsr,     cli::add_verify,     cli::add_limit,
         cli::add_variance,   cli::add_refine,  cli::add_smooth,  cli::add_gallery,    cli::add_experiment,
         cli::add_conjecture, cli::add_merge,   cli::add_theorem, cli::add_statements, cli::add_check,
         cli::add_completion, cli::add_manual},
        argc, argv);
  } catch (const Error& error) {
    return complain(error.what(), cli::exit_code(error.kind()));
  } catch (const std::bad_alloc&) {
    return complain("out of memory", cli::internal);
  } catch (const std::exception& error) {
    return complain(error.what(), cli::internal);
  }
}
