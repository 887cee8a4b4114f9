"""Sweeps over many schemes, and the atlas: what the program `subcert`, a process of its own, answers."""

from __future__ import annotations

import dataclasses
import html
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
from fractions import Fraction
from typing import Any, Iterable, Iterator, Mapping, Optional, Sequence, Union

from ._calls import core as _core
from ._certificates import Path
from ._errors import DataError, Error, MissingFileError, UndecidedError, UsageError
from ._exact import Enclosure, Truth
from ._schemes import Scheme, scheme

_ERRORS = {2: UndecidedError, 64: UsageError, 65: DataError, 66: MissingFileError}


def _program() -> str:
    """The program subcert: the one in the package, or else on the PATH."""
    beside = pathlib.Path(_core.__file__).with_name("subcert")
    found = str(beside) if beside.exists() else shutil.which("subcert")
    if not found:
        raise MissingFileError("the program subcert is not installed")
    return found


def _lines(words: Sequence[str], lines: Iterable[str], answering: tuple[int, ...]) -> Iterator[str]:
    """The lines that the program prints, as they come. `answering`: the exit codes with which it has answered."""
    with tempfile.TemporaryFile("w+", encoding="utf-8") as errors:
        pipe, command = subprocess.PIPE, [_program(), *words]
        with subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=errors, text=True, encoding="utf-8") as process:
            assert process.stdin and process.stdout
            try:
                try:
                    process.stdin.writelines(line + "\n" for line in lines)
                    process.stdin.close()
                except BrokenPipeError:
                    pass
                yield from process.stdout
                process.wait()
            finally:
                process.terminate()
        if process.returncode not in answering:
            errors.seek(0)
            said = errors.read().strip().split("\n")[-1].removeprefix("subcert: ")
            if said.startswith("standard input, line "):  # an argument here
                raise UsageError(said.partition(": ")[2])
            raise _ERRORS.get(process.returncode, Error)(said or "subcert did not answer")


def _object(words: Sequence[str], lines: Iterable[str] = (), answering: tuple[int, ...] = (0,)) -> Optional[Any]:
    """The object that the program prints; nothing where it has answered without one."""
    text = "".join(_lines([*words, "--json", "--quiet"], lines, answering))
    return json.loads(text) if text else None


def _end(text: str) -> Optional[Fraction]:
    return None if text.endswith("inf") else Fraction(text)


def _value(value: Any) -> Any:
    """Enclosures as such."""
    if isinstance(value, dict) and set(value) == {"lower", "upper"}:
        return Enclosure(_end(value["lower"]), _end(value["upper"]))
    return value


def _member(of: Any, path: str) -> Any:
    for name in path.split("."):
        if isinstance(of, Mapping) and name in of:
            of = of[name]
        elif isinstance(of, list) and name.isdigit() and int(name) < len(of):
            of = of[int(name)]
        else:
            return None
    return _value(of)


def _texts(schemes: Union[str, Scheme, Iterable[Union[str, Scheme]]]) -> list[str]:
    several = [schemes] if isinstance(schemes, (str, Scheme)) else list(schemes)
    texts = [one.specification if isinstance(one, Scheme) else one for one in several]
    for text in texts:
        if not isinstance(text, str) or "\n" in text:
            raise TypeError(f"expected schemes or lines of text, got {text!r:.40}")
    return texts


@dataclasses.dataclass(frozen=True)
class SweepAnswer:
    """What was answered about a scheme. ``answer["holder"]`` is the member of this name of the first answer that has
    one, or a key of the scheme, or None; a path as ``"sobolev.exponent"`` or ``"valences.0.c1"`` goes deeper."""

    scheme: str
    keys: dict[str, str]
    #: By the text of the question, as its command says with --json.
    answers: dict[str, Any] = dataclasses.field(repr=False)
    errors: dict[str, str]
    #: Whether it is as expected; None where nothing is.
    expected: Optional[Truth] = None

    def __getitem__(self, name: str) -> Any:
        for one in (*self.answers.values(), self.keys):
            value = _member(one, name)
            if value is not None:
                return value
        return None


def sweep(
    schemes: Union[str, Scheme, Iterable[Union[str, Scheme]]],
    *,
    ask: Sequence[str] = ("regularity",),
    where: Optional[str] = None,
    expect: Optional[str] = None,
    budget: float = 10,
    memory: int = 512,
    journal: Optional[Path] = None,
    jobs: Optional[int] = None,
) -> Iterator[SweepAnswer]:
    """Asks questions about many schemes, as ``"variance"``, ``"vertex --valence 3..12"`` or ``"check smoothness >= 1"``
    (docs/sweeps.md), each in a process of its own, and gives the answers in the order of the schemes as soon as they
    are known. A scheme is one, or a text with lists as ``"primal:n=1..60,d={1,3}"``; `where` and `expect` are
    conditions as ``"n >= 4"``; with `journal` a sweep that was stopped goes on. Raises UsageError for what cannot be
    read; what is no scheme has an error among its `errors`.

    >>> import subcert
    >>> for answer in subcert.sweep("dd:n=1..3", expect="holder >= 2"):
    ...     print(answer["n"], answer["holder"], answer.expected)
    1 1 no
    2 2 yes
    3 2.8300749985577 yes
    """
    words = ["sweep", "-", "--json", "--quiet", "--in-order", "--ask", ",".join(ask)]
    words += ["--budget", str(budget), "--memory", str(memory)]
    for name, value in (("--where", where), ("--expect", expect), ("--jobs", jobs)):
        words += [] if value is None else [name, str(value)]
    words += [] if journal is None else ["--journal", os.fspath(journal)]
    for line in _lines(words, _texts(schemes), (0, 1, 2)):
        one = json.loads(line)
        expected = one.get("expected")
        yield SweepAnswer(
            one["scheme"], one["keys"], one["answers"], one["errors"], None if expected is None else Truth(expected)
        )


class AtlasEntry(Mapping[str, Any]):
    """What an atlas knows of a mask: its members by their names, as ``entry["holder"]``; `subcert atlas --members`
    tells what they mean. Enclosures are Enclosure, what is not known is None."""

    def __init__(self, members: Mapping[str, Any]) -> None:
        self._members = {name: _value(value) for name, value in members.items() if name not in ("subcert", "scheme")}

    def __getitem__(self, name: str) -> Any:
        return self._members[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._members)

    def __len__(self) -> int:
        return len(self._members)

    @property
    def id(self) -> str:
        """By which it is cited."""
        return str(self["id"])

    @property
    def names(self) -> list[str]:
        """Schemes that have this mask."""
        return list(self["names"])

    def scheme(self) -> Scheme:
        """The scheme of the mask."""
        found = scheme(self["mask"])
        assert isinstance(found, Scheme)
        return found

    def __repr__(self) -> str:
        return f"AtlasEntry({self.id}, {self['mask']!r:.60}, holder={self['holder']})"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><th>{name}</th><td>{html.escape(str(value))}</td></tr>"
            for name, value in self.items()
            if value is not None
        )
        return f"<table>{rows}</table>"


class AtlasAnswers(tuple):  # type: ignore[type-arg]
    """The entries that meet a condition; `open` has the ids of those that may. A table in notebooks."""

    open: list[str]

    def rows(self, *members: str) -> list[dict[str, Any]]:
        """These members of each, for a table or a frame."""
        return [{name: _member(entry, name) for name in members} for entry in self]

    def _repr_html_(self) -> str:
        names = ("id", "holder", "sum_rules", "support", "mask", "names")
        head = "".join(f"<th>{name}</th>" for name in names)
        rows = "".join(
            "<tr>" + "".join(f"<td>{html.escape(str(entry[name]))}</td>" for name in names) + "</tr>" for entry in self
        )
        return f"<table><tr>{head}</tr>{rows}</table>"


class Atlas:
    """A database of masks with what is proved about them. Without a file the user's own and the one that came with the
    program, as `subcert atlas` has them.

    >>> import subcert, tempfile, os
    >>> folder = tempfile.TemporaryDirectory()
    >>> atlas = subcert.Atlas(os.path.join(folder.name, "atlas.sqlite"))
    >>> atlas.build("dd:n=1..4")
    4
    >>> [entry.names for entry in atlas.query("holder > 2 and interpolatory")]
    [['dd:n=3'], ['dd:n=4']]
    >>> entry = atlas.find("mask:[-1,0,9,16,9,0,-1]/16@5")
    >>> print(entry["holder"], entry["attained"], entry.names)
    2 False ['dd:n=2']
    """

    def __init__(self, file: Optional[Path] = None) -> None:
        self.file = None if file is None else os.fspath(file)

    def _words(self, *words: str) -> list[str]:
        return ["atlas", *words, *(["--atlas", self.file] if self.file is not None else [])]

    def find(self, scheme: Union[str, Scheme], *, add: bool = True, budget: float = 10) -> Optional[AtlasEntry]:
        """The entry of a scheme, or of an id: that of its mask up to a shift, a reflection and several steps. What is
        missing is computed and added, or with `add=False` None. Raises UsageError for what has no mask of rational
        numbers in one or two variables."""
        [text] = _texts(scheme)
        words = self._words(text, "--budget", str(budget), *([] if add else ["--no-add"]))
        try:
            found = _object(words, answering=(0, 2))
        except UndecidedError:
            found = None
        return AtlasEntry(found) if found else None

    def query(self, condition: str) -> AtlasAnswers:
        """The entries that meet a condition as ``"holder > 2 and support <= 8 and interpolatory"``: comparisons are
        exact. Raises UsageError for a condition that cannot be read, MissingFileError where there is no atlas."""
        found = _object(self._words("query", condition))
        assert found
        answers = AtlasAnswers(AtlasEntry(entry) for entry in found["entries"])
        answers.open = found["open"]
        return answers

    def build(
        self,
        schemes: Union[str, Scheme, Iterable[Union[str, Scheme]]],
        *,
        budget: float = 10,
        certificates: bool = False,
        jobs: Optional[int] = None,
    ) -> int:
        """Enters the masks of many schemes, as `sweep` takes them; how many were new. One that is stopped goes on when
        it is called again."""
        words = self._words("build", "-", "--budget", str(budget), *(["--certificates"] if certificates else []))
        found = _object(words + ([] if jobs is None else ["--jobs", str(jobs)]), _texts(schemes), (0, 2))
        return int(found["added"]) if found else 0

    def save_certificate(self, scheme: Union[str, Scheme], path: Path) -> None:
        """Writes the certificate of the exponent, for `verify`. Raises UndecidedError where there is none."""
        [text] = _texts(scheme)
        _object(self._words(text, "--certificate", os.fspath(path)))
