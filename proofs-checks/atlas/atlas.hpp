#pragma once
/// Looking up, adding, asking.

#include "database.hpp"
#include "entry.hpp"

#include <subcert/proofs-checks/sweeps/sweep.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace subcert::atlas {

/// Where a user's own atlas is: subcert/atlas.sqlite in XDG_DATA_HOME, or else in ~/.local/share; nothing where neither
/// that nor HOME is set.
std::optional<std::filesystem::path> own_atlas();

/// The one that came with the program: in the folder of the program, /usr/bin where the system does not say which runs,
/// or in ../share/subcert; nothing where there is none.
std::optional<std::filesystem::path> shipped_atlas();

/// Several files as one: what an earlier one has hides what a later one has of the same mask.
class Atlas {
 public:
  /// Files that are there, opened to be read; an empty one, which a killed process may leave, has no entries. Errors:
  /// as Database.
  explicit Atlas(const std::vector<std::filesystem::path>& files);

  std::optional<Json> find(const std::string& id) const;
  std::optional<std::string> certificate(const std::string& id) const;
  /// Those of the first file first.
  void for_each(const std::function<void(const Json&)>& take) const;

 private:
  std::vector<Database> databases_;
};

/// What is asked of each mask.
sweeps::SweepPlan usual_plan();

struct BuildReport {
  std::size_t schemes = 0, masks = 0, added = 0;
  std::vector<std::string> left_out = {};  ///< schemes that cannot be entered, each with the reason
  std::vector<std::string> failed = {};    ///< masks without an answer, each with the reason
};

/// Enters what the plan asks about each of the schemes, one case of a sweep for each mask that the atlas has not, or
/// whose entry is_wanted(). Each entry is in the file as soon as it is known, so that a build that
/// was stopped goes on. Returns nothing on ranks other than the first, which alone opens the file. Errors: as
/// run_sweep() and Database.
std::optional<BuildReport> build(const std::filesystem::path& file, const sweeps::SweepPlan& plan,
                                 const std::vector<std::string>& schemes, const std::string& program,
                                 sweeps::SweepOptions options);

/// Whether such a plan could add to the entry: it is open and had a smaller budget, or it has no certificate and none
/// was asked for, with no larger budget.
bool is_wanted(const Json& entry, const sweeps::SweepPlan& plan);

/// As Condition::meets; a surface meets nothing about a member that only curves have.
Truth meets(const Json& entry, const sweeps::Condition& condition);

/// Errors: throws ParseError, about `subject`, for a name, with what may follow behind a dot, that no entry has.
void require_member(const std::string& subject, const std::string& name, std::size_t position = 1);

/// A condition on members of entries, as `holder > 2 and support <= 8 and interpolatory`. Errors: throws ParseError,
/// also for a name that no entry has.
sweeps::Condition parse_query(const std::string& text);

}  // namespace subcert::atlas
