#include "quadratic.hpp"

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

/// Lemma 8: whether a symmetric matrix is shown to be positive semidefinite.
bool is_positive(Vector s, std::size_t n, Arithmetic& arithmetic) {
  constexpr std::size_t half = 128;
  mpz_class largest = 0;
  for (const mpz_class& x : s) largest = std::max(largest, mpz_class(abs(x)));
  if (largest == 0) return true;
  const std::size_t size = bits(largest);
  const mpz_class margin = (mpz_class(n) << half) + n;
  for (std::size_t i = 0; i < n * n; ++i) {
    if (size <= 2 * half)
      s[i] <<= 2 * half - size;
    else
      s[i] >>= size - 2 * half;  // towards minus infinity
    if (i % (n + 1) == 0) s[i] -= margin;
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t l = 0; l < k; ++l) {
      const mpz_class factor = -s[l * n + k];
      for (std::size_t j = k; j < n; ++j) arithmetic.add_product(s[k * n + j], factor, s[l * n + j]);
    }
    mpz_class& pivot = s[k * n + k];
    if (pivot <= 0) return false;
    pivot = sqrt(pivot);
    for (std::size_t j = k + 1; j < n; ++j)
      mpz_fdiv_q(s[k * n + j].get_mpz_t(), s[k * n + j].get_mpz_t(), pivot.get_mpz_t());
  }
  return true;
}

using Word = std::string;  // a character for each letter

/// Of equal matrices the first stands for all.
std::vector<std::size_t> first_of_equals(const Family& family) {
  std::vector<std::size_t> result;
  for (std::size_t t = 0; t < family.count(); ++t) {
    std::size_t first = 0;
    while (!std::ranges::equal(family.matrix(first), family.matrix(t))) ++first;
    result.push_back(first);
  }
  return result;
}

/// Adds the images under the generators.
void close(std::set<Word>& words, const std::vector<Generator>& generators, const std::vector<std::size_t>& first,
           Arithmetic& arithmetic) {
  for (std::vector<Word> fresh(words.begin(), words.end()); !fresh.empty();) {
    const Word word = std::move(fresh.back());
    fresh.pop_back();
    for (const Generator& generator : generators) {
      Word image;
      for (const char letter : word)
        image += static_cast<char>(first[generator.letters[static_cast<std::size_t>(letter)]]);
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

mpq_class read_quadratic(const Family& family, const Fields& fields, Reader& reader, Arithmetic& arithmetic) {
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

  const std::vector<std::size_t> first = first_of_equals(family);
  const mpq_class unit = bound * family.denominator;
  std::set<Word> words;
  Word last;
  std::vector<Vector> products;  // of the beginnings of the last word
  for (std::size_t k = 0; k < count; ++k) {
    const Fields letters = reader.take("word", 1, longest_word);
    Word word;
    for (const std::string_view letter : letters)
      word += static_cast<char>(first[parse_size(letter, 0, family.count() - 1)]);
    const auto common = std::mismatch(word.begin(), word.end(), last.begin(), last.end()).first - word.begin();
    products.resize(static_cast<std::size_t>(common));
    for (std::size_t i = products.size(); i < word.size(); ++i) {
      const auto matrix = family.matrix(static_cast<std::size_t>(word[i]));
      Vector product(matrix.begin(), matrix.end());
      if (i > 0) product = arithmetic.multiply(products.back(), product, n);
      for (const mpz_class& x : product) arithmetic.spend(200 * std::uint64_t{mpz_size(x.get_mpz_t())});
      products.push_back(std::move(product));
    }
    const mpq_class factor = power(unit, 2 * word.size());
    const mpz_class whole = (factor.get_num() << 64) / factor.get_den();
    Vector difference = congruent(products.back(), form, n, arithmetic);
    for (std::size_t i = 0; i < n * n; ++i) difference[i] = whole * form[i] - (difference[i] << 64);
    require(is_positive(std::move(difference), n, arithmetic),
            "a product is not below the bound in the quadratic form");
    require(words.insert(word).second, "a word occurs twice");
    last = std::move(word);
  }
  close(words, generators, first, arithmetic);
  std::set<std::size_t> different(first.begin(), first.end());
  require(is_complete(words, different.size()), "the words are not those of a complete tree");
  return bound;
}

}  // namespace subcert_check
