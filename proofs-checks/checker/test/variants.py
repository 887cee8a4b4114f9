"""What the tests with wrong variants of the checkers share: where the changes are made, and what the corpus says.

A variant is run on those cases alone that come to its place, where that can be told with both values there: in all others it
does what the checker does. Those that told the variants before it go first, then the quickest, until one fails."""
import math
import os
import re
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import run_corpus

test = Path(__file__).resolve().parent


def is_code(text, at, quotes, no_code):
    line = text[text.rfind("\n", 0, at) + 1 : text.find("\n", at)]
    column = at - text.rfind("\n", 0, at) - 1
    comment = line.find("//")  # a template of JavaScript may have several lines
    in_string = any((text[:at] if quote == "`" else line[:column]).count(quote) % 2 == 1 for quote in quotes)
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


def arguments_of(parser):
    """The arguments, with those that choose variants."""
    parser.add_argument("--only", default="", help="variants whose name this matches")
    parser.add_argument("--lines", default="0-1000000", help="variants in these lines of their files, FIRST-LAST")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--list", action="store_true", help="only name the variants")
    return parser.parse_args()


def chosen(every, arguments):
    """{number: variant} of those that the arguments choose; without an answer where they are only named."""
    first, last = map(int, arguments.lines.split("-"))
    result = {number: variant for number, variant in enumerate(every, 1) if re.search(arguments.only, variant[0])
              and first <= variant[1].read_text().count("\n", 0, variant[2]) + 1 <= last}
    if arguments.list:
        print("\n".join(name for name, *_ in result.values()))
        sys.exit(0)
    return result


class Corpus:
    """The cases of a corpus, and which variants each may tell from the checker: those that `trace(folder, words)` gives, by
    number, or all where that is None. The checker is run on all of them, which gives their times; `limits` are commands of the
    shell."""

    def __init__(self, folder, trace, jobs, checker, limits):
        self.scratch, self.limits, self.last = tempfile.TemporaryDirectory(), limits, []
        cases = [(folder / run_corpus.folder_of(mode), words, is_right) for mode in ("accept", "usage", "reject") for _, words, is_right
                 in run_corpus.cases(mode, folder / run_corpus.folder_of(mode), self.scratch.name)]
        with ThreadPoolExecutor(jobs) as pool:
            traces = list(pool.map(lambda case: trace(*case[:2]), cases))
        self.cases, seconds = [(case, numbers, 0) for case, numbers in zip(cases, traces)], []
        if self.fails_on(self.cases, checker, 3600, seconds):
            sys.exit("the checker itself fails")
        self.cases = sorted(zip(cases, traces, seconds), key=lambda case: case[2])

    def cases_for(self, number):
        return [case for case in self.cases if case[1] is None or number in case[1]]

    def parts(self, number, quick):
        """The cases for a variant, in parts: those that told some variants before it, quick ones, and all others, which
        are left out where only `quick` seconds are allowed."""
        cases = self.cases_for(number)
        told = [case for case in self.last if case in cases]
        result, total, ends = [told, []], 0, [quick or 1, 10, 1e9]
        for case in cases:
            total += case[2]
            if total > ends[0]:
                if quick:
                    break
                ends = ends[1:]
                result.append([])
            if case not in told:
                result[-1].append(case)
        return [part for part in result if part]

    def fails(self, checker, number, quick=None, **environment):
        """Whether a checker, this variant, fails on a case, or takes three times as long."""
        return any(self.fails_on(part, checker, 3 + math.ceil(3 * sum(case[2] for case in part)), **environment)
                   for part in self.parts(number, quick))

    def fails_on(self, cases, checker, most, seconds=None, **environment):
        """Whether a checker fails on one of these cases, or exceeds the limits; without, how long each took."""
        started = {}
        try:
            for case in cases:
                folder, words, is_right = case[0]
                if folder not in started:
                    started[folder] = run_corpus.Checker(checker, folder, f"{self.limits}ulimit -t {most}", {**os.environ, **environment})
                start = time.monotonic()
                if not is_right(started[folder].run(words)):
                    break
                if seconds is not None:
                    seconds.append(time.monotonic() - start)
            else:
                return False
        except (OSError, ValueError):  # it has ended
            pass
        finally:
            for one in started.values():
                one.close()
        self.last = [case, *(other for other in self.last if other is not case)][:5]
        return True


def names_in(same):
    return [line.split(" # ")[0] for line in same.read_text().splitlines() if " # " in line]


def report(chosen, outcome, corpus, jobs, every, same):
    """Tries the chosen variants, by number, and prints those that survive; 1 if one of them does not stand in the file `same`,
    or if a line of that fits none."""
    counts, survivors = {}, []
    with ThreadPoolExecutor(jobs) as pool:
        for (number, (name, *_)), result in zip(chosen.items(), pool.map(outcome, chosen.items())):
            counts[result] = counts.get(result, 0) + 1
            if result == "survive":
                survivors.append(name)
                print(f"{name} # {len(corpus.cases_for(number))} cases come there", flush=True)
    known = names_in(same)
    new = [name for name in survivors if name not in known]
    every, tried = {name for name, *_ in every}, {name for name, *_ in chosen.values()}
    gone = [name for name in known if name not in every or (name in tried and name not in survivors)]
    for name in gone:
        print(f"same.txt, but told apart or not there: {name}")
    print(", ".join(f"{count} {result}" for result, count in sorted(counts.items())))
    print(f"{len(new)} that survive are not in same.txt")
    return 1 if new or gone else 0
