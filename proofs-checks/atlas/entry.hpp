#pragma once
/// What the atlas says of a mask.

#include <subcert/proofs-checks/sweeps/sweep_plan.hpp>
#include <subcert/schemes/specification.hpp>

#include <string>
#include <vector>

namespace subcert::atlas {

using sweeps::Json;

/// The mask that is entered for a scheme. Errors: throws a usage error unless its mask is one of exact rational numbers
/// in one or two variables.
LatticeMask mask_of_entry(const Scheme& scheme);

/// Facts of the mask and what `regularity` and `variance` answered about it: a member for each of entry_members() but
/// for the names. Numbers are exact, as texts; ends of enclosures are decimals rounded outward, which are exact
/// rationals; what is not known is null. Domain: an answer of `regularity`. Errors: throws undecided where there is
/// none, with what the program said.
Json entry_of(const LatticeMask& canonical, const sweeps::SweepPlan& plan, const Json& answers,
              const std::string& version);

/// A member of an entry.
struct Member {
  std::string name;
  std::string meaning;
  bool of_curves = false;  ///< surfaces may have none
};
const std::vector<Member>& entry_members();

/// Whether it has all members, each of its kind, as an entry has that is not damaged.
bool is_entry(const Json& value);

/// Whether more time could say more of the exponent.
bool is_open(const Json& entry);

}  // namespace subcert::atlas
