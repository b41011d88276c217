"""What all mechanisms of plm can do. Everything is in SI; `Quantity` tells units."""

from __future__ import annotations

import inspect
import keyword
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Optional, Union

import numpy as np

from ._values import Array, Linearisation, Pose, Quantity, Results, Tables, unknown

# Kinds of numbers, as plm counts them.
PARAMETER, INPUT, STATE, OUTPUT, START, BODY = range(6)


class Snapshot:
    """A mechanism as it was at one moment: `Mechanism.save`."""

    __slots__ = ("_of", "_native")

    def __init__(self, of: type[Mechanism], native: Any) -> None:
        self._of, self._native = of, native


class Mechanism:
    """A mechanism, and a run of it that begins when it is made."""

    __slots__ = ("_run",)

    _native: ClassVar[Any]
    _tables: ClassVar[Tables]
    _numbers: ClassVar[dict[str, tuple[int, int]]]

    def __init_subclass__(cls) -> None:
        if "_tables" not in vars(cls):
            # A user's class over that of a mechanism.
            return
        tables = cls._tables
        numbers: dict[str, tuple[int, int]] = {}
        kinds = (PARAMETER, tables.parameters), (INPUT, tables.inputs), (OUTPUT, tables.outputs), (STATE, tables.states)
        for kind, rows in kinds:
            for index, row in enumerate(rows):
                if numbers.setdefault(row.name, (kind, index)) == (kind, index) and _is_free(row.name):
                    setattr(cls, row.name, _property(row, kind in (PARAMETER, INPUT)))
        cls._numbers = numbers
        own = list(inspect.signature(Mechanism.__init__).parameters.values())
        given = [_keyword(row) for row in tables.parameters if _is_keyword(row.name)]
        init: Any = _init()
        init.__qualname__ = f"{cls.__qualname__}.__init__"
        init.__signature__ = inspect.Signature([own[0], *given, *own[1:-1]])
        setattr(cls, "__init__", init)

    def __init__(
        self,
        *,
        start: Optional[Mapping[str, float]] = None,
        method: str = "dop853",
        tolerance: Optional[float] = None,
        longest_step: Optional[float] = None,
        time: float = 0.0,
        parameters: Optional[Mapping[str, float]] = None,
        **given: float,
    ) -> None:
        tables, given = self._tables, {**given, **(parameters or {})}
        known = [row.name for row in tables.parameters]
        for name in given:
            if name not in known:
                own = (name for name in inspect.signature(Mechanism.__init__).parameters if name not in ("self", "given"))
                raise TypeError(unknown("parameter", name, [*known, *own]))
        missing = [row.name for row in tables.parameters if row.default is None and row.name not in given]
        if missing:
            raise TypeError(f"parameters without a default must be given: {', '.join(missing)}")
        names = [row.name for row in tables.starts]
        for name in start or {}:
            if name not in names:
                raise KeyError(unknown("start value", name, names))
        self._run = self._native.start(
            (method, tolerance, longest_step),
            [(known.index(name), _finite(name, value)) for name, value in given.items()],
            [(names.index(name), _finite(name, value)) for name, value in (start or {}).items()],
            _finite("time", time),
        )

    @property
    def time(self) -> float:
        """The time of the run, s."""
        return float(self._run.time())

    def get(self, name: str) -> float:
        """A parameter, an input, an output or a state by its full name, SI."""
        return float(self._run.get(*self._number(name)))

    def set(self, name: str, value: float) -> None:
        """Sets a parameter or an input, SI; an input is held until it is set again."""
        kind, index = self._number(name)
        if kind not in (PARAMETER, INPUT):
            raise AttributeError(f"`{name}` can be read, not set")
        self._run.set(kind, index, _finite(name, value))

    def __getitem__(self, name: str) -> float:
        return self.get(name)

    def __setitem__(self, name: str, value: float) -> None:
        self.set(name, value)

    # Types find such mistakes by themselves, and better.
    if not TYPE_CHECKING:

        def __setattr__(self, name: str, value: Any) -> None:
            # A class that a user has built upon this one has attributes of its own.
            if not hasattr(type(self), name) and "_tables" in vars(type(self)):
                raise AttributeError(unknown("parameter or input", name, self._numbers))
            super().__setattr__(name, value)

        def __getattr__(self, name: str) -> Any:
            raise AttributeError(unknown("attribute", name, [*self._numbers, *dir(Mechanism)]))

    def pose(self, body: str) -> Pose:
        """Pose and velocity of the centre of gravity of a body."""
        if body not in self.bodies:
            raise KeyError(unknown("body", body, self.bodies))
        return Pose(*self._run.pose(self.bodies.index(body)))

    def step(self, dt: float) -> None:
        """Runs for `dt`, s, and ends exactly there. After a fault the run is as it was before."""
        self._run.step(dt)

    def run(
        self,
        until: float,
        every: Optional[float] = None,
        outputs: Optional[Iterable[str]] = None,
        progress: Union[bool, Callable[[float], object], None] = None,
    ) -> Results:
        """Runs until the time `until`, s, and gives the time and outputs every `every`, s: 1000 times if that is not said.

        `outputs` are names of `self.outputs`, those that were declared if nothing is said. `progress` is called now and then
        with the time, or shows a line if it is True.

        What ends the run early, a `Fault`, Ctrl+C, what `progress` raises, has the rows before as `results`; the run is
        then where the last row is, and can be gone on with.
        """
        rows = self._tables.outputs
        wanted = [row.name for row in self._tables.declared] if outputs is None else outputs
        if isinstance(wanted, str):
            raise TypeError(f"outputs must be a list of names, as in outputs=[{wanted!r}]")
        named = [self._output(name) for name in wanted]
        begin = self.time
        # At the present time there is one row.
        every = (until - begin) / 1000 or 1.0 if every is None else every
        line = _Line(begin, until) if progress is True else None
        shown = line or progress or None
        columns, error = self._run.run((until, every), named, shown)
        if line:
            line.end()
        arrays = [np.frombuffer(column, dtype=np.float64) for column in columns]
        units = {"time": "s", **{rows[index].name: rows[index].unit for index in named}}
        results = Results(dict(zip(units, arrays)), units)
        if error is not None:
            error.results = results
            raise error
        return results

    def linearise(
        self, inputs: Optional[Sequence[str]] = None, outputs: Optional[Sequence[str]] = None
    ) -> Linearisation:
        """The mechanism near its present state as a linear system, of the inputs and the declared outputs, or some of them."""
        a, b, c, d, basis = (_matrix(*matrix) for matrix in self._run.linearise())
        tables = self._tables
        ins, outs = [row.name for row in tables.inputs], [row.name for row in tables.declared]
        factors = np.array([row.factor for row in tables.declared]).reshape(-1, 1)
        u, y = _chosen("input", inputs, ins), _chosen("declared output", outputs, outs)
        c, d = (c * factors)[y], (d * factors)[y]
        return Linearisation(a, b[:, u], c, d[:, u], basis, tuple(ins[k] for k in u), tuple(outs[k] for k in y))

    def save(self) -> Snapshot:
        """Everything that decides how the run goes on."""
        return Snapshot(type(self), self._run.copy())

    def restore(self, snapshot: Snapshot) -> None:
        """Goes on from a saved moment, with the same bits."""
        if not isinstance(snapshot, Snapshot) or snapshot._of is not type(self):
            raise TypeError(f"what is restored must have been saved by a {type(self).__name__}")
        self._run.restore(snapshot._native)

    def __copy__(self) -> Any:
        other = object.__new__(type(self))
        other._run = self._run.copy()
        return other

    def __deepcopy__(self, memo: object) -> Any:
        return self.__copy__()

    def __reduce__(self) -> Any:
        raise TypeError(f"a {type(self).__name__} that runs cannot be pickled: make it where it is needed")

    def __repr__(self) -> str:
        values = (f"{row.name}={self.get(row.name):g}" for row in self._tables.parameters)
        return f"<{type(self).__name__} at {self.time:g} s{''.join(', ' + value for value in values)}>"

    @property
    def parameters(self) -> dict[str, Quantity]:
        """The parameters by name."""
        return {row.name: row for row in self._tables.parameters}

    @property
    def inputs(self) -> dict[str, Quantity]:
        """The inputs by name."""
        return {row.name: row for row in self._tables.inputs}

    @property
    def states(self) -> dict[str, Quantity]:
        """The first-order states by name."""
        return {row.name: row for row in self._tables.states}

    @property
    def outputs(self) -> dict[str, Quantity]:
        """The declared outputs and what else is observed, by name."""
        return {row.name: row for row in self._tables.outputs}

    @property
    def starts(self) -> dict[str, Quantity]:
        """The start values by name: x, y, angle, vx, vy, omega of the origin of each body, then the first-order states."""
        return {row.name: row for row in self._tables.starts}

    @property
    def bodies(self) -> tuple[str, ...]:
        """The names of the bodies."""
        return self._tables.bodies

    def _number(self, name: str) -> tuple[int, int]:
        if name not in self._numbers:
            raise KeyError(unknown("quantity", name, self._numbers))
        return self._numbers[name]

    def _output(self, name: str) -> int:
        names = [row.name for row in self._tables.outputs]
        if name not in names:
            raise KeyError(unknown("output", name, names))
        return names.index(name)


def _init() -> Callable[..., None]:
    """A function of its own for each mechanism, whose signature has its parameters."""

    def __init__(self: Mechanism, **given: Any) -> None:
        Mechanism.__init__(self, **given)

    return __init__


def _is_free(name: str) -> bool:
    """Can it be an attribute? What has the name of a method, or of Python's own, is had by `get` and `set`."""
    return name.isidentifier() and not keyword.iskeyword(name) and not hasattr(Mechanism, name) and name[0] != "_"


def _is_keyword(name: str) -> bool:
    """Can it be a keyword of a call? What cannot stands in `parameters`."""
    own = inspect.signature(Mechanism.__init__).parameters
    return name.isidentifier() and not keyword.iskeyword(name) and name not in own


def _keyword(row: Quantity) -> inspect.Parameter:
    default = inspect.Parameter.empty if row.default is None else row.default
    return inspect.Parameter(row.name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation="float")


def _property(row: Quantity, settable: bool) -> property:
    def get(self: Mechanism) -> float:
        return self.get(row.name)

    def put(self: Mechanism, value: float) -> None:
        self.set(row.name, value)

    return property(get, put if settable else None, doc=f"{row.docs} ({row.unit or '1'})".strip())


def _finite(name: str, value: float) -> float:
    # What `float` would read of a text is no number that was meant.
    if isinstance(value, (str, bytes)):
        raise TypeError(f"`{name}` must be a number, not {value!r}")
    number = float(value)
    if not np.isfinite(number):
        raise ValueError(f"`{name}` must be a finite number, not {value}")
    return number


def _matrix(rows: int, numbers: bytearray) -> Array:
    array = np.frombuffer(numbers, dtype=np.float64)
    return array.reshape(rows, array.size // rows if rows else 0)


def _chosen(what: str, wanted: Optional[Sequence[str]], known: list[str]) -> list[int]:
    for name in wanted or ():
        if name not in known:
            raise KeyError(unknown(what, name, known))
    return list(range(len(known))) if wanted is None else [known.index(name) for name in wanted]


class _Line:
    """A line of the progress on stderr."""

    def __init__(self, begin: float, until: float) -> None:
        self.begin, self.until = begin, until

    def __call__(self, time: float) -> None:
        share = (time - self.begin) / (self.until - self.begin)
        bar = "#" * int(40 * share)
        print(f"\r[{bar:40}] {time:.4g} s of {self.until:g} s ", end="", file=sys.stderr, flush=True)

    def end(self) -> None:
        print("\r" + " " * 79, end="\r", file=sys.stderr, flush=True)
