"""Vectors of refinable functions whose matrices have a square root (5.13). Exponents are known by hand."""
import math
from fractions import Fraction as Q

BUBBLE = "[[[2,0],[0,0]],[[4,0],[0,2*sqrt(2)]],[[2,0],[4,2*sqrt(2)]]]/4@-1"  # SPEC.md, 5.13: exponent 1/2
# that and its conjugate beside it, which is rougher: 1 + sqrt(2) and 1 - sqrt(2) over 4
CONJUGATE = "[[[2,0],[0,0]],[[4,0],[0,-1+sqrt(2)]],[[2,0],[4,-1+sqrt(2)]]]/4@-1"
SWAPPED = "[[[0,0],[0,2]],[[2*sqrt(2),0],[0,4]],[[2*sqrt(2),4],[0,2]]]/4@-1"  # the hat function is the second one
SPACE = "differences 2; digits 0 1; values 0.0:1; space 3; vector 0.1:1; vector 1.1:1; vector -1.0:1 0.0:-2 1.0:1; "
UNIT = ("blocks 1 1 1; basis 1 0 0 0 0 0; basis 0 1 0 0 0 0; basis 0 0 1 0 0 0; inverse 1 0 0 0 0 0; inverse 0 1 0 0 0 0; "
        "inverse 0 0 1 0 0 0; ")
# b times 1 + sqrt(2), with the inverse sqrt(2) - 1
TURNED = ("blocks 1 1 1; basis 1 0 0 1 0 0; basis 0 1 0 0 0 0; basis 0 0 1 0 0 0; inverse -1 0 0 1 0 0; inverse 0 1 0 0 0 0; "
          "inverse 0 0 1 0 0 0; ")
# b + b' and b - b', and y + sqrt(2) b: blocks of 2 and 1
TWO = ("blocks 2 1; basis 1 0 0 0 0 1; basis 0 1 0 0 0 0; basis 0 0 1 0 0 0; inverse 1 0 0 0 0 -1; inverse 0 1 0 0 0 0; "
       "inverse 0 0 1 0 0 0; ")
NORMS = "block 0 norm 1; block 1 norm 1; block 2 norm 1; end"
PRODUCT = "product 0 7071/10000 0 0; "
BOUNDS = "4999/10000 5001/10000"
EXACT = "0-log|[-1,0,2]@7/10,0,1/10|^1/1"
ROOT = "root 7071/10000 0 1/10000 7069/10000 7073/10000; "
NUMBER = "polytope 1 0 0; vertex 1; unit 0 0:1; image 0 0 0:1; image 0 1 0:1; cycle 0 - 0; seed 1 0; same 0 1 0; "
ALONE = "polytope 1 0 0; vertex 1; unit 0 0:1; image 0 0 0:1; image 0 1; cycle 0 - 0; seed 1 0; "
NAMED = f"block 0 {NUMBER}block 1 {ALONE}block 2 norm 1; end"


def claim(mask, ends="--lower 49/100"):
    return f"--refinable {mask} --dilation [2] {ends}"


def accepted(name, mask, ends, lines):
    lower, _, upper = ends.partition(" ")
    return (name, claim(mask, f"--lower {lower}" + (f" --upper {upper}" if upper else "")),
            f"refinable {mask} [2]; bounds {lower} {upper or '-'}; {lines}")


def asked(name, mask, what, ends, lines):
    """Of one component, or of the solution with an integral: `what` as in the second line."""
    lower, upper = ends.split()
    options = what.replace("integral=", "--integral ").replace("component=", "--component ")
    return (name, claim(mask, f"{options} --lower {lower} --upper {upper}"),
            f"refinable {mask} [2] {what}; bounds {lower} {upper}; {lines}")


def exact(name, mask, number, lines):
    return name, claim(mask, f"--exact {number}"), f"refinable {mask} [2]; bounds - -; exact {number}; {lines}"


def parts(matrix):
    """Of entries that are rational, or pairs (p, q) for p + q sqrt(R), the p and the q."""
    return [[[Q(x[k]) if isinstance(x, tuple) else Q(x if k == 0 else 0) for x in row] for row in matrix] for k in (0, 1)]


def characteristic(tools, root, scale, matrices, word, letters):
    """The polynomial of a product, and then the flip if there is a word, times that of its conjugate: by [X, R Y; Y, X]."""
    n = len(matrices[0])
    product = [[Q(i == k) for k in range(2 * n)] for i in range(2 * n)]
    for t in letters:
        x, y = parts(matrices[t])
        halves = [[*x[i], *(root * v for v in y[i])] for i in range(n)] + [[*y[i], *x[i]] for i in range(n)]
        product = tools.multiply([[v / scale for v in row] for row in halves], product)
    if word == "f":
        product = product[:n][::-1] + product[n:][::-1]
    result, m = [Q(1)], [[Q(0)] * (2 * n) for _ in range(2 * n)]
    for k in range(1, 2 * n + 1):  # Faddeev and LeVerrier
        m = tools.multiply(product, [[v + result[0] * (i == j) for j, v in enumerate(row)] for i, row in enumerate(m)])
        result.insert(0, -sum(m[i][i] for i in range(2 * n)) / k)
    common = math.lcm(*(c.denominator for c in result))
    return [int(c * common) for c in result]


def beside_hat(tools, root, scale, matrices, word, cycles, p, centre, within, symmetric=False, transposed=False, others=(), level=3, limit=14):
    """A hat function h, and beside it f = h(2x - 1) (1, ..., 1) + C_0 f(2x) + C_1 f(2x - 1), zero outside of [0, 1]: the C_t are the
    `matrices` over the scale. Blocks are the C_t, then (C_1, 0) and (1/2, 0). `cycles`: first vertices, words, letters and seeds."""
    n, r = len(matrices[0]), len(matrices[0]) + 1
    exact = [parts(m) for m in matrices]
    entry = lambda t, i, k: "+".join(f"{x}{f'*sqrt({root})' if j else ''}" for j, x in enumerate((exact[t][0][i][k], exact[t][1][i][k])) if x) or "0"
    rows = lambda first, block: "[" + ",".join("[" + ",".join(row) + "]" for row in [first, *block]) + "]"
    number = str(scale)
    mask = "[" + ",".join((
        rows([str(Q(scale, 2)), *["0"] * n], [["0"] * r for _ in range(n)]),
        rows([number, *["0"] * n], [["0", *(entry(0, i, k) for k in range(n))] for i in range(n)]),
        rows([str(Q(scale, 2)), *["0"] * n], [[number, *(entry(1, i, k) for k in range(n))] for i in range(n)]))) + f"]/{scale}@-1"
    mask = mask.replace("+-", "-")
    near = [[[x / scale + y / scale * Q(math.isqrt(root * 4**200), 2**200) for x, y in zip(*pair)] for pair in zip(*m)] for m in exact]
    if transposed:
        near = [[list(column) for column in zip(*m)] for m in near]
    lines, _, rho = tools.polytope(near, word, symmetric, limit, others, turned=cycles[0][1] == "f")
    if transposed:
        lines[0] += " transposed"
    size = 2 * n + 1
    unit = lambda head: [f"{head} " + " ".join("1" if i == k else "0" for k in range(2 * size)) for i in range(size)]
    space = ["differences 2", "digits 0 1", "values 0.0:1", f"space {size}", *(f"vector {j}.{c}:1" for j in (0, 1) for c in range(1, r)),
             "vector -1.0:1 0.0:-2 1.0:1", f"blocks {n} {n} 1", *unit("basis"), *unit("inverse")]
    case = ["--refinable", mask, "--dilation", "[2]"], [
        "subcert-certificate 3", f"refinable {mask} [2]", "bounds - -", *space, *lines, f"block 1 norm {level}", "block 2 norm 1", "end"]
    return tools.exactly(case, near, "0-log", p, centre, within, cycles)


MATRICES = []
CHANGED = []
# what subcert-check takes for sqrt(2), times 2^512
NEAR, ONE = math.isqrt(2 * 4**512), 2**512
# (h + sqrt(2) q, q), h the hat function and q the quadratic B-spline: solutions (x h + sqrt(2) y q, y q), with the integral (x + sqrt(2) y, y)
MIXED = "[[[2,-sqrt(2)],[0,1]],[[4,-sqrt(2)],[0,3]],[[2,sqrt(2)],[0,3]],[[0,sqrt(2)],[0,1]]]/4@-1"
RATIONAL = "[[[2,0],[0,1]],[[4,0],[0,3]],[[2,0],[0,3]],[[0,0],[0,1]]]/4@-1"  # h and q
FUNCTIONALS = "functional 1 0 0 0; functional 0 1 0 0; "
HAT = f"differences 2; digits 0 1; values 0.0:1; {FUNCTIONALS}space 1; vector -1.0:1 0.0:-2 1.0:1; product 0 1/2 0 0; block 0 norm 1; end"
# b and b' times sqrt(2)
OF_ROOT = ("blocks 1 1 1; basis 0 0 0 1 0 0; basis 0 0 0 0 1 0; basis 0 0 1 0 0 0; inverse 0 0 0 1/2 0 0; inverse 0 0 0 0 1/2 0; "
           "inverse 0 0 1 0 0 0; ")
# corner cutting beside numbers that are halved: SPEC.md, 6.9
CUT = "[[[s,0],[0,1/2]],[[1-s,0],[0,1/2]],[[1-s,0],[0,0]],[[s,0],[0,0]]]@0".replace("s", "1/4*sqrt(2)")
FAR = CUT.replace("1/4*sqrt(2)", "sqrt(2)")  # no convergence: 2 T_0 has the eigenvalue 2 - 4 sqrt(2)
CUTTING = "sum-rules 1; data 1 0 0 0; digits 0 1; reading 0.1:1; space 3; vector 0.1:1; vector 0.0:1 1.0:-1; vector 2.0:1 1.0:-1; "
# Merrien's, mu = 2 sqrt(2) - 2, with one sum rule more than functions; and parabolas phi_1 + sqrt(2) phi_2, phi_2
MERRIEN = "[[[4,12-8*sqrt(2)],[-1,-4+4*sqrt(2)]],[[8,0],[0,4]],[[4,-12+8*sqrt(2)],[1,-4+4*sqrt(2)]]]/8@-1"
OF_MERRIEN = ("sum-rules 3; digits 0 1; reading 0.0:-3 0.1:2 1.0:4 2.0:-1; space 3; vector -1.0:2 0.1:-4 1.0:-2; "
              "vector -1.1:2 0.1:-4 1.1:2; vector 0.0:2 0.1:-1 1.0:-2 1.1:-1; blocks 1 1 1; basis -2 -6 3 0 -8 0; "
              "basis 1 5 -2 0 6 0; basis 2 4 -4 0 8 0; inverse -2 -2 -1/2 0 0 0; inverse 0 3 -3/2 0 -2 1; inverse "
              "-1 -6 2 0 4 -2; block 0 norm 1; block 1 norm 1; block 2 norm 1; end")
PARABOLAS = "[[[2,2-sqrt(2)],[0,1]],[[2+2*sqrt(2),-4+2*sqrt(2)],[2,4-2*sqrt(2)]],[[2*sqrt(2),-4+sqrt(2)],[2,1-2*sqrt(2)]]]/4@0"
OF_PARABOLAS = ("sum-rules 3; data 0 -4 2 2; data 0 -2 1 2; data 0 0 0 1; digits 0 1; reading 0.0:-4 0.1:2 0.2:2 "
                "1.0:3 2.0:-1; space 3; vector 0.0:1 1.1:-2 2.0:-9 2.1:2 2.2:4 2.3:-4; vector 0.1:1 1.1:-4 1.3:2 "
                "2.0:-28 2.1:15 2.2:20 2.3:-10; vector 1.0:1 2.0:1 2.1:-2 2.2:-2; blocks 1 1 1; basis -1/2 0 4 0 0 "
                "-2; basis 0 0 -2 0 0 0; basis -1/2 -1 -3 1 0 0; inverse -2 -4 0 0 2 0; inverse 1 15/2 -1 -2 -5 0; "
                "inverse 0 -1/2 0 0 0 0; block 0 norm 1; block 1 norm 1; block 2 norm 1; end")


def scheme(name, kind, mask, bounds, lines):
    lower, upper = bounds.split()
    option = f"--lower {lower}" if upper == "-" else f"--upper {upper}"
    return name, f"--{kind} {mask} --arity 2 {option}", f"{kind} {mask} 2; bounds {bounds}; {lines}"


ACCEPTED = [
    scheme("field-scheme", "vectors", CUT, "0 -", CUTTING + "block 0 norm 1; end"),
    scheme("field-scheme-multiple", "vectors", CUT, "0 -", CUTTING.replace("data 1 0 0 0", "data 3 0 -1/2 0") + "block 0 norm 1; end"),
    scheme("field-scheme-reading", "vectors", CUT, "0 -", CUTTING.replace("reading 0.1:1", "reading 0.3:-2") + "block 0 norm 1; end"),
    scheme("field-scheme-hermite", "hermite", MERRIEN, "1 -", OF_MERRIEN),
    scheme("field-scheme-mixed", "vectors", PARABOLAS, "0 -", OF_PARABOLAS),
    scheme("field-scheme-diverges", "vectors", FAR, "- 0", CUTTING + "product 0 -3656/1000 0 0; end"),
    accepted("field-by-hand", BUBBLE, BOUNDS, SPACE + UNIT + PRODUCT + NORMS),
    accepted("field-turned", BUBBLE, BOUNDS, SPACE + TURNED + PRODUCT + NORMS),
    accepted("field-two", BUBBLE, "499/1000 5001/10000", SPACE + TWO + "product 0 7071/10000 0 1; block 0 norm 1; block 1 norm 1; end"),
    accepted("field-whole", BUBBLE, "1/5", SPACE + "block 0 norm 12; end"),
    # for a lower end the space may be a larger one
    accepted("field-larger-space-lower", BUBBLE, "1/10", SPACE.replace("space 3; ", "space 4; vector 2.1:1; ") + "block 0 norm 12; end"),
    # a multiple of the values; the root of another number, in another form
    accepted("field-multiple", BUBBLE, BOUNDS, SPACE.replace("values 0.0:1", "values 0.0:1 0.2:-3") + UNIT + PRODUCT + NORMS),
    accepted("field-other-form", BUBBLE.replace("2*sqrt(2)", "1/2*sqrt(8)+1-1+3/2*sqrt(8)-sqrt(8)"), BOUNDS, SPACE + UNIT + PRODUCT + NORMS),
    accepted("field-values-root", BUBBLE, BOUNDS, SPACE.replace("values 0.0:1", "values 0.2:1") + UNIT + PRODUCT + NORMS),
    accepted("field-swapped", SWAPPED, BOUNDS, SPACE.replace("values 0.0", "values 0.1").replace("vector 0.1", "vector 0.0")
             .replace("vector 1.1", "vector 1.0").replace("-1.0:1 0.0:-2 1.0:1", "-1.1:1 0.1:-2 1.1:1") + UNIT + PRODUCT + NORMS),
    # the limit of the root
    accepted("field-root-large", BUBBLE.replace("2*sqrt(2)", "1/12500*sqrt(1000000000)"), "66/100 67/100", SPACE + UNIT + "product 0 632/1000 0 0; " + NORMS),
    # the conjugate would have the radius 0.6; the last block is rational
    accepted("field-conjugate", CONJUGATE, "1 1", SPACE + UNIT + "product 2 1/2 0 0; " + NORMS),
    accepted("field-rational-form", CONJUGATE, "1 1", SPACE + UNIT + "product 2 1/2 0 0; block 0 norm 1; block 1 norm 1; "
             "block 2 quadratic 2 1/2; form 1; word 0; word 1; end"),
    # the hat without the bubble, the bubble, and the number of the hat; the hat as one of several solutions
    asked("field-component", BUBBLE, "component=0", "1 1", SPACE + "unobservable 2; " + UNIT + "product 2 1/2 0 0; " + NORMS),
    asked("field-component-turned", BUBBLE, "component=0", "1 1", SPACE + "unobservable 2; " + OF_ROOT + "product 2 1/2 0 0; " + NORMS),
    asked("field-component-all", BUBBLE, "component=1", BOUNDS, SPACE + "unobservable 0; " + UNIT + PRODUCT + NORMS),
    asked("field-integral", MIXED, "integral=1,0", "1 1", HAT),
    asked("field-integral-multiple", MIXED, "integral=-1/3,0", "1 1", HAT.replace("values 0.0:1", "values 0.0:5")),
    asked("field-integral-root", MIXED, "integral=1,0", "1 1", HAT.replace("functional 1 0 0 0", "functional 0 0 1 0; functional 3 0 -2 0")),
    asked("field-integral-of-root", MIXED, "integral=sqrt(2),0", "1 1", HAT.replace("values 0.0:1", "values 0.2:1")),
    asked("field-integral-of-both", MIXED, "integral=1/2-1/3*sqrt(2),0", "1 1", HAT.replace("values 0.0:1", "values 0.0:3 0.2:-2")),
    asked("field-integral-alone", RATIONAL, "integral=sqrt(2),0", "1 1", HAT.replace("values 0.0:1", "values 0.2:1")),
    asked("field-integral-component", MIXED, "integral=1,0 component=0", "1 1", HAT.replace("product", "unobservable 0; product")),
    exact("field-exact", BUBBLE, EXACT, ROOT + SPACE + UNIT + NAMED),
    exact("field-exact-rational", CONJUGATE, "0-log|[-1,2]@1/2,0,1/4|^1/1", "root 1/2 0 0 1/2 1/2; " + SPACE + UNIT +
          "block 0 norm 1; block 1 norm 1; block 2 polytope 1 0 1; vertex 1; unit 0 0:2; image 0 0 0:1; image 0 1; cycle 0 - 0; seed 1; end"),
]


def word_case(tools, matrices, word, cycles, centre, transposed=False, **more):
    p = characteristic(tools, 2, 8, matrices, cycles[0][1], cycles[0][2])
    seed = [1] + [0] * (2 * len(matrices[0]) - 1)
    return beside_hat(tools, 2, 8, matrices, word, [(*cycle, seed) for cycle in cycles], p, centre, "1/10000", transposed=transposed, **more)


FLIP = [[[3, (0, 3)], [0, 3]], [[3, 0], [(0, 3), 3]]]
WORD = [[[3, (0, 2)], [0, 3]], [[3, 0], [(1, 1), 3]]]


def two_numbers(number, section="norm 1", sign=""):
    """A bubble with sqrt(2)/2 as before, or less that, and one with a rational number, which is said to be the radius."""
    c, size = f"{sign}1/2*sqrt(2)", 5
    mask = f"[[[1/2,0,0],[0,0,0],[0,0,0]],[[1,0,0],[0,{c},0],[0,0,{number}]],[[1/2,0,0],[1,{c},0],[1,0,{number}]]]@-1"
    exact, n, d = f"0-log|[-{number.numerator},{number.denominator}]@7/10,0,1/10|^1/1", number.numerator, number.denominator
    unit = lambda head: [f"{head} " + " ".join("1" if i == k else "0" for k in range(2 * size)) for i in range(size)]
    bits = d.bit_length() - 1
    weight = round(number * 2**bits)  # the number, or a little more
    return claim(mask, f"--exact {exact}").split(), [
        "subcert-certificate 3", f"refinable {mask} [2]", "bounds - -", f"exact {exact}", f"root {number} 0 0 {number} {number}",
        "differences 2", "digits 0 1", "values 0.0:1", "space 5", "vector 0.1:1", "vector 0.2:1", "vector 1.1:1", "vector 1.2:1",
        "vector -1.0:1 0.0:-2 1.0:1", "blocks 1 1 1 1 1", *unit("basis"), *unit("inverse"), *f"block 0 {section}".split("; "),
        f"block 1 polytope 1 0 {bits}", "vertex 1", f"unit 0 0:{2**bits}", f"image 0 0 0:{weight}", f"image 0 1 0:{weight}", "cycle 0 - 0", "seed 1",
        "same 0 1 0", *f"block 2 {section.partition('; image 0 1')[0]}".split("; "), *(["image 0 1"] if "image" in section else []), "block 3 norm 1", "block 4 norm 1", "end"]


def accepted_by(tools):
    """Names and cases; `tools`: make_certificates."""
    yield "field-two-numbers", two_numbers(Q(725, 1024))
    yield "field-two-numbers-polytope", two_numbers(Q(725, 1024), "polytope 1 0 10; vertex 1; unit 0 0:1024; image 0 0 0:-724; image 0 1 0:-724", "-")
    yield "field-flip", word_case(tools, FLIP, [0, 1], [(0, "f", [1])], "18111/25000", symmetric=True)
    yield "field-word", word_case(tools, WORD, [0, 1], [(0, "-", [1, 0])], "16379/50000")
    yield "field-word-transposed", word_case(tools, WORD, [0, 1], [(0, "-", [1, 0])], "16379/50000", transposed=True)
    yield "field-negative", word_case(tools, [[[-5, (0, 1)], [1, 3]], [[3, 0], [(1, -1), (0, 2)]]], [0], [(0, "-", [0])], "-64663/100000")
    # an eigenvalue of degree 2, of which not all vectors are seeds
    yield "field-seed", beside_hat(tools, 2, 8, [[[(0, 4), 1], [0, 1]], [[2, 1], [1, 1]]], [0], [(0, "-", [0], [1, 0, 0, 0])],
                                   [-1, 0, 2], "7/10", "1/10")


TWO_HATS = "[[[2,0],[0,2]],[[4,0],[0,4]],[[2,0],[sqrt(2),2]]]/4@-1"
HALVES = f"[[[2,0],[0,0]],[[4,0],[0,2*sqrt(2)]],[[2,0],[4,{2 * NEAR}/{ONE}]]]/4@-1"  # c for T_0 and a number near c for T_1
ROUGH = BUBBLE.replace("2*sqrt(2)", "3*sqrt(2)")  # a bubble that is not continuous
BELOW = ("blocks 1 1 1; basis 0 0 0 0 1 0; basis 0 0 0 0 0 1; basis 1 0 0 0 0 0; inverse 0 0 1 0 0 0; inverse 0 0 0 1/2 0 0; "
         "inverse 0 0 0 0 1/2 0; ")
MANY_ENTRIES = f"[{'[[sqrt(2),0],[0,1]],' * 624}[[1,0],[0,1]]]"  # 2500
ENTRIES_1000 = f"[{'[[sqrt(2),0],[0,1]],' * 249}[[1,0],[0,1]]]"
EDITED = [
    ("field-other-values", "field-by-hand", None, "not fixed", [("values 0.0:1", "values 0.0:1 0.3:1")]),
    ("field-no-values", "field-by-hand", None, "expected 'values'", [("values 0.0:1; ", "")]),
    ("field-value-outside", "field-by-hand", None, "number outside 0..3", [("values 0.0:1", "values 0.4:1")]),
    ("field-two-hats", "field-by-hand", claim(TWO_HATS), "the refinement equation may have several continuous solutions", [(BUBBLE, TWO_HATS)]),
    ("field-hidden-quadratic", "field-component", None, "expected 'norm', 'polytope'", [("block 0 norm 1", "block 0 quadratic 1 3/4; form 1; word 0")]),
    ("field-one-entry-below", "field-by-hand", claim(BUBBLE, "--lower 1/10"), "not block upper triangular",
     [("blocks 1 1 1", "blocks 2 1"), *((f"{x} 0 1 0 0 0 0; {x} 0 0 1 0 0 0", f"{x} 0 0 1 0 0 0; {x} 0 1 0 0 0 0") for x in ("basis", "inverse")),
      (PRODUCT + NORMS, "block 0 norm 8; block 1 norm 8; end")]),
    ("field-other-root", "field-by-hand", claim(BUBBLE.replace("sqrt(2)", "sqrt(3)")), "expected 'refinable ", []),
    ("field-rational", "field-by-hand", claim(BUBBLE.replace("*sqrt(2)", "")), "expected 'refinable ", []),
    ("field-as-rational", "field-by-hand", claim(BUBBLE.replace("*sqrt(2)", "")), "wrong number of fields", [(BUBBLE, BUBBLE.replace("*sqrt(2)", ""))]),
    # the space
    ("field-pivot", "field-by-hand", None, "the first point of a vector is of a multiple of the root", [("vector 0.1:1", "vector 0.3:1")]),
    ("field-pivot-first", "field-by-hand", None, "the first point of a vector is of a multiple of the root",
     [("vector -1.0:1 0.0:-2 1.0:1", "vector -1.2:1 0.2:-2 1.2:1")]),
    ("field-pivot-twice", "field-by-hand", None, "occurs in another", [("vector 0.1:1", "vector 0.1:1 0.3:1")]),
    ("field-pivot-root", "field-by-hand", None, "occurs in another", [("vector 1.1:1", "vector 1.1:1 0.3:1")]),
    ("field-space-129", "field-by-hand", None, "number outside 1..128", [("space 3", "space 129")]),
    ("field-smaller-space", "field-by-hand", None, "a transition operator leads out of the space", [("space 3; vector 0.1:1; ", "space 2; ")]),
    ("field-not-led", "field-by-hand", None, "not led into the space", [("space 3; ", "space 2; "), ("; vector -1.0:1 0.0:-2 1.0:1", "")]),
    ("field-larger-space", "field-by-hand", None, "the differences do not span the space", [("space 3; ", "space 4; vector 2.1:1; ")]),
    ("field-larger-space-exact", "field-exact", None, "the differences do not span the space", [("space 3; ", "space 4; vector 2.1:1; ")]),
    ("field-above-order", "field-by-hand", claim(BUBBLE, "--lower 201/100"), "the lower end is above the order of the differences", []),
    ("field-order-64", "field-by-hand", None, "not fixed", [("differences 2", "differences 64"), ("values 0.0:1", "values 0.0:1 0.3:1")]),
    ("field-order-65", "field-by-hand", None, "a higher order than the checker allows", [("differences 2", "differences 65")]),
    # blocks
    ("field-sizes", "field-by-hand", None, "the block sizes do not sum to n", [("blocks 1 1 1", "blocks 1 1")]),
    ("field-basis-fields", "field-by-hand", None, "wrong number of fields", [("basis 1 0 0 0 0 0", "basis 1 0 0")]),
    ("field-inverse", "field-turned", None, "basis times inverse is not the unit matrix", [("inverse -1 0 0 1 0 0", "inverse -1 0 0 2 0 0")]),
    ("field-inverse-twice", "field-by-hand", None, "basis times inverse is not the unit matrix", [("inverse 1 0 0 0 0 0", "inverse 2 0 0 0 0 0")]),
    ("field-inverse-root", "field-by-hand", None, "basis times inverse is not the unit matrix", [("inverse 1 0 0 0 0 0", "inverse 1 0 0 1 0 0")]),
    ("field-below", "field-by-hand", None, "not block upper triangular", [("basis 1 0 0 0 0 0; basis 0 1 0 0 0 0; basis 0 0 1 0 0 0", "basis 0 0 1 0 0 0; basis 0 1 0 0 0 0; basis 1 0 0 0 0 0"),
     ("inverse 1 0 0 0 0 0; inverse 0 1 0 0 0 0; inverse 0 0 1 0 0 0", "inverse 0 0 1 0 0 0; inverse 0 1 0 0 0 0; inverse 1 0 0 0 0 0")]),
    ("field-below-rational", "field-by-hand", None, "not block upper triangular", [
        (f"{head} 0 1 0 0 0 0; {head} 0 0 1 0 0 0", f"{head} 0 0 1 0 0 0; {head} 0 1 0 0 0 0") for head in ("basis", "inverse")]),
    ("field-many-entries", "field-by-hand", claim(MANY_ENTRIES), "expected 'refinable ", []),
    ("field-below-root", "field-by-hand", None, "not block upper triangular", [(UNIT[:-2], BELOW[:-2])]),
    # one component
    ("field-component-whole", "field-component", None, "number outside 0..2", [("unobservable 2", "unobservable 3")]),
    ("field-component-absent", "field-by-hand", claim(BUBBLE, "--component 0 --lower 49/100"), "expected 'refinable ", []),
    ("field-component-line", "field-component", None, "expected 'unobservable'", [("unobservable 2; ", "")]),
    ("field-component-shown", "field-component-all", None, "the component shows what is said to be unobservable", [("unobservable 0", "unobservable 2")]),
    ("field-component-shown-root", "field-component-all", None, "the component shows what is said to be unobservable", [
        ("unobservable 0", "unobservable 2"), (UNIT[:-2], OF_ROOT[:-2])]),
    ("field-component-less", "field-component", None, "more than what is said to be unobservable may be so", [("unobservable 2", "unobservable 1")]),
    ("field-component-sizes", "field-component", None, "what is unobservable consists of no blocks", [("blocks 1 1 1", "blocks 1 2")]),
    ("field-component-no-blocks", "field-component", None, "expected 'blocks', those of what is unobservable first", [(UNIT, "")]),
    ("field-component-product", "field-component", None, "number outside 2..2", [("product 2 1/2", "product 0 7071/10000")]),
    ("field-component-hidden", "field-component", claim(ROUGH, "--component 0 --lower 1 --upper 1"), "the bound does not prove the claim", [(BUBBLE, ROUGH)]),
    # an integral
    ("field-integral-other", "field-integral", claim(MIXED, "--integral 1,1 --lower 1"), "the values are not those of this integral", [("integral=1,0", "integral=1,1")]),
    ("field-integral-none", "field-integral", claim(TWO_HATS, "--integral 1,0 --lower 1"), "the integral is none of a solution", [(MIXED, TWO_HATS)]),
    ("field-integral-factor", "field-integral", None, "the values are not those of this integral", [("values 0.0:1", "values 0.0:1 0.2:1")]),
    ("field-integral-conjugate", "field-integral", None, "the values are not those of this integral", [("values 0.0:1", "values 0.2:1"), ("functional 1 0 0 0; functional 0 1 0 0", "functional 0 0 1 0; functional 0 1 0 0")]),
    ("field-integral-no-root", "field-integral-of-root", None, "the values are not those of this integral", [("values 0.2:1", "values 0.0:1")]),
    ("field-integral-other-part", "field-integral-of-both", None, "the values are not those of this integral", [("0.2:-2", "0.2:2")]),
    ("field-integral-other-root", "field-integral-alone", claim(RATIONAL, "--integral sqrt(3),0 --lower 1"), "expected 'refinable ", []),
    ("field-integral-few", "field-integral", None, "the functionals do not tell all of an integral", [("functional 0 1 0 0; ", "")]),
    ("field-integral-functional", "field-integral", None, "wrong number of fields", [("functional 1 0 0 0", "functional 1 0")]),
    ("field-integral-line", "field-integral", None, "expected 'functional'", [(FUNCTIONALS, "")]),
    # schemes
    ("field-scheme-data", "field-scheme", None, "wrong number of fields", [("data 1 0 0 0", "data 1 0")]),
    ("field-scheme-zero", "field-scheme", None, "the scheme does not keep the constant data", [("data 1 0 0 0", "data 0 1 0 0")]),
    ("field-scheme-data-root", "field-scheme", None, "the scheme does not keep the constant data", [("data 1 0 0 0", "data 1 0 0 1")]),
    ("field-scheme-no-data", "field-scheme", None, "the constant data are 0", [("data 1 0 0 0", "data 0 0 0 0")]),
    ("field-scheme-two-readings", "field-scheme", None, "a line 'reading' has not one number of its component", [("reading 0.1:1", "reading 0.1:1 0.3:1")]),
    ("field-scheme-reading-other", "field-scheme", None, "a line 'reading' does not annihilate the data", [("reading 0.1:1", "reading 0.1:1 0.2:1")]),
    ("field-scheme-reading-part", "field-scheme", None, "a line 'reading' does not annihilate the data", [("reading 0.1:1", "reading 0.1:1 0.0:1")]),
    ("field-scheme-vector", "field-scheme", None, "a vector does not annihilate the data", [("vector 0.1:1", "vector 0.1:1 5.2:1")]),
    ("field-scheme-smaller", "field-scheme", None, "a transition operator leads out of the space", [("space 3", "space 2"), ("; vector 2.0:1 1.0:-1", "")]),
    ("field-scheme-larger-order", "field-scheme", None, "the scheme does not keep the data", [("sum-rules 1; data 1 0 0 0", "sum-rules 2; data 1 0 0 0; data 0 0 0 0")]),
    ("field-scheme-1000", "field-scheme", f"--vectors {ENTRIES_1000} --arity 2 --lower 0", "expected 'vectors ", []),
    ("field-scheme-lower", "field-scheme", f"--vectors {CUT} --arity 2 --lower 2/3", "the bound does not prove the claim", []),
    ("field-scheme-upper", "field-scheme-diverges", None, "prove", [("-3656/1000", "3656/1000")]),
    ("field-scheme-below", "field-scheme-diverges", f"--vectors {CUT} --arity 2 --upper 0", "prove", [(FAR, CUT), ("-3656/1000", "707/1000")]),
    # the ends
    ("field-lower", "field-by-hand", claim(BUBBLE, "--lower 1/2"), "the bound does not prove the claim", []),
    ("field-upper", "field-by-hand", claim(BUBBLE, "--lower 49/100 --upper 1/2"), "does not prove the claim", []),
    ("field-conjugate-product", "field-conjugate", claim(CONJUGATE, "--lower 1 --upper 3/4"), "proves no positive spectral radius", [("product 2 1/2", "product 0 -6036/10000")]),
    ("field-no-product", "field-by-hand", None, "expected 'product'", [(PRODUCT[:-2] + "; ", "")]),
    # what rational blocks have alone
    ("field-quadratic", "field-by-hand", None, "expected 'norm'", [("block 0 norm 1", "block 0 quadratic 2 3/4; form 1; word 0; word 1")]),
    ("field-graph", "field-by-hand", None, "expected 'norm'", [("block 0 norm 1", "block 0 graph 1 3/4 8")]),
    ("field-group", "field-exact", None, "a group proves nothing", [("polytope 1 0 0; vertex", "polytope 1 0 0 group:1; generator 0 1; map 1; vertex")]),
    # the number
    ("field-exact-other", "field-exact", claim(BUBBLE, "--exact 0-log|[-2,0,3]@8/10,0,1/10|^1/1"), "expected 'exact ", []),
    ("field-exact-conjugate", "field-exact", claim(BUBBLE, "--exact " + EXACT.replace("@7", "@-7")), "may be zero where the vertex is large",
     [("@7/10", "@-7/10"), ("root 7071", "root -7071")]),
    ("field-exact-order", "field-exact", claim(BUBBLE, "--exact " + EXACT.replace("0-log", "2-log")), "another number before its logarithm", [("0-log", "2-log")]),
    ("field-seed-fields", "field-exact", None, "wrong number of fields", [("seed 1 0; same", "seed 1; same")]),
    ("field-seed-zero", "field-exact", None, "may be zero where the vertex is large", [("seed 1 0; same", "seed 0 0; same")]),
    ("field-no-same", "field-exact", None, "may lie outside", [("; same 0 1 0", "")]),
    ("field-same-other", "field-exact", None, "an image is not the vertex that it is said to be", [("seed 1 0; block 2", "seed 1 0; same 0 1 0; block 2")]),
    ("field-same-near", "field-exact", claim(HALVES, "--exact " + EXACT), "an image is not the vertex that it is said to be", [(BUBBLE, HALVES)]),
    ("field-complex", "field-exact", None, "over a field complex polytopes and cones name no radius", [
        ("polytope 1 0 0; vertex 1; unit 0 0:1; image 0 0 0:1; image 0 1 0:1", "polytope 1 0 0 complex; vertex 1 0; unit 0 0:1:0; image 0 0 0:1:0; image 0 1 0:1:0")]),
    ("field-cone", "field-exact", None, "over a field complex polytopes and cones name no radius", [("polytope 1 0 0; vertex", "polytope 1 0 0 nonnegative; vertex")]),
]
REJECTED = [(name, base, options, reason, [tuple(part.replace("; ", "\n") for part in edit) for edit in edits])
            for name, base, options, reason, edits in EDITED]

# the component reads all of the halves p and q, but for one combination: what it shows is counted over the field
HALF_SEEN = [
    ("field-halves", 0, "[[[2,-2,2*sqrt(2)],[0,0,0],[0,0,0]],[[4,-3,3*sqrt(2)],[0,1,4-sqrt(2)],[0,0,2*sqrt(2)]],[[6,-5,5*sqrt(2)],[4+4*sqrt(2),-3-4*sqrt(2),12+3*sqrt(2)],[4,-4,6*sqrt(2)]]]/4@-1",
     "differences 1; digits 0 1; values 0.0:1; space 6; vector -1.0:2 1.5:-1; vector 0.0:2 1.5:-1; vector 0.1:2 "
     "1.5:1; vector 0.2:2 1.2:-2; vector 1.0:2 1.5:-1; vector 1.1:2 1.5:1; unobservable 0; blocks 1 1 1 1 1 1; "
     "basis 0 0 -1 1 -2 1 0 0 0 0 1 0; basis 1 0 1 0 0 0 0 1 0 0 0 0; basis 1 0 0 0 0 0 0 0 0 0 0 0; basis 0 -1 "
     "0 0 0 0 0 0 0 0 0 0; basis 0 0 0 -5 6 0 0 0 0 0 0 0; basis 0 0 0 0 0 0 0 0 0 2 1 0; inverse 0 0 1 0 0 0 0 "
     "0 0 0 0 0; inverse 0 0 0 -1 0 0 0 0 0 0 0 0; inverse 0 1 -1 0 0 0 0 0 0 1 0 0; inverse 0 0 0 0 -1/17 0 0 0 "
     "0 0 0 3/17; inverse 0 0 0 0 2/17 0 0 0 0 0 0 5/34; inverse 1 1 -1 0 5/17 -5/17 0 0 0 1 -2/17 2/17; product "
     "1 7071/10000 0 0; block 0 norm 1; block 1 polytope 1 0 0; vertex 1; unit 0 0:1; image 0 0 0:1; image 0 1 "
     "0:1; cycle 0 - 0; seed 1 0; same 0 1 0; block 2 norm 1; block 3 norm 1; block 4 norm 1; block 5 polytope 1 "
     "0 0; vertex 1; unit 0 0:1; image 0 0 0:1; image 0 1; cycle 0 - 0; seed 1 0; end"),
    ("field-halves-first", 2, "[[[16*sqrt(2),-10,0],[48-3*sqrt(2),2-15*sqrt(2),0],[12,-4*sqrt(2),2*sqrt(2)]],[[6+10*sqrt(2),-6-2*sqrt(2),0],[30+3*sqrt(2),-2-9*sqrt(2),0],[0,0,2*sqrt(2)]],[[6+6*sqrt(2),-4-2*sqrt(2),0],[18+6*sqrt(2),-4-6*sqrt(2),0],[0,0,0]]]/4@-1",
     "differences 1; digits 0 1; values 0.0:1 0.1:7 0.3:2; space 6; vector -1.0:1 1.0:-3 1.1:-9 1.3:-3 1.4:-3; "
     "vector -1.1:1 1.0:2 1.1:2 1.3:1 1.4:3; vector -1.2:1; vector 0.0:1 1.0:-3 1.1:-9 1.3:-3 1.4:-3; vector "
     "0.1:1 1.0:2 1.1:2 1.3:1 1.4:3; vector 0.2:1; unobservable 0; blocks 1 1 1 1 1 1; basis 0 0 1 1 0 1 0 1 0 "
     "-2 0 0; basis 0 3 1 -1 -3 0 0 0 0 0 0 0; basis 1 0 0 0 0 0 0 0 0 0 0 0; basis 0 0 -1 -2 0 0 0 0 -2 2 0 0; "
     "basis 0 0 -7 -2 4 0 0 0 0 0 0 0; basis 0 0 0 6 0 0 0 0 0 0 0 0; inverse 0 0 1 0 0 0 0 0 0 0 0 0; inverse 0 "
     "1/3 0 17/84 1/4 10/21 0 0 0 -17/42 0 -17/84; inverse 0 0 0 1/7 0 5/21 0 0 0 -2/7 0 -1/7; inverse 0 0 0 0 0 "
     "1/6 0 0 0 0 0 0; inverse 0 0 0 1/4 1/4 1/2 0 0 0 -1/2 0 -1/4; inverse 1 0 0 2/3 0 0 0 -1/3 0 1/12 -1/4 0; "
     "product 0 7071/10000 0 0; block 0 polytope 1 0 0; vertex 1; unit 0 0:1; image 0 0 0:1; image 0 1 0:1; "
     "cycle 0 - 0; seed 1 0; same 0 1 0; block 1 norm 1; block 2 norm 1; block 3 norm 1; block 4 polytope 1 0 0; "
     "vertex 1; unit 0 0:1; image 0 0 0:1; image 0 1; cycle 0 - 0; seed 1 0; block 5 norm 1; end"),
]


def rejected_by(tools):
    """Names, cases and reasons."""
    # a rational number that is smaller than sqrt(2)/2 and not below what is taken for it: the exponent is another one
    less, above = Q(NEAR, 2 * ONE), "the bound of a block is above the exact radius"
    for sign in ("", "-"):
        polytope = f"polytope 1 0 513; vertex 1; unit 0 0:{2**513}; image 0 0 0:{sign}{NEAR}; image 0 1 0:{sign}{NEAR}"
        for name, section in (("norm", "norm 1"), ("polytope", polytope)):
            yield f"field-two-numbers-less-{name}{sign}", two_numbers(less, section, sign), above
    options, lines = word_case(tools, FLIP, [0, 1], [(0, "f", [1])], "18111/25000", symmetric=True)
    near = [[[f"{3 * NEAR}/{ONE}" if x == (0, 3) else str(x) for x in row] for row in m] for m in FLIP]
    mask = options[1].replace("[8,3*sqrt(2),3]", f"[8,{near[1][1][0]},3]")
    for name, other in (("nearly", mask), ("not", options[1].replace("[8,3*sqrt(2),3]", "[8,3*sqrt(2),4]"))):
        yield f"field-{name}-symmetric", ([options[0], other, *options[2:]], [lines[0], f"refinable {other} [2]", *lines[2:]]), "the family is not symmetric"
    options, lines = beside_hat(tools, 2, 8, [[[(0, 4), 1], [0, 1]], [[2, 1], [1, 1]]], [0], [(0, "-", [0], [0, 1, 0, 0])], [-1, 0, 2], "7/10", "1/10")
    yield "field-other-seed", (options, lines), "the polynomial of the cycle does not vanish on the seed"
    for name, component, mask, lines in HALF_SEEN:
        exact = EXACT.replace("@7/10,0,1/10", "@707/1000,0,1/1000")
        head = f"subcert-certificate 3; refinable {mask} [2] component={component}; bounds - -; exact {exact}; {ROOT}"
        yield name, (claim(mask, f"--component {component} --exact {exact}").split(), (head + lines).split("; ")), \
            "more than what is said to be unobservable may be so"
