#!/usr/bin/env python3
"""links.py and api.py on small files."""
import contextlib
import io
import pathlib
import tempfile
import unittest

import api
import links


class Links(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def faults(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            code = links.main([str(self.folder / name if name.endswith(".md") else self.folder)])
        lines = out.getvalue().split("\n")[:-2]
        self.assertEqual(code, 1 if lines else 0)
        return [line.replace(f"{self.folder}/", "") for line in lines]

    def test_markdown(self):
        (self.folder / "b.md").write_text("# One two\n\n## `f(x)`, again\n\n## One two\n", encoding="utf-8")
        good = "[b](b.md) [b](b.md#one-two) [b](b.md#one-two-1) [b](b.md#fx-again) [w](https://toml.io)\n"
        self.assertEqual(self.faults("a.md", good), [])
        self.assertEqual(self.faults("a.md", "a\n[b](c.md)\n"), ["a.md:2: c.md: no such file"])
        self.assertEqual(self.faults("a.md", "[b](b.md#three)"), ["a.md:1: b.md#three: no such anchor"])
        self.assertEqual(self.faults("a.md", "![p](p.png)"), ["a.md:1: p.png: no such file"])

    def test_code_and_formulas_are_no_links(self):
        self.assertEqual(self.faults("a.md", "```\n[b](c)\n```\n`[b](c)` a_\\[1](z)\n\n    [b](c)\n"), [])

    def test_pages(self):
        self.assertEqual(self.faults("a.html", "<p id=x><a href='#x'>x</a> <a href='a.html#x'>x</a>"), [])
        self.assertEqual(self.faults("a.html", "<a href='#y'>y</a>"), ["a.html:1: #y: no such anchor"])
        self.assertEqual(self.faults("a.html", "<img src='p.png'>"), ["a.html:1: p.png: no such file"])
        self.assertEqual(self.faults("a.html", "<script src='https://a.org/a.js'></script>"),
                         ["a.html:1: https://a.org/a.js: loaded from elsewhere"])

    def test_wrong_usage(self):
        with contextlib.redirect_stderr(io.StringIO()):
            self.assertEqual(links.main([]), 64)
            self.assertEqual(links.main([str(self.folder / "none.md")]), 64)


class Headers(unittest.TestCase):
    def test_page(self):
        text = ("#pragma once\n/// About <all>.\n\n#include <a>\n\nnamespace subcert {\n\n/// The sum of a_i.\n"
                "int sum(const std::vector<int>& a,\n        int start = 0);\n\n/// Two numbers.\ntemplate <class T>\n"
                "struct Pair {\n  T a, b;\n};\n\n}  // namespace subcert\n")
        page = api.page(pathlib.Path("analysis/sum.hpp"), text)
        self.assertIn("About \\<all\\>.", page)
        self.assertIn("## sum\n\nThe sum of a\\_i.\n\n```cpp\nint sum(", page)
        self.assertIn("## Pair\n\nTwo numbers.\n", page)

    def test_a_header_that_cannot_be_read_is_an_error(self):
        with self.assertRaises(api.HeaderError):
            api.page(pathlib.Path("a.hpp"), "/// About.\n\nint f(\n")


if __name__ == "__main__":
    unittest.main()
