#include "group.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace subcert_check {

const Generator& named_generator(char letter, const std::vector<Generator>& generators) {
  const std::size_t number = static_cast<unsigned char>(letter) - std::size_t{'A'};
  require(number < generators.size(), "unknown generator");
  return generators[number];
}

TurnedIndex parse_turned_index(std::string_view text, std::size_t count) {
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  require(text.size() - digits <= 16, "a word of more than 16 generators");
  return {parse_size(text.substr(0, digits), 0, count - 1), std::string(text.substr(digits))};
}

std::size_t parse_group(std::string_view property) {
  return property.starts_with("group:") ? parse_size(property.substr(6), 1, 8) : 0;
}

std::vector<Generator> read_generators(const Family& family, std::size_t count, Reader& reader,
                                       Arithmetic& arithmetic) {
  constexpr std::size_t most_elements = 96;
  const std::size_t n = family.size;
  std::vector<Generator> generators;
  for (std::size_t k = 0; k < count; ++k) {
    auto& [map, letters] = generators.emplace_back(Generator{Vector(n * n), {}});
    for (const std::string_view field : reader.take("generator", family.count(), family.count()))
      letters.push_back(parse_size(field, 0, family.count() - 1));
    for (std::size_t i = 0; i < n; ++i) {
      const Fields row = reader.take("map", n, n);
      for (std::size_t j = 0; j < n; ++j) map[j * n + i] = parse_integer(row[j]);
    }
    for (std::size_t t = 0; t < family.count(); ++t) {
      const auto matrix = family.matrix(letters[t]);
      require(arithmetic.multiply(family.matrix(t), map, n) ==
                  arithmetic.multiply(map, Vector(matrix.begin(), matrix.end()), n),
              "a generator does not permute the matrices as it says");
    }
    require(determinant(map, n, arithmetic) != 0, "a generator is singular");
  }
  Vector identity(n * n);
  for (std::size_t i = 0; i < n; ++i) identity[i * n + i] = 1;
  std::set<Vector> known{identity};  // each up to its sign
  for (std::vector<Vector> fresh{identity}; !fresh.empty();) {
    const Vector element = std::move(fresh.back());
    fresh.pop_back();
    for (const Generator& generator : generators) {
      Vector next = arithmetic.multiply(generator.map, element, n);
      const auto leading = std::find_if(next.begin(), next.end(), [](const mpz_class& x) { return x != 0; });
      if (*leading < 0)
        for (mpz_class& x : next) x = -x;
      if (known.insert(next).second) fresh.push_back(std::move(next));
      require(known.size() <= most_elements, "the generators span a group of more than 96 elements");
    }
  }
  return generators;
}

}  // namespace subcert_check
