#include "exponent_text.hpp"

namespace subcert::cli {
namespace {

constexpr long most_coefficients = 120;

}  // namespace

std::optional<SobolevRegularity> sobolev_if_small(const Mask& mask, const Deadline& deadline) {
  if (mask.symbol().length() > most_coefficients) return std::nullopt;
  return sobolev_regularity(mask, deadline);
}

Json bound_json(const HolderBound& bound) {
  return {{"levels", bound.levels}, {"norm", to_text(bound.norm)}, {"holder", enclosure_json(bound.exponent)}};
}

Json sobolev_json(const std::optional<SobolevRegularity>& sobolev, const Decision& stable) {
  if (!sobolev) return nullptr;
  return {{"exponent", enclosure_json(sobolev->exponent)},
          {"spectral_radius", enclosure_json(sobolev->spectral_radius)},
          {"stable", stable.is_yes()}};
}

std::string sobolev_text(const SobolevRegularity& sobolev, const Decision& stable) {
  return enclosure_text(sobolev.exponent, 14) + (!sobolev.exponent.upper
                                                     ? "  (L2 smoothness, a lower bound as the shifts are not stable)"
                                                 : stable.is_yes() ? "  (L2 smoothness, exact as the shifts are stable)"
                                                                   : "  (L2 smoothness, exact by the reduced mask)");
}

std::string method_text(const JointSpectralRadius& radius) {
  switch (radius.method()) {
    case JsrMethod::invariant_polytope: return "invariant polytope";
    case JsrMethod::quadratic_form: return "quadratic form";
    case JsrMethod::single_spectral_radius: return "single spectral radius";
    default: return "norms of products";
  }
}

std::string sized_method_text(const JointSpectralRadius& radius) {
  const auto counted = [&](std::size_t count, const char* one, const char* several) {
    return fmt::format("{} with {} {}", method_text(radius), count, count == 1 ? one : several);
  };
  if (radius.method() == JsrMethod::invariant_polytope) return counted(radius.vertices(), "vertex", "vertices");
  if (radius.method() == JsrMethod::quadratic_form) return counted(radius.words(), "product", "products");
  return method_text(radius);
}

std::string word_text(const std::vector<int>& word) {
  std::string text;
  for (int letter : word) text += (letter > 9 && !text.empty() ? "," : "") + std::to_string(letter);
  return text;
}

}  // namespace subcert::cli
