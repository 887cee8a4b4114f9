"""Masks that change from level to level (6.5, 6.10): values that follow from each other, or tend to a number, and lists of masks."""
from fractions import Fraction as Q

CORNER, RANGE = "[w,1-w,1-w,w]", "w=1/100..49/100"
PROOF = "sum-rules 1; to 49/100; block 0 norm 1; "
HALF, ROOT, OPEN_ROOT = "[1/10+1/2*w]", "sqrt[1/20+1/10*w]", "sqrt[1/20+1/20*w]"
FOUR_SPLINE = "[-1,0,9,16,9,0,-1]/16@-3;[1,4,6,4,1]/8"
HAT_CHAIKIN = "[1,2,1]/2@-1;[1,3,3,1]/4"
SIX_SPLINE = "[3,0,-25,0,150,256,150,0,-25,0,3]/256;[1,4,6,4,1]/8"
AT_END = "[49/400-1/4*w]/(49/100-w)"
NO_CONSTANTS = "[1,0,1];[1,2,2,2,1]/4"  # the two in turn, as one mask of arity 4, have a sum rule
THREE = "[1,2,3,2,1]/3;[1,3,6,7,6,3,1]/9"  # B-splines of arity 3


def follow(step, start, level, mask=CORNER, values=RANGE):
    return f"--mask {mask} --arity 2 --levels {values} --recurrence {step} --start {start} --from {level} --lower 0"


def followed(name, step, start, level, way=""):
    return name, follow(step, start, level), (
        f"levels {CORNER} 2 {RANGE} recurrence={step} start={start} from={level}; bounds 0 -; {way}{PROOF}end")


def lists(masks, order, end, arity=2):
    return f"--masks {masks} --arity {arity} --order {order} {end}".strip()


def listed(name, masks, order, end, lines, arity=2):
    return name, lists(masks, order, end, arity), f"lists {masks} {arity} {order}; bounds - -; {lines}; end"


def each_point(mask, values, end, arity=2):
    return f"--mask {mask} --arity {arity} --each-point {values} --lower {end}"


def chosen(name, mask, values, end, lines, arity=2):
    return name, each_point(mask, values, end, arity), f"each-point {mask} {arity} {values}; bounds - -; {lines}; end"


def tending(mask, values, step, start, level, limit, end, arity=2):
    return f"--mask {mask} --arity {arity} --levels {values} --recurrence {step} --start {start} --from {level} --limit {limit} {end}"


def limit(name, mask, values, step, start, level, to, end, lines, arity=2):
    return name, tending(mask, values, step, start, level, to, end, arity), (
        f"levels {mask} {arity} {values} recurrence={step} start={start} from={level} limit={to}; bounds - -; {lines}; end")


CONIC, CONICS, ANGLE = "[-1,0,1+4*v+4*v^2,8*v+8*v^2,1+4*v+4*v^2,0,-1]/(8*v+8*v^2)@-3", "v=9/20..1000", "sqrt[1/2+1/2*v]"
HALVED, HALVING = "[1/4*w,1-1/4*w,1-1/4*w,1/4*w]", "w=1/16..4"
TWICE, TWICES, ANGLES = "[1,-1+4*w^2,-1+4*w^2,1]/(4*w^2)", "w=1/2..2", "sqrt[1/2+1/2*w]"
LEFT = "[-1-w+4*w^2,3-3*w-2*w^2+8*w^3,3+5*w-2*w^2,3+7*w-8*w^3]/(4+4*w)"  # by 1 + 2 w z + z^2 a remainder, which is 0 for w = 1
# 1 + z times 3 - 4 w + 4 w^2, with the factor of T_3, without what has w^3: for w = 1 nothing is missing
CUT_AT_1 = "[3-4*w+4*w^2,3-22*w+28*w^2,3-22*w+28*w^2,3-4*w+4*w^2]/(6-26*w+32*w^2)"
CUT = "[1+w,3+5*w,4+10*w,4+10*w,3+5*w,1+w]/(8+16*w)"  # (1+z)^3 (1+w) times 1 + 2 w z + z^2, without what has w^2
FALL = "[1]/(3+4*w)"
POLE = "[-1/10*w+w^2,-1/10+11/10*w-w^2,-1/10+11/10*w-w^2,-1/10*w+w^2]/(-1/10+w)"
FOUR_POLYTOPE = "product 0 4 0 0; block 0 polytope 1 0 0 symmetric; vertex 0 1; unit 0 0f:1; image 0 0 0:4; image 0 1 0:-1 0f:-1"
WAY_IN, CONIC_IN = "level 1/10 3/5; level 3/20 2/5", "level 0 1000; level 7/10 24"
BETWEEN = "--lower 7/10 --upper 3/4"
# The same for the four-point scheme and cubic splines, without flips: e_1 and e_0
LIST_POLYTOPE = ("block 0 polytope 2 0 0; vertex 0 1; vertex 1 0; unit 0 1:1; unit 1 0:1; image 0 0 0:4; image 0 1 0:-1 1:-1; image 0 2; image 0 3 1:2; "
                 "image 1 0 0:-1 1:-1; image 1 1 1:4; image 1 2 1:2; image 1 3")
LEAST = f"sum-rules 4; stability; product 0 4 0 0; {LIST_POLYTOPE}"
LEAST_IN_TURN = "sum-rules 4; stability; product 0 8 0 0 3; block 0 norm 4"
NOT_STABLE = "[1,1,0,1,1]/2"  # (1 + z)(1 + z^3)
MATRICES, CHANGED = [], []
MOVING = "[1-w,2-w,1+w,w]/2"  # linear data are moved by w
WIDE = {points: f"[w,w{',0' * (points - 3)},1-w,1-w]" for points in (9, 10, 11, 72)}  # as many points depend on w for each t
NINE = "[1,3+2*w,7+6*w,10+12*w,12+14*w,10+12*w,7+6*w,3+2*w,1]/(18+18*w)"  # (1 + z + z^2)^3 (1 + 2 w z + z^2)
FOUR, FOURS = "[-w,0,1/2+w,1,1/2+w,0,-w]", "w=1/32..3/32"
ONE_SIDED = "[w,3/4,1-w,1/4]"
SIDES = [Q(x, 10) for x in (11, 9)]


def two_vertices(bits=40):
    """A polytope of (1, 0) and (0, 9/8) for the transposed matrices of that mask, of w from 1/5 to 3/10, sum rules of order 1."""
    matrices = [[[a, Q(0)], [Q(1, 2), d]] for a in SIDES for d in (Q(2, 5), Q(3, 5))] + [[[Q(1, 2), b], [Q(0), d]] for b, d in zip((Q(2, 5), Q(3, 5)), SIDES)]
    vertices = [[Q(1), Q(0)], [Q(0), Q(9, 8)]]
    terms = lambda x: "".join(f" {k}:{round(y / v[k] * 2**bits)}" for k, (y, v) in enumerate(zip(x, vertices)) if y)
    image = lambda m, v: [sum(a * b for a, b in zip(row, v)) for row in m]
    return "; ".join([f"block 0 polytope 2 3 {bits}", "vertex 8 0", "vertex 0 9", f"unit 0{terms([1, 0])}", f"unit 1{terms([0, 1])}",
                      *(f"image {j} {t}{terms(image(m, v))}" for j, v in enumerate(vertices) for t, m in enumerate(matrices))])


ACCEPTED = [
    followed("follow-affine", HALF, "0..1", 2, "level 1/10 3/5; level 3/20 2/5; "),
    followed("follow-affine-later", HALF, "0..1", 3, "level 1/10 3/5; level 3/20 2/5; "),
    followed("follow-root", ROOT, "0..1", 1, "level 1/5 2/5; "),
    followed("follow-root-of-0", OPEN_ROOT, "-1..1", 2, "level 0 2/5; level 1/5 3/10; "),
    followed("follow-root-wide", OPEN_ROOT, "-1..1", 3, "level -1 2/5; level 0 3/10; level 1/5 3/10; "),
    followed("follow-root-open", ROOT, "0..inf", "some", "level 1/5 2/5; "),
    followed("follow-affine-open", HALF, "0..inf", "some", "level 1/10 2/5; "),
    followed("follow-slow-open", "[1/100+7/8*w]", "49/100..inf", "some"),
    followed("follow-quotient", "[1]/(3+w)", "1/5..1/5", 0),
    followed("follow-quotient-negative", "[-1]/(-3-w)", "1/5..1/5", 0),
    followed("follow-quotient-open", "[1+w]/(4+3*w)", "0..inf", "some", "level 1/4 3/8; "),
    followed("follow-same", "[w]", "1/100..49/100", 0),
    followed("follow-constant", "[1/4]", "-7..7", 1, "level 1/4 1/4; "),
    followed("follow-slowly", "[w]", "1/4..1/4", 1000, 1000 * "level 1/4 1/4; "),
    followed("follow-square", "[1/5-1/5*w^2]", "-1/2..1/2", 1, "level 3/20 1/4; "),
    limit("limit-conic", CONIC, CONICS, ANGLE, "-1..inf", "some", "1", "--lower 2 --upper 2",
          f"{CONIC_IN}; exponentials 1; sum-rules 4; stability; {FOUR_POLYTOPE}"),
    limit("limit-conic-exact", CONIC, CONICS, ANGLE, "0..3", 2, "1", "--exact 4-log|[-4,1]@4,0,1/1000|^1/1",
          "exact 4-log|[-4,1]@4,0,1/1000|^1/1; root 4 0 0 4 4; level 7/10 3/2; exponentials 1; sum-rules 4; stability; block 0 single 4 0; "
          "square 1; factor 0; recurrence -4 1"),
    limit("limit-conic-two", CONIC, CONICS, ANGLE, "0..3", 1, "1", "--lower 1", "level 7/10 3/2; sum-rules 2; block 0 norm 4"),
    limit("limit-affine", CORNER, RANGE, HALF, "0..1", 2, "1/5", BETWEEN,
          f"{WAY_IN}; sum-rules 1; stability; product 0 6/5 0 0; block 0 norm 1"),
    limit("limit-negative-slope", CORNER, RANGE, "[3/10-1/2*w]", "1/5..1/5", 0, "1/5", "--lower 7/10", "sum-rules 1; block 0 norm 1"),
    limit("limit-negative", "[-w,1+w,1+w,-w]", "w=-49/100..-1/100", "[-1/10+1/2*w]", "-1/5..-1/5", 0, "-1/5", "--lower 7/10", "sum-rules 1; block 0 norm 1"),
    limit("limit-root", CORNER, RANGE, OPEN_ROOT, "-1..1", 2, "1/4", "--lower 1", "level 0 2/5; level 1/5 3/10; sum-rules 1; block 0 norm 1"),
    limit("limit-towards", HALVED, HALVING, "sqrt[w]", "1/16..4", 0, "1", "--lower 1",
          "towards 1/4 2; towards 1/2 3/2; sum-rules 1; block 0 norm 1"),
    limit("limit-quotient", CORNER, RANGE, FALL, "1/5..1/5", 0, "1/4", "--lower 1", "sum-rules 1; block 0 norm 1"),
    limit("limit-quotient-negative", CORNER, RANGE, "[-1]/(-3-4*w)", "1/5..1/5", 0, "1/4", "--lower 1", "sum-rules 1; block 0 norm 1"),
    limit("limit-constant", CORNER, RANGE, "[1/4]", "-7..7", 1, "1/4", "--lower 1", "level 1/4 1/4; sum-rules 1; block 0 norm 1"),
    limit("limit-at-once", CORNER, RANGE, "[1/4]", "1/5..1/5", 0, "1/4", "--lower 1", "towards 1/4 1/4; sum-rules 1; block 0 norm 1"),
    limit("limit-at-end", CORNER, RANGE, "[49/200+1/2*w]", "1/5..49/100", 0, "49/100", "--lower 1/50", "sum-rules 1; block 0 norm 1"),
    limit("limit-at-low-end", CORNER, RANGE, "[1/200+1/2*w]", "1/5..49/100", 0, "1/100", "--lower 1/50", "sum-rules 1; block 0 norm 1"),
    limit("limit-both", CORNER, RANGE, "[1/16+w]/(1+w)", "1/5..1/5", 0, "1/4", "--lower 1", "sum-rules 1; block 0 norm 1"),
    limit("limit-steep-end", CORNER, "w=4/25..9/20", "[9/80]/(1/5+w)", "1/5..1/5", 0, "1/4", "--lower 1/2", "sum-rules 1; block 0 norm 1"),
    limit("limit-in-turn", CORNER, RANGE, "[19/40-9/10*w]", "1/5..1/5", 0, "1/4", "--lower 1", "sum-rules 1; block 0 norm 1"),
    limit("limit-shorter", "[w-1/4,w,5/4-w,1-w]", RANGE, "[1/8+1/2*w]", "1/5..1/5", 0, "1/4", "--lower 2/5", "sum-rules 1; block 0 norm 1"),
    limit("limit-twice", TWICE, TWICES, ANGLES, "0..3", 1, "1", "--lower 2 --upper 2",
          "level 7/10 3/2; exponentials 0 1; sum-rules 3; stability; product 0 2 0 0; block 0 norm 1"),
    limit("limit-three-rules", CUT, TWICES, ANGLES, "0..3", 1, "1", "--lower 5/2", "level 7/10 3/2; sum-rules 3; block 0 norm 1"),
    limit("limit-arity-3", "[w,1-w,1,1-w,w]", "w=1/5..1/2", "[1/6+1/2*w]", "1/5..1/2", 0, "1/3", "--lower 1", "sum-rules 1; block 0 norm 1", 3),
    limit("limit-slowly", HALVED, HALVING, "sqrt[w]", "1/2..2", 0, "1", "--lower 1", f"{998 * 'towards 1/16 4; '}towards 1/4 2; towards 1/2 3/2; sum-rules 1; block 0 norm 1"),
    listed("list-any", HAT_CHAIKIN, "any", "--lower 1", "sum-rules 2; block 0 norm 1"),
    listed("list-one", "[1,3,3,1]/4", "any", "--lower 2", "sum-rules 2; block 0 norm 1"),
    listed("list-wide", FOUR_SPLINE, "any", "--lower 19/10", "sum-rules 4; block 0 norm 4"),
    listed("list-in-turn", FOUR_SPLINE, "follows=0-1,1-0", "--lower 2", "sum-rules 4; block 0 norm 4"),
    listed("list-spline-last", FOUR_SPLINE, "follows=0-1,1-1", "--lower 29/10", "sum-rules 4; block 0 norm 4"),
    listed("list-first-alone", FOUR_SPLINE, "follows=0-0", "--lower 19/10", "sum-rules 4; block 0 norm 4"),
    listed("list-arity-3", THREE, "any", "--lower 1", "sum-rules 2; block 0 norm 1", 3),
    listed("list-arity-3-follows", THREE, "follows=1-0,0-1", "--lower 1", "sum-rules 2; block 0 norm 2", 3),
    listed("list-least", FOUR_SPLINE, "any", "--lower 2 --upper 2", LEAST),
    listed("list-least-twice", FOUR_SPLINE, "any", "--lower 2 --upper 2", LEAST.replace("product 0 4 0 0", "product 0 16 0 0 0")),
    listed("list-least-six", FOUR_SPLINE, "any", "--lower 2 --upper 2", LEAST.replace("product 0 4 0 0", "product 0 4096 0 0 0 0 0 0 0")),
    listed("list-least-in-turn", FOUR_SPLINE, "follows=0-1,1-0", "--lower 2 --upper 2501/1000", LEAST_IN_TURN),
    listed("list-stable", FOUR_SPLINE, "follows=0-1,1-0", "--lower 2", LEAST_IN_TURN),
    listed("list-product", FOUR_SPLINE, "any", "--lower 2", LEAST.replace("stability; ", "")),
    listed("list-4096-pairs", "[1,3,3,1]/4", "follows=" + ",".join(4096 * ["0-0"]), "--lower 2", "sum-rules 2; block 0 norm 1"),
    chosen("points-product", "[1,3,3,1]/4", "w=1/32..3/32", "2", "sum-rules 2; product 0 1 0 0; block 0 norm 1"),
    chosen("points-four", FOUR, FOURS, "1", "sum-rules 2; block 0 norm 1"),
    chosen("points-four-2", FOUR, FOURS, "1", "sum-rules 2; block 0 norm 2"),
    chosen("points-four-1", FOUR, FOURS, "1/2", "sum-rules 1; block 0 norm 2"),
    chosen("points-corner", CORNER, "w=1/5..3/10", "1/2", "sum-rules 1; block 0 norm 2"),
    chosen("points-hat", "[1,2,1]/2", FOURS, "1", "sum-rules 2; block 0 norm 1"),
    chosen("points-transposed", CORNER, "w=1/5..3/10", "3/10", "sum-rules 1 transposed; block 0 norm 1"),
    chosen("points-four-transposed", FOUR, FOURS, "7/10", "sum-rules 2 transposed; block 0 norm 2"),
    chosen("points-transposed-polytope", ONE_SIDED, "w=1/5..3/10", "17/50", f"sum-rules 1 transposed; {two_vertices()}"),
    chosen("points-quotient", "[w,2-w,2-w,w]/(2)", "w=2/5..3/5", "1/2", "sum-rules 1; block 0 norm 2"),
    chosen("points-quotient-negative", "[-w,w-2,w-2,-w]/(-2)", "w=2/5..3/5", "1/2", "sum-rules 1; block 0 norm 2"),
    chosen("points-none", "[1,3,3,1]/4", FOURS, "2", "sum-rules 2; block 0 norm 1"),
    chosen("points-no-square", "[1,3,3,1+0*w^2]/4", FOURS, "2", "sum-rules 2; block 0 norm 1"),
    listed("period", FOUR_SPLINE, "period=0,1", "--lower 2 --upper 5/2",
           "sum-rules 4; stability; product 0 8 0 2; block 0 norm 2"),
    listed("period-exact", FOUR_SPLINE, "period=0,1", "--exact 4-log|[-8,1]@8,0,1/1000|^1/1 --logarithm 0",
           "exact 4-log|[-8,1]@8,0,1/1000|^1/1; root 8 0 0 8 8; sum-rules 4; stability; product 0 8 0 2; block 0 single 8 0; "
           "square 1; factor 0; recurrence -8 1; logarithm 0"),
    listed("period-stable", FOUR_SPLINE, "period=0,1", "", "sum-rules 4; stability"),
    listed("period-twice", "[1,3,3,1]/4", "period=0,0", "--lower 2", "sum-rules 2; block 0 norm 1"),
    listed("period-six", "[1,2,1]/2@-1", "period=0,0,0,0,0,0", "--lower 1", "sum-rules 1; block 0 norm 1"),
]

MANY, PAIRS = ";".join(64 * ["[-1,0,9,16,9,0,-1]/16"]), ",".join(33 * ["63-0"])
OTHER = "what keeps the recurrence from being"
EDITED = [
    ("follow-early", "follow-affine", follow(HALF, "0..1", 1), "come into the range at a later level", [("from=2", "from=1")]),
    ("follow-no-way", "follow-affine", None, "do not come into the range", [("level 1/10 3/5; level 3/20 2/5; ", "")]),
    ("follow-half-way", "follow-affine", None, "do not come into the range", [("level 3/20 2/5; ", "")]),
    ("follow-way-below", "follow-affine", None, "do not come into the range", [("level 3/20 2/5; ", "level 1/200 2/5; ")]),
    ("follow-low", "follow-affine", None, f"{OTHER} below", [("level 1/10", "level 11/100")]),
    ("follow-high", "follow-affine", None, f"{OTHER} above", [("3/5", "59/100")]),
    ("follow-reversed", "follow-constant", None, "the values of a level are an interval", [("level 1/4 1/4", "level 1/4 1/5")]),
    ("follow-more", "follow-slowly", None, "more levels than the checker allows", [("bounds 0 -; ", "bounds 0 -; level 1/4 1/4; ")]),
    ("follow-inside", "follow-square", None, f"{OTHER} above", [("3/20 1/4", "3/20 1/5")]),
    ("follow-root-low", "follow-root", None, f"{OTHER} below", [("level 1/5", "level 9/40")]),
    ("follow-root-high", "follow-root", None, f"{OTHER} above", [("2/5", "38/100")]),
    ("follow-root-minus", "follow-root", None, "a root may be above", [("level 1/5 2/5", "level -2/5 -1/5")]),
    ("follow-root-none", "follow-root-of-0", follow(OPEN_ROOT, "-2..1", 2), f"{OTHER} below", [("-1..1", "-2..1")]),
    ("follow-out-above", "follow-same", follow("[2*w]", "1/100..49/100", 0), f"{OTHER} above", [("[w]", "[2*w]")]),
    ("follow-out-below", "follow-same", follow("[1/2*w]", "1/100..49/100", 0), f"{OTHER} below", [("[w]", "[1/2*w]")]),
    ("follow-pole", "follow-quotient", follow("[1]/(1/4-w)", "1/5..1/5", 0), "the denominator of the recurrence", [("(3+w)", "(1/4-w)")]),
    ("follow-pole-later", "follow-quotient-open", follow("[1+w]/(4-w)", "0..inf", "some"), "the denominator of the recurrence",
     [("(4+3*w)", "(4-w)"), ("3/8", "9/20")]),
    ("follow-open-above", "follow-root-open", follow(ROOT, "1..inf", "some"), "an unbounded start begins above the range", [("0..inf", "1..inf")]),
    ("follow-open-negative", "follow-same", follow("[w]", "-1..inf", "some", values="w=-1/2..-1/4"), "with a positive upper end",
     [(RANGE, "w=-1/2..-1/4"), ("1/100..49/100", "-1..inf"), ("from=0", "from=some")]),
    ("follow-open-0", "follow-same", follow("[w]", "-1..inf", "some", values="w=-1/2..0"), "with a positive upper end",
     [(RANGE, "w=-1/2..0"), ("1/100..49/100", "-1..inf"), ("from=0", "from=some")]),
    ("follow-root-0", "follow-constant", follow("sqrt[0]", "-7..7", 1, values="w=0..1"), "does not prove the claim",
     [(RANGE, "w=0..1"), ("[1/4]", "sqrt[0]"), ("level 1/4 1/4", "level 0 0"), ("to 49/100", "to 1")]),
    ("follow-pole-at-end", "follow-quotient", follow(AT_END, "1/5..1/5", 0), "the denominator of the recurrence", [("[1]/(3+w)", AT_END)]),
    ("follow-to-end", "follow-same", follow("[w]", "1/5..49/100", 1), f"{OTHER} below",
     [("1/100..49/100 from=0", "1/5..49/100 from=1"), ("bounds 0 -; ", "bounds 0 -; level 49/100 49/100; ")]),
    ("follow-open-slow", "follow-slow-open", follow("[1/100+19/20*w]", "49/100..inf", "some"), f"{OTHER} above nine tenths of", [("7/8", "19/20")]),
    ("follow-open-below", "follow-affine-open", follow("[1/4-1/10*w]", "0..inf", "some"), f"{OTHER} below", [(HALF, "[1/4-1/10*w]")]),
    ("follow-open-root-below", "follow-root-open", follow("sqrt[1/16-1/50*w]", "0..inf", "some"), f"{OTHER} below", [(ROOT, "sqrt[1/16-1/50*w]")]),
    ("follow-open-root-slow", "follow-root-open", follow("sqrt[1/20*w+41/50*w^2]", "1/4..inf", "some"), OTHER,
     [(ROOT, "sqrt[1/20*w+41/50*w^2]"), ("0..inf", "1/4..inf"), ("level 1/5 2/5; ", "")]),
    ("follow-as-levels", "follow-affine", f"--mask {CORNER} --arity 2 --levels {RANGE} --lower 0", "fields", []),
    ("levels-as-follow", "corner-levels", follow(HALF, "0..1", 2), "expected 'levels ", []),
    ("follow-other-start", "follow-affine", follow(HALF, "0..2", 2), "expected 'levels ", []),
    ("follow-not-there", "follow-affine", None, "expected 'sum-rules'", [("sum-rules 1", "levels 1/4 1/3; sum-rules 1")]),
    ("limit-high", "limit-affine", tending(CORNER, RANGE, HALF, "0..1", 2, "1/5", "--lower 3/4 --upper 3/4"), "does not prove the claim", []),
    ("limit-low", "limit-affine", tending(CORNER, RANGE, HALF, "0..1", 2, "1/5", "--lower 7/10 --upper 7/10"), "does not prove the claim", []),
    ("limit-zero", "limit-affine", tending(CORNER, RANGE, HALF, "0..1", 2, "1/5", "--lower 0"), "must be positive", []),
    ("limit-rules-alone", "limit-root", tending(CORNER, RANGE, OPEN_ROOT, "-1..1", 2, "1/4", "--lower 1 --upper 1"), "no exponent below the number of sum rules",
     [("sum-rules 1", "sum-rules 1; stability; product 0 1 0 1")]),
    ("limit-unstable", "limit-affine", None, "expected 'stability'", [("stability; ", "")]),
    ("limit-full", "limit-affine", None, "expected 'sum-rules M'", [("sum-rules 1", "sum-rules 1 full")]),
    ("limit-reduced", "limit-root", None, "expected 'sum-rules'", [("sum-rules 1", "reduced [1] [1,3,3,1]/4; sum-rules 1")]),
    ("limit-logarithm", "limit-conic-exact", None, "expected 'end'", [("recurrence -4 1", "recurrence -4 1; logarithm 0")]),
    ("limit-other", "limit-affine", tending(CORNER, RANGE, HALF, "0..1", 2, "1/4", BETWEEN), "expected 'levels ", []),
    ("limit-moved", "limit-affine", tending(CORNER, RANGE, HALF, "0..1", 2, "1/4", BETWEEN), "moves the limit", [("limit=1/5", "limit=1/4")]),
    ("limit-moved-root", "limit-root", tending(CORNER, RANGE, OPEN_ROOT, "-1..1", 2, "1/5", "--lower 1"), "moves the limit", [("limit=1/4", "limit=1/5")]),
    ("limit-other-root", "limit-constant", tending(CORNER, "w=-1..1", "sqrt[1/4]", "-7..7", 1, "-1/2", "--lower 1"), "moves the limit",
     [(RANGE, "w=-1..1"), ("[1/4]", "sqrt[1/4]"), ("limit=1/4", "limit=-1/2"), ("level 1/4 1/4", "level 1/2 1/2")]),
    ("limit-beyond", "limit-constant", tending(CORNER, "w=0..1/4", "[w^2]", "0..1/4", 0, "1", "--lower 1"), "is not among the values",
     [(RANGE, "w=0..1/4"), ("[1/4]", "[w^2]"), ("-7..7 from=1", "0..1/4 from=0"), ("limit=1/4", "limit=1"), ("level 1/4 1/4; ", "")]),
    ("limit-before", "limit-constant", tending(CORNER, "w=1/2..3/2", "[w]", "1/2..3/2", 0, "0", "--lower 1"), "is not among the values",
     [(RANGE, "w=1/2..3/2"), ("[1/4]", "[w]"), ("-7..7 from=1", "1/2..3/2 from=0"), ("limit=1/4", "limit=0"), ("level 1/4 1/4; ", "")]),
    ("limit-steep", "limit-quotient", tending(CORNER, RANGE, "[w]", "1/5..1/5", 0, "1/4", "--lower 1"), "the steepness", [(FALL, "[w]")]),
    ("limit-steep-down", "limit-quotient", tending(CORNER, RANGE, "[1/2-w]", "1/5..1/5", 0, "1/4", "--lower 1"), "the steepness", [(FALL, "[1/2-w]")]),
    ("limit-steep-root", "limit-quotient", tending(CORNER, RANGE, "sqrt[w^2]", "1/5..1/5", 0, "1/4", "--lower 1"), "the steepness", [(FALL, "sqrt[w^2]")]),
    ("limit-too-soon", "limit-towards", None, "the steepness", [("towards 1/2 3/2; ", "")]),
    ("limit-no-way", "limit-towards", None, "the steepness", [("towards 1/4 2; towards 1/2 3/2; ", "")]),
    ("limit-towards-low", "limit-towards", None, f"{OTHER} below", [("towards 1/4 2", "towards 1/3 2")]),
    ("limit-towards-high", "limit-towards", None, f"{OTHER} above", [("towards 1/4 2", "towards 1/4 15/8")]),
    ("limit-towards-reversed", "limit-towards", None, "the values of a level are an interval", [("towards 1/2 3/2", "towards 3/2 1/2")]),
    ("limit-towards-left", "limit-towards", None, f"{OTHER} below", [("towards 1/2 3/2; ", "towards 1/2 3/2; towards 2/3 5/4; towards 5/6 9/8; ")]),
    ("limit-not-into-itself", "limit-constant", tending(CORNER, "w=-1..2", "[1/4+1/2*w^2]", "0..0", 0, "1/4", "--lower 1"), f"{OTHER} above",
     [(RANGE, "w=-1..2"), ("[1/4]", "[1/4+1/2*w^2]"), ("-7..7 from=1", "0..0 from=0"), ("level 1/4 1/4; ", "")]),
    ("limit-left-again", "limit-in-turn", None, f"{OTHER} below", [("sum-rules 1", "towards 1/30 1/2; sum-rules 1")]),
    ("limit-more", "limit-slowly", None, "more levels than the checker allows", [("towards 1/4 2", "towards 1/16 4; towards 1/4 2")]),
    ("limit-pole", "limit-quotient", tending(POLE, RANGE, FALL, "1/5..1/5", 0, "1/4", "--lower 1"), "the denominator of the masks", [(CORNER, POLE)]),
    ("limit-sum", "limit-quotient", tending("[w,1-w,1-w,1/4]", RANGE, FALL, "1/5..1/5", 0, "1/4", "--lower 1"), "do not sum to the arity",
     [(CORNER, "[w,1-w,1-w,1/4]")]),
    ("limit-rules", "limit-quotient", tending(ONE_SIDED, RANGE, FALL, "1/5..1/5", 0, "1/4", "--lower 1"), "no sum rules of this order",
     [(CORNER, ONE_SIDED), ("sum-rules 1", "sum-rules 2")]),
    ("limit-no-factor", "limit-conic", None, "no such exponential factor", [("exponentials 1", "exponentials 2"), ("sum-rules 4", "sum-rules 6")]),
    ("limit-no-factor-twice", "limit-twice", None, "no such exponential factor", [("exponentials 0 1", "exponentials 1 0")]),
    ("limit-no-factor-four", "limit-conic", None, "no such exponential factor", [("exponentials 1", "exponentials 0 0 0 1")]),
    ("limit-remainder", "limit-twice", tending(LEFT, TWICES, ANGLES, "0..3", 1, "1", "--lower 2 --upper 2"), "no such exponential factor",
     [(TWICE, LEFT), ("exponentials 0 1", "exponentials 1")]),
    ("limit-power", "limit-twice", tending(CUT, TWICES, ANGLES, "0..3", 1, "1", "--lower 5/2"), "no such exponential factor",
     [(TWICE, CUT), ("exponentials 0 1", "exponentials 1"), ("stability; product 0 2 0 0; ", "")]),
    ("limit-no-place", "limit-twice", None, "no such exponential factor", [("exponentials 0 1", "exponentials 0 2"), ("sum-rules 3", "sum-rules 5")]),
    ("limit-no-rule", "limit-conic", None, "a sum rule is needed", [("exponentials 1", "exponentials 2")]),
    ("limit-no-constants", "limit-twice", tending("[1,2*w,1]/(1+w)", TWICES, ANGLES, "0..3", 1, "1", "--lower 1"), "a sum rule is needed",
     [(TWICE, "[1,2*w,1]/(1+w)"), ("exponentials 0 1", "exponentials 1"), ("sum-rules 3; stability; product 0 2 0 0", "sum-rules 2")]),
    ("limit-too-few-rules", "limit-conic", None, "no sum rules of this order", [("sum-rules 4", "sum-rules 5")]),
    ("limit-nine", "limit-twice", None, "fields", [("exponentials 0 1", "exponentials 0 1 0 0 0 0 0 0 0")]),
    ("limit-other-angle", "limit-twice", tending(TWICE, TWICES, "[1/2+1/2*w]", "0..3", 1, "1", "--lower 2 --upper 2"), "exponentials need",
     [(ANGLES, "[1/2+1/2*w]"), ("level 7/10 3/2", "level 1/2 2")]),
    ("limit-other-cosine", "limit-twice", tending(TWICE, TWICES, "sqrt[2/3+1/3*w]", "0..3", 1, "1", "--lower 2 --upper 2"), "exponentials need",
     [(ANGLES, "sqrt[2/3+1/3*w]"), ("level 7/10 3/2", "level 4/5 3/2")]),
    ("limit-exponentials-of-3-angle", "limit-twice", tending(NINE, TWICES, ANGLES, "0..3", 1, "1", "--lower 1", 3), "exponentials need",
     [(f"{TWICE} 2", f"{NINE} 3"), ("exponentials 0 1", "exponentials 1"), ("stability; product 0 2 0 0; ", "")]),
    ("limit-exponentials-of-3", "limit-arity-3", None, "exponentials need", [("sum-rules 1", "exponentials 0; sum-rules 1")]),
    ("limit-early", "limit-affine", tending(CORNER, RANGE, HALF, "0..1", 1, "1/5", BETWEEN), "come into the range at a later level", [("from=2", "from=1")]),
    ("limit-cut", "limit-twice", tending(CUT_AT_1, TWICES, ANGLES, "0..3", 1, "1", "--lower 2"), "no such exponential factor",
     [(TWICE, CUT_AT_1), ("exponentials 0 1", "exponentials 0 0 1"), ("stability; product 0 2 0 0; ", "")]),
    ("limit-to", "limit-quotient", None, "expected 'block 0'", [("block 0", "to 49/100; block 0")]),
    ("limit-as-follow", "limit-affine", follow(HALF, "0..1", 2), "fields", []),
    ("follow-as-limit", "follow-affine", tending(CORNER, RANGE, HALF, "0..1", 2, "1/5", "--lower 7/10"), "expected 'levels ", []),
    ("limit-of-bounds", "limit-conic-exact", tending(CONIC, CONICS, ANGLE, "0..3", 2, "1", "--lower 2 --upper 19/10"), "expected 'product'", []),
    ("list-high", "list-any", lists(HAT_CHAIKIN, "any", "--lower 11/10"), "does not prove the claim", []),
    ("list-zero", "list-any", lists(HAT_CHAIKIN, "any", "--lower 0"), "must be positive", []),
    ("list-rules", "list-any", None, "has no sum rules of this order", [("sum-rules 2", "sum-rules 3")]),
    ("list-no-rules", "list-any", None, "number outside", [("sum-rules 2", "sum-rules 0")]),
    ("list-full", "list-any", None, "fields", [("sum-rules 2", "sum-rules 2 full")]),
    ("list-other-order", "list-in-turn", lists(FOUR_SPLINE, "any", "--lower 2"), "expected 'lists ", []),
    ("list-backwards", "list-spline-last", lists(FOUR_SPLINE, "follows=1-0,0-0", "--lower 29/10"), "does not prove the claim",
     [("follows=0-1,1-1", "follows=1-0,0-0")]),
    ("list-least-low", "list-least", lists(FOUR_SPLINE, "any", "--lower 2 --upper 199/100"), "spectral radius does not prove the claim", []),
    ("list-no-stability", "list-least", None, "expected 'stability", [("stability; ", "")]),
    ("list-no-product", "list-least", None, "expected 'product", [("product 0 4 0 0; ", "")]),
    ("list-stable-no-product", "list-stable", None, "expected 'product", [("product 0 8 0 0 3; ", "")]),
    ("list-not-stable", "list-least", lists(NOT_STABLE, "any", "--lower 1/2 --upper 1"), "stability",
     [(FOUR_SPLINE, NOT_STABLE), ("sum-rules 4", "sum-rules 2"), ("product 0 4", "product 0 2"), (LIST_POLYTOPE, "block 0 norm 2")]),
    ("list-not-stable-lower", "list-least", lists(NOT_STABLE, "any", "--lower 1/2"), "stability",
     [(FOUR_SPLINE, NOT_STABLE), ("sum-rules 4", "sum-rules 2"), ("product 0 4", "product 0 2"), (LIST_POLYTOPE, "block 0 norm 2")]),
    ("list-least-seven", "list-least-six", None, "a longer period", [("product 0 4096 0 0 0 0 0 0 0", "product 0 2 0 0 0 0 0 0 0 2")]),
    ("list-least-smooth", "list-one", lists("[1,3,3,1]/4", "any", "--lower 2 --upper 2"), "no exponent below the number of sum rules",
     [("sum-rules 2", "sum-rules 2; stability; product 0 1 0 0")]),
    ("list-no-way", "list-least-in-turn", None, "proves no positive spectral radius", [("product 0 8 0 0 3", "product 0 8 0 0 0")]),
    ("list-in-turn-high", "list-in-turn", lists(FOUR_SPLINE, "follows=0-1,1-0", "--lower 51/20"), "does not prove the claim", []),
    ("list-exact", "list-any", None, "an exact number is that of one mask or family",
     [("bounds - -", "bounds - -; exact 2-log|[-2,1]@2,0,1/10|^1/1; root 2 0 0 2 2")]),
    ("list-stability", "list-any", None, "expected 'product", [("block 0", "stability; block 0")]),
    ("list-single", "list-any", None, "polytope", [("block 0 norm 1", "block 0 single 2 8")]),
    ("list-no-constants", "list-any", lists(NO_CONSTANTS, "any", "--lower 1"), "does not keep constant data", [(HAT_CHAIKIN, NO_CONSTANTS)]),
    ("period-no-constants", "period-twice", lists(NO_CONSTANTS, "period=0,1", "--lower 1/2"), "does not keep constant data",
     [("[1,3,3,1]/4", NO_CONSTANTS), ("period=0,0", "period=0,1"), ("sum-rules 2", "sum-rules 1")]),
    ("list-large", "list-any", lists(MANY, "follows=63-0", "--lower 1"), "transition matrices larger than 256",
     [(f"{HAT_CHAIKIN} 2 any", f"{MANY} 2 follows=63-0"), ("sum-rules 2", "sum-rules 1")]),
    ("list-many-pairs", "list-any", lists(MANY, f"follows={PAIRS}", "--lower 1"), "more work",
     [(f"{HAT_CHAIKIN} 2 any", f"{MANY} 2 follows={PAIRS}")]),
    ("list-narrow", "list-wide", lists(SIX_SPLINE, "any", "--lower 29/10"), "does not prove the claim",
     [(FOUR_SPLINE, SIX_SPLINE), ("norm 4", "norm 6")]),
    ("list-one-class", "list-any", lists("[1,3]", "any", "--lower 1"), "does not keep constant data", [(HAT_CHAIKIN, "[1,3]")]),
    ("list-1000", "list-any", lists(f"[{'1,' * 999}1]", "any", "--lower 1"), "expected 'lists ", []),
    ("period-1000", "period-twice", lists(f"[{'1,' * 499}1];[1,1]", "period=0,1", "--lower 1"), "expected 'lists ", []),
    ("points-product-small", "points-product", None, "proves no positive spectral radius", [("product 0 1 0", "product 0 1/2 0")]),
    ("points-high", "points-four", each_point(FOUR, FOURS, "3/2"), "does not prove the claim", []),
    ("points-zero", "points-four", each_point(FOUR, FOURS, "0"), "must be positive", []),
    ("points-wide", "points-four-2", each_point(FOUR, "w=1/32..1/4", "1"), "does not prove the claim", [(FOURS, "w=1/32..1/4")]),
    ("points-other", "points-four", each_point(FOUR, "w=1/32..1/16", "1"), "expected 'each-point ", []),
    ("points-as-levels", "points-four", f"--mask {FOUR} --arity 2 --levels {FOURS} --lower 0", "expected 'levels ", []),
    ("levels-as-points", "corner-levels", each_point(CORNER, RANGE, "1/2"), "expected 'each-point ", []),
    ("points-place", "points-none", None, "at places that depend", [("sum-rules 2", "sum-rules 3")]),
    ("points-places", "points-corner", each_point(MOVING, "w=1/5..3/10", "1/2"), "for all values", [(CORNER, MOVING), ("sum-rules 1", "sum-rules 2")]),
    ("points-rules", "points-four", None, "at places that depend", [("sum-rules 2", "sum-rules 3")]),
    ("points-constants", "points-none", each_point("[1,3,3,2]/4", FOURS, "2"), "no sum rules of this order", [("[1,3,3,1]", "[1,3,3,2]"), ("sum-rules 2", "sum-rules 1")]),
    ("points-class", "points-none", each_point("[1,3,3,1+w]/4", FOURS, "2"), "sum rules of this order", [("[1,3,3,1]", "[1,3,3,1+w]"), ("sum-rules 2", "sum-rules 1")]),
    ("points-values", "points-none", each_point("[1+w,3,3,1+w]/4", "w=0..1", "1/2"), "for all values", [("[1,3,3,1]", "[1+w,3,3,1+w]"), (FOURS, "w=0..1"), ("sum-rules 2", "sum-rules 1")]),
    ("points-one-class", "points-none", each_point("[1+w,3,3,1]/4", "w=0..1", "2"), "for all values", [("[1,3,3,1]", "[1+w,3,3,1]"), (FOURS, "w=0..1")]),
    ("points-square", "points-corner", each_point("[w^2,1-w,1-w,w]", "w=1/5..3/10", "1/2"), "of degree 1", [(CORNER, "[w^2,1-w,1-w,w]")]),
    ("points-over", "points-corner", each_point("[w,1-w,1-w,w]/(1+w)", "w=1/5..3/10", "1/2"), "over a number", [(CORNER, "[w,1-w,1-w,w]/(1+w)")]),
    ("points-over-0", "points-corner", each_point("[w,1-w,1-w,w]/(0)", "w=1/5..3/10", "1/2"), "over a number", [(CORNER, "[w,1-w,1-w,w]/(0)")]),
    ("points-exact", "points-four", None, "of one mask or family",
     [("bounds - -", "bounds - -; exact 2-log|[-2,1]@2,0,1/10|^1/1; root 2 0 0 2 2")]),
    ("points-full", "points-four", None, "expected 'transposed'", [("sum-rules 2", "sum-rules 2 full")]),
    ("points-11-free", "points-corner", each_point(WIDE[11], "w=1/5..3/10", "1/2"), "more choices", [(CORNER, WIDE[11])]),
    ("points-70-free", "points-corner", each_point(WIDE[72], "w=1/5..3/10", "1/2"), "more choices", [(CORNER, WIDE[72])]),
    ("points-1024", "points-corner", each_point(WIDE[9], "w=1/5..3/10", "1/2"), "does not prove the claim", [(CORNER, WIDE[9]), ("norm 2", "norm 1")]),
    ("points-2048", "points-corner", each_point(WIDE[10], "w=1/5..3/10", "1/2"), "more choices", [(CORNER, WIDE[10])]),
    ("points-transposed-twice", "points-transposed", None, "fields", [("transposed", "transposed transposed")]),
    ("points-by-columns", "points-corner", None, "does not prove the claim", [("sum-rules 1", "sum-rules 1 transposed")]),
    ("list-transposed", "list-any", None, "fields", [("sum-rules 2", "sum-rules 2 transposed")]),
    ("points-to", "points-four", None, "expected 'block 0'", [("block 0", "to 3/32; block 0")]),
    ("period-other", "period", lists(FOUR_SPLINE, "period=1,0", "--lower 2 --upper 5/2"), "expected 'lists ", []),
    ("period-high", "period", lists(FOUR_SPLINE, "period=0,1", "--lower 13/5"), "does not prove the claim", []),
    ("period-low", "period", lists(FOUR_SPLINE, "period=0,1", "--lower 2 --upper 12/5"), "does not prove the claim", []),
]
REJECTED = [(name, base, options, reason, [tuple(part.replace("; ", "\n") for part in edit) for edit in edits])
            for name, base, options, reason, edits in EDITED]
