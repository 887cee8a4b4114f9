#include "group_words.hpp"

#include <subcert/analysis/symbol/error.hpp>

namespace subcert {
namespace {

/// The element that is the map or its negative.
std::pair<std::size_t, int> find(const std::vector<RationalMatrix>& maps, const RationalMatrix& map) {
  for (std::size_t e = 0; e < maps.size(); ++e)
    for (const int sign : {1, -1})
      if (map == Rational(sign) * maps[e]) return {e, sign};
  fail(ErrorKind::domain, "certificate: need a group of symmetries, got maps that are none");
}

}  // namespace

GroupWords::GroupWords(const std::vector<FamilySymmetry>& group, bool flip, bool negation) : words_(group.size()) {
  words_[0] = {"", 1};
  std::vector<RationalMatrix> maps;
  for (const FamilySymmetry& element : group) maps.push_back(element.map.matrix());
  if (flip) {
    words_[1] = {"f", 1};
    return;
  }
  for (std::size_t next = 1; next < group.size(); ++next) {
    if (words_[next]) continue;
    generators_.push_back(next);
    inverses_.push_back(find(maps, solve(maps[next], maps[0])).first);
    extend(maps);
  }
  if (negation) negation_ = static_cast<char>('A' + generators_.size());
}

/// Words for all products of the generators so far.
void GroupWords::extend(const std::vector<RationalMatrix>& maps) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t e = 0; e < maps.size(); ++e)
      for (std::size_t g = 0; words_[e] && g < generators_.size(); ++g) {
        const auto [product, sign] = find(maps, maps[generators_[g]] * maps[e]);
        if (words_[product]) continue;
        words_[product] = {static_cast<char>('A' + g) + words_[e]->first, sign * words_[e]->second};
        changed = true;
      }
  }
}

}  // namespace subcert
