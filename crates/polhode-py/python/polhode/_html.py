"""HTML for notebooks."""

from __future__ import annotations

from html import escape
from typing import Iterable


def number(value: float) -> str:
    """Formats a number with six significant digits."""
    return f"{value:.6g}"


def rows(head: Iterable[str], body: Iterable[tuple[str, Iterable[str]]]) -> str:
    """Returns an HTML table with column headings and a heading for each row.

    All cells are escaped text.
    """
    heads = "".join(f"<th>{escape(cell)}</th>" for cell in head)
    lines = "".join(
        f"<tr><th>{escape(name)}</th>" + "".join(f"<td>{escape(cell)}</td>" for cell in cells) + "</tr>" for name, cells in body
    )
    return f"<table><thead><tr><th></th>{heads}</tr></thead><tbody>{lines}</tbody></table>"


def text(words: str) -> str:
    """Returns preformatted text."""
    return f"<pre>{escape(words)}</pre>"


def frame(page: str, height: int = 640) -> str:
    """Returns a page in a sandboxed frame, whose scripts cannot access anything outside."""
    return (
        f'<iframe sandbox="allow-scripts" srcdoc="{escape(page)}" '
        f'style="width: 100%; height: {height}px; border: 0" title="motion"></iframe>'
    )
