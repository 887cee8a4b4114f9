#!/usr/bin/env python3
"""Runs the verified checker and the one in C++ on a corpus of claims. Usage: agree.py VERIFIED CHECKER DIRECTORY

Claims about radii: both print the same verdict, and `VERIFIED` in the same words; with flipped bounds both reject. Other
claims are never decided here."""
import subprocess
import sys
import time
from fractions import Fraction
from pathlib import Path

verified, checker, directory = sys.argv[1], sys.argv[2], Path(sys.argv[3])
failures, counts, slowest = [], {}, 0.0


def run(program, arguments):
    done = subprocess.run([program, *arguments], cwd=directory, capture_output=True, text=True, timeout=60)
    return done.returncode, done.stdout.strip()


def compare(name, arguments, accepted=None):
    global slowest
    start = time.monotonic()
    mine = run(verified, arguments)
    slowest = max(slowest, time.monotonic() - start)
    word = mine[1].split(" ")[0]
    counts[word] = counts.get(word, 0) + 1
    if "--matrices" not in arguments or "--exact" in arguments:
        if mine[0] != 2 or word != "UNDECIDED":
            failures.append(f"{name}: {mine}")
        return
    theirs = run(checker, arguments)
    same = mine == theirs if theirs[0] == 0 else mine[0] == theirs[0] == 1 and word == "REJECTED" and ", line " in mine[1]
    if not same or (accepted is not None and accepted != (mine[0] == 0)):
        failures.append(f"{name}: {mine} and {theirs}")


for line in (directory / "claims.txt").read_text().splitlines():
    name, *arguments = line.partition(" | ")[0].split()
    compare(name, [*arguments, f"{name}.cert"])
    if "--exact" in arguments:  # the bounds alone, where the lines about the exact number are right
        at = arguments.index("--exact")
        del arguments[at:at + 2]
        if directory.name == "accept" and len(arguments) > 2:
            compare(name, [*arguments, f"{name}.cert"])
    if "--matrices" in arguments and len(arguments) > 2 and directory.name == "accept":
        value = {key: Fraction(arguments[arguments.index(key) + 1]) for key in ("--lower", "--upper") if key in arguments}
        for key, step in (("--lower", Fraction(1, 1000)), ("--upper", Fraction(-1, 1000))):
            if key in value:
                changed = list(arguments)
                changed[arguments.index(key) + 1] = str(value[key] + step)
                compare(f"{name} with another {key}", [*changed, f"{name}.cert"], False)
        flipped = [{"--lower": "--upper", "--upper": "--lower"}.get(a, a) for a in arguments]
        if len(value) == 2 and value["--lower"] != value["--upper"]:
            compare(f"{name} with its bounds exchanged", [*flipped, f"{name}.cert"], False)

print(", ".join(f"{count} {word}" for word, count in sorted(counts.items())), f"- the slowest took {slowest:.2f} s,",
      f"{len(failures)} failures")
for failure in failures:
    print(failure)
sys.exit(bool(failures) or not counts)
