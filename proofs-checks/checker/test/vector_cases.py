"""Vectors of refinable functions (5.9). The spaces and the bases of the blocks were found by search; exponents are known by hand."""

HAT_BUBBLE = "[[[2,0],[0,0]],[[4,0],[0,1]],[[2,0],[4,1]]]/4@-1"
ROUGH_BUBBLE = HAT_BUBBLE.replace("[0,1]", "[0,3]").replace("[4,1]", "[4,3]")  # exponent -log2(3/4)
HERMITE = "[[[4,6],[-1,-1]],[[8,0],[0,4]],[[4,-6],[1,-1]]]/8@-1"
MERRIEN = "[[[4,2],[-1,1]],[[8,0],[0,4]],[[4,-2],[1,1]]]/8@-1"  # -1/8, 1/2: exponent 2 - log2(3/2)
GHM = "[[[6,8],[-1,-3]],[[6,0],[9,10]],[[0,0],[9,-3]],[[0,0],[-1,0]]]/10@0"
DOUBLE_KNOTS = "[[[2,2],[0,1]],[[2,0],[2,4]],[[0,0],[2,1]]]/4@0"  # quadratic B-splines
HAT_HAAR = "[[[1,0],[0,0]],[[2,0],[0,2]],[[1,0],[0,2]]]/2@-1"  # the characteristic function of [0, 1] is not continuous
COURANT = ("[[[[1,0],[0,0]],[[1,0],[0,0]],[[0,0],[0,0]]],[[[1,0],[0,0]],[[2,0],[0,1]],[[1,0],[2,0]]],"
           "[[[0,0],[0,0]],[[1,0],[0,0]],[[1,0],[0,0]]]]/2@-1,-1")  # and h(2x - (1, 0)) + phi_1(2x)/2, with a kink at 0

UNIT_3 = "basis 1 0 0; basis 0 1 0; basis 0 0 1; inverse 1 0 0; inverse 0 1 0; inverse 0 0 1"
NORMS_3 = "block 0 norm 1; block 1 norm 1; block 2 norm 1; end"
BUBBLE_SPACE = "differences 2; digits 0 1; values 0.0:1; space 3; vector 0.1:1; vector 1.1:1; vector -1.0:1 0.0:-2 1.0:1; "
HAT_SPACE = "differences 2; digits 0 1; values 0.0:1; space 1; vector -1.0:1 0.0:-2 1.0:1; product 0 1/2 0 0; block 0 norm 1; end"
HERMITE_SPACE = ("differences 3; digits 0 1; values 0.0:1; space 3; vector -1.0:2 0.1:-4 1.0:-2; vector -1.1:2 0.1:-4 1.1:2; "
                 "vector 0.0:2 0.1:-1 1.0:-2 1.1:-1; blocks 1 1 1; ")
DIGITS_SPACE = ("differences 2; digits 1 -2; values -1.0:1; space 5; vector -1.0:1 1.0:-3 2.0:2; vector 0.0:1 1.0:-2 2.0:1; "
                "vector 0.1:1; vector 1.1:1; vector 2.1:1; ")
MINUS_SPACE = ("differences 2; digits 0 1; values 0.0:1; space 4; vector -1.0:1 0.0:-2 1.0:1; vector -1.1:1; vector 0.1:1; vector 1.1:1; "
               "blocks 2 1 1; basis 0 0 1 1; basis -1 -1 8 0; basis 1 0 0 0; basis 0 1 0 0; inverse 0 0 1 0; inverse 0 0 0 1; "
               "inverse 0 1/8 1/8 1/8; inverse 1 -1/8 -1/8 -1/8; product 1 1/2 0 0; block 0 norm 9; block 1 norm 1; block 2 norm 1; end")
COURANT_SPACE = (
    "differences 2; digits 0,0 1,0 0,1 1,1; values 0,0.0:1; space 9; vector -1,-1.0:1 0,1.0:-2 1,0.0:-2 1,1.0:3; "
    "vector -1,0.0:1 0,1.0:-2 1,0.0:-1 1,1.0:2; vector -1,1.0:1 0,1.0:-2 1,1.0:1; vector 0,-1.0:1 0,1.0:-1 1,0.0:-2 1,1.0:2; "
    "vector 0,-1.1:1; vector 0,0.0:1 0,1.0:-1 1,0.0:-1 1,1.0:1; vector 0,0.1:1; vector 1,-1.0:1 1,-1.1:2 1,0.0:-2 1,1.0:1; "
    "vector 1,0.1:1; blocks 1 1 1 1 1 1 1 1 1; basis 0 0 1 -1 0 -1 0 0 1; basis 0 0 -1 0 0 1 -1 1 0; basis 0 0 0 1 0 0 1 0 0; "
    "basis 0 0 -1 1 0 0 0 0 0; basis 1 0 0 0 0 0 0 0 0; basis 0 0 1 0 0 0 0 0 0; basis 0 1 0 0 0 0 0 0 0; basis 0 0 0 0 0 1 0 0 0; "
    "basis 0 0 0 0 1 0 0 0 0; inverse 0 0 0 0 1 0 0 0 0; inverse 0 0 0 0 0 0 1 0 0; inverse 0 0 0 0 0 1 0 0 0; "
    "inverse 0 0 0 1 0 1 0 0 0; inverse 0 0 0 0 0 0 0 0 1; inverse 0 0 0 0 0 0 0 1 0; inverse 0 0 1 -1 0 -1 0 0 0; "
    "inverse 0 1 1 -1 0 0 0 -1 0; inverse 1 0 0 1 0 0 0 1 0; product 0 1/2 0 2; "
    + "".join(f"block {i} norm 1; " for i in range(9)) + "end")

# a hat beside the quadratic B-spline: two solutions
HAT_BESIDE = "[[[2,0],[0,1]],[[4,0],[0,3]],[[2,0],[0,3]],[[0,0],[0,1]]]/4@-1"
TWO = "differences 3; digits 0 1; values 0.1:1 1.1:1; "
HAT_VECTOR, SPLINE_VECTOR = "vector -1.0:1 0.0:-2 1.0:1; ", "vector -1.1:1 0.1:-3 1.1:3 2.1:-1; "
SPLINE_SPACE = "space 1; " + SPLINE_VECTOR + "product 0 1/4 0 0; block 0 norm 1; end"
BOTH = "differences 3; digits 0 1; values 0.0:4 0.1:1 1.1:1; functional 1 0; functional 0 1; space 2; " + HAT_VECTOR + SPLINE_VECTOR
NORMS_2 = "block 0 norm 1; block 1 norm 1; end"
JORDAN = "[[[1,1],[0,1]],[[2,0],[0,2]],[[1,0],[0,1]]]/2@-1"
JORDAN_LINES = "differences 2; digits 0 1; values 0.0:1; functional 1 0; functional 0 1; "

MATRICES = []


def accepted(name, mask, ends, lines, dilation="[2]", component=None, integral=None):
    lower, _, upper = ends.partition(" ")
    one = ("" if integral is None else f" --integral {integral}") + ("" if component is None else f" --component {component}")
    head = one.replace("--", "").replace("integral ", "integral=").replace("component ", "component=")
    options = f"--refinable {mask} --dilation {dilation}{one} --lower {lower}" + (f" --upper {upper}" if upper else "")
    return name, options, f"refinable {mask} {dilation}{head}; bounds {lower} {upper or '-'}; {lines}"


ACCEPTED = [
    accepted("vector-by-hand", HAT_BUBBLE, "1 1", BUBBLE_SPACE + "blocks 2 1; " + UNIT_3 + "; product 1 1/2 0 0; block 0 norm 1; "
             "block 1 norm 1; end"),  # SPEC.md, section 5.10
    accepted("vector-hermite", HERMITE, "2 2", HERMITE_SPACE + "basis -3 1 1; basis 1 0 0; basis 0 4 0; inverse 0 1 0; inverse 0 0 1/4; "
             "inverse 1 3 -1/4; product 0 1/4 0 0; " + NORMS_3),
    accepted("vector-merrien", MERRIEN, "1415/1000 1416/1000", HERMITE_SPACE + "basis -2 -1 1; basis 1 1 0; basis 2 0 0; "
             "inverse 0 0 1/2; inverse 0 1 -1/2; inverse 1 1 1/2; product 0 3/8 0 0; " + NORMS_3),
    accepted("vector-ghm", GHM, "1 1", "differences 2; digits 0 1; values 1.1:1; space 3; vector 0.0:1 1.1:-3 2.1:1; "
             "vector 0.1:1 1.1:-2 2.1:1; vector 1.0:1 1.1:-1 2.1:-1; blocks 1 1 1; basis -1 3 1; basis 1 4 0; basis 0 8 0; "
             "inverse 0 1 -1/2; inverse 0 0 1/8; inverse 1 1 -7/8; product 1 1/2 0 0; " + NORMS_3),
    accepted("vector-double-knots", DOUBLE_KNOTS, "1 1", "differences 2; digits 0 1; values 1.1:1; space 3; vector 0.0:2 1.1:-3 2.1:1; "
             "vector 0.1:2 1.1:-4 2.1:2; vector 1.0:2 1.1:-1 2.1:-1; blocks 1 1 1; basis 1 -4 1; basis 0 1 0; basis 1 0 0; "
             "inverse 0 0 1; inverse 0 1 0; inverse 1 4 -1; product 0 1/2 0 0; " + NORMS_3),
    # places at the ends of the support do not count
    accepted("vector-ends", HAT_HAAR, "1 1", HAT_SPACE),
    # with M = -2 its two ends change places
    accepted("vector-ends-minus-two", "[[[0,0],[0,2]],[[1,0],[0,2]],[[2,0],[0,0]],[[1,0],[0,0]]]/2@-2", "1 1", HAT_SPACE, "[-2]"),
    # values of which the sum is 0
    accepted("vector-opposite", "[[[0,-1],[-1,0]],[[0,-2],[-2,0]],[[0,-1],[-1,0]]]/2@-1", "1 1", "differences 2; digits 0 1; values 0.0:1 0.1:-1; "
             "space 1; vector -1.0:1 -1.1:-1 0.0:-2 0.1:2 1.0:1 1.1:-1; product 0 1/2 0 0; block 0 norm 1; end"),
    accepted("vector-hat", "[[[1]],[[2]],[[1]]]/2@-1", "1 1", HAT_SPACE),
    accepted("vector-shifted-hat", "[[[1]],[[2]],[[1]]]/2@0", "1 1", HAT_SPACE.replace("values 0", "values 1").replace(
        "-1.0:1 0.0:-2 1.0:1", "0.0:1 1.0:-2 2.0:1")),
    accepted("vector-rough", ROUGH_BUBBLE, "415/1000 4151/10000", BUBBLE_SPACE + "blocks 1 1 1; " + UNIT_3 +
             "; product 0 3/4 0 0; " + NORMS_3),
    ("vector-exact", f"--refinable {ROUGH_BUBBLE} --dilation [2] --exact 0-log|[-3,4]@3/4,0,1/4|^1/1",
     f"refinable {ROUGH_BUBBLE} [2]; bounds - -; exact 0-log|[-3,4]@3/4,0,1/4|^1/1; root 3/4 0 0 3/4 3/4; {BUBBLE_SPACE}"
     f"blocks 1 1 1; {UNIT_3}; block 0 polytope 1 0 2; vertex 1; unit 0 0:4; image 0 0 0:3; image 0 1 0:3; cycle 0 - 0; seed 1; "
     "block 1 norm 1; block 2 norm 1; end"),
    # the hat alone; the bubble alone; a lower end needs no largest unobservable subspace
    accepted("vector-component", ROUGH_BUBBLE, "1 1", BUBBLE_SPACE + "unobservable 2; blocks 2 1; " + UNIT_3 + "; product 1 1/2 0 0; "
             "block 0 norm 1; block 1 norm 1; end", component=0),
    accepted("vector-component-blocks", ROUGH_BUBBLE, "1 1", BUBBLE_SPACE + "unobservable 2; blocks 1 1 1; " + UNIT_3 +
             "; product 2 1/2 0 0; " + NORMS_3, component=0),
    accepted("vector-component-rough", ROUGH_BUBBLE, "415/1000 4151/10000", BUBBLE_SPACE + "unobservable 0; blocks 1 1 1; " + UNIT_3 +
             "; product 0 3/4 0 0; " + NORMS_3, component=1),
    accepted("vector-component-whole", ROUGH_BUBBLE, "1/5", BUBBLE_SPACE + "unobservable 0; block 0 norm 16; end", component=0),
    ("vector-component-exact", f"--refinable {ROUGH_BUBBLE} --dilation [2] --component 0 --exact 0-log|[-1,2]@1/2,0,1/4|^1/1",
     f"refinable {ROUGH_BUBBLE} [2] component=0; bounds - -; exact 0-log|[-1,2]@1/2,0,1/4|^1/1; root 1/2 0 0 1/2 1/2; {BUBBLE_SPACE}"
     f"unobservable 2; blocks 2 1; {UNIT_3}; block 0 norm 1; block 1 polytope 1 0 1; vertex 1; unit 0 0:2; image 0 0 0:1; image 0 1; "
     "cycle 0 - 0; seed 1; end"),
    # one of several: the hat, the quadratic B-spline, both, with other factors, and one function of both
    accepted("vector-integral-hat", HAT_BESIDE, "1 1", TWO.replace("values 0.1:1 1.1:1", "values 0.0:1").replace("differences 3", "differences 2")
             + "functional 1 0; functional 0 1; " + HAT_SPACE[HAT_SPACE.index("space"):], integral="1,0"),
    accepted("vector-integral-spline", HAT_BESIDE, "2 2", TWO + "functional 0 -3; functional 1 0; " + SPLINE_SPACE, integral="0,1"),
    accepted("vector-integral-factor", HAT_BESIDE, "2 2", TWO + "functional 2 0; functional 1 5; " + SPLINE_SPACE, integral="0,-5/3"),
    accepted("vector-integral-both", HAT_BESIDE, "1 1", BOTH + "blocks 1 1; basis 1 0; basis 0 1; inverse 1 0; inverse 0 1; product 0 1/2 0 0; "
             + NORMS_2, integral="1,1/2"),
    accepted("vector-integral-component", HAT_BESIDE, "2 2", BOTH + "unobservable 1; blocks 1 1; basis 1 0; basis 0 1; inverse 1 0; inverse 0 1; "
             "product 1 1/4 0 0; " + NORMS_2, integral="1,1/2", component=1),
    # B has the eigenvalue 1 with one eigenvector and the multiplicity 2; other eigenvalues; values with another sum than the integral
    accepted("vector-integral-jordan", JORDAN, "1 1", JORDAN_LINES + "space 1; " + HAT_VECTOR + "product 0 1/2 0 0; block 0 norm 1; end", integral="1,0"),
    accepted("vector-integral-hermite", HERMITE, "2 2", HERMITE_SPACE.replace("space", "functional -2 0; space") + "basis -3 1 1; basis 1 0 0; basis 0 4 0; "
             "inverse 0 1 0; inverse 0 0 1/4; inverse 1 3 -1/4; product 0 1/4 0 0; " + NORMS_3, integral="3,0"),
    accepted("vector-integral-courant", COURANT, "1 1", COURANT_SPACE.replace("space", "functional 1 0; space"), "[2,0;0,2]", integral="7,2"),
    accepted("vector-integral-minus-two", HAT_BUBBLE, "1 1", MINUS_SPACE.replace("space", "functional 1 0; space"), "[-2]", integral="3,2"),
    # x' is 1; a lower end alone
    accepted("vector-digits", HAT_BUBBLE, "1/2", DIGITS_SPACE + "block 0 norm 12; end"),
    accepted("vector-minus-two", HAT_BUBBLE, "1 1", MINUS_SPACE, "[-2]"),
    accepted("vector-courant", COURANT, "1 1", COURANT_SPACE, "[2,0;0,2]"),
]

CHANGED = []

DOUBLE_HAT = "[[[1,0],[0,0]],[[2,0],[0,0]],[[1,0],[0,0]]]/2@-1"


HAT_SUMS = HAT_BUBBLE.replace("[0,1]", "[0,4]").replace("[4,1]", "[4,4]")  # phi_1 is a step


def of_component(number, mask=ROUGH_BUBBLE, ends="--lower 1 --upper 1"):
    return f"--refinable {mask} --dilation [2] --component {number} {ends}"


def claim(mask, dilation="[2]", ends="--lower 1"):
    return f"--refinable {mask} --dilation {dilation} {ends}"


def of_integral(integral, mask=HAT_BESIDE, ends="--lower 1"):
    return claim(mask, ends=ends) + f" --integral {integral}"


NOT_UNIQUE = "the refinement equation may have several continuous solutions"
# name, base, options, reason, edits, with `; ` between lines
EDITED = [
    # two hats; a hat of lattice points that are three apart
    ("vector-two-hats", "vector-ends", claim("[[[1,0],[0,1]],[[2,0],[0,2]],[[1,0],[0,1]]]/2@-1"), NOT_UNIQUE,
     [(HAT_HAAR, "[[[1,0],[0,1]],[[2,0],[0,2]],[[1,0],[0,1]]]/2@-1")]),
    ("vector-two-hats-minus", "vector-minus-two", claim("[[[1,0],[0,1]],[[2,0],[0,2]],[[1,0],[0,1]]]/2@-1", "[-2]"), NOT_UNIQUE,
     [(HAT_BUBBLE, "[[[1,0],[0,1]],[[2,0],[0,2]],[[1,0],[0,1]]]/2@-1")]),
    ("vector-three-apart", "vector-hat", claim("[[[1]],[[0]],[[0]],[[2]],[[0]],[[0]],[[1]]]/2@-3"), NOT_UNIQUE,
     [("[[[1]],[[2]],[[1]]]/2@-1", "[[[1]],[[0]],[[0]],[[2]],[[0]],[[0]],[[1]]]/2@-3")]),
    ("vector-three-apart-minus", "vector-ends-minus-two", claim("[[[1]],[[0]],[[0]],[[2]],[[0]],[[0]],[[1]]]/2@-3", "[-2]"), NOT_UNIQUE,
     [("[[[0,0],[0,2]],[[1,0],[0,2]],[[2,0],[0,0]],[[1,0],[0,0]]]/2@-2", "[[[1]],[[0]],[[0]],[[2]],[[0]],[[0]],[[1]]]/2@-3")]),
    # a fixed vector with values at an end of the support
    ("vector-value-at-end", "vector-ends", claim(HAT_HAAR, ends="--lower 1/100"), "the bound does not prove the claim",
     [("differences 2", "differences 1"), ("values 0.0:1", "values 0.1:1"),
      ("vector -1.0:1 0.0:-2 1.0:1", "vector 0.1:1 1.1:-1"), ("product 0 1/2 0 0", "product 0 1 0 0")]),
    # rows and columns exchanged: both are refinable
    ("vector-transposed", "vector-ghm", claim("[[[6,-1],[8,-3]],[[6,9],[0,10]],[[0,9],[0,-3]],[[0,-1],[0,0]]]/10@0"),
     "not fixed",
     [(GHM, "[[[6,-1],[8,-3]],[[6,9],[0,10]],[[0,9],[0,-3]],[[0,-1],[0,0]]]/10@0")]),
    ("vector-transposed-values", "vector-double-knots", claim("[[[2,0],[2,1]],[[2,2],[0,4]],[[0,2],[0,1]]]/4@0"), "not fixed",
     [(DOUBLE_KNOTS, "[[[2,0],[2,1]],[[2,2],[0,4]],[[0,2],[0,1]]]/4@0")]),
    ("vector-other-mask", "vector-ghm", claim(HERMITE), "expected 'refinable ", []),
    ("vector-as-surface", "vector-hat", "--surface [1,2,1]/2@-1 --dilation [2] --lower 1", "expected 'surface ", []),
    ("vector-other-dilation", "vector-by-hand", claim(HAT_BUBBLE, "[3]"), "expected 'refinable ", []),
    # points and components
    *((f"vector-place-{name}", "vector-by-hand", None, reason, [("values 0.0:1", f"values {values}")]) for name, values, reason in (
        ("missing", "0:1", "POINT.COMPONENT"), ("two", "0.0.0:1", "POINT.COMPONENT"), ("outside", "0.2:1", "number outside 0..1"),
        ("minus", "0.-1:1", "number outside 0..1"), ("empty", "0.:1", "not an integer"), ("point", ".0:1", "not an integer"),
        ("coordinates", "0,0.0:1", "another number of coordinates"), ("twice", "0.0:1 0.0:1", "occurs twice"), ("zero", "0.0:0", "a coefficient is 0"),
        ("term", "0.0", "a term is POINT:INTEGER"), ("other", "0.1:1", "not fixed"), ("more", "0.0:1 0.1:1", "not fixed"))),
    ("vector-digit-component", "vector-by-hand", None, "not an integer", [("digits 0 1", "digits 0.0 1.0")]),
    ("vector-component-of-surface", "trapezoid-by-hand", None, "not an integer", [("values 1:1", "values 1.0:1")]),
    ("vector-no-values", "vector-by-hand", None, "expected 'values'", [("values 0.0:1; ", "")]),
    ("vector-no-value", "vector-by-hand", None, "wrong number of fields", [("values 0.0:1", "values")]),
    # the space
    ("vector-larger-space", "vector-ends", None, "the differences do not span the space",
     [("space 1", "space 2"), ("vector -1.0", "vector 0.1:1; vector -1.0"), ("; product", "; blocks 1 1; basis 1 0; basis 0 1; inverse 1 0; inverse 0 1; product")]),
    ("vector-smaller-space", "vector-by-hand", None, "a transition operator leads out of the space",
     [("space 3; vector 0.1:1; ", "space 2; ")]),
    ("vector-not-led", "vector-by-hand", None, "not led into the space", [("space 3; ", "space 2; "), ("; vector -1.0:1 0.0:-2 1.0:1", "")]),
    ("vector-lower-order", "vector-hermite", None, "not led into the space", [("differences 3", "differences 2")]),
    ("vector-above-order", "vector-by-hand", claim(HAT_BUBBLE, ends="--lower 201/100"), "the lower end is above the order of the differences", []),
    ("vector-order-1", "vector-hat", None, "the product proves no exponent below the number of sum rules",
     [("differences 2", "differences 1"), ("vector -1.0:1 0.0:-2 1.0:1", "vector 0.0:1 -1.0:-1"), ("space 1", "space 2"), ("; product 0 1/2 0 0", "; vector 1.0:1 -1.0:-1; product 0 1/2 0 1"),
      ("block 0 norm 1", "block 0 norm 12")]),
    ("vector-order-65", "vector-by-hand", None, ", line 4", [("differences 2", "differences 65")]),
    ("vector-sum-rules", "vector-by-hand", None, "expected 'differences'", [("differences 2", "sum-rules 2")]),
    ("vector-turned", "vector-by-hand", None, "expected 'digits'", [("digits", "turned [-2]; digits")]),
    ("vector-stability", "vector-by-hand", None, "expected 'digits'", [("digits", "stability; digits")]),
    ("vector-gram", "vector-ends", None, "expected 'product'", [("; product", "; gram 0.0:4 1.0:1; product")]),
    ("vector-second-part", "vector-ends", None, "expected 'end'",
     [("; end", "; sum-rules 1; space 1; vector -1.0:1 0.0:-2 1.0:1; block 0 norm 1; end")]),
    # the ends
    ("vector-lower", "vector-by-hand", claim(HAT_BUBBLE, ends="--lower 1001/1000"), "the bound does not prove the claim", []),
    ("vector-upper", "vector-by-hand", claim(HAT_BUBBLE, ends="--lower 1 --upper 999/1000"), "does not prove the claim", []),
    ("vector-no-product", "vector-by-hand", None, "expected 'product'", [("; product 1 1/2 0 0", "")]),
    ("vector-lower-zero", "vector-by-hand", claim(HAT_BUBBLE, ends="--lower 0"), "must be positive", []),
    ("vector-exact-other", "vector-exact", f"--refinable {ROUGH_BUBBLE} --dilation [2] --exact 0-log|[-2,3]@2/3,0,1/4|^1/1", "expected 'exact ", []),
    ("vector-exact-order", "vector-exact", f"--refinable {ROUGH_BUBBLE} --dilation [2] --exact 2-log|[-3,4]@3/4,0,1/4|^1/1",
     "another number before its logarithm", [("exact 0-log", "exact 2-log")]),
    ("vector-exact-1", "vector-exact", f"--refinable {HAT_HAAR} --dilation [2] --exact 0-log|[-1,1]@1,0,1/4|^1/1",
     "no exponent between 0 and the number of sum rules",
     [(ROUGH_BUBBLE, HAT_HAAR), ("[-3,4]@3/4", "[-1,1]@1"), ("root 3/4 0 0 3/4 3/4", "root 1 0 0 1 1")]),
    # one of several
    ("vector-integral-none", "vector-integral-spline", None, "expected 'functional'", [("functional 0 -3; functional 1 0; ", "")]),
    ("vector-integral-not-asked", "vector-integral-hermite", claim(HERMITE), "expected 'space'", [(" integral=3,0", "")]),
    ("vector-integral-in-head", "vector-integral-spline", claim(HAT_BESIDE), "wrong number of fields", []),
    ("vector-integral-other", "vector-integral-spline", of_integral("1,0"), "expected 'refinable ", []),
    ("vector-integral-fields", "vector-integral-spline", None, "wrong number of fields", [("functional 1 0", "functional 1")]),
    ("vector-integral-rational", "vector-integral-spline", None, "not an integer", [("functional 1 0", "functional 1/2 0")]),
    ("vector-integral-hat-spline", "vector-integral-spline", of_integral("1,0"), "the values are not those of this integral", [("integral=0,1", "integral=1,0")]),
    ("vector-integral-sum", "vector-integral-both", of_integral("1,1"), "the values are not those of this integral", [("integral=1,1/2", "integral=1,1")]),
    ("vector-integral-first-zero", "vector-integral-spline", of_integral("1,1"), "the values are not those of this integral",
     [("integral=0,1", "integral=1,1"), ("functional 0 -3; functional 1 0", "functional 1 -1; functional 1 0")]),
    ("vector-integral-zero", "vector-integral-hat", of_integral("0,1"), "the values are of the integral 0",
     [("integral=1,0", "integral=0,1"), ("functional 1 0; functional 0 1", "functional 0 1")]),
    ("vector-integral-no-sum", "vector-integral-spline", None, "the values are of the integral 0", [("functional 0 -3; ", "")]),
    ("vector-integral-fixed", "vector-integral-hermite", of_integral("3,1", HERMITE), "the integral is none of a solution", [("integral=3,0", "integral=3,1")]),
    ("vector-integral-functional", "vector-integral-hermite", None, "a functional does not tell integrals", [("functional -2 0", "functional -2 1")]),
    ("vector-integral-few", "vector-integral-spline", None, "the functionals do not tell all of an integral", [("; functional 1 0", "")]),
    ("vector-integral-jordan-few", "vector-integral-jordan", None, NOT_UNIQUE, [("; functional 0 1", "")]),
    ("vector-integral-two", "vector-hat", of_integral("1", "[[[1]],[[0]],[[0]],[[2]],[[0]],[[0]],[[1]]]/2@-3"), NOT_UNIQUE,
     [("[[[1]],[[2]],[[1]]]/2@-1 [2]", "[[[1]],[[0]],[[0]],[[2]],[[0]],[[0]],[[1]]]/2@-3 [2] integral=1"), ("; space", "; functional 1; space")]),
    ("vector-integral-rough", "vector-integral-both", of_integral("1,1/2", ends="--lower 2"), "the bound does not prove the claim", []),
    ("vector-integral-component-other", "vector-integral-component", of_integral("1,1/2") + " --component 0", "expected 'refinable ", []),
    # one component
    ("vector-component-other", "vector-component", of_component(1), "expected 'refinable ", []),
    ("vector-component-of-all", "vector-component", claim(ROUGH_BUBBLE), "wrong number of fields", []),
    ("vector-component-in-all", "vector-component", claim(ROUGH_BUBBLE, ends="--lower 2/5"), "expected 'block 0'",
     [(" component=0", ""), ("; product 1 1/2 0 0", "")]),
    ("vector-component-no-line", "vector-component", None, "expected 'unobservable'", [("unobservable 2; ", "")]),
    *((f"vector-component-{name}", "vector-component", None, "number outside 0..2", [("unobservable 2", f"unobservable {size}")])
      for name, size in (("minus", -1), ("all", 3))),
    ("vector-component-part", "vector-component", of_component(0, ends="--lower 1"), "consists of no blocks", [("unobservable 2", "unobservable 1")]),
    ("vector-component-less", "vector-component-blocks", None, "more than what is said to be unobservable may be so",
     [("unobservable 2", "unobservable 1")]),
    ("vector-component-none", "vector-component", None, "more than what is said to be unobservable may be so",
     [("unobservable 2", "unobservable 0")]),
    ("vector-component-none-exact", "vector-component-exact", None, "more than what is said to be unobservable may be so",
     [("unobservable 2", "unobservable 0")]),
    ("vector-component-shown", "vector-component", of_component(1, ends="--lower 1"), "shows what is said to be unobservable",
     [("component=0", "component=1")]),
    ("vector-component-no-blocks", "vector-component-whole", None, "expected 'blocks'", [("unobservable 0", "unobservable 2")]),
    ("vector-component-product", "vector-component", None, "number outside 1..1", [("product 1 1/2", "product 0 3/4")]),
    ("vector-component-product-blocks", "vector-component-blocks", None, "number outside 2..2", [("product 2 1/2", "product 1 3/4")]),
    ("vector-component-discontinuous", "vector-component", of_component(0, HAT_SUMS), "the bound does not prove the claim",
     [(ROUGH_BUBBLE, HAT_SUMS)]),
    ("vector-component-discontinuous-exact", "vector-component-exact",
     of_component(0, HAT_SUMS, "--exact 0-log|[-1,2]@1/2,0,1/4|^1/1"), "the bound does not prove the claim", [(ROUGH_BUBBLE, HAT_SUMS)]),
    ("vector-component-upper", "vector-component", of_component(0, ends="--lower 1 --upper 999/1000"), "does not prove the claim", []),
    ("vector-component-lower", "vector-component", of_component(0, ends="--lower 1001/1000"), "the bound does not prove the claim", []),
    ("vector-component-rough-lower", "vector-component-rough", of_component(1, ends="--lower 416/1000"), "the bound does not prove the claim", []),
    ("vector-component-attained-there", "vector-component-exact", of_component(0, ends="--exact 0-log|[-3,4]@3/4,0,1/4|^1/1"),
     "no block attains the exact radius", [("[-1,2]@1/2", "[-3,4]@3/4"), ("root 1/2 0 0 1/2 1/2", "root 3/4 0 0 3/4 3/4"), ("; cycle 0 - 0; seed 1", "")]),
    ("vector-component-surface", "hat-lower", None, "wrong number of fields", [("[2]", "[2] component=0")]),
    # the dilation, the digits, sizes
    ("vector-digits-class", "vector-by-hand", None, "two digits of one class", [("digits 0 1", "digits 0 2")]),
    ("vector-not-isotropic", "vector-courant", claim(COURANT, "[2,0;0,3]"), "not isotropic", [("[2,0;0,2]", "[2,0;0,3]")]),
    ("vector-zero", "vector-hat", claim("[[[0]],[[0]]]"), "all coefficients of the mask are 0", [("[[[1]],[[2]],[[1]]]/2@-1", "[[[0]],[[0]]]")]),
    ("vector-far", "vector-hat", claim("[[[1]],[[2]],[[1]]]/2@999999"), "more work than the checker allows",
     [("[[[1]],[[2]],[[1]]]/2@-1", "[[[1]],[[2]],[[1]]]/2@999999"), ("values 0.0", "values 1000000.0")]),
    ("vector-too-far", "vector-hat", claim("[[[1]],[[2]],[[1]]]/2@1000000001"), "a coordinate is too large",
     [("[[[1]],[[2]],[[1]]]/2@-1", "[[[1]],[[2]],[[1]]]/2@1000000001")]),
]
REJECTED = [(name, base, options, reason, [tuple(part.replace("; ", "\n") for part in edit) for edit in edits])
            for name, base, options, reason, edits in EDITED]
