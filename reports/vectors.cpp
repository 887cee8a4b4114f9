#include "collections.hpp"

#include "computed_quantities.hpp"

#include <subcert/proofs-checks/certificates/scheme_regularity.hpp>

#include <fmt/format.h>

#include <array>

namespace subcert::reports {
namespace {

constexpr double seconds_of_vector = 30;  // what closes needs 8

/// Of which no published exponent is compared, or a Hoelder exponent is told beside it.
constexpr std::array named{"merrien:lambda=-1/8,mu=-1/2",
                           "merrien:lambda=-1/8,mu=1/2",
                           "merrien:lambda=-1/8,mu=-1",
                           "hermite-dd:points=2,order=2",
                           "hermite-dd:points=2,order=3",
                           "hermite-dd:points=4,order=2",
                           "hermite-dd:points=4,order=3",
                           "hermite-dd:points=6,order=2",
                           "bspline:degree=2,multiplicity=2",
                           "bspline:degree=3,multiplicity=2",
                           "bspline:degree=3,multiplicity=3",
                           "bspline:degree=5,multiplicity=3",
                           "ghm",
                           "cl:2",
                           "cl:3",
                           "sa4",
                           "bat:1",
                           "bat:2",
                           "bat:3",
                           "tensor:(ghm)x(ghm)",
                           "tensor:(hermite-dd:points=2,order=2)x(hermite-dd:points=2,order=2)"};

struct Facts {
  Scheme scheme;
  MultivariateRegularity regularity;
};

Facts facts_of(const std::string& specification, const ReportOptions& options) {
  Scheme scheme = make_refinable_scheme(specification);
  const Budget budget{Deadline::in(options.budget.value_or(seconds_of_vector))};
  MultivariateRegularity regularity = *regularity_of(scheme.mask, budget, of_scheme(scheme)).surface;
  return {std::move(scheme), std::move(regularity)};
}

/// Of the scheme itself.
std::string convergence_text(const MultivariateRegularity& found) {
  if (const auto& hermite = found.vector->hermite; hermite && hermite->order >= 0)
    return fmt::format("HC^{}", hermite->order);
  return to_text(found.converges.truth);
}

std::vector<std::string> row_of(const Facts& facts) {
  const MultivariateRegularity& found = facts.regularity;
  return {facts.scheme.specification,
          facts.scheme.title,
          std::to_string(facts.scheme.mask.components()),
          formats::fixed_text(found.exponent, 10),
          convergence_text(found),
          found.sobolev ? formats::fixed_text(*found.sobolev, 10) : "not computed",
          found.space ? std::to_string(found.space->basis.size() / (facts.scheme.quadratic ? 2 : 1)) : "",
          found.radius ? fmt::format("{}", fmt::join(found.radius->product.word, "")) : "",
          found.exact.is_yes() ? "exact"
          : found.is_closed()  ? "enclosed"
                               : "open"};
}

}  // namespace

Report report_vectors(const ReportOptions& options) {
  const statements::PublishedTable& published = statements::paper("vectors").table("published");
  std::map<std::string, std::optional<Facts>> facts;
  std::vector<std::string> specifications;
  if (options.wants("published")) specifications = schemes_of(published);
  if (options.wants("functions")) specifications.insert(specifications.end(), named.begin(), named.end());
  make_missing(facts, specifications, options, [&](const std::string& text) { return facts_of(text, options); });

  formats::Section section{"vectors", "Vectors of functions: Hermite schemes and multiwavelets", {}};
  section.paragraphs.push_back(
      "What sources that were read say of the smoothness of Hermite schemes and multiwavelets, and exact numbers "
      "beside "
      "it. Exponents are those of the worst function of the vector, from its values: neither sum rules nor stable "
      "shifts are needed. C^k holds where the exponent is above k, and fails where it is below.");
  if (options.wants("published"))
    add_published(section, "vectors", published, [&](const statements::PublishedCell& cell) {
      return compare_smoothness(cell, cell.scheme, facts.at(cell.scheme)->regularity);
    });
  if (options.wants("functions")) {
    formats::PlainTable table{"functions",
                              "Vectors of functions by name; no source was read for these numbers",
                              {"specification", "functions", "number", "exponent", "scheme converges",
                               "Sobolev exponent", "dimension", "leading product", "radius"},
                              {}};
    for (const char* name : named) table.rows.push_back(row_of(*facts.at(name)));
    section.tables.push_back(std::move(table));
  }
  return collection_report("vectors", std::move(section));
}

}  // namespace subcert::reports
