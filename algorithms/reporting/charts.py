"""Bars, histograms and curves for reports."""

import math
from collections.abc import Mapping, Sequence
from typing import Optional

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from .figures import AXIS, COLOURS, LETTER, LINE, RED, TEXT, WIDTH, canvas, plain, svg

LEFT, RIGHT, TOP = 52.0, 8.0, 26.0
"""Margins of the axes, in pixels."""

BELOW_NUMBERS = 38.0
"""Margin under an axis of numbers and its name."""

DASHES = (0, (5, 3))

LONGEST_LABEL = 14
"""Letters of an upright label; more are cut."""


def bar_chart(
    labels: Sequence[str],
    series: Mapping[str, Sequence[float]],
    unit: str,
    limit: Optional[float] = None,
    marked: Sequence[bool] = (),
    height: float = 204.0,
) -> str:
    """Return bars side by side for every label.

    Parameters
    ----------
    labels : sequence of str, length n
    series : mapping of str to sequence of float, length n
        Values by what the legend calls them; nan draws nothing.
    unit : str
        Of the values.
    limit : float, optional
        Longest bar; a longer one is cut, and its value written at its end.
    marked : sequence of bool, length n, optional
        Labels that stand out.
    height : float
        Of the axes, in pixels.
    """
    pitch = (WIDTH - LEFT - RIGHT) / max(len(labels), 1)
    longest = LETTER * max(map(len, labels), default=0)
    upright = longest > pitch
    below = min(longest, LETTER * LONGEST_LABEL) + 10 if upright else 24.0
    with canvas(TOP + height + below) as figure:
        axes = _axes(figure, TOP, below, unit)
        width = 0.76 / len(series)
        for place, ((name, values), colour) in enumerate(zip(series.items(), COLOURS)):
            positions = np.arange(len(labels)) + (place - (len(series) - 1) / 2) * width
            shown = _cut(axes, positions, np.asarray(values, dtype=float), limit)
            axes.add_patch(PathPatch(_bars(positions, shown, width), color=colour, label=name, linewidth=0))
        axes.autoscale_view()
        axes.axhline(0.0, color=AXIS, linewidth=1.0)
        axes.set_xlim(-0.5, max(len(labels), 1) - 0.5)
        _add_labels(axes, labels, upright, marked, max(1, math.ceil((LINE if upright else 1.0) / pitch)))
        if len(series) > 1:
            _add_legend(axes)
        return svg(figure)


def histogram(values: Sequence[float], unit: str, bins: int = 30, limits: Sequence[float] = ()) -> str:
    """Return the distribution of values.

    Parameters
    ----------
    values : sequence of float
        Those that are nan are left out.
    unit : str
        Name and unit of the values.
    bins : int
    limits : sequence of float
        Values that are marked by lines.
    """
    finite = np.asarray(values, dtype=float)
    finite = finite[np.isfinite(finite)]
    with canvas(188.0 + 12.0 + BELOW_NUMBERS) as figure:
        axes = _axes(figure, 12.0, BELOW_NUMBERS, "count")
        _counts, edges, _bars = axes.hist(finite, bins=bins, color=COLOURS[0], edgecolor="white")
        axes.axhline(0.0, color=AXIS, linewidth=1.0)
        axes.set_xlim(edges[0], edges[-1])
        axes.yaxis.get_major_locator().set_params(integer=True)
        _add_limits(axes, [limit for limit in limits if edges[0] <= limit <= edges[-1]])
        axes.set_xlabel(unit)
        return svg(figure)


def curve_chart(
    series: Mapping[str, tuple[Sequence[float], Sequence[float]]],
    across: str,
    upwards: str,
    limits: Sequence[float] = (),
) -> str:
    """Return curves over one axis.

    Parameters
    ----------
    series : mapping of str to (sequence of float, sequence of float)
        Values across, from 0, and upwards, by what the legend calls them.
    across, upwards : str
        Names and units of the axes.
    limits : sequence of float
        Values across that are marked by lines.
    """
    end = max(float(np.max(values)) for values, _ in series.values())
    with canvas(204.0 + TOP + BELOW_NUMBERS) as figure:
        axes = _axes(figure, TOP, BELOW_NUMBERS, upwards)
        for (name, values), colour in zip(series.items(), COLOURS):
            axes.plot(*values, color=colour, linewidth=2.0, label=name)
        axes.axhline(0.0, color=AXIS, linewidth=1.0, zorder=1.0)
        axes.set_xlim(0.0, end)
        _add_limits(axes, [limit for limit in limits if limit <= end])
        axes.set_xlabel(across)
        _add_legend(axes)
        return svg(figure)


def _axes(figure: Figure, top: float, bottom: float, unit: str) -> Axes:
    """Return axes with margins in pixels, a named vertical axis and round ticks."""
    height = 72 * figure.get_figheight()
    box = (LEFT / WIDTH, bottom / height, 1 - (LEFT + RIGHT) / WIDTH, 1 - (top + bottom) / height)
    axes = figure.add_axes(box, frameon=False)
    axes.locator_params(axis="y", nbins=8, steps=(1, 2, 5, 10))
    axes.set_ylabel(unit)
    axes.yaxis.set_label_coords(14 / WIDTH, box[1] + box[3] / 2, transform=figure.transFigure)
    return axes


def _bars(positions: np.ndarray, values: np.ndarray, width: float) -> Path:
    """Return the bars of a series as one path, which is drawn and written much faster than many."""
    drawn = np.isfinite(values)
    middles, values = positions[drawn], values[drawn]
    lefts, rights, zeros = middles - width / 2, middles + width / 2, np.zeros(len(values))
    corners = [(lefts, zeros), (lefts, values), (rights, values), (rights, zeros), (lefts, zeros)]
    codes = np.tile([Path.MOVETO, Path.LINETO, Path.LINETO, Path.LINETO, Path.CLOSEPOLY], len(values))
    return Path(np.moveaxis(np.array(corners), 2, 0).reshape(-1, 2), codes)


def _cut(axes: Axes, positions: np.ndarray, values: np.ndarray, limit: Optional[float]) -> np.ndarray:
    """Return the values within the limit, and write those that are beyond where their bars end."""
    if not limit:
        return values
    shown = np.clip(values, -limit, limit)
    for position, end, value in zip(positions, shown, values):
        if abs(value) > limit:
            up = value > 0
            axes.annotate(
                f"{value:.0f}",
                (position, end),
                xytext=(0, 2 if up else -2),
                textcoords="offset points",
                ha="center",
                va="bottom" if up else "top",
                color=RED,
            )
    return shown


def _add_labels(axes: Axes, labels: Sequence[str], upright: bool, marked: Sequence[bool], every: int) -> None:
    """Write the labels under the bars; where there is no room for all, only some of them."""
    style = {"rotation": 90, "ha": "right", "va": "center"} if upright else {"ha": "center", "va": "top"}
    axes.set_xticks([])
    for place in range(0, len(labels), every):
        axes.annotate(
            plain(_short(labels[place]) if upright else labels[place]),
            (place, 0),
            xycoords=("data", "axes fraction"),
            xytext=(0, -5),
            textcoords="offset points",
            rotation_mode="anchor",
            color=RED if place < len(marked) and marked[place] else TEXT,
            **style,
        )


def _add_limits(axes: Axes, limits: Sequence[float]) -> None:
    for limit in limits:
        axes.axvline(limit, color=RED, linewidth=1.0, linestyle=DASHES)


def _add_legend(axes: Axes) -> None:
    axes.legend(
        loc="lower left",
        bbox_to_anchor=(0.0, 1.0),
        ncol=len(COLOURS),
        borderpad=0.0,
        borderaxespad=0.6,
        handlelength=0.9,
        handleheight=0.9,
        handletextpad=0.4,
    )


def _short(label: str) -> str:
    cut = label[: LONGEST_LABEL - 1] + "\N{HORIZONTAL ELLIPSIS}"
    return label if len(label) <= LONGEST_LABEL else cut
