#include "svg.hpp"

#include "html.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace subcert::formats {
namespace {

using Point = std::pair<double, double>;

constexpr double width = 420, height = 260, left = 56, right = 12, top = 12, bottom = 30;
constexpr double invisible = 1.0 / 6;  // pixels
constexpr double flat = 1e-4;          // relative heights below this are drawn as nothing
constexpr int positive_levels = 10, negative_levels = 3;

/// The part of the plane that is drawn, and where it stands in the picture.
struct Frame {
  double x_low, x_high, y_low, y_high;

  static Frame around(const std::vector<Point>& points) {
    constexpr double most = std::numeric_limits<double>::max();
    Frame frame{most, -most, most, -most};
    for (const auto& [x, y] : points) {
      require(std::isfinite(x) && std::isfinite(y), "svg: need finite points, got {}, {}", x, y);
      frame = {std::min(frame.x_low, x), std::max(frame.x_high, x), std::min(frame.y_low, y),
               std::max(frame.y_high, y)};
    }
    require(!points.empty(), "svg: need at least one point, got none");
    return frame;
  }
  void widen(double share_x, double share_y) {
    const auto grow = [](double& low, double& high, double share) {
      const double least = std::max(std::abs(low), std::abs(high)) * flat;
      const double size = high - low > least ? high - low : least > 0 ? least : 1;
      const double more = share * size + std::max(0.0, size - (high - low)) / 2;
      low -= more;
      high += more;
    };
    grow(x_low, x_high, share_x);
    grow(y_low, y_high, share_y);
  }
  /// Makes room so that a unit is as long on both axes.
  void equalise() {
    const double x_unit = (width - left - right) / (x_high - x_low),
                 y_unit = (height - top - bottom) / (y_high - y_low);
    const double unit = std::min(x_unit, y_unit);
    const double x_more = (width - left - right) / unit - (x_high - x_low);
    const double y_more = (height - top - bottom) / unit - (y_high - y_low);
    x_low -= x_more / 2, x_high += x_more / 2, y_low -= y_more / 2, y_high += y_more / 2;
  }
  double x(double value) const { return left + (value - x_low) / (x_high - x_low) * (width - left - right); }
  double y(double value) const {
    return height - bottom - (value - y_low) / (y_high - y_low) * (height - top - bottom);
  }
  Point operator()(const Point& point) const { return {x(point.first), y(point.second)}; }
};

/// Numbers on an axis, and how they are written.
struct Ticks {
  std::vector<double> values;
  int places;

  std::string text(double value) const {
    constexpr int most_places = 6;
    return places <= most_places ? fmt::format("{:.{}f}", value, places) : fmt::format("{:.2g}", value);
  }
};

/// Multiples of 1, 2 or 5 times a power of ten, four to nine of them.
Ticks ticks(double low, double high) {
  const double rough = (high - low) / 5, unit = std::pow(10, std::floor(std::log10(rough)));
  const double step = unit * (rough / unit < 1.5 ? 1 : rough / unit < 3.5 ? 2 : rough / unit < 7.5 ? 5 : 10);
  Ticks result{{}, std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)))};
  for (double tick = std::ceil(low / step); tick * step <= high; ++tick) result.values.push_back(tick * step + 0.0);
  return result;
}

double distance(const Point& p, const Point& a, const Point& b) {
  const double dx = b.first - a.first, dy = b.second - a.second, length = std::hypot(dx, dy);
  if (length == 0) return std::hypot(p.first - a.first, p.second - a.second);
  return std::abs(dx * (p.second - a.second) - dy * (p.first - a.first)) / length;
}

/// Those of the points that a line through them needs (Douglas and Peucker).
std::vector<Point> visible(const std::vector<Point>& points) {
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
  for (const auto& [x, y] : visible(points)) result += fmt::format("{}{:.1f},{:.1f}", result.empty() ? 'M' : ' ', x, y);
  return result;
}

std::string axes(const Frame& frame) {
  std::string lines, texts;
  const Ticks across = ticks(frame.x_low, frame.x_high), up = ticks(frame.y_low, frame.y_high);
  for (const double tick : across.values) {
    lines += fmt::format("M{0:.1f},{1}V{2}", frame.x(tick), top, height - bottom);
    texts += fmt::format("<text x=\"{:.1f}\" y=\"{}\">{}</text>", frame.x(tick), height - bottom + 18,
                         across.text(tick));
  }
  for (const double tick : up.values) {
    lines += fmt::format("M{0},{1:.1f}H{2}", left, frame.y(tick), width - right);
    texts += fmt::format("<text class=\"y\" x=\"{}\" y=\"{:.1f}\">{}</text>", left - 7, frame.y(tick) + 4,
                         up.text(tick));
  }
  std::string zero;
  if (frame.y_low < 0 && frame.y_high > 0)
    zero = fmt::format("<path class=\"zero\" d=\"M{},{:.1f}H{}\"/>", left, frame.y(0), width - right);
  return fmt::format("<path class=\"grid\" d=\"{}\"/>{}<g class=\"ticks\">{}</g>", lines, zero, texts);
}

std::string picture(const std::string& title, const std::string& content) {
  return fmt::format("<svg class=\"picture\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">{}</svg>", width,
                     height, html(title), content);
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

std::string svg(const Panel& panel, const std::string& id) {
  std::vector<Point> all;
  for (const Curve& curve : panel.curves) all.insert(all.end(), curve.points.begin(), curve.points.end());
  Frame frame = Frame::around(all);
  frame.widen(panel.equal_units ? 0.04 : 0, 0.06);
  if (panel.equal_units) frame.equalise();
  std::string content = panel.equal_units ? "" : axes(frame);
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    const Curve& curve = panel.curves[i];
    std::vector<Point> points;
    std::ranges::transform(curve.points, std::back_inserter(points), frame);
    if (points.empty()) continue;
    if (curve.joined)
      content += fmt::format("<path{} class=\"curve curve-{}{}\" d=\"{}\"/>", i == 0 ? id_attribute(id) : "", i + 1,
                             curve.marked ? " thin" : "", steps(points));
    if (curve.marked)
      for (const auto& [x, y] : points)
        content += fmt::format("<circle class=\"mark mark-{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.6\"/>", i + 1, x, y);
  }
  return picture(panel.title, content);
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
  return picture(surface.title, axes(frame) + fmt::format("<g{}>{}</g>", id_attribute(id), levels));
}

}  // namespace subcert::formats
