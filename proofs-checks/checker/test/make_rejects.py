#!/usr/bin/env python3
"""Makes the corpus of certificates that must be rejected, by edits of the accepted ones.

Usage: make_rejects.py ACCEPT_DIRECTORY OUTPUT_DIRECTORY
Each line of OUTPUT_DIRECTORY/claims.txt: name, options of the claim, '|', a part of the expected reason.
"""
import re
import sys
from pathlib import Path

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
    lines = ["subcert-certificate 1", f"exponent {mask} {arity}", "bounds - -", f"sum-rules {m}", *more, "block 0 norm 6", "end"]
    (out / f"{name}.cert").write_text("\n".join(lines) + "\n")
    upper = f" --upper {upper}" if upper else ""
    index.append(f"{name} --mask {mask} --arity {arity} --lower {lower}{upper} | {reason}")


# the file as such
reject("empty-file", "golden", "expected 'subcert-certificate 1', line 1", lambda lines: "")
reject("version", "golden", "expected 'subcert-certificate 1', line 1", replace("certificate 1", "certificate 2"))
reject("truncated", "golden", "expected 'image 3 0'", lambda lines: lines[:-3])
reject("no-end", "golden", "expected 'end'", lambda lines: lines[:-1])
reject("no-line-feed", "golden", "last line without line feed", lambda lines: "\n".join(lines))
reject("trailing-line", "golden", "text after 'end'", lambda lines: lines + ["end"])
reject("trailing-empty-line", "golden", "empty line", lambda lines: lines + [""])
reject("unknown-line", "golden", "needs a norm or a polytope", replace("^block", "comment hello\nblock"))
reject("duplicate-product", "golden", "needs a norm or a polytope", lambda lines: lines[:4] + lines[3:])
reject("duplicate-section", "golden", "expected 'end'", lambda lines: lines[:-1] + lines[4:])
reject("double-space", "golden", "misplaced space, line 2", replace("radius 2 2", "radius 2  2"))
reject("carriage-return", "golden", "bad character", replace("radius 2 2", "radius 2 2\r"))
reject("non-ascii", "golden", "bad character", replace("radius", "radi\u00fcs"))
reject("huge-number", "golden", "number too long", replace("^vertex \\S+", "vertex " + "9" * 3000))
reject("huge-count", "golden", "expected 'vertex'", replace("real \\d+", "real 99999999"))
reject("overflowing-count", "golden", "number outside", replace("real \\d+", "real 18446744073709551617"))
reject("zero-denominator", "golden", "a denominator must be positive", replace("^product 0 \\S+", "product 0 1/0"))
reject("leading-zero", "golden", "not an integer", replace("^vertex ", "vertex 0"))
# the claim
reject("too-high", "golden", "does not prove the claim", arguments=option(claims["golden"], "lower", "1619/1000"))
reject("too-low", "golden", "does not prove the claim", arguments=option(claims["golden"], "upper", "1618/1000"))
reject("bspline-too-high", "bspline-3", "does not prove the claim",
       arguments=option(claims["bspline-3"], "lower", "30000000000000000000001/10000000000000000000000"))
reject("bspline-too-low", "bspline-3", "does not prove the claim",
       arguments=option(claims["bspline-3"], "upper", "29999999999999999999999/10000000000000000000000"))
reject("other-mask", "bspline-3", "certificate for another scheme", arguments=claims["bspline-2"])
reject("other-kind", "golden", "expected 'exponent'", arguments=claims["bspline-2"])
reject("other-family", "golden", "certificate for another scheme or family", arguments=option(claims["golden"], "matrices", "blocks.mat"))
reject("other-matrices", "golden", "no positive spectral radius", arguments=option(claims["golden"], "matrices", "rotation.mat"))
reject("other-shift", "four-point", "certificate for another scheme",
       arguments=claims["four-point"].replace("@-3", "@-2"))
reject("negative-lower", "bspline-2", "must be positive", arguments=option(claims["bspline-2"], "lower", "-1"))
# exponent
reject("too-many-sum-rules", "four-point", "no sum rules of this order", replace("sum-rules 4", "sum-rules 5"))
reject("no-sum-rules", "four-point", "number outside 1..500", replace("sum-rules 4", "sum-rules 0"))
reject("no-stability", "four-point", "needs a 'stability' line", drop("stability"))
reject("stability-field", "four-point", "wrong number of fields", replace("stability", "stability 1"))
reject("no-product", "four-point", "needs a 'product' line", drop("product"))
reject("no-section", "four-point", "needs a norm or a polytope", lambda lines: lines[:6] + ["end"])
mask_case("wrong-sum", "[1,2,1]", 2, "1/2", None, "do not sum to the arity")
mask_case("diverging", "[-1,3,3,-1]/2", 1, "1/10", None, "does not prove the claim")
# hat(x/3)/3: exponent 1, shifts not stable by the cyclic zeros of order 3 (-omega is a zero of 1 - z + z^2)
mask_case("cyclic-zeros", "[1,0,0,2,0,0,1]/2", 2, "1/1000", "2", "Phi_6 may divide", more=["stability"])
# symmetric zeros i, -i: (1+z)(1+z^2)/2
mask_case("symmetric-zeros", "[1,1,1,1]/2", 1, "1/1000", "2", "common zero", more=["stability"])
# ternary, hat(x/2)/2: zeros of order 6 (Phi_6) and 2 by (1 + z^2 + z^4)^2
mask_case("ternary-cyclic-zeros", "[1,0,2,0,3,0,2,0,1]/3", 2, "1/1000", "2", "Phi_6 may divide", arity=3, more=["stability"])
# Haar with M = 1: the radius is 2 and the exponent bound 0
mask_case("haar", "[1,1]", 1, "1/1000", None, "does not prove the claim")
# a cubic spline with too few factors: the radius is 1, nothing can be said from above
reject("saturated", "bspline-3", "radius", lambda lines: [
    *lines[:3], "sum-rules 1", "stability", "product 0 1 0 0", "block 0 norm 1", "end"],
    arguments="--mask [1/8,1/2,3/4,1/2,1/8]@-3 --arity 2 --lower 9/10 --upper 11/10")
# product
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
reject("no-vertices", "golden", "number outside", lambda lines: lines[:4] + ["block 0 polytope real 0 64 64", "end"])
reject("no-vertices-units", "golden", "number outside",
       lambda lines: lines[:4] + ["block 0 polytope real 0 64 64", "unit 0", "unit 1", "end"])
reject("zero-vertex", "golden", "do not span", lambda lines: lines[:4] + [
    "block 0 polytope real 1 64 64", "vertex 0 0", "unit 0", "unit 1", "image 0 0", "image 0 1", "end"])
reject("flat-vertices", "golden", "do not span", lambda lines: lines[:4] + [
    "block 0 polytope real 1 0 0", "vertex 1 0", "unit 0 0:1", "unit 1", "image 0 0 0:1", "image 0 1 0:1", "end"])
reject("vertex-short", "golden", "wrong number of fields", replace("^(vertex \\S+) .*", r"\1"))
reject("vertex-index", "golden", "number outside", replace(r"^unit 0 \d+:", "unit 0 77:"))
reject("negative-index", "golden", "number outside", replace(r"^unit 0 \d+:", "unit 0 -1:"))
reject("flip-unannounced", "golden", "not an integer", replace(r"^unit 0 \d+:", "unit 0 0f:"))
reject("conjugate-unannounced", "golden", "not an integer", replace(r"^unit 0 \d+:", "unit 0 0c:"))
reject("empty-weight", "golden", "not an integer", replace("^(unit 0 \\d+:)\\S+", r"\1"))
reject("not-symmetric", "rotation", "not symmetric", replace("complex 1 0 64", "complex 1 0 64 symmetric"))
reject("not-nonnegative", "rotation", "not non-negative", replace("complex", "nonnegative"))
reject("negative-weight", "golden-nonnegative", "negative weight", replace("^unit 0 0:", "unit 0 0:-"))
reject("negative-vertex", "golden-nonnegative", "negative coordinate", replace("^vertex ", "vertex -"))
reject("nonnegative-as-real", "golden-nonnegative", "do not span", replace("nonnegative", "real"))
reject("complex-as-real", "rotation", "wrong number of parts", replace("complex", "real"))
reject("small-modulus", "rotation", "modulus is too small", replace("^(image 0 0 \\S+),(\\d+)$", r"\1,18446744073709551600"))
reject("missing-unit", "golden", "expected 'unit 1'", drop("unit 1"))
reject("missing-image", "golden", "expected 'image 1 0'", drop("image 1 0"))
reject("empty-image", "golden", "does not prove the claim", replace("^(image 1 0) .*", r"\1"))
reject("untransposed", "golden-transposed", "unknown polytope property", replace("transposed", "transpose"))
reject("weights-scaled", "golden", "does not prove the claim",
       lambda lines: [re.sub(r":(-?)(\d+)", lambda m: f":{m[1]}{int(m[2]) * 999 // 1000}", line)
                      if line.startswith("image") else line for line in lines])
# blocks
reject("blocks-sizes", "blocks", "do not sum", replace("^blocks 2 1", "blocks 2 2"))
reject("blocks-not-triangular", "blocks", "not block upper triangular", replace("^blocks 2 1", "blocks 1 2"))
reject("blocks-entry", "blocks", "T B = B M", replace("^(triangular 0\nrow) \\S+", r"\1 2"))
reject("blocks-singular", "blocks", "determinant", replace("^row 1 2 0$", "row 0 0 0"))
reject("blocks-missing-section", "blocks", "expected 'block 1'", drop("block 1"))
reject("blocks-order", "blocks", "expected 'block 1'", replace("^block 1", "block 0"))

(out / "claims.txt").write_text("\n".join(index) + "\n")
