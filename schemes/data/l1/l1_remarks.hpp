#pragma once
/// What a user of a scheme of l1 regression should know before applying it.

#include <subcert/schemes/specification.hpp>

#include <string>
#include <vector>

namespace subcert::data {

/// Lines: what the program chose, fits that are not unique, limits that are discontinuous, data that are left out;
/// `even`: for uniform data of one weight, of which what is said is proved. Cost: milliseconds.
std::vector<std::string> remarks(const DataDependentScheme& scheme, bool even = true);

}  // namespace subcert::data
