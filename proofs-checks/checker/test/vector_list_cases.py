"""Lists of masks of matrices (6.7): a mask for each level, of vector and Hermite schemes."""
from vector_range_cases import AS_VECTORS, CORNERS, HERMITE, LINES, MERRIEN, at

QUARTER, FIFTHS = at("1/4", CORNERS), at("2/5", CORNERS)
TWO = f"{QUARTER};{FIFTHS}"
HAT = "[[[1/2,0],[0,1/2]],[[1,0],[0,0]],[[1/2,0],[0,0]]]@1"
BACK = "[[[1/4,0],[0,1/2]],[[3/4,0],[0,1/2]],[[3/4,0],[0,1/2]],[[1/4,0],[0,0]]]@-1"
TERNARY = "[[[1/3,0],[0,1/2]],[[2/3,0],[0,1/2]],[[1,0],[0,1/2]],[[2/3,0],[0,0]],[[1/3,0],[0,0]]]@0"
TERNARY_LINES = "sum-rules 1; data 1 0; digits 0 1 2; reading 0.1:1; space 2; vector 0.1:1; vector 0.0:1 1.0:-1; "
NO_CONSTANTS = "[[[1/4,0],[0,1/2]],[[3/4,0],[0,1/2]],[[3/4,0],[0,0]],[[1/3,0],[0,0]]]@0"
SHIFTED, SMOOTH, ROUGH = (at(mu, MERRIEN, "m") for mu in ("-1", "-1/2", "3/2"))
HC, ROUGH_SMOOTH = f"{SHIFTED};{SMOOTH}", f"{ROUGH};{SMOOTH}"


def lists(kind, masks, order, end, arity=2):
    return f"--{kind} {masks} --arity {arity} --order {order} --lower {end}"


def listed(name, kind, masks, order, end, lines, arity=2):
    return name, lists(kind, masks, order, end, arity), f"lists {masks} {arity} {order} {kind}; bounds {end} -; {lines}; end"


MATRICES, CHANGED = [], []
ACCEPTED = [
    listed("vector-list-any", "vectors", TWO, "any", "3/10", f"{LINES}block 0 norm 1"),
    listed("vector-list-product", "vectors", TWO, "any", "3/10", f"{LINES}product 0 4/5 0 2; block 0 norm 1"),
    listed("vector-list-in-turn", "vectors", TWO, "follows=0-1,1-0", "3/4", f"{LINES}block 0 norm 6"),
    listed("vector-list-at-last", "vectors", TWO, "follows=0-1,1-1", "77/100", f"{LINES}block 0 norm 6"),
    listed("vector-list-period", "vectors", TWO, "period=0,1", "3/4", f"{LINES}block 0 norm 6"),
    listed("vector-list-period-three", "vectors", TWO, "period=0,0,1", "77/100", f"{LINES}block 0 norm 6"),
    listed("vector-list-one", "vectors", QUARTER, "any", "1", f"{LINES}block 0 norm 1"),
    listed("vector-list-elsewhere", "vectors", f"{HAT};{TWO}", "any", "3/10", f"{LINES}block 0 norm 1"),
    listed("vector-list-all-rules", "vectors", f"{QUARTER};{HAT}", "any", "1", f"{LINES}block 0 norm 1"),
    listed("vector-list-first-alone", "vectors", TWO, "follows=0-0", "1", f"{LINES}block 0 norm 1"),
    listed("vector-list-arity-3", "vectors", f"{TERNARY};{TERNARY}", "any", "3/5", f"{TERNARY_LINES}block 0 norm 1", 3),
    listed("hermite-list-any", "hermite", HC, "any", "1", f"{HERMITE}block 0 norm 6"),
    listed("hermite-list-period", "hermite", HC, "period=0,1", "1", f"{HERMITE}block 0 norm 6"),
    listed("hermite-list-one", "hermite", SMOOTH, "any", "1", f"{HERMITE}block 0 norm 6"),
    listed("hermite-list-as-vectors", "vectors", HC, "any", "1", f"{AS_VECTORS}block 0 norm 6"),
]
EDITED = [
    ("vector-list-high", "vector-list-any", lists("vectors", TWO, "any", "1/3"), "does not prove the claim", []),
    ("vector-list-zero", "vector-list-any", lists("vectors", TWO, "any", "0"), "must be positive", []),
    ("vector-list-above-rules", "vector-list-all-rules", lists("vectors", f"{QUARTER};{HAT}", "any", "11/10"), "the end is not below", []),
    ("vector-list-other-order", "vector-list-in-turn", lists("vectors", TWO, "any", "3/10"), "expected 'lists ", []),
    ("vector-list-other-kind", "hermite-list-any", lists("vectors", HC, "any", "1"), "expected 'lists ", []),
    ("vector-list-of-numbers", "list-any", lists("vectors", TWO, "any", "1"), "expected 'lists ", []),
    ("vector-list-no-kind", "vector-list-any", None, "expected 'lists ", [(" any vectors", " any")]),
    ("vector-list-backwards", "vector-list-at-last", lists("vectors", TWO, "follows=0-1,1-0", "77/100"), "does not prove the claim",
     [("follows=0-1,1-1", "follows=0-1,1-0")]),
    ("vector-list-any-of-in-turn", "vector-list-in-turn", lists("vectors", TWO, "any", "3/4"), "does not prove the claim", [("follows=0-1,1-0", "any")]),
    ("vector-list-period-other", "vector-list-period-three", lists("vectors", TWO, "period=0,1", "77/100"), "does not prove the claim",
     [("period=0,0,1", "period=0,1")]),
    ("vector-list-constants", "vector-list-any", lists("vectors", f"{QUARTER};{NO_CONSTANTS}", "any", "3/10"), "does not keep the constant data",
     [(TWO, f"{QUARTER};{NO_CONSTANTS}")]),
    ("vector-list-first-constants", "vector-list-any", lists("vectors", f"{NO_CONSTANTS};{QUARTER}", "any", "3/10"), "does not keep the constant data",
     [(TWO, f"{NO_CONSTANTS};{QUARTER}")]),
    ("vector-list-data", "vector-list-any", None, "does not keep the data", [("sum-rules 1; data 1 0", "sum-rules 2; data 1 0; data 0 0")]),
    ("vector-list-space", "vector-list-any", lists("vectors", f"{QUARTER};{BACK}", "any", "3/10"), "leads out of the space", [(TWO, f"{QUARTER};{BACK}")]),
    ("vector-list-many-pairs", "vector-list-any", lists("vectors", ";".join(64 * [QUARTER]), f"follows={','.join(64 * ['63-0'])}", "3/10"), "more work",
     [(f"{TWO} 2 any", f"{';'.join(64 * [QUARTER])} 2 follows={','.join(64 * ['63-0'])}")]),
    ("vector-list-exact", "vector-list-any", None, "exact numbers are those of one mask or family",
     [("bounds 3/10 -", "bounds - -; exact 1-log|[-1,1]@1,0,1/10|^1/1; root 1 0 0 1 1")]),
    ("vector-list-stability", "vector-list-any", None, "expected 'block 0'", [("block 0", "stability; block 0")]),
    ("vector-list-to", "vector-list-any", None, "expected 'block 0'", [("block 0", "to 1; block 0")]),
    ("vector-list-reduced", "vector-list-any", None, "expected 'sum-rules'", [("sum-rules 1", "reduced [1] [1,3,3,1]/4; sum-rules 1")]),
    ("hermite-list-2", "hermite-list-any", lists("hermite", HC, "any", "2"), "does not prove the claim", []),
    ("hermite-list-0", "hermite-list-any", lists("hermite", HC, "any", "0"), "fewer derivatives than its data are", []),
    ("hermite-list-3", "hermite-list-any", lists("hermite", HC, "any", "3"), "the end is not below the number of sum rules", []),
    ("hermite-list-rough", "hermite-list-any", lists("hermite", f"{ROUGH};{SMOOTH}", "any", "1"), "does not prove the claim",
     [(HC, ROUGH_SMOOTH)]),
]
REJECTED = [(name, base, options, reason, [tuple(part.replace("; ", "\n") for part in edit) for edit in edits])
            for name, base, options, reason, edits in EDITED]
