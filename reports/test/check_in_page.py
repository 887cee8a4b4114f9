#!/usr/bin/env python3
"""The buttons of the page, clicked in a browser without a window. Usage: check_in_page.py SUBCERT BROWSER

The page is opened from a file. Each proof must be verified; with another upper end, or with another certificate under its
name, it must not be."""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from browser import answers_of

subcert, browser = sys.argv[1:3]

CLICKS = """
  const answers = [], buttons = [...document.querySelectorAll('button.check')];
  const click = async (button, kind) => {
    button.click();
    while (button.disabled) await new Promise(done => setTimeout(done, 20));
    const answer = button.nextElementSibling;
    answers.push([kind, button.dataset.certificate, answer.className, answer.textContent]);
  };
  for (const button of buttons) await click(button, 'as it is');
  const words = JSON.parse(buttons[0].dataset.words);
  words[words.indexOf('--upper') + 1] = '1';
  buttons[0].dataset.words = JSON.stringify(words);
  await click(buttons[0], 'another claim');
  const other = [...JSON.parse(buttons[1].dataset.words).slice(0, -1), JSON.parse(buttons[2].dataset.words).at(-1)];
  buttons[1].dataset.words = JSON.stringify(other);
  buttons[1].dataset.certificate = buttons[2].dataset.certificate;
  await click(buttons[1], 'another certificate');
  buttons[2].dataset.certificate = 'none.js';
  await click(buttons[2], 'no certificate');
  return answers;
"""

with tempfile.TemporaryDirectory() as folder:
    subprocess.run([subcert, "reproduce", "dyn-2015", "--only", "exponents", "--out", folder], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    page = Path(folder) / "dyn-2015.html"
    text = page.read_text()
    answers = answers_of(browser, page, CLICKS, seconds=240)

in_time = answers is not None
answers = answers or []
failures = [] if in_time else ["the page did not answer"]
buttons = len(re.findall("<button type=button class=check", text))
if in_time and len(answers) != buttons + 3:
    failures.append(f"{len(answers)} answers of {buttons} buttons")
for kind, name, mark, answer in answers:
    wanted = {"as it is": ("proved", "VERIFIED "), "no certificate": ("refused", "not checked: ")}
    if (mark, answer[:len(wanted.get(kind, ("refused", "REJECTED "))[1])]) != wanted.get(kind, ("refused", "REJECTED ")):
        failures.append(f"{name}, {kind}: {answer}")
seconds = [float(match[1]) for *_, answer in answers if (match := re.search(r"\(([\d.]+) s\)$", answer))]
print(f"{buttons} buttons, {len(failures)} failures, the slowest check took {max(seconds, default=0)} s")
for failure in failures:
    print(failure)
sys.exit(bool(failures))
