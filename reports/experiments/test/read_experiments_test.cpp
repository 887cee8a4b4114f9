#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/proofs-checks/file_error.hpp>
#include <subcert/reports/experiments/experiment.hpp>
#include <subcert/reports/experiments/noise_levels.hpp>

using namespace subcert;
using namespace subcert::experiments;

namespace {

/// With the confidence of one interval, "clear" has the interval from -3 to -1, "open" that from -1.5 to 0.5, and
/// "moving" that of width 2 about the choice "place", if there is one.
Measured toy(const Run& run) {
  const double width = 1 / mean_interval({-1, 1}, each_of(1)).half_width,
               place = run.experiment.choices.empty() ? 0 : run.number("place");
  Measured measured;
  measured.samples = {{{"height", "clear"}, {-2 - width, -2 + width}},
                      {{"height", "open"}, {-0.5 - width, -0.5 + width}},
                      {{"height", "moving"}, {place - width, place + width}},
                      {{"error", "a"}, {1, 5}},
                      {{"error", "b"}, {2, 6}},
                      {{"error", "a at 3 dB"}, {7, 7}},
                      {{"noise", "a"}, {0, 4}}};
  measured.numbers = {{"half", 0.5}};
  measured.add_fact("kept", "one", true, "1");
  measured.add_fact("lost", "one", true, "1");
  measured.add_fact("lost", "", false, "2");
  return measured;
}

const std::string head = "[[experiment]]\nid = 'toy'\ntitle = 'A toy'\nsetup = ['<<h>> {half}.']\n";
const std::string text = "[text]\nh = 'Half is'\n";
const std::string words = "[[experiment.claim]]\nsentence = 'A sentence.'\nplace = 'Sec. 1'\n";

std::vector<Experiment> read(const std::string& claim, const std::string& before = "") {
  return read_experiments("paper", text + before + head + words + claim, {{"toy", toy}});
}

/// What is found for one claim.
DecidedClaim decided(const std::string& claim) { return run_experiment(read(claim).front(), {}).result.claims.front(); }

bool holds(const std::string& claim) {
  return decided(claim + "\nstatistic = '{bound}'").finding == ClaimVerdict::holds;
}

/// What the reader says.
std::string refusal(const std::string& whole, const Measures& measures = {{"toy", toy}}) {
  try {
    read_experiments("paper", whole, measures);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("claims need whole intervals on the right side of the bound") {
  const std::string height = "measure = 'height'\n";
  const auto found = [&](const std::string& claim) {
    return decided(height + claim + "\nstatistic = '{bound}'").finding;
  };
  CHECK(found("of = ['clear']\nbelow = 0") == ClaimVerdict::holds);
  CHECK(found("of = ['clear']\nabove = 0") == ClaimVerdict::contrary);
  CHECK(found("of = ['clear']\nabove = -2") == ClaimVerdict::undecided);
  CHECK(found("of = ['clear', 'open']\nbelow = 0") == ClaimVerdict::undecided);
  CHECK(found("of = ['clear', 'open']\nabove = -5") == ClaimVerdict::holds);
  // One that lies wholly elsewhere is enough for the contrary.
  CHECK(found("of = ['clear', 'open']\nabove = 1") == ClaimVerdict::contrary);
  CHECK(holds(height + "of = ['clear']\nbelow = 'half'"));
  CHECK(!holds(height + "of = ['clear']\nabove = 'half'"));
  // Two intervals that hold together with 99 % are wider than one.
  CHECK(found("of = ['clear']\nabove = -3.5") == ClaimVerdict::holds);
  CHECK(found("of = ['clear', 'clear']\nabove = -3.5") == ClaimVerdict::undecided);
  // Bounds and a name of its own; one without a bound is shown only.
  const DecidedClaim claim = decided(height +
                                     "of = [{ of = 'clear', name = '', below = 0 }, { of = 'open' }]\n"
                                     "statistic = 'the middle, {half}'");
  CHECK(claim.finding == ClaimVerdict::holds);
  CHECK(claim.statistic == "the middle, 0.5");
  CHECK(claim.numbers == "-2 ± 1, open: -0.5 ± 1");
  CHECK(claim.recorded == ClaimVerdict::holds);
  CHECK_FAILS(holds(height + "of = ['unknown']\nbelow = 0"), domain);
  CHECK_FAILS(holds(height + "of = ['open']\nbelow = 'unknown'"), domain);
}

TEST_CASE("differences are paired, and facts are wanted all") {
  const DecidedClaim less = decided("measure = 'error'\nof = ['a - b']\nbelow = 0\nstatistic = 'errors: {bound}'");
  CHECK(less.finding == ClaimVerdict::holds);
  CHECK(less.numbers == "a - b: -1 ± 0");
  CHECK(less.statistic == "errors: below 0 with the whole interval, each");
  const std::string above = "above = 'half'\nstatistic = '{bound}'";
  CHECK(decided("measure = 'error'\nof = ['a - b']\nfactor = 0.5\n" + above).numbers.starts_with("a - 0.5 b: 1 ±"));
  const DecidedClaim excess = decided("measure = 'error'\nof = ['a']\nminus = 'noise'\n" + above);
  CHECK(excess.numbers == "a: 1 ± 0");
  CHECK(excess.statistic == "above 0.5 with the whole interval, each");
  CHECK(
      decided(
          "measure = 'height'\nof = [{ of = 'a', measure = 'error', minus = 'noise', factor = 0.5, above = 'half' }]\n"
          "statistic = ''")
          .numbers == "a: 2 ± 254.6");
  CHECK(decided("measure = 'error'\nof = ['a']\nat = '3 dB'\n" + above).numbers == "a: 7 ± 0");
  CHECK(decided("facts = 'kept'\nstatistic = 's'").finding == ClaimVerdict::holds);
  const DecidedClaim lost = decided("facts = 'lost'\nstatistic = 's'\nrecorded = 'contrary shown'");
  CHECK(lost.finding == lost.recorded);
  CHECK(lost.numbers == "one: 1; 2");
  CHECK_FAILS(decided("facts = 'nothing'\nstatistic = 's'"), domain);
}

TEST_CASE("errors over levels of noise: each, some, nearly equal") {
  Measured errors;
  for (int decibel = loudest; decibel <= quietest; ++decibel) {
    errors.samples[error_at("near", decibel)] = {1, 1.0001};
    errors.samples[error_at("far", decibel)] = {1.2, decibel < 5 ? 1.2001 : 1.9};
  }
  const auto of = [&](const Relation& relation) { return relation(errors).truth; };
  CHECK(of(smaller_error({{"near", "far"}}, {1, 4}, At::each_level)) == Truth::yes);
  CHECK(of(smaller_error({{"far", "near"}}, {1, 4}, At::each_level)) == Truth::no);
  const Finding each = smaller_error({{"near", "far"}}, {1, 6}, At::each_level)(errors);
  CHECK(each.truth == Truth::unknown);
  CHECK(each.numbers.starts_with("negative at 1 to 4 dB; positive at none; undecided at 5 to 6; ratio"));
  CHECK(of(smaller_error({{"near", "far"}}, {1, 6}, At::some_level)) == Truth::yes);
  CHECK(of(smaller_error({{"far", "near"}}, {1, 4}, At::some_level)) == Truth::no);
  CHECK(of(smaller_error({{"far", "near"}}, {1, 6}, At::some_level)) == Truth::unknown);
  CHECK(of(nearly_equal_error({{"near", "far"}}, 1.3, {1, 4}, At::each_level)) == Truth::yes);
  CHECK(of(nearly_equal_error({{"near", "far"}}, 1.1, {1, 4}, At::each_level)) == Truth::no);
  CHECK(of(nearly_equal_error({{"near", "far"}}, 1.3, {1, 6}, At::each_level)) == Truth::unknown);
  // Of several pairs each, but some level of one pair is enough.
  const std::vector<Pair> both{{"near", "far"}, {"far", "near"}};
  CHECK(of(smaller_error(both, {1, 4}, At::each_level)) == Truth::no);
  CHECK(of(smaller_error({both[0], both[0]}, {1, 4}, At::each_level)) == Truth::yes);
  CHECK(of(smaller_error(both, {1, 4}, At::some_level)) == Truth::yes);
  CHECK(of(smaller_error({both[1], both[1]}, {1, 4}, At::some_level)) == Truth::no);
  CHECK(of(smaller_error({both[1], both[1]}, {1, 6}, At::some_level)) == Truth::unknown);
  CHECK(of(smaller_error(both, {1, 4}, At::mean_over_levels)) == Truth::no);
  CHECK(of(nearly_equal_error({both[0], {"near", "near"}}, 1.3, {1, 4}, At::each_level)) == Truth::yes);
  CHECK(of(nearly_equal_error({{"near", "near"}, both[0]}, 1.1, {1, 4}, At::each_level)) == Truth::no);
  // The factor counts both ways.
  CHECK(of(nearly_equal_error({{"far", "near"}}, 1.3, {1, 4}, At::each_level)) == Truth::yes);
  CHECK(of(nearly_equal_error({{"far", "near"}}, 1.1, {1, 4}, At::each_level)) == Truth::no);
  // Averaged over the levels first: what is lost at one may be won at the others.
  errors.samples[error_at("mixed", 1)] = {5, 5.0001};
  for (int decibel = 2; decibel <= 4; ++decibel) errors.samples[error_at("mixed", decibel)] = {0.01, 0.0102};
  CHECK(of(smaller_error({{"mixed", "far"}}, {2, 4}, At::mean_over_levels)) == Truth::yes);
  CHECK(of(smaller_error({{"mixed", "far"}}, {1, 4}, At::mean_over_levels)) == Truth::no);
  CHECK(of(smaller_error({{"mixed", "far"}}, {1, 4}, At::each_level)) == Truth::no);
  CHECK(of(nearly_equal_error({{"mixed", "near"}}, 1.3, {1, 4}, At::mean_over_levels)) == Truth::yes);
  CHECK(of(nearly_equal_error({{"mixed", "near"}}, 1.2, {1, 4}, At::mean_over_levels)) == Truth::no);
  CHECK(of(nearly_equal_error({{"near", "mixed"}}, 1.2, {1, 4}, At::mean_over_levels)) == Truth::no);
  // Two intervals are asked to hold together: one alone would do here.
  errors.samples[error_at("near", 1)] = {0.9992, 1.0008};
  errors.samples[error_at("far", 1)] = {1, 1};
  CHECK(of(nearly_equal_error({{"near", "far"}}, 1.3, {1, 1}, At::each_level)) == Truth::unknown);
}

TEST_CASE("a claim is decided over every choice, by its best reading") {
  const auto experiment = [&](const std::string& other, const std::string& claim) {
    const std::string choice = "[[choice]]\nname = 'place'\nopen = 'not printed'\ntaken = '-2'\nothers = ['-3', '" +
                               other + "']\n";
    return read_experiments("paper", text + choice + head + "choices = ['place']\n" + words + claim, {{"toy", toy}})
        .front();
  };
  const auto found = [&](const std::string& other, const std::string& claim) {
    return run_experiment(experiment(other, claim), {}).result;
  };
  const std::string moving = "measure = 'height'\nof = ['moving']\nbelow = 0\nstatistic = '{bound}'\n";
  CHECK(found("-4", moving).claims.front().finding == ClaimVerdict::holds);
  CHECK(found("0", moving).claims.front().finding == ClaimVerdict::undecided);
  CHECK(found("4", moving + "over = []\n").claims.front().finding == ClaimVerdict::holds);
  const DecidedClaim depends = found("4", moving).claims.front();
  CHECK(depends.finding == ClaimVerdict::depends);
  CHECK(depends.numbers ==
        "holds: as taken, place = -3 (as taken: moving: -2 ± 1); contrary: place = 4 (moving: 4 ± 1)");
  CHECK(found("-4", "measure = 'height'\nof = ['moving']\nabove = 0\nstatistic = ''\n").claims.front().finding ==
        ClaimVerdict::contrary);
  // The best reading counts; the others are remarks.
  const std::string readings =
      "[[experiment.claim.reading]]\nread-as = 'harsh'\nfacts = 'lost'\nstatistic = 'harshly'\n"
      "[[experiment.claim.reading]]\nread-as = 'mild'\nfacts = 'kept'\nstatistic = 'mildly'\n";
  const DecidedClaim read = found("4", readings).claims.front();
  CHECK(read.finding == ClaimVerdict::holds);
  CHECK(read.statistic == "read as: mild; mildly");
  REQUIRE(read.readings.size() == 2);
  CHECK(read.readings.back().verdict == ClaimVerdict::contrary);
  // On our data a verdict is a remark, whatever they say; a sentence that is counted elsewhere is none.
  const DecidedClaim own = found("4", "data = 'ours'\n" + readings).claims.front();
  CHECK(own.finding == ClaimVerdict::own_data);
  CHECK(own.recorded == ClaimVerdict::own_data);
  CHECK(own.numbers.starts_with("holds as printed there. "));
  const ExperimentResult elsewhere = found("4", "counted-in = 'other'\n" + readings);
  CHECK(elsewhere.claims.empty());
  CHECK(elsewhere.remarks.size() == 1);
  // A late reading saves a sentence, and does not show it.
  const std::string late =
      "[[experiment.claim.reading]]\nread-as = 'harsh'\nfacts = 'lost'\nstatistic = 'harshly'\n"
      "[[experiment.claim.reading]]\nlate = true\nfacts = 'kept'\nstatistic = 'mildly'\n";
  CHECK(found("4", late).claims.front().finding == ClaimVerdict::depends);
  CHECK(found("4", late).claims.front().statistic.find("chosen after the numbers were seen") != std::string::npos);
  CHECK(found("4", readings + "late = false\n").claims.front().finding == ClaimVerdict::holds);
  CHECK_THROWS_AS(experiment("4", readings + "late = 'true'\n"), FileError);
  CHECK_THROWS_AS(experiment("4", moving + "over = ['time']\n"), FileError);
  // One that says less than the words is not the sentence as printed.
  const std::string weaker = readings + "weaker = true\n";
  CHECK(found("4", weaker).claims.front().finding == ClaimVerdict::weaker);
  CHECK(found("4", weaker).claims.front().statistic.find("(less than the words say)") != std::string::npos);
  CHECK_THROWS_AS(experiment("4", "data = 'theirs'\n" + readings), FileError);
}

TEST_CASE("a reading is open where a decision of it would count") {
  const VariantFinding yes{"a", 2, {Truth::yes, "", ""}}, no{"b", 2, {Truth::no, "", ""}},
      unknown{"c", 2, {Truth::unknown, "", ""}};
  const auto open = [](ClaimVerdict best, const std::vector<VariantFinding>& findings, bool late = false,
                       ClaimVerdict finding = ClaimVerdict::depends) {
    const DecidedReading reading{"", verdict_over(findings), late, false, findings};
    DecidedClaim claim{"", "", finding, "", ""};
    claim.readings = {{"", best, false, false, {}}, reading};
    return is_open(claim, reading);
  };
  CHECK(open(ClaimVerdict::undecided, {no, unknown}));
  CHECK(open(ClaimVerdict::depends, {yes, unknown}));
  CHECK(!open(ClaimVerdict::depends, {no, unknown}));
  CHECK(!open(ClaimVerdict::depends, {yes, unknown}, true));
  CHECK(!open(ClaimVerdict::holds, {yes, unknown}));
  CHECK(!open(ClaimVerdict::undecided, {yes, no}));
  CHECK(!open(ClaimVerdict::undecided, {unknown}, false, ClaimVerdict::own_data));
}

TEST_CASE("what is open is measured again with more samples, and nothing else is") {
  std::map<std::string, std::vector<std::size_t>> runs;  // by the choice
  const Measure measure = [&](const Run& run) {
    runs[run.value].push_back(run.runs);
    Measured measured;
    for (std::size_t i = 0; i < run.runs; ++i)  // clear with 40 samples, open with 10
      measured.samples[{"height", "a"}].push_back(run.value == "far" ? (i % 2 ? 9.0 : 10.0) : (i % 2 ? 4.0 : -2.0));
    return measured;
  };
  const std::string file = "[[choice]]\nname = 'c'\nopen = ''\ntaken = 'near'\nothers = ['far']\n" + text + head +
                           "choices = ['c']\n" + words +
                           "measure = 'height'\nof = ['a']\nabove = -0.7\nstatistic = ''\n";
  Experiment toy = read_experiments("paper", file, {{"toy", measure}}).front();
  toy.setup.clear();
  const ExperimentResult result = run_experiment(toy, {1, 10, 1}).result;
  CHECK(result.claims.front().finding == ClaimVerdict::holds);
  CHECK(result.runs == 40);
  CHECK(runs[""] == std::vector<std::size_t>{10, 40});
  CHECK(runs["far"] == std::vector<std::size_t>{10});
  toy.times = 2;
  CHECK(run_experiment(toy, {1, 10, 1}).result.runs == 80);
}

TEST_CASE("shared claims take values, setups take texts and numbers") {
  const std::string shared =
      "[[shared]]\nname = 'both'\n[[shared.claim]]\nsentence = '{what} is kept.'\nplace = 'Sec. 2'\n"
      "facts = '{topic}'\nstatistic = 's'\nrecorded = '{found}'\n";
  const auto use = [&](const std::string& values) {
    return text + shared + head + "[[experiment.claim]]\nuse = 'both'\nwith = { " + values + " }\n";
  };
  const auto read = read_experiments("paper", use("what = 'It', topic = 'lost', found = 'contrary shown'"),
                                     {{"toy", toy}});
  const ExperimentResult result = run_experiment(read.front(), {}).result;
  CHECK(result.setup == std::vector<std::string>{"Half is 0.5."});
  CHECK(result.claims.front().sentence == "It is kept.");
  CHECK(result.as_recorded());
  CHECK(refusal(use("what = 'It', topic = 'lost', found = 'true'")).find("'true' is no verdict") != std::string::npos);
  CHECK(refusal(use("what = 'It', topic = 'lost', found = 'holds as printed', more = ''")) ==
        "line 15, column 1: the shared claims have no {more}");
  CHECK(refusal(use("topic = 'lost', found = 'holds as printed'")).find("without a value") != std::string::npos);
}

TEST_CASE("what is wrong in a file of experiments is named with its place") {
  const std::string file = text + head + words;
  CHECK(refusal(file) == "line 7, column 1: expected one of the keys 'of', 'facts', 'smaller-error', 'equal-error'");
  CHECK(refusal(file + "facts = 'kept'\nmeasure = 'error'\nstatistic = 's'\n") ==
        "line 11, column 1: unknown key 'measure'; expected one of sentence, place, recorded, data, over, counted-in, "
        "read-as, late, weaker, facts, statistic");
  CHECK(refusal(file + "of = 'a'\nmeasure = 'error'\nstatistic = 's'\n") ==
        "line 10, column 6: expected the list 'of'");
  // What would hold of nothing, or twice.
  const std::string means = file + "of = ['a', 'b']\nmeasure = 'error'\nstatistic = 's'\n";
  CHECK(refusal(means).find("expected 'above' or 'below'") != std::string::npos);
  CHECK(refusal(means + "below = 0\nfactor = 2\n").find("'factor' goes with") != std::string::npos);
  CHECK(refusal(file + "of = ['a - b']\nminus = 'noise'\nmeasure = 'error'\nstatistic = 's'\nbelow = 0\n")
            .find("either a difference") != std::string::npos);
  CHECK(refusal(file + "smaller-error = ['a', 'b']\nfrom = 9\nto = 5\n").find("from <= to") != std::string::npos);
  CHECK(refusal(file + "equal-error = ['a', 'b']\n").find("'within'") != std::string::npos);
  CHECK(refusal(file + "equal-error = ['a', 'b']\nwithin = 0.1\n").find("a factor > 1") != std::string::npos);
  CHECK(refusal(file + "smaller-error = ['a', 'b']\nwhere = 'nowhere'\n").find("'mean' or 'some level'") !=
        std::string::npos);
  CHECK(refusal(means + "below = 0\nrecorded = 'holds'\n").find("contrary shown") != std::string::npos);
  CHECK(refusal(file + "smaller-error = ['a']\n") == "line 10, column 17: expected two texts");
  CHECK(refusal(file + "smaller-error = [['a', 'b'], ['a']]\n") == "line 10, column 30: expected two texts");
  CHECK(refusal(file + "smaller-error = []\n") == "line 10, column 17: expected two texts");
  CHECK(refusal("[text]\n" + head).find("names no text of [text]") != std::string::npos);
  CHECK(refusal(text + "[[choice]]\nname = 'a'\n" + head).find("expected the key 'open'") != std::string::npos);
  CHECK(refusal(text + head + "choices = ['a']\n").find("no [[choice]] of this name") != std::string::npos);
  CHECK(refusal("title = 'A toy'\n").starts_with("line 1, column 1: unknown key 'title'"));
  const std::string fine = text + head;
  CHECK(refusal(fine).empty());
  CHECK(refusal(fine + "times = 3\n").empty());
  for (const char* times : {"0", "101", "1.5", "'2'"})
    CHECK(refusal(fine + "times = " + times + "\n").find("need 1 <= times <= 100") != std::string::npos);
  CHECK(refusal(fine + head).find("the experiment 'toy' is there twice") != std::string::npos);
  CHECK(refusal(fine, {}) == "line 1, column 1: experiments without measure: toy; measures without experiment: none");
  CHECK(refusal(fine, {{"toy", toy}, {"ball", toy}}) ==
        "line 1, column 1: experiments without measure: none; measures without experiment: ball");
}
