#include "command.hpp"

#include "provenance.hpp"

#include <subcert/analysis/regularity/derivatives.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
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

ExitCode exit_code(Truth answer, bool open_for_good) {
  if (answer == Truth::unknown) return open_for_good ? obstructed : undecided;
  return answer == Truth::yes ? done : failed;
}

ExitCode exit_code(const Error& error) {
  if (const auto* refused = dynamic_cast<const NoLimit*>(&error))
    return exit_code(refused->proof().decision.truth, refused->proof().open_for_good);
  switch (error.kind()) {
    case ErrorKind::data: return bad_data;
    case ErrorKind::missing_file: return missing_file;
    case ErrorKind::undecided: return undecided;
    case ErrorKind::usage:
    case ErrorKind::domain:
    case ErrorKind::size: break;
  }
  return usage;
}

std::string program_footer() {
  return "\nFirst steps:\n"
         "  subcert analyze chaikin  all about one scheme\n"
         "  subcert refine chaikin points.csv --plot curve.png  the curve that it draws for points\n"
         "  subcert COMMAND --help  the options of a command, and an example\n"
         "\nExit status:\n"
         "  0   done and as expected\n"
         "  1   a claim, a certificate or a comparison failed\n"
         "  2   undecided within the budget; what is proved is printed\n"
         "  3   undecided for a reason that no budget changes, which is printed\n"
         "  64  wrong usage\n"
         "  65  a data file that cannot be used\n"
         "  66  a file that is missing or cannot be written\n"
         "  70  internal error";
}

std::string json_text(Json json_object) {
  json_object["subcert"] = provenance(json_object);
  return json_object.dump(2) + "\n";
}

void print_json(Json json_object) { std::cout << json_text(std::move(json_object)); }

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
  command.run([run, options] {
    if (options->json) record_inputs();
    return static_cast<int>(run());
  });
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
  for (const auto* help : {&families(), &multivariate_families(), &vector_families()})
    for (const FamilyHelp& family : *help) result.push_back({family.family + ":", family.meaning});
  return result;
}

void add_scheme_certificate(Command& command, std::string& target) {
  command.option("--scheme-certificate", target,
                 "Write one there that a vector scheme converges, or a Hermite scheme with its derivatives, or not");
}

void add_scheme(Command& command, std::string& target, bool any, bool vectors) {
  std::vector<FamilyHelp> help = families();
  if (any) help.insert(help.end(), multivariate_families().begin(), multivariate_families().end());
  if (vectors) help.insert(help.end(), vector_families().begin(), vector_families().end());
  std::string known;
  for (const FamilyHelp& family : help) known += "\n  " + family.usage + "\n      " + family.meaning;
  command.option("SCHEME", target, "Scheme specification").required().suggest(suggested_schemes);
  command.add_to_footer("\n\nSchemes:" + known);
}

void add_family(Command& command, std::string& target, std::string& over) {
  command
      .option("SCHEME", target,
              "mask:[-w,0,1/2+w,1,1/2+w,0,-w], four-point:w, merrien:lambda=-1/8,mu and other families, any letter")
      .required()
      .suggest(suggested_schemes);
  command.option("--over", over, "The values: w=LOW..HIGH").required();
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

}  // namespace subcert::cli
