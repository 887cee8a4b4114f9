"""Columns of objects that have nothing but the dataframe interchange protocol, from their buffers."""

from __future__ import annotations

import ctypes
from typing import Any

# Kinds of columns, and how missing values are marked: the numbers of the protocol.
_INT, _UINT, _FLOAT, _BOOL, _STRING, _DATETIME, _CATEGORICAL = 0, 1, 2, 20, 21, 22, 23
_SENTINEL, _BITMASK, _BYTEMASK = 2, 3, 4
_LETTERS = {_INT: "i", _UINT: "u", _FLOAT: "f", _BOOL: "b", _DATETIME: "i"}
_UNITS = {"s": "s", "m": "ms", "u": "us", "n": "ns"}


def _numbers(buffer: Any, dtype: Any, first: int, count: int) -> Any:
    """`count` numbers of a buffer, a copy; bits as bools."""
    import numpy

    kind, bits = int(dtype[0]), dtype[1]
    memory = (ctypes.c_uint8 * buffer.bufsize).from_address(buffer.ptr) if buffer.bufsize else b""
    raw = numpy.frombuffer(memory, numpy.uint8)
    if kind == _BOOL and bits == 1:
        return numpy.unpackbits(raw, bitorder="little")[first : first + count].astype(bool)
    return numpy.frombuffer(raw, f"{_LETTERS[kind]}{bits // 8}")[first : first + count].copy()


def _texts(buffers: Any, first: int, count: int) -> Any:
    """Texts of UTF-8 between offsets."""
    import numpy

    ends = _numbers(buffers["offsets"][0], buffers["offsets"][1], first, count + 1)
    data = _numbers(buffers["data"][0], (_UINT, 8), 0, buffers["data"][0].bufsize).tobytes()
    return numpy.array([data[a:b].decode() for a, b in zip(ends, ends[1:])], dtype=object)


def _missing(column: Any, buffers: Any, codes: Any, first: int) -> Any:
    """Which values are missing, beside NaN."""
    import numpy

    how, mark = column.describe_null
    if int(how) == _SENTINEL:
        return codes == mark
    if int(how) not in (_BITMASK, _BYTEMASK) or buffers["validity"] is None:
        return numpy.zeros(len(codes), dtype=bool)
    buffer, dtype = buffers["validity"]
    bits = 1 if int(how) == _BITMASK else dtype[1]
    return _numbers(buffer, (_BOOL if bits == 1 else _UINT, bits), first, len(codes)).astype(int) == mark


def _dates(numbers: Any, form: str) -> Any:
    """Of a column of days, `tdD`, or of times in a unit, as `tsn:`; other forms are no dates that are known."""
    if form.startswith("tdD"):
        return numbers.astype("datetime64[D]")
    if form.startswith("tdm"):
        return numbers.astype("datetime64[ms]")
    if form.startswith("ts") and form[2:3] in _UNITS:
        return numbers.astype(f"datetime64[{_UNITS[form[2]]}]")
    return None


def _chunk(column: Any) -> Any:
    import numpy

    kind, bits, form = int(column.dtype[0]), column.dtype[1], column.dtype[2]
    buffers, first = column.get_buffers(), column.offset
    count = column.size() if callable(column.size) else column.size
    if kind == _STRING:
        values = codes = _texts(buffers, first, count)
    elif kind == _CATEGORICAL:
        codes = _numbers(buffers["data"][0], buffers["data"][1], first, count)
        names = array(column.describe_categorical["categories"]).tolist()
        values = numpy.array([*names, None], dtype=object)[codes]
    else:
        codes = _numbers(buffers["data"][0], (kind, bits), first, count)
        values = _dates(codes, form) if kind == _DATETIME else codes
        if values is None:
            return numpy.full(count, form, dtype=object)
    lost = _missing(column, buffers, codes, first)
    if not lost.any():
        return values
    if values.dtype.kind in "iuf":
        return numpy.where(lost, numpy.nan, values)
    if values.dtype.kind == "b":
        values = values.astype(object)
    values[lost] = "NaT" if values.dtype.kind == "M" else None
    return values


def array(column: Any) -> Any:
    """The values of a column: numbers, with NaN for missing ones among them, dates with NaT, or objects with None."""
    import numpy

    parts = [_chunk(chunk) for chunk in column.get_chunks()]
    return numpy.concatenate(parts) if parts else numpy.zeros(0)


def columns(frame: Any) -> dict[str, Any]:
    """The columns by their names; of what data.__dataframe__() gives."""
    return {str(name): array(frame.get_column_by_name(name)) for name in frame.column_names()}
