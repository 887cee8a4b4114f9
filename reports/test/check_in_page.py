#!/usr/bin/env python3
"""The buttons of the page, clicked in a browser without a window. Usage: check_in_page.py SUBCERT BROWSER

The page is opened from a file. Each proof must be verified; with another upper end, or with another certificate under its
name, it must not be. The page sends its answers to a port of this machine."""
import http.server
import json
import re
import subprocess
import sys
import tempfile
import threading
from pathlib import Path

subcert, browser = sys.argv[1:3]
answers = []
arrived = threading.Event()


class Receiver(http.server.BaseHTTPRequestHandler):
    def do_POST(self):
        answers.extend(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
        self.send_response(204)
        self.end_headers()
        arrived.set()

    def log_message(self, *_):
        pass


CLICKS = """
(async () => {
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
  await fetch('http://127.0.0.1:PORT/', {method: 'POST', mode: 'no-cors', body: JSON.stringify(answers)});
})();
"""

# no page but the one that is given, and nothing from elsewhere
FIREFOX = """user_pref("browser.aboutwelcome.enabled", false);
user_pref("browser.shell.checkDefaultBrowser", false);
user_pref("datareporting.policy.dataSubmissionEnabled", false);
user_pref("termsofuse.bypassNotification", true);
user_pref("app.update.enabled", false);
"""

with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
    page = Path(folder) / "page"
    subprocess.run([subcert, "reproduce", "dyn-2015", "--only", "exponents", "--out", page], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    index = page / "index.html"
    text = index.read_text()
    server = http.server.HTTPServer(("127.0.0.1", 0), Receiver)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    clicks = CLICKS.replace("PORT", str(server.server_port))
    index.write_text(text.replace("</body>", f"<script>{clicks}</script></body>"))
    profile = Path(folder) / "profile"
    profile.mkdir()
    options = ["--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}"]
    if "firefox" in Path(browser).name:
        options = ["--no-remote", "--profile", profile]
        (profile / "user.js").write_text(FIREFOX)
    process = subprocess.Popen([browser, "--headless", *options, index.as_uri()], stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    try:
        in_time = arrived.wait(240)
    finally:
        process.kill()
        process.wait()
        server.shutdown()

failures = [] if in_time else ["the page did not answer"]
buttons = len(re.findall("<button class=check", text))
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
