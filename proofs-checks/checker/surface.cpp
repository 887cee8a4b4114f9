#include "surface.hpp"

#include <algorithm>
#include <memory>
#include <set>

namespace subcert_check {
namespace {

constexpr unsigned long prime = 4'294'967'291;  // 2^32 - 5
constexpr std::size_t max_classes = 64, max_space = 256, max_order = 64, max_rounds = 64;
constexpr std::size_t max_steps = 1000, max_places = 1UL << 20;

/// A vector of a basis; the vectors after it, and in the basis of the space all others, are 0 at its pivot.
struct Row {
  Place pivot;
  Sequence values;
};

/// A mask of numbers or of matrices and a dilation with what the certificate says of them. Sequences have numbers or
/// vectors as their values. Coordinates on the space are read off at the pivots.
class Surface {
 public:
  Surface(const Mask& mask, const Dilation& dilation, Reader& reader, Arithmetic& arithmetic)
      : dilation_(dilation),
        of_vectors_(mask.components > 0),
        components_(std::max<std::size_t>(mask.components, 1)),
        denominator_(mask.denominator),
        reader_(reader),
        arithmetic_(arithmetic),
        determinant_(determinant(dilation.rows)),
        adjugate_(adjugate(dilation.rows)) {
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

  void read_digits() {
    const std::size_t classes = static_cast<std::size_t>(std::abs(determinant_));
    require(classes <= max_classes, "a dilation with too large a determinant");
    for (const std::string_view field : reader_.take("digits", classes, classes)) {
      digits_.push_back(parse_point(field, dilation_.variables));
      require(digit_of_class_.try_emplace(class_of(digits_.back()), digits_.size() - 1).second,
              "two digits of one class");
    }
  }

  /// Sections 5.2 and 5.3: the space of the differences of the scheme, of this order.
  Family of_scheme(std::size_t order) {
    check_sum_rules(order);
    read_space();
    for (const Row& row : space_)
      for (const mpz_class& moment : moments(row.values, order))
        require(moment == 0, "a vector does not annihilate the polynomials of degree below the order of the sum rules");
    Family result = restricted();
    rounds_into_space(differences({{Place{}, 1}}, order));
    return result;
  }

  /// Sections 5.6 and 5.9: the space of the differences of phi. With `spanned` they are shown to span it.
  Family of_values(std::size_t order, bool spanned) {
    if (!of_vectors_) check_sum_rules(1);
    const std::set<Sequence> starts = differences(read_values(), order);
    if (of_vectors_) check_unique();
    read_space();
    Family result = restricted();
    const std::size_t rounds = rounds_into_space(starts);
    if (spanned) check_spanned(starts, rounds);
    return result;
  }

  /// Section 5.7: whether the linear map, with some shift, permutes the points of the mask and keeps the coefficients.
  bool is_symmetry(const Matrix& g) {
    const auto image = [&g](const Point& p) {
      Point result{};
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) result[i] += g[i][j] * p[j];
      return result;
    };
    Sequence moved;
    for (const auto& [place, value] : mask_) {
      const Point at = image(place.point);
      for (const std::int64_t c : at) require(std::abs(c) <= max_distance, "a lattice point is too far away");
      set(moved, {at}, value);
    }
    const Point shift = combine(mask_.begin()->first.point, -1, moved.begin()->first.point);
    return std::equal(mask_.begin(), mask_.end(), moved.begin(), moved.end(), [&](const auto& a, const auto& b) {
      return a.first.point == combine(b.first.point, 1, shift) && a.second == b.second;
    });
  }

  /// Section 5.5: g is a fixed point of the transfer operator, and its Fourier series is positive.
  void check_stability() {
    Sequence g, moved, products;
    mpz_class sum = 0;
    for (const auto& [place, value] : read_terms("gram")) {
      set(g, place, value);
      if (place.point != Point{}) set(g, {combine({}, -1, place.point)}, value);
    }
    for (const auto& [place, value] : g) sum += value;
    require(sum > 0, "the numbers of the gram line have no positive sum");
    for (const auto& [i, a] : mask_)
      for (const auto& [k, b] : mask_) add_product(products, {combine(i.point, -1, k.point)}, a, b);
    for (const auto& [i, c] : products)
      for (const auto& [k, value] : g) {
        const Point point = combine(i.point, 1, k.point);
        arithmetic_.spend(40);
        if (class_of(point) == Point{}) add_product(moved, {divide(point)}, c, value);
      }
    drop_zeros(moved);
    const mpz_class scale = denominator_ * denominator_ * std::abs(determinant_);
    for (auto& [place, value] : g) value *= scale;
    require(moved == g, "the gram line is not a fixed point of the transfer operator");
    check_positive(g, dilation_.variables, arithmetic_);
  }

 private:
  static Point first_of(const Mask& mask) {
    Point point{};
    for (std::size_t v = 0; v < mask.first.size(); ++v) {
      require(abs(mask.first[v]) <= max_coordinate, "a coordinate is too large");
      point[v] = mask.first[v].get_si();
    }
    return point;
  }

  /// The value there, 0 if it is new. What it may take of memory counts as work.
  mpz_class& entry(Sequence& x, const Place& place, std::size_t limbs = 1) {
    const auto [at, fresh] = x.try_emplace(place);
    arithmetic_.spend((fresh ? 1200 : 100) + 80 * limbs);
    return at->second;
  }
  void add_product(Sequence& sum, const Place& place, const mpz_class& x, const mpz_class& y) {
    const std::size_t limbs = mpz_size(x.get_mpz_t()) + mpz_size(y.get_mpz_t());
    arithmetic_.add_product(entry(sum, place, limbs), x, y);
  }
  void set(Sequence& x, const Place& place, const mpz_class& value) {
    require(!x.contains(place), "a point occurs twice");
    entry(x, place, mpz_size(value.get_mpz_t())) = value;
  }
  static void drop_zeros(Sequence& x) {
    std::erase_if(x, [](const auto& value) { return value.second == 0; });
  }

  // ---- the lattice and its classes

  Point adjugate_times(const Point& point) const {
    Point result{};
    for (std::size_t i = 0; i < 3; ++i)
      result = combine(result, point[i], {adjugate_[0][i], adjugate_[1][i], adjugate_[2][i]});
    return result;
  }
  /// Equal for points whose difference is in M Z^s, and 0 there.
  Point class_of(const Point& point) const {
    Point result = adjugate_times(point);
    const std::int64_t classes = std::abs(determinant_);
    for (std::int64_t& c : result) c = (c % classes + classes) % classes;
    return result;
  }
  /// M^-1 times a point of M Z^s.
  Point divide(const Point& point) const {
    Point result = adjugate_times(point);
    for (std::int64_t& c : result) c /= determinant_;
    return result;
  }

  // ---- polynomials and differences

  /// The sums of x_k k^nu for all |nu| < m, one after another, beginning with nu = 0.
  Vector moments(const Sequence& x, std::size_t m) {
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

  void check_sum_rules(std::size_t order) {
    std::vector<Sequence> classes(digits_.size());
    for (const auto& [place, value] : mask_) entry(classes[digit_of_class_.at(class_of(place.point))], place) = value;
    const Vector first = moments(classes[0], order);
    require(first[0] == denominator_, "a class of coefficients does not sum to 1");
    for (const Sequence& one : classes)
      require(moments(one, order) == first, "the mask has no sum rules of this order");
  }

  /// All nabla^mu start, |mu| = the order.
  std::set<Sequence> differences(const Sequence& start, std::size_t order) {
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

  // ---- the space

  /// T_d x for all digits, times the denominator of the mask.
  std::vector<Sequence> transitions(const Sequence& x) { return transitions(mask_, x); }
  std::vector<Sequence> transitions(const Sequence& mask, const Sequence& x) {
    std::vector<Sequence> images(digits_.size());
    for (const auto& [i, a] : mask)
      for (const auto& [k, b] : x) {
        arithmetic_.spend(10);
        if (i.component % components_ != k.component) continue;
        const Point point = combine(i.point, 1, k.point);
        const std::size_t d = digit_of_class_.at(class_of(point));
        add_product(images[d], {divide(combine(point, -1, digits_[d])), i.component / components_}, a, b);
      }
    for (Sequence& image : images) drop_zeros(image);
    return images;
  }

  /// A fixed vector of the operator of the first digit; of numbers one whose sum is not 0.
  Sequence read_values() {
    Sequence values, scaled;
    mpz_class sum = 0;
    for (const auto& [place, value] : read_terms("values")) {
      set(values, place, value);
      set(scaled, place, value * denominator_);
      sum += value;
    }
    require(of_vectors_ || sum != 0, "the numbers of the values line have the sum 0");
    require(transitions(values)[0] == scaled, "the values line is not fixed by the operator of the first digit");
    return values;
  }

  // ---- section 5.9: the places where continuous solutions may have values

  /// Bounds the coordinates of the points j for which a solution of compact support may not vanish at x' + j.
  std::int64_t reach() {
    std::int64_t farthest = 0;
    for (const auto& [place, value] : mask_)
      for (const std::int64_t c : combine(place.point, -1, digits_[0])) farthest = std::max(farthest, std::abs(c));
    Vector inverse, power;
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 3; ++i) {
        inverse.emplace_back(adjugate_[i][j]);
        power.emplace_back(i == j);
      }
    mpq_class sum = 0, norm = 1;
    for (mpz_class scale = 1; norm > mpq_class(1, 2); sum += norm) {
      power = arithmetic_.multiply(inverse, power, 3);
      scale *= std::abs(determinant_);
      mpz_class largest = 0;
      for (std::size_t i = 0; i < dilation_.variables; ++i)
        largest = std::max(largest, mpz_class(abs(power[i]) + abs(power[3 + i]) + abs(power[6 + i])));
      norm = ratio(largest, scale);
    }
    const mpz_class result = ceiling(2 * sum * mpz_class(farthest));
    mpz_class places = components_;
    for (std::size_t v = 0; v < dilation_.variables; ++v) places *= 2 * result + 1;
    require(places <= max_places, too_much_work);
    return result.get_si();
  }

  /// The places from which the operator of the first digit leads to one of these, with values 1.
  Sequence led_to(const Sequence& places) {
    Sequence result = std::move(transitions(pattern_, places)[0]);
    for (auto& [place, value] : result) value = 1;
    return result;
  }

  /// All places that may not vanish in v(x'), with values 1.
  Sequence support() {
    for (const auto& [place, value] : mask_) entry(pattern_, place) = 1;
    Point radius{};
    std::fill_n(radius.begin(), dilation_.variables, reach());
    Sequence places, next;
    for (Point p = combine({}, -1, radius);;) {
      for (std::size_t c = 0; c < components_; ++c) entry(next, {p, c}) = 1;
      std::size_t v = 0;
      for (; v < dilation_.variables && ++p[v] > radius[v]; ++v) p[v] = -radius[v];
      if (v == dilation_.variables) break;
    }
    for (std::size_t step = 0; next != places; ++step) {
      require(step < max_steps, too_much_work);
      places = std::exchange(next, led_to(next));
    }
    return places;
  }

  /// Of these, those that may not vanish in the limit of v(x' + M^-n e) either.
  Sequence approached(const Sequence& support, const Point& e) {
    std::vector<Sequence> sets(1);
    for (const auto& [place, value] : support) entry(sets[0], {combine(place.point, -1, e), place.component}) = 1;
    for (;;) {
      Sequence next = led_to(sets.back());
      const auto again = std::find(sets.begin(), sets.end(), next);
      if (again == sets.end()) {
        require(sets.size() < max_steps, too_much_work);
        sets.push_back(std::move(next));
        continue;
      }
      for (auto at = again; at != sets.end(); ++at)
        std::erase_if(next, [&](const auto& value) { return !at->contains(value.first); });
      return next;
    }
  }

  /// The continuous solutions of compact support are the multiples of one: the fixed vectors of the operator of the
  /// first digit with values at these places have no more than one dimension.
  void check_unique() {
    const Sequence all = support();
    Sequence inner = all;
    for (std::size_t v = 0; v < dilation_.variables; ++v)
      for (const std::int64_t sign : {-1, 1}) {
        Point e{};
        e[v] = sign;
        const Sequence seen = approached(all, e);
        std::erase_if(inner, [&](const auto& value) { return !seen.contains(value.first); });
      }
    modular_ = true;
    std::vector<Row> rows;
    for (const auto& [place, value] : inner) {
      Sequence image = std::move(transitions({{place, 1}})[0]);
      entry(image, place) -= denominator_;
      add_independent(rows, std::move(image));
    }
    modular_ = false;
    require(rows.size() + 1 >= inner.size(), "the refinement equation may have several continuous solutions");
  }

  /// Makes x zero at the pivots by subtracting multiples of the rows; x may be multiplied by a number. Once `modular_`
  /// is set, modulo the prime.
  void reduce(Sequence& x, const std::vector<Row>& rows) {
    for (const Row& row : rows) {
      arithmetic_.spend(50);
      const auto at = x.find(row.pivot);
      if (at == x.end()) continue;
      const mpz_class factor = -at->second, scale = row.values.at(row.pivot);
      const std::size_t limbs = mpz_size(scale.get_mpz_t());
      for (auto& [place, value] : x) {
        arithmetic_.spend(20 + limbs * (80 + mpz_size(value.get_mpz_t())));
        value *= scale;
      }
      for (const auto& [place, value] : row.values) add_product(x, place, value, factor);
      if (modular_) {
        reduce_modulo_prime(x);
        continue;
      }
      drop_zeros(x);
      mpz_class content = 0;
      for (const auto& [place, value] : x) {
        arithmetic_.spend(50 + mpz_size(value.get_mpz_t()) * mpz_size(value.get_mpz_t()));
        content = gcd(content, value);
      }
      for (auto& [place, value] : x) value /= content;
    }
  }
  void reduce_modulo_prime(Sequence& x) {
    for (auto& [place, value] : x) {
      arithmetic_.spend(20 + 20 * mpz_size(value.get_mpz_t()));
      value = mpz_fdiv_ui(value.get_mpz_t(), prime);
    }
    drop_zeros(x);
  }

  void read_space() {
    space_.clear();
    const std::size_t size = parse_size(reader_.take("space", 1, 1)[0], 1, max_space);
    for (std::size_t i = 0; i < size; ++i) {
      Row& row = space_.emplace_back();
      for (const auto& [place, value] : read_terms("vector")) {
        if (row.values.empty()) row.pivot = place;
        set(row.values, place, value);
      }
      factor_ = space_[0].values.at(space_[0].pivot);
      require(factor_ > 0, "the first coefficient of a vector must be positive");
      require(row.values.at(row.pivot) == factor_, "the first coefficients of two vectors differ");
    }
    for (const Row& row : space_)
      for (const Row& other : space_)
        require(&row == &other || !other.values.contains(row.pivot), "the first point of a vector occurs in another");
  }

  /// POINT, of vectors POINT.COMPONENT
  Place parse_place(std::string_view text) const {
    if (!of_vectors_) return {parse_point(text, dilation_.variables)};
    const Fields parts = split(text, ".");
    require(parts.size() == 2, "a point of a sequence of vectors is POINT.COMPONENT");
    return {parse_point(parts[0], dilation_.variables), parse_size(parts[1], 0, components_ - 1)};
  }

  /// POINT:INTEGER ...
  std::vector<std::pair<Place, mpz_class>> read_terms(const std::string& head) {
    std::vector<std::pair<Place, mpz_class>> terms;
    for (const std::string_view field : reader_.take(head, 1, max_line)) {
      const Fields parts = split(field, ":");
      require(parts.size() == 2, "a term is POINT:INTEGER");
      terms.emplace_back(parse_place(parts[0]), parse_integer(parts[1]));
      arithmetic_.spend(1000 + 80 * mpz_size(terms.back().second.get_mpz_t()));
      require(terms.back().second != 0, "a coefficient is 0");
    }
    return terms;
  }

  /// All T_d of the vectors, in the coordinates of the space, times the denominator of the mask and the first
  /// coefficient of the vectors.
  Family restricted() {
    Family result{space_.size(), Vector(digits_.size() * space_.size() * space_.size()), denominator_ * factor_};
    for (std::size_t k = 0; k < space_.size(); ++k) {
      std::vector<Sequence> images = transitions(space_[k].values);
      for (std::size_t d = 0; d < images.size(); ++d) {
        for (std::size_t j = 0; j < space_.size(); ++j)
          if (const auto at = images[d].find(space_[j].pivot); at != images[d].end())
            result.entries[(d * space_.size() + k) * space_.size() + j] = at->second;
        reduce(images[d], space_);
        require(images[d].empty(), "a transition operator leads out of the space");
      }
    }
    return result;
  }

  /// All words of the length that is returned lead the starts into the space: modulo the space, their span shrinks to
  /// 0.
  std::size_t rounds_into_space(const std::set<Sequence>& starts) {
    std::vector<Row> rest;
    const auto add = [this](std::vector<Row>& rows, Sequence x) {
      reduce(x, space_);
      add_independent(rows, std::move(x));
    };
    for (const Sequence& start : starts) add(rest, start);
    std::size_t round = 0;
    for (; !rest.empty(); ++round) {
      require(round < max_rounds, "differences are not led into the space");
      std::vector<Row> next;
      for (const Row& row : rest)
        for (const Sequence& image : transitions(row.values)) add(next, image);
      rest = std::move(next);
    }
    return round;
  }
  /// The words of at least this length span the space: they do modulo the prime.
  void check_spanned(const std::set<Sequence>& starts, std::size_t length) {
    modular_ = true;
    std::vector<Row> rows;
    for (const Sequence& start : starts) add_independent(rows, start);
    for (std::size_t round = 0; round < length; ++round) {
      std::vector<Row> next;
      for (const Row& row : rows)
        for (const Sequence& image : transitions(row.values)) add_independent(next, image);
      rows = std::move(next);
    }
    for (std::size_t k = 0; k < rows.size() && rows.size() < space_.size(); ++k)
      for (const Sequence& image : transitions(Sequence(rows[k].values))) add_independent(rows, image);
    require(rows.size() == space_.size(), "the differences do not span the space");
    modular_ = false;
  }
  void add_independent(std::vector<Row>& rows, Sequence x) {
    if (modular_) reduce_modulo_prime(x);
    reduce(x, rows);
    if (!x.empty()) rows.push_back({x.begin()->first, std::move(x)});
  }

  Dilation dilation_;
  bool of_vectors_;
  std::size_t components_;  // 1 for numbers
  mpz_class denominator_;
  Reader& reader_;
  Arithmetic& arithmetic_;
  std::int64_t determinant_;
  Matrix adjugate_;
  Sequence mask_;     // row times the number of components plus column is the component
  Sequence pattern_;  // 1 where the mask is not 0
  std::vector<Point> digits_;
  std::map<Point, std::size_t> digit_of_class_;
  std::vector<Row> space_;
  mpz_class factor_;      // the first coefficient of all vectors
  bool modular_ = false;  // sequences are known modulo the prime only
};

}  // namespace

/// Section 5.7: the dilation that a certificate uses instead of that of the claim.
Dilation read_turned(const Mask& mask, const Dilation& dilation, Reader& reader, Arithmetic& arithmetic) {
  Dilation turned = parse_dilation(reader.take("turned", 1, 1)[0]);
  require(turned.variables == dilation.variables, "the turned dilation has another number of variables");
  classes(turned);
  Surface surface(mask, dilation, reader, arithmetic);
  const Matrix first = quotient(turned.rows, dilation.rows);
  Matrix g = first;
  for (std::size_t round = 0; round < max_rounds; ++round) {
    require(std::abs(determinant(g)) == 1 && surface.is_symmetry(g), "the dilation is not turned by symmetries");
    g = quotient(product(dilation.rows, g), dilation.rows);
    if (g == first) return turned;
  }
  throw Rejected{"the dilation is not turned by symmetries"};
}

SurfaceFamily read_surface(const Mask& mask, const Dilation& dilation, std::size_t order, bool of_values, bool upper,
                           Reader& reader, Arithmetic& arithmetic) {
  require(order <= max_order, "a higher order than the checker allows in several variables");
  const auto is_zero = [](const mpz_class& coefficient) { return coefficient == 0; };
  require(!std::ranges::all_of(mask.coefficients, is_zero), "all coefficients of the mask are 0");
  const Dilation used = mask.components == 0 && reader.at("turned") ? read_turned(mask, dilation, reader, arithmetic)
                                                                    : dilation;
  const auto surface = std::make_shared<Surface>(mask, used, reader, arithmetic);
  surface->read_digits();
  if (mask.components > 0) return {surface->of_values(order, upper), {}};
  if (of_values)
    return {surface->of_values(order, upper), [surface, &reader] {
              return surface->of_scheme(parse_size(reader.take("sum-rules", 1, 1)[0], 1, max_order));
            }};
  SurfaceFamily result{surface->of_scheme(order), {}};
  if (upper || reader.at("gram")) surface->check_stability();
  return result;
}

}  // namespace subcert_check
