"""Public names: the modules of classes, and imports on first use."""

from __future__ import annotations

from importlib import import_module
from types import FunctionType
from typing import Callable, Mapping, TypeVar

Class = TypeVar("Class", bound=type)


def public(module: str = "polhode") -> Callable[[Class], Class]:
    """Sets the public module of a class and of its methods, for messages and pickling."""

    def placed(owner: Class) -> Class:
        owner.__module__ = module
        for name, member in vars(owner).items():
            method = member.__func__ if isinstance(member, classmethod) else member
            if isinstance(method, FunctionType) and not name.startswith("_"):
                method.__module__ = module
        return owner

    return placed


def on_first_use(package: str, homes: Mapping[str, str]) -> Callable[[str], object]:
    """Returns a function that imports a name of ``homes`` from its module, or the module of that name."""

    def imported(name: str) -> object:
        module = import_module(f".{homes[name]}", package)
        return module if homes[name] == name else getattr(module, name)

    return imported
