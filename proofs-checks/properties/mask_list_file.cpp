#include "mask_list_table.hpp"

#include <subcert/schemes/specification.hpp>

#include <fmt/format.h>

namespace subcert::properties {
namespace {

constexpr std::size_t most_masks = 64, most_pairs = 4096, longest_period = 6;

/// The items of a list.
const toml::array& list_of(const toml::node& node, const char* key, const char* items, std::size_t least,
                           std::size_t most) {
  const auto* list = node.as_array();
  if (!list || list->size() < least || list->size() > most)
    throw FileError(place_of(node), fmt::format("'{}' takes a list of {} to {} {}", key, least, most, items));
  return *list;
}

std::size_t number_of_mask(const toml::node& node, std::size_t count) {
  const auto* number = node.as_integer();
  if (!number || number->get() < 0 || static_cast<std::size_t>(number->get()) >= count)
    throw FileError(place_of(node), fmt::format("expected the number of a mask, 0 to {}", count - 1));
  return static_cast<std::size_t>(number->get());
}

/// Of one variable.
Scheme scheme_of(std::string_view specification) {
  Scheme scheme = make_refinable_scheme(specification);
  if (!scheme.form) return make_scheme(specification);
  if (scheme.mask.dimension() != 1)
    fail(ErrorKind::data, "expected masks of one variable, got {}", scheme.specification);
  return scheme;
}

}  // namespace

void add_mask(MaskListFile& file, std::string_view specification) {
  const Scheme scheme = scheme_of(specification);
  if (scheme.rounding) fail(ErrorKind::data, "expected a scheme with exact coefficients, got {}", scheme.specification);
  const LatticeMask& mask = scheme.mask;
  const bool is_hermite = scheme.form == VectorForm::hermite;
  if (!file.list.masks.empty()) {
    const LatticeMask& first = file.list.masks.front();
    if (mask.arity() != first.arity())
      fail(ErrorKind::data, "expected masks of one arity, got {} and {}", first.arity(), mask.arity());
    if (mask.components() != first.components())
      fail(ErrorKind::data, "expected matrices of one size, got {} and {} rows", first.components(), mask.components());
    if (is_hermite != file.list.hermite)
      fail(ErrorKind::data, "expected Hermite schemes alone or none, got {} and {}", file.specifications.front(),
           scheme.specification);
  }
  file.list.hermite = is_hermite;
  file.specifications.push_back(scheme.specification);
  file.list.masks.push_back(mask);
}

void require_common_data(const MaskList& list) {
  if (list.masks.front().components() > 1 && kept_polynomials(list).data.empty())
    fail(ErrorKind::data,
         "expected constant data that all masks of matrices keep, one vector up to a factor, got none (perhaps the "
         "matrices are transposed)");
}

namespace {

void add_mask_of(MaskListFile& file, const toml::node& node) {
  const auto* text = node.as_string();
  if (!text) throw FileError(place_of(node), "'masks' takes specifications of schemes in quotes");
  try {
    add_mask(file, text->get());
  } catch (const Error& error) {
    throw FileError(place_of(node), error.what());
  }
}

}  // namespace

MaskListFile mask_list_of(const toml::table& table) {
  const toml::node *masks = table.get("masks"), *period = table.get("period"), *follows = table.get("follows");
  if (!masks) throw FileError({1, 1}, "no masks; expected masks = [\"dd:n=2\", ...]");
  if (period && follows) throw FileError(place_of(*follows), "'follows' beside 'period'; expected one of them");
  MaskListFile file;
  for (const toml::node& node : list_of(*masks, "masks", "specifications of schemes", 1, most_masks))
    add_mask_of(file, node);
  try {
    require_common_data(file.list);
  } catch (const Error& error) {
    throw FileError(place_of(*masks), error.what());
  }
  const std::size_t count = file.list.masks.size();
  if (period)
    for (const toml::node& node : list_of(*period, "period", "numbers of masks", 1, longest_period))
      file.list.period.push_back(number_of_mask(node, count));
  if (follows)
    for (const toml::node& node : list_of(*follows, "follows", "pairs [BEFORE, AFTER]", 1, most_pairs)) {
      const toml::array& pair = list_of(node, "follows", "numbers in each pair [BEFORE, AFTER]", 2, 2);
      file.list.follows.emplace_back(number_of_mask(*pair.get(0), count), number_of_mask(*pair.get(1), count));
    }
  if (follows && !has_sequence(file.list))
    throw FileError(place_of(*follows), "no sequence of masks goes on for ever; expected pairs that come round again");
  return file;
}

MaskListFile read_mask_list(std::string_view text) {
  const toml::table table = parse_toml(text);
  for (const auto& [key, node] : table)
    if (key.str() != "masks" && key.str() != "period" && key.str() != "follows")
      throw FileError(place_of(key.source()),
                      "unknown key " + in_quotes(key.str()) + "; expected masks, period or follows");
  return mask_list_of(table);
}

}  // namespace subcert::properties
