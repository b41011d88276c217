"""What all mechanisms of plm can do. Everything is in SI; `Quantity` tells units."""

from __future__ import annotations

import copy
import inspect
import keyword
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Optional, Union

import numpy as np

from . import _show
from ._checks import Line, chosen, finite, matrix, optional, text
from ._saved import Snapshot as Snapshot, restored, vars_of
from ._values import Array, Event, Jacobian, Linearisation, Pose, Quantity, Results, Tables, unknown

# Kinds of numbers, as plm counts them.
PARAMETER, INPUT, STATE, OUTPUT, START, BODY = range(6)
CONTACT = 8
# What a row of contact does, by its number.
MODES = "open", "closed", "off", "sticks", "forwards", "backwards"
SETTABLE = (PARAMETER, INPUT, STATE)


class Mechanism:
    """A mechanism, and a run of it that begins when it is made."""

    __slots__ = ("_run",)

    _native: ClassVar[Any]
    _tables: ClassVar[Tables]
    _numbers: ClassVar[dict[str, tuple[int, int]]]
    _rows: ClassVar[dict[str, Quantity]]

    def __init_subclass__(cls) -> None:
        if "_tables" not in vars(cls):
            # A user's class over that of a mechanism.
            return
        tables = cls._tables
        numbers: dict[str, tuple[int, int]] = {}
        named: dict[str, Quantity] = {}
        kinds = (PARAMETER, tables.parameters), (INPUT, tables.inputs), (OUTPUT, tables.outputs), (STATE, tables.states)
        for kind, rows in kinds:
            for index, row in enumerate(rows):
                if row.name not in numbers:
                    numbers[row.name], named[row.name] = (kind, index), row
                    if _is_free(row.name):
                        setattr(cls, row.name, _property(row, kind in SETTABLE))
        cls._numbers, cls._rows = numbers, named
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
        twice = [name for name in parameters or () if name in given]
        if twice:
            raise TypeError(f"parameter {twice[0]!r} is given twice: as a keyword and in parameters")
        by = text("method", method), optional("tolerance", tolerance), optional("longest_step", longest_step)
        self._run = self._started({**given, **(parameters or {})}, start or {}, by, time)

    def _started(
        self,
        given: Mapping[str, float],
        start: Mapping[str, float],
        by: tuple[str, Optional[float], Optional[float]],
        time: float,
        *inputs: Any,
    ) -> Any:
        """A run from these parameters and start values on; `inputs` by number where it begins with others than declared."""
        tables = self._tables
        known = [row.name for row in tables.parameters]
        for name in given:
            if name not in known:
                own = (name for name in inspect.signature(Mechanism.__init__).parameters if name not in ("self", "given"))
                raise TypeError(unknown("parameter", name, [*known, *own]))
        missing = [row.name for row in tables.parameters if row.default is None and row.name not in given]
        if missing:
            raise TypeError(f"parameters without a default must be given: {', '.join(missing)}")
        names = [row.name for row in tables.starts]
        for name in start:
            if name not in names:
                raise KeyError(unknown("start value", name, names))
        return self._native.start(
            by,
            [(known.index(name), finite(name, value)) for name, value in given.items()],
            [(names.index(name), finite(name, value)) for name, value in start.items()],
            finite("time", time),
            *inputs,
        )

    @property
    def time(self) -> float:
        """The time of the run, s."""
        return float(self._run.time())

    def get(self, name: str) -> float:
        """A parameter, an input, an output or a state by its full name, SI."""
        return float(self._run.get(*self._number(name)))

    def set(self, name: str, value: float) -> None:
        """Sets a parameter, an input or a first-order state, SI; an input is held until it is set again."""
        kind, index = self._number(name)
        if kind not in SETTABLE:
            raise AttributeError(f"{name!r} is an output: it can be read, not set")
        self._run.set(kind, index, finite(name, value))

    def __getitem__(self, name: str) -> float:
        return self.get(name)

    def __setitem__(self, name: str, value: float) -> None:
        self.set(name, value)

    def __contains__(self, name: object) -> bool:
        return name in self._numbers

    def __iter__(self) -> Iterator[str]:
        """The names of parameters, inputs, outputs and states."""
        return iter(self._numbers)

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

    @property
    def contacts(self) -> dict[str, str]:
        """What each row of contact does. A gap is "open" or "closed"; a friction is "off" as long as nothing pushes, "sticks", or slips
        "forwards" or "backwards"."""
        rows = enumerate(self._tables.contacts)
        return {name: MODES[int(self._run.get(CONTACT, index))] for index, name in rows}

    def step(self, dt: float) -> None:
        """Runs for `dt`, s, and ends exactly there. After a fault the run is as it was before."""
        dt = finite("dt", dt)
        if dt < 0:
            raise ValueError(f"dt must not be negative: {dt}")
        self._run.step(dt)

    def run(
        self,
        until: float,
        every: Optional[float] = None,
        outputs: Optional[Iterable[str]] = None,
        progress: Union[bool, Callable[[float], object], None] = None,
        poses: bool = False,
    ) -> Results:
        """Runs until the time `until`, s, and gives the time and quantities every `every`, s: 1000 times if that is not said.

        `outputs` are names of outputs, inputs, states or parameters, the outputs that were declared if nothing is said. What
        switched on the way are the `events` of the results; with `poses` they have the `poses` of all bodies. `progress` is called
        now and then with the time, or shows a line if it is True.

        What ends the run early, a `Fault`, Ctrl+C, what `progress` raises, has the rows before as `results`; the run is
        then where the last row is, and can be gone on with.
        """
        wanted = [row.name for row in self._tables.declared] if outputs is None else outputs
        if isinstance(wanted, str):
            raise TypeError(f"outputs must be a list of names, as in outputs=[{wanted!r}]")
        # The time has its column anyway, and each name one.
        names = [name for name in dict.fromkeys(wanted) if name != "time"]
        begin, until = self.time, finite("until", until)
        if until < begin:
            raise ValueError(f"until must not be before the time of the run, {begin} s: {until}")
        # At the present time there is one row.
        every = (until - begin) / 1000 or 1.0 if every is None else finite("every", every)
        if every <= 0:
            raise ValueError(f"every must be positive: {every}")
        numbers = [self._number(name) for name in names]
        line = Line(begin, until) if progress is True else None
        columns, events, error = self._run.run((until, every), numbers, bool(poses), line or progress or None)
        if line:
            line.end()
        units = {"time": "s", **{name: self._rows[name].unit for name in names}}
        arrays = [np.frombuffer(column, dtype=np.float64) for column in columns]
        of_bodies = zip(self.bodies, range(len(units), len(arrays), 6))
        results = Results(
            dict(zip(units, arrays)),
            units,
            (Event(*event) for event in events),
            {name: np.column_stack(arrays[at : at + 6]) for name, at in of_bodies},
            self.stats(),
            self._run.notices(),
        )
        if error is not None:
            error.results = results
            raise error
        return results

    def stats(self) -> dict[str, float]:
        """Counters of the run, from its start on: steps, rejected steps, evaluations, and more; and its longest step, s."""
        return {name: count if name == "longest_step" else int(count) for name, count in self._run.stats()}

    @property
    def state(self) -> Array:
        """What is integrated, SI: coordinates, their velocities, first-order states, as `state_names` names them.

        Angles count from the last whole turn. The coordinates of a loop are others from time to time. A state that is set has its
        loops closed on their present side.
        """
        return np.frombuffer(self._run.state(), dtype=np.float64)

    @state.setter
    def state(self, numbers: Union[Sequence[float], Array]) -> None:
        names = self.state_names
        if len(numbers) != len(names):
            raise ValueError(f"the state has {len(names)} numbers, not {len(numbers)}: {', '.join(names)}")
        self._run.set_state([finite(name, number) for name, number in zip(names, numbers)])

    @property
    def state_names(self) -> tuple[str, ...]:
        """The names of the numbers of `state`, which are those of the rows and columns of matrices too."""
        return tuple(self._run.state_names())

    def rates(self) -> Array:
        """The rates of the numbers of `state`, SI."""
        return np.frombuffer(self._run.rates(), dtype=np.float64)

    def jacobian(self, inputs: Optional[Sequence[str]] = None, outputs: Optional[Sequence[str]] = None) -> Jacobian:
        """The derivatives of rates and declared outputs by the numbers of `state` and by inputs, or some of them."""
        matrices = [matrix(*rows) for rows in self._run.jacobian()]
        return Jacobian(*self._of_chosen(matrices, self.state_names, inputs, outputs))

    def linearise(
        self, inputs: Optional[Sequence[str]] = None, outputs: Optional[Sequence[str]] = None
    ) -> Linearisation:
        """The mechanism near its present state as a linear system, of the inputs and the declared outputs, or some of them."""
        *matrices, basis = (matrix(*rows) for rows in self._run.linearise())
        names, count = self.state_names, basis.shape[1]
        is_free = count == len(names) and np.array_equal(basis, np.eye(count))
        states = names if is_free else tuple(f"direction {k + 1}" for k in range(count))
        a, b, c, d, _, ins, outs = self._of_chosen(matrices, states, inputs, outputs)
        return Linearisation(a, b, c, d, basis, ins, outs, states, names)

    def _of_chosen(
        self,
        matrices: Sequence[Array],
        states: tuple[str, ...],
        inputs: Optional[Sequence[str]],
        outputs: Optional[Sequence[str]],
    ) -> Any:
        """Matrices of some inputs and outputs, in SI, and all names."""
        ins, outs = [row.name for row in self._tables.inputs], [row.name for row in self._tables.declared]
        # Where there are no rows the numbers do not tell how many columns there are.
        sizes = (len(states), len(states)), (len(states), len(ins)), (len(outs), len(states)), (len(outs), len(ins))
        a, b, c, d = (each.reshape(size) for each, size in zip(matrices, sizes))
        factors = np.array([row.factor for row in self._tables.declared]).reshape(-1, 1)
        u, y = chosen("input", inputs, ins), chosen("declared output", outputs, outs)
        c, d = (c * factors)[y], (d * factors)[y]
        return a, b[:, u], c, d[:, u], states, tuple(ins[k] for k in u), tuple(outs[k] for k in y)

    def save(self) -> Snapshot:
        """Everything that decides how the run goes on; `bytes` of it are for files and other machines."""
        return Snapshot(type(self), self._run.copy())

    def restore(self, saved: Union[Snapshot, bytes]) -> None:
        """Goes on from a saved moment, or from its bytes, with the same bits."""
        if isinstance(saved, Snapshot):
            if saved._of is not type(self):
                raise TypeError(f"what is restored was saved by a {saved._of.__name__}, not by a {type(self).__name__}")
            saved = saved._saved
        elif not isinstance(saved, (bytes, bytearray, memoryview)):
            raise TypeError(f"what is restored must have been saved by a {type(self).__name__}, or be bytes of that")
        if isinstance(saved, (bytes, bytearray, memoryview)):
            self._native.read(self._run, bytes(saved))
        else:
            self._run.restore(saved)

    @classmethod
    def from_bytes(cls, saved: bytes) -> Any:
        """A mechanism that goes on from the bytes of a saved moment."""
        return restored(cls, bytes(saved), {})

    def __copy__(self) -> Any:
        other = object.__new__(type(self))
        other._run = self._run.copy()
        vars_of(other).update(vars_of(self))
        return other

    def __deepcopy__(self, memo: dict[int, Any]) -> Any:
        other = self.__copy__()
        vars_of(other).update(copy.deepcopy(vars_of(self), memo))
        return other

    def __reduce__(self) -> Any:
        return restored, (type(self), bytes(self._native.save(self._run)), dict(vars_of(self)))

    def __repr__(self) -> str:
        values = (f"{row.name}={self.get(row.name):g}" for row in self._tables.parameters)
        return f"<{type(self).__name__} at {self.time:g} s{''.join(', ' + value for value in values)}>"

    def _repr_html_(self) -> str:
        kinds = ("parameter", self.parameters), ("input", self.inputs), ("state", self.states), ("output", self.outputs)
        rows = [
            (kind, name, self.get(name), row.unit, row.docs)
            for kind, quantities in kinds
            for name, row in quantities.items()
        ]
        return _show.table(f"{type(self).__name__} at {self.time:g} s", ("", "name", "value", "unit", ""), rows)

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
