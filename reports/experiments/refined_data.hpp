#pragma once
/// Refined data as functions of the parameter and as pictures.

#include "decided.hpp"

#include <subcert/schemes/data/refine/grid_data.hpp>

namespace subcert::experiments {

/// One set of data refined as a Batch is. Domain and errors: as there.
data::GridData<double> refined(const std::string& specification, const data::GridData<double>& data, int levels);

/// The polygon through the points of a curve at these parameters: coordinate c of parameter k at [k * dimension + c].
/// Beyond the first and last point of open data the outer edges are continued. Domain: one axis, at least two points.
std::vector<double> polygon_at(const data::GridData<double>& curve, const std::vector<double>& parameters);

/// A surface, bilinear between its points, at the parameters of a finer one. Domain: two axes, at least two points in
/// each.
std::vector<double> mesh_at(const data::GridData<double>& surface, const std::vector<data::Axis>& finer);

/// The Euclidean distances between points k of both, of `dimension` coordinates. Domain: as many values in both.
std::vector<double> distances(const std::vector<double>& first, const std::vector<double>& second,
                              std::size_t dimension);

/// The diagonal of the smallest box, with sides along the axes, that contains all points.
double diameter(const std::vector<double>& points, std::size_t dimension);

/// Functions over the parameter, or curves by their first two coordinates; closed lines end with their first point.
formats::Curve drawn_points(const std::string& label, const data::GridData<double>& data,
                            const std::string& colour = {});
formats::Curve drawn_line(const std::string& label, const data::GridData<double>& data, const std::string& colour = {});

/// For what a curve is compared with.
extern const std::string pale;

/// A surface in space, or heights over the parameters. Domain: two axes, one or three coordinates.
formats::DrawnSurface drawn_surface(const std::string& title, const data::GridData<double>& surface);

data::GridData<double> rounded(const data::GridData<Rational>& data);

/// Facts that a claim needs, all of them.
class Evidence {
 public:
  /// `numbers` says what was found; `name` may be empty.
  void require(const std::string& name, bool holds, const std::string& numbers);

  Claim decides(const Sentence& sentence, const std::string& statistic, Verdict recorded = Verdict::confirmed) const {
    return decided(sentence, statistic, holds_, numbers_, recorded);
  }

 private:
  bool holds_ = true;
  std::string numbers_;
};

}  // namespace subcert::experiments
