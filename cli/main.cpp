// The program subcert: subcommands, errors and exit codes.

#include "command.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/reports/sweep/journal.hpp>
#include <subcert/schemes/data/table.hpp>

#include <csignal>
#include <iostream>
#include <new>

namespace {

using namespace subcert;

/// One line, whatever the message holds.
int complain(const std::string& message, int code) {
  std::string line;
  for (char c : message) line += (c == '\n' || c == '\r') ? ' ' : c;
  std::cerr << "subcert: " << line << "\n";
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  CLI::App app{"Certifies what is claimed about subdivision schemes", "subcert"};
  app.set_version_flag("--version", std::string("subcert ") + SUBCERT_VERSION);
  app.require_subcommand(1);
  cli::add_reproduce(app);
  cli::add_analyze(app);
  cli::add_mask(app);
  cli::add_regularity(app);
  cli::add_jsr(app);
  cli::add_verify(app);
  cli::add_limit(app);
  cli::add_variance(app);
  cli::add_refine(app);
  cli::add_smooth(app);
  cli::add_experiment(app);
  cli::add_conjecture(app);
  cli::add_merge(app);
  cli::add_theorem(app);
  cli::add_statements(app);
  cli::add_check(app);
  try {
    app.parse(argc, argv);
    return cli::exit_code;
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return complain(std::string(error.what()) + "; see 'subcert --help'", cli::usage);
  } catch (const ParseError& error) {
    return complain(error.what(), cli::usage);
  } catch (const cli::UsageError& error) {
    return complain(error.what(), cli::usage);
  } catch (const cli::DataError& error) {
    return complain(error.what(), error.code);
  } catch (const DataFormatError& error) {
    return complain(error.what(), cli::bad_data);
  } catch (const JournalInUse& error) {
    return complain(error.what(), cli::usage);
  } catch (const JournalError& error) {
    return complain(error.what(), cli::bad_data);
  } catch (const Error& error) {
    return complain(error.what(), cli::usage);
  } catch (const std::length_error& error) {
    return complain(error.what(), cli::usage);
  } catch (const std::bad_alloc&) {
    return complain("out of memory", cli::internal);
  } catch (const std::exception& error) {
    return complain(error.what(), cli::internal);
  }
}
