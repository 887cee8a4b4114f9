"""Cases for sides of conditions that the other cases do not take."""
import math

PHI, ONE = 29847458893032750104, 1 << 64  # the golden ratio and 1, times 2^64
LARGE = 10**80
ROOT = math.isqrt(3 * 10**220)
LONG = f"[{10**110 + ROOT},{3 * 10**110 + ROOT},{3 * 10**110 - ROOT},{10**110 - ROOT}]/{4 * 10**110}"  # Daubechies
HUGE = f"{10**95 + 1}/{10**95}"
SMOOTHED = "[-1,1,7,9,9,7,1,-1]/16@-3"
TRAPEZOID = "--surface [1,1,0,1,1]/2@0 --dilation [2]"
FORM = "block 0 quadratic 2 {}; form 3; form 2 2; form 1 1 1; word 0; word 1"
# that the scheme of the trapezoid converges, but for a section
CONVERGES = "sum-rules 1; space 3; vector 0:1 3:-1; vector 1:1 3:-1; vector 2:1 3:-1"
# (1 + z^3)^2/2, and that times (1 + y)^2/2: the refinement equation has a continuous solution, the scheme diverges
HAT_3 = "--surface [1,0,0,2,0,0,1]/2@0 --dilation [2]"
HAT_3_2D = "--surface [[1,0,0,2,0,0,1],[2,0,0,4,0,0,2],[1,0,0,2,0,0,1]]/4@0,0 --dilation [2,0;0,2]"
DIVERGENT = ("surface [1,0,0,2,0,0,1]/2@0 [2]; bounds 1 1; differences 2; digits 0 1; values 1:1 2:2 3:3 4:2 5:1; space 1; "
    "vector 0:1 3:-2 6:1; product 0 1/2 0 0; block 0 norm 1")
DIVERGENT_EXACT = ("surface [1,0,0,2,0,0,1]/2@0 [2]; bounds - -; exact 0-log|[-1,2]@1/2,0,1/10|^1/1; root 1/2 0 0 1/2 1/2; "
    "differences 2; digits 0 1; values 1:1 2:2 3:3 4:2 5:1; space 1; vector 0:1 3:-2 6:1; block 0 polytope 1 0 1; "
    "vertex 1; unit 0 0:2; image 0 0 0:1; image 0 1; cycle 0 - 0; seed 1")
DIVERGENT_2D = ("surface [[1,0,0,2,0,0,1],[2,0,0,4,0,0,2],[1,0,0,2,0,0,1]]/4@0,0 [2,0;0,2]; bounds 7/50 -; differences 1; "
    "digits 0,0 1,0 0,1 1,1; values 1,1:1 2,1:2 3,1:3 4,1:2 5,1:1; space 7; vector 1,1:1 4,1:-1 2,1:1 5,1:-1 3,1:1 "
    "6,1:-1; vector 0,1:1 3,1:-2 6,1:1; vector 1,0:1 4,0:-4 5,0:-3 3,0:-1 2,1:1 5,1:2 3,1:2 4,1:3 6,0:-2 6,1:1; "
    "vector 0,0:1 3,0:-2 6,0:1; vector 1,2:1 2,1:-1 5,1:-2 3,1:-2 4,1:-3 6,1:-1 4,2:2 2,2:2 5,2:1 3,2:3; vector "
    "0,2:1 2,2:-1 3,2:-4 4,2:-3 5,2:-2 2,1:1 5,1:2 3,1:2 4,1:3 6,1:1; vector 2,0:1 5,0:2 2,1:-1 5,1:-2 3,0:2 3,1:-2"
    " 4,0:3 4,1:-3 6,0:1 6,1:-1; block 0 norm 4")
# all first differences on the points to which words lead
ON_6 = "sum-rules 1; space 6; " + "; ".join(f"vector {k}:1 6:-1" for k in range(6))
ON_6_2 = "sum-rules 1; space 20; " + "; ".join(f"vector {k % 7},{k // 7}:1 6,2:-1" for k in range(20))
NOT_PROVED = {"hat": f"{ON_6}; block 0 norm 3; end", "exact": f"{ON_6}; block 0 norm 8; end", "2d": f"{ON_6_2}; block 0 norm 2; end"}
HAT = "--surface [1,2,1]/2@-1 --dilation [2]"
BOUNDS = "bounds 323606797749959/200000000000000 323606797749999/200000000000000\n"  # of golden.cert
DEGREE_256 = f"|[-1,{255 * '0,'}1]@1,0,1/1000000|^1/1"
PRIME = 4294967291
EQUAL_PARTS = "[w,-1/3,1/3,1-w,4/3,2/3]"
HAT_64 = f"[{','.join(map(str, [*range(1, 65), *range(63, 0, -1)]))}]/64@-63"
FOUR_POINT = "[-w,0,1/2+w,1,1/2+w,0,-w]@-3"
# coefficients in the square of the parameter: forms with large coefficients that are small where both ends count as much
SQUARES = "[1/2,1000*w^2+3/2,1/2,-1000*w^2-1/2]"
GROWING = (("", "[1000*w^2+3/2,1,-1000*w^2-1/2]", 2), ("-negative", "[-1000*w^2-3/2,1,1000*w^2+5/2]", -2))
# a class that is as large as the error of the other two together, but for less than what is rounded away
ALMOST = f"[{2**190 - 1},{2**191 + 2},{2**190 - 1}]/{2**191}"
# rows of a form for which the last pivot of Lemma 17 is 0, or 1
MARGIN, FIRST, MIDDLE = 2 * 2**128 + 2, 2**255 + 12345, 10**70
LAST = MARGIN + (MIDDLE // math.isqrt(FIRST - MARGIN)) ** 2

# name, rows of its matrices
MATRICES = [
    ("axis.mat", [[["1", "1"], ["0", "1/2"]]]),
    ("huge.mat", [[[HUGE]]]),
    ("zero.mat", [[["0"]]]),
    ("one.mat", [[["1"]]]),
    ("turned.mat", [[["1", "1"], ["1", "0"]], [["-1", "0"], ["-1", "0"]]]),  # opposite on the first unit vector
    ("first.mat", [[["1", "0"], ["0", "0"]]]),
    ("eighth.mat", [[["1", "0"], ["0", "1/8"]]]),
    ("swap.mat", [[["0", "1"], ["1", "0"]]]),
    ("ones.mat", [[["1", "0"], ["0", "1"]]]),
    ("small.mat", [[["1/2000"]]]),
    ("unit.mat", [[["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]]]),
    ("four.mat", [[[str(int(i == j)) for j in range(4)] for i in range(4)]]),
]

BETWEEN = "[1,1-w,w,0,0,w,0,w,0,0,1-w,1-w]"  # of arity 4: a multiple of Phi_20 at 0, of Phi_10 at 1

# name, options of the claim, and the lines after the first one
ACCEPTED = [
    # the word `full` where no line `stability` follows
    ("hat-full-lower", "--mask [1,2,1]/2@-1 --arity 2 --lower 1",
     "exponent [1,2,1]/2@-1 2; bounds 1 -; sum-rules 2 full; block 0 norm 1; end"),
    # a coordinate of the eigenvector of a cone is 0
    ("axis-exact", "--matrices axis.mat --exact |[-1,1]@1,0,1/10|^1/1",
     "radius 1 2; bounds - -; exact |[-1,1]@1,0,1/10|^1/1; root 1 0 0 1 1; block 0 polytope 2 2 2 nonnegative; vertex 4 0; "
     "vertex 0 1; unit 0 0:4; unit 1 1:16; image 0 0 0:4; image 1 0 0:1 1:2; cycle 0 - 0; seed 1 0; end"),
    ("trapezoid-exact", f"{TRAPEZOID} --exact 0-log|[-1,2]@1/2,0,1/10|^1/1",
     "surface [1,1,0,1,1]/2@0 [2]; bounds - -; exact 0-log|[-1,2]@1/2,0,1/10|^1/1; root 1/2 0 0 1/2 1/2; differences 2; "
     "digits 0 1; values 1:1 2:1 3:1; space 1; vector 0:1 1:-1 3:-1 4:1; block 0 polytope 1 0 1; vertex 1; unit 0 0:2; "
     f"image 0 0 0:1; image 0 1; cycle 0 - 0; seed 1; {CONVERGES}; block 0 norm 2; end"),
    ("trapezoid-lower", f"{TRAPEZOID} --lower 1",
     "surface [1,1,0,1,1]/2@0 [2]; bounds 1 -; differences 2; digits 0 1; values 1:1 2:1 3:1; space 1; "
     f"vector 0:1 1:-1 3:-1 4:1; block 0 norm 1; {CONVERGES}; block 0 norm 2; end"),
    # convergence by a form, and with a bound just below 1; by two blocks; with a product; by differences of another order
    ("trapezoid-scheme-form", f"{TRAPEZOID} --lower 1",
     "surface [1,1,0,1,1]/2@0 [2]; bounds 1 -; differences 2; digits 0 1; values 1:1 2:1 3:1; space 1; "
     f"vector 0:1 1:-1 3:-1 4:1; block 0 norm 1; {CONVERGES}; {FORM.format('999999/1000000')}; end"),
    ("trapezoid-scheme-blocks", f"{TRAPEZOID} --lower 1 --upper 1",
     "surface [1,1,0,1,1]/2@0 [2]; bounds 1 1; differences 2; digits 0 1; values 1:1 2:1 3:1; space 1; "
     f"vector 0:1 1:-1 3:-1 4:1; product 0 1/2 0 0; block 0 norm 1; {CONVERGES}; blocks 2 1; "
     "basis 1 0 1; basis -1 1 0; basis -1 -2 0; inverse 0 -2/3 -1/3; inverse 0 1/3 -1/3; inverse 1 2/3 1/3; "
     "product 1 1/2 0 0; block 0 norm 2; "
     "block 1 norm 1; end"),
    ("trapezoid-scheme-second", f"{TRAPEZOID} --lower 1",
     "surface [1,1,0,1,1]/2@0 [2]; bounds 1 -; differences 2; digits 0 1; values 1:1 2:1 3:1; space 1; "
     "vector 0:1 1:-1 3:-1 4:1; block 0 norm 1; sum-rules 2; space 2; vector 0:1 2:-3 3:2; vector 1:1 2:-2 3:1; "
     "block 0 norm 3; end"),
    ("hat-lower", f"{HAT} --lower 1", "surface [1,2,1]/2@-1 [2]; bounds 1 -; sum-rules 2; digits 0 1; space 1; "
     "vector -1:1 0:-2 1:1; block 0 norm 1; end"),
    # what a certificate has is checked, with numbers of more bits than are looked at
    ("hat-lower-gram", f"{HAT} --lower 1", "surface [1,2,1]/2@-1 [2]; bounds 1 -; sum-rules 2; digits 0 1; space 1; "
     f"vector -1:1 0:-2 1:1; gram 0:{4 * LARGE} 1:{LARGE}; block 0 norm 1; end"),
    # a product with an eigenvalue that may be 1 at no value of the parameter, but is not bounded away from 1
    ("corner-not-smooth-1", "--mask [w,1-w,1-w,w] --arity 2 --for w=1/10..1/5 --upper 1",
     "exponent [w,1-w,1-w,w] 2 w=1/10..1/5; bounds - 1; sum-rules 1; stability; to 1/5; product 0 1 0 0; end"),
    ("zero", "--matrices zero.mat --upper 0", "radius 1 1; bounds - 0; block 0 norm 2; end"),
    # a power of 4 with the exponent 1/2
    ("quaternary-half", "--mask [2,3,4,4,2,1]/4 --arity 4 --lower 1/2",
     "exponent [2,3,4,4,2,1]/4 4; bounds 1/2 -; sum-rules 1; block 0 norm 1; end"),
    # errors of the entries, and of the zero, that are small beside the unit of the integers
    ("rounded-hat-polytope", "--mask [1,2,1]/2@-1 --arity 2 --within 1/100,1 --lower 4/5",
     "exponent [1,2,1]/2@-1 2 within=1/100,1; bounds 4/5 -; sum-rules 1; block 0 polytope 1 0 0; vertex 1; unit 0 0:1; "
     "image 0 0 0:1; image 0 1 0:1; end"),
    # an image with the norm 1, beside a vertex that attains it
    ("ones-exact", "--matrices ones.mat --exact |[-1,1]@1,0,1/10|^1/1",
     "radius 1 2; bounds - -; exact |[-1,1]@1,0,1/10|^1/1; root 1 0 0 1 1; block 0 polytope 2 0 0; vertex 1 0; vertex 0 1; "
     "unit 0 0:1; unit 1 1:1; image 0 0 0:1; image 1 0 1:1; cycle 0 - 0; seed 1 0; end"),
    ("one-exact-256", f"--matrices one.mat --exact {DEGREE_256}",
     f"radius 1 1; bounds - -; exact {DEGREE_256}; root 1 0 0 1 1; block 0 polytope 1 0 0; vertex 1; unit 0 0:1; "
     "image 0 0 0:1; cycle 0 - 0; seed 1; end"),
    # the eigenvector (1, 0), and a vertex beside it: the first coordinate is that which both have
    ("first-exact", "--matrices first.mat --exact |[-1,1]@1,0,1/10|^1/1",
     "radius 1 2; bounds - -; exact |[-1,1]@1,0,1/10|^1/1; root 1 0 0 1 1; block 0 polytope 2 2 2; vertex 4 0; vertex 0 4; "
     "unit 0 0:4; unit 1 1:4; image 0 0 0:4; image 1 0; cycle 0 - 0; seed 1 0; end"),
    ("eighth-exact", "--matrices eighth.mat --exact |[-1,1]@1,0,1/10|^1/1",
     "radius 1 2; bounds - -; exact |[-1,1]@1,0,1/10|^1/1; root 1 0 0 1 1; block 0 polytope 3 3 3 nonnegative; vertex 8 0; "
     "vertex 1 8; vertex 4 4; unit 0 0:8; unit 1 1:8; image 0 0 0:8; image 1 0 2:2; image 2 0 0:4 1:1; cycle 0 - 0; "
     "seed 1 0; same 1 0 2; end"),
    # an origin without any error
    ("swap-exact", "--matrices swap.mat --exact |[-1,1]@1,0,1/10|^1/2",
     "radius 1 2; bounds - -; exact |[-1,1]@1,0,1/10|^1/2; root 1 0 0 1 1; block 0 polytope 2 0 0; vertex 1 0; vertex 0 1; "
     "unit 0 0:1; unit 1 1:1; image 0 0 1:1; image 1 0 0:1; cycle 0 - 0 0; seed 1 0; origin 1 0 0; end"),
    # units and images with large residuals
    ("unit-short", "--matrices one.mat --upper 5/2",
     "radius 1 1; bounds - 5/2; block 0 polytope 1 2 0; vertex 5; unit 0 0:1; image 0 0; end"),
    ("unit-long", "--matrices ones.mat --upper 9/8", "radius 1 2; bounds - 9/8; block 0 polytope 2 3 0; vertex 8 0; vertex 0 1; "
     "unit 0 0:1; unit 1 1:8; image 0 0 0:1; image 1 0; end"),
    ("small", "--matrices small.mat --lower 0 --upper 1/2000",
     "radius 1 1; bounds 0 1/2000; product 0 1/2000 0 0; block 0 norm 1; end"),
    # more bits than are looked at
    ("huge-product", f"--matrices huge.mat --lower {HUGE} --upper {HUGE}",
     f"radius 1 1; bounds {HUGE} {HUGE}; product 0 {HUGE} 0 0; block 0 norm 1; end"),
    ("huge-inverse", f"--matrices huge.mat --lower 9999/10000 --upper {HUGE}",
     f"radius 1 1; bounds 9999/10000 {HUGE}; product 0 {10**95 + 1 + 10**75}/{10**95} 0 0; inverse 0; column 0 {10**20}; "
     "block 0 norm 1; end"),
    ("rounded-long", f"--mask {LONG} --arity 2 --within 1/100,2",
     f"exponent {LONG} 2 within=1/100,2; bounds - -; sum-rules 2; stability; end"),
    # three blocks of one radius, the last of which attains it
    ("unit-exact", "--matrices unit.mat --exact |[-1,1]@1,0,1/10|^1/1",
     "radius 1 3; bounds - -; exact |[-1,1]@1,0,1/10|^1/1; root 1 0 0 1 1; blocks 1 1 1; basis 1 0 0; basis 0 1 0; "
     "basis 0 0 1; inverse 1 0 0; inverse 0 1 0; inverse 0 0 1; block 0 norm 1; block 1 norm 1; block 2 polytope 1 0 0; "
     "vertex 1; unit 0 0:1; image 0 0 0:1; cycle 0 - 0; seed 1; end"),
    # classes of the mask with different numbers of coefficients, the longest one the first; classes of one coefficient
    ("ternary-stable", "--mask [w,1,1,1-w] --arity 3 --for w=0..1/4",
     "exponent [w,1,1,1-w] 3 w=0..1/4; bounds - -; sum-rules 1; stability; end"),
    ("ternary-stable-last", "--mask [w,1/3,1/2,1-2*w,2/3,1/2,w] --arity 3 --for w=0..1/10",
     "exponent [w,1/3,1/2,1-2*w,2/3,1/2,w] 3 w=0..1/10; bounds - -; sum-rules 1; stability; end"),
    ("haar-quotient-stable", "--mask [1+w,1+w]/(1+w) --arity 2 --for w=0..1",
     "exponent [1+w,1+w]/(1+w) 2 w=0..1; bounds - -; sum-rules 1; stability; end"),
    ("haar-rounded-stable", "--mask [1,1] --arity 2 --within 1/100,1",
     "exponent [1,1] 2 within=1/100,1; bounds - -; sum-rules 1; stability; end"),
    # the letters a parameter may have
    *((f"corner-stable-{name}", f"--mask [{w},1-{w},1-{w},{w}] --arity 2 --for {w}=-1..499/1000",
       f"exponent [{w},1-{w},1-{w},{w}] 2 {w}=-1..499/1000; bounds - -; sum-rules 1; stability; end")
      for name, w in (("upper-case", "W"), ("a", "a"), ("z", "z"), ("upper-case-a", "A"), ("upper-case-z", "Z"))),
    # the largest coordinates, entries and numbers of classes
    ("hat-far", "--surface [1,2,1]/2@-1000000000 --dilation [2] --lower 1",
     "surface [1,2,1]/2@-1000000000 [2]; bounds 1 -; sum-rules 2; digits -1000000000 -999999999; space 1; "
     "vector 0:1 1:-2 2:1; block 0 norm 1; end"),
    ("hat-far-apart", "--surface [1,2,1]/2@-1000000000 --dilation [2] --lower 1",
     "surface [1,2,1]/2@-1000000000 [2]; bounds 1 -; sum-rules 2; digits -1000000000 999999999; space 1; "
     "vector 0:1 1:-2 2:1; block 0 norm 1; end"),
    ("hat-64", f"--surface {HAT_64} --dilation [64] --lower 1",
     f"surface {HAT_64} [64]; bounds 1 -; sum-rules 2; digits {' '.join(map(str, range(64)))}; space 1; "
     "vector -1:1 0:-2 1:1; block 0 norm 1; end"),
    # the largest group: all permutations, and an even number of signs
    ("group-96", "--matrices four.mat --upper 1",
     "radius 1 4; bounds - 1; block 0 polytope 1 0 0 group:3; generator 0; map 0 0 0 1; map 1 0 0 0; map 0 1 0 0; map 0 0 1 0; "
     "generator 0; map 0 1 0 0; map 1 0 0 0; map 0 0 1 0; map 0 0 0 1; generator 0; map -1 0 0 0; map 0 -1 0 0; map 0 0 1 0; "
     "map 0 0 0 1; vertex 1 0 0 0; unit 0 0:1; unit 1 0A:1; unit 2 0AA:1; unit 3 0AAA:1; image 0 0 0:1; end"),
    # coefficients that are 0 for all parameters, and others that are for one
    ("four-point-from-0", f"--mask {FOUR_POINT} --arity 2 --for w=0..1/16",
     f"exponent {FOUR_POINT} 2 w=0..1/16; bounds - -; sum-rules 2; stability; end"),
    # of equally long classes it is the first that has no zero in common with the sum of multiples of the others
    ("equal-parts-stable", f"--mask {EQUAL_PARTS} --arity 3 --for w=2/5..3/5",
     f"exponent {EQUAL_PARTS} 3 w=2/5..3/5; bounds - -; sum-rules 1; stability; end"),
    ("stable-large", f"--mask {SQUARES} --arity 2 --for w=-1..1",
     f"exponent {SQUARES} 2 w=-1..1; bounds - -; sum-rules 1; stability; end"),
    *((f"growing-large{name}", f"--mask {mask} --arity 2 --for w=-1..1 --upper 0",
       f"exponent {mask} 2 w=-1..1; bounds - 0; sum-rules 1; to 1; product 0 {value} 0 0; end") for name, mask, value in GROWING),
    # a value at a root of unity that turns by more than a right angle
    ("turning-stable", "--mask [w,1,1-w] --arity 2 --for w=-2..2",
     "exponent [w,1,1-w] 2 w=-2..2; bounds - -; sum-rules 1; stability; end"),
    ("rounded-complex", "--mask [9,1,1,9]/10 --arity 2 --within 1/1000000,1 --lower 1/1000 --upper 9/10",
     "exponent [9,1,1,9]/10 2 within=1/1000000,1; bounds - -; sum-rules 1; stability; product 0 -13/10 13/5 0 1; block 0 norm 10; end"),
    # masks of two coefficients have no zeros at roots of unity that matter
    ("haar-rounded-wide", "--mask [1,1] --arity 2 --within 99/100,1",
     "exponent [1,1] 2 within=99/100,1; bounds - -; sum-rules 1; stability; end"),
    # quaternary: a multiple of one of Phi_10 and Phi_20, but not of both, and between such masks
    *((f"quaternary-stable-{name}", f"--mask {mask} --arity 4{options}",
       f"exponent {mask} 4{more}; bounds - -; sum-rules 1; stability; end") for name, mask, options, more in (
           ("10", "[1,0,1,0,0,1,0,1]", "", ""), ("20", "[1,1,0,0,0,0,0,0,0,0,1,1]", "", ""),
           ("20-rounded", "[1,1,0,0,0,0,0,0,0,0,1,1]", " --within 1/1000000000,1", " within=1/1000000000,1"),
           ("between", BETWEEN, " --for w=0..1", " w=0..1"))),
]

# name, accepted case that is changed, other options or None, changes of its text
CHANGED = [
    ("single-recurrence-negative", "single-four-point-2", None, [("recurrence -4 1\n", "recurrence 4 -1\n")]),
    ("reduced-exact-rough", "reduced-exact", f"--mask {SMOOTHED} --arity 2 --upper C4", [("sum-rules 4\n", "sum-rules 4 full\n")]),
    ("four-point-exact-coarse", "four-point-exact", "--mask [-1,0,9,16,9,0,-1]/16@-3 --arity 2 --exact 4-log|[4,-5,1]@4,0,1/10|^1/1",
     [("4-log|[-4,1]@4,0,1|", "4-log|[4,-5,1]@4,0,1/10|"), ("root 4 0 0 4 4", "root 4 0 1/100 399/100 401/100")]),
    # an eigenvector with an imaginary coordinate where the vertex is large
    *((f"rotation-exact-seed{sign}1", "rotation-exact", None, [("seed 1 0", f"seed 0 {sign}1")]) for sign in ("", "-")),
    ("rotation-exact-seed-negative", "rotation-exact", None, [("seed 1 0", "seed -1 0")]),
    # all of the disc, and bounds that are no better
    ("four-point-exact-wide", "four-point-exact", "--mask [-1,0,9,16,9,0,-1]/16@-3 --arity 2 --exact 4-log|[-4,1]@4,0,1/10|^1/1",
     [("@4,0,1|", "@4,0,1/10|"), ("root 4 0 0 4 4", "root 4 0 1/10 39/10 41/10")]),
    ("four-point-exact-word", "four-point-exact-group", None, [("cycle 0 - 0", f"cycle 0 {16 * 'A'} 0")]),
    ("upper-10000", "four-point-norm", "--mask [-1,0,9,16,9,0,-1]/16@-3 --arity 2 --lower 2 --upper 10000", []),
    # the longest numbers
    ("bounds-digits", "golden", None, [(BOUNDS, f"bounds {5000 * '9'} -{5000 * '9'}\n")]),
    ("golden-group-word", "golden-group", None, [("unit 0 ", f"unit 0 0{16 * 'A'}:0 ")]),
    ("golden-nonnegative-weight-0", "golden-nonnegative", None, [("unit 0 ", "unit 0 0:0 ")]),
    ("golden-weight-0", "golden", None, [("unit 0 ", "unit 0 0:0 ")]),
    ("golden-quadratic-large", "golden-quadratic", None, [("form 1\n", f"form {LARGE}\n"), ("form 0 1\n", f"form 0 {LARGE}\n")]),
    ("golden-minus", "golden", None, [("polytope 4 64 64\n", "polytope 4 64 64 group:1\ngenerator 0 1\nmap -1 0\nmap 0 -1\n")]),
]

# name, accepted case that is changed, other options or None, reason, changes of its text
REJECTED = [
    *((f"rounded-class-{name}", "haar-rounded-stable", f"--mask {mask} --arity 2 --within {error},1",
       "stability: the resultant of the polyphase parts", [("[1,1] 2 within=1/100,1", f"{mask} 2 within={error},1")])
      for name, mask, error in (("equal", "[1,2,1]/2@-1", "1/2"), ("less", ALMOST, f"{2**180 + 1}/{2**181}"))),
    ("common-zero-positive", "hat-full-lower", "--mask [2,2,-1,-1] --arity 2 --lower 1/1000", "common zero",
     [("[1,2,1]/2@-1", "[2,2,-1,-1]"), ("sum-rules 2 full\n", "sum-rules 1\nstability\n")]),
    ("sum-rules-of-0", "haar-quotient-stable", "--mask [w,w]/(w) --arity 2 --for w=1..2", "no sum rules of this order",
     [("[1+w,1+w]/(1+w) 2 w=0..1", "[w,w]/(w) 2 w=1..2"), ("sum-rules 1\n", "sum-rules 3\n")]),
    ("mask-1000", "golden", f"--mask [{'1,' * 999}1] --arity 2 --lower 1", "expected 'exponent ", []),
    ("reduced-radius", "golden", None, "expected 'product'", [("product 0", "reduced [1] [1,1]\nproduct 0")]),
    ("logarithm-radius", "ones-exact", None, "expected 'end'", [("\nend", "\nlogarithm 0\nend")]),
    ("norm-second-column", "zero", "--matrices axis.mat --upper 1", "the bound does not prove the claim",
     [("radius 1 1", "radius 1 2"), ("bounds - 0", "bounds - 1"), ("norm 2", "norm 1")]),
    ("upper-0-unstable", "four-point-norm", "--mask [-1,0,9,16,9,0,-1]/16@-3 --arity 2 --lower 2 --upper 0",
     "expected 'stability'", [("stability\n", "")]),
    # numbers that are 0 where they must be positive, and inverses that are too large, in one direction only
    ("product-0", "zero", "--matrices zero.mat --lower 1/10 --upper 0", "the product proves no positive spectral radius", [("block 0", "product 0 0 0 0\nblock 0")]),
    *((f"inverse-{name}", "zero", None, reason, [("block 0", f"product 0 {value} 0\ninverse {columns}\nblock 0")])
      for name, value, columns, reason in (
          ("bound-0", "1 0", "0\ncolumn 0 1", "the product proves no positive spectral radius"),
          ("0", "1 0", "0\ncolumn 0 0", "the inverse is none of the product"),
          ("imaginary-less", "1 1", "0\ncolumn 0 0 -1", "the inverse is none of the product"),
          ("imaginary-more", "1 1", "0\ncolumn 0 1 0", "the inverse is none of the product"),
          ("real-large", "-1 0", "3\ncolumn 0 -9", "the product proves no positive spectral radius"),
          ("imaginary-large", "0 1", "3\ncolumn 0 0 -9", "the product proves no positive spectral radius"))),
    # the modulus of a complex eigenvalue, rounded up, bounds the changes
    ("rounded-complex-upper", "rounded-complex",
     "--mask [9,1,1,9]/10 --arity 2 --within 1/1000000,1 --lower 1/1000 --upper 25120618/100000000",
     "the product's spectral radius does not prove the claim", []),
    ("rounded-slope-0", "rounded-four-point", "--mask [-1,0,9,16,9,0,-1]/16@-3 --arity 2 --within 1/1048576,4 --lower 1",
     "the product proves nothing of rounded masks", [("within=1/1000000000,4", "within=1/1048576,4"), ("product 0 4", "product 0 24681/16384")]),
    ("inverse-trace-0", "swap-exact", None, "the inverse proves no eigenvalue near the given one",
     [("block 0", "product 0 0 0 0\ninverse 0\ncolumn 0 0 -1\ncolumn 1 -1 0\nblock 0")]),
    ("group-projection", "unit-long", None, "a generator is singular",
     [("polytope 2 3 0\n", "polytope 2 3 0 group:1\ngenerator 0\nmap 1 0\nmap 0 0\n")]),
    ("single-bound-0", "single-lower", None, "the recurrence may have a zero above the bound", [("single 4 0", "single 0 0")]),
    ("first-low", "hat-lower", "--surface [1,2,1]/2@-1000000001 --dilation [2] --lower 1", "a coordinate is too large",
     [("[1,2,1]/2@-1", "[1,2,1]/2@-1000000001")]),
    ("upper-negative", "four-point-norm", "--mask [-1,0,9,16,9,0,-1]/16@-3 --arity 2 --lower 2 --upper -1",
     "an exponent is negative or too large", []),
    ("upper-large", "four-point-norm", "--mask [-1,0,9,16,9,0,-1]/16@-3 --arity 2 --lower 2 --upper 20001/2",
     "an exponent is negative or too large", []),
    ("lower-large", "four-point-norm", "--mask [-1,0,9,16,9,0,-1]/16@-3 --arity 2 --lower 20001/2", "too large", []),
    ("zero-negative", "zero", "--matrices zero.mat --upper -1", "the bound does not prove the claim", []),
    ("index-high", "golden", None, "number outside 0..3", [("image 3 1 2:", "image 3 1 4:")]),
    ("section-word", "golden", None, ", line 5", [("block 0 polytope", "block 0 polygon")]),
    # a residual times the norm of unit vectors, which is 4/3; and 8
    ("unit-norm", "unit-short", "--matrices one.mat --upper 5/4", "the bound does not prove the claim", []),
    ("unit-norm-largest", "unit-long", "--matrices ones.mat --upper 1", "the bound does not prove the claim", []),
    *((f"quadratic-pivot-{last}", "golden-quadratic", None, reason, [("form 1\n", f"form {FIRST}\n"),
                                                                   ("form 0 1\n", f"form {MIDDLE} {LAST + last}\n")])
      for last, reason in ((0, "the form is not positive definite"), (1, "a product is not below the bound in the quadratic form"))),
    ("quadratic-pivot-first", "golden-quadratic", None, "the form is not positive definite",
     [("form 1\n", f"form {MARGIN}\n"), ("form 0 1\n", f"form 0 {2**255}\n")]),
    ("bounds-digits-more", "golden", None, "number too long", [(BOUNDS, f"bounds 1 {5001 * '9'}\n")]),
    ("rounded-hat-polytope-high", "rounded-hat-polytope", "--mask [1,2,1]/2@-1 --arity 2 --within 1/100,1 --lower 19/20",
     "the bound does not prove the claim", []),
    ("origin-0", "ones-exact", None, ", line 15",
     [("cycle 0 - 0\nseed 1 0\n", "cycle 1 - 0\nseed 0 1\norigin 0 0 0\n")]),
    # the error of a vertex is 1, with a coordinate above that of the eigenvector or below it
    *((f"vertex-error-1{name}", "first-exact", None, "too far",
       [("vertex 4 0\nvertex 0 4\nunit 0 0:4\nunit 1 1:4\n", f"vertex 2 {sign}1\nvertex 0 2\nunit 0 0:8 1:{other}4\nunit 1 1:8\n")])
      for name, sign, other in (("", "", "-"), ("-below", "-", ""))),
    ("vertex-first-largest", "first-exact", None, "too far",
     [("vertex 4 0\nvertex 0 4\nunit 0 0:4\n", "vertex 4 4\nvertex 0 4\nunit 0 0:4 1:-4\n")]),
    *((f"vertex-error-imaginary{name}", "rotation-exact", None, "too far",
       [("polytope 1 0 64", "polytope 1 1 64"), ("vertex 1 0 0 -1", f"vertex 2 0 0 {im}"), ("seed 1 0", f"seed {seed}")])
      for name, im, seed in (("", -3, "1 0"), ("-below", -1, "1 0"), ("-seed", -3, "0 1"), ("-below-seed", -1, "0 1"))),
    # an error of 1/4, which the image is below without, and with an error of fewer coordinates
    ("same-below-error", "eighth-exact", None, "not the vertex", [("vertex 8 0\n", "vertex 8 1\n")]),
    ("cone-origin-other", "slow-cone-exact", None, "too far", [("origin 4 2 0\n", "origin 4 2 1\n")]),
    ("lower-10000", "four-point-norm", "--mask [-1,0,9,16,9,0,-1]/16@-3 --arity 2 --lower 10000",
     "the bound does not prove the claim", []),
    ("reduced-1000", "trapezoid-reduced", None, "the reduced mask is not that of the mask and the factor",
     [("reduced [1,1] ", f"reduced [{'1,' * 999}1] ")]),
    ("root-double", "four-point-exact", "--mask [-1,0,9,16,9,0,-1]/16@-3 --arity 2 --exact 4-log|[16,-8,1]@4,0,1|^1/1",
     "no zero is proved so near", [("exact 4-log|[-4,1]@4,0,1|^1/1\n", "exact 4-log|[16,-8,1]@4,0,1|^1/1\n")]),
    ("axis-seed", "axis-exact", "--matrices axis.mat --exact |[1,-3,2]@1,0,1/10|^1/1",
     "may be negative", [("[-1,1]@1", "[1,-3,2]@1"), ("seed 1 0", "seed 0 1")]),
    ("reduced-rounded", "rounded-hat", None, ", line 4",
     [("sum-rules 1\n", "reduced [1] [1,2,1]/2@-1\nsum-rules 1\n")]),
    ("reduced-surface", "trapezoid-reduced", None, "1 to 1000 coefficients, the first and the last not zero",
     [("reduced [1,1] ", "reduced [[1,1],[1,1]] ")]),
    ("reduced-long", "trapezoid-reduced", None, "1 to 1000 coefficients, the first and the last not zero",
     [("reduced [1,1] ", f"reduced [{'1,' * 1000}1] ")]),
    ("reduced-zero-last", "trapezoid-reduced", None, "1 to 1000 coefficients, the first and the last not zero",
     [("reduced [1,1] ", "reduced [1,1,0] ")]),
    ("single-rounded", "rounded-hat", None, "expected 'norm', 'polytope', 'quadratic', 'graph' or 'single' and its numbers",
     [("block 0 norm 1\n", "block 0 single 1 0\nsquare 1 1\nfactor 0\nrecurrence -1 1\n")]),
    ("logarithm-norm-alone", "single-four-point", None, "expected 'logarithm 0 norm LEVEL'",
     [("logarithm 1\nrecurrence 1 -2 1\n", "logarithm 0 norm\n")]),
    ("logarithm-word", "single-four-point", None, "expected 'logarithm 0 norm LEVEL'",
     [("logarithm 1\nrecurrence 1 -2 1\n", "logarithm 0 form 4\n")]),
    ("determinant-0", "corner-not-smooth", "--mask [1/2*w,3/4+1/2*w,1-1/2*w,1/4-1/2*w] --arity 2 --for w=1/10..1/5 --upper 1",
     "the characteristic polynomial of the product, with the other sign, is not positive",
     [("[w,1-w,1-w,w]", "[1/2*w,3/4+1/2*w,1-1/2*w,1/4-1/2*w]"), ("product 0 11/10 0 0", "product 0 3/2 0 1")]),
    ("polytope-fields", "golden", None, ", line 5",
     [("polytope 4 64 64", "polytope 4 64")]),
    ("quadratic-fields", "golden-quadratic", None, "expected 'quadratic', a number of words, a bound and perhaps a group",
     [("quadratic 3 16181/10000", "quadratic 3 16181/10000 group:1 group:1")]),
    ("turned-coefficients", "hat-turned", "--surface [3,4,1]/4@-1 --dilation [2] --lower 1",
     "the dilation is not turned by symmetries", [("[1,2,1]/2@-1", "[3,4,1]/4@-1")]),
    ("turned-one-point", "hat-turned", "--surface [2] --dilation [2] --lower 1", "the dilation is not turned by symmetries",
     [("[1,2,1]/2@-1 [2]", "[2] [2]"), ("turned [-2]", "turned [4]")]),
    ("turned-twice", "turning-2", None, "the bound does not prove the claim",
     [("digits ", "turned [0,2;-1,0]\ndigits ")]),
    ("values-prime", "trapezoid-by-hand", None, "the differences do not span the space",
     [("values 1:1 2:1 3:1", f"values 1:{PRIME} 2:{PRIME} 3:{PRIME}")]),
    # dilations that are expanding and isotropic in other ways
    *((f"dilation-{name}", "turning-3", f"--surface [[[1,2,1]]]/2@-1,0,0 --dilation {dilation} --lower 1",
       "wrong number of fields", [("[0,0,2;1,0,0;0,1,0]", dilation)])
      for name, dilation in (("twice", "[2,0,0;0,2,0;0,0,2]"), ("quarter-turn", "[0,-2,0;2,0,0;0,0,2]"))),
]
