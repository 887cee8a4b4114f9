// Exact numbers, the work they cost, and text: what the rest of subcert-check is made of. Everything is integer
// arithmetic; the only rounding is outward, in square roots and logarithms.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace subcert_check {

using Vector = std::vector<mpz_class>;
using Rationals = std::vector<mpq_class>;
using Fields = std::vector<std::string_view>;

constexpr std::size_t max_bytes = 1UL << 28;        // of a file
constexpr std::size_t max_line = 1UL << 24;         // characters
constexpr std::uint64_t max_work = 10'000'000'000;  // all in all: about ten seconds
constexpr const char* too_much_work = "more work than the checker allows";

/// The reason, and the exit code: 1 the certificate does not prove the claim, 64 wrong arguments, 65 malformed
/// matrices, 66 a missing file.
struct Rejected {
  std::string why;
  int code = 64;
};

void require(bool condition, std::string_view why);

// ---- numbers ---------------------------------------------------------------------------------------------------

std::size_t bits(const mpz_class& x);
mpq_class ratio(const mpz_class& top, const mpz_class& bottom);
mpz_class ceiling(const mpq_class& x);
mpq_class power(const mpq_class& base, std::size_t exponent);
/// A lower bound of base^exponent, exponent >= 0: exact for integers, otherwise smaller by a factor above 1 - 2^-120.
mpq_class power_lower(unsigned base, const mpq_class& exponent);

/// Sums of products; counts the work.
class Arithmetic {
 public:
  void spend(std::uint64_t work);
  void add_product(mpz_class& sum, const mpz_class& x, const mpz_class& y);
  /// matrix * x. Matrices are stored column by column; x may be several columns, one after another.
  Vector multiply(std::span<const mpz_class> matrix, const Vector& x, std::size_t size);

 private:
  std::uint64_t spent_ = 0;
};

/// By exact elimination [Bareiss 1968]; the matrix column by column.
mpz_class determinant(Vector matrix, std::size_t n, Arithmetic& arithmetic);

// ---- text ------------------------------------------------------------------------------------------------------

Fields split(std::string_view text, std::string_view separator);
mpz_class parse_integer(std::string_view text);
std::size_t parse_size(std::string_view text, std::size_t low, std::size_t high);
mpq_class parse_rational(std::string_view text);

/// A file line by line. A line is its head, `image 3 0` for instance, and fields, each after one space.
class Reader {
 public:
  explicit Reader(const std::string& file) : input_(file, std::ios::binary) {}

  std::size_t line() const { return line_; }
  bool at_end();
  bool at(const std::string& head) { return !at_end() && (text_ == head || text_.starts_with(head + " ")); }
  /// Takes the next line, which must have the head and `low` to `high` fields; they are valid until the next call.
  Fields take(const std::string& head, std::size_t low, std::size_t high);

 private:
  std::ifstream input_;
  std::string text_;
  std::size_t line_ = 0;
  bool taken_ = true;
};

/// use(reader) of the file. What is rejected gets the code and the number of the line.
template <class Use>
void read(const std::string& file, int code, Use use) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error) || !std::ifstream(file)) throw Rejected{"cannot read " + file, 66};
  Reader reader(file);
  try {
    require(std::filesystem::file_size(file) <= max_bytes, "file too long");
    use(reader);
  } catch (const Rejected& rejected) {
    throw Rejected{rejected.why + ", line " + std::to_string(reader.line()), code};
  }
}

}  // namespace subcert_check
