"""The book as a site, for Sphinx: `cargo xtask book`.

Its source is the repository's root, and its pages are plain Markdown with links between files, which a code host shows as well. What the
site adds stands in the modules beside this file: the navigation, search, pages for files that are not pages,
and formulas as MathML.
"""

import sys
from pathlib import Path

from pygments.lexers.special import TextLexer

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "crates/polhode-py/python")]

project = "polhode"
root_doc = "book/README"
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "navigation", "notebooks", "repository", "mathematics", "search"]

# The book, and what it links to at the root.
PAGES = {"book", "ARCHITECTURE.md", "CHANGELOG.md", "CONTRIBUTING.md", "CONVENTIONS.md", "SECURITY.md"}
exclude_patterns = [entry.name for entry in ROOT.iterdir() if entry.name not in PAGES]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}

myst_enable_extensions = ["dollarmath"]
# Anchors of headings are those of code hosts.
myst_heading_anchors = 6
# Two classes are called Event: that of a scenario's table, and what happened in a motion.
suppress_warnings = ["myst.header", "ref.python"]

# The compiled module and other packages are not needed to read what the classes say of themselves.
autodoc_mock_imports = ["polhode._native", "numpy", "pyarrow", "distributed", "ray", "scipy", "matplotlib"]
autodoc_member_order = "bysource"
python_use_unqualified_type_names = True

html_theme = "furo"
html_title = "polhode"
html_static_path = ["site.css", "search.js"]
html_css_files = ["site.css"]
html_js_files = ["search.js"]
html_copy_source = False
html_show_sourcelink = False
html_show_copyright = False
html_show_sphinx = False
# Summaries would be fetched, which a browser does not do for a page from disk.
html_show_search_summary = False
pygments_style = "default"
pygments_dark_style = "github-dark"


def setup(app):
    # Languages of blocks that have no colours.
    for language in ("cad", "csv", "fragment", "xyz"):
        app.add_lexer(language, TextLexer)
