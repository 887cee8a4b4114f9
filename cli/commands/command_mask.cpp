// subcert mask SCHEME

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/cli/paper_form.hpp>
#include <subcert/reports/facts/scheme_facts.hpp>
#include <subcert/schemes/refinement_rules.hpp>

namespace subcert::cli {
namespace {

struct MaskOptions : CommonOptions {
  std::string scheme;
  PaperForm form;
  bool rules = false;
  bool decimals = false;
};

void print(const Scheme& scheme, const MaskOptions& options) {
  require_one_form(options, options.form);
  if (options.form.latex && scheme.form)
    fail(ErrorKind::usage, "--latex: need a mask of numbers, got {}", scheme.specification);
  if (options.decimals && !options.rules)
    fail(ErrorKind::usage, "--decimals: expected --rules, whose weights it rounds");
  if (options.rules && (options.json || options.form.latex))
    fail(ErrorKind::usage, "--rules and --{}: expected one of the two", options.json ? "json" : "latex");
  if (options.form.latex) return options.answer(mask_formulas(scheme));
  if (options.rules) {
    if (scheme.form || scheme.mask.dimension() > 1)
      fail(ErrorKind::usage, "--rules: need a scheme of curves with a mask of numbers, got {}", scheme.specification);
    return options.answer(rules_text(scheme.mask.curve(), options.decimals));
  }
  const Dilation& dilation = scheme.mask.dilation();
  const bool multiple = dilation.factor().value_or(0) > 0;
  if (!options.json) {
    options.answer(to_mask_text(scheme.mask) +
                   (multiple ? "" : ",dilation=" + dilation.to_text() + ",digits=" + to_text(dilation.digits())) +
                   "\n");
    return;
  }
  Json json{{"scheme", scheme.specification}};
  if (multiple) {
    json["arity"] = scheme.mask.arity();
  } else {
    json["dilation"] = dilation.rows();
    json["digits"] = dilation.digits();
  }
  json["first_index"] = first_index_json(scheme.mask);
  json["coefficients"] = coefficients_json(scheme.mask);
  json["support"] = limit_support_json(scheme.mask);
  options.answer(json);
}

}  // namespace

void add_mask(Command& app) {
  auto options = std::make_shared<MaskOptions>();
  Command command = add_command(app, "mask", "The exact mask of a scheme", "subcert mask primal:n=3", options, [=] {
    print(make_refinable_scheme(options->scheme), *options);
    return done;
  });
  add_scheme(command, options->scheme, true, true);
  command.flag("--rules", options->rules, "The rules for new points, f_{2i} = 3/4 f_i + 1/4 f_{i+1}, a line each");
  command.flag("--decimals", options->decimals, "With --rules: weights as decimal numbers, for programs");
  add_paper_form(command, options->form, "Mask and symbol as formulas of LaTeX");
}

}  // namespace subcert::cli
