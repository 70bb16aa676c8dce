"""Navigation of the site. The side bar shows the lists of links in each README.md, under its
headings.

A page that is in none of the lists makes the build fail.
"""

import re

HEADING = re.compile(r"^## (.+)$")
ENTRY = re.compile(r"^- \[([^\]]+)\]\(([^)#:]+)\.(?:md|rst|ipynb)\)")


def setup(app):
    app.connect("source-read", add_toctrees)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def add_toctrees(app, docname, source):
    if docname.rpartition("/")[2] != "README":
        return
    root = docname == app.config.root_doc
    sections = [("", [])]
    for line in source[0].splitlines():
        if root and (heading := HEADING.match(line)):
            sections.append((heading[1], []))
        elif entry := ENTRY.match(line):
            sections[-1][1].append(f"{entry[1]} <{entry[2]}>")
    for caption, entries in sections:
        if entries:
            options = [":hidden:", f":caption: {caption}"] if caption else [":hidden:"]
            source[0] += "\n".join(["\n\n```{toctree}", *options, "", *entries, "```\n"])
