#pragma once
/// What [DHHS15] says about its Figures 2, 8 and 9 and about the scaling of Table 3, each sentence decided.

#include "computed_quantities.hpp"

namespace subcert::reports {

constexpr int last_n_of_figure_2 = 5;
constexpr int last_n_of_figure_8 = 15;

std::vector<std::string> schemes_of_figure_2();
std::vector<std::string> schemes_of_figure_8();
std::vector<std::string> schemes_of_figure_9();

/// Domain: the published tables fig2, fig8 and fig9. Errors: throws a domain error for a statement that is not
/// known.
formats::ComparisonTable compare_statements(const statements::PublishedTable& table, ComputedQuantities& quantities);

}  // namespace subcert::reports
