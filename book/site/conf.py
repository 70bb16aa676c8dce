"""Sphinx configuration of the book's site: `cargo xtask book`.

The source is the repository's root. Its pages are plain Markdown with links between files, which
code hosts also display. The modules in this folder add the navigation, search, pages for other
files, formulas as MathML, and the front page.
"""

import re
import sys
from pathlib import Path

from pygments.lexers.special import TextLexer

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "crates/polhode-py/python")]

project = "polhode"
version = re.search(r'^version = "(.+?)"', (ROOT / "Cargo.toml").read_text(encoding="utf-8"), re.MULTILINE)[1]
root_doc = "book/README"
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx.ext.githubpages", "front", "navigation", "notebooks", "repository", "mathematics", "search"]

# The book, and the pages at the root to which it links.
PAGES = {"book", "ARCHITECTURE.md", "CHANGELOG.md", "CONTRIBUTING.md", "CONVENTIONS.md", "SECURITY.md"}
exclude_patterns = [entry.name for entry in ROOT.iterdir() if entry.name not in PAGES] + ["book/site/get.md"]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}

myst_enable_extensions = ["dollarmath"]
# Headings have the same anchors as on code hosts.
myst_heading_anchors = 6
suppress_warnings = ["myst.header"]

# Reading the docstrings does not need the compiled module or other packages.
autodoc_mock_imports = ["polhode._native", "numpy", "pyarrow", "distributed", "ray", "scipy", "matplotlib"]
autodoc_member_order = "bysource"
python_use_unqualified_type_names = True

html_theme = "furo"
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#0072b2", "color-brand-content": "#0072b2"},
    "dark_css_variables": {"color-brand-primary": "#56b4e9", "color-brand-content": "#56b4e9"},
}
html_title = "polhode"
html_favicon = "favicon.svg"
templates_path = ["."]
html_static_path = ["site.css", "front.css", "search.js"]
html_css_files = ["site.css"]
html_js_files = ["search.js"]
html_copy_source = False
html_show_sourcelink = False
html_show_copyright = False
html_show_sphinx = False
# Summaries would need fetch requests, which browsers do not allow for pages from disk.
html_show_search_summary = False
pygments_style = "default"
pygments_dark_style = "github-dark"


def setup(app):
    # Languages of code blocks without highlighting.
    for language in ("cad", "csv", "fragment", "xyz"):
        app.add_lexer(language, TextLexer)
