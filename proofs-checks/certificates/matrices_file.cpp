#include "matrices_file.hpp"

#include <subcert/analysis/regularity/radius/joint_spectral_radius.hpp>
#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/analysis/symbol/error.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace subcert {
namespace {

constexpr std::size_t longest_number = 4000, most_edges = 4096;

Rational read_number(const std::string& text, const std::string& where) {
  const auto value = text.size() <= longest_number ? parse_number(text) : std::nullopt;
  if (!value)
    fail(ErrorKind::data, "{}: expected an exact number, as 1, 1/2 or 0.5, got '{}'", where, text.substr(0, 40));
  return *value;
}

void check_sizes(const std::string& file, std::size_t count, std::size_t size) {
  if (!FamilyLimits::hold(count, size))
    fail(ErrorKind::data, "{}: expected 1 to {} matrices of size 1 to {} with at most {} entries, got {} of size {}",
         file, FamilyLimits::matrices, FamilyLimits::size, FamilyLimits::entries, count, size);
}

/// JSON with its numbers as strings, so that none goes through a double.
std::string with_quoted_numbers(const std::string& text) {
  constexpr std::string_view number = "0123456789+-.eE";
  std::string result;
  bool in_string = false, in_number = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool starts = !in_string && !in_number && (c == '-' || (c >= '0' && c <= '9'));
    const bool ends = in_number && number.find(c) == std::string_view::npos;
    if (starts || ends) {
      result += '"';
      in_number = starts;
    }
    if (in_string && c == '\\') result += text[i++];
    if (i < text.size()) result += text[i];
    if (c == '"') in_string = !in_string;
  }
  return in_number ? result + '"' : result;
}

RationalMatrix matrix_of(const nlohmann::json& rows, std::size_t size, const std::string& name) {
  if (!rows.is_array() || rows.size() != size) fail(ErrorKind::data, "{}: expected {} rows", name, size);
  RationalMatrix matrix(size, size);
  for (std::size_t i = 0; i < size; ++i) {
    const std::string where = fmt::format("{}, row {}", name, i);
    if (!rows[i].is_array() || rows[i].size() != size) fail(ErrorKind::data, "{}: expected {} entries", where, size);
    for (std::size_t j = 0; j < size; ++j) {
      const std::string place = fmt::format("{}, entry {}", where, j);
      matrix(i, j) = read_number(rows[i][j].is_string() ? rows[i][j].get<std::string>() : rows[i][j].dump(), place);
    }
  }
  return matrix;
}

/// From and to which node, and by which matrix.
Succession edge_of(const nlohmann::json& edge, std::size_t matrices, const std::string& where) {
  std::size_t numbers[3] = {};
  const bool is_list = edge.is_array() && edge.size() == 3;
  for (std::size_t k = 0; is_list && k < 3; ++k) {
    const auto value = edge[k].is_string() ? parse_rational(edge[k].get<std::string>()) : std::nullopt;
    const std::size_t most = k < 2 ? FamilyLimits::size : matrices;
    if (!value || denominator(*value) != 1 || *value < 0 || *value >= static_cast<long>(most))
      fail(ErrorKind::data, "{}: expected [from, to, matrix], nodes 0 to {} and matrices 0 to {}", where,
           FamilyLimits::size - 1, matrices - 1);
    numbers[k] = numerator(*value).convert_to<std::size_t>();
  }
  if (!is_list) fail(ErrorKind::data, "{}: expected [from, to, matrix], three numbers", where);
  return {numbers[0], numbers[1], numbers[2]};
}

MatricesFile from_json(const std::string& text, const std::string& file) {
  const auto json = nlohmann::json::parse(with_quoted_numbers(text), nullptr, false);
  if (json.is_discarded())
    fail(ErrorKind::data,
         "{}: neither JSON, {{\"matrices\": [[[1, 1], [0, 1]], ...]}}, nor a text 'matrices COUNT SIZE'", file);
  if (!json.is_object() || !json.contains("matrices") || !json["matrices"].is_array() || json["matrices"].empty())
    fail(ErrorKind::data, "{}: expected {{\"matrices\": [...]}} with at least one matrix", file);
  const auto& lists = json["matrices"];
  const std::size_t size = lists[0].is_array() ? lists[0].size() : 0;
  check_sizes(file, lists.size(), size);
  std::vector<RationalMatrix> matrices;
  for (const auto& rows : lists)
    matrices.push_back(matrix_of(rows, size, fmt::format("{}, matrix {}", file, matrices.size())));
  MatricesFile result{std::move(matrices), {}};
  if (!json.contains("edges")) return result;
  const auto& edges = json["edges"];
  if (!edges.is_array() || edges.empty() || edges.size() > most_edges)
    fail(ErrorKind::data, "{}: expected \"edges\" to be a list of 1 to {} triples [from, to, matrix]", file,
         most_edges);
  std::size_t nodes = 0;
  for (const auto& edge : edges) {
    result.graph.push_back(edge_of(edge, result.family.count(), fmt::format("{}, edge {}", file, result.graph.size())));
    nodes = std::max({nodes, result.graph.back().from + 1, result.graph.back().to + 1});
  }
  check_sizes(file + ", lifted by the graph", edges.size(), size * nodes);
  return result;
}

MatricesFile from_lines(const std::string& text, const std::string& file) {
  std::istringstream words(text);
  std::string word;
  std::size_t count = 0, size = 0;
  if (!(words >> word) || word != "matrices" || !(words >> count >> size))
    fail(ErrorKind::data, "{}, line 1: expected 'matrices COUNT SIZE'", file);
  check_sizes(file, count, size);
  std::vector<RationalMatrix> matrices;
  for (std::size_t t = 0; t < count; ++t) {
    RationalMatrix& matrix = matrices.emplace_back(size, size);
    for (std::size_t i = 0; i < size; ++i) {
      const std::string where = fmt::format("{}, line {}", file, 2 + t * size + i);
      if (!(words >> word) || word != "row") fail(ErrorKind::data, "{}: expected 'row' and {} numbers", where, size);
      for (std::size_t j = 0; j < size; ++j) {
        if (!(words >> word)) fail(ErrorKind::data, "{}: expected {} numbers", where, size);
        matrix(i, j) = read_number(word, where);
      }
    }
  }
  if (words >> word)
    fail(ErrorKind::data, "{}: expected nothing after the last row, got '{}'", file, word.substr(0, 40));
  return {std::move(matrices), {}};
}

}  // namespace

MatricesFile parse_matrices(const std::string& text, const std::string& file) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != std::string::npos && text.compare(begin, 8, "matrices") == 0 ? from_lines(text, file)
                                                                               : from_json(text, file);
}

}  // namespace subcert
