#!/usr/bin/env python3
"""Changes accepted certificates at random, as the mutation test of subcert-check does, and offers each to both checkers
with the true claim and with others: both must say the same and name the same line.
Usage: agree.py SUBCERT_CHECK NODE MAIN_JS ACCEPT_DIRECTORY MUTANTS [SEED]"""
import json
import random
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path

checker, node, main, directory, wanted = sys.argv[1:6]
directory, wanted, seed = Path(directory).resolve(), int(wanted), int(sys.argv[6]) if len(sys.argv) > 6 else 20261123
chance = random.Random(seed)
TOO_MUCH_WORK = "more work than the checker allows"  # each checker counts its own work


def claims_of(options):
    """The claim of a line of claims.txt and others with the same subject: with one end, with other ends, rough, and if it
    is exact with and without its number, and with other numbers."""
    values = dict(zip(options[::2], options[1::2]))
    lower, upper, exact = (values.pop(option, None) for option in ("--lower", "--upper", "--exact"))
    if "--matrices" in values:
        values["--matrices"] = str(directory / values["--matrices"])
    subject = [word for pair in values.items() for word in pair]
    rough = upper is not None and upper.startswith("C")
    ends = [(lower, upper), (lower, None), (None, upper), (None, None)]
    for step in (Fraction(1, 10**12), Fraction(1, 10), Fraction(2)):
        if lower is not None:
            ends.append((str(Fraction(lower) + step), upper))
        if upper is not None and not rough:
            ends += [(lower, str(Fraction(upper) - step)), (None, str(Fraction(upper) - step))]
        else:
            ends.append((lower, str(Fraction(lower or 0) + step)))
    ends.append((lower, "C" + str(chance.randint(1, 4))))
    numbers = [None] if exact is None else [exact, exact, exact, None, change_field(exact).replace("\0", "")]
    return [subject + [word for option, value in (("--lower", low), ("--upper", high), ("--exact", number))
                       if value is not None for word in (option, value)]
            for number in numbers for low, high in ends]


def change_number(field, by):
    head, colon, number = field.rpartition(":")
    try:
        return f"{head}{colon}{int(number) + by}"
    except ValueError:
        return field + "1"


def change_field(field):
    at = chance.randrange(len(field)) if field else 0
    return chance.choice([
        lambda: "0", lambda: "-" + field, lambda: field + 30 * "9", lambda: 5000 * "7", lambda: field + "/0",
        lambda: "1/" + field, lambda: "18446744073709551616", lambda: "-1", lambda: "",
        lambda: field[:at] + field[at + 1:], lambda: field[:at] + str(chance.randrange(10)) + field[at + 1:],
        lambda: field[:at] + chr(chance.randrange(256)) + field[at + 1:],
        lambda: field[:at] + chance.choice("0123456789-,:/fcAB@[]") + field[at:], lambda: change_number(field, 1),
        lambda: change_number(field, -1), lambda: field[:field.find(":") + 1] + "0", lambda: str(chance.randrange(6)),
        lambda: field + ":" + field])()


def scale(lines, keyword, factor):
    def scaled(text):
        return str(int(Fraction(text) * factor)) if text.lstrip("-").isdigit() and len(text) < 4000 else text

    for i, line in enumerate(lines):
        words = line.split()
        if words[:1] == [keyword]:
            for k, word in enumerate(words[1:], 1):
                head, *numbers = word.split(":")
                words[k] = ":".join([head, *map(scaled, numbers)]) if numbers else scaled(word) \
                    if keyword == "vertex" else word
            lines[i] = " ".join(words)


def keep_heads(lines, keywords):
    for i, line in enumerate(lines):
        words = line.split()
        if words[:1] and words[0] in keywords:
            lines[i] = " ".join(words[:2 if words[0] == "unit" else 3])


def change_lines(lines, other):
    i, kind = chance.randrange(len(lines)), chance.randrange(14)
    if kind == 0:
        del lines[i]
    elif kind == 1:
        lines.insert(i, lines[i])
    elif kind == 2:
        k = chance.randrange(len(lines))
        lines[i], lines[k] = lines[k], lines[i]
    elif kind == 3:
        del lines[i:]
    elif kind == 4:
        lines[i] = lines[i][:chance.randrange(len(lines[i]) + 1)]
    elif kind == 5:
        lines.insert(i, chance.choice(other))
    elif kind == 6:
        lines[i] = chance.choice(other)
    elif kind == 7:
        lines.append(lines[i])
    elif kind == 8:
        scale(lines, "image", Fraction(999, 1000))
    elif kind == 9:
        scale(lines, chance.choice(["vertex", "unit"]), chance.choice([Fraction(1001, 1000), Fraction(1, 2)]))
    elif kind == 10:
        keep_heads(lines, ["image"])
    elif kind == 11:
        keep_heads(lines, ["image", "unit"])
    elif kind == 12:
        lines[:] = [line for line in lines
                    if line.split()[:1] and line.split()[0] not in ("vertex", "unit", "image", "form", "word")]
    else:
        words = lines[i].split()
        chance.shuffle(words)
        lines[i] = " ".join(words)


def mutant(lines):
    lines, other = lines.copy(), chance.choice(cases)[1]
    for _ in range(chance.choice([0, 1, 1, 1, 2, 4])):
        if not lines:
            break
        i = chance.randrange(len(lines))
        words = lines[i].split(" ")
        if chance.random() < 0.7:
            k = chance.randrange(len(words))
            words[k] = change_field(words[k])
            lines[i] = " ".join(words)
        else:
            change_lines(lines, other)
    text = "".join(line + "\n" for line in lines).encode("latin-1")
    return text[:chance.randrange(len(text) + 1)] if chance.random() < 0.01 else text


def run_checker(words):
    done = subprocess.run([checker, *words], capture_output=True, check=False)
    return done.returncode, (done.stdout or done.stderr).decode("latin-1").strip()


def same(one, other):
    (code, line), (other_code, other_line) = one, other
    if code == 0:
        return one == other
    return code == other_code and (code > 1 or line.rpartition(", line ")[2] == other_line.rpartition(", line ")[2])


def feed(stream, commands):  # beside the reading of answers: pipes hold little
    stream.write("".join(json.dumps(words) + "\n" for words in commands))
    stream.flush()


cases = []
for entry in (directory / "claims.txt").read_text().splitlines():
    name, *options = entry.split()
    cases.append((claims_of(options), (directory / f"{name}.cert").read_text().splitlines()))
count = verified = work = 0
failures = []
with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool, \
        subprocess.Popen([node, main, "--many"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as second:
    while count < wanted:
        commands = []
        for k in range(min(400, wanted - count)):
            count += 1
            file = Path(folder) / f"{k}.cert"
            claims, lines = chance.choice(cases)
            file.write_bytes(mutant(lines))
            commands += [claim + [str(file)] for claim in [claims[0], *chance.sample(claims[1:], 2)]]
        first = list(pool.map(run_checker, commands))
        pool.submit(feed, second.stdin, commands)
        for words, (code, line) in zip(commands, first):
            answer = json.loads(second.stdout.readline())
            result = answer["exit"], answer["line"]
            verified += code == 0
            if "internal error" in result[1]:
                failures.append((words, line, result[1], b""))
            elif TOO_MUCH_WORK in line or TOO_MUCH_WORK in result[1]:
                work += 1
            elif not same((code, line), result):
                failures.append((words, line, result[1], Path(words[-1]).read_bytes()))
print(f"{count} mutants (seed {seed}): {verified} claims verified, {work} times too much work, {len(failures)} failures")
for words, line, other, text in failures[:12]:
    print(" ".join(words), "\n ", line[:200], "\n ", other[:200])
    if len(text) < 1500:
        print(text.decode("latin-1"))
sys.exit(bool(failures))
