#pragma once
/// What is asked of answers: `holder > 1.9 and converges == yes`.

#include "journal.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace subcert::sweeps {

/// The member of an answer with this path, names between dots, or numbers from 0 on in lists; nullptr where there is
/// none.
const Json* member_at(const Json& answer, std::string_view path);

/// The number, or the enclosure {"lower": ..., "upper": ...}, that a value is; an end that is infinite, or no number,
/// is none.
Enclosure enclosure_of(const Json& value);

/// Comparisons NAME OP VALUE joined by `and`, OP one of >, >=, <, <=, ==, !=, VALUE a number or a word; a NAME alone
/// stands for NAME == yes.
class Condition {
 public:
  /// What a name stands for; nullptr: nothing.
  using Lookup = std::function<const Json*(const std::string& name)>;

  /// Errors: throws ParseError; `subject` is the option that the text stands for.
  static Condition parse(const std::string& subject, std::string_view text);

  /// Three-valued: an enclosure {"lower": ..., "upper": ...} may leave a comparison open, and a name that stands for
  /// nothing, or for null, does. Numbers are compared exactly, as they are printed; true is the word yes, false no.
  Truth holds(const Lookup& lookup) const;

  /// The same of what is said of a scheme, but a scheme with `converges` no meets nothing about a member that is null
  /// or has no ends: it has no limits, to which these belong.
  Truth meets(const Lookup& lookup) const;

  /// What is compared, in the order of the text.
  std::vector<std::string> names() const;

 private:
  enum class Relation { greater, at_least, less, at_most, equal, different };
  struct Comparison {
    std::string name;
    Relation relation;
    std::string word;  ///< in place of a number
    Rational number;
  };
  static Truth holds(const Comparison& comparison, const Json* value);

  std::vector<Comparison> comparisons_;
};

}  // namespace subcert::sweeps
