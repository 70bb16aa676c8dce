"""Former names, which still work for one version, with a ``DeprecationWarning``."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any, TypeVar

from ._error import warn

Target = TypeVar("Target")


def warn_of_name(former: str, present: str) -> None:
    """Issues a warning that points at the user's line."""
    warn(f"{former} is deprecated and will be removed in the next version: use {present}", DeprecationWarning)


class Former:
    """Former name of a method or attribute."""

    def __init__(self, former: str, present: str) -> None:
        self._former = former
        self._present = present

    def __get__(self, instance: object, owner: type) -> Any:
        warn_of_name(self._former, f"{owner.__name__}.{self._present}")
        return getattr(owner if instance is None else instance, self._present)


def former_keyword(former: str, present: str) -> Callable[[Target], Target]:
    """Returns a decorator of a function or a class that accepts a keyword argument by its former
    name."""

    def accepting(function: Callable[..., Any]) -> Callable[..., Any]:
        @functools.wraps(function)
        def called(*arguments: Any, **keywords: Any) -> Any:
            if former in keywords:
                if present in keywords:
                    raise TypeError(f"{present} is given twice: {former} is its former name")
                warn_of_name(f"the argument {former}", present)
                keywords[present] = keywords.pop(former)
            return function(*arguments, **keywords)

        return called

    def decorated(target: Any) -> Any:
        if not isinstance(target, type):
            return accepting(target)
        setattr(target, "__init__", accepting(vars(target)["__init__"]))
        return target

    return decorated
