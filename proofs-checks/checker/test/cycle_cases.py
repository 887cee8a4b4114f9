"""Cases of `cycle` in sections `graph`, SPEC.md 4.14: families in which a product attains the radius, with its states."""
import math
from fractions import Fraction as Q

from graph_cases import GOLDEN, decomposed, graph, inverse, multiply, transposed

UNIT = 1 << 20  # coordinates of states are rounded to so many parts


def root_below(x, digits=60):
    return Q(math.isqrt(math.floor(x * 10 ** (2 * digits))), 10**digits)


def modulus_root(square, length):
    """Bounds of |z|^(1/length), by |z|^2."""
    low, high, one = Q(0), max(Q(1), square), Q(2) ** -200
    while high - low > one:
        middle = (low + high) / 2
        low, high = (middle, high) if middle ** (2 * length) <= square else (low, middle)
    return low, high


def decimal(x, digits=80):
    return Q(round(x * 10**digits), 10**digits)


def positive(s):
    """Whether 4.8 shows that a matrix of fractions is positive semidefinite, or 0."""
    den = math.lcm(*(Q(x).denominator for row in s for x in row))
    whole = [[int(x * den) for x in row] for row in s]
    largest = max(abs(x) for row in whole for x in row)
    by = 256 - largest.bit_length()
    return not largest or decomposed([[x << by if by >= 0 else x >> -by for x in row] for row in whole], 128, len(s))


def triangular(rows):
    """A lower triangular integer matrix L, L^T L near the form |rows x|^2 times UNIT^2."""
    d, form = len(rows[0]), [[float(x) for x in row] for row in multiply(transposed(rows), rows)]
    result = [[0] * d for _ in range(d)]
    for i in reversed(range(d)):
        result[i][i] = math.sqrt(form[i][i] - sum(result[k][i] ** 2 for k in range(i + 1, d)))
        for j in range(i):
            result[i][j] = (form[i][j] - sum(result[k][i] * result[k][j] for k in range(i + 1, d))) / result[i][i]
    return [[round(x * UNIT) for x in row[:i + 1]] + [0] * (d - 1 - i) for i, row in enumerate(result)]


class Number:
    """|z|^(1/length), z the zero of a polynomial near a point."""

    def __init__(self, polynomial, point, length, claimed, within="1/10", coarse=None):
        """`coarse`: EPS, and by how much c, LOW and HIGH are off."""
        re, im = map(float, point)
        z = complex(re, im)
        for _ in range(60):  # Newton, in floats and then in fractions
            value = slope = 0
            for c in reversed(polynomial):
                value, slope = value * z + float(c), slope * z + value
            z -= value / slope
        x, y = Q(z.real), Q(z.imag) if im else Q(0)
        for _ in range(5):
            value, slope = (Q(0), Q(0)), (Q(0), Q(0))
            for c in reversed(polynomial):
                slope = (slope[0] * x - slope[1] * y + value[0], slope[0] * y + slope[1] * x + value[1])
                value = (value[0] * x - value[1] * y + c, value[0] * y + value[1] * x)
            size = slope[0] ** 2 + slope[1] ** 2
            x, y = (decimal(x - (value[0] * slope[0] + value[1] * slope[1]) / size),
                    decimal(y - (value[1] * slope[0] - value[0] * slope[1]) / size))
        value = [Q(0), Q(0)]
        for c in reversed(polynomial):
            value = [value[0] * x - value[1] * y + c, value[0] * y + value[1] * x]
        self.polynomial, self.length, self.c = polynomial, length, (x, y)
        self.eps = Q(0) if value == [0, 0] else Q(1, 10**75)
        square = x * x + y * y
        low, high = modulus_root(square, length)
        exact = round(high)
        if self.eps == 0 and exact ** (2 * length) == square:
            self.low = self.high = Q(exact)
        else:
            self.low, self.high = decimal(low - Q(1, 10**50), 52), decimal(high + Q(1, 10**50), 52)
        if coarse:
            self.eps, self.low, self.high = Q(coarse), self.low - 3 * Q(coarse), self.high + 3 * Q(coarse)
            self.c = x + self.eps / 5, y - self.eps / 7 if im else y
        self.text = f"|[{','.join(map(str, polynomial))}]@{claimed},{within}|^1/{length}"

    def lines(self):
        return [f"exact {self.text}", f"root {self.c[0]} {self.c[1]} {self.eps} {self.low} {self.high}"]


class Cycle:
    """One cycle: its states, letters and seed, and the coordinate K."""

    def __init__(self, states, letters, seed, coordinate):
        self.states, self.letters, self.seed, self.coordinate = states, letters, seed, coordinate

    def vectors(self, number, matrices):
        """u_0, ..., u_L, as two rows each, and e_0, ..., e_L."""
        p, (x, y), n = number.polynomial, number.c, len(matrices[0])
        row = [[Q(t) for t in self.seed]]
        basis = [[p[-1] * t for t in row[0]]]
        for k in reversed(range(len(p) - 1)):
            last = [basis[0]]
            for t in self.letters:
                last = multiply(last, matrices[t])
            last = [a + p[k] * b for a, b in zip(last[0], row[0])]
            if k:
                basis.insert(0, last)
            else:
                assert not any(last), "the polynomial does not vanish on the seed"
        m, rows, errors = abs(x) + abs(y) + number.eps, [], []
        for t in [*self.letters, None]:
            re, im = [Q(0)] * n, [Q(0)] * n
            for b in reversed(basis):
                re, im = [s * x - r * y + a for s, r, a in zip(re, im, b)], [s * y + r * x for s, r in zip(re, im)]
            rows.append([re, im])
            errors.append(2 * number.eps * sum(k * m ** (k - 1) * sum(map(abs, b)) for k, b in enumerate(basis) if k))
            basis = basis if t is None else multiply(basis, matrices[t])
        return rows, errors

    def matrices(self, number, matrices, coordinates, bound, kept, scale):
        """The two matrices of each state."""
        rows, errors = self.vectors(number, matrices)
        u = [rows[0][part][self.coordinate] for part in (0, 1)]
        square, size, error = u[0] ** 2 + u[1] ** 2, abs(u[0]) + abs(u[1]), errors[0]
        t1, t2 = square - 2 * size * error, square + 2 * size * error + error**2
        kept, scale, low, high = Q(kept), Q(scale), number.low, number.high
        form = [multiply(transposed(r), r) for r in rows]
        change = [2 * sum(map(abs, r[0] + r[1])) * e for r, e in zip(rows, errors)]
        norms = [multiply(transposed(coordinates[j]), coordinates[j]) for j in self.states]
        n = range(len(form[0]))
        for i, t in enumerate(self.letters):
            image = multiply(coordinates[self.states[i]], matrices[t])
            left, right = multiply(transposed(image), image), norms[(i + 1) % len(norms)]
            f = (1 - kept) * scale**2 / (t2 * high ** (2 * i))
            yield ([[kept * low**2 * right[a][b] + f * (form[i + 1][a][b] - (a == b) * change[i + 1]) - left[a][b] for b in n] for a in n],
                   [[(low / bound) ** 2 * norms[i][a][b] - scale**2 / (t1 * low ** (2 * i)) *
                     (form[i][a][b] + (a == b) * (change[i] + errors[i] ** 2)) for b in n] for a in n])

    def edges(self, number, matrices, coordinates, bound, kept):
        """The least and the largest SCALE with which all matrices are positive, relatively near."""
        def shown(which, scale):
            return all(positive(pair[which]) for pair in self.matrices(number, matrices, coordinates, bound, kept, scale))

        most, above = Q(0), Q(1 << 64)
        while above - most > above / 2**70:
            middle = (most + above) / 2
            most, above = (middle, above) if shown(1, middle) else (most, middle)
        assert shown(0, most)
        below, least = Q(0), most
        while least - below > least / 2**70:
            middle = (below + least) / 2
            below, least = (below, middle) if shown(0, middle) else (middle, least)
        return least, most


def rounded(x, bits=80):
    by = Q(2) ** (bits - int(x).bit_length())
    return round(x * by) / by


def certificate(matrices, number, norms, steps, cycles, kept="1/2", bits=24, bound=None, generators=(), product="", place="middle"):
    """The lines of a certificate for a family of matrices, joined. `norms`: of each state the rows of a matrix S; the kept words
    are those of the cycles; `place`: SCALE is in the middle of those that do, or by a hair within or beyond one of its ends."""
    matrices = [[[Q(x) for x in row] for row in m] for m in matrices]
    bound = bound or decimal(number.low * (1 - Q(1, 10**6)), 12)
    coordinates = [triangular(rows) for rows in norms]
    keeps = {(j, t) for cycle in cycles for j, t in zip(cycle.states, cycle.letters)}
    lines = graph(matrices, bound, bits, coordinates, steps, generators, kept=keeps)
    for cycle in cycles:
        least, most = cycle.edges(number, matrices, coordinates, bound, kept)
        hair = Q(1, 10**17)
        scale = {"middle": rounded((least + most) / 2, 32), "least": rounded(least * (1 + hair)), "most": rounded(most * (1 - hair)),
                 "small": rounded(least * (1 - hair)), "large": rounded(most * (1 + hair))}[place]
        lines += [f"cycle {cycle.states[0]} {cycle.coordinate} {kept} {scale}", "seed " + " ".join(map(str, cycle.seed))]
    return "; ".join([f"radius {len(matrices)} {len(matrices[0])}", "bounds - -", *number.lines(), *([product] if product else []),
                      *lines, "end"])


PHI = (1 + 5**0.5) / 2
NUMBERS, THREE = [[[2]], [[1]]], [[[3]], [[1]]]
THIRDS = [[[Q(x, 3) for x in row] for row in m] for m in GOLDEN]  # radius (1 + sqrt 5)/6, that of the product 0 1
DIAGONAL = [[[2, 0], [0, Q(1, 2)]], [[Q(1, 2), 0], [0, 2]]]
EXCHANGE = [[0, 1], [1, 0]]
ODD = [[1, 1, 0], [0, 1, 2], [0, 0, 1]]  # the rows are the coordinates of TURNS in which the form is diagonal
TURNS = [multiply(multiply(inverse(ODD), m), ODD) for m in ([[1, -3, 0], [2, 1, 0], [0, 0, 1]], [[1, 0, 1], [0, 0, 1], [1, -1, 0]])]
ROTATED = [multiply(multiply(inverse(ODD), m), ODD) for m in ([[3, -4, 0], [4, 3, 0], [0, 0, 1]], [[1, 0, 2], [0, 0, 1], [1, -1, 0]])]
FOUR_POINT = [[[-1, 0], [-1, 4]], [[4, -1], [0, -1]]]
# block triangular: 2 and 1, 3/2 and 1/2
BLOCKS = [[[2, 1], [0, Q(3, 2)]], [[1, 5], [0, Q(1, 2)]]]

# name, rows of its matrices
MATRICES = [("kept-numbers.mat", NUMBERS), ("kept-three.mat", THREE), ("kept-thirds.mat", THIRDS), ("kept-diagonal.mat", DIAGONAL),
            ("kept-turns.mat", TURNS), ("kept-rotated.mat", ROTATED), ("kept-blocks.mat", BLOCKS)]

TWO = Number([-2, 1], (2, 0), 1, "2,0")
ALTERNATING = [[["1", "0"], ["0", "1"]]] * 2  # the first steps are those of the product 0 1 0 1 ...
GOLDEN_NORMS = [[[2 * PHI, 2], [1, -PHI]], [[2, 2 * PHI], [PHI, -1]]]


def numbers(number, l, bound, way, kept, scale, root, matrix=2, second=1, product="", seed=1):
    """A certificate for the matrices of size 1, by hand: the states have the coordinates l, and lead to `way`."""
    lines = graph([[[Q(matrix)]], [[Q(second)]]], bound, 8, [[[l]]] * len(way), [[[str(j)], ["0"]] for j in way], kept={(j, 0) for j in range(len(way))})
    return "; ".join(["radius 2 1", "bounds - -", f"exact {number}", f"root {root}", *lines, f"cycle 0 0 {kept} {scale}", f"seed {seed}", "end"])


def claim(matrices, number):
    return f"--matrices kept-{matrices}.mat --exact {number}"


POINT = "|[-2,1]@2,0,1/10|^1/1"
SQUARE = "|[-4,1]@4,0,1/10|^1/2"
PAIR = "|[6,-5,1]@2,0,1/10|^1/1"  # the other zero is 3
THIRDS_NUMBER = Number([1, -27, 81], (0.29, 0), 2, "3/10,0", "1/20", Q(1, 10**4))
TURNS_NUMBER = Number([7, -2, 1], (1, 6**0.5), 1, "1,49/20", "1/5", Q(1, 10**4))
ROTATED_NUMBER = Number([25, -6, 1], (3, 4), 1, "3,4")


def thirds(place):
    return certificate(THIRDS, THIRDS_NUMBER, GOLDEN_NORMS, ALTERNATING, [Cycle([0, 1], [0, 1], [1, 0], 0)], "9/10", bound=Q(53, 100),
                       place=place)


def turns(place):
    rows = [[2**0.5 * float(x) for x in ODD[0]], [3**0.5 * float(x) for x in ODD[1]], [0, 0, 0.9]]
    return certificate(TURNS, TURNS_NUMBER, [rows], [[["0"], ["0"]]], [Cycle([0], [0], ODD[0], 0)], bound=Q(13, 5), place=place)


ROOT = "2 0 0 2 2"
WIDE = "2 0 0 15/8 17/8"  # LOW and HIGH of r = 2
ACCEPTED = [
    # matrices are 0: both, for a bound that is LOW; only the first; only the second
    ("kept-bound", claim("numbers", POINT), numbers(POINT, 4, 2, [0], 0, 4, ROOT)),
    ("kept-least", claim("numbers", POINT), numbers(POINT, 2048, "1999/1000", [0], "1/2", 2048, ROOT)),
    ("kept-most", claim("numbers", POINT) + " --upper 2", numbers(POINT, 1999, "1999/1000", [0], "1/2", 2000, ROOT)),
    ("kept-two", claim("numbers", SQUARE), numbers(SQUARE, 1999, "1999/1000", [1, 0], "1/2", 2000, "4 0 0 2 2")),
    ("kept-eigenvalue", claim("three", PAIR.replace("2,0", "3,0")), numbers(PAIR.replace("2,0", "3,0"), 2048, "2999/1000", [0], "1/2", 2048, "3 0 0 3 3", 3)),
    ("kept-coarse", claim("numbers", PAIR), numbers(PAIR, 128, "3/2", [0], "1/2", 150, "2049/1024 0 1/256 15/8 17/8")),
    ("kept-coarse-complex", claim("numbers", PAIR), numbers(PAIR, 128, "3/2", [0], "1/2", 150, "2 1/1024 1/256 15/8 17/8")),
    # numbers of which digits are dropped, at the start and on the way
    ("kept-long", claim("numbers", SQUARE), numbers(SQUARE, 1999, "1999/1000", [1, 0], "1/2", "3999/2", "4 0 0 2 2", seed=3**2000)),
    *((f"kept-thirds-{place}", claim("thirds", THIRDS_NUMBER.text), thirds(place)) for place in ("least", "most")),
    *((f"kept-turns-{place}", claim("turns", TURNS_NUMBER.text), turns(place)) for place in ("least", "most")),
    ("kept-diagonal", claim("diagonal", TWO.text), certificate(
        DIAGONAL, TWO, [[[1.5, 0], [0, 1]], [[1, 0], [0, 1.5]]], [[["0"], ["1"]]] * 2, [Cycle([0], [0], [1, 0], 0), Cycle([1], [1], [0, 1], 1)])),
    ("kept-flip", claim("diagonal", TWO.text) + " --lower 2", certificate(
        DIAGONAL, TWO, [[[1.5, 0], [0, 1]]], [[["0"], ["0A"]]], [Cycle([0], [0], [1, 0], 0)], generators=[([1, 0], EXCHANGE)],
        product="product 0 2 0 0")),
    ("kept-rotated", claim("rotated", ROTATED_NUMBER.text), certificate(
        ROTATED, ROTATED_NUMBER, [[*ODD[:2], [0, 0, 0.7]]], [[["0"], ["0"]]], [Cycle([0], [0], ODD[0], 0)])),
    ("kept-blocks", claim("blocks", POINT), numbers(POINT, 2048, "1999/1000", [0], "1/2", 2048, ROOT).replace(
        "radius 2 1", "radius 2 2").replace("block 0", "blocks 1 1; basis 1 0; basis 0 1; inverse 1 0; inverse 0 1; block 0").replace(
        "; end", "; block 1 norm 1; end")),
]
FOUR = Number([-4, 1], (4, 0), 1, "4,0", 1)


def four_point():
    """The scheme of section 4.10, by the exchange of the two letters."""
    lines = certificate(FOUR_POINT, FOUR, [[[-0.6, 3], [1, 0]]], [[["0"], ["0A", "0"]]], [Cycle([0], [0], [-1, 5], 1)], bound=Q(3999, 1000),
                        generators=[([1, 0], EXCHANGE)]).split("; ")
    return "; ".join(["exponent [-1,0,9,16,9,0,-1]/16@-3 2", "bounds - -", lines[2].replace("exact ", "exact 4-log"), lines[3], "sum-rules 4",
                      "stability", *lines[4:]])


ACCEPTED += [("kept-four-point", f"--mask [-1,0,9,16,9,0,-1]/16@-3 --arity 2 --exact 4-log{FOUR.text} --lower 2", four_point())]
# a block of the scheme [-1,1,13,22,13,1,-1]/24
PART = [[[Q(-1, 3), 0], [Q(-1, 3), Q(5, 3)]], [[Q(5, 3), Q(-1, 3)], [0, Q(-1, 3)]]]
FIVE_THIRDS = Number([-5, 3], (5 / 3, 0), 1, "5/3,0")
FIVE_THIRDS.c, FIVE_THIRDS.eps, FIVE_THIRDS.low, FIVE_THIRDS.high = (Q(5, 3), Q(0)), Q(0), Q(5, 3), Q(5, 3)


def blocks_exponent():
    lines = certificate(PART, FIVE_THIRDS, [[[-0.5, 3], [1, 0]]], [[["0"], ["0A", "0"]]], [Cycle([0], [0], [-1, 6], 1)], bound=Q(1666, 1000),
                        generators=[([1, 0], EXCHANGE)]).split("; ")
    return "; ".join([
        "exponent [-1,1,13,22,13,1,-1]/24 2", "bounds - -", lines[2].replace("exact ", "exact 3-log"), lines[3], "sum-rules 3", "stability",
        "blocks 2 1", "basis 1 0 0", "basis -1 1 0", "basis 0 -1 1", "inverse 1 0 0", "inverse 1 1 0", "inverse 1 1 1", *lines[4:-1],
        "block 1 graph 1 3/2 8", "coordinates 1", "step 0 0 172 171", "tree 0", "logarithm 0", "end"])


ACCEPTED += [("kept-blocks-exponent", f"--mask [-1,1,13,22,13,1,-1]/24 --arity 2 --exact 3-log{FIVE_THIRDS.text} --logarithm 0", blocks_exponent())]
LONE = Number([-2, 1], (2, 0), 1, "2,0")
MATRICES.append(("kept-lone.mat", DIAGONAL[:1]))
ACCEPTED.append(("kept-lone", claim("lone", LONE.text), certificate(
    DIAGONAL[:1], LONE, [[[1, 0], [0, 1]]], [[["0"]]], [Cycle([0], [0], [1, 0], 0)], bits=8, bound=Q(199, 100))))
# a state more, from which words lead away
AWAY = ("graph 1 1999/1000 8\n", "graph 2 1999/1000 8\n"), ("tree *0\n", "tree *0\ncoordinates 1\nstep 0 0 1 0\nstep 1 0 1 0\ntree 00\n")

# name, accepted case that is changed, other options or None, changes of its text
CHANGED = [
    ("kept-away", "kept-least", None, AWAY),
    ("kept-conjugate", "kept-rotated", claim("rotated", "|[25,-6,1]@3,-4,1/10|^1/1"), [("@3,4", "@3,-4"), ("root 3 4 ", "root 3 -4 ")]),
]

ZERO, BELOW, RADIUS = "may be zero at its coordinate", "does not bound the eigenvector", "a kept word is not that of the radius"
OTHER, MEETS, NO_WORD = "does not vanish on the seed", "too long, or meets one that came before", "a state without a kept word"
SINGLE = ("exact |[-2,1]@2,0,1/10|^1/1\nroot 2 0 0 2 2\n", "exact |[-4,1]@4,0,1/10|^1/2\nroot 4 0 0 2 2\n")
DOUBLE = tuple(reversed(SINGLE))
CYCLE = "cycle 0 0 1/2 2048\n"  # of kept-least
NEAR = "|[34,-33,8]@2,0,1/20|^1/1"
HALF = "|[-1,2]@1/2,0,1/10|^1/1"

# name, accepted case that is changed, other options or None, reason, changes of its text
REJECTED = [
    ("kept-not-exact", "kept-least", "--matrices kept-numbers.mat --upper 2", "none of 0-9, A-Z, a-z", [(SINGLE[0], "")]),
    ("kept-cycle-not-exact", "one-graph", None, "expected 'end'", [("tree 0\n", "tree 0\ncycle 0 0 1/2 1\nseed 1\n")]),
    ("kept-later", "kept-least", None, "a kept word has more than one letter", [("tree *0", "tree +*00")]),
    ("kept-turned", "kept-flip", None, "the step of a kept word has a word of the group", [("tree *0", "tree **")]),
    ("kept-turned-back", "kept-flip", None, "the step of a kept word has a word of the group", [("step 0 0 ", "step 0 0AA ")]),
    ("kept-twice", "kept-least", None, "a state has two kept words", [("tree *0", "tree **")]),
    ("kept-no-cycle", "kept-least", None, "a kept word is on no cycle", [(f"{CYCLE}seed 1\n", "")]),
    ("kept-no-second-cycle", "kept-diagonal", None, "a kept word is on no cycle", [("cycle 1 1 1/2 3221227083/2048\nseed 0 1\n", "")]),
    ("kept-from-away", "kept-least", None, NO_WORD, [*AWAY, (CYCLE, "cycle 1 0 1/2 2048\n")]),
    ("kept-leads-away", "kept-two", None, NO_WORD, [
        ("step 0 1 259 256", "step 0 1 515 512"), ("coordinates 1999\nstep 0 0 259 256\nstep 1 0 131 128\ntree *0\n",
                                                   "coordinates 1000\nstep 0 0 131 128\nstep 1 0 67 64\ntree 00\n")]),
    ("kept-short", "kept-least", claim("numbers", SQUARE), "a cycle is too short", [SINGLE]),
    ("kept-too-long", "kept-two", claim("numbers", POINT), MEETS, [DOUBLE]),
    ("kept-not-back", "kept-two", None, MEETS, [("step 0 0 259 256", "step 0 1 259 256")]),
    ("kept-same-cycle", "kept-least", None, MEETS, [(CYCLE, f"{CYCLE}seed 1\n{CYCLE}")]),
    ("kept-above", "kept-least", None, "the bound of a graph with cycles is above", [("1999/1000", "2001/1000")]),
    ("kept-above-low", "kept-least", None, "the bound of a graph with cycles is above", [("root 2 0 0 2 2", "root 2 0 0 1998/1000 2")]),
    *((f"kept-{name}", "kept-least", None, reason, [(CYCLE, f"cycle {words}\n")]) for name, words, reason in (
        ("few", "0 0 1/2", "wrong number of fields"), ("many", "0 0 1/2 2048 1", "wrong number of fields"),
        ("state-high", "1 0 1/2 2048", "number outside 0..0"), ("coordinate-high", "0 1 1/2 2048", "number outside 0..0"),
        ("part-1", "0 0 1 2048", "the kept part of a norm is not from 0 to 1"), ("part-negative", "0 0 -1/1000 2048", "is not from 0 to 1"),
        ("part-none", "0 0 - 2048", "not an integer"), ("scale-0", "0 0 1/2 0", "the scale of a cycle is not positive"),
        ("scale-negative", "0 0 1/2 -2048", "the scale of a cycle is not positive"), ("scale-none", "0 0 1/2 ", "not an integer"),
        ("scale-small", "0 0 1/2 20479999999999999999/10000000000000000", RADIUS), ("scale-large", "0 0 1/2 2050", BELOW))),
    ("kept-scale-high", "kept-most", None, BELOW, [("cycle 0 0 1/2 2000", "cycle 0 0 1/2 20000000000000001/10000000000000")]),
    ("kept-bound-large", "kept-bound", None, BELOW, [("cycle 0 0 0 4", "cycle 0 0 0 40000000000000001/10000000000000000")]),
    ("kept-seed-missing", "kept-least", None, "expected 'seed'", [("seed 1\n", "")]),
    ("kept-seed-long", "kept-least", None, "wrong number of fields", [("seed 1\n", "seed 1 0\n")]),
    ("kept-seed-zero", "kept-least", None, ZERO, [("seed 1\n", "seed 0\n")]),
    ("kept-seed-other", "kept-rotated", None, OTHER, [("seed 1 1 0", "seed 1 1 1")]),
    ("kept-seed-both", "kept-diagonal", None, OTHER, [("seed 1 0\n", "seed 1 1\n")]),
    ("kept-seed-letter", "kept-diagonal", None, OTHER, [("seed 0 1\n", "seed 1 0\n")]),
    ("kept-coordinate-zero", "kept-diagonal", None, ZERO, [("cycle 0 0", "cycle 0 1")]),
    # U is -1 and known up to 1
    ("kept-coarse-zero", "kept-coarse", claim("numbers", NEAR), ZERO, [(f"exact {PAIR}\nroot 2049/1024 0 1/256", f"exact {NEAR}\nroot 2 0 1/32")]),
    # U = 0: 2 is no eigenvalue, the polynomial has another zero that is one
    ("kept-cancelled", "kept-eigenvalue", claim("three", PAIR), ZERO, [
        (f"exact {PAIR.replace('2,0', '3,0')}\nroot 3 0 0 3 3", f"exact {PAIR}\nroot {ROOT}"), ("2999/1000", "1999/1000"),
        ("step 0 0 259 256", "step 0 0 387 384"), ("step 1 0 88 85", "step 1 0 131 128")]),
    # an eigenvalue that is not the largest one
    ("kept-smaller", "kept-lone", claim("lone", HALF), RADIUS, [
        (f"exact {LONE.text}\nroot {ROOT}", f"exact {HALF}\nroot 1/2 0 0 1/2 1/2"), ("graph 1 199/100", "graph 1 49/100"),
        ("step 0 0 260 257 0 0 64", "step 0 0 1048 1045 0 0 261"), ("cycle 0 0", "cycle 0 1"), ("seed 1 0", "seed 0 1")]),
    ("kept-root-conjugate", "kept-rotated", None, "not the one of the claim", [("root 3 4 ", "root 3 -4 ")]),
    ("kept-claim-bound", "kept-least", claim("numbers", POINT) + " --upper 1999/1000", "the bound does not prove the claim", []),
    ("kept-block-above", "kept-blocks", None, "the bound of a block is above the exact radius", [
        ("block 1 norm 1\n", "block 1 graph 1 2001/1000 8\ncoordinates 1\nstep 0 0 195 192\nstep 1 0 67 64\ntree 00\n")]),
    ("kept-none", "kept-least", claim("numbers", "|[-5,2]@5/2,0,1/10|^1/1"), "no block attains the exact radius", [
        (f"exact {POINT}\nroot {ROOT}", "exact |[-5,2]@5/2,0,1/10|^1/1\nroot 5/2 0 0 5/2 5/2"), ("graph 1 1999/1000", "graph 1 9/4"),
        ("step 0 0 259 256", "step 0 0 231 228"), ("step 1 0 131 128", "step 1 0 117 114"), ("tree *0", "tree 00"), (f"{CYCLE}seed 1\n", "")]),
    *((f"kept-{name}-{place}", f"kept-{name}-{base}", None, reason, [(of(base).split("; ")[-3], of(place).split("; ")[-3])])
      for name, of in (("thirds", thirds), ("turns", turns)) for base, place, reason in (("least", "small", RADIUS), ("most", "large", BELOW))),
]
