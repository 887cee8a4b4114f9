#include "quadratic.hpp"

#include "group.hpp"

#include <algorithm>
#include <iterator>
#include <map>
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

using Forms = std::map<TurnedIndex, Vector>;  // h^T P h by the number of P and the word of h

const Vector& turned_form(Forms& forms, const TurnedIndex& name, const std::vector<Generator>& generators,
                          std::size_t n, Arithmetic& arithmetic) {
  const auto [at, missing] = forms.try_emplace(name);
  if (!missing) return at->second;
  arithmetic.spend(2000);
  const std::size_t rest = name.word.size() - 1;  // a form without a word is there
  const Vector& map = named_generator(name.word[rest], generators).map;
  const Vector& form = turned_form(forms, {name.index, name.word.substr(0, rest)}, generators, n, arithmetic);
  return at->second = congruent(map, form, n, arithmetic);
}

using Word = std::u16string;  // a character for each letter

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
      for (const char16_t letter : word) image += static_cast<char16_t>(first[generator.letters[letter]]);
      arithmetic.spend(1000 + 100 * word.size());
      if (words.insert(image).second) fresh.push_back(std::move(image));
    }
  }
}

/// Of all long sequences of `letters` different letters as many as begin with one word of each length.
Vector shares_of(std::size_t letters) {
  Vector shares(longest_word + 1, 1);
  for (std::size_t k = longest_word; k-- > 0;) shares[k] = shares[k + 1] * letters;
  return shares;
}

/// Whether each long sequence of letters begins with exactly one of the words.
bool is_complete(const std::set<Word>& words, const Vector& shares) {
  mpz_class covered = 0;
  const Word* before = nullptr;
  for (const Word& word : words) {
    if (before != nullptr && word.starts_with(*before)) return false;
    covered += shares[word.size()];
    before = &word;
  }
  return covered == shares[0];
}

}  // namespace

mpq_class read_quadratic(const Family& family, const Fields& fields, Reader& reader, Arithmetic& arithmetic) {
  const bool several = fields.size() > 3 && fields[3].starts_with("forms:");
  const std::size_t form_count = several ? parse_size(fields[3].substr(6), 2, 1000) : 1, next = several ? 4 : 3;
  const std::size_t generator_count = fields.size() == next + 1 ? parse_group(fields[next]) : 0;
  require(fields.size() == next || generator_count > 0,
          "expected 'quadratic', a number of words, a bound and perhaps forms and a group");
  const std::size_t n = family.size, count = parse_size(fields[1], 1, max_bytes);
  const mpq_class bound = parse_rational(fields[2]);
  require(bound >= 0, "the bound of a quadratic form is negative");
  const std::vector<Generator> generators = read_generators(family, generator_count, reader, arithmetic);
  Forms forms;
  for (std::size_t f = 0; f < form_count; ++f) {
    Vector form(n * n);
    for (std::size_t i = 0; i < n; ++i) {
      const Fields row = reader.take("form", i + 1, i + 1);
      for (std::size_t j = 0; j <= i; ++j) form[i * n + j] = form[j * n + i] = parse_integer(row[j]);
    }
    require(form[0] != 0 && is_positive(form, n, arithmetic), "a form is not positive definite");
    forms.insert({{f, ""}, std::move(form)});
  }

  const std::vector<std::size_t> first = first_of_equals(family);
  const mpq_class unit = bound * family.denominator;
  std::vector<std::set<Word>> words(form_count);  // by the form they start from
  Word last;
  std::vector<Vector> products;  // of the beginnings of the last word
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t ends = several ? 2 : 0;
    const Fields letters = reader.take("word", ends + 1, ends + longest_word);
    const std::size_t from = several ? parse_size(letters[0], 0, form_count - 1) : 0;
    const TurnedIndex to = several ? parse_turned_index(letters[1], form_count) : TurnedIndex{0, ""};
    Word word;
    for (std::size_t i = ends; i < letters.size(); ++i)
      word += static_cast<char16_t>(first[parse_size(letters[i], 0, family.count() - 1)]);
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
    const Vector& target = turned_form(forms, to, generators, n, arithmetic);
    Vector difference = congruent(products.back(), forms.at({from, ""}), n, arithmetic);
    for (std::size_t i = 0; i < n * n; ++i) difference[i] = whole * target[i] - (difference[i] << 64);
    require(is_positive(std::move(difference), n, arithmetic),
            "a product is not below the bound in the quadratic form");
    require(words[from].insert(word).second, "a word occurs twice");
    last = std::move(word);
  }

  const std::set<std::size_t> different(first.begin(), first.end());
  const Vector shares = shares_of(different.size());
  for (std::size_t f = 0; f < form_count; ++f) {
    const Vector& form = forms.at({f, ""});
    std::vector<Generator> keeping;
    std::ranges::copy_if(generators, std::back_inserter(keeping), [&](const Generator& generator) {
      return congruent(generator.map, form, n, arithmetic) == form;
    });
    close(words[f], keeping, first, arithmetic);
    require(is_complete(words[f], shares), "the words are not those of a complete tree");
  }
  return bound;
}

}  // namespace subcert_check
