"""Cases of section 4.16 of SPEC.md: differences of data that are refined by fits of least absolute deviations."""
import itertools
from fractions import Fraction as Q
from math import comb, lcm


def vertices(n, d):
    """The vertices of U as texts, in order."""
    found = set()
    for basis in itertools.combinations(range(n), d + 1):
        others = [r for r in range(n) if r not in basis]

        def at(b, r):  # the polynomial that is 1 at b and 0 at the rest of the basis
            value = Q(1)
            for c in basis:
                if c != b:
                    value *= Q(r - c, b - c)
            return value
        weights = {b: [at(b, r) for r in others] for b in basis}
        for signs in itertools.product((1, -1), repeat=len(others)):
            u = dict(zip(others, signs))
            u.update({b: -sum(s * w for s, w in zip(signs, weights[b])) for b in basis})
            if all(abs(x) <= 1 for x in u.values()):
                found.add("".join({1: "+", -1: "-"}.get(u[r], "0") for r in range(n)))
    return sorted(found)


def solve(rows, right, cost):
    """The least cost * x with rows * x = right and x >= 0, all integers: (value, x), or None if there is no x. The value is bounded.
    The simplex method without fractions: all numbers of the table are divided by `last`, that of the last pivot."""
    m, n = len(rows), len(rows[0])
    table = [[-x if b < 0 else x for x in row] + [int(i == k) for k in range(m)] + [abs(b)]
             for i, (row, b) in enumerate(zip(rows, right))]
    basis, last = list(range(n, n + m)), 1

    def pivot(i, j, lines):
        nonlocal last
        row, p = table[i], table[i][j]
        for line in lines:
            if line is not row:
                f = line[j]
                line[:] = [(p * x - f * y) // last for x, y in zip(line, row)] if f else [p * x // last for x in line]
        basis[i], last = j, p
        if p < 0:
            for line in lines:
                line[:] = [-x for x in line]
            last = -p

    def descend(line):
        count = 0
        while falling := [j for j in range(n) if line[j] < 0]:
            count += 1
            j = min(falling, key=lambda k: line[k]) if count < 30 else falling[0]  # then the rule of Bland
            rising = [(Q(table[i][-1], table[i][j]), basis[i], i) for i in range(m) if table[i][j] > 0]
            pivot(min(rising)[2], j, [*table, line])

    first = [-sum(column) for column in zip(*table)]
    first[n:n + m] = [0] * m
    descend(first)
    if first[-1] != 0:
        return None
    for i in range(m):  # no variable of the first phase stays
        if basis[i] >= n and (j := next((j for j in range(n) if table[i][j]), None)) is not None:
            pivot(i, j, table)
    second = [last * c for c in cost] + [0] * (m + 1)
    for row, b in zip(table, basis):
        if b < n and second[b]:
            f = second[b] // last
            second = [x - f * y for x, y in zip(second, row)]
    descend(second)
    x = [Q(0)] * n
    for row, b in zip(table, basis):
        if b < n:
            x[b] = Q(row[-1], last)
    return Q(-second[-1], last), x


class Start:
    """The tree for one difference."""

    def __init__(self, rule, steps, order, bound, j, thin=(), early=False, deep=None):
        self.n, self.d, self.arity = rule
        self.steps, self.order, self.bound, self.j, self.thin, self.early = steps, order, bound, j, thin, early
        self.deep = deep  # windows that all have this vertex are split to the end
        low, high, levels = j, j + order, []
        for _ in range(steps):
            low, high = low // self.arity, high // self.arity
            levels.insert(0, (low, high))
            high += self.n - 1
        self.windows = [(level, i) for level, (a, b) in enumerate(levels) for i in range(a, b + 1)]
        self.data = range(levels[0][0], levels[0][1] + self.n)
        self.vertices = vertices(self.n, self.d)
        self.lines, self.leaves, self.assigned = [f"start {j}"], [], {}

    def position(self, r):
        return self.arity * (2 * r - self.n + 1)

    def outputs(self):
        return [2 * e + 1 - self.arity for e in range(self.arity)]

    def equations(self, variables, scale):
        """Of the multipliers: (window, place) -> coefficient, and the right side: fits vanish; then of the data."""
        at = {window: k for k, window in enumerate(self.windows)}
        rows, right = [], []

        def value(level, m):  # as a form in the multipliers, and a constant
            if level == self.steps:
                k = m - self.j
                return {}, scale * (-1) ** (self.order - k) * comb(self.order, k) if 0 <= k <= self.order else 0
            return {(at[level, i], m - i): 1 for i in range(m - self.n + 1, m + 1) if (level, i) in at}, 0
        for w, (level, i) in enumerate(self.windows):
            for k in range(self.d + 1):
                row = {(w, r): self.position(r) ** k for r in range(self.n)}
                b = 0
                for e, x in enumerate(self.outputs()):
                    form, constant = value(level + 1, self.arity * i + e)
                    b += x ** k * constant
                    for key, c in form.items():
                        row[key] = row.get(key, 0) - x ** k * c
                rows.append(row)
                right.append(b)
        data = [value(0, m)[0] for m in self.data]
        return [[row.get(v, 0) for v in variables] for row in rows], right, [[row.get(v, 0) for v in variables] for row in data]

    def split_variables(self):
        """The multipliers that may be there: (window, place), sign."""
        found = []
        for w in self.assigned:
            for r in range(self.n):
                found += [((w, r), s) for s in (1, -1) if self.allows(w, r, s)]
        return found

    def allows(self, w, r, value):
        """All vertices that are possible for the window have the sign of the value there, or none."""
        return all(vertex[r] in ("0", "+-"[value < 0]) for vertex in self.assigned[w])

    def multipliers(self, found, x):
        result = {}
        for (key, sign), value in zip(found, x):
            result[key] = result.get(key, 0) + sign * value
        return {key: value for key, value in result.items() if value}

    def leaf(self):
        """Multipliers that prove the bound, or None."""
        found = self.split_variables()
        moments, right, data = self.equations([key for key, _ in found], 1)
        signs = [s for _, s in found]
        many = len(data) - self.order
        rows = [[s * x for s, x in zip(signs, row)] + [0] * (2 * many) for row in moments]
        sums = [list(row) for row in data]
        for _ in range(self.order):
            sums = [list(row) for row in itertools.accumulate(sums, lambda x, y: [a + b for a, b in zip(x, y)])]
        for i in range(many):
            rows.append([s * x for s, x in zip(signs, sums[i])] + [(k == i) * (-1) + (k == many + i) for k in range(2 * many)])
            right.append(0)
        done = solve(rows, right, [0] * len(found) + [1] * (2 * many))
        return None if done is None or done[0] > self.bound else self.multipliers(found, done[1])

    def point(self):
        """Residuals at the point of the theorem, where they are known: (window, place) -> value."""
        values = {(0, m): Q(1009) ** k for k, m in enumerate(self.data)}
        residuals = {}
        for w, (level, i) in enumerate(self.windows):
            data = [values.get((level, i + r)) for r in range(self.n)]
            if len(self.assigned.get(w, ())) != 1 or None in data:
                continue
            vertex, = self.assigned[w]
            nodes = [(r, data[r] + (c != "0")) for r, c in sorted(enumerate(vertex), key=lambda one: (one[1] != "0", one[0]))][: self.d + 1]

            def fit(x):
                total = Q(0)
                for r, y in nodes:
                    for c, _ in nodes:
                        if c != r:
                            y *= Q(x - self.position(c), self.position(r) - self.position(c))
                    total += y
                return total
            values.update({(level + 1, self.arity * i + e): fit(x) for e, x in enumerate(self.outputs())})
            residuals.update({(w, r): (data[r] - fit(self.position(r)), vertex.count("0") == self.d + 1) for r in range(self.n)})
        return residuals

    def thin_multipliers(self):
        """Multipliers of a cell without interior, or None."""
        found = [one for one in self.split_variables() if self.windows[one[0][0]][0] in self.thin]
        residuals = self.point()

        def counts(key):
            w, r = key
            sharp = self.assigned[w][0][r] != "0"
            return sharp and (self.windows[w][0] == 0 or (key in residuals and residuals[key][0] != 0 and residuals[key][1]))
        moments, right, data = self.equations([key for key, _ in found], 0)
        rows = [[s * x for (_, s), x in zip(found, row)] for row in moments + data] + [[int(counts(key)) for key, _ in found]]
        done = solve(rows, right + [0] * len(data) + [1], [0] * len(found)) if any(rows[-1]) else None
        return None if done is None else self.multipliers(found, done[1])

    def text(self, multipliers):
        scale = lcm(*(value.denominator for value in multipliers.values()))
        numbers = [multipliers.get((w, r), Q(0)) * scale for w in range(len(self.windows)) for r in range(self.n)]
        return scale, " ".join(str(x.numerator) for x in numbers)

    def fits(self, multipliers):
        return all(w in self.assigned and self.allows(w, r, value) for (w, r), value in multipliers.items())

    def close(self):
        if self.deep and len(self.assigned) < len(self.windows) and all(v == [self.deep] for v in self.assigned.values()):
            return False
        if self.deep and len(self.assigned) == len(self.windows) and (multipliers := self.thin_multipliers()) is not None:
            self.lines.append(f"thin {self.text(multipliers)[1]}")
            return True
        for k, multipliers in enumerate(self.leaves):
            if self.fits(multipliers):
                self.lines.append(f"again {k}")
                return True
        if self.thin and not self.deep and (multipliers := self.thin_multipliers()) is not None:
            self.lines.append(f"thin {self.text(multipliers)[1]}")
            return True
        if (self.early or len(self.assigned) == len(self.windows)) and (multipliers := self.leaf()) is not None:
            self.leaves.append(multipliers)
            scale, numbers = self.text(multipliers)
            self.lines.append(f"leaf {scale} {numbers}")
            return True
        return False

    def grow(self, order):
        """The subtree at the windows that are assigned; `order`: the windows, by number, that are split next."""
        if self.close():
            return True
        if not order:
            return False
        self.lines.append(f"split {order[0]}")
        for vertex in self.vertices:
            self.assigned[order[0]] = [vertex]
            if not self.grow(order[1:]):
                return False
        del self.assigned[order[0]]
        return True

    def grow_by_sides(self, order):
        """The same by the signs of single places, in windows with more than one vertex."""
        if self.close():
            return True
        for w in order:
            possible = self.assigned.get(w, self.vertices)
            if len(possible) > 1:
                break
        else:
            return False
        r = next(r for r in range(self.n) if len({v[r] for v in possible}) > 1)
        signs = possible[0][r]
        if r % 2 == len(self.lines) % 2:  # the others first
            signs = "".join(c for c in "+-0" if c != signs)
        signs = next((s for s in self.prefer if 0 < sum(v[r] in s for v in possible) < len(possible)), signs)
        self.lines.append(f"side {w} {r} {signs}")
        for first in (True, False):
            self.assigned[w] = [v for v in possible if (v[r] in signs) == first]
            if not self.grow_by_sides(order):
                return False
        self.assigned[w] = possible
        return True


def contraction(n, d, steps, order, bound, thin=(), early=False, from_above=False, deep=None, sides=False, prefer=(), arity=2):
    """The lines of a certificate from the second one on."""
    bound = Q(bound)
    moved = -(arity * (n - 2) + 1) * sum(arity**k for k in range(steps))
    lines = [f"l1 {n} {d}" + (f" {arity}" if arity > 2 else ""), "bounds - -", f"contraction {steps} {order} {bound}"]
    for j in range(arity**steps):
        if j <= (moved - order - j) % arity**steps:
            start = Start((n, d, arity), steps, order, bound, j, thin, early, deep)
            start.prefer = prefer  # signs of sides
            numbers = list(range(len(start.windows)))
            grow = start.grow_by_sides if sides else start.grow
            assert grow(numbers[::-1] if from_above else numbers), (n, d, steps, order, bound, j, start.assigned)
            lines += start.lines
    return lines + ["end"]


def orbit(n, d, steps, offset, factor, values, levels):
    """The lines of an orbit: the first full vertex that gives a fit for each window."""
    full = [v for v in vertices(n, d) if v.count("0") == d + 1]
    lines = [f"orbit {steps} {offset} {factor} {' '.join(map(str, values))}"]
    at = [Q(4 * r - 2 * (n - 1)) for r in range(n)]
    for _ in range(levels):
        chosen, following = [], []
        for data in (values[i:i + n] for i in range(len(values) - n + 1)):
            for v in full:
                nodes = [r for r in range(n) if v[r] == "0"]

                def fit(x):
                    total = Q(0)
                    for r in nodes:
                        term = Q(data[r])
                        for c in nodes:
                            term *= (x - at[c]) / (at[r] - at[c]) if c != r else 1
                        total += term
                    return total
                rest = [data[r] - fit(at[r]) for r in range(n)]
                if all(v[r] == "0" or rest[r] * (1 if v[r] == "+" else -1) >= 0 for r in range(n)):
                    chosen.append(v)
                    following += [fit(-1), fit(1)]
                    break
        lines.append(f"fits {' '.join(chosen)}")
        values = following
    return lines


def written(*arguments, **how):
    return "; ".join(contraction(*arguments, **how))


BY_HAND = ("l1 3 1; bounds - -; contraction 1 1 1; start 0; split 0; leaf 8 -2 0 2; again 0; start 1; split 0; split 1; "
           "leaf 8 -3 0 -5 5 0 3; again 0; split 1; again 0; again 0; end")
# of the mean of two data, any number between them: 0 or 2 times the difference
PAIR = ("l1 2 0; bounds - -; contraction 1 1 2; start 0; split 0; leaf 1 0 0; again 0; start 1; split 0; split 1; "
        "leaf 1 0 -1 1 0; leaf 1 0 -1 0 1; split 1; leaf 1 -1 0 1 0; leaf 1 -1 0 0 1; end")
MEDIAN = "--l1 3,0 --contraction 2,1,1"
SIX = "--l1 6,1 --lower 73/100 --contraction 1,1,3/5"

# of the edge of a kink
KINK = "; ".join(orbit(6, 1, 1, 0, "5/12", [0] * 8 + [95, 133, 165], 4))
NEGATIVE = "; ".join(orbit(6, 1, 1, 0, "5/12", [0] * 8 + [-95, -133, -165], 4))
SHIFTED = "; ".join(orbit(6, 1, 1, 1, "10/24", [0] * 9 + [95, 133, 165], 4))
MIRRORED = "; ".join(orbit(6, 1, 1, 1, "5/12", [165, 133, 95] + [0] * 8, 4))
TWICE = "; ".join(orbit(6, 1, 2, 0, "25/144", [0] * 8 + [95, 133, 165], 5))
UPPER = "--l1 6,1 --lower 73/100 --upper 158/125"

def split_after_side():
    """A rule whose first window is split by a side and each part of it by vertices."""
    lines = written(4, 1, 1, 1, "7/6").split("; ")
    at = lines.index("start 0") + 1
    return "; ".join(lines[:at] + ["side 0 0 +-", "split 0", *lines[at + 1:at + 3], "split 0"] + lines[at + 3:])


MATRICES = []
ACCEPTED = [
    ("l1-by-hand", "--l1 3,1 --contraction 1,1,1", BY_HAND),
    ("l1-pair", "--l1 2,0 --contraction 1,1,2", PAIR),
    ("l1-3-twice", "--l1 3,1 --lower 83/100 --contraction 2,1,5/16", written(3, 1, 2, 1, "5/16")),
    ("l1-3-half", "--l1 3,1 --lower 1/2", written(3, 1, 2, 1, "1/2")),
    ("l1-4", "--l1 4,1 --contraction 1,1,7/6", written(4, 1, 1, 1, "7/6")),
    ("l1-4-twice", "--l1 4,1 --lower 1/16 --contraction 2,1,11/12", written(4, 1, 2, 1, "11/12", thin=(0, 1))),
    ("l1-4-from-above", "--l1 4,1 --lower 1/16", written(4, 1, 2, 1, "11/12", early=True, from_above=True)),
    ("l1-4-sides", "--l1 4,1 --lower 1/16", written(4, 1, 2, 1, "11/12", early=True, from_above=True, sides=True)),
    ("l1-4-sides-zero", "--l1 4,1 --contraction 1,1,7/6", written(4, 1, 1, 1, "7/6", early=True, sides=True, prefer=("0", "+0"))),
    ("l1-5-sides-zero", "--l1 5,1 --contraction 1,1,1", written(5, 1, 1, 1, 1, early=True, sides=True, prefer=("+0", "+-", "0"))),
    ("l1-4-split-after-side", "--l1 4,1 --contraction 1,1,7/6", split_after_side()),
    ("l1-5-sides", "--l1 5,1 --contraction 1,1,1", written(5, 1, 1, 1, 1, early=True, sides=True)),
    ("l1-6-sides", "--l1 6,1 --contraction 1,1,3/5", written(6, 1, 1, 1, "3/5", early=True, from_above=True, sides=True)),
    ("l1-median-sides", MEDIAN, written(3, 0, 2, 1, 1, thin=(0, 1), early=True, sides=True)),
    ("l1-5-second", "--l1 5,2 --contraction 1,2,31/32 --lower 9/200", written(5, 2, 1, 2, "31/32")),
    ("l1-6", SIX, written(6, 1, 1, 1, "3/5")),
    ("l1-6-kink", UPPER, written(6, 1, 1, 1, "3/5").replace("; end", f"; {KINK}; end")),
    ("l1-6-kink-negative", UPPER, written(6, 1, 1, 1, "3/5").replace("; end", f"; {NEGATIVE}; end")),
    ("l1-6-kink-shifted", UPPER, written(6, 1, 1, 1, "3/5").replace("; end", f"; {SHIFTED}; end")),
    ("l1-6-kink-mirrored", UPPER, written(6, 1, 1, 1, "3/5").replace("; end", f"; {MIRRORED}; end")),
    ("l1-6-kink-twice", UPPER, written(6, 1, 1, 1, "3/5").replace("; end", f"; {TWICE}; end")),
    ("l1-6-second", "--l1 6,1 --contraction 1,2,3/4", written(6, 1, 1, 2, "3/4")),
    ("l1-6-cubic", "--l1 6,3 --contraction 1,1,433/480", written(6, 3, 1, 1, "433/480")),
    ("l1-median", MEDIAN, written(3, 0, 2, 1, 1, thin=(0, 1))),
    ("l1-median-deep", "--l1 3,0 --contraction 3,1,1", written(3, 0, 3, 1, 1, thin=(2,), early=True, from_above=True, deep="+-0")),
    ("l1-3-ternary", "--l1 3,1,3 --contraction 1,2,1/2 --lower 63/100", written(3, 1, 1, 2, "1/2", arity=3)),
    ("l1-3-ternary-twice", "--l1 3,1,3 --contraction 2,1,1/3 --lower 26/100", written(3, 1, 2, 1, "1/3", arity=3)),
    ("l1-4-ternary-thin", "--l1 4,1,3 --contraction 1,1,11/9", written(4, 1, 1, 1, "11/9", thin=(0,), arity=3)),
    ("l1-6-ternary", "--l1 6,1,3 --contraction 1,1,2/3 --lower 369/1000", written(6, 1, 1, 1, "2/3", early=True, sides=True, arity=3)),
    ("l1-3-four", "--l1 3,1,4 --lower 1/2", written(3, 1, 1, 2, "1/2", arity=4)),
    # as many starts as there may be
    ("l1-256-starts", "--l1 3,1,16 --contraction 2,1,15/32", written(3, 1, 2, 1, "15/32", early=True, arity=16)),
    ("l1-median-ternary", "--l1 3,0,3 --contraction 2,1,1", written(3, 0, 2, 1, 1, thin=(0, 1), early=True, arity=3)),
    ("l1-median-from-above", MEDIAN, written(3, 0, 2, 1, 1, early=True, from_above=True)),
]
# name, accepted case that is changed, other options or None, changes of its text
CHANGED = [
    ("l1-6-lower", "l1-6", "--l1 6,1 --lower 73/100", []),
    ("l1-6-contraction", "l1-6", "--l1 6,1 --contraction 1,1,6/10", []),
    ("l1-6-kink-lower", "l1-6-kink", "--l1 6,1 --lower 73/100", []),
    ("l1-6-kink-both", "l1-6-kink", f"{UPPER} --contraction 1,1,3/5", []),
    ("l1-by-hand-bounds", "l1-by-hand", None, [("bounds - -", "bounds 1/3 C7")]),
    # numbers need not be reduced
    ("l1-by-hand-loose", "l1-by-hand", "--l1 3,1 --contraction 1,1,8/8", [("1 1 1\n", "1 1 3/3\n"), ("leaf 8 -2 0 2", "leaf 16 -4 0 4")]),
    # places where all vertices have 0 have multipliers before the window is split
    ("l1-by-hand-early", "l1-by-hand", None, [("split 0\nleaf 8 -2 0 2\nagain 0", "leaf 8 -2 0 2")]),
    ("l1-by-hand-early-1", "l1-by-hand", None, [("split 0\nsplit 1\nleaf 8 -3 0 -5 5 0 3\nagain 0\nsplit 1\nagain 0\nagain 0", "leaf 8 -3 0 -5 5 0 3")]),
    ("l1-by-hand-side", "l1-by-hand", None, [("split 0\nleaf 8 -2 0 2", "side 0 1 -0\nleaf 8 -2 0 2")]),
    # the last window first, and a leaf where the other was not split
    ("l1-pair-other-order", "l1-pair", None, [("split 0\nleaf 1 0 0\nagain 0\n", "leaf 1 0 0\n"), (
        "split 0\nsplit 1\nleaf 1 0 -1 1 0\nleaf 1 0 -1 0 1\nsplit 1\nleaf 1 -1 0 1 0", "split 1\nsplit 0\nleaf 1 0 -1 1 0\nleaf 1 -1 0 1 0\nsplit 0\nleaf 1 0 -1 0 1")]),
]


def changes(name, base, reason, old, *news):
    """A case for each text that stands in the place of another."""
    return [(f"{name}-{i}" if i else name, base, None, reason, [(old, new)]) for i, new in enumerate(news)]


SIGN, FIT = "a multiplier has the wrong sign", "do not take its fit away"
BOUND, SUM, SHOWN = "do not prove the bound", "of a thin cell do not sum to 0", "no inequality of a thin cell is shown"
REJECTED = [
    # the claim
    *((f"l1-claim-{name}", base, options, reason, []) for name, base, options, reason in (
        ("smaller", "l1-6", "--l1 6,1 --contraction 1,1,599/1000", "another contraction"),
        ("larger", "l1-6", "--l1 6,1 --contraction 1,1,601/1000", "another contraction"),
        ("order", "l1-6", "--l1 6,1 --contraction 1,2,3/5", "another contraction"),
        ("steps", "l1-6", "--l1 6,1 --contraction 2,1,3/5", "another contraction"),
        ("lower", "l1-6", "--l1 6,1 --lower 7369656/10000000", "does not prove the lower end"),
        ("lower-of-one-step", "l1-4-from-above", "--l1 4,1 --lower 63/1000", "does not prove the lower end"),
        ("no-contraction", "l1-4", "--l1 4,1 --lower 1/1000000", "does not prove the lower end"),
        ("lower-1", "l1-by-hand", "--l1 3,1 --lower 1/1000000", "does not prove the lower end"),
        ("zero", "l1-6", "--l1 6,1 --lower 0", "must be positive"), ("negative", "l1-6", "--l1 6,1 --lower -1", "must be positive"),
        ("large", "l1-6", "--l1 6,1 --lower 10001", "too large"), ("points", "l1-6", "--l1 7,1 --lower 7/10", "expected 'l1 7 1', line 2"),
        ("degree", "l1-6", "--l1 6,2 --lower 7/10", "expected 'l1 6 2', line 2"),
        ("arity", "l1-6", "--l1 6,1,3 --lower 1/10", "expected 'l1 6 1 3', line 2"),
        ("binary", "l1-6-ternary", "--l1 6,1 --lower 1/10", "wrong number of fields, line 2"),
        ("arity-four", "l1-6-ternary", "--l1 6,1,4 --lower 1/10", "expected 'l1 6 1 4', line 2"),
        ("lower-of-three", "l1-6-ternary", "--l1 6,1,3 --lower 3691/10000", "does not prove the lower end"),
        ("lower-of-four", "l1-3-four", "--l1 3,1,4 --lower 50001/100000", "does not prove the lower end"),
        ("mask", "l1-by-hand", "--mask [3,5,0,0,5,3]/8 --arity 2 --lower 1/2", "expected 'exponent"))),
    ("l1-of-mask", "bspline-1", "--l1 6,1 --lower 7/10", "expected 'l1 6 1', line 2", []),
    # the lines before the trees
    *changes("l1-bounds", "l1-by-hand", "line 3", "bounds - -", "bounds -", "bounds x -", "bounds - - -", "bounds - 1/0", ""),
    *changes("l1-exact", "l1-by-hand", "expected 'contraction', line 4", "contraction", "exact", "sum-rules 1\ncontraction",
             "exact |[-1,1]@1,0,1|^1/1\nroot 1 0 0 1 1\ncontraction"),
    *changes("l1-contraction", "l1-by-hand", "line 4", "contraction 1 1 1", "contraction 0 1 1", "contraction 9 1 1", "contraction 1 0 1",
             "contraction 1 3 1", "contraction 1 1 -1", "contraction 1 1", "contraction 1 1 1 1", "contraction 1 1 1/0",
             "contraction 1 1 1.0", "contraction -1 1 1"),
    *changes("l1-ternary-steps", "l1-3-ternary", "more steps than the checker allows, line 4", "contraction 1 2", "contraction 6 2", "contraction 8 2"),
    *changes("l1-four-steps", "l1-3-four", "more steps than the checker allows, line 4", "contraction 1 2", "contraction 5 2"),
    *changes("l1-ternary-start", "l1-3-ternary-twice", "expected 'start", "start 2", "start 3"),
    *changes("l1-ternary-last-start", "l1-3-ternary-twice", "expected 'end'", "\nend", "\nstart 8\nend"),
    *changes("l1-ternary-orbit", "l1-6-ternary", "an orbit of a rule that is not binary proves nothing", "\nend", f"\n{KINK.split('; ')[0]}\nend"),
    *changes("l1-start", "l1-by-hand", "expected 'start 0', line 5", "start 0", "start 1", "start", "split 0"),
    *changes("l1-start-field", "l1-by-hand", "line 5", "start 0", "start 0 0", "start 00"),
    *changes("l1-later-start", "l1-by-hand", "expected 'start 1', line 9", "start 1", "start 2", "split 0"),
    *changes("l1-start-more", "l1-by-hand", "expected 'end', line 17", "end", "start 2\nend"),
    *changes("l1-second-more", "l1-5-second", "expected 'end'", "\nend", "\nstart 1\nend"),
    *changes("l1-twice-other", "l1-3-twice", "expected 'start 3'", "start 3", "start 2"),
    *changes("l1-end", "l1-by-hand", "text after 'end'", "end", "end\nend"),
    # the tree
    *changes("l1-split", "l1-by-hand", "number outside 0..0, line 6", "split 0", "split 1", "split -1"),
    *changes("l1-split-fields", "l1-by-hand", "wrong number of fields, line 6", "split 0", "split", "split 0 0"),
    *changes("l1-split-twice", "l1-by-hand", "a window is split that has one vertex, line 11", "split 0\nsplit 1", "split 0\nsplit 0", "split 1\nsplit 1"),
    *changes("l1-missing", "l1-by-hand", "expected 'leaf'", "again 0\nstart 1", "start 1", "node 0\nstart 1"),
    *changes("l1-missing-last", "l1-by-hand", "expected 'leaf', line 16", "again 0\nend", "end"),
    *changes("l1-more", "l1-by-hand", "expected 'start 1', line 9", "again 0\nstart 1", "again 0\nagain 0\nstart 1"),
    *changes("l1-again", "l1-by-hand", "there is no leaf of that number yet, line 8", "again 0", "again 1", "again -1",
             "again 18446744073709551616"),
    *changes("l1-again-fields", "l1-by-hand", "line 8", "again 0", "again", "again 0 0", "again x"),
    # leaves are those of one start
    *changes("l1-again-start", "l1-by-hand", "there is no leaf of that number yet, line 12", "leaf 8 -3 0 -5 5 0 3", "again 0"),
    # a leaf with multipliers of a window that is not split here
    *changes("l1-leaf-early", "l1-pair", f"{SIGN}, line 14", "split 1\nleaf 1 -1 0 1 0\nleaf 1 -1 0 0 1", "leaf 1 -1 0 1 0",
             "leaf 1 -1 0 0 1", "again 0"),
    *changes("l1-again-early", "l1-pair", f"{SIGN}, line 14", "split 1\nleaf 1 -1 0 1 0\nleaf 1 -1 0 0 1", "again 1"),
    # sides
    *changes("l1-side", "l1-by-hand", "number outside", "split 0\nleaf 8 -2 0 2", "side 1 1 +\nleaf 8 -2 0 2", "side 0 3 +\nleaf 8 -2 0 2",
             "side -1 1 +\nleaf 8 -2 0 2", "side 0 -1 +\nleaf 8 -2 0 2"),
    *changes("l1-side-fields", "l1-by-hand", "wrong number of fields, line 6", "split 0\nleaf 8 -2 0 2", "side 0 1", "side 0", "side", "side 0 1 + -"),
    *changes("l1-side-signs", "l1-by-hand", "signs are +, -, 0 or two of these", "split 0\nleaf 8 -2 0 2", "side 0 1 x", "side 0 1 -+", "side 0 1 0+",
             "side 0 1 0-", "side 0 1 +-0", "side 0 1 ++", "side 0 1 1"),
    *changes("l1-side-empty", "l1-by-hand", "a side without a vertex, line 6", "split 0\nleaf 8 -2 0 2", "side 0 1 +-", "side 0 1 0", "side 0 0 +",
             "side 0 0 0", "side 0 0 -0"),
    *changes("l1-side-twice", "l1-by-hand", "a side without a vertex, line 7", "split 0\nleaf 8 -2 0 2", "side 0 1 +\nside 0 1 +"),
    *changes("l1-side-split", "l1-by-hand", "a window is split that has one vertex, line 7", "split 0\nleaf 8 -2 0 2", "side 0 1 +\nsplit 0"),
    # each part has the signs of its own vertices
    *changes("l1-side-turned", "l1-pair", f"{SIGN}, line 12", "start 1\nsplit 0\nsplit 1", "start 1\nsplit 0\nside 1 0 -", "start 1\nside 0 0 -\nsplit 1"),
    *changes("l1-side-again", "l1-by-hand", f"{SIGN}, line 8", "split 0\nleaf 8 -2 0 2", "side 0 1 +\nleaf 8 -3 2 1"),
    *changes("l1-side-leaf", "l1-by-hand", f"{SIGN}, line 7", "split 0\nleaf 8 -2 0 2", "side 0 1 -\nleaf 8 -3 2 1", "side 0 1 +\nleaf 8 -1 -2 3"),
    *changes("l1-leaf-denominator", "l1-by-hand", "a denominator must be positive, line 7", "leaf 8 -2", "leaf 0 -2", "leaf -8 -2"),
    *changes("l1-leaf-zero", "l1-by-hand", "a denominator must be positive, line 7", "leaf 8 -2 0 2", "leaf 0 0 0 0"),
    *changes("l1-leaf-fields", "l1-by-hand", "wrong number of fields, line 7", "leaf 8 -2 0 2", "leaf", "leaf 8 -2 0", "leaf 8 -2 0 2 0"),
    *changes("l1-leaf-number", "l1-by-hand", "not an integer, line 7", "leaf 8 -2 0 2", "leaf 8 -2 -0 2", "leaf 8/1 -2 0 2",
             "leaf 8 -2 0 2/1", "leaf 8 -2 00 2", "leaf 8 -2  2", "leaf 8 x 0 2"),
    *changes("l1-leaf-fit", "l1-by-hand", f"{FIT}, line 7", "leaf 8 -2 0 2", "leaf 8 -3 0 2", "leaf 8 -3 0 3", "leaf 8 -2 0 -2",
             "leaf 4 -2 0 2", "leaf 8 0 0 0"),
    *changes("l1-leaf-fit-late", "l1-by-hand", f"{FIT}, line 12", "leaf 8 -3 0 -5 5 0 3", "leaf 8 -3 0 -5 4 0 3", "leaf 8 -3 0 -5 4 0 4",
             "leaf 8 -2 0 -6 5 0 3", "leaf 8 3 0 5 -5 0 -3"),
    *changes("l1-leaf-plus", "l1-by-hand", f"{SIGN}, line 7", "leaf 8 -2 0 2", "leaf 8 -1 -2 3"),
    *changes("l1-again-minus", "l1-by-hand", f"{SIGN}, line 8", "leaf 8 -2 0 2", "leaf 8 -3 2 1"),
    *changes("l1-pair-bound", "l1-pair", f"{BOUND}, line 16", "1 1 2\n", "1 1 1999999/1000000\n"),
    *changes("l1-pair-sign", "l1-pair", f"{SIGN}, line 12", "leaf 1 0 -1 1 0", "leaf 1 -1 0 1 0", "leaf 1 0 -1 0 1"),
    *changes("l1-6-bound", "l1-6", BOUND, "1 1 3/5", "1 1 599999999/1000000000"),
    *changes("l1-4-bound", "l1-4", BOUND, "1 1 7/6", "1 1 116666/100000", "1 1 0"),
    *changes("l1-5-bound", "l1-5-second", BOUND, "1 2 31/32", "1 2 309/320"),
    *changes("l1-5-first", "l1-5-second", "line", "1 2 31/32", "1 1 31/32", "1 3 31/32", "2 2 31/32"),
    *changes("l1-twice-bound", "l1-4-from-above", BOUND, "2 1 11/12", "2 1 109/120"),
    # orbits
    *((f"l1-kink-{name}", "l1-6-kink", options, reason, []) for name, options, reason in (
        ("upper", "--l1 6,1 --lower 73/100 --upper 1263034/1000000", "the orbit does not prove the upper end"),
        ("upper-0", "--l1 6,1 --lower 73/100 --upper 0", "the orbit does not prove the upper end"),
        ("upper-negative", "--l1 6,1 --lower 73/100 --upper -1", "an exponent is negative or too large"),
        ("upper-large", "--l1 6,1 --lower 73/100 --upper 10001", "an exponent is negative or too large"),
        ("lower", "--l1 6,1 --lower 74/100 --upper 158/125", "does not prove the lower end"))),
    ("l1-kink-twice", "l1-6-kink-twice", "--l1 6,1 --lower 73/100 --upper 1263034/1000000", "the orbit does not prove the upper end", []),
    ("l1-no-orbit", "l1-6", UPPER, "expected 'orbit'", []),
    ("l1-kink-no-limits", "l1-6-kink", "--l1 6,1 --contraction 1,1,1", "where no limits are proved", [("1 1 3/5", "1 1 1")]),
    ("l1-orbit-degree", "l1-5-second", None, "of a degree above 1", [("\nend", "\norbit 1 0 1/3 0 0 0 0 0 0 0 0 1\nfits 0\nend")]),
    *changes("l1-orbit-steps", "l1-6-kink", "number outside 1..8", "orbit 1 0", "orbit 0 0", "orbit 9 0", "orbit -1 0"),
    *changes("l1-orbit-offset", "l1-6-kink", "number outside 0..4096", "orbit 1 0", "orbit 1 -1", "orbit 1 4097"),
    *changes("l1-orbit-number", "l1-6-kink", "not an integer", "95 133", "95/1 133", "x 133"),
    *changes("l1-orbit-half", "l1-6-kink", "the factor of an orbit is a power of 1/2", "0 5/12 0", "0 1/2 0", "0 -1/4 0", "0 1 0", "0 2/4 0", "0 -1 0"),
    *changes("l1-orbit-factor", "l1-6-kink", "are not met again", "0 5/12 0", "0 5/11 0", "0 -5/12 0", "0 0 0", "0 3/2 0", "0 1/3 0"),
    *changes("l1-orbit-values", "l1-6-kink", "are not met again", "95 133 165", "95 133 164", "95 132 165"),
    *changes("l1-orbit-sign", "l1-6-kink", "a residual has not the sign", "95 133 165", "95 100 165", "95 133 1000", "-95 -133 -165"),
    *changes("l1-orbit-shifted", "l1-6-kink", "are not met again", "orbit 1 0", "orbit 1 1"),
    *changes("l1-orbit-outside", "l1-6-kink", "met again outside of what is known", "orbit 1 0", "orbit 1 2"),
    *changes("l1-orbit-short", "l1-6-kink", "wrong number of fields", "0 95 133 165", "95 133"),
    *changes("l1-orbit-run", "l1-6-kink", "too few values of one sign", "\n" + KINK.split("; ")[-1], ""),
    *changes("l1-orbit-run-of-zeros", "l1-6-kink-shifted", "too few values of one sign", "\n" + SHIFTED.split("; ")[-1], ""),
    *changes("l1-orbit-no-fits", "l1-6-kink", "expected 'fits'", "\n" + "\n".join(KINK.split("; ")[1:]), ""),
    *changes("l1-orbit-no-second", "l1-6-kink-twice", "expected 'fits'", "\n" + "\n".join(TWICE.split("; ")[2:]), ""),
    *changes("l1-orbit-second", "l1-6-kink-twice", "are not met again", "0 25/144 0", "0 25/143 0"),
    *changes("l1-orbit-fields", "l1-6-kink", "wrong number of fields", "fits +--+00 ", "fits ", "fits +--+00 +--+00 "),
    *changes("l1-orbit-vertex", "l1-6-kink", "is not that of a full vertex", "fits +--+00", "fits ++--00", "fits +--+0", "fits 000000", "fits 0",
             "fits +--+0x"),
    *changes("l1-orbit-degenerate", "l1-4-from-above", "is not that of a full vertex", "\nend",
             "\norbit 1 0 1/3 0 0 0 0 0 0 1\nfits 0+-0 0+-0 0+-0 +--+\nend", "\norbit 1 0 1/3 0 0 0 0 0 0 1\nfits +--+ 0+-0 0+-0 0+-0\nend"),
    *changes("l1-orbit-end", "l1-6-kink", "text after 'end'", "\nend", "\nend\nend"),
    *changes("l1-orbit-more", "l1-6-kink", "expected 'end'", "\nend", "\nstart 2\nend"),
]
# name, options, lines from the second one on, and the reason; the first vertex of a median is +-0, the second +0-
HEAD = "l1 3 0; bounds - -; contraction 2 1 1/2; start 0"
SAME = f"{HEAD}; split 2; split 0; split 1; thin 0 0 0 0 0 0 1 -1 0"
PAIR_HEAD = "l1 2 0; bounds - -; contraction 3 1 1/2; start 0"
WRITTEN = [(f"l1-thin-{name}", f"--l1 {lines[3:6].replace(' ', ',')} --contraction {steps},1,1/2", lines, reason) for name, steps, lines, reason in (
    # both windows have one median, so that residuals of the next level are 0 on a cell with an interior
    ("same", 2, f"{SAME}; thin 0 0 0 0 0 0 1 -1 0", f"{SHOWN} to be one, line 10"),
    ("same-inner", 2, f"{SAME}; thin 0 0 1 0 -1 0 1 0 -1", f"{SHOWN} to be one, line 10"),
    ("unknown", 2, f"{HEAD}; split 2; thin 0 0 0 0 0 0 1 -1 0", f"{SHOWN} to be one, line 7"),
    ("unknown-1", 2, f"{HEAD}; split 2; split 0; thin 0 0 0 0 0 0 1 -1 0", f"{SHOWN} to be one, line 8"),
    ("nothing", 2, f"{SAME}; thin 0 0 0 0 0 0 0 0 0", f"{SHOWN} to be one, line 10"),
    ("early", 2, f"{HEAD}; thin 1 -1 0 0 0 0 0 0 0", f"{SIGN}, line 6"),
    ("part", 2, f"{HEAD}; side 0 1 +; side 1 0 -; thin 0 1 -1 -1 1 0 0 0 0", f"{SHOWN} to be one, line 8"),
    ("sign", 2, f"{HEAD}; split 0; thin -1 1 0 0 0 0 0 0 0", f"{SIGN}, line 7"),
    ("fit", 2, f"{HEAD}; split 0; thin 1 0 0 0 0 0 0 0 0", f"{FIT}, line 7"),
    ("sum", 2, f"{HEAD}; split 0; thin 1 -1 0 0 0 0 0 0 0", f"{SUM}, line 7"),
    ("sum-last", 2, f"{HEAD}; split 1; thin 0 0 0 1 0 -1 0 0 0", f"{SUM}, line 7"),
    ("fields", 2, f"{HEAD}; split 0; thin 1 -1 0 0 0 0 0 0", "wrong number of fields, line 7"),
    ("denominator", 2, f"{HEAD}; split 0; thin 1 0 0 0 0 0 0 0 0 0", "wrong number of fields, line 7"),
    ("number", 2, f"{HEAD}; split 0; thin 1/2 -1/2 0 0 0 0 0 0 0", "not an integer, line 7"),
    # of degenerate vertices those of level 1 show nothing, those of level 2 are not allowed at all
    ("degenerate", 2, f"{PAIR_HEAD.replace('3 1', '2 1')}; split 0; split 1; thin 0 0 1 -1", f"{SHOWN} to be one, line 8"),
    ("degenerate-2", 3, f"{PAIR_HEAD}; split 0; split 1; split 2; thin 0 0 0 0 1 -1", "thin from level 2 on, and a degenerate vertex, line 9"),
)]
