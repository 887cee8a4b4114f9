#include "svg.hpp"

#include "date_ticks.hpp"
#include "html.hpp"
#include "signs.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace subcert::formats {
namespace {

using Point = std::pair<double, double>;

constexpr double width = 420, height = 260, left = 56, right = 12, top = 12, bottom = 30;
constexpr double room_of_label = 15;    // below for the name of x, above for that of y
constexpr double invisible = 1.0 / 40;  // pixels; readers zoom
constexpr double flat = 1e-4;           // relative heights below this are drawn as nothing
constexpr int positive_levels = 10, negative_levels = 3;
constexpr std::size_t colours = 6;  // --curve-1 ... of the style sheet

/// An axis and the part of it that is drawn; on a logarithmic one in powers of ten.
struct Axis {
  bool logarithmic = false;
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  double date_unit = 0;  // as in Panel

  double scaled(double value) const { return logarithmic ? std::log10(value) : value; }
  bool has(double value) const { return !logarithmic || value > 0; }
  void include(double value) {
    require(std::isfinite(value), "svg: need finite points, got {}", value);
    if (!has(value)) return;
    low = std::min(low, scaled(value));
    high = std::max(high, scaled(value));
  }
  void widen(double share) {
    const double least = std::max(std::abs(low), std::abs(high)) * flat;
    const double size = high - low > least ? high - low : least > 0 ? least : 1;
    const double more = share * size + std::max(0.0, size - (high - low)) / 2;
    low -= more;
    high += more;
  }
  /// For the script, behind its ends.
  std::string kind() const { return logarithmic ? " log" : date_unit > 0 ? fmt::format(" date {}", date_unit) : ""; }
  /// In parts of the length that is drawn.
  double place(double value) const { return (scaled(value) - low) / (high - low); }
};

/// The part of the plane that is drawn, and where it stands in the picture.
struct Frame {
  Axis across, up;
  double above = top, below = bottom;  ///< rooms

  static Frame around(const std::vector<Point>& points, Axis across = {}, Axis up = {}) {
    for (const auto& [x, y] : points)
      if (across.has(x) && up.has(y)) across.include(x), up.include(y);
    require(across.low <= across.high, "svg: need at least one point, got none");
    return {across, up};
  }
  /// Makes room so that a unit is as long on both axes.
  void equalise() {
    const double unit = std::min(drawn_width() / (across.high - across.low), drawn_height() / (up.high - up.low));
    const double x_more = drawn_width() / unit - (across.high - across.low);
    const double y_more = drawn_height() / unit - (up.high - up.low);
    across.low -= x_more / 2, across.high += x_more / 2, up.low -= y_more / 2, up.high += y_more / 2;
  }
  double drawn_width() const { return width - left - right; }
  double drawn_height() const { return height - above - below; }
  double x(double value) const { return left + across.place(value) * drawn_width(); }
  double y(double value) const { return height - below - up.place(value) * drawn_height(); }
  bool has(const Point& point) const { return across.has(point.first) && up.has(point.second); }
  Point operator()(const Point& point) const { return {x(point.first), y(point.second)}; }
};

/// Numbers on an axis, and how they are written.
struct Ticks {
  std::vector<double> values;
  int places = 0;
  bool powers = false;
  std::vector<std::string> dates = {};

  std::string text(std::size_t i) const {
    constexpr int most_places = 6;
    const double value = values[i];
    if (!dates.empty()) return dates[i];
    if (powers) return "10" + superscript(std::lround(std::log10(value)));
    return with_minus(places <= most_places ? fmt::format("{:.{}f}", value, places) : fmt::format("{:.2g}", value));
  }

 private:
  static std::string superscript(long exponent) {
    static const char* const digits[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                         "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    std::string text;
    for (const char c : std::to_string(exponent)) text += c == '-' ? "\u207b" : digits[c - '0'];
    return text;
  }
};

/// Multiples of 1, 2 or 5 times a power of ten, four to nine of them; powers of ten on a logarithmic axis that has two.
Ticks ticks(const Axis& axis) {
  constexpr double most_powers = 7;
  if (axis.date_unit > 0) {
    Ticks result;
    for (auto& [value, text] : date_ticks(axis.low, axis.high, axis.date_unit)) {
      result.values.push_back(value);
      result.dates.push_back(std::move(text));
    }
    return result;
  }
  if (axis.logarithmic && axis.high - axis.low >= 2) {
    Ticks result{{}, 0, true};
    const double step = std::ceil((axis.high - axis.low) / most_powers);
    for (double power = std::ceil(axis.low / step) * step; power <= axis.high; power += step)
      result.values.push_back(std::pow(10, power));
    return result;
  }
  const double low = axis.logarithmic ? std::pow(10, axis.low) : axis.low,
               high = axis.logarithmic ? std::pow(10, axis.high) : axis.high;
  const double rough = (high - low) / 5, unit = std::pow(10, std::floor(std::log10(rough)));
  const double step = unit * (rough / unit < 1.5 ? 1 : rough / unit < 3.5 ? 2 : rough / unit < 7.5 ? 5 : 10);
  Ticks result{{}, std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)))};
  for (double tick = std::ceil(low / step); tick * step <= high; ++tick)
    if (axis.has(tick * step)) result.values.push_back(tick * step + 0.0);
  return result;
}

double distance(const Point& p, const Point& a, const Point& b) {
  const double dx = b.first - a.first, dy = b.second - a.second, length = std::hypot(dx, dy);
  if (length == 0) return std::hypot(p.first - a.first, p.second - a.second);
  return std::abs(dx * (p.second - a.second) - dy * (p.first - a.first)) / length;
}

/// Those of the points that a line through them needs (Douglas and Peucker).
std::vector<Point> visible(const std::vector<Point>& points) {
  if (points.empty()) return {};
  std::vector<bool> kept(points.size(), false);
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  kept.front() = kept.back() = true;
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    std::size_t farthest = first;
    double most = invisible;
    for (std::size_t i = first + 1; i < last; ++i)
      if (const double d = distance(points[i], points[first], points[last]); d > most) most = d, farthest = i;
    if (farthest == first) continue;
    kept[farthest] = true;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
  std::vector<Point> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (kept[i]) result.push_back(points[i]);
  return result;
}

/// The steps of a path through the points.
std::string steps(const std::vector<Point>& points) {
  std::string result;
  for (const auto& [x, y] : visible(points)) result += fmt::format("{}{:.2f},{:.2f}", result.empty() ? 'M' : ' ', x, y);
  return result;
}

std::string axes(const Frame& frame, const std::string& x_label = "", const std::string& y_label = "") {
  const double floor = height - frame.below;
  std::string lines, texts;
  const Ticks across = ticks(frame.across), up = ticks(frame.up);
  for (std::size_t i = 0; i < across.values.size(); ++i) {
    const double tick = across.values[i];
    lines += fmt::format("M{0:.1f},{1}V{2}", frame.x(tick), frame.above, floor);
    texts += fmt::format("<text x=\"{:.1f}\" y=\"{}\">{}</text>", frame.x(tick), floor + 18, across.text(i));
  }
  for (std::size_t i = 0; i < up.values.size(); ++i) {
    const double tick = up.values[i];
    lines += fmt::format("M{0},{1:.1f}H{2}", left, frame.y(tick), width - right);
    texts += fmt::format("<text class=\"y\" x=\"{}\" y=\"{:.1f}\">{}</text>", left - 7, frame.y(tick) + 4, up.text(i));
  }
  std::string zero, labels;
  if (!frame.up.logarithmic && frame.up.low < 0 && frame.up.high > 0)
    zero = fmt::format("<path class=\"zero\" d=\"M{},{:.1f}H{}\"/>", left, frame.y(0), width - right);
  if (!x_label.empty())
    labels = fmt::format("<text class=\"x\" x=\"{}\" y=\"{}\">{}</text>", (left + width - right) / 2, height - 3,
                         with_minus(html(x_label)));
  if (!y_label.empty())
    labels += fmt::format("<text class=\"above\" x=\"{}\" y=\"11\">{}</text>", left - 7, with_minus(html(y_label)));
  return fmt::format(
      "<g class=\"axes\"><path class=\"grid\" d=\"{}\"/>{}<g class=\"ticks\">{}</g></g>"
      "<g class=\"labels\">{}</g>",
      lines, zero, texts, labels);
}

/// The picture; what moves when a reader zooms is clipped.
std::string picture(const std::string& title, const Frame& frame, const std::string& fixed, const std::string& moving,
                    const std::string& kind = "") {
  return fmt::format(
      "<svg class=\"picture{}\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\" data-across=\"{:.12g} {:.12g}{}\" "
      "data-up=\"{:.12g} {:.12g}{}\">{}<svg class=\"window\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" "
      "viewBox=\"{} {} {} {}\"><g class=\"moving\">{}</g></svg></svg>",
      kind, width, height, html(title), frame.across.low, frame.across.high, frame.across.kind(), frame.up.low,
      frame.up.high, frame.up.kind(), fixed, left, frame.above, frame.drawn_width(), frame.drawn_height(), left,
      frame.above, frame.drawn_width(), frame.drawn_height(), moving);
}

std::string id_attribute(const std::string& id) { return id.empty() ? "" : fmt::format(" id=\"{}\"", html(id)); }

/// A grid in which level lines are followed.
struct LevelLines {
  const DrawnSurface& surface;
  double sign;  // -1: of the function with the other sign

  double value(std::size_t i) const {
    const double z = surface.points[i][2];
    return std::isnan(z) ? 0 : sign * z;
  }
  /// Where the function has the level between two points.
  Point crossing(std::uint64_t edge, double level) const {
    const std::size_t count = surface.points.size(), a = edge / count, b = edge % count;
    const double t = (level - value(a)) / (value(b) - value(a));
    const auto between = [&](std::size_t c) {
      return surface.points[a][c] + t * (surface.points[b][c] - surface.points[a][c]);
    };
    return {between(0), between(1)};
  }
  /// The closed lines about the set where the function is at least `level`, piecewise linear on triangles.
  std::vector<std::vector<Point>> at(double level) const {
    const std::size_t count = surface.points.size(), columns = surface.columns;
    std::unordered_map<std::uint64_t, std::uint64_t> next;
    const auto triangle = [&](const std::array<std::size_t, 3>& corner) {
      std::uint64_t from = 0, to = 0;
      bool crossed = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t a = corner[k], b = corner[(k + 1) % 3];
        const bool inside = value(a) >= level;
        if (inside == (value(b) >= level)) continue;
        crossed = true;
        (inside ? from : to) = std::uint64_t{std::min(a, b)} * count + std::max(a, b);
      }
      if (crossed) next[from] = to;
    };
    for (std::size_t j = 0; j + 1 < surface.rows; ++j)
      for (std::size_t i = 0; i + 1 < columns; ++i) {
        const std::size_t a = j * columns + i, b = a + 1, c = b + columns, d = a + columns;
        triangle({a, b, c});
        triangle({a, c, d});
      }
    std::vector<std::vector<Point>> lines;
    while (!next.empty()) {
      lines.emplace_back();
      for (auto edge = next.begin(); edge != next.end();) {
        lines.back().push_back(crossing(edge->first, level));
        const std::uint64_t to = edge->second;
        next.erase(edge);
        edge = next.find(to);
      }
      lines.back().push_back(lines.back().front());
    }
    return lines;
  }
};

}  // namespace

namespace {

std::string colour_of(const std::string& colour) {
  return colour.empty() ? "" : fmt::format(" style=\"--colour:{}\"", html(colour));
}

/// What a reader is told of each point, where there is more to tell than a line through them shows.
std::string told_points(const Frame& frame, const Curve& curve) {
  constexpr std::size_t most = 3000;
  const bool seen_in_line = !curve.marked && curve.joined && curve.values.empty();
  if (seen_in_line || curve.points.size() > most) return "";
  nlohmann::json points = nlohmann::json::array();
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    if (!frame.has(curve.points[i])) continue;
    points.push_back({curve.points[i].first, curve.points[i].second});
    if (i < curve.values.size()) points.back().push_back(curve.values[i]);
  }
  return fmt::format(" data-points=\"{}\"", html(points.dump()));
}

std::string cells_of(const Frame& frame, const Cells& cells) {
  std::string path;
  for (const auto& [x_low, x_high, y_low, y_high] : cells.rectangles)
    path += fmt::format("M{:.2f},{:.2f}H{:.2f}V{:.2f}H{:.2f}Z", frame.x(x_low), frame.y(y_low), frame.x(x_high),
                        frame.y(y_high), frame.x(x_low));
  return fmt::format("<g class=\"series cells\" data-label=\"{}\" style=\"--colour:{}\"><path d=\"{}\"/></g>",
                     with_minus(html(cells.label)), html(cells.colour), path);
}

std::string band_of(const Frame& frame, const Band& band, std::size_t colour) {
  std::vector<Point> low, high;
  for (const auto& [x, least, most] : band.ends)
    if (frame.has({x, least}) && frame.has({x, most})) {
      low.push_back(frame({x, least}));
      high.push_back(frame({x, most}));
    }
  std::ranges::reverse(high);
  low.insert(low.end(), high.begin(), high.end());
  return fmt::format("<g class=\"series band colour-{}\" data-label=\"{}\"{}><path d=\"{}Z\"/></g>", colour,
                     with_minus(html(band.label)), colour_of(band.colour), steps(low));
}

std::string curve_of(const Frame& frame, const Curve& curve, std::size_t colour, const std::string& id) {
  std::vector<Point> points;
  for (const Point& point : curve.points)
    if (frame.has(point)) points.push_back(frame(point));
  std::string content;
  if (curve.joined)
    content += fmt::format("<path{} class=\"curve{}\" d=\"{}\"/>", id_attribute(id), curve.marked ? " thin" : "",
                           steps(points));
  if (curve.marked || !curve.joined) {
    std::string marks;
    for (const auto& [x, y] : points) marks += fmt::format("M{:.2f},{:.2f}h0", x, y);
    content += fmt::format("<path class=\"marks\" d=\"{}\"/>", marks);
  }
  return fmt::format("<g class=\"series colour-{}\" data-label=\"{}\"{}{}>{}</g>", colour,
                     with_minus(html(curve.label)), colour_of(curve.colour), told_points(frame, curve), content);
}

}  // namespace

std::string svg(const Panel& panel, const std::string& id) {
  std::vector<Point> all;
  for (const Curve& curve : panel.curves) all.insert(all.end(), curve.points.begin(), curve.points.end());
  for (const Band& band : panel.bands)
    for (const auto& [x, low, high] : band.ends) all.insert(all.end(), {{x, low}, {x, high}});
  for (const Cells& cells : panel.cells)
    for (const auto& [x_low, x_high, y_low, y_high] : cells.rectangles)
      all.insert(all.end(), {{x_low, y_low}, {x_high, y_high}});
  Frame frame = Frame::around(all, {panel.log_x}, {panel.log_y});
  frame.across.date_unit = panel.date_unit;
  const bool has_marks = std::ranges::any_of(panel.curves, [](const Curve& c) { return c.marked || !c.joined; });
  frame.across.widen(panel.equal_units ? 0.04 : has_marks ? 0.03 : 0);
  frame.up.widen(panel.cells.empty() ? 0.06 : 0);
  if (panel.equal_units) frame.equalise();
  if (!panel.equal_units && !panel.x_label.empty()) frame.below += room_of_label;
  if (!panel.equal_units && !panel.y_label.empty()) frame.above += room_of_label;
  std::string content;
  for (const Cells& cells : panel.cells) content += cells_of(frame, cells);
  for (std::size_t i = 0; i < panel.bands.size(); ++i) content += band_of(frame, panel.bands[i], i % colours + 1);
  for (std::size_t i = 0; i < panel.curves.size(); ++i)
    content += curve_of(frame, panel.curves[i], i % colours + 1, i == 0 ? id : "");
  return picture(panel.title, frame, panel.equal_units ? "" : axes(frame, panel.x_label, panel.y_label), content,
                 panel.equal_units ? " plane" : "");
}

namespace {

/// What the labels of cells, bands and curves are written as: an element with the classes `key` and those of the
/// colour.
std::string keys(const Panel& panel, const char* element) {
  std::string result;
  const auto add = [&](const std::string& label, const std::string& classes, const std::string& colour) {
    if (!label.empty()) result += fmt::format(fmt::runtime(element), classes, colour_of(colour), html(label));
  };
  for (const Cells& cells : panel.cells) add(cells.label, "cells", cells.colour);
  for (std::size_t i = 0; i < panel.bands.size(); ++i)
    add(panel.bands[i].label, fmt::format("band colour-{}", i % colours + 1), panel.bands[i].colour);
  for (std::size_t i = 0; i < panel.curves.size(); ++i)
    add(panel.curves[i].label, fmt::format("colour-{}", i % colours + 1), panel.curves[i].colour);
  return result;
}

}  // namespace

std::string legend(const Panel& panel) {
  const std::string result = keys(panel, "<button type=button class=\"key {}\" aria-pressed=true{}>{}</button>\n");
  return result.empty() ? "" : "<div class=legend>" + result + "</div>\n";
}

std::string preview(const Panel& panel) {
  Panel bare = panel;
  bare.y_label.clear();
  if (bare.title.empty())  // what is drawn is its name
    for (const Curve& curve : panel.curves)
      if (!curve.label.empty()) bare.title += (bare.title.empty() ? "" : ", ") + curve.label;
  const std::string text = svg(bare), names = keys(panel, "<span class=\"key {}\"{}>{}</span> ");
  return (panel.title.empty() ? "" : "<span class=above>" + html(panel.title) + "</span>") + "<svg class=\"preview" +
         text.substr(std::string("<svg class=\"picture").size()) +
         (names.empty() ? "" : "<span class=keys>" + names + "</span>");
}

std::string plot(const Panel& panel, const std::string& id) {
  return "<div class=plot>" + svg(panel, id) + legend(panel) + "</div>\n";
}

std::string panels_html(const Figure& figure) {
  std::string panels;
  for (const Panel& panel : figure.panels)
    panels += fmt::format("<div class=panel><h4>{}</h4>{}</div>\n", html(panel.title), plot(panel));
  return fmt::format("<div class=\"panels columns-{}\">\n{}</div>",
                     std::min(static_cast<std::size_t>(figure.columns), figure.panels.size()), panels);
}

std::string thumbnail(const std::string& id) {
  return fmt::format("<svg class=\"thumbnail\" viewBox=\"{} 0 {} {}\" aria-hidden=\"true\"><use href=\"#{}\"/></svg>",
                     left - 6, width - left - right + 12, height - bottom + top, html(id));
}

std::string svg(const DrawnSurface& surface, const std::string& id) {
  require(surface.heights, "svg: need a function over a grid, got another surface");
  double most = 0, least = 0;
  std::vector<Point> seen;
  for (const auto& [x, y, z] : surface.points)
    if (!std::isnan(z)) {
      most = std::max(most, z), least = std::min(least, z);
      seen.emplace_back(x, y);
    }
  Frame frame = Frame::around(seen);
  frame.equalise();
  std::string levels;
  const auto draw = [&](double sign, double extreme, int count, const char* colour) {
    for (int k = 1; k < count; ++k) {
      std::string path;
      for (std::vector<Point>& line : LevelLines{surface, sign}.at(extreme * k / count)) {
        std::ranges::transform(line, line.begin(), frame);
        // From a point far from the first one on, so that the line does not close to nothing.
        std::rotate(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(line.size() / 2), line.end());
        path += steps(line) + "Z";
      }
      if (!path.empty()) levels += fmt::format("<path class=\"level {}\" d=\"{}\"/>", colour, path);
    }
  };
  if (most > 0) draw(1, most, positive_levels, "above");
  if (least < 0) draw(-1, -least, negative_levels, "below");
  return picture(surface.title, frame, axes(frame), fmt::format("<g{}>{}</g>", id_attribute(id), levels), " plane");
}

}  // namespace subcert::formats
