#include "sample_columns.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/runtime/input.hpp>

#include <cmath>
#include <utility>

namespace subcert::data {
namespace {

/// Refuses positions that do not increase, also from the one before these rows.
void require_increasing(const SampleOptions& options, const Table& table, std::size_t column,
                        const std::vector<double>& x, std::optional<double> before) {
  for (std::size_t i = 0; i < x.size(); before = x[i++])
    if (std::isnan(x[i]) || (before && x[i] <= *before))
      fail(ErrorKind::data, "{}: expected increasing positions in a stream; found {}{}",
           place(options, table, i, column), (std::isnan(x[i]) ? "a missing value" : shown(decimal_value(x[i]))),
           before ? " after " + shown(decimal_value(*before)) : "");
}

}  // namespace

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
             options_.name(), lines_[i], shown(grid_->expected()), shown(head_->spacing), shortest_text(positions_[i]));
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
