#pragma once
/// What the experiments of [MB16] measure. Nothing in them is random.

#include <subcert/reports/experiments/papers.hpp>
#include <subcert/schemes/specification.hpp>

namespace subcert::experiments::mustafa_bari_2016 {

Measured limit_functions(const Run& run);
Measured refined_polygons(const Run& run);
Measured car_profile(const Run& run);
Measured vase(const Run& run);
Measured ring(const Run& run);

struct FourPointScheme {
  int arity;
  std::string name;
  int drawn_level;  ///< of the picture of the basic limit function
  int limit_level;  ///< of the values that stand for limits of data, 64 or 81 for each edge

  Scheme scheme() const { return make_scheme("ary:a=" + std::to_string(arity) + ",points=4,d=3"); }
};
inline const std::vector<FourPointScheme> four_point_schemes{
    {2, "binary", 7, 6}, {3, "ternary", 4, 4}, {4, "quaternary", 4, 3}};

}  // namespace subcert::experiments::mustafa_bari_2016
