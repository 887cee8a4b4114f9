#pragma once
/// How the independent checker is to be asked about a certificate.

#include <string>
#include <vector>

namespace subcert {

/// The command line of subcert-check, without its name, for the claim that a certificate says it proves: the checker
/// proves that claim or rejects, and says which claim it was. `text`: the certificate; `file`: its
/// name, which errors call it by; a certificate of a radius has its matrices beside it, in `file`.matrices. Errors:
/// throws a data error for a text that is no certificate. Cost: the first four lines are read.
std::vector<std::string> checker_arguments(const std::string& text, const std::string& file);

/// The same for a claim that is stated from outside: `[LOWER <=] SUBJECT [= EXACT [with |log h|^P]] [<= UPPER]`, blanks
/// around the signs. EXACT is a number as in SPEC.md, section 1. SUBJECT is a
/// scheme, whose exponent is meant; a family with a parameter, as `four-point:w for w=1/100..19/100`; or `radius FILE`,
/// of the matrices in that file. LOWER and UPPER are exact numbers, UPPER also `C2`, for limits that are not C^2;
/// without both the integer shifts are stable. Errors: throws a usage error for another text, and for a scheme with
/// rounded coefficients, of which a claim needs the distance.
std::vector<std::string> stated_checker_arguments(const std::string& claim, const std::string& file);

}  // namespace subcert
