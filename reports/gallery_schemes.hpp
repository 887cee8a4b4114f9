#pragma once
/// The schemes of the gallery.

#include <string>
#include <vector>

namespace subcert::reports {

struct GalleryScheme {
  std::string specification;
  std::string key = {};  ///< of docs/references.md, without brackets; empty: a scheme of the reader's own
};

/// Forty schemes of the papers and of the literature.
const std::vector<GalleryScheme>& gallery_schemes();

/// The entry of docs/references.md with this key. Errors: throws a domain error where there is none.
std::string reference(const std::string& key);

}  // namespace subcert::reports
