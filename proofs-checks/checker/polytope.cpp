#include "polytope.hpp"

#include <algorithm>
#include <set>

namespace subcert_check {

Vector Polytope::turn(char letter, Vector x, Arithmetic& arithmetic) const {
  if (letter == 'f' && symmetric) {
    for (std::size_t start = 0; start < x.size(); start += size) std::reverse(&x[start], &x[start] + size);
    return x;
  }
  return arithmetic.multiply(named_generator(letter, generators).map, x, size);
}

namespace {

/// The vertex after a word of generators, the last letter first.
const Vector& turned_vertex(Polytope& body, const TurnedIndex& vertex, Arithmetic& arithmetic) {
  if (vertex.word.empty()) return body.vertices[vertex.index];
  require(!body.symmetric || vertex.word.size() == 1, "unknown generator");
  const auto [at, missing] = body.turned.try_emplace(vertex);
  if (!missing) return at->second;
  arithmetic.spend(2000 + 100 * body.size);
  const Vector& rest = turned_vertex(body, {vertex.index, vertex.word.substr(1)}, arithmetic);
  return at->second = body.turn(vertex.word.front(), rest, arithmetic);
}

/// Reads a line of terms. Returns the sum of their weights in absolute value, and the residual: the norm of
/// `target` * `target_scale` - (sum of the terms) * `sum_scale`.
Polytope::Combination read_combination(const std::string& head, Polytope& body, const Vector& target,
                                       const mpz_class& target_scale, const mpz_class& sum_scale, Reader& reader,
                                       Arithmetic& arithmetic) {
  mpz_class weights = 0, residual = 0;
  Vector sum(target.size());
  for (const std::string_view term : reader.take(head, 0, max_line)) {
    arithmetic.spend(1000);
    const Fields parts = split(term, ":");
    require(parts.size() == 1 + body.parts, "a term is INDEX:WEIGHT");
    std::string_view index = parts[0];
    const bool conjugate = body.parts == 2 && index.ends_with('c');
    if (conjugate) index.remove_suffix(1);
    const Vector& vertex = turned_vertex(body, parse_turned_index(index, body.vertices.size()), arithmetic);
    const mpz_class re = parse_integer(parts[1]), im = body.parts == 2 ? parse_integer(parts[2]) : mpz_class(0);
    require(!body.nonnegative || re >= 0, "negative weight");
    mpz_class square = 0;
    for (const mpz_class& x : {re, im}) arithmetic.add_product(square, x, x);
    if (square > 0) weights += sqrt(mpz_class(square - 1)) + 1;  // the modulus, rounded up
    // (Re, Im) of the term are this matrix times (Re, Im) of the vertex; only the first entry counts if not complex
    const Vector factor{re, im, conjugate ? im : -im, conjugate ? -re : re};
    for (std::size_t k = 0; k < body.size; ++k)
      for (std::size_t i = 0; i < body.parts * body.parts; ++i)
        arithmetic.add_product(sum[i % body.parts * body.size + k], factor[i], vertex[i / body.parts * body.size + k]);
  }
  for (std::size_t i = 0; i < target.size(); ++i) {
    mpz_class part = 0;
    arithmetic.add_product(part, target[i], target_scale);
    arithmetic.add_product(part, sum[i], -sum_scale);
    if (part > 0 || !body.nonnegative) residual += abs(part);
  }
  return {weights, residual};
}

}  // namespace

Polytope read_polytope_head(Family family, const Fields& fields, const mpq_class& entry_error, Reader& reader,
                            Arithmetic& arithmetic) {
  require(fields[0] == "polytope" && fields.size() >= 4,
          "expected 'norm', 'polytope', 'quadratic', 'graph' or 'single' and its numbers");
  const std::size_t n = family.size, vertices = parse_size(fields[1], 1, max_bytes);
  const std::size_t vertex_bits = parse_size(fields[2], 0, 4096), weight_bits = parse_size(fields[3], 0, 4096);
  std::set<std::string_view> properties(fields.begin() + 4, fields.end());
  require(properties.size() + 4 == fields.size(), "a polytope property twice");
  const bool transposed = properties.erase("transposed") != 0;
  if (transposed) family.transpose();
  const bool complex = properties.erase("complex") != 0, nonnegative = properties.erase("nonnegative") != 0;
  const bool symmetric = properties.erase("symmetric") != 0;
  const std::size_t generators = properties.size() == 1 ? parse_group(*properties.begin()) : 0;
  if (generators > 0) properties.clear();
  require(!(generators > 0 && (symmetric || nonnegative)), "a group goes with neither 'symmetric' nor 'nonnegative'");
  require(generators == 0 || entry_error == 0, "a group proves nothing of rounded masks");
  require(properties.empty() && !(complex && nonnegative), "unknown polytope property");
  const Vector& entries = family.entries;
  require(!symmetric || std::equal(entries.begin(), entries.end(), entries.rbegin()), "the family is not symmetric");
  require(!nonnegative || is_nonnegative(entries), "a matrix is not non-negative");

  Polytope body{family,
                n,
                complex ? 2U : 1U,
                vertices,
                nonnegative,
                symmetric,
                transposed,
                {},
                mpz_class(1) << vertex_bits,
                mpz_class(1) << weight_bits,
                {},
                {},
                {},
                {},
                {}};
  body.generators = read_generators(family, generators, reader, arithmetic);
  return body;
}

const Vector& read_vertex(Polytope& body, Reader& reader) {
  Vector& vertex = body.vertices.emplace_back();
  for (const std::string_view field : reader.take("vertex", body.parts * body.size, body.parts * body.size))
    vertex.push_back(parse_integer(field));
  require(!body.nonnegative || is_nonnegative(vertex), "negative coordinate");
  return vertex;
}

Polytope::Combination read_image(Polytope& body, std::size_t vertex, std::size_t matrix, int side, Reader& reader,
                                 Arithmetic& arithmetic) {
  return read_combination("image " + std::to_string(vertex) + " " + std::to_string(matrix), body,
                          body.image(matrix, body.vertices[vertex], arithmetic), side * body.weight_one,
                          side * body.family.denominator, reader, arithmetic);
}

Polytope read_polytope(Family family, const Fields& fields, const mpq_class& entry_error, Reader& reader,
                       Arithmetic& arithmetic) {
  Polytope body = read_polytope_head(std::move(family), fields, entry_error, reader, arithmetic);
  while (body.vertices.size() < body.count) read_vertex(body, reader);
  const std::size_t n = body.size;
  const mpz_class& denominator = body.family.denominator;
  const mpz_class one = body.weight_one * body.vertex_one;
  mpz_class most_residual = 0, most_weights = 0;  // R and S of Theorem 6, over `one` and over weight_one
  for (std::size_t k = 0; k < (body.symmetric ? (n + 1) / 2 : n); ++k) {
    Vector unit(body.parts * n);
    unit[k] = 1;
    const auto [weights, residual] = read_combination("unit " + std::to_string(k), body, unit, one, 1, reader,
                                                      arithmetic);
    most_residual = std::max(most_residual, residual);
    most_weights = std::max(most_weights, weights);
  }
  require(most_residual < one, "the vertices do not span: a unit's residual is 1 or more");
  body.unit_norm = most_weights * body.vertex_one / (one - most_residual) + 1;  // at least E
  mpq_class bound = 0;                                                          // over `one` * denominator
  for (std::size_t j = 0; j < body.count; ++j)
    for (std::size_t t = 0; t < body.family.count(); ++t) {
      body.images.push_back(read_image(body, j, t, 1, reader, arithmetic));
      const auto& [weights, residual] = body.images.back();
      mpz_class length = 0;
      for (const mpz_class& x : body.vertices[j]) length += abs(x);
      const mpq_class off = entry_error * (length * n * body.weight_one * denominator);
      bound = std::max(bound, mpq_class(weights * denominator * body.vertex_one + (residual + off) * body.unit_norm));
    }
  body.bound = bound / (one * denominator);
  return body;
}

}  // namespace subcert_check
