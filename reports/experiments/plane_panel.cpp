#include "plane_panel.hpp"

namespace subcert::experiments {

formats::Panel plane_panel(const PanelParts& parts) {
  formats::Panel panel{
      parts.title,
      "",
      "",
      {{"original", parts.truth, false, true, "#e0a030"}, {"data", parts.data, false, false, "#8a97a3"}}};
  if (!parts.outliers.empty()) panel.curves.push_back({"outliers", parts.outliers, false, false, "#7d3c98"});
  panel.curves.push_back({"fitted", parts.curve, false, true, parts.robust ? "#0b559f" : "#c0392b"});
  panel.key = "below";
  panel.equal_units = parts.equal_units;
  return panel;
}

}  // namespace subcert::experiments
