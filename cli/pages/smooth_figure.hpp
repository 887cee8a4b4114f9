#pragma once
/// The picture that `subcert smooth --plot` draws.

#include "smooth_page.hpp"

#include <subcert/reports/formats/figure.hpp>

namespace subcert::cli {

/// For each group and column the data, the limit and its band, and under it what is left of the data without the limit;
/// of a derivative the limit and its band alone. Errors and cost: as smooth(), for the values at the data.
formats::Figure figure_of(const std::vector<std::unique_ptr<SmoothPage>>& pages);

}  // namespace subcert::cli
