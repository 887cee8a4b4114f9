#pragma once
/// Pictures inside pages: SVG with the colours of html_page(), which follow the reader's choice of light or dark.

#include "figure.hpp"
#include "surface_figure.hpp"

#include <string>

namespace subcert::formats {

/// The axes of a panel with its cells, bands and curves, in this order; points less than a fortieth of a pixel off a
/// line are left out, and what is not positive on a logarithmic axis. The title is for those who cannot see. The page's
/// script lets readers zoom, move, and read the points of curves; `id`, where given, names the first curve for
/// thumbnail(). Domain: at least one point, all finite.
std::string svg(const Panel& panel, const std::string& id = "");

/// The labels of cells, bands and curves, which the page's script makes switches; nothing where there are none.
std::string legend(const Panel& panel);

/// The picture small, its title above and its labels below, for the eye alone.
std::string preview(const Panel& panel);

/// The picture with its legend.
std::string plot(const Panel& panel, const std::string& id = "");

/// The curve with this id of a picture on the same page, small.
std::string thumbnail(const std::string& id);

/// The panels of a figure with their titles and legends, side by side where there is room.
std::string panels_html(const Figure& figure);

/// A function that vanishes outside of the grid: the sets where it is at least k/10 of its maximum, k = 1, ..., 9, one
/// over the other, and in another colour those where it is at most k/3 of a negative minimum, k = 1, 2. Domain:
/// heights; where they are no numbers the function is 0. Cost: linear in the points for each level.
std::string svg(const DrawnSurface& surface, const std::string& id = "");

}  // namespace subcert::formats
