#pragma once
/// Sweeps: many independent cases, computed in parallel, journalled one by one, resumed, split and joined. See
/// docs/sweeps.md.

#include "journal.hpp"

#include <functional>
#include <optional>
#include <string_view>

namespace subcert::sweeps {

struct SweepCase {
  /// Canonical text of the scheme(s) and of every option that the result depends on. Distinct within a sweep.
  std::string specification;
  /// How long it may take, in any unit: expensive cases are begun first.
  double effort = 1;
};

/// The cases whose number, counted from 1, is congruent to `number` modulo `count`. 1 <= number <= count.
struct Shard {
  std::size_t number = 1;
  std::size_t count = 1;

  /// Whether the case of this index, counted from 0, is in the shard.
  bool contains(std::size_t index) const { return index % count == number - 1; }
  bool is_whole() const { return count == 1; }
};

/// Reads I/N with 1 <= I <= N <= 10^6. Errors: throws ParseError.
Shard parse_shard(std::string_view text);

struct SweepOptions {
  /// The journal to go on from and to append to; none where empty.
  std::filesystem::path journal = {};
  Shard shard = {};
  /// Which cases of the shard are wanted, asked on the first rank alone, once for each; all where empty.
  std::function<bool(std::size_t)> is_wanted = {};
  /// Threads; 0: all cores, or one for each rank where several ranks work together.
  int jobs = 0;
  /// The version of the program, part of the name of every case.
  std::string version = {};
  /// Called with a line on how far the sweep is; may be empty.
  std::function<void(const std::string&)> progress = {};
  /// Called with each case that is known, in the order in which they come, those of the journal first; may be empty.
  std::function<void(std::size_t, const Json&)> finished = {};
  /// Called with each case of the shard in the order of the cases, as soon as those before it are known; what it was
  /// called with is not among the results any more, so that a sweep holds few of them. May be empty.
  std::function<void(std::size_t, const Json&)> in_order = {};
  /// Called with what the user must know, such as a damaged line of the journal; may be empty.
  std::function<void(const std::string&)> warn = {};
};

struct SweepResults {
  /// In the order of the cases; nothing for the cases outside the shard or not wanted, and for those told in order.
  /// Each value has been through its text, so it is the same whether it was computed now or read from the journal.
  std::vector<std::optional<Json>> values;
  std::size_t computed = 0;
  std::size_t from_journal = 0;
};

/// Computes compute(i) for the cases of the shard that are wanted and not in the journal, on several threads and on all
/// ranks that mpirun started. Domain: distinct specifications; compute may run on several threads at once and depends
/// on nothing but the case; on every rank the cases are the same. The journal belongs to rank 0; each finished case is
/// appended to it at once.
/// Returns nothing on the ranks other than 0: these have only worked and should end without a word.
/// Errors: as Journal; throws std::runtime_error after all other cases are done where compute threw,
/// naming the first such case, which is not journalled; std::logic_error for repeated specifications.
std::optional<SweepResults> run_sweep(const std::vector<SweepCase>& cases,
                                      const std::function<Json(std::size_t)>& compute, const SweepOptions& options);

}  // namespace subcert::sweeps
