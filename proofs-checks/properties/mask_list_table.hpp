#pragma once
/// Lists of masks in a table of TOML. Inner header.

#include "mask_list_file.hpp"

#include <subcert/proofs-checks/toml_file.hpp>

namespace subcert::properties {

/// Of the keys of read_mask_list(); others are left alone. Domain and errors: as there.
MaskListFile mask_list_of(const toml::table& table);

}  // namespace subcert::properties
