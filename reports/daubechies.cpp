#include "collections.hpp"

#include "computed_quantities.hpp"

#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/format.h>

namespace subcert::reports {
namespace {

constexpr int first_order = 2, last_order = 25;  // D4 to D50
constexpr double seconds = 6;                    // for each: D44 is left open in any time that was tried

std::string specification(int n) { return fmt::format("daubechies:n={}", n); }

}  // namespace

Report report_daubechies(const ReportOptions& options) {
  const statements::PublishedTable& published = statements::paper("daubechies").table("published");
  std::vector<std::string> schemes = schemes_of(published);
  if (options.wants("exponents"))
    for (int n = last_order; n >= first_order; --n) schemes.push_back(specification(n));  // the long ones first
  ComputedQuantities computed(options);
  computed.need_exponents(schemes, seconds);

  formats::Section section{"daubechies", "Exponents of Daubechies' orthonormal scaling functions", {}};
  section.paragraphs.push_back(
      "D(2n) has n sum rules and 2n coefficients, which are not rational for n > 1. What is proved holds for all masks "
      "with n sum rules in a small neighbourhood of rounded coefficients, in which the mask that is meant lies: that "
      "a product of its matrices attains the joint spectral radius, too. The exponent is n less the logarithm to the "
      "base 2 of the spectral radius of that product, to the power 1 over its length.");
  if (options.wants("published"))
    add_published(section, "daubechies", published, [&](const statements::PublishedCell& cell) {
      return compare_number(cell, computed.exponent(cell.scheme).exponent);
    });
  if (options.wants("exponents")) {
    formats::PlainTable table{"exponents",
                              "Hoelder exponents of D4 to D50",
                              {"function", "exponent", "width", "leading product", "attained", "vertices", "distance"},
                              {}};
    for (int n = first_order; n <= last_order; ++n) {
      const Scheme scheme = make_scheme(specification(n));
      const HolderRegularity& regularity = computed.exponent(scheme.specification);
      const Enclosure& exponent = regularity.exponent;
      table.proofs.push_back(row_proof(fmt::format("D{}.cert", 2 * n),
                                       exponent_certificate(scheme.mask.curve(), regularity, scheme.rounding),
                                       options.verified));
      table.proofs.back().scheme = scheme.specification;
      table.row_ids.push_back(fmt::format("daubechies-exponents-D{}", 2 * n));
      table.rows.push_back({fmt::format("D{}", 2 * n), formats::fixed_text(exponent, 12),
                            exponent.is_bounded() ? to_decimal(*exponent.upper - *exponent.lower, 2, Rounding::up) : "",
                            fmt::format("{}", fmt::join(regularity.radius.product.word, "")),
                            to_text(regularity.radius.exact.truth), std::to_string(regularity.radius.vertices()),
                            to_decimal(scheme.rounding->distance, 2, Rounding::up)});
    }
    section.tables.push_back(std::move(table));
  }
  return collection_report("daubechies", std::move(section));
}

}  // namespace subcert::reports
