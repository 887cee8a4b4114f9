#include <subcert/cmake/catch.hpp>
#include <subcert/reports/facts/exponents.hpp>
#include <subcert/reports/facts/fact.hpp>
#include <subcert/reports/facts/family_facts.hpp>
#include <subcert/reports/facts/l1_facts.hpp>
#include <subcert/reports/facts/limit_facts.hpp>
#include <subcert/reports/facts/regularity_facts.hpp>
#include <subcert/reports/facts/scheme_facts.hpp>
#include <subcert/reports/facts/screen_lines.hpp>
#include <subcert/reports/facts/weight_facts.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <sstream>

using namespace subcert;
using namespace subcert::facts;

namespace {

/// Each member is there once, and each label; a fact is for programs or for people, or for both.
void check_list(const Facts& list) {
  std::set<std::string> keys, names;
  for (const Fact& fact : list) {
    CAPTURE(fact.key, fact.label);
    CHECK((!fact.key.empty() || !fact.label.empty()));
    if (!fact.key.empty()) CHECK(keys.insert(fact.key).second);
    if (fact.label.empty()) continue;
    CHECK(names.insert(fact.label).second);
    CHECK_FALSE(fact.text.empty());
  }
  CHECK(page_json(list).size() == keys.size());
}

}  // namespace

TEST_CASE("facts: every printer prints the same list") {
  const Facts list{{"scheme", "scheme", "dd:n=2", "a title", "dd:n=2"},
                   {"symbol", "symbol", "a(z)\n= b(z)", "", "a(z)"},
                   decided("stable", "stable", {Truth::unknown, "no time"}),
                   decided("convergence", "convergence", {Truth::yes, ""}),
                   member("arity", 2),
                   {"", "a long label", "words"},
                   plain("sum_rules", "sum rules", 4)};
  CHECK(page_text(list, 13) ==
        "scheme       dd:n=2  (a title)\n"
        "symbol       a(z)\n"
        "             = b(z)\n"
        "stable       unknown: no time\n"
        "convergence  yes\n"
        "a long label words\n"
        "sum rules    4\n");
  CHECK(page_text({{"", "wider than that", "words"}}, 5) == "wider than that words\n");
  const Json stable{{"verdict", "unknown"}, {"reason", "no time"}}, convergence{{"verdict", "yes"}, {"reason", ""}};
  CHECK(page_json(list) == Json{{"scheme", "dd:n=2"},
                                {"symbol", "a(z)"},
                                {"stable", stable},
                                {"convergence", convergence},
                                {"arity", 2},
                                {"sum_rules", 4}});
  CHECK(page_json({}) == Json::object());
  CHECK(page_text({}, 13).empty());
  CHECK(find(list, "symbol")->json == "a(z)");
  CHECK(find(list, "arity") == nullptr);
}

TEST_CASE("facts: labels of several lists, in the order of each") {
  const auto list = [](const std::vector<std::string>& names) {
    Facts result;
    for (const std::string& name : names) result.push_back({name, name, "x"});
    return result;
  };
  CHECK(labels({list({"a", "c"}), list({"a", "b", "c", "d"}), {}}) == std::vector<std::string>{"a", "b", "c", "d"});
  CHECK(labels({{member("a", 1)}}).empty());
}

TEST_CASE("facts: curves and surfaces, with proofs and without") {
  for (const char* specification :
       {"dd:n=2", "mask:[1,1]", "four-point:w=3/4", "mask:[1,2,2,2,1]/4", "daubechies:n=2", "bspline:degree=2,a=3",
        "loop:", "quincunx:", "tensor:(dd:n=1)x(bspline:degree=1)", "mask2:[[1,1],[1,1]]"}) {
    CAPTURE(specification);
    const Scheme scheme = make_linear_scheme(specification);
    const Facts of_mask = mask_facts(scheme);
    const Analysis known = analysis(scheme, {{8, Deadline::in(2)}, 2});
    const Facts list = scheme_facts(scheme, known);
    check_list(list);
    REQUIRE(list.size() > of_mask.size());
    CHECK(std::ranges::equal(of_mask, std::span(list).first(of_mask.size()), {}, &Fact::key, &Fact::key));
    const Json json = page_json(list);
    for (const char* key :
         {"scheme", "title", "coefficients", "sum_rules", "support", "parametrization", "convergence"})
      CHECK(json.contains(key));
    // Without limits nothing is said of them.
    CHECK((find(list, "stable") != nullptr && !known.convergence.is_yes()) == false);
    CHECK((find(list, "smoothness") != nullptr && !known.convergence.is_yes()) == false);
  }
  check_list(family_facts(make_parametric_scheme("four-point:w")));
}

TEST_CASE("facts: the norm of a step tells how far it leaves the range of the data") {
  const std::map<std::string, std::string> texts{
      {"bspline:degree=2", "||S|| = 1: new points are convex combinations of old ones"},
      {"loop", "||S|| = 1: new points are convex combinations of old ones"},
      {"four-point:w=1/16", "||S|| = 5/4: a step leaves the range of the data by at most 1/8 of it"},
      {"tensor:(dd:n=2)x(dd:n=2)", "||S|| = 25/16: a step leaves the range of the data by at most 9/32 of it"},
      {"butterfly:w=1/16", "||S|| = 3/2: a step leaves the range of the data by at most 1/4 of it"}};
  for (const auto& [specification, text] : texts) {
    CAPTURE(specification);
    CHECK(find(mask_facts(make_linear_scheme(specification)), "norm")->text == text);
  }
  for (const char* specification : {"dd:n=3", "primal:n=4,d=3", "ary:a=3,points=4,d=3", "daubechies:n=3", "sqrt3",
                                    "four-point:w=-1/3", "grid:points=4x4,d=3", "quincunx", "mask:[1,1]"}) {
    CAPTURE(specification);
    const Scheme scheme = make_linear_scheme(specification);
    // Data in [0, 1] that are 1 where the coefficient is below 0 give the smallest values.
    const Dilation& dilation = scheme.mask.dilation();
    std::vector<Rational> least(dilation.digits().size(), 0);
    for (const Monomial& term : scheme.mask.symbol().terms())
      if (term.coefficient < 0) least[dilation.divide(term.exponents).digit] += term.coefficient;
    const Json norm = find(mask_facts(scheme), "norm")->json;
    CHECK(norm == to_text(1 - 2 * *std::ranges::min_element(least)));
  }
}

TEST_CASE("facts: exponents have the fields of the contract, whatever was found") {
  const Budget budget{Deadline::in(1)};
  for (const char* specification : {"dd:n=2", "mask:[1,1]", "four-point:w=3/4", "mask:[1,2,2,2,1]/4",
                                    "loop:", "zwart-powell:", "tensor:(dd:n=1)x(dd:n=2)"}) {
    CAPTURE(specification);
    const Scheme scheme = make_linear_scheme(specification);
    const Facts list = regularity_facts(scheme, regularity_of(scheme.mask, budget, {.levels = 4}), std::nullopt, {});
    check_list(list);
    const Json json = page_json(list);
    for (const char* key :
         {"scheme", "sum_rules", "bound", "holder", "exact", "method", "product", "stable", "seconds"})
      CHECK(json.contains(key));
    CHECK(json.at("stable").is_boolean());
    CHECK(json.at("converges").is_string());
  }
}

TEST_CASE("enclosures and intervals as JSON keep both ends, rounded outward or exact") {
  const Json json = enclosure_json(Enclosure{Rational(1, 3), Rational(2, 3)}, 3);
  const auto end = [&](const char* name) { return std::stod(json.at(name).get<std::string>()); };
  CHECK((end("lower") <= 1.0 / 3 && end("lower") > 0.33));
  CHECK((end("upper") >= 2.0 / 3 && end("upper") < 0.67));
  CHECK(interval_json({Rational(1, 3), Rational(2, 3)}) == Json{{"lower", "1/3"}, {"upper", "2/3"}});
  CHECK(enclosure_json(std::nullopt).is_null());
  CHECK(numbers_json({Rational(1, 3), 2}) == Json{"1/3", "2"});
}

TEST_CASE("ends of exponents say something where they are positive") {
  const auto part = [](const Enclosure& exponent) { return positive_part(exponent); };
  CHECK((part({1, 2}).lower == Rational(1) && part({1, 2}).upper == Rational(2)));
  CHECK((!part({0, 2}).lower && part({0, 2}).upper == Rational(2)));
  CHECK((!part({-1, 0}).lower && !part({-1, 0}).upper));
  CHECK((!part({std::nullopt, Rational(2)}).lower && part({std::nullopt, Rational(2)}).upper == Rational(2)));
  CHECK((part(Enclosure::at_least(1)).lower == Rational(1) && !part(Enclosure::at_least(1)).upper));
  CHECK(find(mask_facts(make_linear_scheme("dd:n=2")), "support")->text ==
        "mask -3 ... 3, basic limit function [-3, 3]");
}

TEST_CASE("exponents in closed form, where they are short") {
  const LaurentPolynomial three({-3, 1}, 0);
  CHECK(ExponentFormula({0, 2, 1, {three, {3, 0}}}).text() == "-log_2(3)");
  CHECK(ExponentFormula({4, 2, 1, {three, {3, 0}}}).text() == "4 - log_2(3)");
  CHECK(ExponentFormula({4, 3, 2, {three, {3, 0}, 5}}).text() == "4 - 2*log_3(3)/5");
  // Polynomials that are read have 100 characters at most.
  const auto is_short = [](std::size_t length) {
    const Rational constant = power(Rational(10), static_cast<int>(length - std::string("r^3+").size() - 1));
    return ExponentFormula({1, 2, 1, {LaurentPolynomial({constant, 0, 0, 1}, 0), {-1, 0}}}).is_short();
  };
  CHECK(is_short(99));
  CHECK(is_short(100));
  CHECK_FALSE(is_short(101));
}

TEST_CASE("Hermite schemes alone have a spectral degree") {
  const auto of = [](const char* specification) {
    const Scheme scheme = make_refinable_scheme(specification);
    return page_json(regularity_facts(scheme, regularity_of(scheme.mask, {Deadline::in(1)}, {.levels = 4}), {}, {}));
  };
  CHECK(of("ghm").at("spectral_degree").is_null());
  CHECK_FALSE(of("merrien:lambda=-1/8,mu=-1/2").at("spectral_degree").is_null());
}

TEST_CASE("values of a weight: pieces, and the ends where they meet") {
  const Decision yes{Truth::yes, ""}, no{Truth::no, "too large"}, open{Truth::unknown, "no time"};
  WeightRange range{5, {{0, 1, yes}, {1, 2, open}, {2, 3, no}}, {}};
  CHECK_FALSE(is_decided(range));
  // Ends of other pieces decide nothing.
  for (const Rational& low : {Rational(1, 2), Rational(5, 2)}) {
    range.ends = {{low, low + Rational(1, 4), std::nullopt, {}, yes}};
    CHECK_FALSE(is_decided(range));
  }
  for (const auto& [low, high] : {std::pair<Rational, Rational>{1, Rational(3, 2)}, {Rational(3, 2), 2}}) {
    range.ends = {{low, high, std::nullopt, {}, yes}};
    CHECK(is_decided(range));
  }
  range.ends = {{Rational(5, 4), Rational(3, 2), LaurentPolynomial(Rational(4, 3)), {}, no}};
  CHECK(is_decided(range));
  VertexScheme scheme = VertexScheme::named("loop");
  const LatticeMask mask = make_linear_scheme("loop").mask;
  scheme.written = WrittenRules{SectorLattice::triangles, mask, {}, {{'b'}}};
  const Facts list = weight_facts(scheme, {mask, yes, Enclosure::at_least(2), true, nullptr}, WeightProperty::c1,
                                  {range});
  CHECK(find(list, "n = 5")->text ==
        "proved     0 <= b <= 1\nend        b = 4/3, near 5/4: refuted there\nrefuted    2 <= b <= 3: too large");
}

TEST_CASE("rules of least absolute deviations: windows of up to twelve points") {
  const auto list = [](int points, int degree, const std::string& options) {
    data::LeastAbsoluteLimit limit;
    limit.points = points;
    limit.degree = degree;
    const std::string text = fmt::format("l1:points={},d={}{}", points, degree, options);
    return l1_facts(make_l1_scheme(text), limit, {Deadline::in(0)});
  };
  CHECK(find(list(12, 1, ",exact"), "left over") != nullptr);
  CHECK(find(list(14, 1, ",exact"), "left over") == nullptr);
  CHECK(find(list(3, 1, ",exact"), "left over") != nullptr);
  CHECK(find(list(4, 1, ",iterations=2"), "impulse") != nullptr);
  CHECK(find(list(12, 1, ",iterations=2"), "impulse") != nullptr);
  CHECK(find(list(4, 0, ",iterations=2"), "impulse") == nullptr);
}

TEST_CASE("lines of the screen: broken at blanks, no word lost, words that are too long stay whole") {
  CHECK(wrapped("label  one two three", 7, 14) == "label  one two\n       three");
  CHECK(wrapped("label  one two  (three)", 7, 14) == "label  one two\n       (three)");
  CHECK(wrapped("label  123456789", 7, 10) == "label  123456789");
  CHECK(wrapped("label  123456789 and", 7, 10) == "label  123456789\n       and");
  CHECK(wrapped("one\n  two three four\n", 2, 9) == "one\n  two\n  three\n  four\n");
  for (const char* text : {"", " ", "\n", "\n\n", "            ", "one", "label  "}) CHECK(wrapped(text, 2, 5) == text);
  Facts list{plain("", "label", std::string(40, 'x') + " " + std::string(60, 'y') + " z")};
  CHECK(page_text(list, 10) == "label     " + std::string(40, 'x') + "\n          " + std::string(60, 'y') + " z\n");
}

TEST_CASE("lines of the screen: random texts") {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const std::size_t indent = random() % 4, width = indent + 1 + random() % 12;
    std::string text;
    for (std::size_t k = random() % 60; k > 0; --k) text += random() % 3 == 0 ? ' ' : random() % 20 == 0 ? '\n' : 'x';
    CAPTURE(text, indent, width);
    const std::string lines = wrapped(text, indent, width);
    const auto words = [](const std::string& all) {
      std::istringstream stream(all);
      return std::vector<std::string>(std::istream_iterator<std::string>(stream), {});
    };
    CHECK(words(lines) == words(text));
    std::istringstream stream(lines);
    for (std::string line; std::getline(stream, line);) {
      line = line.substr(0, line.find_last_not_of(' ') + 1);
      const std::string tail = line.substr(std::min(line.find_first_not_of(' ', indent), line.size()));
      CHECK((line.size() <= width || tail.find(' ') == std::string::npos));
    }
  }
}
