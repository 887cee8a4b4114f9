#!/usr/bin/env python3
"""Makes the corpus, certificates with the expected outcome, and compares it with what is on record in corpus.sha256.

    corpus.py FOLDER [--record]

FOLDER/accept and FOLDER/reject are made by make_certificates.py and make_rejects.py, unless they are those of the same
sources already. Prints what differs from the record; exit code 1 then. With --record what was made becomes the record."""
import argparse
import hashlib
import importlib
import shutil
import sys
from pathlib import Path

test = Path(__file__).resolve().parent
record = test / "corpus.sha256"


def digest(data):
    return hashlib.sha256(data).hexdigest()[:16]


def made(folder):
    """A line for each file of the corpus."""
    return [f"{digest(file.read_bytes())} {file.relative_to(folder)}" for file in sorted(folder.glob("*/*"))]


def is_current(folder, state):
    try:
        return (folder / "made-by").read_text() == state
    except OSError:
        return False


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--record", action="store_true")
    arguments = parser.parse_args()
    folder = arguments.folder
    sources = digest(b"".join(file.read_bytes() for file in sorted(test.glob("*.py"))))
    if not (folder.is_dir() and is_current(folder, f"{sources} {digest(repr(made(folder)).encode())}")):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        accept, reject = folder / "accept", folder / "reject"
        # in one process, as what the cases share is computed when it is imported
        sys.path.insert(0, str(test))
        importlib.import_module("make_certificates").main(accept)
        sys.argv[1:] = map(str, (accept, reject))
        importlib.import_module("make_rejects")
        (folder / "made-by").write_text(f"{sources} {digest(repr(made(folder)).encode())}")
    lines = made(folder)
    if arguments.record:
        record.write_text("\n".join(lines) + "\n")
    differing = sorted(set(lines) ^ set(record.read_text().splitlines()), key=lambda line: line.split()[1])
    for name in dict.fromkeys(line.split()[1] for line in differing):
        print(f"not what is on record: {name}")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
