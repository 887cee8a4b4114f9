// subcert jsr FILE: the joint spectral radius of any finite set of rational matrices

#include "command.hpp"
#include "exponent_text.hpp"

#include <subcert/analysis/regularity/radius/joint_spectral_radius.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <sstream>

namespace subcert::cli {
namespace {

struct JsrOptions : SearchOptions {
  std::string file;
  std::string certificate;
};

constexpr std::size_t most_matrices = 64, largest_size = 256, longest_number = 4000;

Rational read_entry(const nlohmann::json& entry, const std::string& where) {
  const std::string text = entry.is_string()           ? entry.get<std::string>()
                           : entry.is_number_integer() ? entry.dump()
                                                       : std::string();
  const auto value = text.size() > longest_number ? std::nullopt : parse_rational(text);
  if (!value)
    fail(ErrorKind::data, "{}: expected an exact number \"p\" or \"p/q\", got {}", where, entry.dump().substr(0, 40));
  return *value;
}

MatrixFamily read_matrices(const std::string& file) {
  const auto json = nlohmann::json::parse(read_file(file), nullptr, false);
  if (json.is_discarded()) fail(ErrorKind::data, "{}: not a JSON file", file);
  if (!json.is_object() || !json.contains("matrices") || !json["matrices"].is_array() || json["matrices"].empty() ||
      json["matrices"].size() > most_matrices)
    fail(ErrorKind::data, "{}: expected {{\"matrices\": [...]}} with 1 to 64 matrices", file);
  std::vector<RationalMatrix> result;
  const std::size_t size = json["matrices"][0].is_array() ? json["matrices"][0].size() : 0;
  if (size < 1 || size > largest_size) fail(ErrorKind::data, "{}, matrix 0: expected 1 to 256 rows", file);
  for (const auto& rows : json["matrices"]) {
    const std::string name = file + ", matrix " + std::to_string(result.size());
    if (!rows.is_array() || rows.size() != size) fail(ErrorKind::data, "{}: expected {} rows", name, size);
    RationalMatrix matrix(size, size);
    for (std::size_t i = 0; i < size; ++i) {
      const std::string where = name + ", row " + std::to_string(i);
      if (!rows[i].is_array() || rows[i].size() != size) fail(ErrorKind::data, "{}: expected {} entries", where, size);
      for (std::size_t j = 0; j < size; ++j)
        matrix(i, j) = read_entry(rows[i][j], where + ", entry " + std::to_string(j));
    }
    result.push_back(std::move(matrix));
  }
  return result;
}

ExitCode run(const JsrOptions& options) {
  const MatrixFamily matrices = read_matrices(options.file);
  options.progress("products and polytopes");
  const Budget budget = options.limits();
  const JointSpectralRadius radius = joint_spectral_radius(matrices, budget);
  options.end_progress();
  if (!options.certificate.empty()) {
    runtime::write_file(options.certificate, radius_certificate(matrices, radius).text);
    runtime::write_file(options.certificate + ".matrices", matrices_text(matrices));
  }
  const BlockProof* blocks = radius.by_blocks();
  if (options.json) {
    options.answer(Json{{"radius", enclosure_json(radius.radius)},
                        {"exact", radius.exact.is_yes()},
                        {"exactness", radius.exact.reason},
                        {"closed", radius.is_closed()},
                        {"product", radius.product.word},
                        {"method", method_text(radius)},
                        {"vertices", radius.vertices()},
                        {"blocks", blocks ? Json(blocks->triangular.sizes) : Json({matrices.size()})}});
  } else {
    std::ostringstream text;
    text << "matrices     " << matrices.count() << " of size " << matrices.size() << "\n"
         << (blocks ? "blocks       " + sizes_text(blocks->triangular.sizes) + "\n" : "") << "radius       "
         << enclosure_text(radius.radius, 14) << "  (" << sized_method_text(radius) << ")\n"
         << "product     ";
    for (int letter : radius.product.word) text << " " << letter;
    text << "  (radius " << enclosure_text(radius.product.radius, 14)
         << (radius.exact.is_yes() ? ", proved to attain the joint spectral radius)\n" : ")\n");
    options.answer(text.str());
  }
  return radius.is_closed() ? done : undecided;
}

}  // namespace

void add_jsr(Command& app) {
  auto options = std::make_shared<JsrOptions>();
  Command command = add_command(
      app, "jsr", "The joint spectral radius of rational matrices, enclosed with proof",
      "subcert jsr pair.json    with {\"matrices\": [[[\"1\",\"1\"],[\"0\",\"1\"]], [[\"1\",\"0\"],[\"1\",\"1\"]]]}",
      options, [=] { return run(*options); });
  command.option("FILE", options->file, "JSON file").required();
  add_limits(command, *options);
  command.option("--certificate", options->certificate,
                 "Write a certificate there, and the matrices beside it as FILE.matrices");
}

}  // namespace subcert::cli
