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

    def levels(self):
        """Lists of (start, end, product) for length 1, 2, ..."""
        words, spent, self.no_longer_words = [(a, b, self.family[letter]) for a, b, letter in self.edges], 0, False
        for length in itertools.count(1):
            if not words:
                break
            yield words
            cost = len(words) * len(self.edges) * self.size**3
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
            if upper is None or norm**upper[1] < upper[0]**length:
                upper = (norm, length)
            closed = [m for start, end, m in words if start == end]
            for m in closed:
                trace = abs(sum(m[i][i] for i in range(self.size)))
                lower = self.better(lower, (trace, length) if len(closed) > MOST_POWERS else self.of_powers(m, length))
        return lower, (0, 1) if self.no_longer_words else upper

    def better(self, one, other):
        """Of (|trace| / n)^(1/length)."""
        left, right = one[0] ** other[1] * self.size ** one[1], other[0] ** one[1] * self.size ** other[1]
        return one if left >= right else other

    def of_powers(self, m, length):
        best, power, times = (0, 1), m, 1
        while True:
            best = self.better(best, (abs(sum(power[i][i] for i in range(self.size))), times * length))
            if self.size**3 * times * length > 4000 or times >= 16:
                return best
            power, times = product(power, power), 2 * times

    def is_at_least(self, number, lower):
        """Whether number^length n >= |trace|."""
        trace, length = lower
        return Fraction(number) ** length * self.size >= Fraction(trace, self.denominator**length)

    def is_at_most(self, number, upper):
        """Whether number^length <= norm; true for number <= 0."""
        norm, length = upper
        number = Fraction(number)
        return number <= 0 or number**length <= Fraction(norm, self.denominator**length)


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
