#include "smooth_page.hpp"

#include <subcert/schemes/data/formats/table.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

namespace subcert::cli {
namespace {

Json risk_json(const data::SmoothingCandidate& candidate) {
  Json json{{"scheme", candidate.specification},
            {"bias_squared", candidate.risk.bias_squared},
            {"variance", candidate.risk.variance},
            {"expected_squared_error", candidate.risk.total()}};
  if (candidate.range) json["likely_range"] = {candidate.range->first, candidate.range->second};
  return json;
}

std::string risk_line(const data::SmoothingCandidate& candidate) {
  if (const auto& range = candidate.range)
    return fmt::format("#   {}: most likely from {:.2g} to {:.2g}\n", candidate.specification, range->first,
                       range->second);
  return fmt::format("#   {}: {:.6g} = bias^2 {:.6g} + variance {:.6g}\n", candidate.specification,
                     candidate.risk.total(), candidate.risk.bias_squared, candidate.risk.variance);
}

}  // namespace

Json choice_json(const std::optional<data::MethodChoice>& choice) {
  if (!choice) return nullptr;
  Json candidates = Json::array();
  for (const data::SmoothingCandidate& candidate : choice->candidates) candidates.push_back(risk_json(candidate));
  return {{"chosen", candidates.front()}, {"candidates", candidates}};
}

std::string choice_text(const data::MethodChoice& choice, const SmoothOptions& options) {
  std::string text = fmt::format(
      "# chosen for the smallest estimated mean squared error{} at the data{}, of {} methods\n",
      options.derivative > 0 ? " of the derivative" : "", options.select == "cv" ? ", by cross-validation" : "",
      choice.candidates.size());
  for (std::size_t i = 0; i < std::min<std::size_t>(3, choice.candidates.size()); ++i)
    text += risk_line(choice.candidates[i]);
  if (choice.widest_tried()) text += "#   more points were not tried for this degree\n";
  return text;
}

std::string covered_text(data::BandKind kind) {
  switch (kind) {
    case data::BandKind::prediction: return "pointwise, for a new datum of weight 1 with normal noise";
    case data::BandKind::simultaneous: return "at all positions at once, for the expected value of the limit";
    default: return "pointwise, for the expected value of the limit";
  }
}

std::string band_method_text(data::BandMethod method) {
  switch (method) {
    case data::BandMethod::sandwich: return ", by the sandwich formula";
    case data::BandMethod::bootstrap:
      return fmt::format(", by {} drawings of the residuals (bootstrap)", bootstrap_drawings);
    default: return "";
  }
}

std::string noise_line(const std::string& column, const data::NoiseEstimate& noise, data::BandMethod method) {
  if (std::isinf(noise.degrees_of_freedom))
    return fmt::format("# noise of {}: standard deviation {:.6g}, as given\n", column, std::sqrt(noise.variance));
  if (!noise.exists()) return "# noise of " + column + ": not estimated, there are no three neighbouring data\n";
  if (method != data::BandMethod::linear)
    return fmt::format("# noise of {}: standard deviation {:.6g} from {} residuals, without outliers\n", column,
                       std::sqrt(noise.variance), noise.terms);
  const std::string ties = noise.ties == 0 ? "" : fmt::format(" and {} data at the positions of others", noise.ties);
  return fmt::format(
      "# noise of {}: standard deviation {:.6g} from {} second differences{}, {:.6g} degrees of freedom\n", column,
      std::sqrt(noise.variance), noise.terms - noise.ties, ties, noise.degrees_of_freedom);
}

SmoothPage::SmoothPage(const SmoothOptions& how, const data::NamedSamples& what, data::SmoothedSamples smoothed)
    : options(how),
      samples(what),
      result(std::move(smoothed)),
      bands(how.bands() != 0 && !result.columns.front().deviations.empty()) {
  if (samples.falling && !how.at_positions()) turn_to_order_of_rows();
  columns.reserve(2 * result.columns.size());  // what `table` points to stays
  texts.reserve(2 + samples.kept.size());
  if (!options.samples.by.empty()) add(options.samples.by, std::vector<std::string>(rows(), samples.group));
  if (samples.dates) {
    std::vector<std::string> dates;
    for (const double position : result.positions) dates.push_back(to_text(position, *samples.dates));
    add(samples.x_name, std::move(dates));
  } else {
    add(samples.x_name, result.positions);
  }
  for (std::size_t c = 0; c < result.columns.size(); ++c) {
    const data::SmoothedColumn& column = result.columns[c];
    const std::string& name = samples.names[c];
    add(name, column.values);
    if (!column.deviations.empty()) add(name + "_sd", column.deviations);
    if (column.deviations.empty() && !options.samples.by.empty() && column.noise) add_unknown(name);
    if (!bands) continue;
    std::vector<double>& lower = columns.emplace_back(column.half_widths(options.bands(), options.kind()));
    std::vector<double>& upper = columns.emplace_back(lower);
    for (std::size_t o = 0; o < rows(); ++o) {
      lower[o] = column.values[o] - lower[o];
      upper[o] = column.values[o] + upper[o];
    }
    add(name + "_lower", lower);
    add(name + "_upper", upper);
  }
  for (const data::NamedTexts& column : samples.kept) {
    add(column.name, column.texts);
    if (samples.falling) std::ranges::reverse(texts.back());
  }
}

void SmoothPage::add_unknown(const std::string& name) {
  if (unknown.empty()) unknown.assign(rows(), std::numeric_limits<double>::quiet_NaN());
  add(name + "_sd", unknown);
  if (options.bands() == 0) return;
  add(name + "_lower", unknown);
  add(name + "_upper", unknown);
}

void SmoothPage::turn_to_order_of_rows() {
  std::ranges::reverse(result.positions);
  for (data::SmoothedColumn& column : result.columns) {
    std::ranges::reverse(column.values);
    std::ranges::reverse(column.deviations);
  }
}

void SmoothPage::add(const std::string& name, const std::vector<double>& values) {
  header.push_back(name);
  table.push_back({values.data()});
}

void SmoothPage::add(const std::string& name, std::vector<std::string> column) {
  header.push_back(name);
  texts.push_back(std::move(column));
  table.push_back({nullptr, 1, texts.back().data()});
}

Json SmoothPage::json() const {
  Json noise = Json::array(), rows = Json::array();
  for (std::size_t c = 0; c < result.columns.size(); ++c)
    if (const auto& estimate = result.columns[c].noise)
      noise.push_back({{"column", samples.names[c]},
                       {"sigma", std::sqrt(estimate->variance)},
                       {"degrees_of_freedom",
                        std::isinf(estimate->degrees_of_freedom) ? Json() : Json(estimate->degrees_of_freedom)},
                       {"terms", estimate->terms},
                       {"outliers", result.columns[c].outliers},
                       {"correlated", optional_json(result.columns[c].correlated)}});
  for (std::size_t o = 0; o < result.positions.size(); ++o) {
    Json& row = rows.emplace_back(Json::array());
    for (const data::TableColumn& column : table)
      row.push_back(column.texts ? Json(column.texts[o]) : Json(column.values[o]));
  }
  Json answer = {{"scheme", result.method},
                 {"auto", result.choice.has_value()},
                 {"choice", choice_json(result.choice)},
                 {"boundary", options.boundary},
                 {"origin", to_text(samples.origin)},
                 {"spacing", to_text(samples.spacing)},
                 {"at", options.at_positions() ? "positions" : options.at},
                 {"level", options.level},
                 {"derivative", options.derivative},
                 {"noise", noise},
                 {"bands", bands ? Json(options.bands()) : Json()},
                 {"bands_kind", bands ? Json(options.bands_kind) : Json()},
                 {"bands_method", bands ? Json(to_text(result.band_method)) : Json()},
                 {"columns", header},
                 {"rows", rows}};
  if (!options.samples.by.empty()) answer["group"] = samples.group;
  if (samples.dates) answer["unit"] = samples.dates->unit_name();
  return answer;
}

void SmoothPage::write_comments(std::ostream& stream) const {
  if (!options.quiet) {
    if (!options.samples.by.empty()) stream << "# " << options.samples.by << " " << samples.group << "\n";
    if (samples.dates)
      stream << "# " << samples.x_name << ": dates; widths, spacings and derivatives are in "
             << samples.dates->unit_name() << "\n";
    stream << "# scheme " << result.method << ", boundary " << options.boundary
           << (options.derivative > 0 ? ", derivative " + std::to_string(options.derivative) : "") << "\n";
    if (result.choice) stream << choice_text(*result.choice, options);
    for (std::size_t c = 0; c < result.columns.size(); ++c)
      if (const auto& estimate = result.columns[c].noise; estimate && (estimate->exists() || !options.stream))
        stream << noise_line(samples.names[c], *estimate, result.band_method);
    if (bands)
      stream << fmt::format("# bands: {:.6g} % {}{}; the bias is not in them\n", 100 * options.bands(),
                            covered_text(options.kind()), band_method_text(result.band_method));
    if (result.band_method == data::BandMethod::bootstrap)
      stream << fmt::format("# values {} levels below the output grid, interpolated{}\n", data::finer_levels,
                            bands ? "" : "; no bands, which --bands draws");
  }
}

void SmoothPage::write_header(std::ostream& stream) const { stream << data::header_text(header, samples.separator); }

void SmoothPage::write_rows(std::ostream& stream) const {
  data::write_rows(stream, table, rows(), samples.separator, options.threads(), samples.decimal);
}

Json smooth_json(const std::vector<std::unique_ptr<SmoothPage>>& pages, const RefusedGroups& refused) {
  if (pages.front()->options.samples.by.empty()) return pages.front()->json();
  Json groups = Json::array();
  for (const auto& page : pages) groups.push_back(page->json());
  Json left_out = Json::array();
  for (const auto& [group, why] : refused) left_out.push_back({{"group", group}, {"reason", why}});
  return {{"by", pages.front()->options.samples.by}, {"groups", groups}, {"refused", left_out}};
}

void write(const std::vector<std::unique_ptr<SmoothPage>>& pages, std::ostream& stream) {
  for (const auto& page : pages) page->write_comments(stream);
  pages.front()->write_header(stream);
  for (const auto& page : pages) page->write_rows(stream);
}

}  // namespace subcert::cli
