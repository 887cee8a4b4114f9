#include "subradius.hpp"

#include "polytope.hpp"

#include <algorithm>

namespace subcert_check {
namespace {

/// A product that takes positive weights to at most RE times them.
void read_upper_end(const Family& family, const std::optional<mpq_class>& upper, Reader& reader,
                    Arithmetic& arithmetic) {
  const Fields fields = reader.take("product", 4, 3 + 4096);
  parse_size(fields[0], 0, 0);
  const mpq_class re = parse_rational(fields[1]), im = parse_rational(fields[2]);
  require(re >= 0 && im == 0, "the product of a subradius needs a real number that is not negative");
  std::vector<std::size_t> letters;
  for (std::size_t i = 3; i < fields.size(); ++i) letters.push_back(parse_size(fields[i], 0, family.count() - 1));
  Vector weights;
  for (const std::string_view field : reader.take("weights", family.size, family.size)) {
    weights.push_back(parse_integer(field));
    require(weights.back() > 0, "a weight is not positive");
  }
  Vector image = weights;
  for (std::size_t i = letters.size(); i-- > 0;)
    image = arithmetic.multiply(family.matrix(letters[i]), image, family.size);
  const mpz_class allowed = re.get_num() * power(family.denominator, letters.size()).get_num();
  for (std::size_t i = 0; i < family.size; ++i) {
    mpz_class rest = 0;
    arithmetic.add_product(rest, allowed, weights[i]);
    arithmetic.add_product(rest, image[i], -re.get_den());
    require(rest >= 0, "the product takes a weight to more than the given multiple");
  }
  require(!upper || (*upper >= 0 && re <= power(*upper, letters.size())), "the product does not prove the upper end");
}

/// Vertices that each matrix takes above a multiple of a mean of vertices.
void read_lower_end(const Family& family, const std::optional<mpq_class>& lower, Reader& reader,
                    Arithmetic& arithmetic) {
  Fields fields = reader.take("block 0", 4, 5);
  require(fields.size() == 4 || fields[4] == "transposed", "unknown property of the polytope of a subradius");
  fields.push_back("nonnegative");
  Polytope body = read_polytope_head(family, fields, 0, reader, arithmetic);
  while (body.vertices.size() < body.count) require(read_vertex(body, reader) != Vector(body.size), "a vertex is 0");
  std::optional<mpz_class> least;
  for (std::size_t j = 0; j < body.count; ++j)
    for (std::size_t t = 0; t < family.count(); ++t) {
      const auto [weights, residual] = read_image(body, j, t, -1, reader, arithmetic);
      require(residual == 0, "an image is not above the sum of its terms");
      least = least ? std::min(*least, weights) : weights;
    }
  require(!lower || *lower * body.weight_one <= *least, "the weights of an image do not prove the lower end");
}

}  // namespace

void read_subradius(const Family& family, const std::optional<mpq_class>& lower, const std::optional<mpq_class>& upper,
                    Reader& reader, Arithmetic& arithmetic) {
  if (upper || reader.at("product")) read_upper_end(family, upper, reader, arithmetic);
  if (lower || reader.at("block 0")) read_lower_end(family, lower, reader, arithmetic);
}

}  // namespace subcert_check
