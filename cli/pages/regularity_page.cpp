#include "regularity_page.hpp"

#include <sstream>

namespace subcert::cli {
namespace {

/// The first digits of what the exponent exceeds this derivative by, never rounded up.
std::string leading_digits(const Enclosure& exponent, int derivative) {
  const Rational low = *exponent.lower - derivative;
  if (exponent.is_exact()) return to_text(low);
  const Rational high = exponent.upper ? Rational(*exponent.upper - derivative) : low;
  const int digits = Enclosure{low, high}.telling_digits(6);
  std::string text = to_decimal(low, digits, Rounding::down);
  return text == to_decimal(high, digits, Rounding::down) ? text + "..." : text;
}

/// Whether the exponent is attained: the modulus of continuity of the derivative that decides.
std::string attained_text(const HolderRegularity& regularity) {
  const LogarithmicFactor& factor = regularity.logarithm;
  if (!factor.derivative) return "unknown: " + factor.reason;
  const auto modulus = [&](int power) {
    const std::string exponent = leading_digits(regularity.exponent, *factor.derivative);
    return "h" + (exponent == "1" ? "" : "^" + exponent) +
           (power == 0   ? ""
            : power == 1 ? " |log h|"
                         : " |log h|^" + std::to_string(power));
  };
  const std::string subject = *factor.derivative == 0
                                  ? "the limits"
                                  : "the derivatives of order " + std::to_string(*factor.derivative);
  if (!factor.at_most)
    return factor.at_least == 0
               ? "unknown: " + factor.reason
               : "no: " + subject + " have no smaller modulus of continuity than " + modulus(factor.at_least);
  const std::string has = subject + " have the modulus of continuity " + modulus(*factor.at_most);
  if (*factor.at_most == 0) return "yes: " + has;
  if (factor.at_least == 0) return "unknown: " + has + " or a smaller one";
  return "no: " + has + (factor.at_least == *factor.at_most ? ", and no smaller one" : " or a smaller one");
}

std::string rounding_text(const MaskRounding& rounding) {
  return "coefficients, by " + to_decimal(rounding.distance, 2, Rounding::up) +
         " at most; what follows holds for all such masks";
}

}  // namespace

Json RegularityPage::json() const {
  const HolderBounds& bounds = regularity.bounds;
  const JointSpectralRadius& radius = regularity.radius;
  Json by_level = Json::array();
  for (const HolderBound& bound : bounds.levels) by_level.push_back(bound.exponent.lower_text(12));
  const LogarithmicFactor& logarithm = regularity.logarithm;
  return {{"scheme", scheme.specification},
          {"rounded", scheme.rounding ? Json(to_text(scheme.rounding->distance)) : Json()},
          {"sum_rules", bounds.sum_rules},
          {"bound", bound_json(bounds.last())},
          {"bounds_by_level", by_level},
          {"converges", to_text(regularity.converges.truth)},
          {"radius", enclosure_json(radius.radius, std::max(digits, 20))},
          {"holder", enclosure_json(holder, std::max(digits, 20))},
          {"exact", radius.exact.is_yes()},
          {"exactness", radius.exact.reason},
          {"closed", radius.is_closed()},
          {"method", method_text(radius)},
          {"product", word_text(radius.product.word)},
          {"vertices", radius.vertices()},
          {"blocks", radius.by_blocks() ? Json(radius.by_blocks()->triangular.sizes) : Json()},
          {"stable", regularity.stable.is_yes()},
          {"stability", regularity.stable.reason},
          {"logarithm",
           {{"at_least", logarithm.at_least},
            {"at_most", optional_json(logarithm.at_most)},
            {"derivative", optional_json(logarithm.derivative)},
            {"reason", logarithm.reason}}},
          {"single", decision_json(regularity.single.applies)},
          {"reduced", reduced_json()},
          {"sobolev", sobolev_json(sobolev, regularity.stable)},
          {"seconds", seconds}};
}

Json RegularityPage::reduced_json() const {
  if (!regularity.reduced) return nullptr;
  const auto& [mask, its] = *regularity.reduced;
  return {{"factor", mask.factor.to_text()},
          {"mask", mask.mask.symbol().to_mask_text()},
          {"radius", enclosure_json(its.radius.radius)},
          {"product", word_text(its.radius.product.word)},
          {"exact", its.radius.exact.is_yes()}};
}

std::string RegularityPage::reduced_text() const {
  if (!regularity.reduced) return "";
  const auto& [mask, its] = *regularity.reduced;
  return fmt::format("reduced      {}: b(z) p(z^{}) = a(z) p(z), p = {}; the same smoothness, {} with {}\n",
                     mask.mask.symbol().to_mask_text(), mask.mask.arity(), mask.factor.to_text(),
                     its.converges.is_yes() ? "exponent " + enclosure_text(its.exponent, 14) : "no exponent",
                     sized_method_text(its.radius));
}

std::string RegularityPage::exponent_text() const {
  if (!holder.lower && !holder.upper)
    return regularity.converges.is_no() ? "none, as the scheme does not converge"
                                        : "unknown, as convergence is not proved";
  const std::string text = enclosure_text(holder, std::max(digits, 14));
  if (!holder.upper) return text + "  (a proved lower bound)";
  const int most = holder.telling_digits(std::max(digits, 17));
  return text + "  (enclosed with proof" +
         (regularity.deciding().radius.is_closed() ? ", " + holder.lower_text(most) + " ... " + holder.upper_text(most)
                                                   : "") +
         ")";
}

std::string RegularityPage::text() const {
  const HolderBounds& bounds = regularity.bounds;
  const JointSpectralRadius& radius = regularity.radius;
  const HolderBound& last = bounds.last();
  std::ostringstream page;
  page << "scheme       " << scheme.specification << "  (" << scheme.title << ")\n"
       << (scheme.rounding ? "rounded      " + rounding_text(*scheme.rounding) + "\n" : "")  //
       << "sum rules    " << bounds.sum_rules << "\n"
       << "converges    " << subcert::to_text(regularity.converges.truth) << ": " << regularity.converges.reason << "\n"
       << "bound        >= " << last.exponent.lower_text(12) << " after " << last.levels << " levels; ||S_b^"
       << last.levels << "|| = " << to_decimal(last.norm, 12, Rounding::nearest) << "\n"
       << "radius       " << enclosure_text(radius.radius, 15) << "  (joint spectral radius, "
       << sized_method_text(radius) << ")\n";
  if (const BlockProof* blocks = radius.by_blocks())
    page << "blocks       " << sizes_text(blocks->triangular.sizes) << "\n";
  if (!radius.product.word.empty())
    page << "product      " << word_text(radius.product.word) << "  (radius "
         << enclosure_text(radius.product.radius, 15)
         << (radius.exact.is_yes() ? ", proved to attain the joint spectral radius)\n" : ")\n");
  page << "stable       " << subcert::to_text(regularity.stable.truth)
       << (regularity.converges.is_yes() ? ": " : ", the shifts of the refinable distribution: ")
       << regularity.stable.reason << "\n"
       << reduced_text() << "exponent     " << exponent_text() << "\n";
  if (holder.lower && *regularity.exponent.lower > 0) page << "attained     " << attained_text(regularity) << "\n";
  if (sobolev) page << "Sobolev      " << sobolev_text(*sobolev, regularity.stable) << "\n";
  if (!complete) page << "budget       the polytope did not close; the enclosure reached is printed\n";
  return page.str();
}

}  // namespace subcert::cli
