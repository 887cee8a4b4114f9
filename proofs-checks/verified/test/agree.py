#!/usr/bin/env python3
"""Runs the verified checker and the one in C++ on a corpus of claims. Usage: agree.py VERIFIED CHECKER DIRECTORY

Claims about radii and subradii, about exponents of one mask or of a list, of schemes of vectors, and about lower ends for
values of a parameter: both print the same verdict, and `VERIFIED` in the same words. Of a corpus of right claims also with other bounds, with other exact numbers, and without what is claimed beside.
Other claims are never decided here."""
import re
import subprocess
import sys
import time
from fractions import Fraction
from pathlib import Path

verified, checker, directory = sys.argv[1], sys.argv[2], Path(sys.argv[3])
failures, counts, slowest = [], {}, 0.0
# Wrong for subcert-check, which takes vertices and bounds of a root as they are given: vertices are not said to be the
# images of others, or are those of others than true vertices; roots are given so roughly that a polynomial around the
# lower bound changes its sign too often, or may be zero, or that the bound is below that of an image. Here they are known
# so well that the claim, which is true, is proved; likewise an eigenvalue. That a radius is not negative needs no product here, denominators
# of blocks may be larger.
proved_here = {"origin-end", "same-beside-cycle", "single-recurrence-complex-sign", "single-no-pole-signs",
               "exact-image-above", "unit-norm-largest", "product-zero", "product-modulus", "reduced-product",
               "blocks-denominators",
               "kept-thirds-small", "kept-thirds-large", "kept-turns-small", "kept-turns-large",
               "kept-tiny-error",
               # what is 0 between the ends of an interval may be so at the ends of its halves
               "follow-inside",
                # the line `stability` of a range, or of a list, says nothing here
                "range-halved-61", "list-not-stable-lower", "list-stable-no-product", "list-stability"}
# Its solutions are multiples of one by the ends of the supports of the components, which are not looked at here; its masks
# keep polynomials at different places.
proved_there = {"vector-ends", "vector-list-places"}
# With large residuals, too, this checker proves a little more: it does not round norms of units up to integers.
sharper = {"unit-short", "unit-long"}
# Claims that are far from the truth: the same with a little more are true as well.
loose = {"turns-graph-close", "single-hat-square", "single-transfer", "upper-10000", "inverse-296-bits", "denominators",
         "list-wide", "list-in-turn", "list-stable", "list-spline-last", "list-first-alone", "list-arity-3-follows", "period",
         "corner-levels-half", "square-range", "quotient-converges", "quotient-denominators-coprime", "quotient-no-constant",
         "range-halved-60", "levels-dual", "levels-conic"}


def run(program, arguments):
    done = subprocess.run([program, *arguments], cwd=directory, capture_output=True, text=True, timeout=60)
    return done.returncode, done.stdout.strip()


def text_of(name):
    return (directory / f"{name.split()[0]}.cert").read_text(errors="replace")


def decided(name, arguments):
    options = {argument for argument in arguments if argument.startswith("--")}
    text = text_of(name)
    # Whether a word keeps a form.
    if "--exact" in options and " quadratic " in text and not re.search("\ncycle | single ", text):
        return False
    if options & {"--mask", "--masks"} and re.search(r"\nblock \d+ frequency ", text):
        return False
    if options & {"--matrices", "--subradius"}:
        return True
    # Lower ends of refinable functions of one variable, or of one of them, or both ends, or exact numbers, with the digits 0, 1, ...
    if "--refinable" in options:
        value = dict(zip(arguments[::2], arguments[1::2]))
        factor = re.fullmatch(r"\[([1-9]\d*)\]", value["--dilation"])
        digits = re.search(r"\ndigits(.*)\n", text)
        usual = factor and (not digits or digits[1].split() == [str(t) for t in range(int(factor[1]))])
        ends = options - {"--refinable", "--dilation"}
        asked = ends <= {"--component", "--lower", "--upper", "--exact"} and ends & {"--lower", "--exact"}
        return bool(asked and usual and "sqrt" not in value["--refinable"])
    # Schemes of vectors, and Hermite schemes, of one variable, with the digits 0, 1, ...: of one mask, and of lists of masks
    if options & {"--vectors", "--hermite"}:
        value = dict(zip(arguments[::2], arguments[1::2]))
        kind = "--vectors" if "--vectors" in options else "--hermite"
        digits = re.search(r"\ndigits(.*)\n", text)
        usual = not digits or digits[1].split() == [str(t) for t in range(int(value.get("--arity", 0)))]
        return options - {"--order"} == {kind, "--arity", "--lower"} and usual and "sqrt" not in value[kind]
    # Lower ends for all values of a parameter, for all sequences of them, or for those that follow from each other
    if options & {"--for", "--levels"}:
        follows = {"--recurrence", "--start", "--from"}
        return options in ({"--mask", "--arity", "--for", "--lower"}, {"--mask", "--arity", "--levels", "--lower"},
                           {"--mask", "--arity", "--levels", "--lower"} | follows)
    if "--masks" in options and not arguments[arguments.index("--order") + 1].startswith("period"):
        return "--upper" not in options
    subject = {"--masks", "--order", "--arity"} if "--masks" in options else {"--mask", "--arity"}
    ends = options - subject
    known = {"--lower", "--upper", "--exact", "--logarithm"}
    rough = "--upper" in options and arguments[arguments.index("--upper") + 1].startswith("C")
    if not subject <= options or not ends <= known or not (ends & {"--lower", "--exact"} or rough):
        return False
    # Of moduli of continuity those without a logarithm, if they follow from a norm, or from the only block; and those with
    # its first power that follow from a recurrence.
    if "--logarithm" in options and "\nlogarithm " in text:
        by_norm = re.search(r"^logarithm 0 norm ", text, re.MULTILINE)
        alone = "\nlogarithm 0\n" in text and "\nblocks " not in text and "\nlogarithm 0\nrecurrence " not in text
        double = "\nlogarithm 1\nrecurrence " in text and "\nblock 0 single " in text
        if not (by_norm or alone or double):
            return False
    return True


def compare(name, arguments, accepted=None):
    global slowest
    start = time.monotonic()
    mine = run(verified, arguments)
    slowest = max(slowest, time.monotonic() - start)
    word = mine[1].split(" ")[0]
    counts[word] = counts.get(word, 0) + 1
    if not decided(name, arguments) and (mine[0], word) == (2, "UNDECIDED"):
        return
    theirs = run(checker, arguments)
    if not decided(name, arguments):
        if not mine[0] == theirs[0] == 1:
            failures.append(f"{name}: {mine} and {theirs}")
        return
    same = mine == theirs if theirs[0] != 1 else mine[0] == theirs[0] == 1 and word == "REJECTED" and ", line " in mine[1]
    # what is wrong about a logarithm is not seen where none is claimed
    beside = "--logarithm" not in arguments and "\nlogarithm " in text_of(name)
    if mine[0] == 0 and directory.name == "reject" and (beside or name in proved_here):
        return
    if (mine[0], theirs[0]) == (0, 1) and name.split()[0] in sharper:
        return
    if (mine[0], theirs[0]) == (1, 0) and name.split()[0] in proved_there:
        return
    far = name.split()[0] in loose or name.startswith("follow-")
    expected = mine[0] == 0 if accepted is None or (far and not accepted) else accepted
    if not same or (expected != (mine[0] == 0) and mine[0] != 64):
        failures.append(f"{name}: {mine} and {theirs}")


def without(option, arguments):
    at = arguments.index(option) if option in arguments else len(arguments)
    return arguments[:at] + arguments[at + 2:]


for line in (directory / "claims.txt").read_text().splitlines():
    name, *arguments = line.partition(" | ")[0].split()
    compare(name, [*arguments, f"{name}.cert"])
    if {"--refinable", "--exact"} <= set(arguments) and decided(name, arguments) and directory.name == "accept":
        number = arguments[arguments.index("--exact") + 1]
        alone = without("--lower", without("--upper", arguments))
        compare(f"{name} alone", [*alone, f"{name}.cert"], True)
        for old, new in (("|[", "|[7,"), ("]@", ",7]@"), ("^1/", "^1/1"), ("0-log", "1-log")):
            compare(f"{name} with {new}", [*(a.replace(old, new) if a == number else a for a in alone), f"{name}.cert"], False)
        for key, end, accepted in (("--lower", 0, False), ("--lower", 100, False), ("--upper", 0, False)):
            compare(f"{name} with {key} {end}", [*alone, key, str(end), f"{name}.cert"], accepted)
        arguments = without("--exact", arguments)
    if {"--refinable", "--lower"} <= set(arguments) or ({"--vectors", "--hermite"} & set(arguments) and decided(name, arguments)):
        alone = without("--upper", arguments)
        at = alone.index("--lower") + 1
        for end in (Fraction(alone[at]), Fraction(alone[at]) * Fraction(6, 7), Fraction(alone[at]) + Fraction(1, 10)):
            compare(f"{name} from {end}", [*alone[:at], str(end), *alone[at + 1:], f"{name}.cert"])
        if "--upper" in arguments:
            at = arguments.index("--upper") + 1
            for end in (Fraction(arguments[at]) + Fraction(1, 7), Fraction(arguments[at]) - Fraction(1, 1000), Fraction(1000)):
                compare(f"{name} to {end}", [*arguments[:at], str(end), *arguments[at + 1:], f"{name}.cert"])
        continue
    if "--exact" in arguments and directory.name == "accept":
        number = arguments[arguments.index("--exact") + 1]
        alone = without("--lower", without("--upper", arguments))
        compare(f"{name} alone", [*alone, f"{name}.cert"], decided(name, alone) or None)
        for old, new in (("|[", "|[7,"), ("]@", ",7]@"), ("^1/", "^1/1")):
            changed = [a.replace(old, new) if a == number else a for a in arguments]
            compare(f"{name} with {changed}", [*changed, f"{name}.cert"], False if decided(name, changed) else None)
        if "--logarithm" in arguments:
            at = arguments.index("--logarithm") + 1
            changed = arguments[:at] + [str(int(arguments[at]) + 1)] + arguments[at + 1 :]
            compare(f"{name} with {changed}", [*changed, f"{name}.cert"], False if decided(name, changed) else None)
        arguments = without("--logarithm", without("--exact", arguments))
        if "--lower" in arguments or {"--subradius", "--upper"} <= set(arguments):
            compare(name, [*arguments, f"{name}.cert"])
    if {"--mask", "--masks"} & set(arguments) and decided(name, arguments) and directory.name == "accept":
        alone = without("--upper", arguments)
        for bounded in [alone] * decided(name, alone) + [arguments]:
            compare(f"{name} as {bounded}", [*bounded, f"{name}.cert"], True)
            for key, sign in (("--lower", 1), ("--upper", -1)):
                if key in bounded:
                    at = bounded.index(key) + 1
                    if bounded[at].startswith("C"):
                        for order, accepted in ((int(bounded[at][1:]) + 1, True), (int(bounded[at][1:]) - 1, False)):
                            compare(f"{name} with C{order}", [*bounded[:at], f"C{order}", *bounded[at + 1:], f"{name}.cert"], accepted)
                        continue
                    for step, accepted in ((Fraction(1, 1000), None), (Fraction(1, 10), False), (Fraction(-1, 7), True)):
                        end = Fraction(bounded[at]) + sign * step
                        changed = [*bounded[:at], str(end), *bounded[at + 1:]]
                        # exponents of claims are from 0 to 10000
                        compare(f"{name} with {key} {end}", [*changed, f"{name}.cert"], accepted if 0 <= end <= 10000 else False)
    # how far the vertices of a subradius prove more than is claimed is not asked
    subradius = "--subradius" in arguments
    if (subradius or "--matrices" in arguments) and len(arguments) > 2 and directory.name == "accept":
        worse = None if subradius else False
        value = {key: Fraction(arguments[arguments.index(key) + 1]) for key in ("--lower", "--upper") if key in arguments}
        for key, step in (("--lower", Fraction(1, 1000)), ("--upper", Fraction(-1, 1000))):
            if key in value:
                changed = list(arguments)
                changed[arguments.index(key) + 1] = str(value[key] + step)
                compare(f"{name} with another {key}", [*changed, f"{name}.cert"], worse)
        flipped = [{"--lower": "--upper", "--upper": "--lower"}.get(a, a) for a in arguments]
        if len(value) == 2 and value["--lower"] != value["--upper"]:
            compare(f"{name} with its bounds exchanged", [*flipped, f"{name}.cert"], False)
        for key in value if subradius and len(value) == 2 else []:
            compare(f"{name} without {key}", [*without(key, arguments), f"{name}.cert"], True)

print(", ".join(f"{count} {word}" for word, count in sorted(counts.items())), f"- the slowest took {slowest:.2f} s,",
      f"{len(failures)} failures")
for failure in failures:
    print(failure)
sys.exit(bool(failures) or not counts)
