#include "checker_arguments.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <sstream>
#include <string_view>

namespace subcert {
namespace {

constexpr std::size_t longest_head = 2'000'000;  // characters in which the first three lines end

}  // namespace

std::vector<std::string> checker_arguments(const std::string& text, const std::string& file) {
  std::istringstream lines(text.substr(0, longest_head));
  std::string version, subject, bounds;
  std::getline(lines, version);
  std::getline(lines, subject);
  std::getline(lines, bounds);
  std::istringstream subject_words(subject), bound_words(bounds);
  std::string kind, first, second, range, word, lower, upper;
  subject_words >> kind >> first >> second >> range;
  bound_words >> word >> lower >> upper;
  if (version.rfind("subcert-certificate", 0) != 0 || word != "bounds" || upper.empty() || second.empty())
    fail(ErrorKind::data, "{}: not a certificate", file);
  std::vector<std::string> arguments;
  if (kind == "exponent")
    arguments = {"--mask", first, "--arity", second};
  else if (kind == "surface")
    arguments = {"--surface", first, "--dilation", second};
  else if (kind == "radius")
    arguments = {"--matrices", file + ".matrices"};
  else
    fail(ErrorKind::data, "{}, line 2: expected exponent, surface or radius", file);
  constexpr std::string_view within = "within=";
  if (kind == "exponent" && range.starts_with(within))
    arguments.insert(arguments.end(), {"--within", range.substr(within.size())});
  else if (kind == "exponent" && !range.empty())
    arguments.insert(arguments.end(), {"--for", range});
  if (lower != "-") arguments.insert(arguments.end(), {"--lower", lower});
  if (upper != "-") arguments.insert(arguments.end(), {"--upper", upper});
  arguments.push_back(file);
  return arguments;
}

}  // namespace subcert
