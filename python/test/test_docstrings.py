"""Every example in a docstring runs."""

import doctest
import importlib
import pkgutil

import pytest
import subcert

modules = ["subcert"] + [f"subcert.{m.name}" for m in pkgutil.iter_modules(subcert.__path__) if m.name != "_core"]


@pytest.mark.parametrize("name", modules)
def test_examples(name):
    options = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
    failed, _ = doctest.testmod(importlib.import_module(name), optionflags=options)
    assert failed == 0


def test_examples_are_found():
    # Classes are members of the package, functions of their modules.
    finder = doctest.DocTestFinder(exclude_empty=True)
    found = sum(len(t.examples) > 0 for name in modules for t in finder.find(importlib.import_module(name)))
    assert found >= 18
