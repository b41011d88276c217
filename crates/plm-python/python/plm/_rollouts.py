"""Many runs of a mechanism."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Dict, Optional, Union

import numpy as np

from . import _native
from ._checks import finite
from ._values import Array, Fault, Quantity, unknown


class Rollouts(Dict[str, Array]):
    """Arrays by name: "time", and of each quantity a row for each run. After the end of a run that ended early there are NaN."""

    __module__ = "plm"

    #: The unit of each quantity, SI.
    units: dict[str, str]
    #: Of each body where poses were asked for: of each run and time x, y, angle, vx, vy, omega; m, rad, m/s, rad/s.
    poses: dict[str, Array]
    #: What ended runs early, by their numbers.
    faults: dict[int, Fault]

    def __init__(
        self,
        columns: Mapping[str, Array],
        units: Mapping[str, str],
        poses: Mapping[str, Array],
        faults: Mapping[int, Fault],
    ) -> None:
        super().__init__(columns)
        self.units, self.poses, self.faults = dict(units), dict(poses), dict(faults)

    def __missing__(self, name: object) -> Array:
        raise KeyError(unknown("column", name, self))


def rollouts(
    text: _native.Text,
    by: tuple[str, Optional[float], Optional[float]],
    varied: Any,
    times: tuple[float, float, float],
    quantities: Mapping[str, tuple[tuple[int, int], str]],
    bodies: tuple[str, ...],
    threads: Optional[int],
) -> Rollouts:
    """Runs a mechanism for each element of arrays: of parameters, starts and inputs, each with all that there are."""
    count = _count({name: array for _, given in varied for name, array in given.items()})
    threads = None if threads is None else _threads(threads)
    values: Any = [
        [(list(rows).index(name), np.broadcast_to(array, (count,)).tolist()) for name, array in given.items()]
        for rows, given in varied
    ]
    numbers = [number for number, _ in quantities.values()]
    samples, width, time, table, faults = _native.rollouts(
        text, count, by, tuple(values), times, numbers, bool(bodies), threads
    )
    array = np.frombuffer(table, dtype=np.float64).reshape(count, samples, width)
    return Rollouts(
        {
            "time": np.frombuffer(time, dtype=np.float64),
            **{name: np.ascontiguousarray(array[:, :, k]) for k, name in enumerate(quantities)},
        },
        {"time": "s", **{name: unit for name, (_, unit) in quantities.items()}},
        {name: np.ascontiguousarray(array[:, :, at : at + 6]) for name, at in zip(bodies, range(len(numbers), width, 6))},
        dict(faults),
    )


def si(what: str, rows: Mapping[str, Quantity], name: str, value: Union[float, str]) -> float:
    """A value in SI."""
    if name not in rows:
        raise KeyError(unknown(what, name, rows))
    if isinstance(value, str):
        try:
            return _native.value(value, rows[name].unit)
        except ValueError as error:
            raise ValueError(f"{name}: {error}") from None
    return finite(name, value)


def columns(rows: Mapping[str, Quantity], matrix: Any) -> dict[str, Any]:
    """A matrix of parameters as columns by name."""
    table = np.asarray(matrix, dtype=float)
    if table.ndim != 2 or table.shape[1] != len(rows):
        raise ValueError(f"parameters must have {len(rows)} columns: {', '.join(rows)}; not the shape {table.shape}")
    return {name: table[:, k] for k, name in enumerate(rows)}


def arrays(what: str, rows: Mapping[str, Quantity], given: Mapping[str, Any]) -> dict[str, Any]:
    """Values in SI by name, of all runs or of each."""
    return {name: _array(what, rows, name, values) for name, values in given.items()}


def _array(what: str, rows: Mapping[str, Quantity], name: str, values: Any) -> Any:
    if name not in rows:
        raise KeyError(unknown(what, name, rows))
    if isinstance(values, str):
        values = [values]
    if isinstance(values, Sequence):
        values = [si(what, rows, name, value) for value in values]
    array = np.atleast_1d(np.asarray(values, dtype=float))
    if array.ndim != 1:
        raise ValueError(f"{name} must have a value for each run, not the shape {array.shape}")
    if not np.all(np.isfinite(array)):
        raise ValueError(f"{name} must be finite numbers")
    return array


def _threads(threads: int) -> int:
    """A number of threads, at least one."""
    if not isinstance(threads, (int, np.integer)) or isinstance(threads, bool):
        raise TypeError(f"threads must be a whole number, not {threads!r}")
    if threads < 1:
        raise ValueError(f"threads must be at least 1: {threads}")
    return int(threads)


def _count(given: Mapping[str, Any]) -> int:
    """The number of runs."""
    empty = [name for name, array in given.items() if array.size == 0]
    if empty:
        raise ValueError(f"{', '.join(empty)} must have a value for each run, and has none")
    sizes = {name: array.size for name, array in given.items() if array.size != 1}
    if len(set(sizes.values())) > 1:
        raise ValueError(f"arrays have several lengths: {', '.join(f'{name} {size}' for name, size in sizes.items())}")
    return next(iter(sizes.values()), 1)
