// subcert verify FILE|DIR...: asks the independent checker, a program of its own

#include "checker.hpp"
#include "command.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace subcert::cli {
namespace {

struct VerifyOptions : CommonOptions {
  std::vector<std::string> files;
};

/// The claim that the certificate says it proves. The checker proves that claim or rejects; which claim it was is part
/// of the answer.
std::vector<std::string> claim_of(const std::string& file, const std::string& text) {
  std::istringstream lines(text.substr(0, text.size() > 2'000'000 ? 2'000'000 : text.size()));
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

/// The files, and those named .cert in folders, in the order of their names.
std::vector<std::string> certificates_of(const std::vector<std::string>& paths) {
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    if (!fs::is_directory(path)) {
      files.push_back(path);
      continue;
    }
    std::vector<std::string> inside;
    for (const fs::directory_entry& entry : fs::directory_iterator(path))
      if (entry.path().extension() == ".cert") inside.push_back(entry.path().string());
    if (inside.empty()) fail(ErrorKind::missing_file, "{}: no certificates (*.cert) in this folder", path);
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

ExitCode run(const VerifyOptions& options) {
  Json list = Json::array();
  std::string text;
  ExitCode worst = done;
  for (const std::string& file : certificates_of(options.files)) {
    const CheckerAnswer answer = run_checker(claim_of(file, read_file(file)));
    if (answer.code != 0) worst = std::max(worst, static_cast<ExitCode>(answer.code));
    list.push_back({{"file", file}, {"verified", answer.code == 0}, {"answer", answer.text}});
    text += file + ": " + answer.text + "\n";
  }
  options.answer(Json{{"certificates", list}}, text);
  return worst;
}

}  // namespace

void add_verify(Command& app) {
  auto options = std::make_shared<VerifyOptions>();
  Command command = add_command(app, "verify", "Checks certificates with the independent checker",
                                "subcert verify s5.cert", options, [=] { return run(*options); });
  command.option("FILE", options->files, "Certificates, or folders of them").required();
}

}  // namespace subcert::cli
