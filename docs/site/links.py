#!/usr/bin/env python3
"""Checks links. Usage: links.py FILE.md|FOLDER...

Of Markdown files the targets of links and pictures, with anchors as GitHub makes them of headings; of folders all HTML
files, with their ids, and that no page loads anything from elsewhere. Links to other places are not followed.
Exit code: 0 all links lead somewhere, 1 some do not (one line each), 64 wrong usage.
"""
import html.parser
import pathlib
import re
import sys
import urllib.parse

LINK = re.compile(r"(?<!\\)!?\[(?:[^\[\]]|\[[^\[\]]*\])*\]\(([^()\s]+)\)")
REMOTE = re.compile(r"^(?:[a-z][a-z0-9+.-]*:|//)", re.IGNORECASE)


def prose(text):
    """The lines with their numbers, without code."""
    fence = None
    for number, line in enumerate(text.split("\n"), 1):
        mark = re.match(r" {0,3}(```+|~~~+)", line)
        if mark and (fence is None or mark[1].startswith(fence)):
            fence = mark[1] if fence is None else None
        elif fence is None and not line.startswith("    "):
            yield number, re.sub(r"(`+).*?\1", "", line)


def slug(heading):
    """The anchor of a heading."""
    words = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", words.replace("`", "")).replace(" ", "-")


def markdown_anchors(file):
    result, fence = set(), False
    for line in file.read_text(encoding="utf-8").split("\n"):
        if re.match(r" {0,3}```", line):
            fence = not fence
        heading = None if fence else re.match(r"#{1,6} +(.*?)[ #]*$", line)
        if heading:
            name, count = slug(heading[1]), 0
            while (name if count == 0 else f"{name}-{count}") in result:
                count += 1
            result.add(name if count == 0 else f"{name}-{count}")
    return result


class Page(html.parser.HTMLParser):
    """The ids of a page, its links and what it loads."""

    def __init__(self, file):
        super().__init__()
        self.ids, self.links, self.loaded = set(), [], []
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.ids.update(values[name] for name in ("id", "name") if values.get(name))
        line = self.getpos()[0]
        if tag in ("a", "area", "use") and values.get("href"):
            self.links.append((line, values["href"]))
        if tag == "link" and values.get("href") and values.get("rel") not in ("canonical", "author", "license"):
            self.loaded.append((line, values["href"]))
        if values.get("src"):
            self.loaded.append((line, values["src"]))


class Checker:
    def __init__(self):
        self.faults, self.count, self.anchors_of = [], 0, {}

    def anchors(self, file):
        if file not in self.anchors_of:
            self.anchors_of[file] = markdown_anchors(file) if file.suffix == ".md" else Page(file).ids
        return self.anchors_of[file]

    def check(self, file, line, link):
        if REMOTE.match(link):
            return
        self.count += 1
        path, _, anchor = link.partition("#")
        path = urllib.parse.unquote(path.partition("?")[0])
        target = (file.parent / path).resolve() if path else file.resolve()
        if not target.exists():
            self.faults.append(f"{file}:{line}: {link}: no such file")
        elif anchor and target.suffix in (".md", ".html"):
            if urllib.parse.unquote(anchor) not in self.anchors(target):
                self.faults.append(f"{file}:{line}: {link}: no such anchor")

    def markdown(self, file):
        for line, text in prose(file.read_text(encoding="utf-8")):
            for link in LINK.findall(text):
                self.check(file, line, link)

    def page(self, file):
        page = Page(file)
        self.anchors_of[file.resolve()] = page.ids
        for line, link in page.links:
            self.check(file, line, link)
        for line, link in page.loaded:
            if REMOTE.match(link) and not link.startswith("data:"):
                self.faults.append(f"{file}:{line}: {link}: loaded from elsewhere")
            self.check(file, line, link)


def main(arguments):
    if not arguments:
        print(__doc__.split("\n")[0], file=sys.stderr)
        return 64
    checker = Checker()
    for argument in map(pathlib.Path, arguments):
        if argument.is_dir():
            for file in sorted(argument.rglob("*.html")):
                checker.page(file)
        elif argument.is_file():
            checker.markdown(argument)
        else:
            print(f"links.py: {argument}: no such file", file=sys.stderr)
            return 64
    print(*checker.faults, f"{checker.count} links, {len(checker.faults)} broken", sep="\n")
    return 1 if checker.faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
