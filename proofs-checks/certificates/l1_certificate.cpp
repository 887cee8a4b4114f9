#include "l1_certificate.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert {
namespace {

using piecewise::ContractionTree;
using piecewise::ResidualFactors;
using piecewise::Row;

/// The factors of all windows over their least common denominator.
std::string leaf_line(const ResidualFactors& factors) {
  Integer common = 1;
  for (const Row& row : factors.of_window)
    for (const Rational& factor : row) common = lcm(common, denominator(factor));
  std::string line = "leaf " + common.str();
  for (const Row& row : factors.of_window)
    for (const Rational& factor : row) line += " " + numerator(factor * Rational(common)).str();
  return line + "\n";
}

std::string tree_lines(const ContractionTree& tree) {
  std::string lines = fmt::format("start {}\n", tree.start);
  std::size_t seen = 0;  // leaves that were written out
  for (const piecewise::ProofNode& node : tree.nodes) {
    if (node.split)
      lines += fmt::format("split {}\n", node.index);
    else if (node.index < seen)
      lines += fmt::format("again {}\n", node.index);
    else
      lines += leaf_line(tree.leaves[seen++]);
  }
  return lines;
}

/// s with bound <= 2^(-steps s), 15 places.
std::optional<std::string> exponent_text(const piecewise::Contraction& contraction) {
  if (contraction.bound >= 1 || contraction.bound <= 0) return std::nullopt;
  const Rational lower = *log_ratio(1 / contraction.bound, 2).lower / contraction.steps;
  const Rational unit = power(Rational(10), 15);
  const Rational rounded = Rational(to_integer(lower * unit, Rounding::down)) / unit;
  if (rounded <= 0) return std::nullopt;
  return to_text(rounded);
}

}  // namespace

Certificate contraction_certificate(int points, int degree, const piecewise::Contraction& contraction) {
  require(!contraction.trees.empty(), "certificate: need the trees of the contraction");
  Certificate certificate;
  certificate.claim.lower = exponent_text(contraction);
  certificate.claim.subject = L1Subject{
      std::to_string(points), std::to_string(degree),
      fmt::format("{},{},{}", contraction.steps, contraction.order, to_text(contraction.bound))};
  for (const ContractionTree& tree : contraction.trees) certificate.sections.push_back({tree_lines(tree)});
  certificate.bounds = certificate.claim;
  return certificate;
}

}  // namespace subcert
