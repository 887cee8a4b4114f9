#!/usr/bin/env python3
"""Makes the corpus of certificates that must be rejected, by edits of the accepted ones.

Usage: make_rejects.py ACCEPT_DIRECTORY OUTPUT_DIRECTORY
Each line of OUTPUT_DIRECTORY/claims.txt: name, options of the claim, '|', a part of the expected reason.
"""
import re
import sys
from fractions import Fraction as Q
from pathlib import Path

import attains_cases
import convergence_cases
import cycle_cases
import edge_cases
import field_cases
import frequency_cases
import graph_cases
import l1_cases
import level_cases
import make_certificates
import make_surfaces
import not_c1_cases
import single_cases
import stability_cases
import subradius_cases
import subradius_exact_cases
import variant_cases
import vector_cases
import vector_list_cases
import vector_range_cases
import vertex_cases
import vertex_fit_cases
import vertex_variant_cases
import vertices_cases

accept, out = map(Path, sys.argv[1:3])
out.mkdir(parents=True, exist_ok=True)
claims = dict(line.split(" ", 1) for line in (accept / "claims.txt").read_text().splitlines())
for matrices in accept.glob("*.mat"):
    (out / matrices.name).write_text(matrices.read_text())
index = []


def option(arguments, name, value):
    """The options with one value replaced; None removes it."""
    arguments = re.sub(rf" *--{name} \S+", "", arguments)
    return (arguments if value is None else f"{arguments} --{name} {value}").strip()


def reject(name, base, reason, edit=lambda lines: lines, arguments=None):
    lines = (accept / f"{base}.cert").read_text().splitlines()
    lines = edit(lines)
    (out / f"{name}.cert").write_text(lines if isinstance(lines, str) else "\n".join(lines) + "\n")
    index.append(f"{name} {arguments or claims[base]} | {reason}")


def replace(pattern, by, count=1):
    return lambda lines: re.sub(pattern, by, "\n".join(lines), count=count, flags=re.M).split("\n")


def drop(pattern):
    return lambda lines: [line for line in lines if not re.match(pattern, line)]


def mask_case(name, mask, m, lower, upper, reason, arity=2, more=()):
    """A certificate from nothing for another mask, with a norm as its upper bound."""
    lines = ["subcert-certificate 3", f"exponent {mask} {arity}", "bounds - -", f"sum-rules {m}", *more, "block 0 norm 6", "end"]
    (out / f"{name}.cert").write_text("\n".join(lines) + "\n")
    upper = f" --upper {upper}" if upper else ""
    index.append(f"{name} --mask {mask} --arity {arity} --lower {lower}{upper} | {reason}")


# the file as such
reject("empty-file", "golden", "expected 'subcert-certificate 3', line 1", lambda lines: "")
reject("version", "golden", "expected 'subcert-certificate 3', line 1", replace("certificate 3", "certificate 2"))
reject("truncated", "golden", "expected 'image 3 0'", lambda lines: lines[:-3])
reject("no-end", "golden", "expected 'end'", lambda lines: lines[:-1])
reject("no-line-feed", "golden", "last line without line feed", lambda lines: "\n".join(lines))
reject("trailing-line", "golden", "text after 'end'", lambda lines: lines + ["end"])
reject("trailing-empty-line", "golden", "text after 'end'", lambda lines: lines + [""])
reject("unknown-line", "golden", "expected 'block 0'", replace("^block", "comment hello\nblock"))
reject("duplicate-product", "golden", "expected 'block 0'", lambda lines: lines[:4] + lines[3:])
reject("duplicate-section", "golden", "expected 'end'", lambda lines: lines[:-1] + lines[4:])
reject("double-space", "golden", "expected 'radius 2 2', line 2", replace("radius 2 2", "radius 2  2"))
reject("carriage-return", "golden", "expected 'radius 2 2'", replace("radius 2 2", "radius 2 2\r"))
reject("non-ascii", "golden", "expected 'radius 2 2'", replace("radius", "radi\u00fcs"))
reject("huge-number", "golden", "number too long", replace("^vertex \\S+", "vertex " + "9" * 6000))
reject("huge-count", "golden", "expected 'vertex'", replace("polytope \\d+", "polytope 99999999"))
reject("overflowing-count", "golden", "number outside", replace("polytope \\d+", "polytope 18446744073709551617"))
reject("zero-denominator", "golden", "a denominator must be positive", replace("^product 0 \\S+", "product 0 1/0"))
reject("leading-zero", "golden", "not an integer", replace("^vertex ", "vertex 0"))
# the claim
reject("too-high", "golden", "does not prove the claim", arguments=option(claims["golden"], "lower", "1619/1000"))
reject("too-low", "golden", "does not prove the claim", arguments=option(claims["golden"], "upper", "1618/1000"))
reject("bspline-too-high", "bspline-3", "does not prove the claim",
       arguments=option(claims["bspline-3"], "lower", "30000000000000000000001/10000000000000000000000"))
reject("bspline-too-low", "bspline-3", "does not prove the claim",
       arguments=option(claims["bspline-3"], "upper", "29999999999999999999999/10000000000000000000000"))
reject("other-mask", "bspline-3", "expected 'exponent ", arguments=claims["bspline-2"])
reject("other-kind", "golden", "expected 'exponent ", arguments=claims["bspline-2"])
reject("other-family", "golden", "expected 'radius 2 3'", arguments=option(claims["golden"], "matrices", "blocks.mat"))
reject("other-matrices", "golden", "no positive spectral radius", arguments=option(claims["golden"], "matrices", "rotation.mat"))
reject("other-shift", "four-point", "expected 'exponent ",
       arguments=claims["four-point"].replace("@-3", "@-2"))
reject("negative-lower", "bspline-2", "must be positive", arguments=option(claims["bspline-2"], "lower", "-1"))
# exponent
reject("too-many-sum-rules", "four-point", "no sum rules of this order", replace("sum-rules 4", "sum-rules 5"))
reject("no-sum-rules", "four-point", "number outside 1..500", replace("sum-rules 4", "sum-rules 0"))
reject("no-stability", "four-point", "expected 'stability'", drop("stability"))
reject("stability-field", "four-point", "wrong number of fields", replace("stability", "stability 1"))
reject("no-product", "four-point", "expected 'product'", drop("product"))
reject("no-section", "four-point", "expected 'block 0'", lambda lines: lines[:6] + ["end"])
mask_case("wrong-sum", "[1,2,1]", 2, "1/2", None, "do not sum to the arity")
mask_case("diverging", "[-1,3,3,-1]/2", 1, "1/10", None, "does not prove the claim")
# hat(x/3)/3: exponent 1, shifts not stable by the cyclic zeros of order 3 (-omega is a zero of 1 - z + z^2)
mask_case("cyclic-zeros", "[1,0,0,2,0,0,1]/2", 2, "1/1000", "2", "of unity of order 3 is 0", more=["stability"])
# symmetric zeros i, -i: (1+z)(1+z^2)/2
mask_case("symmetric-zeros", "[1,1,1,1]/2", 1, "1/1000", "2", "common zero", more=["stability"])
# ternary, hat(x/2)/2: zeros of order 6 (Phi_6) and 2 by (1 + z^2 + z^4)^2
mask_case("ternary-cyclic-zeros", "[1,0,2,0,3,0,2,0,1]/3", 2, "1/1000", "2", "of unity of order 2 is 0", arity=3, more=["stability"])
# Haar with M = 1: the radius is 2 and the exponent bound 0
mask_case("haar", "[1,1]", 1, "1/1000", None, "does not prove the claim")
# a cubic spline with too few factors: the radius is 1, nothing can be said from above
reject("saturated", "bspline-3", "no exponent below", lambda lines: [
    *lines[:3], "sum-rules 1", "stability", "product 0 1 0 0", "block 0 norm 1", "end"],
    arguments="--mask [1/8,1/2,3/4,1/2,1/8]@-3 --arity 2 --lower 9/10 --upper 11/10")
# one coefficient: the data are only moved about
mask_case("one-coefficient", "[2]", 1, "1/1000", None, "no sum rules of this order")
# arity 4, hat(x/3)/3: not stable by the cyclic zeros of order 3, times i
mask_case("quaternary-cyclic-zeros", "[1,0,0,2,0,0,3,0,0,4,0,0,3,0,0,2,0,0,1]/4", 2, "1/1000", "2", "of unity of order 3 is 0", arity=4,
          more=["stability"])
# arity 4, a step of width 5: not stable by the cyclic zeros of order 5, times -1 and i
mask_case("quaternary-box", "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]", 1, "1/1000", "2", "of unity of order 5 is 0", arity=4,
          more=["stability"])
reject("beyond-sum-rules", "four-point", "does not prove the claim", arguments=option(claims["four-point"], "lower", "5"))
reject("crossed-bounds", "bspline-3", "does not prove the claim",
       arguments=option(option(claims["bspline-3"], "lower", "31/10"), "upper", "29/10"))
# inverse
reject("inverse-off", "golden-inverse", "none of the product", replace("^column 0 (\\d)", r"column 0 1\1"))
reject("inverse-sign", "golden-inverse", "none of the product", replace("^column 1 ", "column 1 -"))
reject("inverse-bits", "golden-inverse", "number outside 0..4096", replace("^inverse 160", "inverse 4097"))
reject("inverse-coarse", "golden-inverse", "none of the product", replace("^inverse 160", "inverse 159"))
reject("inverse-short", "golden-inverse", "wrong number of fields", replace("^(column 1 \\S+) .*", r"\1"))
reject("inverse-half", "rotation-inverse", "wrong number of fields", replace("^(column 1 \\S+ \\S+) .*", r"\1"))
reject("inverse-missing", "golden-inverse", "expected 'column 1'", drop("column 1"))
reject("inverse-further", "golden-inverse", "expected 'block 0'", replace("^(column 1 .*)", "\\1\ncolumn 2 0 0"))
reject("inverse-of-real", "rotation-inverse", "wrong number of fields", replace("^product 0 (\\S+) 4/5", r"product 0 \1 0"))
reject("inverse-in-range", "corner-not-smooth", "expected 'end'", replace("^(product .*)", "\\1\ninverse 4\ncolumn 0 1"))
reject("inverse-rounded", "rounded-four-point-inverse", "none of the product", replace("within=1/1000000000", "within=1/1000000"),
       option(claims["rounded-four-point-inverse"], "within", "1/1000000,4"))
pair = [[Q(2), Q(1)], [Q(1), Q(1)]]  # [1, 1; 0, 1] [1, 0; 1, 1], eigenvalues (3 +- sqrt 5)/2
for name, point, reason in (("flat", Q(3, 2), "no eigenvalue near"), ("far", Q(5, 2), "does not prove the claim"),
                            ("small", Q(1, 10), "no positive spectral radius")):
    text = "\n".join((f"product 0 {point} 0 0 1", *make_certificates.inverse_lines(pair, point)))
    reject(f"inverse-{name}", "golden", reason, replace("^product .*", text))

# product
reject("product-far", "golden", "does not prove the claim", replace("^product 0 \\S+", "product 0 1" + "0" * 1000))
reject("product-turned", "golden", "does not prove the claim", replace("^(product 0 \\S+) 0", r"\1 1/2"))
reject("product-index", "golden", "number outside 0..1", replace("^(product .*) 1$", r"\1 2"))
reject("product-block", "golden", "number outside 0..0", replace("^product 0", "product 1"))
reject("product-empty", "golden", "wrong number of fields", replace("^(product 0 \\S+ \\S+) .*", r"\1"))
reject("product-eigenvalue", "golden", "does not prove the claim", replace("^product 0 \\S+", "product 0 5/2"))
reject("product-flat", "golden", "derivative 0", replace("^product 0 \\S+", "product 0 3/2"))
reject("product-long", "blocks", "no positive spectral radius", replace("^(product .*) 1$", r"\1" + " 1" * 4000),
       arguments=claims["blocks"])
# norm
reject("norm-level", "four-point-norm", "number outside 1..64", replace("norm 1", "norm 0"))
reject("norm-work", "four-point-norm", "more work", replace("norm 1", "norm 60"))
reject("norm-weak", "golden", "does not prove the claim", lambda lines: lines[:4] + ["block 0 norm 8", "end"])
# polytope
reject("no-vertices", "golden", "number outside", lambda lines: lines[:4] + ["block 0 polytope 0 64 64", "end"])
reject("no-vertices-units", "golden", "number outside",
       lambda lines: lines[:4] + ["block 0 polytope 0 64 64", "unit 0", "unit 1", "end"])
reject("residual-one", "golden", "do not span", lambda lines: lines[:4] + [
    "block 0 polytope 2 0 1", "vertex 1 0", "vertex 0 1", "unit 0 0:2", "unit 1 0:1 1:1", "image 0 0 0:1", "image 0 1 0:1",
    "image 1 0 0:1", "image 1 1 0:1", "end"])
reject("small-bits", "golden", "does not prove the claim", replace(" 64 64$", " 64 65"))
reject("zero-vertex", "golden", "do not span", lambda lines: lines[:4] + [
    "block 0 polytope 1 64 64", "vertex 0 0", "unit 0", "unit 1", "image 0 0", "image 0 1", "end"])
reject("flat-vertices", "golden", "do not span", lambda lines: lines[:4] + [
    "block 0 polytope 1 0 0", "vertex 1 0", "unit 0 0:1", "unit 1", "image 0 0 0:1", "image 0 1 0:1", "end"])
reject("vertex-short", "golden", "wrong number of fields", replace("^(vertex \\S+) .*", r"\1"))
reject("vertex-index", "golden", "number outside", replace(r"^unit 0 \d+:", "unit 0 77:"))
reject("negative-index", "golden", "not an integer", replace(r"^unit 0 \d+:", "unit 0 -1:"))
reject("flip-unannounced", "golden", "unknown generator", replace(r"^unit 0 \d+:", "unit 0 0f:"))
reject("conjugate-unannounced", "golden", "unknown generator", replace(r"^unit 0 \d+:", "unit 0 0c:"))
reject("empty-weight", "golden", "not an integer", replace("^(unit 0 \\d+:)\\S+", r"\1"))
reject("not-symmetric", "rotation", "not symmetric", replace("complex", "complex symmetric"))
reject("not-nonnegative", "rotation", "not non-negative", replace("complex", "nonnegative"))
reject("negative-weight", "golden-nonnegative", "negative weight", replace("^unit 0 0:", "unit 0 0:-"))
reject("negative-vertex", "golden-nonnegative", "negative coordinate", replace("^vertex ", "vertex -"))
reject("nonnegative-as-real", "golden-nonnegative", "do not span", replace(" nonnegative", ""))
reject("nonnegative-complex", "rotation", "unknown polytope property", replace("complex", "complex nonnegative"))
reject("complex-as-real", "rotation", "wrong number of fields", replace(" complex", ""))
reject("real-weight", "rotation", "a term is INDEX:WEIGHT", replace("^(image 0 0 0:\\d+):\\d+$", r"\1"))
reject("imaginary-dropped", "rotation", "does not prove the claim", replace("^(image 0 0 0:\\d+):\\d+$", r"\1:0"))
reject("missing-unit", "golden", "expected 'unit 1'", drop("unit 1"))
reject("missing-image", "golden", "expected 'image 1 0'", drop("image 1 0"))
reject("empty-image", "golden", "does not prove the claim", replace("^(image 1 0) .*", r"\1"))
reject("unknown-property", "golden-transposed", "unknown polytope property", replace("transposed", "transpose"))
reject("untransposed", "golden-transposed", "does not prove the claim", replace(" transposed", ""))
reject("weights-scaled", "golden", "does not prove the claim",
       lambda lines: [re.sub(r":(-?)(\d+)", lambda m: f":{m[1]}{int(m[2]) * 999 // 1000}", line)
                      if line.startswith("image") else line for line in lines])
# groups
reject("group-not-symmetric", "golden-group", "does not permute the matrices", replace("^generator 1 0", "generator 0 1"))
reject("group-infinite", "golden-group", "more than 96 elements", lambda lines: [
    line.replace("group:1", "group:2") if "group" in line else
    line.replace("generator 1 0", "generator 0 1\nmap 3 0\nmap 0 3\ngenerator 1 0") for line in lines])
reject("group-singular", "golden-group", "singular", replace("^map 0 1\nmap 1 0", "map 0 0\nmap 0 0"))
reject("group-unannounced", "golden-group", "expected 'vertex'", replace(" group:1", ""))
reject("group-none", "golden-group", "number outside 1..8", replace(" group:1", " group:0"))
reject("group-letter", "golden-group", "unknown generator", replace("^unit 0 (\\d+):", r"unit 0 \1B:"))
reject("group-letter-below", "golden-group", "unknown generator", replace("^unit 0 (\\d+):", r"unit 0 \1+:"))
reject("group-flip", "golden-group", "unknown generator", replace("^unit 0 (\\d+):", r"unit 0 \1f:"))
reject("group-long-word", "golden-group", "more than 16 generators", replace("^unit 0 (\\d+):", r"unit 0 \1" + "A" * 17 + ":"))
reject("group-word", "golden-group", "does not prove the claim", replace("^(image 0 0 \\d+):", r"\1A:"))
reject("group-number", "golden-group", "number outside 0..1", replace("^generator 1 0", "generator 1 2"))
reject("group-row", "golden-group", "wrong number of fields", replace("^map 0 1", "map 0"))
reject("group-and-symmetric", "golden-group", "goes with neither", replace(" group:1", " group:1 symmetric"))
reject("group-nonnegative", "golden-group", "goes with neither", replace(" group:1", " nonnegative group:1"))
reject("group-unit-missing", "golden-group", "expected 'unit 1'", drop("unit 1"))
# blocks
reject("blocks-sizes", "blocks", "do not sum", replace("^blocks 2 1", "blocks 2 2"))
reject("blocks-not-triangular", "blocks", "not block upper triangular", replace("^blocks 2 1", "blocks 1 2"))
reject("blocks-negative", "blocks", "number outside 1..3", replace("^blocks 2 1", "blocks 4 -1"))
reject("blocks-inverse", "blocks", "not the unit matrix", replace("^inverse \\S+", "inverse 2"))
reject("blocks-singular", "blocks", "not the unit matrix", replace("^basis 1 2 0$", "basis 0 0 0"))
reject("blocks-zero", "blocks", "not the unit matrix",
       lambda lines: [re.sub(r"^(basis|inverse) .*", r"\1 0 0 0", line) for line in lines])
reject("blocks-rows", "blocks", "expected 'basis'", drop("basis 0 1"))
# in a basis that suits the first unit vector the first columns are small; with blocks all columns count
reject("blocks-norm", "four-point", "does not prove the claim", lambda lines: [
    *lines[:4], "blocks 2", "basis 1 1000", "basis 1 -1000", "inverse 1/2 1/2", "inverse 1/2000 -1/2000",
    "block 0 norm 1", "end"], arguments=option(option(claims["four-point"], "upper", None), "lower", "39/10"))
reject("blocks-missing-section", "blocks", "expected 'block 1'", drop("block 1"))
reject("blocks-order", "blocks", "expected 'block 1'", replace("^block 1", "block 0"))

# several variables: the dilation and its digits
def surface(name, base, reason, edit=lambda lines: lines, **options):
    """An edit of an accepted certificate, with other options for the claim."""
    arguments = claims[base]
    for key, value in options.items():
        arguments = option(arguments, key, value)
    reject(name, base, reason, edit, arguments)


def other_dilation(text):
    return lambda lines: [re.sub(r"^(surface \S+) .*", lambda m: f"{m[1]} {text}", line) for line in lines]


for name, base, text in [("anisotropic", "three-direction", "[2,0;0,4]"), ("shear", "three-direction", "[2,1;0,2]"),
                         ("anisotropic-real", "three-direction", "[3,1;1,1]"), ("not-expanding", "hat-by-hand", "[-1]"),
                         ("singular", "three-direction", "[2,2;2,2]"), ("anisotropic-3", "turning-3", "[2,0,0;0,0,2;0,1,0]"),
                         ("anisotropic-complex-3", "turning-3", "[0,0,2;1,0,1;0,1,0]"),
                         ("shear-3", "turning-3", "[2,0,0;0,2,1;0,0,2]"), ("reflected-shear-3", "turning-3", "[2,0,0;0,-2,1;0,0,-2]")]:
    surface(f"surface-{name}", base, "not isotropic and expanding", other_dilation(text), dilation=text)
surface("surface-large-determinant", "three-direction", "too large a determinant", other_dilation("[9,0;0,9]"), dilation="[9,0;0,9]")
surface("surface-digits-class", "three-direction", "two digits of one class", replace("^digits 0,0 0,1", "digits 0,0 2,-4"))
surface("surface-digits-few", "three-direction", "wrong number of fields", replace(" 1,1$", ""))
surface("surface-digits-order", "turning-2", "no exponent below", replace("^digits 0,0 1,0", "digits 1,0 0,0"))
surface("surface-digits-far", "hat-by-hand", "a coordinate is too large", replace("^digits 0 1", "digits 0 9999999999"))
surface("surface-digits-dimension", "three-direction", "another number of coordinates", replace("^digits 0,0", "digits 0"))
# the sum rules
surface("surface-sum-rules", "three-direction", "no sum rules of this order", replace("^sum-rules 2", "sum-rules 3"))
surface("surface-many-sum-rules", "three-direction", "a higher order than the checker allows", replace("^sum-rules 2", "sum-rules 65"))
surface("surface-class-sums", "hat-by-hand", "does not sum to 1", replace("/2@-1", "/3@-1"), surface="[1,2,1]/3@-1")
surface("surface-haar", "hat-by-hand", "no sum rules of this order", replace("\\[1,2,1\\]/2@-1", "[1,1]@0"), surface="[1,1]@0")
surface("surface-first-differences", "hat-by-hand", "proves no exponent below", lambda lines: [
    *lines[:3], "sum-rules 1", "digits 0 1", "space 2", "vector -1:1 1:-1", "vector 0:1 1:-1", "gram 0:4 1:1",
    "product 0 1/2 0 1", "block 0 polytope 2 0 1", "vertex 1 -1", "vertex 0 1", "unit 0 0:2 1:2", "unit 1 1:2",
    "image 0 0 0:1", "image 0 1 0:1", "image 1 0 1:1", "image 1 1 0:1", "end"])
# the space
flat, step = {(0,): 1, (1,): -2, (2,): 1}, {(0,): -1, (2,): 1}  # the smallest window of the biquadratic B-spline is too small
small = make_surfaces.space([{(*p, *q): a * b for p, a in x.items() for q, b in y.items()}
                             for x, y in ((flat, flat), (flat, step), (step, flat))])[0]
quadratic = "[[1,3,3,1],[3,9,9,3],[3,9,9,3],[1,3,3,1]]/16@0,0"
surface("surface-small-space", "three-direction", "not led into the space", lambda lines: [
    lines[0], f"surface {quadratic} [2,0;0,2]", "bounds 3 -", "sum-rules 3", lines[4], *small, "block 0 norm 8", "end"],
    surface=quadratic, lower="299/100", upper=None)
surface("surface-no-polynomials", "hat-by-hand", "does not annihilate", replace("^space 1\n.*", "space 1\nvector 0:1"))
surface("surface-larger-space", "hat-by-hand", "does not annihilate",
        replace("^space 1\n(.*)", r"space 2\n\1\nvector 5:1 6:-1"))
surface("surface-not-invariant", "hat-by-hand", "leads out of the space", replace("^(vector) .*", r"\1 0:1 1:-2 2:1"))
surface("surface-no-vectors", "hat-by-hand", "number outside 1..256", lambda lines: [
    *lines[:5], "space 0", *lines[7:]])
surface("surface-pivot-shared", "tension-surface", "occurs in another", replace("^vector 1:1 4:-4 5:3", "vector 0:1 1:-2 2:1"))
surface("surface-pivot-unequal", "tension-surface", "first coefficients of two vectors differ",
        replace("^vector 1:1 4:-4 5:3", "vector 1:2 4:-8 5:6"))
surface("surface-pivot-negative", "hat-by-hand", "must be positive", replace("^vector .*", "vector -1:-1 0:2 1:-1"))
surface("surface-point-twice", "hat-by-hand", "occurs twice", replace("^vector -1:1 0:-2", "vector -1:1 0:-1 0:-1"))
surface("surface-coefficient-zero", "hat-by-hand", "a coefficient is 0", replace("^vector -1:1", "vector 7:0 -1:1"))
surface("surface-empty-vector", "hat-by-hand", "wrong number of fields", replace("^vector .*", "vector"))
surface("surface-other-mask", "three-direction", "expected 'surface", surface="[[1,2,1],[2,4,2],[1,2,1]]/4@-1,-1")
# the ends
surface("surface-too-high", "loop", "does not prove the claim", lower="30000000000000000000001/10000000000000000000000")
surface("surface-too-low", "loop", "does not prove the claim", upper="29999999999999999999999/10000000000000000000000")
surface("surface-above-sum-rules", "three-direction", "does not prove the claim", lower="5/2")
surface("surface-lower-zero", "three-direction", "must be positive", lower="0")
surface("surface-norm", "turning-2", "does not prove the claim", lambda lines: [
    *[line for line in lines if re.match("(sub|sur|bou|sum|dig|spa|vec)", line)], "block 0 norm 1", "end"], lower="1/2", upper=None)
# stability
surface("surface-no-gram", "hat-by-hand", "expected 'gram'", drop("gram"))
surface("surface-gram-sign", "hat-by-hand", "no positive sum", replace("^gram .*", "gram 0:-4 1:-1"))
surface("surface-gram-other", "hat-by-hand", "not a fixed point", replace("^gram .*", "gram 0:5 1:1"))
surface("surface-gram-twice", "hat-by-hand", "occurs twice", replace("^gram .*", "gram 0:4 1:1 -1:1"))
surface("surface-gram-far", "hat-by-hand", "not a fixed point", replace("^gram .*", "gram 0:4 1:1 1000000:1"))
# the differences of phi
surface("values-sum", "trapezoid-by-hand", "have the sum 0", replace("^values .*", "values 1:1 2:-1"))
surface("values-other", "trapezoid-by-hand", "not fixed", replace("^values .*", "values 1:1 2:2 3:1"))
surface("values-missing", "trapezoid-by-hand", "expected 'values'", drop("values"))
surface("values-scheme", "trapezoid-by-hand", "expected 'space'", replace("^differences", "sum-rules"))
surface("values-gram", "trapezoid-by-hand", "expected 'product'", replace("^(vector .*)", "\\1\ngram 0:1"))
surface("values-of-curves", "four-point", "expected 'sum-rules'", replace("^sum-rules", "differences"))
surface("values-order", "trapezoid-by-hand", "not led into the space", replace("^differences 2", "differences 1"))
surface("values-above-order", "trapezoid-by-hand", "above the order", lower="3", upper=None)
surface("values-larger-space", "trapezoid-by-hand", "do not span the space", replace(
    "^space 1\nvector .*", "space 5\nvector 0:1\nvector 1:1\nvector 2:1\nvector 3:1\nvector 4:1"))
surface("values-smaller-space", "trapezoid-by-hand", "out of the space", replace("^vector .*", "vector 0:1 1:-1"))
surface("values-class-sums", "trapezoid-by-hand", "does not sum to 1", replace("/2@0", "/3@0"), surface="[1,1,0,1,1]/3@0")
# whether the scheme converges: first without a word about it, then with a part that is not one of that scheme, or proves less
HAT_3 = edge_cases.HAT_3
for name, options, lines in (("hat", f"{HAT_3} --lower 1 --upper 1", edge_cases.DIVERGENT),
                             ("exact", f"{HAT_3} --exact 0-log|[-1,2]@1/2,0,1/10|^1/1", edge_cases.DIVERGENT_EXACT),
                             ("2d", f"{edge_cases.HAT_3_2D} --lower 7/50", edge_cases.DIVERGENT_2D)):
    head = ["subcert-certificate 3", *lines.split("; ")]
    for part, more, reason in (("", "end", "expected 'sum-rules'"), ("-converges", edge_cases.NOT_PROVED[name], "the bound does not prove the claim")):
        (out / f"values-divergent-{name}{part}.cert").write_text("\n".join([*head, *more.split("; ")]) + "\n")
        index.append(f"values-divergent-{name}{part} {options} | {reason}")
scheme_line = "^sum-rules 1\n"
surface("values-scheme-none", "trapezoid-by-hand", "expected 'sum-rules'", replace(f"{scheme_line}(.*\n)*", "end"))
surface("values-scheme-no-section", "trapezoid-by-hand", "expected 'block 0'", replace("^block 0 norm 2\n", ""))
surface("values-scheme-norm", "trapezoid-by-hand", "does not prove the claim", replace("norm 2", "norm 1"))
surface("values-scheme-order-0", "trapezoid-by-hand", "number outside 1..", replace(scheme_line, "sum-rules 0\n"))
surface("values-scheme-order-65", "trapezoid-by-hand", ", line 11", replace(scheme_line, "sum-rules 65\n"))
surface("values-scheme-rules", "trapezoid-by-hand", "no sum rules of this order", replace(scheme_line, "sum-rules 3\n"))
surface("values-scheme-order", "trapezoid-by-hand", "does not annihilate", replace(scheme_line, "sum-rules 2\n"))
surface("values-scheme-fields", "trapezoid-by-hand", "wrong number of fields", replace(scheme_line, "sum-rules 1 full\n"))
surface("values-scheme-small", "trapezoid-scheme-second", "not led into the space", replace("^sum-rules 2", "sum-rules 1"))
surface("values-scheme-not-invariant", "trapezoid-by-hand", "out of the space", replace("^space 3\n(.*)\n.*", "space 2\n\\1"))
surface("values-scheme-phi", "trapezoid-by-hand", "not led into the space",  # the space of the differences of phi
        replace("^space 3(\nvector .*){3}\n.*", "space 1\nvector 0:1 1:-1 3:-1 4:1\nblock 0 norm 1"))
surface("values-scheme-one", "trapezoid-scheme-form", "does not prove the claim", replace("999999/1000000", "1"))
surface("values-scheme-exact", "trapezoid-exact", "expected 'end'", replace("^block 0 norm 2", "block 0 norm 2\ncycle 0 - 0"))
surface("values-scheme-digits", "trapezoid-by-hand", "expected 'space'", replace(scheme_line, "sum-rules 1\ndigits 0 1\n"))
surface("values-scheme-gram", "trapezoid-by-hand", "expected 'block 0'", replace("^(vector 2:1 .*)", r"\1\ngram 0:1"))
surface("surface-scheme", "hat-by-hand", "expected 'end'", replace("^end", "sum-rules 2\nspace 1\nvector -1:1 0:-2 1:1\nblock 0 norm 1\nend"))
surface("surface-zero", "hat-by-hand", "all coefficients of the mask are 0", replace("\\[1,2,1\\]/2@-1", "[0]"), surface="[0]", upper=None)
surface("turned-zero", "hat-turned", "all coefficients of the mask are 0", replace("\\[1,2,1\\]/2@-1", "[0,0]"), surface="[0,0]", upper=None)

# turned dilations
def turned(text):
    return lambda lines: [*lines[:4], f"turned {text}", *lines[4:]]


surface("turned-other", "three-direction", "not turned by symmetries", turned("[-2,0;0,2]"))
surface("turned-shear", "three-direction", "not isotropic and expanding", turned("[2,2;0,2]"))
surface("turned-fraction", "three-direction", "no integer multiple", turned("[1,2;-2,-1]"))
surface("turned-variables", "three-direction", "another number of variables", turned("[2]"))
surface("turned-determinant", "three-direction", "not turned by symmetries", turned("[4,0;0,4]"))
surface("turned-late", "turning-2", "expected 'space'", replace("^(digits .*)", "\\1\nturned [0,2;1,0]"))
surface("turned-curve", "four-point", "expected 'stability'", turned("[2]"))
# The hat function of three times the width: the scheme diverges, and the transfer operator has two fixed points, the one
# with the inner products of the shifts, whose sum has zeros at 2 pi/3, and a positive one. The lower end cannot be proved.
for name, gram, reason in [("cyclic-zeros", "0:108 1:93 2:60 3:27 4:8 5:1", "not shown to be positive"),
                           ("diverging", "0:4 3:1", "does not prove the claim")]:
    surface(f"surface-{name}", "hat-by-hand", reason, lambda lines: [
        lines[0], "surface [1,0,0,2,0,0,1]/2@0 [2]", *lines[2:5],
        *make_surfaces.space([{(k,): 1, (k + 1,): -2, (k + 2,): 1} for k in range(4)])[0],
        f"gram {gram}", *lines[8:]], surface="[1,0,0,2,0,0,1]/2@0")
element = make_surfaces.convolve(*[make_surfaces.binomial(d, 1) for d in ((1, 0), (0, 1), (1, 1), (1, -1))])
unstable = make_surfaces.gram({p: a / 4 for p, a in element.items()}, make_surfaces.Division([[2, 0], [0, 2]]))
surface("surface-unstable", "zwart-powell", "is not positive", lambda lines: [
    line.replace("block 0", f"gram {make_surfaces.terms(unstable)}\nproduct 0 1/4 0 0\nblock 0") for line in lines], upper="2")

# quadratic forms
reject("quadratic-bound", "golden-quadratic", "is not below the bound", replace("16181/10000$", "16180/10000"))
reject("quadratic-claim", "golden-quadratic", "does not prove the claim", replace("16181/10000$", "16182/10000"))
reject("quadratic-isometry", "rotation-quadratic", "is not below the bound",
       replace("2 1$", "2 99999999999999999999/100000000000000000000"))
# no word keeps the form times the number, or only by rounding; or the number is not the bound
def other_number(name, base, matrices, number, root, bound, reason):
    """A form for another number."""
    def edit(lines):
        form = [line for line in lines if re.match("form|word", line)]
        words = sum(line.startswith("word") for line in form)
        return [*lines[:2], "bounds - -", f"exact {number}", f"root {root}", f"block 0 quadratic {words} {bound}", *form, "end"]
    reject(name, base, reason, edit, f"--matrices {matrices} --exact {number}")


ONE, TWO, NEARLY = "|[-1,1]@1,0,1/1000|^1/1", "|[-2,1]@2,0,1/1000|^1/1", f"{2**70 + 1}/{2**70}"
for name, number, root, bound, reason in (
        ("kept-by-none", TWO, "2 0 0 2 2", 2, "no block attains"), ("kept-smaller", TWO, "2 0 0 2 2", 1, "no block attains"),
        ("kept-wide-above", ONE, "1 0 0 1 1001/1000", 1, "no block attains"),
        ("kept-wide-below", ONE, "1 0 0 999/1000 1", 1, "above the exact radius")):
    other_number(f"quadratic-{name}", "rotation-quadratic", "rotation.mat", number, root, bound, reason)
other_number("quadratic-kept-by-rounding", "unit-quadratic", "unit.mat", f"|[{-2**70 - 1},{2**70}]@1,0,1/1000|^1/1",
             f"{NEARLY} 0 0 {NEARLY} {NEARLY}", NEARLY, "no block attains")
reject("quadratic-bound-zero", "rotation-quadratic", "is not below the bound", replace("2 1$", "2 0"))
reject("quadratic-bound-negative", "rotation-quadratic", "is negative", replace("2 1$", "2 -1"))
reject("quadratic-indefinite", "rotation-quadratic", "not positive definite", replace("^form 0 1", "form 0 -1"))
reject("quadratic-semidefinite", "rotation-quadratic", "not positive definite", replace("^form 0 1", "form 0 0"))
reject("quadratic-zero", "rotation-quadratic", "not positive definite", replace("^form 1\nform 0 1", "form 0\nform 0 0"))
reject("quadratic-singular", "rotation-quadratic", "not positive definite", replace("^form 0 1", "form 1 1"))
reject("quadratic-other-form", "golden-quadratic", "is not below the bound", replace("^form 0 1", "form 0 2"))
reject("quadratic-row", "rotation-quadratic", "wrong number of fields", replace("^form 0 1", "form 0"))
reject("quadratic-form-missing", "rotation-quadratic", "expected 'form'", drop("form 0"))
reject("quadratic-word-missing", "golden-quadratic", "expected 'word'", drop("word 1"))
reject("quadratic-incomplete", "golden-quadratic", "not those of a complete tree",
       replace("quadratic 3((.|\n)*)word 1\n", "quadratic 2\\1"))
reject("quadratic-prefix", "golden-quadratic", "not those of a complete tree", replace("^word 0 1", "word 0 0 1"))
reject("quadratic-covered-twice", "golden-quadratic", "not those of a complete tree",
       replace("quadratic 3((.|\n)*)word 1\n", "quadratic 4\\1word 1\nword 1 0\n"))
reject("quadratic-overlap", "rotation-quadratic", "not those of a complete tree",
       replace("quadratic 2((.|\n)*)word 1\n", "quadratic 3\\1word 0 0\nword 0 1\n"))
reject("quadratic-word-twice", "golden-quadratic", "a word occurs twice", replace("^word 0 1", "word 0 0"))
reject("quadratic-empty-word", "golden-quadratic", "wrong number of fields", replace("^word 1", "word"))
reject("quadratic-letter", "golden-quadratic", "number outside 0..1", replace("^word 1", "word 2"))
reject("quadratic-long-word", "golden-quadratic", "wrong number of fields", replace("^word 1", "word" + " 1" * 1001))
reject("quadratic-equal-letters", "twice-quadratic", "a word occurs twice", replace("^word 1", "word 0"))
reject("quadratic-no-words", "golden-quadratic", "number outside 1..", replace("quadratic 3", "quadratic 0"))
reject("quadratic-many-words", "golden-quadratic", "expected 'word'", replace("quadratic 3", "quadratic 100000000"))
reject("quadratic-property", "golden-quadratic", "expected 'quadratic'", replace("16181/10000$", "16181/10000 symmetric"))
reject("quadratic-group-unannounced", "golden-quadratic-group", "expected 'form'", replace(" group:1", ""))
reject("quadratic-group-form", "golden-quadratic-group", "does not keep the form", replace("^form 0 1", "form 0 2"))
reject("quadratic-group-orbits", "golden-quadratic-group", "not those of a complete tree",
       replace("quadratic 3((.|\n)*)word 0 1\n", "quadratic 2\\1"))
reject("quadratic-group-other", "golden-quadratic-group", "does not permute the matrices", replace("^generator 1 0", "generator 0 1"))
reject("quadratic-too-high", "four-point-quadratic", "does not prove the claim",
       arguments=option(claims["four-point-quadratic"], "lower", "1954/1000"))

# a parameter
corner = claims["corner-converges"]
reject("range-other", "corner-converges", "expected 'exponent ", arguments=corner.replace("1/100", "1/101"))
reject("range-open", "corner-converges", "expected 'to'", drop("(to|block)"))
reject("range-short", "corner-converges", "expected 'to'", replace("^to 49/100", "to 48/100"))
reject("range-beyond", "corner-converges", "outside of the rest of the range", replace("^to 49/100", "to 1/2"))
reject("range-backwards", "corner-diverges", "outside of the rest of the range", replace("^to -1$", "to -2"))
reject("range-after-end", "corner-converges", "expected 'end'", lambda lines: lines[:-1] + lines[4:])
# one interval for all levels: each half of it has the property, the whole has not
levels, halves = claims["corner-levels"], "to 1/4\nblock 0 norm 1\nto 49/100"
reject("levels-two", "corner-levels", "has one interval", replace("^to 49/100", halves))
reject("levels-two-halves", "corner-levels-half", "has one interval", replace("^to 3/10", "to 1/4\nblock 0 norm 1\nto 3/10"))
reject("levels-short", "corner-levels", "has one interval", replace("^to 49/100", "to 48/100"))
reject("levels-beyond", "corner-levels", "outside of the rest of the range", replace("^to 49/100", "to 1/2"))
reject("levels-as-range", "corner-levels", "expected 'exponent ", arguments=levels.replace("--levels", "--for"))
reject("range-as-levels", "corner-converges", "expected 'levels ", arguments=corner.replace("--for", "--levels"))
reject("levels-other", "corner-levels", "expected 'levels ", arguments=levels.replace("1/100", "1/101"))
reject("levels-high", "corner-levels-half", "does not prove the claim", arguments=option(claims["corner-levels-half"], "lower", "1"))
reject("levels-negative", "corner-levels", "must be positive", arguments=option(levels, "lower", "-1"))
reject("levels-exact", "four-point-levels", "exact numbers are those of one mask", replace("^(bounds.*)$", "\\1\nexact 2-log|[-4,1]@4,0,1|^1/1\nroot 4 0 0 4 4"))
reject("levels-reduced", "corner-levels", "expected 'sum-rules'", replace("^sum-rules", "reduced [1] [1,1]\nsum-rules"))
reject("range-wide", "four-point-range", "does not prove the claim", lambda lines: lines[:4] + lines[6:])
reject("range-level", "four-point-range", "does not prove the claim", replace("norm \\d+", "norm 1"))
reject("range-too-high", "four-point-range", "does not prove the claim", arguments=option(claims["four-point-range"], "lower", "2"))
# JSR = 2 at w = 0 and 1/2: only s >= 0 there
reject("range-equal", "corner-converges", "does not prove the claim", replace("49/100", "1/2", 2), arguments=corner.replace("49/100", "1/2"))
reject("range-negative", "corner-converges", "must be positive", arguments=option(corner, "lower", "-1"))
reject("range-sum-rules", "corner-converges", "no sum rules of this order", replace("sum-rules 1", "sum-rules 2"))
reject("range-not-affine", "corner-converges", "do not sum to the arity", replace("\\[w,1-w,1-w,w\\]", "[w,1-w,1-w,2*w]"),
       arguments=corner.replace("1-w,w]", "1-w,2*w]"))
reject("range-special-sum-rules", "corner-converges", "no sum rules of this order",  # only at w = 1/3
       replace("\\[w,1-w,1-w,w\\]", "[w,1/3,2-w-1/3]"), arguments=corner.replace("[w,1-w,1-w,w]", "[w,1/3,2-w-1/3]"))
crossing = "the characteristic polynomial of the product, with the other sign, is not"
reject("range-eigenvalue-low", "corner-not-smooth", "no exponent below", replace("11/10", "9/10"))
reject("range-eigenvalue-high", "corner-not-smooth", crossing, replace("11/10", "13/10"))
reject("range-eigenvalue-sign", "corner-not-smooth", crossing, replace("11/10", "-11/10"))
reject("range-eigenvalue-pair", "corner-not-smooth", crossing, replace("11/10 0", "0 11/10"))
reject("range-eigenvalue-both", "corner-not-smooth", "either the real or the imaginary part", replace("11/10 0", "11/10 1"))
reject("range-eigenvalue-none", "corner-not-smooth", "either the real or the imaginary part", replace("11/10 0", "0 0"))
reject("range-eigenvalue-touch", "corner-not-smooth", crossing, replace("11/10", "6/5"))  # an eigenvalue at w = 1/5
reject("range-letter", "corner-not-smooth", "number outside 0..1", replace("11/10 0 0", "11/10 0 2"))
reject("range-long-word", "corner-not-smooth", "more work than", replace("11/10 0 0", "11/10 0" + " 0" * 4000))
reject("range-product-missing", "corner-not-smooth", "expected 'product'", drop("product"))
reject("range-upper", "corner-not-smooth", "does not prove the claim", arguments=option(claims["corner-not-smooth"], "upper", "1/2"))
reject("range-stability-missing", "corner-not-smooth", "expected 'stability'", drop("stability"))
reject("range-diverges-not", "corner-diverges", "does not prove the claim", replace("11/5", "19/10"))
quotient = claims["quotient-converges"]
reject("quotient-sums", "quotient-converges", "do not sum to the arity", replace("1\\+v\\)", "2+v)"),
       arguments=quotient.replace("(1+v)", "(2+v)"))
reject("quotient-zero", "quotient-diverges", "changes its sign", replace("-3$", "0", 2),
       arguments=claims["quotient-diverges"].replace("..-3", "..0"))
reject("quotient-zero-end", "quotient-diverges", "changes its sign", replace("-3$", "-1", 2),
       arguments=claims["quotient-diverges"].replace("..-3", "..-1"))
reject("quotient-zero-stable", "quotient-stable", "the denominator of the mask is not", replace("-11/10", "-9/10"),
       arguments=claims["quotient-stable"].replace("-11/10", "-9/10"))
reject("quotient-zero-stable-end", "quotient-stable", "the denominator of the mask is not", replace("-11/10", "-1"),
       arguments=claims["quotient-stable"].replace("-11/10", "-1"))
reject("quotient-wide", "quotient-square", "changes its sign", replace("^to 1\nproduct 0 2 0 0\n", ""))
reject("quotient-too-high", "quotient-not-smooth", crossing, replace("11/10", "5/4"))
reject("quotient-too-low", "quotient-not-smooth", "no exponent below", replace("11/10", "9/10"))
reject("quotient-norm", "quotient-converges", "does not prove the claim", replace("3/2..9", "1..9"),
       arguments=quotient.replace("3/2..9", "1..9"))


def rounded(name, base, reason, within, edit=lambda lines: lines, **options):
    """The claim with another rounding, in the file as well."""
    arguments = option(claims[base], "within", within)
    for key, value in options.items():
        arguments = option(arguments, key, value)
    reject(name, base, reason, lambda lines: edit([re.sub(" within=.*", f" within={within}", line) for line in lines]), arguments)


four = claims["rounded-four-point"]
reject("rounded-other", "rounded-four-point", "expected 'exponent ", arguments=option(four, "within", "1/100000000,4"))
reject("rounded-not", "four-point", "expected 'exponent ", arguments=option(claims["four-point"], "within", "1/100000000,4"))
rounded("rounded-other-rules", "rounded-four-point", "another number of sum rules", "1/1000000000,3")
rounded("rounded-fewer-rules", "rounded-four-point", "another number of sum rules", "1/1000000000,4",
        replace("sum-rules 4", "sum-rules 3"))
rounded("rounded-coarse-polytope", "rounded-four-point", "does not prove the claim", "1/10000000,4", lambda lines: lines, upper="21/10")
rounded("rounded-coarse-product", "rounded-four-point", "does not prove the claim", "1/10000000,4", lambda lines: lines, lower="19/10")
rounded("rounded-steep", "rounded-four-point", "the product proves nothing of rounded masks", "1/1000000000,4",
        replace("^product 0 4", "product 0 1500001/1000000"))  # 3/2 is a zero of the derivative
rounded("rounded-coarse-norm", "rounded-four-point-norm", "does not prove the claim", "1/100,4")
rounded("rounded-hat-coarse", "rounded-hat", "does not prove the claim", "1/80,1")
rounded("rounded-exact-claim", "rounded-four-point", "does not prove the claim", "1/1000000000,4", lambda lines: lines, lower="2")
rounded("rounded-exact-upper", "rounded-four-point", "does not prove the claim", "1/1000000000,4", lambda lines: lines, upper="2")
rounded("rounded-resultant", "rounded-stable", "the resultant of the polyphase parts is not", "1/5,2")
rounded("rounded-cyclotomic", "rounded-stable", "of unity of order 3 may be 0", "1/1000,1",
        lambda lines: [line.replace("[273205,473205,126795,-73205]/400000", "[1,0,0,1]").replace("rules 2", "rules 1")
                       for line in lines], mask="[1,0,0,1]")
rounded("rounded-unstable", "rounded-stable", "the resultant of the polyphase parts is not", "1/1000,2",
        lambda lines: [line.replace("[273205,473205,126795,-73205]/400000", "[1,1,1,1]/2") for line in lines],
        mask="[1,1,1,1]/2")
reject("rounded-blocks", "rounded-four-point", "blocks prove nothing of rounded masks",
       replace("^product", "blocks 1 1\nbasis 1 0\nbasis 0 1\ninverse 1 0\ninverse 0 1\nproduct"))
reject("rounded-group", "rounded-four-point", "a group proves nothing of rounded masks", replace("symmetric", "group:1"))
reject("rounded-quadratic", "rounded-four-point-norm", "expected 'norm', 'polytope'",
       replace("norm 8", "quadratic 2 5\nform 1\nform 0 1\nword 0\nword 1"))
reject("rounded-no-product", "rounded-daubechies", "expected 'product'", drop("product"))
reject("rounded-no-stability", "rounded-daubechies", "expected 'stability'", drop("stability"))
stable = claims["corner-stable"]
reject("range-unstable", "corner-stable", "the resultant of the polyphase parts is not", replace("499/1000", "501/1000"),
       arguments=stable.replace("499/1000", "501/1000"))
reject("range-unstable-end", "corner-stable", "the resultant of the polyphase parts is not", replace("499/1000", "1/2"),
       arguments=stable.replace("499/1000", "1/2"))
reject("range-unstable-cyclic", "corner-stable", "of unity of order 3 is not", replace("-1..499/1000", "3/4..3/2"),
       arguments=stable.replace("-1..499/1000", "3/4..3/2"))
reject("range-stable-sections", "corner-stable", "expected 'end'", lambda lines: lines[:-1] + ["to 499/1000", "block 0 norm 1", "end"])
rough = claims["corner-rough"]
more = "sum-rules full: what one more sum rule would make 0, is not"
reject("full-not", "corner-rough", more, replace("3/10..2/5", "1/5..2/5"), arguments=rough.replace("3/10", "1/5"))
reject("full-not-at-end", "corner-rough", more, replace("3/10..2/5", "1/4..2/5"), arguments=rough.replace("3/10", "1/4"))
reject("full-not-one-mask", "hat-rough", more, replace("sum-rules 2", "sum-rules 1"))
reject("full-missing", "corner-rough", "needs the full number of sum rules", replace(" full", ""))
reject("full-misspelt", "corner-rough", "expected 'sum-rules M', or", replace(" full", " fall"))
reject("full-twice", "corner-rough", "wrong number of fields", replace(" full", " full full"))
reject("full-unstable", "corner-rough", "the resultant of the polyphase parts is not", replace("2/5", "3/5"),
       arguments=rough.replace("2/5", "3/5"))
reject("full-no-stability", "corner-rough", "expected 'stability'", drop("stability"))
reject("full-order", "hat-rough", "needs the full number of sum rules", arguments=option(claims["hat-rough"], "upper", "C1"))
reject("full-equal", "corner-full", "expected 'product'", arguments=option(claims["corner-full"], "upper", "1"))
reject("full-below", "hat-full", "expected 'product'", arguments=option(claims["hat-full"], "upper", "199/100"))
reject("full-no-section", "corner-rough-converges", "expected 'block 0", drop("block"))
reject("full-rounded", "rounded-daubechies", "expected 'sum-rules M', or", replace("sum-rules 2", "sum-rules 2 full"))
reject("full-surface", "hat-by-hand", "wrong number of fields", replace("sum-rules 2", "sum-rules 2 full"))
trapezoid = claims["trapezoid-reduced"]
reject("reduced-factor", "trapezoid-reduced", "is not that of the mask and the factor", replace("reduced \\[1,1\\]", "reduced [1,2]"))
reject("reduced-mask", "trapezoid-reduced", "is not that of the mask and the factor", replace("\\[1,2,1\\]/2", "[1,2,1]/3"))
reject("reduced-length", "trapezoid-reduced", "is not that of the mask and the factor", replace("\\[1,2,1\\]/2", "[1,1]"))
reject("reduced-zero-at-1", "trapezoid-reduced", "is 0 at 1", replace("reduced \\[1,1\\]", "reduced [1,-1]"))
reject("reduced-zero-first", "trapezoid-reduced", "the first and the last not zero", replace("reduced \\[1,1\\]", "reduced [0,1,1]"))
reject("reduced-by-1", "trapezoid-reduced", "the polyphase parts may have a common zero",
       lambda lines: replace("reduced .*", "reduced [1] [1,1,1,1]/2")(replace("sum-rules 2", "sum-rules 1")(lines)))
reject("reduced-fields", "trapezoid-reduced", "wrong number of fields", replace("reduced \\[1,1\\]", "reduced"))
reject("reduced-text", "trapezoid-reduced", "line 4", replace("reduced \\[1,1\\]", "reduced 1,1"))
reject("reduced-no-convergence", "trapezoid-reduced", "expected 'sum-rules'",
       lambda lines: lines[:-3] + ["end"])
reject("reduced-convergence-open", "trapezoid-reduced", "does not prove the claim", replace("norm 2", "norm 1"))
# the hat at a third of the scale: continuous, but the scheme does not converge
reject("reduced-divergent", "trapezoid-reduced", "does not prove the claim",
       lambda lines: replace("sum-rules 1", "sum-rules 2")(replace("norm 2", "norm 8")(replace("reduced .*", "reduced [1,2,3,2,1] [1,2,1]/2")(
           replace("\\[1,1,1,1\\]/2", "[1,0,0,2,0,0,1]/2")(lines)))),
       arguments=trapezoid.replace("[1,1,1,1]", "[1,0,0,2,0,0,1]"))
reject("reduced-no-stability", "trapezoid-reduced", "expected 'stability'", drop("stability"))
reject("reduced-product", "trapezoid-reduced", "proves no positive spectral radius", replace("product 0 2", "product 0 1"))
reject("reduced-stable-claim", "trapezoid-reduced", "with a lower end", arguments=option(option(trapezoid, "lower", None), "upper", None))
reject("reduced-only-rough", "trapezoid-rough", "with a lower end", arguments=option(claims["trapezoid-rough"], "lower", None))
reject("reduced-not-rough", "trapezoid-rough", "needs the full number of sum rules", arguments=option(claims["trapezoid-rough"], "upper", "C1"))
reject("reduced-high", "trapezoid-reduced", "does not prove the claim", arguments=option(trapezoid, "lower", "11/10"))
reject("reduced-low", "trapezoid-reduced", "does not prove the claim", arguments=option(trapezoid, "upper", "9/10"))
reject("reduced-range", "corner-rough", "expected 'sum-rules'", replace("^sum-rules", "reduced [1] [1,1]\nsum-rules"))
reject("range-pair-high", "pair", crossing, replace("0 7/5", "0 8/5"))
reject("range-pair-real", "pair", crossing, replace("0 7/5", "7/5 0"))
# what only one check refuses
hat = claims["hat-by-hand"]
reject("bounds-text", "golden", "line 3", replace("^bounds .*", "bounds foo bar"))
reject("bounds-order", "golden", "line 3", replace("^bounds .*", "bounds C1 2"))
reject("bounds-code", "golden", "line 3", replace("^bounds .*", "bounds 1 \x1b[31m"))
reject("property-twice", "four-point-by-hand", "a polytope property twice", replace("symmetric", "symmetric symmetric"))
reject("norm-fields", "four-point-norm", "wrong number of fields", replace("^(block 0 norm .*)$", "\\1 1"))
reject("term-fields", "hat-by-hand", "a term is POINT:INTEGER", replace("-1:1 ", "-1:1:1 "))
reject("far-mask", "hat-by-hand", "a coordinate is too large", replace("@-1", "@2000000000"), arguments=hat.replace("@-1", "@2000000000"))
reject("range-pair-size", "corner-diverges", "a pair of eigenvalues needs matrices of size 2",
       lambda lines: replace("^exponent.*", "exponent [w,1,1-w] 2 w=3/2..2")(replace("^to .*", "to 2")(
           replace("product .*", "product 0 0 1 0")(lines))),
       arguments="--mask [w,1,1-w] --arity 2 --for w=3/2..2 --upper 0")
reject("far-exponent", "four-point-norm", "too large", arguments=option(claims["four-point-norm"], "lower", "1000000000"))
# exact numbers
outside = "may lie outside"


def exact_case(name, base, reason, number, edit=lambda lines: lines, root=None):
    """With another exact number, in claim and certificate."""
    def change(lines):
        lines = replace("^exact .*", f"exact {number}")(lines)
        return edit(replace("^root .*", f"root {root}")(lines) if root else lines)
    reject(name, base, reason, change, option(claims[base], "exact", number))


four, slow = "4-log|[-4,1]@4,0,1|^1/1", "|[81,-270,100]@47/20,0,1/10|^1/2"
reject("exact-other", "four-point-exact", "expected 'exact 4-log|[-4,1]@4,0,2|^1/1'", arguments=option(
    claims["four-point-exact"], "exact", "4-log|[-4,1]@4,0,2|^1/1"))
reject("exact-none", "four-point-by-hand", "expected 'exact", arguments=claims["four-point-exact"])
exact_case("exact-order", "four-point-exact", "another number before its logarithm", four.replace("4-log", "3-log"))
exact_case("exact-order-surface", "surface-exact", "another number before its logarithm", "2-log|[1,-10,20]@9/25,0,1/10|^1/1")
reject("exact-range", "four-point-range", "exact numbers are those of one mask", replace("^(bounds.*)$", f"\\1\nexact {four}\nroot 4 0 0 4 4"))
reject("exact-rounded", "rounded-hat", "exact numbers are those of one mask", replace("^(bounds.*)$", f"\\1\nexact {four}\nroot 4 0 0 4 4"))
reject("exact-text", "four-point-exact", "an exact exponent is", replace("^exact 4-log", "exact "), option(claims["four-point-exact"], "exact", None))
exact_case("exact-not-unique", "slow-exact", "more than one zero", slow.replace("1/10|", "2|"))
exact_case("exact-elsewhere", "slow-exact", "not the one of the claim", slow.replace("47/20", "3"))
exact_case("exact-elsewhere-imaginary", "slow-exact", "not the one of the claim", slow.replace(",0,", ",1/2,"))
exact_case("exact-not-real", "slow-exact", "no real eigenvalue", slow.replace(",0,", ",1/100,"))
reject("exact-point-not-real", "slow-exact", "no real eigenvalue", replace(r"^root (\S+) .*", r"root \1 1/1000000 1/10000 1 2"))
reject("root-wide", "slow-exact", "not the one of the claim", replace(r"^(root \S+ 0) \S+", r"\1 1/5"))
reject("root-negative", "slow-exact", "the error of a root is negative", replace(r"^(root \S+ 0) \S+", r"\1 -1"))
reject("root-none", "slow-exact", "no zero is proved so near", replace("^root .*", "root 47/20 0 1/1000 1 2"))
reject("root-narrow", "slow-exact", "no zero is proved so near", replace(r"^(root \S+ 0) \S+", r"\1 0"))
reject("root-low", "slow-exact", "bounds of the exact radius", replace(r"^(root.*) (\S+) (\S+)$", r"\1 154/100 \3"))
reject("root-low-zero", "slow-exact", "or its modulus not positive", replace(r"^(root.*) (\S+) (\S+)$", r"\1 0 \3"))
reject("root-high", "slow-exact", "bounds of the exact radius", replace(r"^(root.*) (\S+) (\S+)$", r"\1 \2 153/100"))
reject("root-high-small", "slow-exact", "bounds of the exact radius", replace(r"^(root \S+ 0) \S+ (\S+) (\S+)$", r"\1 1/20 1/10 1/100"))
reject("root-low-error", "four-point-exact", "bounds of the exact radius", replace("^root.*", "root 4 0 1/100 4 5"))
reject("root-high-error", "four-point-exact", "bounds of the exact radius", replace("^root.*", "root 4 0 1/100 3 4"))
reject("exact-spline", "bspline-1", "between 0 and the number of sum rules", replace("^(bounds.*)$", "\\1\nexact 2-log|[-1,1]@1,0,1|^1/1\nroot 1 0 0 1 1"))
exact_case("exact-rough", "four-point-exact", "between 0 and the number of sum rules", "4-log|[-16,1]@16,0,1|^1/1", root="16 0 0 16 16")
exact_case("exact-not-attained", "four-point-exact", "no block attains", "4-log|[-5,1]@5,0,1|^1/1", lambda lines: drop("cycle|seed")(lines),
           root="5 0 0 5 5")
exact_case("exact-not-attained-reduced", "reduced-exact", "no block attains", "4-log|[-5,1]@5,0,1|^1/1",
           lambda lines: drop("cycle|seed")(lines), root="5 0 0 5 5")
reject("exact-no-cycle", "four-point-exact", "the bound of a block is above", lambda lines: replace("^image 0 1.*", "image 0 1 0:-3 0f:-3")(
    drop("cycle|seed")(lines)))
reject("exact-bound", "four-point-exact", "the bound does not prove", arguments=option(claims["four-point-exact"], "lower", "201/100"))
exact_case("exact-not-unique-edge", "slow-exact", "more than one zero", slow.replace("1/10|", "1|"))
exact_case("exact-not-unique-negative", "four-point-exact", "more than one zero", "4-log|[4,1,4,1]@-4,0,3/4|^1/1", root="-4 0 0 4 4")
exact_case("exact-not-unique-imaginary", "four-point-exact", "more than one zero", "4-log|[16,16,1,1]@0,-4,5/4|^1/1", root="0 -4 0 4 4")
# what is near the zero is known too coarsely
coarse = "|[-8,12,-12,9,27]@-6/5,0,1/20|^1/1"
exact_case("root-coarse-negative", "negative-exact", "may be zero", coarse, replace(r"^(root \S+ 0) .*", r"\1 1/24 1/2 2"))
reject("root-coarse-conjugate", "conjugate-exact", "too far", replace(r"^(root \S+ \S+) .*", r"\1 1/20 1/2 2"))
reject("root-coarse-conjugate-less", "conjugate-exact", "too far", replace(r"^(root \S+ \S+) .*", r"\1 1/80 1/2 2"))
reject("origin-letter-high", "slow-exact", "number outside", replace("^origin 1 0 1", "origin 1 0 2"))
reject("same-letter-high", "lone-exact", "number outside", replace("^same 1 1", "same 1 2"))
reject("same-source-high", "lone-exact", "number outside", replace("^same 1 1", "same 3 1"))
reject("exact-reduced-stable", "reduced-exact", "a reduced mask tells", arguments=option(option(option(
    claims["reduced-exact"], "exact", None), "lower", None), "upper", None))
reject("cycle-alone", "four-point-exact", "expected 'end'", drop("exact|root"), option(claims["four-point-exact"], "exact", None))
reject("cycle-short", "slow-exact", "wrong number of fields", replace("^cycle 0 - 1 0", "cycle 0 - 1"))
reject("cycle-twice", "four-point-exact", "the first one of two cycles", replace("^(cycle.*\nseed.*)$", "\\1\n\\1"))
reject("cycle-vertex", "four-point-exact", "number outside", replace("^cycle 0", "cycle 1"))
reject("cycle-letter", "four-point-exact", "number outside", replace("^cycle 0 - 0", "cycle 0 - 2"))
reject("cycle-word", "flip-exact", "unknown generator", replace("^cycle 0 f", "cycle 0 A"))
reject("cycle-word-empty", "four-point-exact", "a cycle has a word", replace("^cycle 0 - 0", "cycle 0  0"))
reject("cycle-word-twice", "flip-exact", "unknown generator", replace("^cycle 0 f", "cycle 0 fff"))
reject("term-word-twice", "four-point-by-hand", "unknown generator", replace("^unit 0 0f:", "unit 0 0fff:"))
reject("cycle-word-long", "flip-exact", "more than 16 generators, line 15", replace("^cycle 0 f", "cycle 0 " + 17 * "f"))
reject("cycle-other", "slow-exact", "does not vanish on the seed", replace("^cycle 0 - 1 0", "cycle 0 - 1 1"))
reject("cycle-order", "slow-exact", "too far", replace("^cycle 0 - 1 0", "cycle 0 - 0 1"))
reject("cycle-flip", "flip-exact", "does not vanish on the seed", replace("^cycle 0 f", "cycle 0 -"))
reject("seed-other", "lone-exact", "does not vanish on the seed", replace("^seed.*", "seed 0 0 1"))
reject("seed-zero", "four-point-exact", "may be zero", replace("^seed.*", "seed 0 0"))
reject("seed-eigenvector", "four-point-exact", "may be zero", lambda lines: replace("^unit 0 0f:1", "unit 0 0:1")(
    replace("^vertex 0 1", "vertex 1 0")(lines)))
reject("vertex-far", "slow-exact", "too far", replace(r"^vertex (\S+) (\S+)", r"vertex \2 \1"))
exact_case("cone-negative", "golden-cone-exact", "may be negative", "|[-1,-1,1]@-3/5,0,1/10|^1/1",
           root=f"{-Q(6180339887498948482, 10**19)} 0 1/1000000000000000000 6/10 7/10")
reject("origin-first", "slow-exact", "the first vertex of a cycle is no image", replace("^(seed.*)$", "\\1\norigin 0 0 0"))
reject("origin-of-cycle", "slow-exact", "the first vertex of a cycle is no image", lambda lines: replace("^(cycle.*)$", "cycle 1 - 0 1")(lines))
reject("origin-later", "slow-exact", "number outside", replace("^origin 1 0 1", "origin 1 1 1"))
reject("origin-order", "slow-exact", outside, replace("^(origin 3.*)\n(origin 4.*)$", "\\2\n\\1"))
reject("origin-letter", "slow-exact", "too far", replace("^origin 1 0 1", "origin 1 0 0"))
reject("origin-none", "slow-exact", "a vertex of a cycle is missing", drop("origin 1"))
reject("origin-end", "slow-exact", outside, lambda lines: [line for line in lines if line != [o for o in lines if o.startswith("origin")][-1]])
reject("same-none", "lone-exact", outside, drop("same"))
reject("same-target", "lone-exact", "not the vertex", replace("^same 1 1 2", "same 1 1 0"))
reject("same-source", "lone-exact", "not the vertex", replace("^same 1 1 2", "same 2 1 2"))
reject("same-word", "primal-exact", "unknown generator", replace("^(same .*)$", "\\1B"))
reject("same-above", "golden-cone-exact", "not the vertex", lambda lines: replace("^same.*", "same 0 0 0f")(lines))
reject("same-cone-none", "golden-cone-exact", outside, drop("same"))
WEIGHT = edge_cases.ONE**2 // edge_cases.PHI
reject("same-opposite", "golden-cone-exact", "not the vertex", lambda lines: [
    *lines[:5], "block 0 polytope 2 64 64", f"vertex {edge_cases.PHI - 2} {edge_cases.ONE}", f"vertex 0 {edge_cases.ONE}",
    f"unit 0 0:{WEIGHT} 1:{-WEIGHT}", f"unit 1 1:{edge_cases.ONE}", "image 0 0", "image 0 1", "image 1 0", "image 1 1", "cycle 0 - 0",
    "seed 1 0", "same 0 1 0", "end"], "--matrices turned.mat --exact |[-1,-1,1]@8/5,0,1/10|^1/1")

# one spectral radius, and logarithms
reject("logarithm-blocks", "blocks-exponent-exact", "more than one block has the exact radius",
       replace("^(image 0 .) 0:16$", r"\1 0:21 0:-5", 2))
modules = single_cases, edge_cases, frequency_cases, variant_cases, graph_cases, cycle_cases, subradius_cases, subradius_exact_cases, l1_cases, vector_cases, field_cases, convergence_cases, vector_range_cases, stability_cases, attains_cases, level_cases, vector_list_cases
for case, base, options, reason, edits in [case for module in modules for case in module.REJECTED]:
    reject(case, base, reason, lambda lines: make_certificates.edited(lines, edits), options)
for case, options, lines, reason in variant_cases.WRITTEN + subradius_exact_cases.WRITTEN + l1_cases.WRITTEN + stability_cases.WRITTEN + attains_cases.WRITTEN:
    (out / f"{case}.cert").write_text("\n".join(["subcert-certificate 3", *lines.split("; ")]) + "\n")
    index.append(f"{case} {options} | {reason}")
for case, (options, lines), reason in [*attains_cases.rejected(make_certificates), *field_cases.rejected_by(make_certificates)]:
    (out / f"{case}.cert").write_text("\n".join(lines) + "\n")
    index.append(f"{case} {' '.join(options)} | {reason}")
for case, options, lines, reason in [*vertex_cases.rejected(), *vertex_variant_cases.rejected(), *vertices_cases.rejected(), *vertex_fit_cases.rejected(), *not_c1_cases.rejected()]:
    (out / f"{case}.cert").write_text("\n".join(lines) + "\n")
    index.append(f"{case} {options} | {reason}")
(out / "claims.txt").write_text("\n".join(index) + "\n")
