#include "collections.hpp"

#include "computed_quantities.hpp"

#include <subcert/analysis/radii/joint/joint_spectral_radius.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/proofs-checks/certificates/matrices_file.hpp>

#include <fmt/format.h>

#include <map>

namespace subcert {
// Made by the build: the files of proofs-checks/papers/jsr/families.
extern const std::map<std::string, std::string_view> matrix_files;
}  // namespace subcert

namespace subcert::reports {
namespace {

constexpr double radius_seconds = 10;

struct Family {
  std::size_t count, size;  ///< as given
  MatrixFamily family;      ///< lifted, where a graph says what may follow what
  JointSpectralRadius radius;
};

Family computed_family(const std::string& name) {
  const auto text = matrix_files.find(name);
  require(text != matrix_files.end(), "jsr: need a file of matrices for '{}'", name);
  const MatricesFile file = parse_matrices(std::string(text->second), name + ".json");
  MatrixFamily family = file.graph.empty() ? file.family : lifted(file.family, file.graph).family;
  const Budget budget{Deadline::in(radius_seconds)};
  JointSpectralRadius radius = joint_spectral_radius(family, budget);
  sharpen(radius, family, default_bits, budget.deadline);
  return {file.family.count(), file.family.size(), std::move(family), std::move(radius)};
}

std::vector<std::string> row_of(const std::string& name, const Family& one) {
  const JointSpectralRadius& radius = one.radius;
  const Enclosure& ends = radius.radius;
  return {name,
          fmt::format("{} of size {}", one.count, one.size),
          formats::fixed_text(ends, 14),
          radius.exact.is_yes() ? "exact" : to_decimal(*ends.upper - *ends.lower, 2, Rounding::up),
          std::to_string(radius.product.word.size()),
          radius.vertices() > 0 ? std::to_string(radius.vertices()) : ""};
}

Enclosure binary_logarithm(const Enclosure& radius) {
  return {log_ratio(*radius.lower, 2).lower, log_ratio(*radius.upper, 2).upper};
}

}  // namespace

Report report_joint_spectral_radii(const ReportOptions& options) {
  const statements::PublishedTable& published = statements::paper("jsr").table("published");
  std::vector<std::string> names = schemes_of(published);
  if (options.wants("families"))
    for (const auto& [name, text] : matrix_files) names.push_back(name);
  std::map<std::string, std::optional<Family>> families;
  make_missing(families, names, options, computed_family);

  formats::Section section{"jsr", "Joint spectral radii of the literature", {}};
  section.paragraphs.push_back(
      "Exact means that the product is proved to attain the radius; otherwise the width of the enclosure is given. The "
      "matrices are those of the certificates, and of the folder proofs-checks/papers/jsr/families.");
  if (options.wants("published"))
    add_published(section, "jsr", published, [&](const statements::PublishedCell& cell) {
      const Enclosure& radius = families.at(cell.scheme)->radius.radius;
      return compare_number(cell, cell.quantity == "capacity" ? binary_logarithm(radius) : radius);
    });
  if (options.wants("families")) {
    formats::PlainTable table{"families",
                              "Families of the literature",
                              {"family", "matrices", "joint spectral radius", "width", "letters", "vertices"},
                              {}};
    for (const auto& [name, family] : families) {
      table.rows.push_back(row_of(name, *family));
      table.proofs.push_back(row_proof(name + ".cert", radius_certificate(family->family, family->radius),
                                       options.verified, matrices_text(family->family)));
    }
    section.tables.push_back(std::move(table));
  }
  return collection_report("jsr", std::move(section));
}

}  // namespace subcert::reports
