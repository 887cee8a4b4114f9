"""Refinement and smoothing of data in arrays of numpy."""

from __future__ import annotations

import dataclasses
import warnings
from fractions import Fraction
from typing import Any, Optional, Sequence, Union

from . import _frames, _plots
from ._calls import core as _core
from ._calls import threads as _threads
from ._errors import DomainError, UsageError
from ._exact import Exact, fraction
from ._regularity import Progress
from ._vertices import _read_rules


def refine(
    scheme: Any,
    data: Any,
    levels: int = 1,
    *,
    closed: Union[bool, Sequence[bool]] = False,
    boundary: str = "regression",
    constant: float = 0,
    limit: bool = False,
    parameters: bool = False,
    jobs: Optional[int] = None,
    progress: Progress = None,
) -> Any:
    """Applies a scheme to data, `levels` times; of a list of schemes each level takes the next one, again and again.

    `data`: shape (n,) or (n, coordinates) for curves, (n, m) or (n, m, coordinates) for schemes of two variables, and
    so on. `closed`: the first point follows the last, for all axes or one by one. `boundary`: what rules at the ends
    read: regression, reflect, periodic, shrink, nearest or constant, which has `constant` as its value. Coordinates for
    Hermite schemes are values, then derivatives, also after one of positions. `limit`: the values of the limit at the
    new parameters. The new array owns what the library computed. With `parameters` also the pair (first, step) of each
    axis, in spacings of the data. Raises DomainError for arrays of other shapes or with too few points, DataError for
    numbers that are not finite and other columns.

    >>> import numpy, subcert
    >>> subcert.refine("four-point:w=1/16", numpy.arange(5.0) ** 3)
    array([ 0.   ,  0.125,  1.   ,  3.375,  8.   , 15.625, 27.   , 42.875,
           64.   ])
    """
    import numpy

    array = numpy.ascontiguousarray(data, dtype=numpy.float64)
    ends = [bool(closed)] * 3 if isinstance(closed, (bool, int)) else [bool(c) for c in closed]
    if len(ends) < array.ndim - 1:
        raise DomainError(f"closed: need a bool, or one for each axis, got {len(ends)}")
    ends += [False] * (3 - len(ends))
    how = (levels, boundary, float(constant), limit, _threads(jobs), progress)
    schemes = [str(one) for one in scheme] if isinstance(scheme, (list, tuple)) else [str(scheme)]
    refined, axes = _core.refine(schemes, array, ends, *how)
    return (refined, axes) if parameters else refined


def _mesh_rules(scheme: Any) -> Any:
    own = _read_rules(scheme)
    return str(scheme) if own is None else own


def refine_mesh(
    scheme: Any,
    vertices: Any,
    faces: Any,
    levels: int = 1,
    *,
    limit: bool = False,
    normals: bool = False,
    crease: Optional[float] = None,
    keep_faces: bool = False,
    progress: Progress = None,
) -> Any:
    """Refines a mesh of any topology, `levels` times, by loop, catmull-clark, doo-sabin, midedge, butterfly,
    modified-butterfly, sqrt3 or triangular:, or by rules of one's own, `vertex_rules` or a file, "FILE.toml"; gives
    the pair (vertices, faces), with `normals` also the unit normals of the limit surface at the vertices.

    `vertices`: shape (n, numbers), of any numbers that are refined as coordinates are; `faces`: shape (m, sides) of
    numbers of vertices from 0 on, or a list of lists where the faces have different numbers of sides. So are those
    of the result. `limit`: the vertices are moved to the limit surface. `crease`: edges stay sharp where the
    normals of their faces differ by more than these degrees (loop, catmull-clark). `keep_faces`: the old vertices
    alone get their new points, which smooths the mesh. Raises DataError where the faces make no oriented surface
    and for numbers that are not finite, DomainError for another scheme.

    >>> import numpy, subcert
    >>> corners = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]
    >>> points, faces = subcert.refine_mesh("loop", corners, [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]], 2)
    >>> points.shape, faces.shape
    ((34, 3), (64, 3))
    """
    import numpy

    array = numpy.ascontiguousarray(vertices, dtype=numpy.float64)
    lists = [numpy.asarray(face) for face in faces]
    if any(face.ndim != 1 or (face.size > 0 and face.dtype.kind not in "iu") for face in lists):
        raise DomainError("faces: need lists of the numbers of vertices")
    corners = numpy.concatenate(lists) if lists else numpy.zeros(0, numpy.int64)
    counts = numpy.array([len(face) for face in lists], numpy.int64)
    points, corners, sides = _core.refine_mesh(
        _mesh_rules(scheme), array, corners, counts, levels, limit, normals, crease, keep_faces, progress
    )
    if len(set(sides)) == 1:
        made = corners.reshape(-1, sides[0])
    else:
        made = numpy.split(corners, numpy.cumsum(sides)[:-1])
    return (points[:, :-3], made, points[:, -3:]) if normals else (points, made)


@dataclasses.dataclass(frozen=True, eq=False)
class Smoothed:
    """The limit of a scheme from samples, at the positions x; of heights and volumes x has the positions along each
    axis of the array. Deviations are standard deviations, lower and upper the ends of the confidence band for the
    expected value of the limit at each point; None where there are none."""

    x: Any
    values: Any
    scheme: str
    deviation: Any = None
    lower: Any = None
    upper: Any = None
    noise_variance: Optional[float] = None
    candidates: tuple[tuple[str, float], ...] = ()
    """Of the choice by estimated error: schemes with their expected squared error, the smallest first."""
    outliers: int = 0
    """Data that stand out so far that no linear method takes them well; robust ones do."""
    correlated: Optional[float] = None
    """The correlation of neighbouring second differences, where it is beyond that of independent noise, about -2/3."""
    bands_method: Optional[str] = None
    """What the bands are computed from: linear, sandwich or bootstrap."""
    slopes: Optional["Smoothed"] = None
    """Of values with slopes: those of the fits."""

    def plot(self, ax: Any = None) -> Any:
        """Draws values and band, of heights the values, and returns the axes of matplotlib."""
        if isinstance(self.x, tuple):
            return _plots.heights(ax, self.x, self.values, self.scheme)
        return _plots.bands(ax, self.x, self.values, self.lower, self.upper, self.scheme)


def _without_missing(array: Any, x: Any, weights: Any, slopes: Any) -> tuple[Any, Any, Any, Any]:
    """Without the rows that have no position; weight 0 for those that have no sample."""
    import numpy

    prior = None if weights is None else numpy.asarray(weights, dtype=object)
    if x is not None:
        x = numpy.asarray(x, dtype=numpy.float64)
        there = ~numpy.isnan(x)
        array, x, prior = array[there], x[there], None if prior is None else prior[there]
        slopes = None if slopes is None else slopes[there]
    gaps = numpy.isnan(array) if slopes is None else numpy.isnan(array) | numpy.isnan(slopes)
    if gaps.any():
        prior = numpy.where(gaps, 0, 1 if prior is None else prior)
        array = numpy.where(gaps, 0, array)
        slopes = None if slopes is None else numpy.where(gaps, 0, slopes)
    return array, x, None if prior is None else prior.tolist(), slopes


def _smooth_grid(array: Any, options: tuple[Any, ...], refused: dict[str, Any]) -> Smoothed:
    """Heights or a volume; `refused`: what only curves have, by the name of the argument."""
    named = [name for name, given in refused.items() if given]
    if named:
        raise UsageError(f"smooth: heights and volumes have no {', '.join(named)}")
    facts = _core.smooth_grid(array, *options)
    for name in ("values", "deviation", "lower", "upper"):
        if name in facts:
            facts[name] = facts[name].reshape([len(along) for along in facts["x"]])
    facts["candidates"] = tuple(facts["candidates"])
    return Smoothed(**facts)


def smooth(
    data: Any = None,
    x: Any = None,
    y: Any = None,
    *,
    by: Optional[_frames.Name] = None,
    keep: Any = None,
    missing: str = "raise",
    scheme: Any = "",
    weights: Any = None,
    errors: Any = None,
    bands: float = 0.95,
    kind: str = "pointwise",
    level: int = 0,
    derivative: int = 0,
    boundary: str = "interp",
    constant: float = 0.0,
    origin: Exact = 0,
    spacing: Optional[Exact] = None,
    irregular: Optional[bool] = None,
    at: Any = "grid",
    noise: Optional[float] = None,
    slopes: Any = None,
    slope_noise: Optional[float] = None,
    select: str = "risk",
    resamples: int = 0,
    seed: int = 2015,
    jobs: Optional[int] = None,
    progress: Progress = None,
) -> Any:
    """Smooths samples of a function by the limit of a scheme or by local polynomials.

    `data`: an array of shape (n,) for an answer of the kind Smoothed, or of heights (n, m), or a volume (n, m, k),
    which are smoothed along each axis: by one method, or "tensor:(A)x(B)", B along the first axis of the array; or
    a table: a frame of pandas, polars, pyarrow or others with the dataframe interchange protocol, a dict of arrays,
    a structured array, or the name of a file (.npy, .npz, and with pyarrow .parquet, .feather, .arrow), for a table
    of the same kind. Of a table `x`, `y`, `weights`, `errors`, `by` and `keep` are names of columns, or numbers
    from 1 on; `y` and `keep` also lists. Without `x` the first of several columns of numbers or dates holds the
    positions ("none": 0, 1, 2, ...); an index of pandas that has a name or dates is a column before all others, and
    the index of the answer. Without `y` all other columns of numbers are smoothed. `by`: each group of rows by
    itself. `keep`: columns that the answer has, too, with at="data". The columns of the answer are those of the
    command: for v also v_sd, v_lower, v_upper. Dates count in days, or in seconds where one has a time. `missing`:
    "raise", or "drop" for samples that are NaN or missing and rows without a position; of heights and volumes "keep",
    too, which leaves them NaN in the answer.

    Of an array `x` are the positions, in any order, uniform up to their last decimal place; or `origin` and
    `spacing`, 1 by default. With `irregular` other positions are taken as they are, also several data at one, and
    `spacing`, by default that of most neighbours or the mean, is that of the answer; None does so where no scheme
    is named, or a local one. At the data the answer has the order of `y`; on a grid it falls where `x` falls.
    `scheme`: a scheme or a specification, also "local:points=21,d=1" and its like; by default the one with the
    smallest estimated error. `weights`: prior weights, inverse to the variance of the noise; 0: missing. `errors`:
    in their place standard deviations of the noise, which are known with `noise` left out. `bands`: level of the
    confidence band, 0 for none. `kind`: pointwise or simultaneous, for the expected value of the limit, or
    prediction, for a new datum. `level`: values at the multiples of arity^-level of the spacing; `at`: on this
    grid, at the data ("data"), or an array of positions, NaN outside the data. `noise`: its standard deviation,
    where it is known. `slopes`: those of the samples, by position, which local polynomials fit together with the
    values, with the standard deviation `slope_noise` of their noise, where it is known; of a table the names of their
    columns, one for each of `y`. The answer has those of the fits. `select`: by what the method is chosen, its
    estimated error ("risk") or cross-validation ("cv"). `resamples`: of l1 schemes, drawings of the residuals for
    bands, with this `seed`; 0: no bands. `boundary`: interp, mirror, nearest, constant or wrap. Where outliers move a
    linear fit a UserWarning names the method that leaves them out. Raises DataError for samples that cannot be
    smoothed, DomainError for a scheme without proof of convergence.

    >>> import numpy, subcert
    >>> s = subcert.smooth(numpy.arange(12.0), scheme="primal:n=3")
    >>> bool(abs(s.values - numpy.arange(12.0)).max() < 1e-12)
    True
    >>> table = {"day": [0, 1, 2, 3], "mass": [1.0, 2.0, 3.0, 4.0]}
    >>> subcert.smooth(table, x="day", y="mass", scheme="primal:n=1", bands=0)["mass"]
    array([1., 2., 3., 4.])
    """
    options = dict(locals())
    import numpy

    if missing not in ("raise", "drop", "keep"):
        raise UsageError(f"missing: expected raise, drop or keep, got {missing!r}")
    if data is None:
        data, y = y, None
    if data is None:
        raise UsageError("smooth: expected samples, as an array or a table; got none")
    if _frames.is_table(data):
        for name in ("data", "x", "y", "by", "keep"):
            del options[name]
        return _frames.smoothed(smooth, data, x, y, by, keep, options)
    if slope_noise is not None and slopes is None:
        raise UsageError("smooth: slope_noise needs slopes")
    if errors is not None:
        if weights is not None:
            raise UsageError("smooth: weights and errors: expected one of the two")
        weights = _frames.weights_of(errors)
        noise = _frames.noise_of_errors(noise, scheme)
    if y is not None or by is not None or keep is not None:
        raise UsageError("smooth: y, by and keep are columns of a table; got an array")
    array = numpy.ascontiguousarray(data, dtype=numpy.float64)
    places = None
    if not isinstance(at, str):
        places, at = numpy.atleast_1d(numpy.ascontiguousarray(at, dtype=numpy.float64)), "grid"
        if places.ndim != 1 or places.size == 0:
            raise DomainError(f"at: need positions in one dimension, got shape {places.shape}")
    if array.ndim in (2, 3):
        grid = (str(scheme), boundary, constant, level, bands, kind, at, noise, missing, _threads(jobs), progress)
        curves: dict[str, Any] = {"at as positions": places is not None, "x": x is not None}
        curves.update(weights=weights is not None, slopes=slopes is not None)
        curves.update(derivative=derivative, irregular=bool(irregular), spacing=spacing is not None, origin=origin != 0)
        curves.update({"select='cv'": select == "cv", "resamples": resamples})
        return _smooth_grid(array, grid, curves)
    if missing == "keep":
        raise UsageError("missing='keep' is of heights and volumes; drop leaves samples out")
    if slopes is not None:
        slopes = numpy.ascontiguousarray(slopes, dtype=numpy.float64)
        if slopes.shape != array.shape:
            raise DomainError(f"slopes: need as many as samples, {array.size}, got shape {slopes.shape}")
    if missing == "drop" and array.ndim == 1:
        array, x, weights, slopes = _without_missing(array, x, weights, slopes)
    positions = None
    if x is not None:
        positions = numpy.ascontiguousarray(x, dtype=numpy.float64)
        if positions.shape != array.shape or positions.ndim != 1 or positions.size < 2:
            raise DomainError(f"x: need two positions or more, as many as samples, got shape {positions.shape}")
    prior = [] if weights is None else [Fraction(w) if isinstance(w, float) else fraction(w) for w in weights]
    if prior and len(prior) != array.size:
        raise DomainError(f"weights: need as many as samples, {array.size}, got {len(prior)}")
    facts = _core.smooth(
        array,
        positions,
        prior,
        fraction(origin),
        None if spacing is None else fraction(spacing),
        str(scheme),
        boundary,
        constant,
        level,
        derivative,
        bands,
        kind,
        irregular,
        at,
        places,
        noise,
        slopes,
        slope_noise,
        select,
        resamples,
        seed,
        _threads(jobs),
        progress,
    )
    if facts["outliers"]:
        warnings.warn(
            f"{facts['outliers']} outliers move this fit; scheme='local:d=1,robust=3' leaves them out", stacklevel=2
        )
    if facts["correlated"] is not None:
        warnings.warn(_core.remark_on_correlations([("data", facts["correlated"])]), stacklevel=2)
    facts["candidates"] = tuple(facts["candidates"])
    if "slopes" in facts:
        facts["slopes"] = Smoothed(x=facts["x"], scheme=facts["scheme"], **facts["slopes"])
    return Smoothed(**facts)
