"""Convergence of vector schemes in one to three variables (6.11). Spaces are known by hand."""

# bilinear hat functions, and numbers that are halved: SPEC.md, 6.11; C in place of 2 in 2/4
HATS = ("[[[[1,0],[0,0]],[[2,0],[0,0]],[[1,0],[0,0]]],[[[2,0],[0,0]],[[4,0],[0,C]],[[2,0],[0,0]]],"
        "[[[1,0],[0,0]],[[2,0],[0,0]],[[1,0],[0,0]]]]/4@-1,-1")
HALVED, KEPT, OF_ROOT, FAR = (HATS.replace("C", number) for number in ("2", "4", "sqrt(2)", "4*sqrt(2)"))
PLANE, LINE, QUINCUNX = "[2,0;0,2]", "[2]", "[1,1;1,-1]"
DIGITS = "digits 0,0 1,0 0,1 1,1; "
VECTORS = ("vector -1,-1.0:1 1,0.0:-1; vector -1,0.0:1 1,0.0:-1; vector -1,1.0:1 1,0.0:-1; vector 0,-1.0:1 1,0.0:-1; "
           "vector 0,0.0:1 1,0.0:-1; vector 0,0.1:1; vector 0,1.0:1 1,0.0:-1; vector 1,-1.0:1 1,0.0:-1; ")
SPACE, FIXED, NORM = "space 8; " + VECTORS, "fixed 1 0; ", "block 0 norm 4; end"
NOTHING = "[[[[1,0],[0,1]]]]"  # the class of (1,0) has the sum 0
TWO = "[[[2,0],[0,1]],[[4,0],[0,3]],[[2,0],[0,3]],[[0,0],[0,1]]]/4@-1"  # a hat function beside a quadratic B-spline
OF_TWO = ("digits 0 1; fixed 1 0; fixed 0 1; space 4; vector -1.0:1 1.0:-1; vector -1.1:1 1.1:-1; vector 0.0:1 1.0:-1; "
          "vector 0.1:1 1.1:-1; ")
FALSE_SUM = "[[[1,0],[0,0]],[[1,0],[0,0]]]"  # characteristic functions: no convergence, component 0 keeps its steps
OF_STEPS = "digits 0 1; fixed 1 0; space 2; vector 0.0:1 1.0:-1; vector 0.1:1; "
MATRICES = []
CHANGED = []


def claim(mask, dilation, end):
    return f"--vectors {mask} --dilation {dilation} {end} 0"


def case(name, mask, dilation, lines, end="--lower"):
    return name, claim(mask, dilation, end), f"vectors {mask} {dilation}; bounds {'0 -' if end == '--lower' else '- 0'}; {lines}"


def diverges(name, mask, dilation, lines):
    return case(name, mask, dilation, lines, "--upper")


ROOT_KEPT = "fixed 1 0 0 0; "
ACCEPTED = [
    case("convergence-plane", HALVED, PLANE, DIGITS + FIXED + SPACE + NORM),
    case("convergence-fixed-multiple", HALVED, PLANE, DIGITS + "fixed -2/3 0; " + SPACE + NORM),
    case("convergence-digits", HALVED, PLANE, "digits 1,1 0,1 1,0 0,0; " + FIXED + SPACE + NORM),
    case("convergence-larger", HALVED, PLANE, DIGITS + FIXED + SPACE.replace("space 8", "space 10") +
         "vector 1,1.1:1; vector 2,2.1:1; " + NORM),
    case("convergence-line", TWO, LINE, OF_TWO + "block 0 norm 8; end"),
    case("convergence-constants-mixed", TWO, LINE, OF_TWO.replace("fixed 0 1", "fixed 1/2 1") + "block 0 norm 8; end"),
    diverges("convergence-not", KEPT, PLANE, DIGITS + FIXED + SPACE + "product 0 1 0 0; end"),
    diverges("convergence-steps", FALSE_SUM, LINE, OF_STEPS + "product 0 1 0 0; end"),
    diverges("convergence-nothing", NOTHING, PLANE, DIGITS + "end"),
    diverges("convergence-nothing-turned", NOTHING, QUINCUNX, "digits 0,0 0,1; end"),
    diverges("convergence-zero", "[[[[[0,0],[0,0]]]]]", "[2,0,0;0,2,0;0,0,2]",
             "digits " + " ".join(f"{x},{y},{z}" for x in (0, 1) for y in (0, 1) for z in (0, 1)) + "; end"),
    case("field-convergence", OF_ROOT, PLANE, DIGITS + ROOT_KEPT + SPACE + NORM),
    case("field-convergence-multiple", OF_ROOT, PLANE, DIGITS + "fixed 3 0 -1/2 0; " + SPACE + NORM),
    diverges("field-convergence-not", FAR, PLANE, DIGITS + ROOT_KEPT + SPACE + "product 0 1414/1000 0 0; end"),
    diverges("field-convergence-nothing", NOTHING.replace("0,1", "0,sqrt(3)"), PLANE, DIGITS + "end"),
]

LOWER_NOTHING = claim(NOTHING, PLANE, "--lower")
EDITED = [
    ("convergence-not-kept", "convergence-plane", None, "the scheme does not keep a line 'fixed'", [("fixed 1 0", "fixed 0 1")]),
    ("convergence-dependent", "convergence-plane", None, "the lines 'fixed' are not independent", [("fixed 1 0", "fixed 1 0; fixed 2 0")]),
    ("convergence-fixed-zero", "convergence-plane", None, "the lines 'fixed' are not independent", [("fixed 1 0", "fixed 0 0")]),
    ("convergence-fixed-many", "convergence-plane", None, "more lines 'fixed' than components", [("fixed 1 0", "fixed 1 0; fixed 1 0; fixed 1 0")]),
    ("convergence-fixed-fields", "convergence-plane", None, "wrong number of fields", [("fixed 1 0", "fixed 1")]),
    ("convergence-fixed-number", "convergence-plane", None, "", [("fixed 1 0", "fixed 1 0/0")]),
    ("convergence-one-of-two", "convergence-line", None, "the scheme may keep more constant data", [("fixed 0 1; ", "")]),
    ("convergence-none-given", "convergence-plane", None, "the scheme may keep more constant data", [("fixed 1 0; ", "")]),
    ("convergence-none-given-not", "convergence-not", None, "the scheme may keep more constant data", [("fixed 1 0; ", "")]),
    ("convergence-of-nothing", "convergence-nothing", LOWER_NOTHING, "a scheme that keeps no constant data does not converge", []),
    ("convergence-nothing-more", "convergence-nothing", None, "expected 'end'", [("1,1; end", "1,1; space 1; vector 0,0.0:1; end")]),
    ("convergence-vector", "convergence-plane", None, "a vector does not annihilate the data", [("0,0.1:1", "0,0.1:1 5,5.0:1")]),
    ("convergence-smaller", "convergence-plane", None, "a transition operator leads out of the space", [("space 8", "space 7"), ("; vector 1,-1.0:1 1,0.0:-1", "")]),
    ("convergence-not-led", "convergence-plane", None, "differences are not led into the space",
     [("space 8; " + VECTORS, "space 1; vector 0,0.1:1; ")]),
    ("convergence-without-component", "convergence-plane", None, "differences are not led into the space", [("space 8", "space 7"), ("vector 0,0.1:1; ", "")]),
    ("convergence-weak", "convergence-plane", None, "the bound does not prove the claim", [("norm 4", "norm 1")]),
    ("convergence-equal", "convergence-not", claim(KEPT, PLANE, "--lower"), "the bound does not prove the claim", [("product 0 1 0 0", "block 0 norm 4")]),
    ("convergence-no-section", "convergence-not", claim(KEPT, PLANE, "--lower"), "expected 'block 0'", []),
    ("convergence-product-small", "convergence-not", claim(HALVED, PLANE, "--upper"), "", [(KEPT, HALVED), ("product 0 1 0 0", "product 0 1/2 0 0")]),
    ("convergence-product-false", "convergence-not", claim(HALVED, PLANE, "--upper"), "prove", [(KEPT, HALVED)]),
    ("convergence-no-product", "convergence-not", None, "expected 'product'", [("product 0 1 0 0; ", "")]),
    ("convergence-anisotropic", "convergence-plane", claim(HALVED, "[2,0;0,3]", "--lower"), "not isotropic", [(PLANE, "[2,0;0,3]")]),
    ("convergence-shrinking", "convergence-nothing", claim(NOTHING, "[0,1;1,0]", "--upper"), "", [(PLANE, "[0,1;1,0]"), ("0,0 1,0 0,1 1,1", "0,0")]),
    ("convergence-digits-twice", "convergence-plane", None, "two digits of one class", [("0,1 1,1", "0,1 2,1")]),
    ("convergence-other-dilation", "convergence-plane", claim(HALVED, QUINCUNX, "--lower"), "expected 'vectors ", []),
    ("convergence-exact", "convergence-plane", None, "", [("bounds 0 -", "bounds 0 -; exact 0-log|[-1,2]@1/2,0,1/100|^1/1; root 1/2 0 0 1/2 1/2")]),
    ("field-convergence-kept", "field-convergence", None, "the scheme does not keep a line 'fixed'", [("fixed 1 0 0 0", "fixed 1 0 0 1")]),
    ("field-convergence-fields", "field-convergence", None, "wrong number of fields", [("fixed 1 0 0 0", "fixed 1 0")]),
    ("field-convergence-dependent", "field-convergence", None, "the lines 'fixed' are not independent", [("fixed 1 0 0 0", "fixed 1 0 0 0; fixed 0 0 1 0")]),
    ("field-convergence-more", "field-convergence", None, "the scheme may keep more constant data", [("fixed 1 0 0 0; ", "")]),
    ("field-convergence-vector", "field-convergence", None, "a vector does not annihilate the data", [("0,0.1:1", "0,0.1:1 5,5.2:1")]),
    ("field-convergence-weak", "field-convergence", None, "the bound does not prove the claim", [("norm 4", "norm 1")]),
    ("field-convergence-product", "field-convergence-not", claim(OF_ROOT, PLANE, "--upper"), "prove", [(FAR, OF_ROOT), ("1414/1000", "3535/10000")]),
]
REJECTED = [(name, base, options, reason, [tuple(part.replace("; ", "\n") for part in edit) for edit in edits])
            for name, base, options, reason, edits in EDITED]


def usage():
    plane = f"--vectors {NOTHING} --dilation {PLANE}"
    return [(64, f"{words} golden.cert") for words in (
        f"{plane}", f"{plane} --lower 1/2", f"{plane} --upper 1", f"{plane} --lower 0 --upper 0", f"{plane} --arity 2 --lower 0",
        f"{plane} --lower 0 --for w=0..1", f"{plane} --lower 0 --levels w=0..1", f"{plane} --lower 0 --component 0", f"{plane} --lower 0 --integral 1,0",
        f"{plane} --exact 0-log|[-1,2]@1/2,0,1/4|^1/1", f"--hermite {NOTHING} --dilation {PLANE} --lower 1", f"--vectors {NOTHING} --dilation [2] --lower 0",
        f"--vectors {NOTHING} --dilation [2,0;0] --lower 0", f"--vectors [[1,0],[0,1]] --dilation {PLANE} --lower 0",
        f"--vectors {NOTHING.replace('0,1', '0,sqrt(4)')} --dilation {PLANE} --lower 0")]
