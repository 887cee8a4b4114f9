#pragma once
/// The parts of scheme specifications: pieces of text with their places, and `key=value` fields.

#include "specification.hpp"

#include <optional>

namespace subcert::specification {

/// A piece of the specification and where it begins (0-based).
struct Piece {
  std::string_view text;
  std::size_t at;
};

/// Throws SpecificationError for the piece.
[[noreturn]] void fail(const Piece& piece, const std::string& expected);

/// Splits at `separator` outside of brackets.
std::vector<Piece> split(const Piece& piece, char separator);

/// Errors: fail().
Rational read_rational(const Piece& piece);

/// An integer in low, ..., high. Errors: fail(), which calls the integer `name`.
long read_integer(const Piece& piece, const std::string& name, long low, long high);

/// The `key=value` fields of a specification; each is to be taken once, and finish() refuses what is left.
class Fields {
 public:
  Fields(const Piece& family, const Piece& body, std::string usage)
      : family_(family), end_(body.at + body.text.size()), usage_(std::move(usage)) {
    if (body.text.empty()) return;
    for (const Piece& piece : split(body, ',')) add(piece);
  }
  Fields(const Piece& family, const std::vector<Piece>& pieces, std::size_t end, std::string usage)
      : family_(family), end_(end), usage_(std::move(usage)) {
    for (const Piece& piece : pieces) add(piece);
  }

  std::optional<Piece> optional(std::string_view key) {
    for (Field& field : fields_)
      if (field.key.text == key) {
        field.used = true;
        return field.value;
      }
    return std::nullopt;
  }

  Piece required(std::string_view key) {
    if (const auto value = optional(key)) return *value;
    throw SpecificationError(family_.text, end_ + 1, "the key '" + std::string(key) + "', as in " + usage_);
  }

  void finish() const {
    for (const Field& field : fields_)
      if (!field.used) fail(field.key, "a key of " + usage_);
  }

 private:
  struct Field {
    Piece key;
    Piece value;
    bool used = false;
  };

  void add(const Piece& piece) {
    const std::size_t equals = piece.text.find('=');
    if (equals == std::string_view::npos) fail(piece, "key=value, as in " + usage_);
    const Piece key{piece.text.substr(0, equals), piece.at};
    for (const Field& field : fields_)
      if (field.key.text == key.text) fail(key, "each key once");
    fields_.push_back({key, {piece.text.substr(equals + 1), piece.at + equals + 1}});
  }

  Piece family_;
  std::size_t end_;
  std::string usage_;
  std::vector<Field> fields_;
};

}  // namespace subcert::specification
