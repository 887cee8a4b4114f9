#!/usr/bin/env python3
"""Makes the certificates of the corpus for families whose radius is known by hand.

Usage: make_certificates.py OUTPUT_DIRECTORY

Shares no code with the checker or the engine. The polytopes are found by the plain invariant polytope algorithm; norms of
points by trying all bases of vertices, which is fine for a handful of vertices in dimension up to 4.
"""
import itertools
import math
import re
import sys
from fractions import Fraction as Q
from pathlib import Path

import attains_cases
import convergence_cases
import cycle_cases
import edge_cases
import field_cases
import frequency_cases
import graph_cases
import l1_cases
import level_cases
import make_surfaces
import not_c1_cases
import single_cases
import stability_cases
import subradius_cases
import subradius_exact_cases
import variant_cases
import vector_cases
import vector_list_cases
import vector_range_cases
import vertex_cases
import vertex_fit_cases
import vertex_variant_cases
import vertices_cases

BITS = 64
ONE = 1 << BITS


def multiply(a, b):
    return [[sum(x * y for x, y in zip(row, column)) for column in zip(*b)] for row in a]


def apply(a, x):
    return [sum(c * y for c, y in zip(row, x)) for row in a]


def solve(columns, x):
    """Solves sum_k lambda_k columns[k] = x by Gauss elimination in floats; None if singular."""
    n = len(x)
    m = [[float(columns[k][i]) for k in range(n)] + [float(x[i])] for i in range(n)]
    for c in range(n):
        pivot = max(range(c, n), key=lambda i: abs(m[i][c]))
        if abs(m[pivot][c]) < 1e-9:
            return None
        m[c], m[pivot] = m[pivot], m[c]
        for i in range(n):
            if i != c:
                f = m[i][c] / m[c][c]
                m[i] = [p - f * q for p, q in zip(m[i], m[c])]
    return [m[i][n] / m[i][i] for i in range(n)]


def best_combination(points, x):
    """The basis of points (label, coordinates) with the least 1-norm for x."""
    best = None
    for basis in itertools.combinations(points, len(x)):
        weights = solve([p for _, p in basis], x)
        if weights is not None and (best is None or sum(map(abs, weights)) < best[0]):
            best = (sum(map(abs, weights)), [(label, w) for (label, _), w in zip(basis, weights)])
    return best


def transition(mask, arity, m):
    """The family of section 4.1 of SPEC.md, by polynomial long division in Fractions."""
    b = list(mask)
    for _ in range(m):
        quotient = []
        rest = list(b)
        while len(rest) >= arity:
            q = rest[0]
            quotient.append(q)
            rest = [r - q if i < arity else r for i, r in enumerate(rest)][1:]
        assert not any(rest)
        b = [arity * q for q in quotient]
    n = len(b) - 1
    w = max(1, -(-n // (arity - 1)))
    at = lambda i: b[i] if 0 <= i <= n else Q(0)
    return [[[at(arity * j + t - k) for k in range(w)] for j in range(w)] for t in range(arity)]


def leading(matrix):
    """Real leading eigenvalue and eigenvector by power iteration."""
    x = [1.0, 0.7, 0.45, 0.3, 0.2][: len(matrix)]
    for _ in range(4000):
        y = apply(matrix, x)
        value = max(y, key=abs)
        x = [v / value for v in y]
    return value, x


def newton(matrix, value):
    """Improves a real simple eigenvalue to about 200 bits: Newton on det(value - matrix), in Fractions."""
    def determinant(x):
        n = len(matrix)
        m = [[(x if i == j else 0) - matrix[i][j] for j in range(n)] for i in range(n)]
        result = Q(1)
        for c in range(n):
            pivot = next((i for i in range(c, n) if m[i][c] != 0), None)
            if pivot is None:
                return Q(0)
            if pivot != c:
                m[c], m[pivot] = m[pivot], m[c]
                result = -result
            result *= m[c][c]
            for i in range(c + 1, n):
                f = m[i][c] / m[c][c]
                m[i] = [p - f * q for p, q in zip(m[i], m[c])]
        return result
    value = Q(value)
    for _ in range(4):
        step = Q(1, 1 << 60)
        f = determinant(value)
        slope = (determinant(value + step) - determinant(value - step)) / (2 * step)
        if f == 0:
            break
        value = Q(round((value - f / slope) * (1 << 200)), 1 << 200)
    return value


def polytope(family, word, symmetric, limit=14, others=(), turned=False):
    """Lines of a real polytope section for the product of the word (as matrices, left to right). `others`: more vertices;
    `turned`: half of the word and a flip lead back to the first one."""
    n = len(family[0])
    product = family[word[0]]
    for t in word[1:]:
        product = multiply(product, family[t])
    value, x = leading([[float(c) for c in row] for row in product])
    rho = abs(value) ** (1 / len(word))
    vertices = [x]
    for t in [] if turned else list(reversed(word))[:-1]:
        x = [v / rho for v in apply([[float(c) for c in row] for row in family[t]], x)]
        vertices.append(x)
    vertices += [list(map(float, v)) for v in others]
    normal = lambda v: [round(c * ONE) for c in v]
    points = lambda: [(f"{j}", v) for j, v in enumerate(vertices)] + (
        [(f"{j}f", v[::-1]) for j, v in enumerate(vertices)] if symmetric else [])
    done = 0
    while done < len(vertices):
        for matrix in family:
            y = [float(v) / rho for v in apply(matrix, vertices[done])]
            if others and any(max(abs(a - b) for a, b in zip(x, y)) < 1e-12 for x in vertices):
                continue
            best = best_combination(points(), y)
            if best is None or best[0] > 1 + 1e-12:
                vertices.append(y)
                assert len(vertices) <= limit, "did not close"
        done += 1
    exact = [[Q(c, ONE) for c in normal(v)] for v in vertices]
    vertices = exact
    lines = [f"block 0 polytope {len(vertices)} {BITS} {BITS}" + (" symmetric" if symmetric else "")]
    lines += ["vertex " + " ".join(map(str, normal(v))) for v in vertices]
    terms = lambda best: "".join(f" {label}:{round(w * ONE)}" for label, w in best[1] if round(w * ONE) != 0)
    for k in range((n + 1) // 2 if symmetric else n):
        lines.append(f"unit {k}" + terms(best_combination(points(), [Q(int(i == k)) for i in range(n)])))
    for j, v in enumerate(vertices):
        for t, matrix in enumerate(family):
            y = apply(matrix, v)
            lines.append(f"image {j} {t}" + (terms(best_combination(points(), y)) if any(y) else ""))
    return lines, newton(product, value), rho


def inverse_lines(matrix, re, im=Q(0), bits=160):
    """The columns of the inverse of re + i im - matrix over 2^bits, by elimination in Fractions, with the line `inverse`."""
    n = len(matrix)
    real = [[(re if i == j else 0) - matrix[i][j] for j in range(n)] for i in range(n)]
    whole = [[*row, *(-im if i == j else Q(0) for j in range(n))] for i, row in enumerate(real)]
    whole += [[*(im if i == j else Q(0) for j in range(n)), *row] for i, row in enumerate(real)]
    m = [[*row, *(Q(i == k) for k in range(n))] for i, row in enumerate(whole)]
    for c in range(2 * n):
        pivot = next(i for i in range(c, 2 * n) if m[i][c] != 0)
        m[c], m[pivot] = m[pivot], m[c]
        m[c] = [x / m[c][c] for x in m[c]]
        for i in range(2 * n):
            if i != c and m[i][c] != 0:
                m[i] = [x - m[i][c] * y for x, y in zip(m[i], m[c])]
    rows = range(2 * n if im else n)
    return [f"inverse {bits}"] + [f"column {k} " + " ".join(str(round(m[i][2 * n + k] * (1 << bits))) for i in rows)
                                  for k in range(n)]


def with_inverse(case, matrix, re, im=Q(0)):
    """The case with a product line for the eigenvalue re + i im and the inverse for it."""
    arguments, lines = case
    place = next(i for i, line in enumerate(lines) if line.startswith("product"))
    letters = lines[place].split(" ", 4)[4]
    return arguments, [*lines[:place], f"product 0 {re} {im} {letters}", *inverse_lines(matrix, re, im), *lines[place + 1:]]


def root_of(p, centre, length):
    """A zero of the polynomial, by Newton's method from the centre, and the line `root`, for a real zero."""
    x, one = Q(centre), 1 << 300
    value = lambda q: sum(c * x**k for k, c in enumerate(q))
    slope = [k * c for k, c in enumerate(p)][1:]
    for _ in range(12):
        x = Q(round((x - value(p) / value(slope)) * one), one)
    error = (len(p) - 1) * abs(value(p) / value(slope))
    error = Q(math.ceil(error * one * one), one * one)
    bits = 300
    low = Q(integer_root(math.floor((abs(x) - error) * (1 << bits * length)), length), 1 << bits)
    high = Q(integer_root(math.floor((abs(x) + error) * (1 << bits * length)), length) + (1 if error or low**length != abs(x) else 0), 1 << bits)
    return f"root {x} 0 {error} {low} {high}", float(low)


def integer_root(x, k):
    low, high = 0, 1 << (x.bit_length() // k + 1)
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if middle**k <= x else (low, middle)
    return low


def seed_of(p, family, word, letters):
    """A vector on which the polynomial of the product vanishes: the letters in their order, then the flip, if there is a
    word."""
    n = len(family[0])
    def product(x):
        for t in letters:
            x = apply(family[t], x)
        return x[::-1] if word == "f" else x
    columns = []
    for i in range(n):
        x, value = [Q(int(k == i)) for k in range(n)], [Q(0)] * n
        for c in p:
            value, x = [v + c * y for v, y in zip(value, x)], product(x)
        columns.append(value)
    # elimination: the first column that depends on those before
    pivots = []
    for i in range(n):
        value, combination = columns[i], [Q(int(k == i)) for k in range(n)]
        for row, other, used in pivots:
            f = value[row] / other[row]
            value, combination = [a - f * b for a, b in zip(value, other)], [a - f * b for a, b in zip(combination, used)]
        row = next((k for k in range(n) if value[k] != 0), None)
        if row is None:
            common = math.lcm(*(c.denominator for c in combination))
            return [int(c * common) for c in combination]
        pivots.append((row, value, combination))
    assert False, "the polynomial vanishes nowhere"


def exactly(case, family, before, p, centre, within, cycles, block=0, im=0, root=None):
    """The case with the lines that say what the radius is: |z|^(1/L), z the zero of p near the centre. `cycles`: first
    vertices, words, letters and seeds; `before`: M-log, or nothing. Origins and the images that are vertices are found by
    their coordinates."""
    arguments, lines = case
    length = len(cycles[0][2])
    exact = f"{before}|[{','.join(map(str, p))}]@{centre},{im},{within}|^1/{length}"
    root, r = root or root_of(p, centre, length)
    start = next(i for i, line in enumerate(lines) if line.startswith(f"block {block} "))
    end = next(i for i in range(start + 1, len(lines)) if lines[i].split()[0] in ("block", "end", "sum-rules"))
    words = lines[start].split()
    bits, flips = int(words[4]), "symmetric" in words
    below = "nonnegative" in words
    numbers = [[int(x) / 2.0**bits for x in line.split()[1:]] for line in lines[start:end] if line.startswith("vertex")]
    half = len(numbers[0]) // (2 if "complex" in words else 1)
    vertices = [[complex(x, y) for x, y in zip(v, v[half:] or [0.0] * half)] for v in numbers]
    near = lambda x, y: max(abs(a - b) for a, b in zip(x, y)) < 1e-12
    turned = lambda x: [("", x)] + ([("f", x[::-1])] if flips else [])
    images = {(j, t): [c / r for c in apply(m, v)] for j, v in enumerate(vertices) for t, m in enumerate(family)}
    more, origins, known = [], {}, set()
    for first, word, letters, seed in cycles:
        more += [f"cycle {first} {word} " + " ".join(map(str, letters)), "seed " + " ".join(map(str, seed))]
    firsts = [first for first, *_ in cycles]
    for k in range(len(vertices)):
        for (j, t), image in images.items():
            if k not in firsts and k not in origins and j < k and near(image, vertices[k]):
                origins[k] = (j, t)
    more += [f"origin {k} {j} {t}" for k, (j, t) in origins.items()]
    for first, word, letters, _ in cycles:
        at = first
        for t in letters[:-1]:
            at = next(k for k, origin in origins.items() if origin == (at, t))
        known.add((at, letters[-1]))
    for key, image in images.items():
        if key in known or key in origins.values():
            continue
        for k, v in enumerate(vertices):
            for word, x in turned(v):
                if near(image, x) or near(image, [-c for c in x]) or (
                        below and all(a.real < b.real + 1e-12 for a, b in zip(image, x))):
                    more.append(f"same {key[0]} {key[1]} {k}{word}")
                    break
            else:
                continue
            break
    bounds = next(i for i, line in enumerate(lines) if line.startswith("bounds")) + 1
    return [*arguments, "--exact", exact], [
        *lines[:bounds], f"exact {exact}", root, *lines[bounds:end], *more, *lines[end:]]


def exponent(mask_text, mask, arity, m, word, symmetric, stability=True, section=None):
    family = transition(mask, arity, m)
    lines, value, rho = polytope(family, word, symmetric)
    s = m - math.log(rho, arity)
    near = Q(round(s * 10**15), 10**15)
    lower, upper = near - Q(1, 10**13), near + Q(1, 10**13)
    if abs(s - round(s)) < 1e-14:
        lower = upper = Q(round(s))
    head = ["subcert-certificate 3", f"exponent {mask_text} {arity}", f"bounds {lower} {upper}", f"sum-rules {m}"]
    head += ["stability"] if stability else []
    head += [f"product 0 {value} 0 " + " ".join(map(str, word))]
    return ["--mask", mask_text, "--arity", str(arity), "--lower", str(lower), "--upper", str(upper)], \
        head + (section or lines) + ["end"]


def radius(name, family, word, symmetric, width=Q(1, 10**13)):
    lines, value, rho = polytope(family, word, symmetric)
    near = Q(round(rho * 10**15), 10**15)
    lower, upper = near - width, near + width
    head = ["subcert-certificate 3", f"radius {len(family)} {len(family[0])}", f"bounds {lower} {upper}",
            f"product 0 {value} 0 " + " ".join(map(str, word))]
    return ["--matrices", name, "--lower", str(lower), "--upper", str(upper)], head + lines + ["end"]


def as_group(lines):
    """The flip of two coordinates as a generator of a group; then all units have lines."""
    text = re.sub(r"(\d)f:", r"\1A:", "\n".join(lines))
    text = re.sub(r"^(same .*|cycle \d+ )f", r"\1A", text, flags=re.M).replace(" symmetric", " group:1\ngenerator 1 0\nmap 0 1\nmap 1 0")
    unit = re.search("^unit 0.*\n", text, re.M)[0]
    mirrored = re.sub(r"(\d)(A?):", lambda m: m[1] + ("" if m[2] else "A") + ":", unit.replace("unit 0", "unit 1"))
    return text.replace(unit, unit + mirrored).split("\n")


def power_mask(factor, k, scale):
    mask = [Q(1)]
    for _ in range(k):
        mask = [sum(mask[i - j] for j in range(factor) if 0 <= i - j < len(mask)) for i in range(len(mask) + factor - 1)]
    return [Q(c, scale) for c in mask]


def level(mask, m, low, high, bound):
    """The least level at which the 1-norms of products of control matrices show JSR < bound; a mask of arity 2 whose
    coefficients are lists of the coefficients of w^0, w^1, ..."""
    degree = max(map(len, mask)) - 1
    at = lambda w: transition([sum((c * w**k for k, c in enumerate(p)), Q(0)) for p in mask], 2, m)
    nodes = [at(low + (high - low) * Q(i, max(degree, 1))) for i in range(degree + 1)]
    if degree == 2:  # the middle value is (c_0 + 2 c_1 + c_2) / 4
        nodes[1] = [[[2 * y - (x + z) / 2 for x, y, z in zip(*rows)] for rows in zip(*ms)] for ms in zip(*nodes)]
    controls = [matrix for node in nodes for matrix in node]
    products, found = controls, 1
    while max(sum(map(abs, column)) for p in products for column in zip(*p)) >= bound**found:
        products, found = [multiply(p, c) for p in products for c in controls], found + 1
        assert found < 8
    return found


def opposite(lines, vertex):
    """The lines of a real section with the opposite of a vertex in its place."""
    place = [i for i, line in enumerate(lines) if line.startswith("vertex")][vertex]
    result = []
    for i, line in enumerate(lines):
        words = line.split(" ")
        negated = words[0] == "image" and words[1] == str(vertex)
        for k, word in enumerate(words[1:], 1):
            index, colon, weight = word.rpartition(":")
            if i == place or (colon and (index == str(vertex)) != negated):
                words[k] = f"{index}{colon}{-int(weight)}"
        result.append(" ".join(words))
    return result


def edited(lines, edits):
    """The lines after replacements, each of which is made once."""
    whole = "\n".join(lines) + "\n"
    for old, new in edits:
        assert old in whole, old
        whole = whole.replace(old, new, 1)
    return whole.split("\n")[:-1]


def text(mask):
    return "[" + ",".join(map(str, mask)) + "]"


def main(out):
    out.mkdir(parents=True, exist_ok=True)
    cases, made = [], {}  # the lines of claims.txt, and all by their names

    def write(name, case):
        arguments, lines = case
        (out / f"{name}.cert").write_text("\n".join(lines) + "\n")
        cases.append(f"{name} " + " ".join(arguments))
        made[name] = case

    def write_matrices(name, family):
        rows = [f"matrices {len(family)} {len(family[0])}"] + ["row " + " ".join(map(str, row)) for m in family for row in m]
        (out / name).write_text("\n".join(rows) + "\n")

    for d in (1, 2, 3, 5):  # B-splines: exponent d
        mask = power_mask(2, d + 1, 2**d)
        write(f"bspline-{d}", exponent(text(mask) + f"@{-d}", mask, 2, d + 1, [0], False))
    mask = power_mask(3, 3, 9)
    write("bspline-ternary", exponent(text(mask), mask, 3, 3, [0], False))
    dd4 = [Q(c, 16) for c in (-1, 0, 9, 16, 9, 0, -1)]  # exponent 2, a logarithmic factor
    write("four-point", exponent("[-1,0,9,16,9,0,-1]/16@-3", dd4, 2, 4, [0], True))
    case = exponent("[-1,0,9,16,9,0,-1]/16@-3", dd4, 2, 4, [0], True, section=["block 0 norm 1"])
    write("four-point-norm", case)
    hand = ["block 0 polytope 1 0 0 symmetric", "vertex 0 1", "unit 0 0f:1", "image 0 0 0:4", "image 0 1 0:-1 0f:-1"]
    write("four-point-by-hand", exponent("[-1,0,9,16,9,0,-1]/16@-3", dd4, 2, 4, [0], True, section=hand))  # SPEC.md, section 3
    w = Q(1, 20)  # exponent 2 - log2(1 + sqrt(1 - 16 w)) = 1.466...
    tension = [-w, Q(0), Q(1, 2) + w, Q(1), Q(1, 2) + w, Q(0), -w]
    write("tension", exponent(text(tension) + "@-3", tension, 2, 2, [0], True))
    dual = [Q(c, 128) for c in (-5, -7, 35, 105, 105, 35, -7, -5)]  # 2.830074998558
    write("dual-four-point", exponent("[-5,-7,35,105,105,35,-7,-5]/128@-4", dual, 2, 5, [0], True))

    golden = [[[Q(1), Q(1)], [Q(0), Q(1)]], [[Q(1), Q(0)], [Q(1), Q(1)]]]  # radius (1 + sqrt 5)/2
    write_matrices("golden.mat", golden)
    write("golden", radius("golden.mat", golden, [0, 1], False))
    write("golden-symmetric", radius("golden.mat", golden, [0, 1], True))
    arguments, lines = radius("golden.mat", golden, [0, 1], False)
    phi = math.isqrt(5 * ONE * ONE)
    phi = (ONE + phi) // 2 + 1
    arguments, lines = radius("golden.mat", golden, [0, 1], True)
    write("golden-group", (arguments, as_group(lines)))
    arguments, lines = radius("golden.mat", golden, [0, 1], False)
    two = ["block 0 polytope 1 64 64 nonnegative symmetric", f"vertex {phi} {ONE}", f"unit 0 0:{ONE}",
           f"image 0 0 0:{phi + 2}", f"image 0 1 0f:{phi + 2}"]
    write("golden-nonnegative", (arguments, lines[:4] + two + ["end"]))
    swap = [[[row[c] for row in m] for c in range(2)] for m in golden]
    section = polytope(swap, [0, 1], False)[0]
    write("golden-transposed", (arguments, lines[:4] + [section[0] + " transposed"] + section[1:] + ["end"]))

    # golden pair and the scalars 3/2, -1 in a skew basis: two diagonal blocks
    basis = [[Q(1), Q(2), Q(0)], [Q(0), Q(1), Q(1, 2)], [Q(1), Q(0), Q(1)]]
    columns = [solve([list(c) for c in zip(*basis)], [float(i == k) for i in range(3)]) for k in range(3)]
    inverse = [[Q(columns[k][i]).limit_denominator(100) for k in range(3)] for i in range(3)]
    assert multiply(basis, inverse) == [[Q(int(i == k)) for k in range(3)] for i in range(3)]
    blocks = [[[*golden[t][0], Q(5)], [*golden[t][1], Q(-7, 3)], [Q(0), Q(0), (Q(3, 2), Q(-1))[t]]] for t in range(2)]
    write_matrices("blocks.mat", [multiply(multiply(basis, m), inverse) for m in blocks])
    split = ["blocks 2 1"] + [f"{head} " + " ".join(map(str, row)) for head, matrix in
                              (("basis", basis), ("inverse", inverse)) for row in matrix]
    write("blocks", (["--matrices", "blocks.mat"] + arguments[2:], ["subcert-certificate 3", "radius 2 3", lines[2]] + split +
                     lines[3:-1] + ["block 1 norm 3", "end"]))

    # a rotation by an angle with cosine 3/5 and half of it: radius exactly 1, complex leading eigenvalue
    turn = [[[Q(3, 5), Q(-4, 5)], [Q(4, 5), Q(3, 5)]], [[Q(3, 10), Q(-2, 5)], [Q(2, 5), Q(3, 10)]]]
    write_matrices("rotation.mat", turn)
    tenth, unit = 1 << 62, 1 << 64
    re, im = 3 * unit // 5, 4 * unit // 5
    width = Q(1, 10**15)
    rotation = ["subcert-certificate 3", "radius 2 2", f"bounds {1 - width} {1 + width}", "product 0 3/5 4/5 0",
                "block 0 polytope 1 0 64 complex", "vertex 1 0 0 -1", f"unit 0 0:{unit // 2}:0 0c:{unit // 2}:0",
                f"unit 1 0:0:{unit // 2} 0c:0:{-unit // 2}", f"image 0 0 0:{re}:{im}",
                f"image 0 1 0:{re // 2}:{im // 2}", "end"]
    write("rotation", (["--matrices", "rotation.mat", "--lower", str(1 - width), "--upper", str(1 + width)], rotation))

    # quadratic forms: the rotations are isometries; the golden pair has norms just above its radius in the unit form
    def by_form(case, name, words, bound, form, group=(), **claim):
        arguments, lines = case
        head = f"block 0 quadratic {len(words)} {bound}" + (" group:1" if group else "")
        section = [head, *group, *form, *(f"word {word}" for word in words)]
        for option, value in claim.items():
            arguments = arguments[:arguments.index(f"--{option}") + 1] + [value] + arguments[arguments.index(f"--{option}") + 2:]
        start = next(i for i, line in enumerate(lines) if line.startswith("block 0"))
        write(name, (arguments, lines[:start] + section + ["end"]))

    unit_form, exchange = ["form 1", "form 0 1"], ["generator 1 0", "map 0 1", "map 1 0"]
    turns = (["--matrices", "rotation.mat", "--lower", "1", "--upper", "1"], rotation)
    by_form(turns, "rotation-quadratic", ["0", "1"], 1, unit_form)  # upper end 1, as S_0 = 0
    # that is what the radius is, too, without an end; also by a longer word
    one = "|[-1,1]@1,0,1/1000|^1/1"
    numbered = ["--matrices", "rotation.mat", "--exact", one], [
        *rotation[:2], "bounds - -", f"exact {one}", "root 1 0 0 1 1", *rotation[4:]]
    by_form(numbered, "rotation-quadratic-exact", ["0", "1"], 1, unit_form)
    by_form(numbered, "rotation-quadratic-exact-word", ["1", "0 1", "0 0"], 1, unit_form)
    golden_case = radius("golden.mat", golden, [0, 1], False)
    by_form(golden_case, "golden-quadratic", ["0 0", "0 1", "1"], "16181/10000", unit_form, upper="16181/10000")
    by_form(golden_case, "golden-quadratic-group", ["0 0 0", "0 0 1", "0 1"], "16181/10000", unit_form, exchange,
            upper="16181/10000")
    write_matrices("twice.mat", [golden[0], golden[1], golden[0]])
    twice = golden_case[0][:1] + ["twice.mat"] + golden_case[0][2:], [
        line.replace("radius 2", "radius 3") for line in golden_case[1]]
    by_form(twice, "twice-quadratic", ["1", "2"], "16181/10000", unit_form, upper="16181/10000")
    case = exponent("[-1,0,9,16,9,0,-1]/16@-3", dd4, 2, 4, [0], True)
    by_form(case, "four-point-quadratic", ["0", "1"], "4131/1000", unit_form, lower="39/20")

    # a parameter: sections of intervals, and the order of the sum rules
    def over(name, mask, parameter, m, lower, upper, stable, *sections, kind="exponent", option="--for"):
        bounds = [f"--{end} {value}" for end, value in (("lower", lower), ("upper", upper)) if value is not None]
        write(name, (["--mask", mask, "--arity", "2", option, parameter, *bounds], [
            "subcert-certificate 3", f"{kind} {mask} 2 {parameter}",
            f"bounds {'-' if lower is None else lower} {'-' if upper is None else upper}", f"sum-rules {m}",
            *(["stability"] if stable else []), *(line for section in sections for line in section), "end"]))

    corner = "[w,1-w,1-w,w]"  # SPEC.md, section 6.6
    over("corner-converges", corner, "w=1/100..49/100", 1, 0, None, False, ["to 49/100", "block 0 norm 1"])
    over("corner-not-smooth", corner, "w=1/10..1/5", 1, None, 1, True, ["to 1/5", "product 0 11/10 0 0"])
    over("corner-diverges", corner, "w=-2..-1/10", 1, None, 0, False, ["to -1", "product 0 5 0 0"],
         ["to -1/10", "product 0 11/5 0 1"])
    over("corner-stable", corner, "w=-1..499/1000", 1, None, None, True)
    # one sum rule but for w = 1/4
    over("corner-rough", corner, "w=3/10..2/5", "1 full", None, "C1", True)
    over("corner-rough-converges", corner, "w=3/10..2/5", "1 full", 0, "C2", True, ["to 2/5", "block 0 norm 1"])
    over("corner-full", corner, "w=3/10..2/5", "1 full", 0, "1000001/1000000", True, ["to 2/5", "block 0 norm 1"])
    write("hat-full", (["--mask", "[1,2,1]/2@-1", "--arity", "2", "--lower", "1", "--upper", "2"], [
        "subcert-certificate 3", "exponent [1,2,1]/2@-1 2", "bounds 1 2", "sum-rules 2 full", "stability", "block 0 norm 1", "end"]))
    write("hat-rough", (["--mask", "[1,2,1]/2@-1", "--arity", "2", "--upper", "C2"], [
        "subcert-certificate 3", "exponent [1,2,1]/2@-1 2", "bounds - C2", "sum-rules 2 full", "stability", "end"]))
    write("chaikin-rough", (["--mask", "[1,3,3,1]/4", "--arity", "2", "--upper", "C3"], [
        "subcert-certificate 3", "exponent [1,3,3,1]/4 2", "bounds - C3", "sum-rules 3 full", "stability", "end"]))
    # shifts not stable; SPEC.md, section 4.9
    def reduced(name, mask, factor, other, exponent, own, *more, upper=None):
        write(name, (["--mask", mask, "--arity", "2", "--lower", f"{exponent}", "--upper", upper or f"{exponent}"], [
            "subcert-certificate 3", f"exponent {mask} 2", f"bounds {exponent} {upper or exponent}", f"reduced {factor} {other}",
            f"sum-rules {exponent + 1}{' full' if upper else ''}", "stability", *([] if upper else ["product 0 2 0 0"]),
            "block 0 norm 1", f"sum-rules {own}", *more, "end"]))

    reduced("trapezoid-reduced", "[1,1,1,1]/2", "[1,1]", "[1,2,1]/2", 1, 1, "block 0 norm 2")
    reduced("spline-reduced", "[1,3,3,2,3,3,1]/8@-3", "[1,1,1]", "[1,4,6,4,1]/8", 3, 4, "block 0 norm 1")
    reduced("trapezoid-rough", "[1,1,1,1]/2", "[1,1]", "[1,2,1]/2", 1, 1, "block 0 norm 2", upper="C2")
    ends = [Q(1, 50), Q(1, 10), Q(4, 25)]
    four = [[Q(0), Q(-1)], [Q(0)], [Q(1, 2), Q(1)], [Q(1)], [Q(1, 2), Q(1)], [Q(0)], [Q(0), Q(-1)]]
    over("four-point-range", "[-w,0,1/2+w,1,1/2+w,0,-w]@-3", f"w={ends[0]}..{ends[-1]}", 2, 1, None, False, *(
        [f"to {high}", f"block 0 norm {level(four, 2, low, high, 2)}"] for low, high in zip(ends, ends[1:])))
    over("four-point-diverges", "[-w,0,1/2+w,1,1/2+w,0,-w]@-3", "w=3/5..1", 2, None, 0, False, ["to 1", "product 0 41/10 0 0"])
    # a value for each level: SPEC.md, section 6.5
    levels = {"kind": "levels", "option": "--levels"}
    over("corner-levels", corner, "w=1/100..49/100", 1, 0, None, False, ["to 49/100", "block 0 norm 1"], **levels)
    over("corner-levels-half", corner, "w=1/5..3/10", 1, "1/2", None, True, ["to 3/10", "block 0 norm 1"], **levels)
    over("four-point-levels", "[-w,0,1/2+w,1,1/2+w,0,-w]@-3", "w=1/50..1/10", 2, 1, None, False,
         ["to 1/10", f"block 0 norm {level(four, 2, ends[0], Q(1, 10), 2)}"], **levels)
    square = [[Q(0), Q(0), Q(1)], [Q(1, 2)], [Q(1), Q(0), Q(-2)], [Q(1, 2)], [Q(0), Q(0), Q(1)]]
    over("square-range", "[w^2,1/2,1-2*w^2,1/2,w^2]@-2", "w=1/5..2/5", 2, 1, None, True, *(
        [f"to {high}", f"block 0 norm {level(square, 2, low, high, 2)}"]
        for low, high in ((Q(1, 5), Q(1, 4)), (Q(1, 4), Q(2, 5)))))
    # corner cutting with w = 1/(1 + v), where 1 + v is positive and where it is negative
    quotient = "[1,v,v,1]/(1+v)"
    over("quotient-converges", quotient, "v=3/2..9", 1, 0, None, False, ["to 9", "block 0 norm 1"])
    over("quotient-not-smooth", quotient, "v=4..9", 1, None, 1, True, ["to 9", "product 0 11/10 0 0"])
    over("quotient-rough", quotient, "v=7/2..9", "1 full", None, "C1", True)
    over("quotient-diverges", quotient, "v=-9..-3", 1, None, 0, False, ["to -3", "product 0 2 0 1"])
    over("quotient-stable", quotient, "v=-100..-11/10", 1, None, None, True)
    # 1/q and (q - 1)/q for the halves; on both intervals together a coefficient of q = (v - 1)^2 + 1/100 is negative
    over("quotient-square", "[1,101/100-2*v+v^2,1/100-2*v+v^2]/(101/100-2*v+v^2)",
         "v=1/2..3/2", 1, None, 0, False, ["to 1", "product 0 2 0 0"], ["to 3/2", "product 0 2 0 0"])
    # b = 2a/(1+z) = (-w, 1, 1, w): T_0 has a pair of eigenvalues with the product 1 + w^2
    over("pair", "[-1/2*w,1/2-1/2*w,1,1/2+1/2*w,1/2*w]", "w=1..2", 1, None, Q(13, 25), True, ["to 2", "product 0 0 7/5 0"])

    # what the radius is: SPEC.md, section 4.10
    four = exponent("[-1,0,9,16,9,0,-1]/16@-3", dd4, 2, 4, [0], True, section=hand)
    family = transition(dd4, 2, 4)
    write("four-point-exact", exactly(four, family, "4-log", [-4, 1], 4, 1, [(0, "-", [0], [0, 1])], root=("root 4 0 0 4 4", 4)))
    fibonacci = [-1, -1, 1]
    slow = [golden[0], [[Q(9, 10) * x for x in row] for row in golden[1]]]
    write_matrices("slow.mat", slow)
    square = [81, -270, 100]
    plain = radius("slow.mat", slow, [0, 1], False)
    write("slow-exact", exactly(plain, slow, "", square, "47/20", "1/10", [(0, "-", [1, 0], [1, 0])]))
    cone = exactly((golden_case[0], golden_case[1][:4] + two + ["end"]), golden, "", fibonacci, "8/5", "1/10",
                   [(0, "f", [1], [1, 0])])
    write("golden-cone-exact", cone)
    flip = [[[Q(1), Q(2)], [Q(-1, 2), Q(1, 3)]], [[Q(1, 3), Q(-1, 2)], [Q(2), Q(1)]]]
    write_matrices("flip.mat", flip)
    case = exactly(radius("flip.mat", flip, [0, 1], True), flip, "", [-8, -9, 6], "21/10", "1/10", [(0, "f", [1], [1, 0])])
    write("flip-exact", case)
    write("flip-group-exact", (case[0], as_group(case[1])))
    write("rotation-exact", exactly((["--matrices", "rotation.mat", "--lower", str(1 - width), "--upper", str(1 + width)], rotation), turn, "", [5, -6, 5], "3/5", "1/10", [(0, "-", [0], [1, 0])], im="4/5",
                                    root=("root 3/5 4/5 0 1 1", 1)))
    blocks = [[[*slow[t][0], Q(5)], [*slow[t][1], Q(-7, 3)], [Q(0), Q(0), (Q(3, 2), Q(-1))[t]]] for t in range(2)]
    write_matrices("slow-blocks.mat", [multiply(multiply(basis, m), inverse) for m in blocks])
    case = ["--matrices", "slow-blocks.mat"] + plain[0][2:], ["subcert-certificate 3", "radius 2 3", plain[1][2]] + split + \
        plain[1][3:-1] + ["block 1 norm 3", "end"]
    write("blocks-exact", exactly(case, slow, "", square, "47/20", "1/10", [(0, "-", [1, 0], [1, 0])]))
    tension_case, tension_family = exponent(text(tension) + "@-3", tension, 2, 2, [0], True), transition(tension, 2, 2)
    root_five = [4, -10, 5]  # of 1 + 1/sqrt(5)
    write("tension-exact", exactly(tension_case, tension_family, "2-log", root_five, "7/5", "1/10",
                                   [(0, "-", [0], seed_of(root_five, tension_family, "-", [0]))]))
    first = [Q(c, 12) for c in (3, 4, 3, 4, 3, 4, 3)]  # the primal least squares scheme of four points and degree 1
    first_family = transition(first, 2, 2)
    quartic = [-8, -12, -12, -9, 27]
    write("primal-exact", exactly(exponent("[3,4,3,4,3,4,3]/12@-3", first, 2, 2, [0, 1], True), first_family, "2-log", quartic,
                                  "1193/1000", "1/1000", [(0, "f", [1], seed_of(quartic, first_family, "f", [1]))]))
    # the negative matrices, so that z is negative; and a polynomial of degree 3, which need not be irreducible, for 3/5 - 4/5 i
    negative = [[[-x for x in row] for row in m] for m in first_family]
    write_matrices("negative.mat", negative)
    quartic = [c * (-1) ** k for k, c in enumerate(quartic)]
    case = exactly(radius("negative.mat", negative, [0, 1], True), negative, "", quartic, "-1193/1000", "1/1000",
                   [(0, "f", [1], seed_of(quartic, negative, "f", [1]))])
    write("negative-exact", case)
    swap = {"vertex 1 0 0 -1": "vertex 1 0 0 1", f"unit 1 0:0:{unit // 2} 0c:0:{-unit // 2}": f"unit 1 0:0:{-unit // 2} 0c:0:{unit // 2}",
            f"image 0 0 0:{re}:{im}": f"image 0 0 0:{re}:{-im}", f"image 0 1 0:{re // 2}:{im // 2}": f"image 0 1 0:{re // 2}:{-(im // 2)}"}
    conjugated = made["rotation"][0], [swap.get(line, line) for line in rotation]
    write("conjugate-exact", exactly(conjugated, turn, "", [-5, 56, -65, 50], "3/5", "1/10", [(0, "-", [0], [1, 0])], im="-4/5",
                                     root=("root 3/5 -4/5 0 1 1", 1)))
    # b (1 + z^2)/(1 + z), b that of the four-point scheme
    smoothed = "[-1,1,7,9,9,7,1,-1]/16@-3"
    lines = made["four-point-exact"][1]
    write("reduced-exact", (["--mask", smoothed, "--arity", "2", *four[0][4:], "--exact", "4-log|[-4,1]@4,0,1|^1/1"], [
        lines[0], f"exponent {smoothed} 2", *lines[2:5], "reduced [1,1] [-1,0,9,16,9,0,-1]/16", *lines[5:-1],
        "sum-rules 1", "block 0 norm 3", "end"]))
    # a given vertex, (0, 0, 1), whose images are opposite to each other
    lone = [[[Q(1), Q(1), Q(3)], [Q(1), Q(0), Q(0)], [Q(0)] * 3], [[Q(0), Q(0), Q(-3)], [Q(0)] * 3, [Q(0)] * 3]]
    write_matrices("lone.mat", lone)
    golden_ratio = (1 + math.sqrt(5)) / 2
    scaled = lambda x: round(x * ONE)
    points = [[10 * golden_ratio, 10, 0], [0, 0, 1], [3 / golden_ratio, 0, 0]]
    labelled = [(str(j), v) for j, v in enumerate(points)]
    terms = lambda y: "".join(f" {label}:{scaled(w)}" for label, w in best_combination(labelled, y)[1] if scaled(w) != 0)
    section = ["block 0 polytope 3 64 64", *("vertex " + " ".join(str(scaled(c)) for c in v) for v in points),
               *(f"unit {k}" + terms([float(i == k) for i in range(3)]) for k in range(3)),
               *(f"image {j} {t}" + (terms(y) if any(y) else "") for j, v in enumerate(points)
                 for t, y in enumerate(apply([[float(c) for c in row] for row in m], v) for m in lone))]
    lone_case = (["--matrices", "lone.mat"], ["subcert-certificate 3", "radius 2 3", "bounds - -", *section, "end"])
    write("lone-exact", exactly(lone_case, lone, "", fibonacci, "8/5", "1/10", [(0, "-", [0], [1, 0, 0])]))

    # the number 1, by a product of 300 letters
    letters, number = 300, "|[-1,1]@1,0,1/2|^1/300"
    images = [f"image {k} 0 {(k + 1) % letters}:1" for k in range(letters)]
    origins = [f"origin {k} {k - 1} 0" for k in range(1, letters)]
    write("long-exact", (["--matrices", "one.mat", "--lower", "1", "--upper", "1", "--exact", number], [
        "subcert-certificate 3", "radius 1 1", "bounds 1 1", f"exact {number}", "root 1 0 0 1 1", "product 0 1 0 0",
        f"block 0 polytope {letters} 0 0", *["vertex 1"] * letters, "unit 0 0:1", *images, "cycle 0 -" + " 0" * letters,
        "seed 1", *origins, "end"]))

    # rounded masks
    # products by inverses: of a real eigenvalue, of a complex one, of all matrices near one
    near = Q(1, 1 << 60)
    eigenvalue = newton(multiply(*golden), 2.618)
    eigenvalue = Q(round(eigenvalue * (1 << 64)), 1 << 64)
    write("golden-inverse", with_inverse(golden_case, multiply(*golden), eigenvalue + near))
    turns_case = (["--matrices", "rotation.mat", "--lower", str(1 - width), "--upper", str(1 + width)], rotation)
    write("rotation-inverse", with_inverse(turns_case, turn[0], Q(3, 5) + near, Q(4, 5)))

    def rounded(name, mask, within, lower, upper, *lines):
        bounds = [f"--{end} {value}" for end, value in (("lower", lower), ("upper", upper)) if value is not None]
        write(name, (["--mask", mask, "--arity", "2", "--within", within, *bounds], [
            "subcert-certificate 3", f"exponent {mask} 2 within={within}",
            f"bounds {lower or '-'} {upper or '-'}", f"sum-rules {within.split(',')[1]}", *lines, "end"]))

    rounded("rounded-hat", "[1,2,1]/2@-1", "1/100,1", "9/10", None, "block 0 norm 1")  # SPEC.md, section 7
    daubechies = "[273205,473205,126795,-73205]/400000"
    rounded("rounded-daubechies", daubechies, "1/1000000,2", "549/1000", "551/1000", "stability",
            "product 0 273205/100000 0 0", "block 0 norm 1")
    rounded("rounded-stable", daubechies, "1/100,2", None, None, "stability")
    by_polytope = exponent("[-1,0,9,16,9,0,-1]/16@-3", dd4, 2, 4, [0], True)[1][4:-1]
    rounded("rounded-four-point", "[-1,0,9,16,9,0,-1]/16@-3", "1/1000000000,4", "19999/10000", "20001/10000", *by_polytope)
    coarse = Q(1, 1 << 15)
    first = transition(dd4, 2, 4)[0]
    rounded("rounded-four-point-inverse", "[-1,0,9,16,9,0,-1]/16@-3", "1/1000000000,4", "19999/10000", "20001/10000",
            *with_inverse(([], by_polytope), first, 4 + coarse)[1])
    rounded("rounded-four-point-norm", "[-1,0,9,16,9,0,-1]/16@-3", "1/1000000000,4", "19/10", None, "block 0 norm 8")

    hat = ["subcert-certificate 3", "surface [1,2,1]/2@-1 [2]", "bounds 1 1", "sum-rules 2", "digits 0 1", "space 1",
           "vector -1:1 0:-2 1:1", "gram 0:4 1:1", "product 0 1/2 0 0", "block 0 norm 1", "end"]  # SPEC.md, section 5.8
    write("hat-by-hand", (["--surface", "[1,2,1]/2@-1", "--dilation", "[2]", "--lower", "1", "--upper", "1"], hat))
    write("hat-turned", (["--surface", "[1,2,1]/2@-1", "--dilation", "[2]", "--lower", "1", "--upper", "1"],
                         [*hat[:4], "turned [-2]", *hat[4:]]))
    trapezoid = ["subcert-certificate 3", "surface [1,1,0,1,1]/2@0 [2]", "bounds 1 1", "differences 2", "digits 0 1",
                 "values 1:1 2:1 3:1", "space 1", "vector 0:1 1:-1 3:-1 4:1", "product 0 1/2 0 0", "block 0 norm 1",
                 *edge_cases.CONVERGES.split("; "), "block 0 norm 2", "end"]
    write("trapezoid-by-hand", (["--surface", "[1,1,0,1,1]/2@0", "--dilation", "[2]", "--lower", "1", "--upper", "1"], trapezoid))
    triangle = [(1, 0), (0, 1), (1, 1)]
    write("three-direction", make_surfaces.box_spline(triangle, 2))  # exponent 1
    write("three-direction-group", make_surfaces.box_spline(triangle, 2, exchange=True))
    write("loop", make_surfaces.box_spline(triangle * 2, 4, exchange=True))  # exponent 3
    write("zwart-powell", make_surfaces.box_spline(triangle + [(1, -1)], 2, False))  # shifts not stable; exponent 2
    write("turning-2", make_surfaces.turning_hat(2))
    write("turning-3", make_surfaces.turning_hat(3))
    quarter = [[[x / 4 for x in row] for row in m] for m in transition(tension, 2, 2)]
    section, value, rho = polytope(quarter, [0], True)
    near, width = Q(round(-math.log2(rho) * 10**15), 10**15), Q(1, 10**13)
    write("tension-surface", make_surfaces.one_variable({(i,): c for i, c in enumerate(tension) if c}, 2, len(quarter[0]), section,
                                                        f"product 0 {value} 0 0", near - width, near + width))
    write("surface-exact", exactly(made["tension-surface"], quarter, "0-log", [1, -10, 20], "9/25", "1/10",
                                   [(0, "-", [0], seed_of([1, -10, 20], quarter, "-", [0]))]))
    # one factor fewer than there are: the sequences of sum 0 are a block, the other one has the radius 1
    mask = [Q(c, 24) for c in (-1, 1, 13, 22, 13, 1, -1)]
    columns, inverse = [[1, 0, 0], [-1, 1, 0], [0, -1, 1]], [[1, 0, 0], [1, 1, 0], [1, 1, 1]]
    part = [[row[:2] for row in multiply(multiply(inverse, m), columns)[:2]] for m in transition(mask, 2, 3)]
    case = ["--mask", "[-1,1,13,22,13,1,-1]/24", "--arity", "2"], [
        "subcert-certificate 3", "exponent [-1,1,13,22,13,1,-1]/24 2", "bounds - -", "sum-rules 3", "stability", "blocks 2 1",
        *(f"{head} " + " ".join(map(str, row)) for head, rows in (("basis", columns), ("inverse", inverse)) for row in rows),
        *polytope(part, [0], True)[0], "block 1 polytope 1 0 4", "vertex 1", "unit 0 0:16", "image 0 0 0:16", "image 0 1 0:16",
        "logarithm 0", "end"]
    case = exactly(case, part, "3-log", [-5, 3], "5/3", "1/10", [(0, "-", [0], seed_of([-5, 3], part, "-", [0]))],
                   root=("root 5/3 0 0 13/8 7/4", 5 / 3))
    write("blocks-exponent-exact", ([*case[0], "--logarithm", "0"], case[1]))
    for name, options, lines in single_cases.ACCEPTED:
        case = options.split()
        body = lines.split("; ") if lines else body
        write(name, (case, ["subcert-certificate 3", f"exponent {case[1]} {case[3]}", *body]))
    modules = edge_cases, frequency_cases, variant_cases, graph_cases, cycle_cases, subradius_cases, subradius_exact_cases, l1_cases, vector_cases, field_cases, convergence_cases, vector_range_cases, stability_cases, attains_cases, level_cases, vector_list_cases
    for name, case in [*attains_cases.accepted(sys.modules[__name__]), *field_cases.accepted_by(sys.modules[__name__])]:
        write(name, case)
    for name, case in [*vertex_cases.accepted(), *vertex_variant_cases.accepted(), *vertices_cases.accepted(), *vertex_fit_cases.accepted(), *not_c1_cases.accepted()]:
        write(name, case)
    for name, family in [case for module in modules for case in module.MATRICES]:
        write_matrices(name, family)
    for name, options, lines in [case for module in modules for case in module.ACCEPTED]:
        write(name, (options.split(), ["subcert-certificate 3", *lines.split("; ")]))
    write("four-point-exact-group", (made["four-point-exact"][0], as_group(made["four-point-exact"][1])))
    for name, base, options, edits in [case for module in modules for case in module.CHANGED]:
        write(name, (options.split() if options else made[base][0], edited(made[base][1], edits)))
    write("slow-exact-opposite", (made["slow-exact"][0], opposite(made["slow-exact"][1], 1)))
    # the same vertices for a cone
    cone = {"unit 0": f"2:{ONE}", "unit 1": f"3:{2 * ONE}", "image 3 1": f"3:{23 * ONE // 18}", "image 4 0": f"4:{23 * ONE // 18}"}
    lines = [next((f"{head} {terms}" for head, terms in cone.items() if line.startswith(f"{head} ")), line) for line in plain[1]]
    lines = [f"{line} nonnegative" if line.startswith("block") else line for line in lines]
    write("slow-cone-exact", exactly((plain[0], lines), slow, "", [81, -270, 100], "47/20", "1/10", [(0, "-", [1, 0], [1, 0])]))
    (out / "claims.txt").write_text("\n".join(cases) + "\n")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
