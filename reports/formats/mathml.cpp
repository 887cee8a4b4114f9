
#include "mathml.hpp"

#include "html.hpp"
#include "latex_math.hpp"

#include <subcert/analysis/symbol/support/utf8.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <ranges>
#include <span>

namespace subcert::formats {
namespace {

using Kind = MathNode::Kind;
using Row = std::span<const MathNode>;
using Elements = std::vector<std::string>;

/// TeX's: a fraction in display style has a numerator in text style, that one's a numerator in script style.
enum class Style { display, text, script };
Style inside_fraction(Style style) { return style == Style::display ? Style::text : Style::script; }

/// Brackets around it have to grow: LaTeX's authors would use \left and \right.
bool is_tall(const MathNode& node) {
  switch (node.kind) {
    case Kind::fraction:
    case Kind::binomial: return true;
    case Kind::subscript:
    case Kind::superscript:
    case Kind::scripts:
    case Kind::accent: return node.atom == Atom::large || is_tall(node.parts.front());
    default: return node.atom == Atom::large || std::ranges::any_of(node.parts, is_tall);
  }
}

bool grows(const MathNode& fence) {
  return fence.parts[0].stretches || fence.parts[2].stretches || is_tall(fence.parts[1]);
}

std::string tag(const std::string& name, const std::string& attributes, const std::string& content) {
  return "<" + name + attributes + ">" + content + "</" + name + ">";
}

std::string joined(const Elements& elements) { return fmt::format("{}", fmt::join(elements, "")); }
/// As one element.
std::string one(const Elements& elements, const std::string& attributes = "") {
  return elements.size() == 1 && attributes.empty() ? elements.front() : tag("mrow", attributes, joined(elements));
}

/// The classes of the neighbours of a node, none at the ends of a row.
struct Neighbours {
  std::optional<Atom> before, behind;
};

const MathNode* neighbour(Row row, std::size_t at, std::ptrdiff_t step) {
  for (std::ptrdiff_t i = static_cast<std::ptrdiff_t>(at) + step; i >= 0 && i < std::ssize(row); i += step)
    if (row[static_cast<std::size_t>(i)].kind != Kind::space) return &row[static_cast<std::size_t>(i)];
  return nullptr;
}

Neighbours neighbours(Row row, std::size_t at) {
  const MathNode *before = neighbour(row, at, -1), *behind = neighbour(row, at, 1);
  Neighbours result;
  if (before != nullptr && !(before->kind == Kind::word && before->text.back() == ' ')) result.before = before->atom;
  if (behind != nullptr) {
    const bool scripted = behind->kind == Kind::subscript || behind->kind == Kind::superscript ||
                          behind->kind == Kind::scripts;
    const bool opens = (scripted ? behind->parts.front() : *behind).kind == Kind::fenced;
    result.behind = opens ? Atom::open : behind->atom;
  }
  return result;
}

bool is_operand(const std::optional<Atom>& atom) { return atom == Atom::ordinary || atom == Atom::close; }

bool is_sign(const MathNode& node) {
  const auto is = [&](const char* text) { return node.text == text; };
  return node.kind == Kind::symbol && (is("+") || is("−") || is("±") || is("∓"));
}

constexpr const char* no_space = " lspace=\"0\" rspace=\"0\"";
constexpr const char* still = " stretchy=\"false\"";
constexpr const char* mark = " class=\"changed\"";
constexpr const char* prime = "′";
/// Fonts have the prime raised already, and no browser takes their variant for exponents.
constexpr const char* lowered = " scriptlevel=\"-1\" voffset=\"-0.45em\" height=\"0.3em\"";
constexpr const char* thin_space = "<mspace width=\"0.167em\"></mspace>";

/// What TeX does and MathML's dictionary of operators does not: no spaces in scripts, signs, bars.
std::string operator_attributes(const MathNode& node, const Neighbours& around, Style style) {
  const bool small = style == Style::script;
  switch (node.atom) {
    case Atom::binary: {
      const bool between = is_operand(around.before) && around.behind && *around.behind != Atom::close &&
                           *around.behind != Atom::relation && *around.behind != Atom::punctuation;
      if (!between) return is_sign(node) ? " form=\"prefix\"" : no_space;
      return (is_sign(node) ? " form=\"infix\"" : "") + std::string(small ? no_space : "");
    }
    case Atom::relation: return small ? no_space : node.text == "∣" ? " lspace=\"0.278em\" rspace=\"0.278em\"" : "";
    case Atom::punctuation: return small ? no_space : node.text == ":" ? " lspace=\"0\" rspace=\"0.278em\"" : "";
    case Atom::large: return no_space;  // row_elements() sets them, outside of the limits
    case Atom::open: return " form=\"prefix\"" + std::string(node.stretches ? "" : still);
    case Atom::close: return " form=\"postfix\"" + std::string(node.stretches ? "" : still);
    default: return no_space + std::string(is_bar(node) && !node.stretches ? still : "");
  }
}

Elements row_elements(Row row, std::size_t from, std::size_t to, Style style, bool marked);
Elements row_elements(Row row, Style style, bool marked) { return row_elements(row, 0, row.size(), style, marked); }

/// Where the scripts are on a bracket that does not grow, they are on it alone, as in TeX: so an exponent behind
/// (A^T A) is no higher than the one in it.
std::string fenced(const MathNode& node, Style style, bool marked, const std::string& attributes,
                   const std::string& script_tag = "", const std::string& scripts = "") {
  Elements content = row_elements(node.parts[1].parts, style, marked);
  const auto bracket = [&](const MathNode& side) {
    return tag("mo", (grows(node) ? "" : still) + std::string(!marked && side.changed ? mark : ""), html(side.text));
  };
  if (!node.parts[0].text.empty()) content.insert(content.begin(), bracket(node.parts[0]));
  if (!node.parts[2].text.empty()) content.push_back(bracket(node.parts[2]));
  if (!script_tag.empty()) content.back() = tag(script_tag, "", content.back() + scripts);
  return tag("mrow", attributes, joined(content));
}

/// `marked`: an element around it says already that it is changed.
std::string element(const MathNode& node, const Neighbours& around, Style style, bool marked) {
  const auto mark_of = [&](const MathNode& leaf) -> std::string { return !marked && leaf.changed ? mark : ""; };
  const std::string changed = !marked && all_changed(node) ? mark : "";
  marked = marked || !changed.empty();
  const auto part = [&](std::size_t i, Style inner) { return element(node.parts[i], {}, inner, marked); };
  const MathNode& first = node.parts.empty() ? node : node.parts[0];
  const bool limits = style == Style::display &&
                      ((node.atom == Atom::large && first.text != "∫") ||
                       (node.atom == Atom::function &&
                        (first.text == "max" || first.text == "min" || first.text == "sup" || first.text == "inf" ||
                         first.text == "lim" || first.text == "det")));
  switch (node.kind) {
    case Kind::identifier: {
      const auto letters = std::ranges::count_if(node.text, [](char c) { return (c & 0xc0) != 0x80; });
      const bool plain = node.upright && letters == 1 && node.text.size() < 4;
      return tag("mi", (plain ? " mathvariant=\"normal\"" : "") + changed, node.text);
    }
    case Kind::number: return tag("mn", changed, node.text);
    case Kind::symbol:
      return node.text == prime ? tag("mpadded", lowered + changed, "<mo>′</mo>")
                                : tag("mo", operator_attributes(node, around, style) + changed, html(node.text));
    case Kind::word: return tag("mtext", changed, html(node.text));
    case Kind::space: return tag("mspace", " width=\"" + node.text + "em\"", "");
    case Kind::row: return one(row_elements(node.parts, style, marked), changed);
    case Kind::fenced: return fenced(node, style, marked, changed);
    case Kind::subscript:
    case Kind::superscript:
    case Kind::scripts: {
      const std::string name = node.kind == Kind::subscript     ? limits ? "munder" : "msub"
                               : node.kind == Kind::superscript ? limits ? "mover" : "msup"
                               : limits                         ? "munderover"
                                                                : "msubsup";
      std::string scripts;
      for (std::size_t i = 1; i < node.parts.size(); ++i) scripts += part(i, Style::script);
      if (first.kind == Kind::fenced && !grows(first)) return fenced(first, style, marked, changed, name, scripts);
      return tag(name, changed, element(first, around, style, marked) + scripts);
    }
    case Kind::fraction:
      return tag("mfrac", changed, part(0, inside_fraction(style)) + part(1, inside_fraction(style)));
    case Kind::small:
      return tag("mfrac", " displaystyle=\"false\"" + changed, part(0, Style::script) + part(1, Style::script));
    case Kind::binomial:
      return tag(
          "mrow", changed,
          "<mo>(</mo>" +
              tag("mfrac", " linethickness=\"0\"", part(0, inside_fraction(style)) + part(1, inside_fraction(style))) +
              "<mo>)</mo>");
    case Kind::root:
      return node.parts.size() > 1 ? tag("mroot", changed, part(0, style) + part(1, Style::script))
                                   : tag("msqrt", changed, part(0, style));
    default:
      return tag("mover", " accent=\"true\"" + changed,
                 part(0, style) +
                     tag("mo", (node.parts[1].stretches ? "" : still) + mark_of(node.parts[1]), node.parts[1].text));
  }
}

/// A blank at an end of <mtext> is dropped.
std::string with_hard_blanks(std::string text) {
  const auto hard = [](std::string& part, std::size_t at) {
    if (part[at] == ' ') part.replace(at, 1, "\u00a0");
  };
  hard(text, text.size() - 1);
  if (text.size() > 1) hard(text, 0);
  return text;
}

/// The end of the words with the same mark from `at` on, and their text.
std::pair<std::size_t, std::string> words_from(Row row, std::size_t at, std::size_t to) {
  std::string text;
  const bool changed = row[at].changed;
  for (; at < to && row[at].kind == Kind::word && row[at].changed == changed; ++at) text += row[at].text;
  return {at, text};
}

/// Where the run of changed nodes ends that begins here, and how many there are, blanks aside.
std::pair<std::size_t, int> changed_run(Row row, std::size_t at, std::size_t to) {
  std::size_t end = at;
  int count = 0;
  for (; at < to && (row[at].kind == Kind::space || all_changed(row[at])); ++at)
    if (row[at].kind != Kind::space) {
      end = at + 1;
      ++count;
    }
  return {end, count};
}

/// The nodes from..to of a row: one element for a run of changed ones.
Elements row_elements(Row row, std::size_t from, std::size_t to, Style style, bool marked) {
  Elements list;
  for (std::size_t i = from; i < to;) {
    const MathNode& node = row[i];
    if (!marked && node.kind != Kind::space && all_changed(node))
      if (const auto [end, count] = changed_run(row, i, to); count > 1) {
        list.push_back(tag("mrow", mark, joined(row_elements(row, i, end, style, true))));
        i = end;
        continue;
      }
    if (node.kind == Kind::word) {
      const auto [end, text] = words_from(row, i, to);
      list.push_back(tag("mtext", !marked && node.changed ? mark : "", html(with_hard_blanks(text))));
      i = end;
      continue;
    }
    const Neighbours around = neighbours(row, i);
    const bool is_name = node.atom == Atom::function, stands_off = is_name || node.atom == Atom::large;
    if (stands_off && is_operand(around.before)) list.push_back(thin_space);
    list.push_back(element(node, around, style, marked));
    const bool applies = around.behind == Atom::ordinary || around.behind == Atom::large ||
                         around.behind == Atom::function;
    if (is_name && (applies || around.behind == Atom::open)) list.push_back("<mo>\u2061</mo>");
    if (stands_off && applies) list.push_back(thin_space);
    ++i;
  }
  return list;
}

std::string math(const Elements& elements, const std::string& attributes, std::string_view latex) {
  std::string source = trimmed(latex);
  std::ranges::replace(source, '\n', ' ');
  return tag("math", attributes,
             tag("semantics", "", one(elements) + tag("annotation", " encoding=\"application/x-tex\"", html(source))));
}

bool is_break(const MathNode& node) { return node.kind == Kind::space && std::stod(node.text) > 0.25; }

bool is_quad(const MathNode& node) { return node.kind == Kind::space && std::stod(node.text) >= 1; }

/// Leaves of a formula that is about as wide as the page. A longer one may break in front of its signs.
constexpr int longest_line = 80;

std::string flowing(Row row, std::string_view latex) {
  std::string text;
  const auto glued = [&] { return text.empty() || text.back() == ' ' ? "" : "\u2060"; };
  for (std::size_t i = 0; i < row.size();) {
    if (is_break(row[i])) {
      text += is_quad(row[i]) && i > 0 && row[i - 1].kind == Kind::word ? "\u2003 " : " ";
      ++i;
    } else if (row[i].kind == Kind::word) {
      const auto [end, words] = words_from(row, i, row.size());
      if (words.front() != ' ') text += glued();
      text += row[i].changed ? tag("span", mark, html(words)) : html(words);
      i = end;
    } else {
      std::size_t end = i + 1;
      while (end < row.size() && row[end].kind != Kind::word && !is_break(row[end])) ++end;
      text += glued();
      const std::size_t begin = i;
      int size = 0;
      for (const MathNode& node : row.subspan(begin, end - begin)) size += leaves(node).all;
      const bool is_long = size > longest_line;
      for (std::size_t part = begin; part < end; part = i) {
        for (++i; i < end && !(is_long && is_sign(row[i]) && is_operand(neighbours(row, i).before)); ++i) {
        }
        text += (part > begin ? "<wbr>" : "") +
                math(row_elements(row, part, i, Style::display, false),
                     " displaystyle=\"true\"" +
                         std::string(i == end && end < row.size() && is_quad(row[end]) ? " class=\"quad\"" : ""),
                     latex.substr(row[part].begin, row[i - 1].end - row[part].begin));
      }
    }
  }
  return text;
}

}  // namespace

std::string mathml(std::string_view latex, bool block) {
  const MathNode row = read_latex(latex);
  return math(row_elements(row.parts, block ? Style::display : Style::text, false), block ? " display=\"block\"" : "",
              latex);
}

std::string formula_html(std::string_view latex) { return flowing(read_latex(latex).parts, latex); }

MarkedFormulas marked_difference(std::string_view printed, std::string_view corrected) {
  MathNode first = read_latex(printed), second = read_latex(corrected);
  mark_difference(first, second);
  return {flowing(first.parts, printed), flowing(second.parts, corrected)};
}

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
