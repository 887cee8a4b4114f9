"""Random questions to the program, over the whole range of what it documents. A generator draws from the
`random.Random` that it is given and from nothing else; what it makes is well formed."""
import json
from dataclasses import dataclass, field
from fractions import Fraction


@dataclass
class Case:
    """One run. `kind` names the judge. `files` are written beside it: name and text."""

    kind: str
    arguments: list
    budget: float
    files: dict = field(default_factory=dict)
    memory: int = 1024  # MiB that the search may hold
    facts: dict = field(default_factory=dict)  # what the oracles need

    @property
    def limits(self):
        return ["--json", "--quiet"] + ([] if self.kind == "mask" else ["--budget", f"{self.budget:g}"])


# ---- schemes of one variable

LETTERS = {  # families with a letter, and where it is of interest
    "four-point": (Fraction(-1), Fraction(1)),
    "six-point": (Fraction(-1, 8), Fraction(1, 8)),
    "dual-four-point": (Fraction(-1, 8), Fraction(1, 8)),
    "j-spline": (Fraction(-3), Fraction(7)),
    "corner-cutting": (Fraction(-1), Fraction(2)),
    "ternary-three-point": (Fraction(-1), Fraction(1)),
    "ternary-four-point": (Fraction(-1), Fraction(1)),
    "conic-four-point": (Fraction(1, 64), Fraction(9)),
    "exponential-six-point": (Fraction(1, 64), Fraction(9)),
    "exponential-bspline": (Fraction(-63, 64), Fraction(9)),
}


def rational(rng, low, high):
    q = rng.choice((1, 2, 8, 64, 100, 333, 10**6, 2**40))
    return low + (high - low) * Fraction(rng.randint(0, 2 * q), 2 * q)


def degree(rng, points):
    return min(rng.choice((0, 1, 1, 1, 2, 3, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12)), points - 1)


def small_or_large(rng, largest):
    """Small as often as large."""
    return rng.randint(1, rng.choice((3, 8, 20, largest)))


def least_squares(rng):
    name, n = rng.choice(("primal", "dual", "primal-odd", "dual-odd")), small_or_large(rng, 60)
    points = {"primal": 2 * n - 1, "dual": 2 * n, "primal-odd": 2 * n, "dual-odd": 2 * n + 1}[name]
    return f"{name}:n={n},d={degree(rng, points)}"


def ary(rng):
    points = rng.randint(2, rng.choice((6, 12, 30)))
    return f"ary:a={rng.randint(2, 7)},points={points},d={degree(rng, points)}"


def with_letter(rng):
    name = rng.choice(sorted(LETTERS))
    return f"{name}:w={rational(rng, *LETTERS[name])}"


def named(rng):
    m = small_or_large(rng, 12)
    n = small_or_large(rng, 20)
    return rng.choice((
        f"dd:n={small_or_large(rng, 20)},a={rng.randint(2, 5)}",
        f"bspline:degree={small_or_large(rng, 60)},a={rng.randint(2, 7)}",
        f"pseudo-spline:m={m},l={rng.randint(0, m - 1)}",
        f"daubechies:n={small_or_large(rng, 30)}",
        f"cdf:n={n},m={n + 2 * rng.randint(-((n - 1) // 2), 4)}",
    ))


def convolution(a, b):
    result = [0] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            result[i + j] += x * y
    return result


def entry(rng, size):
    """A number of a size that a family of numbers has in common."""
    if size == "tiny":
        return Fraction(rng.randint(-9, 9), 10 ** rng.choice((0, 12, 40)))
    if size == "huge":
        return Fraction(rng.randint(-9, 9) * 10 ** rng.choice((0, 6, 40)))
    if size == "sparse" and rng.random() < 0.6:
        return Fraction(0)
    return Fraction(rng.randint(-9, 9), rng.choice((1, 1, 2, 3, 7)) if size == "fractions" else 1)


SIZES = ("plain", "plain", "plain", "fractions", "sparse", "huge", "tiny")


def mask_coefficients(rng):
    """Coefficients with at least one sum rule, and their arity: often divergent, sometimes with unstable shifts."""
    arity, size = rng.choice((2, 2, 2, 2, 3, 3, 4, 5, 7)), rng.choice(SIZES)
    length = rng.randint(1, rng.choice((3, 6, 12, 25)))
    ones = [Fraction(1)] * arity
    if rng.random() < 0.3:  # one sum rule and nothing else
        c = [entry(rng, size) for _ in range(arity * length)]
        for k in range(arity):
            c[k] += 1 - sum(c[k::arity])
        return c, arity
    while True:
        c = [entry(rng, size) for _ in range(length)]
        if rng.random() < 0.3:  # 1 + z^k takes the stability
            c = convolution(c, [Fraction(1)] + [Fraction(0)] * rng.randint(0, 3) + [Fraction(1)])
        if sum(c) != 0:
            break
    for _ in range(rng.randint(1, rng.choice((2, 4, 9)))):
        c = convolution(c, ones)
    total = sum(c)
    return [arity * v / total for v in c], arity


def mask_text(coefficients, arity):
    return f"mask:[{','.join(map(str, coefficients))}],arity={arity}"


def mask(rng):
    return mask_text(*mask_coefficients(rng))


def rounded(rng):
    """A mask with a number that is no fraction."""
    return f"mask:[-t,0,1/2+t,1,1/2+t,0,-t],where=t^2-{rng.choice((2, 3, 5))}/{rng.choice((64, 256))}:0..1"


def regression(rng):
    rules, d = rng.randint(2, 4), rng.randint(0, 3)
    starts = [-rng.randint(0, 4) for _ in range(rules)]
    stencils = ";".join(f"{s}..{s + d + rng.randint(0, 4)}" for s in starts)
    return f"regression:stencils=[{stencils}],at=[{';'.join(str(Fraction(q, rules)) for q in range(rules))}],d={d}"


def curve_scheme(rng):
    kinds = (least_squares, least_squares, ary, with_letter, named, mask, mask, mask, rounded, regression)
    return rng.choice(kinds)(rng)


# ---- schemes of two and three variables

def small_curve_scheme(rng):
    return rng.choice((f"primal:n={rng.randint(1, 6)}", f"dual:n={rng.randint(1, 5)}",
                       f"bspline:degree={rng.randint(1, 5)}", f"dd:n={rng.randint(1, 4)}"))


def mask2(rng):
    """Directions of a box spline times something: sum rules hold as for the box spline."""
    a = {(0, 0): Fraction(1)}
    steps = [(1, 0), (0, 1)] + rng.choices(((1, 0), (0, 1), (1, 1), (1, -1)), k=rng.randint(0, 3))
    for x, y in steps:
        for (i, j), v in list(a.items()):
            a[i + x, j + y] = a.get((i + x, j + y), 0) + v
    extra = {(rng.randint(0, 2), rng.randint(0, 2)): entry(rng, "plain") for _ in range(rng.randint(1, 4))}
    if sum(extra.values()) == 0:
        extra = {(0, 0): Fraction(1)}
    product = {}
    for (i, j), v in a.items():
        for (k, l), w in extra.items():
            product[i + k, j + l] = product.get((i + k, j + l), 0) + v * w
    total = sum(product.values())
    rows = range(min(i for i, _ in product), max(i for i, _ in product) + 1)
    columns = range(min(j for _, j in product), max(j for _, j in product) + 1)
    text = ",".join(f"[{','.join(str(4 * product.get((i, j), 0) / total) for j in columns)}]" for i in rows)
    return f"mask2:[{text}]"


def box(rng):
    directions = ["1,0", "0,1"] + rng.choices(("1,0", "0,1", "1,1", "1,-1", "1,2"), k=rng.randint(0, 4))
    return f"box:[{';'.join(directions)}]{rng.choice(('', '', ',arity=3'))}"


def surface_scheme(rng):
    side = lambda: rng.randint(2, 7)
    return rng.choice((
        lambda: f"grid:points={side()}x{side()},d={rng.choice((0, 1, 1, 2, 3))}",
        lambda: f"grid:points={rng.randint(2, 3)}x{rng.randint(2, 3)}x{rng.randint(2, 3)},d={rng.randint(0, 1)}",
        lambda: f"triangular:L={rng.choice(('4/5', '1', '8/5', '2'))},d=0",
        lambda: f"triangular:L={rng.choice(('8/5', '2', '5/2'))},d=1",
        lambda: f"butterfly:w={rational(rng, Fraction(-1, 8), Fraction(1, 4))}",
        lambda: f"kobbelt:w={rational(rng, Fraction(-1, 8), Fraction(1, 4))}",
        lambda: f"tensor:({small_curve_scheme(rng)})x({small_curve_scheme(rng)})",
        lambda: box(rng), lambda: mask2(rng),
        lambda: rng.choice(("loop", "catmull-clark", "doo-sabin", "sqrt3", "quincunx", "four-eight", "zwart-powell",
                            "midedge")),
    ))()


# ---- matrices

def product(a, b):
    columns = list(zip(*b))
    return [[sum(x * y for x, y in zip(row, column) if x and y) for column in columns] for row in a]


def identity(n):
    return [[int(i == j) for j in range(n)] for i in range(n)]


def elementary(n, i, j, k):
    """The matrix that adds k times row j to row i, and its inverse."""
    there, back = identity(n), identity(n)
    there[i][j], back[i][j] = k, -k
    return there, back


def in_a_bad_basis(rng, family):
    n = len(family[0])
    for _ in range(rng.randint(1, 2 * n) if n > 1 else 0):
        i, j = rng.sample(range(n), 2)
        there, back = elementary(n, i, j, rng.choice((-3, -1, 1, 1, 2)))
        family = [product(product(there, m), back) for m in family]
    return family


def companion(coefficients):
    n = len(coefficients)
    return [[coefficients[j] if i == 0 else int(i == j + 1) for j in range(n)] for i in range(n)]


def with_equal_moduli(rng, n):
    """Permutations with signs, and companions of z^n = +-1 and of cyclotomic polynomials."""
    if rng.random() < 0.5:
        order = rng.sample(range(n), n)
        return [[rng.choice((-1, 1)) if order[i] == j else 0 for j in range(n)] for i in range(n)]
    return companion(rng.choice(([0] * (n - 1) + [1], [0] * (n - 1) + [-1], [-1] * n)))


def triangular_by_blocks(rng, matrices):
    """Zero below a diagonal block that is the same for all."""
    n = len(matrices[0])
    k = rng.randint(1, max(1, n - 1))
    return [[[0 if i >= k > j else m[i][j] for j in range(n)] for i in range(n)] for m in matrices]


def matrix_family(rng):
    n = rng.randint(1, rng.choice((2, 3, 4, 6, 10, 30)))
    count, size = rng.choice((1, 1, 2, 2, 2, 3, 4)), rng.choice(SIZES)
    plain = lambda: [[entry(rng, size) for _ in range(n)] for _ in range(n)]
    nonnegative = rng.random() < 0.25
    family = [with_equal_moduli(rng, n) if rng.random() < 0.2 else plain() for _ in range(count)]
    if nonnegative:
        family = [[[abs(v) for v in row] for row in m] for m in family]
    if rng.random() < 0.2:
        family = triangular_by_blocks(rng, family)
    if rng.random() < 0.3:
        family = in_a_bad_basis(rng, family)
    for chance, more in ((0.1, lambda: [[-v for v in row] for row in family[0]]), (0.1, lambda: family[0]),
                         (0.1, lambda: [[0] * n for _ in range(n)]), (0.05, lambda: identity(n))):
        if rng.random() < chance:
            family.append(more())
    return family


def edges(rng, letters):
    """A graph with at least one edge, which need not have a cycle."""
    nodes = rng.randint(1, 4)
    return [[rng.randrange(nodes), rng.randrange(nodes), rng.randrange(letters)]
            for _ in range(rng.randint(1, 2 * nodes + 1))]


# ---- vectors of functions

def times(a, b):
    return [[sum(x * y for x, y in zip(row, column)) for column in zip(*b)] for row in a]


def refinable_text(family, matrices, first, arity):
    listed = ",".join("[" + ",".join("[" + ",".join(map(str, row)) + "]" for row in m) + "]" for m in matrices)
    return f"{family}:[{listed}]@{first}" + ("" if arity == 2 else f",arity={arity}")


def named_vector(rng):
    order = rng.randint(2, 4)
    degree, mu = rng.randint(2, 6), rational(rng, Fraction(-4), Fraction(2))
    return rng.choice((
        f"merrien:lambda={rational(rng, Fraction(-1, 2), Fraction(1, 4))},mu={mu}",
        f"merrien:lambda=-1/8,mu={mu}",
        f"hermite-dd:points={rng.choice((2, 2, 4))},order={order},a={rng.randint(2, 4)}",
        f"bspline:degree={degree},multiplicity={rng.randint(2, degree)},a={rng.randint(2, 4)}",
        rng.choice(("ghm", "cl:2", "cl:3", "sa4", "bat:1", "bat:2")),
        f"tensor:({rng.choice(('ghm', 'bspline:degree=2,multiplicity=2'))})x(bspline:degree={rng.randint(1, 3)})",
    ))


def vector_basis(rng, size):
    """An invertible matrix of small integers and its inverse."""
    there = back = identity(size)
    for _ in range(rng.randint(1, 3)):
        i, j = rng.sample(range(size), 2)
        step, inverse = elementary(size, i, j, rng.choice((-2, -1, 1, 3)))
        there, back = times(step, there), times(back, inverse)
    return there, back


def random_vector(rng):
    """Any matrices; of some the sums over classes keep a vector."""
    size, arity, numbers = rng.choice((2, 2, 2, 3, 4)), rng.choice((2, 2, 2, 3, 4)), rng.choice(SIZES)
    count = rng.randint(1, rng.choice((3, 5)))
    scale = rng.choice((1, 1, 2, 4, 8))
    matrices = [[[entry(rng, numbers) / scale for _ in range(size)] for _ in range(size)] for _ in range(count)]
    if rng.random() < 0.6 and count >= arity:  # in each class the first column of the sum becomes that of 1
        for k in range(arity):
            for i in range(size):
                matrices[k][i][0] += int(i == 0) - sum(m[i][0] for m in matrices[k::arity])
        matrices = [[list(row) for row in zip(*m)] for m in matrices] if rng.random() < 0.5 else matrices
        there, back = vector_basis(rng, size)
        matrices = [times(times(there, m), back) for m in matrices]
    if not any(v for m in matrices for row in m for v in row):
        matrices[0][0][0] = 1  # zero alone is no mask
    return refinable_text(rng.choice(("refinable", "vector", "hermite")), matrices, rng.randint(-2, 1), arity)


def merrien_matrices(rng):
    l, mu = rational(rng, Fraction(-1, 2), Fraction(1, 4)), rational(rng, Fraction(-4), Fraction(2))
    h = Fraction(1, 2)
    return [[[h, (1 - mu) / 2], [l, mu / 4]], [[1, 0], [0, h]], [[h, (mu - 1) / 2], [-l, mu / 4]]]


def polyphase_matrices(rng):
    """Of the two functions phi(2x), phi(2x - 1) of a mask of numbers."""
    c = [rng.randint(-3, 6) for _ in range(rng.randint(3, 7))]
    for k in range(2):
        c[k] += 1 - sum(c[k::2])
    matrices = [[[0, 0], [0, 0]] for _ in range((len(c) + 3) // 2)]
    for i in range(2):
        for k, v in enumerate(c):
            matrices[(2 * i + k) // 2][i][(2 * i + k) % 2] += v
    return matrices


def twins(rng):
    """Two specifications of functions that span the same space."""
    matrices = rng.choice((merrien_matrices, polyphase_matrices))(rng)
    there, back = vector_basis(rng, 2)
    family = rng.choice(("refinable", "vector"))
    if rng.random() < 0.3:  # two of the same beside each other: several solutions
        matrices = [[[*row, 0, 0] for row in m] + [[0, 0, *row] for row in m] for m in matrices]
        there, back = vector_basis(rng, 4)
    first = rng.randint(-2, 1)
    return (refinable_text(family, [times(times(there, m), back) for m in matrices], first, 2),
            refinable_text(family, matrices, first, 2))


def two_variables(rng):
    size = rng.choice((2, 2, 3))
    row = lambda: "[" + ",".join(str(entry(rng, "plain") / 4) for _ in range(size)) + "]"
    several = lambda part, count: "[" + ",".join(part() for _ in range(count)) + "]"
    return "refinable:" + several(lambda: several(lambda: several(row, size), 2), 2)


def vector_case(rng, low, high):
    scheme = rng.choice((named_vector, named_vector, random_vector, random_vector, random_vector, two_variables))(rng)
    case = Case("vector", ["regularity", scheme], budget(rng, low, high), facts={"scheme": scheme})
    if rng.random() < 0.2:
        scheme, case.facts["twin"] = twins(rng)
        case.arguments[1] = case.facts["scheme"] = scheme
    if rng.random() < 0.4:
        case.arguments += ["--certificate", "proof.cert"]
    elif rng.random() < 0.1:
        case.arguments += ["--component", "2"]
    return case


# ---- vertices of surfaces

def valences(rng):
    """Small ones often, and the regular ones."""
    return sorted({rng.choice((3, 4, 5, 6, 7, 8, rng.randint(3, 40))) for _ in range(rng.randint(1, 3))})


def named_at_vertices(rng):
    return rng.choice((
        lambda: rng.choice(("loop", "catmull-clark", "doo-sabin", "midedge", "modified-butterfly", "sqrt3",
                            "four-eight")),
        lambda: f"butterfly:w={rational(rng, Fraction(-1, 8), Fraction(1, 4))}",
        lambda: f"kobbelt:w={rational(rng, Fraction(-1, 8), Fraction(1, 4))}",
        lambda: f"triangular:L={Fraction(rng.randint(1501, 1732), 1000)},"
                f"d={rng.randint(0, 2)}" + rng.choice(("", f",power={rng.randint(1, 4)}"))))()


def rules_of_vertices(rng):
    """A file with rules, and the letter and number that are in it."""
    b = rng.choice((Fraction(0), Fraction(1), rational(rng, Fraction(-1, 2), Fraction(3, 2)),
                    rational(rng, Fraction(-9), Fraction(9))))
    kind = rng.choice(("loop", "doo-sabin", "catmull-clark", "butterfly"))
    text = f'scheme = "{kind}"\n[[rule]]\n'
    if kind == "loop":  # the vertex moves by b towards the mean of its neighbours
        text += f'weights = {{vertex = "1 - ({b})", neighbours = "({b})/n"}}\n'
    elif kind == "doo-sabin":  # b is the eigenvalue of frequency 1, the others are 1/4
        text += f'weights = {{corner = "1/4", corners = "(3/4 + 2*({b} - 1/4)*C)/n"}}\n'
    elif kind == "catmull-clark":
        part = rational(rng, Fraction(-1), Fraction(1))
        text += f'weights = {{vertex = "1 - ({b}) - ({part})", neighbours = "({b})/n", across = "({part})/n"}}\n'
    else:
        text += (f'valence = "3..5,7.."\npoint = "edge"\n'
                 f'weights = {{vertex = "1 - ({b})", neighbours = "(({b}) + C + (2*C^2 - 1)/2)/n"}}\n')
    return text, kind, b


def vertex_case(rng, low, high):
    case = Case("vertex", ["vertex", "rules.toml"], budget(rng, low, high))
    if rng.random() < 0.5:
        case.arguments[1] = named_at_vertices(rng)
    else:
        case.files["rules.toml"], case.facts["kind"], case.facts["b"] = rules_of_vertices(rng)
    at = valences(rng)
    case.arguments += ["--valence", ",".join(map(str, at))]
    case.facts["beside"] = 4 + len(at)  # the budget is that of the regular part
    case.facts["certificates"] = rng.random() < 0.3
    return case


# ---- cases

def budget(rng, low, high):
    return round(rng.uniform(low, high), 2)


def regularity_case(rng, low, high):
    surface = rng.random() < 0.3
    scheme = (surface_scheme if surface else curve_scheme)(rng)
    case = Case("regularity", ["regularity", scheme], budget(rng, low, high), memory=rng.choice((64, 256, 1024)))
    case.facts = {"scheme": scheme, "surface": surface}
    case.arguments += ["--memory", str(case.memory)]
    if rng.random() < 0.3:
        case.arguments += ["--certificate", "proof.cert"]
    return case


def jsr_case(rng, low, high):
    family = matrix_family(rng)
    graph = edges(rng, len(family)) if rng.random() < 0.2 else None
    content = {"matrices": [[[str(v) for v in row] for row in m] for m in family]}
    if graph:
        content["edges"] = graph
    case = Case("jsr", ["jsr", "family.json"], budget(rng, low, high), {"family.json": json.dumps(content)},
                rng.choice((64, 256, 1024)), {"family": family, "edges": graph})
    case.arguments += ["--memory", str(case.memory)]
    if rng.random() < 0.3:
        case.arguments += ["--certificate", "proof.cert"]
    return case


def mask_with_letter(rng):
    """A symmetric or any mask with a letter whose coset sums are 1 for all its values; value by value the same mask."""
    half = [(Fraction(rng.randint(-4, 4), 8), rng.choice((-1, 0, 0, 1))) for _ in range(rng.randint(2, 5))]
    c = half + half[::-1] if rng.random() < 0.6 else half + half
    for k in range(2):  # the first coefficient of a class makes its sum 1
        rest = c[k::2]
        c[k] = (c[k][0] + 1 - sum(v for v, _ in rest), c[k][1] - sum(w for _, w in rest))
    text = ",".join(f"{v}{'+' if w >= 0 else '-'}{abs(w)}*w" for v, w in c)
    return f"mask:[{text}]", lambda at: mask_text([v + w * at for v, w in c], 2)


def range_case(rng, low, high):
    lowest, between = Fraction(-1), Fraction(0)
    if rng.random() < 0.4:
        name = rng.choice(sorted(LETTERS))
        scheme, at = f"{name}:w", lambda w: f"{name}:w={w}"
        lowest = max(lowest, LETTERS[name][0])  # below it, some masks have a zero in their denominator
        between = max(between, lowest)
    else:
        scheme, at = mask_with_letter(rng)
    start = rational(rng, lowest, between)
    end = between + rational(rng, Fraction(1, 100), Fraction(1))
    asked = rng.choice(("convergent", "convergent", "C1", "C2", "stable", "holder>=1/2", "holder>=3/2"))
    case = Case("range", ["range", scheme, "--over", f"w={start}..{end}", "--property", asked,
                          "--width", rng.choice(("1e-3", "1e-9"))], budget(rng, low, high))
    case.facts = {"at": at, "property": asked, "low": start, "high": end}
    return case


def keeping_vectors(rng, masks):
    """Schemes on vectors of one size that keep the same constant vector, in one basis."""
    size, arity = rng.choice((2, 2, 3)), rng.choice((2, 2, 3))
    there, back = vector_basis(rng, size)
    for _ in range(masks):
        count = rng.randint(arity, arity + 2)
        matrices = [[[entry(rng, "plain") / 8 for _ in range(size)] for _ in range(size)] for _ in range(count)]
        for k in range(arity):
            for i in range(size):
                matrices[k][i][0] += int(i == 0) - sum(m[i][0] for m in matrices[k::arity])
        yield refinable_text("vector", [times(times(there, m), back) for m in matrices], rng.randint(-2, 1), arity)


def list_of_schemes(rng):
    """Of one arity, numbers or matrices of one size."""
    count, kind = rng.randint(1, 3), rng.choice(("merrien", "hermite-dd", "vector", "numbers"))
    if kind == "merrien":
        return [f"merrien:lambda={rng.choice(('-1/8', rational(rng, Fraction(-1, 4), Fraction(1, 8))))},"
                f"mu={rational(rng, Fraction(-3), Fraction(1))}" for _ in range(count)]
    if kind == "hermite-dd":
        order, arity = rng.randint(2, 3), rng.randint(2, 3)
        return [f"hermite-dd:points={rng.choice((2, 2, 4))},order={order},a={arity}" for _ in range(count)]
    if kind == "vector":
        return list(keeping_vectors(rng, count))
    return [rng.choice((f"dd:n={rng.randint(1, 4)}", f"bspline:degree={rng.randint(1, 6)}",
                        f"four-point:w={rational(rng, Fraction(-1, 8), Fraction(1, 4))}")) for _ in range(count)]


def list_case(rng, low, high):
    """Masks in any order, in turn, or so that none comes twice in a row but the first."""
    schemes = list_of_schemes(rng)
    numbers, order = list(range(len(schemes))), rng.choice(("any", "any", "period", "follows"))
    text = "masks = " + json.dumps(schemes) + "\n"
    alone = numbers  # which may be at all levels
    if order == "period":
        period = [rng.choice(numbers) for _ in range(rng.randint(1, 3))]
        text += f"period = {period}\n"
        alone = period[:1] if len(set(period)) == 1 else []
    elif order == "follows":
        text += f"follows = {[[i, j] for i in numbers for j in numbers if i != j or i == 0]}\n"
        alone = [0]
    if order == "period" and rng.random() < 0.4:
        limit = ["limit", "lists:list.toml", "--level", str(rng.randint(0, 4))]
        hermite = schemes[0].startswith(("merrien", "hermite-dd"))
        return Case("limit", limit, budget(rng, low, high), {"list.toml": text},
                    facts={"hermite": hermite})
    case = Case("levels", ["levels", "lists:list.toml"], budget(rng, low, high), {"list.toml": text})
    case.facts = {"alone": [schemes[k] for k in alone], "one": len({schemes[k] for k in alone}) == 1 and
                  (order == "period" or len(set(schemes)) == 1)}
    return case


def page_case(rng, low, high):
    command = rng.choice(("analyze", "variance", "limit", "limit --range", "mask"))
    surface = command in ("analyze", "limit", "mask") and rng.random() < 0.3
    scheme = (surface_scheme if surface else curve_scheme)(rng)
    case = Case(command, [*command.split(), scheme], budget(rng, low, high), facts={"scheme": scheme})
    if command == "limit" and not surface:
        case.arguments += ["--level", str(rng.randint(0, 5))]
    return case


def any_case(rng, low, high):
    kinds = (regularity_case, vector_case, jsr_case, range_case, list_case, page_case, vertex_case)
    return rng.choices(kinds, (36, 14, 22, 8, 8, 12, 8))[0](rng, low, high)
