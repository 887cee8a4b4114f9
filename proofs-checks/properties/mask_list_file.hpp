#pragma once
/// Lists of masks for levels, as people write them: docs/levels.md.

#include <subcert/analysis/family/mask_list.hpp>
#include <subcert/proofs-checks/file_error.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace subcert::properties {

struct MaskListFile {
  std::vector<std::string> specifications;  ///< in canonical form
  MaskList list;
};

/// Reads TOML: `masks`, a list of specifications of schemes of one variable, and `period`, a list of their numbers from
/// 0, or `follows`, a list of pairs [BEFORE, AFTER]; with neither each mask may follow each. Domain: 1 to 64 masks, up
/// to 4096 pairs, a period of up to 6 masks. Errors: throws FileError.
MaskListFile read_mask_list(std::string_view text);

}  // namespace subcert::properties
