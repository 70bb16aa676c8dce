"""Data of the search box: every section with its heading, its place and its text.

The data are a script, because browsers do not fetch data for a page from disk. `search.js` loads it
when it is first needed.
"""

import json
import re

from docutils import nodes
from sphinx import addnodes

SPACE = re.compile(r"\s+")


def setup(app):
    app.connect("builder-inited", lambda app: setattr(app, "searched", {}))
    app.connect("doctree-resolved", collect)
    app.connect("build-finished", write)
    return {"parallel_read_safe": True, "parallel_write_safe": False}


def collect(app, document, docname):
    page = document.next_node(nodes.title)
    app.searched[docname] = list(sections(document, page.astext() if page else docname))


def sections(document, page):
    """Yields (anchor, page, heading, text) of each section, and of each Python class and function
    with its members."""
    for section in document.findall(nodes.section):
        first = section.parent is document
        title = section.next_node(nodes.title).astext()
        own = [child for child in section.children if not isinstance(child, nodes.section | nodes.title | addnodes.desc)]
        yield ("" if first else section["ids"][0], page, "" if first else title, text_of(own))
        for child in section.children:
            if isinstance(child, addnodes.desc):
                signature = child.next_node(addnodes.desc_signature)
                yield (signature["ids"][0], page, signature.get("fullname", ""), text_of(child.children))


def text_of(parts):
    """Returns the text of these nodes, without raw HTML around them."""
    return SPACE.sub(" ", " ".join(part.astext() for part in parts if not isinstance(part, nodes.raw))).strip()


def write(app, exception):
    if exception is None:
        rows = [
            [app.builder.get_target_uri(docname) + (f"#{anchor}" if anchor else ""), page, heading, text]
            for docname, found in sorted(app.searched.items())
            for anchor, page, heading, text in found
        ]
        data = json.dumps(rows, ensure_ascii=False, separators=(",", ":"))
        (app.outdir / "_static/sections.js").write_text(f"window.polhodeSections = {data};\n", encoding="utf-8")
