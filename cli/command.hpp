#pragma once
/// What the subcommands share.

#include "options.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/symbol/numbers/numbers.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/reports/facts/fact.hpp>
#include <subcert/schemes/data/runtime/input.hpp>
#include <subcert/schemes/specification.hpp>

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>

namespace subcert::cli {

using namespace facts;  // how answers are printed

/// What the program leaves with; its meanings: docs/errors-and-exit-codes.md.
enum class ExitCode {
  done = 0,
  failed = 1,
  undecided = 2,
  obstructed = 3,
  usage = 64,
  bad_data = 65,
  missing_file = 66,
  internal = 70
};
using enum ExitCode;

/// One code for one fact, whichever command finds it: done, failed, or undecided, of which obstructed says that no
/// budget changes it.
ExitCode exit_code(Truth answer, bool open_for_good = false);
/// Whose matter the error is, and of NoLimit that of its answer.
ExitCode exit_code(const Error& error);

/// The meanings, as help prints them.
std::string program_footer();

using runtime::input_name;
using runtime::read_file;
using runtime::read_input;
using runtime::standard_stream;

/// Errors: throws missing_file where standard output did not take all that was printed, with the reason; `reason`, as
/// errno has it, is that of an earlier failure if it is known. Throws ReaderLeft where the pipe is closed.
void require_output_written(int reason = 0);

/// Whoever reads the answer has left: nothing is said about it.
struct ReaderLeft {};

/// An answer with the field `subcert`, which tells the program that made it.
std::string json_text(Json json_object);
/// The same on standard output, whatever --out says.
void print_json(Json json_object);

/// Options that every subcommand takes.
struct CommonOptions {
  bool json = false;
  bool quiet = false;
  int jobs = 0;
  unsigned long seed = 1;
  std::string out;

  int threads() const;
  /// One line on standard error, without --quiet.
  void remark(const std::string& line) const;
  /// One line on standard error, only on a terminal and without --quiet; the next line replaces it.
  void progress(const std::string& line) const;
  void end_progress() const;
  /// Sends the answer to standard output or, with --out, to that file (written whole, then renamed).
  void answer(const std::string& text) const;
  /// The same for an answer that is written piece by piece.
  void answer(const std::function<void(std::ostream&)>& write) const;
  /// As json_text().
  void answer(const Json& json_object) const { answer(json_text(json_object)); }
  /// As a page, texts from the column `width` on, or as JSON.
  void answer(const Facts& facts, std::size_t width) const { answer(page_json(facts), page_text(facts, width)); }
  /// The one that --json asks for.
  void answer(const Json& json_object, const std::string& text) const { json ? answer(json_object) : answer(text); }
};

/// Of commands that search joint spectral radii.
struct SearchOptions : CommonOptions {
  double budget = 60;         ///< seconds
  std::size_t memory = 1024;  ///< MiB
  std::string width;          ///< of what is exact; empty without a wish

  Budget limits() const { return {Deadline::in(budget), memory << 20}; }
};

/// --budget and --memory.
void add_limits(Command& command, SearchOptions& options);

/// Registers a subcommand with the common options; `run` gives its exit code. `example` is shown in its help.
Command add_command(Command& app, const std::string& name, const std::string& description, const std::string& example,
                    const std::shared_ptr<CommonOptions>& options, const std::function<ExitCode()>& run);

/// The names of all families, for options whose value is a scheme.
std::vector<Suggestion> suggested_schemes();

/// The positional argument SCHEME; `any` names the families of two and three variables in the help too, `vectors` those
/// of vectors of functions.
void add_scheme(Command& command, std::string& target, bool any = false, bool vectors = false);
/// `--scheme-certificate`, of vector and Hermite schemes themselves.
void add_scheme_certificate(Command& command, std::string& target);

/// The positional argument SCHEME where it is a family with one parameter, and --over, its values.
void add_family(Command& command, std::string& target, std::string& over);

/// The text with blanks up to this width.
std::string padded(std::string text, std::size_t width);

void add_mask(Command& app);
void add_analyze(Command& app);
void add_regularity(Command& app);
void add_limit(Command& app);
void add_variance(Command& app);
void add_reproduce(Command& app);
void add_range(Command& app);
void add_curve(Command& app);
void add_gallery(Command& app);
void add_compare(Command& app);
void add_levels(Command& app);
void add_map(Command& app);
void add_jsr(Command& app);
void add_l1(Command& app);
void add_verify(Command& app);
void add_vertex(Command& app);
void add_conjecture(Command& app);
void add_merge(Command& app);
void add_sweep(Command& app);
void add_atlas(Command& app);
void add_theorem(Command& app);
void add_refine(Command& app);
void add_smooth(Command& app);
void add_experiment(Command& app);
void add_statements(Command& app);
void add_check(Command& app);
void add_completion(Command& app);
void add_manual(Command& app);

}  // namespace subcert::cli
