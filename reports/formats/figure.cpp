#include "figure.hpp"

#include "gnuplot_text.hpp"
#include "html.hpp"
#include "paper_text.hpp"
#include "svg.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <gnuplot-iostream.h>

#include <algorithm>
#include <fstream>
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

void plot(const Figure& figure, const PictureKind& kind, const std::filesystem::path& target) {
  Gnuplot gnuplot(gnuplot_command);
  const auto count = static_cast<int>(figure.panels.size());
  const int columns = std::min(figure.columns, count), rows = (count + columns - 1) / columns;
  gnuplot << "set encoding utf8\nset terminal " << kind.terminal << " size " << kind.size(460 * columns, 320 * rows)
          << "\n"
          << "set output " << quoted(target.string()) << "\n"
          << "set border 3 lc rgb '#555555'\nset tics nomirror textcolor rgb '#333333'\n"
          << "set grid lc rgb '#dddddd' lt 1\n";
  const char* colours[] = {"#0b559f", "#c0392b", "#1e8449", "#7d3c98", "#b9770e", "#117a8b"};
  for (std::size_t i = 0; i < std::size(colours); ++i)
    gnuplot << "set linetype " << i + 1 << " lc rgb '" << colours[i] << "' lw 2 pt 7 ps 0.6\n";
  gnuplot << "set multiplot layout " << rows << "," << columns << "\n";
  for (const Panel& panel : figure.panels) {
    gnuplot << "set title " << kind.quoted_text(panel.title) << "\nset xlabel " << kind.quoted_text(panel.x_label)
            << "\nset ylabel " << kind.quoted_text(panel.y_label) << "\nset key " << panel.key << "\n"
            << (panel.log_y
                    ? fmt::format("set logscale y\nset format y '{0}10^{{%T}}{0}'\n", kind.ending == ".tex" ? "$" : "")
                    : std::string("unset logscale y\nset format y '%g'\n"))
            << (panel.log_x ? "set logscale x\n" : "unset logscale x\n")
            << (panel.equal_units ? "set size ratio -1\n" : "set size noratio\n")
            << (panel.cells.empty() ? "set autoscale\nset offsets graph 0, graph 0, graph 0.08, graph 0.03\n"
                                    : "set offsets 0, 0, 0, 0\n" + range_of(panel.cells))
            << "plot ";
    std::vector<std::string> parts;
    const auto titled = [&](const std::string& label) {
      return label.empty() ? std::string(" notitle") : " title " + kind.quoted_text(label);
    };
    for (const Cells& cells : panel.cells)
      parts.push_back("'-' using (($1+$2)/2):(($3+$4)/2):1:2:3:4 with boxxyerror fs solid noborder lc rgb " +
                      quoted(cells.colour) + titled(cells.label));
    for (std::size_t i = 0; i < panel.bands.size(); ++i)
      parts.push_back("'-' using 1:2:3 with filledcurves fs transparent solid 0.2 noborder lc rgb " +
                      quoted(panel.bands[i].colour.empty() ? colours[i % std::size(colours)] : panel.bands[i].colour) +
                      titled(panel.bands[i].label));
    for (const Curve& curve : panel.curves)
      parts.push_back(std::string("'-' with ") +
                      (!curve.joined  ? "points"
                       : curve.marked ? "linespoints"
                                      : "lines") +
                      (curve.colour.empty() ? "" : " lc rgb " + quoted(curve.colour)) + titled(curve.label));
    for (std::size_t i = 0; i < parts.size(); ++i) gnuplot << (i ? ", " : "") << parts[i];
    gnuplot << "\n";
    for (const Cells& cells : panel.cells) gnuplot.send1d(cells.rectangles);
    for (const Band& band : panel.bands) gnuplot.send1d(band.ends);
    for (const Curve& curve : panel.curves) gnuplot.send1d(curve.points);
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
      {".png", "pngcairo font 'DejaVu Sans,11'", "IEND", false},
      {".pdf", "pdfcairo font 'DejaVu Sans,11'", "%%EOF", true},
      {".tex", "tikz", "\\end{tikzpicture}", true},
  };
  return kinds;
}

std::string PictureKind::size(int width, int height) const {
  if (!is_on_paper) return fmt::format("{},{}", width, height);
  return fmt::format("{:.2f}in,{:.2f}in", width / 100.0, height / 100.0);
}

std::string PictureKind::quoted_text(const std::string& text) const {
  return quoted(ending == ".tex" ? latex_text(text) : text);
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

void draw_file(const Figure& figure, const std::filesystem::path& file) {
  if (file.extension() == ".html") return runtime::write_file(file, html_page(html(figure.title), panels_html(figure)));
  write_picture(file,
                [&](const PictureKind& kind, const std::filesystem::path& target) { plot(figure, kind, target); });
}

}  // namespace subcert::formats
