"""Cases that tell wrong variants of the checkers from them, where the other cases do not."""
import math
from fractions import Fraction

import edge_cases

FOUR_POINT = "[-1,0,9,16,9,0,-1]/16@-3"
RANGE_FOUR_POINT = "[-w,0,1/2+w,1,1/2+w,0,-w]@-3"
TRAPEZOID = "[1,1,0,1,1]/2@0"
CONVERGES = f"{edge_cases.CONVERGES}; block 0 norm 2"
ROOT_1 = "exact |[-1,1]@1,0,1/10|^1/1; root 1 0 0 1 1"
EXACT_1 = "--exact |[-1,1]@1,0,1/10|^1/1"
MORE, TINY, LESS = 2**129, 2**340, 2**700


def product(*factors):
    result = [1]
    for factor in factors:
        result = [sum(result[i] * factor[n - i] for i in range(len(result)) if 0 <= n - i < len(factor))
                  for n in range(len(result) + len(factor) - 1)]
    return result


def mask(coefficients):
    return "[" + ",".join(map(str, coefficients)) + "]"


# phi = hat(x) - hat(x - 1) + hat(x - 2), of arity 5: zeros of its transform at pi/3 and all its shifts
ARITY_5 = f"{mask(product([1] * 5, [1] * 5, [1, 1, 0, -1, -1, -1, 0, 1, 1]))}/5"
COPRIME = f"[1/{2**6000}*w,1/{3**3785},1/{3**3785}-1/{2**6000}*w]/(1/{3**3785})"
ARITY_6 = mask(product([1] * 6, [1, 0, -1, 0, 1]))


def ramp(size):
    """A mask with one sum rule and transition matrices of this size."""
    return f"[1,{'2,' * size}1]/{size + 1}"


def quotient(low, high):
    """A range claim about fractions with the denominators 1 + low and 1 + high; and its lines."""
    return (f"--mask [1,v,v,1]/(1+v) --arity 2 --for v={low}..{high} --lower 0",
            f"exponent [1,v,v,1]/(1+v) 2 v={low}..{high}; bounds 0 -; sum-rules 1; to {high}; block 0 norm 1; end")


def rows(*matrices):
    return [[[str(x) for x in row] for row in matrix] for matrix in matrices]


def rounded_limit(order):
    """A mask with this number of sum rules, and an EPS for which the norms are at most 4/3 + e = 2^(order - 1)."""
    text = f"{mask(product(*[[1, 1]] * order, [1, 4, 1]))}/{3 * 2**order}"
    largest = math.comb(2 * order + 2, order)  # the coefficient of z^(order + 2) in 1/(1-z)^(order + 1)
    return order, text, (2 ** (order - 1) - Fraction(4, 3)) / (2 * 2**order * largest)


def halved(factor, power):
    """A range claim for which (w - 1/3)^2 + e^2 is shown to be positive, e = factor/2^power; and its lines."""
    e = Fraction(factor) / 2**power
    b = [(1 + Fraction(1, 9) - e / 3, Fraction(-1, 3)), (1 - Fraction(2, 9) - e / 3, Fraction(2, 3)), (1 + Fraction(1, 9) + 2 * e / 3, Fraction(-1, 3))]
    a = [tuple(sum(b[i][k] for i in range(3) if 0 <= n - i < 3) / 3 for k in range(2)) for n in range(5)]
    text = mask([f"{c}{'+' if d > 0 else '-'}{abs(d)}*w" if d else str(c) for c, d in a])
    return (f"--mask {text} --arity 3 --for w=0..1 --lower 0",
            f"exponent {text} 3 w=0..1; bounds 0 -; sum-rules 1 full; to 1; block 0 norm 1; end")


# name, rows of its matrices
MATRICES = [
    ("denominators.mat", rows([[f"1/{2**6000}", 0], [0, f"1/{2**3999 + 1}"]])),
    ("upper.mat", rows([["1/2", f"1/{2**6000}"], [0, "1/2"]])),
    ("unit-4.mat", rows([[int(i == j) for j in range(4)] for i in range(4)])),
    ("unit-12.mat", rows([[int(i == j) for j in range(12)] for i in range(12)])),
    ("off-diagonal.mat", rows([["1000001/1000003", "1/1009"], ["1/1013", "999/1000"]])),
    ("power.mat", rows([[2**295]])),
    ("ellipse.mat", rows([[0, "-1/5"], [5, 0]])),
    ("odd.mat", rows([[1, 0], [0, 3]])),
    ("double.mat", rows([[1, 0], [0, 2]])),
    ("turn.mat", rows([[1, -1], [1, 1]])),
    ("three.mat", rows([[3]])),
    ("first-half.mat", rows([[1, 0], [0, 0]], [[1, 0], ["1/2", 0]])),
    ("below.mat", rows([[1, 0, 0], [0, 1, 0], [0, 1, 1]])),
    ("unit-shear.mat", rows([[1, 0], [0, 1]], [[1, 1], [0, 1]])),
    ("middle.mat", rows([[1, 0], [0, 0]], [[1, 0], [0, 1]], [[1, 0], [0, 0]])),
    ("three-quarters.mat", rows([[1]], [["3/4"]])),
    ("one-two.mat", rows([[1]], [[2]])),
]

# name, options of the claim, and the lines after the first one
ACCEPTED = [
    # common denominators of 10000 bits
    ("denominators", "--matrices denominators.mat --upper 1", "radius 1 2; bounds - 1; block 0 norm 1; end"),
    ("quotient-denominators", *quotient(2**4999, 2**5001 - 1)),
    ("quotient-denominators-coprime", f"--mask {COPRIME} --arity 2 --for w=1/4..3/4 --lower 0",
     f"exponent {COPRIME} 2 w=1/4..3/4; bounds 0 -; sum-rules 1; to 3/4; block 0 norm 1; end"),
    # a group of 96 elements up to signs
    ("group-of-96", "--matrices unit-4.mat --upper 3",
     "radius 1 4; bounds - 3; block 0 polytope 1 0 0 group:3; generator 0; map 0 1 0 0; map 1 0 0 0; map 0 0 1 0; map 0 0 0 1; "
     "generator 0; map 0 0 0 1; map 1 0 0 0; map 0 1 0 0; map 0 0 1 0; generator 0; map -1 0 0 0; map 0 -1 0 0; map 0 0 1 0; "
     "map 0 0 0 1; vertex 1 0 0 0; unit 0 0:1; unit 1 0B:1; unit 2 0BB:1; unit 3 0BBB:1; image 0 0 0:1 0:1 0:-1; end"),
    # weights with moduli that are integers, and one that is not
    ("one-complex", "--matrices one.mat --lower 1 --upper 1",
     "radius 1 1; bounds 1 1; product 0 1 0 0; block 0 polytope 1 0 0 complex; vertex 1 0; unit 0 0:1:0; image 0 0 0:1:0; end"),
    ("turn-coarse", "--matrices turn.mat --upper 3/2",
     "radius 1 2; bounds - 3/2; block 0 polytope 1 0 1 complex; vertex 1 0 0 -1; unit 0 0:1:0 0c:1:0; unit 1 0:0:1 0c:0:-1; "
     "image 0 0 0:2:2; end"),
    # a space that begins with the differences, and one that is larger
    ("trapezoid-space", f"--surface {TRAPEZOID} --dilation [2] --lower 1 --upper 1",
     f"surface {TRAPEZOID} [2]; bounds 1 1; differences 2; digits 0 1; values 1:1 2:1 3:1; space 2; vector 0:1 1:-1 3:-1 4:1; "
     f"vector 5:1 1:1 2:-1 4:-1; product 0 1/2 0 0; block 0 norm 1; {CONVERGES}; end"),
    ("trapezoid-larger-space", f"--surface {TRAPEZOID} --dilation [2] --lower 1",
     f"surface {TRAPEZOID} [2]; bounds 1 -; differences 2; digits 0 1; values 1:1 2:1 3:1; space 3; vector 0:1 1:-1 3:-1 4:1; "
     f"vector 5:1 1:1 2:-1 4:-1; vector 6:1 1:1 3:-1 4:-1; block 0 norm 1; {CONVERGES}; end"),
    # a line `stability` that the claim does not need
    ("hat-lower-stable", "--mask [1,2,1]/2@-1 --arity 2 --lower 1",
     "exponent [1,2,1]/2@-1 2; bounds 1 -; sum-rules 2; stability; block 0 norm 1; end"),
    # Phi_12 divides the mask, and 2 is not coprime to 6
    ("arity-6-cyclotomic", f"--mask {ARITY_6} --arity 6",
     f"exponent {ARITY_6} 6; bounds - -; sum-rules 1; stability; end"),
    ("quotient-no-constant", "--mask [w,2*w,w]/(2*w)@-1 --arity 2 --for w=1..2 --lower 0",
     "exponent [w,2*w,w]/(2*w)@-1 2 w=1..2; bounds 0 -; sum-rules 1; to 2; block 0 norm 1; end"),
    # no first index
    ("hat-at-0", "--surface [1,2,1]/2 --dilation [2] --lower 1",
     "surface [1,2,1]/2 [2]; bounds 1 -; sum-rules 2; digits 0 1; space 1; vector 0:1 1:-2 2:1; block 0 norm 1; end"),
    # integers that grow with each letter
    ("quadratic-large-entries", "--matrices off-diagonal.mat --upper 11/10",
     "radius 1 2; bounds - 11/10; block 0 quadratic 1 11/10; form 1; form 0 1; word 0 0 0; end"),
    # the longest of three polyphase parts is not the last one; with the other lengths the resultant has a zero
    ("ternary-stable-lengths", "--mask [w,1/3,1/2,1-2*w,2/3,1/2,w] --arity 3 --for w=1/5..1/4",
     "exponent [w,1/3,1/2,1-2*w,2/3,1/2,w] 3 w=1/5..1/4; bounds - -; sum-rules 1; stability; end"),
    # one of the other parts begins with 0, and is shifted by itself
    ("ternary-stable-shifted", "--mask [w,1/3,0,1-2*w,2/3,1/2,w,0,1/2] --arity 3 --for w=1/5..1/4",
     "exponent [w,1/3,0,1-2*w,2/3,1/2,w,0,1/2] 3 w=1/5..1/4; bounds - -; sum-rules 1; stability; end"),
    # a polyphase part that begins with 0, beside one that does so for one w
    ("four-point-range-stable", f"--mask {RANGE_FOUR_POINT} --arity 2 --for w=-1/100..19/100",
     f"exponent {RANGE_FOUR_POINT} 2 w=-1/100..19/100; bounds - -; sum-rules 2; stability; end"),
    ("one-symmetric", "--matrices one.mat --lower 1 --upper 1",
     "radius 1 1; bounds 1 1; product 0 1 0 0; block 0 polytope 1 0 0 symmetric; vertex 1; unit 0 0:1; image 0 0 0:1; end"),
    # as many halvings as allowed
    ("range-halved-60", *halved("3/2", 61)),
    # integers of as many bits as are looked at
    ("inverse-296-bits", f"--matrices power.mat --lower {2**294} --upper {2**295}",
     f"radius 1 1; bounds {2**294} {2**295}; product 0 {2**295 - 1} 0 0; inverse 0; column 0 -1; block 0 norm 1; end"),
    # the largest coordinate of an eigenvector is imaginary and negative
    ("ellipse-exact", "--matrices ellipse.mat --exact |[1,0,1]@0,1,1/10|^1/1",
     "radius 1 2; bounds - -; exact |[1,0,1]@0,1,1/10|^1/1; root 0 1 0 1 1; block 0 polytope 1 0 64 complex; vertex 1 0 0 -5; "
     f"unit 0 0:{2**63}:0 0c:{2**63}:0; unit 1 0:0:{2**64 // 10} 0c:0:{-(2**64 // 10)}; image 0 0 0:0:{2**64}; cycle 0 - 0; "
     "seed 1 0; end"),
    # more rows than are computed together
    ("quadratic-12", "--matrices unit-12.mat --upper 2",
     f"radius 1 12; bounds - 2; block 0 quadratic 1 2; {'; '.join('form ' + '0 ' * i + '1' for i in range(12))}; word 0; end"),
    # a reflection, and an odd order of the sum rules
    ("surface-exact-reflected", "--surface [1,3,3,1]/4 --dilation [-2] --exact 0-log|[1,4]@-1/4,0,1/10|^1/1",
     "surface [1,3,3,1]/4 [-2]; bounds - -; exact 0-log|[1,4]@-1/4,0,1/10|^1/1; root -1/4 0 0 1/4 1/4; sum-rules 3; digits 6 1; "
     "space 1; vector 0:1 1:-3 2:3 3:-1; gram 0:66 1:26 2:1; block 0 polytope 1 0 2; vertex 1; unit 0 0:4; image 0 0 0:-1; image 0 1; "
     "cycle 0 - 0; seed 1; end"),
]

# name, accepted case that is changed, other options or None, changes of its text
CHANGED = [
    ("first-exact-minus", "first-exact", None,
     [("vertex 4 0\n", "vertex -4 0\n"), ("unit 0 0:4\n", "unit 0 0:-4\n")]),
    ("single-recurrence-signs", "single-four-point", None,
     [("recurrence -4 1\n", "recurrence 4 -1\n"), ("recurrence 1 -2 1\n", "recurrence -1 2 -1\n")]),
    ("rotation-exact-seed-minus", "rotation-exact", None, [("seed 1 0", "seed -1 0")]),
    ("hat-gram-negative", "hat-by-hand", None, [("gram 0:4 1:1\n", "gram 0:4 -1:1\n")]),
]

# name, accepted case that is changed, other options or None, reason, changes of its text
REJECTED = [
    ("first-line-empty", "golden", None, "expected 'subcert-certificate 3', line 1", [("subcert-certificate 3\n", "\nsubcert-certificate 3\n")]),
    ("root-high-negative", "four-point-exact", None, "its modulus not positive", [("root 4 0 0 4 4\n", "root 4 0 0 4 -4\n")]),
    ("single-bound-zero", "single-four-point", None, "the recurrence may have a zero above the bound", [("single 4 0\n", "single 0 0\n")]),
    ("gram-sum-0", "hat-by-hand", None, "have no positive sum", [("gram 0:4 1:1\n", "gram 0:2 1:-1\n")]),
    ("origin-order-middle", "slow-exact", None, ", line 28",
     [("origin 1 0 1\norigin 2 0 0\n", "origin 2 0 0\norigin 1 0 1\n")]),
    # no `stability` where it is needed
    ("upper-0-no-stability", "four-point-norm", f"--mask {FOUR_POINT} --arity 2 --lower 2 --upper 0", "expected 'stability'",
     [("stability\n", "")]),
    ("rough-lower-no-stability", "hat-full-lower", "--mask [1,2,1]/2@-1 --arity 2 --lower 1 --upper C2", "expected 'stability'", []),
    ("exact-lower-no-stability", "four-point-exact", f"--mask {FOUR_POINT} --arity 2 --lower 2 --exact 4-log|[-4,1]@4,0,1|^1/1",
     "expected 'stability'", [("stability\n", "")]),
    ("no-bounds-no-stability", "hat-full-lower", "--mask [1,2,1]/2@-1 --arity 2", "expected 'stability'", []),
    ("exact-no-section", "four-point-exact", f"--mask {FOUR_POINT} --arity 2 --exact 4-log|[-4,1]@4,0,1|^1/1", "expected 'block 0'",
     [("block 0 polytope 1 0 0 symmetric\nvertex 0 1\nunit 0 0f:1\nimage 0 0 0:4\nimage 0 1 0:-1 0f:-1\ncycle 0 - 0\nseed 0 1\n", "")]),
    ("surface-exact-no-gram", "surface-exact", "--surface [-1,0,11,20,11,0,-1]/20@0 --dilation [2] --exact 0-log|[1,-10,20]@9/25,0,1/10|^1/1",
     "expected 'gram'", [("gram 0:48445920 1:9041842 2:-1972920 3:109061 4:-2400 5:-3\n", "")]),
    # the same product by more coefficients at the end
    ("reduced-more", "trapezoid-reduced", None, "the reduced mask is not that of the mask and the factor",
     [("[1,2,1]/2\n", "[1,2,1,0,0,0,0,1,0,-2,0,1]/2\n")]),
    # values of which a part is fixed, and others of which as many points are taken to
    ("values-more", "trapezoid-by-hand", None, "the values line is not fixed",
     [("values 1:1 2:1 3:1\n", "values 1:1 2:1 3:1 5:1 6:-1 8:-1 9:1\n")]),
    ("values-moved", "trapezoid-by-hand", None, "the values line is not fixed", [("values 1:1 2:1 3:1\n", "values 5:1 6:-1 9:3\n")]),
    ("values-one-fixed", "trapezoid-by-hand", None, "the values line is not fixed", [("values 1:1 2:1 3:1\n", "values 1:1 2:1 3:2\n")]),
    ("polytope-no-fields", "golden", None, ", line 5", [("polytope 4 64 64", "polytope")]),
    ("origin-twice", "slow-exact", None, ", line 28", [("origin 1 0 1\n", "origin 1 0 1\norigin 1 0 1\n")]),
    ("gram-twice-on-axis", "three-direction", None, "a point occurs twice", [("gram 0,0:6 0,1:1 ", "gram 0,0:6 0,1:1 0,-1:1 ")]),
    ("quadratic-large-entries-high", "quadratic-large-entries", "--matrices off-diagonal.mat --upper 1", "a product is not below the bound",
     [("quadratic 1 11/10", "quadratic 1 1")]),
    ("term-without-point", "hat-lower", None, ", line 7", [("vector -1:1 0:-2 1:1\n", "vector -1:1 0 1:1\n")]),
    # points that are too far away, or not
    ("digits-far-below", "hat-lower", None, ", line 5", [("digits 0 1\n", "digits -1000000001 0\n")]),
    ("digits-farthest", "hat-lower", None, ", line 7", [("digits 0 1\n", "digits 1000000000 1\n")]),
    ("exact-order-reflected", "hat-lower", "--surface [1,2,1]/2@-1 --dilation [-2] --exact 0-log|[-1,2]@1/2,0,1/10|^1/1",
     "proves no exponent between", [("[2]\nbounds 1 -\nsum-rules 2\n",
                                    "[-2]\nbounds - -\nexact 0-log|[-1,2]@1/2,0,1/10|^1/1\nroot 1/2 0 0 1/2 1/2\nsum-rules 1\n")]),
    ("exact-not-unique-bend", "slow-exact", "--matrices slow.mat --exact |[-24,26,-9,1]@2,0,1|^1/2", ", line 5",
     [("exact |[81,-270,100]@47/20,0,1/10|^1/2\nroot ", "exact |[-24,26,-9,1]@2,0,1|^1/2\nroot 2 0 0 1 2\nroot ")]),
    # dilations of three variables: of trace 0, and with a negative sum of minors
    *((f"dilation-{name}", "turning-3", f"--surface [[[1,2,1]]]/2@-1,0,0 --dilation {dilation} --lower 1", reason,
       [("[0,0,2;1,0,0;0,1,0]", dilation)])
      for name, dilation, reason in (("trace-0", "[2,0,0;0,2,0;0,0,-4]", "not isotropic and expanding"),
                                     ("minors-negative", "[0,0,-8;1,0,2;0,1,1]", "wrong number of fields"))),
    ("vertex-error-turned", "rotation-exact", None, "too far",
     [("polytope 1 0 64", "polytope 1 2 64"), ("vertex 1 0 0 -1", "vertex 4 -1 0 -4"), ("seed 1 0", "seed 1 1")]),
    # a remainder of the recurrence with coefficients of both signs
    ("single-no-pole-signs", "single-wide", f"--mask {FOUR_POINT[:-3]} --arity 2 --exact 4-log|[-4,1]@4,0,1/6|^1/1",
     ", line 11", [("@4,0,1|", "@4,0,1/6|"), ("root 4 0 0 7/2 9/2", "root 4 0 1/6 23/6 25/6"), ("recurrence -4 1", "recurrence -36 33 -10 1")]),
    # a change of the mask that is a little too large for the resultant
    ("rounded-quadratic-spline-stable", "rounded-stable", "--mask [1,3,3,1]/4 --arity 2 --within 1/18,1",
     "the resultant of the polyphase parts is not",
     [("[273205,473205,126795,-73205]/400000 2 within=1/100,2", "[1,3,3,1]/4 2 within=1/18,1"), ("sum-rules 2", "sum-rules 1")]),
    ("surface-mask-10000", "hat-lower", f"--surface [{'1,' * 9999}1] --dilation [2] --lower 1", ", line 2", []),
    # the largest entries, determinants and orders
    ("dilation-64", "hat-lower", "--surface [1,2,1]/2@-1 --dilation [64] --lower 1", "wrong number of fields, line 5", [("[2]", "[64]")]),
    ("surface-order-64", "hat-lower", None, "no sum rules of this order, line 5", [("sum-rules 2", "sum-rules 64")]),
    # pivots of which roots are rounded down
    ("quadratic-pivot-2", "golden-quadratic", None, "the form is not positive definite",
     [("form 1\n", f"form {2 * 2**128 + 4}\n"), ("form 0 1\n", f"form {math.isqrt(2**255) + 1} {2**255}\n")]),
]

# name, options of the claim, the lines after the first one, and the reason
WRITTEN = [
    # with HIGH < 0 the vertices would be nearer to the true ones than they are; the radius is 2
    ("root-high-negative-even", "--matrices one-two.mat --exact |[-1,1]@1,0,1/10|^1/2",
     "radius 2 1; bounds 1 1; exact |[-1,1]@1,0,1/10|^1/2; root 1 0 0 1 -1000; block 0 polytope 4 8 8; vertex 256; vertex 256; vertex 1; "
     "vertex 1; unit 0 0:256; image 0 0 0:256; image 0 1 0:512; image 1 0 0:256; image 1 1 0:512; image 2 0 0:1; image 2 1 0:2; "
     "image 3 0 0:1; image 3 1 0:2; cycle 0 - 0 0; seed 1; origin 1 0 0; origin 2 0 1; origin 3 1 1; end", "its modulus not positive, line 5"),
    ("product-zero", "--matrices zero.mat --lower 0", "radius 1 1; bounds 0 -; product 0 0 0 0; end", "no positive spectral radius"),
    ("inverse-trace-zero", "--matrices odd.mat --lower 1", "radius 1 2; bounds 1 -; product 0 2 0 0; inverse 0; column 0 1 0; column 1 0 -1; end",
     "no eigenvalue near"),
    ("norm-other-column", "--matrices axis.mat --upper 1", "radius 1 2; bounds - 1; block 0 norm 1; end", "does not prove the claim"),
    ("turn-coarse-high", "--matrices turn.mat --upper 5/4",
     "radius 1 2; bounds - 5/4; block 0 polytope 1 0 1 complex; vertex 1 0 0 -1; unit 0 0:1:0 0c:1:0; unit 1 0:0:1 0c:0:-1; "
     "image 0 0 0:2:2; end", "does not prove the claim"),
    ("unit-large-weight", "--matrices double.mat --upper 1",
     f"radius 1 2; bounds - 1; block 0 polytope 1 0 0; vertex 1 0; unit 0 0:1; unit 1 0:{2**130}; image 0 0 0:1; end",
     "the vertices do not span"),
    ("same-other-cycle", f"--matrices ones.mat {EXACT_1}",
     f"radius 1 2; bounds - -; {ROOT_1}; block 0 polytope 2 0 0; vertex 1 0; vertex 0 1; unit 0 0:1; unit 1 1:1; image 0 0 0:1; "
     "image 1 0 1:1; cycle 0 - 0; seed 1 0; cycle 1 - 0; seed 0 1; same 0 0 1; end", "not the vertex that it is said to be"),
    ("same-beside-cycle", "--matrices swap.mat --exact |[-1,1]@1,0,1/10|^1/2",
     "radius 1 2; bounds - -; exact |[-1,1]@1,0,1/10|^1/2; root 1 0 0 1 1; block 0 polytope 3 0 0; vertex 1 0; vertex 1 0; "
     "vertex 0 1; unit 0 0:1; unit 1 2:1; image 0 0 2:1; image 1 0 2:1; image 2 0 0:1; cycle 0 - 0 0; seed 1 0; origin 2 0 0; "
     "same 1 0 2; end", "not the vertex that it is said to be"),
    ("same-one-coordinate", f"--matrices first-half.mat {EXACT_1}",
     f"radius 2 2; bounds - -; {ROOT_1}; block 0 polytope 2 1 1; vertex 2 0; vertex 0 2; unit 0 0:2; unit 1 1:2; image 0 0 0:2; "
     "image 0 1 0:2; image 1 0; image 1 1; cycle 0 - 0; seed 1 0; same 0 1 0; end", "not the vertex that it is said to be"),
    ("blocks-below", "--matrices below.mat --upper 1",
     "radius 1 3; bounds - 1; blocks 2 1; basis 1 0 0; basis 0 1 0; basis 0 0 1; inverse 1 0 0; inverse 0 1 0; inverse 0 0 1; "
     "block 0 norm 1; block 1 norm 1; end", "not block upper triangular"),
    ("group-one-matrix", "--matrices unit-shear.mat --upper 2",
     "radius 2 2; bounds - 2; block 0 polytope 1 0 0 group:1; generator 0 1; map 0 1; map 1 0; vertex 1 0; unit 0 0:1; unit 1 0A:1; "
     "image 0 0 0:1; image 0 1 0:1; end", "does not permute the matrices"),
    ("symmetric-middle", "--matrices middle.mat --upper 1",
     "radius 3 2; bounds - 1; block 0 polytope 1 0 0 symmetric; vertex 1 0; unit 0 0:1; image 0 0 0:1; image 0 1 0:1; image 0 2 0:1; end",
     "the family is not symmetric"),
    ("ternary-class-sums", "--mask [1/2,1/2,2] --arity 3 --lower 1/10",
     "exponent [1/2,1/2,2] 3; bounds 1/10 -; sum-rules 1; block 0 norm 1; end", "no sum rules of this order"),
    ("ternary-size", "--mask [2,3,4,4,3,2]/6 --arity 3 --lower 1/2",
     "exponent [2,3,4,4,3,2]/6 3; bounds 1/2 -; sum-rules 1; block 0 norm 1; end", "does not prove the claim"),
    ("size-256", f"--mask {ramp(256)} --arity 2 --lower 1", f"exponent {ramp(256)} 2; bounds 1 -; sum-rules 1; block 0 norm 1; end",
     "does not prove the claim"),
    ("size-257", f"--mask {ramp(257)} --arity 2 --lower 9/10", f"exponent {ramp(257)} 2; bounds 9/10 -; sum-rules 1; block 0 norm 1; end",
     "transition matrices larger than 256"),
    ("quotient-denominators-more", *quotient(2**4999, 2**5002 - 1), "common denominator too large"),
    ("blocks-denominators", "--matrices upper.mat --upper 1",
     f"radius 1 2; bounds - 1; blocks 2; basis 1 0; basis 0 1/{3**3785}; inverse 1 0; inverse 0 {3**3785}; block 0 norm 1; end",
     "common denominator too large, line 8"),
    # a bound that is above by less than the roots are rounded by
    ("quaternary-half-above", f"--mask [{2 * TINY + 1}/{TINY},3,4,4,{2 * TINY - 1}/{TINY},1]/4 --arity 4 --lower 1/2",
     f"exponent [{2 * TINY + 1}/{TINY},3,4,4,{2 * TINY - 1}/{TINY},1]/4 4; bounds 1/2 -; sum-rules 1; block 0 norm 1; end",
     "does not prove the claim"),
    # a bound that is below the power but above that with 128 binary digits of the exponent
    ("quaternary-half-digits", f"--mask [{2 * MORE + 1}/{MORE},3,4,4,{2 * MORE - 1}/{MORE},1]/4 --arity 4 --lower {MORE // 2 - 1}/{MORE}",
     f"exponent [{2 * MORE + 1}/{MORE},3,4,4,{2 * MORE - 1}/{MORE},1]/4 4; bounds 1/2 -; sum-rules 1; block 0 norm 1; end",
     "does not prove the claim"),
    # bounds that are exact but for the rounding of Delta
    *((f"rounded-limit-{order}", f"--mask {text} --arity 2 --within {eps},{order} --lower 1",
       f"exponent {text} 2 within={eps},{order}; bounds 1 -; sum-rules {order}; block 0 norm 1; end", "does not prove the claim")
      for order, text, eps in map(rounded_limit, (2, 140))),
    # more halvings than allowed
    ("range-halved-61", *halved("3/2", 62), "not shown to be positive"),
    # less than a unit above the bound
    ("exact-image-above", f"--matrices three-quarters.mat {EXACT_1}",
     "radius 2 1; bounds - -; exact |[-1,1]@1,0,1/10|^1/1; root 1 0 0 7/10 1; block 0 polytope 1 0 2; vertex 1; unit 0 0:4; "
     "image 0 0 0:4; image 0 1 0:3; cycle 0 - 0; seed 1; end", "may lie outside"),
    # the error of a vertex is that of another one, and of the bound of the images
    ("origin-error", "--matrices swap.mat --exact |[-1,1]@1,0,1/10|^1/2",
     "radius 1 2; bounds - -; exact |[-1,1]@1,0,1/10|^1/2; root 1 0 0 1 1; block 0 polytope 2 3 20; vertex 8 1; vertex 1 8; "
     "unit 0 0:1065220 1:-133153; unit 1 1:1065220 0:-133153; image 0 0 1:1048576; image 1 0 0:1048576 0:1572864 0:-1572864; "
     "cycle 0 - 0 0; seed 1 0; origin 1 0 0; end", "too far"),
    # errors that are rounded up to 1, or have other signs
    ("vertex-error-rounded", f"--matrices ones.mat {EXACT_1}",
     f"radius 1 2; bounds - -; {ROOT_1}; block 0 polytope 2 520 520; vertex {2**520} {2**519 - 1}; vertex 0 {2**520}; "
     f"unit 0 0:{2**520} 1:{1 - 2**519}; unit 1 1:{2**520}; image 0 0 0:{2**520}; image 1 0 1:{2**520}; cycle 0 - 0; seed 1 0; "
     "cycle 1 - 0; seed 0 1; end", "too far"),
    ("inverse-imaginary-error", "--matrices three.mat --lower 1", "radius 1 1; bounds 1 -; product 0 3 1 0; inverse 0; column 0 -1 -1; end",
     "the inverse is none of the product"),
    ("inverse-size", "--matrices three.mat --lower 1", "radius 1 1; bounds 1 -; product 0 2 0 0; inverse 2; column 0 -5; end",
     "does not prove the claim"),
    ("inverse-size-imaginary", "--matrices three.mat --lower 2", "radius 1 1; bounds 2 -; product 0 3 1 0; inverse 2; column 0 0 -5; end",
     "does not prove the claim"),
    # moduli that are rounded
    ("inverse-modulus", f"--matrices three.mat --lower {LESS + 1}/{LESS}",
     "radius 1 1; bounds - -; product 0 3 4 0; inverse 2; column 0 0 -1; end", "does not prove the claim"),
    ("product-modulus", "--matrices three.mat --lower 1", "radius 1 1; bounds - -; product 0 3 4 0; end", "does not prove the claim"),
    # zeros of the transform at the points pi/3 and 5 pi/3 alone
    ("surface-zeros-near-0", f"--surface {ARITY_5} --dilation [5] --lower 1 --upper 1",
     f"surface {ARITY_5} [5]; bounds 1 1; sum-rules 2; digits 0 1 2 3 4; space 2; vector 0:1 1:-2 2:1; vector 3:1 1:1 2:-2; "
     "gram 0:8 1:-4 2:2 3:1; end", "not shown to be positive"),
    ("surface-zeros-negative", f"--surface {ARITY_5} --dilation [5] --lower 1 --upper 1",
     f"surface {ARITY_5} [5]; bounds 1 1; sum-rules 2; digits 0 1 2 3 4; space 2; vector 0:1 1:-2 2:1; vector 3:1 1:1 2:-2; "
     "gram 0:8 -1:-4 -2:2 -3:1; end", "not shown to be positive"),
    # polyphase parts with the common zero 2
    ("stability-zero-2", "--mask [2,4,1,-2,-1]/2 --arity 2", "exponent [2,4,1,-2,-1]/2 2; bounds - -; sum-rules 2; stability; end",
     "the polyphase parts may have a common zero"),
    ("stability-part-0", "--mask [w,0,2-w] --arity 2 --for w=1/2..1", "exponent [w,0,2-w] 2 w=1/2..1; bounds - -; sum-rules 1; stability; end",
     ", line 5"),
    # a symmetry of the powers of the dilation that is none of the lattice, of a mask without sum rules
    *((f"turned-{name}", f"--surface [[2]] --dilation {dilation} --lower 1", f"surface [[2]] {dilation}; bounds 1 -; sum-rules 1; turned {turned}; end",
       ", line 5")
      for name, dilation, turned in (("larger", "[2,0;0,2]", "[4,0;0,4]"), ("later-fraction", "[0,2;1,0]", "[1,2;-1,0]"))),
]
