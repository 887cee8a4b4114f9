#!/usr/bin/env python3
"""Changes lines that decide, one at a time, and asks whether a test of that room notices.

Usage: mutants.py SOURCE BUILD [--sample N] [--seed S] [--room NAME]... [--file NAME]; BUILD is made by Ninja and up to date.
Draws 300 mutants by the seed, as many of each room, and tries the first N. Neither tree is written to: the changed
source, or the joined one that holds it, is compiled to a temporary object, which goes before the libraries when the
room's tests are linked. With --file only sources with this in their name are changed. A survivor that known_survivors.txt does not name with its reason is a failure; so is a line of
that file whose source is gone. Exit code 77 where BUILD was not made by Ninja.
"""
import argparse
import pathlib
import random
import re
import shlex
import subprocess
import sys
import tempfile
import time

DRAWN = 300
# Folders of sources (not those below) and the program that tests them.
ROOMS = {
    "properties": (["proofs-checks/properties"], "properties_tests"),
    "theorems": (["proofs-checks/theorems"], "theorems_tests"),
    "conjectures": (["proofs-checks/conjectures"], "conjectures_tests"),
    "statements": (["proofs-checks/statements", "proofs-checks/papers/dyn-2015",
                    "proofs-checks/papers/mustafa-bari-2016", "proofs-checks/papers/mustafa-hameed",
                    "proofs-checks/papers/mustafa-li-2015"], "statements_tests"),
    "experiments": (["reports/experiments", "reports/experiments/dyn-2015", "reports/experiments/mustafa-bari-2016",
                     "reports/experiments/mustafa-hameed", "reports/experiments/mustafa-li-2015"], "experiments_tests"),
    "reports": (["reports", "reports/formats"], "reports_tests"),
    "facts": (["reports/facts"], "facts_tests"),
    "families": (["schemes"], "schemes_tests"),
}
DECIDES = re.compile(r"\bif \(|\breturn\b|\?|&&|\|\||Truth::|Verdict::|\brequire\(|_of\(")
# Each with blanks around operators, as the formatter leaves them; a bracket of a template has none.
CHANGES = [(" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > "), (" == ", " != "), (" != ", " == "),
           (" && ", " || "), (" || ", " && "), (" + 1", " + 2"), (" - 1", " - 2"), ("Truth::yes", "Truth::no"),
           ("Truth::no", "Truth::unknown"), ("Truth::unknown", "Truth::yes"), ("return true", "return false"),
           ("return false", "return true"), ("(!", "("), ("std::min", "std::max"), ("std::max", "std::min"),
           (".lower", ".upper"), (".upper", ".lower"), (" * ", " + "), (" - ", " + ")]


def mutants_of(source, folders, part):
    """(file, number of the line, line, changed line) of every change of a deciding line."""
    for folder in folders:
        for path in sorted(one for one in (source / folder).glob("*.cpp") if part in one.name):
            for number, line in enumerate(path.read_text().split("\n")):
                code = line.split("//")[0]
                if not DECIDES.search(code) or code.lstrip().startswith(("#", "for (")):
                    continue
                quoted = [m.span() for m in re.finditer(r'"(?:\\.|[^"\\])*"', code)]
                for old, new in CHANGES:
                    for found in re.finditer(re.escape(old), code):
                        if not any(first <= found.start() < last for first, last in quoted):
                            yield path, number, line, line[:found.start()] + new + line[found.end():]


def draw(source, rooms, seed, part):
    """Of each room as many, in turn, each file in proportion to its changes."""
    generator = random.Random(seed)
    each = {room: list(mutants_of(source, ROOMS[room][0], part)) for room in rooms}
    for changes in each.values():
        generator.shuffle(changes)
    turns = [[(room, *change) for room, change in zip(rooms, turn)] for turn in zip(*each.values())]
    return [mutant for turn in turns for mutant in turn][:DRAWN]


class Room:
    """The commands that build a program of tests, and how long it takes unchanged."""

    def __init__(self, build, target):
        self.build = build
        listed = subprocess.run(["ninja", "-C", build, "-t", "commands", target], check=True, capture_output=True,
                                text=True).stdout.splitlines()
        self.compiles = [shlex.split(line) for line in listed if " -c " in line]
        link = shlex.split(next(line for line in listed if f"/{target} " in line and line.startswith(": && ")))[2:]
        self.link = link[:link.index("&&")]
        self.folder = (build / self.link[self.link.index("-o") + 1]).parent
        with tempfile.TemporaryDirectory() as folder:
            program = self.linked([], pathlib.Path(folder))
            start = time.monotonic()
            if not self.passes(program, 3600):
                sys.exit(f"{target} fails unchanged")
            self.seconds = time.monotonic() - start

    def linked(self, objects, folder):
        """The program with these objects before its libraries."""
        program = folder / "tests"
        words = list(self.link)
        words[words.index("-o") + 1] = str(program)
        words[1:1] = map(str, objects)
        subprocess.run(words, cwd=self.build, check=True, capture_output=True)
        return program

    def passes(self, program, seconds):
        try:
            return subprocess.run([program, "~[long]", "-a"], cwd=self.folder, timeout=seconds,
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0
        except subprocess.TimeoutExpired:
            return False

    def command_for(self, path):
        """The command that compiles this source, and the text of the source that it is given."""
        for command in self.compiles:
            given = pathlib.Path(command[command.index("-c") + 1])
            if given == path:
                return command, path.read_text()
            if "Unity" in given.parts and f'"{path}"' in given.read_text():
                return command, given.read_text()
        return None, ""

    def outcome(self, path, number, changed, folder):
        """killed, survived, or does not compile."""
        command, given = self.command_for(path)
        if not command:
            return "is not built"
        lines = path.read_text().split("\n")
        lines[number] = changed
        mutant, source, object_file = folder / path.name, folder / "given.cpp", folder / "mutant.o"
        mutant.write_text("\n".join(lines))
        if f'"{path}"' in given:
            source.write_text(given.replace(f'"{path}"', f'"{mutant}"'))
        else:
            source = mutant
        words = list(command)
        for flag, value in (("-c", source), ("-o", object_file), ("-MF", folder / "mutant.d")):
            words[words.index(flag) + 1] = str(value)
        words += ["-w", "-iquote", str(path.parent)]  # at the end: a launcher of the compiler may come first
        if subprocess.run(words, cwd=self.build, capture_output=True).returncode:
            return "does not compile"
        program = self.linked([object_file], folder)
        return "survived" if self.passes(program, 10 * self.seconds + 10) else "killed"


def known_survivors(source):
    """{(file, changed line): reason}, a line each: file ~ line ~ changed line ~ reason."""
    known = {}
    for entry in (pathlib.Path(__file__).parent / "known_survivors.txt").read_text().splitlines():
        if entry and not entry.startswith("#"):
            name, line, changed, reason = entry.split(" ~ ")
            if line not in [text.strip() for text in (source / name).read_text().split("\n")]:
                sys.exit(f"known_survivors.txt: {name} has no line '{line}' any more")
            known[name, changed] = reason
    return known


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("source", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("build", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--sample", type=int, default=DRAWN)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--room", action="append", choices=ROOMS)
    parser.add_argument("--file", default="")
    options = parser.parse_args()
    if not (options.build / "build.ninja").exists():
        sys.exit(77)
    known = known_survivors(options.source)
    counts, rooms, failures = {}, {}, 0
    for room, path, number, line, changed in draw(options.source, options.room or list(ROOMS), options.seed,
                                                   options.file):
        if counts.get("killed", 0) + counts.get("survived", 0) >= options.sample:
            break
        if room not in rooms:
            rooms[room] = Room(options.build, ROOMS[room][1])
        with tempfile.TemporaryDirectory() as folder:
            found = rooms[room].outcome(path, number, changed, pathlib.Path(folder))
        counts[found] = counts.get(found, 0) + 1
        name = str(path.relative_to(options.source))
        reason = known.get((name, changed.strip())) if found == "survived" else None
        failures += found == "survived" and not reason
        print(f"{found}: {name}:{number + 1}\n  - {line.strip()}\n  + {changed.strip()}"
              + (f"\n  known: {reason}" if reason else ""), flush=True)
    print(", ".join(f"{count} {found}" for found, count in counts.items()) + f"; {failures} survivors without a reason")
    return 1 if failures or not counts.get("killed") else 0


if __name__ == "__main__":
    sys.exit(main())
