"""Derivatives of a run."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Dict, Optional

import numpy as np

from . import _native
from ._values import Array, Results, unknown


class Gradient(Dict[str, Dict[str, Array]]):
    """Of each output its derivatives over the time, by name: `gradient["bob.angle"]["length"]`; SI."""

    __module__ = "plm"

    #: The outputs themselves, and "time"; they have the bits of `Mechanism.run`.
    results: Results

    def __init__(self, derivatives: Mapping[str, Dict[str, Array]], results: Results) -> None:
        super().__init__(derivatives)
        self.results = results

    def __missing__(self, name: object) -> Dict[str, Array]:
        raise KeyError(unknown("output", name, self))


def gradient(
    text: _native.Text,
    method: tuple[str, Optional[float], Optional[float]],
    numbers: tuple[list[tuple[int, float]], list[tuple[int, float]], list[tuple[int, float]]],
    times: tuple[float, float, float],
    outputs: Mapping[str, tuple[int, str]],
    by: Mapping[str, tuple[int, int]],
) -> Gradient:
    """Outputs, by their numbers and with their units, and their derivatives by numbers of a kind."""
    if not by:
        raise ValueError("a gradient is by one name at least")
    derivatives: dict[str, dict[str, Array]] = {name: {} for name in outputs}
    columns: dict[str, Array] = {}
    for variable, of in by.items():
        found = _native.gradient(text, method, numbers, times, [number for number, _ in outputs.values()], of)
        time, values, slopes = found
        columns = {"time": np.frombuffer(time), **dict(zip(outputs, map(np.frombuffer, values)))}
        for name, slope in zip(outputs, slopes):
            derivatives[name][variable] = np.frombuffer(slope)
    return Gradient(derivatives, Results(columns, {"time": "s", **{name: unit for name, (_, unit) in outputs.items()}}))
