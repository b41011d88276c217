"""A mechanism that is declared as text."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, Optional, Union

from numpy.typing import ArrayLike

from . import _native, _show, _source
from ._checks import finite, optional, text as named
from ._experiment import Experiment, Rows, Unknowns, Value
from ._fit import Fit, identify
from ._gradient import Gradient, gradient
from ._mechanism import INPUT, OUTPUT, PARAMETER, START
from ._rollouts import Rollouts, arrays, columns, rollouts, si
from ._sim import Show, Sim
from ._values import Quantity, Results, Tables, unknown


def check(text: str, name: str = "<text>") -> list[dict[str, Any]]:
    """Mistakes and warnings of a declaration, as `plm check --json` tells them; none where nothing is wrong."""
    found: list[dict[str, Any]] = json.loads(_native.diagnostics(named("name", name), named("text", text)))
    return found


class Mechanism:
    """A mechanism that is declared as text: the inside of `mechanism! { … }` of Rust, or a file `.plm`.

    Everything is in SI; values of parameters, inputs and starts can be texts with a unit, as "20 cm".
    """

    __module__ = "plm"

    def __init__(self, text: str, name: str = "<text>") -> None:
        """Compiles a declaration; `name` is what messages call it, and files that it names are read beside that.

        A declaration with mistakes is a `DeclarationError`.
        """
        self._source, self._file = named("text", text), named("name", name)
        self._text = _native.Text(name, text)
        self.name, self.docs, self.formulation = self._text.about()
        rows: Any = [tuple(Quantity(*row) if isinstance(row, tuple) else row for row in rows) for rows in self._text.tables()]
        self._tables = tables = Tables(*rows)
        self._class: type[Sim] = type(
            self.name,
            (Sim,),
            {"_native": self._text, "_tables": tables, "mechanism": self, "__doc__": self.docs or self.name},
        )

    @classmethod
    def from_file(cls, path: Union[str, Path]) -> Mechanism:
        """Compiles the declaration in a file; files that it names are read beside it."""
        return cls(Path(path).read_text(encoding="utf-8"), str(path))

    @property
    def text(self) -> str:
        """The declaration."""
        return self._source

    @property
    def diagnostics(self) -> list[dict[str, Any]]:
        """The warnings of the declaration, as `plm check --json` tells them."""
        return check(self._source, self._file)

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

    @property
    def contacts(self) -> tuple[str, ...]:
        """The names of the rows of contact."""
        return self._tables.contacts

    def start(
        self,
        *,
        parameters: Optional[Mapping[str, Value]] = None,
        inputs: Optional[Mapping[str, Value]] = None,
        start: Optional[Mapping[str, Value]] = None,
        method: str = "dop853",
        tolerance: Optional[float] = None,
        longest_step: Optional[float] = None,
        time: float = 0.0,
    ) -> Sim:
        """Assembles the mechanism at a time, s, with parameters, inputs and start values in place of those declared."""
        given = {name: si("parameter", self.parameters, name, value) for name, value in (parameters or {}).items()}
        begin = {name: si("start value", self.starts, name, value) for name, value in (start or {}).items()}
        fed = {name: si("input", self.inputs, name, value) for name, value in (inputs or {}).items()}
        sim: Sim = object.__new__(self._class)
        by = named("method", method), optional("tolerance", tolerance), optional("longest_step", longest_step)
        names = list(self.inputs)
        sim._run = sim._started(given, begin, by, time, [(names.index(name), value) for name, value in fed.items()])
        return sim

    def c_source(
        self,
        folder: Union[str, Path],
        *,
        single: bool = False,
        parameters: Optional[Mapping[str, Value]] = None,
        inputs: Optional[Mapping[str, Value]] = None,
        start: Optional[Mapping[str, Value]] = None,
    ) -> list[Path]:
        """Writes C99 of the mechanism into a folder, and gives the files; `single` is for numbers of 32 bits.

        What no source has is refused by its name, with a `ValueError`.
        """
        return _source.c_source(self, folder, single, parameters, start, inputs)

    def fmu_source(
        self,
        file: Union[str, Path],
        *,
        version: int = 3,
        interface: Optional[str] = None,
        parameters: Optional[Mapping[str, Value]] = None,
        inputs: Optional[Mapping[str, Value]] = None,
        start: Optional[Mapping[str, Value]] = None,
    ) -> Path:
        """Writes an FMU with C source, of FMI 3.0 or 2.0 (`version` 2), and gives the file.

        `interface` is "model-exchange" or "co-simulation"; without it the FMU has both, or co-simulation alone and a warning that names
        what model exchange does not have.
        """
        return _source.fmu_source(self, file, version, interface, parameters, start, inputs)

    def run(
        self,
        until: float,
        every: Optional[float] = None,
        outputs: Optional[Iterable[str]] = None,
        *,
        poses: bool = False,
        progress: Union[bool, Callable[[float], object], None] = None,
        parameters: Optional[Mapping[str, Value]] = None,
        inputs: Optional[Mapping[str, Value]] = None,
        start: Optional[Mapping[str, Value]] = None,
        method: str = "dop853",
        tolerance: Optional[float] = None,
        longest_step: Optional[float] = None,
        time: float = 0.0,
    ) -> Results:
        """Starts it at a time, s, and runs until another one, s, with a row every so often, s: 1000 times if that is not said.

        `parameters`, `inputs` and `start` stand in place of what is declared: numbers in SI, or texts with a unit. `method` is a name,
        as "dop853", "radauiia5" or "rk4"; `tolerance` is relative; `longest_step`, s, is the step of methods with steps of fixed
        length. `outputs` are names of outputs, inputs, states or parameters; with `poses` the results have those of all bodies.
        `progress` is called now and then with the time, or shows a line if it is True.
        """
        sim = self.start(
            parameters=parameters,
            inputs=inputs,
            start=start,
            method=method,
            tolerance=tolerance,
            longest_step=longest_step,
            time=time,
        )
        return sim.run(until, every, outputs, progress, poses)

    def show(
        self,
        until: float,
        every: Optional[float] = None,
        *,
        parameters: Optional[Mapping[str, Value]] = None,
        inputs: Optional[Mapping[str, Value]] = None,
        start: Optional[Mapping[str, Value]] = None,
        method: str = "dop853",
        tolerance: Optional[float] = None,
        longest_step: Optional[float] = None,
        time: float = 0.0,
    ) -> Show:
        """Starts it as `run` does, and gives the page of a run, as `Sim.show` does."""
        sim = self.start(
            parameters=parameters,
            inputs=inputs,
            start=start,
            method=method,
            tolerance=tolerance,
            longest_step=longest_step,
            time=time,
        )
        return sim.show(until, every)

    def rollouts(
        self,
        parameters: Union[Mapping[str, ArrayLike], ArrayLike, None] = None,
        until: float = 1.0,
        every: Optional[float] = None,
        outputs: Optional[Iterable[str]] = None,
        *,
        inputs: Optional[Mapping[str, ArrayLike]] = None,
        start: Optional[Mapping[str, ArrayLike]] = None,
        method: str = "dop853",
        tolerance: Optional[float] = None,
        longest_step: Optional[float] = None,
        time: float = 0.0,
        poses: bool = False,
        threads: Optional[int] = None,
    ) -> Rollouts:
        """Runs it once for each element of the arrays, on so many threads, on all cores if that is not said.

        An array has a value for each run, and a number serves all. `parameters` can be a matrix too, a row for each run with all
        parameters in their order. The numbers of each run are those of `run`, to the bit, whatever the number of threads. What
        ends a run early is in `faults` of the results.
        """
        if parameters is not None and not isinstance(parameters, Mapping):
            parameters = columns(self.parameters, parameters)
        varied = (
            arrays("parameter", self.parameters, parameters or {}),
            arrays("start value", self.starts, start or {}),
            arrays("input", self.inputs, inputs or {}),
        )
        missing = [row.name for row in self._tables.parameters if row.default is None and row.name not in varied[0]]
        if missing:
            raise TypeError(f"parameters without a default must be given: {', '.join(missing)}")
        begin, until = finite("time", time), finite("until", until)
        names = self._named(outputs)
        return rollouts(
            self._text,
            (named("method", method), optional("tolerance", tolerance), optional("longest_step", longest_step)),
            tuple(zip((self.parameters, self.starts, self.inputs), varied)),
            (begin, until, (until - begin) / 1000 if every is None else finite("every", every)),
            {name: (self._class._numbers[name], self._class._rows[name].unit) for name in names},
            self.bodies if poses else (),
            threads,
        )

    def gradient(
        self,
        by: Iterable[str],
        until: float,
        every: Optional[float] = None,
        outputs: Optional[Iterable[str]] = None,
        *,
        parameters: Optional[Mapping[str, Value]] = None,
        inputs: Optional[Mapping[str, Value]] = None,
        start: Optional[Mapping[str, Value]] = None,
        method: str = "dop853",
        tolerance: Optional[float] = None,
        longest_step: Optional[float] = None,
        time: float = 0.0,
    ) -> Gradient:
        """Outputs over the time and their derivatives by parameters, inputs and start values, by a run on dual numbers for each.

        They are exact but for the error of the method. Every mechanism and every method has them.
        """
        of = ("parameter", self.parameters, parameters), ("start value", self.starts, start), ("input", self.inputs, inputs)
        numbers = [
            [(list(rows).index(name), si(what, rows, name, value)) for name, value in (given or {}).items()]
            for what, rows, given in of
        ]
        names = self._named(outputs)
        unread = [name for name in names if self._class._numbers[name][0] != OUTPUT]
        if unread:
            raise KeyError(f"{unread[0]!r} is no output: its derivative is not had")
        begin, until = finite("time", time), finite("until", until)
        return gradient(
            self._text,
            (named("method", method), optional("tolerance", tolerance), optional("longest_step", longest_step)),
            (numbers[0], numbers[1], numbers[2]),
            (begin, until, (until - begin) / 1000 if every is None else finite("every", every)),
            {name: (self._class._numbers[name][1], self._class._rows[name].unit) for name in names},
            {name: self._variable(name) for name in ([by] if isinstance(by, str) else by)},
        )

    def identify(
        self,
        find: Unknowns,
        experiments: Union[Experiment, Iterable[Experiment]],
        *,
        parameters: Optional[Mapping[str, Value]] = None,
        inputs: Optional[Mapping[str, Value]] = None,
        start: Optional[Mapping[str, Value]] = None,
        method: str = "dop853",
        tolerance: Optional[float] = 1e-10,
        iterations: int = 200,
    ) -> Fit:
        """Finds parameters and start values from measurements, by least squares on exact derivatives.

        `find` names what experiments have in common: `["stiffness"]`, `{"stiffness": "20 N/mm"}` with a guess, or an `Unknown` with bounds
        and what is expected. Parameters, inputs and start values that are known are given as to `run`. Mechanisms of up to 8 bodies can
        be identified, by "dop853" and "radauiia5". A search that ends away from a minimum is a `NotConverged`.
        """
        rows = Rows(self.parameters, self.inputs, self.outputs, self.starts)
        by = named("method", method), optional("tolerance", tolerance), None
        known = parameters or {}, inputs or {}, start or {}
        found = identify(self._text, by, known, find, experiments, rows, iterations)
        return Fit(found, self.parameters, (self._file, self._source))

    def _variable(self, name: str) -> tuple[int, int]:
        """What a derivative is taken by: its kind and its number."""
        for kind, rows in (PARAMETER, self.parameters), (INPUT, self.inputs), (START, self.starts):
            if name in rows:
                return kind, list(rows).index(name)
        raise KeyError(unknown("parameter, input or start value", name, [*self.parameters, *self.inputs, *self.starts]))

    def _named(self, outputs: Optional[Iterable[str]]) -> list[str]:
        """Names of quantities, each once; the declared outputs where nothing is said."""
        names = list(dict.fromkeys([row.name for row in self._tables.declared] if outputs is None else outputs))
        for name in names:
            if name not in self._class._numbers:
                raise KeyError(unknown("quantity", name, self._class._numbers))
        return names

    def __reduce__(self) -> Any:
        return Mechanism, (self._source, self._file)

    def __repr__(self) -> str:
        count = len(self.bodies)
        return f"<plm.Mechanism {self.name}: {count} bod{'y' if count == 1 else 'ies'}, {self.formulation}>"

    def _repr_html_(self) -> str:
        kinds = ("parameter", self.parameters), ("input", self.inputs), ("state", self.states), ("output", self.outputs)
        rows = [
            (kind, name, "" if row.default is None else row.default, row.unit, row.docs)
            for kind, quantities in kinds
            for name, row in quantities.items()
        ]
        return _show.table(self.name, ("", "name", "declared", "unit", ""), rows)
