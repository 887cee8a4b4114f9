#pragma once
/// Dates and times as ISO 8601 writes them or between full stops, months and quarters.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace subcert::data {

/// What positions count in.
enum class DateUnit { second, day, month, quarter };

/// How the dates of a column are written. Canonical: mark and zone empty for dates without times; times
/// stand behind `%Y-%m-%d`, `%d.%m.%Y` and `%e.%n.%Y` alone.
struct DateForm {
  bool times = false;             ///< else days, months or quarters alone
  std::string mark = {};          ///< between date and time: T or a blank
  std::string zone = {};          ///< behind the time: nothing, Z, or an offset as +01:00
  std::string date = "%Y-%m-%d";  ///< %Y year, %m and %n month with and without a leading 0, %b and %B its name, short
                                  ///< and long, %q quarter, %d and %e day with and without a leading 0
  bool operator==(const DateForm&) const = default;
  DateUnit unit() const;
  /// `days`, `seconds` and so on.
  std::string unit_name() const;
};

/// A point of time and how it is written.
struct Date {
  double value;  ///< units since 1970 began, in the time of its zone
  DateForm form;
};

/// All readings of a text, the most likely first: `2024-02-29`, `2024-02-29T12:30`, `2024-02-29 12:30:05.25Z`,
/// `2024-02-29T12:30:05+01:00`, `Feb-29-2024`, `29.02.2024`, `1.2.2024 12:30`; months as `2024-02`, `Feb 2024`,
/// `February 2024`, `Feb-2024`, `2024M2`; quarters as `2024Q1`, `2024-Q1`, `2024 Q1`, `Q1 2024`; in the Gregorian
/// calendar, of years 1 to 9999. Several where one text may be written by several forms, as `May 2024` and `2024M12`
/// are.
std::vector<Date> readings_of_date(std::string_view text);

/// The value of a text in this form; nothing for other text.
std::optional<double> parse_date(std::string_view text, const DateForm& form);

/// Whether a month by this form, as 2001-02, may be two years that follow each other.
bool may_be_two_years(std::string_view text, const DateForm& form);

/// The days since 1970-01-01 of a number that is a date as 20240229, of years 1500 to 2499. Nothing for other numbers.
std::optional<double> day_of_number(double number);

/// Seconds since 1970 began of forms with times, else days. Within a month or quarter time runs evenly.
double time_of(double value, const DateForm& form);

/// The date of this value; where it lies between units the day and the time, to the nearest microsecond. Domain: years
/// 1 to 9999. Errors: throws a domain error.
std::string to_text(double value, const DateForm& form);

}  // namespace subcert::data
