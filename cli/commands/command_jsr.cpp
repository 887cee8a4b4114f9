// subcert jsr FILE: the joint spectral radius of any finite set of rational matrices, or the subradius

#include <subcert/analysis/radii/joint/joint_spectral_radius.hpp>
#include <subcert/analysis/radii/joint/p_radius.hpp>
#include <subcert/analysis/radii/subradius/joint_spectral_subradius.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/checker.hpp>
#include <subcert/cli/paper_form.hpp>
#include <subcert/cli/parameter_range.hpp>
#include <subcert/cli/width.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/proofs-checks/certificates/matrices_file.hpp>
#include <subcert/reports/facts/exponent_formula.hpp>
#include <subcert/reports/facts/exponents.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace subcert::cli {
namespace {

struct JsrOptions : SearchOptions {
  std::string file;
  std::string certificate;
  std::string lower, upper;
  int power = 0;       ///< of the averaged growth; 0 for the joint spectral radius
  bool least = false;  ///< the joint spectral subradius is meant
  PaperForm form;
};

std::optional<Rational> read_bound(const std::string& name, const std::string& text) {
  if (text.empty()) return std::nullopt;
  auto value = parse_number(text);
  if (!value || *value < 0) fail(ErrorKind::usage, "{}: expected a number that is not negative, got '{}'", name, text);
  return value;
}

/// A bound that was asked for, and whether it is proved (yes) or refuted (no).
struct Bound {
  std::string name;
  Rational value;
  Truth holds;
};

/// What the enclosure says of both bounds.
std::vector<Bound> decided(const Enclosure& radius, const std::optional<Rational>& lower,
                           const std::optional<Rational>& upper) {
  const auto truth = [](bool proved, bool refuted) {
    return proved ? Truth::yes : refuted ? Truth::no : Truth::unknown;
  };
  std::vector<Bound> result;
  if (lower) result.push_back({"lower", *lower, truth(*radius.lower >= *lower, *radius.upper < *lower)});
  if (upper) result.push_back({"upper", *upper, truth(*radius.upper <= *upper, *radius.lower > *upper)});
  return result;
}

/// Ends as soon as each bound that was asked for is proved or refuted: first a product above the lower one is looked
/// for, and then the radius.
JointSpectralRadius searched(const MatrixFamily& family, const std::optional<Rational>& lower,
                             const std::optional<Rational>& upper, const Budget& budget) {
  std::optional<ProductEvidence> product;
  if (lower) {
    product = find_product_above(family, *lower, {budget.deadline.after(upper ? 0.3 : 0.5), budget.memory});
    if (product->exact) product->radius = Enclosure::exactly(*product->exact);
    if (!upper && *product->radius.lower >= *lower) {
      const NormProof norms = norm_of_products(family, {budget.deadline.at_most(0.1), budget.memory});
      return {{product->radius.lower, norms.bound()},
              *product,
              {Truth::unknown, "a bound was asked for, and nothing else"},
              {},
              norms};
    }
  }
  // Just below, so that the lower bound is refuted.
  const auto target = upper || !lower ? upper : std::optional(Rational(*lower * (1 - power(Rational(2), -40))));
  JointSpectralRadius result = joint_spectral_radius(family, budget, std::nullopt, target);
  if (product && *product->radius.lower > *result.radius.lower) {
    result.radius.lower = product->radius.lower;
    if (!result.by_blocks()) result.product = std::move(*product);
  }
  return result;
}

/// A lower bound that is false has no product, and most are told by the radius soon: so there is a short search before
/// the long one.
JointSpectralRadius radius_of(const MatrixFamily& family, const std::optional<Rational>& lower,
                              const std::optional<Rational>& upper, const Budget& budget) {
  constexpr double first_share = 0.02;
  if (lower) {
    JointSpectralRadius quick = searched(family, lower, upper, {budget.deadline.after(first_share), budget.memory});
    if (std::ranges::none_of(decided(quick.radius, lower, upper),
                             [](const Bound& bound) { return bound.holds == Truth::unknown; }))
      return quick;
  }
  return searched(family, lower, upper, budget);
}

/// The end of both kinds of answers.
Facts verdict_facts(const std::vector<Bound>& bounds) {
  Facts list;
  for (const Bound& bound : bounds)
    list.push_back({bound.name,
                    bound.name,
                    to_text(bound.value) + ": " + verdict_text(bound.holds),
                    "",
                    {{"value", to_text(bound.value)}, {"verdict", verdict_text(bound.holds)}}});
  return list;
}

Fact matrices_fact(const MatrixFamily& family) {
  return {"", "matrices", fmt::format("{} of size {}", family.count(), family.size())};
}

/// Of the caller's letters.
Fact product_fact(const std::vector<int>& word, std::string remark) {
  return {"product", "product", fmt::format("{}", fmt::join(word, " ")), std::move(remark), word};
}

Fact radius_fact(const char* name, const char* label, const Enclosure& radius, std::string remark,
                 const WantedWidth& wanted) {
  return {name, label, enclosure_text(radius, std::max(wanted.digits, 14)), std::move(remark),
          enclosure_json(radius, std::max(wanted.digits, 20))};
}

/// Of bounds that were asked for, or else of the enclosure.
ExitCode code_of(const std::vector<Bound>& bounds, bool is_closed) {
  if (bounds.empty()) return is_closed ? done : undecided;
  const auto any = [&](Truth truth) {
    return std::ranges::any_of(bounds, [=](const Bound& b) { return b.holds == truth; });
  };
  return any(Truth::no) ? failed : any(Truth::unknown) ? undecided : done;
}

Facts radius_facts_of(const JointSpectralRadius& radius, const std::vector<int>& word, std::size_t size,
                      const WantedWidth& wanted) {
  const BlockProof* blocks = radius.by_blocks();
  Facts list{
      blocks ? Fact{"blocks", "blocks", sizes_text(blocks->triangular.sizes), "", blocks->triangular.sizes}
             : member("blocks", Json::array({size})),
      radius_fact("radius", "radius", radius.radius, sized_method_text(radius), wanted),
      product_fact(word, fmt::format("radius {}{}", enclosure_text(radius.product.radius, 14),
                                     radius.exact.is_yes() ? ", proved to attain the joint spectral radius" : "")),
      member("method", method_text(radius)), member("vertices", radius.vertices())};
  append(list, exact_facts(radius.exact, radius.is_closed()));
  return list;
}

ExitCode print(Facts list, const std::vector<Bound>& bounds, const WrittenCertificate& certificate, bool attained,
               bool closed, const JsrOptions& options) {
  append(list, verdict_facts(bounds));
  Json json = page_json(list);
  certificate.add_to(json);
  answer(options, options.form, {list, 13, json, certificate.text(attained)});
  certificate.failure.raise();
  return code_of(bounds, closed);
}

ExitCode run_averaged(const JsrOptions& options, const MatricesFile& file, const WantedWidth& wanted) {
  if (!file.graph.empty()) fail(ErrorKind::usage, "--p: expected matrices without a graph, got \"edges\"");
  if (!options.lower.empty() || !options.upper.empty() || !options.certificate.empty())
    fail(ErrorKind::usage, "--p: expected none of --lower, --upper and --certificate beside it");
  if (!has_p_radius(file.family, options.power))
    fail(ErrorKind::usage, "--p: expected an even number where entries are negative, got {}", options.power);
  const auto found = p_radius(file.family, options.power, wanted.bits, options.limits().deadline);
  if (!found)
    fail(ErrorKind::undecided, "--budget: the p-radius takes more than {} seconds of processor time", options.budget);
  const Facts list{matrices_fact(file.family), member("p", options.power),
                   radius_fact("radius", "p-radius", found->radius,
                               fmt::format("p = {}, by a matrix of size {}", options.power, found->size), wanted),
                   member("size", found->size)};
  answer(options, options.form, {list, 13, page_json(list)});
  return wanted.holds(found->radius) ? done : undecided;
}

/// Of the subradius.
std::string method_text(const JointSpectralSubradius& found) {
  const std::size_t vertices = found.antinorm ? found.antinorm->vertices.size() : 0;
  if (vertices == 0) return "by the product";
  const std::string polytope = fmt::format("polytope with {} {}", vertices, vertices == 1 ? "vertex" : "vertices");
  return found.is_closed() ? polytope : "upper end by the product, lower end by a " + polytope;
}

ExitCode run_least(const JsrOptions& options, const MatricesFile& file, const WantedWidth& wanted) {
  if (!file.graph.empty()) fail(ErrorKind::usage, "--subradius: expected matrices without a graph, got \"edges\"");
  if (options.power > 0) fail(ErrorKind::usage, "--subradius: expected no --p beside it");
  const MatrixFamily& family = file.family;
  if (!is_nonnegative(family)) fail(ErrorKind::usage, "--subradius: expected matrices without negative entries");
  const auto lower = read_bound("--lower", options.lower), upper = read_bound("--upper", options.upper);
  options.progress("products and polytopes");
  const JointSpectralSubradius found = joint_spectral_subradius(family, options.limits(), {lower, upper, wanted.bits});
  options.end_progress();
  const WrittenCertificate certificate = write_certificate(
      options.certificate, [&] { return subradius_certificate(family, found); }, matrices_text(family));
  Facts list{
      matrices_fact(family), radius_fact("subradius", "subradius", found.radius, method_text(found), wanted),
      product_fact(found.product.word, found.exact.is_yes() ? "proved to attain the joint spectral subradius" : "")};
  append(list, exact_facts(found.exact, found.is_closed()));
  list.push_back(member("vertices", found.antinorm ? found.antinorm->vertices.size() : 0));
  return print(std::move(list), decided(found.radius, lower, upper), certificate, found.exact.is_yes(),
               found.is_closed() && wanted.holds(found.radius), options);
}

ExitCode run(const JsrOptions& options) {
  require_one_form(options, options.form);
  require_place(options.certificate);
  const MatricesFile file = parse_matrices(read_input(options.file), input_name(options.file));
  const WantedWidth wanted = wanted_width(options);
  if (options.least) return run_least(options, file, wanted);
  if (options.power > 0) return run_averaged(options, file, wanted);
  const auto lower = read_bound("--lower", options.lower), upper = read_bound("--upper", options.upper);
  std::optional<LiftedFamily> lift;
  if (!file.graph.empty()) lift = lifted(file.family, file.graph);
  const MatrixFamily& family = lift ? lift->family : file.family;
  options.progress("products and polytopes");
  const Budget budget = options.limits();
  JointSpectralRadius radius = radius_of(family, lower, upper, budget);
  sharpen(radius, family, wanted.bits, budget.deadline);
  options.end_progress();
  const WrittenCertificate certificate = write_certificate(
      options.certificate, [&] { return radius_certificate(family, radius); }, matrices_text(family));
  std::vector<int> word = radius.product.word;
  if (lift)
    for (int& letter : word) letter = lift->letters[static_cast<std::size_t>(letter)];
  Facts list{matrices_fact(file.family)};
  if (lift)
    list.push_back(
        {"", "graph",
         fmt::format("{} successions, {} matrices of size {}", file.graph.size(), family.count(), family.size())});
  append(list, radius_facts_of(radius, word, family.size(), wanted));
  append(list, radius_formula_facts(family, radius));
  return print(std::move(list), decided(radius.radius, lower, upper), certificate, radius.exact.is_yes(),
               radius.is_closed() && wanted.holds(radius.radius), options);
}

}  // namespace

void add_jsr(Command& app) {
  auto options = std::make_shared<JsrOptions>();
  Command command = add_command(
      app, "jsr", "The joint spectral radius of rational matrices, enclosed with proof",
      "subcert jsr pair.json    with {\"matrices\": [[[\"1\",\"1\"],[\"0\",\"1\"]], [[\"1\",\"0\"],[\"1\",\"1\"]]]}",
      options, [=] { return run(*options); });
  command
      .option(
          "FILE", options->file,
          "JSON, {\"matrices\": [...]}, where numbers are integers, decimals or \"p/q\", with \"edges\": [[from, to, "
          "matrix], ...] if a graph says what may follow what; or lines 'matrices COUNT SIZE' and 'row ...'")
      .required();
  command.option("--lower", options->lower, "Ends as soon as the radius is proved to be at least that, or not to be")
      .exact_number();
  command.option("--upper", options->upper, "The same for at most").exact_number();
  command
      .option("--p", options->power,
              "The p-radius instead: how averages of p-th powers of norms grow; p even, or no entry negative")
      .within(1, 64);
  command.flag("--subradius", options->least,
               "The joint spectral subradius instead, also called lower spectral radius: how slowly products can grow; "
               "no entry negative");
  add_limits(command, *options);
  add_width(command, *options);
  command.option("--certificate", options->certificate,
                 "Write a certificate there, and the matrices beside it as FILE.matrices");
  add_fact_forms(command, options->form);
}

}  // namespace subcert::cli
