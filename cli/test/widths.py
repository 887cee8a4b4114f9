#!/usr/bin/env python3
"""Help, and answers that people read, are at most 100 columns wide, but for words that are longer: of every command its
help, its example as help names it, and answers that were too wide.

Usage: widths.py SUBCERT
"""
import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

program = os.path.abspath(sys.argv[1])
WIDTH = 100
# what is read by programs: a script for a shell, and claims, one a line, to be asked again
NOT_FOR_PEOPLE = {"completion", "verify"}
# examples that compute for minutes
SHORTER = {"--n 1..40 --d 1,3,5": "--n 1..3 --d 1", "--plot map.svg": "--resolution 2", "fig5 --seed 7": "fig5 --runs 5",
           "--plot curve.svg": "--pieces 8", "primal:n=1..20,d={1,3}": "primal:n=1..3,d={1,3}"}
MORE = [
    "range 'mask:[mu,1/3,2/3,1-2mu,2/3,1/3,mu],arity=3' --over mu=-1..1 --property C1",
    "range corner-cutting:w --over w=0..1 --property convergent",
    "range 'mask:[w,1/2-w,1/2,1/2,1/2-w,w]' --over w=-1..1 --property C1",
    "statements check mustafa-bari-2016", "statements check dyn-2015/conjecture-7-slope", "statements list",
    "theorem list", "theorem limit-constants --d 1 --budget 1", "analyze loop", "analyze ghm", "analyze l1:points=6,d=1",
    "levels four-point:w --over w=1/32..1/8 --property C1 --boxes 2",
    "regularity primal:n=12", "regularity butterfly:w=1/16", "compare chaikin dd:n=2 dd:n=3 dual:n=3",
    "reproduce dyn-2015 --only table3", "vertex butterfly --valence 3..12", "conjecture 8 --n 1..2 --d 1",
]
FILES = {
    "samples.csv": "x,y\n" + "".join(f"{i},{i * i % 7}\n" for i in range(40)),
    "pair.json": '{"matrices": [[["1","1"],["0","1"]], [["1","0"],["1","1"]]]}',
    "my-schemes.toml": "[[scheme]]\nmask = 'dd:n=2'\nholder = '>= 2'\n",
}
failures = []


def answer(command):
    done = subprocess.run(f"{shlex.quote(program)} {command}", shell=True, capture_output=True, text=True, timeout=600,
                          check=False)
    if done.returncode not in (0, 1, 2, 3):
        failures.append(f"subcert {command}: exit {done.returncode}, {done.stderr}")
    return done.stdout


def check(command, text):
    for line in text.splitlines():
        indent = len(line) - len(line.lstrip())
        if len(line) > max(WIDTH, indent + max(map(len, line.split()), default=0)):
            failures.append(f"subcert {command}: {len(line)} columns: {line}")


def commands():
    def named(text):
        return re.findall(r"^  ([a-z0-9]+) ", text[text.index("\nSubcommands:"):].split("\n\n")[0], re.M)

    for name in named(answer("--help")):
        text = answer(name + " --help")
        yield from (f"{name} {below}" for below in named(text)) if "\nSubcommands:" in text else [name]


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    for name, text in FILES.items():
        Path(name).write_text(text, encoding="utf-8")
    answer("conjecture 7 --n 1..2 --d 1 --journal shard-1.journal")
    check("--help", answer("--help"))
    names = list(commands())
    for name in names:
        text = answer(name + " --help")
        check(name + " --help", text)
        example = re.search(r"\nExample:\n  subcert (.*?)(?:   .*)?\n", text + "\n")
        if not example:
            failures.append(f"subcert {name} --help: no example")
        elif name not in NOT_FOR_PEOPLE:
            command = example[1]
            for long, short in SHORTER.items():
                command = command.replace(long, short)
            check(command, answer(command))
    for command in MORE:
        check(command, answer(command))

print(f"{len(names)} commands, {len(MORE)} more answers")
sys.exit("\n".join(failures) if failures else 0)
