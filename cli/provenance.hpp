#pragma once
/// Which program made an answer.

#include <subcert/reports/facts/fact.hpp>

namespace subcert::cli {

constexpr int json_schema = 1;  ///< higher once a field of an answer is renamed, removed or means something else

/// {"version", "commit", "schema"}
facts::Json provenance();

}  // namespace subcert::cli
