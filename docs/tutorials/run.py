#!/usr/bin/env python3
"""Runs a page of Markdown: its commands print what the page says.

Usage: run.py PROGRAM PAGE [--print]
  A fence whose first line begins with `$ ` is a session: each command, then what it prints. A line `...` stands for any
  lines, `...` within a line for any text. A fence with a name behind its language (```toml schemes.toml) is a file.
  The page runs in a folder of its own, where `docs` is that of the sources. `--print` shows what commands print.
Exit code: 0 all is as the page says, 1 not.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

FENCE = re.compile(r"^```([^\n]*)\n(.*?)^```$", re.M | re.S)


def sessions(text):
    """The commands of a session with what they print."""
    parts = re.split(r"^\$ ", text, flags=re.M)
    assert not parts[0], f"text before the first command: {parts[0]}"
    for part in parts[1:]:
        lines = part.split("\n")
        end = next(i for i, line in enumerate(lines) if not line.endswith("\\"))
        yield "\n".join(lines[:end + 1]), "\n".join(lines[end + 1:])


def agrees(expected, printed):
    """Line by line, with `...` as above; blanks at ends of lines do not count."""
    pattern = ""
    for line in expected.splitlines():
        if line.strip() == "...":
            pattern += r"(.*\n)*?"
        else:
            pattern += ".*?".join(re.escape(part) for part in line.rstrip().split("...")) + r" *\n"
    return re.fullmatch(pattern, printed) is not None


def main():
    program, page, *rest = sys.argv[1:]
    page = pathlib.Path(page).resolve()
    shown = "--print" in rest
    faults, count = [], 0
    with tempfile.TemporaryDirectory() as work:
        os.symlink(pathlib.Path(__file__).resolve().parent.parent, f"{work}/docs")
        os.environ["PATH"] = f"{pathlib.Path(program).resolve().parent}:{os.environ['PATH']}"
        for info, text in FENCE.findall(page.read_text(encoding="utf-8")):
            words = info.split()
            if len(words) == 2:
                pathlib.Path(work, words[1]).write_text(text, encoding="utf-8")
            elif text.startswith("$ "):
                for command, expected in sessions(text):
                    ran = subprocess.run(["bash", "-c", command], cwd=work, stdout=subprocess.PIPE,
                                         stderr=subprocess.STDOUT, text=True, check=False)
                    count += 1
                    if shown:
                        print(f"$ {command}\n{ran.stdout}", end="")
                    elif not agrees(expected, ran.stdout):
                        faults.append(f"$ {command}\n--- expected\n{expected}--- printed\n{ran.stdout}")
    print("\n".join(faults) or f"{page.name}: {count} commands print what the page says")
    return 0 if count and not faults else 1


if __name__ == "__main__":
    sys.exit(main())
