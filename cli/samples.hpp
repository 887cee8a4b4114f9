#pragma once
/// Samples of functions on a uniform grid, read from a table.

#include <subcert/schemes/data/formats/table.hpp>
#include <subcert/schemes/data/smooth/samples.hpp>

#include <string>
#include <vector>

namespace subcert::cli {

struct SampleOptions {
  std::string file;
  std::string x;               ///< column by name or number from 1, `none`, or empty: the first of several columns
  std::vector<std::string> y;  ///< columns by name or number; empty: all that are left
  std::string weights;         ///< column by name or number, or empty
  std::string missing = "raise";

  /// What errors call the file.
  std::string name() const;
};

/// Samples with the names of their columns in the file.
struct NamedSamples : data::Samples {
  std::string x_name;
  std::vector<std::string> names;
  char separator = ',';
};

/// Positions must be uniform up to the rounding of their decimal text: each within one unit of the finest decimal place
/// in the column, and within a twentieth of the spacing, of its place on the grid. Errors: throws a usage error for
/// unknown columns, a data error that names the line; for a grid that is not uniform the worst spacing.
NamedSamples read_samples(const SampleOptions& options);

}  // namespace subcert::cli
