#pragma once
/// Dates on the axis of a picture.

#include <string>
#include <utility>
#include <vector>

namespace subcert::formats {

/// Two to eight round points of time between `low` and `high`, counted in units of so many seconds from 1970 on, and
/// how they are written: years, months, days, or times of day, of midnight the date. Domain: low < high, years 1 to
/// 9999.
std::vector<std::pair<double, std::string>> date_ticks(double low, double high, double unit);

}  // namespace subcert::formats
