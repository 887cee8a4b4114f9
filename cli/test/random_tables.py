#!/usr/bin/env python3
"""Random tables, as people have them and worse, for `subcert smooth` and `refine`, each written in two forms.

Whatever the table: no signal, a documented exit code, one line for an error, an answer of finite numbers that another
reader takes, positions at the data that are those of the data to the last bit, bands about their values, and the same
answer for both forms. `--seed S --first I --runs 1` repeats draw I of seed S and keeps its files. Needs Python alone."""

import argparse
import collections
import math
import os
import random
import resource
import shlex
import subprocess
import sys
import tempfile
import time

MOST_SECONDS = 60  # of processor time
GAPS = ["", "NA", "nan", "null", "NaN"]
NAMES = ["t", "v", "E", "Na", "e1", "a b", "x,y", 'say "m"', "ü", "1.5x", "speed", "x", "index", "v_sd"]


class Table:
    """Fields as texts, row by row; what is known of them stands beside."""

    def __init__(self, draw):
        count = draw.choice([0, 1, 2, 3, 4, 7] if draw.random() < 0.2 else [12, 30, 80, draw.randint(8, 400)])
        self.kind, self.positions = positions(draw, count)
        self.values = [values(draw, count, self.positions) for _ in range(draw.choice([1, 1, 2, 3]))]
        columns = [self.positions, *self.values]
        self.names = draw.sample(NAMES, len(columns))
        self.group = self.weights = self.text = None
        if draw.random() < 0.15:
            self.weights = add(self, columns, "w", [draw.choice(["1", "2", "0.5", "0", "3"]) for _ in range(count)])
        if draw.random() < 0.15:
            self.group = add(self, columns, "group", [draw.choice("abc") for _ in range(count)])
        if draw.random() < 0.3:
            self.text = add(self, columns, "make", [draw.choice(["VW", "A, B", "", "é", "a;b"]) for _ in range(count)])
        self.rows = [list(row) for row in zip(*columns)]


def add(table, columns, name, fields):
    columns.append(fields)
    table.names.append(name)
    return name


def shown(value):
    return repr(round(value, 6))


def positions(draw, count):
    kind = draw.choice(["count", "decimal", "falling", "ties", "scattered", "shuffled", "huge", "tiny", "date",
                        "one", "gaps", "month", "near"])
    step, start = draw.choice([1, 0.1, 4, 1e-3]), draw.choice([0, 1, -7, 100])
    plain = [repr(start + step * i) for i in range(count)]
    if kind == "decimal":
        return kind, [f"{start + i / 3:.3f}" for i in range(count)]
    if kind == "falling":
        return kind, plain[::-1]
    if kind == "ties":
        return kind, [str(start + i // draw.choice([2, 3])) for i in range(count)]
    if kind in ("scattered", "shuffled"):
        drawn = [draw.uniform(0, 10) for _ in range(count)]
        return kind, [repr(v) for v in (sorted(drawn) if kind == "scattered" else drawn)]
    if kind == "huge":
        return kind, [repr(1e300 * (i + 1) / (count + 1)) for i in range(count)]
    if kind == "tiny":
        return kind, [repr(1e-300 * i) for i in range(count)]
    if kind == "date":
        return kind, [f"20{20 + i // 336:02}-{i // 28 % 12 + 1:02}-{i % 28 + 1:02}" for i in range(count)]
    if kind == "month":
        return kind, [f"{2000 + i // 12}-{i % 12 + 1:02}" for i in range(count)]
    if kind == "one":
        return kind, ["3"] * count
    if kind == "gaps":
        return kind, [draw.choice(GAPS) if draw.random() < 0.1 else p for p in plain]
    if kind == "near":
        return kind, [repr(float(i) if draw.random() < 0.9 else math.nextafter(i, 9e9)) for i in range(count)]
    return "count", plain


def values(draw, count, places):
    kind = draw.choice(["noise"] * 8 + ["outliers", "gaps"] * 3 + ["line", "constant", "huge", "tiny", "wild", "text"])
    noise = [math.sin(i / 7) + draw.gauss(0, 0.2) for i in range(count)]
    if kind == "line":
        return [repr(2 * i + 1) for i in range(count)]
    if kind == "constant":
        return ["5"] * count
    if kind == "outliers":
        return [shown(v + (draw.random() < 0.1) * draw.choice([-40, 90])) for v in noise]
    if kind == "huge":
        return [repr(v * draw.choice([1e140, 1e160, 1e307])) for v in noise]
    if kind == "tiny":
        return [repr(v * 1e-310) for v in noise]
    if kind == "gaps":
        return [draw.choice(GAPS) if draw.random() < 0.1 else shown(v) for v in noise]
    if kind == "wild":
        odd = ["inf", "-inf", "1e999", "1e-999", "1.2.3", "--1", "0x10", "+", "1e", "12 3", "-", ".", "\u22123", "1_0"]
        return [draw.choice(odd) if draw.random() < 0.03 else shown(v) for v in noise]
    if kind == "text":
        return [draw.choice(["high", "low"]) for _ in noise]
    return [shown(v) for v in noise]


class Form:
    """How a table is written."""

    def __init__(self, draw, plain):
        self.separator = "," if plain else draw.choice([",", ";", "\t", " "])
        self.decimal = "." if plain or self.separator == "," else draw.choice([".", ".", ","])
        self.end = "\n" if plain else draw.choice(["\n", "\r\n"])
        self.mark = not plain and draw.random() < 0.2
        self.quotes = 0 if plain else draw.choice([0, 0, 0.3, 1])
        self.last_end = plain or draw.random() < 0.8
        self.after = "" if plain else draw.choice(["", "", self.end, "# end" + self.end])

    def field(self, draw, text, is_number):
        if is_number and self.decimal == ",":
            text = text.replace(".", ",")
        if text == "" and self.separator == " ":
            text = "NA"
        if any(c in text for c in self.separator + '"') or (text and draw.random() < self.quotes):
            return '"' + text.replace('"', '""') + '"'
        return text

    def bytes(self, draw, table, header):
        head = [[self.field(draw, name, False) for name in table.names]] if header else []
        known = [c <= len(table.values) or name == table.weights for c, name in enumerate(table.names)]
        rows = [[self.field(draw, text, known[c]) for c, text in enumerate(row)] for row in table.rows]
        text = self.end.join(self.separator.join(row) for row in head + rows)
        return (b"\xef\xbb\xbf" * self.mark + (text + (self.end + self.after) * self.last_end).encode())

    def options(self):
        name = {"\t": "tab", " ": "blank"}.get(self.separator, self.separator)
        return ["--delimiter", name] + (["--decimal", ","] if self.decimal == "," else [])


def damaged(draw, content):
    """A file that something went wrong with."""
    if not content:
        return content
    at = draw.randrange(len(content))
    return draw.choice([content[:at], content[:at] + bytes([draw.randrange(256)]) + content[at:], content[at:],
                        content + b"1,2\n", content.decode("utf-8").encode("utf-16"), content.replace(b"\n", b"\r")])


SCHEMES = ["local:points=5", "local:d=1", "local:points=7,d=2,robust=3", "local:d=1,robust=3", "local:width=2",
           "primal:n=2", "dual:n=3,d=3", "primal:n=1", "l1:points=4", "l1:points=6,iterations=auto", "bspline:degree=3",
           "four-point:w=1/16", "local:points=9,d=3,weight=box", "ary:a=3,points=4,d=1", "local:points=1,d=0"]


def smooth_options(draw, table, header):
    options = []

    def maybe(chance, *words):
        if draw.random() < chance:
            options.extend(words)

    known = table.names if header else [str(k + 1) for k in range(len(table.names))]
    maybe(0.6, "--scheme", draw.choice(SCHEMES))
    maybe(0.8, "--missing", "drop")
    maybe(0.5, "--at", "data")
    maybe(0.2, "--irregular", draw.choice(["fit", "raise"]))
    maybe(0.6, "--x", known[0] if "," not in known[0] else "1")
    maybe(0.15, "--x", "none") if "--x" not in options else None
    maybe(0.2, "--y", "2")
    maybe(0.2, "--level", draw.choice(["0", "1", "3"]))
    maybe(0.15, "--derivative", draw.choice(["1", "2"]))
    maybe(0.3, "--bands", draw.choice(["0", "0.5", "0.99"]))
    maybe(0.2, "--bands-kind", draw.choice(["simultaneous", "prediction"]))
    maybe(0.2, "--boundary", draw.choice(["mirror", "nearest", "constant", "wrap"]))
    maybe(0.1, "--noise", draw.choice(["0.1", "1e-100", "1e100"]))
    maybe(0.05, "--spacing", draw.choice(["0.25", "1/3", "1e-9", "1e9"]))
    maybe(0.05, "--closed")
    maybe(0.1, "--select", "cv")
    maybe(0.04, "--stream")
    if table.weights:
        maybe(0.7, "--weights", "w" if header else str(table.names.index("w") + 1))
    if table.group:
        maybe(0.7, "--by", "group" if header else str(table.names.index("group") + 1))
    if table.text and "--at" in options:
        maybe(0.5, "--keep", "make" if header else str(table.names.index("make") + 1))
    return options


class Run:
    def __init__(self, program, arguments, folder):
        def limit():
            resource.setrlimit(resource.RLIMIT_CPU, (MOST_SECONDS, MOST_SECONDS))

        begin = time.time()
        done = subprocess.run([program, *arguments], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, check=False,
                              preexec_fn=limit)
        self.seconds = time.time() - begin
        self.code, self.output, self.errors = done.returncode, *(t.decode("utf-8", "replace") for t in (done.stdout, done.stderr))


def fields_of(line, separator):
    """The fields of a line, and which were in quotes are not told."""
    fields, field, inside, i = [], "", False, 0
    while i < len(line):
        c = line[i]
        if c == '"' and inside and line[i + 1 : i + 2] == '"':
            field, i = field + c, i + 1
        elif c == '"':
            inside = not inside
        elif c == separator and not inside:
            fields, field = fields + [field], ""
        else:
            field += c
        i += 1
    return fields + [field]


def answer_of(run, form):
    lines = [line for line in run.output.split("\n") if line and not line.startswith("#")]
    head, *rows = [fields_of(line, form.separator) for line in lines]
    return head, rows


def number(text, decimal):
    return float(text.replace(decimal, "."))


def judge(run, table, form, options, header):
    """What is wrong with an answer of smooth."""
    codes = (0, 64, 65, 1) if "--derivative" in options else (0, 64, 65)  # 1: there is no such derivative
    if run.code not in codes:
        return [f"exit code {run.code}"]
    errors = [line for line in run.errors.splitlines() if not line.startswith("subcert: note: ")]
    if run.code == 0 and errors or run.code != 0 and (len(errors) != 1 and "--by" not in options or
                                                      any(not line.startswith("subcert: ") for line in errors)):
        return [f"standard error {run.errors!r}"]
    if run.code in (1, 64) and run.output:
        return ["an answer beside a usage error"]
    if run.code != 0:
        return []
    found = []
    head, rows = answer_of(run, form)
    widths = {len(row) for row in rows} | {len(head)}
    if len(widths) != 1:
        return [f"rows of {widths} fields"]
    kept = 1 if "--keep" in options else 0
    first = 1 if "--by" in options else 0
    dated = table.kind in ("date", "month") and "none" not in options
    for row in rows:
        numbers = row[first + dated : len(row) - kept]
        if "--by" in options:  # of a group whose noise has no estimate
            numbers = [text for text, name in zip(numbers, head[first + dated :])
                       if text != "nan" or not name.endswith(("_sd", "_lower", "_upper"))]
        try:
            if not all(math.isfinite(number(text, form.decimal)) for text in numbers):
                return [f"not finite: {row}"]
        except ValueError:
            if not dated and not ("--by" in options and "" in numbers):
                return [f"not a number: {row}"]
    for c, name in enumerate(head):
        if not (name.endswith("_lower") and head[c + 1 : c + 2] == [name[:-6] + "_upper"]):
            continue
        for row in rows:
            value, low, high = (number(row[k], form.decimal) for k in (c - 2, c, c + 1) if row[k])
            if not low <= value <= high and not math.isnan(low):
                found.append(f"the band {low} ... {high} is not about {value}")
                break
    if "--at" in options and "--by" not in options and "--x" in options and "none" not in options and not dated:
        found += judge_positions(table, form, rows)
    return found[:1]


def judge_positions(table, form, rows):
    given = collections.Counter(float(row[0]) for row in table.rows if row[0] not in GAPS)
    whole = collections.Counter(float(row[0]) for row in table.rows
                                if row[0] not in GAPS and not any(v in GAPS for v in row[1 : 1 + len(table.values)]))
    if table.weights:
        whole.clear()
    made = [number(row[0], form.decimal) for row in rows]
    if made != sorted(made) and made != sorted(made, reverse=True):
        return ["positions in no order"]
    counted = collections.Counter(made)
    if counted - given:
        return [f"positions that are not those of the data: {list((counted - given).elements())[:3]}"]
    if "text" not in table.kind and whole - counted:
        return [f"positions of data without a row: {list((whole - counted).elements())[:3]}"]
    return []


def normal(run, form):
    """An answer without its form."""
    if run.code != 0:
        return run.code
    head, rows = answer_of(run, form)

    def plain(text):
        try:
            return number(text, form.decimal)
        except ValueError:
            return text or "NA"

    return [head] + [[plain(text) for text in row] for row in rows]


def draw_case(program, seed, number_of_draw, folder):
    draw = random.Random(f"{seed}/{number_of_draw}")
    table = Table(draw)
    header = draw.random() < 0.8
    forms = [Form(draw, True), Form(draw, False)]
    found, commands, runs = [], [], []
    contents = [form.bytes(draw, table, header) for form in forms]
    names = ["plain.csv", "other.csv"]
    common = smooth_options(draw, table, header) + (["--header", "yes" if header else "no"] if draw.random() < 0.7 else [])
    is_broken = draw.random() < 0.15
    if is_broken:
        contents[1] = damaged(draw, contents[1])
    for name, form, content in zip(names, forms, contents):
        with open(os.path.join(folder, name), "wb") as file:
            file.write(content)
        command = ["smooth", name, *common, *form.options()]
        run = Run(program, command, folder)
        broken = is_broken and name == names[1]
        wrong = judge(run, table, form, common, header) if not broken or run.code not in (0, 1, 64, 65) else []
        found += [f"{what}\n    subcert {shlex.join(command)}\n    {run.errors[-300:]}" for what in wrong]
        runs.append(run)
    if not is_broken and not found and "--header" in common and "text" not in common:
        try:
            one, other = normal(runs[0], forms[0]), normal(runs[1], forms[1])
        except (IndexError, ValueError) as error:
            one, other = error, None
        if repr(one) != repr(other):  # nan is alike, too
            found.append(f"the forms differ\n    {shlex.join(common)}\n    {forms[1].__dict__}\n    {str(one)[:300]}\n"
                         f"    {str(other)[:300]}\n    {runs[0].errors[-200:]}{runs[1].errors[-200:]}")
    if draw.random() < 0.3:
        scheme = draw.choice(["primal:n=2", "l1:points=4", "dd:n=2", "bspline:degree=3,a=3"])
        command = ["refine", scheme, draw.choice(names), "--levels", draw.choice(["0", "1", "2"])]
        command += draw.choice([[], ["--closed"], ["--boundary", "nearest"], ["--boundary", "constant"],
                                ["--boundary", "shrink"], ["--json"]])
        run = Run(program, command, folder)
        if run.code not in (0, 64, 65) or (run.code != 0) != (len(run.errors.splitlines()) == 1):
            found.append(f"exit code {run.code}\n    subcert {shlex.join(command)}\n    {run.errors[-300:]}")
    return found, runs


def draw_rows(program, seed, number_of_draw, folder):
    """Series in rows, whose positions are the names of the columns, beside the same series in a long table."""
    draw = random.Random(f"rows/{seed}/{number_of_draw}")
    count = draw.choice([2, 3, 7, 30])
    kind, places = positions(draw, count)
    while kind == "gaps":  # a column without a name is left out, a row without a position may be an error
        kind, places = positions(draw, count)
    series = [(draw.choice(["a", "b", "c, d", "1"]), values(draw, count, places)) for _ in range(draw.randint(1, 4))]
    wide = [["g", *places], *([name, *each] for name, each in series)]
    tall = [["g", "x", "value"], *([name, p, v] for name, each in series for p, v in zip(places, each))]
    options = smooth_options(draw, Table(draw), False)
    for word in ("--x", "--y", "--weights", "--by", "--keep", "--spacing"):
        while word in options:
            del options[options.index(word) : options.index(word) + 2]
    options = [word for word in options if word not in ("--stream", "--closed")] + ["--by", "g"]
    form, runs = Form(draw, True), []
    for rows, more in ((tall, ["--x", "x", "--y", "value"]), (wide, ["--series", "rows"])):
        with open(os.path.join(folder, "table.csv"), "w", encoding="utf-8") as file:
            file.writelines(",".join(form.field(draw, text, False) for text in row) + "\n" for row in rows)
        runs.append(Run(program, ["smooth", "table.csv", *options, *more], folder))
    one, other = ((run.code, run.output) for run in runs)
    if one == other:
        return [], runs
    return [f"series in rows differ from those in columns\n    {shlex.join(options)}\n    {wide}\n    {str(one)[:300]}\n"
            f"    {str(other)[:300]}\n    {runs[0].errors[-200:]}{runs[1].errors[-200:]}"], runs


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--runs", type=int, default=10**9)
    parser.add_argument("--seconds", type=float, default=1e9)
    arguments = parser.parse_args()
    program, begin, faults, codes = os.path.abspath(arguments.program), time.time(), 0, collections.Counter()
    slowest = (0, 0)
    drawn = arguments.first
    while drawn < arguments.first + arguments.runs and time.time() - begin < arguments.seconds and faults < 20:
        with tempfile.TemporaryDirectory() as folder:
            if arguments.runs == 1:
                folder = tempfile.mkdtemp()
                print(folder)
            found, runs = draw_case(program, arguments.seed, drawn, folder)
            if drawn % 4 == 0:
                more, of_rows = draw_rows(program, arguments.seed, drawn, folder)
                found, runs = found + more, runs + of_rows
        codes.update(run.code for run in runs)
        slowest = max(slowest, max((run.seconds, drawn) for run in runs))
        for what in found:
            faults += 1
            print(f"draw {drawn} of seed {arguments.seed}: {what}", flush=True)
        drawn += 1
    print(f"{drawn - arguments.first} tables; exit codes {dict(codes)}; {faults} faults; the slowest took "
          f"{slowest[0]:.1f} s, draw {slowest[1]}")
    return 1 if faults or codes[0] == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
