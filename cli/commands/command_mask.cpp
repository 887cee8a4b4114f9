// subcert mask SCHEME

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/cli/paper_form.hpp>
#include <subcert/reports/facts/scheme_facts.hpp>

namespace subcert::cli {
namespace {

struct MaskOptions : CommonOptions {
  std::string scheme;
  PaperForm form;
};

void print(const Scheme& scheme, const MaskOptions& options) {
  require_one_form(options, options.form);
  if (options.form.latex && scheme.form)
    fail(ErrorKind::usage, "--latex: need a mask of numbers, got {}", scheme.specification);
  if (options.form.latex) return options.answer(mask_formulas(scheme));
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
  add_paper_form(command, options->form, "Mask and symbol as formulas of LaTeX");
}

}  // namespace subcert::cli
