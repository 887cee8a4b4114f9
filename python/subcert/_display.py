"""Pictures and tables for notebooks."""

from __future__ import annotations

import html
from typing import Any

from ._errors import Error

_WIDTH, _HEIGHT, _MARGIN = 420, 180, 14


def curve_svg(x: Any, y: Any) -> str:
    """A polygon through the points, with the axis y = 0, as a picture of its own."""
    low, high = min(0.0, min(y)), max(y)
    left, right = x[0], x[-1]
    scale_x = (_WIDTH - 2 * _MARGIN) / ((right - left) or 1)
    scale_y = (_HEIGHT - 2 * _MARGIN) / ((high - low) or 1)

    def place(u: float, v: float) -> str:
        return f"{_MARGIN + (u - left) * scale_x:.2f},{_HEIGHT - _MARGIN - (v - low) * scale_y:.2f}"

    points = " ".join(place(u, v) for u, v in zip(x, y))
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH}" height="{_HEIGHT}" role="img">'
        f'<polyline points="{place(left, 0)} {place(right, 0)}" stroke="#888" stroke-width="1" fill="none"/>'
        f'<polyline points="{points}" stroke="#0b559f" stroke-width="1.5" fill="none"/></svg>'
    )


def scheme_html(scheme: Any) -> str:
    head = f"<b>{html.escape(scheme.specification)}</b> {html.escape(scheme.title)}"
    numbers = ", ".join(str(c) for c in scheme.mask)
    text = f"{head}<br/>mask [{numbers}] from index {scheme.first_index}, arity {scheme.arity}"
    try:
        x, y = scheme.limit(5)
    except Error as error:
        return f"{text}<br/>{html.escape(str(error))}"
    return f"{text}<br/>{curve_svg([float(u) for u in x], [float(v) for v in y])}"


def surface_html(scheme: Any) -> str:
    head = f"<b>{html.escape(scheme.specification)}</b> {html.escape(scheme.title)}"
    if scheme.dimension != 2:
        return head
    rows = sorted({j for _, j in scheme.mask}, reverse=True)
    columns = sorted({i for i, _ in scheme.mask})
    cells = "".join(
        "<tr>" + "".join(f"<td>{scheme.mask.get((i, j), '')}</td>" for i in columns) + "</tr>" for j in rows
    )
    return f"{head}<table>{cells}</table>"
