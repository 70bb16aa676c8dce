"""Variables of a plan, and the text of a plan made from objects."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _arrays, _section
from ._arrays import Floats
from ._error import PolhodeError
from ._knob import key_of_argument
from ._scenario import Scenario
from ._section import Section
from ._units import Quantity
from ._toml import pair

#: Names of a distribution's numbers if they are given in order.
_IN_ORDER: dict[str, tuple[str, ...]] = {
    "uniform": ("from", "to"),
    "normal": ("mean", "sd"),
    "log_uniform": ("from", "to"),
    "triangular": ("from", "mode", "to"),
}

#: Largest error of a matrix element that counts as rounding, as a correlation.
ROUNDING = 1e-13

#: Numbers of a distribution, by name or in order.
Distribution = Mapping[str, Any] | Sequence[Quantity]


@dataclass(frozen=True, kw_only=True, repr=False)
class Vary(Section):
    """Variation of a quantity from member to member of a plan.

    It is a table ``[[sweep.vary]]`` of a
    `plan <https://github.com/polhode/polhode/blob/main/book/sweep.md#what-varies>`_, with a key and
    exactly one distribution.

    Parameters
    ----------
    key
        Quantity that varies, by its key in files or by the argument of :class:`polhode.Scenario`,
        such as ``"start.omega[2]"`` or ``'body["bus"].mass'``. Several keys have the same value or,
        with ``correlated``, are drawn together.
    uniform, log_uniform
        Bounds ``(from, to)``.
    normal
        Mean and standard deviation ``(mean, sd)``; or, truncated,
        ``{"mean": …, "sd": …, "from": …, "to": …}``.
    triangular
        Bounds and mode ``(from, mode, to)``.
    log_normal
        Parameters ``{"median": …, "sigma": …}`` or ``{"mean": …, "sd": …}``.
    relative
        Relative standard deviation of a normal distribution about the number in the scenario.
    list_
        Values (n,).
    grid
        Grid ``{"from": …, "to": …, "count": …}``.
    direction, magnitude
        For a vector: direction ``"uniform"`` or ``{"within": "5 deg"}``, and a distribution of its length,
        ``{"uniform": {…}}``.
    random
        For a rotation: ``"uniform"`` or ``{"sd": "2 deg"}``.
    dispersion
        For mass properties: ``0.1``, or ``{"mass": …, "center_of_mass": …, "inertia": …}``.
    correlated
        For several numbers or mass properties: their covariance (n, n), in SI units and in the
        order of the keys; or ``{"covariance": …}``, or ``{"sd": …, "correlation": …}``, optionally
        with ``"mean"`` or ``"impossible"``. Mass properties are mass, centre of mass x, y, z, and
        Ixx, Iyy, Izz, Ixy, Ixz, Iyz about it; for a tensor, the last six.

    Examples
    --------
    >>> import numpy as np
    >>> from polhode.batch import Vary
    >>> Vary(key=["start.omega[0]", "start.omega[1]"], correlated=np.array([[4e-4, 1e-4], [1e-4, 9e-4]]))
    Vary(key=('start.omega[0]', 'start.omega[1]'), correlated={'covariance': ((0.0004, 0.0001), (0.0001, 0.0009))})
    """

    table = "vary"
    key: str | Sequence[str]
    uniform: Distribution | None = None
    normal: Distribution | None = None
    relative: Quantity | None = None
    log_normal: Mapping[str, Any] | None = None
    log_uniform: Distribution | None = None
    triangular: Distribution | None = None
    list_: npt.ArrayLike | None = None
    grid: Mapping[str, Any] | None = None
    direction: str | Mapping[str, Any] | None = None
    magnitude: Mapping[str, Any] | None = None
    random: str | Mapping[str, Any] | None = None
    dispersion: Quantity | Mapping[str, Any] | None = None
    correlated: npt.ArrayLike | Mapping[str, Any] | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        keys = self.key if isinstance(self.key, tuple) else (self.key,)
        for k, key in enumerate(keys):
            _arrays.text(f"vary.key[{k}]" if isinstance(self.key, tuple) else "vary.key", key)
        for name, words in _IN_ORDER.items():
            given = getattr(self, name)
            if isinstance(given, tuple):
                if len(given) != len(words):
                    raise PolhodeError(f"vary.{name} must have {len(words)} numbers, {', '.join(words)}, not {len(given)}")
                object.__setattr__(self, name, dict(zip(words, given)))
        if self.correlated is not None and not isinstance(self.correlated, dict):
            _arrays.numbers("vary.correlated", self.correlated, ("n", "n"))
            object.__setattr__(self, "correlated", {"covariance": self.correlated})
        if isinstance(self.correlated, dict):
            for name in ("covariance", "correlation"):
                rows = self.correlated.get(name)
                if isinstance(rows, tuple) and any(not isinstance(row, tuple) or len(row) != len(rows) for row in rows):
                    raise PolhodeError(f"vary.correlated.{name} must be a square matrix (n, n)")
                if isinstance(rows, tuple) and all(isinstance(number, (int, float)) for row in rows for number in row):
                    self.correlated[name] = _unrounded(np.array(rows, float), is_correlation=name == "correlation")


def _unrounded(matrix: Floats, *, is_correlation: bool) -> tuple[tuple[float, ...], ...]:
    """Removes rounding errors from a matrix: makes it symmetric, and the diagonal of correlations
    1. The reader refuses larger errors."""
    if is_correlation and (np.abs(np.diag(matrix) - 1.0) <= ROUNDING).all():
        np.fill_diagonal(matrix, 1.0)
    variances = np.abs(np.diag(matrix))
    if (np.abs(matrix - matrix.T) <= ROUNDING * np.sqrt(np.outer(variances, variances))).all():
        matrix = 0.5 * (matrix + matrix.T)
    return tuple(map(tuple, matrix.tolist()))


def plan_lines(scenario: Scenario, vary: Sequence[Vary], sweep: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Returns the lines of a plan's file, each with the argument that it comes from."""
    # Functions, which cannot be written into a file, are refused here.
    text = scenario.to_toml()
    lines = [("scenario", line) for line in text.splitlines()]
    given = {key: _section.written(_section.plain(key, value)) for key, value in sweep.items() if value is not None}
    questions = given.pop("questions", {})
    lines += [("", ""), ("Plan", "[sweep]"), *((key, pair(key, key, value)) for key, value in given.items())]
    if questions:
        lines += [("", ""), ("questions", "[sweep.questions]"), *(("questions", pair("questions", key, value)) for key, value in questions.items())]
    for k, one in enumerate(_section.sections("vary", vary, Vary)):
        table = one.to_dict()
        keys = table["key"]
        table["key"] = [key_of_argument(key) for key in keys] if isinstance(keys, list) else key_of_argument(keys)
        lines += [("", ""), (f"vary[{k}]", "[[sweep.vary]]"), *((f"vary[{k}].{key}", pair(key, key, value)) for key, value in table.items())]
    return lines


def placed(error: PolhodeError, path: str, lines: Sequence[tuple[str, str]]) -> PolhodeError:
    """Returns an error in a plan's text as an error of the argument that the text came from."""
    if error.path != path or error.line is None:
        return error
    place = lines[error.line - 1][0] if 0 < error.line <= len(lines) else ""
    message = re.sub(rf"^{re.escape(path)}:\d+:\d+: ", "", error.args[0])
    return PolhodeError(f"{place or 'scenario'}: {message}", error.args[1])


def sweep_of(
    vary: object, members: object, sampling: str | None, seed: object, replicates: object, trajectories: object, questions: object
) -> dict[str, Any]:
    """Returns the settings of a sweep other than variables.

    It checks only what the messages of the reader of files would not explain.
    """
    if not isinstance(vary, (Vary, Sequence)) or isinstance(vary, str):
        raise TypeError(f"vary must be a list of Vary, not {type(vary).__name__}")
    if questions is not None and not isinstance(questions, Mapping):
        raise TypeError(f"questions must be a mapping from names to conditions, not {type(questions).__name__}")
    return {
        "members": None if members is None else _arrays.count("members", members),
        "sampling": _arrays.text("sampling", "monte carlo" if sampling is None else sampling),
        "seed": None if seed is None else _arrays.count("seed", seed, 0),
        "replicates": None if replicates is None else _arrays.count("replicates", replicates),
        "trajectories": _arrays.truth("trajectories", trajectories) or None,
        "questions": questions,
    }
