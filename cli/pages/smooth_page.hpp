#pragma once
/// What `subcert smooth` prints and draws.

#include <subcert/cli/command.hpp>
#include <subcert/schemes/data/smooth/read_samples.hpp>
#include <subcert/schemes/data/smooth/smooth.hpp>

#include <functional>
#include <memory>

namespace subcert::cli {

/// For the bands of l1 schemes.
constexpr int bootstrap_drawings = 200;

struct SmoothOptions : CommonOptions {
  data::SampleOptions samples;
  std::string irregular = "auto";  ///< or raise, fit: what positions that are not uniform are
  std::string noise;               ///< its standard deviation, where it is known
  std::string slope_noise;         ///< that of slopes
  std::string scheme;
  bool automatic = false;
  std::string select = "risk";
  std::string boundary = data::smoothing_boundary_names().front();
  double constant = 0;
  std::optional<double> requested_bands;
  double bands() const { return requested_bands.value_or(0.95); }
  std::string bands_kind = "pointwise";
  data::BandKind kind() const { return *data::parse_band_kind(bands_kind); }
  std::string at = "grid";  ///< or data, or a list of positions
  std::string at_file;      ///< with a column of positions
  /// Whether positions are given, by a list or a file.
  bool at_positions() const { return !at_file.empty() || (at != "grid" && at != "data"); }
  int level = 2;
  int steps = 1;  ///< of a mesh
  int derivative = 0;
  bool closed = false;
  bool stream = false;
  bool grid = false;
  std::string plot;
  std::function<std::vector<std::string>()> given;  ///< the names of options on the command line
};

/// What was smoothed, how, and the result as a table: the group, positions, then value, standard deviation, lower and
/// upper end of the band for each column, then the columns that were kept, as far as there are such. Rows stand in the
/// order of those that were read, or of given positions.
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
  std::vector<double> unknown;               ///< for a group whose noise has no estimate
  std::vector<std::vector<std::string>> texts;
  std::vector<data::TableColumn> table;

  Json json() const;
  /// What was done.
  void write_comments(std::ostream& stream) const;
  /// The names of the columns.
  void write_header(std::ostream& stream) const;
  void write_rows(std::ostream& stream) const;
  std::size_t rows() const { return result.positions.size(); }

 private:
  void add(const std::string& name, const std::vector<double>& values);
  void add(const std::string& name, std::vector<std::string> column);
  void add_unknown(const std::string& name);
  void turn_to_order_of_rows();
};

/// The method chosen, and the two best others.
std::string choice_text(const data::MethodChoice& choice, const SmoothOptions& options);
/// All of them, or null.
Json choice_json(const std::optional<data::MethodChoice>& choice);

/// What a comment says of bands of this kind, and of the noise of a column.
std::string covered_text(data::BandKind kind);
std::string noise_line(const std::string& column, const data::NoiseEstimate& noise,
                       data::BandMethod method = data::BandMethod::linear);

/// Groups that cannot be smoothed, and why.
using RefusedGroups = std::vector<std::pair<std::string, std::string>>;

/// The pages of all groups: one table.
Json smooth_json(const std::vector<std::unique_ptr<SmoothPage>>& pages, const RefusedGroups& refused);
void write(const std::vector<std::unique_ptr<SmoothPage>>& pages, std::ostream& stream);
}  // namespace subcert::cli
