#include "field.hpp"

#include "blocks.hpp"

#include <algorithm>

namespace subcert_check {
namespace {

const mpz_class most_root = 1'000'000'000;
constexpr std::size_t max_entries = 2'500;  // of a mask

/// Of matrices P + sqrt(root) Q, each column by column.
struct FieldMatrix {
  Vector p, q;
};

FieldMatrix product(const FieldMatrix& a, const FieldMatrix& b, const mpz_class& root, std::size_t size,
                    Arithmetic& arithmetic) {
  FieldMatrix result{arithmetic.multiply(a.p, b.p, size), arithmetic.multiply(a.p, b.q, size)};
  const Vector both = arithmetic.multiply(a.q, b.q, size), mixed = arithmetic.multiply(a.q, b.p, size);
  for (std::size_t i = 0; i < both.size(); ++i) {
    arithmetic.add_product(result.p[i], both[i], root);
    result.q[i] += mixed[i];
  }
  return result;
}

FieldMatrix matrix_of(const FieldFamily& family, std::size_t t) {
  const auto p = family.rational.matrix(t), q = family.multiples.matrix(t);
  return {{p.begin(), p.end()}, {q.begin(), q.end()}};
}

/// Rows of twice as many numbers as they have places: the p, and then the q.
FieldFamily read_matrix(const std::string& head, std::size_t size, const mpz_class& root, Reader& reader) {
  Rationals values(2 * size * size);
  for (std::size_t i = 0; i < size; ++i) {
    const Fields row = reader.take(head, 2 * size, 2 * size);
    for (std::size_t k = 0; k < size; ++k) {
      values[k * size + i] = parse_rational(row[k]);
      values[(size + k) * size + i] = parse_rational(row[size + k]);
    }
  }
  return field_family(size, values, root);
}

}  // namespace

bool FieldFamily::is_rational() const {
  return std::ranges::all_of(multiples.entries, [](const mpz_class& x) { return x == 0; });
}

bool FieldFamily::is_mirrored() const {
  return std::ranges::all_of(std::vector{&rational.entries, &multiples.entries},
                             [](const Vector* x) { return std::equal(x->begin(), x->end(), x->rbegin()); });
}

void FieldFamily::transpose() {
  rational.transpose();
  multiples.transpose();
}

Family FieldFamily::on_halves() const {
  Family result{2 * size(), {}, rational.denominator};
  for (std::size_t t = 0; t < rational.count(); ++t) {
    const auto p = rational.matrix(t), q = multiples.matrix(t);
    for (const bool of_multiples : {false, true})
      for (std::size_t k = 0; k < size(); ++k)
        for (std::size_t i = 0; i < 2 * size(); ++i) {
          const bool upper = i < size();
          const mpz_class& entry = upper == of_multiples ? q[k * size() + i % size()] : p[k * size() + i % size()];
          result.entries.push_back(upper && of_multiples ? mpz_class(entry * root) : entry);
        }
  }
  return result;
}

Vector FieldFamily::image(std::size_t letter, const Vector& x, Arithmetic& arithmetic) const {
  const auto half = x.begin() + static_cast<std::ptrdiff_t>(size());
  const FieldMatrix moved = product(matrix_of(*this, letter), {{x.begin(), half}, {half, x.end()}}, root, size(),
                                    arithmetic);
  Vector result = moved.p;
  result.insert(result.end(), moved.q.begin(), moved.q.end());
  return result;
}

mpz_class scaled_root(const mpz_class& root) { return sqrt(mpz_class(root << 2 * root_bits)); }

NearFamily near_family(const FieldFamily& family) {
  if (family.is_rational()) return {family.rational, 0};
  const mpz_class one = mpz_class(1) << root_bits, near = scaled_root(family.root);
  NearFamily result{family.rational, 0};
  result.family.denominator *= one;
  mpz_class largest = 0;
  for (std::size_t i = 0; i < family.rational.entries.size(); ++i) {
    const mpz_class& q = family.multiples.entries[i];
    result.family.entries[i] = family.rational.entries[i] * one + q * near;
    largest = std::max(largest, mpz_class(abs(q)));
  }
  result.error = ratio(largest, result.family.denominator);
  return result;
}

FieldFamily field_family(std::size_t size, const Rationals& values, const mpz_class& root) {
  const Family both = clear_denominators(size, values);
  const auto half = both.entries.begin() + static_cast<std::ptrdiff_t>(both.entries.size() / 2);
  return {{size, {both.entries.begin(), half}, both.denominator},
          {size, {half, both.entries.end()}, both.denominator},
          root};
}

std::pair<std::vector<FieldFamily>, std::size_t> read_field_blocks(const FieldFamily& family,
                                                                   const Component& component, Reader& reader,
                                                                   Arithmetic& arithmetic) {
  const std::size_t n = family.size(), count = family.rational.count();
  const std::vector<std::size_t> sizes = read_block_sizes(n, reader);
  const std::size_t unobservable = unobservable_blocks(sizes, component);
  const FieldFamily basis = read_matrix("basis", n, family.root, reader);
  check_unobservable(component, basis.on_halves().entries, 2 * n, arithmetic);
  const FieldFamily inverse = read_matrix("inverse", n, family.root, reader);
  const FieldMatrix columns = matrix_of(basis, 0), rows = matrix_of(inverse, 0);
  const mpz_class denominator = basis.rational.denominator * inverse.rational.denominator;
  const FieldMatrix unit = product(columns, rows, family.root, n, arithmetic);
  for (std::size_t i = 0; i < n * n; ++i)
    require(unit.p[i] == (i % (n + 1) == 0 ? denominator : mpz_class(0)) && unit.q[i] == 0,
            "basis times inverse is not the unit matrix");
  std::vector<Rationals> entries(sizes.size()), multiples(sizes.size());
  for (std::size_t t = 0; t < count; ++t) {
    const FieldMatrix images = product(matrix_of(family, t), columns, family.root, n, arithmetic),
                      triangular = product(rows, images, family.root, n, arithmetic);
    for (std::size_t block = 0, start = 0; block < sizes.size(); start += sizes[block++])
      for (std::size_t k = start; k < start + sizes[block]; ++k)
        for (std::size_t j = start; j < n; ++j) {
          const mpz_class &p = triangular.p[k * n + j], &q = triangular.q[k * n + j];
          const bool inside = j < start + sizes[block];
          require(inside || (p == 0 && q == 0), "not block upper triangular");
          if (!inside) continue;
          entries[block].push_back(ratio(p, family.rational.denominator * denominator));
          multiples[block].push_back(ratio(q, family.rational.denominator * denominator));
        }
  }
  std::vector<FieldFamily> blocks;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    entries[i].insert(entries[i].end(), multiples[i].begin(), multiples[i].end());
    blocks.push_back(field_family(sizes[i], entries[i], family.root));
  }
  return {std::move(blocks), unobservable};
}

namespace {

constexpr std::string_view root_begins = "sqrt(";
constexpr char root_letter = 'w';  // in its place
constexpr const char* one_root = "square roots in a mask are sqrt(R) with one number R, 2 <= R <= 10^9, no square";

/// With a letter in place of the root, of which sums of terms are polynomials.
std::string with_letter(std::string_view text, const mpz_class& root) {
  require(text.find_first_of("w^") == text.npos && text.find("/(") == text.npos, one_root);
  const std::string whole = std::string(root_begins) + root.get_str() + ")";
  std::string polynomials(text);
  for (std::size_t at = 0; (at = polynomials.find(whole, at)) != std::string::npos; ++at)
    polynomials.replace(at, whole.size(), 1, root_letter);
  require(!has_root(polynomials), one_root);
  return polynomials;
}

}  // namespace

bool has_root(std::string_view text) { return text.find(root_begins) != text.npos; }

mpz_class parse_root(std::string_view text) {
  const std::size_t begin = text.find(root_begins) + root_begins.size(), end = text.find(')', begin);
  require(end != text.npos, one_root);
  mpz_class root = parse_integer(text.substr(begin, end - begin));
  require(root >= 2 && root <= most_root && !mpz_perfect_square_p(root.get_mpz_t()), one_root);
  return root;
}

Rationals parse_field_numbers(std::string_view text, const mpz_class& root) {
  const std::string polynomials = with_letter(text, root);
  Rationals result, multiples;
  for (const std::string_view number : split(polynomials, ",")) {
    Rationals parts = parse_polynomial(number, root_letter);
    require(parts.size() <= 2, one_root);
    parts.resize(2);
    result.push_back(parts[0]);
    multiples.push_back(parts[1]);
  }
  result.insert(result.end(), multiples.begin(), multiples.end());
  return result;
}

FieldMask parse_field_mask(std::string_view text, const mpz_class& root) {
  FieldMask result{parse_matrix_mask(with_letter(text, root), root_letter), root};
  Mask& mask = result.doubled;
  const std::size_t r = mask.components, matrices = mask.points() / (r * r);
  require(mask.powers <= 2, one_root);
  require(mask.points() <= max_entries, "a mask with too many coefficients");
  Vector doubled(4 * mask.points());
  for (std::size_t m = 0; m < matrices; ++m)
    for (std::size_t i = 0; i < r; ++i)
      for (std::size_t k = 0; k < r; ++k) {
        const std::size_t from = (m * r + i) * r + k;
        const mpz_class& p = mask.coefficients[from];
        const mpz_class q = mask.powers == 2 ? mask.coefficients[mask.points() + from] : mpz_class(0);
        const auto entry = [&](std::size_t row, std::size_t column) -> mpz_class& {
          return doubled[(m * 2 * r + row) * 2 * r + column];
        };
        entry(i, k) = entry(r + i, r + k) = p;
        entry(i, r + k) = q * result.root;
        entry(r + i, k) = q;
      }
  mask.coefficients = std::move(doubled);
  mask.components = 2 * r;
  mask.powers = 1;
  mask.divisor = {1};
  return result;
}

}  // namespace subcert_check
