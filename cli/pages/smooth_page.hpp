#pragma once
/// What `subcert smooth` prints and draws.

#include <subcert/cli/command.hpp>
#include <subcert/reports/formats/figure.hpp>
#include <subcert/schemes/data/smooth/read_samples.hpp>
#include <subcert/schemes/data/smooth/smooth.hpp>

namespace subcert::cli {

struct SmoothOptions : CommonOptions {
  data::SampleOptions samples;
  std::string noise;  ///< its standard deviation, where it is known
  std::string scheme;
  bool automatic = false;
  std::string boundary = data::smoothing_boundary_names().front();
  double constant = 0;
  std::optional<double> requested_bands;
  double bands() const { return requested_bands.value_or(0.95); }
  std::string bands_kind = "pointwise";
  data::BandKind kind() const { return *data::parse_band_kind(bands_kind); }
  std::string at = "grid";
  int level = 2;
  int derivative = 0;
  bool stream = false;
  std::string plot;
};

/// What was smoothed, how, and the result as a table: positions, then value, standard deviation, lower and upper end of
/// the band for each column, as far as there are such.
struct SmoothPage {
  /// `how` and `what` must outlive the page.
  SmoothPage(const SmoothPage&) = delete;
  SmoothPage& operator=(const SmoothPage&) = delete;
  SmoothPage(const SmoothOptions& how, const data::NamedSamples& what, data::SmoothedSamples smoothed);

  const SmoothOptions& options;
  const data::NamedSamples& samples;
  data::SmoothedSamples result;
  bool bands;                                ///< whether there are any
  std::vector<std::string> header;           ///< of the columns
  std::vector<std::vector<double>> columns;  ///< those that are not in `result`
  std::vector<const std::vector<double>*> table;

  Json json() const;
  void write(std::ostream& stream) const;
  /// What was done, and the names of the columns.
  void write_head(std::ostream& stream) const;
  void write_rows(std::ostream& stream) const;
  formats::Figure figure() const;
};

}  // namespace subcert::cli
