#include "read_samples.hpp"

#include "sample_columns.hpp"
#include "uniform_grid.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/runtime/input.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ranges>
#include <utility>

namespace subcert::data {
namespace {

constexpr double largest_value = 1e150;  // squares stay finite

/// --spacing, where it is given.
std::optional<Rational> given_spacing(const SampleOptions& options) {
  if (options.spacing.empty()) return std::nullopt;
  auto spacing = parse_number(options.spacing);
  if (!spacing || *spacing <= 0) fail(ErrorKind::usage, "--spacing {}: expected a number > 0", options.spacing);
  return spacing;
}

std::string shown(const Rational& value) { return to_decimal(value, 9, Rounding::nearest); }

/// The rows of a table in this order.
Table selected(const Table& table, const std::vector<std::size_t>& rows) {
  Table result = table;
  result.values.clear();
  result.lines.clear();
  for (auto& fields : result.fields) fields.clear();
  for (const std::size_t row : rows) {
    const auto first = table.values.begin() + static_cast<std::ptrdiff_t>(row * table.columns);
    result.values.insert(result.values.end(), first, first + static_cast<std::ptrdiff_t>(table.columns));
    result.lines.push_back(table.lines[row]);
    for (std::size_t k = 0; k < table.fields.size(); ++k) result.fields[k].push_back(table.fields[k][row]);
  }
  return result;
}

/// The positions in a column; NaN where one is missing and may be. Errors: a data error where none may.
std::vector<double> read_positions(const SampleOptions& options, const Table& table, std::size_t column) {
  std::vector<double> x;
  x.reserve(table.rows());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    x.push_back(table.values[i * table.columns + column]);
    if (std::isnan(x.back()) && options.missing != "drop")
      fail(ErrorKind::data, "{}: expected a position; found a missing value (--missing drop leaves the row out)",
           place(options, table, i, column));
  }
  return x;
}

/// Refuses positions that do not increase, also from the one before these rows.
void require_increasing(const SampleOptions& options, const Table& table, std::size_t column,
                        const std::vector<double>& x, std::optional<double> before) {
  for (std::size_t i = 0; i < x.size(); before = x[i++])
    if (std::isnan(x[i]) || (before && x[i] <= *before))
      fail(ErrorKind::data, "{}: expected increasing positions in a stream; found {}{}",
           place(options, table, i, column), (std::isnan(x[i]) ? "a missing value" : shown(decimal_value(x[i]))),
           before ? " after " + shown(decimal_value(*before)) : "");
}

/// Sorts the rows by their positions, which are the answer.
std::vector<double> sort_rows(const SampleOptions& options, std::size_t column, Table& table, NamedSamples& samples) {
  std::vector<double> x = read_positions(options, table, column);
  const PositionOrder order = order_of(x);
  if (order.rows.empty())
    fail(ErrorKind::data, "{}, column {}: expected positions; found missing values alone", options.name(), column + 1);
  samples.falling = order.falling;
  const std::size_t left_out = x.size() - order.rows.size();
  if (left_out > 0) samples.remarks.push_back(fmt::format("rows without a position, left out: {}", left_out));
  if (!order.rising && !order.falling)
    samples.remarks.push_back(
        "the rows were sorted by their positions" +
        (options.x.empty() ? ", " + column_name(table, column) + " (--x COLUMN takes others, --x none counts the rows)"
                           : std::string()));
  if (left_out > 0 || !order.rising) {
    table = selected(table, order.rows);
    x = read_positions(options, table, column);
  }
  if (order.repeated && !options.any_positions) {
    const std::size_t second = *order.repeated;
    fail(ErrorKind::data,
         "{}, lines {} and {}: expected one row for each position; found {} twice (--irregular fit takes several data "
         "at one position)",
         options.name(), table.lines[second - 1], table.lines[second], shown(decimal_value(x[second])));
  }
  return x;
}

/// Puts the samples at the positions of these rows, or names the spacing that is farthest from the mean. Domain: rows
/// sorted by position.
void set_grid(const SampleOptions& options, const Table& table, std::vector<double> x, NamedSamples& samples) {
  if (x.size() > 1 && x.front() == x.back())
    fail(ErrorKind::data, "{}: expected two different positions; found {} alone", options.name(),
         shown(decimal_value(x.front())));
  const UniformGrid grid = samples.put_at(std::move(x));
  if (!samples.uniform() && !options.any_positions) {
    const std::size_t worst = grid.worst;
    const auto decimal = [&](std::size_t i) { return decimal_value(samples.positions[i]); };
    fail(ErrorKind::data,
         "{}, lines {} and {}: expected a uniform grid, the mean spacing is {}; found the spacing {} between {} and {} "
         "(--irregular fit takes positions as they are)",
         options.name(), table.lines[worst], table.lines[worst + 1], shown(grid.spacing),
         shown(decimal(worst + 1) - decimal(worst)), shown(decimal(worst)), shown(decimal(worst + 1)));
  }
  if (const auto spacing = given_spacing(options); spacing && !samples.uniform())
    samples.spacing = *spacing;
  else if (spacing && *spacing != grid.spacing)
    samples.remarks.push_back(fmt::format(
        "--spacing {} is for irregular positions; these are uniform, {} apart, and --level L sets those of the answer",
        options.spacing, shown(grid.spacing)));
}

/// Prior weights, with 0 for rows that lack a value.
void set_weights(const SampleOptions& options, const Table& table, const std::vector<std::size_t>& values,
                 std::optional<std::size_t> weights, Samples& samples) {
  std::vector<Rational> result;  // none as long as all are 1
  if (weights) result.reserve(table.rows());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (weights) {
      const double value = table.values[i * table.columns + *weights];
      if (!(value >= 0))
        fail(ErrorKind::data, "{}: expected a weight >= 0; found {}", place(options, table, i, *weights),
             (std::isnan(value) ? "a missing value" : shortest_text(value)));
      result.push_back(decimal_value(value));
    }
    for (const std::size_t column : values) {
      if (!std::isnan(table.values[i * table.columns + column])) continue;
      if (options.missing != "drop")
        fail(ErrorKind::data, "{}: expected a number; found a missing value (--missing drop leaves it out)",
             place(options, table, i, column));
      if (result.empty()) result.assign(table.rows(), 1);
      result[i] = 0;
    }
  }
  samples.weights = std::move(result);
}

NamedSamples named_columns(const Table& table, const ColumnUse& use) {
  NamedSamples samples;
  samples.separator = table.columns > 1 ? table.separator : table.decimal == ',' ? ';' : ',';
  samples.decimal = table.decimal;
  for (const std::size_t c : use.values) samples.names.push_back(column_name(table, c));
  // Data that are counted have no column of positions, whose name must be a new one.
  samples.x_name = use.x ? column_name(table, *use.x) : std::ranges::count(samples.names, "x") > 0 ? "index" : "x";
  samples.columns.resize(use.values.size());
  return samples;
}

/// Sets values and weights to those of the rows.
void set_rows(const SampleOptions& options, const Table& table, const ColumnUse& use, Samples& samples) {
  set_weights(options, table, use.values, use.weights, samples);
  for (std::size_t k = 0; k < use.values.size(); ++k) {
    auto& column = samples.columns[k];
    column.clear();
    column.reserve(table.rows());
    for (std::size_t i = 0; i < table.rows(); ++i) {
      const double value = table.values[i * table.columns + use.values[k]];
      if (std::abs(value) > largest_value)
        fail(ErrorKind::data, "{}: expected at most 1e150 in modulus; found {}",
             place(options, table, i, use.values[k]), shortest_text(value));
      column.push_back(std::isnan(value) ? 0 : value);
    }
  }
}

}  // namespace

std::string SampleOptions::name() const { return runtime::input_name(file); }

TableForm SampleOptions::form() const {
  TableForm form(Missing::keep);
  form.text = true;
  if (delimiter == "tab" || delimiter == "\\t")
    form.separator = '\t';
  else if (delimiter == "blank")
    form.separator = ' ';
  else if (delimiter.size() == 1)
    form.separator = delimiter.front();
  else if (!delimiter.empty())
    fail(ErrorKind::usage, "--delimiter {}: expected one character, tab or blank", delimiter);
  form.decimal = decimal.front();
  if (form.separator == form.decimal || form.separator == '"')
    fail(ErrorKind::usage, "--delimiter {}: expected another character than the decimal mark and the quote", delimiter);
  if (header != "auto") form.header = header == "yes";
  return form;
}

namespace {

/// The rows of each group, by the fields of a column, in the order of their first rows.
std::vector<std::pair<std::string, std::vector<std::size_t>>> groups_of(const std::vector<std::string>& fields) {
  std::vector<std::pair<std::string, std::vector<std::size_t>>> groups;
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto [at, is_new] = places.emplace(fields[i], groups.size());
    if (is_new) groups.emplace_back(fields[i], std::vector<std::size_t>());
    groups[at->second].second.push_back(i);
  }
  return groups;
}

/// Rows that lack one value of several count for no column.
void remark_on_missing(const Table& table, const ColumnUse& use, NamedSamples& samples) {
  std::size_t rows = 0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto missing = std::ranges::count_if(
        use.values, [&](std::size_t c) { return std::isnan(table.values[i * table.columns + c]); });
    rows += missing > 0 && missing < std::ssize(use.values) ? 1 : 0;
  }
  if (rows > 0)
    samples.remarks.push_back(
        fmt::format("rows with some of the values, left out for all columns: {} (--y NAME takes one column)", rows));
}

NamedSamples samples_of(const SampleOptions& options, Table table, const ColumnUse& use,
                        const std::vector<std::size_t>& kept) {
  NamedSamples samples = named_columns(table, use);
  if (use.x) {
    std::vector<double> x = sort_rows(options, *use.x, table, samples);
    set_grid(options, table, std::move(x), samples);
  } else if (const auto spacing = given_spacing(options)) {
    samples.spacing = *spacing;
  }
  set_rows(options, table, use, samples);
  remark_on_missing(table, use, samples);
  const auto counts = [&](std::size_t i) { return samples.weights.empty() || samples.weights[i] != 0; };
  for (const std::size_t c : use.kept) {
    NamedTexts& column = samples.kept.emplace_back(NamedTexts{column_name(table, c), {}});
    const std::vector<std::string>& fields = fields_of(table, kept, c);
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (samples.uniform() || counts(i)) column.texts.push_back(fields[i]);
  }
  if (std::ranges::none_of(std::views::iota(std::size_t{0}, samples.count()), counts))
    fail(ErrorKind::data, "{}: expected a row that is neither missing nor of weight 0; found none", options.name());
  if (!samples.uniform()) samples.drop_missing();
  return samples;
}

/// The columns whose fields are kept as they are written: those of groups, what is kept, and dates, as far as the first
/// rows tell.
std::vector<std::size_t> columns_as_written(const SampleOptions& options, std::string_view text) {
  constexpr std::size_t first_bytes = 1 << 14;
  TableReader reader(options.name(), options.form());
  const Table& table = reader.read(text.size() > first_bytes ? text.substr(0, text.rfind('\n', first_bytes)) : text);
  std::vector<std::size_t> columns;
  if (table.rows() == 0) return columns;
  for (const std::string& name : options.keep) columns.push_back(find_column(table, "--keep", name));
  if (!options.by.empty()) columns.push_back(find_column(table, "--by", options.by));
  for (std::size_t c = 0; c < table.columns; ++c)
    if (holds_dates(table, c) && std::ranges::count(columns, c) == 0) columns.push_back(c);
  return columns;
}

}  // namespace

std::vector<NamedSamples> read_samples(const SampleOptions& options) {
  const std::string text = runtime::read_input(options.file);
  if (text.starts_with("# vtk DataFile"))
    fail(ErrorKind::data, "{}: expected a table; found a volume (--grid smooths it)", options.name());
  if (text.starts_with("ply\n") || text.starts_with("ply\r"))
    fail(ErrorKind::data, "{}: expected a table; found a mesh (subcert refine takes it)", options.name());
  TableForm form = options.form();
  form.kept = columns_as_written(options, text);
  Table table = parse_table(text, options.name(), form);
  const ColumnUse use = find_columns(options, table);
  require_numbers(table, use);
  if (use.dates && std::ranges::count(form.kept, *use.x) == 0) {  // dates that begin below the first rows
    form.kept.push_back(*use.x);
    table = parse_table(text, options.name(), form);
  }
  std::optional<DateForm> dates;
  if (use.dates) dates = read_dates(options, table, fields_of(table, form.kept, *use.x), *use.x);
  std::vector<std::string> remarks;
  if (use.x && !use.dates && table.contents[*use.x].numbers > 0 && read_number_dates(table, *use.x)) {
    dates.emplace().date = "%Y%m%d";
    remarks.push_back(column_name(table, *use.x) + " holds dates as YYYYMMDD, and is taken in days");
  }
  for (const std::size_t c : use.left_out) remarks.push_back(column_name(table, c) + " holds text and is left out");
  if (use.numbered)
    remarks.emplace_back("the first column has no name, counts the rows, and is left out (--x 1 takes it)");
  if (options.x.empty() && use.x && !table.header.empty() && column_name(table, *use.x).empty())
    remarks.emplace_back("the positions are the column without a name, as of row numbers (--x COLUMN takes another)");
  std::vector<NamedSamples> result;
  const auto samples_or_why = [&](Table rows) {
    try {
      return samples_of(options, std::move(rows), use, form.kept);
    } catch (const Error& error) {
      if (!use.by || error.kind() != ErrorKind::data) throw;
      NamedSamples none;
      none.refused = error.what();
      return none;
    }
  };
  const auto add = [&](const std::string& group, Table rows) {
    NamedSamples& samples = result.emplace_back(samples_or_why(std::move(rows)));
    samples.group = group;
    samples.dates = dates;
    std::ranges::move(samples.remarks, std::back_inserter(remarks));
    samples.remarks = std::exchange(remarks, {});
  };
  if (!use.by)
    add("", std::move(table));
  else
    for (const auto& [name, rows] : groups_of(fields_of(table, form.kept, *use.by))) add(name, selected(table, rows));
  return result;
}

class SampleStream::State {
 public:
  explicit State(const SampleOptions& options)
      : options_(options), input_(options.file), reader_(options.name(), options.form()) {
    const auto spacing = given_spacing(options);
    while (!head_ || (use_.x && !spacing && positions_.size() < 2))
      if (!read()) break;
    reader_.finish();
    if (use_.x) {
      head_->origin = decimal_value(positions_.front());
      if (positions_.size() > 1) head_->spacing = decimal_value(positions_[1]) - head_->origin;
    }
    if (spacing) head_->spacing = *spacing;
    grid_.emplace(head_->origin, head_->spacing);
  }

  const NamedSamples& head() const { return *head_; }
  bool weighted() const { return options_.missing == "drop" || use_.weights; }

  std::optional<NamedSamples> next() {
    while (rows_.count() == 0)
      if (!read()) return std::nullopt;
    for (std::size_t i = 0; i < positions_.size(); ++i)
      if (!grid_->accepts(positions_[i]))
        fail(ErrorKind::data,
             "{}, line {}: expected {}, on the grid of spacing {}; found the position {} (--spacing sets it)",
             options_.name(), lines_[i], to_decimal(grid_->expected(), 9, Rounding::nearest),
             to_decimal(head_->spacing, 9, Rounding::nearest), shortest_text(positions_[i]));
    positions_.clear();
    lines_.clear();
    return std::exchange(rows_, NamedSamples{});
  }

 private:
  /// Adds the rows of the lines that have come; false at the end.
  bool read() {
    std::string text;
    if (!input_.read_lines(text)) return false;
    const Table& table = reader_.read(text);
    if (table.rows() == 0) return true;
    if (!head_) {
      use_ = find_columns(options_, table);
      if (use_.dates)
        fail(ErrorKind::data, "{}: expected positions that are numbers in a stream; found dates", options_.name());
      head_ = named_columns(table, use_);
    }
    require_numbers(table, use_);
    NamedSamples rows = *head_;
    set_rows(options_, table, use_, rows);
    if (rows.weights.empty() && weighted()) rows.weights.assign(rows.count(), 1);
    if (rows_.count() == 0) {
      rows_ = std::move(rows);
    } else {
      for (std::size_t c = 0; c < rows.columns.size(); ++c)
        rows_.columns[c].insert(rows_.columns[c].end(), rows.columns[c].begin(), rows.columns[c].end());
      rows_.weights.insert(rows_.weights.end(), rows.weights.begin(), rows.weights.end());
    }
    if (!use_.x) return true;
    const std::vector<double> x = read_positions(options_, table, *use_.x);
    require_increasing(options_, table, *use_.x, x, last_);
    last_ = x.back();
    positions_.insert(positions_.end(), x.begin(), x.end());
    lines_.insert(lines_.end(), table.lines.begin(), table.lines.end());
    return true;
  }

  SampleOptions options_;
  runtime::LineInput input_;
  TableReader reader_;
  ColumnUse use_;
  std::optional<NamedSamples> head_;
  std::optional<GridCheck> grid_;
  NamedSamples rows_;              // that were read and not taken
  std::vector<double> positions_;  // of these
  std::vector<std::size_t> lines_;
  std::optional<double> last_;
};

SampleStream::SampleStream(const SampleOptions& options) : state_(std::make_unique<State>(options)) {}
SampleStream::~SampleStream() = default;
const NamedSamples& SampleStream::head() const { return state_->head(); }
bool SampleStream::weighted() const { return state_->weighted(); }
std::optional<NamedSamples> SampleStream::next() { return state_->next(); }

}  // namespace subcert::data
