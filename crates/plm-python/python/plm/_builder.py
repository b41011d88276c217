"""A builder that writes declarations."""

from __future__ import annotations

import inspect
import keyword
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from typing import Any, NamedTuple, Optional, Union

from . import _native
from ._declared import Mechanism
from ._expression import Expression, Pair, Value, pair, pairs, words
from ._values import unknown

# Units of what a body starts with.
_STARTS = {"x": "m", "y": "m", "angle": "rad", "vx": "m/s", "vy": "m/s", "omega": "rad/s"}
# Of its fields that are numbers.
_FIELDS = {"mass": "kg", "inertia": "kg*m^2", "density": "kg/m^3", "thickness": "m", "depth": "m", "drawing_angle": "rad"}


class Part(NamedTuple):
    """A part of the library: its arguments by kind, and what a use can set, by kind (a number, a choice, a function, points)
    with documentation and SI unit."""

    name: str
    docs: str
    arguments: dict[str, str]
    settings: dict[str, tuple[str, str, str]]


@lru_cache(maxsize=None)
def parts() -> dict[str, Part]:
    """The parts library by name, from the table of the compiler."""
    rows = _native.parts()
    return {
        name: Part(name, docs, dict(arguments), {setting: (kind, said, unit) for setting, kind, said, unit in settings})
        for name, docs, arguments, settings in rows
    }


class Builder:
    """Writes a declaration line by line: `text` shows it, and `compile` makes a mechanism of it.

    Numbers are in SI. A text is words of the language with its units, as "20 cm" or "2*length". Bodies and parts that are made
    are expressions: `crank.a` is a port, `crank.angle` an angle. Every part of the library is a method: `m.revolute("pin", a, b)`.
    """

    __module__ = "plm"

    def __init__(self, name: str, docs: str = "", gravity: Optional[Value] = None) -> None:
        #: The name of the mechanism.
        self.name = name if name[:1].isupper() else "".join(word.capitalize() for word in name.split("_"))
        self._docs, self._items = docs, list[str]()
        self._ground: dict[str, str] = {}
        self._place: Optional[int] = None
        if gravity is not None:
            self.item(f"gravity: {words(gravity, 'm/s^2')};")

    def item(self, item: str, docs: str = "") -> None:
        """Adds words of the language as they stand, as "require low: crank.omega < 10 rad/s;"."""
        self._items.append("".join(f"/// {line}\n" for line in docs.splitlines()) + item)

    def param(self, name: str, value: Optional[Value] = None, unit: str = "1", docs: str = "") -> Expression:
        """Declares a parameter in a unit; without a value it must be given before a run."""
        default = "" if value is None else f" = {_in_unit(value, unit)}"
        self.item(f"param {name}: {unit}{default};", docs)
        return Expression(name)

    def input(self, name: str, unit: str = "1", value: Value = 0, docs: str = "") -> Expression:
        """Declares an input in a unit."""
        self.item(f"input {name}: {unit} = {_in_unit(value, unit)};", docs)
        return Expression(name)

    def let(self, name: str, value: Value) -> Expression:
        """Gives an expression a name."""
        self.item(f"let {name} = {words(value)};")
        return Expression(name)

    def ground(self, **ports: Union[Pair, tuple[Value, Value, Value]]) -> Expression:
        """Declares ports of the ground: x, y, m, and an angle, rad, if there is one. Gives the ground."""
        if self._place is None:
            self._place = len(self._items)
            self._items.append("")
        for name, port in ports.items():
            self._ground[name] = _port(name, port)
        return Expression("ground")

    def body(
        self,
        name: str,
        *,
        ports: Optional[Mapping[str, Union[Pair, tuple[Value, Value, Value]]]] = None,
        centre: Optional[Pair] = None,
        start: Optional[Mapping[str, Value]] = None,
        locked: Iterable[str] = (),
        contour: Union[str, Sequence[Pair], None] = None,
        docs: str = "",
        **fields: Value,
    ) -> Expression:
        """Declares a body: `mass`, `inertia` about G, `density` and `thickness`, `depth`; ports x, y and an angle if there is
        one; start values x, y, angle, vx, vy, omega, of which those in `locked` are kept by assembly; a contour, points or a
        file."""
        lines = [f"{field}: {words(value, _FIELDS.get(field, ''))};" for field, value in fields.items()]
        if centre is not None:
            lines.append(f"centre: {pair(centre, 'm')};")
        lines += [_port(port, place) for port, place in (ports or {}).items()]
        if contour is not None:
            lines.append(f'contour: "{contour}";' if isinstance(contour, str) else f"contour: {pairs(contour, 'm')};")
        kept = set(locked)
        for quantity, value in (start or {}).items():
            lock = ", locked" if quantity in kept else ""
            lines.append(f"start {quantity}: {words(value, _STARTS.get(quantity, ''))}{lock};")
            kept.discard(quantity)
        if kept:
            raise ValueError(f"locked without a start value: {', '.join(sorted(kept))}")
        self.item(_block(f"body {name}", lines), docs)
        return Expression(name)

    def part(self, kind: str, name: str, *arguments: Value, **settings: Any) -> Expression:
        """Uses a part of the library, or one that was declared by `item`; what it sets are numbers in SI, words, for points a list
        of pairs, for a function a pair of its arguments and its expression."""
        known = parts().get(kind)
        lines = [_setting(known, setting, value) for setting, value in settings.items()]
        head = f"{kind} {name}({', '.join(words(argument) for argument in arguments)})"
        self.item(_block(head, lines) if lines else f"{head};")
        return Expression(name)

    def output(self, value: Value, name: str = "", unit: str = "", docs: str = "") -> None:
        """Declares an output, in a unit if it is not to be SI's; what is not a member of a body or a part has a name."""
        self.item(f"output {f'{name} = ' if name else ''}{words(value)}{f' in {unit}' if unit else ''};", docs)

    def text(self) -> str:
        """The declaration."""
        items = list(self._items)
        if self._place is not None:
            items[self._place] = _block("ground", self._ground.values())
        docs = "".join(f"/// {line}\n" for line in self._docs.splitlines())
        lines = (line for item in items for line in item.splitlines())
        return f"{docs}pub {self.name} {{\n" + "".join(f"    {line}\n" for line in lines) + "}\n"

    def compile(self) -> Mechanism:
        """The mechanism; a declaration with mistakes is a `DeclarationError`, which shows them in what was written."""
        return Mechanism(self.text(), f"{self.name}.plm")

    def __getattr__(self, name: str) -> Any:
        known = parts().get(name)
        if known is None:
            raise AttributeError(unknown("method or part", name, [*parts(), *dir(type(self))]))
        return _method(self, known)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *parts()]

    def __str__(self) -> str:
        return self.text()


def _method(builder: Builder, of: Part) -> Any:
    """The use of a part as a method, with its signature."""

    def use(name: str, *arguments: Value, **settings: Any) -> Expression:
        return builder.part(of.name, name, *arguments, **settings)

    told = [f"    {name}: {unit or kind}. {docs}".rstrip(". ") for name, (kind, docs, unit) in of.settings.items()]
    use.__name__, use.__doc__ = of.name, "\n".join([of.docs, "", "Can be set:", *told] if told else [of.docs])
    positional, named = inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.KEYWORD_ONLY
    first = [inspect.Parameter(name, positional) for name in ("name", *of.arguments)]
    # Blocks of a part may set the same name in several cases.
    free = (name for name in of.settings if name.isidentifier() and not keyword.iskeyword(name))
    given = [inspect.Parameter(name, named, default=None) for name in free]
    setattr(use, "__signature__", inspect.Signature([*first, *given], return_annotation=Expression))
    return use


def _setting(of: Optional[Part], name: str, value: Any) -> str:
    kind, _, unit = of.settings.get(name, ("number", "", "")) if of else ("number", "", "")
    if kind == "function" and not isinstance(value, (str, Expression)):
        *arguments, expression = value
        return f"{name}({', '.join(arguments)}): {words(expression)};"
    if kind == "points" and not isinstance(value, str):
        return f"{name}: {pairs(value, unit)};"
    return f"{name}: {words(value, unit)};"


def _port(name: str, place: Any) -> str:
    x, y, *angle = place
    turned = f", angle: {words(angle[0], 'rad')}" if angle else ""
    return f"port {name}: {pair((x, y), 'm')}{turned};"


def _in_unit(value: Value, unit: str) -> str:
    """A number in a unit; zero and pure numbers have none."""
    return words(value, "" if unit == "1" or value == 0 else unit)


def _block(head: str, lines: Iterable[str]) -> str:
    return "\n".join([f"{head} {{", *(f"    {line}" for line in lines), "}"])
