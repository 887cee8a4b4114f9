#!/usr/bin/env python3
"""./reproduce and ./check look at all arguments before they install or build anything.

Usage: arguments.py SOURCE PROGRAM. The scripts run in a copy with tools that only leave a trace.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

source, program = pathlib.Path(sys.argv[1]), sys.argv[2]
folder = pathlib.Path(tempfile.mkdtemp())
tools, trace, built = folder / "tools", folder / "trace", folder / "build/release/subcert"


def script(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("#!/bin/sh\n" + text)
    path.chmod(0o755)


def run(command, *arguments):
    """Exit code, last line of errors, and what was run."""
    trace.write_text("")
    environment = {"PATH": f"{tools}:/usr/bin:/bin", "HOME": str(folder)}
    ran = subprocess.run([folder / command, *arguments], env=environment, capture_output=True, text=True, check=False)
    return ran.returncode, ran.stderr.strip(), trace.read_text().splitlines()


for name in ["reproduce", "check", "cmake/setup.sh"]:
    (folder / name).parent.mkdir(exist_ok=True)
    shutil.copy(source / name, folder / name)
for name in ["cmake", "ninja", "ctest", "sudo", "apt-get", "dpkg-query"]:
    script(tools / name, f'echo "{name} $*" >>{trace}\n[ {name} != dpkg-query ] || echo installed\n')
script(tools / "python3", "exit 0\n")
script(built, f'echo "subcert $*" >>{trace}\n')

WRONG = [
    ("reproduce", "--nonsense"), ("reproduce", "--nonsense", "--no-install"), ("reproduce", "--no-install", "dyn-2016"),
    ("reproduce", "dyn-2015", "--only"), ("reproduce", "--jobs", "two"), ("reproduce", "--seed=-1"),
    ("reproduce", "--budget", "1.2.3"), ("reproduce", "--budget", "nan"), ("reproduce", "--out", ""),
    ("reproduce", "--baseline", "nowhere"), ("reproduce", "--out", "a", "--Only=table1"), ("reproduce", ""),
    ("check", "--long", "--nonsense"), ("check", "--no-install", "long"), ("check", "--sanitize", "--long"),
    ("check", ""),
]
for command, *arguments in WRONG:
    code, errors, traces = run(command, *arguments)
    assert code == 64 and errors.startswith(f"{command}: ") and "\n" not in errors, (command, arguments, code, errors)
    assert not traces, (command, arguments, traces)


def last_of(*arguments):
    code, errors, traces = run("reproduce", *arguments)
    assert code == 0 and not errors, (arguments, code, errors)
    return traces[-1]


assert last_of() == "subcert reproduce --out out"
assert last_of("dyn-2015", "--out", "mine") == "subcert reproduce dyn-2015 --out mine"
both = ["dyn-2015", "jsr", "--only=table1", "--out=mine"]
assert last_of(*both) == "subcert reproduce " + " ".join(both)
assert last_of("--seed", "7", "--budget", "0.5") == "subcert reproduce --out out --seed 7 --budget 0.5"
for command in ["reproduce", "check"]:
    for arguments in [["--no-install"], ["--help"]]:
        code, _, traces = run(command, *arguments)
        assert code == 0 and all(one.startswith("dpkg-query") for one in traces), traces
listed = subprocess.run([folder / "reproduce", "--no-install"], env={"PATH": f"{tools}:/usr/bin:/bin"}, check=True,
                        capture_output=True, text=True).stdout
assert listed == "missing packages: none\n", listed
assert run("reproduce", "dyn-2015", "--no-install")[2][-1].startswith("dpkg-query")
assert run("check", "--long")[2][-1].startswith("ctest") and "-LE long" not in run("check", "--long")[2][-1]
assert "-LE long" in run("check")[2][-1]

# Every paper and every option of the program is known to the script.
text = subprocess.run([program, "reproduce", "--help"], capture_output=True, text=True, check=True).stdout
papers = re.search(r"collections: (.*?) \(default", re.sub(r"\s+", " ", text))[1].split(", ")
assert last_of(*papers) == "subcert reproduce --out out " + " ".join(papers)
values = {"--out": "x", "--only": "x", "--jobs": "1", "--seed": "1", "--budget": "1", "--baseline": str(folder)}
(folder / "results.json").write_text("{}")
options = re.findall(r"^  (?:-h,)?(--[a-z]+)", text, re.M)
assert {*values, "--help", "--json", "--quiet"} == set(options), options
for option, value in values.items():
    assert last_of(option, value).endswith(f"{option} {value}"), option
for option in ["--json", "--quiet"]:
    assert last_of(option).endswith(option)
shutil.rmtree(folder)
