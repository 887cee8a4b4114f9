"""Stability where coefficients are real numbers (6.3, section 7): masks that are 0 on a cycle of roots of unity, but not at all
roots of its order. Such a mask is q(z) = p(z^A)/p(z) times another one, and its function a combination of shifts of that one's with
the coefficients of p, which has the zeros omega^h, h = A^i or -A^i."""
from fractions import Fraction


def times(x, y):  # x: pairs (a, b) for a + b w
    result = [(0, 0)] * (len(x) + len(y) - 1)
    for i, (a, b) in enumerate(x):
        for j, c in enumerate(y):
            result[i + j] = (result[i + j][0] + a * c, result[i + j][1] + b * c)
    return result


def form(a, b):
    sign = "-" if b < 0 else "+" if a else ""
    return str(a) if b == 0 else f"{a or ''}{sign}{'' if abs(b) == 1 else f'{abs(b)}*'}w"


def text(mask, by):
    return "[" + ",".join(form(Fraction(a, by), Fraction(b, by)) for a, b in mask) + "]"


def rounded(mask, by, w):
    return "[" + ",".join(str((a + b * Fraction(w)) / by) for a, b in mask) + "]"


# arity 4: omega of order 5 for w = 2 cos(72 degrees), of order 15 for the same w
PENTAGON = times(times([(1, 0), (0, 1), (0, -1), (-1, 0), (0, -1), (0, 1), (1, 0)], [1, 1, 1, 1]), [1, 1, 1, 1])
FIFTEEN = times([(1, 0), (1, 1), (1, 0), (0, 1), (0, -1), (-2, 0), (-1, -2), (-2, 0), (0, -1), (0, 1), (1, 0), (1, 1), (1, 0)], [1, 1, 1, 1])
# binary: omega of order 17 for w = sqrt(17)
SEVENTEEN = times([(2, 0), (-1, 1), (5, -1), (-7, 1), (4, -2), (-7, 1), (5, -1), (-1, 1), (2, 0)], [1, 1])
PENTAGON_W, FIFTEEN_W, SEVENTEEN_W = text(PENTAGON, 4), text(FIFTEEN, 1), text(SEVENTEEN, 2)
# ternary: omega = -1 for w = 1
TERNARY = "[w,1-w,1,1-w,w]"
# that lower bounds of the squares are positive, or not: 1 - w is 20 * 2^-237 where they are 0, 25 if e_l is of L + 1 terms, 11 and
# less if |.| in them loses a sign
TERNARY_STABLE, TERNARY_UNDECIDED = (1 - Fraction(k, 2**237) for k in (23, 16))
# of modulus sqrt(3)/10 at -omega, omega of order 3; the largest integer below |P_0| - e_0, in units of 1/40 W
NEAR_CYCLE = "[9,1,1,9]/10"
NEAREST = 200557781673581021134778817087246769345421003578662689422014334114540556586432


def case(name, mask, arity, claim, order=1):
    option, short = claim
    return (name, f"--mask {mask} --arity {arity} {option} {short}",
            f"exponent {mask} {arity} {'within=' if option == '--within' else ''}{short}; bounds - -; sum-rules {order}; stability; end")


def over(ends):
    return "--for", f"w={ends}"


def within(distance):
    return "--within", distance


NEAR_PENTAGON, AWAY_5 = (rounded(PENTAGON, 4, w) for w in ("0.618034", "618/1000"))
NEAR_SEVENTEEN, AWAY_17 = (rounded(SEVENTEEN, 2, w) for w in ("4.123105625617", "43/10"))
MATRICES = CHANGED = REJECTED = []
ACCEPTED = [
    case("cycle-5-stable", PENTAGON_W, 4, over("2/3..7/10"), 2),
    case("cycle-5-stable-rounded", AWAY_5, 4, within("1/1000000,2"), 2),
    case("cycle-15-stable", FIFTEEN_W, 4, over("2/3..7/10")),
    case("cycle-17-stable", SEVENTEEN_W, 2, over("43/10..9/2")),
    case("cycle-17-stable-rounded", AWAY_17, 2, within("1/1000000000000,1")),
    case("cycle-2-stable", TERNARY, 3, over("-1..1/2")),
    case("cycle-2-stable-just", TERNARY, 3, over(f"-1..{TERNARY_STABLE}")),
    case("cycle-3-stable-rounded", NEAR_CYCLE, 2, within("433/10000,1")),
    case("cycle-3-stable-rounded-just", NEAR_CYCLE, 2, within(f"{Fraction(NEAREST, 40 * 2**256)},1")),
]
UNSTABLE = "stability: the symbol on a cycle of roots of unity of order "
WRITTEN = [
    (*case("cycle-5", PENTAGON_W, 4, over("3/5..7/10"), 2), UNSTABLE + "5 is not"),
    (*case("cycle-5-rounded", NEAR_PENTAGON, 4, within("1/1000000,2"), 2), UNSTABLE + "5 may be 0"),
    (*case("cycle-15", FIFTEEN_W, 4, over("3/5..7/10")), UNSTABLE + "15 is not"),
    (*case("cycle-17", SEVENTEEN_W, 2, over("41/10..33/8")), UNSTABLE + "17 is not"),
    (*case("cycle-17-rounded", NEAR_SEVENTEEN, 2, within("1/1000000000000,1")), UNSTABLE + "17 may be 0"),
    (*case("cycle-2", TERNARY, 3, over("1/2..3/2")), UNSTABLE + "2 is not"),
    (*case("cycle-2-undecided", TERNARY, 3, over(f"-1..{TERNARY_UNDECIDED}")), UNSTABLE + "2 is not"),
    (*case("cycle-3-rounded", NEAR_CYCLE, 2, within("434/10000,1")), UNSTABLE + "3 may be 0"),
    (*case("cycle-3-rounded-just", NEAR_CYCLE, 2, within(f"{(NEAREST + Fraction(255, 256)) / (40 * 2**256)},1")),
     UNSTABLE + "3 may be 0"),
]
