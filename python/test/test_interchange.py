"""Frames of which nothing is known but the protocols that frames have: their buffers, or their names."""

import ctypes

import numpy
import pytest
import subcert

LETTERS = {"i": 0, "u": 1, "f": 2}


class Buffer:
    def __init__(self, values):
        self.held = numpy.ascontiguousarray(values)
        self.bufsize, self.ptr = self.held.nbytes, self.held.ctypes.data if self.held.nbytes else 0


class Chunk:
    """A column of one piece: `values` has None where one is missing; the buffers begin `offset` values earlier."""

    def __init__(self, values, kind, offset=0, bits=True):
        self.kind, self.offset, self.bits, self.given = kind, offset, bits, list(values)
        self.all = [values[0]] * offset + self.given
        self.null_count = sum(v is None for v in self.given)

    def size(self):
        return len(self.given)

    def num_chunks(self):
        return 1

    def get_chunks(self, n_chunks=None):
        yield self

    @property
    def dtype(self):
        if self.kind == "str":
            return (21, 8, "u", "=")
        if self.kind == "bool":
            return (20, 1, "b", "=")
        if self.kind == "date":
            return (22, 32, "tdD", "=")
        if self.kind == "time":
            return (22, 64, "tsm:UTC", "=")
        if self.kind == "category":
            return (23, 8, "c", "=")
        return (LETTERS[self.kind[0]], int(self.kind[1:]), "", "=")

    @property
    def describe_null(self):
        if self.kind == "category":
            return (2, -1)
        if self.kind[0] == "f":
            return (1, None)
        return (3, 0) if self.bits else (4, 1)

    @property
    def describe_categorical(self):
        return {"is_ordered": False, "is_dictionary": True, "categories": Chunk(["u", "v"], "str")}

    def get_buffers(self):
        there = numpy.array([v is not None for v in self.all])
        valid = numpy.packbits(there, bitorder="little") if self.bits else (~there).astype(numpy.uint8)
        buffers = {"validity": (Buffer(valid), (20, 1 if self.bits else 8, "b", "=")), "offsets": None}
        if self.kind == "str":
            texts = [b"" if v is None else v.encode() for v in self.all]
            ends = numpy.cumsum([0] + [len(t) for t in texts]).astype(numpy.int32)
            data = numpy.frombuffer(b"".join(texts), numpy.uint8)
            return {**buffers, "data": (Buffer(data), (1, 8, "C", "=")), "offsets": (Buffer(ends), (0, 32, "i", "="))}
        if self.kind == "bool":
            packed = numpy.packbits([bool(v) for v in self.all], bitorder="little")
            return {**buffers, "data": (Buffer(packed), self.dtype)}
        if self.kind == "category":
            codes = numpy.array([-1 if v is None else "uv".index(v) for v in self.all], numpy.int8)
            return {**buffers, "validity": None, "data": (Buffer(codes), (0, 8, "c", "="))}
        if self.kind in ("date", "time"):
            unit, width = ("D", numpy.int32) if self.kind == "date" else ("ms", numpy.int64)
            numbers = [0 if v is None else numpy.datetime64(v, unit).astype(numpy.int64) for v in self.all]
            return {**buffers, "data": (Buffer(numpy.array(numbers, width)), (0, 8 * width().itemsize, "", "="))}
        fill = numpy.nan if self.kind[0] == "f" else 77
        numbers = numpy.array([fill if v is None else v for v in self.all], f"{self.kind[0]}{int(self.kind[1:]) // 8}")
        if self.kind[0] == "f":
            buffers["validity"] = None
        return {**buffers, "data": (Buffer(numbers), self.dtype)}


class Column(Chunk):
    """A column in pieces."""

    def __init__(self, values, kind, pieces, **how):
        super().__init__(values, kind)
        cuts = numpy.linspace(0, len(values), pieces + 1).astype(int)
        self.pieces = [Chunk(values[a:b], kind, 3 * k, **how) for k, (a, b) in enumerate(zip(cuts, cuts[1:]))]

    def num_chunks(self):
        return len(self.pieces)

    def get_chunks(self, n_chunks=None):
        yield from self.pieces

    def get_buffers(self):
        raise AssertionError("buffers are those of chunks")


class OnlyBuffers:
    """The object of the protocol, which has no columns by [name]."""

    def __init__(self, columns):
        self.held = columns

    def __dataframe__(self, nan_as_null=False, allow_copy=True):
        return self

    def column_names(self):
        return iter(self.held)

    def get_column_by_name(self, name):
        return self.held[name]


def columns_of(pieces, **how):
    count = 24
    return {
        "name": Column(["é", None, "c", ""] * 6, "str", pieces, **how),
        "x": Column([float(i) for i in range(count)], "f64", pieces),
        "few": Column([None if i == 5 else 2 * i for i in range(count)], "i16", pieces, **how),
        "many": Column([3 * i for i in range(count)], "u32", pieces, **how),
        "flag": Column([None if i == 9 else i % 2 == 0 for i in range(count)], "bool", pieces, **how),
        "kind": Column([None if i == 7 else "uv"[i % 2] for i in range(count)], "category", pieces),
        "day": Column([None if i == 3 else f"2024-02-{i + 1:02}" for i in range(count)], "date", pieces, **how),
        "time": Column([f"2024-02-01T{i:02}:00:00.250" for i in range(count)], "time", pieces, **how),
    }


@pytest.mark.parametrize("pieces", [1, 2, 5])
@pytest.mark.parametrize("bits", [True, False])
def test_columns_come_from_their_buffers(pieces, bits):
    data = OnlyBuffers(columns_of(pieces, bits=bits))
    options = {"scheme": "local:points=5", "at": "data", "bands": 0}
    plain = subcert.smooth(data, x="x", y="many", keep=["name", "kind", "flag"], **options)
    assert type(plain) is dict and list(plain) == ["x", "many", "many_sd", "name", "kind", "flag"]
    assert abs(plain["many"] - 3 * numpy.arange(24)).max() < 1e-9
    assert list(plain["name"]) == ["é", None, "c", ""] * 6
    assert list(plain["kind"]) == [None if i == 7 else "uv"[i % 2] for i in range(24)]
    assert list(plain["flag"]) == [None if i == 9 else i % 2 == 0 for i in range(24)]
    gap = subcert.smooth(data, x="x", y="few", missing="drop", scheme="local:points=5", bands=0)
    assert len(gap["few"]) == 24 and abs(gap["few"] - 2 * numpy.arange(24)).max() < 1e-9
    with pytest.raises(subcert.DataError, match="missing='drop'"):
        subcert.smooth(data, x="x", y="few")
    dates = subcert.smooth(data, x="day", y="many", missing="drop", irregular=True, **options)
    days = [f"2024-02-{i + 1:02}" for i in range(24) if i != 3]
    assert list(dates["day"].astype("datetime64[D]").astype(str)) == days
    times = subcert.smooth(data, x="time", y="many", scheme="local:points=5", derivative=1, bands=0)
    assert numpy.allclose(times["many"] * 3600, 3) and str(times["time"][1])[:23] == "2024-02-01T01:00:00.250"


def test_frames_of_pandas_by_the_protocol_alone():
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({"g": ["a", None, "b", "b"] * 5, "t": numpy.arange(20.0), "v": numpy.arange(20) ** 2})
    frame["d"] = pandas.to_datetime("2024-01-01") + pandas.to_timedelta(frame["t"], unit="D")
    frame["c"] = pandas.Categorical(frame["g"])
    bare = frame.__dataframe__()
    assert not hasattr(bare, "__getitem__")
    holder = type("Holder", (), {"__dataframe__": lambda self: bare})()
    found = subcert.smooth(holder, x="t", y="v", keep=["g", "c", "d"], scheme="dd:n=2", bands=0, at="data")
    assert numpy.allclose(found["v"], frame["v"]) and list(found["g"]) == list(frame["g"])
    assert [None if v != v else v for v in found["c"]] == list(frame["g"])
    assert list(found["d"]) == list(frame["d"])


class OnlyNames:
    """A frame that has given up the protocol for that of streams of Arrow, whose columns numpy takes by their names."""

    def __init__(self, columns):
        self.columns_of_it, self.columns = columns, list(columns)

    def __arrow_c_stream__(self, requested_schema=None):
        raise AssertionError("columns are taken by name")

    def __getitem__(self, name):
        return self.columns_of_it[name]


def test_frames_with_streams_of_arrow():
    data = OnlyNames({"t": numpy.arange(9.0), "v": numpy.arange(9.0) ** 2, 3: numpy.ones(9)})
    found = subcert.smooth(data, x="t", y="v", scheme="dd:n=2", bands=0)
    assert type(found) is OnlyNames and found.columns == ["t", "v", "v_sd"] and numpy.allclose(found["v"], data["v"])


def test_memory_of_buffers_is_copied():
    values = numpy.arange(8.0)
    column = Chunk(list(values), "f64")
    held = column.get_buffers()["data"][0]
    column.get_buffers = lambda: {"data": (held, column.dtype), "validity": None, "offsets": None}
    data = OnlyBuffers({"t": Chunk(list(range(8)), "i64"), "v": column})
    found = subcert.smooth(data, x="t", y="v", scheme="primal:n=1", bands=0, at="data")
    ctypes.memset(held.ptr, 0, held.bufsize)
    assert numpy.allclose(found["v"], values)
