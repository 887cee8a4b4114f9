#include "l1_certificate.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert {
namespace {

using piecewise::ContractionTree;
using piecewise::ProofNode;
using piecewise::ResidualFactors;

/// The factors of all windows over their least common denominator.
std::string leaf_line(const ResidualFactors& leaf, std::size_t places) {
  Integer common = 1;
  for (const auto& [place, factor] : leaf.factors) common = lcm(common, denominator(factor));
  std::string line = "leaf " + common.str();
  std::size_t next = 0;
  for (const auto& [place, factor] : leaf.factors) {
    for (; next < place; ++next) line += " 0";
    line += " " + numerator(factor * Rational(common)).str();
    ++next;
  }
  for (; next < places; ++next) line += " 0";
  return line + "\n";
}

std::string signs_text(std::uint8_t signs) {
  std::string text;
  if ((signs & ProofNode::positive) != 0) text += '+';
  if ((signs & ProofNode::negative) != 0) text += '-';
  if ((signs & ProofNode::none) != 0) text += '0';
  return text;
}

std::string tree_lines(const ContractionTree& tree, std::size_t points) {
  std::string lines = fmt::format("start {}\n", tree.start);
  std::size_t seen = 0;  // leaves that were written out
  for (const ProofNode& node : tree.nodes) {
    if (node.split)
      lines += fmt::format("side {} {} {}\n", node.index, node.datum, signs_text(node.signs));
    else if (node.index < seen)
      lines += fmt::format("again {}\n", node.index);
    else
      lines += leaf_line(tree.leaves[seen++], points * tree.windows.size());
  }
  return lines;
}

/// -log(number) / log(arity) / steps with 15 places, if it is positive and more than rounding leaves.
std::optional<std::string> exponent_text(const Rational& number, int arity, int steps, Rounding rounding) {
  if (number >= 1 || number <= 0) return std::nullopt;
  const Enclosure logarithm = log_ratio(1 / number, arity);
  const Rational end = (rounding == Rounding::down ? *logarithm.lower : *logarithm.upper) / steps;
  const Rational unit = power(Rational(10), 15);
  const Rational rounded = Rational(to_integer(end * unit, rounding)) / unit;
  if (rounded <= 0) return std::nullopt;
  return to_text(rounded);
}

std::string orbit_lines(const piecewise::Rule& rule, const piecewise::EdgeOrbit& orbit) {
  Integer common = 1;
  for (const Rational& value : orbit.values) common = lcm(common, denominator(value));
  std::string lines = fmt::format("orbit 1 {} {}", orbit.offset, orbit.factor);
  for (std::size_t i = 0; i < orbit.zeros; ++i) lines += " 0";
  for (const Rational& value : orbit.values) lines += " " + numerator(value * Rational(common)).str();
  lines += "\n";
  for (const std::vector<std::size_t>& level : orbit.pieces) {
    lines += "fits";
    for (const std::size_t piece : level) {
      lines += " ";
      for (const int sign : rule.pieces[piece].signs) lines += sign > 0 ? '+' : sign < 0 ? '-' : '0';
    }
    lines += "\n";
  }
  return lines;
}

}  // namespace

Certificate contraction_certificate(const piecewise::Rule& rule, const piecewise::Contraction& contraction,
                                    const std::optional<piecewise::EdgeOrbit>& edge) {
  require(!contraction.trees.empty(), "certificate: need the trees of the contraction");
  Certificate certificate;
  certificate.claim.lower = exponent_text(contraction.bound, rule.arity(), contraction.steps, Rounding::down);
  certificate.claim.subject = L1Subject{
      std::to_string(rule.points), std::to_string(rule.degree), rule.arity() == 2 ? "" : std::to_string(rule.arity()),
      fmt::format("{},{},{}", contraction.steps, contraction.order, to_text(contraction.bound))};
  for (const ContractionTree& tree : contraction.trees) certificate.sections.push_back({tree_lines(tree, rule.points)});
  if (edge && certificate.claim.lower) {
    certificate.claim.upper = exponent_text(edge->factor, rule.arity(), 1, Rounding::up);
    certificate.sections.push_back({orbit_lines(rule, *edge)});
  }
  certificate.bounds = certificate.claim;
  return certificate;
}

}  // namespace subcert
