"""Pages of Markdown from public headers: what the comments say of each declaration, and the declaration.

The headers keep a small grammar: `///` before what it is about, `///<` behind, no macros. This reads
that grammar and nothing else; a header that it cannot read to its end is an error.
"""
import pathlib
import re

HIDDEN = re.compile(r"^(#pragma once|#include .*|namespace [\w:]+ \{|\}(  // namespace.*)?|extern \"C\".*)$")


class HeaderError(Exception):
    pass


def declaration(lines, start):
    """The line behind the declaration that begins at `start`: at a `;` or `}` that is in no bracket."""
    depth, quote = 0, None
    for i in range(start, len(lines)):
        code = re.sub(r'"(\\.|[^"\\])*"|\'(\\.|[^\'\\])\'', "", lines[i].split("//")[0])
        depth += sum(code.count(c) for c in "({[") - sum(code.count(c) for c in ")}]")
        if depth == 0 and re.search(r"[;}]\s*$", code):
            return i + 1
    raise HeaderError(f"line {start + 1}: no end of the declaration '{lines[start]}'")


def name_of(code):
    """What a declaration declares, for its heading."""
    head = re.sub(r"template\s*<(?:[^<>]|<[^<>]*>)*>\s*(requires [^{;]*?(?=\n))?", "", code).strip()
    head = re.sub(r"\[\[\w+\]\]\s*", "", head)
    for pattern in (r"using enum ([\w:]+)", r"using (\w+)\s*=", r"(?:struct|enum class|enum|class|union|concept) ([\w:]+)",
                    r"(operator\s*[^\s(]+|operator\s*\(\s*\))\s*\(", r"([\w:~]+)\s*\(", r"using ([\w:]+);",
                    r"(\w+)\s*(?:\[[^\]]*\])*\s*(?:=|\{|;)"):
        found = re.search(pattern, head)
        if found:
            return found[1]
    raise HeaderError(f"no name in '{code}'")


def prose(comment):
    """The comment as Markdown; characters that would be markup are themselves."""
    text = "\n".join(comment)
    parts = re.split(r"(`[^`\n]+`)", text)
    return "".join(part if part.startswith("`") else re.sub(r"([\\*_<>\[\]#|$])", r"\\\1", part) for part in parts)


def entries(lines):
    """Comment and code of each declaration; the first entry is about the header and has no code."""
    comment, i, about = [], 0, None
    while i < len(lines):
        line = lines[i]
        if re.match(r"\s*///", line):
            comment.append(re.sub(r"^\s*/// ?", "", line))
            i += 1
        elif not line.strip() or HIDDEN.match(line) or line.startswith("//"):
            if comment and about is None:
                about = comment
                yield about, None
            comment = [] if comment is about or not line.strip() else comment
            i += 1
        else:
            end = declaration(lines, i)
            if about is None:
                about = []
            yield comment, "\n".join(lines[i:end])
            comment, i = [], end


def page(path, text):
    """One header as a page."""
    result = [f"# {path.name}\n", f"`#include <subcert/{path.as_posix()}>`\n"]
    last = None
    for comment, code in entries(text.split("\n")):
        if code is None:
            result.append(prose(comment) + "\n")
            continue
        if re.fullmatch(r"(class|struct) [\w:]+;|enum class \w+( : \w+)?;|namespace \w+ \{.*", code) and not comment:
            continue
        name = name_of(code)
        if comment or name != last:
            if name != last:
                result.append(f"## {name.split('::')[-1]}\n".replace("_", r"\_").replace("<", r"\<").replace("*", r"\*"))
            if comment:
                result.append(prose(comment) + "\n")
        result.append(f"```cpp\n{code}\n```\n")
        last = name
    return "\n".join(result)


def write(source, headers, folder):
    """FOLDER/index.md and a page for each header, named by its path below `source`."""
    folders = {}
    for header in sorted(headers):
        path = pathlib.Path(header).relative_to(source)
        target = folder / path.with_suffix(".md")
        target.parent.mkdir(parents=True, exist_ok=True)
        try:
            target.write_text(page(path, pathlib.Path(header).read_text(encoding="utf-8")), encoding="utf-8")
        except HeaderError as error:
            raise HeaderError(f"{path}: {error}") from error
        folders.setdefault(path.parent.as_posix(), []).append(path.with_suffix("").as_posix())
    index = ["# Library reference\n", "The headers that are installed, floor by floor from below; "
             "`#include <subcert/FOLDER/HEADER.hpp>`. Every text is the comment of the header.\n"]
    for name in sorted(folders, key=lambda f: (["analysis", "schemes", "proofs-checks"].index(f.split("/")[0]), f)):
        index.append(f"## {name}\n\n```{{toctree}}\n:maxdepth: 1\n")
        index.extend(folders[name])
        index.append("```\n")
    (folder / "index.md").write_text("\n".join(index), encoding="utf-8")
