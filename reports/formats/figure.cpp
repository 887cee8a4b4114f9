#include "figure.hpp"

#include "date_ticks.hpp"
#include "gnuplot_text.hpp"
#include "html.hpp"
#include "paper_text.hpp"
#include "signs.hpp"
#include "svg.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <fmt/format.h>
#include <gnuplot-iostream.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numeric>
#include <span>
#include <sstream>

namespace subcert::formats {
namespace {

/// The hull of all cells, where the axes end.
std::string range_of(const std::vector<Cells>& cells) {
  std::array<double, 4> hull = cells.front().rectangles.front();
  for (const Cells& some : cells)
    for (const auto& [x_low, x_high, y_low, y_high] : some.rectangles)
      hull = {std::min(hull[0], x_low), std::max(hull[1], x_high), std::min(hull[2], y_low), std::max(hull[3], y_high)};
  std::ostringstream text;
  text << "set xrange [" << hull[0] << ":" << hull[1] << "]\nset yrange [" << hull[2] << ":" << hull[3] << "]\n";
  return text.str();
}

constexpr const char* panel_colours[] = {"#0b559f", "#c0392b", "#1e8449", "#7d3c98", "#b9770e", "#117a8b"};

/// Where a panel stands, in parts of the whole.
struct Place {
  double left;
  double bottom;
  double height;
};

/// Rows from the top, each as high as its highest panel; `height`: of all together.
std::vector<Place> places_of(const Figure& figure, std::size_t columns, double& height) {
  std::vector<double> heights((figure.panels.size() + columns - 1) / columns, 0);
  for (std::size_t i = 0; i < figure.panels.size(); ++i)
    heights[i / columns] = std::max(heights[i / columns], figure.panels[i].height);
  height = std::accumulate(heights.begin(), heights.end(), 0.0);
  std::vector<Place> places;
  double above = 0;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const double own = heights[i / columns];
    places.push_back(
        {static_cast<double>(i % columns) / static_cast<double>(columns), 1 - (above + own) / height, own / height});
    if (i % columns + 1 == columns) above += own;
  }
  return places;
}

constexpr int panel_width = 460, panel_height = 320;  // in pixels

const std::string automatic_tics = "set xtics autofreq\nset ytics autofreq\n";

/// Of axes with one scale: with one step, and so that the numbers of a narrow picture do not meet.
std::string equal_tics(const Panel& panel) {
  constexpr double inner_width = 0.8 * panel_width, inner_height = 0.65 * panel_height, least_gap = 45;  // in pixels
  double low_x = HUGE_VAL, high_x = -HUGE_VAL, low_y = HUGE_VAL, high_y = -HUGE_VAL;
  for (const Curve& curve : panel.curves)
    for (const auto& [x, y] : curve.points) {
      low_x = std::min(low_x, x), high_x = std::max(high_x, x);
      low_y = std::min(low_y, y), high_y = std::max(high_y, y);
    }
  const double unit = std::max((high_x - low_x) / inner_width, (high_y - low_y) / inner_height);  // of a pixel
  if (!(unit > 0) || !std::isfinite(unit)) return automatic_tics;
  const double least = least_gap * unit, power = std::pow(10, std::floor(std::log10(least)));
  const double step = power * (least <= power ? 1 : least <= 2 * power ? 2 : least <= 5 * power ? 5 : 10);
  return fmt::format("set xtics {0}\nset ytics {0}\n", step);
}

/// The parts of the command plot, in the order in which their points are sent.
std::vector<std::string> drawn_parts(const Panel& panel, const PictureKind& kind) {
  std::vector<std::string> parts;
  const std::string plain = panel.plain_texts ? " noenhanced" : "";
  const auto titled = [&](const std::string& label) {
    return label.empty() ? std::string(" notitle") : " title " + kind.quoted_text(label) + plain;
  };
  for (const Cells& cells : panel.cells)
    parts.push_back("'-' using (($1+$2)/2):(($3+$4)/2):1:2:3:4 with boxxyerror fs solid noborder lc rgb " +
                    quoted(cells.colour) + titled(cells.label));
  for (std::size_t i = 0; i < panel.bands.size(); ++i)
    parts.push_back(
        "'-' using 1:2:3 with filledcurves fs transparent solid 0.3 noborder lc rgb " +
        quoted(panel.bands[i].colour.empty() ? panel_colours[i % std::size(panel_colours)] : panel.bands[i].colour) +
        titled(panel.bands[i].label));
  for (const Curve& curve : panel.curves)
    parts.push_back(std::string("'-' with ") +
                    (!curve.joined  ? "points"
                     : curve.marked ? "linespoints"
                                    : "lines") +
                    (curve.colour.empty() ? "" : " lc rgb " + quoted(curve.colour)) +
                    (curve.marked ? fmt::format(" ps {:.2g}", curve.mark_size) : "") + titled(curve.label));
  return parts;
}

/// Dates where x is one.
std::string date_tics(const Panel& panel) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Curve& curve : panel.curves)
    for (const auto& [x, y] : curve.points) low = std::min(low, x), high = std::max(high, x);
  for (const Band& band : panel.bands)
    for (const auto& [x, lower, upper] : band.ends) low = std::min(low, x), high = std::max(high, x);
  if (!(low < high)) return automatic_tics;
  std::string text;
  for (const auto& [x, label] : date_ticks(low, high, panel.date_unit))
    text += fmt::format("{}{} {:.17g}", text.empty() ? "" : ", ", quoted(label), x);
  return automatic_tics + "set xtics (" + text + ")\n";
}

/// For gnuplot: what stands at the axes.
std::string tics_of(const Panel& panel) {
  return panel.date_unit > 0 ? date_tics(panel) : panel.equal_units ? equal_tics(panel) : automatic_tics;
}

void plot_panel(Gnuplot& gnuplot, const Panel& panel, const PictureKind& kind) {
  const std::string plain = panel.plain_texts ? " noenhanced" : "";
  gnuplot << "set title " << kind.title(panel.title, panel.plain_texts) << "\nset xlabel "
          << kind.quoted_text(panel.x_label) << plain << "\nset ylabel " << kind.quoted_text(panel.y_label) << plain
          << "\nset key " << panel.key << "\n"
          << tics_of(panel)
          << (panel.log_y
                  ? fmt::format("set logscale y\nset format y '{0}10^{{%T}}{0}'\n", kind.ending == ".tex" ? "$" : "")
                  : "unset logscale y\n" + kind.numbers())
          << (panel.log_x ? "set logscale x\n" : "unset logscale x\n")
          << (panel.equal_units ? "set autoscale noextend\nset offsets graph 0.03, graph 0.03, graph 0.03, graph 0.03\n"
              : panel.cells.empty() ? "set autoscale\nset offsets graph 0, graph 0, graph 0.08, graph 0.03\n"
                                    : "set offsets 0, 0, 0, 0\n" + range_of(panel.cells))
          << "plot ";
  const std::vector<std::string> parts = drawn_parts(panel, kind);
  for (std::size_t i = 0; i < parts.size(); ++i) gnuplot << (i ? ", " : "") << parts[i];
  gnuplot << "\n";
  for (const Cells& cells : panel.cells) gnuplot.send1d(cells.rectangles);
  for (const Band& band : panel.bands) gnuplot.send1d(band.ends);
  for (const Curve& curve : panel.curves) gnuplot.send1d(curve.points);
}

constexpr std::size_t most_drawn = 4000, drawn_blocks = 1000;

/// Calls take(begin, end) for blocks of about as many numbers.
template <class Take>
void for_blocks(std::size_t count, const Take& take) {
  for (std::size_t b = 0; b < drawn_blocks; ++b) take(b * count / drawn_blocks, (b + 1) * count / drawn_blocks);
}

using Points = std::vector<std::pair<double, double>>;

/// The ends of each block, and those of its points that lie farthest to each side.
Points extremes(const Points& points) {
  Points result;
  for_blocks(points.size(), [&](std::size_t begin, std::size_t end) {
    std::array<std::size_t, 6> kept{begin, begin, begin, begin, begin, end - 1};
    for (std::size_t i = begin; i < end; ++i) {
      if (points[i].first < points[kept[1]].first) kept[1] = i;
      if (points[i].first > points[kept[2]].first) kept[2] = i;
      if (points[i].second < points[kept[3]].second) kept[3] = i;
      if (points[i].second > points[kept[4]].second) kept[4] = i;
    }
    std::ranges::sort(kept);
    for (const std::size_t i : std::span(kept.begin(), std::unique(kept.begin(), kept.end())))
      result.push_back(points[i]);
  });
  return result;
}

/// The hull of each block, over its whole width.
std::vector<std::array<double, 3>> hulls(const std::vector<std::array<double, 3>>& ends) {
  std::vector<std::array<double, 3>> result;
  for_blocks(ends.size(), [&](std::size_t begin, std::size_t end) {
    double lower = ends[begin][1], upper = ends[begin][2];
    for (std::size_t i = begin; i < end; ++i) lower = std::min(lower, ends[i][1]), upper = std::max(upper, ends[i][2]);
    result.push_back({ends[begin][0], lower, upper});
    result.push_back({ends[end - 1][0], lower, upper});
  });
  return result;
}

void plot(const Figure& figure, const PictureKind& kind, const std::filesystem::path& target) {
  Gnuplot gnuplot(gnuplot_command);
  const std::size_t columns = std::min(static_cast<std::size_t>(figure.columns), figure.panels.size());
  double height = 0;
  const std::vector<Place> places = places_of(figure, columns, height);
  gnuplot << "set encoding utf8\n"
          << kind.numbers() << "set terminal " << kind.terminal << " size "
          << kind.size(panel_width * static_cast<int>(columns), static_cast<int>(std::lround(panel_height * height)))
          << "\n"
          << "set output " << quoted(target.string()) << "\n"
          << "set border 3 lc rgb '#555555'\nset tics nomirror textcolor rgb '#333333'\n"
          << "set grid lc rgb '#dddddd' lt 1\n";
  for (std::size_t i = 0; i < std::size(panel_colours); ++i)
    gnuplot << "set linetype " << i + 1 << " lc rgb '" << panel_colours[i] << "' lw 2 pt 7 ps 0.6\n";
  // Panels that stand under each other have the same margins.
  if (columns == 1 && figure.panels.size() > 1) gnuplot << "set lmargin at screen 0.19\nset rmargin at screen 0.94\n";
  gnuplot << "set multiplot\n";
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    gnuplot << "set origin " << places[i].left << "," << places[i].bottom << "\nset size "
            << (figure.panels[i].equal_units ? "ratio -1 " : "noratio ") << 1.0 / static_cast<double>(columns) << ","
            << places[i].height << "\n";
    plot_panel(gnuplot, thinned(figure.panels[i]), kind);
  }
  gnuplot << "unset multiplot\nunset output\n";
  gnuplot.flush();
}

/// gnuplot does not say that it could not write, but all formats have an end. Devices are not read.
bool is_whole_picture(const std::filesystem::path& file, std::string_view end_mark) {
  if (!std::filesystem::is_regular_file(file)) return std::filesystem::exists(file);
  constexpr std::streamoff longest_end = 64;
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(0, std::ios::end);
  const std::streamoff length = std::min(longest_end, static_cast<std::streamoff>(stream.tellg()));
  std::string end(static_cast<std::size_t>(std::max<std::streamoff>(length, 0)), ' ');
  stream.seekg(-length, std::ios::end);
  stream.read(end.data(), length);
  return stream && end.find(end_mark) != std::string::npos;
}

}  // namespace

void draw(const Figure& figure, const std::filesystem::path& folder) {
  std::ostringstream csv;
  csv.precision(12);
  csv << "panel,curve,x,y\n";
  for (const Panel& panel : figure.panels)
    for (const Curve& curve : panel.curves)
      for (const auto& [x, y] : curve.points)
        csv << '"' << panel.title << "\",\"" << curve.label << "\"," << x << ',' << y << '\n';
  runtime::write_file(folder / (figure.id + ".csv"), csv.str());
  for (const char* ending : {".svg", ".png"}) draw_file(figure, folder / (figure.id + ending));
}

const std::vector<PictureKind>& picture_kinds() {
  static const std::vector<PictureKind> kinds{
      {".svg", "svg font 'DejaVu Sans,12' background rgb 'white'", "</svg>", false},
      {".png", "pngcairo font 'DejaVu Sans,11' fontscale 2 linewidth 2 pointscale 2", "IEND", false, 2},
      {".pdf", "pdfcairo font 'DejaVu Sans,11'", "%%EOF", true},
      {".tex", "tikz", "\\end{tikzpicture}", true},
  };
  return kinds;
}

std::string PictureKind::size(int width, int height) const {
  if (!is_on_paper) return fmt::format("{},{}", scale * width, scale * height);
  return fmt::format("{:.2f}in,{:.2f}in", width / 100.0, height / 100.0);
}

std::string PictureKind::numbers() const {
  return ending == ".tex" ? "set format '$%g$'\n" : "set minussign\nset format '%g'\n";
}

std::string PictureKind::quoted_text(const std::string& text) const {
  return quoted(ending == ".tex" ? latex_text(text) : with_minus(text));
}

std::string PictureKind::title(const std::string& text, bool plain) const {
  constexpr std::size_t width = 56, most_lines = 3;
  std::string lines, rest = text;
  const auto whole = [&](std::size_t at) {  // not within a character of UTF-8
    while (at > 1 && (static_cast<unsigned char>(rest[at]) & 0xC0U) == 0x80) --at;
    return at;
  };
  for (std::size_t line = 1; !rest.empty() || line == 1; ++line) {
    std::size_t stop = rest.size();
    if (stop > width) {
      // Behind a sign that parts, else in the middle of what has none.
      const std::size_t sign = rest.find_last_of(" ,;", width - 1);
      stop = sign == std::string::npos ? whole(width) : sign + 1;
      if (line == most_lines) {
        rest = rest.substr(0, whole(width - 3)) + "...";
        stop = rest.size();
      }
    }
    const std::string quoted_line = quoted_text(rest.substr(0, stop));
    lines += (lines.empty() ? "" : "\\n") + quoted_line.substr(1, quoted_line.size() - 2);
    rest.erase(0, stop);
  }
  const std::size_t colon = text.find(':');
  const bool is_specification = text.find('@') != std::string::npos ||
                                (colon != std::string::npos && text.substr(colon + 1, 1) != " ");
  return '"' + lines + '"' + (plain || is_specification ? " noenhanced" : "");
}

bool is_picture_name(const std::filesystem::path& file) {
  return file.extension() == ".html" ||
         std::ranges::count(picture_kinds(), file.extension().string(), &PictureKind::ending) > 0;
}

void write_picture(const std::filesystem::path& file,
                   const std::function<void(const PictureKind&, const std::filesystem::path&)>& plot) {
  const auto kind = std::ranges::find(picture_kinds(), file.extension().string(), &PictureKind::ending);
  require(kind != picture_kinds().end(), "write_picture: need a name that ends in {}, got {}", picture_endings,
          file.string());
  runtime::write_file_with(file, [&](const std::filesystem::path& target) {
    plot(*kind, target);
    if (!is_whole_picture(target, kind->end))
      fail(ErrorKind::missing_file,
           "cannot write {}: gnuplot did not draw it to its end (is gnuplot installed? is the "
           "disk full?)",
           file.string());
  });
}

Panel thinned(Panel panel) {
  std::vector<Band> clouds;
  for (Curve& curve : panel.curves) {
    if (curve.points.size() <= most_drawn || !curve.values.empty()) continue;
    if (curve.joined) {
      curve.points = extremes(curve.points);
      continue;
    }
    std::ranges::sort(curve.points);
    Band& cloud = clouds.emplace_back(Band{curve.label + ", lowest to highest", {}, curve.colour});
    for (const auto& [x, y] : curve.points) cloud.ends.push_back({x, y, y});
    curve.points.clear();
  }
  std::erase_if(panel.curves, [](const Curve& curve) { return curve.points.empty(); });
  panel.bands.insert(panel.bands.begin(), std::make_move_iterator(clouds.begin()),
                     std::make_move_iterator(clouds.end()));
  for (Band& band : panel.bands)
    if (band.ends.size() > most_drawn) band.ends = hulls(band.ends);
  return panel;
}

void draw_file(const Figure& figure, const std::filesystem::path& file) {
  if (file.extension() == ".html") {
    Figure bounded = figure;
    for (Panel& panel : bounded.panels) panel = thinned(std::move(panel));
    return runtime::write_file(file, html_page(html(figure.title), panels_html(bounded)));
  }
  write_picture(file,
                [&](const PictureKind& kind, const std::filesystem::path& target) { plot(figure, kind, target); });
}

}  // namespace subcert::formats
