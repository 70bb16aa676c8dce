"""Checks of the inertias of robot and simulation models."""

from __future__ import annotations

import copy
import json
import os
from typing import Any, Iterable, Iterator, Mapping, NamedTuple, Sequence

from . import _arrays, _html, _native
from ._error import in_python
from ._public import public


@public("polhode.results")
class ModelFinding(NamedTuple):
    """An error or doubtful value in a model."""

    #: Stable identifier for programs, such as ``"inertia.triangle"``.
    code: str
    #: ``impossible`` (unphysical), ``suspect`` (unlikely to be intended) or ``note``.
    severity: str
    #: Link or joint; empty if the finding concerns the whole model.
    link: str
    #: Further links or joints with the same finding.
    others: list[str]
    #: Line and column in the file, from 1.
    line: int
    column: int
    #: Description of the error, with the numbers.
    message: str
    #: Rule that is violated.
    rule: str
    #: Numbers by name, SI units.
    numbers: dict[str, float]
    #: Fix, if exactly one is consistent with all data of the link: a description and edits of the
    #: text.
    repair: dict[str, Any] | None
    #: Identifier that does not depend on the position in the file.
    id: str
    #: Path of the included file that contains the finding.
    file: str | None = None
    #: Possible tensors nearest to an impossible one, if requested: ``"frobenius"`` and
    #: ``"affine_invariant"``, each with the elements and ``"distance"``, or with ``"none"`` and a reason.
    nearest: dict[str, Any] | None = None


@public("polhode.results")
class CheckReport:
    """Findings about a model, in the order of the file.

    The report is a sequence of ``findings``.
    """

    def __init__(self, path: str, report: dict[str, Any], text: str, table: str) -> None:
        self.path = path
        self._report = report
        self._text = text
        self._table = table

    @property
    def findings(self) -> list[ModelFinding]:
        """Findings that count.

        Findings that comments in the model allow are in ``to_dict()["allowed"]``.
        """
        return [ModelFinding(**finding) for finding in self.to_dict()["findings"]]

    @property
    def ok(self) -> bool:
        """True if no finding is ``impossible`` or ``suspect``."""
        return all(finding.severity == "note" for finding in self.findings)

    def to_dict(self) -> dict[str, Any]:
        """Returns the object that ``polhode check --json`` prints. Its keys are stable."""
        return copy.deepcopy(self._report)

    def table(self) -> str:
        """Returns a text table with a line for each link.

        The columns are mass, centre, principal moments, equivalent box, density and verdict.
        """
        return self._table

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, CheckReport):
            return NotImplemented
        return (self.path, self._report) == (other.path, other._report)

    #: Not hashable, because ``path`` can be changed.
    __hash__ = None  # type: ignore[assignment]

    def __getitem__(self, which: Any) -> Any:
        """Returns the finding at an index, or several for a slice."""
        return self.findings[which]

    def __iter__(self) -> Iterator[ModelFinding]:
        return iter(self.findings)

    def __len__(self) -> int:
        return len(self._report["findings"])

    def __repr__(self) -> str:
        counts = ", ".join(f"{count} {kind}" for kind, count in self._report["counts"].items())
        return f"CheckReport({self.path!r}: {counts})"

    def __str__(self) -> str:
        return self._text

    def _repr_html_(self) -> str:
        lines = ((finding.severity, [finding.link, finding.code, finding.message]) for finding in self.findings)
        return f"<div>{_html.rows(['link', 'rule', 'what'], lines)}</div>"


def check(
    path: str | os.PathLike[str],
    *,
    roots: Sequence[str | os.PathLike[str]] = (),
    nearest: bool = False,
) -> CheckReport:
    """Checks the inertias of a URDF, SDF, MJCF, USD or OpenSim file.

    Parameters
    ----------
    path
        Path of the model file.
    roots
        Folders that contain the packages to which the model refers.
    nearest
        True to propose the possible tensors nearest to each impossible one, with their distances.
        Nothing is written.

    Returns
    -------
    CheckReport
        Findings, each with its link, its rule and its place in the file.

    Raises
    ------
    PolhodeError
        If the file is not a robot model.

    Examples
    --------
    >>> import pathlib, tempfile, polhode
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "arm.urdf"
    >>> _ = path.write_text('''<robot name="arm"><link name="hand"><inertial><mass value="2"/>
    ...     <inertia ixx="0.1" iyy="0.1" izz="0.9" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>''')
    >>> for finding in polhode.check(path):
    ...     print(finding.severity, finding.link, finding.code)
    impossible hand inertia.triangle
    """
    name = _arrays.path("path", path)
    if isinstance(roots, (str, os.PathLike, Mapping)) or not isinstance(roots, Iterable):
        raise TypeError(f"roots must be a list of folders, not {type(roots).__name__}")
    folders = [_arrays.path(f"roots[{k}]", root) for k, root in enumerate(roots)]
    report, text, table = _native.check_file(name, folders, _arrays.truth("nearest", nearest))
    return CheckReport(name, json.loads(report), in_python(text), table)
