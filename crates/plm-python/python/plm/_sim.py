"""A running simulation of a mechanism from text, and the page of a run."""

from __future__ import annotations

import html
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, NoReturn, Optional, Union

from . import _native
from ._checks import finite
from ._mechanism import Mechanism as Run
from ._saved import Snapshot

IN_MEMORY = "a simulation of a text is saved in memory alone, not as bytes"


class Sim(Run):
    """A running simulation: `Mechanism.start`. Parameters, inputs and states are attributes, `sim["bob.angle"]` is an output."""

    __module__ = "plm"

    _run: Any
    #: The mechanism that it runs.
    mechanism: ClassVar[Any]

    if TYPE_CHECKING:
        # Parameters, inputs and states of a text are known when it runs.
        def __getattr__(self, name: str) -> float: ...

        def __setattr__(self, name: str, value: Any) -> None: ...

    def show(self, until: float, every: Optional[float] = None) -> Show:
        """Runs until the time `until`, s, and gives the page of this: it moves, and has curves of all that is observed.

        A run that ends early has its page too, which tells why.
        """
        begin, until = self.time, finite("until", until)
        every = (until - begin) / 1000 or 1.0 if every is None else finite("every", every)
        page, _ = _native.page(self._run, until, every)
        return Show(page)

    def save(self) -> Snapshot:
        """Everything that decides how the run goes on, in memory."""
        return Kept(type(self), self._run.copy())

    def restore(self, saved: Union[Snapshot, bytes]) -> None:
        """Goes on from a saved moment, with the same bits."""
        if not isinstance(saved, Kept):
            raise TypeError(IN_MEMORY)
        super().restore(saved)

    @classmethod
    def from_bytes(cls, saved: bytes) -> NoReturn:
        """Not of mechanisms from text: their simulations are saved in memory alone."""
        raise TypeError(IN_MEMORY)

    def __reduce__(self) -> NoReturn:
        raise TypeError("a simulation of a text cannot be pickled: pickle its mechanism, and start it there")


class Kept(Snapshot):
    """A simulation as it was at one moment: `Sim.save`."""

    __slots__ = ()

    def __bytes__(self) -> NoReturn:
        raise TypeError(IN_MEMORY)


class Show:
    """The page of a run: a notebook shows it, and `write` makes a file of it that a browser opens."""

    __module__ = "plm"

    #: The page, as HTML; it needs no network.
    html: str

    def __init__(self, page: str) -> None:
        self.html = page

    def write(self, path: Union[str, Path]) -> None:
        """Writes the page as a file; one that is there stays as it was until the new one is whole."""
        path = Path(path)
        part = path.with_name(f".{path.name}.{os.getpid()}.part")
        try:
            part.write_text(self.html, encoding="utf-8")
            part.replace(path)
        finally:
            part.unlink(missing_ok=True)

    def _repr_html_(self) -> str:
        style = "width: 100%; height: 480px; border: 0"
        return f'<iframe style="{style}" sandbox="allow-scripts allow-downloads" srcdoc="{html.escape(self.html)}"></iframe>'

    def __repr__(self) -> str:
        return f"<plm.Show: a page of {len(self.html)} bytes>"
