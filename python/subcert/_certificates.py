"""Certificates, and the independent checker that reads them."""

from __future__ import annotations

import dataclasses
import hashlib
import os
import pathlib
import shutil
import tempfile
from typing import Optional, Union

from ._calls import core as _core
from ._errors import MissingFileError

Path = Union[str, "os.PathLike[str]"]


def checker() -> str:
    """The program subcert-check that verifies: the one in the package, or else on the PATH."""
    beside = pathlib.Path(_core.__file__).with_name("subcert-check")
    found = str(beside) if beside.exists() else shutil.which("subcert-check")
    if not found:
        raise MissingFileError("verify: the checker subcert-check is not installed")
    return found


@dataclasses.dataclass(frozen=True)
class Verification:
    """What the checker answered: the claim that it proved, or why it rejects."""

    accepted: bool
    answer: str

    def __str__(self) -> str:
        return self.answer


@dataclasses.dataclass(frozen=True)
class Certificate:
    """A proof that a small program of its own can follow. `lower` and `upper` are the bounds that it proves, as texts
    of fractions; None where it proves none. `matrices`: what a certificate of a joint spectral radius is about.
    `exact`: what the number is, as `4-log|[-4,1]@4,0,1/1000|^1/1`, where it proves that a product attains the
    radius. `attains`: the letters of that product, as `1,1,0,0`, where coefficients are not rational and it has no such
    name. `logarithm`: the power of \\|log h\\| in the modulus of continuity, where it proves that; 0 says that the
    exponent is attained."""

    text: str
    lower: Optional[str]
    upper: Optional[str]
    matrices: Optional[str] = None
    exact: Optional[str] = None
    logarithm: Optional[int] = None
    attains: Optional[str] = None

    @property
    def id(self) -> str:
        """The SHA-256 of the text, by which a paper may name it."""
        return hashlib.sha256(self.text.encode("ascii")).hexdigest()

    def save(self, path: Path) -> None:
        """Writes it, and the matrices beside it as PATH.matrices: under another name first, then renamed."""
        _write(path, self.text)
        if self.matrices is not None:
            _write(os.fspath(path) + ".matrices", self.matrices)

    def verify(self) -> Verification:
        """Asks the independent checker.

        >>> import subcert
        >>> subcert.scheme("four-point:w=1/16").holder().certificate.verify().accepted
        True
        """
        return Verification(*_core.check_certificate(self.text, self.matrices or "", checker()))


def strongest(
    found: list[
        tuple[str, Optional[str], Optional[str], Optional[str], Optional[str], Optional[int], Optional[str]]
    ]
) -> Certificate:
    """The first one that the checker accepts; of one alone nothing is asked."""
    certificates = [Certificate(*one) for one in found]
    for certificate in certificates[:-1]:
        if certificate.verify().accepted:
            return certificate
    return certificates[-1]


def verify(path: Path) -> Verification:
    """Checks a certificate in a file with the independent checker, a program that shares no line with this package.
    Raises DataError for a file that is no certificate, MissingFileError where it cannot be read."""
    if not isinstance(path, (str, os.PathLike)):
        raise TypeError(f"verify: expected the name of a file, got {type(path).__name__}")
    try:
        with open(path, encoding="ascii", errors="replace") as file:
            text = file.read(1 << 28)
    except OSError as error:
        raise MissingFileError(f"{os.fspath(path)}: {error.strerror}") from None
    return Verification(*_core.check_file(text, os.fspath(path), checker()))


def _write(path: Path, text: str) -> None:
    target = os.path.abspath(os.fspath(path))
    try:
        handle, name = tempfile.mkstemp(dir=os.path.dirname(target))
        with os.fdopen(handle, "w", encoding="ascii") as file:
            file.write(text)
        umask = os.umask(0)
        os.umask(umask)
        os.chmod(name, 0o666 & ~umask)
        os.replace(name, target)
    except OSError as error:
        raise MissingFileError(f"{os.fspath(path)}: {error.strerror}") from None
