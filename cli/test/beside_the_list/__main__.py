#!/usr/bin/env python3
"""Random questions beside those that tests list: every command with small budgets, judged by what needs no trust in it.

Each finding is printed with a command that shows it and with its draw; `--seed S --first I --runs 1` repeats draw I of
seed S. Exit code 0 when nothing was found, 1 otherwise. Needs Python alone."""
import argparse
import json
import os
import random
import re
import resource
import shlex
import signal
import subprocess
import sys
import tempfile
import threading
import time

import generators
import judges

if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)  # exact numbers have as many digits as they need

LONGEST_WALL = 900  # seconds: a run that waits for itself


class Run:
    """A run of the program in a folder: how it ended, what it printed, what it used."""

    def __init__(self, program, arguments, folder, most_seconds):
        self.program, self.folder, self.most_seconds = program, folder, most_seconds
        limit = int(most_seconds) + 1
        with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
            child = subprocess.Popen([program, *arguments], stdin=subprocess.DEVNULL, stdout=output, stderr=errors,
                                     cwd=folder, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU,
                                                                                       (limit, limit)))
            timer = threading.Timer(LONGEST_WALL, os.kill, (child.pid, signal.SIGKILL))  # child.kill would wait for it
            timer.start()
            _, status, used = os.wait4(child.pid, 0)
            timer.cancel()
            child.returncode = self.code = os.waitstatus_to_exitcode(status)
            self.output, self.errors = (self.text(file) for file in (output, errors))
        self.seconds, self.mebibytes = used.ru_utime + used.ru_stime, used.ru_maxrss / 1024
        try:
            self.answer = json.loads(self.output)
        except ValueError:
            self.answer = None

    @staticmethod
    def text(file):
        file.seek(0)
        return file.read().decode("utf-8", "replace")

    def again(self, arguments):
        """Another run beside the same files."""
        return Run(self.program, arguments, self.folder, self.most_seconds)

    def ask(self, *arguments):
        """The JSON of another run, or None."""
        return self.again(arguments).answer


def shell_command(case):
    """What shows the case, in a shell."""
    files = "".join(f"printf %s {shlex.quote(text)} > {name} && " for name, text in case.files.items())
    return files + " ".join(map(shlex.quote, ["subcert", *case.arguments, *case.limits]))


def shortened(text):
    """What fits on a screen; the draw shows the rest."""
    return text if len(text) <= 2000 else text[:1000] + " ... " + text[-200:]


def judged(program, case, with_longer):
    """The run of a case and what was found."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in case.files.items():
            with open(os.path.join(folder, name), "w", encoding="ascii") as file:
                file.write(text)
        run = Run(program, [*case.arguments, *case.limits], folder, 8 * case.budget + 30)
        return run, list(judges.findings(case, run, with_longer))


def families_not_drawn(program):
    """Those of the help that have a number w and of which no question is asked."""
    text = subprocess.run([program, "mask", "--help"], capture_output=True, text=True, check=True).stdout
    with open(generators.__file__, encoding="utf-8") as file:
        drawn = file.read()
    names = re.findall(r"^  ([a-z-]+):w=", text, re.MULTILINE)
    return [name for name in names if f'"{name}' not in drawn] if names else ["none in the help"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="build/release/subcert")
    parser.add_argument("--runs", type=int, default=60, help="for each seed")
    parser.add_argument("--first", type=int, default=0, help="draw")
    parser.add_argument("--seed", type=int, nargs="+", default=[int(time.time())])
    parser.add_argument("--seconds", type=float, default=float("inf"), help="of wall clock; no run is begun later")
    parser.add_argument("--budget", type=float, nargs=2, default=(0.5, 3), metavar=("LOW", "HIGH"))
    parser.add_argument("--kind", choices=("regularity", "vector", "jsr", "range", "list", "page", "vertex"),
                        help="draw these only")
    parser.add_argument("--report", help="JSON lines, one for each finding")
    options = parser.parse_args()
    program, end = os.path.abspath(options.program), time.monotonic() + options.seconds
    draw = getattr(generators, f"{options.kind or 'any'}_case")
    report = open(options.report, "w", encoding="ascii") if options.report else None
    runs = found = 0
    for name in families_not_drawn(program):
        print(f"generators.py: no questions about {name}")
        found += 1
    for seed in options.seed:
        for i in range(options.first, options.first + options.runs):
            if time.monotonic() > end:
                break
            rng = random.Random(f"{seed}/{i}")
            case = draw(rng, *options.budget)
            run, findings = judged(program, case, rng.random() < 0.15)
            runs, found = runs + 1, found + len(findings)
            if runs % 500 == 0:
                print(f"{runs} runs, {found} findings", file=sys.stderr, flush=True)
            for kind, what in findings:
                print(f"{kind}: {what}\n  draw {i} of seed {seed}: {shortened(shell_command(case))}", flush=True)
                if report:
                    report.write(json.dumps({"kind": kind, "what": what, "seed": seed, "draw": i,
                                             "seconds": run.seconds, "command": shell_command(case)}) + "\n")
                    report.flush()
    print(f"{runs} runs, seed {' '.join(map(str, options.seed))}: {found} findings")
    sys.exit(1 if found else 0)


main()
