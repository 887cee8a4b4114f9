#pragma once
/// Samples of functions, read from a table.

#include "uniform_grid.hpp"

#include <subcert/schemes/data/formats/dates.hpp>
#include <subcert/schemes/data/formats/table.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace subcert::data {

/// Columns are named, or numbered from 1.
struct SampleOptions {
  std::string file;
  std::string x;                  ///< `none`, or empty: the first of several columns of numbers or dates
  std::vector<std::string> y;     ///< empty: all that are left and hold numbers
  std::string weights;            ///< or empty
  std::string errors;             ///< of standard deviations s of the noise, for weights 1/s^2; or empty
  std::string by;                 ///< of the names of groups, or empty
  std::vector<std::string> keep;  ///< that answers at the data have, as they are
  std::string delimiter;          ///< between the columns: a character, `tab`, `blank`, or empty: found
  std::string decimal = ".";
  std::string header = "auto";  ///< or yes, no
  std::string missing = "raise";
  std::string series = "columns";  ///< or rows: each row is one, named by the column `by`
  bool slopes = false;  ///< Samples::slopes; without `x` an even number of columns has no positions, as of refine
  bool any_positions = false;  ///< also those that are not uniform, and several data at one
  std::string spacing;         ///< of the outputs where positions are irregular; empty: as put_at()

  /// What errors call the file.
  std::string name() const;
  /// How its table is read. Errors: throws a usage error for an unknown delimiter or decimal mark.
  TableForm form() const;
};

/// Fields of a column that is no number, row by row.
struct NamedTexts {
  std::string name;
  std::vector<std::string> texts;
};

/// Samples with the names of their columns in the file.
struct NamedSamples : Samples {
  std::string x_name;
  std::vector<std::string> names;
  char separator = ',';
  char decimal = '.';
  std::string group = {};                 ///< what the column of groups holds in these rows
  bool falling = false;                   ///< the rows came with falling positions
  std::optional<DateForm> dates = {};     ///< how positions are written that are dates, in days or seconds
  std::vector<NamedTexts> kept = {};      ///< columns of the rows, in the order of the samples
  std::vector<std::string> remarks = {};  ///< what was done to the rows that the options do not say, a line each
  std::string refused = {};               ///< of a group that has no samples: why not
};

/// The samples of each group, in the order of their first rows; one where there are no groups. Rows are sorted by their
/// positions; with missing = `drop` those without one are left out. Positions must be uniform up to the rounding of
/// their decimal text: each within one unit of the finest decimal place in the column, and within a twentieth of the
/// spacing, of its place on the grid; with any_positions others are kept, also several data at one position,
/// without rows that miss a value. Errors: throws a usage error for unknown columns, a data error that names the line;
/// for a grid that is not uniform the worst spacing; of one group among several this is its `refused`.
std::vector<NamedSamples> read_samples(const SampleOptions& options);

/// Positions that somebody names, as a list `1,2.5,7` or in a column of a table.
class GivenPositions {
 public:
  /// Errors: throws a usage error for an empty list.
  static GivenPositions of_list(const std::string& list);
  /// The table is read as that of the samples. Errors: throws a data error.
  static GivenPositions of_file(const SampleOptions& options, const std::string& file);

  /// Written as those of the samples, in their order; of a table the column that has the name of their positions, or
  /// the first. Errors: throws a usage error, of a table a data error that names the line, for what is neither a number
  /// nor, where these have dates, such a date.
  std::vector<double> of(const NamedSamples& samples) const;

 private:
  SampleOptions options_;
  std::string text_;                 // of a table
  std::vector<std::string> listed_;  // else
};

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
