"""What goes wrong, as exceptions: one for each kind of error of the library, with the same line of text."""


class Error(Exception):
    """The root of all exceptions of this package. The text is one line: what was wrong, where, and what would be
    right."""


class UsageError(Error, ValueError):
    """A text that cannot be read as a scheme, a number or an option."""


class DomainError(Error, ValueError):
    """An argument outside of the domain of a function."""


class SizeError(Error, ValueError):
    """An argument beyond what the function is able or willing to treat."""


class DataError(Error, ValueError):
    """A file or an array whose content is not what is asked for."""


class MissingFileError(Error, FileNotFoundError):
    """A file or folder that cannot be read or written."""


class UndecidedError(Error, RuntimeError):
    """Neither yes nor no was proved within the budget, and the answer needs one of them."""


class CertificateError(Error):
    """A certificate that the checker rejects, or a result that has none."""
