#include "smooth_page.hpp"

#include <subcert/schemes/data/refine/axis_refinement.hpp>

#include <fmt/format.h>

#include <cmath>

namespace subcert::cli {
namespace {

Json risk_json(const data::SmoothingCandidate& candidate) {
  return {{"scheme", candidate.specification},
          {"bias_squared", candidate.risk.bias_squared},
          {"variance", candidate.risk.variance},
          {"expected_squared_error", candidate.risk.total()}};
}

std::string risk_line(const data::SmoothingCandidate& candidate) {
  return fmt::format("#   {}: {:.6g} = bias^2 {:.6g} + variance {:.6g}\n", candidate.specification,
                     candidate.risk.total(), candidate.risk.bias_squared, candidate.risk.variance);
}

Json choice_json(const std::optional<data::SchemeChoice>& choice) {
  if (!choice) return nullptr;
  Json candidates = Json::array();
  for (const data::SmoothingCandidate& candidate : choice->candidates) candidates.push_back(risk_json(candidate));
  return {{"chosen", risk_json(choice->candidates[choice->chosen])}, {"candidates", candidates}};
}

/// The scheme chosen, and the two best others.
std::string choice_text(const data::SchemeChoice& choice) {
  std::string text = fmt::format(
      "# chosen for the smallest estimated mean squared error at the data, of {} schemes{}\n", choice.candidates.size(),
      choice.chosen == 0 ? "" : ", among those with continuous derivatives of this order");
  text += risk_line(choice.candidates[choice.chosen]);
  if (choice.widest_tried()) text += "#   more points were not tried for this degree\n";
  for (std::size_t i = 0, shown = 0; i < choice.candidates.size() && shown < 2; ++i)
    if (i != choice.chosen) {
      text += risk_line(choice.candidates[i]);
      ++shown;
    }
  return text;
}

std::string noise_line(const std::string& column, const data::NoiseEstimate& noise) {
  if (noise.terms == 0) return "# noise of " + column + ": not estimated, there are no three neighbouring data\n";
  return fmt::format("# noise of {}: standard deviation {:.6g} from {} second differences, {:.6g} degrees of freedom\n",
                     column, std::sqrt(noise.variance), noise.terms, noise.degrees_of_freedom);
}

}  // namespace

SmoothPage::SmoothPage(const SmoothOptions& how, const NamedSamples& what, std::string scheme,
                       std::optional<data::SchemeChoice> chosen, data::SmoothedSamples smoothed)
    : options(how),
      samples(what),
      specification(std::move(scheme)),
      choice(std::move(chosen)),
      result(std::move(smoothed)),
      bands(how.bands() != 0 && !result.columns.front().deviations.empty()) {
  std::vector<std::vector<double>> columns{{}};
  for (const Rational& position : result.positions)
    columns[0].push_back(data::nearest_double(samples.origin + samples.spacing * position));
  table.separator = samples.separator;
  table.header = {samples.x_name};
  const auto add = [&](const std::string& name, const std::vector<double>& values) {
    table.header.push_back(name);
    columns.push_back(values);
  };
  for (std::size_t c = 0; c < result.columns.size(); ++c) {
    const data::SmoothedColumn& column = result.columns[c];
    const std::string prefix = result.columns.size() == 1 ? "" : samples.names[c] + "_";
    add(samples.names[c], column.values);
    if (!column.deviations.empty()) add(prefix + "sd", column.deviations);
    if (!bands) continue;
    const std::vector<double> widths = column.half_widths(options.bands());
    std::vector<double> lower = column.values, upper = column.values;
    for (std::size_t o = 0; o < widths.size(); ++o) {
      lower[o] -= widths[o];
      upper[o] += widths[o];
    }
    add(prefix + "lower", lower);
    add(prefix + "upper", upper);
  }
  table.columns = columns.size();
  for (std::size_t o = 0; o < columns[0].size(); ++o)
    for (const auto& column : columns) table.values.push_back(column[o]);
}

Json SmoothPage::json() const {
  Json noise = Json::array(), rows = Json::array();
  for (std::size_t c = 0; c < result.columns.size(); ++c)
    if (const auto& estimate = result.columns[c].noise)
      noise.push_back({{"column", samples.names[c]},
                       {"sigma", std::sqrt(estimate->variance)},
                       {"degrees_of_freedom", estimate->degrees_of_freedom},
                       {"terms", estimate->terms}});
  for (auto row = table.values.begin(); row != table.values.end(); row += static_cast<long>(table.columns))
    rows.push_back(std::vector<double>(row, row + static_cast<long>(table.columns)));
  return {{"scheme", specification},
          {"auto", choice.has_value()},
          {"choice", choice_json(choice)},
          {"boundary", options.boundary},
          {"origin", to_text(samples.origin)},
          {"spacing", to_text(samples.spacing)},
          {"level", options.level},
          {"derivative", options.derivative},
          {"noise", noise},
          {"bands", bands ? Json(options.bands()) : Json()},
          {"columns", table.header},
          {"rows", rows}};
}

std::string SmoothPage::text() const {
  if (options.quiet) return to_text(table);
  std::string text = "# scheme " + specification + ", boundary " + options.boundary +
                     (options.derivative > 0 ? ", derivative " + std::to_string(options.derivative) : "") + "\n";
  if (choice) text += choice_text(*choice);
  for (std::size_t c = 0; c < result.columns.size(); ++c)
    if (const auto& estimate = result.columns[c].noise) text += noise_line(samples.names[c], *estimate);
  if (bands)
    text += fmt::format("# bands: {:.6g} % pointwise, for the expected value of the limit; the bias is not in them\n",
                        100 * options.bands());
  if (!result.columns.front().noise)
    text += fmt::format(
        "# values {} levels below the output grid, interpolated; no bands, as the scheme is not linear\n",
        data::finer_levels);
  return text + to_text(table);
}

formats::Figure SmoothPage::figure() const {
  formats::Figure figure{"smooth", specification, "", 1, {}};
  const auto drawn = [&](const std::string& label, std::size_t column) {
    formats::Curve curve{label, {}};
    for (std::size_t i = 0; i < table.values.size(); i += table.columns)
      curve.points.emplace_back(table.values[i], table.values[i + column]);
    return curve;
  };
  std::size_t next = 1;  // column of the table
  for (std::size_t c = 0; c < result.columns.size(); ++c) {
    formats::Panel panel{specification, samples.x_name, samples.names[c], {}, false, "below"};
    if (options.derivative == 0) {
      formats::Curve dots{"data", {}, true, false};
      for (std::size_t i = 0; i < samples.count(); ++i)
        if (samples.weights.empty() || samples.weights[i] > 0)
          dots.points.emplace_back(data::nearest_double(samples.origin + samples.spacing * Rational(i)),
                                   samples.columns[c][i]);
      panel.curves.push_back(dots);
    }
    panel.curves.push_back(drawn("limit", next++));
    if (!result.columns[c].deviations.empty()) ++next;
    if (bands) {
      panel.curves.push_back(drawn("lower", next++));
      panel.curves.push_back(drawn("upper", next++));
    }
    figure.panels.push_back(panel);
  }
  return figure;
}

}  // namespace subcert::cli
