#!/usr/bin/env python3
"""Kills sweeps with SIGKILL at random moments, goes on, and compares with a sweep that was left alone.

Usage: kill_sweep.py SUBCERT KILLS [SEED]. Sweeps follow one another, each on a new journal or on two for two shards that
are joined, until so many runs were killed. After each kill every line of the journal is whole, and no case that was
there before is gone; a file for --out is whole or not there; at the end of each sweep the answers and the journal are
those of the undisturbed run, byte by byte. So are the entries of atlases that are built meanwhile.
"""
import json
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path

program, wanted = sys.argv[1], int(sys.argv[2])
seed = int(sys.argv[3]) if len(sys.argv) > 3 else random.randrange(10**9)
chance = random.Random(seed)
SWEEPS = [("conjecture", "7", "--n", "1..9", "--d", "1,3,5"), ("conjecture", "8", "--n", "1..8", "--d", "1,3,5"),
          ("conjecture", "7", "--n", "2..9", "--d", "1", "--json"),
          ("sweep", "masks:length=2..4,numerators=3,denominator=2", "--ask", "regularity,check stable", "--in-order",
           "--quiet"),
          ("check", str(Path(__file__).parents[2] / "docs" / "examples" / "properties.toml"))]
ATLAS = ("atlas", "build", "masks:length=2..4,numerators=3,denominator=2", "--quiet")
kills = ended = 0
print("seed", seed, flush=True)


def fail(message):
    sys.exit(f"after {kills} kills (seed {seed}): {message}")


def lines_of(journal):
    """The whole lines of a journal, none of which a kill may have torn."""
    text = journal.read_bytes() if journal.exists() else b""
    if text and not text.endswith(b"\n"):
        fail(f"a torn line in {journal.name}: {text[-60:]}")
    return text.splitlines()


def run_killed(command, longest):
    """Starts the command and kills it after a random time, unless longest is None; its standard output if it ended."""
    global kills
    process = subprocess.Popen([program, *command], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if longest is not None:
        # often soon after the start, where journals are made, locked and read
        time.sleep(chance.uniform(0, chance.choice([0.02, longest])))
        process.kill()
    out, err = process.communicate()
    if err:
        fail(f"{command} says {err}")
    if process.returncode >= 0:
        if process.returncode != 0:
            fail(f"{command} ended with {process.returncode}")
        return out
    kills += 1
    return None


def sweep_to_the_end(command, journal, longest):
    """Kills and goes on until the sweep comes to its end; what that run printed."""
    while True:
        before = lines_of(journal)
        out = run_killed([*command, "--journal", journal, "--jobs", str(chance.randint(1, 3))], longest)
        now = lines_of(journal)
        if now[:len(before)] != before:
            fail(f"{journal.name} lost cases")
        if out is not None:
            return out


def entries_of(atlas):
    done = subprocess.run([program, "atlas", "query", "arity == 2", "--json", "--quiet", "--atlas", atlas],
                          capture_output=True, check=False)
    if done.returncode != 0:
        fail(f"an atlas cannot be read: {done.stderr}")
    return json.loads(done.stdout)["entries"]


def atlas_to_the_end(file, longest):
    """Builds an atlas, killed again and again: what was entered stays."""
    count = 0
    while True:
        out = run_killed([*ATLAS, "--atlas", file, "--jobs", str(chance.randint(1, 3))], longest)
        if file.exists():
            count, before = len(entries_of(file)), count
            if count < before:
                fail("an atlas lost entries")
        if out is not None:
            return


def merge_to_the_end(parts, whole):
    """Joins journals, killed again and again: the joined one is whole or not there."""
    cases = sorted({line for part in parts for line in lines_of(part)})
    for longest in [0.02, 0.02, 0.02, None]:
        run_killed(["merge", *parts, "--out", whole], longest)
        if whole.exists() and sorted(lines_of(whole)) != cases:
            fail("a joined journal lacks cases")


def undisturbed(command, folder):
    journal = folder / "undisturbed"
    begin = time.monotonic()
    done = subprocess.run([program, *command, "--journal", journal, "--jobs", "1"], capture_output=True,
                          check=True)
    return done.stdout, lines_of(journal), time.monotonic() - begin


with tempfile.TemporaryDirectory() as name:
    rounds = 0
    expected = {}
    while kills < wanted:
        sweep = chance.choice(SWEEPS)
        folder = Path(name) / str(rounds)
        folder.mkdir()
        rounds += 1
        if sweep not in expected:
            expected[sweep] = undisturbed(sweep, folder)
        printed, lines, seconds = expected[sweep]
        if chance.random() < 0.2:
            for name_of_atlas, longest in (("killed.sqlite", 1), ("whole.sqlite", None)):
                atlas_to_the_end(folder / name_of_atlas, longest)
            if entries_of(folder / "killed.sqlite") != entries_of(folder / "whole.sqlite"):
                fail("the atlas is another than that of an undisturbed build")
        command, whole = list(sweep), folder / "whole"
        if chance.random() < 0.3:
            parts = [folder / "one", folder / "two"]
            for i, part in enumerate(parts, 1):
                sweep_to_the_end([*command, "--shard", f"{i}/2"], part, seconds / 2)
            merge_to_the_end(parts, whole)
        out = sweep_to_the_end(command, whole, seconds)
        answer = folder / "answer"  # the journal has all: killed again and again while the answer is written
        for _ in range(4):
            run_killed([*command, "--journal", whole, "--out", answer], 0.02)
            if answer.exists() and answer.read_bytes() != printed:
                fail("half an answer")
        if out != printed:
            fail(f"{' '.join(command)}: the output is another than that of an undisturbed run")
        if sorted(lines_of(whole)) != sorted(lines):
            fail(f"{' '.join(command)}: the journal is another than that of an undisturbed run")
print(f"{kills} kills in {rounds} sweeps: the same bytes")
