#include "matrices_file.hpp"

#include <subcert/analysis/radii/joint/joint_spectral_radius.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/proofs-checks/json_file.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert {
namespace {

constexpr std::size_t longest_number = 4000, most_edges = 4096;
constexpr const char* two_forms = "JSON, {\"matrices\": [[[1, 1], [0, 1]], ...]}, or a text 'matrices COUNT SIZE'";

Rational read_number(const std::string& text, const std::string& where) {
  const auto value = text.size() <= longest_number ? parse_number(text) : std::nullopt;
  if (!value)
    fail(
        ErrorKind::data,
        "{}: expected an exact number, as 1, 1/2 or 0.5, of at most {} characters, decimals of at most 1000 digits and "
        "exponents from -400 to 400; got {}",
        where, longest_number, in_quotes(text));
  return *value;
}

void check_sizes(const std::string& file, std::size_t count, std::size_t size) {
  if (!FamilyLimits::hold(count, size))
    fail(ErrorKind::data, "{}: expected 1 to {} matrices of size 1 to {} with at most {} entries, got {} of size {}",
         file, FamilyLimits::matrices, FamilyLimits::size, FamilyLimits::entries, count, size);
}

constexpr const char* byte_order_mark = "\xEF\xBB\xBF";

using Kind = JsonNode::Kind;

std::string at(const JsonNode& node) { return fmt::format("line {}, column {}", node.place.line, node.place.column); }

/// A number in a cell, in quotes or without.
Rational number_of(const JsonNode& node, const std::string& where) {
  if (node.kind != Kind::number && node.kind != Kind::string)
    fail(ErrorKind::data, "{}, {}: expected an exact number, as 1, \"1/2\" or 0.5", where, at(node));
  return read_number(node.text, fmt::format("{}, {}", where, at(node)));
}

bool is_list(const JsonNode& node, std::size_t size) { return node.kind == Kind::array && node.items.size() == size; }

/// A number alone is a matrix of size 1.
RationalMatrix matrix_of(const JsonNode& rows, std::size_t size, const std::string& name) {
  RationalMatrix matrix(size, size);
  if (size == 1 && rows.kind != Kind::array) {
    matrix(0, 0) = number_of(rows, name);
    return matrix;
  }
  if (!is_list(rows, size)) fail(ErrorKind::data, "{}, {}: expected {} rows", name, at(rows), size);
  for (std::size_t i = 0; i < size; ++i) {
    const std::string where = fmt::format("{}, row {}", name, i);
    if (!is_list(rows.items[i], size))
      fail(ErrorKind::data, "{}, {}: expected {} entries", where, at(rows.items[i]), size);
    for (std::size_t j = 0; j < size; ++j)
      matrix(i, j) = number_of(rows.items[i].items[j], fmt::format("{}, entry {}", where, j));
  }
  return matrix;
}

/// From and to which node, and by which matrix.
Succession edge_of(const JsonNode& edge, std::size_t matrices, const std::string& where) {
  std::size_t numbers[3] = {};
  if (!is_list(edge, 3)) fail(ErrorKind::data, "{}, {}: expected [from, to, matrix], three numbers", where, at(edge));
  for (std::size_t k = 0; k < 3; ++k) {
    const auto value = parse_rational(edge.items[k].text);
    const std::size_t most = k < 2 ? FamilyLimits::size : matrices;
    if (!value || denominator(*value) != 1 || *value < 0 || *value >= static_cast<long>(most))
      fail(ErrorKind::data, "{}, {}: expected [from, to, matrix], nodes 0 to {} and matrices 0 to {}", where, at(edge),
           FamilyLimits::size - 1, matrices - 1);
    numbers[k] = numerator(*value).convert_to<std::size_t>();
  }
  return {numbers[0], numbers[1], numbers[2]};
}

JsonNode checked_json(const std::string& text, const std::string& file) {
  try {
    JsonNode json = parse_json(text);
    only_keys(json, {"matrices", "edges"}, "a file of matrices");
    return json;
  } catch (const FileError& error) {
    fail(ErrorKind::data, "{}, {}", file, error.what());
  }
}

MatricesFile from_json(const std::string& text, const std::string& file) {
  const JsonNode json = checked_json(text, file);
  const JsonNode* lists = json.find("matrices");
  if (!lists || lists->kind != Kind::array || lists->items.empty())
    fail(ErrorKind::data, "{}: expected {{\"matrices\": [...]}} with at least one matrix", file);
  const JsonNode& first = lists->items.front();
  const std::size_t size = first.kind == Kind::array ? first.items.size() : 1;
  check_sizes(file, lists->items.size(), size);
  std::vector<RationalMatrix> matrices;
  for (const JsonNode& rows : lists->items)
    matrices.push_back(matrix_of(rows, size, fmt::format("{}, matrix {}", file, matrices.size())));
  MatricesFile result{std::move(matrices), {}};
  const JsonNode* edges = json.find("edges");
  if (!edges) return result;
  if (edges->kind != Kind::array || edges->items.empty() || edges->items.size() > most_edges)
    fail(ErrorKind::data, "{}, {}: expected \"edges\" to be a list of 1 to {} triples [from, to, matrix]", file,
         at(*edges), most_edges);
  std::size_t nodes = 0;
  for (const JsonNode& edge : edges->items) {
    result.graph.push_back(edge_of(edge, result.family.count(), fmt::format("{}, edge {}", file, result.graph.size())));
    nodes = std::max({nodes, result.graph.back().from + 1, result.graph.back().to + 1});
  }
  check_sizes(file + ", lifted by the graph", edges->items.size(), size * nodes);
  return result;
}

/// The words of a text, which know their lines.
class Words {
 public:
  explicit Words(const std::string& text) : text_(text), at_(text.starts_with(byte_order_mark) ? 3 : 0) {}

  /// Empty at the end.
  std::string next() {
    constexpr const char* blanks = " \t\r\n\f\v";
    const std::size_t begin = std::min(text_.find_first_not_of(blanks, at_), text_.size());
    line_ += std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                        text_.begin() + static_cast<std::ptrdiff_t>(begin), '\n');
    at_ = std::min(text_.find_first_of(blanks, begin), text_.size());
    return text_.substr(begin, at_ - begin);
  }
  std::ptrdiff_t line() const { return line_; }

 private:
  const std::string& text_;
  std::size_t at_;
  std::ptrdiff_t line_ = 1;
};

MatricesFile from_lines(const std::string& text, const std::string& file) {
  Words words(text);
  const auto refuse = [&](const std::string& expected, const std::string& word) {
    fail(ErrorKind::data, "{}, line {}: expected {}, got {}", file, words.line(), expected,
         word.empty() ? "the end" : in_quotes(word));
  };
  const auto read_count = [&] {
    const std::string word = words.next();
    const auto value = parse_rational(word);
    if (!value || denominator(*value) != 1 || *value < 0 || *value > 1'000'000) refuse("'matrices COUNT SIZE'", word);
    return numerator(*value).convert_to<std::size_t>();
  };
  if (const std::string word = words.next(); word != "matrices") refuse(two_forms, word);
  const std::size_t count = read_count(), size = read_count();
  check_sizes(file, count, size);
  std::vector<RationalMatrix> matrices;
  for (std::size_t t = 0; t < count; ++t) {
    RationalMatrix& matrix = matrices.emplace_back(size, size);
    for (std::size_t i = 0; i < size; ++i) {
      if (const std::string word = words.next(); word != "row")
        refuse(fmt::format("'row' and {} numbers, row {} of matrix {}", size, i, t), word);
      for (std::size_t j = 0; j < size; ++j) {
        const std::string word = words.next();
        if (word.empty() || word == "row") refuse(fmt::format("{} numbers in row {} of matrix {}", size, i, t), word);
        matrix(i, j) = read_number(word, fmt::format("{}, line {}", file, words.line()));
      }
    }
  }
  if (const std::string word = words.next(); !word.empty()) refuse("nothing after the last row", word);
  return {std::move(matrices), {}};
}

}  // namespace

MatricesFile parse_matrices(const std::string& text, const std::string& file) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n", text.starts_with(byte_order_mark) ? 3 : 0);
  return begin != std::string::npos && (text[begin] == '{' || text[begin] == '[') ? from_json(text, file)
                                                                                  : from_lines(text, file);
}

}  // namespace subcert
