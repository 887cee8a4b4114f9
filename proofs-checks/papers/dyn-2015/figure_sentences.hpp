#pragma once
/// What [DHHS15] says about its Figures 2, 8 and 9 and about the scaling of Table 3, each sentence decided.

#include <subcert/analysis/symbol/numbers.hpp>
#include <subcert/proofs-checks/statements/paper.hpp>

#include <functional>

namespace subcert::statements::dyn_2015 {

inline constexpr int last_n_of_figure_2 = 5;
inline constexpr int last_n_of_figure_8 = 15;

/// The schemes of the curves that are drawn.
std::vector<std::string> schemes_of_figure_2();
std::vector<std::string> schemes_of_figure_8();
std::vector<std::string> schemes_of_figure_9();

/// Certified extremes of a variance curve and of the modulus of its slope.
struct VarianceExtremes {
  Enclosure maximum, minimum, slope;
};

/// What a sentence is found to be, and the numbers that show it.
struct DecidedSentence {
  Truth truth;
  std::string text;
};

/// Decides a cell of the published tables fig2, fig8 and fig9 by the extremes of the schemes that it is about.
/// Errors: throws a domain error for a quantity that is not known. Cost: a comparison of variance curves for each pair
/// of neighbours, where the sentence orders them.
DecidedSentence decide_sentence(const PublishedCell& sentence, const Paper& paper,
                                const std::function<VarianceExtremes(const std::string& scheme)>& extremes);

}  // namespace subcert::statements::dyn_2015
