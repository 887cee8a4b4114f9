#include "gallery.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/regularity/regularity.hpp>
#include <subcert/analysis/regularity/sobolev.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/analysis/variance/variance_range.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/proofs-checks/certificates/scheme_regularity.hpp>
#include <subcert/reports/facts/regularity_facts.hpp>
#include <subcert/reports/formats/html.hpp>
#include <subcert/reports/formats/limit_figure.hpp>
#include <subcert/schemes/data/refine/refine.hpp>
#include <subcert/schemes/data/scheme_refinement.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace subcert::reports {
namespace {

constexpr int levels_of_norms = 16, most_derivatives = 4;
constexpr long most_coefficients = 250;  // of masks with a variance curve
constexpr double variance_points = 600, points_of_polygon = 1500;
constexpr double sobolev_share = 0.3, smoothness_share = 0.5, variance_seconds = 2;

/// Corners of the sample polygons: a cross, and a meander.
constexpr std::array<std::pair<int, int>, 12> closed_corners{
    {{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}}};
constexpr std::array<std::pair<int, int>, 13> open_corners{
    {{0, 0}, {0, 1}, {0, 2}, {1, 2}, {1, 1}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {3, 2}, {3, 1}, {3, 0}, {4, 0}}};

/// Every edge in so many parts that the polygon has three times the points that rules read at once.
data::GridData<double> sample_polygon(std::size_t window, bool open) {
  const std::vector<std::pair<int, int>> corners = open ? std::vector(open_corners.begin(), open_corners.end())
                                                        : std::vector(closed_corners.begin(), closed_corners.end());
  const std::size_t edges = corners.size() - (open ? 1 : 0), parts = (3 * window + edges - 1) / edges;
  std::vector<double> values;
  for (std::size_t i = 0; i < edges * parts + (open ? 1 : 0); ++i) {
    const auto& [x, y] = corners[i / parts];
    const auto& [next_x, next_y] = corners[(i / parts + 1) % corners.size()];
    const double t = static_cast<double>(i % parts) / static_cast<double>(parts);
    values.push_back(x + t * (next_x - x));
    values.push_back(y + t * (next_y - y));
  }
  return data::curve_data(std::move(values), 2, !open);
}

/// How many steps of this factor lead from one number to at most another.
int steps_between(double from, double to, int factor) {
  return std::max(1, static_cast<int>(std::log(to / from) / std::log(factor)));
}

PlatePicture polygon_picture(const Scheme& scheme, bool open) {
  const std::size_t window = data::fewest_points(scheme, data::Boundary::regression).front();
  const data::GridData<double> polygon = sample_polygon(window, open);
  const int levels = steps_between(static_cast<double>(polygon.points()), points_of_polygon, scheme.mask.arity());
  const data::GridData<double> refined = data::refine(polygon, AnyScheme(scheme), {levels});
  formats::Curve corners = formats::data_curve(polygon, "polygon", true);
  corners.marked = true;
  formats::Panel panel{
      "A polygon and its refinement", "", "", {formats::data_curve(refined, "refined", true), corners}};
  panel.equal_units = true;
  return {"polygon",
          fmt::format("{} polygon with {} points, refined {} times", open ? "An open" : "A closed", polygon.points(),
                      levels),
          std::move(panel)};
}

PlatePicture variance_picture(const Mask& mask) {
  const VarianceGrid grid = variance_grid(mask, steps_between(1, variance_points, mask.arity()), false);
  formats::Curve curve{"", {}};
  for (std::size_t i = 0; i < grid.values.size(); ++i)
    curve.points.emplace_back((grid.step() * Rational(i)).convert_to<double>(), grid.values[i].convert_to<double>());
  return {"variance",
          "<i>ψ</i>, the variance of the limit for data with noise of variance 1",
          {"The variance curve", "x", "", {curve}}};
}

/// Runs a part of the plate, unless time is up; what it cannot have becomes a note.
template <class Part>
void try_part(Plate& plate, const Deadline& deadline, const std::string& name, Part part) {
  if (deadline.expired()) {
    plate.notes.push_back(fmt::format("No {}: the budget ran out.", name));
    return;
  }
  try {
    part();
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::missing_file || error.kind() == ErrorKind::data) throw;
    plate.notes.push_back(fmt::format("No {}: {}.", name, error.what()));
  }
}

void add_regularity(Plate& plate, const PlateOptions& options, const Budget& budget) {
  const Scheme& scheme = plate.scheme;
  std::optional<Regularity> regularity;
  try_part(plate, {}, "Hölder exponent", [&] {
    const HolderProof proof = options.verified ? HolderProof::certificate : HolderProof::shortest;
    regularity = regularity_of(scheme.mask, budget, of_scheme(scheme, {.levels = levels_of_norms, .proof = proof}));
    plate.sum_rules = regularity->sum_rules();
    if (regularity->converges().truth != Truth::unknown) plate.convergence = regularity->converges();
    plate.stable = regularity->stable();
    plate.exact = regularity->exact();
    if (regularity->surface) plate.vector = regularity->surface->vector;
    if (!(plate.vector ? plate.vector->continuous : plate.convergence).is_yes()) return;
    plate.holder = regularity->exponent();
    if (regularity->surface) plate.sobolev = regularity->surface->sobolev;
  });
  if (options.verified && plate.holder.lower && *plate.holder.lower > 0)
    try_part(plate, {}, "certificate", [&] {
      plate.proof = row_proof(formats::slug(scheme.specification) + ".cert",
                              exponent_certificate(scheme.mask, *regularity, scheme.rounding), options.verified);
    });
}

void add_exponents(Plate& plate, const PlateOptions& options, const Budget& budget) {
  const Mask& mask = plate.scheme.mask.curve();
  plate.sum_rules = sum_rules(mask);
  plate.convergence = converges(mask, {levels_of_norms, budget.deadline.after(sobolev_share)});
  if (plate.convergence.is_no()) return;
  if (!plate.scheme.rounding)
    try_part(plate, {}, "Sobolev exponent", [&] {
      const auto sobolev = sobolev_if_small(mask, budget.deadline.after(sobolev_share));
      if (sobolev) plate.sobolev = sobolev->exponent;
    });
  add_regularity(plate, options, budget);
}

/// The exact values at the integers, as text and as marks.
void add_integers(Plate& plate, formats::Panel& panel, const Mask& mask) {
  constexpr std::size_t longest_text = 600, longest_number = 40;
  const LimitValues integers = limit_values(mask, 0);
  formats::Curve marks{"exact values", {}, true, false};
  for (std::size_t i = 0; i < integers.values.size(); ++i) {
    const std::string at = to_text(integers.point(i)), value = to_text(integers.values[i]);
    if (value.size() > longest_number) return;
    marks.points.emplace_back(integers.point(i).convert_to<double>(), integers.values[i].convert_to<double>());
    marks.values.push_back(fmt::format("phi({}) = {}", at, value));
    plate.at_integers += (i ? ", " : "") + marks.values.back();
  }
  if (plate.at_integers.size() > longest_text) plate.at_integers.clear();
  panel.curves.push_back(std::move(marks));
}

void add_pictures(Plate& plate, const Scheme& scheme, const PlateOptions& options) {
  const Mask& mask = scheme.mask.curve();
  const Deadline deadline = Deadline::in(options.budget);
  try_part(plate, {}, "picture of the basic limit function", [&] {
    formats::Panel panel = formats::limit_panel(mask, "", formats::DrawnLimit::values);
    const std::string caption = "<i>φ</i>, the basic limit function" + panel.title;  // : unit sequence, for long masks
    panel.title = "The basic limit function" + panel.title;
    if (!scheme.rounding) add_integers(plate, panel, mask);
    plate.pictures.push_back({"limit", caption, std::move(panel)});
  });
  plate.derivatives = proved_smoothness(mask, {levels_of_norms, deadline.after(smoothness_share)}).order;
  for (int order = 1; order <= std::min(plate.derivatives, most_derivatives); ++order)
    try_part(plate, deadline, fmt::format("picture of derivative {}", order), [&] {
      formats::Panel panel = formats::limit_panel(mask, "", formats::DrawnLimit::values, order);
      panel.title = fmt::format("Derivative {} of the basic limit function", order);
      plate.pictures.push_back({fmt::format("derivative-{}", order),
                                order <= 3 ? "<i>φ</i>" + std::string(static_cast<std::size_t>(order), '\'')
                                           : fmt::format("<i>φ</i><sup>({})</sup>", order),
                                std::move(panel)});
    });
  if (plate.derivatives > most_derivatives)
    plate.notes.push_back(
        fmt::format("Of {} continuous derivatives the first {} are drawn.", plate.derivatives, most_derivatives));
  if (scheme.rounding)
    plate.notes.push_back(
        "The coefficients that are meant are not rational; the mask and the pictures are those of rounded ones, the "
        "Hölder "
        "exponent holds for the ones that are meant. Sobolev exponent and variance are not claimed for them.");
  else if (mask.symbol().length() > most_coefficients)
    plate.notes.push_back(fmt::format("No variance curve: the mask has more than {} coefficients.", most_coefficients));
  else
    try_part(plate, deadline, "variance curve", [&] {
      plate.pictures.push_back(variance_picture(mask));
      const VarianceRange range = variance_range(mask, {Rational(1, 1'000'000), {Deadline::in(variance_seconds)}});
      plate.largest_variance = range.maximum;
      plate.mean_variance = range.mean;
    });
  try_part(plate, deadline, "refined polygon",
           [&] { plate.pictures.push_back(polygon_picture(scheme, options.open)); });
}

void fill_curve(Plate& plate, const PlateOptions& options) {
  add_exponents(plate, options, {Deadline::in(options.budget), options.memory});
  if (plate.convergence.is_yes())
    add_pictures(plate, plate.scheme, options);
  else
    plate.notes.emplace_back(plate.convergence.is_no()
                                 ? "The scheme diverges: there is no limit function, no variance curve and no limit of "
                                   "the polygon to draw."
                                 : "Convergence is not decided within the budget: nothing is drawn.");
}

void fill_surface(Plate& plate, const PlateOptions& options) {
  add_regularity(plate, options, {Deadline::in(options.budget), options.memory});
  if (plate.convergence.is_no())
    plate.notes.emplace_back("The scheme diverges: there is no limit function to draw.");
  else if (!plate.convergence.is_yes())
    plate.notes.emplace_back("Convergence is not decided within the budget: nothing is drawn.");
  else if (plate.scheme.mask.dimension() > 2)
    plate.notes.emplace_back("Limit functions of three variables are not drawn.");
  else
    try_part(plate, {}, "picture of the basic limit function",
             [&] { plate.surface = formats::limit_surface(plate.scheme.mask, "The basic limit function"); });
}

void fill_vector(Plate& plate, const PlateOptions& options) {
  const Scheme& scheme = plate.scheme;
  add_regularity(plate, options, {Deadline::in(options.budget), options.memory});
  plate.notes.emplace_back(
      "Sum rules, stability, variance and refined polygons are of masks of numbers, and left out here.");
  if (!plate.vector || !plate.vector->continuous.is_yes())
    plate.notes.emplace_back("Continuous functions are not proved to exist: nothing is drawn.");
  else if (plate.vector->solutions != 1)
    plate.notes.push_back("None is drawn of several functions; a picture needs " +
                          facts::needed_solution(*plate.vector) + ".");
  else if (scheme.mask.dimension() > 1)
    plate.notes.emplace_back("Functions of several variables are not drawn.");
  else
    try_part(plate, {}, "picture of the functions", [&] {
      plate.pictures.push_back(
          {"limit", scheme.integral ? "<i>φ</i>" : "<i>φ</i>, up to a factor",
           formats::vector_panel(scheme.mask, scheme.quadratic, *plate.vector->values, "The functions of the vector")});
    });
}

}  // namespace

Plate make_plate(const GalleryScheme& scheme, const PlateOptions& options) {
  Plate plate(scheme);
  (plate.scheme.form ? fill_vector : plate.scheme.mask.dimension() == 1 ? fill_curve : fill_surface)(plate, options);
  return plate;
}

}  // namespace subcert::reports
