#pragma once
/// JSON files that people write, with the places of their parts. Inner: the program alone reads them.

#include <subcert/proofs-checks/file_error.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace subcert {

/// A value of a JSON text; of an object with the keys of its members in `items`. Canonical: each key is there once.
struct JsonNode {
  enum class Kind { object, array, string, number, literal };
  Kind kind = Kind::literal;
  Place place{1, 1};
  std::string text;  ///< of a string, without escapes; of a number or `true`, `false`, `null` as it stands there
  std::vector<JsonNode> items;
  std::string key = {};  ///< of a member
  Place key_place{1, 1};

  /// The member of this key, or null.
  const JsonNode* find(std::string_view name) const;
};

/// Reads a JSON text; numbers stay texts, so that none goes through a double. Domain: at most 100 levels of brackets.
/// Errors: throws FileError for what is no JSON [RFC 8259], and for a key that an object has twice. Cost: linear.
JsonNode parse_json(std::string_view text);

/// Errors: throws FileError for a member whose key is not among these; `of` is what they are keys of.
void only_keys(const JsonNode& object, const std::vector<std::string>& known, const std::string& of);

}  // namespace subcert
