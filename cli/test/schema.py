#!/usr/bin/env python3
"""Answers with --json are valid against docs/answers.schema.json. Usage: schema.py PROGRAM SCHEMA

Exit code 77 without python3-jsonschema.
"""
import copy
import json
import pathlib
import re
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    print("skipped: need python3-jsonschema")
    sys.exit(77)

program, schema = sys.argv[1], json.loads(pathlib.Path(sys.argv[2]).read_text(encoding="utf-8"))
jsonschema.Draft202012Validator.check_schema(schema)

FILES = {
    "p.toml": '[[scheme]]\nmask = "chaikin"\nsmoothness = ">= 1"\nholder = ">= 3"\n\n[[scheme]]\nmask = "mask:[-1,0,3,3,0,-1]/2"\n'
              "stable = true\n",
    "w.toml": 'scheme = "loop"\nletter = "b"\n[[rule]]\nweights = {vertex = "1-b", neighbours = "b/n"}\n',
    "m.toml": 'masks = ["merrien:lambda=-1/8,mu=3/2", "merrien:lambda=-1/8,mu=-1/2"]\nperiod = [0, 1]\n',
    "l.toml": 'masks = ["dd:n=2", "bspline:degree=3"]\n',
    "j.json": '{"matrices": [[["1/2","0"],["1","3"]], [["1","0"],["0","1/7"]]]}',
    "d.csv": "x,y\n" + "".join(f"{i},{i * i % 7}\n" for i in range(40)),
}
# Of each kind of scheme and of answer, also such that are no, undecided or empty.
COMMANDS = """
mask chaikin
mask ary:a=3,points=4,d=3
analyze chaikin
analyze primal:n=2,d=3
analyze mask:[-1,0,3,3,0,-1]/2
analyze loop
analyze four-point:w
analyze l1:points=6,d=1
regularity chaikin --certificate c.cert
regularity mask:[-1,0,3,3,0,-1]/2
regularity mask:[1,1,0,0,1,1]/2
regularity primal:n=8,d=5 --budget 0.01
regularity sqrt3 --budget 0.2
regularity ghm
regularity merrien:lambda=-1/8,mu=1/2
analyze hermite-dd:points=2,order=2
limit dd:n=2 --level 2
limit primal:n=3 --level 1 --derivative 1
limit loop --level 0
limit cl:2 --level 1
limit exponential-bspline:v --recurrence v=sqrt((1+v)/2) --start v0=1/2 --level 0
limit lists:m.toml --level 2
variance primal:n=2
atlas dd:n=2 --atlas a.sqlite
atlas mask:[1,0,0,1] --atlas a.sqlite
atlas quincunx --atlas a.sqlite
vertex loop --valence 3..5
vertex butterfly --valence 3,7,8
vertex w.toml --over b=1/5..1/2 --valence 3,4
range four-point:w --over w=-1..1 --property C1
range mask:[w,1/2,1/2-w,1/2-w,1/2,w] --over w=0..1 --property convergent --budget 0.5
curve four-point:w --over w=-1..1 --pieces 20
levels four-point:w --over w=1/20..1/10 --property C1 --boxes 2
levels four-point:w --over w=1/20..1/10 --property C1 --each-point --certificate points
levels lists:l.toml
levels four-point:w --over w=0..1/2 --property C1
levels four-point:w --over w=1/20..1/10 --property C1 --recurrence w=w/2+1/32 --start w0=5
l1 l1:points=6,d=1
l1 l1:points=5,d=1 --budget 0.2
statements check dyn-2015/eq-1
statements check dyn-2015/conjecture-7
conjecture 7 --n 1..3 --d 1
conjecture 8 --n 1..3 --d 1
check p.toml
verify c.cert
jsr j.json
compare chaikin dd:n=2 mask:[-1,0,3,3,0,-1]/2
compare chaikin ghm
experiment fig3 --runs 2
theorem smoothness-dual
reproduce dyn-2015 --only table2
reproduce dyn-2015 --only table3
smooth d.csv --level 0
smooth d.csv --scheme l1:points=6,d=1 --level 0
"""


def validator(command):
    return jsonschema.Draft202012Validator({"$ref": f"#/$defs/answer-{command}", "$defs": schema["$defs"]})


seen, faults = {}, []
with tempfile.TemporaryDirectory() as work:
    for name, text in FILES.items():
        pathlib.Path(work, name).write_text(text, encoding="utf-8")
    for line in COMMANDS.strip().splitlines():
        words = line.split()
        ran = subprocess.run([program, *words, "--json"], cwd=work, capture_output=True, text=True, check=False)
        assert ran.returncode in (0, 1, 2), (line, ran.returncode, ran.stderr)
        answer = json.loads(ran.stdout)
        faults += [f"{line}: {'/'.join(map(str, error.absolute_path))}: {error.message[:200]}"
                   for error in validator(words[0]).iter_errors(answer)]
        seen.setdefault(words[0], answer)
assert not faults, "\n".join(faults)

# Every kind of answer was seen, and would be missed without a field that the schema asks for.
kinds = {name.removeprefix("answer-") for name in schema["$defs"] if name.startswith("answer-")}
assert set(seen) == kinds, set(seen) ^ kinds
for command, answer in seen.items():
    for field in schema["$defs"]["answer-" + command]["required"]:
        less = copy.deepcopy(answer)
        del less[field]
        assert not validator(command).is_valid(less), (command, field)
    assert re.fullmatch(r"[0-9a-f]{12}|", answer["subcert"]["commit"])
