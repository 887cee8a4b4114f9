"""Vector and Hermite schemes (6.7). Spaces of Merrien's scheme and the graph were found by search."""
import re
from fractions import Fraction as Q

CORNERS = "[[[w,0],[0,1/2]],[[1-w,0],[0,1/2]],[[1-w,0],[0,0]],[[w,0],[0,0]]]@0"  # beside numbers that are halved
QUOTIENT = "[[[w,0],[0,1/2+1/2*w]],[[1,0],[0,1/2+1/2*w]],[[1,0],[0,0]],[[w,0],[0,0]]]/(1+w)@0"
MERRIEN = "[[[1/2,1/2-1/2*m],[-1/8,1/4*m]],[[1,0],[0,1/2]],[[1/2,-1/2+1/2*m],[1/8,1/4*m]]]@-1"  # HC^1 for -3 < m < 1
LINES = ("sum-rules 1; data 1 0; digits 0 1; reading 0.1:1; space 3; vector 0.1:1; vector 0.0:1 1.0:-1; vector 2.0:1 1.0:-1; ")
OTHER_WAY = "[[[1/2,0],[0,w]],[[1/2,0],[0,1-w]],[[0,0],[0,1-w]],[[0,0],[0,w]]]@0"
THREE = "[[[w,0,0],[0,1/2,0],[0,0,1/2]],[[1-w,0,0],[0,1/2,0],[0,0,1/2]],[[1-w,0,0],[0,0,0],[0,0,0]],[[w,0,0],[0,0,0],[0,0,0]]]@0"
THREE_LINES = LINES.replace("data 1 0", "data 1 0 0").replace("reading 0.1:1", "reading 0.1:1; reading 0.2:1").replace(
    "space 3; vector 0.1:1", "space 4; vector 0.1:1; vector 0.2:1")
HERMITE = ("sum-rules 3; digits 0 1; reading 0.0:-3 0.1:2 1.0:4 2.0:-1; space 3; vector 0.1:1 -1.0:-2 -1.1:1 0.0:2; "
           "vector 1.0:1 -1.0:3 -1.1:-2 0.0:-4; vector 1.1:1 -1.0:-4 -1.1:3 0.0:4; ")
AS_VECTORS = HERMITE.replace("sum-rules 3; ", "sum-rules 3; data 1 0; data 0 1; data 0 0; ")
GRAPH = ("block 0 graph 1 2251799813673989/562949953421312 60; coordinates 234238487; coordinates -13 2538962658; "
         "coordinates 475 -272831786292359 545663572679761; "
         "step 0 0 576460752306971776 3010855 27789972 -1484753256722 21756882 200814427 -10729045411476 -1168975265422 -10789555941172 "
         "576460752102480510; "
         "step 1 0 576463445965325056 576460752307309410 9263324 -494917752241 10878441 576460752406713006 -5364522719472 206 1898 "
         "576460752204894960; "
         "step 2 0 989835504661 -2007237 -18526648 989835504481 0 1 -54935 -4 -38 2007236; "
         "step 3 0 576460752306910976 576460752304298555 -18526648 989835504481 -31992990887 1 -54935 1168974667022 -38 2007236; tree 0000; ")
HALF, WAY = "[1/10+1/2*w]", "level 1/10 3/5; level 3/20 2/5; "
ONE_BLOCKS = "blocks 1 2; basis 1 0 0; basis 0 1 0; basis 0 0 1; inverse 1 0 0; inverse 0 1 0; inverse 0 0 1; "


def of(kind, mask, values, end):
    return f"--{kind} {mask} --arity 2 {f'--for {values} ' if values else ''}{end}"


def at(value, mask, letter="w"):
    """The mask with a number, as `1/4`, in the place of its letter."""
    return re.sub(rf"[^\[\],]*{letter}[^\[\],]*", lambda entry: str(eval(  # of a corpus
        re.sub(r"\d+/\d+", lambda number: f"Q('{number[0]}')", entry[0]).replace(letter, f"Q('{value}')"), {"Q": Q})), mask)


def levels(kind, mask, values, end, follow=""):
    return of(kind, mask, values, f"{follow}{end}").replace("--for", "--levels")


def accepted_levels(name, kind, mask, values, end, lines, start="", way=""):
    """Of all sequences of values, or of those that follow from each other with these first values."""
    option = start and f"--recurrence {HALF} --start {start} --from {way.count('level ')} "
    words = start and f" recurrence={HALF} start={start} from={way.count('level ')}"
    return name, levels(kind, mask, values, end, option), (
        f"{kind} {mask} 2 {values} levels{words}; bounds {end.split()[1]} -; {way}{lines}end")


def accepted(name, kind, mask, values, end, lines):
    option, number = end.split()
    bounds = f"{number} -" if option == "--lower" else f"- {number}"
    return name, of(kind, mask, values, end), f"{kind} {mask} 2{values and ' '}{values}; bounds {bounds}; {lines}end"


MATRICES = []
ACCEPTED = [
    accepted("vectors-by-hand", "vectors", CORNERS, "w=1/100..49/100", "--lower 0", LINES + "to 49/100; block 0 norm 1; "),  # SPEC.md, 6.8
    accepted("vectors-two-intervals", "vectors", CORNERS, "w=1/10..2/5", "--lower 0",
             LINES + "to 1/4; block 0 norm 1; to 2/5; block 0 norm 1; "),
    accepted("vectors-holder", "vectors", CORNERS, "w=1/5..3/10", "--lower 1/4", LINES + "to 3/10; block 0 norm 1; "),
    accepted("vectors-diverges", "vectors", CORNERS, "w=11/10..3/2", "--upper 0", LINES + "to 3/2; product 0 -2 0 0; "),
    accepted("vectors-other-way", "vectors", OTHER_WAY, "w=1/100..49/100", "--lower 0",
             LINES.replace("data 1 0", "data 0 1").replace(".0:", ".2:").replace(".1:", ".0:").replace(".2:", ".1:") + "to 49/100; block 0 norm 1; "),
    accepted("vectors-three", "vectors", THREE, "w=1/100..49/100", "--lower 0", THREE_LINES + "to 49/100; block 0 norm 1; "),
    accepted("vectors-quotient", "vectors", QUOTIENT, "w=1/100..99/100", "--lower 0", LINES + "to 99/100; block 0 norm 1; "),
    accepted("vectors-other-digits", "vectors", CORNERS, "w=1/5..3/10", "--lower 0",
             LINES.replace("digits 0 1", "digits 2 -1").replace("space 3; vector 0.1:1; vector 0.0:1 1.0:-1; vector 2.0:1 1.0:-1",
             "space 9; vector -1.1:1; vector 0.1:1; vector 1.1:1; vector 2.1:1; vector -1.0:1 0.0:-1; vector 1.0:1 0.0:-1; "
             "vector 2.0:1 0.0:-1; vector 3.0:1 0.0:-1; vector -2.0:1 0.0:-1") + "to 3/10; block 0 norm 5; "),
    accepted("hermite-merrien", "hermite", MERRIEN, "m=-1..0", "--lower 1", HERMITE + "to 0; " + GRAPH),
    accepted("hermite-as-vectors", "vectors", MERRIEN, "m=-1..0", "--lower 1", AS_VECTORS + "to 0; " + GRAPH),
    accepted("hermite-refuted", "hermite", MERRIEN, "m=2..3", "--upper 1", HERMITE + "to 3; product 0 0 642119/131072 0; "),
    accepted("hermite-refuted-zeros", "hermite", MERRIEN.replace("]]]@-1", "]],[[0,0],[0,0]]]@-1"), "m=2..3", "--upper 1",
             HERMITE + "to 3; product 0 0 642119/131072 0; "),
    accepted("hermite-refuted-2", "hermite", MERRIEN, "m=2..3", "--upper 2", HERMITE + "to 3; product 0 0 642119/131072 0; "),
    # one mask
    accepted("vectors-one", "vectors", at("1/4", CORNERS), "", "--lower 0", LINES + "block 0 norm 1; "),
    accepted("vectors-one-holder", "vectors", at("1/4", CORNERS), "", "--lower 99/100", LINES + "block 0 norm 1; "),
    accepted("vectors-one-blocks", "vectors", at("1/4", CORNERS), "", "--lower 0", LINES + ONE_BLOCKS + "block 0 norm 1; block 1 norm 1; "),
    accepted("vectors-one-diverges", "vectors", at("1", CORNERS), "", "--upper 0", LINES + "product 0 -2 0 0; "),  # by 1 itself
    accepted("hermite-one", "hermite", at("-1/2", MERRIEN, "m"), "", "--lower 1", HERMITE + "block 0 norm 4; "),
    accepted("hermite-one-refuted", "hermite", at("1", MERRIEN, "m"), "", "--upper 1", HERMITE + "product 0 4 0 1; "),
    accepted_levels("vectors-levels", "vectors", CORNERS, "w=1/100..49/100", "--lower 0", LINES + "to 49/100; block 0 norm 1; "),
    accepted_levels("vectors-levels-holder", "vectors", CORNERS, "w=1/5..3/10", "--lower 1/4", LINES + "to 3/10; block 0 norm 1; "),
    accepted_levels("hermite-levels", "hermite", MERRIEN, "m=-1..0", "--lower 1", HERMITE + "to 0; " + GRAPH),
    accepted_levels("vectors-follow", "vectors", CORNERS, "w=1/100..49/100", "--lower 0", LINES + "to 49/100; block 0 norm 1; ", "0..1", WAY),
]

CHANGED = []


def corners(name, reason, *edits, claim=None):
    return name, "vectors-by-hand", claim, reason, list(edits)


def hermite(name, reason, *edits, claim=None):
    return name, "hermite-merrien", claim, reason, list(edits)


NO_INTERPOLATION = MERRIEN.replace("[[1,0],[0,1/2]]", "[[1,0],[0,m]]")
AT_TWO = MERRIEN.replace("[[1/2,-1/2+1/2*m],[1/8,1/4*m]]]", "[[1/2,-1/2+1/2*m],[1/8,1/4*m]],[[0,0],[0,1-1*m]]]")
UNKEPT = CORNERS.replace("[[1-w,0],[0,0]]", "[[2-w,0],[0,0]]")
LEADS_OUT = CORNERS.replace("[0,1/2]],[[1-w,0],[0,0]]", "[0,1/2]],[[1-w,0],[1,0]]")

EDITED = [
    *((f"vectors-one-{name}", "vectors-one", of("vectors", at("1/4", CORNERS), "", end), reason, edits) for name, end, reason, edits in (
        ("above-order", "--lower 1", "the end is not below the number of sum rules", []), ("negative", "--lower -1/2", "must be positive", []),
        ("converges", "--upper 0", "expected 'product'", []), ("to", "--lower 0", "expected 'block 0'", [("block 0", "to 1; block 0")]),
        ("exact", "--lower 0", "exact numbers are those of one mask or family", [("sum-rules", "exact 1-log|[-1,1]@1,0,1/2|^1/1; root 1 0 0 1 1; sum-rules")]),
        ("reduced", "--lower 0", "expected 'sum-rules'", [("sum-rules", "reduced [1] [1]; sum-rules")]),
        ("cycle", "--lower 0", "line 13", [("block 0 norm 1", "block 0 norm 1; logarithm 0")]),
        ("columns", "--lower 0", "line 12", [("block 0 norm 1", "block 0 single 1 64")]))),
    ("vectors-one-range", "vectors-one", of("vectors", at("1/4", CORNERS), "w=0..1", "--lower 0"), "expected 'vectors ", []),
    ("vectors-one-edge", "vectors-one", of("vectors", at("1/2", CORNERS), "", "--lower 0"), "the bound does not prove the claim",
     [(at("1/4", CORNERS), at("1/2", CORNERS))]),
    ("vectors-one-other-column", "vectors-one", of("vectors", at("-1/2", CORNERS), "", "--lower 0"), "the bound does not prove the claim",
     [(at("1/4", CORNERS), at("-1/2", CORNERS))]),
    ("vectors-one-little", "vectors-one-diverges", of("vectors", at("3/4", CORNERS), "", "--upper 0"), "does not prove the claim",
     [(at("1", CORNERS), at("3/4", CORNERS)), ("product 0 -2 0 0", "product 0 3/2 0 0")]),
    ("hermite-one-2", "hermite-one", of("hermite", at("-1/2", MERRIEN, "m"), "", "--lower 2"), "the bound does not prove the claim", []),
    ("hermite-one-edge", "hermite-one", of("hermite", at("-3", MERRIEN, "m"), "", "--lower 1"), "the bound does not prove the claim",
     [(at("-1/2", MERRIEN, "m"), at("-3", MERRIEN, "m"))]),
    ("hermite-one-refuted-0", "hermite-one-refuted", of("hermite", at("1", MERRIEN, "m"), "", "--upper 0"), "fewer derivatives than its data are", []),
    ("hermite-one-no-interpolation", "hermite-one-refuted", of("hermite", at("1", MERRIEN, "m").replace("[0,1/2]", "[0,1/4]"), "", "--upper 1"),
     "does not interpolate", [("[0,1/2]", "[0,1/4]")]),
    corners("vectors-lower", "the bound does not prove the claim", claim=of("vectors", CORNERS, "w=1/100..49/100", "--lower 1/20")),
    corners("vectors-edge", "the bound does not prove the claim", ("w=1/100..49/100", "w=0..49/100"),
            claim=of("vectors", CORNERS, "w=0..49/100", "--lower 0")),
    corners("vectors-above-order", "the end is not below the number of sum rules", claim=of("vectors", CORNERS, "w=1/100..49/100", "--lower 1")),
    corners("vectors-negative", "must be positive", claim=of("vectors", CORNERS, "w=1/100..49/100", "--lower -1")),
    corners("vectors-upper", "expected 'product'", claim=of("vectors", CORNERS, "w=1/100..49/100", "--upper 0")),
    corners("vectors-other-range", "expected 'vectors ", claim=of("vectors", CORNERS, "w=1/100..48/100", "--lower 0")),
    corners("vectors-as-hermite", "expected 'hermite ", claim=of("hermite", CORNERS, "w=1/100..49/100", "--lower 1")),
    corners("vectors-short", "expected 'to'", ("to 49/100", "to 48/100")),
    corners("vectors-long", "an interval ends outside of the rest of the range", ("to 49/100", "to 1/2")),
    corners("vectors-order-0", "number outside 1..64", ("sum-rules 1", "sum-rules 0")),
    corners("vectors-order-65", "number outside 1..64", ("sum-rules 1", "sum-rules 65")),
    corners("vectors-full", "wrong number of fields", ("sum-rules 1", "sum-rules 1 full")),
    corners("vectors-no-data", "expected 'data'", ("data 1 0; ", "")),
    corners("vectors-data-zero", "the constant data are 0", ("data 1 0", "data 0 0")),
    corners("vectors-data-other", "does not keep the constant data", ("data 1 0", "data 0 1")),
    corners("vectors-data-more", "does not keep the constant data", ("data 1 0", "data 1 1")),
    corners("vectors-data-fields", "wrong number of fields", ("data 1 0", "data 1")),
    corners("vectors-sums", "does not keep the constant data", (CORNERS, UNKEPT), claim=of("vectors", UNKEPT, "w=1/100..49/100", "--lower 0")),
    corners("vectors-linear-data", "does not keep the data", ("sum-rules 1; data 1 0", "sum-rules 2; data 1 0; data 0 0")),
    corners("vectors-digits", "two digits of one class", ("digits 0 1", "digits 0 2")),
    corners("vectors-reading-none", "expected 'reading'", ("reading 0.1:1; ", "")),
    corners("vectors-reading-other", "has not one number of its component", ("reading 0.1:1", "reading 0.0:1 1.0:-1")),
    corners("vectors-reading-two", "has not one number of its component", ("reading 0.1:1", "reading 0.1:1 1.1:-1")),
    corners("vectors-reading-shows", "a line 'reading' does not annihilate the data", ("reading 0.1:1", "reading 0.0:1 0.1:1")),
    corners("vectors-vector-shows", "a vector does not annihilate the data", ("vector 0.0:1 1.0:-1", "vector 0.0:1 1.0:-2")),
    corners("vectors-small-space", "a transition operator leads out of the space", ("space 3; ", "space 2; "), ("; vector 2.0:1 1.0:-1", "")),
    corners("vectors-not-led", "differences are not led into the space", ("space 3; vector 0.1:1; ", "space 2; ")),
    corners("vectors-leads-out", "a transition operator leads out of the space", (CORNERS, LEADS_OUT),
            claim=of("vectors", LEADS_OUT, "w=1/100..49/100", "--lower 0")),
    corners("vectors-stability", "expected 'digits'", ("digits", "stability; digits")),
    ("vectors-three-readings", "vectors-three", None, "has a component too many", [("reading 0.1:1", "reading 0.1:1 0.2:1")]),
    ("vectors-three-order", "vectors-three", None, "has a component too many",
     [("reading 0.1:1; reading 0.2:1", "reading 0.2:1; reading 0.1:1")]),
    ("vectors-diverges-elsewhere", "vectors-diverges", of("vectors", CORNERS, "w=9/10..3/2", "--upper 0"), "characteristic polynomial",
     [("w=11/10..3/2", "w=9/10..3/2")]),
    ("vectors-diverges-little", "vectors-diverges", None, "does not prove the claim", [("product 0 -2 0 0", "product 0 -3/2 0 0")]),
    ("vectors-denominator", "vectors-quotient", of("vectors", QUOTIENT, "w=-2..99/100", "--lower 0"), "changes its sign", [("w=1/100..99/100", "w=-2..99/100")]),
    ("vectors-levels-lower", "vectors-levels", levels("vectors", CORNERS, "w=1/100..49/100", "--lower 1/20"), "the bound does not prove the claim", []),
    ("vectors-levels-of-range", "vectors-by-hand", levels("vectors", CORNERS, "w=1/100..49/100", "--lower 0"), "levels'", []),
    ("vectors-range-of-levels", "vectors-levels", of("vectors", CORNERS, "w=1/100..49/100", "--lower 0"), "fields", []),
    ("vectors-levels-pieces", "vectors-two-intervals", levels("vectors", CORNERS, "w=1/10..2/5", "--lower 0"),
     "a claim about sequences of values has one interval", [("w=1/10..2/5", "w=1/10..2/5 levels")]),
    ("vectors-levels-as-follow", "vectors-levels", levels("vectors", CORNERS, "w=1/100..49/100", "--lower 0", f"--recurrence {HALF} --start 0..1 --from 2 "),
     "expected 'vectors ", []),
    ("vectors-follow-as-levels", "vectors-follow", levels("vectors", CORNERS, "w=1/100..49/100", "--lower 0"), "fields", []),
    ("vectors-follow-no-way", "vectors-follow", None, "the values do not come into the range", [(WAY, "")]),
    ("hermite-levels-2", "hermite-levels", levels("hermite", MERRIEN, "m=-1..0", "--lower 2"), "the bound does not prove the claim", []),
    hermite("hermite-2", "the bound does not prove the claim", claim=of("hermite", MERRIEN, "m=-1..0", "--lower 2")),
    hermite("hermite-3", "the end is not below the number of sum rules", claim=of("hermite", MERRIEN, "m=-1..0", "--lower 3")),
    hermite("hermite-0", "fewer derivatives than its data are", claim=of("hermite", MERRIEN, "m=-1..0", "--lower 0")),
    hermite("hermite-with-data", "expected 'digits'", ("digits 0 1", "data 1 0; digits 0 1")),
    hermite("hermite-no-hermite", "expected 'product'", claim=of("hermite", MERRIEN, "m=-1..0", "--upper 1")),
    hermite("hermite-reading", "a line 'reading' does not annihilate the data", ("reading 0.0:-3 0.1:2", "reading 0.0:-3 0.1:1")),
    hermite("hermite-slopes", "the scheme does not keep the data", (MERRIEN, NO_INTERPOLATION), claim=of("hermite", NO_INTERPOLATION, "m=-1..0", "--lower 1")),
    ("hermite-refuted-3", "hermite-refuted", of("hermite", MERRIEN, "m=2..3", "--upper 3"), "the end is not below the number of sum rules", []),
    ("hermite-refuted-0", "hermite-refuted", of("hermite", MERRIEN, "m=2..3", "--upper 0"), "fewer derivatives than its data are", []),
    ("hermite-refuted-little", "hermite-refuted", of("hermite", MERRIEN, "m=9/10..19/20", "--upper 1"), "does not prove the claim",
     [("m=2..3", "m=9/10..19/20"), ("to 3", "to 19/20"), ("product 0 0 642119/131072 0", "product 0 0 15/4 0")]),
    ("hermite-no-interpolation", "hermite-refuted", of("hermite", NO_INTERPOLATION, "m=2..3", "--upper 1"), "does not interpolate",
     [(MERRIEN, NO_INTERPOLATION)]),
    ("hermite-at-two", "hermite-refuted", of("hermite", AT_TWO, "m=2..3", "--upper 1"), "does not interpolate", [(MERRIEN, AT_TWO)]),
    ("hermite-no-origin", "hermite-refuted", of("hermite", MERRIEN.replace("@-1", "@-3"), "m=2..3", "--upper 1"), "does not interpolate",
     [("@-1", "@-3")]),
    ("hermite-far-origin", "hermite-refuted", of("hermite", MERRIEN.replace("@-1", "@3"), "m=2..3", "--upper 1"), "does not interpolate",
     [("@-1", "@3")]),
]
REJECTED = [(name, base, options, reason, [tuple(part.replace("; ", "\n") for part in edit) for edit in edits])
            for name, base, options, reason, edits in EDITED]
