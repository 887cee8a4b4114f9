// subcert-check: proves a claim about a mask or about a family of matrices from a certificate
// (../certificates/SPEC.md).
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace subcert_check {

/// Runs the program on its arguments, the name not among them. Prints VERIFIED and the claim to `out` and returns 0 if
/// the certificate proves the claim; otherwise prints REJECTED and why to `out` and returns 1, which never means that
/// the claim is false. Messages about wrong arguments or files go to `errors`. Cost: bounded by the limits in
/// check.cpp.
int run(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& errors);

}  // namespace subcert_check
