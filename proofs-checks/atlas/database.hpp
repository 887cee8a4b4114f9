#pragma once
/// The file of an atlas: a database of SQLite. Tables: docs/atlas.md.

#include <subcert/proofs-checks/sweeps/journal.hpp>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace subcert::atlas {

using sweeps::Json;

class Database {
 public:
  enum class Access { read, write };

  /// Opens the file; to write, it is made where there is none, with its folder. Errors: throws missing_file where it
  /// cannot be opened; a data error for what is no atlas, one of another version, or one that is damaged.
  Database(const std::filesystem::path& path, Access access);
  ~Database();
  Database(Database&& other) noexcept;
  Database& operator=(Database&& other) noexcept;

  const std::filesystem::path& path() const;

  // All that follows, errors: throws a data error where the file is damaged; missing_file where it cannot be read or
  // written, as on a full disk; a usage error where another process has it for longer than three seconds. What was in
  // the file before is in it then.

  /// The entry with this id, with its names.
  std::optional<Json> find(const std::string& id) const;
  bool has(const std::string& id) const;
  /// All entries by arity, length and mask, one at a time, those that have none first.
  void for_each(const std::function<void(const Json&)>& take) const;
  std::size_t count() const;
  /// The text of a certificate by the id of its entry.
  std::optional<std::string> certificate(const std::string& id) const;

  /// Enters it in the place of an older one with its id, the text of a certificate beside it if there is one. Errors:
  /// throws a data error where another mask has that id.
  void put(const Json& entry, const std::optional<std::string>& certificate);
  /// Adds a name to an entry, where it has it not yet. Domain: an entry with this id.
  void add_name(const std::string& id, const std::string& name);
  /// All that `write` enters at once, or nothing where it throws.
  void together(const std::function<void()>& write);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace subcert::atlas
