#pragma once
/// Which program made an answer, and from which inputs.

#include <subcert/reports/facts/fact.hpp>

namespace subcert::cli {

constexpr int json_schema = 1;  ///< higher once a field of an answer is renamed, removed or means something else

/// From now on provenance() knows what is read.
void record_inputs();

/// {"version", "commit", "date", "schema", "inputs": [{"name", "sha256"}]}: the schemes that the answer names, each as
/// a line of text, and the files that were read, without their folders.
facts::Json provenance(const facts::Json& answer);

}  // namespace subcert::cli
