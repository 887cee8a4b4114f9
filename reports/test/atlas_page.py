#!/usr/bin/env python3
"""Pages of an atlas, opened from files in a browser without a window: the search, links to entries, proofs. Usage:
atlas_page.py SUBCERT BROWSER"""
import subprocess
import sys
import tempfile
from pathlib import Path

from browser import answers_of

subcert, browser = sys.argv[1:3]

SEARCH = """
  const shown = () => [...document.querySelectorAll('table.entries tbody tr')].filter(row => !row.hidden).length;
  const answers = [shown()], field = document.querySelector('input[type=search]');
  for (const text of ['dd:n=3', 'interpolatory', 'diverges', 'no such thing', '']) {
    field.value = text;
    field.dispatchEvent(new Event('input', {bubbles: true}));
    answers.push(shown());
  }
  return [...answers, faults, document.querySelector('table.entries a').getAttribute('href')];
"""
PROOFS = """
  const answers = [];
  for (const button of document.querySelectorAll('button.check')) {
    button.click();
    while (button.disabled) await wait(20);
    answers.push(button.nextElementSibling.textContent.slice(0, 9));
  }
  return [answers, document.querySelectorAll('svg.picture').length, faults];
"""

with tempfile.TemporaryDirectory() as folder:
    atlas = ["--atlas", folder + "/atlas.sqlite"]
    subprocess.run([subcert, "atlas", "build", "dd:n=1..4", "mask:[1,0,0,1]", "--certificates", *atlas], check=True)
    subprocess.run([subcert, "atlas", "site", "--out", folder, *atlas], check=True)
    found = answers_of(browser, Path(folder) / "index.html", SEARCH)
    assert found[:6] == [5, 1, 5, 1, 0, 5] and found[6] == [], found
    page, entry = found[7].split("#")
    assert f'id="{entry}"' in (Path(folder) / page).read_text(), found
    for page, proofs in {"4.html": 1, "6.html": 0}.items():
        answers, pictures, faults = answers_of(browser, Path(folder) / page, PROOFS)
        assert answers == ["VERIFIED "] * proofs and pictures == proofs and faults == [], (page, answers, faults)
