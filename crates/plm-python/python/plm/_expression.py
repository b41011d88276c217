"""Expressions of the language, as the builder writes them."""

from __future__ import annotations

import math
from typing import Any, Tuple, Union


class Expression:
    """Words of a declaration: a name, a member of it (`crank.angle`), or what operators make of them.

    A number beside it has no unit; a text is taken as it stands: `length + "20 cm"`.
    """

    __module__ = "plm"
    __slots__ = ("_words", "_binds")

    def __init__(self, words: str, binds: int = 3) -> None:
        # How tightly it binds: sums 0, products 1, powers 2, names and calls 3.
        self._words, self._binds = words, binds

    def __str__(self) -> str:
        return self._words

    def __repr__(self) -> str:
        return f"<plm.Expression {self._words}>"

    def __getattr__(self, name: str) -> Expression:
        if name.startswith("__"):
            raise AttributeError(name)
        return Expression(f"{self._inside(3)}.{name}")

    def _inside(self, binds: int) -> str:
        return self._words if self._binds >= binds else f"({self._words})"

    def __add__(self, other: Value) -> Expression:
        return _joined(self, " + ", other, 0)

    def __radd__(self, other: Value) -> Expression:
        return _joined(other, " + ", self, 0)

    def __sub__(self, other: Value) -> Expression:
        return _joined(self, " - ", other, 0)

    def __rsub__(self, other: Value) -> Expression:
        return _joined(other, " - ", self, 0)

    def __mul__(self, other: Value) -> Expression:
        return _joined(self, "*", other, 1)

    def __rmul__(self, other: Value) -> Expression:
        return _joined(other, "*", self, 1)

    def __truediv__(self, other: Value) -> Expression:
        return _joined(self, "/", other, 1)

    def __rtruediv__(self, other: Value) -> Expression:
        return _joined(other, "/", self, 1)

    def __pow__(self, power: int) -> Expression:
        return Expression(f"{self._inside(3)}^{number(power)}", 2)

    def __neg__(self) -> Expression:
        return Expression(f"-{self._inside(1)}", 0)


# A number in SI, words of the language with units, or an expression.
Value = Union[float, str, Expression]
Pair = Tuple[Value, Value]


def number(value: Any) -> str:
    """A finite number as the language has it."""
    if isinstance(value, bool) or not math.isfinite(value):
        raise ValueError(f"a finite number is wanted, not {value!r}")
    text = repr(value if isinstance(value, int) else float(value))
    return text[:-2] if text.endswith(".0") else text


def words(value: Any, unit: str = "") -> str:
    """A value, a number in this unit."""
    if isinstance(value, (str, Expression)):
        return str(value)
    if isinstance(value, (tuple, list)):
        return pair(value, unit)
    return f"{number(value)} {unit}".rstrip()


def pair(values: Any, unit: str) -> str:
    """A vector: numbers in this unit."""
    if any(isinstance(value, (str, Expression)) for value in values):
        return f"({', '.join(words(value, unit) for value in values)})"
    return f"({', '.join(map(number, values))}) {unit}".rstrip()


def pairs(points: Any, unit: str) -> str:
    """A list of points; the last unit is that of all."""
    listed = [tuple(point) for point in points]
    if any(isinstance(value, (str, Expression)) for point in listed for value in point):
        return ", ".join(pair(point, unit) for point in listed)
    return f"{', '.join(pair(point, '') for point in listed)} {unit}".rstrip()


def _joined(a: Value, sign: str, b: Value, binds: int) -> Expression:
    left, right = _expression(a), _expression(b)
    # To the right of a minus or a stroke what binds as loosely stands in brackets.
    return Expression(left._inside(binds) + sign + right._inside(binds + (sign in (" - ", "/"))), binds)


def _expression(value: Value) -> Expression:
    # Nobody looks into a text: it may be a sum.
    return value if isinstance(value, Expression) else Expression(words(value), 0 if isinstance(value, str) else 3)
