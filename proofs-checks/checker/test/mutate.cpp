// Mutates the accepted certificates and offers each mutant to the checker, in this process, with the true claim and
// with false claims just beyond the known value. Fails if a mutant proves a false claim or takes too long; a crash ends
// the program, so it is meant to run with sanitizers. Usage: mutate ACCEPT_DIRECTORY MUTANTS [SEED]
#include "check.hpp"

#include <gmpxx.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <random>
#include <sstream>

namespace {

using Lines = std::vector<std::string>;
using Claim = std::vector<std::string>;  // as arguments of the checker, without the certificate

#ifdef __SANITIZE_ADDRESS__
constexpr double max_seconds = 150;
#else
constexpr double max_seconds = 5;  // of the processor, for one claim
#endif

/// A claim that a certificate with these lines `exact`, `contraction` or `surface`, and `root` might prove.
struct ExactClaim {
  Claim claim;
  std::string exact, root;
};

struct Case {
  std::string name;
  Claim claim;  // true: the certificate proves it
  std::vector<Claim> false_claims;
  std::vector<ExactClaim> false_numbers;
  Lines lines;
};

std::vector<std::string> split(const std::string& line, char separator = ' ') {
  std::vector<std::string> tokens;
  std::istringstream words(line);
  for (std::string word; std::getline(words, word, separator);)
    if (!word.empty()) tokens.push_back(word);
  return tokens;
}

std::string join(const std::vector<std::string>& tokens, char separator = ' ') {
  std::string line;
  for (const std::string& token : tokens) {
    if (!line.empty()) line += separator;
    line += token;
  }
  return line;
}

/// The exact number of a zero times a power of 2 in place of z: `1-log|[p0,...]@RE,IM,EPS|^1/L`.
std::string with_other_zero(const std::string& exact, const mpq_class& factor) {
  const std::size_t begin = exact.find('[') + 1, end = exact.find(']'), bar = exact.find('|', end);
  std::vector<std::string> p = split(exact.substr(begin, end - begin), ','),
                           point = split(exact.substr(end + 2, bar - end - 2), ',');
  mpz_class scale = 1;
  for (std::size_t k = 0; k < p.size(); ++k, scale *= 2) {
    std::string& c = factor > 1 ? p[p.size() - 1 - k] : p[k];
    c = mpz_class(mpz_class(c) * scale).get_str();
  }
  for (std::string& x : point) x = mpq_class(mpq_class(x) * factor).get_str();
  return exact.substr(0, begin) + join(p, ',') + "]@" + join(point, ',') + exact.substr(bar);
}

/// Its line `root`, with bounds that are right for each L, but far apart.
std::string with_other_root(const std::string& root, const mpq_class& factor) {
  std::vector<std::string> fields = split(root);
  for (std::size_t k = 1; k <= 3; ++k) fields[k] = mpq_class(mpq_class(fields[k]) * factor).get_str();
  std::string& end = factor > 1 ? fields[5] : fields[4];
  end = mpq_class(mpq_class(end) * factor).get_str();
  return join(fields);
}

/// The bounds of contractions are attained, all but those that are said with an exponent of more steps than one.
void add_contraction(const Claim& subject, Case& c) {
  const auto at = std::find(subject.begin(), subject.end(), "--contraction");
  if (at == subject.end()) return;
  std::vector<std::string> fields = split(at[1], ',');
  fields[2] = mpq_class(mpq_class(fields[2]) * mpq_class("999999999999/1000000000000")).get_str();
  Claim smaller{subject.begin(), at};
  smaller.insert(smaller.end(), {"--contraction", join(fields, ',')});
  c.false_numbers.push_back({smaller, "contraction " + join(fields), {}});
}

/// Around a vertex with Loop's rules: the same of one that moves so that an eigenvalue of frequency 0 is 33/40.
void add_vertex(const Claim& claim, Case& c) {
  const std::string part = "31/64-3/16*c-1/16*c^2", rest = "33/64+3/16*c+1/16*c^2";
  const auto at = std::find(claim.begin(), claim.end(), "--vertex");
  if (at == claim.end() || at[1].find(part) == std::string::npos) return;
  std::string other = at[1];
  other.replace(other.find(part), part.size(), "-1/5").replace(other.find(rest), rest.size(), "6/5");
  ExactClaim moved{claim, c.lines[1].substr(0, c.lines[1].find("vertex=")) + "vertex=" + other, {}};
  moved.claim[static_cast<std::size_t>(at - claim.begin()) + 1] = other;
  c.false_numbers.push_back(moved);
}

std::vector<Case> read_cases(const std::string& directory) {
  std::vector<Case> cases;
  std::ifstream list(directory + "/claims.txt");
  for (std::string line; std::getline(list, line);) {
    std::istringstream words(line);
    Case c;
    words >> c.name;
    Claim subject;
    std::optional<mpq_class> lower, upper;
    std::optional<int> rough;  // no derivatives of this order
    std::optional<std::string> exact, logarithm;
    bool of_matrices = false, is_hermite = false, exponent = false, is_range = false, is_levels = false, is_l1 = false;
    for (std::string option, value; words >> option >> value;) {
      if (option == "--lower") lower = mpq_class(value);
      is_range = is_range || option == "--for";
      is_hermite = is_hermite || option == "--hermite";
      of_matrices = of_matrices || is_hermite || option == "--vectors";
      is_levels = is_levels || option == "--levels" || option == "--each-point" ||
                  (option == "--order" && !value.starts_with("period"));
      if (option == "--upper" && value[0] == 'C')
        rough = std::stoi(value.substr(1));
      else if (option == "--upper")
        upper = mpq_class(value);
      if (option == "--exact") exact = value;
      is_l1 = is_l1 || option == "--l1";
      if (option == "--logarithm") logarithm = value;
      if (option == "--lower" || option == "--upper" || option == "--exact" || option == "--logarithm") continue;
      exponent = exponent || option == "--mask" || option == "--masks" || option == "--surface" ||
                 option == "--refinable" || option == "--l1";
      subject.insert(subject.end(),
                     {option, option == "--matrices" || option == "--subradius" ? directory + "/" + value : value});
    }
    const auto claim = [&subject](const std::optional<mpq_class>& low, const std::optional<mpq_class>& high) {
      Claim options = subject;
      if (low) options.insert(options.end(), {"--lower", low->get_str()});
      if (high) options.insert(options.end(), {"--upper", high->get_str()});
      return options;
    };
    const auto none = std::nullopt;
    const auto rough_claim = [&](int order) {
      Claim options = claim(lower, none);
      options.insert(options.end(), {"--upper", "C" + std::to_string(order)});
      return options;
    };
    c.claim = rough ? rough_claim(*rough) : claim(lower, upper);
    if (of_matrices) {  // HC^k, or limits of a vector scheme, and none of them
      const mpq_class end = lower.value_or(upper.value_or(0));
      if (lower) c.false_claims.push_back(claim(none, is_hermite ? end : mpq_class(0)));
      for (const int step : {0, 1, 2})
        if (step == 2 || !lower) c.false_claims.push_back(claim(end + step, none));
    }
    if (rough && *rough > 2) c.false_claims.push_back(rough_claim(*rough - 2));
    for (const char* step : {"1/1000000000000", "1/10", "2"}) {  // false by a hair and by far
      if (of_matrices) break;
      if (lower && upper) {
        c.false_claims.push_back(claim(*upper + mpq_class(step), none));
        c.false_claims.push_back(claim(exponent ? lower : none, *lower - mpq_class(step)));
      } else if (upper) {  // of a range: for no value of the parameter
        c.false_claims.push_back(claim(*upper + mpq_class(step) - mpq_class("1/1000000000000"), none));
      }
    }
    if (!upper && !exact && !of_matrices) {  // no upper end is known
      c.false_claims.push_back(claim(rough ? mpq_class(*rough) + 1 : mpq_class(lower.value_or(0) + 2), none));
      if (!rough && lower && !is_levels)  // of sequences of values no upper end can be asked for
        c.false_claims.push_back(claim(exponent && !is_range ? lower : none, *lower - mpq_class("1/10")));
    }
    std::ifstream file(directory + "/" + c.name + ".cert");
    for (std::string text; std::getline(file, text);) c.lines.push_back(text);
    if (is_l1) add_contraction(subject, c);
    add_vertex(c.claim, c);
    for (const mpq_class& factor : {mpq_class(2), mpq_class(1, 2)}) {
      if (!exact) break;
      const std::string other = with_other_zero(*exact, factor);
      Claim claim_of_other = subject;
      claim_of_other.insert(claim_of_other.end(), {"--exact", other});
      c.false_numbers.push_back({claim_of_other, "exact " + other, {}});
      for (const std::string& text : c.lines)
        if (text.starts_with("root ")) c.false_numbers.back().root = with_other_root(text, factor);
    }
    if (exact) c.claim.insert(c.claim.end(), {"--exact", *exact});
    if (logarithm) {
      Claim other = c.claim;
      other.insert(other.end(), {"--logarithm", *logarithm == "0" ? "1" : "0"});
      c.false_claims.push_back(other);
      c.claim.insert(c.claim.end(), {"--logarithm", *logarithm});
    }
    cases.push_back(c);
  }
  return cases;
}

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

  /// One of `field_kinds` changes of a field.
  static constexpr std::size_t field_kinds = 16;
  std::string change_field(const std::string& field, std::size_t kind) {
    std::string changed = field;
    const std::size_t at = field.empty() ? 0 : below(field.size());
    switch (kind) {
      case 0: return "0";
      case 1: return changed.insert(0, 1, '-');
      case 2: return field + std::string(30, '9');
      case 3: return std::string(6000, '7');
      case 4: return field + "/0";
      case 5: return std::string("1/").append(field);
      case 6: return "18446744073709551616";
      case 7: return "-1";
      case 8: return "";
      case 9: changed.erase(at, 1); return changed;
      case 10: changed[at] = static_cast<char>('0' + below(10)); return changed;
      case 11: changed[at] = static_cast<char>(below(256)); return changed;
      case 12: changed.insert(at, 1, "0123456789-,:/fcAB@[]+*"[below(23)]); return changed;
      case 13: return shift_number(field, 1);
      case 14: return shift_number(field, -1);
      default: return field.substr(0, field.find(':') + 1) + "0";
    }
  }

  /// One of `line_kinds` changes of the whole file; `other` lends lines.
  static constexpr std::size_t line_kinds = 13;
  void change_lines(Lines& lines, const Lines& other, std::size_t i, std::size_t kind) {
    const auto at = lines.begin() + static_cast<std::ptrdiff_t>(i);
    switch (kind) {
      case 0: lines.erase(at); break;
      case 1: lines.insert(at, std::string(*at)); break;
      case 2: std::swap(lines[i], lines[below(lines.size())]); break;
      case 3: lines.resize(i); break;
      case 4: lines[i].resize(below(lines[i].size() + 1)); break;
      case 5: lines.insert(at, other[below(other.size())]); break;
      case 6: lines[i] = other[below(other.size())]; break;
      case 7: lines.push_back(lines[i]); break;
      case 8: scale(lines, "image", 0.999); break;  // smaller weights everywhere: only the residual can tell
      case 9: scale(lines, i % 2 == 0 ? "vertex" : "unit", i % 4 < 2 ? 1.001 : 0.5); break;
      case 10: keep_heads(lines, {"image"}, 2); break;  // empty combinations
      case 11: keep_heads(lines, {"image", "unit"}, 2); break;
      default: empty_proof(lines); break;
    }
  }

 private:
  std::string shift_number(const std::string& field, int by) {
    const std::size_t begin = field.find_last_of(':') == std::string::npos ? 0 : field.find_last_of(':') + 1;
    try {
      return field.substr(0, begin) + mpz_class(mpz_class(field.substr(begin)) + by).get_str();
    } catch (const std::invalid_argument&) {
      return field + "1";
    }
  }

  static std::string scaled_number(const std::string& number, double factor) {
    try {
      return mpz_class(mpf_class(number, 300) * factor).get_str();
    } catch (const std::invalid_argument&) {  // an earlier change left no number
      return number;
    }
  }

  static void scale(Lines& lines, const std::string& keyword, double factor) {
    for (std::string& line : lines) {
      auto tokens = split(line);
      if (tokens.empty() || tokens[0] != keyword) continue;
      for (std::string& token : tokens) {
        const std::size_t begin = keyword == "vertex" ? 0 : token.find(':') + 1;
        if (begin == 0 && keyword != "vertex") continue;
        if (token == keyword) continue;
        std::string result = token.substr(0, begin);
        std::istringstream parts(token.substr(begin));
        bool first = true;
        for (std::string part; std::getline(parts, part, ':'); first = false) {
          if (!first) result += ':';
          result += scaled_number(part, factor);
        }
        token = result;
      }
      line = join(tokens);
    }
  }

  static void keep_heads(Lines& lines, const std::vector<std::string>& keywords, std::size_t indices) {
    for (std::string& line : lines) {
      auto tokens = split(line);
      for (const std::string& keyword : keywords)
        if (!tokens.empty() && tokens[0] == keyword) {
          tokens.resize(std::min(tokens.size(), keyword == "unit" ? indices : indices + 1));
          line = join(tokens);
        }
    }
  }

  void empty_proof(Lines& lines) {
    Lines kept;
    for (std::string& line : lines) {
      auto tokens = split(line);
      if (tokens.empty() || tokens[0] == "vertex" || tokens[0] == "unit" || tokens[0] == "image" ||
          tokens[0] == "form" || tokens[0] == "word" || tokens[0] == "coordinates" || tokens[0] == "step" ||
          tokens[0] == "tree")
        continue;
      if (tokens[0] == "block" && tokens.size() > 3) tokens[3].assign(1, below(2) == 0 ? '0' : '1');
      kept.push_back(join(tokens));
    }
    lines = kept;
  }

  std::mt19937 random_;
};

/// Offers mutants to the checker and counts what becomes of them.
class Campaign {
 public:
  Campaign(std::vector<Case> cases, unsigned seed) : cases_(std::move(cases)), seed_(seed), mutator_(seed) {
    failures_ += cases_.empty() ? 1 : 0;
  }
  Campaign(const Campaign&) = delete;
  ~Campaign() { std::filesystem::remove(file_); }

  /// The cases themselves, then every field and every line of each with each kind of change once; in long ones a
  /// random choice of the kinds.
  void change_everything_once() {
    for (const Case& c : cases_) {
      write(text_of(c.lines));
      if (!proves(c.claim)) fail("not accepted", c, "");
      const std::size_t one_in = 1 + c.lines.size() * c.lines.size() / 400;
      for (std::size_t i = 0; i < c.lines.size(); ++i) {
        change_fields(c, i, one_in);
        for (std::size_t kind = 0; kind < Mutator::line_kinds; ++kind) {
          if (mutator_.below(one_in) != 0) continue;
          Lines lines = c.lines;
          mutator_.change_lines(lines, any_case().lines, i, kind);
          offer(c, lines);
        }
      }
    }
  }

  /// Several changes at once, until there have been so many mutants.
  void change_at_random(std::size_t wanted) {
    while (mutants_ < wanted && !cases_.empty()) {
      const Case& c = any_case();
      Lines lines = c.lines;
      for (std::size_t changes = 1 + mutator_.below(4); changes > 0 && !lines.empty(); --changes) {
        const std::size_t i = mutator_.below(lines.size());
        auto tokens = split(lines[i]);
        if (mutator_.below(2) == 0 && !tokens.empty()) {
          const std::size_t k = mutator_.below(tokens.size());
          tokens[k] = mutator_.change_field(tokens[k], mutator_.below(Mutator::field_kinds));
          lines[i] = join(tokens);
        } else {
          mutator_.change_lines(lines, any_case().lines, i, mutator_.below(Mutator::line_kinds));
        }
      }
      offer(c, lines);
    }
  }

  bool report() const {
    std::cout << mutants_ << " mutants (seed " << seed_ << "): " << rejected_ << " rejected, " << still_true_
              << " still prove the true claim, " << failures_ << " failures, slowest " << slowest_ << " s\n";
    return failures_ == 0;
  }

 private:
  static std::string text_of(const Lines& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
  }
  const Case& any_case() { return cases_[mutator_.below(cases_.size())]; }
  void write(const std::string& text) const { std::ofstream(file_, std::ios::binary) << text; }

  void fail(const std::string& what, const Case& c, const std::string& text) {
    std::cerr << what << " (" << c.name << ", seed " << seed_ << ")\n" << text;
    ++failures_;
  }

  bool proves(Claim claim) {
    claim.push_back(file_);
    std::ostringstream out, errors;
    const std::clock_t start = std::clock();
    const int code = subcert_check::run(claim, out, errors);
    seconds_ = std::max(seconds_, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    if (code > 1 || (code == 0) != out.str().starts_with("VERIFIED "))
      std::cerr << "code " << code << errors.str() << '\n';
    return code != 1;
  }

  void offer(const Case& c, const Lines& lines) {
    std::string text = text_of(lines);
    if (mutants_ % 97 == 0 && !text.empty()) text.resize(mutator_.below(text.size()));
    ++mutants_;
    seconds_ = 0;
    write(text);
    ++(proves(c.claim) ? still_true_ : rejected_);
    for (const Claim& claim : c.false_claims)
      if (proves(claim)) fail("FALSE CLAIM PROVED: " + join(claim), c, text);
    for (const ExactClaim& other : c.false_numbers) {
      Lines changed = lines;
      const std::string head = other.exact.substr(0, other.exact.find(' ') + 1);
      for (std::size_t i = 0; i < changed.size(); ++i) {
        if (changed[i].starts_with(head)) changed[i] = other.exact;
        if (changed[i].starts_with("root ") && i < c.lines.size() && changed[i] == c.lines[i]) changed[i] = other.root;
      }
      write(text_of(changed));
      if (proves(other.claim)) fail("FALSE CLAIM PROVED: " + join(other.claim), c, text_of(changed));
    }
    slowest_ = std::max(slowest_, seconds_);
    if (seconds_ > max_seconds) fail("TOO SLOW: " + std::to_string(seconds_) + " s", c, text);
  }

  void change_fields(const Case& c, std::size_t line, std::size_t one_in) {
    const auto tokens = split(c.lines[line]);
    for (std::size_t k = 0; k < tokens.size(); ++k)
      for (std::size_t kind = 0; kind < Mutator::field_kinds; ++kind) {
        if (mutator_.below(one_in) != 0) continue;
        auto changed = tokens;
        changed[k] = mutator_.change_field(tokens[k], kind);
        Lines lines = c.lines;
        lines[line] = join(changed);
        offer(c, lines);
      }
  }

  std::vector<Case> cases_;
  unsigned seed_;
  Mutator mutator_;
  std::string file_ = std::filesystem::temp_directory_path() / ("subcert-mutant-" + std::to_string(getpid()));
  std::size_t mutants_ = 0, still_true_ = 0, rejected_ = 0, failures_ = 0;
  double seconds_ = 0, slowest_ = 0;  // of the mutant at hand, of all
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: mutate ACCEPT_DIRECTORY MUTANTS [SEED]\n";
    return 64;
  }
  Campaign campaign(read_cases(argv[1]), argc > 3 ? static_cast<unsigned>(std::stoul(argv[3])) : 20261121U);
  campaign.change_everything_once();
  campaign.change_at_random(std::stoul(argv[2]));
  return campaign.report() ? 0 : 1;
}
