#include "certificate_text.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace subcert {
namespace {

using namespace certificate_text;

constexpr int levels_of_bounds = 8;  // of the norms beside the radius
constexpr double most_classes = 64;  // of levels as one mask, of which checkers tell whether shifts are stable

std::string order_text(const MaskList& list) {
  if (!list.period.empty()) return fmt::format("period={}", fmt::join(list.period, ","));
  if (list.follows.empty()) return "any";
  std::vector<std::string> pairs;
  for (const auto& [before, after] : list.follows) pairs.push_back(fmt::format("{}-{}", before, after));
  return fmt::format("follows={}", fmt::join(pairs, ","));
}

/// The lower end by the radius of a family for differences of this order; nothing where it is not positive. `upper`:
/// that of one sequence whose shifts checkers show to be stable, by the product of the radius.
std::optional<Certificate> of_all(ClaimSubject subject, int order, int arity, const MatrixFamily& family,
                                  const JointSpectralRadius& radius, bool transposed = false,
                                  const std::optional<std::string>& upper = {}) {
  const Rational lower = order - *log_ratio(upper_end(radius, {}), arity).upper;
  if (lower <= 0) return std::nullopt;
  const ClaimedEnds ends{outward(lower, Rounding::down), upper};
  Certificate certificate{{ends, std::move(subject)}, {}, ends};
  certificate.sections.push_back(
      {fmt::format("sum-rules {}{}\n{}{}{}", order, transposed ? " transposed" : "", upper ? "stability\n" : "",
                   blocks_text(radius), upper ? product_text(family, radius) : "")});
  add_sections(certificate, radius.proof, family.count());
  return certificate;
}

Mask in_one(const MaskList& list, const std::vector<std::size_t>& sequence) {
  std::vector<LatticeMask> levels;
  for (const std::size_t number : sequence) levels.push_back(list.masks.at(number));
  return levels_as_one(levels).curve();
}

/// Of masks of numbers in any order or along a graph: the upper end, where the product of the radius shows it as it
/// stands, and checkers can tell that the shifts of its sequence are stable.
std::optional<std::string> upper_end_of(const MaskList& list, const ExponentOfList& found) {
  double classes = 1;
  for (std::size_t k = 0; k < found.sequence.size(); ++k) classes *= list.masks.front().arity();
  if (!found.exponent.upper || classes > most_classes) return std::nullopt;
  const Mask one = in_one(list, found.sequence);
  if (common_factor_of_cosets(one).length() != 1) return std::nullopt;
  return upper_end_by(found.radius.product, found.sum_rules, list.masks.front().arity());
}

Certificate of_sequence(const MaskList& list, const std::vector<std::size_t>& sequence, const Budget& budget) {
  const Mask one = in_one(list, sequence);
  Certificate certificate = exponent_certificate(
      one, holder_regularity(one, levels_of_bounds, budget, HolderProof::certificate));
  certificate.claim.subject = list_subject({list.masks, sequence});
  return certificate;
}

/// Of masks of matrices, what is claimed of all sequences: the exponent, or with `hermite` HC^k; nothing where nothing
/// positive is proved.
ClaimedEnds ends_of_all(const MaskList& list, int order, const Rational& radius, bool hermite) {
  ClaimedEnds ends;
  const int arity = list.masks.front().arity();
  if (hermite) {
    const auto k = proved_derivatives(radius, arity, order, static_cast<long>(list.masks.front().components()) - 1);
    if (k) ends.lower = std::to_string(*k);
    return ends;
  }
  Rational lower = order;
  if (radius > 0) lower = std::min(lower, Rational(order - *log_ratio(radius, arity).upper));
  if (lower > 0) ends.lower = outward(lower, Rounding::down);
  return ends;
}

/// Of masks of matrices: for all sequences, the exponent, and of a Hermite list HC^k.
std::vector<Certificate> of_all_vectors(const MaskList& list, const ExponentOfList& found, const Budget& budget) {
  std::vector<Certificate> result;
  const bool in_period = !list.period.empty();
  const MaskList along = in_period ? in_turn(list) : found.list;
  const AnnihilatingSpace space = annihilating_space(along);
  const int order = static_cast<int>(space.polynomials.data.size());
  const MatrixFamily family = in_period ? matrices_along(along) : found.family;
  const JointSpectralRadius radius = in_period ? joint_spectral_radius(family, budget) : found.radius;
  for (const bool hermite : {false, true}) {
    if (hermite && !(list.hermite && space.polynomials.hermite)) continue;
    const ClaimedEnds ends = ends_of_all(along, order, upper_end(radius, {}), hermite);
    if (!ends.lower) continue;
    ListSubject subject = list_subject(in_period ? list : along);
    if (hermite) subject.of_matrices = "hermite";
    Certificate certificate{{ends, std::move(subject)}, {}, ends};
    certificate.sections.push_back(
        {space_of_vectors_text(space, along.masks.front().arity(), hermite) + blocks_text(radius)});
    add_sections(certificate, radius.proof, family.count());
    result.push_back(std::move(certificate));
  }
  return result;
}

/// Of masks of matrices: the exponent of the functions of the leading sequence, and of its scheme that it converges, of
/// a Hermite list HC^k.
void add_functions(std::vector<Certificate>& result, const ExponentOfList& found, const Budget& budget) {
  const VectorList& vectors = *found.vectors;
  if (!vectors.functions || vectors.functions->vector->solutions != 1) return;
  const auto add = [&](const auto& make) {
    try {
      result.push_back(make());
    } catch (const Error&) {  // nothing is proved, or not so that a certificate can tell
    }
  };
  add([&] { return exponent_certificate(*vectors.one, Regularity{std::nullopt, vectors.functions}); });
  add([&] { return vector_scheme_certificate(*vectors.one, vectors.hermite.has_value(), budget); });
}

/// Of levels that follow from each other, to which value they tend, and how.
void add_limit(Certificate& certificate, char letter, const FollowedLevels& followed) {
  const LimitOfLevels& limit = *followed.limit;
  std::get<MaskSubject>(certificate.claim.subject).limit = to_text(limit.value);
  std::string lines;
  for (const Interval& values : limit.way)
    lines += fmt::format("towards {} {}\n", to_text(values.lower), to_text(values.upper));
  if (const auto& powers = limit.rules.exponentials; !powers.empty())
    lines += fmt::format("exponentials {}\n", fmt::join(powers, " "));
  add_recurrence(certificate, letter, followed, lines);
}

}  // namespace

void certificate_text::add_recurrence(Certificate& certificate, char letter, const FollowedLevels& followed,
                                      const std::string& more) {
  auto& subject = std::get<MaskSubject>(certificate.claim.subject);
  const auto& [start, unbounded] = followed.start;
  subject.recurrence = followed.recurrence.to_text(letter);
  subject.start = fmt::format("{}..{}", to_text(start.lower), unbounded ? "inf" : to_text(start.upper));
  subject.from = unbounded ? "some" : std::to_string(*followed.first_level());
  std::string way;
  for (const Interval& values : *followed.way)
    way += fmt::format("level {} {}\n", to_text(values.lower), to_text(values.upper));
  // What an exact number is comes first.
  certificate.sections.insert(certificate.sections.begin() + (certificate.claim.exact ? 1 : 0), {way + more});
}

std::optional<Certificate> limit_certificate(const ParametricMask& mask, char letter, const Box& box,
                                             const FollowedLevels& followed, const Budget& budget) {
  if (!followed.way || !followed.limit) return std::nullopt;
  const LimitOfLevels& limit = *followed.limit;
  const int order = limit.rules.order();
  const ExponentOfList& found = limit.exponent;
  MaskSubject subject{mask.to_text(letter), std::to_string(mask.arity()),
                      fmt::format("{}={}..{}", letter, to_text(box.low[0]), to_text(box.high[0]))};
  subject.is_levels = true;
  const Mask there = mask.at(limit.value);
  std::optional<Certificate> certificate;
  if (sum_rules(there) == order && found.exponent.lower && *found.exponent.lower > 0) {
    const HolderRegularity regularity = holder_regularity(there, levels_of_bounds, budget, HolderProof::certificate);
    certificate.emplace(Certificate{{{}, subject}, {}});
    add_exponent(*certificate, there, checkable(there, regularity), {}, "", true);
  } else {
    certificate = of_all(subject, order, static_cast<int>(mask.arity()), found.family, found.radius);
  }
  if (certificate) add_limit(*certificate, letter, followed);
  return certificate;
}

ListSubject list_subject(const MaskList& list) {
  std::vector<std::string> masks;
  const bool of_matrices = list.masks.front().components() > 1;
  for (const LatticeMask& mask : list.masks)
    masks.push_back(of_matrices ? without_letters(mask).to_text('w') : mask.curve().symbol().to_mask_text());
  return {fmt::format("{}", fmt::join(masks, ";")), std::to_string(list.masks.front().arity()), order_text(list),
          of_matrices ? "vectors" : ""};
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
  if (found.vectors) {
    result = of_all_vectors(list, found, budget);
    add_functions(result, found, budget);
    return result;
  }
  auto all = of_all(list_subject(found.list), found.sum_rules, list.masks.front().arity(), found.family, found.radius,
                    false, list.period.empty() ? upper_end_of(list, found) : std::nullopt);
  if (!all) return result;
  if (list.period.empty()) result.push_back(std::move(*all));
  if (found.exponent.upper || !list.period.empty()) result.push_back(of_sequence(list, found.sequence, budget));
  return result;
}

}  // namespace subcert
