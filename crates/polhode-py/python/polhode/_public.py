"""Public module names of classes."""

from __future__ import annotations

from types import FunctionType


def place(module: str, *classes: type) -> None:
    """Sets the public module of classes and of their methods, for messages and pickling."""
    for public in classes:
        public.__module__ = module
        for name, member in vars(public).items():
            method = member.__func__ if isinstance(member, classmethod) else member
            if isinstance(method, FunctionType) and not name.startswith("_"):
                method.__module__ = module
