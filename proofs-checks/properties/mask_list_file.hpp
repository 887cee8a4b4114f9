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

/// Adds the scheme of a specification, of one variable, numbers or matrices. Errors: throws Error where it cannot be
/// read, is rounded, or has another arity or size than the others, or is one of Hermite schemes where they are not.
void add_mask(MaskListFile& file, std::string_view specification);

/// Errors: throws a data error for masks of matrices that keep no constant data in common. Domain: a mask at least.
void require_common_data(const MaskList& list);

/// Reads TOML: `masks`, a list of specifications of schemes of one variable, of numbers or of matrices of one size, and
/// `period`, a list of their numbers from 0, or `follows`, a list of pairs [BEFORE, AFTER]; with neither each mask may
/// follow each. Domain: 1 to 64 masks, up to 4096 pairs, a period of up to 6 masks. Errors: throws FileError.
MaskListFile read_mask_list(std::string_view text);

}  // namespace subcert::properties
