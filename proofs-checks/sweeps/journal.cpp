
#include "journal.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/json_file.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <boost/crc.hpp>
#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>

namespace subcert::sweeps {
namespace {

const std::string header = "subcert journal 1\n";
constexpr std::size_t checksum_digits = 8, id_length = 36;

std::string checksum(std::string_view text) {
  boost::crc_32_type crc;
  crc.process_bytes(text.data(), text.size());
  char digits[checksum_digits + 1];
  std::snprintf(digits, sizeof digits, "%08x", static_cast<unsigned>(crc.checksum()));
  return digits;
}

/// Escapes everything beyond ASCII, so that a line is a line in every encoding.
std::string one_line(const Json& json) { return json.dump(-1, ' ', true); }

std::string line_of(const JournalEntry& entry) {
  const Json json{{"version", entry.version}, {"case", entry.specification}, {"result", entry.result}};
  const std::string body = entry.id() + " " + one_line(json);
  return checksum(body) + " " + body + "\n";
}

/// The case on a line without its line feed; nothing where the line is damaged. Errors: throws a data error where a
/// whole line has keys that no journal has, or one of them twice. `where` is what errors call the line.
std::optional<JournalEntry> read_line(std::string_view line, const std::string& where) {
  if (line.size() < checksum_digits + id_length + 2 || line[checksum_digits] != ' ') return std::nullopt;
  const std::string_view body = line.substr(checksum_digits + 1);
  if (line.substr(0, checksum_digits) != checksum(body) || body[id_length] != ' ') return std::nullopt;
  try {
    only_keys(parse_json(body.substr(id_length + 1)), {"version", "case", "result"}, "a line of a journal");
  } catch (const FileError& error) {
    if (error.message.starts_with("not JSON")) return std::nullopt;
    fail(ErrorKind::data, "{}: {}", where, error.message);
  }
  const Json json = Json::parse(body.substr(id_length + 1), nullptr, false);
  if (!json.is_object() || !json.contains("version") || !json["version"].is_string() || !json.contains("case") ||
      !json["case"].is_string() || !json.contains("result"))
    return std::nullopt;
  JournalEntry entry{json["version"].get<std::string>(), json["case"].get<std::string>(), json["result"]};
  if (entry.id() != body.substr(0, id_length)) return std::nullopt;
  return entry;
}

std::string place(const std::filesystem::path& path, std::size_t line) {
  return path.string() + " line " + std::to_string(line);
}

Error conflict(const std::string& first, const std::string& second, const std::string& specification) {
  return {ErrorKind::data,
          fmt::format("{} and {} have different results for the case '{}'", first, second, specification)};
}

JournalContent parse_journal(const std::filesystem::path& path, std::string_view text) {
  JournalContent content;
  if (text.size() < header.size() && header.compare(0, text.size(), text) == 0) return content;
  if (text.substr(0, header.size()) != header) fail(ErrorKind::data, "{}: not a journal of subcert", path.string());
  std::map<std::string, std::size_t> known;
  std::size_t number = 1;
  for (std::size_t begin = header.size(), end; begin < text.size(); begin = end + 1) {
    content.whole_bytes = begin;
    ++number;
    end = text.find('\n', begin);
    if (end == std::string_view::npos) return content;
    std::optional<JournalEntry> entry = read_line(text.substr(begin, end - begin), place(path, number));
    if (!entry) {
      if (end + 1 == text.size()) return content;
      content.damaged.push_back(number);
      continue;
    }
    entry->line = number;
    const auto [position, is_new] = known.emplace(entry->id(), content.entries.size());
    if (is_new) {
      content.entries.push_back(std::move(*entry));
    } else if (const JournalEntry& earlier = content.entries[position->second]; earlier.result != entry->result) {
      throw conflict(place(path, earlier.line), place(path, number), entry->specification);
    }
  }
  content.whole_bytes = text.size();
  return content;
}

std::string file_text(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) fail(ErrorKind::data, "{}: not a file", path.string());
  std::ifstream stream(path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (!stream.is_open() || stream.bad()) fail(ErrorKind::data, "{}: cannot be read", path.string());
  return text;
}

Error system_error(const std::filesystem::path& path, const std::string& what) {
  return {ErrorKind::missing_file, fmt::format("{}: {}: {}", path.string(), what, std::strerror(errno))};
}

/// A name in a folder is on disk only after the folder is.
void sync_folder_of(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const int file = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return;
  fsync(file);
  close(file);
}

}  // namespace

std::string case_id(const std::string& version, const std::string& specification) {
  static const boost::uuids::uuid name_space = boost::uuids::name_generator_sha1(boost::uuids::ns::url())(header);
  boost::uuids::name_generator_sha1 generator(name_space);
  return boost::uuids::to_string(generator(version + "\n" + specification));
}

JournalContent read_journal(const std::filesystem::path& path) { return parse_journal(path, file_text(path)); }

std::vector<std::string> damage_reports(const std::filesystem::path& path, const JournalContent& content,
                                        const std::string& consequence) {
  std::vector<std::string> reports;
  for (std::size_t line : content.damaged) reports.push_back(place(path, line) + " is damaged; " + consequence);
  return reports;
}

Journal::Journal(const std::filesystem::path& path) : path_(path) {
  try {
    lock();
    content_ = read_journal(path_);
    bytes_ = content_.whole_bytes;
    if (ftruncate(file_, static_cast<off_t>(bytes_)) != 0)
      throw system_error(path_, "cannot be cut to its whole lines");
    if (bytes_ == 0) {
      write_whole(header);
      sync_folder_of(path_);
    }
  } catch (...) {
    if (file_ >= 0) close(file_);
    throw;
  }
}

Journal::~Journal() { close(file_); }

// A file that was replaced between open and flock is not the one that others see: then the lock is taken anew.
void Journal::lock() {
  std::error_code error;
  if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path(), error);
  for (;;) {
    file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file_ < 0) throw system_error(path_, "cannot be opened for writing");
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
      if (errno == EWOULDBLOCK)
        fail(ErrorKind::usage,
             "{}: another process is using this journal; wait for it, or give each process a journal of its own with "
             "--shard and join them with 'subcert merge'",
             path_.string());
      throw system_error(path_, "cannot be locked");
    }
    struct stat locked, named;
    if (fstat(file_, &locked) == 0 && stat(path_.c_str(), &named) == 0 && locked.st_ino == named.st_ino &&
        locked.st_dev == named.st_dev)
      return;
    close(file_);
    file_ = -1;
  }
}

void Journal::write_whole(const std::string& text) {
  ssize_t written;
  do {
    written = write(file_, text.data(), text.size());
  } while (written < 0 && errno == EINTR);
  if (written >= 0 && static_cast<std::size_t>(written) < text.size()) errno = ENOSPC;
  if (written != static_cast<ssize_t>(text.size()) || fsync(file_) != 0) {
    const Error failure = system_error(path_, "cannot be written");
    if (ftruncate(file_, static_cast<off_t>(bytes_)) != 0)
      throw system_error(path_, "cannot be cut to its whole lines");
    throw failure;
  }
  bytes_ += text.size();
}

void Journal::append(const JournalEntry& entry) { write_whole(line_of(entry)); }

MergedJournals merge_journals(const std::vector<std::filesystem::path>& sources, const std::filesystem::path& out) {
  struct Source {
    std::filesystem::path path;
    JournalEntry entry;
  };
  std::optional<Journal> held;
  std::vector<std::filesystem::path> paths = sources;
  if (std::filesystem::exists(out)) {
    held.emplace(out);
    paths.push_back(out);
  }
  std::vector<std::string> damage;
  std::vector<Source> merged;
  std::map<std::string, std::size_t> known;
  for (const std::filesystem::path& path : paths) {
    const JournalContent content = read_journal(path);
    for (const std::string& report : damage_reports(path, content, "its case is left out")) damage.push_back(report);
    for (const JournalEntry& entry : content.entries) {
      const auto [position, is_new] = known.emplace(entry.id(), merged.size());
      if (is_new) {
        merged.push_back({path, entry});
      } else if (const Source& earlier = merged[position->second]; earlier.entry.result != entry.result) {
        throw conflict(place(earlier.path, earlier.entry.line), place(path, entry.line), entry.specification);
      }
    }
  }
  std::string text = header;
  for (const Source& source : merged) text += line_of(source.entry);
  runtime::write_file(out, text);
  return {merged.size(), damage};
}

nlohmann::ordered_json exact_json(const Enclosure& enclosure) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (enclosure.lower) json["lower"] = to_text(*enclosure.lower);
  if (enclosure.upper) json["upper"] = to_text(*enclosure.upper);
  return json;
}

Enclosure enclosure_from(const nlohmann::ordered_json& json) {
  Enclosure enclosure;
  if (!json.is_object()) fail(ErrorKind::domain, "not an enclosure: {}", json.dump().substr(0, 60));
  for (const auto& [key, end] : json.items()) {
    const auto value = end.is_string() ? parse_rational(end.get<std::string>()) : std::nullopt;
    if (!value || (key != "lower" && key != "upper"))
      fail(ErrorKind::domain, "not an enclosure: {}", json.dump().substr(0, 60));
    (key == "lower" ? enclosure.lower : enclosure.upper) = *value;
  }
  require(enclosure.is_canonical(), "not an enclosure: the lower end is above the upper one");
  return enclosure;
}

}  // namespace subcert::sweeps
