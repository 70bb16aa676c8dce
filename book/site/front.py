"""Front page of the site, `front.html`.

Its questions are those of the README, whose commands and results are tested. Its ways to get
polhode are the sections of `get.md`.
"""

import re
from html import escape
from pathlib import PurePosixPath
from posixpath import normpath
from urllib.parse import urlsplit

import repository
from markdown_it import MarkdownIt
from sphinx.errors import ExtensionError

README = "README.md"
SECTION = re.compile(r"^## Ask it\n(.+?)^## ", re.MULTILINE | re.DOTALL)
# Bold question, note, links in parentheses, command, and the printed text.
QUESTION = re.compile(
    r"^\*\*(?P<text>[^*\n]+\?)\*\*(?P<note>[^\n]*?) \((?P<links>\[[^\n]+\))\):\n+"
    r"```console\n\$ (?P<command>[^\n]+?)(?: # [^\n]+)?\n```\n```text\n(?P<result>.+?)\n```$",
    re.MULTILINE | re.DOTALL,
)
LINK = re.compile(r"\[([^\]]+)\]\(([^)]+)\)")
OMITTED = "…"
HYPHENATED = re.compile(r"\S*-\S*")

WAYS = "book/site/get.md"
WAY = re.compile(r"^## (.+)\n((?:(?!## ).*\n)+)", re.MULTILINE)

COUNTS = {README: ("questions", 8), WAYS: ("ways to get polhode", 3)}


def setup(app):
    # Runs before the pages of linked files are collected.
    app.connect("html-collect-pages", page, priority=100)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def page(app):
    yield "index", {"questions": counted(README, questions(app)), "ways": counted(WAYS, ways(app))}, "front.html"


def counted(path, found):
    name, count = COUNTS[path]
    if len(found) != count:
        raise ExtensionError(f"{path}: {len(found)} {name} for the front page, not {count}: see book/site/front.py")
    return found


def questions(app):
    section = SECTION.search(repository.text_of(app.srcdir / README))
    return [
        {
            "text": match["text"],
            "note": match["note"].strip(),
            "links": [(label, place(app, README, target)) for label, target in LINK.findall(match["links"])],
            "command": code(match["command"]),
            "result": code(trimmed(match["result"])),
        }
        for match in QUESTION.finditer(section[1] if section else "")
    ]


def trimmed(result):
    """Removes marks of omitted lines at the beginning and the end."""
    lines = result.split("\n")
    while lines and lines[0] == OMITTED:
        del lines[0]
    while lines and lines[-1] == OMITTED:
        del lines[-1]
    return "\n".join(lines)


def code(text):
    """Returns text of a terminal as HTML, with marks around the words that have a hyphen."""
    return HYPHENATED.sub(r"<span>\g<0></span>", escape(text, quote=False))


def ways(app):
    return [{"title": title, "body": html(app, text)} for title, text in WAY.findall(repository.text_of(app.srcdir / WAYS))]


def html(app, text):
    markdown = MarkdownIt()
    markdown.add_render_rule("fence", lambda renderer, tokens, at, *_: f"<pre>{code(tokens[at].content.rstrip())}</pre>\n")
    tokens = markdown.parse(text)
    for token in (child for token in tokens for child in token.children or []):
        if token.type == "link_open":
            token.attrSet("href", place(app, WAYS, token.attrGet("href")))
    return markdown.renderer.render(tokens, markdown.options, {})


def place(app, source, target):
    """Returns the address, from the site's root, of what a file of the repository links to."""
    parts = urlsplit(target)
    if parts.scheme:
        return target
    path = normpath((PurePosixPath(source).parent / parts.path).as_posix())
    docname = path.removesuffix(".md")
    found = app.builder.get_target_uri(docname) if docname in app.env.found_docs else repository.page_of(app, path)
    if not found:
        raise ExtensionError(f"{source}: {target} is not on the site")
    return found + (f"#{parts.fragment}" if parts.fragment else "")
