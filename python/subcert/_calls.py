"""The extension module, with wrong types of arguments explained: which one, and what would be right."""

from __future__ import annotations

import ast
import functools
import numbers
import os
from typing import TYPE_CHECKING, Any, Callable, Optional

from . import _core


def _is_count(value: Any) -> bool:
    return hasattr(value, "__index__") and -(2**31) <= value.__index__() < 2**31


_KINDS: dict[str, tuple[str, Callable[[Any], bool]]] = {
    "int": ("an integer below 2^31 in modulus", _is_count),
    "float": ("a number", lambda value: isinstance(value, numbers.Real)),
    "bool": ("True or False", lambda value: isinstance(value, bool)),
    "str": ("a text", lambda value: isinstance(value, str)),
    "Sequence[str]": (
        "a list of texts",
        lambda value: not isinstance(value, str) and all(isinstance(one, str) for one in value),
    ),
    "Sequence[tuple[int, int, int]]": (
        "triples (from, to, matrix) of integers from 0 on",
        lambda value: all(len(edge) == 3 and all(_is_count(k) and k >= 0 for k in edge) for edge in value),
    ),
    "_Progress": ("a function or None", lambda value: value is None or callable(value)),
    "Scheme": ("a linear scheme", lambda value: isinstance(value, _core.Scheme)),
}


@functools.lru_cache(maxsize=None)
def _arguments() -> dict[str, list[tuple[str, str]]]:
    """Names and types of the arguments of each function, from the stub."""
    with open(os.path.join(os.path.dirname(__file__), "_core.pyi"), encoding="utf-8") as stub:
        tree = ast.parse(stub.read())
    return {
        node.name: [(one.arg, ast.unparse(one.annotation)) for one in node.args.args if one.annotation]
        for node in tree.body
        if isinstance(node, ast.FunctionDef)
    }


def _wrong_argument(function: str, values: tuple[Any, ...]) -> Optional[str]:
    for (name, kind), value in zip(_arguments()[function], values):
        optional = kind.startswith("Optional[")
        what, holds = _KINDS.get(kind[9:-1] if optional else kind, ("", lambda _: True))
        try:
            right = (optional and value is None) or holds(value)
        except TypeError:
            right = False
        if name == "memory" and right and value < 0:
            what, right = "an integer from 0 on", False
        if not right:
            text = repr(value)
            shown = text if len(text) <= 40 else text[:37] + "..."
            return f"{name}: expected {what}, got {type(value).__name__} {shown}"
    return None


def _explaining(function: Callable[..., Any]) -> Callable[..., Any]:
    @functools.wraps(function)
    def call(*values: Any) -> Any:
        try:
            return function(*values)
        except TypeError as error:
            if "incompatible function arguments" not in str(error):
                raise
            wrong = _wrong_argument(function.__name__, values)
        raise TypeError(wrong or f"{function.__name__}: expected arguments of other types")

    return call


class _Core:
    def __getattr__(self, name: str) -> Any:
        value = getattr(_core, name)
        if callable(value) and not isinstance(value, type):
            value = _explaining(value)
        setattr(self, name, value)
        return value


if TYPE_CHECKING:
    core = _core
else:
    core = _Core()


def threads(jobs: Optional[int]) -> int:
    return core.all_cores() if jobs is None else jobs
