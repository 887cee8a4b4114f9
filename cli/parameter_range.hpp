#pragma once
/// What the commands about families with a parameter share.

#include "checker.hpp"
#include "command.hpp"

#include <subcert/analysis/family/property_range.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/polynomials/box.hpp>
#include <subcert/reports/facts/range_summary.hpp>

#include <utility>

namespace subcert::cli {

/// `w=-1..1` for this name. Errors: throws a usage error.
std::pair<Rational, Rational> read_over(const std::string& written, const std::string& name);

/// One range for each of these names, in their order. Errors: throws a usage error.
Box read_box(const std::vector<std::string>& over, const std::vector<std::string>& names);

/// The names of two or three parameters, in the order of --over. Errors: throws a usage error.
std::vector<std::string> read_names(const std::vector<std::string>& over);

using facts::number_text;
/// So many digits that the ends of an interval differ as they are printed, 12 at least.
int digits_apart(const Rational& low, const Rational& high);
std::string number_text(const Enclosure& value);

using facts::verdict_text;

/// `more sum rules` and so on.
const char* why_text(SpecialValue::Why why);

struct NamedCertificate {
  std::string name;  ///< of its file, without `.cert`
  Certificate certificate;
};

/// The folder that the option names, made if it is missing. Errors: throws missing_file where it cannot be made.
void require_folder(const std::string& directory, const std::string& option = "--certificate");

/// What became of them: the lines that tell how to verify them, and why some are not there.
struct WrittenCertificates {
  std::string text = {};
  WriteFailure failure = {};
};

/// Writes those that the checker accepts into this folder; others whose names end like that, of a run before, are
/// removed. The first that cannot be written is the last that is tried, and nothing is removed then. Adds the same to
/// the object. `without`: of what there are none, where the list is empty.
WrittenCertificates write_certificates(const std::string& directory, const std::vector<NamedCertificate>& certificates,
                                       const std::vector<std::string>& ends, const std::string& without, Json& json);

}  // namespace subcert::cli
