"""Bars, histograms and curves for reports."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Optional

import numpy as np

from .html import Markup, element, join, number
from .svg import COLOURS, LETTER, LINE, WIDTH, drawing, round_step, stroke, text


def bar_chart(
    labels: Sequence[str],
    series: dict,
    unit: str,
    limit: Optional[float] = None,
    marked: Sequence[bool] = (),
    height: float = 230.0,
) -> Markup:
    """Return bars side by side for every label.

    Parameters
    ----------
    labels : sequence of str, length n
    series : dict of str to sequence of float, length n
        Values by what the legend calls them; nan draws nothing.
    unit : str
        Of the values.
    limit : float, optional
        Where the axis ends, up and down; a longer bar is cut, and its value written there.
    marked : sequence of bool, length n, optional
        Labels that stand out.
    height : float
        Pixels.
    """
    values = np.array([list(row) for row in series.values()], dtype=float).reshape(len(series), len(labels))
    cut = np.clip(values, -limit, limit) if limit else values
    low, high = np.nanmin(cut, initial=0.0), np.nanmax(cut, initial=0.0)
    axes = _Axes.spanning(float(low), float(high), 26.0, height, unit)
    pitch = (axes.right - axes.left) / max(len(labels), 1)
    longest = LETTER * max(map(len, labels), default=0)
    upright = longest > pitch
    colours = COLOURS if len(series) > 1 else (COLOURS[0],)
    width = 0.76 * pitch / len(series)
    starts = axes.left + 0.12 * pitch + width * np.arange(len(series))
    return drawing(
        height + (min(longest, 90.0) + 14 if upright else 24.0),
        axes.frame(),
        *(
            element("path", d=_bars(axes, start, pitch, width, row), fill=colour)
            for start, row, colour in zip(starts, values, colours)
        ),
        _cut_values(axes, values, pitch),
        _labels(axes, labels, pitch, upright, marked),
        _legend(series) if len(series) > 1 else Markup(),
    )


def histogram(values: Sequence[float], unit: str, bins: int = 30, limits: Sequence[float] = ()) -> Markup:
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
    counts, edges = np.histogram(finite, bins=bins)
    axes = _Axes.spanning(0.0, float(max(counts.max(), 1)), 12.0, 200.0, "count")
    span = edges[-1] - edges[0]

    def across(value: float) -> float:
        return axes.left + (axes.right - axes.left) * (value - edges[0]) / span

    bars = "".join(
        f"M{across(left) + 0.5:.1f} {axes.at(0):.1f}V{axes.at(count):.1f}"
        f"H{across(right) - 0.5:.1f}V{axes.at(0):.1f}z"
        for left, right, count in zip(edges, edges[1:], counts)
        if count
    )
    lines = "".join(
        f"M{across(limit):.1f} {axes.top:.1f}V{axes.bottom:.1f}"
        for limit in limits
        if edges[0] <= limit <= edges[-1]
    )
    step = round_step(span / 5)
    ticks = step * np.arange(math.ceil(edges[0] / step - 1e-9), math.floor(edges[-1] / step + 1e-9) + 1)
    return drawing(
        axes.bottom + 38,
        axes.frame(),
        element("path", d=bars, fill=COLOURS[0]),
        element("path", d=lines, class_="limit"),
        *(text(across(tick), axes.bottom + 15, _tick(tick, step)) for tick in ticks),
        text((axes.left + axes.right) / 2, axes.bottom + 31, unit),
    )


def curve_chart(
    series: dict, across: str, upwards: str, limits: Sequence[float] = (), height: float = 230.0
) -> Markup:
    """Return curves over one axis.

    Parameters
    ----------
    series : dict of str to (sequence of float, sequence of float)
        Values across, from 0, and upwards, by what the legend calls them.
    across, upwards : str
        Names and units of the axes.
    limits : sequence of float
        Values across that are marked by lines.
    height : float
        Pixels.
    """
    end = max(float(np.max(values)) for values, _ in series.values())
    highest = max(float(np.max(values)) for _, values in series.values())
    axes = _Axes.spanning(0.0, highest, 26.0, height, upwards)

    def at(value: float) -> float:
        return axes.left + (axes.right - axes.left) * min(value / end, 1.0)

    curves = (
        "M" + "L".join(f"{at(x):.1f} {axes.at(y):.1f}" for x, y in zip(*values)) for values in series.values()
    )
    lines = "".join(f"M{at(limit):.1f} {axes.top:.1f}V{axes.bottom:.1f}" for limit in limits if limit <= end)
    step = round_step(end / 5)
    return drawing(
        axes.bottom + 38,
        axes.frame(),
        element("path", d=lines, class_="limit"),
        *(stroke(curve, colour, 2.0) for curve, colour in zip(curves, COLOURS)),
        *(
            text(at(tick), axes.bottom + 15, _tick(tick, step))
            for tick in step * np.arange(math.floor(end / step + 1e-9) + 1)
        ),
        text((axes.left + axes.right) / 2, axes.bottom + 31, across),
        _legend(series),
    )


@dataclass(frozen=True)
class _Axes:
    """A vertical axis with round ticks, and the box to its right."""

    low: float
    high: float
    step: float
    left: float
    right: float
    top: float
    bottom: float
    unit: str

    @classmethod
    def spanning(cls, low: float, high: float, top: float, bottom: float, unit: str) -> "_Axes":
        span = (high - low) or 1.0
        step = round_step(span / 4)
        low, high = step * math.floor(low / step + 1e-9), step * math.ceil(high / step - 1e-9)
        high = high if high > low else low + step
        return cls(low, high, step, 52.0, WIDTH - 8, top, bottom, unit)

    def at(self, value: float) -> float:
        """Return the pixel of a value; one beyond the axis is put at its end."""
        share = (min(max(value, self.low), self.high) - self.low) / (self.high - self.low)
        return self.bottom - share * (self.bottom - self.top)

    def frame(self) -> Markup:
        ticks = self.step * np.arange(round(self.low / self.step), round(self.high / self.step) + 1)
        grid = "".join(f"M{self.left:.1f} {self.at(tick):.1f}H{self.right:.1f}" for tick in ticks)
        texts = [text(self.left - 6, self.at(tick) + 4, _tick(tick, self.step), "end") for tick in ticks]
        return join(
            (
                element("path", d=grid, class_="grid"),
                element("path", d=f"M{self.left:.1f} {self.at(0.0):.1f}H{self.right:.1f}", class_="axis"),
                *texts,
                element(
                    "text",
                    self.unit,
                    transform=f"translate(12 {(self.top + self.bottom) / 2:.1f}) rotate(-90)",
                    class_="middle",
                ),
            )
        )


def _bars(axes: _Axes, start: float, pitch: float, width: float, values: np.ndarray) -> str:
    return "".join(
        f"M{start + place * pitch:.1f} {axes.at(0.0):.1f}V{axes.at(value):.1f}h{width:.1f}"
        f"V{axes.at(0.0):.1f}z"
        for place, value in enumerate(values)
        if math.isfinite(value) and value
    )


def _cut_values(axes: _Axes, values: np.ndarray, pitch: float) -> Markup:
    """Return the values of bars that were cut, at their ends."""
    rows, columns = np.nonzero((values > axes.high) | (values < axes.low))
    width = 0.76 * pitch / max(len(values), 1)
    return join(
        text(
            axes.left + pitch * (0.12 + column) + width * (row + 0.5),
            axes.top - 4 if values[row, column] > 0 else axes.bottom - 4,
            f"{values[row, column]:.0f}",
            "middle red",
        )
        for row, column in zip(rows, columns)
    )


def _labels(
    axes: _Axes, labels: Sequence[str], pitch: float, upright: bool, marked: Sequence[bool]
) -> Markup:
    """Return the labels under the bars; where they have no room, only some of them."""
    every = max(1, math.ceil((LINE if upright else 1.0) / pitch))
    texts = []
    for place in range(0, len(labels), every):
        x = axes.left + (place + 0.5) * pitch
        red = " red" if place < len(marked) and marked[place] else ""
        if upright:
            turn = f"translate({x + 4:.1f} {axes.bottom + 6:.1f}) rotate(-90)"
            texts.append(element("text", _short(labels[place]), transform=turn, class_=f"end{red}"))
        else:
            texts.append(text(x, axes.bottom + 16, labels[place], f"middle{red}"))
    return join(texts)


def _legend(series: dict) -> Markup:
    parts, x = [], 52.0
    for name, colour in zip(series, COLOURS):
        parts += [element("rect", x=f"{x:.1f}", y=4, width=10, height=10, fill=colour)]
        parts += [text(x + 14, 13, name, None)]
        x += 30 + LETTER * len(name)
    return join(parts)


def _tick(value: float, step: float) -> str:
    return number(value, max(0, -math.floor(math.log10(step) + 1e-9)))


def _short(label: str, letters: int = 14) -> str:
    return label if len(label) <= letters else label[: letters - 1] + "\N{HORIZONTAL ELLIPSIS}"
