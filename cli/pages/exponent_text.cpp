#include "exponent_text.hpp"

#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/analysis/symbol/error.hpp>

#include <algorithm>

namespace subcert::cli {
namespace {

constexpr long most_places = 1000;

}  // namespace

void add_width(Command& command, SearchOptions& options) {
  command
      .option("--width", options.width,
              "At most so wide, 1e-1000 to 1, where a product is proved to attain the radius; wider is undecided")
      .exact_number();
}

WantedWidth wanted_width(const SearchOptions& options) {
  if (options.width.empty()) return {};
  const auto width = parse_number(options.width);
  const Rational least = power(Rational(10), -most_places);
  if (!width || *width < least || *width > 1)
    fail(ErrorKind::usage, "--width: expected a number from 1e-{} to 1, got '{}'", most_places, options.width);
  return {width, bits_for_width(*width), decimal_places(*width) + 2};
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

}  // namespace subcert::cli
