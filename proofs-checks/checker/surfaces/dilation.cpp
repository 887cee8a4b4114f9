#include "dilation.hpp"

namespace subcert_check {
namespace {

constexpr std::int64_t max_entry = 64, max_turn = 1000;

/// Section 5.1: M is similar to a multiple of an orthogonal matrix, and |det M| > 1.
bool expands_isotropically(const Dilation& dilation) {
  const auto& m = dilation.rows;
  const std::size_t s = dilation.variables;
  std::int64_t trace = 0, minors = 0;  // the characteristic polynomial is x^s - trace x^(s-1) + minors x^(s-2) - ...
  for (std::size_t i = 0; i < s; ++i) {
    trace += m[i][i];
    for (std::size_t j = 0; j < i; ++j) minors += m[i][i] * m[j][j] - m[i][j] * m[j][i];
  }
  // Whether a M^2 = b times the unit matrix.
  const auto square_is = [&](std::int64_t a, std::int64_t b) {
    for (std::size_t i = 0; i < s; ++i)
      for (std::size_t j = 0; j < s; ++j) {
        std::int64_t entry = 0;
        for (std::size_t k = 0; k < s; ++k) entry += m[i][k] * m[k][j];
        if (a * entry != (i == j ? b : 0)) return false;
      }
    return true;
  };
  const std::int64_t det = determinant(m);
  if (std::abs(det) < 2) return false;
  if (s == 2) return trace * trace < 4 * det || square_is(1, std::abs(det));
  return s == 1 || (minors * minors * minors == det * trace * trace * trace &&
                    (trace == 0 || std::abs(trace * trace - minors) < 2 * std::abs(minors) ||
                     square_is(trace * trace, minors * minors)));
}

}  // namespace

Point combine(const Point& a, std::int64_t factor, const Point& b) {
  Point result;
  for (std::size_t v = 0; v < 3; ++v) {
    result[v] = a[v] + factor * b[v];
    require(std::abs(result[v]) <= max_distance, "a lattice point is too far away");
  }
  return result;
}

Point parse_point(std::string_view text, std::size_t variables, std::int64_t limit) {
  const Fields fields = split(text, ",");
  require(fields.size() == variables, "a point with another number of coordinates");
  Point point{};
  for (std::size_t v = 0; v < variables; ++v) {
    const mpz_class coordinate = parse_integer(fields[v]);
    require(abs(coordinate) <= limit, "a coordinate is too large");
    point[v] = coordinate.get_si();
  }
  return point;
}

std::int64_t determinant(const Matrix& m) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    sum += m[0][i] * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3]);
  return sum;
}

Matrix adjugate(const Matrix& m) {
  Matrix result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      result[i][j] = m[(j + 1) % 3][(i + 1) % 3] * m[(j + 2) % 3][(i + 2) % 3] -
                     m[(j + 1) % 3][(i + 2) % 3] * m[(j + 2) % 3][(i + 1) % 3];
  return result;
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) result[i] = combine(result[i], a[i][k], b[k]);
  return result;
}

/// a b^-1, which must have integer entries.
Matrix quotient(const Matrix& a, const Matrix& b) {
  Matrix result = product(a, adjugate(b));
  for (Point& row : result)
    for (std::int64_t& entry : row) {
      require(entry % determinant(b) == 0, "the turned dilation is no integer multiple of the dilation");
      entry /= determinant(b);
      require(std::abs(entry) <= max_turn, "the dilation is not turned by symmetries");
    }
  return result;
}

unsigned classes(const Dilation& dilation) {
  require(expands_isotropically(dilation), "the dilation is not isotropic and expanding");
  return static_cast<unsigned>(std::abs(determinant(dilation.rows)));
}

Dilation parse_dilation(std::string_view text) {
  const std::size_t size = split(text, ";").size();
  require(size <= 3 && text.starts_with('[') && text.ends_with(']'), "a dilation is [1,2;-2,-1]");
  Dilation dilation{size};
  const Fields rows = split(text.substr(1, text.size() - 2), ";");
  for (std::size_t i = 0; i < size; ++i) dilation.rows[i] = parse_point(rows[i], size, max_entry);
  return dilation;
}

}  // namespace subcert_check
