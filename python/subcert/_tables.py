"""Schemes side by side, and what is printed in papers."""

from __future__ import annotations

import dataclasses
import html
from fractions import Fraction
from typing import Any, Sequence, Union

from ._errors import UsageError
from ._exact import Enclosure
from ._schemes import LinearScheme, Named, Scheme, scheme

_HEADS = {
    "scheme": "scheme",
    "sum_rules": "sum rules",
    "generation_degree": "generates",
    "reproduction_degree": "reproduces",
    "converges": "converges",
    "holder": "Hölder exponent",
    "exact": "exact",
    "sobolev": "Sobolev exponent",
}


@dataclasses.dataclass(frozen=True, repr=False)
class SchemeTable:
    """A row for each scheme, which is a dict; what is not known of one is None."""

    rows: tuple[dict[str, Any], ...]

    def __len__(self) -> int:
        return len(self.rows)

    def __getitem__(self, row: int) -> dict[str, Any]:
        return self.rows[row]

    def __repr__(self) -> str:
        return f"<SchemeTable of {len(self)} schemes>"

    def __str__(self) -> str:
        return self.to_markdown()

    def to_dict(self) -> list[dict[str, Any]]:
        """Plain values, as for JSON: enclosures as their ends."""
        return [{key: plain(value) for key, value in row.items()} for row in self.rows]

    def _cells(self, text: Any) -> list[list[str]]:
        columns = [key for key in _HEADS if any(row.get(key) is not None for row in self.rows)]
        head = [text(_HEADS[key]) for key in columns]
        return [head, *([text("" if row.get(k) is None else row[k]) for k in columns] for row in self.rows)]

    def to_markdown(self) -> str:
        """A table in Markdown."""
        head, *rows = self._cells(lambda value: str(value).replace("|", "\\|"))
        lines = [head, ["---"] * len(head), *rows]
        return "\n".join("| " + " | ".join(line) + " |" for line in lines)

    def to_latex(self) -> str:
        """A tabular in LaTeX, with the rules of booktabs."""

        def cell(value: Any) -> str:
            return f"${value.to_latex()}$" if isinstance(value, Enclosure) else latex_text(str(value))

        head, *rows = self._cells(cell)
        lines = [f"\\begin{{tabular}}{{l{'c' * (len(head) - 1)}}}", "\\toprule"]
        lines += [" & ".join(head) + " \\\\", "\\midrule"]
        lines += [" & ".join(row) + " \\\\" for row in rows]
        return "\n".join([*lines, "\\bottomrule", "\\end{tabular}"])

    def _repr_html_(self) -> str:
        head, *rows = self._cells(lambda value: html.escape(str(value)))
        cells = "".join("<tr>" + "".join(f"<td>{c}</td>" for c in row) + "</tr>" for row in rows)
        return "<table><tr>" + "".join(f"<th>{c}</th>" for c in head) + f"</tr>{cells}</table>"


def plain(value: Any) -> Any:
    """Plain values in the place of exact ones."""
    if isinstance(value, Enclosure):
        return value.to_dict()
    if isinstance(value, Fraction):
        return str(value)
    return value


def latex_text(text: str) -> str:
    """What LaTeX prints as this text."""
    special = {"\\": "\\textbackslash{}", "~": "\\textasciitilde{}", "^": "\\textasciicircum{}"}
    return "".join(special.get(c, "\\" + c if c in "&%$#_{}" else c) for c in text)


def compare(*schemes: Union[str, Named, Sequence[Union[str, Named]]], budget: float = 5) -> SchemeTable:
    """Schemes side by side, one by one or in a list. `budget`: seconds of processor time for each exponent.

    >>> import subcert
    >>> table = subcert.compare("dd:n=2", "chaikin")
    >>> print(table[0]["holder"], table[1]["reproduction_degree"])
    2 1
    >>> print(table.to_markdown().splitlines()[0])
    | scheme | sum rules | generates | reproduces | converges | Hölder exponent | exact | Sobolev exponent |
    """
    found = [scheme(one) for given in schemes for one in (given if isinstance(given, (list, tuple)) else [given])]
    if not found:
        raise UsageError("compare: expected one scheme or more")
    for one in found:
        if not isinstance(one, LinearScheme):
            raise UsageError(f"compare: expected linear schemes, got {one}")
    return SchemeTable(tuple(_row(one, budget) for one in found))


def _row(one: Any, budget: float) -> dict[str, Any]:
    exponent = one.holder(budget)
    known = exponent.lower is not None or exponent.upper is not None
    sobolev = one.sobolev(budget) if isinstance(one, Scheme) else exponent.sobolev
    return {
        "scheme": one.specification,
        "sum_rules": exponent.sum_rules,
        "generation_degree": one.facts.get("generation_degree"),
        "reproduction_degree": one.facts.get("reproduction_degree"),
        "converges": str(exponent.converges.truth),
        "holder": exponent.enclosure if known else None,
        "exact": "yes" if exponent.exact else "no",
        "sobolev": sobolev,
    }
