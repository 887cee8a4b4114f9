#include "kept_data.hpp"

#include <algorithm>

namespace subcert_check {
namespace {

/// Modulo the prime.
std::size_t rank_of(const Transition& operators, const std::vector<Vector>& rows) {
  const Elimination modulo(operators, true);
  std::vector<Row> span;
  for (const Vector& row : rows) {
    Sequence one;
    for (std::size_t c = 0; c < row.size(); ++c)
      if (row[c] != 0) operators.entry(one, {{}, c}) = row[c];
    modulo.add(span, std::move(one));
  }
  return span.size();
}

}  // namespace

bool annihilates(const Transition& operators, const Sequence& x, const std::vector<Rationals>& data) {
  const std::size_t order = data.size();
  std::vector<Rationals> moments(order, Rationals(operators.components()));  // of (-k)^t / t!
  for (const auto& [place, value] : x) {
    mpq_class term = value;
    for (std::size_t t = 0; t < order; term *= ratio(-place.point[0], ++t)) {
      operators.arithmetic().spend(500 + 10 * bits(term.get_num()));
      moments[t][place.component] += term;
    }
  }
  for (std::size_t l = 0; l < order; ++l) {
    mpq_class sum = 0;
    for (std::size_t s = 0; s <= l; ++s)
      for (std::size_t c = 0; c < operators.components(); ++c) sum += data[s][c] * moments[l - s][c];
    if (sum != 0) return false;
  }
  return true;
}

std::vector<Rationals> multiples(std::vector<Rationals> data, const mpz_class& root) {
  for (Rationals& y : data) {
    const auto half = static_cast<std::ptrdiff_t>(y.size() / 2);
    std::rotate(y.begin(), y.begin() + half, y.end());
    std::for_each(y.begin() + half, y.end(), [&](mpq_class& q) { q *= root; });
  }
  return data;
}

void check_all_kept(const Transition& operators, const std::vector<Rationals>& kept) {
  const std::size_t size = operators.components();
  std::vector<Vector> equations(operators.classes() * size, Vector(size));
  for (const auto& [place, value] : operators.mask())
    equations[operators.digit_of(place.point) * size + place.component % size][place.component / size] += value;
  for (std::size_t i = 0; i < equations.size(); ++i) equations[i][i % size] -= operators.denominator();
  std::vector<Vector> given;
  for (const Rationals& y : kept) {
    given.push_back(clear_denominators(1, y).entries);
    for (const Vector& equation : equations) {
      mpz_class sum = 0;
      for (std::size_t c = 0; c < size; ++c) operators.arithmetic().add_product(sum, equation[c], given.back()[c]);
      require(sum == 0, "the scheme does not keep a line 'fixed'");
    }
  }
  require(rank_of(operators, given) == kept.size(), "the lines 'fixed' are not independent");
  require(rank_of(operators, equations) + kept.size() >= size, "the scheme may keep more constant data");
}

}  // namespace subcert_check
