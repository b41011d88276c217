"""C source of a mechanism from text, and FMUs with it."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Optional, Union

from . import _native
from ._rollouts import si

if TYPE_CHECKING:
    from ._declared import Mechanism
    from ._experiment import Value

Given = Optional[Mapping[str, "Value"]]
Numbers = list[tuple[int, float]]


def numbers(mechanism: Mechanism, parameters: Given, start: Given, inputs: Given) -> tuple[Numbers, Numbers, Numbers]:
    """Values by number, SI: of parameters, start values, inputs."""

    def of(what: str, rows: Mapping[str, object], values: Given) -> Numbers:
        names = list(rows)
        given = [(name, si(what, rows, name, value)) for name, value in (values or {}).items()]  # type: ignore[arg-type]
        return [(names.index(name), value) for name, value in given]

    return (
        of("parameter", mechanism.parameters, parameters),
        of("start value", mechanism.starts, start),
        of("input", mechanism.inputs, inputs),
    )


def c_source(
    mechanism: Mechanism, folder: Union[str, Path], single: bool, parameters: Given, start: Given, inputs: Given
) -> list[Path]:
    """Writes C99 of a mechanism into a folder."""
    files = _native.c_source(mechanism._text, single, *numbers(mechanism, parameters, start, inputs))
    Path(folder).mkdir(parents=True, exist_ok=True)
    written = []
    for name, text in files:
        path = Path(folder) / name
        path.write_bytes(text.encode())
        written.append(path)
    return written


def fmu_source(
    mechanism: Mechanism,
    file: Union[str, Path],
    version: int,
    interface: Optional[str],
    parameters: Given,
    start: Given,
    inputs: Given,
) -> Path:
    """Writes an FMU with sources of a mechanism."""
    given = numbers(mechanism, parameters, start, inputs)
    made, without = _native.fmu_source(mechanism._text, (version, interface), *given)
    if interface is None:
        for part in without:
            warnings.warn(f"co-simulation alone: {part}", stacklevel=3)
    Path(file).write_bytes(made)
    return Path(file)
