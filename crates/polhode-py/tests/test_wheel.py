"""What `wheel.py` finds missing in a wheel. The gate runs it on the real one."""

from __future__ import annotations

import importlib.util
import zipfile
from pathlib import Path
from typing import Callable

import pytest

ABOUT = "polhode-0.1.0.dist-info"
METADATA = """Metadata-Version: 2.4
Name: polhode
Version: 0.1.0
Classifier: Topic :: Scientific/Engineering :: Physics
License-File: LICENSE-MIT
License-File: LICENSE-APACHE
Summary: Rigid-body dynamics: from mass to motion
Keywords: inertia tensor,mass properties
Author: The polhode developers
License-Expression: MIT OR Apache-2.0
Requires-Python: >=3.10
Description-Content-Type: text/markdown; charset=UTF-8; variant=GFM
Project-URL: Homepage, https://example.org
Project-URL: Repository, https://example.org
Project-URL: Documentation, https://example.org/book
Project-URL: Changelog, https://example.org/changes
Project-URL: Issues, https://example.org/issues

    import polhode
"""
FILES = {
    f"{ABOUT}/METADATA": METADATA,
    f"{ABOUT}/WHEEL": "Wheel-Version: 1.0\nTag: cp310-abi3-manylinux_2_28_x86_64\n",
    f"{ABOUT}/entry_points.txt": "[console_scripts]\npolhode=polhode_command:main\n",
    f"{ABOUT}/licenses/LICENSE-MIT": "may " * 300,
    f"{ABOUT}/licenses/LICENSE-APACHE": "may " * 300,
    "polhode/py.typed": "",
    "polhode/_native.pyi": "",
    "polhode/__main__.py": "",
    "polhode/_native.abi3.so": "",
    "polhode_command/__init__.py": "",
}


@pytest.fixture
def problems(tmp_path: Path) -> Callable[..., list[str]]:
    """What is wrong with a wheel of such files."""
    spec = importlib.util.spec_from_file_location("wheel", Path(__file__).parents[1] / "wheel.py")
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)

    def of(files: dict[str, str], platform: str | None = None) -> list[str]:
        with zipfile.ZipFile(tmp_path / "polhode.whl", "w") as wheel:
            for name, text in files.items():
                wheel.writestr(name, text)
        found: list[str] = module.problems(tmp_path / "polhode.whl", platform)
        return found

    return of


def test_nothing_is_wrong_with_one_that_has_everything(problems: Callable[..., list[str]]) -> None:
    assert problems(FILES) == []
    assert problems(FILES, "manylinux_2_28_x86_64") == []


@pytest.mark.parametrize("line", [line for line in METADATA.splitlines() if ":" in line and not line.startswith("Metadata-Version")])
def test_every_line_of_the_metadata_is_asked_for(problems: Callable[..., list[str]], line: str) -> None:
    assert len(problems({**FILES, f"{ABOUT}/METADATA": METADATA.replace(f"{line}\n", "")})) == 1


@pytest.mark.parametrize("name", [name for name in FILES if not name.endswith(("METADATA", "WHEEL"))])
def test_every_file_is_asked_for(problems: Callable[..., list[str]], name: str) -> None:
    assert len(problems({other: text for other, text in FILES.items() if other != name})) == 1


@pytest.mark.parametrize("tag", ["cp311-cp311-manylinux_2_28_x86_64", "cp310-abi3-linux_x86_64", "cp310-abi3-manylinux_2_35_x86_64"])
def test_other_tags_are_wrong(problems: Callable[..., list[str]], tag: str) -> None:
    assert problems({**FILES, f"{ABOUT}/WHEEL": f"Tag: {tag}\n"}, "manylinux_2_28_x86_64")


def test_the_licence_is_said_once(problems: Callable[..., list[str]]) -> None:
    both = METADATA.replace("Summary:", "Classifier: License :: OSI Approved :: MIT License\nSummary:")
    assert problems({**FILES, f"{ABOUT}/METADATA": both}) == ["classifier License :: OSI Approved :: MIT License"]
