#include "vertex_arguments.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/vertex_rules_file.hpp>

#include <fmt/ranges.h>

namespace subcert::cli {

VertexScheme read_vertex_scheme(const std::string& text) {
  if (is_rules_file(text)) return read_vertex_rules(read_input(text), text);
  const Scheme scheme = make_linear_scheme(text);
  if (!has_vertex_rules(scheme))
    fail(ErrorKind::usage, "{}: has no rules at vertices; these have: {}", scheme.specification,
         fmt::join(schemes_with_vertex_rules(), ", "));
  return VertexScheme::named(scheme.specification);
}

void require_values(const VertexScheme& scheme, const std::string& task) {
  const WrittenLetter* letter = scheme.written ? scheme.written->free_letter() : nullptr;
  if (letter)
    fail(ErrorKind::usage, "{}: the letter {} has no value; {} needs one in the file, as value = \"3/8\"",
         scheme.specification, letter->name, task);
}

VertexScheme read_free_rules(const std::string& text, const std::vector<std::string>& names) {
  VertexScheme result = read_vertex_scheme(text);
  if (!result.written || result.written->letters.empty())
    fail(ErrorKind::usage, "--over: need rules with a letter, a file with letter = \"b\", got {}",
         result.specification);
  try {
    result.written = result.written->with_free(names);
  } catch (const Error& error) {
    fail(error.kind(), "--over: {}", error.what());
  }
  return result;
}

}  // namespace subcert::cli
