"""Exceptions and warnings."""

from __future__ import annotations

import os
import re
import sys
import warnings

from ._public import public

#: Options of the command that are switches, those with another name in Python, and those with the
#: same name.
_SWITCHES = {"hull", "union", "resume", "force"}
_RENAMED = {"root": "roots", "joint": "joints", "part": "parts", "omega": "omega_axes"}
_SAME = {"unit", "mass-unit", "products", "decimal", "shell", "density", "mass", "material", "isotopes", "molecule", "field", "tolerance"}
_SAME |= {"spacing", "origin", "per-value", "link", "subtree", "geometry", "only", "threads", "workers", "worker-timeout"}
_SAME |= {"quaternion", "sense", "axes", "time-origin", "step", "columns", "moments", "start-omega", "weld", "fill", "close-within", "walls", "top-layers", "bottom-layers", "infill", "draws"}
#: Options that are functions or attributes in Python.
_ELSEWHERE = {"--lump fixed": "fixed_groups()", "--lump all": "inertia()", "--table": "link_table()", "--body": "the attribute body"}
#: Commands with another name in Python.
_COMMANDS = {"torque": "required_torque"}

#: A flag, with a value after it as an example or a placeholder.
_VALUE = r"(?:negative|positive|point|comma|mm|cm|m|in|g|kg|lb|wxyz|xyzw|body-to-space|space-to-body|body|space|fixed|all)\b"
_NUMBER = r"[0-9][0-9.]*(?:e-?[0-9]+)?\b"
_FLAG = re.compile(rf"(?<![\w-])--([a-z]+(?:-[a-z]+)*)( {_VALUE}(?: or {_VALUE})*| [0-9][0-9.]*%| {_NUMBER}| [A-Z]+\b| (?=\"))?")

#: A command in a message.
_COMMAND = re.compile(r"`polhode (check|explain|inertia|judge|simulate|stability|torque)`")


def in_python(text: str) -> str:
    """Rewrites a message for users of the command, with flags, into one for Python, with keyword
    arguments.

    >>> in_python("paste the line with the unit, or give it by --unit, such as --unit mm")
    'paste the line with the unit, or give it by unit, such as unit="mm"'
    >>> in_python("use its convex hull by --hull")
    'use its convex hull by hull=True'
    >>> in_python("say it: --omega body or --omega space, and --sense body-to-space or space-to-body")
    'say it: omega_axes="body" or omega_axes="space", and sense="body_to_space" or "space_to_body"'
    >>> in_python("it closes if vertices are welded: --weld 5e-7 (3 vertices become 1)")
    'it closes if vertices are welded: weld=5e-7 (3 vertices become 1)'
    >>> in_python("use --close-within 3.3%, or close the hole")
    'use close_within="3.3%", or close the hole'
    >>> in_python("use --lump fixed, which needs no common frame")
    'use fixed_groups(), which needs no common frame'
    >>> in_python("`polhode torque` computes it")
    'polhode.required_torque computes it'
    """

    def keyword(found: re.Match[str]) -> str:
        flag, value = found[1], (found[2] or "").strip()
        if flag in _SWITCHES:
            return f"{flag}=True"
        if found[0] in _ELSEWHERE:
            return _ELSEWHERE[found[0]]
        if flag not in _SAME and flag not in _RENAMED:
            return f"the command's {found[0]}"
        name = _RENAMED.get(flag, flag).replace("-", "_")
        if found[2] == " ":  # a value in quotes follows
            return f"{name}="
        if value.endswith("%"):
            return f'{name}="{value}"'
        if value[:1].isdigit():
            return f"{name}={value}"
        quoted = " or ".join(f'"{one.replace("-", "_")}"' for one in value.split(" or "))
        return f"{name}={quoted}" if value.islower() else name

    if "`polhode " in text:
        text = _COMMAND.sub(lambda found: f"polhode.{_COMMANDS.get(found[1], found[1])}", text)
    return _FLAG.sub(keyword, text.replace(" with -o DIR", "")) if "--" in text or "-o DIR" in text else text


@public()
class PolhodeError(ValueError):
    """An error in an input.

    ``message`` states the error, the value and the rule; ``hint`` states how to fix it. An error in
    a file has its ``path``, and in a text file also its ``line`` and ``column``, from 1.

    >>> import polhode
    >>> polhode.MassProperties(mass=1.0, inertia=[1.0, 1.0, 3.0])
    Traceback (most recent call last):
    polhode.PolhodeError: the inertia tensor is impossible: i1 + i2 = 2 kg·m² is less than i3 = 3 kg·m² (principal moments 1, 1, 3)
    hint: check the sign convention of the products (here: minus the integral ∫xy dm), the point it is about, and the units
    """

    def __init__(
        self,
        message: str,
        hint: str | None = None,
        path: str | None = None,
        line: int | None = None,
        column: int | None = None,
    ) -> None:
        # All arguments, so that a copy in another process has them too.
        super().__init__(message, hint, path, line, column)
        self.message = in_python(message)
        self.hint = None if hint is None else in_python(hint)
        self.path = path
        self.line = line
        self.column = column

    def _as_command(self) -> str:
        """Returns the text for users of the command, with options as flags."""
        message, hint = self.args[:2]
        return f"{message}" if hint is None else f"{message}\nhint: {hint}"

    def __str__(self) -> str:
        return self.message if self.hint is None else f"{self.message}\nhint: {self.hint}"


@public()
class PolhodeWarning(UserWarning):
    """An assumption or a correction, such as an assumed density or reversed normals."""


#: Folder of the package's own modules.
_PACKAGE = os.path.dirname(__file__) + os.sep


def warn(message: str, category: type[Warning] = PolhodeWarning) -> None:
    """Issues a warning that points at the user's line, however many frames of the package are
    between."""
    level, frame = 2, sys._getframe(1)
    while frame.f_back is not None and frame.f_code.co_filename.startswith(_PACKAGE):
        level, frame = level + 1, frame.f_back
    warnings.warn(message, category, stacklevel=level)
