#include "edge_orbit.hpp"

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert::piecewise {
namespace {

constexpr int search_steps = 24;        // after which the pieces of a patch have settled, if they do
constexpr std::size_t most_levels = 8;  // in which positive values in a row are looked for

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

/// The values of the next level from data that stand alone; the pieces of their windows are added to the list.
std::vector<Rational> refined(const Rule& rule, const std::vector<Rational>& data, std::vector<std::size_t>& pieces) {
  std::vector<Rational> next;
  for (std::size_t i = 0; i + rule.points <= data.size(); ++i) {
    const auto begin = data.begin() + static_cast<long>(i);
    const std::vector<Rational> window(begin, begin + static_cast<long>(rule.points));
    const Piece& piece = piece_of(rule, window);
    pieces.push_back(static_cast<std::size_t>(&piece - rule.pieces.data()));
    for (const Row& output : piece.outputs) next.push_back(value_at(output, window));
  }
  return next;
}

bool repeats(const std::vector<Rational>& data, const std::vector<Rational>& next, std::size_t offset,
             const Rational& factor) {
  if (offset + data.size() > next.size()) return false;
  for (std::size_t i = 0; i < data.size(); ++i)
    if (next[offset + i] != factor * data[i]) return false;
  return true;
}

bool has_positive_run(const std::vector<Rational>& data, std::size_t length) {
  std::size_t run = 0;
  for (const Rational& value : data) {
    run = value > 0 ? run + 1 : 0;
    if (run == length) return true;
  }
  return false;
}

/// Fills in the levels; false where the data do not repeat themselves or do not become positive.
bool prove(const Rule& rule, EdgeOrbit& orbit) {
  const std::size_t run = 2 * rule.points - 1;
  std::vector<Rational> data(orbit.zeros, 0);
  data.insert(data.end(), orbit.values.begin(), orbit.values.end());
  if (data.size() < run) return false;
  for (std::size_t level = 0; level < most_levels; ++level) {
    std::vector<Rational> next = refined(rule, data, orbit.pieces.emplace_back());
    if (level == 0) {
      const auto edge = std::find_if(next.begin(), next.end(), [](const Rational& value) { return value != 0; });
      const auto at = static_cast<std::size_t>(edge - next.begin());
      if (at < orbit.zeros) return false;
      orbit.offset = at - orbit.zeros;
    }
    if (!repeats(data, next, orbit.offset << level, orbit.factor)) return false;
    data = std::move(next);
    if (has_positive_run(data, run)) return true;
  }
  return false;
}

std::optional<EdgeOrbit> proved(const Rule& rule, const EdgeOrbit& orbit) {
  if (orbit.factor <= 0 || orbit.factor >= 1) return std::nullopt;
  for (std::size_t zeros = 0; zeros <= 2 * rule.points; ++zeros) {
    EdgeOrbit filled{orbit.values, orbit.factor, zeros};
    if (prove(rule, filled)) return filled;
  }
  return std::nullopt;
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
    if (auto found = proved(rule, orbit)) return found;
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
  require(rule.is_function() && !rule.pieces.empty() && rule.arity() == 2,
          "edge orbit: need a binary rule with one fit to each datum");
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
