#pragma once
/// How papers and experiments read their TOML files. Inner, as toml_file.hpp. Errors: all throw FileError with the
/// place.

#include <subcert/proofs-checks/toml_file.hpp>
#include <subcert/proofs-checks/verdict.hpp>

#include <fmt/ranges.h>

#include <map>
#include <set>

namespace subcert {

using Keys = std::vector<std::string>;

/// Errors: for a key that is not among these.
void only_keys(const toml::table& table, const Keys& known);

/// A text, in which a line break with the blanks around it is one blank.
std::string text_of(const toml::node& node);
/// Empty where there is no such key.
std::string optional_text(const toml::table& table, const std::string& key);
/// Errors: where there is no such key, too.
std::string needed_text(const toml::table& table, const std::string& key);
/// The list of texts at this key; empty where there is no such key.
std::vector<std::string> optional_texts(const toml::table& table, const std::string& key);
/// The table of texts at this key, by their names; empty where there is no such key.
std::map<std::string, std::string> texts_in(const toml::table& table, const std::string& key);
/// The tables of an array; none where there is no such key.
std::vector<const toml::table*> tables_of(const toml::table& table, const std::string& key);
/// The verdict, or the grade, of this word. Errors: for no word of its kind in verdict.hpp, at the node where it
/// stands.
template <HasVerdictWords V>
V verdict_of(const toml::node& node, const std::string& word) {
  constexpr auto& words = VerdictWords<V>::list;
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end())
    throw FileError(place_of(node),
                    fmt::format("'{}' is no verdict; expected one of {}", printable(word), fmt::join(words, ", ")));
  return static_cast<V>(found - words.begin());
}
template <HasVerdictWords V>
V verdict_of(const toml::node& node) {
  return verdict_of<V>(node, text_of(node));
}

/// `key = value` and the end of the line, in which the value is that of the node. Domain: a text, an integer, true or
/// false, or a list of such. Errors: for others.
std::string toml_line(std::string_view key, const toml::node& value);

/// The text with {name} replaced by the value of this name; other braces stay.
std::string filled(std::string text, const std::map<std::string, std::string>& values);

/// Functions by id, which the entries of a file take one by one.
template <class Function>
class ById {
 public:
  /// `function` and `entry` say what they are. Errors: throws a domain error for two functions of one id.
  ById(const std::string& file, std::string function, std::string entry,
       const std::vector<std::pair<std::string, Function>>& functions)
      : function_(std::move(function)), entry_(std::move(entry)) {
    for (const auto& [id, one] : functions)
      if (!open_.emplace(id, one).second) fail(ErrorKind::domain, "{}: two {}s of '{}'", file, function_, id);
  }
  /// Errors: throws FileError where the id was there before.
  void note(const toml::table& entry, const std::string& id) {
    if (!ids_.insert(id).second)
      throw FileError(place_of(entry), fmt::format("the {} '{}' is there twice", entry_, id));
  }
  /// Notes the id and returns its function; an empty one where there is none.
  Function taken(const toml::table& entry, const std::string& id) {
    note(entry, id);
    auto found = open_.extract(id);
    if (!found) missing_.push_back(id);
    return found ? std::move(found.mapped()) : Function{};
  }
  /// Errors: throws FileError that names the entries without function and the functions without entry.
  void require_all_taken() const {
    Keys left;
    for (const auto& [id, one] : open_) left.push_back(id);
    const auto names = [](const Keys& ids) { return ids.empty() ? "none" : fmt::format("{}", fmt::join(ids, ", ")); };
    if (!missing_.empty() || !left.empty())
      throw FileError({1, 1}, fmt::format("{1}s without {0}: {2}; {0}s without {1}: {3}", function_, entry_,
                                          names(missing_), names(left)));
  }

 private:
  std::string function_, entry_;
  std::map<std::string, Function> open_;
  std::set<std::string> ids_;
  Keys missing_;
};

}  // namespace subcert
