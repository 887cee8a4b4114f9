#include "smooth_page.hpp"

#include <subcert/schemes/data/formats/table.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/data/smooth/uniform_grid.hpp>

#include <fmt/format.h>

#include <cmath>
#include <ostream>

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

Json choice_json(const std::optional<data::MethodChoice>& choice) {
  if (!choice) return nullptr;
  Json candidates = Json::array();
  for (const data::SmoothingCandidate& candidate : choice->candidates) candidates.push_back(risk_json(candidate));
  return {{"chosen", risk_json(choice->candidates[choice->chosen])}, {"candidates", candidates}};
}

/// The scheme chosen, and the two best others.
std::string choice_text(const data::MethodChoice& choice) {
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

std::string covered_text(data::BandKind kind) {
  switch (kind) {
    case data::BandKind::prediction: return "pointwise, for a new datum of weight 1 with normal noise";
    case data::BandKind::simultaneous: return "at all positions at once, for the expected value of the limit";
    default: return "pointwise, for the expected value of the limit";
  }
}

std::string noise_line(const std::string& column, const data::NoiseEstimate& noise) {
  if (std::isinf(noise.degrees_of_freedom))
    return fmt::format("# noise of {}: standard deviation {:.6g}, as given\n", column, std::sqrt(noise.variance));
  if (!noise.exists()) return "# noise of " + column + ": not estimated, there are no three neighbouring data\n";
  return fmt::format("# noise of {}: standard deviation {:.6g} from {} second differences, {:.6g} degrees of freedom\n",
                     column, std::sqrt(noise.variance), noise.terms, noise.degrees_of_freedom);
}

}  // namespace

SmoothPage::SmoothPage(const SmoothOptions& how, const data::NamedSamples& what, data::SmoothedSamples smoothed)
    : options(how),
      samples(what),
      result(std::move(smoothed)),
      bands(how.bands() != 0 && !result.columns.front().deviations.empty()) {
  const std::size_t outputs = result.positions.size();
  columns.reserve(2 * result.columns.size());  // what `table` points to stays
  const auto add = [&](const std::string& name, const std::vector<double>& values) {
    header.push_back(name);
    table.push_back(&values);
  };
  add(samples.x_name, result.positions);
  for (std::size_t c = 0; c < result.columns.size(); ++c) {
    const data::SmoothedColumn& column = result.columns[c];
    const std::string prefix = result.columns.size() == 1 ? "" : samples.names[c] + "_";
    add(samples.names[c], column.values);
    if (!column.deviations.empty()) add(prefix + "sd", column.deviations);
    if (!bands) continue;
    std::vector<double>& lower = columns.emplace_back(column.half_widths(options.bands(), options.kind()));
    std::vector<double>& upper = columns.emplace_back(lower);
    for (std::size_t o = 0; o < outputs; ++o) {
      lower[o] = column.values[o] - lower[o];
      upper[o] = column.values[o] + upper[o];
    }
    add(prefix + "lower", lower);
    add(prefix + "upper", upper);
  }
}

Json SmoothPage::json() const {
  Json noise = Json::array(), rows = Json::array();
  for (std::size_t c = 0; c < result.columns.size(); ++c)
    if (const auto& estimate = result.columns[c].noise)
      noise.push_back({{"column", samples.names[c]},
                       {"sigma", std::sqrt(estimate->variance)},
                       {"degrees_of_freedom",
                        std::isinf(estimate->degrees_of_freedom) ? Json() : Json(estimate->degrees_of_freedom)},
                       {"terms", estimate->terms}});
  for (std::size_t o = 0; o < table.front()->size(); ++o) {
    Json& row = rows.emplace_back(Json::array());
    for (const auto* column : table) row.push_back((*column)[o]);
  }
  return {{"scheme", result.method},
          {"auto", result.choice.has_value()},
          {"choice", choice_json(result.choice)},
          {"boundary", options.boundary},
          {"origin", to_text(samples.origin)},
          {"spacing", to_text(samples.spacing)},
          {"at", options.at},
          {"level", options.level},
          {"derivative", options.derivative},
          {"noise", noise},
          {"bands", bands ? Json(options.bands()) : Json()},
          {"bands_kind", bands ? Json(options.bands_kind) : Json()},
          {"columns", header},
          {"rows", rows}};
}

void SmoothPage::write(std::ostream& stream) const {
  write_head(stream);
  write_rows(stream);
}

void SmoothPage::write_head(std::ostream& stream) const {
  if (!options.quiet) {
    stream << "# scheme " << result.method << ", boundary " << options.boundary
           << (options.derivative > 0 ? ", derivative " + std::to_string(options.derivative) : "") << "\n";
    if (result.choice) stream << choice_text(*result.choice);
    for (std::size_t c = 0; c < result.columns.size(); ++c)
      if (const auto& estimate = result.columns[c].noise; estimate && (estimate->exists() || !options.stream))
        stream << noise_line(samples.names[c], *estimate);
    if (bands)
      stream << fmt::format("# bands: {:.6g} % {}; the bias is not in them\n", 100 * options.bands(),
                            covered_text(options.kind()));
    if (!result.columns.front().noise)
      stream << fmt::format(
          "# values {} levels below the output grid, interpolated; no bands, as the scheme is not linear\n",
          data::finer_levels);
  }
  stream << data::header_text(header, samples.separator);
}

void SmoothPage::write_rows(std::ostream& stream) const {
  std::vector<data::TableColumn> views;
  for (const auto* column : table) views.push_back({column->data()});
  data::write_rows(stream, views, table.front()->size(), samples.separator, options.threads());
}

formats::Figure SmoothPage::figure() const {
  formats::Figure figure{"smooth", result.method, "", 1, {}};
  const auto drawn = [&](const std::string& label, std::size_t column) {
    formats::Curve curve{label, {}};
    for (std::size_t o = 0; o < table[0]->size(); ++o) curve.points.emplace_back((*table[0])[o], (*table[column])[o]);
    return curve;
  };
  std::size_t next = 1;  // column of the table
  for (std::size_t c = 0; c < result.columns.size(); ++c) {
    formats::Panel panel{result.method, samples.x_name, samples.names[c], {}, false, "below"};
    if (options.derivative == 0) {
      formats::Curve dots{"data", {}, true, false};
      for (std::size_t i = 0; i < samples.count(); ++i)
        if (samples.weights.empty() || samples.weights[i] > 0)
          dots.points.emplace_back(samples.uniform()
                                       ? data::nearest_double(samples.origin + samples.spacing * Rational(i))
                                       : samples.positions[i],
                                   samples.columns[c][i]);
      panel.curves.push_back(dots);
    }
    panel.curves.push_back(drawn("limit", next++));
    if (!result.columns[c].deviations.empty()) ++next;
    if (bands) {
      formats::Band band{"band", {}, "#c0392b"};
      for (std::size_t o = 0; o < table[0]->size(); ++o)
        band.ends.push_back({(*table[0])[o], (*table[next])[o], (*table[next + 1])[o]});
      panel.bands.push_back(std::move(band));
      next += 2;
    }
    figure.panels.push_back(panel);
  }
  return figure;
}

}  // namespace subcert::cli
