#include "checks.hpp"

#include <subcert/analysis/symbol/interval.hpp>
#include <subcert/proofs-checks/statements/computed.hpp>
#include <subcert/proofs-checks/statements/mask_form.hpp>
#include <subcert/proofs-checks/theorems/theorem.hpp>
#include <subcert/schemes/local_regression.hpp>
#include <subcert/schemes/specification.hpp>

namespace subcert::statements::dyn_2015 {

Checks checks() {
  return joined({section_2(), section_2_2(), section_3(), section_4(), section_4_3(), section_5(), appendix()});
}

Mask s_n(long n) { return regression_mask(primal(static_cast<int>(n), 1)); }

std::string range(int first, int last) {
  return "n = " + std::to_string(first) + (first == last ? "" : ".." + std::to_string(last));
}

std::string at_n_d(int n, int d) { return at("n", n) + ", " + at("d", d); }

ScaledMaximum scaled_maximum(const PublishedCell& cell) {
  const int n = cell.n.value();
  if (cell.quantity == "max psi") return {false, 1};
  if (cell.quantity == "n max psi") return {false, n};
  if (cell.quantity == "max |psi'|") return {true, 1};
  if (cell.quantity == "n^2 max |psi'|") return {true, n * n};
  fail(ErrorKind::domain, "need a maximum of psi or of |psi'|, got '{}'", cell.quantity);
}

Trial proved_for_degree_one(const std::string& theorem) {
  const Decision proof = theorems::prove(theorem, 1).decision;
  Trial trial;
  trial.require(proof.is_yes(), proof.reason);
  return trial;
}

Outcome table_words(const Context& context, const std::string& id) {
  const std::vector<PublishedCell> cells = context.cells(id);
  std::vector<std::string> labels;
  for (const PublishedCell& cell : cells)
    labels.push_back((cell.d ? at("d", *cell.d) + ", " : "") + at("n", cell.n.value()));
  const auto certified = [&](std::size_t i) {
    const std::string scheme = make_scheme(cells[i].scheme).specification;
    if (cells[i].quantity == "bound after 16 levels") return holder_bound_of(scheme).exponent;
    const ScaledMaximum what = scaled_maximum(cells[i]);
    const VarianceRange& range = variance_of(scheme);
    return scaled(what.slope ? *range.slope : range.maximum, what.factor);
  };
  return in_both_forms([&](Form form) { return table_row(context.words(id, form), labels, certified); });
}

}  // namespace subcert::statements::dyn_2015
