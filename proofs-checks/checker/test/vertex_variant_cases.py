"""What only one check of smoothness around vertices (5.11) refuses, or only it takes: for the wrong variants of the checkers."""
import re
from fractions import Fraction as Q

from vertex_cases import SURFACES, doo_sabin, lines_of, loop, options_of, parsed

# as SURFACES
MASKS = {
    "not-divisible": ("[[1,4,7,4,1],[4,16,24,16,4],[7,24,32,24,7],[4,16,24,16,4],[1,4,7,4,1]]/64@-2,-2", "[2,0;0,2]",
             "sum-rules 2; digits 0,0 1,0 0,1 1,1; space 21; vector -2,0:1 -2,-2:1 -2,-1:-2; vector -2,1:1 -2,-2:2 -2,-1:-3; vector -2,2:1 -2,-2:3 -2,-1:-4; vector -1,-1:1 -2,-2:1 -2,-1:-1 -1,-2:-1; vector -1,0:1 -2,-2:2 -2,-1:-2 -1,-2:-1; vector -1,1:1 -2,-2:3 -2,-1:-3 -1,-2:-1; vector -1,2:1 -2,-2:4 -2,-1:-4 -1,-2:-1; vector 0,-2:1 -2,-2:1 -1,-2:-2; vector 0,-1:1 -2,-2:2 -2,-1:-1 -1,-2:-2; vector 0,0:1 -2,-2:3 -2,-1:-2 -1,-2:-2; vector 0,1:1 -2,-2:4 -2,-1:-3 -1,-2:-2; vector 0,2:1 -2,-2:5 -2,-1:-4 -1,-2:-2; vector 1,-2:1 -2,-2:2 -1,-2:-3; vector 1,-1:1 -2,-2:3 -2,-1:-1 -1,-2:-3; vector 1,0:1 -2,-2:4 -2,-1:-2 -1,-2:-3; vector 1,1:1 -2,-2:5 -2,-1:-3 -1,-2:-3; vector 1,2:1 -2,-2:6 -2,-1:-4 -1,-2:-3; vector 2,-2:1 -2,-2:3 -1,-2:-4; vector 2,-1:1 -2,-2:4 -2,-1:-1 -1,-2:-4; vector 2,0:1 -2,-2:5 -2,-1:-2 -1,-2:-4; vector 2,1:1 -2,-2:6 -2,-1:-3 -1,-2:-4; block 0 norm 6"),
    "gaps": ("[[1,1,2,2,1,1],[1,1,2,2,1,1],[2,2,4,4,2,2],[2,2,4,4,2,2],[1,1,2,2,1,1],[1,1,2,2,1,1]]/16@-2,-2", "[2,0;0,2]",
             "differences 3; digits 0,0 1,0 0,1 1,1; values -1,-1:1 -1,0:3 -1,1:3 -1,2:1 0,-1:3 0,0:9 0,1:9 0,2:3 1,-1:3 1,0:9 1,1:9 1,2:3 2,-1:1 2,0:3 2,1:3 2,2:1; space 10; vector -2,-2:1 -2,2:-5 -2,3:-4 -1,1:2 -1,2:4 -1,3:2 0,0:-4 0,2:12 0,3:8 1,-1:2 1,1:-8 1,2:-8 1,3:-2 2,-2:-5 2,-1:4 2,0:12 2,1:-8 2,2:-11 3,-2:-4 3,-1:2 3,0:8 3,1:-2 3,3:4; vector -2,-1:1 -2,2:4 -2,3:3 -1,1:-2 -1,2:-4 -1,3:-2 0,1:-4 0,2:-8 0,3:-4 1,-1:2 1,2:8 1,3:6 2,-1:-1 2,1:4 2,2:4 2,3:1 3,-1:-2 3,1:2 3,2:-4 3,3:-4; vector -2,0:1 -2,2:-3 -2,3:-2 -1,1:1 -1,2:2 -1,3:1 0,0:-2 0,2:6 0,3:4 1,1:-2 1,2:-4 1,3:-2 2,0:1 2,2:-3 2,3:-2 3,1:1 3,2:2 3,3:1; vector -2,1:1 -2,2:2 -2,3:1 -1,1:-1 -1,2:-2 -1,3:-1 0,1:-2 0,2:-4 0,3:-2 1,1:2 1,2:4 1,3:2 2,1:1 2,2:2 2,3:1 3,1:-1 3,2:-2 3,3:-1; vector -1,-2:1 -1,1:2 -1,2:-1 -1,3:-2 1,-1:-2 1,0:-4 1,2:4 1,3:2 2,-2:4 2,-1:-4 2,0:-8 2,1:8 2,2:4 2,3:-4 3,-2:3 3,-1:-2 3,0:-4 3,1:6 3,2:1 3,3:-4; vector -1,-1:1 -1,1:-2 -1,3:1 1,-1:-2 1,1:4 1,3:-2 3,-1:1 3,1:-2 3,3:1; vector -1,0:1 -1,1:1 -1,2:-1 -1,3:-1 1,0:-2 1,1:-2 1,2:2 1,3:2 3,0:1 3,1:1 3,2:-1 3,3:-1; vector 0,-2:1 0,0:-2 0,2:1 1,-1:1 1,1:-2 1,3:1 2,-2:-3 2,-1:2 2,0:6 2,1:-4 2,2:-3 2,3:2 3,-2:-2 3,-1:1 3,0:4 3,1:-2 3,2:-2 3,3:1; vector 0,-1:1 0,1:-2 0,3:1 1,-1:1 1,1:-2 1,3:1 2,-1:-1 2,1:2 2,3:-1 3,-1:-1 3,1:2 3,3:-1; vector 1,-2:1 1,-1:-1 1,0:-2 1,1:2 1,2:1 1,3:-1 2,-2:2 2,-1:-2 2,0:-4 2,1:4 2,2:2 2,3:-2 3,-2:1 3,-1:-1 3,0:-2 3,1:2 3,2:1 3,3:-1; block 0 norm 6; sum-rules 1; space 24; vector -2,-1:1 -2,-2:-1; vector -2,0:1 -2,-2:-1; vector -2,1:1 -2,-2:-1; vector -2,2:1 -2,-2:-1; vector -1,-2:1 -2,-2:-1; vector -1,-1:1 -2,-2:-1; vector -1,0:1 -2,-2:-1; vector -1,1:1 -2,-2:-1; vector -1,2:1 -2,-2:-1; vector 0,-2:1 -2,-2:-1; vector 0,-1:1 -2,-2:-1; vector 0,0:1 -2,-2:-1; vector 0,1:1 -2,-2:-1; vector 0,2:1 -2,-2:-1; vector 1,-2:1 -2,-2:-1; vector 1,-1:1 -2,-2:-1; vector 1,0:1 -2,-2:-1; vector 1,1:1 -2,-2:-1; vector 1,2:1 -2,-2:-1; vector 2,-2:1 -2,-2:-1; vector 2,-1:1 -2,-2:-1; vector 2,0:1 -2,-2:-1; vector 2,1:1 -2,-2:-1; vector 2,2:1 -2,-2:-1; block 0 norm 3"),
    "minus": ("[[1,4,6,4,1],[4,16,24,16,4],[6,24,36,24,6],[4,16,24,16,4],[1,4,6,4,1]]/64@-2,-2", "[-2,0;0,-2]",
             "sum-rules 4; digits -1,-1 0,-1 -1,0 0,0; space 15; vector -2,2:1 -2,-2:1 -2,-1:-4 -2,0:6 -2,1:-4; vector -1,1:1 -2,-2:1 -2,-1:-3 -2,0:3 -2,1:-1 -1,-2:-1 -1,-1:3 -1,0:-3; vector -1,2:1 -2,-2:4 -2,-1:-12 -2,0:12 -2,1:-4 -1,-2:-3 -1,-1:8 -1,0:-6; vector 0,0:1 -2,-2:1 -2,-1:-2 -2,0:1 -1,-2:-2 -1,-1:4 -1,0:-2 0,-2:1 0,-1:-2; vector 0,1:1 -2,-2:4 -2,-1:-9 -2,0:6 -2,1:-1 -1,-2:-6 -1,-1:12 -1,0:-6 0,-2:2 0,-1:-3; vector 0,2:1 -2,-2:10 -2,-1:-24 -2,0:18 -2,1:-4 -1,-2:-12 -1,-1:24 -1,0:-12 0,-2:3 0,-1:-4; vector 1,-1:1 -2,-2:1 -2,-1:-1 -1,-2:-3 -1,-1:3 0,-2:3 0,-1:-3 1,-2:-1; vector 1,0:1 -2,-2:4 -2,-1:-6 -2,0:2 -1,-2:-9 -1,-1:12 -1,0:-3 0,-2:6 0,-1:-6 1,-2:-1; vector 1,1:1 -2,-2:10 -2,-1:-18 -2,0:9 -2,1:-1 -1,-2:-18 -1,-1:27 -1,0:-9 0,-2:9 0,-1:-9 1,-2:-1; vector 1,2:1 -2,-2:20 -2,-1:-40 -2,0:24 -2,1:-4 -1,-2:-30 -1,-1:48 -1,0:-18 0,-2:12 0,-1:-12 1,-2:-1; vector 2,-2:1 -2,-2:1 -1,-2:-4 0,-2:6 1,-2:-4; vector 2,-1:1 -2,-2:4 -2,-1:-3 -1,-2:-12 -1,-1:8 0,-2:12 0,-1:-6 1,-2:-4; vector 2,0:1 -2,-2:10 -2,-1:-12 -2,0:3 -1,-2:-24 -1,-1:24 -1,0:-4 0,-2:18 0,-1:-12 1,-2:-4; vector 2,1:1 -2,-2:20 -2,-1:-30 -2,0:12 -2,1:-1 -1,-2:-40 -1,-1:48 -1,0:-12 0,-2:24 0,-1:-18 1,-2:-4; vector 2,2:1 -2,-2:35 -2,-1:-60 -2,0:30 -2,1:-4 -1,-2:-60 -1,-1:80 -1,0:-24 0,-2:30 0,-1:-24 1,-2:-4; block 0 norm 4"),
    "negative": ("[[-1,4,10,4,-1],[4,16,24,16,4],[10,24,28,24,10],[4,16,24,16,4],[-1,4,10,4,-1]]/64@-2,-2", "[2,0;0,2]",
             "sum-rules 4; digits 0,0 1,0 0,1 1,1; space 15; vector -2,2:1 -2,-2:1 -2,-1:-4 -2,0:6 -2,1:-4; vector -1,1:1 -2,-2:1 -2,-1:-3 -2,0:3 -2,1:-1 -1,-2:-1 -1,-1:3 -1,0:-3; vector -1,2:1 -2,-2:4 -2,-1:-12 -2,0:12 -2,1:-4 -1,-2:-3 -1,-1:8 -1,0:-6; vector 0,0:1 -2,-2:1 -2,-1:-2 -2,0:1 -1,-2:-2 -1,-1:4 -1,0:-2 0,-2:1 0,-1:-2; vector 0,1:1 -2,-2:4 -2,-1:-9 -2,0:6 -2,1:-1 -1,-2:-6 -1,-1:12 -1,0:-6 0,-2:2 0,-1:-3; vector 0,2:1 -2,-2:10 -2,-1:-24 -2,0:18 -2,1:-4 -1,-2:-12 -1,-1:24 -1,0:-12 0,-2:3 0,-1:-4; vector 1,-1:1 -2,-2:1 -2,-1:-1 -1,-2:-3 -1,-1:3 0,-2:3 0,-1:-3 1,-2:-1; vector 1,0:1 -2,-2:4 -2,-1:-6 -2,0:2 -1,-2:-9 -1,-1:12 -1,0:-3 0,-2:6 0,-1:-6 1,-2:-1; vector 1,1:1 -2,-2:10 -2,-1:-18 -2,0:9 -2,1:-1 -1,-2:-18 -1,-1:27 -1,0:-9 0,-2:9 0,-1:-9 1,-2:-1; vector 1,2:1 -2,-2:20 -2,-1:-40 -2,0:24 -2,1:-4 -1,-2:-30 -1,-1:48 -1,0:-18 0,-2:12 0,-1:-12 1,-2:-1; vector 2,-2:1 -2,-2:1 -1,-2:-4 0,-2:6 1,-2:-4; vector 2,-1:1 -2,-2:4 -2,-1:-3 -1,-2:-12 -1,-1:8 0,-2:12 0,-1:-6 1,-2:-4; vector 2,0:1 -2,-2:10 -2,-1:-12 -2,0:3 -1,-2:-24 -1,-1:24 -1,0:-4 0,-2:18 0,-1:-12 1,-2:-4; vector 2,1:1 -2,-2:20 -2,-1:-30 -2,0:12 -2,1:-1 -1,-2:-40 -1,-1:48 -1,0:-12 0,-2:24 0,-1:-18 1,-2:-4; vector 2,2:1 -2,-2:35 -2,-1:-60 -2,0:30 -2,1:-4 -1,-2:-60 -1,-1:80 -1,0:-24 0,-2:30 0,-1:-24 1,-2:-4; block 0 norm 4"),
    "right": ("[[1,3,3,1],[3,9,9,3],[3,9,9,3],[1,3,3,1]]/16@62,-1", "[2,0;0,2]",
             "sum-rules 3; digits 0,0 1,0 0,1 1,1; space 10; vector 61,2:1 61,-1:-1 61,0:3 61,1:-3; vector 62,1:1 61,-1:-1 61,0:2 61,1:-1 62,-1:1 62,0:-2; vector 62,2:1 61,-1:-3 61,0:6 61,1:-3 62,-1:2 62,0:-3; vector 63,0:1 61,-1:-1 61,0:1 62,-1:2 62,0:-2 63,-1:-1; vector 63,1:1 61,-1:-3 61,0:4 61,1:-1 62,-1:4 62,0:-4 63,-1:-1; vector 63,2:1 61,-1:-6 61,0:9 61,1:-3 62,-1:6 62,0:-6 63,-1:-1; vector 64,-1:1 61,-1:-1 62,-1:3 63,-1:-3; vector 64,0:1 61,-1:-3 61,0:2 62,-1:6 62,0:-3 63,-1:-3; vector 64,1:1 61,-1:-6 61,0:6 61,1:-1 62,-1:9 62,0:-6 63,-1:-3; vector 64,2:1 61,-1:-10 61,0:12 61,1:-3 62,-1:12 62,0:-9 63,-1:-3; block 0 norm 4"),
    "left": ("[[1,3,3,1],[3,9,9,3],[3,9,9,3],[1,3,3,1]]/16@-101,-1", "[2,0;0,2]",
             "sum-rules 3; digits 0,0 1,0 0,1 1,1; space 10; vector -101,2:1 -101,-1:-1 -101,0:3 -101,1:-3; vector -100,1:1 -101,-1:-1 -101,0:2 -101,1:-1 -100,-1:1 -100,0:-2; vector -100,2:1 -101,-1:-3 -101,0:6 -101,1:-3 -100,-1:2 -100,0:-3; vector -99,0:1 -101,-1:-1 -101,0:1 -100,-1:2 -100,0:-2 -99,-1:-1; vector -99,1:1 -101,-1:-3 -101,0:4 -101,1:-1 -100,-1:4 -100,0:-4 -99,-1:-1; vector -99,2:1 -101,-1:-6 -101,0:9 -101,1:-3 -100,-1:6 -100,0:-6 -99,-1:-1; vector -98,-1:1 -101,-1:-1 -100,-1:3 -99,-1:-3; vector -98,0:1 -101,-1:-3 -101,0:2 -100,-1:6 -100,0:-3 -99,-1:-3; vector -98,1:1 -101,-1:-6 -101,0:6 -101,1:-1 -100,-1:9 -100,0:-6 -99,-1:-3; vector -98,2:1 -101,-1:-10 -101,0:12 -101,1:-3 -100,-1:12 -100,0:-9 -99,-1:-3; block 0 norm 4"),
}


def moved(surface, by):
    """All of a mask and of its proof moved along the first axis."""
    mask, dilation, body = surface
    return (re.sub(r"@(-?\d+)", lambda x: f"@{int(x[1]) + by}", mask), dilation,
            re.sub(r"(?<= )-?\d+(?=,-?\d+:)", lambda x: str(int(x[0]) + by), body))


SURFACES.update(MASKS, **{f"right-{by}": moved(MASKS["right"], by) for by in (-1, 37)})


def near(name, point, factor=0, at=(0, 0), step=(1, 0)):
    """The mask's rule for a point, in a list of rules, and so many times a difference of data along an axis."""
    m = int(SURFACES[name][1][1])
    terms = [(k, value) for k, value in parsed(SURFACES[name][0]).items() if all((x - y) % m == 0 for x, y in zip(point, k))]
    text = "|".join(f"{value}@{(point[0] - k[0]) // m},{(point[1] - k[1]) // m},0" for k, value in terms)
    x, y = at
    return f";{point[0]},{point[1]}={text}" + (f"|{factor}@{x},{y},0|{-factor}@{x - step[0]},{y - step[1]},0" if factor else "")


def alone(vertex, along="7/8@1,0,0|1/8@0,0,0"):
    """Rules next to the vertex that make all data of one ring."""
    return (f"quads:5;0,0={vertex};1,0=1/2@1,0,0|1/4@1,0,1|1/4@1,0,4;2,0={along};1,1=1/2@1,0,0|1/2@1,0,1;"
            "2,1=3/4@1,0,0|1/4@1,0,1;1,2=1/4@1,0,0|3/4@1,0,1;2,2=1/2@1,0,0|1/2@1,0,1")


SAME = ";1,0=1@0,0,0;0,1=1@0,0,0;1,1=1@0,0,0"  # next to the corner of a face
EXACT = [(r"^(vertex \S+ \S+ \S+ \S+) \S+", r"\1 0")]  # with the radius 0
CORNER = [(0, 0)]
ONE_SIDE = doo_sabin(5) + near("doo-sabin", (7, 3), Q(-33, 50), (3, 1))
EXACT_CORNER = {"points": CORNER, "edits": EXACT}


def accepted():
    last_first = sorted([(0, 0), (0, 1), (1, 0), (1, 1)], reverse=True)
    for name, base, rules, more in (
            # the limits
            ("vertex-rules-64", "doo-sabin", doo_sabin(5) + "".join(
                near("doo-sabin", (x, y)) for x in range(9, 17) for y in range(9, 17) if (x, y) != (9, 9)), {}),
            ("vertex-terms-1000", "doo-sabin", doo_sabin(5).replace("|1/4@0,0~1", 998 * "|1/3992@0,0~1"), {}),
            # the vertex is none of the points: its rule is a mean of the ring
            ("vertex-of-ring", "catmull-clark", alone("1@1,0~0"), {"levels": 2, "points": [(1, 0)]}),
            ("vertex-first-row", "doo-sabin", doo_sabin(5), {"first": (3, 3), "points": last_first}),
            ("vertex-ring-outside", "doo-sabin", doo_sabin(5) + near("doo-sabin", (3, 3)) + "|100@0,0~2", {}),
            ("vertex-ring-of-squares", "doo-sabin", ONE_SIDE + near("doo-sabin", (8, 8)), {}),
            ("vertex-window-closed", "loop", loop(5) + near("loop", (3, 2), Q(-87, 100), (2, 1)), {}),
            ("vertex-first-outside", "doo-sabin", doo_sabin(5) + near("doo-sabin", (3, 3)) + "|1/1000@0,0~1", {}),
    ):
        yield name, (options_of(base, rules).split(), lines_of(base, rules, **{"levels": 0, **more}))


def rejected():
    """name, options, lines, reason"""
    apart, near_it, open_map = ("may not be below lambda", "no eigenvector is shown near the values",
                                "not shown to be regular and in a half plane")

    def case(name, base, rules, reason, edits=(), **more):
        lines = lines_of(base, rules, **{"levels": 0, **more})
        for old, new in edits:
            lines = [re.sub(old, new, line) for line in lines]
        return name, options_of(base, rules), lines, reason

    # data next to the vertex that stay where they are
    yield case("vertex-stays", "catmull-clark", alone("1@0,0,0", "1@1,0,0"), "a point depends on itself", levels=2, points=[(1, 0)])
    yield case("vertex-no-rule", "catmull-clark", alone("1@1,0~0").replace("0,0=1@1,0~0;", ""), "opposite of its sector", levels=2, points=[(1, 0)])
    # masks and dilations
    yield case("vertex-negative", "negative", "quads:4;0,0=7/16@0,0,0|5/8@1,0~0|-1/16@1,1~0", "a coefficient of the scheme of the differences is negative")
    yield case("vertex-not-divisible", "not-divisible", "quads:4;0,0=1/2@0,0,0|7/16@1,0~0|1/16@1,1~0", "the mask does not refine differences along an axis")
    yield case("vertex-gaps", "gaps", "dual:4", "the scheme of the differences does not keep constants")
    lines = lines_of("doo-sabin", "dual:4", levels=0)
    of_vertex = lines[[line.split()[0] for line in lines].index("vertex"):]
    for name, base, reason in (("vertex-dilation-minus", "minus", "no multiple of the unit matrix"), ("vertex-index-64", "right--1", "the mask does not turn"),
                               *((f"vertex-index-{base}", base, "an index of the mask is too large") for base in ("left", "right", "right-37"))):
        mask, dilation, body = SURFACES[base]
        yield name, options_of(base, "dual:4"), [lines[0], f"surface {mask} {dilation} vertex=dual:4", *lines[2:3], *body.split("; "), *of_vertex], reason
    # eigenvalues
    yield case("vertex-gap-1", "doo-sabin", doo_sabin(5) + "|1/4@0,0~2" + SAME, f"frequency 2 {apart}", **EXACT_CORNER)
    yield case("vertex-gap-large", "doo-sabin", f"dual:5;0,0=1@0,0~0|1/2@0,0~1;9,9=1@0,0~0|1@0,0~1|{2 ** 127}@0,0~2" + SAME, f"frequency 2 {apart}",
               **{**EXACT_CORNER, "points": [(0, 0), (9, 9)]})
    slow = (1 - Q(14, 10 ** 7)) / 2
    yield case("vertex-gap-24", "doo-sabin", f"dual:5;0,0=1@0,0~0|1/2@0,0~1|{slow}@0,0~2;1,1=1@0,0~0|1/2@0,0~1|1@0,0~2|{slow}@1,1~2;1,0=1@0,0~0;0,1=1@0,0~0;9,9=1@1,1,0",
               open_map)
    yield case("vertex-equal-data", "doo-sabin", doo_sabin(5) + SAME, open_map, levels=4, points=CORNER, edits=EXACT)
    yield case("vertex-divisor-0", "doo-sabin", doo_sabin(4) + SAME, "a number that is divided by may be 0", first=(2 ** 20, 2 ** 20), points=CORNER,
               edits=[(r"^vertex 128( \S+ \S+) \S+ \S+", rf"vertex 64\1 {2 ** 63} 4611686018427322365")])
    # a map that is regular by less, or not at all
    yield case("vertex-window", "doo-sabin", doo_sabin(3, "17/32"), open_map)
    yield case("vertex-window-triangles", "loop", loop(5) + near("loop", (3, 2), Q(-3579649, 4096000), (2, 1)), open_map)
    yield case("vertex-one-side", "doo-sabin", ONE_SIDE, open_map)
    yield case("vertex-other-side", "doo-sabin", doo_sabin(5) + near("doo-sabin", (3, 7), Q(-33, 50), (1, 3), (0, 1)), open_map)
    yield case("vertex-one-part", "doo-sabin", doo_sabin(6) + near("doo-sabin", (7, 3), Q(-344469, 512000), (4, 3)), open_map, levels=1)
    yield case("vertex-turned", "doo-sabin", doo_sabin(5), open_map, first=(-1, 2))
    turn = Q(4392081346164271959, 2 ** 64)
    yield case("vertex-on-half-plane", "doo-sabin", doo_sabin(3), open_map, first=(1 - turn, 1 + turn), radius_bits=30,
               edits=[(r"^vertex 128( \S+ \S+ \S+) \S+", rf"vertex 64\1 {2 ** 34}")])
    yield case("vertex-radius-wide-5", "doo-sabin", doo_sabin(5), open_map, levels=1, edits=[(r"^(vertex \S+ \S+ \S+ \S+) \S+", r"\1 7223794280143191")])
    yield case("vertex-first-outside-large", "doo-sabin", doo_sabin(5) + near("doo-sabin", (3, 3)) + "|100@0,0~1", open_map)
    # a reflection as well: the squares of the lattice are not those of the sectors
    mask, dilation, body = SURFACES["minus"]
    mirrored, body = dilation.replace("[-2", "[2"), body.replace("digits -1,-1 0,-1 -1,0 0,0", "digits 0,-1 1,-1 0,0 1,0")
    yield "vertex-dilation-mirrored", options_of("minus", "dual:4").replace(dilation, mirrored), [
        lines[0], f"surface {mask} {mirrored} vertex=dual:4", *lines[2:3], *body.split("; "), *of_vertex], "no multiple of the unit matrix"
