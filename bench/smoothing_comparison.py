#!/usr/bin/env python3
"""`subcert.smooth` beside savgol_filter of SciPy, lowess of statsmodels, lowess and loess of R: value, robustness,
coverage of bands, choice of the window, speed. Makes the tables of docs/smoothing-beside-others.md, in one run.

Needs the Python package of subcert and Debian's python3-scipy, python3-statsmodels and r-base-core:

    PYTHONPATH=build/release/python /usr/bin/python3 bench/smoothing_comparison.py --out smoothing.md

Times are seconds of one processor, the least of the runs; what begins and what reads data are not in them. Errors are
root mean squares of the distance to the curve without noise."""

import argparse
import platform
import subprocess
import sys
import tempfile
import time
import warnings
from pathlib import Path

import numpy
import scipy
import scipy.signal
import statsmodels
import statsmodels.nonparametric.smoothers_lowess as lowess_module

import subcert

R_PROGRAM = r"""
read <- function(name) { path <- file.path(FOLDER, name); readBin(path, "double", file.size(path) / 8) }
x <- read("x"); y <- read("y"); best <- Inf
options(warn = -1)
for (run in seq_len(RUNS)) { begin <- proc.time(); fit <- CALL; spent <- proc.time() - begin
  best <- min(best, spent[[1]] + spent[[2]]) }
writeBin(as.double(fit), file.path(FOLDER, "fit")); cat(best)
"""
R_LOESS = (
    'predict(loess(y ~ x, span = {points} / length(x), degree = {degree}, family = "{family}", '
    'control = loess.control(surface = "{surface}", statistics = "approximate", trace.hat = "approximate")))'
)
R_LOWESS = "lowess(x, y, f = {points} / length(x) + 1e-9, iter = {steps}, delta = 0)$y"


def curve(t):
    return numpy.sin(12 * t) + 0.3 * numpy.sin(66 * t)


def draw(count, uniform, outliers, seed, sigma=0.2):
    """Positions in [0, 1], data and the curve; a share of outliers, ten deviations up and down."""
    generator = numpy.random.default_rng([2026, seed, count])
    x = numpy.arange(count) / count if uniform else numpy.sort(generator.uniform(0, 1, count))
    y = curve(x) + generator.normal(0, sigma, count)
    hit = generator.uniform(size=count) < outliers
    y[hit] += generator.choice([-10 * sigma, 15 * sigma], hit.sum())
    return x, y, curve(x)


def timed(call, runs):
    best, answer = float("inf"), None
    for _ in range(runs):
        begin = time.process_time()
        answer = call()
        best = min(best, time.process_time() - begin)
    return best, answer


def by_subcert(scheme, uniform, **more):
    def run(x, y, runs):
        where = dict(spacing=subcert.fraction(1) / y.size) if uniform else dict(x=x, irregular=True)
        options = dict(bands=0, jobs=1, at="data") | more
        return timed(lambda: subcert.smooth(y, scheme=scheme, **where, **options).values, runs)

    return run


def by_savgol(points, degree):
    return lambda x, y, runs: timed(lambda: scipy.signal.savgol_filter(y, points, degree), runs)


def by_statsmodels(points, steps):
    return lambda x, y, runs: timed(
        lambda: lowess_module.lowess(y, x, frac=points / y.size + 1e-12, it=steps, return_sorted=False), runs
    )


def by_r(call, **values):
    def run(x, y, runs):
        with tempfile.TemporaryDirectory() as folder:
            x.tofile(Path(folder, "x"))
            y.tofile(Path(folder, "y"))
            program = R_PROGRAM.replace("CALL", call.format(**values)).replace("RUNS", str(runs))
            program = program.replace("FOLDER", f'"{folder}"')
            done = subprocess.run(["Rscript", "-e", program], capture_output=True, text=True, check=True)
            return float(done.stdout), numpy.fromfile(Path(folder, "fit"))

    return run


def linear_methods(points, uniform):
    """Name, the largest number of data to try, and what smooths."""
    for degree in (1, 3) if uniform else ():
        yield f"`local:points={points},d={degree},weight=box`", 10**7, by_subcert(
            f"local:points={points},d={degree},weight=box", uniform
        )
        yield f"SciPy `savgol_filter(y, {points}, {degree})`", 10**7, by_savgol(points, degree)
    for degree in (1, 2):
        yield f"`local:points={points},d={degree}`", 10**7, by_subcert(f"local:points={points},d={degree}", uniform)
        yield f"R `loess`, degree {degree}", 10**5, by_r(
            R_LOESS, points=points, degree=degree, family="gaussian", surface="interpolate"
        )
    yield f"statsmodels `lowess`, it=0", 10**6, by_statsmodels(points, 0)
    yield f"R `lowess`, iter=0", 10**7, by_r(R_LOWESS, points=points, steps=0)


def robust_methods(points, uniform):
    for degree in (1, 2):
        yield f"`local:points={points},d={degree},robust=3`", 10**7, by_subcert(
            f"local:points={points},d={degree},robust=3", uniform
        )
        yield f'R `loess(family = "symmetric")`, degree {degree}', 10**5, by_r(
            R_LOESS, points=points, degree=degree, family="symmetric", surface="interpolate"
        )
    yield f'the same with `surface = "direct"`, degree 1', 10**4, by_r(
        R_LOESS, points=points, degree=1, family="symmetric", surface="direct"
    )
    yield f"statsmodels `lowess`, it=3", 10**6, by_statsmodels(points, 3)
    yield f"R `lowess`, iter=3", 10**7, by_r(R_LOWESS, points=points, steps=3)


def rms(values, truth):
    return float(numpy.sqrt(numpy.mean((values - truth) ** 2)))


def tables_of_values(out, count, points, runs):
    for outliers, methods in ((0, linear_methods), (0.2, robust_methods)):
        title = "Robustness: one datum in five an outlier" if outliers else "Value"
        out(f"\n## {title}\n\n{count} data, windows of {points}.\n")
        out("| data | method | seconds | error |\n|---|---|---|---|")
        for uniform in (True, False):
            x, y, truth = draw(count, uniform, outliers, 1)
            for name, _, method in methods(points, uniform):
                seconds, values = method(x, y, runs)
                out(f"| {'uniform' if uniform else 'scattered'} | {name} | {seconds:.4f} | {rms(values, truth):.5f} |")
            if outliers:
                seconds, values = by_subcert(f"local:points={points},d=1", uniform)(x, y, runs)
                out(f"| {'uniform' if uniform else 'scattered'} | none of these: `local:points={points},d=1` "
                    f"| {seconds:.4f} | {rms(values, truth):.5f} |")


def table_of_wide_windows(out, count, windows, runs):
    """Robust fits whose windows grow with the number of data, each method beside the others."""
    out(f"\n## Robustness: {count} scattered data, one in five an outlier\n\nSeconds and error.\n")
    out('| window | degree | `robust=3` | R `loess(family = "symmetric")` | R `lowess`, iter=3 |\n|---|---|---|---|---|')
    x, y, truth = draw(count, False, 0.2, 1)
    for points in windows:
        for degree in (1, 2):
            methods = [
                by_subcert(f"local:points={points},d={degree},robust=3", False),
                by_r(R_LOESS, points=points, degree=degree, family="symmetric", surface="interpolate"),
            ]
            if degree == 1:
                methods.append(by_r(R_LOWESS, points=points, steps=3))
            cells = []
            for method in methods:
                seconds, values = method(x, y, runs)
                cells.append(f"{seconds:.2f}, {rms(values, truth):.5f}")
            out(f"| {points} | {degree} | " + " | ".join(cells + ["-"] * (degree - 1)) + " |")


def table_of_choices(out, counts):
    out("\n## Choice of the window\n\nThe best fixed window is the best of 1.2^k points for the curve itself, which "
        "only a benchmark knows.\n")
    out("| data | number | method | chosen | seconds | error | best fixed window |\n|---|---|---|---|---|---|---|")
    for uniform in (True, False):
        for count in counts:
            x, y, truth = draw(count, uniform, 0, 2)
            where = dict(spacing=subcert.fraction(1) / count) if uniform else dict(x=x, irregular=True, at="data")
            best, points = float("inf"), 8
            while points < count / 2:
                fit = subcert.smooth(y, scheme=f"local:points={points},d=1", bands=0, jobs=1, **where).values
                error = rms(fit, truth)
                if error > 2 * best:
                    break
                best, points = min(best, error), points + 1 + points // 5
            for scheme, select in (("local:d=1", "risk"), ("local:d=1", "cv"), ("", "risk")):
                seconds, fit = timed(
                    lambda: subcert.smooth(y, scheme=scheme, select=select, bands=0, jobs=1, **where), 1
                )
                name = f"`{scheme}`" if scheme else "automatic"
                name += ", `--select cv`" if select == "cv" else ""
                out(f"| {'uniform' if uniform else 'scattered'} | {count} | {name} | `{fit.scheme}` | {seconds:.2f} "
                    f"| {rms(fit.values, truth):.5f} | {best:.5f} |")


R_COVERAGE = r"""
fit <- loess(y ~ x, span = SPAN, degree = 1, family = "FAMILY", control = loess.control(surface = "direct"))
p <- predict(fit, x, se = TRUE); half <- qt(0.975, p$df) * p$se.fit
c(p$fit, half)
"""


def table_of_coverage(out, runs, count=200, points=41):
    out(f"\n## Coverage of bands of 95 %\n\n{count} scattered data about a line, windows of {points}, degree 1, {runs} "
        "draws; the share of the positions at which the band holds the line, and the mean half width. The last column "
        "is the standard deviation of the share, from the draws; l1 schemes and R have a fifth of these.\n")
    out("| outliers | method | share | half width | deviation |\n|---|---|---|---|---|")
    for outliers in (0.0, 0.2):
        methods = {
            f"`local:points={points},d=1`": f"local:points={points},d=1",
            f"`local:points={points},d=1,robust=3`, sandwich": f"local:points={points},d=1,robust=3",
            "`l1:points=14,iterations=12`, bootstrap": "l1:points=14,iterations=12",
        }
        shares = {name: [] for name in (*methods, "R `loess`", 'R `loess(family = "symmetric")`')}
        widths = {name: [] for name in shares}
        for run in range(runs):
            generator = numpy.random.default_rng([7, run])
            x = numpy.sort(generator.uniform(0, 10, count))
            truth = 1 + x / 3
            y = truth + generator.normal(0, 0.3, count)
            hit = generator.uniform(size=count) < outliers
            y[hit] += generator.choice([-4, 6], hit.sum())

            def note(name, values, half, line):
                shares[name].append(numpy.mean(numpy.abs(values - line) <= half))
                widths[name].append(numpy.mean(half))

            for name, scheme in methods.items():
                if scheme.startswith("l1") and run >= runs // 5:
                    continue
                more = dict(resamples=100) if scheme.startswith("l1") else {}
                fit = subcert.smooth(y, x, irregular=True, at="data", scheme=scheme, jobs=1, **more)
                note(name, fit.values, fit.upper - fit.values, truth)
            if run >= runs // 5:
                continue
            for name, family in (("R `loess`", "gaussian"), ('R `loess(family = "symmetric")`', "symmetric")):
                call = "{" + R_COVERAGE.replace("SPAN", f"{points}/{count} + 1e-9").replace("FAMILY", family) + "}"
                both = by_r(call.replace("{", "{{").replace("}", "}}"))(x, y, 1)[1]
                note(name, both[:count], both[count:], truth)
        for name in shares:
            each = numpy.array(shares[name])
            out(f"| {outliers:.0%} | {name} | {each.mean():.3f} | {numpy.mean(widths[name]):.3f} "
                f"| {each.std() / len(each) ** 0.5:.3f} |")


def table_of_speed(out, largest, points, budget):
    out(f"\n## Speed\n\nSeconds for windows of {points}; a dash where a call would take more than about {budget} s or "
        "more memory than 2 GB.\n")
    counts = [10**k for k in range(3, 8) if 10**k <= largest]
    for title, methods, outliers in (("linear", linear_methods, 0.0), ("robust", robust_methods, 0.2)):
        for uniform in (True, False):
            heads = " | ".join(f"10^{k}" for k in range(3, 3 + len(counts)))
            out(f"\n| {title}, {'uniform' if uniform else 'scattered'} | {heads} |")
            out("|---" * (1 + len(counts)) + "|")
            for name, most, method in methods(points, uniform):
                cells, last = [], 0.0
                for count in counts:
                    if count > most or last * 10 > budget:
                        cells.append("-")
                        continue
                    x, y, _ = draw(count, uniform, outliers, 3)
                    try:
                        last, _ = method(x, y, 1)
                        cells.append(f"{last:.3g}")
                    except Exception as error:  # a limit of the other program, or of this one
                        print(f"{name}, {count}: {error}", file=sys.stderr)
                        cells.append("-")
                out(f"| {name} | " + " | ".join(cells) + " |")


def versions():
    r = subprocess.run(["Rscript", "-e", "cat(R.version.string)"], capture_output=True, text=True, check=True).stdout
    return (f"subcert {subcert.__version__}, Python {platform.python_version()}, NumPy {numpy.__version__}, "
            f"SciPy {scipy.__version__}, statsmodels {statsmodels.__version__}, {r}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--count", type=int, default=20_000, help="data for value and robustness (20000)")
    parser.add_argument("--points", type=int, default=201, help="data in a window (201)")
    parser.add_argument("--runs", type=int, default=2, help="runs of each method (2)")
    parser.add_argument("--draws", type=int, default=200, help="draws for the coverage (200)")
    parser.add_argument("--largest", type=int, default=10**7, help="number of data (10^7)")
    parser.add_argument("--budget", type=float, default=40, help="seconds for one call (40)")
    parser.add_argument("--out", help="file for the tables")
    arguments = parser.parse_args()
    warnings.simplefilter("ignore")
    lines = []

    def out(line):
        print(line, flush=True)
        lines.append(line)

    out(f"Made by `bench/smoothing_comparison.py` in one run: {versions()}; {platform.machine()}, one processor.")
    tables_of_values(out, arguments.count, arguments.points, arguments.runs)
    if arguments.largest >= 10**5:
        table_of_wide_windows(out, 10**5, (201, 1001, 1999, 4001), arguments.runs)
    table_of_choices(out, [n for n in (10**3, 10**4, 10**5, 10**6) if n <= arguments.largest])
    table_of_coverage(out, arguments.draws)
    table_of_speed(out, arguments.largest, arguments.points, arguments.budget)
    if arguments.out:
        Path(arguments.out).write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
