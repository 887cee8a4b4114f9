#include "certificate_text.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace subcert {
namespace {

using namespace certificate_text;

constexpr int levels_of_bounds = 8;  // of the norms beside the radius

std::string order_text(const MaskList& list) {
  if (!list.period.empty()) return fmt::format("period={}", fmt::join(list.period, ","));
  if (list.follows.empty()) return "any";
  std::vector<std::string> pairs;
  for (const auto& [before, after] : list.follows) pairs.push_back(fmt::format("{}-{}", before, after));
  return fmt::format("follows={}", fmt::join(pairs, ","));
}

/// The lower end by the radius of a family for differences of this order; nothing where it is not positive.
std::optional<Certificate> of_all(ClaimSubject subject, int order, int arity, const MatrixFamily& family,
                                  const JointSpectralRadius& radius, bool transposed = false) {
  const Rational lower = order - *log_ratio(upper_end(radius, {}), arity).upper;
  if (lower <= 0) return std::nullopt;
  const ClaimedEnds ends{outward(lower, Rounding::down), {}};
  Certificate certificate{{ends, std::move(subject)}, {}, ends};
  certificate.sections.push_back(
      {fmt::format("sum-rules {}{}\n{}", order, transposed ? " transposed" : "", blocks_text(radius))});
  add_sections(certificate, radius.proof, family.count());
  return certificate;
}

Certificate of_sequence(const MaskList& list, const std::vector<std::size_t>& sequence, const Budget& budget) {
  std::vector<Mask> levels;
  for (const std::size_t number : sequence) levels.push_back(list.masks.at(number));
  const Mask one = levels_as_one(levels);
  Certificate certificate = exponent_certificate(
      one, holder_regularity(one, levels_of_bounds, budget, HolderProof::certificate));
  certificate.claim.subject = list_subject({list.masks, sequence});
  return certificate;
}

}  // namespace

ListSubject list_subject(const MaskList& list) {
  std::vector<std::string> masks;
  for (const Mask& mask : list.masks) masks.push_back(mask.symbol().to_mask_text());
  return {fmt::format("{}", fmt::join(masks, ";")), std::to_string(list.masks.front().arity()), order_text(list)};
}

std::optional<Certificate> each_point_certificate(const ParametricMask& mask, char letter, const Box& box,
                                                  const LocalLevels& found) {
  MaskSubject subject{mask.to_text(letter), std::to_string(mask.arity()),
                      fmt::format("{}={}..{}", letter, to_text(box.low[0]), to_text(box.high[0]))};
  subject.is_each_point = true;
  return of_all(subject, found.order, static_cast<int>(mask.arity()), found.family, found.radius, found.transposed);
}

std::vector<Certificate> list_certificates(const MaskList& list, const ExponentOfList& found, const Budget& budget) {
  std::vector<Certificate> result;
  auto all = of_all(list_subject(found.list), found.sum_rules, list.masks.front().arity(), found.family, found.radius);
  if (!all) return result;
  if (list.period.empty()) result.push_back(std::move(*all));
  if (found.exponent.upper || !list.period.empty()) result.push_back(of_sequence(list, found.sequence, budget));
  return result;
}

}  // namespace subcert
