#include "read_samples.hpp"

#include "uniform_grid.hpp"

#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/schemes/data/formats/table.hpp>
#include <subcert/schemes/data/runtime/input.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace subcert::data {
/// Which columns of a table hold what.
struct ColumnUse {
  std::optional<std::size_t> x;
  std::optional<std::size_t> weights;
  std::vector<std::size_t> values;
};

namespace {

constexpr double largest_value = 1e150;  // squares stay finite

std::string column_name(const Table& table, std::size_t column) {
  return table.header.empty() ? "column " + std::to_string(column + 1) : table.header[column];
}

std::size_t find_column(const Table& table, const std::string& option, const std::string& text) {
  const auto named = std::find(table.header.begin(), table.header.end(), text);
  if (named != table.header.end()) return static_cast<std::size_t>(named - table.header.begin());
  const auto number = parse_rational(text);
  if (number && denominator(*number) == 1 && *number >= 1 && *number <= Rational(table.columns))
    return numerator(*number).convert_to<std::size_t>() - 1;
  std::string known;
  for (const std::string& name : table.header) known += (known.empty() ? " or one of " : ", ") + name;
  fail(ErrorKind::usage, "{} {}: expected a column from 1 to {}{}", option, text, table.columns, known);
}

std::string place(const SampleOptions& options, const Table& table, std::size_t row, std::size_t column) {
  return options.name() + ", line " + std::to_string(table.lines[row]) + ", column " + std::to_string(column + 1);
}

/// --spacing, where it is given.
std::optional<Rational> given_spacing(const SampleOptions& options) {
  if (options.spacing.empty()) return std::nullopt;
  auto spacing = parse_number(options.spacing);
  if (!spacing || *spacing <= 0) fail(ErrorKind::usage, "--spacing {}: expected a number > 0", options.spacing);
  return spacing;
}

/// The positions in a column, which increase, also from the one before these rows.
std::vector<double> read_positions(const SampleOptions& options, const Table& table, std::size_t column,
                                   std::optional<double> before = std::nullopt) {
  std::vector<double> x;
  x.reserve(table.rows());
  const auto shown = [](double value) { return to_decimal(decimal_value(value), 9, Rounding::nearest); };
  for (std::size_t i = 0; i < table.rows(); ++i) {
    x.push_back(table.values[i * table.columns + column]);
    if (std::isnan(x.back()))
      fail(ErrorKind::data, "{}: expected a position; found a missing value", place(options, table, i, column));
    if (before && x.back() <= *before)
      fail(ErrorKind::data, "{}: expected increasing positions; found {} after {}", place(options, table, i, column),
           shown(x.back()), shown(*before));
    before = x.back();
  }
  return x;
}

/// Sets origin and spacing, or names the spacing that is farthest from the mean.
void set_grid(const SampleOptions& options, const Table& table, std::size_t column, Samples& samples) {
  std::vector<double> x = read_positions(options, table, column);
  const auto shown = [](const Rational& value) { return to_decimal(value, 9, Rounding::nearest); };
  const auto decimal = [&](std::size_t i) { return decimal_value(x[i]); };
  const UniformGrid grid = uniform_grid(x);
  if (!grid.uniform && options.irregular == "fit") {
    samples.positions = std::move(x);
  } else if (const std::size_t worst = grid.worst; !grid.uniform) {
    fail(ErrorKind::data,
         "{}, lines {} and {}: expected a uniform grid, the mean spacing is {}; found the spacing {} between {} and {} "
         "(--irregular fit takes positions as they are)",
         options.name(), table.lines[worst], table.lines[worst + 1], shown(grid.spacing),
         shown(decimal(worst + 1) - decimal(worst)), shown(decimal(worst)), shown(decimal(worst + 1)));
  }
  samples.origin = grid.origin;
  samples.spacing = grid.spacing;
  if (const auto spacing = given_spacing(options); spacing && !samples.uniform()) samples.spacing = *spacing;
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

ColumnUse find_columns(const SampleOptions& options, const Table& table) {
  ColumnUse use;
  if (!options.weights.empty()) use.weights = find_column(table, "--weights", options.weights);
  const bool none = options.x == "none";
  if (!options.x.empty() && !none) use.x = find_column(table, "--x", options.x);
  for (const std::string& text : options.y) use.values.push_back(find_column(table, "--y", text));
  std::vector<std::size_t> left;
  for (std::size_t c = 0; c < table.columns; ++c)
    if (c != use.weights && c != use.x && std::find(use.values.begin(), use.values.end(), c) == use.values.end())
      left.push_back(c);
  if (options.x.empty() && (use.values.empty() ? left.size() > 1 : !left.empty())) {
    use.x = left.front();
    left.erase(left.begin());
  }
  if (use.values.empty()) use.values = left;
  if (use.values.empty()) fail(ErrorKind::data, "{}: expected a column of values; found none", options.name());
  for (const std::size_t c : use.values)
    if (c == use.weights || c == use.x) fail(ErrorKind::usage, "--y: column {} has another use", c + 1);
  return use;
}

NamedSamples named_columns(const Table& table, const ColumnUse& use) {
  NamedSamples samples;
  samples.separator = table.columns == 1 ? ',' : table.separator;
  samples.x_name = use.x ? column_name(table, *use.x) : "x";
  for (const std::size_t c : use.values) samples.names.push_back(column_name(table, c));
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

NamedSamples read_samples(const SampleOptions& options) {
  const Table table = parse_table(runtime::read_input(options.file), options.name(), Missing::keep);
  const ColumnUse use = find_columns(options, table);
  NamedSamples samples = named_columns(table, use);
  if (use.x) set_grid(options, table, *use.x, samples);
  set_rows(options, table, use, samples);
  if (!samples.weights.empty() &&
      std::all_of(samples.weights.begin(), samples.weights.end(), [](const Rational& weight) { return weight == 0; }))
    fail(ErrorKind::data, "{}: expected a row that is neither missing nor of weight 0; found none", options.name());
  if (!samples.uniform()) samples.drop_missing();
  return samples;
}

class SampleStream::State {
 public:
  explicit State(const SampleOptions& options)
      : options_(options), input_(options.file), reader_(options.name(), Missing::keep) {
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
      head_ = named_columns(table, use_);
    }
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
    const std::vector<double> x = read_positions(options_, table, *use_.x, last_);
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
