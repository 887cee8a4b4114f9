#include "formats/comparison.hpp"
#include "formats/html.hpp"
#include "formats/svg.hpp"
#include "gallery.hpp"

#include <subcert/analysis/symbol/decimal.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace subcert::reports {
namespace {

constexpr int places = 10, places_of_card = 4, places_of_variance = 5;
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

/// The sign that people use for `>=` and `<=`.
std::string number_html(const Enclosure& enclosure, int digits) {
  std::string text = formats::fixed_text(enclosure, digits);
  if (text.starts_with(">= ")) return "≥ " + text.substr(3);
  if (text.starts_with("<= ")) return "≤ " + text.substr(3);
  if (const auto dots = text.find(" ... "); dots != std::string::npos) return text.replace(dots, 5, " … ");
  if (enclosure.is_exact()) return to_text(*enclosure.lower);
  return text;
}

std::string why(const Decision& decision) {
  const char* word = decision.is_yes() ? "yes" : decision.is_no() ? "no" : "not decided";
  return decision.reason.empty() ? word
                                 : fmt::format("{} <span class=why>{}</span>", word, formats::html(decision.reason));
}

std::string fact(const std::string& name, const std::string& value, const std::string& kind = "") {
  return fmt::format("<dt>{}</dt><dd{}>{}</dd>\n", name, kind.empty() ? "" : " class=" + kind, value);
}

std::string mask_html(const Scheme& scheme) {
  const LaurentPolynomial& symbol = scheme.mask.symbol();
  constexpr std::size_t longest = 1200;
  std::string text = symbol.to_mask_text();
  if (scheme.rounding || text.size() > longest) {
    text.clear();
    for (const Rational& coefficient : symbol.coefficients())
      text += (text.empty() ? "" : ",") + to_decimal(coefficient, places, Rounding::nearest);
    text = fmt::format("[{}]@{}, to {} digits; subcert mask prints it exactly", text, symbol.lowest(), places);
  }
  std::string result;  // lines may break behind commas
  for (const char c : formats::html(text)) result += c == ',' ? ",<wbr>" : std::string(1, c);
  return result;
}

std::string mask_html(const MultivariateScheme& scheme) {
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

std::string holder_html(const Plate& plate) {
  if (plate.convergence.is_no()) return "none";
  if (!plate.holder.lower) return "not proved";
  std::string text = "<b>" + number_html(plate.holder, places) + "</b>";
  if (!plate.holder.upper)
    text += " <span class=why>a lower bound; the shifts are not proved stable</span>";
  else if (plate.exact.is_yes())
    text += " <span class=why>enclosed with proof; a product attains the radius</span>";
  else
    text += " <span class=why>enclosed with proof</span>";
  return text;
}

std::string facts(const Plate& plate) {
  std::string result = "<dl>\n";
  result += fact("mask", std::visit([](const auto& one) { return mask_html(one); }, plate.scheme),
                 std::holds_alternative<Scheme>(plate.scheme) ? "mask" : "");
  result += fact("sum rules", std::to_string(plate.sum_rules));
  result += fact("converges", why(plate.convergence));
  result += fact("Hölder exponent", holder_html(plate));
  if (plate.convergence.is_yes() && plate.sobolev)
    result += fact("Sobolev exponent", number_html(*plate.sobolev, places));
  if (plate.convergence.is_yes() && plate.derivatives >= 0)
    result += fact("continuous derivatives", fmt::format("{} proved", plate.derivatives));
  if (plate.convergence.is_yes()) result += fact("stable shifts", why(plate.stable));
  if (plate.largest_variance) result += fact("max <i>ψ</i>", number_html(*plate.largest_variance, places_of_variance));
  if (plate.mean_variance) {
    const std::string exact = to_text(*plate.mean_variance);
    constexpr std::size_t longest = 40;
    result += fact("mean of <i>ψ</i>", to_decimal(*plate.mean_variance, places, Rounding::nearest) +
                                           (exact.size() <= longest ? " = " + exact : ""));
  }
  return result + "</dl>\n";
}

std::string plate_html(const Plate& plate, const std::string& anchor) {
  std::string result = fmt::format(
      "<article class=plate id=\"{0}\">\n<h2><a href=\"#{0}\">{1}</a></h2>\n"
      "<p class=subtitle>{2}</p>\n",
      anchor, formats::html(plate.specification()), formats::html(plate.title()));
  if (!plate.key.empty())
    result += fmt::format("<p class=place>[{}] {}</p>\n", plate.key, formats::html(reference(plate.key)));
  result += facts(plate);
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
  return result + "</div>\n</article>\n";
}

std::string card(const Plate& plate, const std::string& anchor) {
  const bool drawn = plate.surface || std::ranges::any_of(plate.pictures, [](const PlatePicture& picture) {
                       return picture.name == "limit";
                     });
  return fmt::format("<li><a href=\"#{}\">{}<b>{}</b><small>{}{}</small></a></li>\n", anchor,
                     drawn ? formats::thumbnail(anchor + "-limit") : "<span class=none>no limits</span>",
                     formats::html(plate.specification()),
                     plate.convergence.is_no()    ? "diverges"
                     : plate.holder.lower         ? "Hölder " + number_html(plate.holder, places_of_card)
                     : plate.convergence.is_yes() ? "converges"
                                                  : "not decided",
                     plate.key.empty() ? "" : "<br>[" + plate.key + "]");
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
                            body);
}

}  // namespace subcert::reports
