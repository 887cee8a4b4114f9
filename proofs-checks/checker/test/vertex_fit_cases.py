"""Smoothness around vertices by affine fits (Lemma 65, Theorem 66): masks of any sign, around one valence (5.11)."""
from fractions import Fraction

import vertices_cases
from vertex_cases import SURFACES, catmull_clark, doo_sabin, lines_of, loop, midedge, options_of
from vertex_variant_cases import near

# mask, dilation, and the lines that prove 11/10
SURFACES["butterfly"] = ("[[0,0,0,0,-1,-1,0],[0,0,-1,0,2,0,-1],[0,-1,2,8,8,2,-1],[0,0,8,16,8,0,0],[-1,2,8,8,2,-1,0],[-1,0,2,0,-1,0,0],[0,-1,-1,0,0,0,0]]/16@-3,-3", "[2,0;0,2]",
             "sum-rules 2; digits 0,0 1,0 0,1 1,1; space 27; vector -3,1:1 -3,-1:1 -3,0:-2; vector -3,2:1 -3,-1:2 -3,0:-3; vector -2,-1:1 -3,-1:1 -3,0:-1 -2,-2:-1; vector -2,0:1 -3,-1:2 -3,0:-2 -2,-2:-1; vector -2,1:1 -3,-1:3 -3,0:-3 -2,-2:-1; vector -2,2:1 -3,-1:4 -3,0:-4 -2,-2:-1; vector -1,-3:1 -3,-1:1 -2,-2:-2; vector -1,-2:1 -3,-1:2 -3,0:-1 -2,-2:-2; vector -1,-1:1 -3,-1:3 -3,0:-2 -2,-2:-2; vector -1,0:1 -3,-1:4 -3,0:-3 -2,-2:-2; vector -1,1:1 -3,-1:5 -3,0:-4 -2,-2:-2; vector -1,2:1 -3,-1:6 -3,0:-5 -2,-2:-2; vector 0,-3:1 -3,-1:3 -3,0:-1 -2,-2:-3; vector 0,-2:1 -3,-1:4 -3,0:-2 -2,-2:-3; vector 0,-1:1 -3,-1:5 -3,0:-3 -2,-2:-3; vector 0,0:1 -3,-1:6 -3,0:-4 -2,-2:-3; vector 0,1:1 -3,-1:7 -3,0:-5 -2,-2:-3; vector 0,2:1 -3,-1:8 -3,0:-6 -2,-2:-3; vector 1,-3:1 -3,-1:5 -3,0:-2 -2,-2:-4; vector 1,-2:1 -3,-1:6 -3,0:-3 -2,-2:-4; vector 1,-1:1 -3,-1:7 -3,0:-4 -2,-2:-4; vector 1,0:1 -3,-1:8 -3,0:-5 -2,-2:-4; vector 1,1:1 -3,-1:9 -3,0:-6 -2,-2:-4; vector 2,-3:1 -3,-1:7 -3,0:-3 -2,-2:-5; vector 2,-2:1 -3,-1:8 -3,0:-4 -2,-2:-5; vector 2,-1:1 -3,-1:9 -3,0:-5 -2,-2:-5; vector 2,0:1 -3,-1:10 -3,0:-6 -2,-2:-5; blocks 11 3 1 1 2 2 1 1 1 1 1 1 1; basis -1 -1 0 0 -1 1 0 1 0 1 0 1 0 2 3 1 -2 1 3 6 -1 -2 1 0 0 0 0; basis 0 1 0 0 0 -1 0 0 0 0 0 0 1 0 -1 0 1 0 -1 -1 0 1 0 0 0 0 0; basis -1 1 0 0 -2 -2 2 1 1 1 -2 -1 -1 0 -1 1 1 4 -3 9 -2 2 0 -2 1 0 0; basis 0 0 -1 -1 1 -1 -1 1 -2 0 0 2 2 2 3 1 1 -2 1 -3 1 -1 0 0 0 0 0; basis -1 0 1 1 1 0 0 -1 0 1 1 -2 1 -1 -3 -1 -1 0 0 0 0 0 0 0 0 0 0; basis 1 -1 -1 0 1 1 0 0 0 0 -1 1 -1 -1 1 0 0 0 0 0 0 0 0 0 0 0 0; basis 0 0 0 0 0 -1 1 0 0 0 -1 0 1 0 0 0 1 1 -4 2 0 0 0 -1 0 -3 1; basis -1 -1 0 1 2 1 -1 0 -2 2 1 0 0 -1 0 1 -2 -2 0 0 0 0 0 1 0 0 0; basis 1 0 0 0 0 0 0 0 2 -1 1 0 0 1 0 -2 1 1 0 0 0 0 0 0 0 0 0; basis 0 1 -1 0 1 1 -1 0 0 0 -2 1 0 0 0 1 0 0 0 0 0 0 0 0 0 0 0; basis 1 0 0 0 -2 -1 1 0 0 1 0 0 -1 -1 0 0 0 0 0 0 0 0 0 0 0 0 0; basis -1 0 1 -1 -1 0 0 0 0 -2 1 -1 0 1 0 0 0 0 0 0 0 0 0 0 0 0 0; basis 0 0 -1 -1 0 0 -1 1 0 0 0 0 -1 0 0 0 0 0 6 2 0 0 0 0 0 1 0; basis 0 0 0 0 0 -1 1 -1 0 0 -2 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0; basis 1 -1 1 -1 -1 2 0 -1 -2 -1 1 0 2 -1 0 0 0 0 0 0 0 0 0 0 0 0 0; basis -2 0 0 1 0 -1 1 1 2 0 2 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0; basis 1 1 0 0 1 0 -1 0 0 -1 -1 0 -1 1 0 0 0 0 0 0 0 0 0 0 0 0 0; basis 0 0 0 1 0 0 0 0 0 2 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0; basis 0 1 1 1 0 1 0 -1 0 0 1 0 -1 0 0 0 0 0 -4 -3 0 0 0 0 0 0 0; basis 0 0 -1 0 -1 -2 1 2 2 0 0 -1 1 2 0 0 0 0 0 0 0 0 0 0 0 0 0; basis 0 0 1 0 1 1 -2 -1 -1 -1 0 1 -2 -2 0 0 0 0 0 0 0 0 0 0 0 0 0; basis 0 -1 0 0 -1 0 1 0 -1 3 -1 -1 1 1 0 0 0 0 0 0 0 0 0 0 0 0 0; basis 0 0 -1 -1 1 0 0 0 0 -2 0 1 1 -1 0 0 0 0 0 0 0 0 0 0 0 0 0; basis 0 -1 0 0 0 0 0 0 0 0 0 0 1 0 0 0 0 0 1 1 0 0 0 0 0 0 0; basis 0 1 0 -1 0 0 0 0 -1 0 -1 1 0 -1 0 0 0 0 0 0 0 0 0 0 0 0 0; basis 0 0 -1 1 1 0 0 0 1 0 1 -1 -1 1 0 0 0 0 0 0 0 0 0 0 0 0 0; basis 0 0 1 0 -1 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0; inverse 0 0 0 0 0 0 0 0 0 0 1 2 0 1/2 2 9/2 9 29/2 0 4 10 19 31 0 12 28 49; inverse 0 0 0 0 0 0 0 0 0 0 0 1 0 1/2 1 3/2 3 13/2 0 2 4 7 12 0 6 12 20; inverse 0 0 0 0 0 0 0 0 0 0 1 3 0 1 3 7 13 21 0 6 15 28 45 0 18 41 72; inverse 0 0 0 0 0 0 0 0 0 0 -2 -6 0 -1 -4 -11 -22 -38 0 -10 -26 -50 -82 0 -32 -74 -130; inverse 0 0 0 0 0 0 0 0 0 0 1 3 0 1 3 7 13 21 0 6 15 28 45 0 18 41 71; inverse 0 0 0 0 0 0 0 0 0 0 -1 -2 0 -1/2 -1 -5/2 -5 -17/2 0 -2 -5 -9 -15 0 -5 -12 -21; inverse 0 0 0 0 0 0 0 0 0 0 0 -1 0 0 0 0 -1 -4 0 -1 -2 -3 -6 0 -2 -5 -9; inverse 0 0 0 0 0 0 0 0 0 0 -1 -3 0 -1/2 -1 -7/2 -8 -31/2 0 -3 -9 -18 -31 0 -11 -27 -48; inverse 0 0 0 0 0 0 0 0 0 0 1 4 0 1 3 8 16 29 0 8 20 38 63 0 25 58 102; inverse 0 0 0 0 0 0 0 0 0 0 1 3 0 1/2 2 11/2 11 39/2 0 5 13 25 41 0 16 37 65; inverse 0 0 0 0 0 0 0 0 0 0 1 2 0 0 1 3 6 10 0 2 6 12 20 0 7 17 30; inverse 0 0 0 0 0 0 0 0 0 0 0 -2 0 -3/2 -3 -9/2 -8 -31/2 0 -6 -12 -20 -32 0 -15 -32 -53; inverse 0 0 0 0 0 0 0 0 0 0 0 1 0 1/2 1 3/2 3 13/2 0 2 4 7 12 0 5 11 19; inverse 0 0 0 0 0 0 0 0 0 0 0 -1 0 -1 -2 -3 -5 -10 0 -4 -8 -13 -21 0 -10 -21 -35; inverse 0 0 0 0 0 1 0 0 0 0 1 5 0 3/2 3 11/2 11 45/2 0 6 13 23 39 0 16 35 60; inverse 0 0 0 0 0 0 0 0 0 1 3 6 0 3/2 5 23/2 21 67/2 0 9 23 43 69 0 26 61 106; inverse 0 0 0 0 -1 -3 0 0 0 -1 -4 -9 0 0 -1 -4 -10 -19 0 -1 -4 -10 -20 0 -3 -9 -19; inverse 0 0 0 0 1 3 0 0 1 3 7 13 0 2 6 12 21 33 0 6 15 27 43 0 12 28 48; inverse 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 -1 -1 -1 -1 -1 -3 -3 -3 -3; inverse 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1 1 1 1 1 4 4 4 4; inverse 0 1 0 1 4 10 0 0 2 7 16 30 0 3 10 22 40 65 4 13 28 50 80 16 34 60 95; inverse 0 1 0 0 1 4 0 0 0 1 4 10 0 0 1 4 10 20 0 1 4 10 20 1 4 10 20; inverse 1 3 0 1 3 6 0 0 1 3 6 10 0 1 3 6 10 15 1 3 6 10 15 3 6 10 15; inverse 0 0 0 0 0 0 0 1 2 3 4 5 0 3 6 9 12 15 0 6 12 18 24 0 10 20 30; inverse 0 0 1 2 3 4 0 2 4 6 8 10 0 3 6 9 12 15 -4 0 4 8 12 -15 -10 -5 0; inverse 0 0 0 0 0 0 0 0 0 0 0 0 1 1 1 1 1 1 4 4 4 4 4 10 10 10 10; inverse 0 0 0 0 0 0 1 1 1 1 1 1 3 3 3 3 3 3 6 6 6 6 6 10 10 10 10; block 0 norm 4; block 1 norm 4; block 2 norm 1; block 3 norm 1; block 4 norm 4; block 5 norm 4; block 6 norm 1; block 7 norm 1; block 8 norm 1; block 9 norm 1; block 10 norm 1; block 11 norm 1; block 12 norm 1")


def modified(n):
    """The rule of an edge, whose data are the means of three frequencies [ZSS96]."""
    return f"triangles:{n};1,0=3/4@0,0,0|1/4@1,0~0|1/2@1,0~1" + ("|1/4@1,0~2" if n > 3 else "")


def with_fits(lines, fits):
    return [*lines[:-1], *fits.split("; "), "end"] if fits else lines


ACCEPTED = [
    *((f"fits-butterfly-{n}", "butterfly", f"triangles:{n}", "3/4", {"levels": 3}) for n in (4, 5, 6, 7)),
    *((f"fits-modified-{n}", "butterfly", modified(n), "3/4", {"levels": 5}) for n in (3, 4, 5, 8, 50)),
    ("fits-loop", "loop", loop(5), "1/2", {"levels": 1}),
    ("fits-loop-wide", "loop", loop(7), "9/10", {"levels": 2}),
    ("fits-catmull-clark", "catmull-clark", catmull_clark(5), "1/2", {"levels": 2}),
    ("fits-doo-sabin", "doo-sabin", doo_sabin(5), "1/2", {"levels": 2}),
    ("fits-midedge", "midedge", midedge(5), "3/4", {"levels": 4}),
    ("fits-ternary", "ternary", "dual:4", "1/2", {"levels": 1}),
]


def accepted():
    for name, base, rules, fits, more in ACCEPTED:
        yield name, (options_of(base, rules).split(), with_fits(lines_of(base, rules, **more), f"fits {fits}"))


def rejected():
    """name, options, lines, reason"""
    def case(name, base, rules, reason, fits="fits 1/2", **more):
        return name, options_of(base, rules), with_fits(lines_of(base, rules, **more), fits), reason

    open_map, rate = "not shown to be regular and in a half plane", "the rate of the fits is not between 0 and 1"
    ds, all_ds = doo_sabin(5), vertices_cases.DOO_SABIN.format("40+")
    yield case("fits-none", "butterfly", "triangles:5", "a coefficient of the scheme of the differences is negative", "", levels=3)
    # the line
    yield case("fits-rate-0", "doo-sabin", ds, rate, "fits 0")
    yield case("fits-rate-negative", "doo-sabin", ds, rate, "fits -1/2")
    yield case("fits-rate-1", "doo-sabin", ds, rate, "fits 1")
    yield case("fits-rate-word", "doo-sabin", ds, "not an integer", "fits x")
    yield case("fits-rate-small", "doo-sabin", ds, "words do not contract by the rate", "fits 1/1000000000")
    yield case("fits-empty", "doo-sabin", ds, "wrong number of fields", "fits")
    yield case("fits-cuts-of-one", "doo-sabin", ds, "wrong number of fields", "fits 1/2 1")
    yield case("fits-twice", "doo-sabin", ds, "expected 'end'", "fits 1/2; fits 1/2", levels=2)
    yield "fits-of-all", options_of("doo-sabin", all_ds), with_fits(vertices_cases.lines_of("doo-sabin", all_ds), "fits 1/2"), "expected 'end'"
    # the mask
    yield case("fits-gaps", "gaps", "dual:4", "the mask does not keep affine functions")
    # what is not shown
    yield case("fits-folded", "doo-sabin", doo_sabin(3, "7/10"), open_map, levels=3)
    yield case("fits-levels-0", "butterfly", "triangles:4", open_map, "fits 3/4", levels=0)
    yield case("fits-levels-3", "butterfly", modified(3), open_map, "fits 3/4", levels=3)
    yield case("fits-turned", "doo-sabin", ds, open_map, levels=2, first=(-1, 2))
    yield case("fits-beside", "doo-sabin", ds, open_map, levels=0, first=(Fraction(957, 1000), Fraction(-291, 1000)))  # by the rest alone
    yield case("fits-behind", "doo-sabin", ds, open_map, levels=1, first=(-1, -1))
    for axis, point, at, step in ((0, (7, 3), (3, 1), (1, 0)), (1, (3, 7), (1, 3), (0, 1))):
        yield case(f"fits-bent-{axis}", "doo-sabin", ds + near("doo-sabin", point, -9, at, step), open_map, levels=0)
