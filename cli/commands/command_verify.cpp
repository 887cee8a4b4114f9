// subcert verify FILE|DIR...: asks the independent checker, a program of its own

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/checker.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/proofs-checks/certificates/claim.hpp>
#include <subcert/proofs-checks/certificates/identity.hpp>

#include <algorithm>
#include <exception>
#include <filesystem>

namespace subcert::cli {
namespace {

struct VerifyOptions : CommonOptions {
  std::vector<std::string> files;
  std::string claim;
  bool print_claim = false;
  bool ids = false;
};

/// As a shell reads it.
std::string in_shell_quotes(const std::string& word) {
  std::string quoted;
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return "'" + quoted + "'";
}

/// A command line of a checker without its name.
std::string shell_line(const std::vector<std::string>& arguments) {
  std::string line;
  for (const std::string& argument : arguments) {
    const bool plain = argument.find_first_not_of(
                           "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,=") == std::string::npos;
    line += (line.empty() ? "" : " ") + (plain && !argument.empty() ? argument : in_shell_quotes(argument));
  }
  return line + "\n";
}

/// A file, or those named .cert in a folder, in the order of their names.
std::vector<std::string> certificates_in(const std::string& path) {
  namespace fs = std::filesystem;
  if (!fs::is_directory(path)) return {path};
  std::vector<std::string> inside;
  for (const fs::directory_entry& entry : fs::directory_iterator(path))
    if (entry.path().extension() == ".cert") inside.push_back(entry.path().string());
  if (inside.empty()) fail(ErrorKind::missing_file, "{}: no certificates (*.cert) in this folder", path);
  std::sort(inside.begin(), inside.end());
  return inside;
}

/// A file that cannot be asked about ends the work, after the answers so far.
ExitCode run(const VerifyOptions& options) {
  Json list = Json::array();
  std::string lines;
  ExitCode worst = done;
  std::exception_ptr unread;
  try {
    for (const std::string& path : options.files)
      for (const std::string& file : certificates_in(path)) {
        const std::string text = read_file(file);
        const std::vector<std::string> arguments = checker_arguments(
            options.claim.empty() ? read_claim(text, file) : stated_claim(options.claim), file);
        if (options.print_claim) {
          list.push_back({{"file", file}, {"arguments", arguments}});
          lines += shell_line(arguments);
          continue;
        }
        const CheckerAnswer answer = run_checker(arguments);
        if (answer.code != 0) worst = std::max(worst, static_cast<ExitCode>(answer.code));
        list.push_back(
            {{"file", file}, {"verified", answer.code == 0}, {"answer", answer.text}, {"id", content_id(text)}});
        lines += file + ": " + answer.text + "\n";
        if (options.ids) lines += file + ": sha256 " + content_id(text) + "\n";
      }
  } catch (const Error&) {
    if (list.empty()) throw;
    unread = std::current_exception();
  }
  options.answer(Json{{"certificates", list}}, lines);
  if (unread) std::rethrow_exception(unread);
  return worst;
}

}  // namespace

void add_verify(Command& app) {
  auto options = std::make_shared<VerifyOptions>();
  Command command = add_command(app, "verify", "Checks certificates with the independent checker",
                                "subcert verify s5.cert --claim '1.99 <= primal:n=5'", options,
                                [=] { return run(*options); });
  command.option("FILE", options->files, "Certificates, or folders of them").required();
  command.option("--claim", options->claim,
                 "What is to be proved, as '1.99 <= primal:n=5 <= 2', '2 <= four-point:w for w=1/20..1/10', "
                 "'radius FILE <= 3/2', '1 <= subradius FILE', 'contraction 1,1 of l1:points=6,d=1 <= 3/5', or "
                 "'dd:n=2 = 4-log|[-4,1]@4,0,1/1000|^1/1 with |log h|^1', in place of what "
                 "the certificate says of itself");
  command.flag(
      "--print-claim", options->print_claim,
      "Asks no checker: prints the arguments by which each of them is asked, one line a file, as a shell reads "
      "them");
  command.flag("--ids", options->ids,
               "Also the SHA-256 of each certificate, by which papers may name it; --json has it always");
}

}  // namespace subcert::cli
