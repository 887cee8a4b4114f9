#!/usr/bin/env python3
"""The pages in a browser without a window. Usage: pages_test.py SUBCERT BROWSER LINKS

A report, a comparison and the page of a scheme, opened from files: no error, every link leads somewhere (LINKS is the
program that checks links), nothing is wider than a narrow and a wide screen, text has the contrast of WCAG AA in light
and dark, what can be used has a name; cells, pictures, surfaces and the filter do what they are for.
"""
import json
import subprocess
import sys
import tempfile
import urllib.parse
from pathlib import Path

from browser import answers_of

subcert, browser, links = (str(Path(word).resolve()) for word in sys.argv[1:4])
failures = []

# What has no name, what is too wide, and text whose contrast with what lies behind it is too low.
LOOK = """
await wait(300);
const found = [];
for (const part of document.querySelectorAll('button, a[href], input, select, img, [role=img], [role=region]'))
  if (!(part.getAttribute('aria-label') || part.getAttribute('alt') || part.textContent.trim() ||
        (part.labels && part.labels.length) || part.querySelector('[aria-label]')))
    found.push('no name: ' + part.outerHTML.slice(0, 120));
if (!document.documentElement.lang) found.push('no language');
if (document.documentElement.scrollWidth > innerWidth) {
  const wide = [...document.body.querySelectorAll('*')].filter(part => {
    if (part.getBoundingClientRect().right <= innerWidth + 1) return false;
    for (let box = part.parentElement; box !== document.body; box = box.parentElement)
      if (getComputedStyle(box).overflowX !== 'visible') return false;
    return true;
  });
  found.push('wider than the screen: ' + wide.map(part => part.outerHTML.slice(0, 80)).slice(0, 3).join(' | '));
}
const canvas = document.createElement('canvas').getContext('2d', {willReadFrequently: true});
const rgba = colour => {
  canvas.clearRect(0, 0, 1, 1);
  canvas.fillStyle = colour;
  canvas.fillRect(0, 0, 1, 1);
  return [...canvas.getImageData(0, 0, 1, 1).data];
};
const over = (front, back) => front.slice(0, 3).map((value, k) => value * front[3] / 255 + back[k] * (1 - front[3] / 255));
const luminance = colour => {
  const [r, g, b] = colour.map(value => (value / 255 <= 0.04045 ? value / 255 / 12.92 : ((value / 255 + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
};
const behind = part => {
  const layers = [];
  for (let box = part; box; box = box.parentElement) layers.push(rgba(getComputedStyle(box).backgroundColor));
  return layers.reverse().reduce((back, layer) => over(layer, back), dark ? [18, 23, 29] : [255, 255, 255]);
};
const seen = new Set();
for (const part of document.body.querySelectorAll('*')) {
  if (![...part.childNodes].some(node => node.nodeType === 3 && node.textContent.trim())) continue;
  if (part.closest('script, style, [hidden], details:not([open]) > :not(summary), .zero-coefficient')) continue;
  const style = getComputedStyle(part), back = behind(part);
  const ink = over(rgba(part instanceof SVGElement ? style.fill : style.color), back);
  const [low, high] = [luminance(ink), luminance(back)].sort((a, b) => a - b), contrast = (high + 0.05) / (low + 0.05);
  const what = `${part.tagName}.${part.getAttribute('class')}`;
  if (contrast < 4.5 && !seen.has(what)) {
    seen.add(what);
    found.push(`contrast ${contrast.toFixed(2)}: ${what} '${part.textContent.trim().slice(0, 30)}'`);
  }
}
return {found, faults, width: innerWidth, dark: matchMedia('(prefers-color-scheme: dark)').matches};
"""

PICTURES = """
await wait(300);
const said = [], check = (what, holds) => { if (!holds) said.push(what); };
const key = (name, more = {}) => svg.dispatchEvent(new KeyboardEvent('keydown', {key: name, bubbles: true, ...more}));
const svg = [...document.querySelectorAll('svg.picture')].find(one => one.querySelectorAll('.series').length > 1 &&
                                                                      one.parentElement.querySelector('.legend'));
const moving = svg.querySelector('.moving'), reading = svg.parentElement.querySelector('.reading');
const ticks = () => [...svg.querySelectorAll('.ticks text')].map(text => text.textContent).join();
const whole = ticks();
svg.focus();
key('+'), key('+');
const scale = () => Number(/scale\\(([\\d.]+)/.exec(moving.getAttribute('transform'))[1]);
check('zoom by keys', Math.abs(scale() - 2.25) < 1e-6 && ticks() !== whole);
key('ArrowRight', {shiftKey: true});
key('0');
check('the whole picture again', scale() === 1 && ticks() === whole);
key('ArrowRight');
const first = reading.textContent;
key('ArrowRight');
check('points by keys', first && reading.textContent && reading.textContent !== first);
key('ArrowDown');
check('the next curve', reading.textContent.split(':')[0] !== first.split(':')[0]);
const box = svg.getBoundingClientRect();
svg.dispatchEvent(new WheelEvent('wheel', {deltaY: -400, clientX: box.x + box.width / 2, clientY: box.y + box.height / 2,
                                           cancelable: true}));
check('zoom by the wheel', scale() > 1.5);
key('0');
let read = 0;
for (let x = 0.1; x < 0.95; x += 0.05)
  for (let y = 0.1; y < 0.95; y += 0.05) {
    svg.dispatchEvent(new PointerEvent('pointermove', {clientX: box.x + box.width * x, clientY: box.y + box.height * y,
                                                       pointerType: 'mouse', pointerId: 7}));
    read += reading.textContent !== '';
  }
check('values under the pointer', read > 0);
const switches = svg.parentElement.querySelector('.legend button');
switches.click();
const hidden = [...svg.querySelectorAll('.series')].filter(one => one.style.display === 'none').length;
switches.click();
check('series to switch off and on', hidden === 1 && switches.getAttribute('aria-pressed') === 'true');
return {said, faults};
"""

CELLS = """
await wait(300);
const said = [], check = (what, holds) => { if (!holds) said.push(what); };
const told = JSON.parse(document.getElementById('details').textContent), panel = document.querySelector('.details-panel');
for (const key in told) {
  const cell = document.getElementById(key);
  check('a place for ' + key, cell);
  if (!cell) break;
  cell.click();
  check('what is told of ' + key, !panel.hidden && panel.textContent.includes(told[key].command) &&
        panel.textContent.includes('#' + key) && panel.textContent.includes(told[key].verdict));
}
document.dispatchEvent(new KeyboardEvent('keydown', {key: 'Escape'}));
check('closed by Escape', panel.hidden);
const cell = document.querySelector('.told');
cell.dispatchEvent(new KeyboardEvent('keydown', {key: 'Enter', bubbles: true}));
check('opened by Enter', !panel.hidden);
return {said, faults, count: Object.keys(told).length};
"""

LINKED = """
await wait(300);
const panel = document.querySelector('.details-panel'), cell = document.getElementById(location.hash.slice(1));
const {top, bottom} = cell.getBoundingClientRect();
return {said: !panel.hidden && cell.matches('.opened') && top >= 0 && bottom <= innerHeight ? [] : ['a link to a cell'],
        faults};
"""

FILTER = """
await wait(300);
const shown = () => document.querySelectorAll('table.results tbody tr:not([hidden])').length;
const form = document.querySelector('form.filter'), counts = [shown()];
form.elements.verdict.value = 'match', form.dispatchEvent(new Event('input'));
counts.push(shown());
form.elements.search.value = 'primal', form.dispatchEvent(new Event('input'));
counts.push(shown());
const link = location.hash;
form.reset();
await wait(100);
counts.push(shown());
return {counts, link, faults, said: []};
"""

SURFACES = """
await wait(300);
const said = [], button = document.querySelector('button.turn');
if (button) {
  button.click();
  for (let i = 0; i < 50 && !document.querySelector('.surface canvas'); ++i) await wait(100);
}
await wait(300);
const canvas = document.querySelector('.surface canvas');
if (!canvas) return {said: ['no surface: ' + (button && button.textContent)], faults};
const look = () => canvas.toDataURL();
const before = look();
canvas.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowLeft', bubbles: true}));
await wait(200);
if (look() === before) said.push('a surface turns');
return {said, faults};
"""

PROOF = """
const button = document.querySelector('button.check'), answer = button.nextElementSibling;
button.click();
while (button.disabled) await wait(20);
return {said: answer.className === 'proved' && answer.textContent.startsWith('VERIFIED') ? [] : [answer.textContent], faults};
"""


def ask(page, what, script, **options):
    """The answer of the page; what it says, and the errors of the page, are failures."""
    name = f"{page.name}{options.get('link', '')}, {what}"
    answer = answers_of(browser, page, script, **options)
    if answer is None or "failed" in answer:
        failures.append(f"{name}: {'no answer' if answer is None else answer['failed']}")
        return {}
    failures.extend(f"{name}: {fault}" for fault in answer["faults"] + answer.get("said", []) + answer.get("found", []))
    return answer


def made(folder, *words):
    subprocess.run([subcert, *words], check=True, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


with tempfile.TemporaryDirectory() as name:
    folder = Path(name)
    made(folder, "reproduce", "dyn-2015", "--only", "masks,table1,fig1,levels,fig5,fig19", "--out", ".")
    made(folder, "compare", "primal:n=2", "dual:n=2", "four-point:w=1/16", "--html", "compare.html")
    made(folder, "analyze", "primal:n=3", "--html", "scheme.html")
    made(folder, "analyze", "loop", "--html", "surface.html")
    made(folder, "vertex", "catmull-clark", "--valence", "3..5", "--html", "vertices.html")
    made(folder, "gallery", "--vertices", "--valence", "3..5", "--out", "gallery-of-vertices.html")
    made(folder, "statements", "check", "mustafa-hameed", "--page", "errata.html")
    broken = subprocess.run([sys.executable, "-B", links, folder], capture_output=True, text=True, check=False)
    if broken.returncode:
        failures.append(broken.stdout)
    paper, pages = folder / "dyn-2015.html", sorted(folder.glob("*.html"))
    results = json.loads((folder / "results.json").read_text())["results"]
    for page in pages:
        if page.stat().st_size > 3_000_000:
            failures.append(f"{page.name}: {page.stat().st_size} bytes")
        for width, dark in ((1400, False), (1400, True), (360, False)):
            answer = ask(page, f"{width} pixels, {'dark' if dark else 'light'}", f"const dark = {str(dark).lower()};" + LOOK,
                         size=(width, 900), dark=dark)
            if answer and (answer["width"], answer["dark"]) != (width, dark):
                failures.append(f"{page.name}: asked for {width} pixels, dark {dark}, got {answer}")
    for page in (paper, folder / "compare.html"):
        ask(page, "pictures", PICTURES)
    told = ask(paper, "cells", CELLS)
    if told and told["count"] != len(results):
        failures.append(f"{told['count']} results are told of {len(results)}")
    ask(paper, "a link to a cell", LINKED, link="#" + urllib.parse.quote(results[-1]["key"]))
    for page in (paper, folder / "surface.html", folder / "vertices.html"):
        ask(page, "surfaces", SURFACES)
    for page in (folder / "scheme.html", folder / "compare.html", folder / "surface.html"):
        ask(page, "proof", PROOF)
    matches = [one for one in results if one["verdict"] == "match"]
    filtered = ask(folder / "results.html", "filter", FILTER)
    if filtered:
        found = [len(results), len(matches), sum("primal" in json.dumps(one) for one in matches), len(results)]
        if filtered["counts"] != found or filtered["link"] != "#verdict=match&search=primal":
            failures.append(f"filter: {filtered}, expected {found}")
    linked = ask(folder / "results.html", "a link to a choice", FILTER, link="?kind=claim")
    if linked and linked["counts"][0] != sum(one["kind"] == "claim" for one in results):
        failures.append(f"a link to a choice: {linked}")

print(f"{len(pages)} pages, {len(failures)} failures", *failures, sep="\n")
sys.exit(bool(failures))
