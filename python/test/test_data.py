"""Data in arrays."""

import numpy
import pytest
import subcert

numbers = numpy.random.default_rng(7)


def test_refined_curves_have_the_shape_of_their_data():
    points = numbers.normal(size=(11, 2))
    curve = subcert.scheme("primal:n=3").refine(points, 3, closed=True)
    assert curve.shape == (88, 2)
    assert curve.flags.c_contiguous and curve.dtype == numpy.float64
    for k in range(2):
        assert numpy.array_equal(curve[:, k], subcert.scheme("primal:n=3").refine(points[:, k], 3, closed=True))


def test_polynomials_are_reproduced():
    x = numpy.arange(20.0)
    s = subcert.scheme("dd:n=2")
    refined, [(first, step)] = s.refine(x**3 - x, 2, parameters=True)
    at = float(first) + float(step) * numpy.arange(len(refined))
    assert numpy.allclose(refined, at**3 - at, rtol=1e-12, atol=1e-9)


def test_values_and_slopes_are_refined():
    x = numpy.arange(6.0) / 4
    data = numpy.stack([x, x**3, 3 * x**2], axis=1)  # the slopes are by the positions in front
    refined = subcert.refine("hermite-dd:points=2,order=2", data, 2)
    at = numpy.arange(21) / 16
    assert numpy.allclose(refined, numpy.stack([at, at**3, 3 * at**2], axis=1), rtol=0, atol=1e-14)
    by_parameter = subcert.refine("hermite-dd:points=2,order=2", data[:, 1:] * [1, 1 / 4], 2)
    assert numpy.allclose(by_parameter, refined[:, 1:] * [1, 1 / 4], rtol=0, atol=1e-14)
    with pytest.raises(subcert.DataError, match="a multiple of 2 columns"):
        subcert.refine("hermite-dd:points=2,order=2", x)


def test_levels_of_hermite_schemes():
    two = ["hermite-dd:points=4,order=2", "hermite-dd:points=2,order=2"]
    x = numpy.arange(6.0)
    refined = subcert.refine(two, numpy.stack([x**3, 3 * x**2], axis=1), 3)
    at = numpy.arange(41.0) / 8
    assert numpy.allclose(refined, numpy.stack([at**3, 3 * at**2], axis=1), rtol=1e-12)
    points, values = subcert.limit_in_turn(two, 2)
    assert values[points.index(0)] == (1, 0) and all(isinstance(one, tuple) for one in values)
    alone, own = subcert.scheme(two[1]).limit(2, exact=True)
    assert subcert.limit_in_turn(two[1:], 2) == ([point for (point,) in alone], own)
    apart = ["merrien:lambda=-1/8,mu=2", "merrien:lambda=-1/8,mu=5"]
    for wrong in (["dd:n=2", *two], ["ghm", *two], [], ["loop"], apart):
        with pytest.raises((subcert.DomainError, subcert.UndecidedError)):
            subcert.limit_in_turn(wrong, 1)
    with pytest.raises(subcert.DomainError):
        subcert.refine(["ghm", two[0]], numpy.ones((6, 2)), 1)


def test_surfaces_run_along_the_axes_of_the_array():
    heights = numbers.normal(size=(9, 13))
    tensor = subcert.scheme("tensor:(dd:n=2)x(bspline:degree=3)")
    refined = tensor.refine(heights, 1)
    rows = subcert.scheme("bspline:degree=3").refine(heights, 1)  # points with 13 coordinates, along axis 0
    both = subcert.scheme("dd:n=2").refine(rows.T.copy(), 1).T
    assert refined.shape == both.shape and numpy.allclose(refined, both, atol=1e-12)


def test_views_and_integers_are_taken():
    data = numpy.arange(40).reshape(20, 2)
    s = subcert.scheme("primal:n=2")
    assert numpy.array_equal(s.refine(data[:, 0]), s.refine(data[:, 0].astype(float).copy()))


@pytest.mark.parametrize(
    "data, kind, text",
    [
        (numpy.zeros((3, 3, 3)), subcert.DomainError, "dimensions"),
        (numpy.zeros(2), subcert.DomainError, "at least"),
        ([1, 2, 3, float("nan"), 4, 5, 6], subcert.DataError, "finite"),
    ],
)
def test_bad_data(data, kind, text):
    with pytest.raises(kind, match=text):
        subcert.scheme("primal:n=2").refine(data)


CUBE = (
    [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]],
    [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]],
)


def test_meshes():
    points, faces = subcert.refine_mesh("catmull-clark", *CUBE)
    assert points.shape == (26, 3) and faces.shape == (24, 4)
    assert numpy.allclose(points[0], 2 / 9, atol=1e-15) and numpy.allclose(points[20:].mean(axis=0), 0.5)
    points, faces = subcert.refine_mesh("doo-sabin", *CUBE)
    assert points.shape == (24, 3) and sorted(map(len, faces)) == [3] * 8 + [4] * 18
    points, faces, normals = subcert.refine_mesh("catmull-clark", *CUBE, 2, limit=True, normals=True)
    assert points.shape == normals.shape == (98, 3)
    assert numpy.allclose((normals**2).sum(axis=1), 1) and (((points - 0.5) * normals).sum(axis=1) > 0.2).all()
    block, _ = subcert.refine_mesh("catmull-clark", *CUBE, crease=45, limit=True)
    assert numpy.array_equal(block[:8], CUBE[0])
    finer, _ = subcert.refine_mesh("catmull-clark", *CUBE)
    smoothed, kept = subcert.refine_mesh("catmull-clark", *CUBE, keep_faces=True)
    assert numpy.array_equal(smoothed, finer[:8]) and numpy.array_equal(kept, CUBE[1])
    regular = 'scheme = "catmull-clark"\n[[rule]]\n'
    regular += 'weights = {vertex = "9/16", neighbours = "3/(8*n)", across = "1/(16*n)"}'
    tuned, _ = subcert.refine_mesh(subcert.vertex_rules(regular), *CUBE)
    assert numpy.allclose(tuned[0], 3 / 8 * 1 / 3 + 1 / 16 * 2 / 3) and numpy.array_equal(tuned[8:], finer[8:])
    one, _ = subcert.refine_mesh("loop", [[1.0], [2], [3]], numpy.array([[0, 1, 2]]))
    assert numpy.array_equal(one[:, 0], [1.375, 2, 2.625, 1.5, 2.5, 2])


@pytest.mark.parametrize(
    "vertices, faces, kind, text",
    [
        (CUBE[0], [[0, 1, 8]], subcert.DataError, "face 0: expected the number of a vertex from 0 to 7; found 8"),
        (CUBE[0], [[0, 1, -1]], subcert.DataError, "found -1"),
        (CUBE[0], [[0, 1]], subcert.DataError, "three or more vertices; found 2"),
        (CUBE[0], [[0, 1, 1]], subcert.DataError, "one of them twice"),
        (CUBE[0], [[0, 1, 2], [0, 1, 3]], subcert.DataError, "in the same direction; face 1 has it, too"),
        (CUBE[0], [], subcert.DataError, "no faces"),
        (CUBE[0], [[0.5, 1, 2]], subcert.DomainError, "numbers of vertices"),
        ([[0, 0, numpy.nan], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], subcert.DataError, "got nan at vertex 0"),
        ([0, 1, 2], [[0, 1, 2]], subcert.DomainError, "two dimensions"),
    ],
)
def test_bad_meshes(vertices, faces, kind, text):
    with pytest.raises(kind, match=text):
        subcert.refine_mesh("catmull-clark", vertices, faces)


def test_bad_options():
    s, data = subcert.scheme("primal:n=2"), numpy.zeros(20)
    with pytest.raises(subcert.UsageError, match="boundary"):
        s.refine(data, boundary="glue")
    with pytest.raises(subcert.SizeError):
        s.refine(data, 60)
    with pytest.raises(subcert.DomainError):
        s.refine(data, -1)
    with pytest.raises(subcert.DomainError, match="no limit"):
        subcert.scheme("four-point:w=1/2").refine(data, limit=True)


def test_smoothing():
    x = numpy.linspace(0, 1, 200)
    y = numpy.sin(6 * x) + 0.1 * numbers.normal(size=200)
    found = subcert.smooth(y, x)
    assert found.scheme.startswith(("primal:n=", "local:points=")) and found.candidates[0][0] == found.scheme
    assert found.values.shape == found.lower.shape == (200,)
    assert (found.lower < found.values).all() and (found.values < found.upper).all()
    assert abs(found.values - numpy.sin(6 * x)).max() < 0.15
    assert numpy.allclose(found.x, x)
    assert 0.005 < found.noise_variance < 0.02
    plain = subcert.scheme("primal:n=4").smooth(y, bands=0, level=2)
    assert plain.lower is None and plain.values.size == 199 * 4 + 1
    slope = subcert.smooth(y, x, scheme="primal:n=8,d=3", derivative=1)
    off = abs(slope.values - 6 * numpy.cos(6 * x)) / slope.deviation
    assert off.max() < 6  # standard deviations, at 200 points
    together = subcert.smooth(y, x, kind="simultaneous")
    assert (together.upper - together.lower > 1.2 * (found.upper - found.lower)).all()
    with pytest.raises(subcert.UsageError, match="pointwise, prediction, simultaneous"):
        subcert.smooth(y, kind="wide")
    weights = [1] * 200
    weights[77] = 0
    gap = subcert.smooth(numpy.where(numpy.arange(200) == 77, 1e6, y), weights=weights, scheme="primal:n=4")
    assert abs(gap.values[77]) < 2


def test_standard_deviations_of_the_noise():
    y = numpy.sin(numpy.arange(60.0))
    errors = numpy.where(numpy.arange(60) < 30, 0.5, 2.0)
    weighed = subcert.smooth(y, weights=1 / errors**2, noise=1.0, scheme="primal:n=3")
    found = subcert.smooth(y, errors=errors, scheme="primal:n=3")
    assert (found.values == weighed.values).all() and (found.deviation == weighed.deviation).all()
    frame = {"x": numpy.arange(60.0), "y": y, "s": errors}
    table = subcert.smooth(frame, x="x", y="y", errors="s", scheme="primal:n=3")
    assert (table["y"] == found.values).all() and (table["y_sd"] == found.deviation).all()
    for data, more in ((y, {"weights": errors}), (frame, {"y": "y", "weights": "s"})):
        with pytest.raises(subcert.UsageError, match="weights and errors"):
            subcert.smooth(data, errors=errors if data is y else "s", **more)
    with pytest.raises(subcert.DomainError, match="1e-75"):
        subcert.smooth(y, errors=0 * y)


def test_smoothing_at_scattered_positions():
    generator = numpy.random.default_rng(1)
    x = numpy.sort(generator.uniform(0, 10, 300))
    y = numpy.sin(x) + generator.normal(0, 0.1, 300)
    found = subcert.smooth(y, x, irregular=True)
    assert found.scheme.startswith("local:points=") and found.candidates
    off = found.values - numpy.sin(found.x)
    assert (off**2).mean() ** 0.5 < 0.04 and abs(off[5:-5]).max() < 0.15
    there = subcert.smooth(y, x, irregular=True, at="data", scheme="local:width=1/2,d=2", noise=0.1)
    assert (there.x == x).all() and there.noise_variance == pytest.approx(0.01)
    line = subcert.smooth(3 - x, x, irregular=True, scheme="primal:n=6", level=1, spacing="1/16", bands=0)
    assert abs(line.values - (3 - line.x)).max() < 1e-9
    assert line.x[1] - line.x[0] == pytest.approx(1 / 32)
    weights = [0] + [1] * 299
    kept = subcert.smooth(y, x, irregular=True, at="data", scheme="local:points=20", weights=weights)
    assert (kept.x == x[1:]).all()
    filtered = subcert.smooth(y, scheme="local:points=7,d=2,weight=box", bands=0)
    assert abs(filtered.values - savitzky_golay(y, 3, 2)).max() < 1e-12
    for bad in ({"at": "there"}, {"scheme": "local:points=0"}):
        with pytest.raises(subcert.Error):
            subcert.smooth(y, **bad)
    with pytest.raises(subcert.DomainError):
        subcert.smooth(y, noise=-1.0)


def test_values_with_slopes():
    generator = numpy.random.default_rng(2)
    x = numpy.sort(generator.uniform(0, 10, 200))
    y, dy = numpy.sin(x) + generator.normal(0, 0.1, 200), numpy.cos(x) + generator.normal(0, 0.1, 200)
    found = subcert.smooth(y, x, slopes=dy, at="data")
    alone = subcert.smooth(y, x, at="data")
    error = ((found.values - numpy.sin(x)) ** 2).mean()
    assert error < 0.8 * ((alone.values - numpy.sin(x)) ** 2).mean()
    assert ((found.slopes.values - numpy.cos(x)) ** 2).mean() < 0.01
    assert (found.slopes.lower < found.slopes.upper).all()
    assert found.slopes.noise_variance == pytest.approx(0.01, rel=0.4)
    # In any order, with rows left out, as a table, and with noise that is known.
    backwards = subcert.smooth(y[::-1], x[::-1], slopes=dy[::-1], at="data", scheme=found.scheme)
    assert (backwards.slopes.values[::-1] == found.slopes.values).all()
    table = {"x": x, "y": y, "dy": dy}
    made = subcert.smooth(table, x="x", y="y", slopes="dy", at="data", scheme=found.scheme)
    assert list(made)[5:] == ["dy", "dy_sd", "dy_lower", "dy_upper"]
    assert (made["y"] == found.values).all() and (made["dy_upper"] == found.slopes.upper).all()
    gap = {**table, "dy": numpy.where(numpy.arange(200) == 50, numpy.nan, dy)}
    left = subcert.smooth(gap, x="x", y="y", slopes="dy", at="data", scheme=found.scheme, missing="drop")
    short = subcert.smooth(numpy.delete(y, 50), numpy.delete(x, 50), slopes=numpy.delete(dy, 50), at="data",
                           scheme=found.scheme)  # fmt: skip
    assert left["dy"] == pytest.approx(short.slopes.values) and len(left["x"]) == 199
    known = subcert.smooth(y, x, slopes=dy, noise=0.1, slope_noise=0.2, scheme="local:points=9,d=3")
    assert known.slopes.noise_variance == pytest.approx(0.04)
    assert subcert.smooth(y, x, slopes=dy, derivative=1, scheme="local:points=9,d=3").slopes is None
    for bad in ({"slope_noise": 1.0}, {"slopes": dy[1:]}, {"slopes": dy, "scheme": "primal:n=2"},
                {"slopes": dy, "boundary": "mirror"}, {"slopes": dy, "slope_noise": 0.0}):  # fmt: skip
        with pytest.raises(subcert.Error):
            subcert.smooth(y, x, irregular=True, **bad)
    with pytest.raises(subcert.UsageError):
        subcert.smooth(table, x="x", y=["y"], slopes=["dy", "x"])


def test_positions_in_any_order():
    generator = numpy.random.default_rng(2)
    x = generator.integers(0, 40, 120).astype(float)
    y = 3 - 2 * x
    for scheme in ("local:points=9", "local:width=4,d=2", ""):
        line = subcert.smooth(y, x, irregular=True, at="data", scheme=scheme, noise=1)
        assert (line.x == x).all() and abs(line.values - y).max() < 1e-9, scheme
        assert (line.deviation > 0).all()
    weights = [i % 3 for i in range(120)]
    kept = subcert.smooth(y, x, irregular=True, at="data", scheme="local:points=9", weights=weights)
    assert (kept.x == x[numpy.array(weights) > 0]).all()
    noisy = y + generator.normal(size=120)
    order = numpy.argsort(x, kind="stable")
    shuffled = subcert.smooth(noisy, x, irregular=True, at="data", scheme="local:points=15,d=2")
    plain = subcert.smooth(noisy[order], x[order], irregular=True, at="data", scheme="local:points=15,d=2")
    assert (shuffled.values[order] == plain.values).all()
    falling = numpy.arange(20.0)[::-1] / 3
    waves = subcert.smooth(falling**2, falling, scheme="local:points=5,d=2", derivative=1, level=1)
    assert (numpy.diff(waves.x) < 0).all() and abs(waves.values - 2 * waves.x).max() < 1e-9
    assert (subcert.smooth(falling, falling, scheme="primal:n=2", at="data").x == falling).all()
    closed = subcert.scheme("four-point:w=1/16").refine(numpy.array([[0.0, 0], [1, 0], [0, 1]]), 1, closed=True)
    assert numpy.array_equal(closed[1], [0.5625, -0.125])
    with pytest.raises(subcert.DataError, match="twice"):
        subcert.smooth([1.0, 2, 3], [0.0, 1, 1], irregular=False)
    with pytest.raises(subcert.DataError, match="twice"):
        subcert.smooth([1.0, 2, 3], [0.0, 1, 1], scheme="primal:n=1")
    taken, named = (subcert.smooth(noisy, x, irregular=how, at="data", scheme="local:d=1") for how in (None, True))
    assert (taken.values == named.values).all()
    with pytest.raises(subcert.DataError, match="two different"):
        subcert.smooth([1.0, 2, 3], [1.0, 1, 1], irregular=True)


def test_grids_with_missing_data():
    heights = numpy.add.outer(numpy.arange(9.0), 2 * numpy.arange(7.0))
    holes = heights.copy()
    holes[3, 2:4] = numpy.nan
    filled = subcert.smooth(holes, missing="drop", scheme="local:points=5,d=1", at="data")
    assert abs(filled.values - heights).max() < 1e-9
    kept = subcert.smooth(holes, missing="keep", at="data")
    assert (numpy.isnan(kept.values) == numpy.isnan(holes)).all()
    for wrong in ({}, {"missing": "drop", "scheme": "primal:n=2"}, {"missing": "drop", "kind": "simultaneous"}):
        with pytest.raises(subcert.Error):
            subcert.smooth(holes, **wrong)
    with pytest.raises(subcert.DataError, match="inf"):
        subcert.smooth(heights + numpy.inf, missing="drop")
    with pytest.raises(subcert.UsageError, match="heights and volumes"):
        subcert.smooth(heights[0], missing="keep")


def test_values_at_given_positions():
    x = numpy.array([0.0, 0.5, 1, 3, 3, 4, 7, 8, 10])
    for scheme in ("local:points=4", "primal:n=2", ""):
        found = subcert.smooth(2 * x - 1, x, irregular=True, scheme=scheme, at=[7.25, -1, 0.1, 10], noise=1)
        assert numpy.allclose(found.values, [13.5, numpy.nan, -0.8, 19], atol=1e-9, equal_nan=True)
        assert found.x.tolist() == [7.25, -1, 0.1, 10] and numpy.isnan(found.deviation).tolist() == [0, 1, 0, 0]
    assert subcert.smooth(x, scheme="dd:n=2", at=2.0).values == [1]
    days = numpy.array("2024-02-27", "M8[D]") + numpy.arange(6)
    table = {"day": days, "mass": numpy.arange(6.0)}
    answer = subcert.smooth(table, scheme="primal:n=1", bands=0, at=numpy.array(["2024-02-29T12"], "M8[h]"))
    assert answer["day"][0] == numpy.datetime64("2024-02-29T12") and answer["mass"][0] == 2.5
    for wrong in ([], [[1.0]], [numpy.nan]):
        with pytest.raises(subcert.DomainError):
            subcert.smooth(x, scheme="dd:n=2", at=wrong)
    with pytest.raises(subcert.DataError, match="found none"):
        subcert.smooth(x, scheme="dd:n=2", at=[99])


def savitzky_golay(y, half, degree):
    """Fits to 2 half + 1 data, by least squares of numpy."""
    centres = numpy.clip(numpy.arange(y.size), half, y.size - 1 - half)
    fits = [numpy.polyfit(numpy.arange(-half, half + 1), y[c - half : c + half + 1], degree) for c in centres]
    return numpy.array([numpy.polyval(fit, i - c) for i, (fit, c) in enumerate(zip(fits, centres))])


def test_positions_are_taken_as_they_are_where_the_method_takes_them():
    x = numpy.array([0.0, 1, 2, 4, 5, 7, 8, 9, 12])
    for scheme in ("", "local:points=4", "local:d=1"):
        taken = subcert.smooth(2 * x + 1, x, scheme=scheme, at="data", bands=0)
        assert numpy.allclose(taken.values, 2 * x + 1, atol=1e-9)
        with pytest.raises(subcert.DataError, match="irregular=True takes positions as they are"):
            subcert.smooth(2 * x + 1, x, scheme=scheme, irregular=False)
    with pytest.raises(subcert.DataError, match="irregular=True takes positions as they are"):
        subcert.smooth(2 * x + 1, x, scheme="primal:n=2")
    table = {"x": x, "y": 2 * x + 1}
    assert numpy.allclose(subcert.smooth(table, at="data", bands=0)["y"], 2 * x + 1, atol=1e-9)


def test_correlated_noise_is_said_as_the_command_says_it():
    random = numpy.random.default_rng(5)
    noise = numpy.convolve(random.normal(size=1300), 0.6 ** numpy.arange(40), "valid")
    with pytest.warns(UserWarning, match="the noise is correlated from datum to datum, and bands are too narrow"):
        found = subcert.smooth(noise, scheme="primal:n=6")
    assert found.correlated is not None and -0.667 < found.correlated < 0


def test_robust_smoothing():
    random = numpy.random.default_rng(8)
    x = numpy.sort(random.uniform(0, 10, 300))
    y = numpy.sin(x) + 0.1 * random.normal(size=300)
    y[::10] += 5
    with pytest.warns(UserWarning, match="outliers move this fit; scheme='local:d=1,robust=3' leaves them out"):
        plain = subcert.smooth(y, x, irregular=True, at="data")
    assert plain.outliers > 10 and plain.bands_method == "linear"
    for scheme, resamples, method in (
        ("local:d=1,robust=3", 0, "sandwich"),
        ("l1:points=12,iterations=20", 50, "bootstrap"),
    ):
        robust = subcert.smooth(y, x, irregular=True, at="data", scheme=scheme, resamples=resamples)
        assert abs(robust.values - numpy.sin(x)).mean() < 0.06 < abs(plain.values - numpy.sin(x)).mean()
        assert robust.bands_method == method and (robust.lower < robust.upper).all()
    crossed = subcert.smooth(numpy.sin(x), x, irregular=True, at="data", select="cv", derivative=1, bands=0)
    assert abs(crossed.values - numpy.cos(x))[20:-20].max() < 0.2
    for bad in ({"select": "best"}, {"resamples": 1}, {"scheme": "local:points=9,robust=1", "kind": "prediction"}):
        with pytest.raises(subcert.Error):
            subcert.smooth(y, **bad)


def test_smoothing_refuses():
    y = numpy.zeros(50)
    with pytest.raises(subcert.DataError, match="uniform"):
        subcert.smooth(y, numpy.arange(50.0) ** 2, irregular=False)
    with pytest.raises(subcert.DataError, match="finite"):
        subcert.smooth(numpy.full(50, numpy.inf))
    with pytest.raises(subcert.DomainError, match="as many"):
        subcert.smooth(y, weights=[1, 2])
    with pytest.raises(subcert.UsageError):
        subcert.smooth(y, scheme="primal:q=1")
    with pytest.raises(subcert.DomainError):
        subcert.smooth(y.reshape(5, 5, 2, 1))


def test_outliers():
    y = numpy.arange(30.0)
    y[12] = 500
    found = subcert.smooth(y, scheme="l1:points=8,iterations=30")
    assert abs(found.values[12] - 12) < 1 and found.deviation is None


def test_heights_and_volumes():
    y, x = numpy.mgrid[0:12, 0:17]
    heights = 2.0 * x - y + 0.5 * x * y
    found = subcert.smooth(heights, level=1, scheme="tensor:(primal:n=2)x(dual:n=3)", noise=2.0)
    assert [len(along) for along in found.x] == [23, 33] and found.values.shape == (23, 33)
    assert numpy.array_equal(found.x[0], numpy.arange(23) / 2)
    b, a = numpy.meshgrid(found.x[0], found.x[1], indexing="ij")
    assert abs(found.values - (2 * a - b + 0.5 * a * b)).max() < 1e-10
    along_y = subcert.smooth(heights[:, 0], level=1, scheme="dual:n=3", noise=1.0)
    along_x = subcert.smooth(heights[0], level=1, scheme="primal:n=2", noise=1.0)
    assert numpy.allclose(found.deviation, 2 * numpy.outer(along_y.deviation, along_x.deviation), rtol=1e-12)
    noisy = numpy.sin(x / 3.0) + numbers.normal(size=x.shape) / 5
    chosen = subcert.smooth(noisy, kind="simultaneous")
    pointwise = subcert.smooth(noisy)
    assert chosen.scheme == chosen.candidates[0][0] and len(chosen.candidates) > 10
    assert chosen.candidates[0][1] == min(error for _, error in chosen.candidates)
    assert ((chosen.upper - chosen.lower) > 1.2 * (pointwise.upper - pointwise.lower)).all()
    assert 0.15**2 < chosen.noise_variance < 0.25**2 and chosen.bands_method == "linear"
    volume = numpy.arange(60.0).reshape(3, 4, 5)
    assert numpy.allclose(subcert.smooth(volume, scheme="primal:n=1", bands=0).values, volume)
    for options, name in (({"x": x}, "x"), ({"derivative": 1}, "derivative"), ({"select": "cv"}, "select='cv'")):
        with pytest.raises(subcert.UsageError, match=f"heights and volumes have no {name}"):
            subcert.smooth(heights, **options)
    with pytest.raises(subcert.DataError, match="finite"):
        subcert.smooth(numpy.full((4, 4), numpy.nan), scheme="primal:n=1")
    with pytest.raises(subcert.DomainError):
        subcert.smooth(numpy.zeros((0, 4)))
