"""Answers of the command, as it prints them."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

from . import _html
from ._error import in_python
from ._record import Record


@dataclass(frozen=True, eq=False, repr=False)
class Printed(Record):
    """What is common to answers of which the command prints text, Markdown, JSON and a page."""

    #: JSON, text, Markdown and page, as the command prints them.
    _printed: tuple[str, str, str, str]

    def to_dict(self) -> dict[str, Any]:
        """The object that the command prints with ``--json``: its keys are stable."""
        return dict(json.loads(self._printed[0]))

    def report(self) -> str:
        """The text that the command prints."""
        # A drawing has dashes between letters that are no flags.
        return "\n".join(line if "│" in line else in_python(line) for line in self._printed[1].split("\n"))

    def page(self) -> str:
        """The report as a page with pictures, for a browser."""
        return self._printed[3]

    def __str__(self) -> str:
        return self.report()

    def _repr_markdown_(self) -> str:
        return self._printed[2]

    def _repr_html_(self) -> str:
        return _html.frame(self.page())
