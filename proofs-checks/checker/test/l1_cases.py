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
    """The least cost * x with rows * x = right and x >= 0, all exact: (value, x), or None if there is no x. The value is bounded."""
    m, n = len(rows), len(rows[0])
    table = []
    for i, (row, b) in enumerate(zip(rows, right)):
        sign = -1 if b < 0 else 1
        table.append([Q(sign * x) for x in row] + [Q(i == k) for k in range(m)] + [Q(sign * b)])
    basis = list(range(n, n + m))

    def pivot(i, j, lines):
        row = table[i]
        factor = row[j]
        if factor != 1:
            row[:] = [x / factor for x in row]
        places = [k for k, x in enumerate(row) if x]
        for line in lines:
            if line is not row and line[j]:
                f = line[j]
                for k in places:
                    line[k] -= f * row[k]
        basis[i] = j

    def descend(line, width):
        count = 0
        while True:
            count += 1
            falling = [j for j in range(width) if line[j] < 0]
            if not falling:
                return
            j = min(falling, key=lambda k: line[k]) if count < 30 else falling[0]  # then the rule of Bland
            rising = [(table[i][-1] / table[i][j], basis[i], i) for i in range(m) if table[i][j] > 0]
            pivot(min(rising)[2], j, [*table, line])

    first = [-sum(column) for column in zip(*table)]
    first[n:n + m] = [Q(0)] * m
    descend(first, n)
    if first[-1] != 0:
        return None
    for i in range(m):  # no variable of the first phase stays
        if basis[i] >= n:
            j = next((j for j in range(n) if table[i][j] != 0), None)
            if j is not None:
                pivot(i, j, table)
    second = [Q(c) for c in cost] + [Q(0)] * (m + 1)
    for i in range(m):
        if basis[i] < n and second[basis[i]]:
            f = second[basis[i]]
            second = [x - f * y for x, y in zip(second, table[i])]
    descend(second, n)
    x = [Q(0)] * n
    for i in range(m):
        if basis[i] < n:
            x[basis[i]] = table[i][-1]
    return -second[-1], x


class Start:
    """The tree for one difference."""

    def __init__(self, rule, steps, order, bound, j, thin=(), early=False):
        self.n, self.d = rule
        self.steps, self.order, self.bound, self.j, self.thin, self.early = steps, order, bound, j, thin, early
        low, high, levels = j, j + order, []
        for _ in range(steps):
            low, high = low // 2, high // 2
            levels.insert(0, (low, high))
            high += self.n - 1
        self.windows = [(level, i) for level, (a, b) in enumerate(levels) for i in range(a, b + 1)]
        self.data = range(levels[0][0], levels[0][1] + self.n)
        self.vertices = vertices(*rule)
        self.lines, self.leaves, self.assigned = [f"start {j}"], [], {}

    def position(self, r):
        return 4 * r - 2 * (self.n - 1)

    def equations(self, variables, scale):
        """Of the multipliers: (window, place) -> coefficient, and the right side: fits vanish; then of the data."""
        at = {window: k for k, window in enumerate(self.windows)}
        rows, right = [], []

        def value(level, m):  # as a form in the multipliers, and a constant
            if level == self.steps:
                k = m - self.j
                return {}, Q(scale * (-1) ** (self.order - k) * comb(self.order, k) if 0 <= k <= self.order else 0)
            return {(at[level, i], m - i): 1 for i in range(m - self.n + 1, m + 1) if (level, i) in at}, Q(0)
        for w, (level, i) in enumerate(self.windows):
            for k in range(self.d + 1):
                row = {(w, r): self.position(r) ** k for r in range(self.n)}
                b = Q(0)
                for place, sign in ((2 * i, (-1) ** k), (2 * i + 1, 1)):
                    form, constant = value(level + 1, place)
                    b += sign * constant
                    for key, c in form.items():
                        row[key] = row.get(key, 0) - sign * c
                rows.append(row)
                right.append(b)
        data = [value(0, m)[0] for m in self.data]
        return [[row.get(v, 0) for v in variables] for row in rows], right, [[row.get(v, 0) for v in variables] for row in data]

    def split_variables(self):
        """The multipliers that may be there: (window, place), sign."""
        found = []
        for w, vertex in self.assigned.items():
            for r, c in enumerate(vertex):
                found += [((w, r), s) for s in (1, -1) if c in ("0", "+-"[s < 0])]
        return found

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
            right.append(Q(0))
        done = solve(rows, right, [0] * len(found) + [1] * (2 * many))
        return None if done is None or done[0] > self.bound else self.multipliers(found, done[1])

    def point(self):
        """Residuals at the point of the theorem, where they are known: (window, place) -> value."""
        values = {(0, m): Q(1009) ** k for k, m in enumerate(self.data)}
        residuals = {}
        for w, (level, i) in enumerate(self.windows):
            data = [values.get((level, i + r)) for r in range(self.n)]
            if w not in self.assigned or None in data:
                continue
            vertex = self.assigned[w]
            nodes = [(r, data[r] + (c != "0")) for r, c in sorted(enumerate(vertex), key=lambda one: (one[1] != "0", one[0]))][: self.d + 1]

            def fit(x):
                total = Q(0)
                for r, y in nodes:
                    for c, _ in nodes:
                        if c != r:
                            y *= Q(x - self.position(c), self.position(r) - self.position(c))
                    total += y
                return total
            values[level + 1, 2 * i], values[level + 1, 2 * i + 1] = fit(-1), fit(1)
            residuals.update({(w, r): (data[r] - fit(self.position(r)), vertex.count("0") == self.d + 1) for r in range(self.n)})
        return residuals

    def thin_multipliers(self):
        """Multipliers of a cell without interior, or None."""
        found = [one for one in self.split_variables() if self.windows[one[0][0]][0] in self.thin]
        residuals = self.point()

        def counts(key):
            w, r = key
            sharp = self.assigned[w][r] != "0"
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
        return all(w in self.assigned and (c := self.assigned[w][r]) in ("0", "+-"[value < 0]) for (w, r), value in multipliers.items())

    def close(self):
        for k, multipliers in enumerate(self.leaves):
            if self.fits(multipliers):
                self.lines.append(f"again {k}")
                return True
        if self.thin and (multipliers := self.thin_multipliers()) is not None:
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
            self.assigned[order[0]] = vertex
            if not self.grow(order[1:]):
                return False
        del self.assigned[order[0]]
        return True


def contraction(n, d, steps, order, bound, thin=(), early=False, from_above=False):
    """The lines of a certificate from the second one on."""
    bound = Q(bound)
    lines = [f"l1 {n} {d}", "bounds - -", f"contraction {steps} {order} {bound}"]
    for j in range(2**steps):
        if j <= (2 * n - 3 - order - j) % 2**steps:
            start = Start((n, d), steps, order, bound, j, thin, early)
            numbers = list(range(len(start.windows)))
            assert start.grow(numbers[::-1] if from_above else numbers), (n, d, steps, order, bound, j, start.assigned)
            lines += start.lines
    return lines + ["end"]


def written(*arguments, **how):
    return "; ".join(contraction(*arguments, **how))


BY_HAND = ("l1 3 1; bounds - -; contraction 1 1 1; start 0; split 0; leaf 8 -2 0 2; again 0; start 1; split 0; split 1; "
           "leaf 8 -3 0 -5 5 0 3; again 0; split 1; again 0; again 0; end")
# of the mean of two data, any number between them: 0 or 2 times the difference
PAIR = ("l1 2 0; bounds - -; contraction 1 1 2; start 0; split 0; leaf 1 0 0; again 0; start 1; split 0; split 1; "
        "leaf 1 -1 0 0 1; leaf 1 -1 0 1 0; split 1; leaf 1 0 -1 0 1; leaf 1 0 -1 1 0; end")
MEDIAN = "--l1 3,0 --contraction 2,1,1"
SIX = "--l1 6,1 --lower 73/100 --contraction 1,1,3/5"

MATRICES = []
ACCEPTED = [
    ("l1-by-hand", "--l1 3,1 --contraction 1,1,1", BY_HAND),
    ("l1-pair", "--l1 2,0 --contraction 1,1,2", PAIR),
    ("l1-3-twice", "--l1 3,1 --lower 33/100 --contraction 2,1,5/8", written(3, 1, 2, 1, "5/8")),
    ("l1-4", "--l1 4,1 --contraction 1,1,7/6", written(4, 1, 1, 1, "7/6")),
    ("l1-4-twice", "--l1 4,1 --lower 1/16 --contraction 2,1,11/12", written(4, 1, 2, 1, "11/12", thin=(0, 1))),
    ("l1-4-from-above", "--l1 4,1 --lower 1/16", written(4, 1, 2, 1, "11/12", early=True, from_above=True)),
    ("l1-5-second", "--l1 5,2 --contraction 1,2,31/32 --lower 9/200", written(5, 2, 1, 2, "31/32")),
    ("l1-6", SIX, written(6, 1, 1, 1, "3/5")),
    ("l1-6-second", "--l1 6,1 --contraction 1,2,3/4", written(6, 1, 1, 2, "3/4")),
    ("l1-6-cubic", "--l1 6,3 --contraction 1,1,433/480", written(6, 3, 1, 1, "433/480")),
    ("l1-median", MEDIAN, written(3, 0, 2, 1, 1, thin=(0, 1))),
    ("l1-median-from-above", MEDIAN, written(3, 0, 2, 1, 1, early=True, from_above=True)),
]
