#pragma once
/// Dyn, Heard, Hormann & Sharon 2015 [DHHS15], statement by statement.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/proofs-checks/statements/statement.hpp>
#include <subcert/proofs-checks/statements/trial.hpp>

#include <string>
#include <vector>

namespace subcert::statements::dyn_2015 {

/// All of them.
Checks checks();

/// The mask of S_n.
Mask s_n(long n);
/// `n = 2..10`, or `n = 2`.
std::string range(int first, int last);
/// `n = 2, d = 1`, as in witnesses.
std::string at_n_d(int n, int d);

/// A maximum of psi or, where `slope`, of |psi'|, times a power of n.
struct ScaledMaximum {
  bool slope;
  int factor;
};
/// Domain: a cell of Table 3. Errors: throws a domain error for another quantity.
ScaledMaximum scaled_maximum(const PublishedCell& cell);

/// Whether every inequality of the theorem for this degree is certified.
Trial proved_theorem(const std::string& theorem, int degree = 1, const std::string& family = "primal");

/// Why fits of degree d to m > d nodes are unique.
inline const std::string few_zeros =
    "a polynomial of degree d that vanishes at m > d nodes is zero, so that the Vandermonde matrix has no kernel; ";

/// The words of a transcription in a table, in both forms, against certified enclosures, and how far off they are.
/// Domain: Tables 1, 2 and 3.
Outcome table_words(const Context& context, const std::string& id);

/// Of one part of the paper each.
Checks section_2();
Checks section_2_2();
Checks section_2_2_theorem_5();
Checks section_3();
Checks section_4();
Checks section_4_3();
Checks section_5();
Checks appendix();

inline constexpr int last_n_of_figure_2 = 5;
inline constexpr int last_n_of_figure_8 = 15;

std::vector<std::string> schemes_of_figure_2();
std::vector<std::string> schemes_of_figure_8();
std::vector<std::string> schemes_of_figure_9();

}  // namespace subcert::statements::dyn_2015
