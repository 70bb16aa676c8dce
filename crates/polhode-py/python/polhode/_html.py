"""What notebooks show."""

from __future__ import annotations

from html import escape
from typing import Iterable


def number(value: float) -> str:
    """Six digits."""
    return f"{value:.6g}"


def rows(head: Iterable[str], body: Iterable[tuple[str, Iterable[str]]]) -> str:
    """A table: its column heads, and rows with a head each. All of it is text."""
    heads = "".join(f"<th>{escape(cell)}</th>" for cell in head)
    lines = "".join(
        f"<tr><th>{escape(name)}</th>" + "".join(f"<td>{escape(cell)}</td>" for cell in cells) + "</tr>" for name, cells in body
    )
    return f"<table><thead><tr><th></th>{heads}</tr></thead><tbody>{lines}</tbody></table>"


def text(words: str) -> str:
    """A text as it is printed."""
    return f"<pre>{escape(words)}</pre>"


def frame(page: str, height: int = 640) -> str:
    """A page in a frame of its own: its scripts reach nothing outside."""
    return (
        f'<iframe sandbox="allow-scripts" srcdoc="{escape(page)}" '
        f'style="width: 100%; height: {height}px; border: 0" title="motion"></iframe>'
    )
