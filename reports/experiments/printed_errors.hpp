#pragma once
/// Errors that a paper prints for data that it does not publish.

#include "experiment.hpp"

namespace subcert::experiments {

/// The printed table beside the measured errors of the schemes that its columns name; no value is reproducible.
/// Errors: throws a domain error for an unknown table or an error that was not measured.
formats::ComparisonTable printed_errors(const std::string& paper, const std::string& table, const Measured& measured);

/// The claim that says so. Errors: as printed_errors().
DecidedClaim printed_errors_claim(const std::string& paper, const std::string& table, const Measured& measured);

}  // namespace subcert::experiments
