#include "dates.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>

#include <chrono>
#include <cmath>

namespace subcert::data {
namespace {

constexpr long seconds_of_day = 86'400, micros_of_second = 1'000'000;

/// Reads a text from its beginning.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : rest_(text) {}

  /// So many digits.
  std::optional<int> digits(std::size_t count) {
    if (rest_.size() < count) return std::nullopt;
    int value = 0;
    for (const char c : rest_.substr(0, count)) {
      if (c < '0' || c > '9') return std::nullopt;
      value = 10 * value + (c - '0');
    }
    rest_.remove_prefix(count);
    return value;
  }
  bool take(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  /// Digits behind a decimal point, as a part of one.
  std::optional<double> fraction() {
    double value = 0, place = 0.1;
    std::size_t count = 0;
    for (; count < rest_.size() && rest_[count] >= '0' && rest_[count] <= '9'; ++count, place /= 10)
      value += place * (rest_[count] - '0');
    rest_.remove_prefix(count);
    return count > 0 ? std::optional(value) : std::nullopt;
  }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

std::optional<long> day_of(int year, int month, int day) {
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok()) return std::nullopt;
  return std::chrono::sys_days(date).time_since_epoch().count();
}

std::optional<long> read_day(Cursor& text) {
  const auto year = text.digits(4);
  if (!year || *year == 0 || !text.take('-')) return std::nullopt;
  const auto month = text.digits(2);
  if (!month || !text.take('-')) return std::nullopt;
  const auto day = text.digits(2);
  if (!day) return std::nullopt;
  return day_of(*year, *month, *day);
}

/// Seconds of the day.
std::optional<double> read_time(Cursor& text) {
  const auto hour = text.digits(2);
  if (!hour || *hour > 23 || !text.take(':')) return std::nullopt;
  const auto minute = text.digits(2);
  if (!minute || *minute > 59) return std::nullopt;
  double seconds = *hour * 3600 + *minute * 60;
  if (!text.take(':')) return seconds;
  const auto second = text.digits(2);
  if (!second || *second > 59) return std::nullopt;
  seconds += *second;
  if (!text.take('.')) return seconds;
  const auto fraction = text.fraction();
  return fraction ? std::optional(seconds + *fraction) : std::nullopt;
}

bool is_zone(std::string_view text) {
  if (text.empty() || text == "Z") return true;
  Cursor zone(text);
  if (!zone.take('+') && !zone.take('-')) return false;
  const auto hours = zone.digits(2);
  if (!hours || *hours > 23 || !zone.take(':')) return false;
  const auto minutes = zone.digits(2);
  return minutes && *minutes <= 59 && zone.rest().empty();
}

}  // namespace

std::optional<Date> parse_date(std::string_view text) {
  Cursor cursor(text);
  const auto day = read_day(cursor);
  if (!day) return std::nullopt;
  if (cursor.rest().empty()) return Date{static_cast<double>(*day), {}};
  const std::string mark(1, cursor.rest().front());
  if (!cursor.take('T') && !cursor.take(' ')) return std::nullopt;
  const auto seconds = read_time(cursor);
  if (!seconds || !is_zone(cursor.rest())) return std::nullopt;
  return Date{static_cast<double>(*day * seconds_of_day) + *seconds, {true, mark, std::string(cursor.rest())}};
}

std::optional<double> day_of_number(double number) {
  constexpr double first = 15'000'101, last = 24'991'231;
  if (!(number >= first && number <= last) || number != std::floor(number)) return std::nullopt;
  const auto digits = static_cast<int>(number);
  const auto day = day_of(digits / 10'000, digits / 100 % 100, digits % 100);
  return day ? std::optional(static_cast<double>(*day)) : std::nullopt;
}

std::string to_text(double value, const DateForm& form) {
  const double seconds = form.times ? value : value * seconds_of_day;
  require(seconds > -62'135'596'801.0 && seconds < 253'402'300'800.0, "dates: need years 1 to 9999, got {} seconds",
          seconds);
  const auto micros = std::llround(std::fmod(seconds, 1) * micros_of_second);
  const long long all = std::llround(std::trunc(seconds)) * micros_of_second + micros;
  const long long of_day = seconds_of_day * micros_of_second;
  const long long day = all >= 0 ? all / of_day : -((of_day - 1 - all) / of_day), rest = all - day * of_day;
  const std::chrono::year_month_day date{std::chrono::sys_days(std::chrono::days(day))};
  std::string text = fmt::format("{0:04}{3}{1:02}{3}{2:02}", static_cast<int>(date.year()),
                                 static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                                 form.basic ? "" : "-");
  if (!form.times && rest == 0) return text;
  const long long second = rest / micros_of_second, micro = rest % micros_of_second;
  text += fmt::format("{0}{1:02}{4}{2:02}{4}{3:02}", form.times ? form.mark : "T", second / 3600, second / 60 % 60,
                      second % 60, form.basic ? "" : ":");
  if (micro != 0) {
    text += fmt::format(".{:06}", micro);
    text.erase(text.find_last_not_of('0') + 1);
  }
  return text + form.zone;
}

}  // namespace subcert::data
