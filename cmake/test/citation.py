#!/usr/bin/env python3
"""CITATION.cff has what CFF 1.2.0 asks for, and the version of the project stands alike wherever it stands.

Usage: citation.py SOURCE VERSION. Exit code 77 without python3-yaml.
"""
import pathlib
import re
import sys

try:
    import yaml
except ImportError:
    print("skipped: need python3-yaml")
    sys.exit(77)

source, version = pathlib.Path(sys.argv[1]), sys.argv[2]
citation = yaml.safe_load((source / "CITATION.cff").read_text(encoding="utf-8"))

assert citation["cff-version"] == "1.2.0"
assert set(citation) <= {"cff-version", "message", "type", "title", "abstract", "authors", "version", "date-released",
                         "license", "keywords", "references"}, "a key that CFF 1.2.0 may not know"
for key in ["message", "title"]:
    assert isinstance(citation[key], str) and citation[key], key
assert citation["authors"] and all(set(author) == {"name"} for author in citation["authors"])
assert citation["license"] == "MIT" and (source / "LICENSE").read_text().startswith("MIT License")

known = (source / "docs/references.md").read_text(encoding="utf-8")
known = re.sub(r"\s+", " ", known)
for paper in citation["references"]:
    assert paper["type"] == "article" and paper["authors"], paper["title"]
    who = ", ".join(f"{author['given-names']} {author['family-names']}" for author in paper["authors"])
    assert f"{who}: {paper['title']}." in known, f"docs/references.md has no such entry: {who}: {paper['title']}"
    if "start" in paper:
        assert f"({paper['year']})" in known and f"{paper['start']}-{paper['end']}" in known

# One version everywhere, one date.
assert citation["version"] == version, "CITATION.cff"
date = re.search(rf"^## {re.escape(version)} \((\d{{4}}-\d\d-\d\d)\)$", (source / "CHANGELOG.md").read_text(), re.M)
assert date, f"CHANGELOG.md has no heading '## {version} (YEAR-MONTH-DAY)'"
assert citation["date-released"] == date[1], "the dates of CITATION.cff and CHANGELOG.md"
minor = ".".join(version.split(".")[:2])
for name in ["README.md", "docs/installing.md", "cmake/test/consumer/CMakeLists.txt"]:
    found = re.findall(r"find_package\(subcert (\S+) REQUIRED\)", (source / name).read_text())
    assert found and set(found) == {minor}, name
archives = set(re.findall(r"subcert-([0-9.]+)-Linux", (source / "README.md").read_text()))
assert archives == {version}, "the archive in README.md"
project = source / "pyproject.toml"
if project.exists():
    fixed = re.search(r'^version = "(.*)"$', project.read_text(), re.M)
    assert not fixed or fixed[1] == version, "pyproject.toml"
