// subcert atlas SCHEME: what is known of a mask, looked up or computed and added

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/checker.hpp>
#include <subcert/cli/pages/sweep_lines.hpp>
#include <subcert/cli/sweep_arguments.hpp>
#include <subcert/proofs-checks/atlas/atlas.hpp>
#include <subcert/proofs-checks/atlas/canonical_mask.hpp>
#include <subcert/reports/atlas/atlas_site.hpp>
#include <subcert/reports/atlas/entry_facts.hpp>
#include <subcert/reports/facts/screen_lines.hpp>
#include <subcert/schemes/data/runtime/files.hpp>
#include <subcert/schemes/data/runtime/process.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace subcert::cli {
namespace {

constexpr std::size_t most_told = 5;  // schemes of a kind
constexpr const char* how_to_make_it =
    "'subcert atlas build docs/examples/atlas.toml' makes the one that packages have, in some minutes";

/// Of all commands about an atlas.
struct AtlasOptions : CommonOptions {
  std::string file;

  /// Where entries are added. Errors: throws a usage error where no place is known.
  std::filesystem::path own() const {
    if (!file.empty()) return file;
    const auto own = atlas::own_atlas();
    if (!own) fail(ErrorKind::usage, "atlas: neither XDG_DATA_HOME nor HOME is set; expected --atlas FILE");
    return *own;
  }

  /// What is asked: the file that is named, or else the user's own and the one that came with the program.
  atlas::Atlas atlas(bool may_be_missing) const {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    if (!file.empty() && (!may_be_missing || std::filesystem::exists(file, error))) return atlas::Atlas({file});
    if (!file.empty()) return atlas::Atlas({});
    if (const auto own = atlas::own_atlas(); own && std::filesystem::exists(*own, error)) files.push_back(*own);
    if (const auto shipped = atlas::shipped_atlas()) files.push_back(*shipped);
    if (files.empty() && !may_be_missing)
      fail(ErrorKind::missing_file, "atlas {}: there is no such file; {}", own().string(), how_to_make_it);
    return atlas::Atlas(files);
  }

  /// Says so where only the user's own file is asked, since a program that was built and not installed has no other.
  void tell_what_is_missing() const {
    if (file.empty() && !atlas::shipped_atlas())
      remark(fmt::format("only {} is asked, no atlas came with this program; {}", own().string(), how_to_make_it));
  }
};

struct LookUpOptions : AtlasOptions {
  std::string scheme, certificate;
  double budget = 10;
  bool no_add = false, members = false;
};

struct QueryOptions : AtlasOptions {
  std::string text;
  std::vector<std::string> columns;
};

struct SiteOptions : AtlasOptions {
  std::string where;
};

struct BuildOptions : AtlasOptions, SweepArguments {
  std::vector<std::string> schemes;
  std::optional<double> budget;
  std::optional<int> memory;
  bool certificates = false;
};

void add_atlas_file(Command& command, std::string& file) {
  command.option(
      "--atlas", file,
      "The file of the atlas; if none, subcert/atlas.sqlite among the user's data and the one that came with "
      "the program");
}

ExitCode print_members(const LookUpOptions& options) {
  Facts list;
  for (const atlas::Member& member : atlas::entry_members())
    list.push_back({member.name, member.name, member.meaning, "", member.meaning});
  options.answer(list, 21);
  return done;
}

/// The entry that is asked for, computed where it is missing.
Json entry_of_scheme(const LookUpOptions& options, const std::string& id) {
  const std::optional<Json> known = options.atlas(true).find(id);
  sweeps::SweepPlan plan = atlas::usual_plan();
  plan.budget = options.budget;
  plan.certificates = !known || !options.certificate.empty();
  const bool is_fixed = options.no_add || atlas::is_entry_id(options.scheme);
  if (known && (is_fixed || !atlas::is_wanted(*known, plan))) return *known;
  if (is_fixed) fail(ErrorKind::undecided, "atlas: there is no entry {}", options.scheme);
  sweeps::SweepOptions sweep = sweep_options(options, {}, "atlas");
  const auto report = atlas::build(options.own(), plan, {options.scheme}, runtime::this_program(), sweep);
  options.end_progress();
  if (!report) return {};  // the first rank prints
  if (!report->failed.empty()) fail(ErrorKind::undecided, "atlas: {}", report->failed.front());
  return *options.atlas(false).find(id);
}

/// The certificate where it is asked for; what stands in the way of the file, or that there is none.
WriteFailure write_kept_certificate(const LookUpOptions& options, const std::string& id) {
  if (options.certificate.empty()) return {};
  const auto text = options.atlas(false).certificate(id);
  if (!text) return {Error(ErrorKind::undecided, fmt::format("atlas: there is no certificate of {}", id))};
  try {
    runtime::write_file(options.certificate, *text);
    return {};
  } catch (const Error& error) {
    return {error};
  }
}

ExitCode look_up(const LookUpOptions& options) {
  require_place(options.certificate);
  if (options.members) return print_members(options);
  if (options.scheme.empty())
    fail(ErrorKind::usage, "atlas: a scheme is missing, or one of build, query, site; see 'subcert atlas --help'");
  std::optional<Scheme> scheme;
  if (!atlas::is_entry_id(options.scheme)) scheme = make_linear_scheme(options.scheme);
  const std::string id = scheme ? atlas::entry_id(atlas::mask_of_entry(*scheme)) : options.scheme;
  const Json entry = entry_of_scheme(options, id);
  if (entry.is_null()) return done;
  const Facts list = entry_facts(entry);
  Json json = Json::object();
  if (scheme) json["scheme"] = scheme->specification;
  json.update(page_json(list));
  const WriteFailure failure = write_kept_certificate(options, id);
  const std::string more = failure.error
                               ? facts::wrapped("certificate  not written: " + reason_text(*failure.error), 13) + "\n"
                               : "";
  options.answer(json, page_text(list, 21) + more);
  failure.raise();
  return atlas::is_open(entry) ? undecided : done;
}

ExitCode query(const QueryOptions& options) {
  const sweeps::Condition condition = atlas::parse_query(options.text);
  std::vector<std::string> columns = options.columns;
  if (columns.empty()) columns = {"id", "holder.lower", "holder.upper", "sum_rules", "support", "scheme"};
  for (const std::string& column : columns)
    if (column != "scheme") atlas::require_member("--columns", column);
  const SweepLines lines(false, columns);
  Json found = Json::array(), open = Json::array();
  std::string text = lines.head();
  std::size_t count = 0, all = 0;
  options.atlas(false).for_each([&](const Json& entry) {
    ++all;
    const Truth truth = atlas::meets(entry, condition);
    if (truth == Truth::unknown) open.push_back(entry.at("id"));
    if (truth != Truth::yes) return;
    ++count;
    if (options.json) return found.push_back(entry);
    Json line = entry;
    line["scheme"] = facts::title_of_entry(entry);
    text += lines.line(line);
  });
  const std::size_t left_open = open.size();
  options.answer({{"query", options.text}, {"entries", std::move(found)}, {"open", open}}, text);
  options.remark(fmt::format("{} of {} entries; open {}{}", count, all, left_open,
                             left_open == 0 ? "" : ", the first " + open.front().get<std::string>()));
  options.tell_what_is_missing();
  return done;
}

/// The first of a list, as remarks.
void tell(const AtlasOptions& options, const std::string& what, const std::vector<std::string>& list) {
  for (std::size_t i = 0; i < std::min(list.size(), most_told); ++i) options.remark(what + " " + list[i]);
  if (list.size() > most_told) options.remark(fmt::format("{}, and {} more", what, list.size() - most_told));
}

ExitCode build(const BuildOptions& options) {
  sweeps::SweepPlan plan = plan_of_texts(options.schemes, "atlas build");
  plan.ask = atlas::usual_plan().ask;
  if (options.budget) plan.budget = *options.budget;
  if (options.memory) plan.memory = static_cast<std::size_t>(*options.memory);
  plan.certificates = plan.certificates || options.certificates;
  const auto report = atlas::build(options.own(), plan, schemes_of_plan(plan), runtime::this_program(),
                                   sweep_options(options, options, "atlas"));
  if (!report) return done;  // the first rank prints
  options.end_progress();
  tell(options, "not entered:", report->left_out);
  tell(options, "no answer:", report->failed);
  const std::size_t entries = atlas::Database(options.own(), atlas::Database::Access::read).count();
  options.answer({{"atlas", options.own().string()},
                  {"schemes", report->schemes},
                  {"masks", report->masks},
                  {"added", report->added},
                  {"entries", entries},
                  {"not_entered", report->left_out},
                  {"no_answer", report->failed}},
                 fmt::format("{}: {}, {}, {} added; {}\n", options.own().string(), counted(report->schemes, "scheme"),
                             counted(report->masks, "mask"), report->added, counted(entries, "entry", "entries")));
  return report->failed.empty() ? done : undecided;
}

ExitCode site(const SiteOptions& options) {
  if (options.out.empty() || options.out == standard_stream)
    fail(ErrorKind::usage, "atlas site: need --out FOLDER, got {}", options.out.empty() ? "none" : options.out);
  std::optional<sweeps::Condition> where;
  if (!options.where.empty()) where = atlas::parse_query(options.where);
  const std::size_t entries = reports::write_atlas_site(
      options.atlas(false), [&](const Json& entry) { return !where || atlas::meets(entry, *where) == Truth::yes; },
      options.out, options.threads());
  const std::string page = (std::filesystem::path(options.out) / "index.html").string();
  if (options.json)
    print_json({{"page", page}, {"entries", entries}});
  else
    std::cout << page << ": " << counted(entries, "entry", "entries") << "\n";
  options.tell_what_is_missing();
  return done;
}

void add_site(Command& group) {
  auto options = std::make_shared<SiteOptions>();
  Command command = add_command(group, "site", "Pages of all entries, to be read and searched without a network",
                                "subcert atlas site --out pages --atlas dd.sqlite", options,
                                [=] { return site(*options); });
  command.existing("--out").describe("The folder of the pages, which begin with index.html");
  command.option("--where", options->where, "Only entries that meet this condition, as for 'subcert atlas query'");
  add_atlas_file(command, options->file);
}

void add_query(Command& group) {
  auto options = std::make_shared<QueryOptions>();
  Command command = add_command(group, "query", "Entries that meet a condition, and those that may",
                                "subcert atlas query 'holder > 2 and support <= 10' --atlas dd.sqlite", options,
                                [=] { return query(*options); });
  command
      .option("CONDITION", options->text,
              "Comparisons of members with numbers or words, joined by 'and'; 'subcert atlas --members' lists the "
              "members")
      .required();
  command
      .option("--columns", options->columns,
              "Members in the place of id, holder.lower, holder.upper, sum_rules, support, scheme")
      .separated_by_commas();
  add_atlas_file(command, options->file);
}

void add_build(Command& group) {
  auto options = std::make_shared<BuildOptions>();
  Command command = add_command(group, "build", "Enters the masks of many schemes, and goes on where it was stopped",
                                "subcert atlas build 'dd:n=1..8' --atlas dd.sqlite", options,
                                [=] { return build(*options); });
  add_schemes_of_sweep(command, options->schemes);
  add_atlas_file(command, options->file);
  command.option("--budget", options->budget, "Seconds of processor time for each answer; 10 if none")
      .within(0.001, 1e6);
  command.option("--memory", options->memory, "MiB that a search of one answer may hold; 512 if none")
      .within(16, 1'000'000);
  command.flag("--certificates", options->certificates, "Certificates of the exponents are kept, too");
  add_sweep_arguments(command, *options);
}

}  // namespace

void add_atlas(Command& app) {
  auto options = std::make_shared<LookUpOptions>();
  Command group = add_command(app, "atlas", "What is known of a mask, looked up, or computed and added to a database",
                              "subcert atlas primal:n=3", options, [=] { return look_up(*options); });
  group.run_without_subcommand([=] { return static_cast<int>(look_up(*options)); });
  group.option("SCHEME", options->scheme, "A scheme with a mask of rational numbers in one or two variables, or an id")
      .suggest(suggested_schemes);
  add_atlas_file(group, options->file);
  group.flag("--no-add", options->no_add, "Only look");
  group.option("--budget", options->budget, "Seconds of processor time for each answer that is missing")
      .within(0.001, 1e6)
      .with_default();
  group.option("--certificate", options->certificate, "Write the certificate of the entry there");
  group.flag("--members", options->members, "What entries have, and what it means");
  add_build(group);
  add_query(group);
  add_site(group);
}

}  // namespace subcert::cli
