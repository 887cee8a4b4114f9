"""Cases of section 4.15 of SPEC.md: the joint spectral subradius."""

PAIR = [[[1, 1], [1, 1]], [[0, 4], [1, 0]]]  # subradius 2, SPEC.md
MATRICES = [
    ("pair.mat", PAIR),
    ("pair-transposed.mat", [[list(row) for row in zip(*m)] for m in PAIR]),
    ("pair-third.mat", [[[f"{x}/3" for x in row] for row in m] for m in PAIR]),
    ("nilpotent.mat", [[[0, 1], [0, 0]], [[0, 2], [0, 0]]]),  # 0
    ("means.mat", [[["1/2", "1/3"], ["1/3", "1/2"]], [["1/2", "1/2"], ["1/4", "3/4"]]]),  # 5/6
    ("half.mat", [[[3]], [["1/2"]], [[1]]]),  # 1/2
    ("circle.mat", [[[0, 0, 1], [1, 0, 0], [0, 1, 0]], [[1, 0, 1], [1, 1, 0], [0, 1, 1]]]),  # 1
    ("negative-entry.mat", [[[1, 1], [1, 1]], [[0, 4], [1, "-1/9"]]]),
    ("below-0.mat", [[[-1]]]),
]

PRODUCT = "product 0 2 0 0; weights 1 1"
VERTICES = "vertex 2 2; vertex 4 1"
IMAGES = "image 0 0 0:2; image 0 1 1:2; image 1 0 0:2; image 1 1 0:2"
SECTION = f"block 0 polytope 2 1 0; {VERTICES}; {IMAGES}"
CIRCLE = "vertex 1 0 0; vertex 0 1 0; vertex 0 0 1"
BOTH = "--subradius pair.mat --lower 2 --upper 2"

# name, options of the claim, and the lines from the second one on
ACCEPTED = [
    ("subradius-by-hand", BOTH, f"subradius 2 2; bounds 2 2; {PRODUCT}; {SECTION}; end"),
    ("subradius-lower", "--subradius pair.mat --lower 2", f"subradius 2 2; bounds 2 -; {SECTION}; end"),
    # the vector of weights is one of the product in this order alone
    ("subradius-upper", "--subradius pair.mat --upper 5/2", "subradius 2 2; bounds - 5/2; product 0 5 0 1 0; weights 4 1; end"),
    # the product is of the matrices as they are
    ("subradius-transposed", "--subradius pair-transposed.mat --lower 2 --upper 2",
     f"subradius 2 2; bounds 2 2; product 0 2 0 1; weights 1 2; {SECTION.replace('2 1 0', '2 1 0 transposed', 1)}; end"),
    ("subradius-third", "--subradius pair-third.mat --lower 170/256 --upper 2/3",
     "subradius 2 2; bounds 170/256 2/3; product 0 4/9 0/1 0 0; weights 3 3; block 0 polytope 2 1 8; vertex 2 2; vertex 4 1; "
     "image 0 0 0:170; image 0 1 1:170; image 1 0 0:213; image 1 1 0:170; end"),
    ("subradius-zero", "--subradius nilpotent.mat --lower 0 --upper 0",
     "subradius 2 2; bounds 0 0; product 0 0 0 1 0; weights 1 7; block 0 polytope 1 0 0; vertex 1 0; image 0 0; image 0 1; end"),
    ("subradius-means", "--subradius means.mat --lower 853/1024 --upper 5/6",
     "subradius 2 2; bounds - -; product 0 25/36 0 0 0; weights 1 1; block 0 polytope 1 3 10; vertex 8 8; image 0 0 0:853; "
     "image 0 1 0:1024; end"),
    # the least sum of weights is neither the first nor the last one
    ("subradius-half", "--subradius half.mat --lower 1/2 --upper 1/2",
     "subradius 3 1; bounds 1/2 1/2; product 0 1/2 0 1; weights 1; block 0 polytope 1 0 1; vertex 1; image 0 0 0:6; image 0 1 0:1; "
     "image 0 2 0:2; end"),
    ("subradius-circle", "--subradius circle.mat --lower 1 --upper 1",
     f"subradius 2 3; bounds 1 1; product 0 1 0 0; weights 1 1 1; block 0 polytope 3 0 0; {CIRCLE}; image 0 0 1:1; image 0 1 0:1 1:1; "
     "image 1 0 2:1; image 1 1 1:1; image 2 0 0:1; image 2 1 0:1 2:0; end"),
    ("subradius-shears", "--subradius golden.mat --lower 1 --upper 1001/1000",
     "subradius 2 2; bounds 1 1001/1000; product 0 1001/1000 0 0; weights 1000 1; block 0 polytope 2 0 0; vertex 1 0; vertex 0 1; "
     "image 0 0 0:1; image 0 1 0:1 1:1; image 1 0 0:1 1:1; image 1 1 1:1; end"),
    # it need not grow as fast as a vertex allows
    ("subradius-above", "--subradius pair.mat --lower 1",
     "subradius 2 2; bounds 1 -; block 0 polytope 1 0 1; vertex 1 1; image 0 0 0:3; image 0 1 0:2; end"),
    # an end may be negative
    ("subradius-below-0", "--subradius nilpotent.mat --lower -1/2", "subradius 2 2; bounds - -; block 0 polytope 1 0 0; vertex 1 1; image 0 0; "
     "image 0 1; end"),
]

# name, accepted case that is changed, other options or None, changes of its text
CHANGED = [
    ("subradius-more-upper", "subradius-by-hand", "--subradius pair.mat --upper 5/2", []),
    ("subradius-more-lower", "subradius-by-hand", "--subradius pair.mat --lower 2", []),
    ("subradius-terms", "subradius-circle", None, [("image 1 1 1:1\n", "image 1 1 1:1 2:1 1:0\n")]),
    ("subradius-zeros", "subradius-shears", "--subradius golden.mat --lower 3/4 --upper 1001/1000",
     [("polytope 2 0 0", "polytope 2 0 2"), ("0:1\n", "0:3\n"), ("0:1 1:1", "0:3 1:3"), ("0:1 1:1", "0:4 1:4"), ("1 1 1:1", "1 1 1:3")]),
]

ABOVE, ENTRY = "an image is not above", "a matrix is not non-negative, line 2"
HEAD = "block 0 polytope 2 1 0\n"


def changes(name, base, reason, old, *news):
    """A case for each text that stands in the place of another."""
    return [(f"{name}-{i}" if i else name, base, None, reason, [(old, new)]) for i, new in enumerate(news)]


REJECTED = [
    # the claim
    *((f"subradius-claim-{name}", "subradius-by-hand", f"--subradius pair.mat {ends}", reason, []) for name, ends, reason in (
        ("high", "--lower 200000001/100000000", "do not prove the lower end, line 12"),
        ("low", "--upper 199999999/100000000", "does not prove the upper end, line 5"),
        ("high-both", "--lower 200000001/100000000 --upper 2", "do not prove the lower end, line 12"),
        ("low-both", "--lower 2 --upper 199999999/100000000", "does not prove the upper end, line 5"))),
    ("subradius-upper-negative", "subradius-zero", "--subradius nilpotent.mat --upper -1", "does not prove the upper end", []),
    ("subradius-upper-close", "subradius-upper", "--subradius pair.mat --upper 2236/1000", "does not prove the upper end", []),
    ("subradius-lower-middle", "subradius-half", "--subradius half.mat --lower 1", "do not prove the lower end, line 10", []),
    ("subradius-lower-0", "subradius-zero", "--subradius nilpotent.mat --lower 1/1000", "do not prove the lower end, line 9", []),
    ("subradius-no-product", "subradius-lower", BOTH, "expected 'product', line 4", []),
    ("subradius-no-section", "subradius-upper", "--subradius pair.mat --lower 1", "expected 'block 0', line 6", []),
    ("subradius-of-radius", "subradius-by-hand", "--matrices pair.mat --lower 2 --upper 2", "expected 'radius 2 2', line 2", []),
    ("radius-of-subradius", "golden", "--subradius golden.mat --lower 1", "expected 'subradius 2 2', line 2", []),
    ("subradius-other-family", "subradius-by-hand", "--subradius circle.mat --lower 1", "expected 'subradius 2 3', line 2", []),
    ("subradius-not-transposed", "subradius-by-hand", "--subradius pair-transposed.mat --lower 2", ABOVE, []),
    ("subradius-negative", "subradius-by-hand", "--subradius negative-entry.mat --lower 1", ENTRY, []),
    ("subradius-negative-upper", "subradius-half", "--subradius below-0.mat --upper 1", ENTRY, [("subradius 3 1", "subradius 1 1")]),
    # the lines
    *changes("subradius-head", "subradius-by-hand", "expected 'subradius 2 2', line 2", "subradius 2 2", "subradius 2", "subradius 2 3",
             "radius 2 2", "subradius 2 02"),
    *changes("subradius-bounds", "subradius-by-hand", "not an integer, line 3", "bounds 2 2", "bounds x 2", "bounds 2 x"),
    *changes("subradius-before-product", "subradius-by-hand", "expected 'product', line 4", "product", "root 2 0 0 2 2\nproduct",
             "stability\nproduct", "blocks 2\nproduct", "reduced [1] [1]\nproduct"),
    *changes("subradius-only-number", "subradius-by-hand", "expected 'cycle 0 -', line 15", "product",
             "exact |[-2,1]@2,0,1/10|^1/1\nroot 2 0 0 2 2\nproduct"),
    *changes("subradius-after-product", "subradius-by-hand", "expected 'block 0', line 6", "block 0",
             "exact |[-2,1]@2,0,1/10|^1/1\nblock 0", "inverse 0\nblock 0", "block 1", "block"),
    *changes("subradius-after-end", "subradius-by-hand", "text after 'end', line 14", "end\n", "end\nend\n", "end\n\n"),
    *changes("subradius-no-end", "subradius-by-hand", "expected 'end', line 13", "end\n", "", "unit 0 0:1\nend\n", "cycle 0 - 0\nend\n",
             "block 1 norm 1\nend\n", "image 2 0\nend\n"),
    # the upper end
    *changes("subradius-product", "subradius-by-hand", "a real number that is not negative, line 4", "product 0 2 0 0",
             "product 0 -2 0 0", "product 0 2 1 0", "product 0 2 -1/9 0"),
    *changes("subradius-product-block", "subradius-by-hand", "number outside 0..0, line 4", "product 0 2 0 0", "product 1 2 0 0"),
    *changes("subradius-product-letter", "subradius-by-hand", "number outside 0..1, line 4", "product 0 2 0 0", "product 0 2 0 2",
             "product 0 2 0 0 -1"),
    *changes("subradius-product-fields", "subradius-by-hand", "wrong number of fields, line 4", "product 0 2 0 0", "product 0 2 0",
             "product", f"product 0 2 0{' 0' * 4097}"),
    *changes("subradius-product-number", "subradius-by-hand", "line 4", "product 0 2 0 0", "product 0 2.0 0 0", "product 0 2/0 0 0",
             "product 0 2 x 0", "product 00 2 0 0"),
    *changes("subradius-product-small", "subradius-by-hand", "to more than the given multiple, line 5", "product 0 2 0 0",
             "product 0 1999/1000 0 0", "product 0 2 0 1", "product 0 0 0 0"),
    # of both coordinates the first, and the second
    *changes("subradius-product-weights", "subradius-by-hand", "to more than the given multiple, line 5", "weights 1 1", "weights 1 2",
             "weights 2 1"),
    *changes("subradius-product-order", "subradius-upper", "to more than the given multiple, line 5", "5 0 1 0", "5 0 0 1"),
    *changes("subradius-product-longer", "subradius-third", "to more than the given multiple, line 5", "4/9 0/1 0 0", "4/9 0/1 0",
             "1/3 0/1 0 0"),
    *changes("subradius-product-shorter", "subradius-third", "does not prove the upper end, line 5", "4/9 0/1 0 0", "3/2 0/1 0 0"),
    *changes("subradius-weights", "subradius-by-hand", "a weight is not positive, line 5", "weights 1 1", "weights 0 1", "weights 1 0",
             "weights -1 -1"),
    *changes("subradius-weights-fields", "subradius-by-hand", "wrong number of fields, line 5", "weights 1 1", "weights 1",
             "weights 1 1 1"),
    *changes("subradius-weights-number", "subradius-by-hand", "not an integer, line 5", "weights 1 1", "weights 1/2 1", "weights x 1"),
    *changes("subradius-no-weights", "subradius-by-hand", "expected 'weights', line 5", "weights 1 1\n", "", "inverse 0\nweights 1 1\n"),
    ("subradius-zero-product", "subradius-zero", None, "to more than the given multiple", [("0 0 0 1 0\n", "0 0 0 1\n")]),
    # the lower end
    *((f"subradius-{name}", "subradius-by-hand", None, reason, [(HEAD, f"block 0 {words}\n")]) for name, words, reason in (
        ("polytope-nonnegative", "polytope 2 1 0 nonnegative", "unknown property"),
        ("polytope-complex", "polytope 2 1 0 complex", "unknown property"),
        ("polytope-symmetric", "polytope 2 1 0 symmetric", "unknown property"),
        ("polytope-group", "polytope 2 1 0 group:1", "unknown property"),
        ("polytope-empty", "polytope 2 1 0 ", "unknown property"),
        ("polytope-transposed-twice", "polytope 2 1 0 transposed transposed", "wrong number of fields, line 6"),
        ("polytope-short", "polytope 2 1", "wrong number of fields, line 6"), ("norm", "norm 1", "wrong number of fields, line 6"),
        ("quadratic", "quadratic 1 2 3", "expected 'norm', 'polytope'"), ("graph", "graph 1 2 8", "expected 'norm', 'polytope'"),
        ("count-0", "polytope 0 1 0", "number outside"), ("count-negative", "polytope -2 1 0", "number outside"),
        ("count-more", "polytope 3 1 0", "expected 'vertex', line 9"), ("count-fewer", "polytope 1 1 0", "expected 'image 0 0', line 8"),
        ("vertex-bits", "polytope 2 4097 0", "number outside 0..4096"), ("weight-bits", "polytope 2 1 4097", "number outside 0..4096"),
        ("weight-bits-1", "polytope 2 1 1", "do not prove the lower end, line 12"))),
    *changes("subradius-vertex-negative", "subradius-by-hand", "negative coordinate, line 7", "vertex 2 2", "vertex -2 2", "vertex 2 -2"),
    *changes("subradius-vertex-zero", "subradius-by-hand", "a vertex is 0, line 8", "vertex 4 1", "vertex 0 0"),
    *changes("subradius-vertex-fields", "subradius-by-hand", "wrong number of fields, line 7", "vertex 2 2", "vertex 2", "vertex 2 2 2"),
    *changes("subradius-vertex-number", "subradius-by-hand", "not an integer, line 7", "vertex 2 2", "vertex 2 1/2"),
    *changes("subradius-vertex-missing", "subradius-by-hand", "expected 'vertex', line 8", "vertex 4 1\n", ""),
    *changes("subradius-image", "subradius-by-hand", f"{ABOVE} the sum of its terms, line 10", "image 0 1 1:2", "image 0 1 1:3",
             "image 0 1 0:2", "image 0 1 0:1 1:2", "image 0 1 1:2 0:1"),
    # of one coordinate alone, the first or the second
    *changes("subradius-image-first", "subradius-circle", ABOVE, "image 0 1 0:1 1:1", "image 0 1 0:2"),
    *changes("subradius-image-last", "subradius-circle", ABOVE, "image 0 0 1:1", "image 0 0 1:1 2:1"),
    *changes("subradius-image-late", "subradius-by-hand", f"{ABOVE} the sum of its terms, line 12", "image 1 1 0:2", "image 1 1 0:3"),
    *changes("subradius-image-missing", "subradius-by-hand", "expected 'image 0 1', line 10", "image 0 1 1:2\n", "", "image 1 1 1:2\n",
             "unit 0 0:1\nimage 0 1 1:2\n"),
    *changes("subradius-image-last-missing", "subradius-by-hand", "expected 'image 1 1', line 12", "image 1 1 0:2\n", ""),
    *changes("subradius-image-empty", "subradius-by-hand", "do not prove the lower end, line 12", "image 0 1 1:2", "image 0 1",
             "image 0 1 1:1", "image 0 1 1:0"),
    *changes("subradius-term-negative", "subradius-by-hand", "negative weight, line 10", "image 0 1 1:2", "image 0 1 1:-1",
             "image 0 1 1:3 0:-1"),
    *changes("subradius-term-letter", "subradius-by-hand", "unknown generator, line 10", "image 0 1 1:2", "image 0 1 1f:2",
             "image 0 1 1c:2", "image 0 1 1A:2"),
    *changes("subradius-term-index", "subradius-by-hand", "number outside 0..1, line 10", "image 0 1 1:2", "image 0 1 2:2"),
    *changes("subradius-term-form", "subradius-by-hand", "a term is INDEX:WEIGHT, line 10", "image 0 1 1:2", "image 0 1 1",
             "image 0 1 1:2:0", "image 0 1 "),
    *changes("subradius-term-number", "subradius-by-hand", "not an integer, line 10", "image 0 1 1:2", "image 0 1 1:2/1", "image 0 1 :2",
             "image 0 1 -1:2"),
    *changes("subradius-unit", "subradius-by-hand", "expected 'image 0 0', line 9", "image 0 0", "unit 0 0:1\nimage 0 0"),
]
