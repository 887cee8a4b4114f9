#pragma once
/// Panels of noisy data with outliers and a fitted curve.

#include <subcert/reports/formats/figure.hpp>

namespace subcert::experiments {

struct PanelParts {
  std::string title;
  std::vector<std::pair<double, double>> data, outliers, truth, curve;
  bool robust;  ///< draws the curve in blue, else in red
  bool equal_units = false;
};

formats::Panel plane_panel(const PanelParts& parts);

}  // namespace subcert::experiments
