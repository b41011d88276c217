"""What mechanisms of plm give and tell."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping
from typing import Dict, NamedTuple, Optional

import numpy as np
from numpy.typing import NDArray

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
    """Arrays by name: "time", and the outputs that were asked for; `units` has their units."""

    units: dict[str, str]

    def __init__(self, columns: Mapping[str, Array], units: Mapping[str, str]) -> None:
        super().__init__(columns)
        self.units = dict(units)

    def __missing__(self, name: object) -> Array:
        raise KeyError(unknown("column", name, self))


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


def unknown(what: str, name: object, known: Iterable[str]) -> str:
    near = difflib.get_close_matches(str(name), list(known), 3, 0.7)
    hint = "; is " + " or ".join(f"`{one}`" for one in near) + " meant?" if near else ""
    return f"there is no {what} `{name}`{hint}"
