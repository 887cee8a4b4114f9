"""Pages in a browser without a window: they are opened from a file, and a script in them sends its answers to a port of
this machine."""
import http.server
import json
import os
import subprocess
import tempfile
import threading
from pathlib import Path


class Receiver(http.server.BaseHTTPRequestHandler):
    def do_POST(self):
        self.server.answers.append(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
        self.send_response(204)
        self.end_headers()
        self.server.arrived.set()

    def log_message(self, *_):
        pass


# of a profile: no page but the one that is given, and nothing from elsewhere
FIREFOX = """user_pref("browser.aboutwelcome.enabled", false);
user_pref("browser.shell.checkDefaultBrowser", false);
user_pref("datareporting.policy.dataSubmissionEnabled", false);
user_pref("termsofuse.bypassNotification", true);
user_pref("app.update.enabled", false);
user_pref("layout.css.prefers-color-scheme.content-override", {scheme});
"""
LEAST_WINDOW = 500  # pixels; narrower ones are frames inside

# Before any script of the page: what goes wrong is kept.
WATCH = """
var faults = [];
addEventListener('error', event => faults.push(event.message || 'not loaded: ' + (event.target.src || '')), true);
addEventListener('unhandledrejection', event => faults.push('not caught: ' + event.reason));
for (const kind of ['error', 'warn']) console[kind] = (...words) => faults.push(words.join(' '));
"""


def answers_of(browser, page, script, *, link="", size=(1400, 900), dark=False, seconds=120):
    """What the script, the body of an asynchronous function, returns in the page; None if it did not answer in time. It
    may use `faults`, the errors of the page, and `wait(milliseconds)`. `link`: what follows the name of the page."""
    server = http.server.HTTPServer(("127.0.0.1", 0), Receiver)
    server.answers, server.arrived = [], threading.Event()
    threading.Thread(target=server.serve_forever, daemon=True).start()
    asked = f"""
addEventListener('load', async () => {{
  const wait = milliseconds => new Promise(done => setTimeout(done, milliseconds));
  let answer;
  try {{
    answer = await (async () => {{ {script} }})();
  }} catch (error) {{
    answer = {{failed: String(error.stack || error)}};
  }}
  await fetch('http://127.0.0.1:{server.server_port}/', {{method: 'POST', mode: 'no-cors', body: JSON.stringify(answer)}});
}});
"""
    page = Path(page)
    text = page.read_text(encoding="utf-8")
    changed = page.with_name("asked-" + page.name)
    changed.write_text(text.replace("<head>", f"<head><script>{WATCH}</script>")
                       .replace("</body>", f"<script>{asked}</script></body>"), encoding="utf-8")
    opened, frame = changed, page.with_name("frame-" + page.name)
    if size[0] < LEAST_WINDOW:
        opened = frame
        frame.write_text(f"<iframe src='{changed.name}{link}' width={size[0]} height={size[1]} style='border:0'></iframe>",
                         encoding="utf-8")
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        options, scheme, environment = [], 0 if dark else 1, dict(os.environ)
        if "firefox" in Path(browser).name:
            options = ["--no-remote", "--profile", profile]
            (Path(profile) / "user.js").write_text(FIREFOX.format(scheme=scheme), encoding="utf-8")
            environment.update(MOZ_HEADLESS_WIDTH=str(size[0]), MOZ_HEADLESS_HEIGHT=str(size[1]))
        else:
            options = ["--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}", f"--window-size={size[0]},{size[1]}",
                       f"--blink-settings=preferredColorScheme={scheme}"]
        process = subprocess.Popen([browser, "--headless", *options, opened.resolve().as_uri() + link], env=environment,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            server.arrived.wait(seconds)
        finally:
            process.kill()
            process.wait()
            server.shutdown()
            changed.unlink()
            frame.unlink(missing_ok=True)
    return server.answers[0] if server.answers else None
