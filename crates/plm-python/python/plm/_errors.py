"""What is wrong with a declaration."""

from __future__ import annotations

import json
from typing import Any, Dict, List


class DeclarationError(ValueError):
    """A declaration has mistakes; its text shows each with its place, a caret, and what helps."""

    __module__ = "plm"

    #: The mistakes, and warnings, as `plm check --json` tells them.
    diagnostics: List[Dict[str, Any]]

    def __init__(self, text: str, diagnostics: str) -> None:
        super().__init__(text, diagnostics)
        self.diagnostics = json.loads(diagnostics)

    def __str__(self) -> str:
        return str(self.args[0])
