// subcert jsr FILE: the joint spectral radius of any finite set of rational matrices, or the subradius

#include <subcert/analysis/regularity/radius/joint_spectral_radius.hpp>
#include <subcert/analysis/regularity/radius/p_radius.hpp>
#include <subcert/analysis/regularity/subradius/joint_spectral_subradius.hpp>
#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/cli/checker.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/cli/parameter_range.hpp>
#include <subcert/cli/width.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/proofs-checks/certificates/matrices_file.hpp>
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

/// Ends as soon as each bound that was asked for is proved or refuted.
JointSpectralRadius radius_of(const MatrixFamily& family, const std::optional<Rational>& lower,
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

void add_verdicts(Json& json, const std::vector<Bound>& bounds) {
  for (const Bound& bound : bounds)
    json[bound.name] = {{"value", to_text(bound.value)}, {"verdict", verdict_text(bound.holds)}};
}

std::string verdicts_text(const std::vector<Bound>& bounds) {
  std::string text;
  for (const Bound& bound : bounds)
    text += fmt::format("{}{}: {}\n", padded(bound.name, 13), to_text(bound.value), verdict_text(bound.holds));
  return text;
}

/// Of bounds that were asked for, or else of the enclosure.
ExitCode code_of(const std::vector<Bound>& bounds, bool is_closed) {
  if (bounds.empty()) return is_closed ? done : undecided;
  const auto any = [&](Truth truth) {
    return std::ranges::any_of(bounds, [=](const Bound& b) { return b.holds == truth; });
  };
  return any(Truth::no) ? failed : any(Truth::unknown) ? undecided : done;
}

Json json_of(const JointSpectralRadius& radius, const std::vector<int>& word, const std::vector<Bound>& bounds,
             std::size_t size, int digits) {
  const BlockProof* blocks = radius.by_blocks();
  Json json{{"radius", enclosure_json(radius.radius, std::max(digits, 20))},
            {"exact", radius.exact.is_yes()},
            {"exactness", radius.exact.reason},
            {"closed", radius.is_closed()},
            {"product", word},
            {"method", method_text(radius)},
            {"vertices", radius.vertices()},
            {"blocks", blocks ? Json(blocks->triangular.sizes) : Json({size})}};
  add_verdicts(json, bounds);
  return json;
}

std::string text_of(const JointSpectralRadius& radius, const std::vector<int>& word, const std::vector<Bound>& bounds,
                    int digits) {
  const BlockProof* blocks = radius.by_blocks();
  std::string text;
  if (blocks) text += "blocks       " + sizes_text(blocks->triangular.sizes) + "\n";
  text += fmt::format("radius       {}  ({})\nproduct      {}  (radius {}{})\n",
                      enclosure_text(radius.radius, std::max(digits, 14)), sized_method_text(radius),
                      fmt::join(word, " "), enclosure_text(radius.product.radius, 14),
                      radius.exact.is_yes() ? ", proved to attain the joint spectral radius" : "");
  return text + verdicts_text(bounds);
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
  const Json json{{"p", options.power},
                  {"radius", enclosure_json(found->radius, std::max(wanted.digits, 20))},
                  {"size", found->size}};
  options.answer(json,
                 fmt::format("matrices     {} of size {}\np-radius     {}  (p = {}, by a matrix of size {})\n",
                             file.family.count(), file.family.size(),
                             enclosure_text(found->radius, std::max(wanted.digits, 14)), options.power, found->size));
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
  const std::vector<Bound> bounds = decided(found.radius, lower, upper);
  Json json{{"subradius", enclosure_json(found.radius, std::max(wanted.digits, 20))},
            {"exact", found.exact.is_yes()},
            {"exactness", found.exact.reason},
            {"closed", found.is_closed()},
            {"product", found.product.word},
            {"vertices", found.antinorm ? found.antinorm->vertices.size() : 0}};
  add_verdicts(json, bounds);
  certificate.add_to(json);
  options.answer(
      json, fmt::format("matrices     {} of size {}\nsubradius    {}  ({})\nproduct      {}{}\n{}{}", family.count(),
                        family.size(), enclosure_text(found.radius, std::max(wanted.digits, 14)), method_text(found),
                        fmt::join(found.product.word, " "),
                        found.exact.is_yes() ? "  (proved to attain the joint spectral subradius)" : "",
                        verdicts_text(bounds), certificate.text(found.exact.is_yes())));
  certificate.failure.raise();
  return code_of(bounds, found.is_closed() && wanted.holds(found.radius));
}

ExitCode run(const JsrOptions& options) {
  require_place(options.certificate);
  const MatricesFile file = parse_matrices(read_file(options.file), options.file);
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
  const std::vector<Bound> bounds = decided(radius.radius, lower, upper);
  std::string head = fmt::format("matrices     {} of size {}\n", file.family.count(), file.family.size());
  if (lift)
    head += fmt::format("graph        {} successions, {} matrices of size {}\n", file.graph.size(), family.count(),
                        family.size());
  Json json = json_of(radius, word, bounds, family.size(), wanted.digits);
  certificate.add_to(json);
  options.answer(json, head + text_of(radius, word, bounds, wanted.digits) + certificate.text(radius.exact.is_yes()));
  certificate.failure.raise();
  return code_of(bounds, radius.is_closed() && wanted.holds(radius.radius));
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
}

}  // namespace subcert::cli
