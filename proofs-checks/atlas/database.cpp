#include "database.hpp"

#include "entry.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>

#include <fmt/format.h>
#include <sqlite3.h>

#include <new>
#include <system_error>

namespace subcert::atlas {
namespace {

constexpr int application = 0x73634174;  // the file says that it is an atlas,
constexpr int schema = 1;                // and which tables it has
constexpr int patience = 3'000;          // milliseconds that another process may write

constexpr const char* tables = R"(
CREATE TABLE entries (id TEXT PRIMARY KEY, mask TEXT NOT NULL UNIQUE, arity INTEGER NOT NULL, length INTEGER NOT NULL,
  facts TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE names (name TEXT PRIMARY KEY, id TEXT NOT NULL REFERENCES entries (id)) WITHOUT ROWID;
CREATE INDEX names_of_entry ON names (id);
CREATE TABLE certificates (id TEXT PRIMARY KEY REFERENCES entries (id), text TEXT NOT NULL);
)";

ErrorKind kind_of(int code) {
  switch (code & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED: return ErrorKind::usage;
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB: return ErrorKind::data;
    default: return ErrorKind::missing_file;
  }
}

[[noreturn]] void fail_with(const std::filesystem::path& path, int code) {
  if (code == SQLITE_NOMEM) throw std::bad_alloc();
  const ErrorKind kind = kind_of(code);
  fail(kind, "atlas {}: {}", path.string(),
       kind == ErrorKind::usage         ? "another process is writing to it"
       : (code & 0xff) == SQLITE_NOTADB ? "is no atlas, but something else"
                                        : sqlite3_errstr(code));
}

}  // namespace

struct Database::Impl {
  struct Close {
    void operator()(sqlite3* handle) const { sqlite3_close(handle); }
    void operator()(sqlite3_stmt* handle) const { sqlite3_finalize(handle); }
  };
  using Statement = std::unique_ptr<sqlite3_stmt, Close>;

  std::filesystem::path path;
  std::unique_ptr<sqlite3, Close> connection;

  void check(int code) const {
    if (code != SQLITE_OK && code != SQLITE_ROW && code != SQLITE_DONE) fail_with(path, code);
  }

  /// Runs a statement with these values, and hands each row, columns as texts, to `take`.
  void run(const char* sql, const std::vector<std::string>& values = {},
           const std::function<void(const std::vector<std::string>&)>& take = {}) const {
    sqlite3_stmt* made = nullptr;
    check(sqlite3_prepare_v2(connection.get(), sql, -1, &made, nullptr));
    const Statement statement(made);
    for (std::size_t i = 0; i < values.size(); ++i)
      check(sqlite3_bind_text64(made, static_cast<int>(i) + 1, values[i].data(), values[i].size(), SQLITE_STATIC,
                                SQLITE_UTF8));
    for (int code = 0; (code = sqlite3_step(made)) != SQLITE_DONE;) {
      check(code);
      std::vector<std::string> row;
      for (int column = 0; column < sqlite3_column_count(made); ++column) {
        const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(made, column));
        row.emplace_back(text ? text : "", static_cast<std::size_t>(sqlite3_column_bytes(made, column)));
      }
      if (take) take(row);
    }
  }

  /// The only column of the first row; nothing where there is none.
  std::optional<std::string> value(const char* sql, const std::vector<std::string>& values = {}) const {
    std::optional<std::string> found;
    run(sql, values, [&](const std::vector<std::string>& row) {
      if (!found) found = row.front();
    });
    return found;
  }

  Json entry(const std::string& facts, const std::string& id) const {
    Json entry = Json::parse(facts, nullptr, false);
    if (!entry.is_object()) fail_with(path, SQLITE_CORRUPT);
    entry.emplace("variables", 1);  // where surfaces were not entered yet
    entry["names"] = Json::array();
    run("SELECT name FROM names WHERE id = ? ORDER BY length(name), name", {id},
        [&](const std::vector<std::string>& row) { entry["names"].push_back(visible(row.front())); });
    if (!is_entry(entry) || entry.at("id") != id) fail_with(path, SQLITE_CORRUPT);
    return entry;
  }

  /// Of a file that has just been opened.
  void require_atlas(bool may_make) const {
    const std::string found = *value("PRAGMA application_id"), version = *value("PRAGMA user_version");
    if (may_make && found == "0" && version == "0" && value("SELECT count(*) FROM sqlite_master") == "0") {
      const std::string marks = fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {};", application,
                                            schema);
      check(sqlite3_exec(connection.get(), ("BEGIN EXCLUSIVE;" + std::string(tables) + marks + "COMMIT").c_str(),
                         nullptr, nullptr, nullptr));
    } else if (found != std::to_string(application)) {
      fail(ErrorKind::data, "atlas {}: is no atlas, but another database", path.string());
    } else if (version != std::to_string(schema)) {
      fail(ErrorKind::data, "atlas {}: its tables are of version {}, expected {}", path.string(), version, schema);
    }
  }
};

Database::Database(const std::filesystem::path& path, Access access) : impl_(std::make_unique<Impl>()) {
  impl_->path = path;
  const bool writes = access == Access::write;
  std::error_code error;
  if (writes && path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  if (!writes && !std::filesystem::is_regular_file(path, error))
    fail(ErrorKind::missing_file, "atlas {}: there is no such file", path.string());
  sqlite3* made = nullptr;
  // Also where it is only read, as what a killed process left half is taken back first; SQLite itself reads only where
  // the file cannot be written.
  const int code = sqlite3_open_v2(path.c_str(), &made, SQLITE_OPEN_READWRITE | (writes ? SQLITE_OPEN_CREATE : 0),
                                   nullptr);
  impl_->connection.reset(made);
  impl_->check(code);
  sqlite3_busy_timeout(made, patience);
  impl_->require_atlas(writes);
}

Database::~Database() = default;
Database::Database(Database&& other) noexcept = default;
Database& Database::operator=(Database&& other) noexcept = default;

const std::filesystem::path& Database::path() const { return impl_->path; }

std::optional<Json> Database::find(const std::string& id) const {
  const auto facts = impl_->value("SELECT facts FROM entries WHERE id = ?", {id});
  if (!facts) return std::nullopt;
  return impl_->entry(*facts, id);
}

bool Database::has(const std::string& id) const {
  return impl_->value("SELECT 1 FROM entries WHERE id = ?", {id}).has_value();
}

void Database::for_each(const std::function<void(const Json&)>& take) const {
  impl_->run("SELECT facts, id FROM entries ORDER BY arity, length, mask", {},
             [&](const std::vector<std::string>& row) { take(impl_->entry(row[0], row[1])); });
}

std::size_t Database::count() const { return std::stoul(*impl_->value("SELECT count(*) FROM entries")); }

std::optional<std::string> Database::certificate(const std::string& id) const {
  return impl_->value("SELECT text FROM certificates WHERE id = ?", {id});
}

void Database::put(const Json& entry, const std::optional<std::string>& certificate) {
  const auto text = [&](const char* name) { return entry.at(name).get<std::string>(); };
  const auto number = [&](const char* name) { return entry.at(name).is_null() ? "0" : entry.at(name).dump(); };
  const std::string id = text("id"), mask = text("mask");
  const auto before = impl_->value("SELECT mask FROM entries WHERE id = ?", {id});
  if (before && *before != mask) fail(ErrorKind::data, "atlas: {} and {} have the same id {}", *before, mask, id);
  Json facts = entry;
  facts.erase("names");
  together([&] {
    impl_->run("INSERT INTO entries VALUES (?1, ?2, ?3, ?4, ?5) ON CONFLICT (id) DO UPDATE SET facts = ?5",
               {id, mask, number("arity"), number("length"), facts.dump()});
    impl_->run("DELETE FROM certificates WHERE id = ?", {id});
    if (certificate) impl_->run("INSERT INTO certificates VALUES (?, ?)", {id, *certificate});
  });
}

void Database::add_name(const std::string& id, const std::string& name) {
  impl_->run("INSERT OR IGNORE INTO names VALUES (?, ?)", {name, id});
}

void Database::together(const std::function<void()>& write) {
  if (sqlite3_get_autocommit(impl_->connection.get()) == 0) return write();  // within another one
  impl_->run("BEGIN IMMEDIATE");
  try {
    write();
    impl_->run("COMMIT");
  } catch (...) {
    sqlite3_exec(impl_->connection.get(), "ROLLBACK", nullptr, nullptr, nullptr);
    throw;
  }
}

}  // namespace subcert::atlas
