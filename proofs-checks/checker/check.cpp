// The whole of subcert-check. Section numbers refer to ../certificates/SPEC.md, which proves each step.
// Everything is exact integer arithmetic; the only rounding is outward, in square roots and logarithms.
#include "check.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <utility>

namespace subcert_check {
namespace {

using Vector = std::vector<mpz_class>;
using Rationals = std::vector<mpq_class>;
using Fields = std::vector<std::string_view>;

constexpr std::size_t max_bytes = 1UL << 28;          // of a file
constexpr std::size_t max_line = 1UL << 24;           // characters
constexpr std::size_t max_digits = 2000;              // of a number
constexpr std::size_t max_denominator_bits = 10'000;  // of the common denominator of a mask or a family
constexpr std::size_t max_family_bits = 1UL << 32;    // of that denominator times the number of entries
constexpr std::size_t max_power_bits = 20'000'000;    // of a number times the power to which it is raised
constexpr std::uint64_t max_work = 10'000'000'000;    // all in all: about ten seconds
constexpr const char* too_much_work = "more work than the checker allows";

/// The reason, and the exit code: 1 the certificate does not prove the claim, 64 wrong arguments, 65 malformed
/// matrices, 66 a missing file.
struct Rejected {
  std::string why;
  int code = 64;
};

void require(bool condition, std::string_view why) {
  if (!condition) throw Rejected{std::string(why)};
}

// ---- numbers ---------------------------------------------------------------------------------------------------

std::size_t bits(const mpz_class& x) { return mpz_sizeinbase(x.get_mpz_t(), 2); }

mpq_class ratio(const mpz_class& top, const mpz_class& bottom) { return mpq_class(top) / mpq_class(bottom); }

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
  void spend(std::uint64_t work) {
    spent_ += work;
    require(spent_ <= max_work, too_much_work);
  }
  void add_product(mpz_class& sum, const mpz_class& x, const mpz_class& y) {
    spend(20 + std::uint64_t{mpz_size(x.get_mpz_t())} * mpz_size(y.get_mpz_t()));
    mpz_addmul(sum.get_mpz_t(), x.get_mpz_t(), y.get_mpz_t());
  }
  /// matrix * x. Matrices are stored column by column; x may be several columns, one after another.
  Vector multiply(std::span<const mpz_class> matrix, const Vector& x, std::size_t size) {
    spend(100 * x.size());
    Vector result(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = 0; j < size; ++j) add_product(result[i - i % size + j], matrix[i % size * size + j], x[i]);
    return result;
  }

 private:
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
  const bool divided = tail[0].starts_with('/');
  require(halves.size() == 2 && text.starts_with('[') && (tail[0].empty() || divided) && tail.size() <= 2,
          "a mask is [c0,c1,...]/D@first");
  const mpq_class scale = parse_rational("1" + std::string(tail[0]));
  if (tail.size() == 2) parse_integer(tail[1]);
  Rationals mask;
  for (const std::string_view c : split(halves[0].substr(1), ',')) mask.push_back(parse_rational(c) * scale);
  require(mask.size() <= 1000 && mask.front() != 0 && mask.back() != 0,
          "a mask has 1 to 1000 coefficients, the first and the last not zero");
  return mask;
}

/// A file line by line. A line is its head, `image 3 0` for instance, and fields, each after one space.
class Reader {
 public:
  explicit Reader(const std::string& file) : input_(file, std::ios::binary) {}

  std::size_t line() const { return line_; }
  bool at_end() {
    if (std::exchange(taken_, false)) {
      ++line_;
      require(!std::getline(input_, text_) || !input_.eof(), "last line without line feed");
      require(text_.size() <= max_line, "line too long");
    }
    return !input_;
  }
  bool at(const std::string& head) { return !at_end() && (text_ == head || text_.starts_with(head + " ")); }
  /// Takes the next line, which must have the head and `low` to `high` fields; they are valid until the next call.
  Fields take(const std::string& head, std::size_t low, std::size_t high) {
    require(at(head), "expected '" + head + "'");
    taken_ = true;
    Fields fields = split(std::string_view(text_).substr(head.size()), ' ');
    fields.erase(fields.begin());  // what is before the first space: nothing
    require(fields.size() >= low && fields.size() <= high, "wrong number of fields");
    return fields;
  }

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

// ---- families and masks ----------------------------------------------------------------------------------------

/// Square matrices of one size, one after another, each column by column; all entries over one denominator > 0.
struct Family {
  std::size_t size = 1;
  Vector entries;
  mpz_class denominator = 1;

  std::size_t count() const { return entries.size() / (size * size); }
  std::span<const mpz_class> matrix(std::size_t t) const { return {&entries.at(t * size * size), size * size}; }
  void transpose() {
    for (std::size_t t = 0; t < count(); ++t)
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < i; ++j)
          std::swap(entries[(t * size + i) * size + j], entries[(t * size + j) * size + i]);
  }
};

/// The matrices with these entries.
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

/// Reads matrices row by row, each row after the head.
Family read_family(Reader& reader, const std::string& head, std::size_t count, std::size_t size) {
  Rationals rows;
  for (std::size_t i = 0; i < count * size; ++i)
    for (const std::string_view field : reader.take(head, size, size)) rows.push_back(parse_rational(field));
  Family family = clear_denominators(size, rows);
  family.transpose();
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
  Vector entries;
  for (std::size_t t = 0; t < arity; ++t)
    for (std::size_t k = 0; k < size; ++k)
      for (std::size_t i = t; i < t + arity * size; i += arity)
        entries.push_back(i >= k && i - k < b.size() ? b[i - k] : mpz_class(0));
  return {size, entries, denominator};
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
  std::string head, text, file;  // its line in a certificate; what to print; the certificate
};

class Checker {
 public:
  Checker(const Claim& claim, Reader& reader)
      : claim_(claim), reader_(reader), lower_(claim.lower), upper_(claim.upper) {}

  /// Returns if the certificate proves the claim.
  void run() {
    reader_.take("subcert-certificate 2", 0, 0);
    reader_.take(claim_.head, 0, 0);
    reader_.take("bounds", 2, 2);
    const Family family = claim_.arity != 0 ? read_scheme() : claim_.family;
    const bool divided = reader_.at("blocks"), first_columns = claim_.arity != 0 && !divided;
    const std::vector<Family> blocks = divided ? read_blocks(family) : std::vector{family};
    if (lower_ || reader_.at("product")) read_product(blocks);
    const bool sections = upper_ || reader_.at("block 0");
    for (std::size_t i = 0; sections && i < blocks.size(); ++i) {
      const Fields fields = reader_.take("block " + std::to_string(i), 2, 8);
      if (fields[0] == "norm")
        read_norm(blocks[i], fields, first_columns ? 1 : blocks[i].size);
      else
        read_polytope(blocks[i], fields);
    }
    reader_.take("end", 0, 0);
    require(reader_.at_end(), "text after 'end'");
  }

 private:
  /// The transition matrices of the mask of the claim, and what is to be shown of them.
  Family read_scheme() {
    require(*claim_.lower > 0, "the lower end of an exponent must be positive");
    const std::size_t sum_rules = parse_size(reader_.take("sum-rules", 1, 1)[0], 1, 500);
    const Family mask = clear_denominators(1, claim_.mask);
    require(std::accumulate(mask.entries.begin(), mask.entries.end(), mpz_class(0)) == mask.denominator * claim_.arity,
            "the coefficients of the mask do not sum to the arity");
    upper_ = power_lower(claim_.arity, sum_rules - *claim_.lower);
    lower_.reset();
    if (claim_.upper) lower_ = power(claim_.arity, sum_rules) / power_lower(claim_.arity, *claim_.upper);
    if (claim_.upper || reader_.at("stability")) {
      reader_.take("stability", 0, 0);
      check_stability(mask.entries, claim_.arity);
    }
    return transition_family(mask.entries, mask.denominator, claim_.arity, sum_rules);
  }

  /// Section 4.4: the diagonal blocks.
  std::vector<Family> read_blocks(const Family& family) {
    const std::size_t n = family.size;
    std::vector<std::size_t> sizes;
    for (const std::string_view field : reader_.take("blocks", 1, n)) sizes.push_back(parse_size(field, 1, n));
    require(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}) == n, "the block sizes do not sum to n");
    const Family basis = read_family(reader_, "basis", 1, n), inverse = read_family(reader_, "inverse", 1, n);
    const mpz_class denominator = basis.denominator * inverse.denominator;
    const Vector unit = arithmetic_.multiply(basis.entries, inverse.entries, n);
    for (std::size_t i = 0; i < n * n; ++i)
      require(unit[i] == (i % (n + 1) == 0 ? denominator : mpz_class(0)), "basis times inverse is not the unit matrix");
    std::vector<Rationals> entries(sizes.size());
    for (std::size_t t = 0; t < family.count(); ++t) {
      const Vector images = arithmetic_.multiply(family.matrix(t), basis.entries, n);
      const Vector triangular = arithmetic_.multiply(inverse.entries, images, n);
      for (std::size_t block = 0, start = 0; block < sizes.size(); start += sizes[block++])
        for (std::size_t k = start; k < start + sizes[block]; ++k)
          for (std::size_t j = start; j < n; ++j) {
            const mpz_class& entry = triangular[k * n + j];
            const bool inside = j < start + sizes[block];
            require(inside || entry == 0, "not block upper triangular");
            if (inside) entries[block].push_back(ratio(entry, family.denominator * denominator));
          }
    }
    std::vector<Family> blocks;
    for (std::size_t i = 0; i < sizes.size(); ++i) blocks.push_back(clear_denominators(sizes[i], entries[i]));
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
    Vector product(n * n), m(n * n);
    for (std::size_t i = 0; i < n; ++i) product[i * n + i] = q;
    for (std::size_t i = fields.size(); i-- > 3;)
      product = arithmetic_.multiply(family.matrix(parse_size(fields[i], 0, family.count() - 1)), product, n);
    // The characteristic polynomial, highest coefficient first; by Horner's scheme its value and derivative at c.
    mpz_class coefficient = 1;
    const Vector times_c{x, y, -y, x};
    Vector state{1, 0, 0, 0};  // real and imaginary part of the value, then of the derivative
    for (std::size_t k = 1; k <= n; ++k) {
      mpz_class trace = 0;
      for (std::size_t i = 0; i < n; ++i) m[i * n + i] += coefficient;
      m = arithmetic_.multiply(product, m, n);
      for (std::size_t i = 0; i < n; ++i) trace += m[i * n + i];
      coefficient = -trace / k;
      Vector next = arithmetic_.multiply(times_c, state, 2);
      next[0] += coefficient;
      for (std::size_t part = 0; part < 2; ++part) next[2 + part] += state[part];
      state = next;
    }
    const auto square = [](const mpz_class& a, const mpz_class& b) { return mpz_class(a * a + b * b); };
    const mpz_class values = square(state[0], state[1]) * n * n, slopes = square(state[2], state[3]);
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
    const std::size_t n = family.size, level = parse_size(fields[1], 1, 64);
    require(power(family.count(), level) * columns * n * n * 20 <= max_work, too_much_work);
    mpz_class largest = 0;
    for (std::size_t k = 0; k < columns; ++k) {
      Vector unit(n);
      unit[k] = 1;
      largest = std::max(largest, largest_norm(family, unit, level));
    }
    use_upper_bound(ratio(largest, power(family.denominator, level).get_num()), level);
  }

  /// The largest 1-norm of product * x over all products of this many matrices.
  mpz_class largest_norm(const Family& family, const Vector& x, std::size_t level) {
    mpz_class largest = 0;
    for (std::size_t t = 0; level > 0 && t < family.count(); ++t)
      largest = std::max(largest,
                         largest_norm(family, arithmetic_.multiply(family.matrix(t), x, family.size), level - 1));
    for (std::size_t i = 0; level == 0 && i < x.size(); ++i) largest += abs(x[i]);
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
    require(fields[0] == "polytope" && fields.size() >= 4, "expected 'norm' or 'polytope' and its numbers");
    const std::size_t n = family.size, vertices = parse_size(fields[1], 1, max_bytes);
    const std::size_t vertex_bits = parse_size(fields[2], 0, 4096), weight_bits = parse_size(fields[3], 0, 4096);
    std::set<std::string_view> properties(fields.begin() + 4, fields.end());
    if (properties.erase("transposed") != 0) family.transpose();
    const bool complex = properties.erase("complex") != 0, nonnegative = properties.erase("nonnegative") != 0;
    const bool symmetric = properties.erase("symmetric") != 0;
    require(properties.empty() && !(complex && nonnegative), "unknown polytope property");
    const Vector& entries = family.entries;
    const auto negative = [](const mpz_class& x) { return x < 0; };
    require(!symmetric || std::equal(entries.begin(), entries.end(), entries.rbegin()), "the family is not symmetric");
    require(!nonnegative || std::none_of(entries.begin(), entries.end(), negative), "a matrix is not non-negative");

    Polytope body{n, complex ? 2U : 1U, nonnegative, symmetric, {}};
    for (std::size_t i = 0; i < vertices; ++i) {
      Vector& vertex = body.vertices.emplace_back();
      for (const std::string_view field : reader_.take("vertex", body.parts * n, body.parts * n))
        vertex.push_back(parse_integer(field));
      require(!nonnegative || std::none_of(vertex.begin(), vertex.end(), negative), "negative coordinate");
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
      for (std::size_t t = 0; t < family.count(); ++t) {
        const Vector image = arithmetic_.multiply(family.matrix(t), body.vertices[j], n);
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
    mpz_class weights = 0, residual = 0;
    Vector sum(target.size());
    for (const std::string_view term : reader_.take(head, 0, max_line)) {
      arithmetic_.spend(1000);
      const Fields parts = split(term, ':');
      require(parts.size() == 1 + body.parts, "a term is INDEX:WEIGHT");
      std::string_view index = parts[0];
      const bool conjugate = body.parts == 2 && index.ends_with('c');
      if (conjugate) index.remove_suffix(1);
      const bool flipped = body.symmetric && index.ends_with('f');
      if (flipped) index.remove_suffix(1);
      const Vector& vertex = body.vertices[parse_size(index, 0, body.vertices.size() - 1)];
      const mpz_class re = parse_integer(parts[1]), im = body.parts == 2 ? parse_integer(parts[2]) : mpz_class(0);
      require(!body.nonnegative || re >= 0, "negative weight");
      mpz_class square = 0;
      for (const mpz_class& x : {re, im}) arithmetic_.add_product(square, x, x);
      if (square > 0) weights += sqrt(mpz_class(square - 1)) + 1;  // the modulus, rounded up
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

Claim read_claim(const std::vector<std::string>& arguments) {
  std::map<std::string, std::optional<std::string>> given{{"--mask", {}},  {"--arity", {}}, {"--matrices", {}},
                                                          {"--lower", {}}, {"--upper", {}}, {"FILE", {}}};
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string name = arguments[i].starts_with("--") ? arguments[i++] : "FILE";
    require(given.contains(name), "unknown option " + name);
    require(i < arguments.size() && !given[name], name + " needs a value, and only one");
    given[name] = arguments[i];
  }
  const auto &mask = given["--mask"], &arity = given["--arity"], &matrices = given["--matrices"],
             &lower = given["--lower"], &upper = given["--upper"], &file = given["FILE"];
  require(file && mask.has_value() != matrices.has_value() && mask.has_value() == arity.has_value() &&
              (lower || (upper && matrices)),
          usage);
  Claim claim;
  claim.file = *file;
  if (lower) claim.lower = parse_rational(*lower);
  if (upper) claim.upper = parse_rational(*upper);
  if (mask) {
    claim.mask = parse_mask(*mask);
    claim.arity = static_cast<unsigned>(parse_size(*arity, 2, 16));
    claim.head = "exponent " + *mask + " " + *arity;
  } else {
    read(*matrices, 65, [&](Reader& reader) {
      const Fields fields = reader.take("matrices", 2, 2);
      claim.family = read_family(reader, "row", parse_size(fields[0], 1, 64), parse_size(fields[1], 1, 256));
      require(reader.at_end(), "text after the last row");
    });
    claim.head = "radius " + std::to_string(claim.family.count()) + " " + std::to_string(claim.family.size);
  }
  claim.text = (lower ? claim.lower->get_str() + " <= " : "") + (mask ? "Hoelder exponent" : "joint spectral radius") +
               (upper ? " <= " + claim.upper->get_str() : "") + " of " +
               (mask ? *mask + " with arity " + *arity : *matrices);
  return claim;
}

}  // namespace

int run(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& errors) {
  try {
    if (arguments == std::vector<std::string>{"--help"}) throw Rejected{usage, 0};
    const Claim claim = read_claim(arguments);
    read(claim.file, 1, [&](Reader& reader) { Checker(claim, reader).run(); });
    out << "VERIFIED " << claim.text << std::endl;
    return out ? 0 : 1;
  } catch (const Rejected& rejected) {
    const std::string prefix = rejected.code == 0 ? "" : rejected.code == 1 ? "REJECTED " : "subcert-check: ";
    (rejected.code <= 1 ? out : errors) << prefix << rejected.why << std::endl;
    return rejected.code;
  } catch (const std::exception& error) {
    out << "REJECTED " << error.what() << ", line 0" << std::endl;
    return 1;
  }
}

}  // namespace subcert_check
