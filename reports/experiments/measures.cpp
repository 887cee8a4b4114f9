#include "measures.hpp"

#include <cmath>

namespace subcert::experiments {

std::string scheme_name(const std::string& specification) {
  const std::string prefix = "primal:n=";
  if (!specification.starts_with(prefix)) return specification;
  const std::size_t comma = specification.find(",d=");
  std::string name = "S_" + specification.substr(prefix.size(), comma - prefix.size());
  if (comma != std::string::npos) name += "^" + specification.substr(comma + 3);
  return name;
}

double noise_deviation(std::span<const Coordinate> samples, double decibel) {
  double square = 0;
  for (const Coordinate& coordinate : samples) square += mean_square(coordinate) / static_cast<double>(samples.size());
  return noise_deviation(square, decibel);
}

void add_noise(std::span<Coordinate> samples, double sigma, std::mt19937_64& engine) {
  for (Coordinate& coordinate : samples) {
    const auto noise = normal_noise(engine, coordinate.size());
    for (std::size_t i = 0; i < coordinate.size(); ++i) coordinate[i] += sigma * noise[i];
  }
}

double relative_error(std::span<const Coordinate> values, std::span<const Coordinate> truth) {
  double error = 0, norm = 0;
  for (std::size_t c = 0; c < truth.size(); ++c)
    for (std::size_t i = 0; i < truth[c].size(); ++i) {
      error += (values[c][i] - truth[c][i]) * (values[c][i] - truth[c][i]);
      norm += truth[c][i] * truth[c][i];
    }
  return std::sqrt(error / norm);
}

Measured empty_measure(std::size_t schemes, std::size_t runs) {
  return Measured(schemes, {std::vector<double>(runs), std::vector<double>(runs)});
}

formats::PlainTable measures_table(const std::string& id, const std::string& title,
                                   const std::vector<std::string>& schemes, const TwoLevels& decibels,
                                   const std::vector<std::pair<std::string, const Measured*>>& columns) {
  formats::PlainTable table{id, title, {"scheme", "SNR (dB)"}, {}};
  for (const auto& column : columns) table.head.push_back(column.first);
  for (std::size_t s = 0; s < schemes.size(); ++s)
    for (std::size_t d = 0; d < 2; ++d) {
      std::vector<std::string> row{scheme_name(schemes[s]), short_number(decibels[d])};
      for (const auto& column : columns) row.push_back(mean_interval((*column.second)[s][d]).text());
      table.rows.push_back(row);
    }
  return table;
}

Dominance dominance(const Measured& error, std::size_t noise, const std::vector<std::string>& schemes,
                    const std::vector<std::size_t>& good, const std::vector<std::size_t>& bad) {
  Dominance result{true, ""};
  for (const std::size_t g : good)
    for (const std::size_t b : bad) {
      const MeanInterval difference = mean_difference(error[g][noise], error[b][noise]);
      result.shown = result.shown && difference.is_negative();
      result.numbers += (result.numbers.empty() ? "" : ", ") + scheme_name(schemes[g]) + " - " +
                        scheme_name(schemes[b]) + ": " + difference.text();
    }
  return result;
}

}  // namespace subcert::experiments
