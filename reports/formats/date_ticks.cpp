#include "date_ticks.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

namespace subcert::formats {
namespace {

constexpr double most_steps = 6, day = 86'400;
constexpr double days_of_month = 365.2425 / 12;

/// The first of these steps, which rise, of which at most six fit into the span; else the last.
template <std::size_t count>
double step_for(const double (&steps)[count], double span) {
  for (const double step : steps)
    if (span <= most_steps * step) return step;
  return steps[count - 1];
}

std::string text_of(std::chrono::year_month_day date, const char* form) {
  return fmt::format(fmt::runtime(form), static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                     static_cast<unsigned>(date.day()));
}

std::chrono::year_month_day date_of(double seconds) {
  return std::chrono::sys_days(std::chrono::days(static_cast<long>(std::floor(seconds / day))));
}

/// A time of day as exactly as the step asks, or at midnight the date.
std::string text_of(double seconds, double step) {
  const double midnight = std::floor(seconds / day + 1e-12) * day;
  const long long micros = std::llround((seconds - midnight) * 1e6), whole = micros / 1'000'000;
  if (micros == 0) return text_of(date_of(midnight + 1), "{:04}-{:02}-{:02}");
  std::string text = fmt::format("{:02}:{:02}", whole / 3600, whole / 60 % 60);
  if (step < 60) text += fmt::format(":{:02}", whole % 60);
  if (step < 1) text += fmt::format(".{:06}", micros % 1'000'000);
  return text;
}

}  // namespace

std::vector<std::pair<double, std::string>> date_ticks(double low, double high, double unit) {
  using namespace std::chrono;
  const double first = low * unit, last = high * unit, span = last - first;
  std::vector<std::pair<double, std::string>> ticks;
  constexpr double months[] = {1, 2, 3, 6, 12, 24, 60, 120, 240, 600, 1200, 2400, 6000, 12000};
  if (span > most_steps / 2 * days_of_month * day) {
    const auto step = static_cast<long>(step_for(months, span / (days_of_month * day)));
    const year_month_day start = date_of(first);
    const long number = 12L * static_cast<int>(start.year()) + static_cast<long>(static_cast<unsigned>(start.month())) -
                        1;
    for (long month = number / step * step;; month += step) {
      const year_month_day date{year(static_cast<int>(month / 12)),
                                std::chrono::month(static_cast<unsigned>(month % 12) + 1), std::chrono::day(1)};
      const double seconds = static_cast<double>(sys_days(date).time_since_epoch().count()) * day;
      if (seconds > last) return ticks;
      if (seconds >= first)
        ticks.emplace_back(seconds / unit, text_of(date, step % 12 == 0 ? "{:04}" : "{0:04}-{1:02}"));
    }
  }
  // Neighbours differ by a factor of at most three, so that two or more fit.
  constexpr double steps[] = {1e-6,   2e-6,   5e-6, 1e-5,    2e-5,    5e-5,    1e-4,    2e-4, 5e-4, 1e-3,
                              2e-3,   5e-3,   0.01, 0.02,    0.05,    0.1,     0.2,     0.5,  1,    2,
                              5,      10,     30,   60,      120,     300,     600,     1800, 3600, 7200,
                              21'600, 43'200, day,  2 * day, 4 * day, 7 * day, 14 * day};
  const double step = step_for(steps, span);
  for (double number = std::ceil(first / step); number * step <= last; ++number)
    ticks.emplace_back(number * step / unit, text_of(number * step, step));
  return ticks;
}

}  // namespace subcert::formats
