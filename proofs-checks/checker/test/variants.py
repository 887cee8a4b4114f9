"""What the tests with wrong variants of the checkers share: where the changes are made, and what the corpus says."""
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

test = Path(__file__).resolve().parent


def is_code(text, at, quotes, no_code):
    line = text[text.rfind("\n", 0, at) + 1 : text.find("\n", at)]
    column = at - text.rfind("\n", 0, at) - 1
    comment = line.find("//")
    in_string = any(line[:column].count(quote) % 2 == 1 for quote in quotes)
    return not in_string and not 0 <= comment <= column and not line.strip().startswith(no_code)


def variants(files, changes, quotes, no_code=()):
    """(name, file, begin, end, text) for every variant: what stands in place of a part of a file; the name is file, change with
    its column, and line. A change is what is looked for, what stands in its place, and what the variant does."""
    for file in files:
        text = file.read_text()
        for old, new, what in changes:
            for match in re.finditer(old, text):
                if is_code(text, match.start(), quotes, no_code):
                    before = text.rfind("\n", 0, match.start())
                    line = text[before + 1 : text.find("\n", match.start())].strip()
                    column = "" if what == "no check" else f" at {match.start() - before}"
                    yield f"{file.name}: {what}{column} in: {line}", file, match.start(), match.end(), new


def fails(checker, corpus, limits, **environment):
    """Whether a checker fails on the corpus in a folder, or exceeds the limits, commands of the shell."""
    for mode, folder in (("accept", "accept"), ("usage", "accept"), ("reject", "reject")):
        run = subprocess.run(
            ["sh", "-c", f'{limits}; exec "$@"', "limited", sys.executable, "-B", test / "run_corpus.py", *checker, mode, corpus / folder],
            capture_output=True,
            check=False,
            env={**os.environ, "SUBCERT_FIRST_FAILURE": "1", **environment},
        )
        if run.returncode != 0:
            return True
    return False


def report(chosen, outcome, jobs, every, same):
    """Tries the chosen variants, by number, and prints those that survive; 1 if one of them does not stand in the file `same`,
    or if a line of that fits none."""
    counts, survivors = {}, []
    with ThreadPoolExecutor(jobs) as pool:
        for (name, *_), result in zip(chosen.values(), pool.map(outcome, chosen.items())):
            counts[result] = counts.get(result, 0) + 1
            if result == "survive":
                survivors.append(name)
                print(name, flush=True)
    known = [line.split(" # ")[0] for line in same.read_text().splitlines() if " # " in line]
    new = [name for name in survivors if name not in known]
    every, tried = {name for name, *_ in every}, {name for name, *_ in chosen.values()}
    gone = [name for name in known if name not in every or (name in tried and name not in survivors)]
    for name in gone:
        print(f"same.txt, but told apart or not there: {name}")
    print(", ".join(f"{count} {result}" for result, count in sorted(counts.items())))
    print(f"{len(new)} that survive are not in same.txt")
    return 1 if new or gone else 0
