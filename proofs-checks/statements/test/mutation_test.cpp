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
TEST_CASE("a wrong number in any transcription changes a verdict") {
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
