#include "formula.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace subcert::statements {

/// kind: `#` number, `v` name, `+`, `-`, `*`, `/`, `^`, `~` negation, `(` brackets as written.
struct Formula::Node {
  char kind;
  Rational number;
  std::string name;
  std::shared_ptr<const Node> left;
  std::shared_ptr<const Node> right;
};

namespace {

using Node = Formula::Node;
using Tree = std::shared_ptr<const Node>;

constexpr std::size_t longest_text = 10'000;
constexpr int deepest = 100;
constexpr long largest_exponent = 1000;

Tree number_node(const Rational& value) { return std::make_shared<Node>(Node{'#', value, "", nullptr, nullptr}); }
Tree name_node(const std::string& name) { return std::make_shared<Node>(Node{'v', 0, name, nullptr, nullptr}); }
Tree node(char kind, Tree left, Tree right = nullptr) {
  return std::make_shared<Node>(Node{kind, 0, "", std::move(left), std::move(right)});
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  Tree whole() {
    if (text_.size() > longest_text) fail("at most 10,000 characters");
    Tree tree = sum();
    if (peek() != 0) fail("an operator or the end");
    return tree;
  }

 private:
  Tree sum() {
    if (++depth_ > deepest) fail("at most 100 nested brackets");
    Tree tree = take('-') ? node('~', product()) : product();
    for (char c = peek(); c == '+' || c == '-'; c = peek()) {
      ++at_;
      tree = node(c, tree, product());
    }
    --depth_;
    return tree;
  }

  Tree product() {
    Tree tree = power_of();
    for (char c = peek(); c == '*' || c == '/'; c = peek()) {
      ++at_;
      tree = node(c, tree, power_of());
    }
    return tree;
  }

  Tree power_of() {
    Tree tree = atom();
    return take('^') ? node('^', tree, atom()) : tree;
  }

  Tree atom() {
    const char c = peek();
    if (take('(')) {
      Tree tree = sum();
      if (!take(')')) fail("')'");
      return node('(', tree);
    }
    if (std::isdigit(static_cast<unsigned char>(c))) return number_node(number());
    if (std::isalpha(static_cast<unsigned char>(c))) {
      const std::size_t begin = at_;
      while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_]))) ++at_;
      while (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_]))) ++at_;
      return name_node(std::string(text_.substr(begin, at_ - begin)));
    }
    fail("a number, a name or '('");
  }

  Rational number() {
    const auto digits = [&] {
      std::string run;
      while (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_]))) run += text_[at_++];
      return run;
    };
    Rational value = *parse_rational(digits());
    if (at_ < text_.size() && text_[at_] == '.') {
      ++at_;
      const std::string decimals = digits();
      if (decimals.empty()) fail("decimals");
      value += *parse_rational(decimals) * power(Rational(10), -static_cast<long>(decimals.size()));
    }
    return value;
  }

  char peek() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  [[noreturn]] void fail(const std::string& expected) {
    throw ParseError("formula", at_ < text_.size() ? text_.substr(at_) : std::string_view("end"), at_ + 1, expected);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

long exponent_of(const Rational& value) {
  if (denominator(value) != 1 || abs(value) > largest_exponent)
    throw Undefined("formula: need an integer exponent of modulus at most 1000, got " + subcert::to_text(value));
  return static_cast<long>(numerator(value));
}

Rational evaluate(const Node& n, const Values& values) {
  switch (n.kind) {
    case '#': return n.number;
    case 'v':
      for (const auto& [name, value] : values)
        if (name == n.name) return value;
      fail(ErrorKind::domain, "formula: no value for {}", n.name);
    case '(': return evaluate(*n.left, values);
    case '~': return -evaluate(*n.left, values);
    default: break;
  }
  const Rational left = evaluate(*n.left, values), right = evaluate(*n.right, values);
  switch (n.kind) {
    case '+': return left + right;
    case '-': return left - right;
    case '*': return left * right;
    case '/':
      if (right == 0) throw Undefined("division by zero at " + to_text(values));
      return left / right;
    default: {
      const long exponent = exponent_of(right);
      if (left == 0 && exponent < 0) throw Undefined("division by zero at " + to_text(values));
      return power(left, exponent);
    }
  }
}

bool is_constant(const Node& n) {
  return n.kind != 'v' && (!n.left || is_constant(*n.left)) && (!n.right || is_constant(*n.right));
}

Degrees degrees_of(const Node& n, const std::vector<std::string>& variables) {
  switch (n.kind) {
    case '#': return {0, 0};
    case 'v': return {std::find(variables.begin(), variables.end(), n.name) == variables.end() ? 0 : 1, 0};
    case '(':
    case '~': return degrees_of(*n.left, variables);
    case '^': {
      const Degrees base = degrees_of(*n.left, variables);
      if (!is_constant(*n.right)) throw Undefined("formula: need constant exponents");
      const long exponent = exponent_of(evaluate(*n.right, {}));
      return exponent >= 0 ? Degrees{base.numerator * exponent, base.denominator * exponent}
                           : Degrees{-base.denominator * exponent, -base.numerator * exponent};
    }
    default: break;
  }
  const Degrees a = degrees_of(*n.left, variables), b = degrees_of(*n.right, variables);
  switch (n.kind) {
    case '*': return {a.numerator + b.numerator, a.denominator + b.denominator};
    case '/': return {a.numerator + b.denominator, a.denominator + b.numerator};
    default: return {std::max(a.numerator + b.denominator, b.numerator + a.denominator), a.denominator + b.denominator};
  }
}

MultivariatePolynomial power_of(const MultivariatePolynomial& base, long exponent) {
  MultivariatePolynomial result(base.variables(), 1);
  for (long i = 0; i < exponent; ++i) result *= base;
  return result;
}

using Substitution = std::vector<std::pair<std::string, MultivariatePolynomial>>;

Fraction substitute(const Node& n, const Substitution& values) {
  const int variables = values.front().second.variables();
  const MultivariatePolynomial one(variables, 1);
  switch (n.kind) {
    case '#': return {MultivariatePolynomial(variables, n.number), one};
    case 'v':
      for (const auto& [name, value] : values)
        if (name == n.name) return {value, one};
      fail(ErrorKind::domain, "formula: no value for {}", n.name);
    case '(': return substitute(*n.left, values);
    case '~': {
      Fraction f = substitute(*n.left, values);
      return {-f.numerator, f.denominator};
    }
    case '^': {
      const Fraction base = substitute(*n.left, values);
      const long exponent = exponent_of(evaluate(*n.right, {}));
      const Fraction f{power_of(base.numerator, std::abs(exponent)), power_of(base.denominator, std::abs(exponent))};
      return exponent >= 0 ? f : Fraction{f.denominator, f.numerator};
    }
    default: break;
  }
  const Fraction a = substitute(*n.left, values), b = substitute(*n.right, values);
  switch (n.kind) {
    case '*': return {a.numerator * b.numerator, a.denominator * b.denominator};
    case '/':
      if (b.numerator.is_zero()) throw Undefined("formula: division by the zero polynomial");
      return {a.numerator * b.denominator, a.denominator * b.numerator};
    case '+': return {a.numerator * b.denominator + b.numerator * a.denominator, a.denominator * b.denominator};
    default: return {a.numerator * b.denominator - b.numerator * a.denominator, a.denominator * b.denominator};
  }
}

Tree replace(const Tree& tree, const std::string& name, const Tree& by) {
  if (tree->kind == 'v') return tree->name == name ? node('(', by) : tree;
  if (!tree->left) return tree;
  return node(tree->kind, replace(tree->left, name, by), tree->right ? replace(tree->right, name, by) : nullptr);
}

/// `tau12` as \tau_{12}.
std::string name_latex(const std::string& name) {
  const std::size_t digits = std::min(name.find_first_of("0123456789"), name.size());
  const std::string letters = name.substr(0, digits), index = name.substr(digits);
  return (digits > 1 ? "\\" + letters : letters) +
         (index.empty() ? std::string(digits > 1 ? " " : "") : "_{" + index + "}");
}

std::string latex_of(const Node& n) {
  const auto bare = [](const Node& part) { return latex_of(part.kind == '(' ? *part.left : part); };
  switch (n.kind) {
    case '#': return subcert::to_text(n.number);
    case 'v': return name_latex(n.name);
    case '(': return n.left->kind == '/' || n.left->kind == '(' ? latex_of(*n.left) : "(" + latex_of(*n.left) + ")";
    case '~': return "-" + latex_of(*n.left);
    case '+': return latex_of(*n.left) + " + " + latex_of(*n.right);
    case '-': return latex_of(*n.left) + " - " + latex_of(*n.right);
    case '/': return "\\frac{" + bare(*n.left) + "}{" + bare(*n.right) + "}";
    case '^': {
      const bool plain = n.left->kind == '#' || n.left->kind == 'v';
      return (plain ? latex_of(*n.left) : "(" + bare(*n.left) + ")") + "^{" + bare(*n.right) + "}";
    }
    default: {
      const std::string right = latex_of(*n.right);
      return latex_of(*n.left) + (std::isdigit(static_cast<unsigned char>(right.front())) ? " \\cdot " : " ") + right;
    }
  }
}

}  // namespace

std::string to_text(const Values& values) {
  std::string text;
  for (const auto& [name, value] : values) text += (text.empty() ? "" : ", ") + name + " = " + subcert::to_text(value);
  return text;
}

Formula Formula::parse(std::string_view text) { return Formula(Reader(text).whole()); }

Rational Formula::operator()(const Values& values) const { return evaluate(*root_, values); }

Degrees Formula::degrees(const std::vector<std::string>& variables) const { return degrees_of(*root_, variables); }

Formula Formula::replaced(const std::string& name, const Formula& by) const {
  return Formula(replace(root_, name, by.root_));
}

Formula Formula::joined(char kind, const Formula& a, const Formula& b) {
  return Formula(node(kind, node('(', a.root_), node('(', b.root_)));
}

Fraction Formula::substituted(const Substitution& values) const { return substitute(*root_, values); }

std::string Formula::to_latex() const { return latex_of(*root_); }

}  // namespace subcert::statements
