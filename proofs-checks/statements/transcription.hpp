#pragma once
/// What the papers print, typed in as text, with the places where it is wrong marked.

#include "formula.hpp"

#include <map>
#include <string>
#include <vector>

namespace subcert::statements {

/// `text` is what the paper prints; `{printed => corrected}` marks a misprint and its correction, and both sides may be
/// empty. What is outside of braces belongs to both forms, so that a slip there spoils both.
struct Transcription {
  std::string id;
  std::string text;
};

enum class Form { printed, corrected };

/// The text of one form. Errors: throws ParseError for unbalanced braces or a missing `=>`.
std::string form_text(const std::string& text, Form form);

/// The text with its index-th number made larger: integers by 1, decimals by 3 units of the last place. Numbers of the
/// marked places count too. Domain: index < number_count(text). Errors: throws a domain error.
std::string with_changed_number(const std::string& text, std::size_t index);
std::size_t number_count(const std::string& text);
/// Whether the index-th number stands in the printed side of a marked place.
bool is_in_misprint(const std::string& text, std::size_t index);

/// Transcriptions by id.
class Transcriptions {
 public:
  explicit Transcriptions(const std::vector<Transcription>& all);

  /// Errors: throws a domain error for an unknown id.
  const std::string& text(const std::string& id) const;
  std::vector<std::string> ids() const;
  /// A copy with another text for one id.
  Transcriptions with(const std::string& id, const std::string& text) const;

  Formula formula(const std::string& id, Form form) const;
  /// `[p, q, ...]/D` or `[p, q, ...]`: each entry a formula, divided by D.
  std::vector<Formula> list(const std::string& id, Form form) const;
  /// Words between blanks, as in a row of a table.
  std::vector<std::string> words(const std::string& id, Form form) const;
  /// LaTeX of a formula or of a list; words with commas between.
  std::string latex(const std::string& id, Form form) const;

 private:
  std::map<std::string, std::string> texts_;
};

}  // namespace subcert::statements
