#include "collections.hpp"

#include "surface_facts.hpp"

#include <subcert/proofs-checks/papers/registry.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert::reports {
namespace {

constexpr long most_searched = 100;  // coefficients: larger masks take longer than a page may
constexpr double fit_seconds = 120;  // seconds; the slowest of the others needs 15

/// The least squares scheme of a total degree on a grid, and the tensor product with the same data and positions.
struct GridScheme {
  int points, variables, degree;

  std::string specification() const {
    std::string data = std::to_string(points);
    for (int v = 1; v < variables; ++v) data += fmt::format("x{}", points);
    return fmt::format("grid:points={},d={}", data, degree);
  }
  std::string factor() const {
    return fmt::format("{}:n={},d={}", points % 2 ? "dual-odd" : "dual", points / 2, degree);
  }
  /// Degree 1: [MLZD15, sec. 3, App. B], with p variables there too, and [MH]; 2: [MH]; 3: [MB16, sec. 3].
  std::string papers() const {
    if (variables == 3) return degree == 1 ? "MLZD15" : "none";
    return degree == 1 ? "MLZD15, MH" : degree == 2 ? "MH" : "MB16";
  }
};

/// Each scheme once, where the data determine the polynomial.
std::vector<GridScheme> grid_schemes() {
  std::vector<GridScheme> list;
  for (int points = 2; points <= 6; ++points)
    for (int degree = 1; degree <= std::min(3, points - 1); ++degree) list.push_back({points, 2, degree});
  for (int degree = 1; degree <= 2; ++degree) list.push_back({3, 3, degree});
  return list;
}

std::string tensor_product(const std::string& factor, int variables) {
  std::string text = "tensor:";
  for (int v = 0; v < variables; ++v) text += (v ? "x(" : "(") + factor + ")";
  return text;
}

std::vector<std::string> primal_products() {
  std::vector<std::string> list;
  for (int degree : {1, 3})
    for (int n = (degree + 3) / 2; n <= 5; ++n)
      list.push_back(tensor_product(fmt::format("primal:n={},d={}", n, degree), 2));
  return list;
}

/// Yes: the first is proved to be rougher.
Truth is_rougher(const Enclosure& first, const Enclosure& second) {
  if (first.upper && second.lower && *first.upper < *second.lower) return Truth::yes;
  return first.lower && second.upper && *first.lower >= *second.upper ? Truth::no : Truth::unknown;
}

struct FitAndProduct {
  GridScheme scheme;
  SurfaceFacts fit, product;
};

std::vector<std::string> fit_findings(const std::vector<FitAndProduct>& pairs) {
  const auto count = [&](auto holds) { return std::ranges::count_if(pairs, holds); };
  std::vector<std::string> sentences;
  sentences.push_back(
      fmt::format("Of {} schemes on grids that are no tensor products, {} are proved to converge; the Hoelder exponent "
                  "is known exactly for {}, and proved to be below that of the tensor product for {}.",
                  pairs.size(), count([](const FitAndProduct& p) { return p.fit.regularity.converges.is_yes(); }),
                  count([](const FitAndProduct& p) {
                    return p.fit.regularity.exact.is_yes() && p.fit.regularity.exponent.is_bounded();
                  }),
                  count([](const FitAndProduct& p) {
                    return is_rougher(p.fit.regularity.exponent, p.product.regularity.exponent) == Truth::yes;
                  })));
  sentences.push_back(
      fmt::format("For {} of them the Sobolev exponent and that of the tensor product agree in all digits shown.",
                  count([](const FitAndProduct& p) { return p.fit.sobolev_text() == p.product.sobolev_text(); })));
  std::string unstable;
  for (const FitAndProduct& p : pairs)
    if (p.fit.regularity.stable.is_no()) unstable += (unstable.empty() ? "" : ", ") + p.fit.specification;
  if (!unstable.empty()) sentences.push_back("The integer shifts of the limits are not stable for " + unstable + ".");
  return sentences;
}

/// The exponent of each fit over that of its tensor product: what is proved of both, from below.
formats::Panel fits_beside_products(const std::vector<FitAndProduct>& pairs) {
  formats::Panel panel{"Hoelder exponents of fits and of tensor products", "tensor product", "fit", {}};
  formats::Curve fits{"a scheme", {}, true, false}, equal{"as smooth", {}};
  double most = 0;
  for (const FitAndProduct& pair : pairs) {
    const Enclosure &fit = pair.fit.regularity.exponent, &product = pair.product.regularity.exponent;
    if (!fit.lower || !product.lower) continue;
    fits.points.emplace_back(product.lower->convert_to<double>(), fit.lower->convert_to<double>());
    fits.values.push_back(fmt::format("{}: {}, tensor product {}", pair.fit.specification, pair.fit.holder_text(),
                                      pair.product.holder_text()));
    most = std::max({most, fits.points.back().first, fits.points.back().second});
  }
  equal.points = {{0, 0}, {most, most}};
  panel.curves = {fits, equal};
  return panel;
}

formats::Section fits_section(const ReportOptions& options) {
  std::vector<std::string> specifications;
  for (const GridScheme& scheme : grid_schemes()) {
    specifications.push_back(scheme.specification());
    specifications.push_back(tensor_product(scheme.factor(), scheme.variables));
  }
  const std::vector<SurfaceFacts> facts = surface_facts(specifications, options, fit_seconds, most_searched);
  std::vector<FitAndProduct> pairs;
  for (const GridScheme& scheme : grid_schemes())
    pairs.push_back({scheme, facts[2 * pairs.size()], facts[2 * pairs.size() + 1]});

  formats::Section section{"least-squares", "Least squares on grids: smoothness of the limits", {}};
  section.paragraphs.push_back(
      "Schemes that fit one polynomial of total degree d to a square or a cube of data, with the tensor product of the "
      "schemes of [DHHS15] that takes the same data and the same positions. The papers claim nothing about the "
      "smoothness of these limits, so that nothing printed is compared here.");
  for (const std::string& sentence : fit_findings(pairs)) section.paragraphs.push_back(sentence);
  section.paragraphs.push_back(
      "Masks of more than 100 coefficients are not searched for the product that attains their radius unless --budget "
      "gives the seconds; their Hoelder exponents are enclosed by the Sobolev exponents. '>=' says that no upper "
      "end is proved.");
  for (const char* key : {"MLZD15", "MH", "MB16", "DHHS15"})
    section.paragraphs.push_back(fmt::format("[{}] {}", key, statements::reference(key)));
  section.finding = fit_findings(pairs).front();
  section.figures.push_back(
      {"fits-plot",
       "Fits and tensor products",
       "Proved lower ends of the Hoelder exponents: below the line the tensor product is smoother.",
       1,
       {fits_beside_products(pairs)}});
  formats::PlainTable table{"least-squares", "Least squares on grids", surface_facts_head({"scheme", "papers"}), {}};
  table.head.insert(table.head.end(), {"tensor product of", "its Hoelder", "its Sobolev"});
  for (const FitAndProduct& pair : pairs) {
    table.row_classes.push_back(pair.fit.regularity.is_closed() ? "" : "open");
    table.rows.push_back(pair.fit.row({pair.fit.specification, pair.scheme.papers()}));
    table.rows.back().insert(table.rows.back().end(),
                             {pair.scheme.factor(), pair.product.holder_text(), pair.product.sobolev_text()});
  }
  section.tables.push_back(std::move(table));
  return section;
}

formats::Section products_section(const ReportOptions& options) {
  formats::Section section{"tensor-products", "Tensor products of the primal schemes", {}};
  section.paragraphs.push_back(
      "Tensor products of the primal schemes of [DHHS15], with which its figures smooth surfaces; the dual ones stand "
      "beside the fits above.");
  formats::PlainTable table{
      "tensor-products", "Tensor products of the primal schemes", surface_facts_head({"scheme"}), {}};
  for (const SurfaceFacts& one : surface_facts(primal_products(), options, fit_seconds))
    table.rows.push_back(one.row({one.specification}));
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace

Report report_least_squares_surfaces(const ReportOptions& options) {
  Report report{"surfaces", "Surfaces and volumes: the least squares schemes of the papers, smoothness proved", {}};
  if (options.wants("least-squares")) report.sections.push_back(fits_section(options));
  if (options.wants("tensor-products")) report.sections.push_back(products_section(options));
  report.listed = true;
  return report;
}

}  // namespace subcert::reports
