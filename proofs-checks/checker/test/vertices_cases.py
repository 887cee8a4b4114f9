"""Smoothness around vertices of all valences from one on (5.12): what the checkers accept and what they reject."""
import re
from fractions import Fraction as Q

from vertex_cases import SURFACES, doo_sabin, lines_of as lines_of_one, options_of

LOOP = "triangles:{};0,0=33/64+3/16*c+1/16*c^2@0,0,0|31/64-3/16*c-1/16*c^2@1,0~0"
CATMULL_CLARK = "quads:{};0,0=1@0,0,0|-7/4/n@0,0,0|3/2/n@1,0~0|1/4/n@1,1~0"
DOO_SABIN = "dual:{};0,0=1/4@0,0,0|3/4@0,0~0|1/4@0,0~1"
MIDEDGE = "dual:{};0,0=1/2@0,0,0|1/4@0,0,1|1/4@0,0,-1"
OWN = ";1,0=3/8@0,0,0|3/8@1,0,0|1/16@1,1,0|1/16@1,0,1|1/16@1,1,-1|1/16@1,0,-1"  # that of the mask itself
FACE = ";1,1=1/4@0,0,0|1/4@1,0,0|1/4@1,1,0|1/4@1,0,1"
# Next to a corner whose data are c z, (1,1) stays in the line, (1,0) and (0,1) are on those of the next sector: no number is rounded
STRAIGHT = ";1,0=3/4@0,0,0|1/4@0,0,-1;0,1=3/4@0,0,0|1/4@0,0,1;1,1=3/4@0,0,0|1/4@1,1,0"
EXACT = "dual:13+;0,0=1/4@0,0,0|3/4@0,0~0|1/4@0,0~1" + STRAIGHT
HALVED = STRAIGHT.replace("1,1=3/4@0,0,0|1/4@1,1,0", "1,1=1/2@1,0,0|1/2@0,1,0")
NEAR_1 = MIDEDGE.format("100+") + HALVED  # lambda = (1 + c)/2
# lambda = 7/10 c - 1/10, of the other frequencies up to -4/5
NEGATIVE = "dual:40+;0,0=-1/10@0,0,0|7/20@0,0,1|7/20@0,0,-1|2/5@0,0~0" + HALVED
ON_LINE = {"points": "0,0 1,1"}
# The plane of x + y w in each sector, with lambda = 1/2 for all n; the constants have 1/2 + (1 - c)/8 - 5/16 nu
PLANE = ("quads:16+;0,0=1@0,0,0|-5/16/n@0,0,0|5/16/n@1,0~0;1,0=1/2-1/8*c@1,0,0|1/16@1,0,1|1/16@1,0,-1|3/8+1/8*c@0,0,0;"
         "2,0=1@1,0,0;1,1=1/2@1,0,0|1/2@1,0,1;2,1=1@1,0,0|1/2@1,0,1|-1/2@0,0,0;1,2=1/2@1,0,0|1@1,0,1|-1/2@0,0,0;2,2=1@1,0,0|1@1,0,1|-1@0,0,0")
ON_AXIS = {"points": "0,0 1,0", "start": "1/2"}
BENT = "dual:30+;0,0=1-1/2*c@0,0,0|1/4*c@0,0,1|1/4*c@0,0,-1"  # lambda = 1 - c/2 + c^2/2
POINTS = {"loop": "0,0 1,0 1,1 2,0", "catmull-clark": "0,0 1,0 1,1 1,2 2,0 2,1 2,2", "doo-sabin": "0,0 0,1 1,0 1,1", "midedge": "0,0 0,1 1,0"}
STARTS = {"loop": "5/8", "catmull-clark": "2/3", "doo-sabin": "1/2", "midedge": "1"}

# PLANE with another point; of the constants one eigenvalue is 1/2 or less, another one below -1/2 where 1/n is not small
SECOND = (PLANE.replace("-5/16/n@0,0,0|5/16/n@1,0~0", "-3/n@0,0,0|7/2/n@1,0~0|-1/2/n@3,0~0") +
          ";3,0=-12/25@3,0,0|147/50@1,0,0|-73/50@0,0,0")


LITTLE = "1/1000000000"


def lines_of(name, rules, halvings=4, bits=128, start=None, points=None):
    mask, dilation, body = SURFACES[name]
    return ["subcert-certificate 3", f"surface {mask} {dilation} vertex={rules}", "bounds 11/10 -", *body.split("; "),
            f"vertices {bits} {halvings} {start or STARTS[name]}", f"points {points or POINTS[name]}", "end"]


ACCEPTED = [
    ("loop-vertices", "loop", LOOP.format("60+"), {}),
    ("catmull-clark-vertices", "catmull-clark", CATMULL_CLARK.format("100+"), {}),
    ("catmull-clark-vertices-own", "catmull-clark", CATMULL_CLARK.format("200+") + OWN, {}),
    ("catmull-clark-vertices-second", "catmull-clark", CATMULL_CLARK.format("200+") + OWN + "|-1/8@1,0~2", {}),
    ("catmull-clark-vertices-ring", "catmull-clark", CATMULL_CLARK.format("200+") + FACE + "|1/64@1,1~1", {}),
    ("doo-sabin-vertices", "doo-sabin", DOO_SABIN.format("13+"), {}),
    ("doo-sabin-vertices-7", "doo-sabin", DOO_SABIN.format("7+"), {}),
    ("doo-sabin-vertices-named", "doo-sabin", DOO_SABIN.format("20+") + "|1/9@0,0~2|1/8@0,0~8", {}),
    ("midedge-vertices", "midedge", MIDEDGE.format("100+"), {"halvings": 7}),
    ("vertices-exact", "doo-sabin", EXACT, ON_LINE),
    ("vertices-exact-named", "doo-sabin", EXACT + "|-5/8@1,1~2", ON_LINE),
    ("vertices-exact-near-1", "midedge", NEAR_1, {"points": "0,0"}),
    ("vertices-plane", "catmull-clark", PLANE, ON_AXIS),
    ("vertices-free", "doo-sabin", DOO_SABIN.format("40+").replace("1/4@0,0~1", "73/100@0,0~1"), {"start": "49/50"}),
    ("vertices-share", "doo-sabin", DOO_SABIN.format("13+") + "|1/9/n@0,0~1", {"halvings": 6}),
]


def accepted():
    for name, base, rules, more in ACCEPTED:
        yield name, (options_of(base, rules).split(), lines_of(base, rules, **more))


def rejected():
    """name, options, lines, reason"""
    def case(name, base, rules, reason, edits=(), lines=None, **more):
        lines = lines or lines_of(base, rules, **more)
        for old, new in edits:
            assert any(re.search(old, line) for line in lines), (name, old)
            lines = [re.sub(old, new, line) for line in lines]
        return name, options_of(base, rules), lines, reason

    open_rest, ds, loop = "smoothness is not shown for all valences", DOO_SABIN.format("13+"), LOOP.format("100+")
    clark = CATMULL_CLARK.format("100+")
    # lines of another claim
    one = doo_sabin(13)
    yield case("vertices-of-one", "doo-sabin", ds, "expected 'vertices'",
               lines=[re.sub("vertex=.*", f"vertex={ds}", line) for line in lines_of_one("doo-sabin", one)])
    yield case("vertices-for-one", "doo-sabin", one, "expected 'vertex'", lines=lines_of("doo-sabin", one))
    yield case("vertices-other-first", "doo-sabin", ds, "expected 'surface", lines=lines_of("doo-sabin", DOO_SABIN.format("14+")))
    # rules that are not C^1, or not for all: a named frequency leads, all others, the constants, none of frequency 1
    yield case("vertices-named-leads", "doo-sabin", ds.replace("1/4@0,0~1", "1/5@0,0~1") + "|3/10@0,0~2", open_rest)
    yield case("vertices-named-equal", "doo-sabin", ds + "|1/4@0,0~3", open_rest)
    yield case("vertices-named-exactly", "doo-sabin", EXACT.replace("0~1", "0~1|1/4@0,0~2"), open_rest, **ON_LINE)
    yield case("vertices-others-equal", "doo-sabin", EXACT.replace("1/4@0,0,0|3/4@0,0~0|1/4@0,0~1", "1/2@0,0,0|1/2@0,0~0"), open_rest, **ON_LINE)
    yield case("vertices-constants-as-fast", "catmull-clark", PLANE, open_rest, **ON_AXIS, halvings=0)
    yield case("vertices-others-lead", "doo-sabin", ds.replace("1/4@0,0,0|3/4@", "3/5@0,0,0|2/5@").replace("1/4@0,0~1", "-1/10@0,0~1"), open_rest)
    yield case("vertices-constants-lead", "loop", loop.replace("33/64+3/16*c+1/16*c^2", "101/100").replace("31/64-3/16*c-1/16*c^2", "-1/100"), open_rest)
    yield case("vertices-constants-grow", "catmull-clark", clark.replace("-7/4/n", "7/4/n").replace("3/2/n", "-3/2/n").replace("1/4/n", "-1/4/n"), open_rest)
    yield case("vertices-constants-equal", "catmull-clark", clark.replace("|-7/4/n@0,0,0|3/2/n@1,0~0|1/4/n@1,1~0", ""), open_rest)
    yield case("vertices-constants-apart", "catmull-clark", clark + OWN + f"|{LITTLE}@1,0~0|-{LITTLE}@0,0,0", open_rest)
    yield case("vertices-constants-moved", "catmull-clark", clark.replace("1@0,0,0", f"1@0,0,0|{LITTLE}@0,0,0|-{LITTLE}@1,0~0"), open_rest)
    yield case("vertices-above-1", "midedge", MIDEDGE.format("100+").replace("1/2@", "3/2@").replace("1/4@", "-1/4@"), open_rest)
    yield case("vertices-share-near-1", "midedge", MIDEDGE.format("100+") + "|-2/9/n@0,0,0|1/9/n@0,0,1|1/9/n@0,0,-1", open_rest)
    yield case("vertices-share-near-1-line", "midedge", NEAR_1 + "|-1/45/n@0,0,0|1/90/n@0,0,1|1/90/n@0,0,-1", open_rest, points="0,0", halvings=7)
    yield case("vertices-others-negative", "doo-sabin", NEGATIVE, open_rest, points="0,0", start="3/5", halvings=7)
    yield case("vertices-tend-to-1", "doo-sabin", ds.replace("1/4@0,0~1", "1/4+1/2*c@0,0~1"), open_rest)
    yield case("vertices-folded", "doo-sabin", DOO_SABIN.format("7+").replace("1/4@0,0~1", "149/200@0,0~1"), open_rest, start="199/200", halvings=7)
    near_1 = MIDEDGE.format("100+")
    yield case("vertices-others-grow", "midedge", near_1 + "|-1/10@0,0~1", open_rest, start="9/10")
    yield case("vertices-near-1-named", "midedge", near_1 + "|-1/9@0,0~2", open_rest, halvings=7)
    yield case("vertices-near-1-bent", "midedge", BENT, open_rest, halvings=8)
    yield case("vertices-not-real", "midedge", MIDEDGE.format("13+").replace("1/4@0,0,1|1/4@0,0,-1", "1/2@0,0,1"),
               "the eigenvalues of a frequency and of its opposite are not the same")
    # zeros that are not where they should be: of the constants, of others, of the frequency 1
    yield case("vertices-constants-far", "catmull-clark", PLANE.replace("5/16/n", "64/n"), open_rest, **ON_AXIS, halvings=0)
    yield case("vertices-constants-second", "catmull-clark", SECOND, open_rest, **{**ON_AXIS, "points": "0,0 1,0 3,0"}, halvings=0)
    yield case("vertices-others-second", "midedge", NEAR_1 + "|-8@1,1,0|4@1,1,1|4@1,1,-1", open_rest, points="0,0 0,1 1,0 1,1")
    yield case("vertices-leader-negative", "doo-sabin", EXACT.replace("1/4@0,0~1", "-3/4@0,0~1"), open_rest, **ON_LINE, start="-1/2")
    yield case("vertices-start-flat", "doo-sabin", EXACT, open_rest, **ON_LINE, start="3/8")
    yield case("vertices-leader-tiny", "doo-sabin", EXACT.replace("1/4@0,0~1", f"{Q(1, 2 ** 40) - Q(1, 4)}@0,0~1").replace(
        "1/4@0,0,-1", "1/4@1,0,0"), open_rest, points="0,0 1,0 1,1", bits=64, start=f"{Q(1, 2 ** 40)}")
    # what the claim says
    wrong = "the weights of a rule do not sum to 1"
    yield case("vertices-sum", "doo-sabin", ds.replace("3/4@", "7/10@"), wrong)
    yield case("vertices-sum-share", "catmull-clark", clark.replace("3/2/n", "5/4/n"), wrong)
    yield case("vertices-sum-both", "catmull-clark", clark.replace("1@0,0,0|-7/4/n", "3/4@0,0,0|-3/2/n"), wrong)
    yield case("vertices-one-sector", "catmull-clark", clark.replace("@1,0~0", "@1,0,0"), "the rule of the vertex does not turn")
    yield case("vertices-other-ring", "catmull-clark", clark + "|1/9@1,0~1", "the rule of the vertex does not turn")
    yield case("vertices-mask-rule", "catmull-clark", "quads:13+", "opposite of its sector")
    yield case("vertices-frequency-9", "doo-sabin", DOO_SABIN.format("18+") + "|1/9@0,0~9", "a frequency of a rule is too large")
    # the lines
    yield case("vertices-halvings-few", "loop", LOOP.format("60+"), open_rest, halvings=0)
    yield case("vertices-start-far", "loop", loop, open_rest, start="1/100")
    yield case("vertices-start-word", "doo-sabin", ds, "not an integer", start="x")
    yield case("vertices-bits-63", "doo-sabin", ds, "number outside 64..1024", bits=63)
    yield case("vertices-halvings-17", "doo-sabin", ds, "number outside 0..16", halvings=17)
    yield case("vertices-points-twice", "doo-sabin", ds, "a point occurs twice", points="0,0 0,1 1,0 1,1 0,0")
    yield case("vertices-points-outside", "doo-sabin", ds, "not one of sector 0", points="0,-1")
    yield case("vertices-points-few", "doo-sabin", ds, "has data elsewhere", points="0,0 0,1 1,0 5,5")
    yield case("vertices-points-no-vertex", "catmull-clark", clark, "has data elsewhere", points="1,0 1,1 1,2 2,0 2,1 2,2")
    yield case("vertices-points-less", "doo-sabin", ds, "a point depends on itself", points="0,0")
    yield case("vertices-points-none", "catmull-clark", clark, "no point of a sector is given", points="0,0")
    yield case("vertices-points-many", "doo-sabin", ds, "wrong number of fields", points=" ".join(f"{k},0" for k in range(17)))
    yield case("vertices-first-outside", "doo-sabin", ds, open_rest, points="1,1 0,0 0,1 1,0", halvings=1)
    yield case("vertices-after", "doo-sabin", ds, "expected 'end'", edits=[("^end", "points 0,0\nend")])


# Wrong rules in a claim: usage
def usage():
    surface = "--surface [[1,3,3,1],[3,9,9,3],[3,9,9,3],[1,3,3,1]]/16@-1,-1 --dilation [2,0;0,2]"
    for rules in ("dual:+", "dual:6+", "dual:1001+", "dual:13++", "dual:13+;0,0=1@0,0,4", "dual:13+;0,0=1@0,0,-4", "dual:13+;0,0=1@0,0,-0",
                  "dual:13+;0,0=/n@0,0,0", "dual:13+;0,0=1/n/n@0,0,0", "dual:13;0,0=1/n@0,0,0", "dual:13;0,0=1@0,0,-1", "dual:13+;0,0=1@0,0~7",
                  "quads:13+;0,0=1@0,0,-1"):
        yield 64, f"{surface} --lower 11/10 --vertex {rules} hat-by-hand.cert"
