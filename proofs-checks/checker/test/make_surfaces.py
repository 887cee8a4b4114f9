"""Certificates of schemes of several variables whose radius is known by hand, for make_certificates.py.

Points are tuples, sequences dictionaries from points to numbers without zeros. For a mask a, directions Y and
D_Y = prod over Y of 1 - z^eta with a D_Y = b prod over Y' of 1 - z^(M eta'), T_d maps D_Y z^k to the sum of the
b_i D_Y' z^j over M j + d = k + i: combinations of the vertices D_Y z^k. Shares no code with the checker or the engine.
"""
import itertools
import math
from fractions import Fraction as Q

BITS = 64


def add(p, q, factor=1):
    return tuple(a + factor * b for a, b in zip(p, q))


def times(matrix, p):
    return tuple(sum(a * b for a, b in zip(row, p)) for row in matrix)


def convolve(*sequences):
    result = {(0,) * len(next(iter(sequences[0]))): Q(1)}
    for x in sequences:
        product = {}
        for (p, a), (q, b) in itertools.product(result.items(), x.items()):
            product[add(p, q)] = product.get(add(p, q), 0) + a * b
        result = {p: a for p, a in product.items() if a}
    return result


def binomial(direction, sign):
    """1 + sign * z^direction."""
    return {(0,) * len(direction): Q(1), tuple(direction): Q(sign)}


def eliminate(vectors):
    """A basis as pairs (pivot, vector): each vector is 1 at its pivot, all others are 0 there."""
    basis = []
    for x in vectors:
        for pivot, row in basis:
            x = subtract(x, row, x.get(pivot, 0))
        if x:
            pivot = min(x)
            x = {p: Q(a) / x[pivot] for p, a in x.items()}
            basis = [(p, subtract(row, x, row.get(pivot, 0))) for p, row in basis] + [(pivot, x)]
    return basis


def subtract(x, row, factor):
    result = {p: x.get(p, 0) - factor * row.get(p, 0) for p in {**x, **row}} if factor else x
    return {p: a for p, a in result.items() if a}


class Division:
    """p = M j + d, the digits being the first point of each class in a box."""

    def __init__(self, matrix):
        self.matrix = matrix
        self.digits = []
        n = len(matrix)
        units = [tuple(int(i == v) for v in range(n)) for i in range(n)]
        columns = eliminate([{**{(i,): Q(row[c]) for i, row in enumerate(matrix) if row[c]}, (n + c,): Q(1)} for c in range(n)])
        rows = dict(columns)  # by column operations: pivot (i,) has the unit vector i above column i of the inverse
        self.inverse = [[rows[(i,)].get((n + j,), Q(0)) for i in range(n)] for j in range(n)]
        for p in itertools.product(range(4), repeat=n):
            if all(self.quotient(add(p, d, -1)) is None for d in self.digits):
                self.digits.append(p)

    def quotient(self, p):
        j = times(self.inverse, p)
        return tuple(int(c) for c in j) if all(Q(c).denominator == 1 for c in j) else None

    def __call__(self, p):
        return next((d, j) for d, digit in enumerate(self.digits) if (j := self.quotient(add(p, digit, -1))) is not None)


def gram(mask, divide):
    """The fixed point of the transfer operator, as integers."""
    scale = Q(1, len(divide.digits))
    products = {p: a * scale for p, a in convolve(mask, {tuple(-c for c in p): a for p, a in mask.items()}).items()}
    zero = (0,) * len(divide.matrix)
    images, fresh = {}, [zero]
    while fresh:
        k = fresh.pop()
        images[k] = {j: c for p, c in products.items() if (j := divide.quotient(add(p, k))) is not None}
        fresh += [j for j in images[k] if j not in images and j not in fresh]
    # Columns (T - 1) e_k with e_k below: combinations without an upper part are the kernel.
    basis = eliminate([{**{("a", p): a for p, a in subtract(images[k], {k: Q(1)}, 1).items()}, ("b", k): Q(1)} for k in images])
    (kernel,) = [x for pivot, x in basis if pivot[0] == "b"]
    sign = 1 if sum(kernel.values()) > 0 else -1
    common = math.lcm(*(a.denominator for a in kernel.values()))
    return {p: int(a * common) * sign for (_, p), a in sorted(kernel.items()) if p >= zero}


def nested(mask):
    """The text of the mask, the last variable outermost."""
    low, high = ([f(p[v] for p in mask) for v in range(len(next(iter(mask))))] for f in (min, max))
    common = math.lcm(*(Q(a).denominator for a in mask.values()))

    def part(v, point):
        if v < 0:
            return str(mask.get(point, 0) * common)
        return "[" + ",".join(part(v - 1, (c, *point)) for c in range(low[v], high[v] + 1)) + "]"
    return part(len(low) - 1, ()) + f"/{common}@" + ",".join(map(str, low))


def at(p):
    return ",".join(map(str, p))


def terms(x):
    return " ".join(f"{at(p)}:{a}" for p, a in x.items())


def space(vectors):
    """The lines of the space that the vectors span, and the coordinates of a sequence."""
    basis = sorted(eliminate(vectors))
    common = math.lcm(*(a.denominator for _, x in basis for a in x.values()))
    lines = [f"space {len(basis)}"]
    for pivot, x in basis:
        lines.append("vector " + terms({pivot: common, **{p: int(a * common) for p, a in sorted(x.items()) if p != pivot}}))
    return lines, lambda x: [x.get(pivot, Q(0)) for pivot, _ in basis]


def move(name, k, families, divide):
    """The images of D_Y z^k, digit by digit."""
    _, b, following, _ = families[name]
    images = [{} for _ in divide.digits]
    for i, weight in b.items():
        d, j = divide(add(k, i))
        images[d][following, j] = images[d].get((following, j), 0) + weight
    return images


def certificate(mask, divide, sum_rules, space_lines, product, section, lower, upper, blocks=()):
    """Options of the claim, and lines; without an upper end no stability and no product."""
    text, dilation = nested(mask), "[" + ";".join(map(at, divide.matrix)) + "]"
    claim = ["--surface", text, "--dilation", dilation, "--lower", str(lower)]
    head = ["subcert-certificate 3", f"surface {text} {dilation}", f"bounds {lower} {upper or '-'}",
            f"sum-rules {sum_rules}", "digits " + " ".join(map(at, divide.digits)), *space_lines]
    if upper:
        claim += ["--upper", str(upper)]
        head += ["gram " + terms(gram(mask, divide)), *blocks, product]
    return claim, head + section + ["end"]


def exchanged(vertex):
    """The vertex with its two variables exchanged."""
    name, k = vertex
    return tuple(sorted(direction[::-1] for direction in name)), k[::-1]


def surface(mask, matrix, sum_rules, families, word, value, lower, upper, exchange=False):
    """families: name -> (directions, b, next name, scale of the vertices); value: the eigenvalue of the word. With
    `exchange` one of two vertices that an exchange of the variables maps to each other."""
    divide = Division(matrix)
    start = {name: convolve(*(binomial(eta, -1) for eta in directions)) for name, (directions, *_) in families.items()}
    reached = set(itertools.product(families, itertools.product((-1, 0), repeat=len(matrix))))
    images = {}
    while set(images) != reached:  # until the vertices that are reached after many steps alone are left
        images = {vertex: move(*vertex, families, divide) for vertex in sorted(reached)}
        reached = {v for vertex in images for image in images[vertex] for v in image}
    sequences = {(name, k): {add(p, k): a for p, a in start[name].items()} for name, k in images}
    lines, coordinates = space(sequences.values())
    one = 1 << BITS
    of_orbit = (lambda v: min(v, exchanged(v))) if exchange else (lambda v: v)
    listed = [v for v in images if of_orbit(v) == v]
    number = {v: f"{listed.index(of_orbit(v))}" + ("" if of_orbit(v) == v else "A") for v in images}
    scale = {name: Q(round(family[3] * one), one) for name, family in families.items()}
    section = [f"block 0 polytope {len(listed)} {BITS} {BITS}" + (" group:1" if exchange else "")]
    if exchange:
        columns = [coordinates({p[::-1]: a for p, a in x.items()}) for _, x in sorted(eliminate(sequences.values()))]
        section.append("generator " + " ".join(str(divide.digits.index(d[::-1])) for d in divide.digits))
        section += ["map " + " ".join(map(str, row)) for row in zip(*columns)]
    section += ["vertex " + " ".join(str(int(a * scale[v[0]] * one)) for a in coordinates(sequences[v])) for v in listed]
    # e_K as combinations of vertices: vectors with the vertices in a second part
    size = len(coordinates({}))
    basis = dict(eliminate([{**{("a", i): a * scale[v[0]] for i, a in enumerate(coordinates(sequences[v])) if a},
                             ("b", number[v]): Q(1)} for v in images]))
    for k in range(size):
        weights = {i: a for (part, i), a in basis["a", k].items() if part == "b"}
        section.append(f"unit {k} " + " ".join(f"{i}:{round(a * one)}" for i, a in sorted(weights.items())))
    for v in listed:
        for d, image in enumerate(images[v]):
            weights = {number[w]: round(a * one * scale[v[0]] / scale[w[0]]) for w, a in image.items()}
            section.append(" ".join([f"image {number[v]} {d}"] + [f"{i}:{a}" for i, a in sorted(weights.items())]))
    product = f"product 0 {value} 0 " + " ".join(map(str, word))
    return certificate(mask, divide, sum_rules, lines, product, section, lower, upper)


def box_spline(directions, sum_rules, upper=True, exchange=False):
    """Of the exponent sum_rules - 1, which is the upper end as well where the shifts are stable."""
    n, s = len(directions), len(directions[0])
    scale = {(0,) * s: Q(2**s, 2**n)}
    families = {}
    for chosen in itertools.combinations(range(n), sum_rules):
        name = tuple(sorted(directions[i] for i in chosen))
        rest = [binomial(directions[i], 1) for i in range(n) if i not in chosen]
        families[name] = (name, convolve(scale, *rest), name, Q(1))
    matrix = [[2 * int(i == j) for j in range(s)] for i in range(s)]
    exponent = sum_rules - 1
    return surface(convolve(scale, *(binomial(d, 1) for d in directions)), matrix, sum_rules, families, [0, 1], Q(1, 4**exponent), exponent, exponent if upper else None, exchange)


def turning_hat(s):
    """The tensor product of s hat functions with M e_v = e_(v+1), M e_s = 2 e_1, so that M^s = 2: exponent 1. The
    eigenvalue 1/2 is a multiple one."""
    units = [tuple(int(i == v) for i in range(s)) for v in range(s)]
    minus = tuple(-c for c in units[0])
    matrix = [[2 * int(i == 0 and j == s - 1) + int(i == j + 1) for j in range(s)] for i in range(s)]
    hat = {minus: Q(1, 2), (0,) * s: Q(1), units[0]: Q(1, 2)}
    families = {}
    for chosen in itertools.combinations_with_replacement(range(s), 2):
        # (1 - z_1)(1 + z_1) = 1 - z^(M e_s), and 1 - z_(v+1) = 1 - z^(M e_v)
        b = convolve({minus: Q(1, 2)}, *[binomial(units[0], 1)] * (2 - chosen.count(0)))
        following = tuple(sorted((v - 1) % s for v in chosen))
        families[chosen] = (tuple(units[v] for v in chosen), b, following, 2 ** (-sum(set(chosen)) / s))
    width = Q(1, 10**13)
    return surface(hat, matrix, 2, families, [0] * s, Q(1, 2) + Q(1, 2**100), 1 - width, 1 + width)


def one_variable(mask, sum_rules, size, section, product, lower, upper):
    """A binary mask of one variable as one of several. In the basis of the differences of delta at 0, ..., size - 1 the
    transition matrices are those of section 4.1 of SPEC.md over 2^sum_rules; the section is about these."""
    difference = convolve(*[binomial((1,), -1)] * sum_rules)
    differences = [{add(p, (k,)): a for p, a in difference.items()} for k in range(size)]
    lines, coordinates = space(differences)
    columns = [coordinates(x) for x in differences]
    inverse = dict(eliminate([{**{("a", i): a for i, a in enumerate(column) if a}, ("b", k): Q(1)}
                              for k, column in enumerate(columns)]))
    blocks = [f"blocks {size}"] + ["basis " + " ".join(str(column[i]) for column in columns) for i in range(size)]
    blocks += ["inverse " + " ".join(str(inverse["a", i].get(("b", k), 0)) for i in range(size)) for k in range(size)]
    return certificate(mask, Division([[2]]), sum_rules, lines, product, section, lower, upper, blocks)
