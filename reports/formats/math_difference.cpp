#include "math_difference.hpp"

#include <subcert/analysis/symbol/utf8.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <ranges>

namespace subcert::formats {
namespace {

using Kind = MathNode::Kind;

struct Leaf {
  MathNode* node;
  std::string key;
  bool separates;        ///< a relation or a comma outside of brackets and arguments
  std::size_t part = 0;  ///< the number of separators in front
};

void collect(MathNode& node, const std::string& role, bool top, std::vector<Leaf>& list) {
  if (is_leaf(node))
    list.push_back({&node,
                    role +
                        (node.kind == Kind::word ? "word "
                         : node.upright          ? "upright "
                                                 : " ") +
                        trimmed(node.text),
                    top && (node.atom == Atom::relation || node.atom == Atom::punctuation)});
  for (std::size_t i = 0; i < node.parts.size(); ++i) {
    std::string inner;
    if (has_scripts(node) && i > 0) inner = node.kind == Kind::superscript || i == 2 ? "^" : "_";
    if (node.kind == Kind::fraction || node.kind == Kind::small) inner = i == 0 ? "over " : "under ";
    if (node.kind == Kind::binomial) inner = i == 0 ? "of " : "choose ";
    if (node.kind == Kind::root) inner = i == 0 ? "root " : "degree ";
    if (node.kind == Kind::accent && i == 1) inner = "accent ";
    collect(node.parts[i], role + inner, false, list);
  }
}

/// Leaves a..a_end of the one and b..b_end of the other are equal or not.
struct Block {
  bool equal;
  std::size_t a, a_end, b, b_end;
};

/// Numbers the parts between the separators, which it returns.
std::vector<std::string> separators(std::vector<Leaf>& list) {
  std::vector<std::string> keys;
  for (Leaf& leaf : list) {
    leaf.part = keys.size();
    if (leaf.separates) keys.push_back(leaf.key);
  }
  return keys;
}

/// Of the common subsequences one with the largest sum of its length and the number of neighbours in both that stay
/// neighbours, so that it keeps together what belongs together; part by part where the separators are the same, so that
/// the numbers of a list are compared in their order.
std::vector<Block> common_blocks(std::vector<Leaf>& a, std::vector<Leaf>& b) {
  const std::size_t width = b.size() + 1;
  // The largest sum from (i, j) on, where the leaves in front are no pair, and where they are one.
  std::vector<std::array<std::uint16_t, 2>> best((a.size() + 1) * width, {0, 0});
  const auto at = [&](std::size_t i, std::size_t j) -> std::array<std::uint16_t, 2>& { return best[i * width + j]; };
  const bool by_parts = separators(a) == separators(b);
  const auto is_pair = [&](std::size_t i, std::size_t j) {
    return i < a.size() && j < b.size() && a[i].key == b[j].key && (!by_parts || a[i].part == b[j].part);
  };
  const auto with_pair = [&](std::size_t i, std::size_t j, int behind_pair) {
    return static_cast<std::uint16_t>(at(i + 1, j + 1)[1] + 1 + behind_pair);
  };
  for (std::size_t i = a.size(); i-- > 0;)
    for (std::size_t j = b.size(); j-- > 0;)
      for (const int behind_pair : {0, 1}) {
        const std::uint16_t without = std::max(at(i + 1, j)[0], at(i, j + 1)[0]);
        at(i, j)[static_cast<std::size_t>(behind_pair)] = is_pair(i, j)
                                                              ? std::max(without, with_pair(i, j, behind_pair))
                                                              : without;
      }
  std::vector<Block> blocks;
  int behind_pair = 0;
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    const bool equal = is_pair(i, j) && with_pair(i, j, behind_pair) == at(i, j)[static_cast<std::size_t>(behind_pair)];
    const bool first = !equal && i < a.size() && (j == b.size() || at(i + 1, j)[0] >= at(i, j + 1)[0]);
    if (blocks.empty() || blocks.back().equal != equal || (equal && a[i].separates != a[i - 1].separates))
      blocks.push_back({equal, i, i, j, j});
    i += equal || first ? 1 : 0;
    j += equal || !first ? 1 : 0;
    blocks.back().a_end = i;
    blocks.back().b_end = j;
    behind_pair = equal ? 1 : 0;
  }
  return blocks;
}

constexpr std::size_t long_run = 4;

/// Between two common separators, short runs of equal leaves amid changes count as changed where both forms changed in
/// more leaves than stayed equal there.
void drop_crumbs(std::vector<Block>& blocks, const std::vector<Leaf>& a) {
  const auto separates = [&](const Block& block) { return block.equal && a[block.a].separates; };
  for (auto from = blocks.begin(); from != blocks.end();) {
    const auto to = std::find_if(from + 1, blocks.end(), separates);
    auto first = std::find_if(from, to, [](const Block&block) { return !block.equal; }), last = to;
    while (last != first && (last - 1)->equal) --last;
    std::size_t equal = 0, printed = 0, corrected = 0;
    for (auto block = first; block != last; ++block) {
      equal += block->equal ? block->a_end - block->a : 0;
      printed += block->equal ? 0 : block->a_end - block->a;
      corrected += block->equal ? 0 : block->b_end - block->b;
    }
    if (equal < std::min(printed, corrected))
      for (; first != last; ++first) first->equal = first->equal && first->a_end - first->a >= long_run;
    from = to;
  }
}

/// They look the same: equal leaves alone do not tell one root of a product from a product of roots.
bool is_same(const MathNode& a, const MathNode& b) {
  const auto is_wrapping = [](const MathNode& node) { return node.kind == Kind::row && node.parts.size() == 1; };
  if (is_wrapping(a)) return is_same(a.parts[0], b);
  if (is_wrapping(b)) return is_same(a, b.parts[0]);
  const auto is_seen = [](const MathNode& node) { return node.kind != Kind::space; };
  const auto kind = [](const MathNode& node) { return node.kind == Kind::small ? Kind::fraction : node.kind; };
  return kind(a) == kind(b) && trimmed(a.text) == trimmed(b.text) &&
         std::ranges::equal(a.parts | std::views::filter(is_seen), b.parts | std::views::filter(is_seen), is_same);
}

/// No bracket is marked without its partner where all between them is.
void pair_brackets(MathNode& node) {
  for (MathNode& part : node.parts) pair_brackets(part);
  if (node.kind == Kind::fenced && (node.parts[0].changed || node.parts[2].changed) && all_changed(node.parts[1]))
    node.parts[0].changed = node.parts[2].changed = true;
}

}  // namespace

void mark_difference(MathNode& printed, MathNode& corrected) {
  std::vector<Leaf> a, b;
  for (MathNode& node : printed.parts) collect(node, "", true, a);
  for (MathNode& node : corrected.parts) collect(node, "", true, b);
  std::vector<Block> blocks = common_blocks(a, b);
  drop_crumbs(blocks, a);
  const bool all = std::ranges::all_of(blocks, &Block::equal) && !is_same(printed, corrected);
  for (const Block& block : blocks) {
    if (block.equal && !all) continue;
    for (std::size_t i = block.a; i < block.a_end; ++i) a[i].node->changed = true;
    for (std::size_t i = block.b; i < block.b_end; ++i) b[i].node->changed = true;
  }
  pair_brackets(printed);
  pair_brackets(corrected);
}

}  // namespace subcert::formats
