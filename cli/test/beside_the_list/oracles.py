"""Bounds computed here, in exact integers and fractions, by nothing that the program uses: products and norms."""
import itertools
import math
from fractions import Fraction

MOST_OPERATIONS = 60_000  # of numbers, for the products of one family
LONGEST_WORD = 8
MOST_POWERS = 20  # words of one length whose powers are looked at
MOST_COEFFICIENTS = 20_000  # products of them, for one power of a symbol


def common(numbers):
    """Integers and the denominator that they have in common."""
    denominator = math.lcm(*(Fraction(v).denominator for v in numbers))
    return [int(v * denominator) for v in numbers], denominator


def product(a, b):
    columns = list(zip(*b))
    return [[sum(x * y for x, y in zip(row, column) if x and y) for column in columns] for row in a]


class Words:
    """Products of matrices along words of a graph: all words up to a length that the size allows, and powers of those
    that are closed. Entries are integers over one denominator."""

    def __init__(self, family, edges=None):
        flat, self.denominator = common([v for m in family for row in m for v in row])
        n, numbers = len(family[0]), iter(flat)
        self.family = [[[next(numbers) for _ in range(n)] for _ in range(n)] for _ in family]
        self.edges = edges or [[0, 0, letter] for letter in range(len(family))]
        self.size = n
        self.length = 1 + max((abs(v).bit_length() for v in (*flat, self.denominator)), default=0) // 256  # of numbers

    def levels(self):
        """Lists of (start, end, product) for length 1, 2, ..."""
        words, spent, self.no_longer_words = [(a, b, self.family[letter]) for a, b, letter in self.edges], 0, False
        for length in itertools.count(1):
            if not words:
                break
            yield words
            cost = len(words) * len(self.edges) * self.size**3 * self.length
            spent += cost
            if spent > MOST_OPERATIONS or length == LONGEST_WORD:
                return
            # product(m, w): the letter that comes later stands on the left
            words = [(start, b, product(self.family[letter], m)) for start, end, m in words
                     for a, b, letter in self.edges if a == end]
        self.no_longer_words = True

    def bounds(self):
        """(trace, length) with |trace| / n <= radius^length, the best found, and (norm, length) with radius^length <=
        norm; integers over denominator^length. A graph without long paths has norm 0."""
        lower, upper = (0, 1), None
        for length, words in enumerate(self.levels(), 1):
            norm = max(max(sum(map(abs, row)) for row in m) for _, _, m in words)
            norm = min(norm, max(max(sum(map(abs, column)) for column in zip(*m)) for _, _, m in words))
            if upper is None or not norm or math.log(norm) / length < math.log(upper[0]) / upper[1]:
                upper = (norm, length)
            closed = [m for start, end, m in words if start == end]
            for m in closed:
                trace = abs(sum(m[i][i] for i in range(self.size)))
                lower = self.better(lower, (trace, length) if len(closed) > MOST_POWERS else self.of_powers(m, length))
        return lower, (0, 1) if self.no_longer_words else upper

    def better(self, one, other):
        """Of (|trace| / n)^(1/length), as far as doubles tell: each is a bound."""
        def logarithm(trace, length):
            return (math.log(trace) - math.log(self.size)) / length if trace else -math.inf
        return one if logarithm(*one) >= logarithm(*other) else other

    def of_powers(self, m, length):
        best, power, times = (0, 1), m, 1
        while True:
            best = self.better(best, (abs(sum(power[i][i] for i in range(self.size))), times * length))
            if self.size**3 * self.length * times * length > 4000 or times >= 16:
                return best
            power, times = product(power, power), 2 * times

    def is_at_least(self, number, lower):
        """Whether number^length n >= |trace|."""
        (trace, length), number = lower, Fraction(number)
        return (number.numerator * self.denominator) ** length * self.size >= trace * number.denominator**length

    def is_at_most(self, number, upper):
        """Whether number^length <= norm; true for number <= 0."""
        norm, length = upper
        number = Fraction(number)
        return number <= 0 or (number.numerator * self.denominator) ** length <= norm * number.denominator**length


class DifferenceScheme:
    """The divided symbol q of a mask, a(z) = (1 + z + ... + z^(m-1))^r q(z) with r as large as possible. With R the
    growth of the operator of q, the exponent is at least -log_m R, and no larger where the shifts are stable."""

    def __init__(self, coefficients, arity):
        q, self.denominator = common(coefficients)
        while q and q[0] == 0:
            q = q[1:]
        while q and q[-1] == 0:
            q = q[:-1]
        self.arity, self.rules = arity, 0
        while len(q) >= arity:
            quotient = self.quotient(q, arity)
            if quotient is None:
                break
            q, self.rules = quotient, self.rules + 1
        self.q = q

    @staticmethod
    def quotient(a, arity):
        """a / (1 + ... + z^(arity-1)), or None."""
        rest, result = list(a), []
        for i in range(len(a) - arity + 1):
            result.append(rest[i])
            if rest[i]:
                for k in range(arity):
                    rest[i + k] -= result[-1]
        return None if any(rest) else result

    def growth_at_most(self):
        """log R, by norms of powers."""
        best, power, levels = math.inf, [1], 0
        while levels < 12 and len(power) * len(self.q) < MOST_COEFFICIENTS:
            step = self.arity**levels
            longer = [0] * (len(power) + step * (len(self.q) - 1))
            for j, c in enumerate(self.q):
                if c:
                    for i, v in enumerate(power):
                        longer[i + step * j] += c * v
            power, levels = longer, levels + 1
            stride = step * self.arity
            norm = max(sum(map(abs, power[k::stride])) for k in range(min(stride, len(power))))
            best = min(best, (math.log(norm) - levels * math.log(self.denominator)) / levels)
        return best

    def growth_at_least(self):
        """log R, by traces of products of the transition matrices (minus infinity where these are zero)."""
        top, m = len(self.q) - 1, self.arity
        size = max(1, (max(top, 1) - 1) // (m - 1) + 1)
        at = lambda k: self.q[k] if 0 <= k <= top else 0
        words = Words([[[at(m * i + d - j) for j in range(size)] for i in range(size)] for d in range(m)])
        trace, length = words.bounds()[0]
        ends = max(abs(self.q[0]), abs(self.q[-1]))  # each is a factor of a coefficient of every power
        best = math.log(ends) - math.log(self.denominator)
        if trace:
            best = max(best, (math.log(trace) - math.log(size)) / length - math.log(self.denominator))
        return best

    def exponent_at_least(self):
        return -self.growth_at_most() / math.log(self.arity)

    def exponent_at_most(self):
        return -self.growth_at_least() / math.log(self.arity)


class VectorEquation:
    """phi(x) = sum over k of A_k phi(ax - k) in one variable, by its operators on finite sequences of vectors:
    (T_d u)_j = sum over k of A_(aj+d-k) u_k. Sequences are dictionaries {(j, component): number}."""

    LARGEST = 24  # spaces

    def __init__(self, matrices, first, arity):
        self.arity, self.size = arity, len(matrices[0])
        self.entries = [(first + k, i, j, m[i][j]) for k, m in enumerate(matrices) for i in range(self.size)
                        for j in range(self.size) if m[i][j]]

    def images(self, u):
        """T_d u for every d."""
        result = [{} for _ in range(self.arity)]
        for (k, c), value in u.items():
            for n, i, j, entry in self.entries:
                if j == c:
                    at, d = divmod(n + k, self.arity)
                    result[d][at, i] = result[d].get((at, i), 0) + entry * value
        return [{key: v for key, v in image.items() if v} for image in result]

    def spun(self, starts):
        """The matrices of T_d on the span of all words on the sequences; None where it is too large."""
        rows = []  # (pivot, sequence), reduced one by one

        def reduced(u):
            u, coordinates = dict(u), []
            for pivot, row in rows:
                factor = u.get(pivot, 0)
                coordinates.append(factor)
                if factor:
                    for key, v in row.items():
                        u[key] = u.get(key, 0) - factor * v
            return {key: v for key, v in u.items() if v}, coordinates

        waiting = list(starts)
        while waiting:
            rest, _ = reduced(waiting.pop())
            if rest:
                pivot = min(rest)
                rows.append((pivot, {key: Fraction(v) / rest[pivot] for key, v in rest.items()}))
                waiting.extend(self.images(rows[-1][1]))
                if len(rows) > self.LARGEST:
                    return None
        columns = [[reduced(image)[1] for image in self.images(row)] for _, row in rows]
        return [[[columns[c][d][r] for c in range(len(rows))] for r in range(len(rows))] for d in range(self.arity)]

    def of_differences(self):
        """Of the scheme of the transposed matrices: what has to vanish where its data converge."""
        starts = []
        for c in range(self.size):
            starts.append({(0, c): 1, (1, c): -1})
            for image in self.images({(0, c): 1}):
                image[0, c] = image.get((0, c), 0) - 1
                starts.append(image)
        return self.spun(starts)

    def keeps_constants(self):
        """Whether a vector is kept by the sums of the transposed matrices over every class."""
        rows = {(d, j): [Fraction(-int(i == j)) for i in range(self.size)]
                for d in range(self.arity) for j in range(self.size)}
        for n, i, j, entry in self.entries:
            rows[n % self.arity, j][i] += entry
        return bool(kernel(list(rows.values()), self.size))

    def of_values(self, order):
        """Of differences of the values of the only solution at integers; None where there is not one."""
        low, high = min(e[0] for e in self.entries), max(e[0] for e in self.entries)
        inside = [(j, c) for j in range(low, high + 1) for c in range(self.size)
                  if low < j * (self.arity - 1) < high]
        if not inside or len(inside) > self.LARGEST:
            return None
        rows = {}
        for column, at in enumerate(inside):
            image = self.images({at: 1})[0]
            image[at] = image.get(at, 0) - 1
            for key, v in image.items():
                rows.setdefault(key, [Fraction(0)] * len(inside))[column] = Fraction(v)
        solutions = kernel(list(rows.values()), len(inside))
        if len(solutions) != 1:
            return None
        u = {at: v for at, v in zip(inside, solutions[0]) if v}
        for _ in range(order):
            moved = dict(u)
            for (j, c), v in u.items():
                moved[j + 1, c] = moved.get((j + 1, c), 0) - v
            u = moved
        return self.spun([u])


def kernel(rows, columns):
    """A basis of what these rows map to 0."""
    pivots = []
    for column in range(columns):
        at = next((row for row in rows[len(pivots):] if row[column]), None)
        if at is None:
            continue
        rows.remove(at)
        rows.insert(len(pivots), [v / at[column] for v in at])
        pivot = rows[len(pivots)]
        rows[:] = [row if row is pivot or not row[column] else [a - row[column] * b for a, b in zip(row, pivot)]
                   for row in rows]
        pivots.append(column)
    result = []
    for free in set(range(columns)) - set(pivots):
        vector = [Fraction(0)] * columns
        vector[free] = Fraction(1)
        for place, column in enumerate(pivots):
            vector[column] = -rows[place][free]
        result.append(vector)
    return result
