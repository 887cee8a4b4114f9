// Specifications of masks of matrices: function vectors, vector schemes and Hermite schemes.

#include "specification_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace subcert {
namespace {

using namespace specification_text;

constexpr std::size_t max_nesting = 5;  // three variables, rows and columns

LatticeMask transposed(const LatticeMask& mask) {
  std::vector<LatticeMask::Term> terms = mask.terms();
  for (LatticeMask::Term& term : terms) std::swap(term.row, term.column);
  return matrix_mask(terms, mask.components(), mask.dilation());
}

/// The key integral, one number for each component, none where it is absent. `root`: that of the mask, or 0; made that
/// of the numbers.
std::vector<QuadraticNumber> read_integral(Fields& fields, std::size_t components, long& root) {
  const auto piece = fields.optional("integral");
  if (!piece) return {};
  std::vector<QuadraticNumber> result;
  for (const Piece& number : read_list(*piece, ',')) {
    result.push_back(placed(number, [&] { return QuadraticNumber::parse(number.text, root); }));
    root = std::max(root, result.back().root);
  }
  if (result.size() != components || std::ranges::all_of(result, &QuadraticNumber::is_zero))
    fail(*piece, fmt::format("{} numbers in brackets, not all 0, the integrals of the functions", components));
  return result;
}

std::string integral_text(const std::vector<QuadraticNumber>& integral) {
  std::vector<std::string> numbers;
  for (const QuadraticNumber& number : integral) numbers.push_back(number.to_text());
  return fmt::format(",integral=[{}]", fmt::join(numbers, ","));
}

std::string title_of(VectorForm form) {
  return form == VectorForm::refinable ? "function vector given by its matrices"
         : form == VectorForm::vector  ? "vector scheme given by its matrices"
                                       : "Hermite scheme given by its matrices";
}

/// The entries but for their roots, or what these are multiplied by.
text::MaskText part_of(const text::MaskTextOf<QuadraticNumber>& parts, Rational QuadraticNumber::*part) {
  text::MaskText result{{}, parts.sizes, parts.first};
  for (const QuadraticNumber& number : parts.coefficients) result.coefficients.push_back(number.*part);
  return result;
}

/// With entries in which one square root stands.
Scheme with_root(VectorForm form, const text::MaskTextOf<QuadraticNumber>& parts, long root, std::size_t components,
                 const Dilation& dilation) {
  std::vector<QuadraticTerm> terms;
  for (const bool is_root : {false, true})
    for (LatticeMask::Term term :
         terms_of(part_of(parts, is_root ? &QuadraticNumber::multiple : &QuadraticNumber::rational),
                  text::Entries::matrices)) {
      if (form != VectorForm::refinable) std::swap(term.row, term.column);
      terms.push_back({term.exponents, term.row, term.column, is_root ? Rational(0) : term.coefficient,
                       is_root ? term.coefficient : Rational(0)});
    }
  text::MaskTextOf<QuadraticNumber> printed = parts;
  if (!printed.first) {
    printed.first.emplace();
    for (std::size_t v = 2; v < parts.sizes.size(); ++v)
      printed.first->push_back(-static_cast<long>(parts.sizes[v] / 2));
  }
  return quadratic_scheme(name_of(form) + ":" + text::print_mask_text(printed) + fields_text(dilation), title_of(form),
                          form, quadratic_mask(terms, components, root, dilation));
}

/// Lists that are nested as deep as the text begins, the innermost two being matrices.
Scheme make_matrices(VectorForm form, const Piece& family, const Piece& body, const std::string& usage) {
  const std::size_t depth = std::min(body.text.find_first_not_of("[ "), body.text.size());
  const auto nesting = static_cast<std::size_t>(
      std::count(body.text.begin(), body.text.begin() + static_cast<long>(depth), '['));
  const std::string lists = "a list of square matrices, as [[[1,0],[1,2]],[[2,1],[0,1]]]/2@0";
  if (nesting < 3 || nesting > max_nesting || (form == VectorForm::hermite && nesting > 3))
    fail(body, lists + (form == VectorForm::hermite ? ", of one variable" : ", of one to three variables"));
  const int variables = static_cast<int>(nesting) - 2;
  auto [mask, fields] = split_mask(family, body, usage, variables, max_entries);
  const auto parts = placed(
      mask, [&mask = mask, variables] { return text::parse_quadratic_mask_text(mask.text, variables); });
  const std::size_t components = read_components(parts, mask);
  const Dilation dilation = read_dilation(fields, static_cast<std::size_t>(variables));
  long root = std::ranges::max_element(parts.coefficients, {}, &QuadraticNumber::root)->root;
  const std::vector<QuadraticNumber> integral = read_integral(fields, components, root);
  fields.finish();
  Scheme scheme = checked(mask, [&, &mask = mask] {
    if (root > 0) return with_root(form, parts, root, components, dilation);
    const LatticeMask given = matrix_mask(terms_of(part_of(parts, &QuadraticNumber::rational), text::Entries::matrices),
                                          components, dilation);
    return vector_scheme(form, title_of(form), form == VectorForm::refinable ? given : transposed(given));
  });
  if (integral.empty()) return scheme;
  scheme.specification += integral_text(integral);
  scheme.integral.emplace();
  for (const QuadraticNumber& number : integral) scheme.integral->push_back(number.rational);
  if (root > 0)
    for (const QuadraticNumber& number : integral) scheme.integral->push_back(number.multiple);
  return scheme;
}

Family of_matrices(VectorForm form, const std::string& meaning) {
  const std::string name = name_of(form), usage = name + ":[[[1,0],[1,2]],[[2,1],[0,1]]]/2@0";
  return {{name, usage, meaning}, [form](const Piece& family, const Piece& body, const std::string& help) {
            return make_matrices(form, family, body, help);
          }};
}

const std::vector<Family>& vector_table() {
  static const std::vector<Family> families = [] {
    std::vector<Family> list{
        of_matrices(VectorForm::refinable,
                    "the functions phi(x) = sum over k of A_k phi(2x - k), A_k matrices, rows in brackets; optional "
                    "arity=2 or dilation=[1,1;1,-1], and integral=[1,0], that of phi, where there are several"),
        of_matrices(VectorForm::vector,
                    "the scheme f'_i = sum over j of P_{i-2j} f_j on vectors, so that A_k is P_k transposed"),
        of_matrices(VectorForm::hermite,
                    "the scheme D^(n+1) f'_i = sum over j of P_{i-2j} D^n f_j on values and derivatives, D = "
                    "diag(1,1/2,1/4,...)")};
    list.insert(list.end(), named_vectors().begin(), named_vectors().end());
    return list;
  }();
  return families;
}

Scheme refinable_scheme_of(std::string_view specification) {
  if (auto scheme = make_one_of(vector_table(), specification)) return *std::move(scheme);
  return make_linear_scheme(specification);
}

}  // namespace

std::optional<VectorForm> specification_text::form_of(std::string_view family) {
  for (const VectorForm form : {VectorForm::refinable, VectorForm::vector, VectorForm::hermite})
    if (name_of(form) == family) return form;
  return std::nullopt;
}

Scheme specification_text::quadratic_scheme(const std::string& specification, const std::string& title, VectorForm form,
                                            const QuadraticMask& mask) {
  constexpr long bits = 256;
  Rational largest = 0;
  for (const LatticeMask::Term& term : mask.doubled.terms())
    if (term.row >= mask.components() && term.column < mask.components())
      largest = std::max(largest, abs(term.coefficient));
  return {specification,
          title,
          mask.at(rounded_root(mask.root, bits)),
          {},
          MaskRounding{largest * power(Rational(2), -bits), 0},
          form,
          mask};
}

std::string specification_text::name_of(VectorForm form) {
  return form == VectorForm::refinable ? "refinable" : form == VectorForm::vector ? "vector" : "hermite";
}

Scheme vector_scheme(VectorForm form, const std::string& title, const LatticeMask& mask) {
  return {name_of(form) + ":" + to_mask_text(form == VectorForm::refinable ? mask : transposed(mask)) +
              fields_text(mask.dilation()),
          title,
          mask,
          {},
          {},
          form};
}

Scheme make_refinable_scheme(std::string_view specification) {
  return from_written(specification, refinable_scheme_of);
}

const std::vector<FamilyHelp>& vector_families() {
  static const std::vector<FamilyHelp> help = help_of(vector_table());
  return help;
}

}  // namespace subcert
