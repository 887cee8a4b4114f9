#!/usr/bin/env python3
"""Changes accepted certificates at random, as the mutation test of subcert-check does, and offers each to both checkers
with the true claim and with others: both must say the same and name the same line.
Usage: agree.py SUBCERT_CHECK_MANY NODE MAIN_JS ACCEPT_DIRECTORY MUTANTS [SEED]"""
import json
import os
import random
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from fractions import Fraction
from itertools import accumulate
from pathlib import Path

many, node, main, directory, wanted = sys.argv[1:6]
directory, wanted, seed = Path(directory).resolve(), int(wanted), int(sys.argv[6]) if len(sys.argv) > 6 else 20261123
chance = random.Random(seed)
TOO_MUCH_WORK = "more work than the checker allows"  # each checker counts its own work


def claims_of(options):
    """The claim of a line of claims.txt and others with the same subject: with one end, with other ends, rough, and if it
    is exact with and without its number, with other numbers and powers of logarithms."""
    values = dict(zip(options[::2], options[1::2]))
    names = ("--lower", "--upper", "--exact", "--logarithm")
    lower, upper, exact, power = (values.pop(option, None) for option in names)
    for option in ("--matrices", "--subradius"):
        if option in values:
            values[option] = str(directory / values[option])
    if "--contraction" in values and chance.randrange(2):
        del values["--contraction"]
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
    powers = [power] if power is None else [power, None, "0", "1", "2"]
    claims = [(low, high, number, chance.choice(powers)) for number in numbers for low, high in ends]
    claims[0] = (lower, upper, exact, power)
    return [subject + [word for option, value in zip(names, claim) if value is not None for word in (option, value)]
            for claim in claims]


def change_number(field, by):
    head, colon, number = field.rpartition(":")
    try:
        return f"{head}{colon}{int(number) + by}"
    except ValueError:
        return field + "1"


def change_field(field):
    at = chance.randrange(len(field)) if field else 0
    return chance.choice([
        lambda: "0", lambda: "-" + field, lambda: field + 30 * "9", lambda: 6000 * "7", lambda: field + "/0",
        lambda: "1/" + field, lambda: "18446744073709551616", lambda: "-1", lambda: "",
        lambda: field[:at] + field[at + 1:], lambda: field[:at] + str(chance.randrange(10)) + field[at + 1:],
        lambda: field[:at] + chr(chance.randrange(256)) + field[at + 1:],
        lambda: field[:at] + chance.choice("0123456789-,:/fcAB@[]+*") + field[at:], lambda: change_number(field, 1),
        lambda: change_number(field, -1), lambda: field[:field.find(":") + 1] + "0", lambda: str(chance.randrange(6)),
        lambda: field + ":" + field])()


def scale(lines, keyword, factor):
    def scaled(text):
        return str(int(Fraction(text) * factor)) if re.fullmatch("-?[0-9]{1,4000}", text) else text

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
                    if line.split()[:1] and line.split()[0] not in ("vertex", "unit", "image", "form", "word", "coordinates", "step", "tree")]
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


def same(one, other):
    (code, line), (other_code, other_line) = one, other
    if code == 0:
        return one == other
    return code == other_code and (code > 1 or line.rpartition(", line ")[2] == other_line.rpartition(", line ")[2])


class Checker:
    """One that answers many command lines, in a process of its own."""

    def __init__(self, command, encoded, decoded):
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.encoded, self.decoded = encoded, decoded

    def feed(self, commands):  # beside the reading of answers: pipes hold little
        self.process.stdin.write(b"".join(map(self.encoded, commands)))
        self.process.stdin.flush()

    def answer(self):
        line = self.process.stdout.readline()
        if not line:
            raise SystemExit(f"{self.process.args}: ended with {self.process.wait()}")
        return self.decoded(line)


def encoded_first(words):
    return b"%d\0" % len(words) + b"".join(word.encode() + b"\0" for word in words)


def decoded_first(line):
    code, _, text = line.decode("latin-1").partition(" ")
    return int(code), text.strip()


def decoded_second(line):
    answer = json.loads(line)
    return answer["exit"], answer["line"]


def campaign(seed, wanted):
    """Numbers of mutants, of verified claims, of claims with too much work, and the failures."""
    chance.seed(seed)
    count = verified = work = 0
    failures = []
    first = Checker([many], encoded_first, decoded_first)
    second = Checker([node, main, "--many"], lambda words: (json.dumps(words) + "\n").encode(), decoded_second)
    with tempfile.TemporaryDirectory(dir="/dev/shm" if os.path.isdir("/dev/shm") else None) as folder, \
            ThreadPoolExecutor(2) as pool:
        while count < wanted:
            commands = []
            for k in range(min(400, wanted - count)):
                count += 1
                file = Path(folder) / f"{k}.cert"
                claims, lines = chance.choices(cases, cum_weights=weights)[0]
                file.write_bytes(mutant(lines))
                commands += [claim + [str(file)] for claim in [claims[0], *chance.sample(claims[1:], 2)]]
            for checker in first, second:
                pool.submit(checker.feed, commands)
            for words in commands:
                one, other = first.answer(), second.answer()
                verified += one[0] == 0
                if "internal error" in other[1]:
                    failures.append((words, one[1], other[1], b""))
                elif TOO_MUCH_WORK in one[1] or TOO_MUCH_WORK in other[1]:
                    work += 1
                elif not same(one, other):
                    failures.append((words, one[1], other[1], Path(words[-1]).read_bytes()))
    for checker in first, second:
        checker.process.stdin.close()
        checker.process.wait()
    return count, verified, work, failures


cases = []
for entry in (directory / "claims.txt").read_text().splitlines():
    name, *options = entry.split()
    cases.append((claims_of(options), (directory / f"{name}.cert").read_text().splitlines()))
# long ones take long, and have few lines that are unlike all others: they come less often
weights = list(accumulate(1 / (2000 + sum(map(len, lines))) for _, lines in cases))
workers = os.cpu_count() or 1
with ProcessPoolExecutor(workers) as pool:
    parts = list(pool.map(campaign, range(seed, seed + workers), [-(-wanted // workers)] * workers))
count, verified, work = (sum(part[i] for part in parts) for i in range(3))
failures = [failure for part in parts for failure in part[3]]
print(f"{count} mutants (seed {seed}): {verified} claims verified, {work} times too much work, {len(failures)} failures")
for words, line, other, text in failures[:12]:
    print(" ".join(words), "\n ", line[:200], "\n ", other[:200])
    if len(text) < 1500:
        print(text.decode("latin-1"))
sys.exit(bool(failures))
