#include "origins.hpp"

#include <utility>

namespace subcert_check {

Image Origins::read(std::size_t j, Reader& reader) {
  const Fields fields = reader.take("origin " + std::to_string(j), 2, 2);
  const Image image{parse_size(fields[0], 0, j - 1), parse_size(fields[1], 0, body_.family.count() - 1)};
  parents_[j] = image;
  children_[image] = j;
  return image;
}

Image Origins::last_image(std::size_t vertex, const std::vector<std::size_t>& letters) const {
  for (std::size_t k = 0; k + 1 < letters.size(); ++k) {
    const auto next = children_.find({vertex, letters[k]});
    require(next != children_.end(), "a vertex of a cycle is missing");
    vertex = next->second;
  }
  return {vertex, letters.back()};
}

Origins::Way Origins::way_to(std::size_t j) {
  Way way{j, {}};
  for (; parents_[way.first]; way.first = parents_[way.first]->vertex)
    way.letters.push_back(parents_[way.first]->letter);
  arithmetic_.spend(way.letters.size());
  return way;
}

Vector Origins::led(Vector x, const std::function<Vector(Vector)>& around, std::size_t turns, const Way& way) {
  for (; turns > 0; --turns) x = around(std::move(x));
  for (std::size_t at = way.letters.size(); at-- > 0;) x = body_.image(way.letters[at], x, arithmetic_);
  return x;
}

}  // namespace subcert_check
