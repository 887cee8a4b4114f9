// Command line of subcert-check: reads the claim from the arguments, prints VERIFIED or REJECTED.
#include "check.hpp"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

namespace {

constexpr const char* usage =
    "usage: subcert-check --mask '[c0,c1,...]/D@first' --arity A --lower P/Q [--upper P/Q] FILE\n"
    "       subcert-check --matrices MATRICES [--lower P/Q] [--upper P/Q] FILE    (at least one bound)\n"
    "prints VERIFIED <claim> (exit 0) or REJECTED <why, line n> (exit 1)\n"
    "exit 64: wrong usage, 65: malformed MATRICES, 66: missing file\n";

int fail(int code, const std::string& message) {
  std::cerr << "subcert-check: " << message << '\n';
  return code;
}

int run(int argc, char** argv) {
  using namespace subcert_check;
  std::map<std::string, std::string> options;
  std::string file;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--help") {
      std::cout << usage;
      return 0;
    }
    if (argument.starts_with("--")) {
      if (argument != "--mask" && argument != "--arity" && argument != "--matrices" && argument != "--lower" &&
          argument != "--upper")
        return fail(64, "unknown option " + argument);
      if (i + 1 == argc) return fail(64, argument + " needs a value");
      if (!options.emplace(argument, argv[++i]).second) return fail(64, argument + " given twice");
    } else if (argument.empty() || !file.empty()) {
      return fail(64, "need exactly one certificate file");
    } else {
      file = argument;
    }
  }
  const bool mask = options.contains("--mask"), lower = options.contains("--lower");
  if (file.empty() || mask == options.contains("--matrices") || mask != options.contains("--arity") ||
      (!lower && (mask || !options.contains("--upper")))) {
    std::cerr << usage;
    return 64;
  }

  Claim claim;
  std::string option;
  try {
    for (const auto& [name, value] : options) {
      option = name;
      if (name == "--lower") claim.lower = parse_rational(value);
      if (name == "--upper") claim.upper = parse_rational(value);
      if (name == "--arity") {
        const mpq_class arity = parse_rational(value);
        if (arity.get_den() != 1 || arity < 2 || arity > 16) throw Rejected("need an integer 2..16");
        claim.arity = static_cast<unsigned>(arity.get_num().get_ui());
      }
      if (name == "--mask") claim.mask = parse_mask(value);
      if (name == "--mask" || name == "--matrices") claim.subject = value;
    }
  } catch (const Rejected& rejected) {
    return fail(64, option + ": " + rejected.what());
  }
  for (const std::string& path : {mask ? file : claim.subject, file})
    if (!std::filesystem::is_regular_file(path)) return fail(66, "no such file: " + path);
  if (!mask) {
    std::ifstream matrices(claim.subject, std::ios::binary);
    if (!matrices) return fail(66, "cannot read " + claim.subject);
    try {
      claim.family = read_matrices(matrices);
    } catch (const Rejected& rejected) {
      return fail(65, claim.subject + ": " + rejected.what());
    }
  }
  std::ifstream certificate(file, std::ios::binary);
  if (!certificate) return fail(66, "cannot read " + file);
  try {
    check(claim, certificate);
  } catch (const Rejected& rejected) {
    std::cout << "REJECTED " << rejected.what() << std::endl;
    return 1;
  }
  std::cout << "VERIFIED " << claim.text() << std::endl;
  return std::cout ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cout << "REJECTED " << error.what() << ", line 0" << std::endl;
    return 1;
  }
}
