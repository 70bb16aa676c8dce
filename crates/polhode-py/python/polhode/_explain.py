"""Worked solutions."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from typing import Any

from . import _arrays, _native
from ._error import in_python
from ._public import public
from ._record import Record
from ._scenario import Scenario, formula_source


@public("polhode.results")
@dataclass(frozen=True, eq=False, repr=False)
class Explanation(Record):
    """A worked solution, with every formula and number.

    It covers the body, its axes, the inertia tensor, Euler's equations, ω and the attitude.
    """

    #: Title of the solution.
    title: str
    #: Plain text in lines of 100 characters.
    text: str
    #: Markdown with typeset formulas, for notebooks, GitHub and pandoc.
    markdown: str
    #: Self-contained HTML page with typeset formulas and graphs.
    html: str
    #: LaTeX article.
    latex: str
    #: JSON, as the command prints it.
    _json: str

    def to_dict(self) -> dict[str, Any]:
        """Returns the object that ``polhode explain --json`` prints.

        It contains sections, formulas and tables as data.
        """
        return dict(json.loads(self._json))

    def __repr__(self) -> str:
        return f"Explanation({self.title!r}: {len(self.to_dict()['sections'])} sections)"

    def __str__(self) -> str:
        return self.text

    def _repr_html_(self) -> None:
        """Returns ``None``, so that notebooks use the Markdown, which has the formulas."""

    def _repr_markdown_(self) -> str:
        return self.markdown


def explain(scenario: str | os.PathLike[str] | Scenario, *, formalism: str = "newton") -> Explanation:
    """Makes the worked solution of a scenario, step by step, as ``polhode explain`` does.

    Parameters
    ----------
    scenario
        A path, or a text of more than one line, as for :func:`simulate`, or a :class:`Scenario`.
    formalism
        ``"newton"`` for Euler's equations and the motion; ``"lagrange"`` for T, U, momenta, Lagrange's
        equations, conserved quantities and small oscillations; ``"hamilton"`` for Hamilton's
        equations.

    Returns
    -------
    Explanation
        The solution. A notebook shows it with its formulas.

    Raises
    ------
    PolhodeError
        If the scenario cannot be read or computed, has torques that are Python functions, which
        have no known formula, or has no known Lagrangian.

    Examples
    --------
    >>> import polhode
    >>> solution = polhode.explain('''
    ... title = "A spinning box"
    ...
    ... [[body.part]]
    ... shape = "box"
    ... size = ["20 cm", "13 cm", "3 cm"]
    ... mass = "0.6 kg"
    ...
    ... [start]
    ... spin = { body = ["0.01 rad/s", "5 rad/s", "0.02 rad/s"] }
    ... ''')
    >>> solution.title, solution.latex.startswith(r"\\documentclass")
    ('A spinning box', True)
    """
    formalism = _arrays.choice("formalism", formalism, ["newton", "lagrange", "hamilton"])
    found = _native.explain_scenario(*formula_source(scenario), formalism)
    return Explanation(
        title=str(json.loads(found["json"])["title"]),
        text=in_python(found["text"]),
        markdown=found["markdown"],
        html=found["html"],
        latex=found["latex"],
        _json=found["json"],
    )
