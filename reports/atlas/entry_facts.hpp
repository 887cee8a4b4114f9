#pragma once
/// An entry of an atlas for people.

#include <subcert/proofs-checks/atlas/entry.hpp>
#include <subcert/reports/facts/fact.hpp>

namespace subcert::facts {

/// A fact for each member, with a label for those that are known. Enclosures have the digits that are for people; in
/// JSON all is as it is entered.
Facts entry_facts(const Json& entry);

/// The first name, or else the mask.
std::string title_of_entry(const Json& entry);

}  // namespace subcert::facts
