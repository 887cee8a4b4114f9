#include "sweep_arguments.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/file_error.hpp>
#include <subcert/proofs-checks/sweeps/ranks.hpp>
#include <subcert/reports/formats/provenance.hpp>
#include <subcert/schemes/data/runtime/process.hpp>

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <sstream>

namespace subcert::cli {

namespace {

/// The lines of a file, or of standard input, without empty ones and remarks.
void add_lines(const std::string& file, std::vector<sweeps::SchemeText>& schemes) {
  std::istringstream lines(read_input(file));
  std::size_t number = 1;
  for (std::string line; std::getline(lines, line); ++number) {
    if (number == 1 && line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);  // the mark of UTF-8
    if (line.find_first_not_of(" \t\r") != std::string::npos && !line.starts_with('#'))
      schemes.push_back(
          {line.substr(0, line.find_last_not_of(" \t\r") + 1), fmt::format("{}, line {}", input_name(file), number)});
  }
}

/// Whether the argument names a file of schemes, or a folder, which is refused as no file.
bool is_list(const std::string& text) {
  std::error_code none;
  if (text == standard_stream || text.ends_with(".txt") || std::filesystem::is_regular_file(text, none)) return true;
  return std::filesystem::is_directory(text, none) && !is_scheme(text);
}

}  // namespace

sweeps::SweepPlan plan_of_texts(const std::vector<std::string>& texts, const std::string& command) {
  sweeps::SweepPlan plan;
  if (texts.size() == 1 && texts.front().ends_with(".toml")) {
    const std::string& file = texts.front();
    try {
      plan = sweeps::read_sweep_plan(read_file(file));
      for (sweeps::SchemeText& grid : plan.schemes) grid.place = file + ", " + grid.place;
    } catch (const FileError& error) {
      fail(ErrorKind::data, "{}, {}", file, error.what());
    }
  } else {
    for (const std::string& text : texts) {
      if (text.ends_with(".toml")) fail(ErrorKind::usage, "{}: need a plan alone, got others beside {}", command, text);
      if (is_list(text))
        add_lines(text, plan.schemes);
      else
        plan.schemes.push_back({text});
    }
    if (plan.schemes.empty())
      fail(ErrorKind::data, "{}: there is no scheme; expected one in each line", input_name(texts.front()));
  }
  return plan;
}

std::string counted(std::size_t count, const std::string& one, const std::string& several) {
  return fmt::format("{} {}", count, count == 1 ? one : several.empty() ? one + "s" : several);
}

void add_schemes_of_sweep(Command& command, std::vector<std::string>& schemes) {
  command
      .option("SCHEMES", schemes,
              "Schemes with lists of values, as primal:n=1..60,d={1,3} or four-point:w=0..1/4 step 1/64; all masks, as "
              "masks:length=1..5,numerators=3,denominator=2; a plan in TOML; a file with a scheme in each line, - for "
              "standard input")
      .required();
}

void add_sweep_arguments(Command& command, SweepArguments& arguments) {
  command.option("--journal", arguments.journal, "Keep finished cases there and go on from those it has");
  command.option("--shard", arguments.shard, "Only part I of N, as I/N with I from 1 to N; see 'subcert merge'");
}

std::string WorkerArguments::answering_program() const {
  if (worker.empty()) return runtime::this_program();
  runtime::run_process(worker, {"--version"});  // throws where there is none
  return worker;
}

void add_worker(Command& command, WorkerArguments& arguments) {
  command.option("--worker", arguments.worker, "Another program that answers, called as this one");
}

sweeps::SweepOptions sweep_options(const CommonOptions& common, const SweepArguments& arguments,
                                   const std::string& title) {
  sweeps::SweepOptions options;
  options.journal = arguments.journal;
  options.shard = sweeps::parse_shard(arguments.shard);
  sweeps::rank_count();  // refuses processes that cannot work together
  options.jobs = common.jobs;
  options.version = formats::version();
  options.progress = [&common, title](const std::string& line) { common.progress(title + ": " + line); };
  options.warn = [&common](const std::string& line) {
    common.end_progress();
    std::cerr << "subcert: " << line << "\n";
  };
  return options;
}

}  // namespace subcert::cli
