#include "mathml.hpp"

#include "html.hpp"
#include "latex_math.hpp"
#include "math_difference.hpp"

#include <subcert/analysis/symbol/utf8.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
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

}  // namespace subcert::formats
