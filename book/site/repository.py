"""Links to files of the repository that are not pages of the book. Each such file has a page with
its text.

The contents page of a crate, `src/lib.rs`, is shown as the crate's documentation, which
`cargo xtask book` puts next to the pages. The interactive page is shown as itself.
"""

import re
from html import escape
from pathlib import Path
from posixpath import normpath, relpath
from urllib.parse import urlsplit

from docutils import nodes
from sphinx import addnodes
from sphinx.util import logging

GALLERY = "book/gallery"
# The interactive page, which the site has at its root.
INTERACTIVE = "crates/polhode-live/assets/polhode.html"
LIBRARY = re.compile(r"crates/([a-z-]+)/src/lib\.rs")
LANGUAGES = {".toml": "toml", ".py": "python", ".rs": "rust", ".urdf": "xml", ".sdf": "xml", ".xml": "xml"}

logger = logging.getLogger(__name__)


def setup(app):
    app.config.html_extra_path = [str(app.srcdir / INTERACTIVE)]
    app.connect("builder-inited", lambda app: setattr(app.env, "shown_files", set()))
    # Runs before Sphinx copies linked files as downloads.
    app.connect("doctree-read", link_files, priority=100)
    app.connect("html-collect-pages", pages)
    app.connect("doctree-read", check_external)
    return {"parallel_read_safe": False, "parallel_write_safe": True}


def link_files(app, document):
    docname = app.env.docname
    for node in list(document.findall(lambda node: isinstance(node, addnodes.download_reference | addnodes.pending_xref))):
        path = path_of(app, node, docname)
        if path and (target := page_of(app, path)):
            link = nodes.reference("", "", *node.children, refuri=relative(docname, target), internal=True)
            if docname == GALLERY and path.endswith(".toml"):
                fold(app, node, path)
            node.replace_self(link)


def fold(app, node, path):
    """Inserts the scenario's text, folded, after the paragraph that names it."""
    paragraph = node.parent
    at = paragraph.parent.index(paragraph) + 1
    text = nodes.literal_block("", text_of(app.srcdir / path), language="toml")
    begin, end = (nodes.raw("", html, format="html") for html in ("<details><summary>The scenario</summary>", "</details>"))
    paragraph.parent[at:at] = [begin, text, end]


def path_of(app, node, docname):
    """Returns the file or folder of the repository to which a link leads; None if that is a
    page."""
    target = node.get("reftarget", "")
    if isinstance(node, addnodes.pending_xref) and node.get("refdomain") == "doc":
        return None if target in app.env.found_docs else f"{target}.md"
    path = normpath((Path(docname).parent / target).as_posix())
    is_link = isinstance(node, addnodes.download_reference) or (node.get("reftype") == "myst" and (app.srcdir / path).is_dir())
    return path if is_link else None


def page_of(app, path):
    """Returns the place of the page for a file or folder on the site; None for a file that is not
    text."""
    if library := LIBRARY.fullmatch(path):
        return f"rust/{library[1].replace('-', '_')}/index.html"
    if path == INTERACTIVE:
        return Path(path).name
    whole = app.srcdir / path
    if not whole.exists() or whole.is_file() and text_of(whole) is None:
        return None
    app.env.shown_files.add(path)
    return f"files/{path}.html"


def relative(docname, target):
    return relpath(target, Path(docname).parent.as_posix())


def text_of(file):
    try:
        return file.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        return None


def pages(app):
    waiting = sorted(app.env.shown_files)
    for path in waiting:
        whole = app.srcdir / path
        if whole.is_dir():
            inside = sorted(entry.name for entry in whole.iterdir() if entry.is_dir() or text_of(entry) is not None)
            shown = {f"{path}/{name}" for name in inside}
            waiting += sorted(shown - set(waiting))
            items = (f'<li><a href="{Path(path).name}/{escape(name)}.html">{escape(name)}</a></li>' for name in inside)
            body = f"<ul>{''.join(items)}</ul>"
        else:
            language = LANGUAGES.get(whole.suffix, "text")
            body = app.builder.highlighter.highlight_block(text_of(whole), language, force=True)
        yield f"files/{path}", {"title": path, "body": f"<h1>{escape(path)}</h1>{body}"}, "page.html"


def check_external(app, document):
    """Checks that links to other sites are well formed. It does not request them."""
    for node in document.findall(nodes.reference):
        parts = urlsplit(node.get("refuri", ""))
        if parts.scheme and not (parts.scheme == "https" and "." in (parts.hostname or "")):
            logger.warning("not the address of a page: %s", node["refuri"], location=node)
