#!/usr/bin/env python3
"""Wrong variants of checker.js: each must fail on a file of the corpus.

    wrong_variants.py NODE CORPUS [--only REGEX] [--lines FIRST-LAST] [--list]

A variant drops one check, or changes one comparison, condition, quantifier, rounding, end or sign. It is run on those cases
of the corpus that come to its place, the quickest first, until an outcome is wrong. Variants that no file can tell from the
checker stand in `same.txt`, each with its reason; they are run for two seconds. Prints the variants that survive; exit code 1
if there are any, or if a line of `same.txt` fits none."""
import argparse
import json
import shutil
import subprocess
import sys
import tempfile
import threading
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
QUICK = 2  # seconds for the variants of same.txt


class Reached:
    """The variants whose place a command line comes to, by number: what reached.js says, which is started once for a thread,
    without the optimizer, as the report leaves functions out that this has inlined."""

    def __init__(self, node, chosen):
        self.node, self.local, self.lock, self.started = node, threading.local(), threading.Lock(), []
        places = sorted((begin, number) for number, (_, _, begin, _, _) in chosen.items())
        self.numbers = [number for _, number in places]
        self.places = tempfile.NamedTemporaryFile("w", suffix=".json")
        json.dump([begin for begin, _ in places], self.places)
        self.places.flush()

    def __call__(self, folder, words):
        if not hasattr(self.local, "server"):
            self.local.server = subprocess.Popen([self.node, "--no-opt", test / "reached.js", self.places.name], stdin=subprocess.PIPE,
                                                 stdout=subprocess.PIPE, text=True)
            with self.lock:
                self.started.append(self.local.server)
        self.local.server.stdin.write(json.dumps([str(folder), words]) + "\n")
        self.local.server.stdin.flush()
        return {self.numbers[index] for index in json.loads(self.local.server.stdout.readline())}

    def close(self):
        for server in self.started:
            server.communicate()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("node")
    parser.add_argument("corpus", type=Path)
    arguments = variants.arguments_of(parser)
    # lines that count work and memory are left out: these limits are the checker's own
    every = list(variants.variants([sources / "checker.js"], CHANGES, "'`", ("spend(", "allow_bits(")))
    chosen = variants.chosen(every, arguments)
    known = set(variants.names_in(test / "same.txt"))
    checker = [arguments.node, "--max-old-space-size=2000"]
    trace = Reached(arguments.node, chosen)
    corpus = variants.Corpus(arguments.corpus.resolve(), trace, arguments.jobs, [*checker, sources / "main.js"], "")
    trace.close()

    def outcome(numbered):
        number, (name, file, begin, end, new) = numbered
        text = file.read_text()
        with tempfile.TemporaryDirectory() as folder:
            variant = Path(folder) / file.name
            variant.write_text(text[:begin] + new + text[end:])
            if not corpus.fails([*checker, shutil.copy(sources / "main.js", folder)], number, QUICK if name in known else None):
                return "survive"
            done = subprocess.run([arguments.node, "--check", variant], capture_output=True, check=False)
            return "do not compile" if done.returncode else "fail"

    return variants.report(chosen, outcome, corpus, arguments.jobs, every, test / "same.txt")


if __name__ == "__main__":
    sys.exit(main())
