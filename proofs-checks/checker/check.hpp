// subcert-check: proves a claim about a mask or a family of matrices from a certificate (../certificates/SPEC.md).
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace subcert_check {

/// Runs the program on its arguments, the name not among them; returns the exit code. Answers go to `out`, messages
/// about wrong arguments or files to `errors`. Cost: bounded by the limits in check.cpp.
int run(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& errors);

}  // namespace subcert_check
