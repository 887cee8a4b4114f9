// The papers in docs/theorems against the program: numbered inequalities, stated constants, and sources that build.

#include <subcert/cmake/catch.hpp>
#include <subcert/proofs-checks/theorems/proofs.hpp>
#include <subcert/proofs-checks/theorems/theorem.hpp>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

using namespace subcert;
using namespace subcert::theorems;

namespace {

std::string file_text(const std::string& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  REQUIRE(text.str().size() > 100);
  return text.str();
}

/// A paper with the files that it reads in their places.
std::string paper(const std::string& name) {
  const std::string folder = SUBCERT_THEOREM_TEXT;
  std::string text = file_text(folder + "/" + name);
  const std::regex input(R"(\\input\{([^}]*)\})");
  for (std::smatch found; std::regex_search(text, found, input);)
    text.replace(static_cast<std::size_t>(found.position()), static_cast<std::size_t>(found.length()),
                 file_text(folder + "/" + found[1].str() + ".tex"));
  return text;
}

const char* const papers[] = {"least-squares-schemes.tex", "variance-curves.tex"};

std::string source() { return paper(papers[0]) + paper(papers[1]); }

std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  std::vector<std::string> found;
  const std::regex expression(pattern);
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it) found.push_back((*it)[1]);
  return found;
}

std::set<std::string> as_set(const std::vector<std::string>& list) { return {list.begin(), list.end()}; }

/// The cells of the row of a table that ends in `% TABLE:NAME`, without blanks.
std::vector<std::string> row(const std::string& text, const std::string& key) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string end = "% " + key;
    if (line.size() < end.size() || line.substr(line.size() - end.size()) != end) continue;
    std::vector<std::string> cells(1);
    for (char c : line.substr(0, line.find("\\\\")))
      if (c == '&')
        cells.emplace_back();
      else if (c != ' ')
        cells.back() += c;
    return cells;
  }
  FAIL("no row " << key);
  return {};
}

/// "K" of "K_3"; names without a degree stay.
std::string head(const std::string& name, int degree) {
  const std::string end = "_" + std::to_string(degree);
  const bool has = name.size() > end.size() && name.substr(name.size() - end.size()) == end;
  return has ? name.substr(0, name.size() - end.size()) : name;
}

void check_cell(const std::string& text, const std::string& key, std::size_t column, const Constant& one) {
  CAPTURE(key, one.name);
  const std::vector<std::string> cells = row(text, key);
  REQUIRE(cells.size() > column + 1);
  CHECK(decimal(cells[column]) == one.value);
  CHECK(cells.back() == "(" + one.check + ")");
}

}  // namespace

/// The numbers of theorems that take longer, which a long test runs.
const std::set<std::string> costly{"T.16", "W.1", "W.2", "W.3"};

TEST_CASE("the text has the numbered inequalities that the program runs", "[long]") {
  std::set<std::string> run;
  for (const char* id : {"conjecture-7", "conjecture-8-n"}) {
    for (const Check& check : proved(id, 1).checks) run.insert(check.id);
    for (const Check& check : proved(id, 3).checks) run.insert(check.id);
  }
  for (const char* id : {"conjecture-8-d", "convergence", "conjecture-8-d-all", "limit-constants-order", "smoothness",
                         "smoothness-dual"})
    for (const Check& check : proved(id, 1).checks) run.insert(check.id);
  for (const Check& check : proved("smoothness-all", 5).checks) run.insert(check.id);
  for (int degree : {3, 7})
    for (const Check& check : proved("conjecture-8-d-all", degree).checks) run.insert(check.id);
  for (int degree : {5, 13})
    for (const Check& check : proved("conjecture-8-d-large", degree).checks) run.insert(check.id);
  const auto tags = matches(source(), R"(\\tag\{([^}]*)\})");
  CHECK(as_set(tags).size() == tags.size());
  run.insert(costly.begin(), costly.end());
  CHECK(as_set(tags) == run);
}

TEST_CASE("the tables of the text state the constants of the program") {
  const std::string text = source();
  std::size_t rows = 0;
  for (const Constant& one : proved("conjecture-7", 1).constants.all()) {
    check_cell(text, "1:" + one.name, 1, one);
    ++rows;
  }
  for (const Constant& one : proved("conjecture-8-n", 1).constants.all()) check_cell(text, "1:" + one.name, 1, one);
  rows += 4;  // n_1, beta_2, beta, s of the table for section 7
  for (const Constant& one : proved("conjecture-8-d", 1).constants.all())
    if (head(one.name, 1) != one.name) {
      check_cell(text, "7:" + head(one.name, 1), 1, one);
      ++rows;
    }
  for (const Constant& one : proved("convergence", 1).constants.all()) {
    check_cell(text, "P:" + one.name, 1, one);
    ++rows;
  }
  std::size_t column = 1;
  for (const auto& [family, degree] : {std::pair{"primal", 5}, {"dual", 3}, {"dual", 4}}) {
    for (const Constant& one : proved("smoothness-all", degree, family).constants.all()) {
      check_cell(text, "X:" + one.name, column, one);
      if (column == 1) ++rows;
    }
    ++column;
  }
  for (int degree : {5, 7, 9, 11, 13, 21, 51, 101}) {
    const std::vector<std::string> cells = row(text, "X_start:" + std::to_string(degree));
    CHECK(decimal(cells.at(1)) == every_smoothness_start(scheme_family("primal"), degree));
    CHECK(decimal(cells.at(2)) == every_smoothness_start(scheme_family("dual"), degree));
  }
  for (int degree : {5, 7, 9, 11})
    for (const Constant& one : proved("conjecture-8-d-large", degree).constants.all()) {
      check_cell(text, "T:" + one.name, static_cast<std::size_t>(degree - 3) / 2, one);
      if (degree == 5) ++rows;
    }
  for (int degree : {3, 5})
    for (const Constant& one : proved("conjecture-8-d-all", degree).constants.all())
      CHECK(proved("conjecture-7", degree).constants[one.name] == one.value);
  CHECK(matches(text, R"((% [0-9PTX]:))").size() == rows);
}

TEST_CASE("the text has the numbers and constants of the theorems that take longer", "[long]") {
  const std::string text = source();
  const Constants rate = proved("rate", 1).constants;
  for (const Constant& one : rate.all()) check_cell(text, "W:" + one.name, 1, one);
  std::set<std::string> run;
  for (const Check& check : proved("rate", 1).checks) run.insert(check.id);
  for (const Check& check : proved("conjecture-8-d", 13).checks) run.insert(check.id);
  for (const Check& check : proved("conjecture-8-d-large", 13).checks) run.erase(check.id);
  CHECK(run == costly);
}

TEST_CASE("the tables for section 7 state the constants that the program finds", "[long]") {
  const std::string text = source();
  const auto n_1 = [](const Theorem& theorem) {
    return theorem.ranges.back().first.substr(std::string("n >= ").size());
  };
  for (int degree : {3, 5, 7, 9, 11, 13}) {
    CAPTURE(degree);
    const auto column = static_cast<std::size_t>(degree + 1) / 2;
    for (const Constant& one : proved("conjecture-7", degree).constants.all())
      check_cell(text, "7:" + head(one.name, degree), column, one);
    CHECK(row(text, "7:n_1")[column] == n_1(proved("conjecture-7", degree)));
  }
  for (const char* family : {"primal-odd", "dual", "dual-odd"})
    for (int degree = 1; degree <= 7; degree += family == std::string("primal-odd") ? 2 : 1) {
      const std::string key = "F:" + (family + (":" + std::to_string(degree)));
      CAPTURE(key);
      const Constants stated = proved("conjecture-7", degree, family).constants;
      const std::vector<std::string> cells = row(text, key);
      CHECK(cells[2] == n_1(prove("conjecture-7", degree, stated, 2, family)));
      CHECK(decimal(cells[3]) == stated["beta_2"]);
      CHECK(decimal(cells[4]) == stated["beta"]);
      CHECK(decimal(cells[5]) == stated["s"]);
      CHECK(decimal(cells[6]) == stated["Delta_" + std::to_string(degree)]);
      CHECK(decimal(cells[7]) == stated["r_" + std::to_string(degree)]);
      CHECK(decimal(cells[8]) == stated["R_" + std::to_string(degree)]);
    }
}

namespace {

void check_smoothness_rows(const std::vector<std::pair<std::string, int>>& rows) {
  const std::string text = source();
  for (const auto& [family, degree] : rows) {
    const std::string d = std::to_string(degree), key = "S:" + family + ":" + d;
    CAPTURE(key);
    const Theorem& theorem = proved("smoothness", degree, family, 2);
    const Constants& stated = theorem.constants;
    const std::vector<std::string> cells = row(text, key);
    const auto bound = [&](std::size_t i) {
      return theorem.ranges.at(theorem.ranges.size() - 3 + i).first.substr(std::string("n >= ").size());
    };
    CHECK(cells[1] == d);
    const std::string& statement = theorem.statement.front();  // For all n >= 7 all limits are C^3: ...
    const std::string first = statement.substr(13, statement.find(' ', 13) - 13),
                      order = statement.substr(statement.find("C^") + 2, 1);
    CHECK(cells[2] == "$C^" + order + "$for$n\\ge" + first + "$");
    CHECK(cells[3] == bound(1));
    CHECK(cells[4] == bound(2));
    CHECK(decimal(cells[5]) == stated["r*_" + d + "'"]);
    CHECK(decimal(cells[6]) == stated["R*_" + d + "'"]);
  }
}

}  // namespace

TEST_CASE("the text states the constants of the theorems on smoothness") {
  const std::string text = source();
  const Constants one = proved("smoothness", 1).constants;
  CHECK(text.find("C = " + to_decimal(one["C"], 6, Rounding::nearest) + " ,") != std::string::npos);
  CHECK(text.find("$s>" + to_decimal(one["s"], 6, Rounding::nearest) + "$ for $n\\ge4$") != std::string::npos);
  check_smoothness_rows({{"dual", 1}});
}

TEST_CASE("the text states all constants of the theorems on smoothness", "[long]") {
  check_smoothness_rows({{"primal-odd", 1}, {"primal", 3}, {"dual", 2}, {"dual-odd", 1}, {"dual-odd", 2}});
}

TEST_CASE("the source of the text is balanced and uses only macros that exist") {
  const std::string text = source();
  for (char c : text) CHECK(static_cast<unsigned char>(c) < 128);
  std::vector<std::string> open;
  const std::regex environment(R"(\\(begin|end)\{([a-zA-Z*]+)\})");
  for (std::sregex_iterator it(text.begin(), text.end(), environment), end; it != end; ++it) {
    if ((*it)[1] == "begin") {
      open.push_back((*it)[2]);
      continue;
    }
    REQUIRE_FALSE(open.empty());
    CHECK(open.back() == (*it)[2]);
    open.pop_back();
  }
  CHECK(open.empty());
  CHECK(std::count(text.begin(), text.end(), '{') == std::count(text.begin(), text.end(), '}'));
  CHECK(std::count(text.begin(), text.end(), '$') % 2 == 0);

  std::set<std::string> known = as_set(matches(text, R"(\\newcommand\{\\([a-zA-Z]+)\})"));
  std::istringstream standard(
      "documentclass usepackage setlength textwidth oddsidemargin textheight topmargin emergencystretch newtheorem "
      "newcommand title author date begin end maketitle section subsection caption "
      "label ref cite bibitem emph texttt text tag qed operatorname mathbb hat frac tfrac binom bigl bigr Bigl Bigr "
      "quad "
      "qquad "
      "sum prod int sup inf max min lim log sin cos sinh cosh exp to mapsto in notin ne le ge pm sim cdot dots infty "
      "partial "
      "lceil rceil alpha beta gamma delta varepsilon zeta eta theta kappa lambda mu xi pi rho sigma tau varphi psi "
      "Gamma Delta Pi Phi Psi Omega Theta input H sqrt left right chi varpi nu epsilon omega iota vartheta theta mp "
      "arcsin appendix Lambda "
      "Im hline endhead langle rangle bar log medskip lfloor rfloor ln cdots scriptsize tabcolsep limsup cot "
      "equiv mathcal dagger ddagger tan");
  for (std::string name; standard >> name;) known.insert(name);
  for (const std::string& name : matches(text, R"(\\([a-zA-Z]+))")) {
    CAPTURE(name);
    CHECK(known.count(name) == 1);
  }
  for (const char* name : papers) {
    const std::string one = paper(name);
    const auto labels = matches(one, R"(\\label\{([^}]*)\})"), items = matches(one, R"(\\bibitem\{([^}]*)\})");
    CHECK(as_set(labels).size() == labels.size());
    for (const std::string& label : matches(one, R"(\\ref\{([^}]*)\})")) {
      CAPTURE(name, label);
      CHECK(as_set(labels).count(label) == 1);
    }
    std::set<std::string> cited;
    for (const std::string& list : matches(one, R"(\\cite(?:\[[^\]]*\])?\{([^}]*)\})")) {
      std::istringstream keys(list);
      for (std::string key; std::getline(keys, key, ',');) cited.insert(key);
    }
    CHECK(as_set(items) == cited);
  }
}
