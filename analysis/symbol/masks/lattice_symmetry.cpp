#include "lattice_symmetry.hpp"

#include <algorithm>
#include <map>

namespace subcert {
namespace {

using Rows = std::vector<LatticePoint>;

long determinant(const Rows& rows) {
  if (rows.size() == 1) return rows[0][0];
  long sum = 0;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    Rows minor(rows.begin() + 1, rows.end());
    for (LatticePoint& row : minor) row.erase(row.begin() + static_cast<std::ptrdiff_t>(j));
    if (rows[0][j] != 0) sum += (j % 2 == 0 ? rows[0][j] : -rows[0][j]) * determinant(minor);
  }
  return sum;
}

/// All matrices with entries -1, 0, 1, the identity first.
std::vector<Rows> candidates(std::size_t size) {
  Rows identity(size, LatticePoint(size, 0)), at(size, LatticePoint(size, -1));
  for (std::size_t i = 0; i < size; ++i) identity[i][i] = 1;
  std::vector<Rows> result{identity};
  for (;;) {
    if (at != identity) result.push_back(at);
    std::size_t entry = 0;
    for (; entry < size * size; ++entry) {
      long& value = at[entry / size][entry % size];
      if (++value <= 1) break;
      value = -1;
    }
    if (entry == size * size) return result;
  }
}

}  // namespace

LatticePoint LatticeMap::operator()(const LatticePoint& point) const { return times(linear, point) + shift; }

std::vector<LatticeMap> lattice_symmetries(const MultivariatePolynomial& p) {
  const auto variables = static_cast<std::size_t>(p.variables());
  std::map<LatticePoint, Rational> coefficients;
  std::vector<Rational> moment(variables, 0);
  Rational sum = 0;
  for (const auto& term : p.terms()) {
    coefficients.emplace(term.exponents, term.coefficient);
    sum += term.coefficient;
    for (std::size_t v = 0; v < variables; ++v) moment[v] += term.coefficient * term.exponents[v];
  }
  std::vector<LatticeMap> result;
  for (const Rows& linear : candidates(variables)) {
    if (std::abs(determinant(linear)) != 1) continue;
    // The centre of mass stays where it is.
    LatticeMap map{linear, LatticePoint(variables, 0)};
    bool keeps = true;
    for (std::size_t i = 0; i < variables && keeps; ++i) {
      Rational shift = moment[i];
      for (std::size_t j = 0; j < variables; ++j) shift -= linear[i][j] * moment[j];
      shift /= sum;
      keeps = denominator(shift) == 1;
      if (keeps) map.shift[i] = numerator(shift).convert_to<long>();
    }
    for (auto entry = coefficients.begin(); keeps && entry != coefficients.end(); ++entry) {
      const auto image = coefficients.find(map(entry->first));
      keeps = image != coefficients.end() && image->second == entry->second;
    }
    if (!keeps) continue;
    result.push_back(std::move(map));
  }
  return result;
}

std::vector<LatticeMap> symmetries_along(std::vector<LatticeMap> group, const Dilation& dilation) {
  // G' with G' M = M G.
  const auto conjugate_is_there = [&](const LatticeMap& map) {
    const Rows goal = times(dilation.rows(), map.linear);
    return std::any_of(group.begin(), group.end(),
                       [&](const LatticeMap& other) { return times(other.linear, dilation.rows()) == goal; });
  };
  for (std::size_t before = 0; before != group.size();) {
    before = group.size();
    std::vector<LatticeMap> kept;
    std::copy_if(group.begin(), group.end(), std::back_inserter(kept), conjugate_is_there);
    group = std::move(kept);
  }
  return group;
}

}  // namespace subcert
