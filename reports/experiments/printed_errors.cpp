#include "printed_errors.hpp"

#include <subcert/reports/formats/published.hpp>

#include <algorithm>

namespace subcert::experiments {
namespace {

std::string smallest_to_largest(const std::vector<double>& values) {
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  return short_number(*least) + " to " + short_number(*largest);
}

}  // namespace

formats::ComparisonTable printed_errors(const std::string& paper, const std::string& table, const Measured& measured) {
  const formats::PublishedTable printed = formats::published_paper(paper).table(table);
  formats::ComparisonTable result{paper, printed.id, printed.title, printed.place, printed.grid, {}};
  for (const formats::PublishedCell& cell : printed.cells) {
    const auto& errors = measured.at({"error", cell.column});
    result.comparisons.push_back(
        {cell.row, cell.column, cell.scheme, cell.printed, mean_interval(errors).text(), Verdict::not_reproducible,
         cell.recorded,
         "The printed value rests on one unpublished sample; over our samples the error runs from " +
             smallest_to_largest(errors) + "."});
  }
  return result;
}

DecidedClaim printed_errors_claim(const std::string& paper, const std::string& table, const Measured& measured) {
  const formats::PublishedTable printed = formats::published_paper(paper).table(table);
  std::string numbers;
  for (const formats::PublishedCell& cell : printed.cells)
    numbers += (numbers.empty() ? "" : "; ") + cell.column + ": printed " + cell.printed + ", ours " +
               smallest_to_largest(measured.at({"error", cell.column}));
  return {"The errors of " + printed.title + ".",
          printed.place,
          "the data were not published; the printed values beside the range over our samples",
          Verdict::not_reproducible,
          numbers,
          Verdict::not_reproducible};
}

}  // namespace subcert::experiments
