#pragma once
/// Dates and times as ISO 8601 writes them.

#include <optional>
#include <string>
#include <string_view>

namespace subcert::data {

/// How the dates of a column are written. Canonical: mark and zone empty for dates without times.
struct DateForm {
  bool times = false;  ///< else days alone
  std::string mark;    ///< between date and time: T or a blank
  std::string zone;    ///< behind the time: nothing, Z, or an offset as +01:00
  bool basic = false;  ///< without hyphens and colons, as 20240229
  bool operator==(const DateForm&) const = default;
  /// `days`, or `seconds`.
  std::string unit() const { return times ? "seconds" : "days"; }
};

/// A point of time and how it is written.
struct Date {
  double value;  ///< days, or seconds, since 1970-01-01, in the time of its zone
  DateForm form;
};

/// `2024-02-29`, `2024-02-29T12:30`, `2024-02-29 12:30:05.25Z`, `2024-02-29T12:30:05+01:00`, in the Gregorian calendar,
/// of years 1 to 9999. Nothing for other text.
std::optional<Date> parse_date(std::string_view text);

/// The days since 1970-01-01 of a number that is a date as 20240229, of years 1500 to 2499. Nothing for other numbers.
std::optional<double> day_of_number(double number);

/// The date of this value; of whole days, or of a day and a time where it lies between, to the nearest microsecond.
/// Domain: years 1 to 9999. Errors: throws a domain error.
std::string to_text(double value, const DateForm& form);

}  // namespace subcert::data
