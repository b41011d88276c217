"""Tables for notebooks, and curves."""

from __future__ import annotations

import html
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Optional, Tuple


def table(title: str, heads: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """A table in HTML; numbers have six digits."""
    head = "".join(f"<th>{_cell(cell)}</th>" for cell in heads)
    body = "".join("<tr>" + "".join(f"<td>{_cell(cell)}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<table><caption>{_cell(title)}</caption><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


# A matrix with its title, and the names of its rows and columns.
Named = Tuple[str, Any, Tuple[str, ...], Tuple[str, ...]]


def matrices(named: Iterable[Named]) -> str:
    """Matrices in HTML; none that is empty."""
    return "".join(
        table(title, ("", *columns), [(name, *map(float, row)) for name, row in zip(rows, matrix)])
        for title, matrix, rows, columns in named
        if matrix.size
    )


def lines(named: Iterable[Named]) -> str:
    """The same in lines of text."""
    texts = []
    for title, matrix, rows, columns in named:
        if matrix.size:
            cells = [(title, *columns), *((name, *map(_text, map(float, row))) for name, row in zip(rows, matrix))]
            widths = [max(map(len, column)) for column in zip(*cells)]
            rest = [[cell.rjust(width) for cell, width in zip(row[1:], widths[1:])] for row in cells]
            texts.append("\n".join("  ".join((row[0].ljust(widths[0]), *cell)) for row, cell in zip(cells, rest)))
    return "\n\n".join(texts)


def _text(cell: object) -> str:
    return f"{cell:.6g}" if isinstance(cell, float) else str(cell)


def _cell(cell: object) -> str:
    return html.escape(_text(cell))


def plot(
    time: Any, columns: Mapping[str, Any], units: Mapping[str, str], events: Iterable[Any], axes: Optional[Any]
) -> Any:
    """Curves over the time."""
    try:
        import matplotlib.pyplot as plt
    except ImportError as error:
        raise ImportError("plot needs matplotlib, which cannot be imported: pip install matplotlib") from error
    names: dict[str, list[str]] = {}
    for name in columns:
        names.setdefault(units.get(name, "") if axes is None else "", []).append(name)
    if axes is None:
        size = (6.4, 1.2 + 2.4 * max(len(names), 1))
        _, own = plt.subplots(max(len(names), 1), sharex=True, squeeze=False, figsize=size, layout="constrained")
        drawn = list(own[:, 0])
    else:
        drawn = [axes]
    for on, (unit, group) in zip(drawn, names.items()):
        for name in group:
            on.plot(time, columns[name], label=name if axes is None else f"{name}, {units.get(name) or '1'}")
        for event in events:
            on.axvline(event.time, color="0.8", linewidth=0.8, zorder=0)
        if axes is None:
            on.set_ylabel(unit or "1")
        on.legend()
    drawn[-1].set_xlabel("time, s")
    return axes if axes is not None else drawn
