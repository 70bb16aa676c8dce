"""Build backend: maturin, after a check that the Rust compiler is there.

Without a compiler, maturin would fetch one of several hundred MB. This backend fetches nothing before
the check, not even maturin.
"""

from __future__ import annotations

import re
import shutil
import subprocess
from typing import Any

#: Also: `rust-version` in Cargo.toml.
RUST = (1, 95)
MATURIN = "maturin>=1.9.4,<2"

Settings = "dict[str, Any] | None"


def _require_rust() -> None:
    needed = ".".join(map(str, RUST))
    install = "Install it from https://rustup.rs, and run pip again."
    if not shutil.which("cargo") or not shutil.which("rustc"):
        raise SystemExit(f"polhode is built from source here, which needs the Rust compiler {needed} or later: rustc or cargo is not on PATH. {install}")
    said = subprocess.run(["rustc", "--version"], capture_output=True, text=True, check=False).stdout
    found = re.match(r"rustc (\d+)\.(\d+)", said)
    if found and tuple(map(int, found.groups())) < RUST:
        raise SystemExit(f"polhode is built from source here, which needs the Rust compiler {needed} or later: this is {said.strip()}. {install}")


def get_requires_for_build_wheel(config_settings: Settings = None) -> list[str]:
    _require_rust()
    return [MATURIN]


get_requires_for_build_editable = get_requires_for_build_wheel


def get_requires_for_build_sdist(config_settings: Settings = None) -> list[str]:
    return get_requires_for_build_wheel(config_settings)


def build_wheel(wheel_directory: str, config_settings: Settings = None, metadata_directory: str | None = None) -> str:
    import maturin

    return str(maturin.build_wheel(wheel_directory, config_settings, metadata_directory))


def build_editable(wheel_directory: str, config_settings: Settings = None, metadata_directory: str | None = None) -> str:
    import maturin

    return str(maturin.build_editable(wheel_directory, config_settings, metadata_directory))


def build_sdist(sdist_directory: str, config_settings: Settings = None) -> str:
    import maturin

    return str(maturin.build_sdist(sdist_directory, config_settings))
