"""Writes the lines of a certificate from `vertex` on (5.11), for rules around a vertex as they stand in a claim. Floating point
and rounded fractions: what is written need not be right."""
import cmath
import math
from fractions import Fraction

BITS, XBITS, IBITS = 128, 64, 24


def polynomial(text):
    """A sum of terms c, w*c^k: the coefficients by powers of c."""
    result = {}
    for term in text.replace("-", "+-").lstrip("+").split("+"):
        factor, _, power = term.partition("c")
        factor = factor.rstrip("*")
        k = 0 if "c" not in term else int(power[1:]) if power else 1
        value = Fraction(-1 if factor == "-" else 1) if factor in ("", "-") else Fraction(factor)
        result[k] = result.get(k, 0) + value
    return result


class Rules:
    def __init__(self, mask, arity, text):
        parts = text.split(";")
        self.lattice, valence = parts[0].split(":")
        self.n, self.arity, self.mask, self.own = int(valence), arity, mask, {}
        for part in parts[1:]:
            point, _, terms = part.partition("=")
            self.own[tuple(map(int, point.split(",")))] = [self.term(term) for term in terms.split("|")]

    @staticmethod
    def term(text):
        weight, _, place = text.partition("@")
        if "~" in place:
            point, frequency = place.split("~")
            return tuple(map(int, point.split(","))), int(frequency), True, polynomial(weight)
        x, y, turn = map(int, place.split(","))
        return (x, y), turn, False, polynomial(weight)

    def is_vertex(self, point):
        return self.lattice != "dual" and point == (0, 0)

    def in_sector(self, point):
        x, y = point
        if self.is_vertex(point):
            return point, 0
        turns, full, least = 0, 6 if self.lattice == "triangles" else 4, 0 if self.lattice == "dual" else 1
        while not (x >= least and y >= 0):
            x, y = (x + y, -x) if self.lattice == "triangles" else (y, -x - (self.lattice == "dual"))
            turns += 1
        return (x, y), turns - full if 2 * turns > full else turns

    def rule_at(self, point):
        if point in self.own:
            return self.own[point]
        result = []
        for k, value in self.mask.items():
            x, y = point[0] - k[0], point[1] - k[1]
            if x % self.arity == 0 and y % self.arity == 0:
                at, turn = self.in_sector((x // self.arity, y // self.arity))
                result.append((at, turn, False, {0: value}))
        return result

    def closure(self, points):
        known, open_points = set(), list(points)
        while open_points:
            point = open_points.pop()
            if point not in known:
                known.add(point)
                open_points += [term[0] for term in self.rule_at(point)]
        return known

    def closed_set(self):
        """The smallest one that holds all points that depend on themselves."""
        reach = max(abs(x) + abs(y) for x, y in self.mask)
        size = (reach + self.arity) // (self.arity - 1)
        start = [(x, y) for x in range(size + 1) for y in range(size + 1) if x or self.lattice == "dual"] + list(self.own)
        known = self.closure(start + ([] if self.lattice == "dual" else [(0, 0)]))
        return sorted(self.closure(p for p in known if p in self.closure(term[0] for term in self.rule_at(p))))


def cosine(n, k=1):
    """cos(2 pi k/n), up to 10^-60."""
    def arctangent(k):
        return sum(Fraction((-1) ** j, (2 * j + 1) * k ** (2 * j + 1)) for j in range(50))
    x = Fraction(round(2 * 4 * (4 * arctangent(5) - arctangent(239)) * k / n * 2 ** 220), 2 ** 220)
    total, term = Fraction(0), Fraction(1)
    for j in range(60):
        total += term
        term = Fraction(round(-term * x * x / ((2 * j + 1) * (2 * j + 2)) * 2 ** 220), 2 ** 220)
    return total


class Numbers:
    """a + b w as pairs, w = exp(2 pi i k/n); b = 0 where w is real."""

    def __init__(self, n, k=1):
        self.k, self.of_weights = k, cosine(n)
        self.c, self.w = (self.of_weights, cmath.exp(2j * math.pi / n)) if k == 1 else (cosine(n, k), cmath.exp(2j * math.pi * k / n))
        self.is_real = 2 * k % n == 0

    def times(self, x, y):
        bb = x[1] * y[1]
        return self.rounded((x[0] * y[0] - bb, x[0] * y[1] + x[1] * y[0] + 2 * self.c * bb))

    @staticmethod
    def rounded(x):
        return tuple(Fraction(round(part * 2 ** 160), 2 ** 160) for part in x)

    def turned(self, x, turns, n):
        if self.is_real:
            return x if self.k == 0 or turns % 2 == 0 else (-x[0], x[1])
        if 2 * turns > n:
            turns -= n
        for _ in range(abs(turns)):
            x = (-x[1], x[0] + 2 * self.c * x[1]) if turns > 0 else (x[1] + 2 * self.c * x[0], -x[0])
        return x

    def value(self, x):
        return float(x[0]) + float(x[1]) * self.w

    def pair(self, z):
        if self.is_real:
            return z.real, 0
        b = z.imag / self.w.imag
        return z.real - b * self.w.real, b


def block(rules, points, numbers):
    matrix = [[(Fraction(0), Fraction(0)) for _ in points] for _ in points]
    for i, point in enumerate(points):
        for at, turn, is_ring, weight in rules.rule_at(point):
            if (rules.is_vertex(at) and numbers.k) or (is_ring and turn != numbers.k):
                continue
            value = sum(factor * numbers.of_weights ** k for k, factor in weight.items())
            entry = numbers.turned((value, Fraction(0)), 0 if is_ring else turn, rules.n)
            j = points.index(at)
            matrix[i][j] = numbers.rounded((matrix[i][j][0] + entry[0], matrix[i][j][1] + entry[1]))
    return matrix


def inverse_of(matrix):
    n = len(matrix)
    rows = [list(row) + [float(i == j) for j in range(n)] for i, row in enumerate(matrix)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for i in range(n):
            if i != k:
                rows[i] = [x - rows[i][k] * y for x, y in zip(rows[i], rows[k])]
    return [row[n:] for row in rows]


def rough_eigenvector(rough):
    """Of the largest eigenvalue."""
    vector = [complex(1, k / 7) for k in range(len(rough))]
    for _ in range(3000):
        vector = [sum(x * v for x, v in zip(row, vector)) for row in rough]
        size = max(map(abs, vector))
        vector = [v / size for v in vector]
    return vector


def of_differences(rough):
    """Of a matrix that keeps constants, on the differences to the first place."""
    return [[x - y for x, y in zip(row[1:], rough[0][1:])] for row in rough[1:]]


def with_constants(rough, differences):
    """The eigenvector that has these differences."""
    value = sum(x * v for x, v in zip(of_differences(rough)[0], differences)) / differences[0]
    constant = sum(x * v for x, v in zip(rough[0][1:], differences)) / (value - 1)
    return [constant, *(v + constant for v in differences)]


def eigenpair(matrix, numbers, first):
    """lambda, z with z_0 = first, and an approximate inverse of the derivative of (A - lambda) z."""
    n = len(matrix)
    rough = [[numbers.value(x) for x in row] for row in matrix]
    vector = rough_eigenvector(rough if numbers.k else of_differences(rough))
    if not numbers.k:
        vector = with_constants(rough, vector)
    vector = [v * numbers.value(first) / vector[0] for v in vector]
    value = sum(x * v for x, v in zip(rough[0], vector)) / vector[0]
    lam, z = Fraction(value.real), [first] + [tuple(map(Fraction, numbers.pair(v))) for v in vector[1:]]
    derivative = [[-vector[i] if j == 0 else rough[i][j] - (value if i == j else 0) for j in range(n)] for i in range(n)]
    inverse = [[numbers.pair(x) for x in row] for row in inverse_of(derivative)]
    for _ in range(6):
        off = [tuple(sum(numbers.times(x, v)[part] for x, v in zip(row, z)) - lam * own[part] for part in (0, 1))
               for row, own in zip(matrix, z)]
        change = [tuple(sum(numbers.times(tuple(map(Fraction, x)), v)[part] for x, v in zip(row, off)) for part in (0, 1))
                  for row in inverse]
        lam = numbers.rounded((lam - change[0][0], 0))[0]
        z = [first] + [numbers.rounded((old[0] - d[0], old[1] - d[1])) for old, d in zip(z[1:], change[1:])]
    return lam, z, inverse


def vertex_lines(mask, arity, text, levels=1, radius_bits=44, points=None, first=None, refuted=None):
    """`refuted`: the frequency, and the lines behind the rows, where what is proved is that limits are not C^1."""
    rules = Rules(mask, arity, text)
    k, ends = refuted or (1, [])
    numbers = Numbers(rules.n, k)
    points = points or rules.closed_set()
    points = points if k else sorted(points, key=rules.is_vertex)  # where the value may be 0
    turning = [p for p in points if k == 0 or not rules.is_vertex(p)]
    first = first or (1, int(rules.lattice == "dual" and not numbers.is_real))
    lam, z, inverse = eigenpair(block(rules, turning, numbers), numbers, tuple(map(Fraction, first)))
    def pairs(values, bits):
        return " ".join(str(round(part * 2 ** bits)) for value in values for part in value)
    place = f"{round(lam * 2 ** XBITS)} {2 ** (XBITS - radius_bits)}"
    lines = [f"not-c1 {k} {BITS} {XBITS} {place}" if refuted else f"vertex {BITS} {XBITS} {levels} {place}",
             "points " + " ".join(",".join(map(str, p)) for p in points), "values " + pairs(z, XBITS), f"inverse {IBITS}"]
    return [*lines, *(f"row {i} {pairs(row, IBITS)}" for i, row in enumerate(inverse)), *ends]
