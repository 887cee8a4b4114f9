#pragma once
/// Proofs that a reader checks in the page itself: by the checker in JavaScript, offline, also from a file.

#include "section.hpp"

#include <string>

namespace subcert::formats {

/// The button and the place of its answer; nothing for a proof without a name. `folder`: of the paper, beside the page.
std::string check_button(const std::string& folder, const RowProof& proof);

/// The same for a page in one file, which holds the certificate.
std::string check_button_inside(const RowProof& proof);

/// The script that gives the files of the proof to the page: PROOF.name + ".js" in the folder.
std::string certificate_script(const std::string& folder, const RowProof& proof);

}  // namespace subcert::formats
