#!/usr/bin/env python3
"""Every output of every command where it cannot be written: one line that names the file and the reason, exit code 66,
what was there before intact, nothing beside it. Where a certificate cannot be written the answer is printed before.

Usage: outputs.py SUBCERT CHECKER. File systems that are full or read-only are mounted in a name space of their own; where
that is not allowed a line says so.
"""
import os
import re
import resource
import stat
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

program, checker = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
# those that name something to be written
OPTIONS = {"--out", "--plot", "--csv", "--certificate", "--certificates", "--journal", "--page", "--html", "--junit", "--sarif",
           "--stencils-header"}
MAP = "map mask:[-w,0,1/2+w,1,1/2+w,0,-w] --over w=0..1/5 --over t=0..1 --property convergent --resolution 2"
# a command, and what it can write: of files the ending is given where it matters, folders end with a slash
COMMANDS = [
    ("mask primal:n=2", ["--out"]), ("completion bash", ["--out"]), ("limit primal:n=1 --level 2", ["--out"]),
    ("variance primal:n=1", ["--out"]), ("theorem list", ["--out"]), ("statements list", ["--out"]),
    ("statements check dyn-2015/eq-2", ["--out", "--page"]), ("check properties.toml", ["--out", "--junit", "--sarif", "--journal"]),
    ("conjecture 7 --n 1..2 --d 1", ["--out", "--journal"]),
    ("sweep primal:n=1..2", ["--out", "--journal"]), ("merge journal", ["--out"]),
    ("atlas primal:n=1 --atlas made.sqlite", ["--out", "--certificate"]),
    ("smooth data.csv --scheme primal:n=2", ["--out"]), ("smooth data.csv --scheme primal:n=2 --stream", ["--out"]),
    ("refine primal:n=2 data.csv", ["--out"]), ("verify s1.cert", ["--out"]),
    ("refine loop mesh.obj --levels 1", ["--out", "--out.ply", "--out.off", "--out.stl"]),
    ("regularity bspline:degree=3", ["--out", "--certificate"]), ("jsr pair.json", ["--out", "--certificate"]),
    # not asked to print into what is full
    ("range four-point:w --over w=1/20..1/10 --property convergent", ["--out", "--certificate/"]),
    ("curve four-point:w --over w=1/20..1/16 --pieces 1", ["--out", "--csv", "--plot.svg", "--certificate/"]),
    ("levels four-point:w --over w=1/20..1/16 --property C1", ["--out", "--plot.svg", "--certificate/"]),
    ("levels four-point:w --over w=1/20..1/16 --property C1 --each-point", ["--out", "--certificate/"]),
    ("vertex loop --valence 3", ["--out", "--certificate/", "--stencils-header.h", "--plot.svg", "--html"]),
    ("map weights.toml --valence 3 --over a=0..1 --over b=0..1 --property C1 --resolution 2", ["--out", "--csv", "--plot.svg"]),
    ("analyze primal:n=1", ["--out", "--plot.svg", "--plot.png"]),
    ("analyze loop", ["--plot.svg"]), (MAP.replace("w]", "w+t-t]"), ["--out", "--csv", "--plot.png"]),
    ("smooth data.csv --scheme primal:n=2", ["--plot.svg"]), ("refine primal:n=2 data.csv", ["--plot.svg"]),
    ("check vectors.toml", ["--certificate/"]), ("analyze primal:n=1", ["--html"]), ("compare primal:n=1 dual:n=1", ["--out", "--html", "--plot.svg"]),
    ("sweep primal:n=1 --expect holder>3 --quiet", ["--certificates/"]), ("gallery primal:n=1", ["--out"]), ("gallery primal:n=1 --json", ["--out"]),
    ("gallery --vertices loop --valence 3", ["--out"]),
    ("experiment fig3 --runs 2", ["--out/"]), ("reproduce dyn-2015 --only masks,fig1", ["--out/"]),
]
PRINTED = 17
REASONS = ("Not a directory", "Is a directory", "No space left on device", "Read-only file system", "File too large",
           "gnuplot did not draw it to its end", "No such file or directory", "expected a folder",
           "expected a file in a folder")
NO_JOURNAL = ": not a file"  # with exit code 65
failures, runs = [], 0


def complain(why, words, done):
    failures.append(f"{why}: subcert {' '.join(map(str, words))}\n  exit {done.returncode}, {done.stderr!r}")


def run(words, **more):
    global runs
    runs += 1
    return subprocess.run([program, *words], cwd=work, stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                          timeout=300, check=False, **{"stdout": subprocess.DEVNULL, **more})


def tree(folder):
    """What is there but for devices and empty folders."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def refuses(words, named, folder, **more):
    """The run fails as it should and changes nothing in the folder."""
    before = tree(folder)
    done = run(words, **more, stdout=subprocess.PIPE)
    lines = done.stderr.splitlines()
    if done.returncode == 65 and len(lines) == 1 and lines[0].endswith(named + NO_JOURNAL):
        return
    if done.returncode != 66:
        complain("not exit code 66", words, done)
    elif len(lines) != 1 or not lines[0].startswith("subcert: ") or not any(reason in lines[0] for reason in REASONS):
        complain("not one line with a reason", words, done)
    elif named not in lines[0] and "/subcert-" not in lines[0]:  # or one of its own temporary files
        complain("the file is not named", words, done)
    if "--certificate" in words and "expected a" not in done.stderr and "not written" not in done.stdout:
        complain("the answer, which was there, is lost", words, done)
    if tree(folder) != before:
        complain(f"{sorted(set(tree(folder)) ^ set(before)) or 'a content'} changed", words, done)


def outputs(folder, number):
    """(words, option, kind, target) for all that can be written, each target in place of its own."""
    for i, (command, options) in enumerate(COMMANDS):
        for option in options:
            name, kind = re.fullmatch(r"(--[\w-]+)(.*)", option).groups()
            place = folder / f"{number}-{i}{name}{kind.replace('/', '')}"
            place.mkdir()
            target = place / ("folder" if kind == "/" else "file" + kind)
            yield command.split() + [name, str(target)], name, kind, target


def fill(words, name, kind, target):
    """Something good is there already, of a journal a part."""
    if kind == "/":
        target.mkdir()
        (target / "old").write_text("good\n")
    else:
        target.write_bytes(begun if name == "--journal" or words[0] == "merge" else b"good\n")


def below_a_file(folder):
    for words, name, kind, target in outputs(folder, "below"):
        target.write_text("a file\n")
        words[-1] = str(target / ("deeper" + kind.replace("/", "")))
        yield words, str(target), target.parent, {}


def a_folder_is_there(folder):
    for words, name, kind, target in outputs(folder, "folder"):
        if kind != "/":
            target.mkdir()
            yield words, str(target), target.parent, {}


def full_device(folder):
    for words, name, kind, target in outputs(folder, "device"):
        if kind == "":
            try:
                os.mknod(target, stat.S_IFCHR | 0o666, os.makedev(1, 7))
                target.open("w").close()
            except OSError:
                return
            yield words, str(target), target.parent, {}


def limited_size(folder):
    limit = {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0))}
    for words, name, kind, target in outputs(folder, "size"):
        fill(words, name, kind, target)
        yield words, str(target), target.parent, limit


def mounted(folder, prepare):
    """A tiny file system, in which good things are before it is read-only or full."""
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=1024k", "tmpfs", folder], check=False).returncode:
        return
    made = [case for case in outputs(folder, "disk") if case[1] != "--journal"]  # its last block may have room
    for case in made:
        fill(*case)
    prepare(folder)
    for words, name, kind, target in made:
        yield words, str(target), target.parent, {}


def full_disk(folder):
    def fill_up(folder):
        filler = os.open(folder / "filler", os.O_WRONLY | os.O_CREAT)
        try:
            while os.write(filler, bytes(4096)):
                pass
        except OSError:
            os.close(filler)
    return mounted(folder, fill_up)


def read_only_disk(folder):
    return mounted(folder, lambda folder: subprocess.run(["mount", "-o", "remount,ro", folder], check=True))


def closed_or_full_streams(folder):
    """Standard output that takes nothing; standard streams that are closed while files are written."""
    for command, _ in COMMANDS[:PRINTED]:
        words = command.split() + (["--out", str(folder / "merged")] if command.startswith("merge") else [])
        with open("/dev/full", "w") as full:
            done = run(words, stdout=full)
        if done.returncode != 66 or done.stderr != "subcert: cannot write to standard output: No space left on device\n":
            complain("standard output is full", words, done)
        done = run(words, preexec_fn=lambda: os.close(1))
        if done.returncode != 66 or done.stderr != "subcert: cannot write to standard output: Bad file descriptor\n":
            complain("standard output is closed", words, done)
    for words in (["--help"], ["--version"], ["mask", "--help"]):
        with open("/dev/full", "w") as full:
            if run(words, stdout=full).returncode != 66:
                failures.append(f"{words} on a full standard output")
    with open("/dev/full", "w") as full:
        proof = ["--mask", "[1,2,1]/2@-1", "--arity", "2", "--lower", "1", work / "s1.cert"]
        assert subprocess.run([checker, *proof], stdout=subprocess.DEVNULL, check=False).returncode == 0
        for arguments in (["--help"], proof):
            if subprocess.run([checker, *arguments], stdout=full, check=False).returncode != 1:
                failures.append(f"subcert-check {arguments} on a full standard output")
    damaged = folder / "damaged"
    damaged.write_bytes(journal.replace(b"upper", b"UPPER", 1))
    before = damaged.read_bytes()
    words = "conjecture 7 --n 1..2 --d 1 --journal".split() + [str(damaged)]
    run(words, preexec_fn=lambda: os.closerange(0, 3))
    if not damaged.read_bytes().startswith(before) or b"subcert:" in damaged.read_bytes():
        failures.append("a warning went into a journal")


def good_places(folder):
    """Links and devices stay what they are, files keep their mode."""
    target, link = folder / "behind", folder / "link"
    target.write_text("old\n")
    target.chmod(0o640)
    link.symlink_to(target)
    run(["mask", "primal:n=1", "--out", str(link)])
    if not link.is_symlink() or "[1,2,1]" not in target.read_text() or stat.S_IMODE(target.stat().st_mode) != 0o640:
        failures.append("a link was replaced, or a mode")
    pipe = folder / "pipe"
    os.mkfifo(pipe)
    with ThreadPoolExecutor(1) as reader:
        text = reader.submit(pipe.read_text)
        run(["mask", "primal:n=1", "--out", str(pipe)])
        if "[1,2,1]" not in text.result(60) or not stat.S_ISFIFO(pipe.stat().st_mode):
            failures.append("a pipe was not written as it is")
    nothing = {**os.environ, "TMPDIR": str(folder / "nowhere")}
    certificate = folder / "x.cert"
    refuses(["regularity", "primal:n=2", "--certificate", str(certificate)], "nowhere", folder, env=nothing)


def every_option_is_tried():
    tried = {(command.split()[0], re.match(r"--[\w-]+", option)[0]) for command, options in COMMANDS for option in options}
    text = subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout
    for command in re.findall(r"^  ([a-z]+)  ", text[text.index("Subcommands"):], re.M):
        usage = subprocess.run([program, command, "--help"], capture_output=True, text=True, check=True).stdout
        for option in re.findall(r"^  (--[\w-]+)", usage, re.M):
            if option in OPTIONS and (command, option) not in tried:
                failures.append(f"subcert {command} {option} is not tried here")


if os.environ.get("SUBCERT_OWN_MOUNTS") is None:
    for unshare in (["unshare", "-m"], ["unshare", "-rm"]):
        if subprocess.run([*unshare, "true"], capture_output=True, check=False).returncode == 0:
            os.environ["SUBCERT_OWN_MOUNTS"] = "1"
            os.execvp("unshare", [*unshare, sys.executable, "-B", *sys.argv])
with tempfile.TemporaryDirectory() as name:
    work = Path(name)
    (work / "mesh.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    (work / "data.csv").write_text("x,y\n" + "".join(f"{i},{i * i % 7}\n" for i in range(12)))
    (work / "pair.json").write_text('{"matrices": [[["1","1"],["0","1"]], [["1","0"],["1","1"]]]}\n')
    (work / "vectors.toml").write_text("mask = 'merrien:lambda=-1/8,mu=1/2'\nHC = '>= 1'\n")
    (work / "weights.toml").write_text('scheme = "loop"\nletter = ["a", "b"]\n[[rule]]\n'
                                       'weights = {vertex = "1 - a*b", neighbours = "a*b/n"}\n')
    (work / "properties.toml").write_text("mask = 'dd:n=2'\nreproduces = 3\n")
    for words in ("conjecture 7 --n 1..3 --d 1 --journal journal", "regularity primal:n=1 --certificate s1.cert"):
        assert run(words.split()).returncode in (0, 2)
    journal = (work / "journal").read_bytes()
    begun = b"".join(journal.splitlines(True)[:2])
    for i, (command, _) in enumerate(COMMANDS[:PRINTED]):
        words = command.split() + (["--out", "merged"] if command.startswith("merge") else [])
        done = run(words)
        if done.returncode not in (0, 2):
            complain("does not work at all", words, done)
    every_option_is_tried()
    for places in (below_a_file, a_folder_is_there, full_device, limited_size, full_disk, read_only_disk):
        folder = Path(tempfile.mkdtemp(dir=work))
        before = runs
        with ThreadPoolExecutor(2) as pool:
            list(pool.map(lambda case: refuses(*case[:3], **case[3]), places(folder)))
        print(places.__name__, "was skipped: not allowed here" if runs == before else f"{runs - before} runs")
        subprocess.run(["umount", folder], capture_output=True, check=False)
    folder = Path(tempfile.mkdtemp(dir=work))
    closed_or_full_streams(folder)
    good_places(folder)
print(runs, "runs,", len(failures), "failures")
print(*failures[:40], sep="\n")
sys.exit(bool(failures))
