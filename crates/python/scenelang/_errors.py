"""What is raised where a scene cannot be used."""

import json
from typing import Any


class SceneError(ValueError):
    """A program, a layout or settings cannot be used.

    The message is what the command line prints. ``diagnostics`` has the findings as data, as in reports: code, severity,
    message, span, related, notes, fixes.
    """

    diagnostics: list[dict[str, Any]]

    def __init__(self, message: str, diagnostics: str = "[]") -> None:
        # The arguments stay as they are, so that the exception can be sent to another process.
        super().__init__(message, diagnostics)
        self.diagnostics = json.loads(diagnostics)

    def __str__(self) -> str:
        return str(self.args[0])


class ContradictionError(SceneError):
    """It is proved that there is no layout in which all of a program holds."""
