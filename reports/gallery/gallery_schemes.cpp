#include "gallery.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <map>
#include <string_view>

namespace subcert {
extern const std::map<std::string, std::string_view> reference_files;  // docs/references.md, by the build
}

namespace subcert::reports {

const std::vector<GalleryScheme>& gallery_schemes() {
  static const std::vector<GalleryScheme> schemes{
      {"primal:n=2,d=1", "DHHS15"},
      {"primal:n=3,d=1", "DHHS15"},
      {"primal:n=5,d=1", "DHHS15"},
      {"primal:n=10,d=1", "DHHS15"},
      {"primal:n=4,d=3", "DHHS15"},
      {"primal:n=6,d=5", "DHHS15"},
      {"dual:n=2,d=1", "DHHS15"},
      {"dual:n=3,d=1", "DHHS15"},
      {"dual:n=5,d=1", "DHHS15"},
      {"dual:n=4,d=3", "DHHS15"},
      {"primal-odd:n=2,d=1", "DHHS15"},
      {"dual-odd:n=2,d=1", "DHHS15"},
      {"ary:a=3,points=4,d=3", "MB16"},
      {"ary:a=3,points=7,d=3", "MB16"},
      {"ary:a=4,points=6,d=3", "MB16"},
      {"bspline:degree=1", "CDM91"},
      {"dual:n=1,d=1", "DL02"},
      {"bspline:degree=3", "CDM91"},
      {"bspline:degree=2,a=3", "CDM91"},
      {"four-point:w=1/16", "DLG87"},
      {"four-point:w=1/2", "DLG87", Truth::no},
      {"dd:n=3", "DD89"},
      {"dd:n=2,a=3", "DD89"},
      {"six-point:w=1/100", "Wei90"},
      {"dual-four-point:w=1/128", "DFH05"},
      {"corner-cutting:w=1/10", "MP89"},
      {"ternary-three-point:w=4/15", "HD03"},
      {"ternary-four-point:w=1/11", "HIDS02"},
      {"pseudo-spline:m=3,l=1", "DS07"},
      {"cdf:n=2,m=4", "CDF92"},
      {"daubechies:n=2", "Dau88"},
      {"daubechies:n=4", "Dau88"},
      {"grid:points=4x4,d=3", "MB16"},
      {"catmull-clark:", "CC78"},
      {"loop:", "Loo87"},
      {"butterfly:w=1/16", "DLG90"},
      {"sqrt3:", "Kob00"},
      {"quincunx:", "CD93"},
      {"four-eight:", "VZ01"},
      {"zwart-powell:", "Zwa73"},
  };
  return schemes;
}

std::string reference(const std::string& key) {
  const std::string_view all = reference_files.at("references");
  std::size_t begin = all.find("- [" + key + "] ");
  require(!key.empty() && begin != std::string_view::npos, "references: no entry [{}]", key);
  begin += key.size() + 5;
  std::string text(all.substr(begin, all.find("\n- [", begin) - begin));
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos;) {
    const std::size_t end = text.find_first_not_of(" \n", at);
    text.replace(at, end == std::string::npos ? end : end - at, end == std::string::npos ? "" : " ");
  }
  return text;
}

}  // namespace subcert::reports
