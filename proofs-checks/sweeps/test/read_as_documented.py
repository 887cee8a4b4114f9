"""read_as_documented.py PAGE TOY: runs the Python lines of the page on a journal of TOY, then on a damaged one."""
import os
import re
import subprocess
import sys
import tempfile

page, toy = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
lines = re.search(r"```python\n(.*?)```", open(page, encoding="utf-8").read(), re.S).group(1)
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    subprocess.run([toy, "20", "0", "whole.journal"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    seen = {}
    exec(lines, seen)
    assert seen["case"]["version"] == "toy 1", seen["case"]
    text = open("whole.journal").read()
    for damaged in (text.replace("xxx", "xyx"), text.replace("toy 1", "toy 2")):
        open("whole.journal", "w").write(damaged)
        try:
            exec(lines, {})
        except AssertionError:
            continue
        sys.exit("damage was not noticed")
    os.chdir("/")
