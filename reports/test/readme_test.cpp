#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/folder.hpp>
#include <subcert/proofs-checks/papers/registry.hpp>
#include <subcert/reports/results.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/ranges.h>

#include <cmath>
#include <numbers>
#include <regex>
#include <sstream>

using namespace subcert;
using namespace subcert::reports;

namespace {

/// Every cell and every claim of a paper with the verdict on record.
Report recorded_report(const statements::Paper& paper) {
  Report report{paper.key, paper.citation, {{"tables", "Tables", {}}}};
  for (const statements::PublishedTable& table : paper.tables) {
    formats::ComparisonTable compared{paper.key, table.id, table.title, table.place, table.grid, {}};
    for (const statements::PublishedCell& cell : table.cells) {
      compared.comparisons.push_back(
          {cell.row, cell.column, cell.scheme, cell.printed, std::string(), cell.recorded, cell.recorded, ""});
      compared.comparisons.back().derived = cell.derived;
    }
    report.sections.front().comparisons.push_back(std::move(compared));
  }
  for (const experiments::Experiment& experiment : experiments::experiments()) {
    if (experiment.paper != paper.key) continue;
    report.experiments.push_back({&experiment, {}, {}});
    for (const experiments::Claim& claim : experiment.claims)
      if (claim.counted_in.empty())
        report.experiments.back().result.claims.push_back(
            {claim.sentence, claim.place, claim.recorded, "", "", claim.recorded});
  }
  return report;
}

/// What a run finds where all verdicts are as recorded.
Findings recorded_findings() {
  Findings findings;
  for (const std::string& key : statements::paper_keys())
    findings.reports.push_back(recorded_report(statements::paper(key)));
  for (const statements::Statement& one : statements::statements())
    findings.statements.push_back(
        {&one, {one.recorded, "", "", "", one.grade == Grade::edge ? std::string("n = 1") : std::string()}, 0});
  return findings;
}

/// With one blank for all white space between words.
std::string in_one_line(const std::string& text) {
  std::istringstream words(text);
  std::string result;
  for (std::string word; words >> word;) result += (result.empty() ? "" : " ") + word;
  return result;
}

void quote(const std::string& page, const std::string& text) {
  CAPTURE(page, text);
  CHECK(in_one_line(testing::content(SUBCERT_SOURCE_DIR "/" + page)).find(text) != std::string::npos);
}
void quote_experiments(const std::string& text) { quote("docs/experiments.md", text); }

/// The experiment with the seed and the samples of a report.
const experiments::ExperimentResult& ran(const std::string& id) {
  static std::map<std::string, experiments::ExperimentResult> results;
  const auto found = results.find(id);
  if (found != results.end()) return found->second;
  const ReportOptions defaults;
  const experiments::ExperimentOptions options{defaults.seed, defaults.runs, defaults.jobs};
  return results[id] = run_experiment(experiments::experiment(id), options).result;
}

/// What this variant says of the reading of a sentence that begin so; an empty beginning is any.
experiments::Finding finding(const std::string& id, const std::string& sentence,
                             const std::string& variant = "as taken", const std::string& reading = "") {
  for (const auto* claims : {&ran(id).claims, &ran(id).remarks})
    for (const experiments::DecidedClaim& claim : *claims)
      for (const experiments::DecidedReading& read : claim.readings)
        for (const experiments::VariantFinding& one : read.findings)
          if (claim.sentence.starts_with(sentence) && read.words.starts_with(reading) && one.variant == variant)
            return one.finding;
  FAIL("no finding: " << id << ", " << sentence << ", " << variant);
  return {};
}

/// All groups of all matches.
std::vector<std::string> groups(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> result;
  for (std::sregex_iterator one(text.begin(), text.end(), expression), end; one != end; ++one)
    for (std::size_t k = 1; k < one->size(); ++k) result.push_back((*one)[k].str());
  return result;
}

Rational value_at_zero(const std::string& scheme) { return limit_values(make_scheme(scheme).mask.curve(), 0).at(0); }

/// "76 and 151".
std::string others(const std::string& id, const std::string& choice) {
  for (const experiments::Choice& one : experiments::experiment(id).choices)
    if (one.name == choice) return fmt::format("{}", fmt::join(one.others, " and "));
  FAIL("no choice " << choice);
  return "";
}

}  // namespace

TEST_CASE("README and docs quote the counts on record") {
  const Findings findings = recorded_findings();
  REQUIRE(findings.as_recorded());
  const std::vector<Result> all = results(findings);
  for (const ResultKind kind : {ResultKind::value, ResultKind::statement, ResultKind::claim}) {
    quote("README.md", counts(all, kind).text());
    for (const std::string& key : statements::paper_keys()) quote("docs/report.md", counts(all, kind, key).text());
  }
  quote("docs/report.md", errata_sentence(counts(all, ResultKind::statement)));
}

TEST_CASE("docs quote what the experiments find on functions", "[long]") {
  const auto shown = [](const std::string& id, const std::string& variant = "as taken",
                        const std::string& reading = "") { return finding(id, "", variant, reading).truth; };
  quote_experiments("S_7 is better than LLR from " +
                    groups(finding("fig5", "S_7", "as taken", "at every").numbers, "negative at ([^;]*) dB").at(0) +
                    " dB");
  const std::string leaving_out = finding("fig6", "", "bandwidth = leaving out", "than LLR, at all").numbers;
  quote_experiments("LLR beats S_3 on f_2 from " + groups(leaving_out, "positive at (\\d+) to 20;").at(0) + " dB on");
  CHECK(shown("fig3") == Truth::yes);
  CHECK(shown("fig4", "as taken", "over") == Truth::yes);
  CHECK(shown("fig6", "as taken", "than LLR, where") == Truth::yes);
  CHECK(shown("fig7", "as taken", "where") == Truth::yes);
  CHECK(shown("fig3", "spacing = 2") == Truth::no);
  CHECK(shown("fig7", "spacing = 2", "where") == Truth::yes);
  CHECK(ran("fig12").as_recorded());
  CHECK(shown("fig13", "spacing = 2") == Truth::yes);
  CHECK(shown("fig11", "spacing = 2") == Truth::yes);
  std::vector<double> ratios;
  for (const std::string& one :
       groups(finding("figs3-7", "The application", "as taken", "in each").numbers, ": ([\\d.]+) \\.\\.\\. ([\\d.]+)"))
    ratios.push_back(std::stod(one));
  REQUIRE(ratios.size() == 10);
  const auto [least, largest] = std::ranges::minmax(ratios);
  quote_experiments(fmt::format("{:.2f} to {:.2f} times those of LLR", least, largest));
  CHECK(finding("figs10-11", "Due to", "as taken", "that of S_5 is larger than the effect of the noise at every")
            .numbers.starts_with("negative at 2 to 20 dB"));
  for (const char* variant : {"spacing = 2", "decibel = 10"})
    CHECK(finding("figs10-11", "For the slowly", variant, "smaller than the effect").truth == Truth::no);
  const std::string on_both = finding("figs10-11", "For the slowly", "as taken", "smaller than on f_4").numbers;
  quote_experiments(fmt::format("it is {:.3f} times that on f_4", std::stod(groups(on_both, ": ([\\d.]+) \\.").at(0))));
}

TEST_CASE("docs quote what the experiments find on curves and surfaces of [DHHS15]") {
  for (const auto& [name, scheme] : {std::pair{"S_3", "primal:n=3"}, std::pair{"S_4^3", "primal:n=4,d=3"}}) {
    const Rational value = value_at_zero(scheme);
    CHECK(value < Rational(1, 2));
    quote_experiments(fmt::format("{:.4f} for {}", data::nearest_double(value), name));
  }
  // cos(2 pi x/24) becomes this many times itself.
  const LimitValues phi = limit_values(make_scheme("primal:n=5").mask.curve(), 0);
  double factor = 0;
  for (std::size_t i = 0; i < phi.values.size(); ++i)
    factor += data::nearest_double(phi.values[i]) *
              std::cos(std::numbers::pi / 12 * data::nearest_double(phi.point(i)));
  quote_experiments(fmt::format("takes {} % off the radius", std::lround(100 * (1 - factor))));
  const double covered = 50 / (100 * std::numbers::pi), period = 2 * std::numbers::pi;
  quote_experiments(
      fmt::format("cover {:.3f} of {:.3f}, {:.1f} % of the period", covered, period, 100 * covered / period));
}

TEST_CASE("docs quote what the experiments find on l1 schemes and cars", "[long]") {
  for (const char* count : {"2", "3"})
    CHECK(groups(finding("l1-fig2", "The basic", std::string("fits = ") + count).numbers, "D_\\d: (\\d) of") ==
          std::vector<std::string>{"2", "2", "2"});
  for (const char* variant : {"as taken", "fits = 7"})
    CHECK(groups(finding("l1-fig2", "The basic", variant).numbers, "D_\\d: (\\d) of") ==
          std::vector<std::string>{"2", "4", "2"});
  quote_experiments(
      "functions of D_6 and D_8 have two peaks and a valley, that of D_7 has four peaks with 6 or 7 fits and two with "
      "2 "
      "or 3");
  quote_experiments(others("l1-exp1", "data") + " data");
  quote_experiments("the interval [-" + others("l1-exp1", "half interval") + ", ");
  quote_experiments("heights from " + others("l1-exp1", "heights") + " to 6");
  quote_experiments("on surfaces grids of 21, " + others("l1-surface1", "grid") + " points");
  quote_experiments(others("l1-surface2", "outliers of the band"));
  const auto noise_alone = [](const std::string& variant) {
    return finding("l1-exp2", "The algorithm is suitable", variant, "it removes").truth;
  };
  CHECK(noise_alone("as taken") == Truth::no);
  CHECK(noise_alone("data = 151") == Truth::yes);
  CHECK(finding("l1-exp1", "The algorithm is suitable", "as taken", "in the root").truth == Truth::no);
  CHECK(groups(finding("l1-exp2", "In most of the cases").numbers, ": (\\S+) ") == std::vector<std::string>(3, "1"));
  const std::string explained = finding("aary-fig3", "The cubic polynomial just").numbers;
  quote_experiments(fmt::format("explains {} %", std::lround(100 * std::stod(explained))));
}

TEST_CASE("docs quote what the experiments find on surfaces with outliers", "[long]") {
  const auto wins = [](const std::string& id, const std::string& variant) {
    return finding(id, id == "l1-surface1" ? "Each D_k" : "The l1 schemes outperform", variant).truth;
  };
  CHECK(wins("l1-surface1", "noise = deviation 0.1") == Truth::yes);
  CHECK(wins("l1-surface1", "grid = 41") == Truth::no);
  CHECK(wins("l1-surface2", "as taken") == Truth::no);
  CHECK(wins("l1-surface2", "outliers of the band = 100") == Truth::yes);
  quote_experiments(
      "with an outlier and noise of deviation 0.1 D_k wins, with noise of variance 0.1 among 1681 data S_k does");
  quote_experiments("with 13 outliers among 2000 points of the band S_k wins, with 100 D_k does");
  std::map<std::string, long> small;
  for (const char* variant : {"as taken", "grid = 31", "grid = 41", "refinements = 2"})
    small[variant] = std::lround(
        800 * std::stod(groups(finding("l1-surface1", "The errors of Table 3", variant, "at least").numbers,
                               "D_6: ([\\d.e-]+) ")
                            .at(0)));
  CHECK(small ==
        std::map<std::string, long>{{"as taken", 0}, {"grid = 31", 0}, {"grid = 41", 0}, {"refinements = 2", 1}});
  quote_experiments(
      "of 800 samples none leaves D_6 so little, on 441, 961 or 1681 data, and one after two refinements");
}
