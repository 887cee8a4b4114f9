"""Tables: frames of pandas, polars, pyarrow and others, dicts of arrays, files. Answers are of the same kind."""

from __future__ import annotations

import dataclasses
import os
import warnings
from collections.abc import Mapping
from decimal import Decimal
from numbers import Real
from typing import Any, Callable, Optional, Sequence, Union

from . import _interchange
from ._calls import core as _core
from ._errors import DataError, DomainError, Error, UsageError

Name = Union[str, int]


def is_table(data: Any) -> bool:
    """Whether these are named columns, or a file of them."""
    return (
        isinstance(data, (Mapping, str, os.PathLike))
        or hasattr(data, "__dataframe__")
        or (hasattr(data, "__arrow_c_stream__") and _names(data) is not None)
        or bool(getattr(getattr(data, "dtype", None), "names", None))
        or (hasattr(data, "to_frame") and _holds_positions(getattr(data, "index", None)))
    )


def _names(data: Any) -> Optional[list[Any]]:
    """Of the columns that data[name] gives; None where it does not."""
    if not hasattr(data, "__getitem__"):
        return None
    names = getattr(data, "column_names", None)  # of pyarrow, whose columns are arrays
    if names is None or callable(names):
        names = getattr(data, "columns", None)
    return None if names is None else list(names)


def _holds_positions(index: Any) -> bool:
    """Whether an index of pandas is more than labels of rows: it has a name, or dates."""
    kind = getattr(getattr(index, "dtype", None), "kind", "")
    return kind == "M" or (kind in ("i", "u", "f") and getattr(index, "name", None) is not None)


def _read(path: str) -> Any:
    """The table, or the array, in a file."""
    import numpy

    ending = os.path.splitext(path)[1].lower()
    if ending == ".npy":
        return numpy.load(path, allow_pickle=False)
    if ending == ".npz":
        with numpy.load(path, allow_pickle=False) as arrays:
            return {name: arrays[name] for name in arrays.files}
    if ending not in (".parquet", ".feather", ".arrow"):
        hint = "; pandas.read_csv reads tables of text" if ending in (".csv", ".tsv", ".txt", ".dat") else ""
        raise UsageError(f"{path}: expected a name that ends in .npy, .npz, .parquet, .feather or .arrow{hint}")
    try:
        from pyarrow import feather, parquet  # type: ignore[import]
    except ImportError:
        raise ImportError(f"{path}: files of this kind need pyarrow (pip install pyarrow)") from None
    return parquet.read_table(path) if ending == ".parquet" else feather.read_table(path)


def _columns(data: Any) -> tuple[dict[str, Any], Callable[[dict[str, Any]], Any]]:
    """The columns by their names, and what makes of columns a table of the same kind."""
    import numpy

    if isinstance(data, (str, os.PathLike)):
        path = os.fspath(data)
        data = _read(path)
        if not is_table(data):
            if data.ndim not in (1, 2):
                raise DataError(f"{path}: expected an array of one or two dimensions; found {data.ndim}")
            return {f"column {k + 1}": c for k, c in enumerate(data.T if data.ndim == 2 else [data])}, dict
    if isinstance(data, Mapping):
        return {str(name): numpy.asarray(values) for name, values in data.items()}, dict
    if hasattr(data, "to_frame") and not hasattr(data, "__dataframe__"):
        data = data.to_frame("value" if data.name is None else data.name)
    names = _names(data) if hasattr(data, "__dataframe__") or hasattr(data, "__arrow_c_stream__") else None
    if names is None and hasattr(data, "__dataframe__"):
        return _interchange.columns(data.__dataframe__()), dict
    if names is not None:
        columns = {name: data[name] for name in names}
        make = getattr(type(data), "from_pydict", type(data))
        index: Any = getattr(data, "index", None)
        if not _holds_positions(index):
            return columns, make
        own = "index" if index.name is None else str(index.name)
        if own in columns:
            raise DataError(f"smooth: expected an index with a name of its own; found {own!r}, which a column has, too")

        def with_index(answer: dict[str, Any]) -> Any:
            return make(answer).set_index(own) if own in answer else make(answer)

        with_index.own = own  # type: ignore[attr-defined]
        return {own: index.to_numpy(), **columns}, with_index

    def records(columns: dict[str, Any]) -> Any:
        kinds = [(name, values.dtype) for name, values in columns.items()]
        return numpy.rec.fromarrays(list(columns.values()), dtype=kinds)

    return {name: data[name] for name in data.dtype.names}, records


def _is_missing(value: Any) -> bool:
    if value is None or type(value).__name__ in ("NAType", "NaTType"):
        return True
    return isinstance(value, Real) and bool(value != value)


@dataclasses.dataclass
class _Column:
    """Numbers, NaN where one is missing; of dates days or seconds from `first` on."""

    name: str
    raw: Any
    numbers: Any
    first: Any = None
    unit: str = ""

    def positions(self, numbers: Any) -> Any:
        """Numbers as they stand in this column: dates where it holds dates."""
        import numpy

        if self.first is None:
            return numbers
        second = 10**9 * (86400 if self.unit == "D" else 1)
        return self.first + numpy.round(numbers * second).astype("timedelta64[ns]")

    def counted(self, places: Any) -> Any:
        """The numbers of places that are written as this column."""
        import numpy

        if self.first is None:
            return numpy.asarray(places, dtype=numpy.float64)
        return (numpy.asarray(places, dtype="datetime64[ns]") - self.first) / numpy.timedelta64(1, self.unit)


def _column(name: str, values: Any) -> Optional[_Column]:
    """A column of numbers or dates; None for text."""
    import datetime

    import numpy

    raw = numpy.asarray(values)
    array = raw
    if array.dtype.kind == "O":
        present = [value for value in array.tolist() if not _is_missing(value)]
        if present and all(isinstance(value, (datetime.date, numpy.datetime64)) for value in present):
            array = numpy.array([None if _is_missing(v) else v for v in array.tolist()], dtype="datetime64[ns]")
        elif all(isinstance(value, (Real, Decimal)) for value in present):
            array = numpy.array([numpy.nan if _is_missing(v) else float(v) for v in array.tolist()])
    if array.dtype.kind in "biuf":
        return _Column(name, raw, array.astype(numpy.float64))
    if array.dtype.kind != "M":
        return None
    times = array.astype("datetime64[ns]")
    there = times[~numpy.isnat(times)]
    days = bool((there == there.astype("datetime64[D]")).all())
    first = there.min() if there.size else numpy.datetime64(0, "ns")
    numbers = (times - first) / numpy.timedelta64(1, "D" if days else "s")
    return _Column(name, times, numbers, first, "D" if days else "s")


class _Table:
    """Which columns of a table hold what."""

    def __init__(self, data: Any) -> None:
        self.columns, self.make = _columns(data)
        if not self.columns:
            raise DataError("smooth: expected a table with columns; found none")

    def name(self, option: str, name: Name) -> str:
        if isinstance(name, str) and name in self.columns:
            return name
        if isinstance(name, int) and 1 <= name <= len(self.columns):
            return list(self.columns)[name - 1]
        raise UsageError(f"{option}: expected one of the columns {', '.join(self.columns)}; got {name!r}")

    def numbers(self, name: str) -> _Column:
        column = _column(name, self.columns[name])
        if column is None:
            raise DataError(f"column {name}: expected numbers; found text")
        return column

    def choose(self, x: Any, y: Any, used: list[str]) -> tuple[Optional[_Column], list[_Column]]:
        """Positions and values. Without a name the first of several columns of numbers or dates holds the positions,
        and all other columns of numbers the values."""
        names = [] if y is None else [y] if isinstance(y, (str, int)) else list(y)
        values = [self.numbers(self.name("y", one)) for one in names]
        counted = isinstance(x, str) and x == "none" and x not in self.columns
        position = None if x is None or counted else self.numbers(self.name("x", x))
        index = [own] if (own := getattr(self.make, "own", None)) and x is not None else []  # which is no value
        taken = used + index + [column.name for column in values] + ([position.name] if position else [])
        left = [_column(name, raw) for name, raw in self.columns.items() if name not in taken]
        others = [column for column in left if column is not None]
        if x is None and len(others) > (0 if values else 1):
            position = others.pop(0)
        values = values or [column for column in others if column.first is None]
        if not values:
            raise DataError("smooth: expected a column of values; found none")
        for column in values:
            if column.first is not None:
                raise DataError(f"column {column.name}: expected numbers; found dates")
        return position, values


def _groups(keys: Any) -> dict[Any, list[int]]:
    """The rows of each group, in the order of their first rows."""
    groups: dict[Any, list[int]] = {}
    for row, key in enumerate(keys.tolist()):
        groups.setdefault(None if _is_missing(key) else key, []).append(row)
    return groups


def weights_of(errors: Any) -> Any:
    """Prior weights of data whose noise has these standard deviations."""
    import numpy

    numbers = numpy.asarray(errors, dtype=numpy.float64)
    if not ((numbers >= 1e-75) & (numbers <= 1e75)).all():
        raise DomainError("errors: expected standard deviations from 1e-75 to 1e75")
    return 1 / numbers**2


def noise_of_errors(noise: Optional[float], scheme: Any) -> Optional[float]:
    """Where errors are given: the noise in their units, which robust and l1 methods find by themselves."""
    return noise if noise is not None or _core.finds_its_noise(str(scheme)) else 1.0


def _smoothed_rows(
    smooth: Callable[..., Any],
    x: Optional[_Column],
    values: Sequence[_Column],
    slopes: Sequence[_Column],
    rows: Any,
    weights: Any,
    kept: dict[str, Any],
    options: dict[str, Any],
) -> dict[str, Any]:
    """The columns of the answer for these rows."""
    import numpy

    missing = numpy.isnan(numpy.array([column.numbers[rows] for column in [*values, *slopes]])).any(axis=0)
    if x is not None:
        lost = numpy.isnan(x.numbers[rows])
        if lost.any() and options["missing"] != "drop":
            raise DataError(f"column {x.name}: expected a position; found a missing value (missing='drop' drops it)")
        rows, missing = rows[~lost], missing[~lost]
    prior = None if weights is None else weights.numbers[rows]
    if missing.any():
        if options["missing"] != "drop":
            names = ", ".join(column.name for column in values)
            raise DataError(f"columns {names}: expected numbers; found a missing value (missing='drop' drops it)")
        prior = numpy.where(missing, 0, 1.0 if prior is None else prior)
    answer: dict[str, Any] = {}
    if not isinstance(options["at"], str) and x is not None:
        options = {**options, "at": x.counted(options["at"])}

    def add(column: _Column, found: Any) -> None:
        answer[column.name] = found.values
        for ending, facts in (("sd", found.deviation), ("lower", found.lower), ("upper", found.upper)):
            if facts is not None:
                answer[f"{column.name}_{ending}"] = facts

    of_slopes = []
    for k, column in enumerate(values):
        samples = numpy.where(missing, 0, column.numbers[rows])
        given = numpy.where(missing, 0, slopes[k].numbers[rows]) if slopes else None
        found = smooth(samples, None if x is None else x.numbers[rows], weights=prior, slopes=given, **options)
        whole = len(found.values) == len(rows)
        at_data = isinstance(options["at"], str) and options["at"] == "data"
        stay = rows if whole or prior is None else rows[prior > 0]
        if not answer:
            name = x.name if x is not None else "index" if any(one.name == "x" for one in values) else "x"
            if x is None:
                answer[name] = found.x
            else:
                answer[name] = x.raw[stay] if at_data else x.positions(found.x)
        add(column, found)
        of_slopes.append(found.slopes)
    for column, found in zip(slopes, of_slopes):
        if found is not None:
            add(column, found)
    for name, raw in kept.items():
        answer[name] = raw[stay]
    return answer


def smoothed(
    smooth: Callable[..., Any], data: Any, x: Any, y: Any, by: Optional[Name], keep: Any, options: dict[str, Any]
) -> Any:
    """What subcert.smooth makes of a table."""
    import numpy

    table = _Table(data)
    given = {name: options.pop(name) for name in ("weights", "errors")}
    given = {name: column for name, column in given.items() if column is not None}
    if len(given) > 1:
        raise UsageError("smooth: weights and errors: expected one of the two")
    prior = None
    for name, column in given.items():
        if not isinstance(column, (str, int)):
            raise UsageError(f"{name}: expected the name of a column; got {type(column).__name__}")
        prior = table.numbers(table.name(name, column))
        if name == "errors":
            prior.numbers = weights_of(prior.numbers)
            options["noise"] = noise_of_errors(options["noise"], options["scheme"])
    names = [] if keep is None else [keep] if isinstance(keep, (str, int)) else list(keep)
    if names and not (isinstance(options["at"], str) and options["at"] == "data"):
        raise UsageError("keep needs at='data': other rows have no fields of the table")
    kept = {table.name("keep", one): numpy.asarray(table.columns[table.name("keep", one)]) for one in names}
    group = None if by is None else table.name("by", by)
    named = options.pop("slopes")
    named = [] if named is None else [named] if isinstance(named, (str, int)) else list(named)
    slopes = [table.numbers(table.name("slopes", one)) for one in named]
    used = list(kept) + ([group] if group else []) + ([prior.name] if prior else []) + [one.name for one in slopes]
    position, values = table.choose(x, y, used)
    count = len(values[0].numbers)
    if slopes and len(slopes) != len(values):
        raise UsageError(f"slopes: expected one for each column of values, {len(values)}; got {len(slopes)}")
    for column in values + slopes + ([position] if position else []):
        if len(column.numbers) != count:
            raise DataError(f"column {column.name}: expected {count} rows; found {len(column.numbers)}")
    if group is None:
        return table.make(_smoothed_rows(smooth, position, values, slopes, numpy.arange(count), prior, kept, options))
    keys = numpy.asarray(table.columns[group])
    parts = []
    left_out: dict[str, str] = {}
    for key, rows in _groups(keys).items():
        try:
            part = _smoothed_rows(smooth, position, values, slopes, numpy.array(rows), prior, kept, options)
        except DataError as error:
            left_out[str(key)] = str(error)
        except Error as error:
            raise type(error)(f"{group} {key}: {error}") from None
        else:
            parts.append({group: keys[[rows[0]] * len(next(iter(part.values())))], **part})
    for key, why in left_out.items():
        if not parts:
            raise DataError(f"{group} {key}: {why}")
        warnings.warn(f"{group} {key}, left out: {why}", stacklevel=3)
    return table.make(_joined(parts))


def _joined(parts: list[dict[str, Any]]) -> dict[str, Any]:
    """One after another; NaN where a part lacks a column, as of a group whose noise has no estimate."""
    import numpy

    widest = max(parts, key=len)
    gaps = [numpy.full(len(next(iter(part.values()))), numpy.nan) for part in parts]
    return {name: numpy.concatenate([part.get(name, gap) for part, gap in zip(parts, gaps)]) for name in widest}
