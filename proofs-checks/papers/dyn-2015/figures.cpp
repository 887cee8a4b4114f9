#include "figures.hpp"

#include <subcert/proofs-checks/statements/computed.hpp>

namespace subcert::statements::dyn_2015 {

std::vector<std::string> schemes_of_figure_2() {
  std::vector<std::string> schemes;
  for (int n = 1; n <= last_n_of_figure_2; ++n) schemes.push_back(specification("primal", n));
  return schemes;
}

std::vector<std::string> schemes_of_figure_8() {
  std::vector<std::string> schemes;
  for (const int degree : {1, 3, 5})
    for (int n = (degree + 1) / 2; n <= last_n_of_figure_8; ++n) schemes.push_back(specification("primal", n, degree));
  return schemes;
}

std::vector<std::string> schemes_of_figure_9() {
  std::vector<std::string> schemes;
  for (const int degree : {1, 3, 5}) schemes.push_back(specification("primal", 5, degree));
  for (const int n : {3, 4, 6, 7}) schemes.push_back(specification("primal", n, 3));
  return schemes;
}

}  // namespace subcert::statements::dyn_2015
