// The lines of a certificate, and what they prove of a claim; the parts are beside this file. Section numbers refer to
// ../certificates/SPEC.md, which proves each step.
#include "check.hpp"

#include "blocks.hpp"
#include "claim.hpp"
#include "frequency.hpp"
#include "graph.hpp"
#include "levels.hpp"
#include "product.hpp"
#include "single.hpp"
#include "subradius.hpp"
#include "surfaces/vertex.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

namespace subcert_check {
namespace {

constexpr unsigned most_exponent = 10'000;
constexpr const char* not_attained = "no block attains the exact radius";

class Checker {
 public:
  Checker(const Claim& claim, Reader& reader)
      : claim_(claim), reader_(reader), lower_(claim.lower), upper_(claim.upper), strict_(claim.is_strict()) {}

  /// Returns if the certificate proves the claim.
  void run() {
    reader_.take("subcert-certificate 3", 0, 0);
    reader_.take(claim_.head, 0, 0);
    require(!claim_.subradius || is_nonnegative(claim_.family.entries), "a matrix is not non-negative");
    const Fields bounds = reader_.take("bounds", 2, 2);  // for people: any claim may be asked
    if (bounds[0] != "-") parse_rational(bounds[0]);
    if (bounds[1].starts_with('C'))
      parse_size(bounds[1].substr(1), 1, 500);
    else if (bounds[1] != "-")
      parse_rational(bounds[1]);
    if (claim_.rounding && (claim_.exact || reader_.at("attains")))
      read_product_of_claim();
    else if (claim_.exact || (!claim_.l1 && reader_.at("exact")))
      read_exact();
    if (claim_.subradius)
      read_subradius(claim_.family, {claim_.lower, claim_.upper, exact_}, reader_, arithmetic_);
    else if (claim_.l1)
      read_l1();
    else
      read_proof();
    if (claim_.vertex)
      check_vertex(*claim_.mask, *claim_.dilation, *claim_.vertex, claim_.not_c1, reader_, arithmetic_);
    reader_.take("end", 0, 0);
    require(reader_.at_end(), "text after 'end'");
  }

 private:
  /// What follows these lines, but of a subradius.
  void read_proof() {
    if (claim_.recurrence) read_recurrence(*claim_.recurrence, *claim_.range, reader_, arithmetic_);
    if (claim_.limit) exponentials_ = claim_.limit->read(claim_.arity, reader_, arithmetic_);
    if (claim_.list && !claim_.on_vectors) check_constants(*claim_.list);
    if (claim_.is_of_choices())
      read_bounds(read_choices(), false);
    else if (claim_.arity != 0 && !claim_.is_of_values() && !claim_.on_vectors && !claim_.limit &&
             reader_.at("reduced"))
      read_reduced();
    else if (const Family family = claim_.mask ? read_scheme(*claim_.mask) : claim_.family; claim_.range)
      read_intervals(family);
    else if (over_field_ || !family.entries.empty()) {
      read_bounds(family, claim_.arity != 0 && !claim_.on_vectors);
      show_attained(claim_.mask);
      if (of_scheme_) show_convergence(of_scheme_(), 1, false);
    }
  }

  /// Section 4.16: the contraction of the claim, or one by which limits have the exponent of the claim.
  void read_l1() {
    const Contraction proved = read_contraction(*claim_.l1, reader_, arithmetic_);
    require(!claim_.contraction || *claim_.contraction == proved, "the claim is about another contraction");
    if (claim_.lower)
      require(proved.bound <=
                  power_of_exponent(static_cast<unsigned>(claim_.l1->arity), *claim_.lower * mpz_class(proved.steps)),
              "the contraction does not prove the lower end");
    if (!claim_.upper && !reader_.at("orbit")) return;
    require(proved.bound < 1, "an orbit proves nothing where no limits are proved");
    const L1Orbit orbit = read_orbit(*claim_.l1, reader_, arithmetic_);
    if (!claim_.upper) return;
    require(abs(orbit.factor) >= 1 / power_of_upper(2, *claim_.upper * mpz_class(orbit.steps)),
            "the orbit does not prove the upper end");
  }

  /// Section 4.10: the number that the joint spectral radius is said to be.
  void read_exact() {
    require(!claim_.is_strict() && !claim_.on_vectors && !claim_.rounding,
            "exact numbers are those of one mask or family");
    if (claim_.exact) {
      reader_.take("exact " + claim_.exact_text, 0, 0);
      exact_ = claim_.exact;
      exact_order_ = claim_.exact_order;
    } else {
      std::tie(exact_, exact_order_) = parse_exact(reader_.take("exact", 1, 1)[0], claim_.mask || claim_.list);
    }
    read_root(*exact_, reader_, arithmetic_);
  }

  /// Section 7.1: the product that attains the radius for all masks near by.
  void read_product_of_claim() {
    const Fields fields = reader_.take("attains", 3, 3);
    require(!claim_.exact || fields[0] == claim_.exact_text, "the claim is about another product");
    exact_ = parse_attained(fields);
    exact_order_ = claim_.rounding->sum_rules;
  }

  /// Section 4.9: the exponent of another mask, and convergence of the scheme.
  void read_reduced() {
    const Mask& mask = *claim_.mask;
    // `stability` is shown of the reduced mask: nothing follows from it for the mask of the claim.
    require((claim_.lower || (exact_ && (claim_.exact || claim_.rough))) && !claim_.rounding,
            "a reduced mask tells the exponent of one mask, with a lower end");
    const Fields fields = reader_.take("reduced", 2, 2);
    const Mask factor = parse_mask(fields[0], '\0'), other = parse_mask(fields[1], '\0');
    for (const Mask* one : {&factor, &other})
      require(one->sizes.size() == 1 && one->points() <= 1000 && one->coefficients.front() != 0 &&
                  one->coefficients.back() != 0,
              "a reduced mask and its factor have 1 to 1000 coefficients, the first and the last not zero");
    const Vector& p = factor.coefficients;
    require(std::accumulate(p.begin(), p.end(), mpz_class(0)) != 0, "the factor of the reduced mask is 0 at 1");
    Vector left = product_of_symbols(mask.coefficients, p, 1, arithmetic_),
           right = product_of_symbols(other.coefficients, p, claim_.arity, arithmetic_);
    for (mpz_class& x : left) x *= other.denominator;
    for (mpz_class& x : right) x *= mask.denominator;
    require(left == right, "the reduced mask is not that of the mask and the factor");
    read_bounds(read_scheme(other), true);
    show_attained(other);
    const std::size_t sum_rules = parse_size(reader_.take("sum-rules", 1, 1)[0], 1, 500);
    show_convergence(transition_family(mask, claim_.arity, sum_rules), power(claim_.arity, sum_rules), true);
  }

  /// Sections 4.9 and 5.6, after all that was to be shown of something else: the radius is below the limit.
  void show_convergence(const Family& family, const mpq_class& limit, bool first_columns) {
    exact_.reset();
    lower_.reset();
    upper_ = limit;
    root_ = 1;
    strict_ = true;
    read_bounds(family, first_columns);
  }

  /// Sections 6.1 and 6.5: intervals that cover the range, one after another; one where values change.
  void read_intervals(const Family& powers) {
    const mpq_class& high = claim_.range->high;
    for (mpq_class reached = claim_.range->low; (lower_ || upper_) && reached < high;) {
      const mpq_class next = parse_rational(reader_.take("to", 1, 1)[0]);
      require(reached < next && next <= high, "an interval ends outside of the rest of the range");
      require(!claim_.levels || next == high, "a claim about sequences of values has one interval");
      const Range interval{claim_.range->letter, reached, next};
      Controls controls = control_family(powers, claim_.mask->divisor, interval, arithmetic_);
      weights_ = std::move(controls.weights);
      read_bounds(controls.family, false);
      reached = next;
    }
  }

  /// Bounds of the radius. `first_columns`: the entries of the first columns of products are those of all columns.
  void read_bounds(const Family& family, bool first_columns) {
    const bool divided = reader_.at("blocks");
    require(!divided || entry_error_ == 0, "blocks prove nothing of rounded masks");
    require(divided || component_.unobservable == 0, "expected 'blocks', those of what is unobservable first");
    std::vector<Family> blocks{family};
    if (over_field_)
      blocks = near_blocks(divided);
    else if (divided)
      std::tie(blocks, unobservable_blocks_) = read_blocks(family, component_, reader_, arithmetic_);
    if (lower_ || by_sequence_ || reader_.at("product")) read_product(blocks);
    const bool sections = upper_ || exact_ || reader_.at("block 0");
    const auto goal = std::tuple(upper_, strict_, exact_);
    for (std::size_t i = 0; sections && i < blocks.size(); ++i) {
      if (i < unobservable_blocks_)  // phi is continuous: their radius is below 1
        std::tie(upper_, strict_, exact_) = std::tuple(mpq_class(1), true, std::nullopt);
      else
        std::tie(upper_, strict_, exact_) = goal;
      use_block(i);
      read_section(family, blocks[i], i, first_columns && !divided);
    }
  }

  /// Section 5.13: rational matrices near those of the blocks over the field.
  std::vector<Family> near_blocks(bool divided) {
    field_blocks_ = {*over_field_};
    if (divided)
      std::tie(field_blocks_, unobservable_blocks_) = read_field_blocks(*over_field_, component_, reader_, arithmetic_);
    std::vector<Family> blocks;
    for (const FieldFamily& block : field_blocks_) {
      NearFamily near = near_family(block);
      blocks.push_back(std::move(near.family));
      entry_errors_.push_back(near.error);
    }
    return blocks;
  }
  /// What is known of the numbers of a block.
  void use_block(std::size_t i) {
    if (!over_field_) return;
    entry_error_ = entry_errors_[i];
    field_block_ = entry_error_ > 0 ? &field_blocks_[i] : nullptr;
  }

  void read_section(const Family& family, const Family& block, std::size_t i, bool first_columns) {
    const Fields fields = reader_.take("block " + std::to_string(i), 2, 8);
    if (fields[0] == "norm")
      read_norm(block, fields, first_columns ? 1 : block.size);
    else if (fields[0] == "single" && first_columns && entry_error_ == 0)
      use_single(read_single(family, fields, exact_ ? &*exact_ : nullptr, reader_, arithmetic_));
    else if (fields[0] == "frequency" && first_columns && entry_error_ == 0)
      use_upper_bound(read_frequency(family, fields, reader_, arithmetic_), 1);
    else if (fields[0] == "quadratic" && entry_error_ == 0)
      use_graph(read_quadratic(block, fields, exact_ ? &*exact_ : nullptr, reader_, arithmetic_));
    else if (fields[0] == "graph" && entry_error_ == 0)
      use_graph(read_graph(block, fields, exact_ ? &*exact_ : nullptr, reader_, arithmetic_));
    else {
      const bool symmetric = std::ranges::find(fields, "symmetric") != fields.end();
      require(!field_block_ || !symmetric || field_block_->is_mirrored(), "the family is not symmetric");
      use_polytope(read_polytope(block, fields, entry_error_, reader_, arithmetic_));
    }
  }

  /// Section 6.5: all masks, or the ends of the range for each new point, and what is to be shown of them.
  Family read_choices() {
    require(!exact_, "an exact number is that of one mask or family");
    const Fields fields = reader_.take("sum-rules", 1, claim_.each_point ? 2 : 1);
    const std::size_t sum_rules = sum_rules_ = parse_size(fields[0], 1, 500);
    const bool transposed = fields.size() == 2;
    require(!transposed || fields[1] == "transposed", "expected 'transposed' or nothing");
    show_exponent(claim_.arity, power(claim_.arity, sum_rules), sum_rules);
    by_sequence_ = claim_.list && (claim_.upper || reader_.at("stability"));
    if (by_sequence_) reader_.take("stability", 0, 0);
    if (!claim_.each_point) return list_family(*claim_.list, sum_rules);
    Family family = each_point_family(*claim_.mask, claim_.arity, *claim_.range, sum_rules, arithmetic_);
    if (transposed) family.reflect();
    return family;
  }

  /// Section 6.7: of a vector scheme.
  Family read_vectors(const Mask& mask) {
    const std::size_t order = parse_size(reader_.take("sum-rules", 1, 1)[0], 1, 64), size = claim_.functions();
    show_exponent(claim_.arity, power(claim_.arity, order), order);
    const mpq_class end = claim_.lower ? *claim_.lower : *claim_.upper;
    require(end < mpz_class(order) || (!claim_.is_strict() && end == mpz_class(order)),
            "the end is not below the number of sum rules");
    require(!claim_.hermite || end + 1 >= mpz_class(size),
            "a Hermite scheme is asked for fewer derivatives than its data are");
    if (claim_.hermite && claim_.upper) check_interpolation(mask, size, claim_.arity);
    SurfaceFamily found = read_vector_scheme(mask, claim_.root, claim_.arity, order, claim_.hermite, reader_,
                                             arithmetic_);
    over_field_ = std::move(found.over_field);
    return claim_.list ? along(*claim_.list, found.family) : std::move(found.family);
  }

  /// Section 6.11: the same with a dilation.
  Family read_vectors_of_dilation(const Mask& mask) {
    SurfaceFamily found = read_vector_scheme(mask, claim_.root, *claim_.dilation, reader_, arithmetic_);
    over_field_ = std::move(found.over_field);
    require(over_field_ || !found.family.entries.empty() || claim_.upper,
            "a scheme that keeps no constant data does not converge");
    (claim_.lower ? upper_ : lower_) = 1;
    (claim_.lower ? lower_ : upper_).reset();
    return std::move(found.family);
  }

  /// The transition matrices of the mask, and what is to be shown of them.
  Family read_scheme(const Mask& mask) {
    if (claim_.on_vectors) return claim_.dilation ? read_vectors_of_dilation(mask) : read_vectors(mask);
    const bool of_values = claim_.dilation && (mask.components > 0 || reader_.at("differences"));
    const Fields order = reader_.take(of_values ? "differences" : "sum-rules", 1, claim_.arity != 0 ? 2 : 1);
    const std::size_t sum_rules = sum_rules_ = parse_size(order[0], 1, 500);
    const bool full = order.size() > 1, is_word_full = full && order[1] == "full";
    if (claim_.dilation) {
      show_exponent(classes(*claim_.dilation), 1, sum_rules);
      require(!of_values || !claim_.lower || *claim_.lower <= mpz_class(sum_rules),
              "the lower end is above the order of the differences");
      root_ = claim_.dilation->variables;
      show_exact_exponent(1, 0);
      SurfaceFamily surface = claim_.root > 0
                                  ? read_vector_over_field(mask, claim_.root, *claim_.dilation, sum_rules,
                                                           claim_.upper || exact_, claim_.integral, reader_,
                                                           arithmetic_)
                                  : read_surface(mask, *claim_.dilation, sum_rules, of_values, claim_.upper || exact_,
                                                 claim_.integral, reader_, arithmetic_);
      of_scheme_ = std::move(surface.of_scheme);
      if (claim_.component) {
        component_ = surface.of_component(*claim_.component);
        if (claim_.upper || exact_) check_observable(component_, surface.family, arithmetic_);
      }
      over_field_ = std::move(surface.over_field);
      return std::move(surface.family);
    }
    check_sum(mask, claim_.arity);
    if (claim_.limit) claim_.limit->check_factors(claim_.arity, sum_rules, exponentials_, arithmetic_);
    show_exponent(claim_.arity, power(claim_.arity, sum_rules), sum_rules);
    show_exact_exponent(power(claim_.arity, sum_rules), sum_rules);
    const bool diverges = claim_.range && claim_.upper && *claim_.upper == 0;
    if (claim_.rough || exact_ || (claim_.upper && !diverges) || !(claim_.lower || claim_.upper) ||
        reader_.at("stability")) {
      reader_.take("stability", 0, 0);
      const mpq_class error = claim_.rounding ? claim_.rounding->distance * mask.denominator : mpq_class(0);
      check_stability(mask, claim_.arity, sum_rules, claim_.range.value_or(Range{}), error, arithmetic_);
    }
    if (claim_.rounding) {
      require(sum_rules == claim_.rounding->sum_rules, "the claim is about masks with another number of sum rules");
      entry_error_ = entry_error(mask, claim_.arity, *claim_.rounding);
    }
    const Family family = transition_family(mask, claim_.arity, sum_rules);
    if (full) {
      require(is_word_full && !claim_.rounding && !claim_.limit,
              "expected 'sum-rules M', or 'sum-rules M full' of one mask");
      check_full_sum_rules(family, mask.powers - 1, claim_.range.value_or(Range{}), arithmetic_);
      const mpz_class end = sum_rules;
      if (claim_.upper && (claim_.range ? *claim_.upper > end : *claim_.upper >= end)) lower_.reset();
    }
    require(!claim_.rough || (full && *claim_.rough >= sum_rules),
            "less smoothness than that needs the full number of sum rules, and no more of them");
    return family;
  }

  /// At most base^-exponent, for a lower end of an exponent.
  mpq_class power_of_exponent(unsigned base, const mpq_class& lower) const {
    require(lower > 0 || (claim_.is_strict() && lower == 0), "the lower end of an exponent must be positive");
    require(lower <= most_exponent, "the lower end of an exponent is too large");
    const mpz_class whole = lower.get_num() / lower.get_den() + 1;
    return power_lower(base, whole - lower) / power(base, whole.get_ui());
  }

  /// At most base^exponent, for an upper end.
  static mpq_class power_of_upper(unsigned base, const mpq_class& upper) {
    require(upper >= 0 && upper <= most_exponent, "an exponent is negative or too large");
    return power_lower(base, upper);
  }

  /// An exponent s of a scheme of this order m of sum rules says JSR^root = factor * base^-s, provided that s < m.
  void show_exponent(unsigned base, const mpq_class& factor, std::size_t order) {
    lower_.reset();
    upper_.reset();
    above_ = factor / power(base, order);
    if (claim_.lower) {
      upper_ = factor * power_of_exponent(base, *claim_.lower);
    }
    if (claim_.upper) lower_ = factor / power_of_upper(base, *claim_.upper);
  }

  /// The radius is below that of no exponent and above that of as many derivatives as there are sum rules.
  void show_exact_exponent(const mpq_class& factor, std::size_t order) const {
    if (!exact_) return;
    require(exact_order_ == order, "the exact exponent has another number before its logarithm");
    require(power(exact_->low, root_) > above_ && power(exact_->high, root_) < factor,
            "the exact radius proves no exponent between 0 and the number of sum rules");
  }

  /// A lower bound of the radius.
  void read_product(const std::vector<Family>& blocks) {
    const Fields fields = reader_.take("product", 4, 3 + 4096);
    const std::size_t block = parse_size(fields[0], unobservable_blocks_, blocks.size() - 1);
    const Family& family = blocks[block];
    use_block(block);
    GivenProduct given{{}, parse_rational(fields[1]), parse_rational(fields[2])};
    for (std::size_t i = 3; i < fields.size(); ++i)
      given.letters.push_back(parse_size(fields[i], 0, family.count() / weights_.size() - 1));
    mpq_class radius = abs(given.re + given.im);  // JSR^length is at least that, over a range above it
    if (claim_.is_of_values())
      check_eigenvalue(family, weights_, given.letters, given.re, given.im, arithmetic_);
    else
      radius = spectral_radius_bound(family, given, entry_error_, reader_, arithmetic_);
    if (by_sequence_) check_stability(*claim_.list, given.letters, sum_rules_, arithmetic_);
    if (!lower_) return;
    const mpq_class value = power(radius, root_), least = power(above_, given.letters.size());
    require(value > least || (claim_.is_of_values() && value == least),
            "the product proves no exponent below the number of sum rules");
    require(*lower_ <= 0 || value >= power(*lower_, given.letters.size()),
            "the product's spectral radius does not prove the claim");
  }

  /// Section 4.6, with the first columns of the products.
  void read_norm(const Family& family, const Fields& fields, std::size_t columns) {
    require(fields.size() == 2, "wrong number of fields after 'norm'");
    const std::size_t level = parse_size(fields[1], 1, 64);
    use_upper_bound(norm_of_products(family, level, columns, arithmetic_) + change_of(family, entry_error_, level),
                    level);
  }

  void use_polytope(const Polytope& body) {
    const bool attained = exact_ && reader_.at("cycle");
    const FamilyError error{entry_error_, claim_.rounding && claim_.rounding->symmetric, field_block_};
    if (attained) check_attained(body, *exact_, error, reader_, arithmetic_);
    use_graph({body.bound, attained});
  }
  /// Of a polytope as well.
  void use_graph(const GraphBound& graph) {
    if (!graph.attained) return use_upper_bound(graph.bound, 1);
    attained_ = true;
    ++reaching_;
    show_upper_bound(graph.bound, 1);
  }
  void use_single(const SingleRadius& single) {
    attained_ = true;
    by_single_ = true;
    power_ = single.power;
    show_upper_bound(single.bound, 1);
  }

  /// Compares the proved JSR(block)^exponent <= value with what is to be shown of each block.
  void use_upper_bound(const mpq_class& value, std::size_t exponent) {
    if (exact_) {
      const mpq_class low = power(exact_->low, exponent);
      require(value <= low, "the bound of a block is above the exact radius");
      if (value == low) ++reaching_;
    }
    show_upper_bound(value, exponent);
  }
  void show_upper_bound(const mpq_class& value, std::size_t exponent) const {
    if (!upper_) return;
    const mpq_class proved = power(value, root_), wanted = power(*upper_, exponent);
    require(*upper_ >= 0 && (strict_ ? proved < wanted : proved <= wanted), "the bound does not prove the claim");
  }

  /// Some block has the exact radius; and section 4.12.
  void show_attained(const std::optional<Mask>& mask) {
    if (!exact_) return;
    require(attained_, not_attained);
    if (claim_.arity != 0 && !claim_.limit && reader_.at("logarithm")) read_logarithm(*mask);
    require(!claim_.logarithm || logarithm_ == claim_.logarithm, "the logarithm of the claim is not proved");
  }

  void read_logarithm(const Mask& mask) {
    const Fields fields = reader_.take("logarithm", 1, 3);
    logarithm_ = parse_size(fields[0], 0, 256);
    std::size_t order = sum_rules_;  // of the differences whose growth tells the modulus
    mpz_class least = 1;             // power of the arity that is not below the radius
    for (; least < exact_->low; least *= claim_.arity) --order;
    if (least > exact_->high) {
      require(fields.size() == 1, "expected 'logarithm' and a number, as the exponent is no integer");
      require(by_single_ || reaching_ == 1, "more than one block has the exact radius");
      require(logarithm_ == power_, "products grow with another power");
      return;
    }
    require(exact_->low == exact_->high, "the exponent may be an integer");
    const Family family = transition_family(mask, claim_.arity, order);
    if (fields.size() > 1) {
      require(fields.size() == 3 && fields[1] == "norm" && logarithm_ == 0, "expected 'logarithm 0 norm LEVEL'");
      require(norm_of_products(family, parse_size(fields[2], 1, 64), 1, arithmetic_) <= 1,
              "the norm of products is above 1");
    } else {
      require(by_single_ && (sum_rules_ - order) % 2 == 0, "the differences of this order need a norm");
      ExactRadius one;
      one.polynomial = {-1, 1};
      one.re = one.near_re = one.low = one.high = 1;
      require(logarithm_ == read_power(family, one, reader_, arithmetic_), "products grow with another power");
    }
  }

  const Claim& claim_;
  Reader& reader_;
  Arithmetic arithmetic_;
  Vector weights_{1};                         // of the control matrices
  mpq_class entry_error_ = 0;                 // of the matrices, where the mask is rounded
  std::optional<FieldFamily> over_field_;     // section 5.13: of matrices with a square root,
  std::vector<FieldFamily> field_blocks_;     // their blocks,
  Rationals entry_errors_;                    // the errors of these,
  const FieldFamily* field_block_ = nullptr;  // and the block of the section, if it is not rational
  // What is to be shown: lower <= JSR^root <= upper (`strict`: <); JSR^root > above, where there is a lower end.
  std::optional<mpq_class> lower_, upper_;
  bool strict_;
  mpq_class above_ = 0;
  std::size_t root_ = 1;
  std::function<Family()> of_scheme_;    // with `values`: what tells whether the scheme converges
  Component component_;                  // of which the claim is,
  std::size_t unobservable_blocks_ = 0;  // and the first blocks, which it does not show
  std::optional<ExactRadius> exact_;
  std::size_t exact_order_ = 0;
  std::size_t sum_rules_ = 0;
  bool by_sequence_ = false;               // section 6.5: a product says of which sequence of masks there is more
  std::vector<std::size_t> exponentials_;  // section 6.10: the factors of the masks beside these
  bool attained_ = false;                  // a block has the exact radius
  std::size_t reaching_ = 0;               // blocks that have it, or may have it
  bool by_single_ = false;                 // or one spectral radius tells it,
  std::size_t power_ = 0;                  // and how products grow
  std::optional<std::size_t> logarithm_;
};

}  // namespace

int run(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& errors) {
  try {
    if (arguments == std::vector<std::string>{"--help"}) throw Rejected{usage, 0};
    const Claim claim = read_claim(arguments);
    read(claim.file, 1, [&](Reader& reader) { Checker(claim, reader).run(); });
    out << "VERIFIED " << claim.text << std::endl;
    return out ? 0 : 1;
  } catch (const Rejected& rejected) {
    const std::string prefix = rejected.code == 0 ? "" : rejected.code == 1 ? "REJECTED " : "subcert-check: ";
    (rejected.code <= 1 ? out : errors) << prefix << rejected.why << std::endl;
    return out ? rejected.code : 1;
  } catch (const std::exception& error) {
    out << "REJECTED " << error.what() << ", line 0" << std::endl;
    return 1;
  }
}

}  // namespace subcert_check
