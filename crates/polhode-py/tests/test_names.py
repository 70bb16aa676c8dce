"""The public names: documented, typed, with an example; and the stub of what Rust computes."""

from __future__ import annotations

import ast
import inspect
import re
import subprocess
import sys
from pathlib import Path

import polhode
from conftest import ROOT
from polhode import _native

HERE = Path(polhode.__file__).parent


def test_every_public_name_is_documented() -> None:
    for module, name in [*((polhode, name) for name in polhode.__all__), *((polhode.results, name) for name in polhode.results.__all__)]:
        value = getattr(module, name)
        if name == "__version__":
            continue
        assert inspect.getdoc(value), name
        if inspect.isclass(value):
            members = {k: v for k, v in vars(value).items() if not k.startswith("_") and (callable(v) or isinstance(v, property))}
            for member, what in members.items():
                assert inspect.getdoc(what), f"{name}.{member}"


def test_every_public_name_is_in_the_reference() -> None:
    listed = re.findall(r"(?m)^\.\. auto\w+:: polhode\.([\w.]+)$", (ROOT / "book/site/python-api.rst").read_text())
    results = {f"results.{name}" for name in polhode.results.__all__}
    assert sorted(listed) == sorted({*polhode.__all__, *results, "batch", "sweep"} - {"__version__"})


def test_the_top_of_the_package_has_what_users_type() -> None:
    """Functions, classes that users make, modules, errors: no class of results."""
    made = {"Body", "Ensemble", "Flight", "FreeMotion", "Knob", "MassProperties", "PolhodeError", "PolhodeWarning", "Scenario"}
    classes = {name for name in polhode.__all__ if inspect.isclass(getattr(polhode, name))}
    assert classes == made and not classes & {*polhode.results.__all__}
    assert {name for name in vars(polhode.results) if not name.startswith("_")} - {"annotations"} == {*polhode.results.__all__}
    for module in (polhode, polhode.results):
        own = [getattr(module, name) for name in module.__all__ if inspect.isclass(getattr(module, name))]
        assert all(value.__module__ == module.__name__ for value in own)


def test_names_are_imported_on_first_use() -> None:
    """Without NumPy, the module in Rust or any other of the package; for type checkers the same names from the same modules."""
    program = "import sys, polhode; print(*sorted(name for name in sys.modules if name.partition('.')[0] in ('numpy', 'polhode')))"
    done = subprocess.run([sys.executable, "-c", program], check=True, capture_output=True, text=True)
    assert done.stdout.split() == ["polhode", "polhode._public"]
    present, _ = (node for node in ast.parse((HERE / "__init__.py").read_text()).body if isinstance(node, ast.If))
    imports = [node for node in present.body if isinstance(node, ast.ImportFrom) and node.module != "_native"]
    static = {name.name: node.module or name.name for node in imports for name in node.names}
    assert static == polhode._HOMES and sorted({*static, "__version__"}) == sorted(polhode.__all__)


def test_types_are_announced() -> None:
    assert (HERE / "py.typed").exists()
    for source in HERE.glob("*.py"):
        for node in ast.walk(ast.parse(source.read_text())):
            if isinstance(node, ast.FunctionDef):
                arguments = [*node.args.args, *node.args.kwonlyargs]
                typed = node.returns is not None and all(a.annotation or a.arg in ("self", "cls") for a in arguments)
                assert typed, f"{source.name}: {node.name}"


def test_the_stub_has_what_rust_has() -> None:
    stub = ast.parse((HERE / "_native.pyi").read_text())
    functions = {node.name for node in stub.body if isinstance(node, ast.FunctionDef)}
    classes = {
        node.name: {member.name for member in node.body if isinstance(member, ast.FunctionDef)} - {"__len__"}
        for node in stub.body
        if isinstance(node, ast.ClassDef) and node.name in vars(_native)
    }
    there = {name: value for name, value in vars(_native).items() if not name.startswith("__")}
    assert functions == {name for name, value in there.items() if inspect.isbuiltin(value)}
    assert classes == {
        name: {member for member in vars(value) if not member.startswith("__")}
        for name, value in there.items()
        if inspect.isclass(value)
    }
