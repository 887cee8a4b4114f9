#include "atlas.hpp"

#include "canonical_mask.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/proofs-checks/sweeps/ranks.hpp>
#include <subcert/schemes/data/runtime/process.hpp>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <system_error>

namespace subcert::atlas {
namespace {

constexpr const char* file_name = "atlas.sqlite";

/// The masks of a build in the order of the schemes, each with the names that it is to get.
struct Wanted {
  std::vector<LatticeMask> masks;
  std::map<std::string, std::vector<std::string>> names;  ///< by id
  std::vector<std::string> left_out;
};

Wanted wanted_masks(const std::vector<std::string>& schemes) {
  Wanted wanted;
  for (const std::string& text : schemes) try {
      const Scheme scheme = make_linear_scheme(text);
      const LatticeMask mask = mask_of_entry(scheme);
      const auto [at, is_new] = wanted.names.try_emplace(entry_id(mask));
      if (is_new) wanted.masks.push_back(mask);
      if (!scheme.specification.starts_with("mask")) at->second.push_back(scheme.specification);
    } catch (const Error& error) {
      wanted.left_out.push_back(text + ": " + error.what());
    }
  return wanted;
}

/// A database that is open, or word to the other ranks that there is none.
Database opened_on_first_rank(const std::filesystem::path& file) {
  try {
    return {file, Database::Access::write};
  } catch (...) {
    static_cast<void>(sweeps::sweep_begins(false, ""));
    throw;
  }
}

/// Enters an answer with the names of its mask.
void enter(Database& database, const Json& entry, const Json& answers, const std::vector<std::string>& names) {
  const Json* certificate = sweeps::member_at(answers, "certificate");
  database.together([&] {
    database.put(entry, certificate ? std::optional(certificate->get<std::string>()) : std::nullopt);
    for (const std::string& name : names) database.add_name(entry.at("id").get<std::string>(), name);
  });
}

}  // namespace

std::optional<std::filesystem::path> own_atlas() {
  const char* data = std::getenv("XDG_DATA_HOME");
  if (data && *data) return std::filesystem::path(data) / "subcert" / file_name;
  const char* home = std::getenv("HOME");
  if (!home || !*home) return std::nullopt;
  return std::filesystem::path(home) / ".local" / "share" / "subcert" / file_name;
}

std::optional<std::filesystem::path> shipped_atlas() {
  std::filesystem::path folder = runtime::own_program().parent_path();
  if (folder.empty()) folder = "/usr/bin";  // that of a package, where the system does not say which program runs
  std::error_code error;
  for (const std::filesystem::path& file : {folder / file_name, folder / ".." / "share" / "subcert" / file_name})
    if (std::filesystem::is_regular_file(file, error)) return file.lexically_normal();
  return std::nullopt;
}

Atlas::Atlas(const std::vector<std::filesystem::path>& files) {
  std::error_code error;
  for (const std::filesystem::path& file : files)
    if (!std::filesystem::is_regular_file(file, error) || std::filesystem::file_size(file, error) > 0)
      databases_.emplace_back(file, Database::Access::read);
}

std::optional<Json> Atlas::find(const std::string& id) const {
  for (const Database& database : databases_)
    if (auto entry = database.find(id)) return entry;
  return std::nullopt;
}

std::optional<std::string> Atlas::certificate(const std::string& id) const {
  for (const Database& database : databases_)
    if (auto text = database.certificate(id)) return text;
  return std::nullopt;
}

void Atlas::for_each(const std::function<void(const Json&)>& take) const {
  for (auto database = databases_.begin(); database != databases_.end(); ++database)
    database->for_each([&](const Json& entry) {
      const auto id = entry.at("id").get<std::string>();
      if (std::none_of(databases_.begin(), database, [&](const Database& earlier) { return earlier.has(id); }))
        take(entry);
    });
}

sweeps::SweepPlan usual_plan() {
  sweeps::SweepPlan plan;
  plan.ask = {"regularity", "variance"};
  return plan;
}

std::optional<BuildReport> build(const std::filesystem::path& file, const sweeps::SweepPlan& plan,
                                 const std::vector<std::string>& schemes, const std::string& program,
                                 sweeps::SweepOptions options) {
  const Wanted wanted = wanted_masks(schemes);
  std::vector<sweeps::SweepCase> cases;
  for (const LatticeMask& mask : wanted.masks) cases.push_back(case_of(plan, mask_text(mask)));
  BuildReport report{.schemes = schemes.size(), .masks = wanted.masks.size(), .left_out = wanted.left_out};
  std::optional<Database> database;
  if (sweeps::own_rank() == 0) database = opened_on_first_rank(file);
  options.is_wanted = [&](std::size_t i) {
    const auto entry = database->find(entry_id(wanted.masks[i]));
    return !entry || is_wanted(*entry, plan);
  };
  options.in_order = [](std::size_t, const Json&) {};  // no answer is held
  options.finished = [&](std::size_t i, const Json& answers) {
    const LatticeMask& mask = wanted.masks[i];
    try {
      enter(*database, entry_of(mask, plan, answers, options.version), answers, wanted.names.at(entry_id(mask)));
      ++report.added;
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::undecided) throw;
      const auto& names = wanted.names.at(entry_id(mask));
      report.failed.push_back((names.empty() ? printable(mask_text(mask)) : names.front()) + ": " + error.what());
    }
  };
  if (!run_sweep(
          cases, [&](std::size_t i) { return answers_of_scheme(plan, mask_text(wanted.masks[i]), program); }, options))
    return std::nullopt;
  database->together([&] {  // also of what was known
    for (const auto& [id, names] : wanted.names)
      if (!names.empty() && database->find(id))
        for (const std::string& name : names) database->add_name(id, name);
  });
  return report;
}

bool is_wanted(const Json& entry, const sweeps::SweepPlan& plan) {
  const auto budget = entry.at("budget").get<double>();
  const bool has_no_certificate = entry.at("certificate").is_null() && !entry.at("holder").is_null();
  return (is_open(entry) && budget < plan.budget) || (plan.certificates && has_no_certificate && budget <= plan.budget);
}

Truth meets(const Json& entry, const sweeps::Condition& condition) {
  if (entry.at("variables") != 1)
    for (const std::string& name : condition.names())
      for (const Member& member : entry_members())
        if (member.of_curves && member.name == name.substr(0, name.find('.')) && entry.at(member.name).is_null())
          return Truth::no;
  return condition.meets([&](const std::string& name) { return sweeps::member_at(entry, name); });
}

void require_member(const std::string& subject, const std::string& name, std::size_t position) {
  std::vector<std::string> known;
  for (const Member& member : entry_members()) known.push_back(member.name);
  const std::string first = name.substr(0, name.find('.'));
  if (std::ranges::find(known, first) == known.end())
    throw ParseError(subject, first, position,
                     "a member of an entry" + did_you_mean(first, known) + " (subcert atlas --members lists them)");
}

sweeps::Condition parse_query(const std::string& text) {
  sweeps::Condition condition = sweeps::Condition::parse("atlas query", text);
  for (const std::string& name : condition.names()) require_member("atlas query", name, text.find(name) + 1);
  return condition;
}

}  // namespace subcert::atlas
