"""The papers: their statements as checks, their tables recomputed; expected properties of schemes."""

from __future__ import annotations

import dataclasses
import json
import os
from typing import Any, Optional, Sequence

from ._calls import core as _core
from ._calls import threads as _threads
from ._errors import DataError, Error, MissingFileError
from ._exact import Decision
from ._regularity import Progress


@dataclasses.dataclass(frozen=True)
class Statement:
    """A numbered statement of a paper. `printed` and `corrected` are LaTeX."""

    id: str
    place: str
    paraphrase: str
    checked: str
    printed: str
    recorded: str

    def _repr_markdown_(self) -> str:
        formula = f"\n\n$${self.printed}$$" if self.printed and "$" not in self.printed else f"\n\n{self.printed}"
        return f"**{self.id}** ({self.place}): {self.paraphrase} *{self.recorded}*{formula}"


@dataclasses.dataclass(frozen=True)
class CheckedStatement(Statement):
    """A statement and what its check found."""

    verdict: str
    range: str
    witness: str
    argument: str
    corrected: str
    #: slip, edge, number or claim, of what is wrong or fails at an edge; empty otherwise.
    grade: str = dataclasses.field(default="", repr=False)
    #: Where at the edge of the printed range it fails; empty otherwise.
    edge: str = dataclasses.field(default="", repr=False)
    #: Of what has a grade: the words of the paper, and how they were read.
    sentence: str = dataclasses.field(default="", repr=False)
    readings: str = dataclasses.field(default="", repr=False)
    #: The statement whose fault it repeats; what a slip of the text recognition would explain. Empty otherwise.
    follows: str = dataclasses.field(default="", repr=False)
    scan: str = dataclasses.field(default="", repr=False)

    @property
    def as_recorded(self) -> bool:
        return self.verdict == self.recorded


@dataclasses.dataclass(frozen=True)
class PropertyAnswer:
    """Whether a scheme has an expected property."""

    line: int
    scheme: str
    name: str
    property: str
    expected: str
    answer: Decision


@dataclasses.dataclass(frozen=True)
class Comparison:
    """A printed value beside the certified one."""

    paper: str
    table: str
    cell: str
    printed: str
    computed: Any
    verdict: str
    note: str


class Comparisons(tuple):  # type: ignore[type-arg]
    """The comparisons of a report; a table in notebooks."""

    def _repr_html_(self) -> str:
        head = "".join(f"<th>{name}</th>" for name in ("table", "cell", "printed", "computed", "verdict"))
        rows = "".join(
            f"<tr><td>{c.table}</td><td>{c.cell}</td><td>{c.printed}</td><td>{_computed_text(c.computed)}</td>"
            f"<td>{c.verdict}</td></tr>"
            for c in self
        )
        return f"<table><tr>{head}</tr>{rows}</table>"


def _computed_text(computed: Any) -> str:
    if isinstance(computed, dict) and "lower" in computed:
        low, high = computed["lower"], computed["upper"]
        return f"{low} ... {high}" if low != high else low
    return "" if computed is None else str(computed)


def _made(kind: Any, answer: str) -> list[Any]:
    """Of what the library says in JSON the fields of this kind."""
    names = [field.name for field in dataclasses.fields(kind)]
    return [kind(**{name: one[name] or "" for name in names}) for one in json.loads(answer)]


def _ids(wanted: tuple[Any, ...]) -> list[str]:
    for one in wanted:
        if not isinstance(one, str):
            raise TypeError(f"expected ids of statements or papers, one after another, got {one!r}")
    return list(wanted)


def statements(*wanted: str) -> list[Statement]:
    """The statements with these ids, or of these papers; all where none is named.

    >>> import subcert
    >>> subcert.statements("dyn-2015/eq-2")[0].recorded
    'holds-for-all-n'
    """
    return _made(Statement, _core.statements(_ids(wanted)))


def check_statements(
    *wanted: str, wide: bool = False, jobs: Optional[int] = None, progress: Progress = None
) -> list[CheckedStatement]:
    """Checks statements: holds, holds-for-all-n, misprint (with witness and correction), false or not-checkable.
    `wide`: larger ranges."""
    return _made(CheckedStatement, _core.check_statements(_ids(wanted), wide, _threads(jobs), progress))


def check(
    expectations: str, *, budget: float = 20, jobs: Optional[int] = None, progress: Progress = None
) -> list[PropertyAnswer]:
    """Checks expected properties of schemes, given as TOML: the text, or the name of a file. `budget`: seconds of
    processor time for each search. Raises DataError for a text that is not of that form.

    >>> import subcert
    >>> [answer] = subcert.check('''
    ... [[scheme]]
    ... mask = "four-point:w=1/16"
    ... sum_rules = 4
    ... ''')
    >>> answer.answer.is_yes
    True
    """
    if not isinstance(expectations, str):
        raise TypeError(f"check: expected TOML or the name of a file, got {type(expectations).__name__}")
    text, name = expectations, ""
    if "\n" not in expectations:
        name = f"{expectations}, "
        try:
            with open(expectations, encoding="utf-8") as file:
                text = file.read()
        except OSError as error:
            raise MissingFileError(f"{expectations}: {error.strerror}") from None
    try:
        found = _core.check_properties(text, budget, _threads(jobs), progress)
    except DataError as error:
        raise DataError(f"{name}{error}") from None
    return [PropertyAnswer(answer=Decision._of(one.pop("answer")), **one) for one in found]


def papers() -> dict[str, list[str]]:
    """The papers and collections that can be reproduced, with the items of each."""
    return _core.papers()


def reproduce(
    paper: str, only: Sequence[str] = (), *, jobs: Optional[int] = None, progress: Progress = None
) -> Comparisons:
    """Recomputes the tables of a paper, or some items of it, and compares with what it prints.

    >>> import subcert
    >>> {c.verdict for c in subcert.reproduce("dyn-2015", ["table1"])}
    {'match'}
    """
    found = json.loads(_core.reproduce(paper, list(only), _threads(jobs), progress))
    return Comparisons(
        Comparison(
            c["paper"], c["table"], c["cell"], c["printed"], c.get("computed"), c["verdict"], c.get("note") or ""
        )
        for c in found["comparisons"]
    )
