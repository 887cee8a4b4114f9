#pragma once
/// Enclosures in journals.

#include <subcert/analysis/symbol/numbers.hpp>

#include <nlohmann/json_fwd.hpp>

namespace subcert::sweeps {

/// {"lower": "p/q", "upper": "p/q"}, an absent end left out.
nlohmann::ordered_json exact_json(const Enclosure& enclosure);
/// Errors: throws a domain error for anything else.
Enclosure enclosure_from(const nlohmann::ordered_json& json);

}  // namespace subcert::sweeps
