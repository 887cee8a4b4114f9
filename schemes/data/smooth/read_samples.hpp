#pragma once
/// Samples of functions, read from a table.

#include "uniform_grid.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace subcert::data {

struct SampleOptions {
  std::string file;
  std::string x;               ///< column by name or number from 1, `none`, or empty: the first of several columns
  std::vector<std::string> y;  ///< columns by name or number; empty: all that are left
  std::string weights;         ///< column by name or number, or empty
  std::string missing = "raise";
  std::string irregular = "raise";
  std::string spacing;  ///< of the outputs where positions are irregular; empty: the mean

  /// What errors call the file.
  std::string name() const;
};

/// Samples with the names of their columns in the file.
struct NamedSamples : Samples {
  std::string x_name;
  std::vector<std::string> names;
  char separator = ',';
};

/// Positions must be uniform up to the rounding of their decimal text: each within one unit of the finest decimal place
/// in the column, and within a twentieth of the spacing, of its place on the grid; with irregular = `fit` others are
/// kept, without rows that miss a value. Errors: throws a usage error for unknown columns, a data error that names the
/// line; for a grid that is not uniform the worst spacing.
NamedSamples read_samples(const SampleOptions& options);

/// Samples on a uniform grid that are read as they come. The spacing is that of the options or of the first two rows,
/// which later positions must keep as uniform ones do.
class SampleStream {
 public:
  /// Reads until origin and spacing are known. Errors: as read_samples().
  explicit SampleStream(const SampleOptions& options);
  ~SampleStream();
  SampleStream(const SampleStream&) = delete;
  SampleStream& operator=(const SampleStream&) = delete;

  /// Names, origin and spacing, without data.
  const NamedSamples& head() const;
  /// Whether rows have prior weights.
  bool weighted() const;
  /// The rows that have come, one or more; nothing at the end. Errors: as read_samples().
  std::optional<NamedSamples> next();

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace subcert::data
