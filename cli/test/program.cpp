#include "program.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>

#include <sys/wait.h>

#include <cstdio>

namespace subcert::testing {
namespace {

std::optional<Rational> end_of(const std::string& text) {
  if (text == "inf" || text == "-inf") return std::nullopt;
  const auto decimal = parse_decimal(text);
  REQUIRE(decimal);
  return decimal->value;
}

}  // namespace

Run run_command(const std::string& command) {
  const std::filesystem::path errors = std::filesystem::temp_directory_path() /
                                       ("subcert-cli-test-" + std::to_string(getpid()) + ".err");
  FILE* pipe = popen((command + " 2>" + errors.string()).c_str(), "r");
  REQUIRE(pipe != nullptr);
  Run result;
  char buffer[4096];
  for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) result.out.append(buffer, n);
  const int status = pclose(pipe);
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + status;
  result.err = content(errors);
  std::filesystem::remove(errors);
  return result;
}

nlohmann::json run_json(const std::string& arguments, int code) {
  const Run result = run(arguments + " --json");
  CAPTURE(arguments, result.err);
  REQUIRE((result.code == code || (code == -1 && (result.code == 0 || result.code == 2))));
  CHECK(result.err.empty());
  return nlohmann::json::parse(result.out);
}

void check_fails(const Run& run, int code, const std::string& message) {
  CHECK(run.code == code);
  CHECK(run.out.empty());
  CHECK(run.err == "subcert: " + message + "\n");
}

Enclosure enclosure_of(const nlohmann::json& json) {
  Enclosure enclosure{end_of(json.at("lower")), end_of(json.at("upper"))};
  REQUIRE(enclosure.is_canonical());
  return enclosure;
}

bool has_digits(const nlohmann::json& enclosure, const std::string& end, const std::string& number) {
  const Enclosure found = enclosure_of(enclosure);
  const auto expected = parse_decimal(number);
  REQUIRE(expected);
  const std::optional<Rational>& value = end == "lower" ? found.lower : found.upper;
  return value && abs(Rational(*value - expected->value)) <= expected->unit;
}

}  // namespace subcert::testing
