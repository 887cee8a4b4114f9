// subcert gallery SCHEME...: what is known of schemes, drawn on one page

#include "command.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/parallel.hpp>
#include <subcert/reports/gallery.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <iostream>
#include <mutex>

namespace subcert::cli {
namespace {

constexpr double small_budget = 5;

struct GalleryOptions : SearchOptions {
  std::vector<std::string> schemes;
  bool all = false;
  bool open = false;
};

Json curves_json(const reports::Plate& plate) {
  Json curves = Json::array();
  for (const reports::PlatePicture& picture : plate.pictures)
    for (const formats::Curve& curve : picture.panel.curves)
      curves.push_back({{"picture", picture.name}, {"label", curve.label}, {"points", curve.points}});
  return curves;
}

Json mask_json(const Scheme& scheme) {
  return {{"arity", scheme.mask.arity()},
          {"first_index", scheme.mask.symbol().lowest()},
          {"coefficients", numbers_json(scheme.mask.symbol().coefficients())}};
}

Json mask_json(const MultivariateScheme& scheme) {
  return {{"dilation", scheme.mask.dilation().rows()}, {"mask", to_mask_text(scheme.mask)}};
}

Json plate_json(const reports::Plate& plate) {
  Json json{{"scheme", plate.specification()},
            {"title", plate.title()},
            {"reference", plate.key.empty() ? Json() : Json(plate.key)},
            {"mask", std::visit([](const auto& one) { return mask_json(one); }, plate.scheme)},
            {"sum_rules", plate.sum_rules},
            {"convergence", decision_json(plate.convergence)},
            {"holder", plate.holder.lower ? enclosure_json(plate.holder) : Json()},
            {"exact", plate.exact.is_yes()},
            {"sobolev", enclosure_json(plate.sobolev)},
            {"stable", decision_json(plate.stable)},
            {"derivatives", plate.derivatives < 0 ? Json() : Json(plate.derivatives)},
            {"variance_sup", enclosure_json(plate.largest_variance)},
            {"variance_mean", plate.mean_variance ? Json(to_text(*plate.mean_variance)) : Json()},
            {"notes", plate.notes},
            {"curves", curves_json(plate)}};
  return json;
}

std::vector<reports::GalleryScheme> wanted(const GalleryOptions& options) {
  if (options.schemes.empty()) return reports::gallery_schemes();
  if (options.all) fail(ErrorKind::usage, "--all: takes no schemes, got '{}'", options.schemes.front());
  std::vector<reports::GalleryScheme> result;
  for (const std::string& scheme : options.schemes) {
    static_cast<void>(make_linear_scheme(scheme));  // errors before work
    result.push_back({scheme});
  }
  return result;
}

ExitCode run(const GalleryOptions& options) {
  const std::vector<reports::GalleryScheme> schemes = wanted(options);
  std::vector<std::optional<reports::Plate>> made(schemes.size());
  std::mutex mutex;
  std::size_t finished = 0;
  parallel_for_each(schemes.size(), options.threads(), [&](std::size_t i) {
    made[i] = reports::make_plate(schemes[i], {options.budget, options.memory << 20, options.open});
    const std::scoped_lock lock(mutex);
    options.progress(fmt::format("{} of {} schemes", ++finished, schemes.size()));
  });
  options.end_progress();
  std::vector<reports::Plate> plates;
  bool undecided_one = false;
  for (auto& plate : made) {
    undecided_one = undecided_one || plate->convergence.truth == Truth::unknown;
    plates.push_back(std::move(*plate));
  }
  if (options.json) {
    Json all = Json::array();
    for (const reports::Plate& plate : plates) all.push_back(plate_json(plate));
    options.answer(Json{{"schemes", std::move(all)}});
  } else {
    const std::string file = options.out.empty() ? "gallery.html" : options.out;
    runtime::write_file(file, reports::gallery_html(plates));
    if (!options.quiet) std::cout << file << ": " << plates.size() << (plates.size() == 1 ? " scheme\n" : " schemes\n");
  }
  return undecided_one ? undecided : done;
}

}  // namespace

void add_gallery(Command& app) {
  auto options = std::make_shared<GalleryOptions>();
  options->budget = small_budget;
  Command command = add_command(app, "gallery", "Schemes on one page, with pictures of their limits",
                                "subcert gallery primal:n=3 four-point:w=1/16 --out page.html", options,
                                [=] { return run(*options); });
  command.option("SCHEME", options->schemes, "Scheme specifications; none: forty schemes of the literature");
  command.flag("--all", options->all, "The forty schemes, as without arguments");
  command.flag("--open", options->open, "The polygon that is refined is an open one");
  command.existing("--out").describe("The page, gallery.html if not given; with --json the data");
  add_limits(command, *options);
}

}  // namespace subcert::cli
