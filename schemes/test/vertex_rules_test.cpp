#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/vertices/fan_regression.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <subcert/analysis/symbol/polynomials/cosine_field.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace subcert;

namespace {

/// As it is written with its parameters.
std::string specification(const std::string& name) {
  if (name == "butterfly") return "butterfly:w=1/16";
  return name == "triangular" ? "triangular:L=17/10,d=1,power=2" : name;
}

SectorRules rules_of(const std::string& name, long valence) { return vertex_rules(specification(name), valence); }

using Weights = std::map<SectorPoint, double>;

Weights weights_of(const SectorRules& rules, const LatticePoint& point) {
  Weights result;
  for (const auto& [at, weight] : weights_at(rules.rule_at(point), rules.lattice, rules.valence)) {
    const double low = weight.lower->convert_to<double>(), high = weight.upper->convert_to<double>();
    CHECK(high - low < 1e-15);
    if (std::abs(low) > 1e-15) result[at] = low;
  }
  return result;
}

std::vector<LatticePoint> first_points(const SectorRules& rules, long size) {
  const long least = rules.lattice == SectorLattice::dual ? 0 : 1;
  std::vector<LatticePoint> points = points_of_box({least, 0}, {size, size});
  if (least == 1) points.push_back({0, 0});
  return points;
}

SectorPoint mirrored(const SectorPoint& at, const SectorRules& rules) {
  const auto point = in_sector({at.point[1], at.point[0]}, rules.lattice, rules.valence);
  return turned(*point, -at.turn, rules.lattice, rules.valence);
}

void check_equal(const Weights& a, const Weights& b) {
  REQUIRE(a.size() == b.size());
  for (const auto& [at, weight] : a) {
    REQUIRE(b.count(at) == 1);
    CHECK(std::abs(b.at(at) - weight) < 1e-15);
  }
}

double sine(long multiple, long n) {
  return std::sin(2 * std::numbers::pi * static_cast<double>(multiple) / static_cast<double>(n));
}

double cosine(long multiple, long n) {
  return std::cos(2 * std::numbers::pi * static_cast<double>(multiple) / static_cast<double>(n));
}

}  // namespace

TEST_CASE("rules at vertices sum to 1 and are their own mirror images") {
  for (const std::string& name : schemes_with_vertex_rules())
    for (const long n : {3L, 4L, 5L, 6L, 7L, 8L, 13L, 50L, 1000L}) {
      CAPTURE(name, n);
      const SectorRules rules = rules_of(name, n);
      CHECK(rules.valence == n);
      for (const LatticePoint& point : first_points(rules, n > 50 ? 2 : 7)) {
        CAPTURE(point);
        const Weights weights = weights_of(rules, point);
        double sum = 0;
        Weights mirror;
        for (const auto& [at, weight] : weights) {
          sum += weight;
          mirror[mirrored(at, rules)] = weight;
        }
        CHECK(std::abs(sum - 1) < 1e-12);
        const SectorPoint image = *in_sector({point[1], point[0]}, rules.lattice, n);
        Weights other;
        for (const auto& [at, weight] : weights_of(rules, image.point))
          other[turned(at, image.turn, rules.lattice, n)] = weight;
        check_equal(other, mirror);
      }
    }
}

TEST_CASE("rules at vertices of the regular valence are the mask") {
  for (const std::string& name : schemes_with_vertex_rules()) {
    CAPTURE(name);
    const bool triangles = rules_of(name, 3).lattice == SectorLattice::triangles;
    const SectorRules rules = rules_of(name, triangles ? 6 : 4);
    for (const LatticePoint& point : first_points(rules, 5)) {
      Weights expected;
      const long m = rules.mask.arity();
      for (const Monomial& term : rules.mask.symbol().terms()) {
        const long x = point[0] - term.exponents[0], y = point[1] - term.exponents[1];
        if (x % m == 0 && y % m == 0)
          expected[*in_sector({x / m, y / m}, rules.lattice, rules.valence)] += term.coefficient.convert_to<double>();
      }
      CAPTURE(point);
      check_equal(weights_of(rules, point), expected);
    }
  }
}

TEST_CASE("rules at vertices have the weights that are printed") {
  for (const long n : {3L, 4L, 5L, 7L, 12L, 101L}) {
    CAPTURE(n);
    const double valence = static_cast<double>(n);
    const Weights loop = weights_of(vertex_rules("loop", n), {0, 0});
    const double inner = 3.0 / 8 + cosine(1, n) / 4;
    CHECK(loop.at({{1, 0}, n - 1}) == Approx((5.0 / 8 - inner * inner) / valence).epsilon(1e-13));
    const Weights quads = weights_of(vertex_rules("catmull-clark", n), {0, 0});
    CHECK(quads.at({{1, 0}, 0}) == Approx(3 / (2 * valence * valence)).epsilon(1e-13));
    CHECK(quads.at({{1, 1}, 0}) == Approx(1 / (4 * valence * valence)).epsilon(1e-13));
    const Weights dual = weights_of(vertex_rules("doo-sabin", n), {0, 0});
    const Weights edge = weights_of(vertex_rules("modified-butterfly", n), {1, 0});
    for (long t = 0; t < n; ++t) {
      CHECK(dual.at({{0, 0}, t}) ==
            Approx((3 + 2 * cosine(t, n)) / (4 * valence) + (t == 0 ? 0.25 : 0)).epsilon(1e-12));
      if (n < 5 || edge.count({{1, 0}, t}) == 0) continue;
      CHECK(edge.at({{1, 0}, t}) ==
            Approx((0.25 + cosine(t, n) + cosine(2 * t, n) / 2) / valence).epsilon(1e-11).margin(1e-15));
    }
  }
  check_equal(weights_of(vertex_rules("modified-butterfly", 3), {1, 0}),
              {{{{0, 0}, 0}, 0.75}, {{{1, 0}, 0}, 5.0 / 12}, {{{1, 0}, 1}, -1.0 / 12}, {{{1, 0}, 2}, -1.0 / 12}});
  check_equal(weights_of(vertex_rules("modified-butterfly", 4), {1, 0}),
              {{{{0, 0}, 0}, 0.75}, {{{1, 0}, 0}, 3.0 / 8}, {{{1, 0}, 2}, -1.0 / 8}});
}

TEST_CASE("rules that are written down have the weights of their expressions") {
  const LatticePoint centre{0, 0}, ray{1, 0};
  WrittenRules written{SectorLattice::triangles,
                       mask_in_sectors(make_linear_scheme("loop").mask, SectorLattice::triangles)};
  written.rules = {
      {ray, {{centre, 0, {"1 - (1/2 + c*(4*C^3 - 3*C) + C^4/n)"}}, {ray, std::nullopt, {"(1/2 + C)/n"}}}, 4}};
  CHECK_THROWS_AS(rules_at(written, 5), Error);  // C at one datum
  written.rules.front().weights = {{centre, 0, {"1/2 - 3*n/8/n"}},
                                   {ray, std::nullopt, {"(1/2 + c*(4*C^3 - 3*C) + C^4)/n"}}};
  for (const long n : {4L, 5L, 7L, 8L, 31L}) {
    CAPTURE(n);
    const Weights edge = weights_of(rules_at(written, n), ray);
    for (long t = 0; t < n; ++t) {
      const double expected = (0.5 + cosine(1, n) * cosine(3 * t, n) + std::pow(cosine(t, n), 4)) /
                              static_cast<double>(n);
      const auto found = edge.find({ray, t});
      CHECK((found == edge.end() ? 0 : found->second) == Approx(expected).margin(1e-14));
    }
  }
  CHECK(rules_at(written, 6).rules.size() == 1);
  CHECK_THROWS_AS(rules_at(written, 3), Error);
  written.rules.front()
      .place = "here";  // what somebody else wrote has to sum to 1: the mean of C^4 is 3/8 from n = 5 on
  CHECK_NOTHROW(rules_at(written, 5));
  CHECK_THROWS_WITH(rules_at(written, 4), Catch::Contains("here: the weights at valence 4 sum to 9/8; need 1"));
}

TEST_CASE("rows are the expressions that they are the values of") {
  const LatticePoint centre{0, 0};
  WrittenRules row{SectorLattice::dual, mask_in_sectors(make_linear_scheme("doo-sabin").mask, SectorLattice::dual)};
  for (const long n : {3L, 5L, 8L}) {
    std::vector<std::string> values;
    for (long t = 0; t < n; ++t)
      values.push_back(t == 0 ? "1/4 + 3/(4*n) + 1/(2*n)" : "3/(4*n) + (" + [&] {
        std::string text = chebyshev(t).to_text();
        std::replace(text.begin(), text.end(), 'z', 'c');
        return text;
      }() + ")/(2*n)");
    row.rules = {{centre, {{centre, std::nullopt, values}}, n, n}};
    check_equal(weights_of(rules_at(row, n), centre), weights_of(vertex_rules("doo-sabin", n), centre));
    CHECK_THROWS_AS(rule_family(row), Error);
    // Equal weights have one form.
    const SectorRules made = rules_at(row, n);
    for (const SectorTerm& term : made.rules.at(centre).terms)
      CHECK(term.weight == CosineField(n).number(term.weight).polynomial());
  }
}

TEST_CASE("local regression at vertices keeps what its fits keep") {
  // In the flat fan: polynomials of the degree, at the vertex and in the middle of an edge.
  for (const char* name :
       {"triangular:L=8/5,d=0", "triangular:L=8/5,d=1", "triangular:L=17/10,d=1,power=1",
        "triangular:L=17/10,d=1,power=8", "triangular:L=8/5,d=2", "triangular:L=1732/1000,d=2,power=3"})
    for (const long n : {3L, 4L, 5L, 6L, 7L, 8L, 12L, 31L}) {
      CAPTURE(name, n);
      const SectorRules rules = vertex_rules(name, n);
      const int kept = name[std::string(name).find("d=") + 2] - '0';
      for (const LatticePoint& point : {LatticePoint{0, 0}, LatticePoint{1, 0}}) {
        const Weights weights = weights_of(rules, point);
        const double middle = point[0] == 1 ? 0.5 : 0;
        for (int i = 0; i <= kept; ++i)
          for (int j = 0; i + j <= kept; ++j) {
            double sum = 0;
            for (const auto& [at, weight] : weights) {
              const auto along = static_cast<double>(at.point[0]), beside = static_cast<double>(at.point[1]);
              const double x = along * cosine(at.turn, n) + beside * cosine(at.turn + 1, n),
                           y = along * sine(at.turn, n) + beside * sine(at.turn + 1, n);
              sum += weight * std::pow(x, i) * std::pow(y, j);
            }
            CAPTURE(point, i, j);
            CHECK(std::abs(sum - std::pow(middle, i) * (j == 0 ? 1 : 0)) < 1e-12);
          }
      }
    }
}

TEST_CASE("local regression at vertices has the weights of its fits") {
  // At valence 3 without weights x is 0, 1, -1/2, -1/2, 2, 1/2, 1/2: seven data with the sums 3 and 6 of x and x^2.
  const Weights edge = weights_of(vertex_rules("triangular:L=8/5,d=1", 3), {1, 0});
  REQUIRE(edge.size() == 7);
  const auto line = [](double x) { return 1.0 / 7 + (x - 3.0 / 7) * (1.0 / 2 - 3.0 / 7) / (6 - 9.0 / 7); };
  CHECK(edge.at({{0, 0}, 0}) == Approx(line(0)).epsilon(1e-12));
  CHECK(edge.at({{1, 0}, 0}) == Approx(line(1)).epsilon(1e-12));
  CHECK(edge.at({{1, 0}, 2}) == Approx(line(-0.5)).epsilon(1e-12));
  CHECK(edge.at({{2, 0}, 0}) == Approx(line(2)).epsilon(1e-12));
  CHECK(edge.at({{1, 1}, 2}) == Approx(line(0.5)).epsilon(1e-12));
  const Weights vertex = weights_of(vertex_rules("triangular:L=8/5,d=1", 4), {0, 0});
  CHECK(vertex.at({{0, 0}, 0}) == Approx(1.0 / 5).epsilon(1e-12));
  CHECK(weights_of(vertex_rules("triangular:L=8/5,d=2", 4), {0, 0}) == Weights{{{{0, 0}, 0}, 1}});
}

TEST_CASE("fits in a whole fan are the rules at a vertex") {
  for (const char* name : {"triangular:L=8/5,d=0", "triangular:L=17/10,d=1,power=2", "triangular:L=1732/1000,d=2"})
    for (const long n : {3L, 4L, 5L, 6L, 7L, 12L}) {
      CAPTURE(name, n);
      const Weights expected = weights_of(vertex_rules(name, n), {1, 0});
      const std::vector<Enclosure> fit = fan_weights(name, {n, -1, n - 2, true, true, true}, true);
      Weights weights;
      const auto put = [&](const SectorPoint& at, const Enclosure& weight) {
        if (std::abs(weight.lower->convert_to<double>()) > 1e-15) weights[at] = weight.lower->convert_to<double>();
      };
      const auto after_ring = static_cast<std::size_t>(n + 1);
      REQUIRE(fit.size() == after_ring + 3);
      put({{0, 0}, 0}, fit[0]);
      for (long k = 0; k < n; ++k) put({{1, 0}, (k + n - 1) % n}, fit[static_cast<std::size_t>(k + 1)]);
      put({{1, 1}, 0}, fit[after_ring]);
      put({{2, 0}, 0}, fit[after_ring + 1]);
      put({{1, 1}, n - 1}, fit[after_ring + 2]);
      check_equal(weights, expected);
    }
}

TEST_CASE("fits in a part of a fan keep polynomials, and take a lower degree where data are few") {
  const auto check = [](const char* name, const MeshFan& fan, int degree) {
    const double angle = 2 * std::numbers::pi / static_cast<double>(fan.turn);
    for (const bool at_middle : {false, true}) {
      std::vector<std::pair<double, double>> places{{0, 0}};
      for (long k = fan.first; k <= fan.last; ++k)
        places.emplace_back(std::cos(static_cast<double>(k) * angle), std::sin(static_cast<double>(k) * angle));
      if (fan.left) places.emplace_back(1 + std::cos(angle), std::sin(angle));
      if (fan.straight) places.emplace_back(2, 0);
      if (fan.right) places.emplace_back(1 + std::cos(angle), -std::sin(angle));
      const std::vector<Enclosure> weights = fan_weights(name, fan, at_middle);
      REQUIRE(weights.size() == places.size());
      for (int i = 0; i <= degree; ++i)
        for (int j = 0; i + j <= degree; ++j) {
          double sum = 0;
          for (std::size_t k = 0; k < places.size(); ++k)
            sum += weights[k].lower->convert_to<double>() * std::pow(places[k].first, i) *
                   std::pow(places[k].second, j);
          CAPTURE(name, fan.turn, fan.first, fan.last, at_middle, i, j);
          CHECK(std::abs(sum - (j > 0 ? 0 : std::pow(at_middle ? 0.5 : 0, i))) < 1e-12);
        }
    }
  };
  for (const char* name :
       {"triangular:L=8/5,d=1", "triangular:L=17/10,d=1,power=8", "triangular:L=17/10,d=2,power=1"}) {
    const int degree = name[std::string(name).find("d=") + 2] - '0';
    for (const long turn : {8L, 10L, 14L, 40L, 400L}) {
      check(name, {turn, 0, turn / 2, true, true}, degree);
      check(name, {turn, -turn / 2, 0, false, true, true}, degree);
      check(name, {turn, -1, turn / 2 - 1}, degree);
      check(name, {turn, -1, turn - 2, true}, degree);
    }
    check(name, {6, 0, 3, true, true}, degree);
    check(name, {4, 0, 1}, 1);  // three data
    check(name, {4, 0, 1, true, true}, 1);
    check(name, {4, 0, 2, true, true}, 1);
  }
  // A triangle: three data, which a fit of degree 1 meets.
  const std::vector<Enclosure> corner = fan_weights("triangular:L=17/10,d=2,power=1", {4, 0, 1}, false);
  CHECK(corner[0].lower->convert_to<double>() == Approx(1));
  CHECK(std::abs(corner[1].lower->convert_to<double>()) < 1e-15);
  CHECK_THROWS_AS(fan_weights("loop", {6, 0, 3}, true), Error);
  CHECK_THROWS_AS(fan_weights("triangular:L=2,d=1", {6, 0, 3}, true), Error);
  CHECK_THROWS_AS(fan_weights("triangular:L=8/5,d=1", {6, 1, 3}, true), Error);
  CHECK_THROWS_AS(fan_weights("triangular:L=8/5,d=1", {6, -3, 3}, true), Error);
}

TEST_CASE("rules of all valences are those of each") {
  CHECK_THROWS_AS(vertex_rule_family(specification("triangular")), Error);
  for (const std::string& name : schemes_with_vertex_rules()) {
    if (name == "triangular") continue;
    const SectorRuleFamily family = vertex_rule_family(specification(name));
    CHECK_THROWS_AS(family.at(family.least - 1), Error);
    for (const long n : {family.least, 8L, 12L, 13L, 101L, 1000L}) {
      const SectorRules all = family.at(n), own = rules_of(name, n);
      CHECK(all.rules.size() == own.rules.size());
      for (const LatticePoint& point : first_points(own, n > 50 ? 2 : 7)) {
        CAPTURE(name, n, point);
        check_equal(weights_of(all, point), weights_of(own, point));
      }
    }
  }
}

TEST_CASE("rules at vertices are refused where there are none") {
  CHECK_THROWS_AS(vertex_rules("loop", 2), Error);
  CHECK_THROWS_AS(vertex_rules("quincunx", 5), Error);
  CHECK_THROWS_AS(vertex_rules("primal:n=3", 5), Error);
  CHECK_THROWS_AS(vertex_rules("nothing", 5), Error);
}
