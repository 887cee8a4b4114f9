#!/usr/bin/env python3
"""The program with little memory, and asked for too much: it works, or says so in one line and leaves with the right code.

Usage: memory.py SUBCERT [long]. Main commands in 2 GB of address space end as without a limit; in less, with `long` down to
what loads the program, they may also end with exit code 70 and a line that says so.
"""
import os
import resource
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

program, is_long = os.path.abspath(sys.argv[1]), sys.argv[2:] == ["long"]
COMMANDS = """analyze primal:n=5
regularity primal:n=12 --budget 5
regularity primal:n=5 --certificate s5.cert
regularity loop
analyze catmull-clark --plot loop.png
jsr pair.json
jsr big.json --budget 2
range four-point:w --over w=1/20..1/4 --property convergent
smooth data.csv --auto
refine primal:n=2 data.csv --levels 15
limit primal:n=3 --level 15
variance primal:n=20
conjecture 7 --n 1..6
gallery loop primal:n=3 --out page.html
reproduce dyn-2015 --only masks,fig1 --out out
mask tensor:(primal:n=40)x(primal:n=40)
regularity primal:n=200 --budget 2
analyze primal:n=150 --jobs 1024
statements check dyn-2015/eq-2""".splitlines()
# Their answers go out as they are made: they end well in little memory, whatever the levels.
STREAMED = """refine primal:n=2 data.csv --levels 18 --jobs 1 --out fine.csv
refine primal:n=2 data.csv --levels 18 --jobs 1 --out fine.csv --boundary nearest
refine primal:n=2 data.csv --levels 18 --jobs 1 --out fine.csv --boundary constant""".splitlines()
TOO_MUCH = """analyze bspline:degree=1000000000
analyze primal:n=100000000
mask ary:a=1000000000,points=4,d=3
analyze grid:points=1000x1000,d=3
mask tensor:(primal:n=2047)x(primal:n=2047)
analyze mask:[1,1]/1@-1,arity=1000000000
mask mask:[10^1000000000,1]
analyze mask2:[[1,1],[1,1]]/4,dilation=[1000000,0;0,1000000]
limit primal:n=3 --level 60
refine primal:n=2 data.csv --levels 60
refine primal:n=2 data.csv --levels 1000000000
smooth data.csv --scheme primal:n=2 --level 60
conjecture 7 --n 1..100000000
regularity primal:n=3 --levels 1000000000
regularity primal:n=3 --width 1e-1000000000
curve four-point:w --over w=0..1/4 --pieces 100000000
experiment fig3 --runs 1000000000
limit bspline:degree=3 --derivative 1000000000""".splitlines()
failures = []


def run(case):
    command, megabytes = case
    with tempfile.TemporaryDirectory() as place:
        for name, text in FILES.items():
            (Path(place) / name).write_text(text)
        done = subprocess.run([program, *command.split()], cwd=place, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              check=False, timeout=900,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20,) * 2))
        left = [path for path in Path(place).rglob("*.part*") if done.returncode != 70]
    lines = done.stderr.splitlines()
    one_line = len(lines) == 1 and lines[0].startswith("subcert: ")
    if command in TOO_MUCH:
        good = done.returncode == 64 and one_line
    elif megabytes >= 2000 or command in STREAMED and megabytes >= 80:
        good = done.returncode in (0, 2) and not lines
    else:  # other programs that it starts, and their files, may fail first
        good = done.returncode in (0, 2) and not lines or done.returncode in (66, 70) and one_line
    if not good or left:
        failures.append(f"{megabytes} MB: subcert {command}\n  exit {done.returncode}, {done.stderr[-400:]!r}")
    return done.returncode


FILES = {"data.csv": "x,y\n" + "".join(f"{i},{i * i % 7}\n" for i in range(12)),
         "pair.json": '{"matrices": [[["1","1"],["0","1"]], [["1","0"],["1","1"]]]}\n',
         "big.json": '{"matrices": [%s]}\n' % ", ".join(
             "[%s]" % ", ".join("[%s]" % ", ".join(str((i * i + 7 * i * k + 3 * k + t) % 19 - 9) for k in range(60))
                                for i in range(60)) for t in range(3))}
with ThreadPoolExecutor(2) as pool:
    for megabytes in [2000, 400, 200, 150, 110, 80, 65, 55] if is_long else [2000, 100]:
        commands = [command for command in COMMANDS if is_long or "--budget" not in command]
        commands += TOO_MUCH if megabytes == 2000 else STREAMED
        codes = list(pool.map(run, [(command, megabytes) for command in commands]))
        print(megabytes, "MB:", ", ".join(f"{codes.count(code)} times {code}" for code in sorted(set(codes))), flush=True)
print(len(failures), "failures")
print(*failures[:20], sep="\n")
sys.exit(bool(failures))
