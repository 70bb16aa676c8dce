"""Docstrings in NumPy's style: what users call says each argument, what comes back, what is refused, and shows it."""

from __future__ import annotations

import inspect
import re
from typing import Any, Iterator

import polhode
import pytest

#: Classes that users make; the others come back from functions, and say what they have by attribute.
MADE = {"Body", "Ensemble", "Flights", "FreeMotion", "MassProperties", "Scenario"}


def called() -> Iterator[tuple[str, Any]]:
    """Public functions, the classes that users make, and methods of all that take arguments."""
    for name, value in [*((name, getattr(polhode, name)) for name in polhode.__all__), *((name, getattr(polhode.results, name)) for name in polhode.results.__all__)]:
        if inspect.isfunction(value) or name in MADE:
            yield name, value
        if inspect.isclass(value):
            for member, what in vars(value).items():
                method = getattr(what, "__func__", what)
                if not member.startswith("_") and inspect.isfunction(method) and arguments(method):
                    yield f"{name}.{member}", method


def arguments(of: Any) -> list[str]:
    return [name for name in inspect.signature(of).parameters if name not in ("self", "cls")]


def sections(text: str) -> dict[str, str]:
    """The parts under underlined headings, by these."""
    parts = re.split(r"(?m)^([A-Z][a-z]+)\n-{4,}$", text)
    return dict(zip(parts[1::2], parts[2::2]))


def missing(name: str, text: str, given: list[str], is_class: bool) -> list[str]:
    """What a docstring lacks."""
    found = sections(text)
    listed = re.findall(r"(?m)^(\S.*)$", found.get("Parameters", ""))
    named = {word.strip("* ") for line in listed for word in line.split(",")}
    lacks = [f"argument {argument}" for argument in given if argument not in named]
    lacks += [f"no argument {argument}" for argument in named - set(given)]
    wanted = ["Returns"] * (not is_class) + ["Raises"] * bool(given) + ["Examples"] * ("." not in name)
    return lacks + [section for section in wanted if not found.get(section, "").strip()]


@pytest.mark.parametrize(("name", "of"), list(called()), ids=lambda value: value if isinstance(value, str) else "")
def test_all_is_said(name: str, of: Any) -> None:
    assert missing(name, inspect.getdoc(of) or "", arguments(of), inspect.isclass(of)) == []


def test_what_is_not_said_is_found() -> None:
    whole = inspect.getdoc(polhode.particles) or ""
    assert missing("particles", whole, ["masses", "positions"], False) == []
    assert missing("particles", whole, ["masses", "positions", "charges"], False) == ["argument charges"]
    assert missing("particles", whole, ["masses"], False) == ["no argument positions"]
    for section in ("Returns", "Raises", "Examples"):
        assert missing("particles", whole.replace(section, "Remarks"), ["masses", "positions"], False) == [section]
