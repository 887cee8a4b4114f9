#include "latex_math.hpp"

#include "latex_symbols.hpp"

#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/analysis/symbol/support/utf8.hpp>

#include <algorithm>
#include <cctype>
#include <optional>

namespace subcert::formats {
namespace {

using Kind = MathNode::Kind;
using Nodes = std::vector<MathNode>;

constexpr std::size_t longest_text = 5000;
constexpr int deepest = 50;   ///< nested arguments
constexpr int highest = 100;  ///< of a tree; matching brackets are levels, too

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  MathNode whole() {
    require(text_.size() <= longest_text, "formula in LaTeX: need at most {} characters, got {}", longest_text,
            text_.size());
    MathNode row = made(Kind::row, sequence(), 0);
    if (at_ < text_.size()) wrong(at_, "no '" + token() + "' without its beginning");
    return row;
  }

 private:
  /// Up to the end, a `}` or a \right, which stay.
  Nodes sequence() {
    Nodes nodes;
    for (blanks(); at_ < text_.size() && text_[at_] != '}' && token() != "\\right"; blanks()) {
      atom(nodes, false);
      scripts(nodes);
    }
    return grouped(std::move(nodes));
  }

  /// Appends one atom, several for a \text, none for one that a script follows.
  void atom(Nodes& nodes, bool one_digit) {
    if (++depth_ > deepest) wrong(at_, "at most 50 levels");
    const std::size_t begin = at_;
    const char c = text_[at_];
    if (c == '\\') {
      command(nodes);
    } else if (c == '{') {
      nodes.push_back(group());
    } else if (is_digit(c)) {
      ++at_;
      while (!one_digit && at_ < text_.size() &&
             (is_digit(text_[at_]) || (text_[at_] == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))))
        ++at_;
      leaf(nodes, Symbol{std::string(text_.substr(begin, at_ - begin)), Atom::ordinary, Kind::number}, begin);
    } else if (is_letter(c)) {
      ++at_;
      leaf(nodes, Symbol{std::string(1, c), Atom::ordinary, Kind::identifier}, begin);
    } else if (const Symbol* known = symbol(token())) {
      ++at_;
      leaf(nodes, *known, begin);
    } else if (c != '_' && c != '^' && c != '\'') {
      wrong(at_, "a character of LaTeX's mathematics");
    }
    --depth_;
  }

  void command(Nodes& nodes) {
    const std::size_t begin = at_;
    const std::string whole = token(), name = whole.substr(1);
    at_ += whole.size();
    const Symbol* known = symbol(whole);
    if (known != nullptr && known->kind == Kind::accent) {
      Nodes parts{argument(whole)};
      leaf(parts, Symbol{known->text}, begin);
      parts.back().stretches = name.starts_with("wide") || name == "overline";
      nodes.push_back(made(Kind::accent, std::move(parts), begin));
    } else if (known != nullptr) {
      leaf(nodes, *known, begin);
      if (name == "dots" && operator_follows()) nodes.back().text = "⋯";
    } else if (name == "frac" || name == "dfrac" || name == "tfrac" || name == "binom") {
      MathNode top = argument(whole), bottom = argument(whole);
      nodes.push_back(made(name == "binom"   ? Kind::binomial
                           : name == "tfrac" ? Kind::small
                                             : Kind::fraction,
                           {std::move(top), std::move(bottom)}, begin));
    } else if (name == "sqrt") {
      root(nodes, begin);
    } else if (name == "text" || name == "mbox" || name == "textrm") {
      words(nodes, whole);
    } else if (name == "mathrm" || name == "operatorname") {
      const std::string letters = plain_argument(whole);
      leaf(nodes, Symbol{letters, name == "mathrm" ? Atom::ordinary : Atom::function, Kind::identifier, true}, begin);
    } else if (name == "mathbf" || name == "mathbb" || name == "mathcal") {
      std::string letters;
      for (const char c : plain_argument(whole)) letters += in_alphabet(name, c);
      leaf(nodes, Symbol{letters, Atom::ordinary, Kind::identifier}, begin);
    } else if (name == "left") {
      Nodes parts;
      delimiter(parts, whole);
      const std::size_t inside = at_;
      parts.push_back(made(Kind::row, sequence(), inside));
      if (at_ >= text_.size() || token() != "\\right") wrong(begin, "a \\right that ends it");
      at_ += 6;
      delimiter(parts, "\\right");
      parts.front().stretches = true;
      nodes.push_back(made(Kind::fenced, std::move(parts), begin));
    } else if (const std::string size = name.substr(0, name.find_last_not_of("lrm") + 1);
               name.size() <= size.size() + 1 && (size == "big" || size == "Big" || size == "bigg" || size == "Bigg")) {
      delimiter(nodes, whole);
      nodes.back().stretches = true;
      if (name.back() == 'l') nodes.back().atom = Atom::open;
      if (name.back() == 'r') nodes.back().atom = Atom::close;
    } else {
      fail(ErrorKind::domain, "formula in LaTeX, position {}: unknown command '{}'", begin + 1, printable(whole));
    }
  }

  void root(Nodes& nodes, std::size_t begin) {
    Nodes degree;
    blanks();
    if (at_ < text_.size() && text_[at_] == '[') {
      const std::size_t close = text_.find(']', at_);
      if (close == std::string_view::npos) wrong(at_, "']'");
      const std::size_t from = at_ + 1;
      at_ = close + 1;
      for (const char c : text_.substr(from, close - from))
        if (!is_digit(c) && !is_letter(c)) wrong(from, "a degree of letters or digits");
      leaf(degree, Symbol{std::string(text_.substr(from, close - from)), Atom::ordinary, Kind::number}, from);
    }
    Nodes parts{argument("\\sqrt")};
    parts.insert(parts.end(), degree.begin(), degree.end());
    nodes.push_back(made(Kind::root, std::move(parts), begin));
  }

  /// The words and stops of a \text: each keeps the blanks behind it, the first also those in front.
  void words(Nodes& nodes, const std::string& whole) {
    blanks();
    if (at_ >= text_.size() || text_[at_] != '{') wrong(at_, "'{' behind " + whole);
    const std::size_t open = at_++;
    std::string word;
    std::size_t begin = at_;
    const auto finish = [&] {
      if (!word.empty()) leaf(nodes, Symbol{word, Atom::ordinary, Kind::word}, begin);
      word.clear();
      begin = at_;
    };
    for (; at_ < text_.size() && text_[at_] != '}'; ++at_) {
      const char c = text_[at_];
      if (c == '{' || c == '$') wrong(at_, "plain words in " + whole);
      const bool behind_blank = !word.empty() && word.back() == ' ' && word.find_first_not_of(' ') != std::string::npos;
      if (c == ' ' || c == '\n' || c == '~') {
        if (word.empty() || word.back() != ' ') word += ' ';
        continue;
      }
      const bool stop = std::string(",.;:").find(c) != std::string::npos &&
                        (at_ + 1 == text_.size() || text_[at_ + 1] == ' ' || text_[at_ + 1] == '}');
      if (behind_blank || stop) finish();
      if (c == '\\') {
        const std::string sign = token();
        if (sign.size() != 2 || std::string("%&_#${}").find(sign[1]) == std::string::npos)
          fail(ErrorKind::domain, "formula in LaTeX, position {}: unknown command '{}' in {}", at_ + 1, printable(sign),
               whole);
        word += text_[++at_];
      } else {
        word += c == '\'' ? "’" : std::string(1, c);
      }
    }
    if (at_ >= text_.size()) wrong(open, "'}'");
    finish();
    ++at_;
  }

  /// `{abc}` or `a`: letters and digits.
  std::string plain_argument(const std::string& whole) {
    blanks();
    const std::size_t begin = at_;
    const bool braces = at_ < text_.size() && text_[at_] == '{';
    std::size_t end = braces ? text_.find('}', at_) : std::min(at_ + 1, text_.size());
    if (end == std::string_view::npos) wrong(begin, "'}'");
    std::string letters(text_.substr(begin + (braces ? 1 : 0), end - begin - (braces ? 1 : 0)));
    at_ = end + (braces ? 1 : 0);
    for (const char c : letters)
      if (!is_letter(c) && (!is_digit(c) || whole == "\\mathcal")) wrong(begin, "plain letters behind " + whole);
    if (letters.empty()) wrong(begin, "plain letters behind " + whole);
    return letters;
  }

  /// A bracket, a bar or a point for none.
  void delimiter(Nodes& nodes, const std::string& whole) {
    blanks();
    if (at_ >= text_.size()) wrong(at_, "a bracket behind " + whole);
    const std::size_t begin = at_;
    const std::string sign = token();
    const Symbol* known = symbol(sign);
    if (known == nullptr || (known->atom != Atom::open && known->atom != Atom::close && known->text != "|" &&
                             known->text != "‖" && known->text != "/" && sign != "."))
      wrong(begin, "a bracket behind " + whole);
    at_ += sign.size();
    leaf(nodes, sign == "." ? Symbol{} : *known, begin);
  }

  /// A group, a command with its arguments, or one character.
  MathNode argument(const std::string& whole) {
    blanks();
    const std::size_t begin = at_;
    const bool is_there = at_ < text_.size() && std::string("}_^'&").find(text_[at_]) == std::string::npos &&
                          token() != "\\right";
    if (!is_there) wrong(at_, "an argument of " + whole);
    Nodes nodes;
    atom(nodes, true);
    return nodes.size() == 1 ? std::move(nodes.front()) : made(Kind::row, std::move(nodes), begin);
  }

  MathNode group() {
    const std::size_t begin = at_++;
    Nodes nodes = sequence();
    if (at_ >= text_.size() || text_[at_] != '}') wrong(begin, "'}'");
    ++at_;
    return made(Kind::row, std::move(nodes), begin);
  }

  /// The scripts that follow, put on the last node.
  void scripts(Nodes& nodes) {
    std::optional<MathNode> below;
    Nodes above;
    bool has_exponent = false;
    const std::size_t begin = at_;
    for (blanks(); at_ < text_.size(); blanks()) {
      const char c = text_[at_];
      if (c == '\'' && !has_exponent) {
        ++at_;
        leaf(above, Symbol{"′"}, at_ - 1);
      } else if (c == '^' && !has_exponent) {
        ++at_;
        above.push_back(argument("^"));
        has_exponent = true;
      } else if (c == '_' && !below) {
        ++at_;
        below = argument("_");
      } else if (c == '^' || c == '_' || c == '\'') {
        wrong(at_, "one index and one exponent");
      } else {
        break;
      }
    }
    const bool has_above = !above.empty();
    if (!below && !has_above) return;
    const bool has_base = !nodes.empty() && nodes.back().kind != Kind::space;
    Nodes parts;
    parts.push_back(has_base ? std::move(nodes.back()) : made(Kind::row, {}, begin));
    if (has_base) nodes.pop_back();
    if (below) parts.push_back(std::move(*below));
    if (has_above)
      parts.push_back(above.size() == 1 ? std::move(above.front()) : made(Kind::row, std::move(above), begin));
    const std::size_t first = parts.front().begin;
    nodes.push_back(made(!below       ? Kind::superscript
                         : !has_above ? Kind::subscript
                                      : Kind::scripts,
                         std::move(parts), first));
    nodes.back().atom = nodes.back().parts.front().atom;
  }

  /// Brackets and bars that match become one node with what is between them.
  Nodes grouped(Nodes nodes) {
    Nodes done;
    std::vector<std::size_t> open;  // places in `done`
    for (MathNode& node : nodes) {
      const bool scripted = has_scripts(node);
      MathNode& core = scripted ? node.parts.front() : node;
      const bool leaf = core.kind == Kind::symbol, bar = leaf && core.atom == Atom::ordinary && is_bar(core);
      bool closes = leaf && core.atom == Atom::close && core.text != "!";
      if (bar && !open.empty() && done[open.back()].text == core.text && ends_operand(done, open.back())) closes = true;
      if (closes) {
        while (!bar && !open.empty() && done[open.back()].atom != Atom::open) open.pop_back();
        if (!open.empty()) {
          core = fence(done, open.back(), std::move(core));
          node.begin = core.begin;
          node.atom = core.atom;
          if (scripted) node.height = std::max(node.height, core.height + 1);
          bounded(node);
          open.pop_back();
        }
      } else if (leaf && !scripted && (bar || core.atom == Atom::open)) {
        open.push_back(done.size());
      }
      done.push_back(std::move(node));
    }
    return done;
  }

  /// Something that a bar may close stands behind the place `from`.
  static bool ends_operand(const Nodes& done, std::size_t from) {
    for (std::size_t i = done.size(); i-- > from + 1;)
      if (done[i].kind != Kind::space) return done[i].atom == Atom::ordinary || done[i].atom == Atom::close;
    return false;
  }

  MathNode fence(Nodes& done, std::size_t from, MathNode close) {
    const std::size_t begin = done[from].begin, end = close.end, inside = done[from].end, outside = close.begin;
    Nodes parts{std::move(done[from])};
    const auto first = done.begin() + static_cast<std::ptrdiff_t>(from);
    parts.push_back(
        made(Kind::row, Nodes(std::make_move_iterator(first + 1), std::make_move_iterator(done.end())), inside));
    parts.back().end = outside;
    parts.push_back(std::move(close));
    done.erase(first, done.end());
    parts.front().stretches = parts.front().stretches || parts.back().stretches;
    MathNode result = made(Kind::fenced, std::move(parts), begin);
    result.end = end;
    return result;
  }

  MathNode made(Kind kind, Nodes parts, std::size_t begin) {
    MathNode node{kind};
    node.begin = begin;
    node.end = at_;
    for (const MathNode& part : parts) node.height = std::max(node.height, part.height + 1);
    node.parts = std::move(parts);
    bounded(node);
    return node;
  }

  void bounded(const MathNode& node) {
    if (node.height > highest) wrong(node.begin, "at most 100 levels of brackets and arguments");
  }

  void leaf(Nodes& nodes, const Symbol& symbol, std::size_t begin) {
    MathNode node{symbol.kind, symbol.text, symbol.atom, symbol.upright};
    node.begin = begin;
    node.end = at_;
    nodes.push_back(std::move(node));
  }

  bool operator_follows() {
    blanks();
    const Symbol* next = symbol(token());
    return next != nullptr && (next->atom == Atom::binary || next->atom == Atom::relation);
  }

  /// What stands here: a command, or one character.
  std::string token() const {
    if (at_ >= text_.size()) return "";
    if (text_[at_] != '\\') return std::string(1, text_[at_]);
    std::size_t end = at_ + 1;
    while (end < text_.size() && is_letter(text_[end])) ++end;
    return std::string(text_.substr(at_, std::max(end, at_ + 2) - at_));
  }

  void blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
  }

  [[noreturn]] void wrong(std::size_t at, const std::string& expected) {
    at_ = at;
    fail(ErrorKind::domain, "formula in LaTeX, position {}: '{}'; expected {}", at + 1,
         at < text_.size() ? printable(token()) : "end", expected);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

bool is_bar(const MathNode& node) { return node.kind == Kind::symbol && (node.text == "|" || node.text == "‖"); }

bool has_scripts(const MathNode& node) {
  return node.kind == Kind::subscript || node.kind == Kind::superscript || node.kind == Kind::scripts;
}

bool is_leaf(const MathNode& node) {
  return node.parts.empty() && node.kind != Kind::row && node.kind != Kind::space && !node.text.empty();
}

Leaves leaves(const MathNode& node) {
  Leaves sum;
  if (is_leaf(node)) sum = {1, node.changed ? 1 : 0};
  for (const MathNode& part : node.parts) {
    const auto [all, changed] = leaves(part);
    sum = {sum.all + all, sum.changed + changed};
  }
  return sum;
}

bool all_changed(const MathNode& node) {
  const auto [all, changed] = leaves(node);
  return all > 0 && all == changed;
}

MathNode read_latex(std::string_view text) { return Reader(text).whole(); }

}  // namespace subcert::formats
