#!/usr/bin/env python3
"""Speed and error of `subcert.smooth` beside scipy.signal.savgol_filter and the lowess of statsmodels, in one run.

Needs the Python package of subcert and Debian's python3-scipy and python3-statsmodels:

    PYTHONPATH=build/release/python /usr/bin/python3 bench/smoothing_comparison.py

All windows have 21 data, but for the methods that choose. Times are the medians of the runs, on one core; the root mean
square error is that to the curve without noise."""

import argparse
import statistics
import time
import warnings

import numpy
import scipy.signal
import statsmodels.nonparametric.smoothers_lowess as lowess_module

import subcert


def timed(runs, smooth):
    times, answer = [], None
    for _ in range(runs):
        begin = time.perf_counter()
        answer = smooth()
        times.append(time.perf_counter() - begin)
    return statistics.median(times), answer


def lowess(y, x, points, robust):
    return lowess_module.lowess(y, x, frac=points / y.size, it=3 if robust else 0, return_sorted=False)


def methods(y, x, uniform, points):
    """Name, and what gives values at the data."""
    options = {"bands": 0, "jobs": 1}
    if uniform:
        yield f"subcert {scheme(points)}", lambda: subcert.smooth(y, scheme=scheme(points), **options).values
        with_bands = dict(options, bands=0.95, kind="simultaneous")
        yield f"subcert {scheme(points)}, simultaneous bands", lambda: subcert.smooth(
            y, scheme=scheme(points), **with_bands
        ).values
        box = f"local:points={points},d=1,weight=box"
        yield f"subcert {box}", lambda: subcert.smooth(y, scheme=box, **options).values
        yield f"scipy savgol_filter({points}, 1)", lambda: scipy.signal.savgol_filter(y, points, 1)
        cubic = f"local:points={points},d=3,weight=box"
        yield f"subcert {cubic}", lambda: subcert.smooth(y, scheme=cubic, **options).values
        yield f"scipy savgol_filter({points}, 3)", lambda: scipy.signal.savgol_filter(y, points, 3)
    tricube = f"local:points={points},d=1,weight=tricube"
    where = {} if uniform else {"x": x, "irregular": True, "at": "data"}
    yield f"subcert {tricube}", lambda: subcert.smooth(y, scheme=tricube, **where, **options).values
    yield f"statsmodels lowess, {points} points, it=0", lambda: lowess(y, x, points, False)
    yield f"statsmodels lowess, {points} points, it=3", lambda: lowess(y, x, points, True)
    chosen = "" if uniform else "local:d=1"
    yield "subcert, method chosen from the data", lambda: subcert.smooth(y, scheme=chosen, **where, **options).values


def scheme(points):
    return f"primal:n={(points + 1) // 2}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--count", type=int, default=20_000, help="data (20000)")
    parser.add_argument("--runs", type=int, default=3, help="runs of each method (3)")
    arguments = parser.parse_args()
    warnings.simplefilter("ignore")
    generator = numpy.random.default_rng(2015)
    count = arguments.count
    print("| data | method | seconds | root mean square error |\n|---|---|---|---|")
    for uniform in (True, False):
        x = numpy.arange(count) / 100.0 if uniform else numpy.sort(generator.uniform(0, count / 100.0, count))
        truth = numpy.sin(2 * x) + 0.3 * numpy.sin(11 * x)
        y = truth + generator.normal(0, 0.2, count)
        points = 21
        for name, smooth in methods(y, x, uniform, points):
            seconds, values = timed(arguments.runs, smooth)
            error = numpy.sqrt(numpy.mean((values - truth) ** 2))
            print(f"| {'uniform' if uniform else 'scattered'} | {name} | {seconds:.4f} | {error:.4f} |", flush=True)


if __name__ == "__main__":
    main()
