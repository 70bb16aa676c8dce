"""Runs the notebooks beside it, each in a kernel and a folder of its own.

python book/notebooks/execute.py [NAME …]            says where one fails, or gives another text than it has
python book/notebooks/execute.py --write [NAME …]    writes what it gives into it
"""

from __future__ import annotations

import re
import sys
import tempfile
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

HERE = Path(__file__).resolve().parent


def texts(cell: nbformat.NotebookNode) -> list[str]:
    """What a cell has said, without figures; what it has printed in a row is one text, in however many pieces it came."""
    said: list[str] = []
    was_printed = False
    for output in cell.get("outputs", ()):
        if "image/png" in output.get("data", {}):
            continue
        is_printed = output["output_type"] == "stream"
        text = output["text"] if is_printed else output["data"]["text/plain"]
        if is_printed and was_printed:
            said[-1] += text
        else:
            said.append(text)
        was_printed = is_printed
    return said


def keep(output: nbformat.NotebookNode) -> None:
    """Takes out what is not stored: motions in three dimensions, which are large, and widgets, which are nothing without their kernel."""
    data = output.get("data", {})
    data.pop("application/vnd.jupyter.widget-view+json", None)
    if "polhode-motion" in data.get("text/html", "") or not data.get("text/html", " "):
        del data["text/html"]


def is_beside(output: nbformat.NotebookNode) -> bool:
    """Whether it is the motion of a widget, which stands beside it for those who have no kernel."""
    return "data-beside" in output.get("data", {}).get("text/html", "")


def execute(path: Path, write: bool) -> list[str]:
    """What is wrong with a notebook."""
    stored = nbformat.read(path, 4)
    notebook = nbformat.from_dict(stored.copy())
    notebook.cells = [nbformat.from_dict(dict(cell)) for cell in stored.cells]
    with tempfile.TemporaryDirectory() as folder:
        try:
            NotebookClient(notebook, timeout=300, kernel_name="python3", store_widget_state=False).execute(cwd=folder)
        except CellExecutionError as error:
            return [f"{path.name}: {re.sub(chr(27) + '[^m]*m', '', str(error))}"]
    for cell in notebook.cells:
        if "outputs" in cell:
            cell.outputs = [output for output in cell.outputs if not is_beside(output)]
    for output in (output for cell in notebook.cells for output in cell.get("outputs", ())):
        keep(output)
        if "text" in output:
            # A warning says in which file of the kernel's its line is.
            output["text"] = re.sub(r"(?m)^\S*ipykernel_\d+\S*:\d+: ", "", output["text"])
    if write:
        for cell in notebook.cells:
            cell.metadata = {}
        nbformat.write(notebook, path)
        return []
    wrong = []
    for before, after in zip(stored.cells, notebook.cells, strict=True):
        if texts(before) != texts(after):
            wrong.append(f"{path.name}: {before.source.splitlines()[-1]}\n  has   {texts(before)}\n  gives {texts(after)}")
    return wrong


def main(arguments: list[str]) -> int:
    write = "--write" in arguments
    names = [argument for argument in arguments if argument != "--write"]
    paths = [HERE / f"{name}.ipynb" for name in names] or sorted(HERE.glob("*.ipynb"))
    wrong = [line for path in paths for line in execute(path, write)]
    print("\n".join(wrong) or f"{len(paths)} notebooks")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
