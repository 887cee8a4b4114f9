// The whole of subcert-check. Section numbers refer to ../certificates/SPEC.md, which proves each step.
// Everything is exact integer arithmetic; the only rounding is outward, in square roots and logarithms.
#include "check.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace subcert_check {
namespace {

using Vector = std::vector<mpz_class>;
using Rationals = std::vector<mpq_class>;
using Fields = std::vector<std::string_view>;

constexpr std::size_t max_bytes = 1UL << 28;          // of a file
constexpr std::size_t max_digits = 2000;              // of a number
constexpr std::size_t max_denominator_bits = 10'000;  // of the common denominator of a mask or a family
constexpr std::size_t max_family_bits = 1UL << 32;    // of that denominator times the number of entries
constexpr std::size_t max_power_bits = 20'000'000;    // of a number times the power to which it is raised
constexpr std::uint64_t max_work = 10'000'000'000;    // all in all: about ten seconds

/// The reason, and the exit code: 1 the certificate does not prove the claim, 64 wrong arguments, 65 malformed
/// matrices, 66 a missing file.
struct Rejected {
  std::string why;
  int code = 64;
};

void require(bool condition, const std::string& why) {
  if (!condition) throw Rejected{why};
}

// ---- numbers ---------------------------------------------------------------------------------------------------

std::size_t bits(const mpz_class& x) { return mpz_sizeinbase(x.get_mpz_t(), 2); }

mpq_class ratio(const mpz_class& numerator, const mpz_class& denominator) {
  mpq_class result(numerator, denominator);
  result.canonicalize();
  return result;
}

mpq_class power(const mpq_class& base, std::size_t exponent) {
  require((bits(base.get_num()) + bits(base.get_den())) * exponent <= max_power_bits, "power of a number too large");
  mpq_class result;
  mpz_pow_ui(result.get_num_mpz_t(), base.get_num_mpz_t(), exponent);
  mpz_pow_ui(result.get_den_mpz_t(), base.get_den_mpz_t(), exponent);
  return result;
}

/// A lower bound of base^exponent, exponent >= 0: exact for integers, otherwise smaller by a factor above 1 - 2^-120.
mpq_class power_lower(unsigned base, const mpq_class& exponent) {
  constexpr std::size_t precision = 320, steps = 128;
  const mpz_class whole = exponent.get_num() / exponent.get_den(), one = mpz_class(1) << precision;
  require(exponent >= 0 && whole <= 10000, "an exponent is negative or too large");
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

/// Sums of products; counts the work.
class Arithmetic {
 public:
  void add_product(mpz_class& sum, const mpz_class& x, const mpz_class& y) {
    spend(20 + std::uint64_t{mpz_size(x.get_mpz_t())} * mpz_size(y.get_mpz_t()));
    mpz_addmul(sum.get_mpz_t(), x.get_mpz_t(), y.get_mpz_t());
  }
  /// matrix * x. Matrices are stored column by column; x may be several columns, one after another.
  Vector multiply(const Vector& matrix, const Vector& x, std::size_t size) {
    spend(100 * x.size());
    Vector result(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = 0; j < size; ++j) add_product(result[i - i % size + j], matrix[i % size * size + j], x[i]);
    return result;
  }
  /// Coefficients of det(z - matrix), highest power first, by the method of Faddeev and LeVerrier.
  Vector characteristic_polynomial(const Vector& matrix, std::size_t size) {
    Vector p{1}, m(size * size);
    for (std::size_t k = 1; k <= size; ++k) {
      mpz_class trace = 0;
      for (std::size_t i = 0; i < size; ++i) m[i * size + i] += p.back();
      m = multiply(matrix, m, size);
      for (std::size_t i = 0; i < size; ++i) trace += m[i * size + i];
      p.emplace_back(-trace / k);
    }
    return p;
  }

 private:
  void spend(std::uint64_t work) {
    spent_ += work;
    require(spent_ <= max_work, "more work than the checker allows");
  }
  std::uint64_t spent_ = 0;
};

// ---- text ------------------------------------------------------------------------------------------------------

Fields split(std::string_view text, char separator) {
  Fields parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

mpz_class parse_integer(std::string_view text) {
  const std::string_view digits = text.substr(text.starts_with('-') ? 1 : 0);
  const bool decimal = !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
  require(decimal && (digits.front() != '0' || text == "0"), "not an integer");
  require(digits.size() <= max_digits, "number too long");
  return mpz_class(std::string(text), 10);
}

/// `count` integers between commas.
Vector parse_integers(std::string_view text, std::size_t count) {
  Vector values;
  for (const std::string_view part : split(text, ',')) values.push_back(parse_integer(part));
  require(values.size() == count, "wrong number of parts");
  return values;
}

std::size_t parse_size(std::string_view text, std::size_t low, std::size_t high) {
  const mpz_class value = parse_integer(text);
  require(value >= low && value <= high, "number outside " + std::to_string(low) + ".." + std::to_string(high));
  return value.get_ui();
}

mpq_class parse_rational(std::string_view text) {
  const Fields parts = split(text, '/');
  require(parts.size() <= 2, "not a rational");
  const mpz_class denominator = parts.size() == 2 ? parse_integer(parts[1]) : mpz_class(1);
  require(denominator > 0, "a denominator must be positive");
  return ratio(parse_integer(parts[0]), denominator);
}

/// The coefficients of a mask [c0,c1,...]/D@first. Nothing that is proved depends on `first`.
Rationals parse_mask(std::string_view text) {
  const Fields halves = split(text, ']'), tail = split(halves.back(), '@');
  require(
      halves.size() == 2 && text.starts_with('[') && (tail[0].empty() || tail[0].starts_with('/')) && tail.size() <= 2,
      "a mask is [c0,c1,...]/D@first");
  const mpq_class scale = parse_rational("1" + std::string(tail[0]));
  if (tail.size() == 2) parse_integer(tail[1]);
  Rationals mask;
  for (const std::string_view c : split(halves[0].substr(1), ',')) mask.push_back(parse_rational(c) * scale);
  require(mask.size() <= 1000 && mask.front() != 0 && mask.back() != 0,
          "a mask has 1 to 1000 coefficients, the first and the last not zero");
  return mask;
}

/// A file line by line. A line starts with its head, `image 3 0` for instance, and goes on with fields.
class Reader {
 public:
  explicit Reader(const std::string& file) : input_(file, std::ios::binary) {}

  std::size_t line() const { return line_; }
  /// Whether the next line has this head. All lines have the empty one; after the last line there is none.
  bool at(const std::string& head) {
    load();
    return head.empty() ? !text_.empty() : text_ == head || text_.starts_with(head + " ");
  }
  /// Takes the next line, which must have the head and `low` to `high` fields; they are valid until the next call.
  Fields take(const std::string& head, std::size_t low, std::size_t high) {
    require(at(head), "expected '" + head + "'");
    taken_ = true;
    const std::string_view rest = std::string_view(text_).substr(head.size());
    const Fields fields = rest.empty() ? Fields{} : split(rest.substr(head.empty() ? 0 : 1), ' ');
    require(fields.size() >= low && fields.size() <= high, "wrong number of fields");
    return fields;
  }

 private:
  void load() {
    if (!std::exchange(taken_, false)) return;
    ++line_;
    if (!std::getline(input_, text_)) return;
    require(!input_.eof(), "last line without line feed");
    require(std::all_of(text_.begin(), text_.end(), [](char c) { return c >= ' ' && c <= '~'; }), "bad character");
    require(!text_.empty() && text_.front() != ' ' && text_.back() != ' ' && text_.find("  ") == std::string::npos,
            "empty line or misplaced space");
  }

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

// ---- families and masks ----------------------------------------------------------------------------------------

/// Square matrices of one size: entry (j,k) of matrix t is matrices[t][k * size + j] / denominator, denominator > 0.
struct Family {
  std::size_t size = 0;
  mpz_class denominator = 1;
  std::vector<Vector> matrices;
};

/// The values times their common denominator, and that.
std::pair<Vector, mpz_class> clear_denominators(const Rationals& values) {
  mpz_class denominator = 1;
  for (const mpq_class& x : values) {
    denominator = lcm(denominator, x.get_den());
    require(bits(denominator) <= max_denominator_bits, "common denominator too large");
  }
  require(values.size() * bits(denominator) <= max_family_bits, "matrices too large");
  Vector cleared;
  for (const mpq_class& x : values) cleared.emplace_back(x.get_num() * (denominator / x.get_den()));
  return {cleared, denominator};
}

/// Reads matrices, each after a line with its title unless that is empty, row by row, each row after the head.
Family read_family(Reader& reader, std::size_t size, const std::vector<std::string>& titles, const std::string& head) {
  Rationals rows;
  for (const std::string& title : titles) {
    if (!title.empty()) reader.take(title, 0, 0);
    for (std::size_t j = 0; j < size; ++j)
      for (const std::string_view field : reader.take(head, size, size)) rows.push_back(parse_rational(field));
  }
  const auto [entries, denominator] = clear_denominators(rows);
  Family family{size, denominator, std::vector<Vector>(titles.size(), Vector(size * size))};
  for (std::size_t i = 0; i < entries.size(); ++i)
    family.matrices[i / (size * size)][i % size * size + i / size % size] = entries[i];
  return family;
}

Family read_matrices(Reader& reader) {
  const Fields fields = reader.take("matrices", 2, 2);
  const std::size_t count = parse_size(fields[0], 1, 64), size = parse_size(fields[1], 1, 256);
  const Family family = read_family(reader, size, std::vector<std::string>(count), "");
  require(!reader.at(""), "text after the last row");
  return family;
}

/// The family of section 4.1: divides `b` by sigma, `sum_rules` times.
Family transition_family(Vector b, const mpz_class& denominator, unsigned arity, std::size_t sum_rules) {
  for (std::size_t round = 0; round < sum_rules; ++round) {
    for (std::size_t i = b.size(); i-- > 1;) b[i] -= b[i - 1];            // times 1 - z
    for (std::size_t i = arity; i < b.size(); ++i) b[i] += b[i - arity];  // divided by 1 - z^arity
    for (unsigned i = 1; i < arity; ++i, b.pop_back())
      require(b.size() > 1 && b.back() == 0, "the mask has no sum rules of this order");
  }
  const mpz_class scale = power(arity, sum_rules).get_num();
  for (mpz_class& x : b) x *= scale;
  const std::size_t size = std::max<std::size_t>(1, (b.size() + arity - 3) / (arity - 1));
  require(size <= 256, "transition matrices larger than 256");
  Family family{size, denominator, std::vector<Vector>(arity, Vector(size * size))};
  for (std::size_t t = 0; t < arity; ++t)
    for (std::size_t j = 0; j < size; ++j)
      for (std::size_t k = 0; k < size; ++k)
        if (const std::size_t i = arity * j + t; i >= k && i - k < b.size())
          family.matrices[t][k * size + j] = b[i - k];
  return family;
}

/// The sum of a[start + i * step] * 2^(k * i).
mpz_class value_at_power(const Vector& a, std::size_t start, std::size_t step, std::size_t k) {
  mpz_class value = 0;
  for (std::size_t i = a.size(); i-- > 0;)
    if (i % step == start) value = (value << k) + a[i];
  return value;
}

/// Phi_n(2^k): for a prime q, Phi_{mq}(z) is Phi_m(z^q) if q divides m, otherwise Phi_m(z^q) / Phi_m(z).
mpz_class cyclotomic_at_power(std::size_t n, std::size_t k) {
  if (n == 1) return (mpz_class(1) << k) - 1;
  std::size_t q = 2;
  while (n % q != 0) ++q;
  const std::size_t m = n / q;
  const mpz_class value = cyclotomic_at_power(m, k * q);
  return m % q == 0 ? value : mpz_class(value / cyclotomic_at_power(m, k));
}

/// Conditions (i) and (ii) of Theorem 4 for the mask `a`, its denominators cleared.
void check_stability(const Vector& a, unsigned arity) {
  std::size_t k = 0;
  for (const mpz_class& x : a) k = std::max(k, bits(x) + 64);
  mpz_class common = 0;
  for (unsigned r = 0; r < arity; ++r) common = gcd(common, value_at_power(a, r, arity, k));
  require(bits(common) < k, "stability: the polyphase parts may have a common zero");
  const mpz_class symbol = value_at_power(a, 0, 1, 64);
  for (std::size_t n = 2 * arity; n < 6 * a.size(); n += arity)
    if (std::gcd(n / arity, std::size_t{arity}) == 1)
      require(symbol % cyclotomic_at_power(n, 64) != 0, "stability: Phi_" + std::to_string(n) + " may divide a");
}

// ---- the certificate -------------------------------------------------------------------------------------------

/// What is to be proved: about the exponent of a mask if `arity` is not 0, otherwise about the radius of a family.
struct Claim {
  unsigned arity = 0;
  Rationals mask;
  Family family;
  std::optional<mpq_class> lower, upper;
  std::string head, text;  // of the line for it in certificates, and to be printed
};

class Checker {
 public:
  Checker(const Claim& claim, Reader& reader)
      : claim_(claim), reader_(reader), lower_(claim.lower), upper_(claim.upper) {}

  /// Returns if the certificate proves the claim.
  void run() {
    reader_.take("subcert-certificate 1", 0, 0);
    const bool exponent = claim_.arity != 0;
    require(reader_.at(claim_.head), "certificate for another scheme or family");
    reader_.take(claim_.head, 0, 0);
    reader_.take("bounds", 2, 2);
    const Family family = exponent ? read_scheme() : claim_.family;
    const bool divided = reader_.at("blocks");
    const std::vector<Family> blocks = divided ? read_blocks(family) : std::vector{family};
    const bool product = reader_.at("product");
    require(product || !lower_, "the claim needs a 'product' line");
    if (product) read_product(blocks);
    const bool sections = reader_.at("block 0");
    require(sections || !upper_, "the claim needs a norm or a polytope");
    for (std::size_t i = 0; sections && i < blocks.size(); ++i) {
      const Fields fields = reader_.take("block " + std::to_string(i), 2, 7);
      if (fields[0] == "norm")
        read_norm(blocks[i], fields, exponent && !divided ? 1 : blocks[i].size);
      else
        read_polytope(blocks[i], fields);
    }
    reader_.take("end", 0, 0);
    require(!reader_.at(""), "text after 'end'");
  }

 private:
  /// The transition matrices of the mask of the claim, and what is to be shown of them.
  Family read_scheme() {
    require(*claim_.lower > 0, "the lower end of an exponent must be positive");
    const std::size_t sum_rules = parse_size(reader_.take("sum-rules", 1, 1)[0], 1, 500);
    const auto [mask, denominator] = clear_denominators(claim_.mask);
    require(std::accumulate(mask.begin(), mask.end(), mpz_class(0)) == denominator * claim_.arity,
            "the coefficients of the mask do not sum to the arity");
    upper_ = power_lower(claim_.arity, sum_rules - *claim_.lower);
    lower_.reset();
    if (claim_.upper) lower_ = power(claim_.arity, sum_rules) / power_lower(claim_.arity, *claim_.upper);
    if (reader_.at("stability")) {
      reader_.take("stability", 0, 0);
      check_stability(mask, claim_.arity);
    } else {
      require(!lower_, "the upper end needs a 'stability' line");
    }
    return transition_family(mask, denominator, claim_.arity, sum_rules);
  }

  /// Section 4.4: the diagonal blocks.
  std::vector<Family> read_blocks(const Family& family) {
    const std::size_t n = family.size, count = family.matrices.size();
    std::vector<std::size_t> sizes;
    for (const std::string_view field : reader_.take("blocks", 1, n)) sizes.push_back(parse_size(field, 1, n));
    require(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}) == n, "the block sizes do not sum to n");
    const Vector basis = read_family(reader_, n, {"basis"}, "row").matrices[0];
    require(arithmetic_.characteristic_polynomial(basis, n).back() != 0, "the determinant of the basis is 0");
    std::vector<std::string> titles;
    for (std::size_t t = 0; t < count; ++t) titles.push_back("triangular " + std::to_string(t));
    const Family triangular = read_family(reader_, n, titles, "row");
    for (std::size_t t = 0; t < count; ++t) {
      const Vector left = arithmetic_.multiply(family.matrices[t], basis, n);
      const Vector right = arithmetic_.multiply(basis, triangular.matrices[t], n);
      for (std::size_t i = 0; i < n * n; ++i)
        require(left[i] * triangular.denominator == right[i] * family.denominator, "T B = B M does not hold");
    }
    std::vector<Family> blocks;
    std::size_t start = 0;
    for (const std::size_t size : sizes) {
      blocks.push_back({size, triangular.denominator, std::vector<Vector>(count)});
      for (std::size_t t = 0; t < count; ++t)
        for (std::size_t k = start; k < start + size; ++k)
          for (std::size_t j = start; j < n; ++j) {
            const mpz_class& entry = triangular.matrices[t][k * n + j];
            require(j < start + size || entry == 0, "not block upper triangular");
            if (j < start + size) blocks.back().matrices[t].push_back(entry);
          }
      start += size;
    }
    return blocks;
  }

  /// Section 4.5: a lower bound of the radius.
  void read_product(const std::vector<Family>& blocks) {
    const Fields fields = reader_.take("product", 4, 3 + 4096);
    const Family& family = blocks[parse_size(fields[0], 0, blocks.size() - 1)];
    const mpq_class re = parse_rational(fields[1]), im = parse_rational(fields[2]);
    const std::size_t n = family.size, length = fields.size() - 3;
    // `scale` times the product is an integer matrix; c = x + i y is `scale` times the given eigenvalue.
    const mpz_class q = lcm(re.get_den(), im.get_den());
    const mpz_class scale = power(family.denominator, length).get_num() * q;
    const mpz_class x = mpq_class(re * scale).get_num(), y = mpq_class(im * scale).get_num();
    Vector product(n * n);
    for (std::size_t i = 0; i < n; ++i) product[i * n + i] = q;
    for (std::size_t i = 3; i < fields.size(); ++i)
      product = arithmetic_.multiply(product, family.matrices[parse_size(fields[i], 0, family.matrices.size() - 1)], n);
    const Vector times_c{x, y, -y, x};
    Vector value(2), slope(2);  // of the characteristic polynomial and its derivative at c: real and imaginary part
    for (const mpz_class& coefficient : arithmetic_.characteristic_polynomial(product, n)) {
      slope = arithmetic_.multiply(times_c, slope, 2);
      for (std::size_t part = 0; part < 2; ++part) slope[part] += value[part];
      value = arithmetic_.multiply(times_c, value, 2);
      value[0] += coefficient;
    }
    const auto square = [](const mpz_class& a, const mpz_class& b) { return mpz_class(a * a + b * b); };
    const mpz_class values = square(value[0], value[1]) * n * n, slopes = square(slope[0], slope[1]);
    require(slopes != 0, "the characteristic polynomial has derivative 0 at the given eigenvalue");
    const mpz_class modulus = sqrt(mpz_class(square(x, y) << 640)),
                    distance = sqrt(mpz_class((values << 640) / slopes));
    const mpz_class bound = modulus - distance - (values == 0 ? 0 : 1);
    require(bound > 0, "the product proves no positive spectral radius");
    const mpq_class radius = ratio(bound, scale << 320);  // JSR^length is at least that
    require(!lower_ || claim_.arity == 0 || radius > 1, "the product must have a spectral radius above 1");
    require(!lower_ || *lower_ <= 0 || radius >= power(*lower_, length),
            "the product's spectral radius does not prove the claim");
  }

  /// Section 4.6, with the first columns of the products.
  void read_norm(const Family& family, const Fields& fields, std::size_t columns) {
    require(fields.size() == 2, "wrong number of fields after 'norm'");
    const std::size_t level = parse_size(fields[1], 1, 64), work = 20 * columns * family.size * family.size;
    require(power(family.matrices.size(), level) * work <= max_work, "more work than the checker allows");
    mpz_class most = 0;
    for (std::size_t k = 0; k < columns; ++k) {
      Vector unit(family.size);
      unit[k] = 1;
      most = std::max(most, largest_norm(family, unit, level));
    }
    use_upper_bound(ratio(most, power(family.denominator, level).get_num()), level);
  }

  /// The largest 1-norm of product * x over all products of this many matrices.
  mpz_class largest_norm(const Family& family, const Vector& x, std::size_t level) {
    mpz_class largest = 0;
    if (level == 0)
      for (const mpz_class& value : x) largest += abs(value);
    else
      for (const Vector& matrix : family.matrices)
        largest = std::max(largest, largest_norm(family, arithmetic_.multiply(matrix, x, family.size), level - 1));
    return largest;
  }

  /// Vertices hold the real parts of their coordinates, then, if complex, the imaginary ones: `parts` is 1 or 2.
  struct Polytope {
    std::size_t size, parts;
    bool nonnegative, symmetric;
    std::vector<Vector> vertices;
  };

  /// Section 4.7.
  void read_polytope(Family family, const Fields& fields) {
    const std::size_t n = family.size, count = family.matrices.size();
    require(fields[0] == "polytope" && fields.size() >= 5, "expected 'norm' or 'polytope' and its numbers");
    const bool symmetric = fields.size() > 5 && fields[5] == "symmetric", transposed = fields.back() == "transposed";
    require(fields.size() == 5U + symmetric + transposed, "unknown polytope property");
    Polytope body{n, fields[1] == "complex" ? 2U : 1U, fields[1] == "nonnegative", symmetric, {}};
    require(body.parts == 2 || body.nonnegative || fields[1] == "real", "unknown polytope mode");
    const std::size_t vertices = parse_size(fields[2], 1, max_bytes);
    const std::size_t vertex_bits = parse_size(fields[3], 0, 4096), weight_bits = parse_size(fields[4], 0, 4096);
    for (std::size_t t = 0; t < count; ++t)
      for (std::size_t i = 0; i < n * n; ++i) {
        const mpz_class& entry = family.matrices[t][i];
        require(!symmetric || entry == family.matrices[count - 1 - t][n * n - 1 - i], "the family is not symmetric");
        require(!body.nonnegative || entry >= 0, "a matrix is not non-negative");
      }
    for (Vector& matrix : family.matrices)
      for (std::size_t j = 0; transposed && j < n; ++j)
        for (std::size_t k = 0; k < j; ++k) std::swap(matrix[j * n + k], matrix[k * n + j]);

    for (std::size_t i = 0; i < vertices; ++i) {
      Vector& vertex = body.vertices.emplace_back(body.parts * n);
      const Fields coordinates = reader_.take("vertex", n, n);
      for (std::size_t k = 0; k < n; ++k) {
        const Vector coordinate = parse_integers(coordinates[k], body.parts);
        for (std::size_t part = 0; part < body.parts; ++part) vertex[part * n + k] = coordinate[part];
        require(!body.nonnegative || vertex[k] >= 0, "negative coordinate");
      }
    }
    const mpz_class weight_one = mpz_class(1) << weight_bits, one = weight_one << vertex_bits;
    mpz_class most_residual = 0, most_weights = 0;  // R and S of Theorem 6, over `one` and over `weight_one`
    for (std::size_t k = 0; k < (symmetric ? (n + 1) / 2 : n); ++k) {
      Vector unit(body.parts * n);
      unit[k] = 1;
      const auto [weights, residual] = read_combination("unit " + std::to_string(k), body, unit, one, 1);
      most_residual = std::max(most_residual, residual);
      most_weights = std::max(most_weights, weights);
    }
    require(most_residual < one, "the vertices do not span: a unit's residual is 1 or more");
    const mpz_class unit_norm = (most_weights << vertex_bits) / (one - most_residual) + 1;  // at least E
    mpz_class bound = 0;                                                                    // over `one` * denominator
    for (std::size_t j = 0; j < vertices; ++j)
      for (std::size_t t = 0; t < count; ++t) {
        const Vector image = arithmetic_.multiply(family.matrices[t], body.vertices[j], n);
        const std::string head = "image " + std::to_string(j) + " " + std::to_string(t);
        const auto [weights, residual] = read_combination(head, body, image, weight_one, family.denominator);
        bound = std::max(bound, mpz_class((weights * family.denominator << vertex_bits) + residual * unit_norm));
      }
    use_upper_bound(ratio(bound, one * family.denominator), 1);
  }

  /// Reads a line of terms. Returns the sum of their weights in absolute value, and the residual: the norm of
  /// `target` * `target_scale` - (sum of the terms) * `sum_scale`.
  std::pair<mpz_class, mpz_class> read_combination(const std::string& head, const Polytope& body, const Vector& target,
                                                   const mpz_class& target_scale, const mpz_class& sum_scale) {
    const bool complex = body.parts == 2;
    mpz_class weights = 0, residual = 0;
    Vector sum(target.size());
    for (const std::string_view term : reader_.take(head, 0, max_bytes)) {
      const Fields halves = split(term, ':');
      require(halves.size() == 2, "a term is INDEX:WEIGHT");
      std::string_view index = halves[0];
      const bool conjugate = complex && index.ends_with('c');
      if (conjugate) index.remove_suffix(1);
      const bool flipped = body.symmetric && index.ends_with('f');
      if (flipped) index.remove_suffix(1);
      const Vector& vertex = body.vertices[parse_size(index, 0, body.vertices.size() - 1)];
      const Vector parts = parse_integers(halves[1], complex ? 3 : 1);
      const mpz_class re = parts[0], im = complex ? parts[1] : mpz_class(0), modulus = complex ? parts[2] : abs(re);
      require(!body.nonnegative || re >= 0, "negative weight");
      require(modulus >= 0 && modulus * modulus >= re * re + im * im, "a weight's modulus is too small");
      weights += modulus;
      // (Re, Im) of the term are this matrix times (Re, Im) of the vertex; only the first entry counts if not complex
      const Vector factor{re, im, conjugate ? im : -im, conjugate ? -re : re};
      for (std::size_t k = 0; k < body.size; ++k)
        for (std::size_t i = 0; i < body.parts * body.parts; ++i)
          arithmetic_.add_product(sum[i % body.parts * body.size + k], factor[i],
                                  vertex[i / body.parts * body.size + (flipped ? body.size - 1 - k : k)]);
    }
    for (std::size_t i = 0; i < target.size(); ++i) {
      mpz_class part = 0;
      arithmetic_.add_product(part, target[i], target_scale);
      arithmetic_.add_product(part, sum[i], -sum_scale);
      if (part > 0 || !body.nonnegative) residual += abs(part);
    }
    return {weights, residual};
  }

  /// Compares the proved JSR(block)^exponent <= value with what is to be shown of each block.
  void use_upper_bound(const mpq_class& value, std::size_t exponent) const {
    require(!upper_ || (*upper_ >= 0 && value <= power(*upper_, exponent)), "the bound does not prove the claim");
  }

  const Claim& claim_;
  Reader& reader_;
  Arithmetic arithmetic_;
  std::optional<mpq_class> lower_, upper_;  // what is to be shown of the joint spectral radius
};

// ---- the command line ------------------------------------------------------------------------------------------

constexpr const char* usage =
    "usage: subcert-check --mask '[c0,c1,...]/D@first' --arity A --lower P/Q [--upper P/Q] FILE\n"
    "       subcert-check --matrices MATRICES [--lower P/Q] [--upper P/Q] FILE    (at least one bound)\n"
    "prints VERIFIED <claim> (exit 0) or REJECTED <why, line n> (exit 1)\n"
    "exit 64: wrong usage, 65: malformed MATRICES, 66: missing file";

Claim read_claim(const std::vector<std::string>& arguments, std::string& file) {
  static const std::set<std::string> known{"--mask", "--arity", "--matrices", "--lower", "--upper", "FILE"};
  Claim claim;
  std::string subject;
  std::set<std::string> given;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string name = arguments[i].starts_with("--") ? arguments[i++] : "FILE";
    require(known.contains(name), "unknown option " + name);
    require(i < arguments.size() && given.insert(name).second, name + " needs a value, and only one");
    if (name == "--mask") claim.mask = parse_mask(arguments[i]);
    if (name == "--arity") claim.arity = static_cast<unsigned>(parse_size(arguments[i], 2, 16));
    if (name == "--lower") claim.lower = parse_rational(arguments[i]);
    if (name == "--upper") claim.upper = parse_rational(arguments[i]);
    if (name == "--mask" || name == "--matrices") subject = arguments[i];
    if (name == "FILE") file = arguments[i];
  }
  const bool exponent = given.contains("--mask");
  require(given.contains("FILE") && exponent != given.contains("--matrices") && exponent == given.contains("--arity") &&
              (claim.lower || (claim.upper && !exponent)),
          usage);
  if (!exponent) read(subject, 65, [&](Reader& reader) { claim.family = read_matrices(reader); });
  const std::string arity = std::to_string(claim.arity), count = std::to_string(claim.family.matrices.size());
  claim.head = exponent ? "exponent " + subject + " " + arity
                        : "radius " + count + " " + std::to_string(claim.family.size);
  claim.text = (claim.lower ? claim.lower->get_str() + " <= " : "") +
               (exponent ? "Hoelder exponent" : "joint spectral radius") +
               (claim.upper ? " <= " + claim.upper->get_str() : "") + " of " + subject +
               (exponent ? " with arity " + arity : "");
  return claim;
}

}  // namespace

int run(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& errors) {
  try {
    if (arguments == std::vector<std::string>{"--help"}) {
      out << usage << std::endl;
      return 0;
    }
    std::string file;
    const Claim claim = read_claim(arguments, file);
    read(file, 1, [&](Reader& reader) { Checker(claim, reader).run(); });
    out << "VERIFIED " << claim.text << std::endl;
    return out ? 0 : 1;
  } catch (const Rejected& rejected) {
    (rejected.code == 1 ? out << "REJECTED " : errors << "subcert-check: ") << rejected.why << std::endl;
    return rejected.code;
  } catch (const std::exception& error) {
    out << "REJECTED " << error.what() << ", line 0" << std::endl;
    return 1;
  }
}

}  // namespace subcert_check
