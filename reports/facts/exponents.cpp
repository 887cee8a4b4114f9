#include "exponents.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>

#include <fmt/ranges.h>

namespace subcert::facts {

Enclosure positive_part(const Enclosure& exponent) {
  Enclosure result;
  if (exponent.lower && *exponent.lower > 0) result.lower = exponent.lower;
  if (exponent.upper && *exponent.upper > 0) result.upper = exponent.upper;
  return result;
}

Json bound_json(const HolderBound& bound) {
  return {{"levels", bound.levels}, {"norm", to_text(bound.norm)}, {"holder", enclosure_json(bound.exponent)}};
}

Fact bound_fact(std::string label, const HolderBound& bound) {
  return {"bound", std::move(label),
          fmt::format(">= {} after {} levels; ||S_b^{}|| = {}", bound.exponent.lower_text(12), bound.levels,
                      bound.levels, to_decimal(bound.norm, 12, Rounding::nearest)),
          "", bound_json(bound)};
}

std::string method_text(const JointSpectralRadius& radius) { return to_text(radius.method()); }

std::string sized_method_text(const JointSpectralRadius& radius) {
  std::string text = method_text(radius);
  const auto counted = [&](std::size_t count, const char* one, const char* several) {
    return fmt::format("{} with {} {}", text, count, count == 1 ? one : several);
  };
  if (radius.method() == JsrMethod::invariant_polytope) text = counted(radius.vertices(), "vertex", "vertices");
  if (radius.method() == JsrMethod::quadratic_form) text = counted(radius.words(), "product", "products");
  return radius.is_closed() ? text : "lower end by the product, upper end by " + text;
}

std::string sizes_text(const std::vector<std::size_t>& sizes) { return fmt::format("{}", fmt::join(sizes, " + ")); }

Facts radius_facts(const JointSpectralRadius& radius, int digits) {
  Facts list{{"radius", "radius", enclosure_text(radius.radius, 15),
              "joint spectral radius, " + sized_method_text(radius), enclosure_json(radius.radius, digits)}};
  const BlockProof* blocks = radius.by_blocks();
  if (blocks)
    list.push_back({"blocks", "blocks", sizes_text(blocks->triangular.sizes), "", blocks->triangular.sizes});
  else
    list.push_back(member("blocks", nullptr));
  const std::string word = word_text(radius.product.word);
  list.push_back({"product", word.empty() ? "" : "product", word,
                  fmt::format("radius {}{}", enclosure_text(radius.product.radius, 15),
                              radius.exact.is_yes() ? ", proved to attain the joint spectral radius" : ""),
                  word});
  list.push_back(member("method", method_text(radius)));
  list.push_back(member("vertices", radius.vertices()));
  return list;
}

Facts exact_facts(const Decision& exact, bool closed) {
  return {member("exact", exact.is_yes()), member("exactness", exact.reason), member("closed", closed)};
}

namespace {

/// With the reasons why there is no upper end, and why it is exact although the shifts are not stable.
Fact sobolev(const Enclosure& exponent, const Decision& stable, const char* open, const char* unstable, Json json) {
  json["stable"] = stable.is_yes();
  return {"sobolev", "Sobolev", enclosure_text(exponent, 14),
          fmt::format("L2 smoothness, {}", !exponent.upper   ? fmt::format("a lower bound as the shifts are {}", open)
                                           : stable.is_yes() ? "exact as the shifts are stable"
                                                             : unstable),
          std::move(json)};
}

}  // namespace

Fact sobolev_fact(const std::optional<SobolevRegularity>& found, const Decision& stable) {
  if (!found) return member("sobolev", nullptr);
  return sobolev(
      found->exponent, stable, "not stable", "exact by the reduced mask",
      {{"exponent", enclosure_json(found->exponent)}, {"spectral_radius", enclosure_json(found->spectral_radius)}});
}

Fact sobolev_fact(const std::optional<Enclosure>& exponent, const Decision& stable, bool of_values) {
  if (!exponent) return member("sobolev", nullptr);
  return sobolev(*exponent, stable, "not proved stable",
                 of_values ? "exact, by the differences of phi" : "exact, by the inner products of the shifts",
                 {{"exponent", enclosure_json(*exponent)}});
}

}  // namespace subcert::facts
