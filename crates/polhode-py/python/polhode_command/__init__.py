"""The command ``polhode``: the program of the same name, run in this process.

Beside the package ``polhode`` and not in it, so that the command starts without NumPy, which takes ten times as long as Python does.
"""

from __future__ import annotations

import importlib.machinery
import importlib.util
import os
import signal
import sys
from types import ModuleType

__all__ = ["main"]


def main() -> int:
    """Runs the command with the arguments of this process, and returns its exit status."""
    _open_standard_streams()
    # Ctrl-C is the command's business: Python would only note it down.
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    # What the command looks for as python3 is this one.
    if sys.executable:
        os.environ["PATH"] = os.pathsep.join([os.path.dirname(sys.executable), os.environ.get("PATH", os.defpath)])
    status: int = _native().run_command(["polhode", *sys.argv[1:]])
    return status


def _open_standard_streams() -> None:
    """What the caller has closed would be the next file that is opened, and what is printed would go there: a Rust program starts as this does."""
    if os.name == "posix":
        for stream in range(3):
            try:
                os.fstat(stream)
            except OSError:
                os.set_inheritable(os.open(os.devnull, os.O_RDWR), True)


def _native() -> ModuleType:
    """``polhode._native`` without what ``polhode`` itself imports."""
    name = "polhode._native"
    if name in sys.modules:
        return sys.modules[name]
    package = importlib.util.find_spec("polhode")
    spec = package and importlib.machinery.PathFinder.find_spec(name, package.submodule_search_locations)
    if spec is None or spec.loader is None:
        raise ImportError(f"{name} is not installed")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
