#!/usr/bin/env python3
"""Wrong variants of checker.js: each must fail on a file of the corpus.

    wrong_variants.py NODE CORPUS [--only REGEX] [--lines FIRST-LAST] [--list]

A variant drops one check, or changes one comparison, condition, quantifier, rounding, end or sign. It is run on those cases
of the corpus that come to its place, the quickest first, until an outcome is wrong, or for 10 s. Variants that no file can
tell from the checker stand in `same.txt`, each with its reason. Prints the variants that survive; exit code 1 if there are
any, or if a line of `same.txt` fits none."""
import argparse
import itertools
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

test = Path(__file__).resolve().parent
sources = test.parent
sys.path.append(str(sources.parent / "checker" / "test"))

import variants  # noqa: E402

# What is looked for, what stands in its place, and what the variant does. Nothing is NaN: `a && b` becomes `a === NaN || b`.
CHANGES = [
    (r"\bdemand\(", "(() => {})(", "no check"),
    (r"(?:(?<=\n) +|(?<=\)) )(?=check_\w+\()", " 0 && ", "a hypothesis of the claim is not checked"),
    (r" <= ", " < ", "<= -> <"),
    (r" >= ", " > ", ">= -> >"),
    (r" < ", " <= ", "< -> <="),
    (r" > ", " >= ", "> -> >="),
    (r" === ", " !== ", "=== -> !=="),
    (r" !== ", " === ", "!== -> ==="),
    (r" && ", " === NaN || ", "&& -> the right side alone"),
    (r" \|\| ", " === NaN || ", "|| -> the right side alone"),
    (r"\.every\(", ".some(", "every -> some"),
    (r"\.some\(", ".every(", "some -> every"),
    (r" \+ 1n?\b", "", "+ 1 -> nothing"),
    (r" - 1n?\b", "", "- 1 -> nothing"),
    (r"\bfloor_div\(", "ceil_div(", "floor_div -> ceil_div"),
    (r"\bceil_div\(", "floor_div(", "ceil_div -> floor_div"),
    (r"Math\.floor\(", "Math.ceil(", "floor -> ceil"),
    (r"Math\.ceil\(", "Math.floor(", "ceil -> floor"),
    (r"\bmodulus_below\(", "modulus_above(", "modulus_below -> modulus_above"),
    (r"\bmodulus_above\(", "modulus_below(", "modulus_above -> modulus_below"),
    (r"\bround_up\(", "(", "round_up -> nothing"),
    (r"(?<!function )\broot\(", "1n + root(", "root -> one more"),
    (r"Math\.max\(", "Math.min(", "max -> min"),
    (r"Math\.min\(", "Math.max(", "min -> max"),
    (r"(?<!\.)\bmax\(", "((x, y) => x < y ? x : y)(", "max -> min"),
    (r"Math\.abs\(", "(", "abs -> nothing"),
    (r"(?<!\.)\babs(_of)?\(", "(", "abs -> nothing"),
    (r" \+= ", " -= ", "+= -> -="),
    (r" -= ", " += ", "-= -> +="),
]


def reached(coverage, chosen):
    """The numbers of the variants whose place a run came to: the innermost range of V8's report around it counts."""
    scripts = json.loads(coverage.read_text())["result"]
    functions = next(script["functions"] for script in scripts if script["url"].endswith("/checker.js"))
    ranges = sorted((r["startOffset"], -r["endOffset"], r["count"]) for function in functions for r in function["ranges"])
    places = sorted((begin, number) for number, (_, _, begin, _, _) in chosen.items())
    numbers, first = {}, 0
    for start, end, count in ranges:
        while first < len(places) and places[first][0] < start:
            first += 1
        for begin, number in itertools.islice(places, first, None):
            if begin >= -end:
                break
            numbers[number] = count
    return {number for number, count in numbers.items() if count > 0}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("node")
    parser.add_argument("corpus", type=Path)
    arguments = variants.arguments_of(parser)
    # lines that count work and memory are left out: these limits are the checker's own
    every = list(variants.variants([sources / "checker.js"], CHANGES, "'`", ("spend(", "allow_bits(")))
    chosen = variants.chosen(every, arguments)

    def trace(folder, words):
        with tempfile.TemporaryDirectory() as coverage:
            subprocess.run([arguments.node, sources / "main.js", *words], cwd=folder, capture_output=True, check=False,
                           env={**os.environ, "NODE_V8_COVERAGE": coverage})
            return reached(next(Path(coverage).iterdir()), chosen)

    corpus = variants.Corpus(arguments.corpus.resolve(), trace, arguments.jobs)

    def fails(number, main_js, seconds):
        return corpus.fails([arguments.node, "--max-old-space-size=2000", main_js], number, f"ulimit -t {seconds}")

    # One process has all cases of a folder: as long as the checker itself takes, and half as much again.
    before = sum(os.times()[2:4])
    if fails(0, sources / "main.js", 600):
        sys.exit("the checker itself fails")
    most = math.ceil(1.5 * (sum(os.times()[2:4]) - before)) + 10

    def outcome(numbered):
        number, (_, file, begin, end, new) = numbered
        text = file.read_text()
        with tempfile.TemporaryDirectory() as folder:
            variant = Path(folder) / file.name
            variant.write_text(text[:begin] + new + text[end:])
            if not fails(number, shutil.copy(sources / "main.js", folder), most):
                return "survive"
            done = subprocess.run([arguments.node, "--check", variant], capture_output=True, check=False)
            return "do not compile" if done.returncode else "fail"

    return variants.report(chosen, outcome, corpus, arguments.jobs, every, test / "same.txt")


if __name__ == "__main__":
    sys.exit(main())
