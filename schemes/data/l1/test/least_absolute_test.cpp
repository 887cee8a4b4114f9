#include "least_absolute_deviation.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/data/l1/l1_refinement.hpp>
#include <subcert/schemes/data/l1/least_absolute_limit.hpp>

#include <algorithm>
#include <map>
#include <numeric>

using namespace subcert;
using namespace subcert::data;
using namespace subcert::piecewise;
using subcert::testing::least_absolute_deviation;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

Rational value(const Row& form, const std::vector<Rational>& f) {
  Rational sum = 0;
  for (std::size_t r = 0; r < f.size(); ++r) sum += form[r] * f[r];
  return sum;
}

/// The pieces without variables of their own in which the data lie.
std::vector<const Piece*> pieces_of(const Rule& rule, const std::vector<Rational>& f) {
  std::vector<const Piece*> found;
  for (const Piece& piece : rule.pieces)
    if (piece.own == 0 &&
        std::all_of(piece.cell.begin(), piece.cell.end(), [&](const Row& row) { return value(row, f) >= 0; }))
      found.push_back(&piece);
  return found;
}

/// Integers with many equal ones, and some outliers.
std::vector<Rational> data_with_outliers(Random& random, std::size_t count) {
  std::vector<Rational> f;
  for (std::size_t i = 0; i < count; ++i)
    f.emplace_back(random.integer(0, 5) == 0 ? random.integer(-1000, 1000) : random.integer(-2, 2));
  return f;
}

std::vector<Rational> step(const Rule& rule, const std::vector<Rational>& f) {
  std::vector<Rational> next;
  for (std::size_t i = 0; i + rule.points <= f.size(); ++i) {
    const std::vector<Rational> window(f.begin() + static_cast<long>(i),
                                       f.begin() + static_cast<long>(i + rule.points));
    for (const Row& output : pieces_of(rule, window).at(0)->outputs) next.push_back(value(output, window));
  }
  return next;
}

Rational largest_difference(std::vector<Rational> f, int order) {
  for (; order > 0; --order) {
    for (std::size_t i = 0; i + 1 < f.size(); ++i) f[i] = f[i + 1] - f[i];
    f.pop_back();
  }
  Rational largest = 0;
  for (const Rational& difference : f) largest = std::max(largest, abs(difference));
  return largest;
}

std::string bound_text(int points, int degree, int steps, int order) {
  const auto found = contraction(*least_absolute_rule(points, degree), {steps, order}).proved;
  return found ? found->bound.str() : "none";
}

/// Follows a tree: the factors of a leaf have the signs of all pieces that are possible there, and both parts of a
/// split have a piece.
class TreeWalk {
 public:
  TreeWalk(const Rule& rule, const ContractionTree& tree) : rule_(rule), tree_(tree) {
    std::vector<std::size_t> all(rule.pieces.size());
    std::iota(all.begin(), all.end(), 0);
    possible_.assign(tree.windows.size(), all);
    visit();
    CHECK(next_ == tree.nodes.size());
  }

 private:
  void visit() {
    REQUIRE(next_ < tree_.nodes.size());
    const ProofNode node = tree_.nodes[next_++];
    if (!node.split) return check_leaf(tree_.leaves.at(node.index));
    std::vector<std::size_t> parts[2];
    for (const std::size_t piece : possible_.at(node.index)) {
      const int sign = rule_.pieces[piece].signs.at(node.datum);
      const auto kind = sign > 0 ? ProofNode::positive : sign < 0 ? ProofNode::negative : ProofNode::none;
      parts[(node.signs & kind) != 0 ? 0 : 1].push_back(piece);
    }
    const std::vector<std::size_t> all = possible_[node.index];
    for (const std::vector<std::size_t>& part : parts) {
      REQUIRE_FALSE(part.empty());
      possible_[node.index] = part;
      visit();
    }
    possible_[node.index] = all;
  }

  void check_leaf(const ResidualFactors& leaf) const {
    long wrong = 0;
    for (const auto& [place, factor] : leaf.factors)
      for (const std::size_t piece : possible_.at(place / rule_.points))
        wrong += rule_.pieces[piece].signs[place % rule_.points] == -factor.sign() ? 1 : 0;
    CHECK(wrong == 0);
  }

  const Rule& rule_;
  const ContractionTree& tree_;
  std::size_t next_ = 0;
  std::vector<std::vector<std::size_t>> possible_;
};

}  // namespace

TEST_CASE("the trees of contractions go through all pieces, and their factors have the signs of the pieces") {
  for (const auto& [points, steps] : std::vector<std::pair<int, int>>{{3, 1}, {4, 2}, {5, 2}, {6, 1}, {6, 2}, {7, 1}}) {
    CAPTURE(points, steps);
    const auto rule = least_absolute_rule(points, 1);
    const auto found = contraction(*rule, {steps, 1, 0, {}, true}).proved;
    REQUIRE(found);
    for (const ContractionTree& tree : found->trees) TreeWalk(*rule, tree);
  }
}

TEST_CASE("pieces of least absolute deviations: how many, and whether they determine the fit") {
  struct Known {
    int points, degree;
    std::size_t pieces, determined;
  };
  for (const Known& known : std::vector<Known>{{3, 1, 2, 2},
                                               {4, 1, 4, 2},
                                               {5, 1, 10, 4},
                                               {6, 1, 38, 38},
                                               {7, 1, 70, 64},
                                               {8, 1, 140, 132},
                                               {10, 1, 980, 980},
                                               {3, 0, 6, 6},
                                               {4, 0, 6, 0},
                                               {5, 2, 6, 6},
                                               {6, 2, 8, 4},
                                               {6, 3, 8, 8},
                                               {2, 1, 1, 1},
                                               {5, 3, 2, 2},
                                               {8, 3, 32, 28}}) {
    CAPTURE(known.points, known.degree);
    const auto rule = least_absolute_rule(known.points, known.degree);
    REQUIRE(rule);
    CHECK(rule->pieces.size() == known.pieces);
    CHECK(std::count_if(rule->pieces.begin(), rule->pieces.end(), [](const Piece& p) { return p.own == 0; }) ==
          static_cast<long>(known.determined));
  }
  CHECK_FALSE(least_absolute_rule(30, 1));
  CHECK_THROWS_AS(least_absolute_rule(3, 3), Error);
}

TEST_CASE("one minimiser for every datum: the theorem of degree 1 and the pieces agree") {
  for (int points = 2; points <= 12; ++points) {
    CAPTURE(points);
    const auto rule = least_absolute_rule(points, 1);
    CHECK(unique_minimiser(points, 1, rule).is_yes() == rule->is_function());
  }
  CHECK(unique_minimiser(62, 1, std::nullopt).is_yes());
  CHECK(unique_minimiser(64, 1, std::nullopt).is_no());
  CHECK(unique_minimiser(64, 2, std::nullopt).truth == Truth::unknown);
}

TEST_CASE("the pieces of random data have the least sum of moduli, and all of them the same outputs") {
  for (const auto& [points, degree] : std::vector<std::pair<int, int>>{{3, 1}, {6, 1}, {5, 2}, {6, 3}, {5, 0}}) {
    const auto rule = least_absolute_rule(points, degree);
    const RegressionWindow window = l1_window({{points}, degree, {}});
    Random random;
    for (const auto round : rounds(60)) {
      (void)round;
      const std::vector<Rational> f = data_with_outliers(random, rule->points);
      const auto found = pieces_of(*rule, f);
      REQUIRE_FALSE(found.empty());
      Rational sum = 0;
      for (const Row& row : found[0]->cell) sum += value(row, f);
      CHECK(sum == least_absolute_deviation(window, f).objective);
      for (const Piece* piece : found)
        for (std::size_t o = 0; o < 2; ++o) CHECK(value(piece->outputs[o], f) == value(found[0]->outputs[o], f));
    }
  }
}

TEST_CASE("the pieces are what reweighting tends to") {
  const auto rule = least_absolute_rule(6, 1);
  const L1Fitter fitter(l1_window({{6}, 1, {}}), {1e-22, 2000, 0, false});
  Random random;
  for (const auto round : rounds(40)) {
    (void)round;
    std::vector<Rational> f;
    std::vector<double> in_doubles;
    for (int r = 0; r < 6; ++r) {
      f.emplace_back(random.integer(-1000, 1000));
      in_doubles.push_back(f.back().convert_to<double>() / 1000);
    }
    const std::vector<double> fit = fitter.fit(in_doubles);
    for (std::size_t o = 0; o < 2; ++o)
      CHECK(fit[o] == Approx(value(pieces_of(*rule, f).at(0)->outputs[o], f).convert_to<double>() / 1000).margin(1e-6));
  }
}

TEST_CASE("one step: Lipschitz constants, the range of the data, linear rules") {
  CHECK(lipschitz_constant(*least_absolute_rule(6, 1)) == Rational(9, 2));
  CHECK(lipschitz_constant(*least_absolute_rule(10, 1)) == Rational(17, 2));
  CHECK_THROWS_AS(lipschitz_constant(*least_absolute_rule(4, 1)), Error);
  for (int points = 3; points <= 9; ++points) CHECK(largest_output(*least_absolute_rule(points, 1)) == Rational(1));
  CHECK(largest_output(*least_absolute_rule(4, 0)) == Rational(1));
  CHECK(*largest_output(*least_absolute_rule(6, 3)) > 1);
  CHECK(*largest_output(*least_absolute_rule(6, 3)) <= Rational(425, 128));
  CHECK(linear_mask(*least_absolute_rule(3, 1), -1)->symbol().to_mask_text() == "[3,5,0,0,5,3]/8@-2");
  CHECK(linear_mask(*least_absolute_rule(5, 3), -2)->symbol().to_mask_text() ==
        "[-35,-45,126,210,0,0,210,126,-45,-35]/256@-4");
  CHECK_FALSE(linear_mask(*least_absolute_rule(6, 1), -2));
  CHECK_FALSE(linear_mask(*least_absolute_rule(4, 1), -1));
}

TEST_CASE("contraction of differences: the least bounds") {
  CHECK(bound_text(3, 1, 1, 1) == "1");
  CHECK(bound_text(4, 1, 1, 1) == "7/6");
  CHECK(bound_text(4, 1, 2, 1) == "11/12");
  CHECK(bound_text(5, 1, 1, 1) == "1");
  CHECK(bound_text(6, 1, 1, 1) == "3/5");
  CHECK(bound_text(6, 1, 1, 2) == "3/4");
  CHECK(bound_text(8, 1, 1, 1) == "13/10");
  CHECK(bound_text(10, 1, 1, 1) == "2/3");
  CHECK(bound_text(6, 3, 1, 2) == "45/64");
  CHECK(bound_text(5, 2, 1, 1) == "13/8");
  CHECK(bound_text(5, 2, 1, 2) == "31/32");
  CHECK(bound_text(4, 0, 1, 1) == "2");
  CHECK_THROWS_AS(bound_text(6, 1, 1, 3), Error);
  CHECK_THROWS_AS(bound_text(6, 1, 0, 1), Error);
}

TEST_CASE("contraction of differences: the least bounds of several steps", "[long]") {
  CHECK(bound_text(5, 2, 2, 2) == "403/512");
  CHECK(bound_text(6, 1, 2, 2) == "8019/24032");
  CHECK(bound_text(7, 1, 2, 1) == "599/1116");
  CHECK(bound_text(5, 1, 3, 1) == "25/32");
}

TEST_CASE("no data exceed the bound of a contraction, and those that it names attain it") {
  struct Known {
    int points, degree, steps, order;
  };
  for (const Known& of : std::vector<Known>{{6, 1, 1, 1}, {6, 1, 1, 2}, {6, 3, 1, 1}, {5, 2, 1, 2}, {3, 1, 2, 1}}) {
    CAPTURE(of.points, of.degree, of.steps, of.order);
    const auto rule = least_absolute_rule(of.points, of.degree);
    const auto found = contraction(*rule, {of.steps, of.order}).proved;
    REQUIRE(found);
    const auto ratio_fits = [&](const std::vector<Rational>& f) {
      std::vector<Rational> refined = f;
      for (int level = 0; level < of.steps; ++level) refined = step(*rule, refined);
      return std::pair{largest_difference(refined, of.order), found->bound * largest_difference(f, of.order)};
    };
    REQUIRE_FALSE(found->data.empty());
    CHECK(largest_difference(found->data, of.order) == 1);
    CHECK(ratio_fits(found->data).first == found->bound);
    Random random;
    for (const auto round : rounds(30)) {
      (void)round;
      const auto [refined, bound] = ratio_fits(data_with_outliers(random, rule->points + 3));
      CHECK(refined <= bound);
    }
  }
}

TEST_CASE("factors of a contraction reproduce polynomials and bound the difference at every leaf") {
  const auto rule = least_absolute_rule(4, 1);
  const auto found = contraction(*rule, {2, 1, 0, {}, true}).proved;
  REQUIRE(found);
  CHECK(found->trees.size() == 3);
  for (const ContractionTree& tree : found->trees) {
    std::size_t splits = 0, leaves = 0;
    for (const ProofNode& node : tree.nodes) ++(node.split ? splits : leaves);
    CHECK(leaves == splits + 1);
    for (const ResidualFactors& factors : tree.leaves) {
      CHECK(factors.bound <= found->bound);
      // A window of level 0 hands on what its outputs are asked for: the sum of its factors.
      Rational sum = 0;
      for (std::size_t window = 0; window < tree.windows.size(); ++window)
        if (tree.windows[window].level == 1)
          for (const auto& [place, factor] : factors.factors)
            if (place / rule->points == window) sum += factor;
      CHECK(sum == 0);
    }
  }
}

TEST_CASE("data that repeat themselves at an edge") {
  const auto rule = least_absolute_rule(6, 1);
  const auto six = edge_orbit(*rule);
  REQUIRE(six);
  CHECK(six->factor == Rational(5, 12));
  CHECK(six->values == std::vector<Rational>{1, Rational(7, 5), Rational(33, 19)});
  // The same by two steps of the rule itself, from more zeros.
  std::vector<Rational> f(12, 0);
  f.insert(f.end(), six->values.begin(), six->values.end());
  f = step(*rule, step(*rule, f));
  const auto edge = std::find_if(f.begin(), f.end(), [](const Rational& entry) { return entry != 0; });
  REQUIRE(f.end() - edge >= 3);
  for (long i = 0; i < 3; ++i) CHECK(edge[i] == Rational(25, 144) * six->values[static_cast<std::size_t>(i)]);
  CHECK_THROWS_AS(edge_orbit(*least_absolute_rule(4, 1)), Error);
}

TEST_CASE("limits of least absolute deviations: what is decided") {
  const LeastAbsoluteLimit six = least_absolute_limit(6, 1, {});
  CHECK(six.converges.is_yes());
  CHECK(six.contraction->bound == Rational(3, 5));
  CHECK(*six.exponent.lower > Rational(7369, 10000));
  CHECK(*six.exponent.lower < Rational(7370, 10000));
  CHECK(*six.exponent.upper > Rational(12630, 10000));
  CHECK(*six.exponent.upper < Rational(12631, 10000));
  const LeastAbsoluteLimit four = least_absolute_limit(4, 1, {});
  CHECK(four.converges.is_yes());
  CHECK(four.contraction->steps == 2);
  CHECK(four.unique.is_no());
  const LeastAbsoluteLimit three = least_absolute_limit(3, 1, {.deadline = Deadline::in(20)});
  CHECK(three.converges.is_yes());
  CHECK(three.exponent.contains(1));
  CHECK(least_absolute_limit(5, 0, {.steps = 1}).converges.is_no());
  CHECK(least_absolute_limit(5, 1, {.steps = 1}).converges.truth == Truth::unknown);
  CHECK(least_absolute_limit(40, 1, {}).converges.truth == Truth::unknown);
  CHECK(least_absolute_limit(6, 2, {.steps = 2, .deadline = Deadline::in(0)}).converges.truth == Truth::unknown);
  CHECK_THROWS_AS(least_absolute_limit(6, 1, {.order = 3}), Error);
}
