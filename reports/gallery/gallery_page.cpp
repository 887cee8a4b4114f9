#include "gallery.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/reports/formats/comparison.hpp>
#include <subcert/reports/formats/html.hpp>
#include <subcert/reports/formats/section.hpp>
#include <subcert/reports/formats/surface_figure.hpp>
#include <subcert/reports/formats/svg.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace subcert::reports {
namespace {

using facts::Fact;

constexpr int places_of_card = 4;
constexpr long largest_grid = 21;  // rows and columns of a mask that are shown

std::vector<std::string> anchors(const std::vector<Plate>& plates) {
  std::vector<std::string> result;
  std::map<std::string, int> seen;
  for (const Plate& plate : plates) {
    const std::string name = formats::slug(plate.specification());
    const int before = seen[name]++;
    result.push_back(before == 0 ? name : fmt::format("{}--{}", name, before + 1));
  }
  return result;
}

std::string value_html(const Fact& fact) {
  const bool strong = fact.key == "holder" && fact.text.find_first_of("0123456789") != std::string::npos;
  return (strong ? "<b>" + formats::html(fact.text) + "</b>" : formats::html(fact.text)) +
         (fact.remark.empty() ? "" : " <span class=why>" + formats::html(fact.remark) + "</span>");
}

std::string mask_html(const Scheme& scheme) {
  const MultivariatePolynomial& symbol = scheme.mask.symbol();
  const auto low = symbol.lowest(), high = symbol.highest();
  if (scheme.mask.dimension() != 2 || high[0] - low[0] >= largest_grid || high[1] - low[1] >= largest_grid)
    return fmt::format("{} coefficients; <code>subcert mask</code> prints them", symbol.count());
  Integer common = 1;
  for (const auto& term : symbol.terms()) common = lcm(common, denominator(term.coefficient));
  std::string rows;
  for (long y = high[1]; y >= low[1]; --y) {
    rows += "<tr>";
    for (long x = low[0]; x <= high[0]; ++x) {
      const Rational value = symbol.coefficient({x, y}) * Rational(common);
      rows += fmt::format("<td{}>{}</td>", value == 0 ? " class=zero-coefficient" : "", to_text(value));
    }
    rows += "</tr>\n";
  }
  return fmt::format(
      "<div class=scroll><table class=coefficients>\n{}</table></div>\n<span class=why>divided by {}; "
      "the lower left entry has the index ({}, {}); dilation {}</span>",
      rows, common.str(), low[0], low[1], formats::html(scheme.mask.dilation().to_text()));
}

std::string facts_html(const Plate& plate) {
  std::string result = "<dl>\n";
  for (const Fact& fact : plate_facts(plate)) {
    if (fact.label.empty()) continue;
    const bool mask = fact.label == "mask", table = mask && plate.scheme.mask.dimension() > 1;
    result += fmt::format("<dt>{}</dt><dd{}>{}</dd>\n", formats::html(fact.label), mask && !table ? " class=mask" : "",
                          table ? mask_html(plate.scheme) : value_html(fact));
  }
  if (plate.proof && !plate.proof->name.empty())
    result += "<dt>certificate</dt><dd class=proof>" + formats::check_button_inside(*plate.proof) + "</dd>\n";
  return result + "</dl>\n";
}

std::string plate_html(const Plate& plate, const std::string& anchor) {
  std::string result = fmt::format(
      "<article class=plate id=\"{0}\">\n<h2><a href=\"#{0}\">{1}</a></h2>\n"
      "<p class=subtitle>{2}</p>\n",
      anchor, formats::html(plate.specification()), formats::html(plate.title()));
  if (!plate.key.empty())
    result += fmt::format("<p class=place>[{}] {}</p>\n", plate.key, formats::html(reference(plate.key)));
  result += facts_html(plate);
  for (const std::string& note : plate.notes) result += "<p class=note>" + formats::html(note) + "</p>\n";
  if (plate.pictures.empty() && !plate.surface) return result + "</article>\n";
  result += "<div class=pictures>\n";
  const auto figure = [&](const std::string& picture, const std::string& caption) {
    result += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", picture, caption);
  };
  for (const PlatePicture& picture : plate.pictures)
    figure(formats::plot(picture.panel, picture.name == "limit" ? anchor + "-limit" : ""), picture.caption);
  if (plate.surface)
    figure(formats::svg(*plate.surface, anchor + "-limit"),
           "<i>φ</i>: where it is at least 1/10, …, 9/10 of its maximum; in the other colour, at most 1/3 and 2/3 "
           "of a negative minimum");
  if (plate.surface) figure(formats::surface_view(*plate.surface), "<i>φ</i>, to be turned");
  return result + "</div>\n</article>\n";
}

std::string card(const Plate& plate, const std::string& anchor) {
  const bool drawn = plate.surface || std::ranges::any_of(plate.pictures, [](const PlatePicture& picture) {
                       return picture.name == "limit";
                     });
  return fmt::format("<li><a href=\"#{}\">{}<b>{}</b><small>{}{}</small></a></li>\n", anchor,
                     drawn ? formats::thumbnail(anchor + "-limit") : "<span class=none>no limits</span>",
                     formats::html(plate.specification()),
                     plate.convergence.is_no() ? "diverges"
                     : plate.holder.lower
                         ? "Hoelder " + formats::html(formats::fixed_text(plate.holder, places_of_card))
                     : plate.convergence.is_yes() ? "converges"
                                                  : "not decided",
                     plate.key.empty() ? "" : "<br>[" + plate.key + "]");
}

std::vector<std::string> specifications(const std::vector<Plate>& plates) {
  std::vector<std::string> texts;
  for (const Plate& plate : plates) texts.push_back(plate.specification());
  return texts;
}

}  // namespace

std::string gallery_html(const std::vector<Plate>& plates) {
  const std::vector<std::string> names = anchors(plates);
  const bool several = plates.size() > 1;
  std::string body;
  if (several) {
    body += fmt::format(
        "<h1>A gallery of subdivision schemes</h1>\n<p>{} schemes, each with its exact mask, its smoothness, "
        "enclosed with proof, its basic limit function with the continuous derivatives, its variance curve "
        "and a polygon that it refines. Curves go through exact values.</p>\n<ul class=cards>\n",
        plates.size());
    for (std::size_t i = 0; i < plates.size(); ++i) body += card(plates[i], names[i]);
    body += "</ul>\n";
  }
  for (std::size_t i = 0; i < plates.size(); ++i) body += plate_html(plates[i], names[i]);
  return formats::html_page(several ? "A gallery of subdivision schemes"
                                    : formats::html(plates.empty() ? "" : plates.front().specification()),
                            body, specifications(plates));
}

std::vector<PlatePicture> overlaid(const std::vector<Plate>& plates) {
  std::vector<PlatePicture> pictures;
  for (const char* name : {"limit", "derivative-1", "derivative-2", "variance"}) {
    PlatePicture all{name, "", {}};
    for (const Plate& plate : plates)
      for (const PlatePicture& picture : plate.pictures) {
        if (picture.name != name) continue;
        if (all.panel.curves.empty()) all = {name, picture.caption, {picture.panel.title, "x", "", {}}};
        for (const formats::Curve& curve : picture.panel.curves)
          if (!curve.marked)
            all.panel.curves.push_back(
                {plate.specification() + (curve.label.empty() ? "" : " " + curve.label), curve.points});
      }
    if (all.panel.curves.size() > 1) pictures.push_back(std::move(all));
  }
  return pictures;
}

std::string comparison_html(const std::vector<Plate>& plates) {
  const std::vector<std::string> names = anchors(plates);
  std::vector<facts::Facts> known;
  for (const Plate& plate : plates) known.push_back(plate_facts(plate));
  std::string table = "<tr><th></th>";
  for (std::size_t i = 0; i < plates.size(); ++i)
    table += fmt::format("<th class=text><a href=\"#{}\">{}</a></th>", names[i],
                         formats::html(plates[i].specification()));
  table += "</tr>\n";
  for (const std::string& label : labels(known)) {
    table += fmt::format("<tr><th>{}</th>", formats::html(label));
    for (const facts::Facts& list : known) {
      const Fact* fact = find(list, label);
      table += fmt::format("<td class=text>{}</td>", fact ? value_html(*fact) : "");
    }
    table += "</tr>\n";
  }
  std::string pictures;
  for (const PlatePicture& picture : overlaid(plates))
    pictures += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", formats::plot(picture.panel),
                            picture.caption);
  std::string body = fmt::format(
      "<h1>{} schemes side by side</h1>\n<div class=scroll tabindex=0 role=region aria-label=\"What is known\"><table "
      "class=comparison>\n{}</table></div>\n<div class=pictures>\n{}</div>\n",
      plates.size(), table, pictures);
  for (std::size_t i = 0; i < plates.size(); ++i) body += plate_html(plates[i], names[i]);
  return formats::html_page("Subdivision schemes side by side", body, specifications(plates));
}

}  // namespace subcert::reports
