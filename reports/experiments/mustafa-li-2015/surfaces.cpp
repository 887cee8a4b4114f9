// [MLZD15, sec. 3.1, Experiments 1 and 2, Figures 8 and 9, Table 3]: surfaces with noise and outliers.

#include "parts.hpp"

#include <subcert/proofs-checks/papers/registry.hpp>
#include <subcert/reports/experiments/figures.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace subcert::experiments::mustafa_li_2015 {
namespace {

/// In the order of the pictures: the B-spline first.
std::vector<Method> drawn_methods() {
  std::vector<Method> result = with_classical_surface();
  std::rotate(result.begin(), result.end() - 1, result.end());
  return result;
}

/// One of each kind.
std::vector<Method> methods_on_six() { return {surface_methods()[0], surface_methods()[3]}; }

NoisyData bump_data(double sigma) {
  return {.axes = {data::Axis::of(21), data::Axis::of(21)},
          .levels = 2,
          .truth =
              [](double u, double v) {
                const double x = -2 + u / 5, y = -2 + v / 5;
                return std::array{x * std::exp(-x * x - y * y), 0.0, 0.0};
              },
          .sigma = sigma,
          .outliers = 1,
          .displace = vertical_outlier(3, 3)};
}

/// Sample 0 under these methods, `keep`-th points of them; parameter u is drawn at origin + scale * u.
formats::SurfaceFigure sample_figure(const formats::SurfaceFigure& words, const NoisyData& data,
                                     const std::vector<Method>& methods, std::uint64_t seed, std::size_t keep,
                                     const Rational& origin = 0, const Rational& scale = 1) {
  const auto drawn = [&](const std::string& title, const data::GridData<double>& surface, std::size_t every) {
    return drawn_surface(title, placed(surface, origin, scale), every);
  };
  const data::GridData<double> sample = data.first_data(seed);
  formats::SurfaceFigure result = words;
  result.columns = 3;
  result.surfaces = {drawn("original", data.true_points(), 1), drawn("data", sample, 1)};
  for (const Method& method : methods)
    result.surfaces.push_back(drawn(method.name, refined(method.specification, sample, 2), keep));
  return result;
}

/// Whether Table 3 can belong to noise of this deviation: what the schemes leave of such noise alone.
void find_noise_of_table_3(Measured& measured, double sigma, const ExperimentOptions& options) {
  NoisyData noise = bump_data(sigma);
  noise.outliers = 0;
  noise.truth = [](double, double) { return std::array{0.0, 0.0, 0.0}; };
  const std::string left = "left of noise: ";
  study(measured, noise, methods_on_six(), {error_measure}, options, left);
  for (const statements::PublishedCell& cell : statements::paper("mustafa-li-2015").table("table3").cells) {
    if (cell.column != "S_6" && cell.column != "D_6") continue;
    const auto& errors = measured.at({left + "error", cell.column});
    const double least = *std::min_element(errors.begin(), errors.end());
    measured.add_fact("noise of Table 3", cell.column, std::stod(cell.printed) >= least,
                      "printed " + cell.printed + ", of noise alone at least " + short_number(least) +
                          ", in the mean " + mean_interval(errors).text());
  }
}

Measured measured_bump(const ExperimentOptions& options) {
  const NoisyData data = bump_data(std::sqrt(0.1)), quiet = bump_data(0.1);
  std::vector<SampleMeasure> measures = outlier_measures;
  measures.push_back(roughness_measure);
  Measured result;
  study(result, data, with_classical_surface(), measures, options);
  study(result, quiet, surface_methods(), outlier_measures, options, "quiet ");
  find_noise_of_table_3(result, std::sqrt(0.1), options);
  const std::vector<Method> methods = drawn_methods();
  const std::string caption = "One sample; original, data with an outlier, and surfaces.";
  const auto figure = [&](const std::string& id, const std::string& title, const NoisyData& what,
                          const std::vector<Method>& shown) {
    return sample_figure({id, title, caption, {}}, what, shown, options.seed, 2, -2, Rational(1, 5));
  };
  result.surface_figures = {
      figure("l1-surface1", "A function with normal noise of variance 0.1 and an outlier", data, methods),
      figure("l1-surface1-quiet-surfaces", "The same with noise of deviation 0.1", quiet,
             {methods[0], methods[1], methods[4], methods[6]})};
  return result;
}

constexpr double band_variance = 0.1;
constexpr int few = 20, many = 100;  // outliers

/// A part of a Moebius band: u from -1.5 to 1.5, v from -1.25 to 1.25.
NoisyData band_data(std::size_t outliers) {
  constexpr std::size_t columns = 40, rows = 50;
  return {.axes = {data::Axis::of(columns), data::Axis::of(rows)},
          .dimension = 3,
          .levels = 1,
          .truth =
              [](double i, double j) {
                const double u = -1.5 + 3 * i / (columns - 1), v = -1.25 + 2.5 * j / (rows - 1);
                const double radius = 3 + u * std::cos(v / 2);
                return std::array{std::cos(v) * radius, std::sin(v) * radius, u * std::sin(v / 2)};
              },
          .sigma = std::sqrt(band_variance),
          .outliers = outliers,
          .displace =
              [](std::mt19937_64& engine, double* point) {
                // Uniform on a sphere.
                const double radius = 2 + 2 * uniform(engine), z = 2 * uniform(engine) - 1,
                             angle = 2 * std::numbers::pi * uniform(engine), r = std::sqrt(1 - z * z);
                point[0] += radius * r * std::cos(angle);
                point[1] += radius * r * std::sin(angle);
                point[2] += radius * z;
              }};
}

Measured measured_band(const ExperimentOptions& options) {
  const NoisyData data = band_data(few);
  Measured result;
  study(result, data, with_classical_surface(), outlier_measures, options);
  study(result, band_data(many), methods_on_six(), outlier_measures, options, "many: ");
  result.surface_figures = {
      sample_figure({"l1-surface2",
                     "A part of a Moebius band with normal noise of variance 0.1 and 20 outliers",
                     "One sample. Original, data, biquadratic B-spline; least squares; l1 regression.",
                     {}},
                    data, drawn_methods(), options.seed, 4)};
  return result;
}

}  // namespace

Experiment surface_with_outlier() {
  const std::string place = "Sec. 3.1, Experiment 1, Fig. 8";
  // The extremes of F are at (1/sqrt 2, 0) and its mirror image.
  const double tenth_of_range = std::sqrt(2) * std::exp(-0.5) / 10;
  const Names all = names_of(surface_methods()), classical{classical_surface.name};
  return {
      .id = "l1-surface1",
      .title = "Surfaces, Experiment 1, Figure 8 and Table 3: an outlier",
      .setup =
          {"F(x, y) = x e^(-x^2 - y^2). The schemes need a grid, which the paper does not name; here x, y = -2, "
           "-1.8, ..., 2, with independent normal noise of variance 0.1 and one outlier: a number of random sign "
           "and of a modulus uniform in [3, 6] is added to a random datum. Surfaces after 2 refinements, 6 "
           "reweighted fits with delta = 1e-8, rules at the ends by regression. Error and response as in l1-exp1."},
      .claims =
          {{.sentence = "The outlier leaves a significant effect on the surface of S_6, the scheme of low complexity "
                        "(read as: more than a tenth of the range of F).",
            .place = place,
            .relation = above("largest change by the outlier", tenth_of_range, means("response", {"S_6"}))},
           {.sentence = "The effect on the least squares schemes decreases with their complexity.",
            .place = place,
            .relation = smaller(more_least_squares_points, "response", "the largest change")},
           {.sentence =
                "The l1 schemes are free from the effect of the outlier (read as: less than a tenth of the range "
                "of F).",
            .place = place,
            .relation = below("largest change by the outlier", tenth_of_range, means("response", l1_schemes)),
            .recorded = Verdict::not_confirmed},
           {.sentence = "Both kinds of schemes produce smooth surfaces (read as: smoother than the biquadratic "
                        "B-spline).",
            .place = place,
            .relation = smaller(all_pairs(all, classical), "roughness", "the mean square of the second differences")},
           {.sentence = "Classical schemes are not suitable for such data (read as: the biquadratic B-spline has a "
                        "larger error than every other scheme).",
            .place = place,
            .relation = larger(all_pairs(classical, all))},
           {.sentence = "Each D_k has a smaller error than S_k.",
            .place = "Sec. 3.1, Table 3",
            .relation = smaller(l1_over_least_squares)},
           {.sentence = "Schemes of high complexity have larger errors.",
            .place = "Sec. 2.5, Experiment 2; Table 3",
            .relation = larger(more_over_fewer_points)},
           {.sentence = "The errors of Table 3 are those of data with noise of variance 0.1.",
            .place = "Sec. 3.1, Experiment 1, Table 3",
            .relation = all_facts(
                "noise of Table 3",
                "the printed errors of S_6 and D_6 are not below the least that these schemes leave of "
                "such noise alone, F = 0 and no outlier, over our samples")}},
      .tables = {outlier_table("l1-surface1-measures", "Noise of variance 0.1", with_classical_surface()),
                 outlier_table("l1-surface1-quiet", "Noise of deviation 0.1", surface_methods(), "quiet ")},
      .measure = measured_bump,
      .printed = "table3"};
}

Experiment moebius_band() {
  const std::string place = "Sec. 3.1, Experiment 2, Fig. 9";
  return {
      .id = "l1-surface2",
      .title = "Surfaces, Experiment 2 and Figure 9: a Moebius band",
      .setup = {"40 values of u in [-1.5, 1.5] and 50 of v in [-1.25, 1.25], as printed: some 0.4 of the Moebius band. "
                "Normal noise of variance 0.1 in every coordinate; the paper does not say how many outliers, here 20 "
                "random points are moved by a length uniform in [2, 4] in a random direction. Surfaces after one "
                "refinement, every coordinate fitted by itself, 6 reweighted fits with delta = 1e-8, rules at the ends "
                "by regression. Error: mean squared distance from the surface at the same parameters; response: the "
                "largest distance by which the outliers move a point."},
      .claims =
          {{.sentence = "The l1 schemes outperform the least squares schemes.",
            .place = "Sec. 4; " + place,
            .relation = smaller(l1_over_least_squares),
            .recorded = Verdict::not_confirmed},
           {.sentence = "The l1 schemes fit noisy data with outliers better than other subdivision schemes (read as: "
                        "than the biquadratic B-spline).",
            .place = "Sec. 1; " + place,
            .relation = smaller(all_pairs(l1_schemes, {classical_surface.name}))},
           {.sentence = "The l1 schemes remove outliers (read as: these raise the error by less than a tenth).",
            .place = "Highlights; " + place,
            .relation = below("paired differences of the error and 1.1 of that without outliers", 0,
                              excess("error", "error without", l1_schemes, 1.1))},
           {.sentence = "The l1 schemes remove noise (read as: a tenth of its mean square is left).",
            .place = "Highlights; " + place,
            .relation = below("error", 3 * band_variance / 10, means("error", l1_schemes))},
           {.sentence = "D_6 fits better than the other schemes.",
            .place = "Sec. 2.5, Experiment 2",
            .relation = smaller(six_over_others),
            .recorded = Verdict::not_confirmed}},
      .tables = {outlier_table("l1-surface2-measures", "Noise of variance 0.1 and 20 outliers (1 %)",
                               with_classical_surface()),
                 outlier_table("l1-surface2-many", "The same with 100 outliers (5 %)", methods_on_six(), "many: ")},
      .measure = measured_band};
}

}  // namespace subcert::experiments::mustafa_li_2015
