"""Exceptions and warnings."""

from __future__ import annotations


class PolhodeError(ValueError):
    """What is wrong with an input, in the words of the library.

    ``message`` says what, the value and the rule; ``hint`` what to do about it. An error in a file has its ``path``, and in a text file
    its ``line`` and ``column``, from 1.

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
        # All of them, so that a copy in another process has them too.
        super().__init__(message, hint, path, line, column)
        self.message = message
        self.hint = hint
        self.path = path
        self.line = line
        self.column = column

    def __str__(self) -> str:
        return self.message if self.hint is None else f"{self.message}\nhint: {self.hint}"


class PolhodeWarning(UserWarning):
    """Something that was decided on the way, and that the user should know: a density that was assumed, normals that were turned."""
