"""Saved moments of runs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._mechanism import Mechanism


class Snapshot:
    """A mechanism as it was at one moment: `Mechanism.save`. `bytes(snapshot)` are for files; it can be pickled."""

    __slots__ = ("_of", "_saved")

    def __init__(self, of: type[Mechanism], saved: Any) -> None:
        # A run, or its bytes.
        self._of, self._saved = of, saved

    def __bytes__(self) -> bytes:
        return self._saved if isinstance(self._saved, bytes) else bytes(self._of._native.save(self._saved))

    def __reduce__(self) -> Any:
        return Snapshot, (self._of, bytes(self))


def restored(of: type[Mechanism], saved: bytes, own: dict[str, Any]) -> Any:
    """What was pickled; `own` are attributes of a user's class."""
    other = object.__new__(of)
    other._run = of._native.saved(saved)
    vars_of(other).update(own)
    return other


def vars_of(mechanism: Mechanism) -> dict[str, Any]:
    """The attributes that a user's class has, which may have none."""
    return getattr(mechanism, "__dict__", {})
