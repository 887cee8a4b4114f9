// The checker behind subcert-check. Section numbers refer to ../certificates/SPEC.md, which proves each step.
// Everything is exact integer arithmetic; the only rounding is outward, in square roots and logarithms.
#include "check.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace subcert_check {
namespace {

using Vector = std::vector<mpz_class>;

constexpr std::size_t max_digits = 2000;
constexpr std::size_t max_line = std::size_t{1} << 24;
constexpr std::size_t max_denominator_bits = 20000;
constexpr double max_work = 2e10;  // products of 64-bit limbs, all in all: about ten seconds

void require(bool condition, const std::string& why) {
  if (!condition) throw Rejected(why);
}

// ---- numbers as text -------------------------------------------------------------------------------------------

mpz_class parse_integer(std::string_view text) {
  const std::string_view digits = text.substr(text.starts_with('-') ? 1 : 0);
  const bool decimal = std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
  require(!digits.empty() && decimal && (digits.front() != '0' || text.size() == 1), "not an integer");
  require(digits.size() <= max_digits, "number too long");
  if (long value = 0; digits.size() <= 18) {
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
  }
  return mpz_class(std::string(text), 10);
}

std::size_t parse_size(std::string_view text, std::size_t low, std::size_t high) {
  const mpz_class value = parse_integer(text);
  require(value >= low && value <= high, "number outside " + std::to_string(low) + ".." + std::to_string(high));
  return value.get_ui();
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

std::size_t bits(const mpz_class& x) { return mpz_sizeinbase(x.get_mpz_t(), 2); }
double limbs(const Vector& values) {
  std::size_t most = 0;
  for (const mpz_class& x : values) most = std::max(most, bits(x));
  return static_cast<double>(most) / 64 + 0.1;
}
double limbs(const Family& family) {
  double most = limbs(Vector{family.denominator});
  for (const Vector& matrix : family.entries) most = std::max(most, limbs(matrix));
  return most;
}

mpz_class power(const mpz_class& base, unsigned long exponent) {
  mpz_class result;
  mpz_pow_ui(result.get_mpz_t(), base.get_mpz_t(), exponent);
  return result;
}

mpq_class ratio(const mpz_class& numerator, const mpz_class& denominator) {
  mpq_class result(numerator, denominator);
  result.canonicalize();
  return result;
}

/// Common denominator of the values; `values` times it goes to `cleared`.
mpz_class clear_denominators(const std::vector<mpq_class>& values, Vector& cleared) {
  mpz_class denominator = 1;
  for (const mpq_class& x : values) {
    denominator = lcm(denominator, x.get_den());
    require(bits(denominator) <= max_denominator_bits, "common denominator too large");
  }
  cleared.clear();
  for (const mpq_class& x : values) cleared.emplace_back(x.get_num() * (denominator / x.get_den()));
  return denominator;
}

/// A family from rational entries, all over one denominator.
Family make_family(std::size_t size, std::size_t count, const std::vector<mpq_class>& values) {
  Family family{size, 1, {}};
  Vector cleared;
  family.denominator = clear_denominators(values, cleared);
  const auto step = static_cast<std::ptrdiff_t>(size * size);
  for (std::size_t t = 0; t < count; ++t) {
    const auto begin = cleared.begin() + static_cast<std::ptrdiff_t>(t) * step;
    family.entries.emplace_back(begin, begin + step);
  }
  return family;
}

// ---- lines -----------------------------------------------------------------------------------------------------

/// The input line by line, split at single spaces; the current line is `tokens`, empty at the end of the input.
class Reader {
 public:
  explicit Reader(std::istream& input) : input_(*input.rdbuf()) { advance(); }

  std::vector<std::string_view> tokens;
  std::size_t line = 0;

  void advance() {
    ++line;
    text_.clear();
    tokens.clear();
    constexpr int end = std::char_traits<char>::eof();
    int c = input_.sbumpc();
    if (c == end) return;
    for (; c != '\n'; c = input_.sbumpc()) {
      require(c != end, "last line without line feed");
      require(c >= ' ' && c <= '~' && text_.size() < max_line, "bad character or line too long");
      text_.push_back(static_cast<char>(c));
    }
    tokens = split(text_, ' ');
    for (const std::string_view token : tokens) require(!token.empty(), "empty line or misplaced space");
  }
  bool at(std::string_view keyword) const { return !tokens.empty() && tokens[0] == keyword; }
  /// Requires a line that starts with the keyword and has `low` to `high` tokens after it.
  void expect(std::string_view keyword, std::size_t low, std::size_t high) const {
    require(at(keyword), "expected '" + std::string(keyword) + "'");
    const std::size_t count = tokens.size() - 1;
    require(count >= low && count <= high, "wrong number of fields after '" + std::string(keyword) + "'");
  }
  /// Reads `rows` lines 'row ...' of `size` rationals each.
  std::vector<mpq_class> read_rows(std::size_t rows, std::size_t size) {
    std::vector<mpq_class> values;
    for (std::size_t i = 0; i < rows; ++i, advance()) {
      expect("row", size, size);
      for (std::size_t k = 1; k <= size; ++k) values.push_back(parse_rational(tokens[k]));
    }
    return values;
  }

 private:
  std::streambuf& input_;
  std::string text_;
};

// ---- outward rounded functions ---------------------------------------------------------------------------------

/// Square root of x >= 0, rounded down or up to a multiple of 2^-320.
mpq_class root(const mpq_class& x, bool up) {
  const mpz_class scaled = x.get_num() << 640;
  mpz_class floor_root = sqrt(mpz_class(scaled / x.get_den()));
  if (up) ++floor_root;
  return ratio(floor_root, mpz_class(1) << 320);
}

/// Enclosure of log2(x), x > 0, by repeated squaring of the mantissa. Width at most 2^-127 in all but contrived cases.
std::pair<mpq_class, mpq_class> log2_enclosure(const mpq_class& x) {
  constexpr unsigned long precision = 320, steps = 128;
  const mpz_class one = mpz_class(1) << precision, two = one << 1;
  long exponent = static_cast<long>(bits(x.get_num())) - static_cast<long>(bits(x.get_den()));
  const auto scaled = [&](long e) -> mpq_class {
    return e >= 0 ? mpq_class(x >> static_cast<unsigned long>(e)) : mpq_class(x << static_cast<unsigned long>(-e));
  };
  if (scaled(exponent) < 1) --exponent;
  const mpq_class mantissa = scaled(exponent) << precision;
  mpz_class low = mantissa.get_num() / mantissa.get_den(), high = low + 1, digits = exponent;
  if (low == mantissa) high = low;
  for (unsigned long i = 1; i <= steps; ++i) {
    low = (low * low) >> precision;
    high = (high * high + one - 1) >> precision;
    digits *= 2;
    if (low >= two) {
      ++digits;
      low >>= 1;
      high = (high + 1) >> 1;
    } else if (high > two) {  // the digit is not decided at this precision: log2 of the mantissa is in 0..2
      return {ratio(digits, mpz_class(1) << i), ratio(digits + 2, mpz_class(1) << i)};
    }
  }
  const mpz_class scale = mpz_class(1) << steps;
  return {ratio(digits, scale), ratio(low == one && high == one ? digits : mpz_class(digits + 1), scale)};
}

/// True only if x <= base^s, proved: exactly if the powers are small, otherwise by logarithms.
bool proves_at_most(const mpq_class& x, unsigned base, const mpq_class& s) {
  if (x <= 0) return true;
  constexpr unsigned long limit = 1UL << 20;
  const mpz_class size = bits(x.get_num()) + bits(x.get_den());
  if (s.get_den() * size <= limit && abs(s.get_num()) * 4 <= limit) {
    const unsigned long q = s.get_den().get_ui();
    const mpz_class scale = power(base, mpz_class(abs(s.get_num())).get_ui());
    const mpz_class left = power(x.get_num(), q), right = power(x.get_den(), q);
    return s >= 0 ? left <= right * scale : left * scale <= right;
  }
  const auto log_base = log2_enclosure(base);
  return log2_enclosure(x).second <= s * (s >= 0 ? log_base.first : log_base.second);
}

// ---- arithmetic modulo a prime below 2^31 ----------------------------------------------------------------------

using Residues = std::vector<std::uint64_t>;  // polynomials: coefficient of z^i at i, no leading zeros

std::uint64_t parse_prime(std::string_view text) {
  const std::uint64_t p = parse_size(text, 2, 2147483647);
  for (std::uint64_t q = 2; q * q <= p; ++q) require(p % q != 0, "not a prime");
  return p;
}

std::uint64_t inverse(std::uint64_t x, std::uint64_t p) {
  std::uint64_t result = 1;
  for (std::uint64_t e = p - 2; e != 0; e >>= 1, x = x * x % p)
    if (e & 1) result = result * x % p;
  return p == 2 ? x : result;
}

Residues reduce(const Vector& values, std::uint64_t p) {
  Residues result;
  for (const mpz_class& x : values) result.push_back(mpz_fdiv_ui(x.get_mpz_t(), p));
  return result;
}

/// Remainder of x modulo y, y not zero; zero is the empty polynomial.
Residues remainder(Residues x, const Residues& y, std::uint64_t p) {
  const std::uint64_t lead = inverse(y.back(), p);
  while (true) {
    while (!x.empty() && x.back() == 0) x.pop_back();
    if (x.size() < y.size()) return x;
    const std::uint64_t factor = x.back() * lead % p;
    const std::size_t shift = x.size() - y.size();
    for (std::size_t i = 0; i < y.size(); ++i) x[shift + i] = (x[shift + i] + (p - factor) * y[i]) % p;
  }
}

bool determinant_is_nonzero(Residues m, std::size_t n, std::uint64_t p) {
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    while (pivot < n && m[pivot * n + c] == 0) ++pivot;
    if (pivot == n) return false;
    for (std::size_t k = 0; k < n; ++k) std::swap(m[c * n + k], m[pivot * n + k]);
    const std::uint64_t scale = inverse(m[c * n + c], p);
    for (std::size_t i = c + 1; i < n; ++i) {
      const std::uint64_t factor = (p - m[i * n + c]) * scale % p;
      for (std::size_t k = c; k < n; ++k) m[i * n + k] = (m[i * n + k] + factor * m[c * n + k]) % p;
    }
  }
  return true;
}

int moebius(std::size_t n) {
  int sign = 1;
  for (std::size_t q = 2; n > 1; ++q)
    if (n % q == 0) {
      n /= q;
      if (n % q == 0) return 0;
      sign = -sign;
    }
  return sign;
}

/// Euler's phi of 0..n.
std::vector<std::size_t> totients(std::size_t n) {
  std::vector<std::size_t> phi(n + 1);
  std::iota(phi.begin(), phi.end(), std::size_t{0});
  for (std::size_t q = 2; q <= n; ++q)
    if (phi[q] == q)
      for (std::size_t i = q; i <= n; i += q) phi[i] -= phi[i] / q;
  return phi;
}

/// Phi_n, n > 1, as the power series of the product of (1 - z^d)^moebius(n/d) over the divisors d, which ends at
/// phi(n).
Residues cyclotomic(std::size_t n, std::size_t degree, std::uint64_t p) {
  Residues f(degree + 1, 0);
  f[0] = 1;
  for (std::size_t d = 1; d <= n && d < f.size(); ++d) {
    const int mu = n % d == 0 ? moebius(n / d) : 0;
    for (std::size_t i = f.size(); mu > 0 && i-- > d;) f[i] = (f[i] + p - f[i - d]) % p;
    for (std::size_t i = d; mu < 0 && i < f.size(); ++i) f[i] = (f[i] + f[i - d]) % p;
  }
  return f;
}

/// Conditions (i) and (ii) of Theorem 4 for the mask `a` (denominators cleared, first and last not zero), modulo p.
void check_stability(const Vector& a, unsigned arity, std::uint64_t p) {
  Residues divisor;
  bool first = true;
  for (unsigned r = 0; r < arity; ++r) {
    Vector part;
    for (std::size_t i = r; i < a.size(); i += arity)
      if (!part.empty() || a[i] != 0) part.push_back(a[i]);
    while (!part.empty() && part.back() == 0) part.pop_back();
    if (part.empty()) continue;
    Residues y = reduce(part, p);
    require(!first || y.back() != 0, "stability: the prime divides a leading coefficient, name another one");
    first = false;
    for (y = remainder(y, Residues(y.size() + 1, 1), p); !y.empty(); std::swap(divisor, y))
      divisor = divisor.empty() ? Residues{} : remainder(divisor, y, p);
  }
  require(divisor.size() == 1, "stability: the polyphase parts may have a common zero");
  const std::size_t degree = a.size() - 1;
  const Residues symbol = reduce(a, p);
  const std::vector<std::size_t> phi = totients(2 * degree * degree);
  for (std::size_t k = 2, n = 2 * arity; n < phi.size(); ++k, n += arity)
    if (std::gcd(k, std::size_t{arity}) == 1 && phi[n] <= degree)
      require(!remainder(symbol, cyclotomic(n, phi[n], p), p).empty(),
              "stability: Phi_" + std::to_string(n) + " may divide a");
}

// ---- matrices --------------------------------------------------------------------------------------------------

Vector multiply(const Vector& a, const Vector& b, std::size_t n) {
  Vector c(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (a[i * n + j] != 0)
        for (std::size_t k = 0; k < n; ++k)
          mpz_addmul(c[i * n + k].get_mpz_t(), a[i * n + j].get_mpz_t(), b[j * n + k].get_mpz_t());
  return c;
}

Vector apply(const Vector& a, const Vector& x) {
  const std::size_t n = x.size();
  Vector y(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) mpz_addmul(y[i].get_mpz_t(), a[i * n + j].get_mpz_t(), x[j].get_mpz_t());
  return y;
}

/// Coefficients of det(z - A), highest power first. Berkowitz: by leading principal submatrices, without division.
Vector characteristic_polynomial(const Vector& a, std::size_t n) {
  Vector p{1};
  for (std::size_t r = 0; r < n; ++r) {
    Vector column(r + 2), s(r);
    column[0] = 1;
    column[1] = -a[r * n + r];
    for (std::size_t i = 0; i < r; ++i) s[i] = a[i * n + r];
    for (std::size_t k = 0; k < r; ++k) {
      Vector next(r);
      for (std::size_t i = 0; i < r; ++i) {
        mpz_submul(column[k + 2].get_mpz_t(), a[r * n + i].get_mpz_t(), s[i].get_mpz_t());
        for (std::size_t j = 0; j < r; ++j) mpz_addmul(next[i].get_mpz_t(), a[i * n + j].get_mpz_t(), s[j].get_mpz_t());
      }
      s = std::move(next);
    }
    Vector next(r + 2);
    for (std::size_t i = 0; i < r + 2; ++i)
      for (std::size_t j = 0; j <= std::min(i, r); ++j)
        mpz_addmul(next[i].get_mpz_t(), column[i - j].get_mpz_t(), p[j].get_mpz_t());
    p = std::move(next);
  }
  return p;
}

/// The family of section 4.1, after exact division by sigma^m.
Family transition_family(const Vector& mask, const mpz_class& denominator, unsigned arity, std::size_t m) {
  Vector b = mask;
  for (std::size_t round = 0; round < m; ++round) {
    require(b.size() >= arity, "the mask has no sum rules of this order");
    for (std::size_t i = 0; i < b.size(); ++i)
      for (std::size_t j = 1; j < arity && j <= i; ++j)
        if (i - j + arity <= b.size()) b[i] -= b[i - j];
    for (std::size_t i = b.size() - arity + 1; i < b.size(); ++i)
      require(b[i] == 0, "the mask has no sum rules of this order");
    b.resize(b.size() - arity + 1);
  }
  const mpz_class scale = power(arity, m);
  for (mpz_class& x : b) x *= scale;
  const std::size_t size = std::max<std::size_t>(1, (b.size() - 1 + arity - 2) / (arity - 1));
  require(size <= 256, "transition matrices larger than 256");
  Family family{size, denominator, std::vector<Vector>(arity, Vector(size * size))};
  for (std::size_t t = 0; t < arity; ++t)
    for (std::size_t j = 0; j < size; ++j)
      for (std::size_t k = 0; k < size; ++k)
        if (const std::size_t i = arity * j + t; i >= k && i - k < b.size()) family.entries[t][j * size + k] = b[i - k];
  return family;
}

// ---- the certificate -------------------------------------------------------------------------------------------

class Checker {
 public:
  Checker(const Claim& claim, Reader& reader) : claim_(claim), reader_(reader) {}

  void run() {
    reader_.expect("subcert-certificate", 1, 1);
    require(reader_.tokens[1] == "1", "unknown version");
    reader_.advance();
    read_subject();
    reader_.expect("bounds", 2, 2);
    for (const std::size_t i : {1U, 2U})
      if (reader_.tokens[i] != "-") parse_rational(reader_.tokens[i]);
    reader_.advance();
    const bool stable = claim_.arity != 0 && read_scheme();
    if (reader_.at("blocks")) read_blocks();
    const bool whole_scheme = claim_.arity != 0 && blocks_.empty();
    if (blocks_.empty()) blocks_.push_back(family_);
    bool product = false;
    if (reader_.at("product")) {
      read_product();
      product = true;
    }
    const bool sections = reader_.at("block");
    for (std::size_t i = 0; sections && i < blocks_.size(); ++i) read_section(i, whole_scheme);
    reader_.expect("end", 0, 0);
    reader_.advance();
    require(reader_.tokens.empty(), "text after 'end'");

    require(sections || (claim_.arity == 0 && !claim_.upper), "the claim needs a norm or a polytope");
    require(product || (claim_.arity == 0 ? !claim_.lower : !claim_.upper), "the claim needs a 'product' line");
    require(stable || claim_.arity == 0 || !claim_.upper, "the upper end needs a 'stability' line");
  }

 private:
  void spend(double work) {
    work_ += work;
    require(work_ <= max_work, "more work than the checker allows");
  }

  void read_subject() {
    if (claim_.arity != 0) {
      reader_.expect("exponent", 2, 2);
      require(parse_mask(reader_.tokens[1]) == claim_.mask && parse_size(reader_.tokens[2], 2, 16) == claim_.arity,
              "certificate for another scheme");
    } else {
      reader_.expect("radius", 2, 2);
      family_ = claim_.family;
      require(parse_size(reader_.tokens[1], 1, 64) == family_.entries.size() &&
                  parse_size(reader_.tokens[2], 1, 256) == family_.size,
              "certificate for another family");
    }
    reader_.advance();
  }

  /// Builds the transition matrices from the mask of the claim; true if the integer shifts are proved stable.
  bool read_scheme() {
    require(claim_.lower && *claim_.lower > 0, "the lower end of an exponent must be positive");
    reader_.expect("sum-rules", 1, 1);
    sum_rules_ = parse_size(reader_.tokens[1], 1, 500);
    Vector mask;
    const mpz_class denominator = clear_denominators(claim_.mask.coefficients, mask);
    const mpz_class sum = std::accumulate(mask.begin(), mask.end(), mpz_class(0));
    require(sum == denominator * claim_.arity, "the coefficients of the mask do not sum to the arity");
    family_ = transition_family(mask, denominator, claim_.arity, sum_rules_);
    reader_.advance();
    if (!reader_.at("stability")) return false;
    reader_.expect("stability", 1, 1);
    check_stability(mask, claim_.arity, parse_prime(reader_.tokens[1]));
    reader_.advance();
    return true;
  }

  /// Section 4.4.
  void read_blocks() {
    const std::size_t n = family_.size, count = family_.entries.size();
    reader_.expect("blocks", 2, n + 1);
    const std::uint64_t prime = parse_prime(reader_.tokens[1]);
    std::vector<std::size_t> sizes;
    for (std::size_t i = 2; i < reader_.tokens.size(); ++i) sizes.push_back(parse_size(reader_.tokens[i], 1, n));
    require(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}) == n, "the block sizes do not sum to n");
    reader_.advance();
    reader_.expect("basis", 0, 0);
    reader_.advance();
    const Family basis = make_family(n, 1, reader_.read_rows(n, n));
    require(determinant_is_nonzero(reduce(basis.entries[0], prime), n, prime),
            "the determinant of the basis is 0 mod p");
    for (std::size_t t = 0; t < count; ++t) {
      reader_.expect("triangular", 1, 1);
      require(parse_size(reader_.tokens[1], 0, count - 1) == t, "matrices out of order");
      reader_.advance();
      const std::vector<mpq_class> rows = reader_.read_rows(n, n);
      const Family image = make_family(n, 1, rows);
      spend(std::pow(static_cast<double>(n), 3) * limbs(basis) * (limbs(image) + limbs(family_) + 10));
      const Vector left = multiply(family_.entries[t], basis.entries[0], n);
      const Vector right = multiply(basis.entries[0], image.entries[0], n);
      for (std::size_t i = 0; i < n * n; ++i)
        require(left[i] * image.denominator == right[i] * family_.denominator, "T B = B M does not hold");
      for (std::size_t b = 0, start = 0; b < sizes.size(); start += sizes[b++]) {
        for (std::size_t j = start; j < start + sizes[b]; ++j)
          for (std::size_t k = 0; k < start; ++k) require(rows[j * n + k] == 0, "not block upper triangular");
      }
      triangular_.push_back(rows);
    }
    for (std::size_t b = 0, start = 0; b < sizes.size(); start += sizes[b++]) {
      std::vector<mpq_class> values;
      for (const std::vector<mpq_class>& rows : triangular_)
        for (std::size_t j = start; j < start + sizes[b]; ++j)
          for (std::size_t k = start; k < start + sizes[b]; ++k) values.push_back(rows[j * n + k]);
      blocks_.push_back(make_family(sizes[b], count, values));
    }
  }

  /// Section 4.5: proves a lower bound of the radius and compares it with the claim.
  void read_product() {
    reader_.expect("product", 4, 3 + 4096);
    const Family& family = blocks_[parse_size(reader_.tokens[1], 0, blocks_.size() - 1)];
    const mpq_class re = parse_rational(reader_.tokens[2]), im = parse_rational(reader_.tokens[3]);
    std::vector<std::size_t> word;
    for (std::size_t i = 4; i < reader_.tokens.size(); ++i)
      word.push_back(parse_size(reader_.tokens[i], 0, family.entries.size() - 1));
    const std::size_t n = family.size, length = word.size();
    const double d = static_cast<double>(n);
    const double growth = static_cast<double>(length) * (limbs(family) + std::log2(d) / 64);
    spend(std::pow(d, 3) * (10 * d + static_cast<double>(length) * 40 + growth * growth * (1 + d * d / 10)));
    Vector product = family.entries[word[0]];
    for (std::size_t i = 1; i < length; ++i) product = multiply(product, family.entries[word[i]], n);
    const Vector p = characteristic_polynomial(product, n);

    // Horner for p and p' at c = (x + i y)/q, c the eigenvalue of the integer product, homogeneous in q
    const mpz_class scale = power(family.denominator, length), q = lcm(re.get_den(), im.get_den());
    const mpz_class x = re.get_num() * (q / re.get_den()) * scale, y = im.get_num() * (q / im.get_den()) * scale;
    const auto evaluate = [&](std::size_t degree, auto coefficient) {
      mpz_class u = 0, v = 0, q_power = 1, next;
      for (std::size_t k = 0; k <= degree; ++k, q_power *= q) {
        next = u * x - v * y + coefficient(k) * q_power;
        v = u * y + v * x;
        u = next;
      }
      return mpz_class(u * u + v * v);
    };
    spend(d * d * (limbs(Vector{x, y, q}) + limbs(p)) * limbs(Vector{x, y, q}));
    const mpz_class value = evaluate(n, [&](std::size_t k) { return p[k]; });
    const mpz_class slope = evaluate(n - 1, [&](std::size_t k) { return mpz_class(p[k] * mpz_class(n - k)); });
    require(slope != 0, "the characteristic polynomial has derivative 0 at the given eigenvalue");
    const mpq_class radius = root(ratio(value * n * n, slope * q * q * scale * scale), value != 0);
    const mpq_class modulus = im == 0 ? mpq_class(abs(re)) : root(re * re + im * im, false);
    const mpq_class bound = modulus - radius;
    require(bound > 0, "the product proves no positive spectral radius");
    if (claim_.arity == 0 && claim_.lower && *claim_.lower > 0) {
      require_small_power(*claim_.lower, length);
      const mpq_class target = ratio(power(claim_.lower->get_num(), length), power(claim_.lower->get_den(), length));
      require(bound >= target, "the product's spectral radius does not prove the lower end");
    } else if (claim_.arity != 0 && claim_.upper) {
      require(bound > 1, "the product must have a spectral radius above 1");
      const mpq_class exponent = (*claim_.upper - sum_rules_) * length;  // 1/bound <= A^(length (upper - m))
      require(proves_at_most(1 / bound, claim_.arity, exponent),
              "the product's spectral radius does not prove the upper end");
    }
    reader_.advance();
  }

  static void require_small_power(const mpq_class& x, std::size_t exponent) {
    require((bits(x.get_num()) + bits(x.get_den())) * exponent <= 50'000'000, "power of a bound too large");
  }

  /// Compares radius(block)^exponent <= value with the claim.
  void require_upper(const mpq_class& value, std::size_t exponent) const {
    bool proved = true;
    if (claim_.arity != 0) {
      const mpq_class level = (sum_rules_ - *claim_.lower) * exponent;
      proved = proves_at_most(value, claim_.arity, level);
    } else if (claim_.upper) {
      require(*claim_.upper >= 0, "a radius is not negative");
      require_small_power(*claim_.upper, exponent);
      proved = value <= ratio(power(claim_.upper->get_num(), exponent), power(claim_.upper->get_den(), exponent));
    }
    require(proved, std::string("the bound does not prove the ") + (claim_.arity != 0 ? "lower end" : "upper end"));
  }

  void read_section(std::size_t index, bool whole_scheme) {
    reader_.expect("block", 3, 8);
    require(parse_size(reader_.tokens[1], 0, blocks_.size() - 1) == index, "blocks out of order");
    if (reader_.tokens[2] == "norm") {
      require(reader_.tokens.size() == 4, "wrong number of fields after 'norm'");
      read_norm(blocks_[index], whole_scheme);
    } else {
      require(reader_.tokens[2] == "polytope", "expected 'norm' or 'polytope'");
      read_polytope(blocks_[index]);
    }
  }

  /// Section 4.6.
  void read_norm(const Family& family, bool whole_scheme) {
    const std::size_t level = parse_size(reader_.tokens[3], 1, 64), starts = whole_scheme ? 1 : family.size;
    const double count = static_cast<double>(family.entries.size()), d = static_cast<double>(family.size);
    const double products = std::pow(count, level) * (count > 1 ? 2 : static_cast<double>(level));
    spend(products * d * d * static_cast<double>(starts) *
          (40 + limbs(family) * static_cast<double>(level) * (limbs(family) + 1)));
    mpz_class most = 0;
    for (std::size_t k = 0; k < starts; ++k) {
      Vector unit(family.size);
      unit[k] = 1;
      extend_products(family, unit, level, most);
    }
    require_upper(ratio(most, power(family.denominator, level)), level);
    reader_.advance();
  }

  static void extend_products(const Family& family, const Vector& x, std::size_t levels, mpz_class& most) {
    for (const Vector& matrix : family.entries) {
      const Vector y = apply(matrix, x);
      if (levels > 1) {
        extend_products(family, y, levels - 1, most);
      } else {
        mpz_class norm = 0;
        for (const mpz_class& value : y) norm += abs(value);
        if (norm > most) most = norm;
      }
    }
  }

  struct Vertex {
    Vector re, im;  // im is empty unless complex
  };

  /// The polytope of the section being read, and the sum of weighted vertices of the line being read.
  struct Polytope {
    bool complex = false, nonnegative = false, symmetric = false, transposed = false;
    std::size_t size = 0, count = 0, vertex_bits = 0, weight_bits = 0;
    std::vector<Vertex> vertices;
    double vertex_limbs = 1;
    Vertex sum;
  };

  /// Section 4.7.
  void read_polytope(Family family) {
    const auto& tokens = reader_.tokens;
    require(tokens.size() >= 7, "wrong number of fields after 'polytope'");
    Polytope body;
    body.complex = tokens[3] == "complex";
    body.nonnegative = tokens[3] == "nonnegative";
    require(body.complex || body.nonnegative || tokens[3] == "real", "unknown polytope mode");
    body.size = family.size;
    body.count = parse_size(tokens[4], 1, 100'000'000);
    body.vertex_bits = parse_size(tokens[5], 0, 4096);
    body.weight_bits = parse_size(tokens[6], 0, 4096);
    body.symmetric = tokens.size() > 7 && tokens[7] == "symmetric";
    body.transposed = tokens.size() > 7 && tokens.back() == "transposed";
    require(tokens.size() == 7U + body.symmetric + body.transposed, "unknown polytope property");
    const std::size_t n = family.size, count = family.entries.size();
    for (std::size_t t = 0; t < count; ++t)
      for (std::size_t i = 0; i < n * n; ++i) {
        require(!body.symmetric || family.entries[t][i] == family.entries[count - 1 - t][n * n - 1 - i],
                "the family is not symmetric");
        require(!body.nonnegative || family.entries[t][i] >= 0, "a matrix is not non-negative");
      }
    for (std::size_t j = 0; body.transposed && j < n; ++j)
      for (std::size_t k = 0; k < j; ++k)
        for (Vector& matrix : family.entries) std::swap(matrix[j * n + k], matrix[k * n + j]);
    reader_.advance();

    for (std::size_t j = 0; j < body.count; ++j, reader_.advance()) read_vertex(body);
    const mpz_class one = mpz_class(1) << (body.vertex_bits + body.weight_bits);
    mpz_class worst_residual = 0, worst_weights = 0;  // R and S of Theorem 6, over `one` and over 2^weight_bits
    for (std::size_t k = 0; k < (body.symmetric ? (n + 1) / 2 : n); ++k, reader_.advance()) {
      reader_.expect("unit", 1, max_line);
      require(parse_size(tokens[1], 0, n - 1) == k, "units out of order");
      const mpz_class weights = read_terms(body, 2);
      Vertex unit{Vector(n), Vector(body.complex ? n : 0)};
      unit.re[k] = 1;
      worst_residual = std::max(worst_residual, residual(body, unit, one, 1));
      worst_weights = std::max(worst_weights, weights);
    }
    require(worst_residual < one, "the vertices do not span: a unit's residual is 1 or more");
    const mpq_class unit_norm = ratio(worst_weights * one, (one - worst_residual) << body.weight_bits);
    mpq_class worst = 0;
    const mpz_class weight_one = mpz_class(1) << body.weight_bits, residual_one = family.denominator * one;
    for (std::size_t j = 0; j < body.count; ++j)
      for (std::size_t t = 0; t < count; ++t, reader_.advance()) {
        reader_.expect("image", 2, max_line);
        require(parse_size(tokens[1], 0, body.count - 1) == j && parse_size(tokens[2], 0, count - 1) == t,
                "images out of order");
        const mpz_class weights = read_terms(body, 3);
        const Vertex& v = body.vertices[j];
        spend(static_cast<double>(n * n) * body.vertex_limbs * (limbs_ == 0 ? limbs_ = limbs(family) : limbs_));
        const Vertex image{apply(family.entries[t], v.re), body.complex ? apply(family.entries[t], v.im) : Vector{}};
        const mpz_class rest = residual(body, image, weight_one, family.denominator);
        const mpq_class norm = ratio(weights, weight_one) + ratio(rest, residual_one) * unit_norm;
        if (norm > worst) worst = norm;
      }
    limbs_ = 0;
    require_upper(worst, 1);
  }

  void read_vertex(Polytope& body) const {
    reader_.expect("vertex", body.size, body.size);
    Vertex& v = body.vertices.emplace_back();
    for (std::size_t i = 1; i <= body.size; ++i) {
      const auto parts = split(reader_.tokens[i], ',');
      require(parts.size() == (body.complex ? 2U : 1U), "wrong number of parts in a coordinate");
      v.re.push_back(parse_integer(parts[0]));
      if (body.complex) v.im.push_back(parse_integer(parts[1]));
      require(!body.nonnegative || v.re.back() >= 0, "negative coordinate");
    }
    body.vertex_limbs = std::max({body.vertex_limbs, limbs(v.re), limbs(v.im)});
  }

  /// Reads the terms from token `from` on: their sum goes to body.sum; returns the sum of the absolute weights.
  mpz_class read_terms(Polytope& body, std::size_t from) {
    const std::size_t n = body.size;
    body.sum.re.resize(n);
    body.sum.im.resize(body.complex ? n : 0);
    for (Vector* sum : {&body.sum.re, &body.sum.im})
      for (mpz_class& x : *sum) x = 0;
    mpz_class total = 0;
    for (std::size_t i = from; i < reader_.tokens.size(); ++i) {
      const auto halves = split(reader_.tokens[i], ':');
      require(halves.size() == 2, "a term is INDEX:WEIGHT");
      std::string_view index = halves[0];
      const bool conjugate = body.complex && index.ends_with('c');
      if (conjugate) index.remove_suffix(1);
      const bool flipped = body.symmetric && index.ends_with('f');
      if (flipped) index.remove_suffix(1);
      const Vertex& v = body.vertices[parse_size(index, 0, body.count - 1)];
      const auto parts = split(halves[1], ',');
      require(parts.size() == (body.complex ? 3U : 1U), "wrong number of parts in a weight");
      const mpz_class re = parse_integer(parts[0]);
      spend(static_cast<double>(n) * body.vertex_limbs * static_cast<double>(bits(re) / 64 + 1) * 2);
      require(!body.nonnegative || re >= 0, "negative weight");
      const auto add = [n, flipped](Vector& sum, const mpz_class& weight, const Vector& x) {
        for (std::size_t k = 0; k < n; ++k)
          mpz_addmul(sum[k].get_mpz_t(), weight.get_mpz_t(), x[flipped ? n - 1 - k : k].get_mpz_t());
      };
      add(body.sum.re, re, v.re);
      if (!body.complex) {
        total += abs(re);
        continue;
      }
      const mpz_class im = parse_integer(parts[1]), modulus = parse_integer(parts[2]);
      spend(static_cast<double>(n) * body.vertex_limbs * static_cast<double>(bits(im) / 64 + 1) * 2);
      require(modulus >= 0 && modulus * modulus >= re * re + im * im, "a weight's modulus is too small");
      total += modulus;
      add(body.sum.re, conjugate ? im : mpz_class(-im), v.im);
      add(body.sum.im, im, v.re);
      add(body.sum.im, conjugate ? mpz_class(-re) : re, v.im);
    }
    return total;
  }

  /// Norm of `target * target_scale - body.sum * sum_scale`; in mode nonnegative only what is positive counts.
  static mpz_class residual(const Polytope& body, const Vertex& target, const mpz_class& target_scale,
                            const mpz_class& sum_scale) {
    mpz_class total = 0, part;
    const auto add = [&](const Vector& x, const Vector& y) {
      for (std::size_t i = 0; i < x.size(); ++i) {
        part = x[i] * target_scale;
        mpz_submul(part.get_mpz_t(), y[i].get_mpz_t(), sum_scale.get_mpz_t());
        if (part > 0 || !body.nonnegative) total += abs(part);
      }
    };
    add(target.re, body.sum.re);
    add(target.im, body.sum.im);
    return total;
  }

  const Claim& claim_;
  Reader& reader_;
  Family family_;
  std::size_t sum_rules_ = 0;
  std::vector<std::vector<mpq_class>> triangular_;
  std::vector<Family> blocks_;
  double work_ = 0, limbs_ = 0;
};

}  // namespace

mpq_class parse_rational(std::string_view text) {
  const auto parts = split(text, '/');
  require(parts.size() <= 2, "not a rational");
  const mpz_class numerator = parse_integer(parts[0]);
  const mpz_class denominator = parts.size() == 2 ? parse_integer(parts[1]) : mpz_class(1);
  require(denominator > 0, "a denominator must be positive");
  return ratio(numerator, denominator);
}

Mask parse_mask(std::string_view text) {
  const std::size_t close = text.find(']');
  require(text.starts_with('[') && close != std::string_view::npos, "a mask is [c0,c1,...]/D@first");
  Mask mask;
  for (const std::string_view c : split(text.substr(1, close - 1), ',')) mask.coefficients.push_back(parse_rational(c));
  text.remove_prefix(close + 1);
  if (const std::size_t at = text.find('@'); at != std::string_view::npos) {
    const bool negative = text.substr(at + 1).starts_with('-');
    mask.first = static_cast<long>(parse_size(text.substr(at + (negative ? 2 : 1)), 0, 1'000'000));
    if (negative) mask.first = -mask.first;
    text = text.substr(0, at);
  }
  if (!text.empty()) {
    require(text.starts_with('/'), "a mask is [c0,c1,...]/D@first");
    const mpz_class denominator = parse_integer(text.substr(1));
    require(denominator > 0, "a denominator must be positive");
    for (mpq_class& c : mask.coefficients) c /= denominator;
  }
  auto& c = mask.coefficients;
  while (!c.empty() && c.back() == 0) c.pop_back();
  const auto begin = std::find_if(c.begin(), c.end(), [](const mpq_class& x) { return x != 0; });
  mask.first += static_cast<long>(begin - c.begin());
  c.erase(c.begin(), begin);
  require(!c.empty() && c.size() <= 1000, "a mask has 1 to 1000 coefficients, not all zero");
  return mask;
}

Family read_matrices(std::istream& input) {
  Reader reader(input);
  reader.expect("matrices", 2, 2);
  const std::size_t count = parse_size(reader.tokens[1], 1, 64), size = parse_size(reader.tokens[2], 1, 256);
  std::vector<mpq_class> values;
  for (reader.advance(); values.size() < count * size * size; reader.advance()) {
    require(reader.tokens.size() == size, "wrong number of entries, line " + std::to_string(reader.line));
    for (const std::string_view token : reader.tokens) values.push_back(parse_rational(token));
  }
  require(reader.tokens.empty(), "text after the last row");
  return make_family(size, count, values);
}

std::string Claim::text() const {
  return (lower ? lower->get_str() + " <= " : "") + (arity != 0 ? "Hoelder exponent" : "joint spectral radius") +
         (upper ? " <= " + upper->get_str() : "") + " of " + subject +
         (arity != 0 ? " with arity " + std::to_string(arity) : "");
}

void check(const Claim& claim, std::istream& certificate) {
  std::optional<Reader> reader;
  try {
    reader.emplace(certificate);
    Checker(claim, *reader).run();
  } catch (const Rejected& rejected) {
    throw Rejected(std::string(rejected.what()) + ", line " + std::to_string(reader ? reader->line : 1));
  }
}

}  // namespace subcert_check
