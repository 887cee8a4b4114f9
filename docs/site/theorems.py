#!/usr/bin/env python3
"""The text of the theorems, docs/theorems/variance-curves.tex: as one source, as PDF, and its table of inequalities.

Usage: theorems.py pdf TEX             builds the PDF twice in a folder of its own; 77 if pdflatex is missing
       theorems.py table SUBCERT       prints docs/theorems/inequalities.tex, from what the program runs
       theorems.py check SUBCERT TEX   compares that file, beside TEX, with the program
Exit code: 0 done, 1 not: a reference is undefined, a line is wider than the page, or the table is another one.
"""
import decimal as decimals
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HEAD = """% Made by docs/site/theorems.py from the program's answers; do not edit.
\\begin{longtable}{llrl}
number & theorem, degree & how many & the tightest\\\\
\\hline
\\endhead
"""


def merged(file):
    """The source with the files that it reads in their places."""
    return re.sub(r"\\input\{(.*?)\}", lambda part: merged(file.parent / f"{part[1]}.tex"),
                  file.read_text(encoding="utf-8"))


def for_page(tex):
    """What pandoc 2 reads as the PDF shows it: numbers of inequalities, the abstract, letters of the appendices."""
    text = re.sub(r"\\[bB]igg?[lr]?(?![a-zA-Z])", "", tex)  # MathML stretches brackets by itself
    text = re.sub(r"\\tag\{(.*?)\}", r"\\qquad\\text{(\1)}", text)
    text = re.sub(r"\\qed(?![a-zA-Z])", "◻", text)  # pandoc makes other signs of it
    text = re.sub(r"\\(begin|end)\{abstract\}", "", text)
    text, mark, appendices = text.partition("\\appendix")
    letters = iter("ABCDEF")
    return text + mark + re.sub(r"\\section\{", lambda _: f"\\section*{{Appendix {next(letters)}: ", appendices)


def build_pdf(folder, name):
    """Runs pdflatex until the references stand; what it says last."""
    for _ in range(3):
        log = subprocess.run(["pdflatex", "-interaction=nonstopmode", "-halt-on-error", name], cwd=folder,
                             capture_output=True, text=True, errors="replace", check=False)
        if log.returncode:
            break
    return log


def pdf(file):
    if not shutil.which("pdflatex"):
        print("no PDF of the theorems, as pdflatex is missing (Debian: texlive-latex-base)")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        name = pathlib.Path(folder) / file.name
        name.write_text(merged(file), encoding="utf-8")
        log = build_pdf(folder, file.name)
        faults = [line for line in log.stdout.splitlines()
                  if line.startswith(("!", "Overfull")) or "undefined" in line or "multiply defined" in line]
        print("\n".join(faults) or log.stdout.splitlines()[-2])
        return 1 if faults or log.returncode else 0


def answer(subcert, *arguments):
    return json.loads(subprocess.run([subcert, "theorem", *arguments, "--json"], capture_output=True, text=True,
                                     check=True).stdout)


def decimal(text):
    """As in TeX."""
    return re.sub(r"(.*)e\+?(-?)0*(\d+)", r"\1\\cdot10^{\2\3}", text)


def rounded(end, up, digits):
    """To the outside. An end is a decimal."""
    rounding = decimals.ROUND_CEILING if up else decimals.ROUND_FLOOR
    value = decimals.Context(prec=digits, rounding=rounding).create_decimal(end).normalize()
    plain = not value or decimals.Decimal("1e-6") < abs(value) < 10**9
    return decimal(f"{value:f}" if plain else f"{value:e}")


def sides(check):
    """Left and right side with as many digits, from five on, as show the inequality."""
    left, right = check["left"]["upper"], check["right"]["lower"]
    for digits in range(5, 40):
        context = decimals.Context(prec=digits)
        if context.create_decimal(left) < context.create_decimal(right):
            break
    return rounded(left, True, digits + 1), rounded(right, False, digits + 1)


def tightness(check):
    low, right = check["margin"].get("lower"), check["right"].get("upper")
    return float(low) / abs(float(right)) if low and right and float(right) else 0.0


def rows(subcert):
    """(number, theorem and degree, how many, left, right) of the tightest one, in the order of the answers. What an
    earlier line says with the same numbers is left out, and the digits of limit-constants, which the text has not."""
    known = set()
    for entry in answer(subcert, "list")["theorems"]:
        if entry["id"] == "limit-constants":
            continue
        for degree in entry["degrees"][:1] if entry["id"].startswith("limit") else entry["degrees"]:
            groups = {}
            for check in answer(subcert, entry["id"], "--d", str(degree))["checks"]:
                groups.setdefault(check["id"], []).append(check)
            for number, group in groups.items():
                left, right = sides(min(group, key=tightness))
                row = (number, len(group), left, right)
                if row not in known:
                    yield (number, f"{entry['id']}, {degree}", len(group), left, right)
                known.add(row)


def table(subcert):
    return HEAD + "".join(f"({number}) & {theorem} & {count} & ${left}<{right}$ \\\\\n"
                          for number, theorem, count, left, right in rows(subcert)) + "\\end{longtable}\n"


def check(subcert, file):
    """Numbers may differ by one part in a hundred: they are not rounded in the same way everywhere."""
    def shape(text):
        return re.sub(r"\$.*?\$", "", text)

    def values(text):
        return [float(re.sub(r"\\cdot10\^\{(.*?)\}", r"e\1", side)) for pair in re.findall(r"\$(.*?)\$", text)
                for side in pair.split("<")]

    ours, theirs = table(subcert), (file.parent / "inequalities.tex").read_text(encoding="utf-8")
    same = shape(ours) == shape(theirs) and all(abs(a - b) <= 0.01 * abs(a) for a, b in
                                                zip(values(ours), values(theirs), strict=True))
    print("the table of inequalities is that of the program" if same else
          "inequalities.tex differs from what the program runs; make it again with: theorems.py table SUBCERT")
    return 0 if same else 1


def main(arguments):
    if len(arguments) == 2 and arguments[0] == "pdf":
        return pdf(pathlib.Path(arguments[1]))
    if len(arguments) == 2 and arguments[0] == "table":
        print(table(arguments[1]), end="")
        return 0
    if len(arguments) == 3 and arguments[0] == "check":
        return check(arguments[1], pathlib.Path(arguments[2]))
    print(__doc__, file=sys.stderr)
    return 64


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
