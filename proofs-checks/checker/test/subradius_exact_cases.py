"""Cases of section 4.15 of SPEC.md: what the joint spectral subradius is. The certificates are those of SPEC.md, or made here from what
stems from what; the rest is rounded down."""
from fractions import Fraction as Q
from math import floor

from subradius_cases import HEAD, IMAGES, PAIR, PRODUCT, SECTION, VERTICES, changes

TWO = "|[-2,1]@2,0,1|^1/1"
GOLDEN, GOLDEN_POLYNOMIAL = "|[-1,-1,1]@8/5,0,1/10|^1/1", [-1, -1, 1]
GOLDEN_ROOT = "1618033989/1000000000 0 1/1000000000 1618033987/1000000000 1618033991/1000000000"
# the square root of 2, as 2^(1/2)
ROOT_2, ROOT_2_ROOT = "|[-2,1]@2,0,1|^1/2", "2 0 0 1414213562/1000000000 1414213563/1000000000"

FIBONACCI = [[1, 1], [1, 0]]
FAMILIES = {
    "fibonacci": [FIBONACCI],
    "fibonacci-more": [FIBONACCI, [[1, 1], [2, 0]]],
    "fibonacci-ways": [FIBONACCI, [[0, 4], [2, 2]]],
    "fibonacci-third": [[["1/3", "1/3"], ["1/3", 0]], [[1, "1/3"], ["2/3", 0]]],
    # the third coordinate decays, or is cut
    "fibonacci-cut": [[[1, 1, 0], [1, 0, 0], [0, 0, 1]], [[2, 1, 0], [2, 0, 0], [1, 0, 3]]],
    "fibonacci-cut-equal": [[[1, 1, 0], [1, 0, 0], [0, 0, 1]], [[1, 1, 0], [2, 0, 0], [1, 0, 3]]],
    # the vertex is (0, 0, 1), and the weights of the rest are not equal
    "rest": [[[1, 3, 0], [0, 1, 0], [5, 0, 2]], [[1, 0, 0], [0, 1, 0], [0, 0, 2]]],
    "two-codes": [[[0, 1], [1, 1]], [[1, 1], [1, 0]]],
    "two-letters": [[[0, 1], [2, 2]], [[1, 1], [1, 0]]],
    "skew": [[[1, 2], [1, 0]], [[1, 3], [1, 0]]],  # transposed (1, 1) is an eigenvector
    "numbers": [[[2]], [[8]]],
    # the rhombus of Pascal
    "pascal": [[[0, 1, 0, 0, 0], [1, 0, 2, 0, 0], [0, 0, 0, 0, 0], [0, 1, 0, 0, 1], [0, 0, 0, 2, 1]],
               [[1, 0, 2, 0, 0], [0, 0, 0, 2, 1], [1, 1, 0, 0, 0], [0, 0, 0, 0, 0], [0, 1, 0, 0, 0]]],
    "cut-on-cycle": [[[1, 0], [1, 1]], [[1, 0], [0, 0]]],
}
MATRICES = [(f"slow-{name}.mat", family) for name, family in FAMILIES.items()]


def fractions(matrix):
    return [[Q(x) for x in row] for row in matrix]


def apply(matrix, x):
    return [sum(a * b for a, b in zip(row, x)) for row in matrix]


def above(image, vertices, terms, one):
    """The terms of an image: as much as there may be of the first vertex, then of the next, or as much as is said after its number."""
    weights = []
    for k, *share in [term if isinstance(term, tuple) else (term,) for term in terms]:
        weight = floor(min([x * one / v for x, v in zip(image, vertices[k]) if v] + [Q(x) * one for x in share]))
        image = [x - Q(weight, one) * v for x, v in zip(image, vertices[k])]
        weights.append(f"{k}:{weight}")
    return weights


def certificate(name, exact, root, letters, seed, origins=(), same=(), terms=None, rest="", cut=(), shrink=None, before="", bits=40,
                polynomial=None, transposed=False):
    """`origins`: (K, T) of the vertices from number 1 on; `cut`: their coordinates that are 0, by number; `shrink`: by what they are divided, by number; `terms`: of images, otherwise
    one vertex that has the largest weight."""
    family = FAMILIES[name]
    count, size = len(family), len(family[0])
    matrices = [fractions(zip(*matrix) if transposed else matrix) for matrix in family]
    p = polynomial or [-2, 1]
    c, high, one = Q(root.split()[0]), Q(root.split()[4]), 1 << bits
    y, total = [Q(p[-1] * x) for x in seed], [Q(0)] * size
    for k in reversed(range(len(p) - 1)):
        total = [a * c + b for a, b in zip(total, y)]
        image = y
        for t in letters:
            image = apply(matrices[t], image)
        y = [a + p[k] * x for a, x in zip(image, seed)]
    assert not any(y)
    vertices = [[floor(abs(x) * one) for x in total]]
    for j, (parent, t) in enumerate(origins, 1):
        image = apply(matrices[t], vertices[parent])
        factors = (shrink or {}).get(j, [1] * size)
        vertices.append([0 if i in dict(cut).get(j, ()) else floor(x / high / factors[i]) for i, x in enumerate(image)])
    images = []
    for j, vertex in enumerate(vertices):
        for t in range(count):
            image = apply(matrices[t], vertex)
            choices = [above(image, vertices, [k], one) for k in range(len(vertices))]
            best = max(choices, key=lambda choice: int(choice[0].split(":")[1]))
            chosen = above(image, vertices, terms[j, t], one) if (j, t) in (terms or {}) else best
            images.append(" ".join([f"image {j} {t}", *(term for term in chosen if not term.endswith(":0"))]))
    property_ = " transposed" if transposed else ""
    lines = [f"subradius {count} {size}", "bounds - -", f"exact {exact}", f"root {root}", *filter(None, [before]),
             f"block 0 polytope {len(vertices)} {bits} {bits}{property_}",
             *("vertex " + " ".join(map(str, vertex)) for vertex in vertices), *images, "cycle 0 - " + " ".join(map(str, letters)),
             "seed " + " ".join(map(str, seed)), *filter(None, [rest]),
             *(f"origin {j} {parent} {t}" for j, (parent, t) in enumerate(origins, 1)), *(f"same {line}" for line in same), "end"]
    return "; ".join(lines)


def accepted(case, name, exact, *arguments, ends="", **options):
    return f"subradius-exact-{case}", f"--subradius slow-{name}.mat --exact {exact}{ends}", certificate(name, exact, *arguments, **options)


def golden(case, name, *arguments, exact=GOLDEN, root=GOLDEN_ROOT, polynomial=GOLDEN_POLYNOMIAL, **options):
    return accepted(case, name, exact, root, *arguments, polynomial=polynomial, **options)


ONE_ROOT = "1 0 0 1 1"
EXACT = f"exact {TWO}; root 2 0 0 2 2"
TAIL = "cycle 0 - 0; seed 1 1; origin 1 0 1"
PAIR_CLAIM = f"--subradius pair.mat --exact {TWO}"
ACCEPTED = [
    ("subradius-exact", PAIR_CLAIM, f"subradius 2 2; bounds 2 2; {EXACT}; {PRODUCT}; {SECTION}; {TAIL}; end"),
    # neither a product nor weights of what is an image
    ("subradius-exact-alone", PAIR_CLAIM, f"subradius 2 2; bounds - -; {EXACT}; {HEAD.strip()}; {VERTICES}; image 0 0; image 0 1; "
     f"image 1 0 0:2; image 1 1 0:2; {TAIL}; end"),
    ("subradius-exact-third", "--subradius pair-third.mat --exact |[-2,3]@2/3,0,1|^1/1", "subradius 2 2; bounds - -; "
     "exact |[-2,3]@2/3,0,1|^1/1; root 2/3 0 0 2/3 2/3; block 0 polytope 2 1 8; vertex 2 2; vertex 4 1; image 0 0; image 0 1; "
     f"image 1 0 0:213; image 1 1; {TAIL}; same 1 1 0; end"),
    golden("golden", "fibonacci", [0], [1, 0]),
    golden("opposite", "fibonacci", [0], [-1, 0], ends=" --lower 1 --upper 17/10", before="product 0 17/10 0 0; weights 17 11"),
    # one coordinate by equations, the other one as it is larger
    golden("mixed", "fibonacci-more", [0], [1, 0], same=["0 1 0"]),
    # which vertices know by which way they stem from the first one; a turn of the cycle before either way
    golden("ways", "fibonacci-ways", [0], [1, 0], [(0, 1), (0, 0), (2, 1)], ["2 0 0", "2 1 1", "0 1 3", "3 1 0"]),
    golden("smaller", "fibonacci-ways", [0], [1, 0], [(0, 1), (0, 0), (2, 1)], ["2 0 0", "2 1 1"], shrink={2: [1, Q(11, 10)], 3: [1, Q(13, 10)]}),
    golden("rational", "fibonacci-third", [0], [1, 0], [(0, 1)], exact="|[-1,-3,9]@8/15,0,1/30|^1/1", polynomial=[-1, -3, 9],
           root="539344663/1000000000 0 1/1000000000 539344661/1000000000 539344665/1000000000"),
    golden("cut", "fibonacci-cut", [0], [1, 0, 0], [(0, 1), (1, 0)], ["1 0 0", "2 0 0", "1 1 2"], cut=[(1, [2])], rest="rest 1 1 1"),
    accepted("rest", "rest", TWO, "2 0 0 2 2", [0], [0, 0, 1], rest="rest 3 1 1", same=["0 1 0"]),
    accepted("rest-bare", "rest", TWO, "2 0 0 2 2", [0], [0, 0, 1], rest="rest 3 1 1", same=["0 1 0"], terms={(0, 0): [], (0, 1): []}),
    accepted("rest-last", "rest", TWO, "2 0 0 2 2", [1], [0, 0, 1], rest="rest 1 1 1"),
    # the true vertex is 4/3 of the given one, so that images need 8/3
    ("subradius-exact-factor", f"--subradius slow-numbers.mat --exact {TWO}", f"subradius 2 1; bounds - -; {EXACT}; block 0 polytope 2 0 0; vertex 1; "
     "vertex 3; image 0 0; image 0 1; image 1 0 0:3; image 1 1 0:3; cycle 0 - 0; seed 1; origin 1 0 1; end"),
    accepted("rest-opposite", "rest", TWO, "2 0 0 2 2", [0], [0, 0, -5], rest="rest 4 1 9"),
    accepted("codes", "two-codes", "|[-1,1]@1,0,1/10|^1/2", ONE_ROOT, [0, 1], [1, 0], [(0, 0)], rest="rest 7 3", polynomial=[-1, 1],
             terms={(0, 1): [0, 1], (1, 0): [0, 1]}),
    accepted("letters", "two-letters", ROOT_2, ROOT_2_ROOT, [0, 1], [1, 0], [(0, 0), (1, 1), (2, 0)], ["3 1 0", "0 0 3", "2 0 1"],
             terms={(0, 1): [0, 1], (1, 0): [0, 1], (2, 1): [0, 1], (3, 0): [0, 1]}, rest="rest 1 1"),
    accepted("transposed", "skew", TWO, "2 0 0 2 2", [0], [1, 1], [(0, 1)], transposed=True),
    accepted("pascal", "pascal", "|[-121,20,-20,1]@2411/125,0,1/1000|^1/6",
             f"{Q('19.288337885462')} 0 {Q('1/1000000000000')} {Q('1.637630057453')} {Q('1.637630057454')}", [1, 1, 1, 0, 0, 0],
             [136, 330, 272, 330, 363], [(0, 1), (1, 1), (2, 1), (3, 0), (4, 0), (5, 1), (2, 0), (6, 0), (7, 1)],
             terms={(0, 0): [(5, "1.027"), 0], (3, 1): [(3, "0.667"), 2], (8, 0): [(8, "0.113"), (6, "0.138"), 5],
                    (9, 1): [(1, "0.163"), (0, "0.199"), 2]}, polynomial=[-121, 20, -20, 1], transposed=True),
    accepted("on-cycle", "cut-on-cycle", "|[-1,1]@1,0,1/10|^1/2", ONE_ROOT, [0, 1], [1, 0], [(0, 0)], rest="rest 1 1", polynomial=[-1, 1]),
]
CHANGED = [
    ("subradius-exact-bounds", "subradius-exact", f"{PAIR_CLAIM} --lower 2 --upper 2", []),
    ("subradius-exact-lower", "subradius-exact", f"{PAIR_CLAIM} --lower 1", []),
    ("subradius-exact-unasked", "subradius-exact", "--subradius pair.mat --upper 5/2", []),
]

LOW, SAME, EIGENVECTOR = "may lie below", "is not above the vertex that it is said to be", "a coordinate of the eigenvector may"
BASE = "subradius-exact"


def other_number(name, base, exact, root, reason, *edits):
    """Another number, in claim and certificate."""
    options, lines = next((options, lines) for case, options, lines in ACCEPTED if case == base)
    old, old_root = next((line[6:], after[5:]) for line, after in zip(lines.split("; "), lines.split("; ")[1:]) if line.startswith("exact "))
    return name, base, options.replace(old, exact), reason, [(f"exact {old}\n", f"exact {exact}\n"), (f"{old_root}\n", f"{root}\n"), *edits]


REJECTED = [
    # the claim
    ("subradius-exact-other", BASE, "--subradius pair.mat --exact |[-2,1]@2,0,2|^1/1", "expected 'exact |[-2,1]@2,0,2|^1/1', line 4", []),
    ("subradius-exact-none", "subradius-by-hand", PAIR_CLAIM, f"expected 'exact {TWO}', line 4", []),
    ("subradius-exact-of-radius", BASE, f"--matrices pair.mat --exact {TWO}", "expected 'radius 2 2', line 2", []),
    ("subradius-exact-high", BASE, f"{PAIR_CLAIM} --lower 200000001/100000000", "do not prove the lower end, line 14", []),
    ("subradius-exact-high-alone", "subradius-exact-alone", f"{PAIR_CLAIM} --lower 1", "do not prove the lower end, line 12", []),
    ("subradius-exact-low", BASE, f"{PAIR_CLAIM} --upper 199999999/100000000", "does not prove the upper end, line 7", []),
    ("subradius-exact-no-product", "subradius-exact-alone", f"{PAIR_CLAIM} --upper 2", "expected 'product', line 6", []),
    ("subradius-exact-no-section", "subradius-upper", "--subradius pair.mat --upper 5/2", "expected 'block 0', line 8",
     [("product", f"{EXACT.replace('; ', chr(10))}\nproduct")]),
    ("subradius-exact-no-section-asked", "subradius-upper", PAIR_CLAIM, "expected 'block 0', line 8",
     [("product", f"{EXACT.replace('; ', chr(10))}\nproduct")]),
    # the number
    other_number("subradius-exact-3", BASE, "|[-3,1]@3,0,1|^1/1", "3 0 0 3 3", "does not vanish on the seed, line 16"),
    other_number("subradius-exact-imaginary", BASE, "|[1,0,1]@0,1,1/10|^1/1", "0 1 0 1 1", "a subradius needs a real zero, line 5"),
    other_number("subradius-exact-imaginary-centre", BASE, "|[-2,1]@2,1/100,1|^1/1", "2 0 0 2 2", "a subradius needs a real zero, line 5"),
    other_number("subradius-exact-imaginary-near", BASE, TWO, "2 1/100 1/100 1 3", "a subradius needs a real zero, line 5"),
    ("subradius-exact-imaginary-unasked", BASE, "--subradius pair.mat --lower 1", "a subradius needs a real zero, line 5",
     [("root 2 0 0 2 2", "root 2 1/100 1/100 1 3")]),
    ("subradius-exact-high-negative", "subradius-exact-codes", None, "its modulus not positive, line 5", [("root 1 0 0 1 1", "root 1 0 0 1 -1")]),
    ("subradius-exact-root-unasked", "subradius-exact-unasked", None, "bounds of the exact radius are wrong, line 5",
     [("root 2 0 0 2 2", "root 2 0 0 2 1")]),
    ("subradius-exact-number-unasked", "subradius-exact-unasked", None, "an exact radius the same without M-log, line 4", [(f"exact {TWO}", f"exact 1-log{TWO}")]),
    # the smaller zero has an eigenvector, but not a positive one
    other_number("subradius-exact-smaller", "subradius-exact-golden", "|[-1,-1,1]@-3/5,0,1/10|^1/1", "-618/1000 0 1/1000 616/1000 620/1000",
                 f"{EIGENVECTOR} not be positive, or not be 0, as that of the vertex is, line 10"),
    # the cycle and its seed
    *changes("subradius-exact-cycle", BASE, "expected 'cycle 0 -', line 15", "cycle 0 - 0\n", "", "cycle 1 - 0\n", "cycle 0 A 0\n", "cycle 0 0\n",
             "unit 0 0:1\ncycle 0 - 0\n"),
    *changes("subradius-exact-cycle-length", BASE, "wrong number of fields, line 15", "cycle 0 - 0\n", "cycle 0 -\n", "cycle 0 - 0 0\n"),
    *changes("subradius-exact-cycle-letter", BASE, "number outside 0..1, line 15", "cycle 0 - 0\n", "cycle 0 - 2\n", "cycle 0 - -1\n"),
    *changes("subradius-exact-seed", BASE, "does not vanish on the seed, line 16", "seed 1 1\n", "seed 1 0\n", "seed 0 1\n"),
    *changes("subradius-exact-seed-fields", BASE, "wrong number of fields, line 16", "seed 1 1\n", "seed 1\n", "seed 1 1 1\n"),
    *changes("subradius-exact-seed-0", BASE, f"{EIGENVECTOR} not be positive", "seed 1 1\n", "seed 0 0\n"),
    *changes("subradius-exact-seed-missing", BASE, "expected 'seed', line 16", "seed 1 1\n", ""),
    ("subradius-exact-vertex-0", "subradius-exact-golden", None, f"{EIGENVECTOR} not be positive, or not be 0, as that of the vertex is, line 10",
     [("1099511627776\n", "0\n"), ("image 0 0 0:1779047184662\n", "image 0 0\n")]),
    *changes("subradius-exact-vertex-1", "subradius-exact-rest-bare", f"{EIGENVECTOR} not be positive, or not be 0", "vertex 0 0 ",
             "vertex 0 1 ", "vertex 1 0 "),
    # a turn of the cycle in the other order, or of one matrix
    *changes("subradius-exact-cycle-order", "subradius-exact-codes", "does not vanish on the seed", "cycle 0 - 0 1", "cycle 0 - 1 0",
             "cycle 0 - 1 1"),
    # the rest
    *changes("subradius-exact-rest-missing", "subradius-exact-codes", "expected 'rest', line 15", "rest 7 3\n", ""),
    *changes("subradius-exact-rest-much", BASE, "expected 'origin 1', line 17", "origin", "rest 1 1\norigin"),
    *changes("subradius-exact-rest-0", "subradius-exact-codes", "a weight is not positive, line 15", "rest 7 3", "rest 7 0", "rest 0 3", "rest 7 -3"),
    *changes("subradius-exact-rest-fields", "subradius-exact-codes", "wrong number of fields, line 15", "rest 7 3", "rest 7", "rest 7 3 1"),
    *changes("subradius-exact-rest-large", "subradius-exact-rest", "a weight of the rest to too much, line 12", "rest 3 1 1", "rest 2 1 1",
             "rest 2999 1000 9000"),
    # what stems from what
    *changes("subradius-exact-origin", BASE, "expected 'origin 1', line 17", "origin 1 0 1\n", "", "same 0 1 1\n", "origin 0 0 1\n",
             "origin 2 0 1\n"),
    *changes("subradius-exact-origin-parent", BASE, "number outside 0..0, line 17", "origin 1 0 1\n", "origin 1 1 1\n", "origin 1 -1 1\n"),
    *changes("subradius-exact-origin-letter", BASE, "number outside 0..1, line 17", "origin 1 0 1\n", "origin 1 0 2\n"),
    *changes("subradius-exact-origin-fields", BASE, "wrong number of fields, line 17", "origin 1 0 1\n", "origin 1 0\n", "origin 1 0 1 0\n"),
    *changes("subradius-exact-origin-twice", BASE, "expected 'end', line 18", "origin 1 0 1\n", "origin 1 0 1\norigin 1 0 1\n",
             "origin 1 0 1\norigin 2 0 1\n"),
    *changes("subradius-exact-origin-above", BASE, "above the image from which it stems, line 17", "origin 1 0 1\n", "origin 1 0 0\n"),
    ("subradius-exact-origin-above-last", "subradius-exact-alone", None, "above the image from which it stems, line 15",
     [("vertex 4 1\n", "vertex 2 2\n"), ("image 1 1 0:2\n", "image 1 1\n")]),
    *changes("subradius-exact-not-on-cycle", "subradius-exact-codes", "a vertex of a cycle is missing, line 16", "origin 1 0 0\n",
             "origin 1 0 1\n"),
    *changes("subradius-exact-cut-on-cycle", "subradius-exact-on-cycle", "a vertex of the cycle is cut, line 16", "vertex 1099511627776 1099511627776\n",
             "vertex 1099511627776 0\n"),
    # the images
    *changes("subradius-exact-image", BASE, f"image 1 0 {LOW}, line 18", "image 1 0 0:2", "image 1 0 0:1", "image 1 0 1:1"),
    *changes("subradius-exact-image-last", BASE, f"image 1 1 {LOW}, line 18", "image 1 1 0:2", "image 1 1 0:1", "image 1 1"),
    *changes("subradius-exact-image-first", "subradius-exact-rest-last", f"image 0 0 {LOW}, line 13", "image 0 0 0:2199023255552",
             "image 0 0 0:2199023255551"),
    *changes("subradius-exact-image-factor", "subradius-exact-factor", f"image 1 0 {LOW}, line 16", "image 1 0 0:3", "image 1 0 0:2"),
    ("subradius-exact-image-factor-bits", "subradius-exact-factor", None, f"image 1 0 {LOW}, line 16",
     [("polytope 2 0 0\n", "polytope 2 0 600\n"), ("1 0 0:3", f"1 0 0:{2**603 // 3}"), ("1 1 0:3", f"1 1 0:{2**602}")]),
    *changes("subradius-exact-image-above", BASE, "an image is not above the sum of its terms, line 11", "image 0 0 0:2", "image 0 0 0:3"),
    *changes("subradius-exact-image-close", "subradius-exact-mixed", f"image 0 1 {LOW}, line 12", "same 0 1 0\n", ""),
    *changes("subradius-exact-image-codes", "subradius-exact-codes", f"image 1 0 {LOW}", "image 1 0 0:1099511627776 1:1099511627776",
             "image 1 0 0:1099511627775"),
    *changes("subradius-exact-no-ways", "subradius-exact-ways", f"image 2 0 {LOW}", "same 2 0 0\n", ""),
    *changes("subradius-exact-no-letters", "subradius-exact-letters", f"image 3 1 {LOW}", "same 3 1 0\n", ""),
    *changes("subradius-exact-no-third", "subradius-exact-third", f"image 1 1 {LOW}", "same 1 1 0\n", ""),
    # the lines `same`
    *changes("subradius-exact-same-fields", "subradius-exact-mixed", "wrong number of fields, line 12", "same 0 1 0\n", "same 0 1\n",
             "same 0 1 0 0\n"),
    *changes("subradius-exact-same-number", "subradius-exact-mixed", "number outside", "same 0 1 0\n", "same 1 1 0\n", "same 0 2 0\n",
             "same 0 1 1\n"),
    *changes("subradius-exact-same-letters", "subradius-exact-mixed", "not an integer", "same 0 1 0\n", "same 0 1 0A\n", "same 0 1 0f\n"),
    *changes("subradius-exact-same-less", "subradius-exact-ways", f"{SAME}, line 24", "same 2 0 0\n", "same 0 0 1\n"),
    # one coordinate is less
    *changes("subradius-exact-same-order", "subradius-exact-letters", f"{SAME}, line 25", "same 3 1 0\n", "same 1 1 3\n", "same 0 0 2\n",
             "same 2 0 0\n"),
    # the ways are of other lengths than their vertices want
    *changes("subradius-exact-same-length", "subradius-exact-letters", f"{SAME}, line 25", "same 3 1 0\n", "same 0 1 0\n", "same 2 1 1\n"),
    *changes("subradius-exact-same-above", "subradius-exact-third", f"{SAME}, line 16", "same 1 1 0\n", "same 1 1 1\n", "same 0 1 0\n"),
    *changes("subradius-exact-same-last", BASE, "expected 'end', line 19", "end\n", "same 0 1 1\norigin 1 0 1\nend\n"),
]


def written(case, name, *arguments, reason, exact=GOLDEN, root=GOLDEN_ROOT, polynomial=GOLDEN_POLYNOMIAL, **options):
    _, claim, lines = accepted(case, name, exact, root, *arguments, polynomial=polynomial, **options)
    return f"subradius-exact-{case}", claim, lines, reason


CUT = {"cut": [(1, [2])], "rest": "rest 1 1 1", "reason": SAME}
WAYS = [0], [1, 0], [(0, 1), (0, 0), (2, 1)], ["2 0 0", "2 1 1"]
UNSURE = {"exact": "|[-1,-1,1]@8/5,0,1|^1/1", "reason": f"{EIGENVECTOR} not be positive"}
# name, options of the claim, the lines after the first one, reason
WRITTEN = [
    # equations say nothing of a vertex that is cut, or stems from such a one
    written("same-cut", "fibonacci-cut-equal", [0], [1, 0, 0], [(0, 1)], ["1 0 0"], **CUT),
    written("same-cut-target", "fibonacci-cut-equal", [0], [1, 0, 0], [(0, 1)], ["0 1 1"], **CUT),
    written("same-cut-parent", "fibonacci-cut-equal", [0], [1, 0, 0], [(0, 1), (1, 0), (0, 1)], ["3 0 2"], **CUT),
    # a vertex that is much below the true one, and one that is not, but for its origin
    written("small", "fibonacci-ways", *WAYS, shrink={1: [1, Q(8, 5)]}, reason=LOW),
    written("small-origin", "fibonacci-ways", *WAYS, shrink={2: [1, Q(6, 5)], 3: [1, Q(7, 5)]}, reason=LOW),
    # the error of a coordinate of the eigenvector is as large as that, or larger
    written("unsure", "fibonacci", [0], [1, 0], root="1618/1000 0 3/4 1/2 3", **UNSURE),
    written("unsure-edge", "fibonacci", [0], [1, 0], root="1618/1000 0 1/2 1/2 3", **UNSURE),
]
