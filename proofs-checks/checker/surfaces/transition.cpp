#include "transition.hpp"

#include <algorithm>

namespace subcert_check {
namespace {

constexpr std::size_t max_classes = 64;

Point first_of(const Mask& mask) {
  Point point{};
  for (std::size_t v = 0; v < mask.first.size(); ++v) {
    require(abs(mask.first[v]) <= max_coordinate, "a coordinate is too large");
    point[v] = mask.first[v].get_si();
  }
  return point;
}

}  // namespace

void drop_zeros(Sequence& x) {
  std::erase_if(x, [](const auto& value) { return value.second == 0; });
}

Transition::Transition(const Mask& mask, const Dilation& dilation, Arithmetic& arithmetic)
    : dilation_(dilation),
      components_(std::max<std::size_t>(mask.components, 1)),
      denominator_(mask.denominator),
      determinant_(determinant(dilation.rows)),
      adjugate_(subcert_check::adjugate(dilation.rows)),
      arithmetic_(arithmetic) {
  Point point{};
  const std::size_t entries = components_ * components_;
  for (std::size_t k = 0; k < mask.coefficients.size(); ++k) {
    if (const mpz_class& coefficient = mask.coefficients[k]; coefficient != 0)
      entry(mask_, {combine(point, 1, first_of(mask)), k % entries}) = coefficient;
    for (std::size_t v = 0; v < mask.sizes.size() && (k + 1) % entries == 0; ++v) {
      if (++point[v] < static_cast<std::int64_t>(mask.sizes[v])) break;
      point[v] = 0;
    }
  }
}

void Transition::read_digits(Reader& reader) {
  require(classes() <= max_classes, "a dilation with too large a determinant");
  for (const std::string_view field : reader.take("digits", classes(), classes())) {
    digits_.push_back(parse_point(field, variables()));
    require(digit_of_class_.try_emplace(class_of(digits_.back()), digits_.size() - 1).second,
            "two digits of one class");
  }
}

mpz_class& Transition::entry(Sequence& x, const Place& place, std::size_t limbs) const {
  const auto [at, fresh] = x.try_emplace(place);
  arithmetic_.spend((fresh ? 1200 : 100) + 80 * limbs);
  return at->second;
}

void Transition::add_product(Sequence& sum, const Place& place, const mpz_class& x, const mpz_class& y) const {
  const std::size_t limbs = mpz_size(x.get_mpz_t()) + mpz_size(y.get_mpz_t());
  arithmetic_.add_product(entry(sum, place, limbs), x, y);
}

void Transition::set(Sequence& x, const Place& place, const mpz_class& value) const {
  require(!x.contains(place), "a point occurs twice");
  entry(x, place, mpz_size(value.get_mpz_t())) = value;
}

Point Transition::adjugate_times(const Point& point) const {
  Point result{};
  for (std::size_t i = 0; i < 3; ++i)
    result = combine(result, point[i], {adjugate_[0][i], adjugate_[1][i], adjugate_[2][i]});
  return result;
}

Point Transition::class_of(const Point& point) const {
  Point result = adjugate_times(point);
  const std::int64_t classes = std::abs(determinant_);
  for (std::int64_t& c : result) c = (c % classes + classes) % classes;
  return result;
}

Point Transition::divide(const Point& point) const {
  Point result = adjugate_times(point);
  for (std::int64_t& c : result) c /= determinant_;
  return result;
}

Vector Transition::moments(const Sequence& x, std::size_t m) const {
  Vector sums(m * (m + 1) * (m + 2) / 6);
  for (const auto& [place, value] : x) {
    const Point& point = place.point;
    arithmetic_.spend(sums.size() * (60 + m + mpz_size(value.get_mpz_t())));
    std::size_t at = 0;
    mpz_class a = value;
    for (std::size_t i = 0; i < m; ++i, a *= point[0]) {
      mpz_class b = a;
      for (std::size_t j = 0; i + j < m; ++j, b *= point[1]) {
        mpz_class c = b;
        for (std::size_t k = 0; i + j + k < m; ++k, c *= point[2]) sums[at++] += c;
      }
    }
  }
  return sums;
}

std::set<Sequence> Transition::differences(const Sequence& start, std::size_t order) const {
  std::set<Sequence> result{start};
  for (std::size_t round = 0; round < order; ++round) {
    std::set<Sequence> next;
    for (const Sequence& x : result)
      for (std::size_t v = 0; v < dilation_.variables; ++v) {
        Sequence difference = x;
        for (const auto& [place, value] : x) {
          Place moved = place;
          ++moved.point[v];
          entry(difference, moved, 10 + mpz_size(value.get_mpz_t())) -= value;
        }
        drop_zeros(difference);
        next.insert(difference);
      }
    result = std::move(next);
  }
  return result;
}

std::vector<Sequence> Transition::of(const Sequence& mask, const Sequence& x) const {
  std::vector<Sequence> images(digits_.size());
  for (const auto& [i, a] : mask)
    for (const auto& [k, b] : x) {
      arithmetic_.spend(10);
      if (i.component % components_ != k.component) continue;
      const Point point = combine(i.point, 1, k.point);
      const std::size_t d = digit_of(point);
      add_product(images[d], {divide(combine(point, -1, digits_[d])), i.component / components_}, a, b);
    }
  for (Sequence& image : images) drop_zeros(image);
  return images;
}

void Elimination::reduce(Sequence& x, const std::vector<Row>& rows) const {
  for (const Row& row : rows) {
    sequences_.arithmetic().spend(50);
    const auto at = x.find(row.pivot);
    if (at == x.end()) continue;
    const mpz_class factor = -at->second, scale = row.values.at(row.pivot);
    const std::size_t limbs = mpz_size(scale.get_mpz_t());
    for (auto& [place, value] : x) {
      sequences_.arithmetic().spend(20 + limbs * (80 + mpz_size(value.get_mpz_t())));
      value *= scale;
    }
    for (const auto& [place, value] : row.values) sequences_.add_product(x, place, value, factor);
    if (modular_) {
      reduce_modulo_prime(x);
      continue;
    }
    drop_zeros(x);
    mpz_class content = 0;
    for (const auto& [place, value] : x) {
      sequences_.arithmetic().spend(50 + mpz_size(value.get_mpz_t()) * mpz_size(value.get_mpz_t()));
      content = gcd(content, value);
    }
    for (auto& [place, value] : x) value /= content;
  }
}

void Elimination::reduce_modulo_prime(Sequence& x) const {
  for (auto& [place, value] : x) {
    sequences_.arithmetic().spend(20 + 20 * mpz_size(value.get_mpz_t()));
    value = mpz_fdiv_ui(value.get_mpz_t(), prime);
  }
  drop_zeros(x);
}

void Elimination::add(std::vector<Row>& rows, Sequence x) const {
  if (modular_) reduce_modulo_prime(x);
  reduce(x, rows);
  if (!x.empty()) rows.push_back({x.begin()->first, std::move(x)});
}

}  // namespace subcert_check
