#pragma once
/// The independent checker, a program of its own, and how it is asked.

#include "certificate.hpp"

#include <string>
#include <vector>

namespace subcert {

struct CheckerAnswer {
  int code;
  std::string text;  ///< without the last end of line
};

/// subcert-check beside this program, or else the one on the PATH.
std::string checker_program();

/// Runs the checker. Errors: throws missing_file where there is none.
CheckerAnswer run_checker(const std::vector<std::string>& arguments, const std::string& program = checker_program());

/// Asks the checker whether the text of a certificate proves a claim, and the matrices that one of a radius is about;
/// the answer names no file. Errors: as run_checker(); missing_file where there is no place for temporary files.
CheckerAnswer check_certificate(const CertificateClaim& claim, const std::string& text,
                                const std::string& matrices = {}, const std::string& program = checker_program());

/// The certificate if the checker accepts it, or else, if it accepts that, the one of the bounds alone. Errors: throws
/// undecided, with the checker's reason, where it accepts neither, else as check_certificate(). Cost: at most two runs
/// of the checker.
Certificate verified(const Certificate& certificate, const std::string& matrices = {});

}  // namespace subcert
