#include "exponents.hpp"

#include <fmt/ranges.h>

#include <algorithm>

namespace subcert::facts {

Json bound_json(const HolderBound& bound) {
  return {{"levels", bound.levels}, {"norm", to_text(bound.norm)}, {"holder", enclosure_json(bound.exponent)}};
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

Fact sobolev_fact(const Enclosure& exponent, const Decision& stable, const SobolevReasons& otherwise, Json json) {
  return {"sobolev", "Sobolev", enclosure_text(exponent, 14),
          "L2 smoothness, " + (!exponent.upper   ? "a lower bound as the shifts are " + otherwise.no_upper_end
                               : stable.is_yes() ? "exact as the shifts are stable"
                                                 : "exact" + otherwise.unstable),
          std::move(json)};
}

}  // namespace subcert::facts
