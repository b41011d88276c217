"""What mechanisms of plm give and tell."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping
from typing import Any, Dict, NamedTuple, Optional

import numpy as np
from numpy.typing import NDArray

from . import _show

Array = NDArray[np.float64]


class Quantity(NamedTuple):
    """A parameter, an input, a state, an output or a start value."""

    name: str
    #: Its unit here, SI.
    unit: str
    #: The unit of its declaration; a value in SI is one in that unit times `factor`.
    declared_unit: str
    factor: float
    docs: str
    #: As declared, SI; None for outputs, for a parameter that must be given, and for what is made of one.
    default: Optional[float]


class Pose(NamedTuple):
    """Pose and velocity of the centre of gravity of a body: m, rad, m/s, rad/s."""

    x: float
    y: float
    angle: float
    vx: float
    vy: float
    omega: float


class Event(NamedTuple):
    """Something has switched: a condition of the declaration, or a time that it names."""

    #: When, s.
    time: float
    #: The part to which the condition belongs.
    name: str


class Fault(Exception):
    """The mechanism cannot be assembled, or cannot go on."""

    __module__ = __name__.rpartition(".")[0]

    #: When, s.
    time: float
    #: The part that is to blame; empty where no single one is.
    part: str
    #: What a run has come to before.
    results: Optional[Results]

    def __init__(self, text: str, time: float, part: str) -> None:
        super().__init__(text, time, part)
        self.time, self.part, self.results = time, part, None

    def __str__(self) -> str:
        return str(self.args[0])


class Results(Dict[str, Array]):
    """Arrays by name: "time", and the quantities that were asked for."""

    #: The unit of each column, SI.
    units: dict[str, str]
    #: What has switched, in the order of time.
    events: tuple[Event, ...]
    #: Of each body where poses were asked for: rows of x, y, angle, vx, vy, omega of its centre of gravity; m, rad, m/s, rad/s.
    poses: dict[str, Array]
    #: Counters of the run, from its start on: `Mechanism.stats`.
    stats: dict[str, float]
    #: What should be known although the run went on: contact that could go on in several ways, steps that are too long.
    notices: tuple[str, ...]

    def __init__(
        self,
        columns: Mapping[str, Array],
        units: Mapping[str, str],
        events: Iterable[Event] = (),
        poses: Optional[Mapping[str, Array]] = None,
        stats: Optional[Mapping[str, float]] = None,
        notices: Iterable[str] = (),
    ) -> None:
        super().__init__(columns)
        self.units, self.events, self.poses, self.stats = dict(units), tuple(events), dict(poses or {}), dict(stats or {})
        self.notices = tuple(notices)

    def __missing__(self, name: object) -> Array:
        raise KeyError(unknown("column", name, self))

    def plot(self, *names: str, axes: Optional[Any] = None) -> Any:
        """Draws columns over the time with matplotlib, all of them if none is named.

        There is a diagram for each unit, or `axes` of your own with all curves; grey lines are events. Gives the axes.
        """
        columns = {name: self[name] for name in names or [name for name in self if name != "time"]}
        return _show.plot(self["time"], columns, self.units, self.events, axes)

    def _repr_html_(self) -> str:
        rows = [(name, self.units[name], *_range(column)) for name, column in self.items()]
        count = self["time"].size
        title = f"{count} row{'s' * (count != 1)}, {len(self.events)} event{'s' * (len(self.events) != 1)}"
        title = "; ".join((title, *self.notices))
        return _show.table(title, ("", "unit", "from", "to", "least", "greatest"), rows)


class Linearisation(NamedTuple):
    """x' = A x + B u, y = C x + D u for small changes; SI.

    The state x is counted along the columns of `basis`, in coordinates, velocities and first-order states.
    """

    A: Array
    B: Array
    C: Array
    D: Array
    basis: Array
    #: Names of the columns of B and D.
    inputs: tuple[str, ...]
    #: Names of the rows of C and D.
    outputs: tuple[str, ...]
    #: Names of the rows of A and B and of the columns of A, C and `basis`: those of `coordinates`, but for directions that
    #: constraints leave, which are numbered.
    states: tuple[str, ...]
    #: Names of the rows of `basis`.
    coordinates: tuple[str, ...]

    def _named(self) -> tuple[_show.Named, ...]:
        states, rates = self.states, _rates(self.states)
        return (
            ("A", self.A, rates, states),
            ("B", self.B, rates, self.inputs),
            ("C", self.C, self.outputs, states),
            ("D", self.D, self.outputs, self.inputs),
        )

    def __str__(self) -> str:
        return _show.lines(self._named())

    def _repr_html_(self) -> str:
        return _show.matrices(self._named())


class Jacobian(NamedTuple):
    """Derivatives of the rates of all states, and of outputs, by states and inputs; SI."""

    rates_by_states: Array
    rates_by_inputs: Array
    outputs_by_states: Array
    outputs_by_inputs: Array
    #: Names of the states, and of their rates in the same order.
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]

    def _named(self) -> tuple[_show.Named, ...]:
        states, rates = self.states, _rates(self.states)
        return (
            ("rates by states", self.rates_by_states, rates, states),
            ("rates by inputs", self.rates_by_inputs, rates, self.inputs),
            ("outputs by states", self.outputs_by_states, self.outputs, states),
            ("outputs by inputs", self.outputs_by_inputs, self.outputs, self.inputs),
        )

    def __str__(self) -> str:
        return _show.lines(self._named())

    def _repr_html_(self) -> str:
        return _show.matrices(self._named())


class Tables(NamedTuple):
    """What a mechanism has, in the order of its declaration."""

    parameters: tuple[Quantity, ...]
    inputs: tuple[Quantity, ...]
    states: tuple[Quantity, ...]
    outputs: tuple[Quantity, ...]
    starts: tuple[Quantity, ...]
    bodies: tuple[str, ...]
    #: The outputs that were declared, in their units; the others are observed.
    declared: tuple[Quantity, ...]
    #: Rows of contact.
    contacts: tuple[str, ...] = ()


def unknown(what: str, name: object, known: Iterable[str]) -> str:
    near = difflib.get_close_matches(str(name), list(known), 3, 0.7)
    hint = "; did you mean " + " or ".join(map(repr, near)) + "?" if near else ""
    return f"there is no {what} {name!r}{hint}"


def _rates(states: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(f"({name})'" for name in states)


def _range(column: Array) -> tuple[float, ...]:
    if not column.size:
        return ()
    return float(column[0]), float(column[-1]), float(column.min()), float(column.max())
