#pragma once
/// Pages of an atlas.

#include <subcert/proofs-checks/atlas/atlas.hpp>

#include <filesystem>
#include <functional>

namespace subcert::reports {

/// Writes FOLDER/index.html, a table of the entries that are wanted with a search, FOLDER/X.html with the entries whose
/// ids begin with X, each with what is known, a picture of its limit function, and a button that checks its
/// certificate in the page, where the atlas has one: FOLDER/certificates/ID.cert. All open from files, without a
/// network. Returns the number of entries. Domain: jobs >= 1. Errors: throws missing_file, and as Atlas. Cost: 2,000
/// values of the limit for each entry; the entries of one page are held at a time, and a row of each.
std::size_t write_atlas_site(const atlas::Atlas& atlas, const std::function<bool(const atlas::Json&)>& is_wanted,
                             const std::filesystem::path& folder, int jobs);

}  // namespace subcert::reports
