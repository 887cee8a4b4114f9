#include "claim.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace subcert_check {

const char* const usage =
    "what is claimed is said here, not in FILE; 'subcert verify FILE' takes it from there\n"
    "usage: subcert-check --mask '[c0,c1,...]/D@first' --arity A [--lower P/Q [--upper P/Q]] FILE\n"
    "       subcert-check --mask '[-w,0,1/2+w,...]@first' --arity A --for 'w=LOW..HIGH'\n"
    "                     [--lower P/Q] [--upper P/Q] FILE    (for all these w; <, not <=)\n"
    "       subcert-check --mask '[-w,0,1/2+w,...]@first' --arity A --levels 'w=LOW..HIGH' --lower P/Q FILE\n"
    "                     (for all sequences of these w, one for each level; <, not <=)\n"
    "       subcert-check --mask '[-w,0,1/2+w,...]@first' --arity A --each-point 'w=LOW..HIGH' --lower P/Q FILE\n"
    "                     (for all choices of these w, one for each new point of each level)\n"
    "       subcert-check ... --levels RANGE --recurrence '[P]/(Q)' --start LOW..HIGH --from K --lower P/Q FILE\n"
    "                     (for those that follow from each other; sqrt[P]/(Q); LOW..inf --from some)\n"
    "       subcert-check --mask ... --levels RANGE --recurrence ... --limit V [--lower P/Q [--upper P/Q]] FILE\n"
    "                     (for those that tend to V; <=; --exact as below)\n"
    "       subcert-check --masks 'MASK;MASK;...' --arity A --order any --lower P/Q [--upper P/Q] FILE    (for all "
    "sequences\n"
    "                     of these masks, and the upper end for one of them; follows=0-1,1-0,...: for those where each "
    "pair is one of these)\n"
    "       subcert-check --masks ... --arity A --order period=0,1,...    (in turn; the rest as with --mask)\n"
    "       subcert-check --mask MASK --arity A [--for RANGE] --upper CK FILE    (no C^K limits, K = 1, 2, ...)\n"
    "       subcert-check --mask MASK --arity A --within EPS,M [--lower P/Q [--upper P/Q]] FILE    (for all masks\n"
    "                     within EPS of MASK that have M sum rules)\n"
    "       subcert-check --surface '[[c00,c10,...],...]/D@first,first' --dilation '[2,0;0,2]'\n"
    "                     --lower P/Q [--upper P/Q] FILE\n"
    "       subcert-check --surface ... --vertex 'triangles:N;0,0=WEIGHT@0,0,0|WEIGHT@1,0~0' FILE    (and limits of "
    "almost\n"
    "                     all data are C^1 around a vertex of valence N, or with N+ of N and above; quads:N, dual:N;\n"
    "                     --not-c1 RULES: are not, N alone)\n"
    "       subcert-check --refinable '[[[a,b],[c,d]],...]/D@first' --dilation '[2]'\n"
    "                     [--integral X0,X1,...] [--component C] --lower P/Q [--upper P/Q] FILE    (of the continuous\n"
    "                     phi = sum_k A_k phi(M x - k), one up to a factor; or the one with this integral; of phi_C\n"
    "                     alone, C = 0, 1, ...)\n"
    "       subcert-check --vectors '[[[a,b],[c,d]],...]@first' --arity A [--for 'w=LOW..HIGH'] --lower P/Q FILE\n"
    "                     (the limits of f'_i = sum_j A_(i-aj)^T f_j, for all these w; <, not <=; --upper 0: it "
    "diverges;\n"
    "                     --levels and what belongs to it in place of --for, as above; 'MASK;MASK;...' with --order:\n"
    "                     for all sequences of these masks, <=)\n"
    "       subcert-check --vectors MASK --dilation '[2,0;0,2]' --lower 0 FILE    (this scheme converges; --upper 0: "
    "it "
    "does\n"
    "                     not)\n"
    "       subcert-check --hermite MASK --arity A [--for RANGE] --lower K FILE    (it is HC^K; --upper K: it is not)\n"
    "       subcert-check --matrices MATRICES [--lower P/Q] [--upper P/Q] FILE    (at least one bound)\n"
    "       subcert-check --subradius MATRICES [--lower P/Q] [--upper P/Q] FILE    (the joint spectral subradius)\n"
    "       subcert-check --l1 N,D[,A] [--contraction STEPS,ORDER,P/Q] [--lower P/Q [--upper P/Q]] FILE\n"
    "                     (fits of degree D to N points by least absolute deviations:\n"
    "                     |D^ORDER S^STEPS f| <= P/Q |D^ORDER f|; exponents of limits)\n"
    "       subcert-check ... --exact 'M-log|[p0,p1,...]@RE,IM,EPS|^1/L' FILE    (exponents: M less the\n"
    "                     logarithm to the base A of |z|^(1/L), z the only zero of p0 + p1 x + ...\n"
    "                     within EPS of RE + i IM; radii: without M-log; beside bounds, or without)\n"
    "       subcert-check --mask MASK --arity A --within EPS,M[,symmetric] --attains T1,T2,... FILE    (exponents: M "
    "less\n"
    "                     the logarithm of the spectral radius of the product T1 T2 ... of L matrices to the power "
    "1/L)\n"
    "       subcert-check --mask ... --exact ... --logarithm P FILE    (the modulus of continuity takes |log h|^P; so "
    "with\n"
    "                     --attains)\n"
    "a mask and no bounds: its integer shifts are stable\n"
    "prints VERIFIED <claim> (exit 0) or REJECTED <why, line n> (exit 1)\n"
    "exit 64: wrong usage, 65: malformed MATRICES, 66: missing file";

namespace {

using Options = std::map<std::string, std::optional<std::string>>;

Options read_options(const std::vector<std::string>& arguments) {
  Options given;
  for (const char* name :
       {"--mask",     "--arity",     "--for",    "--levels",      "--each-point", "--recurrence", "--start",
        "--from",     "--limit",     "--masks",  "--order",       "--within",     "--surface",    "--refinable",
        "--integral", "--component", "--vertex", "--not-c1",      "--dilation",   "--vectors",    "--hermite",
        "--matrices", "--subradius", "--l1",     "--contraction", "--lower",      "--upper",      "--exact",
        "--attains",  "--logarithm", "FILE"})
    given[name];
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string name = arguments[i].starts_with("--") ? arguments[i++] : "FILE";
    require(given.contains(name), "unknown option " + name);
    require(i < arguments.size() && !given[name], name + " needs a value, and only one");
    given[name] = arguments[i];
  }
  return given;
}

/// The mask, of numbers or of matrices, and its arity or its dilation. `numbers`: others that may hold the root.
void read_scheme_claim(const std::string& kind, const std::string& mask, const std::string& scale, Claim& claim,
                       bool of_matrices = false, const std::string& numbers = {}) {
  const char letter = claim.range ? claim.range->letter : '\0';
  if (of_matrices && !claim.range && (has_root(mask) || has_root(numbers))) {
    FieldMask over_field = parse_field_mask(mask, parse_root(has_root(mask) ? mask : numbers));
    claim.mask = std::move(over_field.doubled);
    claim.root = over_field.root;
  } else {
    claim.mask = of_matrices ? parse_matrix_mask(mask, letter) : parse_mask(mask, letter);
  }
  const Vector& coefficients = claim.mask->coefficients;
  if (kind == "arity") {
    require(claim.mask->sizes.size() == 1 && claim.mask->points() <= (claim.root == 0 ? 1000 : 4000) &&
                (claim.range || of_matrices || (coefficients.front() != 0 && coefficients.back() != 0)),
            "a mask has 1 to 1000 coefficients, the first and the last not zero");
    claim.arity = static_cast<unsigned>(parse_size(scale, 2, 16));
  } else {
    claim.dilation = parse_dilation(scale);
    require(claim.dilation->variables == claim.mask->sizes.size(),
            "mask and dilation have different numbers of variables");
  }
  const std::string of_numbers = kind != "arity"    ? "surface "
                                 : claim.levels     ? "levels "
                                 : claim.each_point ? "each-point "
                                                    : "exponent ";
  const std::string vectors = claim.hermite ? "hermite " : "vectors ";
  claim.head = (!of_matrices ? of_numbers : claim.on_vectors ? vectors : "refinable ") + mask + " " + scale;
  claim.text = "Hoelder exponent";
  claim.subject = std::string(!of_matrices       ? ""
                              : claim.hermite    ? "the Hermite scheme of "
                              : claim.on_vectors ? "the vector scheme of "
                                                 : "the refinable functions of ") +
                  mask + " with " + kind + " " + scale;
}

/// A mask for each level.
void read_masks_claim(const std::string& masks, const std::string& arity, const std::string& order, Claim& claim) {
  claim.arity = static_cast<unsigned>(parse_size(arity, 2, 16));
  claim.list = parse_mask_list(masks, claim.arity, order);
  const std::vector<std::size_t>& period = claim.list->period;
  if (!period.empty()) {
    Arithmetic arithmetic;
    claim.mask = masks_in_one(*claim.list, period, arithmetic);
    claim.arity = arity_in_one(*claim.list, period.size());
  }
  claim.head = "lists " + masks + " " + arity + " " + order;
  claim.text = claim.upper && period.empty() ? "least Hoelder exponent" : "Hoelder exponent";
  claim.subject = masks + " with arity " + arity + (period.empty() ? " for all sequences of levels" : " for levels") +
                  (order == "any" ? "" : " with " + order);
}

/// A mask of matrices for each level.
void read_matrix_masks_claim(const std::string& masks, const std::string& arity, const std::string& order,
                             Claim& claim) {
  claim.arity = static_cast<unsigned>(parse_size(arity, 2, 16));
  claim.list = parse_matrix_mask_list(masks, claim.arity, order);
  claim.mask = masks_as_powers(*claim.list);
  claim.head = "lists " + masks + " " + arity + " " + order + (claim.hermite ? " hermite" : " vectors");
  claim.text = "Hoelder exponent";
  const std::string what = claim.hermite ? "the Hermite scheme of " : "the vector scheme of ";
  claim.subject = what + masks + " with arity " + arity + " for all sequences of levels" +
                  (order == "any" ? "" : " with " + order);
}

/// Of the levels of a recurrence: their masks tend to one, and the rest is about that.
void read_limit(const std::string& limit, Claim& claim) {
  const mpq_class value = parse_rational(limit);
  claim.limit = MasksToLimit{std::move(*claim.mask), *claim.range, *claim.recurrence, value};
  claim.mask = mask_at(claim.limit->family, value);
  claim.range.reset();
  claim.recurrence.reset();
  claim.head += " limit=" + limit;
  claim.text += ", tending to " + limit;
}

/// Fits of least absolute deviations: a contraction of differences, or ends of the exponent, or both.
Claim read_l1_claim(Options& given) {
  const auto &l1 = given["--l1"], &contraction = given["--contraction"], &lower = given["--lower"],
             &upper = given["--upper"], &file = given["FILE"];
  const auto count = std::count_if(given.begin(), given.end(), [](const auto& option) { return option.second; });
  require(l1 && file && (contraction || lower) && (lower || !upper) &&
              count == 2 + contraction.has_value() + lower.has_value() + upper.has_value(),
          usage);
  Claim claim;
  claim.file = *file;
  claim.l1 = parse_l1_rule(*l1);
  claim.head = "l1 " + std::to_string(claim.l1->points) + " " + std::to_string(claim.l1->degree) +
               (claim.l1->arity == 2 ? "" : " " + std::to_string(claim.l1->arity));
  if (lower) {
    claim.lower = parse_rational(*lower);
    claim.text = claim.lower->get_str() + " <= Hoelder exponent";
  }
  if (upper) {
    claim.upper = parse_rational(*upper);
    claim.text += " <= " + claim.upper->get_str();
  }
  if (contraction) {
    claim.contraction = parse_contraction(split(*contraction, ","), *claim.l1);
    const std::string difference = "|D^" + std::to_string(claim.contraction->order);
    claim.text += (lower ? " and " : "") + difference + " S^" + std::to_string(claim.contraction->steps) +
                  " f| <= " + claim.contraction->bound.get_str() + " " + difference + " f|";
  }
  claim.text += " of least absolute deviations " + *l1;
  return claim;
}

}  // namespace

std::pair<ExactRadius, std::size_t> parse_exact(std::string_view text, bool exponent) {
  const std::size_t bar = std::min(text.find('|'), text.size());
  const std::string_view before = text.substr(0, bar);
  require(exponent ? before.ends_with("-log") : before.empty(),
          "an exact exponent is M-log|[p0,p1,...]@RE,IM,EPS|^1/L, an exact radius the same without M-log");
  return {parse_exact_radius(text.substr(bar)), exponent ? parse_size(before.substr(0, bar - 4), 0, 500) : 0};
}

Claim read_claim(const std::vector<std::string>& arguments) {
  Options given = read_options(arguments);
  const auto &mask = given["--mask"], &arity = given["--arity"], &values = given["--for"], &levels = given["--levels"],
             &each = given["--each-point"],
             &range = each     ? each
                      : levels ? levels
                               : values,
             &rounding = given["--within"], &scheme = given["--surface"], &refinable = given["--refinable"],
             &integral = given["--integral"], &component = given["--component"],
             &surface = refinable ? refinable : scheme, &dilation = given["--dilation"], &smooth = given["--vertex"],
             &broken = given["--not-c1"], &vertex = smooth ? smooth : broken, &radius = given["--matrices"],
             &subradius = given["--subradius"], &vectors = given["--vectors"], &hermite = given["--hermite"],
             &of_matrices = vectors ? vectors : hermite, &masks = given["--masks"], &order = given["--order"],
             &recurrence = given["--recurrence"], &start = given["--start"], &from = given["--from"],
             &limit = given["--limit"], &one = mask ? mask : masks, &curve = one ? one : of_matrices,
             &matrices = subradius ? subradius : radius, &lower = given["--lower"], &upper = given["--upper"],
             &exact = given["--exact"], &attains = given["--attains"], &logarithm = given["--logarithm"],
             &l1 = given["--l1"], &contraction = given["--contraction"], &file = given["FILE"];
  if (l1 || contraction) return read_l1_claim(given);
  const bool rough = upper && upper->starts_with('C');
  const bool of_values = range && !limit;  // of each value, or of all choices of them
  const bool in_period = order && order->starts_with("period"), list_of_matrices = of_matrices && order,
             follow_each_other = (masks && !in_period) || list_of_matrices;
  const int subjects = one.has_value() + scheme.has_value() + refinable.has_value() + radius.has_value() +
                       subradius.has_value() + vectors.has_value() + hermite.has_value();
  const bool in_variables = vectors && dilation && !range;  // section 6.11
  require(file && subjects == 1 && (curve.has_value() && !in_variables) == arity.has_value() &&
              (surface.has_value() || in_variables) == dilation.has_value() && (mask || of_matrices || !range) &&
              (mask || !rounding) && !(mask && masks) && (masks || list_of_matrices) == order.has_value() &&
              !(order && (range || in_variables)) && recurrence.has_value() == start.has_value() &&
              start.has_value() == from.has_value() && (levels || !from) &&
              (!limit || (mask && from && !rough && !logarithm)) && (mask || !each) && !(range && rounding) &&
              (!of_matrices || (!exact && lower.has_value() != upper.has_value())) &&
              values.has_value() + levels.has_value() + each.has_value() <= 1 &&
              !(((levels && !limit) || each) && (upper || !lower)) && !(follow_each_other && (rough || !lower)) &&
              !(exact && (of_values || rounding || follow_each_other)) && (!attains || rounding) &&
              (exact || attains || lower || (upper ? matrices || of_values || rough || of_matrices : one && !limit)) &&
              (!rough || (one && !rounding)) && (!logarithm || (one && (exact || attains))) &&
              ((!component && !integral) || refinable) && (!vertex || (scheme && lower)) && !(smooth && broken),
          usage);
  Claim claim;
  claim.file = *file;
  if (lower) claim.lower = parse_rational(*lower);
  require(!vectors || !upper || parse_rational(*upper) == 0, usage);
  require(!in_variables || !lower || parse_rational(*lower) == 0, usage);
  if (rough) claim.rough = parse_size(upper->substr(1), 1, 500);
  if (upper && !rough) claim.upper = parse_rational(*upper);
  if (exact) {
    std::tie(claim.exact, claim.exact_order) = parse_exact(*exact, !matrices);
    claim.exact_text = *exact;
  }
  if (attains) {
    claim.exact.emplace().letters = parse_letters(*attains);
    claim.exact_text = *attains;
  }
  if (logarithm) claim.logarithm = parse_size(*logarithm, 0, 256);
  if (range) claim.range = parse_range(*range);
  claim.levels = levels.has_value();
  claim.each_point = each.has_value();
  if (rounding) claim.rounding = parse_rounding(*rounding);
  claim.on_vectors = of_matrices.has_value();
  claim.hermite = hermite.has_value();
  if (masks) read_masks_claim(*masks, *arity, *order, claim);
  if (list_of_matrices) read_matrix_masks_claim(*of_matrices, *arity, *order, claim);
  if (mask || (of_matrices && !order))
    read_scheme_claim(in_variables ? "dilation" : "arity", *curve, in_variables ? *dilation : *arity, claim,
                      of_matrices.has_value());
  if (surface)
    read_scheme_claim("dilation", *surface, *dilation, claim, refinable.has_value(), integral.value_or(std::string()));
  if (vertex) {
    require(*claim.lower > 1, "smoothness around a vertex needs limits with an exponent above 1");
    claim.vertex = parse_sector_rules(*vertex);
    claim.not_c1 = broken.has_value();
    require(!claim.not_c1 || !claim.vertex->and_above, "what is not C^1 is so around one valence");
    claim.head += (claim.not_c1 ? " not-c1=" : " vertex=") + *vertex;
    claim.subject += std::string(", and ") + (claim.not_c1 ? "no " : "") + "C^1 limits of almost all data around " +
                     *vertex;
  }
  if (integral) {
    claim.integral.emplace();
    if (claim.root != 0)
      claim.integral = parse_field_numbers(*integral, claim.root);
    else
      for (const std::string_view number : split(*integral, ",")) claim.integral->push_back(parse_rational(number));
    require(claim.integral->size() == claim.mask->components &&
                std::ranges::any_of(*claim.integral, [](const mpq_class& x) { return x != 0; }),
            "an integral is a list of a number for each component, not all 0");
    claim.head += " integral=" + *integral;
    claim.subject += " and integral " + *integral;
  }
  if (component) {
    claim.component = parse_size(*component, 0, claim.functions() - 1);
    claim.head += " component=" + *component;
    claim.subject = "component " + *component + " of " + claim.subject;
  }
  if (matrices) {
    read(*matrices, 65, [&](Reader& reader) {
      const Fields fields = reader.take("matrices", 2, 2);
      const std::size_t count = parse_size(fields[0], 1, 4096), size = parse_size(fields[1], 1, 256);
      require(count * size * size <= std::size_t{1} << 22, "more entries than 2^22");
      claim.family = read_family(reader, "row", count, size);
      require(reader.at_end(), "text after the last row");
    });
    claim.subradius = subradius.has_value();
    const std::string what = claim.subradius ? "subradius" : "radius";
    claim.head = what + " " + std::to_string(claim.family.count()) + " " + std::to_string(claim.family.size);
    claim.text = "joint spectral " + what;
    claim.subject = *matrices;
  }
  if (exact) claim.text += " = " + *exact;
  if (attains)
    claim.text += " = " + std::to_string(claim.rounding->sum_rules) + "-log rho(" + *attains + ")^1/" +
                  std::to_string(claim.exact->letters.size());
  const bool is_number = exact || attains;
  const std::string number = lower || is_number ? claim.text + " and " : "";
  if (!lower && !upper && !is_number) claim.text = "stable integer shifts of the refinable distribution";
  const bool strict = claim.is_strict() && !limit;
  const std::string relation = strict ? " < " : " <= ";
  const bool diverges = strict && !lower && claim.upper && *claim.upper == 0;
  if (diverges)
    claim.text = "no convergence";
  else if (of_values && upper && !lower && !rough)
    claim.text = "no convergence, or " + claim.text;
  if (rough) claim.text = number + "no C^" + upper->substr(1) + " limits";
  if (hermite) claim.text = (lower ? "HC^" : "no HC^") + std::to_string(parse_size(lower ? *lower : *upper, 0, 500));
  claim.text = (lower && !hermite ? claim.lower->get_str() + relation : "") + claim.text +
               (upper && !diverges && !rough && !hermite ? relation + claim.upper->get_str() : "") +
               (logarithm ? " with |log h|^" + *logarithm : "") + " of " + claim.subject;
  if (range) {
    claim.head += " " + *range + (levels && of_matrices ? " levels" : "");
    if (recurrence) {
      claim.recurrence = parse_recurrence(*recurrence, *start, *from, claim.range->letter);
      claim.head += " recurrence=" + *recurrence + " start=" + *start + " from=" + *from;
      claim.text += (claim.recurrence->from ? " from level " + *from : " from some level") + " on of " +
                    range->substr(0, 1) + " -> " + *recurrence + " with " + range->substr(0, 1) + "=" + *start +
                    " at level 0, all in " + *range;
      if (limit) read_limit(*limit, claim);
    } else {
      claim.text += (levels ? " for all sequences of levels with "
                     : each ? " for all choices for each new point of "
                            : " for all ") +
                    *range;
    }
  }
  if (rounding) {
    claim.head += " within=" + *rounding;
    claim.text += " for all masks within=" + *rounding;
  }
  return claim;
}

}  // namespace subcert_check
