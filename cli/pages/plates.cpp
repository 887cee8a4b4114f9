#include "plates.hpp"

#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/reports/gallery/gallery.hpp>

#include <mutex>
#include <optional>

namespace subcert::cli {
namespace {

Json curves_json(const reports::Plate& plate) {
  Json curves = Json::array();
  for (const reports::PlatePicture& picture : plate.pictures)
    for (const formats::Curve& curve : picture.panel.curves)
      curves.push_back({{"picture", picture.name}, {"label", curve.label}, {"points", curve.points}});
  return curves;
}

Json mask_json(const Scheme& scheme) {
  if (scheme.form || scheme.mask.dimension() > 1)
    return {{"dilation", scheme.mask.dilation().rows()}, {"mask", to_mask_text(scheme.mask)}};
  const Mask& mask = scheme.mask.curve();
  return {{"arity", mask.arity()},
          {"first_index", mask.symbol().lowest()},
          {"coefficients", numbers_json(mask.symbol().coefficients())}};
}

Json plate_json(const reports::Plate& plate) {
  Json json = page_json(reports::plate_facts(plate));
  json["reference"] = plate.key.empty() ? Json() : Json(plate.key);
  json["mask"] = mask_json(plate.scheme);
  json["notes"] = plate.notes;
  json["curves"] = curves_json(plate);
  return json;
}

}  // namespace

std::vector<reports::Plate> make_plates(const std::vector<reports::GalleryScheme>& schemes,
                                        const reports::PlateOptions& plate_options, const CommonOptions& options) {
  std::vector<std::optional<reports::Plate>> made(schemes.size());
  std::mutex mutex;
  std::size_t finished = 0;
  parallel_tasks(schemes.size(), options.threads(), [&](std::size_t i) {
    made[i] = reports::make_plate(schemes[i], plate_options);
    const std::scoped_lock lock(mutex);
    options.progress(fmt::format("{} of {} schemes", ++finished, schemes.size()));
  });
  options.end_progress();
  std::vector<reports::Plate> plates;
  for (auto& plate : made) plates.push_back(std::move(*plate));
  return plates;
}

Json plates_json(const std::vector<reports::Plate>& plates) {
  Json all = Json::array();
  for (const reports::Plate& plate : plates) all.push_back(plate_json(plate));
  return {{"schemes", std::move(all)}};
}

ExitCode exit_code(const std::vector<reports::GalleryScheme>& schemes, const std::vector<reports::Plate>& plates) {
  Truth as_expected = Truth::yes;
  for (std::size_t i = 0; i < plates.size(); ++i) {
    const Truth found = plates[i].convergence.truth;
    if (found == schemes[i].convergence) continue;
    if (found != Truth::unknown) return exit_code(Truth::no);
    as_expected = Truth::unknown;
  }
  return exit_code(as_expected);
}

}  // namespace subcert::cli
