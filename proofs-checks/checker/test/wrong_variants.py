#!/usr/bin/env python3
"""Wrong variants of the checker's sources: each must fail on a file of the corpus.

    wrong_variants.py COMPILER GMP_FLAGS BUILD [--checks] [--only REGEX] [--list]

A variant drops one check, or changes one comparison, rounding, end or sign. It is compiled, and run on the corpus until
an outcome is wrong. Variants that no file can tell from the checker stand in `same.txt`, each with its reason. Prints the
variants that survive; exit code 1 if there are any, or if a line of `same.txt` fits none."""
import argparse
import concurrent.futures
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

test = Path(__file__).resolve().parent
sources = test.parent

# What is replaced by what, everywhere it occurs in code: a wrong comparison, end, rounding or sign.
CHANGES = [
    (r" <= ", " < "),
    (r" >= ", " > "),
    (r"(?<!operator) < (?!=)", " <= "),
    (r" > (?!=)", " >= "),
    (r" == ", " != "),
    (r" && ", " || "),
    (r" \+ 1\b", ""),
    (r" - 1\b", ""),
    (r"mpz_cdiv_q\b", "mpz_fdiv_q"),
    (r"mpz_fdiv_q\b", "mpz_cdiv_q"),
    (r"std::max\(", "std::min("),
    (r"max_element", "min_element"),
    (r"\babs\(", "mpz_class("),
    (r" \+= ", " -= "),
]


def statement_end(text, begin):
    """Where the parenthesis that opens at `begin` closes."""
    depth, quoted = 0, None
    for i in range(begin, len(text)):
        c = text[i]
        if quoted:
            quoted = None if c == quoted and text[i - 1] != "\\" else quoted
        elif c in "\"'":
            quoted = c
        elif c == "(":
            depth += 1
        elif c == ")":
            depth -= 1
            if depth == 0:
                return i
    raise ValueError("no closing parenthesis")


def is_code(text, at):
    line = text[text.rfind("\n", 0, at) + 1 : text.find("\n", at)]
    stripped = line.strip()
    column = at - text.rfind("\n", 0, at) - 1
    comment = line.find("//")
    in_string = line[:column].count('"') % 2 == 1
    return not in_string and not (0 <= comment <= column) and not stripped.startswith(("#", "template", "for ("))


def variants(checks_only):
    """(name, file, changed text) for every variant; the name is file, place in its function and change."""
    for file in sorted(sources.glob("*.cpp")):
        text = file.read_text()

        def variant(begin, end, new, what):
            line = text[text.rfind("\n", 0, begin) + 1 : text.find("\n", begin)].strip()
            return f"{file.name}: {what} in: {line}", file, text[:begin] + new + text[end:]

        for match in re.finditer(r"\brequire\(", text):
            if "void require" in text[match.start() - 5 : match.end()] or not is_code(text, match.start()):
                continue
            end = statement_end(text, match.end() - 1)
            inside = text[match.end() : end]
            yield variant(match.start(), end + 1, "static_cast<void>(" + first_argument(inside) + ")", "no check")
        if checks_only:
            continue
        for old, new in CHANGES:
            for match in re.finditer(old, text):
                if is_code(text, match.start()):
                    what = f"{match.group().strip()} -> {new.strip() or 'nothing'}"
                    column = match.start() - text.rfind("\n", 0, match.start())
                    yield variant(match.start(), match.end(), new, f"{what} at {column}")


def first_argument(inside):
    depth = 0
    for i, c in enumerate(inside):
        depth += c in "([{"
        depth -= c in ")]}"
        if c == "," and depth == 0:
            return inside[:i]
    return inside


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("compiler")
    parser.add_argument("flags", help="of GMP, as one argument")
    parser.add_argument("build", type=Path)
    parser.add_argument("--only", default="", help="variants whose name this matches")
    parser.add_argument("--checks", action="store_true", help="only dropped checks, some five minutes on two cores")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--list", action="store_true")
    arguments = parser.parse_args()
    chosen = [v for v in variants(arguments.checks) if re.search(arguments.only, v[0])]
    if arguments.list:
        print("\n".join(name for name, _, _ in chosen))
        return 0
    build = arguments.build.resolve()
    build.mkdir(parents=True, exist_ok=True)
    flags = shlex.split(arguments.flags)
    libraries = [flag for flag in flags if not flag.startswith("-I")]
    compile_line = [arguments.compiler, "-std=c++20", "-O1", "-w", f"-I{sources}", *(set(flags) - set(libraries))]

    def object_of(source, target):
        return (
            subprocess.run(compile_line + ["-c", str(source), "-o", str(target)], capture_output=True).returncode == 0
        )

    # all but main.cpp are run as many.cpp does, in one process
    many = test / "many.cpp"
    files = [*sorted(sources.glob("*.cpp")), many]
    objects = {file: build / (file.stem + ".o") for file in files}
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        if not all(pool.map(lambda file: object_of(file, objects[file]), files)):
            sys.exit("the checker does not compile")

    def outcome(job):
        index, (name, file, text) = job
        source, target, program = (build / f"v{index}{suffix}" for suffix in (".cpp", ".o", ""))
        source.write_text(text)
        try:
            if not object_of(source, target):
                return "does not compile"
            others = [str(objects[f]) for f in files if f not in (file, many if file.stem == "main" else sources / "main.cpp")]
            linked = subprocess.run([arguments.compiler, str(target), *others, "-o", str(program), *libraries])
            if linked.returncode != 0:
                return "does not compile"
            for mode, folder in (("reject", "reject"), ("accept", "accept"), ("usage", "accept")):
                limits = ["sh", "-c", 'ulimit -v 2000000 -t 60; exec "$@"', "limited"]
                checker = [program] if file.stem == "main" else ["many", program]
                run = subprocess.run(
                    [*limits, sys.executable, "-B", test / "run_corpus.py", *checker, mode, test / folder],
                    capture_output=True,
                    env={**os.environ, "SUBCERT_FIRST_FAILURE": "1"},
                )
                if run.returncode != 0:
                    return "fails"
            return "survives"
        finally:
            for path in (source, target, program):
                path.unlink(missing_ok=True)

    counts, survivors = {}, []
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for (name, _, _), result in zip(chosen, pool.map(outcome, enumerate(chosen))):
            counts[result] = counts.get(result, 0) + 1
            if result == "survives":
                survivors.append(name)
                print(name, flush=True)
    known = [line.split(" # ")[0] for line in (test / "same.txt").read_text().splitlines() if " # " in line]
    new = [name for name in survivors if name not in known]
    gone = [name for name in known if name not in survivors] if not arguments.only else []
    for name in gone:
        print(f"same.txt, but told apart or not there: {name}")
    print(", ".join(f"{count} {result}" for result, count in sorted(counts.items())))
    print(f"{len(new)} that survive are not in same.txt")
    return 1 if new or gone else 0


if __name__ == "__main__":
    sys.exit(main())
