"""Looks at what a caller gives, and a line of the progress."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import Any, Optional

import numpy as np

from ._values import Array, unknown


def finite(name: str, value: float) -> float:
    # What `float` would read of a text is no number that was meant.
    try:
        number = float("text" if isinstance(value, (str, bytes)) else value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a number, not {value!r}") from None
    if not np.isfinite(number):
        raise ValueError(f"{name} must be a finite number, not {value}")
    return number


def optional(name: str, value: Optional[float]) -> Optional[float]:
    return None if value is None else finite(name, value)


def text(name: str, value: str) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name} must be a name, not {value!r}")
    return value


def matrix(rows: int, numbers: bytearray) -> Array:
    array = np.frombuffer(numbers, dtype=np.float64)
    return array.reshape(rows, array.size // rows if rows else 0)


def chosen(what: str, wanted: Optional[Sequence[str]], known: list[str]) -> list[int]:
    for name in wanted or ():
        if name not in known:
            raise KeyError(unknown(what, name, known))
    return list(range(len(known))) if wanted is None else [known.index(name) for name in wanted]


class Line:
    """A line of the progress on stderr."""

    def __init__(self, begin: float, until: float) -> None:
        self.begin, self.until = begin, until

    def __call__(self, time: float) -> None:
        share = (time - self.begin) / (self.until - self.begin)
        bar = "#" * int(40 * share)
        print(f"\r[{bar:40}] {time:.4g} s of {self.until:g} s ", end="", file=sys.stderr, flush=True)

    def end(self) -> None:
        print("\r" + " " * 79, end="\r", file=sys.stderr, flush=True)
