#include "graph_prover.hpp"

#include <subcert/analysis/symbol/matrices/ball_matrix.hpp>

#include <algorithm>

namespace subcert::quadratic {
namespace {

constexpr slong eigenvector_bits = 512, bits_per_letter = 16;
constexpr int most_halvings = 40;  // of 1 - kept

/// A row with a bound for the sum of the moduli of real and imaginary parts of
/// its error.
struct Row {
  ComplexVector entries;
  Rational error;
};

/// The left eigenvector of the product, and the modulus of the eigenvalue.
struct LeftEigenpair {
  Row row;
  Enclosure modulus = Enclosure::at_least(0);
};

std::optional<LeftEigenpair> left_eigenpair(const RationalMatrix& product, const RationalComplex& eigenvalue,
                                            slong bits) {
  if (eigenvalue.squared_modulus() == 0) return std::nullopt;
  const auto pair = enclose_eigenpair(transposed(product), eigenvalue, bits);
  if (!pair) return std::nullopt;
  LeftEigenpair result{{}, abs(pair->value).enclosure()};
  const auto middle = [&](const Enclosure& part) {
    result.row.error += (*part.upper - *part.lower) / 2;
    return Rational((*part.upper + *part.lower) / 2);
  };
  for (const ComplexBall& entry : pair->vector)
    result.row.entries.push_back({middle(entry.real().enclosure()), middle(imaginary_part(entry).enclosure())});
  return result;
}

/// Adds the form factor (|row x|^2 + more |x|^2).
void add_squares(RationalMatrix& form, const Rational& factor, const ComplexVector& row, const Rational& more) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    for (std::size_t j = 0; j < row.size(); ++j) form(i, j) += factor * (row[i].re * row[j].re + row[i].im * row[j].im);
    form(i, i) += factor * more;
  }
}

RationalMatrix to_matrix(const Integers& coordinates, std::size_t n) {
  RationalMatrix result(n, n);
  for (std::size_t i = 0; i < n * n; ++i) result(i / n, i % n) = coordinates[i];
  return result;
}

/// The largest |row x|^2 / scale of all x with |L x| = 1.
double largest_square(const ComplexVector& row, const Integers& coordinates, const Rational& scale) {
  const std::size_t n = row.size();
  // Doubles hold neither of them, perhaps.
  const Rational unit = power(Rational(2), -binary_exponent(one_norm(row)));
  ComplexVector y;
  for (const RationalComplex& entry : row) y.push_back(unit * entry);
  double re = 0, im = 0, mixed = 0;
  for (std::size_t j = n; j-- > 0;) {
    for (std::size_t k = j + 1; k < n; ++k) y[j] += Rational(-coordinates[k * n + j]) * y[k];
    y[j] = 1 / Rational(coordinates[j * n + j]) * y[j];
    const double a = y[j].re.convert_to<double>(), b = y[j].im.convert_to<double>();
    re += a * a;
    im += b * b;
    mixed += a * b;
  }
  return (re + im + std::hypot(re - im, 2 * mixed)) / 2 / Rational(unit * unit * scale).convert_to<double>();
}

/// With 512 binary digits.
Rational rounded(const Rational& value, Rounding rounding) {
  constexpr long bits = 512;
  return to_multiple(value, power(Rational(2), binary_exponent(value) - bits), rounding);
}

}  // namespace

std::optional<KeptCycle> prove_kept_cycle(const MatrixFamily& family, const std::vector<int>& product,
                                          const RationalComplex& eigenvalue, std::span<const Integers> coordinates,
                                          const Rational& bound) {
  const std::size_t n = family.size(), length = product.size();
  const auto pair = left_eigenpair(family.product(product), eigenvalue,
                                   eigenvector_bits + bits_per_letter * static_cast<slong>(length));
  if (!pair || !(*pair->modulus.lower > 0)) return std::nullopt;
  KeptCycle result;
  const int degree = static_cast<int>(length);
  result.radius = {root_enclosure(*pair->modulus.lower, degree).lower,
                   root_enclosure(*pair->modulus.upper, degree).upper};
  const Rational &low = *result.radius.lower, &high = *result.radius.upper;
  if (bound > low) return std::nullopt;

  std::vector<Row> rows{pair->row};
  std::vector<RationalMatrix> forms, images;  // |L x|^2 and |L A x|^2
  for (std::size_t i = 0; i < length; ++i) {
    const RationalMatrix &letter = family[static_cast<std::size_t>(product[i])], letter_transposed = transposed(letter),
                         triangle = to_matrix(coordinates[i], n), image = triangle * letter;
    rows.push_back({letter_transposed * rows[i].entries, rows[i].error * one_norm(letter_transposed)});
    forms.push_back(transposed(triangle) * triangle);
    images.push_back(transposed(image) * image);
  }
  const ComplexVector& first = rows[0].entries;
  const auto size = [](const RationalComplex& x) { return x.squared_modulus(); };
  result.coordinate = static_cast<std::size_t>(std::ranges::max_element(first, {}, size) - first.begin());
  const Rational square = size(first[result.coordinate]),
                 off = 2 * one_norm({first[result.coordinate]}) * rows[0].error, least = square - off,
                 most = square + off + rows[0].error * rows[0].error;
  if (!(least > 0)) return std::nullopt;

  const double ratio = Rational(low / bound).convert_to<double>();
  double largest = 0;
  for (std::size_t i = 0; i < length; ++i)
    largest = std::max(largest,
                       largest_square(rows[i].entries, coordinates[i], least * power(low, 2 * static_cast<long>(i))));
  const double scale = (1 + ratio) / 2 / std::sqrt(largest);
  if (!(scale > 0) || !std::isfinite(scale)) return std::nullopt;
  result.scale = Rational(scale);
  const auto error_of = [](const Row& row) { return Rational(2 * one_norm(row.entries) * row.error); };
  // The two matrices of SPEC.md, 4.14, for the letter i.
  const auto is_small = [&](std::size_t i) {
    const Rational factor = power(result.scale, 2) / (least * power(low, 2 * static_cast<long>(i)));
    RationalMatrix rest = power(low / bound, 2) * forms[i];
    add_squares(rest, -rounded(factor, Rounding::up), rows[i].entries,
                error_of(rows[i]) + rows[i].error * rows[i].error);
    return is_positive(rest);
  };
  const auto is_kept = [&](std::size_t i) {
    const Rational factor = power(result.scale, 2) / (most * power(high, 2 * static_cast<long>(i)));
    RationalMatrix rest = result.kept * low * low * forms[(i + 1) % length];
    add_squares(rest, (1 - result.kept) * rounded(factor, Rounding::down), rows[i + 1].entries, -error_of(rows[i + 1]));
    for (std::size_t k = 0; k < n * n; ++k) rest(k / n, k % n) -= images[i](k / n, k % n);
    return is_positive(rest);
  };
  const auto all = [&](const auto& holds) {
    for (std::size_t i = 0; i < length; ++i)
      if (!holds(i)) return false;
    return true;
  };
  if (!all(is_small)) return std::nullopt;
  for (int k = 1; k <= most_halvings; ++k) {
    result.kept = 1 - power(Rational(2), -k);
    if (all(is_kept)) return result;
  }
  return std::nullopt;
}

}  // namespace subcert::quadratic
