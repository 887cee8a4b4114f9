#include "dates.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>

#include <array>
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
  /// One or two, the first no 0.
  std::optional<int> digits_without_zero() {
    if (rest_.empty() || rest_.front() == '0') return std::nullopt;
    const auto both = digits(2);
    return both ? both : digits(1);
  }
  bool take(std::string_view text) {
    if (!rest_.starts_with(text)) return false;
    rest_.remove_prefix(text.size());
    return true;
  }
  bool take(char c) { return take(std::string_view(&c, 1)); }
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

constexpr std::array<std::string_view, 12> month_names{"January",   "February", "March",    "April",
                                                       "May",       "June",     "July",     "August",
                                                       "September", "October",  "November", "December"};
constexpr std::array<std::string_view, 16> known_forms{"%Y-%m-%d", "%Y-%m",    "%YQ%q",    "%Y-Q%q",  "%Y Q%q", "%Yq%q",
                                                       "Q%q %Y",   "%YM%m",    "%YM%n",    "%Ym%n",   "%b %Y",  "%B %Y",
                                                       "%b-%Y",    "%b-%e-%Y", "%d.%m.%Y", "%e.%n.%Y"};
constexpr std::string_view basic_form = "%Y%m%d";

/// Day, month and year between full stops, which nobody writes in another order.
bool is_dotted(std::string_view form) { return form.ends_with(".%Y"); }

std::string_view name_of_month(std::size_t month, char field) {
  return month_names[month - 1].substr(0, field == 'b' ? 3 : std::string_view::npos);
}

/// What the fields of a text hold.
struct DateFields {
  int year = 1970, month = 1, day = 1, quarter = 1;
};

bool read_month_name(Cursor& text, char field, int& month) {
  for (std::size_t k = 1; k <= month_names.size(); ++k)
    if (text.take(name_of_month(k, field))) {
      month = static_cast<int>(k);
      return true;
    }
  return false;
}

bool read_into(int& field, std::optional<int> value) {
  if (value) field = *value;
  return value.has_value();
}

bool read_field(Cursor& text, char field, DateFields& fields) {
  switch (field) {
    case 'Y': return read_into(fields.year, text.digits(4)) && fields.year > 0;
    case 'm': return read_into(fields.month, text.digits(2));
    case 'n': return read_into(fields.month, text.digits_without_zero());
    case 'd': return read_into(fields.day, text.digits(2));
    case 'e': return read_into(fields.day, text.digits_without_zero());
    case 'q': return read_into(fields.quarter, text.digits(1));
    default: return read_month_name(text, field, fields.month);
  }
}

/// Reads what stands before a time.
std::optional<DateFields> read_fields(Cursor& text, std::string_view form) {
  DateFields fields;
  for (std::size_t k = 0; k < form.size(); ++k)
    if (form[k] == '%' ? !read_field(text, form[++k], fields) : !text.take(form[k])) return std::nullopt;
  return fields;
}

DateUnit unit_of(std::string_view date) {
  if (date.find("%q") != std::string_view::npos) return DateUnit::quarter;
  return date.find("%d") == std::string_view::npos && date.find("%e") == std::string_view::npos ? DateUnit::month
                                                                                                : DateUnit::day;
}

std::optional<long> units_of(const DateFields& fields, DateUnit unit) {
  if (unit == DateUnit::day) return day_of(fields.year, fields.month, fields.day);
  const bool quarters = unit == DateUnit::quarter;
  const int in_year = quarters ? 4 : 12, part = quarters ? fields.quarter : fields.month;
  if (part < 1 || part > in_year) return std::nullopt;
  return static_cast<long>(in_year) * (fields.year - 1970) + part - 1;
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

DateUnit DateForm::unit() const { return times ? DateUnit::second : unit_of(date); }

std::string DateForm::unit_name() const {
  static constexpr const char* names[] = {"seconds", "days", "months", "quarters"};
  return names[static_cast<std::size_t>(unit())];
}

namespace {

/// By this form of the date, with or without a time.
std::optional<Date> read_date(std::string_view text, std::string_view form) {
  Cursor cursor(text);
  const auto fields = read_fields(cursor, form);
  const auto units = fields ? units_of(*fields, unit_of(form)) : std::nullopt;
  if (!units) return std::nullopt;
  DateForm made;
  made.date = form;
  if (cursor.rest().empty()) return Date{static_cast<double>(*units), made};
  made.times = true;
  made.mark = cursor.rest().front();
  const bool iso = made.date == DateForm{}.date;
  if ((!iso && !is_dotted(form)) || (!(iso && cursor.take('T')) && !cursor.take(' '))) return std::nullopt;
  const auto seconds = read_time(cursor);
  made.zone = cursor.rest();
  if (!seconds || !is_zone(made.zone)) return std::nullopt;
  return Date{static_cast<double>(*units * seconds_of_day) + *seconds, made};
}

}  // namespace

std::vector<Date> readings_of_date(std::string_view text) {
  std::vector<Date> readings;
  for (const std::string_view form : known_forms)
    if (auto date = read_date(text, form)) readings.push_back(std::move(*date));
  return readings;
}

std::optional<double> parse_date(std::string_view text, const DateForm& form) {
  const auto date = read_date(text, form.date);
  return date && date->form == form ? std::optional(date->value) : std::nullopt;
}

bool may_be_two_years(std::string_view text, const DateForm& form) {
  Cursor cursor(text);
  const auto fields = form.date == "%Y-%m" ? read_fields(cursor, form.date) : std::nullopt;
  return fields && fields->month == (fields->year + 1) % 100;
}

std::optional<double> day_of_number(double number) {
  constexpr double first = 15'000'101, last = 24'991'231;
  if (!(number >= first && number <= last) || number != std::floor(number)) return std::nullopt;
  const auto digits = static_cast<int>(number);
  const auto day = day_of(digits / 10'000, digits / 100 % 100, digits % 100);
  return day ? std::optional(static_cast<double>(*day)) : std::nullopt;
}

double time_of(double value, const DateForm& form) {
  const DateUnit unit = form.unit();
  if (unit == DateUnit::second || unit == DateUnit::day) return value;
  const long months = unit == DateUnit::quarter ? 3 : 1;
  const auto begin_of = [&](double units) {
    const long month = static_cast<long>(units) * months, year = floor_divide(month, 12);
    return static_cast<double>(
        day_of(static_cast<int>(1970 + year), static_cast<int>(month - 12 * year) + 1, 1).value_or(0));
  };
  const double whole = std::floor(value);
  require(std::abs(whole) < 120'000, "dates: need years 1 to 9999, got {} {}", value, form.unit_name());
  return begin_of(whole) + (value - whole) * (begin_of(whole + 1) - begin_of(whole));
}

namespace {

std::string date_text(const std::chrono::year_month_day& date, std::string_view form) {
  const unsigned month = static_cast<unsigned>(date.month()), day = static_cast<unsigned>(date.day());
  std::string text;
  for (std::size_t k = 0; k < form.size(); ++k) {
    if (form[k] != '%') {
      text += form[k];
      continue;
    }
    switch (const char field = form[++k]) {
      case 'Y': text += fmt::format("{:04}", static_cast<int>(date.year())); break;
      case 'm': text += fmt::format("{:02}", month); break;
      case 'n': text += fmt::format("{}", month); break;
      case 'd': text += fmt::format("{:02}", day); break;
      case 'e': text += fmt::format("{}", day); break;
      case 'q': text += fmt::format("{}", (month + 2) / 3); break;
      default: text += name_of_month(month, field);
    }
  }
  return text;
}

}  // namespace

std::string to_text(double value, const DateForm& form) {
  constexpr double nearly = 1e-9;  // units of months, whose lengths differ
  const DateUnit unit = form.unit();
  const bool of_months = unit == DateUnit::month || unit == DateUnit::quarter;
  const bool whole = of_months && std::abs(value - std::round(value)) < nearly;
  const double time = time_of(whole ? std::round(value) : value, form);
  const double seconds = form.times ? time : time * seconds_of_day;
  require(seconds > -62'135'596'801.0 && seconds < 253'402'300'800.0, "dates: need years 1 to 9999, got {} seconds",
          seconds);
  const auto micros = std::llround(std::fmod(seconds, 1) * micros_of_second);
  const long long all = std::llround(std::trunc(seconds)) * micros_of_second + micros;
  const long long of_day = seconds_of_day * micros_of_second;
  const long long day = all >= 0 ? all / of_day : -((of_day - 1 - all) / of_day), rest = all - day * of_day;
  const std::chrono::year_month_day date{std::chrono::sys_days(std::chrono::days(day))};
  const bool between = of_months ? !whole : !form.times && rest != 0, basic = form.date == basic_form;
  const bool dotted = is_dotted(form.date);
  std::string text = date_text(date, between && !basic && !dotted ? DateForm{}.date : form.date);
  if (!form.times && rest == 0) return text;
  const long long second = rest / micros_of_second, micro = rest % micros_of_second;
  text += fmt::format("{0}{1:02}{4}{2:02}{4}{3:02}",
                      form.times ? form.mark
                      : dotted   ? " "
                                 : "T",
                      second / 3600, second / 60 % 60, second % 60, basic ? "" : ":");
  if (micro != 0) {
    text += fmt::format(".{:06}", micro);
    text.erase(text.find_last_not_of('0') + 1);
  }
  return text + form.zone;
}

}  // namespace subcert::data
