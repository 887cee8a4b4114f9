#include "parameter_range.hpp"

#include <subcert/analysis/symbol/polynomials/expression.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/schemes/plain_text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

namespace subcert::cli {

std::pair<Rational, Rational> read_over(const std::string& written, const std::string& name) {
  const std::string text = plain_text(written);
  const std::string head = name + "=";
  const std::size_t equals = text.find('='), dots = text.find("..");
  const std::string letter = text.substr(0, std::min(equals, text.size()));
  if (equals != std::string::npos && letter != name)
    fail(ErrorKind::usage, "--over {}: the parameter of the family is {}, not {}", in_quotes(written), name,
         in_quotes(letter));
  const auto number = [&](std::size_t begin, std::size_t end) {
    return begin > end || end - begin > 200 ? std::nullopt
                                            : parse_constant(std::string_view(text).substr(begin, end - begin));
  };
  const auto low = text.starts_with(head) && dots != std::string::npos ? number(head.size(), dots) : std::nullopt,
             // 0...1 is neither 0..0.1 nor 0..1.
      high = low && text.substr(dots + 2, 1) != "." ? number(dots + 2, text.size()) : std::nullopt;
  if (!high || !(*low < *high))
    fail(ErrorKind::usage, "--over: expected {}LOW..HIGH with exact numbers LOW < HIGH, as {}-1..1, got {}", head, head,
         in_quotes(written));
  return {*low, *high};
}

Box read_box(const std::vector<std::string>& over, const std::vector<std::string>& names) {
  Box box;
  for (std::size_t v = 0; v < names.size(); ++v) {
    auto [low, high] = read_over(over[v], names[v]);
    box.low.push_back(std::move(low));
    box.high.push_back(std::move(high));
  }
  return box;
}

std::vector<std::string> read_names(const std::vector<std::string>& over) {
  std::vector<std::string> names;
  for (const std::string& range : over) {
    const std::string name = plain_text(range.substr(0, range.find('=')));
    const bool letters = !name.empty() &&
                         std::ranges::all_of(name, [](unsigned char c) { return std::isalpha(c) != 0; });
    if (letters && name.size() < range.size() && std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  if (over.size() < 2 || over.size() > 3 || names.size() != over.size())
    fail(ErrorKind::usage,
         "--over: expected two or three ranges with different letters, --over v=LOW..HIGH --over w=LOW..HIGH");
  return names;
}

int digits_apart(const Rational& low, const Rational& high) {
  return low < high ? digits_within(std::max(abs(low), abs(high)), (high - low) / 4, 12) : 12;
}

std::string number_text(const Enclosure& value) {
  return value.is_exact() ? number_text(*value.lower) : enclosure_text(value, 12);
}

const char* why_text(SpecialValue::Why why) {
  switch (why) {
    case SpecialValue::Why::sum_rules: return "more sum rules";
    case SpecialValue::Why::unstable: return "shifts may be unstable";
    case SpecialValue::Why::sign: return "a coefficient vanishes";
    default: return "a radius meets the threshold";
  }
}

void require_folder(const std::string& directory, const std::string& option) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (!std::filesystem::is_directory(directory, error))
    fail(ErrorKind::missing_file, "{} {}: expected a folder, or a place where one can be made", option, directory);
}

namespace {

/// Certificates of a run before.
void remove_others(const std::string& directory, const std::vector<std::string>& ends,
                   const std::set<std::string>& written) {
  namespace fs = std::filesystem;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    const std::string name = entry.path().stem().string();
    const bool ours = std::any_of(ends.begin(), ends.end(),
                                  [&](const std::string& end) { return name.ends_with(end); });
    if (entry.path().extension() == ".cert" && ours && !written.contains(name)) fs::remove(entry.path());
  }
}

}  // namespace

WrittenCertificates write_certificates(const std::string& directory, const std::vector<NamedCertificate>& certificates,
                                       const std::vector<std::string>& ends, const std::string& without, Json& json) {
  std::set<std::string> written;
  WrittenCertificates result;
  Json reasons = Json::object();
  for (const NamedCertificate& named : certificates) {
    const WrittenCertificate one = write_certificate(std::filesystem::path(directory) / (named.name + ".cert"),
                                                     [&] { return named.certificate; });
    if (one.claim) {
      written.insert(named.name);
    } else {
      result.text += fmt::format("certificate  {} not written: {}\n", named.name, one.reason);
      reasons[named.name] = one.reason;
    }
    result.failure = one.failure;
    if (one.failure.error) break;
  }
  try {
    if (!result.failure.error) remove_others(directory, ends, written);
  } catch (const std::filesystem::filesystem_error& error) {
    result.failure.error.emplace(ErrorKind::missing_file,
                                 "cannot remove " + error.path1().string() + ": " + error.code().message());
  }
  json["certificates"] = written.size();
  if (!reasons.empty()) json["certificate_reason"] = reasons;
  if (!written.empty())
    result.text.insert(
        0, fmt::format("certificates {} in {}, verified: subcert verify {}\n", written.size(), directory, directory));
  if (certificates.empty()) result.text = "certificates none: there are none for " + without + "\n";
  return result;
}

}  // namespace subcert::cli
