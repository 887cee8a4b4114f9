"""Products that attain the radius for all masks near one: SPEC.md, section 7.1."""
from fractions import Fraction as Q

D4 = "[273205,473205,126795,-73205]/400000"
BY_HAND = (f"exponent {D4} 2 within=1/1000000,2; bounds - -; attains 0 27319/10000 27322/10000; sum-rules 2; stability; "
           "block 0 polytope 1 0 0; vertex 1; unit 0 0:1; image 0 0 0:3; image 0 1 0:-1; cycle 0 - 273205/100000 0; "
           "inverse 0; column 0 0 -1; column 1 1 0; logarithm 0; end")
CLAIM = f"--mask {D4} --arity 2 --within 1/1000000,2 --attains 0"


def inverse(matrix, bits):
    """The lines of an inverse over 2^bits, by elimination in Fractions."""
    n = len(matrix)
    m = [[*row, *(Q(i == k) for k in range(n))] for i, row in enumerate(matrix)]
    for c in range(n):
        pivot = max(range(c, n), key=lambda i: abs(m[i][c]))
        m[c], m[pivot] = m[pivot], m[c]
        m[c] = [x / m[c][c] for x in m[c]]
        for i in range(n):
            if i != c and m[i][c] != 0:
                m[i] = [x - m[i][c] * p for x, p in zip(m[i], m[c])]
    return [f"inverse {bits}"] + [f"column {k} " + " ".join(str(round(m[i][n + k] * 2**bits)) for i in range(n)) for k in range(n)]


def cycle_lines(tools, family, vertex, first, word, letters, bits=80, point=None):
    """The lines of a cycle; the number near its eigenvalue."""
    n = len(family[0])
    product = [[Q(i == k) for k in range(n)] for i in range(n)]
    for t in letters:
        product = tools.multiply(family[t], product)
    if word == "f":
        product = product[::-1]
    kept = max(range(n), key=lambda i: (abs(vertex[i]), -i))
    image = sum(a * v for a, v in zip(product[kept], vertex))
    value = point or Q(round(image / vertex[kept] * 2**bits), 2**bits)
    system = [[product[i][k] - (value if i == k else 0) for k in range(n)] + [-vertex[i]] for i in range(n)]
    system.append([Q(k == kept) for k in range(n + 1)])
    return [f"cycle {first} {word} {value} " + " ".join(map(str, letters)), *inverse(system, bits)], value


def attains(tools, mask_text, arity, rounding, word, cycles, symmetric=False, bounds=None, transposed=False, others=(), logarithm=True):
    """A real polytope of vertices that are images; `cycles`: first vertices, words and letters; `word`: the product."""
    order = int(rounding.split(",")[1])
    values, _, scale = mask_text.partition("/")
    mask = [Q(c) / Q(scale.partition("@")[0] or 1) for c in values.strip("[]").split(",")]
    family = tools.transition(mask, arity, order)
    if transposed:
        family = [[list(column) for column in zip(*m)] for m in family]
    first = cycles[0]
    turns = [*first[2], *(arity - 1 - t for t in first[2])] if first[1] == "f" else first[2]
    lines, value, rho = tools.polytope(family, list(reversed(turns)), symmetric, others=others, turned=first[1] == "f")
    if transposed:
        lines[0] += " transposed"
    case = ["--mask", mask_text, "--arity", str(arity), "--within", rounding, "--attains", ",".join(map(str, word))], [
        "subcert-certificate 3", f"exponent {mask_text} {arity} within={rounding}", "bounds - -", f"sum-rules {order}",
        "stability", *lines, "end"]
    options, lines = tools.exactly(case, family, "0-log", [0, 1], 0, 1, [(*cycle, [0]) for cycle in cycles], root=("root", rho))
    vertices = [[Q(int(c), 1 << tools.BITS) for c in line.split()[1:]] for line in lines if line.startswith("vertex")]
    result, point = [], None
    for line in lines:
        if line.startswith("cycle"):
            _, at, turn, *letters = line.split()
            more, found = cycle_lines(tools, family, vertices[int(at)], at, turn, list(map(int, letters)), point=point)
            point = point or found
            result += more
        elif line.startswith("exact"):
            low, high = bounds or (Q(round(rho * 10**6) - 2, 10**6), Q(round(rho * 10**6) + 2, 10**6))
            result.append(f"attains {','.join(map(str, word))} {low} {high}")
        elif not line.startswith(("root", "seed")):
            result.append(line)
    return ([*options[:-2], "--logarithm", "0"], [*result[:-1], "logarithm 0", "end"]) if logarithm else (options[:-2], result)


def accepted(tools):
    """Names and cases; `tools`: make_certificates."""
    four_point = "[-1,0,9,16,9,0,-1]/16@-3"
    yield "attains-four-point", attains(tools, four_point, 2, "1/1000000000000,4,symmetric", [0], [(0, "-", [0])], True, logarithm=False)
    # both ends are eigenvectors, of the first and of the last matrix: each is the other one's reflection, or a pair
    yield "attains-pair", attains(
        tools, "[-2,11,24,9,-2]/20", 2, "1/1000000000000,1", [0], [(0, "-", [0]), (1, "-", [1])],
        others=[[0.9 * x for x in tools.leading([[1.3, -0.2, 0], [-0.2, 1.1, 1.3], [0, 0, -0.2]])[1]]])
    yield "attains-flip", attains(tools, "[9,11,11,9]/20", 2, "1/1000000000000,1,symmetric", [0, 1], [(0, "f", [1])], True)
    yield "attains-word", attains(tools, "[8,11,12,9]/20", 2, "1/1000000000000,1", [0, 1], [(0, "-", [1, 0])])
    yield "attains-transposed", attains(tools, "[8,11,12,9]/20", 2, "1/1000000000000,1", [1, 0], [(0, "-", [1, 0])], transposed=True)
    yield "attains-middle", attains(tools, "[1,8,7,13,7,8,1]/15", 3, "1/1000000000000,1,symmetric", [1], [(0, "-", [1])], True)
    yield "attains-middle-plain", attains(tools, "[1,8,7,13,7,8,1]/15", 3, "1/1000000000000,1", [1], [(0, "-", [1])])
    yield "attains-middle-given", attains(tools, "[-1,6,9,17,9,6,-1]/15", 3, "1/1000000000000,1,symmetric", [1], [(0, "-", [1])], True,
                                          others=[[1.0, 1.0]])


def rejected(tools):
    """Names, cases and reasons: second cycles that say nothing."""
    pair = "[-2,11,24,9,-2]/20"
    first = tools.leading([[-0.2, 0, 0], [1.1, 1.3, -0.2], [-0.2, -0.2, 1.1]])[1]
    other = [0.9 * x for x in tools.leading([[1.3, -0.2, 0], [-0.2, 1.1, 1.3], [0, 0, -0.2]])[1]]
    both = [(0, "-", [0]), (1, "-", [1])]
    yield "attains-pair-same", attains(tools, pair, 2, "1/1000000000000,1", [0], [(0, "-", [0]), (2, "-", [0])],
                                       others=[other, [0.5 * x for x in first]], logarithm=False), SAME
    case = attains(tools, pair, 2, "1/1000000000000,1", [0], both, others=[other], logarithm=False)
    at = [i for i, line in enumerate(case[1]) if line.startswith("cycle")][1]
    words = case[1][at].split()
    words[3] = str(Q(words[3]) + Q(1, 2**60))
    yield "attains-pair-eigenvalue", (case[0], [*case[1][:at], " ".join(words), *case[1][at + 1:]]), SAME
    # of two letters: the second cycle follows the first one, from the next vertex on
    options, lines = attains(tools, "[8,11,12,9]/20", 2, "1/1000000000000,1", [0, 1], [(0, "-", [1, 0])], logarithm=False)
    family = tools.transition([Q(c, 20) for c in (8, 11, 12, 9)], 2, 1)
    vertex = [Q(int(c), 1 << tools.BITS) for c in next(line for line in lines[8:] if line.startswith("vertex")).split()[1:]]
    at = next(i for i, line in enumerate(lines) if line.startswith("origin"))
    value = Q(next(line for line in lines if line.startswith("cycle")).split()[3])
    yield "attains-pair-words", (options, [*lines[:at], *cycle_lines(tools, family, vertex, 1, "-", [0, 1], point=value)[0], *lines[at:]]), SAME
    yield "attains-pair-symmetric", attains(tools, "[-1,0,9,16,9,0,-1]/16", 2, "1/1000000000000,4,symmetric", [0], both, True,
                                            others=[[1, 0]], logarithm=False), SAME
    # a given vertex that is opposite to its flip: one image is said to be what it is, another one is outside
    yield "attains-middle-opposite", attains(tools, "[1,8,7,13,7,8,1]/15", 3, "1/1000000000000,1,symmetric", [1], [(0, "-", [1])], True,
                                             others=[[2.0, -2.0]]), "image 2 1 may lie outside"
    # 3/2 is in a corner of both matrices
    yield "attains-pair-corner", attains(tools, "[3,1,1,3]/4", 2, "1/1000000000000,1", [0], both, others=[[0.9 * 0.6, 0.9]],
                                         logarithm=False), "a corner of a matrix may be the eigenvalue"


MATRICES, CHANGED = [], [
    ("attains-upper", "attains-by-hand-ends", f"{CLAIM} --upper 56/100", []),
    ("attains-negative", "attains-by-hand", None, [("vertex 1", "vertex -1"), ("0:1\n", "0:-1\n"), ("0:3\n", "0:3\n"),
                                                   ("column 0 0 -1\ncolumn 1 1 0", "column 0 0 1\ncolumn 1 1 0")]),
]
ACCEPTED = [("attains-by-hand", f"{CLAIM} --logarithm 0", BY_HAND),
            ("attains-by-hand-ends", f"{CLAIM} --lower 54/100 --upper 56/100", BY_HAND.replace(
                "bounds - -", "bounds 54/100 56/100").replace("block 0", "product 0 273205/100000 0 0; block 0")
             .replace("image 0 0 0:3", "image 0 0 0:2933516350").replace("image 0 1 0:-1", "image 0 1 0:-786032702")
             .replace("polytope 1 0 0", "polytope 1 0 30").replace("unit 0 0:1", "unit 0 0:1073741824"))]
FOUR = "--mask [-1,0,9,16,9,0,-1]/16@-3 --arity 2 --within 1/1000000000000,4"
FLIP = "--mask [9,11,11,9]/20 --arity 2 --within 1/1000000000000,1,symmetric --attains"
WORD = "--mask [8,11,12,9]/20 --arity 2 --within 1/1000000000000,1 --attains"
PAIR = "--mask [-2,11,24,9,-2]/20 --arity 2 --within 1/1000000000000,1 --attains"
OTHER, LIES = "the product of the cycle is not the one of the claim", "may lie outside"
FAR, BOUNDS = "no eigenvector is proved near the first vertex of the cycle", "the bounds of the exact radius are wrong"
NOTHING, SAME = "nothing says of all masks near by that an image is a vertex", "nothing says that two products have the same radius"
NUMBERS = "no exponent between 0 and the number of sum rules"
C = "273205/100000"
COLUMNS = "inverse 0\ncolumn 0 0 -1\ncolumn 1 1 0\n"
REJECTED = [
    ("attains-other", "attains-by-hand", f"{CLAIM[:-1]}1", "another product", []),
    ("attains-other-both", "attains-by-hand", f"{CLAIM[:-1]}1", OTHER, [("attains 0", "attains 1")]),
    ("attains-longer", "attains-by-hand", f"{CLAIM},0", OTHER, [("attains 0", "attains 0,0")]),
    ("attains-none", "attains-by-hand", None, "expected 'attains'", [("attains 0 27319/10000 27322/10000\n", "")]),
    ("attains-letters", "attains-by-hand", f"--mask {D4} --arity 2 --within 1/1000000,2 --lower 1/2", "more than 1000 letters",
     [("attains 0 ", f"attains {'0,' * 1000}0 ")]),
    ("attains-letter-16", "attains-by-hand", f"--mask {D4} --arity 2 --within 1/1000000,2 --lower 1/2", "number outside 0..15", [("attains 0 ", "attains 16 ")]),
    ("attains-exact", "attains-by-hand", None, ", line 4", [("attains 0 27319/10000 27322/10000", "exact 2-log|[-1,1]@1,0,1|^1/1")]),
    ("attains-not-rounded", "four-point", None, "expected 'sum-rules'", [("sum-rules", "attains 0 4 4\nsum-rules")]),
    ("attains-low-0", "attains-by-hand", None, "not positive", [("27319/10000", "0")]),
    ("attains-high-0", "attains-by-hand", None, "not positive", [("27322/10000", "0")]),
    ("attains-low", "attains-by-hand", None, BOUNDS, [("27319/10000", "27320/10000")]),
    ("attains-high", "attains-by-hand", None, BOUNDS, [("27322/10000", "27321/10000")]),
    ("attains-low-1", "attains-by-hand", None, NUMBERS, [("27319/10000", "1")]),
    ("attains-high-4", "attains-by-hand", None, NUMBERS, [("27322/10000", "4")]),
    ("attains-logarithm-1", "attains-by-hand", f"{CLAIM} --logarithm 1", "products grow with another power", [("logarithm 0", "logarithm 1")]),
    ("attains-logarithm-claim", "attains-by-hand", f"{CLAIM} --logarithm 1", "the logarithm of the claim is not proved", []),
    ("attains-logarithm-integer", "attains-four-point", f"{FOUR},symmetric --attains 0 --logarithm 0", "the exponent may be an integer", [("\nend", "\nlogarithm 0\nend")]),
    ("attains-no-cycle", "attains-by-hand", None, "the bound of a block is above the exact radius", [(f"cycle 0 - {C} 0\n{COLUMNS}", "")]),
    ("attains-no-stability", "attains-by-hand", None, "expected 'stability'", [("stability\n", "")]),
    ("attains-no-product", "attains-by-hand-ends", None, "expected 'product'", [("product 0 273205/100000 0 0\n", "")]),
    ("attains-lower", "attains-by-hand-ends", f"{CLAIM} --lower 552/1000", "does not prove the claim", []),
    ("attains-symmetric-claim", "attains-four-point", f"{FOUR} --attains 0", "prove nothing", [("4,symmetric", "4")]),
    ("attains-cone", "attains-by-hand", None, "a matrix is not non-negative", [("polytope 1 0 0", "polytope 1 0 0 nonnegative")]),
    ("attains-turn", "attains-by-hand", None, "the word of a cycle is '-' or 'f'", [("cycle 0 -", "cycle 0 g")]),
    ("attains-turn-empty", "attains-by-hand", None, "the word of a cycle is '-' or 'f'", [("cycle 0 -", "cycle 0 ")]),
    ("attains-turn-plain", "attains-by-hand", None, "the word of a cycle is '-' or 'f'", [("cycle 0 -", "cycle 0 f")]),
    ("attains-turn-none", "attains-flip", f"{FLIP} 1", FAR, [("attains 0,1", "attains 1"), ("cycle 0 f", "cycle 0 -")]),
    ("attains-turn-unknown", "attains-flip", None, "the word of a cycle is '-' or 'f'", [("cycle 0 f", "cycle 0 g")]),
    ("attains-turn-first", "attains-flip", f"{FLIP} 1,0", OTHER, [("attains 0,1", "attains 1,0")]),
    ("attains-order", "attains-word", f"{WORD} 1,0", OTHER, [("attains 0,1", "attains 1,0")]),
    ("attains-order-transposed", "attains-transposed", f"{WORD} 0,1", OTHER, [("attains 1,0", "attains 0,1")]),
    ("attains-vertex", "attains-by-hand", None, "number outside 0..0", [("cycle 0", "cycle 1")]),
    ("attains-letter", "attains-by-hand", None, "number outside 0..1", [(f"{C} 0", f"{C} 2")]),
    ("attains-no-letter", "attains-by-hand", None, "wrong number of fields", [(f"{C} 0", C)]),
    ("attains-inverse-none", "attains-by-hand", None, "expected 'inverse'", [(COLUMNS, "")]),
    ("attains-column", "attains-by-hand", None, "expected 'column 1'", [("column 1 1 0\n", "")]),
    ("attains-column-short", "attains-by-hand", None, "wrong number of fields", [("column 0 0 -1", "column 0 0")]),
    ("attains-inverse-0", "attains-by-hand", None, FAR, [("column 0 0 -1", "column 0 0 0")]),
    ("attains-inverse-sign", "attains-by-hand", None, FAR, [("column 1 1 0", "column 1 -1 0")]),
    ("attains-eigenvalue", "attains-by-hand", None, BOUNDS, [(f"{C} 0", "27322/10000 0")]),
    ("attains-eigenvalue-far", "attains-by-hand", None, FAR, [(f"{C} 0", "3 0")]),
    ("attains-image", "attains-by-hand", None, "image 0 1 " + LIES, [("image 0 1 0:-1", "image 0 1 0:1")]),
    ("attains-image-closing", "attains-word", None, LIES, [("origin 3 1 1\n", "")]),
    ("attains-origin-order", "attains-word", None, ", line 28", [("origin 1 0 1\norigin 2 0 0\n", "origin 2 0 0\norigin 1 0 1\n")]),
    ("attains-origin-none", "attains-word", None, "a vertex of a cycle is missing", [("origin 1 0 1\n", "")]),
    ("attains-origin-far", "attains-word", None, "too far", [("origin 3 1 1", "origin 3 0 0")]),
    ("attains-same-none", "attains-middle", None, LIES, [("same 0 2 1f\n", "")]),
    ("attains-same-plain", "attains-middle", None, NOTHING, [("same 0 2 1f", "same 0 2 1")]),
    ("attains-same-other", "attains-middle", None, NOTHING, [("same 0 2 1f", "same 0 0 1f")]),
    ("attains-same-not-symmetric", "attains-middle-plain", None, ", line 29", [("logarithm", "same 0 2 1f\nlogarithm")]),
    ("attains-same-given", "attains-middle-given", None, NOTHING, [(f"vertex {2**64} {2**64}\n", f"vertex {2**64} {2**64 - 1}\n")]),
    ("attains-same-roots", "attains-middle-given", None, NOTHING, [("same 1 2 2f", "same 0 2 2f")]),
    ("attains-same-turned", "attains-flip", None, NOTHING, [("logarithm", "same 0 1 0f\nlogarithm")]),
    ("attains-same-vertex", "attains-pair", None, NOTHING, [("logarithm", "same 0 0 0\nlogarithm")]),
    ("attains-1000", "attains-by-hand", f"{CLAIM}{',0' * 999}", "another product", []),
    ("attains-high-negative", "attains-negative", None, BOUNDS, [("27322/10000", "27321/10000")]),
    # two products
    ("attains-pair-claim", "attains-pair", f"{PAIR} 1", OTHER, [("attains 0", "attains 1")]),
    ("attains-pair-once", "attains-pair", None, "a vertex is the first one of two cycles", [("cycle 1", "cycle 0")]),
]
# weights 3/2 and 1/2: the matrices are not negative
CONE = ("exponent [3,4,1]/4 2 within=1/1000000,1; bounds - -; attains 0 14999/10000 15001/10000; sum-rules 1; stability; "
        "block 0 polytope 1 0 1 nonnegative; vertex 1; unit 0 0:2; image 0 0 0:3; image 0 1 0:1; cycle 0 - 3/2 0; "
        "inverse 0; column 0 0 -1; column 1 1 0; end")
COMPLEX = (CONE.replace("nonnegative; vertex 1; unit 0 0:2; image 0 0 0:3; image 0 1 0:1",
                        "complex; vertex 1 0; unit 0 0:2:0; image 0 0 0:3:0; image 0 1 0:1:0"))
WRITTEN = [("attains-complex", "--mask [3,4,1]/4 --arity 2 --within 1/1000000,1 --attains 0", COMPLEX, "prove nothing"),
           ("attains-cone-rounded", "--mask [3,4,1]/4 --arity 2 --within 1/1000000,1 --attains 0", CONE, "prove nothing")]
