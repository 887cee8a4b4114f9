#!/usr/bin/env python3
"""The page on which a parameter is moved, in a browser without a window. Usage: explorer_page.py SUBCERT BROWSER

Opened from a file: no error, nothing wider than a narrow screen; moving the slider moves mask, exponent and pictures, and
what is shown is what the program says of that value.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

from browser import answers_of

subcert, browser = (str(Path(word).resolve()) for word in sys.argv[1:3])


def ran(*words):
    return subprocess.run([subcert, *words], capture_output=True, text=True, check=True).stdout


SCRIPT = """
await wait(300);
const slider = document.querySelector('form.explorer input'), seen = [];
const text = name => document.querySelector(`[data-shows=${name}]`).textContent.replaceAll('\\u200b', '');
const curves = name => [...document.querySelectorAll(`[data-shows=${name}] > path`)].map(path => path.getAttribute('d'));
for (let i = 0; i <= +slider.max; ++i) {
  slider.value = i;
  slider.dispatchEvent(new Event('input', {bubbles: true}));
  seen.push({w: document.querySelector('form.explorer output').textContent, mask: text('mask'), exponent: text('value'),
             limit: curves('limit'), variance: curves('variance'), curve: curves('curve').length,
             marker: curves('curve').at(-1)});
}
const ticks = [...document.querySelectorAll('[data-shows=curve] .ticks text')].map(tick => tick.textContent);
return {seen, ticks, faults, wide: document.documentElement.scrollWidth > innerWidth,
        requests: performance.getEntriesByType('resource').length};
"""

with tempfile.TemporaryDirectory() as work:
    page = Path(work, "explorer.html")
    ran("analyze", "four-point:w", "--over", "w=-3/4..1/2", "--html", str(page))
    for size in [(1400, 900), (420, 900)]:
        answer = answers_of(browser, page, SCRIPT, size=size)
        assert answer and "failed" not in answer, answer
        assert not answer["faults"] and not answer["wide"] and answer["requests"] == 0, answer["faults"]
assert answer["ticks"] == ["-0.6", "-0.4", "-0.2", "0.0", "0.2", "0.4", "0.0", "0.5", "1.0", "1.5", "2.0"], answer["ticks"]
seen = {one["w"]: one for one in answer["seen"]}
assert len(seen) >= 61 and len({one["marker"] for one in seen.values()}) == len(seen)
assert seen["1/16"]["exponent"] == "2", seen["1/16"]["exponent"]
assert seen["0"]["exponent"].startswith("1") or "..." in seen["0"]["exponent"], seen["0"]["exponent"]
converging = [one for one in seen.values() if one["limit"]]
assert 40 < len(converging) < len(seen) and len({one["limit"][0] for one in converging}) == len(converging)
assert all(len(one["variance"]) == 1 for one in converging)
for one in seen.values():
    assert bool(one["limit"]) == ("converge" not in one["exponent"]), one
for w in ["1/16", "1/4", "-1/8", "-3/4"]:
    assert seen[w]["mask"] == ran("mask", f"four-point:w={w}").strip(), (w, seen[w]["mask"])
print(f"{len(seen)} values, {len(converging)} of them with pictures")
