#include "least_absolute.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/l1_scheme.hpp>

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>

namespace subcert::data {
namespace {

using piecewise::Piece;
using piecewise::Row;
using piecewise::Rule;
using Signs = std::vector<int>;

// Twice the positions about the centre of the window.
long twice_position(int points, std::size_t r) { return 2 * static_cast<long>(r) - (points - 1); }

/// The polynomial of the basis that is 1 at nodes[k] and 0 at the others, at x / 2.
Rational basis_value(int points, const std::vector<std::size_t>& nodes, std::size_t k, const Rational& x) {
  Rational value = 1;
  for (std::size_t j = 0; j < nodes.size(); ++j)
    if (j != k)
      value *= (x - twice_position(points, nodes[j])) /
               Rational(twice_position(points, nodes[k]) - twice_position(points, nodes[j]));
  return value;
}

/// Lexicographic, 1 before -1 before 0, as texts of + - 0.
bool in_order(const Signs& a, const Signs& b) {
  const auto rank = [](int sign) { return sign == 0 ? 2 : sign < 0 ? 1 : 0; };
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                      [&](int x, int y) { return rank(x) < rank(y); });
}

/// All signs that balance each other with basic values of modulus at most 1, for one choice of basic nodes.
class SignSearch {
 public:
  SignSearch(int points, std::vector<std::size_t> basic, std::size_t& steps)
      : points_(static_cast<std::size_t>(points)), basic_(std::move(basic)), steps_(steps) {
    Integer denominator = 1;
    std::vector<std::vector<Rational>> values;
    for (std::size_t r = 0; r < points_; ++r) {
      if (std::find(basic_.begin(), basic_.end(), r) != basic_.end()) continue;
      others_.push_back(r);
      values.emplace_back();
      for (std::size_t k = 0; k < basic_.size(); ++k) {
        values.back().push_back(basis_value(points, basic_, k, twice_position(points, r)));
        denominator = lcm(denominator, subcert::denominator(values.back().back()));
      }
    }
    one_ = denominator.convert_to<long>();
    for (const auto& row : values) {
      weights_.emplace_back();
      for (const Rational& value : row) weights_.back().push_back((value * Rational(denominator)).convert_to<long>());
    }
    rest_.assign(others_.size() + 1, std::vector<long>(basic_.size(), 0));
    for (std::size_t i = others_.size(); i-- > 0;)
      for (std::size_t k = 0; k < basic_.size(); ++k) rest_[i][k] = rest_[i + 1][k] + std::abs(weights_[i][k]);
  }

  /// Calls found with the signs of each vertex; false where the steps are used up.
  bool run(const std::function<void(const Signs&)>& found) {
    Signs signs(points_, 0);
    std::vector<long> sums(basic_.size(), 0);
    return visit(0, signs, sums, found);
  }

 private:
  bool visit(std::size_t i, Signs& signs, std::vector<long>& sums, const std::function<void(const Signs&)>& found) {
    if (steps_ == 0) return false;
    --steps_;
    for (std::size_t k = 0; k < sums.size(); ++k)
      if (std::abs(sums[k]) > one_ + rest_[i][k]) return true;
    if (i == others_.size()) {
      for (std::size_t k = 0; k < sums.size(); ++k) signs[basic_[k]] = sums[k] == one_ ? -1 : sums[k] == -one_ ? 1 : 0;
      found(signs);
      return true;
    }
    for (const int sign : {-1, 1}) {
      signs[others_[i]] = sign;
      for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += sign * weights_[i][k];
      const bool going_on = visit(i + 1, signs, sums, found);
      for (std::size_t k = 0; k < sums.size(); ++k) sums[k] -= sign * weights_[i][k];
      if (!going_on) return false;
    }
    return true;
  }

  std::size_t points_;
  std::vector<std::size_t> basic_, others_;
  std::size_t& steps_;
  long one_ = 1;
  std::vector<std::vector<long>> weights_;  // [other][basic]: values of the basis, times one_
  std::vector<std::vector<long>> rest_;     // sums of moduli of the weights from here on
};

Piece make_piece(int points, int degree, const std::vector<Rational>& places, const Signs& signs) {
  Piece piece{signs, 0, {}, {}};
  std::vector<std::size_t> nodes;
  const auto needed = static_cast<std::size_t>(degree) + 1;
  for (std::size_t r = 0; r < signs.size(); ++r)
    if (signs[r] == 0) nodes.push_back(r);
  std::vector<std::size_t> free;
  for (std::size_t r = 0; nodes.size() + free.size() < needed; ++r)
    if (signs[r] != 0) free.push_back(r);
  piece.own = free.size();
  nodes.insert(nodes.end(), free.begin(), free.end());
  // The fit passes through the data of `nodes`, less the residual where it is a variable.
  const auto value_at = [&](const Rational& x) {
    Row row(signs.size() + free.size(), 0);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Rational factor = basis_value(points, nodes, k, x);
      row[nodes[k]] = factor;
      if (k >= needed - free.size()) row[signs.size() + k - (needed - free.size())] = -factor;
    }
    return row;
  };
  for (std::size_t r = 0; r < signs.size(); ++r) {
    if (signs[r] == 0) continue;
    Row residual = value_at(twice_position(points, r));
    for (Rational& entry : residual) entry *= -signs[r];
    residual[r] += signs[r];
    piece.cell.push_back(std::move(residual));
  }
  for (const Rational& place : places) piece.outputs.push_back(value_at(2 * place));
  return piece;
}

bool next_subset(std::vector<std::size_t>& subset, std::size_t count) {
  for (std::size_t k = subset.size(); k-- > 0;)
    if (subset[k] + (subset.size() - k) < count) {
      ++subset[k];
      for (std::size_t j = k + 1; j < subset.size(); ++j) subset[j] = subset[j - 1] + 1;
      return true;
    }
  return false;
}

}  // namespace

std::optional<Rule> least_absolute_rule(int points, int degree, int arity, std::size_t most_pieces) {
  require(degree >= 0 && degree <= 3 && points > degree && points <= 64,
          "least absolute rule: need 0 <= degree <= 3 and degree < points <= 64, got {} and {}", degree, points);
  require(arity >= 2, "least absolute rule: need arity >= 2, got {}", arity);
  Rule rule{static_cast<std::size_t>(points), degree, {}, {}};
  for (int phase = 0; phase < arity; ++phase) rule.places.push_back(output_place(arity, phase));
  std::set<Signs, decltype(&in_order)> known(&in_order);
  std::size_t steps = 1000 * most_pieces;
  std::vector<std::size_t> basic(static_cast<std::size_t>(degree) + 1);
  std::iota(basic.begin(), basic.end(), 0);
  do {
    if (!SignSearch(points, basic, steps).run([&](const Signs& signs) { known.insert(signs); })) return std::nullopt;
    if (known.size() > most_pieces) return std::nullopt;
  } while (next_subset(basic, rule.points));
  for (const Signs& signs : known) rule.pieces.push_back(make_piece(points, degree, rule.places, signs));
  return rule;
}

Decision unique_minimiser(int points, int degree, const std::optional<Rule>& rule) {
  const std::string theorem = "of degree 1 exactly 3 points and 2 mod 4 points have one minimiser for every datum";
  if (degree == 1) return {points == 3 || points % 4 == 2 ? Truth::yes : Truth::no, theorem};
  if (degree == 0) return {points % 2 == 1 ? Truth::yes : Truth::no, "medians of an odd number of data are unique"};
  if (points == degree + 1) return {Truth::yes, "the fit interpolates"};
  if (!rule) return {Truth::unknown, "there are too many pieces"};
  if (rule->is_function()) return {Truth::yes, "each of the pieces determines the fit"};
  return {Truth::no, "a piece leaves the fit free on an open set of data"};
}

}  // namespace subcert::data
