#pragma once
/// Which schemes [DHHS15] draws in its figures of variance curves.

#include <string>
#include <vector>

namespace subcert::statements::dyn_2015 {

inline constexpr int last_n_of_figure_2 = 5;
inline constexpr int last_n_of_figure_8 = 15;

std::vector<std::string> schemes_of_figure_2();
std::vector<std::string> schemes_of_figure_8();
std::vector<std::string> schemes_of_figure_9();

}  // namespace subcert::statements::dyn_2015
