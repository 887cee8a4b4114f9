"""Draws times over dimension and vertices from a run of the polytope benchmarks.

  cmake --build build/release --target benchmarks
  build/release/bench/subcert_bench --benchmark_filter=polytope --benchmark_out=polytope.json --benchmark_out_format=json
  python3 bench/polytope_times.py polytope.json docs/images/polytope-times.svg
"""
import json
import subprocess
import sys


def main():
    source, target = sys.argv[1:]
    with open(source) as file:
        runs = json.load(file)["benchmarks"]
    search = {r["name"].split("/", 1)[1]: r for r in runs if r["name"].startswith("BM_polytope_search/")}
    proof = {r["name"].split("/", 1)[1]: r["cpu_time"] for r in runs if r["name"].startswith("BM_polytope_proof/")}
    data = "".join(f"{r['dimension']} {r['vertices']} {r['cpu_time']} {proof[scheme]}\n" for scheme, r in search.items())
    plots = ("'-' using 1:3 title 'search' with points pt 7 ps 0.6 lc rgb '#1f6f8b', "
             "'-' using 1:4 title 'proof' with points pt 6 ps 0.6 lc rgb '#c8553d'")
    script = f"""set terminal svg size 860,330 font 'DejaVu Sans,11'
set output '{target}'
set logscale y
set grid lc rgb '#dddddd'
set key top left
set ylabel 'milliseconds'
set multiplot layout 1,2
set xlabel 'dimension'
plot {plots}
{data}e
{data}e
set logscale x
set xlabel 'vertices'
plot {plots.replace('1:', '2:')}
{data}e
{data}e
unset multiplot
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


main()
