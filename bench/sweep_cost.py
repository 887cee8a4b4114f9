#!/usr/bin/env python3
"""What a case of a sweep costs, by family and size: 10,000 schemes, each asked for its exponent in a process of its
own, as `subcert sweep` does. Usage: sweep_cost.py SUBCERT TABLE.csv [PICTURE.svg]

TABLE.csv gets family, size (coefficients of the mask), processor seconds and MiB of each process, and goes on from the
lines that it has. The picture has the median and the largest of each size, and the budget.
"""
import collections
import concurrent.futures
import csv
import json
import os
import random
import statistics
import subprocess
import sys

BUDGET = 1
SEARCH = BUDGET - 0.5  # what a sweep gives a command, so that it has proved within a tenth more (searching_seconds)
COUNT = 10_000


def schemes(program):
    """Families for n up to 60, and of all masks with up to 6 coefficients k/8, |k| <= 8, as many as are missing."""
    grids = ["primal:n=1..60,d={1,3}", "dual:n=1..60,d={1,3}", "primal-odd:n=1..60,d={1,3}", "dual-odd:n=1..60,d={1,3}"]
    small = ["masks:length=2..6,numerators=8,denominator=8"]

    def listed(texts):
        words = [program, "sweep", *texts, "--columns", "scheme", "--in-order", "--quiet", "--worker", "/bin/false"]
        answer = subprocess.run(words, capture_output=True, text=True, check=False).stdout
        return [row[0] for row in csv.reader(answer.splitlines()[1:])]

    named, masks = listed(grids), listed(small)
    chosen = named + random.Random(1).sample(masks, COUNT - len(named))
    random.Random(2).shuffle(chosen)  # what is measured until the end is of all kinds
    return chosen


def cost(program, scheme):
    """Processor seconds and MiB of the process that answers, its exit code, and the length of the mask."""
    read, write = os.pipe()
    limits = ["--jobs", "1", "--budget", f"{SEARCH:.6g}", "--memory", "512"]
    streams = [(os.POSIX_SPAWN_DUP2, write, 1), (os.POSIX_SPAWN_OPEN, 2, os.devnull, os.O_WRONLY, 0)]
    child = os.posix_spawn(program, [program, "regularity", scheme, "--json", "--quiet", *limits], os.environ,
                           file_actions=streams)
    os.close(write)
    with os.fdopen(read) as answer:
        json.loads(answer.read())
    _, status, used = os.wait4(child, 0)
    mask = json.loads(subprocess.run([program, "mask", scheme, "--json"], capture_output=True, check=True).stdout)
    size = len(mask["coefficients"])
    seconds, code = used.ru_utime + used.ru_stime, os.waitstatus_to_exitcode(status)
    return [scheme, size, f"{seconds:.4f}", used.ru_maxrss // 1024, code]


def measure(program, table):
    done = set()
    if os.path.exists(table):
        with open(table, encoding="utf-8") as file:
            done = {row[0] for row in csv.reader(file)}
    todo = [scheme for scheme in schemes(program) if scheme not in done]
    with open(table, "a", encoding="utf-8") as file, concurrent.futures.ThreadPoolExecutor(2) as pool:
        for row in pool.map(lambda scheme: cost(program, scheme), todo):
            csv.writer(file).writerow(row)
            file.flush()


def read(table):
    """{family: {size: [seconds]}}, largest memory, exit codes."""
    costs, memory, codes = collections.defaultdict(lambda: collections.defaultdict(list)), 0, collections.Counter()
    with open(table, encoding="utf-8") as file:
        for scheme, size, seconds, mebibytes, code in csv.reader(file):
            family = scheme.split(":")[0]
            degree = ", d=" + scheme.split("d=")[1] if "d=" in scheme else ""
            costs[family + degree][int(size)].append(float(seconds))
            memory = max(memory, int(mebibytes))
            codes[code] += 1
    return costs, memory, codes


def draw(costs, picture):
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "subcert"
    from matplotlib import pyplot

    _, axes = pyplot.subplots(figsize=(8, 4.5))
    for family, sizes in sorted(costs.items()):
        order = sorted(sizes)
        axes.plot(order, [statistics.median(sizes[size]) for size in order], ".-", label=family, linewidth=1)
    axes.axhline(BUDGET, color="grey", linestyle="--", linewidth=0.8, label="budget")
    axes.set(xscale="log", yscale="log", xlabel="coefficients of the mask", ylabel="processor seconds (median)")
    axes.legend(fontsize=7, ncol=2)
    pyplot.tight_layout()
    pyplot.savefig(picture, metadata={"Date": None})


def main():
    program, table = os.path.abspath(sys.argv[1]), sys.argv[2]
    measure(program, table)
    costs, memory, codes = read(table)
    for family, sizes in sorted(costs.items()):
        every = sorted(seconds for some in sizes.values() for seconds in some)
        print(f"{family}: {len(every)} schemes, {sum(every):.1f} s, median {1000 * statistics.median(every):.0f} ms, "
              f"largest {every[-1]:.2f} s")
    print(f"{sum(codes.values())} schemes, exit codes {dict(codes)}, at most {memory} MiB")
    if len(sys.argv) > 3:
        draw(costs, sys.argv[3])


if __name__ == "__main__":
    main()
