#pragma once
/// Figures: data first, drawn by gnuplot as SVG and PNG, and as pages that readers touch.

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace subcert::formats {

struct Curve {
  std::string label;
  std::vector<std::pair<double, double>> points;
  bool marked = false;      ///< points with marks, as for a sequence over n
  bool joined = true;       ///< a line through the points; else marks alone
  std::string colour = {};  ///< as "#0b559f"; empty: by place in the panel
  std::vector<std::string> values =
      {};  ///< what a page tells of each point, as an exact number; empty: its coordinates
  double mark_size = 0.6;
};

/// What is enclosed: x, lower end, upper end.
struct Band {
  std::string label;
  std::vector<std::array<double, 3>> ends;
  std::string colour = {};
};

/// Rectangles x_low, x_high, y_low, y_high, filled; at least one.
struct Cells {
  std::string label;
  std::string colour;
  std::vector<std::array<double, 4>> rectangles;
};

struct Panel {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Curve> curves;
  bool log_y = false;
  std::string key = "top right";  ///< where gnuplot puts the legend
  bool equal_units = false;       ///< the same scale on both axes, as for curves in the plane
  bool log_x = false;
  std::vector<Cells> cells = {};  ///< under the curves
  std::vector<Band> bands = {};   ///< between them
  bool plain_texts = false;       ///< signs as _ and ^ in titles and names are no markup
  double height = 1;              ///< against other panels
  double date_unit = 0;           ///< x is a time from 1970 on, in units of so many seconds; 0: it is a number
};

/// The panel with at most some thousand points for each curve and band. Of a joined curve those that rise or fall most
/// stay among so many neighbours; of marks the hull, as a band. Curves whose points have values stay as they are.
Panel thinned(Panel panel);

/// Panels side by side, at most `columns` in a row.
struct Figure {
  std::string id;
  std::string title;
  std::string caption;
  int columns = 2;
  std::vector<Panel> panels;
};

/// Writes FOLDER/ID.svg, FOLDER/ID.png and FOLDER/ID.csv (panel, curve, x, y). Errors: throws missing_file where
/// gnuplot is missing or fails; the CSV file is written first.
void draw(const Figure& figure, const std::filesystem::path& folder);

/// A kind of picture that gnuplot draws.
struct PictureKind {
  std::string ending;    ///< of file names
  std::string terminal;  ///< of gnuplot
  std::string end;       ///< which a whole file has
  bool is_on_paper;      ///< measured in inches, not in pixels
  int scale = 1;         ///< pixels for each

  /// For gnuplot: `460,320`, or of these hundredths of an inch.
  std::string size(int width, int height) const;
  /// For gnuplot: numbers at axes with minus signs.
  std::string numbers() const;
  /// In quotes, as gnuplot reads strings; in pictures that LaTeX reads what it prints as this text.
  std::string quoted_text(const std::string& text) const;
  /// For gnuplot, behind `set title`: in as many lines as the width of a panel asks for, at most three, of which the
  /// last one may end in dots. Specifications have no markup, nor what is plain.
  std::string title(const std::string& text, bool plain = false) const;
};
const std::vector<PictureKind>& picture_kinds();
/// As people read them.
inline constexpr const char* picture_endings = ".svg, .png, .pdf, .tex (TikZ) or .html";

/// Whether pictures have the ending of this name.
bool is_picture_name(const std::filesystem::path& file);

/// Lets `plot` have gnuplot draw into the file that it is given, which then takes this name; gnuplot must have ended
/// when `plot` returns. Domain: an ending of picture_kinds(). Errors: throws a domain error for another ending;
/// missing_file where the file cannot be written, or gnuplot is missing or did not come to the end of the picture.
void write_picture(const std::filesystem::path& file,
                   const std::function<void(const PictureKind&, const std::filesystem::path&)>& plot);

/// Writes one picture, its kind by the ending. Errors: as write_picture().
void draw_file(const Figure& figure, const std::filesystem::path& file);

}  // namespace subcert::formats
