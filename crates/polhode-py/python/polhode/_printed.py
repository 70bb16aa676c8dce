"""Results of commands, as the command prints them."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

from . import _html
from ._error import in_python
from ._record import Record


@dataclass(frozen=True, eq=False, repr=False)
class Printed(Record):
    """Common part of results that the command prints as text, Markdown, JSON and a page."""

    #: JSON, text, Markdown and page, as the command prints them.
    _printed: tuple[str, str, str, str]

    def to_dict(self) -> dict[str, Any]:
        """Returns the object that the command prints with ``--json``. Its keys are stable."""
        return dict(json.loads(self._printed[0]))

    def report(self) -> str:
        """Returns the text that the command prints."""
        # Lines of a drawing may contain dashes between letters that are not flags.
        return "\n".join(line if "│" in line else in_python(line) for line in self._printed[1].split("\n"))

    def page(self) -> str:
        """Returns the report as an HTML page with figures."""
        return self._printed[3]

    def __str__(self) -> str:
        return self.report()

    def _repr_markdown_(self) -> str:
        return self._printed[2]

    def _repr_html_(self) -> str:
        return _html.frame(self.page())
