// subcert verify FILE|DIR...: asks the independent checker, a program of its own

#include "level_values.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/checker.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/proofs-checks/certificates/identity.hpp>
#include <subcert/proofs-checks/certificates/stated_claim.hpp>

#include <fmt/format.h>

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

struct Verdict {
  std::string word;  ///< `verified`, `false`, or `rejected`
  ExitCode code;
  std::string text;
};

/// The ends in decimals, where the claim has them as long fractions: ` (1.9901439593863)`.
std::string decimals(const CertificateClaim& claim) {
  constexpr int digits = 14;
  constexpr std::size_t long_fraction = 8;
  const auto is_long = [](const std::optional<std::string>& end) { return end && end->size() > long_fraction; };
  if (claim.says_rough() || !(is_long(claim.lower) || is_long(claim.upper))) return "";
  const auto number = [](const std::optional<std::string>& end) { return end ? parse_number(*end) : std::nullopt; };
  return " (" + enclosure_text({number(claim.lower), number(claim.upper)}, digits) + ")";
}

/// What the file says of itself.
Verdict own_verdict(const CertificateClaim& claim, const std::string& file) {
  const CheckerAnswer answer = run_checker(checker_arguments(claim, file));
  if (answer.code != 0) return {"rejected", static_cast<ExitCode>(answer.code), answer.text};
  return {"verified", done, answer.text + decimals(claim)};
}

/// Errors: as stated_claim, and read_lists.
StatedClaim read_stated(const std::string& words) {
  return stated_claim(words,
                      [](const std::string& file) { return list_subject(without_twins(read_lists(file).list)); });
}

/// A claim in words: what a checker proves of it as it stands, or what follows from what the file says of itself, once
/// a checker proved that of the subject of these words.
Verdict stated_verdict(const std::string& words, const CertificateClaim& own, const std::string& file) {
  const StatedClaim stated = with_letter_of(own, read_stated(words));
  if (stated.is_plain()) {
    const CheckerAnswer answer = run_checker(checker_arguments(stated.claim, file));
    const auto code = static_cast<ExitCode>(answer.code);
    if (code == done) return {"verified", done, answer.text + decimals(stated.claim)};
    if (code != failed) return {"rejected", code, answer.text};  // no claim, or not about these files
  }
  constexpr std::string_view verified = "VERIFIED ";
  const CertificateClaim claim = about_subject_of(stated, own);
  const CheckerAnswer answer = run_checker(checker_arguments(claim, file));
  if (answer.code == static_cast<int>(usage))  // the numbers of the file are none for a claim of this kind
    return {"rejected", failed, fmt::format("REJECTED {}: the certificate is about another property", words)};
  if (answer.code != 0) return {"rejected", static_cast<ExitCode>(answer.code), answer.text};
  const std::string proved = answer.text.substr(verified.size()) + decimals(claim);
  switch (follows(stated, own)) {
    case Truth::yes: return {"verified", done, fmt::format("VERIFIED {}, as {}", words, proved)};
    case Truth::no: return {"false", failed, fmt::format("FALSE {}: {}", words, proved)};
    case Truth::unknown: break;
  }
  return {"rejected", failed, fmt::format("REJECTED {}: neither proved nor refuted by {}", words, proved)};
}

/// What the checkers are to be asked.
CertificateClaim plain_claim(const std::string& words, const CertificateClaim& own) {
  const StatedClaim stated = with_letter_of(own, read_stated(words));
  if (!stated.is_plain())
    fail(ErrorKind::usage,
         "--print-claim: checkers know <= alone, ranges with LOW < HIGH and no recurrences in words, got '{}'", words);
  return stated.claim;
}

/// What is found about the files.
struct Answers {
  Json list = Json::array();
  std::string lines;
  ExitCode worst = done;
};

/// A claim in words about a folder is proved by one of its files.
void ask(const VerifyOptions& options, const std::string& path, Answers& answers) {
  const bool one_suffices = std::filesystem::is_directory(path) && !options.claim.empty();
  bool one_proves = false;
  ExitCode worst = done;
  for (const std::string& file : certificates_in(path)) {
    const std::string text = read_file(file);
    const CertificateClaim own = read_claim(text, file);
    if (options.print_claim) {
      const std::vector<std::string> arguments = checker_arguments(
          options.claim.empty() ? own : plain_claim(options.claim, own), file);
      answers.list.push_back({{"file", file}, {"arguments", arguments}});
      answers.lines += shell_line(arguments);
      continue;
    }
    const Verdict verdict = options.claim.empty() ? own_verdict(own, file) : stated_verdict(options.claim, own, file);
    one_proves = one_proves || verdict.code == done;
    worst = std::max(worst, verdict.code);
    answers.list.push_back({{"file", file},
                            {"verified", verdict.code == done},
                            {"verdict", verdict.word},
                            {"answer", verdict.text},
                            {"id", content_id(text)}});
    answers.lines += file + ": " + verdict.text + "\n";
    if (options.ids) answers.lines += file + ": sha256 " + content_id(text) + "\n";
  }
  if (!one_suffices || !one_proves) answers.worst = std::max(answers.worst, worst);
}

/// A file that cannot be asked about ends the work, after the answers so far.
ExitCode run(const VerifyOptions& options) {
  if (!options.claim.empty()) static_cast<void>(read_stated(options.claim));  // errors before work
  Answers answers;
  std::exception_ptr unread;
  try {
    for (const std::string& path : options.files) ask(options, path, answers);
  } catch (const Error&) {
    if (answers.list.empty()) throw;
    unread = std::current_exception();
  }
  options.answer(Json{{"certificates", answers.list}}, answers.lines);
  if (unread) std::rethrow_exception(unread);
  return answers.worst;
}

}  // namespace

void add_verify(Command& app) {
  auto options = std::make_shared<VerifyOptions>();
  Command command = add_command(app, "verify", "Checks certificates with the independent checker",
                                "subcert verify s5.cert --claim '1.99 <= primal:n=5'", options,
                                [=] { return run(*options); });
  command.option("FILE", options->files, "Certificates, or folders of them").required();
  command.option("--claim", options->claim,
                 "What is to be proved, as '1.99 <= primal:n=5 <= 2', '1 < four-point:w for 1/20 <= w <= 1/10', "
                 "'radius FILE <= 3/2', '1 <= subradius FILE', 'contraction 1,1 of l1:points=6,d=1 <= 3/5', or "
                 "'dd:n=2 = 4-log|[-4,1]@4,0,1/1000|^1/1 with |log h|^1', in place of what "
                 "the certificate says of itself; what follows from that is proved, what contradicts it is false");
  command.flag(
      "--print-claim", options->print_claim,
      "Asks no checker: prints the arguments by which each of them is asked, one line a file, as a shell reads "
      "them");
  command.flag("--ids", options->ids,
               "Also the SHA-256 of each certificate, by which papers may name it; --json has it always");
}

}  // namespace subcert::cli
