"""Limits that are not C^1 around a vertex (5.14): where another frequency than 1 leads, the map folds, or an eigenvalue is above 1."""
import re

import vertex_fit_cases  # adds the mask of the butterfly scheme
from vertex_cases import doo_sabin, lines_of, loop, midedge, options_of

FITS = "fits 3/4"


def butterfly(n):
    return f"triangles:{n}"


def second(n, weight="3/10"):
    """Doo and Sabin's mask with another part of frequency 2."""
    return doo_sabin(n, "1/5") + f"|{weight}@0,0~2"


# name, scheme, rules, frequency, the lines behind the rows
ACCEPTED = [
    *((f"butterfly-{n}", "butterfly", butterfly(n), 2, ["around 124", FITS]) for n in (8, 9, 12)),
    ("loop-slow", "loop", loop(5, "31/640", "609/640"), 0, ["around 64"]),
    ("second", "doo-sabin", second(8), 2, ["around 64"]),
    ("folded", "doo-sabin", doo_sabin(3, "7/10"), 1, ["folds 71,35 67,67"]),
    ("above-1", "doo-sabin", second(8, "1"), 2, []),
    ("below-minus-1", "doo-sabin", second(8, "-3/2"), 2, []),
    ("above-1-last", "doo-sabin", doo_sabin(8) + "|1@0,0~4", 4, []),
    ("above-1-constant", "loop", loop(5, "-1", "2"), 0, []),
]


def of(base, rules, k, ends, **more):
    return lines_of(base, rules, refuted=(k, ends), **more)


def accepted():
    for name, base, rules, k, ends in ACCEPTED:
        yield f"not-c1-{name}", (options_of(base, rules, "not-c1").split(), of(base, rules, k, ends))


def rejected():
    """name, options, lines, reason"""
    def case(name, base, rules, k, ends, reason, edits=(), kind="not-c1", told=None, **more):
        lines = of(base, rules, k, ends, **more)
        for old, new in edits:
            assert any(re.search(old, line) for line in lines), (name, old)
            lines = [re.sub(old, new, line) for line in lines]
        return f"not-c1-{name}", told or options_of(base, rules, kind), "\n".join(lines).split("\n"), reason

    two, round_, apart = second(8), ["around 64"], "may not be below lambda"
    yield case("no-claim", "doo-sabin", two, 2, round_, "expected 'surface", kind="vertex")
    yield case("other-claim", "doo-sabin", two, 2, round_, "expected 'surface", told=options_of("doo-sabin", second(9), "not-c1"))
    yield case("no-lines", "doo-sabin", two, 2, round_, "expected 'not-c1'", edits=[("^not-c1 .*", "end")])
    yield case("not-leading", "doo-sabin", second(8, "1/20"), 2, round_, f"frequency 1 {apart}")
    yield case("two-lead", "doo-sabin", two + "|3/10@0,0~3", 2, round_, f"frequency 3 {apart}")
    yield case("constants-lead", "loop", loop(5, "31/640", "609/640"), 1, ["folds 64,64 64,0"], f"frequency 0 {apart}")
    yield case("behind-0", "loop", loop(5), 0, round_, f"frequency 1 {apart}")
    yield case("last", "doo-sabin", doo_sabin(8) + "|1/2@0,0~4", 4, round_, "the frequency is n/2")
    yield case("frequency-5", "doo-sabin", two, 2, round_, "number outside 0..4", edits=[("^not-c1 2", "not-c1 5")])
    yield case("other-frequency", "doo-sabin", two, 2, round_, "no eigenvector is shown near the values", edits=[("^not-c1 2", "not-c1 3")])
    yield case("c1", "doo-sabin", doo_sabin(5), 1, round_, "expected 'folds'")
    yield case("c1-folds", "doo-sabin", doo_sabin(5), 1, ["folds 64,64 64,0"], "the Jacobian is not shown to have both signs")
    yield case("folds-order", "doo-sabin", doo_sabin(3, "7/10"), 1, ["folds 71,35 67,67"], "the Jacobian is not shown to have both signs",
               edits=[(r"^folds (\S+) (\S+)", r"folds \2 \1")])
    yield case("folds-near", "doo-sabin", doo_sabin(3, "7/10"), 1, ["folds 6,6 6,0"], "a square is too near to the vertex")
    yield case("folds-0", "loop", loop(5, "31/640", "609/640"), 0, ["folds 64,64 64,0"], "a real map has no Jacobian")
    yield case("around-near", "doo-sabin", two, 2, ["around 6"], "a square is too near to the vertex")
    yield case("around-far", "doo-sabin", two, 2, ["around 4097"], "number outside")
    yield case("no-end", "doo-sabin", two, 2, [], "expected 'folds'")
    yield case("one", "doo-sabin", second(8, "3/4"), 2, round_, "between 0 and 1")
    yield case("radius", "doo-sabin", second(8, "1"), 2, [], "the radius is below 0", edits=[(r"^(not-c1 .*) (\S+)", r"\1 -\2")])
    yield case("above-off", "doo-sabin", second(8, "1"), 2, [], "no eigenvector is shown near the values",
               edits=[(r"^(not-c1 2 \S+ \S+) \S+", rf"\1 {2**64 + 2**62 + 2**21}")])
    yield case("real", "doo-sabin", doo_sabin(8) + "|1@0,0~4", 4, [], "a number of a real frequency is not real", edits=[(r"^(values \S+) 0", r"\1 1")])
    yield case("above-after", "doo-sabin", second(8, "1"), 2, round_, "expected 'end'")


# Wrong command lines
def usage():
    surface = "--surface [[1,3,3,1],[3,9,9,3],[3,9,9,3],[1,3,3,1]]/16@-1,-1 --dilation [2,0;0,2]"
    rules = "dual:8;0,0=1@0,0,0"
    for more in (f"--lower 1 --not-c1 {rules}", f"--not-c1 {rules}", f"--lower 3/2 --not-c1 {rules} --vertex {rules}",
                 f"--lower 3/2 --not-c1 {rules.replace('8', '8+')}"):
        yield 64, f"{surface} {more} golden.cert"
