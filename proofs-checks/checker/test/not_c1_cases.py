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
    ("butterfly-3", "butterfly", butterfly(3), 0, ["around 192", FITS]),
    *((f"butterfly-{n}", "butterfly", butterfly(n), 2, ["around 192", FITS]) for n in (8, 9, 12, 50)),
    ("loop-slow", "loop", loop(5, "31/640", "609/640"), 0, ["around 64"]),
    ("second", "doo-sabin", second(8), 2, ["around 64"]),
    ("folded", "doo-sabin", doo_sabin(3, "7/10"), 1, ["folds 64,64 64,0"]),
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
