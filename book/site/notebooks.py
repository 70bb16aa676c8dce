"""Notebooks as pages: their text, code and outputs, as Markdown."""

import json

from myst_parser.parsers.sphinx_ import MystParser


def markdown(notebook):
    """Yields the Markdown of a notebook, with its stored outputs."""
    for cell in notebook["cells"]:
        text = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            yield text
            continue
        yield f"```python\n{text}\n```"
        for output in cell["outputs"]:
            data = output.get("data", {})
            if "image/png" in data:
                yield f"![What the cell draws](data:image/png;base64,{''.join(data['image/png']).strip()})"
            else:
                said = "".join(output.get("text") or data.get("text/plain") or "").rstrip()
                yield f"```fragment\n{said}\n```"


class NotebookParser(MystParser):
    """Parser of notebooks, by conversion to Markdown."""

    supported = ("notebook",)

    def parse(self, inputstring, document):
        super().parse("\n\n".join(markdown(json.loads(inputstring))), document)


def setup(app):
    app.add_source_suffix(".ipynb", "notebook")
    app.add_source_parser(NotebookParser)
