#include "sample_columns.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/schemes/data/runtime/input.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace subcert::data {
namespace {

/// The fields of a column that the table keeps as they are written.
const std::vector<std::string>& fields_of(const Table& table, const std::vector<std::size_t>& kept,
                                          std::size_t column) {
  return table.fields[static_cast<std::size_t>(std::ranges::find(kept, column) - kept.begin())];
}

/// The rows of a table in this order.
Table selected(const Table& table, const std::vector<std::size_t>& rows) {
  Table result;
  result.columns = table.columns;
  result.header = table.header;
  result.separator = table.separator;
  result.decimal = table.decimal;
  result.row_names = table.row_names;
  result.contents = table.contents;
  result.fields.resize(table.fields.size());
  for (const std::size_t row : rows) {
    const auto first = table.values.begin() + static_cast<std::ptrdiff_t>(row * table.columns);
    result.values.insert(result.values.end(), first, first + static_cast<std::ptrdiff_t>(table.columns));
    result.lines.push_back(table.lines[row]);
    if (!table.places.empty()) result.places.push_back(table.places[row]);
    for (std::size_t k = 0; k < table.fields.size(); ++k) result.fields[k].push_back(table.fields[k][row]);
  }
  return result;
}

/// Puts units of time in the place of dates. Errors: a data error for text that is none, or is written otherwise.
DateForm read_dates(const SampleOptions& options, Table& table, const std::vector<std::string>& fields,
                    std::size_t column) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (!is_missing(fields[i])) rows.push_back(i);
  if (rows.empty()) return {};
  // The form that takes most of the column, which one text does not tell.
  std::size_t known = 0;
  DateForm form;
  for (const Date& reading : readings_of_date(fields[rows.front()])) {
    const auto other = std::ranges::find_if(rows, [&](std::size_t i) { return !parse_date(fields[i], reading.form); });
    if (const auto taken = static_cast<std::size_t>(other - rows.begin()); taken > known) {
      known = taken;
      form = reading.form;
    }
  }
  if (known < rows.size())
    fail(ErrorKind::data, "{}: expected a date{}; found {}", place(options, table, rows[known], column),
         known > 0 ? " written as those before" : "", in_quotes(fields[rows[known]]));
  if (rows.size() > 1 && std::ranges::all_of(rows, [&](std::size_t i) { return may_be_two_years(fields[i], form); }))
    fail(
        ErrorKind::data,
        "{}: expected months; found {}, which may be two years (write months with days, or take another column by --x)",
        place(options, table, rows.front(), column), in_quotes(fields[rows.front()]));
  for (const std::size_t i : rows) table.values[i * table.columns + column] = *parse_date(fields[i], form);
  return form;
}

/// Puts days in the place of dates that are written as numbers, as 20240229; whether all in the column are.
bool read_number_dates(Table& table, std::size_t column) {
  std::vector<double> days;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double value = table.values[i * table.columns + column];
    const auto day = std::isnan(value) ? std::optional(value) : day_of_number(value);
    if (!day) return false;
    days.push_back(*day);
  }
  for (std::size_t i = 0; i < table.rows(); ++i) table.values[i * table.columns + column] = days[i];
  return true;
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
  if (!order.rising && !order.falling) {
    const bool others = options.x.empty() && table.places.empty();
    samples.remarks.push_back(
        "the rows were sorted by their positions" +
        (others ? ", " + column_name(table, column) + " (--x COLUMN takes others, --x none counts the rows)" : ""));
  }
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
  samples.slopes = options.slopes;
  remark_on_missing(table, use, samples);
  const auto counts = [&](std::size_t i) { return samples.weights.empty() || samples.weights[i] != 0; };
  for (const std::size_t c : use.kept) {
    NamedTexts& column = samples.kept.emplace_back(NamedTexts{column_name(table, c), {}});
    const std::vector<std::string>& fields = fields_of(table, kept, c);
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (samples.uniform() || counts(i)) column.texts.push_back(fields[i]);
  }
  if (samples.count() == 0 ||
      (!samples.weights.empty() && std::ranges::all_of(samples.weights, [](const Rational& w) { return w == 0; })))
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

/// That these columns are left out, which option takes one of them, and where names may have been taken for data.
std::string remark_on_text(const Table& table, const std::vector<std::size_t>& columns, bool by) {
  std::string text;
  for (const std::size_t c : columns) text += (text.empty() ? "" : ", ") + column_name(table, c);
  text += columns.size() == 1 ? " holds text and is left out" : " hold text and are left out";
  if (!by)
    text += fmt::format(" (--by {} smooths its groups one by one)",
                        table.header.empty() ? std::to_string(columns.front() + 1) : table.header[columns.front()]);
  if (table.header.empty())
    text += fmt::format(
        "; line {} counts as data, as a number is in it (--header yes takes it as names, --series rows as positions)",
        table.lines.front());
  return text;
}

/// Columns of samples, as they stand.
SampleTable read_columns(const SampleOptions& options, const std::string& text) {
  SampleTable result;
  TableForm form = options.form();
  form.kept = columns_as_written(options, text);
  Table& table = result.table = parse_table(text, options.name(), form);
  const ColumnUse& use = result.use = find_columns(options, table);
  require_numbers(table, use);
  if (use.dates && std::ranges::count(form.kept, *use.x) == 0) {  // dates that begin below the first rows
    form.kept.push_back(*use.x);
    table = parse_table(text, options.name(), form);
  }
  result.kept = form.kept;
  if (!use.left_out.empty()) result.remarks.push_back(remark_on_text(table, use.left_out, !options.by.empty()));
  if (use.numbered)
    result.remarks.emplace_back("the first column has no name, counts the rows, and is left out (--x 1 takes it)");
  if (options.x.empty() && use.x && !table.header.empty() && column_name(table, *use.x).empty())
    result.remarks.emplace_back(
        "the positions are the column without a name, as of row numbers (--x COLUMN takes another)");
  return result;
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

std::vector<NamedSamples> read_samples(const SampleOptions& options) {
  const std::string text = runtime::read_input(options.file);
  if (text.starts_with("# vtk DataFile"))
    fail(ErrorKind::data, "{}: expected a table; found a volume (--grid smooths it)", options.name());
  if (text.starts_with("ply\n") || text.starts_with("ply\r"))
    fail(ErrorKind::data, "{}: expected a table; found a mesh (subcert refine takes it)", options.name());
  SampleTable read = options.series == "rows" ? read_row_series(options, text) : read_columns(options, text);
  Table& table = read.table;
  const ColumnUse& use = read.use;
  const std::vector<std::size_t>& kept = read.kept;
  std::vector<std::string>& remarks = read.remarks;
  std::optional<DateForm> dates;
  if (use.dates) dates = read_dates(options, table, fields_of(table, kept, *use.x), *use.x);
  if (use.x && !use.dates && table.contents[*use.x].numbers > 0 && read_number_dates(table, *use.x)) {
    dates.emplace().date = "%Y%m%d";
    remarks.push_back(column_name(table, *use.x) + " holds dates as YYYYMMDD, and is taken in days");
  }
  std::vector<NamedSamples> result;
  const auto samples_or_why = [&](Table rows) {
    try {
      return samples_of(options, std::move(rows), use, kept);
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
    for (const auto& [name, rows] : groups_of(fields_of(table, kept, *use.by))) add(name, selected(table, rows));
  return result;
}

}  // namespace subcert::data
