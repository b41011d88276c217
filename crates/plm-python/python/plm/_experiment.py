"""What is to be found, and the measurements that tell it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, NamedTuple, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from ._mechanism import PARAMETER, START
from ._rollouts import si
from ._values import Quantity, unknown

# A value in SI, or a text with its unit.
Value = Union[float, str]


class Unknown(NamedTuple):
    """A parameter or a start value that is to be found, with what is known of it. Values are in SI, or texts with a unit."""

    #: Where the search begins; at the declared value if nothing is said.
    guess: Optional[Value] = None
    least: Optional[Value] = None
    most: Optional[Value] = None
    #: What is known beforehand: a value and its standard deviation.
    expected: Optional[Tuple[Value, Value]] = None
    #: The typical size, for what is near zero.
    size: Optional[Value] = None


# What is to be found: names, or names with a guess or what else is known.
Unknowns = Union[Iterable[str], Mapping[str, Union[Unknown, Value, None]]]
# A constant, or times (s) with values; each holds from its time to the next.
Signal = Union[Value, Tuple[ArrayLike, ArrayLike]]


class Experiment:
    """Readings of one run: arrays over its times, or the table of a file. Everything is in SI, but for a table, which names its units."""

    __module__ = "plm"

    def __init__(
        self,
        times: ArrayLike,
        measured: Mapping[str, ArrayLike],
        *,
        deviations: Optional[Mapping[str, Value]] = None,
        inputs: Optional[Mapping[str, Signal]] = None,
        parameters: Optional[Mapping[str, Value]] = None,
        start: Optional[Mapping[str, Value]] = None,
        find: Unknowns = (),
        segments: int = 1,
    ) -> None:
        """Readings of outputs at times, s, from 0 on; NaN where there is none.

        `deviations` are the standard deviations of single readings; without them residuals tell them. `parameters` and `start` are those
        of this experiment alone, and so are the unknowns in `find`. A long or unstable run is shot in several `segments`.
        """
        self.csv: Optional[tuple[str, list[str]]] = None
        self.times: list[float] = _column("times", times)
        self.measured = {name: _column(name, values) for name, values in measured.items()}
        self.deviations, self.inputs = dict(deviations or {}), dict(inputs or {})
        self.parameters, self.start = dict(parameters or {}), dict(start or {})
        self.find, self.segments = find, segments

    @classmethod
    def from_csv(cls, path: Union[str, Path], only: Iterable[str] = (), **given: Any) -> Experiment:
        """Readings of a file: times, outputs and inputs with their units in its first line, as in `time (s),bob.angle (deg)`.

        `only` names the columns that are read, all of them if nothing is said; the rest is that of an experiment of arrays.
        """
        own = cls([], {}, **given)
        own.csv = str(path), [only] if isinstance(only, str) else list(only)
        return own


class Given(NamedTuple):
    """An experiment in SI, as native code has it."""

    csv: Optional[tuple[str, list[str]]]
    times: list[float]
    measured: list[tuple[str, list[float]]]
    deviations: list[tuple[str, float]]
    inputs: list[tuple[str, list[float], list[float]]]
    parameters: list[tuple[str, float]]
    start: list[tuple[str, float]]
    find: list[Wanted]
    segments: int


class Wanted(NamedTuple):
    """An unknown in SI, as native code has it."""

    kind: int
    name: str
    guess: Optional[float]
    bounds: tuple[float, float]
    expected: Optional[tuple[float, float]]
    size: Optional[float]


class Rows(NamedTuple):
    """The numbers of a mechanism by name."""

    parameters: Mapping[str, Quantity]
    inputs: Mapping[str, Quantity]
    outputs: Mapping[str, Quantity]
    starts: Mapping[str, Quantity]

    def values(self, what: str, rows: Mapping[str, Quantity], given: Mapping[str, Value]) -> list[tuple[str, float]]:
        return [(name, si(what, rows, name, value)) for name, value in given.items()]

    def wanted(self, unknowns: Unknowns) -> list[Wanted]:
        """Unknowns in SI."""
        if isinstance(unknowns, str):
            unknowns = [unknowns]
        known = unknowns if isinstance(unknowns, Mapping) else dict.fromkeys(unknowns)
        return [self._wanted(name, own if isinstance(own, Unknown) else Unknown(own)) for name, own in known.items()]

    def _wanted(self, name: str, own: Unknown) -> Wanted:
        kind, rows = (PARAMETER, self.parameters) if name in self.parameters else (START, self.starts)
        if name not in rows:
            raise KeyError(unknown("parameter or start value", name, [*self.parameters, *self.starts]))

        def value(given: Optional[Value]) -> Optional[float]:
            return None if given is None else si("unknown", rows, name, given)

        least, most = value(own.least), value(own.most)
        expected = None
        if own.expected is not None:
            mean, deviation = own.expected
            expected = si("unknown", rows, name, mean), si("unknown", rows, name, deviation)
        bounds = -np.inf if least is None else least, np.inf if most is None else most
        return Wanted(kind, name, value(own.guess), bounds, expected, value(own.size))

    def given(self, own: Experiment, inputs: Mapping[str, Value]) -> Given:
        """An experiment in SI, with inputs that all have in common."""
        for name in own.measured:
            if name not in self.outputs and name not in self.inputs:
                raise KeyError(unknown("output or input", name, [*self.outputs, *self.inputs]))
        readings = {**self.outputs, **self.inputs}
        signals: dict[str, Signal] = {**inputs, **own.inputs}
        return Given(
            own.csv,
            own.times,
            list(own.measured.items()),
            self.values("output", readings, own.deviations),
            [(name, *self._signal(name, signal)) for name, signal in signals.items()],
            self.values("parameter", self.parameters, own.parameters),
            self.values("start value", self.starts, own.start),
            self.wanted(own.find),
            own.segments,
        )

    def _signal(self, name: str, signal: Signal) -> tuple[list[float], list[float]]:
        if isinstance(signal, tuple):
            if name not in self.inputs:
                raise KeyError(unknown("input", name, self.inputs))
            times, values = signal
            return _column(f"times of {name}", times), _column(name, values)
        return [0.0], [si("input", self.inputs, name, signal)]


def _column(name: str, values: ArrayLike) -> list[float]:
    array = np.asarray(values, dtype=float)
    if array.ndim != 1:
        raise ValueError(f"{name} must be a row of numbers, not of the shape {array.shape}")
    return [float(value) for value in array]

