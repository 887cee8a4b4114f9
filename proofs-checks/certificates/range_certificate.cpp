#include "certificate_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace subcert {
namespace {

using namespace certificate_text;

/// What the proofs of intervals that follow each other say of all values from low to high; without proofs, that the
/// shifts are stable. `of_matrices`: the kind of a claim about a mask of matrices, as in MaskSubject.
Certificate interval_certificate(const ParametricMask& mask, char letter, const Rational& low, const Rational& high,
                                 const ClaimedEnds& ends, const std::vector<IntervalProof>& proofs,
                                 const std::string& of_matrices = "", bool is_levels = false) {
  const MaskSubject subject{mask.to_text(letter),
                            std::to_string(mask.arity()),
                            fmt::format("{}={}..{}", letter, to_text(low), to_text(high)),
                            is_levels,
                            {},
                            of_matrices};
  Certificate certificate{{ends, subject}, {}, ends};
  const bool stable = proofs.empty() || (ends.upper && *ends.upper != "0");
  certificate.sections.push_back(
      {!of_matrices.empty() ? space_of_vectors_text(annihilating_space(mask), mask.arity(), of_matrices == "hermite")
                            : fmt::format("sum-rules {}{}\n{}", sum_rules(mask), full_text(ends.says_rough()),
                                          stable ? "stability\n" : "")});
  const std::size_t matrices = static_cast<std::size_t>(mask.arity()) * mask.powers().size();
  for (const IntervalProof& proof : proofs) {
    std::string text = fmt::format("to {}\n", to_text(proof.high));
    if (proof.above) text += blocks_text(*proof.above);
    if (const auto& below = proof.below) text += product_text(0, {below->re, below->im}, below->word);
    certificate.sections.push_back({std::move(text)});
    if (proof.above) add_sections(certificate, proof.above->proof, matrices);
  }
  return certificate;
}

/// As in MaskSubject.
std::string kind_of_matrices(const ParametricMask& mask, const RangeProperty& property) {
  return property.kind == RangeProperty::Kind::hermite ? "hermite" : mask.components() > 1 ? "vectors" : "";
}

/// What needs no proofs of intervals, for all values from `low` to `high` but those within `margin` of `away`, in
/// order.
void add_away(std::vector<RangeCertificate>& certificates, const ParametricMask& mask, char letter,
              const ClaimedEnds& ends, Truth holds, Rational low, const Rational& high,
              const std::vector<Enclosure>& away, const Rational& margin) {
  const auto add = [&](const Rational& end) {
    if (low < end) certificates.push_back({low, end, holds, interval_certificate(mask, letter, low, end, ends, {})});
  };
  for (const Enclosure& value : away) {
    if (*value.upper < low || *value.lower > high) continue;
    add(*value.lower - margin);
    low = *value.upper + margin;
  }
  add(high);
}

/// The limits are not C^order.
void add_rough(std::vector<RangeCertificate>& certificates, const ParametricMask& mask, char letter,
               const Rational& order, const Rational& low, const Rational& high, const std::vector<Enclosure>& away,
               const Rational& margin) {
  add_away(certificates, mask, letter, {{}, "C" + to_text(order)}, Truth::no, low, high, away, margin);
}

/// The shifts are stable; where the polynomial vanishes by which a range is proved, value by value.
void add_stable(std::vector<RangeCertificate>& certificates, const ParametricMask& mask, char letter,
                const Rational& low, const Rational& high, const std::vector<SpecialValue>& special,
                const Rational& margin) {
  std::vector<Enclosure> away;
  for (const SpecialValue& one : special) {
    if (one.why != SpecialValue::Why::unstable) continue;
    away.push_back(one.value);
    if (one.holds != Truth::yes || !one.value.is_exact() || *one.value.lower < low || *one.value.lower > high) continue;
    const Rational& value = *one.value.lower;
    const Mask there = mask.at(value);
    const MaskSubject subject{there.symbol().to_mask_text(), std::to_string(there.arity())};
    certificates.push_back(
        {value, value, Truth::yes, {{{}, subject}, {{fmt::format("sum-rules {}\nstability\n", sum_rules(there))}}}});
  }
  add_away(certificates, mask, letter, {}, Truth::yes, low, high, away, margin);
}

}  // namespace

std::vector<RangeCertificate> range_certificates(const ParametricMask& mask, char letter, const RangeProperty& property,
                                                 const PropertyRange& range, const Rational& margin) {
  using Kind = RangeProperty::Kind;
  const bool stable = property.kind == Kind::stable,
             rough = property.kind == Kind::smooth && property.order >= range.sum_rules;
  if (!stable && !rough && range.proofs.empty()) return {};
  const std::string of_matrices = kind_of_matrices(mask, property);
  std::vector<RangeCertificate> certificates;
  std::vector<Enclosure> special;  // looked at on their own
  for (const SpecialValue& value : range.special) special.push_back(value.value);
  auto proof = range.proofs.begin();
  const auto add = [&](const Rational& low, const Rational& high, Truth holds, const ClaimedEnds& ends,
                       const std::vector<IntervalProof>& proofs) {
    if (low < high)
      certificates.push_back(
          {low, high, holds, interval_certificate(mask, letter, low, high, ends, proofs, of_matrices)});
  };
  // Limits of vectors are refuted by HC^k alone.
  const bool no_refuted = stable || (of_matrices == "vectors" && property.kind != Kind::convergent);
  for (const RangePiece& piece : range.pieces) {
    if (piece.holds == Truth::unknown || (no_refuted && piece.holds == Truth::no)) continue;
    const Rational low = piece.low_included ? piece.low : Rational(piece.low + margin);
    const Rational high = piece.high_included ? piece.high : Rational(piece.high - margin);
    ClaimedEnds ends;
    if (rough) {
      if (piece.holds == Truth::no) add_rough(certificates, mask, letter, property.order, low, high, special, margin);
      continue;
    }
    if (stable) {
      add_stable(certificates, mask, letter, low, high, range.special, margin);
      continue;
    }
    (piece.holds == Truth::yes ? ends.lower : ends.upper) = to_text(property.order);
    // What is known by positive coefficients has no proof of its own.
    std::vector<IntervalProof> proofs;
    const auto add_run = [&] {
      if (!proofs.empty()) add(proofs.front().low, proofs.back().high, piece.holds, ends, proofs);
      proofs.clear();
    };
    while (proof != range.proofs.end() && proof->low < piece.low) ++proof;  // of pieces without a certificate
    for (; proof != range.proofs.end() && proof->low < piece.high; ++proof) {
      if (!proofs.empty() && proofs.back().high < proof->low) add_run();
      proofs.push_back(*proof);
    }
    add_run();
  }
  return certificates;
}

std::optional<Certificate> levels_certificate(const ParametricMask& mask, char letter, const RangeProperty& property,
                                              const Box& box, const PropertyOfLevels& levels,
                                              const FollowedLevels* followed) {
  if (levels.holds != Truth::yes) return std::nullopt;
  const Rational &low = box.low[0], &high = box.high[0];
  Certificate certificate = interval_certificate(mask, letter, low, high, {to_text(property.order), {}},
                                                 {{low, high, levels.above, std::nullopt}},
                                                 kind_of_matrices(mask, property), true);
  if (followed && followed->way) add_recurrence(certificate, letter, *followed);
  return certificate;
}

std::vector<RangeCertificate> curve_certificates(const ParametricMask& mask, char letter, const ExponentCurve& curve) {
  const std::string of_matrices = mask.components() > 1 ? "vectors" : "";
  const Rational strictly = power(Rational(10), -12);
  std::vector<Enclosure> special;  // with more sum rules
  for (const CurvePoint& point : curve.special) special.push_back(point.at.value);
  std::vector<RangeCertificate> certificates;
  const auto add = [&](const IntervalProof& proof, const ClaimedEnds& ends) {
    certificates.push_back({proof.low, proof.high, ends.lower ? Truth::yes : Truth::unknown,
                            interval_certificate(mask, letter, proof.low, proof.high, ends, {proof}, of_matrices)});
  };
  for (const CurvePiece& piece : curve.pieces) {
    IntervalProof above{piece.proof.low, piece.proof.high, std::nullopt, std::nullopt}, below = above;
    ClaimedEnds lower, upper;
    if (piece.exponent.lower && *piece.exponent.lower > strictly) {
      above.above = piece.proof.above;
      const Rational most = of_matrices.empty() ? *piece.exponent.lower : Rational(curve.sum_rules);
      lower.lower = outward(std::min(*piece.exponent.lower, most) - strictly, Rounding::down);
    }
    if (piece.exponent.upper && of_matrices.empty()) {
      below.below = piece.proof.below;
      upper.upper = outward(std::max(Rational(0), *piece.exponent.upper), Rounding::up);
    }
    // A product of diagonal blocks is not that of the whole matrices.
    if (above.above && below.below && !above.above->by_blocks()) {
      add(piece.proof, {lower.lower, upper.upper});
      continue;
    }
    if (above.above) add(above, lower);
    if (below.below) add(below, upper);
    if (piece.exponent.upper && !piece.proof.below && of_matrices.empty())
      add_rough(certificates, mask, letter, curve.sum_rules, piece.proof.low, piece.proof.high, special, strictly);
  }
  return certificates;
}

}  // namespace subcert
