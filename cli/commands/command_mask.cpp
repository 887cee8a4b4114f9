// subcert mask SCHEME

#include <subcert/cli/command.hpp>
#include <subcert/reports/facts/scheme_facts.hpp>

namespace subcert::cli {
namespace {

void print(const Scheme& scheme, const CommonOptions& options) {
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
  auto options = std::make_shared<CommonOptions>();
  auto specification = std::make_shared<std::string>();
  Command command = add_command(app, "mask", "The exact mask of a scheme", "subcert mask primal:n=3", options, [=] {
    print(make_linear_scheme(*specification), *options);
    return done;
  });
  add_scheme(command, *specification, true);
}

}  // namespace subcert::cli
