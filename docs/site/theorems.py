#!/usr/bin/env python3
"""The text of the theorems, two papers in docs/theorems: as one source each, as PDF, their tables of inequalities.

Usage: theorems.py pdf TEX                builds the PDF in a folder of its own; 77 if pdflatex is missing
       theorems.py tables SUBCERT FOLDER  writes inequalities-first.tex, inequalities.tex and checklist.md into the
                                          folder, docs/theorems, from what the program runs
       theorems.py check SUBCERT FOLDER   compares these files with the program
Exit code: 0 done, 1 not: a reference is undefined, a line is wider than the page, or a table is another one.
"""
import decimal as decimals
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

FIRST = ("P", "Q", "S", "W", "X")  # the letters of the first paper
CHECKLIST = """# Who decides which line

*For provers.*

For a referee: each number of the two papers, the command that decides it, the source with its computation
(in `proofs-checks/theorems/`), the constants that it bounds, and what is compared. Made from the program's answers by
`docs/site/theorems.py tables`; a long test compares it with them. `subcert theorem ID --d D --all` prints every
single inequality with both sides and its margin, `--json` exact ends; `--family` runs the same for the other families
(Theorems G, V).

How to check the checker: [the tests](../../proofs-checks/theorems/test) move every constant by one part in a hundred
to its wrong side and ask that its inequality fails; compare bounds with exact means, values, slopes and exponents of
single schemes, which other parts of the program compute; and draw random points for suprema. Enclosures are Arb balls.
Lines without a number are proved in the text alone. In the first paper the numbers of Theorems P, S and X are
elementary, those of Q and W confirm and compare.

| line | paper | command | source | constants | what is compared |
|---|---|---|---|---|---|
"""
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


def groups(subcert):
    """(theorem, degree, its answer, number, the inequalities of this number), in the order of the answers, but for the
    digits of limit-constants, which the text has not."""
    for entry in answer(subcert, "list")["theorems"]:
        if entry["id"] == "limit-constants":
            continue
        for degree in entry["degrees"][:1] if entry["id"].startswith("limit") else entry["degrees"]:
            theorem = answer(subcert, entry["id"], "--d", str(degree))
            together = {}
            for check in theorem["checks"]:
                together.setdefault(check["id"], []).append(check)
            for number, group in together.items():
                yield entry["id"], degree, theorem, number, group


def paper(number):
    return "I" if number.startswith(FIRST) else "II"


def table(found, which):
    """Of the lines with the same numbers the first; the tightest inequality of each."""
    known, text = set(), HEAD
    for name, degree, _, number, group in found:
        left, right = sides(min(group, key=tightness))
        row = (number, len(group), left, right)
        if paper(number) == which and row not in known:
            text += f"({number}) & {name}, {degree} & {len(group)} & ${left}<{right}$ \\\\\n"
        known.add(row)
    return text + "\\end{longtable}\n"


def checklist(found, sources):
    """One line for each number, by the first theorem that runs it."""
    lines = {}
    for name, degree, theorem, number, group in found:
        if number in lines:
            continue
        constants = {constant["name"] for constant in theorem["constants"] if constant["check"] == number}
        files = [file.name for file, text in sources if f'"{number}"' in text]
        cells = [f"({number})", paper(number), f"`theorem {name} --d {degree}`", ", ".join(files),
                 ", ".join(sorted(f"`{one}`" for one in constants)), f"`{group[0]['claim']}`"]
        lines[number] = "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |\n"
    order = sorted(lines, key=lambda number: [(not part.isdigit(), part.zfill(3)) for part in number.split(".")])
    return CHECKLIST + "".join(lines[number] for number in order)


def made(subcert, folder):
    """The files that are made, by name."""
    found = list(groups(subcert))
    folder = folder.resolve()
    files = (folder.parent.parent / "proofs-checks/theorems").glob("*.cpp")
    sources = [(file, file.read_text(encoding="utf-8")) for file in sorted(files, key=lambda file: file.name)]
    return {"inequalities-first.tex": table(found, "I"), "inequalities.tex": table(found, "II"),
            "checklist.md": checklist(found, sources)}


def tables(subcert, folder):
    for name, text in made(subcert, folder).items():
        (folder / name).write_text(text, encoding="utf-8")
    return 0


def check(subcert, folder):
    """Numbers may differ by one part in a hundred: they are not rounded in the same way everywhere."""
    def shape(text):
        return re.sub(r"\$.*?\$", "", text)

    def values(text):
        return [float(re.sub(r"\\cdot10\^\{(.*?)\}", r"e\1", side)) for pair in re.findall(r"\$(.*?)\$", text)
                for side in pair.split("<")]

    other = []
    for name, ours in made(subcert, folder).items():
        theirs = (folder / name).read_text(encoding="utf-8")
        same = shape(ours) == shape(theirs) and all(abs(a - b) <= 0.01 * abs(a) for a, b in
                                                    zip(values(ours), values(theirs), strict=True))
        other += [] if same else [name]
    print(f"{', '.join(other)}: not what the program runs; make it again with: theorems.py tables SUBCERT docs/theorems"
          if other else "the tables of inequalities and the checklist are those of the program")
    return 1 if other else 0


def main(arguments):
    if len(arguments) == 2 and arguments[0] == "pdf":
        return pdf(pathlib.Path(arguments[1]))
    if len(arguments) == 3 and arguments[0] in ("tables", "check"):
        return {"tables": tables, "check": check}[arguments[0]](arguments[1], pathlib.Path(arguments[2]))
    print(__doc__, file=sys.stderr)
    return 64


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
