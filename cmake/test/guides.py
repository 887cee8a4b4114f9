#!/usr/bin/env python3
"""Manual pages and completions against the help of the program.

Usage: guides.py pages|bash|zsh|fish PROGRAM FOLDER; FOLDER holds man1/ and the completions as they are installed.
Exit code 77 where the shell, or man, is not there.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys


def help_of(program, *command):
    text = subprocess.run([program, *command, "--help"], check=True, capture_output=True, text=True).stdout
    options = set(re.findall(r"^  (?:-\w,)?(--[\w-]+)", text, re.M))
    listed = re.search(r"^Subcommands:\n((?:  .*\n)+)", text, re.M)
    return options, re.findall(r"^  ([\w-]+)", listed[1], re.M) if listed else []


def check_pages(program, folder):
    """Each command has a page that names its options and those of its subcommands; man has no complaint."""
    pages = folder / "man1"
    _, commands = help_of(program)
    expected = {"subcert.1"} | {f"subcert-{command}.1" for command in commands}
    assert {page.name for page in pages.iterdir()} == expected
    for command in commands:
        text = (pages / f"subcert-{command}.1").read_text().replace("\\-", "-")
        options, below = help_of(program, command)
        for one in below:
            assert f"subcert {command} {one} " in text, (command, one)
            options |= help_of(program, command, one)[0]
        for option in options:
            assert f"\\fB{option}\\fR" in text, (command, option)
        for needed in [".SH NAME", ".SH SYNOPSIS", ".SH DESCRIPTION", ".SH EXIT STATUS", ".SH SEE ALSO"]:
            assert text.count(needed + "\n") == 1, (command, needed)
        assert f"\\fBsubcert-{command}\\fR(1)" in (pages / "subcert.1").read_text().replace("\\-", "-"), command
    if not shutil.which("man"):
        return 77
    for page in expected:
        shown = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", pages / page], capture_output=True, text=True,
                               env={**os.environ, "LC_ALL": "C.UTF-8", "MANWIDTH": "80"})
        assert shown.returncode == 0 and not shown.stderr, shown.stderr
    return 0


# A line that is typed, what must be offered, and what must not.
CASES = [
    ("subcert ma", ["mask", "map"], ["range", "manual"]),
    ("subcert --", ["--help", "--version"], []),
    ("subcert mask pri", ["primal:", "primal-odd:"], ["dual:"]),
    ("subcert mask --jobs 3 b", ["butterfly:", "box:"], ["primal:"]),
    ("subcert range --o", ["--over", "--out"], ["--json"]),
    ("subcert statements ", ["list", "check"], []),
    ("subcert statements check dyn-2015/theorem-", ["dyn-2015/theorem-1"], ["dyn-2015/eq-2"]),
    ("subcert smooth samples.csv --scheme du", ["dual:", "dual-odd:"], ["primal:"]),
    ("subcert smooth samples.csv --boundary m", ["mirror"], ["wrap"]),
    ("subcert theorem con", ["conjecture-7"], ["list"]),
    ("subcert reproduce dyn-2015 must", ["mustafa-hameed"], ["dyn-2015"]),
    ("subcert completion ", ["bash", "zsh", "fish"], []),
]


def check_offers(offers_of):
    for line, wanted, unwanted in CASES:
        offers = offers_of(line)
        assert set(wanted) <= set(offers), (line, offers)
        assert not set(unwanted) & set(offers), (line, offers)
    return 0


def check_bash(program, folder):
    """Calls the function as readline does, and compares options of all commands with their help."""
    script = r"""
      source "$1"; shift
      complete -p subcert >/dev/null || exit 1
      for line; do
        COMP_LINE=$line; COMP_POINT=${#line}; COMPREPLY=(); _subcert
        echo "${COMPREPLY[*]}"
      done"""

    def offers(*lines):
        ran = subprocess.run(["bash", "--norc", "-c", script, "bash", folder / "subcert", *lines], check=True,
                             capture_output=True, text=True)
        assert not ran.stderr, ran.stderr
        return [line.split() for line in ran.stdout.split("\n")[:-1]]

    check_offers(lambda line: offers(line)[0])
    assert offers("subcert smooth --boundary=m") == [["mirror"]]
    assert offers("subcert smooth --scheme=primal-") == [["primal-odd:"]]
    _, commands = help_of(program)
    for command, found in zip(commands, offers(*[f"subcert {command} --" for command in commands])):
        assert set(found) == help_of(program, command)[0], command
    return 0


def check_fish(program, folder):
    def offers(line):
        ran = subprocess.run(["fish", "--no-config", "-c", f"source {folder}/subcert.fish; complete -C '{line}'"],
                             check=True, capture_output=True, text=True)
        assert not ran.stderr, ran.stderr
        return [one.split("\t")[0] for one in ran.stdout.splitlines()]

    return check_offers(offers)


# An interactive zsh in a terminal of its own; what it shows when TAB is pressed behind each line.
ZSH = r"""
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell "PROMPT='NEXT> '; fpath=($1 \$fpath); autoload -U compinit; compinit -u -D; bindkey '^I' list-choices
LISTMAX=10000; setopt no_always_last_prompt no_list_beep no_list_ambiguous; stty columns 200 rows 100; echo READ''Y"
zpty -r -m shell shown $'*READY\r\n*NEXT> *'
for typed in "${@:2}"; do
  zpty -w -n shell "$typed"$'\t\C-u'"echo DON''E"$'\n'
  zpty -r -m shell shown $'*DONE\r\n*NEXT> *'
  print -r -- "$shown" END
done
"""


def check_zsh(program, folder):
    lines = [line for line, _, _ in CASES]
    ran = subprocess.run(["zsh", "-f", "-c", ZSH, "zsh", folder, *lines], check=True, capture_output=True, text=True,
                         timeout=240)
    shown = dict(zip(lines, re.sub(r"\x1b\[[0-9;?]*[a-zA-Z]", " ", ran.stdout).split(" END\n")))
    assert len(shown) == len(lines)
    return check_offers(lambda line: shown[line].split("NEXT>")[0].replace(line, " ").split())


def main():
    kind, program, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    if kind != "pages" and not shutil.which(kind):
        print(f"skipped: there is no {kind}")
        return 77
    code = {"pages": check_pages, "bash": check_bash, "zsh": check_zsh, "fish": check_fish}[kind](program, folder)
    if code == 77:
        print("pages say what help says; how man shows them is not checked: there is no man")
    return code


if __name__ == "__main__":
    sys.exit(main())
