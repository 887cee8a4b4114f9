// Whatever the bytes, a parser takes them or refuses them with an Error, and the checker answers. FUZZED names which.

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/certificates/matrices_file.hpp>
#include <subcert/proofs-checks/certificates/stated_claim.hpp>
#include <subcert/proofs-checks/checker/check.hpp>
#include <subcert/proofs-checks/properties/properties.hpp>
#include <subcert/proofs-checks/sweeps/journal.hpp>
#include <subcert/schemes/data/formats/mesh_file.hpp>
#include <subcert/schemes/data/formats/table.hpp>
#include <subcert/schemes/data/formats/volume.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

/// A file with this content, the same one each time.
std::string file_of(const std::string& text) {
  static const std::string path = std::filesystem::temp_directory_path() / ("subcert-fuzz-" + std::to_string(getpid()));
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

/// The first line is the command line, without the file; the rest is the certificate.
void check(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  std::istringstream words(line);
  std::vector<std::string> arguments;
  for (std::string word; words >> word;)
    if (word != "--matrices" && word != "--subradius") arguments.push_back(word);  // of which other files know
  arguments.push_back(file_of(text.substr(std::min(text.size(), line.size() + 1))));
  std::ostringstream out, errors;
  const int code = subcert_check::run(arguments, out, errors);
  const bool verified = out.str().starts_with("VERIFIED "), rejected = out.str().starts_with("REJECTED ");
  const bool help = out.str().starts_with("usage");
  if (code == 0 ? !verified && !help : code == 1 ? !rejected : errors.str().empty()) std::abort();
}

const std::map<std::string_view, void (*)(const std::string&)> parsers{
    {"certificate", [](const std::string& text) { subcert::read_claim(text, "file"); }},
    {"checker", check},
    {"claim", [](const std::string& text) { subcert::stated_claim(text); }},
    {"expectations", [](const std::string& text) { subcert::properties::read_expectations(text); }},
    {"family", [](const std::string& text) { subcert::make_parametric_scheme(text); }},
    {"journal", [](const std::string& text) { subcert::sweeps::read_journal(file_of(text)); }},
    {"matrices", [](const std::string& text) { subcert::parse_matrices(text, "file"); }},
    {"obj", [](const std::string& text) { subcert::data::parse_obj(text, "file"); }},
    {"off", [](const std::string& text) { subcert::data::parse_off(text, "file"); }},
    {"ply", [](const std::string& text) { subcert::data::parse_ply(text, "file"); }},
    {"stl", [](const std::string& text) { subcert::data::parse_stl(text, "file"); }},
    {"table", [](const std::string& text) { subcert::data::parse_table(text, "file"); }},
    {"vtk", [](const std::string& text) { subcert::data::parse_vtk(text, "file"); }},
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    parsers.at(FUZZED)({reinterpret_cast<const char*>(data), size});
  } catch (const subcert::Error&) {
  }
  return 0;
}
