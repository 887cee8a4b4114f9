#pragma once
/// What is said of a scheme, in words.

#include "gallery.hpp"

#include <string>
#include <vector>

namespace subcert::reports {

/// Plain text, as for a terminal.
struct Fact {
  std::string name;
  std::string value;
  std::string remark = {};  ///< why, or in what sense
};

/// In an order that is the same for all schemes; what is not known of this one is left out.
std::vector<Fact> facts(const Plate& plate);

/// The names of the facts of any of these schemes, in that order.
std::vector<std::string> fact_names(const std::vector<std::vector<Fact>>& of_schemes);

/// The coefficients, to ten digits where they are too long for people.
std::string mask_text(const Scheme& scheme);

}  // namespace subcert::reports
