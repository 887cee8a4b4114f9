#pragma once
/// What the commands about families with a parameter share.

#include "command.hpp"

#include <subcert/analysis/family/property_range.hpp>
#include <subcert/analysis/symbol/decimal.hpp>

#include <utility>

namespace subcert::cli {

/// `w=-1..1` for this letter. Errors: throws a usage error.
std::pair<Rational, Rational> read_over(const std::string& text, char parameter);

/// Exact where that is short, else rounded to 12 digits.
std::string number_text(const Rational& value, Rounding rounding = Rounding::nearest);
std::string number_text(const Enclosure& value);

/// `proved`, `refuted` or `undecided`.
const char* verdict_text(Truth holds);

/// `more sum rules` and so on.
const char* why_text(SpecialValue::Why why);

struct NamedCertificate {
  std::string name;  ///< of its file, without `.cert`
  std::string text;
};

/// Writes them into a folder, which is made if it is missing; others whose names end like that, of a run before, are
/// removed. Returns the line that tells how to verify them.
std::string write_certificates(const std::string& directory, const std::vector<NamedCertificate>& certificates,
                               const std::vector<std::string>& ends);

}  // namespace subcert::cli
