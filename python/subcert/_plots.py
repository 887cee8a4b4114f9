"""Pictures by matplotlib, which is imported when one is drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._errors import UsageError

if TYPE_CHECKING:
    from ._families import ExponentCurve, PropertyRange
    from ._vertices import WeightMap, WeightRange

_COLOURS = {"yes": "#7fbf7b", "no": "#e0a3a0", "unknown": "#d0d0d0"}


def axes(ax: Any, **projection: Any) -> Any:
    """Those given, or new ones."""
    if ax is not None:
        if not hasattr(ax, "plot"):
            raise TypeError(f"ax: expected axes of matplotlib, got {ax!r}; .plot().figure.savefig(name) writes a file")
        return ax
    try:
        from matplotlib import pyplot  # type: ignore[import]
    except ImportError:
        raise ImportError("plot: needs matplotlib (Debian: python3-matplotlib; pip install matplotlib)") from None
    return pyplot.figure().add_subplot(**projection)


def line(ax: Any, x: Any, y: Any, label: str, title: str) -> Any:
    ax = axes(ax)
    ax.plot([float(u) for u in x], [float(v) for v in y], label=label)
    ax.axhline(0, color="#888", linewidth=0.5)
    ax.set_title(title)
    return ax


def surface(ax: Any, points: Any, values: Any, title: str) -> Any:
    ax = axes(ax, projection="3d")
    ax.plot_trisurf(points[:, 0], points[:, 1], values, linewidth=0.1)
    ax.set_title(title)
    return ax


def envelope(ax: Any, curve: ExponentCurve, parameter: str) -> Any:
    """Between the proved ends of each piece; nothing is drawn where one is absent."""
    ax = axes(ax)
    for piece in curve.pieces:
        if piece.exponent.is_bounded:
            low, high = float(piece.exponent.lower or 0), float(piece.exponent.upper or 0)
            x = [float(piece.low), float(piece.high)]
            ax.fill_between(x, [low, low], [high, high], color="#0b559f", linewidth=0.8)
    ax.set_xlabel(parameter)
    ax.set_ylabel("Hölder exponent")
    return ax


def pieces(ax: Any, found: PropertyRange | WeightRange, parameter: str) -> Any:
    """A bar for each piece: proved, refuted, not decided."""
    ax = axes(ax)
    seen = set()
    for piece in found.pieces:
        verdict = piece.holds.value
        label = {"yes": "proved", "no": "refuted", "unknown": "undecided"}[verdict] if verdict not in seen else None
        seen.add(verdict)
        left, width = float(piece.low), float(piece.high - piece.low)
        ax.barh(0, width, left=left, color=_COLOURS[verdict], label=label)
        if width == 0:
            ax.plot([left], [0], "|", color=_COLOURS[verdict], markersize=20)
    ax.set_yticks([])
    ax.set_xlabel(parameter)
    ax.legend()
    return ax


def cells(ax: Any, found: WeightMap) -> Any:
    """A rectangle for each cell: proved, refuted, not decided."""
    if len(found.parameters) != 2:
        raise UsageError(f"plot: pictures are of two parameters; got {len(found.parameters)}")
    ax = axes(ax)
    for cell in found.cells:
        (left, low), (right, high) = ([float(value) for value in corner] for corner in (cell.low, cell.high))
        ax.fill_between([left, right], [low, low], [high, high], color=_COLOURS[cell.holds.value], linewidth=0)
    ax.set_xlabel(found.parameters[0])
    ax.set_ylabel(found.parameters[1])
    return ax


def heights(ax: Any, places: Any, values: Any, title: str) -> Any:
    if values.ndim != 2:
        raise UsageError(f"plot: pictures are of curves and heights; got a volume of {values.shape}")
    ax = axes(ax)
    ax.pcolormesh(places[1], places[0], values, shading="nearest")
    ax.set_title(title)
    return ax


def bands(ax: Any, x: Any, values: Any, lower: Any, upper: Any, title: str) -> Any:
    ax = axes(ax)
    ax.plot(x, values)
    if lower is not None:
        ax.fill_between(x, lower, upper, alpha=0.3)
    ax.set_title(title)
    return ax
