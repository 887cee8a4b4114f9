#!/usr/bin/env python3
"""Every page says at its head for whom it is, and the map lists it in the section of that role. Usage: heads.py DOCS"""
import pathlib
import re
import sys

docs = pathlib.Path(sys.argv[1])
text = (docs / "README.md").read_text(encoding="utf-8")
sections = {}
for part in text.split("\n## For ")[1:]:
    role, body = part.split("\n", 1)
    sections[role] = set(re.findall(r"\]\(([^)#]+\.md)\)", body))
assert set(sections) == {"users", "provers", "developers"}, set(sections)
for page in sorted(docs.glob("**/*.md")):
    name = str(page.relative_to(docs))
    if name == "README.md" or name.startswith("site/"):
        continue
    lines = page.read_text(encoding="utf-8").split("\n")
    said = re.match(r"\*For (users|provers|developers)\b", lines[2])
    assert said, f"{name}: the third line says for whom the page is: *For users.*, provers or developers"
    roles = {role for role in sections if role in lines[2]}
    listed = {role for role, pages in sections.items() if name in pages}
    assert listed and listed <= roles, f"docs/README.md: {name} is for {sorted(roles)}, and stands under {sorted(listed)}"
