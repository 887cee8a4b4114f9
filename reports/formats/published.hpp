#pragma once
/// The values that the papers print, as reports call them.

#include "comparison.hpp"

#include <subcert/proofs-checks/papers/registry.hpp>

namespace subcert::formats {

using statements::PublishedCell;
using statements::PublishedTable;
using PublishedPaper = statements::Paper;

/// Errors: throws a domain error for an unknown key.
inline const PublishedPaper& published_paper(const std::string& key) { return statements::paper(key); }

}  // namespace subcert::formats
