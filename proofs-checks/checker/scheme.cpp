
#include "scheme.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace subcert_check {
namespace {

constexpr std::size_t max_coefficients = 10'000;      // of a mask
constexpr std::size_t max_degree = 12;                // of a parameter
constexpr std::size_t max_denominator_bits = 10'000;  // of the common denominator of a mask or a family
constexpr std::size_t max_family_bits = 1UL << 32;    // of that denominator times the number of entries

/// The sum of a[i] * 2^(k * floor(i / step)) over the i that leave the remainder `start`.
mpz_class value_at_power(const Vector& a, std::size_t start, std::size_t step, std::size_t k) {
  mpz_class value = 0;
  for (std::size_t i = a.size(); i-- > 0;)
    if (i % step == start) value = (value << k) + a[i];
  return value;
}

}  // namespace

Rationals parse_polynomial(std::string_view text, char letter) {
  require(!text.empty(), "a coefficient is empty");
  Rationals coefficients(1);
  for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end) {
    end = std::min(text.find_first_of("+-", begin + 1), text.size());
    std::string_view term = text.substr(begin, end - begin);
    if (begin > 0 && term.front() == '+') term.remove_prefix(1);
    const std::size_t at = letter == '\0' ? term.npos : term.find(letter);
    std::size_t power = 0;
    std::string factor(term.substr(0, at));
    if (at != term.npos) {
      const std::string_view exponent = term.substr(at + 1);
      require(exponent.empty() || exponent.front() == '^', "not a term c*w^k");
      power = exponent.empty() ? 1 : parse_size(exponent.substr(1), 1, max_degree);
      if (factor.empty() || factor == "-")
        factor += '1';
      else
        require(std::exchange(factor.back(), ' ') == '*', "not a term c*w^k"), factor.pop_back();
    }
    if (coefficients.size() <= power) coefficients.resize(power + 1);
    coefficients[power] += parse_rational(factor);
  }
  return coefficients;
}

namespace {

/// `inner`: how many of the innermost lists belong to a coefficient.
Mask parse_lists(std::string_view text, char letter, std::size_t inner, const char* expected) {
  const std::size_t variables = std::min(text.find_first_not_of('['), text.size()), end = text.rfind(']') + 1;
  require(variables > inner && variables <= 3 + inner && end >= 2 * variables, expected);
  const Fields tail = split(text.substr(end), "@");
  require(text.substr(end - variables, variables) == std::string(variables, ']') && tail.size() <= 2 &&
              (tail[0].empty() || tail[0].starts_with('/')),
          expected);
  Mask mask{std::vector<std::size_t>(variables), Vector(variables - inner), 0, 1, {}, 1, {1}};
  Fields lists{text.substr(variables, end - 2 * variables)};
  for (std::size_t v = variables; v-- > 0;) {
    Fields items;
    for (const std::string_view list : lists) {
      const Fields parts = split(list, std::string(v, ']') + "," + std::string(v, '['));
      require(items.empty() || parts.size() == mask.sizes[v], "a list of a mask is longer than another");
      mask.sizes[v] = parts.size();
      items.insert(items.end(), parts.begin(), parts.end());
    }
    lists = items;
  }
  require(lists.size() <= max_coefficients, "a mask with too many coefficients");
  const bool divided = letter != '\0' && tail[0].starts_with("/(") && tail[0].ends_with(')');
  mpq_class scale = divided ? mpq_class(1) : parse_rational("1" + std::string(tail[0]));
  if (divided) {
    const Family divisor = clear_denominators(1, parse_polynomial(tail[0].substr(2, tail[0].size() - 3), letter));
    mask.divisor = divisor.entries;
    mask.powers = divisor.entries.size();
    scale = divisor.denominator;
  }
  std::vector<Rationals> polynomials;
  for (const std::string_view c : lists)
    mask.powers = std::max(mask.powers, polynomials.emplace_back(parse_polynomial(c, letter)).size());
  mask.divisor.resize(mask.powers);
  Rationals values;
  for (std::size_t k = 0; k < mask.powers; ++k)
    for (const Rationals& c : polynomials) values.push_back(k < c.size() ? mpq_class(c[k] * scale) : mpq_class(0));
  const Family cleared = clear_denominators(1, values);
  mask.coefficients = cleared.entries;
  mask.denominator = cleared.denominator;
  if (tail.size() == 2) {
    const Fields first = split(tail[1], ",");
    require(first.size() == mask.first.size(), expected);
    std::transform(first.begin(), first.end(), mask.first.begin(), parse_integer);
  }
  return mask;
}

}  // namespace

bool is_nonnegative(const Vector& x) {
  return std::all_of(x.begin(), x.end(), [](const mpz_class& entry) { return entry >= 0; });
}

void Family::transpose() {
  for (std::size_t t = 0; t < count(); ++t)
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < i; ++j)
        std::swap(entries[(t * size + i) * size + j], entries[(t * size + j) * size + i]);
}

void Family::reflect() {
  transpose();
  for (std::size_t t = 0; t < count(); ++t)
    std::reverse(entries.begin() + static_cast<std::ptrdiff_t>(t * size * size),
                 entries.begin() + static_cast<std::ptrdiff_t>((t + 1) * size * size));
}

std::vector<std::size_t> Family::letters() const {
  std::vector<std::size_t> result;
  for (std::size_t t = 0; t < count(); ++t) {
    std::size_t first = 0;
    while (!std::ranges::equal(matrix(first), matrix(t))) ++first;
    result.push_back(first);
  }
  return result;
}

Family clear_denominators(std::size_t size, const Rationals& values) {
  mpz_class denominator = 1;
  for (const mpq_class& x : values) {
    denominator = lcm(denominator, x.get_den());
    require(bits(denominator) <= max_denominator_bits, "common denominator too large");
  }
  require(values.size() * bits(denominator) <= max_family_bits, "matrices too large");
  Vector cleared;
  for (const mpq_class& x : values) cleared.emplace_back(x.get_num() * (denominator / x.get_den()));
  return {size, cleared, denominator};
}

Family read_family(Reader& reader, const std::string& head, std::size_t count, std::size_t size) {
  Rationals rows;
  for (std::size_t i = 0; i < count * size; ++i)
    for (const std::string_view field : reader.take(head, size, size)) rows.push_back(parse_rational(field));
  Family family = clear_denominators(size, rows);
  family.transpose();
  return family;
}

Mask parse_mask(std::string_view text, char letter) {
  return parse_lists(text, letter, 0,
                     "a mask is [c0,c1,...]/D@first, of two variables [[c00,c10,...],...]/D@first,first");
}

Mask parse_matrix_mask(std::string_view text, char letter) {
  Mask mask = parse_lists(text, letter, 2,
                          "a mask of matrices is [[[a,b],[c,d]],...]/D@first: for each variable a list, then the rows");
  mask.components = mask.sizes[0];
  require(mask.sizes[1] == mask.components, "a coefficient of a mask is no square matrix");
  mask.sizes.erase(mask.sizes.begin(), mask.sizes.begin() + 2);
  return mask;
}

void check_sum(const Mask& mask, unsigned arity) {
  for (std::size_t k = 0; k < mask.powers; ++k) {
    const auto begin = mask.coefficients.begin() + static_cast<std::ptrdiff_t>(k * mask.points()),
               end = begin + static_cast<std::ptrdiff_t>(mask.points());
    require(std::accumulate(begin, end, mpz_class(0)) == mask.denominator * arity * mask.divisor[k],
            "the coefficients of the mask do not sum to the arity");
  }
}

Family transition_family(const Mask& mask, unsigned arity, std::size_t sum_rules, std::size_t width) {
  const std::size_t points = mask.points();
  const mpz_class scale = power(arity, sum_rules).get_num();
  std::vector<Vector> divided;
  for (std::size_t p = 0; p < mask.powers; ++p) {
    Vector& b = divided.emplace_back(&mask.coefficients[p * points], &mask.coefficients[p * points] + points);
    for (std::size_t round = 0; round < sum_rules; ++round) {
      for (std::size_t i = b.size(); i-- > 1;) b[i] -= b[i - 1];            // times 1 - z
      for (std::size_t i = arity; i < b.size(); ++i) b[i] += b[i - arity];  // divided by 1 - z^arity
      for (unsigned i = 1; i < arity; ++i, b.pop_back())
        require(b.size() > 1 && b.back() == 0, "the mask has no sum rules of this order");
    }
    for (mpz_class& x : b) x *= scale;
  }
  const std::size_t size = std::max(width, (divided[0].size() + arity - 3) / (arity - 1));
  require(size <= 256, "transition matrices larger than 256");
  Vector entries;
  for (std::size_t t = 0; t < arity; ++t)
    for (const Vector& b : divided)
      for (std::size_t k = 0; k < size; ++k)
        for (std::size_t i = t; i < t + arity * size; i += arity)
          entries.push_back(i >= k && i - k < b.size() ? b[i - k] : mpz_class(0));
  return {size, entries, mask.denominator};
}

void check_interpolation(const Mask& mask, std::size_t data, unsigned arity) {
  const std::size_t square = mask.components * mask.components;
  for (std::size_t i = 0; i < mask.points(); ++i) {
    const mpz_class k = mask.first[0] + mpz_class(i / square);
    if (k % arity != 0) continue;
    const std::size_t row = i % square / mask.components, column = i % square % mask.components;
    for (std::size_t p = 0; p < mask.powers; ++p) {
      const mpz_class whole = k == 0 && row == column ? mpz_class(mask.denominator * mask.divisor[p]) : mpz_class(0);
      require(mask.coefficients[p * mask.points() + i] * power(arity, row % data).get_num() == whole,
              "the scheme does not interpolate");
    }
  }
}

void check_no_leading_factors(const Mask& mask, unsigned arity) {
  const Vector& a = mask.coefficients;
  std::size_t k = 0;
  for (const mpz_class& x : a) k = std::max(k, bits(x) + 64);
  mpz_class common = 0;
  for (unsigned r = 0; r < arity; ++r) common = gcd(common, value_at_power(a, r, arity, k));
  require(bits(common) < k, "stability: the polyphase parts may have a common zero");
}

namespace {

constexpr long kept_bits = 128;
constexpr std::size_t max_symbol_bits = 1UL << 28;

}  // namespace

mpq_class few_digits_up(const mpq_class& x) {
  const long shift = static_cast<long>(bits(x.get_num())) - static_cast<long>(bits(x.get_den())) - kept_bits;
  const mpz_class top = shift < 0 ? mpz_class(x.get_num() << -shift) : x.get_num(),
                  bottom = shift > 0 ? mpz_class(x.get_den() << shift) : x.get_den();
  mpz_class kept;
  mpz_cdiv_q(kept.get_mpz_t(), top.get_mpz_t(), bottom.get_mpz_t());
  return shift < 0 ? ratio(kept, mpz_class(1) << -shift) : mpq_class(mpz_class(kept << shift));
}

Rounding parse_rounding(std::string_view text) {
  constexpr const char* expected = "a rounding is EPS,M or EPS,M,symmetric with EPS > 0 and the number M of sum rules";
  const Fields fields = split(text, ",");
  require(fields.size() == 2 || (fields.size() == 3 && fields[2] == "symmetric"), expected);
  Rounding rounding{parse_rational(fields[0]), parse_size(fields[1], 1, 500), fields.size() == 3};
  require(rounding.distance > 0, expected);
  return rounding;
}

mpq_class entry_error(const Mask& mask, unsigned arity, const Rounding& rounding) {
  // (1 + z + ...) ((1 + z) / (1 - z^arity))^M
  Vector factors(mask.points(), 1);
  for (std::size_t round = 0; round < rounding.sum_rules; ++round) {
    for (std::size_t i = factors.size(); i-- > 1;) factors[i] += factors[i - 1];
    for (std::size_t i = arity; i < factors.size(); ++i) factors[i] += factors[i - arity];
  }
  return rounding.distance * power(arity, rounding.sum_rules) * *std::max_element(factors.begin(), factors.end());
}

mpq_class change_of_product(const mpq_class& norm, const mpq_class& error, std::size_t factors) {
  if (factors == 0) return 0;
  const mpq_class base = few_digits_up(norm + error);
  require((bits(base.get_num()) + bits(base.get_den())) * factors <= max_symbol_bits, too_much_work);
  return few_digits_up(few_digits_up(power(base, factors - 1)) * few_digits_up(error) * mpz_class(factors));
}

mpq_class largest_column_sum(const Family& family) {
  mpz_class largest = 0;
  for (std::size_t k = 0; k < family.count() * family.size; ++k) {
    mpz_class sum = 0;
    for (std::size_t i = 0; i < family.size; ++i) sum += abs(family.entries[k * family.size + i]);
    largest = std::max(largest, sum);
  }
  return ratio(largest, family.denominator);
}

mpq_class change_of(const Family& family, const mpq_class& entry_error, std::size_t level) {
  if (entry_error == 0) return 0;
  return change_of_product(largest_column_sum(family), entry_error * mpz_class(family.size), level);
}

}  // namespace subcert_check
