#include "edge_orbit.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/rational_matrix.hpp>

#include <algorithm>

namespace subcert::piecewise {
namespace {

constexpr int search_steps = 24;    // after which the pieces of a patch have settled, if they do
constexpr int positive_levels = 8;  // in which positive values in a row are looked for

Rational value_at(const Row& form, const std::vector<Rational>& x) {
  Rational sum = 0;
  for (std::size_t r = 0; r < x.size(); ++r)
    if (x[r] != 0) sum += form[r] * x[r];
  return sum;
}

const Piece& piece_of(const Rule& rule, const std::vector<Rational>& window) {
  for (const Piece& piece : rule.pieces)
    if (std::all_of(piece.cell.begin(), piece.cell.end(), [&](const Row& row) { return value_at(row, window) >= 0; }))
      return piece;
  fail(ErrorKind::domain, "edge orbit: need a rule whose pieces cover all data");
}

/// What zeros and a patch determine, with the first value that is not zero in front: values and, as forms in the patch,
/// the pieces in which they are.
struct Next {
  std::vector<Rational> values;
  std::vector<Row> forms;
};

Next evolved(const Rule& rule, const std::vector<Rational>& patch) {
  Next next;
  for (std::size_t known = 1; known <= patch.size(); ++known) {
    std::vector<Rational> window(rule.points, 0);
    for (std::size_t r = 0; r < rule.points; ++r)
      if (r + known >= rule.points) window[r] = patch[r + known - rule.points];
    for (const Row& output : piece_of(rule, window).outputs) {
      const Rational value = value_at(output, window);
      if (next.values.empty() && value == 0) continue;
      next.values.push_back(value);
      Row form(patch.size(), 0);
      for (std::size_t r = 0; r < rule.points; ++r)
        if (r + known >= rule.points) form[r + known - rule.points] = output[r];
      next.forms.push_back(std::move(form));
    }
  }
  return next;
}

/// To 40 bits, so that numbers stay short in the search.
Rational rounded(const Rational& value) {
  const Rational unit = power(Rational(2), 40);
  return Rational(to_integer(value * unit, Rounding::nearest)) / unit;
}

bool is_orbit(const Rule& rule, const EdgeOrbit& orbit) {
  const std::vector<Rational> next = evolved(rule, orbit.values).values;
  if (next.size() <= orbit.values.size() || orbit.factor <= 0 || orbit.factor >= 1) return false;
  for (std::size_t i = 0; i < orbit.values.size(); ++i)
    if (next[i] != orbit.factor * orbit.values[i]) return false;
  return true;
}

bool becomes_positive(const Rule& rule, std::vector<Rational> patch) {
  for (int level = 0; level < positive_levels && patch.size() < 40 * rule.points; ++level) {
    std::size_t in_a_row = 0;
    for (const Rational& value : patch) {
      in_a_row = value > 0 ? in_a_row + 1 : 0;
      if (in_a_row == 2 * rule.points - 2) return true;
    }
    patch = evolved(rule, patch).values;
  }
  return false;
}

/// The eigenvector of the pieces in which a patch is, if its eigenvalue is the rational number near this one.
std::optional<EdgeOrbit> read_off(const Rule& rule, const std::vector<Rational>& patch, const Rational& near) {
  const Next next = evolved(rule, patch);
  const Rational width(1, 1'000'000);
  const Rational factor = simplest_between(near - width, near + width);
  RationalMatrix matrix(patch.size(), patch.size());
  for (std::size_t i = 0; i < patch.size(); ++i)
    for (std::size_t j = 0; j < patch.size(); ++j) matrix(i, j) = next.forms[i][j] - (i == j ? factor : Rational(0));
  for (const std::vector<Rational>& vector : kernel(matrix)) {
    if (vector[0] == 0) continue;
    EdgeOrbit orbit{{}, factor};
    for (const Rational& value : vector) orbit.values.push_back(value / vector[0]);
    if (is_orbit(rule, orbit) && becomes_positive(rule, orbit.values)) return orbit;
  }
  return std::nullopt;
}

std::optional<EdgeOrbit> orbit_from(const Rule& rule, std::vector<Rational> patch) {
  for (int step = 0;; ++step) {
    const std::vector<Rational> next = evolved(rule, patch).values;
    if (next.size() <= patch.size() || next[0] <= 0) return std::nullopt;
    if (step == search_steps) return read_off(rule, patch, next[0] / patch[0]);
    for (std::size_t i = 0; i < patch.size(); ++i) patch[i] = rounded(next[i] / next[0]);
  }
}

}  // namespace

std::optional<EdgeOrbit> edge_orbit(const Rule& rule) {
  require(rule.is_function() && !rule.pieces.empty(), "edge orbit: need a rule with one fit to each datum");
  std::optional<EdgeOrbit> best;
  for (std::size_t count = 2; count <= rule.points; ++count)
    for (const bool kink : {false, true}) {
      std::vector<Rational> patch;
      for (std::size_t i = 0; i < count; ++i) patch.emplace_back(kink ? static_cast<long>(i) + 1 : 1);
      if (auto found = orbit_from(rule, patch); found && (!best || found->factor > best->factor))
        best = std::move(found);
    }
  return best;
}

}  // namespace subcert::piecewise
