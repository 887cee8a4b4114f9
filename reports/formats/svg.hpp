#pragma once
/// Pictures inside pages: SVG with the colours of html_page(), which follow the reader's choice of light or dark.

#include "figure.hpp"
#include "surface_figure.hpp"

#include <string>

namespace subcert::formats {

/// The axes of a panel and its curves; points less than a sixth of a pixel off a line are left out. The i-th curve has
/// the colour --curve-i, marked and joined ones are thin. Of the panel the title is for those who cannot see; labels,
/// legend and cells are left to the page. `id`, where given, names the first curve for thumbnail(). Domain: at least
/// one point, all finite.
std::string svg(const Panel& panel, const std::string& id = "");

/// The curve with this id of a picture on the same page, small.
std::string thumbnail(const std::string& id);

/// A function that vanishes outside of the grid: the sets where it is at least k/10 of its maximum, k = 1, ..., 9, one
/// over the other, and in another colour those where it is at most k/3 of a negative minimum, k = 1, 2. Domain:
/// heights; where they are no numbers the function is 0. Cost: linear in the points for each level.
std::string svg(const DrawnSurface& surface, const std::string& id = "");

}  // namespace subcert::formats
