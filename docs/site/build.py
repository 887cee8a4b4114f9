#!/usr/bin/env python3
"""Builds the documentation site: pages of Markdown, theorems, library reference and gallery, as HTML for Sphinx's search.

Usage: build.py SOURCE TREE SITE SUBCERT VERSION HEADERS
  SOURCE   the source tree              TREE     a folder of its own, made anew: what Sphinx reads
  SITE     the site, made anew          SUBCERT  the program, which draws the gallery
  VERSION  of the project               HEADERS  a file with the names of the installed headers, one a line
Exit code: 0 done and all links lead somewhere, 1 not, 77 a package is missing (one line says which).
"""
import pathlib
import re
import shutil
import subprocess
import sys

import api
import links
import theorems

PAGES = ["README.md", "CHANGELOG.md", "docs/**/*.md", "proofs-checks/*/*.md"]
THEOREMS = ["docs/theorems/least-squares-schemes.tex", "docs/theorems/variance-curves.tex"]
NEEDED = {"sphinx-build": "python3-sphinx", "pandoc": "pandoc"}
NEEDED_MODULES = {"sphinx": "python3-sphinx", "myst_parser": "python3-myst-parser", "furo": "furo"}


def missing_packages():
    """Of Debian, as far as they are not installed. Sphinx may run in another Python than this one."""
    missing = {package for program, package in NEEDED.items() if not shutil.which(program)}
    if not missing:
        first = pathlib.Path(shutil.which("sphinx-build")).read_text(encoding="utf-8").split("\n", 1)[0]
        for module, package in NEEDED_MODULES.items():
            command = first[2:].split() + ["-c", f"import {module}"] if first.startswith("#!") else ["false"]
            if subprocess.run(command, capture_output=True, check=False).returncode:
                missing.add(package)
    return sorted(missing)


def run(command, **options):
    subprocess.run([str(part) for part in command], check=True, **options)


class Tree:
    """The files that Sphinx reads. Pages keep their places, so that links among them stay as they are."""

    def __init__(self, source, tree):
        self.source, self.tree, self.pages = source, tree, []
        self.open = sorted({page for pattern in PAGES for page in source.glob(pattern)} -
                           set((source / "docs/site").glob("*.md")))
        while self.open:
            self.add(self.open.pop(0))

    def add(self, page):
        name = page.relative_to(self.source)
        if name in self.pages:
            return
        self.pages.append(name)
        text = links.LINK.sub(lambda link: self.link(page, link), page.read_text(encoding="utf-8"))
        self.write(name, text)

    def write(self, name, text):
        (self.tree / name).parent.mkdir(parents=True, exist_ok=True)
        (self.tree / name).write_text(text, encoding="utf-8")

    def link(self, page, link):
        """The link as the site has it: to a page, to a copy of a file, or only its text."""
        path, hash_sign, anchor = link[1].partition("#")
        if links.REMOTE.match(link[1]) or not path:
            return link[0]
        target = (page.parent / path).resolve()
        if target.suffix == ".md" and target.is_file():
            self.open.append(target)
        elif target in [self.source / paper for paper in THEOREMS]:
            return link[0].replace(path, path[:-len(".tex")] + ".md")
        elif target.is_file():
            name = target.relative_to(self.source)
            (self.tree / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(target, self.tree / name)
            if not target.suffix:  # a download of Sphinx, whatever its name
                return f"{{download}}`{re.match(r'!?.(.*?).[(]', link[0])[1]} <{path}>`"
        elif target.is_dir():
            return re.match(r"!?\[(.*)\]\(", link[0])[1]
        return link[0]

    def theorems(self, paper):
        """A paper as a page with MathML and, where TeX is installed, as PDF."""
        file = self.source / paper
        tex = theorems.merged(file)  # one source to download, and pandoc reads standard input
        title = re.sub(r"\\\\|\$|\s+", " ", re.search(r"\\title\{(.*)\}", tex)[1])
        body = theorems.for_page(tex)
        html = subprocess.run(["pandoc", "-f", "latex", "-t", "html", "--mathml", "--number-sections"],
                              input=body, capture_output=True, text=True, check=True)
        sys.stderr.write(html.stderr)
        below_title = re.sub(r"(</?h)([1-5])", lambda tag: f"{tag[1]}{int(tag[2]) + 1}", html.stdout)
        folder = self.tree / pathlib.Path(paper).parent
        (folder / file.name).write_text(tex, encoding="utf-8")
        others = f"{{download}}`LaTeX source <{file.name}>`"
        if shutil.which("pdflatex"):
            if theorems.build_pdf(folder, file.name).returncode:
                raise RuntimeError(f"pdflatex does not read {paper}")
            others = f"{{download}}`PDF <{file.stem}.pdf>`, " + others
        else:
            print("site: no PDF of the theorems, as pdflatex is missing (Debian: texlive-latex-base)")
        self.write(pathlib.Path(paper).with_suffix(".md"), f"# {title}\n\n{others}\n\n```{{raw}} html\n"
                   f"<div class=\"theorem\">\n{below_title}</div>\n```\n")

    def gallery(self, subcert):
        run([subcert, "gallery", "--quiet", "--budget", "20", "--out", self.tree / "_extra/gallery.html"])
        page = self.tree / "docs/gallery.md"
        page.write_text(page.read_text(encoding="utf-8") + "\n```{raw} html\n<p><a href=\"../gallery.html\">The gallery of "
                        "forty schemes</a></p>\n```\n", encoding="utf-8")

    def python(self, folder):
        """The reference of the package in that folder, from its docstrings; nothing where there is none."""
        if folder:
            self.write(pathlib.Path("python/subcert.md"), "# Reference: Python\n\n```{eval-rst}\n"
                       ".. automodule:: subcert\n   :members:\n   :show-inheritance:\n   :member-order: groupwise\n"
                       "```\n")

    def index(self, python):
        """The first page; pages that none of its lists names stand in a list of their own."""
        text = (self.source / "docs/site/index.md").read_text(encoding="utf-8")
        further = sorted(str(name.with_suffix("")) for name in self.pages
                         if not re.search(rf"^(.*<)?{re.escape(str(name.with_suffix('')))}>?$", text, re.M))
        further += ["python/subcert"] if python else []
        if further:
            text += "\n".join(["", "```{toctree}", ":caption: Further pages", ":hidden:", "", *further, "```", ""])
        self.write(pathlib.Path("index.md"), text)


def main(arguments):
    if len(arguments) not in (6, 7):
        print("usage: build.py SOURCE TREE SITE SUBCERT VERSION HEADERS [PYTHON]", file=sys.stderr)
        return 64
    source, tree, site = (pathlib.Path(argument).resolve() for argument in arguments[:3])
    subcert, version, headers = arguments[3:6]
    python = arguments[6] if len(arguments) == 7 else ""  # the folder to import the package from
    if missing := missing_packages():
        print(f"site: not built, packages are missing: {' '.join(missing)}")
        return 77
    for folder in (tree, site):
        shutil.rmtree(folder, ignore_errors=True)
    made = Tree(source, tree)
    for paper in THEOREMS:
        made.theorems(paper)
    made.gallery(subcert)
    made.python(python)
    made.index(python)
    listed = pathlib.Path(headers).read_text(encoding="utf-8").split()
    api.write(source, [pathlib.Path(header).resolve() for header in listed], tree / "api")
    (tree / "_static").mkdir()
    shutil.copyfile(source / "docs/site/site.css", tree / "_static/site.css")
    conf = (source / "docs/site/conf.py").read_text(encoding="utf-8").replace("@VERSION@", version)
    (tree / "conf.py").write_text(conf + f"import sys\nsys.path[:0] = {[python] if python else []!r}\n", encoding="utf-8")
    try:
        run(["sphinx-build", "-q", "-W", "--keep-going", "-b", "html", "-d", tree / ".doctrees", tree, site])
    except subprocess.CalledProcessError:
        print("site: not built, see above", file=sys.stderr)
        return 1
    return links.main([str(site)])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
