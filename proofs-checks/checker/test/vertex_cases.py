"""Smoothness around vertices (5.11): surface certificates with an exponent above 1, and what vertex_writer.py adds."""
import re
from fractions import Fraction as Q

import vertex_writer

# mask, dilation, and the lines that prove 11/10
SURFACES = {
    "loop": ("[[0,0,1,2,1],[0,2,6,6,2],[1,6,10,6,1],[2,6,6,2,0],[1,2,1,0,0]]/16@-2,-2", "[2,0;0,2]",
             "sum-rules 4; digits 0,0 1,0 0,1 1,1; space 11; vector -1,1:1 -2,-1:1 -2,0:-3 -2,1:3 -2,2:-1 -1,-2:-1 -1,-1:3 -1,0:-3; vector -1,2:1 -2,-1:4 -2,0:-12 -2,1:12 -2,2:-4 -1,-2:-3 -1,-1:8 -1,0:-6; vector 0,0:1 -2,-1:2 -2,0:-5 -2,1:4 -2,2:-1 -1,-2:-2 -1,-1:4 -1,0:-2 0,-2:1 0,-1:-2; vector 0,1:1 -2,-1:7 -2,0:-18 -2,1:15 -2,2:-4 -1,-2:-6 -1,-1:12 -1,0:-6 0,-2:2 0,-1:-3; vector 0,2:1 -2,-1:16 -2,0:-42 -2,1:36 -2,2:-10 -1,-2:-12 -1,-1:24 -1,0:-12 0,-2:3 0,-1:-4; vector 1,-1:1 -2,-1:3 -2,0:-6 -2,1:4 -2,2:-1 -1,-2:-3 -1,-1:3 0,-2:3 0,-1:-3 1,-2:-1; vector 1,0:1 -2,-1:10 -2,0:-22 -2,1:16 -2,2:-4 -1,-2:-9 -1,-1:12 -1,0:-3 0,-2:6 0,-1:-6 1,-2:-1; vector 1,1:1 -2,-1:22 -2,0:-51 -2,1:39 -2,2:-10 -1,-2:-18 -1,-1:27 -1,0:-9 0,-2:9 0,-1:-9 1,-2:-1; vector 2,-2:1 -2,-1:4 -2,0:-6 -2,1:4 -2,2:-1 -1,-2:-4 0,-2:6 1,-2:-4; vector 2,-1:1 -2,-1:13 -2,0:-24 -2,1:16 -2,2:-4 -1,-2:-12 -1,-1:8 0,-2:12 0,-1:-6 1,-2:-4; vector 2,0:1 -2,-1:28 -2,0:-57 -2,1:40 -2,2:-10 -1,-2:-24 -1,-1:24 -1,0:-4 0,-2:18 0,-1:-12 1,-2:-4; block 0 norm 4"),
    "catmull-clark": ("[[1,4,6,4,1],[4,16,24,16,4],[6,24,36,24,6],[4,16,24,16,4],[1,4,6,4,1]]/64@-2,-2", "[2,0;0,2]",
             "sum-rules 4; digits 0,0 1,0 0,1 1,1; space 15; vector -2,2:1 -2,-2:1 -2,-1:-4 -2,0:6 -2,1:-4; vector -1,1:1 -2,-2:1 -2,-1:-3 -2,0:3 -2,1:-1 -1,-2:-1 -1,-1:3 -1,0:-3; vector -1,2:1 -2,-2:4 -2,-1:-12 -2,0:12 -2,1:-4 -1,-2:-3 -1,-1:8 -1,0:-6; vector 0,0:1 -2,-2:1 -2,-1:-2 -2,0:1 -1,-2:-2 -1,-1:4 -1,0:-2 0,-2:1 0,-1:-2; vector 0,1:1 -2,-2:4 -2,-1:-9 -2,0:6 -2,1:-1 -1,-2:-6 -1,-1:12 -1,0:-6 0,-2:2 0,-1:-3; vector 0,2:1 -2,-2:10 -2,-1:-24 -2,0:18 -2,1:-4 -1,-2:-12 -1,-1:24 -1,0:-12 0,-2:3 0,-1:-4; vector 1,-1:1 -2,-2:1 -2,-1:-1 -1,-2:-3 -1,-1:3 0,-2:3 0,-1:-3 1,-2:-1; vector 1,0:1 -2,-2:4 -2,-1:-6 -2,0:2 -1,-2:-9 -1,-1:12 -1,0:-3 0,-2:6 0,-1:-6 1,-2:-1; vector 1,1:1 -2,-2:10 -2,-1:-18 -2,0:9 -2,1:-1 -1,-2:-18 -1,-1:27 -1,0:-9 0,-2:9 0,-1:-9 1,-2:-1; vector 1,2:1 -2,-2:20 -2,-1:-40 -2,0:24 -2,1:-4 -1,-2:-30 -1,-1:48 -1,0:-18 0,-2:12 0,-1:-12 1,-2:-1; vector 2,-2:1 -2,-2:1 -1,-2:-4 0,-2:6 1,-2:-4; vector 2,-1:1 -2,-2:4 -2,-1:-3 -1,-2:-12 -1,-1:8 0,-2:12 0,-1:-6 1,-2:-4; vector 2,0:1 -2,-2:10 -2,-1:-12 -2,0:3 -1,-2:-24 -1,-1:24 -1,0:-4 0,-2:18 0,-1:-12 1,-2:-4; vector 2,1:1 -2,-2:20 -2,-1:-30 -2,0:12 -2,1:-1 -1,-2:-40 -1,-1:48 -1,0:-12 0,-2:24 0,-1:-18 1,-2:-4; vector 2,2:1 -2,-2:35 -2,-1:-60 -2,0:30 -2,1:-4 -1,-2:-60 -1,-1:80 -1,0:-24 0,-2:30 0,-1:-24 1,-2:-4; block 0 norm 3"),
    "doo-sabin": ("[[1,3,3,1],[3,9,9,3],[3,9,9,3],[1,3,3,1]]/16@-1,-1", "[2,0;0,2]",
             "sum-rules 3; digits 0,0 1,0 0,1 1,1; space 9; vector -1,2:1 -1,-1:-1 -1,0:3 -1,1:-3; vector 0,1:1 -1,-1:-1 -1,0:2 -1,1:-1 0,-1:1 0,0:-2; vector 0,2:1 -1,-1:-3 -1,0:6 -1,1:-3 0,-1:2 0,0:-3; vector 1,0:1 -1,-1:-1 -1,0:1 0,-1:2 0,0:-2 1,-1:-1; vector 1,1:1 -1,-1:-3 -1,0:4 -1,1:-1 0,-1:4 0,0:-4 1,-1:-1; vector 1,2:1 -1,-1:-6 -1,0:9 -1,1:-3 0,-1:6 0,0:-6 1,-1:-1; vector 2,-1:1 -1,-1:-1 0,-1:3 1,-1:-3; vector 2,0:1 -1,-1:-3 -1,0:2 0,-1:6 0,0:-3 1,-1:-3; vector 2,1:1 -1,-1:-6 -1,0:6 -1,1:-1 0,-1:9 0,0:-6 1,-1:-3; block 0 norm 3"),
    "midedge": ("[[0,1,1,0],[1,2,2,1],[1,2,2,1],[0,1,1,0]]/4@-1,-1", "[2,0;0,2]",
             "differences 3; digits 0,0 1,0 0,1 1,1; values 0,0:1 0,1:1 1,0:1 1,1:1; space 8; vector -1,-1:1 0,2:-3 1,-1:-4 1,1:3 1,2:4 2,-1:2 2,0:3 2,1:-6; vector -1,0:1 0,2:-3 1,-1:-2 1,2:5 2,0:5 2,1:-6; vector -1,1:1 0,2:-3 1,-1:-1 1,2:4 2,0:3 2,1:-4; vector -1,2:1 0,2:-3 1,2:3 2,-1:-1 2,0:3 2,1:-3; vector 0,-1:1 0,2:-1 1,-1:-2 1,2:2 2,0:3 2,1:-3; vector 0,0:1 0,2:-1 1,-1:-1 1,1:-1 1,2:2 2,0:2 2,1:-2; vector 0,1:1 0,2:-1 1,1:-2 1,2:2 2,-1:-1 2,0:3 2,1:-2; vector 1,0:1 1,1:-2 1,2:1 2,-1:-1 2,0:2 2,1:-1; block 0 norm 5; sum-rules 1; space 8; vector -1,0:1 -1,-1:-1; vector -1,1:1 -1,-1:-1; vector 0,-1:1 -1,-1:-1; vector 0,0:1 -1,-1:-1; vector 0,1:1 -1,-1:-1; vector 1,-1:1 -1,-1:-1; vector 1,0:1 -1,-1:-1; vector 1,1:1 -1,-1:-1; block 0 norm 3"),
    "ternary": ("[[1,3,6,7,6,3,1],[3,9,18,21,18,9,3],[6,18,36,42,36,18,6],[7,21,42,49,42,21,7],[6,18,36,42,36,18,6],[3,9,18,21,18,9,3],[1,3,6,7,6,3,1]]/81@-2,-2", "[3,0;0,3]",
             "sum-rules 3; digits 0,0 1,0 2,0 0,1 1,1 2,1 0,2 1,2 2,2; space 9; vector -1,2:1 -1,-1:-1 -1,0:3 -1,1:-3; vector 0,1:1 -1,-1:-1 -1,0:2 -1,1:-1 0,-1:1 0,0:-2; vector 0,2:1 -1,-1:-3 -1,0:6 -1,1:-3 0,-1:2 0,0:-3; vector 1,0:1 -1,-1:-1 -1,0:1 0,-1:2 0,0:-2 1,-1:-1; vector 1,1:1 -1,-1:-3 -1,0:4 -1,1:-1 0,-1:4 0,0:-4 1,-1:-1; vector 1,2:1 -1,-1:-6 -1,0:9 -1,1:-3 0,-1:6 0,0:-6 1,-1:-1; vector 2,-1:1 -1,-1:-1 0,-1:3 1,-1:-3; vector 2,0:1 -1,-1:-3 -1,0:2 0,-1:6 0,0:-3 1,-1:-3; vector 2,1:1 -1,-1:-6 -1,0:6 -1,1:-1 0,-1:9 0,0:-6 1,-1:-3; block 0 norm 2"),
}


def loop(n, part="31/64-3/16*c-1/16*c^2", rest="33/64+3/16*c+1/16*c^2"):
    return f"triangles:{n};0,0={rest}@0,0,0|{part}@1,0~0"


def catmull_clark(n, own=""):
    return f"quads:{n};0,0={1 - Q(7, 4 * n)}@0,0,0|{Q(3, 2 * n)}@1,0~0|{Q(1, 4 * n)}@1,1~0{own}"


def doo_sabin(n, free="1/4"):
    return f"dual:{n};0,0=1/4@0,0,0|3/4@0,0~0|{free}@0,0~1"


def midedge(n):
    return f"dual:{n};0,0=1/2@0,0,0|1/4@0,0,1|1/4@0,0,{n - 1}"


def parsed(mask):
    """The coefficients of nested lists of numbers, by points."""
    lists, denominator, x, y = re.fullmatch(r"\[\[(.*)\]\]/(\d+)@(-?\d+),(-?\d+)", mask).groups()
    return {(int(x) + i, int(y) + j): Q(int(c), int(denominator)) for j, row in enumerate(lists.split("],["))
            for i, c in enumerate(row.split(",")) if c != "0"}


def lines_of(name, rules, **more):
    mask, dilation, body = SURFACES[name]
    arity = int(dilation[1])
    kind = "not-c1" if "refuted" in more else "vertex"
    return ["subcert-certificate 3", f"surface {mask} {dilation} {kind}={rules}", "bounds 11/10 -", *body.split("; "),
            *vertex_writer.vertex_lines(parsed(mask), arity, rules, **more), "end"]


def options_of(name, rules, kind="vertex"):
    mask, dilation, _ = SURFACES[name]
    return f"--surface {mask} --dilation {dilation} --lower 11/10 --{kind} {rules}"


# the rule of the mask itself for a point next to the vertex
OWN = ";1,0=3/8@0,0,0|3/8@1,0,0|1/16@1,1,0|1/16@1,0,1|1/16@1,1,{0}|1/16@1,0,{0}"
CASES = [
    *((f"loop-vertex-{n}", "loop", loop(n), {"levels": 0}) for n in (3, 4, 5, 6, 7, 12, 50)),
    *((f"catmull-clark-vertex-{n}", "catmull-clark", catmull_clark(n), {"levels": 0}) for n in (3, 4, 5, 20)),
    ("catmull-clark-vertex-own", "catmull-clark", catmull_clark(5, OWN.format(4)), {"levels": 0}),
    *((f"doo-sabin-vertex-{n}", "doo-sabin", doo_sabin(n), {"levels": 0}) for n in (3, 4, 5, 8, 50)),
    ("doo-sabin-vertex-free", "doo-sabin", doo_sabin(3, "3/5"), {"levels": 3}),
    *((f"midedge-vertex-{n}", "midedge", midedge(n), {"levels": 1}) for n in (4, 5, 20)),
    ("ternary-vertex", "ternary", "dual:4", {"levels": 0}),
]


def accepted():
    for name, base, rules, more in CASES:
        yield name, (options_of(base, rules).split(), lines_of(base, rules, **more))


def rejected():
    """name, options, lines, reason: files that are written for another claim, or from nothing."""
    def case(name, base, rules, reason, of=None, options=None, edits=(), **more):
        lines = [re.sub(r" vertex=.*", f" vertex={rules}", line) for line in lines_of(base, of or rules, **more)]
        for old, new in edits:
            assert any(re.search(old, line) for line in lines), (name, old)
            lines = [re.sub(old, new, line) for line in lines]
        return name, options or options_of(base, rules), "\n".join(lines).split("\n"), reason

    apart, small, near, open_map = ("may not be below lambda", "between 0 and 1", "no eigenvector is shown near the values",
                                    "not shown to be regular and in a half plane")
    ds, wrong = doo_sabin(5), "the weights of a rule do not sum to 1"
    vertex_0, vertex_line = catmull_clark(5), r"^(vertex \S+ \S+) (\S+) (\S+) (\S+)"
    # of another claim
    yield case("vertex-no-claim", "doo-sabin", ds, "expected 'end'", options=options_of("doo-sabin", ds).split(" --vertex")[0], edits=[(" vertex=.*", "")])
    yield case("vertex-no-lines", "doo-sabin", ds, "expected 'vertex'", edits=[("^vertex .*", "end")])
    yield case("vertex-other-rules", "doo-sabin", doo_sabin(6), near, of=ds)
    yield case("vertex-other-claim", "doo-sabin", ds, "expected 'surface", options=options_of("doo-sabin", doo_sabin(6)))
    yield case("vertex-other-valence", "loop", loop(8), near, of=loop(7))
    yield case("vertex-other-weight", "catmull-clark", vertex_0.replace("13/20", "193/200").replace("3/10", "-1/50").replace("1/20", "11/200"), f"frequency 0 {apart}",
               of=vertex_0)
    # schemes that are not C^1
    yield case("vertex-loop-slow", "loop", loop(5, "31/640", "609/640"), f"frequency 0 {apart}")
    yield case("vertex-second-frequency", "doo-sabin", doo_sabin(8, "1/5") + "|3/10@0,0~2", f"frequency 2 {apart}")
    yield case("vertex-last-frequency", "doo-sabin", doo_sabin(8) + "|1/4@0,0~4", f"frequency 4 {apart}")
    yield case("vertex-folded", "doo-sabin", doo_sabin(3, "7/10"), open_map, levels=5)
    yield case("vertex-levels", "doo-sabin", doo_sabin(3, "3/5"), open_map, levels=1)
    # what the claim says
    yield case("vertex-sum", "doo-sabin", ds.replace("3/4@", "7/10@"), wrong, of=ds)
    yield case("vertex-sum-c", "loop", loop(5, "31/64-3/16*c", "33/64+3/16*c+1/16*c^2"), wrong, of=loop(5))
    yield case("vertex-own-sum", "catmull-clark", catmull_clark(5, OWN.format(4).replace("1,0=3/8", "1,0=1/4")), wrong, of=vertex_0)
    yield case("vertex-one-sector", "catmull-clark", vertex_0.replace("@1,0~0", "@1,0,0"), "the rule of the vertex does not turn", of=vertex_0)
    yield case("vertex-other-ring", "catmull-clark", vertex_0 + "|1/9@1,0~1", "the rule of the vertex does not turn", of=vertex_0)
    yield case("vertex-mask-rule", "catmull-clark", "quads:5", "opposite of its sector", of=vertex_0)
    yield case("vertex-mask-rule-4", "catmull-clark", "quads:4", "the rule of the vertex does not turn", of=catmull_clark(4))
    yield case("vertex-dual-opposite", "doo-sabin", "dual:5", "opposite of its sector", of=ds)
    yield case("vertex-mask-shifted", "catmull-clark", "dual:5;0,0=1@0,0,0", "the mask does not turn", of=vertex_0)
    yield case("vertex-mask-quads", "loop", vertex_0, "the mask does not turn", of=loop(5))
    yield case("vertex-dilation", "doo-sabin", ds, "no multiple of the unit matrix", edits=[(r"\[2,0;0,2\]", "[0,2;2,0]")],
               options=options_of("doo-sabin", ds).replace("[2,0;0,2]", "[0,2;2,0]"))
    # the lines
    yield case("vertex-radius-wide", "doo-sabin", doo_sabin(1000), "a number that is divided by may be 0", radius_bits=15)
    for number, line in [("bits-63", "vertex 63"), ("bits-1025", "vertex 1025")]:
        yield case(f"vertex-{number}", "doo-sabin", ds, "number outside 64..1024", edits=[("^vertex 128", line)])
    yield case("vertex-xbits", "doo-sabin", ds, "number outside 0..4096", edits=[("^vertex 128 64", "vertex 128 4097")])
    yield case("vertex-levels-9", "doo-sabin", ds, "number outside 0..8", edits=[(vertex_line, r"\1 9 \3 \4")])
    yield case("vertex-lambda-0", "doo-sabin", ds, small, edits=[(vertex_line, r"\1 \2 \4 \4")])
    yield case("vertex-lambda-negative", "doo-sabin", ds, small, edits=[(vertex_line, r"\1 \2 -\3 \4")])
    yield case("vertex-lambda-1", "doo-sabin", ds, small, edits=[(vertex_line, rf"\1 \2 {2**64} 0")])
    yield case("vertex-lambda-off", "doo-sabin", ds, near, edits=[(vertex_line, rf"\1 \2 {2**63 + 2**21} \4")])
    yield case("vertex-radius-negative", "doo-sabin", ds, "the radius is below 0", edits=[(vertex_line, r"\1 \2 \3 -\4")])
    yield case("vertex-radius-0", "loop", loop(5), near, edits=[(vertex_line, r"\1 \2 \3 0")])
    yield case("vertex-radius-large", "doo-sabin", ds, near, edits=[(vertex_line, rf"\1 \2 \3 {2**62}")])
    yield case("vertex-value", "loop", loop(5), near, edits=[(r"^(values \S+ \S+) \S+", r"\1 5")])
    yield case("vertex-inverse-0", "loop", loop(5), near, edits=[(r"^(row \d+) .*", r"\1 0 0 0 0 0 0")])
    yield case("vertex-inverse-coarse", "loop", loop(5), near, edits=[("^inverse 24", "inverse 22")])
    yield case("vertex-points-twice", "doo-sabin", ds, "a point occurs twice", edits=[("^points 0,0", "points 0,0 0,0")])
    yield case("vertex-points-outside", "doo-sabin", ds, "not one of sector 0", edits=[("^points 0,0", "points 0,-1")])
    yield case("vertex-points-opposite", "doo-sabin", ds, "not one of sector 0", edits=[("^points 0,0", "points -1,-1")])
    yield case("vertex-points-few", "doo-sabin", ds, "has data elsewhere", edits=[("^(points.*) 1,1", r"\1 5,5")])
    yield case("vertex-points-no-vertex", "catmull-clark", vertex_0, "has data elsewhere", edits=[("^points 0,0 ", "points ")])
    yield case("vertex-points-less", "doo-sabin", ds, "a point depends on itself", points=[(0, 0)])
    yield case("vertex-points-none", "catmull-clark", vertex_0, "no point of a sector is given", edits=[("^points.*", "points 0,0")])
    yield case("vertex-points-many", "doo-sabin", ds, "wrong number of fields", edits=[("^points", "points " + " ".join(f"{k},0" for k in range(9, 79)))])
    yield case("vertex-values-few", "doo-sabin", ds, "wrong number of fields", edits=[(r"^values \S+", "values")])
    yield case("vertex-row-few", "doo-sabin", ds, "wrong number of fields", edits=[(r"^row 1 \S+", "row 1")])
    yield case("vertex-row-order", "doo-sabin", ds, "expected 'row 1'", edits=[("^row 1", "row 2")])
    yield case("vertex-after", "doo-sabin", ds, "expected 'end'", edits=[("^end", "row 4\nend")])


# Wrong rules in a claim: usage
def usage():
    surface = "--surface [[1,3,3,1],[3,9,9,3],[3,9,9,3],[1,3,3,1]]/16@-1,-1 --dilation [2,0;0,2]"
    for rules in ("", "dual", "dual:", "dual:2", "dual:1001", "dual:5:5", "hexagons:5", "dual:5;", "dual:5;0,0", "dual:5;0,0=", "dual:5;0,0=1",
                  "dual:5;0,0=1@0,0", "dual:5;0,0=@0,0,0", "dual:5;0,0=1@0,0,5", "dual:5;0,0=1@0,0,-1", "dual:5;0,0=1@0,0,0@0,0,0",
                  "dual:5;0,0=1@0,0~3", "dual:5;0,0=1@0,0~0~0", "dual:5;0,0=1@-1,0,0", "dual:5;0,0=1@0,17,0", "dual:5;0,0=w@0,0,0",
                  "dual:5;-1,0=1@0,0,0", "dual:5;17,0=1@0,0,0", "dual:5;0,0=1@0,0,0=1@0,0,0", "dual:5;0,0=1@0,0,0;0,0=1@0,0,0",
                  "quads:5;0,1=1@0,0,0", "quads:5;0,0=1@0,0,1", "quads:5;0,0=1@0,0~0", "triangles:5;1,-1=1@0,0,0",
                  "dual:5" + "".join(f";{k % 9},{k // 9}=1@0,0,0" for k in range(65)), "dual:5;0,0=" + "|".join(1001 * ["1@0,0,0"])):
        yield 64, f"{surface} --lower 11/10 --vertex {rules} hat-by-hand.cert"
    good = doo_sabin(5)
    yield 64, f"{surface} --lower 1 --vertex {good} hat-by-hand.cert"
    yield 64, f"{surface} --upper 2 --vertex {good} hat-by-hand.cert"
    yield 64, f"--mask [1,2,1]/2 --arity 2 --lower 1 --vertex {good} hat-by-hand.cert"
    yield 64, f"--refinable [[[2,0],[0,0]],[[4,0],[0,1]],[[2,0],[4,1]]]/4@-1 --dilation [2] --lower 11/10 --vertex {good} hat-by-hand.cert"
    yield 64, f"--matrices golden.mat --upper 2 --vertex {good} golden.cert"
    yield 64, f"{surface} --exact 0-log|[-1,2]@1/2,0,1/10|^1/1 --vertex {good} hat-by-hand.cert"
