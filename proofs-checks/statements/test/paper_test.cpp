#include "../statement.hpp"

#include <subcert/cmake/catch.hpp>
#include <subcert/proofs-checks/file_error.hpp>

using namespace subcert;
using namespace subcert::statements;

namespace {

const Check passes = [](const Context&) { return Outcome{StatementVerdict::holds, "", "", ""}; };

const std::string head = "citation = 'A paper.'\n[transcription]\nwidth = '{4 => 2}*n'\nlist = '[1, 2]/3'\n";

const std::string one_statement = R"(
[[statement]]
id = 'eq-1'
place = 'equation (1)'
claim = 'The width.'
latex = '''
  w =
  <<width>>'''
recorded = 'misprint'
grade = 'number'
sentence = 'The width is 4n.'
readings = 'of both sides'
)";

const std::string one_table = R"(
[[table]]
id = 'table1'
title = 'Maxima'
place = 'Table 1'
layout = 'grid'
row = 'd={d}, n={n}'
column = '{quantity}'
scheme = 'primal:n={n},d={d}'
columns = [{ quantity = 'maximum', words = 'maxima' }, { quantity = 'support' }]
rows = [
  { d = 1, n = 2, printed = ['{0.5 => 0.6}', '<<width>>'] },
  { d = 3, n = 4, printed = ['0.25', '[<<list>>, <<width>>]'], recorded = ['open', 'match'] }]
)";

/// What the reader says.
std::string refusal(const std::string& text, const Checks& checks = {}) {
  try {
    read_paper("paper", text, checks);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a paper is read: statements, transcriptions, tables") {
  const Paper paper = read_paper("paper", head + one_statement + one_table, {{"eq-1", passes}});
  CHECK(paper.citation == "A paper.");
  REQUIRE(paper.statements.size() == 1);
  CHECK(paper.statements[0].id == "paper/eq-1");
  CHECK(paper.statements[0].printed == "w = <<width>>");
  // The correction is the same text where the file gives none.
  CHECK(paper.statements[0].corrected == "w = <<width>>");
  const std::vector<PublishedCell>& cells = paper.table("table1").cells;
  REQUIRE(cells.size() == 4);
  CHECK(cells[0].row == "d=1, n=2");
  CHECK(cells[0].column == "maximum");
  CHECK(cells[0].scheme == "primal:n=2,d=1");
  CHECK(*cells[2].n == 4);
  CHECK(*cells[2].d == 3);
  // The words of a column are a transcription, and a transcription may stand in a cell.
  CHECK(paper.transcriptions.words("maxima", Form::printed) == std::vector<std::string>{"0.5", "0.25"});
  CHECK(paper.transcriptions.words("maxima", Form::corrected) == std::vector<std::string>{"0.6", "0.25"});
  CHECK(cells[0].printed == "0.5");
  CHECK(cells[1].printed == "8");
  CHECK(cells[3].printed == "[[1,2]/3, 16]");
  // A marked place is on record as a mismatch.
  CHECK(cells[0].recorded == ValueVerdict::mismatch);
  CHECK(cells[1].recorded == ValueVerdict::mismatch);
  CHECK(cells[2].recorded == ValueVerdict::open);
  CHECK(Context(paper, Tier::quick).cells("maxima").size() == 2);
}

TEST_CASE("statements and checks match one to one") {
  CHECK(refusal(head + one_statement) ==
        "line 1, column 1: statements without check: eq-1; checks without statement: none");
  CHECK(refusal(head + one_statement, {{"eq-1", passes}, {"eq-2", passes}, {"eq-3", passes}}) ==
        "line 1, column 1: statements without check: none; checks without statement: eq-2, eq-3");
  CHECK(refusal(head + one_statement + one_statement, {{"eq-1", passes}}).find("'eq-1' is there twice") !=
        std::string::npos);
  const Paper paper = read_paper(
      "paper", head + "[[statement]]\nid = 'a'\nplace = 'b'\nclaim = 'c'\nlatex = 'd'\nnot-checkable = 'lost'\n", {});
  CHECK(check(paper.statements[0], Context(paper, Tier::quick)).argument == "lost");
}

TEST_CASE("a fault is followed in one step") {
  const std::string second =
      "[[statement]]\nid = 'eq-2'\nplace = 'b'\nclaim = 'c'\nlatex = 'd'\nrecorded = "
      "'misprint'\ngrade = 'slip'\nsentence = 's'\nreadings = 'r'\n";
  const Checks both{{"eq-1", passes}, {"eq-2", passes}};
  CHECK(read_paper("paper", head + one_statement + second + "follows = 'eq-1'\n", both).statements[1].follows ==
        "paper/eq-1");
  for (const char* id : {"eq-2", "eq-3"})
    CHECK(refusal(head + one_statement + second + "follows = '" + id + "'\n", both).find("which is no first fault") !=
          std::string::npos);
}

TEST_CASE("what is no paper is refused with its place") {
  const auto says = [](const std::string& text, const std::string& expected) {
    CAPTURE(text, refusal(text));
    CHECK(refusal(text).find(expected) != std::string::npos);
  };
  says("citation = 1", "line 1, column 12: expected a text in quotes");
  says("title = 'x'",
       "line 1, column 1: unknown key 'title'; expected one of citation, transcription, statement, table");
  says("[transcription]\n", "expected the key 'citation'");
  says(head + "a b = 3", "line 5, column 3: not TOML: ");
  says(head + "[[statement]]\nname = 'x'", "line 6, column 1: unknown key 'name'");
  says(head + "[[statement]]\nid = 'x'", "line 5, column 1: expected the key 'place'");
  const std::string first = head + "[[statement]]\nid = 'a'\nplace = 'b'\nclaim = 'c'\nlatex = 'd'\n";
  says(first, "line 5, column 1: expected either 'recorded' or 'not-checkable'");
  // What is wrong has a grade, the words of the paper and how they were read; what is right has none but an edge.
  const std::string words = "sentence = 's'\nreadings = 'r'\n";
  says(first + "recorded = 'misprint'", "line 5, column 1: expected a grade: slip, number or claim");
  says(first + "recorded = 'misprint'\ngrade = 'edge'\n" + words, "expected a grade: slip, number or claim");
  says(first + "recorded = 'holds'\ngrade = 'slip'\n" + words, "expected no grade but edge");
  says(first + "recorded = 'holds'\ngrade = 'small'", "'small' is no verdict; expected one of slip, edge");
  says(first + "recorded = 'false'\ngrade = 'claim'", "expected the key 'sentence'");
  says(first + "recorded = 'false'\ngrade = 'claim'\nsentence = 's'", "expected the key 'readings'");
  says(first + "recorded = 'right'", "line 10, column 12: 'right' is no verdict; expected one of");
  says(first + "not-checkable = 'x'\nexperiments = 'fig3'", "line 11, column 15: 'experiments' takes a list of texts");
  const std::string grid = head +
                           "[[table]]\nid = 'a'\ntitle = 'b'\nplace = 'c'\nlayout = 'grid'\ncolumns = [{}, {}]\n";
  says(grid + "rows = [{ printed = ['1'] }]", "line 11, column 21: expected 2 values, one a column");
  says(grid + "rows = [{ n = 'one' }]", "line 11, column 15: expected an integer");
  says(grid + "printed = '1'", "line 11, column 1: unknown key 'printed'");
  says(grid + "rows = [{ n = 1 }]", "expected the key 'printed'");
}
