#include "primal_schemes.hpp"

#include <subcert/proofs-checks/number_list.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <map>

namespace subcert::conjectures {

std::string PrimalScheme::specification() const { return "primal:n=" + std::to_string(n) + ",d=" + std::to_string(d); }

std::string PrimalSchemes::Skipped::reason() const {
  if (!beyond_data()) return "the same mask as " + same_as.specification();
  return "2n = " + std::to_string(2 * scheme.n) + " data fix no degree above " + std::to_string(same_as.d) +
         ": the same scheme as " + same_as.specification();
}

std::vector<std::string> PrimalSchemes::skipped_lines() const {
  std::map<std::pair<int, bool>, std::vector<int>> groups;
  for (const Skipped& one : skipped) groups[{one.scheme.d, one.beyond_data()}].push_back(one.scheme.n);
  std::vector<std::string> lines;
  for (const auto& [group, sizes] : groups) {
    const auto& [degree, beyond] = group;
    lines.push_back("d = " + std::to_string(degree) + " with n = " + number_list_text(sizes) + ": " +
                    (beyond ? "2n data fix no degree above 2n-1; these are the schemes with d = 2n-1"
                            : "the same masks as d = " + std::to_string(degree + 1)));
  }
  return lines;
}

PrimalSchemes distinct_primal_schemes(const std::vector<int>& n, const std::vector<int>& d) {
  PrimalSchemes result;
  for (int degree : d)
    for (int points : n) {
      const PrimalScheme scheme{degree, points};
      const PrimalScheme next{degree + 1, points};
      if (degree > 2 * points - 1) {
        result.skipped.push_back({scheme, {2 * points - 1, points}});
      } else if (std::binary_search(d.begin(), d.end(), next.d) && degree % 2 == 0 &&
                 make_scheme(scheme.specification()).mask.curve() == make_scheme(next.specification()).mask.curve()) {
        result.skipped.push_back({scheme, next});
      } else {
        result.schemes.push_back(scheme);
      }
    }
  return result;
}

std::vector<VariancePair> neighbouring_pairs(const std::vector<PrimalScheme>& schemes) {
  std::map<int, std::vector<int>> degrees_of, sizes_of;
  for (const PrimalScheme& scheme : schemes) {
    degrees_of[scheme.n].push_back(scheme.d);
    sizes_of[scheme.d].push_back(scheme.n);
  }
  std::vector<VariancePair> pairs;
  for (auto& [n, degrees] : degrees_of) {
    std::sort(degrees.begin(), degrees.end());
    for (std::size_t i = 1; i < degrees.size(); ++i) pairs.push_back({{degrees[i], n}, {degrees[i - 1], n}});
  }
  for (auto& [d, sizes] : sizes_of) {
    std::sort(sizes.begin(), sizes.end());
    for (std::size_t i = 1; i < sizes.size(); ++i) pairs.push_back({{d, sizes[i - 1]}, {d, sizes[i]}});
  }
  return pairs;
}

}  // namespace subcert::conjectures
