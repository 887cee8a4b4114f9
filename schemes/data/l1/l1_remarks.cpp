#include "l1_remarks.hpp"

#include "least_absolute.hpp"

#include <fmt/format.h>

namespace subcert::data {

std::vector<std::string> remarks(const DataDependentScheme& scheme, bool even) {
  std::vector<std::string> lines;
  if (!scheme.choice.empty())
    lines.push_back(scheme.choice + (even ? "" : "; proved for uniform data of one weight, which these are not"));
  if (!scheme.rules.options.exact) return lines;
  const int points = scheme.rules.points[0], degree = scheme.rules.degree;
  constexpr std::size_t few = 500;  // pieces
  const Decision unique = unique_minimiser(points, degree, least_absolute_rule(points, degree, 2, few));
  if (!unique.is_yes())
    lines.push_back(fmt::format("{}: the fit {} unique, and the middle one is taken{}", scheme.specification,
                                unique.is_no() ? "of some data is not" : "may not be",
                                degree == 1   ? "; points = 2 mod 4, as 6 or 10, have one line for all data"
                                : degree == 0 ? "; an odd number of points has one median"
                                              : ""));
  if (degree == 0 && points % 2 == 1)
    lines.push_back(
        fmt::format("{}: limits are discontinuous, a step in the data stays a step; take d=1", scheme.specification));
  if (points == degree + 2 && points % 2 == 1)
    lines.push_back(
        fmt::format("{}: the scheme is linear and leaves out the datum in the middle of each window; take "
                    "more points",
                    scheme.specification));
  return lines;
}

}  // namespace subcert::data
