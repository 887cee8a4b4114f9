#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/proofs-checks/file_error.hpp>
#include <subcert/reports/experiments/experiment.hpp>
#include <subcert/reports/experiments/noise_levels.hpp>

using namespace subcert;
using namespace subcert::experiments;

namespace {

/// "clear" has the interval from -3 to -1, "open" that from -1.5 to 0.5.
Measured toy(const Run&) {
  const double width = 1 / mean_interval({-1, 1}).half_width;
  Measured measured;
  measured.samples = {{{"height", "clear"}, {-2 - width, -2 + width}},
                      {{"height", "open"}, {-0.5 - width, -0.5 + width}},
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
  CHECK(holds(height + "of = ['clear']\nbelow = 0"));
  CHECK(!holds(height + "of = ['clear', 'open']\nbelow = 0"));
  CHECK(holds(height + "of = ['clear', 'open']\nabove = -4"));
  CHECK(!holds(height + "of = ['clear', 'open']\nabove = -2"));
  CHECK(holds(height + "of = ['open']\nbelow = 'half'") == (-0.5 + 1 < 0.5));
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
    errors.samples[error_at("near", decibel)] = {1, 1.01};
    errors.samples[error_at("far", decibel)] = {1.05, decibel < 5 ? 1.06 : 1.5};
  }
  CHECK(smaller_error("near", "far", 1, 4, At::each_level)(errors).verdict == ClaimVerdict::holds);
  const Finding each = smaller_error("near", "far", 1, 6, At::each_level)(errors);
  CHECK(each.verdict == ClaimVerdict::contrary);
  CHECK(each.numbers.starts_with("negative at 1 to 4 dB; positive at none; undecided at 5 to 6; ratio"));
  CHECK(smaller_error("near", "far", 1, 6, At::some_level)(errors).verdict == ClaimVerdict::holds);
  CHECK(nearly_equal_error("near", "far", 0.3)(errors).verdict == ClaimVerdict::holds);
  CHECK(nearly_equal_error("near", "far", 0.1)(errors).verdict == ClaimVerdict::contrary);
}

TEST_CASE("shared claims take values; setups take texts and numbers") {
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
        "line 11, column 1: unknown key 'measure'; expected one of sentence, place, recorded, facts, statistic");
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
  CHECK(refusal(means + "below = 0\nrecorded = 'holds'\n").find("'contrary shown'") != std::string::npos);
  CHECK(refusal(file + "smaller-error = ['a']\n") == "line 10, column 17: expected two texts");
  CHECK(refusal("[text]\n" + head).find("names no text of [text]") != std::string::npos);
  CHECK(refusal("title = 'A toy'\n").starts_with("line 1, column 1: unknown key 'title'"));
  const std::string fine = text + head;
  CHECK(refusal(fine).empty());
  CHECK(refusal(fine + head).find("the experiment 'toy' is there twice") != std::string::npos);
  CHECK(refusal(fine, {}) == "line 1, column 1: experiments without measure: toy; measures without experiment: none");
  CHECK(refusal(fine, {{"toy", toy}, {"ball", toy}}) ==
        "line 1, column 1: experiments without measure: none; measures without experiment: ball");
}
