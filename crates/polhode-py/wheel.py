#!/usr/bin/env python3
"""Says what a wheel of the package lacks that its users, or those who pass it on, rely on.

    python3 crates/polhode-py/wheel.py WHEEL… [--platform manylinux_2_28_x86_64]

The gate runs it on the wheel that it builds, and the workflow of releases on each that it makes. It needs nothing but Python 3.11.
"""

from __future__ import annotations

import argparse
import re
import sys
import zipfile
from email import message_from_bytes
from email.message import Message
from pathlib import Path

#: Fields of the metadata, and what each has to match (the core metadata specification, version 2.4).
FIELDS = {
    "Name": r"polhode",
    "Version": r"\d+\.\d+\.\d+\S*",
    "Summary": r".{20,}",
    "License-Expression": r"MIT OR Apache-2\.0",
    "Keywords": r".+,.+",
    "Requires-Python": r">=3\.10",
    "Description-Content-Type": r"text/markdown\b.*",
}

#: Project addresses that there have to be.
ADDRESSES = ("Homepage", "Repository", "Documentation", "Changelog", "Issues")

#: Files besides those of the package that its types and its command need.
FILES = ("polhode/py.typed", "polhode/_native.pyi", "polhode/__main__.py", "polhode_command/__init__.py")


def problems(path: Path, platform: str | None = None) -> list[str]:
    """What is wrong with a wheel; nothing if it is as it should be."""
    with zipfile.ZipFile(path) as wheel:
        names = set(wheel.namelist())
        (metadata,) = [name for name in names if name.endswith(".dist-info/METADATA")]
        about = metadata.removesuffix("METADATA")
        said = message_from_bytes(wheel.read(metadata))
        tags = message_from_bytes(wheel.read(f"{about}WHEEL")).get_all("Tag", [])
        commands = wheel.read(f"{about}entry_points.txt").decode() if f"{about}entry_points.txt" in names else ""
        licences = {name: wheel.read(f"{about}licenses/{name}") for name in said.get_all("License-File", []) if f"{about}licenses/{name}" in names}
    wrong = _of_metadata(said)
    wrong += [f"no text of the licence {name}" for name in ("LICENSE-MIT", "LICENSE-APACHE") if len(licences.get(name, b"")) < 1000]
    wrong += [f"no file {name}" for name in FILES if name not in names]
    if not any(re.fullmatch(r"polhode/_native(\.abi3\.so|\.pyd)", name) for name in names):
        wrong.append("no module polhode._native of the stable ABI")
    wrong += [f"{name} is not a file of a package" for name in names if "__pycache__" in name or name.startswith("tests/")]
    if "polhode=polhode_command:main" not in commands.replace(" ", ""):
        wrong.append("no command polhode")
    wrong += [f"tag {tag} is not of Python 3.10 and later by the stable ABI" for tag in tags if not tag.startswith("cp310-abi3-")]
    if not tags or platform and {tag.rpartition("-")[2] for tag in tags} != {platform}:
        wrong.append(f"tags {tags}, not of {platform or 'any platform'}")
    return wrong


def _of_metadata(said: Message) -> list[str]:
    wrong = [f"{name}: {said.get(name)!r}" for name, rule in FIELDS.items() if not re.fullmatch(rule, str(said.get(name) or ""))]
    if not said.get("Author") and not said.get("Author-email"):
        wrong.append("no author")
    addresses = dict(line.split(", ", 1) for line in said.get_all("Project-URL", []))
    wrong += [f"no address {name}" for name in ADDRESSES if not addresses.get(name, "").startswith("https://")]
    if not said.get_all("Classifier"):
        wrong.append("no classifiers")
    # Refused by package indexes beside a licence expression.
    wrong += [f"classifier {line}" for line in said.get_all("Classifier", []) if line.startswith("License ::")]
    if "import polhode" not in str(said.get_payload()):
        wrong.append("no description with an example")
    return wrong


def main() -> int:
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    arguments.add_argument("wheels", metavar="WHEEL", nargs="+", type=Path)
    arguments.add_argument("--platform", help="the only platform tag that is right")
    given = arguments.parse_args()
    wrong = [f"{path.name}: {problem}" for path in given.wheels for problem in problems(path, given.platform)]
    print("\n".join(wrong), file=sys.stderr, end="\n" if wrong else "")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
