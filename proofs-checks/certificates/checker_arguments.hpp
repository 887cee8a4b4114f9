#pragma once
/// How the independent checker is to be asked about a certificate.

#include <string>
#include <vector>

namespace subcert {

/// The command line of subcert-check, without its name, for the claim that a certificate says it proves: the checker
/// proves that claim or rejects, and says which claim it was. `text`: the certificate, or its beginning; `file`: its
/// name, which errors call it by; a certificate of a radius has its matrices beside it, in `file`.matrices. Errors:
/// throws a data error for a text that is no certificate. Cost: the first three lines are read.
std::vector<std::string> checker_arguments(const std::string& text, const std::string& file);

}  // namespace subcert
