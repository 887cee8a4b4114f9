#include "parameter.hpp"

#include "circle.hpp"
#include "scheme.hpp"
#include "surfaces/torus.hpp"

#include <algorithm>
#include <numeric>

namespace subcert_check {

std::vector<Vector> power_forms(const Range& range, std::size_t n) {
  const mpz_class denominator = lcm(range.low.get_den(), range.high.get_den());
  const mpz_class low = mpq_class(range.low * denominator).get_num(),
                  high = range.unbounded ? denominator : mpq_class(range.high * denominator).get_num(),
                  last = range.unbounded ? mpz_class(0) : denominator;
  std::vector<Vector> forms;
  for (std::size_t k = 0; k <= n; ++k) {
    Vector& form = forms.emplace_back(Vector{1});
    for (std::size_t r = 0; r < n; ++r) {
      form.emplace_back(0);
      for (std::size_t j = form.size(); j-- > 0;)
        form[j] = (r < k ? low : denominator) * form[j] +
                  (j > 0 ? mpz_class((r < k ? high : last) * form[j - 1]) : mpz_class(0));
    }
  }
  return forms;
}

Vector divisor_form(const Vector& polynomial, const std::vector<Vector>& forms) {
  Vector result(polynomial.size());
  for (std::size_t k = 0; k < polynomial.size(); ++k)
    for (std::size_t j = 0; j < polynomial.size(); ++j) result[j] += forms[k][j] * polynomial[k];
  return result;
}

namespace {

constexpr std::size_t max_determinant_bits = 1UL << 31;  // of all numbers of a determinant together
constexpr std::size_t max_determinant_degree = 1UL << 14;
constexpr std::size_t max_cycle_order = 1UL << 20;  // but for 1, of roots of unity

/// The boxes of u^j v^(n-j), j = 0, ..., n, in place of those of the powers.
Vector coefficient_forms(const Mask& mask, const Range& range) {
  const std::vector<Vector> forms = power_forms(range, mask.powers - 1);
  Vector result(mask.coefficients.size());
  for (std::size_t k = 0; k < mask.powers; ++k)
    for (std::size_t j = 0; j < mask.powers; ++j)
      for (std::size_t i = 0; i < mask.points(); ++i)
        result[j * mask.points() + i] += forms[k][j] * mask.coefficients[k * mask.points() + i];
  return result;
}

/// Bits that hold the coefficients of the determinant of a matrix with these majorants, and their signs.
std::size_t bits_of_determinant(const Vector& majorants, std::size_t n) {
  std::size_t result = 2;
  for (std::size_t i = 0; i < n; ++i) {
    mpz_class sum = 0;
    for (std::size_t j = 0; j < n; ++j) sum += majorants[j * n + i];
    result += bits(sum);
  }
  return result;
}

/// The coefficients of a form of this degree from its value at u = 2^bits, v = 1.
Vector unpack(mpz_class value, std::size_t degree, std::size_t bits, Arithmetic& arithmetic) {
  Vector form;
  for (std::size_t j = 0; j <= degree; ++j) {
    arithmetic.spend(100 + mpz_size(value.get_mpz_t()));
    mpz_class& digit = form.emplace_back();
    mpz_fdiv_r_2exp(digit.get_mpz_t(), value.get_mpz_t(), bits);
    if (mpz_tstbit(digit.get_mpz_t(), bits - 1) != 0) digit -= mpz_class(1) << bits;
    value = (value - digit) >> bits;
  }
  return form;
}

/// The matrix of the forms that `fill(u)` gives: at u = 2^bits, and with moduli at u = 1; their degree is at most that.
/// Returns the coefficients of the determinant, a form of the degree size * degree.
template <class Fill>
Vector determinant_form(std::size_t size, std::size_t degree, Fill fill, Arithmetic& arithmetic) {
  require(size * degree <= max_determinant_degree, too_much_work);
  const std::size_t width = bits_of_determinant(fill(std::size_t{0}), size);
  require((size * degree + 1) * width <= max_determinant_bits / (size * size), too_much_work);
  return unpack(determinant(fill(width), size, arithmetic), size * degree, width, arithmetic);
}

/// Conditions (i): the part with the fewest coefficients and a sum of multiples of the others. With errors all
/// coefficients count, as none is sure to be 0.
void check_resultant(const Vector& forms, std::size_t degree, unsigned arity, const mpq_class& error,
                     Arithmetic& arithmetic) {
  const std::size_t points = forms.size() / (degree + 1);
  struct Part {
    unsigned residue;
    std::size_t first, last;  // of the coefficients that are not zero, as multiples of the arity
  };
  std::vector<Part> parts;
  for (unsigned r = 0; r < arity; ++r) {
    Part part{r, points, 0};
    for (std::size_t i = r; i < points; i += arity)
      for (std::size_t k = 0; k <= degree; ++k)
        if (error > 0 || forms[k * points + i] != 0) part = {r, std::min(part.first, i / arity), i / arity};
    require(part.first <= part.last, "stability: a polyphase part is zero");
    parts.push_back(part);
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Part& a, const Part& b) { return a.last - a.first < b.last - b.first; });
  const std::size_t p_degree = parts[0].last - parts[0].first, q_degree = parts.back().last - parts.back().first,
                    size = p_degree + q_degree;
  // Of the coefficient number i of both; bits 0: the sum of the moduli.
  const auto value = [&](bool of_p, std::size_t i, std::size_t width) {
    mpz_class sum = 0;
    for (std::size_t j = of_p ? 0 : 1; j < (of_p ? 1 : parts.size()); ++j) {
      const std::size_t at = (parts[j].first + i) * arity + parts[j].residue;
      for (std::size_t k = 0; at < points && k <= degree; ++k) {
        const mpz_class term = forms[k * points + at] * (of_p ? 1 : j * j);
        sum += width == 0 ? mpz_class(abs(term)) : mpz_class(term << width * k);
      }
    }
    return sum;
  };
  const auto sylvester = [&](std::size_t width) {
    Vector matrix(size * size);
    for (std::size_t row = 0; row < size; ++row) {
      const bool of_p = row < q_degree;
      const std::size_t shift = of_p ? row : row - q_degree;
      for (std::size_t i = 0; i <= (of_p ? p_degree : q_degree); ++i)
        matrix[(shift + i) * size + row] = value(of_p, i, width);
    }
    return matrix;
  };
  Vector form{1};
  if (error > 0 && size > 0) {
    // Section 7: with fewer digits, which is one more error.
    Vector matrix = sylvester(1);
    std::size_t most = 0;
    for (const mpz_class& entry : matrix) most = std::max(most, bits(entry));
    const std::size_t cut = most - std::min(most, 256 + 16 * size);
    for (mpz_class& entry : matrix) entry >>= cut;
    mpz_class multiples = 1;
    for (std::size_t j = 1; j < parts.size(); ++j) multiples += j * j;
    const mpq_class off = error * multiples / (mpz_class(1) << cut) + (cut > 0 ? 1 : 0);
    const mpq_class change = change_of_product(largest_column_sum({size, matrix, 1}), off * mpz_class(size), size);
    form[0] = abs(determinant(matrix, size, arithmetic)) > change ? 1 : 0;
  } else if (size > 0) {
    form = determinant_form(size, degree, sylvester, arithmetic);
  }
  if (form[0] < 0)
    for (mpz_class& c : form) c = -c;
  check_positive_form(form, "stability: the resultant of the polyphase parts", arithmetic);
}

/// The form that is the sum of the squares of forms: their coefficients of u^k v^(n-k), k = 0, ..., n, one after
/// another.
Vector sum_of_squares(const std::vector<Vector>& forms, Arithmetic& arithmetic) {
  Vector squares(2 * forms.size() - 1);
  for (std::size_t k = 0; k < forms.size(); ++k)
    for (std::size_t l = 0; l < forms.size(); ++l)
      for (std::size_t i = 0; i < forms[k].size(); ++i)
        arithmetic.add_product(squares[k + l], forms[k][i], forms[l][i]);
  return squares;
}

std::vector<std::size_t> primes_of(std::size_t n) {
  std::vector<std::size_t> primes;
  for (std::size_t q = 2; n > 1; ++q) {
    if (n % q != 0) continue;
    primes.push_back(q);
    while (n % q == 0) n /= q;
  }
  return primes;
}

const std::string zeros_on_cycle = "stability: the symbol on a cycle of roots of unity of order ";

/// Rejects a symbol of integers that all Phi_{kd}, d > 1 a divisor of the arity, divide: its products with all
/// 1 - z^(n/q), q | n = kd a prime, modulo z^n - 1.
void check_cyclotomic(const Vector& symbol, std::size_t k, std::size_t arity, Arithmetic& arithmetic) {
  bool divides = true;
  for (std::size_t d = 2; d <= arity; ++d) {
    if (arity % d != 0) continue;
    const std::size_t n = k * d;
    const std::vector<std::size_t> primes = primes_of(n);
    arithmetic.spend((symbol.size() + n * primes.size()) * 50);
    Vector rest(n);
    for (std::size_t i = 0; i < symbol.size(); ++i) rest[i % n] += symbol[i];
    for (const std::size_t q : primes) {
      const Vector old = rest;
      for (std::size_t i = 0; i < n; ++i) rest[(i + n / q) % n] -= old[i];
    }
    divides = divides && std::ranges::all_of(rest, [](const mpz_class& x) { return x == 0; });
  }
  require(!divides, zeros_on_cycle + std::to_string(k) + " is 0");
}

/// Section 6.3: whether a symbol whose coefficients are real numbers may be 0 on a cycle of roots of unity. Forms of
/// this degree, or numbers with errors.
class Cycles {
 public:
  Cycles(const Vector& forms, std::size_t degree, std::size_t arity, const mpq_class& error, Arithmetic& arithmetic)
      : forms_(forms), degree_(degree), arity_(arity), arithmetic_(arithmetic), circle_(256) {
    const std::size_t points = forms.size() / (degree + 1);
    for (std::size_t k = 0; k <= degree; ++k) {
      mpz_class sum = 0;
      for (std::size_t i = 0; i < points; ++i) sum += abs(forms[k * points + i]);
      errors_.push_back((sum * (points - 1)) << 19);
    }
    if (error > 0) least_ = errors_[0] + ceiling(error * circle_.one() * mpz_class(points));
  }

  /// Of a symbol with so many zeros at most where sigma has none.
  void check(std::size_t zeros) {
    std::size_t power = arity_;
    for (std::size_t j = 1; (j == 1 ? 1 : 2 * j) * (arity_ - 1) <= zeros; ++j, power *= arity_) {
      require(power <= max_cycle_order, too_much_work);
      for (const std::size_t n : {power - 1, power + 1})
        for (std::size_t e = 1; 2 * e <= n; ++e)
          if (const std::vector<std::size_t> half = half_cycle(e, n);
              half.size() == j && (2 * e == n ? 1 : 2 * j) * (arity_ - 1) <= zeros)
            check_cycle(half, n);
    }
  }

 private:
  /// e, A e, A^2 e, ... modulo n, up to their signs, if e is the least of these numbers and their negatives.
  std::vector<std::size_t> half_cycle(std::size_t e, std::size_t n) {
    std::vector<std::size_t> result;
    for (std::size_t x = e; result.empty() || (x != e && x != n - e); x = arity_ * x % n) {
      arithmetic_.spend(50);
      if (x < e || n - x < e) return {};
      result.push_back(x);
    }
    return result;
  }

  void check_cycle(const std::vector<std::size_t>& half, std::size_t n) {
    Vector squares(2 * degree_ + 1);
    for (const std::size_t x : half)
      for (std::size_t r = 1; r < arity_; ++r) {
        mpq_class turn = ratio(x, n) + ratio(r, arity_);
        if (turn >= 1) turn -= 1;
        const std::vector<CirclePoint> values = values_at(2 * turn);
        if (least_ > 0 && square_of(values[0], values[0]) > least_ * least_) return;
        for (std::size_t k = 0; k <= degree_; ++k)
          for (std::size_t l = 0; l <= degree_; ++l)
            squares[k + l] += square_of(values[k], values[l]) - above(values[k], k) * errors_[l] -
                              above(values[l], l) * errors_[k];
        if (least_ == 0 && std::ranges::all_of(squares, [](const mpz_class& c) { return c > 0; })) return;
      }
    const std::string what = zeros_on_cycle + std::to_string(n);
    require(least_ == 0, what + " may be 0");
    check_positive_form(squares, what, arithmetic_);
  }

  static mpz_class square_of(const CirclePoint& a, const CirclePoint& b) { return a.re * b.re + a.im * b.im; }
  mpz_class above(const CirclePoint& value, std::size_t k) const { return abs(value.re) + abs(value.im) + errors_[k]; }

  /// The coefficients of the form at exp(i pi y), times W, up to the errors.
  std::vector<CirclePoint> values_at(const mpq_class& y) const {
    const std::size_t points = forms_.size() / (degree_ + 1);
    const std::vector<CirclePoint> powers = circle_.powers(y, points, arithmetic_);
    std::vector<CirclePoint> result;
    for (std::size_t k = 0; k <= degree_; ++k)
      result.push_back(combined({&forms_[k * points], points}, powers, arithmetic_));
    return result;
  }

  const Vector& forms_;
  std::size_t degree_, arity_;
  Arithmetic& arithmetic_;
  Circle circle_;
  Vector errors_;
  mpz_class least_ = 0;  // with errors: a larger modulus, times W, is not that of 0
};

/// The sums of products of two entries of two rows and two columns: the minors, or with +1 what is at least their
/// moduli.
Vector second_compound(const Vector& matrix, std::size_t n, int sign, Arithmetic& arithmetic) {
  Vector result;
  const auto at = [&](std::size_t i, std::size_t j) -> const mpz_class& { return matrix[j * n + i]; };
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t l = j + 1; l < n; ++l)
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = i + 1; k < n; ++k) {
          mpz_class& minor = result.emplace_back();
          arithmetic.add_product(minor, at(i, j), at(k, l));
          arithmetic.add_product(minor, at(i, l), sign * at(k, j));
        }
  return result;
}

}  // namespace

Range parse_range(std::string_view text) {
  constexpr const char* expected = "a range is w=LOW..HIGH with rationals LOW < HIGH";
  const std::size_t dots = text.find("..");
  require(dots != text.npos && text[1] == '=', expected);
  const char letter = text[0];
  require((letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z'), expected);
  Range range{letter, parse_rational(text.substr(2, dots - 2)), parse_rational(text.substr(dots + 2))};
  require(range.low < range.high, expected);
  return range;
}

Controls control_family(const Family& powers, const Vector& divisor, const Range& range, Arithmetic& arithmetic) {
  const std::size_t degree = divisor.size() - 1, square = powers.size * powers.size,
                    count = powers.count() / (degree + 1);
  const std::vector<Vector> forms = power_forms(range, degree);
  Vector weights = divisor_form(divisor, forms);
  Rationals entries;
  arithmetic.spend(count * square * (degree + 1) * 1000);
  for (std::size_t t = 0; t < count; ++t)
    for (std::size_t j = 0; j <= degree; ++j) {
      require(sgn(weights[j]) * sgn(weights[0]) > 0, "the denominator of the mask changes its sign, or may do so");
      for (std::size_t i = 0; i < square; ++i) {
        mpz_class sum = 0;
        for (std::size_t k = 0; k <= degree; ++k)
          arithmetic.add_product(sum, forms[k][j], powers.entries[(t * (degree + 1) + k) * square + i]);
        entries.push_back(ratio(sum, weights[j] * powers.denominator));
      }
    }
  mpz_class common = 0;
  for (const mpz_class& weight : weights) common = gcd(common, weight);
  for (mpz_class& weight : weights) weight = abs(weight) / common;
  return {clear_denominators(powers.size, entries), std::move(weights)};
}

void check_stability(const Mask& mask, unsigned arity, std::size_t sum_rules, const Range& range,
                     const mpq_class& error, Arithmetic& arithmetic) {
  const std::size_t degree = mask.powers - 1, points = mask.points();
  Vector divisor = divisor_form(mask.divisor, power_forms(range, degree));
  if (divisor[0] < 0)
    for (mpz_class& c : divisor) c = -c;
  check_positive_form(divisor, "the denominator of the mask", arithmetic);
  const Vector forms = coefficient_forms(mask, range);
  if (degree > 0 || error > 0) {
    check_resultant(forms, degree, arity, error, arithmetic);
    const std::size_t taken = sum_rules * (arity - 1) + 1;
    if (points > taken) Cycles(forms, degree, arity, error, arithmetic).check(points - taken);
    return;
  }
  check_no_leading_factors(mask, arity);
  for (std::size_t k = 2; k * arity < 6 * points; ++k) {
    if (std::gcd(k, std::size_t{arity}) != 1) continue;
    std::size_t totient = k * arity;
    for (const std::size_t q : primes_of(totient)) totient -= totient / q;
    if (totient < points) check_cyclotomic(mask.coefficients, k, arity, arithmetic);
  }
}

void check_full_sum_rules(const Family& powers, std::size_t degree, const Range& range, Arithmetic& arithmetic) {
  const std::vector<Vector> forms = power_forms(range, degree);
  const std::size_t arity = powers.count() / (degree + 1);
  // The first columns hold the coefficients of the classes.
  const auto class_sum = [&](std::size_t t, std::size_t k) {
    const auto column = powers.matrix(t * (degree + 1) + k).first(powers.size);
    return std::accumulate(column.begin(), column.end(), mpz_class(0));
  };
  std::vector<Vector> differences(degree + 1, Vector(arity));
  for (std::size_t k = 0; k <= degree; ++k)
    for (std::size_t t = 0; t < arity; ++t)
      for (std::size_t j = 0; j <= degree; ++j)
        arithmetic.add_product(differences[j][t], forms[k][j], class_sum(t, k) - class_sum(0, k));
  check_positive_form(sum_of_squares(differences, arithmetic), "sum-rules full: what one more sum rule would make 0,",
                      arithmetic);
}

void check_eigenvalue(const Family& family, const Vector& weights, const std::vector<std::size_t>& letters,
                      const mpq_class& re, const mpq_class& im, Arithmetic& arithmetic) {
  const bool is_pair = im != 0;
  require((re == 0) == is_pair, "over a range either the real or the imaginary part of the eigenvalue is 0");
  const std::size_t n = family.size, length = letters.size(), factors = is_pair ? 2 * length : length;
  const std::size_t degree = weights.size() - 1;
  const std::size_t size = is_pair ? n * (n - 1) / 2 : n;
  require(size > 0, "a pair of eigenvalues needs matrices of size 2");
  require(size <= 256, too_much_work);
  // The bound of the eigenvalue, and the power of the denominator that belongs to it.
  const mpq_class bound = is_pair ? mpq_class(im * im) : mpq_class(abs(re));
  const mpz_class whole = bound.get_num() * power(family.denominator, factors).get_num();
  const auto fill = [&](std::size_t width) {
    const bool exact = width > 0;
    const auto matrix = [&](std::size_t t) {
      Vector sum(n * n);
      for (std::size_t j = 0; j <= degree; ++j) {
        const auto control = family.matrix(t * (degree + 1) + j);
        for (std::size_t i = 0; i < n * n; ++i) {
          const mpz_class term = control[i] * weights[j];
          sum[i] += exact ? mpz_class(term << width * j) : mpz_class(abs(term));
        }
      }
      arithmetic.spend(n * n * (degree + 1) * (100 + width * degree / 64));
      return sum;
    };
    Vector product(n * n);
    for (std::size_t i = 0; i < n; ++i) product[i * n + i] = 1;
    for (std::size_t i = length; i-- > 0;) product = arithmetic.multiply(matrix(letters[i]), product, n);
    if (is_pair) product = second_compound(product, n, exact ? -1 : 1, arithmetic);
    for (mpz_class& x : product) x *= exact && (is_pair || re > 0) ? -bound.get_den() : bound.get_den();
    mpz_class one = 0;
    for (std::size_t j = 0; j <= degree; ++j) one += weights[j] << width * j;
    const mpz_class diagonal = whole * power(one, factors).get_num();
    for (std::size_t i = 0; i < size; ++i) product[i * size + i] += diagonal;
    return product;
  };
  Vector form = determinant_form(size, degree * factors, fill, arithmetic);
  for (mpz_class& c : form) c = -c;
  check_positive_form(form, "the characteristic polynomial of the product, with the other sign,", arithmetic);
}

}  // namespace subcert_check
