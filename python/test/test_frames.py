"""Tables: frames, dicts, files."""

import builtins
import datetime

import numpy
import pytest
import subcert

numbers = numpy.random.default_rng(11)


class Frame:
    """What every frame with the interchange protocol has that gives its columns by their names, and nothing else."""

    def __init__(self, columns):
        self.columns_of_it = {name: numpy.asarray(values) for name, values in columns.items()}
        self.columns = list(columns)

    def __dataframe__(self):
        return self

    def column_names(self):
        return list(self.columns_of_it)

    def __getitem__(self, name):
        return self.columns_of_it[name]


def table():
    x = numpy.round(numbers.uniform(0, 10, 60), 3)
    group = numpy.array(["b", "a", "c"] * 20, dtype=object)
    return {"x": x, "y": 2 * x + numbers.normal(size=60), "name": group, "z": x**2}


def kinds():
    yield dict
    yield Frame
    try:
        import pandas
    except ImportError:
        return
    yield pandas.DataFrame


@pytest.mark.parametrize("kind", list(kinds()))
def test_the_answer_is_of_the_kind_of_the_table(kind):
    data = table()
    found = subcert.smooth(kind(data), x="x", y="y", irregular=True, at="data", scheme="local:points=15", keep="name")
    assert type(found) is kind
    plain = subcert.smooth(data["y"], data["x"], irregular=True, at="data", scheme="local:points=15")
    names = ["x", "y", "y_sd", "y_lower", "y_upper", "name"]
    assert (list(found.__dataframe__().column_names()) if kind is not dict else list(found)) == names
    for name, numbers_of_it in zip(names, (data["x"], plain.values, plain.deviation, plain.lower, plain.upper)):
        assert numpy.array_equal(numpy.asarray(found[name]), numbers_of_it), name
    assert list(found["name"]) == list(data["name"])
    all_of_it = subcert.smooth(kind(data), irregular=True, bands=0, scheme="local:points=15")
    assert [n for n in ("x", "y", "y_sd", "z", "z_sd") if len(numpy.asarray(all_of_it[n]))] and type(all_of_it) is kind


@pytest.mark.parametrize("kind", list(kinds()))
def test_groups(kind):
    data = table()
    options = {"irregular": True, "at": "data", "scheme": "local:points=9"}
    found = subcert.smooth(kind(data), x="x", y=["y", "z"], by="name", **options)
    assert list(found["name"]) == ["b"] * 20 + ["a"] * 20 + ["c"] * 20
    for k, name in enumerate("bac"):
        rows = data["name"] == name
        alone = subcert.smooth(data["z"][rows], data["x"][rows], **options)
        assert numpy.array_equal(numpy.asarray(found["z"])[20 * k : 20 * k + 20], alone.values)
    with pytest.raises(subcert.Error, match="^name b: "):
        subcert.smooth(kind(data), x="x", y="y", by="name", irregular=True, scheme="local:points=21")


def test_a_group_that_is_too_small_does_not_stop_the_others():
    data = {"g": ["a"] * 6 + ["b"] * 2, "t": [0.0, 1, 2, 3, 4, 5, 0, 1], "v": numpy.arange(8.0)}
    with pytest.warns(UserWarning, match="^g b, left out: expected at least 4 rows"):
        found = subcert.smooth(data, by="g")
    assert list(found["g"]) == ["a"] * 6 and abs(found["v"] - numpy.arange(6)).max() < 1e-9
    with pytest.raises(subcert.DataError, match="^g b: expected at least 4 rows"):
        subcert.smooth({name: values[6:] for name, values in data.items()}, by="g")


@pytest.mark.parametrize("kind", list(kinds()))
def test_missing_values_and_dates(kind):
    days = numpy.datetime64("2024-02-01") + numpy.arange(40)
    y = numpy.arange(40.0)
    y[7] = numpy.nan
    data = kind({"day": days, "y": y})
    with pytest.raises(subcert.DataError, match="missing='drop'"):
        subcert.smooth(data)
    found = subcert.smooth(data, missing="drop", scheme="local:points=5", derivative=1, bands=0)
    assert (numpy.asarray(found["day"]).astype("datetime64[D]") == days).all()
    assert abs(numpy.asarray(found["y"]) - 1).max() < 1e-9  # a day
    lost = days.astype("datetime64[s]").copy()
    lost[3] = "NaT"
    lost[5] += 3600
    scattered = kind({"time": lost, "y": y})
    with pytest.raises(subcert.DataError, match="expected a position"):
        subcert.smooth(scattered)
    found = subcert.smooth(scattered, missing="drop", scheme="local:points=5", at="data")
    stay = numpy.array([i for i in range(40) if i not in (3, 7)])
    assert (numpy.asarray(found["time"]).astype("datetime64[s]") == lost[stay]).all()
    slope = subcert.smooth(scattered, missing="drop", irregular=True, scheme="local:points=5", derivative=1, at="data")
    assert 0.9 / 86400 < numpy.median(slope["y"]) < 1.1 / 86400  # seconds


def test_columns_of_objects():
    rows = [datetime.date(2024, 1, 1) + datetime.timedelta(days=i) for i in range(12)]
    values = numpy.array([None, *range(1, 12)], dtype=object)
    found = subcert.smooth({"d": numpy.array(rows, dtype=object), "v": values}, missing="drop", scheme="primal:n=2")
    assert abs(found["v"] - numpy.arange(12)).max() < 1e-9
    records = numpy.rec.fromarrays([numpy.arange(9.0), numpy.arange(9.0) ** 2], names=["t", "v"])
    again = subcert.smooth(records, scheme="dd:n=2", bands=0)
    assert again.dtype.names[:2] == ("t", "v") and abs(again.v - records.v).max() < 1e-9
    columns = {"x": numpy.arange(8.0), "w": numpy.ones(8)}
    counted = subcert.smooth(columns, x="none", y="x", weights="w", scheme="primal:n=2")
    assert list(counted)[:2] == ["index", "x"] and abs(counted["x"] - counted["index"]).max() < 1e-9


def test_pandas_extension_types():
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({"x": pandas.array([0, 1, None, 3, 4, 5], dtype="Int64"), "y": [0.0, 2, 4, 6, 8, 10]})
    frame["g"] = pandas.Categorical(["u"] * 6)
    found = subcert.smooth(frame, missing="drop", irregular=True, by="g", at="data", scheme="local:points=4")
    assert list(found["x"]) == [0, 1, 3, 4, 5] and numpy.allclose(found["y"], [0, 2, 6, 8, 10])


def test_files(tmp_path):
    t = numpy.arange(20.0)
    numpy.save(tmp_path / "one.npy", t**2)
    numpy.save(tmp_path / "two.npy", numpy.stack([t, t**2], axis=1))
    numpy.savez(tmp_path / "named.npz", t=t, v=t**2)
    one = subcert.smooth(tmp_path / "one.npy", scheme="dd:n=2", bands=0)
    assert list(one)[:2] == ["x", "column 1"] and abs(one["column 1"] - t**2).max() < 1e-9
    two = subcert.smooth(str(tmp_path / "two.npy"), x=1, y=2, scheme="dd:n=2", bands=0)
    assert abs(two["column 2"] - t**2).max() < 1e-9
    named = subcert.smooth(tmp_path / "named.npz", scheme="dd:n=2", bands=0)
    assert list(named)[:2] == ["t", "v"]
    with pytest.raises(subcert.UsageError, match="expected a name that ends in"):
        subcert.smooth(tmp_path / "data.xlsx")
    numpy.save(tmp_path / "pickled.npy", numpy.array([{}], dtype=object), allow_pickle=True)
    with pytest.raises(ValueError):
        subcert.smooth(tmp_path / "pickled.npy")


def test_parquet(tmp_path):
    pyarrow = pytest.importorskip("pyarrow")
    from pyarrow import feather, parquet

    data = pyarrow.table({"t": numpy.arange(20.0), "v": numpy.arange(20.0) ** 2})
    parquet.write_table(data, tmp_path / "d.parquet")
    feather.write_feather(data, tmp_path / "d.feather")
    for source in (data, tmp_path / "d.parquet", tmp_path / "d.feather"):
        found = subcert.smooth(source, scheme="dd:n=2", bands=0)
        assert isinstance(found, pyarrow.Table) and found.column_names[:2] == ["t", "v"]


def test_polars():
    polars = pytest.importorskip("polars")
    frame = polars.DataFrame({"t": numpy.arange(20.0), "v": numpy.arange(20.0) ** 2, "g": ["a", "b"] * 10})
    found = subcert.smooth(frame, by="g", scheme="dd:n=2", bands=0)
    assert isinstance(found, polars.DataFrame) and found.columns[:3] == ["g", "t", "v"]


def test_what_is_not_installed_is_named(tmp_path, monkeypatch):
    real = builtins.__import__

    def without(name, *rest):
        if name.split(".")[0] in ("pyarrow", "pandas", "polars"):
            raise ImportError(name)
        return real(name, *rest)

    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(ImportError, match="need pyarrow"):
        subcert.smooth(tmp_path / "d.parquet")
    assert len(subcert.smooth({"t": numpy.arange(9.0), "v": numpy.ones(9)}, scheme="primal:n=2")["v"]) == 9


@pytest.mark.parametrize(
    "options, message",
    [
        ({"x": "u"}, "x: expected one of the columns x, y, name, z; got 'u'"),
        ({"x": "name"}, "column name: expected numbers; found text"),
        ({"by": 9}, "by: expected one of"),
        ({"keep": "z"}, "keep needs at='data'"),
        ({"missing": "guess"}, "missing: expected raise, drop or keep"),
        ({"weights": [1, 2]}, "weights: expected the name of a column; got list"),
    ],
)
def test_refused(options, message):
    with pytest.raises(subcert.Error, match="^" + message.replace("(", "\\(")):
        subcert.smooth(table(), **options)


def test_arrays_without_tables():
    y = numpy.arange(30.0)
    y[4] = numpy.nan
    with pytest.raises(subcert.DataError):
        subcert.smooth(y)
    found = subcert.smooth(y, missing="drop", scheme="primal:n=3")
    assert abs(found.values - numpy.arange(30)).max() < 1e-9
    x = numpy.arange(30.0)
    x[9] = numpy.nan
    options = {"irregular": True, "scheme": "local:points=5", "at": "data", "weights": [1] * 30}
    scattered = subcert.smooth(y, x, missing="drop", **options)
    assert len(scattered.values) == 28
    with pytest.raises(subcert.UsageError, match="columns of a table"):
        subcert.smooth(y, by="g")
    with pytest.raises(subcert.DataError, match="none"):
        subcert.smooth({"a": numpy.array(["u", "v"])})
    with pytest.raises(subcert.DataError, match="rows"):
        subcert.smooth({"a": numpy.arange(3.0), "b": numpy.arange(4.0)})


def test_an_index_of_pandas_that_has_a_name_or_dates_is_the_positions():
    pandas = pytest.importorskip("pandas")
    days = pandas.to_datetime(["2024-01-01", "2024-01-02", "2024-01-04", "2024-01-05", "2024-01-08", "2024-01-09"])
    frame = pandas.DataFrame({"v": [0.0, 1, 3, 4, 7, 8]}, index=days)
    found = subcert.smooth(frame, at="data", irregular=True)
    assert list(found.index) == list(days)
    assert numpy.allclose(found["v"], frame["v"])
    assert numpy.allclose(subcert.smooth(frame["v"], at="data", irregular=True)["v"], frame["v"])
    counted = subcert.smooth(frame, x="none", at="data")
    assert list(counted["x"]) == [0, 1, 2, 3, 4, 5]
    named = pandas.DataFrame({"v": [0.0, 1, 3, 4, 7, 8]}, index=pandas.Index([0, 1, 3, 4, 7, 8], name="t"))
    assert numpy.allclose(subcert.smooth(named, at="data", irregular=True)["v"], named["v"])
    assert list(subcert.smooth(named, x="none", at="data").columns)[:2] == ["x", "v"]
    clash = pandas.DataFrame({"t": [1.0, 2, 3], "v": [1.0, 2, 3]}, index=pandas.Index([1, 2, 3], name="t"))
    with pytest.raises(subcert.DataError):
        subcert.smooth(clash)
    # Labels of rows are none.
    labels = pandas.DataFrame({"v": [1.0, 2, 3, 4]}, index=[7, 9, 11, 13])
    assert list(subcert.smooth(labels, at="data")["x"]) == [0, 1, 2, 3]
