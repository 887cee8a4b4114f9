#pragma once
/// Computer-assisted theorems about the variance curves of the primal least squares schemes. Texts: docs/theorems/.

#include "check.hpp"
#include "constants.hpp"
#include "patience.hpp"

#include <string>
#include <utility>
#include <vector>

namespace subcert::theorems {

/// That can be asked for; what holds for every degree is then shown for this one.
constexpr int largest_degree = 301;

struct Theorem {
  std::string id;
  std::vector<int> degrees;  ///< that it speaks about
  std::string title;
  std::vector<std::string> statement;  ///< in words, one sentence each
  std::string text;                    ///< where the proof stands
  Constants constants;
  std::vector<Check> checks;
  std::vector<std::pair<std::string, std::string>> ranges;  ///< which n, and by what they are settled
  std::vector<std::pair<std::string, std::string>> values;  ///< numbers that the theorem gives, with their names
  std::vector<std::string> missing;                         ///< what would be needed where nothing is proved
  Decision decision;         ///< the verdict on all checks; unknown where something is missing
  bool out_of_time = false;  ///< which is time alone
};

/// A theorem that can be asked for; where nothing is proved for a degree the answer says what is missing.
struct TheoremEntry {
  std::string id;
  std::string title;
  std::string range;              ///< of n, and of the degrees where they are not only those listed
  std::vector<int> degrees;       ///< for which it can be asked and is proved
  std::string family = "primal";  ///< where none is named
};

const std::vector<TheoremEntry>& theorem_list();

/// Runs every inequality of the proof with the constants that the text states, or that the proof finds; kept in this
/// process. `family` is that of a specification: primal, primal-odd, dual or dual-odd. Domain: 1 <= degree <=
/// largest_degree, odd for the primal families, whose even degrees have the schemes of degree + 1. Errors: throws a
/// domain error for an unknown id or family and for a degree beyond. Cost: seconds, for degree 13 a quarter of a minute
/// on one thread.
const Theorem& proved(const std::string& id, int degree, const std::string& family = "primal", int threads = 1);

/// The same with these constants, not kept.
Theorem prove(const std::string& id, int degree, const Constants& constants, int threads = 1,
              const std::string& family = "primal");

/// `proved`, or, where the patience ends first, unknown with the inequalities that were proved until then.
Theorem prove_in_time(const std::string& id, int degree, const std::string& family, int threads,
                      const Patience& patience);

}  // namespace subcert::theorems
