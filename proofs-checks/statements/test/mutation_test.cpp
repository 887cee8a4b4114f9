#include <subcert/cmake/catch.hpp>
#include <subcert/proofs-checks/papers/registry.hpp>

#include <algorithm>
#include <map>

using subcert::StatementVerdict;
using namespace subcert::statements;

namespace {

struct Result {
  std::string verdict;  ///< or the error
  std::string witness;

  bool differs(const Result& other, bool with_witness) const {
    return verdict != other.verdict || (with_witness && witness != other.witness);
  }
};

Result result(const Statement& statement, const Context& context) {
  try {
    const Outcome outcome = check(statement, context);
    return {to_text(outcome.verdict), outcome.witness};
  } catch (const std::exception& error) {
    return {std::string("error: ") + error.what(), ""};
  }
}

struct Reader {
  const Statement* statement;
  Result unchanged;
};

}  // namespace

// Every number of every transcription is changed, one at a time. Where the printed form is wrong, a wrong number stays
// a wrong number: in the printed side of a misprint and in what a false claim reads, the witness must change.
TEST_CASE("a wrong number in any transcription changes a verdict", "[long]") {
  for (const Paper& paper : papers()) {
    std::map<std::string, std::vector<Reader>> readers;
    for (const Statement& statement : paper.statements) {
      const Context context(paper, Tier::quick);
      const Result unchanged = result(statement, context);
      CAPTURE(statement.id);
      CHECK(unchanged.verdict == to_text(statement.recorded));
      for (const std::string& id : context.read()) readers[id].push_back({&statement, unchanged});
    }
    for (const std::string& id : paper.transcriptions.ids()) {
      const std::string& text = paper.transcriptions.text(id);
      for (std::size_t i = 0; i < number_count(text); ++i) {
        const std::string changed = with_changed_number(text, i);
        const Transcriptions mutated = paper.transcriptions.with(id, changed);
        const bool caught = std::any_of(readers[id].begin(), readers[id].end(), [&](const Reader& reader) {
          const bool with_witness = is_in_misprint(text, i) ||
                                    reader.statement->recorded == StatementVerdict::false_claim;
          return result(*reader.statement, Context(paper, mutated, Tier::quick))
              .differs(reader.unchanged, with_witness);
        });
        CAPTURE(paper.key, id, changed);
        CHECK(caught);
      }
    }
  }
}

// Forms that are wrong in other ways than by a number, each for a line of a check that nothing else guards.
TEST_CASE("a wrong form changes the verdict of a proof for all parameters") {
  struct Wrong {
    const char* paper;
    const char* statement;
    const char* transcription;
    const char* text;
  };
  const std::vector<Wrong> all{
      {"mustafa-bari-2016", "theorem-2.3", "p", "r - n"},
      {"mustafa-bari-2016", "theorem-2.3", "p", "1 - n - r"},
      {"mustafa-bari-2016", "theorem-2.4", "b", "r - n"},
      {"mustafa-bari-2016", "theorem-2.4", "b", "-n - r"},
      {"mustafa-bari-2016", "approximating", "b", "8*n*(n + 2)*(2*n + 3)*(n^2 - 1)*(4*n^2 - 1)*a^3"},
      {"mustafa-bari-2016", "approximating", "position-2n", "q/a"},
      {"mustafa-bari-2016", "approximating", "position-2n", "(q + 1)/a"},
      {"mustafa-bari-2016", "approximating", "position-odd", "q/a"},
      {"mustafa-bari-2016", "approximating", "position-odd", "q/(2*a) - 1"},
      {"mustafa-bari-2016", "non-tensor", "rules-y", "[1/4, 2, 3/4, 3/4]"},
      {"mustafa-bari-2016", "datum-index", "datum-index", "{r => i - r}"},
      {"mustafa-li-2015", "proposition-1", "s-2n-even", "1/(2*n)*(1 - (2*j - 1)/(2*n - 1))"},
      {"mustafa-li-2015", "proposition-1", "s-2n-odd", "1/(2*n)*(1 + (2*j - 1)/(2*n - 1))"},
      {"mustafa-li-2015", "global-optimum", "eq-3-objective", "w^2*(f - beta1 - r*beta2)^2"},
      {"mustafa-li-2015", "starting-value", "eq-2", "(f - beta1 + beta2*r)^2 + delta"},
      {"mustafa-li-2015", "starting-value", "eq-3-weight", "(f - beta1 + r*beta2)^2 + delta"},
      {"mustafa-li-2015", "more-robust", "s-2n-odd", "1/(2*n)*(1 + (6*j - 3)/(2*n - 1))"},
      {"mustafa-li-2015", "advice-delta", "eq-2", "(f - beta1 - beta2*r)^2 + 2*delta"},
      {"mustafa-li-2015", "advice-many-fits", "eq-2", "(f - beta1 + beta2*r)^2 + delta"},
      {"mustafa-hameed", "remark-2.1-delta", "eq-2.6", "(f - beta0 - beta1*r)^2 + delta"},
      {"mustafa-hameed", "stopping", "eq-2.6", "(f - beta0 - beta1*r)^2 + delta"},
      {"mustafa-li-2015", "outlier-weight", "eq-9-factor", "0"},
      {"mustafa-li-2015", "outlier-weight", "eq-9-beta-2", "-1/(4*n^3 - n)*(6*r - 3)"},
      {"mustafa-hameed", "not-interpolatory", "positions", "[1/4, 1]"}};
  for (const Wrong& one : all) {
    CAPTURE(one.statement, one.transcription, one.text);
    const Paper& of = paper(one.paper);
    const auto id = of.key + "/" + one.statement;
    const auto found = std::ranges::find(of.statements, id, &Statement::id);
    REQUIRE(found != of.statements.end());
    const Transcriptions wrong = of.transcriptions.with(one.transcription, one.text);
    CHECK(check(*found, Context(of, wrong, Tier::quick)).verdict != found->recorded);
  }
}
