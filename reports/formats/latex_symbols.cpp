#include "latex_symbols.hpp"

#include <subcert/analysis/symbol/support/utf8.hpp>

#include <map>
#include <sstream>

namespace subcert::formats {
namespace {

using Kind = MathNode::Kind;
using Symbols = std::map<std::string, Symbol, std::less<>>;

/// `glyphs`: names and texts in turn.
void add(Symbols& list, Atom atom, Kind kind, bool upright, const char* glyphs) {
  std::istringstream words(glyphs);
  for (std::string name, text; words >> name >> text;) list[name] = {text, atom, kind, upright};
}

/// The commands without arguments, and the accents; the text of a space is its width.
const Symbols& symbols() {
  static const Symbols all = [] {
    Symbols list;
    add(list, Atom::ordinary, Kind::identifier, false,
        "alpha α beta β gamma γ delta δ epsilon ϵ varepsilon ε zeta ζ eta η theta θ vartheta ϑ iota ι "
        "kappa κ lambda λ mu μ nu ν xi ξ pi π varpi ϖ rho ρ varrho ϱ sigma σ varsigma ς tau τ "
        "upsilon υ phi ϕ varphi φ chi χ psi ψ omega ω partial ∂ ell ℓ");
    add(list, Atom::ordinary, Kind::identifier, true,
        "Gamma Γ Delta Δ Theta Θ Lambda Λ Xi Ξ Pi Π Sigma Σ Upsilon Υ Phi Φ Psi Ψ Omega Ω nabla ∇ "
        "infty ∞ emptyset ∅");
    add(list, Atom::ordinary, Kind::symbol, false,
        "prime ′ forall ∀ exists ∃ neg ¬ dots … ldots … cdots ⋯ vert | | ‖ Vert ‖ % % # # & & "
        "_ _ $ $");
    add(list, Atom::binary, Kind::symbol, false,
        "pm ± mp ∓ cdot ⋅ times × ast ∗ star ⋆ circ ∘ bullet ∙ otimes ⊗ oplus ⊕ cap ∩ "
        "cup ∪ setminus ∖ wedge ∧ vee ∨ dagger †");
    add(list, Atom::relation, Kind::symbol, false,
        "leq ≤ le ≤ geq ≥ ge ≥ neq ≠ ne ≠ ll ≪ gg ≫ lt < gt > sim ∼ simeq ≃ approx ≈ "
        "cong ≅ equiv ≡ propto ∝ in ∈ notin ∉ ni ∋ subset ⊂ subseteq ⊆ supset ⊃ supseteq ⊇ "
        "mid ∣ parallel ∥ perp ⊥ to → rightarrow → leftarrow ← gets ← mapsto ↦ Rightarrow ⇒ "
        "Leftarrow ⇐ Leftrightarrow ⇔ iff ⇔ implies ⇒");
    add(list, Atom::large, Kind::symbol, false,
        "sum ∑ prod ∏ int ∫ bigcup ⋃ bigcap ⋂ bigoplus ⨁ "
        "bigotimes ⨂");
    add(list, Atom::open, Kind::symbol, false, "{ { lbrace { langle ⟨ lfloor ⌊ lceil ⌈ lvert | lVert ‖");
    add(list, Atom::close, Kind::symbol, false, "} } rbrace } rangle ⟩ rfloor ⌋ rceil ⌉ rvert | rVert ‖");
    add(list, Atom::punctuation, Kind::symbol, false, "colon :");
    add(list, Atom::function, Kind::identifier, true,
        "arg arg cos cos cot cot deg deg det det dim dim exp exp gcd gcd inf inf ker ker lim lim ln ln log log "
        "max max min min sin sin sup sup tan tan");
    add(list, Atom::ordinary, Kind::accent, false,
        "bar ¯ hat ˆ tilde ˜ dot ˙ ddot ¨ vec → check ˇ overline ¯ widehat ^ widetilde ~");
    add(list, Atom::ordinary, Kind::space, false, ", 0.167 : 0.222 > 0.222 ; 0.278 ! -0.167 quad 1 qquad 2");
    list[" "] = {"0.25", Atom::ordinary, Kind::space};
    return list;
  }();
  return all;
}

/// The characters that stand for themselves, or for one more beautiful.
const Symbols& characters() {
  static const Symbols all = [] {
    Symbols list;
    add(list, Atom::ordinary, Kind::symbol, false, "| | / / . .");
    add(list, Atom::ordinary, Kind::space, false, "~ 0.25");
    add(list, Atom::binary, Kind::symbol, false, "+ + - − * ∗");
    add(list, Atom::relation, Kind::symbol, false, "= = < < > >");
    add(list, Atom::open, Kind::symbol, false, "( ( [ [");
    add(list, Atom::close, Kind::symbol, false, ") ) ] ] ! !");
    add(list, Atom::punctuation, Kind::symbol, false, ", , ; ; : :");
    return list;
  }();
  return all;
}

/// Of a character beyond U+FFFF.
std::string utf8(char32_t c) {
  const auto byte = [&](int lead, int shift) {
    return static_cast<char>(lead | (static_cast<int>(c >> shift) & 0x3f));
  };
  return {byte(0xf0, 18), byte(0x80, 12), byte(0x80, 6), byte(0x80, 0)};
}

}  // namespace

const Symbol* symbol(const std::string& token) {
  const bool is_command = token.size() > 1;
  const Symbols& known = is_command ? symbols() : characters();
  const auto found = known.find(is_command ? token.substr(1) : token);
  return found == known.end() ? nullptr : &found->second;
}

std::string in_alphabet(const std::string& alphabet, char c) {
  static const Symbols exceptions = [] {
    Symbols list;
    add(list, Atom::ordinary, Kind::identifier, false,
        "mathbbC ℂ mathbbH ℍ mathbbN ℕ mathbbP ℙ mathbbQ ℚ mathbbR ℝ mathbbZ ℤ "
        "mathcalB ℬ mathcalE ℰ mathcalF ℱ mathcalH ℋ mathcalI ℐ mathcalL ℒ mathcalM ℳ mathcalR ℛ "
        "mathcale ℯ mathcalg ℊ mathcalo ℴ");
    return list;
  }();
  if (const auto found = exceptions.find(alphabet + c); found != exceptions.end()) return found->second.text;
  const bool bold = alphabet == "mathbf", blackboard = alphabet == "mathbb";
  if (is_digit(c)) return utf8((bold ? U'𝟎' : U'𝟘') + static_cast<char32_t>(c - '0'));
  const int place = c >= 'a' ? c - 'a' + 26 : c - 'A';
  return utf8((bold ? U'𝐀' : blackboard ? U'𝔸' : U'𝒜') + static_cast<char32_t>(place));
}

}  // namespace subcert::formats
