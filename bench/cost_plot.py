"""Draws the times of benchmarks over their argument, on logarithmic scales of time.

  build/release/bench/subcert_bench --benchmark_filter=BM_range --benchmark_out=cost.json --benchmark_out_format=json
  python3 bench/cost_plot.py cost.json docs/images/range-cost.svg 'digits of the width'
"""
import json
import subprocess
import sys


def main():
    source, target, label = sys.argv[1:]
    with open(source) as file:
        runs = json.load(file)["benchmarks"]
    curves = {}
    for run in runs:
        _, name, argument = run["name"].split("/")[:3]
        curves.setdefault(name.replace("_", " "), []).append(f"{argument} {run['real_time']}\n")
    colours = ["#1f6f8b", "#c8553d", "#588b1f", "#7a4fa3"]
    plots = ", ".join(f"'-' using 1:2 title '{name}' with linespoints pt 7 ps 0.6 lc rgb '{colour}'"
                      for name, colour in zip(curves, colours, strict=False))
    data = "".join("".join(points) + "e\n" for points in curves.values())
    script = f"""set terminal svg size 560,330 font 'DejaVu Sans,11'
set output '{target}'
set logscale y
set grid lc rgb '#dddddd'
set key top left
set xlabel '{label}'
set ylabel '{runs[0]["time_unit"]}'
plot {plots}
{data}"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


main()
