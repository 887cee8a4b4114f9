#include "arithmetic.hpp"

#include <algorithm>
#include <utility>

namespace subcert_check {
namespace {

constexpr std::size_t max_digits = 5000;            // of a number
constexpr std::size_t max_power_bits = 20'000'000;  // of a number times the power to which it is raised

}  // namespace

void require(bool condition, std::string_view why) {
  if (!condition) throw Rejected{std::string(why)};
}

std::size_t bits(const mpz_class& x) { return mpz_sizeinbase(x.get_mpz_t(), 2); }

mpq_class ratio(const mpz_class& top, const mpz_class& bottom) { return mpq_class(top) / mpq_class(bottom); }

mpz_class ceiling(const mpq_class& x) {
  mpz_class result;
  mpz_cdiv_q(result.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
  return result;
}

mpq_class power(const mpq_class& base, std::size_t exponent) {
  require((bits(base.get_num()) + bits(base.get_den())) * exponent <= max_power_bits, "power of a number too large");
  mpq_class result;
  mpz_pow_ui(result.get_num_mpz_t(), base.get_num_mpz_t(), exponent);
  mpz_pow_ui(result.get_den_mpz_t(), base.get_den_mpz_t(), exponent);
  return result;
}

mpq_class power_lower(unsigned base, const mpq_class& exponent) {
  constexpr std::size_t precision = 320, steps = 128;
  const mpz_class whole = exponent.get_num() / exponent.get_den(), one = mpz_class(1) << precision;
  mpq_class rest = exponent - whole;
  mpz_class result = one, root = base * one;
  for (std::size_t i = 0; i < steps && rest > 0; ++i) {  // base^(exponent - whole) >= result / one * (root / one)^rest
    root = sqrt(mpz_class(root * one));
    rest *= 2;
    if (rest < 1) continue;
    result = result * root >> precision;
    rest -= 1;
  }
  return power(base, whole.get_ui()) * ratio(result, one);
}

void Arithmetic::spend(std::uint64_t work) {
  spent_ += work;
  require(spent_ <= max_work, too_much_work);
}

void Arithmetic::add_product(mpz_class& sum, const mpz_class& x, const mpz_class& y) {
  spend(20 + std::uint64_t{mpz_size(x.get_mpz_t())} * mpz_size(y.get_mpz_t()));
  mpz_addmul(sum.get_mpz_t(), x.get_mpz_t(), y.get_mpz_t());
}

Vector Arithmetic::multiply(std::span<const mpz_class> matrix, const Vector& x, std::size_t size) {
  spend(100 * x.size());
  Vector result(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; x[i] != 0 && j < size; ++j)
      add_product(result[i - i % size + j], matrix[i % size * size + j], x[i]);
  return result;
}

mpz_class determinant(Vector matrix, std::size_t n, Arithmetic& arithmetic) {
  mpz_class last = 1;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    const auto at = [&](std::size_t i, std::size_t j) -> mpz_class& { return matrix[j * n + i]; };
    const mpz_class* column = &at(0, k);
    const mpz_class* nonzero = std::find_if(column + k, column + n, [](const mpz_class& x) { return x != 0; });
    const std::size_t pivot = static_cast<std::size_t>(nonzero - column);
    if (pivot == n) return 0;
    for (std::size_t j = k; pivot > k && j < n; ++j) {
      swap(at(pivot, j), at(k, j));
      at(k, j) = -at(k, j);
    }
    for (std::size_t i = k + 1; i < n; ++i)
      for (std::size_t j = k + 1; j < n; ++j) {
        mpz_class minor = 0;
        arithmetic.add_product(minor, at(k, k), at(i, j));
        arithmetic.add_product(minor, at(i, k), -at(k, j));
        arithmetic.spend(std::uint64_t{mpz_size(minor.get_mpz_t())} * mpz_size(last.get_mpz_t()));
        mpz_divexact(at(i, j).get_mpz_t(), minor.get_mpz_t(), last.get_mpz_t());
      }
    last = at(k, k);
  }
  return matrix.back();
}

Fields split(std::string_view text, std::string_view separator) {
  Fields parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + separator.size();
  }
}

mpz_class parse_integer(std::string_view text) {
  const std::string_view digits = text.substr(text.starts_with('-') ? 1 : 0);
  const bool decimal = !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
  require(decimal && (digits.front() != '0' || text == "0"), "not an integer");
  require(digits.size() <= max_digits, "number too long");
  return mpz_class(std::string(text), 10);
}

std::size_t parse_size(std::string_view text, std::size_t low, std::size_t high) {
  const mpz_class value = parse_integer(text);
  require(value >= low && value <= high, "number outside " + std::to_string(low) + ".." + std::to_string(high));
  return value.get_ui();
}

mpq_class parse_rational(std::string_view text) {
  const Fields parts = split(text, "/");
  require(parts.size() <= 2, "not a rational");
  const mpz_class denominator = parts.size() == 2 ? parse_integer(parts[1]) : mpz_class(1);
  require(denominator > 0, "a denominator must be positive");
  return ratio(parse_integer(parts[0]), denominator);
}

bool Reader::at_end() {
  if (std::exchange(taken_, false)) {
    ++line_;
    require(!std::getline(input_, text_) || !input_.eof(), "last line without line feed");
    require(text_.size() <= max_line, "line too long");
  }
  return !input_;
}

Fields Reader::take(const std::string& head, std::size_t low, std::size_t high) {
  require(at(head), "expected '" + head + "'");
  taken_ = true;
  Fields fields = split(std::string_view(text_).substr(head.size()), " ");
  fields.erase(fields.begin());  // what is before the first space: nothing
  require(fields.size() >= low && fields.size() <= high, "wrong number of fields");
  return fields;
}

}  // namespace subcert_check
