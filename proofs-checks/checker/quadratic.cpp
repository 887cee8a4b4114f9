#include "graph.hpp"

#include "definite.hpp"
#include "group.hpp"

#include <algorithm>
#include <set>

namespace subcert_check {
namespace {

constexpr std::size_t longest_word = 1000;

/// m^T `form` m.
Vector congruent(std::span<const mpz_class> m, const Vector& form, std::size_t n, Arithmetic& arithmetic) {
  Vector transposed(n * n);
  for (std::size_t i = 0; i < n * n; ++i) transposed[i % n * n + i / n] = m[i];
  return arithmetic.multiply(transposed, arithmetic.multiply(form, Vector(m.begin(), m.end()), n), n);
}

using Word = std::u16string;  // a character for each letter

/// Adds the images under the generators.
void close(std::set<Word>& words, const std::vector<Generator>& generators, const std::vector<std::size_t>& first,
           Arithmetic& arithmetic) {
  for (std::vector<Word> fresh(words.begin(), words.end()); !fresh.empty();) {
    const Word word = std::move(fresh.back());
    fresh.pop_back();
    for (const Generator& generator : generators) {
      Word image;
      for (const char16_t letter : word) image += static_cast<char16_t>(first[generator.letters[letter]]);
      arithmetic.spend(1000 + 100 * word.size());
      if (words.insert(image).second) fresh.push_back(std::move(image));
    }
  }
}

/// Whether each long sequence of `letters` different letters begins with exactly one of the words.
bool is_complete(const std::set<Word>& words, std::size_t letters) {
  mpz_class covered = 0, all;
  mpz_ui_pow_ui(all.get_mpz_t(), letters, longest_word);
  std::vector<mpz_class> shares{all};
  for (std::size_t k = 0; k < longest_word; ++k) shares.push_back(shares.back() / letters);
  const Word* before = nullptr;
  for (const Word& word : words) {
    if (before != nullptr && word.starts_with(*before)) return false;
    covered += shares[word.size()];
    before = &word;
  }
  return covered == all;
}

}  // namespace

GraphBound read_quadratic(const Family& family, const Fields& fields, const ExactRadius* exact, Reader& reader,
                          Arithmetic& arithmetic) {
  require(fields.size() == 3 || (fields.size() == 4 && parse_group(fields[3]) > 0),
          "expected 'quadratic', a number of words, a bound and perhaps a group");
  const std::size_t n = family.size, count = parse_size(fields[1], 1, max_bytes);
  const mpq_class bound = parse_rational(fields[2]);
  require(bound >= 0, "the bound of a quadratic form is negative");
  const std::vector<Generator> generators = read_generators(family, fields.size() == 4 ? parse_group(fields[3]) : 0,
                                                            reader, arithmetic);
  Vector form(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    const Fields row = reader.take("form", i + 1, i + 1);
    for (std::size_t j = 0; j <= i; ++j) form[i * n + j] = form[j * n + i] = parse_integer(row[j]);
  }
  require(form[0] != 0 && is_positive(form, n, arithmetic), "the form is not positive definite");
  for (const Generator& generator : generators)
    require(congruent(generator.map, form, n, arithmetic) == form, "a generator does not keep the form");

  const std::vector<std::size_t> first = family.letters();
  const mpq_class unit = bound * family.denominator;
  std::set<Word> words;
  Word last;
  std::vector<Vector> products;  // of the beginnings of the last word
  bool kept = false;             // the form, by a word, times a power of the bound
  for (std::size_t k = 0; k < count; ++k) {
    const Fields letters = reader.take("word", 1, longest_word);
    Word word;
    for (const std::string_view letter : letters)
      word += static_cast<char16_t>(first[parse_size(letter, 0, family.count() - 1)]);
    const auto common = std::mismatch(word.begin(), word.end(), last.begin(), last.end()).first - word.begin();
    products.resize(static_cast<std::size_t>(common));
    for (std::size_t i = products.size(); i < word.size(); ++i) {
      const auto matrix = family.matrix(word[i]);
      Vector product(matrix.begin(), matrix.end());
      if (i > 0) product = arithmetic.multiply(products.back(), product, n);
      for (const mpz_class& x : product) arithmetic.spend(200 * std::uint64_t{mpz_size(x.get_mpz_t())});
      products.push_back(std::move(product));
    }
    const mpq_class factor = power(unit, 2 * word.size());
    const mpz_class whole = (factor.get_num() << 64) / factor.get_den();
    Vector difference = congruent(products.back(), form, n, arithmetic);
    for (std::size_t i = 0; i < n * n; ++i) difference[i] = whole * form[i] - (difference[i] << 64);
    kept = kept || (whole * factor.get_den() == factor.get_num() << 64 &&
                    std::ranges::all_of(difference, [](const mpz_class& x) { return x == 0; }));
    require(is_positive(std::move(difference), n, arithmetic),
            "a product is not below the bound in the quadratic form");
    require(words.insert(word).second, "a word occurs twice");
    last = std::move(word);
  }
  close(words, generators, first, arithmetic);
  std::set<std::size_t> different(first.begin(), first.end());
  require(is_complete(words, different.size()), "the words are not those of a complete tree");
  return {bound, exact != nullptr && kept && exact->low == exact->high && bound == exact->low};
}

}  // namespace subcert_check
