#!/usr/bin/env python3
"""Branches of the checker's sources that the corpus takes: all but those on the lines of `branches.txt`.

    branches.py COMPILER GMP_FLAGS BUILD CORPUS

COMPILER is g++, GMP_FLAGS one argument. The sources are compiled with --coverage in the folder BUILD, the whole corpus is
run, and gcov counts. A condition that is evaluated, but always with one outcome, and a line that is never reached must
stand in `branches.txt`, with their number and a reason, and no others. Not counted: what only an exception leads to, which
exception is caught, and destructors at the end of a block. Made for g++ 12."""
import collections
import functools
import gzip
import json
import re
import shlex
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

compiler, flags, build, corpus = sys.argv[1], shlex.split(sys.argv[2]), Path(sys.argv[3]).resolve(), Path(sys.argv[4])
test = Path(__file__).resolve().parent
sources = test.parent
files = {file.name: file for file in sources.rglob("*.[ch]pp") if test not in file.parents}
libraries = [flag for flag in flags if not flag.startswith("-I")]
includes = [flag for flag in flags if flag.startswith("-I")]
shutil.rmtree(build, ignore_errors=True)
build.mkdir(parents=True)


def compile_one(source):
    # -O0: one branch for each condition of the text; NDEBUG: with the caps of main.cpp
    line = [compiler, "-std=c++20", "-O0", "-DNDEBUG", "--coverage", f"-I{sources}", *includes, "-c", source]
    subprocess.run([*line, "-o", build / f"{source.stem}.o"], check=True)


with ThreadPoolExecutor(2) as pool:
    list(pool.map(compile_one, (file for file in files.values() if file.suffix == ".cpp")))
program = build / "subcert-check"
subprocess.run([compiler, "--coverage", *build.glob("*.o"), "-o", program, *libraries], check=True)
for mode, folder in (("accept", "accept"), ("reject", "reject"), ("usage", "accept")):
    subprocess.run([sys.executable, "-B", test / "run_corpus.py", program, mode, corpus / folder], check=True)
# a claim that cannot be printed
with open("/dev/full", "w", encoding="ascii") as full:
    for words in (["--help"], ["--matrices", "golden.mat", "--upper", "2", "golden.cert"]):
        assert subprocess.run([program, *words], cwd=corpus / "accept", stdout=full, check=False).returncode == 1

gcov = re.sub(r"(g\+\+|c\+\+|gcc)(?=[^/]*$)", "gcov", compiler)
subprocess.run([gcov, "--branch-probabilities", "--json-format", *build.glob("*.gcda")], cwd=build, check=True,
               stdout=subprocess.DEVNULL)


@functools.lru_cache
def lines_of(name):
    return files[name].read_text().splitlines()


taken, runs = collections.Counter(), collections.Counter()  # of (file, line, what of the line), of (file, line)
for report in build.glob("*.gcov.json.gz"):
    for entry in json.loads(gzip.decompress(report.read_bytes()))["files"]:
        file = Path(entry["file"])
        for line in entry["lines"] if files.get(file.name) == file.resolve() else []:
            at = file.name, line["line_number"]
            text = lines_of(at[0])[at[1] - 1].strip()
            if text in ("}", "};"):  # destructors
                continue
            branches = [] if text.startswith("} catch") else line["branches"]
            runs[at] += line["count"]
            assert len(branches) % 2 == 0, f"{at}: a condition with more than two outcomes"
            for i, branch in enumerate(branches):
                if not branch["throw"] and not branches[i ^ 1]["throw"]:
                    taken[(*at, len(branches), i)] += branch["count"]
missing = collections.Counter(at for at, count in runs.items() if count == 0)
for (name, line, size, i), count in taken.items():
    missing[name, line] += count == 0 and taken[name, line, size, i ^ 1] > 0
found = {}
for (name, number), count in sorted((+missing).items()):
    found.setdefault(f"{name}: {count} in: {lines_of(name)[number - 1].strip()}", []).append(number)
named = {line.rpartition(" # ")[0] for line in (test / "branches.txt").read_text().splitlines() if " # " in line}
new, gone = [key for key in found if key not in named], sorted(named - set(found))
for key in new:
    print(f"not taken on every side, line {', '.join(map(str, found[key]))} of {key}")
for key in gone:
    print(f"branches.txt, but not so: {key}")
evaluated = sum(count > 0 or taken[(*at, i ^ 1)] > 0 for (*at, i), count in taken.items())
print(f"{sum(count > 0 for count in taken.values())} of {evaluated} branches taken; of {len(runs)} lines "
      f"{sum(count == 0 for count in runs.values())} not reached; {len(found)} lines named or new")
sys.exit(bool(new or gone))
