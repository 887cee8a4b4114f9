#include "vertex_gallery.hpp"

#include <subcert/reports/facts/vertex_facts.hpp>
#include <subcert/reports/formats/comparison.hpp>
#include <subcert/reports/formats/html.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert::cli {
namespace {

constexpr int points_of_card = 12;  // along a ray
constexpr int places_of_card = 4;
constexpr std::size_t label_width = 14;

std::vector<VertexSmoothness> valences_of(const VertexPlate& plate) {
  std::vector<VertexSmoothness> result;
  for (const VertexPicture& picture : plate.pictures) result.push_back(picture.smoothness);
  return result;
}

Facts facts_of(const VertexPlate& plate) {
  return facts::vertex_facts(plate.scheme, plate.regular, valences_of(plate));
}

std::string number(const Enclosure& enclosure) {
  return enclosure.is_bounded() ? formats::html(formats::fixed_text(enclosure, places_of_card)) : "open";
}

/// What is proved, in three lines.
std::string card(const VertexPicture& picture, const std::string& anchor) {
  const VertexSmoothness& at = picture.smoothness;
  std::string text = fmt::format("C1: {}", at.c1.truth == Truth::unknown ? "open" : to_text(at.c1.truth));
  if (at.subdominant.is_bounded())
    text += fmt::format("<br>λ = {}{}", number(at.subdominant),
                        at.frequency == 1 ? "" : fmt::format(", frequency {}", at.frequency));
  if (at.c1.is_yes()) text += "<br>curvature " + (at.curvature ? to_text(*at.curvature) : "open");
  return fmt::format("<li><a id=\"{0}\" href=\"#{0}\">{1}<b>n = {2}</b><small>{3}</small></a></li>\n", anchor,
                     picture.surface ? map_svg(*picture.surface) : "<span class=none>no picture</span>", at.valence,
                     text);
}

std::string plate_html(const VertexPlate& plate) {
  const std::string name = formats::slug(plate.scheme.specification);
  std::string result = fmt::format("<h2 id=\"{0}\"><a href=\"#{0}\">{1}</a></h2>\n<p class=subtitle>{2}</p>\n", name,
                                   formats::html(plate.scheme.specification), formats::html(plate.scheme.title));
  result += "<ul class=cards>\n";
  for (const VertexPicture& picture : plate.pictures)
    result += card(picture, fmt::format("{}-{}", name, picture.smoothness.valence));
  return result + "</ul>\n<details><summary>What is proved</summary><div class=scroll><pre>" +
         formats::html(page_text(facts_of(plate), label_width)) + "</pre></div></details>\n";
}

}  // namespace

const std::vector<std::string>& vertex_gallery_schemes() {
  static const std::vector<std::string> schemes{"loop",    "catmull-clark", "doo-sabin",
                                                "midedge", "butterfly",     "modified-butterfly",
                                                "kobbelt", "sqrt3",         "four-eight"};
  return schemes;
}

std::vector<VertexPlate> make_vertex_plates(const std::vector<VertexScheme>& schemes, const std::vector<int>& valences,
                                            const SearchOptions& options) {
  std::vector<std::vector<SectorRules>> rules;  // errors before work
  for (const VertexScheme& scheme : schemes) rules.push_back(scheme.at(valences));
  std::vector<VertexPlate> plates;
  for (std::size_t i = 0; i < schemes.size(); ++i) {
    options.progress(fmt::format("{} of {} schemes: {}", i + 1, schemes.size(), schemes[i].specification));
    const RegularPart regular = regular_part(rules[i].front(), options.limits());
    const std::vector<VertexSmoothness> proved = vertex_smoothness(rules[i], regular, options.threads());
    VertexPlate plate{schemes[i], regular, {}};
    for (std::size_t k = 0; k < proved.size(); ++k)
      plate.pictures.push_back({proved[k], vertex_surface(rules[i][k], regular, proved[k], points_of_card)});
    plates.push_back(std::move(plate));
  }
  options.end_progress();
  return plates;
}

std::string vertex_gallery_html(const std::vector<VertexPlate>& plates) {
  std::string body = fmt::format(
      "<h1>A gallery of vertices</h1>\n<p>{} surface schemes at vertices of several valences n, of dual schemes at "
      "faces with n corners. Each card has the characteristic map, the subdominant eigenvalue λ, and whether surfaces "
      "are C1 and have curvature there, proved. Colours, for the eye, are the root of the modulus of Gauss's "
      "curvature of the largest eigenvalue behind λ: red above 0, blue below. Towards the vertex they fade where "
      "curvature is zero, stay where it is bounded, fill up where it is unbounded; maps are grey where that eigenvalue "
      "is not proved to be one real number.</p>\n",
      plates.size());
  for (const VertexPlate& plate : plates) body += plate_html(plate);
  return formats::html_page("A gallery of vertices", body);
}

Json vertex_plates_json(const std::vector<VertexPlate>& plates) {
  Json all = Json::array();
  for (const VertexPlate& plate : plates) all.push_back(page_json(facts_of(plate)));
  return {{"schemes", std::move(all)}};
}

ExitCode exit_code(const std::vector<VertexPlate>& plates) {
  Truth truth = Truth::yes;
  bool open_for_good = true;
  for (const VertexPlate& plate : plates) {
    const Truth one = facts::all_of(valences_of(plate));
    if (one == Truth::no) return exit_code(Truth::no);
    if (one == Truth::unknown) truth = one, open_for_good = open_for_good && plate.regular.c1.is_yes();
  }
  return exit_code(truth, open_for_good);
}

}  // namespace subcert::cli
