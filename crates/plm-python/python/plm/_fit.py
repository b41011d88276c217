"""What was found from measurements."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple, Optional, Union

import numpy as np

from . import _native
from ._checks import matrix
from ._experiment import Experiment, Rows, Unknowns, Value
from ._mechanism import PARAMETER
from ._sim import Show
from ._values import Array, unknown


class Estimate(NamedTuple):
    """What was found of an unknown, SI."""

    name: str
    #: The experiment that it belongs to, from 0; None where all have it in common.
    experiment: Optional[int]
    value: float
    #: Infinite where no reading tells it, zero at a bound.
    standard_error: float
    #: The bound that it stands at, if it does.
    bound: Optional[float]


class Residuals(NamedTuple):
    """Readings of one output in one experiment, and what the model has in their place; in the unit that they were given in."""

    experiment: int
    output: str
    unit: str
    times: Array
    readings: Array
    model: Array


class NotConverged(Exception):
    """A search has ended away from a minimum."""

    __module__ = "plm"

    #: Where it has ended, by name, SI.
    best: dict[str, float]

    def __init__(self, text: str, best: Iterable[tuple[str, float]]) -> None:
        super().__init__(text, best)
        self.best = dict(best)

    def __str__(self) -> str:
        return str(self.args[0])


class Fit(Mapping[str, float]):
    """What an identification has found: `fit["stiffness"]` in SI, its errors, its residuals. Printed it is a table."""

    __module__ = "plm"

    #: All estimates: those that experiments have in common, then those of each.
    estimates: tuple[Estimate, ...]
    #: Of the estimates, SI; infinite on the diagonal where no reading tells, zero at a bound.
    covariance: Array
    correlation: Array
    #: Combinations along which no reading changes: by how much each changes, SI.
    undetermined: tuple[dict[str, float], ...]
    residuals: tuple[Residuals, ...]
    #: Sum of squares of the residuals, each over its deviation, and the number of readings less that of unknowns.
    chi_squared: float
    freedoms: int
    iterations: int
    runs: int

    def __init__(self, native: _native.Fit, parameters: Iterable[str], source: tuple[str, str]) -> None:
        self._native, self._parameters, self._source = native, set(parameters), source
        self.estimates = tuple(Estimate(*row) for row in native.estimates())
        self.covariance, self.correlation = (matrix(*rows) for rows in native.matrices())
        self.undetermined = tuple(map(dict, native.undetermined()))
        self.residuals = tuple(Residuals(*row[:3], *map(np.frombuffer, row[3])) for row in native.residuals())
        self.chi_squared, self.freedoms, self.iterations, self.runs = native.statistics()

    def estimate(self, name: str, experiment: Optional[int] = None) -> Estimate:
        """The estimate of a name, of one experiment if that is said."""
        for own in self.estimates:
            if own.name == name and (experiment is None or own.experiment == experiment):
                return own
        raise KeyError(unknown("unknown", name, [own.name for own in self.estimates]))

    def __getitem__(self, name: str) -> float:
        return self.estimate(name).value

    def __iter__(self) -> Iterator[str]:
        return iter(dict.fromkeys(own.name for own in self.estimates))

    def __len__(self) -> int:
        return len({own.name for own in self.estimates})

    @property
    def parameters(self) -> dict[str, float]:
        """The parameters that experiments have in common, for `run` and its like."""
        return {own.name: own.value for own in self.estimates if own.experiment is None and own.name in self._parameters}

    @property
    def start(self) -> dict[str, float]:
        """The start values that experiments have in common."""
        return {own.name: own.value for own in self.estimates if own.experiment is None and own.name not in self._parameters}

    @property
    def text(self) -> str:
        """The declaration with the values that experiments have in common, comments and layout as they are.

        What stands nowhere in the text by itself, such as a value of a part, is a `ValueError`.
        """
        text, missing = self._native.declaration(*self._source)
        if missing:
            raise ValueError(f"{missing[0]!r} stands nowhere in the declaration by itself")
        return text

    def chart(self) -> str:
        """Readings, model and residuals as a picture, SVG."""
        return self._native.chart()

    def show(self) -> Show:
        """The page of the experiments with what was found, which moves, with readings and residuals beside its curves."""
        return Show(self._native.page())

    def __str__(self) -> str:
        return self._native.table().rstrip()

    def __repr__(self) -> str:
        found = ", ".join(f"{own.name}={own.value:g}" for own in self.estimates)
        return f"<plm.Fit: {found}>"

    def _repr_svg_(self) -> str:
        return self.chart()


def identify(
    text: _native.Text,
    method: tuple[str, Optional[float], Optional[float]],
    known: tuple[Mapping[str, Value], Mapping[str, Value], Mapping[str, Value]],
    find: Unknowns,
    experiments: Union[Experiment, Iterable[Experiment]],
    rows: Rows,
    iterations: int,
) -> _native.Fit:
    """Searches with parameters, inputs and start values that are known."""
    parameters, inputs, start = known
    wanted = rows.wanted(find)
    # A parameter without a default has its guess.
    guesses = {own.name: own.guess for own in wanted if own.kind == PARAMETER and own.guess is not None}
    numbers = [
        [(list(of).index(name), value) for name, value in rows.values(what, of, given)]
        for what, of, given in (
            ("parameter", rows.parameters, {**guesses, **parameters}),
            ("start value", rows.starts, start),
        )
    ]
    experiments = [experiments] if isinstance(experiments, Experiment) else experiments
    given = [rows.given(own, inputs) for own in experiments]
    return _native.identify(text, method, (numbers[0], numbers[1]), wanted, given, iterations)
