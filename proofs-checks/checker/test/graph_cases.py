"""Cases of sections `graph`, SPEC.md 4.13, and of sections `quadratic` with many letters; the sections of graphs are made here."""
import math
from fractions import Fraction as Q

GOLDEN = [[[1, 1], [0, 1]], [[1, 0], [1, 1]]]
TURN, EXCHANGE = [[0, -1], [1, 0]], [[0, 1], [1, 0]]
# shears under the rotation by a right angle, whose square is -1, and the exchange of the coordinates: radius (1 + sqrt 5)/2
SHEARS = [[[1, 1], [0, 1]], [[1, 0], [-1, 1]], [[1, 0], [1, 1]], [[1, -1], [0, 1]]]
TURNS = [TURN, [[Q(3, 5), Q(-4, 5)], [Q(4, 5), Q(3, 5)]]]
COLUMNS = [[[int(t == j) for j in range(3)] for _ in range(3)] for t in range(3)]  # (1, 1, 1)^T e_t^T: radius 1
ONE = [[[1]]]
# matrices over 256, NORM and ENDS with 8 bits, and whether they are accepted then: by a hair
NEAR = {
    "root": ([[-171, 119], [61, -144]], 256, "0", False),
    "quotient": ([[-86, -137], [110, 157]], 256, "0", False),
    "quotient-true": ([[70, -153], [0, 194]], 256, "0", True),
    "pivot": ([[150, 0, 0], [144, 0, 0], [136, 0, 0]], 256, "0", False),  # the first one is 0
    "product": ([[-79, -77, 45, -154, -10, -151], [74, 14, 91, -34, 27, -19], [-50, 10, -84, -24, 47, 4],
                 [-28, 147, 4, -39, 11, -35], [-26, -24, 136, 2, 12, 45], [135, -15, -42, 166, -98, -25]], 442, "+0", False),
    "product-true": ([[50, 172, -72, -183, 50, -39], [-29, 35, 17, 22, -33, 97], [113, 2, -34, 55, 36, -78],
                      [-35, 79, -7, -25, 16, -3], [0, -146, 132, 15, -66, 74], [23, 1, 79, 170, 42, 119]], 471, "+0", True),
}
LETTERS = 257
ENDS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"


def multiply(a, b):
    return [[sum(x * y for x, y in zip(row, column)) for column in zip(*b)] for row in a]


def transposed(a):
    return [list(row) for row in zip(*a)]


def inverse(matrix):
    n = len(matrix)
    m = [[*map(Q, row), *(Q(i == k) for k in range(n))] for i, row in enumerate(matrix)]
    for c in range(n):
        pivot = next(i for i in range(c, n) if m[i][c] != 0)
        m[c], m[pivot] = m[pivot], m[c]
        m[c] = [x / m[c][c] for x in m[c]]
        m = [row if i == c else [x - row[c] * y for x, y in zip(row, m[c])] for i, row in enumerate(m)]
    return [row[n:] for row in m]


def decomposed(u, h, m):
    """Lemma 17."""
    x, d = [row[:] for row in u], len(u)
    for k in range(d):
        x[k] = [x[k][j] - (k == j) * ((d << h) + m) - sum(x[l][k] * x[l][j] for l in range(k)) for j in range(d)]
        if x[k][k] <= 0:
            return False
        x[k][k] = math.isqrt(x[k][k])
        x[k][k + 1:] = [y // x[k][k] for y in x[k][k + 1:]]
    return True


def least_less_gram(number, b):
    """number^2 1 - b^T b."""
    return [[number**2 * (i == j) - x for j, x in enumerate(row)] for i, row in enumerate(multiply(transposed(b), b))]


def least_norm(b):
    """The least NORM that is shown by a definite matrix."""
    low, high = 0, 1 << max(abs(x) for row in b for x in row).bit_length() + len(b)
    while high - low > 1:
        middle = (low + high) // 2
        s = least_less_gram(middle, b)
        by = 256 - max(abs(x) for row in s for x in row).bit_length()
        shifted = [[x << by if by >= 0 else x >> -by for x in row] for row in s]
        low, high = (low, middle) if decomposed(shifted, 128, len(b)) else (middle, high)
    return high


def tree_of(state, steps, bits, kept=()):
    """The characters ENDS: words end as soon as one of the steps allows it. `kept`: numbers of letters."""
    unit, d = 1 << bits, len(steps[0][0][0][1])

    def ends(m, c):
        u = least_less_gram(c, m)
        return c > 0 and min(u[k][k] for k in range(d)) > 0 and decomposed(u, bits, 0)

    def characters(j, m, p, e):
        result = ""
        for letter, edges in enumerate(steps[j]):
            if e == 0 and letter in kept:
                result += "*"
                continue
            led = [(to, [[x >> bits for x in row] for row in multiply(m, b)], -(-p * (norm + d) // unit),
                    d - (-(e * norm + p * d) // unit)) for to, b, norm in edges]
            number = next((k for k, (_, m2, _, e2) in enumerate(led) if ends(m2, unit - e2)), None)
            result += "+" + characters(*led[0]) if number is None else ENDS[number]
        return result

    return characters(state, [[unit * (i == j) for j in range(d)] for i in range(d)], unit, 0)


def graph(matrices, bound, bits, coordinates, steps, generators=(), trees=None, norms=None, kept=()):
    """The lines of a section. `steps`: by state and letter the list of TO[WORD]; generators are letters and maps; `kept`: states and
    letters of kept words."""
    table, lines = [], [f"block 0 graph {len(coordinates)} {bound} {bits}" + (f" group:{len(generators)}" if generators else "")]
    for letters, rows in generators:
        lines += ["generator " + " ".join(map(str, letters)), *("map " + " ".join(map(str, row)) for row in rows)]
    letters = [t for t, m in enumerate(matrices) if matrices.index(m) == t]
    for j, by_letter in enumerate(steps):
        table.append([])
        for t, targets in zip(letters, by_letter):
            table[j].append([])
            for target in targets:
                digits = target.rstrip("ABCDEFGH")
                other = coordinates[int(digits)]
                for letter in target[len(digits):]:
                    other = multiply(other, generators[ord(letter) - ord("A")][1])
                b = multiply(multiply(coordinates[j], matrices[t]), inverse(other))
                b = [[math.floor(x * (1 << bits) / Q(bound) + Q(1, 2)) for x in row] for row in b]
                table[j][-1].append((int(digits), b, least_norm(b) + 2))
    for j, rows in enumerate(coordinates):
        lines += ["coordinates " + " ".join(map(str, row[:i + 1])) for i, row in enumerate(rows)]
        for t, targets, edges in zip(letters, steps[j], table[j]):
            lines += [f"step {t} {target} {norms or norm} " + " ".join(str(x) for row in b for x in row)
                      for target, (_, b, norm) in zip(targets, edges)]
        lines.append("tree " + (trees[j] if trees else tree_of(j, table, bits, {k for k, t in enumerate(letters) if (j, t) in kept})))
    return lines


def radius(matrices, lower, upper, product, *section, **more):
    """A certificate of a radius, its lines joined."""
    return "; ".join([f"radius {len(matrices)} {len(matrices[0])}", f"bounds {lower} {upper}", *([product] if product else []),
                      *graph(matrices, upper, *section, **more), "end"])


def letters_under(matrices, g):
    return [matrices.index(multiply(multiply(inverse(g), m), g)) for m in matrices]


NEAR_FAMILIES = {name: [[[Q(x, 256) for x in row] for row in rows]] for name, (rows, *_) in NEAR.items()}


def near(name, bits):
    """The section for a bound 1."""
    rows, norm, ends, _ = NEAR[name]
    unit = [[int(i == j) for j in range(len(rows))] for i in range(len(rows))]
    return graph(NEAR_FAMILIES[name], 1, bits, [unit], [[["0"]]], trees=[ends], norms=norm << bits - 8)


# name, rows of its matrices
MATRICES = [
    ("shears.mat", SHEARS),
    ("columns.mat", COLUMNS),
    ("turns.mat", TURNS),
    *((f"near-{name}.mat", family) for name, family in NEAR_FAMILIES.items()),
    ("unit.mat", [[[int(i == j) for j in range(3)] for i in range(3)]]),
    ("letters.mat", [[[f"{t}/{LETTERS}"]] for t in range(1, LETTERS + 1)]),
]
LAST_LETTER = [[["0"], ["1"]]] * 2  # the states are the last letters
GOLDEN_L = [[[184, 0], [524, 1049]], [[368, 0], [1049, 589]]]
PHI = "product 0 2618034/1000000 0 0 1"
WITH_GOLDEN = "--matrices golden.mat --lower 1618/1000 --upper 17/10"
SHEAR_MAPS = [(letters_under(SHEARS, g), g) for g in (TURN, EXCHANGE)]
COLUMN_MAPS = [([1, 0, 2], [[0, 1, 0], [1, 0, 0], [0, 0, 1]]), ([0, 2, 1], [[1, 0, 0], [0, 0, 1], [0, 1, 0]])]

FOUR_POINT = [[[-1, 0], [-1, 4]], [[4, -1], [0, -1]]]  # the family of 4.1
ONES = "--matrices one.mat --upper 2"
UNIT = [[1, 0], [0, 1]]


def one(bits, coordinates, *steps, trees=None, norms=None):
    """A certificate for the matrix 1 and the bound 2; `steps`: of each state."""
    return radius(ONE, "-", 2, "", bits, [[[x]] for x in coordinates], [[list(targets)] for targets in steps], trees=trees, norms=norms)


# name, options of the claim, and the lines after the first one
ACCEPTED = [
    *((f"golden-graph{name}", WITH_GOLDEN, radius(GOLDEN, "1618/1000", "17/10", PHI, bits, GOLDEN_L, LAST_LETTER))
      for name, bits in (("", 16), ("-24", 24), ("-25", 25))),
    ("twice-graph", WITH_GOLDEN.replace("golden", "twice"),
     radius([*GOLDEN, GOLDEN[0]], "1618/1000", "17/10", PHI, 20, GOLDEN_L, LAST_LETTER)),
    # one state; words end by other steps than the first, and AA is -1
    *((f"shears-graph{name}", "--matrices shears.mat --lower 1618/1000 --upper 17/10",
       radius(SHEARS, "1618/1000", "17/10", "product 0 2618034/1000000 0 0 2", bits, [[[10, 0], [3, 8]]],
              [[["0", "0B"], ["0AA"], ["0", "0AA", "0"], ["0", "0B", "0AB"]]], SHEAR_MAPS, trees=trees))
      for name, bits, trees in (("", 24, None), ("-30", 30, None), ("-ends", 24, ["1012"]))),
    ("columns-graph", "--matrices columns.mat --lower 1 --upper 11/10",
     radius(COLUMNS, 1, "11/10", "product 0 1 0 0", 20, [[[4, 0, 0], [0, 1, 0], [0, 0, 1]]],
            [[["0"], ["0", "0A"], ["0", "0BA", "0AB"]]], COLUMN_MAPS)),
    ("turns-graph", "--matrices turns.mat --lower 1 --upper 2",
     radius(TURNS, 1, 2, "product 0 0 1 0", 8, [UNIT], [[["0"], ["0"]]], norms=129)),
    ("four-point-graph", "--mask [-1,0,9,16,9,0,-1]/16@-3 --arity 2 --lower 195/100",
     "; ".join(["exponent [-1,0,9,16,9,0,-1]/16@-3 2; bounds 195/100 -; sum-rules 4",
                *graph(FOUR_POINT, "4131/1000", 20, [UNIT], [[["0"], ["0A"]]], [([1, 0], EXCHANGE)]), "end"])),
    ("zero-graph", "--matrices zero.mat --upper 1/10",
     "radius 1 1; bounds - 1/10; block 0 graph 1 1/10 8; coordinates -3; step 0 0 1 0; tree 0; end"),
    ("one-graph", ONES, one(8, [1], ["0"])),
    ("one-graph-1000", ONES, one(1000, [3], ["0"])),
    ("one-graph-long", ONES, one(24, [1], ["0"], trees=[f"{999 * '+'}0"])),
    ("one-graph-62", ONES, one(8, [6, 1], [*61 * ["1"], "0"], ["0"], trees=["z", "0"])),
    # |B| = 3 U, and p + e = 4 U where the word goes on
    ("one-graph-high", ONES, one(8, [6, 1], ["1"], ["0"], trees=["+0", "0"]).replace("step 0 1 771", "step 0 1 1021")),
    # e grows
    ("one-graph-error", ONES, one(8, [1, 1], ["1"], ["1"], trees=[f"{50 * '+'}0", "0"]).replace("step 0 1 131", "step 0 1 499", 1).replace(
        "step 0 1 131", "step 0 1 255")),
    *((f"near-{name}-graph", f"--matrices near-{name}.mat --upper 1",
       "; ".join([f"radius 1 {len(rows)}; bounds - 1", *near(name, 8 if accepted else 24), "end"]))
      for name, (rows, _, _, accepted) in NEAR.items()),
    ("near-product-graph-30", "--matrices near-product.mat --upper 1", "; ".join(["radius 1 6; bounds - 1", *near("product", 30), "end"])),
    # a form in which R_12 depends on R_01 and R_02
    ("unit-quadratic", "--matrices unit.mat --upper 2",
     "radius 1 3; bounds - 2; block 0 quadratic 1 2; form 100; form 90 100; form 0 30 100; word 0; end"),
    # more letters than a byte holds
    ("letters", "--matrices letters.mat --lower 1 --upper 1",
     f"radius {LETTERS} 1; bounds 1 1; product 0 1 0 {LETTERS - 1}; block 0 quadratic {LETTERS} 1; form 1; "
     f"{'; '.join(f'word {t}' for t in range(LETTERS))}; end"),
]

# name, accepted case that is changed, other options or None, changes of its text
CHANGED = [
    # the largest error of B that is accepted, the least norm, the largest one
    ("one-graph-far", "one-graph", None, [("131 128\n", "129 129\n")]),
    ("one-graph-far-below", "one-graph", None, [("131 128\n", "128 127\n")]),
    ("one-graph-norm", "one-graph", None, [("131 128\n", "1792 128\n")]),
    ("turns-graph-close", "turns-graph", None, [
        ("graph 1 2 8\n", "graph 1 128/125 8\n"), ("0 129 0 -128 128 0\n", "0 250 0 -250 250 0\n"),
        ("0 129 77 -102 102 77\n", "0 251 150 -200 200 150\n")]),
    ("turns-graph-norm", "turns-graph", None, [("step 0 0 129 ", "step 0 0 128 ")]),
    ("zero-graph-negative", "zero-graph", None, [("0 0 1 0\n", "0 0 1 -1\n"), ("8\ncoordinates -3\n", "10\ncoordinates -1\n")]),
    ("golden-graph-more", "golden-graph", None, [("+++000+00++++00+0000", "+++0+000+00++++00++00000")]),
    ("columns-graph-word", "columns-graph", None, [("step 0 0 ", f"step 0 0{16 * 'A'} ")]),
    ("blocks-graph", "blocks", None, [("block 1 norm 3\n", "block 1 graph 1 8/5 12\ncoordinates 1\nstep 0 0 3841 3840\nstep 1 0 2561 -2560\ntree 00\n")]),
]

FIRST_LINE = "expected 'graph', a number of states, a bound, a number of bits and perhaps a group"
SMALL, FAR, ABOVE = "the norm of a step is larger than it says", "not near the one that it stands for", "is not below the bound"
FEWER, MORE, NO_STEP = "a tree has fewer characters", "a tree has more characters", "a step that is not there"
NUMBERS = "the norm of a step is not from 1 to 7 2^BITS"
STEP = "step 0 0 80148 19294 6762 -54840 57808\n"  # the first one of golden-graph
HUGE = 300 * "9"

# name, accepted case that is changed, other options or None, reason, changes of its text
REJECTED = [
    *((f"graph-{name}", "golden-graph", None, reason, [("graph 2 17/10 16\n", f"graph {words}\n")]) for name, words, reason in (
        ("no-bits", "2 17/10", FIRST_LINE), ("group-0", "2 17/10 16 group:0", "number outside 1..8"),
        ("group-none", "2 17/10 16 group:", "not an integer"), ("property", "2 17/10 16 symmetric", FIRST_LINE),
        ("group-twice", "2 17/10 16 group:1 group:1", FIRST_LINE), ("states-0", "0 17/10 16", "number outside 1..4096"),
        ("states-4097", "4097 17/10 16", "number outside 1..4096"), ("bits-7", "2 17/10 7", "number outside 8..1000"),
        ("bits-1001", "2 17/10 1001", "number outside 8..1000"), ("bits-no-integer", "2 17/10 16.0", "not an integer"),
        ("bound-0", "2 0 16", "the bound of a graph is not positive"), ("bound-negative", "2 -17/10 16", "the bound of a graph is not positive"),
        ("bound-low", "2 1699/1000 16", FAR), ("bound-high", "2 1701/1000 16", FAR), ("bits-other", "2 17/10 17", FAR),
        ("states-more", "3 17/10 16", "expected 'coordinates'"), ("states-fewer", "1 17/10 16", "number outside 0..0"))),
    *((f"graph-coordinates-{name}", "golden-graph", None, reason, [("coordinates 524 1049\n", words)]) for name, words, reason in (
        ("missing", "", "expected 'coordinates'"), ("few", "coordinates 524\n", "wrong number of fields"),
        ("many", "coordinates 524 1049 0\n", "wrong number of fields"), ("singular", "coordinates 524 0\n", "have a 0 on the diagonal"),
        ("rational", "coordinates 524 1/2\n", "not an integer"), ("other", "coordinates 525 1049\n", FAR))),
    ("graph-coordinates-zero", "golden-graph", None, "have a 0 on the diagonal", [("coordinates 184\n", "coordinates 0\n")]),
    *((f"graph-step-{name}", "golden-graph", None, reason, [(STEP, words)]) for name, words, reason in (
        ("missing", "", "expected 'step 0'"), ("letter", STEP.replace("0", "1", 1), "expected 'step 0'"),
        ("few", STEP.replace(" 6762", ""), "wrong number of fields"), ("many", STEP.replace(" 6762", " 6762 0"), "wrong number of fields"),
        ("empty", "step 0\n", "wrong number of fields"), ("second-empty", STEP + "step 0\n", "wrong number of fields"),
        ("to-high", STEP.replace(" 0 0 ", " 0 2 "), "number outside 0..1"), ("to-negative", STEP.replace(" 0 0 ", " 0 -1 "), "not an integer"),
        ("to-none", STEP.replace(" 0 0 ", " 0 A "), "not an integer"), ("no-group", STEP.replace(" 0 0 ", " 0 0A "), "unknown generator"),
        ("to-other", STEP.replace(" 0 0 ", " 0 1 "), FAR), ("norm-0", STEP.replace("80148", "0"), NUMBERS),
        ("norm-negative", STEP.replace("80148", "-80148"), NUMBERS), ("norm-high", STEP.replace("80148", str(7 * 2**16 + 1)), NUMBERS),
        ("norm-rational", STEP.replace("80148", "80148/1"), "not an integer"), ("norm-small", STEP.replace("80148", "80145"), SMALL),
        ("norm-column", STEP.replace("80148", "58000"), SMALL), ("norm-entry", STEP.replace("80148", "57807"), SMALL),
        ("matrix-above", STEP.replace(" 6762", " 6765"), FAR), ("matrix-below", STEP.replace(" 6762", " 6759"), FAR),
        ("matrix-negated", STEP.replace("19294 6762", "-19294 -6762"), FAR), ("matrix-transposed", STEP.replace("6762 -54840", "-54840 6762"), FAR),
        ("matrix-rational", STEP.replace(" 6762", " 6762/1"), "not an integer"), ("matrix-minus-zero", STEP.replace(" 6762", " -0"), "not an integer"),
        ("matrix-exponent", STEP.replace(" 6762", " 1e3"), "not an integer"), ("matrix-infinite", STEP.replace(" 6762", " inf"), "not an integer"),
        ("matrix-huge", STEP.replace(" 6762", f" {HUGE}"), SMALL), ("matrix-huge-negative", STEP.replace(" 6762", f" -{HUGE}"), SMALL),
        # numbers that doubles do not hold
        ("huge", STEP.replace("80148", HUGE).replace(" 6762", f" {HUGE}"), NUMBERS),
        ("wrapped", STEP.replace(" 6762", f" {2**64 + 6762}"), SMALL), ("second-far", STEP + STEP.replace("6762", "6765"), FAR))),
    ("graph-step-order", "golden-graph", None, "expected 'step 0'", [(STEP, ""), ("step 1 1 75744 19275 0 -30930 68658\n",
                                                                       f"step 1 1 75744 19275 0 -30930 68658\n{STEP}")]),
    ("graph-equal-letters", "twice-graph", None, "expected 'tree'", [("tree", "step 2 0 1282330 308699 108192 -877446 924920\ntree")]),
    *((f"graph-tree-{name}", "golden-graph", None, reason, [("tree +++000+00++++00+0000\n", words)]) for name, words, reason in (
        ("missing", "", "expected 'tree'"), ("empty", "tree \n", FEWER), ("two", "tree + ++000+00++++00+0000\n", "wrong number of fields"),
        ("short", "tree +++000+00++++00+000\n", FEWER), ("long", "tree +++000+00++++00+00000\n", MORE), ("only-on", "tree +\n", FEWER),
        ("early", "tree ++00+00++++00+0000\n", ABOVE), ("step", "tree +++000+00++++00+0001\n", NO_STEP),
        *((f"character-{ord(c)}", f"tree +++000+00++++00+000{c}\n", "none of 0-9, A-Z, a-z") for c in "*,-/:@[`{"),
        *((f"character-{ord(c)}", f"tree +++000+00++++00+000{c}\n", NO_STEP) for c in "9AZaz"))),
    ("graph-tree-step-62", "one-graph-62", None, NO_STEP, [("step 0 0 131 128\n", "")]),
    ("graph-tree-step-61", "one-graph-62", None, ABOVE, [("tree z", "tree y")]),
    ("graph-word-1001", "one-graph-long", None, "a word of more than 1000 letters", [("tree +", "tree ++")]),
    ("graph-words-endless", "one-graph-long", None, "a word of more than 1000 letters", [("+0\n", f"+{1000 * '+'}\n")]),
    ("graph-too-large", "one-graph-high", None, "a word that goes on is too large", [("1021", "1022")]),
    # c < 0: c^2 is large enough
    ("graph-error-large", "one-graph-error", None, ABOVE, [("+0\n", f"+{150 * '+'}0\n")]),
    ("graph-one-far", "one-graph", None, FAR, [("131 128\n", "130 130\n")]),
    ("graph-one-far-below", "one-graph", None, FAR, [("131 128\n", "128 126\n")]),
    ("graph-one-norm-high", "one-graph", None, NUMBERS, [("131 128\n", "1793 128\n")]),
    ("graph-turns-norm", "turns-graph", None, SMALL, [("step 0 0 129 ", "step 0 0 127 ")]),
    *((f"graph-near-{name}", f"near-{name}-graph", None, ABOVE, [
        ("\n".join(near(name, 24)), "\n".join(near(name, 8)))]) for name, (*_, accepted) in NEAR.items() if not accepted),
    # c^2 - |M'|^2 is positive, but less than d U
    ("graph-margin", "turns-graph", None, ABOVE, [
        ("graph 1 2 8\n", "graph 1 256/251 8\n"), ("0 129 0 -128 128 0\n", "0 252 0 -251 251 0\n"),
        ("0 129 77 -102 102 77\n", "0 252 151 -201 201 151\n")]),
    # products of isometries are never below 1
    ("graph-isometries", "turns-graph", "--matrices turns.mat --upper 1", ABOVE, [
        ("graph 1 2 8\n", "graph 1 1 8\n"), ("0 129 0 -128 128 0\n", "0 256 0 -256 256 0\n"),
        ("0 129 77 -102 102 77\n", "0 257 154 -205 205 154\n")]),
    *((f"graph-turn-{name}", "shears-graph", None, reason, [("step 1 0AA 1", f"step 1 {to} 1")]) for name, to, reason in (
        ("unknown", "0AC", "unknown generator"), ("low", "0A@", "unknown generator"), ("small", "0aa", "unknown generator"),
        ("flip", "0f", "unknown generator"), ("alone", "AA", "not an integer"), ("minus", "0", FAR), ("first", "0A", FAR), ("other", "0BA", FAR),
        ("long", f"0{17 * 'A'}", "more than 16 generators"), ("opposite", "0AAAA", FAR))),
    ("graph-turn-order", "columns-graph", None, FAR, [("step 2 0AB ", "step 2 0BA ")]),
    ("graph-group-other", "shears-graph", None, "does not permute the matrices", [("generator 1 0 3 2", "generator 0 1 3 2")]),
    ("graph-group-unannounced", "shears-graph", None, "expected 'coordinates'", [(" group:2", "")]),
    ("graph-claim", "golden-graph", "--matrices golden.mat --upper 16999/10000", "does not prove the claim", []),
    ("graph-other-matrices", "golden-graph", "--matrices rotation.mat --lower 1 --upper 17/10", "no positive", []),
    ("graph-rounded", "rounded-hat", None, "expected 'norm', 'polytope', 'quadratic', 'graph' or 'single'", [
        ("block 0 norm 1\n", "block 0 graph 1 2 8\ncoordinates 1\nstep 0 0 131 128\ntree 0\n")]),
    ("quadratic-no-bound", "golden-quadratic", None, "expected 'quadratic', a number of words, a bound and perhaps a group",
     [("quadratic 3 16181/10000", "quadratic 3")]),
    ("letters-incomplete", "letters", None, "not those of a complete tree",
     [(f"quadratic {LETTERS}", f"quadratic {LETTERS - 1}"), (f"word {LETTERS - 1}\n", "")]),
]
