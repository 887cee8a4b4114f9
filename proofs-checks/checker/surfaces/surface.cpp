#include "surface.hpp"

#include "kept_data.hpp"

#include <algorithm>
#include <memory>
#include <set>

namespace subcert_check {
namespace {

constexpr std::size_t max_space = 256, max_order = 64, max_rounds = 64;

/// A mask of numbers or of matrices and a dilation with what the certificate says of them. Sequences have numbers or
/// vectors as their values. Coordinates on the space are read off at the pivots.
class Surface {
 public:
  Surface(const Mask& mask, const Dilation& dilation, Reader& reader, Arithmetic& arithmetic)
      : of_vectors_(mask.components > 0),
        operators_(of_power(mask, 0), dilation, arithmetic),
        reader_(reader),
        arithmetic_(arithmetic) {
    for (std::size_t p = 1; p < mask.powers; ++p)
      more_powers_.push_back(Transition(of_power(mask, p), dilation, arithmetic).mask());
  }

  void read_digits() { operators_.read_digits(reader_); }

  /// Sections 5.2 and 5.3: the space of the differences of the scheme, of this order.
  Family of_scheme(std::size_t order) {
    check_sum_rules(order);
    read_space();
    for (const Row& row : space_)
      for (const mpz_class& moment : operators_.moments(row.values, order))
        require(moment == 0, "a vector does not annihilate the polynomials of degree below the order of the sum rules");
    Family result = restricted();
    rounds_into_space(operators_.differences({{Place{}, 1}}, order));
    return result;
  }

  /// Sections 5.6 and 5.9: the space of the differences of phi. With `spanned` they are shown to span it.
  Family of_values(std::size_t order, bool spanned, const std::optional<Rationals>& integral) {
    if (!of_vectors_) check_sum_rules(1);
    const Sequence values = read_values();
    const std::set<Sequence> starts = operators_.differences(values, order);
    if (of_vectors_)
      check_unique(operators_,
                   integral ? read_functionals(operators_, values, *integral, reader_) : std::vector<Vector>(), 1);
    read_space();
    Family result = restricted();
    const std::size_t rounds = rounds_into_space(starts);
    if (spanned) check_spanned(starts, rounds);
    return result;
  }

  /// Section 5.13: the space of the differences of phi over the field of a root, of the mask [P, root Q; Q, P].
  FieldFamily over_field(std::size_t order, bool spanned, const mpz_class& root,
                         const std::optional<Rationals>& integral) {
    const Sequence values = read_values();
    std::set<Sequence> starts = operators_.differences(values, order);
    starts.merge(operators_.differences(times_root(values, root), order));
    check_unique(operators_,
                 integral ? read_functionals(operators_, values, *integral, reader_, &root) : std::vector<Vector>(), 2);
    read_space(&root);
    const Family moved = restricted(space_.size() / 2);
    const std::size_t rounds = rounds_into_space(starts);
    if (spanned) check_spanned(starts, rounds);
    return over_field(moved, root);
  }

  /// Section 6.7: the space of what annihilates the data of the scheme with this mask, perhaps with a parameter. With a
  /// root, section 6.9, the mask is the doubled one, and the matrices are over the field. Each of `data` is y, or (q,
  /// p) for p + sqrt(root) q: what the sequences of the doubled mask, number by number, tell of its multiple of the
  /// root.
  SurfaceFamily of_data(const Mask& mask, const std::vector<Rationals>& data, const mpz_class* root) {
    const Vector& divisor = mask.divisor;
    const std::size_t functions = operators_.components() / (root ? 2 : 1);
    std::vector<std::vector<Rationals>> conditions{data};
    if (root) conditions.push_back(multiples(data, *root));
    const auto is_zero = [&](const Sequence& x) {
      return std::ranges::all_of(conditions, [&](const auto& one) { return annihilates(operators_, x, one); });
    };
    for (std::size_t p = 0; p < mask.powers; ++p) {
      std::vector<Rationals> sums(operators_.classes(), Rationals(operators_.components()));
      for (const auto& [place, value] : power(p)) {
        const std::size_t row = place.component / operators_.components(),
                          column = place.component % operators_.components();
        arithmetic_.spend(1000);
        sums[operators_.digit_of(place.point)][column] += data[0][row] * value;
      }
      for (const Rationals& sum : sums)
        for (std::size_t c = 0; c < sum.size(); ++c)
          require(sum[c] == data[0][c] * operators_.denominator() * divisor[p],
                  "the scheme does not keep the constant data");
    }
    std::set<Sequence> starts = read_generators(data, functions);
    for (const Sequence& start : starts) {
      require(is_zero(start), "a line 'reading' does not annihilate the data");
      for (const Sequence& image : images(start)) require(is_zero(image), "the scheme does not keep the data");
    }
    return on_space(starts, conditions, root, subcert_check::power(operators_.classes(), data.size()).get_num());
  }

  /// Section 6.11: the space of what annihilates the constant data that the scheme keeps, of any number of variables.
  /// Without a matrix where there are none. With a root as above.
  SurfaceFamily of_constants(const mpz_class* root) {
    const std::size_t size = operators_.components(), functions = size / (root ? 2 : 1);
    std::vector<Rationals> kept;
    while (reader_.at("fixed")) {
      require(kept.size() < size, "more lines 'fixed' than components");
      const Fields fields = reader_.take("fixed", size, size);
      Rationals y(size);
      std::transform(fields.begin(), fields.end(), y.begin(), parse_rational);
      if (root) std::rotate(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(functions), y.end());
      kept.push_back(y);
      if (root) kept.push_back(multiples({y}, *root)[0]);
    }
    check_all_kept(operators_, kept);
    if (kept.empty()) return {};
    std::set<Sequence> starts;
    for (std::size_t c = 0; c < functions; ++c) {
      const Sequence one{{Place{{}, c}, 1}};
      starts.merge(operators_.differences(one, 1));
      for (Sequence& image : operators_.of(one)) {
        operators_.entry(image, Place{{}, c}) -= operators_.denominator();
        drop_zeros(image);
        starts.insert(std::move(image));
      }
    }
    std::vector<std::vector<Rationals>> conditions;
    for (const Rationals& y : kept) conditions.push_back({y});
    return on_space(starts, conditions, root, 1);
  }

  /// Section 5.9: what reads a component on the space, and the line that says what it does not show. With `degree` 2 it
  /// is read by both of its parts, section 5.13.
  Component read_component(std::size_t number, std::size_t degree) {
    const std::size_t half = operators_.components() / degree;
    std::map<Place, Vector> readings;
    for (std::size_t k = 0; k < space_.size(); ++k)
      for (const auto& [place, value] : space_[k].values)
        if (place.component % half == number) {
          arithmetic_.spend(100 * space_.size());
          readings.try_emplace(place, space_.size()).first->second[k] = value;
        }
    Component result;
    for (auto& [place, reading] : readings) result.readings.push_back(std::move(reading));
    result.unobservable = parse_size(reader_.take("unobservable", 1, 1)[0], 0, space_.size() / degree - 1);
    result.degree = degree;
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
    for (const auto& [place, value] : operators_.mask()) {
      const Point at = image(place.point);
      for (const std::int64_t c : at) require(std::abs(c) <= max_distance, "a lattice point is too far away");
      operators_.set(moved, {at}, value);
    }
    const Point shift = combine(operators_.mask().begin()->first.point, -1, moved.begin()->first.point);
    return std::equal(operators_.mask().begin(), operators_.mask().end(), moved.begin(), moved.end(),
                      [&](const auto& a, const auto& b) {
                        return a.first.point == combine(b.first.point, 1, shift) && a.second == b.second;
                      });
  }

  /// Section 5.5: g is a fixed point of the transfer operator, and its Fourier series is positive.
  void check_stability() {
    Sequence g, moved, products;
    mpz_class sum = 0;
    for (const auto& [place, value] : read_terms("gram")) {
      operators_.set(g, place, value);
      if (place.point != Point{}) operators_.set(g, {combine({}, -1, place.point)}, value);
    }
    for (const auto& [place, value] : g) sum += value;
    require(sum > 0, "the numbers of the gram line have no positive sum");
    for (const auto& [i, a] : operators_.mask())
      for (const auto& [k, b] : operators_.mask())
        operators_.add_product(products, {combine(i.point, -1, k.point)}, a, b);
    for (const auto& [i, c] : products)
      for (const auto& [k, value] : g) {
        const Point point = combine(i.point, 1, k.point);
        arithmetic_.spend(40);
        if (operators_.class_of(point) == Point{}) operators_.add_product(moved, {operators_.divide(point)}, c, value);
      }
    drop_zeros(moved);
    const mpz_class scale = operators_.denominator() * operators_.denominator() * mpz_class(operators_.classes());
    for (auto& [place, value] : g) value *= scale;
    require(moved == g, "the gram line is not a fixed point of the transfer operator");
    check_positive(g, operators_.variables(), arithmetic_);
  }

 private:
  /// The matrices times `scale` on the space of vectors that follow, which annihilate these data. With a root `starts`
  /// get their multiples by it.
  SurfaceFamily on_space(std::set<Sequence> starts, const std::vector<std::vector<Rationals>>& conditions,
                         const mpz_class* root, const mpz_class& scale) {
    read_space(root);
    for (const Row& row : space_)
      for (const auto& one : conditions)
        require(annihilates(operators_, row.values, one), "a vector does not annihilate the data");
    Family result = restricted(root ? space_.size() / 2 : space_.size());
    if (root)
      for (const Sequence& start : std::set(starts)) starts.insert(times_root(start, *root));
    rounds_into_space(starts);
    for (mpz_class& entry : result.entries) entry *= scale;
    if (!root) return {std::move(result), {}, {}};
    return {{}, {}, {}, over_field(result, *root)};
  }

  static Mask of_power(const Mask& mask, std::size_t p) {
    Mask result = mask;
    const auto begin = mask.coefficients.begin() + static_cast<std::ptrdiff_t>(p * mask.points());
    result.coefficients.assign(begin, begin + static_cast<std::ptrdiff_t>(mask.points()));
    result.powers = 1;
    return result;
  }
  const Sequence& power(std::size_t p) const { return p == 0 ? operators_.mask() : more_powers_[p - 1]; }

  /// The images under the T_d of all powers of the parameter, digit by digit.
  std::vector<Sequence> images(const Sequence& x) const {
    if (more_powers_.empty()) return operators_.of(x);
    std::vector<Sequence> result(operators_.classes() * (1 + more_powers_.size()));
    for (std::size_t p = 0; p <= more_powers_.size(); ++p) {
      std::vector<Sequence> moved = operators_.of(power(p), x);
      for (std::size_t d = 0; d < moved.size(); ++d) result[d * (1 + more_powers_.size()) + p] = std::move(moved[d]);
    }
    return result;
  }

  /// The differences of the first component that constant data have, and for each other one what reads it beside that
  /// one. Components are told by their number modulo that of the functions.
  std::set<Sequence> read_generators(const std::vector<Rationals>& data, std::size_t functions) {
    std::size_t first = 0;
    while (first < data[0].size() && data[0][first] == 0) ++first;
    require(first < data[0].size(), "the constant data are 0");
    first %= functions;
    std::set<Sequence> starts = operators_.differences({{Place{{}, first}, 1}}, data.size());
    for (std::size_t c = 0; c < functions; ++c) {
      if (c == first) continue;
      Sequence reading;
      std::size_t own = 0;
      for (const auto& [place, value] : read_terms("reading")) {
        const std::size_t component = place.component % functions;
        require(component == c || component == first, "a line 'reading' has a component too many");
        own += component == c ? 1 : 0;
        operators_.set(reading, place, value);
      }
      require(own == 1, "a line 'reading' has not one number of its component");
      starts.insert(reading);
    }
    return starts;
  }

  void check_sum_rules(std::size_t order) {
    std::vector<Sequence> classes(operators_.classes());
    for (const auto& [place, value] : operators_.mask())
      operators_.entry(classes[operators_.digit_of(place.point)], place) = value;
    const Vector first = operators_.moments(classes[0], order);
    require(first[0] == operators_.denominator(), "a class of coefficients does not sum to 1");
    for (const Sequence& one : classes)
      require(operators_.moments(one, order) == first, "the mask has no sum rules of this order");
  }

  /// A fixed vector of the operator of the first digit; of numbers one whose sum is not 0.
  Sequence read_values() {
    Sequence values, scaled;
    mpz_class sum = 0;
    for (const auto& [place, value] : read_terms("values")) {
      operators_.set(values, place, value);
      operators_.set(scaled, place, value * operators_.denominator());
      sum += value;
    }
    require(of_vectors_ || sum != 0, "the numbers of the values line have the sum 0");
    require(operators_.of(values)[0] == scaled, "the values line is not fixed by the operator of the first digit");
    return values;
  }

  /// The components p and then q of p + sqrt(root) q, times sqrt(root).
  Sequence times_root(const Sequence& x, const mpz_class& root) const {
    const std::size_t half = operators_.components() / 2;
    Sequence result;
    for (const auto& [place, value] : x) {
      const bool is_rational = place.component < half;
      operators_.set(result, {place.point, is_rational ? place.component + half : place.component - half},
                     is_rational ? value : mpz_class(value * root));
    }
    return result;
  }

  /// The images of the first half of the vectors, in coordinates of which the second half counts times the root.
  static FieldFamily over_field(const Family& moved, const mpz_class& root) {
    const std::size_t size = moved.size / 2;
    FieldFamily result{{size, {}, moved.denominator}, {size, {}, moved.denominator}, root};
    for (auto column = moved.entries.begin(); column != moved.entries.end();) {
      const auto half = column + static_cast<std::ptrdiff_t>(size), end = half + static_cast<std::ptrdiff_t>(size);
      result.rational.entries.insert(result.rational.entries.end(), column, half);
      result.multiples.entries.insert(result.multiples.entries.end(), half, end);
      column = end;
    }
    return result;
  }

  /// `root`: the vectors are a basis over the field; their multiples by the root follow all of them.
  void read_space(const mpz_class* root = nullptr) {
    space_.clear();
    const std::size_t size = parse_size(reader_.take("space", 1, 1)[0], 1, root ? max_space / 2 : max_space);
    for (std::size_t i = 0; i < size; ++i) {
      Row& row = space_.emplace_back();
      for (const auto& [place, value] : read_terms("vector")) {
        if (row.values.empty()) row.pivot = place;
        operators_.set(row.values, place, value);
      }
      factor_ = space_[0].values.at(space_[0].pivot);
      require(factor_ > 0, "the first coefficient of a vector must be positive");
      require(row.values.at(row.pivot) == factor_, "the first coefficients of two vectors differ");
    }
    for (std::size_t i = 0; root && i < size; ++i) {
      const std::size_t half = operators_.components() / 2;
      Place pivot = space_[i].pivot;
      require(pivot.component < half, "the first point of a vector is of a multiple of the root");
      pivot.component += half;
      space_.push_back({pivot, times_root(space_[i].values, *root)});
    }
    for (const Row& row : space_)
      for (const Row& other : space_)
        require(&row == &other || !other.values.contains(row.pivot), "the first point of a vector occurs in another");
  }

  /// POINT, of vectors POINT.COMPONENT
  Place parse_place(std::string_view text) const {
    if (!of_vectors_) return {parse_point(text, operators_.variables())};
    const Fields parts = split(text, ".");
    require(parts.size() == 2, "a point of a sequence of vectors is POINT.COMPONENT");
    return {parse_point(parts[0], operators_.variables()), parse_size(parts[1], 0, operators_.components() - 1)};
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

  Family restricted() { return restricted(space_.size()); }
  /// All T_d of the first `columns` vectors, in the coordinates of the space, times the denominator of the mask and the
  /// first coefficient of the vectors.
  Family restricted(std::size_t columns) {
    const std::size_t count = operators_.classes() * (1 + more_powers_.size());
    Family result{space_.size(), Vector(count * columns * space_.size()), operators_.denominator() * factor_};
    for (std::size_t k = 0; k < columns; ++k) {
      std::vector<Sequence> moved = images(space_[k].values);
      for (std::size_t d = 0; d < moved.size(); ++d) {
        for (std::size_t j = 0; j < space_.size(); ++j)
          if (const auto at = moved[d].find(space_[j].pivot); at != moved[d].end())
            result.entries[(d * columns + k) * space_.size() + j] = at->second;
        over_rationals_.reduce(moved[d], space_);
        require(moved[d].empty(), "a transition operator leads out of the space");
      }
    }
    return result;
  }

  /// All words of the length that is returned lead the starts into the space: modulo the space, their span shrinks to
  /// 0.
  std::size_t rounds_into_space(const std::set<Sequence>& starts) {
    std::vector<Row> rest;
    const auto add = [this](std::vector<Row>& rows, Sequence x) {
      over_rationals_.reduce(x, space_);
      over_rationals_.add(rows, std::move(x));
    };
    for (const Sequence& start : starts) add(rest, start);
    std::size_t round = 0;
    for (; !rest.empty(); ++round) {
      require(round < max_rounds, "differences are not led into the space");
      std::vector<Row> next;
      for (const Row& row : rest)
        for (const Sequence& image : images(row.values)) add(next, image);
      rest = std::move(next);
    }
    return round;
  }
  /// The words of at least this length span the space: they do modulo the prime.
  void check_spanned(const std::set<Sequence>& starts, std::size_t length) {
    std::vector<Row> rows;
    for (const Sequence& start : starts) modulo_prime_.add(rows, start);
    for (std::size_t round = 0; round < length; ++round) {
      std::vector<Row> next;
      for (const Row& row : rows)
        for (const Sequence& image : operators_.of(row.values)) modulo_prime_.add(next, image);
      rows = std::move(next);
    }
    for (std::size_t k = 0; k < rows.size() && rows.size() < space_.size(); ++k)
      for (const Sequence& image : operators_.of(Sequence(rows[k].values))) modulo_prime_.add(rows, image);
    require(rows.size() == space_.size(), "the differences do not span the space");
  }
  bool of_vectors_;
  Transition operators_;  // of the power 0 of a parameter
  std::vector<Sequence> more_powers_;
  Reader& reader_;
  Arithmetic& arithmetic_;
  std::vector<Row> space_;
  mpz_class factor_;  // the first coefficient of all vectors
  const Elimination over_rationals_{operators_, false}, modulo_prime_{operators_, true};
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
                           const std::optional<Rationals>& integral, Reader& reader, Arithmetic& arithmetic) {
  require(order <= max_order, "a higher order than the checker allows in several variables");
  const auto is_zero = [](const mpz_class& coefficient) { return coefficient == 0; };
  require(!std::ranges::all_of(mask.coefficients, is_zero), "all coefficients of the mask are 0");
  const bool turned = mask.components == 0 && reader.at("turned");
  const Dilation used = turned ? read_turned(mask, dilation, reader, arithmetic) : dilation;
  const auto surface = std::make_shared<Surface>(mask, used, reader, arithmetic);
  surface->read_digits();
  if (mask.components > 0)
    return {surface->of_values(order, upper, integral), {}, [surface](std::size_t c) {
              return surface->read_component(c, 1);
            }};
  if (of_values)
    return {
        surface->of_values(order, upper, integral),
        [surface, &reader] { return surface->of_scheme(parse_size(reader.take("sum-rules", 1, 1)[0], 1, max_order)); },
        {}};
  SurfaceFamily result{surface->of_scheme(order), {}, {}};
  if (upper || reader.at("gram")) surface->check_stability();
  return result;
}

SurfaceFamily read_vector_over_field(const Mask& doubled, const mpz_class& root, const Dilation& dilation,
                                     std::size_t order, bool upper, const std::optional<Rationals>& integral,
                                     Reader& reader, Arithmetic& arithmetic) {
  require(order <= max_order, "a higher order than the checker allows in several variables");
  const auto surface = std::make_shared<Surface>(doubled, dilation, reader, arithmetic);
  surface->read_digits();
  const FieldFamily family = surface->over_field(order, upper, root, integral);
  return {family.on_halves(), {}, [surface](std::size_t c) { return surface->read_component(c, 2); }, family};
}

SurfaceFamily read_vector_scheme(const Mask& mask, const mpz_class& root, unsigned arity, std::size_t order,
                                 bool hermite, Reader& reader, Arithmetic& arithmetic) {
  const std::size_t size = mask.components, half = root > 0 ? size / 2 : 0;
  std::vector<Rationals> data(order, Rationals(size));
  for (std::size_t s = 0; s < order; ++s) {
    if (hermite && s < size - half) data[s][s] = 1;
    if (!hermite) {
      const Fields fields = reader.take("data", size, size);
      std::transform(fields.begin(), fields.end(), data[s].begin(), parse_rational);
    }
    std::rotate(data[s].begin(), data[s].begin() + static_cast<std::ptrdiff_t>(half), data[s].end());
  }
  Dilation dilation;
  dilation.variables = 1;
  dilation.rows[0][0] = arity;
  Surface surface(mask, dilation, reader, arithmetic);
  surface.read_digits();
  return surface.of_data(mask, data, root > 0 ? &root : nullptr);
}

SurfaceFamily read_vector_scheme(const Mask& mask, const mpz_class& root, const Dilation& dilation, Reader& reader,
                                 Arithmetic& arithmetic) {
  classes(dilation);
  Surface surface(mask, dilation, reader, arithmetic);
  surface.read_digits();
  return surface.of_constants(root > 0 ? &root : nullptr);
}

}  // namespace subcert_check
