// subcert theorem: computer-assisted theorems, every inequality of their proofs certified

#include <subcert/cli/pages/theorem_page.hpp>
#include <subcert/reports/facts/screen_lines.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

namespace subcert::cli {
namespace {

using theorems::Theorem;
using theorems::TheoremEntry;

struct TheoremOptions : CommonOptions {
  std::string id = "list";
  std::optional<int> degree = {};
  std::string family = {};  ///< empty: that of the theorem
  bool all = false;
  std::optional<double> budget = {};
};

Json list_json() {
  Json list = Json::array();
  for (const TheoremEntry& entry : theorems::theorem_list())
    list.push_back({{"id", entry.id}, {"title", entry.title}, {"range", entry.range}, {"degrees", entry.degrees}});
  return {{"theorems", list}};
}

std::string list_text() {
  std::string text;
  for (const TheoremEntry& entry : theorems::theorem_list())
    text += facts::wrapped(
                padded(entry.id, 23) + entry.title + "; " + entry.range +
                    (entry.degrees.empty() ? "" : fmt::format("; proved for --d {}", fmt::join(entry.degrees, ", "))),
                23) +
            "\n";
  return text;
}

const TheoremEntry& entry_of(const std::string& id) {
  return *std::ranges::find(theorems::theorem_list(), id, &TheoremEntry::id);
}

ExitCode run(const TheoremOptions& options) {
  if (options.id == "list") {
    options.json ? options.answer(list_json()) : options.answer(list_text());
    return done;
  }
  const TheoremEntry& entry = entry_of(options.id);
  const int degree = options.degree.value_or(entry.degrees.empty() ? 1 : entry.degrees.front());
  const std::string& family = options.family.empty() ? entry.family : options.family;
  if (entry.family == "dual" && !family.starts_with("dual"))
    fail(ErrorKind::usage, "--family {}: expected dual or dual-odd, of which {} speaks", family, options.id);
  if (family.starts_with("primal") && degree % 2 == 0)
    fail(ErrorKind::usage, "--d {}: expected an odd degree; {} schemes of degree {} are those of degree {}", degree,
         family, degree, degree + 1);
  std::mutex mutex;
  const theorems::Patience patience{options.budget ? Deadline::in(*options.budget) : Deadline(),
                                    [&](const std::string& step) {
                                      const std::scoped_lock lock(mutex);
                                      options.progress("theorem " + options.id + ": " + step);
                                    }};
  const Theorem theorem = theorems::prove_in_time(options.id, degree, family, options.threads(), patience);
  options.end_progress();
  options.json ? options.answer(theorem_json(theorem)) : options.answer(theorem_text(theorem, options.all));
  return exit_code(theorem.decision.truth, !theorem.out_of_time);
}

}  // namespace

void add_theorem(Command& app) {
  auto options = std::make_shared<TheoremOptions>();
  std::vector<std::string> ids{"list"};
  for (const TheoremEntry& entry : theorems::theorem_list()) ids.push_back(entry.id);
  Command command = add_command(app, "theorem",
                                "Computer-assisted theorems: runs every certified inequality of a proof",
                                "subcert theorem conjecture-8-n --d 1", options, [=] { return run(*options); });
  command.option("ID", options->id, "list, or a theorem of the list").one_of(ids).with_default();
  command
      .option("--d", options->degree,
              "Degree, by default the least of the list; for conjecture-8-d the smaller one of two neighbouring odd "
              "degrees")
      .within(1, theorems::largest_degree);
  command.option("--family", options->family, "Family of the schemes, by default primal; for smoothness-dual dual")
      .one_of({"primal", "primal-odd", "dual", "dual-odd"});
  command
      .option("--budget", options->budget,
              "Seconds of processor time (default: no end); after them what is proved until then is printed")
      .within(0.001, 1e6);
  command.flag("--all", options->all, "Every single inequality, also where many differ in n only");
}

}  // namespace subcert::cli
