"""Notebooks as pages: their text, their code and what it gave, as Markdown."""

import json

from myst_parser.parsers.sphinx_ import MystParser


def markdown(notebook):
    """The Markdown of a notebook, with outputs as they are stored in it."""
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
    """Notebooks by way of Markdown."""

    supported = ("notebook",)

    def parse(self, inputstring, document):
        super().parse("\n\n".join(markdown(json.loads(inputstring))), document)


def setup(app):
    app.add_source_suffix(".ipynb", "notebook")
    app.add_source_parser(NotebookParser)
