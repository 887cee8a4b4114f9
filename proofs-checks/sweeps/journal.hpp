#pragma once
/// The journal of a sweep: finished cases, one checksummed line each, safe against kills and power cuts.
/// The format is specified in docs/sweeps.md.

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace subcert::sweeps {

using Json = nlohmann::ordered_json;

/// The name of a case in a journal: the name-based UUID (version 5, SHA-1) of the program's version and the canonical
/// specification, which states the scheme(s) and every option that the result depends on. Ref: RFC 4122, sec. 4.3.
std::string case_id(const std::string& version, const std::string& specification);

/// One finished case and the 1-based line it stands on.
struct JournalEntry {
  std::string version;
  std::string specification;
  Json result;
  std::size_t line = 0;

  std::string id() const { return case_id(version, specification); }
};

/// What a journal holds. A last line that is torn or damaged is left out without notice, for that is what a kill or a
/// power cut leaves behind; other damaged lines are named by their 1-based numbers in `damaged` and left out.
struct JournalContent {
  std::vector<JournalEntry> entries;  ///< one for each id: repeated lines with the same result are one entry
  std::vector<std::size_t> damaged;
  std::uintmax_t whole_bytes = 0;  ///< the length of the file without a torn or damaged last line
};

/// Reads a journal, also one that is being written. Errors: throws a data error that names the file for a file that
/// cannot be read or is no journal, and the file and both lines where one case has two different results.
JournalContent read_journal(const std::filesystem::path& path);

/// "FILE line 7 is damaged; CONSEQUENCE" for each damaged line.
std::vector<std::string> damage_reports(const std::filesystem::path& path, const JournalContent& content,
                                        const std::string& consequence);

/// A journal that this process alone writes to, until it is destroyed.
class Journal {
 public:
  /// Opens the journal or makes a new one, locks it, reads it and cuts off a torn or damaged last line. Errors: throws
  /// a usage error where another process holds it, missing_file where it cannot be written, else as read_journal does.
  explicit Journal(const std::filesystem::path& path);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  const JournalContent& content() const { return content_; }
  /// The entries, which the content then has no more.
  std::vector<JournalEntry> take_entries() { return std::exchange(content_.entries, {}); }

  /// Appends one case: one write, then fsync, so that afterwards the line survives whatever happens to the process or
  /// the machine. Errors: throws missing_file; the journal then ends with its last whole line.
  void append(const JournalEntry& entry);

 private:
  void lock();
  void write_whole(const std::string& text);

  std::filesystem::path path_;
  int file_ = -1;
  std::uintmax_t bytes_ = 0;
  JournalContent content_;
};

struct MergedJournals {
  std::size_t cases = 0;
  std::vector<std::string> damage;  ///< reports on damaged lines, which are left out
};

/// Joins journals, and the one at `out` where it exists, into `out`; cases stand in the order of their first
/// occurrence. Errors: as read_journal, and a data error that names both files and lines where two
/// journals have different results for one case; a usage error where another process holds `out`. The file at `out` is
/// then as it was.
MergedJournals merge_journals(const std::vector<std::filesystem::path>& sources, const std::filesystem::path& out);

/// {"lower": "p/q", "upper": "p/q"}, an absent end left out.
nlohmann::ordered_json exact_json(const Enclosure& enclosure);
/// Errors: throws a domain error for anything else.
Enclosure enclosure_from(const nlohmann::ordered_json& json);

}  // namespace subcert::sweeps
